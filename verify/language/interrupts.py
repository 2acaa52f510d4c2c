"""Interrupts that wait: a library of C that is interrupted while it is loaded may crash."""

from __future__ import annotations

import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType


@contextmanager
def held() -> Iterator[None]:
    """What stands in it is not interrupted: a SIGINT that comes meanwhile comes at the end.

    Only the main thread of a process can hold it back; in another one nothing is interrupted.
    """
    waiting: list[int] = []
    before = signal.getsignal(signal.SIGINT)
    try:
        if before is not None:  # what Python has not set it cannot set again
            signal.signal(signal.SIGINT, lambda number, _: waiting.append(number))
    except ValueError:  # another thread
        before = None
    try:
        yield
    finally:
        if before is not None:
            signal.signal(signal.SIGINT, before)
            if waiting:
                signal.raise_signal(signal.SIGINT)


class HeldImport:
    """A finder that loads one library without interrupts, wherever it is imported first.

    Args:
        name: the name of the library.
    """

    def __init__(self, name: str) -> None:
        self.name = name

    def find_spec(
        self, name: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """How to load the library; None of every other one."""
        if name != self.name:
            return None
        spec = PathFinder.find_spec(name, path, target)
        if spec is not None and spec.loader is not None:
            spec.loader.exec_module = partial(_loaded, spec.loader.exec_module)  # type: ignore[method-assign]
        return spec


def _loaded(load: Callable[[ModuleType], None], module: ModuleType) -> None:
    with held():
        load(module)


def hold_while_loading(name: str) -> None:
    """Afterwards a library that is not loaded yet will be loaded without interrupts."""
    if name not in sys.modules:
        sys.meta_path.insert(0, HeldImport(name))
