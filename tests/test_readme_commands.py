"""What the pages tell a reader to do is found, is done, and a wrong page is seen."""

from __future__ import annotations

import ast
import os
import re
import shlex
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType

import pytest

from tests.readme_commands import (
    FENCE,
    ROOT,
    Command,
    File,
    complaint,
    followed,
    is_shown,
    pages,
    session,
    steps_of,
    steps_of_cell,
    steps_on,
    to_run,
)
from verify.cli import COMMANDS, main


def steps() -> list[Command | File]:
    return [step for page in pages() for step in steps_on(page)]


#: What `.ci/run` does itself.
IN_CI = {"certify", "report"}


def test_every_command_is_run_on_some_page() -> None:
    lines = [step.line for step in steps() if isinstance(step, Command)]
    run = {line.split()[1] for line in lines if line.startswith("verify ")}
    hidden = COMMANDS.keys() - IN_CI - run
    assert not hidden, (
        f"{', '.join(sorted(hidden))}: show the command on a page, in a block that is run"
    )
    assert len([line for line in lines if line.startswith("python3 -I verify/check")]) >= 3
    assert any(isinstance(step, File) for step in steps())


def test_a_line_is_what_a_shell_can_run() -> None:
    page = "```sh\nverify map phi --out DIR  # x\nverify/coq/build /tmp\nverify check DIR\n```\n"
    first, second = steps_of(page)
    assert to_run(first, "/tmp/a b") == "verify map phi --out '/tmp/a b'"
    assert to_run(second, "x") == "verify check certificates/theorem1-r-3-100"


def test_a_session_has_files_outputs_and_exit_codes() -> None:
    page = (
        "```{code-block} toml\n:caption: a.toml\n\nr = 1\n```\n"
        "```console\n$ verify scene a.toml\none\ntwo\n$ echo $?\n3\n$ ls\n```\n"
    )
    file, first, second = steps_of(page)
    assert file == File("a.toml", "r = 1\n")
    assert first == Command("verify scene a.toml", 3, "one\ntwo\n")
    assert second == Command("ls", 0, "")


def test_a_notebook_has_files_commands_pictures_and_programs() -> None:
    assert list(steps_of_cell("%%writefile a.toml\nr = 1", "", "c.py")) == [File("a.toml", "r = 1")]
    assert list(steps_of_cell("!ls", "a\n", "c.py")) == [Command("ls", 0, "a\n")]
    assert list(steps_of_cell('SVG("a.svg")', "", "c.py")) == [Command("test -s a.svg")]
    program = [File("c.py", "print(1)"), Command("python c.py", 0, "1\n")]
    assert list(steps_of_cell("print(1)", "1\n", "c.py")) == program


@pytest.mark.parametrize(
    ("shown", "printed", "same"),
    [
        ("a\nb\n", "a\nb\n", True),
        ("a\n", "a\nb\n", False),
        ("a\n...\nd\n", "a\nb\nc\nd\n", True),
        ("a\n...\n", "a\nb\n", True),
        ("...\nb\n", "a\nb\n", True),
        ("...\nb\n", "a\nc\n", False),
        ("in 0... s\n", "in 0.5 s\n", True),
        ("a.b\n", "axb\n", False),
        ("", "", True),
        ("\n", "a\n", False),
    ],
)
def test_what_a_page_leaves_out(shown: str, printed: str, same: bool) -> None:
    assert is_shown(shown, printed) is same


def test_a_wrong_end_is_seen() -> None:
    command = Command("verify theorem1 --r 0.03 --constants printed", 1)
    assert complaint(command, 1, "") == ""
    assert "exit code 0" in complaint(command, 0, "")
    assert complaint(command, 1, "Traceback (most recent call last):\n") == "a traceback"
    assert complaint(command._replace(shown="a\n"), 1, "b\n") == "something else is shown"


@pytest.mark.parametrize(
    "page", sorted((ROOT / "docs/tutorials").glob("*.[mi]*")), ids=lambda p: p.name
)
def test_a_tutorial_shows_what_happens(page: Path, tmp_path: Path) -> None:
    path = f"{Path(sys.executable).parent}:{os.environ['PATH']}"
    assert not list(followed(page, tmp_path, {**os.environ, "PATH": path}))


