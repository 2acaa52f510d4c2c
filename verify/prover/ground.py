"""The prover: verdicts by balls, exact rationals and rewriting, on a precision ladder.

Nothing here is trusted. What the prover finds out is recorded in a `Decision`, from which a
certificate is written that somebody else can check.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from typing import Any, NamedTuple

from verify.prover import balls
from verify.prover.algebra import is_identity
from verify.prover.decimals import round_decimal
from verify.prover.program import ExactArithmetic, Machine, Program, Run
from verify.language.statement import Constant, Statement
from verify.language.terms import Claim, Term, as_term, substitute, symbols_of

PROVED = "proved"
REFUTED = "refuted"
UNDECIDED = "undecided"

DEFAULT_PRECISION = 128
DEFAULT_MAX_PRECISION = 1 << 16

#: Enclosures are reported with at least this many relative bits (about 1e-28) where they exist.
REPORTED_BITS = 96

#: Chosen constants are rounded to this many significant decimal digits.
CHOSEN_DIGITS = 3

#: Bits at which choices are rounded, whatever the precision asked for, so that they depend on the
#: parameters alone.
CHOICE_BITS = 256

#: How many rewriting steps a proof may have; the longest that the paper needs has four.
MAX_STEPS = 8

Ends = tuple[Fraction, Fraction]
Step = tuple[str, int | None]


class BudgetError(ArithmeticError):
    """The last precision was spent without a result."""


class Decision(NamedTuple):
    """A verdict with its evidence.

    ``method`` is ``interval`` (the enclosures decide), ``exact`` (rational values decide) or
    ``rewrite``: the steps replace a constant by its definition (entry None) or, where that can
    only make the claim harder, by one entry of the min that defines it; then the claim is closed
    by ``closing``, ``interval`` or ``identity``.
    """

    verdict: str
    method: str
    bits: int
    lhs: Ends | None
    rhs: Ends | None
    steps: tuple[Step, ...] = ()
    closing: str = ""


class Prover:
    """Decides claims at one choice of the parameters.

    Args:
        statement: the constants over which claims are written.
        parameters: the value of each parameter, a term without symbols.
        start_bits: the first precision tried.
        max_bits: the last one.
    """

    def __init__(
        self,
        statement: Statement,
        parameters: Mapping[str, Term],
        start_bits: int = DEFAULT_PRECISION,
        max_bits: int = DEFAULT_MAX_PRECISION,
    ) -> None:
        self.start_bits = start_bits
        self.max_bits = max_bits
        self.definitions: dict[str, Term] = {}
        self._program = Program(())
        self._parameters = frozenset(statement.parameters)
        self._balls: dict[int, Run] = {}
        self._enclosures: dict[Term, Ends | None] = {}
        self._exact = Machine(self._program, ExactArithmetic()).run(())
        for name in statement.parameters:
            self._define(name, parameters[name])
        for constant in statement.constants:
            self.define(constant)

    def define(self, constant: Constant) -> None:
        """Add a constant that uses names defined before; choose it where it is to be chosen.

        Raises:
            BudgetError: if the precision does not suffice for a choice.
        """
        term = as_term(choose(self, constant)) if constant.chosen else constant.term
        self._define(constant.name, term)

    def _define(self, name: str, term: Term) -> None:
        self.definitions[name] = term
        self._program.define(name, term)

    def ball(self, term: Term, bits: int) -> Any:
        """The ball of a term at this precision, or None where it is undefined."""
        with balls.precision(bits):
            return self._run(bits)[term]

    def _run(self, bits: int) -> Run:
        """The values at this precision, which must be the current one."""
        run = self._balls.get(bits)
        if run is None:
            run = self._balls[bits] = Machine(self._program, balls.BallArithmetic()).run(())
        return run

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

    def enclose(self, term: Term) -> Ends | None:
        """The ends of an enclosure of a term, with `REPORTED_BITS` relative bits if possible."""
        if term not in self._enclosures:
            self._enclosures[term] = self._enclose(term)
        return self._enclosures[term]

    def _enclose(self, term: Term) -> Ends | None:
        exact = self.exact(term)
        if exact is not None:
            return exact, exact
        best = None
        for bits in self.ladder():
            with balls.precision(bits):
                ball = self._run(bits)[term]
                if ball is not None:
                    best = balls.ends(ball)
                    if balls.accuracy_bits(ball) >= REPORTED_BITS:
                        break
        return best

    def decide(self, claim: Claim) -> Decision:
        """Decide a claim, or say ``undecided`` when the last precision is spent."""
        for bits in self.ladder():
            with balls.precision(bits):
                found = self._decide_at(claim, self._run(bits))
            if found is not None:
                break
        verdict, method, steps, closing = found or (UNDECIDED, "", (), "")
        lhs, rhs = self.enclose(claim.lhs), self.enclose(claim.rhs)
        return Decision(verdict, method, bits, lhs, rhs, steps, closing)

    def proves_at(self, claim: Claim, bits: int) -> bool:
        """Whether a claim is proved at one precision, whatever the ladder."""
        with balls.precision(bits):
            found = self._decide_at(claim, self._run(bits))
        return found is not None and found[0] == PROVED

    def _decide_at(self, claim: Claim, run: Run) -> tuple[str, str, tuple[Step, ...], str] | None:
        lhs, rhs = run[claim.lhs], run[claim.rhs]
        if lhs is None or rhs is None:
            return None
        verdict = _compare(claim.relation, lhs, rhs)
        if verdict is not None:
            return verdict, "interval", (), ""
        a, b = self.exact(claim.lhs), self.exact(claim.rhs)
        if a is not None and b is not None:
            verdict = PROVED if (a < b or (a == b and claim.relation == "<=")) else REFUTED
            return verdict, "exact", (), ""
        found = self._rewrite(claim, run, MAX_STEPS)
        if found is not None:
            return PROVED, "rewrite", *found
        if claim.relation == "<":
            found = self._rewrite(Claim("<=", claim.rhs, claim.lhs), run, MAX_STEPS)
            if found is not None:
                return REFUTED, "rewrite", *found
        return None

    def _rewrite(self, claim: Claim, run: Run, budget: int) -> tuple[tuple[Step, ...], str] | None:
        """Search for steps that end in a claim decided by balls or by an identity."""
        if claim.relation == "<=" and is_identity(claim.lhs, claim.rhs):
            return (), "identity"
        name = self._latest(claim)
        if budget == 0 or name is None:
            return None
        definition = self.definitions[name]
        if definition.op != "min":
            return self._continue(claim, (name, None), definition, run, budget)
        if not self._harder_when_larger(claim, name, run):
            return None
        for index, entry in enumerate(definition.children):
            found = self._continue(claim, (name, index), entry, run, budget)
            if found is not None:
                return found
        return None

    def _continue(
        self, claim: Claim, step: Step, value: Term, run: Run, budget: int
    ) -> tuple[tuple[Step, ...], str] | None:
        name = step[0]
        next_claim = Claim(
            claim.relation,
            substitute(claim.lhs, name, value),
            substitute(claim.rhs, name, value),
        )
        verdict = _compare(claim.relation, run[next_claim.lhs], run[next_claim.rhs])
        if verdict == REFUTED:
            return None
        if verdict == PROVED:
            return (step,), "interval"
        rest = self._rewrite(next_claim, run, budget - 1)
        return None if rest is None else ((step, *rest[0]), rest[1])

    def _latest(self, claim: Claim) -> str | None:
        """The name in a claim that was defined last; parameters are left as they are."""
        names = {*symbols_of(claim.lhs), *symbols_of(claim.rhs)} - self._parameters
        return next((name for name in reversed(self.definitions) if name in names), None)

    def _harder_when_larger(self, claim: Claim, name: str, run: Run) -> bool:
        """Whether raising a constant, all else fixed, can only raise lhs and lower rhs."""

        def sign(term: Term) -> int:
            ball = run[term]
            return 0 if ball is None else balls.sign(ball)

        rises = direction(claim.lhs, name, sign)
        falls = direction(claim.rhs, name, sign)
        return rises in (0, 1) and falls in (0, -1)


def _compare(relation: str, lhs: Any, rhs: Any) -> str | None:
    """The verdict that two enclosures give, if any."""
    if lhs is None or rhs is None:
        return None
    if relation == "<":
        holds, fails = balls.less(lhs, rhs), balls.less_equal(rhs, lhs)
    else:
        holds, fails = balls.less_equal(lhs, rhs), balls.less(rhs, lhs)
    return PROVED if holds else REFUTED if fails else None


def direction(term: Term, name: str, sign: Callable[[Term], int]) -> int | None:
    """How a term moves with a symbol.

    The result is 1 if the term cannot fall as the symbol rises, -1 if it cannot rise, 0 if it
    does not depend on the symbol, None if that is unknown.

    ``sign`` returns 1 for a term known to be non-negative, -1 for non-positive, 0 otherwise.
    """
    if name not in symbols_of(term):
        return 0
    if term.op == "symbol":
        return 1
    parts = [direction(child, name, sign) for child in term.children]
    if None in parts:
        return None
    moves = [part for part in parts if part is not None]
    match term.op:
        case "add" | "min" | "max" | "sqrt":
            return _together(moves)
        case "neg":
            return -moves[0]
        case "sub":
            return _together([moves[0], -moves[1]])
        case "pow" if sign(term.children[0]) == 1:
            return moves[0]
        case "mul":
            a, b = term.children
            return _together_signed([(moves[0], sign(b)), (moves[1], sign(a))])
        case "div":
            a, b = term.children
            return _together_signed([(moves[0], sign(b)), (-moves[1], sign(a))])
    return None


def _together(moves: list[int]) -> int | None:
    seen = set(moves) - {0}
    if len(seen) > 1:
        return None
    return seen.pop() if seen else 0


def _together_signed(pairs: list[tuple[int, int]]) -> int | None:
    moves = []
    for move, sign in pairs:
        if move and not sign:
            return None
        moves.append(move * sign)
    return _together(moves)


def choose(prover: Prover, constant: Constant) -> Fraction:
    """A short decimal on the safe side of a positive bound.

    The result has `CHOSEN_DIGITS` significant digits (above ``base``, where that is given) and
    depends on the parameters alone, not on the precision asked for.

    Raises:
        BudgetError: if the bound is not known to 64 relative bits at the last precision.
    """
    bound = constant.term if constant.base is None else constant.term - constant.base
    ends = prover.exact(bound)
    bits = CHOICE_BITS
    if ends is not None:
        low = high = ends
    else:
        while (ball := prover.ball(bound, bits)) is None or balls.accuracy_bits(ball) < 64:
            bits *= 2
            if bits > prover.max_bits:
                raise BudgetError(f"{constant.name} cannot be chosen with {prover.max_bits} bits")
        low, high = balls.ends(ball)
    up = constant.direction == "up"
    candidates = [round_to_digits(end, up) for end in ((low, high) if up else (high, low))]
    base = Fraction(0)
    if constant.base is not None:
        exact_base = prover.exact(constant.base)
        if exact_base is None:
            raise ValueError(f"the base of {constant.name} is not rational")
        base = exact_base
    value = base + candidates[0]
    if candidates[0] == candidates[1] or _on_safe_side(prover, value, constant, bits):
        return value
    return base + candidates[1]


def _on_safe_side(prover: Prover, value: Fraction, constant: Constant, bits: int) -> bool:
    """Whether a candidate that the bound's ball straddles is proved to be allowed."""
    if constant.direction == "up":
        claims = [constant.term <= as_term(value)]
    else:
        entries = constant.term.children if constant.term.op == "min" else (constant.term,)
        claims = [as_term(value) <= entry for entry in entries]
    return all(prover.proves_at(claim, bits) for claim in claims)


def round_to_digits(value: Fraction, up: bool, digits: int = CHOSEN_DIGITS) -> Fraction:
    """A positive rational rounded up or down to a number of significant decimal digits."""
    if value <= 0:
        raise ValueError("only a positive bound can be rounded to significant digits")
    mantissa, exponent = round_decimal(value, digits, up)
    return mantissa * Fraction(10) ** exponent
