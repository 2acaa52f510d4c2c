"""Speed against error, measured: the job `bench`.

Times are CPU times, the least of repeated runs, and what is compared takes turns: whatever else a
machine does only adds to a time. Errors are exact: widths of enclosures, and distances from a
4096-bit enclosure.
"""

from __future__ import annotations

import math
import resource
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from typing import Any

from verify.language.fold import fails, holds
from verify.language.statement import PROVED, REFUTED, UNDECIDED
from verify.language.terms import Claim, Term, as_term
from verify.measure import Table, table, timed
from verify.measure.engines import ArbEngine, CheckerEngine, DoubleEngine, MpmathEngine, load
from verify.measure.inequalities import inequality_table
from verify.measure.maps import maps_table
from verify.measure.scenes import scene_tables
from verify.measure.separatrix import separatrix_table
from verify.paper.commands import eigenvalues
from verify.paper.commands.scan import Grid, Scan
from verify.paper.commands.slack import SHARE, find_slack
from verify.paper.commands.theorem1 import constants_enclosure, decide_point
from verify.prover import balls
from verify.prover.decimals import decimal_text, round_decimal
from verify.prover.outcome import Ends, Outcome
from verify.prover.program import Program, UndefinedError

PRECISIONS = (53, 64, 96, 128, 192, 256, 512, 1024, 2048, 4096)
REFERENCE_BITS = 4096

#: Points at which doubles are judged: an easy one, and three at which an ordinary script fails.
DOUBLE_POINTS = {
    "r = 3/100, c = 1": ("3/100", "1"),
    "r = 1e-16, c = 1": ("1e-16", "1"),
    "r = 0.0557280900008, c = 1 (next to 9-4√5)": ("0.0557280900008", "1"),
    "r = 1/64, c = 8/13 + 1e-15": ("1/64", str(Fraction(8, 13) + Fraction(1, 10**15))),
}

#: The command whose cost is compared with that of importing flint.
MAIN_JOB = "verify theorem1 --r 0.03"
WITHOUT_PYC = f"{MAIN_JOB}, without .pyc"

Progress = Callable[[str], None]


def parameters(r: str, c: str) -> dict[str, Term]:
    """The parameters with V_0 = 1 and delta_theta = 1/10."""
    texts = {"r": r, "c": c, "V_0": "1", "delta_theta": "1/10"}
    return {name: as_term(Fraction(text)) for name, text in texts.items()}


#: How often `run_benchmarks` tells its progress.
STEPS = 11
#: The tables that it makes.
TABLES = (
    *("precision", "equal_width", "spectrum", "decided", "doubles", "double_verdicts"),
    *("throughput", "scene_precision", "scene_simulation", "maps", "separatrix", "processes"),
    *("slack", "inequalities"),
)


def run_benchmarks(quick: bool, progress: Progress) -> dict[str, Table]:
    """All tables. ``quick`` takes fewer precisions and repetitions."""
    precisions = (53, 128, 512) if quick else PRECISIONS
    rounds = 3 if quick else 11
    outcome = decide_point(parameters("3/100", "1"))
    tables = {}
    progress("precision against time and width")
    tables["precision"], tables["equal_width"] = precision_tables(outcome, precisions, rounds)
    progress("the spectrum at a point")
    tables["spectrum"] = spectrum_table(precisions, rounds)
    progress("precision against the share of rows decided")
    tables["decided"] = decided_table(outcome, precisions, rounds)
    progress("doubles against a 4096-bit enclosure")
    tables["doubles"], tables["double_verdicts"] = double_tables()
    progress("throughput")
    tables["throughput"] = throughput_table(100 if quick else 1000, rounds)
    progress("scenes")
    tables |= scene_tables([bits for bits in precisions if bits <= 512], rounds, _cpu)
    progress("maps")
    tables["maps"] = maps_table(quick, 1 if quick else 3, _cpu)
    progress("the separatrix")
    tables["separatrix"] = separatrix_table(quick, rounds)
    progress("whole processes")
    tables["processes"] = process_table(3 if quick else 15)
    progress("bounds with slack")
    tables["slack"] = slack_table(quick)
    progress("published inequalities")
    tables["inequalities"] = inequality_table(quick)
    return tables


def out_of_date(tables: Mapping[str, Table]) -> list[str]:
    """Why measurements are not those that the program would make in full; nothing if they are."""
    found = [f"has no table {name}" for name in TABLES if name not in tables]
    found += [f"has a table {name}, which is not made now" for name in tables if name not in TABLES]
    wanted = {"precision": map(str, PRECISIONS), "processes": [*_commands(""), WITHOUT_PYC]}
    for name in wanted.keys() & tables.keys():
        if [str(row[0]) for row in tables[name]["rows"]] != list(wanted[name]):
            found.append(f"the table {name} has other rows")
    return sorted(found)


