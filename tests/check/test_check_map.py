"""The checker of maps: what it accepts is proved, and a changed log is refused."""

from __future__ import annotations

import ast
import json
import random
import sys
from collections.abc import Callable
from fractions import Fraction
from hashlib import sha256
from math import sqrt
from pathlib import Path
from typing import Any

import pytest

from verify import check_map
from verify.check_map import LogError, RefusedError

ROOT = Path(__file__).parents[2]
CHECKER = ROOT / "verify" / "check_map.py"
LOG = ROOT / "certificates" / "map" / "map.jsonl"
STRIP = ROOT / "certificates" / "map" / "strip" / "map.jsonl"
Lines = list[dict[str, Any]]


def lines(count: int) -> Lines:
    """The beginning of the committed log."""
    return [json.loads(line) for line in LOG.read_bytes().splitlines()[:count]]


def sealed(content: Lines) -> list[bytes]:
    """With digests that fit: whoever changes a log can calculate them too."""
    chain, found = "", []
    for line in content:
        body = json.dumps(line | {"sha256": None}, separators=(",", ":")).encode()[:-15]
        chain = sha256(chain.encode() + body).hexdigest()
        found.append(body + f',"sha256":"{chain}"}}\n'.encode())
    return found


def check(found: list[bytes]) -> check_map.Areas:
    return check_map.check_log(iter(found))[1]


def test_the_committed_map_is_proved() -> None:
    with LOG.open("rb") as file:
        plane, areas = check_map.check_log(file)
    document = json.loads((LOG.parent / "map.json").read_text(encoding="utf-8"))
    assert plane.r == Fraction(3, 100)
    assert areas.boxes == document["boxes"] >= 10**4
    assert str(areas.collapses) == document["areas"]["collapses"]
    assert str(areas.disperses) == document["areas"]["disperses"]
    rest = 1 - areas.collapses - areas.disperses
    assert str(rest) == document["areas"]["undecided"]
    assert rest < Fraction(1, 200)
    assert LOG.stat().st_size < 10**6


def test_a_beginning_of_a_log_is_a_log() -> None:
    found = check(sealed(lines(4)))
    assert found.boxes == sum(len(line["verdicts"]) for line in lines(4)[1:])
    assert found.collapses + found.disperses < 1


def changed(change: Callable[[Lines], object]) -> list[bytes]:
    content = lines(4)
    change(content)
    return sealed(content)


def first(content: Lines, letter: str) -> tuple[int, int]:
    for place, line in enumerate(content[1:], 1):
        if letter in line["verdicts"]:
            return place, line["verdicts"].index(letter)
    raise AssertionError(letter)


def with_letter(content: Lines, old: str, new: str) -> None:
    place, at = first(content, old)
    letters = content[place]["verdicts"]
    content[place]["verdicts"] = letters[:at] + new + letters[at + 1 :]
    if old == "c":
        del content[place]["numbers"][0]
    if new == "c":
        content[place]["numbers"].insert(
            letters[:at].count("c"), [25193416, 438582174, 4204233, 44262473, 12592029, 2163065221]
        )


@pytest.mark.parametrize(("old", "new"), ["cd", "dc", "uc", "ud"])
def test_one_verdict_changed(old: str, new: str) -> None:
    content = lines(4)
    with_letter(content, old, new)
    with pytest.raises((RefusedError, LogError)):
        check(sealed(content))
    with pytest.raises(LogError):
        check(sealed(lines(3)) + sealed(content)[3:])


@pytest.mark.parametrize("place", range(6))
def test_one_number_changed_to_one_that_proves_nothing(place: int) -> None:
    rng = random.Random(place)
    for factor in (0, 2 if place > 1 else 3):
        content = lines(4)
        numbers = rng.choice([n for line in content[1:] for n in line["numbers"]])
        numbers[place] = factor * numbers[place]
        # Wider bounds may do as well, narrower ones do not.
        if factor == 0 or place < 2:
            with pytest.raises(RefusedError):
                check(sealed(content))


