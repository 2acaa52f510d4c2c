"""Write an example: the flow of three inelastic hard spheres through five collisions.

    python tests/certificates/flow.py certificates/examples/flow

Afterwards the folder has a statement and a certificate. Nothing here has to be trusted: the
numbers below are estimates, and what they suggest is proved by the certificate. Sphere 0 is hit by
the spheres 1 and 2 in turn; x and y are where these two are, and u and w how fast they go, relative
to sphere 0. The spheres have diameter 1 and restitution r.
"""

from __future__ import annotations

import hashlib
import json
import math
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

Term = Any  # as in the files: a text, or a list of an operation and terms

R = "3/100"
START = {"x1": "2", "x2": "0", "y1": "-3/2", "y2": "1/10", "u1": "-1", "u2": "1/50"}
START |= {"w1": "1/5", "w2": "-1/50"}
HITS = (1, 2, 1, 2, 1)  # the sphere that hits sphere 0
BITS, DIGITS, WIDTH = 256, 20, 96


def pretty(value: Any, indent: int = 0, used: int = 0) -> str:
    """JSON with as many items to a line as there is room for."""
    line = json.dumps(value, ensure_ascii=False)
    if indent + used + len(line) < WIDTH or not isinstance(value, dict | list):
        return line
    keys = (
        [f"{json.dumps(key)}: " for key in value] if isinstance(value, dict) else [""] * len(value)
    )
    items = [*value.values()] if isinstance(value, dict) else value
    lines = [""]
    for key, item in zip(keys, items, strict=True):
        text = key + pretty(item, indent + 1, len(key))
        length = indent + len(lines[-1]) + len(text)
        length += used if len(lines) == 2 and isinstance(value, dict) else 0
        if lines[-1] and "\n" not in lines[-1] + text and length < WIDTH:
            lines[-1] += f", {text}"
        else:
            lines.append(text)
    body = f",\n{' ' * (indent + 1)}".join(lines[1:])
    if isinstance(value, dict):
        return f"{{{body}}}"
    return f"[\n{' ' * (indent + 1)}{body}\n{' ' * indent}]"


def write(folder: Path, statement: dict[str, Any], certificate: dict[str, Any]) -> None:
    """Afterwards the folder has both files, of which the second names the first."""
    folder.mkdir(parents=True, exist_ok=True)
    text = pretty(statement) + "\n"
    certificate["statement_sha256"] = hashlib.sha256(text.encode()).hexdigest()
    (folder / "statement.json").write_text(text, encoding="utf-8")
    (folder / "certificate.json").write_text(pretty(certificate) + "\n", encoding="utf-8")


# --- terms, and estimates of their values --------------------------------------------------------


def add(a: Term, b: Term) -> Term:
    return ["add", a, b]


def sub(a: Term, b: Term) -> Term:
    return ["sub", a, b]


def mul(a: Term, b: Term) -> Term:
    return ["mul", a, b]


def dot(a: list[Term], b: list[Term]) -> Term:
    """The inner product of two vectors in the plane."""
    return add(mul(a[0], b[0]), mul(a[1], b[1]))


def quadratic(a: Term, b: Term, c: Term, t: Term) -> Term:
    """The polynomial a t^2 + 2 b t + c."""
    return add(add(mul(a, ["pow", t, "2"]), mul("2", mul(b, t))), c)


def discriminant(a: Term, b: Term, c: Term) -> Term:
    return sub(mul(b, b), mul(a, c))


def first_root(a: Term, b: Term, c: Term) -> Term:
    """The smaller root of that polynomial."""
    return ["div", sub(["neg", b], ["sqrt", discriminant(a, b, c)]), a]


class Estimates(dict[str, Fraction]):
    """Values of constants that are right to some hundred bits, without proof."""

    def of(self, term: Term) -> Fraction:
        """The value of a term."""
        if isinstance(term, str):
            return self[term] if term in self else Fraction(term)
        op, *args = term
        x = [self.of(arg) for arg in args]
        if op == "sqrt":
            return Fraction(math.isqrt(int(x[0] * 4**900)), 2**900)
        if op == "div":
            return Fraction(int(x[0] / x[1] * 2**900), 2**900)
        values = {"add": lambda: x[0] + x[1], "sub": lambda: x[0] - x[1], "neg": lambda: -x[0]}
        values |= {"mul": lambda: x[0] * x[1], "pow": lambda: x[0] ** int(x[1])}
        return Fraction(int(values[op]() * 2**900), 2**900)

    def ends(self, term: Term) -> list[str]:
        """Two decimal numbers around the value of a term."""
        n = math.floor(self.of(term) * 10**DIGITS)
        return [f"{n - 1}e-{DIGITS}", f"{n + 2}e-{DIGITS}"]


