"""Statements of one's own, in a few lines: what `from verify import …` offers.

Names, claims and values are all that is needed; letters are taken from the names. The words are
those of a page of constants in the text format. What cannot be used is said where it is written
down: a `TypeError` for a value of the wrong kind, an `InputError` for the rest.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from fractions import Fraction
from hashlib import sha256
from os import PathLike
from pathlib import Path
from typing import TypeVar

from verify.language.record import Record
from verify.language.statement import (
    NEEDED,
    PRINTED,
    Always,
    Applies,
    Assumption,
    Cite,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Claim, Number, Term, as_term, names_of, symbol
from verify.prover.budget import WORK, WorkBudget
from verify.prover.decimals import short
from verify.prover.hint import Hint
from verify.prover.outcome import Decision, Outcome
from verify.prover.prove import NO_HINTS
from verify.wire.inputs import InputError, nearest, shown
from verify.wire.questions import cites_in, decide, decide_page, stated
from verify.wire.text import Page
from verify.wire.text.letters import letter_of
from verify.wire.text.page_tables import NAME
from verify.wire.text.read_page import read_page as read_text
from verify.wire.text.roots import Isolated, isolated
from verify.wire.text.write_page import page_text
from verify.wire.write import write

Item = TypeVar("Item")
#: So many seconds are no time to wait.
LONGEST = 10**9
Claims = Mapping[str, Claim] | Iterable[Claim]


class Result(Outcome):
    """A statement with its rows decided; a notebook shows it as a table with its formulas."""

    def decision(self, row: str) -> Decision:
        """What was found of one row.

        Raises:
            InputError: for a name of no row.
        """
        if row not in self.decisions:
            raise InputError(f"there is no row {shown(row)}; {nearest(row, self.decisions)}")
        return self.decisions[row]

    def latex(self) -> str:
        """The statement with its verdicts as one LaTeX document."""
        from verify.publication import NOBODYS  # loaded only where they are used
        from verify.views.tex.article import tex_document

        return tex_document([self], NOBODYS)

    def _repr_html_(self) -> str:
        from verify.views.notebook import notebook_page  # loaded only where it is used

        return notebook_page(self)

    def __str__(self) -> str:
        from verify.publication import NOBODYS  # loaded only where they are used
        from verify.views.prove import decided_lines

        return "\n".join(decided_lines(self, NOBODYS))


class Interval(Record):
    """All numbers from ``low`` to ``high``, both exact; its text has certain digits."""

    low: Fraction
    high: Fraction

    def __str__(self) -> str:
        return short(self)


def exact_text(name: str, value: str | int | Fraction) -> str:
    """A number as a text that means just it.

    Raises:
        TypeError: for a float, or what is no number.
    """
    if isinstance(value, bool) or not isinstance(value, str | int | Fraction):
        what = type(value).__name__
        raise TypeError(f"{name} is a {what}; write a text such as '0.03', or a Fraction")
    try:
        return str(value)
    except ValueError as error:  # more digits than Python writes
        raise InputError(f"{name}: has too many digits; write fewer than 4300") from error


def exact_bits(name: str, value: int, most: int) -> int:
    """A precision, as the commands take it.

    Raises:
        TypeError: for what is no integer.
        InputError: if it is too small, or too large to wait for.
    """
    if isinstance(value, bool) or not isinstance(value, int):
        raise TypeError(f"{name} is a {type(value).__name__}; write an integer such as 128")
    if not 2 <= value <= most:
        raise InputError(f"{name}: has to be from 2 to {most}")
    return value


@contextmanager
def called(**names: str) -> Iterator[None]:
    """Inside, what a message is about is called as the argument, ``neg_cos``, or as ``names`` say.

    Raises:
        InputError: with the message that names arguments.
    """
    try:
        yield
    except InputError as error:
        about, colon, rest = str(error).partition(":")
        for option in re.findall(r"--([\w-]+)", about):
            about = about.replace(f"--{option}", names.get(option, option.replace("-", "_")))
        raise InputError(about + colon + rest) from None


# --- the parts of a statement --------------------------------------------------------------------


def constant(
    name: str, value: Number, *, letter: str | None = None, tex: str | None = None, label: str = ""
) -> Constant:
    """A number with a name: an exact one, or a term over earlier names.

    ``letter`` and ``tex`` are how it is shown; by default ``alpha_0`` is α₀.
    """
    plain, latex = letter_of(name)
    plain, latex = plain if letter is None else letter, latex if tex is None else tex
    return Constant(name, plain, latex, label, as_term(value))


def for_all(
    name: str,
    givens: Claims,
    point: Mapping[str, Number],
    *,
    within: Context | None = None,
    constants: Iterable[Constant] = (),
    carried: Claims = (),
    standing: Mapping[str, tuple[Claim, Assumption]] | None = None,
    says: str = "",
) -> Context:
    """All values with these givens; ``point`` has for each variable a value that is one of them.

    Args:
        name: what rows and other contexts call it.
        givens: claims with their names, or claims alone.
        point: the variables, with values, over the names of the context around, at which all
            givens hold.
        within: the context around, whose variables may be used.
        constants: names for terms over the variables.
        carried: givens that an induction shows at the start and carries from state to state.
        standing: givens that an assumption grants for every state of an induction.
        says: the context in words.

    Raises:
        TypeError: for a given that is no claim, or a variable that is no name.
    """
    found = [*_givens(name, givens, "plain", 0)]
    found += _givens(name, carried, "carried", len(found))
    for given, (claim, assumption) in (standing or {}).items():
        found.append(Given(given, _claim(f"the given {given}", claim), "standing", assumption.name))
    for variable in point:
        if not isinstance(variable, str):
            raise TypeError(f"point: {variable!r} is no name; write the name, such as 'x'")
    return Context(
        name,
        tuple(Variable(v, *letter_of(v)) for v in point),
        tuple(found),
        {v: as_term(value) for v, value in point.items()},
        None if within is None else _context("within", within).name,
        says,
        tuple(constants),
    )


def root_between(
    name: str,
    term: Term,
    variable: Term,
    between: tuple[Number, Number],
    *,
    constants: Iterable[Constant] = (),
) -> Isolated:
    """The root of a term between two numbers, which no term stands for.

    The statement needs its two contexts, ``context`` and ``range``, and its ``rows``, which show
    that it exists and is the only one there, by the intermediate value theorem. What is asked in
    ``context`` is proved of all numbers that are within 1e-12 of the root.

    Args:
        name: that of the context; the rows begin with it.
        term: is 0 at the root, and its derivative has one sign between the numbers.
        variable: the symbol that stands for the root.
        between: rational numbers at which the term has different signs.
        constants: those whose names are in the term.

    Raises:
        InputError: if the term does not change its sign, or has no derivative.
        TypeError: if the variable is no symbol, or an end no rational number.
    """
    low, high = map(as_term, between)
    if not isinstance(variable, Term) or variable.op != "symbol":
        raise TypeError(f"root_between {name}: {variable!r} is no variable; write symbol('x')")
    if low.op != "rational" or high.op != "rational":
        raise TypeError(
            f"root_between {name}: between has to be two rational numbers, such as (1, 2)"
        )
    known = {constant.name: constant.term for constant in constants}
    x = variable.name
    names = (x, f"{name}.range.{x}")
    first, second = (Variable(own, *letter_of(x)) for own in names)
    return isolated(name, (first, second), as_term(term), (low.value, high.value), known)


def applies(context: Context, at: Mapping[str, Number]) -> Applies:
    """The claim that these values satisfy all givens of a context."""
    _same_names(f"applies to {_context('applies', context).name}", context, at)
    return Applies(context.name, {name: as_term(value) for name, value in at.items()})


def always(
    context: Context, start: Mapping[str, Number], following: Mapping[str, Number]
) -> Always:
    """The claim that from this start, with this following state, the givens hold for ever.

    The givens of the context are carried or standing; its row is an induction.
    """
    _same_names(f"start in {_context('always', context).name}", context, start)
    _same_names(f"following in {context.name}", context, following)
    return Always(
        context.name,
        {name: as_term(value) for name, value in start.items()},
        {name: as_term(value) for name, value in following.items()},
    )


def ask(
    name: str,
    claim: Claim | Applies | Always,
    within: Context | None = None,
    uses: Iterable[Assumption] = (),
    *,
    role: str = NEEDED,
    says: str = "",
    label: str = "",
) -> Obligation:
    """The question whether a claim holds, for all values of a context if it is about one.

    ``uses`` are the assumptions without which it would not say what it should. A row whose ``role``
    is ``"printed"`` is judged, and nothing rests on it.

    Raises:
        TypeError: for what is no claim, such as ``a == b``, which is a bool.
    """
    if role not in (NEEDED, PRINTED):
        raise InputError(f"the row {name}: role {shown(role)} is unknown; write needed or printed")
    asked = claim if isinstance(claim, Applies | Always) else _claim(f"the row {name}", claim)
    where = f"the row {name}: one of its uses"
    names = tuple(_made("assume", where, assumption, Assumption).name for assumption in uses)
    context = None if within is None else _context(f"the row {name}", within).name
    return Obligation(name, "", label, role, says, asked, uses=names, context=context)


def assume(name: str, sentence: str, *, kind: str = "assumption") -> Assumption:
    """A sentence that is used and not proved."""
    return Assumption(name, "", sentence, kind)


def cite(name: str, files: Mapping[str, bytes]) -> Cite:
    """Another statement, by the files that `certificate` makes, whose theorems may be used.

    Raises:
        InputError: if there is no statement among the files.
    """
    statement = files.get("statement.json")
    if statement is None:
        raise InputError(f"cite {shown(name)}: there is no statement.json among the files")
    digests = {sha256(content).hexdigest(): content for content in files.values()}
    own = sha256(statement).hexdigest()
    found = (c for c in cites_in(digests) if sha256(c.content).hexdigest() == own)
    cited = next(found, None)
    if cited is None:
        raise InputError(f"cite {shown(name)}: its statement.json is no statement")
    return cited._replace(name=name)


def lemma(
    title: str,
    questions: Iterable[Obligation],
    constants: Iterable[Constant] = (),
    contexts: Iterable[Context] = (),
    assumptions: Iterable[Assumption] = (),
    cites: Iterable[Cite] = (),
    parameters: Mapping[str, Number] | None = None,
) -> Statement:
    """A statement, for `verify.prove`; earlier rows may be used for later ones.

    ``parameters`` are numbers at which it is stated, and come before the constants.

    Raises:
        InputError: where a row or a context names what is not in the statement, or a name is none,
            or stands for two things.
        TypeError: where something else stands among rows, constants, contexts or assumptions.
    """
    parts: list[tuple[str, type, tuple[object, ...]]] = [
        ("questions", Obligation, rows := _all("questions", questions)),
        ("constants", Constant, numbers := _all("constants", constants)),
        ("contexts", Context, places := _all("contexts", contexts)),
        ("assumptions", Assumption, sentences := _all("assumptions", assumptions)),
        ("cites", Cite, cited := _all("cites", cites)),
    ]
    for what, kind, items in parts:
        for item in items:
            if not isinstance(item, kind):
                maker = _MAKERS[what]
                raise TypeError(f"lemma: {item!r:.60} is none of the {what}; make it by {maker}")
    _are_there(rows, places, sentences, cited)
    given = {name: as_term(value) for name, value in (parameters or {}).items()}
    _are_names(_names_in(rows, numbers, places, given))
    _are_defined(rows, numbers, places, given)
    return Statement(title, title, given, numbers, places, rows, sentences, cited)


_MAKERS = {
    "questions": "ask",
    "constants": "constant",
    "contexts": "for_all",
    "assumptions": "assume",
    "cites": "cite",
}


# --- what is decided, and its files --------------------------------------------------------------


def prove(
    statement: Statement,
    *,
    work: int = WORK,
    seconds: float | None = None,
    watch: Callable[[str], None] | None = None,
    hints: Mapping[str, Hint] = NO_HINTS,
) -> Result:
    """The statement with its rows decided, where that is found; the checker accepts the proofs.

    Args:
        statement: what is asked.
        work: how many units of work each row may be, of about a microsecond each.
        seconds: how long all rows together may take; they share it.
        watch: called with the name of each row when its search begins.
        hints: where to look for the proofs of some rows, by their names.

    Raises:
        InputError: for a statement that the checker cannot read.
        OwnError: if the checker refuses a proof.
    """
    _made("lemma or read_page", "prove: the statement", statement, Statement)
    for row, hint in hints.items():
        _made("Hint", f"prove: the hint for {row}", hint, Hint)
    return Result(*decide(statement, _budget(work, seconds, watch), hints))


def certificate(outcome: Outcome) -> dict[str, bytes]:
    """The files of a certificate, by name, for `verify.check.check` or for a folder."""
    return write(_made("prove", "certificate: the outcome", outcome, Outcome))


def read_page(path: str | PathLike[str]) -> Statement:
    """The statement in a page of constants, a file in the text format.

    Raises:
        InputError: for a file that cannot be used, naming the line and what to write instead; and
            for a page with lemmas, or whose lines say what they follow from.
    """
    page = _page(path)
    if page.is_argued:
        raise InputError(
            f"{path}: it has lemmas, or names what its rows follow from, which is no part of the "
            "statement; write prove_page(path)"
        )
    return stated(page)


def prove_page(
    path: str | PathLike[str],
    *,
    work: int = WORK,
    seconds: float | None = None,
    watch: Callable[[str], None] | None = None,
) -> Result:
    """A page of constants with its rows decided, each by what it names, or else by the search.

    Args:
        path: a file in the text format.
        work: how many units of work each line may be, of about a microsecond each.
        seconds: how long all lines together may take; they share it.
        watch: called with the name of each line when its search begins.

    Raises:
        InputError: for a file that cannot be used, naming the line and what to write instead.
        OwnError: if the checker refuses a proof that was found.
    """
    return Result(*decide_page(_page(path), _budget(work, seconds, watch)))


def _page(path: str | PathLike[str]) -> Page:
    try:
        return read_text(str(path), Path(path).read_bytes())
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror}); name a file") from error


def _budget(work: int, seconds: float | None, watch: Callable[[str], None] | None) -> WorkBudget:
    if type(work) is not int or work < 0:
        raise InputError(f"work = {work!r}: write how many units, an integer")
    is_number = isinstance(seconds, int | float | Fraction)
    if seconds is not None and not (is_number and 0 <= seconds < LONGEST):
        raise InputError(f"seconds = {seconds!r}: write a number below {LONGEST}, or None")
    return WorkBudget(work, seconds) if watch is None else WorkBudget(work, seconds, watch)


def write_page(statement: Statement) -> str:
    """The statement as a page of constants, in the text format."""
    return page_text(_made("lemma", "write_page: the statement", statement, Statement))


# --- what is said of values of the wrong kind ----------------------------------------------------


def _claim(where: str, claim: object) -> Claim:
    if isinstance(claim, bool):
        raise TypeError(
            f"{where}: its claim is {claim}, because == compares how terms are written; "
            "write equal(a, b)"
        )
    if not isinstance(claim, Claim):
        raise TypeError(f"{where}: {claim!r:.60} is no claim; write for example x <= 1")
    return claim


def _givens(name: str, claims: Claims, kind: str, count: int) -> Iterator[Given]:
    if isinstance(claims, Claim):
        raise TypeError(f"the context {name}: write a list of givens, also of one: [0 <= x]")
    if not isinstance(claims, Mapping):
        claims = {f"{name}.{i}": claim for i, claim in enumerate(claims, count + 1)}
    for given, claim in claims.items():
        yield Given(given, _claim(f"the given {given}", claim), kind)


def _context(where: str, context: object) -> Context:
    if not isinstance(context, Context):
        raise TypeError(f"{where}: {context!r:.60} is no context; make one by for_all")
    return context


def _made(maker: str, where: str, value: Item, kind: type) -> Item:
    """The value, which has to be of its kind."""
    if not isinstance(value, kind):
        raise TypeError(f"{where} is {value!r:.60}; make it by {maker}")
    return value


def _same_names(where: str, context: Context, values: Mapping[str, Number]) -> None:
    names = [variable.name for variable in context.variables]
    for name in values.keys() ^ {*names}:
        what = "has no value" if name in names else "is no variable"
        raise InputError(f"{where}: {name} {what}; write values of {', '.join(names)}")


def _all(what: str, items: Iterable[Item]) -> tuple[Item, ...]:
    if isinstance(items, tuple) and hasattr(items, "_fields"):
        raise TypeError(f"lemma: write a list of {what}, also of one")
    return tuple(items)


def _are_there(
    rows: Iterable[Obligation],
    contexts: Iterable[Context],
    assumptions: Iterable[Assumption],
    cites: Iterable[Cite],
) -> None:
    """Afterwards the statement has each context and assumption that is named in it."""
    named = [context.name for context in contexts]
    prefixes = tuple(f"{cite.name}:" for cite in cites)
    trusted = {assumption.name for assumption in assumptions}
    for row in rows:
        about = [] if isinstance(row.claim, Claim) else [row.claim.context]
        for context in (row.context, *about):
            if not (context is None or context in named or context.startswith(prefixes or " ")):
                raise InputError(
                    f"the row {row.name} is about the context {context}, which the lemma does not "
                    "have; write it among the contexts"
                )
        for name in row.uses:
            if name not in trusted:
                raise InputError(
                    f"the row {row.name} uses {name}, which the lemma does not have; write it "
                    "among the assumptions"
                )
    for at, one in enumerate(contexts):
        if one.parent is not None and one.parent not in named[:at]:
            raise InputError(
                f"the context {one.name} is within {one.parent}, which has to come before it among "
                "the contexts"
            )


def _names_in(
    rows: Iterable[Obligation],
    constants: Iterable[Constant],
    contexts: Iterable[Context],
    parameters: Iterable[str],
) -> Iterator[tuple[str, str]]:
    """What has a name, and its name; each has to be another one."""
    yield from (("parameter", name) for name in parameters)
    yield from (("constant", one.name) for one in constants)
    for context in contexts:
        yield "context", context.name
        yield from (("variable", one.name) for one in context.variables)
        yield from (("given", one.name) for one in context.givens)
        yield from (("constant", one.name) for one in context.constants)
    yield from (("row", row.name) for row in rows)


def _are_names(named: Iterable[tuple[str, str]]) -> None:
    """Afterwards each name is one that files have, and stands for one thing."""
    taken: dict[str, str] = {}
    for what, name in named:
        if not NAME.fullmatch(name):
            raise InputError(
                f"the {what} {shown(name)}: it is no name; write ASCII letters, digits, and _ . -"
            )
        if name == "goal":
            raise InputError(f"the {what} goal: that is a word of certificates; choose another")
        if name in taken:
            raise InputError(
                f"{name} is the name of a {taken[name]} and of a {what}; choose another"
            )
        taken[name] = what


def _are_defined(
    rows: Iterable[Obligation],
    constants: Iterable[Constant],
    contexts: Iterable[Context],
    parameters: Iterable[str],
) -> None:
    """Afterwards each name in a term is that of a constant or a variable, or of a citation."""
    inner = [constant for context in contexts for constant in context.constants]
    variables = [variable for context in contexts for variable in context.variables]
    known = {*parameters, *(one.name for one in (*constants, *inner))}
    known |= {one.name for one in variables}

    def test(where: str, *terms: Term) -> None:
        for name in names_of(*terms):
            if name not in known and ":" not in name:
                instead = nearest(name, sorted(known)) if known else "no constant or variable is"
                raise InputError(f"{where}: {name} is not defined; {instead}")

    for one in (*constants, *inner):
        test(f"the constant {one.name}", one.term)
    for context in contexts:
        test(f"the point of {context.name}", *context.point.values())
        for given in context.givens:
            test(f"the given {given.name}", given.claim.lhs, given.claim.rhs)
    for row in rows:
        if isinstance(row.claim, Claim):
            test(f"the row {row.name}", row.claim.lhs, row.claim.rhs)


__all__ = [
    "Result",
    "always",
    "applies",
    "ask",
    "assume",
    "certificate",
    "cite",
    "constant",
    "for_all",
    "lemma",
    "prove",
    "prove_page",
    "read_page",
    "symbol",
    "write_page",
]
