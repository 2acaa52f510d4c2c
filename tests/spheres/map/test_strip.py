"""Strips along the border: all tiles are decided, points beside the strip behave accordingly."""

from __future__ import annotations

import json
import random
from fractions import Fraction
from pathlib import Path

import pytest

from tests.spheres.map.map_simulation import fate
from verify import check_map
from verify.spheres.map.boxes import verdicts
from verify.spheres.map.curve import strip_along
from verify.spheres.map.grow import Target, grow
from verify.spheres.map.log import Progress, all_keys, plane_document
from verify.spheres.map.planes import Phi
from verify.spheres.map.strip import BorderStrip
from verify.spheres.map.workers import workers
from verify.views.map import tile_corners

ONE = Fraction(1)
DELTA = Fraction(1, 1000)
PLANE = Phi(Fraction(3, 100), ONE, x=(Fraction(1, 10), Fraction(3, 20)))
#: Points of the border, by bisection.
BORDER = {
    "0.02": "0.09560557161697",
    "0.083": "0.05828567595941",
    "0.15": "0.03192164647110",
    "0.31": "0.00402940596413",
}


@pytest.fixture(scope="module")
def strip() -> BorderStrip:
    return strip_along(PLANE, DELTA, 3, 3)


@pytest.fixture(scope="module")
def log(strip: BorderStrip) -> tuple[Progress, list[bytes]]:
    progress = Progress(strip)
    lines = [progress.header]
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(0), 10**6, 12), staff, lines.append):
            pass
    return progress, lines


def test_all_tiles_are_decided(log: tuple[Progress, list[bytes]]) -> None:
    progress, lines = log
    assert not progress.due
    plane, areas = check_map.check_log(iter(lines))
    assert areas.is_strip
    assert areas.collapses == progress.share("c")
    assert areas.disperses == progress.share("d")
    assert areas.boxes == progress.boxes
    assert areas.proved == sum(1 for _ in progress.decided())
    # What is left is just the strip.
    assert 1 - areas.collapses - areas.disperses == 2 * DELTA / (PLANE.y[1] - PLANE.y[0])
    assert "every such state" in check_map.says(plane, areas)


def height(strip: BorderStrip, phi_1: Fraction) -> Fraction:
    part = (strip.x[1] - strip.x[0]) / len(strip.curve)
    place = min(int((phi_1 - strip.x[0]) / part), len(strip.curve) - 1)
    t = phi_1 - strip.x[0] - part * (place + ONE / 2)
    c_0, c_1, c_2 = strip.curve[place]
    return c_0 + c_1 * t + c_2 * t * t


def test_points_beside_the_strip(strip: BorderStrip, log: tuple[Progress, list[bytes]]) -> None:
    rng = random.Random(1)
    assert not log[0].due
    for _ in range(25):
        phi_1 = strip.x[0] + (strip.x[1] - strip.x[0]) * Fraction(rng.random())
        beside = DELTA * (1 + Fraction(rng.choice((0.0, 1e-10, rng.random()))))
        f = height(strip, phi_1)
        assert fate(PLANE, phi_1, f + beside) == "d"
        assert fate(PLANE, phi_1, f - beside) == "c"


def test_the_checker_reads_the_same_tiles(strip: BorderStrip) -> None:
    plane = check_map.plane_of(plane_document(strip))
    keys = [*all_keys(3), "012301", "333333", "000000", "321012"]
    for key in keys:
        assert check_map.share_of(plane, key) == strip.share(key)
    whole = sum(strip.share(key) for key in all_keys(3))
    assert whole == 1 - 2 * DELTA / (PLANE.y[1] - PLANE.y[0])
    children = sum(strip.share("0123" + digit) for digit in "0123")
    assert children == strip.share("0123")


def test_corners_of_tiles_lie_at_their_distance_from_the_curve(strip: BorderStrip) -> None:
    gaps = []
    for key in [*all_keys(3), "012301", "321012"]:
        corners = strip.corners(key)
        assert {x >= strip.x[0] for x, _ in corners} == {x <= strip.x[1] for x, _ in corners}
        row = int("".join("01"[int(digit) >> 1] for digit in key), 2) >> len(key) - 3
        for x, gap in corners:
            assert gap >= strip.delta if strip.is_above(row) else gap <= -strip.delta
            assert strip.y[0] <= height(strip, x) + gap or x in (strip.x[0], strip.x[1])
            gaps.append(gap)
        # Drawn, it stays on its side of the middle, within the square.
        drawn = [y for _, y in tile_corners(strip, key)]
        assert all(0.5 <= y <= 1 if strip.is_above(row) else 0 <= y <= 0.5 for y in drawn)
    assert min(map(abs, gaps)) == strip.delta


def test_a_tile_across_the_border_has_no_verdict(strip: BorderStrip) -> None:
    """A curve that is too low has collapsing states above it."""
    low = tuple((c_0 - 4 * DELTA, c_1, c_2) for c_0, c_1, c_2 in strip.curve)
    lower = strip._replace(curve=low)
    keys = [key for key in all_keys(3) if lower.share(key)]
    letters = dict(zip(keys, verdicts(lower, keys).letters, strict=True))
    assert "u" in letters.values()
    progress = Progress(lower)
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(0), 10**6, 4), staff, len):
            pass
    assert progress.due
    assert progress.undecided > 2 * DELTA / (PLANE.y[1] - PLANE.y[0])


def test_malformed_strips(log: tuple[Progress, list[bytes]]) -> None:
    header = json.loads(log[1][0])["plane"]
    changes = {
        "below": ["0", "1/2"],
        "above": ["0", "1/2", "1/3", "1"],
        "curve": header["curve"][1:],
        "delta": "1/2",
        "y": ["1/100", "1/4"],
        "name": "strips",
    }
    check_map.plane_of(header)
    for name, value in changes.items():
        with pytest.raises(check_map.LogError):
            check_map.plane_of(header | {name: value})


def test_a_verdict_of_the_wrong_side(log: tuple[Progress, list[bytes]], tmp_path: Path) -> None:
    """The log of a strip with another δ is another claim, and its proofs do not fit."""
    from tests.check.test_check_map import sealed

    content = [json.loads(line) for line in log[1]]
    content[0]["plane"]["curve"] = [
        [str(Fraction(c_0) + 6 * DELTA), c_1, c_2] for c_0, c_1, c_2 in content[0]["plane"]["curve"]
    ]
    (tmp_path / "log").write_bytes(b"".join(sealed(content)))
    assert check_map.main([str(tmp_path / "log")]) == 1


def test_points_very_near_the_border() -> None:
    """Tiny boxes at a distance of 10^-10 from the curve, on either side."""
    near, size = Fraction(1, 10**10), Fraction(1, 10**14)
    for x, y in BORDER.items():
        for sign, letter in ((-1, "c"), (1, "d")):
            phi_1, phi_2 = Fraction(x), Fraction(y) + sign * near
            box = PLANE._replace(x=(phi_1, phi_1 + size), y=(phi_2, phi_2 + size))
            assert verdicts(box, ["0"]).letters == letter
            assert fate(PLANE, phi_1, phi_2) == letter
