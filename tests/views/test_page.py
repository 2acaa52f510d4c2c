"""The page says what the certificates say, and nothing else."""

from __future__ import annotations

import json
import os
import re
import shutil
from collections import Counter
from fractions import Fraction
from html.parser import HTMLParser
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from tests.cli.running import command, validator
from tests.views.conftest import TABLE, build, pages_of
from verify.paper.commands.citing import step_cited
from verify.paper.commands.report import NAMES
from verify.publication import ACCUSATIONS
from verify.views.page.build import joined
from verify.views.typesetting import prose

MAIN = "theorem1-r-3-100"
VOID = {"meta", "link", "br", "wbr", "img", "hr", "input"}
#: What a paragraph cannot contain: the parser of a browser closes it there.
BLOCKS = {"details", "div", "p", "ul", "table", "figure", "article", "section", "dl", "pre", "h3"}


class Reader(HTMLParser):
    """Checks nesting and collects ids, references, and the values of `data`."""

    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.open: list[str] = []
        self.ids: list[str] = []
        self.references: list[str] = []
        self.values: list[str] = []
        self.tags: Counter[str] = Counter()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags[tag] += 1
        assert not (tag in BLOCKS and "p" in self.open), f"<{tag}> inside of <p>"
        for name, value in attrs:
            if name == "id":
                self.ids.append(str(value))
            if name in ("href", "src", "xlink:href"):
                self.references.append(str(value))
            if name == "value" and tag == "data":
                self.values.append(str(value))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open, f"</{tag}> closes nothing"
        assert self.open.pop() == tag, f"</{tag}> closes another element"


def read(text: str) -> Reader:
    result = Reader()
    result.feed(text)
    result.close()
    return result


@pytest.fixture(scope="module")
def readers(made: Path) -> dict[str, Reader]:
    return {name: read(text) for name, text in pages_of(made).items()}


@pytest.fixture(scope="module")
def values(readers: dict[str, Reader]) -> set[str]:
    return {value for reader in readers.values() for value in reader.values}


def documents(made: Path, folder: str = MAIN) -> tuple[dict[str, Any], dict[str, Any]]:
    statement, certificate = (
        json.loads((made / folder / name).read_text(encoding="utf-8")) for name in NAMES
    )
    return statement, certificate


def test_each_page_is_well_formed(readers: dict[str, Reader]) -> None:
    for name, reader in readers.items():
        assert reader.open == [], name
        assert [one for one, times in Counter(reader.ids).items() if times > 1] == [], name
        assert reader.tags["h1"] == 1, name


def test_the_pages_need_nothing_but_themselves(
    page: str, readers: dict[str, Reader], made: Path
) -> None:
    for name, reader in readers.items():
        assert reader.tags["script"] == 0
        for reference in reader.references:
            if reference == "data:,":
                continue
            assert not re.match(r"[a-z]+:|//", reference), reference
            target, _, place = reference.partition("#")
            path = os.path.normpath(os.path.join(os.path.dirname(name), target)) if target else name
            assert (made / path).is_file(), (name, reference)
            if place:
                assert place in readers[path].ids, (name, reference)
    style = (made / "pages/style.css").read_text(encoding="utf-8")
    addresses = set(re.findall(r"https?://[^\"'<> ]*", page + style))
    assert addresses <= {"http://www.w3.org/2000/svg", "http://www.w3.org/1999/xlink"}


def test_each_page_is_small_and_is_reached_from_the_first(
    made: Path, readers: dict[str, Reader]
) -> None:
    for name in readers:
        assert (made / name).stat().st_size <= 300_000, name
    reached, new = set(), {"index.html"}
    while new:
        reached |= new
        found = {
            os.path.normpath(os.path.join(os.path.dirname(name), reference.partition("#")[0]))
            for name in new
            for reference in readers[name].references
        }
        new = (found & readers.keys()) - reached
    assert reached == readers.keys()


def test_a_link_to_a_place_that_no_page_has_is_an_error() -> None:
    with pytest.raises(KeyError):
        joined({"index.html": '<a href="#nowhere">x</a>'}, draw=True)


