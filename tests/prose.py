"""Numbers and formulas in README.md and docs/: what is seen of them, and what proves each.

A page is read without its blocks of code, which are run, and without what the program writes into
it. Each digit, power and root that is left has to lie in a span that something covers:

* a formula that stands word for word in what the program writes of a committed certificate, or in a
  block of the same page, which is run and compared;
* an equation between numbers, which is computed;
* a label of the paper, or the version of a program, that exists;
* an entry of `tests.watched`: words with the numbers of the program in their gaps.

Whatever is left over is `unwatched`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache

from mpmath import mpf, sqrt, workdps

from tests.readme_commands import ROOT
from verify.paper.source import PAPER, printed_numbers
from verify.views import all_parameters, classification

CERTIFICATES = ROOT / "certificates"

PAGES = [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]

#: What has to be covered: digits, powers and roots. Digits below the line belong to letters.
WATCHED = re.compile(r"[\d⁰¹²³⁴⁵⁶⁷⁸⁹√]")
_CODE = re.compile(r"^ *(```+)(?!\{glossary|\{note)[^\n]*\n.*?^ *\1[ ]*$", re.MULTILINE | re.DOTALL)
_GENERATED = re.compile(r"<!--.*?-->|\{\{.*?\}\}", re.DOTALL)
_INLINE = re.compile(
    r"`[^`\n]*\n?[^`\n]*`|<code>.*?</code>|\]\([^)\s]*\)|https?://[^\s)]+|^(?::::|''')[^\n]*",
    re.MULTILINE,
)
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


def prose(text: str) -> str:
    """A page without blocks of code, code in a line, addresses, and what is generated."""
    for pattern in (_CODE, _GENERATED, _INLINE):
        text = pattern.sub(blank, text)
    return text


def plain(text: str) -> str:
    """A formula without spaces, dots of products and marks of Markdown."""
    return re.sub(r"[\s\\`*·]", "", text)


@cache
def written() -> str:
    """What the program writes of the committed certificates, and says of its theorems."""
    reports = [path.read_text("utf-8") for path in sorted(CERTIFICATES.rglob("report.md"))]
    said = [
        *classification.THEOREMS,
        all_parameters.CLAIM,
        *(text for _, text in PAPER.notes().causes),
    ]
    said += [change.needed for change in PAPER.notes().changes]
    return re.sub(r"[\\`*·]", "", "\n".join([*reports, *said]))


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
    """What stands in the blocks of a page, as words between spaces."""
    found = " ".join(match[0] for match in _CODE.finditer(text))
    return f" {' '.join(re.split(_BETWEEN, found))} "


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


def shown(page: str, text: str) -> Iterator[Span]:
    """Numbers of three digits and more that a block of the page shows, or is given."""
    known = blocks(page)
    for match in re.finditer(r"[^\s|*]*\d[^\s|*]*", text):
        word = match[0].strip(',.;:()[]"*?')
        if len(re.findall(r"\d", word)) >= 3 and f" {word} " in known:
            yield match.span()


def labels(text: str) -> Iterator[Span]:
    """Labels of the paper that exist: (4.10), Theorem 1, Section 4.2, Cnd7."""
    numbers = set(printed_numbers().values())
    numbers |= {f"Section {number[1]}" for number in numbers if number.startswith("(")} | {
        "Section 1"
    }
    for match in re.finditer(r"\(\d\.\d+\)", text):
        if match[0] in numbers:
            yield match.span()
    kinds = "Theorem|Proposition|Definition|Lemma|Remark|Section"
    for match in re.finditer(
        rf"\b({kinds})s?\s+(\d(?:\.\d)?(?:(?:,| and| to)\s+\d(?:\.\d)?)*)", text
    ):
        parts = re.findall(r"\d(?:\.\d)?", match[2])
        if all(f"{match[1]} {part}" in numbers for part in parts):
            yield match.span()
    for match in re.finditer(r"\bCnd(10|[1-9])\b", text):
        yield match.span()


#: The particles of the paper are 0, 1 and 2, and a bound or a limit that is 0 is not measured.
_SAYINGS = (
    r"\bparticles 0 and 1\b|\b0-1 and 0-2\b|\b0-2, 0-1, 0-2\b|\b02, 01, 02\b|\bthat of 1\b",
    r"(?<!and[ \n])(?<!,[ \n])\b(?:0-[12]|1-2)\b(?! and [012]-|, [012]-)|\b1 and 2\b",
    r"(?<!between[ \n])\b0 and [12c]\b|\bbetween 0 and [c1]\b|\]0, ?1[\]\[]|SMT-LIB 2\b",
    r"\b(?:[Pp]articles?|balls?|spheres?|at|of|from|where|measure|momentum) 0\b(?!\.?\d)",
    r"\b(?:tends?|falls?|up) to 0\b|\breaches 0\b|[<>≥≤=→≠] 0\b(?!\.\d)|\b0 <",
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


def covered(page: str, text: str) -> Iterator[Span]:
    """What the rules of this file cover."""
    for rule in (formulas, equations, labels, marks, idioms):
        yield from rule(text)
    yield from shown(page, text)


def unwatched(page: str, spans: list[Span]) -> list[tuple[int, str]]:
    """The words with something to watch outside all spans, each with its line."""
    text = prose(page)
    free = bytearray(b"\1" * len(text))
    for start, end in spans:
        free[start:end] = bytes(end - start)
    return [
        (text.count("\n", 0, word.start()) + 1, word[0])
        for word in re.finditer(r"\S+", text)
        if any(free[word.start() + found.start()] for found in WATCHED.finditer(word[0]))
    ]
