"""The rules of the kernel, on the side that searches: one class of proofs in each file.

A file is loaded where its rule is used first: the rows of a point need five of them.
"""

from __future__ import annotations

from verify.language.record import TYPE_CHECKING

if TYPE_CHECKING:
    from verify.prover.rules.angles import Angles
    from verify.prover.rules.antisymmetry import Antisymmetry
    from verify.prover.rules.cases import Cases
    from verify.prover.rules.cosine import Cosine
    from verify.prover.rules.cuts import Cuts
    from verify.prover.rules.define import Define
    from verify.prover.rules.entry import Entry
    from verify.prover.rules.induction import Induction
    from verify.prover.rules.instance import Applying, Instance
    from verify.prover.rules.interval import Interval
    from verify.prover.rules.least import Least
    from verify.prover.rules.root import Root
    from verify.prover.rules.sum import Sum
    from verify.prover.rules.witness import Witness

__all__ = [
    "Angles",
    "Antisymmetry",
    "Applying",
    "Cases",
    "Cosine",
    "Cuts",
    "Define",
    "Entry",
    "Induction",
    "Instance",
    "Interval",
    "Least",
    "Root",
    "Sum",
    "Witness",
]

if not TYPE_CHECKING:

    def __getattr__(name):
        if name not in __all__:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        from importlib import import_module

        file = "instance" if name == "Applying" else name.lower()
        found = getattr(import_module(f"{__name__}.{file}"), name)
        globals()[name] = found
        return found
