"""Small statements with their certificates, built step by step, and the checker's answer.

Terms and claims may be written as in ``min(sqrt(2) - 1, x**2/3) <= 1/(1 - x)``; quotients of whole
numbers are rational numbers.
"""

from __future__ import annotations

import ast
import json
from collections.abc import Mapping, Sequence
from copy import deepcopy
from hashlib import sha256
from typing import Any

from verify import check

Json = Any
Document = dict[str, Any]
BINARY = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "div"}
COMPARE = {ast.Lt: "<", ast.LtE: "<=", ast.Eq: "="}


def term(text: Json) -> Json:
    """The JSON of a term or claim; what is no text stays as it is."""
    if not isinstance(text, str):
        return text
    return tree(ast.parse(text.replace(" = ", " == "), mode="eval").body)


def tree(node: ast.expr) -> Json:
    """The JSON of a syntax tree."""
    match node:
        case ast.Constant(value=value):
            return str(value)
        case ast.Name(id=name):
            return name
        case ast.BinOp(left=ast.Constant(a), op=ast.Div(), right=ast.Constant(b)):
            return f"{a}/{b}"
        case ast.BinOp(left=left, op=ast.Pow(), right=ast.Constant(n)):
            return ["pow", tree(left), str(n)]
        case ast.BinOp(left=left, op=op, right=right):
            return [BINARY[type(op)], tree(left), tree(right)]
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value)):
            return f"-{value}"
        case ast.UnaryOp(op=ast.USub(), operand=inner):
            return ["neg", tree(inner)]
        case ast.Call(func=ast.Name(id=op), args=args):
            return [op, *map(tree, args)]
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            return [COMPARE[type(op)], tree(left), tree(right)]
    raise ValueError(ast.unparse(node))


# --- proofs --------------------------------------------------------------------------------------


def interval(*bounds: Sequence[str], bits: Json = 64) -> Document:
    """Enclosures decide; each bound is a name and the facts that bound it."""
    return {"rule": "interval", "bits": bits, "bounds": [list(bound) for bound in bounds]}


def total(*addends: Json, using: Sequence[str] = (), equations: Json = ()) -> Document:
    """A sum of addends, modulo equations."""
    pairs = [[name, term(cofactor)] for name, cofactor in equations]
    fields = {"using": list(using), "addends": list(addends), "equations": pairs}
    return {"rule": "sum", **fields}


def cuts(of: Json, at: Sequence[str], *branches: Json) -> Document:
    """The claim between neighbouring cuts."""
    return {"rule": "cuts", "term": term(of), "at": list(at), "branches": list(branches)}


def cases(of: Json, *branches: Json) -> Document:
    """The claim for each entry of a min or max."""
    return {"rule": "cases", "of": term(of), "branches": list(branches)}


def entry(side: str, equation: str | None = None) -> Document:
    """A min is at most its entries."""
    return {"rule": "entry", "side": side, "equation": equation}


def least(side: str, *branches: Json, equation: str | None = None) -> Document:
    """What is below all entries is below the min."""
    return {"rule": "least", "side": side, "equation": equation, "branches": list(branches)}


def instance(of: str, at: Mapping[str, Json], *givens: Json) -> Document:
    """A fact at values."""
    values = {name: term(text) for name, text in at.items()}
    return {"rule": "instance", "of": of, "at": values, "givens": list(givens)}


def witness(at: Mapping[str, Json], givens: Sequence[Json], negation: Json) -> Document:
    """Values at which the claim fails."""
    values = {name: term(text) for name, text in at.items()}
    return {"rule": "witness", "at": values, "givens": list(givens), "negation": negation}


def induction(start: Sequence[Json], following: Sequence[Json]) -> Document:
    """Proofs of the carried givens at the start and at the next state."""
    return {"rule": "induction", "start": list(start), "next": list(following)}


INTERVAL = interval()
IDENTITY = total()
ROOT = {"rule": "root"}
ANGLES = {"rule": "angles"}
COSINE = {"rule": "cosine"}
DEFINE = {"rule": "define"}


# --- statements with certificates ----------------------------------------------------------------


