"""What the checker prints and returns: one line per obligation, assumptions, the last line."""

from __future__ import annotations

import copy
import io
import json
import os
import sys
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import WIDE, files
from verify import check

Document = dict[str, Any]
FOLDER = Path(__file__).parents[2] / "certificates" / "theorem1-r-3-100"


def pair() -> tuple[Document, Document]:
    """Two obligations over a parameter, two constants and two assumptions."""
    row = {"label": "L", "role": "needed", "says": "s", "uses": ["law"], "variables": {}}
    statement = {
        "format": "verify-statement/1",
        "theorem": "T",
        "title": "t",
        "parameters": {"r": "1/3"},
        "constants": [
            {"name": "a", "label": "L-a", "tex": "a", "term": ["mul", "r", "3"]},
            {"name": "b", "label": "L-b", "tex": "b", "term": ["sqrt", ["add", "a", "1"]]},
        ],
        "obligations": [
            {**row, "name": "first", "claim": ["<", "a", "b"]},
            {**row, "name": "second", "claim": ["<", "x", "2"], "variables": {"x": ["0", "1"]}},
        ],
        "assumptions": [
            {"name": "law", "label": "L-law", "sentence": "A law."},
            {"name": "map", "label": "L-map", "sentence": "A map."},
        ],
    }
    certificate = {
        "format": "verify-certificate/1",
        "statement_sha256": "",
        "enclosures": {"a": ["1", "1"], "b": ["1.4142", "1.4143"]},
        "proofs": [
            {"obligation": "first", "rule": "interval", "bits": 64, "lhs": WIDE, "rhs": WIDE},
            {"obligation": "second", "rule": "interval", "bits": 64},
        ],
    }
    return statement, certificate


def bind(statement: Document, certificate: Document) -> tuple[bytes, bytes]:
    first = json.dumps(statement).encode()
    certificate = {**certificate, "statement_sha256": sha256(first).hexdigest()}
    return first, json.dumps(certificate).encode()


def report(edit: Callable[[Document, Document], Any] | None = None) -> list[str]:
    """The lines on the pair after an edit, with ``malformed`` in front of an error."""
    statement, certificate = copy.deepcopy(pair())
    if edit is not None:
        edit(statement, certificate)
    try:
        proved, lines = check.check(*bind(statement, certificate))
    except check.Malformed as error:
        return ["malformed", str(error)]
    assert lines[-1] == ("PROVED" if proved else "NOT PROVED")
    return lines


def test_a_proved_statement() -> None:
    assert report() == [
        "proved  first [L] lhs < rhs",
        "proved  second [L] lhs < rhs for all x",
        "assumed L-law: A law.",
        "assumed L-map: A map.",
        "PROVED",
    ]


def test_one_failure_does_not_hide_another() -> None:
    def edit(statement: Document, _: Document) -> None:
        statement["obligations"][0]["claim"] = ["<", "b", "a"]
        statement["obligations"][1]["claim"] = ["not", ["=", "2", "2"]]
        statement["obligations"][1]["variables"] = {"x": ["0", "1"], "y": ["0", "1"]}

    first, second, *_, last = report(edit)
    assert first == (
        "REFUSED first [L] lhs < rhs: found [141421356237309504876e-20, 141421356237309504882e-20]"
        " and [100000000000000000000e-20, 100000000000000000000e-20], expected < between them"
    )
    assert second == (
        "REFUSED second [L] not (lhs = rhs for all x, y): "
        "found interval, expected witness for not-for-all, and only for that"
    )
    assert last == "NOT PROVED"


@pytest.mark.parametrize(
    ("role", "claim", "line"),
    [
        ("printed", ["not", ["<", "b", "a"]], "proved  first [L] not (lhs < rhs)"),
        ("needed", ["not", ["<", "b", "a"]],
         "REFUSED first [L] not (lhs < rhs): the negation is proved, but the row is needed"),
        ("needed", ["not", ["not", ["<", "a", "b"]]], "proved  first [L] lhs < rhs"),
    ],
)  # fmt: skip
def test_a_needed_row_must_not_be_refuted(role: str, claim: Any, line: str) -> None:
    def edit(statement: Document, _: Document) -> None:
        statement["obligations"][0] |= {"role": role, "claim": claim}

    lines = report(edit)
    assert lines[0] == line
    assert lines[-1] == ("PROVED" if line.startswith("proved") else "NOT PROVED")


