"""The proof as a graph of the paper's formulas: which rests on which, printed against repaired."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape

from verify.language.record import Record
from verify.language.statement import PRINTED, REFUTED, Publication
from verify.prover.outcome import Outcome
from verify.views.graph import Graph, graph, levels
from verify.views.plots.drawing import begun, pattern
from verify.views.words import fair, in_letters

#: So many sentences are told of a formula when it is pointed at.
TOLD = 5
WIDTH, COLUMNS = 420, 4
BOX, HEIGHT, STEP = 92, 40, 76

Edges = dict[str, set[str]]


class Formula(Record):
    """A formula of the paper: its label, number, what it says, and the refuted printed rows."""

    label: str
    number: str
    rows: int
    refuted: Sequence[str]
    says: Sequence[str]


def edges_between_labels(found: Graph) -> Edges:
    """For each label those whose facts it uses, directly or through facts without a label."""
    label = {vertex.name: vertex.label for vertex in found.vertices}
    used: dict[str, list[str]] = {name: [] for name in label}
    for source, user in found.edges:
        used[user].append(source)
    behind: dict[str, set[str]] = {}
    edges: Edges = {}
    for vertex in found.vertices:  # facts come after those that they use
        sources: set[str] = set()
        for name in used[vertex.name]:
            sources |= {label[name]} if label[name] else behind.get(name, set())
        behind[vertex.name] = sources
        if vertex.label:
            edges.setdefault(vertex.label, set()).update(sources - {vertex.label})
    return edges


def lowered(level: Mapping[str, int], edges: Edges) -> dict[str, int]:
    """Each formula that another rests on is just above the first that does: lines are short."""
    found = dict(level)
    for label in sorted(level, key=lambda label: -level[label]):
        below = [found[user] for user, sources in edges.items() if label in sources]
        users = [place for place in below if place > level[label]]
        found[label] = min(users, default=found[label] + 1) - 1
    return found


def direct(edges: Edges, level: Mapping[str, int]) -> Edges:
    """The edges that lead down, without those that follow from others."""
    down = {
        label: {source for source in sources if level.get(source, level[label]) < level[label]}
        for label, sources in edges.items()
    }
    above: Edges = {}
    for label in sorted(down, key=lambda label: level[label]):
        above[label] = set(down[label]).union(*(above.get(source, ()) for source in down[label]))
    return {
        label: {
            source
            for source in sources
            if not any(source in above.get(other, ()) for other in sources)
        }
        for label, sources in down.items()
    }


def proof_drawing(everywhere: Outcome, point: Outcome, paper: Publication) -> str:
    """The graph of the theorem for all parameters; what is refuted at the point is hatched."""
    edges = edges_between_labels(graph(everywhere))
    formulas = {label: _formula(label, everywhere, point, paper) for label in edges}
    level = lowered(levels(edges), edges)
    place = dict(_places(level))
    height = max(y for _, y in place.values()) + HEIGHT + 60
    told = (
        f"{len(formulas)} formulas of the paper as boxes, each below those that it rests on; "
        f"{sum(bool(f.refuted) for f in formulas.values())} of them, hatched orange, have printed "
        "steps that are refuted."
    )
    return "\n".join(
        [
            begun(WIDTH, height, told, 'role="group"'),
            f"<defs>{pattern('proof-hatch', 'refuted-area')}</defs>",
            *_lines(direct(edges, level), place),
            *(_box(formulas[label], *place[label]) for label in edges),
            *_legend(height - 24),
            "</svg>",
        ]
    )


def _formula(label: str, everywhere: Outcome, point: Outcome, paper: Publication) -> Formula:
    rows = [in_letters(row.says) for row, _ in everywhere.rows if row.label == label]
    trusted = [f"assumed: {one.name}" for one in everywhere.assumptions if one.label == label]
    refuted = [
        row
        for row, found in point.rows
        if row.label == label and row.role == PRINTED and fair(point, row, found) == REFUTED
    ]
    says = [*(f"✗ {in_letters(row.says)}" for row in refuted), *rows, *trusted]
    more = [f"and {len(says) - TOLD} more"] if len(says) > TOLD else []
    names = [row.name for row in refuted]
    return Formula(label, paper.number(label), len(rows), names, [*says[:TOLD], *more])


def _places(found: Mapping[str, int]) -> Iterator[tuple[str, tuple[float, float]]]:
    """A level has as many lines as it needs, each with at most so many boxes."""
    line = 0
    for level in range(max(found.values(), default=-1) + 1):
        here = [label for label, own in found.items() if own == level]
        for start in range(0, len(here), COLUMNS):
            part = here[start : start + COLUMNS]
            gap = (WIDTH - BOX * len(part)) / (len(part) + 1)
            for number, label in enumerate(part):
                yield label, (gap + number * (BOX + gap), 10 + STEP * line)
            line += 1


def _lines(edges: Edges, place: Mapping[str, tuple[float, float]]) -> Iterable[str]:
    for label, sources in edges.items():
        for source in sorted(sources & place.keys()):
            (a, b), (c, d) = place[source], place[label]
            x, y, u, v = a + BOX / 2, b + HEIGHT, c + BOX / 2, d
            yield (
                f'<path d="M{x:.0f} {y:.0f}C{x:.0f} {y + 24:.0f} {u:.0f} {v - 24:.0f} '
                f'{u:.0f} {v:.0f}" fill="none" stroke="var(--faint)" stroke-width="0.8"/>'
            )


def _box(formula: Formula, x: float, y: float) -> str:
    target = formula.refuted[0] if formula.refuted else "repaired"
    fill = "url(#proof-hatch)" if formula.refuted else "var(--paper)"
    sign = f"✗ {len(formula.refuted)} refuted" if formula.refuted else _count(formula.rows)
    rim = "refuted" if formula.refuted else "proved"
    told = "\n".join([formula.label, *formula.says])
    middle = x + BOX / 2
    inner = 'fill="var(--paper)"' if formula.refuted else 'fill="none"'
    return (
        f'<a href="#{target}"><title>{escape(told)}</title>'
        f'<rect x="{x:.0f}" y="{y:.0f}" width="{BOX}" height="{HEIGHT}" rx="5" fill="{fill}" '
        f'stroke="var(--{rim})" stroke-width="1.6"/>'
        f'<rect x="{x + 5:.0f}" y="{y + 3:.0f}" width="{BOX - 10}" height="{HEIGHT - 6}" rx="3" '
        f"{inner}/>"
        f'<text x="{middle:.0f}" y="{y + 17:.0f}" text-anchor="middle" font-weight="600" '
        f'fill="var(--ink)">{escape(formula.number)}</text>'
        f'<text x="{middle:.0f}" y="{y + 33:.0f}" text-anchor="middle" font-size="12.5" '
        f'fill="var(--{rim})">{sign}</text></a>'
    )


def _count(rows: int) -> str:
    return f"✓ {rows} row{'s' * (rows > 1)}" if rows else "assumed"


def _legend(y: float) -> Iterable[str]:
    for x, fill, rim, text in (
        (14, "var(--paper)", "proved", "all rows hold"),
        (170, "url(#proof-hatch)", "refuted", "printed steps refuted"),
    ):
        yield (
            f'<rect x="{x}" y="{y - 12:.0f}" width="20" height="14" rx="3" fill="{fill}" '
            f'stroke="var(--{rim})"/><text x="{x + 27}" y="{y:.0f}" fill="var(--ink)">{text}</text>'
        )
