"""Simulated balls contradict none of the theorems: random ones, and nearly collapsing ones."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from mpmath import mp, mpf

from tests.paper.classification.simulation import Balls, Collision, on_a_line, scattered
from verify.paper.commands.classification import at_restitution, longest_run

#: Rounding at 100 digits, far below anything that is compared.
DUST = mpf(10) ** -70
#: A run is left when its closing speeds or its free flights are below this.
TINY = mpf(10) ** -50
#: How near the final angle is when closing speeds are tiny.
NEARLY = mpf(10) ** -6
COUNTS = {"1/5": 4, "1/10": 7, "2/25": 11, "3/40": 17, "147/2000": 23}


def exact(number: Any) -> Any:
    """A fraction as a number of mpmath."""
    return mpf(number.numerator) / number.denominator if isinstance(number, Fraction) else number


def shared(first: Collision, second: Collision) -> int | None:
    """The ball that two collisions of different pairs have in common."""
    both = {*first.pair} & {*second.pair}
    return both.pop() if len(both) == 1 else None


def alternating(collisions: list[Collision]) -> Iterator[list[Collision]]:
    """The longest runs in which one ball meets two others in turn."""
    run: list[Collision] = []
    for collision in collisions:
        if len(run) > 1 and collision.pair == run[-2].pair and collision.pair != run[-1].pair:
            run.append(collision)
        else:
            if run:
                yield run
            run = [run[-1], collision] if run and run[-1].pair != collision.pair else [collision]
    if run:
        yield run


def against_the_lemma(collisions: list[Collision]) -> list[str]:
    """Pairs that met again although no angle between was obtuse."""
    found = []
    obtuse = dict.fromkeys(((0, 1), (0, 2), (1, 2)), True)
    for collision in collisions:
        if not obtuse[collision.pair]:
            found.append(f"{collision.pair} meets again at {mp.nstr(exact(collision.time), 5)}")
        obtuse[collision.pair] = False
        for ball, cosine in collision.cosines.items():
            for pair in obtuse:
                if ball in pair and pair != collision.pair and cosine < 0:
                    obtuse[pair] = True
    return found


def against_the_recursion(collisions: list[Collision], r: Any) -> list[str]:
    """Three closing speeds in turn with u'' > (1+r)/2 (-cos) u' - r u."""
    found = []
    for run in alternating(collisions):
        for first, second, third in zip(run, run[1:], run[2:], strict=False):
            ball = shared(first, second)
            assert ball is not None
            bound = (1 + r) / 2 * -second.cosines[ball] * second.u - r * first.u
            if exact(third.u - bound) > DUST:
                found.append(f"closing speed at {mp.nstr(exact(third.time), 5)}")
    return found


