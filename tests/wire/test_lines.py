"""Pages whose lines say what they follow from: that is used, and none of it is passed over."""

from __future__ import annotations

from pathlib import Path

import pytest

import verify
from verify.cli import main
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.paper.commands import pages
from verify.prover.budget import WorkBudget
from verify.prover.outcome import Outcome
from verify.prover.proof import LemmaStep
from verify.prover.rules import Sum, Witness
from verify.wire.inputs import InputError
from verify.wire.questions import decide_page
from verify.wire.text.read_page import read_page

PAGE = """
title = "Named facts"

[contexts.box]
variables = "x y z"
constants = { k = "1/(1 + z)" }
[contexts.box.given]
x-small = "x <= 1/2"
x-positive = "0 < x"
y-small = "y <= x"
y-positive = "0 < y"
z-positive = "0 < z"

[contexts.other]
variables = "t"
given = { t-small = "t <= 1/2" }

[rows]
before = "x <= 1"
number = "sqrt(2) <= 3/2"

[[chapters]]
in = "box"

[chapters.rows]
half = { lemma = "y <= 1/2", by = "y-small x-small" }
both = { claim = "x*y <= 1/4", by = "half x-small x-positive y-positive" }
part = { claim = "x*y*k <= 1/4", by = "both z-positive k" }
below = { claim = "x*x <= 1", by = "before x-positive" }
false = { claim = "x <= 1/4", false_at = "x = 1/2, y = 1/4, z = 1" }
never = { claim = "x < 0", verdict = "refuted", by = "x-positive" }
searched = { claim = "y <= 3/4" }
"""
#: A state whose values are terms of its context, used in another one.
AWAY = """given = { t-small = "t <= 1/2" }
states = { half = "t = t/2" }

[[chapters]]
in = "box"
rows = { away = { LINE } }"""
ROWS = {
    **dict.fromkeys(("before", "number", "both", "part", "below", "searched"), PROVED),
    **dict.fromkeys(("false", "never"), REFUTED),
}
WORK = 3_000_000


def decided(text: str) -> Outcome:
    return decide_page(read_page("p.toml", text.encode()), WorkBudget(WORK))


def verdicts(text: str) -> dict[str, str]:
    return {row.name: found.verdict for row, found in decided(text).rows}


def changed(old: str, new: str) -> str:
    assert PAGE.count(old) == 1
    return PAGE.replace(old, new)


def test_lines_are_shown_by_what_they_name() -> None:
    found = decided(PAGE)
    assert {row.name: one.verdict for row, one in found.rows} == ROWS
    lemmas = [step.name for step in found.steps if isinstance(step, LemmaStep)]
    assert "half" in lemmas
    proof = found.decisions["both"].proof
    assert isinstance(proof, Sum)
    assert "half" in str(proof.addends)
    assert isinstance(found.decisions["false"].proof, Witness)
    assert isinstance(found.decisions["never"].proof, Sum)


