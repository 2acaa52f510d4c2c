"""Draw the proof: hypotheses, constants, lemmas and rows, and which uses which."""

from __future__ import annotations

import os

from verify.cli.files import test_folder, write_all
from verify.cli.options import Options, Usage
from verify.cli.proofs import MAIN, outcome_of
from verify.wire.inputs import InputError, shown

ENDINGS = (".svg", ".dot", ".json")


USAGE = Usage(
    {
        "[folder]": f"a folder with a certificate, or step, flow, sharper, … (default: {MAIN})",
        "--out FILE": "FILE.svg, .dot or .json",
    },
    required=("--out",),
)


def run(options: Options) -> int:
    """Write the drawing; return 0."""
    ending = os.path.splitext(options.out)[1]
    if ending not in ENDINGS:
        raise InputError(f"--out: {shown(options.out)} must end in .svg, .dot or .json")
    directory, name = os.path.split(options.out)
    test_folder("--out", directory or ".", name)
    from verify.views import graph  # loaded only where it is used

    found = graph.graph(outcome_of(MAIN if options.folder is None else options.folder))
    text = {".svg": graph.to_svg, ".dot": graph.to_dot, ".json": graph.to_json}[ending](found)
    write_all("--out", directory or ".", {name: text.encode()})
    print(f"written  {options.out}: {len(found.vertices)} vertices, {len(found.edges)} edges")
    return 0
