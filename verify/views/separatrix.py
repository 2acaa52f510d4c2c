"""What people and scripts see of the separatrix."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from verify.language.statement import PROVED, UNDECIDED
from verify.prover.decimals import exact_number, outward, rational_text, short
from verify.prover.outcome import Ends

FORMAT = "verify-separatrix/1"

#: What the spheres know of a separatrix, and of its curve at a place: records of theirs, whose
#: entries are read.
Separatrix = Any
CurveAt = Any

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

#: Digits of the ends in a document, beyond those asked for.
EXTRA_DIGITS = 6


def phi_2(u: Ends) -> Ends:
    """The paper's φ₂ = u(2-u)/2 for |W_c| = 1, which grows with u up to 1."""
    low, high = (end * (2 - end) / 2 for end in u)
    return low, high


# --- JSON -----------------------------------------------------------------------------------------


def separatrix_document(found: Separatrix) -> dict[str, Any]:
    """One JSON document; every number is a string."""
    r, c, ratio = map(rational_text, found.parameters)
    document: dict[str, Any] = {
        "format": FORMAT,
        "command": "separatrix",
        "verdict": found.verdict,
        "parameters": {"r": r, "neg_cos_theta": c, "ratio": ratio},
        "exists": {"answer": found.exists, "judge": found.exists_by},
        "believed": list(BELIEVED),
        "not_decided": list(NOT_DECIDED),
    }
    if found.at is not None:
        document["at"] = rational_text(found.at)
    if found.exists is False:
        return document | {"f": _values((Fraction(0), Fraction(0)), found.digits)}
    rows = [_row(found, strip) for strip in found.strips]
    if found.at is not None and rows:
        document |= {key: rows[0][key] for key in ("f", "judge")}
    elif rows:
        document["table"] = rows
    if found.fixed:
        minus, plus = (outward(ends, found.digits + EXTRA_DIGITS) for ends in found.fixed)
        document["fixed_points"] = {"phi_minus": minus, "phi_plus": plus}
    if found.cycle:
        q, u = (outward(ends, found.digits + EXTRA_DIGITS) for ends in found.cycle)
        document["cycle"] = {"q": q, "u": u, "judge": found.cycle_by}
    return document


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


def screen(found: Separatrix) -> Iterator[str]:
    """The table, the points on it, what is believed and what is not decided, the verdict."""
    r, c, ratio = map(exact_number, found.parameters)
    yield f"Separatrix of the limit map at r = {r}, -cos θ = {c}, ratio {ratio}"
    yield ""
    yield from _existence(found)
    yield from _curve(found)
    yield "What this rests on, beside the judges that are named"
    yield from (f"  {number}. {text}" for number, text in enumerate(BELIEVED, 1))
    yield "What is not decided here"
    yield from (f"  {number}. {text}" for number, text in enumerate(NOT_DECIDED, 1))
    yield ""
    yield f"Verdict: {_verdict(found)}"


def _existence(found: Separatrix) -> Iterator[str]:
    """Whether there is a curve at all."""
    if found.exists is None:
        yield "Whether there is a separatrix is not decided."
    elif found.exists:
        yield f"There is a separatrix: s + s² < a, where s³ = r and a = {_a(found)}."
        yield "Below the curve u = f(q) the collisions go on for ever; above it they end."
    else:
        yield (
            f"There is no separatrix: a ≤ s + s², where s³ = r and a = {_a(found)}. No orbit with "
            "u > 0 goes on for ever; f is 0 everywhere."
        )
    yield ""


def _a(found: Separatrix) -> str:
    return exact_number(found.parameters.a)


def _curve(found: Separatrix) -> Iterator[str]:
    if not found.strips:
        return
    rows = [("q", "u = f(q)", "φ₂ for |W_c| = 1")]
    for strip in found.strips:
        u, phi = (short(ends, found.digits) for _, ends in _named((strip.low, strip.high)))
        rows.append((exact_number(strip.q), u, phi))
    widths = [max(len(row[column]) for row in rows) for column in range(2)]
    for row in rows:
        yield f"  {row[0]:<{widths[0]}}  {row[1]:<{widths[1]}}  {row[2]}"
    yield ""
    minus, plus = (short(ends, found.digits) for ends in found.fixed)
    yield f"Fixed points with u = 0: q = {minus} (a sink for two collisions), q = {plus}"
    if found.cycle:
        q, u = (short(ends, found.digits) for ends in found.cycle)
        yield f"The cycle on the curve: q = {q}, u = {u} (judge: {found.cycle_by})"
    elif found.at is None:
        yield "The cycle on the curve was not enclosed."
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
