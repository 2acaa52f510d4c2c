"""The job `prove`: a statement of anybody's, whose rows are questions, decided and judged."""

from __future__ import annotations

import json
import re
from codecs import BOM_UTF8
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from verify import check
from verify.language.errors import UnreadError
from verify.language.record import TYPE_CHECKING
from verify.language.statement import NEEDED, PROVED, UNDECIDED, Cite, Obligation, Statement
from verify.language.terms import Claim, parts_of
from verify.prover.budget import SpentError, WorkBudget
from verify.prover.definedness import completed
from verify.prover.hint import Hint
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import Step
from verify.prover.prove import NO_HINTS, prove
from verify.wire.inputs import InputError, TooDeepError, shown
from verify.wire.judge import judged
from verify.wire.text import Page
from verify.wire.write import certificate_file, digest, statement_file

if TYPE_CHECKING:
    from verify.language.argument import Chapter

#: What the checker says where there is more than it reads; a longer number than those that it
#: reads is no number for it, and so the name of a fact.
LIMITS = (
    "found (.*more (work )?than|a number of [0-9]+ bits|a degree above|equations that are too deep|"
    r"-?[0-9/]+\.\.\. \([0-9]+ characters\), which is no fact)"
)
#: What the enclosures at the end of a certificate, and tables of shared terms, may cost.
RESERVE = check.MAX_WORK // 10


def read_questions(content: bytes, cited: Mapping[str, bytes]) -> Statement:
    """The statement in a file; which verdicts stand there does not matter.

    ``cited`` has the contents of statements that may be cited, by their digests.

    Raises:
        InputError: for a file that is not in the format, with the reason in one line.
    """
    return _statement(_document(content, cited), cited)


def _statement(document: dict[str, Any], cited: Mapping[str, bytes]) -> Statement:
    from verify.wire.read import read_statement  # loaded only where they are used
    from verify.wire.term_json import TermReader

    return read_statement(document, TermReader(document["terms"]), cited)


def read_page_of(
    path: str, content: bytes, cited: Mapping[str, bytes], seconds: float | None = None
) -> Page:
    """The questions in a file, and hints for them; the end of its name says what it is written in.

    At most half of the ``seconds`` goes into the search for points of its contexts.

    Raises:
        InputError: for a file that cannot be used, with the place and the reason in one line.
    """
    content = content.removeprefix(BOM_UTF8)
    if path.endswith(".toml"):
        from verify.wire.text.read_page import read_page

        return read_page(path, content, cites_in(cited), seconds=seconds)
    if path.endswith(".smt2"):
        from verify.wire.text.smtlib import read_smtlib

        return read_smtlib(path, content, seconds)
    if path.endswith(".fpcore"):
        from verify.wire.text.fpcore import read_fpcore

        return Page(read_fpcore(path, content, seconds), {})
    if not (path.endswith(".json") or content.lstrip().startswith(b"{")):
        raise InputError(
            f"STATEMENT: {shown(path)} is none of the formats that are read; name a page .toml, a "
            "statement .json, or a question .smt2 or .fpcore"
        )
    return Page(read_questions(content, cited), {})


def decide(
    statement: Statement,
    budget: WorkBudget | None = None,
    hints: Mapping[str, Hint] = NO_HINTS,
    chapters: Sequence[Chapter] = (),
) -> Outcome:
    """Every row of a statement, decided and judged; or undecided, with the reason.

    ``hints`` say where to look for the proofs of some rows; with ``chapters`` each line is shown by
    what it names, if it names anything.

    Raises:
        InputError: for a statement that the checker cannot read.
        OwnError: if the checker refuses what the search calls proved.
    """
    budget, cited = budget or WorkBudget(), list(_proved(statement.cites))

    def proves(part: Statement) -> bool:
        with budget.part(1, 1 + len(statement.obligations)) as share:
            found = prove(part, budget=share, cited=cited)
        return not found.spent and all(d.claimed == PROVED for d in found.decisions.values())

    reading, asked = Reading(statement, budget), statement
    statement = completed(statement, proves)
    reading = reading if statement is asked else Reading(statement, budget)
    if chapters:
        from verify.prover.lines import prove_lines  # loaded only where it is used

        outcome = prove_lines(
            statement, chapters, budget, reading.price, reading.refusal, hints, cited
        )
    else:
        outcome = prove(statement, budget=budget, price=reading.price, hints=hints, cited=cited)
    try:
        return judged(outcome)
    except UnreadError as error:
        if not _is_limit(error):
            raise
        found = Decision(UNDECIDED, reason=str(error))
        return outcome._replace(decisions=dict.fromkeys(outcome.decisions, found))