@pytest.mark.parametrize(
    ("ends", "good"),
    [(["1.4142", "1.4143"], True), (["1.4143", "1.4144"], False), (["1.4141", "1.4142"], False),
     (["1", "2"], True), (["-1", "1.41421356237309504881"], True),
     (["-1", "1.4142135623730950488"], False),
     (["1.41421356237309504881", "1e5"], False), (["1.4142135623730950488", "1e5"], True)],
)  # fmt: skip
def test_enclosures_of_constants_are_compared(ends: list[str], good: bool) -> None:
    lines = report(lambda _, certificate: certificate["enclosures"].update(b=ends))
    if good:
        assert lines[-1] == "PROVED"
    else:
        assert lines[2].startswith("REFUSED constant b [L-b]: found [")
        assert "expected [141421356237309504880" in lines[2]
        assert lines[-1] == "NOT PROVED"


def test_a_constant_without_value_is_refused() -> None:
    def edit(statement: Document, certificate: Document) -> None:
        term = ["div", "1", ["sub", "a", "1"]]
        statement["constants"].append({"name": "c", "label": "L-c", "tex": "c", "term": term})
        certificate["enclosures"]["c"] = ["0", "0"]

    line = report(edit)[2]
    assert line.startswith("REFUSED constant c [L-c]: found a division by [0e-")


def put(*path: Any, value: Any, where: int = 0) -> Callable[[Document, Document], None]:
    """An edit of the statement, or of the certificate."""

    def edit(*documents: Document) -> None:
        target: Any = documents[where]
        for key in path[:-1]:
            target = target[key]
        target[path[-1]] = value

    return edit


CLAIM = ("obligations", 0, "claim")


