"""The committed examples are accepted, cover the format, and are what the documentation shows."""

import copy
import hashlib
import json
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from docs.generated import rules
from tests.certificates import flow
from verify import check

ROOT = Path(__file__).parents[2]
CERTIFICATES = ROOT / "certificates"
EXAMPLES = sorted(path for path in (CERTIFICATES / "examples").iterdir() if path.is_dir())
NAMES = [path.name for path in EXAMPLES]
TABLES = (check.RULES, check.DEFINING, check.APPLYING, check.REPEATING, check.FAILING)


def load(path: Path) -> Any:
    return json.loads(path.read_text(encoding="utf-8"))


def objects(value: Any) -> Iterator[dict[str, Any]]:
    """All objects in a document."""
    if isinstance(value, dict):
        yield value
    for item in value.values() if isinstance(value, dict) else value:
        if isinstance(item, dict | list):
            yield from objects(item)


def lists(value: Any) -> Iterator[list[Any]]:
    """All lists in a document."""
    if isinstance(value, list):
        yield value
    for item in value.values() if isinstance(value, dict) else value:
        if isinstance(item, dict | list):
            yield from lists(item)


def report(*paths: Path) -> tuple[int, list[str]]:
    return check.check_folders(check.read_folders([str(path) for path in paths]))


def verdict(folder: Path, certificate: Any) -> str:
    """What is said of a statement with another certificate."""
    cited = [path.read_bytes() for path in (folder / "cited").glob("*")]
    available = {hashlib.sha256(data).hexdigest(): data for data in cited}
    data = (folder / "statement.json").read_bytes()
    try:
        return check.check(data, json.dumps(certificate).encode(), available).verdict
    except check.Malformed:
        return "MALFORMED"


@pytest.mark.parametrize("name", NAMES)
def test_example_is_accepted(name: str) -> None:
    command = [sys.executable, "-I", str(ROOT / "verify" / "check.py"), name]
    run = subprocess.run(command, capture_output=True, text=True, cwd=CERTIFICATES / "examples")
    assert (run.returncode, run.stderr) == (0, "")
    assert run.stdout.splitlines()[-1].startswith("PROVED: ")


#: The examples that were written by hand, and not found for a page of constants.
BY_HAND = [path.name for path in EXAMPLES if not path.with_suffix(".toml").exists()]


@pytest.mark.parametrize("name", [name for name in BY_HAND if name != "flow"])
def test_every_step_is_needed(name: str) -> None:
    folder = CERTIFICATES / "examples" / name
    certificate = load(folder / "certificate.json")
    assert verdict(folder, certificate) == "PROVED"
    for i in range(len(certificate["steps"])):
        less = copy.deepcopy(certificate)
        step = less["steps"].pop(i)
        assert verdict(folder, less) in ("REFUSED", "MALFORMED"), step


def test_every_rule_has_an_example() -> None:
    used = {
        found["rule"]
        for folder in EXAMPLES
        for found in objects(load(folder / "certificate.json"))
        if "rule" in found
    }
    assert used == {rule for table in TABLES for rule in table}


def test_every_step_has_an_example() -> None:
    steps = [step for folder in EXAMPLES for step in load(folder / "certificate.json")["steps"]]
    assert {kind for step in steps for kind in step if kind in check.STEPS} == {*check.STEPS}


def test_every_list_has_an_example() -> None:
    expected = {*check.ARITY_OR_MORE, *check.INDEXED, *check.VALUES, *check.NEGATION}
    expected |= {"applies", "always"}
    expected -= {"!="}
    files = [load(path) for folder in EXAMPLES for path in folder.glob("*.json")]
    heads = [found[0] for file in files for found in lists(file) if found]
    assert expected <= {head for head in heads if isinstance(head, str)}


def test_every_verdict_and_kind_has_an_example() -> None:
    statements = [load(folder / "statement.json") for folder in EXAMPLES]
    rows = [row for statement in statements for row in statement["obligations"]]
    contexts = [context for statement in statements for context in statement["contexts"]]
    assert {row["verdict"] for row in rows} == {"proved", "refuted", "undecided"}
    kinds = {given["kind"] for context in contexts for given in context["givens"]}
    assert kinds == {"plain", "carried", "standing"}
    assert any(context["parent"] for context in contexts)


