"""What is cited is read once for several statements: with the same reports, and nothing leaks."""

from __future__ import annotations

import gc
import weakref
from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import INTERVAL, Pair, interval, total
from tests.check.test_citations import cited, citing
from tests.citing import cited_in
from verify import check

CERTIFICATES = Path(__file__).parents[2] / "certificates"
#: Cites three statements.
NEARLY_ALIGNED = CERTIFICATES / "scenes" / "nearly-aligned"


def beside(*others: Pair) -> dict[str, bytes]:
    found = [pair.files()[0] for pair in others]
    return {sha256(data).hexdigest(): data for data in found}


def asked(pair: Pair, library: check.Library, work: int = check.MAX_WORK) -> check.Report:
    return check.examined(*pair.files(), beside(cited()), work, library)


def state(library: check.Library) -> list[Any]:
    """All that the kernels of a library know."""
    found: list[Any] = []
    for kept in library.kept.values():
        kernel = kept.kernel
        contexts = [kernel.outermost, *kernel.contexts.values()]
        found.append([*(check.copies(item) for item in (kernel, *contexts)), kernel.work])
    return found


@pytest.mark.parametrize("path", sorted(CERTIFICATES.glob("scenes/*/statement.json")))
def test_committed_scenes_get_the_same_report(path: Path) -> None:
    files = path.read_bytes(), (path.parent / "certificate.json").read_bytes()
    library, available = check.Library(), cited_in(path.parent)
    alone = check.check(*files, available)
    for _ in range(3):
        assert check.check(*files, available, None, library) == alone
    (kept,) = library.kept.values()
    assert kept.statements
    assert alone.verdict == "PROVED"


def test_what_a_certificate_adds_is_not_in_the_next_one() -> None:
    """Facts, names, refusals, definitions that have a value; also in the cited context."""
    rich, library = citing(cited()), check.Library()
    assert asked(rich, library).verdict == "PROVED"
    before = state(library)
    proof = total("goal", "c:v-low", "1", using=["c:w"])
    rich.lemma("more", ["<", "0", ["add", "c:v", "1"]], proof, "c:free")
    rich.lemma("root-positive", ["<", "0", "c:root"], interval())
    rich.define("third", ["div", "c:root", "3"]).lemma("wrong", "1 <= 0", INTERVAL)
    first = asked(rich, library)
    (refusal,) = [line for line in first.lines if line.startswith("REFUSED")]
    assert refusal.startswith("REFUSED lemma wrong")
    for name in ("more", "root-positive", "third", "wrong"):
        pair = citing(cited())
        pair.lemma("uses", ["<", "0", "c:root"], total("goal", name))
        report = asked(pair, library)
        assert report.verdict == "MALFORMED"
        assert f"found {name}, which is no fact so far" in report.summary
    square_root = Pair("MAIN").cite("c", cited())
    square_root.row("row", ["<=", "0", ["sqrt", "c:root"]], total("goal"))
    assert "is not known to be >= 0" in asked(square_root, library).lines[0]
    assert asked(rich, library) == first
    assert state(library) == before


def nested() -> Pair:
    """A cited statement with a context in another one, and facts about signs everywhere."""
    pair = Pair("NESTED").constant("c", "2").row("sign", "0 < c", INTERVAL)
    pair.context("outer", {"x": "1"}, {"x-pos": "0 < x", "x-low": "0 <= x"})
    pair.inner("outer", "d", "x + c")
    return pair.context("inner", {"y": "1"}, {"y-low": "0 <= y"}, parent="outer")


def known(kernel: check.Kernel) -> Any:
    """All that a kernel knows, with contexts by their names."""

    def named(value: Any) -> Any:
        if isinstance(value, dict):
            return {key: named(item) for key, item in value.items()}
        if isinstance(value, check.Context):
            tables = check.copies(value)
            return value.name, [item.name for item in value.around], value.is_open, tables
        is_plain = not isinstance(value, list | check.Fact)
        return value if is_plain else [named(item) for item in value]

    return named({"outermost": kernel.outermost, **check.copies(kernel)})


