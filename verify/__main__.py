"""`python -m verify`, and the command `verify`."""

from __future__ import annotations

import gc
import os
import signal
import sys
from contextlib import suppress

#: What `verify.cli` says of these codes: our own error, an interrupt, and a request to end.
OWN_ERROR, INTERRUPTED, TERMINATED = 5, 130, 143


def run() -> None:
    """Run a command and leave at once: taking the process down tidily costs as much as a proof.

    What was printed is flushed by `verify.cli.main`; files are written whole when it returns.
    Whatever nobody has caught is one line and code 5, also where it is raised by an import.
    """
    # A short-lived process that builds trees and drops nothing: collecting would find no garbage.
    gc.disable()
    code, process = OWN_ERROR, os.getpid()

    def terminated(_number: int, _frame: object) -> None:
        if os.getpid() == process:  # and not a helper that it has started
            _tell("terminated")
        os._exit(TERMINATED)

    signal.signal(signal.SIGTERM, terminated)
    try:
        try:
            code = _code()
        except KeyboardInterrupt:
            code = INTERRUPTED
            _tell("interrupted")
        except BaseException as error:  # Python would end with code 1, which means refuted
            _tell(words_about(error))
        for stream in (sys.stdout, sys.stderr):
            with suppress(OSError, ValueError, AttributeError):  # main has said so
                stream.flush()
    finally:  # also after a second interrupt
        os._exit(code)


def _code() -> int:
    from verify.language.interrupts import held

    with held():
        from verify.cli import main
    return main()


def words_about(error: BaseException) -> str:
    """One line about an error that nobody has expected."""
    if isinstance(error, MemoryError):
        return "our own error: there is not enough memory; make the input smaller"
    if isinstance(error, RecursionError):
        return "our own error: something in the input nests too deeply; name its parts"
    words = " ".join(f"{type(error).__name__}: {error}".split())
    return f"our own error: {words[:300]}; please report it with the input"


def _tell(words: str) -> None:
    with suppress(OSError):  # nobody listens; the exit code says it still
        os.write(2, f"verify: {ascii(words)[1:-1]}\n".encode())


if __name__ == "__main__":
    run()
