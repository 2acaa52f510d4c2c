"""The list of displayed formulas: nothing is left out, and every name in it exists."""

from __future__ import annotations

import re
from pathlib import Path

from verify.language.statement import NEEDED, Obligation
from verify.paper import theorem1
from verify.paper.commands import pages
from verify.paper.commands.pages import page
from verify.paper.commands.spectrum import cite_spectrum
from verify.prover.outcome import Outcome
from verify.prover.uses import nodes

TABLE = Path(theorem1.__file__).parent / "formulas.md"
ROOT = TABLE.parents[2]

#: Rows of the step that say what the model is.
ASIDE = ("impact-momentum", "impact-restitution", "impact-energy")

#: Rows that are no step to the theorem: which entries of the minima are the least.
OF_THEIR_OWN = ("redundant.", "active.")

#: The first formula of the theorem and its proof.
FIRST = 19

#: The labels of displayed formulas there, in the order of the LaTeX text.
LABELS = [
    f"EQUATSS4.1{name}"
    for name in (
        "ThExiCondi_r_1_",
        "ThExiCondiTheta",
        "DerivFonctF_1P-",
        "Quantite_C_eta_",
        "DonneInitiColSp",
        "SysteDynamColSp",
        "EvoluCompoNormC",
        "EvoluNormeVitRl",
        "EvoluCosinAngle",
        "DefinDeltxDelty",
        "DefinBorne_Eta_",
        "DefinBorne_Zeta",
        "DefinBorne_d_0_",
        "DescrDoIniColla",
        "Recurrence_Cnd1",
        "Recurrence_Cnd2",
        "Recurrence_Cnd3",
        "Recurrence_Cnd4",
        "Recurrence_CndT",
        "Recurrence_Cnd5",
        "Recurrence_Cnd6",
        "Recurrence_Cnd7",
        "Recurrence_Cnd8",
        "Recurrence_Cnd9",
        "Recurrence_Cnd10",
        "BorneParam_ZK0_",
        "BorneDista_d_1_",
        "_Controle_Tau_n",
        "DefinReste_y_n_",
        "Lien_x_n_&_y_n_",
        "DefinReste_x_n_",
        "Cntrlx_n+1Ameli",
    )
]

#: How many displayed formulas Section 4 has, counted in the LaTeX text.
DISPLAYED = 106


def table() -> list[list[str]]:
    """The cells of each line of the table: number, formula, what it says, carried by."""
    lines = TABLE.read_text(encoding="utf-8").splitlines()
    entries = [line for line in lines if re.match(r"\| \d+ \|", line)]
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", entry)[1:-1]] for entry in entries]


def rows() -> list[Obligation]:
    return [row for part in theorem1.theorem().parts.values() for row in part.obligations]


def constants() -> set[str]:
    statement = theorem1.theorem()
    chosen = [constant for part in statement.parts.values() for constant in part.bounds]
    return {constant.name for constant in (*statement.common, *chosen)}


def misprints() -> set[str]:
    """The rows that are refuted at states."""
    rows = page("step_as_printed").statement.obligations
    return {f"step-printed:{row.name}" for row in rows if row.severity}


def facts_elsewhere() -> set[str]:
    """The facts of the step and of other statements, and the rows that are refuted at states."""
    found = misprints() | {f"step:{name}" for name in nodes(pages.decide("step"))}
    for prefix, outcome in (
        ("elsewhere", pages.decide("sections_1_to_4")),
        ("spectrum", cite_spectrum()),
        ("classification", pages.decide("classification")),
    ):
        statement = outcome.statement
        found |= {f"{prefix}:{row.name}" for row in statement.obligations}
        found |= {f"{prefix}:{assumption.name}" for assumption in statement.assumptions}
    return found


def names(cell: str) -> list[str]:
    return re.findall(r"`([^`]+)`", cell)


def labels() -> list[str]:
    return [names(cells[1])[0] for cells in table() if not cells[1].startswith("(none)")]


def test_there_is_one_line_for_every_displayed_formula() -> None:
    assert [cells[0] for cells in table()] == [str(n) for n in range(1, DISPLAYED + 1)]
    for cells in table():
        assert len(cells) == 4
        assert all(cells)
        assert len(names(cells[1])) == 1
    assert f"All {DISPLAYED} displayed formulas" in TABLE.read_text(encoding="utf-8")


def test_every_name_that_carries_a_formula_exists() -> None:
    statement = theorem1.theorem()
    known = {row.name for row in rows()} | constants() | facts_elsewhere()
    known |= {assumption.name for assumption in statement.assumptions}
    unknown = [
        (cells[0], name) for cells in table() for name in names(cells[3]) if name not in known
    ]
    assert unknown == []


