"""The readable form: every constant a definition, every row a lemma in ordinary notation.

Coq reads the terms back from their numbers and compares by conversion, so that nothing written here
has to be believed: a lemma that does not say what the row says does not compile.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable
from itertools import count

from verify import check
from verify.wire.coq.proofs import Proofs
from verify.wire.coq.reading import NotAcceptedError, Reading
from verify.wire.coq.statement import whole

HEAD = """
(* --- the same in ordinary notation --- *)

From Coq Require Import Reals.
From Verify Require Import Terms Readable.
Open Scope R_scope.

Definition the_table := Eval vm_compute in table (numbered the_statement).
Lemma the_table_is : table (numbered the_statement) = the_table.
Proof. vm_cast_no_check (eq_refl the_table). Qed.
Lemma the_order : ordered (numbered the_statement) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma the_rows_hold : Forall (row_true the_statement) (rows the_statement).
Proof. apply PROVED. Qed.
Definition values_0 : values := [].
Lemma right_0 : right_values the_statement values_0.
Proof. constructor. Qed.
"""


def readable(reading: Reading, form: Readable, names: Collection[str] | None) -> list[str]:
    """What is added to the exported file; of the rows those that are named, or all."""
    constants = [form.constant(i, term) for i, term in enumerate(form.constants, 1)]
    found = enumerate(reading.statement.rows.values(), 1)
    rows = [form.row(i, row) for i, row in found if names is None or row.name in names]
    constants += [form.end(), *map(form.variable, form.variables)]
    constants += map(form.context, reading.kernel.contexts, count(1))
    if not reading.cites:
        return [HEAD.replace("PROVED", "proved"), *constants, *rows]
    given = "Section Citing.\nHypothesis the_citations_hold : citations_true the_statement."
    head = HEAD.replace("PROVED", "(proved the_citations_hold)").replace(
        "Lemma the_rows", f"{given}\nLemma the_rows"
    )
    return [head, *constants, *rows, "End Citing."]


class Readable:
    """Constants and rows of a statement, one after the other."""

    def __init__(self, reading: Reading) -> None:
        self.reading, self.kernel = reading, reading.kernel
        self.notation, self.numbers = Notation(reading), Proofs(reading)
        own = [self.kernel.names[name] for name in reading.reader.own]
        self.constants = sorted((*reading.cited_constants, *own))
        self.count = len(self.constants)

    @property
    def variables(self) -> list[int]:
        """All variables."""
        return [x for c in self.kernel.contexts.values() for x in c.variables.values()]

    def end(self) -> str:
        """All constants."""
        lines = f"Definition all_values := values_{self.count}.\nDefinition all_right := right_"
        return f"\n{lines}{self.count}.\n"

    def variable(self, term: int) -> str:
        """The number of a variable."""
        name = self.notation.bound([term])
        return f"Definition number_of_{name} := {self.numbers.term(term)}%positive."

    def context(self, name: str, number: int) -> str:
        """The number of a context."""
        return f"Definition context_{self.notation.name(name)} := {number}%nat."

    def constant(self, i: int, term: int) -> str:
        """The definition of a constant, and that it is the one of the statement."""
        notation = self.notation
        definition, here = self.kernel.definitions[term], notation.name(notation.names[term])
        variables = notation.variables(term)
        arguments = f" ({notation.bound(variables)} : R)" if variables else ""
        at = "".join(f" (v {self.numbers.term(x)}%positive)" for x in variables)
        number, before = self.numbers.term(term), i - 1
        return f"""
Definition {here}{arguments} : R := {notation.term(definition)}.
Definition shape_{i} := Eval vm_compute in read the_table 400 {self.numbers.term(definition)}.
Definition values_{i} : values := ({number}%positive, fun v => {here}{at}) :: values_{before}.
Lemma right_{i} : right_values the_statement values_{i}.
Proof.
  refine (one_more the_statement the_order the_table the_table_is values_{before} {number}%positive
    _ shape_{i} right_{before} _ (fun v => eq_refl)).
  vm_cast_no_check (eq_refl shape_{i}).
Qed."""

    def row(self, i: int, row: check.Row) -> str:
        """The lemma for a row that is decided."""
        if row.verdict == "undecided":
            return f"\n(* {row.name} is undecided. *)"
        if not isinstance(row.claim, check.Claim):
            return f"""
(* About a whole context, in the words of Meaning.v. *)
Lemma {self.notation.name(row.name)} :
  says the_statement {self.numbers.home(row.context)} {self.numbers.sentence(row)}%positive.
