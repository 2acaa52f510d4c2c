"""Check certificates with verify/check.py; and that a theorem is the program's own."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Sequence
from fractions import Fraction
from hashlib import sha256
from typing import Any

from verify import check
from verify.cli.files import print_document
from verify.cli.options import COLOR, JSON, VERBOSE, Options, Usage
from verify.cli.steps import watched
from verify.cli.terminal import show
from verify.language.record import Record
from verify.wire.inputs import InputError, near, shown
from verify.wire.packaged import PACKAGED, PACKAGED_FILES, cited_digests, packaged_files

FORMAT = "verify-check/1"

NAMES = ("statement.json", "certificate.json")

MALFORMED = "MALFORMED"

#: How the lines of the checker begin that only say what its last line counts.
ROWS = ("proved  ", "assumed ")

#: How a rational is written in a statement.
NUMBER = re.compile(r"-?[0-9]+(/[0-9]+)?")

LONGEST_PATH = 160  # in a message


USAGE = Usage(
    {
        "path [path ...]": "folders of certificates, folders of such folders, or one "
        "statement.json and its certificate.json",
        "--statement": "also make each statement anew from its parameters, and compare it byte "
        "for byte",
        **VERBOSE,
        **JSON,
        **COLOR,
        "--latex": "print what is accepted as one LaTeX document instead of the verdicts",
        "--full": "in LaTeX also the rows that others are proved from, and all printed",
        "--markdown": "print what is accepted as a report in Markdown",
    },
    example="theorem1-all",
)


class CheckedFolder(Record):
    """What the checker found in one folder.

    ``verdict`` is undecided where something cited is not proved in this run. ``own`` says whether
    the statement is one that the program makes and calls proved; None where that was not asked, or
    the checker does not say PROVED. ``cited`` has the statements on whose sentences it rests, with
    what their names begin with here.
    """

    folder: check.Folder
    report: check.Report
    verdict: str
    lines: list[str]
    cited: list[tuple[str, bytes]]
    own: bool | None = None

    @property
    def code(self) -> int:
        """The exit code of this folder alone."""
        return check.EXIT_CODES[self.judged]

    @property
    def judged(self) -> str:
        """The verdict, also about whose statement it is."""
        return MALFORMED if self.own is False else self.verdict


def run(options: Options) -> int:
    """Check, and return the worst exit code of all folders."""
    kinds = [f"--{kind}" for kind in ("latex", "markdown", "json") if getattr(options, kind)]
    if options.full and not options.latex:
        raise InputError("--full: write it with --latex; without, -v prints every row")
    if len(kinds) > 1:
        raise InputError(f"{kinds[0]}: leave it out with {kinds[1]}; each is a document of its own")
    found = judge_folders(folders_at(options.path))
    if options.statement:
        found = [_compared(judged) for judged in found]
    if options.latex or options.markdown:
        return _print_report(found, latex=options.latex, full=options.full)
    if options.json:
        print_document({"format": FORMAT, "command": "check", "folders": list(map(_row, found))})
    else:
        show(_lines(found, every=options.verbose), options, records=True)
    return check.exit_code(judged.judged for judged in found)


def _print_report(found: Sequence[CheckedFolder], *, latex: bool, full: bool) -> int:
    """Print the document if everything is accepted, else say on stderr what is not."""
    refused = [judged for judged in found if judged.code and judged.verdict != "REFUTED"]
    for judged in refused:
        why = "not a statement of the program" if judged.own is False else judged.lines[-1]
        print(f"verify: {judged.folder.path}: {why}"[:300], file=sys.stderr)
    if not refused:
        from verify.paper.commands.repaired_theorem import whole  # loaded only where they are used
        from verify.paper.parameters import ALL_PARAMETERS
        from verify.paper.source import PAPER
        from verify.views.all_parameters import latex as theorem_tex
        from verify.views.markdown import report
        from verify.views.tex.article import tex_document
        from verify.wire.judge import read_judged
        from verify.wire.term_json import WireError

        folders = [judged.folder for judged in found]
        cited = available(folders)
        try:
            read = (read_judged(f.statement, f.certificate, cited) for f in folders)
            if latex:
                told = {ALL_PARAMETERS: lambda: theorem_tex(whole())}
                texts = [tex_document(read, PAPER, told, full=full)]
            else:
                is_sent = (os.path.isfile(os.path.join(f.path, "check.py")) for f in folders)
                both = zip(read, is_sent, strict=True)
                texts = [report(one, PAPER, is_sent=sent) for one, sent in both]
        except WireError as error:
            print(f"verify: {error}"[:300], file=sys.stderr)
            return check.EXIT_CODES[MALFORMED]
        sys.stdout.write("\n".join(texts))
    return check.exit_code(judged.judged for judged in found)


def folders_at(paths: Sequence[str]) -> list[check.Folder]:
    """What is to be checked; each file is read once, here.

    A folder without files of a certificate stands for the certificates in the folders below it; a
    name that is no path, for the certificate with this name that comes with the program.

    Raises:
        InputError: for a path that is missing, or no certificate and without one below it.
    """
    paths = [path for name in paths for path in _packaged(name)]
    pair = len(paths) == 2 and not any(map(os.path.isdir, paths))
    if not pair:
        paths = [folder for path in dict.fromkeys(paths) for folder in _below(path)]
    for path in paths:
        if not pair and not os.path.isdir(path):
            what = "is a file" if os.path.exists(path) else "does not exist"
            meant = near(path, PACKAGED_FILES) or "theorem1-all"
            raise InputError(
                f"path: {shown(path)} {what}; name a folder with {' and '.join(NAMES)}, or a "
                f"certificate that comes with the program, such as {meant}"
            )
        for name in paths if pair else [os.path.join(path, name) for name in NAMES]:
            if not os.path.isfile(name):
                quoted = shown(name, LONGEST_PATH)
                what = "is no file" if os.path.exists(name) else "does not exist"
                raise InputError(f"path: {quoted} {what}; name a certificate's folder")
    try:
        return check.read_folders(paths)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise InputError(
            f"path: {shown(paths[0])} cannot be read ({reason}); name a folder"
        ) from error


def _packaged(path: str) -> list[str]:
    """The path; or, where nothing lies there, what comes with the program, and what that cites."""
    if path not in PACKAGED_FILES or os.path.lexists(path):
        return [path]
    names = {files["statement.json"]: name for name, files in PACKAGED_FILES.items()}
    cited = [names[digest] for digest in cited_digests(packaged_files(path)[0])]
    return [os.path.join(PACKAGED, path), *(found for name in cited for found in _packaged(name))]


def _below(path: str) -> list[str]:
    """The folders below a folder with a file of a certificate, or the path itself.

    Hidden ones are left out: a run that was killed may have left one that is not whole.
    """
    found = []
    for folder, inner, files in os.walk(path):
        if set(NAMES) & {*files, *inner}:
            found.append(folder)
            inner.clear()  # what it cites lies there
        inner[:] = sorted(name for name in inner if not name.startswith("."))
    return found or [path]


def judge_folders(folders: Sequence[check.Folder]) -> list[CheckedFolder]:
    """Check folders of which some may cite others, as `verify/check.py` does."""
    statements = available(folders)
    found = list(watched(check.judged(folders), len(folders)))
    closed = check.closed_by(found)
    results = []
    for folder, (report, _) in zip(folders, found, strict=True):
        verdict, lines = check.verdict(report, closed), check.conclusion(report, closed)
        cited = [(f"{c.name}:", statements[c.digest]) for c in check.rests_on(report)]
        results.append(CheckedFolder(folder, report, verdict, lines, cited))
    return results


def available(folders: Sequence[check.Folder]) -> dict[str, bytes]:
    """The statements that may be cited, by their digests."""
    everything = [data for folder in folders for data in (folder.statement, *folder.cited)]
    return {sha256(data).hexdigest(): data for data in everything}


def _compared(judged: CheckedFolder) -> CheckedFolder:
    """With the answer whether a proved theorem is the program's own, from the same bytes."""
    if judged.report.verdict != "PROVED":
        return judged
    from verify.paper.commands.regenerate import is_right_statement  # loads flint

    return judged._replace(own=is_right_statement(judged.folder.statement))


