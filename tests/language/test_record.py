"""Records do what `typing.NamedTuple` does, as far as the program uses it."""

from __future__ import annotations

import copy
import pickle
from typing import Any, NamedTuple

import pytest

from verify.language.record import Record


class Point(Record):
    """A point."""

    x: int
    y: int = 2
    name: str = "p"

    @property
    def total(self) -> int:
        """The sum of both."""
        return self.x + self.y


class Twin(NamedTuple):
    """The same, as the library makes it."""

    x: int
    y: int = 2
    name: str = "p"


class Empty(Record):
    """No entries."""


ARGUMENTS: list[tuple[tuple[Any, ...], dict[str, Any]]] = [
    ((1,), {}),
    ((1, 5), {}),
    ((1, 5, "q"), {}),
    ((), {"x": 1}),
    ((1,), {"name": "r"}),
    ((), {"name": "r", "x": 4}),
]

REFUSED: list[tuple[tuple[Any, ...], dict[str, Any]]] = [
    ((), {}),
    ((1, 2, "p", 4), {}),
    ((1,), {"x": 1}),
    ((1,), {"z": 1}),
    ((1, 2, "p"), {"z": 1}),
    ((), {"y": 1}),
]


@pytest.mark.parametrize(("values", "named"), ARGUMENTS)
def test_entries_are_those_of_a_named_tuple(values: Any, named: Any) -> None:
    one, two = Point(*values, **named), Twin(*values, **named)
    assert tuple(one) == tuple(two)
    assert (one.x, one.y, one.name) == (two.x, two.y, two.name)
    assert one._asdict() == two._asdict()
    assert repr(one) == repr(two).replace("Twin", "Point")
    assert hash(one) == hash(two)
    assert Point._make(one) == one


@pytest.mark.parametrize(("values", "named"), REFUSED)
def test_what_is_refused(values: Any, named: Any) -> None:
    for kind in (Point, Twin):
        with pytest.raises(TypeError):
            kind(*values, **named)


def test_entries_are_replaced_and_never_changed() -> None:
    point = Point(1)
    assert point._replace(name="q") == (1, 2, "q")
    assert point == (1, 2, "p")
    with pytest.raises((TypeError, ValueError)):
        point._replace(z=1)  # type: ignore[call-arg]
    with pytest.raises(AttributeError):
        point.x = 3  # type: ignore[misc]
    with pytest.raises(AttributeError):
        point.other = 3  # type: ignore[attr-defined]


def test_properties_patterns_and_copies() -> None:
    point = Point(1)
    assert point.total == 3
    match point:
        case Point(1, name=name):
            assert name == "p"
        case _:
            raise AssertionError
    assert copy.copy(point) == point
    again = pickle.loads(pickle.dumps(point))
    assert (type(again), again) == (Point, point)
    assert Empty() == ()
    assert Point._fields == Twin._fields
