"""Mutants of a trusted file: is a checker that was broken on purpose noticed by its tests?

    python -m tests.mutation verify/check_map.py [--sample 300] [--seconds 500] [--least 95] …

Each mutant is the file with one change: another comparison, operator or constant, a condition that
always or never holds, a statement or an argument left out, two arguments swapped. Texts for readers
are left alone. A mutant runs in a copy of the tree, the tests that are likely to notice it first.
It is noticed if one of them fails, does not end, or needs too much memory. The mutants that nobody
can notice are listed in `tests/excused`, each group under a comment that says why: by their names,
or after `~ ` by a regular expression.
"""

from __future__ import annotations

import argparse
import ast
import os
import random
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from importlib import import_module
from multiprocessing import get_context
from pathlib import Path
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
EXCUSED = ROOT / "tests" / "excused"
#: The tests of each file, the likely killers first; a later stage runs where no earlier one fails.
STAGES = {
    "verify/check.py": (
        ("tests/check/test_pairs.py",),
        ("tests/lies/test_lies.py", "tests/check", "tests/certificates"),
        ("tests/lies/test_heavy.py",),
    ),
    "verify/check_map.py": (
        ("tests/check/test_check_map.py", "tests/check/test_check_map_branches.py"),
        ("tests/check/test_check_map_numbers.py", "tests/check/test_check_map_planes.py"),
        ("tests/check/test_check_map_closing.py", "tests/spheres/map/test_branches.py"),
        ("tests/check/test_check_map_lies.py",),
    ),
}
#: What the tests of the one file need not run.
IGNORED = {
    "verify/check.py": ["--ignore-glob=*check_map*", "--deselect=tests/check/test_wall.py"],
    "verify/check_map.py": ["-k", "not 4_mb"],
}
#: Loaded once, before the mutants.
LIBRARIES = ("pytest", "_pytest.assertion.rewrite", "xdist.plugin", "hypothesis", "mpmath")
LIBRARIES += ("flint", "jsonschema", "numpy")
MEMORY = 3 << 30

COMPARISONS: dict[type[ast.cmpop], tuple[type[ast.cmpop], ...]] = {
    ast.Lt: (ast.LtE, ast.Gt),
    ast.LtE: (ast.Lt, ast.GtE),
    ast.Gt: (ast.GtE, ast.Lt),
    ast.GtE: (ast.Gt, ast.LtE),
    ast.Eq: (ast.NotEq,),
    ast.NotEq: (ast.Eq,),
    ast.Is: (ast.IsNot,),
    ast.IsNot: (ast.Is,),
    ast.In: (ast.NotIn,),
    ast.NotIn: (ast.In,),
}
OPERATORS: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Add,
    ast.Div: ast.Mult,
    ast.FloorDiv: ast.Mult,
    ast.Mod: ast.FloorDiv,
    ast.Pow: ast.Mult,
    ast.LShift: ast.RShift,
    ast.RShift: ast.LShift,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
    ast.BitXor: ast.BitAnd,
}
OTHER_NAMES = {"min": "max", "max": "min", "any": "all", "all": "any"}
#: Calls that say something: their texts are left alone.
SAYING = {"need", "print"}


class Mutant(NamedTuple):
    """What replaces the bytes between two places; the name has the line with the change."""

    name: str
    start: int
    end: int
    text: str


# --- what can be changed -------------------------------------------------------------------------