KEYS: dict[str, Callable[[Lines], object]] = {
    "changed": lambda c: c[2].update(keys="1" + c[2]["keys"][1:]),
    "no-verdict": lambda c: c[2].update(verdicts=c[2]["verdicts"].replace("u", "q", 1)),
    "of-another-level": lambda c: c[2].update(level=6),
    "swapped": lambda c: c[2].update(keys=" ".join(reversed(c[2]["keys"].split(" ")))),
    "twice": lambda c: c.insert(2, c[2]),
    "left-out": lambda c: c.pop(2),
    "none": lambda c: c[2].update(keys="", verdicts="", numbers=[]),
    "no-digit": lambda c: c[2].update(keys="4" + c[2]["keys"][1:]),
    "one-verdict-too-few": lambda c: c[2].update(verdicts=c[2]["verdicts"][1:]),
    "numbers-of-nobody": lambda c: c[2]["numbers"].append([1] * 6),
    "five-numbers": lambda c: c[2]["numbers"][0].pop(),
    "negative": lambda c: c[2]["numbers"][0].__setitem__(0, -1),
    "no-number": lambda c: c[2]["numbers"][0].__setitem__(0, "1"),
    "truth": lambda c: c[2]["numbers"][0].__setitem__(0, True),
    "a-float": lambda c: c[2]["numbers"][0].__setitem__(0, 1.5),
    "another-format": lambda c: c[0].update(format="verify-map-log/2"),
    "r-negative": lambda c: c[0]["plane"].update(r="-1/2"),
    "no-rectangle": lambda c: c[0]["plane"].update(x=["1/2", "0"]),
    "divided-by-0": lambda c: c[0]["plane"].update(r="1/0"),
    "long-number": lambda c: c[0]["plane"].update(r="0." + "1" * 99),
    "no-level": lambda c: c[0].update(first_level=0),
    "no-code": lambda c: c[0].update(code="1"),
}


@pytest.mark.parametrize("name", KEYS)
def test_a_malformed_log(name: str) -> None:
    with pytest.raises(LogError):
        check(changed(KEYS[name]))


def test_the_chain_of_digests() -> None:
    good = sealed(lines(4))
    check(good)
    for place in range(4):
        for old, new in ((b'"', b"'"), (b"1", b"2"), (b"\n", b"")):
            bad = [*good]
            bad[place] = bad[place].replace(old, new, 1)
            with pytest.raises(LogError):
                check(bad)
    with pytest.raises(LogError):
        check([])


#: Each number of the plane, changed.
OTHER_PLANES: dict[str, Any] = {
    "r": "1/20",
    "neg_cos": "19/20",
    "speed": "1",
    "tangential": ["3", "1"],
    "x": ["0", "1"],
    "y": ["0", "1/2"],
}


@pytest.mark.parametrize("name", OTHER_PLANES)
def test_another_plane_is_another_claim(name: str) -> None:
    """The verdicts are not those of other parameters."""
    with pytest.raises(RefusedError):
        check(changed(lambda c: c[0]["plane"].update({name: OTHER_PLANES[name]})))


# --- a strip -------------------------------------------------------------------------------------


def test_the_committed_strip(monkeypatch: pytest.MonkeyPatch) -> None:
    """Here one tile of 16 is proved; CI has the checker prove them all."""
    prove, seen = check_map.prove_box, iter(range(10**6))
    monkeypatch.setattr(check_map, "prove_box", lambda *a: next(seen) % 16 or prove(*a))
    with STRIP.open("rb") as file:
        plane, areas = check_map.check_log(file)
    assert isinstance(plane, check_map.Strip)
    assert areas.is_strip
    assert next(seen) == areas.proved > 4000
    assert plane.delta == Fraction(1, 10**6)
    assert plane.phi.x == (Fraction(1, 100), Fraction(9, 25))
    # What is left is |φ2 - f| < δ alone.
    rest = 1 - areas.collapses - areas.disperses
    assert rest == 2 * plane.delta / plane.phi.y[1]


