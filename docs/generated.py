"""What the program itself writes into the pages while they are built.

A line ``<!-- generated: NAME -->`` of a page becomes the Markdown that the function ``NAME``
returns, and ``{{ name }}`` in a sentence becomes a figure of `figures`. So no table and no count
can be out of date. At the end each built page is searched for what it would load from elsewhere,
since the pages have to be readable without a network.
"""

from __future__ import annotations

import inspect
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

from verify.check_map import GIVEN
from verify.cli import _EXIT_CODES, COMMANDS
from verify.language.statement import NEEDED
from verify.paper.glossary import LETTERS
from verify.paper.in_coq import CITED_IN_COQ, IN_COQ
from verify.paper.theorem1 import theorem
from verify.prover.proof import Shape, shapes
from verify.prover.rules import RULES
from verify.publication import OTHERWISE
from verify.views.words import DEFINITION

ROOT = Path(__file__).resolve().parent.parent
MARK = re.compile(r"^<!-- generated: (\w+) -->$", re.MULTILINE)
#: What a built page would load: a script, style, picture or font with an address of its own.
LOADED = re.compile(
    r"<(?:script|img|iframe|link(?![^>]*rel=\"(?:canonical|author)\"))[^>]*(?:src|href)=\"(?:https?:)?//"
    r"|@import|url\([\"']?(?:https?:)?//"
)


# --- what the program says ------------------------------------------------------------------------


@cache
def document(*words: str) -> Any:
    """The JSON document of a command; its exit code may be that of a refutation."""
    line = [sys.executable, "-m", "verify", *words, "--json"]
    done = subprocess.run(line, cwd=ROOT, capture_output=True, encoding="utf-8", check=False)
    if done.returncode not in (0, 1):
        raise RuntimeError(f"verify {' '.join(words)}: {done.stderr}")
    return json.loads(done.stdout)


def point() -> Any:
    """Theorem 1 at the point that the pages speak about."""
    return document("theorem1", "--r", "0.03")


def figures() -> dict[str, str]:
    """The figures that sentences name."""
    printed, repaired = (point()["sets"][name]["obligations"] for name in ("printed", "repaired"))
    refuted = [row for row in printed if row["verdict"] == "refuted"]
    hypotheses = [row for row in point()["hypotheses"] if row["verdict"] == "refuted"]
    severity = Counter(row["severity"] for row in [*refuted, *hypotheses])
    names = {row["name"] for row in [*refuted, *hypotheses]}
    breaking = {row["name"] for row in refuted if row["severity"] == "breaks the argument"}
    elsewhere, spectrum = document("elsewhere")["claims"], document("spectrum")["claims"]
    every = document("theorem1", "--all")["claims"]
    ci = (ROOT / ".ci/run").read_text(encoding="utf-8")
    named = {
        "mutants": re.findall(r"tests\.mutation .*--least (\d+)", ci)[0],
        "refuted": len(refuted) + len(hypotheses),
        "breaking": severity["breaks the argument"],
        "harmless": severity["false, but harmless here"],
        "slips": severity["slip of wording"],
        "causes": sum(bool(names & set(cause.rows)) for cause in theorem().causes),
        "breaking_causes": sum(bool(breaking & set(cause.rows)) for cause in theorem().causes),
        "otherwise": sum(row["verdict"] == OTHERWISE for row in printed),
        "remarks": sum(row["verdict"] == "remark" for row in [*printed, *point()["hypotheses"]]),
        "repaired": sum(not row["name"].endswith("collapse") for row in repaired),
        "all_rows": len(every),
        "assumptions": len(point()["assumptions"]),
        "printed_assumptions": len(point()["assumptions_of_printed_rows"]),
        "elsewhere_rows": len(elsewhere),
        "elsewhere_proved": sum(row["verdict"] == "proved" for row in elsewhere),
        "elsewhere_refuted": sum(row["verdict"] == "refuted" for row in elsewhere),
        "spectrum_refuted": sum(row["verdict"] == "refuted" for row in spectrum),
        "classification_assumptions": len(document("classification")["assumptions"]),
    }
    return {name: str(value) for name, value in named.items()}


# --- tables ---------------------------------------------------------------------------------------


