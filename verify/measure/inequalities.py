"""Published inequalities, each a statement of one row, decided and checked: the job of `bench`.

`verify/data/inequalities.json` has them with their sources and what is true of them: polynomials,
quotients, roots, cosines and minima, on boxes and on half-lines. Ranges are open.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from pathlib import Path
from statistics import median
from typing import Any

from verify import check
from verify.language.record import Record
from verify.language.statement import (
    NEEDED,
    PROVED,
    UNDECIDED,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Claim, Term, as_term, symbol
from verify.measure import Table, table, timed
from verify.prover.budget import WorkBudget
from verify.prover.prove import prove
from verify.wire.term_json import TermReader
from verify.wire.write import write

COLLECTION = Path(__file__).parent.parent / "data" / "inequalities.json"

CONTEXT, ROW = "domain", "claim"


class Judged(Record):
    """What became of one inequality; ``accepted`` says that the checker agrees with the verdict."""

    name: str
    category: str
    verdict: str
    right: bool
    accepted: bool
    search: float
    check: float
    size: int
    rule: str
    why: str = ""


def entries() -> list[dict[str, Any]]:
    """The collection."""
    found: list[dict[str, Any]] = json.loads(COLLECTION.read_text(encoding="utf-8"))
    return found


def question(entry: dict[str, Any]) -> Statement:
    """The statement that asks for one inequality."""
    claim = TermReader({}).comparison(entry["claim"])
    contexts = (_domain(entry["variables"]),) if entry["variables"] else ()
    context = CONTEXT if contexts else None
    row = Obligation(ROW, "", "", NEEDED, entry["name"], claim, context=context)
    return Statement(entry["name"], entry["name"], {}, (), contexts, (row,), ())


def _domain(ranges: dict[str, list[str | None]]) -> Context:
    variables = tuple(Variable(name, name, name) for name in ranges)
    givens, point = [], {}
    for name, (low, high) in ranges.items():
        ends = [None if end is None else Fraction(end) for end in (low, high)]
        x = symbol(name)
        if ends[0] is not None:
            givens.append(Given(f"{name}.low", Claim("<", as_term(ends[0]), x)))
        if ends[1] is not None:
            givens.append(Given(f"{name}.high", Claim("<", x, as_term(ends[1]))))
        point[name] = _between(*ends)
    return Context(CONTEXT, variables, tuple(givens), point)


def _between(low: Fraction | None, high: Fraction | None) -> Term:
    if low is not None and high is not None:
        return as_term((low + high) / 2)
    return as_term(0 if low is high else low + 1 if low is not None else (high or 0) - 1)


def judge(entry: dict[str, Any], seconds: float) -> Judged:
    """Decide an inequality, and check the certificate."""
    search, outcome = timed(lambda: prove(question(entry), budget=WorkBudget(seconds=seconds)))
    verdict, rule = outcome.claimed, outcome.decisions[ROW].method
    right = verdict == UNDECIDED or (verdict == PROVED) == entry["truth"]
    found = Judged(entry["name"], entry["category"], verdict, right, False, search, 0, 0, rule)
    if verdict == UNDECIDED:
        return found
    files = write(outcome)
    checked, why = timed(lambda: _complaint(files, verdict))
    size = len(files["certificate.json"])
    return found._replace(accepted=not why, check=checked, size=size, why=why)


def _complaint(files: Mapping[str, bytes], verdict: str) -> str:
    """What the checker has against a certificate and its verdict; nothing if it accepts both."""
    try:
        report = check.check(files["statement.json"], files["certificate.json"], {})
    except (check.Malformed, RecursionError) as error:
        return f"MALFORMED {error}"
    return "" if report.verdict == verdict.upper() else report.lines[0] or report.summary


def measured(names: Iterable[str] = (), seconds: float = 60) -> Iterator[Judged]:
    """All of the collection, or some of it."""
    wanted = set(names)
    for entry in entries():
        if not wanted or entry["name"] in wanted or entry["category"] in wanted:
            yield judge(entry, seconds)


#: What the short form measures.
QUICK = ("ground", "poly-uni", "sqrt", "identity")


def inequality_table(quick: bool) -> Table:
    """For each category how many are decided and accepted, how fast, and how long proofs are."""
    found = list(measured(QUICK if quick else ()))
    groups = list(dict.fromkeys(one.category for one in found))
    rows = [_counted(group, [one for one in found if one.category == group]) for group in groups]
    columns = (
        *("category", "claims", "decided", "wrong", "accepted", "median s (with the check)"),
        *("longest certificate (bytes)", "longest check (s)", "undecided"),
    )
    title = "Published inequalities: decided within 60 s each, with certificates"
    return table(title, columns, [*rows, _counted("all", found)])


def _counted(group: str, found: list[Judged]) -> list[str | int | None]:
    decided = [one for one in found if one.verdict != UNDECIDED]
    times = [one.search + one.check for one in decided]
    return [
        group,
        len(found),
        len(decided),
        sum(not one.right for one in found),
        sum(one.accepted for one in found),
        f"{median(times):.3f}" if times else None,
        max((one.size for one in decided), default=0),
        f"{max((one.check for one in decided), default=0.0):.2f}",
        ", ".join(one.name for one in found if one.verdict == UNDECIDED),
    ]
