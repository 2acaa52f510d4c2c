"""``law``: identities of exponentials, logarithms, sines and inverse tangents."""

from __future__ import annotations

import pytest

from tests.check.support import Pair, cuts, ground, verdict

LAW = {"rule": "law"}
WRONG = "terms that differ"
NONE = "which is no law"


CASES = [
    ("exp(x + y) = exp(x)*exp(y)", "proved"),
    ("exp(x) = exp(x - y)*exp(y)", "proved"),
    ("exp(0) = exp(x)*exp(-(1*x))", "proved"),
    ("exp(x/p + y) = exp(y)*exp(x/p)", "proved"),
    ("exp(x + y) = exp(x)*exp(x)", WRONG),
    ("exp(x*y) = exp(x)*exp(y)", WRONG),
    ("exp(x + y) = exp(x) + exp(y)", NONE),
    ("exp(x)*exp(y) = exp(x + y)", NONE),
    ("exp(x + y) <= exp(x)*exp(y)", "expected ="),
    ("exp(x + y) = exp(x)*y", "found name, expected exp"),
    ("exp(x + y) = log(p)*log(q)", "found log, expected exp"),
    ("log(p*q) = log(p) + log(q)", "proved"),
    ("log(p) = log(p/q) + log(q)", "a term that is not known to be > 0"),
    ("log(p/q) = log(p) + log(1/q)", "a term that is not known to be > 0"),
    ("log(2*p) = log(2) + log(p)", "proved"),
    ("log(p*q) = log(p) + log(p)", WRONG),
    ("log(p + q) = log(p) + log(q)", "a term that is not known to be > 0"),
    ("log(x*x) = log(x) + log(x)", "a term that is not known to be > 0"),
    ("log(p*q) = log(p)*log(q)", NONE),
    ("exp(log(p)) = p", "proved"),
    ("exp(log(x)) = x", "a term that is not known to be > 0"),
    ("exp(log(p)) = q", NONE),
    ("exp(log(p*q)) = p*q", "proved"),
    ("exp(log(p)) < p", "expected ="),
    ("log(exp(x)) = x", "proved"),
    ("log(exp(x)) = y", NONE),
    ("log(log(q)) = q", "a term that is not known to be > 0"),
    ("exp(exp(x)) = x", NONE),
    ("sin(x)**2 + cos(x)**2 = 1", "proved"),
    ("sin(2*x)**2 + cos(x + x)**2 = 1", "proved"),
    ("sin(x)**2 + cos(y)**2 = 1", WRONG),
    ("sin(x)**2 + cos(x)**2 = 2", NONE),
    ("sin(x)**2 + cos(x)**3 = 1", NONE),
    ("sin(x)**3 + cos(x)**2 = 1", NONE),
    ("sin(x)**3 + cos(x)**3 = 1", NONE),
    ("cos(x)**2 + sin(x)**2 = 1", "found cos, expected sin"),
    ("sin(x)**2 + sin(x)**2 = 1", "found sin, expected cos"),
    ("sin(x)**2 - cos(x)**2 = 1", NONE),
    ("root(p, 2) + root(q, 2) = 1", "found root, expected pow"),
    ("sin(x)**2 + cos(x)**2 < 1", "expected ="),
    ("sin(x) = cos(pi()/2 - x)", "proved"),
    ("sin(pi()/2 - x) = cos(x)", "proved"),
    ("sin(x) = cos(x - pi()/2)", WRONG),
    ("sin(x) = cos(x)", WRONG),
    ("sin(x) = cos(pi() - x)", WRONG),
    ("cos(x) = sin(pi()/2 - x)", NONE),
    ("cos(pi()*x) = cos_pi(x)", "proved"),
    ("cos(x) = cos_pi(x)", WRONG),
    ("cos(x) = cos_pi(pi()*x)", WRONG),
    ("sin(pi()*x) = cos_pi(x)", NONE),
    ("sin(atan(x)) = x*cos(atan(x))", "proved"),
    ("sin(atan(x)) = y*cos(atan(x))", "another angle"),
    ("sin(atan(x)) = x*cos(atan(y))", WRONG),
    ("sin(x) = x*cos(x)", "another angle"),
    ("sin(atan(x)) = x*sin(atan(x))", "found sin, expected cos"),
    ("x = x", NONE),
    ("1 = 1", NONE),
    ("exp(1/x) = exp(1/x)*exp(0)", "a division by a term"),
]


def statement(claim: str) -> Pair:
    """The claim, as a law of any x and y and of positive p and q."""
    pair = Pair().context(
        "c", {"x": "0", "y": "0", "p": "1", "q": "1"}, {"p-pos": "0 < p", "q-pos": "0 < q"}
    )
    pair.lemma("e", "0 < exp(x)", {"rule": "range"}, "c")
    pq = {"rule": "sum", "using": [], "addends": ["goal", ["mul", "p-pos", "q-pos"]]}
    pair.lemma("pq", "0 < p*q", {**pq, "equations": []}, "c")
    double = {"rule": "sum", "using": [], "addends": ["goal", "p-pos", "p-pos"], "equations": []}
    pair.lemma("p2", "0 < 2*p", double, "c")
    return pair.row("row", claim, LAW, "c")


@pytest.mark.parametrize(("claim", "found"), CASES)
def test_laws(claim: str, found: str) -> None:
    assert found in verdict(statement(claim))


def test_without_variables() -> None:
    assert ground("log(6) = log(2) + log(3)", LAW) == "proved"
    assert WRONG in ground("log(5) = log(2) + log(3)", LAW)
    assert "not known to be > 0" in ground("log(0) = log(0) + log(1)", LAW)


def test_a_hypothesis_makes_no_identity() -> None:
    pair = Pair().context("c", {"x": "0"}, {})
    claim = "exp(x) = exp(0)*exp(0)"
    pair.row("row", claim, cuts("x", ["0"], LAW, LAW), "c")
    assert WRONG in verdict(pair)
