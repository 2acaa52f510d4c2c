"""Mutants of a trusted file: is a checker that was broken on purpose noticed by its tests?

    python -m tests.mutation verify/check_map.py [--sample 300] [--seconds 500] [--least 95] …

Each mutant is the file with one change: another comparison, operator or constant, a condition that
always or never holds, a statement or an argument left out, two arguments swapped. Texts for readers
are left alone. A mutant is noticed if one of the tests that run its lines fails, does not end, or
needs too much memory. The mutants that nobody can notice are listed in `tests/excused`, each group
under a comment that says why: by their names, or after `~ ` by a regular expression.

First all tests run once, on a copy of the file as it stands, and it is noted which lines each test
runs. Then each mutant has a process of its own. It is a copy of one in which the tests are already
collected, and the functions of the file get the mutant's code; where collecting runs the function
that is changed, the tests are collected anew. Tests that start processes of their own take long:
they count only for lines that few others run, which can make the share smaller, but not larger.
"""

from __future__ import annotations

import argparse
import ast
import builtins
import gc
import os
import pickle
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
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from functools import partial
from importlib import import_module
from multiprocessing import get_context
from multiprocessing.connection import Connection, wait
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any, NamedTuple

ROOT = Path(__file__).parents[1]
EXCUSED = ROOT / "tests" / "excused"
#: The tests of each file, and what they need not run.
TESTS = {
    "verify/check.py": [
        *("tests/lies/test_lies.py", "tests/check", "tests/certificates"),
        *("--ignore-glob=*check_map*", "--deselect=tests/check/test_wall.py"),
        "--deselect=tests/check/test_report.py::test_interrupted_while_it_checks",  # takes its time
    ],
    "verify/check_map.py": [
        *("tests/check", "tests/spheres/map/test_branches.py"),
        *("--ignore-glob=*test_[!cb]*", "--ignore-glob=*test_c[!h]*", "-k", "not 4_mb"),
    ],
}
#: Tests that start processes count for lines that fewer others run.
FEW = 20
STARTING = ("subprocess.Popen", "os.fork", "os.posix_spawn")
#: Loaded once, before the mutants.
LIBRARIES = ("pytest", "_pytest.assertion.rewrite", "xdist.plugin", "hypothesis", "mpmath")
LIBRARIES += ("flint", "jsonschema", "numpy")
MEMORY = 3 << 30
#: A test that takes so many times as long as it should, and a second, has no end.
PATIENCE = 10
#: Exit codes of a process: a test fails; this program does.
NOTICED, BROKEN = 1, 99

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
    """What replaces the bytes between two places; the name has the line with the change.

    Sets of lines are the bits of a number: those of the statement (or of its head, if it has a
    body) and those of the outermost function around it.
    """

    name: str
    start: int
    end: int
    text: str
    lines: int
    function: int

    @property
    def where(self) -> str:
        """The function that is changed."""
        return self.name.partition(":")[0]


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


def lines_of(first: int, last: int) -> int:
    """A set of lines, from the first to the last one."""
    return (1 << last + 1) - (1 << first)


def places(module: ast.Module) -> tuple[list[tuple[int, int, int]], list[tuple[int, int, int]]]:
    """First and last lines of all statements, short ones first, and of functions; with a set each.

    It has the lines of a statement, or of its head if there is a body; the body of a function.
    """
    parts = [node for node in ast.walk(module) if isinstance(node, ast.stmt)]
    found, functions = [], []
    for node in parts:
        first, last, body = node.lineno, node.end_lineno or 0, getattr(node, "body", None)
        head = max(first, body[0].lineno - 1) if body else last
        found.append((first, last, lines_of(first, head)))
        if isinstance(node, ast.FunctionDef):
            functions.append((first, last, lines_of(node.body[0].lineno, last)))
    return sorted(found, key=lambda place: place[1] - place[0]), functions


