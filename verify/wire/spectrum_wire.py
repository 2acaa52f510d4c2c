"""Statement and certificate of the spectral claims, in the format of `verify.wire.wire`."""

from __future__ import annotations

from hashlib import sha256
from typing import Any

from verify.prover.decimals import outward, rational_text
from verify.prover.forall import Finding
from verify.jobs.spectrum import Outcome
from verify.language.statement import Obligation
from verify.wire.wire import CERTIFICATE_FORMAT, DIGITS, encode, statement_document

TITLE = "Spectral claims of Section 5, its appendix and Sections 4.1-4.2, for every r in ]0,1["


def files(outcome: Outcome) -> dict[str, bytes]:
    """The two files of a decided outcome, the same bytes on every machine."""
    rows = [(row, finding.decision) for row, finding in outcome.rows]
    statement = encode(statement_document(outcome.statement, {}, rows, TITLE))
    certificate = {
        "format": CERTIFICATE_FORMAT,
        "statement_sha256": sha256(statement).hexdigest(),
        "enclosures": {},
        "proofs": [_proof(row, finding) for row, finding in outcome.rows],
    }
    return {"statement.json": statement, "certificate.json": encode(certificate)}


def _proof(row: Obligation, finding: Finding) -> dict[str, Any]:
    decision = finding.decision
    proof: dict[str, Any] = {
        "obligation": row.name,
        "rule": decision.method,
        "bits": decision.bits,
    }
    if decision.lhs is not None and decision.rhs is not None:
        proof["lhs"] = outward(decision.lhs, DIGITS)
        proof["rhs"] = outward(decision.rhs, DIGITS)
    if decision.method == "rewrite":
        proof["steps"] = []
        proof["closing"] = decision.closing
    elif decision.method == "bernstein":
        proof["degree"] = finding.degree
    elif decision.method == "cuts":
        proof["cuts"] = {
            name: [rational_text(cut) for cut in cuts] for name, cuts in finding.cuts.items()
        }
    elif decision.method == "witness":
        proof["point"] = {name: rational_text(value) for name, value in finding.point.items()}
    return proof
