"""Writing results: files, all of them or none, certificates, documents, and progress."""

from __future__ import annotations

import os
import re
import signal
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import cache

from verify.language.errors import UnreadError
from verify.language.record import TYPE_CHECKING
from verify.language.statement import NEEDED, UNDECIDED
from verify.wire.inputs import InputError, regular_file, shown

if TYPE_CHECKING:
    from typing import Any

    from verify.prover.outcome import Outcome

#: Numbers with more digits, above or below the fraction bar, are not in the checker's format.
CHECKER_DIGITS = 4300

#: Of a file that is read: as many as the checker reads.
MAX_BYTES = 1 << 22

#: Of all files in a folder `cited`.
MAX_CITED = 8 * MAX_BYTES

#: What comes with the program: pages and scenes, and certificates.
DATA = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data")
EXAMPLES = os.path.join(DATA, "examples")

#: Those that are scenes: for the help, where nothing is read.
SCENES = (
    *("bead", "in-space", "light-bead", "nearly-aligned", "on-a-line", "parting", "passing"),
    *("small-bead", "tie"),
)

PAGES = ("agm", "alpha-theory", "bb84", "fista", "max-cut")

#: A folder for files of these names is a certificate's: it is written, and replaced, as a whole.
CERTIFICATE = {"statement.json", "certificate.json"}

#: What the program itself puts into such a folder.
OURS = re.compile(
    r"(statement|certificate|scene)\.json|report\.(md|html)|check\.py|cited/[0-9a-f]{64}(\.certificate)?\.json"
)

#: Only numbers with this many digits can be more work than the checker is willing to do.
LONG_NUMBER = 300


def test_folder(option: str, directory: str | None, *names: str) -> None:
    """Before the work: afterwards files of these names can be written into the directory.

    Nothing stays on the disk. None is a directory that nobody asked for.

    Raises:
        InputError: if they cannot, naming the option.
    """
    if directory is not None:
        kind = _Whole if CERTIFICATE <= {*names} else _Writing
        with kind(option, directory) as writing:
            for name in names:
                writing.add(name, b"")


def write_all(option: str, directory: str, contents: Mapping[str, bytes]) -> None:
    """Write files into a directory, created if needed; each appears whole or not at all.

    Files of other names stay as they are.

    Raises:
        InputError: if the directory or a file cannot be written, naming the option.
    """
    with _Writing(option, directory) as writing:
        for name, content in contents.items():
            writing.add(name, content)
        writing.finish()


def write_file(option: str, path: str, text: str) -> None:
    """Write one file as a whole; what is no letter, as in some names of files, with a backslash.

    Raises:
        InputError: if it cannot be written, naming the option.
    """
    folder, name = os.path.split(path)
    write_all(option, folder or os.curdir, {name: text.encode(errors="backslashreplace")})


def write_folder(option: str, directory: str, contents: Mapping[str, bytes]) -> None:
    """Write a folder as a whole: these files and no others are in it afterwards.

    Whatever other processes do, and whenever this one is killed, the folder has the files of one
    run, or there is none. A folder with files that are not the program's own, or with the
    certificate of another theorem, is left as it is.

    Raises:
        InputError: if it cannot be written, naming the option.
    """
    with _Whole(option, directory) as writing:
        for name, content in contents.items():
            writing.add(name, content)
        writing.finish()


#: What asks a process to end. It waits until what is being written is in its place.
ENDING = {signal.SIGINT, signal.SIGTERM, signal.SIGHUP}


