"""Questions of SMT-LIB 2 about real numbers (QF_NRA): is there a solution of these assertions?

Each `(check-sat)` asks whether what is asserted by then has a solution. The rows of a question say
that it has none, one for each of its cases. So *proved* is ``unsat``, with a certificate, and
*refuted* is ``sat``, with the witness as a solution. A file without `(check-sat)` asks once, at its
end. What a file says is done or refused: the commands that are passed over ask for something to be
printed, and change no answer.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain

from verify.language.record import Record
from verify.language.statement import Statement, Variable
from verify.language.terms import Claim, as_term, names_of, substitute_claim, symbol
from verify.wire.inputs import InputError, file_name, shown
from verify.wire.text import Page
from verify.wire.text.conjunctions import Asked, Order, TooManyCasesError, cases, forms
from verify.wire.text.formulas import (
    BOOL,
    MAX_CASES,
    REAL,
    SMTLIB,
    Formula,
    Function,
    Reader,
    Value,
    real,
)
from verify.wire.text.lisp import SMTLIB as WORDS
from verify.wire.text.lisp import Names, Source, Tree, Word
from verify.wire.text.points import Points

#: A file has at most so many rows, and scopes inside of one another.
MAX_ROWS, MAX_LEVELS = 256, 1000
#: So many assertions its questions have together, each with those of the scopes around it.
MAX_ASSERTED = 20_000
#: Commands that change no answer.
SILENT = (
    *("set-info", "get-info", "get-option", "get-model", "get-value", "get-assignment"),
    *("get-assertions", "get-proof", "get-unsat-core", "get-unsat-assumptions", "echo"),
)
#: Options that change no answer, whatever their values are.
OPTIONS = (
    *(":produce-models", ":produce-proofs", ":produce-unsat-cores", ":produce-assignments"),
    *(":produce-unsat-assumptions", ":produce-assertions", ":interactive-mode", ":print-success"),
    *(":random-seed", ":verbosity", ":reproducible-resource-limit", ":regular-output-channel"),
    *(":diagnostic-output-channel", ":incremental", ":precision", ":timeout"),
)
#: Logics with real numbers; what they have beside them is refused where it stands.
LOGICS = (
    *("QF_NRA", "QF_LRA", "QF_RDL", "QF_NRAT", "QF_UFNRA", "QF_UFLRA", "QF_NIRA", "QF_LIRA"),
    *("NRA", "LRA", "NRAT", "UFNRA", "UFLRA", "NIRA", "LIRA", "ALL"),
)
#: What is said of rows that have nothing to prove, and of those that nothing proves.
CONTRADICTORY = "what is asserted contradicts itself, as it is written"
NOTHING = "nothing is asserted, and this is false"
FALSE = as_term(0) < 0


def read_smtlib(path: str, content: bytes, seconds: float | None = None) -> Page:
    """The statement that no question of a file has a solution, and other forms of its rows.

    Raises:
        InputError: for what is not about real numbers, naming the line.
    """
    file = _File(Source(path, content, WORDS))
    with file.source.shallow():
        file.read()
        points, asked = Points(seconds), file.rows()
        parts = {one.row: forms(one, claims, file.order, points) for one, claims in asked}
        first = [next(found) for found in parts.values()]
    name = file_name(path)
    title = f"no real numbers satisfy the assertions of {name}"
    if len(file.questions) > 1:
        title = f"at no (check-sat) of {name} do real numbers satisfy the assertions"
    contexts = tuple(context for context, _ in first if context is not None)
    rows = tuple(row for _, row in first)
    return Page(Statement(name, title, {}, (), contexts, rows, ()), {}, parts)


class _Level:
    """What was declared and asserted since a ``(push)``."""

    def __init__(self) -> None:
        self.names: list[str] = []
        self.asserted: list[Formula] = []


class _Question(Record):
    """What is asserted at a line with ``(check-sat)``; at no line, at the end of a file."""

    line: int
    asserted: tuple[Formula, ...]


class _File:
    """What the commands of a file have said so far."""

    def __init__(self, source: Source) -> None:
        self.source, self.names, self.order = source, Names(), Order()
        self.questions: list[_Question] = []
        self._begin()

    def _begin(self) -> None:
        self.reader = Reader(self.source, SMTLIB)
        self.levels = [_Level()]

    def read(self) -> None:
        """Do what the commands say, in their order, up to ``(exit)``."""
        commands: Mapping[str, Callable[[Tree], None]] = {
            "assert": self._assert,
            "check-sat": self._ask,
            "check-sat-assuming": self._ask_assuming,
            "push": self._push,
            "pop": self._pop,
            "reset": self._reset,
            "reset-assertions": self._reset,
            "set-logic": self._set_logic,
            "set-option": self._set_option,
            **dict.fromkeys(("declare-const", "declare-fun"), self._declare),
            **dict.fromkeys(("define-const", "define-fun"), self._define),
            **dict.fromkeys(SILENT, lambda _: None),
        }
        for tree in self.source.trees():
            if not isinstance(tree, list) or not tree or not isinstance(tree[0], Word):
                raise self.source.error(tree, "is no command; write (assert ...)")
            head = tree[0]
            if head.quoted or head not in (*commands, "exit"):
                raise self.source.error(tree, f"the command {shown(head)} cannot be used")
            if head == "exit":
                if len(tree) > 1:
                    raise self._no(tree, "(exit)")
                break
            commands[head](tree)
        if not self.questions:
            self._keep(0)

    def _no(self, tree: Tree, instead: str) -> InputError:
        return self.source.error(tree, f"this {tree[0]} cannot be used; write {instead}")

    # --- names -----------------------------------------------------------------------------------

    def _new(self, name: Word, value: Value | Function) -> None:
        """Let a name of the file stand for a value, until its scope is left."""
        if not name.is_symbol or name in SMTLIB.words:
            raise self.source.error(name, f"{shown(name)} cannot be a name; choose another one")
        if name in self.reader.globals.own:
            raise self.source.error(name, f"{shown(name)} is declared twice; choose another name")
        if name in self.reader.meant:
            what = f"{shown(name)} stands for a function or number above; choose another name"
            raise self.source.error(name, what)
        self.reader.globals.own[name] = value
        self.levels[-1].names.append(name)

    def _declare(self, tree: Tree) -> None:
        match tree:
            case ["declare-const", Word() as name, sort] | [
                "declare-fun",
                Word() as name,
                [],
                sort,
            ]:
                pass
            case ["declare-fun", Word() as name, [_, *_], _]:
                raise self.source.error(
                    name, f"the function {shown(name)} has arguments; use its values as constants"
                )
            case _:
                raise self._no(tree, "(declare-const x Real)")
        if _is(sort, BOOL):
            self._new(name, Formula(f"{BOOL} {name}"))
            return
        if not _is(sort, REAL):
            said = sort if isinstance(sort, Word) else "another"
            raise self.source.error(name, f"{shown(name)} is of the sort {said}; declare it Real")
        self._new(name, real(symbol(self.names[name])))

    def _define(self, tree: Tree) -> None:
        match tree:
            case ["define-const", Word() as name, sort, body]:
                parameters: list[Tree] = []
            case ["define-fun", Word() as name, [*parameters], sort, body]:
                pass
            case _:
                raise self._no(tree, "(define-fun f ((x Real)) Real (* x x))")
        values = self._sort(name, sort)
        if not parameters:
            self._new(name, self.reader.of_sort(values, body, self.reader.globals))
            return
        known = dict(self._parameter(name, item) for item in parameters)
        if len(known) < len(parameters):
            raise self.source.error(name, f"{shown(name)} has two parameters of one name")
        function = Function(known, values, body)
        # Whatever is wrong with the body is said here, whether the function is called or not.
        wrong: dict[str, Value] = {
            BOOL: Formula("claim", (), as_term(0) < 0),
            REAL: real(symbol(" ")),
        }
        self.reader.called(function, tuple(wrong[sort] for _, sort in function.parameters))
        self._new(name, function)

    def _parameter(self, function: Word, item: Tree) -> tuple[str, str]:
        match item:
            case [Word() as name, sort] if name.is_symbol and name not in SMTLIB.words:
                return name, self._sort(name, sort)
        raise self.source.error(function, "a parameter is a name with a sort; write (x Real)")

    def _sort(self, name: Word, sort: Tree) -> str:
        if not (_is(sort, REAL) or _is(sort, BOOL)):
            said = sort if isinstance(sort, Word) else "another"
            raise self.source.error(
                name, f"{shown(name)} is of the sort {said}; write Real or Bool"
            )
        return str(sort)

    # --- assertions ------------------------------------------------------------------------------

    def _assert(self, tree: Tree) -> None:
        match tree:
            case [
                "assert",
                [Word("!", quoted=False), body, Word(":named", quoted=False), Word() as name],
            ]:
                found = self.reader.formula(body, self.reader.globals)
                self._new(name, found)
            case ["assert", body]:
                found = self.reader.formula(body, self.reader.globals)
            case _:
                raise self._no(tree, "(assert (< x 1))")
        self.levels[-1].asserted.append(found)

    def _ask(self, tree: Tree) -> None:
        match tree:
            case [Word() as head]:
                self._keep(head.line)
            case _:
                raise self._no(tree, "(check-sat)")

    def _ask_assuming(self, tree: Tree) -> None:
        match tree:
            case [Word() as head, [*literals]]:
                found = [self.reader.formula(one, self.reader.globals) for one in literals]
                self._keep(head.line, found)
            case _:
                raise self._no(tree, "(check-sat-assuming (p (not q)))")

    def _keep(self, line: int, assumed: Sequence[Formula] = ()) -> None:
        asserted = (*chain.from_iterable(level.asserted for level in self.levels), *assumed)
        self.questions.append(_Question(line, asserted))
        if len(self.questions) > MAX_ROWS:
            raise self.source.error(line, f"it asks more than {MAX_ROWS} questions; split the file")
        if sum(len(question.asserted) for question in self.questions) > MAX_ASSERTED:
            what = f"the questions have more than {MAX_ASSERTED} assertions together"
            raise self.source.error(line, f"{what}; split the file")

    def _push(self, tree: Tree) -> None:
        count = self._count(tree)
        if len(self.levels) + count > MAX_LEVELS:
            raise self.source.error(tree, f"more than {MAX_LEVELS} scopes are open; split the file")
        self.levels += [_Level() for _ in range(count)]

    def _pop(self, tree: Tree) -> None:
        count = self._count(tree)
        if count >= len(self.levels):
            raise self.source.error(tree, f"{count} scopes are closed, {len(self.levels) - 1} open")
        for _ in range(count):
            for name in self.levels.pop().names:
                del self.reader.globals.own[name]

    def _count(self, tree: Tree) -> int:
        match tree:
            case [_]:
                return 1
            case [_, Word(quoted=False) as number] if re.fullmatch("0|[1-9][0-9]{0,5}", number):
                return int(number)
        raise self._no(tree, "(push 1) or (pop 1)")

    def _reset(self, tree: Tree) -> None:
        """Take all assertions back, and all declarations with them."""
        if len(tree) > 1:
            raise self._no(tree, f"({tree[0]})")
        self._begin()

    # --- what changes no answer ------------------------------------------------------------------

    def _set_logic(self, tree: Tree) -> None:
        match tree:
            case [_, Word() as logic] if logic in LOGICS:
                return
        raise self._no(tree, f"(set-logic QF_NRA), or one of {', '.join(LOGICS[1:])}")

    def _set_option(self, tree: Tree) -> None:
        match tree:
            case [_, Word() as option, *_] if option in OPTIONS:
                return
            case [_, ":global-declarations", "false"]:
                return
            case [_, Word() as option, *_]:
                what = f"the option {shown(option)} is not known; leave it out if no answer"
                raise self.source.error(option, f"{what} depends on it")
        raise self._no(tree, "(set-option :produce-models true)")

    # --- rows ------------------------------------------------------------------------------------

    def rows(self) -> Iterator[tuple[Asked, list[Claim]]]:
        """The rows of all questions, each with the claims of its case."""
        count = 0
        for number, question in enumerate(self.questions, 1):
            found = self._cases(question)
            for case, claims in enumerate(found, 1):
                of = f"{number}.case-{case}" if len(found) > 1 else str(number)
                count += 1
                yield self._row(of, question, claims, is_first=count == 1)
            if count > MAX_ROWS:
                raise self.source.error(
                    question.line, f"the file has more than {MAX_ROWS} cases; split it"
                )
            if not found:
                yield Asked(f"asserted-{number}", f"check-{number}", CONTRADICTORY, ()), [FALSE]

    def _cases(self, question: _Question) -> list[list[Claim]]:
        try:
            return cases(question.asserted, self.order)
        except TooManyCasesError as error:
            what = f"what is asserted has more than {MAX_CASES} cases; split it into several files"
            raise self.source.error(question.line, what) from error

    def _row(
        self, of: str, question: _Question, claims: list[Claim], *, is_first: bool
    ) -> tuple[Asked, list[Claim]]:
        context = f"asserted-{of}"
        used = {*names_of(*(side for claim in claims for side in (claim.lhs, claim.rhs)))}
        # A name of the file that is read by now stands for one variable of the statement.
        olds = [old for old in self.names if self.names[old] in used]
        new = {
            self.names[old]: self.names[old] if is_first else f"{context}.{self.names[old]}"
            for old in olds
        }
        variables = tuple(Variable(new[self.names[o]], *[self.names.letter(o)] * 2) for o in olds)
        symbols = {name: symbol(other) for name, other in new.items()}
        where = f" at the (check-sat) in line {question.line}" if len(self.questions) > 1 else ""
        says = f"what is asserted besides{where} is false" if claims else NOTHING
        asked = Asked(context, f"check-{of}", says, variables)
        return asked, [substitute_claim(claim, symbols) for claim in claims]


def _is(tree: Tree, word: str) -> bool:
    return isinstance(tree, Word) and tree == word
