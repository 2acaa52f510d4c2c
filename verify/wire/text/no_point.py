"""Why no point of a context was found, and what to write or to mend."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import isnan

from verify.language.statement import Constant, Given
from verify.language.terms import names_of
from verify.prover.ground import Ground
from verify.prover.search.interior import contradiction_of
from verify.prover.session import Session


def why_no_point(
    context: str,
    variables: Mapping[str, str],
    givens: Sequence[Given],
    numbers: tuple[Sequence[Constant], Mapping[str, float]],
    in_time: str,
) -> tuple[list[str], str]:
    """What is to be mended, and why.

    Args:
        context: its name.
        variables: as they are written, and their names.
        givens: of the context.
        numbers: the constants, and about what names stand for.
        in_time: what may help as well, where the search ended before its time.
    """
    if undefined := _without_value(*numbers, givens):
        name, why = undefined
        why = f"{why}, so no point of the context {context} is known; mend it"
        return ["constants", name], why
    place = ["contexts", context]
    wrong = contradiction_of([*variables.values()], [given.claim for given in givens])
    if wrong is not None:
        return place, f"the givens contradict each other: {wrong.words}; mend one of them"
    sides = ", ".join(f"{written} = ..." for written in variables)
    return place, (
        f"no point was found at which all givens hold; write {in_time}one, as "
        f"point = {{ {sides} }}; or mend the givens, if they contradict each other"
    )


def _without_value(
    constants: Sequence[Constant], floats: Mapping[str, float], givens: Sequence[Given]
) -> tuple[str, str] | None:
    """A constant in the givens that is known to have no value, and why."""
    claims = [given.claim for given in givens]
    used = {n for claim in claims for n in names_of(claim.lhs, claim.rhs)}
    if not any(isnan(floats.get(one.name, 0.0)) for one in constants if one.name in used):
        return None
    ground = Ground(Session())
    for constant in constants:
        ground.know(constant.name, constant.term)
        why = ground.why_no_value(constant.term)
        if isnan(floats[constant.name]) and why != ground.no_value:
            return constant.name, why
    return None
