"""What holds where: Theorem 1 over the plane of its parameters, and the roots of Q for every r.

The repaired constants are short decimals chosen at one point. Over a region they are formulas: a
fixed share of the bound below which each may be chosen, so that each row is a claim about r and
c. (V_0 and delta_theta are those of the committed certificates.)

The sides of a cell of the plane are intervals of s = r^(1/3) and of c = -cos theta_0. In s both
thresholds are smooth down to r = 0: the stability threshold is 2s(1+s)/(1+s^3), that of existence
is 4 s^(3/2)/(1+s^3).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import cache
from itertools import pairwise

from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, REMARK, Choice, Constant, Obligation
from verify.language.terms import Claim, Term, as_term, sqrt, symbol
from verify.paper.commands.spectrum import roots_of_q
from verify.paper.hypotheses import hypotheses
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.cover import Box, Field, Values, refined
from verify.prover.ground import Ground
from verify.prover.outcome import Ends
from verify.prover.proof import LemmaStep
from verify.prover.rules import Interval
from verify.prover.session import Session
from verify.prover.slopes import BITS, Side
from verify.views.material import Ratios, Roots

FIXED = {"V_0": as_term(1), "delta_theta": as_term(Fraction(1, 10))}

#: Where it is found out which rows are identities: irrational, so that values alone decide none.
SAMPLE = FIXED | {"r": sqrt(2) / 50, "c": sqrt(Fraction(19, 20))}


def formulas(group: str, share: Fraction) -> tuple[Constant, ...]:
    """The constants of a set as ``share`` of their bounds (1/share of T*), after the common ones.

    With the share 1 each is its bound.
    """
    own = theorem().parts[group].constants
    return (*theorem().common, *(_formula(constant, share) for constant in own))


def _formula(item: Constant | Choice, share: Fraction) -> Constant:
    if isinstance(item, Constant):
        return item
    bound = item.constant.term
    if share == 1:
        return item.constant
    if item.base is not None:
        return item.constant._replace(term=item.base + share * (bound - item.base))
    factor = share if item.direction == "down" else 1 / share
    return item.constant._replace(term=factor * bound)


def field_definitions(constants: Iterable[Constant]) -> Iterator[tuple[str, Term]]:
    """What a field over r and c needs; r and c themselves stay to be defined before it."""
    yield from FIXED.items()
    for constant in constants:
        # phi+ = alpha_0 - phi-, the sum of the roots: the slopes of alpha_0 then cancel.
        term = symbol("alpha_0") - symbol("phi_minus") if constant.name == "phi_plus" else None
        yield constant.name, constant.term if term is None else term


def at_point(group: str, share: Fraction, parameters: dict[str, Term]) -> Ground:
    """The formulas at one point, where claims about them can be decided."""
    ground = Ground(Session())
    for name, term in parameters.items():
        ground.define(Constant(name, name, name, "", term))
    for constant in formulas(group, share):
        ground.define(constant)
    return ground


class Rows(Record):
    """The rows of a set: those that enclosures can decide, and those that algebra does.

    The two sides of ``algebraic`` rows are equal wherever they are defined, or the row follows
    because a min is at most its entries; no enclosure can decide that. The sample point only
    shows which rows these are: the proof there uses no value of a parameter.
    """

    open: tuple[Obligation, ...]
    algebraic: tuple[Obligation, ...]

    @property
    def claims(self) -> dict[str, Claim]:
        """The claims that enclosures can decide, by the names of their rows."""
        return {row.name: row.claim for row in self.open if isinstance(row.claim, Claim)}


@cache
def sorted_rows(group: str, share: Fraction) -> Rows:
    """The rows of a set, sorted into the two kinds."""
    ground = at_point(group, share, SAMPLE)
    kinds: tuple[list[Obligation], list[Obligation]] = ([], [])
    for row in theorem().parts[group].obligations:
        kinds[_is_algebraic(ground, row)].append(row)
    return Rows(*map(tuple, kinds))


def _is_algebraic(ground: Ground, row: Obligation) -> bool:
    if not isinstance(row.claim, Claim):
        raise TypeError(f"{row.name} compares no numbers")
    before = len(ground.session.steps)
    verdict, proof = ground.prove(row.claim)
    if verdict != PROVED or proof is None or isinstance(proof, Interval):
        return False
    lemmas = [s.proof for s in ground.session.steps[before:] if isinstance(s, LemmaStep)]
    unfolded = {name for found in (proof, *lemmas) for name in getattr(found, "using", ())}
    return not SAMPLE.keys() & unfolded


#: Just beyond (3-√5)/2 = 0.38196…, the cube root of r_stabi = 9-4√5.
WIDTH = Fraction(49, 128)

INPUTS = ("s", "c")
CUBE = ("r", symbol("s") ** 3)

#: All of them: r up to just beyond r_stabi, any angle.
PLANE: Box = ((Fraction(0), WIDTH), (Fraction(0), Fraction(1)))

#: The share of its bound at which each repaired constant stands.
SHARE = Fraction(1, 2)
WHOLE = Fraction(1)

#: How many times a side of the plane is halved.
DEPTH = 7

#: r_stabi = 9 - 4√5 = 0.0557280900008…; intervals of r end just below it.
END = Fraction("0.055728")

#: A ratio counts as enclosed if its ends differ by at most this factor.
FACTOR = 2

ROOT_CELLS = 240


# --- the plane -----------------------------------------------------------------------------------


@cache
def stability() -> Claim:
    """The hypothesis that the construction needs."""
    claim = next(row.claim for row in hypotheses() if row.name == "hypotheses.stability")
    if not isinstance(claim, Claim):
        raise TypeError("the hypothesis compares two numbers")
    return claim


def plane(group: str, share: Fraction = SHARE) -> Field:
    """The constants of a set over the plane."""
    return Field(INPUTS, (CUBE, *field_definitions(formulas(group, share))))


@cache
def threshold_boxes(cells: int) -> dict[str, list[Box]]:
    """Enclosures of the two thresholds of c over intervals of s: boxes that contain the curves."""
    s = symbol("s")
    root = symbol("q")  # q = s^(1/2), so that the second one is rational too
    curves = {
        "stability": (2 * s * (1 + s) / (1 + s**3), "s", WIDTH, 1),
        "existence": (4 * root**3 / (1 + root**6), "q", Fraction(619, 1000), 2),
    }
    return {name: list(_curve(*curve, cells)) for name, curve in curves.items()}


def _curve(term: Term, letter: str, end: Fraction, power: int, cells: int) -> Iterable[Box]:
    field, count = Field((letter,), ()), power * cells
    with balls.precision(BITS):
        for index in range(count):
            low, high = end * index / count, end * (index + 1) / count
            found = field.on(((low, high),)).ends(term)
            if found is not None:
                yield (low**power, high**power), found


# --- which entry of the min that bounds eta_bar is the least --------------------------------------


@cache
def least_entries(group: str, depth: int = DEPTH - 1) -> list[tuple[Box, int | None]]:
    """The cells of the plane, each with the entry that is the least at every point, if one is."""
    field = plane(group, WHOLE)
    constants = {constant.name: constant for constant in formulas(group, WHOLE)}
    slots = [field.slot(entry) for entry in constants[f"{group}.eta_bar"].term.children]
    gate = field.slots({"stability": stability()})["stability"]

    def judge_cell(values: Values, _before: int | None) -> tuple[int | None, bool] | None:
        admissible = values.judge(gate)
        if admissible == REFUTED:
            return None
        least = values.least(slots) if admissible == PROVED else None
        return least, least is not None

    found = refined(field, PLANE, depth, None, judge_cell)
    return [(box, least) for box, _, least in found]


# --- how close the two sides are, over r at theta_0 = pi ------------------------------------------


def intervals() -> list[Side]:
    """Intervals of r that shrink by a fixed factor towards both ends."""
    left, right = (_distances(Fraction(1, part)) for part in (4, 8))
    return list(pairwise([*reversed(left), *(END - x for x in right[1:])]))


def _distances(share: Fraction) -> list[Fraction]:
    """Distances from an end, from the middle on; each step is at most a share of what is left."""
    distances = [END / 2]
    while distances[-1] > END / 4000:
        distances.append(distances[-1] - min(distances[-1] * share, END / 36))
    return distances


@cache
def ratios(group: str, share: Fraction) -> list[Ratios]:
    """The rows of a set whose two sides are positive, from the largest ratio to the smallest."""
    field = Field(("r",), (("c", as_term(1)), *field_definitions(formulas(group, share))))
    kinds = sorted_rows(group, share)
    slots = field.slots(kinds.claims)
    boxes: dict[str, list[tuple[Side, Ends]]] = {row.name: [] for row in kinds.open}
    verdicts: dict[str, set[str]] = {row.name: set() for row in kinds.open}
    with balls.precision(BITS):
        for side in intervals():
            values = field.on((side,))
            for name, slot in slots.items():
                verdicts[name].add(values.judge(slot))
                ends = values.ratio(slot)
                positive = values.positive(slot[1]) and values.positive(slot[2])
                if positive and ends is not None and ends[1] < FACTOR * ends[0]:
                    boxes[name].append((side, ends))
    drawn = [
        Ratios(row.name, row.says, row.severity, found, verdicts[row.name], _middle(found))
        for row in kinds.open
        if len(found := boxes[row.name]) > 10 and row.severity != REMARK
    ]
    return sorted(drawn, key=lambda row: row.middle, reverse=True)


def _middle(boxes: Iterable[tuple[Side, Ends]]) -> Fraction:
    """An upper bound of the ratio halfway between the ends, or where it is next enclosed."""
    return min(boxes, key=lambda pair: abs(pair[0][0] - END / 2))[1][1]


# --- the roots of Q ------------------------------------------------------------------------------


@cache
def roots() -> list[Roots]:
    """Boxes that contain r, the roots and both bounds at every m of their intervals."""
    m, (r, real_part, square) = symbol("m"), roots_of_q()
    terms: tuple[Term, ...] = (r, -(m**3), real_part, sqrt(square), -r, -(r**3))
    field, found = Field(("m",), ()), []
    with balls.precision(BITS):
        for index in range(ROOT_CELLS):
            side = (Fraction(index, ROOT_CELLS), Fraction(index + 1, ROOT_CELLS))
            values = field.on((side,))
            found.append(Roots(side, *(_enclosed(values, term) for term in terms)))
    return found


def _enclosed(values: Values, term: Term) -> Ends:
    ends = values.ends(term)
    if ends is None:
        raise ValueError("a root of Q has no enclosure")
    return ends
