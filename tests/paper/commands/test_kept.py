"""What is kept of algebra gives the verdicts that algebra finds, and none where it may not hold."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.points import ADMISSIBLE, parameters
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Constant
from verify.language.terms import as_term, sqrt, symbol
from verify.paper import theorem1
from verify.paper.commands import kept as keeping
from verify.paper.commands.theorem1 import Recalled, RecallingGround, decide_point
from verify.paper.parameters import SELECTIONS
from verify.prover.session import Session
from verify.wire.compiled import Kept

OTHERS = [("3/100", "97/100"), ("3/100", "1/2"), ("557/10000", "1"), ("1/10000000000", "1")]


def verdicts(where, selection: str, all_sides: bool, bits: int = 128) -> dict[str, str]:
    outcome = decide_point(where, selection, bits, all_sides=all_sides)
    return {name: found.verdict for name, found in outcome.decisions.items()}


@pytest.mark.parametrize(("r", "c"), [*ADMISSIBLE, *OTHERS])
def test_the_verdicts_are_those_of_a_run_that_looks_for_proofs(r: str, c: str) -> None:
    where = parameters(r, c)
    for selection in SELECTIONS:
        assert verdicts(where, selection, False) == verdicts(where, selection, True)


def test_with_too_few_bits_algebra_is_looked_for() -> None:
    where = parameters("3/100", "1")
    assert verdicts(where, "all", False, 8) == verdicts(where, "all", True)


def test_most_rows_that_algebra_decides_need_no_search() -> None:
    outcome = decide_point(parameters("1/50", "1"), all_sides=False)
    used = [name for name, found in outcome.decisions.items() if isinstance(found.proof, Recalled)]
    assert len(used) > 50


# --- near misses ----------------------------------------------------------------------------------

TWO, ROOT = as_term(2), symbol("root")
SQUARE = ROOT * ROOT <= TWO  # with equality, so that no enclosure decides


@pytest.mark.parametrize(
    ("need", "verdict"),
    [(as_term(1) < ROOT, REFUTED), (ROOT <= as_term(1), PROVED), (ROOT * ROOT < TWO, PROVED)],
)
def test_only_claims_that_enclosures_show_are_built_on(need, verdict) -> None:
    """A false claim is refuted or open: then the lie about the square is not believed."""
    kept = {SQUARE: Kept(REFUTED, (need,))}
    ground = RecallingGround(Session(), 128, 1024, kept)
    ground.define(Constant("root", "root", "root", "", sqrt(TWO)))
    assert ground.prove(SQUARE)[0] == verdict


def test_nothing_is_kept_that_rests_on_the_value_of_a_rounded_constant(monkeypatch) -> None:
    everything = keeping.kept()
    assert everything == theorem1.theorem().kept
    assert {found.verdict for found in everything.values()} == {PROVED}
    monkeypatch.setattr(keeping, "_numbers", lambda: {"phi_minus"})
    assert 0 < len(keeping.kept()) < len(everything)


@pytest.mark.usefixtures("a_new_process")
@pytest.mark.parametrize(
    ("old", "new"), [(b"\nkept\tproved\t", b"\nkept\trefuted\t"), (b"\t<=\t", b"\t<\t")]
)
def test_a_file_that_was_changed_is_not_read(old, new, tmp_path: Path, monkeypatch) -> None:
    content = Path(theorem1.COMPILED).read_bytes()
    assert old in content
    changed = tmp_path / "theorem1.txt"
    changed.write_bytes(content.replace(old, new, 1))
    monkeypatch.setattr(theorem1, "COMPILED", str(changed))
    assert theorem1.theorem().kept == {}
    assert UNDECIDED not in verdicts(parameters("3/100", "1"), "all", False).values()
