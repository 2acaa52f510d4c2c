"""Numbers of many boxes at once, in records: the records are trees whose leaves are arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache
from typing import Any

import numpy as np

#: An array, or a record or number that is made of arrays; whole numbers are the same for all boxes.
Tree = Any


@cache
def _parts(kind: Any) -> tuple[str, ...]:
    """The names of the parts of a number."""
    names: tuple[str, ...] = kind.__slots__ if hasattr(kind, "__slots__") else ()
    return () if issubclass(kind, np.generic) else names


def leaves(tree: Tree) -> Iterator[Any]:
    """The arrays of a tree."""
    kind: Any = type(tree)
    names = _parts(kind)
    if isinstance(tree, tuple) or names:
        for part in tree if isinstance(tree, tuple) else (getattr(tree, name) for name in names):
            yield from leaves(part)
    elif not isinstance(tree, int):
        yield tree


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


def chosen_of(tree: Tree, chosen: Any) -> Tree:
    """What is known of some boxes: of those where it is true, or at these places in their order."""
    size = None if chosen.dtype == bool else len(chosen)

    def part(x: Any) -> Any:
        is_of_all = x.ndim == 0 or x.shape[-1] == 1
        return x if is_of_all or x.shape[-1] == size else x[..., chosen]

    return mapped(tree, part)


def repeated(
    step: Callable[[Tree, Tree], tuple[Tree, Any, Any]], most: int, fixed: Tree, state: Tree
) -> tuple[Tree, Any]:
    """The last states after a step is taken at each box until it ends, and where there is one.

    ``step(fixed, state)`` is the next state, whether that is the last one, and whether to go on. It
    is taken at most so often.
    """
    last = mapped(state, np.empty_like)
    size = max(x.shape[-1] for x in leaves(state))
    places, ended = np.arange(size), np.zeros(size, bool)
    for _ in range(most):
        if len(places) == 0:
            break
        state, ends, goes = step(fixed, state)
        if ends.any():
            ended[places[ends]] = True
            for found, x in zip(leaves(last), leaves(state), strict=True):
                found[..., places[ends]] = x[..., ends]
        if not goes.all():
            places, (fixed, state) = places[goes], chosen_of((fixed, state), goes)
    return last, ended
