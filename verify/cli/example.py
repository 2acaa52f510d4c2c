"""List the examples that come with the program, or copy one into this folder."""

from __future__ import annotations

import os

from verify.cli.files import command_for, example, examples, read_bytes, write_all
from verify.cli.options import Options, Usage, beside
from verify.cli.terminal import width
from verify.wire.inputs import InputError, nearest, shown

USAGE = Usage(
    {
        "[name]": f"of an example: {', '.join(examples())}; without a name all are listed with "
        "what they are, and the command that decides them"
    }
)


def run(options: Options) -> int:
    """Print the commands that run them, or write one file."""
    names = examples()
    if options.name is None:
        for name in names:
            command = f"verify {_command(name)} {name}"
            print("\n".join(beside(command, _about(name), 30, width())))
        return 0
    if options.name not in names:
        known = nearest(options.name, names)
        raise InputError(f"name: there is no example {shown(options.name)}; {known}")
    file = f"{options.name}.toml"
    if os.path.lexists(file):
        raise InputError(f"name: {file} is here already; copy it into another folder")
    write_all("name", os.curdir, {file: _content(options.name)})
    print(f"{file} is written; try: verify {_command(options.name)} {file}")
    return 0


def _content(name: str) -> bytes:
    return read_bytes("name", example(name))


def _command(name: str) -> str:
    return command_for(example(name))


def _about(name: str) -> str:
    """The title of a page; what the first lines of a scene say."""
    lines = _content(name).decode().splitlines()
    titles = [line.partition("=")[2].strip(' "') for line in lines if line.startswith("title")]
    remarks = [line.strip("# ") for line in lines if line.startswith("#")]
    return titles[0] if titles else " ".join(remarks)
