"""No command takes a twentieth more instructions of Python than `instructions.txt` says of it.

    python -m tests.measure.benchmarks.instructions            # exit code 1 if one does
    python -m tests.measure.benchmarks.instructions --write    # writes down what they take now

Instructions are counted one by one, so that the count does not depend on the machine or its load.
It depends on the version of Python, which the first line names: with another one nothing is
compared. What FLINT does is not counted; `ratios.py` measures all, more coarsely.
"""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.measure.benchmarks.ratios import grown

FIGURES = Path(__file__).with_name("instructions.txt")
#: How much more than the figure is too much.
TOLERANCE = 1.05
#: Later ones use what those before have written; POINT is a folder.
COMMANDS = (
    "theorem1 --r 0.03",
    "theorem1 --r 0.03 --out POINT",
    "check POINT",
    "theorem1 --all",
    "explain delta_1",
    "spectrum",
    "prove agm.toml",
    "scene in-space",
)
COUNTING = """
import sys
count = 0
def instruction(frame, event, argument):
    global count
    count += event == "opcode"
    return instruction
def enter(frame, event, argument):
    frame.f_trace_opcodes, frame.f_trace_lines = True, False
    return instruction
sys.settrace(enter)
from verify.cli import main
code = main(sys.argv[1:])
sys.settrace(None)
print("\\ninstructions", count, file=sys.stderr)
sys.exit(code)
"""


def version() -> str:
    """The Python that counts."""
    return f"{platform.python_implementation()} {platform.python_version()}"


def committed() -> tuple[str, dict[str, float]]:
    """The Python that has counted, and the figures by the commands."""
    first, *lines = FIGURES.read_text(encoding="utf-8").splitlines()
    pairs = (line.strip().partition("  ") for line in lines)
    return first, {name: float(count) for count, _, name in pairs}


def instructions(words: str, folder: str) -> int:
    """How many a command takes, in a folder.

    Raises:
        ValueError: if it fails.
    """
    environment = {**os.environ, "PYTHONHASHSEED": "0", "COLUMNS": "80"}
    command = [sys.executable, "-X", "utf8", "-c", COUNTING, *words.split()]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise ValueError(f"verify {words}: exit code {done.returncode}: {done.stderr}")
    return int(done.stderr.split()[-1])


def counted() -> dict[str, float]:
    """The instructions of each command."""
    with TemporaryDirectory() as folder:
        instructions("example agm", folder)
        return {f"verify {words}": instructions(words, folder) for words in COMMANDS}


def main(arguments: list[str]) -> int:
    """Count, and compare or write."""
    first, figures = committed()
    if arguments != ["--write"] and first != version():
        print(f"not counted: {FIGURES.name} is about {first}, and this is {version()}")
        return 0
    found = counted()
    text = "".join(f"{count:9d}  {name}\n" for name, count in found.items())
    if arguments == ["--write"]:
        FIGURES.write_text(f"{version()}\n{text}", encoding="utf-8")
        return 0
    complaints = grown(found, figures, TOLERANCE)
    print(text + "\n".join(complaints), end="\n" * bool(complaints))
    return bool(complaints)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