class Watched:
    """Balls that are followed to the end, with what is found wrong on the way."""

    def __init__(self, balls: Balls, r: Fraction | None, most: int) -> None:
        self.balls, self.wrong = balls, list[str]()
        self.start = balls.square, balls.virial, balls.spin()
        self.impulse = self.weighted = 0
        self.ended = False
        outward = balls.virial >= 0 and balls.square >= 2
        ratio = balls.virial / mp.sqrt(balls.square)
        while len(balls.collisions) < most:
            if not balls.step():
                self.ended = True
                break
            ratio = self.after(balls.collisions[-1], ratio)
            if balls.collisions[-1].u < TINY:
                break
        self.wrong += against_the_lemma(balls.collisions)
        if r is not None:
            self.wrong += against_the_recursion(balls.collisions, exact(r))
            self.count(r, outward)

    def after(self, collision: Collision, ratio: Any) -> Any:
        """Compare the sums after a collision with their bounds."""
        balls = self.balls
        R2, A, L = self.start
        touch = balls.sigma[collision.pair] * collision.J
        self.impulse += touch
        self.weighted += touch * collision.time
        size, energy = mp.sqrt(balls.square), mp.sqrt(balls.energy)
        new = balls.virial / size
        checks = {
            "total impulse": self.impulse <= mp.sqrt(R2) * energy - A + DUST,
            "A/R": ratio <= new + DUST,
            "A/R and e": new <= energy + DUST,
            "impulse times": self.weighted + balls.square / 2 - collision.time * balls.virial
            <= R2 / 2 + DUST,
            "angular momentum": all(
                abs(p - q) < DUST for p, q in zip(L, balls.spin(), strict=True)
            ),
            "its bound": mp.sqrt(sum(p**2 for p in L)) <= size * energy + DUST,
        }
        self.wrong += [
            f"{name} at {mp.nstr(balls.time, 5)}" for name, fine in checks.items() if not fine
        ]
        return new

    def count(self, r: Fraction, outward: bool) -> None:
        """The number of collisions, for balls of equal size."""
        least = at_restitution(r)
        longest = max((len(run) for run in alternating(self.balls.collisions)), default=0)
        if least.longest is not None and longest > least.longest:
            self.wrong.append(f"a run of {longest} collisions")
        if (least.excluded or outward) and not self.ended:
            self.wrong.append(f"{len(self.balls.collisions)} collisions and no end")
        last = self.balls.collisions[-10:]
        if not self.ended and last[-1].u < TINY:
            ball = shared(last[-2], last[-1])
            if last not in alternating(last) or ball is None:
                self.wrong.append("a collapse in another order")
            elif -last[-1].cosines[ball] < exact(least.least_neg_cos[0]) - NEARLY:
                self.wrong.append("a collapse at a smaller angle")


def violations(seed: int, dimension: int, kind: str, equal: bool) -> list[str]:
    """What is wrong with one random run."""
    rates = [Fraction(t) for t in ("1/50", "1/20", "9/125", "2/25", "1/10", "1/5", "1/2", "9/10")]
    r = rates[seed % len(rates)] if equal else None
    balls = scattered(seed, dimension, equal=equal, r=r, kind=kind)
    return Watched(balls, r, 150).wrong


@pytest.mark.parametrize("dimension", [2, 3])
@pytest.mark.parametrize("kind", ["heap", "chain", "triangle"])
def test_random_runs(dimension: int, kind: str) -> None:
    for seed in range(16):
        assert violations(seed, dimension, kind, True) == []
        assert violations(seed, dimension, kind, False) == []


def test_there_are_collapses_among_them() -> None:
    """At small r many chains collapse: then the order and the angle are compared, too."""
    r = Fraction(1, 50)
    found = [
        Watched(scattered(seed, 2, equal=True, r=r, kind="chain"), r, 300) for seed in range(12)
    ]
    assert [watched.wrong for watched in found] == [[]] * 12
    collapsed = [watched for watched in found if not watched.ended]
    assert len(collapsed) > 3
    assert all(len(watched.balls.collisions) > 30 for watched in collapsed)


@pytest.mark.parametrize(("text", "count"), COUNTS.items())
def test_the_longest_run_is_attained_on_a_line(text: str, count: int) -> None:
    r = Fraction(text)
    assert longest_run(r) == count
    balls = on_a_line(r, Fraction(10))
    while balls.step():
        assert len(balls.collisions) <= count
    pairs = [collision.pair for collision in balls.collisions]
    assert pairs == [((0, 1), (0, 2))[i % 2] for i in range(count)]
    assert against_the_lemma(balls.collisions) == []


def test_the_recursion_is_an_equation_on_a_line() -> None:
    r = Fraction(1, 10)
    balls = on_a_line(r, Fraction(3))
    while balls.step():
        pass
    u = [collision.u for collision in balls.collisions]
    assert u[:2] == [1, 3]
    for first, second, third in zip(u, u[1:], u[2:], strict=False):
        assert third == (1 + r) / 2 * second - r * first


def test_the_watch_sees_what_is_wrong() -> None:
    balls = on_a_line(Fraction(1, 5), Fraction(10))
    while balls.step():
        pass
    faster = [*balls.collisions]
    faster[2].u *= 2
    assert against_the_recursion(faster, Fraction(1, 5))
    for collision in faster:
        collision.cosines = dict.fromkeys(collision.cosines, Fraction(1))
    assert against_the_lemma(faster)
