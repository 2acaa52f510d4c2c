"""Random claims over random definitions: prover, checker and an oracle at 2000 bits agree."""

from __future__ import annotations

import os
import random
from fractions import Fraction

import mpmath
import pytest

from verify import check
from verify.language.statement import NEEDED, PROVED, REFUTED, Constant, Obligation, Statement
from verify.language.terms import Claim, Term, as_term, cos_pi, maximum, minimum, sqrt, symbol
from verify.prover.ground import Ground
from verify.prover.outcome import Outcome
from verify.prover.session import Session
from verify.wire.read import read
from verify.wire.write import write

ROUNDS = int(os.environ.get("ORACLE_ROUNDS", "60"))
#: Seeds of claims whose certificates were once refused.
FOUND = (899, 51314)

CONTEXT = mpmath.MPContext()
CONTEXT.prec = 2000
#: Values that differ by less are taken to be equal, which random claims are only on purpose.
TINY = CONTEXT.mpf(2) ** -1500


def value(term: Term, names: dict[str, mpmath.mpf]) -> mpmath.mpf:  # noqa: C901
    """The value of a term with 2000 bits.

    Raises:
        ZeroDivisionError: or ValueError where it has none, or where that is open.
    """
    children = [value(child, names) for child in term.children]
    match term.op:
        case "rational":
            return CONTEXT.mpf(term.value.numerator) / term.value.denominator
        case "symbol":
            return names[term.name]
        case "pow":
            return children[0] ** term.exponent
        case "sqrt":
            if children[0] < TINY:
                raise ValueError
            return CONTEXT.sqrt(children[0])
        case "div":
            if abs(children[1]) < TINY:
                raise ZeroDivisionError
            return children[0] / children[1]
        case "cos_pi":
            return CONTEXT.cospi(children[0])
        case "min" | "max":
            return min(children) if term.op == "min" else max(children)
        case "neg":
            return -children[0]
        case "pi":
            return +CONTEXT.pi
        case "exp" | "log" | "sin" | "atan" | "root" | "cos":
            return function(term, children[0])
    a, b = children
    return {"add": a + b, "sub": a - b, "mul": a * b}[term.op]


def function(term: Term, x: mpmath.mpf) -> mpmath.mpf:
    """The value of a function, where it is known to have one of a size that can be written."""
    if term.op in ("log", "root") and x < TINY:
        raise ValueError
    if abs(x) > 10**6:
        raise OverflowError
    if term.op == "root":
        return CONTEXT.root(x, term.exponent)
    return getattr(CONTEXT, term.op)(x)


def holds(relation: str, a: mpmath.mpf, b: mpmath.mpf) -> bool:
    """The truth, if values that are very close are equal."""
    close = abs(a - b) <= TINY * max(abs(a), abs(b), 1)
    return close if relation == "=" else (relation == "<=" and close) or (a < b and not close)


class Generator:
    """Random terms over the names so far."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)
        self.names: list[str] = []

    def number(self) -> Term:
        r = self.random
        return as_term(
            Fraction(r.randrange(-9, 30), r.choice((1, 2, 3, 7, 10 ** r.randrange(1, 9))))
        )

    def term(self, depth: int) -> Term:
        r = self.random
        if depth == 0:
            return (
                symbol(r.choice(self.names)) if self.names and r.random() < 0.6 else self.number()
            )
        part = lambda: self.term(depth - 1)  # noqa: E731
        match r.randrange(9):
            case 0:
                return part() + part()
            case 1:
                return part() - part()
            case 2 | 3:
                return part() * part()
            case 4:
                return part() / part()
            case 5:
                return part() ** r.randrange(2, 4)
            case 6:
                return sqrt(part())
            case 7:
                return (minimum if r.random() < 0.7 else maximum)(part(), part(), part())
        return cos_pi(self.number()) if r.random() < 0.2 else -part()

    def claim(self, definitions: dict[str, Term]) -> Claim:
        """A claim; in half of the cases with sides that are equal, or equal but for a min."""
        r, relation = self.random, self.random.choice(("<", "<=", "=", "<="))
        lhs = self.term(2)
        kind = r.randrange(6)
        if kind == 0 and self.names:
            name = r.choice(self.names)
            term = definitions[name]
            entry = r.choice(term.children) if term.op in ("min", "max") else term
            outer = r.choice((lambda t: t, lambda t: 2 * t + lhs, lambda t: 1 / (1 + t**2), sqrt))
            sides = [outer(symbol(name)), outer(entry)]
            r.shuffle(sides)
            return Claim(relation, *sides)
        if kind == 1:
            a, b = self.term(1), self.term(1)
            return Claim(relation, (a + b) ** 2, a**2 + 2 * a * b + b**2)
        if kind == 2:
            return Claim(relation, lhs, lhs + as_term(Fraction(1, 10 ** r.randrange(1, 80))))
        return Claim(relation, lhs, self.term(2))


def decided(seed: int) -> tuple[Outcome, dict[str, bool]]:
    """A random statement, decided, and what is true of its rows."""
    generator = Generator(seed)
    session = Session()
    ground = Ground(session, max_bits=2048)
    constants, values, truth = [], {}, {}
    for i in range(6):
        term = generator.term(2)
        try:
            values[f"c{i}"] = value(term, values)
        except (ZeroDivisionError, ValueError):
            continue
        constant = Constant(f"c{i}", "", "", "", term)
        if not ground.define(constant):
            del values[f"c{i}"], ground.definitions[f"c{i}"]
            continue
        constants.append(constant)
        generator.names.append(f"c{i}")
    decisions, rows = {}, []
    for i in range(12):
        claim = generator.claim(ground.definitions)
        try:
            truth[f"row{i}"] = holds(
                claim.relation, value(claim.lhs, values), value(claim.rhs, values)
            )
        except (ZeroDivisionError, ValueError):
            continue
        row = Obligation(f"row{i}", "", "", NEEDED, "", claim)
        found = ground.decide(row)
        role = NEEDED if found.claimed == PROVED else "printed"
        rows.append(row._replace(role=role))
        decisions[row.name] = found
    enclosures = {c.name: ground.enclose(c.term) for c in constants}
    assert None not in enclosures.values()
    always = Obligation("always", "", "", NEEDED, "", as_term(0) < as_term(1))
    decisions["always"] = ground.decide(always)
    statement = Statement("random", f"seed {seed}", {}, tuple(constants), (), (*rows, always), ())
    return Outcome(statement, decisions, tuple(session.steps), enclosures), truth  # type: ignore[arg-type]


@pytest.mark.parametrize("seed", sorted({*range(ROUNDS), *FOUND}))
def test_agreement(seed: int) -> None:
    outcome, truth = decided(seed)
    for name, decision in outcome.decisions.items():
        if name in truth:
            wanted = PROVED if truth[name] else REFUTED
            assert decision.claimed in (wanted, "undecided"), (name, outcome.statement.title)
    files = write(outcome)
    report = check.check(files["statement.json"], files["certificate.json"], {})
    assert report.verdict == "PROVED", [line for line in report.lines if "REFUSED" in line]
    assert read(files["statement.json"], files["certificate.json"], {}) == outcome.draft


def test_most_claims_are_decided() -> None:
    decisions = [d for seed in range(60) for d in decided(seed)[0].decisions.values()]
    verdicts = [decision.claimed for decision in decisions]
    assert {PROVED, REFUTED} <= set(verdicts)
    assert verdicts.count("undecided") <= len(verdicts) // 5
    assert {"interval", "sum"} <= {decision.method for decision in decisions}
