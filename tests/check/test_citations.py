"""Citations: facts of other statements, closed by a proof in the same run."""

from __future__ import annotations

from hashlib import sha256
from pathlib import Path
from typing import Any

import pytest

from tests.check.support import IDENTITY, INTERVAL, Pair, answer, instance, interval, total
from tests.lies.heavy import chain
from verify import check

CUBE = total("goal", ["pow", "v-low", "3"])


def cited() -> Pair:
    """v >= 0 implies v^3 >= 0; sqrt(2) > 1; and a row that is refuted, and one undecided."""
    pair = Pair("CUBES").assume("law").constant("root", "sqrt(2)", INTERVAL)
    pair.context("free", {"v": "1"}, {"v-low": "0 <= v"}).inner("free", "w", "v*v")
    pair.row("cube", "0 <= v*v*v", CUBE, "free").row("big", "1 < root", INTERVAL)
    pair.row("false", "root < 1", INTERVAL, None, "refuted", "printed")
    return pair.row("open", "root < 3/2", None, None, "undecided", "printed")


def citing(other: Pair, proof: Any = None, claim: Any = None, **fields: Any) -> Pair:
    pair = Pair("MAIN").cite("c", other, **fields)
    pair.lemma("one", "0 <= 1", INTERVAL)
    claim = claim or ["<=", "0", ["mul", ["mul", "1", "1"], "1"]]
    return pair.row("row", claim, proof or instance("c:cube", {"v": "1"}, "one"))


def last(*pairs: Pair, beside: tuple[Pair, ...] = ()) -> tuple[int, str]:
    code, lines = answer(*pairs, cited=beside)
    return code, lines[-1]


def digest(pair: Pair) -> str:
    return sha256(pair.files()[0]).hexdigest()


def test_a_citation_checked_in_the_same_run() -> None:
    other = cited()
    for pairs in ([other, citing(other)], [other, other, citing(other)]):
        code, line = last(*pairs)
        assert code == 0
        assert line.startswith("PROVED: MAIN's title: 1 needed proved")
        assert line.endswith("; given c:law")
    code, lines = answer(citing(other), other)
    assert code == 0
    assert "assumed c:law: sentence of law" in lines
    assert next(line for line in lines if "MAIN" in line).endswith("; given c:law")


def test_a_citation_at_hand_and_not_checked() -> None:
    other = cited()
    code, line = last(citing(other), beside=(other,))
    assert code == 3
    assert line.startswith("UNDECIDED: MAIN's title: 1 needed proved")
    assert line.endswith(f"; given c:law; citing CUBES, which is not proved here ({digest(other)})")
    assert last(refused(), citing(other), beside=(other,))[0] == 1  # which is worse


def test_a_citation_that_is_not_at_hand() -> None:
    code, line = last(citing(cited()))
    assert code == 4
    assert line.startswith("MALFORMED: cites: found ")
    assert line.endswith("whose statement is not at hand")


def test_a_changed_statement_is_not_at_hand() -> None:
    other, changed = cited(), cited()
    changed.statement["title"] = "another"
    assert last(changed, citing(other))[0] == 4


def test_a_wrong_title() -> None:
    other = cited()
    code, line = last(other, citing(other, theorem="SQUARES"))
    assert (code, "found SQUARES under another title" in line) == (4, True)


def refused() -> Pair:
    pair = cited()
    pair.steps[-2]["proof"] = IDENTITY
    return pair


def refuted() -> Pair:
    pair = cited()
    pair.statement["obligations"][2]["role"] = "needed"
    return pair


def malformed() -> Pair:
    pair = cited()
    pair.steps.pop()
    return pair


@pytest.mark.parametrize("other", [refused(), refuted(), malformed()])
def test_what_is_not_proved_does_not_close(other: Pair) -> None:
    code, line = last(other, citing(other))
    assert code in (1, 4)
    assert f"; citing CUBES, which is not proved here ({digest(other)})" in line
    code, lines = answer(citing(other), other)
    assert code in (1, 4)
    assert any("which is not proved here" in item for item in lines)


