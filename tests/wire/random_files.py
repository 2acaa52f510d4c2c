"""Random files of SMT-LIB and FPCore, in which everything stands that readers may mix up."""

from __future__ import annotations

import re
from random import Random

REAL, BOOL = "Real", "Bool"
#: Names that are like one another, like words of ours, or like those of functions.
NAMES = (
    *("x", "y", "a-b", "a_b", "a.b", "goal", "core1", "case1", "g1", "t1", "l.1", "sin", "pi", "e"),
    *("check-1", "asserted-1", "v-x", "core-1", "u.1", "lemma", "cos_pi", "max2", "E", "~!@$%^&*"),
    *(
        "asserted-1.1",
        "check-2.case-1",
        "part-1",
        "less-",
        "x" * 70,
        "x" * 69 + "y",
        "sqrt",
        "|a b|",
    ),
    *("|x'|", "|a(b|", "|;|", "|x y|", "|v-_20_|", "PI", "-x", ".x", "a%b"),
    *("|1|", "|0.5|", '|"s"|', "|:named|", "||", "|a\nb|", "|λ|", "/3", "e1", "push", "assert"),
)
#: What may stand wherever a space does.
SPACES = ("\t", "  ", "\r\n", " ; ) (assert false)\n", ' ;"\n', " ; |\n", "\n;λ (pop 1)\n")


