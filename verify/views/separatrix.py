"""What people and scripts see of the separatrix."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from typing import Any

from verify.language.statement import PROVED, UNDECIDED
from verify.prover.decimals import exact_number, outward, rational_text, short
from verify.prover.outcome import Ends, Outcome
from verify.publication import Publication
from verify.views.document import claims_document
from verify.views.row_lists import screen as rows_screen
from verify.views.words import summary

FORMAT = "verify-separatrix/1"
CURVES_FORMAT, THEOREM_FORMAT = "verify-separatrix-curves/1", "verify-separatrix-theorem/1"
#: The judge of a certificate.
CHECKER = "verify/check.py"

#: What the spheres know of a separatrix, and of its curve at a place: records of theirs, whose
#: entries are read.
Separatrix = Any
CurveAt = Any
Parameters = Any

#: What the verdicts rest on, beside their judges.
BELIEVED = (
    "the theorem on the curve of the limit map, with its proof in Coq (verify/coq/Separatrix.v)",
    "the ball arithmetic of FLINT, and Python's whole numbers",
)
#: What this command says nothing about.
NOT_DECIDED = (
    "the full dynamics: this map is its limit for small distances, and a scene may do otherwise",
    "how near to the curve a scene may lie for the map to foretell what it does",
    "what scenes on the curve do, and those of which a tangential speed tends to 0",
)

#: An exact number with more signs is shown by its digits.
LONGEST = 60
#: Digits of what the letters of unlike balls are multiplied by.
SHOWN_DIGITS = 8
#: Digits of the ends in a document, beyond those asked for.
EXTRA_DIGITS = 6


def phi_2(u: Ends) -> Ends:
    """The paper's φ₂ = u(2-u)/2 for |W_c| = 1, which grows with u up to 1."""
    low, high = (end * (2 - end) / 2 for end in u)
    return low, high


# --- JSON -----------------------------------------------------------------------------------------


def separatrix_document(found: Separatrix, certified: str = "") -> dict[str, Any]:
    """One JSON document; every number is a string. A certificate says what was certified."""
    document: dict[str, Any] = {
        "format": FORMAT,
        "command": "separatrix",
        "verdict": found.verdict,
        "parameters": _parameters(found.parameters),
        "exists": {"answer": found.exists, "judge": found.exists_by},
        "believed": list(BELIEVED),
        "not_decided": list(NOT_DECIDED),
    }
    if found.at is not None:
        document["at"] = rational_text(found.at)
    if certified:
        document["certificate"] = {"says": certified, "judge": CHECKER}
    if found.exists is False:
        return document | {"f": _values((Fraction(0), Fraction(0)), found.digits)}
    rows = [_row(found, strip) for strip in found.strips]
    if found.at is not None and rows:
        document |= {key: rows[0][key] for key in ("f", "judge")}
    elif rows:
        document["table"] = rows
    if found.fixed:
        minus, plus = (outward(ends, found.digits + EXTRA_DIGITS) for ends in found.fixed)
        document["fixed_points"] = {"phi_minus": minus, "phi_plus": plus, "judge": found.fixed_by}
    if found.cycle:
        q, u, x, v = (outward(ends, found.digits + EXTRA_DIGITS) for ends in found.cycle)
        document["cycle"] = {"q": q, "u": u, "next": {"q": x, "u": v}, "judge": found.cycle_by}
    return document


def _parameters(parameters: Parameters) -> dict[str, Any]:
    names = ("r", "neg_cos_theta", "ratio")
    told: dict[str, Any] = dict(zip(names, map(rational_text, parameters[:3]), strict=True))
    if parameters.is_unlike:
        for name in ("masses", "radii"):
            told[name] = [rational_text(value) for value in getattr(parameters, name)]
    return told


def line_of(parameters: Parameters, *, of_one: bool = True) -> str:
    """The parameters in a line; of several curves without r."""
    r, c, ratio = map(exact_number, parameters[:3])
    words = [f"r = {r}"] if of_one else []
    words += [f"-cos θ = {c}", f"ratio {ratio}"]
    if parameters.is_unlike:
        masses, radii = (", ".join(map(exact_number, values)) for values in parameters[3:])
        words.append(f"masses {masses}, radii {radii}")
    return ", ".join(words)


