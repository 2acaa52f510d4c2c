"""No command prints a verdict that no judge has given: every judge is broken, all commands run."""

from __future__ import annotations

import ast
import gc
import re
import shutil
from collections.abc import Iterator
from functools import _lru_cache_wrapper, cache
from pathlib import Path
from typing import Any

import pytest

from tests.points import parameters
from verify import check, check_map
from verify.cli import COMMANDS, main
from verify.language.errors import OwnError
from verify.language.statement import PROVED, UNDECIDED, Obligation, Statement
from verify.language.terms import Claim, as_term
from verify.paper.commands import pages
from verify.paper.commands.theorem1 import decide_point
from verify.prover.ground import Ground
from verify.prover.straight import StraightLine
from verify.spheres import limit_map, separatrix
from verify.spheres.flow.follow import Flow, UnclearError
from verify.spheres.limit_map import Orbits
from verify.spheres.many.queue import Queue
from verify.spheres.scene import decide as scene
from verify.wire import packaged

ROOT = Path(__file__).resolve().parents[2]
#: What nobody may say without a judge.
VERDICT = re.compile(
    r"\b(?:(?<!not )proved|PROVED|collapses|disperses)\b|^(?:finite|rests:|followed:)"
    r"|\"(?:finite|rests|followed)\"",
    re.MULTILINE,
)
#: A heading before numbers, which are 0 then.
SHARES = re.compile(r"^Rows proved, of those needed:(?!.* [1-9][0-9]*/)", re.MULTILINE)
POINT = "--r 0.03"

#: What rests on a written proof, which the checker judges.
WRITTEN = (
    "classification",
    "classification --r 0.05",
    "classification --json",
    "classification --rows ratio-falls",
    "elsewhere",
    "elsewhere --json",
    "separatrix --all",
    "separatrix --all --json",
    "separatrix --r 0.03 --at 1/10 --out OUT",
    "theorem1 --all",
    "theorem1 --all --constants printed",
    "theorem1 --r 0.02..0.03",
    "theorem1 --r 0.02..0.03 --json",
    f"theorem1 {POINT} --out OUT",
    "prove certificates/examples/instance/statement.json",
    "prove certificates/examples/cosine/statement.json --json",
    "prove certificates/examples/fista.toml",
    "prove certificates/examples/alpha-theory.toml --out OUT/page",
    "check certificates/step",
    "check certificates/sharper --json",
    "check certificates/classification --statement",
    "check certificates/flow --latex",
    "explain certificates/sharper impact-energy",
    "export coq certificates/examples/instance",
    "report --compare",
    "certify --compare",
    "scene certificates/scenes/passing.toml --out OUT",
)
#: What rests on a certificate that comes with the program: the checker has judged it before, and
#: its digests are compared.
SHIPPED = (
    "spectrum",
    "spectrum --r 0.1",
    "spectrum --json",
    "explain step impact-energy",
    "explain sharper impact-energy",
)
#: What a named decision procedure judges.
DECIDED = (
    f"theorem1 {POINT}",
    f"theorem1 {POINT} -v",
    f"theorem1 {POINT} --json",
    "theorem1 --r 0.02..0.04 --steps 3",
    "theorem1 --r 0.02..0.04 --steps 3 --json",
    *(
        f"scene certificates/scenes/{name}.toml"
        for name in ("passing", "parting", "nearly-aligned")
    ),
    "scene certificates/scenes/on-a-line.toml --json",
    "scene SCENES",
    "scene SCENES --json",
    "scene SCENES --csv OUT/scenes.csv",
    "scene certificates/scenes/passing.toml --sample 3",
    "scene certificates/scenes/passing.toml --sample 3 --json",
    "scene many.toml",
    "scene many.toml --until 1/4",
    "scene many.toml --json --csv OUT/events.csv",
    "stress --quick",
    "map phi --r 0.03 --undecided 20%",
    "separatrix --r 0.03",
    "separatrix --r 0.03 --at 1/10 --json",
    "separatrix --r 0.08",
    "separatrix --r 0.03..0.09 --steps 3",
    "separatrix --r 0.03..0.09 --steps 3 --json",
    "separatrix --r 0.03 --plot OUT/strip.svg",
)
#: Five beads, of which three collapse.
MANY = """
r = 0.03
positions = [[0], [1.2], [2.5], [4], [5.3]]
velocities = [[1], [0.3], [0], [-0.2], [-1]]
"""
#: Commands that print no verdict.
SILENT = {
    "example": "names, and files as they are",
    "bench": "speeds and errors; its verdicts are those of plain doubles, called wrong",
}


