"""Questions of SMT-LIB and ranges of FPCore: what real files mean, and what is said of others."""

from __future__ import annotations

import math
from fractions import Fraction
from pathlib import Path

import pytest

from verify import check
from verify.cli import main
from verify.language.terms import (
    Claim,
    as_term,
    cos,
    cos_pi,
    maximum,
    minimum,
    pi,
    sqrt,
    symbol,
    unequal,
)
from verify.wire.inputs import InputError
from verify.wire.text.estimates import estimate
from verify.wire.text.fpcore import read_fpcore
from verify.wire.text.smtlib import read_smtlib

X, Y = symbol("x"), symbol("y")

#: SMT-LIB, QF_NRA/meti-tarski, sqrt-problem-13-sqrt1-chunk-0018.smt2.
UNSAT = """
(set-info :smt-lib-version 2.6)
(set-logic QF_NRA)
(set-info :category "industrial")
(set-info :status unsat)
(declare-fun skoX () Real)
(declare-fun skoSS () Real)
(declare-fun skoSM () Real)
(assert (and (not (<= (- 2) skoSS)) (and (= (* skoX skoX) (+ 1 (* skoSS (* skoSS (- 1))))) (and
 (= skoX (+ 1 (* skoSM (* skoSM (- 1))))) (and (<= 0 skoSS) (and (<= 0 skoSM) (and
 (not (<= skoX 0)) (not (<= 1 skoX)))))))))
(check-sat)
(exit)
"""

#: The first file of SMT-LIB, QF_NRA/meti-tarski, in the version with decimal points.
SAT = """
(set-logic QF_NRA)
(declare-fun skoX () Real)
(declare-fun skoS () Real)
(declare-fun skoC () Real)
(assert (and (not (<= (* skoC (/ 3. 13.)) skoS)) (not (<= skoX 0.))))
(set-info :status sat)
(check-sat)
"""

#: FPBench, benchmarks/fptaylor-tests.fpcore.
RANGES = """
(FPCore (t)
  :name "intro-example"
  :cite (solovyev-et-al-2015)
  :pre (<= 0 t 999)
  (/ t (+ t 1)))

(FPCore (x y)
  :name "sec4-example"
  :cite (solovyev-et-al-2015)
  :precision binary64
  :pre (and (<= 1.001 x 2) (<= 1.001 y 2))
  (let ([t (* x y)])
    (/ (- t 1) (- (* t t) 1))))
"""


def run(tmp_path: Path, name: str, text: str) -> int:
    """The exit code of `verify prove`; what it writes is accepted."""
    path, out = tmp_path / name, tmp_path / "out"
    path.write_text(text, encoding="utf-8")
    code = main(["prove", str(path), "--out", str(out)])
    if code < 2:
        assert check.check_folders(check.read_folders([str(out)]))[0] == code
    return code


def test_unsat_has_a_certificate(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, "chunk.smt2", UNSAT) == 0
    last = " ".join(capsys.readouterr().out.split("Verdict: ")[1].split())
    assert last.startswith("proved: no real numbers satisfy the assertions of chunk.smt2")


