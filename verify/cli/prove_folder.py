"""What ``prove --out`` writes: the statement that was decided, and its certificate."""

from __future__ import annotations

import json
import os
import sys

from verify.cli.files import read_bytes, write_certificate
from verify.language.statement import NEEDED, PRINTED, UNDECIDED, Statement
from verify.language.terms import Claim
from verify.prover.outcome import Outcome
from verify.wire.inputs import InputError, shown


def keep_more(directory: str, statement: Statement) -> None:
    """Afterwards there is no certificate of this theorem that has all these rows and others.

    Raises:
        InputError: if there is, or if what lies there cannot be read.
    """
    path = os.path.join(directory, "statement.json")
    if not os.path.exists(path):
        return
    try:
        there = json.loads(read_bytes("--out", path))
        names = [row["name"] for row in there["obligations"]]
        theorem = there["theorem"]
    except (ValueError, KeyError, TypeError, RecursionError) as error:
        raise InputError(f"--out: {shown(path)} is no statement; name a new folder") from error
    chosen = {row.name for row in statement.obligations}
    others = [name for name in names if name not in chosen]
    if theorem == statement.theorem and others and chosen <= {*names}:
        raise InputError(
            f"--out: {shown(directory)} has a certificate of more rows ({shown(str(others[0]))}); "
            "leave --rows out, or name another folder"
        )


def write(directory: str, outcome: Outcome) -> None:
    """Write a certificate of what is decided, and say what is not in it."""
    undecided = [row for row, found in outcome.rows if found.claimed == UNDECIDED]
    unwritten = {row.name for row in undecided if not isinstance(row.claim, Claim)}
    rows = [
        row._replace(role=PRINTED) if row in undecided else row
        for row in outcome.statement.obligations
        if row.name not in unwritten
    ]
    if not any(row.role == NEEDED for row in rows) or outcome.spent:
        why = outcome.spent or "no needed row is decided"
        print(f"verify: --out: {why}; no certificate was written", file=sys.stderr)
        return
    for row in undecided:
        if row.name not in unwritten and row.role == PRINTED:
            continue
        if row.name in unwritten:
            how = "is left out of it; a certificate says nothing of an undecided row on a context"
        else:
            how = f"stands there as {PRINTED} and undecided, and the theorem does not rest on it"
        print(f"verify: --out: the row {row.name} {how}", file=sys.stderr)
    kept = {row.name: outcome.decisions[row.name] for row in rows}
    statement = outcome.statement._replace(obligations=tuple(rows))
    written = outcome._replace(statement=statement, decisions=kept)
    write_certificate("--out", directory, written, markdown=True)
