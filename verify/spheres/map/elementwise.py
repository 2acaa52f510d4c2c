"""Functions of many boxes at once whose value at each box depends on that box alone."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np

#: An array, or a record or number that is made of arrays; whole numbers are the same for all boxes.
Tree = Any


def leaves(tree: Tree) -> Iterator[Any]:
    """The arrays of a tree."""
    if isinstance(tree, tuple):
        for part in tree:
            yield from leaves(part)
    elif names := _parts(type(tree)):
        for name in names:
            yield from leaves(getattr(tree, name))
    elif not isinstance(tree, int):
        yield tree


def mapped(tree: Tree, function: Callable[[Any], Any]) -> Tree:
    """The tree with a function of each array in its place."""
    if isinstance(tree, tuple):
        return tuple.__new__(type(tree), [mapped(part, function) for part in tree])
    if names := _parts(type(tree)):
        found = object.__new__(type(tree))
        for name in names:
            setattr(found, name, mapped(getattr(tree, name), function))
        return found
    return tree if isinstance(tree, int) else function(tree)


def _parts(kind: type) -> tuple[str, ...]:
    """The names of the parts of a number."""
    return () if issubclass(kind, np.ndarray | np.generic | int) else kind.__slots__  # type: ignore[attr-defined]


def of_all(x: Any) -> bool:
    """Whether there is one value for all boxes."""
    return np.ndim(x) == 0 or x.shape[-1] == 1


def chosen_of(tree: Tree, chosen: Any) -> Tree:
    """What is known of some boxes: of those where it is true, or at these places in their order."""
    size = None if chosen.dtype == bool else len(chosen)
    return mapped(tree, lambda x: x if of_all(x) or x.shape[-1] == size else x[..., chosen])


class Elementwise:
    """A function of trees whose value at each box depends on that box alone."""

    def __init__(self, function: Callable[..., Tree]) -> None:
        self.function = function

    def __call__(self, *given: Tree, chosen: Any = None) -> Tree:
        """Its value at all boxes, or at the chosen ones."""
        return self.function(*(given if chosen is None else chosen_of(given, chosen)))


class Repeated:
    """A step that is taken at each box until it is the last one there, or leads nowhere.

    ``step(fixed, state)`` is the next state, whether that is the last one, and whether to go on.
    """

    def __init__(self, step: Callable[..., Tree], most: int) -> None:
        self.step, self.most = step, most

    def __call__(self, fixed: Tree, state: Tree, chosen: Any) -> tuple[Tree, Any]:
        """At the chosen boxes the last states, and where there is one."""
        fixed, state = chosen_of((fixed, state), chosen)
        last, ended = mapped(state, np.empty_like), np.zeros(len(chosen), bool)
        places = np.arange(len(chosen))
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