def decide_page(page: Page, budget: WorkBudget) -> Outcome:
    """Every row of a page, decided and judged; other forms of a row are tried if it is undecided.

    The first form has all the work for a row, as on a page that is written so, and two thirds of
    the time; the others have half as much work together. What is found apart is decided once more
    with the other rows.

    Raises:
        InputError: for a statement that the checker cannot read.
        OwnError: if the checker refuses what the search calls proved.
    """
    statement = stated(page)
    if page.is_argued:
        return decide(statement, budget, page.hints, page.chapters)
    if not page.forms:
        return _with_contexts(statement, page, budget)
    with budget.part(1, 1.5) as most:
        first = decide(statement, most, page.hints)
    from verify.wire.other_forms import with_other_forms  # loaded only where it is used

    return with_other_forms(first, page, budget, decide)


def _with_contexts(statement: Statement, page: Page, budget: WorkBudget) -> Outcome:
    """Every row decided; where rows of contexts are open, in parts of their contexts."""
    if all(row.context is None for row in statement.obligations):
        return decide(statement, budget, page.hints)
    claims = (row.claim for row in statement.obligations if isinstance(row.claim, Claim))
    is_told = any(part.op in ("min", "max") for c in claims for part in parts_of(c.lhs, c.rhs))
    with budget.part(20 if is_told else 1, 6 if is_told else 1.5) as most:
        first = decide(statement, most, page.hints)
    if budget.is_over or all(found.claimed != UNDECIDED for _, found in first.rows):
        return first
    from verify.wire.halves import decided_in_parts  # loaded only where it is used

    found = decided_in_parts(first, page, budget, decide) or first
    again = is_told and found is first and not budget.is_over
    return decide(statement, budget, page.hints) if again else found


def stated(page: Page) -> Statement:
    """The statement of a page, with a number for each constant that may be chosen.

    Raises:
        InputError: if a number cannot be chosen.
    """
    if not page.choices:
        return page.statement
    from verify.prover.choices import BudgetError, chosen  # loaded only where it is used

    try:
        return chosen(page.statement, page.choices)
    except (BudgetError, ValueError) as error:
        raise InputError(
            f"STATEMENT: a constant cannot be chosen: {error}; write its value"
        ) from error


def _is_limit(error: Exception) -> bool:
    """Whether the checker stops because of how much there is, not of what it says."""
    return isinstance(error, RecursionError) or re.search(LIMITS, str(error)) is not None


class Reading:
    """The checker, which reads the steps of a statement's rows as they are found.

    What it thinks of them does not matter here, but whether it comes to their end.

    Raises:
        InputError: for a statement that it cannot read.
    """

    def __init__(self, statement: Statement, budget: WorkBudget) -> None:
        self._statement, self._budget = statement, budget
        cited = {digest(cite.content): cite.content for cite in all_cites(statement.cites)}
        try:
            self._content, self._names = statement_file(_claims(statement, ()))
            deep = _is_deep(json.loads(self._content))
        except RecursionError:
            deep = True
        if deep:
            raise TooDeepError("STATEMENT: its terms are too deep; nest fewer operations")
        if len(self._content) > check.MAX_BYTES:
            most = f"the checker reads at most {check.MAX_BYTES}"
            raise InputError(
                f"STATEMENT: what it says takes {len(self._content)} bytes, and {most}; split it"
            )
        self._cited = cited
        self._batches: list[tuple[Obligation | None, str, Sequence[Step]]] = []
        _document(self._content, cited)
        self._begin()

    def price(self, row: Obligation | None, claimed: str, steps: Sequence[Step]) -> str:
        """Why the checker does not come to the end of the steps for a row; or nothing."""
        try:
            with self._budget.alarm():
                self._read(row, claimed, steps)
        except (check.Malformed, RecursionError, SpentError) as error:
            is_late = isinstance(error, SpentError)
            if not is_late and not _is_limit(error):  # a mistake of ours, which the judge will name
                return ""
            self._again()
            what = "is checked too late" if is_late else "is more than the checker reads"
            return f"the proof that was found {what}: {error!s:.200}"
        self._batches.append((row, claimed, tuple(steps)))
        return ""

    def refusal(self, row: Obligation | None, claimed: str, steps: Sequence[Step]) -> str:
        """Why the checker does not accept steps that somebody wrote; or nothing."""
        before = len(self._checking.complaints)
        try:
            with self._budget.alarm():
                self._read(row, claimed, steps)
        except (check.Malformed, RecursionError, SpentError) as error:
            reason = str(error) or "it is too deep"
        else:
            reason = next(iter(self._checking.complaints[before:]), "").removeprefix("REFUSED ")
        if reason:
            self._again()
        else:
            self._batches.append((row, claimed, tuple(steps)))
        return reason

    def _again(self) -> None:
        """Read what was accepted so far once more."""
        self._begin()
        for batch in self._batches:
            self._read(*batch)

    def _begin(self) -> None:
        kernel = check.Kernel()
        reader = check.Reader(kernel, self._cited)
        document = _as_asked(check.parsed("statement", self._content, check.STATEMENT))
        self._checking = check.Checking(kernel, reader, reader.read(document))
        kernel.work -= RESERVE

    def _read(self, row: Obligation | None, claimed: str, steps: Sequence[Step]) -> None:
        checking = self._checking
        claimed_steps = _claims(self._statement, steps)
        certificate = certificate_file(claimed_steps, self._content, self._names)
        document = check.parsed("certificate", certificate, check.CERTIFICATE)
        if row is not None:
            rows = checking.statement.rows
            rows[row.name] = rows[row.name]._replace(verdict=claimed)
        # Each batch has shared terms of its own, whose names are free again after it.
        own = document["terms"].keys()
        checking.kernel.shared |= document["terms"]
        for name in own:
            checking.kernel.introduce(name)
        for step in document["steps"]:
            checking.step(step)
        checking.kernel.taken -= own
        for name in own:
            checking.kernel.shared.pop(name, None)
            checking.kernel.abbreviations.pop(name, None)


