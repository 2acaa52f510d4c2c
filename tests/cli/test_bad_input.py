"""Whatever is written: one line that says what, where, and what to write instead; exit code 2.

What random words have found, and one of each kind; `RANDOM_WORDS` has the number of more of them.
"""

from __future__ import annotations

import os
import random
import re
import signal
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from verify.cli import COMMANDS, main
from verify.cli.options import Parser

ROOT = Path(__file__).resolve().parents[2]
MEAN = str(ROOT / "certificates/examples/mean")
PARTING = str(ROOT / "certificates/scenes/parting.toml")

#: Files that are not what they should be.
FILES = {
    "empty": b"",
    "bytes": bytes(range(256)),
    "object.json": b"{}",
    "null.json": b"null",
    "deep.json": b"[" * 100_000,
    "digits.json": b'{"a":' + b"9" * 5000 + b"}",
    "nan.toml": b"r = nan\npositions = 1\nvelocities = []",
    "words.toml": b'r = "1/2"\npositions = [["1", "nan"], ["2", "x"], ["3", "4"]]\nvelocities = []',
    "huge.toml": b'r = "1/2"\npositions = [["0", "0"], ["1e999999", "0"], ["-2", "4"]]\n'
    b'velocities = [["0", "0"], ["0", "0"], ["0", "0"]]',
    "family.toml": b'r = "0.01..0.05"\npositions = [[0, 0], [1.002, 0], [-1.006, "h"]]\n'
    b'velocities = [[0, 0], [-1.4, 0], [0.7, -0.1]]\n[parameters]\nh = "0..0.1"\n',
    "unit.toml": b'r = 0.01\npositions = [[0, 0], [1.002, 0], [-1.006, "h"]]\n'
    b'velocities = [[0, 0], [-1.4, 0], [0.7, -0.1]]\n[parameters]\nh = "0..5 cm"\n',
    "long.toml": b'title = "t"\n[contexts.b]\nvariables = ["x"]\n'
    b'given = ["1 <= x", "x <= 10^(-999)"]\n[rows]\nr = "0 < x"\n',
    "outside.toml": b'r = "2"\npositions = [["0", "0"], ["2", "0"], ["-2", "0"]]\n'
    b'velocities = [["0", "0"], ["0", "0"], ["0", "0"]]',
}
NUMBERS = (
    "", " ", "0", "-1", "2", "nan", "inf", "1e-1000000", "1e1000000", "10**10000", "9" * 5000,
    "1/0", "1/" + "9" * 5000, "..", "0.04..0.02", "0x1", "1_0", "٣", "½", "\x00", "\n", "\ud800",
    "−1",
)  # fmt: skip
MORE = [*NUMBERS, *FILES, "folder", "missing", MEAN, PARTING, "flow", "a/" * 3000, "/dev/null"]


@pytest.fixture(autouse=True)
def a_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for name, content in FILES.items():
        Path(name).write_bytes(content)
    for name in ("folder", "folder.toml", "folder.svg"):
        Path(name).mkdir()


def refused(capsys: pytest.CaptureFixture[str], words: list[str]) -> str:
    """The complaint about these words, which is one line of moderate length."""
    code = main(words)
    out, err = capsys.readouterr()
    assert (code, "" if "--json" in words else out) == (2, ""), words
    assert err.count("\n") == 1, words
    assert err.startswith("verify: "), words
    assert len(err) < 600, words
    assert not any(inner in err for inner in ("Errno", "Traceback", "NoneType", "codec")), err
    return err