# --- parts of the two files ----------------------------------------------------------------------


def row(name: str, context: str | None, says: str, claim: Term) -> dict[str, Any]:
    parts = {"name": name, "context": context, "group": "", "label": "", "role": "needed"}
    parts |= {"severity": None, "says": says, "claim": claim, "verdict": "proved"}
    return parts | {"uses": [], "corrected_by": None}


def constant(name: str, term: Term) -> dict[str, Any]:
    return {"name": name, "label": "", "letter": name, "tex": name, "term": term}


def context(
    name: str, says: str, point: dict[str, Term], givens: dict[str, Term]
) -> dict[str, Any]:
    parts = {"name": name, "parent": None, "says": says}
    variables = [{"name": x, "letter": x, "tex": x} for x in point]
    found = [
        {"name": g, "claim": c, "kind": "plain", "assumption": None} for g, c in givens.items()
    ]
    return parts | {"variables": variables, "givens": found, "point": point, "constants": []}


def lemma(name: str, context: str | None, claim: Term, proof: Any) -> dict[str, Any]:
    return {"lemma": name, "context": context, "claim": claim, "proof": proof}


def summing(*addends: Any, using: tuple[str, ...] = (), equations: Any = ()) -> dict[str, Any]:
    parts = {"rule": "sum", "using": [*using], "addends": [*addends]}
    return parts | {"equations": [list(pair) for pair in equations]}


def instance(of: str, at: dict[str, Term], *givens: Any) -> dict[str, Any]:
    return {"rule": "instance", "of": of, "at": at, "givens": [*givens]}


INTERVAL = {"rule": "interval", "bits": BITS, "bounds": []}
DEFINE = {"rule": "define"}


# --- the scene -----------------------------------------------------------------------------------


def lemmas(statement: dict[str, Any], certificate: dict[str, Any]) -> None:
    """Two lemmas about a t^2 + 2 b t + c, the squared distance of two spheres less 1 at time t."""
    givens = {"a-pos": ["<", "0", "a"], "disc-pos": ["<", "0", discriminant("a", "b", "c")]}
    givens |= {"tau-is": ["=", "tau", first_root("a", "b", "c")]}
    givens |= {"t-pos": ["<", "0", "t"], "t-early": ["<", "t", "tau"]}
    point = {"a": "1", "b": "-1", "c": "3/4", "tau": "1/2", "t": "1/4"}
    says = "a t^2 + 2 b t + c has the smaller root tau, and t is earlier"
    statement["contexts"].append(context("meeting", says, point, givens))
    claims = {"meets": ["=", quadratic("a", "b", "c", "tau"), "0"]}
    claims |= {"before": ["<", "0", quadratic("a", "b", "c", "t")]}
    statement["obligations"] += [
        row("meets", "meeting", "at tau it is 0", claims["meets"]),
        row("before", "meeting", "at t it is positive", claims["before"]),
    ]
    gap = ["add", "t-early", ["mul", "2", ["root", ["sqrt", discriminant("a", "b", "c")]]]]
    certificate["steps"] += [
        {"open": "meeting", "givens": [INTERVAL] * 5},
        {"obligation": "meets", "proof": summing(using=("tau-is",))},
        {
            "obligation": "before",
            "proof": summing(["mul", "goal", "a-pos"], ["mul", "t-early", gap], using=("tau-is",)),
        },
    ]
    givens = {"A-low": ["<=", "0", "A"], "C-pos": ["<", "0", "C"]}
    givens |= {"end-pos": ["<", "0", add("C", mul("2", mul("B", "T")))]}
    givens |= {"s-pos": ["<", "0", "s"], "s-early": ["<", "s", "T"]}
    point = {"A": "1", "B": "0", "C": "1", "T": "1", "s": "1/2"}
    says = "C + 2 B s is positive for s = 0 and s = T, and s lies between"
    statement["contexts"].append(context("passing", says, point, givens))
    claim = ["<", "0", quadratic("A", "B", "C", "s")]
    statement["obligations"].append(row("between", "passing", "A s^2 + 2 B s + C > 0", claim))
    long = ["add", "s-pos", "s-early"]  # T, as a sum
    squares = ["mul", long, "A-low", ["square", "s"]]
    proof = summing(
        ["mul", "goal", long], squares, ["mul", "C-pos", "s-early"], ["mul", "end-pos", "s-pos"]
    )
    certificate["steps"] += [
        {"open": "passing", "givens": [INTERVAL] * 5},
        {"obligation": "between", "proof": proof},
    ]


