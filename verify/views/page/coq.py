"""Which certificates of the page Coq has checked, with its version and the time."""

from __future__ import annotations

from verify.views.material import Material
from verify.views.page.blocks import Cell, Code, Text


def checked_in_coq(material: Material) -> Cell:
    """All, or how many and which not: a file that has changed since is not counted."""
    record = material.coq
    found = [record.seconds[folder.name] for folder in material.folders]
    times = [seconds for seconds in found if seconds is not None]
    both = zip(material.folders, found, strict=True)
    missing = [folder.name for folder, seconds in both if seconds is None]
    number = f"{len(times)} of {len(found)}" if missing else f"all {len(times)}"
    but = f"; not {', '.join(missing)}, which may have changed since" if missing else ""
    return [
        Text(f"accepted {number} certificates, with Coq {record.version} in {sum(times)} s{but}; "),
        Code(".ci/coq --record"),
        Text(" does it again"),
    ]
