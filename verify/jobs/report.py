"""What the report is made from: accepted certificates, and the committed measurements."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, NamedTuple

from verify.cli.files import read_bytes
from verify.cli.inputs import InputError, rational
from verify.paper.parameters import THEOREM
from verify.paper.spectrum import theorem as spectrum
from verify.paper.theorem1 import theorem
from verify.prover.ground import Ends
from verify.jobs.regenerate import is_right_statement
from verify.paper.groups import GROUPS
from verify.language.statement import Obligation, Statement
from verify.language.terms import Claim, Term
from verify.wire.wire import WireError, term_from_document

#: The trusted file; it is run on its own, and nothing is imported from it.
CHECKER = Path(__file__).with_name("check.py")

NAMES = ("statement.json", "certificate.json")
MEASUREMENTS = ("bench", "stress")


class CertificateError(Exception):
    """A certificate that no report may show; ``code`` is the exit code that says why."""

    def __init__(self, message: str, code: int) -> None:
        super().__init__(message)
        self.code = code


class Constant(NamedTuple):
    """A constant with its enclosure as the certificate has it."""

    name: str
    tex: str
    label: str
    term: Term
    texts: tuple[str, str]

    @property
    def ends(self) -> Ends:
        """The ends of the enclosure."""
        return _ends(self.texts)


class Row(NamedTuple):
    """An obligation with its proof; ``refuted`` if the negation of the claim is what is proved."""

    name: str
    label: str
    role: str
    says: str
    claim: Claim
    refuted: bool
    rule: str
    lhs: tuple[str, str] | None
    rhs: tuple[str, str] | None

    @property
    def verdict(self) -> str:
        """``proved`` or ``refuted``."""
        return "refuted" if self.refuted else "proved"

    @property
    def group(self) -> str:
        """The set that the row belongs to, or nothing."""
        head = self.name.partition(".")[0]
        return head if head in GROUPS else ""

    @property
    def sides(self) -> tuple[Ends, Ends] | None:
        """Enclosures of both sides, where the claim has no variables."""
        if self.lhs is None or self.rhs is None:
            return None
        return _ends(self.lhs), _ends(self.rhs)


class Folder(NamedTuple):
    """One certificate, read; ``said`` is the checker's last line."""

    name: str
    theorem: str
    title: str
    parameters: dict[str, Term]
    constants: tuple[Constant, ...]
    rows: tuple[Row, ...]
    assumptions: tuple[dict[str, str], ...]
    digests: dict[str, str]
    said: str

    def of_group(self, *groups: str) -> list[Row]:
        """The rows of some sets."""
        return [row for row in self.rows if row.group in groups]

    @property
    def proved(self) -> bool:
        """Whether all needed rows are proved (the checker has seen that the proofs are right)."""
        needed = [row for row in self.rows if row.role == "needed"]
        return bool(needed) and not any(row.refuted for row in needed)


class Material(NamedTuple):
    """Everything that the report shows."""

    folders: tuple[Folder, ...]
    measurements: dict[str, dict[str, Any]]
    digests: dict[str, str]

    def about(self, theorem_name: str) -> list[Folder]:
        """The certificates of one theorem."""
        return [folder for folder in self.folders if folder.theorem == theorem_name]


def read(directory: str) -> Material:
    """Read and check every certificate folder, and the measurements if there are any.

    Raises:
        InputError: if the directory has no certificate, or a file cannot be used.
        CertificateError: if one is not accepted, or its statement is not the program's.
    """
    names = _folders(directory)
    if not names:
        raise InputError(
            f"--directory: {directory!r} has no certificates; make them with verify certify"
        )
    measurements, digests = {}, {}
    for name in MEASUREMENTS:
        path = os.path.join(directory, "data", f"{name}.json")
        if os.path.exists(path):
            content = read_bytes("--directory", path)
            measurements[name] = _tables(path, content)
            digests[f"data/{name}.json"] = sha256(content).hexdigest()
    folders = tuple(_folder(directory, name) for name in names)
    if not any(folder.theorem == THEOREM for folder in folders):
        raise InputError(
            f"--directory: {directory!r} has no certificate of {THEOREM}; make it with "
            f"verify certify"
        )
    return Material(folders, measurements, digests)


