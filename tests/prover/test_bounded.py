"""Variables that functions bound: claims that are linear in them, and inductions with them."""

from __future__ import annotations

import pytest

from verify.language.statement import PROVED, UNDECIDED
from verify.prover.budget import WorkBudget
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

WORK = 12_000_000


def verdict(given: str, claim: str) -> str:
    page = f"""
title = "t"
[contexts.s]
variables = "k a b"
given = [{given}]
point = {{ k = 2, a = "1/10", b = 1 }}
rows = {{ row = "{claim}" }}
"""
    found = decide_page(read_page("p.toml", page.encode()), WorkBudget(WORK))
    return found.decisions["row"].verdict


@pytest.mark.parametrize(
    ("given", "claim"),
    [
        ('"0 <= k", "a <= exp(-k)"', "a <= 1"),
        ('"0 <= k", "a < exp(-k)"', "a < 1"),
        ('"0 < k", "a <= exp(-k)"', "a < 1"),
        ('"0 <= k", "a <= exp(-k)"', "2*a - 3 <= -1"),
        ('"0 <= k", "a <= exp(-k)", "0 <= b"', "a*b <= b"),
        ('"1 <= k", "log(k) - 2 <= a"', "-2 <= a"),
        ('"1 <= k", "log(k) - 2 <= a"', "-6 <= 3*a"),
        ('"1 <= k", "log(k) - 2 <= a", "b <= -atan(k) + 3"', "b <= 3"),
        ('"1 <= k", "a <= 2 + cos(k)"', "a <= 3"),
    ],
)
def test_a_bound_in_place_of_the_variable(given: str, claim: str) -> None:
    assert verdict(given, claim) == PROVED


@pytest.mark.parametrize(
    ("given", "claim"),
    [
        ('"0 <= k", "exp(-k)/20 <= a"', "a <= 1"),  # the bound is on the other side
        ('"0 <= k", "a <= exp(-k)"', "a < 1"),  # meets at an end
        ('"0 <= k", "a <= exp(-k)"', "a*b <= b"),  # b may be negative
        ('"0 <= k", "a <= exp(-k)"', "a^2 <= 1"),  # not linear, and false below
        ('"1 <= k", "log(k) - 2 <= a"', "0 <= 1 - a"),
    ],
)
def test_what_does_not_follow_is_not_proved(given: str, claim: str) -> None:
    assert verdict(given, claim) != PROVED


#: What is carried beside the bounds of n, the first state, the next one, and what follows.
CARRIED = {
    "1/n": ("1 <= n", "a <= 1 - 1/n", "n = 1, a = 0", "a = 1 - 1/(n + 1)", "a < 1"),
    "n/(n+1)": ("1 <= n", "a <= 1/n", "n = 1, a = 1", "a = a*n/(n + 1)", "a <= 1"),
    "squares": ("1 <= n", "a <= 2 - 1/n", "n = 1, a = 1", "a = a + 1/(n + 1)^2", "a < 2"),
    "1/n^2": ("1 <= n", "a <= 1/n^2", "n = 1, a = 1", "a = a*(n/(n + 1))^2", "a <= 1"),
    "2/(n+2)": ("0 <= n", "a <= 2/(n + 2)", "n = 0, a = 1", "a = a*(1 - 2/(n + 3))", "a <= 1"),
    "roots": (
        "1 <= n",
        "2*sqrt(n + 1) - 2 <= a",
        "n = 1, a = 1",
        "a = a + 1/sqrt(n + 1)",
        "0 <= a",
    ),
    "2 sqrt n": ("0 <= n", "a <= 2*sqrt(n)", "n = 0, a = 0", "a = a + 1/sqrt(n + 1)", "0 <= n"),
    "1/sqrt(n+1)": (
        *("0 <= n", "a <= 1/sqrt(n + 1)", "n = 0, a = 1"),
        *("a = a*sqrt(n + 1)/sqrt(n + 2)", "a <= 1"),
    ),
    "differences": (
        *("0 <= n", "a <= sqrt(n + 1) - sqrt(n)", "n = 0, a = 1"),
        *("a = sqrt(n + 2) - sqrt(n + 1)", "a <= 1"),
    ),
    "log": ("2 <= n", "a <= 1/log(n)", "n = 2, a = 1", "a = a*log(n)/log(n + 1)", "1 < n"),
    "log of a sum": ("1 <= n", "a <= log(n + 1)", "n = 1, a = 0", "a = a", "a <= log(n + 2)"),
    "exp": ("0 <= n", "a <= exp(-n)", "n = 0, a = 1", "a = a/e", "a <= 1"),
}


@pytest.mark.parametrize("name", CARRIED)
def test_inductions_carry_functions_of_the_number(name: str) -> None:
    least, carried, start, after, row = CARRIED[name]
    page = f"""
title = "t"
[contexts.s]
variables = "n a"
states = {{ start = "{start}", next = "n = n + 1, {after}" }}
carried = {{ least = "{least}", positive = "0 <= a", carried = "{carried}" }}
[[chapters]]
in = "s"
[chapters.rows]
goes-on = {{ always = "s", start = "start", next = "next", in = "" }}
row = {{ claim = "{row}" }}
"""
    found = decide_page(read_page("p.toml", page.encode()), WorkBudget(WORK))
    assert {one.verdict for _, one in found.rows} == {PROVED}, found.rows
    wrong = page.replace("n = n + 1", "n = n - 5")
    found = decide_page(read_page("p.toml", wrong.encode()), WorkBudget(300_000))
    assert found.decisions["goes-on"].verdict == UNDECIDED