class _Writing:
    """Files on their way into a directory: what is not finished disappears.

    Meanwhile nothing that asks this process to end reaches it.
    """

    def __init__(self, option: str, directory: str) -> None:
        self._option, self._directory = option, directory
        self._temporary: dict[str, str] = {}
        self._made: list[str] = []

    def __enter__(self) -> _Writing:
        if not self._directory:
            raise InputError(f"{self._option}: '' is no folder; write . for this one")
        self._mask = signal.pthread_sigmask(signal.SIG_BLOCK, ENDING)
        return self

    def add(self, name: str, content: bytes) -> None:
        """Write a file beside its place; where a link names the place, the link stays."""
        target = os.path.join(self._directory, name)
        if os.path.isdir(target):
            raise InputError(f"{self._option}: {shown(target)} is a folder; name another place")
        if os.path.exists(target) and not os.path.isfile(target):  # /dev/null, say, would be gone
            raise InputError(f"{self._option}: {shown(target)} is no regular file; name another")
        target = os.path.realpath(target)
        folder, last = os.path.split(target)
        self._make(folder)
        path = os.path.join(folder, f".{last}.{os.urandom(6).hex()}")
        self._temporary[path] = target
        with open(path, "xb") as file:
            file.write(content)

    def _make(self, folder: str) -> None:
        with suppress(FileNotFoundError):
            os.stat(folder or os.curdir)  # a path that is too long fails here
        missing = []
        while folder and not os.path.isdir(folder):
            missing.append(folder)
            folder = os.path.dirname(folder)
        for path in reversed(missing):
            try:
                os.mkdir(path)
            except FileExistsError:  # another process has made it meanwhile
                if not os.path.isdir(path):
                    raise
            else:
                self._made.append(path)

    def finish(self) -> None:
        """Put every file into its place."""
        for path, target in self._temporary.items():
            os.replace(path, target)

    def __exit__(self, _kind: object, error: BaseException | None, _trace: object) -> None:
        self._clean()
        signal.pthread_sigmask(signal.SIG_SETMASK, self._mask)
        if isinstance(error, InputError):
            raise error
        if isinstance(error, OSError | ValueError | RecursionError):
            raise InputError(
                f"{self._option}: {shown(self._directory)} cannot be written ({_reason(error)}); "
                "name a folder that can"
            ) from error

    def _clean(self) -> None:
        for path in self._temporary:
            with suppress(OSError):
                os.unlink(path)
        for path in reversed(self._made):
            with suppress(OSError):  # not empty: its files are in their places
                os.rmdir(path)


class _Whole(_Writing):
    """A folder on its way: written beside its place, and then renamed."""

    _fresh = _aside = _target = ""

    def add(self, name: str, content: bytes) -> None:
        """Write a file of the folder; before the first one, see whether its place can be taken."""
        if not self._fresh:
            self._begin()
        path = os.path.join(self._fresh, name)
        self._make(os.path.dirname(path))
        with open(path, "xb") as file:
            file.write(content)

    def _begin(self) -> None:
        self._target = os.path.realpath(self._directory)
        if f"{os.getcwd()}/".startswith(f"{self._target}/") or os.path.ismount(self._target):
            raise self._refused("has to stay where it is; name a folder inside of it")
        with suppress(FileNotFoundError):
            os.stat(self._target)  # a path that is too long fails here
            with _alone(os.path.dirname(self._target)):
                self._look(None)
        hidden = os.path.join(os.path.dirname(self._target), f".verify-{os.urandom(8).hex()}")
        self._fresh, self._aside = f"{hidden}-new", f"{hidden}-old"
        self._make(self._fresh)

    def finish(self) -> None:
        """Put the folder into its place, instead of what was there."""
        with _alone(os.path.dirname(self._target)):
            self._look(os.path.join(self._fresh, "statement.json"))
            with suppress(FileNotFoundError):
                os.rename(self._target, self._aside)
            os.rename(self._fresh, self._target)

    def _look(self, statement: str | None) -> None:
        """Afterwards what is at the place may be replaced, by a certificate of this statement."""
        with suppress(FileNotFoundError):
            others = [name for name in _names_in(self._target) if not OURS.fullmatch(name)]
            if others:
                raise self._refused(f"has other files ({shown(others[0])}); name a new folder")
            found = _theorem(os.path.join(self._target, "statement.json"))
            theorem = None if statement is None else _theorem(statement)
            if None not in (theorem, found) and theorem != found:
                raise self._refused(
                    f"has a certificate of {shown(str(found))}; name another folder, or remove it"
                )

    def _refused(self, why: str) -> InputError:
        return InputError(f"{self._option}: {shown(self._directory)} {why}")

    def __exit__(self, kind: object, error: BaseException | None, trace: object) -> None:
        if error is not None and self._aside:
            with suppress(OSError):  # nothing was there
                os.rename(self._aside, self._target)
        for folder in (self._fresh, self._aside):
            _remove(folder)
        super().__exit__(kind, error, trace)


