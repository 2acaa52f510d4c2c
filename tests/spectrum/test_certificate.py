"""The two files: the checker accepts them, and a second reading of the format agrees."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable
from fractions import Fraction
from hashlib import sha256
from math import comb
from pathlib import Path
from typing import Any

import mpmath
import pytest
import sympy

from verify.jobs.spectrum import decide
from verify.wire.spectrum_wire import files

ROOT = Path(__file__).resolve().parents[2]
BITS = 400

Files = tuple[dict[str, Any], dict[str, Any]]


@pytest.fixture(scope="module")
def contents() -> dict[str, bytes]:
    return files(decide())


@pytest.fixture(scope="module")
def documents(contents: dict[str, bytes]) -> Files:
    return json.loads(contents["statement.json"]), json.loads(contents["certificate.json"])


@pytest.fixture
def folder(contents: dict[str, bytes], tmp_path: Path) -> Path:
    for name, content in contents.items():
        (tmp_path / name).write_bytes(content)
    return tmp_path


def check(folder: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-I", str(ROOT / "verify" / "check.py"), str(folder)]
    return subprocess.run(command, capture_output=True, text=True)


def test_the_checker_accepts_the_certificate(folder: Path) -> None:
    result = check(folder)
    assert result.returncode == 0, result.stdout[-2000:] + result.stderr[-2000:]


def change(folder: Path, name: str, alter: Callable[[dict[str, Any]], None]) -> None:
    """Alter the row and the proof of one obligation, and renew the digest."""
    statement = json.loads((folder / "statement.json").read_text())
    certificate = json.loads((folder / "certificate.json").read_text())
    row = next(row for row in statement["obligations"] if row["name"] == name)
    proof = next(proof for proof in certificate["proofs"] if proof["obligation"] == name)
    alter({"row": row, "proof": proof})
    data = json.dumps(statement).encode()
    certificate["statement_sha256"] = sha256(data).hexdigest()
    (folder / "statement.json").write_bytes(data)
    (folder / "certificate.json").write_text(json.dumps(certificate))


def wrong_side(parts: dict[str, Any]) -> None:
    relation, lhs, rhs = parts["row"]["claim"]
    parts["row"]["claim"] = [relation, lhs, ["add", rhs, "1/64"]]


def wrong_sign(parts: dict[str, Any]) -> None:
    relation, lhs, rhs = parts["row"]["claim"]
    parts["row"]["claim"] = [relation, rhs, lhs]


def wrong_interval(parts: dict[str, Any]) -> None:
    parts["row"]["variables"] = {name: ["-9", "9"] for name in parts["row"]["variables"]}


def wrong_point(parts: dict[str, Any]) -> None:
    parts["proof"]["point"]["r"] = "1"


def true_point(parts: dict[str, Any]) -> None:
    parts["proof"]["point"]["u_4"] = "0"


def lower_degree(parts: dict[str, Any]) -> None:
    parts["proof"]["degree"] -= 1


@pytest.mark.parametrize(
    ("name", "alter"),
    [
        ("characteristic", wrong_side),
        ("matrix", wrong_side),
        ("entry-3-2", wrong_side),
        ("Q-prime-positive", wrong_sign),
        ("q-negative", wrong_sign),
        ("Q-minus-r-negative", wrong_interval),
        ("m-increasing", wrong_sign),
        ("matrix-stated", wrong_point),
        ("matrix-stated", true_point),
        ("x-multiple-1", lower_degree),
        ("r_exist-above", wrong_sign),
    ],
)
def test_the_checker_refuses_a_lie(
    folder: Path, name: str, alter: Callable[[dict[str, Any]], None]
) -> None:
    change(folder, name, alter)
    result = check(folder)
    assert result.returncode in (1, 4), result.stdout[-2000:] + result.stderr[-2000:]


def test_statement_and_certificate_belong_together(
    contents: dict[str, bytes], documents: Files
) -> None:
    statement, certificate = documents
    assert certificate["statement_sha256"] == sha256(contents["statement.json"]).hexdigest()
    names = [row["name"] for row in statement["obligations"]]
    assert [proof["obligation"] for proof in certificate["proofs"]] == names
    known = {assumption["name"] for assumption in statement["assumptions"]}
    for row in statement["obligations"]:
        assert set(row["uses"]) <= known
        assert (row["claim"][0] == "not") <= (row["role"] == "printed")


def evaluate(term: Any, values: dict[str, Any]) -> Any:
    if isinstance(term, str):
        return values[term] if term[0].isalpha() else number(Fraction(term))
    op, *args = term
    if op == "pow":
        return evaluate(args[0], values) ** int(args[1])
    parts = [evaluate(arg, values) for arg in args]
    if op in ("neg", "sqrt", "max"):
        return {"neg": lambda x: -x, "sqrt": mpmath.sqrt, "max": max}[op](*parts)
    a, b = parts
    return {"add": a + b, "sub": a - b, "mul": a * b, "div": a / b if op == "div" else None}[op]


def number(value: Fraction) -> mpmath.mpf:
    return mpmath.mpf(value.numerator) / value.denominator


def test_identities_hold_at_a_transcendental_point(documents: Files) -> None:
    """Each equation, read from the file, at a point where no false one could hold by chance."""
    statement, certificate = documents
    count = 0
    with mpmath.workprec(BITS):
        for row, proof in zip(statement["obligations"], certificate["proofs"], strict=True):
            if proof["rule"] != "rewrite":
                continue
            names = row["variables"]
            point = {name: mpmath.exp(-mpmath.sqrt(i + 2)) for i, name in enumerate(sorted(names))}
            relation, lhs, rhs = row["claim"]
            assert relation == "="
            a, b = evaluate(lhs, point), evaluate(rhs, point)
            assert abs(a - b) < mpmath.mpf(2) ** (60 - BITS) * (1 + abs(a)), row["name"]
            count += 1
    assert count > 100


def to_poly(term: Any, name: str) -> sympy.Poly:
    x = sympy.Symbol(name)
    if isinstance(term, str):
        return sympy.Poly(x if term == name else sympy.Rational(term), x)
    op, *args = term
    if op == "pow":
        return to_poly(args[0], name) ** int(args[1])
    parts = [to_poly(arg, name) for arg in args]
    if op == "neg":
        return -parts[0]
    a, b = parts
    if op == "div":
        return a * sympy.Poly(1 / b.as_expr(), x)
    return {"add": a + b, "sub": a - b, "mul": a * b}[op]


def test_bernstein_coefficients_by_sympy(documents: Files) -> None:
    statement, certificate = documents
    count = 0
    for row, proof in zip(statement["obligations"], certificate["proofs"], strict=True):
        if proof["rule"] != "bernstein":
            continue
        ((name, (low, high)),) = row["variables"].items()
        relation, lhs, rhs = row["claim"]
        assert relation in ("<", "<=")
        x = sympy.Symbol(name)
        start, end = sympy.Rational(low), sympy.Rational(high)
        p = (to_poly(rhs, name) - to_poly(lhs, name)).compose(
            sympy.Poly(start + (end - start) * x, x)
        )
        n, c = proof["degree"], list(reversed(p.all_coeffs()))
        values = [
            sum(c[k] * sympy.Rational(comb(j, k), comb(n, k)) for k in range(min(j + 1, len(c))))
            for j in range(n + 1)
        ]
        assert len(c) <= n + 1
        assert min(values) >= 0
        assert max(values) > 0
        count += 1
    assert count > 40