def test_the_ends_of_the_constants_are_those_of_the_certificate(
    made: Path, values: set[str]
) -> None:
    _, certificate = documents(made)
    for name, found in certificate["enclosures"]["constants"].items():
        low, high = found["ends"]
        if name not in ("r", "c", "V_0", "delta_theta"):
            assert (low if low == high else f"{low} {high}") in values, name


def test_both_sides_of_every_row_are_those_of_the_certificate(made: Path, values: set[str]) -> None:
    statement, certificate = documents(made)
    values = values | {"0", "1"}
    sides = certificate["enclosures"]["rows"]
    for name, found in sides.items():
        for side in ("lhs", "rhs"):
            low, high = found[side]
            assert (low if low == high else f"{low} {high}") in values, name
    compared = [row for row in statement["obligations"] if row["claim"][0] != "applies"]
    assert len(compared) == len(sides) == len(statement["obligations"]) - 1


def test_what_is_shown_is_a_part_of_what_is_certified(page: str) -> None:
    """Each short decimal is the beginning of both of its ends."""
    shape = r'<data value="([^" ]+) ([^" ]+)"(?: title="[^"]*")?>([^…<]*)…'
    shape += r"((?:·10<sup>[^<]*</sup>)?)"
    found = [(low, high, a + b) for low, high, a, b in re.findall(shape, page)]
    assert len(found) > 300
    for low, high, shown in found:
        text = re.sub(r"·10<sup>(.*)</sup>", r"e\1", shown).replace("−", "-")
        value, ends = Fraction(text), [abs(Fraction(low)), abs(Fraction(high))]
        place = Fraction(1, 10 ** len(text.partition("e")[0].partition(".")[2]))
        place *= Fraction(10) ** int(text.partition("e")[2] or 0)
        assert all(abs(value) <= end <= abs(value) + place for end in ends), shown


def test_refuted_rows_come_first_each_with_its_repair(made: Path, page: str) -> None:
    statement, _ = documents(made)
    refuted = [
        row
        for row in statement["obligations"]
        if row["verdict"] == "refuted" and row["severity"] in ACCUSATIONS
    ]
    classes = ACCUSATIONS
    refuted.sort(key=lambda row: classes.index(row["severity"]))
    places = [page.index(f'<article id="{row["name"]}">') for row in refuted]
    assert places == sorted(places)
    for row in refuted:
        article = page[page.index(f'<article id="{row["name"]}">') :].partition("</article>")[0]
        assert re.search(r'<b class="verdict proved">.*proved</b> <code>\S+</code>', article), row
        claim = re.search(r'<p class="claim">(.*?)</p>', article, re.DOTALL)
        assert claim is not None
        assert re.sub("<[^>]*>", "", claim[1]).strip(), row
        assert "<dl>" in article or "false at" in article, row
    assert f"{len(refuted)} of its" in page
    assert "True, but not by the printed argument: 3 sentences" in page
    assert "10 false claims that the text does not make" in page
    assert "it counts these 26 rows alike, as refuted" in " ".join(page.split())
    assert '<article id="printed.alone-d-y-3">' not in page


def test_the_first_screen_has_the_result(made: Path) -> None:
    first, _, rest = pages_of(made)["index.html"].partition("<figure")
    for words in (
        *("The theorem, repaired", "The theorem holds with repaired constants", "does not close"),
        *("As printed, the theorem is false", "Its set is right"),
        *("more than put together", "python3 -I verify/check.py"),
        *("Why set-interior: ", "Why zeta-x-bound and 3 more: "),
    ):
        assert words in first
    assert "in numbers" in rest
    assert '<data value="5.2e-7">5.2·10<sup>−7</sup></data>' in rest


def test_assumptions_and_digests_are_listed(made: Path, page: str) -> None:
    from hashlib import sha256

    for folder in sorted(path.parent.name for path in made.glob("*/statement.json")):
        for name in NAMES:
            assert sha256((made / folder / name).read_bytes()).hexdigest() in page
    for folder in (MAIN, "spectrum"):
        statement, _ = documents(made, folder)
        for assumption in statement["assumptions"]:
            assert prose(assumption["sentence"]) in page
    for assumption in step_cited().trusted:
        assert prose(assumption.sentence) in page