@contextmanager
def _alone(folder: str) -> Iterator[None]:
    """Meanwhile no other process moves a certificate's folder that lies in this one."""
    import fcntl  # loaded only where it is used

    lock = os.open(folder, os.O_RDONLY)
    try:
        with suppress(
            OSError
        ):  # a file system without locks: what is renamed is whole all the same
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield
    finally:
        os.close(lock)


def _names_in(folder: str) -> Iterator[str]:
    """The names in a certificate's folder; a slash ends that of a folder with other folders."""
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if name == "cited" and os.path.isdir(path):
            yield from (f"cited/{inner}" for inner in sorted(os.listdir(path)))
        else:
            yield name if os.path.isfile(path) else f"{name}/"


def _theorem(path: str) -> str | None:
    """The theorem of a statement; None where there is none, and no reason to keep what is there.

    Raises:
        ValueError: if the file is no statement.
    """
    try:
        return _theorem_of(regular_file(path, MAX_BYTES))
    except FileNotFoundError:
        return None
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise ValueError("its statement.json is no statement") from error


@cache  # what is written, or replaced, is looked at twice
def _theorem_of(statement: bytes) -> str:
    import json  # loaded only where it is used

    return str(json.loads(statement)["theorem"])


def _remove(folder: str) -> None:
    from shutil import rmtree  # loaded only where it is used

    if folder:
        rmtree(folder, ignore_errors=True)


class UncheckableError(InputError):
    """There can be no certificate that the checker reads; ``why`` says it without the option."""

    def __init__(self, option: str, why: str) -> None:
        what = f"{why}, so none was written; write parameters with fewer digits"
        super().__init__(f"{option}: {what}")
        self.why = why


def write_certificate(
    option: str,
    directory: str,
    outcome: Outcome,
    beside: Mapping[str, bytes] | None = None,
    *,
    markdown: bool = False,
) -> Outcome:
    """Write an outcome as a certificate that `verify/check.py` accepts, or say why not.

    It is given back with the verdicts of the checker, or as it is if nothing was written.
    ``beside`` are other files of the same folder, by default those with which it can be sent;
    with the report in ``markdown``, too.
    Nothing is written, with a line on stderr, where a needed row is undecided.

    Raises:
        InputError: if the directory cannot be written, or the checker cannot read the parameters.
        OwnError: if the checker does not accept what would be written.
    """
    from verify.wire.judge import accept, with_verdicts  # load hashlib and json
    from verify.wire.write import write

    if outcome.spent or any(
        row.role == NEEDED and found.claimed == UNDECIDED for row, found in outcome.rows
    ):
        print("verify: a needed row is undecided; no certificate was written", file=sys.stderr)
        return outcome
    files = write(outcome)
    try:
        report = accept(files, outcome.claimed)
    except UnreadError as error:
        digits = longest_number(outcome)
        if digits < LONG_NUMBER:
            raise
        why = (
            f"a number in the certificate would have {digits} digits, and the checker reads at "
            f"most {CHECKER_DIGITS}"
            if digits > CHECKER_DIGITS
            else f"numbers of {digits} digits make the certificate more than the checker's budget "
            "of work"
        )
        raise UncheckableError(option, why) from error
    judged = with_verdicts(outcome, report)
    if beside is None:
        from verify.cli.sent import sent  # loaded only where it is used

        beside = sent(judged, files, markdown=markdown)
    write_folder(option, directory, {**files, **beside})
    return judged


