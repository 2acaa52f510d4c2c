"""The job `prove`: a statement of anybody's, whose rows are questions, decided."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from verify import check
from verify.jobs.inputs import InputError
from verify.language.statement import NEEDED, PROVED, Statement
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.prover.prove import prove
from verify.wire.read import read_statement
from verify.wire.term_json import TermReader


def read_questions(content: bytes, cited: Mapping[str, bytes]) -> Statement:
    """The statement in a file; which verdicts stand there does not matter.

    ``cited`` has the contents of statements that may be cited, by their digests.

    Raises:
        InputError: for a file that is not in the format, with the reason in one line.
    """
    try:
        document = check.parsed("STATEMENT", content, check.STATEMENT)
        check.Reader(check.Kernel(), cited).read(asked(document))
    except (check.Malformed, RecursionError) as error:
        raise InputError(
            f"STATEMENT: {error}; certificates/README.md describes the format"
        ) from error
    if not any(row["role"] == NEEDED for row in document["obligations"]):
        raise InputError('STATEMENT: no row is needed; write "role": "needed" where it is asked')
    reader = TermReader(document["terms"])
    return read_statement(document, reader, cited)


def asked(document: dict[str, Any]) -> dict[str, Any]:
    """The document with the verdict that each row asks for."""
    rows = [row | {"verdict": PROVED} for row in document["obligations"]]
    return document | {"obligations": rows}


def decide_statement(content: bytes, cited: Mapping[str, bytes], budget: WorkBudget) -> Outcome:
    """Every row of a statement, decided or not.

    Raises:
        InputError: for a file that is not in the format.
    """
    return prove(read_questions(content, cited), budget=budget)