def test_a_tile_with_the_other_verdict() -> None:
    with STRIP.open("rb") as file:
        header, *records = map(json.loads, file)
    plane = check_map.plane_of(header["plane"])
    law, six = check_map.law_in(plane), check_map.sixes(records[0]["numbers"][0], "c")
    begin = check_map.beginning(law, plane)
    keys, letters = records[0]["keys"].split(" "), records[0]["verdicts"]
    for place in random.Random(1).sample([i for i, c in enumerate(letters) if c != "u"], 4):
        other, numbers = ("c", six) if letters[place] == "d" else ("d", [])
        with pytest.raises(RefusedError):
            check_map.prove_box(law, begin, keys[place], other, numbers)


def tiles(count: int = 96) -> Lines:
    """The first tiles of the strip, far below the curve: they collapse."""
    with STRIP.open("rb") as file:
        header, record = (json.loads(next(file)) for _ in range(2))
    letters = record["verdicts"][:count]
    keys = " ".join(record["keys"].split(" ")[:count])
    numbers = record["numbers"][: letters.count("c")]
    return [header, record | {"keys": keys, "verdicts": letters, "numbers": numbers}]


def in_plane(name: str, value: Callable[[Any], Any]) -> Callable[[Lines], object]:
    return lambda c: c[0]["plane"].update({name: value(c[0]["plane"][name])})


#: A strip with one thing changed.
STRIPS: dict[str, Callable[[Lines], object]] = {
    "disperses-for-collapses": lambda c: with_letter(c, "c", "d"),
    "a-number": lambda c: c[1]["numbers"][7].__setitem__(0, 0),
    "a-key": lambda c: c[1].update(keys="000001" + c[1]["keys"][6:]),
    "without-delta": in_plane("delta", lambda _: "0"),
    "delta-negative": in_plane("delta", lambda _: "-1/1000000"),
    "the-curve-higher": in_plane("curve", lambda c: [["1/5", b, a] for _, b, a in c]),
    "the-curve-shorter": in_plane("curve", lambda c: c[:-1]),
    "the-bands-with-a-gap": in_plane("above", lambda c: [*c[:1], c[2], c[2], *c[3:]]),
    "no-band-below": lambda c: c[0]["plane"].update(
        below=[], above=[str(i) for i in range(len(c[0]["plane"]["curve"]) + 2)]
    ),
    "the-bands-beyond": in_plane("above", lambda c: [*c[:-1], "2"]),
    "another-r": in_plane("r", lambda _: "1/20"),
    "another-interval": in_plane("x", lambda _: ["1/5", "2/5"]),
    "another-top": in_plane("y", lambda _: ["0", "1/1000"]),
    "another-kind": in_plane("name", lambda _: "phi"),
}


def test_the_first_tiles_are_proved() -> None:
    areas = check(sealed(tiles()))
    assert areas.proved == 96
    assert areas.collapses > areas.disperses == 0
    assert not areas.is_strip


@pytest.mark.parametrize("name", STRIPS)
def test_a_strip_with_one_thing_changed(name: str) -> None:
    content = tiles()
    STRIPS[name](content)
    with pytest.raises((RefusedError, LogError)):
        check(sealed(content))


def test_it_stands_alone_and_calculates_with_whole_numbers() -> None:
    tree = ast.parse(CHECKER.read_text(encoding="utf-8"))
    modules = {
        node.module if isinstance(node, ast.ImportFrom) else node.names[0].name
        for node in ast.walk(tree)
        if isinstance(node, ast.Import | ast.ImportFrom)
    }
    assert {str(module).partition(".")[0] for module in modules} <= {*sys.stdlib_module_names}
    assert not [n for n in ast.walk(tree) if isinstance(n, ast.Assert)]
    constants = [n.value for n in ast.walk(tree) if isinstance(n, ast.Constant)]
    assert not [value for value in constants if isinstance(value, float)]


# --- what it asks for ----------------------------------------------------------------------------


