"""The job `classification`: the four theorems, and what they say at one r."""

from __future__ import annotations

from fractions import Fraction

from verify.language.statement import PROVED, UNDECIDED
from verify.prover.outcome import Outcome
from verify.views.findings import AboutMiddle, AtMasses, AtR
from verify.views.restitution import comes_to_rest, never

#: Bits of the least final -cos.
BITS = 160
#: Work on the numbers of the comparison sequence: products of lengths in bits, added up.
BUDGET = 1 << 37


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
    from verify.prover import balls  # flint is loaded only where it is used
    from verify.spheres.scene.middle import Middle, excluded, rests

    found = []
    for o, i, j in ((0, 1, 2), (1, 0, 2), (2, 0, 1)):
        middle = Middle(o, (i, j), masses[o], (masses[i], masses[j]), (r, r))
        share = middle.square / (1 + r) ** 2
        with balls.precision(BITS):
            rest = 1 + balls.root(balls.from_fraction(1 - share))
            largest = balls.ends(balls.from_fraction(share) / (rest * rest))
        never, at_rest = (shown(middle) is not None for shown in (excluded, rests))
        found.append(AboutMiddle(o, never, at_rest, largest))
    return AtMasses(r, masses, tuple(found))


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
