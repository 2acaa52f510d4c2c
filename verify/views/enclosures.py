"""Numbers that a view makes itself: entries of minima, more digits, values that are exact."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from fractions import Fraction
from functools import partial

from verify.language.record import Record
from verify.language.statement import PROVED, Constant
from verify.language.terms import Claim, Term, names_of
from verify.prover.decimals import near_decimal, outward
from verify.prover.outcome import Enclosure, Ends, Outcome
from verify.prover.program import ExactArithmetic, Machine, Program, Run
from verify.views.words import SHOWN_BITS, definitions_of, ends_of

#: Digits of the entries of minima, as many as enclosures of constants have.
SHOWN_DIGITS = 27


class Minimum(Record):
    """The entries of a min, and the number (from 1) of the one that is shown to be the least."""

    entries: list[Ends | None]
    least: int | None


def minimum_of(outcome: Outcome, constant: Constant) -> Minimum:
    """The entries of a constant's min, enclosed from the enclosures of the constants in them."""
    entries = constant.term.children
    names = sorted({name for entry in entries for name in names_of(entry)})
    from verify.prover import balls  # loaded only where it is used

    with balls.precision(SHOWN_BITS):
        machine = Machine(Program(names), balls.BallArithmetic())
        known = [ends_of(outcome, name) for name in names]
        inputs = [None if k is None else balls.hull(*map(balls.from_fraction, k)) for k in known]
        run = machine.run(inputs)
        values = [run[entry] for entry in entries]
        ends = [None if value is None else _rounded(balls.ends(value)) for value in values]
    ends = [
        ends_of(outcome, entry.name) if entry.op == "symbol" else found
        for entry, found in zip(entries, ends, strict=True)
    ]
    return Minimum(ends, _least(ends))


def _rounded(ends: Ends) -> Ends:
    low, high = map(Fraction, outward(ends, SHOWN_DIGITS))
    return low, high


def _least(entries: list[Ends | None]) -> int | None:
    known = [pair for pair in entries if pair is not None]
    for number, (_, high) in enumerate(known, 1):
        others = known[: number - 1] + known[number:]
        if len(known) == len(entries) and all(high <= low for low, _ in others):
            return number
    return None


# --- more digits ---------------------------------------------------------------------------------

#: Bits beyond those asked for; what cancels in the formulas takes some of them.
GUARD_BITS = 64


def sharpened(outcome: Outcome, bits: int) -> Outcome:
    """The same outcome with enclosures from at least ``bits`` bits; no decision changes.

    An enclosure that would not be narrower stays.
    """
    program = Program(())
    for name, term in definitions_of(outcome).items():
        program.define(name, term)
    from verify.prover import balls  # loaded only where it is used

    with balls.precision(bits + GUARD_BITS):
        run = Machine(program, balls.BallArithmetic()).run(())
        known = definitions_of(outcome)
        enclosures = {
            name: _narrower(run, old, (known[name],), bits)
            for name, old in outcome.enclosures.items()
        }
        decisions = dict(outcome.decisions)
        for row, found in outcome.rows:
            if found.sides is not None and isinstance(row.claim, Claim):
                sides = _narrower(run, found.sides, (row.claim.lhs, row.claim.rhs), bits)
                decisions[row.name] = found._replace(sides=sides)
    return outcome._replace(enclosures=enclosures, decisions=decisions)


def _narrower(run: Run, old: Enclosure, terms: Iterable[Term], bits: int) -> Enclosure:
    ends = (_ends(run, before, term, bits) for before, term in zip(old.ends, terms, strict=True))
    return old._replace(ends=tuple(ends))


def _ends(run: Run, old: Ends, term: Term, bits: int) -> Ends:
    ball = run[term]
    if ball is None:
        return old
    from verify.prover import balls  # loaded only where it is used

    low, high = map(Fraction, outward(balls.ends(ball), int(bits * 0.30103) + 3))
    return (low, high) if high - low < old[1] - old[0] else old


# --- what is no enclosure ------------------------------------------------------------------------

#: Numerators and denominators of values that are computed exactly have at most so many bits.
EXACT_BITS = 4096

#: Values of functions at rational numbers that are rational.
_KNOWN: dict[str, dict[Fraction, int]] = {
    "exp": {Fraction(0): 1},
    "log": {Fraction(1): 0},
    "cos": {Fraction(0): 1},
    "sin": {Fraction(0): 0},
    "atan": {Fraction(0): 0},
}


class _Values(ExactArithmetic):
    """Rational numbers, with the values of functions that are rational."""

    def operation(self, name: str) -> Callable[..., Fraction | None]:
        if name == "cos_pi":
            return _cos_pi
        known = _KNOWN.get(name)
        return super().operation(name) if known is None else partial(_at, known)


def _at(known: dict[Fraction, int], x: Fraction) -> Fraction | None:
    """The value of a function at a number, if it is known to be rational."""
    found = known.get(x)
    return None if found is None else Fraction(found)


def _cos_pi(x: Fraction) -> Fraction | None:
    """cos(πx), where it is rational: at the multiples of 1/2 and 1/3 alone (Niven)."""
    x = abs((x + 1) % 2 - 1)
    found = {0: 2, Fraction(1, 3): 1, Fraction(1, 2): 0, Fraction(2, 3): -1, 1: -2}.get(x)
    return None if found is None else Fraction(found, 2)


def exactly(outcome: Outcome) -> Outcome:
    """The same outcome for people: a number that is a short decimal is no enclosure of it."""
    rows = [
        (row.name, row.claim, found.sides)
        for row, found in outcome.rows
        if found.sides is not None and isinstance(row.claim, Claim) and _is_near(found.sides)
    ]
    near = [name for name, found in outcome.enclosures.items() if _is_near(found)]
    if not near and not rows:
        return outcome
    program, known = Program(()), dict[str, Term]()
    for name, term in definitions_of(outcome).items():
        if known.keys() >= {*names_of(term)}:  # but not where a constant is one that is cited
            known[name] = term
            program.define(name, term)
    near = [name for name in near if name in known]
    rows = [row for row in rows if known.keys() >= {*names_of(row[1].lhs, row[1].rhs)}]
    run = Machine(program, _Values(EXACT_BITS)).run(())
    enclosures = {name: _exact(run, outcome.enclosures[name], (known[name],)) for name in near}
    decisions = {}
    for row, claim, sides in rows:
        found = _exact(run, sides, (claim.lhs, claim.rhs))
        if outcome.decisions[row].verdict == PROVED and claim.relation == "=":
            found = found._replace(ends=_equal(*found.ends))
        decisions[row] = outcome.decisions[row]._replace(sides=found)
    return outcome._replace(
        enclosures={**outcome.enclosures, **enclosures},
        decisions={**outcome.decisions, **decisions},
    )


def _equal(left: Ends, right: Ends) -> tuple[Ends, Ends]:
    """Two sides that are equal: where one is a number, so is the other one."""
    exact = next((side for side in (left, right) if side[0] == side[1]), None)
    return (left, right) if exact is None else (exact, exact)


def _is_near(enclosure: Enclosure) -> bool:
    return any(near_decimal(ends) is not None for ends in enclosure.ends)


def _exact(run: Run, old: Enclosure, terms: Iterable[Term]) -> Enclosure:
    values = (run[term] for term in terms)
    pairs = zip(old.ends, values, strict=True)
    ends = (e if v is None or v != near_decimal(e) else (v, v) for e, v in pairs)
    return old._replace(ends=tuple(ends))
