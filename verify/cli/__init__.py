"""The command line: one module per command, loaded only when it is asked for."""

from __future__ import annotations

import os
import sys
from argparse import ArgumentParser
from collections.abc import Sequence
from importlib import import_module
from typing import NoReturn

from verify import __version__
from verify.inputs import InputError

#: The commands in the order a newcomer needs them.
COMMANDS = {
    "theorem1": "decide Theorem 1 (collapse of three particles) at given parameters",
    "spectrum": "prove the spectral claims for every r, enclose the spectrum at one",
    "check": "check a certificate, and that its statement is the right one",
    "bench": "measure speed against error",
    "stress": "run the numerically hard cases",
    "report": "write the report: a page with plots, its Markdown twin, a LaTeX table",
    "certify": "make the committed certificates anew, or compare them",
}

USAGE_ERROR = 2
INTERRUPTED = 130


class Parser(ArgumentParser):
    """An argument parser whose errors are one line."""

    def error(self, message: str) -> NoReturn:
        """Raise instead of printing the usage."""
        raise InputError(f"{message}; see {self.prog} --help")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one command and return its exit code: 0, 1, 2, 3 or 4 (see the README)."""
    words = list(sys.argv[1:] if arguments is None else arguments)
    try:
        return _dispatch(words)
    except InputError as error:
        print(f"verify: {error}", file=sys.stderr)
        return USAGE_ERROR
    except KeyboardInterrupt:
        print("verify: interrupted; nothing was written", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # The reader of the output has left; what it read was right.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0


def _dispatch(words: list[str]) -> int:
    if not words or words[0] in ("-h", "--help"):
        print(_help())
        return 0 if words else USAGE_ERROR
    if words[0] == "--version":
        print(f"verify {__version__}")
        return 0
    name = words[0]
    if name not in COMMANDS:
        known = ", ".join(COMMANDS)
        raise InputError(f"{name!r} is not a command; write one of: {known}")
    command = import_module(f"verify.cli.{name}")
    parser = Parser(prog=f"verify {name}", description=command.__doc__, allow_abbrev=False)
    command.add_arguments(parser)
    code = command.run(parser.parse_args(words[1:]))
    sys.stdout.flush()
    return int(code)


def _help() -> str:
    lines = ["usage: verify COMMAND [options]", "", "commands:"]
    lines += [f"  {name:<10} {summary}" for name, summary in COMMANDS.items()]
    lines += ["", "verify COMMAND --help describes the options of a command.", "", _EXIT_CODES]
    return "\n".join(lines)


_EXIT_CODES = """exit codes:
  0  everything asked for is proved
  1  something asked for is refuted
  2  the input cannot be used
  3  undecided within the precision budget
  4  a malformed certificate, or one that does not belong to its statement"""
