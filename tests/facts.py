"""What the prose of the pages says in numbers, each from the program that computes or proves it.

``said("docs/x.md", "at most {} bits", MAX)`` puts values of the program into the gaps of a text.
What stands beside the gaps may have digits only if ``by`` has them, word for word: a row of a
committed certificate, a sentence of the program, a file, or a formula that is computed (`true`).
Figures that were measured once, and that no program computes again, are in `measured.json` with
what was run; a page repeats them.
"""

from __future__ import annotations

import json
import random
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import Any, NamedTuple

from mpmath import mp, mpf

from docs.generated import document, figures, point, sentences_of
from tests.prose import CERTIFICATES, CHUNK, ROOT, WATCHED, plain
from verify.language.statement import Obligation
from verify.language.terms import Claim
from verify.paper.commands.theorem1 import decide_point
from verify.paper.source import printed_numbers
from verify.prover.decimals import short
from verify.views import words
from verify.views.point import final_angle
from verify.wire.inputs import InputError
from verify.wire.text.read_page import read_page

Samples = Callable[[random.Random], Mapping[str, Any]]


class Said(NamedTuple):
    """A text of a page (of all pages, if that is empty), as the program makes it."""

    page: str
    text: str


#: How small numbers are written.
NUMBERS = ("none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine")

ENTRIES: list[Said] = []


def said(page: str, template: str, *values: object, by: str = "") -> None:
    """Watch a text.

    Raises:
        ValueError: if it has a number of its own that nothing proves.
    """
    known = plain(by)
    for match in CHUNK.finditer(template.replace("{}", " | ")):
        own = plain(match[0]).strip(",.;:*=+<≤>≥%")
        if WATCHED.search(own) and own not in known:
            raise ValueError(f"{template!r}: nothing says {own!r}")
    parts, gaps = template.split("{}"), [*map(str, values), ""]
    ENTRIES.append(Said(page, "".join(a + b for a, b in zip(parts, gaps, strict=True))))


def so(page: str, text: str, *facts: object) -> None:
    """Watch a text that is so because of facts, each of them true.

    Raises:
        ValueError: if one is not.
    """
    if not (facts and all(facts)):
        raise ValueError(f"{text!r} is not so")
    said(page, text, by=text)


# --- formulas that are computed -------------------------------------------------------------------

_TOKEN = re.compile(
    r"\s*(\|[^|]+\||√|\*\*|exp|atan|[⁰¹²³⁴⁵⁶⁷⁸⁹]+|\d+(?:\.\d+)?|[A-Za-zαβγδζηθκρσφΓπ]"
    r"(?:_[a-z0-9]+|[₀-₉]+)?'?|.)"
)
_UP = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹", "0123456789")


def python(text: str, names: Mapping[str, Any]) -> str:
    """A formula in the paper's notation, in that of Python; products have no sign."""
    found: list[str] = []
    for token in _TOKEN.findall(re.sub(r"√([\d.]+|[a-z])", r"√(\1)", text.strip())):
        known = token in names
        starts = known or token[0].isdecimal() or token in ("(", "√", "exp", "atan", "π")
        if starts and found and (found[-1][-1] in "])" or found[-1].startswith("mpf")):
            found.append("*")
        if known:
            found.append(f"names[{token!r}]")
        elif token[0] in "⁰¹²³⁴⁵⁶⁷⁸⁹":
            found.append(f"**({token.translate(_UP)})")
        elif token[0].isdecimal():
            found.append(f"mpf('{token}')")
        elif token == "^":
            found.append("**")
        elif token in ("√", "exp", "atan", "π"):
            found.append({"√": "mp.sqrt", "π": "(mp.pi)"}.get(token, f"mp.{token}"))
        elif token in "()+-/":
            found.append(token)
        else:
            raise ValueError(f"{text!r}: {token!r} is not understood")
    return " ".join(found)


def true(text: str, names: Samples) -> str:
    """The text, an equation or inequality that holds at random points, its parts from the left.

    Raises:
        ValueError: if it is false.
    """
    draw = random.Random(text)
    left, *rest = re.split(r"(=|≤|≥|<|>)", text)
    if not rest:
        raise ValueError(f"{text!r} compares nothing")
    with mp.workdps(40):
        for _ in range(20):
            values = names(draw)
            before = computed(left, values)
            for sign, part in zip(rest[::2], rest[1::2], strict=True):
                after = computed(part, values)
                near = abs(before - after) <= mpf(10) ** -30 * max(1, abs(after))
                found = {"=": near, "≤": before <= after or near, "≥": before >= after or near}
                if not (found | {"<": before < after, ">": before > after})[sign]:
                    raise ValueError(f"{text!r} is false")
                before = after
    return text


def computed(text: str, names: Mapping[str, Any]) -> Any:
    """The value of a formula."""
    return eval(python(text, names), {"names": names, "mp": mp, "mpf": mpf})


