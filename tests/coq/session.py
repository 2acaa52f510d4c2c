"""Coq as a process that answers, so that it loads the libraries once for many texts."""

from __future__ import annotations

import atexit
import re
import subprocess
from functools import cache
from pathlib import Path
from threading import Thread, Timer
from typing import IO

#: What the pages and the files that they pin use of Coq's libraries.
LIBRARIES = (
    "From Coq Require Reals Lra Psatz List Arith Lia ZArith QArith FunctionalExtensionality."
)
#: What many of the pages use of what is compiled, with all that it needs: it is loaded once, too.
PAGE = "From Verify Require Pinned."
#: The state after these, as Coq counts: the two sentences above, and that goals are not shown.
READY = 4
#: An answer comes within so many seconds.
PATIENCE = 300


class Session:
    """A toplevel in a folder with compiled files; each text is forgotten after its answer."""

    def __init__(self, directory: Path) -> None:
        self.coq = subprocess.Popen(
            ["coqtop", "-q", "-quiet", "-w", "none", "-R", ".", "Verify"], cwd=directory,
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
        )  # fmt: skip
        atexit.register(self.close)  # its time is counted when it has ended
        if self.fails(f"{LIBRARIES}\n{PAGE}\nSet Silent."):
            raise ValueError("the libraries cannot be loaded")

    def close(self) -> None:
        """It has ended afterwards."""
        self.coq.kill()
        self.coq.wait()

    def fails(self, text: str) -> bool:
        """Whether there is an error in sentences.

        Raises:
            ValueError: if Coq stops, or does not come to their end.
        """
        assert self.coq.stdin
        assert self.coq.stdout
        # A name that nothing has: the error about it is the end of the answer.
        end = "the_end_of_the_text"
        Thread(target=_write, args=(self.coq.stdin, f"{text}\nCheck {end}.\n")).start()
        timer = Timer(PATIENCE, self.coq.kill)
        timer.start()
        failed = False
        try:
            for line in self.coq.stdout:
                if end in line and "was not found" in line:
                    return failed
                failed |= re.match("(Error|Anomaly|Syntax error)", line) is not None
        finally:
            timer.cancel()
        raise ValueError("Coq stops")

    def first_that_fails(self, parts: dict[str, str]) -> str:
        """The first of some modules in which there is an error, or empty; all are forgotten.

        What comes after the proof with the error is not read.
        """
        pieces = (
            (name, piece)
            for name, text in parts.items()
            for piece in re.split(r"(?<=\bQed\.)\n", text)
        )
        try:
            return next((name for name, piece in pieces if self.fails(piece)), "")
        finally:
            if self.fails(f"BackTo {READY}."):
                raise ValueError("Coq does not forget")


def _write(to: IO[str], text: str) -> None:
    to.write(text)
    to.flush()


@cache
def session(directory: Path) -> Session:
    """The one in a folder."""
    return Session(directory)