Proof. apply (said_row the_statement the_rows_hold {i - 1}). vm_compute. reflexivity. Qed."""
        says = self.proved if row.verdict == "proved" else self.refuted
        rule = f"{row.verdict}_row the_statement the_order the_table the_table_is the_rows_hold"
        here = self.notation.name(row.name)
        fact = f"({rule}\n    all_values {i - 1} _ _ all_right row_of_{here}_is)"
        claim, proof = says(row.context, self.notation.claim(row.claim), fact)
        return f"""
Definition row_of_{here} := Eval vm_compute in read_row the_statement the_table {i - 1}.
Lemma row_of_{here}_is : read_row the_statement the_table {i - 1} = row_of_{here}.
Proof. vm_cast_no_check (eq_refl row_of_{here}). Qed.
Lemma {here} : {claim}.
Proof. {proof} Qed."""

    def scope(self, context: check.Context) -> tuple[list[int], list[str]]:
        """The variables and the givens in scope, the outermost first."""
        around = (*context.outside, context)
        variables = [x for c in around for x in c.variables.values()]
        return variables, [self.notation.claim(a.claim) for c in around for a in c.givens]

    def proved(self, context: check.Context, claim: str, fact: str) -> tuple[str, str]:
        """For all values that satisfy the givens."""
        variables, givens = self.scope(context)
        says = " -> ".join([*givens, claim])
        if not variables:
            return says, f"exact ({fact} (fun _ => 0))."
        bound = self.notation.bound(variables)
        cases = " | ".join(
            f"{self.numbers.term(x)}%positive => {self.notation.bound([x])}" for x in variables
        )
        valuation = f"(fun i => match i with {cases} | _ => 0 end)"
        return f"forall {bound} : R,\n  {says}", f"intros {bound}. exact ({fact} {valuation})."

    def refuted(self, context: check.Context, claim: str, fact: str) -> tuple[str, str]:
        """There are values that satisfy the givens and not the claim."""
        variables, givens = self.scope(context)
        says = " /\\ ".join([*givens, f"~ ({claim})"])
        if variables:
            says = f"exists {self.notation.bound(variables)} : R,\n  {says}"
        there = "".join(f" exists (v {self.numbers.term(x)}%positive)." for x in variables)
        return says, f"destruct {fact} as [v H].{there} exact H."


SYMBOLS = {"add": (" + ", 1), "sub": (" - ", 1), "mul": (" * ", 2), "div": (" / ", 2)}
RELATIONS = {"<": "<", "<=": "<=", "=": "=", "!=": "<>"}
FUNCTIONS = {
    "sqrt": "sqrt", "cos": "cos", "exp": "exp", "log": "ln", "sin": "sin", "atan": "atan",
}  # fmt: skip
#: A name of these is Coq's, or one that the file needs.
TAKEN = (
    "Axiom CoFixpoint Definition Fixpoint Hypothesis Parameter Theorem Variable by "
    "as at cofix else end exists exists2 fix for forall fun if in let match mod return then using "
    "where with Prop Set Type SProp R Rmin Rmax sqrt cos exp ln sin atan nth_root PI v fst snd "
    "Some None nil cons pair true false eq_refl values show read table numbered Qmake list nat "
    "positive accepted proved Always Applies Forall citations_true one_more ordered proved_row "
    "read_row refuted_row right_values row_true rows said_row says"
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
        self.letters = 0  # in all that is written
        self.depends: dict[int, tuple[int, ...]] = {}

    def name(self, name: str) -> str:
        """A name for Coq, always the same one."""
        if name not in self.given:
            found = re.sub("[^A-Za-z0-9_]", "_", name)
            while not {found, f"{found}_is"}.isdisjoint(self.used) or re.match(
                r"(the|row|shape|values|right|number|context|all)_", found
            ):
                found = f"{found}_" if found in self.used else f"its_{found}"
            self.used |= {found, f"{found}_is"}
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
            self.letters += len(self.written[term][0])
            if len(self.written[term][0]) > MAX_LETTERS or self.letters > 100 * MAX_LETTERS:
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
        if op in ("min", "max"):
            first, *others = subterms
            text = self.term(first, 4)
            for other in reversed(others):
                text = f"(R{op} {self.term(other, 4)} {text})"
            return text[1:-1], 3
        return self.function(term)

    def function(self, term: int) -> tuple[str, int]:
        """A function of Coq's library, or a root."""
        op, subterms, rest = self.kernel.nodes[term]
        if op == "pi":
            return "PI", 4
        if op == "root":
            return f"nth_root {rest[0]} {self.term(subterms[0], 4)}", 3
        if op == "cos_pi":
            return f"cos (PI * {self.term(subterms[0], 3)})", 3
        if op not in FUNCTIONS:
            raise NotAcceptedError(f"the checker in Coq has no operation {op}")
        return f"{FUNCTIONS[op]} {self.term(subterms[0], 4)}", 3

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
