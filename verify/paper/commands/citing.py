"""Statements that cite the step: its givens are their rows, and its theorem is theirs.

The step holds for every state and for all numbers with its givens. So a point run need not make it:
the program brings the step's folder along, as `verify/data/step`, and a test says that it is what
the page `step` becomes.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from verify.language.statement import (
    NEEDED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Applies,
    Assumption,
    Cite,
    Obligation,
)
from verify.language.terms import Claim, Term, equal, sqrt, symbol
from verify.paper.parameters import (
    HYPOTHESES,
    PRINTED,
    PRINTED_SET,
    PRINTED_SIGN,
    REPAIRED,
    THEOREM,
    V_0,
    r,
)
from verify.prover.outcome import Decision, Judgement, Outcome, conjunction, names_in
from verify.prover.proof import LemmaStep, ObligationStep, Proof, Step, Value
from verify.prover.rules import Applying, Root, Sum
from verify.wire.packaged import packaged_files

#: The step's name where it is cited, and its context of numbers.
STEP = "step"
CONTEXT = "parameters"

#: The row that the step applies to the constants of the theorem.
COLLAPSE = "collapse"

#: The variables of the context that are the same in both sets of constants, and the others.
COMMON = "r c V_0 delta_theta alpha_0 phi_minus delta_2 C_eta h_4 h_5"
OWN = "V_1 delta_x delta_y x_0 Delta_theta eta_bar zeta_bar d_slope d_const d_bar T_star"

#: Each variable with the term that Theorem 1 has for it.
MEANING: Mapping[str, Term] = {
    **{name: symbol(name) for name in COMMON.split()},
    **{name: symbol(f"{REPAIRED}.{name}") for name in OWN.split()},
}

_gap = MEANING["alpha_0"] - MEANING["phi_minus"]
_decay = 1 - MEANING["C_eta"]
#: What the step needs of the constants and is neither a row nor a definition.
BETWEEN: Mapping[str, Claim] = {
    "V_1-positive": 0 < MEANING["V_1"],
    "decay-positive": 0 < _decay,
    "decay-speed-positive": 0 < V_0 * _decay,
    "gap-square-positive": 0 < (_gap - MEANING["delta_y"]) ** 2,
    "r-product": equal(r, MEANING["phi_minus"] * _gap),
}

#: The constants that givens define.
DEFINED = {
    "alpha": MEANING["alpha_0"].name,
    "same-delta": MEANING["delta_y"].name,
    "d_bar-least": MEANING["d_bar"].name,
}

_NAMES = """
    r-positive r-below-one angle-obtuse angle-real
    V_0-positive V_1-above-V_0 phi-positive gap-positive alpha-positive delta_2-positive
    C_eta-positive C_eta-below-one h_4-positive h_4-below-one h_5-positive delta_x-positive
    x_0-positive Delta_theta-positive eta_bar-positive zeta_bar-positive d_slope-positive
    d_const-positive
    V_1-positive decay-positive decay-speed-positive gap-square-positive
    alpha r-product same-delta d_bar-least
    x_0-entry-1 d_const-entry-1 d_const-entry-3 d_const-entry-4 set-eta_c set-eta_s phi-below-half
    init-Cnd3 init-Cnd4 eta-below-one tau-small d-below-one Cnd5-upper eta-contraction zeta-root
    zeta-denominator zeta-dropped-factor zeta-total obtuse CndT x-term-1-d x-term-1-zeta
    x-contraction y-ratio y-term-1 y-term-2-d y-term-2-zeta y-term-3 y-term-4 final-angle
    collapse-time"""
#: The givens of the context, in its order.
GIVENS = tuple(_NAMES.split())

#: Those of them that are hypotheses of the theorem.
ROWS_OF_HYPOTHESES = ("r-positive", "r-below-one", "angle-obtuse", "angle-real")


def row_names() -> dict[str, str]:
    """The row of the theorem that each given is, if it is one."""
    rows = [name for name in GIVENS if name not in BETWEEN and name not in DEFINED]
    groups = dict.fromkeys(ROWS_OF_HYPOTHESES, HYPOTHESES)
    return {name: f"{groups.get(name, REPAIRED)}.{name}" for name in rows}


def collapse(group: str) -> Obligation:
    """The row of a theorem that cites the step: its constants satisfy all that the step needs."""
    return Obligation(COLLAPSE, group, THEOREM, NEEDED,
                      "the constants satisfy what the step needs: from each datum of the set the "
                      "particles collapse", Applies(f"{STEP}:{CONTEXT}", MEANING))  # fmt: skip


# --- statements that cite it ---

#: The judge of the row that the step applies: those that have judged all rows that it needs.
BY_ROWS = "the rows that the step needs"


def applying(between: Mapping[str, str]) -> Applying:
    """The proof that the step applies, from rows, definitions, and the facts that are neither."""
    known = row_names() | DEFINED | dict(between)
    return Applying(tuple(known[name] for name in GIVENS))


def applies(verdicts: Mapping[str, str]) -> bool:
    """Whether all rows are proved that show at a point what the step needs.

    Raises:
        OwnError: if the files of the step are not those that the checker has accepted.
    """
    packaged_files(STEP)
    needed = (*row_names().values(), _row("fixed-points-exist"))
    return all(verdicts[name] == PROVED for name in needed)


def with_step(outcome: Outcome) -> Outcome:
    """A point run with the row that the step applies to its repaired constants.

    That row is proved where all rows are that the step needs, and else undecided. What the paper's
    argument says of every state is the step's now: the needed rows compare numbers and take
    nothing on trust. Without rows of the repaired set the outcome stays as it is.
    """
    if not outcome.of_group(REPAIRED):
        return outcome
    row, decision = collapse(REPAIRED), Decision(UNDECIDED)
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


@cache
def step_cited() -> Cite:
    """The step, by the files that come with the program, with what it takes on trust."""
    content, certificate = packaged_files(STEP)
    return Cite(STEP, STEP, content, (), tuple(_trusted(content)), certificate)


def _trusted(statement: bytes) -> Iterator[Assumption]:
    """What the step takes on trust: a line each; the file is not read as JSON for that."""
    lines = statement.decode().partition('"assumptions": [\n')[2].partition("\n]")[0]
    for line in lines.split("\n"):
        kind, label, name, sentence = line.split('"')[3::4]
        yield Assumption(name, label, sentence, kind)


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