def curves_document(curves: Sequence[Separatrix]) -> dict[str, Any]:
    """The documents of several r, and the verdict on all of them."""
    return {
        "format": CURVES_FORMAT,
        "command": "separatrix",
        "verdict": _all(curves),
        "curves": [separatrix_document(found) for found in curves],
    }


def theorem_document(outcome: Outcome) -> dict[str, Any]:
    """The document of the theorem for all parameters."""
    return claims_document(outcome, "separatrix", THEOREM_FORMAT)


def _row(found: Separatrix, strip: CurveAt) -> dict[str, Any]:
    return {
        "q": rational_text(strip.q),
        "f": _values((strip.low, strip.high), found.digits),
        "verdict": PROVED if strip.reached else UNDECIDED,
        "judge": strip.judge,
    }


def _values(u: Ends, digits: int) -> dict[str, list[str]]:
    return {name: outward(ends, digits + EXTRA_DIGITS) for name, ends in _named(u)}


def _named(u: Ends) -> tuple[tuple[str, Ends], ...]:
    return ("u", u), ("phi_2", phi_2(u))


# --- the terminal ---------------------------------------------------------------------------------


def screen(found: Separatrix, certified: str = "") -> Iterator[str]:
    """The table, the points on it, what is believed and what is not decided, the verdict."""
    yield f"Separatrix of the limit map at {line_of(found.parameters)}: {found.verdict}"
    yield ""
    yield from _existence(found)
    yield from _curve(found)
    yield "What this rests on, beside the judges that are named"
    yield from (f"  {number}. {text}" for number, text in enumerate(BELIEVED, 1))
    yield "What is not decided here"
    yield from (f"  {number}. {text}" for number, text in enumerate(NOT_DECIDED, 1))
    yield ""
    if certified:
        yield f"Certificate (accepted by {CHECKER}): {certified}"
    yield f"Verdict: {_verdict(found)}"


def _existence(found: Separatrix) -> Iterator[str]:
    """The line that says whether there is a curve."""
    if found.exists is None:
        yield "Whether there is a separatrix is not decided."
    elif found.exists:
        yield f"There is a separatrix: s + s² < a, where s³ = r and a = {_a(found)}."
        yield "Below the curve u = f(q) the collisions go on for ever; above it they end."
        yield from _units(found)
    else:
        yield (
            f"There is no separatrix: a ≤ s + s², where s³ = r and a = {_a(found)}. No orbit with "
            "u > 0 goes on for ever; f is 0 everywhere."
        )
    yield ""


def _units(found: Separatrix) -> Iterator[str]:
    """What the letters mean for unlike balls."""
    if found.parameters.is_unlike:
        scale, rho = (_number(ends, SHOWN_DIGITS) for ends in (found.scale, found.rho))
        yield (
            "Ball 0 is in the middle; ball 1 has just collided with it, and ball 2 is next. "
            f"Here q is {scale} times φ₁ and ρ is {rho}; the gap in φ₂ is measured in R₀ + R₂."
        )


def _a(found: Separatrix) -> str:
    return _number(found.a, found.digits)


def _number(ends: Ends, digits: int) -> str:
    """A number exactly if it is rational and short, else with its digits."""
    exact = exact_number(ends[0]) if ends[0] == ends[1] else ""
    return exact if 0 < len(exact) <= LONGEST else short(ends, digits)


