"""A certificate as data: proofs, steps, and enclosures."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction

from verify import check
from verify.wire.coq.reading import Json, NotAcceptedError
from verify.wire.coq.statement import Numbers, listed, rational

#: The bits with which Coq tries first.
LOWEST = 128
SIDES = {"lhs": "Left", "rhs": "Right"}


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
        if proof["rule"] not in PROOFS:
            raise NotAcceptedError(f"the checker in Coq has no rule {proof['rule']}")
        return PROOFS[proof["rule"]](self, proof, context)

    def interval(self, proof: Json, _: check.Context) -> str:
        """The precision and the bounds."""
        return f"Interval {self.precision(proof)}"

    def precision(self, proof: Json) -> str:
        """The bits and the bounds of an enclosure."""
        bounds = (
            f"Bound {self.term(self.kernel.names[name])} {self.reference(low)} {self.reference(up)}"
            for name, low, up in proof["bounds"]
        )
        return f"{proof['bits']} {listed(bounds)}"

    def cuts(self, proof: Json, context: check.Context) -> str:
        """The term, the cuts as terms, and the branches."""
        points = (self.term(self.kernel.rational(check.rational(text))) for text in proof["at"])
        term = self.term(self.read(proof["term"], context))
        return f"Cuts {term} {listed(points)} {self.proofs(proof['branches'], context)}"

    def cases(self, proof: Json, context: check.Context) -> str:
        """The minimum or maximum, and the branches."""
        term = self.term(self.read(proof["of"], context))
        return f"Cases {term} {self.proofs(proof['branches'], context)}"

    def entry(self, proof: Json, _: check.Context) -> str:
        """The side and the equation."""
        return f"Entry {SIDES[proof['side']]} {self.optional(proof['equation'])}"

    def least(self, proof: Json, context: check.Context) -> str:
        """The side, the equation, and the branches."""
        branches = self.proofs(proof["branches"], context)
        return f"Least {SIDES[proof['side']]} {self.optional(proof['equation'])} {branches}"

    def root(self, _: Json, __: check.Context) -> str:
        """Nothing but its name."""
        return "PositiveRoot"

    def antisymmetry(self, proof: Json, context: check.Context) -> str:
        """The two branches."""
        return f"Antisymmetry {self.proofs(proof['branches'], context)}"

    def angles(self, _: Json, __: check.Context) -> str:
        """Nothing but its name."""
        return "Angles"

    def cosine(self, _: Json, __: check.Context) -> str:
        """Nothing but its name."""
        return "Cosine_"

    def sum(self, proof: Json, context: check.Context) -> str:
        """What is replaced, the addends, and the equations."""
        using = listed(map(self.reference, proof["using"]))
        addends = listed(self.addend(item, context) for item in proof["addends"])
        equations = listed(
            f"({self.reference(name)}, {self.term(self.read(cofactor, context))})"
            for name, cofactor in proof["equations"]
        )
        return f"BySum {using} {addends} {equations}"

    def addend(self, item: Json, context: check.Context) -> str:
        """What is >= 0."""
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
        by = "ByClearing" if proof["rule"] == "define" else f"(ByInterval {self.precision(proof)})"
        return f"Constant_ {self.name(name)} {self.term(self.kernel.names[name])} {by}"

    def row_proof(self, row: check.Row, proof: Json) -> str:
        """The proof of a row."""
        claim, here = row.claim, row.context
        if isinstance(claim, check.Applies):
            return f"ByInstance {self.proofs(proof['givens'], here)}"
        if isinstance(claim, check.Always):
            start = self.proofs(proof["start"], here)
            return f"ByInduction {start} {self.proofs(proof['next'], claim.context)}"
        if proof["rule"] != "witness":
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


#: How each rule is written.
PROOFS: dict[str, Callable[[Proofs, Json, check.Context], str]] = {
    "interval": Proofs.interval,
    "cuts": Proofs.cuts,
    "cases": Proofs.cases,
    "entry": Proofs.entry,
    "least": Proofs.least,
    "root": Proofs.root,
    "antisymmetry": Proofs.antisymmetry,
    "angles": Proofs.angles,
    "cosine": Proofs.cosine,
    "sum": Proofs.sum,
    "instance": Proofs.instance,
}
