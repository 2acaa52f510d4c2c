"""Draw the proof: hypotheses, constants, lemmas and rows, and which uses which."""

from __future__ import annotations

import os

from verify.cli.files import progress, read_bytes, test_folder, write_all
from verify.cli.options import Options, Parser
from verify.jobs.inputs import InputError, shown
from verify.prover.outcome import Outcome

ENDINGS = (".svg", ".dot", ".json")


def add_arguments(parser: Parser) -> None:
    """The options."""
    text = "a folder with a certificate (default: Theorem 1, --all)"
    parser.place("folder", text, required=False)
    parser.option("--out", "FILE.svg, .dot or .json", "FILE", required=True)


def run(options: Options) -> int:
    """Write the drawing; return 0."""
    ending = os.path.splitext(options.out)[1]
    if ending not in ENDINGS:
        raise InputError(f"--out: {shown(options.out)} must end in .svg, .dot or .json")
    directory, name = os.path.split(options.out)
    test_folder("--out", directory or ".", name)
    from verify.views import graph  # loaded only where it is used

    found = graph.graph(outcome_of(options.folder))
    text = {".svg": graph.to_svg, ".dot": graph.to_dot, ".json": graph.to_json}[ending](found)
    write_all("--out", directory or ".", {name: text.encode()})
    print(f"written  {options.out}: {len(found.vertices)} vertices, {len(found.edges)} edges")
    return 0


def outcome_of(folder: str | None) -> Outcome:
    """The outcome in a folder, as it is written there; by default Theorem 1 for all parameters."""
    if folder is None:
        from verify.jobs import everywhere

        progress("proving Theorem 1 for all parameters")
        return everywhere.decide_everywhere()
    from verify.wire.read import read
    from verify.wire.term_json import WireError
    from verify.wire.write import digest

    names = ("statement.json", "certificate.json")
    first, second = (read_bytes("folder", os.path.join(folder, name)) for name in names)
    cited = os.path.join(folder, "cited")
    paths = sorted(os.listdir(cited)) if os.path.isdir(cited) else []
    contents = [read_bytes("folder", os.path.join(cited, path)) for path in paths]
    try:
        return read(first, second, {digest(content): content for content in contents})
    except WireError as error:
        raise InputError(f"folder: {shown(folder)} has no certificate ({error})") from error
