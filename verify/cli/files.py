"""Writing results: files, all of them or none, certificates, documents, and progress."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping
from contextlib import suppress
from errno import EISDIR

from verify.jobs.errors import UnreadError
from verify.jobs.inputs import InputError, shown
from verify.language.record import TYPE_CHECKING
from verify.language.statement import NEEDED, UNDECIDED

if TYPE_CHECKING:
    from typing import Any

    from verify.prover.outcome import Outcome

#: Numbers with more digits, above or below the fraction bar, are not in the checker's format.
CHECKER_DIGITS = 4300

#: Of a file that is read: as many as the checker reads.
MAX_BYTES = 1 << 22

#: Only numbers with this many digits can be more work than the checker is willing to do.
LONG_NUMBER = 300


def test_folder(option: str, directory: str | None, *names: str) -> None:
    """Before the work: afterwards files of these names can be written into the directory.

    Nothing stays on the disk. None is a directory that nobody asked for.

    Raises:
        InputError: if they cannot, naming the option.
    """
    if directory is not None:
        with _Writing(option, directory) as writing:
            for name in names:
                writing.add(name, b"")


def write_all(option: str, directory: str, contents: Mapping[str, bytes]) -> None:
    """Write files into a directory, created if needed; each appears whole or not at all.

    Raises:
        InputError: if the directory or a file cannot be written, naming the option.
    """
    with _Writing(option, directory) as writing:
        for name, content in contents.items():
            writing.add(name, content)
        writing.finish()


class _Writing:
    """Files on their way into a directory: what is not finished disappears."""

    def __init__(self, option: str, directory: str) -> None:
        self._option, self._directory = option, directory
        self._temporary: dict[str, str] = {}
        self._made: list[str] = []

    def __enter__(self) -> _Writing:
        if not self._directory:
            raise InputError(f"{self._option}: '' is no folder; write . for this one")
        return self

    def add(self, name: str, content: bytes) -> None:
        """Write a file beside its place."""
        target = os.path.join(self._directory, name)
        folder, last = os.path.split(target)
        self._make(folder)
        if os.path.isdir(target):
            raise IsADirectoryError(EISDIR, os.strerror(EISDIR), target)
        path = os.path.join(folder, f".{last}.{os.getpid()}")
        self._temporary[path] = target
        with open(path, "xb") as file:
            file.write(content)

    def _make(self, folder: str) -> None:
        with suppress(FileNotFoundError):
            os.stat(folder or os.curdir)  # a path that is too long fails here
        missing = []
        while folder and not os.path.isdir(folder):
            missing.append(folder)
            folder = os.path.dirname(folder)
        for path in reversed(missing):
            try:
                os.mkdir(path)
            except FileExistsError:  # another process has made it meanwhile
                if not os.path.isdir(path):
                    raise
            else:
                self._made.append(path)

    def finish(self) -> None:
        """Put every file into its place."""
        for path, target in self._temporary.items():
            os.replace(path, target)

    def __exit__(self, _kind: object, error: BaseException | None, _trace: object) -> None:
        for path in self._temporary:
            with suppress(OSError):
                os.unlink(path)
        for path in reversed(self._made):
            with suppress(OSError):  # not empty: its files are in their places
                os.rmdir(path)
        if isinstance(error, OSError | ValueError | RecursionError):
            raise InputError(
                f"{self._option}: {shown(self._directory)} cannot be written ({_reason(error)}); "
                "name a folder that can"
            ) from error


def write_certificate(option: str, directory: str, outcome: Outcome) -> None:
    """Write an outcome as a certificate that `verify/check.py` accepts, or say why not.

    Nothing is written, with a line on stderr, where a needed row is undecided.

    Raises:
        InputError: if the directory cannot be written, or the checker cannot read the parameters.
        OwnError: if the checker does not accept what would be written.
    """
    from verify.jobs.acceptance import (
        accept,  # hashlib and json are loaded only where they are used
    )
    from verify.wire.write import write

    if outcome.spent or any(
        row.role == NEEDED and found.claimed == UNDECIDED for row, found in outcome.rows
    ):
        print("verify: a needed row is undecided; no certificate was written", file=sys.stderr)
        return
    digits = longest_number(outcome)
    if digits > CHECKER_DIGITS:
        raise InputError(
            f"{option}: a number in the certificate would have {digits} digits, and the checker "
            f"reads at most {CHECKER_DIGITS}; write parameters with fewer digits"
        )
    files = write(outcome)
    try:
        accept(files, outcome.claimed)
    except UnreadError as error:
        if digits < LONG_NUMBER:
            raise
        raise InputError(
            f"{option}: numbers of {digits} digits make the certificate more than the checker's "
            "budget of work; write parameters with fewer digits"
        ) from error
    write_all(option, directory, files)


def longest_number(outcome: Outcome) -> int:
    """The largest number of digits above or below a fraction bar in a statement."""
    from verify.language.terms import parts_of  # loaded only where they are used
    from verify.wire.write import statement_terms

    parts = parts_of(*statement_terms(outcome.statement))
    numbers = [part.value for part in parts if part.op == "rational"]
    ends = (end for value in numbers for end in (abs(value.numerator), value.denominator))
    return len(str(max(ends, default=1)))


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def read_bytes(option: str, path: str) -> bytes:
    """The content of a file.

    Raises:
        InputError: if it cannot be read, or has no end in sight, naming the option.
    """
    try:
        with open(path, "rb") as file:
            content = file.read(MAX_BYTES + 1)
    except (OSError, ValueError) as error:
        raise InputError(
            f"{option}: {shown(path)} cannot be read ({_reason(error)}); name a file"
        ) from error
    if len(content) > MAX_BYTES:
        raise InputError(f"{option}: {shown(path)} has more than {MAX_BYTES} bytes; name a file")
    return content


def progress(text: str) -> None:
    """Say on stderr what is being done, if somebody watches."""
    if sys.stderr is not None and sys.stderr.isatty():
        print(f"{text} …", file=sys.stderr)


def print_document(document: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout."""
    import json  # loaded only where it is used

    print(json.dumps(document, ensure_ascii=False, indent=1))
