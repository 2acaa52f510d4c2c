"""Enclosures over intervals of one number, for the plots: thresholds, ratios of rows, roots of Q.

The repaired constants are short decimals chosen at one point. Over an interval of r they are
formulas: a fixed share of the bound below which each may be chosen, so that each row is a claim
about r. (V_0 and delta_theta are those of the committed certificates.)

Each interval is cut into parts, and balls enclose the values on each part. What holds on all parts
holds at every point. Nothing rests on it but the plots.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cache
from itertools import pairwise

from verify.language.fold import fails, holds
from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Choice, Constant, Obligation
from verify.language.terms import Claim, Term, as_term, sqrt, symbol
from verify.paper.commands.spectrum import roots_of_q
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.ground import Ground
from verify.prover.outcome import Ends
from verify.prover.program import Machine, Program
from verify.prover.proof import LemmaStep
from verify.prover.rules import Interval
from verify.prover.session import Session
from verify.publication import REMARK
from verify.views.findings import Ratios, Roots

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

#: The share of its bound at which each repaired constant stands.
SHARE = Fraction(1, 2)
WHOLE = Fraction(1)

#: r_stabi = 9 - 4√5 = 0.0557280900008…; intervals of r end just below it.
END = Fraction("0.055728")

#: A ratio counts as enclosed if its ends differ by at most this factor.
FACTOR = 2

ROOT_CELLS = 240

#: Each interval is cut into so many parts, and has so many bits, which is plenty for its width.
PARTS = 8
BITS = 64


# --- on an interval ------------------------------------------------------------------------------

#: The value of a term on each part of an interval; None where it is undefined or not enclosed.
Values = Sequence[balls.Ball | None]


class Curves:
    """Terms as functions of one number.

    Args:
        letter: the number.
        definitions: a term for each further name, in order.
    """

    def __init__(self, letter: str, definitions: Iterable[tuple[str, Term]] = ()) -> None:
        self._machine = Machine(Program((letter,)), balls.BallArithmetic())
        for name, term in definitions:
            self._machine.program.define(name, term)

    def on(self, side: Ends, terms: Sequence[Term]) -> list[Values]:
        """The values of each term on the parts of an interval."""
        slots = [self._machine.program.add(term) for term in terms]
        low, step = side[0], (side[1] - side[0]) / PARTS
        with balls.precision(BITS):
            ends = [balls.from_fraction(low + k * step) for k in range(PARTS + 1)]
            runs = [self._machine.run((balls.hull(*pair),)).values for pair in pairwise(ends)]
            return [[run[slot] for run in runs] for slot in slots]


def hull(values: Values) -> Ends | None:
    """Bounds on a whole interval."""
    found = [balls.ends(value) for value in values if value is not None]
    if len(found) < len(values):
        return None
    return min(low for low, _ in found), max(high for _, high in found)


def verdict(relation: str, left: Values, right: Values) -> str:
    """Whether a claim holds, or fails, at every point of an interval."""
    found = set()
    for a, b in zip(left, right, strict=True):
        if a is None or b is None:
            return UNDECIDED
        found.add(PROVED if holds(relation, a, b) else REFUTED if fails(relation, a, b) else "")
    return found.pop() or UNDECIDED if len(found) == 1 else UNDECIDED


def ratio(left: Values, right: Values) -> Ends | None:
    """Bounds of left/right on an interval, if both are positive."""
    pairs = [(a, b) for a, b in zip(left, right, strict=True) if a is not None and b is not None]
    if len(pairs) < len(left) or not all(a > 0 and b > 0 for a, b in pairs):
        return None
    with balls.precision(BITS):
        return hull([a / b for a, b in pairs])


# --- the thresholds ------------------------------------------------------------------------------


@cache
def threshold_boxes(cells: int) -> Mapping[str, list[tuple[Ends, Ends]]]:
    """The two thresholds of c over intervals of s = r^(1/3): boxes that contain the curves.

    In s both are smooth down to r = 0: stability is 2s(1+s)/(1+s^3), existence 4s^(3/2)/(1+s^3).
    """
    s = symbol("s")
    root = symbol("q")  # q = s^(1/2), so that the second one is rational too
    curves = {
        "stability": (2 * s * (1 + s) / (1 + s**3), "s", WIDTH, 1),
        "existence": (4 * root**3 / (1 + root**6), "q", Fraction(619, 1000), 2),
    }
    return {name: list(_curve(*curve, cells)) for name, curve in curves.items()}


def _curve(
    term: Term, letter: str, end: Fraction, power: int, cells: int
) -> Iterator[tuple[Ends, Ends]]:
    curves, count = Curves(letter), power * cells
    for index in range(count):
        low, high = end * index / count, end * (index + 1) / count
        yield (low**power, high**power), _enclosed(curves, (low, high), (term,))[0]


def _enclosed(curves: Curves, side: Ends, terms: Sequence[Term]) -> list[Ends]:
    found = []
    for term, values in zip(terms, curves.on(side, terms), strict=True):
        ends = hull(values)
        if ends is None:
            raise ValueError(f"{term} has no enclosure")
        found.append(ends)
    return found


# --- how close the two sides are, over r at theta_0 = pi ------------------------------------------


def intervals() -> list[Ends]:
    """Intervals of r that shrink by a fixed factor towards both ends."""
    left, right = (_distances(Fraction(1, part)) for part in (4, 8))
    return list(pairwise([*reversed(left), *(END - x for x in right[1:])]))


def _distances(share: Fraction) -> list[Fraction]:
    """Distances from an end, from the middle on; each step is at most a share of what is left."""
    distances = [END / 2]
    while distances[-1] > END / 4000:
        distances.append(distances[-1] - min(distances[-1] * share, END / 36))
    return distances


def set_over_r(group: str, share: Fraction) -> Curves:
    """The constants of a set as functions of r, at theta_0 = pi."""
    known = ((constant.name, constant.term) for constant in formulas(group, share))
    return Curves("r", (("c", as_term(1)), *FIXED.items(), *known))


@cache
def ratios(group: str, share: Fraction) -> list[Ratios]:
    """The rows of a set whose two sides are positive, from the largest ratio to the smallest."""
    curves, kinds = set_over_r(group, share), sorted_rows(group, share)
    sides = [side for claim in kinds.claims.values() for side in (claim.lhs, claim.rhs)]
    boxes: dict[str, list[tuple[Ends, Ends]]] = {row.name: [] for row in kinds.open}
    verdicts: dict[str, set[str]] = {row.name: set() for row in kinds.open}
    for side in intervals():
        values = iter(curves.on(side, sides))
        for (name, claim), left, right in zip(kinds.claims.items(), values, values, strict=True):
            verdicts[name].add(verdict(claim.relation, left, right))
            ends = ratio(left, right)
            if ends is not None and ends[1] < FACTOR * ends[0]:
                boxes[name].append((side, ends))
    drawn = [
        Ratios(row.name, row.says, row.severity, found, verdicts[row.name], _middle(found))
        for row in kinds.open
        if len(found := boxes[row.name]) > 10 and row.severity != REMARK
    ]
    return sorted(drawn, key=lambda row: row.middle, reverse=True)


def _middle(boxes: Iterable[tuple[Ends, Ends]]) -> Fraction:
    """An upper bound of the ratio halfway between the ends, or where it is next enclosed."""
    return min(boxes, key=lambda pair: abs(pair[0][0] - END / 2))[1][1]


# --- the roots of Q ------------------------------------------------------------------------------


@cache
def roots() -> list[Roots]:
    """Boxes that contain r, the roots and both bounds at every m of their intervals."""
    m, (r, real_part, square) = symbol("m"), roots_of_q()
    terms: tuple[Term, ...] = (r, -(m**3), real_part, sqrt(square), -r, -(r**3))
    curves, found = Curves("m"), []
    for index in range(ROOT_CELLS):
        side = (Fraction(index, ROOT_CELLS), Fraction(index + 1, ROOT_CELLS))
        found.append(Roots(side, *_enclosed(curves, side, terms)))
    return found