def test_sat_has_a_solution(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(tmp_path, "chunk.smt2", SAT) == 1
    assert "false at skoX = 1, skoS = -1, skoC = 0" in " ".join(capsys.readouterr().out.split())


def test_ranges_are_proved(tmp_path: Path) -> None:
    assert run(tmp_path, "tests.fpcore", RANGES) == 0


@pytest.mark.parametrize(("low", "high"), [(-27, -8), (-8, 27), (-1, 0), (0, 1), (1, 64)])
def test_cube_roots_of_negative_numbers_are_negative(low: int, high: int, tmp_path: Path) -> None:
    text = f"(FPCore (x) :pre (<= {low} x {high}) (cbrt x))"
    claims = [row.claim for row in read_fpcore("f.fpcore", text.encode()).obligations]
    lowest, highest = estimate(claims[0].lhs, {}), estimate(claims[1].rhs, {})
    roots = [math.copysign(abs(a) ** (1 / 3), a) for a in (low, high)]
    spare = (roots[1] - roots[0]) / 40
    assert roots[0] - spare <= lowest <= roots[0] < roots[1] <= highest <= roots[1] + spare
    assert run(tmp_path, "roots.fpcore", text) == 0


def test_ranges_are_near_the_values() -> None:
    statement = read_fpcore("f.fpcore", RANGES.encode())
    low, high, *_ = [row.claim for row in statement.obligations]
    assert isinstance(low, Claim)
    assert isinstance(high, Claim)
    assert low.lhs == as_term(Fraction(-1, 100))
    assert high.rhs == as_term(Fraction(1009, 1000))  # the greatest value is 999/1000
    assert statement.contexts[1].says == "sec4-example"
    assert [v.letter for v in statement.contexts[1].variables] == ["x", "y"]


@pytest.mark.parametrize(
    ("text", "claim"),
    [
        ("(< (^ x 2) (pow y 3))", X**2 < Y**3),
        ("(<= (/ 1 3) (sqrt x))", as_term(Fraction(1, 3)) <= sqrt(X)),
        ("(> (- x y 1) (abs x))", maximum(X, -X) < X - Y - 1),
        ("(distinct (+ x y 1.5) (max x y))", unequal(X + Y + Fraction(3, 2), maximum(X, Y))),
        ("(< 0 (cos (* real.pi x)))", 0 < cos_pi(X)),
        ("(< 0 (cos (/ (* x pi) 2)))", 0 < cos_pi(X / 2)),
        ("(< 0 (cos (+ x pi)))", 0 < cos(X + pi)),
        ("(< 0 (ite (<= x y) x y))", 0 < minimum(X, Y)),
        ("(< 0 (ite (> x y) y x))", 0 < minimum(Y, X)),
        ("(< 0 (ite (>= x 0) x (- x)))", 0 < maximum(X, -X)),
        ("(< 0 (ite (< x 0) (- x) x))", 0 < maximum(X, -X)),
    ],
)
def test_operations(text: str, claim: Claim) -> None:
    content = f"(declare-const x Real)(declare-const y Real)(assert (not {text}))"
    (row,) = read_smtlib("f.smt2", content.encode()).statement.obligations
    assert row.claim == claim


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("(declare-fun x () Int)", "line 1: 'x' is of the sort Int; declare it Real"),
        ("(assert (< x 1))", "line 1: 'x' is not known; declare it before"),
        ("(declare-const x Real)\n(assert (< (foo x) 1))", "line 2: the operation 'foo' cannot"),
        ("(declare-const x Real)\n(assert (< x 1)", "line 2: a parenthesis that opens here"),
        ("(assert true))", "line 1: a parenthesis closes that was not opened"),
        ("(declare-const x Real)(assert (iff (< x 1) (< x 2)))", "the operation 'iff' cannot be"),
        ("(declare-const x Real)(assert (< (^ x y) 2))", "'y' is not known; "),
        (
            "(declare-const x Real)(assert (< (^ x 0.003) 2))",
            "'^' of 2 terms: an exponent has to be",
        ),
        ("(declare-const x Real)(assert x)", "'x' is a number, where a formula is meant"),
        ("(assert (< (< 1 2) 3))", "'<' is a formula, where a number is meant"),
        ("(forall x)", "the command 'forall' cannot be used"),
        ("(declare-const e1 Real)(assert (< 0 1e1))", "or followed by the name e1; choose another"),
        ("(declare-const /3 Real)(assert (< 0 1/3))", "or followed by the name /3; choose another"),
        ("(declare-const .e5 Real)(assert (< 0 1.e5))", "or followed by the name .e5; choose"),
        ("(declare-const . Real)(assert (< 0 -1.))", "or followed by the name .; choose another"),
        ("(define-fun |1| ((a Real)) Real a)(assert (< (1 5) 9))", "the operation '1' cannot be"),
        ("(push |1|)", "this push cannot be used"),
        ("(assert (! true |:named| n))", "an annotation cannot be used here"),
        ("(assert (|!| true :named n))", "the operation '!' cannot be used"),
        ("(|exit|)", "the command 'exit' cannot be used"),
        ("(exit 3)", "this exit cannot be used; write (exit)"),
        ("(assert (not))", "line 1: 'not' stands alone"),
        ("(assert (not true true))", "line 1: 'not' of 2 parts is no formula"),
        ("(assert (=> true))", "line 1: '=>' of 1 parts is no formula"),
        ("(assert (!))", "line 1: an annotation cannot be used here"),
        ("(assert (let ((y ())) (< y 0)))", "an operation is missing after the parenthesis"),
        ("(assert (let ((y (let))) (< y 0)))", "line 1: a let needs a list of pairs, and a body"),
        ("(assert ())", "f.smt2: an operation is missing after the parenthesis"),
        ("(assert (< (!) 0))", "line 1: an annotation cannot be used here"),
        (f"(assert (< {'(+ 1 ' * 5000}1{')' * 5000} 0))", "f.smt2: it nests too deeply"),
        (f"(assert {'(not ' * 5000}true{')' * 5001}", "f.smt2: it nests too deeply"),
        ("(declare-const x Real)\n(declare-const x Real)", "line 2: 'x' is declared twice"),
        ("(set-logic QF_NIA)", "line 1: this set-logic cannot be used; write (set-logic QF_NRA)"),
        ('(set-info :source "abc)', "line 1: '\"' has no end; close the quotation"),
    ],
)
def test_what_is_said_of_other_files(text: str, says: str) -> None:
    with pytest.raises(InputError) as error:
        read_smtlib("f.smt2", text.encode())
    assert str(error.value).startswith("f.smt2")
    assert says in str(error.value)


