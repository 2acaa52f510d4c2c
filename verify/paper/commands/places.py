"""Where on the pages of the paper a name stands: that of a row, a line, a constant, or a given.

It is the line in which its entry begins.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache

from verify.language.argument import Line
from verify.paper.commands.pages import content, included, names, page
from verify.paper.commands.place import Place
from verify.wire.text.places import Places


@cache
def places() -> tuple[Place, ...]:
    """Every name on a page, in its order; the page of Theorem 1 comes first."""
    found: dict[tuple[str, str], Place] = {}
    for name in sorted(names(), key=lambda name: (name != "theorem1", name)):
        for place in _on_page(name):
            found.setdefault((place.name, place.part), place)
    return tuple(found.values())


def _on_page(name: str) -> list[Place]:
    """The places of a page in the order of its lines."""
    statement = page(name).statement
    texts = {f"{name}.toml": content(name), **included(name)}
    lines = {path: Places(path, text.decode()).key_lines for path, text in texts.items()}
    rows = {row.name: (row.label, row.says) for row in statement.obligations}

    def place(name: str, label: str, says: str, *written: tuple[str, ...]) -> Place:
        path, keys = next((p, keys) for p in lines for keys in written if keys in lines[p])
        return Place(name, label, says, f"verify/paper/{path}", lines[path][keys])

    found = [
        place(
            item.name,
            *rows.get(item.name, ("", "")),
            *_keys("rows", item.name),
            ("chapters", "rows", item.name.rpartition("-")[0]),
        )
        for chapter in page(name).chapters
        for item in chapter.items
        if isinstance(item, Line)
    ]
    for constant in statement.constants:
        said = (constant.label, f"the constant {constant.letter}")
        found.append(place(constant.name, *said, *_keys("constants", constant.name)))
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


def _keys(table: str, name: str) -> Iterator[tuple[str, ...]]:
    """The keys under which a name may stand: in one of the sets it may be without that of its set.

    A name under its full key is not that of another set.
    """
    for key in (name, name.partition(".")[2]):
        yield from ((table, key), ("chapters", table, key))
