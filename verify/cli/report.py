"""Write the report: certificates/index.html with its pages, and a LaTeX table."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Mapping

from verify.cli.files import test_folder, write_all
from verify.cli.made import DIFFERS, SAME, STALE, WRITTEN, Made
from verify.cli.options import JSON, Options, Usage
from verify.cli.steps import Steps
from verify.cli.terminal import erase
from verify.language.record import TYPE_CHECKING
from verify.paper.commands.report_files import MAX_BYTES
from verify.wire.inputs import InputError, regular_file, shown

if TYPE_CHECKING:
    from typing import Any

#: The exit code of input that cannot be used.
UNUSABLE = 2
#: What is compared.
PAGES = ("index.html", "constants.tex")
#: Where the pages are that lead on from the first one; nothing else is there.
FOLDER = "pages"


USAGE = Usage(
    {
        "--directory DIR": "where the certificates are and the report goes (default certificates)",
        "--compare": "write nothing and draw nothing: exit 1 if anything but the drawings "
        "themselves would change",
        **JSON,
    },
    {"directory": "certificates"},
)


def run(options: Options) -> int:
    """Write or compare the files; return 0, 1 if a compared one differs, or the checker's code."""
    if not os.path.isdir(options.directory):
        raise InputError(
            f"--directory: {shown(options.directory)} is not a folder; name the certificates"
        )
    if not options.compare:
        test_folder("--directory", options.directory, "index.html")
    else:
        for name in PAGES:
            _read(os.path.join(options.directory, name))  # said before the long work
    from verify.paper.commands.report import number_of_steps, read_material
    from verify.paper.commands.report_files import CertificateError
    from verify.views.page.build import files

    told = Made("report", options)
    try:
        progress = Steps(number_of_steps(options.directory, draw=not options.compare))
        material = read_material(options.directory, progress)
    except CertificateError as error:
        if error.code == UNUSABLE:
            raise InputError(str(error)) from error
        print(f"verify: {error}", file=sys.stderr)
        return told.end(error.code, str(error))
    if not options.compare:
        progress("drawing")
    made = files(material, draw=not options.compare)
    erase()
    if not options.compare:
        write_all("--directory", options.directory, made)
        for name in _old_pages(options.directory) - made.keys():
            os.remove(os.path.join(options.directory, name))
        for name in made:
            told(WRITTEN, os.path.join(options.directory, name))
        return told.end(0)
    differing = _differing(options.directory, made, told)
    stale = _stale(options.directory, material.measurements, told)
    return told.end(1 if stale or differing else 0)


def _differing(directory: str, made: Mapping[str, bytes], told: Made) -> int:
    """How many of the files differ, or are there and no longer made; each has been told."""
    differing = 0
    for name, content in made.items():
        path = os.path.join(directory, name)
        same = without_drawings(_read(path)) == without_drawings(content)
        differing += not same
        told(SAME if same else DIFFERS, path)
    for name in sorted(_old_pages(directory) - made.keys()):
        differing += 1
        told(DIFFERS, os.path.join(directory, name), "no such page is made now")
    return differing


def _stale(directory: str, measurements: Mapping[str, dict[str, Any]], told: Made) -> bool:
    """Whether the speeds are not those that `verify bench` measures now; why has been told."""
    if "bench" not in measurements:
        return False
    from verify.measure.bench import out_of_date  # loads mpmath

    folder = os.path.join(directory, "data")
    reasons = out_of_date(measurements["bench"])
    if reasons:
        path = os.path.join(folder, "bench.json")
        remedy = f"write it anew with verify bench --out {folder}"
        told(STALE, path, f"{'; '.join(reasons)}; {remedy}")
    return bool(reasons)


def _old_pages(directory: str) -> set[str]:
    """The files in the folder of the pages, by their names from the report's folder."""
    folder = os.path.join(directory, FOLDER)
    return {f"{FOLDER}/{name}" for name in os.listdir(folder)} if os.path.isdir(folder) else set()


def without_drawings(page: bytes) -> bytes:
    """The page without what is inside its SVG elements, which nothing draws to compare it.

    Captions stay, and with them the numbers of cells, of verdicts and of boxes.
    """
    return re.sub(rb"<svg .*?</svg>\n?", b"", page, flags=re.DOTALL)


def _read(path: str) -> bytes:
    try:
        return regular_file(path, MAX_BYTES)
    except (OSError, ValueError) as error:
        raise InputError(
            f"--compare: {path!r} cannot be read; write it with verify report"
        ) from error
