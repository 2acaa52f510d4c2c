"""A statement and its certificate, as the checker reads them."""

from __future__ import annotations

from hashlib import sha256
from typing import Any, NamedTuple

from verify import check

Json = Any


class NotAcceptedError(ValueError):
    """The certificate does not prove its statement, or is none."""


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
    complaints: list[str]


def read(folder: check.Folder) -> Reading:
    """What the checker reads in a folder, with its complaints.

    Raises:
        NotAcceptedError: if a file is not in the format.
    """
    available = {sha256(data).hexdigest(): data for data in (folder.statement, *folder.cited)}
    try:
        document = check.parsed("statement", folder.statement, check.STATEMENT)
        certificate = check.parsed("certificate", folder.certificate, check.CERTIFICATE)
        report = check.check(folder.statement, folder.certificate, available)
        kernel = check.Kernel()
        reader = check.Reader(kernel, available)
        statement = reader.read(document)
        cited, defined = dict(kernel.facts), sorted(kernel.defined)
        kernel.shared |= certificate["terms"]
        for name in certificate["terms"]:
            kernel.introduce(name)
        checking = check.Checking(kernel, reader, statement)
        for step in certificate["steps"]:
            checking.step(step)
        checking.finish(certificate["enclosures"])
    except (check.Malformed, RecursionError) as error:
        raise NotAcceptedError(f"MALFORMED: {error}") from error
    kernel.work = check.MAX_WORK
    complaints = [] if report.verdict == "PROVED" else [report.verdict, *checking.complaints]
    return Reading(
        kernel, reader, statement, document["theorem"], report.digest, certificate, cited, defined,
        complaints,
    )  # fmt: skip
