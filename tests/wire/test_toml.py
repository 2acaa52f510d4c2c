"""TOML: what would take its reader long is refused before, and nothing else is."""

from __future__ import annotations

import random
import time
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from verify.cli import main
from verify.wire.inputs import InputError
from verify.wire.text.read_page import read_page
from verify.wire.toml import MAX_PARTS, MAX_WORD, toml_of

#: Each with what its message names.
LONG = {
    "an-integer": ("r = " + "1" * 1_000_000, "line 1: a number"),
    "an-integer-with-signs": ("r = " + "1_" * 500_000 + "1", "line 1: a number"),
    "a-float": ("a = 1\nr = 1." + "1" * 1_000_000, "line 2: a number"),
    "a-hexadecimal": ("r = 0x" + "f" * 1_000_000, "line 1: a number"),
    "a-key": ("a" * 10_000 + " = 1", "a name"),
    "a-dotted-key": ("r='0.03'\n" + "a." * 20_000 + "a = 1", "line 2: a key"),
    "a-dotted-key-with-spaces": ("a . " * 20_000 + "a = 1", "line 1: a key"),
    "a-quoted-dotted-key": ("\"a\".'b'." * 20_000 + "a = 1", "line 1: a key"),
    "a-header": ("[" + "a." * 20_000 + "a]", "line 1: a key"),
    "a-key-in-a-table": ("t = {" + "a." * 20_000 + "a = 1}", "line 1: a key"),
    "a-key-after-a-long-text": (
        't = """\n\\""" \n""""\n' + "a." * 20_000 + "a = 1",
        "line 4: a key",
    ),
    "brackets": ("r = " + "[" * 50_000, "deep"),
    "tables": ("r = " + "{a=" * 50_000, "deep"),
}


@pytest.mark.parametrize("name", LONG)
def test_what_is_too_long(name: str) -> None:
    text, where = LONG[name]
    begin = time.process_time()
    with pytest.raises(InputError, match=where):
        toml_of("f.toml", text.encode(), "")
    assert time.process_time() - begin < 1


#: Texts of about 100 kB in which something is repeated.
REPEATED = {
    "quotes": 'x = "' + '\\"' * 49_000,
    "three-quotes": 'x = """' + '\\"""' * 24_000,
    "spaces": "x = [\n[a" + " " * 95_000 + ",",
    "spaces-after-a-word": "x = [\ny" + " " * 95_000 + ",",
    "a-header": "[a" + " " * 90_000 + "\nx=",
    "a-text-and-lines": 'x = "' + '\\"' * 3000 + "\n" + ('"' + '\\"' * 1900 + "\n") * 20,
}


@pytest.mark.parametrize("name", REPEATED)
def test_what_is_no_toml_is_told_at_once(name: str) -> None:
    begin = time.process_time()
    with pytest.raises(InputError, match="line"):
        toml_of("f.toml", REPEATED[name].encode(), "")
    assert time.process_time() - begin < 1


def test_many_spaces_are_read_at_once() -> None:
    begin = time.process_time()
    assert toml_of("f.toml", b"x = [1," + b" " * 95_000 + b"2]", "")[0] == {"x": [1, 2]}
    assert time.process_time() - begin < 1


