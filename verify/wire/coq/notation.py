"""Terms and claims in the notation of Coq's real numbers, and names that Coq accepts."""

from __future__ import annotations

import re
from collections.abc import Iterable

from verify import check
from verify.wire.coq.reading import NotAcceptedError, Reading
from verify.wire.coq.statement import whole

SYMBOLS = {"add": (" + ", 1), "sub": (" - ", 1), "mul": (" * ", 2), "div": (" / ", 2)}
RELATIONS = {"<": "<", "<=": "<=", "=": "="}
#: A name of these is Coq's, or one that the file needs.
TAKEN = (
    "as at cofix else end exists exists2 fix for forall fun if in let match mod return then using "
    "where with Prop Set Type SProp R Rmin Rmax sqrt cos PI v fst snd Some None nil cons pair true "
    "false eq_refl values show read table numbered Qmake list nat positive"
)
#: A term that is longer in letters is not readable.
MAX_LETTERS = 200_000


class Notation:
    """How the terms of a statement are written; each name gets another one that Coq accepts."""

    def __init__(self, reading: Reading) -> None:
        self.kernel = reading.kernel
        self.given: dict[str, str] = {}
        self.used = set(TAKEN.split())
        self.names = {term: name for name, term in self.kernel.names.items()}
        self.written: dict[int, tuple[str, int]] = {}
        self.depends: dict[int, tuple[int, ...]] = {}

    def name(self, name: str) -> str:
        """A name for Coq, always the same one."""
        if name not in self.given:
            found = re.sub("[^A-Za-z0-9_]", "_", name)
            while found in self.used or re.match(
                r"(the|row|shape|values|right|number|all)_", found
            ):
                found = f"{found}_" if found in self.used else f"its_{found}"
            self.used.add(found)
            self.given[name] = found
        return self.given[name]

    def variables(self, term: int) -> tuple[int, ...]:
        """The variables on which a term depends, in the order of their numbers."""
        if term not in self.depends:
            node, kernel = self.kernel.nodes[term], self.kernel
            if term in kernel.definitions:
                below: Iterable[int] = self.variables(kernel.definitions[term])
            elif node.op == "name":
                below = (term,)
            else:
                below = {name for part in node.subterms for name in self.variables(part)}
            self.depends[term] = tuple(sorted(below))
        return self.depends[term]

    def term(self, term: int, strength: int = 0) -> str:
        """A term, in brackets where it binds less than asked for."""
        if term not in self.written:
            self.written[term] = self.compose(term)
            if len(self.written[term][0]) > MAX_LETTERS:
                raise NotAcceptedError(
                    f"a term has more than {MAX_LETTERS} letters, for --readable"
                )
        text, own = self.written[term]
        return f"({text})" if own < strength else text

    def compose(self, term: int) -> tuple[str, int]:
        """The text of a term, and how strongly it binds: 1 for sums to 4 for atoms."""
        op, subterms, rest = self.kernel.nodes[term]
        if op == "name":
            return self.named(term)
        if op == "rational":
            if rest[1] == 1:
                return whole(rest[0]), 4 if rest[0] >= 0 else 0
            return f"{whole(rest[0])} / {whole(rest[1])}", 2 if rest[0] >= 0 else 0
        if op in SYMBOLS:
            sign, own = SYMBOLS[op]
            return f"{self.term(subterms[0], own)}{sign}{self.term(subterms[1], own + 1)}", own
        if op == "neg":
            return f"- {self.term(subterms[0], 4)}", 0
        if op == "pow":
            return f"{self.term(subterms[0], 4)} ^ {rest[0]}", 3
        if op == "cos_pi":
            return f"cos (PI * {self.term(subterms[0], 3)})", 3
        if op in ("min", "max"):
            first, *others = subterms
            text = self.term(first, 4)
            for other in reversed(others):
                text = f"(R{op} {self.term(other, 4)} {text})"
            return text[1:-1], 3
        return f"{op} {self.term(subterms[0], 4)}", 3

    def named(self, term: int) -> tuple[str, int]:
        """A variable, or a constant at the variables on which it depends."""
        name = self.name(self.names[term])
        if term not in self.kernel.definitions or not self.variables(term):
            return name, 4
        return f"{name} {' '.join(self.name(self.names[x]) for x in self.variables(term))}", 3

    def claim(self, claim: check.Claim) -> str:
        """A claim."""
        return f"{self.term(claim.lhs)} {RELATIONS[claim.relation]} {self.term(claim.rhs)}"

    def bound(self, variables: Iterable[int]) -> str:
        """Variables after a quantifier."""
        return " ".join(self.name(self.names[x]) for x in variables)