def theorem_program(outcome: Outcome) -> tuple[Program, list[int]]:
    """The constants and both sides of every row as one program without inputs."""
    program = definitions_program(outcome)
    sides = [t for _, claim in claims_of(outcome) for t in (claim.lhs, claim.rhs)]
    slots = {*program.slots.values(), *(program.add(term) for term in sides)}
    return program, sorted(slots)


def definitions_program(outcome: Outcome) -> Program:
    """Parameters and constants as one program without inputs."""
    program = Program(())
    statement = outcome.statement
    definitions = {**statement.parameters, **{c.name: c.term for c in statement.constants}}
    for name, term in definitions.items():
        program.define(name, term)
    return program


def claims_of(outcome: Outcome) -> list[tuple[str, Claim]]:
    """The rows that compare numbers."""
    found = ((row.name, row.claim) for row, _ in outcome.rows)
    return [(name, claim) for name, claim in found if isinstance(claim, Claim)]


def relative_width(ends: Ends) -> Fraction:
    """The width over the smaller absolute end; 0 for an exact number."""
    low, high = ends
    least = min(abs(low), abs(high))
    if low == high:
        return Fraction(0)
    return (high - low) / least if least and low * high > 0 else Fraction(1)


def precision_tables(
    outcome: Outcome, precisions: Sequence[int], rounds: int
) -> tuple[Table, Table]:
    """Time and largest relative width of each engine at each precision, and at equal widths."""
    program, slots = theorem_program(outcome)
    engines: list[Any] = [ArbEngine(), CheckerEngine(), MpmathEngine()]
    rows: list[list[Any]] = []
    raw: dict[str, list[float]] = {}
    measured: dict[tuple[str, int], tuple[float, Fraction]] = {}
    for bits in precisions:
        times: dict[str, list[float]] = {engine.name: [] for engine in engines}
        widths: dict[str, Fraction] = {}
        for _ in range(rounds):
            for engine in engines:
                seconds, widths[engine.name] = _timed_run(engine, program, slots, bits)
                times[engine.name].append(seconds)
        for name, seconds_list in times.items():
            raw[f"{name} {bits}"] = seconds_list
            measured[name, bits] = min(seconds_list), widths[name]
        row: list[Any] = [bits]
        for engine in engines:
            seconds, width = measured[engine.name, bits]
            row += [milliseconds(seconds), scientific(width)]
        rows.append(row)
    columns = ["bits"] + [f"{e.name}: {what}" for e in engines for what in ("ms", "width")]
    title = "Constants and rows of Theorem 1 at r = 3/100: time and largest relative width"
    precision = table(title, columns, rows, raw_seconds=raw)
    return precision, _equal_width_table(program, slots, measured, precisions, rounds)


def _timed_run(
    engine: Any, program: Program, slots: Sequence[int], bits: int
) -> tuple[float, Fraction]:
    """The seconds of one run, and the largest relative width of its enclosures."""
    with engine.at(bits):
        seconds, run = timed(partial(load(program, engine).run, ()))
        values = run.values
        widths = [relative_width(engine.ends(values[s])) for s in slots if values[s] is not None]
    return seconds, max(widths)


def _equal_width_table(
    program: Program,
    slots: Sequence[int],
    measured: dict[tuple[str, int], tuple[float, Fraction]],
    precisions: Sequence[int],
    rounds: int,
) -> Table:
    """Arb with as many extra bits as mpmath's width takes, timed against it in turn."""
    arb, mpmath = ArbEngine(), MpmathEngine()
    rows = []
    for bits in precisions:
        width = measured["mpmath iv", bits][1]
        extra = bits
        while True:
            _, found = _timed_run(arb, program, slots, extra)
            if found <= width:
                break
            extra += 4
        pairs = [
            (_timed_run(arb, program, slots, extra)[0], _timed_run(mpmath, program, slots, bits)[0])
            for _ in range(3 * rounds)
        ]
        ours, theirs = map(min, zip(*pairs, strict=True))
        rows.append([bits, extra, scientific(width), scientific(found), f"{theirs / ours:.1f}"])
    title = "At equal width: how many times faster Arb is than mpmath iv"
    columns = ["mpmath bits", "Arb bits", "mpmath width", "Arb width", "speed ratio"]
    return table(title, columns, rows)


def spectrum_table(precisions: Sequence[int], rounds: int) -> Table:
    """Time and largest relative width of the spectrum at r = 3/100."""
    rows: list[list[Any]] = []
    r = Fraction(3, 100)
    for bits in precisions:
        seconds, found = timed(partial(eigenvalues.at, r, bits), rounds)
        parts = (found.lambda_0, *found.plus, found.modulus, found.argument)
        with balls.precision(2 * bits):
            width = max(relative_width(balls.ends(ball)) for ball in parts)
        rows.append([bits, milliseconds(seconds), scientific(width)])
    title = "Eigenvalues at r = 3/100: time and largest relative width"
    return table(title, ["bits", "ms", "width"], rows)


