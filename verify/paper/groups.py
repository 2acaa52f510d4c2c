"""The groups of rows of Theorem 1, in the order in which they are shown."""

from verify.language.statement import HYPOTHESES, PRINTED, REPAIRED

__all__ = ["GROUPS", "HYPOTHESES", "PRINTED", "REPAIRED", "SELECTIONS"]

GROUPS = (HYPOTHESES, PRINTED, REPAIRED)

#: The sets of constants that each value of ``--constants`` asks for.
SELECTIONS = {
    "printed": (PRINTED,),
    "repaired": (REPAIRED,),
    "all": (PRINTED, REPAIRED),
}
