"""Sentences with numbers: no interval is empty, inputs are exact, differences are seen."""

from __future__ import annotations

import random
import re
from fractions import Fraction

import pytest

from tests.points import parameters
from tests.prover.test_decimals import shown, value_of
from verify.cli import main
from verify.language.statement import NEEDED, PRINTED, PROVED, Obligation
from verify.language.terms import Claim, as_term, symbol
from verify.language.typeset import LONG, Typesetter
from verify.paper.commands.theorem1 import decide_point
from verify.prover.outcome import Outcome
from verify.publication import REPAIRED
from verify.views import words
from verify.views.point import failed_hypotheses, in_numbers, place, theorem_in_numbers
from verify.views.prove import _difference

#: Points at which a sentence stated an empty set, or hid on which side of a threshold it is.
FOUND = [
    ("0.055728", "1"),
    ("0.03", "0.79082"),
    ("1/64", "0.61539"),
    ("1/64", "0.61538461538461538461"),
    ("0.03", "0.7908197840"),
]


def threshold(r: float) -> float:
    s = r ** (1 / 3)
    return 2 * s * (1 + s) / (1 + r)


def drawn(number: int) -> list[tuple[str, str]]:
    """Points of all sizes, most of them near the threshold, on both sides of it."""
    draw = random.Random(20261127)
    found = []
    for _ in range(number):
        r = round(10 ** draw.uniform(-6, -1.255), draw.choice((8, 10, 14)))
        far = draw.choice((1, -1)) * 10 ** draw.uniform(-12, -0.5)
        c = min(1.0, threshold(r) * (1 + far))
        found.append((f"{r:.14f}", f"{c:.14f}"))
    return found


def outcome_at(r: str, c: str) -> Outcome:
    return decide_point(parameters(r, c))


def told(text: str) -> Fraction:
    return Fraction(text) if "/" in text else value_of(text)


@pytest.mark.parametrize("point", [*FOUND, *drawn(60)], ids=" ".join)
def test_a_sentence_about_a_point_is_true_and_says_something(point: tuple[str, str]) -> None:
    outcome = outcome_at(*point)
    known = words.definitions_of(outcome)
    _check_place(outcome)
    if outcome.verdict != PROVED:
        for _, text in failed_hypotheses(outcome):
            _check_difference(text)
        return
    sentence = theorem_in_numbers(outcome)
    assert sentence == in_numbers(outcome)
    low, high = map(value_of, re.findall(r"in \[(\S+), (\S+)\],", sentence)[0])
    v_0, v_1 = known["V_0"].value, known["repaired.V_1"].value
    third = (v_1 - v_0) / 3
    assert v_0 + third <= low < high <= v_1 - third
    assert high - low >= third * Fraction(9, 10)
    for name, pattern in (
        ("eta_bar", r"-η_c ≤ ([^,]+), "),
        ("x_0", r"φ⁻\| ≤ (\S+) and"),
        ("d_const", r"min\(([^,]+),"),
        ("d_slope", r"min\([^,]+, (\S+) η_c²"),
        ("T_star", r"within the time (\S+) "),
    ):
        assert value_of(re.findall(pattern, sentence)[0]) == known[f"repaired.{name}"].value, name


def _check_place(outcome: Outcome) -> None:
    r, c = (outcome.statement.parameters[name].value for name in ("r", "c"))
    found = re.fullmatch(r"r = (\S+), (?:-cos θ₀ = (\S+)|θ₀ = π)", place(outcome))
    assert found is not None
    assert (told(found[1]), told(found[2] or "1")) == (r, c)


def _check_difference(text: str) -> None:
    if text in ("both sides are equal", ""):
        return
    found = re.fullmatch(r"(?:-cos θ₀|r) = (\S+), (?:the right side is|r_stabi =) (\S+)", text)
    assert found is not None, text
    (low, high), (other_low, other_high) = map(shown, found.groups())
    assert high <= other_low or other_high <= low


@pytest.mark.parametrize("value", ["exp(0)/10", "cos_pi(1/3)/5", "cos_pi(5/3)*log(1) + 1/10"])
def test_an_exact_value_is_no_enclosure(
    value: str, tmp_path, capsys: pytest.CaptureFixture[str]
) -> None:
    page = tmp_path / "page.toml"
    page.write_text(f'title = "A"\n[constants]\nq = "{value}"\n[rows]\na = "q <= 1/9"\n')
    assert main(["prove", str(page), "-v", "--out", str(tmp_path / "out")]) == 0
    assert "q = 0.1\n" in capsys.readouterr().out
    assert "| q | 0.1 |" in (tmp_path / "out/report.md").read_text()
    assert main(["check", "--latex", str(tmp_path / "out")]) == 0
    assert "0.1" in capsys.readouterr().out
    assert main(["explain", str(tmp_path / "out"), "a"]) == 0
    assert "left side 0.1, right side 0.11111111…" in capsys.readouterr().out


def test_a_sentence_about_a_committed_certificate_is_not_empty() -> None:
    from docs.generated import ROOT

    reports = sorted((ROOT / "certificates").rglob("report.md"))
    assert len(reports) > 15
    for path in reports:
        text = path.read_text(encoding="utf-8")
        for low, high in re.findall(
            r"\[(-?[\d.]+(?:·10[⁻⁰-⁹¹²³]+)?), (-?[\d.]+(?:·10\S+?)?)\]", text
        ):
            assert value_of(low) <= value_of(high), (path, low, high)


def test_a_row_whose_claim_is_long_says_where_it_is() -> None:
    """Its line was empty: "proved    a     by interval"."""
    claim = Claim("<", symbol("x"), as_term(10**500))
    row = Obligation("a", "", "", NEEDED, "", claim)
    assert words.sentence(row, Typesetter({})) == LONG
    assert words.sentence(row._replace(says="as said"), Typesetter({})) == "as said"


@pytest.mark.parametrize(
    ("low", "high", "told"),
    [
        ("1/3", "1/3", "the right side is larger by 0.33333333…"),
        ("-1/3", "-1/3", "the right side is smaller by 0.33333333…"),
        ("-98300562/100000000000", "-98300562/100000000000", "smaller by 0.00098300562"),
        ("0", "0", "both sides are equal"),
        ("-1/1000000000", "2/1000000000", "the sides differ by at most 2·10⁻⁹"),
        ("0", "1/7", "the sides differ by at most 0.143"),
    ],
)
def test_a_difference_has_no_sign(low: str, high: str, told: str) -> None:
    assert told in _difference((Fraction(low), Fraction(high)))


def test_a_row_is_explained_as_printed_before_it_is_repaired(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert main(["explain", "zeta-term-2"]) == 0
    out = capsys.readouterr().out
    sets = (PRINTED, REPAIRED)
    printed, repaired = (out.index(f"obligation {which}.zeta-term-2") for which in sets)
    assert "refuted: " in out[:printed]
    assert "proved: " in out[printed:repaired]
    assert out.index("is written in") > repaired
