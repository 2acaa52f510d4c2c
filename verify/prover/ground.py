"""Claims without variables: balls on a ladder of precisions, exact rationals, and algebra.

Nothing here is trusted. What is found is written down as the steps of a certificate.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping

from verify.language.fold import negation
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Obligation
from verify.language.terms import Claim, parts_of
from verify.prover.constants import DEFAULT_MAX_PRECISION, DEFAULT_PRECISION, Constants
from verify.prover.outcome import Decision, Enclosure, Judgement
from verify.prover.proof import Proof
from verify.prover.rules import Interval
from verify.prover.session import Session

TYPE_CHECKING = False
if TYPE_CHECKING:
    from verify.prover.tight import Tight

#: The judge of what balls or exact values decide, and of what algebra does.
FLINT, ALGEBRA = "FLINT at a point", "algebra at a point"


class Ground(Constants):
    """Decides claims over constants: by enclosures, and where they do not decide by algebra."""

    def __init__(
        self,
        session: Session,
        start_bits: int = DEFAULT_PRECISION,
        max_bits: int = DEFAULT_MAX_PRECISION,
    ) -> None:
        super().__init__(session, start_bits, max_bits)
        self._decided: dict[Claim, tuple[str, Proof | None]] = {}
        #: The most bits that decided a claim so far. Others near the same threshold need as many,
        #: so these are tried before a search by algebra.
        self._reached = 0

    def mark(self) -> Callable[[], None]:
        """What forgets the decisions from now on, whose lemmas may be gone."""
        decided = dict(self._decided)

        def undo() -> None:
            self._decided = decided

        return undo

    # --- decisions ------------------------------------------------------------------------------

    def decide(self, row: Obligation, *, all_sides: bool = True) -> Decision:
        """Decide a row and write its proof down, or leave it undecided.

        Without ``all_sides`` only a refuted row gets the enclosures of its sides; a certificate
        needs them all.
        """
        claim = row.claim
        if not isinstance(claim, Claim):
            raise TypeError(f"{row.name} compares no numbers")
        verdict, proof = self.prove(claim)
        if proof is None:
            return Decision(UNDECIDED)
        sides = None
        if all_sides or verdict == REFUTED:
            sides = self.enclose(claim.lhs, claim.rhs)
            if sides is None:
                return Decision(UNDECIDED)
        self.session.prove_row(row, proof, holds=verdict == PROVED)
        by = FLINT if isinstance(proof, Interval) else ALGEBRA
        judged = Judgement(verdict, by, claim, row.context, self.definitions)
        return Decision(verdict, proof, sides, judged)

    def prove(self, claim: Claim) -> tuple[str, Proof | None]:
        """A verdict with its proof; the lemmas that it needs are written down.

        Two rows with one claim have one proof.
        """
        found = self._decided.get(claim)
        if found is None:
            found = self._decided[claim] = self._prove(claim)
        return found

    def _prove(self, claim: Claim) -> tuple[str, Proof | None]:
        found = self.decide_at(claim, self.start_bits)
        if found is None:
            found = self._decide_tight(claim, self.start_bits)
        if found is not None:
            return found
        for bits in self.ladder():
            found = self.decide_at(claim, bits)
            if found is not None:
                self._reached = max(self._reached, bits)
                return found
        return UNDECIDED, None

    def _decides_by(self, claim: Claim, bits: int) -> bool:
        """Whether enclosures decide at a higher precision, so that no algebra is needed."""
        return bits <= self.max_bits and self.compare(claim, bits) is not None

    def _decide_tight(self, claim: Claim, bits: int) -> tuple[str, Proof] | None:
        """What algebra decides, if that is not too long.

        Names are replaced at first; then nested roots, or cosines, are shown to be equal.
        """
        from verify.prover.clearing import TooLongError  # loaded only where they are needed
        from verify.prover.tight import TIGHT_BITS, Tight

        if self._decides_by(claim, max(TIGHT_BITS, self._reached)):
            return None
        tight = Tight(self, bits)
        try:
            found = _first(claim, tight.prove) or self._by_half_turns(claim, tight)
            if found is None:
                from verify.prover.algebraic import Algebraic  # loaded only where needed

                found = _first(claim, lambda wanted: Algebraic(tight).prove(wanted))
        except TooLongError:
            return None
        return found

    def _by_half_turns(self, claim: Claim, tight: Tight) -> tuple[str, Proof] | None:
        """What exact values of sines and cosines decide."""
        ops = {part.op for part in parts_of(claim.lhs, claim.rhs)}
        if "pi" not in ops or ops.isdisjoint(("sin", "cos")):
            return None
        from verify.prover.tight import by_half_turns  # loaded only where it is needed

        def prove(simpler: Claim) -> Proof | None:
            verdict, proof = self.prove(simpler)
            return proof if verdict == PROVED else None

        return _first(claim, lambda wanted: by_half_turns(tight, wanted, prove))


class Enclosures(Mapping[str, Enclosure]):
    """The enclosures of some names that have one, each found when it is asked for."""

    def __init__(self, ground: Constants, names: Iterable[str]) -> None:
        self._ground, self._names = ground, tuple(names)

    def __getitem__(self, name: str) -> Enclosure:
        found = self._ground.enclose(self._ground.definitions[name])
        if found is None:
            raise KeyError(name)
        return found

    def __iter__(self) -> Iterator[str]:
        return (name for name in self._names if self.get(name) is not None)

    def __len__(self) -> int:
        return sum(1 for _ in self)


def _first(claim: Claim, prove: Callable[[Claim], Proof | None]) -> tuple[str, Proof] | None:
    """The verdict on a claim, if this proves the claim or its negation."""
    for verdict, wanted in ((PROVED, claim), (REFUTED, negation(claim))):
        proof = None if wanted is None else prove(wanted)
        if proof is not None:
            return verdict, proof
    return None
