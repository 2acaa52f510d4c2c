"""Questions of SMT-LIB 2 about real numbers (QF_NRA): is there a solution of these assertions?

The row of a conjunction says that it has none: for all values that satisfy most of its parts, what
is left of it is false. So *proved* is ``unsat``, with a certificate, and *refuted* is ``sat``, with
the witness as a solution. A file with disjunctions has a row for each case, and no solution if all
are proved. Which parts are givens is chosen so that a point is found at which they hold.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, product
from os.path import basename
from sys import maxsize

from verify.language.statement import NEEDED, Context, Given, Obligation, Statement, Variable
from verify.language.terms import Claim, Term, as_term, maximum, substitute_claim, symbol
from verify.wire.inputs import InputError, shown
from verify.wire.text.lisp import RELATIONS, Formulas, Source, Tree, Word
from verify.wire.text.points import a_point

#: A file whose disjunctions have more cases than this is refused.
MAX_CASES = 64
#: Commands that say nothing about the numbers.
SILENT = (
    *("set-info", "set-option", "set-logic", "check-sat", "get-model", "exit", "get-unsat-core"),
    *("get-value", "get-info", "echo", "push", "pop", "get-assignment", "minimize", "maximize"),
)
Cases = list[list[Claim]]
#: How many parts formulas need, at least and at most.
PARTS = {"not": (1, 1), "let": (2, 2), "=>": (1, maxsize), "!": (1, maxsize)}


def read_smtlib(path: str, content: bytes) -> Statement:
    """The statement that the assertions of a file have no solution.

    Raises:
        InputError: for what is not about real numbers, naming the line.
    """
    file = _File(Source(path, content))
    with file.source.shallow():
        for tree in file.source.trees():
            file.command(tree)
        cases = _conjunctions(file, file.asserted)
        parts = [_part(path, file, number, case) for number, case in enumerate(cases, 1)]
    name = basename(path)
    return Statement(
        name,
        f"no real numbers satisfy the assertions of {name}",
        {},
        (),
        tuple(context for context, _ in parts),
        tuple(row for _, row in parts),
        (),
    )


class _File:
    """What the commands of a file have said so far."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.variables: dict[str, str] = {}  # by their names in the file
        self.formulas = Formulas(source, {})
        self.asserted: list[Cases] = []

    def command(self, tree: Tree) -> None:
        """Do what one command says."""
        if not isinstance(tree, list) or not tree or not isinstance(tree[0], Word):
            raise self.source.error(tree, "is no command; write (assert ...)")
        match tree:
            case ["declare-fun", Word() as name, [], sort] | [
                "declare-const",
                Word() as name,
                sort,
            ]:
                self._declare(name, sort)
            case ["define-fun", Word() as name, [], "Real", body]:
                self.formulas.names[name] = self.formulas.term(body)
            case ["define-fun", Word() as name, [], "Bool", body]:
                self.formulas.claims[name] = body, self.formulas.copy()
            case ["assert", body]:
                self.asserted.append(self.cases(body, self.formulas, holds=True))
            case [head, *_] if head in SILENT:
                pass
            case _:
                raise self.source.error(tree, f"the command {shown(str(tree[0]))} cannot be used")

    def _declare(self, name: Word, sort: Tree) -> None:
        if sort != "Real":
            raise self.source.error(name, f"{shown(name)} is of the sort {sort}; declare it Real")
        if name in self.variables:
            raise self.source.error(name, f"{shown(name)} is declared twice")
        plain = re.sub(r"[^A-Za-z0-9_]+", "_", name).strip("_")
        plain = plain if plain[:1].isalpha() and plain != "goal" else f"v_{plain}"
        while plain in self.variables.values():
            plain += "_"
        self.variables[name] = plain
        self.formulas.names[name] = symbol(plain)

    def cases(self, tree: Tree, formulas: Formulas, *, holds: bool) -> Cases:
        """Conjunctions of which one has to hold, so that a formula holds; or does not."""
        if isinstance(tree, Word):
            return self._named(tree, formulas, holds=holds)
        self._check_count(tree)
        head, *rest = tree
        if head == "not":
            return self.cases(rest[0], formulas, holds=not holds)
        if head == "=>":
            *before, last = rest
            flipped: list[Tree] = [[Word("not"), one] for one in before]
            return self.cases([Word("or"), *flipped, last], formulas, holds=holds)
        if head in ("let", "!"):
            return self._inside(tree, formulas, holds=holds)
        if head in ("and", "or"):
            parts = [self.cases(part, formulas, holds=holds) for part in rest]
            return _all(self, tree, parts) if (head == "and") == holds else [*chain(*parts)]
        if head == "distinct" and len(rest) == 2:
            return self.cases([Word("="), *rest], formulas, holds=not holds)
        if head in RELATIONS:
            claims = formulas.comparison(tree)
            return [claims] if holds else [[other] for one in claims for other in _negations(one)]
        raise self.source.error(tree, f"the formula {shown(str(head))} cannot be used")

    def _check_count(self, tree: list[Tree]) -> None:
        """Afterwards a formula has as many parts as its operation needs."""
        if not tree or not isinstance(tree[0], Word):
            raise self.source.error(tree, "an operation is missing after the parenthesis")
        head, count = tree[0], len(tree) - 1
        least, most = PARTS.get(head, (0, count))
        if not least <= count <= most:
            raise self.source.error(head, f"{shown(head)} of {count} parts is no formula")

    def _named(self, word: Word, formulas: Formulas, *, holds: bool) -> Cases:
        if word in ("true", "false"):
            return [[]] if (word == "true") == holds else []
        if word in formulas.claims:
            body, there = formulas.claims[word]
            return self.cases(body, there, holds=holds)
        raise self.source.error(word, f"{shown(word)} is no formula about real numbers")

    def _inside(self, tree: list[Tree], formulas: Formulas, *, holds: bool) -> Cases:
        """What stands in a ``let``, whose names are terms or formulas, or beside attributes."""
        if tree[0] == "!":
            return self.cases(tree[1], formulas, holds=holds)
        inner = formulas.copy()
        for name, body in self.source.pairs(tree[1]):
            if _is_formula(body, formulas):
                inner.claims[name] = body, formulas
            else:
                inner.names[name] = formulas.term(body)
        return self.cases(tree[2], inner, holds=holds)