@pytest.mark.parametrize(
    ("edit", "error"),
    [
        (put("format", value="verify-statement/2"),
         "statement: format: found verify-statement/2, expected verify-statement/1"),
        (put("format", value="verify-certificate/2", where=1), "certificate: format: found"),
        (put("extra", value=1), "statement: found ['format',"),
        (put("title", value=None), "statement: title: found None, expected (?s).*"),
        (put("theorem", value=["T"]), "statement: theorem: found ['T'], expected"),
        (put("obligations", value=[]), "obligations: found none, which proves nothing"),
        (put("obligations", value={}), "statement: obligations: found [], expected [{"),
        (put("obligations", 0, "role", value="wanted"),
         "statement: obligations: 0: role: found wanted, expected needed|printed"),
        (put("obligations", 0, "role", value="needed "), "role: found needed , expected"),
        (put("obligations", 0, "extra", value=0), "statement: obligations: 0: found ["),
        (put("obligations", 0, value="first"), "statement: obligations: 0: found first"),
        (put("obligations", 0, "uses", value=["nothing"]),
         "obligation first: uses: found {'nothing'}, which no assumption has"),
        (put("obligations", 0, "uses", value="law"), "obligations: 0: uses: found law"),
        (put("obligations", 1, "name", value="first"),
         "obligations: found a name twice in ['first', 'first']"),
        (put("obligations", 1, "name", value="other"),
         "proofs: found and expected are [('second', 'other')]"),
        (put("assumptions", 1, "name", value="law"), "assumptions: found a name twice in"),
        (put("assumptions", value=[]), "obligation first: uses: found {'law'}"),
        (put("parameters", value={"r": "x"}), "parameter r: found x, expected -?(0|"),
        (put("parameters", value={"1": "2"}), "name: found 1, expected [A-Za-z]"),
        (put("parameters", value={"a": "2"}), "constant a: found r, expected"),
        (put("parameters", value={"r": "1", "a": "2"}), "found the name a, which is in use"),
        (put("constants", 1, "name", value="a"), "found the name a, which is in use"),
        (put("constants", 0, "term", value="b"), "constant a: found b, expected -?(0|"),
        (put("constants", 0, "term", value="a"), "constant a: found a, expected -?(0|"),
        (put("constants", 0, "term", value=3), "constant a: found 3, expected a term"),
        (put("constants", 0, "term", value=[]), "constant a: found [], expected a term"),
        (put("constants", 0, "term", value=None), "constant a: found None, expected a term"),
        (put("constants", 0, "term", value=["mul", "1"]), "found ['mul', '1'], expected a term"),
        (put("constants", 0, "term", value=["neg", "1", "2"]), "found ['neg', '1', '2'], exp"),
        (put("constants", 0, "term", value=["min", "1"]), "found ['min', '1'], expected a term"),
        (put("constants", 0, "term", value=["max"]), "found ['max'], expected a term"),
        (put("constants", 0, "term", value=["min"]), "found ['min'], expected a term"),
        (put("constants", 0, "term", value=["exp", "1"]), "found ['exp', '1'], expected a term"),
        (put("constants", 0, "term", value=[["neg"], "1"]), "found [['neg'], '1'], expected"),
        (put("constants", 0, "term", value=["rational", "1", "2"]), "expected a term"),
        (put("constants", 0, "term", value=["symbol"]), "found ['symbol'], expected a term"),
        (put("constants", 0, "term", value=["pow", "2"]), "constant a: found ['2'], expected"),
        (put("constants", 0, "term", value=["pow", "2", "0"]), "constant a: 1: found 0, exp"),
        (put("constants", 0, "term", value=["pow", "2", "-1"]), "1: found -1, expected [1-9]"),
        (put("constants", 0, "term", value=["pow", "2", "1000"]), "1: found 1000, expected"),
        (put("constants", 0, "term", value=["pow", "2", 2]), "1: found 2, expected [1-9]"),
        (put("constants", 0, "term", value=["pow", "2", "r"]), "1: found r, expected [1-9]"),
        (put("constants", 0, "term", value=["pow", "x", "2"]), "constant a: found x, expected"),
        (put("constants", 0, "term", value="1/0"), "constant a: found 1/0, expected -?(0|"),
        (put("constants", 0, "term", value="01"), "constant a: found 01, expected -?(0|"),
        (put("constants", 0, "term", value="1_0"), "constant a: found 1_0, expected -?(0|"),
        (put("constants", 0, "term", value="+1"), "constant a: found +1, expected -?(0|"),
        (put("constants", 0, "term", value="0.5"), "constant a: found 0.5, expected -?(0|"),
        (put("constants", 0, "term", value="1e5"), "constant a: found 1e5, expected -?(0|"),
        (put("constants", 0, "term", value=" 1"), "constant a: found  1, expected -?(0|"),
        (put("constants", 0, "term", value="1\n"), "constant a: found '1\\n', expected -?(0|"),
        (put("constants", 0, "term", value="٣"), "constant a: found ٣, expected -?(0|"),
        (put("constants", 0, "term", value="1" * 4301), "(4301 characters), expected"),
        (put(*CLAIM, value="a"), "obligation first: claim: found a, expected"),
        (put(*CLAIM, value=["<", "a"]), "obligation first: claim: found ['<', 'a'], expected"),
        (put(*CLAIM, value=["<", "a", "b", "b"]), "obligation first: claim: found ['<', 'a', 'b'"),
        (put(*CLAIM, value=[">", "a", "b"]),
         "obligation first: claim: 0: found >, expected <|<=|="),
        (put(*CLAIM, value=["!=", "a", "b"]), "obligation first: claim: 0: found !=, expected"),
        (put(*CLAIM, value=["not", "a"]), "obligation first: claim: found a, expected"),
        (put(*CLAIM, value=["not"]), "obligation first: claim: found ['not'], expected"),
        (put(*CLAIM, value=["not", ["<", "a", "b"], "b"]), "claim: 0: found not, expected <|<=|="),
        (put(*CLAIM, value=["<", "a", "x"]), "obligation first: rhs: found x, expected -?(0|"),
        (put(*CLAIM, value=["<", "x", "a"]), "obligation first: lhs: found x, expected -?(0|"),
        (put("obligations", 1, "variables", value={"x": ["1", "1"]}),
         "obligation second: found the variable x between ['1', '1']"),
        (put("obligations", 1, "variables", value={"x": ["2", "1"]}), "between ['2', '1']"),
        (put("obligations", 1, "variables", value={"a": ["0", "1"]}),
         "obligation second: found the name a, which is in use"),
        (put("obligations", 1, "variables", value={"r": ["0", "1"]}), "found the name r, which"),
        (put("obligations", 1, "variables", value={"2": ["0", "1"]}), "name: found 2, expected"),
        (put("obligations", 1, "variables", value={"x": ["0"]}), "variables: x: found ['0'], exp"),
        (put("obligations", 1, "variables", value={"x": ["0", "1", "2"]}), "variables: x: found"),
        (put("obligations", 1, "variables", value={"x": [0, "1"]}), "x: 0: found 0, expected"),
        (put("obligations", 1, "variables", value={"x": ["0", "0.5"]}), "x: 1: found 0.5, exp"),
        (put("obligations", 1, "variables", value=[]), "1: variables: found [], expected {'any'"),
        (put("statement_sha256", value="0" * 64, where=1), None),
        (put("proofs", value=[], where=1), "proofs: found and expected are [(None, 'first')"),
        (put("proofs", 1, value=None, where=1), "proofs: found and expected are [(None, 'second')"),
        (put("proofs", 1, "obligation", value="first", where=1), "are [('first', 'second')]"),
        (put("proofs", 1, "rule", value="guess", where=1),
         "obligation second: rule: found guess, expected one of ['interval', 'exact', 'rewrite'"),
        (put("proofs", 1, "rule", value=["exact"], where=1), "rule: found ['exact'], expected one"),
        (put("proofs", 1, "lhs", value=["0", "1"], where=1), "obligation second: proof: found ["),
        (put("proofs", 1, "steps", value=[], where=1), "obligation second: proof: found ["),
        (put("proofs", 0, "lhs", value=["0"], where=1), "proof: lhs: found ['0'], expected ("),
        (put("proofs", 0, "lhs", value=["1", "0"], where=1),
         "obligation first: found the enclosure ['1', '0'], whose ends are in no order"),
        (put("proofs", 0, "lhs", value=["0", "NaN"], where=1), "lhs: 1: found NaN, expected"),
        (put("proofs", 0, "lhs", value=["0", "1e"], where=1), "lhs: 1: found 1e, expected"),
        (put("proofs", 0, "lhs", value=["0", "1e100000"], where=1), "1: found 1e100000, expected"),
        (put("proofs", 0, "lhs", value=["0", "1/2"], where=1), "1: found 1/2, expected"),
        (put("proofs", 0, "bits", value=1, where=1), "bits: found 1, expected range(2, 65537)"),
        (put("proofs", 0, "bits", value=65537, where=1), "bits: found 65537, expected range"),
        (put("proofs", 0, "bits", value="64", where=1), "bits: found 64, expected range"),
        (put("proofs", 0, "bits", value=True, where=1), "bits: found True, expected range"),
        (put("proofs", 0, "bits", value=None, where=1), "bits: found None, expected range"),
        (put("enclosures", value={}, where=1),
         "enclosures: found too many or too few names: ['a', 'b']"),
        (put("enclosures", "c", value=["0", "1"], where=1), "too many or too few names: ['c']"),
        (put("enclosures", "r", value=["0", "1"], where=1), "too many or too few names: ['r']"),
        (put("enclosures", "a", value="1", where=1), "enclosures: a: found 1, expected ("),
    ],
)  # fmt: skip
def test_malformed_files_say_where(
    edit: Callable[[Document, Document], None], error: str | None
) -> None:
    lines = report(edit)
    if error is None:  # the digest is made anew by `bind`
        assert lines[-1] == "PROVED"
    else:
        assert lines[0] == "malformed"
        assert error in lines[1]


