"""The commands that README.md, certificates/README.md and docs/ show, run as a reader runs them.

Run this file with any Python: it makes a virtual environment, installs the package there without an
extra, and runs the commands in a copy of the repository. It fails on an exit code or an output that
the page does not show, and on a traceback.

In a block ``sh`` the lines that begin with ``verify`` or ``python3 -I`` are run; a comment may say
``exit code 1``. A block ``console`` is a session: each line ``$ command`` is run, and has to print
the lines below it, where a line ``...`` stands for any lines and ``...`` in a line for any text;
``$ echo $?`` shows the exit code of the command before. A block ``code-block`` with a caption is a
file of that name, which the reader writes. The sessions of a page share one folder, in which
``certificates`` and ``verify`` are those of the repository. A notebook is run without Jupyter: its
commands, its files, its programs, and that the pictures which it shows are there.
"""

from __future__ import annotations

import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent
PAGES = ("README.md", "certificates/README.md")
#: What stands for a file or a folder in the text.
PLACES = {
    "STATEMENT.json": "certificates/examples/mean/statement.json",
    "DIR": "certificates/theorem1-r-3-100",
}
#: A short form of what takes minutes.
DIAGRAM = "verify map diagram.toml --x r --y t --out diagram"
SHORT = {
    "verify bench": "verify bench --quick",
    "verify stress": "verify stress --quick",
    DIAGRAM: f"{DIAGRAM} --undecided 30%",
}
SECONDS = 600
FENCE = re.compile(r"^(`{3,})(.*)\n((?:.*\n)*?)\1\s*$", re.MULTILINE)


class File(NamedTuple):
    """A file that the reader of a page writes."""

    name: str
    text: str


class Command(NamedTuple):
    """A line for a shell, the exit code that the page says, and what it shows, if it shows it."""

    line: str
    code: int = 0
    shown: str | None = None


Step = File | Command


def pages() -> list[Path]:
    """The pages whose commands are run."""
    found = [path for kind in ("*.md", "*.ipynb") for path in sorted((ROOT / "docs").rglob(kind))]
    return [*(ROOT / page for page in PAGES), *found]


def steps_on(page: Path) -> Iterator[Step]:
    """What a reader of a page or of a notebook does, in order."""
    text = page.read_text(encoding="utf-8")
    if page.suffix != ".ipynb":
        yield from steps_of(text)
        return
    for number, cell in enumerate(json.loads(text)["cells"]):
        if cell["cell_type"] == "code":
            shown = "".join(output.get("text", "") for output in cell["outputs"])
            yield from steps_of_cell(cell["source"], shown, f"cell-{number}.py")


def steps_of_cell(source: str, shown: str, name: str) -> Iterator[Step]:
    """A cell is a file with its content, a command, a picture, or else a program."""
    picture = re.search(r'^SVG\("(.*)"\)$', source, re.MULTILINE)
    if source.startswith("%%writefile "):
        file, _, content = source.removeprefix("%%writefile ").partition("\n")
        yield File(file, content)
    elif source.startswith("!"):
        yield Command(source[1:], shown=shown)
    elif picture:
        yield Command(f"test -s {picture[1]}")
    else:
        yield File(name, source)
        yield Command(f"python {name}", shown=shown)


def steps_of(text: str) -> Iterator[Step]:
    """What a reader of one page does, in order."""
    for _, kind, block in FENCE.findall(text):
        caption = re.match(r":caption: (\S+)\n+", block)
        if kind.startswith("{code-block}") and caption:
            yield File(caption[1], block[caption.end() :])
        elif kind == "console":
            yield from session(block)
        elif not kind.startswith("{"):
            yield from commands_of(block)


def session(block: str) -> Iterator[Command]:
    """The commands of a session with what they print."""
    parts = [part.split("\n", 1) for part in re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]]
    for number, (line, shown) in enumerate(parts):
        following = parts[number + 1] if number + 1 < len(parts) else ["", ""]
        code = int(following[1]) if following[0] == "echo $?" else 0
        if line != "echo $?":
            yield Command(line, code, shown)


def commands_of(block: str) -> Iterator[Command]:
    """The command lines of a block that shows no output."""
    for whole in block.splitlines():
        line, _, comment = whole.partition("#")
        line = line.strip()
        if re.match(r"verify |python3 -I ", line):
            code = re.search(r"exit code ([0-9])", comment)
            yield Command(SHORT.get(line, line), int(code[1]) if code else 0)


def to_run(command: Command, folder: str) -> str:
    """The line, with a new folder after --out, and files that are there."""
    line = command.line.replace("--out DIR", f"--out {shlex.quote(folder)}")
    for word, place in PLACES.items():
        line = re.sub(rf"(?<=\s){re.escape(word)}(?=\s|$)", place, line)
    return line


def is_shown(shown: str, printed: str) -> bool:
    """Whether a page shows what was printed, with ``...`` for what it leaves out."""
    parts = re.split(r"^\.\.\.\n|\.\.\.", shown.rstrip("\n"), flags=re.MULTILINE)
    whole = ".*".join(map(re.escape, parts))
    return re.fullmatch(whole, printed.rstrip("\n"), re.DOTALL) is not None


def complaint(command: Command, code: int, printed: str) -> str:
    """What is wrong with how a command ended; nothing if it is right."""
    if "Traceback" in printed:
        return "a traceback"
    if code != command.code:
        return f"exit code {code}, and {command.code} is said"
    wrong = command.shown is not None and not is_shown(command.shown, printed)
    return "something else is shown" if wrong else ""


def followed(page: Path, place: Path, environment: Mapping[str, str]) -> Iterator[str]:
    """Does what a page says, in an empty folder; yields what goes wrong."""
    for name in ("certificates", "verify"):
        (place / name).symlink_to(ROOT / name)
    for number, step in enumerate(steps_on(page)):
        if isinstance(step, File):
            (place / step.name).write_text(step.text, encoding="utf-8")
            continue
        start = time.monotonic()
        done = subprocess.run(
            ["sh", "-c", to_run(step, str(place / f"out-{number}"))],
            cwd=place,
            env={**environment, "COLUMNS": "88"},
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            timeout=SECONDS,
            check=False,
        )
        print(f"{time.monotonic() - start:6.1f} s  {step.line}", flush=True)
        found = complaint(step, done.returncode, done.stdout)
        if found:
            yield f"{page.relative_to(ROOT)}: {step.line}: {found}:\n{done.stdout[-3000:]}"


def installed(place: Path) -> dict[str, str]:
    """An environment with the package and nothing else, made from a copy of the repository."""
    left_out = shutil.ignore_patterns(
        ".git", ".venv", "__pycache__", ".*_cache", "*.egg-info", "build"
    )
    shutil.copytree(ROOT, place / "copy", symlinks=True, ignore=left_out)
    subprocess.run([sys.executable, "-m", "venv", str(place / "bare")], check=True)
    pip = [str(place / "bare/bin/python"), "-m", "pip", "install", "-q", "."]
    subprocess.run(pip, cwd=place / "copy", check=True)
    kept = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    return kept | {"PATH": f"{place / 'bare/bin'}:{os.environ['PATH']}"}


def main() -> int:
    """Follow every page; return 1 if one of them does not say what happens."""
    wrong = 0
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        environment = installed(place)

        def complaints(number: int, page: Path) -> list[str]:
            folder = place / f"page-{number}"
            folder.mkdir()
            return list(followed(page, folder, environment))

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for found in pool.map(complaints, *zip(*enumerate(pages()), strict=True)):
                wrong += len(found)
                print(*found, sep="\n", end="\n" * bool(found), file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
