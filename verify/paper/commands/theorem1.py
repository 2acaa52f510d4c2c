"""The job `theorem1`: decide Theorem 1 at one choice of the parameters."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from verify.language.record import Record
from verify.language.statement import NEEDED, PROVED, Choice, Constant, Obligation, Statement
from verify.language.terms import Claim, Term
from verify.language.typeset import Typesetter
from verify.paper.commands.citing import with_step
from verify.paper.parameters import HYPOTHESES, PRINTED, SELECTIONS
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.choices import BudgetError, choose
from verify.prover.constants import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION
from verify.prover.ground import Enclosures, Ground
from verify.prover.outcome import Decision, Outcome, conjunction
from verify.prover.proof import Proof
from verify.prover.session import Session
from verify.publication import BREAKS, HARMLESS, OTHERWISE, REMARK
from verify.wire.compiled import Kept


class Recalled(Record):
    """A proof that was found before rests on these claims; it is no step of a certificate."""

    needs: tuple[Claim, ...]


class RecallingGround(Ground):
    """Decides by what is kept of algebra, where enclosures show all claims on which that rests."""

    def __init__(
        self, session: Session, start_bits: int, max_bits: int, kept: Mapping[Claim, Kept]
    ) -> None:
        super().__init__(session, start_bits, max_bits)
        self._kept = kept

    def _prove(self, claim: Claim) -> tuple[str, Proof | None]:
        found, bits = self._kept.get(claim), self.start_bits
        claims = (claim, *found.needs) if found else ()
        verdicts = [self.compare(one, bits) for one in claims]
        if found and verdicts == [None, *(PROVED for _ in found.needs)]:
            return found.verdict, Recalled(found.needs)
        return super()._prove(claim)


class PointRun:
    """Theorem 1 at one choice of the parameters, decided step by step."""

    def __init__(
        self,
        parameters: Mapping[str, Term],
        selection: str,
        start_bits: int,
        max_bits: int,
        all_sides: bool,
    ) -> None:
        self.parameters, self.selection = parameters, selection
        self.all_sides = all_sides
        self.session = Session()
        self.kept = {} if all_sides else theorem().kept
        self.ground = RecallingGround(self.session, start_bits, max_bits, self.kept)
        self.constants: list[Constant] = []
        self.decisions: dict[str, Decision] = {}
        self.rows: list[Obligation] = []
        self.spent = ""
        for name in theorem().parameters:
            self.ground.define(Constant(name, name, name, "", parameters[name]))

    def run(self) -> Outcome:
        """Decide the hypotheses, and where they hold every row of the sets asked for."""
        parts = theorem().parts
        self._decide(parts[HYPOTHESES].obligations)
        if self._hypotheses_hold() and self._define(theorem().common):
            rows: tuple[Obligation, ...] = ()
            for group in SELECTIONS[self.selection]:
                if self._define(parts[group].constants):
                    rows += self._asked(parts[group].obligations)
                if self.all_sides:  # a certificate has a set's rows behind its constants
                    self._decide(rows)
                    rows = ()
            self._decide(rows)
        return self._outcome()

    def _hypotheses_hold(self) -> bool:
        needed = (self.decisions[row.name] for row in self.rows if row.role == NEEDED)
        return conjunction(needed) == PROVED

    def _asked(self, rows: tuple[Obligation, ...]) -> tuple[Obligation, ...]:
        """The rows; those of the printed set are needed where that alone is asked for."""
        if self.selection != PRINTED:
            return rows
        kept = (OTHERWISE, REMARK)
        return tuple(row if row.severity in kept else row._replace(role=NEEDED) for row in rows)

    def _define(self, constants: tuple[Constant | Choice, ...]) -> bool:
        """Add constants, or say what the precision does not suffice for."""
        for item in constants:
            try:
                constant = choose(self.ground, item) if isinstance(item, Choice) else item
            except BudgetError as error:
                self.spent = str(error)
                return False
            if not self.ground.define(constant):
                self.spent = f"{constant.name} has no value at {self.ground.max_bits} bits"
                return False
            self.constants.append(constant)
        return True

    def _decide(self, rows: tuple[Obligation, ...]) -> None:
        claims = [row.claim for row in rows if isinstance(row.claim, Claim)]
        needs = (need for c in claims if c in self.kept for need in self.kept[c].needs)
        self.ground.compile((*claims, *needs))
        for row in rows:
            self.rows.append(row)
            self.decisions[row.name] = self.ground.decide(row, all_sides=self.all_sides)

    def _outcome(self) -> Outcome:
        used = {name for row in self.rows for name in row.uses}
        verdicts = {name: found.verdict for name, found in self.decisions.items()}
        values = {name: self.parameters[name] for name in theorem().parameters}
        statement = Statement(
            theorem=theorem().name,
            title=_title(self.selection, values),
            parameters=values,
            constants=tuple(self.constants),
            contexts=(),
            obligations=tuple(graded(row, verdicts) for row in self.rows),
            assumptions=tuple(a for a in theorem().assumptions if a.name in used),
        )
        names = (*values, *(constant.name for constant in self.constants))
        found = Enclosures(self.ground, names)
        enclosures = dict(found) if self.all_sides else found
        steps = tuple(self.session.steps)
        return with_step(Outcome(statement, self.decisions, steps, enclosures, self.spent))


def graded(row: Obligation, verdicts: Mapping[str, str]) -> Obligation:
    """The row with the severity that follows from verdicts, where it has one that can be computed.

    A step breaks the argument unless rows about the same constants do its work: then the paper
    reaches its conclusion without it, and it is harmless. A slip of wording stays one.
    """
    if row.severity not in (BREAKS, HARMLESS) or row.name not in INSTEAD:
        return row
    instead = INSTEAD[row.name]
    reached = bool(instead) and all(verdicts.get(name) == PROVED for name in instead)
    return row._replace(severity=HARMLESS if reached else BREAKS)


#: For each step of the printed proof of Theorem 1 that may be false, the printed rows that do its
#: work if they hold: what the text concludes from the step, with nothing else than its constants.
INSTEAD: Mapping[str, tuple[str, ...]] = {
    "printed.set-interior": (),
    "printed.norm-law-as-printed": (
        "printed.norm-factor-2",
        "printed.norm-c-upper",
        "printed.norm-c-lower",
    ),
    "printed.zeta-x-bound": ("printed.zeta-total",),
    "printed.zeta-term-2": ("printed.zeta-total",),
    "printed.zeta-remainders": ("printed.zeta-total",),
    "printed.zeta-total": (),
    "printed.x-term-1-d": ("printed.x-term-1-factor",),
    "printed.y-term-3": ("printed.y-term-3-factor",),
    "printed.final-angle": (),
}


def decide_point(
    parameters: Mapping[str, Term],
    selection: str = "all",
    start_bits: int = DEFAULT_PRECISION,
    max_bits: int = DEFAULT_MAX_PRECISION,
    *,
    all_sides: bool = True,
) -> Outcome:
    """Decide Theorem 1 at a point.

    Args:
        parameters: r, c, V_0, delta_theta as terms without symbols.
        selection: a key of `SELECTIONS`.
        start_bits: the first precision.
        max_bits: the last one.
        all_sides: whether every row gets enclosures of its sides, not only the refuted ones, and
            all constants are enclosed now, not when they are asked for. Without them there is no
            certificate, and proofs by algebra that come with the program are not looked for anew.
    """
    return PointRun(parameters, selection, start_bits, max_bits, all_sides).run()


def _title(selection: str, parameters: Mapping[str, Term]) -> str:
    """What the statement is about, in one line."""
    typesetter = Typesetter({})
    values = ", ".join(f"{name} = {typesetter.term(term)}" for name, term in parameters.items())
    which = "printed and repaired" if selection == "all" else selection
    return f"Rows of {theorem().name}, {which} constants, at {values}"


def constants_enclosure(bits: int) -> Callable[[Mapping[str, Fraction]], dict[str, balls.Ball]]:
    """A function that encloses all constants of the printed proof, for many parameters.

    The program is compiled once, here. The function takes the values of r, c, V_0 and delta_theta
    and returns a ball for each constant that exists there.
    """
    from verify.prover.straight import StraightLine  # loaded only where it is used

    names = theorem().parameters
    constants = (*theorem().common, *theorem().parts[PRINTED].bounds)
    code = StraightLine(names)
    for constant in constants:
        code.define(constant.name, constant.term)
    found = [constant.name for constant in constants]
    run = code.function([code.names[name] for name in found], bits)

    def enclose(parameters: Mapping[str, Fraction]) -> dict[str, balls.Ball]:
        with balls.precision(bits):
            values = run(*(balls.from_fraction(parameters[name]) for name in names))
        return {n: v for n, v in zip(found, values, strict=True) if v.is_finite()}

    return enclose