@pytest.mark.parametrize("key", [*pair()[0]])
def test_every_key_of_the_statement_is_needed(key: str) -> None:
    lines = report(lambda statement, _: statement.pop(key))
    assert lines[0] == "malformed"
    assert lines[1].startswith("statement: found [")


def test_the_limits_are_allowed() -> None:
    def edit(statement: Document, certificate: Document) -> None:
        statement["constants"][0]["term"] = ["pow", ["div", "1" * 4300, "1" * 4300], "999"]
        certificate["proofs"][0]["bits"] = 65536
        certificate["proofs"][1]["bits"] = 2
        certificate["enclosures"]["a"] = ["1e-99999", f"{'9' * 100}.{'9' * 99}e99999"]

    assert report(edit)[-1] == "PROVED"


def nested(levels: int) -> Any:
    term: Any = "1"
    for _ in range(levels):
        term = ["neg", term]
    return term


def test_deep_terms() -> None:
    """A file may nest 100 brackets; a term with the definitions in it has 200 levels at most."""
    assert report(put("constants", 0, "term", value=nested(97)))[0] != "malformed"
    found = report(put("constants", 0, "term", value=nested(98)))
    assert "more than 100 inside each other" in found[1]

    def chain(length: int) -> Callable[[Document, Document], None]:
        def edit(statement: Document, certificate: Document) -> None:
            for i in range(length):
                term = f"k{i - 1}" if i else "1"
                item = {"name": f"k{i}", "label": "L", "tex": "k", "term": term}
                statement["constants"].append(item)
                certificate["enclosures"][f"k{i}"] = ["1", "1"]

        return edit

    assert report(chain(199))[-1] == "PROVED"
    assert "more than 200 levels" in report(chain(200))[1]