@pytest.mark.parametrize(
    ("old", "new", "open_rows"),
    [
        # a false lemma, and a lemma that does not follow from what it names
        ('"y <= 1/2", by = "y-small x-small"', '"y <= 1/4"', {"both", "part"}),
        ('by = "y-small x-small"', 'by = "y-small"', {"both", "part"}),
        # names that do not suffice, a name besides
        ('by = "half x-small x-positive y-positive"', 'by = "x-small"', {"both", "part"}),
        ('by = "half x-small', 'by = "z-positive half x-small', set()),
        # products that do not add up, rules that show something else
        (
            'by = "half x-small x-positive y-positive"',
            'by = "goal + half*x-small"',
            {"both", "part"},
        ),
        ('by = "before x-positive"', 'by = "goal + goal*goal"', {"below"}),
        ('by = "before x-positive"', 'rule = "root"', {"below"}),
        ('by = "before x-positive"', 'rule = "interval"', {"below"}),
        ('by = "before x-positive"', 'rule = "entry"', {"below"}),
        ('by = "before x-positive"', 'using = "k"', {"below"}),
        ('by = "before x-positive"', 'plus = "k = x"', {"below"}),
        # values at which the row holds, at which not all is given, a negation that does not follow
        ("x = 1/2, y = 1/4, z = 1", "x = 1/4, y = 1/8, z = 1", {"false"}),
        ("x = 1/2, y = 1/4, z = 1", "x = 3/4, y = 1/8, z = 1", {"false"}),
        ('by = "x-positive" }', 'by = "y-positive" }', {"never"}),
        ('claim = "x < 0"', 'claim = "x < 1"', {"never"}),
        ('claim = "y <= 3/4"', 'claim = "y <= 3/4", verdict = "refuted"', {"searched"}),
        (
            'claim = "y <= 3/4"',
            'claim = "y <= 3/4", verdict = "refuted", by = "half"',
            {"searched"},
        ),
    ],
)
def test_lies_leave_their_rows_undecided(old: str, new: str, open_rows: set[str]) -> None:
    found = decided(changed(old, new))
    others = {row.name: one.verdict for row, one in found.rows if row.name not in open_rows}
    assert others == {name: verdict for name, verdict in ROWS.items() if name not in open_rows}
    assert all(found.decisions[name].verdict == UNDECIDED for name in open_rows)
    assert all(found.decisions[name].reason for name in open_rows)


def test_a_lemma_that_is_not_shown_leaves_the_page_undecided() -> None:
    lies = [line for line in PAGE.splitlines() if not line.startswith(("false", "never"))]
    text = "\n".join([*lies, ""])
    assert decided(text).verdict == PROVED
    found = decided(text + 'odd = { lemma = "z <= 5" }\n')
    assert {one.verdict for _, one in found.rows} == {PROVED}
    assert (found.verdict, "odd" in found.spent) == (UNDECIDED, True)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('by = "half x-small', 'by = "hal x-small'),
        ('by = "half x-small', 'by = "part x-small'),  # a later line
        ('by = "half x-small', 'by = "both x-small'),  # the line itself
        ('by = "half x-small', 'by = "t-small x-small'),  # of another context
        ("half = { lemma", "before = { lemma"),  # the name of a row
        ("half = { lemma", "x = { lemma"),
        ('in = "box"\n\n', 'in = "box"\nlet = { x = "1/4" }\n\n'),
        ('lemma = "y <= 1/2"', 'lemma = "y <= 1/2", false_at = "x = 1"'),
        ('lemma = "y <= 1/2"', 'lemma = "y <= 1/2", verdict = "refuted"'),
        ('lemma = "y <= 1/2"', 'lemma = "y <= 1/2", role = "printed"'),
        ('by = "both z-positive k"', 'by = "both z-positive", using = "k"'),  # names, no products
        ('by = "before x-positive"', 'by = "before", rule = "root"'),
        ('by = "before x-positive"', 'by = "before", of = "k"'),
        ('verdict = "refuted", by', 'verdict = "proved", by'),
        ('z = 1"', 'z = 1", by = "x-small"'),
        ('given = { t-small = "t <= 1/2" }', 'given = { t-small = "t <= 1/2" }\nby = "none"'),
        ('before = "x <= 1"', 'before = { claim = "x <= 1", by = "half" }'),
        # numbers and signs in products
        ('by = "before x-positive"', 'by = "goal + 1/0"'),
        ('by = "before x-positive"', 'by = "goal + before^0"'),
        ('by = "before x-positive"', 'by = "goal + before^1000"'),
        ('by = "before x-positive"', 'by = "goal - before"'),
        ('by = "before x-positive"', 'by = "goal + (-1)*before"'),
        # a fact where an equation has to be, what was refuted, a list where there is no minimum
        ('by = "before x-positive"', 'using = "before"'),
        ('by = "before x-positive"', 'plus = { before = "x" }'),
        ('claim = "y <= 3/4"', 'claim = "y <= 3/4", by = "never"'),
        ('claim = "y <= 3/4"', 'claim = "y <= 3/4", by = "false"'),
        ('by = "before x-positive"', 'by = ["before", "x-positive"]'),
        ('claim = "y <= 3/4"', 'claim = "0 <= min(x, y)", by = ["x-positive"]'),
        ('claim = "y <= 3/4"', 'claim = "0 <= min(x, y)", by = ["x-positive", "", ""]'),
        (
            'claim = "y <= 3/4"',
            'claim = "min(x, y) <= 1", rule = "cases", of = "min(x, y)", by = ["goal"]',
        ),
        # values and facts that are missing, or too many
        ('claim = "y <= 3/4"', 'instance = "half", by = ""'),
        ('claim = "y <= 3/4"', 'instance = "half", at = "x = 1, y = 1, z = 1"'),
        ('claim = "y <= 3/4"', 'instance = "k", at = "x = 1, y = 1, z = 1", by = ""'),
        ('claim = "y <= 3/4"', 'applies = "other"'),
        ('claim = "y <= 3/4"', 'applies = "other", at = "t = x", by = ""'),
        ('claim = "y <= 3/4"', 'applies = "other", at = "t = x", by = "x-small x-positive"'),
        ('claim = "y <= 3/4"', 'always = "other", start = "t = 0"'),
        ('claim = "y <= 3/4"', 'always = "box", start = "point", next = "point"'),
        (
            'given = { t-small = "t <= 1/2" }',
            'given = { t-small = "t <= 1/2" }\npoint = { t = 0 }\nby = "before number"',
        ),
        # names of another context, which come with a state
        ('given = { t-small = "t <= 1/2" }', AWAY.replace("LINE", 'claim = "t-small at half"')),
        ('given = { t-small = "t <= 1/2" }', AWAY.replace("LINE", 'claim = "1 < 2", at = "half"')),
        (
            'given = { t-small = "t <= 1/2" }',
            AWAY.replace("LINE", 'claim = "t <= 0", in = "other", false_at = "half"'),
        ),
        (
            'given = { t-small = "t <= 1/2" }',
            AWAY.replace("LINE", 'applies = "other", at = "half"'),
        ),
        (
            'given = { t-small = "t <= 1/2" }',
            AWAY.replace("LINE", 'always = "other", start = "half", next = "half", in = ""'),
        ),
    ],
)
def test_what_cannot_be_meant_is_refused(old: str, new: str) -> None:
    with pytest.raises(InputError, match=r"p\.toml, line"):
        read_page("p.toml", changed(old, new).encode())


