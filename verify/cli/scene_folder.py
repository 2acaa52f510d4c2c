"""A folder of scenes: one line each, in the order of their names, by several processes if asked."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from hashlib import sha256

from verify.cli.files import print_document, read_bytes, write_file, write_folder
from verify.cli.options import Options, leave_out
from verify.cli.scene_certificate import write_scene
from verify.cli.steps import in_order, watched
from verify.cli.terminal import show
from verify.cli.unfinished import Result, Unfinished
from verify.language.errors import OwnError
from verify.spheres.scene.afterwards import Afterwards, afterwards
from verify.spheres.scene.decide import Budget, decide_scene
from verify.spheres.scene.scene_files import read_scene
from verify.spheres.scene.verdict import Told, told
from verify.views.scene import exit_code, given_line, judge_of, scene_document
from verify.views.scene_table import COLUMNS, cells, counts_of, csv_text, unusable_cells
from verify.wire.inputs import InputError, shown

FORMAT = "verify-scenes/2"
#: The codes, the one that wins first: our own error, unusable, undecided.
ORDER = (5, 2, 3, 0)
#: The file beside a certificate that says what was found.
RESULT = "scene.json"


def run_folder(options: Options, limits: Budget, jobs: int) -> int:
    """Print one line for each scene; the exit code is that of the worst."""
    others = ("plot", "verbose", "trajectory", "sample", "grid", "at")
    leave_out(options, others, "leave it out with a folder")
    names = sorted(name for name in os.listdir(options.scene) if name.endswith(".toml"))
    if not names:
        raise InputError(f"scene: {shown(options.scene)} has no file that ends in .toml")
    wants_document = options.json or options.out is not None
    work = partial(decide_file, options.scene, options.out, limits, wants_document)
    unfinished = Unfinished(options.scene, options.out, limits)
    results: list[Result] = []
    for result in watched(_results(names, work, jobs, unfinished), len(names), apart=True):
        results.append(result)
        if not (options.json or options.csv):
            show([f"{result['file']}: {' '.join(result['lines'])}"], options, records=True)
    if options.csv:
        rows = [result["row"] for result in results]
        write_file("--csv", options.csv, csv_text([COLUMNS, *rows]))
        if not options.json:
            show(counts_of(rows), options)
    if options.json:
        found = [{"file": result["file"], **result["document"]} for result in results]
        print_document({"format": FORMAT, "command": "scene", "scenes": found})
    unfinished.end()
    return worst(int(result["code"]) for result in results)


def _results(
    names: Sequence[str], work: Callable[[str], Result], jobs: int, unfinished: Unfinished
) -> Iterator[Result]:
    """What is found about each file, in order; what an interrupted run has found is kept."""
    kept = unfinished.kept
    if kept:
        print(
            f"verify: {len(kept)} scenes are kept from a run that was interrupted", file=sys.stderr
        )
    new = in_order(work, [name for name in names if name not in kept], jobs)
    for name in names:
        if name in kept:
            yield kept[name]
        else:
            result = next(new)
            unfinished.add(result)
            yield result


def decide_file(
    folder: str, out: str | None, limits: Budget, wants_document: bool, name: str
) -> Result:
    """What is found about one file."""
    try:
        return _decide(folder, out, limits, wants_document, name)
    except InputError as error:
        return _failed(name, 2, "unusable", str(error))
    except OwnError as error:
        return _failed(name, 5, "error", str(error))


def _failed(name: str, code: int, verdict: str, says: str) -> Result:
    document = {"verdict": verdict, "reason": verdict, "says": says}
    row = unusable_cells(name, verdict)
    return {"file": name, "code": code, "lines": [says], "document": document, "row": row}


def _decide(
    folder: str, out: str | None, limits: Budget, wants_document: bool, name: str
) -> Result:
    path = os.path.join(folder, name)
    content = read_bytes("scene", path)
    found = decide_scene(read_scene(path, content), limits)
    known = told(found)
    if not wants_document:
        return _without_document(name, known, judge_of(False))
    after = afterwards(found, None if limits.digits is None else limits)
    if out is None:
        return _result(name, known, after, "")
    place = os.path.join(out, os.path.splitext(name)[0])
    result = _result(name, known, after, None)
    missing = write_scene("--out", place, found, _beside(result))
    if missing:
        result = _result(name, known, after, missing)
        write_folder("--out", place, _beside(result))
    return result | {"scene": sha256(content).hexdigest()}


def _result(name: str, known: Told, after: Afterwards | None, missing: str | None) -> Result:
    """What is found, with a certificate if ``missing`` is None; else it says why there is none."""
    judge = judge_of(missing is None)
    result = _without_document(name, known, judge)
    document = scene_document(known, after, judge)
    if missing and known.theorems:
        result["lines"].append(f"no certificate: {missing}")
        document |= {"no_certificate": missing}
    return result | {"document": document}


def _without_document(name: str, known: Told, judge: str) -> Result:
    lines = [*known.lines, *filter(None, [given_line(known, judge)])]
    row = cells(name, known, judge)
    return {"file": name, "code": exit_code(known), "lines": lines, "row": row}


def _beside(result: Result) -> dict[str, bytes]:
    kept = {name: value for name, value in result.items() if name != "row"}
    text = json.dumps(kept, ensure_ascii=False, indent=1) + "\n"
    return {RESULT: text.encode(errors="backslashreplace")}  # which is JSON, too


def worst(codes: Iterable[int]) -> int:
    """The exit code of several scenes."""
    found = {*codes}
    return next(code for code in ORDER if code in found)
