"""Matplotlib drawings as inline SVG that follows the colours of the page.

This is the only module that imports matplotlib. A drawing is made in placeholder colours; each is
then replaced by a variable of the page's style sheet, so that one drawing serves light, dark and
paper. No date, no version, a fixed salt: the same bytes from the same matplotlib.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from io import StringIO
from typing import Any

from verify.language.record import Record


class MatplotlibMissingError(ImportError):
    """The drawings need matplotlib, which is not installed; the message says what to do."""


#: The colours that a drawing may use: a placeholder, and the variable that it stands for.
COLOURS = {
    "ink": "#010203",
    "faint": "#010204",
    "proved": "#010205",
    "refuted": "#010206",
    "proved-area": "#010209",
    "refuted-area": "#01020a",
    "undecided": "#010207",
    "paper": "#010208",
    **{f"series-{i}": f"#01021{i}" for i in range(1, 8)},
}

_LIGHT = """
ink #1c2128, faint #8a929c, undecided #c3c8ce, paper #ffffff, proved #0b7a5b, refuted #b3372a,
proved-area #0b7a5b, refuted-area #b3372a, series-1 #3566b8, series-2 #b8741a, series-3 #0b7a5b,
series-4 #8a4fa3, series-5 #b3372a, series-6 #4b8fa0, series-7 #77803a"""
_DARK = """
ink #e4e7ea, faint #7d8691, undecided #4a525c, paper #14181d, proved #3fbf97, refuted #ef7a6a,
proved-area #23805f, refuted-area #a8453a, series-1 #7ea6ee, series-2 #e0a658, series-3 #3fbf97,
series-4 #c592dc, series-5 #ef7a6a, series-6 #7cc3d3, series-7 #b9c36c"""

#: What the variables stand for, in either scheme.
SCHEMES = {
    scheme: dict(pair.split() for pair in text.split(","))
    for scheme, text in (("light", _LIGHT), ("dark", _DARK))
}

#: How matplotlib writes a box; the same is said with half as many numbers.
_RECTANGLE = re.compile(r"M (\S+) (\S+) L (\S+) \2 L \3 (\S+) L \1 \4 (?:L \1 \2 )?z ?")

Draw = Callable[[Any], None]
Boxes = Iterable[tuple[float, float, float, float]]


class Panel(Record):
    """One pair of axes: its title, how it is drawn, and its size in points."""

    title: str
    draw: Draw
    width: int = 400
    height: int = 330


def pyplot() -> Any:
    """Matplotlib, set up once per call for text that stays text.

    Raises:
        MatplotlibMissingError: where it is not installed.
    """
    try:
        import matplotlib
    except ImportError as error:
        raise MatplotlibMissingError(
            "the plots of the report need matplotlib; install it with: pip install -e '.[report]'"
        ) from error
    matplotlib.use("svg")
    import matplotlib.pyplot as plt

    ink, faint = COLOURS["ink"], COLOURS["faint"]
    plt.rcdefaults()
    plt.rcParams.update(
        {
            "svg.fonttype": "none",
            "svg.hashsalt": "verify-collapse",
            "font.size": 11,
            "text.color": ink,
            "axes.labelcolor": ink,
            "axes.edgecolor": faint,
            "axes.facecolor": "none",
            "figure.facecolor": "none",
            "xtick.color": faint,
            "ytick.color": faint,
            "xtick.labelcolor": ink,
            "ytick.labelcolor": ink,
            "axes.titlesize": 11,
            "axes.unicode_minus": True,
            "legend.frameon": False,
            "legend.fontsize": 10,
            "path.simplify": False,
        }
    )
    return plt


def svg(name: str, panels: Sequence[Panel], description: str) -> str:
    """One SVG element with the panels side by side; ``name`` keeps its ids apart from others."""
    plt = pyplot()
    width = sum(panel.width for panel in panels)
    height = max(panel.height for panel in panels)
    figure, axes = plt.subplots(
        1, len(panels), figsize=(width / 72, height / 72), squeeze=False, layout="constrained"
    )
    for axis, panel in zip(axes[0], panels, strict=True):
        axis.set_title(panel.title, loc="left")
        panel.draw(axis)
    buffer = StringIO()
    nothing = dict.fromkeys(("Date", "Creator", "Format", "Type"))
    figure.savefig(buffer, format="svg", metadata=nothing)
    plt.close(figure)
    return _tidy(buffer.getvalue(), name, description)


