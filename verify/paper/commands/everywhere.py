"""The job `everywhere`: Theorem 1 for all parameters at once."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from functools import cache

from verify.language.argument import Chapter, Line, Opened, ToBeFound
from verify.language.statement import REFUTED, UNDECIDED, Constant, Obligation, Statement
from verify.language.terms import Claim, as_term, names_of, substitute, substitute_claim, symbol
from verify.paper.commands.citing import applying
from verify.paper.commands.step import decide_step
from verify.paper.everywhere import angle_display, hints
from verify.paper.everywhere import chart as paper
from verify.paper.everywhere.everywhere import printed_statement, statement
from verify.paper.initial_data import ConstantSet
from verify.paper.parameters import PRINTED, REPAIRED
from verify.paper.recursion import angle_state
from verify.paper.rows import graded
from verify.paper.step import BETWEEN, COLLAPSE, STEP
from verify.prover import arguments
from verify.prover.ground import Ground
from verify.prover.outcome import Decision, Outcome
from verify.prover.positivity import NotFoundError, Positivity, Square
from verify.prover.proof import Proof
from verify.prover.relations import negation
from verify.prover.ring import Ring
from verify.prover.row_proofs import RowProofs
from verify.prover.rules import Define, Entry, Instance, Interval, Least, Witness
from verify.wire.judge import judged, known
from verify.wire.packaged import ALL, packaged_files
from verify.wire.write import write

HALF = Fraction(1, 2)
POINT_BITS = 128
#: The variables of the ring: those of the chart, two roots, then the constants that are minima.
MINIMA = ("delta_x", "x_0", "Delta_theta", "eta_bar", "zeta_bar", "d_const", "d_bar")
BELOW = {
    "u": (Fraction(1), "u-below-one"),
    "p": (HALF, "p-below-half"),
    "a": (paper.REST_BELOW, "rest-small"),
}
ATOMS = {
    "u": paper.u,
    "p": paper.p,
    "a": paper.rest,
    "v": paper.v,
    "e": symbol("delta_theta"),
    "g4": paper.root_4,
    "g5": paper.root_5,
}
SIGNS = {
    "u": "u-positive",
    "p": "p-positive",
    "a": "rest-positive",
    "v": "v-positive",
    "e": paper.hypothesis("delta-theta-positive"),
    "g4": "root-4",
    "g5": "root-5",
}
#: Points at which rows that are not true for all parameters may fail: r, -cos theta_0, V_0 and
#: delta_theta.
TRIED = (
    ("3/100", "1", "1", "1/10"),
    ("3/100", "1", "1", "1/1000"),
    ("1/1000", "3/10", "1", "1/10"),
    ("1/1000000", "1/20", "1", "1/10"),
    ("11/200", "1", "1", "1/10"),
    ("3/100", "1", "1000000", "1/10"),
    ("3/100", "1", "1/1000000", "1/10"),
)


def state_everywhere() -> Statement:
    """The statement of Theorem 1 for all parameters."""
    files = write(decide_step())
    return statement(files["statement.json"], files["certificate.json"])


def cite_everywhere() -> Outcome:
    """Every row for all parameters, as proved in the certificate that comes with the program.

    The checker reads that certificate again. It is decided anew where its statement, which cites
    the step, is not the one that is made here.
    """
    return known(ALL, statement(*packaged_files(STEP)), anew=True) or decide_everywhere()


@cache
def decide_everywhere() -> Outcome:
    """Every row for all parameters; what is not found is left undecided."""
    return everywhere_run()[1]


@cache
def everywhere_run() -> tuple[Everywhere, Outcome]:
    """The same, with all that is known at the end, from where a search can go on."""
    work = Everywhere(state_everywhere(), REPAIRED)
    return work, work.run()


@cache
def decide_printed_everywhere() -> Outcome:
    """Every row of the printed set: true for all parameters, or false for all or for some."""
    return Everywhere(printed_statement(), PRINTED).run()


class Everywhere:
    """The facts of the chart, and the rows that are decided so far."""

    def __init__(self, statement: Statement, group: str) -> None:
        self.statement, self.set = statement, ConstantSet(group)
        self.hints = hints.hints(self.set)
        self.writing = arguments.Writing(self.statement)
        self.session = self.writing.session
        self.ground = Ground(self.session)
        signs = SIGNS | {name: f"{group}.{name}-positive" for name in MINIMA}
        self.search = Positivity(tuple(signs), signs, BELOW, {"a": 2**0.5 - 1.4})
        self.ring = self._ring()
        self.proofs = RowProofs(self.ring, self.hints, self.set.delta_x.name)

    def _ring(self) -> Ring:
        made = self.search.generators
        seven_fifths = self.search.constant(paper.REST_ABOVE)
        atoms = ATOMS | {name: symbol(f"{self.set.group}.{name}") for name in MINIMA}
        values = {term: made[name] for name, term in atoms.items() if name != "a"}
        values[paper.root_two] = made["a"] + seven_fifths
        search, one = self.search, self.search.constant(1)
        u, p = made["u"], made["p"]
        square = 2 * one - seven_fifths**2 - 2 * seven_fifths * made["a"]
        search.relate("a", Square(square, one, "1"))
        search.relate(
            "g4", Square(2 * u * p**3, one + u * p, _one_plus("u-positive", "p-positive"))
        )
        search.relate("g5", Square(2 * u * p**2, one + u, _one_plus("u-positive")))
        replaced = paper.replacements(self.set)
        return Ring(self.session, paper.CONTEXT, search, atoms, values, replaced)

    def prepare(self) -> None:
        """The chart and the constants."""
        root = (*paper.ground_lines(), Opened(self.statement.contexts[0]))
        self.writing.chapter(Chapter(None, root))
        self.writing.chapter(Chapter(paper.CONTEXT, tuple(paper.lines(self.set))))
        for name in (*MINIMA[:1], "delta_y", *MINIMA[1:5], "d_slope", *MINIMA[5:], "T_star"):
            self.constant(self.writing.constants[f"{self.set.group}.{name}"], name)

    def run(self) -> Outcome:
        """The chart, the constants, the rows, and that the step applies."""
        self.prepare()
        if self.set.printed:
            name = f"{self.set.group}.delta_x"
            self._prove(hints.LEAST, paper.LEAST_DELTA <= symbol(name), self._least(name))
            self.lines(hints.about_zeta_bar(self.set))
        rows = [row for row in self.statement.obligations if row.name not in self.hints]
        left = [row for row in rows if not self._decided(row)]
        if self.set.printed:
            self._bounds_below()
            self._refute_display()
            for row in left:
                self._refute(row)
        else:
            self.lines(hints.about_d_bar())
        for name in self.hints:
            hinted = self.writing.rows.get(name)
            if hinted is not None and isinstance(hinted.claim, Claim):
                self._proved(hinted, hinted.claim)
        if not self.set.printed:
            self._apply()
        return self.outcome()

    def outcome(self) -> Outcome:
        """The decisions so far, each with the verdict of the checker."""
        decisions = {
            row.name: self.writing.decisions.get(row.name, Decision(UNDECIDED))
            for row in self.statement.obligations
        }
        found = judged(Outcome(self.statement, decisions, tuple(self.session.steps), {}))
        return _graded(found) if self.set.printed else found

    # --- constants ------------------------------------------------------------------------------

    def constant(self, constant: Constant, name: str) -> None:
        """A constant has a value: an equation, or for a minimum its sign and its entries."""
        self.ring.ensure(constant.term)
        self.session.constant(constant, Define(), paper.CONTEXT)
        term = symbol(constant.name)
        if constant.term.op != "min":
            self.ring.replaced[term] = constant.name
            return
        facts = []
        branches = tuple(self.ring.prove(0 < entry) for entry in constant.term.children)
        positive = f"{constant.name}-positive"
        self._prove(positive, 0 < term, Least("rhs", branches, constant.name))
        for number, entry in enumerate(constant.term.children, 1):
            fact = f"{constant.name}-entry-{number}"
            self._prove(fact, term <= entry, Entry("lhs", constant.name))
            facts.append((fact, entry))
        self.search.bound(name, self.ring.entries(name, facts))

    def _prove(self, name: str, claim: Claim, proof: Proof) -> None:
        """Write down a row of this name, or a lemma."""
        row = self.writing.rows.get(name)
        if row is None:
            self.session.lemma(claim, proof, paper.CONTEXT, name)
        else:
            self.writing.decide(row, proof)

    def lines(self, items: Iterable[Line]) -> None:
        """Write down lines, some of which have a proof that has to be found."""
        for item in items:
            if not isinstance(item.claim, Claim):
                raise TypeError(f"{item.name} compares no numbers")
            if isinstance(item.reason, ToBeFound):
                self._prove(item.name, item.claim, self.ring.prove(item.claim))
            else:
                self.ring.ensure(item.claim.lhs, item.claim.rhs)
                self.writing.chapter(Chapter(paper.CONTEXT, (item,)))

    # --- rows -----------------------------------------------------------------------------------

    def _decided(self, row: Obligation) -> bool:
        """Whether a row, or its negation, is proved for all parameters now, or was before."""
        if row.name in self.writing.decisions or not isinstance(row.claim, Claim):
            return True
        if not any(names_of(row.claim.lhs, row.claim.rhs)):
            self.writing.decisions[row.name] = self.ground.decide(row)
            return True
        return self._proved(row, row.claim) or self._fails(row, row.claim)

    def _proved(self, row: Obligation, claim: Claim) -> bool:
        try:
            self.writing.decide(row, self.proofs.proof(row.name, claim))
        except NotFoundError:
            return False
        return True

    def _fails(self, row: Obligation, claim: Claim) -> bool:
        opposite = negation(claim)
        try:
            if opposite is None:
                return False
            self._write_refuted(row, self.proofs.proof(f"not {row.name}", opposite))
        except NotFoundError:
            return False
        return True

    def _write_refuted(self, row: Obligation, proof: Proof) -> None:
        self.session.prove_row(row, proof, holds=False)
        self.writing.decisions[row.name] = Decision(REFUTED, proof)

    def _bounds_below(self) -> None:
        """From now on the search knows bounds from below, too: rows that fail may need them."""
        zeta = f"{self.set.group}.zeta_bar-positive"
        self.search.bound_below("delta_x", hints.LEAST, self.ring.clear(paper.LEAST_DELTA)[0])
        self.search.bound_below("zeta_bar", zeta, self.search.constant(0))

    def _least(self, constant: str) -> Least:
        """Why the least delta is at most delta_x, a minimum."""
        entries = self.session.definitions[constant].children
        branches = tuple(self.ring.prove(paper.LEAST_DELTA <= entry) for entry in entries)
        return Least("rhs", branches, constant)

    def _refute_display(self) -> None:
        """The display with a wrong sign fails at a state that all parameters allow."""
        opened = Opened(self.statement.contexts[1])
        self.writing.chapter(Chapter(None, (opened,)))
        self.writing.chapter(Chapter(angle_display.CONTEXT, tuple(angle_display.lines())))
        self.lines(angle_display.state_lines(self.set))
        state = angle_state(self.set)
        proof = Instance(angle_display.FAILS, state, angle_display.premises())
        self._write_refuted(self.writing.rows[angle_display.ROW], proof)

    def _refute(self, row: Obligation) -> None:
        """Decide a row that fails for all parameters, or at one of some points."""
        known = row.name in self.writing.decisions
        if isinstance(row.claim, Claim) and not known and not self._fails(row, row.claim):
            found = self._witness(row.claim)
            if found is not None:
                self._write_refuted(row, found)

    def _witness(self, claim: Claim) -> Witness | None:
        context = self.statement.contexts[0]
        names = [variable.name for variable in context.variables]
        for point in TRIED:
            at = {name: as_term(Fraction(x)) for name, x in zip(names, point, strict=True)}
            values = dict(at)
            for constant in context.constants:
                values[constant.name] = substitute(constant.term, values)
            opposite = negation(substitute_claim(claim, values))
            if opposite is not None and self.ground.holds_at(opposite, POINT_BITS):
                givens = tuple(Interval(POINT_BITS) for _ in context.givens)
                return Witness(at, givens, Interval(2 * POINT_BITS))
        return None

    # --- the step -------------------------------------------------------------------------------

    def _apply(self) -> None:
        between = {name: self.ring.lemma(claim) for name, claim in BETWEEN.items()}
        self.writing.decide(self.writing.rows[COLLAPSE], applying(between))


def _graded(outcome: Outcome) -> Outcome:
    """The outcome with how bad each false row is, over all parameters."""
    verdicts = {name: found.verdict for name, found in outcome.decisions.items()}
    rows = tuple(graded(row, verdicts) for row in outcome.statement.obligations)
    return outcome._replace(statement=outcome.statement._replace(obligations=rows))


def _one_plus(*facts: str) -> tuple[object, ...]:
    return ("add", "1", ("mul", *facts) if len(facts) > 1 else facts[0])