@pytest.mark.parametrize(
    ("claim", "proof", "reason"),
    [
        ("1 < 2", total("goal", "c:big"), "found a sum that is not 0"),
        ("1 < 2", total("goal", "c:false"), "found c:false, which is no fact so far"),
        ("1 < 2", total("goal", "c:open"), "found c:open, which is no fact so far"),
        ("1 < 2", total("goal", "c:law"), "found c:law, which is no fact so far"),
        ("1 < 2", total("goal", "big"), "found big, which is no fact so far"),
        ("1 < 2", total("goal", "c:v-low"), "found c:v-low, which is a fact of c:free only"),
        ("1 < 2", total("goal", "d:big"), "found d:big, which is no fact so far"),
        ("1 < 2", total("goal", "c:c:big"), "found c:c:big, which is no fact so far"),
        ("0 <= 1*1*1", instance("c:cube", {"v": "1"}, total("goal", "c:cube")), "of c:free only"),
        ("0 <= 1*1*1", instance("c:cube", {"c:v": "1"}, "one"), "expected a name"),
        ("0 <= 1*1*1", instance("cube", {"v": "1"}, "one"), "found cube, which is no fact"),
        ("0 <= -1*-1*-1", instance("c:cube", {"v": "-1"}, INTERVAL), "expected <= between them"),
    ],
)  # fmt: skip
def test_only_proved_rows_are_facts(claim: Any, proof: Any, reason: str) -> None:
    from tests.check.support import term

    other = cited()
    assert reason in "\n".join(answer(other, citing(other, proof, term(claim)))[1])


def test_names_of_a_cited_statement_have_its_name_before_them() -> None:
    other = cited()
    claim = ["<", "1", "c:root"]
    assert last(other, citing(other, total("goal", "c:big"), claim))[0] == 0
    assert last(other, citing(other, interval(), claim))[0] == 0
    code, line = last(other, citing(other, interval(), ["<", "1", "root"]))
    assert (code, "found root, which is no name so far" in line) == (4, True)


def test_lemmas_in_a_cited_context() -> None:
    other = cited()
    pair = citing(other)
    proof = total("goal", "c:v-low", "1", using=["c:w"])
    pair.lemma("more", ["<", "0", ["add", "c:v", "1"]], proof, "c:free")
    assert last(other, pair)[0] == 0
    pair.lemma("wrong", ["<", "0", "c:v"], proof, "c:free")
    assert last(other, pair)[0] == 1


def test_a_cited_context_is_not_opened_again() -> None:
    other = cited()
    pair = citing(other).step(open="c:free", givens=[INTERVAL])
    assert "expected a name" in last(other, pair)[1]


def test_the_name_of_a_citation_is_taken() -> None:
    other = cited()
    pair = citing(other).cite("c", other)
    assert "found the name c twice" in last(other, pair)[1]
    pair = citing(other).row("c", "0 <= 1", INTERVAL)
    assert "found the name c twice" in last(other, pair)[1]


def test_citations_of_citations() -> None:
    """Both are named; a chain is closed as far as it was checked."""
    first = cited()
    second = citing(first)
    second.statement["theorem"] = "SECOND"
    third = Pair("THIRD").cite("s", second)
    third.row("row", ["<", "1", "s:c:root"], total("goal", "s:c:big"))
    code, line = last(first, second, third)
    assert code == 0
    assert line.endswith("; given s:c:law")
    opened = [
        f"; citing {name}, which is not proved here ({digest(pair)})"
        for name, pair in (("SECOND", second), ("CUBES", first))
    ]
    for pairs, words in (((second, third), opened[1]), ((first, third), opened[0]),
                         ((third,), "".join(opened))):  # fmt: skip
        code, lines = answer(*pairs, cited=(first, second))
        assert code == 3
        assert lines[-1].endswith(f"; given s:c:law{words}")
        assert "assumed s:c:law: sentence of law" in lines