def test_the_measurements_are_shown(built: Path) -> None:
    page = "".join(pages_of(built).values())
    assert TABLE["title"] in page
    assert 'value="1.0e-1230"' in page
    assert "plot-speed" in page


def test_the_latex_table_has_the_constants(made: Path) -> None:
    text = (made / "constants.tex").read_text(encoding="utf-8")
    assert r"$\overline{\eta}$ & $[0.0001889745,\, 0.00018897451]$ & $5.2\cdot 10^{-7}$" in text
    statement, _ = documents(made)
    names = {c["name"].removeprefix("repaired.").removeprefix("printed.")
             for c in statement["constants"]}  # fmt: skip
    assert text.count("\\\\\n") == len(names) + 1
    assert text.count("{") == text.count("}")


def test_prose() -> None:
    assert prose("η_{c,n+1}² < V₁^{1/2}") == "η<sub>c,n+1</sub>² &lt; V₁<sup>1/2</sup>"
    assert prose("r^(1/3)") == "r<sup>1/3</sup>"
    assert prose("η_c²") == "η<sub>c</sub>²"
    assert prose("1e-7") == '<data value="1e-7">10<sup>−7</sup></data>'
    assert prose("<script>") == "&lt;script&gt;"


def test_a_second_build_is_the_same_to_the_byte(built: Path) -> None:
    for name, content in build(built, draw=True).items():
        assert (built / name).read_bytes() == content, name


@pytest.fixture(autouse=True)
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """What is compared measures little."""
    monkeypatch.setattr("verify.measure.bench.out_of_date", lambda _: [])  # it has one table


run = command("report")


@pytest.fixture
def copy(built: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(built, tmp_path / "certificates"))


