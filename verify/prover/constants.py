"""Numbers without variables: balls on a ladder of precisions, exact rationals, enclosures.

Nothing here is trusted. What is found is written down as the steps of a certificate.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction

from verify.language.fold import fails, holds
from verify.language.record import Any
from verify.language.statement import PROVED, REFUTED, Constant
from verify.language.terms import Claim, Term, as_term, parts_of
from verify.prover import balls
from verify.prover.decimals import enclosing_decimals
from verify.prover.outcome import Enclosure, Ends
from verify.prover.program import ExactArithmetic, Machine, Program, Run
from verify.prover.proof import Proof
from verify.prover.rules import Interval
from verify.prover.session import ZERO, Session

DEFAULT_PRECISION = 128
DEFAULT_MAX_PRECISION = 1 << 16

#: More bits than the precision that is asked for, so that enclosures have as many.
GUARD_BITS = 64

#: More bits for the checker, whose intervals may be a little wider than balls.
CHECKER_BITS = 32

MAX_BITS = 1 << 16

#: An argument of cos with so many bits before the point costs the checker no more than those above.
SMALL = 8

#: A value that has no reliable bits with this precision is taken for zero: its enclosure is narrow.
ZERO_BITS = 4096

#: Enclosures are written with this many digits, which come from at least this many relative bits,
#: so that every version of FLINT agrees on them.
DIGITS = 27
RELIABLE_BITS = 128


#: Short decimals near constants have this denominator, and so many bits before the point.
SHORT, SHORT_BITS = 10**9, 1000


class Constants:
    """Constants that are defined one after another, and what enclosures show of them.

    Args:
        session: where the steps are written down.
        start_bits: the first precision tried.
        max_bits: the last one.
    """

    def __init__(
        self,
        session: Session,
        start_bits: int = DEFAULT_PRECISION,
        max_bits: int = DEFAULT_MAX_PRECISION,
    ) -> None:
        self.session = session
        self.start_bits, self.max_bits = start_bits, max_bits
        self.definitions: dict[str, Term] = {}
        self._program = Program(())
        self._balls: dict[int, Run] = {}
        self._within: dict[tuple[Term, int], Any] = {}
        self._enclosed: dict[Term, tuple[int, Ends] | None] = {}
        self._exact = Machine(self._program, ExactArithmetic()).run(())
        self._small = Machine(self._program, ExactArithmetic(RELIABLE_BITS)).run(())

    # --- values ---------------------------------------------------------------------------------

    def define(self, constant: Constant) -> bool:
        """Add a constant over names defined before; False if no precision shows its value."""
        self.know(constant.name, constant.term)
        bits = self.defined_at(constant.term)
        if bits is not None:
            self.session.constant(constant, Interval(bits))
        return bits is not None

    def know(self, name: str, term: Term) -> None:
        """A name that has this value, as somebody else has shown or will show."""
        self.definitions[name] = term
        self._program.define(name, term)

    def defined_at(self, term: Term) -> int | None:
        """A precision at which the checker sees that a term has a value."""
        shown = (bits for bits in self.ladder() if self.ball(term, bits) is not None)
        return next(map(_for_checker, shown), None)

    def ball(self, term: Term, bits: int) -> Any:
        """The ball of a term at this precision; None where it may be undefined, or too long."""
        if (term, bits) not in self._within:
            found = self._computed(term, bits)
            is_near = found is None or balls.is_within_reach(found)
            self._within[term, bits] = found if is_near else None
        return self._within[term, bits]

    def _computed(self, term: Term, bits: int) -> Any:
        working = bits + GUARD_BITS
        run = self._balls.get(working)
        slot = self._program.known(term)
        if run is not None and slot is not None and slot < len(run.values):
            return run.values[slot]
        with balls.precision(working):
            if run is None:
                machine = Machine(self._program, balls.BallArithmetic())
                run = self._balls[working] = machine.run(())
            return run[term]

    def compile(self, claims: Iterable[Claim]) -> None:
        """Compile many claims, so that the first value that is asked for computes all of them."""
        for claim in claims:
            self._program.add(claim.lhs)
            self._program.add(claim.rhs)

    def exact(self, term: Term) -> Fraction | None:
        """The value of a term where it is computed within the rational numbers."""
        value = self._exact[term]
        return value if isinstance(value, Fraction) else None

    def ladder(self) -> Iterator[int]:
        """The precisions to try: from the first, doubled, up to the last."""
        bits = self.start_bits
        while bits < self.max_bits:
            yield bits
            bits *= 2
        yield self.max_bits

    def sign(self, term: Term) -> int:
        """1 or -1 for a term that is proved positive or negative, else 0."""
        for bits in self.ladder():
            ball = self.ball(term, bits)
            if ball is not None and (found := balls.strict_sign(ball)):
                return found
            if self.exact(term) == 0:
                return 0
        return 0

    def short_bound(self, term: Term, *, up: bool) -> Term | None:
        """The value, if it is rational; else a short decimal near it, above it or below.

        None where there is none, also of a number that is too large.
        """
        exact = self.exact(term)
        if exact is not None:
            return as_term(exact)
        ball = self.ball(term, self.start_bits)
        if ball is None or balls.magnitude_bits(ball) > SHORT_BITS:
            return None
        low, high = balls.ends(ball)
        near = -(-high * SHORT // 1) if up else low * SHORT // 1
        return as_term(Fraction(near, SHORT))

    # --- enclosures for people ------------------------------------------------------------------

    @property
    def no_value(self) -> str:
        """The message about a term that has no enclosure."""
        return (
            f"has no value at {self.max_bits} bits; "
            "look for a divisor that is 0, or a root or logarithm of a negative number"
        )

    def why_no_value(self, term: Term) -> str:
        """The message about a term that has no enclosure: what it cannot have a value for."""
        for part in parts_of(term):
            if part.op in ("sqrt", "root", "log") and self._first_sign(part.children[0]) < 0:
                kind = "logarithm" if part.op == "log" else "root"
                return f"has no value: it has the {kind} of a negative number"
            if part.op in ("div", "log") and self.exact(part.children[-1]) == 0:
                what = "it divides by 0" if part.op == "div" else "it has the logarithm of 0"
                return f"has no value: {what}"
        return self.no_value

    def _first_sign(self, term: Term) -> int:
        """The sign of a term, if one precision shows it; else 0."""
        ball = self.ball(term, 8 * self.start_bits)
        return 0 if ball is None else balls.strict_sign(ball)

    def enclose(self, *terms: Term) -> Enclosure | None:
        """Decimal ends around values, outside those that the checker will compute."""
        reached, found = 0, []
        for term in terms:
            result = self._enclose(term)
            if result is None:
                return None
            reached = max(reached, result[0])
            found.append(result[1])
        return Enclosure(reached, tuple(found))

    def _enclose(self, term: Term) -> tuple[int, Ends] | None:
        if term not in self._enclosed:
            self._enclosed[term] = self._find_enclosure(term)
        return self._enclosed[term]

    def _find_enclosure(self, term: Term) -> tuple[int, Ends] | None:
        small, best = self._small[term], None
        if small is not None:
            n, d = small.numerator, small.denominator
            return _for_checker(self.start_bits), enclosing_decimals(n, n, d, DIGITS)
        for bits in self.ladder():
            ball = self.ball(term, bits)
            if ball is not None and ball.is_finite():
                wide = balls.widened_ends(ball, RELIABLE_BITS - 4)
                best = _for_checker(bits + self._lost()), enclosing_decimals(*wide, DIGITS)
                if balls.accuracy_bits(ball) >= RELIABLE_BITS or bits >= ZERO_BITS:
                    break
        return best

    def _lost(self) -> int:
        """How many bits the checker loses where it reduces large arguments of cos."""
        slots = self._program.cosines
        runs = self._balls.values() if slots else ()
        values = (run.values[slot] for run in runs for slot in slots if slot < len(run.values))
        return max(
            (2 * bits for bits in map(balls.magnitude_bits, values) if bits > SMALL), default=0
        )

    # --- claims that enclosures decide ----------------------------------------------------------

    def decide_at(self, claim: Claim, bits: int) -> tuple[str, Proof] | None:
        """What the enclosures at one precision, or exact values, decide."""
        verdict = self.compare(claim, bits)
        if verdict is not None:
            lost = self._lost()
            return None if lost > MAX_BITS // 2 else (verdict, Interval(_for_checker(bits + lost)))
        a, b = self.exact(claim.lhs), self.exact(claim.rhs)
        if a is not None and b is not None:
            return PROVED if holds(claim.relation, a, b) else REFUTED, Interval(MAX_BITS)
        return None

    def lemma(self, claim: Claim) -> str | None:
        """The name of a fact, known or proved by enclosures or exact values; None if it is not."""
        known = self.session.known(claim, None)
        if known is not None:
            return known
        for bits in self.ladder():
            found = self.decide_at(claim, bits)
            if found is not None:
                verdict, proof = found
                return self.session.lemma(claim, proof) if verdict == PROVED else None
        return None

    def positive(self, term: Term) -> str | None:
        """The name of the fact that a term is positive, if it is."""
        return self.lemma(Claim("<", ZERO, term))

    def compare(self, claim: Claim, bits: int) -> str | None:
        """The verdict that the enclosures of the two sides give, if any."""
        lhs, rhs = self.ball(claim.lhs, bits), self.ball(claim.rhs, bits)
        if lhs is None or rhs is None:
            return None
        if holds(claim.relation, lhs, rhs):
            return PROVED
        return REFUTED if fails(claim.relation, lhs, rhs) else None

    def holds_at(self, claim: Claim, bits: int) -> bool:
        """Whether the enclosures at one precision, or exact values, prove the claim."""
        found = self.decide_at(claim, bits)
        return found is not None and found[0] == PROVED

    def may_hold(self, claim: Claim, bits: int) -> bool:
        """False if the enclosures refute the claim."""
        return self.compare(claim, bits) != REFUTED


def _for_checker(bits: int) -> int:
    return min(bits + GUARD_BITS + CHECKER_BITS, MAX_BITS)