def other_expressions(node: ast.AST) -> Iterator[ast.expr]:  # noqa: C901
    """What an expression is replaced by."""
    match node:
        case ast.Compare(left, ops, comparators):
            for place, op in enumerate(ops):
                for other in COMPARISONS[type(op)]:
                    yield ast.Compare(left, [*ops[:place], other(), *ops[place + 1 :]], comparators)
        case ast.BinOp(left, op, right):
            yield ast.BinOp(left, OPERATORS[type(op)](), right)
        case ast.BoolOp(op, values):
            yield ast.BoolOp(ast.Or() if isinstance(op, ast.And) else ast.And(), values)
            for place in range(len(values)):
                rest = [*values[:place], *values[place + 1 :]]
                yield rest[0] if len(rest) == 1 else ast.BoolOp(op, rest)
        case ast.UnaryOp(_, operand):
            yield operand
        case ast.IfExp(_, body, orelse):
            yield from (body, orelse)
        case ast.Constant(value):
            yield from map(ast.Constant, other_constants(value))
        case ast.Call(func, args, keywords):
            yield from other_calls(func, args, keywords)


def other_constants(value: object) -> list[Any]:
    """What a constant is replaced by."""
    if isinstance(value, bool):
        return [not value]
    if isinstance(value, int):
        return [value + 1, value - 1]
    return [value + "?"] if isinstance(value, str) else []


def other_calls(
    func: ast.expr, args: list[ast.expr], keywords: list[ast.keyword]
) -> Iterator[ast.expr]:
    """Calls of the opposite, with arguments swapped, with one of them for the result."""
    name = func.id if isinstance(func, ast.Name) else ""
    if name in OTHER_NAMES:
        yield ast.Call(ast.Name(OTHER_NAMES[name]), args, keywords)
    if name == "abs" or (name in ("min", "max") and len(args) > 1):
        yield from args
    if name not in ("min", "max", *SAYING):
        for i in range(len(args) - 1):
            if ast.dump(args[i]) != ast.dump(args[i + 1]):
                yield ast.Call(func, [*args[:i], args[i + 1], args[i], *args[i + 2 :]], keywords)


def conditions(node: ast.AST) -> Iterator[tuple[ast.expr, list[str]]]:
    """Conditions, and what they are replaced by besides."""
    match node:
        case ast.If(test):
            yield test, ["True", "False"]
        case ast.While(test):
            yield test, ["False"]
        case ast.comprehension(_, _, ifs):
            yield from ((test, ["True"]) for test in ifs)


def is_text(node: ast.AST) -> bool:
    """Whether nothing but words depends on it."""
    match node:
        case ast.Raise() | ast.JoinedStr() | ast.Expr(ast.Constant()):
            return True
        case ast.Expr(ast.Call(ast.Name("print"))):
            return True
    return False


def visited(node: ast.AST, where: str = "") -> Iterator[tuple[ast.AST, str]]:
    """The nodes that are changed, each with the function or class that it is in."""
    yield node, where
    if is_text(node):
        return
    skipped: list[Any] = []
    match node:
        case ast.FunctionDef(name) | ast.ClassDef(name):
            where = f"{where}.{name}" if where else name
            skipped = [*node.decorator_list, getattr(node, "returns", None)]
        case ast.arg() | ast.Import() | ast.ImportFrom():
            return
        case ast.AnnAssign():
            skipped = [node.annotation]
        case ast.Call(ast.Name(name), args) if name in SAYING:
            skipped = args[1:]
        case ast.If(ast.Compare(ast.Name("__name__"))):
            return
    for child in ast.iter_child_nodes(node):
        if not any(child is one for one in skipped):
            yield from visited(child, where)


def changes(node: ast.AST) -> Iterator[tuple[Any, str]]:
    """Nodes with the text that stands there afterwards."""
    match node:
        case ast.Expr(ast.Constant()):
            return
        case ast.Expr() | ast.Raise() | ast.AugAssign() | ast.Assert():
            yield node, "pass"
        case ast.Assign(targets) if not isinstance(targets[0], ast.Name):
            yield node, "pass"
        case ast.Continue() | ast.Break():
            yield node, "pass"
    if isinstance(node, ast.AugAssign):
        target, op, value = node.target, OPERATORS[type(node.op)](), node.value
        yield node, ast.unparse(ast.AugAssign(target, op, value))
    for test, others in conditions(node):
        yield from ((test, other) for other in others)
    for other in other_expressions(node):
        yield node, f"({ast.unparse(ast.fix_missing_locations(other))})"


