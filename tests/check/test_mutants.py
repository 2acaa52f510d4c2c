"""The checker broken on purpose, a line at a time: each time a lie passes, or the truth does not.

A mutant is killed by a lie of ``tests/lies`` that it answers with another code, or by one of the
pairs here, which the checker answers as it must.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from types import ModuleType

import pytest

from tests.check.support import (
    IDENTITY,
    INTERVAL,
    ROOT,
    Pair,
    box,
    cases,
    cuts,
    entry,
    instance,
    interval,
    total,
    witness,
)  # fmt: skip
from tests.lies.lies import LIES, honest
from verify import check

SOURCE = Path(check.__file__).read_text()

MUTANTS = [
    # contexts, names, facts
    ("other.depth <= self.depth and self.around", "True and self.around"),
    ("self.around[other.depth] is other", "True"),
    ('need(good, Malformed, "found names of {} and {} in a term", home.name, other.name)', "pass"),
    ('need(name not in self.taken, Malformed, "found the name {} twice", name)', "pass"),
    ('so far", name)\n        claim, context = self.facts[name]',
     'so far", name)\n        claim, _ = self.facts[name]\n        context = place.context'),
    ("need(place.context.is_inside(context), Malformed, message, name, context.name)", "pass"),
    ("any(term in context.positive for context in around)", "True"),
    ("any(term in context.positive for context in around)",
     "any(term in context.nonnegative for context in around)"),
    ("any(term in context.nonnegative for context in around)", "True"),
    ('tables = {"<": [context.positive], "<=": [context.nonnegative]}',
     'tables = {"<": [context.positive], "<=": [context.positive]}'),
    ("if zero and claim.relation == relation and claim.rhs == term:",
     "if zero and claim.rhs == term:"),
    ("return term in at or self.homes[term] is not context", "return term in at"),
    ("need(good, Malformed, message, where, self.homes[term].name)", "pass"),
    # rules
    ("need(HOLDS[claim.relation](x, y), Refused, message, x, y, claim.relation)", "pass"),
    ('"<": lambda x, y: x.high < y.low', '"<": lambda x, y: x.high <= y.low'),
    ('"<=": lambda x, y: x.high <= y.low', '"<=": lambda x, y: x.low <= y.high'),
    ('"=": lambda x, y: x.low == x.high == y.low == y.high', '"=": lambda x, y: x == y'),
    ('"!=": lambda x, y: x.high < y.low or y.high < x.low', '"!=": lambda x, y: x != y'),
    ('NEGATION = {"<": "<="', 'NEGATION = {"<": "<"'),
    ('"<=": "<", "=": "!="}', '"<=": "<=", "=": "!="}'),
    ('        Clearing(self, place, ()).clear(term)\n        points', "        points"),
    ('need(good, Refused, "found cuts {} that do not increase", proof["at"])', "pass"),
    ("all(a < b for a, b in pairwise(points))", "all(a <= b for a, b in pairwise(points))"),
    ('hypotheses = [] if low is None else [Claim("<=", low, term)]',
     'hypotheses = [] if low is None else [Claim("<=", term, low)]'),
    ('need(op in ("min", "max"), Refused, "of: found {}, expected min or max", op)', "pass"),
    ('sides = (entry, other) if op == "min" else (other, entry)', "sides = (entry, other)"),
    ('sides = (entry, other) if op == "min" else (other, entry)', "sides = (other, entry)"),
    ('need(claim.relation == "<=", Refused, "found {}, expected <=", claim.relation)', "pass"),
    ('need(found < len(entries), Refused, "found a side that is no entry of the {}", op)', "pass"),
    ("clearing.clear(term), clearing.clear(other)", "pass"),
    ('good = equation.relation == "=" and equation.lhs == term', "good = True"),
    ('need(op == wanted, Refused, "found {} on the {}, expected {}", op, proof["side"], wanted)',
     "pass"),
    ('need(zero and claim.relation == "<" and op == "sqrt", Refused, "expected 0 < a root")',
     'need(zero and op == "sqrt", Refused, "expected 0 < a root")'),
    ('known = self.knows("<", radicands[0], place)',
     'known = self.knows("<=", radicands[0], place)'),
    ('clearing.goal = goal, claim.relation == "<="', "clearing.goal = goal, True"),
    ('need(strict, Refused, "found no addend that is positive")', "pass"),
    ('need(not rest, Refused, "found a sum that is not 0, but {}", clearing.told(rest))', "pass"),
    ('need(not rest, Refused, "found sides that differ, by {}", clearing.told(rest))', "pass"),
    ('need(relation == "=", Refused, "found {}, which is no equation", name)', "pass"),
    ('need(same, Refused, "found another claim than {} at these values", name)', "pass"),
    ('need(good, Refused, "found a place outside the parent of {}", context.name)', "pass"),
    ("clearing = Clearing(self, place, ())\n        for term in at.values():",
     "clearing = Clearing(self, place, ())\n        for term in ():"),
    ('need(same, Refused, "found {}, which is another claim than is needed", premise)', "pass"),
    ('need(not plain, Refused, "found givens that are neither carried nor standing: {}", plain)',
     "pass"),
    ('need(context.parent is place.context, Refused, "found {} elsewhere", context.name)', "pass"),
    ("clearing.clear(term)\n            for given, premise in self.paired(carried",
     "pass\n            for given, premise in self.paired(carried"),
    ('("next", claim.next, inside)', '("next", claim.start, inside)'),
    ("self.prove(outside, negated(self.substitute(claim, context, at)), proof[\"negation\"])",
     "self.prove(outside, self.substitute(claim, context, at), proof[\"negation\"])"),
    ('inside.clear(given.claim.lhs), inside.clear(given.claim.rhs)', "pass"),
    ("for term in context.point.values():\n            clearing.clear(term)", "pass"),
    ("self.premise(outside, self.substitute(given.claim, context, context.point), premise)",
     "pass"),
    ("need(found[0] <= found[1]", "need(True"),
    ('need(good, Refused, "found bounds of {}, whose value is known", name)', "pass"),
    ("other = {claim.lhs: claim.rhs} if side == 1 else",
     "other = {claim.rhs: claim.lhs} if side == 1 else"),
    ('good = len(proofs) == len(expected)', "good = len(proofs) <= len(expected)"),
    # polynomials
    ("value = before + factor * coefficient", "value = before + coefficient"),
    ("total[monomial] = before + c * d", "total[monomial] = c * d"),
    ('need(good, Refused, "found a constant before its definition is proved to have a value")',
     "pass"),
    ('need(known, Refused, "found the root of a term that is not known to be >= 0")', "pass"),
    ('need(known, Refused, "found a division by a term that is not known to be > 0 or < 0")',
     "pass"),
    ('known = op == "rational" and rest[0] >= 0', 'known = op == "rational"'),
    ('if node.op == "rational" and node.rest[0]:', 'if node.op == "rational":'),
    ("parts = [self.clear(part) for part in node.subterms]",
     'parts = [self.clear(part) for part in node.subterms if node.op == "sqrt"]'),
    ('return (self.kernel.times(n, n) if kind == "square" else n), False',
     'return (self.kernel.times(n, n) if kind == "square" else n), True'),
    ('return (self.kernel.times(n, n) if kind == "square" else n), False', "return n, False"),
    ('need(root, Refused, "root: found another term")', "pass"),
    ('return total, any(flags) if kind == "add" else all(flags)', "return total, any(flags)"),
    ('need(number >= 0, Refused, "found {}, expected a number >= 0", name)', "pass"),
    ("return {(): number} if number else {}, number > 0",
     "return {(): number} if number else {}, True"),
    ('need(relation in ("<", "<="), Refused, "found {}, which is no inequality", name)', "pass"),
    ('return self.difference(rhs, lhs), relation == "<"',
     "return self.difference(rhs, lhs), True"),
    ('return self.difference(rhs, lhs), relation == "<"',
     'return self.difference(lhs, rhs), relation == "<"'),
    ("n, m = kernel.plus({}, n, sign), kernel.plus({}, m, sign)", "m = kernel.plus({}, m, sign)"),
    ('good = relation == "=" and kernel.nodes[atom].op in ATOMS',
     "good = kernel.nodes[atom].op in ATOMS"),
    ('good = equation.relation == "=" and equation.lhs == term', "good = equation.lhs == term"),
    ("if zero and claim.relation == relation and claim.rhs == term:",
     "if claim.relation == relation and claim.rhs == term:"),
    ("if zero and claim.relation == relation and claim.rhs == term:",
     "if zero and claim.relation == relation:"),
    ('opposite = kernel.index.get(key(Node("neg", (divisor,))), -1)',
     'opposite = kernel.index.get(key(Node("neg", (divisor,))), 1)'),
    # enclosures
    ("return Interval(self.shorter(x.low), -self.shorter(-x.high))",
     "return Interval(-self.shorter(-x.low), self.shorter(x.high))"),
    ("return Interval(x.low - y.high, x.high - y.low)",
     "return Interval(x.low - y.low, x.high - y.high)"),
    ('need(y.low > 0 or y.high < 0, Refused, "found a division by {}, which contains 0", y)',
     'need(y.low >= 0 or y.high < 0, Refused, "found a division by {}, which contains 0", y)'),
    ('need(x.low >= 0, Refused, "found a square root of {}, which reaches below 0", x)',
     'need(x.high >= 0, Refused, "found a square root of {}, which reaches below 0", x)'),
    ("if n % 2 == 0 and low < 0:", "if False:"),
    ("return Interval(min(x.low for x in xs), min(x.high for x in xs))",
     "return Interval(min(x.low for x in xs), max(x.low for x in xs))"),
    ('need(op != "name", Refused, "found a variable without bounds")',
     'if op == "name":\n                self.known[part] = UNIT\n                continue'),
    # statements and the report
    ('need(found == digest, Malformed, "statement_sha256: found {}, expected {}", found, digest)',
     "pass"),
    ('need(needed, Malformed, "obligations: found no needed row, which proves nothing")', "pass"),
    ('need(not left, Malformed, "steps: found none for {}", left)', "pass"),
    ('need(context.is_open, Malformed, "found {}, which is not open so far", context.name)',
     "pass"),
    ('need(item not in self.done, Malformed, "found a second step")', "pass"),
    ('need(row.verdict != "undecided", Malformed, "found a proof of an undecided row")', "pass"),
    ('if row.role == "needed" and row.verdict == "undecided":', "if False:"),
    ('need(given.low <= given.high, Malformed, "{}: found ends in no order: {}", name, given)',
     "pass"),
    ("good = given.low <= inner.low and inner.high <= given.high",
     "good = given.low <= inner.high and inner.low <= given.high"),
    ("good = given.low <= inner.low and inner.high <= given.high",
     "good = given.low <= inner.low"),
    ("need(not odd, Malformed, message, key, odd)", "pass"),
    ("need(known, Malformed, message, given[\"name\"], given[\"assumption\"], given[\"kind\"])",
     "pass"),
    ('good = isinstance(claim, Claim) or item["verdict"] == "proved"', "good = True"),
    ('need(len(data) <= MAX_BYTES', "need(True"),
    ('need(not level, Malformed', "need(True"),
    ('need(len({*keys}) == len(keys)', "need(True"),
    ('"REFUSED": 1', '"REFUSED": 0'),
    ('"REFUTED": 1', '"REFUTED": 0'),
]  # fmt: skip


def more() -> Iterator[Pair]:
    """Pairs that tell some mutants from the checker, true ones and lies."""
    yield honest()
    yield Pair().row("row", "1/3 <= 1/3 - 0*sqrt(2)", IDENTITY).row("next", "2 = 2", INTERVAL)
    pair = box(("-1", "1")).row("row", "0 < sqrt(x)", cuts("x", ["0"], ROOT, ROOT), "box")
    yield pair
    bounds = interval(("x", "x-low", "x-high"))
    yield box(("-2", "1")).row("row", "1 <= x**2", bounds, "box")
    yield box(("-1", "1")).row("row", "x - x <= 0", bounds, "box")
    yield box(("-1", "1")).row("row", "0 <= sqrt(x)", bounds, "box")
    yield box(("-1", "1")).row("row", "min(x, 2) <= 1/2", bounds, "box")
    yield box(("-1", "1")).row("row", "x <= 0", cuts("x", ["0"], *[total("goal", "@1")] * 2), "box")
    for claim in ("sqrt(2) <= sqrt(2)", "sqrt(2)**2 <= 2", "2 <= sqrt(2)**2", "sqrt(2) = sqrt(2)"):
        yield Pair().row("row", claim, INTERVAL)
    lie = Pair().row("row", "sqrt(4) = 2", INTERVAL, None, "refuted", "printed")
    yield lie.row("next", "0 <= 1", INTERVAL)
    free = box(("0", "1")).context("free", {"v": "0"}, {})
    free.lemma("same", "v = v", IDENTITY, "free")
    undefined = "1/(x - x)"
    same = instance("same", {"v": undefined})
    yield free.row("row", f"{undefined} = {undefined}", same, "box")
    yield Pair().context("c", {"x": "1/(1 - 1)"}, {}).row("row", "0 <= 1", INTERVAL)
    yield box(("0", "1")).row("row", "x*sqrt(-1) = x*sqrt(-1)", IDENTITY, "box")
    two = Pair().context("c", {"x": "1"}, {"p": "0 < x"}).context("d", {"y": "x"}, {}, [], "c")
    two.row("row", "y/x = y*(1/x)", IDENTITY, "d").row("wrong", "x/y = x/y", IDENTITY, "c")
    yield two
    yield (
        box(("0", "1"))
        .define("n", "max(x, 2)", context="box")
        .row("row", "x <= 1", entry("rhs", "n"), "box")
    )
    falls = Pair().context("c", {"x": "-1"}, {"n": "0 < -x", "m": "-2 <= x"})
    falls.row("row", "1/x < 0", total("goal", "1"), "c")
    yield falls
    below = Pair().context("c", {"x": "1"}, {"p": "0 < x"}).lemma("f", "0 < x*x", POSITIVE, "c")
    below.context("d", {"y": "1"}, {}, [])
    yield below.row("row", "0 < y*y", instance("f", {"x": "y"}, "p"), "d")
    inner = box(("0", "1")).context("in", {"y": "x"}, {"low": "x <= y"}, [total("goal")], "box")
    inner.lemma("fact", "0 <= y", total("goal", "x-low", "low"), "in")
    yield inner.row("row", "0 <= 1", instance("fact", {"y": "1"}, INTERVAL))
    state = Pair().context("s", {"x": "1"}, {})
    claim = ["always", "s", {"x": "1"}, {"x": ["div", "1", "x"]}]
    yield state.row("row", claim, {"rule": "induction", "start": [], "next": []})
    out = box(("0", "1")).row("needed", "0 <= 1", INTERVAL)
    proof = witness({"x": "1"}, [INTERVAL, INTERVAL], INTERVAL)
    yield out.row("row", "x <= 1", proof, "box", "refuted", "printed")
    elsewhere = box(("0", "1")).context("s", {"x2": "1"}, {})
    claim = ["always", "s", {"x2": "x"}, {"x2": "x2"}]
    induction = {"rule": "induction", "start": [], "next": []}
    yield elsewhere.row("row", claim, induction, "box")
    yield (
        Pair()
        .constant("a", "1")
        .row("row", "0 <= 1", INTERVAL)
        .lemma("l", "a <= 1", interval(("a", "a", "a")))
    )


def proofs() -> Iterator[Pair]:
    """Proofs of what is false, or true, which one check each tells apart."""
    bounds = interval(("x", "x-low", "x-high"))
    beside = Pair().context("a", {"x": "1"}, {}).context("b", {"y": "1"}, {})
    yield beside.row("row", "y + (x - x) = y", IDENTITY, "b")
    yield box(("1/2", "1")).row("row", "0 < sqrt(x)", cuts("x", ["0"], bounds, ROOT), "box")
    unfolded = Pair().constant("k", "1").context("c", {"x": "1"}, {})
    unfolded.lemma("f", "x <= x + k", total("goal", "1", using=["k"]), "c")
    yield unfolded.row("row", "2 <= 2 + k", instance("f", {"x": "2"}))
    for claim in ("sqrt(2)*sqrt(2) = 2", "1 < 1", "1 <= 1"):
        pair = Pair().row("next", "0 <= 1", INTERVAL)
        yield pair.row("row", claim, INTERVAL, None, "refuted", "printed")
    for of, at in (("1/x", ["0"]), ("x", ["1/2", "1/2"]), ("x", ["1/2", "1/3"])):
        yield box(("0", "1")).row("row", "x <= 1", cuts(of, at, *[bounds] * (len(at) + 1)), "box")
    wrong = total("goal", equations=[("@1", "-1")])
    yield Pair().row("row", "1 <= 0", cases("1 + 1", wrong, wrong))
    greater = cases("max(x, 2)", total("goal", using=["@1"]), total("goal", "@2", using=["@1"]))
    yield box(("0", "1")).row("row", "max(x, 2) <= x", greater, "box")
    less = cases("min(x, 2)", total("goal", "@2", using=["@1"]), total("goal", using=["@1"]))
    yield box(("0", "3")).row("row", "2 <= min(x, 2)", less, "box")
    positive = Pair().context("c", {"x": "1"}, {"p": "0 < x"})
    yield positive.row("row", "0 <= sqrt(x)", ROOT, "c")
    unit = [
        ("1 <= x", total("goal", equations=[("x-high", "1")])),
        ("(x + 1)*(x + 1) = x*x + 2*x + 1", IDENTITY),
        ("0 < x*x", total("goal", ["square", "x"])),
        ("0 < x", total("goal", ["mul", "1", "x-low"])),
        ("0 < x", total("goal", "x-low")),
        ("x <= 1", cuts("x", ["3"], bounds, interval(("x", "@1", "x-high")))),
    ]
    for claim, proof in unit:
        yield box(("0", "1")).row("row", claim, proof, "box")
    for addend in (["square", "x"], ["root", "x"]):
        yield box(("-1", "1")).row("row", "0 <= x", total("goal", addend), "box")
    for claim, proof in [
        ("1 <= 0", total("goal", "-1")),
        ("0 < 0", total("goal", "0")),
        ("sqrt(-1) = sqrt(-1)", IDENTITY),
        (["=", ["div", "1", "0"], ["div", "1", "0"]], IDENTITY),
    ]:
        yield Pair().row("row", claim, proof)
    equal = Pair().context("c", {"x": "1", "y": "1"}, {"is": "x = y"})
    yield equal.row("row", "x <= y", total("goal", "is"), "c")


def steps() -> Iterator[Pair]:
    """Steps in a wrong order, or at a wrong place."""
    nested = box(("0", "1")).context("in", {"y": "1"}, {"low": "0 <= y"}, None, "box")
    nested.lemma("f", "0 <= y", total("goal", "low"), "in")
    yield nested.row("row", "0 <= 1", instance("f", {"y": "1"}, INTERVAL))
    other = Pair().context("c", {"x": "1"}, {"p": "0 < x"}).lemma("f", "0 < x*x", POSITIVE, "c")
    other.context("d", {"y": "1"}, {"n": "-5 <= y"})
    yield other.row("row", "0 < y*y", instance("f", {"x": "y"}, "n"), "d")
    early = Pair().constant("a", "sqrt(2)", INTERVAL).row("row", "a = a", IDENTITY)
    early.steps.reverse()
    yield early
    unopened = Pair().context("c", {"x": "1"}, {}).row("row", "x = x", IDENTITY, "c")
    unopened.steps.reverse()
    yield unopened
    yield Pair().row("row", "2 < 1", INTERVAL, verdict="refuted")
    applies = box(("0", "1")).row("next", "0 <= 1", INTERVAL)
    proof = {"rule": "instance", "givens": [INTERVAL, INTERVAL]}
    yield applies.row("row", ["applies", "box", {"x": "1/2"}], proof, None, "refuted", "printed")


POSITIVE = total("goal", ["mul", "p", "p"])
Files = tuple[bytes, bytes]


@cache
def corpus() -> list[tuple[Files, int]]:
    """Files with the checker's codes: the shorter ones first."""
    files = [pair.files() for pair in (*more(), *proofs(), *steps())]
    files += sorted((lie.files() for lie in LIES.values()), key=lambda pair: len(b"".join(pair)))
    return [(pair, code(check, pair)) for pair in files]


def code(checker: ModuleType, files: Files) -> int:
    """The exit code; -1 for a traceback."""
    try:
        return checker.check_folders([checker.Folder("", *files, [])])[0]
    except Exception:
        return -1


def mutated(old: str, new: str) -> ModuleType:
    """The checker with one change."""
    assert SOURCE.count(old) == 1, (SOURCE.count(old), old)
    module = ModuleType("mutant")
    sys.modules["mutant"] = module
    exec(compile(SOURCE.replace(old, new), "mutant", "exec"), module.__dict__)
    return module


def test_enough_mutants() -> None:
    assert len({(old, new) for old, new in MUTANTS}) == len(MUTANTS) >= 90


@pytest.mark.parametrize("i", range(len(MUTANTS)))
def test_each_mutant_is_killed(i: int) -> None:
    mutant = mutated(*MUTANTS[i])
    assert any(code(mutant, files) != expected for files, expected in corpus()), MUTANTS[i]
