"""A refusal names what was found and what was expected, word for word."""

from __future__ import annotations

from typing import Any

import pytest

from tests.check.support import verdict

UNIT = {"x": ["0", "1"]}
LOW = {"low": ["min", "1/4", "2"]}
ONE = "[100000000000000000000e-20, 100000000000000000000e-20]"
MINUS_ONE = "[-100000000000000000000e-20, -100000000000000000000e-20]"
NINE = "[900000000000000000000e-20, 900000000000000000000e-20]"
IDENTITY = {"rule": "rewrite", "bits": 64, "steps": [], "closing": "identity"}


def rewrite(*steps: Any, **fields: Any) -> dict[str, Any]:
    return {"rule": "rewrite", "steps": list(steps), "closing": "identity", **fields}


@pytest.mark.parametrize(
    ("claim", "fields", "reason"),
    [
        (["<", "x", "2"], {"rule": "interval", "variables": {"x": ["0", None]}},
         "found a variable without bounds"),
        (["<", ["sqrt", "-1"], "2"], {"rule": "interval"},
         f"found a square root of {MINUS_ONE}, which reaches below 0"),
        (["<", ["div", "1", "0"], "2"], {"rule": "interval"},
         "found a division by [0e-21, 0e-21], which contains 0"),
        (["<", ["cos", "9"], "2"], {"rule": "interval"},
         f"found a cosine of {NINE}, which reaches beyond 8"),
        (["<", "1", "1"], {"rule": "interval"},
         f"found {ONE} and {ONE}, expected < between them"),
        (["not", ["=", "1", "1"]], {"rule": "exact"},
         f"found {ONE} and {ONE}, expected != between them"),
        (["=", "x", "1"], {**rewrite(), "variables": UNIT},
         "found sides that differ, expected an identity"),
        (["<", "x", "x"], {**rewrite(), "variables": UNIT}, "found equal sides, not <"),
        (["<=", "low", "2"], {**rewrite(["low", 2]), "constants": LOW},
         "found entry 2 of low, which has none such"),
        (["<=", "2", "low"], {**rewrite(["low", 1]), "constants": LOW},
         "found entry 1 of low, which may make the claim easier"),
        (["=", "x", "0"], {"rule": "bernstein", "degree": 3, "variables": UNIT},
         "found no inequality in one variable with a bounded interval"),
        (["<=", "0", ["pow", "x", "4"]], {"rule": "bernstein", "degree": 3, "variables": UNIT},
         "found a degree above 3"),
        (["<=", ["sub", "x", "1"], ["sub", "x", "x"]],
         {"rule": "bernstein", "degree": 1, "variables": {"x": ["0", "3"]}},
         "found [-200000000000000000000e-20, -200000000000000000000e-20] as the least coefficient"),
        (["<=", "0", ["mul", "x", ["sqrt", "4/9"]]],
         {"rule": "bernstein", "degree": 1, "variables": {"x": ["-1", "1"]}},
         "found [-66666666666666666667e-20, -66666666666666666666e-20] as the least coefficient"),
        (["<=", "x", "1"], {"rule": "cuts", "cuts": {"y": ["0", "1"]}, "variables": UNIT},
         "found cuts of ['y']"),
        (["<=", "x", "1"], {"rule": "cuts", "cuts": {"x": ["0", "1/2"]}, "variables": UNIT},
         "found cuts ['0', '1/2'] that do not increase from end to end"),
        (["not", ["<=", "x", "1"]], {"rule": "witness", "point": {"y": "1"}, "variables": UNIT},
         "found a point with ['y']"),
        (["not", ["<=", "x", "1"]], {"rule": "witness", "point": {"x": "1"}, "variables": UNIT},
         f"found {ONE}, expected a value inside"),
        (["<=", "-1", "1"], {"rule": "square", "then": IDENTITY},
         f"found {MINUS_ONE}, expected a side that is not negative"),
    ],
)  # fmt: skip
def test_refusals(claim: Any, fields: dict[str, Any], reason: str) -> None:
    found = verdict(claim, **fields)
    head, _, tail = found.partition(": ")
    assert head.startswith("REFUSED row [LABEL] ")
    assert tail == reason


@pytest.mark.parametrize(
    ("claim", "fields", "reason"),
    [
        (["=", "x", "x"], {**rewrite(["nobody", None]), "variables": UNIT},
         "found nobody, expected a constant"),
        (["<", "1", ["add", "1"]], {"rule": "exact"}, "rhs: found ['add', '1'], expected a term"),
        (["<", "1", ["pow", "1", "x"]], {"rule": "exact"},
         "rhs: 1: found x, expected [1-9][0-9]{0,2}"),
    ],
)  # fmt: skip
def test_malformed(claim: Any, fields: dict[str, Any], reason: str) -> None:
    assert verdict(claim, **fields) == f"malformed: obligation row: {reason}"
