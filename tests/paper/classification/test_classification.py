"""The theorems: accepted as they are, and refused with a wrong sign, index or factor."""

from __future__ import annotations

import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from tests.pages import Variables, headings
from tests.paper.changed_statements import report
from verify import check
from verify.language.statement import NEEDED, PRINTED, PROVED, REFUTED, Always, Obligation
from verify.language.terms import Claim, Term, as_term, names_of, substitute, symbol
from verify.paper.commands import pages
from verify.paper.commands.pages import page
from verify.paper.commands.regenerate import is_right_statement
from verify.prover.proof import LemmaStep, ObligationStep, Proof
from verify.wire.read import read
from verify.wire.write import write

STATEMENT = page("classification").statement


# --- as they are ---------------------------------------------------------------------------------


def test_all_rows_are_proved(tmp_path: Path) -> None:
    outcome = pages.decide("classification")
    files = write(outcome)
    assert outcome.verdict == PROVED
    verdicts = {(row.role, decision.verdict) for row, decision in outcome.rows}
    assert verdicts == {(NEEDED, PROVED), (PRINTED, REFUTED)}
    assert sum(map(len, files.values())) < 150_000
    assert read(files["statement.json"], files["certificate.json"], {}) == outcome.draft
    for name, content in files.items():
        (tmp_path / name).write_bytes(content)
    command = [sys.executable, "-I", check.__file__, str(tmp_path)]
    said = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert (said.returncode, said.stderr) == (0, "")
    assert said.stdout.splitlines()[-1].startswith("PROVED: ")


def test_the_misprint_is_corrected_by_a_row_that_is_needed() -> None:
    rows = {row.name: (row, decision) for row, decision in pages.decide("classification").rows}
    row, decision = rows["cone-image-stated"]
    assert row.corrected_by is not None
    correction = rows[row.corrected_by]
    assert (correction[0].role, correction[1].verdict) == (NEEDED, PROVED)
    assert set(decision.witness) == {"r", "triple.a", "triple.b", "triple.c", "triple.t"}


@pytest.mark.parametrize("heading", headings("classification"))
def test_each_part_has_rows(heading: str) -> None:
    found = pages.decide("classification").of_group(heading)
    assert found
    assert {decision.verdict for row, decision in found if row.role == NEEDED} == {PROVED}


def test_it_is_the_program_s_own() -> None:
    assert is_right_statement(write(pages.decide("classification"))["statement.json"])


# --- what is refused -----------------------------------------------------------------------------


def other(claim: Claim, context: str | None) -> Claim | None:
    """The claim with one variable of its side put for another one."""
    names = [*names_of(changed_side(claim))]
    variables = [
        variable.name
        for found in STATEMENT.contexts
        if found.name == context
        for variable in found.variables
    ]
    chosen = [name for name in names if name in variables]
    instead = [name for name in variables if name not in names] or chosen[1:]
    if not chosen or not instead:
        return None
    swapped = substitute(changed_side(claim), {chosen[0]: Term("symbol", instead[0])})
    return with_side(claim, swapped)


def changed_side(claim: Claim) -> Term:
    """The right side, or the left one where the right one is a number."""
    return claim.lhs if claim.rhs.op == "rational" else claim.rhs


def with_side(claim: Claim, term: Term) -> Claim:
    if claim.rhs.op == "rational":
        return Claim(claim.relation, term, claim.rhs)
    return Claim(claim.relation, claim.lhs, term)


def double(claim: Claim) -> Claim | None:
    """With a factor 2 on one side, where the other one is not 0."""
    if as_term(0) in (claim.lhs, claim.rhs):
        return None
    return with_side(claim, changed_side(claim) * 2)


def opposite(claim: Claim) -> Claim:
    """With a minus sign on one side."""
    return with_side(claim, -changed_side(claim))


def stronger(claim: Claim) -> Claim:
    """By one thousandth."""
    return Claim(claim.relation, claim.lhs + as_term(1) / 1000, claim.rhs)


