"""Z3 and cvc5 on two public collections, beside our own search.

``python -m tests.measure.peers [--quick]`` prints a table.

Each gets the question whether the givens and the negation of a claim have a solution, as SMT-LIB
text and in a process of its own: `unsat` proves the claim, `sat` refutes it. Roots and logarithms
are unknowns with an equation. Z3 gets no claim with other functions, as it has none of them. The
peers are optional (`pip install z3-solver cvc5`); those that are missing are named.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import reduce
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from statistics import median
from typing import Any

from verify import check
from verify.cli.columns import table_lines
from verify.cli.terminal import width
from verify.language.fold import fold
from verify.language.record import Record
from verify.language.statement import PROVED, REFUTED, UNDECIDED, Constant, Statement
from verify.language.terms import Claim, Term
from verify.measure import Table, table, timed
from verify.measure.inequalities import QUICK, ROW, entries, question
from verify.prover.budget import WorkBudget
from verify.wire.questions import decide, read_page_of
from verify.wire.write import write

ROOT = Path(__file__).resolve().parents[2]
DRAWN = ROOT / "tests" / "prover" / "drawn"
#: For each row and each tool; a process may take so much longer to start.
SECONDS, START = 5, 20
#: By the names of their distributions what they are called.
PEERS = {"z3-solver": "Z3", "cvc5": "cvc5"}
TRANSCENDENTAL = ("exp", "log", "sin", "cos", "cos_pi", "atan", "pi")


class Problem(Record):
    """A row of a statement, its set, and whether it is true."""

    collection: str
    name: str
    statement: Statement
    truth: bool


class Reply(Record):
    """A verdict, the CPU time, and whether a certificate was checked."""

    verdict: str
    seconds: float
    certified: bool = False


Solver = Callable[[Problem], Reply]


def problems(quick: bool) -> Iterator[Problem]:
    """The published inequalities whose truth is known, then the drawn ones, all of which hold."""
    for entry in entries():
        if entry["truth"] is not None and (not quick or entry["category"] in QUICK):
            yield Problem("published", ROW, question(entry), entry["truth"])
    for path in () if quick else sorted(DRAWN.glob("*.toml")):
        statement = read_page_of(str(path), path.read_bytes(), {}).statement
        for row in statement.obligations:
            contexts = tuple(c for c in statement.contexts if c.name == row.context)
            alone = statement._replace(obligations=(row,), contexts=contexts)
            yield Problem(f"drawn, {path.stem}", row.name, alone, truth=True)


def peers_table(quick: bool) -> Table:
    """For each set and each tool what it decides, and how fast."""
    asked = [*problems(quick)]
    missing = [called for name, called in PEERS.items() if _version(name) is None]
    rows = []
    for collection in dict.fromkeys(problem.collection for problem in asked):
        own = [problem for problem in asked if problem.collection == collection]
        for tool, solve in _solvers().items():
            rows.append(_counted(collection, tool, own, [solve(problem) for problem in own]))
    title = f"Public sets, {SECONDS} s for each claim"
    if missing:
        title += f"; not installed: {', '.join(missing)} (pip install z3-solver cvc5)"
    columns = ["set", "tool", "claims", "decided", "wrong", "median CPU s", "certificates"]
    return table(title, columns, rows)


def _solvers() -> dict[str, Solver]:
    found: dict[str, Solver] = {"verify": _ours}
    for name, called in PEERS.items():
        number = _version(name)
        if number is not None:
            found[f"{called} {number}"] = lambda problem, name=name: _asked(name, problem)  # type: ignore[misc]
    return found


def _version(name: str) -> str | None:
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def _counted(
    collection: str, tool: str, asked: Sequence[Problem], answers: Sequence[Reply]
) -> list[str | int]:
    decided = [
        (problem, answer)
        for problem, answer in zip(asked, answers, strict=True)
        if answer.verdict != UNDECIDED
    ]
    wrong = sum((answer.verdict == PROVED) != problem.truth for problem, answer in decided)
    times = [answer.seconds for _, answer in decided]
    middle = f"{median(times):.3f}" if times else "-"
    certified = sum(answer.certified for _, answer in decided)
    return [collection, tool, len(asked), len(decided), wrong, middle, certified]


# --- our own -------------------------------------------------------------------------------------


def _ours(problem: Problem) -> Reply:
    """Decided, and the certificate checked; the time is that of both."""
    seconds, (found, accepted) = timed(lambda: _decided(problem))
    return Reply(found, seconds, accepted)


def _decided(problem: Problem) -> tuple[str, bool]:
    """The verdict, and whether the checker accepts a certificate of it."""
    outcome = decide(problem.statement, WorkBudget(seconds=SECONDS))
    found = outcome.decisions[problem.name].claimed
    if found == UNDECIDED:
        return found, False
    files = write(outcome)
    report = check.check(files["statement.json"], files["certificate.json"], {})
    return found, report.verdict == found.upper()


# --- peers ---------------------------------------------------------------------------------------


def _asked(peer: str, problem: Problem) -> Reply:
    """What a peer answers in a process of its own; nothing if that ends badly or takes long."""
    text = smt_of(problem.statement, functions=peer == "cvc5")
    if text is None:
        return Reply(UNDECIDED, 0.0)
    command = [sys.executable, "-m", "tests.measure.peers", peer]
    most = SECONDS + START
    try:
        done = subprocess.run(
            command, cwd=ROOT, input=text, capture_output=True, text=True, timeout=most, check=True
        )
    except (subprocess.TimeoutExpired, subprocess.CalledProcessError):
        return Reply(UNDECIDED, float(SECONDS))
    told = json.loads(done.stdout)
    verdict = {"unsat": PROVED, "sat": REFUTED}.get(told["answer"], UNDECIDED)
    return Reply(verdict, told["seconds"])


def _ask_z3(text: str) -> str:
    import z3

    solver = z3.Solver()
    solver.set("timeout", SECONDS * 1000)
    solver.from_string(text)
    return str(solver.check())


def _ask_cvc5(text: str) -> str:
    import cvc5

    solver = cvc5.Solver(cvc5.TermManager())
    solver.setOption("tlimit-per", str(SECONDS * 1000))
    parser = cvc5.InputParser(solver)
    whole = f"(set-logic QF_NRAT)\n{text}(check-sat)\n"
    parser.setStringInput(cvc5.InputLanguage.SMT_LIB_2_6, whole, "claim")
    names, answer = parser.getSymbolManager(), ""
    while not (command := parser.nextCommand()).isNull():
        answer = str(command.invoke(solver, names)).strip()
    return answer


_ASKED = {"z3-solver": _ask_z3, "cvc5": _ask_cvc5}


# --- SMT-LIB -------------------------------------------------------------------------------------


class _Writer:
    """Terms as SMT-LIB, and the unknowns that stand for roots and logarithms."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.known: dict[Term, str] = {}
        self.algebra: Mapping[str, Callable[..., str]] = {
            "rational": _number,
            "symbol": lambda name: f"|{name}|",
            "add": "(+ {} {})".format,
            "sub": "(- {} {})".format,
            "mul": "(* {} {})".format,
            "div": "(/ {} {})".format,
            "neg": "(- {})".format,
            "pow": lambda base, exponent: f"(* {' '.join([base] * exponent)} 1.0)",
            "min": lambda *parts: reduce("(ite (<= {0} {1}) {0} {1})".format, parts),
            "max": lambda *parts: reduce("(ite (<= {0} {1}) {1} {0})".format, parts),
            "sqrt": lambda base: self._root(base, 2),
            "root": self._root,
            "exp": "(exp {})".format,
            "log": self._logarithm,
            "sin": "(sin {})".format,
            "cos": "(cos {})".format,
            "cos_pi": "(cos (* real.pi {}))".format,
            "atan": "(arctan {})".format,
            "pi": lambda: "real.pi",
        }

    def term(self, term: Term) -> str:
        """The text of a term."""
        return fold(term, self.algebra, self.known)

    def claim(self, claim: Claim) -> str:
        """The text of a claim."""
        return f"({claim.relation} {self.term(claim.lhs)} {self.term(claim.rhs)})"

    def define(self, constants: Sequence[Constant]) -> None:
        """Constants of the statement; a line for an unknown stands before its user's."""
        for constant in constants:
            text = self.term(constant.term)
            self.lines.append(f"(define-fun |{constant.name}| () Real {text})")

    def _unknown(self) -> str:
        name = f"|unknown {len(self.lines)}|"
        self.lines.append(f"(declare-const {name} Real)")
        return name

    def _root(self, base: str, index: int) -> str:
        name = self._unknown()
        self.lines.append(f"(assert (and (>= {name} 0.0) (= (* {(name + ' ') * index}) {base})))")
        return name

    def _logarithm(self, base: str) -> str:
        name = self._unknown()
        self.lines.append(f"(assert (= (exp {name}) {base}))")
        return name


def _number(value: Any) -> str:
    text = f"(/ {abs(value.numerator)}.0 {value.denominator}.0)"
    return f"(- {text})" if value < 0 else text


def smt_of(statement: Statement, *, functions: bool) -> str | None:
    """The question as SMT-LIB; None if it has functions, and they are not wanted."""
    writer = _Writer()
    lines = writer.lines
    (row,) = statement.obligations
    if not isinstance(row.claim, Claim):
        return None
    writer.define(statement.constants)
    for context in statement.contexts:
        lines += [f"(declare-const |{variable.name}| Real)" for variable in context.variables]
        for given in context.givens:
            text = writer.claim(given.claim)
            lines.append(f"(assert {text})")
        writer.define(context.constants)
    text = writer.claim(row.claim)
    lines.append(f"(assert (not {text}))")
    ops = {term.op for term in writer.known}
    if not functions and not ops.isdisjoint(TRANSCENDENTAL):
        return None
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    if sys.argv[1:] in ([], ["--quick"]):
        print(*table_lines(peers_table("--quick" in sys.argv), width()), sep="\n")
    else:
        taken, found = timed(lambda: _ASKED[sys.argv[1]](sys.stdin.read()))
        print(json.dumps({"answer": found, "seconds": taken}))