@pytest.fixture
def made_before(built: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The command makes the report that was built for all tests, which takes no time."""
    names = ["constants.tex", *pages_of(built), "pages/style.css"]
    made = {name: (built / name).read_bytes() for name in names}
    monkeypatch.setattr("verify.views.page.build.files", lambda *_, **__: made)
    empty = SimpleNamespace(measurements={})
    monkeypatch.setattr("verify.paper.commands.report.read_material", lambda *_: empty)


def test_compare_accepts_and_writes_nothing(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = {path: path.read_bytes() for path in copy.rglob("*") if path.is_file()}
    code, out, err = run(capsys, "--compare", "--directory", str(copy))
    assert (code, err) == (0, "")
    assert out.count("same") == len(pages_of(copy)) + 2
    assert before == {path: path.read_bytes() for path in copy.rglob("*") if path.is_file()}


@pytest.mark.usefixtures("made_before")
def test_compare_sees_one_digit(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("pages/constants.html", "constants.tex"):
        text = (copy / name).read_text(encoding="utf-8")
        assert "0.000637" in text
        (copy / name).write_text(text.replace("0.000637", "0.000638", 1), encoding="utf-8")
    code, out, _ = run(capsys, "--compare", "--directory", str(copy))
    assert code == 1
    assert out.count("DIFFERS") == 2
    code, out, _ = run(capsys, "--compare", "--directory", str(copy), "--json")
    found = json.loads(out)
    validator("files").validate(found)
    assert (code, found["exit_code"], found["command"]) == (1, 1, "report")
    states = [one["state"] for one in found["files"]]
    assert (states.count("differs"), {*states}) == (2, {"same", "differs"})


@pytest.mark.usefixtures("made_before")
def test_compare_sees_a_caption_but_no_path(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    page = copy / "pages/margins.html"
    text = page.read_text(encoding="utf-8")
    figure = text.index("<figcaption>")
    changed = re.sub(r"[0-9]{2,}", "7", text[figure:], count=1)
    page.write_text(text[:figure] + changed, encoding="utf-8")
    assert run(capsys, "--compare", "--directory", str(copy))[0] == 1
    page.write_text(re.sub(r"<svg .*?</svg>\n", "", text, flags=re.DOTALL), encoding="utf-8")
    assert run(capsys, "--compare", "--directory", str(copy))[0] == 0


def test_compare_without_a_page(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (copy / "index.html").unlink()
    code, _, err = run(capsys, "--compare", "--directory", str(copy))
    assert code == 2
    assert "index.html" in err


def test_a_certificate_that_the_checker_refuses_is_not_shown(
    copy: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = copy / MAIN / "certificate.json"
    text = path.read_text(encoding="utf-8")
    path.write_text(text.replace("0.36", "0.37").replace('"bits": 128', '"bits": 2', 1))
    (copy / MAIN / "statement.json").write_text("{}", encoding="utf-8")
    before = (copy / "index.html").read_bytes()
    code, out, err = run(capsys, "--directory", str(copy))
    assert code in (1, 4)
    assert out == ""
    assert err.startswith("verify: ")
    assert MAIN in err
    assert (copy / "index.html").read_bytes() == before


def test_a_weaker_statement_is_not_shown(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """It checks, but it is not the one that the program makes from its parameters."""
    from hashlib import sha256

    from verify.wire.write import encode

    statement, certificate = documents(copy)
    name = "repaired.y-sum"  # no other row, and not the step, is proved from it
    rows = statement["obligations"]
    rows.remove(next(row for row in rows if row["name"] == name))
    certificate["steps"] = [s for s in certificate["steps"] if s.get("obligation") != name]
    del certificate["enclosures"]["rows"][name]
    first = encode(statement)
    certificate["statement_sha256"] = sha256(first).hexdigest()
    (copy / MAIN / NAMES[0]).write_bytes(first)
    (copy / MAIN / NAMES[1]).write_bytes(encode(certificate))
    code, _, err = run(capsys, "--directory", str(copy))
    assert code == 1
    assert "not the one that the program makes" in err


@pytest.mark.parametrize(
    "content",
    ["", "[]", "{}", '{"tables": {"a": {"title": "t", "columns": ["x"], "rows": [[1, 2]]}}}',
     '{"tables": {"a": {"columns": [], "rows": []}}}'],
)  # fmt: skip
def test_unusable_measurements(
    copy: Path, capsys: pytest.CaptureFixture[str], content: str
) -> None:
    (copy / "data" / "bench.json").write_text(content, encoding="utf-8")
    code, _, err = run(capsys, "--compare", "--directory", str(copy))
    assert code == 2
    assert "bench.json" in err
    assert err.count("\n") == 1


def test_absent_measurements_and_spectrum_are_no_error(built: Path, tmp_path: Path) -> None:
    shutil.copytree(built / MAIN, tmp_path / MAIN)
    pages = build(tmp_path, draw=False)
    assert "pages/spectrum.html" not in pages
    assert "pages/speed.html" not in pages
    assert all(read(pages[name].decode()).open == [] for name in pages if name.endswith(".html"))


@pytest.mark.usefixtures("made_before")
def test_a_page_that_is_no_longer_made(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    old = copy / "pages" / "old.html"
    old.write_text("", encoding="utf-8")
    code, out, _ = run(capsys, "--compare", "--directory", str(copy))
    assert code == 1
    assert f"DIFFERS  {old}" in out
    assert run(capsys, "--directory", str(copy))[0] == 0
    assert not old.exists()


@pytest.mark.parametrize("kind", ["missing", "empty", "file", "spectrum alone"])
def test_a_directory_without_certificates(
    made: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], kind: str
) -> None:
    path = tmp_path / "x"
    if kind == "spectrum alone":
        shutil.copytree(made / "spectrum", path / "spectrum")
    if kind == "empty":
        path.mkdir()
    elif kind == "file":
        path.write_text("")
    code, out, err = run(capsys, "--directory", str(path))
    assert (code, out) == (2, "")
    assert err.startswith("verify: --directory")
    assert err.count("\n") == 1
