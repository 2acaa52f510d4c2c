"""The command line: one module per command, loaded only when it is asked for."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Sequence
from contextlib import suppress
from errno import EAGAIN, EBADF, EMFILE, ENFILE, ENOMEM
from importlib import import_module
from io import TextIOWrapper

from verify import __version__
from verify.cli.options import Parser, beside
from verify.cli.terminal import erase, width
from verify.language.errors import OwnError
from verify.language.interrupts import held
from verify.wire.inputs import InputError, nearest, shown

#: The commands in the order a newcomer needs them.
COMMANDS = {
    "theorem1": "decide Theorem 1 (collapse of three particles) at given parameters",
    "spectrum": "prove the spectral claims for every r, enclose the spectrum at one",
    "scene": "decide whether three given particles collapse",
    "map": "decide whole boxes of scenes, and enclose the border of what collapses",
    "classification": "prove which collapses there are; what that says at one r",
    "separatrix": "enclose the curve between collapse and the end of collisions",
    "elsewhere": "judge what the paper prints outside Theorem 1's proof and the spectrum",
    "prove": "decide a statement of your own, with a certificate",
    "explain": "print a row with the facts and the identity that prove it",
    "check": "check a certificate, and that its statement is the right one",
    "example": "list the examples that come with the program, or copy one",
    "export": "write a certificate for Coq, or its statement as a page",
    "bench": "measure speed against error",
    "stress": "run the numerically hard cases",
    "report": "write the report: pages with plots, and a LaTeX table",
    "certify": "make the committed certificates anew, or compare them",
}

#: The format of the document that says why there is no other one.
ERROR = "verify-error/1"

#: How the names of files end that a command may be asked about.
INPUTS = (".toml", ".json", ".smt2", ".fpcore")

USAGE_ERROR = 2
OWN_ERROR = 5
INTERRUPTED = 130
PIPE_CLOSED = 141
TERMINATED = 143


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code (see `_EXIT_CODES`)."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    # The lengths of inputs are capped where they are read; what is computed may be longer.
    sys.set_int_max_str_digits(0)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(encoding="utf-8", errors="backslashreplace")
    try:
        if sys.stdout is None:
            raise OSError(EBADF, os.strerror(EBADF))
        try:
            code = _dispatch(words)
        finally:
            erase()
        sys.stdout.flush()
    except InputError as error:
        return _fail(str(error), USAGE_ERROR, words)
    except OwnError as error:
        return _fail(str(error), OWN_ERROR, words)
    except KeyboardInterrupt:
        return _fail("interrupted", INTERRUPTED)
    except BrokenPipeError:
        _silence_stdout()
        return PIPE_CLOSED
    except OSError as error:
        _silence_stdout()
        if _is_lack(error):
            what = f"the system allows no more files, processes or memory ({error.strerror})"
            return _fail(f"{what}; write a smaller --jobs, or raise its limits", OWN_ERROR)
        return _fail(f"stdout cannot be written ({error.strerror})", USAGE_ERROR)
    return code


def _is_lack(error: OSError) -> bool:
    """Whether the system has refused a file or a process; a full pipe says how much it took."""
    lacks = (EMFILE, ENFILE, ENOMEM, EAGAIN)
    return error.errno in lacks and not hasattr(error, "characters_written")


def _fail(message: str, code: int, words: Sequence[str] = ()) -> int:
    """Say why there is no answer: on stderr, and as a document where one is asked for.

    Numbers of more than a hundred digits are cut.
    """
    message = re.sub("([0-9]{20})[0-9]{70,}([0-9]{10})", r"\1...\2", message)
    if "--json" in words and words[0] in COMMANDS:
        import json  # loaded only where it is used

        found = {"format": ERROR, "command": words[0], "error": message, "exit_code": code}
        with suppress(OSError, AttributeError):
            print(json.dumps(found, ensure_ascii=False, indent=1), flush=True)
    if sys.stderr is not None:
        with suppress(OSError):  # nobody listens; the exit code says it still
            print(f"verify: {message}", file=sys.stderr, flush=True)
    return code


def _silence_stdout() -> None:
    """What is still in the buffer goes nowhere, so that the end of Python is quiet."""
    with suppress(OSError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _dispatch(words: list[str]) -> int:
    known = ", ".join(COMMANDS)
    if not words:
        raise InputError(f"no command; write one of: {known}")
    if words[0] == "help":
        words = [*words[1:2], "--help", *words[2:]]
    name = words[0]
    if name in ("-h", "--help"):
        print(_help())
        return 0
    if name in ("-V", "--version"):
        print(f"verify {__version__}")
        return 0
    if name not in COMMANDS:
        if name.endswith(INPUTS):
            before = "scene" if _is_scene(name) else "prove"
            raise InputError(
                f"{shown(name)} is not a command; write one before it: {before} {name}"
            )
        instead = nearest(name, COMMANDS, f"write one of: {known}")
        raise InputError(f"{shown(name)} is not a command; {instead}")
    with held():
        command = import_module(f"verify.cli.{name}")
    parser = Parser(f"verify {name}", command.__doc__ or "", command.USAGE)
    options = parser.read(words[1:])
    if options is None:
        print(parser.help(width()))
        return 0
    return int(command.run(options))


def _is_scene(path: str) -> bool:
    """Whether a file has positions of particles, as scenes have and statements do not."""
    from verify.wire.inputs import regular_file  # loaded only where it is used

    try:
        content = regular_file(path, 1 << 20)
    except (OSError, ValueError):
        return False
    return any(line.lstrip().startswith(b"positions") for line in content.splitlines())


def _help() -> str:
    lines = ["usage: verify COMMAND [options]", "", "commands:"]
    for name, summary in COMMANDS.items():
        lines += beside(f"  {name}", summary, 18, width())
    lines += ["", "verify help COMMAND describes the options of a command.", "", "exit codes:"]
    for code, meaning in _EXIT_CODES.items():
        lines += beside(f"  {code}", meaning, 7, width())
    return "\n".join(lines)


_EXIT_CODES = {
    0: "everything asked for is proved",
    1: "something asked for, or a hypothesis, is refuted; or a certificate is refused",
    USAGE_ERROR: "the input cannot be used",
    3: "undecided within the precision or work budget",
    4: "a malformed certificate, one that is not its statement's, or a foreign theorem",
    OWN_ERROR: "our own error: a proof that the checker does not accept, or too little memory",
    INTERRUPTED: "interrupted",
    PIPE_CLOSED: "the reader of the output has left",
    TERMINATED: "asked to end (SIGTERM)",
}