def standalone(drawing: str) -> str:
    """The drawing as a file of its own, with both sets of colours."""
    rules = {
        scheme: ";".join(f"--{name}:{colour}" for name, colour in colours.items())
        for scheme, colours in SCHEMES.items()
    }
    style = (
        f"<style>svg{{{rules['light']};background:var(--paper)}}"
        f"@media (prefers-color-scheme:dark){{svg{{{rules['dark']}}}}}</style>"
    )
    head, end, rest = drawing.partition(">")
    return f"{head}{end}{style}{rest}\n"


def _tidy(text: str, name: str, description: str) -> str:
    text = text[text.index("<svg") :].strip()
    box = re.search(r'viewBox="([^"]*)"', text)
    if box is None:
        raise ValueError("matplotlib wrote no viewBox")
    body = text[text.index(">") + 1 :]
    body = re.sub(r"<metadata>.*?</metadata>", "", body, flags=re.DOTALL)
    body = re.sub(r"<!--.*?-->", "", body, flags=re.DOTALL)
    body = re.sub(r'\bid="([^"]*)"', rf'id="{name}-\1"', body)
    body = re.sub(r'href="#([^"]*)"', rf'href="#{name}-\1"', body)
    body = re.sub(r"url\(#([^)]*)\)", rf"url(#{name}-\1)", body)
    body = re.sub(r'(?<= d=")[^"]*', lambda match: _shortened(match[0]), body)
    body = re.sub(r"(font: [^;\"]*?px) [^;\"]*", r"\1 system-ui, sans-serif", body)
    body = re.sub(r"\n\s*", "\n", body)
    body = _RECTANGLE.sub(r"M\1 \2H\3V\4H\1z", body).replace("xlink:href", "href")
    for colour, placeholder in COLOURS.items():
        body = body.replace(placeholder, f"var(--{colour})")
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="{box[1]}" role="img" '
        f'aria-label="{description}">{body}'
    )


def _shortened(path: str) -> str:
    text = re.sub(r"-?[0-9]+\.[0-9]+", lambda match: f"{float(match[0]):.2f}", path)
    return _RECTANGLE.sub(r"M\1 \2H\3V\4H\1z", " ".join(text.split()))


def boxes(
    axis: Any,
    corners: Boxes,
    colour: str,
    opacity: float = 1.0,
    name: str = "",
    edge: float = 0.25,
) -> None:
    """Draw boxes, each ``(left, right, bottom, top)``, as one shape.

    Its edge has the same colour: it hides the seams between neighbours, and keeps boxes visible
    that are thinner than a line.
    """
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path

    points: list[tuple[float, float]] = []
    codes: list[Any] = []
    for left, right, low, high in corners:
        points += [(left, low), (right, low), (right, high), (left, high), (left, low)]
        codes += [Path.MOVETO, *[Path.LINETO] * 3, Path.CLOSEPOLY]
    if points:
        patch = PathPatch(
            Path(points, codes),
            facecolor=COLOURS[colour],
            edgecolor=COLOURS[colour],
            linewidth=edge if opacity == 1 else 0,
            alpha=opacity,
            label=name or None,
        )
        axis.add_patch(patch)


def merged(cells: Iterable[tuple[Fraction, Fraction, Fraction, Fraction]]) -> Boxes:
    """The same area in fewer boxes: neighbours of one height are joined, then of one width."""
    rows = _joined((low, high, left, right) for left, right, low, high in cells)
    columns = _joined((left, right, low, high) for low, high, left, right in rows)
    return [(float(a), float(b), float(c), float(d)) for a, b, c, d in columns]


def _joined(
    cells: Iterable[tuple[Fraction, Fraction, Fraction, Fraction]],
) -> list[tuple[Fraction, Fraction, Fraction, Fraction]]:
    result: list[tuple[Fraction, Fraction, Fraction, Fraction]] = []
    for a, b, c, d in sorted(cells):
        if result and result[-1][:2] == (a, b) and result[-1][3] == c:
            result[-1] = (a, b, result[-1][2], d)
        else:
            result.append((a, b, c, d))
    return result