def between(low: float, high: float, *letters: str) -> Samples:
    """Letters with independent values in an interval."""
    return lambda draw: {letter: mpf(draw.uniform(low, high)) for letter in letters}


# --- what the program says ------------------------------------------------------------------------


@cache
def row(folder: str, name: str) -> str:
    """What the report of a committed certificate has of a row, verdict first."""
    text = (CERTIFICATES / folder / "report.md").read_text(encoding="utf-8")
    found = [
        line for line in text.split("\n") if re.match(rf"\| [^|]*\| `{re.escape(name)}` \|", line)
    ]
    if not found or "undecided" in "".join(line.split("|")[1] for line in found):
        raise ValueError(f"{folder}: {name} is no row that is decided")
    return "\n".join(found)


def sides(name: str, digits: int = 3) -> list[str]:
    """Both sides of a printed row at the point of the pages, as the screen shows them."""
    (found,) = (
        r for r in point()["sets"]["printed"]["obligations"] if r["name"] == f"printed.{name}"
    )
    ends = (tuple(map(Fraction, found[side])) for side in ("lhs", "rhs"))
    return [short(pair, digits).rstrip("…") for pair in ends]


def has(path: str, *codes: str) -> bool:
    """Whether a file of the project says all of this, spaces apart."""
    text = " ".join(file(path).split())
    return all(" ".join(code.split()) in text for code in codes)


def number(label: str) -> str:
    """The printed number of a label of the paper."""
    return printed_numbers()[label]


def obligations(*claims: str) -> list[Obligation]:
    """The rows of a page with these claims about numbers of which x is positive."""
    rows = "".join(
        f"r{i or ''} = {{ claim = '{text}', in = 'all' }}\n" for i, text in enumerate(claims)
    )
    page = (
        "title = 't'\n[contexts.all]\nvariables = 'a b c d t x y delta_1'\n"
        f"given = ['0 < x']\n[rows]\n{rows}"
    )
    return list(read_page("t.toml", page.encode()).statement.obligations)


def names_of_rows(claim: str) -> list[str]:
    """The names of the rows that a page makes of the claim of a row `r`."""
    return [row.name for row in obligations(claim)]


def givens(claim: str) -> list[Claim]:
    """What is given where a claim is."""
    page = (
        f"title = 't'\n[contexts.all]\nvariables = 'b t'\ngiven = ['{claim}']\n"
        "rows = { r = 't < b' }\n"
    )
    (context,) = read_page("t.toml", page.encode()).statement.contexts
    return [given.claim for given in context.givens]


@cache
def alike(*texts: str) -> bool:
    """Whether a page reads all these terms, or claims, as the same one."""
    claims = [text if re.search(r"[<>=≠≤≥]", text) else f"0 <= {text}" for text in texts]
    return len({row.claim for row in obligations(*claims)}) == 1


@cache
def refuses(text: str) -> bool:
    """Whether a page refuses a formula."""
    try:
        return not alike(text)
    except InputError:
        return True


@cache
def here() -> Any:
    """The outcome at the point."""
    from tests.points import parameters

    return decide_point(parameters("3/100", "1"))


@cache
def angle() -> tuple[str, str]:
    """Up to which δ_θ `final-angle` fails at the point, and by which factor."""
    found = re.findall(r"δ_θ ≤ (\S+), .* by up to (\S+) δ_θ", final_angle(here()))
    return found[0]


def constant(name: str) -> Fraction:
    """A rounded constant of the repaired set at the point."""
    return Fraction(words.definitions_of(here())[f"repaired.{name}"].value)


def told(value: object, digits: int = 3) -> str:
    """A number with the digits that are certain."""
    number = Fraction(str(value))
    return short((number, number), digits)


F = figures()
MEASURED = json.loads((ROOT / "tests/measured.json").read_text(encoding="utf-8"))
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
#: The point that the pages speak about.
R, C = told(point()["parameters"]["r"]), point()["parameters"]["neg_cos_theta0"]
AT = f"r = {R}, θ₀ = π"
KINDS = [one["kind"] for one in point()["assumptions"]]
COUNTED = sum(
    one["verdict"] != "proved"
    for one in (*point()["hypotheses"], *point()["sets"]["printed"]["obligations"])
)


def sentences(folder: str) -> tuple[int, int]:
    """How many sentences a verdict rests on, and how many of them Coq has proved."""
    found = sentences_of(folder)
    return len(found), sum(proved and "(" not in name for name, proved in found)


def printed_by_checker(folder: str) -> int:
    """How many sentences the trusted file says are assumed for a folder."""
    path = str(ROOT / "certificates" / folder)
    words = [sys.executable, "-I", str(ROOT / "verify/check.py"), path]
    done = subprocess.run(words, capture_output=True, encoding="utf-8", check=True)
    return sum(line.startswith("assumed") for line in done.stdout.splitlines())


def percent(part: int, whole: int) -> str:
    """A share in percent, rounded to one decimal."""
    tenths = int(Fraction(1000 * part, whole) + Fraction(1, 2))
    return f"{tenths // 10}.{tenths % 10}"