def decided_table(outcome: Outcome, precisions: Sequence[int], rounds: int) -> Table:
    """Which share of the rows the enclosures at one precision decide."""
    program, _ = theorem_program(outcome)
    claims = [claim for _, claim in claims_of(outcome)]
    rows: list[list[Any]] = []
    for bits in precisions:
        seconds, decided = timed(partial(_decided_at, program, claims, bits), rounds)
        rows.append([bits, f"{decided} of {len(claims)}", milliseconds(seconds)])
    title = "Rows of Theorem 1 at r = 3/100 that enclosures at one precision decide"
    return table(title, ["bits", "decided", "ms"], rows)


def _decided_at(program: Program, claims: Iterable[Claim], bits: int) -> int:
    with balls.precision(bits):
        values = load(program, balls.BallArithmetic()).run(()).values
        pairs = [(c.relation, values[program.add(c.lhs)], values[program.add(c.rhs)])
                 for c in claims]  # fmt: skip
        return sum(
            lhs is not None
            and rhs is not None
            and (holds(relation, lhs, rhs) or fails(relation, lhs, rhs))
            for relation, lhs, rhs in pairs
        )


def double_tables() -> tuple[Table, Table]:
    """What plain doubles get wrong: digits of constants, and verdicts."""
    digits: list[list[Any]] = []
    verdicts: list[list[Any]] = []
    for point, (r, c) in DOUBLE_POINTS.items():
        outcome = decide_point(parameters(r, c), "printed")
        program, _ = theorem_program(outcome)
        values = load(program, DoubleEngine()).run(()).values
        worst = sorted(_digits(outcome, program, values))
        shown = ", ".join(f"{name}: {count:.1f}" for count, name in worst[:6])
        digits.append([point, shown, f"{median(count for count, _ in worst):.1f}"])
        claims = claims_of(outcome)
        wrong = [
            f"{name.partition('.')[2]} ({verdict} for {outcome.decisions[name].verdict})"
            for name, claim in claims
            for verdict in [_double_verdict(claim, values, program)]
            if verdict != outcome.decisions[name].verdict
        ]
        verdicts.append([point, len(claims), len(wrong), ", ".join(wrong[:8])])
    title = "Correct digits of the constants in plain doubles (16 at best)"
    columns = ["point", "rows", "wrong", "which (at most eight)"]
    return (
        table(title, ["point", "worst constants", "median"], digits),
        table("Verdicts that plain doubles get wrong", columns, verdicts),
    )


def _digits(
    outcome: Outcome, program: Program, values: Sequence[float | None]
) -> list[tuple[float, str]]:
    """The correct digits of each constant, and of the printed formula for phi_minus."""
    with balls.precision(REFERENCE_BITS):
        exact = load(program, balls.BallArithmetic()).run(()).values
        true = {
            name: balls.ends(exact[slot])[0]
            for name, slot in program.slots.items()
            if exact[slot] is not None
        }
    found = [
        (_correct_digits(values[program.slots[constant.name]], true[constant.name]),
         constant.short_name)
        for constant in outcome.statement.constants
    ]  # fmt: skip
    textbook = _textbook(*(float(outcome.statement.parameters[name].value) for name in ("r", "c")))
    return [*found, (_correct_digits(textbook, true["phi_minus"]), "textbook φ⁻")]


def _correct_digits(value: float | None, true: Fraction) -> float:
    if value is None:
        return 0.0
    error = abs(Fraction(value) / true - 1)
    return 16.0 if error == 0 else min(16.0, max(0.0, -_log10(error)))


def _textbook(r: float, c: float) -> float:
    """(alpha_0 - sqrt(alpha_0^2 - 4r))/2, the printed formula, in doubles."""
    alpha = (1 + r) / 2 * c
    return (alpha - math.sqrt(max(0.0, alpha * alpha - 4 * r))) / 2


def _double_verdict(claim: Claim, values: Sequence[Any], program: Program) -> str:
    try:
        lhs, rhs = values[program.add(claim.lhs)], values[program.add(claim.rhs)]
    except (UndefinedError, IndexError):
        return UNDECIDED
    if lhs is None or rhs is None:
        return UNDECIDED
    return PROVED if holds(claim.relation, lhs, rhs) else REFUTED


def _sweep(grid: Grid) -> None:
    job = Scan()
    for i in range(grid.steps):
        job.at({**grid.parameters, "r": grid.value(i)})


