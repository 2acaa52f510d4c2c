"""Verified constants and recursion of a theorem on the collapse of inelastic hard spheres.

A name means one thing. A subject has the same name in every package: `cli/theorem1.py` is the
command, `paper/commands/theorem1.py` what it does, `paper/theorem1.toml` what the paper says. Each
command has `USAGE` and `run()`. `tests/test_names.py` has the list.
"""

__version__ = "0.3.0"

#: True for a type checker only: what is offered is loaded when it is used.
TYPE_CHECKING = False

#: What a program of one's own imports from here, by the modules that have it.
_OFFERED = {
    "verify.library": (
        *("Interval", "Result", "always", "applies", "ask", "assume", "certificate", "cite"),
        *("constant", "for_all", "lemma", "prove", "prove_page", "read_page", "root_between"),
        "write_page",
    ),
    "verify.language.terms": (
        *("Claim", "Term", "absolute", "acos", "any_of", "asin", "atan", "cos", "cos_pi", "cosh"),
        *("equal", "exp", "log", "maximum", "minimum", "nth_root", "pi", "sin", "sinh", "sqrt"),
        *("symbol", "tan", "tanh", "unequal"),
    ),
    "verify.language.statement": ("Statement",),
    "verify.prover.hint": ("Hint",),
    "verify.language.errors": ("OwnError",),
    "verify.wire.inputs": ("InputError",),
}

#: And as modules, beside the commands of these names: ``theorem1.at``, ``spectrum.at``.
_MODULES = ("spectrum", "theorem1")

__all__ = [
    "Claim",
    "Hint",
    "InputError",
    "Interval",
    "OwnError",
    "Result",
    "Statement",
    "Term",
    "absolute",
    "acos",
    "always",
    "any_of",
    "applies",
    "asin",
    "ask",
    "assume",
    "atan",
    "certificate",
    "cite",
    "constant",
    "cos",
    "cos_pi",
    "cosh",
    "equal",
    "exp",
    "for_all",
    "lemma",
    "log",
    "maximum",
    "minimum",
    "nth_root",
    "pi",
    "prove",
    "prove_page",
    "read_page",
    "root_between",
    "sin",
    "sinh",
    "spectrum",
    "sqrt",
    "symbol",
    "tan",
    "tanh",
    "theorem1",
    "unequal",
    "write_page",
]

if TYPE_CHECKING:
    from verify import spectrum, theorem1
    from verify.language.errors import OwnError
    from verify.language.statement import Statement
    from verify.language.terms import (
        Claim,
        Term,
        absolute,
        acos,
        any_of,
        asin,
        atan,
        cos,
        cos_pi,
        cosh,
        equal,
        exp,
        log,
        maximum,
        minimum,
        nth_root,
        pi,
        sin,
        sinh,
        sqrt,
        symbol,
        tan,
        tanh,
        unequal,
    )
    from verify.library import (
        Interval,
        Result,
        always,
        applies,
        ask,
        assume,
        certificate,
        cite,
        constant,
        for_all,
        lemma,
        prove,
        prove_page,
        read_page,
        root_between,
        write_page,
    )
    from verify.prover.hint import Hint
    from verify.wire.inputs import InputError
else:

    def __getattr__(name):
        """What is offered under a name, from the module that has it."""
        from importlib import import_module

        if name in _MODULES:
            return import_module(f"{__name__}.{name}")
        for module, names in _OFFERED.items():
            if name in names:
                return getattr(import_module(module), name)
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
