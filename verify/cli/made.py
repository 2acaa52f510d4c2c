"""What is told of the files that a command writes or compares: a line each, or one document."""

from __future__ import annotations

from verify.cli.files import print_document
from verify.cli.options import Options
from verify.cli.terminal import erase
from verify.language.record import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import Any

FORMAT = "verify-files/1"
WRITTEN, SAME, DIFFERS, STALE = "written", "same", "DIFFERS", "STALE"


class Made:
    """Tells of each file at once, or of all at the end where ``--json`` is asked for."""

    def __init__(self, command: str, options: Options) -> None:
        self._told: list[dict[str, str]] = []
        self._json = options.json
        self._head = {"format": FORMAT, "command": command, "compared": options.compare}

    def __call__(self, state: str, path: str, why: str = "") -> None:
        """Tell what was done with a file, or found out about it."""
        self._told.append({"path": path, "state": state.lower()} | ({"why": why} if why else {}))
        if not self._json:
            erase()
            print(f"{state:<8} {path}{f': {why}' if why else ''}")

    def end(self, code: int, error: str = "") -> int:
        """Print the document, if it is asked for; return the exit code."""
        if self._json:
            document: dict[str, Any] = {**self._head, "files": self._told, "exit_code": code}
            print_document(document | ({"error": error} if error else {}))
        return code
