"""A file that is not TOML: one line says where, and what it proposes works when it is followed."""

from __future__ import annotations

import random
import re
import tomllib

import pytest

from verify.wire.inputs import InputError
from verify.wire.toml import toml_of

SCENE = """r = 0.05
positions = [[0, 0], [2, 0], [1, -3]]
velocities = [[-1, 0], [1, 0], [0, 1]]
masses = [1, 2, 3]
"""
PAGE = """title = "t"
[constants]
q = "1/2"
[contexts.c]
variables = ["x"]
given = ["0 < x", "x < 1"]
point = { x = "1/2" }
[rows]
a = "q < 2"
"""


def complaint(text: str) -> str:
    """The line about a text that is not TOML."""
    with pytest.raises(InputError) as found:
        toml_of("f.toml", text.encode(), "OTHERWISE")
    words = str(found.value)
    assert "\n" not in words
    assert len(words) < 600
    assert words.startswith("f.toml, line "), words
    return words


def followed(text: str, words: str) -> str:
    """The text with the line as it is proposed; the line itself where none is."""
    number = int(words.split("line ")[1].split(":")[0])
    found = re.search(r"\); write (.*)$", words)
    assert found, words
    lines = text.split("\n")
    lines[number - 1] = found[1]
    return "\n".join(lines)


def is_toml(text: str) -> bool:
    try:
        tomllib.loads(text)
    except ValueError:
        return False
    return True


#: A line of a file, how it is mistyped, and what is meant if that is written in another way.
MISTYPED = [
    ("r = 0.05", "r = .05", ""),
    ("r = 0.05", "r = +.05", "r = +0.05"),
    ("r = 0.05", "r = 3/100", 'r = "3/100"'),
    ("r = 0.05", "r = 3 / 100", 'r = "3/100"'),
    ("r = 0.05", 'r = "0.05', 'r = "0.05"'),
    ("r = 0.05", "r = 0.05'", 'r = "0.05"'),
    ("r = 0.05", "r = '0.05\"", 'r = "0.05"'),
    ("r = 0.05", "r = “0.05”", 'r = "0.05"'),
    ("r = 0.05", "r = 0,05", ""),
    ("r = 0.05", "r = 0,05 # comma", ""),
    ("r = 0.05", "r = 5%", ""),
    ("r = 0.05", "r = 1.", "r = 1"),
    ("r = 0.05", "r = 0.05;", ""),
    ("r = 0.05", "r = 0.05,", ""),
    ("r = 0.05", "r: 0.05", ""),
    ("r = 0.05", "r := 0.05", ""),
    ("r = 0.05", "r == 0.05", ""),
    ("r = 0.05", "r 0.05", ""),
    ("r = 0.05", "r = 0.05 // half", ""),
    ("r = 0.05", "r\u00a0= 0.05", ""),
    ("r = 0.05", "r = −0.05", "r = -0.05"),
    ("r = 0.05", "r = 0.01..0.09", 'r = "0.01..0.09"'),
    ("[1, -3]]", "[1, -3]", ""),
    ("[2, 0], [1", "[2, 0, [1", ""),
    ("[[0, 0], [2", "[[0, 0, [2", ""),
    ("= [[0, 0]", "= [0, 0]", ""),
    ("[1, -3]]", "[1, -3]]]", ""),
    ("[0, 0], [2, 0], ", "[0, 0] [2, 0] ", ""),
    ("[[0, 0]", "[[0 0]", ""),
    ("[[0, 0]", "[[0\t0]", ""),
    ("[[0, 0]", "[[0; 0]", ""),
    ("[2, 0]", "[.5, 0]", "[0.5, 0]"),
    ("[2, 0]", "[1/2, 0]", '["1/2", 0]'),
    ("[2, 0]", '["2, 0]', '["2", 0]'),
    ("[2, 0]", '[2", 0]', '["2", 0]'),
    ("[2, 0]", "[2 cm, 0]", ""),
    ("[2, 0]", "[2,05, 0]", "[2.05, 0]"),
    ("[1, 0]", "[1 m/s, 0]", ""),
    ("[1, 2, 3]", "1, 2, 3", ""),
    ("[1, 2, 3]", "1 2 3", ""),
    ("[1, 2, 3]", "(1, 2, 3)", ""),
    ("[1, 2, 3]", "[1, 2, 3", ""),
    ("[1, 2, 3]", "1, 2, 3]", ""),
    ("[1, 2, 3]", "[1 kg, 2 kg, 3 kg]", ""),
    ("[1, 2, 3]", "[1. , .5, 03]", "[1, 0.5, 3]"),
    ('q = "1/2"', "q = 1/2", ""),
    ('q = "1/2"', 'η = "1/2"', '"η" = "1/2"'),
    ('q = "1/2"', "q = min(1, 2)", 'q = "min(1, 2)"'),
    ('"x < 1"]', '"x < 1"', ""),
    ('"x < 1"]', '"x < 1]', ""),
    ('["0 < x", "x', '["0 < x, "x', ""),
    ('["0 < x", "x < 1"]', "[0 < x, x < 1]", ""),
    ('["0 < x", "x < 1"]', '"0 < x", "x < 1"', ""),
    ('["x"]', "[x]", ""),
    ('{ x = "1/2" }', "{ x = 1/2 }", ""),
    ('{ x = "1/2" }', '{ x: "1/2" }', ""),
    ('{ x = "1/2" }', '{ x = "1/2"', ""),
    ("[constants]", "[constants", ""),
    ("[constants]", "constants]", ""),
    ("[constants]", "[constants)", ""),
    ("r = 0.05", "r = −.05", "r = -0.05"),
    ("[constants]", "[[constants", ""),
    ("[constants]", "constants:", ""),
    ("[contexts.c]", "[contexts.η]", '[contexts."η"]'),
    ('a = "q < 2"', "a = q < 2", ""),
    ('a = "q < 2"', "q < 2", 'name = "q < 2"'),
    ('a = "q < 2"', "q^2 = 1/4", 'name = "q^2 = 1/4"'),
    ('a = "q < 2"', 'a row = "q < 2"', 'a_row = "q < 2"'),
    ('q = "1/2"', "q := sqrt(2)", 'q = "sqrt(2)"'),
    ('q = "1/2"', "q = max(1/2, min(1, sqrt(2)))", 'q = "max(1/2, min(1, sqrt(2)))"'),
    ('q = "1/2"', '"q": 1/2,', 'q = "1/2"'),
]


