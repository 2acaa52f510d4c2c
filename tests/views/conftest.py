"""The committed report, and one that is built once, with coarse plots."""

from __future__ import annotations

import json
import shutil
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from verify import check_map
from verify.cli.certify import folder_files
from verify.cli.files import write_all
from verify.paper.commands import report
from verify.paper.commands.certificates import all_folders
from verify.prover.outcome import Outcome
from verify.views.findings import CertifiedOutcome, Plotted
from verify.views.page.build import files

Files = Mapping[str, bytes]

TABLE = {
    "title": "Time and width",
    "columns": ["bits", "arb: ms", "arb: width", "iv: ms", "iv: width"],
    "rows": [
        [53, "1.5", "3.1e-12", "20", "4.0e-12"],
        [128, 2, "1.0e-35", "25", "2e-35"],
        [4096, "30", "1.0e-1230", "—", "—"],
    ],
}
BENCH: dict[str, Any] = {"command": "bench", "tables": {"precision": TABLE}}


@pytest.fixture(scope="session", autouse=True)
def checked_once() -> Iterator[None]:
    """A folder is checked and read once for the same bytes: the pages here are built many times.

    So is a map; and what is drawn is computed once for the same outcome.
    """
    known: dict[object, CertifiedOutcome] = {}
    maps: dict[object, tuple[Any, Any]] = {}
    drawn: dict[int, tuple[Outcome, Plotted]] = {}
    check, check_log, plotted = report._folder, check_map.check_log, report.plotted

    def folder(path: str, name: str, contents: Files, available: Files) -> CertifiedOutcome:
        key = (name, *sorted(contents.items()), *sorted(available.items()))
        if key not in known:
            known[key] = check(path, name, contents, available)
        return known[key]

    def read_log(lines: Iterable[bytes], most: int | None = check_map.MAX_WORK) -> tuple[Any, Any]:
        key = (*lines, most)
        if key not in maps:
            maps[key] = check_log(iter(key[:-1]), most)
        return maps[key]

    def plot(everywhere: Outcome) -> Plotted:
        key = id(everywhere)
        if key not in drawn:
            drawn[key] = everywhere, plotted(everywhere)
        return drawn[key][1]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(report, "_folder", folder)
        patch.setattr(report, "plotted", plot)
        patch.setattr(check_map, "check_log", read_log)
        yield


def few_boxes(log: bytes) -> bytes:
    """The beginning of a log: its plane, and four levels of boxes."""
    return b"".join(log.splitlines(keepends=True)[:5])


def build(directory: Path, draw: bool) -> dict[str, bytes]:
    return files(report.read_material(str(directory)), draw=draw)


def pages_of(made: Path) -> dict[str, str]:
    """The pages of a report, by their names, in no other order than that of their files."""
    found = [made / "index.html", *sorted((made / "pages").glob("*.html"))]
    return {str(path.relative_to(made)): path.read_text(encoding="utf-8") for path in found}


@pytest.fixture(scope="session")
def page(made: Path) -> str:
    """All pages of the report, one after the other."""
    return "\n".join(pages_of(made).values())


@pytest.fixture(scope="session")
def made() -> Path:
    """The committed report, which is what people see; CI compares it with what is made now."""
    return Path(__file__).parents[2] / "certificates"


@pytest.fixture(scope="session")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of certificates and measurements with its report."""
    directory = tmp_path_factory.mktemp("certificates")
    for folder, outcome in all_folders():
        contents = folder_files(outcome)
        write_all("--directory", str(directory / folder), contents)
    (directory / "data").mkdir()
    (directory / "data" / "bench.json").write_text(json.dumps(BENCH), encoding="utf-8")
    (directory / "map").mkdir()
    maps = Path(__file__).parents[2] / "certificates" / "map"
    (directory / "map" / "map.jsonl").write_bytes(few_boxes((maps / "map.jsonl").read_bytes()))
    shutil.copytree(maps / "strip", directory / "map" / "strip")
    pages = build(directory, draw=True)
    write_all("--directory", str(directory), pages)
    return directory
