"""Scenes by hand: the behaviours there are, and what is hard about them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from verify.spheres.scene.scene import Scene

Rows = Sequence[Sequence[int | str | Fraction]]
REST = (0, 0)


def scene(r: str, positions: Rows, velocities: Rows) -> Scene:
    """A scene from numbers as people write them."""
    x, v = (tuple(tuple(map(Fraction, row)) for row in rows) for rows in (positions, velocities))
    return Scene(Fraction(r), x, v)


def straight(r: str) -> Scene:
    """Nearly on a line."""
    places = (REST, ("1.001", 0), ("-1.002", "0.001"))
    return scene(r, places, (REST, (-1, 0), (1, "0.001")))


def on_a_line(r: str) -> Scene:
    """Two particles run into a third one between them, on a line."""
    return scene(r, (REST, (2, 0), ("-5/2", 0)), (REST, (-1, 0), (1, 0)))


def aligned(scale: str = "1", places: tuple[str, str] = ("1.002", "0.08")) -> Scene:
    """A collapse, with velocities times a number."""
    k = Fraction(scale)
    velocities = ((Fraction("-1.4") * k, 0), (Fraction("0.7") * k, Fraction("-0.1") * k))
    return scene("0.03", (REST, (places[0], 0), ("-1.006", places[1])), (REST, *velocities))


def at_angle(C: float, kappa: str) -> Scene:
    """r = 1/100, 0 and 1 just met, 2 is near and comes with the speed 10^-100; -cos is about C."""
    t = Fraction(math.sqrt((1 + C) / (1 - C))).limit_denominator(1000)
    c, s, y = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t), Fraction(1, 10**100)
    reach = 1 + Fraction(kappa) * y * y
    velocities = (REST, (y / 10, 1), (-y * c - s, -y * s + c))
    return scene("1/100", (REST, (1, 0), (reach * c, reach * s)), velocities)


def passing(height: str) -> Scene:
    """1 passes 0 at some height, 2 is far away."""
    return scene("0.03", (REST, (-3, height), (5, 5)), (REST, (1, 0), REST))


def touching(second: Sequence[int | str], v_1: Rows, v_2: Sequence[int | str] = (1, 0)) -> Scene:
    """0 and 1 in contact, 2 on the other side."""
    return scene("0.03", (REST, (1, 0), second), (REST, *v_1, v_2))


FAR, NEAR = (-3, 0), ("-1.01", "0.01")
ORE = "0.000000000000000000000000000000000000000001"
DIGITS = ("1.002" + "3" * 197, "0.08" + "1" * 198)
RAY = scene("4/95", (REST, (1, 0), (-2, 0)), (REST, ("8/19", 0), (1, 0)))

#: A scene with its verdict, the number of collisions followed, and the name of the reason.
CASES: dict[str, tuple[Scene, str, int, str]] = {
    "aligned": (aligned(), "collapses", 2, "sharper"),
    "faster-by-1e100": (aligned("1e100"), "collapses", 2, "sharper"),
    "slower-by-1e100": (aligned("1e-100"), "collapses", 2, "sharper"),
    "200-digits": (aligned(places=DIGITS), "collapses", 2, "sharper"),
    "exact-symmetry": (
        scene("0.03", (REST, (2, 0), (-2, 0)), (REST, (-1, 0), (1, 0))),
        "undecided",
        0,
        "triple-contact",
    ),
    "grazing": (passing("1"), "undecided", 0, "grazing"),
    "nearly-grazing-below": (passing(f"{1 - Fraction(ORE)}"), "disperses", 1, "apart"),
    "nearly-grazing-above": (passing(f"{1 + Fraction(ORE)}"), "disperses", 0, "apart"),
    "contact-approaching": (touching(NEAR, [(-1, 0)]), "collapses", 2, "sharper"),
    "contact-separating": (touching(NEAR, [("0.1", 0)]), "collapses", 1, "sharper"),
    "contact-tangential": (touching(NEAR, [(0, "0.3")]), "collapses", 1, "sharper"),
    "contact-resting": (touching(FAR, [(0, 0)], (-1, 0)), "disperses", 0, "apart"),
    "contact-resting-hit": (touching(FAR, [(0, 0)]), "undecided", 0, "triple-contact"),
    "two-contacts": (touching((-1, 0), [(-1, 0)]), "undecided", 0, "triple-contact"),
    "contact-and-collision-at-once": (
        touching((-1, 0), [(-1, 0)], (-1, 0)),
        "disperses",
        1,
        "apart",
    ),
    "all-at-rest": (scene("0.03", (REST, (2, 0), (0, 2)), (REST,) * 3), "disperses", 0, "apart"),
    "never-meet": (
        scene("0.05", (REST, (2, 0), (1, -3)), ((-1, 0), (1, 0), (0, 1))),
        "disperses",
        0,
        "apart",
    ),
    "another-order-first": (
        scene(
            "0.01",
            ((0, 0, 0), ("1.2", "0.1", "0.05"), ("2.5", 0, "0.1")),
            ((1, "0.02", 0), (0, 0, "0.01"), ("-0.8", "0.05", 0)),
        ),
        "collapses",
        2,
        "sharper",
    ),
    "speeds-100-to-1": (
        scene("0.03", (REST, ("1.001", 0), ("-1.0001", "0.01")), (REST, (-1, 1), (1, "0.01"))),
        "collapses",
        1,
        "sharper",
    ),
    "doubles-show-a-collapse": (on_a_line("0.072"), "disperses", 64, "apart"),
    "below-9-4√5": (straight("0.0557"), "collapses", 3, "sandwich"),
    "above-9-4√5": (straight("0.0558"), "finite", 1000, "momentum"),
    "without-angular-momentum": (
        scene("0.0558", (REST, ("1.001", "0.001"), ("-1.002", "0.001")), (REST, (-1, 0), (1, 0))),
        "undecided",
        1000,
        "budget",
    ),
    "below-7-4√3": (straight("0.0717967"), "disperses", 23, "apart"),
    "above-7-4√3": (straight("0.0717968"), "disperses", 23, "apart"),
    "threshold-0.42": (at_angle(0.42, "1e-7"), "disperses", 10, "apart"),
    "threshold-0.46": (at_angle(0.46, "1e-7"), "disperses", 18, "apart"),
    "threshold-0.49": (at_angle(0.49, "1e-7"), "disperses", 37, "apart"),
    "threshold-0.51": (at_angle(0.51, "1e-7"), "disperses", 108, "apart"),
    "a-thousand-on-a-line": (on_a_line("0.0717968"), "finite", 1000, "restitution"),
    "the-ray": (RAY, "undecided", 200, "for-ever"),
}
