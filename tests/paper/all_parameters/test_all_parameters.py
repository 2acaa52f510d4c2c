"""Theorem 1 for all parameters: accepted, true at random parameters, refused if changed."""

from __future__ import annotations

import random
from fractions import Fraction
from pathlib import Path

import pytest

from tests.citing import cited
from tests.paper.changed_statements import report
from verify import check
from verify.language.fold import fails
from verify.language.statement import NEEDED, PROVED, Constant
from verify.language.terms import Claim, Term
from verify.paper.commands import pages
from verify.paper.parameters import PRINTED, REPAIRED
from verify.paper.theorem1 import theorem
from verify.prover import balls
from verify.prover.balls import BallArithmetic
from verify.prover.outcome import Outcome
from verify.prover.program import Machine, Program
from verify.prover.proof import LemmaStep, ObligationStep
from verify.wire.read import read
from verify.wire.write import write

#: The context of all parameters.
CONTEXT = "everywhere"


def test_everything_is_proved_and_small() -> None:
    outcome = pages.decide("all_parameters")
    files = write(outcome)
    assert outcome.verdict == PROVED
    assert {row.verdict for row in outcome.decisions.values()} == {PROVED}
    assert report(outcome).verdict == "PROVED"
    own = (data for name, data in files.items() if not name.startswith("cited/"))
    assert sum(map(len, own)) < 400_000
    assert read(files["statement.json"], files["certificate.json"], cited(files)) == outcome.draft


def test_the_rows_are_those_of_the_theorem() -> None:
    rows = {row.name: row for row in pages.decide("all_parameters").statement.obligations}
    for row in theorem().parts[REPAIRED].obligations:
        if row.role == NEEDED:
            assert rows[row.name].claim == row.claim
            assert rows[row.name].context == CONTEXT


def test_the_last_line_closes_the_citation(tmp_path_factory: pytest.TempPathFactory) -> None:
    """By the certificate beside it, or another folder of the run."""
    folders = []
    for name in ("all_parameters", "step"):
        folder, outcome = tmp_path_factory.mktemp(name), pages.decide(name)
        for file, data in write(outcome).items():
            (folder / file).parent.mkdir(exist_ok=True)
            (folder / file).write_bytes(data)
        folders.append(str(folder))
    code, lines = check.check_folders(check.read_folders(folders))
    assert code == 0
    assert not any("which is not proved here" in line for line in lines)
    for path in Path(folders[0], "cited").glob("*.certificate.json"):
        code, lines = check.check_folders(check.read_folders(folders[:1]))
        assert (code, lines[-1].partition("; given ")[2].count("step:")) == (0, 9)
        path.unlink()
    code, lines = check.check_folders(check.read_folders(folders[:1]))
    assert (code, lines[-1].partition("; given ")[2].count("step:")) == (3, 9)
    assert "which is not proved here" in lines[-1]


def test_every_fact_holds_at_random_parameters() -> None:
    names = ("r", "c", "V_0", "delta_theta")
    program = Program(names)
    for constant in pages.statement("all_parameters").context(CONTEXT).constants:
        program.define(constant.name, constant.term)
    claims: dict[str, Claim] = {}
    rows = {row.name: row for row in pages.decide("all_parameters").statement.obligations}
    for item in pages.decide("all_parameters").steps:
        if isinstance(item, LemmaStep) and item.context == CONTEXT:
            claims[item.name] = item.claim
        if isinstance(item, ObligationStep) and rows[item.name].context == CONTEXT:
            claim = rows[item.name].claim
            if isinstance(claim, Claim):
                claims[item.name] = claim
    slots = {n: (program.add(c.lhs), program.add(c.rhs)) for n, c in claims.items()}
    chosen = random.Random(3)
    with balls.precision(600):
        machine = Machine(program, BallArithmetic())
        for _ in range(60):
            values = machine.run([balls.from_fraction(x) for x in admissible(chosen)]).values
            for name, (x, z) in slots.items():
                assert not fails(claims[name].relation, values[x], values[z]), name


def admissible(chosen: random.Random) -> tuple[Fraction, ...]:
    """r, c, V_0 and delta_theta that satisfy the hypotheses, extremes included."""
    root = Fraction(chosen.choice([1, 10, 100, 300, 380]), 1000)
    r = root**3
    least = 2 * root * (1 + root) / (1 + r)
    share = chosen.choice([Fraction(1, 10**6), Fraction(1, 2), 1 - Fraction(1, 10**6), Fraction(1)])
    power = Fraction(10) ** chosen.randrange(-12, 12)
    return r, least + (1 - least) * share, power, Fraction(10) ** chosen.randrange(-6, 2)


def with_entry(name: str, entry: int, factor: Fraction) -> Outcome:
    """The certificate, of a statement in which one entry of a minimum is larger."""
    outcome = pages.decide("all_parameters")
    context = outcome.statement.contexts[0]

    def changed(constant: Constant) -> Constant:
        if constant.name != f"{REPAIRED}.{name}":
            return constant
        entries = list(constant.term.children)
        entries[entry - 1] = entries[entry - 1] * factor
        return constant._replace(term=Term("min", *entries))

    own = context._replace(constants=tuple(map(changed, context.constants)))
    return outcome._replace(statement=outcome.statement._replace(contexts=(own,)))


@pytest.mark.parametrize(
    ("name", "entry"),
    [("delta_x", 6), ("Delta_theta", 2), ("eta_bar", 3), ("eta_bar", 6), ("zeta_bar", 4)],
)
def test_a_larger_bound_is_refused(name: str, entry: int) -> None:
    assert report(with_entry(name, entry, Fraction(1001, 1000))).verdict == "REFUSED"


def test_without_a_hypothesis_it_is_refused() -> None:
    outcome = pages.decide("all_parameters")
    context = outcome.statement.contexts[0]
    for i in range(len(context.givens)):
        fewer = context._replace(givens=context.givens[:i] + context.givens[i + 1 :])
        lie = outcome._replace(statement=outcome.statement._replace(contexts=(fewer,)))
        try:
            assert report(lie).verdict == "REFUSED"
        except check.Malformed:
            continue


@pytest.mark.parametrize(
    ("page", "group"),
    [
        ("all_parameters", REPAIRED),
        ("printed_rows", PRINTED),
        ("printed_set", PRINTED),
        ("thresholds", PRINTED),
    ],
)
def test_the_constants_are_those_of_the_theorem(page: str, group: str) -> None:
    known = {c.name: c for c in (*theorem().common, *theorem().parts[group].bounds)}
    found = {c.name: c for c in pages.statement(page).context(CONTEXT).constants}
    assert {name: found[name] for name in known} == known
