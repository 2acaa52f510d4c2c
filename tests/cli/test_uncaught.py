"""Whatever nobody catches is one line and code 5, and an interrupt is one line and code 130."""

from __future__ import annotations

import random
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from verify import check, check_map
from verify.language.interrupts import held

ROOT = Path(__file__).resolve().parents[2]
CERTIFICATE = ROOT / "certificates" / "step"
COMMANDS = (["-m", "verify"], ["-c", "from verify.__main__ import run; run()"])


def with_memory(mebibytes: int) -> Callable[[], None]:
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (mebibytes << 20,) * 2)


@pytest.mark.parametrize("command", COMMANDS)
@pytest.mark.parametrize(
    ("how", "says"),
    [
        ("raise MemoryError", "memory"),
        ("raise RecursionError", "too deeply"),
        ("raise KeyError('a\\nb')", "KeyError"),
        ("raise SystemExit(1)", "SystemExit"),
    ],
)
@pytest.mark.parametrize("where", ["run", "import"])
def test_an_error_that_nobody_expects(
    tmp_path: Path, command: list[str], how: str, says: str, where: str
) -> None:
    """It is raised by a command, or while that is imported."""
    hook = {
        "run": f"""
import verify.cli.scene
def failing(_):
    {how}
verify.cli.scene.run = failing
""",
        "import": f"""
import sys
class Fails:
    def find_spec(self, name, *_):
        if name == "verify.cli.scene":
            {how}
sys.meta_path.insert(0, Fails())
""",
    }
    (tmp_path / "sitecustomize.py").write_text(hook[where])
    done = subprocess.run(
        [sys.executable, *command, "scene", "a.toml"],
        capture_output=True,
        text=True,
        cwd=ROOT,
        env={"PYTHONPATH": f"{tmp_path}:{ROOT}"},
        check=False,
    )
    assert (done.returncode, done.stdout) == (5, "")
    assert done.stderr.count("\n") == 1
    assert says in done.stderr


@pytest.mark.parametrize("memory", [25, 40])
def test_too_little_memory_to_load_a_library(memory: int) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "verify", "theorem1", "--r", "0.03"],
        capture_output=True,
        text=True,
        cwd=ROOT,
        preexec_fn=with_memory(memory),
        check=False,
    )
    assert (done.returncode, done.stderr.count("\n")) == (5, 1)


@pytest.mark.parametrize("program", [check, check_map])
def test_a_checker_without_memory_gives_no_verdict(program: object, tmp_path: Path) -> None:
    path = tmp_path / "log"
    path.write_bytes(b"[" + b"1," * (1 << 23))
    file = str(program.__file__)  # type: ignore[attr-defined]
    target = str(CERTIFICATE if program is check else path)
    found = set()
    for memory in (26, 32, 40):
        done = subprocess.run(
            [sys.executable, "-I", file, target],
            capture_output=True,
            text=True,
            preexec_fn=with_memory(memory),
            check=False,
        )
        found.add(done.returncode)
        assert done.returncode != 1
        assert done.stderr.count("\n") <= 1
    assert 5 in found


def test_interrupts_at_any_time() -> None:
    """Forty processes, of which each gets one SIGINT at a random time while it loads and proves."""
    words = [sys.executable, "-m", "verify", "theorem1", "--r", "0.03", "--json"]
    begin = time.monotonic()
    subprocess.run(words, capture_output=True, cwd=ROOT, check=True)
    whole, draw = time.monotonic() - begin, random.Random(40)
    for _ in range(40):
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT)
        time.sleep(draw.uniform(0.3, 1) * whole)
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        if process.returncode == 130:
            assert err == b"verify: interrupted\n"
        elif process.returncode == -signal.SIGINT:  # before the first line of the program
            assert b"verify/" not in err
        else:
            assert process.returncode == 0
            assert out


@pytest.mark.parametrize(
    ("sign", "code", "says"),
    [(signal.SIGINT, 130, "interrupted"), (signal.SIGTERM, 143, "terminated")],
)
def test_a_search_that_is_ended(tmp_path: Path, sign: int, code: int, says: str) -> None:
    """One line on stderr tells it, wherever the search is; what was decided is printed."""
    page = tmp_path / "long.toml"
    rows = "".join(
        f'r{i} = {{in = "c", claim = "sin(x*y + {i})^2 + y^2 >= x"}}\n' for i in range(999)
    )
    page.write_text(
        'title = "long"\n[contexts.c]\nvariables = ["x", "y"]\n'
        f'given = ["0 <= x <= 9", "0 <= y <= 9"]\n[rows]\n{rows}'
    )
    words = [sys.executable, "-m", "verify", "prove", str(page)]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, cwd=ROOT)
    time.sleep(3)
    process.send_signal(sign)
    _, err = process.communicate(timeout=60)
    assert (process.returncode, err.decode()) == (code, f"verify: {says}\n")


def test_an_interrupt_waits() -> None:
    done = []
    with pytest.raises(KeyboardInterrupt), held():  # noqa: PT012
        signal.raise_signal(signal.SIGINT)
        done.append(1)
    assert done == [1]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_flint_is_loaded_without_interrupts() -> None:
    """A signal that comes while it is loaded is not lost, and comes when it is loaded."""
    code = """
import builtins, signal, sys
import verify.prover
load = builtins.__import__
def loading(name, *rest):
    if name.startswith("flint.") and "done" not in globals():
        globals()["done"] = True
        signal.raise_signal(signal.SIGINT)
    return load(name, *rest)
builtins.__import__ = loading
try:
    import flint
    print("not interrupted")
except KeyboardInterrupt:
    print("flint" in sys.modules and hasattr(sys.modules["flint"], "arb"), done)
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT, check=False
    )
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("files", [5, 6, 8, 12])
@pytest.mark.parametrize(
    "words",
    [
        ["theorem1", "--r", "0.02..0.05", "--steps", "4", "--jobs", "2"],
        ["scene", "certificates/scenes", "--jobs", "2"],
        ["map", "phi", "--r", "0.03", "--undecided", "90%", "--jobs", "2"],
    ],
)
def test_too_few_files_for_helpers_are_told(words: list[str], files: int) -> None:
    """The system allows so many open files: that is said, and nothing of the standard output."""
    done = subprocess.run(
        [sys.executable, "-m", "verify", *words],
        capture_output=True,
        text=True,
        cwd=ROOT,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (files, files)),
        check=False,
    )
    assert done.stderr.count("\n") == 1, done.stderr
    assert "stdout" not in done.stderr
    assert done.returncode in ({2, 5} if files < 6 else {5}), done.stderr
    assert "report it" not in done.stderr