class Pair:
    """A statement and its certificate."""

    def __init__(self, theorem: str = "T") -> None:
        self.statement: Document = {
            "format": "verify-statement/2",
            "theorem": theorem,
            "title": f"{theorem}'s title",
            "parameters": {},
            "terms": {},
            "constants": [],
            "contexts": [],
            "obligations": [],
            "assumptions": [],
            "cites": [],
        }
        self.steps: list[Json] = []
        self.terms: Document = {}
        self.enclosures: Document = {"constants": {}, "rows": {}}

    def parameter(self, name: str, value: Json, proof: Json = DEFINE) -> Pair:
        """A parameter and its step."""
        self.statement["parameters"][name] = term(value)
        return self.step(constant=name, proof=proof)

    def constant(self, name: str, value: Json, proof: Json = DEFINE) -> Pair:
        """A constant of the root and its step."""
        item = {"name": name, "label": "L", "letter": name, "tex": name, "term": term(value)}
        self.statement["constants"].append(item)
        return self.step(constant=name, proof=proof)

    def context(
        self,
        name: str,
        point: Mapping[str, Json],
        givens: Mapping[str, Json],
        premises: Sequence[Json] | None = None,
        parent: str | None = None,
    ) -> Pair:
        """A context with variables, the step that opens it, and proofs by intervals at the point.

        A given is a claim, or a claim, its kind, and its assumption.
        """
        parts = {n: g if isinstance(g, tuple) else (g, "plain", None) for n, g in givens.items()}
        item = {
            "name": name,
            "parent": parent,
            "says": "",
            "variables": [{"name": v, "letter": v, "tex": v} for v in point],
            "givens": [
                {"name": n, "claim": term(claim), "kind": kind, "assumption": assumption}
                for n, (claim, kind, assumption) in parts.items()
            ],
            "point": {v: term(value) for v, value in point.items()},
            "constants": [],
        }
        self.statement["contexts"].append(item)
        premises = [INTERVAL] * len(givens) if premises is None else premises
        return self.step(open=name, givens=list(premises))

    def inner(self, context: str, name: str, value: Json, proof: Json = DEFINE) -> Pair:
        """A constant of a context, and its step."""
        item = {"name": name, "label": "L", "letter": name, "tex": name, "term": term(value)}
        found = [c for c in self.statement["contexts"] if c["name"] == context]
        found[0]["constants"].append(item)
        return self.step(constant=name, proof=proof)

    def assume(self, name: str) -> Pair:
        """An assumption."""
        item = {"name": name, "kind": "glue", "label": "L", "sentence": f"sentence of {name}"}
        self.statement["assumptions"].append(item)
        return self

    def cite(self, name: str, other: Pair, theorem: str | None = None) -> Pair:
        """A citation."""
        digest = sha256(other.files()[0]).hexdigest()
        theorem = other.statement["theorem"] if theorem is None else theorem
        item = {"name": name, "theorem": theorem, "statement_sha256": digest}
        self.statement["cites"].append(item)
        return self

    def row(
        self,
        name: str,
        claim: Json,
        proof: Json,
        context: str | None = None,
        verdict: str = "proved",
        role: str = "needed",
    ) -> Pair:
        """An obligation and its step."""
        item = {
            "name": name,
            "context": context,
            "group": "",
            "label": "L",
            "role": role,
            "severity": None,
            "says": "",
            "claim": term(claim),
            "verdict": verdict,
            "uses": [],
            "corrected_by": None,
        }
        self.statement["obligations"].append(item)
        return self if verdict == "undecided" else self.step(obligation=name, proof=proof)

    def lemma(self, name: str, claim: Json, proof: Json, context: str | None = None) -> Pair:
        """A step that proves a claim of the certificate."""
        return self.step(lemma=name, context=context, claim=term(claim), proof=proof)

    def define(
        self, name: str, value: Json, proof: Json = DEFINE, context: str | None = None
    ) -> Pair:
        """A step that introduces a constant of the certificate."""
        return self.step(define=name, context=context, term=term(value), proof=proof)

    def step(self, **fields: Json) -> Pair:
        """A step."""
        self.steps.append(deepcopy(fields))
        return self

    def certificate(self) -> Document:
        """The certificate."""
        return {
            "format": "verify-certificate/2",
            "statement_sha256": sha256(pack(self.statement)).hexdigest(),
            "terms": self.terms,
            "steps": self.steps,
            "enclosures": self.enclosures,
        }

    def files(self) -> tuple[bytes, bytes]:
        """The bytes of both."""
        return pack(self.statement), pack(self.certificate())


def pack(document: Json) -> bytes:
    """The bytes of a document."""
    return json.dumps(document, sort_keys=True).encode()


# --- answers -------------------------------------------------------------------------------------


def answer(*pairs: Pair | tuple[bytes, bytes], cited: Sequence[Pair] = ()) -> tuple[int, list[str]]:
    """The exit code and the report about folders with these files."""
    beside = [pair.files()[0] for pair in cited]
    folders = []
    for i, pair in enumerate(pairs, 1):
        first, second = pair.files() if isinstance(pair, Pair) else pair
        folders.append(check.Folder(f"folder {i}", first, second, beside))
    return check.check_folders(folders)


def verdict(pair: Pair) -> str:
    """``proved`` if all is, or the first complaint."""
    code, lines = answer(pair)
    word = lines[-1].partition(":")[0]
    assert (code, word) in [
        (0, "PROVED"), (1, "REFUTED"), (1, "REFUSED"), (4, "MALFORMED"),
    ]  # fmt: skip
    complaints = [line for line in lines[:-1] if line.startswith("REFUSED")]
    assert bool(complaints) == (word == "REFUSED")
    return "proved" if code == 0 else (complaints or lines[-1:])[0]


def box(*bounds: Sequence[str], point: Sequence[str] = ()) -> Pair:
    """A statement whose context ``box`` has variables x, y, ... between numbers.

    The givens of x are ``x-low`` and ``x-high``; the context's point is the lower corner.
    """
    names = "xyzw"[: len(bounds)]
    givens = {}
    for name, (low, high) in zip(names, bounds, strict=True):
        givens |= {f"{name}-low": ["<=", low, name], f"{name}-high": ["<=", name, high]}
    at = point or [low for low, _ in bounds]
    return Pair().context("box", dict(zip(names, at, strict=True)), givens)


BOUNDS = ("x", "x-low", "x-high")


def in_box(claim: Json, proof: Json, *bounds: Sequence[str]) -> str:
    """What the checker says to a claim about variables in a box, by default x in [0, 1]."""
    return verdict(box(*(bounds or [("0", "1")])).row("row", claim, proof, "box"))


def ground(claim: Json, proof: Json) -> str:
    """What the checker says to a claim without variables."""
    return verdict(Pair().row("row", claim, proof))
