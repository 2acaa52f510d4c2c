"""What is compiled gives the numbers of numpy, and maps of every kind the same bytes."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import product
from math import inf, nan
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tests.spheres.map.test_boxes import PLANES
from tests.spheres.map.test_families import DIAGRAM, plane_of
from verify.spheres.flow.law import Pair, State
from verify.spheres.map import branches, closing, elementwise
from verify.spheres.map.curve import strip_along
from verify.spheres.map.elementwise import Elementwise, Repeated, chosen_of, clock, leaves
from verify.spheres.map.grow import Target, grow
from verify.spheres.map.intervals import Intervals, enclosed
from verify.spheres.map.log import Progress
from verify.spheres.map.models import Models, from_bounds, parameter
from verify.spheres.map.planes import Phi, Plane
from verify.spheres.map.strip import BorderStrip
from verify.spheres.map.workers import workers

kernel = pytest.importorskip("verify.spheres.map.kernel", exc_type=ImportError)

LINE = Path("certificates/scenes/on-a-line.toml")
#: Doubles with which operations do something special.
SPECIAL = (
    *(
        0.0,
        -0.0,
        5e-324,
        -5e-324,
        2.0**-1022,
        -(2.0**-1022),
        1.0,
        -1.0,
        1 + 2.0**-52,
        1e154,
        1e-160,
    ),
    *(1.7976931348623157e308, -1.7976931348623157e308, inf, -inf, nan),
)
PAIRS = np.array([*product(SPECIAL, repeat=2)]).T


@pytest.fixture
def compiled(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clock, "wait", 0.0)


def is_same(found: Any, expected: Any) -> bool:
    """Whether arrays are equal, where NaN is equal to NaN; one number may be that of all boxes."""
    pairs = [*zip(leaves(found), leaves(expected), strict=True)]
    return all(
        (x.shape == y.shape or not y.ndim)
        and x.dtype == y.dtype
        and bool(((x == y) | ((x != x) & (y != y))).all())
        for x, y in pairs
    )


# --- single operations ---------------------------------------------------------------------------

OPERATIONS: dict[str, Callable[[Any, Any], Any]] = {
    **{
        name: getattr(np, name)
        for name in (
            *("add", "subtract", "multiply", "divide", "minimum", "maximum", "fmin", "fmax"),
            *("less", "less_equal", "greater", "greater_equal"),
        )
    },
    "up": lambda x, _: np.nextafter(x, inf),
    "down": lambda x, _: np.nextafter(x, -inf),
    **{
        name: lambda x, _, name=name: getattr(np, name)(x)
        for name in ("sqrt", "absolute", "rint", "ceil", "negative")
    },
    "where": lambda x, y: np.where((x < y) & ~(x < 1) | (y > 2), x, 3.0),
    "where of truths": lambda x, y: np.where(x < y, x < 1, y < 1),
    "matrix": lambda x, y: np.add.reduce(np.abs(np.stack([x, y, x * y])[1:]) * y),
    "constants": lambda x, _: x * 0.1 + -0.0 - 5e-324,
    "full": lambda x, _: np.full_like(x, -0.75) + np.zeros_like(x),
}


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("name", OPERATIONS)
def test_an_operation_on_special_numbers(name: str) -> None:
    function = OPERATIONS[name]
    with np.errstate(all="ignore"):
        expected = function(*PAIRS)
        assert is_same(Elementwise(function)(*PAIRS), expected)


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("size", [1, 7, 8, 9, 16, 41])
def test_any_number_of_boxes(size: int) -> None:
    function = Elementwise(lambda x, y, z: (np.stack([x, y]), x * y < z))
    x, y, z = PAIRS[0, 60 : 60 + size], np.broadcast_to(PAIRS[1, :1], size), np.float64(2.5)
    with np.errstate(all="ignore"):
        assert is_same(function(x, y, z), function.function(x, y, z))
        some = np.arange(0, size, 3)
        assert is_same(function(x, y, z, chosen=some), function.function(x[some], y[some], z))


@pytest.mark.usefixtures("compiled")
def test_what_cannot_be_compiled_is_an_error() -> None:
    for function in (np.cos, np.sort):
        with pytest.raises(TypeError, match="cannot be compiled"):
            Elementwise(function)(PAIRS[0])
    for array in (np.arange(9), np.ones(9, np.float32), PAIRS < 1):
        with pytest.raises(TypeError, match="cannot be compiled"):
            Elementwise(lambda x: x)(array)
    for chosen in (PAIRS[0] < 1, np.arange(9, dtype=np.int32)):
        with pytest.raises(TypeError, match="cannot be read"):
            Elementwise(lambda x: x)(PAIRS[0], chosen=chosen)
    for place in (-1, len(PAIRS[0])):
        with pytest.raises(IndexError, match="beyond"):
            Elementwise(lambda x: x)(PAIRS[0], chosen=np.array([0, place]))


# --- the functions of maps -----------------------------------------------------------------------

SIZE = 203


def numbers(rng: np.random.Generator) -> np.ndarray[Any, Any]:
    """Mostly ordinary ones."""
    found = rng.uniform(-0.2, 1.5, SIZE) * 10.0 ** rng.integers(-3, 1, SIZE)
    special = rng.random(SIZE) < 0.03
    found[special] = rng.choice(SPECIAL, special.sum())
    return found


def intervals(rng: np.random.Generator) -> Intervals:
    low = numbers(rng)
    width = np.where(rng.random(SIZE) < 0.3, 0.0, 10.0 ** rng.uniform(-12, -1, SIZE))
    return Intervals(low, low + width)


def models(rng: np.random.Generator) -> Models:
    x, y, z = (intervals(rng) for _ in range(3))
    return parameter(0, x) * from_bounds(y) + parameter(1, z)


def state(rng: np.random.Generator, number: Callable[[np.random.Generator], Any]) -> State:
    return State(*(0 if k == 4 else number(rng) for k in range(11)))


def likely(rng: np.random.Generator, wide: Callable[[Intervals], Any]) -> State:
    """As they are just after a collision of nearly aligned spheres that collapse, or nearly so."""
    middles = (0.01, 1.0, 0.1, 0.02, 0.0, 1.0, 1.0, 0.99, 1.0, -1.0, 1.0)

    def near(middle: float) -> Any:
        low = middle * (1 + rng.uniform(-0.03, 0.03, SIZE))
        return wide(Intervals(low, low + abs(middle) * 10.0 ** rng.uniform(-8, -2, SIZE)))

    return State(*(near(x) if x else 0 for x in middles))


KINDS: dict[str, tuple[Callable[..., Any], Callable[..., Any], Callable[..., Any]]] = {
    "intervals": (intervals, lambda x: x, lambda: enclosed(Fraction(3, 100))),
    "models": (models, from_bounds, lambda: from_bounds(Intervals(*np.full((2, 1), 0.03)))),
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("is_likely", [False, True])
def test_the_functions_of_maps(kind: str, is_likely: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each on random states, and all boxes of a step."""
    number, wide, rate = KINDS[kind]
    rng, r = np.random.default_rng(3), rate()
    with np.errstate(all="ignore"):
        states = [likely(rng, wide) if is_likely else state(rng, number) for _ in range(3)]
        pairs = tuple(Pair(*(number(rng) for _ in range(3))) for _ in range(3))
        met, way = branches.meeting_part(states[0])
        never, ends = numbers(rng) < 0.1, (np.float64(0.03), np.float64(0.03))
        begun = closing._begun.function(ends, states[0])
        guess = closing._searched._in_turn(begun[1:3], SIZE)[0]
        calls: list[tuple[Any, tuple[Any, ...]]] = [
            (branches._own, (states[0],)),
            (branches._far, (states[0], way.y, way.T)),
            (branches._near, (states[0], never)),
            (branches._after, (r, met, way)),
            (branches._first_of_three, (tuple(states), pairs)),
            (closing._begun, (ends, states[0])),
            (closing._closed, (r.hull, begun[0], guess)),
            (closing._shown_on_a_line, (r.hull, states[0])),
        ]
        for function, given in calls:
            for chosen in (None, np.flatnonzero(never), np.arange(3)):
                monkeypatch.setattr(clock, "wait", inf)
                expected = function(*given, chosen=chosen)
                monkeypatch.setattr(clock, "wait", 0.0)
                assert is_same(function(*given, chosen=chosen), expected), function.function
        worth = np.flatnonzero(begun[3])
        assert len(worth) > SIZE / 2 or not is_likely
        monkeypatch.setattr(clock, "wait", inf)
        last, ended = closing._searched(*begun[1:3], chosen=worth)
        monkeypatch.setattr(clock, "wait", 0.0)
        last_too, ended_too = closing._searched(*begun[1:3], chosen=worth)
        assert (ended == ended_too).all()
        assert ended.any() or not is_likely
        assert is_same(chosen_of(last_too, ended), chosen_of(last, ended))


