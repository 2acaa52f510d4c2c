"""Write a certificate for the proof assistant Coq, or its statement as a page of constants."""

from __future__ import annotations

import os
import sys
from hashlib import sha256

from verify.check import Folder
from verify.cli.check import LONGEST_PATH, folders_at
from verify.cli.options import Options, Usage
from verify.wire.inputs import InputError, shown

SYSTEMS = ("coq", "text")


USAGE = Usage(
    {
        "system": "coq; or text, the page that verify prove reads",
        "folder": "a folder with a statement and its certificate, or one of step, theorem1-all, …",
        "--readable": "also every constant as a definition, and every row as a lemma in ordinary "
        "notation",
        "--balls": "end with the theorem on three balls: theorem1, or a scene",
    },
    choices={"system": SYSTEMS},
)


def run(options: Options) -> int:
    """Print the file; return 0."""
    if options.system not in SYSTEMS:
        raise InputError(f"system: {shown(options.system)} is not known; write coq or text")
    folder = _named(options.folder)
    if options.system == "text":
        return _print_page(folder, options)
    from verify.spheres.coq.motion import about_balls  # loaded only where they are used
    from verify.wire.coq.export import export
    from verify.wire.coq.reading import NotAcceptedError

    try:
        text = export(
            folder, ordinary=options.readable, ending=about_balls if options.balls else None
        )
    except NotAcceptedError as error:
        what = "cannot be exported"
        reason = " ".join(str(error).split())[:300]
        raise InputError(f"folder: {shown(options.folder)} {what} ({reason})") from error
    sys.stdout.write(text)
    return 0


def _named(path: str) -> Folder:
    """The certificate of a name. One that comes with the program has what it cites beside it.

    Raises:
        InputError: if it is the name of none, or of several.
    """
    folder, *others = folders_at([path])
    if others and os.path.lexists(path):
        one = shown(folder.path, LONGEST_PATH)
        raise InputError(
            f"folder: {shown(path)} has {len(others) + 1} certificates; name one, such as {one}"
        )
    if not others:
        return folder  # with what lies in it to be cited
    proofs = [(other.statement, other.certificate) for other in others]
    return folder._replace(cited=[other.statement for other in others], proofs=proofs)


def _print_page(folder: Folder, options: Options) -> int:
    """Print the statement of a folder as a page of constants; return 0."""
    from verify.wire.questions import read_questions  # loaded only where they are used
    from verify.wire.text.write_page import page_text

    if options.balls:
        raise InputError("--balls: leave it out with text, which has no proofs")
    if options.readable:
        raise InputError("--readable: leave it out with text, which is readable")
    cited = {sha256(content).hexdigest(): content for content in folder.cited}
    sys.stdout.write(page_text(read_questions(folder.statement, cited)))
    return 0
