"""The certificate of a scene: with as many bits as the checker's intervals need."""

from __future__ import annotations

import sys
from collections.abc import Mapping

from verify.cli.files import write_certificate
from verify.language.errors import OwnError, UnreadError
from verify.paper.commands.scene import precisions, scene_outcome
from verify.prover.program import UndefinedError
from verify.spheres.scene.decide import DISPERSES, UNDECIDED, Fate
from verify.wire.inputs import InputError


def write_scene(
    option: str, directory: str, found: Fate, beside: Mapping[str, bytes] | None = None
) -> None:
    """Write the certificate, which `verify/check.py` accepts.

    ``beside`` are other files of the same folder. Nothing is written, with a line on stderr,
    where the scene is undecided.

    Raises:
        OwnError: if the checker does not accept it with any of the precisions.
    """
    if found.verdict == UNDECIDED:
        print("verify: the scene is undecided; no certificate was written", file=sys.stderr)
        return
    if found.line is not None and found.verdict == DISPERSES:
        raise InputError(_too_many(option, found))
    complaint = OwnError("no precision suffices to evaluate the constants of the scene")
    for bits in precisions(found):
        try:
            write_certificate(option, directory, scene_outcome(found, bits), beside)
        except UndefinedError:
            continue
        except UnreadError as error:
            raise InputError(_too_many(option, found)) from error
        except OwnError as error:
            complaint = error
            continue
        return
    raise complaint


def _too_many(option: str, found: Fate) -> str:
    return (
        f"{option}: {found.collisions} collisions are more than the checker is willing to follow; "
        "leave it out"
    )
