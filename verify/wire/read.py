"""The outcome that two files stand for; the inverse of `verify.wire.write`.

Nothing is checked here but the form: `verify/check.py` checks.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from functools import partial
from typing import Any

from verify.language.statement import (
    Assumption,
    Cite,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.prover.outcome import Decision, Enclosure, Outcome
from verify.prover.proof import (
    ConstantStep,
    DefinitionStep,
    LemmaStep,
    ObligationStep,
    OpenStep,
    Step,
    made_of,
    shapes,
)
from verify.prover.rules import RULES, Interval
from verify.wire.term_json import TermReader, WireError
from verify.wire.write import CERTIFICATE_FORMAT, STATEMENT_FORMAT


def read(statement: bytes, certificate: bytes, cited: Mapping[str, bytes]) -> Outcome:
    """The outcome; ``cited`` has the contents of cited statements by their digests.

    Raises:
        WireError: for files that are not in the format.
    """
    try:
        return _outcome(json.loads(statement), json.loads(certificate), cited)
    except KeyError as error:
        raise WireError(f"not a statement with its certificate: {error} is missing") from error
    except (TypeError, ValueError, AttributeError, IndexError, RecursionError) as error:
        raise WireError(f"not a statement with its certificate: {error}") from error


def _outcome(first: Any, second: Any, cited: Mapping[str, bytes]) -> Outcome:
    reader = TermReader(first["terms"], second["terms"])
    statement = read_statement(first, reader, cited)
    steps = tuple(_step(item, reader) for item in second["steps"])
    proofs = {step.name: step.proof for step in steps if isinstance(step, ObligationStep)}
    sides = second["enclosures"]["rows"]
    decisions = {
        row["name"]: Decision(
            row["verdict"],
            proofs.get(row["name"]),
            _sides(sides[row["name"]]) if row["name"] in sides else None,
        )
        for row in first["obligations"]
    }
    enclosures = {
        name: Enclosure(found["bits"], (_ends(found["ends"]),))
        for name, found in second["enclosures"]["constants"].items()
    }
    return Outcome(statement, decisions, steps, enclosures)


def _sides(found: Any) -> Enclosure:
    return Enclosure(found["bits"], (_ends(found["lhs"]), _ends(found["rhs"])))


def _ends(texts: Any) -> tuple[Fraction, Fraction]:
    low, high = map(Fraction, texts)
    return low, high


def statement_of(content: bytes, cited: Mapping[str, bytes]) -> Statement:
    """The statement that a file is; ``cited`` has what it cites, by the digests."""
    document = json.loads(content)
    return read_statement(document, TermReader(document["terms"]), cited)


def read_statement(document: Any, reader: TermReader, cited: Mapping[str, bytes]) -> Statement:
    """The statement that a JSON value stands for."""
    return Statement(
        theorem=document["theorem"],
        title=document["title"],
        parameters=reader.table(document["parameters"]),
        constants=tuple(_constant(item, reader) for item in document["constants"]),
        contexts=tuple(_context(item, reader) for item in document["contexts"]),
        obligations=tuple(_row(item, reader) for item in document["obligations"]),
        assumptions=tuple(Assumption(**item) for item in document["assumptions"]),
        cites=tuple(_cite(item, cited) for item in document["cites"]),
    )


def _cite(item: Any, cited: Mapping[str, bytes]) -> Cite:
    digest = item["statement_sha256"]
    content = cited[digest]
    document = json.loads(content)
    inner = tuple(_cite(other, cited) for other in document["cites"])
    assumptions = tuple(Assumption(**entry) for entry in document["assumptions"])
    certificate = _certificate_of(digest, cited)
    return Cite(item["name"], item["theorem"], content, inner, assumptions, certificate)


def cite_of(statement: bytes, certificate: bytes, cited: Mapping[str, bytes]) -> Cite:
    """The citation of a statement under its theorem's name; ``cited`` has what it cites."""
    document = json.loads(statement)
    theorem = document["theorem"]
    inner = tuple(_cite(item, cited) for item in document["cites"])
    assumptions = tuple(Assumption(**entry) for entry in document["assumptions"])
    return Cite(theorem, theorem, statement, inner, assumptions, certificate)


