"""Speed against error, from the committed measurements."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from math import ceil, floor, log10
from typing import Any

from verify.language.record import Record
from verify.prover.decimals import round_decimal
from verify.views.plots.shapes import Curve, Figure, Panel, Scale, powers

_DECIMAL = re.compile(r"[0-9]{1,40}(\.[0-9]{1,40})?(e[+-]?[0-9]{1,5})?")


class Measured(Record):
    """One run of one engine: its precision, its time in milliseconds, its relative width."""

    bits: str
    milliseconds: Fraction
    width: Fraction


def points(table: Mapping[str, Any]) -> dict[str, list[Measured]]:
    """The measurements of each engine: its columns are ``<engine>: ms`` and ``<engine>: width``."""
    columns = list(table["columns"])
    engines = [name.removesuffix(": ms") for name in columns if name.endswith(": ms")]
    found: dict[str, list[Measured]] = {}
    for engine in engines:
        if f"{engine}: width" not in columns:
            continue
        places = [columns.index(f"{engine}: {what}") for what in ("ms", "width")]
        for row in table["rows"]:
            time, width = (_number(str(row[place])) for place in places)
            if time is not None and width is not None and time > 0 and width > 0:
                found.setdefault(engine, []).append(Measured(str(row[0]), time, width))
    return found


def _number(text: str) -> Fraction | None:
    """A decimal of bounded size; None for what was not measured."""
    return Fraction(text) if _DECIMAL.fullmatch(text) else None


def figure(table: Mapping[str, Any]) -> Figure | None:
    """The plot, or nothing where the table has no such columns."""
    engines = points(table)
    if not engines:
        return None
    count = sum(map(len, engines.values()))
    return Figure(
        "speed",
        "Speed against error",
        f"{table['title']}. Each of the {count} points is a measured time (a median; lower is "
        f"faster) and a rigorous bound: the largest relative width of an enclosure, the same "
        f"work at several precisions (smaller, to the right, is sharper). Only the times depend "
        f"on the machine.",
        (_panel(engines),),
    )


def _panel(engines: dict[str, list[Measured]]) -> Panel:
    runs = [run for found in engines.values() for run in found]
    times = [log10(float(run.milliseconds)) for run in runs]
    digits = [log10(_digits(run.width)) for run in runs]
    x, y = (floor(min(digits)), ceil(max(digits))), (floor(min(times)), ceil(max(times)))
    return Panel(
        "",
        Scale("correct digits of the widest enclosure", *_ends(x), powers(*x), logarithmic=True),
        Scale("milliseconds", *_ends(y), powers(*y), logarithmic=True),
        lambda: _curves(engines),
        f"Time against digits for {', '.join(engines)}: the time grows with the digits.",
        480,
        400,
    )


def _ends(exponents: tuple[int, int]) -> tuple[float, float]:
    low, high = exponents
    return 10.0**low, 10.0 ** max(high, low + 1)


def _curves(engines: dict[str, list[Measured]]) -> Iterator[Curve]:
    for index, (engine, runs) in enumerate(engines.items()):
        points = [(_digits(run.width), float(run.milliseconds)) for run in runs]
        yield Curve(points, f"series-{1 + index % 7}", index, engine)


def _digits(width: Fraction) -> float:
    """-log10 of a width that may be far below the smallest double."""
    mantissa, exponent = round_decimal(width, 3, up=True)
    return max(0.1, -(log10(mantissa) + exponent))