def _lines(found: Sequence[CheckedFolder], *, every: bool) -> list[str]:
    """What the checker says of each folder; not every row, unless that is asked for."""
    lines = []
    for judged in found:
        if len(found) > 1:
            lines.append(f"{judged.folder.path}:")
        lines += judged.lines if every else map(_brief, _told(judged.lines))
        if judged.own is not None:
            verb = "is" if judged.own else "is not"
            why = "" if judged.own else _out_of_range(judged.folder.statement)
            what = f"the one that the program makes and calls proved{why}"
            lines.append(f"STATEMENT: it {verb} {what}")
    return [line if line.isprintable() else ascii(line) for line in lines]


def _told(lines: Sequence[str]) -> list[str]:
    return [line for line in lines if not line.startswith(ROWS)]


def _brief(line: str) -> str:
    """A line without the counts that are 0."""
    return re.sub(r", 0 (needed|printed) (proved|refuted|undecided)", "", line)


def _out_of_range(statement: bytes) -> str:
    """That r, if the statement has one, is not in (0, 1)."""
    import json  # loaded only where it is used

    text = json.loads(statement)["parameters"].get("r")
    is_number = isinstance(text, str) and NUMBER.fullmatch(text)
    return (
        f": its r = {text:.60} is not in (0, 1)" if is_number and not 0 < Fraction(text) < 1 else ""
    )