def test_every_constant_and_assumption_carries_a_formula() -> None:
    statement = theorem1.theorem()
    carrying = {name for cells in table() for name in names(cells[3])}
    # The collapse time and the induction are not displayed: the paper leaves them out.
    assert constants() - carrying == {"printed.T_star", "repaired.T_star"}
    assert {assumption.name for assumption in statement.assumptions} - carrying == {"induction"}


def test_every_label_of_a_row_is_in_the_table() -> None:
    listed = labels()
    assert len(listed) == len(set(listed))
    used = {row.label for row in rows()}
    assert {label for label in used if label.startswith("EQUATSS4.1")} <= set(listed)


def test_every_misprint_of_a_display_is_in_the_table() -> None:
    carrying = {name for cells in table() for name in names(cells[3])}
    displayed = set(labels())
    missing = {row.name for row in rows() if row.severity and row.label in displayed} - carrying
    assert missing == set()


def test_remarks_and_causes_name_things_that_exist() -> None:
    statement = theorem1.theorem()
    displayed = set(labels())
    for remark in statement.remarks:
        assert remark.label in displayed or remark.label == statement.name
    known = {row.name for row in rows()}
    short = {name.partition(".")[2] for name in known}
    mentioned = [name for remark in statement.remarks for name in names(remark.text)]
    mentioned += [name for cause in statement.causes for name in names(cause.text)]
    earlier = {"EQUATSS2.2LoiEvDistaInit1", "EQUATSS2.2LoiEvW1Om1Init1"}
    assert {n for n in mentioned if n.startswith("EQUATSS2")} == earlier
    folders = {name for name in mentioned if (ROOT / name / "certificate.json").exists()}
    assert set(mentioned) <= short | displayed | earlier | folders


def test_every_label_of_the_theorem_is_in_the_table() -> None:
    assert [label for label in labels() if label.startswith("EQUATSS4.1")] == LABELS


def test_every_wrong_estimate_is_beside_its_formula() -> None:
    carrying = {name for cells in table() for name in names(cells[3])}
    assert misprints() <= carrying


# --- to the theorem -------------------------------------------------------------------------------


def reaching(outcome: Outcome, ends: set[str]) -> set[str]:
    """The facts on which these rest, with themselves."""
    found, seen, todo = nodes(outcome), set[str](), sorted(ends)
    while todo:
        name = todo.pop()
        if name in found and name not in seen:
            seen.add(name)
            todo += found[name].uses
    return seen


def theorems_of_the_step() -> set[str]:
    """The induction, and what the glue puts together: it names its facts, `inside-...` by kind."""
    known = set(nodes(pages.decide("step")))
    glue = [a.sentence for a in pages.decide("step").assumptions if a.name.startswith("glue")]
    named = {word.strip(".,:;()") for sentence in glue for word in sentence.split()} & known
    assert any("inside-..." in sentence for sentence in glue)
    assert named >= {"always", "time-total", "outer-pair-apart", "angle-final-upper"}
    return named | {name for name in known if name.startswith("inside-")}


def on_a_path() -> set[str]:
    """The facts that the theorem rests on: those of the step, and the rows that make it apply."""
    step = {f"step:{name}" for name in reaching(pages.decide("step"), theorems_of_the_step())}
    return step | reaching(pages.decide("all_parameters"), {"collapse"})


def test_every_fact_of_the_step_is_on_a_path_to_the_theorem() -> None:
    found = on_a_path()
    hanging = {row.name for row, _ in pages.decide("step").rows if f"step:{row.name}" not in found}
    assert hanging == set(ASIDE)


def test_every_formula_of_the_proof_has_a_fact_on_a_path_to_the_theorem() -> None:
    """Others beside it are the paper's way to the same place, which the step does not take."""
    found = on_a_path()
    for cells in table():
        if int(cells[0]) >= FIRST and cells[3] != "definition of notation":
            there = {name.replace("printed.", "repaired.", 1) for name in names(cells[3])}
            assert there & found, cells[:3]


def test_every_needed_row_is_on_a_path_or_beside_a_fact_that_is() -> None:
    found, beside = on_a_path(), set[str]()
    for cells in table():
        there = {name.replace("printed.", "repaired.", 1) for name in names(cells[3])}
        if there & found:
            beside |= there
    rows = [row.name for row, _ in pages.decide("all_parameters").rows if row.role == NEEDED]
    hanging = [
        name for name in rows if name not in found | beside and not name.startswith(OF_THEIR_OWN)
    ]
    assert not hanging, (
        f"{', '.join(hanging)}: the theorem does not rest on it; name the row of the printed set "
        f"in verify/paper/{TABLE.name}, in the line of the formula to which it belongs"
    )
