"""A statement and its certificate, as the checker reads them."""

from __future__ import annotations

from hashlib import sha256
from typing import Any, NamedTuple

from verify import check

Json = Any


class NotAcceptedError(ValueError):
    """The file is no certificate, or does not prove its statement."""


class Reading(NamedTuple):
    """A statement and its certificate, as the checker has read them."""

    kernel: check.Kernel
    reader: check.Reader
    statement: check.Statement
    theorem: str
    digest: str
    certificate: Json
    cited: dict[str, check.Fact]
    cited_constants: list[int]
    refused: list[str]  # steps
    complaints: list[str]

    @property
    def cites(self) -> bool:
        """Whether another statement is cited."""
        return bool(self.statement.cites)


def read(folder: check.Folder) -> Reading:
    """What the checker reads in a folder, with its complaints.

    Raises:
        NotAcceptedError: if a file, or a certificate of what is cited, is not in the format.
    """
    available = {sha256(data).hexdigest(): data for data in (folder.statement, *folder.cited)}
    ((report, _),) = check.judged([folder])
    if report.verdict == "MALFORMED":
        raise NotAcceptedError(f"MALFORMED: {report.summary}")
    try:
        document = check.parsed("statement", folder.statement, check.STATEMENT)
        certificate = check.parsed("certificate", folder.certificate, check.CERTIFICATE)
        kernel = check.Kernel()
        reader = check.Reader(kernel, available)
        statement = reader.read(document)
        cited, defined = dict(kernel.facts), sorted(kernel.defined)
        kernel.shared |= certificate["terms"]
        for name in certificate["terms"]:
            kernel.introduce(name)
        checking = check.Checking(kernel, reader, statement)
        refused = []
        for step in certificate["steps"]:
            before = len(checking.complaints)
            checking.step(step)
            if len(checking.complaints) > before:
                refused.append(label(step))
        checking.finish(certificate["enclosures"])
    except (check.Malformed, RecursionError) as error:
        raise NotAcceptedError(f"MALFORMED: {error}") from error
    kernel.work = check.MAX_WORK
    cited_complaints = [line for line in report.lines if line.startswith("REFUSED cited")]
    complaints = [report.verdict, *checking.complaints, *cited_complaints]
    complaints = [] if report.verdict == "PROVED" else complaints
    return Reading(
        kernel, reader, statement, document["theorem"], report.digest, certificate, cited, defined,
        refused, complaints,
    )  # fmt: skip


def label(step: Json) -> str:
    """What a step is about."""
    return str(next(step[kind] for kind in check.STEPS if kind in step))