def cites_of(cited: Mapping[str, bytes]) -> tuple[Cite, ...]:
    """What may be cited among some files, by their digests: each statement under its theorem.

    Raises:
        WireError: for a statement that cites what is not there.
    """
    found = []
    for digest, content in statements_among(cited).items():
        theorem = _document(content).get("theorem")
        try:
            item = {"name": theorem, "theorem": theorem, "statement_sha256": digest}
            found.append(_cite(item, cited))
        except (KeyError, TypeError) as error:
            raise WireError(f"the cited statement {theorem!r:.40} lacks {error!s:.80}") from error
    return tuple(found)


def statements_among(cited: Mapping[str, bytes]) -> dict[str, bytes]:
    """Those of some files that say they are statements, by their digests."""
    return {
        digest: content
        for digest, content in cited.items()
        if _document(content).get("format") == STATEMENT_FORMAT
    }


def _document(content: bytes) -> dict[str, Any]:
    """The JSON object that a file has, or an empty one."""
    try:
        document = json.loads(content)
    except (ValueError, RecursionError):
        return {}
    return document if isinstance(document, dict) else {}


def _certificate_of(digest: str, cited: Mapping[str, bytes]) -> bytes:
    """The certificate of what is cited: the program's own, or one that is given, or none."""
    from verify.wire.packaged import packaged_certificate  # loaded only where it is used

    given = (data for data in cited.values() if _certifies(data, digest))
    return packaged_certificate(digest) or next(given, b"")


def _certifies(data: bytes, digest: str) -> bool:
    if CERTIFICATE_FORMAT.encode() not in data or digest.encode() not in data:
        return False
    found = _document(data)
    return (found.get("format"), found.get("statement_sha256")) == (CERTIFICATE_FORMAT, digest)


def _constant(item: Any, reader: TermReader) -> Constant:
    return Constant(**item | {"term": reader.term(item["term"])})


def _context(item: Any, reader: TermReader) -> Context:
    givens = (Given(**g | {"claim": reader.comparison(g["claim"])}) for g in item["givens"])
    changed = {
        "variables": tuple(Variable(**variable) for variable in item["variables"]),
        "givens": tuple(givens),
        "point": reader.table(item["point"]),
        "constants": tuple(_constant(constant, reader) for constant in item["constants"]),
    }
    return Context(**item | changed)


def _row(item: Any, reader: TermReader) -> Obligation:
    fields = {key: value for key, value in item.items() if key != "verdict"}
    changed = {"claim": reader.claim(item["claim"]), "uses": tuple(item["uses"])}
    return Obligation(**fields | changed)


def _step(item: Any, reader: TermReader) -> Step:
    if "open" in item:
        leaf = partial(reader.leaf, _proof, "premise")
        return OpenStep(item["open"], tuple(map(leaf, item["givens"])))
    proof = _proof(item["proof"], reader)
    if "constant" in item:
        return ConstantStep(item["constant"], proof)
    if "obligation" in item:
        return ObligationStep(item["obligation"], proof)
    if "lemma" in item:
        claim = reader.comparison(item["claim"])
        return LemmaStep(item["lemma"], item["context"], claim, proof)
    return DefinitionStep(item["define"], item["context"], reader.term(item["term"]), proof)


def _proof(item: Any, reader: TermReader) -> Any:
    if isinstance(item, int):
        return Interval(item)
    fields = item.keys() - {"rule"}
    for proofs, rule in RULES.items():
        if rule.name == item["rule"] and shapes(proofs).keys() == fields:
            return proofs(**made_of(proofs, item, partial(reader.leaf, _proof)))
    raise WireError(f"a proof by {item['rule']} has other fields than {sorted(fields)}")