@pytest.mark.parametrize(("line", "mistyped", "meant"), MISTYPED)
def test_what_is_proposed_works(line: str, mistyped: str, meant: str) -> None:
    """After each remedy the file is read, or the next mistake of the same file is told."""
    whole = SCENE if line in SCENE else PAGE
    assert line in whole
    text = whole.replace(line, mistyped, 1)
    for _ in range(3):
        text = followed(text, complaint(text))
        if is_toml(text):
            break
    wanted = whole.replace(line, meant or line, 1)
    assert toml_of("f.toml", text.encode(), "")[0] == toml_of("f.toml", wanted.encode(), "")[0]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("r = 1\n\nr = 2\n", "line 3: is not valid TOML (a name stands there twice: r, in line 1"),
        ("[a]\nr = 1\n[b]\nr = 1\nr = 2\n", "line 5: is not valid TOML (a name stands there twice"),
        (
            "[a]\n[b]\n[a]\n",
            "line 3: is not valid TOML (a name stands there twice: [a], in line 1",
        ),
        ('a = 1\nb = """\n\\q\n"""\n', "line 3: is not valid TOML (a backslash)"),
        ("r = 1\r\nx = 1/2\r\n", "line 2: is not valid TOML"),
        ("a = [\n 1,\n x y z\n 2\n]\n", 'write a = [1, "x y z", 2]'),
        ("r =\n", "line 1: is not valid TOML (nothing stands after the =)"),
        ('{"r": 0.05}', "line 1: is not valid TOML (it looks like JSON)"),
        ('a = 1\nb = """\nc\n', 'line 2: is not valid TOML (a text begins with """'),
        ('a = "\\alpha < 1"\n', "TeX is not read"),
        (
            "a = [\n 1,\n 2\n\nb = 3\n",
            "line 1: is not valid TOML (not each [ has its ]); write a = [1, 2]",
        ),
        ("a = [\n 1\n 2\n]\n", "write a = [1, 2]"),
        (
            'b = """\nc = .5\n"""\na = .5\n',
            "line 4: is not valid TOML (a number of TOML looks otherwise)",
        ),
    ],
)
def test_where(text: str, says: str) -> None:
    assert says in complaint(text)


def test_random_damage() -> None:
    """One sign lost, doubled or put in: where a line is proposed, the file is read with it."""
    draw = random.Random(45)
    proposed = told = 0
    for _ in range(1500):
        text = draw.choice((SCENE, PAGE))
        for _ in range(draw.choice((1, 1, 2))):
            at = draw.randrange(len(text))
            text = text[:at] + draw.choice(("", text[at] * 2, *"[]{}\"',;=.# x/%")) + text[at + 1 :]
        for _ in range(6):
            if is_toml(text):
                break
            words = complaint(text)
            told += 1
            if "); write " not in words:
                break
            proposed += 1
            before, text = text, followed(text, words)
            assert before != text, words
        else:
            pytest.fail(text)
    assert proposed > told // 4 > 300


def test_long_texts_are_told_soon() -> None:
    """Neither a long line nor many of them makes a complaint slow; pytest has the time limit."""
    for text in (
        "a = " + "[" * 90 + "1" + " " * 100_000,
        "a = " + "x " * 100_000,
        " " * 100_000 + "[",
        "a.b " * 50_000,
        '"' * 99_999,
        "a = [\n" + "1,\n" * 50_000,
        '"""' * 20_000 + "x",
    ):
        with pytest.raises(InputError):
            toml_of("f.toml", text.encode(), "")
