"""Logs that must not pass the checker of maps, what it says of the others, and its command line."""

from __future__ import annotations

import copy
import json
import os
import random
import resource
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import Any

import pytest

from tests.check.test_check_map import CHECKER, LOG, STRIP, Lines, check, lines, on_a_line, sealed
from verify import check_map
from verify.check_map import Areas, LogError, RefusedError

SECONDS, MEMORY = 10, 500 << 20


def plane(kind: str) -> dict[str, Any]:
    """A plane of each kind, as a log has it."""
    if kind == "scene":
        found: dict[str, Any] = json.loads(on_a_line("9/10", "d", ["11/10", "12/10"])[0])["plane"]
        return found
    with (LOG if kind == "phi" else STRIP).open("rb") as file:
        found = json.loads(next(file))["plane"]
    if kind == "strip":  # four parts are enough
        found |= {"curve": found["curve"][30:34], "x": ["1/10", "11/100"]}
        found |= {"below": ["0", "1/2", "1"], "above": ["0", "1/2", "1"]}
    return found


KINDS = ("phi", "scene", "strip")

# --- what it says --------------------------------------------------------------------------------

#: Of each plane every number, changed to one that is usable too.
OTHERS: dict[str, dict[tuple[str | int, ...], Any]] = {
    "phi": {
        ("r",): "1/20", ("neg_cos",): "1/2", ("speed",): "1/7",
        ("tangential", 0): "3/5", ("tangential", 1): "3/5",
        ("x", 0): "1/90", ("x", 1): "3/5", ("y", 0): "1/90", ("y", 1): "3/5",
    },
    "scene": {
        ("r",): "1/20", ("x_at",): "velocities[1][1]", ("y_at",): "positions[2][1]",
        ("x", 0): "1/90", ("x", 1): "30", ("y", 0): "-3", ("y", 1): "30",
        **{
            (name, i, k): "1/90"
            for name in ("positions", "velocities")
            for i in range(3)
            for k in range(2)
            if (name, i) != ("velocities", 2)
        },
    },
}  # fmt: skip
OTHERS["strip"] = {
    **{key: value for key, value in OTHERS["phi"].items() if key[0] != "y" and key[0] != "x"},
    ("x", 0): "99/1000", ("x", 1): "111/1000", ("y", 1): "3/5", ("delta",): "1/999999",
    **{("curve", i, k): c for i in range(4) for k, c in enumerate(("1/12", "1/99", "1/98"))},
    ("below", 1): "1/3", ("above", 1): "1/3",
}  # fmt: skip


def put(document: Any, at: tuple[str | int, ...], value: Any) -> Any:
    """A copy with another value at a place."""
    found = inner = copy.deepcopy(document)
    for key in at[:-1]:
        inner = inner[key]
    inner[at[-1]] = value
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_two_planes_have_two_sentences(kind: str) -> None:
    first = plane(kind)
    documents = [first, *(put(first, at, value) for at, value in OTHERS[kind].items())]
    for is_strip in {False, kind == "strip"}:
        areas = Areas(9, 4, Fraction(1, 4), Fraction(1, 2), is_strip)
        said = [check_map.says(check_map.plane_of(document), areas) for document in documents]
        for a, b in combinations(range(len(said)), 2):
            assert said[a] != said[b], (documents[a], documents[b])