class Draw:
    """Text of one file; ``scopes`` has the names that are known with what they stand for."""

    def __init__(self, seed: int, *, fpcore: bool = False) -> None:
        self.random, self.fpcore = Random(seed), fpcore
        self.equal = "==" if fpcore else "="
        self.scopes: list[dict[str, tuple[tuple[str, ...], str]]] = [{}]
        self.pool = self.random.sample(NAMES, self.random.randint(2, 5))

    def one(self, *choices: str) -> str:
        return self.random.choice(choices)

    def chance(self, share: float) -> bool:
        return self.random.random() < share

    # --- terms and formulas ----------------------------------------------------------------------

    def names(self, known: dict[str, tuple[tuple[str, ...], str]], sort: str) -> list[str]:
        return [name for name, (args, kind) in known.items() if kind == sort and not args]

    def written(self, name: str) -> str:
        """A name, sometimes quoted where it need not be."""
        plain = name.strip("|")
        if self.fpcore or plain != name:
            return name
        return f"|{name}|" if self.chance(0.1) else name

    def of(self, sort: str, known: dict[str, tuple[tuple[str, ...], str]], depth: int) -> str:
        """A term or a formula."""
        kind = self.random.random()
        if depth > 0 and kind < 0.2:
            return self.let(sort, known, depth)
        calls = [name for name, (args, kind) in known.items() if args and kind == sort]
        if depth > 0 and calls and kind < 0.35:
            name = self.random.choice(calls)
            parts = " ".join(self.of(arg, known, depth - 1) for arg in known[name][0])
            return f"({self.written(name)} {parts})"
        if not self.fpcore and depth > 0 and kind < 0.42:
            kinds = (BOOL, sort, sort)
            return f"(ite {' '.join(self.of(kind, known, depth - 1) for kind in kinds)})"
        return self.term(known, depth) if sort == REAL else self.formula(known, depth)

    def let(self, sort: str, known: dict[str, tuple[tuple[str, ...], str]], depth: int) -> str:
        inner, pairs = dict(known), []
        word = self.one("let", "let*") if self.fpcore else "let"
        for name in self.random.sample(self.pool, self.random.randint(1, 2)):
            kind = REAL if self.fpcore else self.one(REAL, BOOL)
            around = inner if word == "let*" else known
            pairs.append(f"({self.written(name)} {self.of(kind, dict(around), depth - 1)})")
            inner[name] = ((), kind)
        body = f"({word} ({' '.join(pairs)}) {self.of(sort, inner, depth - 1)})"
        return body.replace("(", "[", 1).removesuffix(")") + "]" if self.square() else body

    def square(self) -> bool:
        return self.fpcore and self.chance(0.1)

    def term(self, known: dict[str, tuple[tuple[str, ...], str]], depth: int) -> str:
        names, rare = self.names(known, REAL), not self.fpcore and self.chance(0.1)
        if depth <= 0 or self.chance(0.25):
            number = self.one("0", "1", "2", "3.5", "0.25", "(- 1)", "(/ 1 3)", "(- (/ 2 5))", "10")
            number = self.one("1.50", "0.0", "2.000", "(/ 3 2 4)", "(+ 1)") if rare else number
            return self.written(self.random.choice(names)) if names and self.chance(0.7) else number
        op = self.one(
            "+", "-", "*", "-1", "/", *([] if self.fpcore else ["^"]), "min", "max", "abs"
        )
        if op in ("min", "max", "abs"):
            op = f"f{op}" if self.fpcore else "ite"
        left = self.of(REAL, known, depth - 1)
        if op == "-1":
            return f"(- {left})"
        if op == "fabs":
            return f"(fabs {left})"
        if op == "^":
            return f"(^ {left} {self.one('1', '2', '3')})"
        if op == "/":
            return f"(/ {left} {self.one('2', '(- 3)', '0.5')})"
        right = self.of(REAL, known, depth - 1)
        if op == "ite":
            return self.extremum(left, right)
        more = f" {self.of(REAL, known, depth - 1)}" if op in "+-*" and self.chance(0.2) else ""
        return f"({op} {left} {right}{more})"

    def extremum(self, left: str, right: str) -> str:
        a, b = self.one(f"{left} {right}", f"{right} {left}"), self.one(f"{left} {right}")
        if self.chance(0.3):
            a, b = self.one(f"{left} (- {left})", f"(- {left}) {left}"), f"{left} 0"
        return f"(ite ({self.one('<', '<=', '>', '>=')} {b}) {a})"

    def formula(self, known: dict[str, tuple[tuple[str, ...], str]], depth: int) -> str:
        names = self.names(known, BOOL)
        if names and self.chance(0.3):
            return self.written(self.random.choice(names))
        if depth <= 0 or self.chance(0.35):
            op = self.one("<", "<=", self.equal, ">=", ">", *([] if self.fpcore else ["distinct"]))
            count = self.random.choice((2, 2, 2, 3, 4))
            return f"({op} {' '.join(self.term(known, min(depth, 2)) for _ in range(count))})"
        op = self.one("not", "and", "or", "=>", "xor", "=", "distinct", "true")
        if op == "true":
            return self.one("true", "false")
        least = 1 if op in ("not", "and", "or") else 2
        most = least if op in ("not", "distinct") else 4 if self.chance(0.1) else 3
        parts = [self.of(BOOL, known, depth - 1) for _ in range(self.random.randint(least, most))]
        return f"({op} {' '.join(parts)})"

    # --- files -----------------------------------------------------------------------------------

    def known(self) -> dict[str, tuple[tuple[str, ...], str]]:
        return {name: kind for scope in self.scopes for name, kind in scope.items()}

    def fresh(self) -> str | None:
        free = [name for name in self.pool if name not in self.known()]
        return self.random.choice(free) if free else None

    def smtlib(self) -> str:
        lines = ["(set-logic QF_NRA)"]
        for _ in range(self.random.randint(4, 14)):
            lines += self.command()
        lines.append("(check-sat)")
        if self.chance(0.1):
            lines += ["(exit)", "(assert false)", "(check-sat)"]
        space = self.one("\n", " ", "\n; (assert false)\n", "\r\n")
        return self.spaced(space.join(lines))

    def spaced(self, text: str) -> str:
        """The same text, with comments and line ends in place of some of its spaces."""
        parts = re.split(r"""(\|[^|]*\||"(?:[^"]|"")*"|;[^\n]*\n)""", text)
        for i in range(0, len(parts), 2):
            words = re.split("( )", parts[i])
            parts[i] = "".join(
                self.one(*SPACES) if word == " " and self.chance(0.03) else word for word in words
            )
        return "".join(parts)

    def command(self) -> list[str]:
        kind = self.random.random()
        name = self.fresh()
        if not self.names(self.known(), REAL) or (kind < 0.2 and name):
            return [self.declare(name)] if name else ['(echo "(pop 1)")']
        if kind < 0.35 and name:
            return [self.define(name)]
        if kind < 0.65:
            return [self.asserted()]
        if kind < 0.75:
            count = self.random.randint(0, 2)
            self.scopes += [{} for _ in range(count)]
            return ["(push)" if count == 1 and self.chance(0.5) else f"(push {count})"]
        if kind < 0.85 and len(self.scopes) > 1:
            count = self.random.randint(1, len(self.scopes) - 1)
            del self.scopes[len(self.scopes) - count :]
            return ["(pop)" if count == 1 and self.chance(0.5) else f"(pop {count})"]
        if kind < 0.87:
            self.scopes = [{}]
            return [self.one("(reset-assertions)", "(reset)", "(reset)")]
        if kind > 0.98:
            return ["(get-value (x))", '(echo "(pop 1) "" |")']
        return ["(check-sat)"] if kind < 0.95 else ['(set-info :notes "a ""b"" (assert false) ;")']

    def declare(self, name: str) -> str:
        self.scopes[-1][name] = ((), REAL)
        as_function = self.chance(0.5)
        start = "declare-fun" if as_function else "declare-const"
        return f"({start} {self.written(name)} {'() ' if as_function else ''}Real)"

    def define(self, name: str) -> str:
        known = self.known()
        names = self.random.sample(self.pool, self.random.choice((0, 0, 1, 2)))
        kinds = [self.one(REAL, REAL, BOOL) for _ in names]
        inner = known | {n: ((), kind) for n, kind in zip(names, kinds, strict=True)}
        sort = self.one(REAL, BOOL)
        body = self.of(sort, inner, 2)
        self.scopes[-1][name] = (tuple(kinds), sort)
        if not names and self.chance(0.3):
            return f"(define-const {self.written(name)} {sort} {body})"
        pairs = zip(names, kinds, strict=True)
        parameters = " ".join(f"({self.written(n)} {kind})" for n, kind in pairs)
        return f"(define-fun {self.written(name)} ({parameters}) {sort} {body})"

    def asserted(self) -> str:
        body = self.of(BOOL, self.known(), 3)
        name = self.fresh() if self.chance(0.1) else None
        if name is None:
            return f"(assert {body})"
        self.scopes[-1][name] = ((), BOOL)
        return f"(assert (! {body} :named {self.written(name)}))"

    def fpcores(self) -> str:
        cores = []
        for _ in range(self.random.randint(1, 3)):
            pool = [name for name in NAMES if "|" not in name and "%" not in name]
            inputs = self.random.sample(pool, self.random.randint(1, 3))
            self.pool = [*dict.fromkeys([*inputs, *self.random.sample(pool, 2)])]
            known = dict.fromkeys(inputs, ((), REAL))
            ends = [self.random.sample(range(-5, 6), 2) for _ in inputs]
            bounds = [
                f"({self.one('<=', '<')} {min(e)} {n} {max(e)})"
                for n, e in zip(inputs, ends, strict=True)
            ]
            name = self.one("", "f ", ':name "(a \\" ) :pre" ')
            pre = f":pre (and {' '.join(bounds)})"
            props = f"{name}:precision binary64 {pre}" if ":" in name else f":cite (a) {pre}"
            first = name if ":" not in name else ""
            body = self.of(REAL, known, 3)
            body = f"(! :precision binary32 {body})" if self.chance(0.1) else body
            cores.append(f"(FPCore {first}({' '.join(inputs)}) {props} {body})")
        return "\n".join(cores)
