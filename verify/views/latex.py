"""A statement as LaTeX source beside the numbers of its certificate, for a referee."""

from __future__ import annotations

import json
from collections.abc import Iterator
from typing import Any

from verify.cli.inputs import InputError
from verify.language.terms import Claim
from verify.views.typeset import Typesetter
from verify.wire.wire import WireError, term_from_document

_PREAMBLE = r"""\documentclass{article}
\usepackage[landscape,margin=1cm]{geometry}
\usepackage{amsmath,amssymb,longtable}
\begin{document}"""


def statement_source(statement: bytes, certificate: bytes) -> str:
    """A LaTeX document with every constant and every obligation of a statement.

    Raises:
        InputError: if the files are not a statement and a certificate.
    """
    try:
        lines = list(_lines(json.loads(statement), json.loads(certificate)))
    except (KeyError, TypeError, ValueError, AttributeError, RecursionError) as error:
        raise InputError(f"path: not a statement with its certificate ({error!r:.60})") from error
    return "\n".join(lines) + "\n"


def _lines(statement: dict[str, Any], certificate: dict[str, Any]) -> Iterator[str]:
    typesetter = Typesetter(_letters(statement), latex=True)
    yield _PREAMBLE
    yield rf"\section*{{{_escape(statement['title'])}}}"
    yield r"\begin{longtable}{lll}"
    for constant in statement["constants"]:
        letter = typesetter.term(term_from_document(constant["name"]))
        term = typesetter.term(term_from_document(constant["term"]))
        low, high = certificate["enclosures"][constant["name"]]
        yield rf"${letter}$ & $\displaystyle {term}$ & $[{low}, {high}]$ \\"
    yield r"\end{longtable}"
    yield r"\begin{longtable}{lll}"
    proofs = {proof["obligation"]: proof for proof in certificate["proofs"]}
    for row in statement["obligations"]:
        claim = _claim(row["claim"], typesetter)
        sides = proofs[row["name"]]
        numbers = " ".join(
            rf"${side}$: $[{', '.join(sides[side])}]$" for side in ("lhs", "rhs") if side in sides
        )
        yield rf"\texttt{{{_escape(row['label'])}}} & $\displaystyle {claim}$ & {numbers} \\"
    yield r"\end{longtable}"
    yield r"\end{document}"


def _letters(statement: dict[str, Any]) -> dict[str, str]:
    letters = {"r": "r", "c": r"(-\cos\theta_0)", "V_0": "V_0", "delta_theta": r"\delta_\theta"}
    for constant in statement["constants"]:
        group, _, _ = constant["name"].rpartition(".")
        mark = rf"^{{\text{{{group}}}}}" if group else ""
        letters[constant["name"]] = f"{{{constant['tex']}}}{mark}"
    return letters


def _claim(document: Any, typesetter: Typesetter) -> str:
    relation, *parts = document
    if relation == "not":
        return rf"\neg\left({_claim(parts[0], typesetter)}\right)"
    if relation not in ("<", "<=", "="):
        raise WireError(f"{relation!r} is not a relation")
    return typesetter.claim(Claim(relation, *map(term_from_document, parts)))


def _escape(text: str) -> str:
    for character in "&%#_{}":
        text = text.replace(character, "\\" + character)
    return text.replace("^", r"\^{}").replace("θ", r"$\theta$").replace("√", r"$\surd$")
