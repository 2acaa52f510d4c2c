"""The groups of rows of Theorem 1, in the order in which they are shown."""

HYPOTHESES = "hypotheses"
PRINTED = "printed"
REPAIRED = "repaired"
GROUPS = (HYPOTHESES, PRINTED, REPAIRED)

#: The sets of constants that each value of ``--constants`` asks for.
SELECTIONS = {
    "printed": (PRINTED,),
    "repaired": (REPAIRED,),
    "all": (PRINTED, REPAIRED),
}