@pytest.mark.parametrize("option", ["--r", "--neg-cos", "--V0", "--delta-theta", "--theta0"])
def test_numbers(option: str, capsys: pytest.CaptureFixture[str]) -> None:
    usable = {"--V0": {"2"}, "--delta-theta": {"2"}, "--theta0": {"2"}}.get(option, set())
    for text in (number for number in NUMBERS if number not in usable):
        given = [f"{option}={text}"] + (["--r", "0.03"] if option != "--r" else [])
        assert "write " in refused(capsys, ["theorem1", *given])


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["theorem1", "--r", "0.03", "--color", "blue"], "write auto, always or never"),
        (["spectrum", "--json", "--color", ""], "write auto, always or never"),
        (["theorem1", "--r", "0.03", "--constants", "x"], "write printed, repaired or all"),
        (["theorem1", "--all", "--constants", ""], "write printed, repaired or all"),
        (["theorem1", "--r", "0.03", "--rows", "x-term"], "is it x-term-2"),
        (["theorem1", "--r", "0.03", "--steps", "1e9"], "needs an interval of r"),
        (["theorem1", "--r", "0.1..0.2", "--steps", "3", "--rows", "a"], "leave it out"),
        (["theorem1", "--r", "0.03", "--out", "empty"], "name a folder that can"),
        (["theorem1", "--r", "0.03", "--out", ""], "write . for this one"),
        (["elsewhere", "--rows", ""], "write a name that -v prints"),
        (["classification", "--rows", "cone-image"], "is it cone-image"),
        (["separatrix"], "--r: is missing; write for example --r 0.03"),
        (["separatrix", "--r", "0.03..0.02"], "--r: "),
        (["separatrix", "--r", "1"], "is not in (0, 1)"),
        (["separatrix", "--r", "0.03", "--neg-cos", "0"], "is not in (0, 1]; write"),
        (["separatrix", "--r", "0.03", "--ratio", "0"], "is not positive; write"),
        (["separatrix", "--r", "0.03", "--neg-cos="], "'' is not an exact number; write"),
        (["separatrix", "--r", "0.03", "--masses="], "'' is not an exact number; write"),
        (["separatrix", "--r", "0.03", "--digits="], "write a whole number from 1 to 1000"),
        (["theorem1", "--r", "0.02..0.03", "--neg-cos="], "'' is no interval; write"),
        (["map", "phi", "--r", "0.03", "--x="], "--x: '' is no interval; write"),
        (["map", "phi", "--r", "0.03", "--tangential="], "'' is no pair; write 1,1"),
        (["map", "phi", "--r", "0.03", "--undecided="], "--undecided: ''"),
        (["scene", PARTING, "--trajectory", "folder"], "folder' is a folder; name another place"),
        (["separatrix", "--r", "0.03", "--at", "-1/10"], "is negative; write for example 1/10"),
        (["separatrix", "--r", "0.03", "--digits", "0"], "write a whole number from 1 to 1000"),
        (["separatrix", "--r", "0.03", "--budget", "x"], "write a whole number from 1"),
        (["scene", "outside.toml"], "outside.toml: r: '2' is not in (0, 1]; write"),
        (["scene", "nan.toml"], "nan.toml: r: "),
        (["scene", "words.toml"], "words.toml: "),
        (["scene", "huge.toml"], "huge.toml: positions of particle 1: "),
        (["scene", "empty"], "empty: 'positions' is missing; write r, positions, velocities"),
        (["scene", "digits.json"], "a number or a name has more than 4300 signs; make it shorter"),
        (["scene", "bytes"], "is not valid TOML (it is not UTF-8); save it as UTF-8"),
        (["scene", "folder"], "no file that ends in .toml"),
        (["scene", PARTING, "--plot", "x\n.png"], "ends in neither .svg nor .html"),
        (["scene", PARTING, "--plot", "folder.svg"], "--plot: "),
        (["scene", PARTING, "--digits", "10**10000"], "write a whole number"),
        (["prove", "deep.json"], "STATEMENT: "),
        (["prove", "null.json"], "STATEMENT: "),
        (["prove", "digits.json"], "STATEMENT: "),
        (["prove", "folder"], "cannot be read"),
        (["prove", "long.toml"], "says 0 ≤ -99999999999999999999...9999999999; mend one of them"),
        (["check", "object.json"], "is a file; name a folder"),
        (["check", "folder"], "name a certificate's folder"),
        (["check", MEAN, "missing"], "'missing' does not exist"),
        (["export", "isabelle", MEAN], "write coq"),
        (["export", "coq", "folder"], "name a certificate's folder"),
        (["explain", "flow", "contac"], "is it contact"),
        (["explain", ""], "there is no row ''"),
        (["explain", "zeta-total", "--r", "0.9"], "write numbers at which all hold: --r 0.03"),
        (["explain", "zeta-all", "--r", "0.03"], "in 'theorem1'; is it "),
        (["map", "phi"], "--r: is missing"),
        (["report", "--directory", "empty"], "is not a folder"),
        (["certify", "--compare", "--directory", "missing"], "is not a folder"),
        (["stress", "--out", "empty"], "--out: "),
        (["bench", "--nonsense"], "unknown option '--nonsense'; see verify bench --help"),
        (["theorem1", "--r"], "--r: its value is missing"),
        ([PARTING], f"write one before it: scene {PARTING}"),
        (["words.json"], "write one before it: prove words.json"),
        (["teorem1"], "is not a command; did you mean theorem1?"),
        (["foo"], "is not a command; write one of"),
        (["theorem1", "--v0", "1"], "unknown option '--v0' (did you mean --V0?); see"),
        (
            ["theorem1", "--r", "0.03", "--V0", "1,000"],
            "write 1000, or 1.000 if the comma is a decimal comma",
        ),
        (["theorem1", "--r", "0.03", "--V0", "1_000"], "write 1000"),
        (["theorem1", "--r", "0.03", "--V0", "1 000"], "write 1000"),
        (["theorem1", "--r", "0.03", "--V0", "1.000.000,5"], "write 1000000.5"),
        (["theorem1", "--r", "0.03", "--V0", "0,030"], "write 0.030"),
        ([], "no command; write one of"),
        (["theorem1", "--r", "0.03r"], "write 0.03\n"),
        (["theorem1", "--r", "3%"], "write 0.03\n"),
        (["theorem1", "--r", "1/3%"], "write 1/300\n"),
        (["theorem1", "--r", "r=0.03"], "write 0.03\n"),
        (["theorem1", "--r", "0.01-0.03"], "write 0.01..0.03 where an interval may stand"),
        (["theorem1", "--r", "[0.01, 0.03]"], "write it like 0.03"),
        (["theorem1", "--r", "[0.01,0.03]"], "write 0.01..0.03 where"),
        (["theorem1", "--r", "0.01...0.03"], "is no interval; write 0.01..0.03\n"),
        (["theorem1", "--r", "0.01..0.03", "--steps", "1e3"], "write 1000 (a whole number"),
        (["theorem1", "--r", "0.01..0.03", "--steps", "1,000"], "write 1000 (a whole number"),
        (["theorem1", "--r", "0.01..0.03", "--steps", "10^3"], "write 1000 (a whole number"),
        (["theorem1", "--r", "0.01..0.03", "--steps", "2.5"], "write a whole number from 2"),
        (["prove", "fista", "--work", "1e6"], "write 1000000 (a whole number"),
        (["prove", "fista", "--time", "5s"], "write 5, the number of seconds"),
        (["prove", "fista", "--time", "2 min"], "write 120, the number of seconds"),
        (["prove", "fista", "--time", "1:30"], "write 90, the number of seconds"),
        (["scene", PARTING, "--jobs", "1x"], "write 1 (a whole number"),
        (["map", "phi", "--r", "0.03", "--undecided", "1,5%"], "write 1.5%"),
        (["map", "phi", "--r", "0.03", "--undecided", "5"], "write 5%"),
        (["scene", "family.toml", "--at", "r=0,02"], "write r=0.02\n"),
        (["scene", "family.toml", "--at", "r=0,02,h=0,01"], "write r=0.02,h=0.01\n"),
        (["scene", "family.toml", "--at", "{r: 0.02; h: 0.01}"], "write r=0.02,h=0.01\n"),
        (["scene", "family.toml", "--at", "R=0.02,h=0"], "did you mean r?"),
        (["scene", "family.toml", "--grid", "r=0,01..0,05:3"], "write r=0.01..0.05:3\n"),
        (["scene", "family.toml", "--grid", "r=0.01..0.05"], "write r=0.01..0.05:5 for 5 values"),
        (["map", "family.toml", "--x", "r=0.01-0.05"], "write 0.01..0.05\n"),
        (["map", "unit.toml", "--x", "h"], "h: '5 cm' is not an exact number; write 5\n"),
        (["scene", "passing", "--trajectory", "f.xlsx"], "ends in .xlsx; write f.csv"),
        (["theorem1", "--r", "0.03", "--csv", "f.ods"], "ends in .ods; write f.csv"),
        (["export", "step"], "write verify export coq step or verify export text step;"),
        (["export", "coq"], "write verify export coq FOLDER;"),
        (["export", "a\nb"], "write verify export coq FOLDER or"),
        (["export", "x" * 5000], "write verify export coq FOLDER or"),
        (
            ["explain", "fista", "grows"],
            "verify prove fista --out DIR, and then verify explain DIR",
        ),
        (["explain", "4.99"], "have rows: (4.59), (4.61), (4.62)\n"),
        (["explain", "9.1"], "no row is about (9.1); write one of the nearest"),
        (["check", "theorem1-al"], "such as theorem1-all"),
        (["check", "sandwhich"], "such as sandwich"),
    ],
)
def test_one_line_says_what_to_write(
    words: list[str], says: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert says in refused(capsys, words)


def test_random_words(capsys: pytest.CaptureFixture[str]) -> None:
    """Any option of any command with any value: an answer, or a line that says what is wrong."""
    chosen = random.Random(5)
    left_out = ("bench", "certify", "report", "stress", "map")  # long where the words are usable
    names = [name for name in COMMANDS if name not in left_out]
    for _ in range(int(os.environ.get("RANDOM_WORDS", "60"))):
        name = chosen.choice(names)
        parser = Parser(name, "", import_module(f"verify.cli.{name}").USAGE)
        options = [*parser.valued] or ["--nonsense"]
        words = [name, chosen.choice(MORE)] if chosen.random() < 0.6 else [name]
        words += [f"{chosen.choice(options)}={chosen.choice(MORE)}" for _ in range(2)]
        code = main(words)
        out, err = capsys.readouterr()
        assert code in (0, 1, 2, 3, 4), words
        assert "Traceback" not in err, words
        assert code != 2 or (out, err.count("\n")) == ("", 1), words


def test_the_reader_leaves() -> None:
    """Closed, or full: no traceback, and an exit code that says it."""
    command = f"{sys.executable} -m verify theorem1 --r 0.03 --json"
    for rest, code in (("| true; exit ${PIPESTATUS[0]}", 141), (">/dev/full", 2), (">&-", 2)):
        done = subprocess.run(
            ["bash", "-c", f"{command} {rest}"], cwd=ROOT, capture_output=True, timeout=60
        )
        assert done.returncode == code
        assert done.stderr.count(b"\n") == (code == 2)


def test_ctrl_c_ends_several_processes(tmp_path: Path) -> None:
    """What waits here for the end of the output waits for every process."""
    scenes = tmp_path / "scenes"
    scenes.mkdir()
    for number in range(60):
        (scenes / f"s{number}.toml").write_bytes(Path(PARTING).read_bytes())
    command = [sys.executable, "-m", "verify", "scene", str(scenes), "--jobs", "2"]
    command += ["--out", str(tmp_path / "out")]
    process = subprocess.Popen(command, cwd=ROOT, stdout=-1, stderr=-1, start_new_session=True)
    assert process.stdout is not None
    assert process.stdout.readline().startswith(b"s0.toml: disperses: ")
    os.killpg(process.pid, signal.SIGINT)
    _, err = process.communicate(timeout=30)
    assert (process.returncode, err) in ((0, b""), (130, b"verify: interrupted\n"))


@pytest.mark.parametrize(
    ("words", "code"),
    [
        ("theorem1 --r 0.03r", 0),
        ("theorem1 --r 0.01..0.03 --steps 1e1", 0),
        ("theorem1 --r 0.03 --V0 1,000", 0),
        ("prove fista --time 60s", 0),
        ("prove fista --work 1e6", 0),
        ("scene family.toml --at r=0,02,h=0,05", 0),
        ("scene family.toml --grid r=0,02..0,03:2 --at h=0.05", 0),
        ("scene passing --trajectory f.xlsx", 0),
        ("export step", 0),
        ("explain 4.99", 0),
        ("explain (4.58)", 0),
        ("scene pasing", 0),
    ],
)
def test_a_remedy_works_when_it_is_followed(
    words: str, code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    given = words.split()
    for _ in range(2):
        err = refused(capsys, given)
        before = r"(?:write (?!one of)(?:verify )?|did you mean |have rows: )"
        found = re.search(before + r"([^ ,;?(\n]*(?:\([^)]*\))?)", err)
        assert found, err
        if "write verify" in err:
            given = err.split("write verify ")[1].split(" or ")[0].split()
        else:
            quoted = re.search(r"'([^']*)'", err)
            wrong = quoted[1] if quoted and "no row is about" not in err else given[-1]
            meant = found[1] if ",h=" not in err else err.split("write ")[1].strip()
            given = [
                meant if word == wrong else word.replace(f"={wrong}", f"={meant}") for word in given
            ]
        if main(given) == code:
            capsys.readouterr()
            return
        capsys.readouterr()
    pytest.fail(f"{given}")


@pytest.mark.parametrize("command", ["prove", "scene", "map", "check", "explain"])
def test_what_may_be_written_is_said_where_all_is_missing(
    command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    code = main([command])
    err = capsys.readouterr().err
    found = re.search(r"write for example verify (.*); see", err)
    assert code == 2
    assert found is not None
    words = found[1].split()
    if command == "map":  # which takes its time
        words += ["--boxes", "9"]
    assert main(words) in (0, 1, 3)
