"""Small files that ask for much of a reader, a search or a writer, and a generator of others."""

from __future__ import annotations

import random
from collections.abc import Callable

from tests.check.support import INTERVAL, Pair

#: Pages, by what is much in them.
PAGES: dict[str, Callable[[], str]] = {}
IN_A_BOX = "title = 't'\n[contexts.c]\nvariables = ['x']\ngiven = ['1/10 <= x <= 2/10']\n[rows]\n"


def page(make: Callable[[], str]) -> Callable[[], str]:
    """Register a page under the name of the function that makes it."""
    PAGES[make.__name__.replace("_", "-")] = make
    return make


def nested(functions: list[str], inner: str = "x") -> str:
    """Functions of functions."""
    return "".join(f"{name}(" for name in functions) + inner + ")" * len(functions)


def row(formula: str) -> str:
    """A page with a row about a number in an interval."""
    return f"{IN_A_BOX}a = '{formula}'\n"


@page
def absolute_values() -> str:
    return row(f"0 <= {nested(['abs'] * 90)}")


@page
def tangents() -> str:
    return row(f"0 <= {nested(['tan'] * 60)}")


@page
def inverse_sines() -> str:
    return row(f"0 <= {nested(['asin'] * 25)}")


@page
def functions_of_functions() -> str:
    let = "".join(f'"f_{k}(x)" = "f_{k - 1}(x) + f_{k - 1}(x + 1)"\n' for k in range(1, 60))
    return f"title = 't'\n[let]\n\"f_0(x)\" = \"x\"\n{let}[rows]\na = 'f_59(1) > 0'\n"


@page
def sums_of_functions_that_are_sums() -> str:
    let = '"f(x)" = "sum(k*x, k, 1, 1000)"\n"g(x)" = "sum(f(k*x), k, 1, 1000)"\n'
    return f"title = 't'\n[let]\n{let}[rows]\na = 'sum(g(k), k, 1, 1000) > 0'\n"


@page
def sums_in_products_of_vectors() -> str:
    inner = "x"
    for letter in "ijk":
        inner = f"sum(dot({inner}*V, V), {letter}, 1, 900)"
    given = "variables = 'x'\ngiven = ['0 <= x <= 1']\ngram = { V = '1' }"
    return f"title = 't'\n[contexts.c]\n{given}\nrows = {{ a = '{inner} > 0' }}\n"


@page
def entries_of_a_long_minimum() -> str:
    least = ", ".join(f"x + {i}" for i in range(9000))
    context = f"variables = 'x'\ngiven = ['0 <= x <= 1']\nconstants = {{ m = 'min({least})' }}"
    return (
        f"title = 't'\n[contexts.c]\n{context}\n[[chapters]]\nin = 'c'\n[chapters.rows]\n"
        "l = { entries = 'm', says = 'entry {i}' }\n"
    )


@page
def many_sets_with_many_rows() -> str:
    sets = "".join(f"s{i} = 'needed'\n" for i in range(2000))
    names = ", ".join(f"'s{i}'" for i in range(2000))
    rows = "".join(f"r{i} = {{ claim = 'b < {i + 2}' }}\n" for i in range(500))
    chapter = f"[[chapters]]\nin = [{names}]\nconstants = {{ b = '1' }}\n[chapters.rows]\n{rows}"
    return f"title = 't'\n[sets]\n{sets}{chapter}"


@page
def products_in_parentheses() -> str:
    by = "(" * 20_000 + "c.1" + ")" * 20_000
    context = "[contexts.c]\nvariables = 'x'\ngiven = ['0 <= x <= 1']\n"
    return (
        f"title = 't'\n{context}[[chapters]]\nin = 'c'\n[chapters.rows]\n"
        f"l = {{ claim = '0 <= x', by = 'goal*{by}' }}\n"
    )


@page
def powers_of_matrices() -> str:
    entries = [[f"1/{i + j + 2}" for i in range(8)] for j in range(8)]
    let = f"A_0 = {entries}\n" + "".join(f"A_{k} = 'A_{k - 1}*A_{k - 1}'\n" for k in range(1, 40))
    return f"title = 't'\n[let]\n{let}[rows]\na = 'A_39[1, 1] > 0'\n"


@page
def many_products_of_matrices() -> str:
    entries = [[f"1/{i + j + 2}" for i in range(8)] for j in range(8)]
    product = "*".join(["A"] * 40_000)
    return f"title = 't'\n[let]\nA = {entries}\n[rows]\na = '({product})[1, 1] > 0'\n"


@page
def hyperbolic_functions() -> str:
    return row(f"0 <= {nested(['cosh'] * 30)}")


@page
def absolute_values_of_tangents() -> str:
    return row(f"0 <= {nested(['abs', 'tan'] * 40)}")


@page
def squares_of_squares() -> str:
    return row("0 <= " + "(" * 90 + "x" + ")^2" * 90)


@page
def high_powers_of_high_powers() -> str:
    return row("0 <= " + "(" * 60 + "x" + ")^999" * 60)


