"""The conditions that the text quotes or announces, in s = r^{1/3}, and the count of variables."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from verify.language.argument import Chapter, Item, Line, identity, plus, power, proof, times
from verify.language.terms import equal
from verify.paper.letters import Letters, Refuted, refuted, subject
from verify.paper.rows import HARMLESS, OTHERWISE, REMARK

STABLE = "EQUATSS3.4ZKCl2CondiStabi"
THEOREM = "THEORSS4.1ExistenCollapse"
SYSTEM = "EQUATSS2.2IterationSystm1"

below = Letters("below", s="r^(1/3)")
wide = Letters("wide", s="r^(1/3)", c="-cos θ")
slow = Letters("slow", s="r^(1/3)", c="-cos θ")
count = Letters("count", n="n")


def chapters() -> Iterator[Chapter]:
    """One context a subject."""
    exist = 0 < below.s**6 - 14 * below.s**3 + 1
    yield from subject(
        below,
        "r below r_exist = 7-4√3: r² - 14r + 1 > 0",
        "1/5",
        {"s": 0 < below.s, "s-one": below.s < 1, "exist": exist},
        _below(),
    )
    obtuse = {"s": 0 < wide.s, "s-one": wide.s < 1, "obtuse": 0 < wide.c, "real": wide.c <= 1}
    yield from subject(
        wide,
        "r below r_stabi = 9-4√5, where 1 - 3s + s² > 0, and any obtuse angle",
        "1/5 1",
        {**obtuse, "stabi": 0 < 1 - 3 * wide.s + wide.s**2},
    )
    small = {"s": 0 < slow.s, "small": 4 * slow.s <= slow.c}
    yield from subject(
        slow,
        "any obtuse angle, and r^(1/3) at most a quarter of -cos θ",
        "1/5 1",
        {**small, "obtuse": 0 < slow.c, "real": slow.c <= 1},
        _slow(),
    )
    yield from subject(
        count, "the dimension n of the space", "2", {"plane": 2 <= count.n}, _count()
    )


def _below() -> Iterator[Item]:
    s = below.s
    yield Line("quoted-threshold",
               equal((1 + s**3) - 2 * s * (1 + s), (1 + s) * (1 - 3 * s + s**2)), identity(),
               STABLE,
               "2s(1+s)/(1+s³) < 1 is 1-3s+s² > 0, that is r < 9-4√5: for larger r no angle "
               "satisfies it")  # fmt: skip
    yield Line("quoted-existence",
               equal((1 + s**3) ** 2 - 16 * s**3, s**6 - 14 * s**3 + 1), identity(),
               "EQUATSS3.4ZKCl1CondiExist",
               "4√r/(1+r) ≤ 1 is r² - 14r + 1 ≥ 0, that is r ≤ 7-4√3: for larger r no collapse "
               "takes place, by theorem II of the classification")  # fmt: skip


def _slow() -> Iterator[Item]:
    s, c = slow.s, slow.c
    whole = plus(1, "slow-s")
    yield Line("angle-if-r-is-small", 2 * s * (1 + s) < c * (1 + s**3),
               proof(times(Fraction(1, 2), "slow-small", whole),
                     times(Fraction(1, 2), "slow-obtuse",
                           plus("slow-real", "slow-small", times(3, "slow-s"))),
                     times("slow-obtuse", power("slow-s", 3))), THEOREM,
               "every obtuse angle can be prescribed once r is small enough for it")  # fmt: skip


def _count() -> Iterator[Item]:
    n = count.n
    yield from (
        Line("dimension",          equal((n - 1) + n + 1 + (n - 1) + n, 4 * n - 1), identity(),
             SYSTEM, "ω₁, W₁, d, ω₂, W₂ are 4n-1 numbers: 7 for n = 2, 11 for n = 3"),
        Line("dimension-in-parts",
             equal((n - 1) + (1 + (n - 1)) + 1 + (n - 1) + (1 + (n - 1)), 4 * n - 1), identity(),
             SYSTEM, "η and W⊥, orthogonal to ω, are n numbers, as many as W: nothing is saved"),
    )  # fmt: skip


def misprints() -> Iterator[Refuted]:
    """What is false here, each with a point at which it is."""
    yield from (
        refuted(below, "quoted-limit", 2 * below.s * (1 + below.s) < 1 + below.s**3, "2/5",
                label=STABLE,
                says="the introduction: no collapse for r above r_c = 7-4√3, in particular from "
                     "the displayed condition; that one gives 9-4√5, and r_c belongs to the other, "
                     "4√r/(1+r); here θ = π and r = 8/125 < 7-4√3", severity=OTHERWISE,
                corrected_by="quoted-existence"),
        refuted(wide, "angle-for-every-r", 2 * wide.s * (1 + wide.s) < wide.c * (1 + wide.s**3),
                "1/4 1/2", label=THEOREM,
                says="the introduction: the limiting angle can be chosen in ]π/2,π]: true if r may "
                     "be chosen for it; the theorem has for each r the angles above a bound that "
                     "depends on r; here r = 1/64", severity=REMARK,
                corrected_by="angle-if-r-is-small"),
        refuted(count, "dimension-less",
                equal((count.n - 1) + (1 + (count.n - 1)) + 1 + (count.n - 1) + (1 + (count.n - 1)),
                      4 * count.n - 3), "2", label=SYSTEM,
                says="as W⊥ is orthogonal to ω, the dimension 4n-1 could be reduced by 2",
                severity=HARMLESS, corrected_by="dimension-in-parts"),
    )  # fmt: skip
