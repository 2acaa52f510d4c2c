"""Statement and certificate as JSON: the two files that pass the wall to the checker.

Format (version 1; every number is a string, so that no reader rounds it):

* A *term* is a rational ``"3/100"`` (a text that starts with a digit or a minus sign), a name
  ``"alpha_0"`` (a text that starts with a letter), or a list of an operation and its arguments:
  ``add sub mul div`` with two, ``neg sqrt cos cos_pi`` with one, ``min max`` with two or more,
  and ``["pow", a, "2"]``, whose exponent is a positive integer as a text. ``cos_pi`` of x is
  cos(pi x).
* A *claim* is ``["<", lhs, rhs]``, ``["<=", lhs, rhs]``, ``["=", lhs, rhs]`` or
  ``["not", claim]``.
* The *statement* has ``format``, ``theorem``, ``title``, ``parameters`` (name to term),
  ``constants`` (in order of definition: ``name``, ``label``, ``tex``, ``term``), ``obligations``
  and ``assumptions`` (``name``, ``label``, ``sentence``). An obligation has ``name``, ``label``,
  ``role``, ``says``, ``claim``, ``uses`` (names of assumptions) and ``variables``: for each
  universally quantified symbol of the claim the open interval in which it lies, a pair of
  rationals, or of null where it is unbounded. A row that was refuted stands in the statement as
  the negation of its claim.
* The *certificate* has ``format``, ``statement_sha256`` (of the bytes of the statement),
  ``enclosures`` (constant to a pair of decimal texts) and ``proofs``, one for each obligation in
  the statement's order, with ``obligation`` and ``rule``, and ``lhs`` and ``rhs`` (enclosures of
  the two sides) where the claim has no variables.

A negation without variables is read as the opposite inequality. The rules and their fields:

* ``interval``: the enclosures of the two sides at ``bits`` bits decide.
* ``exact``: both sides are rational and decide.
* ``rewrite``: ``steps`` are pairs of a constant and either null (the constant is replaced by its
  definition) or the index of an entry of the min that defines it (it is replaced by that entry;
  allowed only if raising the constant can only raise lhs and lower rhs). After the steps, the
  claim holds by ``closing``: ``interval`` (at ``bits``) or ``identity``: the two sides are the
  same rational function of symbols, variables and square roots.
* ``bernstein``: for one variable in a bounded interval: rhs - lhs is a polynomial whose Bernstein
  coefficients of degree ``degree`` are all non-negative, and for ``<`` not all zero.
* ``cuts``: ``cuts`` gives for each variable increasing rationals from its lower to its upper
  bound; on each box between cuts the enclosures at ``bits`` decide.
* ``witness``: for a negation: ``point`` gives each variable a value inside its interval for which
  the claim is false, by exact values or by enclosures at ``bits``.
* ``square``: both sides are non-negative by enclosures at ``bits``, and the claim between their
  squares holds by the proof ``then``.

Both are written with sorted keys and without anything that depends on the day or the machine.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from fractions import Fraction
from hashlib import sha256
from typing import Any

from verify.prover.decimals import outward, rational_text
from verify.prover.ground import PROVED, Decision, Prover
from verify.language.statement import Obligation, Statement
from verify.language.terms import Claim, Term, as_term, symbol
from verify.jobs.theorem1 import Outcome
from verify.views.typeset import Typesetter

STATEMENT_FORMAT = "verify-statement/1"
CERTIFICATE_FORMAT = "verify-certificate/1"

OPERATIONS = ("add", "sub", "mul", "div", "neg", "pow", "sqrt", "min", "max", "cos", "cos_pi")


class WireError(ValueError):
    """A document that does not have the described form."""


#: Digits of the enclosures in a certificate: few enough that every version of FLINT agrees on
#: them, because they come from at least `verify.prover.ground.REPORTED_BITS` relative bits.
DIGITS = 20


def term_document(term: Term) -> Any:
    """A term as JSON."""
    if term.op == "rational":
        return rational_text(term.value)
    if term.op == "symbol":
        return term.name
    if term.op == "pow":
        return ["pow", term_document(term.children[0]), str(term.exponent)]
    return [term.op, *map(term_document, term.children)]


def term_from_document(document: Any) -> Term:
    """The term that a JSON document stands for.

    Raises:
        WireError: for anything that is not a term.
    """
    if isinstance(document, str) and document:
        if document[0].isalpha():
            return symbol(document)
        if re.fullmatch(r"-?[0-9]+(/[0-9]*[1-9][0-9]*)?", document):
            return as_term(Fraction(document))
    if isinstance(document, list) and document and document[0] in OPERATIONS:
        op, *arguments = document
        if op == "pow":
            base, exponent = arguments
            return term_from_document(base) ** int(exponent)
        return Term(op, *map(term_from_document, arguments))
    raise WireError(f"{str(document)[:40]!r} is not a term")


def claim_document(claim: Claim, proved: bool) -> Any:
    """A proved claim, or the negation of a refuted one."""
    document = [claim.relation, term_document(claim.lhs), term_document(claim.rhs)]
    return document if proved else ["not", document]


def statement_document(
    statement: Statement,
    definitions: Mapping[str, Term],
    rows: Sequence[tuple[Obligation, Decision]],
    title: str,
) -> dict[str, Any]:
    """The statement with its parameters and chosen constants bound and its rows decided."""
    return {
        "format": STATEMENT_FORMAT,
        "theorem": statement.theorem,
        "title": title,
        "parameters": {name: term_document(definitions[name]) for name in statement.parameters},
        "constants": [
            {
                "name": constant.name,
                "label": constant.label,
                "tex": constant.tex,
                "term": term_document(definitions[constant.name]),
            }
            for constant in statement.constants
            if constant.name in definitions
        ],
        "obligations": [
            {
                "name": row.name,
                "label": row.label,
                "role": row.role,
                "says": row.says,
                "claim": claim_document(row.claim, decision.verdict == PROVED),
                "uses": list(row.uses),
                "variables": {
                    variable.name: [
                        None if bound is None else rational_text(bound)
                        for bound in (variable.lower, variable.upper)
                    ]
                    for variable in row.variables
                },
            }
            for row, decision in rows
        ],
        "assumptions": [
            {"name": a.name, "label": a.label, "sentence": a.sentence}
            for a in statement.assumptions
        ],
    }


def certificate_document(
    prover: Prover,
    statement: Statement,
    rows: Sequence[tuple[Obligation, Decision]],
    statement_bytes: bytes,
) -> dict[str, Any]:
    """What was hard to find, tied to the statement by its digest."""
    return {
        "format": CERTIFICATE_FORMAT,
        "statement_sha256": sha256(statement_bytes).hexdigest(),
        "enclosures": {
            constant.name: _pair(prover.enclose(prover.definitions[constant.name]))
            for constant in statement.constants
            if constant.name in prover.definitions
        },
        "proofs": [_proof(row, decision) for row, decision in rows],
    }


def _proof(row: Obligation, decision: Decision) -> dict[str, Any]:
    proof = {
        "obligation": row.name,
        "rule": decision.method,
        "bits": decision.bits,
        "lhs": _pair(decision.lhs),
        "rhs": _pair(decision.rhs),
    }
    if decision.method == "rewrite":
        proof["steps"] = [list(step) for step in decision.steps]
        proof["closing"] = decision.closing
    return proof


def _pair(ends: tuple[Fraction, Fraction] | None) -> list[str]:
    if ends is None:
        raise ValueError("a certificate needs finite enclosures")
    return outward(ends, DIGITS)


def files(outcome: Outcome) -> dict[str, bytes]:
    """The two files of a decided outcome."""
    rows, prover, statement = outcome.decided_rows, outcome.prover, outcome.statement
    first = encode(statement_document(statement, prover.definitions, rows, title(outcome)))
    second = encode(certificate_document(prover, statement, rows, first))
    return {"statement.json": first, "certificate.json": second}


def title(outcome: Outcome) -> str:
    """What the statement is about, in one line."""
    typesetter = Typesetter({})
    values = ", ".join(
        f"{name} = {typesetter.term(outcome.prover.definitions[name])}"
        for name in outcome.statement.parameters
    )
    return f"{outcome.statement.theorem} ({outcome.selection} constants) at {values}"


def encode(document: Mapping[str, Any]) -> bytes:
    """The bytes of a document: sorted keys, one line per entry of a list, a final line feed."""
    parts = []
    for key in sorted(document):
        value = document[key]
        if isinstance(value, list) and value:
            text = "[\n" + ",\n".join(map(_compact, value)) + "\n]"
        else:
            text = _compact(value)
        parts.append(f"{_compact(key)}: {text}")
    return ("{\n" + ",\n".join(parts) + "\n}\n").encode()


def _compact(value: Any) -> str:
    return json.dumps(value, ensure_ascii=False, sort_keys=True)
