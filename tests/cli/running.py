"""Commands as a person runs them."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from verify.cli import main

#: The exit code, and what stands on both streams.
Found = tuple[int, str, str]


def command(*first: str) -> Callable[..., Found]:
    """What runs the command that begins with these words."""

    def run(capsys: pytest.CaptureFixture[str], *words: object) -> Found:
        code = main([*first, *map(str, words)])
        captured = capsys.readouterr()
        return code, captured.out, captured.err

    return run


def check_refused(found: Found, why: str = "") -> None:
    """Unusable input: one line on stderr that has these words, and nothing else."""
    code, out, err = found
    assert (code, out, err.count("\n")) == (2, "", 1), err
    assert err.startswith("verify: ")
    assert why in err
