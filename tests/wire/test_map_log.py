"""The header of a log names the code that decided its boxes."""

from __future__ import annotations

from fractions import Fraction
from hashlib import sha256
from pathlib import Path

from verify.jobs.map import Target, grow
from verify.jobs.map_workers import workers
from verify.paper.map.planes import Phi
from verify.wire.map_log import CODE, Progress

ROOT = Path(__file__).parents[2]
LOG = ROOT / "certificates" / "map" / "map.jsonl"
#: What a verdict and its numbers depend on.
DECIDING = (
    "paper/flow/law.py",
    "paper/map/planes.py",
    "paper/map/strip.py",
    "paper/sharper/numbers.py",
    "prover/map_boxes.py",
    "prover/map_branches.py",
    "prover/map_closing.py",
    "prover/map_intervals.py",
    "prover/map_models.py",
)
#: Of these files, for each code. Where one of them has changed: the next code, or, if no verdict
#: and no number can have changed, another digest for this code.
DIGESTS = {2: "5e2adadb6830ff5383d19c10f603240362138f20392e4c8ffa29f5c8d2d4dff8"}


def test_other_code_has_another_number() -> None:
    whole = sha256()
    for name in DECIDING:
        whole.update((ROOT / "verify" / name).read_bytes())
    assert whole.hexdigest() == DIGESTS[CODE], "see DIGESTS"


def test_the_committed_map_is_what_this_code_writes() -> None:
    progress = Progress(Phi(Fraction(3, 100), Fraction(1)))
    lines = [progress.header]
    with workers(1, None) as staff:
        for _ in grow(progress, Target(Fraction(1, 500), 10**6, 20), staff, lines.append):
            pass
    assert b"".join(lines) == LOG.read_bytes()
