"""Every command line of the README, where nothing but the package itself is installed.

Run this file with any Python: it makes a virtual environment, installs the package there without an
extra, and runs the commands in a copy of the repository. It fails on an exit code that the README
does not say, and on a traceback.
"""

from __future__ import annotations

import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
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
SHORT = {"verify bench": "verify bench --quick", "verify stress": "verify stress --quick"}
SECONDS = 600


class Command(NamedTuple):
    """A line for a shell, and the exit code that the page says."""

    line: str
    code: int


def commands() -> list[Command]:
    """The command lines of the pages, each once, in their order."""
    texts = ((ROOT / page).read_text(encoding="utf-8") for page in PAGES)
    return list(dict.fromkeys(command for text in texts for command in commands_of(text)))


def commands_of(text: str) -> Iterator[Command]:
    """The command lines in the blocks of one page."""
    for block in re.findall(r"^```\w*\n(.*?)^```", text, re.MULTILINE | re.DOTALL):
        for line in block.splitlines():
            line, _, comment = line.removeprefix("$ ").partition("#")
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


def complaint(command: Command, code: int, err: str) -> str:
    """What is wrong with how a command ended; nothing if it is right."""
    if "Traceback" in err:
        return "a traceback"
    return "" if code == command.code else f"exit code {code}, and {command.code} is said"


def installed(place: Path) -> dict[str, str]:
    """A copy of the repository, and the environment with the package and nothing else."""
    left_out = shutil.ignore_patterns(".git", ".venv", "__pycache__", ".*_cache", "*.egg-info")
    shutil.copytree(ROOT, place / "copy", symlinks=True, ignore=left_out)
    subprocess.run([sys.executable, "-m", "venv", str(place / "bare")], check=True)
    pip = [str(place / "bare/bin/python"), "-m", "pip", "install", "-q", "."]
    subprocess.run(pip, cwd=place / "copy", check=True)
    kept = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    return kept | {"PATH": f"{place / 'bare/bin'}:{os.environ['PATH']}"}


def main() -> int:
    """Run every command; return 1 if one of them does not do what is said."""
    wrong = 0
    with tempfile.TemporaryDirectory() as name:
        place = Path(name)
        environment = installed(place)
        for number, command in enumerate(commands()):
            line = to_run(command, str(place / f"out-{number}"))
            start = time.monotonic()
            done = subprocess.run(
                ["sh", "-c", line],
                cwd=place / "copy",
                env=environment,
                capture_output=True,
                text=True,
                timeout=SECONDS,
                check=False,
            )
            found = complaint(command, done.returncode, done.stderr)
            print(f"{time.monotonic() - start:6.1f} s  {command.line}", flush=True)
            if found:
                wrong += 1
                print(f"{found}: {command.line}\n{done.stderr[-2000:]}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