def _curve(found: Separatrix) -> Iterator[str]:
    if not found.strips:
        return
    rows: list[tuple[str, ...]] = [("q", "u = f(q)", "φ₂ for |W_c| = 1")]
    for strip in found.strips:
        u, phi = (short(ends, found.digits) for _, ends in _named((strip.low, strip.high)))
        rows.append((exact_number(strip.q), u, phi))
    yield from _in_columns(rows)
    yield ""
    if found.fixed:
        minus, plus = (short(ends, found.digits) for ends in found.fixed)
        yield f"Fixed points with u = 0: q = {minus} (a sink for two collisions), q = {plus}"
        yield f"  (judge: {found.fixed_by})"
    if found.cycle:
        q, u, x, v = (short(ends, found.digits) for ends in found.cycle)
        kind = "The saddle" if found.is_steady else "The saddle, of period two,"
        yield f"{kind} on the curve: q = {q}, u = {u} (judge: {found.cycle_by})"
        if not found.is_steady:
            yield f"  after one collision: q = {x}, u = {v}, on the curve of 1/ratio"
    elif found.at is None:
        yield "The saddle on the curve was not enclosed."
    yield ""


def _verdict(found: Separatrix) -> str:
    """The verdict with what it is about, and its judge."""
    judges = " and ".join(
        dict.fromkeys([found.exists_by, *(strip.judge for strip in found.strips)])
    )
    digits = f"{found.digits} digit{'s' if found.digits > 1 else ''}"
    if found.verdict == UNDECIDED:
        return f"undecided: f is not known to {digits} within the budget; each interval holds it"
    if not found.exists:
        return f"proved: no orbit goes on for ever (judge: {judges})"
    where = f"at {len(found.strips)} values of q"
    if found.at is not None:
        where = f"at q = {exact_number(found.at)}"
    return f"proved: f is enclosed to {digits} {where} (judge: {judges})"


def curves_screen(curves: Sequence[Separatrix]) -> Iterator[str]:
    """How the curve moves with r: where it begins and ends, and its saddle."""
    where = line_of(curves[0].parameters, of_one=False)
    yield f"Separatrices of the limit map at {where}"
    yield ""
    rows: list[tuple[str, ...]] = [("r", "f(0)", "φ⁺, where f = 0", "saddle: q", "u")]
    rows += [_curve_row(found) for found in curves]
    yield from _in_columns(rows)
    yield ""
    judges = ", ".join(dict.fromkeys(by for found in curves for by in _judges(found)))
    known = sum(found.verdict == PROVED for found in curves)
    yield f"Verdict: {_all(curves)}: {known} of {len(curves)} values of r (judges: {judges})"


def _in_columns(rows: Sequence[tuple[str, ...]]) -> Iterator[str]:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for row in rows:
        cells = (f"{cell:<{width}}" for cell, width in zip(row, widths, strict=True))
        yield f"  {'  '.join(cells)}".rstrip()


def _curve_row(found: Separatrix) -> tuple[str, ...]:
    r = exact_number(found.parameters.r)
    if found.exists is None or found.verdict != PROVED:
        return r, "not decided", "", "", ""
    if not found.exists:
        return r, "no curve", "", "", ""
    first = found.strips[0]
    ends = ((first.low, first.high), *found.fixed[1:], *found.cycle[:2])
    cells = [short(pair, found.digits) for pair in ends]
    return r, *cells, *[""] * (4 - len(cells))


def _all(curves: Sequence[Separatrix]) -> str:
    return PROVED if all(found.verdict == PROVED for found in curves) else UNDECIDED


def _judges(found: Separatrix) -> Iterator[str]:
    yield found.exists_by
    yield from (strip.judge for strip in found.strips)
    if found.fixed:
        yield found.fixed_by
    if found.cycle:
        yield found.cycle_by


# --- the theorem ----------------------------------------------------------------------------------

#: What else is proved of the curve, and by whom.
IN_COQ = (
    "Coq proves this without glue, and also that f is continuous, convex and strictly decreasing "
    "up to φ⁺, and that all orbits on it tend to one cycle: verify/coq/Separatrix.v."
)


def theorem_screen(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The rows in brief, and the theorem if it is proved."""
    yield from rows_screen("The separatrix of the limit map, for all parameters", outcome, paper)
    yield ""
    if outcome.verdict == PROVED:
        yield f"Given what is taken on trust: {outcome.statement.title}."
        yield IN_COQ
        yield ""
    yield f"Verdict: {summary(outcome, paper)}"
