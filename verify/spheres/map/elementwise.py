"""Functions of many boxes at once whose value at each box depends on that box alone.

They are run in numpy. Where the extra `fast` is installed, they are compiled once they have taken
as long as that may take; their values are the same.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from time import perf_counter
from typing import Any

import numpy as np

#: An array, or a record or number that is made of arrays; whole numbers are the same for all boxes.
Tree = Any
#: In so many seconds of numpy functions are compiled, or loaded.
WAIT = 0.1


@cache
def _parts(kind: Any) -> tuple[str, ...]:
    """The names of the parts of a number."""
    names: tuple[str, ...] = kind.__slots__ if hasattr(kind, "__slots__") else ()
    return () if issubclass(kind, np.generic) else names


def leaves(tree: Tree, shape: list[Any] | None = None) -> list[Any]:
    """The arrays of a tree; what it is besides is appended to `shape`."""
    found: list[Any] = []
    _gather(tree, found, [] if shape is None else shape)
    return found


def _gather(tree: Tree, found: list[Any], shape: list[Any]) -> None:
    kind: Any = type(tree)
    shape.append(kind)
    if isinstance(tree, tuple):
        for part in tree:
            _gather(part, found, shape)
    elif names := _parts(kind):
        for name in names:
            _gather(getattr(tree, name), found, shape)
    elif isinstance(tree, int):
        shape.append(tree)
    else:
        found.append(tree)
        shape += tree.dtype, tree.ndim


def mapped(tree: Tree, function: Callable[[Any], Any]) -> Tree:
    """The tree with a function of each array in its place."""
    if isinstance(tree, tuple):
        return tuple.__new__(type(tree), [mapped(part, function) for part in tree])
    kind: Any = type(tree)
    if names := _parts(kind):
        found = object.__new__(kind)
        for name in names:
            setattr(found, name, mapped(getattr(tree, name), function))
        return found
    return tree if isinstance(tree, int) else function(tree)


def of_all(x: Any) -> bool:
    """Whether there is one value for all boxes."""
    return bool(x.ndim == 0 or x.shape[-1] == 1)


def chosen_of(tree: Tree, chosen: Any) -> Tree:
    """What is known of some boxes: of those where it is true, or at these places in their order."""
    size = None if chosen.dtype == bool else len(chosen)
    return mapped(tree, lambda x: x if of_all(x) or x.shape[-1] == size else x[..., chosen])


class Elementwise:
    """A function of trees whose value at each box depends on that box alone."""

    def __init__(self, function: Callable[..., Tree]) -> None:
        self.function = function
        self._kernels = _Kernels(function, 0)

    def __call__(self, *given: Tree, chosen: Any = None) -> Tree:
        """Its value at all boxes, or at the chosen ones."""
        if clock.is_over():
            return self._kernels(given, chosen)
        with clock:
            return self.function(*(given if chosen is None else chosen_of(given, chosen)))


class Repeated:
    """A step that is taken at each box until it is the last one there, or leads nowhere.

    ``step(fixed, state)`` is the next state, whether that is the last one, and whether to go on.
    """

    def __init__(self, step: Callable[..., Tree], most: int) -> None:
        self.step, self.most = step, most
        self._kernels = _Kernels(step, most)

    def __call__(self, fixed: Tree, state: Tree, chosen: Any) -> tuple[Tree, Any]:
        """At the chosen boxes the last states, and where there is one."""
        if clock.is_over():
            last, ended = self._kernels((fixed, state), chosen)
            return last, ended
        with clock:
            return self._in_turn(chosen_of((fixed, state), chosen), len(chosen))

    def _in_turn(self, given: Tree, size: int) -> tuple[Tree, Any]:
        fixed, state = given
        last, ended = mapped(state, np.empty_like), np.zeros(size, bool)
        places = np.arange(size)
        for _ in range(self.most):
            if len(places) == 0:
                break
            state, ends, goes = self.step(fixed, state)
            if ends.any():
                ended[places[ends]] = True
                for found, x in zip(leaves(last), leaves(state), strict=True):
                    found[..., places[ends]] = x[..., ends]
            if not goes.all():
                places, (fixed, state) = places[goes], chosen_of((fixed, state), goes)
        return last, ended


class _Clock:
    """How long these functions have taken in numpy."""

    def __init__(self) -> None:
        self.spent, self.wait = 0.0, WAIT if find_spec("llvmlite") else float("inf")

    def is_over(self) -> bool:
        """Whether to compile."""
        return self.spent >= self.wait

    def __enter__(self) -> None:
        self.spent -= perf_counter()

    def __exit__(self, *_: object) -> None:
        self.spent += perf_counter()


clock = _Clock()


class _Kernels:
    """A function compiled for each shape of what it is given."""

    def __init__(self, function: Callable[..., Tree], most: int) -> None:
        self.function, self.most = function, most
        self._known: dict[tuple[Any, ...], Callable[..., Tree]] = {}

    def __call__(self, given: Tree, chosen: Any) -> Tree:
        shape: list[Any] = []
        arrays = leaves(given, shape)
        kernel = self._known.get(key := tuple(shape))
        if kernel is None:
            from verify.spheres.map.kernel import Kernel  # llvmlite is loaded only where it is used

            kernel = self._known[key] = Kernel(self.function, given, self.most)
        return kernel(arrays, chosen)