def _is_deep(document: Any) -> bool:
    """Whether lists and tables nest more deeply than the checker reads."""
    level = [document]
    for _ in range(check.MAX_NESTING):
        lists = [item.values() if isinstance(item, dict) else item for item in level]
        level = [item for inner in lists for item in inner if isinstance(item, dict | list)]
    return bool(level)


def _claims(statement: Statement, steps: Sequence[Step]) -> Outcome:
    decisions = dict.fromkeys((row.name for row in statement.obligations), Decision(PROVED))
    return Outcome(statement, decisions, tuple(steps), {})


def cites_in(cited: Mapping[str, bytes]) -> tuple[Cite, ...]:
    """What may be cited among some files, by their digests.

    Raises:
        InputError: if a statement there cannot be read.
    """
    if not cited:
        return ()
    from verify.wire.read import cites_of, statements_among  # loaded only where they are used

    for content in statements_among(cited).values():
        try:
            document = check.parsed("statement", content, check.STATEMENT)
            check.Reader(check.Kernel(), cited).read(document)
        except (check.Malformed, check.Refused, RecursionError) as error:
            told = f"{error!s:.200}; make it anew, or take it away"
            raise InputError(f"cited: a statement there cannot be read: {told}") from error
    return cites_of(cited)


def _proved(cites: Sequence[Cite], prefix: str = "") -> Iterator[tuple[str, Statement]]:
    """What is cited, with its proved rows only, and what its names begin with here."""
    for cite in cites:
        here = f"{prefix}{cite.name}:"
        yield from _proved(cite.cites, here)
        document = json.loads(cite.content)
        rows = [row for row in document["obligations"] if row["verdict"] == PROVED]
        yield here, _statement(document | {"obligations": rows, "cites": []}, {})


def all_cites(cites: Sequence[Cite]) -> list[Cite]:
    """The citations, and those in what is cited."""
    return [found for cite in cites for found in (cite, *all_cites(cite.cites))]


def _document(content: bytes, cited: Mapping[str, bytes]) -> dict[str, Any]:
    """The document in a statement's file, which the checker can read."""
    try:
        document: dict[str, Any] = check.parsed("STATEMENT", content, check.STATEMENT)
        check.Reader(check.Kernel(), cited).read(_as_asked(document))
    except (check.Malformed, RecursionError) as error:
        raise InputError(
            f"STATEMENT: {_as_written(error)}; certificates/README.md describes the format"
        ) from error
    if not any(row["role"] == NEEDED for row in document["obligations"]):
        raise InputError('STATEMENT: no row is needed; write "role": "needed" where it is asked')
    half = re.search("[\ud800-\udfff]", json.dumps(document, ensure_ascii=False))
    if half is not None:
        raise InputError(
            f"STATEMENT: {half[0]!a} is one half of an escaped letter; write both halves of it"
        )
    return document


def _as_written(error: Exception) -> str:
    twice = re.search("found the name .* twice$", str(error))
    words = str(error).removeprefix("STATEMENT: ")
    return f"{words}: one name stands for two things" if twice else words


def _as_asked(document: dict[str, Any]) -> dict[str, Any]:
    """The document with the verdict that each row asks for."""
    rows = [row | {"verdict": PROVED} for row in document["obligations"]]
    return document | {"obligations": rows}
