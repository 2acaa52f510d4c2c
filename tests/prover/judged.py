"""Claims judged on boxes, which are cut until they are decided: what tests of fields look at."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, Term
from verify.prover.cover import Box, Field, Values, refined
from verify.prover.outcome import Ends


class JudgedBox(Record):
    """A box on which a condition was ``proved``, or left ``undecided``.

    ``verdicts`` has a verdict for each claim, for all points of the box at once, and ``size`` an
    enclosure of one more term where all wanted claims are decided; ``weight`` is the area of the
    box in units of the smallest one.
    """

    box: Box
    condition: str
    verdicts: dict[str, str]
    size: Ends | None
    weight: int


def cover(
    field: Field,
    start: Box,
    depth: int,
    condition: Claim,
    claims: Mapping[str, Claim],
    wanted: Iterable[str],
    size: Term | None = None,
) -> list[JudgedBox]:
    """Cut a box until the condition and every wanted claim is decided on each part.

    Parts on which the condition is refuted are left out. A verdict on a box holds on its parts, so
    only what is undecided is asked again.
    """
    slots, asked = field.slots(claims), tuple(wanted)
    gate = field.slots({"condition": condition})["condition"]

    def judge(values: Values, before: JudgedBox) -> tuple[JudgedBox, bool] | None:
        admissible, verdicts = before.condition, dict(before.verdicts)
        if admissible == UNDECIDED:
            admissible = values.judge(gate)
        if admissible == REFUTED:
            return None
        if admissible == PROVED:
            for name, slot in slots.items():
                if verdicts.get(name, UNDECIDED) == UNDECIDED:
                    verdicts[name] = values.judge(slot)
        enough = admissible == PROVED and all(verdicts[name] != UNDECIDED for name in asked)
        ends = values.ends(size) if enough and size is not None else None
        return JudgedBox(start, admissible, verdicts, ends, 0), enough

    nothing = JudgedBox(start, UNDECIDED, {}, None, 0)
    found = refined(field, start, depth, nothing, judge)
    return [known._replace(box=box, weight=weight) for box, weight, known in found]
