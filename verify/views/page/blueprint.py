"""The proof as a graph of the paper's formulas: which rests on which, printed against repaired."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from html import escape

from verify.language.record import Record
from verify.language.statement import PRINTED, REFUTED, Applies, Cite, Obligation
from verify.prover.outcome import Outcome
from verify.prover.uses import nodes
from verify.publication import Publication
from verify.views.plots import drawing
from verify.views.plots.drawing import pattern
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


def edges_between_labels(outcome: Outcome) -> Edges:
    """For each label those whose facts it uses, directly or through facts without a label."""
    rows = {row.name: row for row, _ in outcome.rows}
    found = nodes(outcome)
    label = {name: rows[name].label if name in rows else "" for name in found}
    label |= {a.name: a.label for a in (*outcome.own_assumptions, *outcome.printed_assumptions)}
    used = {name: [*node.uses, *rows[name].uses] if name in rows else [*node.uses]
            for name, node in found.items()}  # fmt: skip
    for cite in outcome.statement.cites:
        there = {f"{cite.name}:{a.name}": a.label for a in cite.trusted}
        label |= there
        for name in rows.keys() & used.keys():
            used[name] += there if _applies(rows[name], cite) else ()
    behind: dict[str, set[str]] = {}
    edges: Edges = {}
    for name, own in label.items():  # facts come after those that they use
        sources: set[str] = set()
        for source in used.get(name, ()):
            known = label.get(source)
            sources |= {known} if known else behind.get(source, set())
        behind[name] = sources
        if own:
            edges.setdefault(own, set()).update(sources - {own})
    return edges


def _applies(row: Obligation, cite: Cite) -> bool:
    """Whether a row applies a cited statement."""
    claim = row.claim
    return isinstance(claim, Applies) and claim.context.startswith(f"{cite.name}:")


def levels(above: Edges) -> dict[str, int]:
    """How far each formula is from what it rests on, in any order; no edge leads up.

    An edge that closes a circle does not count: formulas may rest on one another.
    """
    found: dict[str, int] = {}
    begun: set[str] = set()

    def visit(label: str) -> None:
        begun.add(label)
        sources = sorted(above[label])
        for one in sources:
            if one not in begun:
                visit(one)
        found[label] = 1 + max((found[one] for one in sources if one in found), default=-1)

    for label in above:
        if label not in begun:
            visit(label)
    return {label: found[label] for label in above}


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
    edges = edges_between_labels(everywhere)
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
            drawing.begun(WIDTH, height, told, 'role="group"'),
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
