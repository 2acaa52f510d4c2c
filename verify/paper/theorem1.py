"""`THEORSS4.1ExistenCollapse`, assembled: constants, obligations, assumptions."""

from __future__ import annotations

from functools import cache

from verify.paper import conclusion, initial_data, initialization, preliminary_rows, recursion
from verify.paper.assumptions import ASSUMPTIONS
from verify.paper.hypotheses import hypotheses
from verify.paper.initial_data import CHANGES, ConstantSet
from verify.paper.parameters import PARAMETERS, THEOREM
from verify.paper.preliminaries import CONSTANTS
from verify.language.statement import PRINTED, REPAIRED, Statement


@cache
def theorem() -> Statement:
    """The statement over the symbols r, c, V_0 and delta_theta, built once per process."""
    sets = (ConstantSet(PRINTED), ConstantSet(REPAIRED))
    sections = (preliminary_rows, initial_data, initialization, recursion, conclusion)
    return Statement(
        theorem=THEOREM,
        parameters=PARAMETERS,
        constants=CONSTANTS + tuple(c for k in sets for c in k.constants()),
        obligations=tuple(hypotheses())
        + tuple(row for k in sets for section in sections for row in section.rows(k)),
        assumptions=ASSUMPTIONS,
        changes=CHANGES,
    )