def test_a_forged_digest() -> None:
    first, second = bind(*pair())
    changed = first.replace(b'"1/3"', b'"1/4"')
    with pytest.raises(check.Malformed, match=r"statement_sha256: found .*, expected "):
        check.check(changed, second)
    with pytest.raises(check.Malformed, match="statement_sha256"):
        check.check(first + b"\n", second)


@pytest.mark.parametrize(
    ("text", "error"),
    [
        (b"", "Expecting value"),
        (b"{", "without partner"),
        (b"[[]", "without partner"),
        (b"}{", "without partner"),
        (b"[}", "Expecting value"),
        (b"{} x", "Extra data"),
        (b"\xff", "codec can't decode"),
        (b"\xef\xbb\xbf{}", "BOM"),
        (b"NaN", "found NaN, expected numbers as texts"),
        (b"-Infinity", "found -Infinity, expected numbers as texts"),
        (b"1.5", "found 1.5, expected numbers as texts"),
        (b"1e5", "found 1e5, expected numbers as texts"),
        (b"-1", "found -1, expected numbers as texts"),
        (b"-0", "found -0, expected numbers as texts"),
        (b"1000000000", "found 1000000000, expected numbers as texts"),
        (b"9" * 100_000, "(100000 characters), expected numbers as texts"),
        (b'{"a": 1, "a": 1}', "found a key twice: [('a', 1), ('a', 1)]"),
        (b'[{"a": {"b": 1, "b": 2}}]', "found a key twice: [('b', 1), ('b', 2)]"),
        (b'["\x00"]', "Invalid control character"),
        (b"[" * 101 + b"]" * 101, "more than 100 inside each other"),
        (b'{"a":' * 101 + b"1" + b"}" * 101, "more than 100 inside each other"),
        (b"[" * 100_000, "more than 100 inside each other"),
    ],
)
def test_what_is_no_document(text: bytes, error: str) -> None:
    with pytest.raises(check.Malformed) as caught:
        check.parse("file", text, None)  # type: ignore[arg-type]
    assert str(caught.value).startswith("file: ")
    assert error in str(caught.value)


@pytest.mark.parametrize(
    "text",
    [
        b"[" * 100 + b"]" * 100,
        b'["[[[", "]", "\\"[", "\\\\", "{", "\\u005b[", ""]',
        b'["\\\\\\"]]]]"]',
        b'{"": [{"[": "}"}, {}]}',
        b" [ 0 , 999999999 ] ",
    ],
)
def test_brackets_in_texts_do_not_count(text: bytes) -> None:
    assert check.parse("file", text, None) == json.loads(text)  # type: ignore[arg-type]


