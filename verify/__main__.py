"""`python -m verify`, and the command `verify`."""

from __future__ import annotations

import gc
import os
import sys
from contextlib import suppress

from verify.language.record import TYPE_CHECKING

if TYPE_CHECKING:
    from typing import NoReturn


def run() -> NoReturn:
    """Run a command and leave at once: taking the process down tidily costs as much as a proof.

    What was printed is flushed by `verify.cli.main`; files are written whole when it returns.
    """
    # A short-lived process that builds trees and drops nothing: collecting would find no garbage.
    gc.disable()
    try:
        from verify.cli import main

        code = main()
    except KeyboardInterrupt:
        code = 130
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError, AttributeError):  # main has said so, or nobody listens
            stream.flush()
    os._exit(code)


if __name__ == "__main__":
    run()