def longest_number(outcome: Outcome) -> int:
    """The largest number of digits above or below a fraction bar in a statement."""
    from verify.language.terms import parts_of  # loaded only where they are used
    from verify.wire.write import statement_terms

    parts = parts_of(*statement_terms(outcome.statement))
    numbers = [part.value for part in parts if part.op == "rational"]
    ends = (end for value in numbers for end in (abs(value.numerator), value.denominator))
    return len(str(max(ends, default=1)))


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def read_bytes(option: str, path: str) -> bytes:
    """The content of a file.

    Raises:
        InputError: if it cannot be read, or has no end in sight, naming the option.
    """
    try:
        return regular_file(path, MAX_BYTES)
    except (OSError, ValueError) as error:
        instead = _meant(path) if isinstance(error, FileNotFoundError) else "name a file"
        raise InputError(
            f"{option}: {shown(path)} cannot be read ({_reason(error)}); {instead}"
        ) from error


def _meant(path: str) -> str:
    """What to write for a file that is not there: one beside it, or an example."""
    from verify.wire.inputs import near  # loaded only where it is used

    folder, name = os.path.split(path)
    beside = os.listdir(folder or os.curdir) if os.path.isdir(folder or os.curdir) else []
    known = [other for other in beside if other.endswith((".toml", ".json", ".smt2", ".fpcore"))]
    meant = near(name, [*known, *([] if folder else examples())])
    return f"did you mean {os.path.join(folder, meant)}?" if meant else "name a file"


def example(path: str) -> str:
    """The path; or, where nothing lies there, that of the example with this name, if there is."""
    found = os.path.join(EXAMPLES, f"{path}.toml")
    is_name = os.path.basename(path) == path and not os.path.lexists(path)
    return found if is_name and os.path.isfile(found) else path


def examples() -> list[str]:
    """The names of the examples that come with the program."""
    return sorted(name.removesuffix(".toml") for name in os.listdir(EXAMPLES))


def command_for(path: str) -> str:
    """The command that decides a page or a scene: what has positions is a scene."""
    return "scene" if b"\npositions" in read_bytes("name", path) else "prove"


def read_cited(option: str, folder: str) -> dict[str, bytes]:
    """The files in the folder `cited` beside a statement; none if there is no such folder.

    A folder in it with a certificate, as ``--out`` writes it, counts as `NAME.json` with
    `NAME.certificate.json` and what lies beside these in a folder `cited` of its own.

    Raises:
        InputError: if one cannot be read, or together they are more than the checker reads.
    """
    cited, found, total = os.path.join(folder, "cited"), {}, 0
    for name, path in _cited_paths(cited):
        found[name] = read_bytes(option, path)
        total += len(found[name])
        if total > MAX_CITED:
            raise InputError(
                f"{option}: {shown(cited)} has more than {MAX_CITED} bytes; keep what is cited"
            )
    return found


def _cited_paths(cited: str) -> Iterator[tuple[str, str]]:
    """The files in a folder `cited`, with their names."""
    for name in _listed(cited):
        path = os.path.join(cited, name)
        if not os.path.isfile(os.path.join(path, "statement.json")):
            yield name, path
            continue
        for file, ending in (("statement", ".json"), ("certificate", ".certificate.json")):
            if os.path.isfile(os.path.join(path, f"{file}.json")):
                yield f"{name}{ending}", os.path.join(path, f"{file}.json")
        inner = os.path.join(path, "cited")
        yield from ((f"{name}/{other}", os.path.join(inner, other)) for other in _listed(inner))


def _listed(folder: str) -> list[str]:
    return sorted(os.listdir(folder)) if os.path.isdir(folder) else []


def print_document(document: Mapping[str, Any]) -> None:
    """Print one JSON document on stdout."""
    import json  # loaded only where they are used

    from verify.cli.terminal import erase

    erase()
    print(json.dumps(document, ensure_ascii=False, indent=1))
