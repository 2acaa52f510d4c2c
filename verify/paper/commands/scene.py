"""The job `scene`: a scene that was decided, as a statement with its certificate.

The prover followed the scene; here the same moves are told in terms, and each row gets its proof:
a constant of the scene shows that a number is what the theorem about all states says, enclosures
show the inequalities.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache

from verify.language.statement import PROVED, Applies, Cite, Context, Obligation, Statement
from verify.language.terms import Claim, Term
from verify.paper.commands.pages import cite, statement
from verify.prover import balls
from verify.prover.decimals import enclosing_decimals, round_decimal
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.proof import ConstantStep, ObligationStep, Premise, Proof, Step
from verify.prover.rules import Applying, Interval, Sum
from verify.spheres.flow.collapse import LINE, SANDWICH, SHARPER, THREE_BALLS
from verify.spheres.flow.contexts import FLOW, FLOW_OF_BALLS, TOUCHING
from verify.spheres.flow.follow import COLLIDE, DRIFT
from verify.spheres.scene.assumptions import ASSUMPTIONS
from verify.spheres.scene.decide import (
    COLLAPSES,
    DISPERSES,
    FINITE,
    MAX_COLLISIONS,
    MAX_DIGITS,
    UNDECIDED,
    Budget,
    Fate,
    decide_scene,
)
from verify.spheres.scene.scene import PAIRS, Bodies, Scene, pair_name
from verify.spheres.scene.scene_files import is_in_range
from verify.spheres.scene.statement import (
    CLASSIFICATION,
    CLASSIFICATION_OF_BALLS,
    MASS,
    RESTITUTION,
    SIZES,
    TIME,
    Numbers,
    Telling,
)
from verify.spheres.scene.verdict import is_settled_at_start, scene_lines, theorems

#: Digits of the times in a certificate.
DIGITS = 16
#: How the names of the rows begin that show the verdict.
DECISIVE = ("collapse", "end.", "finite.")
#: The prover is exact where numbers stay rational; the checker may need more bits for the same.
MORE_BITS = (1, 2, 4, 8, 16)
#: More than MANY collisions are checked with few bits first.
MANY, FEW_BITS = 500, 80


#: The pages of the theorems that a scene may cite.
PAGES = {
    CLASSIFICATION: "classification",
    CLASSIFICATION_OF_BALLS: "classification_of_balls",
    FLOW: "flow",
    FLOW_OF_BALLS: "flow_of_balls",
    LINE: "line",
    SANDWICH: "sandwich_below",
    SHARPER: "sharper",
    THREE_BALLS: "three_balls",
    TOUCHING: "touching",
}


@cache
def cited_context(name: str) -> Context:
    """The context that a scene applies, by the name by which it cites it."""
    theorem, _, context = name.partition(":")
    return statement(PAGES[theorem]).context(context)


def tell(found: Fate) -> Telling:
    """What happened, in terms."""
    telling = Telling(found.flow.scene)
    moves = [] if is_settled_at_start(found) else found.flow.moves
    if moves:
        telling.begin(moves[0].before.frame)
    for move in moves:
        if move.kind == COLLIDE:
            telling.collide(move.weights)
        elif move.kind == DRIFT:
            telling.drift(move.time)
        else:
            telling.recentre()
    _tell_end(telling, found)
    return telling


def _tell_end(telling: Telling, found: Fate) -> None:
    if found.verdict == COLLAPSES and found.collapse is not None:
        with balls.precision(found.flow.bits):
            low, high = (balls.ends(balls.as_ball(end)) for end in found.collapse.time)
        time = short_outward((low[0], high[1]))
        angle = short_outward(found.collapse.angle)
        numbers = {name: balls.fraction_of(x) for name, x in found.collapse.numbers.items()}
        telling.collapse(Numbers(numbers, time, angle, found.collapse.stair))
    elif found.verdict == DISPERSES:
        telling.disperse(found.flow.apart)
    elif found.verdict == FINITE and found.criterion is not None:
        telling.limit(found.criterion.name)


def short_outward(ends: tuple[Fraction, Fraction]) -> tuple[Fraction, Fraction]:
    """Decimals around two ends, with a few digits more than those on which they agree."""
    low, high = ends
    digits, width = 4, high - low
    while width and digits < 60 and abs(high) > width * 10 ** (digits - 3):
        digits += 1
    down, up = round_decimal(low, digits, up=False), round_decimal(high, digits, up=True)
    return down[0] * Fraction(10) ** down[1], up[0] * Fraction(10) ** up[1]


def precisions(found: Fate) -> list[int]:
    """The precisions to try, in turn: few bits for many collisions, as work is limited."""
    bits = found.flow.bits
    few = [FEW_BITS] if len(found.flow.collisions) > MANY and bits > FEW_BITS else []
    return [*few, *(factor * bits for factor in MORE_BITS)]


# --- the certificate -----------------------------------------------------------------------------


def scene_outcome(found: Fate, bits: int) -> Outcome:
    """The verdict as a statement with a certificate that evaluates with so many bits."""
    telling = tell(found)
    if not any(row.name.startswith(DECISIVE) for row in telling.rows):
        raise ValueError(f"no row shows that the scene {found.verdict}")
    statement = statement_of(telling, found)
    proofs = {row.name: _proof(row, telling, bits) for row in telling.rows}
    decisions = {name: Decision(PROVED, proof) for name, proof in proofs.items()}
    names = [*telling.parameters, *(constant.name for constant in telling.constants)]
    steps: list[Step] = [ConstantStep(name, Interval(bits)) for name in names]
    steps += [ObligationStep(name, proof) for name, proof in proofs.items()]
    return Outcome(statement, decisions, tuple(steps), dict(_times(found, telling, bits)))


def statement_of(telling: Telling, found: Fate) -> Statement:
    """What is claimed."""
    used = {name for row in telling.rows for name in row.uses}
    return Statement(
        "scene",
        _in_one_line(found),
        telling.parameters,
        tuple(telling.constants),
        (),
        tuple(telling.rows),
        tuple(a for a in ASSUMPTIONS if a.name in used),
        tuple(cites(found)),
    )


def _in_one_line(found: Fate) -> str:
    """The verdict, with the title of the file before it and its unit of length at the end."""
    lines, labels = list(scene_lines(found._replace(reason=""))), found.flow.scene.labels
    title = f"{lines.pop(0)}: " if labels.title else ""
    unit = f"; {lines.pop()}" if labels.length_unit else ""
    return f"{title}{' '.join(lines)}{unit}"


def cites(found: Fate) -> list[Cite]:
    """The statements whose theorems are applied."""
    return [_cite(name) for name in theorems(found)]


@cache
def _cite(name: str) -> Cite:
    """What is claimed in a theorem, with its proof; whoever writes the scene has both checked."""
    return cite(PAGES[name])._replace(name=name)


def _proof(row: Obligation, telling: Telling, bits: int) -> Proof:
    if isinstance(row.claim, Applies):
        context = cited_context(row.claim.context)
        return Applying(
            tuple(_premise(given.claim, row.claim.at, bits, telling) for given in context.givens)
        )
    if telling.is_short:
        return Interval(bits)
    kind, _, name = row.name.partition(".")
    given = tuple(telling.parameters)
    if kind == "is":
        return Sum((), (*given, name))
    if kind == "start":
        gap, _, _ = telling.exact.pair(int(name[0]), int(name[1]))
        return Sum(("goal", str(gap)), given)
    if kind == "line":
        return Sum((), given)
    if kind == "range":
        side, _, pair = name.partition(".")
        restitution = telling.parameters[f"{RESTITUTION}.{pair}" if pair else RESTITUTION].value
        return Sum(("goal", str(restitution if side == "low" else 1 - restitution)), given)
    return Interval(bits)


def _premise(given: Claim, at: Mapping[str, Term], bits: int, telling: Telling) -> Premise:
    """A definition is the fact that a constant of the scene has it; enclosures show the rest.

    An equation of masses, radii and shares follows from what is given.
    """
    if given.relation == "=" and given.lhs.op != "symbol":
        lengths = (c.name for c in telling.constants if c.name.startswith("l."))
        return Sum((), (*lengths, *telling.parameters))
    if given.relation == "=" and at[given.lhs.name].op == "symbol":
        return at[given.lhs.name].name
    return Interval(bits)


def _times(found: Fate, telling: Telling, bits: int) -> Iterator[tuple[str, Enclosure]]:
    """The times of the collisions, and of what comes between them."""
    told = {constant.name for constant in telling.constants}
    with balls.precision(found.flow.bits):
        for number, move in enumerate(found.flow.moves, 1):
            if (name := f"{TIME}.{number}") in told:
                ball = balls.loosened(balls.as_ball(move.after.time))
                ends = enclosing_decimals(*balls.widened_ends(ball, 4 * DIGITS), DIGITS)
                yield name, Enclosure(bits, (ends,))


# --- all statements of a scene, from its parameters alone -----------------------------------------


#: No more bits are needed for these than without digits.
FEW_DIGITS = 16


def read_back(parameters: Mapping[str, Term]) -> Scene | None:
    """The scene whose parameters these are; None if they are those of no scene that is accepted."""
    count = sum(name.startswith("x.0.") for name in parameters)
    is_unequal = f"{MASS}.0" in parameters
    sizes = [[f"{letter}.{i}" for i in range(3)] for letter in SIZES] if is_unequal else []
    rows = {
        letter: [[f"{letter}.{i}.{k}" for k in range(1, count + 1)] for i in range(3)]
        for letter in ("x", "v")
    }
    pairs = [f"{RESTITUTION}.{pair_name(i, j)}" for i, j in PAIRS]
    restitutions = [RESTITUTION] if RESTITUTION in parameters else pairs
    names = {*restitutions, *(name for table in rows.values() for row in table for name in row)}
    names |= {name for row in sizes for name in row}
    numbers = all(term.op == "rational" for term in parameters.values())
    if count < 1 or {*parameters} != names or not numbers:
        return None
    positions, velocities = (
        tuple(tuple(parameters[name].value for name in row) for row in rows[letter])
        for letter in ("x", "v")
    )
    bodies = (
        Bodies(*(tuple(parameters[name].value for name in row) for row in sizes)) if sizes else None
    )
    if bodies is not None and min(*bodies.masses, *bodies.radii) <= 0:
        return None
    values = [parameters[name].value for name in restitutions]
    several = (values[0], values[1], values[2]) if len({*values}) > 1 else None
    if several is None and restitutions is pairs:
        return None
    if several is not None and bodies is None:
        return None
    scene = Scene(max(values), positions, velocities, bodies=bodies, restitutions=several)
    return scene if is_in_range(scene) else None


def statements_of(scene: Scene, collisions: int) -> Iterator[Outcome]:
    """What the program makes of a scene with so many rows about collisions.

    It depends on the number of digits, and of collisions, that were asked for.
    """
    for limits in _budgets(collisions):
        found = decide_scene(scene, limits)
        told = 0 if is_settled_at_start(found) else len(found.flow.collisions)
        if found.verdict != UNDECIDED and told == collisions:
            yield scene_outcome(found, found.flow.bits)


def _budgets(collisions: int) -> Iterator[Budget]:
    """What may have been asked for.

    Whoever asks for digits is told of a collapse what shows it after the last collision that was
    followed; so it does not matter how many digits these were, but for the bits that they need.
    """
    yield Budget(max(MAX_COLLISIONS, collisions + 1))
    yield Budget(collisions)
    yield Budget(collisions, FEW_DIGITS)
    yield Budget(collisions, MAX_DIGITS)