def mutants(source: bytes) -> list[Mutant]:
    """All mutants of a file, in its order, each with a name of its own."""
    begins, at = [0], 0
    for line in source.splitlines(keepends=True):
        at += len(line)
        begins.append(at)
    found, seen, module = [], Counter[str](), ast.parse(source)
    parts, functions = places(module)
    for node, where in visited(module):
        for part, text in changes(node):
            start = begins[part.lineno - 1] + part.col_offset
            end = begins[part.end_lineno - 1] + part.end_col_offset
            before = source[begins[part.lineno - 1] : start].decode()
            after = source[end : begins[part.end_lineno]].decode().partition("  #")[0]
            shown = f"{before}{{{source[start:end].decode()} => {text}}}{after}"
            name = " ".join(f"{where}: {shown}".split())
            seen[name] += 1
            name += f" #{seen[name]}" if seen[name] > 1 else ""
            around = [x for x in parts if x[0] <= part.lineno and part.end_lineno <= x[1]]
            function = 0
            for first, last, lines in functions:
                function |= lines if first <= part.lineno <= last else 0
            found.append(Mutant(name, start, end, text, around[0][2], function))
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


def copied(tree: Path) -> None:
    """Make a copy of the tree, in which a file can be changed."""
    for name in ("verify", "tests"):
        ignore = shutil.ignore_patterns(".hypothesis")
        shutil.copytree(ROOT / name, tree / name, ignore=ignore)
    for path in ROOT.iterdir():
        if path.name not in ("verify", "tests", ".git", ".venv"):
            (tree / path.name).symlink_to(path)


def marked(source: bytes) -> bytes:
    """The same program, which notes in `builtins.lines`, if it is there, which lines are run."""
    module = ast.parse(source)
    for node in [*ast.walk(module)]:
        for field in ("body", "orelse", "finalbody"):
            parts = getattr(node, field, None)
            if isinstance(parts, list) and parts and isinstance(parts[0], ast.stmt):
                marks = [ast.parse(f"LINES[{part.lineno}] = 1").body[0] for part in parts]
                setattr(node, field, [x for pair in zip(marks, parts, strict=True) for x in pair])
    lines = len(source.splitlines()) + 1
    begin = f"import builtins\nLINES = getattr(builtins, 'lines', bytearray({lines}))\n"
    future = "from __future__ import annotations\n"
    return (future + begin + ast.unparse(module).replace(future, "")).encode()


def lines_run() -> int:
    """The lines that were run since the last time."""
    found = sum(1 << line for line, is_run in enumerate(builtins.lines) if is_run)
    builtins.lines[:] = bytes(len(builtins.lines))
    return found


class Told(NamedTuple):
    """What is known of a test: the lines that it runs, whether it starts processes, its time."""

    lines: int
    starts: bool
    seconds: float


class Plugin:
    """For pytest: what is done with the tests, once they are collected."""

    def __init__(self, said: Path, use: Callable[[list[Any]], object]) -> None:
        self.said, self.use = said, use

    def pytest_runtestloop(self, session: Any) -> bool:
        """Instead of running them all."""
        if not session.testsfailed:
            self.use(session.items)
        return True

    def pytest_runtest_logreport(self, report: Any) -> None:
        """The first failure is the end of a process; the last line says which test it was."""
        if report.failed:
            with self.said.open("a") as said:
                print(report.longreprtext, report.nodeid, sep="\n", file=said)
            os._exit(NOTICED)


def collected(tree: Path, file: str, use: Callable[[list[Any]], object]) -> int:
    """Collect the tests of a copy of the tree, and do something with them; pytest's exit code."""
    import pytest

    os.chdir(tree)
    sys.path[:] = [str(tree), *(x for x in sys.path if x and Path(x).resolve() != ROOT)]
    for name in [name for name in sys.modules if name.partition(".")[0] in ("tests", "verify")]:
        del sys.modules[name]
    options = ["-q", "-n", "0", "-p", "no:cacheprovider", "--tb=line", *TESTS[file]]
    options += [f"--basetemp={tree.parent / 'temporary'}"]
    options += ["-W", "ignore::pytest.PytestAssertRewriteWarning"]  # the libraries are loaded
    return int(pytest.main(options, plugins=[Plugin(tree.parent / "said", use)]))


def run(items: Iterable[Any], told: dict[str, Told] | None = None) -> None:
    """Run tests, in their order; a failure, or too long a time, is the end of this process."""
    items = [*items]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    for item, following in zip(items, [*items[1:], None], strict=True):
        seconds = told[item.nodeid].seconds if told else 60.0
        signal.setitimer(signal.ITIMER_REAL, PATIENCE * (1 + seconds))
        item.config.hook.pytest_runtest_protocol(item=item, nextitem=following)
    signal.setitimer(signal.ITIMER_REAL, 0)


