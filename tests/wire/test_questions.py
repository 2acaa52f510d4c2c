"""What is asked in a file of SMT-LIB: scopes, names, the rows of each question, what is refused."""

from __future__ import annotations

import json
import resource
from itertools import permutations
from pathlib import Path

import pytest

from tests.cpu import seconds_of
from verify.cli import main
from verify.prover.budget import WorkBudget
from verify.wire.inputs import InputError
from verify.wire.questions import decide_page, read_page_of
from verify.wire.text.fpcore import read_fpcore
from verify.wire.text.smtlib import read_smtlib

PROVED, REFUTED, UNDECIDED = "proved", "refuted", "undecided"
X = "(declare-const x Real)"
B = "(declare-const p Bool)(declare-fun q () Bool)"


def verdicts(text: str, work: int = 3_000_000) -> list[str]:
    """What becomes of the rows of a file."""
    outcome = decide_page(read_page_of("f.smt2", text.encode(), {}), WorkBudget(work))
    return [found.verdict for _, found in outcome.rows]


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        # Each scope for itself, as in ordinary files of incremental solvers.
        (
            (
                f"{X}(push 1)(assert (< x 0))(check-sat)(pop 1)(push 1)(assert (> x 0))(check-sat)"
                "(pop 1)"
            ),
            [REFUTED, REFUTED],
        ),
        (f"{X}(push)(assert (< x 0))(pop)(assert (> x 0))(check-sat)", [REFUTED]),
        (f"{X}(push 2)(assert (< x 0))(pop 1)(assert (> x 0))(check-sat)", [REFUTED]),
        (f"{X}(push 2)(assert (< x 0))(pop 2)(assert (> x 0))(check-sat)", [REFUTED]),
        (f"{X}(assert (< x 0))(push 1)(assert (> x 0))(check-sat)(pop 1)", [PROVED]),
        (f"{X}(push 0)(assert (< x 0))(pop 0)(assert (> x 0))(check-sat)", [PROVED]),
        # dReal's andrea_callia_01.smt2.
        (
            (
                "(set-logic QF_NRA)(declare-fun x () Real)(assert (> x 0.0))(assert (< x 2.0))"
                "(check-sat)(assert (> x 5.0))(check-sat)(exit)"
            ),
            [REFUTED, PROVED],
        ),
        (f"{X}(assert (< x 0))(exit)(assert (> x 0))(check-sat)", [REFUTED]),
        (f"{X}(assert (< x 0))(check-sat)(exit)(nonsense)(assert (> x 0))(check-sat)", [REFUTED]),
        (f"{X}(assert (< x 0))(check-sat)(assert (> x 0))", [REFUTED]),
        (f"{X}(assert (< x 0))(reset-assertions){X}(assert (> x 0))(check-sat)", [REFUTED]),
        (f"{X}(assert (< x 0))(push 3)(reset){X}(assert (> x 0))(check-sat)", [REFUTED]),
        # A name of a scope that was left may be declared again, as something else.
        (
            (
                "(push 1)(define-fun p () Bool true)(pop 1)(declare-const p Real)(assert (< p 0))"
                "(check-sat)"
            ),
            [REFUTED],
        ),
        # An inner name hides an outer one, whatever the two are.
        (
            (
                f"{X}(declare-const q Real)(assert (= q 1))(assert (= x (- 5)))"
                "(assert (let ((p (< x 0))) (let ((p (+ x 1))) (let ((q p)) (< q 0)))))(check-sat)"
            ),
            [REFUTED],
        ),
        (f"{X}(define-fun p () Bool (< x 0))(assert (let ((p x)) (> p 0)))(check-sat)", [REFUTED]),
        (f"{X}(assert (let ((x (+ x 1)) (y x)) (and (= x 1) (= y 0))))(check-sat)", [REFUTED]),
        (
            f"{X}(define-fun f ((x Real)) Real (+ x 1))(assert (= (f (f x)) 5))(check-sat)",
            [REFUTED],
        ),
        # A function means what stood around its definition.
        (
            (
                f"{X}(define-fun f ((y Real)) Real (+ x y))(assert (let ((x 7)) (= (f x) 7)))"
                "(assert (< x 0))(check-sat)"
            ),
            [PROVED],
        ),
        ("(declare-const |x| Real)(assert (< x 0))(assert (> |x| 0))(check-sat)", [PROVED]),
        ("(declare-const |5| Real)(assert (= |5| 6))(check-sat)", [REFUTED]),
        (f"{X}(assert (! (< x 0) :named p))(assert (not p))(check-sat)", [PROVED]),
        # Nothing is asserted; what is asserted says nothing, or contradicts itself.
        ("(check-sat)", [REFUTED]),
        ("(assert true)(check-sat)", [REFUTED]),
        ("(assert false)(check-sat)", [PROVED]),
        ("(assert (< 1 2))(check-sat)", [REFUTED]),
        ("(assert (< 2 1))(check-sat)", [PROVED]),
        ("(assert (and (< 1 2) (<= 3 3)))(check-sat)", [REFUTED]),
        (f"{X}(assert (or (< x 0) (> x 0)))(assert (not (distinct x 0)))(check-sat)", [PROVED]),
        # Constants of the sort Bool are cases, and what is assumed holds for one question.
        (
            f"{X}{B}(assert (= p (< x 0)))(assert (=> q p))(assert (and q (< 1 x)))(check-sat)",
            [PROVED],
        ),
        (
            f"{X}{B}(assert (= p (< x 0)))(assert (=> q p))(assert (and p (< 1 x)))(check-sat)",
            [PROVED],
        ),
        (
            f"{X}{B}(assert (= p (< x 0)))(assert (=> q p))(assert (< 1 x))(assert q)(check-sat)",
            [PROVED],
        ),
        (f"{X}{B}(assert (= p (< x 0)))(assert (not p))(assert (< 1 x))(check-sat)", [REFUTED]),
        (f"{B}(assert (xor p q))(assert (or (not p) q))(assert (not q))(check-sat)", [PROVED]),
        (f"{B}(assert (xor p q))(check-sat)", [REFUTED]),
        (f"{X}{B}(assert (< (ite p x (- x)) 0))(assert (< 0 x))(assert p)(check-sat)", [PROVED]),
        (
            (
                f"{X}{B}(assert (= p (< x 0)))(check-sat-assuming (p (not q)))(assert (< 1 x))"
                "(check-sat-assuming (p))(check-sat-assuming ((not p)))(check-sat-assuming ())"
            ),
            [REFUTED, PROVED, REFUTED, PROVED, REFUTED],
        ),
        (
            "(push)(declare-const p Bool)(assert p)(pop)(declare-const p Bool)(assert (not p))",
            [REFUTED],
        ),
        # A bound of a modulus or minimum is two bounds.
        (f"{X}(assert (<= (abs x) 2))(assert (< x (- 1)))(check-sat)", [REFUTED]),
        (f"{X}(assert (< (ite (< x 0) (- x) x) 2))(assert (>= (* x x) 4))(check-sat)", [PROVED]),
        (f"{X}(assert (< 1 (min x (- 3 x))))(assert (< 2 x))(check-sat)", [PROVED]),
        # No point of all but one assertion: the rest is denied together.
        (
            (
                f"{X}(declare-const y Real)(assert (< x 0))(assert (<= 0 x))(assert (< y 0))"
                "(assert (<= 0 y))(check-sat)"
            ),
            [PROVED],
        ),
        (f"{X}(assert (and (< (* x x) 0) (= (* x x) (- 1))))(check-sat)", [PROVED]),
        ("; (assert false)\n(declare-const x Real)(assert (< x 0));)\n(check-sat)", [REFUTED]),
        ('(set-info :source "(assert false)"" (")(declare-const x Real)(check-sat)', [REFUTED]),
    ],
)
def test_what_each_question_asks(text: str, wanted: list[str]) -> None:
    assert verdicts(text) == wanted


