"""The graph of a proof: facts, and which facts the proof of each one uses."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from html import escape

from verify.language.record import Record
from verify.language.statement import PRINTED, PROVED, REFUTED, Applies, Cite, Obligation
from verify.prover.outcome import Outcome
from verify.prover.uses import Node, nodes

FORMAT = "verify-graph/1"

#: Lightness tells proved from refuted, and so does the border of what is refuted.
_COLOURS = {
    "given": "#b8c4d6",
    "constant": "#d9d2e9",
    "definition": "#d9d2e9",
    "lemma": "#e8e8e8",
    PROVED: "#c3d9f5",
    REFUTED: "#ee9b3f",
    "assumed": "#fde9b0",
}


class Vertex(Record):
    """A fact or an assumption; ``state`` is its kind, or for an obligation its verdict."""

    name: str
    state: str
    context: str
    label: str


class Graph(Record):
    """Vertices, and edges from what is used to what uses it."""

    vertices: list[Vertex]
    edges: list[tuple[str, str]]


def graph(outcome: Outcome) -> Graph:
    """The facts of an outcome, with the assumptions that rows use and what corrects what."""
    found = nodes(outcome)
    rows = {row.name: (row, decision) for row, decision in outcome.rows}
    vertices, edges = [], []
    for node in found.values():
        vertices.append(_vertex(node, rows.get(node.name)))
        edges += [(used, node.name) for used in node.uses if used in found]
    own = (*outcome.own_assumptions, *outcome.printed_assumptions)
    vertices += [Vertex(a.name, "assumed", "", a.label) for a in own]
    names = {vertex.name for vertex in vertices}
    for cite in outcome.statement.cites:
        there = [Vertex(f"{cite.name}:{a.name}", "assumed", "", a.label) for a in cite.trusted]
        users = [row.name for row, _ in rows.values() if _applies(row, cite) and row.name in names]
        vertices += there
        edges += [(vertex.name, user) for vertex in there for user in users]
    for row, decision in rows.values():
        edges += [(name, row.name) for name in row.uses if name in names and row.name in names]
        corrected = decision.verdict == REFUTED and row.corrected_by in names
        if corrected and row.role == PRINTED:
            edges.append((row.name, str(row.corrected_by)))
    return Graph(vertices, edges)


def _applies(row: Obligation, cite: Cite) -> bool:
    """Whether a row applies a cited statement."""
    claim = row.claim
    return isinstance(claim, Applies) and claim.context.startswith(f"{cite.name}:")


def _vertex(node: Node, row: object) -> Vertex:
    if isinstance(row, tuple):
        return Vertex(node.name, row[1].verdict, node.context or "", row[0].label)
    return Vertex(node.name, node.kind, node.context or "", "")


def to_json(found: Graph) -> str:
    """One JSON document."""
    document = {
        "format": FORMAT,
        "vertices": [vertex._asdict() for vertex in found.vertices],
        "edges": [list(edge) for edge in found.edges],
    }
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def to_dot(found: Graph) -> str:
    """A file for Graphviz."""
    lines = ["digraph proof {", "  rankdir=LR; node [shape=box, style=filled, fontsize=9];"]
    for vertex in found.vertices:
        colour = _COLOURS.get(vertex.state, "#ffffff")
        border = ', penwidth=3, style="filled,dashed"' if vertex.state == REFUTED else ""
        lines.append(f'  "{vertex.name}" [fillcolor="{colour}"{border}];')
    lines += [f'  "{used}" -> "{user}";' for used, user in found.edges]
    return "\n".join([*lines, "}"]) + "\n"


def to_svg(found: Graph) -> str:
    """A drawing: each fact to the right of what it uses, its name and label as tooltip."""
    above: dict[str, list[str]] = {vertex.name: [] for vertex in found.vertices}
    for used, user in found.edges:
        above[user].append(used)
    level = levels(above)
    columns: dict[int, list[Vertex]] = {}
    for vertex in found.vertices:
        columns.setdefault(level[vertex.name], []).append(vertex)
    place = {
        vertex.name: (20 + 190 * place, 30 + 16 * i)
        for place, column in columns.items()
        for i, vertex in enumerate(column)
    }
    width = 40 + 190 * (max(columns, default=0) + 1)
    height = 70 + 16 * max(map(len, columns.values()), default=0)
    size = f'viewBox="0 0 {width} {height}" width="{width}" height="{height}"'
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} font-family="sans-serif" font-size="9">',
        f"<title>{len(found.vertices)} facts and assumptions of a proof</title>",
        *_lines(found, place),
        *(_box(vertex, *place[vertex.name]) for vertex in found.vertices),
        *_legend(height),
        "</svg>",
    ]
    return "\n".join(parts) + "\n"


def levels(above: Mapping[str, Iterable[str]]) -> dict[str, int]:
    """How far each fact is from what it rests on, in any order; no edge leads up.

    An edge that closes a circle does not count: one to a correction, or between formulas that rest
    on one another.
    """
    found: dict[str, int] = {}
    begun: set[str] = set()

    def visit(name: str) -> None:
        begun.add(name)
        sources = sorted(above[name])
        for one in sources:
            if one not in begun:
                visit(one)
        found[name] = 1 + max((found[one] for one in sources if one in found), default=-1)

    for name in above:
        if name not in begun:
            visit(name)
    return {name: found[name] for name in above}


def _lines(found: Graph, place: dict[str, tuple[int, int]]) -> Iterable[str]:
    for used, user in found.edges:
        (a, b), (c, d) = place[used], place[user]
        yield (
            f'<path d="M{a + 150} {b + 6} C{a + 175} {b + 6} {c - 25} {d + 6} {c} {d + 6}" '
            'fill="none" stroke="#888" stroke-width="0.3" opacity="0.6"/>'
        )


def _box(vertex: Vertex, x: int, y: int) -> str:
    name = vertex.name if len(vertex.name) <= 30 else vertex.name[:28] + "…"
    tip = escape(" ".join(part for part in (vertex.name, vertex.label, vertex.context) if part))
    return (
        f'<g><title>{tip}</title><rect x="{x}" y="{y}" width="150" height="12" rx="2" '
        f'fill="{_COLOURS.get(vertex.state, "#ffffff")}"{_border(vertex.state)}/>'
        f'<text x="{x + 3}" y="{y + 9}">{escape(name)}</text></g>'
    )


def _border(state: str) -> str:
    return ' stroke="#5a2a00" stroke-width="1.4" stroke-dasharray="3 2"' if state == REFUTED else ""


def _legend(height: int) -> Iterable[str]:
    for i, (state, colour) in enumerate(_COLOURS.items()):
        x = 20 + 95 * i
        box = f'<rect x="{x}" y="{height - 24}" width="10" height="10"'
        yield f'{box} fill="{colour}"{_border(state)}/>'
        yield f'<text x="{x + 14}" y="{height - 15}">{escape(state)}</text>'