def table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A table in Markdown."""
    heads = list(head)
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def escaped(text: str) -> str:
    """A text in which Markdown sees no markup of its own."""
    return re.sub(r"([|*_<\[\]])", r"\\\1", text)


def section(title: str) -> str:
    """One section of the committed report on Theorem 1 at the point."""
    report = (ROOT / "certificates/theorem1-r-3-100/report.md").read_text(encoding="utf-8")
    return report.split(f"\n## {title}\n")[1].split("\n## ")[0].strip()


def row_counts() -> str:
    """How many rows there are, and what each number counts."""
    here, every = point(), document("theorem1", "--all")["claims"]
    printed, repaired = (here["sets"][name]["obligations"] for name in ("printed", "repaired"))
    first = Counter(row["role"] for row in here["hypotheses"])
    both = {row["name"].rpartition(".")[2] for row in repaired}
    own = [row for row in every if row["name"].startswith(("redundant.", "active."))]
    derived = sum(row["name"].startswith("hypotheses.") for row in every)
    rows = [
        ("Hypotheses, needed", first["needed"], "r, -cos θ₀, V₀ and δ_θ are in range"),
        (
            "The repaired set",
            len(repaired),
            f"{len(repaired) - 1} inequalities that close the proof, and that the step applies",
        ),
        ("**Needed at a point**", first["needed"] + len(repaired), "the sum of these two"),
        ("Hypotheses, printed", first["printed"], "the sign in (4.10)"),
        ("The printed set", len(printed), "the same for the paper's constants, and misprints"),
        ("**Printed at a point**", first["printed"] + len(printed), "the sum of these two"),
        (
            "Of these, refuted for the checker",
            sum(row["verdict"] != "proved" for row in [*here["hypotheses"], *printed]),
            "refuted, true for another reason, and remarks: it knows claims, not what a text means",
        ),
        ("The repaired set, for all parameters", len(both & names_of(every)), "the same rows"),
        ("Hypotheses that follow", derived, "those that the chart of parameters implies"),
        ("Entries of minima", len(own), "which ones are never, or sometimes, the least"),
        ("**Needed for all parameters**", len(every), "the sum of these three"),
    ]
    return table(("Rows", "Number", "What is counted"), ((a, str(n), c) for a, n, c in rows))


def names_of(rows: Iterable[dict[str, Any]]) -> set[str]:
    """The names of rows of the repaired set without their group."""
    found = (row["name"] for row in rows if row["group"] == "repaired")
    return {name.removeprefix("repaired.") for name in found}


def defects() -> str:
    """The rows of the printed set that are refuted, with both sides."""
    return section("What is printed and refuted here")


def changes() -> str:
    """What the repaired set changes."""
    return section("What was changed")


def causes() -> str:
    """Why, once for each cause."""
    return "\n".join(f"* `{'`, `'.join(c.rows)}`: {escaped(c.text)}" for c in theorem().causes)


def remarks() -> str:
    """What else is remarked on the text of the proof."""
    return "\n".join(f"* `{r.label}`: {escaped(r.text)}" for r in theorem().remarks)


def assumptions() -> str:
    """The sentences that the verdict at the point rests on."""
    return table(
        ("Name", "Kind", "What it says", "In Coq"),
        (
            [f"`{a['name']}`", a["kind"], escaped(a["statement"]), _theorems(a["name"])]
            for a in point()["assumptions"]
        ),
    )


def _theorems(name: str) -> str:
    """What a sentence of the step is in Coq."""
    return ", ".join(f"`{theorem}`" for theorem in IN_COQ["step"][name])


#: What one runs, the folder with a statement of that kind, and the judge.
RUNS = {
    "theorem1 --r R": ("theorem1-r-3-100", "`check.py` with `--out`, else FLINT at a point"),
    "theorem1 --all": ("theorem1-all", "`check.py`"),
    "scene: collapses": ("scenes/in-space", "`check.py` with `--out`, else FLINT at a point"),
    "scene: disperses": ("scenes/passing", "the same"),
    "scene: finite": ("scenes/on-a-line", "the same"),
    "map": ("", "`check_map.py`"),
    "spectrum": ("spectrum", "`check.py`"),
    "classification": ("classification", "`check.py`"),
    "separatrix --all": ("separatrix", "`check.py`"),
    "the sandwich theorem": ("sandwich", "`check.py`"),
    "the theorem on any three balls": ("three-balls", "`check.py`"),
    "its other half, outside the set": ("outside", "`check.py`"),
    "the printed set": ("printed-set", "`check.py`"),
    "the printed sign, which makes the theorem false": ("printed-sign", "`check.py`"),
}


#: What Coq proves from its definitions alone, without a certificate, by the name of the theorem.
FROM_DEFINITIONS = {
    "classification, of it I to IV b for three equal balls": (
        "PinnedClassification.classification_proved"
    ),
    "the printed sign, which makes the theorem false": "PinnedPrintedSign.printed_sign_proved",
    "the spectrum": "PinnedSpectrum.spectrum_proved",
}

#: What one believes who takes the word of a judge.
BELIEVED = {
    "FLINT at a point": "the ball arithmetic of FLINT, and this program",
    "the checker": "`verify/check.py` and Python",
    "verify/check_map.py": "`verify/check_map.py` and Python",
    "balls along monotone orbits": "FLINT, this program, and a theorem that Coq proves",
}
#: Who judges what one runs; each also as words of a command that shows it.
JUDGES = {
    "`verify theorem1 --r R`, `verify scene`": "FLINT at a point",
    "either with `--out` (except many balls), and all commands not named here": "the checker",
    "`verify map`": "verify/check_map.py",
    "`verify separatrix` without `--all` and `--out`": "balls along monotone orbits",
}


def believed() -> str:
    """What is believed, in short, as it stands in README.md."""
    ours = "that our rows say what the paper says"
    rows = [
        ("any command", f"the assumptions that are listed with the verdict, and {ours}"),
        *((run, BELIEVED[judge]) for run, judge in JUDGES.items()),
        (
            "`verify/coq/build`",
            "Coq, and that [its definitions](docs/explanation/coq.md) say what is meant",
        ),
    ]
    head, _, *lines = table(("If you run", "you believe"), rows).split("\n")
    return "\n".join([head, "|---|---|", *lines])


def sharper_givens() -> str:
    """All that the sharper theorem asks of the numbers and of the state."""
    report = (ROOT / "certificates/sharper/report.md").read_text(encoding="utf-8")
    context = report.split("## Context `start`\n")[1].split("\n## ")[0]
    lines = (line.split(" | ") for line in context.split("\n") if line.endswith(" | plain |"))
    return table(("Given", "Claim"), ([line[0][2:], escaped(line[1])] for line in lines))


def believed_and_proved() -> str:
    """For what one runs: who judges, what is believed, and what Coq proves of that."""
    accepted = {item["folder"]: item for item in in_coq()["certificates"]}
    rows = []
    for name, (folder, judge) in RUNS.items():
        folders = [folder] if folder else [*GIVEN]
        found: dict[str, bool] = {}
        for text, proved in (pair for one in folders for pair in sentences_of(one)):
            found[text] = found.get(text, True) and proved
        checked = {f"certificates/{one}" for one in folders} <= accepted.keys()
        answer = ("yes" if folder else "the theorems, not the log") if checked else "no"
        proofs = [text for text, proved in found.items() if proved and "(" not in text]
        believed = [text for text in found if text not in proofs]
        # A theorem about the very particles of a scene rests on no sentence.
        theorem = accepted.get(f"certificates/{folder}", {}).get("theorem")
        if theorem and any("(" not in text for text in believed):
            proofs = [f"none is needed where Coq has a theorem, as it has for `{folder}`"]
            believed = [f"that `{theorem}` says what is meant (definition)"]
        rows.append([name, judge, answer, ", ".join(proofs) or "–", ", ".join(believed) or "–"])
    for name, theorem in FROM_DEFINITIONS.items():
        if theorem in in_coq()["theorems"]:
            page = theorem.partition(".")[0]
            says = f"that `{page}.v` says what is meant (definitions)"
            rows.append([name, "Coq", "no certificate", f"none is needed: `{theorem}`", says])
    head = ("What you run", "Judge", "Accepted by Coq", "Assumptions proved in Coq", "Believed")
    return table(head, rows)


@cache
def in_coq() -> Any:
    """The record of what Coq has checked."""
    return json.loads((ROOT / "verify/data/coq.json").read_text(encoding="utf-8"))


@cache
def statements() -> dict[str, Any]:
    """The committed statements by their folders."""
    paths = (ROOT / "certificates").rglob("statement.json")
    return {
        str(path.parent.relative_to(ROOT / "certificates")): json.loads(path.read_bytes())
        for path in paths
    }


def sentences_of(folder: str) -> list[tuple[str, bool]]:
    """What the needed rows of a statement take on trust, there and in what it cites.

    With each sentence comes whether Coq has it; beside a definition stands that it is one.
    """
    statement = statements()[folder]
    needed = (row for row in statement["obligations"] if row["role"] == NEEDED)
    used = {name for row in needed for name in row["uses"]}
    used |= {given["assumption"] for c in statement["contexts"] for given in c["givens"]}
    known = IN_COQ.get(statement["theorem"], {})
    own = [
        (name + f" ({DEFINITION})" * (one["kind"] == DEFINITION), name in known)
        for one in statement["assumptions"]
        if (name := one["name"]) in used
    ]
    cited = [cite["theorem"] for cite in statement["cites"]]
    in_coq = CITED_IN_COQ.get(statement["theorem"], {})
    inner = (
        (other["theorem"], pair)
        for folder, other in statements().items()
        if other["theorem"] in cited and "/" not in folder
        for pair in sentences_of(folder)
    )
    # Where Coq proves what is cited, only its definitions are believed.
    return [*own, *(pair for name, pair in inner if name not in in_coq or "(" in pair[0])]


def letters() -> str:
    """Every letter of the paper, and where it is introduced."""
    rows = ([letter.letter, escaped(letter.says), f"`{letter.label}`"] for letter in LETTERS)
    return table(("Letter", "What it stands for", "Label in the paper's source"), rows)


def exit_codes() -> str:
    """The exit codes, as the program lists them."""
    return table(("Code", "Meaning"), ([str(c), says] for c, says in _EXIT_CODES.items()))


def commands() -> str:
    """Each command with its options."""
    pages = []
    for name, summary in COMMANDS.items():
        module = import_module(f"verify.cli.{name}")
        usage = module.USAGE.meanings.items()
        rows = ([f"`{option}`", escaped(text)] for option, text in usage)
        about = escaped((module.__doc__ or summary).strip())
        pages.append(f"## verify {name}\n\n{about}\n\n{table(('Option', 'Meaning'), rows)}")
    return "\n\n".join(pages)


def schemas() -> str:
    """The schema of each JSON document, with the keys at its top."""
    rows = []
    for path in sorted((ROOT / "certificates/schema").glob("*.json")):
        schema = json.loads(path.read_text(encoding="utf-8"))
        keys = ", ".join(f"`{key}`" for key in schema.get("properties", {}))
        rows.append([f"`{path.name}`", escaped(schema["title"]), keys])
    return table(("Schema", "What it describes", "Keys"), rows)


def law() -> str:
    """The page on statements and certificates, whose links to folders become names of folders."""
    text = (ROOT / "certificates/README.md").read_text(encoding="utf-8")
    title, rest = re.sub(r"\[(`[^`]*`)\]\([^)]*\)", r"\1", text).split("\n\n", 1)
    return f"{title}\n\nPaths on this page are relative to the folder `certificates/`.\n\n{rest}"


def measured(name: str) -> str:
    """A table of the committed measurements of speed and error."""
    data = json.loads((ROOT / "certificates/data/bench.json").read_text(encoding="utf-8"))
    found = data["tables"][name]
    return table(found["columns"], (map(str, row) for row in found["rows"]))


def precision() -> str:
    """Time and width of enclosures, by bits."""
    return measured("precision")


def equal_width() -> str:
    """Times at equal width."""
    return measured("equal_width")


def double_verdicts() -> str:
    """What plain doubles get wrong."""
    return measured("double_verdicts")


def maps() -> str:
    """What maps cost, and what their checks do."""
    return measured("maps")


def growth() -> str:
    """How times grow."""
    path = ROOT / "tests/measure/benchmarks/growth.json"
    found = json.loads(path.read_text(encoding="utf-8"))
    return table(found["columns"], found["rows"])


# --- the rules of the kernel ---------------------------------------------------------------------

LAW = ROOT / "certificates/README.md"
SCHEMA = ROOT / "certificates/schema/certificate.schema.json"


def rules() -> dict[Path, str]:
    """The two files that show the rules, as `verify.prover.rules` has them."""
    begin = "<!-- made from verify/prover/rules.py by docs/generated.py -->\n"
    end = "<!-- so far -->"
    first, rest = LAW.read_text(encoding="utf-8").split(begin)
    page = "\n".join([first + begin, *rules_in_words(), end + rest.split(end)[1]])
    first, rest = SCHEMA.read_text(encoding="utf-8").split('  "definition":')
    head = first.split('  "interval":')[0]
    found = (f"  {packed({name: what}, 1)[1:-1]},\n" for name, what in rule_shapes().items())
    return {LAW: page, SCHEMA: "".join([head, *found, '  "definition":', rest])}


def rules_in_words() -> Iterator[str]:
    """A table of the rules, and a paragraph on each."""
    laws = {}
    for proofs, rule in RULES.items():
        meaning, _, law = inspect.getdoc(proofs).replace("``", "`").partition("\n\n")
        if law:
            laws[rule, ", ".join(proofs._fields)] = " ".join(meaning.split()), law
    rows = ([f"`{rule.name}`", meaning] for (rule, _), (meaning, _) in laws.items())
    yield table(("rule", "in a sentence"), rows)
    for (rule, fields), (_, law) in laws.items():
        links = ", ".join(f"[`{name}`](examples/{name})" for name in rule.examples)
        examples = f"Example{'s' * (len(rule.examples) > 1)}: {links}."
        gap = "\n\n" if law.endswith("|") else " "
        yield f"\n**`{rule.name}`** `{{{fields}}}`: {law}{gap}{examples}"
    yield ""


def rule_shapes() -> dict[str, Any]:
    """For each rule the schema of its proofs, and which of them may stand anywhere."""
    found = {}
    for proofs, rule in RULES.items():
        meaning = inspect.getdoc(proofs).replace("``", "`").partition("\n\n")[0]
        fields = {name: shape_schema(shape) for name, shape in shapes(proofs).items()}
        found[rule.stands if rule.name in found else rule.name] = {
            "description": " ".join(meaning.split()),
            "type": "object",
            "required": ["rule", *fields],
            "properties": {"rule": {"const": rule.name}, **fields},
            "additionalProperties": False,
        }
    anywhere = [reference(rule.name) for rule in RULES.values() if rule.stands == "proof"]
    anywhere.append(reference("bits"))
    return found | {"proof": {"description": "a proof of a claim", "oneOf": anywhere}}


def reference(name: str) -> dict[str, str]:
    """A reference to a definition of the schema."""
    return {"$ref": f"#/$defs/{name}"}


def shape_schema(shape: Shape) -> dict[str, Any]:
    """What a field of a proof may hold."""
    if shape.form == "leaf":
        return reference(shape.of[0])
    if shape.form == "choice":
        return {"enum": [*shape.of]}
    inner = [shape_schema(part) for part in shape.of]
    match shape.form:
        case "optional":
            return {"anyOf": [*inner, {"type": "null"}]}
        case "table":
            named = {"propertyNames": reference("name"), "additionalProperties": inner[0]}
            return {"type": "object", **named}
        case "row":
            size = {"minItems": len(inner), "maxItems": len(inner)}
            return {"type": "array", "prefixItems": inner, **size}
    return {"type": "array", "items": inner[0]} | ({"minItems": shape.least} if shape.least else {})


def packed(value: Any, indent: int) -> str:
    """A JSON value in lines that are filled up to 100 characters."""
    flat = json.dumps(value, ensure_ascii=False)
    if len(flat) + indent <= 94 or not isinstance(value, list | dict):
        return flat
    if isinstance(value, list):
        parts = [packed(item, indent + 1) for item in value]
    else:
        parts = [f"{json.dumps(key)}: {packed(item, indent + 1)}" for key, item in value.items()]
    lines = [""]
    for part in parts:
        fits = len(lines[-1]) + len(part) + indent <= 94 and "\n" not in part
        lines[-1:] = [f"{lines[-1]}{part}, "] if fits or not lines[-1] else [lines[-1], f"{part}, "]
    text = f"\n{' ' * (indent + 1)}".join(line.rstrip() for line in lines).removesuffix(",")
    return f"{flat[0]}{text}{flat[-1]}"


# --- the plan of the house ------------------------------------------------------------------------


@cache
def rooms() -> dict[str, Counter[str]]:
    """For each room, how many of its imports go to each other room."""
    from grimp import build_graph

    def room(module: str) -> str:
        parts = module.split(".")
        return parts[1] if len(parts) > 1 else ""

    graph = build_graph("verify", cache_dir=None)
    found: dict[str, Counter[str]] = {}
    for module in graph.modules:
        here = found.setdefault(room(module), Counter())
        others = (room(other) for other in graph.find_modules_directly_imported_by(module))
        here.update(other for other in others if other not in (room(module), ""))
    return {name: found[name] for name in found if name not in ("", "__main__")}


def arrows() -> set[tuple[str, str]]:
    """Who imports whom, less what follows from others; of a circle the weaker arrow is left out."""
    uses = rooms()
    kept = {
        name: {other for other in others if uses[other][name] <= others[other]}
        for name, others in uses.items()
    }

    def reaches(name: str, end: str) -> bool:
        return end in kept[name] or any(reaches(other, end) for other in kept[name])

    return {
        (name, end)
        for name, others in kept.items()
        for end in others
        if not any(reaches(other, end) for other in others - {end})
    }


def house() -> str:
    """The rooms as a picture: an arrow leads from a room to one below, which it imports."""
    drawn = arrows()

    def floor(name: str) -> int:
        return max((1 + floor(end) for start, end in drawn if start == name), default=0)

    floors: dict[int, list[str]] = {}
    for name in sorted(rooms()):
        floors.setdefault(floor(name), []).append(name)
    top = max(floors)
    place = {
        name: (360 + int((column - (len(names) - 1) / 2) * 180), 40 + (top - level) * 80)
        for level, names in floors.items()
        for column, name in enumerate(names)
    }
    lines = []
    for start, end in sorted(drawn):
        (x1, y1), (x2, y2) = place[start], place[end]
        bend = 0 if floor(start) == floor(end) + 1 else 130 if x1 >= 360 else -130
        path = f"M{x1} {y1 + 17} Q{(x1 + x2) // 2 + bend} {(y1 + y2) // 2} {x2} {y2 - 17}"
        lines.append(ARROW.format(path, f"{start} imports {end}"))
    boxes = [BOX.format(x - 62, y - 17, x, y + 5, name) for name, (x, y) in place.items()]
    return "\n".join([PICTURE.format(80 + top * 80), *lines, *boxes, "</svg>"])


ARROW = '<path d="{}" marker-end="url(#tip)"><title>{}</title></path>'
BOX = '<rect x="{}" y="{}" width="124" height="34" rx="5"/><text x="{}" y="{}">{}</text>'
PICTURE = """<svg class="house" role="img" aria-label="The packages, and which imports which"
 viewBox="0 0 720 {}" xmlns="http://www.w3.org/2000/svg">
