"""Tables of a page that are written as texts: the same tables, and nothing is passed over."""

from __future__ import annotations

import random
import tomllib
from typing import Any

import pytest

from verify.wire.inputs import InputError
from verify.wire.text.entries import spelled_out
from verify.wire.text.places import Places
from verify.wire.text.read_page import read_page

TEXTS = """
title = "Named facts"
parameters = 'a: 1/2; b: 3'
constants = 'k: a + b; letter κ; l: k + 1; label "a label; with a semicolon"'
assumptions = '''
small: "It is small; nobody
    measures it."; kind law of motion
other: "It is not."'''

[contexts.box]
variables = 'x: ξ: "\\xi ", y, z: |ζ(1, 2)|'
let = 'f(u, v): u*v; both: [x, y]; entry: f(both[1], z)'
states = 'point: x = 1/2, y = 1/4, z = 1; next: x = y, y = y, z = z'
given = '''
x-small: x <= 1/2; x-positive: 0 < x
y-small: y <= x
y-positive: 0 < y; z-positive: 0 < z'''
constants = 'c: 1/(1 + z)'

[[chapters]]
in = "box"
let = 'short: x + y'
rows = '''
# A comment; lemma nothing: 0 < 1
lemma half: y <= 1/2; by y-small
    x-small
both: x*y <= 1/4; "the product; it is small"; by half x-small x-positive y-positive; uses small
    other; severity "proved; not by the printed argument"; corrected_by part; role printed
part: x*y*c <= 1/4; by both z-positive c
least: 0 <= min(short, entry); by goal + x-positive + y-positive; by goal + f; using c; plus c = 1
always going: box; start point; next next; in
instance again: half; at x = 1/2, y = y, z = z; by x-positive'''
"""
TABLES = """
title = "Named facts"
[parameters]
a = "1/2"
b = "3"
[constants]
k = { value = "a + b", letter = "κ" }
l = { value = "k + 1", label = "a label; with a semicolon" }
[assumptions]
small = { sentence = "It is small; nobody measures it.", kind = "law of motion" }
other = "It is not."
[contexts.box]
variables = 'x: ξ: "\\xi ", y, z: |ζ(1, 2)|'
[contexts.box.let]
"f(u, v)" = "u*v"
both = "[x, y]"
entry = "f(both[1], z)"
[contexts.box.states]
point = "x = 1/2, y = 1/4, z = 1"
next = "x = y, y = y, z = z"
[contexts.box.given]
x-small = "x <= 1/2"
x-positive = "0 < x"
y-small = "y <= x"
y-positive = "0 < y"
z-positive = "0 < z"
[contexts.box.constants]
c = "1/(1 + z)"
[[chapters]]
in = "box"
[chapters.let]
short = "x + y"
[chapters.rows]
half = { lemma = "y <= 1/2", by = "y-small x-small" }
part = { claim = "x*y*c <= 1/4", by = "both z-positive c" }
going = { always = "box", start = "point", next = "next", in = "" }
again = { instance = "half", at = "x = 1/2, y = y, z = z", by = "x-positive" }
[chapters.rows.both]
claim = "x*y <= 1/4"
says = "the product; it is small"
by = "half x-small x-positive y-positive"
uses = ["small", "other"]
severity = "proved; not by the printed argument"
corrected_by = "part"
role = "printed"
[chapters.rows.least]
claim = "0 <= min(short, entry)"
by = ["goal + x-positive + y-positive", { by = "goal + f", using = "c", plus = "c = 1" }]
"""


def tables(text: str) -> dict[str, Any]:
    return spelled_out(tomllib.loads(text), Places("p.toml", text))


def test_a_text_is_the_table_that_it_stands_for() -> None:
    assert tables(TEXTS) == tomllib.loads(TABLES)
    assert list(tables(TEXTS)["contexts"]["box"]["given"])[:2] == ["x-small", "x-positive"]


