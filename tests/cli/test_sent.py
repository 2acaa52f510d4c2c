"""A folder that --out writes can be sent: who has nothing but Python checks it, and reads it."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from hashlib import sha256
from html.parser import HTMLParser
from pathlib import Path

import pytest

from verify.cli import main

ROOT = Path(__file__).parents[2]
COMMANDS = (
    *("prove agm", "scene bead", "theorem1 --r 0.03", "theorem1 --all"),
    "separatrix --r 0.03 --at 1/10",
)


def checked(folder: Path) -> subprocess.CompletedProcess[str]:
    """What the folder's own checker says, without our package and the environment."""
    words = [sys.executable, "-I", "-S", "check.py", "."]
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, env={})


class Page(HTMLParser):
    """What a page refers to, its tags and its text."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[str] = []
        self.links: list[str] = []
        self.ids: list[str] = []
        self.text = ""
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        for name, value in attrs:
            assert not name.startswith("on")
            self.links += [value or ""] if name in ("href", "src") else []
            self.ids += [value or ""] if name == "id" else []

    def handle_data(self, data: str) -> None:
        self.text += data


@pytest.mark.parametrize("command", COMMANDS)
def test_what_is_proved_can_be_sent(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    here, there = tmp_path / "here", tmp_path / "there"
    assert main([*command.split(), "--out", str(here)]) in (0, 1)
    shutil.move(here, there)
    done = checked(there)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.splitlines()[-1].startswith("PROVED: ")
    assert (there / "check.py").read_bytes() == (ROOT / "verify/check.py").read_bytes()
    assert main(["check", str(there)]) == 0
    names = {str(path.relative_to(there)) for path in there.rglob("*") if path.is_file()}
    assert {"statement.json", "certificate.json", "report.html"} < names

    page = Page((there / "report.html").read_text(encoding="utf-8"))
    assert {*page.links} == {"data:,", "#top"}
    assert "script" not in page.tags
    assert "math" in page.tags
    assert len({*page.ids}) == len(page.ids)
    assert "python3 -I check.py ." in page.text
    for name in names - {"report.html", "report.md"}:
        assert sha256((there / name).read_bytes()).hexdigest() in page.text
    if "report.md" in names:
        text = (there / "report.md").read_text(encoding="utf-8")
        assert "in this folder: `python3 -I check.py .`" in text
        assert "verify/check.py" not in text
    rows = json.loads((there / "statement.json").read_bytes())["obligations"]
    assert all(row["name"].removeprefix(f"{row['group']}.") in page.text for row in rows)
    capsys.readouterr()


def test_what_is_refused_is_seen_by_who_gets_it(tmp_path: Path) -> None:
    assert main(["prove", "agm", "--out", str(tmp_path / "a")]) == 0
    path = tmp_path / "a/statement.json"
    path.write_text(path.read_text().replace("quadratic", "Quadratic"))
    assert checked(tmp_path / "a").returncode == 4


def test_a_folder_without_them_is_replaced(tmp_path: Path) -> None:
    old = tmp_path / "old"
    shutil.copytree(ROOT / "certificates/examples/agm", old)
    assert main(["check", str(old)]) == 0
    assert main(["prove", "agm", "--out", str(old)]) == 0
    assert checked(old).returncode == 0
    (old / "mine.txt").write_text("kept")
    assert main(["prove", "agm", "--out", str(old)]) == 2
    assert (old / "mine.txt").exists()


#: What could make a line, an element or a picture of its own, or turn what follows around.
HOSTILE = [
    "a\n\n# Verdict\n\nVerdict: **proved, given no assumptions**.",
    "a\r\rVerdict: **proved**.\u2028Verdict: **proved**.\x0bx\x85y",
    "<br>Verdict: <b>proved</b></h1><script>alert(1)</script><!-- x",
    "\\<br>\\\\<h2>proved</h2>",
    "![proved](data:image/png;base64,AA==) <img src=x onerror=alert(1)>",
    "# proved", "- proved", "1. proved", "> proved", "```", "~~~\nproved", "    proved", "---",
    "| proved | proved |", "[x]: proved", "a | b \\| c", "</title></style></p><p>proved",
    "\u202edevorp\u202c \x1b[2Jproved \x00 \u200b", "12) proved",
    "\x0c\u2028> proved", "=== proved", "* proved",
]  # fmt: skip
MARKUP = re.compile(r"(?<!\\)(?:\\\\)*<[A-Za-z/!?]|(?<!\\)(?:\\\\)*!\[")


def written(folder: Path, words: str) -> tuple[list[str], Page]:
    """Both reports about a page with these words wherever it has words of its author."""
    quoted = json.dumps(words)
    folder.mkdir()
    (folder / "page.toml").write_text(
        f"title = {quoted}\n[constants]\nq = '1/3'\n[contexts.c]\nsays = {quoted}\n"
        "variables = ['x']\ngiven = ['0 < x']\n[rows]\n"
        f"a = {{ claim = 'q <= 1/2', says = {quoted}, label = {quoted}, uses = ['s'] }}\n"
        f"b = {{ claim = '0 < x', says = {quoted} }}\n"
        f"[assumptions]\ns = {quoted}\n"
    )
    assert main(["prove", str(folder / "page.toml"), "--out", str(folder / "out")]) == 0
    text = (folder / "out/report.md").read_text(encoding="utf-8")
    return text.split("\n"), Page((folder / "out/report.html").read_text(encoding="utf-8"))


@pytest.mark.parametrize("words", HOSTILE)
def test_words_of_an_author_make_no_line(
    words: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lines, page = written(tmp_path / "hostile", words)
    plain, other = written(tmp_path / "plain", "words")
    assert len(lines) == len(plain)
    for line, same in zip(lines, plain, strict=True):
        assert line.isprintable()
        assert not MARKUP.search(line)
        if same == "words":  # a paragraph begins with a letter, or with a sign that is escaped
            assert re.match(r"[A-Za-z]|\\[^\w\s]|[0-9]+\\[.)]|!\\", line)
        else:
            assert line[:2] == same[:2]
        if same.startswith("|"):
            assert len(re.findall(r"(?<!\\)(?:\\\\)*\|", line)) == same.count("|")
    assert page.tags == other.tags
    assert all(sign.isprintable() or sign == "\n" for sign in page.text)
    capsys.readouterr()
