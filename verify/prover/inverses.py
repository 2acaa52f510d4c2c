"""Claims about far away numbers as claims about their inverses, which are near 0.

Both sides of a claim may come together where a variable x is large, as log(1 + 1/x) and
1/sqrt(x (x + 1)) do. With x = 1/t they meet at t = 0, and signs of derivatives show what holds from
there on. So each function of x is written as one of t that is defined at 0, if there is one.
"""

from __future__ import annotations

from collections.abc import Mapping

from flint import fmpq_mpoly

from verify.language.record import Record
from verify.language.terms import Claim, Term, as_term, atan, log, names_of, nth_root, pi, sqrt
from verify.prover.balls import fraction_of
from verify.prover.clearing import ROOTS, Clearing, TooLongError, atoms_of, coefficients, index_of
from verify.prover.multiple import outside_atoms

ONE, QUARTER = as_term(1), pi / 2


class Image(Record):
    """A function of x as one of t: as it is with its argument in t, and as it is used."""

    plain: Term
    used: Term


def inverted(
    claim: Claim, x: Term, t: Term, sign: int
) -> tuple[Claim, Mapping[Term, Image]] | None:
    """The claim with 1/t (or -1/t) for x, and the images of functions; None if that is too long."""
    images: dict[Term, Image] = {}
    chosen: dict[Term, Term] = {x: as_term(sign) / t}
    try:
        for atom in atoms_of((claim.lhs, claim.rhs), {}):
            if atom == x or x.name not in names_of(atom):
                continue
            if atom.op in ("min", "max"):
                return None
            images[atom] = _image(atom, chosen, t)
            chosen[atom] = images[atom].used
        sides = [_quotient(outside_atoms(side, chosen)) for side in (claim.lhs, claim.rhs)]
    except TooLongError:
        return None
    return Claim(claim.relation, *sides), images


def _image(atom: Term, chosen: Mapping[Term, Term], t: Term) -> Image:
    """The images of a function, where those inside it are known."""
    argument = _quotient(outside_atoms(atom.children[0], chosen))
    plain = Term(atom.op, argument, *atom.args[1:])
    power, rest, sign = _without_powers(argument, t)
    if atom.op == "log" and power:
        far = as_term(power) * log(t)
        return Image(plain, far if rest == ONE else log(rest) + far)
    if atom.op == "atan" and power < 0 and sign:
        inverse = atan(_quotient(ONE / argument))
        return Image(plain, (QUARTER if sign > 0 else -QUARTER) - inverse)
    if atom.op in ROOTS and power // index_of(atom):
        index = index_of(atom)
        outer, inner = divmod(power, index)
        radicand = _quotient(t**inner * rest) if inner else rest
        root = sqrt(radicand) if index == 2 else nth_root(radicand, index)
        return Image(plain, root * t**outer if outer > 0 else root / t**-outer)
    return Image(plain, plain)


def _cleared(term: Term) -> tuple[Clearing, fmpq_mpoly, fmpq_mpoly]:
    """Numerator and denominator without common factors, the latter with a leading 1."""
    clearing = Clearing((term,), {})
    above, below = clearing.clear(term)
    if below.is_zero():
        raise TooLongError
    common = above.gcd(below)
    if common.is_zero():
        return clearing, above, clearing.one
    above, below = above / common, below / common
    scale = below.leading_coefficient()
    return clearing, above / scale, below / scale


def _quotient(term: Term) -> Term:
    clearing, above, below = _cleared(term)
    return clearing.term(above) if below == clearing.one else _over(clearing, above, below)


def _over(clearing: Clearing, above: fmpq_mpoly, below: fmpq_mpoly) -> Term:
    return clearing.term(above) / clearing.term(below)


def _without_powers(term: Term, t: Term) -> tuple[int, Term, int]:
    """The power of t in a quotient, the rest, and the sign of the rest at 0 (0: unknown)."""
    clearing, above, below = _cleared(term)
    if t not in clearing.atoms or above.is_zero():
        return 0, term, 0
    index, power = clearing.atoms.index(t), 0
    rests, sign = [], 1
    for way, polynomial in ((1, above), (-1, below)):
        parts = coefficients(polynomial, index)
        least = min(parts)
        power += way * least
        rests.append(polynomial / clearing.generators[t] ** least)
        first = parts[least]
        is_known = first.is_constant()
        sign *= (1 if fraction_of(first.leading_coefficient()) > 0 else -1) if is_known else 0
    rest = _over(clearing, *rests) if rests[1] != clearing.one else clearing.term(rests[0])
    return power, rest, sign