#: Mutants that are true, and that the same proof proves.
TRUE = {"law-of-cosines.index", "bound-below-one.sign"}


def mutants() -> dict[str, tuple[Claim, str | None, Proof]]:
    """For each row claims that are nearly the same, with the proof of the row."""
    found = {}
    for row, decision in pages.decide("classification").rows:
        if isinstance(row.claim, Claim) and row.role == NEEDED and decision.proof is not None:
            made = {
                "sign": opposite(row.claim),
                "factor": double(row.claim),
                "index": other(row.claim, row.context),
                "stronger": stronger(row.claim),
            }
            for kind, claim in made.items():
                name = f"{row.name}.{kind}"
                if claim is not None and name not in TRUE:
                    found[name] = claim, row.context, decision.proof
    return found


MUTANTS = mutants()


@cache
def refused() -> set[str]:
    """The mutants that the checker refuses, each put before the row it is made from."""
    steps: list[object] = []
    for step in pages.decide("classification").steps:
        if isinstance(step, ObligationStep):
            steps += [
                LemmaStep(name, *_placed(name))
                for name in MUTANTS
                if name.rpartition(".")[0] == step.name
            ]
        steps.append(step)
    found = report(pages.decide("classification")._replace(steps=tuple(steps)))  # type: ignore[arg-type]
    lines = [line for line in found.lines if line.startswith("REFUSED lemma ")]
    return {line.split()[2].rstrip(":") for line in lines}


def _placed(name: str) -> tuple[str | None, Claim, Proof]:
    claim, context, proof = MUTANTS[name]
    return context, claim, proof


@pytest.mark.parametrize("name", MUTANTS)
def test_a_wrong_claim_is_refused(name: str) -> None:
    assert name in refused()


def test_there_are_many_wrong_claims() -> None:
    assert len(MUTANTS) > 3 * len(pages.decide("classification").statement.obligations)


run, first = Variables("classification", "run"), Variables("classification", "first")

NEXT = {
    "the balls keep their roles": {"s": run.s, "c": run.c},
    "the ghost of the last speed is forgotten": {"u_0": run.u_0},
    "the comparison sequence runs ahead": {"low": symbol("high_next")},
    "with the wrong sign": {"high": -symbol("high_next")},
    "with the wrong factor": {"high": first.a * run.high - 2 * first.r * run.low},
    "the bend is not halved": {"b": (1 + first.r) * symbol("C_next")},
    "the distance stays": {"D": run.D, "eta": run.eta},
}


@pytest.mark.parametrize("what", NEXT)
def test_a_wrong_next_state_is_refused(what: str) -> None:
    outcome = pages.decide("classification")
    rows = outcome.statement.obligations
    index = next(i for i, row in enumerate(rows) if row.name == "run-always")
    claim = rows[index].claim
    assert isinstance(claim, Always)
    changed = {run.full(name): term for name, term in NEXT[what].items()}
    wrong: Obligation = rows[index]._replace(
        claim=Always(claim.context, claim.start, {**claim.next, **changed})
    )
    statement = outcome.statement._replace(obligations=(*rows[:index], wrong, *rows[index + 1 :]))
    found = report(outcome._replace(statement=statement))
    assert found.verdict == "REFUSED"
    assert any(line.startswith("REFUSED run-always") for line in found.lines)


GIVENS = [
    given.name
    for context in STATEMENT.contexts
    for given in context.givens
    if context.name in ("flight", "limit", "speeds", "inward")
]


@pytest.mark.parametrize("name", GIVENS)
def test_a_given_is_needed(name: str) -> None:
    outcome = pages.decide("classification")
    contexts = tuple(
        context._replace(givens=tuple(g for g in context.givens if g.name != name))
        for context in outcome.statement.contexts
    )
    lie = outcome._replace(statement=outcome.statement._replace(contexts=contexts))
    try:
        assert report(lie).verdict == "REFUSED"
    except check.Malformed:
        return
