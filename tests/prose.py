"""Numbers and formulas in README.md and docs/: what is seen of them, and what proves each.

A page is read without its blocks of code, which are run, and without what the program writes into
it. Each digit, power, root and sign that is left has to lie in a span that something covers:

* a formula that stands word for word in what the program writes of a committed certificate, or in a
  block of the same page, which is run and compared;
* an equation between numbers, which is computed;
* code in a line that is a path, a name, a command or an option that exists, or stands in a block of
  the same page;
* an entry of `tests.watched`: words with the numbers of the program in their gaps.

Whatever is left over is `unwatched`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from mpmath import mpf, sqrt, workdps

from tests.readme_commands import ROOT
from verify.paper.source import PAPER
from verify.views import all_parameters, classification

CERTIFICATES = ROOT / "certificates"

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]

#: What has to be covered: digits, powers, roots and signs. Digits below the line belong to letters,
#: and a hyphen is no sign.
WATCHED = re.compile(
    r"[\d⁰¹²³⁴⁵⁶⁷⁸⁹√<>≤≥≠+→↦]|(?<![^\s(/`|\[\"])-(?=[\s\w(√|])|(?<=\w)-(?=\d)|(?<=\d)-(?=\w)"
)
_CODE = re.compile(r"^ *(```+)(?!\{glossary|\{note)[^\n]*\n.*?^ *\1[ ]*$", re.MULTILINE | re.DOTALL)
_GENERATED = re.compile(r"<!--.*?-->|\{\{.*?\}\}", re.DOTALL)
#: Addresses, references, marks of quoted lines and places: what the tests of links see.
_MARKUP = re.compile(
    r"\{\w+\}`[^`]*`|\]\([^)\s]*\)|https?://[^\s)]+|^(?::::|''')[^\n]*|^(?:> )+|^\(\w+\)=$",
    re.MULTILINE,
)
_INLINE = re.compile(r"`` .*? ``|`[^`\n]*\n?[^`\n]*`|<code>.*?</code>")
_BETWEEN = re.compile(r'[\s,;:()"]+')
#: Words of which a formula is made; a sentence or a cell ends it.
_WORD = (
    r"(?<!\S)[^\s*]*[\d⁰-⁹¹²³₀-₉√αβγδζηθκλμρστφωΓΔΘΣ<>=≤≥±·…^/()\[\]_+][^\s*]*"
    r"|(?<!\S)(?:-|[a-zA-Z]'?)(?!\S)|(?<!\S)\\\|[^\s]*"
)
CHUNK = re.compile(rf"(?:{_WORD})(?:\s+(?:{_WORD}))*")


def blank(match: re.Match[str]) -> str:
    """Spaces of the same length: places on a page stay."""
    return re.sub(r"[^\n]", " ", match[0])


@cache
def prose(text: str) -> str:
    """A page without blocks of code, addresses, and what is generated."""
    for pattern in (_CODE, _GENERATED, _MARKUP):
        text = pattern.sub(blank, text)
    return text


def plain(text: str) -> str:
    """A formula without spaces, dots of products and marks of Markdown."""
    return re.sub(r"[\s\\`*·]", "", text)


@cache
def reports() -> str:
    """The reports of the committed certificates."""
    found = sorted(CERTIFICATES.rglob("report.md"))
    return "\n".join(path.read_text(encoding="utf-8") for path in found)


@cache
def written() -> str:
    """What the program writes of the committed certificates, and says of its theorems."""
    said = [
        *classification.THEOREMS,
        all_parameters.CLAIM,
        *(text for _, text in PAPER.notes().causes),
    ]
    said += [change.needed for change in PAPER.notes().changes]
    return re.sub(r"[\\`*·]", "", "\n".join([reports(), *said]))


@cache
def without_spaces() -> tuple[str, list[int]]:
    """The same without spaces, and where each character stands with them."""
    places = [place for place, letter in enumerate(written()) if letter != " "]
    return "".join(written()[place] for place in places), places


@cache
def stands(formula: str) -> bool:
    """Whether a formula without spaces stands there, and not as a part of a longer one."""
    text, places = without_spaces()
    start = text.find(formula)
    while start >= 0:
        before = written()[max(0, places[start] - 1) : places[start]]
        after = written()[
            places[start + len(formula) - 1] + 1 : places[start + len(formula) - 1] + 2
        ]
        if not (_JOINS.match(before) and _BEGINS.match(formula[0])) and not (
            _ENDS.match(formula[-1]) and (_ENDS.match(after) or after == ".")
        ):
            return True
        start = text.find(formula, start + 1)
    return False


_JOINS = re.compile(r"[\w.√)]")
_BEGINS = re.compile(r"[\w√+-]")
_ENDS = re.compile(r"[\w⁰-⁹¹²³]")


def blocks(text: str) -> str:
    """What stands in the blocks of a page, in one line."""
    return " ".join(" ".join(match[0] for match in _CODE.finditer(text)).split())


@cache
def apart(blocks: str) -> str:
    """The same as words between spaces."""
    return f" {' '.join(re.split(_BETWEEN, blocks))} "


# --- rules ----------------------------------------------------------------------------------------

Span = tuple[int, int]


def formulas(text: str) -> Iterator[Span]:
    """Formulas that stand in `written`: they compare or join at least two things."""
    for match in CHUNK.finditer(text):
        words = [m.span() for m in re.finditer(r"\S+", match[0])]
        first = 0
        while first < len(words):
            sign = match[0][slice(*words[first])]
            if sign in "+-=<>≤≥":  # what stands before it is missing
                first += 2 if sign in "+-" else 1
                continue
            for last in range(len(words), first, -1):  # the longest row of words from here on
                span = match.start() + words[first][0], match.start() + words[last - 1][1]
                formula = plain(text[slice(*span)]).strip(",.;:")
                if is_formula(formula) and stands(formula):
                    yield span
                    first = last - 1
                    break
            first += 1


def is_formula(text: str) -> bool:
    """Whether a text is long enough to stand in no other formula by chance.

    A letter with its value, or a number, is none: that is an entry.
    """
    if len(text) < 5 or re.fullmatch(r"[^<>=≤≥+/()]+[=<≤]-?[\d./⁻¹²³⁰-⁹]+", text):
        return False
    if re.fullmatch(r"[\d√.+/-]+", text):
        return False
    if re.fullmatch(r"[^<>=≤≥/√]_\{[^}]*\}", text):
        return False
    return re.search("[<>=≤≥+/√-]", text[1:-1]) is not None


#: A number: whole, a decimal, a root, or what is made of these.
_NUMBER = r"[\d.]*√?[\d.]+(?:\s*[-+/]\s*[\d.]*√?[\d.]+)*"


def equations(text: str) -> Iterator[Span]:
    """Numbers that are compared, as is true: 9 - 4√5 = 0.0557…, √2 < 3/2."""
    for match in re.finditer(rf"(?<![\w/^·)]){_NUMBER}\s*[=<≤]\s*{_NUMBER}…?(?!\w)", text):
        left, sign, right = re.split(r"\s*([=<≤])\s*", match[0].rstrip("."))
        (a, _), (b, more) = value(left), value(right)
        if {"=": b <= a <= b + more, "<": a < b, "≤": a <= b}[sign]:
            yield match.start(), match.start() + len(match[0].rstrip("."))


def value(text: str) -> tuple[mpf, mpf]:
    """A number, and the unit of its last digit where … follows; a digit less is another number."""
    with workdps(60):
        digits = len(text.rstrip("…").partition(".")[2])
        more = mpf(10) ** -digits if text.endswith("…") else mpf(0)
        python = re.sub(r"([\d.]+)√", r"\1*√", text.rstrip("…"))
        python = re.sub(r"√([\d.]+)", r"sqrt(mpf('\1'))", python)
        python = re.sub(r"(?<![\d.'])([\d.]+)(?![\d.'])", r"mpf('\1')", python)
        return eval(python, {"mpf": mpf, "sqrt": sqrt}), more


def shown(blocks: str, text: str) -> Iterator[Span]:
    """Numbers of three digits and more that a block of the page shows, or is given."""
    known = apart(blocks)
    for match in re.finditer(r"[^\s|*]*\d[^\s|*]*", text):
        word = match[0].strip(',.;:()[]"*?')
        if len(re.findall(r"\d", word)) >= 3 and f" {word} " in known:
            yield match.span()


#: The particles of the paper are 0, 1 and 2, and a bound or a limit that is 0 is not measured.
_SAYINGS = (
    r"\bparticles 0 and 1\b|\b0-1 and 0-2\b|\b0-2, 0-1, 0-2\b|\b02, 01, 02\b|\bthat of 1\b",
    r"(?<!and[ \n])(?<!,[ \n])\b(?:0-[12]|1-2)\b(?! and [012]-|, [012]-)|\b1 and 2\b",
    r"(?<!between[ \n])\b0 and [12c]\b|\bbetween 0 and [c1]\b|\]0, ?1[\]\[]|SMT-LIB 2\b",
    r"(?<![^\s(|])-(?:cos|η_c)\b",
    r"\b(?:[Pp]articles?|balls?|spheres?|at|of|from|where|measure|momentum) 0\b(?!\.?\d)",
    r"\b(?:tends?|falls?|up) to 0\b|\breaches 0\b",
    r"\b(?:is|not|be|by|least|divides|are) 0\b|Velázquez \[1\],",
    r"\b(?:above|below|exceeds?|than|most|exceed) 1\b(?!\.\d)",
)
IDIOMS = re.compile(re.sub(r"(?<!\[) (?![?\\])", r"\\s+", "|".join(_SAYINGS)))
_MARKS = re.compile(r"^( *)(?:\*\*)?(\d+)\. ", re.MULTILINE)


def marks(text: str) -> Iterator[Span]:
    """The numbers of lists, which count."""
    last = 0
    for match in _MARKS.finditer(text):
        if int(match[2]) in (1, last + 1):
            last = int(match[2])
            yield match.span()


def idioms(text: str) -> Iterator[Span]:
    """Names of particles, and bounds that are 0."""
    yield from (match.span() for match in IDIOMS.finditer(text))


@cache
def words() -> frozenset[str]:
    """Names with digits in the sources: rows, labels, constants, what Coq defines."""
    paths = [
        path for kind in ("py", "toml", "v", "md") for path in (ROOT / "verify").rglob(f"*.{kind}")
    ]
    text = "\n".join(
        path.read_text(encoding="utf-8") for path in [*paths, ROOT / "tests/points.py"]
    )
    return frozenset(re.findall(r"(?=[\w.-]*\d)[^\W\d][\w.-]*\w", text))


_LABEL = re.compile(r"[A-Z]{5}SS\d\.\d\w+")


@cache
def labelled() -> frozenset[tuple[str, str]]:
    """The rows of the committed reports with their labels in the paper's source."""
    return frozenset(
        re.findall(r"^\| [^|]* \| `([^`|]+)` \| [^|]*`(\w+SS[^`|]+)`", reports(), re.MULTILINE)
    )


