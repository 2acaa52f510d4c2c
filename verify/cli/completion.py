"""Print a script that completes commands and options in a shell."""

from __future__ import annotations

import sys
from argparse import ArgumentParser
from importlib import import_module

from verify.cli.options import Options, Parser
from verify.wire.inputs import InputError, shown

SHELLS = ("bash", "zsh", "tcsh")


def add_arguments(parser: Parser) -> None:
    """The options."""
    parser.place("shell", f"{', '.join(SHELLS[:-1])} or {SHELLS[-1]}")


def run(options: Options) -> int:
    """Print the script; return 0."""
    if options.shell not in SHELLS:
        raise InputError(f"shell: {shown(options.shell)} is unknown; write {' or '.join(SHELLS)}")
    import shtab  # loaded only here

    sys.stdout.write(shtab.complete(every_option(), options.shell))
    return 0


def every_option() -> ArgumentParser:
    """The commands with their options; what names a file is completed to one."""
    import shtab

    from verify.cli import COMMANDS

    whole = ArgumentParser("verify")
    whole.add_argument("--version", "-V", action="store_true", help="print the version")
    commands = whole.add_subparsers()
    for name, about in COMMANDS.items():
        command = import_module(f"verify.cli.{name}")
        parser = Parser(f"verify {name}", about)
        command.add_arguments(parser)
        for action in parser.add_to(commands.add_parser(name, help=about, description=about)):
            if not action.option_strings or action.metavar in ("FILE", "DIR"):
                vars(action)["complete"] = shtab.FILE
    return whole
