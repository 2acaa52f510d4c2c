"""The theorem on the limit map is proved, a point is certified, and lies about it are refused."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from fractions import Fraction
from hashlib import sha256
from itertools import pairwise
from typing import Any

import pytest

from verify import check
from verify.language.argument import Chapter, Line
from verify.language.statement import PROVED, Applies
from verify.language.terms import Claim, as_term
from verify.paper.commands import pages, separatrix
from verify.paper.commands.pages import argument
from verify.paper.commands.regenerate import is_right_statement
from verify.prover.arguments import write_down
from verify.spheres.limit_map import Parameters
from verify.spheres.separatrix import decide_separatrix as enclose
from verify.wire.judge import report_on
from verify.wire.write import write

F = Fraction
Json = dict[str, Any]


def point(
    r: str, c: str, ratio: str, q: str, digits: int = 4, balls: tuple[str, ...] = ()
) -> separatrix.PointParameters:
    numbers = [tuple(map(F, each.split())) for each in balls]
    parameters = Parameters(F(r), F(c), F(ratio), *numbers)
    found = separatrix.point_of(enclose(parameters, F(q), digits, 10**6))
    assert found is not None
    return found


HONEST = ("3/100", "1", "2", "1/10")
UNLIKE = ("1 5 1/2", "1/2 1 1/4")

# --- the theorem ----------------------------------------------------------------------------------


def test_the_theorem_has_its_rows() -> None:
    assert len(pages.decide("separatrix").rows) == 42


def test_every_row_is_sharp_enough_to_be_refused() -> None:
    """With a little more on the smaller side no row is shown by its proof."""
    honest = argument("separatrix")

    def larger(claim: Claim) -> Claim:
        return Claim(claim.relation, claim.lhs + F(1, 10**9), claim.rhs)

    def falsified(item: Any) -> Any:
        if not (isinstance(item, Line) and item.says and isinstance(item.claim, Claim)):
            return item
        return item._replace(claim=larger(item.claim))

    rows = tuple(
        row._replace(claim=larger(row.claim)) if isinstance(row.claim, Claim) else row
        for row in honest.statement.obligations
    )
    chapters = tuple(Chapter(c.context, tuple(map(falsified, c.items))) for c in honest.chapters)
    lie = honest._replace(statement=honest.statement._replace(obligations=rows), chapters=chapters)
    report = report_on(write_down(lie))
    compared = [row.name for row in rows if isinstance(row.claim, Claim)]
    assert len(compared) > 30
    assert [name for name in compared if report.rows.get(name) == "proved"] == []


# --- points ---------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "at",
    [
        HONEST,
        ("3/100", "1", "1", "0"),
        ("3/100", "1", "1/7", "44/100"),
        ("1/100000", "1/10", "1000", "1/100"),
        ("1/20", "1", "1/1000", "1/100"),
        ("1/20", "1", "3", "2/5"),
        ("3/100", "1", "1", "100"),
        ("2/25", "1", "1", "1/10"),
        ("1/1000", "220/1001", "1", "1/10"),
        ("99/100", "1", "1", "0"),
    ],
)
def test_a_point_is_certified(at: tuple[str, str, str, str]) -> None:
    outcome = separatrix.decide_value(point(*at))
    assert outcome.verdict == PROVED
    content = write(outcome)["statement.json"]
    assert is_right_statement(content)


@pytest.mark.parametrize("q", ["0", "1/10", "3"])
def test_a_point_of_unlike_balls_is_certified(q: str) -> None:
    outcome = separatrix.decide_value(point("3/100", "1", "2", q, balls=UNLIKE))
    assert outcome.verdict == PROVED
    assert is_right_statement(write(outcome)["statement.json"])


@pytest.mark.parametrize("name", separatrix.BALLS)
def test_a_lie_about_a_ball_is_refused(name: str) -> None:
    files = write(separatrix.decide_value(point(*HONEST, balls=UNLIKE)))
    for factor in (F(9, 10), F(11, 10)):
        old = F(json.loads(files["statement.json"])["parameters"][name])
        assert lied(files, parameter(name, str(old * factor))).verdict == "REFUSED"


def test_equal_balls_have_no_second_statement() -> None:
    """Their parameters are the six of a point."""
    given = point(*HONEST, balls=("2 2 2", "3 3 3"))
    statement = separatrix.point_outcome(given).statement
    assert [*statement.parameters] == [*separatrix.NAMES]
    more = {**statement.parameters, **{name: as_term(2) for name in separatrix.BALLS}}
    assert separatrix.read_point(more) is None


def test_the_value_is_the_known_one() -> None:
    found = point("3/100", "1", "1", "1/10", 12)
    assert F("0.051778562761854") <= found.least < found.most <= F("0.051778562761856")
    assert "f(0.1) lies between 0.0517785627618" in separatrix.decide_value(found).statement.title


def test_many_digits_have_a_certificate() -> None:
    assert separatrix.decide_value(point("3/100", "1", "1", "1/10", 40)).verdict == PROVED


# --- lies -----------------------------------------------------------------------------------------


def changed(at: tuple[str, str, str, str], change: Callable[[Json], None]) -> check.Report:
    """What the checker says after a change of the statement, to which the certificate is tied."""
    return lied(write(separatrix.decide_value(point(*at))), change)


def lied(files: Mapping[str, bytes], change: Callable[[Json], None]) -> check.Report:
    """The same of files."""
    statement, certificate = (json.loads(files[f"{n}.json"]) for n in ("statement", "certificate"))
    change(statement)
    first = json.dumps(statement).encode()
    certificate["statement_sha256"] = sha256(first).hexdigest()
    cited = {sha256(data).hexdigest(): data for name, data in files.items() if "cited" in name}
    return check.check(first, json.dumps(certificate).encode(), cited, None)


def parameter(name: str, value: str) -> Callable[[Json], None]:
    def change(statement: Json) -> None:
        statement["parameters"][name] = value

    return change


def number(row: str, key: str, value: str) -> Callable[[Json], None]:
    def change(statement: Json) -> None:
        (found,) = (r for r in statement["obligations"] if r["name"] == row)
        found["claim"][2][key] = value

    return change


def swapped(row: str) -> Callable[[Json], None]:
    def change(statement: Json) -> None:
        (found,) = (r for r in statement["obligations"] if r["name"] == row)
        found["claim"][1:] = reversed(found["claim"][1:])

    return change


@pytest.mark.parametrize(
    "change",
    [
        parameter("least", "1/20"),
        parameter("most", "1/50"),
        parameter("q", "1/5"),
        parameter("q", "1/100"),
        parameter("r", "4/100"),
        parameter("r", "1/100"),
        parameter("c", "9/10"),
        parameter("ratio", "3"),
        parameter("ratio", "1"),
        number("below-1", "up.X", "1/100"),
        number("below-1", "up.V", "1/100"),
        number("above-1", "down.X", "1/2"),
        number("above-1", "down.V", "1/2"),
        swapped("below-falls-q"),
        swapped("below-falls-u"),
        swapped("above-rises-q"),
        swapped("above-rises-u"),
        swapped("above-rises"),
    ],
)
def test_a_lie_is_refused(change: Callable[[Json], None]) -> None:
    assert changed(HONEST, lambda _: None).verdict == "PROVED"
    assert changed(HONEST, change).verdict == "REFUSED"


def test_zero_is_refused_where_there_is_a_curve() -> None:
    """At a larger -cos there is a curve; below phi_plus f is positive."""
    below, none = ("1/20", "1", "3", "2/5"), ("2/25", "1", "1", "1/10")
    assert changed(below, parameter("q", "39/100")).verdict == "REFUSED"
    assert changed(none, parameter("r", "3/100")).verdict == "REFUSED"


def test_a_chain_with_a_gap_is_not_the_program_s() -> None:
    """The checker reads rows one by one; that they belong together is seen from the statement."""
    content = write(separatrix.decide_value(point(*HONEST)))["statement.json"]
    statement = json.loads(content)
    statement["obligations"] = [r for r in statement["obligations"] if r["name"] != "below-2"]
    assert is_right_statement(content)
    assert not is_right_statement(json.dumps(statement).encode())


@pytest.mark.parametrize(("name", "value"), [("least", F(1, 20)), ("most", F(1, 50))])
def test_a_false_bound_has_no_certificate(name: str, value: Fraction) -> None:
    with pytest.raises(separatrix.TooLongError):
        separatrix.point_outcome(point(*HONEST)._replace(**{name: value}))


def test_each_row_applies_to_the_state_before() -> None:
    outcome = separatrix.decide_value(point(*HONEST))
    for kind, context in (("below", "up"), ("above", "down")):
        rows = [row.claim for row, _ in outcome.rows if row.name.startswith(kind)]
        states = [
            r.at for r in rows if isinstance(r, Applies) and r.context.endswith(f":{context}")
        ]
        assert len(states) > 3
        for before, after in pairwise(states):
            assert before[f"{context}.X"] == after[f"{context}.Q"]
            assert before[f"{context}.V"] == after[f"{context}.U"]
            assert before[f"{context}.rho"] != after[f"{context}.rho"]
