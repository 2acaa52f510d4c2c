"""What people and scripts see of Theorem 1 on a box of parameters."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from verify.language.statement import PROVED, REFUTED, Assumption, Publication
from verify.prover.decimals import exact_number
from verify.views.document import assumption_document, claims_document
from verify.views.everywhere import THEOREM
from verify.views.material import Answer, ParameterBox
from verify.views.words import believed, given, in_letters

FORMAT = "verify-theorem1-box/1"


def screen(answer: Answer, paper: Publication) -> Iterator[str]:
    """What holds on the box, or on which part of it."""
    cited = answer.outcome.assumptions
    yield f"Theorem 1 at all points with {_words(answer.box)}"
    yield ""
    if answer.verdict == REFUTED:
        yield "The stability condition fails at each of these points."
        yield ""
        yield f"Verdict: refuted: {in_letters(answer.outcome.statement.title)}"
        return
    where = "all points" if answer.verdict == PROVED else "all points of the certified part"
    yield f"The hypotheses are compared at a corner; by monotony they hold at {where}."
    yield "The constants are the unrounded minima of Theorem 1 for all parameters."
    yield f"{believed(answer.outcome, paper)} The sentences: -v."
    yield ""
    yield THEOREM
    yield ""
    if answer.verdict == PROVED:
        yield f"Verdict: proved: {in_letters(answer.outcome.statement.title)}; given {given(cited)}"
        return
    yield "The certified part, as a command:"
    yield f"  {_command(answer)}"
    yield (
        "Verdict: undecided: the hypotheses fail at some points of the box; they hold at all with "
        f"{_words(answer.part)}; given {given(cited)}"
    )


def _words(box: ParameterBox) -> str:
    return f"r {_side(box.r)} and -cos θ₀ {_side(box.c)}"


def _side(side: tuple[Fraction, Fraction]) -> str:
    low, high = side
    texts = exact_number(low), exact_number(high)
    return f"= {texts[0]}" if low == high else f"in [{texts[0]}, {texts[1]}]"


def _command(answer: Answer) -> str:
    """The command that decides the certified part."""
    part, parameters = answer.part, answer.outcome.statement.parameters
    v_0, delta = (parameters[name].value for name in ("V_0", "delta_theta"))
    return (
        f"verify theorem1 --r {_range(part.r)} --neg-cos {_range(part.c)} "
        f"--V0 {v_0} --delta-theta {delta}"
    )


def _range(side: tuple[Fraction, Fraction]) -> str:
    return f"{side[0]}..{side[1]}"


def box_document(answer: Answer, cited: tuple[Assumption, ...]) -> dict[str, Any]:
    """One JSON document; its claims are about the part that is certified."""
    found = claims_document(answer.outcome, "theorem1", FORMAT)
    parameters = answer.outcome.statement.parameters
    found["verdict"] = answer.verdict
    if answer.verdict not in (PROVED, REFUTED):
        found["headline"] = answer.verdict
    found["parameters"] = {
        **_sides(answer.box),
        "delta_theta": str(parameters["delta_theta"].value),
        "V_0": str(parameters["V_0"].value),
    }
    found["certified"] = None if answer.verdict == REFUTED else _sides(answer.part)
    used = () if answer.verdict == REFUTED else cited
    found["assumptions"] = [assumption_document(assumption) for assumption in used]
    return found


def _sides(box: ParameterBox) -> dict[str, list[str]]:
    return {"r": list(map(str, box.r)), "neg_cos_theta0": list(map(str, box.c))}