def throughput_table(count: int, rounds: int) -> Table:
    """Parameter points per second, in one process."""
    points = [str(Fraction(k, 20 * count)) for k in range(1, count + 1)]
    enclose = constants_enclosure(128)
    exact = [{name: t.value for name, t in parameters(r, "1").items()} for r in points]
    constants, _ = timed(lambda: [enclose(p) for p in exact], rounds)
    some = points[:: max(1, count // 20)]
    single, _ = timed(lambda: [decide_point(parameters(r, "1")) for r in some], rounds)
    grid = Grid(Fraction(1, 1000), Fraction(55, 1000), count, exact[0])
    full, _ = timed(lambda: _sweep(grid), rounds)
    rows = [
        ["all constants of the printed proof", round(count / constants)],
        ["all rows of both sets, on a grid (--steps)", round(count / full)],
        ["the same with proofs and enclosures, point by point", round(len(some) / single)],
    ]
    return table("Throughput in one process at 128 bits", ["work", "points per second"], rows)


def process_table(rounds: int) -> Table:
    """CPU of whole processes, as ratios to an empty one and to one that imports flint.

    They take turns, and the least time of each counts: what else runs only adds to one. Without
    .pyc: the program alone is compiled each time, Python's library and flint are not.
    """
    with TemporaryDirectory() as folder:
        commands = _commands(folder)
        times: dict[str, list[float]] = {name: [] for name in [*commands, WITHOUT_PYC]}
        sources = Path(__file__).parents[1]
        shutil.copytree(
            sources, Path(folder, "verify"), ignore=shutil.ignore_patterns("__pycache__")
        )
        for _ in range(rounds):
            for name, words in commands.items():
                times[name].append(_cpu(words))
            times[WITHOUT_PYC].append(_cpu(["-B", *commands[MAIN_JOB]], folder))
    empty, flint = min(times["python -c pass"]), min(times["python -c 'import flint'"])
    rows = [
        [name, milliseconds(least), f"{least / empty:.2f}", f"{least / flint:.2f}"]
        for name, least in ((name, min(seconds)) for name, seconds in times.items())
    ]
    columns = ["command", "ms", "times an empty process", "times importing flint"]
    return table("CPU time of whole processes", columns, rows, raw_seconds=times)


def _commands(folder: str) -> dict[str, list[str]]:
    """What Python is started with, by names; files go into a folder."""
    point = str(Path(folder, "point"))
    main_job = ["-m", "verify", "theorem1", "--r", "0.03"]
    return {
        "python -c pass": ["-c", "pass"],
        "python -c 'import flint'": ["-c", "import flint"],
        MAIN_JOB: main_job,
        "verify theorem1 --r 0.03 --json": [*main_job, "--json"],
        "verify theorem1 --all": ["-m", "verify", "theorem1", "--all"],
        "verify explain delta_1": ["-m", "verify", "explain", "delta_1"],
        "verify explain ratio-falls": ["-m", "verify", "explain", "ratio-falls"],
        "verify theorem1 --r 0.02..0.03": ["-m", "verify", "theorem1", "--r", "0.02..0.03"],
        "verify spectrum": ["-m", "verify", "spectrum"],
        "verify classification": ["-m", "verify", "classification"],
        "verify elsewhere": ["-m", "verify", "elsewhere"],
        "verify theorem1 --r 0.03 --out POINT": [*main_job, "--out", point],
        "verify check POINT": ["-m", "verify", "check", point],
    }


def _cpu(words: Sequence[str], folder: str | None = None) -> float:
    """The seconds that Python takes with these words, in a folder; what fails is not measured."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(  # noqa: S603 - our own commands
        [sys.executable, *words],
        cwd=folder,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        check=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


#: The bounds with slack that the quick form looks at.
SOME = ("repaired.y-ratio", "repaired.zeta-ratio", "repaired.zeta-main", "repaired.x-improved")


def slack_table(quick: bool) -> Table:
    """Bounds for all parameters that are proved with a tenth to spare, of how many looked at."""
    found = find_slack(SOME if quick else None)
    rows = [
        [bound.row.name, bound.row.label, bound.row.says]
        for bound in found.bounds
        if bound.row.name in found.slack
    ]
    title = (
        f"Bounds with slack: with {SHARE} of the larger side {len(found.accepted)} of "
        f"{len(found.bounds)} are proved by the committed proofs, these {len(rows)} by others"
    )
    return table(title, ["bound", "label", "what it says"], rows)


def milliseconds(seconds: float) -> str:
    """A time in milliseconds with three digits."""
    return f"{seconds * 1e3:.3g}"


def scientific(width: Fraction) -> str:
    """A width as a power of ten, rounded up."""
    if width == 0:
        return "0"
    return decimal_text(*round_decimal(width, 2, up=True))


def _log10(value: Fraction) -> float:
    """The decimal logarithm of a positive rational of any size, to a few digits."""
    shift = value.numerator.bit_length() - value.denominator.bit_length()
    return math.log10(float(value / Fraction(2) ** shift)) + shift * math.log10(2)
