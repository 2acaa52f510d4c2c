"""A small honest statement with its certificate, in which every rule of the checker occurs."""

from __future__ import annotations

import contextlib
import gc
import io
import json
import signal
from collections.abc import Iterator
from fractions import Fraction
from hashlib import sha256
from pathlib import Path
from typing import Any

import mpmath

from verify import check

Json = Any
Document = dict[str, Any]
SECONDS = 10
ROOT_2 = "141421356237309504880168872420969807857/" + "1" + "0" * 38  # rounded up

PARAMETERS = {"r": "1/3", "s": "7/5"}
CONSTANTS: dict[str, Json] = {
    "half": ["div", "1", "2"],
    "root2": ["sqrt", "2"],
    "root3": ["sqrt", "3"],
    "lowest": ["min", ["mul", "r", "s"], "half", "root2"],
    "highest": ["max", "r", "s", "root2"],
    "third-turn": ["cos_pi", "r"],
    "cosine": ["cos", "s"],
    "cube": ["pow", "root2", "3"],
}
X = {"x": ["0", "1"]}
INTERVAL = {"rule": "interval", "bits": 128}
IDENTITY = {"rule": "rewrite", "bits": 128, "closing": "identity"}
BOTH = [["root2", None], ["root3", None]]
SUM = ["add", "root2", "root3"]

#: name, claim, variables, proof.
ROWS: list[tuple[str, Json, dict[str, Json], Document]] = [
    ("interval", ["<", "root2", "root3"], {}, INTERVAL),
    ("interval-tight", ["<", "root2", ROOT_2], {}, {"rule": "interval", "bits": 256}),
    ("interval-box", ["<", ["mul", "x", "root2"], "3/2"], X, INTERVAL),
    ("exact", ["<=", ["mul", "r", "s"], "7/15"], {}, {"rule": "exact", "bits": 64}),
    ("exact-equal", ["=", ["sub", "s", "r"], "16/15"], {}, {"rule": "exact", "bits": 64}),
    (
        "rewrite-interval",
        ["<", "lowest", "half"],
        {},
        {"rule": "rewrite", "bits": 128, "closing": "interval", "steps": [["lowest", None]]},
    ),
    (
        "rewrite-entry",
        ["<=", "lowest", ["mul", "r", "s"]],
        {},
        IDENTITY | {"steps": [["lowest", 0]]},
    ),
    (
        "rewrite-root",
        ["<=", ["pow", "root2", "2"], "2"],
        {},
        IDENTITY | {"steps": [["root2", None]]},
    ),
    (
        "identity",
        ["=", ["mul", SUM, ["sub", "root3", "root2"]], "1"],
        {},
        IDENTITY | {"steps": BOTH},
    ),
    (
        "identity-box",
        [
            "=",
            ["div", "1", ["add", "x", "root2"]],
            ["div", ["sub", "root2", "x"], ["sub", "2", ["pow", "x", "2"]]],
        ],
        X,
        IDENTITY | {"steps": BOTH[:1]},
    ),
    (
        "bernstein",
        ["<", ["mul", "2", "x"], ["add", "1", ["mul", "2", ["pow", "x", "2"]]]],
        X,
        {"rule": "bernstein", "bits": 128, "degree": 2},
    ),
    (
        "cuts",
        ["<", ["mul", "x", ["sub", "1", "x"]], "2/5"],
        X,
        {"rule": "cuts", "bits": 128, "cuts": {"x": ["0", "1/4", "1/2", "3/4", "1"]}},
    ),
    (
        "cuts-two",
        ["<=", ["mul", ["mul", "x", "y"], ["sub", "1", "x"]], "3/4"],
        X | {"y": ["1", "2"]},
        {
            "rule": "cuts",
            "bits": 128,
            "cuts": {"x": ["0", "1/4", "1/2", "3/4", "1"], "y": ["1", "3/2", "2"]},
        },
    ),
    (
        "witness",
        ["not", ["<", ["pow", "x", "2"], "2"]],
        {"x": ["0", "2"]},
        {"rule": "witness", "bits": 128, "point": {"x": "3/2"}},
    ),
    (
        "witness-two",
        ["not", ["<=", ["add", "x", "y"], "root2"]],
        X | {"y": [None, None]},
        {"rule": "witness", "bits": 128, "point": {"x": "1/2", "y": "1"}},
    ),
    ("square", ["<", SUM, ["sqrt", "10"]], {}, {"rule": "square", "bits": 128, "then": INTERVAL}),
    (
        "square-identity",
        ["<=", ["mul", "root2", "root3"], ["sqrt", "6"]],
        {},
        {"rule": "square", "bits": 128, "then": IDENTITY | {"steps": BOTH}},
    ),
    ("negation", ["not", ["<", "root3", "root2"]], {}, INTERVAL),
    ("negation-weak", ["not", ["<=", "root3", "root2"]], {}, INTERVAL),
    ("negation-equal", ["not", ["=", "root2", "7/5"]], {}, INTERVAL),
    ("cos", ["<", "cosine", "17/100"], {}, INTERVAL),
    ("cos-pi", ["<=", ["sub", "third-turn", "half"], "1/" + "1" + "0" * 30], {}, INTERVAL),
    ("max", ["<", "highest", "283/200"], {}, INTERVAL),
    ("pow", ["<", ["neg", "cube"], "-2828/1000"], {}, INTERVAL),
]


