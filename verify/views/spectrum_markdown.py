"""The readable report beside the certificate of the spectral claims, in Markdown."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from verify.prover.forall import Finding
from verify.prover.ground import REFUTED
from verify.jobs.spectrum import Outcome
from verify.language.statement import Obligation
from verify.views.markdown import section, table
from verify.views.spectrum import sentence, verdict_text


def report(outcome: Outcome) -> str:
    """The whole report, ending with a line feed."""
    return "\n".join(_lines(outcome)) + "\n"


def _lines(outcome: Outcome) -> Iterator[str]:
    yield "# Spectral claims, for every r in ]0,1["
    yield ""
    yield f"Verdict: **{verdict_text(outcome)}**."
    yield ""
    yield "Check it with nothing but Python: `python3 -I verify/check.py` and this folder."
    yield from section("What is printed and false")
    refuted = [(row, found) for row, found in outcome.rows if found.verdict == REFUTED]
    yield from table(
        ("Label", "Sentence", "False at", "Corrected by"),
        (
            (f"`{row.label}`", sentence(row), _witness(found), f"`{row.corrected_by}`")
            for row, found in refuted
        ),
    )
    yield from section("All rows")
    yield from table(("Verdict", "Role", "Label", "Sentence", "Method"), _rows(outcome.rows))
    yield from section("Taken on trust")
    yield from (f"- `{a.name}` (`{a.label}`): {a.sentence}" for a in outcome.assumptions)


def _rows(rows: Iterable[tuple[Obligation, Finding]]) -> Iterator[tuple[str, ...]]:
    for row, found in rows:
        yield found.verdict, row.role, f"`{row.label}`", sentence(row), found.method


def _witness(found: Finding) -> str:
    return ", ".join(f"{name} = {value}" for name, value in found.point.items())
