"""What Coq has checked, as `.ci/coq --record` has written it down."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from importlib.resources import files
from typing import NamedTuple


class Checked(NamedTuple):
    """The version of Coq, and for each pair of statement and certificate the seconds it took."""

    version: str
    seconds: dict[tuple[str, str], int]

    def of(self, pairs: Iterable[Mapping[str, str]]) -> list[int | None]:
        """For each pair the seconds, or none if Coq has not checked these very files.

        A pair is given by the digests of its files.
        """
        return [
            self.seconds.get((digests["statement.json"], digests["certificate.json"]))
            for digests in pairs
        ]


def checked() -> Checked:
    """The committed record."""
    text = files("verify").joinpath("data/coq.json").read_text(encoding="utf-8")
    record = json.loads(text)
    return Checked(
        record["coq"],
        {
            (item["statement_sha256"], item["certificate_sha256"]): item["seconds"]
            for item in record["certificates"]
        },
    )