def test_long_files(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(check, "MAX_BYTES", 10)
    assert check.parse("file", b"[" + b" " * 8 + b"]", None) == []  # type: ignore[arg-type]
    with pytest.raises(check.Malformed, match="file: found more than 10 bytes"):
        check.parse("file", b"[" + b" " * 9 + b"]", None)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("a text", "a text"),
        ("two\nlines", r"'two\nlines'"),
        (None, "None"),
        ([1, "é"], r"[1, '\xe9']"),
        ("x" * 199, "x" * 199),
        ("x" * 200, "x" * 160 + "... (200 characters)"),
        ((check.Fraction(1, 3), check.Fraction(1, 3)),
         "[333333333333333333333e-21, 333333333333333333334e-21]"),
        ((check.Fraction(-1, 3), check.Fraction(0)), "[-333333333333333333334e-21, 0e-21]"),
        ((check.Fraction(0), check.Fraction(0)), "[0e-21, 0e-21]"),
        ((check.Fraction(10**30), check.Fraction(10**30)),
         "[1000000000000000000000e9, 1000000000000000000000e9]"),
        ((check.Fraction(1, 10**9000), check.Fraction(1)),
         "[0e-20, 100000000000000000000e-20]"),
    ],
)  # fmt: skip
def test_values_in_messages(value: object, text: str | None) -> None:
    found = check.shown(value)
    assert found == text if text is not None else len(found) < 80


def write(folder: Path, contents: tuple[bytes, bytes]) -> str:
    (folder / "statement.json").write_bytes(contents[0])
    (folder / "certificate.json").write_bytes(contents[1])
    return str(folder)


def test_exit_codes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = write(tmp_path, bind(*pair()))
    assert check.main([folder]) == 0
    assert capsys.readouterr().out.splitlines() == report()
    assert check.main([f"{folder}/statement.json", f"{folder}/certificate.json"]) == 0
    capsys.readouterr()
    assert check.main([f"{folder}/certificate.json", f"{folder}/statement.json"]) == 4
    out, err = capsys.readouterr()
    assert out.startswith("malformed: statement: found [")
    assert out.endswith("\nNOT PROVED\n")
    assert not err
    write(tmp_path, files(["<", "2", "1"], "exact"))
    assert check.main([folder]) == 1
    assert capsys.readouterr().out.splitlines()[-1] == "NOT PROVED"