def test_an_instance_has_the_constants_of_its_values() -> None:
    lines = """
small = { lemma = "k <= 1", by = "z-positive k" }
there = { lemma = "0 < x + z", by = "goal + x-positive + z-positive" }
at-sum = { instance = "small", at = "x = x, y = y, z = x + z", by = "BY" }
then = { claim = "1/(1 + x + z) <= 1", by = "at-sum" }
"""
    facts = "x-small x-positive y-small y-positive there"
    assert verdicts(PAGE + lines.replace("BY", facts))["then"] == PROVED
    swapped = "x-small x-positive y-positive y-small there"
    assert verdicts(PAGE + lines.replace("BY", swapped))["then"] == UNDECIDED


@pytest.mark.parametrize("value", ["1/(x - 1/4)", "sqrt(x - 1/4)", "log(0*x)"])
def test_a_constant_without_a_value_is_left_out_with_what_uses_it(value: str) -> None:
    text = changed('k = "1/(1 + z)"', f'k = "1/(1 + z)", m = "{value}"')
    text += 'uses-m = { claim = "m <= 5" }\nafter = { claim = "y <= 2", by = "half" }\n'
    found = decided(text)
    assert found.spent == "m was not seen to have a value"
    assert {row.name: one.verdict for row, one in found.rows} == {
        **ROWS,
        "uses-m": UNDECIDED,
        "after": PROVED,
    }
    bare = '\n[rows]\nhigh = "x <= 1"\n'
    undecided = decided(text.partition("\n[rows]")[0] + bare)
    assert undecided.decisions["high"].reason == "m was not seen to have a value"


