"""What is installed with the package is what it imports, and it is loaded where it is used."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import sysconfig
import tomllib
from pathlib import Path

import pytest

from verify.cli import COMMANDS

ROOT = Path(__file__).resolve().parent.parent
#: A package of the index by the name of its module, where these differ.
PACKAGES = {"flint": "python-flint"}
#: What only an option needs that says so in a line: the module and its extra.
HEAVY = {"distributed": "dask"}


def imported() -> set[str]:
    """Every module that a file of the package imports, anywhere, and that Python does not have."""
    found: set[str] = set()
    for path in (ROOT / "verify").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                found |= {alias.name.partition(".")[0] for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                found.add(str(node.module).partition(".")[0])
    return found - sys.stdlib_module_names - {"verify"}


def names(requirements: list[str]) -> set[str]:
    return {re.split(r"[<>=!~ \[]", one)[0] for one in requirements}


def test_what_is_imported_is_installed_and_nothing_else() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    ordinary, extras = names(project["dependencies"]), project["optional-dependencies"]
    assert {PACKAGES.get(name, name) for name in imported() - HEAVY.keys()} == ordinary
    assert HEAVY.keys() <= imported()
    for extra in HEAVY.values():
        modules = {module for module, other in HEAVY.items() if other == extra}
        assert {PACKAGES.get(m, m) for m in modules} == names(extras[extra])
    assert extras.keys() == {*HEAVY.values(), "docs", "test"}


def test_the_lock_file_has_what_is_installed() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    extras = project["optional-dependencies"]
    locked = names((ROOT / "requirements.lock").read_text(encoding="utf-8").split())
    asked = names([*project["dependencies"], *extras["docs"], *extras["test"]])
    assert asked <= locked


def test_a_type_checker_finds_the_package_from_any_folder(tmp_path: Path) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    is_path = project["tool"]["setuptools"].get("package-dir") == {"": "."}
    if is_path and [*Path(sysconfig.get_path("purelib")).glob("__editable___verify*_finder.py")]:
        pytest.skip("this environment has an older install; run pip install -e . again")
    (tmp_path / "program.py").write_text("from verify import symbol\n\nsymbol('x')\n")
    command = [sys.executable, "-I", "-m", "mypy", "--strict", "--no-incremental", "program.py"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout


def test_help_loads_nothing_heavy() -> None:
    code = (
        "import sys\n"
        "from verify.cli import COMMANDS, main\n"
        "for command in COMMANDS:\n"
        "    assert main([command, '--help']) == 0, command\n"
        "print([m for m in ('jinja2', 'mpmath', 'numpy', 'sympy', 'distributed') "
        "if m in sys.modules])\n"
    )
    assert "stress" in COMMANDS
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout.splitlines()[-1:], done.stderr) == (0, ["[]"], "")