@pytest.mark.parametrize("name", NAMES)
def test_example_is_called_as_its_folder(name: str) -> None:
    assert load(CERTIFICATES / "examples" / name / "statement.json")["theorem"] == name


def test_citation_is_open_alone_and_closed_together(tmp_path: Path) -> None:
    mean, stored = (CERTIFICATES / "examples" / name for name in ("mean", "mean-applied"))
    for name in ("statement", "certificate"):
        copied = stored / "cited" / f"mean{'.certificate' * (name == 'certificate')}.json"
        assert copied.read_bytes() == (mean / f"{name}.json").read_bytes()
    code, lines = report(stored)
    assert (code, lines[-1].endswith("; given nothing")) == (0, True)
    applied = tmp_path / "applied"
    shutil.copytree(stored, applied)
    (applied / "cited" / "mean.certificate.json").unlink()
    digest = hashlib.sha256((mean / "statement.json").read_bytes()).hexdigest()
    code, lines = report(applied)
    assert (code, lines[-1].partition(":")[0]) == (3, "UNDECIDED")
    assert lines[-1].endswith(f"; citing mean, which is not proved here ({digest})")
    for folders in ([mean, applied], [applied, mean]):
        code, lines = report(*folders)
        last = [line for line in lines if line.startswith("PROVED")]
        assert code == 0
        assert len(last) == 2
        assert all(line.endswith("; given nothing") for line in last)
        assert not any(digest in line for line in last)


def test_flow_is_what_its_script_writes(tmp_path: Path) -> None:
    flow.main(str(tmp_path))
    for name in ("statement.json", "certificate.json"):
        committed = CERTIFICATES / "examples" / "flow" / name
        assert (tmp_path / name).read_bytes() == committed.read_bytes()


@pytest.mark.parametrize("hits", [(1, 2, 2), (2, 1), (1, 1)])
def test_flow_in_another_order_is_refused(tmp_path: Path, monkeypatch: Any, hits: Any) -> None:
    monkeypatch.setattr(flow, "HITS", hits)
    flow.main(str(tmp_path))
    code, lines = report(tmp_path)
    assert code == 1
    assert lines[-1].startswith("REFUSED")


# --- the documentation ---------------------------------------------------------------------------

README = (CERTIFICATES / "README.md").read_text(encoding="utf-8")


def test_readme_shows_the_committed_example() -> None:
    shown = re.findall(r"<!-- (\S+) -->\n```json\n(.*?)```", README, re.DOTALL)
    names = ["examples/instance/statement.json", "examples/instance/certificate.json"]
    assert [path for path, _ in shown] == names
    for path, text in shown:
        assert (CERTIFICATES / path).read_text(encoding="utf-8") == text


def test_rules_are_shown_as_the_prover_has_them() -> None:
    for path, text in rules().items():
        assert path.read_text(encoding="utf-8") == text, "run `python docs/generated.py`"


def test_readme_links_to_what_is_there() -> None:
    links = re.findall(r"\]\(([^)#]+)\)", README)
    assert links
    assert all((CERTIFICATES / link).exists() for link in links)
    assert {link.partition("/")[2] for link in links} >= {*NAMES}


def test_readme_has_every_rule_with_its_fields() -> None:
    described = dict(re.findall(r"^\*\*`(\w+)`\*\* `\{(.*?)\}`", README, re.MULTILINE))
    assert described.keys() == {rule for table in TABLES for rule in table}
    fields = {
        rule: {key for key in found if key != "rule"}
        for folder in EXAMPLES
        for step in load(folder / "certificate.json")["steps"]
        for found in objects(step)
        if (rule := found.get("rule")) and not (rule == "instance" and "of" not in found)
    }
    assert {rule: {*re.findall(r"\w+", text)} for rule, text in described.items()} == fields
