"""The certificate of a scene: with as many bits as the checker's intervals need."""

from __future__ import annotations

import sys

from verify.cli.errors import OwnError, UnreadError
from verify.cli.files import write_certificate
from verify.jobs.inputs import InputError
from verify.jobs.scene import scene_outcome
from verify.prover.program import UndefinedError
from verify.prover.scene import DISPERSES, UNDECIDED, Fate

#: The prover is exact where numbers stay rational; the checker may need more bits for the same.
MORE_BITS = (1, 2, 4, 8, 16)
#: More than MANY collisions are checked with few bits first.
MANY, FEW_BITS = 500, 80


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
        raise InputError(_too_many(option, found))
    complaint = OwnError("no precision suffices to evaluate the constants of the scene")
    for bits in precisions(found):
        try:
            write_certificate(option, directory, scene_outcome(found, bits))
        except UndefinedError:
            continue
        except UnreadError as error:
            raise InputError(_too_many(option, found)) from error
        except OwnError as error:
            complaint = error
            continue
        return
    raise complaint


def precisions(found: Fate) -> list[int]:
    """The precisions to try, in turn: few bits for many collisions, as work is limited."""
    bits = found.flow.bits
    few = [FEW_BITS] if len(found.flow.collisions) > MANY and bits > FEW_BITS else []
    return [*few, *(factor * bits for factor in MORE_BITS)]


def _too_many(option: str, found: Fate) -> str:
    return (
        f"{option}: {found.collisions} collisions are more than the checker is willing to follow; "
        "leave it out"
    )
