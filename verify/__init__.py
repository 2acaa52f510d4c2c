"""Verified constants and recursion of a theorem on the collapse of inelastic hard spheres.

A name means one thing. A subject has the same name in every room: `cli/theorem1.py` is the
command, `jobs/theorem1.py` what it does, `paper/theorem1.py` what the paper says. Modules of the
paper that stand side by side have one interface: `rows()` of a section, `lines()` and `context()`
of a chapter, `chapters()` and `statement()` of a part; each command has `add_arguments()` and
`run()`. `tests/test_names.py` has the list.
"""

__version__ = "0.1.0"
