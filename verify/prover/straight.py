"""Terms compiled once into straight-line Python code for balls, and run at many inputs.

The code has one line for each distinct operation. Where a value is undefined its ball is not
finite, and so is every ball that is computed from it; a comparison with such a ball is false, so
that it proves nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any

from verify.language.fold import fold
from verify.language.terms import FUNCTIONS, Claim, Term
from verify.prover import balls

_UNARY = {"neg": "-{}", "sqrt": "{}.sqrt()"}
_BINARY = {
    "add": "{} + {}",
    "sub": "{} - {}",
    "mul": "{} * {}",
    "div": "{} / {}",
    "min": "{}.min({})",
    "max": "{}.max({})",
}

_VERDICTS = {
    "<": "1 if {a} < {b} else 2 if {b} <= {a} else 0",
    "<=": "1 if {a} <= {b} else 2 if {b} < {a} else 0",
    "=": "1 if {a} <= {b} and {b} <= {a} else 2 if {a} < {b} or {b} < {a} else 0",
}


class StraightLine:
    """Code that grows line by line; `function` makes it callable.

    Balls of rationals are computed once, at the precision of `function`.
    """

    def __init__(self, inputs: Sequence[str]) -> None:
        self.names = {name: f"x{i}" for i, name in enumerate(inputs)}
        self._inputs = list(self.names.values())
        self._lines: list[str] = []
        self._known: dict[Term, str] = {}
        self._codes: dict[str, str] = {}
        self._constants: dict[str, Fraction] = {}
        self._helpers: dict[str, Any] = {}
        self._algebra: dict[str, Callable[..., str]] = {
            "rational": self._rational,
            "symbol": self.names.__getitem__,
            "pow": self._power,
            "pi": self._pi,
            "root": self._root,
            **{op: self._call(op) for op in FUNCTIONS if op not in _UNARY},
            **{op: self._unary(pattern) for op, pattern in _UNARY.items()},
            **{op: self._binary(pattern) for op, pattern in _BINARY.items()},
        }

    def define(self, name: str, term: Term) -> None:
        """Give a name to the value of a term over inputs and earlier names."""
        self.names[name] = self.value(term)

    def call(self, name: str, helper: Callable[..., Any], *terms: Term) -> None:
        """Give a name to what a Python function makes of the balls of some terms."""
        arguments = ", ".join([self.value(term) for term in terms])
        function, variable = f"h{len(self._helpers)}", f"c{len(self._lines)}"
        self._helpers[function] = helper
        self._lines.append(f"{variable} = {function}({arguments})")
        self.names[name] = variable

    def value(self, term: Term) -> str:
        """The variable that holds the value of a term.

        Raises:
            KeyError: for a name that is neither an input nor defined.
        """
        return fold(term, self._algebra, self._known)

    def _rational(self, value: Fraction) -> str:
        name = f"q{len(self._constants)}"
        self._constants[name] = value
        return name

    def _unary(self, pattern: str) -> Callable[[str], str]:
        return lambda operand: self._line(pattern.format(operand))

    def _binary(self, pattern: str) -> Callable[..., str]:
        """One line for two operands, and one more for each further one."""
        line = lambda a, b: self._line(pattern.format(a, b))  # noqa: E731
        return lambda *operands: reduce(line, operands)

    def _call(self, name: str) -> Callable[[str], str]:
        def written(operand: str) -> str:
            self._helpers[name] = balls.operation(name)
            return self._line(f"{name}({operand})")

        return written

    def _pi(self) -> str:
        self._helpers["pi"] = balls.pi
        return self._line("pi()")

    def _root(self, operand: str, index: int) -> str:
        name = f"root{index}"
        self._helpers[name] = balls.operation(f"root {index}")
        return self._line(f"{name}({operand})")

    def _power(self, base: str, exponent: int) -> str:
        result = base
        for _ in range(exponent - 1):
            result = self._line(f"{result} * {base}")
        return result

    def _line(self, code: str) -> str:
        found = self._codes.get(code)
        if found is None:
            found = self._codes[code] = f"v{len(self._lines)}"
            self._lines.append(f"{found} = {code}")
        return found

    def verdict(self, claim: Claim) -> str:
        """The variable that holds `HOLDS`, `FAILS` or `OPEN` for a claim."""
        a, b = self.value(claim.lhs), self.value(claim.rhs)
        variable = f"w{len(self._lines)}"
        self._lines.append(f"{variable} = {_VERDICTS[claim.relation].format(a=a, b=b)}")
        return variable

    def function(self, outputs: Iterable[str], bits: int) -> Callable[..., tuple[Any, ...]]:
        """The code as a function of the inputs that returns the variables named as outputs.

        It must be called at the precision given here.
        """
        results = ", ".join(outputs)
        with balls.precision(bits):
            scope = {name: balls.from_fraction(value) for name, value in self._constants.items()}
        body = "".join(f"    {line}\n" for line in self._lines)
        code = f"def run({', '.join(self._inputs)}):\n{body}    return ({results},)\n"
        found: dict[str, Any] = {}
        exec(code, {**scope, **self._helpers}, found)  # noqa: S102  built above, from terms alone
        return found["run"]  # type: ignore[no-any-return]
