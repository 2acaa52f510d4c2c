"""What balls never decide, however precise: three spheres in contact at once, and a graze.

Where the numbers of all pairs are rational, the times of contact are compared exactly. Where they
are not, a scene that looks the same with two spheres exchanged still has both meet a third at once.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from verify.language.record import Record
from verify.prover import balls
from verify.spheres.flow.follow import Flow, pairs_now
from verify.spheres.flow.law import Number, Pair
from verify.spheres.scene.scene import Coordinates, Scene, pair_name

TRIPLE, GRAZING = "triple-contact", "grazing"
#: How each is told, without its time.
SAYS = {
    TRIPLE: "triple contact: {0} and {1} touch at once, and the law of collisions is about a pair",
    GRAZING: "grazing: {0} touch and neither approach nor part",
}


class Event(Record):
    """What happens exactly, of which pairs, and when: the time since the start."""

    name: str
    pairs: tuple[str, ...]
    time: Number


class Contact(Record):
    """When a pair is next in contact: -(p + √D)/m; as it collides, grazes or just touches."""

    pair: Pair
    time: Number
    collides: bool
    grazes: bool = False


def what_happens(flow: Flow) -> Event | None:
    """The next event, if it is certain that it is one of these two."""
    found = pairs_now(flow)
    start = balls.fmpq_of(Fraction(0)) if flow.now is None else flow.now.time
    event = _of_rationals(found) if all(map(_is_rational, found.values())) else None
    if event is None:
        event = _of_symmetry(flow, found)
    return None if event is None else event._replace(time=start + event.time)


def _is_rational(pair: Pair) -> bool:
    return all(balls.is_rational(value) for value in pair)


def _of_rationals(pairs: Mapping[str, Pair]) -> Event | None:
    contacts = {name: found for name, pair in pairs.items() if (found := contact(pair)) is not None}
    first = _first(contacts)
    if first is None:
        return None
    others = [name for name in contacts if name != first and _at_once(contacts, first, name)]
    if others:
        names = sorted((first, others[0]))
        return Event(TRIPLE, (names[0], names[1]), contacts[first].time)
    if contacts[first].grazes:
        return Event(GRAZING, (first,), contacts[first].time)
    return None


def contact(pair: Pair) -> Contact | None:
    """The next contact of a pair with rational numbers, or the one that there is now."""
    g, p, m = pair
    zero = balls.fmpq_of(Fraction(0))
    if g == 0:
        return Contact(pair, zero, collides=bool(p < 0))
    below = p * p - m * g
    if p >= 0 or below < 0:
        return None
    return Contact(pair, -(p + _root(below)) / m, below > 0, below == 0)


def _root(value: Any) -> Number:
    return value if value == 0 else balls.any_root(value)


def _first(contacts: Mapping[str, Contact]) -> str | None:
    """The first pair that collides or grazes; None where balls do not tell which one is."""
    for name, one in contacts.items():
        others = [other for other in contacts.values() if other is not one and _moves(other)]
        if _moves(one) and all(_is_no_later(one, other) for other in others):
            return name
    return None


def _moves(one: Contact) -> bool:
    return one.collides or one.grazes


def _is_no_later(one: Contact, other: Contact) -> bool:
    return bool(one.time <= other.time) or _same_time(one.pair, other.pair)


def _at_once(contacts: Mapping[str, Contact], first: str, name: str) -> bool:
    """Whether the pair is in contact when the first one collides or grazes."""
    one, other = contacts[first], contacts[name]
    if _moves(other):
        return bool(one.time == other.time) or _same_time(one.pair, other.pair)
    rests = other.pair.p == 0 and other.pair.m == 0
    return rests or bool(one.time == 0)


def _same_time(one: Pair, other: Pair) -> bool:
    """True only if both quadratics have the same smaller root."""
    if not (one.m > 0 and other.m > 0):
        return False
    half = one.p / one.m - other.p / other.m
    rest = one.g / one.m - other.g / other.m
    if half == 0:
        return bool(rest == 0)
    time = -rest / (2 * half)
    is_root = one.m * time * time + 2 * one.p * time + one.g == 0
    return bool(is_root and time * one.m <= -one.p and time * other.m <= -other.p)


# --- symmetry ------------------------------------------------------------------------------------


def _of_symmetry(flow: Flow, pairs: Mapping[str, Pair]) -> Event | None:
    """Two spheres that behave alike meet the third one at the same time."""
    given = Coordinates(flow.scene.positions, flow.scene.velocities)
    for o, s, c in ((0, 1, 2), (1, 0, 2), (2, 0, 1)):
        if not (_are_alike(flow.scene, s, c) and is_symmetric(given, (o, s, c))):
            continue
        names = (pair_name(o, s), pair_name(o, c))
        g, p, m = pairs[names[0]]
        between = pairs[pair_name(s, c)]
        below = p * p - m * g
        if p < 0 and below > 0:
            time = -(p + balls.any_root(below)) / m
            if _is_apart(between, time):
                return Event(TRIPLE, names, time)
    return None


def _are_alike(scene: Scene, s: int, c: int) -> bool:
    """Whether two spheres have the same mass and radius."""
    bodies = scene.bodies
    return bodies is None or all(row[s] == row[c] for row in bodies)


def _is_apart(pair: Pair, time: Number) -> bool:
    """True only if the pair is apart until then, or parts, or passes by."""
    g, p, m = pair
    return bool(p >= 0) or bool(p * p < m * g) or bool(g + 2 * p * time > 0)


def is_symmetric(given: Coordinates, frame: tuple[int, int, int]) -> bool:
    """Whether positions and velocities look the same from o with s and c exchanged.

    Up to an isometry.
    """
    o, s, c = frame

    def keep(_: str, value: Number) -> Number:
        return value

    one, two = given.state((o, s, c), keep), given.state((o, c, s), keep)
    return one == two