def apart(tree: Path, does: Callable[[], int | None]) -> tuple[int, str]:
    """The exit code of a process of its own that does something, and what it says."""
    with (tree.parent / "said").open("w+b") as said:
        pid = os.fork()
        if pid == 0:
            code = BROKEN
            try:
                os.setsid()
                os.dup2(said.fileno(), 1), os.dup2(said.fileno(), 2)
                code = does() or 0
            except MemoryError:
                code = NOTICED
            except BaseException:
                traceback.print_exc()
            finally:
                sys.stdout.flush(), sys.stderr.flush()
                os._exit(code)
        _, status = os.waitpid(pid, 0)
        with suppress(ProcessLookupError):
            os.killpg(pid, signal.SIGKILL)  # what a test has started and left behind
        said.seek(0)
        return os.waitstatus_to_exitcode(status), said.read().decode(errors="replace")


def put(target: Path, source: bytes) -> None:
    """Afterwards the file has this source."""
    target.write_bytes(source)
    for stale in (target.parent / "__pycache__").glob(f"{target.stem}.*"):
        stale.unlink()


def measured(tree: Path, file: str) -> tuple[int, dict[str, Told]]:
    """Which lines of the file run while the tests are collected, and what is known of each test.

    Raises:
        SystemExit: if one fails.
    """
    path = tree.parent / "measured"

    def each(items: list[Any]) -> None:
        at_once, told = lines_run(), []
        for item in items:
            begin, started[:] = time.monotonic(), []
            run([item])
            told.append((item.nodeid, lines_run(), bool(started), time.monotonic() - begin))
        path.write_bytes(pickle.dumps((at_once, told)))

    def measure() -> int:
        builtins.lines = bytearray(len(source.splitlines()) + 1)
        sys.addaudithook(lambda event, _: started.append(event) if event in STARTING else None)
        return collected(tree, file, each)

    started, source = list[str](), (ROOT / file).read_bytes()
    put(tree / file, marked(source))
    code, said = apart(tree, measure)
    put(tree / file, source)
    if code:
        raise SystemExit(f"{file} as it stands does not pass its tests:\n{said}")
    at_once, found = pickle.loads(path.read_bytes())
    return at_once, {name: Told(*rest) for name, *rest in found}


def codes(code: CodeType) -> Iterator[tuple[str, CodeType]]:
    """The code of functions, by their names."""
    for inner in code.co_consts:
        if isinstance(inner, CodeType):
            yield inner.co_qualname, inner
            yield from codes(inner)


class Task(NamedTuple):
    """A mutant with its source, the tests that run, and whether they are collected anew."""

    mutant: Mutant
    source: bytes
    tests: list[str]
    anew: bool


class Worker:
    """A copy of the tree, in which one task after the other is done; those anew come first."""

    def __init__(
        self, tree: Path, file: str, told: dict[str, Told], pipe: Connection, others: Any
    ) -> None:
        self.tree, self.file, self.told, self.pipe = tree, file, told, pipe
        for other in others:  # so that it is noticed if the first process has ended
            other.close()
        with (tree.parent / "begun").open("wb") as said:
            os.dup2(said.fileno(), 1), os.dup2(said.fileno(), 2)
        self.receive()
        while self.source and self.anew:
            self.answer(lambda: collected(tree, file, self.run))
        put(tree / file, (ROOT / file).read_bytes())
        if self.source:
            collected(tree, file, self.with_these)

    def receive(self) -> None:
        """The next source, if there is one, and the names of the tests that run."""
        self.source, self.anew, self.tests = self.pipe.recv()

    def with_these(self, items: list[Any]) -> None:
        """Do all other tasks, with tests that are collected."""
        path = str(self.tree / self.file)
        mine = (x for x in gc.get_objects() if type(x) is FunctionType)
        functions = {x.__qualname__: x for x in mine if x.__code__.co_filename == path}

        def changed() -> None:
            for name, code in codes(compile(self.source, path, "exec")):
                if name in functions and "<" not in name:
                    functions[name].__code__ = code
            self.run(items)

        while self.source:
            self.answer(changed)

    def run(self, items: list[Any]) -> None:
        """Run the tests of the task."""
        known = {item.nodeid: item for item in items}
        run([known[test] for test in self.tests], self.told)

    def answer(self, does: Callable[[], int | None]) -> None:
        """Send the exit code of a mutant, and what was said; receive the next one."""
        put(self.tree / self.file, self.source)
        self.pipe.send(apart(self.tree, does))
        self.receive()