def _folders(directory: str) -> list[str]:
    if not os.path.isdir(directory):
        raise InputError(f"--directory: {directory!r} is not a folder; name the certificates")
    names = sorted(os.listdir(directory))
    found = [n for n in names if os.path.exists(os.path.join(directory, n, NAMES[0]))]
    first = "theorem1-r-3-100"  # the main job stands first
    return sorted(found, key=lambda name: (name != first, name))


def _tables(path: str, content: bytes) -> dict[str, Any]:
    try:
        tables = json.loads(content, parse_float=str)["tables"]
        for table in tables.values():
            width = len(table["columns"])
            if not isinstance(table["title"], str) or any(len(r) != width for r in table["rows"]):
                raise ValueError("a table without a title, or with a row of another width")
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(f"--directory: {path!r} has no tables ({error!r:.60})") from error
    return dict(tables)


def _folder(directory: str, name: str) -> Folder:
    path = os.path.join(directory, name)
    contents = [read_bytes("--directory", os.path.join(path, file)) for file in NAMES]
    said = _checked(path)
    if not is_right_statement(contents[0]):
        raise CertificateError(
            f"{path}: the statement is not the one that the program makes; run verify certify", 1
        )
    try:
        statement, certificate = map(json.loads, contents)
        proofs = {proof["obligation"]: proof for proof in certificate["proofs"]}
        return Folder(
            name,
            statement["theorem"],
            statement["title"],
            {key: term_from_document(term) for key, term in statement["parameters"].items()},
            tuple(_constant(c, certificate) for c in statement["constants"]),
            tuple(_row(row, proofs[row["name"]]) for row in statement["obligations"]),
            tuple(statement["assumptions"]),
            {
                file: sha256(content).hexdigest()
                for file, content in zip(NAMES, contents, strict=True)
            },
            said,
        )
    except (ValueError, KeyError, TypeError, WireError) as error:
        raise CertificateError(f"{path}: not in the format ({error!r:.60})", 4) from error


def _checked(path: str) -> str:
    """The last line of the checker, run on its own and without anything but Python.

    Raises:
        CertificateError: if it does not accept.
    """
    command = [sys.executable, "-I", str(CHECKER), path]
    run = subprocess.run(command, capture_output=True, text=True, check=False)  # noqa: S603
    lines = (run.stdout.strip() or run.stderr.strip() or "no answer").splitlines()
    if run.returncode != 0:
        raise CertificateError(f"{path}: the checker does not accept it ({lines[-1]})",
                               run.returncode)  # fmt: skip
    return lines[-1]


def _constant(document: dict[str, Any], certificate: dict[str, Any]) -> Constant:
    low, high = certificate["enclosures"][document["name"]]
    return Constant(
        document["name"],
        document["tex"],
        document["label"],
        term_from_document(document["term"]),
        (low, high),
    )


def _row(document: dict[str, Any], proof: dict[str, Any]) -> Row:
    claim = document["claim"]
    refuted = claim[0] == "not"
    relation, *sides = claim[1] if refuted else claim
    lhs, rhs = map(term_from_document, sides)
    return Row(
        document["name"],
        document["label"],
        document["role"],
        document["says"],
        Claim(relation, lhs, rhs),
        refuted,
        proof["rule"],
        tuple(proof["lhs"]) if "lhs" in proof else None,
        tuple(proof["rhs"]) if "rhs" in proof else None,
    )


def _ends(texts: tuple[str, str]) -> Ends:
    low, high = (rational("an enclosure", text) for text in texts)
    return low, high


@cache
def corrections() -> dict[str, str]:
    """For a printed row the row that replaces it."""
    return {row.name: row.corrected_by for row in _obligations() if row.corrected_by}


def _obligations() -> Iterator[Obligation]:
    statements: tuple[Statement, ...] = (theorem(), spectrum.theorem())
    for statement in statements:
        yield from statement.obligations