def test_letters_of_variables_are_a_text() -> None:
    variables = "'x: ξ: \"\\xi \", y, z: |ζ(1, 2)|'"
    text = f"""title = "t"
[contexts.box]
variables = {variables}
given = ["0 < x"]
rows = 'row: 0 < x*x'"""
    (context,) = read_page("p.toml", text.encode()).statement.contexts
    found = [(v.name, v.letter, v.tex) for v in context.variables]
    assert found[:2] == [("x", "ξ", "\\xi "), ("y", "y", "y")]
    assert found[2][:2] == ("z", "|ζ(1, 2)|")


def test_drawn_tables_are_read_back() -> None:
    """Whatever is in an entry, and wherever lines break, the table is the one that was written."""
    rng = random.Random(41)
    words = ["x", "a-b", "0 <= x;", "by", "lemma", "goal*a", "f(x, y)", "#", "κ:", "1/2"]
    for _ in range(300):
        rows: dict[str, Any] = {}
        parts: list[str] = []
        for i in range(rng.randint(1, 5)):
            kind = rng.choice(["claim", "lemma", "always", "instance", "applies", "entries"])
            value = " ".join(rng.sample(["x", "<=", "1/2", "(y)"], rng.randint(1, 4)))
            row = {kind: value}
            part = f"{'' if kind == 'claim' else kind + ' '}row-{i}.a: {value}"
            for key in rng.sample(["says", "label", "severity", "group"], rng.randint(0, 4)):
                row[key] = " ".join(rng.choices(words, k=rng.randint(1, 4)))
                part += f'; {"" if key == "says" else key + " "}"{row[key]}"'
            rows[f"row-{i}.a"] = row
            parts.append(part.replace(" ", "\n  ") if rng.random() < 0.5 else part)
        text = rng.choice(["\n", ";\n", "; "]).join(parts)
        written = f"[[chapters]]\nrows = '''\n{text}'''\n"
        assert tables(written)["chapters"][0]["rows"] == rows, written


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("lemma half: y", "half y", ("chapters.rows", "has no name")),
        ("both: x*y", "half: x*y", ("rows.half", "twice")),
        ("; by both z", "; by both; label a; label z", ("part", "label stands there twice")),
        ("; by both z-positive c", "; from both", ("part", "'from'")),
        ("; uses small", "; uses smaller", ("both", "'smaller'")),
        ('it is small"', "it is small", ("both", "quotation mark")),
        ('"the product;', 'label "the" product;', ("both", "quotation mark")),
        ("part: x*y*c <= 1/4; by", "part: x*y*c <= 1/4 by", ("part",)),
        ("part: x*y*c", "x*y*c", ("'x*y*c'",)),
        ("y-small: y <= x\n", "y-small y <= x\n", ("'y-small'",)),
        ("x-small: x <= 1/2; x-positive", "x-small: x <= 1/2, x-positive", ("x-small",)),
        ("always going: box", "whenever going: box", ("'whenever'",)),
        ("rows = '''\n", "rows = '''\nby x-small\n", ("chapters.rows", "has no name")),
    ],
)
def test_what_is_unclear_in_a_text_is_refused(old: str, new: str, words: tuple[str, ...]) -> None:
    """Nothing that stands in a text is passed over."""
    assert TEXTS.count(old) == 1
    with pytest.raises(InputError) as error:
        read_page("p.toml", TEXTS.replace(old, new).encode())
    assert all(word in str(error.value) for word in words), str(error.value)


def test_entries_have_lines() -> None:
    lines = Places("p.toml", TEXTS).key_lines
    text = TEXTS.splitlines()
    for keys in (
        ("chapters", "rows", "half"),
        ("chapters", "rows", "going"),
        ("contexts", "box", "given", "x-positive"),
        ("contexts", "box", "constants", "c"),
        ("assumptions", "other"),
        ("constants", "l"),
    ):
        assert f"{keys[-1]}:" in text[lines[keys] - 1]
