"""What people and scripts see of the spectral claims."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from verify.jobs.eigenvalues import Complex, Spectrum
from verify.language.statement import NEEDED, REFUTED, Obligation
from verify.language.terms import symbol
from verify.language.typeset import Typesetter
from verify.paper.numbering import cited
from verify.prover import balls
from verify.prover.balls import Ball
from verify.prover.decimals import exact_number, outward, rational_text, short
from verify.prover.outcome import Decision, Outcome
from verify.views.document import claims_document, value_text
from verify.views.words import groups, letters, sentence, summary, taken_on_trust, witness_of

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

    def complex_pair(value: Complex) -> dict[str, list[str]]:
        return {"re": pair(value.re), "im": pair(value.im)}

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


def claim_lines(outcome: Outcome) -> Iterator[str]:
    """The report for a reader at a terminal, line by line; `verdict_line` comes after it."""
    typesetter = letters(outcome)
    yield "Spectral claims, for every r in ]0,1["
    for group in groups(outcome):
        yield ""
        yield group.capitalize() if group[0].islower() else group
        for row, decision in outcome.of_group(group):
            yield from _row(row, decision, typesetter)
    yield ""
    yield from taken_on_trust(outcome)
    if outcome.spent:
        yield f"Work budget spent: {outcome.spent}"


def verdict_line(outcome: Outcome) -> str:
    """The result with everything it is about."""
    return f"Verdict: {summary(outcome)}"


def _row(row: Obligation, decision: Decision, typesetter: Typesetter) -> Iterator[str]:
    role = "" if row.role == NEEDED else " (as printed)"
    yield f"  {decision.verdict:<9} {row.name:<24} {cited(row.label)}{role}"
    yield f"            {sentence(row, typesetter)}"
    details = decision.method or "no rule that was found"
    if row.uses:
        details += f"; with {', '.join(row.uses)}"
    yield f"            by {details}"
    if decision.verdict == REFUTED:
        values = (
            f"{typesetter.term(symbol(name))} = {value_text(term, typesetter)}"
            for name, term in witness_of(row, decision).items()
        )
        if decision.witness:
            yield f"            false at {', '.join(values)}"
        if row.severity:
            yield f"            {row.severity}"
        if row.corrected_by:
            yield f"            corrected by {row.corrected_by}"


def point_lines(r: list[Fraction], spectrum: Spectrum) -> Iterator[str]:
    """The eigenvalues and eigenvectors for a reader."""
    texts = " to ".join(map(exact_number, r))
    yield ""
    yield f"At r = {texts}" if len(r) == 1 else f"For all r from {texts}"
    value = _short(spectrum.lambda_0) if spectrum.exact is None else f"{spectrum.exact}"
    yield f"  λ₀  = {value}{'' if spectrum.exact is None else ' (exactly)'}, argument π"
    plus = spectrum.plus
    yield f"  λ±  = {_short(plus.re)} ± i {_short(plus.im)}"
    yield f"  |λ±| = {_short(spectrum.modulus)}, argument ±{_short(spectrum.argument)}"
    yield "  eigenvector of 1:  (0, 1, 0, 1)"
    yield f"  eigenvector of λ₀: ({', '.join(map(_short, spectrum.vector_0))})"
    entries = [f"{_short(z.re)} + i {_short(z.im)}" for z in spectrum.vector_plus]
    yield f"  eigenvector of λ₊: ({', '.join(entries)})"


def _short(ball: Ball) -> str:
    return short(balls.ends(ball))
