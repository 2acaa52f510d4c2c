"""Print a script that completes commands and options in a shell."""

from __future__ import annotations

import sys
from argparse import Action, ArgumentParser
from collections.abc import Iterator
from importlib import import_module

from verify.cli.options import Options, Usage
from verify.wire.inputs import InputError, shown

SHELLS = ("bash", "zsh", "tcsh")


USAGE = Usage({"shell": f"{', '.join(SHELLS[:-1])} or {SHELLS[-1]}"})


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
        parser = commands.add_parser(name, help=about, description=about)
        for action in _added(parser, command.USAGE):
            if not action.option_strings or action.metavar in ("FILE", "DIR"):
                vars(action)["complete"] = shtab.FILE
    return whole


def _added(parser: ArgumentParser, usage: Usage) -> Iterator[Action]:
    """The options and words of a command, made known to a parser of the standard library."""
    for written, text in usage.meanings.items():
        option, _, value = written.partition(" ")
        about = text.replace("%", "%%")
        if not written.startswith("-"):
            yield parser.add_argument(option.strip("[]"), nargs="*", help=about)
        elif not value or ", " in written:
            yield parser.add_argument(*written.split(", "), action="store_true", help=about)
        else:
            choices = usage.choices.get(option)
            yield parser.add_argument(option, metavar=value, choices=choices, help=about)
