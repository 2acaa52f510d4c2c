"""The stored certificates: ``python -m tests.lies.store`` writes them again."""

from __future__ import annotations

from pathlib import Path

from tests.lies.lies import LIES, row
from tests.lies.small import honest, pack, write

FOLDER = Path(__file__).parents[1] / "certificates"
STORED = {
    "incorrect": (
        "a-bound-moved-by-its-last-digit",
        "a-cut-missing",
        "a-witness-on-the-boundary",
        "an-enclosure-shrunk-to-a-disjoint-one",
        "an-entry-that-makes-the-claim-easier",
        "a-needed-row-as-a-negation",
    ),
    "malformed": (
        "a-forged-digest",
        "a-key-twice",
        "an-enclosure-that-is-nan",
        "an-interval-without-points",
        "an-unknown-rule",
        "no-obligations",
    ),
}


def correct() -> dict[str, tuple[bytes, bytes]]:
    """Pairs that check, by name."""
    statement, certificate = honest()
    row(statement, "interval")["claim"][0] = "<="
    spare, spare_certificate = honest()
    for document, key in ((spare, "obligations"), (spare_certificate, "proofs")):
        document[key] = document[key][:1]
    return {
        "honest": pack(*honest()),
        "one-obligation": pack(spare, spare_certificate),
        "strict-turned-weak": pack(statement, certificate),
    }


def stored() -> dict[Path, tuple[bytes, bytes]]:
    """The files of every stored folder."""
    pairs = {FOLDER / "correct" / name: files for name, files in correct().items()}
    for kind, names in STORED.items():
        pairs |= {FOLDER / kind / name: LIES[name].files() for name in names}
    return pairs


if __name__ == "__main__":
    for folder, files in stored().items():
        write(folder, files)