@pytest.fixture(autouse=True)
def anew(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Nothing that was decided before is remembered, neither by this test nor by later ones."""
    monkeypatch.chdir(ROOT)
    monkeypatch.setenv("COLUMNS", "99999")
    _forget()
    yield
    monkeypatch.undo()
    _forget()


def _forget() -> None:
    for found in gc.get_objects():
        if isinstance(found, _lru_cache_wrapper) and found.__module__.startswith("verify."):
            found.cache_clear()


def break_checker(monkeypatch: pytest.MonkeyPatch) -> None:
    """Afterwards both checkers refuse whatever they are shown."""

    def refuse(*_: Any, **__: Any) -> Any:
        raise check.Refused("a judge that decides nothing")

    def refuse_log(*_: Any, **__: Any) -> Any:
        raise check_map.RefusedError("a judge that decides nothing")

    monkeypatch.setattr(check, "STEP", dict.fromkeys(check.STEP, refuse))
    monkeypatch.setattr(check_map, "check_log", refuse_log)


def break_digests(monkeypatch: pytest.MonkeyPatch) -> None:
    """Afterwards no file that comes with the program has the digest of one that was checked."""
    for name, files in packaged.PACKAGED_FILES.items():
        others = dict.fromkeys(files, "0" * 64)
        monkeypatch.setitem(packaged.PACKAGED_FILES, name, others)


def break_procedures(monkeypatch: pytest.MonkeyPatch) -> None:
    """Afterwards balls, exact numbers and algebra decide nothing at a point, nor on a scene."""

    def unclear(_: Flow | Queue) -> bool:
        raise UnclearError("a judge that decides nothing")

    monkeypatch.setattr(Ground, "prove", lambda *_: (UNDECIDED, None))
    monkeypatch.setattr(StraightLine, "verdict", lambda *_: "0")
    monkeypatch.setattr(Flow, "advance", unclear)
    monkeypatch.setattr(Queue, "first", unclear)
    monkeypatch.setattr(Orbits, "side", lambda *_: 0)
    monkeypatch.setattr(separatrix, "has_separatrix", lambda *_: None)
    monkeypatch.setattr(limit_map, "changes_sign", lambda *_: False)
    for name in ("find_collapse", "finitely_many", "follow_line"):
        monkeypatch.setattr(scene, name, lambda *_: None)


def said(words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> tuple[int, str]:
    """The exit code of a command, and what it prints and writes."""
    scenes, out = tmp_path / "scenes", tmp_path / "out"
    scenes.mkdir()
    out.mkdir()
    shutil.copy(ROOT / "certificates/scenes/passing.toml", scenes)
    many = tmp_path / "many.toml"
    many.write_text(MANY)
    places = {"SCENES": str(scenes), "OUT": str(out), "many.toml": str(many)}
    for place, path in places.items():
        words = words.replace(place, path)
    code = main(words.split())
    files = (path for path in out.rglob("*") if path.is_file())
    text = "\n".join([capsys.readouterr().out, *(path.read_text() for path in files)])
    return code, SHARES.sub("", text)


def test_every_command_is_here() -> None:
    """A new command prints a verdict that some judge gives, or is listed as silent."""
    tried = {words.split()[0] for words in (*WRITTEN, *SHIPPED, *DECIDED)}
    missing = set(COMMANDS) - tried - SILENT.keys()
    assert not missing, (
        f"{', '.join(sorted(missing))}: if it prints verdicts, add words that run it to WRITTEN, "
        "SHIPPED or DECIDED; if not, add its name to SILENT, with what it prints"
    )
    assert tried | SILENT.keys() <= set(COMMANDS)


@pytest.mark.parametrize("words", WRITTEN)
def test_what_rests_on_a_proof_is_not_said_without_the_checker(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    break_checker(monkeypatch)
    code, text = said(words, tmp_path, capsys)
    assert code != 0
    assert VERDICT.search(text) is None, text


@pytest.mark.parametrize("words", SHIPPED)
def test_what_comes_with_the_program_is_not_said_without_its_digests(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    break_digests(monkeypatch)
    try:
        code, text = said(words, tmp_path, capsys)
    except OwnError:
        return
    assert code != 0
    assert VERDICT.search(text) is None, text


@pytest.mark.parametrize("words", [*WRITTEN, *DECIDED])
def test_nothing_is_said_without_judges(
    words: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    break_checker(monkeypatch)
    break_procedures(monkeypatch)
    code, text = said(words, tmp_path, capsys)
    assert code != 0
    assert VERDICT.search(text) is None, text


def test_the_words_are_found_where_the_judges_work(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Otherwise the tests above would see nothing."""
    for number, words in enumerate((WRITTEN[0], DECIDED[0], DECIDED[5], DECIDED[6])):
        (tmp_path / str(number)).mkdir()
        code, text = said(words, tmp_path / str(number), capsys)
        assert code == 0
        assert VERDICT.search(text) is not None, text


# --- a false line ---------------------------------------------------------------------------------


@pytest.mark.parametrize("more", ["", "--json", "--rows ratio-falls", "-v", "--out OUT"])
def test_a_false_line_of_a_page_is_undecided(
    more: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """The ratio falls if 2√r <= 1 + r; with another hundred on the left that is false."""
    honest = pages.page("classification")

    def falsified(claim: Claim) -> Claim:
        return Claim(claim.relation, claim.lhs + 100, claim.rhs)

    def changed(item: Any) -> Any:
        named = getattr(item, "name", "") == "ratio-falls"
        return item._replace(claim=falsified(item.claim)) if named else item

    rows = tuple(map(changed, honest.statement.obligations))
    assert rows != honest.statement.obligations
    chapters = tuple(c._replace(items=tuple(map(changed, c.items))) for c in honest.chapters)
    statement = honest.statement._replace(obligations=rows)
    lie = honest._replace(statement=statement, chapters=chapters)
    monkeypatch.setattr(pages, "page", lambda _: lie)
    monkeypatch.setattr(pages, "became", lambda _name, _text: None)  # its text was changed
    for known in (pages.decide, pages.accepted, pages.statement):
        monkeypatch.setattr(pages, known.__name__, cache(known.__wrapped__))
    code, text = said(f"classification {more}", tmp_path, capsys)
    assert code == 3
    assert "Verdict: proved" not in text


# --- who makes judgements -------------------------------------------------------------------------

#: Each record that has a verdict, and the modules that may make it.
JUDGES = {
    "Judgement": {"wire/judge.py", "paper/commands/citing.py", "prover/ground.py"},
    "Fate": {"spheres/scene/decide.py"},
    "ScannedPoint": {"paper/commands/scan.py"},
    "CurveAt": {"spheres/limit_map.py"},
    "Separatrix": {"spheres/separatrix.py"},
    "Ending": {"spheres/many/decide.py"},
}


def test_only_judges_make_judgements() -> None:
    """Nor does anybody put one into what exists: ``judged=`` is written by the judges only."""
    makers: dict[str, set[str]] = {name: set() for name in JUDGES}
    for path in (ROOT / "verify").rglob("*.py"):
        where = path.relative_to(ROOT / "verify").as_posix()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call):
                name = getattr(node.func, "id", getattr(node.func, "attr", ""))
                if name in makers:
                    makers[name].add(where)
                given = [k.value for k in node.keywords if k.arg == "judged"]
                if any(not (isinstance(v, ast.Constant) and v.value is None) for v in given):
                    makers["Judgement"].add(where)
    assert makers == JUDGES


def test_a_claim_without_a_judge_is_undecided() -> None:
    draft = pages.decide("classification").draft
    assert draft.claimed == PROVED
    assert draft.verdict == UNDECIDED
    assert {found.verdict for found in draft.decisions.values()} == {UNDECIDED}


def test_a_judgement_is_about_the_claim_that_was_judged() -> None:
    """Another claim, another place, or other meanings of the names in it: nobody has judged it."""
    found = pages.decide("classification")
    statement = found.statement
    name, context = "ratio-falls", statement.contexts[0]
    row = next(row for row in statement.obligations if row.name == name)
    assert found.decisions[name].verdict == PROVED

    def changed(new: Obligation) -> Statement:
        rows = tuple(new if old.name == name else old for old in statement.obligations)
        return statement._replace(obligations=rows)

    false = Claim(row.claim.relation, row.claim.lhs + 100, row.claim.rhs)
    assert found._replace(statement=changed(row._replace(claim=false))).verdict == UNDECIDED
    assert found._replace(statement=changed(row._replace(context=None))).verdict == UNDECIDED
    assert found._replace(statement=changed(row._replace(says="the same"))).verdict == PROVED
    wider = (context._replace(givens=context.givens[1:]), *statement.contexts[1:])
    assert found._replace(statement=statement._replace(contexts=wider)).verdict == UNDECIDED
    other = next(n for n, d in found.decisions.items() if n != name and d.verdict == PROVED)
    swapped = {**found.decisions, name: found.decisions[other]}
    assert found._replace(decisions=swapped).verdict == UNDECIDED


def test_a_judgement_at_a_point_is_about_that_point() -> None:
    first, second = (decide_point(parameters(r, "1")) for r in ("3/100", "1/2"))
    assert first.verdict == PROVED
    for statement in (second.statement, first.statement._replace(parameters={"r": as_term(1)})):
        assert first._replace(statement=statement).verdict == UNDECIDED
