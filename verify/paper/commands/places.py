"""Where in `verify/paper/` a name stands: that of a row, a line, a constant, or something given.

On a page it is the line that begins with the name. The modules of the paper yield what they say. A
generator that hands over to another one tells which one is at work, and where; in a table that it
yields each row begins a line with its name. So no table of places is kept by hand.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from linecache import getline
from pathlib import Path
from pkgutil import walk_packages
from types import CodeType, GeneratorType, ModuleType
from typing import Any

from verify import paper
from verify.language.argument import Chapter, Line, Opened
from verify.language.statement import Context, Obligation
from verify.paper.commands.pages import content, included, names, page
from verify.paper.commands.place import ROOT, Place
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import PRINTED, REPAIRED
from verify.spheres import flow, scene
from verify.wire.text.places import keys_of

#: What a generator of the paper may ask for, by its annotation.
ARGUMENTS: dict[str, tuple[Any, ...]] = {
    "ConstantSet": (ConstantSet(PRINTED), ConstantSet(REPAIRED)),
}

#: A table of a page, and a key in it; what goes on in the next lines is indented.
HEADER = re.compile(r"\[+([^\[\]]+)\]+\s*(?:#.*)?")
KEY = re.compile(r"""([\w."'-]+)\s*=""")


@cache
def places() -> tuple[Place, ...]:
    """Every name on a page, in its order, and then every one that a module of the paper yields.

    The modules that only collect what others yield come last, and add what is theirs alone.
    """
    found: dict[tuple[str, str], Place] = {}
    for name in names():
        for place in _on_page(name):
            found.setdefault((place.name, place.part), place)
    for module in _modules():
        for place in _written_in(module):
            if not (_collects(module.__name__) and (place.name, "") in found):
                found.setdefault((place.name, place.part), place)
    return tuple(found.values())


# --- pages ----------------------------------------------------------------------------------------


def _on_page(name: str) -> list[Place]:
    """The places of a page in the order of its lines."""
    statement = page(name).statement
    texts = {f"{name}.toml": content(name), **included(name)}
    lines = {path: _lines(text.decode()) for path, text in texts.items()}
    rows = {row.name: (row.label, row.says) for row in statement.obligations}

    def place(name: str, label: str, says: str, *written: tuple[str, ...]) -> Place:
        path, keys = next((p, keys) for p in lines for keys in written if keys in lines[p])
        return Place(name, label, says, f"verify/paper/{path}", lines[path][keys])

    found = [
        place(
            item.name,
            *rows.get(item.name, ("", "")),
            *(("chapters", "rows", key) for key in (item.name, item.name.rpartition("-")[0])),
        )
        for chapter in page(name).chapters
        for item in chapter.items
        if isinstance(item, Line)
    ]
    for context in statement.contexts:
        here, said = ("contexts", context.name), ("", f"in the context {context.name}")
        for given in context.givens:
            kind = "given" if given.kind == "plain" else given.kind
            found.append(place(given.name, *said, (*here, kind, given.name)))
        for constant in context.constants:
            short = constant.name.removeprefix(f"{context.name}.")
            keys = ((*here, "constants", key) for key in (constant.name, short, f".{short}"))
            found.append(place(constant.name, *said, *keys))
    return sorted(found, key=lambda place: (place.path, place.line))


def _lines(text: str) -> dict[tuple[str, ...], int]:
    """The line in which each key of a page stands, by all keys that lead to it."""
    table: tuple[str, ...] = ()
    found: dict[tuple[str, ...], int] = {}
    for number, line in enumerate(text.splitlines(), 1):
        if header := HEADER.fullmatch(line):
            table = tuple(keys_of(header[1]))
            found.setdefault(table, number)
        elif key := KEY.match(line):
            keys = keys_of(key[1])
            found.setdefault((*table, keys[0]), number)
    return found


# --- modules --------------------------------------------------------------------------------------


def _modules() -> list[ModuleType]:
    names = []
    for room in (paper, flow, scene):
        names += [m.name for m in walk_packages(room.__path__, f"{room.__name__}.")]
    rows = sorted(names, key=lambda name: (_collects(name), name))
    return [import_module(name) for name in rows if ".commands" not in name]


def _collects(module: str) -> bool:
    """Whether a module is that of a whole theorem: `theorem`, or named like its folder."""
    *_, folder, name = module.split(".")
    return name in ("theorem", folder)


def _written_in(module: ModuleType) -> Iterator[Place]:
    for function in [f for f in vars(module).values() if inspect.isfunction(f)]:
        if function.__module__ == module.__name__ and not function.__name__.startswith("_"):
            for arguments in _arguments(function):
                if inspect.isgeneratorfunction(function):
                    yield from _yielded(function(*arguments))
                elif inspect.signature(function).return_annotation == "Context":
                    yield from _known(function(*arguments), *_start(function))


def _arguments(function: Callable[..., Any]) -> Iterator[tuple[Any, ...]]:
    """The arguments of a function where they are known: none, or one of `ARGUMENTS`."""
    asked = [p for p in inspect.signature(function).parameters.values() if p.default is p.empty]
    if not asked:
        yield ()
    elif len(asked) == 1:
        yield from ((argument,) for argument in ARGUMENTS.get(asked[0].annotation, ()))


def _yielded(running: Any) -> Iterator[Place]:
    for item in running:
        code, line = _at_work(running)
        for row in item.items if isinstance(item, Chapter) else (item,):
            if isinstance(row, Obligation | Line):
                yield Place(row.name, row.label, row.says, _path(code), _entry(row, code, line))
            elif isinstance(row, Opened):
                yield from _known(row.context, _path(code), line)


def _known(context: Context, path: str, line: int) -> Iterator[Place]:
    """Places of the givens and constants of a context."""
    names = [*(given.name for given in context.givens), *(c.name for c in context.constants)]
    for name in names:
        yield Place(name, "", f"in the context {context.name}", path, line)


def _entry(row: Obligation | Line, code: CodeType, start: int) -> int:
    """The line of a row, or its own line in the table that begins at ``start``."""
    names = "|".join(re.escape(name) for name in (row.name, row.name.partition(".")[2]) if name)
    entry = re.compile(rf'\s*(?:yield |yield from |\*)?([\w.]+)\(f?"(?:{{\w+}}\.)?(?:{names})"')
    true = isinstance(row, Obligation) and row.severity is None
    end = max(line or 0 for _, _, line in code.co_lines())
    for number in range(start, end + 1):
        found = entry.match(getline(code.co_filename, number))
        if found and not (true and found[1].endswith("misprint")):
            return number
    return start


def _at_work(running: Any) -> tuple[CodeType, int]:
    """The innermost function of a module that yields, and the line of its statement."""
    inner = running
    while isinstance(running.gi_yieldfrom, GeneratorType):
        running = running.gi_yieldfrom
        if "." not in running.gi_code.co_qualname:  # a method serves many places
            inner = running
    return inner.gi_code, inner.gi_frame.f_lineno


def _start(function: Any) -> tuple[str, int]:
    return _path(function.__code__), function.__code__.co_firstlineno


def _path(code: CodeType) -> str:
    return Path(code.co_filename).resolve().relative_to(Path(ROOT).resolve()).as_posix()