# --- blocks that show what is not there yet ------------------------------------------------------

#: Pages with blocks that no reader can run as they stand, and why.
NOT_RUN = {
    "README.md": "it installs the package and the documentation: .ci/run does that",
    "certificates/README.md": "JSON, compared with the examples by tests/certificates",
    "docs/contributing/command.md": "a command that is added",
    "docs/contributing/function.md": "a function that is added",
    "docs/contributing/house.md": "it installs the package",
    "docs/contributing/row.md": "a row that is added",
    "docs/contributing/rule.md": "a rule that is added",
    "docs/contributing/technique.md": "a technique that is added",
    "docs/explanation/coq.md": "theorems, see below; .ci/coq runs the commands",
    "docs/howto/check.md": ".ci/coq runs the commands for Coq",
    "docs/howto/cite.md": "BibTeX",
    "docs/howto/dask.md": "it starts a cluster",
    "docs/tutorials/page-of-constants.md": "it installs the package",
    "docs/tutorials/referee.md": "it installs the package",
}
PATH_OF_COMMANDS = ROOT / "docs/contributing/command.md"


def blocks(page: Path) -> list[tuple[str, str]]:
    """The blocks of code on a page, each with its language."""
    if page.suffix != ".md":
        return []
    found = FENCE.findall(page.read_text(encoding="utf-8"))
    kinds = [(kind.removeprefix("{code-block} "), block) for _, kind, block in found]
    return [(kind, block) for kind, block in kinds if not kind.startswith("{")]


def test_every_other_block_is_run() -> None:
    left = set()
    for page in pages():
        found = FENCE.finditer(page.read_text(encoding="utf-8"))
        code = [m[0] + "\n" for m in found if not re.match(r"\{(?!code-block)", m[2])]
        if any(not list(steps_of(block)) for block in code):
            left.add(page.relative_to(ROOT).as_posix())
    assert left == NOT_RUN.keys()


def parsed(block: str) -> ast.Module:
    """A block as Python; an entry of a table stands for the table."""
    try:
        return ast.parse(block)
    except SyntaxError:
        return ast.parse(f"table = {{\n{block}\n}}")


def test_python_that_is_shown_can_be_read_and_imports_what_there_is() -> None:
    shown = [
        ast.walk(parsed(block))
        for page in pages()
        for kind, block in blocks(page)
        if kind == "python" and not block.startswith(":caption:")
    ]
    assert len(shown) >= 9
    imported = [node for nodes in shown for node in nodes if isinstance(node, ast.ImportFrom)]
    for node in imported:
        if node.module and node.module.startswith("verify"):
            module = import_module(node.module)
            assert {alias.name for alias in node.names} <= vars(module).keys(), node.module


def test_the_command_that_is_shown_works(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (_, code), (_, line), (_, shown) = blocks(PATH_OF_COMMANDS)[:3]
    module = ModuleType("verify.cli.glossary")
    exec(code, vars(module))
    monkeypatch.setitem(sys.modules, "verify.cli.glossary", module)
    for name, says in ast.literal_eval(f"{{{line}}}").items():
        monkeypatch.setitem(COMMANDS, name, says)
    for command in session(shown):
        code_found = main(shlex.split(command.line)[1:])
        printed = "".join(capsys.readouterr())
        assert is_shown(command.shown or "", printed), printed
        assert code_found == (2 if "--jsn" in command.line else 0)


#: The theorems on the page about Coq, in their order, by the folder whose file for Coq has them.
THEOREMS = ("theorem1-r-3-100", "scenes/parting", "scenes/nearly-aligned", "scenes/on-a-line")


def test_the_theorems_that_are_shown_are_those_of_the_files(
    capsys: pytest.CaptureFixture[str],
) -> None:
    page = blocks(ROOT / "docs/explanation/coq.md")
    shown = [" ".join(block.split()) for kind, block in page if kind == "coq"]
    shown = [block for block in shown if block.startswith("Theorem three_balls")]
    for folder, theorem in zip(THEOREMS, shown, strict=True):
        assert main(["export", "coq", "--balls", str(ROOT / "certificates" / folder)]) == 0
        file = capsys.readouterr().out.replace("Theorem1.B", "B")
        assert theorem in " ".join(file.split()), folder
