"""The limit map and its separatrix: rows for all r, a and ratios, in the order of the proof.

Begin with `model.py`, then `theorem.py`. Coq has the same theorem, and more of it, without glue:
`verify/coq/Separatrix.v`.
"""