class Flow:
    """The two files while they grow, and the state after the last collision."""

    def __init__(self) -> None:
        self.values = Estimates(r=Fraction(R))
        self.constants: list[dict[str, Any]] = []
        self.terms: dict[str, Term] = {}
        self.statement = {
            "format": "verify-statement/2",
            "theorem": "flow",
            "title": "Three inelastic hard spheres collide five times, 01 02 01 02 01",
            "parameters": {"r": R},
            "terms": self.terms,
            "constants": self.constants,
            "contexts": [],
            "obligations": [],
            "assumptions": [],
            "cites": [],
        }
        self.steps: list[dict[str, Any]] = [{"constant": "r", "proof": DEFINE}]
        self.certificate = {
            "format": "verify-certificate/2",
            "statement_sha256": "",
            "terms": {},
            "steps": self.steps,
            "enclosures": {"constants": {}, "rows": {}},
        }
        lemmas(self.statement, self.certificate)
        self.state = {name: self.define(f"{name}.0", term) for name, term in START.items()}

    def define(self, name: str, term: Term) -> str:
        """A new constant of the statement, and its step."""
        self.constants.append(constant(name, term))
        self.steps.append({"constant": name, "proof": DEFINE})
        self.values[name] = self.values.of(term)
        return name

    def term(self, name: str, term: Term) -> str:
        """A new shared term of the statement."""
        self.terms[name], self.values[name] = term, self.values.of(term)
        return name

    def claim(self, row: dict[str, Any], proof: Any) -> str:
        """A new obligation, and its step."""
        self.statement["obligations"].append(row)
        self.steps.append({"obligation": row["name"], "proof": proof})
        return row["name"]

    def fact(self, name: str, claim: Term) -> str:
        """A lemma that enclosures decide."""
        self.steps.append(lemma(name, None, claim, INTERVAL))
        return name

    def pair(self, name: str, t: Term = None) -> tuple[list[Term], list[Term]]:
        """The difference of the centres of two spheres, after a time t, and of their velocities."""
        s = self.state
        p = {"01": [s["x1"], s["x2"]], "02": [s["y1"], s["y2"]]}
        v = {"01": [s["u1"], s["u2"]], "02": [s["w1"], s["w2"]]}
        if t is not None:
            p = {k: [add(p[k][i], mul(t, v[k][i])) for i in (0, 1)] for k in p}
        for both in (p, v):
            both["12"] = [sub(both["01"][i], both["02"][i]) for i in (0, 1)]
        return p[name], v[name]

    def motion(self, pair: str, n: int) -> list[str]:
        """The terms a, b, c, where the squared distance in flight is 1 + a t^2 + 2 b t + c."""
        p, v = self.pair(pair)
        terms = {"a": dot(v, v), "b": dot(p, v), "c": sub(dot(p, p), "1")}
        return [self.term(f"{key}.{pair}.{n}", term) for key, term in terms.items()]

    def collision(self, n: int) -> None:
        """The n-th flight, in which no spheres touch, and the collision at its end."""
        hit, other = ("01", "02") if HITS[n - 1] == 1 else ("02", "01")
        a, b, c = self.motion(hit, n)
        positive = self.fact(f"a-pos.{n}", ["<", "0", a])
        real = self.fact(f"disc-pos.{n}", ["<", "0", discriminant(a, b, c)])
        tau, t = self.define(f"tau.{n}", first_root(a, b, c)), f"t.{n}"
        self.fact(f"tau-pos.{n}", ["<", "0", tau])
        meets, at = f"meets.{n}", {"a": a, "b": b, "c": c, "tau": tau}
        proof = instance(
            "meets", at | {"t": ["div", tau, "2"]}, positive, real, tau, *[INTERVAL] * 2
        )
        self.steps.append(lemma(meets, None, ["=", quadratic(a, b, c, tau), "0"], proof))
        self.flight(n, t, tau)
        early = f"t-pos.{n}", f"t-early.{n}"
        proof = instance("before", at | {"t": t}, positive, real, tau, *early)
        self.apart(n, hit, t, quadratic(a, b, c, t), proof)
        for pair in ["12", other] if n == 1 else ["12"]:
            a, b, c = self.motion(pair, n)
            at = {"A": a, "B": b, "C": c, "T": tau, "s": t}
            proof = instance("between", at, *[INTERVAL] * 3, *early)
            self.apart(n, pair, t, quadratic(a, b, c, t), proof)
        if n > 1:
            self.parting(n, other, t)
        self.impact(n, hit, tau)

    def flight(self, n: int, t: str, tau: str) -> None:
        """A context for the times between two collisions."""
        name, says = f"flight.{n}", f"{t} lies between the start of flight {n} and its end, {tau}"
        givens = {f"t-pos.{n}": ["<", "0", t], f"t-early.{n}": ["<", t, tau]}
        self.statement["contexts"].append(context(name, says, {t: ["div", tau, "2"]}, givens))
        self.steps.append({"open": name, "givens": [INTERVAL] * 2})

    def far(self, n: int, pair: str, t: str, proof: Any) -> None:
        """The obligation that two spheres do not touch in a flight."""
        p, _ = self.pair(pair, t)
        says = f"in flight {n} the spheres {pair[0]} and {pair[1]} are apart"
        self.claim(row(f"apart.{pair}.{n}", f"flight.{n}", says, ["<", "1", dot(p, p)]), proof)

    def apart(self, n: int, pair: str, t: str, excess: Term, proof: Any) -> None:
        """Two spheres do not touch, as their squared distance less 1 is positive."""
        name = f"excess.{pair}.{n}"
        self.steps.append(lemma(name, f"flight.{n}", ["<", "0", excess], proof))
        self.far(n, pair, t, summing("goal", name))

    def parting(self, n: int, pair: str, t: str) -> None:
        """Two spheres that touch at the start do not touch again, as they go apart."""
        p, v = self.pair(pair)
        away = self.fact(f"away.{n}", ["<", "0", dot(p, v)])
        squares = ["mul", ["square", t], ["add", ["square", v[0]], ["square", v[1]]]]
        rise = ["mul", "2", away, f"t-pos.{n}"]
        self.far(n, pair, t, summing("goal", rise, squares, equations=[(f"touch.{n - 1}", "1")]))

    def impact(self, n: int, hit: str, tau: str) -> None:
        """The state after a collision: v' = v - (1 + r)/2 (v.e) e, the opposite for sphere 0."""
        s = self.state
        speeds = {"x1": "u1", "x2": "u2", "y1": "w1", "y2": "w2"}
        for name, speed in speeds.items():
            s[name] = self.define(f"{name}.{n}", add(s[name], mul(tau, s[speed])))
        e, v = self.pair(hit)
        says = f"collision {n}: the spheres {hit[0]} and {hit[1]} touch"
        proof = summing(using=(e[0], e[1]), equations=[(f"meets.{n}", "1")])
        self.claim(row(f"touch.{n}", None, says, ["=", dot(e, e), "1"]), proof)
        push = self.define(f"push.{n}", dot(v, e))
        self.claim(
            row(f"push-neg.{n}", None, "and approach each other", ["<", push, "0"]), INTERVAL
        )
        for name in ("u1", "u2", "w1", "w2"):
            both = (name[0] == "u") == (hit == "01")
            share = add("1", "r") if both else ["div", add("1", "r"), "2"]
            change = mul(share, mul(push, e[int(name[1]) - 1]))
            s[name] = self.define(f"{name}.{n}", sub(s[name], change))

    def enclose(self) -> None:
        """Afterwards the certificate has the enclosures of all constants and ground rows."""
        enclosures = self.certificate["enclosures"]
        for name in ["r", *(item["name"] for item in self.constants)]:
            enclosures["constants"][name] = {"bits": BITS, "ends": self.values.ends(name)}
        for item in self.statement["obligations"]:
            if item["context"] is None:
                sides = map(self.values.ends, item["claim"][1:])
                enclosures["rows"][item["name"]] = {
                    "bits": BITS,
                    **dict(zip(("lhs", "rhs"), sides, strict=True)),
                }


def main(folder: str) -> None:
    """Afterwards the folder has the example."""
    flow = Flow()
    for n, _ in enumerate(HITS, 1):
        flow.collision(n)
    flow.enclose()
    write(Path(folder), flow.statement, flow.certificate)


if __name__ == "__main__":
    main(sys.argv[1])