def exists(path: str) -> bool:
    """Whether a text is a path, from here or from a folder of which the pages speak."""
    folders = ("", "verify/paper", "verify/coq", "certificates")
    return any((ROOT / folder / path).exists() for folder in folders)


@cache
def of_commands() -> frozenset[str]:
    """The words of commands: in the blocks of all pages, and in what the commands tell of them."""
    tools = ("tests/golden/__main__.py", "tests/mutation.py", "tests/measure/techniques.py")
    paths = [*(ROOT / "verify/cli").glob("*.py"), *(ROOT / tool for tool in tools)]
    sources = [path.read_text(encoding="utf-8") for path in paths]
    texts = [blocks(page.read_text(encoding="utf-8")) for page in PAGES]
    return frozenset(re.split(r"[\s,;\"'`]+", " ".join([*sources, *texts])))


def is_command(text: str) -> bool:
    """Whether a text is a command or an option, all of whose words are known."""
    first, *others = text.split()
    starts = first in ("verify", "python", "theorem1", "pip") or first.startswith("--")
    return starts and all(
        word in of_commands()
        or word in ("-m", "-O")
        or exists(word)
        or word in words()
        or exists(word.replace(".", "/") + ".py")
        or exists(word.replace(".", "/"))
        for word in (first, *others)
    )


