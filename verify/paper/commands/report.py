"""What the report is made from: accepted certificates, and the committed measurements.

Every file is read once: the bytes that the checker accepts are those that are shown.
"""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Iterator, Mapping
from hashlib import sha256
from typing import Any

from verify import check
from verify.paper.commands import curves
from verify.paper.commands.pages import accepted
from verify.paper.commands.regenerate import is_right_when_accepted
from verify.paper.commands.repaired_theorem import whole
from verify.paper.commands.report_files import CertificateError, read_file, unusable
from verify.paper.commands.report_maps import is_strip, log_names, read_map, read_strip, story
from verify.paper.commands.scene import read_back
from verify.paper.commands.separatrix import NAME as SEPARATRIX
from verify.paper.commands.separatrix import stored_curve
from verify.paper.commands.thresholds import all_shares, bands
from verify.paper.glossary import LETTERS
from verify.paper.parameters import ALL_PARAMETERS, PRINTED, REPAIRED, THEOREM
from verify.paper.source import PAPER
from verify.prover.outcome import Outcome
from verify.views.findings import (
    CertifiedOutcome,
    CoqRecord,
    Margins,
    Material,
    Plotted,
    Region,
    Story,
)
from verify.wire.judge import with_verdicts
from verify.wire.packaged import checked
from verify.wire.read import read
from verify.wire.term_json import WireError

NAMES = ("statement.json", "certificate.json")
CITED = "cited"
SCENES = "scenes"
MEASUREMENTS = ("bench", "stress")

#: The folder of the main job, which stands first.
FIRST = "theorem1-r-3-100"


def number_of_steps(directory: str, *, draw: bool) -> int:
    """How often progress is told, until the report is drawn."""
    return len(folder_names(directory)) + len(log_names(directory)) + (2 if draw else 1)


def read_material(
    directory: str,
    progress: Callable[[str], None] = lambda _: None,
) -> Material:
    """Read and check every certificate folder and every map, and enclose what the plots show.

    Args:
        directory: where the certificates are, and the measurements if there are any.
        progress: is told what is being done.

    Raises:
        CertificateError: with the code 2 if the directory has no certificate, or a file cannot be
            used; with that of the checker if one is not accepted; with 1 if its statement is not
            the program's.
    """
    names = folder_names(directory)
    if not names:
        raise unusable(f"{directory!r} has no certificates; make them with verify certify")
    measurements, digests = _measurements(directory)
    contents = {name: _contents(os.path.join(directory, name)) for name in names}
    available = {
        sha256(content).hexdigest(): content
        for files in contents.values()
        for name, content in files.items()
        if name != NAMES[1]
    }
    folders: list[CertifiedOutcome] = []
    for name in names:
        path = os.path.join(directory, name)
        progress(f"checking {path}")
        folders.append(_folder(path, name, contents[name], available))
    maps, strips = [], []
    for name in log_names(directory):
        progress(f"reading {os.path.join(directory, name)}")
        if is_strip(directory, name):
            strips.append(read_strip(directory, name))
        else:
            maps.append(read_map(directory, name))
    if all(folder.outcome.statement.theorem != THEOREM for folder in folders):
        raise unusable(
            f"{directory!r} has no certificate of {THEOREM}; make it with verify certify"
        )
    progress("enclosing what the plots show")
    found = [f.outcome for f in folders if f.outcome.statement.theorem == ALL_PARAMETERS]
    return Material(
        PAPER,
        LETTERS,
        folders,
        maps,
        strips,
        measurements,
        digests,
        dict(_stories(folders)),
        plotted(found[0] if found else accepted("all_parameters")),
        _checked_in_coq(folders),
        whole(),
        stored_curve() if any(f.outcome.statement.theorem == SEPARATRIX for f in folders) else None,
    )


def _stories(folders: Iterable[CertifiedOutcome]) -> Iterator[tuple[str, Story]]:
    """The committed scenes that collapse."""
    for folder in folders:
        place, _, name = folder.name.partition("/")
        scene = read_back(folder.outcome.statement.parameters) if place == SCENES else None
        told = None if scene is None else story(scene)
        if told is not None:
            yield name, told


