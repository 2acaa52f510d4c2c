"""What is decided of the boxes of maps, in numpy and compiled: CPU time, and the same log.

``python -m tests.measure.benchmarks.maps`` prints a table; the exit code is 1 where compiling gains
less than `LEAST` on the first map, which is large enough not to be the start of a process. A law is
one application of the collision law to one box.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from fractions import Fraction
from hashlib import sha256
from math import inf
from pathlib import Path
from time import process_time
from typing import Any

from verify.spheres.map import branches
from verify.spheres.map.axes import axis_in, plane_in
from verify.spheres.map.curve import strip_along
from verify.spheres.map.elementwise import clock
from verify.spheres.map.grow import Target, grow
from verify.spheres.map.log import Progress
from verify.spheres.map.planes import Phi, Plane
from verify.spheres.map.strip import BorderStrip
from verify.spheres.map.workers import workers

SCENES = Path(__file__).parents[3] / "certificates" / "scenes"
LEAST = 2
BENT = Phi(Fraction(1, 20), Fraction(97, 100), tangential=(Fraction(1), Fraction(-1)))
STRAIGHT = Phi(Fraction(3, 100), Fraction(1), x=(Fraction(1, 100), Fraction(9, 25)))


def through(scene: str, *axes: str) -> Plane:
    """A plane through the scene of a file."""
    found = [axis_in(f"--{name}", axis) for name, axis in zip("xy", axes, strict=False)]
    return plane_in(scene, (SCENES / scene).read_bytes(), found, {})


#: Maps, and where they end: at an undecided share, or at so many boxes.
MAPS: dict[str, tuple[Callable[[], Plane | BorderStrip], Fraction, int]] = {
    "phi, r = 0.05, bent": (lambda: BENT, Fraction(0), 30000),
    "phi, r = 0.03": (lambda: STRAIGHT, Fraction(3, 10000), 10**6),
    "strip 1e-7": (lambda: strip_along(STRAIGHT, Fraction(1, 10**7), 6, 16), Fraction(0), 10**6),
    "two velocities": (
        lambda: through(
            "nearly-aligned.toml", "velocities[2][0]=-1.5..0", "velocities[2][1]=-1..1"
        ),
        Fraction(0),
        9000,
    ),
    "r and a velocity": (
        lambda: through("nearly-aligned.toml", "r=0.01..0.08", "velocities[2][1]=-1..1"),
        Fraction(0),
        2500,
    ),
    "r on a line": (
        lambda: through("on-a-line.toml", "r=0.05..0.08"),
        Fraction(1, 10**6),
        10**6,
    ),
}


def run(name: str, wait: float) -> tuple[float, int, int, str]:
    """CPU seconds, boxes, laws, and the digest of the log."""
    make, share, boxes = MAPS[name]
    clock.wait, laws, law = wait, 0, branches._after

    def counted(*given: Any, chosen: Any) -> Any:
        nonlocal laws
        laws += len(chosen)
        return law(*given, chosen=chosen)

    branches._after = counted  # type: ignore[assignment]
    before = process_time()
    progress = Progress(make())
    log = sha256(progress.header)
    with workers(1, None) as staff:
        for _ in grow(progress, Target(share, boxes, 26), staff, log.update):
            pass
    seconds = process_time() - before
    branches._after = law
    return seconds, progress.boxes, laws, log.hexdigest()


def main() -> int:
    """Print the table."""
    import verify.spheres.map.kernel  # noqa: F401  # an error where the extra is not installed

    print("map                      boxes      laws  µs a box: numpy  compiled  gain  ns a law")
    gains = []
    for name in MAPS:
        run(name, 0.0)  # afterwards all is compiled
        seconds, boxes, laws, digest = run(name, 0.0)
        in_numpy, *_, expected = run(name, inf)
        assert digest == expected, name
        gains.append(in_numpy / seconds)
        each = [1e6 * in_numpy / boxes, 1e6 * seconds / boxes, gains[-1], 1e9 * seconds / laws]
        row = "{:16.1f} {:9.1f} {:5.1f} {:9.0f}".format(*each)
        print(f"{name:20} {boxes:9} {laws:9} {row}")
    return int(gains[0] < LEAST)


if __name__ == "__main__":
    sys.exit(main())
