"""The job `spectrum`: decide all spectral claims, for every r in ]0,1[."""

from __future__ import annotations

from functools import cache

from verify.paper.spectrum.printed import Printed
from verify.paper.spectrum.spectrum import statement
from verify.prover.outcome import Outcome
from verify.prover.prove import prove
from verify.wire.judge import judged, known

#: Its name among the certificates that come with the program.
NAME = "spectrum"

#: No claim here needs more bits; a value that is 0 is not known to any number of relative bits.
MAX_BITS = 1024


def cite_spectrum() -> Outcome:
    """Every row, from the certificate that comes with the program; else decided anew."""
    return known(NAME, statement()) or decide_spectrum()


def decide_spectrum(paper: Printed | None = None) -> Outcome:
    """Decide every row, for the printed matrix and polynomial or for altered ones."""
    return _as_printed() if paper is None else judged(prove(statement(paper), max_bits=MAX_BITS))


@cache
def _as_printed() -> Outcome:
    """Decided once a process: whoever compares several statements with it asks again."""
    return judged(prove(statement(), max_bits=MAX_BITS))