def leaves(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    for inner in (
        value.values() if isinstance(value, dict) else value if value != str(value) else ()
    ):
        yield from leaves(inner)


@pytest.mark.parametrize("kind", KINDS)
def test_a_sentence_names_all_hypotheses(kind: str) -> None:
    document = plane(kind)
    said = check_map.says(check_map.plane_of(document), Areas(9, 4, Fraction(1, 4), Fraction(1, 8)))
    for name, value in document.items():
        if name in ("name", "curve", "below", "above", "x_at", "y_at"):
            continue
        for number in leaves(value):
            if (name, number) not in {("velocities", "1"), ("velocities", "0")}:
                assert str(Fraction(number)) in said, (name, number, said)
    words = {
        "phi": ["r = 3/100", "-cos θ = 1", "-eta_c = 1/100", "u_c = 1 and u_s = 1",
                "φ1 = eta_s/(-eta_c) in [0, 1/2]", "φ2 = d/eta_c² in [0, 1/4]"],
        "scene": ["r = 9/10", "positions (0, 0) (2, 0) (-2, 0)", "velocities (0, 0) (-1, 0) (x, y)",
                  "x in [11/10, 6/5], y in [-1/1000, 1/1000]"],
        "strip": ["δ = 1/1000000", "-eta_c = 1/100", "u_c = 1 and u_s = 1", "4 equal parts",
                  "φ1 = eta_s/(-eta_c) in [1/10, 11/100]", "φ2 = d/eta_c² in [0, 1/4]"],
    }  # fmt: skip
    assert [word for word in words[kind] if word not in said] == []
    end = (
        "9 boxes, 4 of them proved; of the area: collapses 1/4 (about 25.0000 %), "
        "disperses 1/8 (about 12.5000 %), undecided 5/8 (about 62.5000 %)"
    )
    assert said.endswith(f": {end}")


def test_a_strip_says_what_all_its_states_do() -> None:
    found = check_map.plane_of(plane("strip"))
    told = (
        "every such state with 0 < φ2 <= f - δ collapses and every one with "
        "f + δ <= φ2 <= 1/4 disperses; 4 tiles; of the area: "
    )
    assert told in check_map.says(found, Areas(9, 4, Fraction(1, 4), Fraction(1, 2), True))
    assert "every" not in check_map.says(found, Areas(9, 4, Fraction(1, 4), Fraction(1, 2)))
    phi = check_map.plane_of(plane("phi"))
    assert "every" not in check_map.says(phi, Areas(9, 4, Fraction(1, 4), Fraction(1, 2), True))


def test_a_strip_is_one_where_all_tiles_are_proved(monkeypatch: pytest.MonkeyPatch) -> None:
    """Those below collapse, those above disperse, and none is missing."""
    monkeypatch.setattr(check_map, "prove_box", lambda *_: None)
    header, record = honest("strip")
    strip, keys = check_map.plane_of(header["plane"]), record["keys"].split(" ")
    assert isinstance(strip, check_map.Strip)
    good = "".join("d" if check_map.is_above(strip, key) else "c" for key in keys)

    def is_strip(letters: str, count: int = 16) -> bool:
        numbers = [[1] * 6] * letters[:count].count("c")
        found = record | {"keys": " ".join(keys[:count]), "verdicts": letters[:count]}
        return check([*sealed([header, found | {"numbers": numbers}])]).is_strip

    assert is_strip(good)
    assert not is_strip(good, 15)
    for place, letter in enumerate(good):
        for other in "cdu".replace(letter, ""):
            assert not is_strip(good[:place] + other + good[place + 1 :])


# --- malformed logs ------------------------------------------------------------------------------

ODD: list[Any] = [
    None, True, False, 0, 1, 5, -1, 1.5, 10**30, "", "5", "-1", "1/0", "1e9", "+1", " 1", "_1",
    "٣", "0.5", "1" * 41, [], [[]], [5, 5], ["5", "5"], ["1", "1", "1"], {}, {"0": "1"}, [None] * 3,
    [["0", "0"]] * 3, [[5, 5]] * 3, "velocities[0][9]", "positions[3][0]", [["1", "1", "1"]] * 2,
]  # fmt: skip


def places(document: Any, at: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    """All places in a document."""
    if at:
        yield at
    if isinstance(document, dict | list):
        keys = document if isinstance(document, dict) else range(len(document))
        for key in keys:
            yield from places(document[key], (*at, key))


def code(content: Any) -> int:
    """The exit code for a log; with a traceback the test fails."""
    said = ""
    try:
        check_map.check_log(iter(sealed(content)))
    except RefusedError:
        return 1
    except LogError as error:
        said = str(error)
    assert len(said) < 500
    assert said.isprintable()
    return 4 if said else 0


def honest(kind: str) -> Lines:
    """A log with a plane of each kind, and its first boxes undecided."""
    level = 2 if kind == "strip" else 1
    header = {"format": check_map.FORMAT, "plane": plane(kind), "first_level": level, "code": 1}
    keys = [check_map._key(i, level) for i in range(4**level)]
    record = {"level": level, "keys": " ".join(keys), "verdicts": "u" * 4**level, "numbers": []}
    return [header | {"sha256": ""}, record | {"sha256": ""}]


@pytest.mark.parametrize("kind", KINDS)
def test_wrong_types_and_shapes_are_malformed(kind: str) -> None:
    good = honest(kind)
    assert code(good) == 0
    usable, tried = 0, 0
    for at in places(good):
        if at[-1] == "sha256" or len(at) == 1:
            continue
        for value in ODD:
            tried += 1
            usable += code(put(good, at, value)) != 4
    # Some are usable, as other numbers are.
    assert usable < tried / 20, (usable, tried)


def test_what_is_no_json_object_with_the_keys() -> None:
    header = sealed(lines(1))[0]
    for bad in (b"", b"\n", b"5\n", b"[]\n", b"null\n", b'"sha256"\n', header[:-1], header + b" "):
        with pytest.raises(LogError):
            check([bad])
    with pytest.raises(LogError, match="no key twice"):
        check([header.replace(b'{"format"', b'{"format":1,"format"')])
    with pytest.raises(LogError, match="no key twice"):
        check([header.replace(b'"r":', b'"r":"1/2","r":')])
    for content in (
        [{**lines(1)[0], "more": 1}],
        [{"more": 1, **lines(1)[0]}],
        [put(lines(1)[0], ("plane", "more"), 1)],
    ):
        assert code(content) == 4
    with pytest.raises(LogError, match="expected a line with"):
        check([header.replace(b',"sha256":"', b',"sha256": "')])
    for number in (b"1.0", b"1e0", b"NaN", b"Infinity"):
        with pytest.raises(LogError, match="whole numbers"):
            check([header.replace(b'"first_level":', b'"first_level":' + number + b',"more":')])
    utf_16 = header.decode().encode("utf-16")
    with pytest.raises(LogError, match="no JSON"):
        check([utf_16])


@pytest.mark.parametrize(
    "text",
    [
        "velocities[2][0",
        "velocities[2][2]",
        "velocities[3][0]",
        "momenta[2][0]",
        "velocities[2][000]",
    ],
)
def test_what_is_no_place_of_a_number(text: str) -> None:
    content = honest("scene")
    assert code(put(content, (0, "plane", "x_at"), text)) == 4
    assert code(put(content, (0, "plane", "x_at"), "velocities[0][01]")) == 0


@pytest.mark.parametrize(
    ("name", "values", "wanted"),
    [
        ("r", ["0", "1", "-1/2"], 4), ("r", ["1/1000", "999/1000"], 0),
        ("neg_cos", ["0", "-1/2", "11/10"], 4), ("neg_cos", ["1/1000", "1"], 0),
        ("speed", ["0", "-1"], 4), ("speed", ["1/1000", "1000"], 0),
        ("x", [["0", "0"], ["1", "0"], ["-1", "1"]], 4), ("y", [["0", "0"], ["-1", "1"]], 4),
    ],
)  # fmt: skip
def test_the_ends_of_what_numbers_may_be(name: str, values: list[Any], wanted: int) -> None:
    for value in values:
        assert code(put(honest("phi"), (0, "plane", name), value)) == wanted


def test_whole_numbers_are_no_truths_and_not_long() -> None:
    content = honest("phi")
    for at in ((0, "first_level"), (0, "code"), (1, "level")):
        assert code(put(content, at, True)) == 4
        assert code(put(content, at, 1.0)) == 4
        assert code(put(content, at, 10**50)) == 4
    assert code(put(content, (0, "code"), (1 << 31) - 1)) == 0
    for value in (1 << 31, -1):
        assert code(put(content, (0, "code"), value)) == 4


def test_limits_of_what_a_box_has() -> None:
    content = on_a_line("1/100", "c", ["11/10", "12/10"])
    header, record = map(json.loads, content)
    for count, wanted in ((64, 1), (65, 4)):
        found = record | {"numbers": [[1] * 6 * count] * 4}
        assert code([header, found]) == wanted
    for number, wanted in (((1 << 60) - 1, 1), (1 << 60, 4)):
        assert code([header, record | {"numbers": [[number] * 6] * 4}]) == wanted


# --- counted work --------------------------------------------------------------------------------


def endless(sixes: int) -> list[bytes]:
    """Boxes that take as many steps as a box may."""
    content = [json.loads(line) for line in on_a_line("1/100", "c", ["11/10", "12/10"])]
    content[1]["numbers"] = [[1] * 6 * sixes] * 4
    return sealed(content)


def test_work_is_counted() -> None:
    work = check_map.Work(5)
    work.spend(5)
    with pytest.raises(RefusedError, match="--long"):
        work.spend(1)
    check_map.Work(None).spend(10**30)
    assert check_map.Work().left == check_map.MAX_WORK
    with LOG.open("rb") as file, pytest.raises(RefusedError, match="--long"):
        check_map.check_log(file, 2000)


def test_a_log_without_limit() -> None:
    found = on_a_line("9/10", "d", ["11/10", "12/10"])
    with pytest.raises(RefusedError, match="--long"):
        check_map.check_log(iter(found), 3)
    assert check_map.check_log(iter(found), None)[1].proved == 4


def phi_log(letters: str, level: int, sixes: int = 1, **changes: Any) -> bytes:
    """A log with all boxes of a level, and 4 MB at most."""
    header = honest("phi")[0] | {"first_level": level}
    header["plane"] |= changes
    keys = [check_map._key(i, level) for i in range(4**level)]
    found = (letters * len(keys))[: len(keys)]
    numbers = [[(1 << 60) - 1] * 6 * sixes] * found.count("c")
    record = {"level": level, "keys": " ".join(keys), "verdicts": found, "numbers": numbers}
    return b"".join(sealed([header, record]))


def undecided(level: int) -> bytes:
    """As many boxes without a verdict as there is room for."""
    header = honest("phi")[0] | {"first_level": level}
    keys, content, size = [check_map._key(i, level) for i in range(4**level)], [header], 0
    while size < 3 * 10**6:
        record = {
            "level": level,
            "keys": " ".join(keys),
            "verdicts": "u" * len(keys),
            "numbers": [],
        }
        content.append(record)
        size += len(keys) * (level + 2)
        keys, level = [key + digit for key in keys for digit in "0123"], level + 1
        keys = keys[: (3_900_000 - size) // (level + 2)]
    return b"".join(sealed(content))


def long_areas() -> bytes:
    """A strip with as many long fractions as there may be."""
    rng, header = random.Random(1), honest("strip")[0]
    long = [f"{rng.getrandbits(100) + 2**101}/{2**104 - 2 * i - 1}" for i in range(900)]
    count, size = 256, 10**37
    bands = ["0", *(f"{i * (size + 2 * i) // 128}/{size + 2 * i + 1}" for i in range(1, 128)), "1"]
    header["plane"] |= {
        "curve": [[long[i], long[i + count], "0"] for i in range(count)],
        "below": bands,
        "above": bands,
        "y": ["0", "9"],
        "r": "99/100",
    }  # fmt: skip
    header["first_level"] = 8
    keys = [check_map._key(i, 8) for i in range(4**8)]
    record = {"level": 8, "keys": " ".join(keys), "verdicts": "d" * len(keys), "numbers": []}
    return b"".join(sealed([header, record]))


def scenes(letter: str, size: int, x: list[str]) -> bytes:
    """Scenes with many long coordinates."""
    long = [str(Fraction(7 + i, 10**38 + 3)) for i in range(size - 2)]
    header = json.loads(on_a_line("99/100", letter, x)[0])
    for name in ("positions", "velocities"):
        header["plane"][name] = [[*row, *long] for row in header["plane"][name]]
    header["first_level"] = 7
    keys = [check_map._key(i, 7) for i in range(4**7)]
    numbers = [[1] * 36] * len(keys) if letter == "c" else []
    letters = letter * len(keys)
    record = {"level": 7, "keys": " ".join(keys), "verdicts": letters, "numbers": numbers}
    return b"".join(sealed([header, record]))


BOMBS: dict[str, Callable[[], bytes]] = {
    "sixes-without-end": lambda: b"".join(endless(50_000)),
    "as-many-sixes-as-a-box-may-have": lambda: phi_log("c", 5, 32, x=["1/100", "1/90"]),
    "boxes-that-disperse": lambda: phi_log("d", 8, y=["1/5", "1/4"]),
    "boxes-that-disperse-with-long-numbers": lambda: phi_log(
        "d", 8, y=["1/5", "1/4"], r="3" + "0" * 36 + "1/1" + "0" * 38,
        tangential=["9" * 39, "9" * 39], speed="1/" + "9" * 39,
    ),
    "undecided-boxes": lambda: undecided(1),
    "undecided-boxes-at-once": lambda: undecided(8),
    "long-areas": long_areas,
    "scenes-in-many-dimensions": lambda: scenes("d", 20, ["11/10", "12/10"]),
    "scenes-with-sixes": lambda: scenes("c", 20, ["9/10", "11/10"]),
    "nested-lists": lambda: b"[" * 4_000_000 + b"\n",
    "many-lists": lambda: b"[" + b"[]," * 1_333_000 + b"[]]\n",
    "many-objects": lambda: b"[" + b"{}," * 1_333_000 + b"{}]\n",
    "many-keys": lambda: b"{" + b",".join(b'"%x":1' % i for i in range(380_000)) + b"}\n",
    "a-long-number": lambda: b"[" + b"9" * 4_000_000 + b"]\n",
    "a-long-fraction": lambda: b"[0." + b"9" * 4_000_000 + b"]\n",
    "many-numbers": lambda: b"[" + b"9," * 1_999_000 + b"9]\n",
    "many-lines": lambda: b"\n" * 4_000_000,
    "many-short-lines": lambda: sealed(honest("phi"))[0] + b"{}\n" * 1_300_000,
}  # fmt: skip


def bounded() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))


@pytest.mark.parametrize("name", list(BOMBS)[:: 1 if os.environ.get("HEAVY") == "all" else 3])
def test_every_log_of_4_mb_is_answered(name: str, tmp_path: Path) -> None:
    data = BOMBS[name]()
    assert 10**4 < len(data) <= 4_300_000
    (tmp_path / "log").write_bytes(data)
    begin = time.process_time()
    done = subprocess.run(
        [sys.executable, "-I", str(CHECKER), str(tmp_path / "log")],
        capture_output=True,
        encoding="utf-8",
        preexec_fn=bounded,
        check=False,
    )
    assert begin <= time.process_time()
    assert done.stderr == ""
    assert done.returncode in (0, 1, 4)
    assert done.stdout.count("\n") == 1
    assert done.stdout.split()[0] in ("PROVED", "REFUSED", "MALFORMED")


# --- the command line ----------------------------------------------------------------------------


def run(*words: str | Path, **options: Any) -> tuple[int, str, str]:
    done = subprocess.run(
        [sys.executable, "-I", str(CHECKER), *map(str, words)],
        capture_output=True, encoding="utf-8", check=False, timeout=60, **options,
    )  # fmt: skip
    return done.returncode, done.stdout, done.stderr


@pytest.fixture
def logs(tmp_path: Path) -> Path:
    (tmp_path / "good").write_bytes(b"".join(sealed(lines(3))))
    (tmp_path / "bad").write_bytes(b"{}\n")
    refused = on_a_line("1/100", "d", ["11/10", "12/10"])
    (tmp_path / "refused").write_bytes(b"".join(refused))
    return tmp_path


def test_exit_codes(logs: Path) -> None:
    for names, wanted, words in (
        (["good"], 0, ["PROVED"]),
        (["refused", "good"], 1, ["REFUSED", "PROVED"]),
        (["bad"], 4, ["MALFORMED"]),
        (["bad", "refused", "--long"], 4, ["MALFORMED", "REFUSED"]),
        (["--long", "good"], 0, ["PROVED"]),
    ):
        paths = [name if name.startswith("-") else logs / name for name in names]
        code, out, err = run(*paths)
        assert (code, err) == (wanted, "")
        assert [line.split()[0] for line in out.splitlines()] == words
        for line in out.splitlines():
            assert line.startswith("PROVED") == line.endswith(
                "; given the theorems of certificates/flow and certificates/sharper; "
                "scenes with an overlap or a triple contact at the start are excluded"
            )
        assert all(str(path) in out for path in paths if path != "--long")


def test_what_is_no_file(logs: Path) -> None:
    os.mkfifo(logs / "pipe")
    (logs / "folder").mkdir()
    (logs / "locked").write_text("")
    for path in ("pipe", "folder", "missing", "a\nPROVED b"):
        code, out, err = run(logs / "good", logs / path)
        assert (code, out) == (2, "")
        assert err.startswith("check_map: found ")
        assert err.count("\n") == 1
    for words in ([], ["--long"], ["--what"], ["/dev/zero"]):
        code, out, err = run(*words)
        assert (code, out, err.count("\n")) == (2, "", 1)


def test_names_are_escaped(logs: Path) -> None:
    name = logs / "a\nPROVED b\x1b[2J"
    for content, wanted in (("good", 0), ("bad", 4), ("refused", 1)):
        name.write_bytes((logs / content).read_bytes())
        code, out, _ = run(name)
        assert code == wanted
        assert out.count("\n") == 1
        assert "\x1b" not in out


def test_a_line_without_end_is_malformed(tmp_path: Path) -> None:
    with (tmp_path / "log").open("wb") as file:
        file.truncate(1 << 32)
    code, out, err = run(tmp_path / "log")
    assert (code, err) == (4, "")
    assert "a line has more than" in out


def test_a_reader_that_leaves_and_a_full_disk(logs: Path) -> None:
    command = [sys.executable, "-I", str(CHECKER), str(logs / "good")]
    read, write = os.pipe()
    os.close(read)
    with os.fdopen(write, "wb") as out:
        done = subprocess.run(command, stdout=out, stderr=subprocess.PIPE, check=False)
    assert (done.returncode, done.stderr) == (141, b"")
    with Path("/dev/full").open("wb") as out:
        done = subprocess.run(command, stdout=out, stderr=subprocess.PIPE, check=False)
    assert done.returncode == 2
    assert done.stderr.startswith(b"check_map: the report cannot be written")


def test_any_encoding(logs: Path) -> None:
    code, out, err = run(logs / "good", env={"PYTHONIOENCODING": "ascii"})
    assert (code, err) == (0, "")
    assert "PROVED" in out


def test_work_without_limit_only_if_asked(logs: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(check_map, "MAX_WORK", 3)
    assert check_map.main([str(logs / "good")]) == 1
    assert check_map.main(["--long", str(logs / "good")]) == 0


def test_a_report_that_nobody_can_get_is_none(
    logs: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.stdout", None)
    assert check_map.main([str(logs / "good")]) == 2
    assert "stdout is closed" in capsys.readouterr().err


def test_closed_streams(logs: Path) -> None:
    def shell(redirections: str, path: Path) -> tuple[int, bytes, bytes]:
        command = f'"{sys.executable}" -I "{CHECKER}" "{path}" {redirections}'
        done = subprocess.run(command, shell=True, capture_output=True, check=False)
        return done.returncode, done.stdout, done.stderr

    written = b"check_map: the report cannot be written (stdout is closed)\n"
    assert shell(">&-", logs / "good") == (2, b"", written)
    assert shell(">&- 2>&-", logs / "good")[0] == 2
    assert shell("2>&-", logs / "good")[0] == 0
    for redirections in ("2>&-", "2>/dev/full", ">&- 2>&-", ">/dev/full 2>/dev/full"):
        assert shell(redirections, logs / "nowhere") == (2, b"", b""), redirections
    assert shell(">/dev/full 2>/dev/full", logs / "good")[0] == 2
