"""The job `classification`: the four theorems, and what they say at one r, or by r."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import gcd, isqrt

from verify.language.statement import PROVED, UNDECIDED
from verify.prover.outcome import Outcome
from verify.views.findings import AboutMiddle, AtMasses, AtR, Count, OnALine
from verify.views.restitution import comes_to_rest, never

#: Bits of the least final -cos.
BITS = 160
#: Work on the numbers of the comparison sequence: products of lengths in bits, added up.
BUDGET = 1 << 37
#: So many numbers of collisions are told, from the least on.
COUNTS = 6
#: All squares of cos(π/n) that are rational, by Niven's theorem, but for that of n = 2.
RATIONAL = {3: Fraction(1, 4), 4: Fraction(1, 2), 6: Fraction(3, 4)}
#: The number under a root that is written has to be below this.
MOST_UNDER_ROOT = 10**10


def at_restitution(r: Fraction) -> AtR:
    """What the theorems say for 0 < r ≤ 1; all but the enclosure is exact."""
    from verify.prover import balls  # flint is loaded only where it is used

    excluded = never(r)
    with balls.precision(BITS):
        root = balls.root(balls.from_fraction(r))
        least = balls.ends(4 * root / balls.from_fraction(1 + r))
    longest = longest_run(r) if excluded else None
    undecided = excluded and longest is None
    return AtR(r, least, excluded, longest, undecided, comes_to_rest(r))


def at_masses(masses: tuple[Fraction, ...], r: Fraction) -> AtMasses:
    """What the classification of balls says of three masses and one r in (0, 1], exactly.

    b² is (1+r)²M, so that b < 2√r just if r > (1-√(1-M))/(1+√(1-M)) = M/(1+√(1-M))².
    """
    from verify.spheres.scene.middle import Middle, excluded, rests

    found = []
    for o, i, j in ((0, 1, 2), (1, 0, 2), (2, 0, 1)):
        middle = Middle(o, (i, j), masses[o], (masses[i], masses[j]), (r, r))
        endless = _count(middle.square / (1 + r) ** 2, None)
        never, at_rest = (shown(middle) is not None for shown in (excluded, rests))
        found.append(AboutMiddle(o, never, at_rest, endless.least_r))
    return AtMasses(r, masses, tuple(found))


def on_a_line(masses: Sequence[Fraction]) -> tuple[OnALine, ...]:
    """How many collisions there are on a line, for each ball in the middle, by r in (0, 1].

    Closing speeds are, but for positive factors, s_1, s_2, … with s_0 = 0, s_1 = 1 and s_{n+1} =
    (1+r)√M s_n - r s_{n-1}. So s_n = √r^(n-1) sin(nφ)/sin(φ), where 2√r cos(φ) = (1+r)√M, if that
    is below 2√r; there are N collisions if s_{N+1} is the first that is not positive, that is, if
    φ is at least π/(N+1) and less than π/N. It is at least π/n just if r is at least that r at
    which (1+r)²M = 4rc², where c = cos(π/n): M/(c+√(c²-M))².
    """
    found = []
    for o, i, j in ((0, 1, 2), (1, 0, 2), (2, 0, 1)):
        m, one, two = masses[o], masses[i], masses[j]
        share = one * two / ((m + one) * (m + two))
        first = least_n(share)
        counts = [_count(share, n) for n in range(first, first + COUNTS)]
        found.append(OnALine(o, share, _count(share, None), tuple(counts)))
    return tuple(found)


def least_n(share: Fraction) -> int:
    """The least n with cos(π/n)² of at least a number in ]0,1[."""
    from verify.prover import balls

    for n, square in RATIONAL.items():
        if square == share:
            return n
    bits = BITS
    while True:
        with balls.precision(bits):
            turn = balls.root(balls.from_fraction(share)).acos()
            low, high = balls.ends(balls.pi() / turn) if turn > 0 else (Fraction(0), Fraction(1))
        if low // 1 == high // 1:
            return int(low // 1) + 1
        bits *= 2


def _count(share: Fraction, n: int | None) -> Count:
    """The r at which φ is π/n, below which there are n collisions; without n, at which it is 0."""
    from verify.prover import balls

    square = Fraction(1) if n is None else RATIONAL.get(n)
    bits, exact = BITS, "" if square is None else _surd(share / square)
    while True:
        with balls.precision(bits):
            c = balls.from_fraction(Fraction(1)) if n is None else (balls.pi() / n).cos()
            if square is not None:
                under = balls.from_fraction(square - share)
            else:
                under = c * c - balls.from_fraction(share)
            if square is not None or under > 0:
                root = c + balls.root(under)
                least = balls.ends(balls.from_fraction(share) / (root * root))
                return Count(0 if n is None else n - 1, least, exact)
        bits *= 2


def _surd(share: Fraction) -> str:
    """M/(1+√(1-M))² as (A-B√C)/D; empty if C would be long."""
    p, q = share.numerator, share.denominator
    under, factor = q * (q - p), 2
    if under >= MOST_UNDER_ROOT:
        return ""
    for d in range(isqrt(under), 1, -1):
        if under % (d * d) == 0:
            under, factor = under // (d * d), factor * d
            break
    common = gcd(2 * q - p, factor, p)
    a, b, divisor = (2 * q - p) // common, factor // common, p // common
    if under <= 1:
        return str(Fraction(a - b * under, divisor))
    text = f"{a}-{'' if b == 1 else b}√{under}"
    return text if divisor == 1 else f"({text})/{divisor}"


def verdict_at(outcome: Outcome, found: AtR | None) -> str:
    """The verdict on all that was asked for: the theorems, and what they say at one r."""
    short_of_work = found is not None and found.undecided
    return UNDECIDED if outcome.verdict == PROVED and short_of_work else outcome.verdict


def longest_run(r: Fraction) -> int | None:
    """The least n >= 1 with s_n <= 0, where s_0 = 0, s_1 = 1, s_{n+1} = (1+r)/2 s_n - r s_{n-1}.

    With r = p/q the numbers s_n (2q)^(n-1) are integers. None beyond the budget; r has to be one
    for which there is such an n.
    """
    p, q = r.numerator, r.denominator
    before, now, n, work = 0, 1, 1, 0
    while now > 0:
        before, now, n = now, (p + q) * now - 4 * p * q * before, n + 1
        work += now.bit_length() * max(64, q.bit_length())
        if work > BUDGET:
            return None
    return n
