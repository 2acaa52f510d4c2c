"""A certificate as data for the checker in Coq (the files in ``verify/coq``).

Terms, contexts and facts get the numbers under which ``verify/check.py`` reads them; that program
has to accept the certificate first. The numbering is not believed: Coq computes what it needs from
the data. What has to be believed is that the data are those in the files.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from hashlib import sha256
from typing import Any, NamedTuple

from verify import check

Json = Any

RELATIONS = {"<": "Less", "<=": "AtMost", "=": "Equal", "!=": "Differs"}
SIDES = {"lhs": "Left", "rhs": "Right"}
#: The nodes of one or two subterms; a constant, a variable, and the rest have more to them.
NODES = {
    "add": "NAdd", "sub": "NSub", "mul": "NMul", "div": "NDiv", "neg": "NNeg", "sqrt": "NSqrt",
    "cos": "NCos", "cos_pi": "NCosPi",
}  # fmt: skip


class NotAcceptedError(ValueError):
    """The certificate does not prove its statement, or is none."""


class Reading(NamedTuple):
    """A statement and its certificate, as the checker has read them."""

    kernel: check.Kernel
    reader: check.Reader
    statement: check.Statement
    theorem: str
    digest: str
    certificate: Json
    cited: dict[str, check.Fact]
    cited_constants: list[int]
    complaints: list[str]


def read(folder: check.Folder) -> Reading:
    """What the checker reads in a folder, with its complaints.

    Raises:
        NotAcceptedError: if a file is not in the format.
    """
    available = {sha256(data).hexdigest(): data for data in (folder.statement, *folder.cited)}
    try:
        document = check.parsed("statement", folder.statement, check.STATEMENT)
        certificate = check.parsed("certificate", folder.certificate, check.CERTIFICATE)
        report = check.check(folder.statement, folder.certificate, available)
        kernel = check.Kernel()
        reader = check.Reader(kernel, available)
        statement = reader.read(document)
        cited, defined = dict(kernel.facts), sorted(kernel.defined)
        kernel.shared |= certificate["terms"]
        for name in certificate["terms"]:
            kernel.introduce(name)
        checking = check.Checking(kernel, reader, statement)
        for step in certificate["steps"]:
            checking.step(step)
        checking.finish(certificate["enclosures"])
    except (check.Malformed, RecursionError) as error:
        raise NotAcceptedError(f"MALFORMED: {error}") from error
    kernel.work = check.MAX_WORK
    complaints = [] if report.verdict == "PROVED" else [report.verdict, *checking.complaints]
    return Reading(
        kernel, reader, statement, document["theorem"], report.digest, certificate, cited, defined,
        complaints,
    )  # fmt: skip


def export(folder: check.Folder) -> str:
    """A Coq file that proves the statement from the certificate.

    Raises:
        NotAcceptedError: for what is no certificate that proves its statement.
    """
    reading = read(folder)
    if reading.complaints:
        raise NotAcceptedError("; ".join(reading.complaints))
    data = Data(reading)
    return "\n".join((data.head(), *data.definitions(), *theorem(data)))


def theorem(data: Data) -> list[str]:
    """What Coq proves: the statement is true, if what it cites is, and so are the enclosures."""
    citing = "" if data.cites_nothing else "citations_true the_statement -> "
    closing = "\n  apply no_citations; vm_compute; reflexivity." if data.cites_nothing else ""
    return [
        "Theorem accepted : accepts the_statement the_certificate = true.",
        "Proof. vm_cast_no_check (eq_refl true). Qed.",
        f"Theorem proved : {citing}true_statement the_statement.",
        f"Proof.\n  apply (accepts_sound _ _ accepted).{closing}\nQed.",
        "Definition enclosed_values := enclosures_sound _ _ accepted.",
        "Print Assumptions proved.",
        "",
    ]


def listed(items: Iterable[str], separator: str = "; ") -> str:
    """A list in Coq."""
    return f"[{separator.join(items)}]"


def rational(value: Fraction) -> str:
    """A rational number in Coq."""
    return f"(Qmake ({value.numerator}) {value.denominator})"


class Data:
    """The definitions for one statement with its certificate."""

    def __init__(self, reading: Reading) -> None:
        self.reading, self.kernel = reading, reading.kernel
        self.contexts = {name: i for i, name in enumerate(self.kernel.contexts, 1)}
        self.facts: dict[str, int] = {}
        self.rows = {name: i for i, name in enumerate(reading.statement.rows, 1)}
        self.cites_nothing = not any(":" in name for name in self.kernel.taken)
        self.steps = [self.step(step) for step in reading.certificate["steps"]]

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

    def optional(self, name: str | None) -> str:
        """A usable fact, or none."""
        return "None" if name is None else f"(Some {self.reference(name)})"

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
            return f"NRational ({rest[0]}) {rest[1]}"
        if op == "pow":
            return f"NPow {below[0]} {rest[0]}"
        if op in ("min", "max"):
            return f"N{op.capitalize()} {below[0]} {listed(below[1:])}"
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
        claim = row.claim
        if isinstance(claim, check.Applies):
            at = self.substitution(claim.context, claim.at)
            sentence = f"(Applies {self.home(claim.context)} {at})"
        elif isinstance(claim, check.Always):
            start = self.substitution(claim.context, claim.start)
            following = self.substitution(claim.context, claim.next)
            sentence = f"(Always {self.home(claim.context)} {start} {following})"
        else:
            sentence = f"(Compare {self.claim(claim)})"
        needed = "true" if row.role == "needed" else "false"
        verdict = row.verdict.capitalize()
        return f"Row {self.name(row.name)} {self.home(row.context)} {verdict} {needed} {sentence}"

    def fact(self, name: str, fact: check.Fact) -> str:
        """A fact of a cited statement."""
        return f"({self.name(name)}, ({self.home(fact.context)}%nat, {self.claim(fact.claim)}))"

    # --- proofs ---

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
        fact = self.kernel.facts.get(proof["of"])
        home = context if fact is None else fact.context
        at = self.values(proof["at"], home, context)
        premises = self.proofs(proof["givens"], context)
        return f"Instance {self.name(proof['of'])} {at} {premises}"

    # --- steps ---

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

    def enclosures(self) -> list[str]:
        """Each enclosure of a constant, and of the sides of a row."""
        found = self.reading.certificate["enclosures"]
        rows = self.reading.statement.rows
        items = [(self.kernel.names[k], v["bits"], v["ends"]) for k, v in found["constants"].items()]
        for name, value in found["rows"].items():
            claim = rows[name].claim
            if isinstance(claim, check.Claim):
                items += [(claim.lhs, value["bits"], value["lhs"])]
                items += [(claim.rhs, value["bits"], value["rhs"])]
        return [
            f"Ends {self.term(term)} {bits} {' '.join(rational(Fraction(end)) for end in ends)}"
            for term, bits, ends in items
        ]

    def shared(self) -> list[str]:
        """For each precision the constants of the root that are enclosed with it."""
        found = []
        for bits, scope in self.kernel.grounds.items():
            constants = sorted(term for term in scope.known if term in self.kernel.definitions)
            found.append(f"({bits}, {listed(map(self.term, constants))})")
        return found

    # --- the file ---

    def head(self) -> str:
        """What it is about, and the libraries."""
        lines = [
            f"(* {self.reading.theorem}: data for the checker in Coq.",
            f"   SHA-256 of statement.json: {self.reading.digest} *)",
            "From Coq Require Import ZArith QArith List.",
            "From Verify Require Import Meaning Clearing Kernel Checker.",
            "Import ListNotations.",
            "Open Scope positive_scope.",
            "",
        ]
        return "\n".join(lines)

    def definitions(self) -> list[str]:
        """The definitions, with the names of things beside them."""
        kernel, statement = self.kernel, self.reading.statement
        names = {term: name for name, term in kernel.names.items()}
        nodes = [
            (self.node(i), f"{i + 1} {names.get(i, '')}".strip()) for i in range(len(kernel.nodes))
        ]
        own = [f"{i}%nat" for name, i in self.contexts.items() if ":" not in name]
        constants = [self.term(kernel.names[name]) for name in self.reading.reader.own]
        labels = [next(step[k] for k in check.STEPS if k in step) for step in self.certificate_steps]
        parts = [
            defined("the_nodes : list node", nodes),
            defined("the_contexts : list context",
                    [(self.context(kernel.contexts[k]), k) for k in self.contexts]),
            defined("the_rows : list row",
                    [(self.row(row), row.name) for row in statement.rows.values()]),
            defined("the_citations : list (positive * (nat * claim))",
                    [(self.fact(name, fact), name) for name, fact in self.reading.cited.items()]),
            "Definition the_statement : statement := Statement the_nodes the_contexts\n"
            f"  {listed(own)}\n  {listed(constants)}\n  the_rows the_citations\n"
            f"  {listed(map(self.term, self.reading.cited_constants))}.\n",
            defined("the_steps : list step", list(zip(self.steps, labels, strict=True))),
            defined("the_enclosures : list ends", [(text, "") for text in self.enclosures()]),
            "Definition the_certificate : certificate :=\n"
            f"  Certificate {listed(self.shared())} the_steps the_enclosures.\n",
        ]  # fmt: skip
        return parts

    @property
    def certificate_steps(self) -> list[Json]:
        """The steps, as they are written."""
        steps: list[Json] = self.reading.certificate["steps"]
        return steps


def defined(name: str, items: list[tuple[str, str]]) -> str:
    """The definition of a list, each item on a line, with a comment."""
    lines = [
        f"  {text}{'' if i == len(items) else ';'}{f'  (* {note} *)' if note else ''}"
        for i, (text, note) in enumerate(items, 1)
    ]
    return f"Definition {name} := [\n" + "\n".join(lines) + "\n].\n"


PROOFS: dict[str, Callable[[Data, Json, check.Context], str]] = {
    "interval": Data.interval,
    "cuts": Data.cuts,
    "cases": Data.cases,
    "entry": Data.entry,
    "least": Data.least,
    "root": Data.root,
    "sum": Data.sum,
    "instance": Data.instance,
}