<style>
.house path {{ fill: none; stroke: #7a8a99; stroke-width: 1.5 }}
.house rect {{ fill: #e8eef4; stroke: #445566 }}
.house text {{ font: 14px sans-serif; text-anchor: middle; fill: #112233 }}
.house marker path {{ fill: #7a8a99; stroke: none }}
</style>
<defs><marker id="tip" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="9" markerHeight="9"
 markerUnits="userSpaceOnUse" orient="auto"><path d="M0 0L8 4L0 8z"/></marker></defs>"""


def imports() -> str:
    """How many imports lead from each room to each other."""
    uses = rooms()
    names = sorted(uses, key=lambda name: -len(uses[name]))
    rows = ([f"**{name}**", *(str(uses[name][end] or "") for end in names)] for name in names)
    return table(("imports", *names), rows)


# --- Sphinx ---------------------------------------------------------------------------------------

FRAGMENTS: dict[str, Callable[[], str]] = {
    function.__name__: function
    for function in (
        believed_and_proved,
        sharper_givens,
        *(row_counts, defects, changes, causes, remarks, assumptions, letters, exit_codes),
        *(commands, schemas, law, precision, equal_width, double_verdicts, maps, growth),
        *(house, imports),
    )
}


def filled(text: str) -> str:
    """A page with what is generated in place of its marks."""
    return MARK.sub(lambda mark: FRAGMENTS[mark[1]](), text)


def _read(app: Any, name: str, source: list[str]) -> None:
    source[0] = filled(source[0])


def _finished(app: Any, error: Exception | None) -> None:
    from sphinx.errors import ExtensionError

    for path in Path(app.outdir).rglob("*"):
        if error is None and path.suffix in (".html", ".css"):
            found = LOADED.search(path.read_text(encoding="utf-8"))
            if found:
                raise ExtensionError(f"{path} loads something from elsewhere: {found[0]}")


def setup(app: Any) -> dict[str, bool]:
    """Called by Sphinx."""
    app.connect("source-read", _read)
    app.connect("build-finished", _finished)
    return {"parallel_read_safe": True}


if __name__ == "__main__":
    for path, text in rules().items():
        path.write_text(text, encoding="utf-8")
