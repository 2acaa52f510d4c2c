"""A certificate as data: proofs, steps, and enclosures."""

from __future__ import annotations

import re
from fractions import Fraction

from verify import check
from verify.prover.proof import Shape, shapes
from verify.prover.rules import RULES
from verify.wire.coq.reading import Json, NotAcceptedError
from verify.wire.coq.statement import Numbers, listed, rational

#: The bits with which Coq tries first.
LOWEST = 128
#: The words of a choice: a side of a claim, or a function that rises.
WORDS = {
    "lhs": "Left", "rhs": "Right", None: "None", "sqrt": "(Some SquareRoot)",
    "exp": "(Some (Elementary Exp))", "log": "(Some (Elementary Log))",
    "atan": "(Some (Elementary Atan))",
}  # fmt: skip


#: For each rule the constructor of its proofs, and the fields in the order in which it takes them.
CONSTRUCTORS = {
    "cuts": "Cuts term at branches",
    "cases": "Cases of branches",
    "entry": "Entry side equation",
    "least": "Least side equation branches",
    "root": "PositiveRoot",
    "antisymmetry": "Antisymmetry branches",
    "angles": "Angles",
    "cosine": "Cosine_",
    "range": "Range",
    "law": "Law",
    "monotony": "Monotony under premise",
    "sum": "BySum using addends equations",
}


