"""Holes that were found by looking for them: each test fails without its repair."""

from __future__ import annotations

import os
import random
import signal
import time
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from typing import Any

import mpmath
import pytest

from tests.check.support import INTERVAL, Pair, answer, total
from verify import check


def true(pair: Pair) -> Pair:
    """The statement with a row that is true."""
    return pair.row("row", "0 <= 1", INTERVAL)


@pytest.mark.parametrize("document", [b"5", b"null", b"true"])
def test_a_document_that_is_no_object_is_malformed(document: bytes) -> None:
    first, second = true(Pair()).files()
    for files in [(document, second), (first, document)]:
        code, lines = answer(files)
        assert code == 4
        assert lines[-1].endswith(", expected an object")


def balanced(leaves: list[Any], terms: dict[str, Any]) -> str:
    """The name of a shared term for the sum."""
    while len(leaves) > 1:
        pairs = [leaves[i : i + 2] for i in range(0, len(leaves), 2)]
        leaves = []
        for pair in pairs:
            name = f"sum{len(terms)}"
            terms[name] = ["add", *pair] if len(pair) == 2 else pair[0]
            leaves.append(name)
    return str(leaves[0])


def test_powers_of_one_while_roots_are_reduced_take_no_time() -> None:
    """The square of the root of 1 is 1/1; each of the other monomials is multiplied by 1^499000."""
    names = [f"v{i}" for i in range(300)]
    pair = true(Pair().context("c", dict.fromkeys(names, "1"), {}, []))
    large = ["pow", ["pow", ["sqrt", "1"], "999"], "999"]
    claim = ["<=", "0", balanced([large, *names], pair.terms)]
    pair.lemma("false", claim, total("goal", "1"), "c")
    before = time.process_time()
    assert answer(pair)[0] == 1
    assert time.process_time() - before < 5


def chain(length: int, leaf: Pair) -> tuple[Pair, list[Pair]]:
    """A statement that cites one that cites one, and so on, and what is cited."""
    pairs = [leaf]
    for _ in range(length):
        pairs.append(true(Pair()).cite("n" * 100, pairs[-1]))
    return pairs[-1], pairs[:-1]


def test_names_in_citations_of_citations_are_not_too_long() -> None:
    """A hundred citations would put ten thousand characters before each name of the last one."""
    top, cited = chain(9, true(Pair()))
    assert answer(top, cited=cited)[0] == 3
    top, cited = chain(10, true(Pair()))
    assert answer(top, cited=cited) == (4, ["MALFORMED: found a name of 1009 characters"])


def test_long_names_are_work() -> None:
    leaf = true(Pair())
    leaf.statement["terms"] = {f"t{i}": "1" for i in range(15_000)}
    top, cited = chain(9, leaf)
    code, lines = answer(top, cited=cited)
    assert code == 4
    assert "found more work" in lines[-1]


def test_additions_of_fractions_are_more_work_than_of_integers() -> None:
    """They take more time, and three objects more: 6 s and 300 MB in all, not 9 s and 600 MB."""
    spent = []
    for number in (3, Fraction(1, 3)):
        kernel = check.Kernel()
        kernel.plus({}, {(): number}, -1)
        spent.append(check.MAX_WORK - kernel.work)
    assert spent[1] >= spent[0] + 2


def written(folder: Path) -> Path:
    """A folder that is proved, with an empty folder for cited statements."""
    for name, data in zip(("statement", "certificate"), true(Pair()).files(), strict=True):
        (folder / f"{name}.json").write_bytes(data)
    (folder / "cited").mkdir()
    return folder


def test_nobody_waits_for_a_pipe_among_cited_files(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    def give_up(*_: object) -> None:
        raise AssertionError("somebody waits")

    folder = written(tmp_path)
    assert check.main([str(folder)]) == 0
    os.mkfifo(folder / "cited" / "pipe")
    before = signal.signal(signal.SIGALRM, give_up)
    signal.alarm(5)
    try:
        assert check.main([str(folder)]) == 2
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)
    assert "cited/pipe, which is no file" in capsys.readouterr().err


def test_pipes_that_are_named_are_read(tmp_path: Path) -> None:
    ends = []
    for data in true(Pair()).files():
        read, write = os.pipe()
        os.write(write, data)
        os.close(write)
        ends.append(read)
    assert check.main([f"/dev/fd/{end}" for end in ends]) == 0
    for end in ends:
        os.close(end)


def test_cited_files_are_few(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """All are kept until the end: a thousand of four megabytes would fill the memory."""
    folder = written(tmp_path)
    monkeypatch.setattr(check, "MAX_CITED", 100)
    for i in range(11):
        (folder / "cited" / f"{i}.json").write_bytes(b"0" * 10)
        assert check.main([str(folder)]) == (0 if i < 10 else 2)


def test_statements_cited_in_two_ways_are_the_same() -> None:
    """The same bytes under two names are two copies, which know nothing of each other."""
    leaf = true(Pair()).constant("c", "1")
    top = true(Pair()).cite("a", leaf).cite("b", leaf)
    top.lemma("equal", ["=", "a:c", "b:c"], total(using=["a:c"]))
    assert answer(top, cited=[leaf])[0] == 1
    top.steps[-1]["proof"] = total(using=["a:c", "b:c"])
    code, lines = answer(top, cited=[leaf])
    assert (code, lines[-1].count(sha256(leaf.files()[0]).hexdigest())) == (3, 1)


def near(generator: random.Random) -> Fraction:
    """A number, a half-integer, or one that is very near to a half-integer."""
    half = Fraction(generator.randint(-9, 9), 2)
    exponent = generator.randint(1, 40)
    kinds = [Fraction(0), Fraction(1, 10**exponent), Fraction(-1, 10**exponent)]
    kinds.append(Fraction(generator.randint(-(10**30), 10**30), 10**exponent))
    return half + generator.choice(kinds)


@pytest.mark.parametrize("bits", [2, 3, 8, 30, 64, 100])
def test_cosines_are_in_their_enclosures(bits: int) -> None:
    """With 600 bits, cosines are known to 500 bits also at arguments of 100 bits."""
    generator = random.Random(bits)
    scope = check.Enclosing(check.Kernel(), bits, None)
    with mpmath.workprec(600):
        for _ in range(150):
            low, high = sorted([near(generator), near(generator)])
            points = [low, high, (low + high) / 2, Fraction(high // 1), Fraction(-(-low // 1))]
            x = check.Interval(low, high)
            for op, enclose in (("cos", scope.cos), ("cospi", scope.cos_pi)):
                found = enclose(x)
                for point in points:
                    value = getattr(mpmath, op)(mpmath.mpf(point.numerator) / point.denominator)
                    slack = mpmath.mpf(2) ** -450
                    ends = [mpmath.mpf(end.numerator) / end.denominator for end in found]
                    inside = ends[0] - slack <= value <= ends[1] + slack
                    assert inside or not low <= point <= high
