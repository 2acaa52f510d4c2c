"""A statement as data: nodes, contexts, rows, and what is cited."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from verify import check
from verify.wire.coq.reading import NotAcceptedError, Reading

RELATIONS = {"<": "Less", "<=": "AtMost", "=": "Equal", "!=": "Differs"}
#: The nodes of at most two subterms; a constant, a variable, and the rest have more to them.
NODES = {
    "add": "NAdd", "sub": "NSub", "mul": "NMul", "div": "NDiv", "neg": "NNeg", "sqrt": "NSqrt",
    "cos": "NCos", "cos_pi": "NCosPi", "pi": "NPi", "exp": "NOf Exp", "log": "NOf Log",
    "sin": "NOf Sin", "atan": "NOf Atan",
}  # fmt: skip


def listed(items: Iterable[str], separator: str = "; ") -> str:
    """A list in Coq."""
    return f"[{separator.join(items)}]"


def rational(value: Fraction) -> str:
    """A rational number in Coq."""
    return f"(Qmake ({whole(value.numerator)}) {whole(value.denominator)})"


def whole(number: int) -> str:
    """A whole number in Coq, which reads long ones faster in hexadecimal digits."""
    return str(number) if abs(number) < 1 << 64 else hex(number)


class Numbers:
    """What is in a statement, with the numbers of terms, contexts, rows and facts."""

    def __init__(self, reading: Reading) -> None:
        self.reading, self.kernel = reading, reading.kernel
        self.contexts = {name: i for i, name in enumerate(self.kernel.contexts, 1)}
        self.facts: dict[str, int] = {}
        self.rows = {name: i for i, name in enumerate(reading.statement.rows, 1)}

    # --- numbers ---

    def term(self, number: int) -> str:
        """The number of a term."""
        return str(number + 1)

    def home(self, context: check.Context) -> int:
        """The number of a context; 0 is the root."""
        return self.contexts.get(context.name, 0)

    def find(self, name: str | None) -> check.Context:
        """The context of a name."""
        return self.reading.reader.find(name, "")

    def name(self, name: str) -> str:
        """The number of a fact, or of what may become one."""
        return str(self.facts.setdefault(name, len(self.facts) + 1))

    def reference(self, name: str) -> str:
        """A usable fact, or the hypothesis of a branch."""
        return f"(Hypothesis_ {name[1:]})" if name.startswith("@") else f"(Fact {self.name(name)})"

    # --- the statement ---

    def node(self, number: int) -> str:
        """The node of a term."""
        op, subterms, rest = self.kernel.nodes[number]
        below = [self.term(term) for term in subterms]
        if op == "name":
            home = self.home(self.kernel.homes[number])
            definition = self.kernel.definitions.get(number)
            return f"NVariable {home}" if definition is None else (
                f"NConstant {home} {self.term(definition)}"
            )  # fmt: skip
        if op == "rational":
            return f"NRational ({whole(rest[0])}) {whole(rest[1])}"
        if op == "pow":
            return f"NPow {below[0]} {rest[0]}"
        if op in ("min", "max"):
            return f"N{op.capitalize()} {below[0]} {listed(below[1:])}"
        if op not in NODES:
            raise NotAcceptedError(f"the checker in Coq has no operation {op}")
        return " ".join((NODES[op], *below))

    def claim(self, claim: check.Claim) -> str:
        """A claim that compares two terms."""
        return f"(Claim {RELATIONS[claim.relation]} {self.term(claim.lhs)} {self.term(claim.rhs)})"

    def substitution(self, context: check.Context, at: Mapping[int, int]) -> str:
        """Terms for the variables of a context, in its order."""
        pairs = ((name, at[name]) for name in context.variables.values())
        return listed(f"({self.term(name)}, {self.term(term)})" for name, term in pairs)

    def context(self, context: check.Context) -> str:
        """A context with its variables, givens and point."""
        parent = 0 if context.parent is None else self.home(context.parent)
        variables = listed(map(self.term, context.variables.values()))
        givens = listed(
            f"Given {self.name(given.name)} {self.claim(given.claim)} {given.kind.capitalize()}"
            for given in context.givens
        )
        point = self.substitution(context, context.point)
        return f"Context {parent} {variables} {givens} {point}"

    def row(self, row: check.Row) -> str:
        """A row."""
        needed = "true" if row.role == "needed" else "false"
        about = f"{row.verdict.capitalize()} {needed} {self.sentence(row)}"
        return f"Row {self.name(row.name)} {self.home(row.context)} {about}"

    def sentence(self, row: check.Row) -> str:
        """What a row claims."""
        claim = row.claim
        if isinstance(claim, check.Applies):
            at = self.substitution(claim.context, claim.at)
            return f"(Applies {self.home(claim.context)} {at})"
        if isinstance(claim, check.Always):
            start = self.substitution(claim.context, claim.start)
            following = self.substitution(claim.context, claim.next)
            return f"(Always {self.home(claim.context)} {start} {following})"
        return f"(Compare {self.claim(claim)})"

    def fact(self, name: str, fact: check.Fact) -> str:
        """A fact of a cited statement."""
        return f"({self.name(name)}, ({self.home(fact.context)}%nat, {self.claim(fact.claim)}))"