def apart(kernel: check.Kernel, other: check.Kernel) -> bool:
    """Whether two kernels have no table and no context in common."""

    def parts(found: check.Kernel) -> set[int]:
        owners = [found, found.outermost, *found.contexts.values()]
        tables = [item for owner in owners for item in vars(owner).values()]
        changing = [item for item in tables if isinstance(item, dict | list | set)]
        contexts = [*found.homes, *(fact.context for fact in found.facts.values())]
        around = [item for context in contexts for item in (*context.around, context)]
        return {id(item) for item in [*owners, *changing, *around]}

    return not parts(kernel) & parts(other)


def test_a_copy_knows_the_same_and_shares_nothing_that_changes() -> None:
    library, kernel = check.Library(), check.Kernel()
    items = citing(nested(), INTERVAL, "0 <= 1").statement["cites"]
    found, _ = library.open(items, kernel, beside(nested()))
    assert known(found) == known(kernel)
    assert apart(found, kernel)
    assert [item.name for item in found.contexts["c:inner"].around] == ["", "c:outer", "c:inner"]
    assert found.outermost.positive
    assert found.contexts["c:outer"].positive


def test_other_bytes_are_read_anew() -> None:
    """Whoever calls this says under which digest they are; those that were read are compared."""
    other, library = cited(), check.Library()
    assert asked(citing(other), library).verdict == "PROVED"
    (digest,) = beside(other)
    changed = cited()
    changed.statement["assumptions"][0]["sentence"] = "another sentence"
    for data in (changed.files()[0], other.files()[0]):
        report = check.examined(*citing(other).files(), {digest: data}, check.MAX_WORK, library)
        assert (report.cites[0].sentences["law"] == "another sentence") == (
            data != beside(other)[digest]
        )
    report = check.examined(*citing(other).files(), {}, check.MAX_WORK, library)
    assert (report.verdict, "not at hand" in report.summary) == ("MALFORMED", True)


def test_the_work_is_that_of_reading_it_now() -> None:
    pair, library = citing(cited()), check.Library()
    alone = check.check(*pair.files(), beside(cited())).work
    for limit in (alone, 10 * check.MAX_WORK, alone):
        assert asked(pair, library, limit).work == alone
        fresh = check.check(*pair.files(), beside(cited()), limit)
        assert asked(pair, library, limit) == fresh
    for limit in (alone - 1, alone // 2, alone // 10):
        report = asked(pair, library, limit)
        assert (report.verdict, "more work" in report.summary) == ("MALFORMED", True)


def test_few_kernels_are_kept_and_no_large_ones(monkeypatch: pytest.MonkeyPatch) -> None:
    library = check.Library()
    for i in range(2 * check.MAX_KEPT):
        pair = Pair("MAIN").cite(f"c{i}", cited()).row("row", "0 <= 1", INTERVAL)
        assert asked(pair, library).verdict == "PROVED"
        assert len(library.kept) == min(i + 1, check.MAX_KEPT)
    assert f'"c{i}"' in [*library.kept][-1]
    nodes = len(next(iter(library.kept.values())).kernel.nodes)
    for most in (nodes, nodes - 1):
        library = check.Library()
        monkeypatch.setattr(check, "MAX_KEPT_NODES", most)
        for _ in range(2):
            assert asked(citing(cited()), library).verdict == "PROVED"
        assert len(library.kept) == (most == nodes)


def test_a_kernel_is_freed_without_looking_for_circles(monkeypatch: pytest.MonkeyPatch) -> None:
    """The command collects no garbage: in a folder of scenes nothing may pile up."""
    files = [
        (NEARLY_ALIGNED / f"{name}.json").read_bytes() for name in ("statement", "certificate")
    ]
    seen: list[Any] = []

    class Seen(check.Kernel):
        def __init__(self) -> None:
            super().__init__()
            seen.extend(map(weakref.ref, (self, self.outermost)))

    monkeypatch.setattr(check, "Kernel", Seen)
    library = check.Library()
    gc.disable()
    try:
        check.check(*files, cited_in(NEARLY_ALIGNED), None, library)
        assert [item() for item in seen[2:]] == [None, None]
        library.kept.clear()
    finally:
        gc.enable()