def code(blocks: str, text: str) -> Iterator[Span]:
    """Code in a line that exists: a path, a name with digits, or what a block of the page has."""
    for match in _INLINE.finditer(text):
        inner = " ".join(match[0].strip("` ").split())
        if not re.search(r"\w", inner):
            continue
        if _LABEL.fullmatch(inner):
            line = text[text.rfind("\n", 0, match.start()) + 1 : text.find("\n", match.end())]
            if any((name, inner) in labelled() for name in re.findall(r"`([^`]+)`", line)):
                yield match.span()
            continue
        if is_command(inner):
            yield match.span()
        shown_there = rf"(?<![\w.-]){re.escape(inner)}(?![\w-]|\.\w)"
        if inner in words() or exists(inner) or re.search(shown_there, blocks):
            yield match.span()


def paragraphs(text: str) -> Iterator[tuple[int, str]]:
    """The parts of a page between empty lines, each with its place."""
    place = 0
    for part in re.split(r"(\n[ ]*\n)", text):
        yield place, part
        place += len(part)


@cache
def covered(shown_here: str, text: str) -> tuple[Span, ...]:
    """What the rules of this file cover in a paragraph of a page with these blocks."""
    rules = (formulas, equations, idioms)
    own = [span for rule in rules for span in rule(text)]
    return (*own, *shown(shown_here, text), *code(shown_here, text))


def unwatched(text: str, spans: list[Span]) -> list[tuple[int, str]]:
    """The words with something to watch outside all spans, each with its line."""
    free = bytearray(b"\1" * len(text))
    for start, end in spans:
        free[start:end] = bytes(end - start)
    places = [found.start() for found in WATCHED.finditer(text) if free[found.start()]]
    words = {
        (
            text.count("\n", 0, place) + 1,
            re.split(r"\s", text[:place])[-1] + text[place:].split()[0],
        )
        for place in places
    }
    return sorted(words)