class Proofs(Numbers):
    """What is in a certificate, with the numbers of its statement."""

    def read(self, value: Json, context: check.Context) -> int:
        """The term that is written at a place."""
        return self.kernel.read("term", value, context)

    def values(self, value: Json, of: check.Context, context: check.Context) -> str:
        """Terms at a place for the variables of another context."""
        at = self.kernel.values("at", value, of, check.Place(context))
        return self.substitution(of, at)

    def proofs(self, proofs: list[Json], context: check.Context) -> str:
        """Branches or premises."""
        return listed(self.proof(proof, context) for proof in proofs)

    def proof(self, proof: Json, context: check.Context) -> str:
        """A proof, or a premise that is a fact."""
        if isinstance(proof, str):
            return f"Given_ {self.reference(proof)}"
        rule = check.rule_of(proof, check.RULES)
        if rule == "interval":
            return f"Interval {self.precision(proof)}"
        if rule == "instance":
            return self.instance(proof, context)
        if rule not in CONSTRUCTORS:
            raise NotAcceptedError(f"the checker in Coq has no rule {rule}")
        (found,) = (shapes(proofs) for proofs, known in RULES.items() if known.name == rule)
        name, *fields = CONSTRUCTORS[rule].split()
        parts = [self.field(found[key], proof[key], context) for key in fields]
        if fields[-1:] == ["premise"]:
            parts[-1] = f"({parts[-1]})"
        return " ".join([name, *parts])

    def field(self, shape: Shape, value: Json, context: check.Context) -> str:
        """What a field holds; a list of proofs that has a fixed length is a list, too."""
        if shape.form == "choice":
            return WORDS[value]
        if shape.form == "leaf":
            return self.leaf(shape.of[0], value, context)
        if shape.form == "optional":
            return "None" if value is None else f"(Some {self.field(shape.of[0], value, context)})"
        shapes_ = shape.of if shape.form == "row" else shape.of * len(value)
        parts = [self.field(*pair, context) for pair in zip(shapes_, value, strict=True)]
        is_pair = shape.form == "row" and shape.of[0].of != ("proof",)
        return f"({', '.join(parts)})" if is_pair else listed(parts)

    def leaf(self, kind: str, value: Json, context: check.Context) -> str:
        """A term, a number as a term, a fact, a proof or a premise, or what is >= 0."""
        match kind:
            case "term":
                return self.term(self.read(value, context))
            case "number":
                return self.term(self.kernel.rational(check.rational(value)))
            case "reference":
                return self.reference(value)
            case "value":
                return self.addend(value, context)
        return self.proof(value, context)

    def precision(self, proof: Json) -> str:
        """The bits and the bounds of an enclosure."""
        bits, found = check.precision(proof)
        bounds = (
            f"Bound {self.term(self.kernel.names[name])} {self.reference(low)} {self.reference(up)}"
            for name, low, up in found
        )
        return f"{bits} {listed(bounds)}"

    def addend(self, item: Json, context: check.Context) -> str:
        """A factor that is at least 0: a number, the goal, a fact or a square."""
        if isinstance(item, str):
            if re.fullmatch(check.RATIONAL, item):
                return f"Number {rational(check.rational(item))}"
            return "Goal" if item == "goal" else f"Known {self.reference(item)}"
        kind, *rest = item
        if kind in ("square", "root"):
            return f"{kind.capitalize()} {self.term(self.read(rest[0], context))}"
        if kind == "pow":
            return f"Power ({self.addend(rest[0], context)}) {rest[1]}"
        parts = listed(self.addend(part, context) for part in rest)
        return f"{'Sum' if kind == 'add' else 'Product'} {parts}"

    def instance(self, proof: Json, context: check.Context) -> str:
        """The fact, the terms for its variables, and the premises."""
        known: dict[str, check.Fact | check.Row] = {
            **self.reading.statement.rows,
            **self.kernel.facts,
        }
        home = known[proof["of"]].context if proof["of"] in known else context
        at = self.values(proof["at"], home, context)
        premises = self.proofs(proof["givens"], context)
        return f"Instance {self.name(proof['of'])} {at} {premises}"

    def step(self, step: Json) -> str:
        """A step."""
        if "open" in step:
            context = self.kernel.contexts[step["open"]]
            premises = self.proofs(step["givens"], context.parent or context)
            return f"Open_ {self.home(context)} {premises}"
        if "lemma" in step:
            context = self.find(step["context"])
            claim = self.claim(self.kernel.read_claim("claim", step["claim"], context))
            proof = self.proof(step["proof"], context)
            return f"Lemma_ {self.name(step['lemma'])} {self.home(context)} {claim} ({proof})"
        if "obligation" in step:
            row = self.reading.statement.rows[step["obligation"]]
            return f"Obligation {self.rows[row.name]} ({self.row_proof(row, step['proof'])})"
        name, proof = step["constant" if "constant" in step else "define"], step["proof"]
        is_clear = check.rule_of(proof, check.DEFINING) == "define"
        by = "ByClearing" if is_clear else f"(ByInterval {self.precision(proof)})"
        return f"Constant_ {self.name(name)} {self.term(self.kernel.names[name])} {by}"

    def row_proof(self, row: check.Row, proof: Json) -> str:
        """The proof of a row."""
        claim, here = row.claim, row.context
        if isinstance(claim, check.Applies):
            return f"ByInstance {self.proofs(proof['givens'], here)}"
        if isinstance(claim, check.Always):
            start = self.proofs(proof["start"], here)
            return f"ByInduction {start} {self.proofs(proof['next'], claim.context)}"
        if not (isinstance(proof, dict) and proof["rule"] == "witness"):
            return f"ByProof ({self.proof(proof, here)})"
        outside = here.parent or here
        at = self.values(proof["at"], here, outside)
        premises = self.proofs(proof["givens"], outside)
        return f"ByWitness {at} {premises} ({self.proof(proof['negation'], outside)})"

    def enclosed(self) -> list[tuple[int, int, list[str]]]:
        """Each enclosed term with bits and ends: constants, and the sides of rows."""
        found = self.reading.certificate["enclosures"]
        rows = self.reading.statement.rows
        items = [
            (self.kernel.names[name], value["bits"], value["ends"])
            for name, value in found["constants"].items()
        ]
        for name, value in found["rows"].items():
            claim = rows[name].claim
            if isinstance(claim, check.Claim):
                items.append((claim.lhs, value["bits"], value["lhs"]))
                items.append((claim.rhs, value["bits"], value["rhs"]))
        return items

    def enclosures(self) -> list[str]:
        """The enclosures, written."""
        return [
            f"Ends {self.term(term)} {bits} {' '.join(rational(Fraction(end)) for end in ends)}"
            for term, bits, ends in self.enclosed()
        ]

    def shared(self) -> list[str]:
        """Terms of the root that are enclosed once, for the lowest precision that Coq tries."""
        constants = {
            term
            for scope in self.kernel.grounds.values()
            for term in scope.known
            if term in self.kernel.definitions
        }
        terms = sorted(constants | {term for term, _, _ in self.enclosed()})
        precisions = sorted({LOWEST, *(bits for _, bits, _ in self.enclosed())})
        known = [(bits, terms if bits == LOWEST else sorted(constants)) for bits in precisions]
        return [f"({bits}, {listed(map(self.term, found))})" for bits, found in known]
