"""The job `spectrum`: decide all spectral claims, for every r in ]0,1[."""

from __future__ import annotations

from functools import cache

from verify.language.statement import PROVED, Statement
from verify.paper.commands import pages
from verify.paper.spectrum.printed import Printed
from verify.paper.spectrum.spectrum import statement
from verify.paper.spectrum.zhou_kadanoff import CITED, PREMISES
from verify.prover.outcome import Decision, Outcome
from verify.prover.proof import ObligationStep
from verify.prover.prove import prove
from verify.prover.rules import Applying
from verify.wire.judge import judged, known

#: Its name among the certificates that come with the program.
SPECTRUM = "spectrum"

#: No claim here needs more bits; a value that is 0 is not known to any number of relative bits.
MAX_BITS = 1024


def state_spectrum(paper: Printed | None = None) -> Statement:
    """What is claimed, before it is decided; it cites the classification of this program."""
    return statement(pages.cite("classification"), paper)


def cite_spectrum() -> Outcome:
    """Every row, from the certificate that comes with the program; else decided anew."""
    return known(SPECTRUM, state_spectrum()) or decide_spectrum()


def decide_spectrum(paper: Printed | None = None) -> Outcome:
    """Decide every row, for the printed matrix and polynomial or for altered ones."""
    return _as_printed() if paper is None else _decided(paper)


def _decided(paper: Printed | None) -> Outcome:
    """The search decides all rows but the one that applies what is cited."""
    found = prove(state_spectrum(paper), max_bits=MAX_BITS)
    proof = Applying(PREMISES)
    decisions = {**found.decisions, CITED: Decision(PROVED, proof)}
    steps = list(found.steps)
    before = next(i for i, s in enumerate(steps) if getattr(s, "name", "") == PREMISES[-1])
    steps.insert(before + 1, ObligationStep(CITED, proof))
    return judged(found._replace(decisions=decisions, steps=tuple(steps)))


@cache
def _as_printed() -> Outcome:
    """Decided once a process: whoever compares several statements with it asks again."""
    return _decided(None)
