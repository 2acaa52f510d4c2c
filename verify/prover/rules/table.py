"""Which class of proofs is which rule, with the kinds of its fields."""

from __future__ import annotations

from verify.language.record import TYPE_CHECKING
from verify.prover.proof import Kinds
from verify.prover.rules import (
    angles,
    antisymmetry,
    cases,
    cosine,
    cuts,
    define,
    entry,
    induction,
    instance,
    interval,
    least,
    root,
    sum,  # noqa: A004
    witness,
)
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

if TYPE_CHECKING:
    from typing import Any

    from verify.prover.proof import Proof

#: For each class of proofs the name of its rule, and the kinds of its fields.
RULES: dict[type[Any], tuple[str, Kinds]] = {
    Interval: ("interval", interval.KINDS),
    Cuts: ("cuts", cuts.KINDS),
    Sum: ("sum", sum.KINDS),
    Entry: ("entry", entry.KINDS),
    Least: ("least", least.KINDS),
    Cases: ("cases", cases.KINDS),
    Root: ("root", root.KINDS),
    Antisymmetry: ("antisymmetry", antisymmetry.KINDS),
    Angles: ("angles", angles.KINDS),
    Cosine: ("cosine", cosine.KINDS),
    Define: ("define", define.KINDS),
    Instance: ("instance", instance.INSTANCE_KINDS),
    Applying: ("instance", instance.APPLYING_KINDS),
    Induction: ("induction", induction.KINDS),
    Witness: ("witness", witness.KINDS),
}


def rule_of(proof: Proof) -> str:
    """The name of the rule by which a proof shows its claim."""
    return RULES[type(proof)][0]
