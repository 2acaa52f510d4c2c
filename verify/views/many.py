"""What people and scripts see of a scene of many balls."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from verify.prover.decimals import decimal_text, outward, round_decimal, short
from verify.prover.ground import FLINT

FORMAT = "verify-many/1"
COLLAPSES, UNDECIDED, RESTS = "collapses", "undecided", "rests"
UNDECIDED_CODE = 3
#: Digits of the enclosures in a table, and those that a decimal has at most.
DIGITS, MOST_DIGITS = 17, 1 << 16
#: What is said of a run besides its certificate.
COMPUTED = (
    "computed rigorously, without a certificate: the collisions before, their order, and that no "
    "other ball is near"
)

#: A record of the spheres whose entries are read: `verify.spheres.many.decide.Ending`.
Ending = Any
Scene = Any
Ends = tuple[Fraction, Fraction]


def exit_code(found: Ending) -> int:
    """0 with a verdict, 3 without one."""
    return UNDECIDED_CODE if found.verdict == UNDECIDED else 0


def many_lines(found: Ending, shown: Callable[[Ends], list[str]]) -> Iterator[str]:
    """What ended the run, for a reader."""
    count, labels = len(found.contacts), found.system.labels
    unit = f" {labels.time_unit}" if labels.time_unit else ""
    if labels.title:
        yield labels.title
    after = f"after {_collisions(count)} of {found.system.number} balls"
    if found.verdict == UNDECIDED:
        yield f"undecided: {found.says}; {_certain(found, unit)}"
        return
    yield f"{found.verdict}: {found.says}, {after}"
    if found.verdict == RESTS:
        yield f"time {short(found.time)}{unit}"
    if found.verdict == COLLAPSES:
        low, high = shown(found.time)
        yield f"collapse time in [{low}, {high}]{unit}"
        low, high = shown(found.angle)
        if found.wall is None:
            yield f"ball {found.members[0]} is in the middle; final -cos θ in [{low}, {high}]"
        else:
            one, other = found.members
            what = f"the cosine between its normal and the direction of ball {other}"
            yield f"ball {one} is at the wall; at the end {what} is in [{low}, {high}]"
    if found.place:
        rows = ["[{}, {}]".format(*shown(e)) if found.angle else short(e) for e in found.place]
        yield f"ball {found.members[0]} is then at {' x '.join(rows)}"


def _collisions(count: int) -> str:
    return f"{count} collision{'' if count == 1 else 's'}"


def _certain(found: Ending, unit: str) -> str:
    """How many collisions are certain, and when the last of them was."""
    impacts = list(found.impacts())
    last = f", the last at the time {short(impacts[-1].time)}{unit}" if impacts else ""
    return f"certain: {_collisions(len(impacts))}{last}"


def origin_lines(found: Ending, certificate: str) -> Iterator[str]:
    """Who says so: ``certificate`` tells of that of the three, if one was asked for."""
    if found.verdict == UNDECIDED:
        return
    if certificate:
        yield certificate
    given = f"given {_theorem(found)}; " if found.verdict == COLLAPSES else ""
    yield f"{given}judged by {FLINT}; {COMPUTED}"


def _theorem(found: Ending) -> str:
    """On which theorem a collapse rests."""
    if found.wall is None:
        return f"certificates/{found.why}"
    return "the theorem on a ball at a wall (docs/explanation/wall.md), which has no certificate"


def many_document(found: Ending, certificate: str | None) -> dict[str, Any]:
    """The same as JSON; ``certificate`` is the folder with that of the three, if there is one."""
    is_open = found.verdict == UNDECIDED
    return {
        "format": FORMAT,
        "command": "scene",
        "verdict": found.verdict,
        "judged_by": None if is_open else FLINT,
        "cites": [found.why] if found.verdict == COLLAPSES and found.wall is None else [],
        "reason": found.why,
        "says": found.says,
        "balls": found.system.number,
        "members": list(found.members),
        "wall": found.wall,
        "collisions": len(found.contacts),
        "time": None if found.time is None or is_open else outward(found.time),
        "event_time": outward(found.time) if is_open and found.time is not None else None,
        "neg_cos_theta": None if found.angle is None else outward(found.angle),
        "place": [outward(ends) for ends in found.place],
        "certified": None if certificate is None else {
            "certificate": certificate,
            "since": str(found.since),
            "says": "a scene of the three at that time, seen from the first, whose numbers are "
            "decimals near the true ones",
        },
        "computed": COMPUTED,
        **{name: text for name, text in found.system.labels._asdict().items() if text},
        "impacts": [
            {"pair": one.pair, "time": outward(one.time), "normal_speed": outward(one.speed)}
            for one in found.impacts()
        ],
    }  # fmt: skip


def event_rows(found: Ending) -> Iterator[Sequence[str]]:
    """A head, and a line for each collision."""
    yield "collision", "pair", "time_low", "time_high", "normal_speed_low", "normal_speed_high"
    for n, one in enumerate(found.impacts(), 1):
        yield str(n), one.pair, *outward(one.time, DIGITS), *outward(one.speed, DIGITS)


def scene_text(scene: Scene, title: str) -> str:
    """A scene of three as a file."""
    rows = {"masses": scene.bodies.masses, "radii": scene.bodies.radii}
    names = ("01", "02", "12")
    if scene.restitutions is None:
        first = f'r = "{_exactly(scene.r)}"'
    else:
        pairs = zip(names, scene.restitutions, strict=True)
        each = ", ".join(f'"{name}" = "{_exactly(r)}"' for name, r in pairs)
        first = f"restitution = {{{each}}}"
    lines = [f'title = "{title}"', first, *(f"{key} = {_list(row)}" for key, row in rows.items())]
    for key in ("positions", "velocities"):
        each = ",\n  ".join(_list(row) for row in getattr(scene, key))
        lines.append(f"{key} = [\n  {each},\n]")
    return "\n".join(lines) + "\n"


def _list(row: Sequence[Fraction]) -> str:
    return "[" + ", ".join(f'"{_exactly(value)}"' for value in row) + "]"


def _exactly(value: Fraction) -> str:
    """A rational as the reader of scenes reads it: a decimal if that is exact."""
    fraction = str(value)
    mantissa, exponent = round_decimal(value, max(20, len(fraction)), up=False)
    is_exact = mantissa * Fraction(10) ** exponent == value
    return decimal_text(mantissa, exponent) if is_exact else fraction