@pytest.mark.parametrize(
    "command",
    [
        *("(check-sat-assuming (p))", "(check-sat-assuming)", "(check-sat-assuming (x))"),
        *(
            "(declare-const x Bool)",
            "(declare-const b Int)",
            "(declare-const b Bool)(assert (< b x))",
        ),
        *("(define-sort R () Real)", "(declare-sort S 0)"),
        *("(define-fun-rec f ((x Real)) Real x)", "(define-funs-rec () ())", "(maximize x)"),
        *("(declare-datatypes () ())", "(declare-datatype L ())", "(minimize x)", "(check)"),
        *("(set-option :global-declarations true)", "(set-option :smt.arith.solver 2)"),
        *("(declare-fun f (Real) Real)", "(declare-fun f (Bool) Bool)", "(declare-fun x () Real)"),
        *("(define-fun x () Real 1)", "(define-fun f ((y Real) (y Real)) Real y)", "(pop 1)"),
        *("(define-fun f ((y Real)) Real z)", "(define-fun f () Real (< x 1))", "(push x)"),
        *("(push 0000000001)", "(pop 0)(pop 1)"),
        *("(define-fun f ((y Int)) Real y)", "(assert (forall ((y Real)) (< y x)))", "(pop -1)"),
        *(
            "(assert (let ((y x) (y 1)) (< y 0)))",
            "(assert (let ((5 x)) (< x 0)))",
            "(check-sat 1)",
        ),
        *("(assert (= x E))", "(declare-const and Real)", "(declare-const |let| Real)"),
        *("(assert (< x 0) (< x 1))", "(assert (! (< x 0) :pattern (x)))", "(push 1000000000)"),
        *("(|assert| (< x 0))", "(set-logic QF_LIA)", "(declare-const 5 Real)", "(assert (x 1))"),
        *(
            "(assert (< (! x :named y) 1))",
            "(assert (< x é))",
            "[assert (< x 0)]",
            "(assert (< x 1]",
        ),
        *("; a comment\r(assert (< x 0))", "(reset 1)", "(assert (and))", '(include "f")'),
    ],
)
def test_what_is_not_understood_is_refused_with_its_line(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "f.smt2"
    path.write_bytes(f"{X}\n(assert (< x 0))\n{command}\n(check-sat)\n".encode())
    assert main(["prove", str(path)]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.count("\n") == 1
    assert "line 3: " in told.err


@pytest.mark.parametrize(
    ("body", "declared"),
    [
        ("(+ y pi)", "(declare-const pi Real)"),
        ("(+ y real.pi)", "(define-fun real.pi () Real 1)"),
        ("(abs y)", "(define-fun abs ((z Real)) Real (- z))"),
        ("(sin (cos y))", "(push 1)(define-fun cos ((z Real)) Real z)"),
    ],
)
def test_a_word_of_a_defined_function_keeps_its_meaning(body: str, declared: str) -> None:
    """With the new meaning, f(2) of the second file would be -2."""
    text = f"(define-fun f ((y Real)) Real {body})\n{declared}\n(assert (= (f 2) 2))(check-sat)"
    with pytest.raises(InputError, match=r"f\.smt2, line 2: .* choose another name"):
        read_smtlib("f.smt2", text.encode())
    assert read_smtlib("f.smt2", "\n".join(text.split("\n")[1:]).replace("f 2", "+ 1 1").encode())


def test_the_worst_answer_is_the_exit_code(tmp_path: Path) -> None:
    path = tmp_path / "f.smt2"
    refuted, proved = (
        "(push 1)(assert (< x 0))(check-sat)(pop 1)",
        "(assert (< (* x x) 0))(check-sat)",
    )
    for text, code in ((refuted + proved, 1), (proved, 0), (proved + proved, 0)):
        path.write_text(X + text)
        assert main(["prove", str(path)]) == code


def test_a_witness_has_all_variables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "f.smt2"
    path.write_text(f"{X}(declare-const |a b| Real)(assert (< x 0))(assert (= |a b| 3))(check-sat)")
    assert main(["prove", str(path), "--json"]) == 1
    (row,) = json.loads(capsys.readouterr().out)["obligations"]
    assert row["witness"] == {"x": "-1", "v-a_20_b": "3"}


# --- names ---------------------------------------------------------------------------------------

OURS = (
    *(
        "goal",
        "core1",
        "core-1",
        "case1",
        "g1",
        "l.1",
        "t.1",
        "u.1",
        "check-1",
        "asserted-1",
        "sin",
    ),
    *("asserted-1.1", "asserted-1.less-", "pi", "cos_pi", "a-b", "a_b", "a.b", "v-a", "v-_1", "e"),
)


def test_names_of_a_file_stay_different_and_are_none_of_ours() -> None:
    declared = "".join(f"(declare-const {name} Real)" for name in OURS)
    chain = f"(assert (< {' '.join(OURS)}))"
    cases = "(assert (or (< goal 0) (> goal 0)))"
    text = f"{declared}{chain}{cases}(check-sat)(assert (< 0 e))(check-sat)"
    statement = read_smtlib("f.smt2", text.encode()).statement
    names = [v.name for context in statement.contexts for v in context.variables]
    names += [given.name for context in statement.contexts for given in context.givens]
    names += [context.name for context in statement.contexts]
    names += [row.name for row in statement.obligations]
    assert len({*names}) == len(names) > 4 * len(OURS)


def test_names_of_fpcore_stay_different() -> None:
    inputs = " ".join(name for name in OURS if name not in ("pi",))
    bounds = " ".join(f"(<= 0 {name} 1)" for name in inputs.split())
    core = f"(FPCore ({inputs}) :pre (and {bounds}) (- a-b a_b))"
    statement = read_fpcore("f.fpcore", f"{core}{core}".encode())
    names = [v.name for context in statement.contexts for v in context.variables]
    names += [item.name for context in statement.contexts for item in (context, *context.givens)]
    names += [row.name for row in statement.obligations]
    assert len({*names}) == len(names)
    letters = [variable.letter for variable in statement.contexts[0].variables]
    assert len({*letters}) == len(OURS) - 1


@pytest.mark.parametrize(
    "core",
    [
        "(FPCore (x) :pre (<= 0 x 1) :pre (<= 0 x 2) x)",
        "(FPCore (x) :pre (<= 0 x 1) name x)",
        "(FPCore (x) :pre (or (<= 0 x 1) (<= 2 x 3)) x)",
        "(FPCore (x) :pre (= 0 x) x)",
        "(FPCore (x) :pre (<= 0 x 1) (if (< x 1/2) x (* x x)))",
        "(FPCore (|x|) :pre (<= 0 x 1) x)",
        "(FPCore (x 5) :pre (<= 0 x 1) x)",
        "(FPCore (x let) :pre (<= 0 x 1) x)",
        "(FPCore (x] :pre (<= 0 x 1) x)",
    ],
)
def test_what_is_not_understood_of_fpcore_is_refused(core: str) -> None:
    with pytest.raises(InputError, match=r"f\.fpcore, line 1: "):
        read_fpcore("f.fpcore", core.encode())


def test_many_expressions_are_sampled_together() -> None:
    core = "(FPCore (x) :pre (<= 0 x 1) (+ (* x x) (sin (* x {}))))"
    text = "".join(map(core.format, range(250)))
    seconds, statement = seconds_of(lambda: read_fpcore("f.fpcore", text.encode()))
    assert len(statement.obligations) == 500
    assert seconds < 7.5
    with pytest.raises(InputError, match="more than 256 expressions; split the file"):
        read_fpcore("f.fpcore", "".join(map(core.format, range(257))).encode())


def test_texts_of_fpcore_end_where_they_end() -> None:
    core = r'(FPCore (x) :name "a\" :pre (<= 5 x 6) \"" :pre (<= 0 x 1) (! :precision binary32 x))'
    (context,) = read_fpcore("f.fpcore", core.encode()).contexts
    assert [given.claim.rhs.op for given in context.givens].count("symbol") == 1


# --- one answer, whatever the order ---------------------------------------------------------------

ASSERTED = (
    "(<= (- 2) x 2)",
    "(<= (- 2) y 2)",
    "(= (+ (* x x) (* y y)) 1)",
    "(or (< (* x y) (- 0.51)) (> (* x y) 0.51))",
)


def test_the_order_of_assertions_does_not_matter() -> None:
    found = set()
    for order in permutations(ASSERTED):
        asserted = "".join(f"(assert {formula})" for formula in order)
        text = f"{X}(declare-const y Real){asserted}(check-sat)"
        found.add(repr(read_smtlib("f.smt2", text.encode()).statement))
    assert len(found) == 1
    assert verdicts(text) == [PROVED, PROVED]


#: Bounds before and behind a claim of `inequalities.json`: schwefel, and the lower bound of
#: affine arithmetic for a polynomial of Legendre.
SWAPPED = {
    "magnetism": (
        ("(<= (- 1) x 1)", "(<= (- 1) y 1)"),
        "(not (< (- 0.26) (- (+ (* x x) (* 2 (* y y))) x)))",
    ),
    "heart": (("(<= 0 x 1)", "(<= 2 y 3)"), "(>= (* x (sin y)) (+ 1 (/ x y)))"),
}


@pytest.mark.parametrize("name", SWAPPED)
def test_bounds_may_stand_behind_a_claim(name: str) -> None:
    bounds, claim = SWAPPED[name]
    for formulas in ((*bounds, claim), (claim, *bounds)):
        asserted = "".join(f"(assert {formula})" for formula in formulas)
        assert verdicts(f"{X}(declare-const y Real){asserted}(check-sat)") == [PROVED]


def test_another_form_is_tried_where_the_first_is_not_decided() -> None:
    text = f"{X}(push 1)(assert (< (exp x) (exp 1)))(assert (<= 1 x))(check-sat)(pop 1)(check-sat)"
    assert verdicts(text) == [PROVED, REFUTED]


# --- bombs ---------------------------------------------------------------------------------------


def _equations(count: int, last: str) -> str:
    """Linear equations with one solution, and a last assertion."""
    names = [f"x{i}" for i in range(count)]
    text = "".join(f"(declare-const {name} Real)" for name in names)
    for i, name in enumerate(names):
        other, third = names[(i + 1) % count], names[(i + 3) % count]
        text += f"(assert (= (+ {name} (* {i + 2} {other}) (- {third})) {i}))"
    return f"{text}(assert {last})(check-sat)"


@pytest.mark.parametrize("count", [7, 40])
def test_where_the_point_of_the_givens_refutes_nothing_else_is_tried(count: int) -> None:
    """Seven took a minute, and were undecided then."""
    solved = _equations(count, "(< x1 x0)")
    assert verdicts(solved, 300_000) == [REFUTED]
    assert verdicts(_equations(count, "(< x0 x1)"), 300_000) != [REFUTED]


def test_numbers_and_choices_without_end_are_not_looked_at() -> None:
    """Each file took more than 20 seconds, or more than a gigabyte."""
    power = f"{X}(assert (= x (^ (^ (^ 9 999) 999) 999)))"
    assert read_smtlib("f.smt2", power.encode()).statement.obligations
    names = [f"x{i}" for i in range(300)]
    declared = "".join(f"(declare-const {name} Real)" for name in names)
    for count, why in ((200, "more than 64 cases"), (300, "too many pairs")):
        text = f"{declared}(assert (distinct {' '.join(names[:count])}))(check-sat)"
        with pytest.raises(InputError, match=why):
            read_smtlib("f.smt2", text.encode())


def test_the_points_of_all_questions_are_looked_for_together() -> None:
    """A point of each question alone would take two seconds."""
    names = [f"x{i}" for i in range(60)]
    text = "".join(f"(declare-const {name} Real)" for name in names)
    for i, name in enumerate(names):
        other, third = names[(7 * i + 1) % 60], names[(i + 3) % 60]
        text += f"(push 1)(assert (> (* {name} {other}) (+ {third} 1)))(check-sat)"
    seconds, questions = seconds_of(lambda: read_smtlib("f.smt2", text.encode()))
    assert len(questions.statement.obligations) == len(names)
    assert seconds < 10


def test_assertions_that_make_a_long_statement_are_refused() -> None:
    text = X + "(push 1)(assert (< x 1))(check-sat)" * 250
    with pytest.raises(InputError, match=r"line 1: .* assertions together; split the file"):
        read_smtlib("f.smt2", text.encode())


def _chain(count: int, line: str) -> str:
    """Lines in which {1} is the number before {0}."""
    return "".join(line.format(i, i - 1) for i in range(1, count))


def _terms(line: str) -> str:
    """The same with x as the first of the terms t."""
    return _chain(60, line).replace("t0", "x")


P0, T0 = "(define-fun p0 () Bool (< x 0))", "(define-fun t0 () Real (+ x 1))"
F0 = "(define-fun f0 ((y Real)) Real (+ y 1))"
MODULUS = "(define-fun f ((x Real)) Real (ite (< x 0) (- x) x))"
LETS = f"{_terms('(let ((t{0} (* t{1} t{1}))) ')}(< t59 0){')' * 59}"
BOMBS = {
    "and": P0 + _chain(60, "(define-fun p{0} () Bool (and p{1} p{1}))") + "(assert p59)",
    "or": P0 + _chain(60, "(define-fun p{0} () Bool (or p{1} (=> p{1} p{1})))") + "(assert p59)",
    "equality": P0 + _chain(60, "(define-fun p{0} () Bool (= p{1} (not p{1})))") + "(assert p59)",
    "squares": T0 + _chain(60, "(define-fun t{0} () Real (* t{1} t{1}))") + "(assert (< t59 0))",
    "squares in let": f"(assert {LETS})",
    "moduli": MODULUS + _terms("(define-fun t{0} () Real (- (f t{1}) 1))") + "(assert (< t59 0))",
    "functions": F0
    + _chain(60, "(define-fun f{0} ((y Real)) Real (f{1} (f{1} y)))")
    + "(assert (< (f59 x) 0))",
    "cases": _chain(30, "(assert (or (< x {0}) (> (* x x) {0})))"),
    "conditions": f"(assert (< {_chain(30, '(+ (ite (< x {0}) 1 x) ')}x{')' * 29} 0))",
    "scopes": "(push 900)" * 1000,
    "questions": "(check-sat)" * 9000,
    "a chain": "(define-fun p0 () Bool true)"
    + _chain(2000, "(define-fun p{0} () Bool (and (< x {0}) p{1}))")
    + "(assert p1999)",
}


@pytest.mark.parametrize("name", BOMBS)
def test_what_doubles_is_read_once_or_refused(name: str, tmp_path: Path) -> None:
    path = tmp_path / "f.smt2"
    path.write_text(f"{X}{BOMBS[name]}(check-sat)", encoding="utf-8")
    before = resource.getrusage(resource.RUSAGE_SELF)
    code = main(["prove", str(path), "--time", "2"])
    after = resource.getrusage(resource.RUSAGE_SELF)
    assert code in (0, 1, 2, 3)
    assert after.ru_utime - before.ru_utime < 10
    assert after.ru_maxrss - before.ru_maxrss < 200_000


def test_squares_in_fpcore_are_not_written_out(tmp_path: Path) -> None:
    path = tmp_path / "f.fpcore"
    lets = _chain(40, "(let ((t{0} (* t{1} t{1}))) ").replace("t0", "x")
    path.write_text(f"(FPCore (x) :pre (<= 0 x 1) {lets}t39{')' * 40}", encoding="utf-8")
    assert main(["prove", str(path), "--time", "2"]) in (0, 3)


def test_a_row_that_a_given_needs_has_no_other_forms(monkeypatch: pytest.MonkeyPatch) -> None:
    """The sign of a divisor was proved; the time was over where it was to be proved again."""
    now = [0.0]

    def watch(name: str) -> None:
        if "defined" not in name:
            now[0] = 80.0

    monkeypatch.setattr("verify.prover.budget.monotonic", lambda: now[0])
    text = (
        f"{X}(declare-const y Real)(assert (and (<= (- 2) x 2) (<= 0 y 1)))"
        "(assert (xor (or (= (+ 1 0.5 2) (+ (- 1 y) 1 0.5)) (> (/ (/ 1 3) (+ 1 (* x x))) 0.5))"
        "(<= (- (/ 1 3)) (* x x))))(assert (xor (< (- x) x) (distinct 1 (/ 0.5 3))))"
        "(assert (> (* 2 2) (+ 2 0.5 2)))(check-sat)"
    )
    page = read_page_of("f.smt2", text.encode(), {})
    outcome = decide_page(page, WorkBudget(seconds=100, watch=watch))
    assert any("defined" in row.name for row, _ in outcome.rows)
    assert outcome.claimed == UNDECIDED


def test_a_proof_with_a_number_that_the_checker_does_not_read(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """It is undecided, and no error of our own."""
    path = tmp_path / "p.toml"
    path.write_text(
        'title = "t"\n[contexts.c]\nvariables = "t"\ngiven = ["1 <= t"]\n'
        'rows = { row = "1/(2*t^2) <= 2/(1e-4000 + 1)^2", other = "0 <= t" }\n'
    )
    assert main(["prove", str(path)]) == 3
    assert "proved    other" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("constant", "says"),
    [
        ('{ value = "0", choose = "down" }', "the bound of half is not positive; write its value"),
        ('{ value = "-1/3", choose = "up" }', "the bound of half is not positive; write its value"),
        ('{ value = "1", choose = "up", above = "1" }', "the bound of half is not above 1; write"),
    ],
)
def test_a_constant_that_cannot_be_chosen_is_named(
    capsys: pytest.CaptureFixture[str], tmp_path: Path, constant: str, says: str
) -> None:
    page = f'title = "t"\n[constants]\nhalf = {constant}\n[rows]\nrow = "half < 2"\n'
    (tmp_path / "page.toml").write_text(page)
    assert main(["prove", str(tmp_path / "page.toml")]) == 2
    assert says in capsys.readouterr().err
