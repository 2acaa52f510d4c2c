"""What is trusted stays small, plain and alone."""

from __future__ import annotations

import ast
import subprocess
import sys
from pathlib import Path

CHECKER = Path(__file__).parents[2] / "verify" / "check.py"
SOURCE = CHECKER.read_text()
TREE = ast.parse(SOURCE)
STANDARD = {
    "__future__", "collections", "fractions", "functools", "gc", "hashlib", "itertools", "json",
    "math", "os", "re", "sys", "typing",
}  # fmt: skip


def nodes(*kinds: type[ast.AST]) -> list[ast.AST]:
    return [node for node in ast.walk(TREE) if isinstance(node, kinds)]


def test_it_imports_nothing_but_the_standard_library() -> None:
    modules = {alias.name for node in nodes(ast.Import) for alias in node.names}
    for node in nodes(ast.ImportFrom):
        assert node.level == 0
        modules.add(node.module)
    assert {module.partition(".")[0] for module in modules} <= STANDARD
    assert STANDARD - {"__future__"} <= set(sys.stdlib_module_names)


def test_nothing_from_this_package_is_loaded() -> None:
    program = "import runpy, sys; runpy.run_path(sys.argv[1]); print(*sys.modules)"
    command = [sys.executable, "-I", "-c", program, str(CHECKER)]
    found = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    assert not [name for name in found if name.partition(".")[0] in ("verify", "flint", "sympy")]


def test_no_assert_no_eval_no_import_by_name() -> None:
    assert not nodes(ast.Assert)
    names = {node.id for node in nodes(ast.Name)} | {node.attr for node in nodes(ast.Attribute)}
    assert not names & {"eval", "exec", "compile", "__import__", "import_module", "pickle", "float"}


def test_no_floating_point() -> None:
    constants = [node.value for node in nodes(ast.Constant)]
    assert not [value for value in constants if isinstance(value, float | complex)]
    assert not nodes(ast.Div), "the quotient of two integers is a float"
    powers = [node for node in nodes(ast.BinOp) if isinstance(node.op, ast.Pow)]
    for node in powers:  # only of a Fraction: an integer to a negative power is a float
        assert ast.unparse(node.left) == "Fraction(10)"
    called = {ast.unparse(node.func) for node in nodes(ast.Call)}
    assert not called & {"math.sqrt", "math.log", "math.cos", "sum", "round", "divmod_float"}


def test_json_numbers_are_never_read_as_floats() -> None:
    hooks = ast.unparse(next(n for n in nodes(ast.FunctionDef) if n.name == "parse"))
    for hook in ("parse_int", "parse_float", "parse_constant", "object_pairs_hook"):
        assert hook in hooks


def code_lines() -> int:
    """Lines that are neither blank nor comment nor docstring."""
    skipped = {i for i, line in enumerate(SOURCE.splitlines(), 1) if line.strip()[:1] in ("", "#")}
    for node in nodes(ast.Module, ast.ClassDef, ast.FunctionDef):
        if ast.get_docstring(node) is not None:
            skipped |= set(range(node.body[0].lineno, node.body[0].end_lineno + 1))
    return len(SOURCE.splitlines()) - len(skipped)


def test_it_reads_in_one_sitting() -> None:
    assert code_lines() <= 500
    assert len(SOURCE.splitlines()) <= 680
    assert max(map(len, SOURCE.splitlines())) <= 100


def test_every_function_says_what_it_does() -> None:
    for node in nodes(ast.FunctionDef, ast.ClassDef):
        inner = isinstance(node, ast.FunctionDef) and node.name in ("unique", "number", "new")
        if node.name != "__init__" and not inner:
            assert ast.get_docstring(node), node.name
        assert node.end_lineno - node.lineno < 40 or isinstance(node, ast.ClassDef), node.name


def test_every_rule_has_a_test_file() -> None:
    from verify.check import RULES

    for rule in RULES:
        assert Path(__file__).with_name(f"test_rule_{rule}.py").is_file()
