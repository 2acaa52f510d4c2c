"""The header of a log names the code that decided its boxes."""

from __future__ import annotations

from fractions import Fraction
from hashlib import sha256
from pathlib import Path

from verify.spheres.map.grow import Target, grow
from verify.spheres.map.log import CODE, FREE_CODE, Progress
from verify.spheres.map.planes import Phi
from verify.spheres.map.workers import workers

ROOT = Path(__file__).parents[3]
LOG = ROOT / "certificates" / "map" / "map.jsonl"
#: What a verdict and its numbers depend on.
DECIDING = (
    "spheres/flow/law.py",
    "spheres/map/planes.py",
    "spheres/map/strip.py",
    "data/sharper/statement.json",
    "spheres/map/boxes.py",
    "spheres/map/branches.py",
    "spheres/map/closing.py",
    "spheres/map/intervals.py",
    "spheres/map/models.py",
    "spheres/map/trees.py",
)
#: Of these files, for each code. Where one of them has changed: the next code, or, if no verdict
#: and no number can have changed, another digest for this code.
DIGEST = "295b98130bf0ae532b4e1d17c39d4be8fa93d1b35d54dc607634fa87adaa5927"
DIGESTS = {2: DIGEST, 7: DIGEST}


def test_other_code_has_another_number() -> None:
    whole = sha256()
    for name in DECIDING:
        whole.update((ROOT / "verify" / name).read_bytes())
    for code in (CODE, FREE_CODE):
        assert whole.hexdigest() == DIGESTS[code], "see DIGESTS"


def test_the_committed_map_is_what_this_code_writes() -> None:
    progress = Progress(Phi(Fraction(3, 100), Fraction(1)))
    lines = [progress.header]
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(1, 500), 10**6, 20), staff, lines.append):
            pass
    assert b"".join(lines) == LOG.read_bytes()
