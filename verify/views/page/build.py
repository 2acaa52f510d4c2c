"""The files of the report: one template says it all, page by page."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from verify import __version__
from verify.language.record import Record
from verify.language.statement import PRINTED, PROVED, REFUTED
from verify.language.terms import Claim
from verify.language.typeset import LONG
from verify.prover.decimals import outward
from verify.prover.outcome import Outcome
from verify.publication import BREAKS, HARMLESS, OTHERWISE, REMARK, REPAIRED, SLIP
from verify.views import all_parameters, classification, words
from verify.views.findings import Material
from verify.views.mathml import MathML
from verify.views.page import rows
from verify.views.page.blueprint import proof_drawing
from verify.views.plots import Pictures, collapses, figures, maps, separatrix
from verify.views.plots.collapse import animation, film
from verify.views.plots.drawing import standalone, svg
from verify.views.plots.letters import letters_drawing
from verify.views.plots.shapes import Figure, Panel
from verify.views.point import causes, in_numbers, place
from verify.views.style import style
from verify.views.template import in_html

TITLE = "Three particles collapse: what is proved"
#: The style sheet of all pages, with their font.
STYLE = "pages/style.css"
#: Where the scenes are: a folder of folders.
SCENES = "scenes/"

#: The classes of refuted steps, the worst first: anchor and title.
CLASSES = (
    (BREAKS, "breaking", "Steps that break the argument"),
    (HARMLESS, "harmless", "False, but harmless there"),
    (SLIP, "slips", "Slips of wording"),
    (None, "", ""),
)
SETS = (
    ("", "The first constants"),
    (PRINTED, "The set as printed"),
    (REPAIRED, "The repaired set"),
)
PLOTS = {
    "region": "For which r and θ₀",
    "margins": "How close each step is",
    "roots": "The roots of Q",
}
MEASURED = (
    ("bench", "speed", "Speed", "verify bench"),
    ("stress", "stability", "Numerical stability on hard cases", "verify stress"),
)


def files(material: Material, *, draw: bool) -> dict[str, bytes]:
    """Every file of the report; without drawings the page has none, and there is no picture."""
    pictures = _pictures(material)
    drawn = {figure.name: _drawn(figure) if draw else [] for figure in pictures.all}
    made: dict[str, bytes] = {}
    if draw:
        for name, story in material.stories.items():
            drawn[name].insert(0, animation(film(story), name))
        region = material.plotted.region.everywhere
        drawn["proof"] = [proof_drawing(region, material.main, material.paper)]
        drawn["letters"] = [letters_drawing()]
        made["picture.svg"] = standalone(readme_picture(pictures.plots[0])).encode()
    found = _content(material) | {"pictures": pictures, "drawn": drawn}
    parts = list(_parts(found))
    found |= {"contents": [part for part in parts if part.short], "STYLE": STYLE, "css": ""}
    pages = {part.file: in_html("page.j2", found | {"part": part}, FILTERS) for part in parts}
    return {
        **{name: content.encode() for name, content in joined(pages, draw).items()},
        STYLE: style().encode(),
        "constants.tex": found["latex"].encode(),
        **made,
    }


# --- the pages -----------------------------------------------------------------------------------


class Part(Record):
    """A page: its file, its title, its name in the contents, and the macro that says it, of what.

    A part without a name in the contents is found from another one.
    """

    file: str
    title: str
    short: str
    says: str
    of: tuple[Any, ...] = ()


def _parts(found: Mapping[str, Any]) -> Iterator[Part]:
    """The pages, in the order in which a referee asks."""
    material = found["material"]
    yield Part("index.html", TITLE, "What is proved", "first")
    for name, named, says, of in (
        ("theorem", "Theorem 1, whole", "whole", True),
        ("printed", "What is wrong in the printed proof", "defects", found["printed_rows"]),
        ("proof", "The proof as a graph", "proof", True),
        ("repaired", "The repaired proof, row by row", "repaired_proof", True),
        ("holds", "Printed steps that hold", "printed_steps_that_hold", True),
        ("letters", "The letters", "the_letters", True),
        ("constants", "Constants", "numbers", True),
        ("scenes", "Scenes", "what_happens", found["scenes"]),
        ("maps", "Maps", "where_it_collapses", material.maps),
        ("curve", "The separatrix", "the_separatrix", found["pictures"].curves),
        ("theorems", "The other theorems", "theorems", found["others"]),
        ("trust", "What has to be believed", "trust", True),
    ):
        if of:
            yield Part(_file(name), named, named, says)
    for figure in found["pictures"].plots[1 : 1 + len(PLOTS)]:
        named = PLOTS[figure.name]
        yield Part(_file(figure.name), named, named, "plot", (named, figure))
    for one in MEASURED:
        if one[0] in material.measurements:
            yield Part(_file(one[1]), one[2], one[2], "measured", (one,))
    yield Part(_file("files"), "Versions and digests", "Versions and digests", "versions")
    for folder in found["others"]:
        yield Part(_file(folder.name), title(folder.outcome), "", "row_by_row", (folder,))


def _file(name: str) -> str:
    return f"pages/{name}.html"


def joined(pages: Mapping[str, str], draw: bool) -> dict[str, str]:
    """The pages, with each link to a place on another page, or to a file, as seen from there.

    Without drawings, a place that no page has is taken for a curve on the same page.

    Raises:
        KeyError: if a link leads to a place that no page has.
    """
    ids = {name: re.findall(r' id="([^"]*)"', text) for name, text in pages.items()}
    homes = {one: name for name, found in ids.items() for one in found}

    def relocated(page: str, text: str) -> str:
        def link(match: re.Match[str]) -> str:
            target, _, place = match[2].partition("#")
            here = place in ids[page] or not (draw or place in homes)
            if target == "data:," or (not target and here):
                return match[0]
            path = os.path.relpath(target or homes[place], os.path.dirname(page) or ".")
            return f'{match[1]}="{path}{"#" if place else ""}{place}"'

        return re.sub(r'(\bhref)="([^"]*)"', link, text)

    return {name: relocated(name, text) for name, text in pages.items()}


# --- drawings ------------------------------------------------------------------------------------


def _pictures(material: Material) -> Pictures:
    precision = material.measurements.get("bench", {}).get("precision")
    told = (
        "Each box is a formula of the paper, by its printed number, and a link to its rows; what "
        "these say is told when it is pointed at. Lines lead down from what a formula rests on; a "
        "line that follows from others is left out. "
        "Where no line leads down from a box, Theorem 1 does without its rows in this certificate. "
        "Assumed: a sentence that is taken on trust. Hatched: printed steps with this label are "
        f"refuted at {place(material.main)}."
    )
    state = "Three spheres just after a collision of 0 and s; the next one is that of 0 and c."
    return Pictures(
        figures(material.plotted, precision),
        Figure("proof", "Theorem 1, repaired, for all parameters", told, ()),
        Figure("letters", "A state just after a collision", state, ()),
        collapses(material.stories),
        maps(material.maps, material.strips),
        [] if material.separatrix is None else [separatrix.figure(*material.separatrix)],
    )


def _drawn(figure: Figure) -> list[str]:
    """The panels of a figure."""
    return [
        svg(f"{figure.name}-{number}", [panel], alternative_text(figure, panel))
        for number, panel in enumerate(figure.panels)
    ]


def alternative_text(figure: Figure, panel: Panel) -> str:
    """What a panel shows, for readers who cannot see it."""
    return " ".join(part for part in (f"{figure.title}: {panel.title}.", panel.told) if part)


def readme_picture(figure: Figure) -> str:
    """All panels of a figure in one drawing."""
    return svg(
        "picture", figure.panels, " ".join(alternative_text(figure, p) for p in figure.panels)
    )


# --- the template --------------------------------------------------------------------------------


def title(outcome: Outcome) -> str:
    """The title of a theorem as the start of a sentence."""
    return words.begun(words.in_letters(outcome.statement.title))


def constant(outcome: Outcome, name: str) -> rows.Number | None:
    """The value of a constant of the repaired set."""
    return rows.number_of(words.ends_of(outcome, f"{REPAIRED}.{name}"))


def of_severity(found: Iterable[rows.Row], severity: str | None) -> list[rows.Row]:
    """The rows of one class."""
    return [(row, decision) for row, decision in found if row.severity == severity]


#: What the template asks of outcomes and rows.
FILTERS = (
    *(
        constant,
        words.constants_of,
        words.counts,
        words.headline,
        words.rests_on_more,
        in_numbers,
        of_severity,
        place,
        title,
    ),
    *(rows.of_role, rows.rows_as_printed, rows.with_verdict),
)


def _content(material: Material) -> dict[str, Any]:
    """What the template speaks of."""
    main, paper = material.main, material.paper
    printed = rows.rows_as_printed(main)
    refuted = rows.with_verdict(printed, REFUTED, main)
    breaking = of_severity(refuted, BREAKS)
    proved = rows.with_verdict(main.of_group(REPAIRED), PROVED, main)
    apart = [folder for folder in material.folders if folder.name.startswith(SCENES)]
    region = material.plotted.region.everywhere
    return {
        "material": material,
        "main": main,
        "everywhere": material.about(region.statement.theorem),
        "scenes": apart,
        "others": [
            folder
            for folder in material.folders
            if folder.outcome.statement.theorem != paper.theorem and folder not in apart
        ],
        "printed_rows": printed,
        "refuted": refuted,
        "otherwise": rows.with_verdict(printed, OTHERWISE, main),
        "remarks": rows.with_verdict(printed, REMARK, main),
        "why": [line.strip() for line in causes([r for r, _ in breaking], paper)],
        "OTHERWISE": OTHERWISE,
        "REMARK": REMARK,
        "BREAKS": BREAKS,
        "closing": sum(isinstance(row.claim, Claim) for row, _ in proved),
        "writer": rows.Writer(main, paper),
        "writer_of": lambda outcome: rows.Writer(outcome, paper),
        "given": lambda outcome: words.given_by(outcome, paper),
        "believed": lambda outcome: words.believed(outcome, paper),
        "printed": paper.printed,
        "fatal": paper.fatal,
        "severity": paper.severity,
        "coq": checked_in_coq(material),
        "latex": latex(main),
        "whole_latex": all_parameters.latex(material.whole),
        "whole_set": all_parameters.SET,
        "whole_more": all_parameters.FLIGHT,
        "whole_math": MathML({n: tex for n, (_, tex) in material.whole.letters.items()}),
        "whole_text": all_parameters.plain(material.whole),
        "Math": rows.Math,
        "subtitle": (
            f"{paper.authors}, {paper.title} ({paper.text_read}; its companion is "
            f"{paper.companion}): Theorem 1 and the spectrum of its linear model, every "
            "inequality decided in rigorous arithmetic."
        ),
        "version": __version__,
        "TITLE": TITLE,
        "CLASSES": CLASSES,
        "SETS": SETS,
        "MEASURED": MEASURED,
        "EVERYWHERE_IN_WORDS": all_parameters.CLAIM,
        "SETTING": classification.SETTING,
        "THEOREMS": classification.THEOREMS,
        "LONG": LONG,
        "MANY": rows.MANY,
    }


def checked_in_coq(material: Material) -> str:
    """All, or how many and which not: a file that has changed since is not counted."""
    checked = material.coq.checked
    missing = [name for name, is_checked in checked.items() if not is_checked]
    number = f"{sum(checked.values())} of {len(checked)}" if missing else f"all {len(checked)}"
    but = (
        f"; not {', '.join(missing)}, which it cannot read or which may have changed since"
        if missing
        else ""
    )
    return f"accepted {number} certificates, with Coq {material.coq.version}{but}"


# --- LaTeX ---------------------------------------------------------------------------------------


def latex(outcome: Outcome) -> str:
    """The constants as a LaTeX table: enclosures of the first and printed ones, repaired values."""
    lines = [
        f"% {outcome.statement.title}",
        "% Enclosures: the true value lies between the two ends.",
        r"\begin{tabular}{lll}",
        r"\hline",
        r"constant & as printed & repaired \\",
        r"\hline",
    ]
    repaired = {c.short_name: c.name for c in words.constants_of(outcome, REPAIRED)}
    first = [*words.constants_of(outcome, ""), *words.constants_of(outcome, PRINTED)]
    known = {constant.short_name for constant in first}
    only = [c for c in words.constants_of(outcome, REPAIRED) if c.short_name not in known]
    for constant in (*first, *only):
        printed = "" if constant in only else _tex_number(outcome, constant.name)
        other = _tex_number(outcome, repaired.get(constant.short_name, ""))
        lines.append(rf"${constant.tex}$ & {printed} & {other} \\")
    return "\n".join([*lines, r"\hline", r"\end{tabular}"]) + "\n"


def _tex_number(outcome: Outcome, name: str) -> str:
    """An exact decimal, or an interval of 8 digits that contains the enclosure."""
    ends = words.ends_of(outcome, name)
    if ends is None:
        return ""
    low, high = outward(ends, 8)
    if low == high:
        return f"${_tex_decimal(low)}$"
    return rf"$[{_tex_decimal(low)},\, {_tex_decimal(high)}]$"


def _tex_decimal(text: str) -> str:
    mantissa, _, exponent = text.partition("e")
    return mantissa if not exponent else rf"{mantissa}\cdot 10^{{{exponent}}}"