def in_thousands(number: int) -> str:
    """As the pages write it."""
    return f"{number:,}".replace(",", " ")


def file(path: str) -> str:
    """The text of a file of the project."""
    return (ROOT / path).read_text(encoding="utf-8")


def coded(text: str, path: str, code: str) -> str:
    """The text, of which a file of the project says the same in its own notation.

    Raises:
        ValueError: if it does not.
    """
    if " ".join(code.split()) not in " ".join(file(path).split()):
        raise ValueError(f"{text!r}: {path} does not say {code!r}")
    return text


def given(text: str, fact: bool) -> str:
    """The text, which is said because of a fact.

    Raises:
        ValueError: if it is none.
    """
    if not fact:
        raise ValueError(f"{text!r} is not so")
    return text


def digits(formula: str, count: int) -> str:
    """A number without letters, cut to so many digits."""
    with mp.workdps(40):
        ends = Fraction(str(computed(formula, {})))
    return told(ends, count).rstrip("…")


def digits_of(ends: list[str], count: int) -> str:
    """An enclosure, rounded to so many decimals."""
    return f"{float(Fraction(ends[0])):.{count}f}"


def half(draw: random.Random) -> Mapping[str, Any]:
    """The tangent of half an angle, and the cosine."""
    a = mpf(draw.uniform(0, 3))
    return {"t": mp.tan(a / 2), "C": mp.cos(a), "S": mp.sin(a)}


def admissible(draw: random.Random) -> Mapping[str, Any]:
    """r and α₀ as in Theorem 1, with two fixed points."""
    r = mpf(draw.uniform(0.001, 0.05))
    c = mpf(draw.uniform(float(2 * r ** (mpf(1) / 3) * (1 + r ** (mpf(1) / 3)) / (1 + r)), 1))
    return {"r": r, "α": (1 + r) / 2 * c}


def sine(draw: random.Random) -> Mapping[str, Any]:
    """A number with its arc sine and its arc cosine."""
    x = mpf(draw.uniform(-1, 1))
    return {"x": x, "A": mp.asin(x), "C": mp.acos(x)}


def in_line(draw: random.Random) -> Mapping[str, Any]:
    """Three particles in line that touch, the sum of the masses, and Σ m|x|² about their centre."""
    o, a, b, left, right = (mpf(draw.uniform(1, 2)) for _ in range(5))
    masses, places = (o, a, b), (mpf(0), -left, right)
    centre = sum(m * x for m, x in zip(masses, places, strict=True)) / sum(masses)
    spread = sum(m * (x - centre) ** 2 for m, x in zip(masses, places, strict=True))
    names = {"m_o": o, "m_a": a, "m_b": b, "σ_oa": left, "σ_ob": right}
    return names | {"M": sum(masses), "B": spread}


def turned(draw: random.Random) -> Mapping[str, Any]:
    """Numbers with A²R₀² < (R₀² - B)L²."""
    R, A, L, t = (mpf(draw.uniform(1, 2)) for _ in range(4))
    return {"R₀": R, "A": -A, "L": L, "t": t, "B": R**2 - A**2 * R**2 / L**2 - 1}


def confidence() -> tuple[str, str]:
    """How often the intervals of a sample may miss, by default and in the example."""
    from verify.cli.scene import USAGE

    found = re.findall(r"default (\d+)%", USAGE.meanings["--confidence P%"])[0]
    return str(100 - int(found)), "1"


def strip_border() -> str:
    """φ₂ on the border of the committed map of a strip, where φ₁ = 1/100."""
    plane = json.loads(file("certificates/map/strip/map.json"))["plane"]
    if Fraction(plane["x"][0]) != Fraction(1, 100):
        raise ValueError("the strip begins elsewhere")
    return f"{float(Fraction(plane['curve'][0][0])):.4f}"


def separatrix_at(q: str) -> str:
    """φ₂ on the separatrix."""
    found = document("separatrix", "--r", "0.03", "--at", q)
    return f"{float(Fraction(found['f']['phi_2'][0])):.4f}"


def limit_map(draw: random.Random) -> Mapping[str, Any]:
    """A state of the limit map with its image, as `verify/coq/Separatrix.v` defines it."""
    r, α, ρ, u, q = (mpf(draw.uniform(0.01, 0.2)) for _ in range(5))
    p = α * 4 * (1 - u) - q * mpf("0.1") - ρ * u
    φ = q * mpf("0.1")
    square = ρ * u * (2 * φ + ρ * u) / p**2
    new = 1 - mp.sqrt(1 - square) if square <= 1 else mp.nan
    names = {"r": r, "α": 4 * α, "ρ": ρ, "u": u, "φ₁": φ, "p": p, "u'": new}
    return names | {"φ₂": u * (2 - u) / 2, "|W_c|": mpf(1)} if square < 1 else limit_map(draw)
