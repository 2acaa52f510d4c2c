"""What the report says, in the order in which a referee asks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any

from verify import __version__
from verify.prover.decimals import outward, short
from verify.views.mathml import MathML
from verify.paper.parameters import THEOREM
from verify.paper.spectrum.rows import LETTERS
from verify.paper.theorem1 import theorem
from verify.views.plots.figure import Figure
from verify.jobs.report import Constant, Folder, Material, Row, corrections
from verify.paper.groups import HYPOTHESES, PRINTED, REPAIRED
from verify.language.terms import Claim, Term
from verify.jobs.theorem1 import decide
from verify.views.typeset import Typesetter
from verify.views.page.blocks import (
    Block,
    Box,
    Cell,
    Code,
    Commands,
    Drawing,
    Facts,
    Heading,
    Items,
    Link,
    Math,
    Number,
    Paragraph,
    Raw,
    Source,
    Step,
    Steps,
    Strong,
    Table,
    Text,
    Verdict,
)
from verify.views.words import theorem_in_numbers

TITLE = "Three particles collapse: what is proved"
SUBTITLE = (
    "Dolmaire and Velázquez, Collapse of inelastic hard spheres in dimension d ≥ 2: Theorem 1 and "
    "the spectrum of its linear model, every inequality decided in rigorous arithmetic."
)

#: Formulas with more letters than this stay in the statement file.
LONGEST = 400

#: A min with more entries than this is written one entry a line.
MANY = 2

#: A table with more rows than this is folded.
UNFOLDED = 16


def content(
    material: Material, drawings: Mapping[str, Sequence[str]], figures: Sequence[Figure]
) -> list[Block]:
    """The blocks of the page; ``drawings`` has the panels of each figure that was drawn."""
    drawn = [Drawing(figure, drawings.get(figure.name, ())) for figure in figures]
    main, *_ = material.about(THEOREM)
    writer = Writer(main)
    return [
        *_result(material, main),
        drawn[0],
        *_recheck(material),
        *_printed_proof(writer),
        *_changes(),
        *_constants(writer),
        *_points(material),
        *_spectral(material),
        Heading("plots", "Plots"),
        Paragraph([Text(
            "Nothing here is a sample: each band and each box encloses the values at every point "
            "of its interval or cell (ball arithmetic with the mean value theorem), and what "
            "enclosures do not decide is drawn as undecided."
        )]),
        *drawn[1:],
        *_measurements(material),
        *_assumptions(material),
        *_digests(material),
    ]  # fmt: skip


class Writer:
    """Formulas and numbers of one certificate."""

    def __init__(self, folder: Folder) -> None:
        self.folder = folder
        known = {constant.name: constant for constant in theorem().constants}
        plain = {name: constant.letter for name, constant in known.items()} | dict(LETTERS)
        self._text = Typesetter(plain | {"V_0": "V₀", "delta_theta": "δ_θ", "c": "(-cos θ₀)"})
        tex = {constant.name: constant.tex for constant in folder.constants}
        self._mathml = MathML(tex | ({"c": r"(-\cos\theta_0)"} if folder.parameters else {}))
        self.rows = {row.name: row for row in folder.rows}

    def claim(self, claim: Claim) -> Math | None:
        """A claim, unless it is too long to be read."""
        text = self._text.claim(claim)
        return None if len(text) > LONGEST else Math(self._mathml.claim(claim), text)

    def term(self, term: Term, before: str = "") -> Math:
        """A term after a relation."""
        text = f"{before} {self._text.term(term)}".strip()
        if term.op == "min" and len(term.children) > MANY:
            return Math(self._mathml.entries(term, before), text)
        return Math(self._mathml.term(term, before), text)

    def plain(self, term: Term) -> str:
        """A term in one line."""
        return self._text.term(term)


def _number(texts: tuple[str, str] | None) -> Number | None:
    if texts is None:
        return None
    low, high = (Fraction(text) for text in texts)
    return Number(short((low, high)), texts)


def _cell(*parts: Math | Number | Text | None) -> Cell:
    return [part for part in parts if part is not None]


def _count(rows: Iterable[Row], verdict: str) -> int:
    return sum(row.verdict == verdict for row in rows)


def _printed(folder: Folder) -> list[Row]:
    return [row for row in folder.of_group(HYPOTHESES, PRINTED) if row.role == "printed"]


def _at(folder: Folder) -> str:
    """The point in words."""
    r, c = (folder.parameters[name] for name in ("r", "c"))
    if c.op == "neg" and c.children[0].op == "cos_pi":
        turns = c.children[0].children[0].value
        angle = f"θ₀ = {turns.numerator}π/{turns.denominator}"
    elif c.op == "rational":
        angle = "θ₀ = π" if c.value == 1 else f"-cos θ₀ = {_readable(c.value)}"
    else:
        angle = f"-cos θ₀ = {Typesetter({}).term(c)}"
    return f"r = {_readable(r.value)}, {angle}"


def _readable(value: Fraction) -> str:
    """A fraction where it is short, else a decimal where that is exact."""
    low, high = outward((value, value), 20)
    return low if value.denominator > 1000 and low == high else str(value)


def _result(material: Material, main: Folder) -> Iterator[Block]:
    repaired, printed = main.of_group(REPAIRED), _printed(main)
    refuted = _count(printed, "refuted")
    yield Facts([
        ("proved", [
            Strong("The theorem holds with repaired constants. "),
            Text(f"At {_at(main)} all {_count(repaired, 'proved')} inequalities that close the "
                 f"proof are proved, given {len(main.assumptions)} estimates that are "),
            Link("#trust", "listed below"), Text("."),
        ]),
        ("refuted", [
            Strong("The proof as printed does not close. "),
            Text(f"{refuted} of its {len(printed)} steps, taken one by one, are refuted there; "
                 "each is "),
            Link("#printed", "listed with both sides and its repair"), Text("."),
        ]),
        *_spectrum_facts(material),
    ])  # fmt: skip
    outcome = decide(main.parameters)
    yield Box("Theorem 1, in numbers", [Text(theorem_in_numbers(outcome))])


def _spectrum_facts(material: Material) -> Iterator[tuple[str, Cell]]:
    for folder in _others(material):
        needed = [row for row in folder.rows if row.role == "needed"]
        refuted = [row for row in folder.rows if row.refuted]
        word = "proved" if folder.proved else "refuted"
        yield word, [
            Strong("The spectral claims. "),
            Text(f"All {len(needed)} needed claims are proved for every r in ]0,1[, given "
                 f"{len(folder.assumptions)} listed assumptions; {len(refuted)} of the "
                 f"{len(folder.rows) - len(needed)} printed ones are refuted ("),
            Link("#spectrum", "list"), Text(")."),
        ]  # fmt: skip


def _others(material: Material) -> list[Folder]:
    return [folder for folder in material.folders if folder.theorem != THEOREM]


def _recheck(material: Material) -> Iterator[Block]:
    yield Heading("check", "Check it yourself")
    yield Paragraph([
        Text("The program need not be believed. It writes what it claims and how each claim is "
             "proved into two files, and "), Code("verify/check.py"),
        Text(", one file that needs nothing but Python's standard library and searches for "
             "nothing, checks them again. This page was written after it accepted all "
             f"{len(material.folders)} certificates. One command does the same, in the folder "
             "of the project:"),
    ])  # fmt: skip
    yield Commands(
        [
            "for file in certificates/*/statement.json",
            'do python3 -I verify/check.py "${file%/*}" | tail -n 1',
            "done",
        ]
    )
    yield Paragraph([
        Text("With the program installed, "), Code("verify check --statement FOLDER"),
        Text(" also makes the statement anew and compares it byte for byte, and "),
        Code("verify report --compare"), Text(" does so with the numbers of this page."),
    ])  # fmt: skip


def _printed_proof(writer: Writer) -> Iterator[Block]:
    printed = _printed(writer.folder)
    refuted = [row for row in printed if row.refuted]
    holding = [row for row in printed if not row.refuted]
    yield Heading("printed", f"The printed proof: {len(refuted)} steps refuted")
    yield Paragraph([Text(
        f"At {_at(writer.folder)}, in the paper's order. Each step is judged at the worst state "
        f"that the printed set allows. A refuted one comes with certified enclosures of both sides "
        f"(the digits shown are those on which both ends agree; touch a number for its ends) and "
        f"with the row that takes its place. A step that names its own r and θ₀ is an implication, "
        f"refuted by an exact counterexample."
    )])  # fmt: skip
    yield Steps([_step(writer, row) for row in refuted])
    yield _rows_table(writer, f"The {len(holding)} printed steps that hold", holding)
    repaired = writer.folder.of_group(REPAIRED)
    yield _rows_table(writer, f"The {len(repaired)} rows of the repaired proof", repaired)
    needed = [row for row in writer.folder.of_group(HYPOTHESES) if row.role == "needed"]
    yield _rows_table(writer, f"The {len(needed)} hypotheses", needed)


def _step(writer: Writer, row: Row) -> Step:
    claim = writer.claim(row.claim)
    return Step(
        row.name,
        row.label,
        row.says,
        claim or Math("", "in the statement file"),
        _number(row.lhs),
        _number(row.rhs),
        _margin(row),
        _repair(writer, row),
    )


def _margin(row: Row) -> Cell:
    """An enclosure of right - left, from the certified ends of both."""
    if row.sides is None:
        return [Text("(for all values)")]
    lhs, rhs = row.sides
    margin = (rhs[0] - lhs[1], rhs[1] - lhs[0])
    low, high = outward(margin, 20)
    return [Number(short(margin, 4), (low, high))]


def _repair(writer: Writer, row: Row) -> Cell:
    name = corrections().get(row.name)
    other = writer.rows.get(name) if name else None
    if name is None or other is None:
        return [Text("No repair is needed: nothing rests on it.")]
    parts: list[Any] = [Verdict(other.verdict), Text(" "), Code(name), Text(f": {other.says}")]
    claim = writer.claim(other.claim)
    if claim is not None:
        parts += [Text(", "), claim]
    sides = [_number(other.lhs), _number(other.rhs)]
    if sides[0] is not None and sides[1] is not None:
        sign = "≤" if other.claim.relation == "<=" else other.claim.relation
        parts += [Text(": "), sides[0], Text(f" {sign} "), sides[1]]
    return parts


def _rows_table(writer: Writer, title: str, rows: Sequence[Row], folded: bool = True) -> Table:
    sides = any(row.lhs is not None for row in rows)
    head = ["Verdict", "Label", "Step", "Claim", *(("Left", "Right") if sides else ("Proof",))]
    return Table(title, head, [_row(writer, row, sides) for row in rows], folded)


def _row(writer: Writer, row: Row, sides: bool) -> list[Cell]:
    claim = writer.claim(row.claim)
    first: list[Cell] = [
        [Verdict(row.verdict)],
        [Code(row.label)],
        [Text(row.says)],
        [Text("(long: see the statement file)") if claim is None else claim],
    ]
    if not sides:
        return [*first, [Text(row.rule)]]
    return [*first, _cell(_number(row.lhs)), _cell(_number(row.rhs))]


def _changes() -> Iterator[Block]:
    yield Heading("changes", "What is changed")
    yield Table(
        "Paper, needed, why",
        ("Label", "Paper", "Needed", "Why"),
        [
            ([Code(c.label)], [Text(c.paper)], [Text(c.needed)], [Text(c.why)])
            for c in theorem().changes
        ],
    )


def _constants(writer: Writer) -> Iterator[Block]:
    folder = writer.folder
    yield Heading("constants", f"Constants at {_at(folder)}")
    yield Paragraph([Text(
        "Certified enclosures; touch a number for both ends. The repaired constants are chosen: "
        "short decimals on the safe side of their bounds, so they are exact."
    )])  # fmt: skip
    definitions = {constant.name: constant for constant in theorem().constants}
    groups = {
        "": "The first constants",
        PRINTED: "The set as printed",
        REPAIRED: "The repaired set",
    }
    for group, title in groups.items():
        rows = []
        for constant in folder.constants:
            if constant.name.rpartition(".")[0] != group:
                continue
            known = definitions[constant.name]
            sign = "=" if not known.chosen else "≤" if known.direction == "down" else "≥"
            rows.append(_constant(writer, constant, writer.term(known.term, sign)))
        yield Table(title, ("Constant", "Value", "Definition or bound", "Label"), rows)
    yield Source("The constants as a LaTeX table (also in constants.tex)", latex(folder))


def _constant(writer: Writer, constant: Constant, definition: Math) -> list[Cell]:
    letter = writer.term(Term("symbol", constant.name))
    return [[letter], _cell(_number(constant.texts)), [definition], [Code(constant.label)]]


def _points(material: Material) -> Iterator[Block]:
    yield Heading("points", "The same at other points")
    rows: list[list[Cell]] = []
    for folder in material.about(THEOREM):
        values = {constant.name: constant for constant in folder.constants}
        printed = _printed(folder)
        rows.append([
            [Link(f"{folder.name}/report.md", _at(folder))],
            [Verdict("proved" if folder.proved else "refuted")],
            [Text(f"{_count(folder.of_group(REPAIRED), 'proved')} proved")],
            [Text(f"{_count(printed, 'refuted')} of {len(printed)}")],
            *(_cell(_number(values[f"repaired.{name}"].texts))
              for name in ("delta_x", "eta_bar", "zeta_bar", "T_star")),
        ])  # fmt: skip
    yield Table(
        "Certificates of Theorem 1",
        ("Point", "Verdict", "Repaired rows", "Printed steps refuted", "δ_x", "η̄", "ζ̄", "T*"),
        rows,
    )


def _spectral(material: Material) -> Iterator[Block]:
    folders = _others(material)
    if folders:
        yield Heading("spectrum", "The spectral claims, for every r in ]0,1[")
    for folder in folders:
        writer = Writer(folder)
        refuted = [row for row in folder.rows if row.refuted]
        if refuted:
            yield Paragraph([Text(
                f"{len(refuted)} printed claims are refuted; each has a point at which it is false "
                "in the certificate, and the claim that takes its place:"
            )])  # fmt: skip
            yield Steps([_step(writer, row) for row in refuted])
        labels = dict.fromkeys(row.label for row in folder.rows if not row.refuted)
        yield Paragraph([Text(
            f"{len(folder.rows) - len(refuted)} claims are proved, each by a rule of the checker "
            "(identities of polynomials, Bernstein coefficients, boxes). By label of the paper:"
        )])  # fmt: skip
        for label in labels:
            rows = [row for row in folder.rows if row.label == label and not row.refuted]
            yield _rows_table(writer, f"{label} ({len(rows)})", rows)


def _measurements(material: Material) -> Iterator[Block]:
    titles = {
        "bench": ("speed", "Speed", "verify bench"),
        "stress": ("stability", "Numerical stability on hard cases", "verify stress"),
    }
    for name, tables in material.measurements.items():
        anchor, title, command = titles[name]
        yield Heading(anchor, title)
        yield Paragraph([Text("As measured and committed; made anew by "), Code(command),
                         Text(".")])  # fmt: skip
        for table in tables.values():
            rows = [[[Raw(str(value))] for value in row] for row in table["rows"]]
            yield Table(table["title"], table["columns"], rows, len(rows) > UNFOLDED)


def _assumptions(material: Material) -> Iterator[Block]:
    yield Heading("trust", "Taken on trust")
    yield Paragraph([Text(
        "What is used and not proved by the program. The checker prints the same list with each "
        "verdict."
    )])  # fmt: skip
    seen: set[str] = set()
    for folder in material.folders:
        if folder.theorem not in seen:
            seen.add(folder.theorem)
            yield Paragraph([Strong("For "), Code(folder.theorem), Text(":")])
            yield Items(
                [[Code(a["label"]), Text(f": {a['sentence']}")] for a in folder.assumptions]
            )


def _digests(material: Material) -> Iterator[Block]:
    yield Heading("versions", "Versions and digests")
    yield Paragraph([Text(f"verify-collapse {__version__}. SHA-256 of the files behind this page; "
                          "a certificate carries the digest of its statement.")])  # fmt: skip
    rows: list[list[Cell]] = [
        [[Code(f"{folder.name}/{file}")], [Code(digest)]]
        for folder in material.folders
        for file, digest in folder.digests.items()
    ]
    rows += [[[Code(file)], [Code(digest)]] for file, digest in material.digests.items()]
    yield Table("Files", ("File", "SHA-256"), rows, folded=True)


def latex(folder: Folder) -> str:
    """The constants as a LaTeX table: enclosures of the first and printed ones, repaired values."""
    lines = [
        f"% {folder.title}",
        "% Enclosures: the true value lies between the two ends.",
        r"\begin{tabular}{lll}",
        r"\hline",
        r"constant & as printed & repaired \\",
        r"\hline",
    ]
    values = {constant.name: constant for constant in folder.constants}
    for name, constant in values.items():
        group, _, short_name = name.rpartition(".")
        if group == REPAIRED and {short_name, f"{PRINTED}.{short_name}"} & values.keys():
            continue
        repaired = constant if group == REPAIRED else values.get(f"{REPAIRED}.{short_name}")
        first = "" if group == REPAIRED else _tex_number(constant)
        second = "" if repaired is None else _tex_number(repaired)
        lines.append(rf"${constant.tex}$ & {first} & {second} \\")
    return "\n".join([*lines, r"\hline", r"\end{tabular}"]) + "\n"


def _tex_number(constant: Constant) -> str:
    """An exact decimal, or an interval of 8 digits that contains the enclosure."""
    low, high = outward(constant.ends, 8)
    if low == high:
        return f"${_tex_decimal(low)}$"
    return rf"$[{_tex_decimal(low)},\, {_tex_decimal(high)}]$"


def _tex_decimal(text: str) -> str:
    mantissa, _, exponent = text.partition("e")
    return mantissa if not exponent else rf"{mantissa}\cdot 10^{{{exponent}}}"