def mutants(source: bytes) -> list[Mutant]:
    """All mutants of a file, in its order, each with a name of its own."""
    begins, at = [0], 0
    for line in source.splitlines(keepends=True):
        at += len(line)
        begins.append(at)
    found, seen = [], Counter[str]()
    for node, where in visited(ast.parse(source)):
        for part, text in changes(node):
            start = begins[part.lineno - 1] + part.col_offset
            end = begins[part.end_lineno - 1] + part.end_col_offset
            before = source[begins[part.lineno - 1] : start].decode()
            after = source[end : begins[part.end_lineno]].decode().partition("  #")[0]
            shown = f"{before}{{{source[start:end].decode()} => {text}}}{after}"
            name = " ".join(f"{where}: {shown}".split())
            seen[name] += 1
            name += f" #{seen[name]}" if seen[name] > 1 else ""
            found.append(Mutant(name, start, end, text))
    return found


def excused(file: str, names: list[str]) -> dict[str, str]:
    """Those of these mutants of a file that nobody can notice, with the reasons.

    Raises:
        SystemExit: if a line of the list excuses none.
    """
    found, why, last = {}, "", ""
    path = EXCUSED / f"{Path(file).stem}.txt"
    for line in filter(None, path.read_text(encoding="utf-8").splitlines()):
        if line.startswith("# "):
            why = f"{why} {line[2:]}" if last.startswith("# ") else line[2:]
        else:
            chosen = [name for name in names if name == line]
            if line.startswith("~ "):
                chosen = [name for name in names if re.fullmatch(line[2:], name)]
            if not chosen:
                raise SystemExit(f"{path}: excused, but no mutant: {line}")
            found |= dict.fromkeys(chosen, why)
        last = line
    return found


# --- whether it is noticed -----------------------------------------------------------------------


def copied(folder: str) -> Path:
    """A copy of the tree, in which a file can be changed."""
    tree = Path(folder) / "tree"
    for name in ("verify", "tests"):
        ignore = shutil.ignore_patterns(".hypothesis")
        shutil.copytree(ROOT / name, tree / name, ignore=ignore)
    for path in ROOT.iterdir():
        if path.name not in ("verify", "tests", ".git", ".venv"):
            (tree / path.name).symlink_to(path)
    return tree


def run_stages(tree: Path, file: str, limits: list[float], said: int) -> int:
    """In a process of its own: 0 if no test fails, in any stage."""
    import pytest

    os.setsid()
    os.dup2(said, 1), os.dup2(said, 2)
    os.chdir(tree)
    sys.path[:] = [str(tree), *(x for x in sys.path if x and Path(x).resolve() != ROOT)]
    for name in [name for name in sys.modules if name.partition(".")[0] in ("tests", "verify")]:
        del sys.modules[name]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    options = ["-x", "-q", "-n", "0", "-p", "no:cacheprovider", "--tb=line", *IGNORED[file]]
    options += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]  # the libraries are loaded
    for stage, limit in zip(STAGES[file], limits, strict=True):
        begin = time.monotonic()
        signal.setitimer(signal.ITIMER_REAL, limit)
        paths = [path for path in stage if (tree / path).exists()]
        if paths and pytest.main([*options, *paths]):
            return 1
        os.write(said, f"\nstage {time.monotonic() - begin}\n".encode())
    return 0


def tested(tree: Path, file: str, source: bytes, limits: list[float]) -> tuple[bool, str]:
    """Whether a source in the copy of the tree passes the tests, and what they said."""
    target = tree / file
    target.write_bytes(source)
    for stale in (target.parent / "__pycache__").glob(f"{target.stem}.*"):
        stale.unlink()
    with tempfile.TemporaryFile() as said:
        pid = os.fork()
        if pid == 0:
            code = 2
            try:
                code = run_stages(tree, file, limits, said.fileno())
            except BaseException:
                traceback.print_exc()
            finally:
                sys.stdout.flush(), sys.stderr.flush()
                os._exit(code)
        _, status = os.waitpid(pid, 0)
        with suppress(ProcessLookupError):
            os.killpg(pid, signal.SIGKILL)  # what a test has started and left behind
        said.seek(0)
        return status == 0, said.read().decode(errors="replace")


