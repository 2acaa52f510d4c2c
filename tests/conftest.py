"""What is started before the first test, so that it is done when it is asked for."""

from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any

import pytest


@pytest.fixture(autouse=True)
def whole_lines(monkeypatch: pytest.MonkeyPatch) -> None:
    """Lines are not broken: tests of the terminal say themselves how wide it is."""
    monkeypatch.setenv("COLUMNS", "99999")


@pytest.fixture(scope="session", autouse=True)
def heavy_answers(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Iterator[dict[str, Future[Any]]]:
    """The answers to the heavy files that are asked for, found in processes of their own.

    Other tests run meanwhile: one processor is left to them, if there are any.
    """
    items = [item for item in request.session.items if isinstance(item, pytest.Function)]
    chosen = [i.callspec.params["name"] for i in items if i.originalname == "test_heavy"]
    if not chosen:
        yield {}
        return
    from tests.lies.test_heavy import answer

    folder = tmp_path_factory.mktemp("heavy")
    processors = os.cpu_count() or 1
    with ThreadPoolExecutor(max(1, processors - (len(chosen) < len(items)))) as pool:
        yield {name: pool.submit(answer, name, folder / name) for name in chosen}
        pool.shutdown(cancel_futures=True)
