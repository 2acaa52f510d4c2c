"""The flow of a scene, collision by collision, in balls and exact rationals.

Each collision is shown to be the next one: the spheres o and c meet, and the two other pairs stay
apart until then and at that instant. What balls leave open is never guessed: `UnclearError`.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.contexts import PARTING, PASSING
from verify.spheres.flow.law import (
    Flight,
    Number,
    Pair,
    Sizes,
    State,
    collided,
    drifted,
    flight,
    inner,
    outer,
    parted,
    recentred,
)
from verify.spheres.scene.scene import (
    AROUND_FIRST,
    FIRST_FRAMES,
    PAIRS,
    Coordinates,
    Frame,
    Scene,
    coordinates,
    pair_name,
    sizes_of,
)

COLLIDE, RECENTRE, DRIFT = "collide", "recentre", "drift"
#: How often one flight may be cut where two spheres pass each other.
MAX_CUTS = 6
#: Where p² is by this factor below m g, a pair is all but where it is nearest.
NEAREST = 1 << 40
#: Times that differ by such a share count as a tie in messages.
SAME = 1e-9
GRAZE = "may graze or miss"
ZERO = balls.fmpq_of(Fraction(0))


#: The names of what balls may leave open.
NEAR_TIE, NEAR_TRIPLE, NEAR_GRAZING = "near-tie", "near-triple-contact", "near-grazing"
UNCLEAR = "unclear"


class UnclearError(ArithmeticError):
    """What balls of this precision leave open, in words, with a name."""

    def __init__(self, words: str, name: str = UNCLEAR) -> None:
        super().__init__(words)
        self.name = name


class Moment(Record):
    """A state with the labels of its spheres, and the time since the start."""

    frame: Frame
    state: State
    time: Number


class Weights(Record):
    """Why the law of pairs says that o and c collide, although another pair is in contact.

    The rate x·w of the pair o, s is at least -s times its |x|² - K over y² then, that of s and c at
    least -o times its |x|² - K, less angle; that is 0 unless o, c and s make a right angle at c.
    """

    s: Fraction
    o: Fraction
    angle: Fraction


class Move(Record):
    """From one moment to the next: a collision (with its flight), a new centre, or a drift.

    A collision has weights if another pair is in contact, or may be.
    """

    kind: str
    before: Moment
    after: Moment
    way: Flight | None = None
    time: Fraction = Fraction(0)
    weights: Weights | None = None


class Flow:
    """The moves so far; `advance` adds those of the next collision."""

    def __init__(self, scene: Scene, bits: int) -> None:
        self.scene, self.bits = scene, bits
        self.r = balls.fmpq_of(scene.r)
        self.start: Coordinates = coordinates(scene, balls.fmpq_of)
        self.moves: list[Move] = []
        self.collisions: list[Move] = []
        #: Why each pair does not collide any more, by its name, once that is certain.
        self.apart: dict[str, str] = {}
        #: Whether all spheres stay on one line, once that was asked for.
        self.is_on_a_line: bool | None = None

    @property
    def now(self) -> Moment | None:
        """The moment just after the last collision; None before the first."""
        return self.collisions[-1].after if self.collisions else None

    def sizes(self, frame: Frame) -> Sizes:
        """What the law needs of the spheres besides r."""
        return sizes_of(self.scene, frame, balls.fmpq_of)

    def keep(self, _: str, value: Number) -> Number:
        """A rational number stays one while it is short."""
        return balls.shortened(value, self.bits)

    def advance(self) -> bool:
        """Take the next collision; False if it is certain that there is none.

        Raises:
            UnclearError: if balls of this precision do not show which one it is.
        """
        never = True
        meets: list[tuple[float, str]] = []
        unclear: list[str] = []
        for moves, moment in self._candidates():
            way = meeting(moment)
            never = never and way is None
            if isinstance(way, str):
                unclear.append(way)
            elif way is not None:
                found = self._collide(moment, way)
                if found is not None:
                    self.moves += [*moves, *found]
                    self.collisions.append(found[-1])
                    return True
                meets.append((balls.as_float(way.y * way.T), name_of(moment.frame)))
        if not never:
            raise _what_is_unclear(meets, unclear)
        self.apart = why_apart(self)
        return False

    def end_after(self, collisions: int) -> None:
        """Forget all that comes after so many collisions."""
        del self.collisions[collisions:]
        if not self.collisions:
            self.moves.clear()
            return
        last = self.collisions[-1]
        del self.moves[1 + next(i for i, move in enumerate(self.moves) if move is last) :]

    def _candidates(self) -> Iterator[tuple[list[Move], Moment]]:
        """Moments whose o, c may be the next pair, with the moves that lead there."""
        now = self.now
        if now is None:
            more = () if self.scene.bodies is None else (AROUND_FIRST,)
            for frame in (*FIRST_FRAMES, *more):
                yield [], Moment(frame, self.start.state(frame, self.keep), ZERO)
            return
        yield [], now
        o, s, c = now.frame
        state = recentred(now.state, self.keep, self.sizes(now.frame))
        other = Moment((s, o, c), state, now.time)
        yield [Move(RECENTRE, now, other)], other

    def _collide(self, moment: Moment, way: Flight) -> list[Move] | None:
        """The flight and the collision of o and c, if no other pair meets before."""
        moves: list[Move] = []
        sizes = self.sizes(moment.frame)
        while (cut := passing(moment.state, way, sizes)) is not None:
            moves.append(self._drift(moment, cut))
            found = meeting(moves[-1].after)
            if (
                len(moves) > MAX_CUTS
                or not is_free(moves[-1], sizes)
                or not isinstance(found, Flight)
            ):
                return None
            moment, way = moves[-1].after, found
        weights = None
        if not is_next(moment.state, way, sizes):
            weights = None if self.scene.bodies is None else touching(moment.state, way, sizes)
            if weights is None:
                return None
        o, s, c = moment.frame
        r = balls.fmpq_of(self.scene.restitution(moment.frame[0], moment.frame[2]))
        state = collided(r, moment.state, way, self.keep, sizes)
        after = Moment((o, c, s), state, self.keep("time", moment.time + way.y * way.T))
        return [*moves, Move(COLLIDE, moment, after, way, weights=weights)]

    def _drift(self, moment: Moment, time: Fraction) -> Move:
        exact = balls.fmpq_of(time)
        state = drifted(moment.state, exact, self.keep)
        after = Moment(moment.frame, state, self.keep("time", moment.time + exact))
        return Move(DRIFT, moment, after, None, time)


def name_of(frame: Frame) -> str:
    """The pair o, c."""
    return pair_name(frame[0], frame[2])


def never_meets(pair: Pair) -> str | None:
    """Why the pair does not collide in free flight: it parts, or it passes by; None if unknown."""
    g, p, m = pair
    if p >= 0 and m >= 0:
        return PARTING
    return PASSING if m > 0 and p * p < m * g else None


def pairs_now(flow: Flow) -> dict[str, Pair]:
    """The three pairs just after the last collision, or at the start, by their names."""
    if flow.now is None:
        return {pair_name(i, j): flow.start.pair(i, j) for i, j in PAIRS}
    (o, s, c), (own, spectator) = flow.now.frame, inner(flow.now.state)
    names = (pair_name(o, c), pair_name(o, s), pair_name(s, c))
    other = outer(flow.now.state, flow.sizes(flow.now.frame))
    return dict(zip(names, (own, spectator, other), strict=True))


def why_apart(flow: Flow) -> dict[str, str]:
    """Why each pair does not collide any more, by its name.

    Raises:
        UnclearError: if balls of this precision do not show it of all three.
    """
    reasons = {}
    for name, pair in pairs_now(flow).items():
        reason = never_meets(pair)
        if reason is None:
            raise UnclearError(f"the spheres of {name} may approach or part")
        reasons[name] = reason
    return reasons


def meeting(moment: Moment) -> Flight | str | None:
    """How o and c meet; None if they never do in free flight; or what is unclear."""
    state, name = moment.state, name_of(moment.frame)
    pair, _ = inner(state)
    if never_meets(pair):
        return None
    if not state.lam > 0:
        return f"the spheres of {name} may approach or part"
    reduced = 1 - state.A * (state.eps / state.lam / state.lam)
    if not reduced > 0:
        return f"{name} {GRAZE}"
    if not state.eps >= 0:
        return f"{name} may be in contact"
    return flight(state, balls.any_root)


def is_next(state: State, way: Flight, sizes: Sizes) -> bool:
    """True only if no other pair meets before o and c do, or at that instant."""
    return (
        bool(state.sig >= 0)
        and bool(state.sig + way.T * state.lam * state.rho >= 0)
        and bool(parted(state, way) > 0)
        and stays_apart(outer(state, sizes), way.y * way.T)
    )


def stays_apart(pair: Pair, time: Number) -> bool:
    """True only if the pair is apart at all times in (0, time]."""
    g, p, m = pair
    step = p * time
    return bool(g >= 0) and bool(g + step >= 0) and bool(g + time * (2 * p + m * time) > 0)


def touching(state: State, way: Flight, sizes: Sizes) -> Weights | None:
    """Why o and c are the only pair that approaches in contact then, or the order does not matter.

    None unless balls or exact numbers show it.
    """
    time, spectator, other = way.y * way.T, inner(state)[1], outer(state, sizes)
    if not all(_never_overlaps(pair, time) for pair in (spectator, other)):
        return None
    own = _weight(spectator.p + spectator.m * time, parted(state, way))
    rate = other.p + other.m * time
    outermost = _weight(rate, other.g + time * (2 * other.p + other.m * time))
    if own is None:
        return None
    if outermost is not None:
        return Weights(own, outermost, Fraction(0))
    corner = sizes.c + state.C - time * (state.a + state.b + time * state.w)
    if not (balls.is_rational(corner) and corner == 0):
        return None
    return Weights(own, Fraction(0), balls.fraction_of(balls.decimal(-rate, 0, above=True)))


def _never_overlaps(pair: Pair, time: Number) -> bool:
    """True only if the pair is apart or in contact up to the time, and does not graze then."""
    g, p, m = pair
    end = g + time * (2 * p + m * time)
    is_known = end > 0 or time == 0 or (p == 0 and m == 0)
    if not is_known and not p + m * time < 0:
        return False
    return bool(g >= 0) and bool(g + p * time >= 0) and bool(end >= 0)


def _weight(rate: Number, gap: Number) -> Fraction | None:
    """A number z >= 0 such that the rate is at least -z times the gap; or None."""
    if rate >= 0:
        return Fraction(0)
    if gap > 0:
        return balls.fraction_of(balls.decimal(balls.as_ball(-rate / gap), 0, above=True))
    return None


def passing(state: State, way: Flight, sizes: Sizes) -> Fraction | None:
    """The time at which another pair is nearest, or just after, if it passes before o, c meet."""
    time = way.y * way.T
    _, spectator = inner(state)
    times = []
    for pair in (spectator, outer(state, sizes)):
        g, p, m = pair
        if g + p * time < 0 and never_meets(pair) and m > 0:
            beyond = 2 if NEAREST * p * p < m * g else 1  # so that it parts, however short t is
            times.append(balls.short_rational(-beyond * p / m))
    return min(times, default=None)


def is_free(drift: Move, sizes: Sizes) -> bool:
    """True only if all pairs are apart during a drift."""
    state, time = drift.before.state, balls.fmpq_of(drift.time)
    pairs = (*inner(state), outer(state, sizes))
    return bool(time > 0) and all(stays_apart(pair, time) for pair in pairs)


def _what_is_unclear(meets: list[tuple[float, str]], unclear: list[str]) -> UnclearError:
    first = min(meets, default=(0.0, ""))[0]
    names = [*dict.fromkeys(name for time, name in meets if time <= first * (1 + SAME))]
    if len(names) > 1:
        words = f"tie: {' and '.join(names)} meet at the same time, or too nearly so"
        return UnclearError(words, NEAR_TIE)
    found = [f"triple contact: {name} meets, and another pair may touch then" for name in names]
    grazes = any(words.endswith(GRAZE) for words in unclear)
    name = NEAR_TRIPLE if found else NEAR_GRAZING if grazes else UNCLEAR
    return UnclearError("; ".join([*found, *unclear]), name)