def value(term: Json, names: dict[str, Any]) -> Any:
    """A term's value: a fraction where possible, or mpmath's number."""
    if isinstance(term, str):
        return names[term] if term in names else Fraction(term)
    op, *rest = term
    if op == "pow":
        return value(rest[0], names) ** int(rest[1])
    args = [value(arg, names) for arg in rest]
    if op in ("min", "max"):
        key = None if all(isinstance(arg, Fraction) for arg in args) else real
        return {"min": min, "max": max}[op](args, key=key)
    if op in ("sqrt", "cos", "cos_pi"):
        return {"sqrt": mpmath.sqrt, "cos": mpmath.cos, "cos_pi": mpmath.cospi}[op](real(args[0]))
    if any(isinstance(arg, mpmath.mpf) for arg in args):
        args = [real(arg) for arg in args]
    if op == "neg":
        return -args[0]
    a, b = args
    if op == "div":
        return a / b
    return {"add": lambda: a + b, "sub": lambda: a - b, "mul": lambda: a * b}[op]()


def real(number: Any) -> Any:
    """A number of mpmath."""
    if isinstance(number, Fraction):
        return mpmath.mpf(number.numerator) / number.denominator
    return number


def around(number: Any) -> list[str]:
    """An enclosure, as a certificate writes it."""
    middle = int(mpmath.floor(real(number) * 10**20))
    return [f"{middle - 1}e-20", f"{middle + 2}e-20"]


def honest() -> tuple[Document, Document]:
    """The statement and the certificate, without its digest."""
    with mpmath.workdps(60):
        names: dict[str, Any] = {}
        for name, term in (PARAMETERS | CONSTANTS).items():
            names[name] = value(term, names)
        enclosures = {name: around(names[name]) for name in CONSTANTS}
        proofs = []
        for name, claim, variables, proof in ROWS:
            sides = {}
            if not variables:
                _, lhs, rhs = claim[1] if claim[0] == "not" else claim
                sides = {side: around(value(t, names)) for side, t in (("lhs", lhs), ("rhs", rhs))}
            proofs.append({"obligation": name, **proof, **sides})
    statement = {
        "format": "verify-statement/1",
        "theorem": "theorem-0",
        "title": "A small theorem",
        "parameters": PARAMETERS,
        "constants": [
            {"name": name, "label": f"C-{name}", "tex": f"c_{i}", "term": term}
            for i, (name, term) in enumerate(CONSTANTS.items())
        ],
        "obligations": [
            {
                "name": name,
                "label": f"O-{name}",
                "role": "printed" if claim[0] == "not" else "needed",
                "says": f"What {name} says.",
                "claim": claim,
                "uses": ["model"] if name == "interval" else [],
                "variables": variables,
            }
            for name, claim, variables, _ in ROWS
        ],
        "assumptions": [
            {"name": "model", "label": "A-model", "sentence": "Spheres are hard."},
            {"name": "map", "label": "A-map", "sentence": "Collisions follow one another."},
        ],
    }
    certificate = {"format": "verify-certificate/1", "enclosures": enclosures, "proofs": proofs}
    first, second = json.loads(json.dumps([statement, certificate]))  # nothing is shared
    return first, second


def encode(document: Json) -> bytes:
    """The bytes of a document; unpaired surrogates stay escapes."""
    return (json.dumps(document, indent=1) + "\n").encode()


def pack(statement: Json, certificate: Json) -> tuple[bytes, bytes]:
    """The bytes of both files, with the digest of the first in the second."""
    first = encode(statement)
    if isinstance(certificate, dict):
        certificate = certificate | {"statement_sha256": sha256(first).hexdigest()}
    return first, encode(certificate)


def bind(first: bytes, second: bytes) -> tuple[bytes, bytes]:
    """Both files after the statement has changed: with its new digest."""
    certificate = json.loads(second)
    certificate["statement_sha256"] = sha256(first).hexdigest()
    return first, encode(certificate)


def write(folder: Path, files: tuple[bytes, bytes]) -> Path:
    """Write both files into a folder."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, data in zip(("statement.json", "certificate.json"), files, strict=True):
        (folder / name).write_bytes(data)
    return folder


class TooSlow(BaseException):
    """The checker has worked for too long."""


@contextlib.contextmanager
def limited() -> Iterator[None]:
    """Inside, more than `SECONDS` seconds raise `TooSlow`."""

    def late(*_: object) -> None:
        raise TooSlow(f"more than {SECONDS} seconds")

    before = signal.signal(signal.SIGALRM, late)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def run(*paths: Path | str) -> tuple[int, list[str], str]:
    """The checker's exit code, the lines that it prints, and its errors, in this process."""
    out, err = io.StringIO(), io.StringIO()
    try:
        with limited(), contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            code = check.main([str(path) for path in paths])
    finally:
        gc.enable()  # a program of its own may turn it off; a test must not
    return code, out.getvalue().splitlines(), err.getvalue()