class Job:
    """A worker's copy of the tree."""

    tree: Path

    @classmethod
    def begin(cls, folder: str) -> None:
        """In a new worker."""
        for library in LIBRARIES:
            with suppress(ImportError):  # the tests that need it are skipped
                import_module(library)
        cls.tree = copied(tempfile.mkdtemp(dir=folder))

    @classmethod
    def runs(cls, file: str, limits: list[float], source: bytes) -> tuple[bool, str]:
        """Whether it passes."""
        return tested(cls.tree, file, source, limits)


def survivors(file: str, chosen: list[Mutant], jobs: int) -> Iterator[tuple[Mutant, bool]]:
    """Mutants, and whether each is noticed.

    Raises:
        SystemExit: if the file as it stands does not pass.
    """
    source = (ROOT / file).read_bytes()
    with (
        tempfile.TemporaryDirectory() as folder,
        ProcessPoolExecutor(jobs, get_context("fork"), Job.begin, (folder,)) as pool,
    ):
        limits = [600.0] * len(STAGES[file])
        passed, said = pool.submit(Job.runs, file, limits, source).result()
        if not passed:
            raise SystemExit(f"{file} as it stands does not pass its tests:\n{said}")
        times = [float(x.split()[1]) for x in said.splitlines() if x.startswith("stage ")]
        limits = [10 + 6 * spent for spent in times]
        sources = (source[: m.start] + m.text.encode() + source[m.end :] for m in chosen)
        results = [pool.submit(Job.runs, file, limits, changed) for changed in sources]
        try:
            for mutant, result in zip(chosen, results, strict=True):
                yield mutant, not result.result()[0]
        finally:
            pool.shutdown(cancel_futures=True)


def examine(file: str, options: argparse.Namespace) -> float:
    """Print the mutants that nobody notices, and the percentage that is noticed."""
    generated = mutants((ROOT / file).read_bytes())
    left_out = excused(file, [mutant.name for mutant in generated])
    chosen = [mutant for mutant in generated if options.match in mutant.name]
    if options.sample is not None and options.sample < len(chosen):
        chosen = random.Random(options.seed).sample(chosen, options.sample)
    tried = [mutant for mutant in chosen if mutant.name not in left_out]
    begin, noticed, done = time.monotonic(), 0, 0
    for mutant, is_noticed in survivors(file, tried, options.jobs):
        noticed, done = noticed + is_noticed, done + 1
        if not is_noticed:
            print(mutant.name, flush=True)
        if time.monotonic() - begin > options.seconds:
            break
    share = 100 * noticed / max(done, 1)
    print(
        f"{file}: {noticed} of {done} mutants are noticed ({share:.1f} %), "
        f"{len(tried) - done} not tried; {len(chosen) - len(tried)} more are excused; "
        f"{len(generated)} in all; {time.monotonic() - begin:.0f} s",
        flush=True,
    )
    return share


def main() -> int:
    """Examine files; 1 if too few mutants are noticed."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("files", nargs="*", default=[*STAGES], help="trusted files (default: all)")
    parser.add_argument("--sample", type=int, help="so many mutants, chosen at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=float("inf"), help="stop after so many")
    parser.add_argument("--least", type=float, default=95, help="percent (default 95)")
    parser.add_argument("--match", default="", help="only mutants whose name has this")
    found = parser.parse_args()
    shares = [examine(file, found) for file in found.files]
    return int(min(shares) < found.least)


if __name__ == "__main__":
    sys.exit(main())
