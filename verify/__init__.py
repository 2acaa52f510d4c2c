"""Verified constants and recursion of a theorem on the collapse of inelastic hard spheres.

A name means one thing. A subject has the same name in every room: `cli/theorem1.py` is the
command, `paper/commands/theorem1.py` what it does, `paper/theorem1.py` what the paper says.
Modules of the paper that stand side by side have one interface: `rows()` of a section, `lines()`
and `context()` of a chapter, `chapters()` and `statement()` of a part; each command has
`add_arguments()` and `run()`. `tests/test_names.py` has the list.
"""

__version__ = "0.1.0"

#: What a program of one's own imports from here, and where it is; each is loaded when it is used.
_OFFERED = {
    "Statement": "verify.language.statement",
    **dict.fromkeys(
        ("ask", "assume", "certificate", "constant", "for_all", "lemma", "prove"), "verify.library"
    ),
    **dict.fromkeys(
        (
            "equal",
            "symbol",
            "sqrt",
            "root",
            "minimum",
            "maximum",
            "absolute",
            "exp",
            "log",
            "pi",
            "sin",
            "cos",
            "cos_pi",
            "tan",
            "atan",
        ),
        "verify.language.terms",
    ),
}


def __getattr__(name: str) -> object:
    if name not in _OFFERED:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from importlib import import_module

    return getattr(import_module(_OFFERED[name]), name)