def tasks(file: str, chosen: list[Mutant], tree: Path) -> tuple[list[Task], dict[str, Told]]:
    """What is to be done, where the tests are collected anew first; and what is known of tests."""
    source, found = (ROOT / file).read_bytes(), []
    at_once, told = measured(tree, file)
    for mutant in chosen:
        tests = [name for name in told if mutant.lines & (told[name].lines | at_once)]
        loud = [name for name in told if told[name].starts and name not in tests]
        changed = source[: mutant.start] + mutant.text.encode() + source[mutant.end :]
        anew = bool(at_once & (mutant.lines | mutant.function))
        found.append(Task(mutant, changed, tests if len(tests) >= FEW else tests + loud, anew))
    return sorted(found, key=lambda task: task.anew), told  # they are taken from the end


def examined(file: str, chosen: list[Mutant], jobs: int) -> Iterator[tuple[Mutant, bool]]:
    """Mutants, and whether each is noticed.

    Raises:
        SystemExit: if the file as it stands does not pass, or this program fails.
    """
    for library in LIBRARIES:
        with suppress(ImportError):  # the tests that need it are skipped
            import_module(library)
    context, pipes, workers = get_context("fork"), list[Connection](), []
    with tempfile.TemporaryDirectory() as folder:
        trees = [Path(folder).resolve() / str(job) / "tree" for job in range(jobs)]
        for tree in trees:
            copied(tree)
        waiting, told = tasks(file, chosen, trees[0])
        for tree in trees:
            pipe, other = context.Pipe()
            pipes.append(pipe)
            begin = (tree, file, told, other, [*pipes])
            workers.append(context.Process(target=Worker, args=begin, daemon=True))
            workers[-1].start()
            other.close()
        try:
            yield from answers(waiting, told, pipes)
        finally:
            for worker in workers:
                worker.terminate()
                worker.join()


def answers(
    waiting: list[Task], told: dict[str, Told], free: list[Connection]
) -> Iterator[tuple[Mutant, bool]]:
    """Give tasks to workers; of the tests those come first that have noticed most, in least time.

    Raises:
        SystemExit: if this program fails.
    """
    busy: dict[Any, Task] = {}
    kills = Counter[tuple[str, str]]()

    def cost(task: Task, test: str) -> float:
        return (0.005 + told[test].seconds) / (0.02 + kills[task.mutant.where, test])

    while waiting or busy:
        while waiting and free:
            task, pipe = waiting.pop(), free.pop()
            busy[pipe] = task
            pipe.send((task.source, task.anew, sorted(task.tests, key=partial(cost, task))))
        for pipe in wait([*busy]):
            task, (code, said) = busy.pop(pipe), pipe.recv()
            if code == BROKEN:
                raise SystemExit(f"{task.mutant.name}:\n{said}")
            kills[task.mutant.where, said.strip().rpartition("\n")[2]] += code == NOTICED
            free.append(pipe)
            if len(waiting) % 100 == 0:
                print(f"{len(waiting)} mutants are left", file=sys.stderr, flush=True)
            yield task.mutant, code != 0


def examine(file: str, options: argparse.Namespace) -> float:
    """Print the mutants that nobody notices, and the percentage that is noticed."""
    generated = mutants((ROOT / file).read_bytes())
    left_out = excused(file, [mutant.name for mutant in generated])
    chosen = [mutant for mutant in generated if options.match in mutant.name]
    if options.sample is not None and options.sample < len(chosen):
        chosen = random.Random(options.seed).sample(chosen, options.sample)
    tried = [mutant for mutant in chosen if mutant.name not in left_out]
    begin, noticed, done = time.monotonic(), 0, 0
    for mutant, is_noticed in examined(file, tried, options.jobs):
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
    parser.add_argument("files", nargs="*", default=[*TESTS], help="trusted files (default: all)")
    parser.add_argument("--sample", type=int, help="so many mutants, chosen at random")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=float("inf"), help="stop after so many")
    parser.add_argument("--least", type=float, default=95, help="percent (default 95)")
    parser.add_argument("--match", default="", help="only mutants whose name has this")
    found = parser.parse_args()
    signal.signal(signal.SIGINT, signal.default_int_handler)  # tests in the background, too, use it
    shares = [examine(file, found) for file in found.files]
    return int(min(shares) < found.least)


if __name__ == "__main__":
    sys.exit(main())
