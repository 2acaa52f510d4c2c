"""What people and scripts see of the spectral claims."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from verify.prover import balls
from verify.prover.balls import Ball
from verify.prover.decimals import exact_number, outward, rational_text, short
from verify.prover.outcome import Outcome
from verify.publication import Publication
from verify.views.document import claims_document
from verify.views.findings import Rectangle, Spectrum, complex_told
from verify.views.words import summary

FORMAT = "verify-spectrum/1"

#: Bits beyond the precision asked for, so that rounding the ends of a ball costs nothing.
EXTRA_BITS = 16


def spectrum_document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document; every number is a string."""
    return claims_document(outcome, "spectrum", FORMAT)


def point_document(r: list[Fraction], spectrum: Spectrum, bits: int) -> dict[str, Any]:
    """The part of the document that belongs to one r, or to all r between two."""
    with balls.precision(bits + EXTRA_BITS):  # at which the ends of balls are rounded
        return _point(r, spectrum, max(40, int(bits * 0.30103) + 3))


def _point(r: list[Fraction], spectrum: Spectrum, digits: int) -> dict[str, Any]:

    def pair(ball: Ball) -> list[str]:
        return outward(balls.ends(ball), digits)

    def complex_pair(value: Rectangle) -> dict[str, list[str]]:
        return {"re": pair(value.real), "im": pair(value.imaginary)}

    texts = [rational_text(end) for end in r]
    eigenvalues: dict[str, Any] = {
        "lambda_0": pair(spectrum.lambda_0),
        "lambda_plus": {
            **complex_pair(spectrum.plus),
            "abs": pair(spectrum.modulus),
            "arg": pair(spectrum.argument),
        },
    }
    if spectrum.exact is not None:
        eigenvalues["lambda_0"] = outward((spectrum.exact, spectrum.exact), digits)
        eigenvalues["lambda_0_exact"] = rational_text(spectrum.exact)
    return {
        "r": texts[0] if len(texts) == 1 else texts,
        "eigenvalues": eigenvalues,
        "eigenvectors": {
            "1": [["0", "0"], ["1", "1"], ["0", "0"], ["1", "1"]],
            "lambda_0": [pair(entry) for entry in spectrum.vector_0],
            "lambda_plus": [complex_pair(entry) for entry in spectrum.vector_plus],
        },
    }


def verdict_line(outcome: Outcome, paper: Publication) -> str:
    """The result with everything it is about."""
    return f"Verdict: {summary(outcome, paper)}"


def point_lines(r: list[Fraction], spectrum: Spectrum) -> Iterator[str]:
    """The eigenvalues and eigenvectors for a reader."""
    texts = " to ".join(map(exact_number, r))
    yield f"At r = {texts}" if len(r) == 1 else f"For all r from {texts}"
    value = _short(spectrum.lambda_0) if spectrum.exact is None else f"{spectrum.exact}"
    yield f"  λ₀  = {value}{'' if spectrum.exact is None else ' (exactly)'}, argument π"
    plus = spectrum.plus
    yield f"  λ±  = {_short(plus.real)} ± i {_short(plus.imaginary)}"
    yield f"  |λ±| = {_short(spectrum.modulus)}, argument ±{_short(spectrum.argument)}"
    yield "  eigenvector of 1:  (0, 1, 0, 1)"
    yield f"  eigenvector of λ₀: ({', '.join(map(_short, spectrum.vector_0))})"
    yield f"  eigenvector of λ₊: ({', '.join(map(_complex, spectrum.vector_plus))})"


def _short(ball: Ball) -> str:
    return short(balls.ends(ball))


def _complex(value: Rectangle) -> str:
    return complex_told(_short(value.real), _short(value.imaginary))