def closing(r: Fraction) -> bool:
    """At -cos θ = 1, very close to the larger fixed point p: whether the six numbers close.

    X is a little less than Y, and m a little more than p's partner r/p, so that every inequality
    has room, but perhaps d-room: for small speeds and small k it says m + X < (p - Y)².
    """
    half = (1 + r) / 2
    p = Fraction(int((half + sqrt(half**2 - 4 * r)) / 2 * 10**9), 10**9)
    m, Y = r / p, Fraction(1, 1000)
    X, k = Y * (1 + m / p) / 2, Fraction(1, 10**4)
    speed, tangential = Fraction(1, 10**6), Fraction(1, 10**3)
    law, side = check_map.law_of(r), (Fraction(0), Fraction(1))
    plane = check_map.Phi(r, Fraction(1), speed, (tangential, tangential), side, side)
    phi = (check_map.around(m), check_map.around(k / 2))
    state = check_map._at_contact(law.kind, plane)(*phi)
    numbers = (m, p, X, Y, k, 2 * tangential)
    return check_map.closes(law, state, tuple(map(check_map.around, numbers)))


def test_gaps_must_shrink_faster_than_squares_of_speeds() -> None:
    """Below 9-4√5 the numbers close; above it, where the fixed point is unstable, they do not."""
    stabi = 9 - 4 * sqrt(5)
    for r in (Fraction(1, 100), Fraction(3, 100), Fraction(11, 200)):
        assert r < stabi
        assert closing(r)
    for r in (Fraction(57, 1000), Fraction(3, 50), Fraction(7, 100)):
        assert r > stabi
        assert not closing(r)


def test_numbers_that_grow_without_end_are_refused() -> None:
    law, most = check_map.law_of(Fraction(1, 2)), (1 << check_map.MAX_BITS) - 1
    for huge, why in ((most + 1, "too large"), (most, "stay in contact")):
        state = check_map.Sight(*[(-huge, huge)] * len(check_map.Sight._fields))
        with pytest.raises(RefusedError, match=why):
            prove(law, [state], "d")


def prove(law: check_map.Law, states: list[check_map.Sight | None], verdict: str) -> None:
    check_map.prove(law, states, verdict, [], check_map.Work())


def test_a_branch_without_states_hides_no_other() -> None:
    law = check_map.law_of(Fraction(1, 2))
    none = check_map.Sight(*[(check_map.ONE, 0)] * len(check_map.Sight._fields))
    prove(law, [none], "c")
    with pytest.raises(RefusedError, match="no two spheres meet"):
        prove(law, [none, None], "c")
    wide = check_map.Sight(*[(-check_map.ONE, check_map.ONE)] * len(check_map.Sight._fields))
    for verdict in "cd":
        with pytest.raises(RefusedError, match="stay in contact"):
            prove(law, [wide, none], verdict)


def on_a_line(r: str, letter: str, speeds: list[str]) -> list[bytes]:
    """Two spheres run towards one between them; the velocity of one of them varies."""
    plane = {
        "name": "scene",
        "r": r,
        "positions": [["0", "0"], ["2", "0"], ["-2", "0"]],
        "velocities": [["0", "0"], ["-1", "0"], ["1", "0"]],
        "x_at": "velocities[2][0]",
        "y_at": "velocities[2][1]",
        "x": speeds,
        "y": ["-1/1000", "1/1000"],
    }
    header = {"format": "verify-map-log/1", "plane": plane, "first_level": 1, "code": 1}
    numbers = [[1] * 6] * 4 if letter == "c" else []
    boxes = {"level": 1, "keys": "0 1 2 3", "verdicts": letter * 4, "numbers": numbers}
    return sealed([header, boxes])


def test_what_ends_does_not_collapse_and_what_collapses_does_not_end() -> None:
    assert check(on_a_line("9/10", "d", ["11/10", "12/10"])).disperses == 1
    for r, letter, speeds in (
        ("9/10", "c", ["11/10", "12/10"]),
        ("1/100", "d", ["11/10", "12/10"]),
        ("9/10", "d", ["9/10", "11/10"]),
    ):
        with pytest.raises(RefusedError):
            check(on_a_line(r, letter, speeds))