@pytest.mark.usefixtures("compiled")
@pytest.mark.parametrize("most", [1, 3, 40])
def test_a_step_is_repeated_at_each_box_until_it_ends(most: int) -> None:
    def step(fixed: Any, state: Any) -> Any:
        (x, count) = state
        x, count = x / 2 + fixed, count + 1
        return (x, count), x < 1, ~(x < 1) & (count < 12)

    repeated = Repeated(step, most)
    start = 2.0 ** np.arange(-2, 18)
    given = (np.full(20, 0.25), (start, np.zeros(20)))
    for chosen in (np.arange(1, 20), np.arange(4, 8)):
        last, ended = repeated(*given, chosen=chosen)
        (x, count), expected = repeated._in_turn(chosen_of(given, chosen), len(chosen))
        assert (ended == expected).all()
        assert ended.sum() < 19
        assert ended.any() or len(chosen) < 19
        assert (last[0][ended] == x[ended]).all()
        assert (last[1][ended] == count[ended]).all()


# --- maps ----------------------------------------------------------------------------------------

MAPS: dict[str, Callable[[], Plane | BorderStrip]] = {
    "phi": lambda: Phi(Fraction(3, 100), Fraction(1)),
    "bent": lambda: PLANES["bent"],
    "slow": lambda: PLANES["slow"],
    "slice": lambda: PLANES["slice"],
    "contact": lambda: PLANES["slice-contact"],
    "space": lambda: PLANES["slice-space"],
    "strip": lambda: strip_along(
        Phi(Fraction(3, 100), Fraction(1), x=(Fraction(1, 100), Fraction(9, 25))),
        Fraction(1, 10**5),
        5,
        8,
    ),
    "over r": lambda: plane_of(DIAGRAM, "r", "t"),
    "line over r": lambda: plane_of(LINE.read_text(encoding="utf-8"), "r=0.05..0.08"),
}


