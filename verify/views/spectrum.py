"""What people and scripts see of the spectral claims."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from verify.prover import balls
from verify.prover.balls import Ball
from verify.prover.decimals import outward, rational_text, short
from verify.prover.eigenvalues import Complex, Spectrum
from verify.prover.forall import Finding
from verify.paper.spectrum.rows import LETTERS
from verify.language.statement import PROVED, REFUTED
from verify.jobs.spectrum import Outcome
from verify.language.statement import Obligation
from verify.views.typeset import Typesetter

#: A longer formula is left to the statement file; what the row says names it.
MAX_FORMULA = 400

#: Bits beyond the precision asked for, so that rounding the ends of a ball costs nothing.
EXTRA_BITS = 16

_TYPESETTER = Typesetter(LETTERS)


def verdict_text(outcome: Outcome) -> str:
    """The verdict, with the number of sentences on which a proof rests."""
    if outcome.verdict != PROVED:
        return outcome.verdict
    return f"{PROVED}, given {len(outcome.assumptions)} listed assumptions"


def document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document; every number is a string."""
    return {
        "command": "spectrum",
        "verdict": verdict_text(outcome),
        "assumptions": [
            {"label": a.label, "statement": a.sentence, "name": a.name} for a in outcome.assumptions
        ],
        "claims": [_claim(row, finding) for row, finding in outcome.rows],
    }


def _claim(row: Obligation, finding: Finding) -> dict[str, Any]:
    entry: dict[str, Any] = {
        "name": row.name,
        "label": row.label,
        "statement": sentence(row),
        "role": row.role,
        "verdict": finding.verdict,
        "method": finding.method,
        "uses": list(row.uses),
    }
    if finding.verdict == REFUTED:
        entry["witness"] = {name: rational_text(v) for name, v in finding.point.items()}
        if row.corrected_by:
            entry["corrected_by"] = row.corrected_by
    return entry


def sentence(row: Obligation) -> str:
    """What the row says, then the claim that is decided, where it is short."""
    formula = _TYPESETTER.claim(row.claim)
    return f"{row.says}: {formula}" if len(formula) <= MAX_FORMULA else row.says


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


def lines(outcome: Outcome) -> Iterator[str]:
    """The report for a reader at a terminal, line by line."""
    yield "Spectral claims, for every r in ]0,1["
    group = ""
    for row, finding in outcome.rows:
        if row.group != group:
            group = row.group
            yield ""
            yield group.capitalize() if group[0].islower() else group
        yield from _row(row, finding)
    yield ""
    yield f"Taken on trust, and not proved by this program ({len(outcome.assumptions)}):"
    for assumption in outcome.assumptions:
        yield f"  {assumption.name} ({assumption.label}): {assumption.sentence}"
    yield ""
    for role in ("needed", "printed"):
        counts: dict[str, int] = {}
        for row, finding in outcome.rows:
            if row.role == role:
                counts[finding.verdict] = counts.get(finding.verdict, 0) + 1
        yield f"{role}: " + ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
    yield f"Verdict: {verdict_text(outcome)}"


def _row(row: Obligation, finding: Finding) -> Iterator[str]:
    role = "" if row.role == "needed" else " (as printed)"
    yield f"  {finding.verdict:<9} {row.name:<24} {row.label}{role}"
    yield f"            {sentence(row)}"
    details = finding.method or "no method found"
    if finding.degree:
        details += f", degree {finding.degree}"
    if row.uses:
        details += f"; with {', '.join(row.uses)}"
    yield f"            by {details}"
    if finding.verdict == REFUTED:
        if finding.point:
            point = ", ".join(
                f"{LETTERS.get(name, name)} = {value}" for name, value in finding.point.items()
            )
            yield f"            false at {point}"
        if row.corrected_by:
            yield f"            corrected by {row.corrected_by}"


def point_lines(r: list[Fraction], spectrum: Spectrum) -> Iterator[str]:
    """The eigenvalues and eigenvectors for a reader."""
    texts = " to ".join(map(str, r))
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
