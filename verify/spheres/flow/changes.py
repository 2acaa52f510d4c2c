"""Two changes of a state without a collision: another sphere is central, or time goes on."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Chapter, Item, Line, Opened, identity, proof
from verify.language.terms import Claim, Term, equal, symbol
from verify.language.vectors import Combination, scale
from verify.spheres.flow.frame import BASIS, Frame, W_c, W_s, minus, moved, x_c, x_s
from verify.spheres.flow.law import Number, State, drifted, inner, outer, recentred
from verify.spheres.flow.pairs import FREE, bernstein_claims, between
from verify.spheres.flow.spaces import space, state_of

RECENTRE, DRIFT, DRIFTING = "recentre", "drift", "drifting"
Point = dict[str, int | Fraction | Term]
#: The numbers of the next state that have names of their own.
NAMED = {
    RECENTRE: ("lam", "rho", "eps", "sig", "A", "C", "a", "b", "w"),
    DRIFT: ("lam", "rho", "eps", "sig", "C", "a", "b"),
}


def chapters() -> Iterator[Chapter]:
    """Both changes."""
    yield from _recentre()
    yield from _drift()


def recentring() -> tuple[State, dict[str, Claim]]:
    """A state, and the numbers of the same one seen from s."""
    now = state_of("recentre.")
    return now, _equations("recentre.", lambda keep: recentred(now, keep))


def drifting() -> tuple[State, Term, dict[str, Claim]]:
    """A state, a time of free flight, and what is given about them."""
    now, time = state_of("drift."), symbol("drift.t")
    found = {"drift-unit": 0 < now.v, "drift-time": 0 <= time}
    found |= _equations("drift.", lambda keep: drifted(now, time, keep))
    for name, pair in zip(("c", "s"), inner(now), strict=True):
        found |= bernstein_claims(f"drift-{name}", pair, time)
    return now, time, found | bernstein_claims("drift-outer", outer(now), time)


def _equations(prefix: str, change: Number) -> dict[str, Claim]:
    found: dict[str, Claim] = {}

    def keep(name: str, term: Number) -> Term:
        new = symbol(f"{prefix}{name}_next")
        found[f"{new.name}-is"] = equal(new, term)
        return new

    change(keep)
    return found


def _point(prefix: str, values: State, change: Number) -> Point:
    point: Point = {f"{prefix}{name}": x for name, x in values._asdict().items()}
    change(lambda name, x: point.setdefault(f"{prefix}{name}_next", x))
    return point


def _next(prefix: str, state: Number) -> State:
    return State(*state(lambda name, _: symbol(f"{prefix}{name}_next")))


#: Three spheres in a row, at rest but for one.
ROW = State(*map(Fraction, (1, 1, 0, 0, 0, 1, 0, 1, 0, 0, 0)))
APART = State(*map(Fraction, (1, -1, 1, 1, 1, 1, 1, 1, 0, 0, 0)))


def _recentre() -> Iterator[Chapter]:
    now, givens = recentring()
    point = _point("recentre.", ROW, lambda keep: recentred(ROW, keep))
    says = "s is central from here on, o is the spectator"
    yield Chapter(None, (Opened(space(RECENTRE, says, point, givens)),))
    after = _next("recentre.", lambda keep: recentred(now, keep))
    vectors = {"x_s": scale(-1, x_s), "W_s": scale(-1, W_s)}
    vectors |= {"x_c": minus(x_c, x_s), "W_c": minus(W_c, W_s)}
    lines = _rows(RECENTRE, now, after, vectors, tuple(givens))
    yield Chapter(RECENTRE, tuple(lines))


def _drift() -> Iterator[Chapter]:
    now, time, givens = drifting()
    point = _point("drift.", APART, lambda keep: drifted(APART, Fraction(1), keep))
    point |= {"drift.t": 1}
    says = "all three spheres are in free flight for a time t"
    yield Chapter(None, (Opened(space(DRIFT, says, point, givens)),))
    after = _next("drift.", lambda keep: drifted(now, time, keep))
    vectors = {"x_s": moved(x_s, time, W_s), "W_s": W_s, "x_c": moved(x_c, time, W_c), "W_c": W_c}
    share = symbol("drift.share")
    until = {"drift-share-positive": 0 < share, "drift-share-most": 0 <= 1 - share}
    inside = space(DRIFTING, "a share of that time", {share.name: 1}, until, DRIFT)
    using = tuple(name for name in givens if name.endswith("-is"))
    yield Chapter(DRIFT, (*_rows(DRIFT, now, after, vectors, using), Opened(inside)))
    paths = {"c": (x_c, W_c), "s": (x_s, W_s), "outer": (minus(x_c, x_s), minus(W_c, W_s))}
    words = {"c": "o and c", "s": "o and s", "outer": "s and c"}
    yield Chapter(
        DRIFTING,
        tuple(
            Line(
                f"drift-{name}-apart",
                1 < Frame(now).square(moved(x, share * time, w)),
                proof(between(f"drift-{name}", "drift-share-positive", "drift-share-most")),
                FREE,
                f"{words[name]} are apart meanwhile",
            )
            for name, (x, w) in paths.items()
        ),
    )


def _rows(
    name: str, now: State, after: State, vectors: dict[str, Combination], using: tuple[str, ...]
) -> Iterator[Item]:
    frame, frame_next = Frame(now), Frame(after)
    for k, i in enumerate(BASIS):
        for j in BASIS[k:]:
            yield Line(f"{name}-{i}-{j}",
                       equal(frame.dot(vectors[i], vectors[j]), frame_next.gram(i, j)),
                       identity(" ".join(using)), FREE, f"the next {i}·{j}")  # fmt: skip
