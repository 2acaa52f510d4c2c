"""Search for proofs, of claims and of arguments; whatever it finds, the checker judges.

It uses the language, and knows no paper and no spheres. Begin with `goal.py`, then `prove.py`.
"""