def test_citations_that_branch_are_named_once() -> None:
    """Each level cites the one below twice: 2^12 ways, and one line."""
    levels = [cited()]
    for i in range(1, 7):
        pair = Pair(f"LEVEL {i}").cite("a", levels[-1]).cite("b", levels[-1])
        levels.append(pair.row("row", "0 <= 1", INTERVAL))
    code, line = last(*levels)
    assert code == 0
    assert line.endswith("; given a:a:a:a:a:a:law")


def test_reading_citations_is_work() -> None:
    other = cited()
    other.statement["obligations"][0]["says"] = "x" * 4_000_000
    pair = citing(other)
    for i in range(20):
        pair.cite(f"c{i}", other)
    assert "found more work than the limit" in last(pair, beside=(other,))[1]


def test_reading_a_chain_of_citations_is_work_before_it_is_done(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """All its documents are in memory at once: of seven that are full of lists, none is read.

    A smaller chain in a smaller limit; `tests.lies.heavy` has the long one, with its memory.
    """
    files, read, honest = chain(7, check.MAX_BYTES >> 6), [], check.parsed
    monkeypatch.setattr(check, "MAX_WORK", check.MAX_WORK >> 6)
    monkeypatch.setattr(
        check, "parsed", lambda where, *rest: read.append(where) or honest(where, *rest)
    )
    cited = [data for name, data in files.items() if name.startswith("cited/")]
    pair = files["statement.json"], files["certificate.json"]
    code, lines = check.check_folders([check.Folder("", *pair, cited)])
    assert (code, "found more work than the limit" in lines[-1]) == (4, True)
    assert "cited statement" not in read


def test_statements_beside_a_certificate(tmp_path: Path, capsys: Any) -> None:
    other = cited()
    for name, pair in (("main", citing(other)), ("cubes", other)):
        (tmp_path / name).mkdir()
        for file, data in zip(("statement.json", "certificate.json"), pair.files(), strict=True):
            (tmp_path / name / file).write_bytes(data)
    main, cubes = str(tmp_path / "main"), str(tmp_path / "cubes")
    assert check.main([main]) == 4
    assert check.main([cubes, main]) == 0
    (tmp_path / "main" / "cited").mkdir()
    (tmp_path / "main" / "cited" / "any-name").write_bytes(other.files()[0])
    capsys.readouterr()
    assert check.main([main]) == 3
    assert "citing CUBES, which is not proved here" in capsys.readouterr().out
    files = [str(tmp_path / "main" / name) for name in ("statement.json", "certificate.json")]
    assert check.main(files) == 3
    (tmp_path / "main" / "cited" / "any-name").write_bytes(b"{}")
    assert check.main([main]) == 4


def test_that_a_cited_theorem_applies_is_no_fact() -> None:
    other = cited()
    proof = {"rule": "instance", "givens": [INTERVAL]}
    other.row("applies", ["applies", "free", {"v": "1"}], proof)
    assert last(other, citing(other))[0] == 0
    pair = citing(other, total("goal", "c:applies"))
    assert "found c:applies, which is no fact so far" in "\n".join(answer(other, pair)[1])


# --- what is cited is read once ------------------------------------------------------------------


def test_statements_that_cite_the_same_share_what_was_read_and_nothing_else() -> None:
    """What one of them proves in a cited context is no fact, and no known sign, for the others."""
    other, more = cited(), ["<", "0", ["add", "c:v", "1"]]
    first = citing(other)
    first.lemma("more", more, total("goal", "c:v-low", "1"), "c:free")
    first.lemma("root", ["<=", "0", ["div", "1", "c:root"]], INTERVAL)
    assert last(first, beside=(other,))[0] == 3
    divided = ["<", "0", ["div", "1", ["add", "c:v", "1"]]]
    for pair, says in (
        (citing(other).lemma("x", more, total("goal", "more"), "c:free"), "more, which is no fact"),
        (citing(other).lemma("x", divided, total("goal", "1"), "c:free"), "found a division by"),
        (citing(other).lemma("more", more, total("goal", "c:v-low", "2"), "c:free"), "not 0"),
    ):
        code, lines = answer(pair, cited=(other,))
        assert (code in (1, 4), says in "\n".join(lines)) == (True, True)
    first.lemma("x", divided, total("goal", "1"), "c:free")  # where the sign is a fact
    assert last(first, beside=(other,))[0] == 3


def test_what_was_read_before_counts_as_work_and_has_to_be_at_hand() -> None:
    other = cited()
    pair = Pair("OUTER").cite("s", citing(other)).row("row", "0 <= 1", INTERVAL)
    files, inner = pair.files(), citing(other).files()[0]
    everything = {sha256(data).hexdigest(): data for data in (inner, other.files()[0])}
    check.BEGINNINGS.clear()
    new = check.check(*files, everything)
    assert check.check(*files, everything) == new
    assert check.check(*files, everything, new.work).work == new.work
    with pytest.raises(check.Malformed, match="more work"):
        check.check(*files, everything, new.work - 1)
    for left_out in everything:
        some = {name: data for name, data in everything.items() if name != left_out}
        for _ in range(2):
            with pytest.raises(check.Malformed, match=f"{left_out}, whose statement is not at"):
                check.check(*files, some)
            check.BEGINNINGS.clear()


def test_what_is_cited_is_read_with_the_work_that_is_left(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing is read after that is used up; and a higher limit than usual is one here, too."""
    other = cited()
    pair, available = citing(other), {digest(other): other.files()[0]}
    limit = check.check(*pair.files(), available).work
    monkeypatch.setattr(check, "MAX_WORK", limit // 2)
    check.BEGINNINGS.clear()
    assert check.check(*pair.files(), available, limit).verdict == "PROVED"
    pair.cite("d", citing(cited()))  # which is not at hand
    for work, words in ((limit // 2, "more work"), (limit, "not at hand")):
        with pytest.raises(check.Malformed, match=words):
            check.check(*pair.files(), available, work)


def test_a_statement_under_another_digest_is_not_at_hand() -> None:
    other, changed = cited(), cited()
    changed.statement["title"] = "another"
    check.BEGINNINGS.clear()
    for _ in range(2):  # also after it was read
        with pytest.raises(check.Malformed, match="not at hand"):
            check.check(*citing(other).files(), {digest(other): changed.files()[0]})
        report = check.check(*citing(other).files(), {digest(other): other.files()[0]})
        assert report.verdict == "PROVED"


def test_beginnings_are_read_once_and_only_so_many_are_kept(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    other, read, honest = cited(), 0, check.parsed

    def counted(where: str, *rest: Any) -> Any:
        nonlocal read
        read += where == "cited statement"
        return honest(where, *rest)

    check.BEGINNINGS.clear()
    last(citing(other), beside=(other,))
    ((_, work, _),) = check.BEGINNINGS.values()
    monkeypatch.setattr(check, "MAX_KEPT", 7 * work // 2)
    monkeypatch.setattr(check, "parsed", counted)
    check.BEGINNINGS.clear()
    for i in range(12):
        pair = Pair("MAIN").cite(f"c{i}", other)
        pair.row("row", ["<", "1", f"c{i}:root"], total("goal", f"c{i}:big"))
        for _ in range(2):
            assert last(pair, beside=(other,))[0] == 3
        assert (read, len(check.BEGINNINGS)) == (i + 1, i % 4 + 1)


def test_what_has_no_term_is_not_kept_forever(monkeypatch: pytest.MonkeyPatch) -> None:
    """Contexts take memory, too: thirty thousand of them forty megabytes, for each new name."""
    other = Pair("CONTEXTS")
    for i in range(9):
        other.context(f"c{i}", {}, {})
    monkeypatch.setattr(check, "MAX_KEPT", 1)
    check.BEGINNINGS.clear()
    for i in range(3):
        pair = Pair("MAIN").cite(f"c{i}", other).row("row", "0 <= 1", INTERVAL)
        assert last(pair, beside=(other,))[0] == 3
        assert len(check.BEGINNINGS) == 1


# --- certificates that lie beside what is cited --------------------------------------------------


def with_proofs(pair: Pair, *others: Pair) -> tuple[int, list[str]]:
    """The answer about a folder in which cited statements lie with their certificates."""
    files = [other.files() for other in others]
    cited = [first for first, _ in files]
    return check.check_folders([check.Folder("main", *pair.files(), cited, files)])


def test_a_citation_is_closed_by_the_certificate_beside_it() -> None:
    other = cited()
    code, lines = with_proofs(citing(other), other)
    assert code == 0
    assert lines[-2] == "assumed c:law: sentence of law"
    assert lines[-1].endswith("; given c:law")
    assert lines[:1] == ["proved  row [L] lhs <= rhs"]


def test_citations_of_citations_are_closed_beside_it() -> None:
    first = cited()
    second = citing(first)
    second.statement["theorem"] = "SECOND"
    second.assume("own")
    third = Pair("THIRD").cite("s", second)
    third.row("row", ["<", "1", "s:c:root"], total("goal", "s:c:big"))
    assert with_proofs(third, second, first)[1][-1].endswith("; given s:own, s:c:law")
    code, lines = with_proofs(third, first)
    assert (code, lines[-1].partition(":")[0]) == (4, "MALFORMED")  # the second is not at hand


@pytest.mark.parametrize(
    ("other", "code", "says"),
    [(refused(), 1, "REFUSED big [L] lhs < rhs: found no addend that is positive"),
     (refuted(), 1, "REFUTED: CUBES's title: 2 needed proved"),
     (malformed(), 4, "steps: found none for ['false']")],
)  # fmt: skip
def test_a_cited_certificate_that_is_not_accepted(other: Pair, code: int, says: str) -> None:
    """The citing folder is not proved then, also where another one in the run closes it."""
    found, lines = with_proofs(citing(other), other)
    word = "cited certificate of"
    assert found == code
    if code == 4:
        assert lines == [f"MALFORMED: {word} {digest(other)}: {says}"]
    else:
        assert any(line.startswith(f"REFUSED {word} {digest(other)}: {says}") for line in lines)
        assert lines[-1] == "REFUSED: MAIN's title: not shown; refused above: 1"
    good, files = cited(), refused().files()
    folder = check.Folder("main", *citing(good).files(), [good.files()[0]], [files])
    proof = check.Folder("proof", *good.files(), [])
    assert check.check_folders([proof, folder])[0] == 1


def test_a_refused_folder_stays_refused_beside_a_good_certificate() -> None:
    other = cited()
    pair = citing(other).row("wrong", "1 < 1", INTERVAL)
    code, lines = with_proofs(pair, other)
    assert (code, lines[-1]) == (1, "REFUSED: MAIN's title: not shown; refused above: 1")


def test_the_certificate_of_another_statement_closes_nothing() -> None:
    """It is named after the cited statement, but its digest is another one."""
    other, changed = cited(), cited()
    changed.statement["title"] = "another"
    files = other.files()[0], changed.files()[1]
    folder = check.Folder("main", *citing(other).files(), [files[0]], [files])
    code, lines = check.check_folders([folder])
    assert code == 4
    assert f"cited certificate of {digest(other)}: statement_sha256: found" in lines[-1]


def test_a_theorem_that_cites_itself_is_not_closed_by_its_own_claim() -> None:
    """No file has its own digest in it; a certificate of one that claims to is malformed."""
    pair = Pair("SELF").row("row", "0 <= 1", INTERVAL)
    item = {"name": "c", "theorem": "SELF", "statement_sha256": digest(pair)}
    pair.statement["cites"].append(item)
    code, lines = with_proofs(pair, pair)
    assert (code, "whose statement is not at hand" in lines[-1]) == (4, True)


def test_certificates_that_are_cited_share_one_budget(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each is little work, and so is the folder itself; all of them are more than the limit."""
    others, pair = [], Pair("MAIN")
    for i in range(9):
        other = Pair(f"OTHER {i}").constant("c", "cos(1)", interval(bits=1000 + i))
        others.append(other.row("row", "0 <= 1", INTERVAL))
        pair.cite(f"c{i}", others[-1])
    pair.row("row", "0 <= 1", INTERVAL)
    available = {digest(other): other.files()[0] for other in others}
    works = [check.check(*files.files(), available).work for files in (pair, *others)]
    monkeypatch.setattr(check, "MAX_WORK", sum(works))
    assert with_proofs(pair, *others)[0] == 0
    monkeypatch.setattr(check, "MAX_WORK", sum(works) - 1)
    code, lines = with_proofs(pair, *others)
    says = f"cited certificate of {digest(others[-1])}: obligation row: found more work than the"
    assert (code, says in lines[-1]) == (4, True)
    folders = [check.Folder(str(i), *other.files(), []) for i, other in enumerate(others)]
    files = [other.files() for other in others]
    main = check.Folder("main", *pair.files(), [first for first, _ in files], files)
    code, lines = check.check_folders([*folders, main])  # where all are known to be proved
    assert (code, says in lines[-1]) == (4, True)


def write_folder(folder: Path, files: dict[str, bytes]) -> str:
    for name, data in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(data)
    return str(folder)


def test_where_a_cited_certificate_lies(tmp_path: Path, capsys: Any) -> None:
    other = cited()
    first, second = citing(other).files()
    files = {"statement.json": first, "certificate.json": second}
    files["cited/any-name.json"], files["cited/any-name.certificate.json"] = other.files()
    folder = write_folder(tmp_path / "main", files)
    assert check.main([folder]) == 0
    assert capsys.readouterr().out.endswith("; given c:law\n")
    (tmp_path / "main/cited/any-name.json").rename(tmp_path / "main/cited/other-name.json")
    assert check.main([folder]) == 2
    said = capsys.readouterr().err
    assert "found any-name.certificate.json in " in said
    assert "but no any-name.json beside it" in said


# --- sentences -----------------------------------------------------------------------------------


def test_sentences_of_printed_rows_are_told_apart() -> None:
    pair = Pair().assume("shared").assume("apart").assume("idle").assume("granted")
    pair.row("one", "0 <= 1", INTERVAL).row("two", "0 <= 1", INTERVAL, role="printed")
    pair.context("state", {"x": "1"}, {"x-pos": ("0 < x", "standing", "granted")})
    pair.statement["obligations"][0]["uses"] = ["shared"]
    pair.statement["obligations"][1]["uses"] = ["shared", "apart", "granted"]
    said = "; given shared, idle, granted; for printed rows only, also given apart"
    assert last(pair)[1].endswith(said)


def test_sentences_cited_count_even_if_only_printed_rows_use_them_there() -> None:
    """Any fact of a cited statement may be used, also that of a printed row."""
    other = cited().assume("apart")
    other.statement["obligations"][2]["uses"] = ["apart"]
    assert last(other)[1].endswith("; given law; for printed rows only, also given apart")
    assert with_proofs(citing(other), other)[1][-1].endswith("; given c:law, c:apart")


def test_a_point_of_theorem_1_is_given_the_sentences_of_the_step() -> None:
    stored = Path(check.__file__).parents[1] / "certificates"
    code, lines = check.check_folders(check.read_folders([str(stored / "theorem1-r-3-100")]))
    given = lines[-1].partition("; given ")[2].partition("; ")[0].split(", ")
    assert (code, lines[-1].startswith("PROVED: ")) == (0, True)
    assert given == [
        f"step:{name}"
        for name in (
            "hard-spheres", "cauchy-schwarz", "bounded-monotone", "finite-length",
            "open-condition", "glue-next",
            "glue-collapse", "glue-angle", "glue-interior",
        )
    ]  # fmt: skip
    assert "citing" not in lines[-1]
