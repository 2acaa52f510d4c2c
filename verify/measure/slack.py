"""Bounds of Theorem 1 for all parameters that the program can prove with a tenth to spare."""

from __future__ import annotations

from typing import Any

from verify.paper.commands.slack import SHARE, find_slack

#: What the quick form looks at.
SOME = ("repaired.y-ratio", "repaired.zeta-ratio", "repaired.zeta-main", "repaired.x-improved")


def slack_table(quick: bool) -> dict[str, Any]:
    """A line for each bound with slack, and how many bounds were looked at."""
    found = find_slack(SOME if quick else None)
    rows = [
        [bound.row.name, bound.row.label, bound.row.says]
        for bound in found.bounds
        if bound.row.name in found.slack
    ]
    title = (
        f"Bounds with slack: with {SHARE} of the larger side {len(found.accepted)} of "
        f"{len(found.bounds)} are proved by the committed proofs, these {len(rows)} by others"
    )
    return {"title": title, "columns": ["bound", "label", "what it says"], "rows": rows}