@page
def a_bound_of_absolute_values() -> str:
    return row("x <= 1").replace("2/10'", f"2/10', '{nested(['abs'] * 90)} <= 1'")


@page
def constants_that_are_squares_of_others() -> str:
    lines = [f"c{i} = 'c{i - 1}*c{i - 1} + 1/{i}'" for i in range(1, 1500)]
    return "title = 't'\n[constants]\nc0 = '1/3'\n" + "\n".join([*lines, "[rows]", "a = '0 < c9'"])


@page
def many_rows() -> str:
    return "title = 't'\n[rows]\n" + "".join(f"r{i} = '0 <= {i}'\n" for i in range(1500))


@page
def many_constants() -> str:
    lines = "".join(f"c{i} = '{i}/7'\n" for i in range(3000))
    return f"title = 't'\n[constants]\n{lines}[rows]\na = '0 <= c1'\n"


@page
def many_variables() -> str:
    names = ", ".join(f"'x{i}'" for i in range(8000))
    return f"title='t'\n[contexts.c]\nvariables=[{names}]\ngiven=['0 <= x1']\n[rows]\na='0 <= x1'\n"


@page
def many_variables_with_bounds() -> str:
    names = ", ".join(f"'x{i}'" for i in range(500))
    given = ", ".join(f"'0 <= x{i} <= 1'" for i in range(500))
    return f"title='t'\n[contexts.c]\nvariables=[{names}]\ngiven=[{given}]\n[rows]\na='0 <= x1'\n"


@page
def an_alternative_of_many() -> str:
    return row(" or ".join(f"x <= {i}" for i in range(6000)))


@page
def a_long_sum() -> str:
    return row("0 <= " + " + ".join(["x"] * 24_000))


@page
def long_fractions() -> str:
    return row("0 <= " + " + ".join("1/" + "7" * 3900 + str(i) for i in range(24)))


@page
def a_line_without_a_key() -> str:
    return 'title = """\n' + "a." * 40_000 + '\n"""\n[rows]\na = "0 <= y"\n'


def doubled(levels: int, op: str = "add") -> Pair:
    """A statement of which each shared term has the one before it twice."""
    pair = Pair()
    pair.statement["terms"] = {"t0": ["div", "2", "2"]} | {
        f"t{i}": [op, f"t{i - 1}", f"t{i - 1}"] for i in range(1, levels + 1)
    }
    return pair.row("a", ["<", "0", f"t{levels}"], INTERVAL)


def lettered(letter: str, tex: str) -> Pair:
    """A statement of one constant with this letter, which stands 190 times in a deep term."""
    pair = Pair()
    constant = {"name": "k", "label": "", "letter": letter, "tex": tex, "term": "1/2"}
    pair.statement["constants"] = [constant]
    pair.steps.append({"constant": "k", "proof": INTERVAL})
    pair.statement["terms"] = {"t0": "k"} | {
        f"t{i}": ["add", f"t{i - 1}", "k"] for i in range(1, 191)
    }
    return pair.row("a", ["<", "0", "t190"], INTERVAL)


def nested_powers(levels: int) -> str:
    """A family of scenes one of whose numbers is a power of a power of a power."""
    term = "a"
    for _ in range(levels):
        term = f"(1 + {term})**20"
    return f"""r = "0.3"
positions = [[0, 0], ["2 + {term}", "b"], [-3, "0.2"]]
velocities = [[0, 0], [-1, 0], [1, 0]]
[parameters]
a = "0..0.1"
b = "0..0.3"
"""


def drawn(seed: int) -> str:
    """A page of at most some kilobytes that nests, repeats and shares at random."""
    draw = random.Random(seed)
    functions = ["abs", "tan", "atan", "asin", "cosh", "tanh", "exp", "sqrt", "", "-", "1/", "2^"]

    def formula(depth: int) -> str:
        kind = draw.randrange(7)
        if depth == 0 or kind == 0:
            return draw.choice(["x", "c0", "c1", "1/3", "7" * draw.randint(1, 400), "1e-300", "pi"])
        if kind < 3:
            return nested([draw.choice(functions) for _ in range(draw.randint(1, 12))], formula(0))
        if kind == 3:
            return f"({formula(depth - 1)})^{draw.choice([2, 3, 999])}"
        if kind == 4:
            return f"sum({formula(0)}*k, k, 1, {draw.choice([2, 50, 300])})"
        if kind == 5:
            return f"min({', '.join(formula(depth - 1) for _ in range(draw.randint(2, 5)))})"
        return f"({formula(depth - 1)}) {draw.choice('+-*/')} ({formula(depth - 1)})"

    lines = [
        "title = 't'",
        "[constants]",
        "c0 = '1/3'",
        f"c1 = '{draw.choice(['c0^9', 'abs(c0)'])}'",
    ]
    lines += ["[contexts.c]", "variables = ['x']", "given = ['1/10 <= x <= 2/10']", "[rows]"]
    relations = ["<", "<=", ">", "="]
    for i in range(draw.randint(1, 4)):
        lines.append(f"r{i} = '{formula(3)} {draw.choice(relations)} {formula(2)}'")
    return "\n".join(lines) + "\n"