@pytest.mark.parametrize(
    "words", [[], ["a", "b", "c"], ["nowhere"], [".", "."], ["nowhere", "nowhere"], ["a\0b"]]
)
def test_unusable_command_lines(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert check.main(words) == 2
    out, err = capsys.readouterr()
    assert not out
    assert err.startswith("check: ")
    assert len(err.splitlines()) == 1


def test_too_long_a_file_is_not_read_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(check, "MAX_BYTES", len(bind(*pair())[0]))
    assert check.main([write(tmp_path, bind(*pair()))]) == 0
    monkeypatch.setattr(check, "MAX_BYTES", len(bind(*pair())[0]) - 1)
    assert check.main([write(tmp_path, bind(*pair()))]) == 4
    assert "malformed: statement: found more than" in capsys.readouterr().out
    first, second = bind(*pair())
    monkeypatch.setattr(check, "MAX_BYTES", len(first))
    assert check.main([write(tmp_path, (first, second + b" " * len(first)))]) == 4
    assert "malformed: certificate: found more than" in capsys.readouterr().out
    seen: list[int] = []
    monkeypatch.setattr(check, "MAX_BYTES", 1000)
    monkeypatch.setattr(check, "check", lambda *files: (seen.extend(map(len, files)), [""]))
    check.main([write(tmp_path, (b" " * 5000, b" " * 5000))])
    assert seen == [1001, 1001]


def test_texts_cannot_forge_lines(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    statement, certificate = pair()
    statement["obligations"][0]["label"] = "x\nPROVED\n\x1b[2J\u202e\ud800"
    statement["assumptions"][0]["sentence"] = "é\r"
    assert check.main([write(tmp_path, bind(statement, certificate))]) == 0
    lines = capsys.readouterr().out.split("\n")
    assert lines[0] == r"'proved  first [x\nPROVED\n\x1b[2J\u202e\ud800] lhs < rhs'"
    assert lines[2] == r"'assumed L-law: \xe9\r'"
    assert len(lines) == 6


def test_output_in_any_encoding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    statement, certificate = pair()
    statement["assumptions"][0]["sentence"] = "0 < η"
    folder = write(tmp_path, bind(statement, certificate))
    path = tmp_path / "out"
    for encoding, expected in (
        ("ascii", rb"L-law: 0 < \u03b7"),
        ("utf-8", "L-law: 0 < η".encode()),
    ):
        with path.open("w", encoding=encoding) as file:
            monkeypatch.setattr(sys, "stdout", file)
            assert check.main([folder]) == 0
            monkeypatch.undo()
        assert expected in path.read_bytes()


def test_output_without_encoding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    statement, certificate = pair()
    statement["assumptions"][0]["sentence"] = "0 < η"
    out = io.StringIO()
    monkeypatch.setattr(sys, "stdout", out)
    assert check.main([write(tmp_path, bind(statement, certificate))]) == 0
    assert r"0 < \u03b7" in out.getvalue()


class ClosedPipe(io.StringIO):
    """A standard output whose reader has left, over a real file."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number

    def fileno(self) -> int:
        return self.number

    def flush(self) -> None:
        raise BrokenPipeError


def test_a_reader_may_leave(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = write(tmp_path, bind(*pair()))
    with (tmp_path / "out").open("w") as file:
        monkeypatch.setattr(sys, "stdout", ClosedPipe(file.fileno()))
        assert check.main([folder]) == 0
        monkeypatch.undo()
        os.write(file.fileno(), b"lost")
    assert (tmp_path / "out").read_bytes() == b""


def test_an_interrupt_is_quiet(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(check, "check", interrupt)
    assert check.main([str(FOLDER)]) == 130
    assert capsys.readouterr() == ("", "check: interrupted\n")


def test_the_budget_is_one_for_all(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(check, "MAX_WORK", 60)
    lines = report()
    assert [line.split(":")[0] for line in lines if line.startswith("REFUSED")]
    assert lines[-1] == "NOT PROVED"


def test_polynomials_cost_work(monkeypatch: pytest.MonkeyPatch) -> None:
    """What a product costs grows with its terms, with their lengths and with their numbers."""
    costs = []
    for base, n in (("x", 2), ("x", 100), (["add", "x", "1"], 30), (["mul", "9" * 1000, "x"], 30)):
        terms = check.Terms()
        terms.define("x")
        terms.scope(64, {}).expand(terms.read("term", ["pow", base, str(n)]))
        costs.append(check.MAX_WORK - terms.work)
    assert costs[0] < 200
    assert 20 * 1000 < costs[1] < 60 * 1000
    assert 20 * 1000 < costs[2] < 200 * 1000
    assert costs[3] > 5 * costs[1]
    monkeypatch.setattr(check, "MAX_WORK", 10_000)
    edit = put("obligations", 1, "claim", value=["=", ["pow", ["add", "x", "1"], "99"], "x"])

    def both(statement: Document, certificate: Document) -> None:
        edit(statement, certificate)
        certificate["proofs"][1] |= {"rule": "rewrite", "steps": [], "closing": "identity"}

    assert "found too much work" in report(both)[1]


@pytest.mark.parametrize(
    ("bits", "times", "left"), [(0, 1, 96), (0, 3, 88), (1024, 1, 95), (2048, 2, 84), (1023, 1, 96)]
)
def test_spending(bits: int, times: int, left: int) -> None:
    terms = check.Terms()
    terms.work = 100
    terms.spend(bits, times)
    assert terms.work == left


def test_the_committed_certificate_at_a_few_budgets() -> None:
    contents = [(FOLDER / f"{name}.json").read_bytes() for name in ("statement", "certificate")]
    proved, lines = check.check(*contents)
    assert proved
    rows = json.loads(contents[0])["obligations"]
    assert len([line for line in lines if line.startswith("proved  ")]) == len(rows)
    assert not [line for line in lines if line.startswith("REFUSED")]