def _is_formula(tree: Tree, formulas: Formulas) -> bool:
    if isinstance(tree, Word):
        return tree in formulas.claims or tree in ("true", "false")
    head = tree[0] if tree else None
    if head == "let" and len(tree) == 3:
        inner = formulas.copy()
        for name, body in formulas.source.pairs(tree[1]):
            if _is_formula(body, formulas):
                inner.claims[name] = body, formulas
        return _is_formula(tree[2], inner)
    return head in ("not", "and", "or", "=>", "distinct", *RELATIONS)


def _negations(claim: Claim) -> Iterator[Claim]:
    """The claims of which one holds where a claim does not."""
    if claim.relation == "=":
        yield Claim("<", claim.lhs, claim.rhs)
        yield Claim("<", claim.rhs, claim.lhs)
    else:
        yield Claim("<=" if claim.relation == "<" else "<", claim.rhs, claim.lhs)


def _all(file: _File, tree: Tree | None, parts: Sequence[Cases]) -> Cases:
    """The cases in which one case of each part holds."""
    count = 1
    for part in parts:
        count *= len(part)
    if count > MAX_CASES:
        raise file.source.error(tree, f"it has {count} cases; split it into several files")
    return [[claim for claims in choice for claim in claims] for choice in product(*parts)]


def _conjunctions(file: _File, asserted: Sequence[Cases]) -> Cases:
    found = _all(file, None, asserted) if asserted else []
    if not found or not all(found):
        what = "asserts nothing" if not asserted else "has a case without a comparison"
        raise InputError(f"{file.source.path}: {what}; write (assert (< x 1))")
    return found


def _part(path: str, file: _File, number: int, case: list[Claim]) -> tuple[Context, Obligation]:
    """A conjunction as a context, with the row that what is left of it is false there."""
    prefix = "" if number == 1 else f"case{number}."
    names = {old: symbol(f"{prefix}{plain}") for old, plain in file.variables.items()}
    claims = [_renamed(claim, file.variables, prefix) for claim in dict.fromkeys(case)]
    variables = [term.name for term in names.values()]
    givens, question, point = _answerable(path, claims, variables)
    context = Context(
        f"case{number}",
        tuple(Variable(v, *[v.rpartition(".")[2]] * 2) for v in variables),
        tuple(Given(f"{prefix}g{i}", claim) for i, claim in enumerate(givens, 1)),
        point,
    )
    says = "what is asserted besides is false"
    row = Obligation(f"unsat{number}", "", "", NEEDED, says, question, context=context.name)
    return context, row


def _answerable(
    path: str, claims: Sequence[Claim], variables: Sequence[str]
) -> tuple[list[Claim], Claim, dict[str, Term]]:
    """Givens, the claim that the rest is false, and a point of the givens: a solution if any is."""
    solution = a_point(variables, [Given("", claim) for claim in claims], {})
    for givens, question in _choices(claims):
        point = solution or a_point(variables, [Given("", claim) for claim in givens], {})
        if point is not None:
            return givens, question, point
    raise InputError(
        f"{path}: no point was found at which all but one of the assertions hold; write the "
        "question as a page of constants, with a point"
    )


def _renamed(claim: Claim, variables: Mapping[str, str], prefix: str) -> Claim:
    return substitute_claim(claim, {v: symbol(f"{prefix}{v}") for v in variables.values()})


def _choices(claims: Sequence[Claim]) -> Iterator[tuple[list[Claim], Claim]]:
    """Givens, and the claim that what is left cannot hold too; the last part is left first.

    Of parts that are left together all have to have negations of one kind.
    """
    for left in reversed(claims):
        yield [claim for claim in claims if claim is not left], _denied([left])
    closed = [claim for claim in claims if claim.relation != "<"]
    open_ones = [claim for claim in claims if claim.relation == "<"]
    for left_out, givens in ((closed, open_ones), (open_ones, closed)):
        if left_out:
            yield givens, _denied(left_out)


def _denied(claims: Sequence[Claim]) -> Claim:
    """The claim that not all of these hold; either all of them are strict, or none is."""
    gaps: list[Term] = []
    for claim in claims:
        gap = claim.lhs - claim.rhs
        gaps.append(gap**2 if claim.relation == "=" else gap)
    relation = "<=" if claims[0].relation == "<" else "<"
    if len(claims) == 1 and claims[0].relation != "=":
        return Claim(relation, claims[0].rhs, claims[0].lhs)
    return Claim(relation, as_term(0), gaps[0] if len(gaps) == 1 else maximum(*gaps))