def test_a_term_that_only_the_checker_finds_deep(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    declare, name = "declare a constant for a part", "name its parts"
    for depth, code, says in ((60, 0, ""), (120, 2, declare), (290, 2, declare), (310, 2, name)):
        file = tmp_path / "deep.smt2"
        term = f"{'(+ 1 ' * depth}x{')' * depth}"
        file.write_text(f"(declare-const x Real)(assert (< 0 x))(assert (< {term} 0))(check-sat)")
        assert main(["prove", str(file)]) == code
        assert (f"nests too deeply; {says}" in capsys.readouterr().err) == bool(code)


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("(FPCore (x) (* x x))", "line 1: x has no bounds; write for example :pre (<= 0 x 1)"),
        ("(FPCore (x) :pre (<= 0 x 1) (while (< x 1) ()))", "the operation 'while' cannot be used"),
        (
            "(FPCore (x) :pre (<= 2 x 1) x)",
            "no input was found that satisfies :pre",
        ),
        ("(FPCore ((A 3)) 1)", "an input has to be a name; sizes cannot be used"),
        ("(FPCore x)", "is no expression; write (FPCore (x) ... (* x x))"),
        ("(FPCore (x) :pre (or (< x 1) (< 2 x)) x)", "write the precondition as comparisons"),
        ("(FPCore (x y x) :pre (< 0 x 1) (+ x 1))", "line 1: 'x' is an argument twice"),
        ("(FPCore (x) :pre (< 0 x 1) (min))", "line 1: 'min' stands alone"),
        (
            f"(FPCore (x) :pre (< 0 x 1) {'(+ x ' * 5000}x{')' * 5001}",
            "f.fpcore: it nests too deeply",
        ),
        ("", "f.fpcore: has no expression"),
    ],
)
def test_what_is_said_of_other_cores(text: str, says: str) -> None:
    with pytest.raises(InputError) as error:
        read_fpcore("f.fpcore", text.encode())
    assert says in str(error.value)


@pytest.mark.parametrize(
    ("claim", "says"),
    [
        ("(== x 1)", "write ="),
        ("(=< x 1)", "write <="),
        ("(!= x 1)", "write distinct"),
        ("(<> x 1)", "write distinct"),
        ("(< (** x 2) 1)", "write ^"),
        ("(forall ((y Real)) (< x y))", "not read"),
        ("(is_int x)", "not read"),
    ],
)
def test_signs_of_other_languages(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], claim: str, says: str
) -> None:
    assert run(tmp_path, "a.smt2", f"(declare-const x Real)(assert {claim})(check-sat)") == 2
    assert says in capsys.readouterr().err


def test_a_number_of_fpcore_is_one_word() -> None:
    """FPCore has no words side by side: an input may be called like the end of a number."""
    statement = read_fpcore(
        "f.fpcore", b"(FPCore (e1 /3) :pre (and (<= 0 e1 1e1) (<= 0 /3 1/3)) e1)"
    )
    ten, third = as_term(10), as_term(Fraction(1, 3))
    sides = [given.claim.rhs for given in statement.contexts[0].givens]
    assert {ten, third} <= {*sides}