def _row(judged: CheckedFolder) -> dict[str, Any]:
    """One folder of the document."""
    verdict = judged.verdict
    row: dict[str, Any] = {"path": judged.folder.path, "verdict": verdict.lower()}
    row |= {"title": None, "needed": None, "printed": None}
    row |= {"assumptions": [], "assumptions_of_printed_rows": []}
    if verdict != MALFORMED:
        row |= _content(judged)
    if verdict == "REFUSED":  # what the statement claims is not counted as if it were shown
        row |= {"needed": None, "printed": None}
    row["complaints"] = [
        line for line in judged.lines if line.startswith(("REFUSED ", f"{MALFORMED}: "))
    ]
    row["summary"] = judged.lines[-1]
    return row if judged.own is None else row | {"own_statement": judged.own}


def _content(judged: CheckedFolder) -> dict[str, Any]:
    """What a statement that the checker has read is about, and what it is given."""
    import json  # loaded only where it is used

    from verify.language.statement import PROVED, REFUTED, UNDECIDED

    document = json.loads(judged.folder.statement)
    found: dict[str, Any] = {"title": document["title"]}
    for role in ("needed", "printed"):
        rows = [row["verdict"] for row in document["obligations"] if row["role"] == role]
        found[role] = {verdict: rows.count(verdict) for verdict in (PROVED, REFUTED, UNDECIDED)}
    own, apart = _assumptions("", document), judged.report.printed
    cited = [item for name, data in judged.cited for item in _assumptions(name, json.loads(data))]
    found["assumptions"] = [item for item in own if item["name"] not in apart] + cited
    found["assumptions_of_printed_rows"] = [item for item in own if item["name"] in apart]
    return found


def _assumptions(prefix: str, statement: dict[str, Any]) -> list[dict[str, Any]]:
    from verify.language.statement import Assumption
    from verify.views.document import assumption_document

    items = [item | {"name": prefix + item["name"]} for item in statement["assumptions"]]
    return [assumption_document(Assumption(**item)) for item in items]
