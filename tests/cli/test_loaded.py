"""How much of the program two commands load: what a referee of their answers would have to read."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]

PROGRAM = """
import sys
from verify.cli import main
main(sys.argv[1:])
files = {m.__file__ for n, m in list(sys.modules.items()) if n.partition(".")[0] == "verify"}
print(*sorted(files), sep="\\n", file=sys.stderr)
"""


def loaded(*words: str) -> list[Path]:
    """The files of the program that are loaded when a command has ended."""
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, *words], capture_output=True, text=True, cwd=ROOT
    )
    return [Path(line) for line in done.stderr.splitlines() if line.endswith(".py")]


def lines(files: list[Path]) -> int:
    return sum(len(file.read_text(encoding="utf-8").splitlines()) for file in files)


NUMBERS = 'title = "t"\n[constants]\nq = "(3 - sqrt(5))/4"\n[rows]\nsmall = "q < 1/5"\n'
CONTEXT = (
    'slope = "2*(q + x) <= 1"\n[contexts.near]\nvariables = ["x"]\ngiven = ["-0.1 <= x <= 0.1"]\n'
)


@pytest.mark.parametrize(
    ("page", "most", "long"), [(NUMBERS, 60, 14_800), (NUMBERS + CONTEXT, 72, 16_700)]
)
def test_prove_loads_what_the_page_needs(page: str, most: int, long: int, tmp_path: Path) -> None:
    """Of the techniques those that it tries; nothing of the paper, nor of the spheres."""
    path = tmp_path / "page.toml"
    path.write_text(page)
    found = loaded("prove", str(path))
    assert 30 < len(found) <= most
    assert lines(found) <= long
    rooms = {file.relative_to(ROOT / "verify").parts[0] for file in found}
    assert not rooms & {"paper", "spheres", "measure"}


def test_a_point_of_theorem_1_loads_a_part_of_the_program() -> None:
    found = loaded("theorem1", "--r", "0.03")
    assert 30 < len(found) <= 46
    assert not {"tight.py", "clearing.py", "algebraic.py"} & {file.name for file in found}


def test_a_point_of_theorem_1_does_not_load_typing() -> None:
    """That took two milliseconds, a twentieth of the whole."""
    program = (
        "import sys; before = {*sys.modules}; from verify.cli import main; main(sys.argv[1:]); "
        "print(*{*sys.modules} - before, file=sys.stderr)"
    )
    words = (sys.executable, "-c", program, "theorem1", "--r", "0.03")
    found = subprocess.run(words, capture_output=True, cwd=ROOT).stderr.decode().split()
    assert "verify.prover.rules" in found
    assert "typing" not in found


def test_a_page_to_be_sent_needs_no_templates(tmp_path: Path) -> None:
    """Nor the plots, nor a library that finds files in archives: that took half of the time."""
    program = PROGRAM.partition("files =")[0] + "print(*sys.modules, file=sys.stderr)"
    words = ("theorem1", "--r", "0.03", "--out", str(tmp_path / "point"))
    done = subprocess.run([sys.executable, "-c", program, *words], capture_output=True, cwd=ROOT)
    found = set(done.stderr.decode().split())
    assert (tmp_path / "point/report.html").exists()
    assert "verify.views.page.single" in found
    assert not found & {"jinja2", "markupsafe", "importlib.resources", "verify.views.plots"}