@pytest.mark.parametrize("command", ["prove", "scene"])
def test_a_file_is_refused_in_one_line(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "long.toml"
    path.write_text(LONG["a-dotted-key"][0])
    assert main([command, str(path)]) == 2
    out, err = capsys.readouterr()
    assert (out, err.count("\n")) == ("", 1)
    assert "line 2: a key has more than 100 parts" in err


@pytest.mark.parametrize(
    "text",
    [
        "r = " + "1" * MAX_WORD,
        ".".join(["a"] * MAX_PARTS) + " = 1",
        's = "' + "a." * 5000 + "[" * 5000 + "x" * 5000 + '"',
        "s = '''\n" + "a." * 5000 + "[" * 5000 + "\\'''",
        's = """\n' + "a." * 5000 + '\\"""' + "x" * 5000 + '"""',
        "# " + "a." * 5000 + "[" * 5000,
        "r = " + "[" * 99 + "]" * 99,
    ],
)
def test_what_is_not_too_long(text: str) -> None:
    """What stands in texts and comments is not meant."""
    assert toml_of("f.toml", text.encode(), "")[0] == tomllib.loads(text, parse_float=str)


def python(text: str) -> Any:
    return tomllib.loads(text, parse_float=str)


def ours(text: str) -> Any:
    return toml_of("f.toml", text.encode(), "")[0]


def answer(reader: Callable[[str], Any], text: str) -> Any:
    try:
        return reader(text)
    except ValueError:
        return None


def test_random_files_are_read_as_by_python() -> None:
    draw = random.Random(5)
    parts = (
        "'",
        '"',
        '"""',
        "'''",
        "\\",
        "a",
        ".",
        "=",
        "1",
        "\n",
        "#",
        "[",
        "]",
        "{",
        "}",
        " ",
        ",",
    )
    read = 0
    for _ in range(20_000):
        text = "a = " * draw.randint(0, 1) + "".join(draw.choices(parts, k=draw.randint(1, 12)))
        expected, found = (answer(reader, text) for reader in (python, ours))
        assert found == expected, text
        read += expected is not None
    assert read > 500


@pytest.mark.parametrize(
    "name", ["page.toml", "scene.toml", "statement.json", "q.smt2", "q.fpcore"]
)
def test_a_byte_order_mark_is_skipped(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    root = Path(__file__).resolve().parents[2]
    text = {
        "page.toml": "title = 't'\n[rows]\na = '0 <= 1'\n",
        "scene.toml": (root / "certificates/scenes/passing.toml").read_text(),
        "statement.json": (root / "certificates/line/statement.json").read_text(),
        "q.smt2": "(declare-fun x () Real)(assert (< (* x x) 0))(check-sat)\n",
        "q.fpcore": "(FPCore (x) :pre (<= 1 x 2) (+ x 1))\n",
    }[name]
    command = "scene" if name == "scene.toml" else "prove"
    found = []
    for mark in ("", "\ufeff"):
        path = tmp_path / name
        path.write_text(mark + text, encoding="utf-8")
        found.append((main([command, str(path)]), *capsys.readouterr()))
    assert found[0] == found[1]
    assert found[0][0] == (3 if name == "statement.json" else 0)


CHAPTERS = """title = "t"
[constants]
k = "1"
[contexts.c]
variables = ["x"]
point = { x = "1" }
given = { g = "0 < x" }
[contexts.ro]
variables = ["rho"]
root = "rho^2 - 2"
between = [1, 2]
[contexts.d]
in = "c"
variables = ["y"]
given = ["0 < y"]
[[chapters]]
[chapters.rows]
n = { lemma = "k < 2", rule = "interval" }
m = { claim = "k < 3", rule = "entry", of = "n", side = "lhs" }
[[chapters]]
in = "c"
[chapters.rows]
i = { instance = "g", at = { x = "2" }, by = "g" }
s = { claim = "g at point", by = "g" }
"""


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('in = "c"\nvar', 'in = ["c"]\nvar'),
        ('in = "c"\n[ch', "in = []\n[ch"),
        ('variables = ["x"]\npoint = { x = "1" }', "point = 3"),
        ('variables = ["x"]\npoint = { x = "1" }', 'point = "x = 1"'),
        ("between = [1, 2]", f"between = [1, 1{'0' * 400}]"),
        ("between = [1, 2]", 'between = [1, 2]\nstates = { s = { rho = "1" } }'),
        ("between = [1, 2]", 'between = [1, 2]\nby = "g"'),
        ('instance = "g"', 'instance = "n"'),
        ('instance = "g", at = { x = "2" }', 'instance = "n", at = "point"'),
        ('of = "n"', 'of = ["n"]'),
        ('of = "n"', 'of = "nn"'),
        ('side = "lhs"', 'side = "left"'),
        ('claim = "g at point"', 'claim = "ro.1 at point"'),
        ('claim = "g at point"', 'claim = "g at nowhere"'),
        ('rule = "interval"', 'false_at = "point"'),
    ],
)
def test_what_has_another_type_or_no_such_place_is_refused(old: str, new: str) -> None:
    assert old in CHAPTERS
    assert read_page("a.toml", CHAPTERS.encode()).chapters
    with pytest.raises(InputError, match=r"^a\.toml"):
        read_page("a.toml", CHAPTERS.replace(old, new).encode())


SHADOWS = """title = "t"
[let]
a = "3"
[constants]
b = "5"
[contexts.c]
variables = ["x"]
given = ["0 <= x <= 1"]
let = { s = "x + 1" }
[contexts.c.constants]
z = "x"
[rows]
row = "x <= 1"
"""


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('a = "3"', 'b = "3"'),
        ('s = "x + 1"', 'x = "x + 1"'),
        ('s = "x + 1"', 'z = "x + 1"'),
        ('row = "x <= 1"', 'row = "x <= 1"\n[[chapters]]\nlet = { b = "1" }'),
        ('row = "x <= 1"', 'row = "x <= 1"\n[[chapters]]\nin = "c"\nlet = { s = "1" }'),
        ('row = "x <= 1"', 'row = "a <= 1"\n[contexts.d]\nvariables = ["a"]\ngiven = ["a < 1"]'),
    ],
)
def test_a_name_has_one_meaning_in_one_place(old: str, new: str) -> None:
    """A name of a let was read in its place, and printed as the constant or variable."""
    assert read_page("a.toml", SHADOWS.encode()).statement
    with pytest.raises(InputError, match=r"^a\.toml, line"):
        read_page("a.toml", SHADOWS.replace(old, new).encode())