def log_of(plane: Plane | BorderStrip) -> bytes:
    progress, boxes = Progress(plane), 1500
    lines = [progress.header]
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(1, 1000), boxes, 12), staff, lines.append):
            pass
    return b"".join(lines)


@pytest.mark.parametrize("name", MAPS)
def test_a_map_has_the_same_bytes(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clock, "wait", inf)
    plane = MAPS[name]()
    expected = log_of(plane)
    assert b'"verdicts"' in expected
    monkeypatch.setattr(clock, "wait", 0.0)
    monkeypatch.setattr(branches._after._kernels, "_known", known := {})
    assert MAPS[name]() == plane
    assert log_of(plane) == expected
    assert known


def test_functions_are_compiled_once_numpy_has_taken_long(monkeypatch: pytest.MonkeyPatch) -> None:
    function = Elementwise(lambda x: x + 1)
    monkeypatch.setattr(elementwise, "clock", elementwise._Clock())
    for spent, count in ((0.0, 0), (elementwise.WAIT, 1)):
        elementwise.clock.spent = spent
        assert function(np.array([1.0])) == [2.0]
        assert len(function._kernels._known) == count


@pytest.mark.usefixtures("compiled")
def test_machine_code_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(kernel, "cache_from_source", lambda _: str(tmp_path / "folder" / "x.pyc"))
    for number, writes in enumerate((False, True)):
        monkeypatch.setattr("sys.dont_write_bytecode", not writes)
        assert Elementwise(lambda x, n=number: x + 7.125 + n)(np.zeros(1)) == [7.125 + number]
        assert len([*tmp_path.glob("folder/*")]) == writes
    (path,) = tmp_path.glob("folder/*.o")
    assert kernel._kept(path)
    path.write_bytes(path.read_bytes()[:-1])
    assert kernel._kept(path) is None
    path.unlink()
    assert kernel._kept(path) is None
    (tmp_path / "file").touch()
    kernel._keep(tmp_path / "file" / "x.o", b"a folder that cannot be made")
