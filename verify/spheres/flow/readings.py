"""Two readings of a state: its three pairs, and the paper's letters with unit vectors."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction

from verify.language.argument import ByRoot, Chapter, Item, Line, Opened, identity, proof
from verify.language.record import Record
from verify.language.terms import Claim, Number, Term, equal, sqrt, symbol
from verify.language.vectors import scale
from verify.spheres.flow.frame import Frame, W_c, W_s, minus, x_c, x_s
from verify.spheres.flow.law import Keep, Pair, State, inner, outer, unnamed
from verify.spheres.flow.spaces import space, state_of

PAIRS, UNIT = "pairs", "unit"
LABEL = "EQUATSS2.2IterationSystm1"
THREE = ("c", "s", "outer")


class Unit(Record):
    """The state with ω_c = x_c/reach: -ω_c·W_c, x_s·W_s, -x_s·ω_c, ω_c·W_s and reach - 1."""

    reach: Number
    closing: Number
    parting: Number
    cosine: Number
    turning: Number
    distance: Number


def pairs_of(state: State, keep: Keep = unnamed) -> dict[str, Pair]:
    """The pairs o, c and o, s and s, c."""
    found = zip(THREE, (*inner(state), outer(state)), strict=True)
    return {
        name: Pair(*(keep(f"{f}_{name}", getattr(pair, f)) for f in Pair._fields))
        for name, pair in found
    }


def unit_of(state: State, root: Callable[[Number], Number], keep: Keep = unnamed) -> Unit:
    """The numbers of the state in the paper's letters."""
    gap = state.eps * state.v**2
    reach = keep("reach", root(1 + gap))
    return Unit(
        reach,
        keep("closing", state.lam * state.v / reach),
        keep("parting", state.rho * state.v),
        keep("cosine", state.C / reach),
        keep("turning", state.b / reach),
        keep("distance", gap / (1 + reach)),
    )


def _definitions(prefix: str, read: Callable[[State, Keep], object]) -> dict[str, Claim]:
    found: dict[str, Claim] = {}

    def keep(name: str, term: Number) -> Term:
        new = symbol(f"{prefix}.{name}")
        found[f"{new.name}-is"] = equal(new, term)
        return new

    read(state_of(f"{prefix}."), keep)
    return found


def pairs_givens() -> dict[str, Claim]:
    """What the nine numbers are."""
    return _definitions(PAIRS, pairs_of)


def unit_givens() -> dict[str, Claim]:
    """What the six numbers are, each after what it needs."""
    now = state_of(f"{UNIT}.")
    free = _definitions(UNIT, lambda state, keep: unit_of(state, sqrt, keep))
    reach = symbol(f"{UNIT}.reach")
    first = {"unit-contact": equal(now.sig, 0), "unit-room": 0 < 1 + now.eps * now.v**2}
    first |= {"unit.reach-is": free["unit.reach-is"]}
    return {**first, "unit-reach": 0 < reach, "unit-divisor": 0 < 1 + reach, **free}


#: Numbers of a state with |x_c|² = 9/4.
POINT = State(*map(Fraction, ("1", "1", "1", "5/4", "0", "1", "1", "1", "0", "0", "0")))


def chapters() -> Iterator[Chapter]:
    """Both readings."""
    point: dict[str, int | Fraction | Term] = {
        f"{PAIRS}.{k}": x for k, x in POINT._asdict().items()
    }
    pairs_of(POINT, lambda name, x: point.setdefault(f"{PAIRS}.{name}", x))
    says = "the three pairs of a state: |x|² - 1, x·w and |w|² of each"
    yield Chapter(None, (Opened(space(PAIRS, says, point, pairs_givens())),))
    yield Chapter(PAIRS, tuple(_pair_lines()))
    point = {f"{UNIT}.{k}": x for k, x in POINT._asdict().items()}
    unit_of(POINT, lambda _: Fraction(3, 2), lambda n, x: point.setdefault(f"{UNIT}.{n}", x))
    says = "a state in the paper's letters: ω_c = x_c/|x_c|"
    yield Chapter(None, (Opened(space(UNIT, says, point, unit_givens())),))
    yield Chapter(UNIT, tuple(_unit_lines()))


def _pair_lines() -> Iterator[Item]:
    frame = Frame(state_of(f"{PAIRS}."))
    vectors = {"c": (x_c, W_c), "s": (x_s, W_s), "outer": (minus(x_c, x_s), minus(W_c, W_s))}
    for name, (x, w) in vectors.items():
        g, p, m = (symbol(f"{PAIRS}.{f}_{name}") for f in Pair._fields)
        claims = {"gap": (frame.square(x), 1 + g), "rate": (frame.dot(x, w), p)}
        claims["speed"] = (frame.square(w), m)
        for kind, (left, right) in claims.items():
            using = identity(" ".join(pairs_givens()))
            says = {"gap": "|x|² = 1 + g", "rate": "x·w = p", "speed": "|w|² = m"}[kind]
            yield Line(f"pair-{name}-{kind}", equal(left, right), using, LABEL, says)


def _unit_lines() -> Iterator[Item]:
    now = state_of(f"{UNIT}.")
    frame = Frame(now)
    reach, *rest = (symbol(f"{UNIT}.{name}") for name in Unit._fields)
    closing, parting, cosine, turning, distance = rest
    omega = scale(1 / reach, x_c)
    yield Line("unit-root", 0 < unit_givens()["unit.reach-is"].rhs, ByRoot())
    using = "unit.reach-is unit-contact"
    rows = {
        "unit-contact-s": (frame.square(x_s), 1, "|x_s| = 1: o and s are in contact"),
        "unit-length": (frame.square(omega), 1, "|ω_c| = 1 for ω_c = x_c/reach"),
        "unit-closing": (frame.dot(omega, W_c), -closing, "ω_c·W_c = -closing"),
        "unit-parting": (frame.dot(x_s, W_s), parting, "x_s·W_s = parting"),
        "unit-cosine": (frame.dot(x_s, omega), -cosine, "x_s·ω_c = -cosine"),
        "unit-turning": (frame.dot(omega, W_s), turning, "ω_c·W_s = turning"),
        "unit-spin": (frame.dot(x_s, W_c), now.a, "x_s·W_c = a"),
        "unit-speed-c": (frame.square(W_c), now.A, "|W_c|² = A"),
        "unit-speed-s": (frame.square(W_s), now.B, "|W_s|² = B"),
        "unit-speeds": (frame.dot(W_s, W_c), now.w, "W_s·W_c = w"),
        "unit-distance": (reach, 1 + distance, "reach = 1 + distance"),
    }
    names = ("closing", "parting", "cosine", "turning", "distance")
    using = " ".join((using, *(f"unit.{name}-is" for name in names)))
    for name, (left, right, says) in rows.items():
        yield Line(name, equal(left, right), identity(using), LABEL, says)
    yield Line("unit-reach-positive", 0 < reach, proof("unit-reach"))
