"""The parameters of the theorem `THEORSS4.1ExistenCollapse`, and the groups of its rows.

``r`` is the restitution coefficient, ``c`` is -cos(theta_0), ``delta_theta`` the allowed deviation
of the final angle (in -cos), ``V_0`` the lower bound on the squared relative speeds.
"""

from __future__ import annotations

from verify.language.statement import PRINTED as PRINTED
from verify.language.terms import symbol
from verify.publication import HYPOTHESES as HYPOTHESES
from verify.publication import REPAIRED as REPAIRED

THEOREM = "THEORSS4.1ExistenCollapse"
#: Folders of certificates: the one for all parameters; those about the theorem as printed, its set
#: with > for <, and that with < it is false; and the rows of the printed set, some refuted.
ALL, AS_PRINTED = "theorem1-all", "printed"
PRINTED_SET, PRINTED_SIGN = "printed-set", "printed-sign"
#: The name of the theorem that is proved for all of them at once.
ALL_PARAMETERS = f"{THEOREM} for all parameters"
PARAMETERS = ("r", "c", "V_0", "delta_theta")

r = symbol("r")
c = symbol("c")
V_0 = symbol("V_0")
delta_theta = symbol("delta_theta")

GROUPS = (HYPOTHESES, PRINTED, REPAIRED)

#: The sets of constants that each value of ``--constants`` asks for.
SELECTIONS = {
    "printed": (PRINTED,),
    "repaired": (REPAIRED,),
    "all": (PRINTED, REPAIRED),
}
