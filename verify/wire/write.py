"""An outcome as the two files of a certificate: what is claimed, and what was hard to find.

`verify.wire.read` is the inverse.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache, partial
from hashlib import sha256
from typing import Any

from verify.language.statement import (
    UNDECIDED,
    Always,
    Applies,
    Cite,
    Constant,
    Context,
    Obligation,
    Statement,
)
from verify.language.terms import Claim, Term
from verify.prover.decimals import decimal_text, round_decimal
from verify.prover.outcome import Enclosure, Ends, Outcome
from verify.prover.proof import (
    ConstantStep,
    DefinitionStep,
    LemmaStep,
    ObligationStep,
    OpenStep,
    Proof,
    Step,
    leaf_names,
    leaves,
    mapped,
)
from verify.prover.rules import Interval, rule_of
from verify.wire.inputs import InputError
from verify.wire.term_json import TermWriter

STATEMENT_FORMAT = "verify-statement/2"
CERTIFICATE_FORMAT = "verify-certificate/2"


def write(outcome: Outcome) -> dict[str, bytes]:
    """The files of a certificate, by their names in its folder.

    Besides statement and certificate there are the statements that are cited, with their
    certificates if those are at hand.
    """
    first, names = statement_file(outcome)
    second = certificate_file(outcome, first, names)
    cited = dict(_cited(outcome.statement.cites))
    return {"statement.json": first, "certificate.json": second} | cited


def statement_file(outcome: Outcome) -> tuple[bytes, Mapping[Term, str]]:
    """The statement, and the names of the terms that its certificate may share with it."""
    statement = outcome.statement
    writer = TermWriter(_unused("t", statement), statement_terms(statement), {})
    return encode(_statement(outcome, writer)), writer.names


def certificate_file(outcome: Outcome, statement: bytes, names: Mapping[Term, str]) -> bytes:
    """The certificate of a statement, of which `statement_file` has made the bytes and names."""
    used = [term for step in outcome.steps for term in _step_terms(step)]
    writer = TermWriter(_unused("u", outcome.statement), used, names)
    return encode(_certificate(outcome, statement, writer))


def _unused(prefix: str, statement: Statement) -> str:
    """What begins the names of shared terms, and no name of the statement."""
    items: list[Any] = [*statement.constants, *statement.contexts, *statement.obligations]
    for context in statement.contexts:
        items += [*context.variables, *context.givens, *context.constants]
    names = [*statement.parameters, *(item.name for item in items)]
    while any(name.startswith(f"{prefix}.") and name[-1].isdigit() for name in names):
        prefix *= 2
    return prefix


def _cited(cites: Iterable[Cite]) -> Iterator[tuple[str, bytes]]:
    """The files of citations, and of the citations in them."""
    for cite in cites:
        name = f"cited/{_cite_digest(cite.content)}"
        yield f"{name}.json", cite.content
        if cite.certificate:
            yield f"{name}.certificate.json", cite.certificate
        yield from _cited(cite.cites)


def digest(content: bytes) -> str:
    """The digest by which a statement is cited and a certificate tied to its statement."""
    return sha256(content).hexdigest()


#: The same of what is cited, which many cite.
_cite_digest = lru_cache(maxsize=16)(digest)


# --- the statement -------------------------------------------------------------------------------


def statement_terms(statement: Statement) -> Iterator[Term]:
    """Every term that is written down in a statement."""
    yield from statement.parameters.values()
    constants = list(statement.constants)
    for context in statement.contexts:
        constants += context.constants
        yield from context.point.values()
        for given in context.givens:
            yield from _claim_terms(given.claim)
    for constant in constants:
        yield constant.term
    for row in statement.obligations:
        yield from _claim_terms(row.claim)


def _claim_terms(claim: Claim | Applies | Always) -> Iterator[Term]:
    if isinstance(claim, Claim):
        yield from (claim.lhs, claim.rhs)
    elif isinstance(claim, Applies):
        yield from claim.at.values()
    else:
        yield from (*claim.start.values(), *claim.next.values())


def _statement(outcome: Outcome, writer: TermWriter) -> dict[str, Any]:
    statement = outcome.statement
    return {
        "format": STATEMENT_FORMAT,
        "theorem": statement.theorem,
        "title": statement.title,
        "parameters": writer.table(statement.parameters),
        "terms": writer.shared(),
        "constants": [_constant(constant, writer) for constant in statement.constants],
        "contexts": [_context(context, writer) for context in statement.contexts],
        "obligations": [_row(row, found.claimed, writer) for row, found in outcome.rows],
        "assumptions": [assumption._asdict() for assumption in statement.assumptions],
        "cites": [
            {
                "name": cite.name,
                "theorem": cite.theorem,
                "statement_sha256": _cite_digest(cite.content),
            }
            for cite in statement.cites
        ],
    }


def _constant(constant: Constant, writer: TermWriter) -> dict[str, Any]:
    return constant._asdict() | {"term": writer.term(constant.term)}


def _context(context: Context, writer: TermWriter) -> dict[str, Any]:
    return context._asdict() | {
        "variables": [variable._asdict() for variable in context.variables],
        "givens": [g._asdict() | {"claim": writer.claim(g.claim)} for g in context.givens],
        "point": writer.table(context.point),
        "constants": [_constant(constant, writer) for constant in context.constants],
    }


def _row(row: Obligation, verdict: str, writer: TermWriter) -> dict[str, Any]:
    return row._asdict() | {
        "claim": writer.claim(row.claim),
        "uses": list(row.uses),
        "verdict": verdict,
    }


# --- the certificate -----------------------------------------------------------------------------


def _certificate(outcome: Outcome, statement: bytes, writer: TermWriter) -> dict[str, Any]:
    rows = {
        name: {"bits": found.sides.bits, "lhs": _pair(found.sides, 0), "rhs": _pair(found.sides, 1)}
        for name, found in outcome.decisions.items()
        if found.sides is not None and found.claimed != UNDECIDED
    }
    return {
        "format": CERTIFICATE_FORMAT,
        "statement_sha256": digest(statement),
        "terms": writer.shared(),
        "steps": [_step(step, writer) for step in outcome.steps],
        "enclosures": {
            "constants": {
                name: {"bits": found.bits, "ends": _pair(found, 0)}
                for name, found in outcome.enclosures.items()
            },
            "rows": rows,
        },
    }


def _pair(enclosure: Enclosure, side: int) -> list[str]:
    return decimals(enclosure.ends[side])


def decimals(ends: Ends) -> list[str]:
    """The decimal texts of two numbers that have at most forty decimal digits."""
    return [decimal_text(*round_decimal(end, 40, up=False)) for end in ends]


def _step(step: Step, writer: TermWriter) -> dict[str, Any]:
    if isinstance(step, OpenStep):
        leaf = partial(writer.leaf, proof_document, "premise")
        return {"open": step.name, "givens": [*map(leaf, step.givens)]}
    proof = {"proof": proof_document(step.proof, writer)}
    if isinstance(step, ConstantStep):
        return {"constant": step.name} | proof
    if isinstance(step, ObligationStep):
        return {"obligation": step.name} | proof
    where = {"context": step.context} | proof
    if isinstance(step, LemmaStep):
        return {"lemma": step.name, "claim": writer.claim(step.claim)} | where
    return {"define": step.name, "term": writer.term(step.term)} | where


def proof_document(proof: Proof, writer: TermWriter) -> dict[str, Any] | int:
    """A proof as JSON: its rule and its fields, or just the bits of enclosures without bounds."""
    if type(proof) is Interval and not proof.bounds:
        return proof.bits
    return {"rule": rule_of(proof)} | mapped(proof, partial(writer.leaf, proof_document))


def _step_terms(step: Step) -> Iterator[Term]:
    """Every term that is written down in a step."""
    if isinstance(step, LemmaStep):
        yield from (step.claim.lhs, step.claim.rhs)
    if isinstance(step, DefinitionStep):
        yield step.term
    for proof in step.givens if isinstance(step, OpenStep) else (step.proof,):
        yield from _proof_terms(proof)


#: The leaves of proofs in which there may be terms.
_WITH_TERMS = {"proof", "premise", "claim", "term", "value"}


def _proof_terms(proof: Any) -> Iterator[Term]:
    bare = isinstance(proof, str) or _WITH_TERMS.isdisjoint(leaf_names(proof))
    for leaf, item in () if bare else leaves(proof):
        if leaf in ("proof", "premise"):
            yield from _proof_terms(item)
        elif leaf == "claim":
            yield from (item.lhs, item.rhs)
        elif leaf in ("term", "value"):
            yield from _value_terms(item)


def _value_terms(value: Any) -> Iterator[Term]:
    if isinstance(value, Term):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _value_terms(item)


def encode(document: Mapping[str, Any]) -> bytes:
    """The bytes of a document: sorted keys, one line per entry of a list or table.

    Raises:
        InputError: if a text in it has half of a letter.
    """
    parts = [f"{_compact(key)}: {_lines(document[key])}" for key in sorted(document)]
    try:
        return ("{\n" + ",\n".join(parts) + "\n}\n").encode()
    except UnicodeEncodeError as error:
        half = error.object[error.start]
        raise InputError(f"{half!r} in a text is half of a letter; write the letter") from error


def _lines(value: Any) -> str:
    if isinstance(value, list) and value:
        return "[\n" + ",\n".join(map(_compact, value)) + "\n]"
    if isinstance(value, dict) and value:
        rows = (f"{_compact(key)}: {_compact(value[key])}" for key in sorted(value))
        return "{\n" + ",\n".join(rows) + "\n}"
    return _compact(value)


_compact = json.JSONEncoder(ensure_ascii=False, sort_keys=True).encode


def cite_of_outcome(outcome: Outcome) -> Cite:
    """The citation of what an outcome proves, under its theorem's name."""
    files, said = write(outcome), outcome.statement
    content, certificate = files["statement.json"], files["certificate.json"]
    return Cite(said.theorem, said.theorem, content, said.cites, said.assumptions, certificate)
