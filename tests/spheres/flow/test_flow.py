"""The flow is proved, its map is that of the laws in vectors, and another map is refused."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from verify import check
from verify.language.argument import Argument
from verify.language.terms import Claim, equal, sqrt, symbol
from verify.paper.commands.pages import content, page
from verify.prover.arguments import write_down
from verify.spheres.flow.contexts import COLLISION, DRIFT, NAMED, PAIRS, RECENTRE, UNIT
from verify.spheres.flow.law import (
    Keep,
    State,
    collided,
    drifted,
    flight,
    recentred,
)
from verify.spheres.flow.pairs_and_units import pairs_of, unit_of
from verify.wire.text.read_page import read_page
from verify.wire.write import write


def report(statement: bytes, certificate: bytes) -> check.Report:
    return check.check(statement, certificate, {})


# --- the page -------------------------------------------------------------------------------------


def computed(prefix: str, read: Callable[[State, Keep], object]) -> dict[str, Claim]:
    """What the program computes from a state of variables, as the page would write it."""
    found: dict[str, Claim] = {}

    def keep(name: str, term: Any) -> Any:
        new = symbol(f"{prefix}{name}")
        found[f"{new.name}-is"] = equal(new, term)
        return new

    read(State(*(symbol(f"{prefix}{name}") for name in State._fields)), keep)
    return found


def after(change: Callable[[State, Keep], object]) -> Callable[[State, Keep], object]:
    """The same, with the names of a next state."""
    return lambda now, keep: change(now, lambda name, term: keep(f"{name}_next", term))


def check_page(name: str, context: str, prefix: str, read: Callable[[State, Keep], object]) -> None:
    """A context of a page has the formulas that the program computes, and no others."""
    written = page(name).statement.context(context).claims
    own = computed(prefix, read)
    assert own == {name: written[name] for name in own}
    assert {*own} == {name for name in written if name.endswith("-is")}
    if context in NAMED:
        named = {name for name in own if name.endswith("_next-is")}
        assert named == {f"{prefix}{name}_next-is" for name in NAMED[context]}


def flight_and_collision(now: State, keep: Keep) -> None:
    way = flight(now, sqrt, keep)
    collided(symbol("r"), now, way, lambda name, term: keep(f"{name}_next", term))


@pytest.mark.parametrize(
    ("context", "prefix", "read"),
    [
        (COLLISION, "", flight_and_collision),
        (RECENTRE, "recentre.", after(recentred)),
        (DRIFT, "drift.", after(lambda now, keep: drifted(now, symbol("drift.t"), keep))),
        (PAIRS, "pairs.", pairs_of),
        (UNIT, "unit.", lambda now, keep: unit_of(now, sqrt, keep)),
    ],
)
def test_the_program_computes_with_the_formulas_of_the_page(
    context: str, prefix: str, read: Callable[[State, Keep], object]
) -> None:
    check_page("flow", context, prefix, read)


def test_another_map_is_refused() -> None:
    """With W_s pushed twice as hard the numbers are not those of the vectors."""
    right = "w_next-is: w_next = w + (1 + r)/2*"
    text = content("flow").decode()
    assert text.count(right) == 1
    wrong = read_page("flow.toml", text.replace(right, right.replace("= w +", "= 2*w +")).encode())
    found = write(write_down(Argument(wrong.statement, wrong.chapters)))
    verdict = report(found["statement.json"], found["certificate.json"])
    assert verdict.verdict == "REFUSED"
    assert any("next-" in line for line in verdict.lines if line.startswith("REFUSED"))
