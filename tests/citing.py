"""The statements that are cited beside a certificate, for tests that read or check it."""

from __future__ import annotations

from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path


def cited(files: Mapping[str, bytes]) -> dict[str, bytes]:
    """By their digests, from the files of a folder by their names there."""
    inside = (content for name, content in files.items() if name.startswith("cited/"))
    return {sha256(content).hexdigest(): content for content in inside}


def cited_in(folder: Path) -> dict[str, bytes]:
    """By their digests, from a folder."""
    return cited({f"cited/{p.name}": p.read_bytes() for p in folder.glob("cited/*.json")})
