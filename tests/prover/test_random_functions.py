"""Random statements with exponentials, logarithms, sines, inverse tangents, roots and pi.

What is proved or refuted is compared with 2000 bits at many points, as in
`tests.prover.test_random_statements`; ``STATEMENT_FIRST`` and ``STATEMENT_ROUNDS`` choose others.
"""

from __future__ import annotations

from fractions import Fraction

import pytest

from tests.prover.test_random_statements import FIRST, ROUNDS, Statements, wrong
from verify.language.statement import PROVED, REFUTED
from verify.language.terms import Claim, Term, as_term, atan, cos, exp, log, nth_root, pi, sin, tan


class WithFunctions(Statements):
    """Statements in whose terms functions occur often, and claims that touch at a point."""

    def term(self, depth: int) -> Term:
        r = self.random
        if depth == 0 or r.random() < 0.5:
            return super().term(depth)
        a = self.term(depth - 1)
        match r.randrange(9):
            case 0 | 1:
                return exp(a)
            case 2:
                return log(a)
            case 3:
                return sin(a)
            case 4:
                return cos(a)
            case 5:
                return atan(a)
            case 6:
                return nth_root(a, r.choice((2, 3, 4, 5, 9)))
            case 7:
                return tan(a)
        return pi * self.number()

    def compared(self) -> Claim:
        """One of known bounds, perhaps turned around or a little off, in half of the cases."""
        r, a = self.random, self.term(r_depth(self))
        relation = r.choice(("<", "<=", "<="))
        off = as_term(Fraction(r.choice((0, 0, 0, 1, -1)), 10 ** r.randrange(1, 8)))
        bounds = (
            (1 + a, exp(a)),
            (log(a), a - 1),
            (sin(a), a),
            (1 - a**2 / 2, cos(a)),
            (atan(a), a),
            (a / (1 + a), log(1 + a)),
            (exp(a), 1 / (1 - a)),
            (nth_root(a, 3), (2 + a) / 3),
            (a, tan(a)),
            (log(a), nth_root(a, 2)),
        )
        if r.random() < 0.5:
            return super().compared()
        small, large = r.choice(bounds)
        sides = (small + off, large) if r.random() < 0.8 else (large, small + off)
        return Claim(relation, *sides)


def r_depth(made: WithFunctions) -> int:
    """Mostly a name or a number alone."""
    return made.random.choice((0, 0, 0, 1))


#: Seeds of statements whose proofs were refused, or took minutes.
FOUND = (700866, 700921, 701197, 701302, 740189, 740718)


@pytest.mark.parametrize("seed", [*range(FIRST, FIRST + ROUNDS), *FOUND])
def test_a_random_statement_with_functions(seed: int) -> None:
    assert wrong(seed, WithFunctions)[0] == ""


def test_many_rows_with_functions_are_decided() -> None:
    decisions = [d for seed in range(60) for d in wrong(seed, WithFunctions)[1].decisions.values()]
    assert sum(decision.verdict in (PROVED, REFUTED) for decision in decisions) > 60
    assert "derivative" in {decision.method for decision in decisions}
