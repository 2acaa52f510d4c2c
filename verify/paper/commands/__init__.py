"""What the paper's commands do: parameters in, an outcome out.

It uses all packages below: the pages beside it, the prover, the wire, the spheres, and it calls the
checker. Begin with `theorem1.py`, then `pages.py`.
"""
