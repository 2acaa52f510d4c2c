"""Enclosures of the eigenvalues and eigenvectors of the limiting velocity matrix at a given r.

With m = (-lambda_0)^(1/3) the spectrum is 1, -m^3 and a complex pair whose real part, squared
imaginary part and squared modulus are rational functions of m (`verify/paper/spectrum.toml`,
rows Q-factorised, modulus, eigenvector-*). So all that is to be found is m, the only real root of

    f(m) = 4 m^3 - (1+r) m^2 + (1+r) m - 4r,

which increases, in m and from 0 to 1 with r. A ball X with c - f(c)/f'(X) in its interior, c its
midpoint, contains exactly one root of f (interval Newton), and the smaller ball contains it.

The root is rational exactly if lambda_0 is. For r = a/b it is then an integer divided by 4b, the
leading coefficient of b f: one candidate is tried exactly.
"""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from verify.prover import balls
from verify.prover.balls import Ball
from verify.views.findings import Rectangle, Spectrum

Scalar = Any  # a Fraction or a Ball: the same formulas serve both

#: Bits beyond those asked for; cancellation near a zero of a component asks for more.
GUARD_BITS = 32

#: An interval of r is cut into this many pieces of equal length in m.
PIECES = 64

#: The estimate of m by doubles is trusted, until it is verified, to so many relative bits.
ESTIMATE_BITS = 40


def at(r: Fraction, bits: int) -> Spectrum:
    """The spectrum at r in (0, 1), each part known to ``bits`` relative bits.

    The precision is raised until that is so. This ends: a part that is not computed exactly is a
    number other than 0.
    """
    work = max(bits, ESTIMATE_BITS, r.denominator.bit_length()) + GUARD_BITS
    while True:
        with balls.precision(work):
            m = enclose_root(r, work)
            exact = rational_root(r, m)
            found = _spectrum(r, m, exact)
        if all(balls.accuracy_bits(ball) >= bits for ball in found.parts):
            return found
        work *= 2


def over(low: Fraction, high: Fraction, bits: int) -> Spectrum:
    """Enclosures valid for all r in [low, high], where 0 < low < high < 1."""
    lengths = (r.denominator.bit_length() for r in (low, high))
    work = max(bits, ESTIMATE_BITS, *lengths) + GUARD_BITS
    with balls.precision(work):
        first, last = enclose_root(low, work), enclose_root(high, work)
        step = (last - first) / PIECES
        cuts = [first, *(first + step * i for i in range(1, PIECES)), last]
        pieces = [_spectrum(None, balls.hull(cuts[i], cuts[i + 1]), None) for i in range(PIECES)]
        hulls = [_hull(parts) for parts in zip(*(piece.parts for piece in pieces), strict=True)]
        return _from_balls([_hull([-(first**3), -(last**3)]), *hulls[1:]])


def enclose_root(r: Fraction, bits: int) -> Ball:
    """A ball around m, verified, at the current precision of ``bits`` bits."""
    restitution = balls.from_fraction(r)
    u = 1 + restitution
    constant = 4 * restitution
    x = balls.around(_estimate(r, restitution), ESTIMATE_BITS)
    known = 0
    while True:
        c = balls.middle(x)
        smaller = c - (((4 * c - u) * c + u) * c - constant) / ((12 * x - 2 * u) * x + u)
        if not known and not balls.inside(smaller, x):
            raise ArithmeticError(f"the estimate of the real root at r = {r} is too far off")
        accuracy = balls.accuracy_bits(smaller)
        if accuracy <= known:
            return x
        x, known = smaller, accuracy
        if accuracy >= bits - 8:
            return x


def _estimate(r: Fraction, ball: Ball) -> Ball:
    """A number close to m, without proof."""
    if r < Fraction(1, 10**30):
        return 4 * balls.middle(ball)
    s = float(r)
    u = 1 + s
    m = 4 * s / u if s < 1e-3 else min(1.0, s ** (1 / 3))
    for _ in range(60):
        step = (((4 * m - u) * m + u) * m - 4 * s) / ((12 * m - 2 * u) * m + u)
        m -= step
        if abs(step) <= 1e-9 * m:
            break
    return balls.from_fraction(Fraction(m))


def rational_root(r: Fraction, m: Ball) -> Fraction | None:
    """The root m of f if it is rational."""
    a, b = r.numerator, r.denominator
    n = balls.integer_in(4 * b * m)
    if n is None:
        return None
    # b f(n/(4b)) times (4b)^3 / (4b).
    value = n**3 - (a + b) * n**2 + 4 * b * (a + b) * n - 64 * a * b * b
    return None if value else Fraction(n, 4 * b)


def _spectrum(r: Fraction | None, ball: Ball, m: Fraction | None) -> Spectrum:
    """The closed formulas; parts that are rational numbers are computed exactly if m is."""
    if m is None:
        values = _rational_functions(ball)
    else:
        values = tuple(map(balls.from_fraction, _rational_functions(m)))
    lambda_0, real, square, factor, modulus, y_0, z_0, t_0, y, z, t, m_1, m_0 = values
    # The imaginary part of the root mu of mu^3 + h mu^2 + h mu + r whose cube is ``plus``.
    q = -balls.root(square) / 2
    third = balls.root(balls.from_fraction(Fraction(3))) / 3
    plus = Rectangle(real, -factor * q)
    one, nothing = balls.from_fraction(Fraction(1)), balls.from_fraction(Fraction(0))
    return Spectrum(
        r,
        None if m is None else -(m**3),
        lambda_0,
        plus,
        modulus * balls.root(modulus),
        balls.argument(*plus),
        (one, third * y_0, z_0, third * t_0),
        (
            Rectangle(one, nothing),
            Rectangle(third * y, third * q * m_1),
            Rectangle(z, q),
            Rectangle(third * t, third * q * m_0),
        ),
    )


def _rational_functions(m: Scalar) -> tuple[Scalar, ...]:
    """The rational functions of m of which everything is made, in balls or exactly."""
    square = m * m
    denominator = square - m + 4
    trace = square - 4 * m + 1
    modulus = (4 * square - m + 1) / denominator
    inverse = 1 / denominator
    inverse_2 = inverse * inverse
    half = inverse / 2
    sum_ = m + 1
    return (
        -(m * square),
        trace * ((((11 * m - 7) * m + 36) * m - 7) * m + 11) * inverse_2 * half,
        3 * ((((5 * m - 4) * m + 18) * m - 4) * m + 5) * inverse_2,
        3 * sum_ * sum_ * (square - m + 1) * inverse_2,
        modulus,
        -3 * m * sum_ * inverse,
        trace * inverse,
        3 * (square - 1) * inverse,
        sum_ * sum_ * sum_ * half,
        (((2 * m - 1) * m + 4) * m + 1) * half,
        (((m - 6) * m + 3) * m - 8) * half,
        1 - m,
        m,
    )


def _from_balls(parts: Iterable[Ball]) -> Spectrum:
    """The spectrum with these parts, in their order."""
    lambda_0, re, im, modulus, argument, y, z, t, *rest = parts
    one, nothing = balls.from_fraction(Fraction(1)), balls.from_fraction(Fraction(0))
    entries = (one, nothing, *rest)
    return Spectrum(
        None,
        None,
        lambda_0,
        Rectangle(re, im),
        modulus,
        argument,
        (one, y, z, t),
        tuple(Rectangle(entries[i], entries[i + 1]) for i in range(0, 8, 2)),
    )


def _hull(parts: Iterable[Ball]) -> Ball:
    first, *others = parts
    for part in others:
        first = balls.hull(first, part)
    return first
