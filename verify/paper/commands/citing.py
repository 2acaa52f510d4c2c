"""Statements that cite the step: its givens are their rows, and its theorem is theirs.

The step holds for every state and for all numbers with its givens. So a point run need not make it:
the program brings the step's folder along, as `verify/data/step`, and a test says that it is what
`verify.paper.commands.step` makes.
"""

from __future__ import annotations

from collections.abc import Mapping

from verify.language.statement import NEEDED, PROVED, REFUTED, UNDECIDED, Cite
from verify.language.terms import Claim, sqrt
from verify.paper import step
from verify.paper.assumptions import STEP_ASSUMPTIONS
from verify.paper.parameters import HYPOTHESES, PRINTED, PRINTED_SET, PRINTED_SIGN, REPAIRED, r
from verify.paper.step import BETWEEN, MEANING, STEP
from verify.prover.outcome import Decision, Judgement, Outcome, conjunction, names_in
from verify.prover.proof import LemmaStep, ObligationStep, Proof, Step, Value
from verify.prover.rules import Applying, Root, Sum
from verify.wire.packaged import packaged_files

#: The judge of the row that the step applies: those that have judged all rows that it needs.
BY_ROWS = "the rows that the step needs"


def applying(between: Mapping[str, str]) -> Applying:
    """The proof that the step applies, from rows, definitions, and the facts that are neither."""
    known = step.row_names() | step.DEFINED | dict(between)
    return Applying(tuple(known[name] for name in step.GIVENS))


def applies(verdicts: Mapping[str, str]) -> bool:
    """Whether all rows are proved that show at a point what the step needs.

    Raises:
        OwnError: if the files of the step are not those that the checker has accepted.
    """
    packaged_files(STEP)
    needed = (*step.row_names().values(), _row("fixed-points-exist"))
    return all(verdicts[name] == PROVED for name in needed)


def with_step(outcome: Outcome) -> Outcome:
    """A point run with the row that the step applies to its repaired constants.

    That row is proved where all rows are that the step needs, and else undecided. What the paper's
    argument says of every state is the step's now: the needed rows compare numbers and take
    nothing on trust. Without rows of the repaired set the outcome stays as it is.
    """
    if not outcome.of_group(REPAIRED):
        return outcome
    row, decision = step.collapse(REPAIRED), Decision(UNDECIDED)
    steps: tuple[Step, ...] = ()
    if applies({name: found.verdict for name, found in outcome.decisions.items()}):
        lemmas, between = _between()
        proof = applying(between)
        decision = Decision(PROVED, proof)
        steps = (*lemmas, ObligationStep(row.name, proof))
    old = outcome.statement
    rows = [r._replace(uses=()) if r.role == NEEDED and r.uses else r for r in old.obligations]
    used = {name for r in rows for name in r.uses}
    statement = old._replace(
        obligations=(*rows, row),
        assumptions=tuple(a for a in old.assumptions if a.name in used),
        cites=(step_cited(),),
    )
    if decision.claimed == PROVED:
        judged = Judgement(PROVED, BY_ROWS, row.claim, row.context, names_in(statement))
        decision = decision._replace(judged=judged)
    decisions = {**outcome.decisions, row.name: decision}
    return outcome._replace(
        statement=statement, decisions=decisions, steps=(*outcome.steps, *steps)
    )


def step_cited() -> Cite:
    """The step, by the files that come with the program."""
    content, certificate = packaged_files(STEP)
    return Cite(STEP, STEP, content, (), STEP_ASSUMPTIONS, certificate)


def as_printed(outcome: Outcome) -> dict[str, str]:
    """The verdicts on the theorem with its sign as printed, and on its set, where > holds.

    They are those of two certificates that come with the program.

    Raises:
        OwnError: if their files are not those that the checker has accepted.
    """
    needed = (found for row, found in outcome.of_group(HYPOTHESES) if row.role == NEEDED)
    if conjunction(needed) != PROVED or not outcome.of_group(PRINTED):
        return {}
    for name in (PRINTED_SIGN, PRINTED_SET):
        packaged_files(name)  # they are those that the checker has accepted
    return {"sign": REFUTED, "set": PROVED}


def verdicts_as_printed() -> dict[str, str]:
    """The verdicts on the theorem with its sign as printed, and on its set with the other sign.

    They are those of the certificates that come with the program; a page that was changed since
    then is decided anew.
    """
    from verify.paper.commands.pages import accepted  # loaded only where it is used

    by_sign = accepted("printed_sign", anew=False).verdict
    of_set = accepted("printed_set", anew=False).verdict
    return {"sign": REFUTED if by_sign == PROVED else UNDECIDED, "set": of_set}


def _row(name: str) -> str:
    return f"{REPAIRED}.{name}"


def _between() -> tuple[list[LemmaStep], dict[str, str]]:
    """What the step needs besides rows and definitions, at a point."""
    alpha_0 = MEANING["alpha_0"]
    discriminant = alpha_0**2 - 4 * r
    root, gap = sqrt(discriminant), ("add", _row("zeta-denominator"), _row("delta_2-positive"))
    proofs: list[tuple[str, Claim, Proof]] = [
        ("radicand", 0 < discriminant, Sum(("goal", _row("fixed-points-exist")))),
        ("root", 0 < root, Root()),
        ("divisor", 0 < alpha_0 + root, Sum(("goal", _row("alpha-positive"), f"{STEP}.root"))),
    ]
    sums: dict[str, tuple[Value, ...]] = {
        "V_1-positive": (_row("V_1-above-V_0"), _row("V_0-positive")),
        "decay-positive": (_row("C_eta-below-one"),),
        "decay-speed-positive": (("mul", _row("V_0-positive"), _row("C_eta-below-one")),),
        "gap-square-positive": (("pow", gap, 2),),
    }
    for name, claim in BETWEEN.items():
        found = (
            Sum(("goal", *sums[name])) if name in sums else Sum(using=(MEANING["phi_minus"].name,))
        )
        proofs.append((name, claim, found))
    lemmas = [LemmaStep(f"{STEP}.{name}", None, claim, proof) for name, claim, proof in proofs]
    return lemmas, {name: f"{STEP}.{name}" for name in BETWEEN}
