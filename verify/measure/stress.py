"""Numerical stability on hard cases: the job `stress`.

The cases are data (`verify/data/stress.json`): each says what makes it hard and which answer is
right by exact reasoning. A run says the precision that the case needed, how many digits it lost,
and whether the answer is right: the verdict against the one in the data, each enclosure against
an independent computation in the checker's own arithmetic with `EXTRA_BITS` more bits (and the
textbook formula for the smaller fixed point), and the hypotheses against exact rationals.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from fractions import Fraction
from importlib.resources import files
from typing import cast

from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED
from verify.language.terms import Claim, as_term, sqrt, symbol
from verify.measure.bench import definitions_program
from verify.measure.engines import CheckerEngine, load
from verify.paper.commands import eigenvalues
from verify.paper.commands.theorem1 import decide_point
from verify.paper.parameters import HYPOTHESES
from verify.prover import balls
from verify.prover.budget import WorkBudget
from verify.prover.constants import MAX_BITS
from verify.prover.outcome import Ends, Outcome
from verify.prover.program import ExactArithmetic
from verify.prover.proof import OpenStep
from verify.spheres.parameters import angle
from verify.wire.inputs import rational
from verify.wire.questions import decide, read_page_of

#: The independent computation has this many bits more than the precision that was needed.
EXTRA_BITS = 512

#: The bits asked for at a point of the spectrum.
POINT_BITS = 128

#: In the short form, cases whose name ends like this are left out.
LONG = re.compile(r"(-300|-1e-(40|50|60|100|300))$")


class Case(Record):
    """One hard case, as the data has it."""

    name: str
    why: str
    command: str
    arguments: dict[str, str]
    expect: str


class Finding(Record):
    """What a run of a case showed.

    ``bits`` is the largest precision that the certificate asks for (exact values apart), ``lost``
    the decimal digits that the worst constant lost there, ``textbook`` those that the textbook
    formula loses (None where there is none), ``right`` whether every comparison agreed.
    """

    case: Case
    answer: str
    bits: int
    lost: float
    textbook: float | None
    right: bool


def cases(quick: bool) -> list[Case]:
    """The cases of the data; ``quick`` leaves out the most extreme repetitions."""
    text = files("verify").joinpath("data/stress.json").read_text(encoding="utf-8")
    everything = [Case(**entry) for entry in json.loads(text)["cases"]]
    return [case for case in everything if not (quick and LONG.search(case.name))]


def run_case(case: Case) -> Finding:
    """Decide a case, and compare."""
    return RUNNERS[case.command](case)


def number(text: str) -> Fraction:
    """A rational, or a sum or difference of two, as the data writes it."""
    first, *rest = text.split(" ")
    value = rational("argument", first)
    if rest:
        sign, second = rest
        value += rational("argument", second) * (1 if sign == "+" else -1)
    return value


def run_theorem1(case: Case) -> Finding:
    """Decide Theorem 1 for the repaired set and compare."""
    arguments = case.arguments
    if "theta0" in arguments:
        c = angle("theta0", arguments["theta0"])
    else:
        c = as_term(number(arguments.get("neg_cos", "1")))
    parameters = {
        "r": as_term(number(arguments["r"])),
        "c": c,
        "V_0": as_term(number(arguments.get("V0", "1"))),
        "delta_theta": as_term(number(arguments.get("delta_theta", "1/10"))),
    }
    outcome = decide_point(parameters, "repaired")
    bits = precision_needed(outcome)
    lost, textbook = _digits_lost(outcome, bits)
    right = (
        outcome.verdict == case.expect
        and hypotheses_are_exact(outcome)
        and constants_agree(outcome, bits + EXTRA_BITS)
    )
    return Finding(case, outcome.verdict, bits, lost, textbook, right)


def precision_needed(outcome: Outcome) -> int:
    """The largest precision with which a step evaluates, unless that stands for exact values."""
    proofs = (step.proof for step in outcome.steps if not isinstance(step, OpenStep))
    bits = (int(getattr(proof, "bits", 0)) for proof in proofs)
    return max((b for b in bits if b < MAX_BITS), default=MAX_BITS)


def _digits_lost(outcome: Outcome, bits: int) -> tuple[float, float | None]:
    """Decimal digits lost by the worst constant, and by phi_minus in the textbook form."""
    program = definitions_program(outcome)
    with balls.precision(bits):
        run = load(program, balls.BallArithmetic()).run(())
        losses = [_loss(run.values[slot], bits) for slot in program.slots.values()]
        worst = max((lost for lost in losses if lost is not None), default=0.0)
        if "alpha_0" not in program.slots:
            return worst, None
        alpha, r = symbol("alpha_0"), symbol("r")
        textbook = (alpha - sqrt(alpha * alpha - 4 * r)) / 2
        lost = _loss(run[textbook], bits)
    exact = load(program, ExactArithmetic()).run(())[textbook]
    return worst, lost if exact is None else None


def _loss(ball: balls.Ball | None, bits: int) -> float | None:
    if ball is None:
        return None
    return (bits - min(bits, max(0, balls.accuracy_bits(ball)))) * 0.30103


def hypotheses_are_exact(outcome: Outcome) -> bool:
    """The verdicts on the thresholds, against the signs of polynomials in exact rationals."""
    r, c = outcome.statement.parameters["r"], outcome.statement.parameters["c"]
    if c.op != "rational":
        return True
    x = (1 + r.value) / 2 * c.value
    signs = {
        "hypotheses.existence": x * x - 4 * r.value > 0,
        "hypotheses.stability": x**3 - 3 * r.value * x - r.value * (1 + r.value) > 0,
        "hypotheses.r-below-stabi": r.value**2 - 18 * r.value + 1 > 0,
    }
    verdicts = {row.name: found.verdict for row, found in outcome.of_group(HYPOTHESES)}
    return all(verdicts[name] == (PROVED if sign else REFUTED) for name, sign in signs.items())


def constants_agree(outcome: Outcome, bits: int) -> bool:
    """Every constant's enclosure meets the checker's, which has many more bits."""
    program, engine = definitions_program(outcome), CheckerEngine()
    with engine.at(bits):
        values = load(program, engine).run(()).values
    return all(
        meets(found.ends[0], engine.ends(values[program.slots[name]]))
        for name, found in outcome.enclosures.items()
        if values[program.slots[name]] is not None
    )


def meets(a: Ends, b: Ends) -> bool:
    """Whether two closed intervals have a number in common."""
    return a[0] <= b[1] and b[0] <= a[1]


def run_spectrum(case: Case) -> Finding:
    """Enclose the spectrum, and check the enclosures by exact rational arithmetic.

    Q is taken in its cyclic form, which is not the one that the enclosures come from:
    Q(x) = (x+r)^3 + h^3 x^2 + h^3 x - 3 h^2 x (x+r) with h = (1+r)/4. It increases, so it changes
    its sign between the ends of the real root's enclosure; the sum and the product of its roots
    must lie in what the enclosures give.
    """
    r = number(case.arguments["r"])
    found = eigenvalues.at(r, POINT_BITS)
    with balls.precision(2 * POINT_BITS):
        real, part, modulus = (
            balls.ends(b) for b in (found.lambda_0, found.plus.real, found.modulus)
        )
        parts = (found.lambda_0, *found.plus, found.modulus, found.argument)
        known = min(balls.accuracy_bits(ball) for ball in parts)
    h = (1 + r) / 4

    def q(x: Fraction) -> Fraction:
        return (x + r) ** 3 + h**3 * x**2 + h**3 * x - 3 * h**2 * x * (x + r)

    total, product = -(3 * r + h**3 - 3 * h**2), -(r**3)
    right = (
        q(real[0]) <= 0 <= q(real[1])
        and meets((real[0] + 2 * part[0], real[1] + 2 * part[1]), (total, total))
        and meets((real[0] * modulus[1] ** 2, real[1] * modulus[0] ** 2), (product, product))
        and case.expect == "enclosed"
    )
    lost = max(0, POINT_BITS - known) * 0.30103
    return Finding(case, case.expect, POINT_BITS, lost, None, right)


def run_claim(case: Case) -> Finding:
    """Decide a claim about numbers, and compare; the checker's arithmetic gives a second answer."""
    text = f'title = "{case.name}"\n[rows]\nclaim = "{case.arguments["claim"]}"\n'
    outcome = decide(read_page_of(case.name + ".toml", text.encode(), {}).statement, WorkBudget())
    ((row, decision),) = outcome.rows
    claim = cast(Claim, row.claim)
    bits = precision_needed(outcome)
    program = definitions_program(outcome)
    slots = [program.add(side) for side in (claim.lhs, claim.rhs)]
    with balls.precision(bits):
        lost = _loss(load(program, balls.BallArithmetic()).run(())[claim.rhs - claim.lhs], bits)
    engine = CheckerEngine()
    with engine.at(bits + EXTRA_BITS):
        values = load(program, engine).run(()).values
        lhs, rhs = (engine.ends(values[slot]) for slot in slots)
    same = lhs[1] < rhs[0] if decision.verdict == PROVED else rhs[1] < lhs[0]
    right = same and decision.verdict == case.expect
    return Finding(case, decision.verdict, bits, lost or 0.0, None, right)


RUNNERS: dict[str, Callable[[Case], Finding]] = {
    "theorem1": run_theorem1,
    "spectrum": run_spectrum,
    "claim": run_claim,
}
