"""Search for proofs, of claims and of arguments; whatever it finds, the checker judges.

It uses the language, and knows no paper and no spheres. Begin with `goal.py`, then `prove.py`.
"""

from verify.language.interrupts import hold_while_loading

hold_while_loading("flint")
