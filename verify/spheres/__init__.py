"""Hard spheres followed rigorously.

What is true here: each answer encloses what it is about, or says that the budget was spent; its
inputs are exact rationals and every rounding goes outward. It may use the language and the prover;
the views and the command line use it. A newcomer begins with `verify.spheres.separatrix`.
"""
