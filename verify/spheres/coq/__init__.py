"""For Coq: what a certificate says of three balls. The file of `verify/wire/coq` ends in it.

Begin with `motion.py`.
"""