def plotted(everywhere: Outcome) -> Plotted:
    """What the plots show."""
    where = accepted("thresholds")
    return Plotted(
        Region(
            everywhere,
            accepted("printed_rows"),
            where,
            all_shares(where),
            tuple(bands(where)),
            curves.WIDTH,
            tuple(curves.threshold_boxes(400).values()),
        ),
        Margins(
            curves.intervals(),
            curves.END,
            curves.FACTOR,
            curves.ratios(PRINTED, curves.WHOLE),
            curves.ratios(REPAIRED, curves.SHARE),
        ),
        curves.roots(),
    )


def _checked_in_coq(folders: Iterable[CertifiedOutcome]) -> CoqRecord:
    record = checked()
    return CoqRecord(record.version, {one.name: record.has(one.digests) for one in folders})


def folder_names(directory: str) -> list[str]:
    """The folders of certificates in a directory, the main job's first.

    Raises:
        CertificateError: if there is no such directory.
    """
    if not os.path.isdir(directory):
        raise unusable(f"{directory!r} is not a folder; name the certificates")
    names = sorted(os.listdir(directory))
    if os.path.isdir(os.path.join(directory, SCENES)):
        names += [f"{SCENES}/{n}" for n in sorted(os.listdir(os.path.join(directory, SCENES)))]
    found = [n for n in names if os.path.exists(os.path.join(directory, n, NAMES[0]))]
    return sorted(found, key=lambda name: (name != FIRST, name))


def _contents(path: str) -> dict[str, bytes]:
    """The files of a folder: statement, certificate, and the statements that they cite."""
    folder = os.path.join(path, CITED)
    cited = sorted(os.listdir(folder)) if os.path.isdir(folder) else []
    names = [*NAMES, *(f"{CITED}/{name}" for name in cited)]
    return {name: read_file(os.path.join(path, name)) for name in names}


def _measurements(directory: str) -> tuple[dict[str, dict[str, Any]], dict[str, str]]:
    """The tables of each measurement that is there, and the digests of their files."""
    found, digests = {}, {}
    for name in MEASUREMENTS:
        path = os.path.join(directory, "data", f"{name}.json")
        if os.path.exists(path):
            content = read_file(path)
            found[name] = _tables(path, content)
            digests[f"data/{name}.json"] = sha256(content).hexdigest()
    return found, digests


def _tables(path: str, content: bytes) -> dict[str, Any]:
    try:
        tables = json.loads(content, parse_float=str)["tables"]
        for table in tables.values():
            width = len(table["columns"])
            if not isinstance(table["title"], str) or any(len(r) != width for r in table["rows"]):
                raise ValueError("a table without a title, or with a row of another width")
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise unusable(f"{path!r} has no tables ({error!r:.60})") from error
    return dict(tables)


def _folder(
    path: str, name: str, contents: Mapping[str, bytes], available: Mapping[str, bytes]
) -> CertifiedOutcome:
    statement, certificate = (contents[file] for file in NAMES)
    report = _checked(path, statement, certificate, available)
    try:
        outcome = with_verdicts(read(statement, certificate, available), report)
    except WireError as error:
        raise CertificateError(f"{path}: {error}", 4) from error
    if not is_right_when_accepted(statement, outcome):
        raise CertificateError(
            f"{path}: the statement is not the one that the program makes; run verify certify", 1
        )
    digests = {file: sha256(content).hexdigest() for file, content in contents.items()}
    return CertifiedOutcome(name, outcome, digests, check.last_line(report, {}))


def _checked(
    path: str, statement: bytes, certificate: bytes, available: Mapping[str, bytes]
) -> check.Report:
    """What the checker says.

    Raises:
        CertificateError: if it does not accept with the verdict PROVED.
    """
    try:
        report = check.check(statement, certificate, available)
    except (check.Malformed, RecursionError) as error:
        raise CertificateError(f"{path}: the checker finds it malformed ({error})", 4) from error
    if report.verdict != "PROVED":
        said = check.last_line(report, {})
        raise CertificateError(f"{path}: the checker does not accept it ({said})", 1)
    return report
