"""Speed against error of the separatrix: an enclosure of f, against plain bisection with mpmath."""

from __future__ import annotations

from fractions import Fraction
from functools import partial
from typing import Any

from mpmath import mp, mpf

from verify.measure import Table, table, timed
from verify.spheres.limit_map import Allowance, Curve, CurveAt, Parameters

#: Where f is enclosed, and the digits asked for.
PLACES = (("3/100", "1", "1", "1/10"), ("1/1000", "1/2", "100", "1/20"), ("1/20", "1", "1", "0"))
DIGITS = (6, 12, 30, 100)
#: Bisection with mpmath is slow, and is measured once, for so many digits at most.
PLAIN_DIGITS = 12
STEPS = 10**8
#: Digits with which mpmath computes, beyond those of the result.
MORE = 10


def separatrix_table(quick: bool, rounds: int) -> Table:
    """Milliseconds and relative width for each number of digits; mpmath proves nothing."""
    rows: list[list[Any]] = []
    for r, c, ratio, q in PLACES[: 1 if quick else None]:
        parameters = Parameters(Fraction(r), Fraction(c), Fraction(ratio))
        for digits in DIGITS[: 2 if quick else None]:
            job = partial(enclosed, parameters, Fraction(q), digits)
            time, (strip, steps) = timed(job, rounds)
            width = (strip.high - strip.low) / strip.low
            row = [f"r = {r}, -cos θ = {c}, ratio {ratio}, q = {q}", digits, steps]
            row += [f"{1000 * time:.2f}", f"{float(width):.1e}", None, None]
            if digits <= PLAIN_DIGITS:
                time, middle = timed(partial(bisected, parameters, Fraction(q), digits))
                row[-2:] = [f"{1000 * time:.2f}", _apart(strip, middle)]
            rows.append(row)
    title = "The separatrix f(q): milliseconds against digits, and plain bisection with mpmath"
    columns = ["at", "digits", "collisions", "balls: ms", "balls: width", "mpmath: ms", "apart by"]
    return table(title, columns, rows)


def enclosed(parameters: Parameters, q: Fraction, digits: int) -> tuple[CurveAt, int]:
    """The enclosure of f(q), and how many collisions were followed for it."""
    budget = Allowance(STEPS)
    strip = Curve(parameters, budget).strip(q, digits)
    return strip, STEPS - budget.left


def bisected(parameters: Parameters, q: Fraction, digits: int) -> mpf:
    """f(q) as plain bisection finds it: an orbit that gets small is taken for one that goes on."""
    with mp.workdps(digits + MORE):
        numbers = (parameters.r, parameters.square_a, parameters.square_rho, q)
        r, square, other, start = (mpf(x.numerator) / x.denominator for x in numbers)
        a, ratio = mp.sqrt(square), mp.sqrt(other)
        low, high = mpf(0), mpf(1)
        while high - low > high / 10**digits:
            middle = (low + high) / 2
            goes_on = _goes_on(r, a, ratio, start, middle)
            low, high = (middle, high) if goes_on else (low, middle)
        return +low


def _goes_on(r: mpf, a: mpf, rho: mpf, q: mpf, u: mpf) -> bool:
    first = u
    while u > first / 10**6:
        p = a * (1 - u) - q - rho * u
        top = rho * u * (2 * q + rho * u)
        if p <= 0 or top >= p * p:
            return False
        q, u, rho = r * (1 - u) / p, 1 - mp.sqrt(1 - top / p**2), 1 / rho
    return True


def _apart(strip: CurveAt, middle: mpf) -> str:
    """How far the result of bisection lies outside of the enclosure, in proportion."""
    with mp.workdps(400):
        low, high = (mpf(end.numerator) / end.denominator for end in (strip.low, strip.high))
        off = max(low - middle, middle - high, 0) / low
        return f"{float(off):.1e}"