def test_what_a_line_tried_in_vain_is_forgotten() -> None:
    """A name of a lemma was taken by a line that was left out: exit code 5."""
    text = """
title = "t"
[let]
c = 2
[contexts.other]
variables = "z"
constants = { w = "c/(1 + c^2)" }
given = { low = "-1 <= z", high = "z < 1" }
[[chapters]]
[chapters.rows]
in-vain = { claim = "1 > c", false_at = "z = 1", in = "other" }
"""
    found = decided(text)
    assert (found.verdict, found.spent) == (UNDECIDED, "")


NESTED = """
title = "t"
[contexts.out]
variables = ["x"]
given = ["0 < x", "x < 1"]
[contexts.inside]
in = "out"
variables = ["y"]
given = ["0 < y", "y < x"]
states = { half = "y = x/2" }
[rows]
below = "y < x"
[[chapters]]
in = "inside"
[chapters.rows]
named = { claim = "y <= x/4", false_at = "half", role = "printed" }
written = { claim = "y <= x/4", false_at = "y = x/2", role = "printed" }
true-there = { claim = "y <= x/4", false_at = "y = x/5", role = "printed" }
outside = { claim = "y <= x/4", false_at = "y = 2*x", role = "printed" }
"""


def test_a_claim_is_false_at_values_in_terms_of_the_context_around() -> None:
    assert verdicts(NESTED) == {
        "below": PROVED,
        "named": REFUTED,
        "written": REFUTED,
        "true-there": UNDECIDED,
        "outside": UNDECIDED,
    }


def test_the_points_of_contexts_are_shown_by_what_they_name() -> None:
    inner = """
[contexts.inner]
in = "box"
variables = "u"
given = { u-positive = "0 < u" }
point = { u = "x/2" }
by = "NAME"
[rows]"""
    text = (
        changed("[rows]", inner).replace(
            "half = {", 'start = { lemma = "0 < x/2", by = "x-positive" }\nhalf = {'
        )
        + '\n[[chapters]]\nin = "inner"\n[chapters.rows]\n'
        + 'last = { claim = "0 < u*x", by = "u-positive x-positive" }\n'
    )
    assert decided(text.replace("NAME", "start")).decisions["last"].verdict == PROVED
    lie = decided(text.replace("NAME", "y-positive"))
    assert lie.decisions["last"].verdict == UNDECIDED
    assert lie.decisions["both"].verdict == PROVED


@pytest.mark.parametrize("name", ["line", "step"])
def test_pages_of_the_paper_are_proved_as_anybodys(name: str) -> None:
    found = decide_page(pages.page(name), WorkBudget())
    assert (found.verdict, found.statement) == (PROVED, pages.statement(name))


def test_the_command_and_the_library(tmp_path: Path) -> None:
    path = tmp_path / "p.toml"
    path.write_text(PAGE)
    assert main(["prove", str(path)]) == 1
    assert main(["prove", str(path), "--rows", "part,below", "--out", str(tmp_path / "out")]) == 0
    assert main(["check", str(tmp_path / "out")]) == 0
    assert verify.prove_page(path, work=WORK).verdict == REFUTED
    with pytest.raises(InputError, match="prove_page"):
        verify.read_page(path)


@pytest.mark.parametrize("place", ['["other"]', "3", '{ a = "other" }'])
def test_a_line_is_in_a_context_that_has_a_name(place: str) -> None:
    more = f'[[chapters]]\n[chapters.rows]\nline = {{ claim = "t < 1", in = {place} }}\n'
    with pytest.raises(InputError, match="is no context"):
        read_page("p.toml", (PAGE + more).encode())


@pytest.mark.parametrize("fact", ['"nothere"', '["x-small"]', '"k"'])
def test_a_claim_is_an_instance_of_a_fact_that_there_is(fact: str) -> None:
    line = f'a = {{ claim = "1/4 <= 1/2", instance = {fact}, at = {{ x = "1/4" }}, by = "" }}'
    with pytest.raises(InputError, match=r"rows\.a\.instance: "):
        read_page(
            "p.toml", (PAGE + f'[[chapters]]\nin = "box"\n[chapters.rows]\n{line}\n').encode()
        )
