"""The certificate of a scene: with as many bits as the checker's intervals need."""

from __future__ import annotations

from collections.abc import Mapping

from verify.cli.files import UncheckableError, write_certificate
from verify.language.errors import OwnError, UnreadError
from verify.paper.commands.scene import precisions, scene_outcome
from verify.spheres.scene.decide import DISPERSES, UNDECIDED, Fate

#: The checker follows so many collisions; where it reads no further, something else is wrong.
SURELY_FEW = 50


def write_scene(
    option: str, directory: str, found: Fate, beside: Mapping[str, bytes] | None = None
) -> str:
    """Write the certificate, which `verify/check.py` accepts; why not, where there can be none.

    ``beside`` are other files of the same folder. Without a certificate nothing is written.

    Raises:
        OwnError: if the checker does not accept it, and not because of its length.
    """
    if found.verdict == UNDECIDED:
        return "the scene is undecided"
    if found.line is not None and found.verdict == DISPERSES:
        return _too_many(found)
    complaint = OwnError("no precision suffices to evaluate the constants of the scene")
    for bits in precisions(found):
        try:
            write_certificate(option, directory, scene_outcome(found, bits), beside)
        except UnreadError:
            if bits < found.flow.bits:  # too few bits can be more work than enough of them
                continue
            if found.collisions <= SURELY_FEW:
                raise
            return _too_many(found)
        except UncheckableError as error:
            return error.why
        except OwnError as error:
            complaint = error
            continue
        return ""
    raise complaint


def _too_many(found: Fate) -> str:
    return f"{found.collisions} collisions are more than the checker is willing to follow"
