"""What is trusted stays small, plain and alone."""

from __future__ import annotations

import ast
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

CHECKER = Path(__file__).parents[2] / "verify" / "check.py"
SOURCE = CHECKER.read_text()
TREE = ast.parse(SOURCE)
STANDARD = {
    "__future__", "collections", "fractions", "functools", "gc", "hashlib", "itertools", "json",
    "math", "os", "re", "sys", "typing",
}  # fmt: skip
BLOCKS = ast.If | ast.For | ast.While | ast.With | ast.Try | ast.Match


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
    assert not names & {"eval", "exec", "__import__", "import_module", "pickle", "float"}
    compiled = [node.value for node in nodes(ast.Attribute) if node.attr == "compile"]
    assert {ast.unparse(of) for of in compiled} <= {"re"}
    assert "compile" not in {node.id for node in nodes(ast.Name)}


def test_no_floating_point() -> None:
    """Quotients by / are of fractions: one side is a name for an end, a number of which is one."""
    constants = [node.value for node in nodes(ast.Constant)]
    assert not [value for value in constants if isinstance(value, float | complex)]
    assert [ast.unparse(n) for n in nodes(ast.BinOp) if isinstance(n.op, ast.Div)] == [
        "1 / y.high", "1 / y.low", "(x - 1) / (x + 1)", "-1 / x",
    ]  # fmt: skip
    powers = [ast.unparse(n) for n in nodes(ast.BinOp) if isinstance(n.op, ast.Pow)]
    assert powers == [
        "10 ** abs(exponent)", "(-1) ** (k % 2)", "d ** (k - 1)", "root ** (k - 1)", "root ** k",
    ]  # fmt: skip


def test_json_numbers_are_never_read_as_floats() -> None:
    hooks = ast.unparse(next(n for n in nodes(ast.FunctionDef) if n.name == "parsed"))
    for hook in ("parse_int", "parse_float", "parse_constant", "object_pairs_hook"):
        assert hook in hooks


def depth(node: ast.AST) -> int:
    """How many blocks stand inside one another; an elif is not one of its own."""
    inner = 0
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.FunctionDef | ast.ClassDef | ast.Lambda):
            continue
        is_elif = isinstance(node, ast.If) and node.orelse == [child]
        inner = max(inner, depth(child) + (isinstance(child, BLOCKS) and not is_elif))
    return inner


def functions() -> Iterator[ast.FunctionDef]:
    yield from nodes(ast.FunctionDef)


def test_functions_are_short_and_flat() -> None:
    for node in functions():
        assert node.end_lineno - node.lineno < 40, node.name
        assert depth(node) <= 3, node.name
    assert max(map(len, SOURCE.splitlines())) <= 100


def test_every_function_says_what_it_does() -> None:
    inner = {id(child) for node in functions() for child in ast.walk(node) if child is not node}
    for node in nodes(ast.FunctionDef, ast.ClassDef):
        if node.name != "__init__" and id(node) not in inner:
            assert ast.get_docstring(node), node.name


def test_every_rule_has_a_test_file() -> None:
    from verify import check

    for rule in {**check.RULES, **check.DEFINING, **check.REPEATING, **check.FAILING}:
        assert Path(__file__).with_name(f"test_rule_{rule}.py").is_file()


def test_every_operation_is_known_to_each_table() -> None:
    from verify import check

    atoms = {"name", "rational", "pow", "root"}
    assert set(check.CLEARED) == set(check.ARITY_OR_MORE) | atoms
    assert set(check.OPERATIONS) == (set(check.ARITY_OR_MORE) | atoms) - {"name"}
    assert set(check.HOLDS) == set(check.NEGATION) | {"!="}
