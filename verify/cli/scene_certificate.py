"""The certificate of a scene: with as many bits as the checker's intervals need."""

from __future__ import annotations

import sys

from verify.cli.errors import OwnError
from verify.cli.files import write_certificate
from verify.jobs.inputs import InputError
from verify.jobs.scene import scene_outcome
from verify.prover.program import UndefinedError
from verify.prover.scene import DISPERSES, UNDECIDED, Fate

#: The prover is exact where numbers stay rational; the checker may need more bits for the same.
MORE_BITS = (1, 2, 4, 8, 16)


def write_scene(option: str, directory: str, found: Fate) -> None:
    """Write the certificate, which `verify/check.py` accepts.

    Nothing is written, with a line on stderr, where the scene is undecided.

    Raises:
        OwnError: if the checker does not accept it with any of the precisions.
    """
    if found.verdict == UNDECIDED:
        print("verify: the scene is undecided; no certificate was written", file=sys.stderr)
        return
    if found.line is not None and found.verdict == DISPERSES:
        raise InputError(
            f"{option}: {found.collisions} collisions on a line are more than a certificate can "
            "show; leave it out"
        )
    complaint = OwnError("no precision suffices to evaluate the constants of the scene")
    for factor in MORE_BITS:
        try:
            outcome = scene_outcome(found, factor * found.flow.bits)
            write_certificate(option, directory, outcome)
        except UndefinedError:
            continue
        except OwnError as error:
            complaint = error
            continue
        return
    raise complaint
