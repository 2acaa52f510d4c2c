"""The list of formulas outside Section 4: nothing is left out, and every name in it exists."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from verify.language.statement import REFUTED
from verify.paper import theorem1
from verify.paper.commands import pages
from verify.paper.commands.pages import decide
from verify.paper.commands.spectrum import cite_spectrum
from verify.paper.source import printed_numbers
from verify.prover.outcome import Outcome
from verify.prover.uses import nodes

TABLE = Path(theorem1.__file__).parent / "formulas_of_sections_1_to_4.md"

#: How many displayed formulas there are, counted in the LaTeX text.
DISPLAYED = 169

#: The labels of those that have one, by their place in the order of the text.
LABELS = {
    5: "EQUATSS2.1_Loi_de_Newton_",
    6: "EQUATSS2.1VitesPost-Colli",
    10: "EQUATSS2.1DissiEnergCinet",
    12: "EQUATSS2.2LoiEvW1Om1Init1",
    14: "EQUATSS2.2LoiEvW1Om1Init2",
    15: "EQUATSS2.2LoiEvDistaInit1",
    17: "EQUATSS2.2LoiEvW2Om2Init1",
    20: "EQUATSS2.2CondiColliFutur",
    21: "EQUATSS2.2DiscrTrinox2-x0",
    22: "EQUATSS2.2TempsColliTauV1",
    23: "EQUATSS2.2TempsColliTauV2",
    24: "EQUATSS2.2DefinParZK_zeta",
    25: "EQUATSS2.2TempsColliTauV3",
    27: "EQUATSS2.2LoiEvDista_d'v1",
    28: "EQUATSS2.2DefinOmeg1Prime",
    29: "EQUATSS2.2DefinOmeg2Prime",
    30: "EQUATSS2.2VitesPostCVers2",
    31: "EQUATSS2.2ViteRPostCVers2",
    35: "EQUATSS2.2Eta_1PrimeVers1",
    37: "EQUATSS2.2Eta_1PrimeVers2",
    38: "EQUATSS2.2W1prpPrimeVers1",
    39: "EQUATSS2.2W2prpPrimeVers1",
    40: "EQUATSS2.2CosinAngleVers1",
    44: "EQUATSS2.2IterationSystm1",
    55: "EQUATSS3.2EtaCollisiSumma",
    59: "EQUATSS3.2eta_ij_CasColli",
    60: "EQUATSS3.2eta_ij_CasNColl",
    68: "EQUATSS3.3PROPOComp1Tau_d",
    69: "EQUATSS3.3PROPOComp1_d'__",
    70: "EQUATSS3.3PROPOComp1_eta'",
    71: "EQUATSS3.3PROPOComp1omga'",
    72: "EQUATSS3.3PROPOComp1PerpD",
    73: "EQUATSS3.3PROPOComp1PerpG",
    74: "EQUATSS3.3DisjoCVTauEta/W",
    75: "EQUATSS3.3DisjoCVTau_Zeta",
    76: "EQUATSS3.3AsympCompa_Tau_Zeta_",
    90: "EQUATSS3.3CompaAsymp_d__3",
    91: "EQUATSS3.3CompaAsympTauV2",
    93: "EQUATSS3.3PROPOComp2Tau_d",
    94: "EQUATSS3.3PROPOComp2_d'__",
    95: "EQUATSS3.3PROPOComp2_eta'",
    96: "EQUATSS3.3PROPOComp2omga'",
    97: "EQUATSS3.3PROPOComp2PerpD",
    101: "SECT6EquatSysteApproxEta_",
    103: "EQUATSS3.3CompaAsympTauV3",
    114: "EQUATSS3.5Eta1_Explicite_",
    117: "EQUATSS3.5ConclusionEta1>",
    119: "EQUATSS3.5VitesColli_0-1_",
    121: "EQUATSS3.5DefinMatrix_A_a",
    123: "EQUATSS3.5DefinMatrix_A_b",
    127: "EQUATSS3.5DefinMatrix_A_c",
    134: "EQUATSS3.5DefinSs-Ev__F__",
    135: "EQUATSS3.5MatrixAlim_ResF",
    136: "EQUATSS3.5Alim_PolynCarac",
    137: "EQUATSS3.5Alim_DetaiPCarQ",
    138: "EQUATSS3.5Alim_ContrRacRL",
    139: "EQUATSS3.5Alim_ContrRacCx",
    141: "EQUATSS3.5Alim_EspPp_L=1_",
    162: "EQUATSS3.5Minor_z'__Triag",
}

#: The numbered claims in the order of the text.
NUMBERED = (
    *("Definition 1", "Definition 2", "Remark 1", "Remark 2", "Lemma 1", "Definition 3"),
    *("Definition 4", "Remark 3", "Definition 5", "Remark 4", "Proposition 1", "Proposition 2"),
    *("Remark 5", "Definition 6", "Proposition 3", "Proposition 4", "Remark 6", "Proposition 5"),
    *("Remark 7", "Definition 7", "Definition 8", "Remark 8", "Proposition 6", "Proposition 7"),
    *("Remark 9", "Proposition 8", "Theorem 1", "Remark 10", "Remark 11", "Definition 9"),
    *("Remark 12", "Proposition 9", "Theorem 2", "Remark 13", "Proposition 10", "Definition 10"),
    *("Proposition 11", "Theorem 3", "Remark 14"),
)

#: What a line says that no row and no assumption carries.
REASONS = (
    "definition",
    "general mathematics",
    "formal approximation",
    "hypothesis",
    "nothing rests",
)

COMMANDS = {"verify theorem1", "verify spectrum", "certificates/sharper"}


def cells_of(line: str) -> list[str]:
    return [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]


@cache
def lines() -> list[list[str]]:
    found = TABLE.read_text(encoding="utf-8").splitlines()
    return [cells_of(line) for line in found if re.match(r"\| [^-N]", line)]


def displays() -> list[list[str]]:
    return [cells for cells in lines() if cells[0].isdigit()]


def claims() -> list[list[str]]:
    return [cells for cells in lines() if not cells[0].isdigit()]


def names(cell: str) -> list[str]:
    return re.findall(r"`([^`]+)`", cell)


def known_in(outcome: Outcome) -> set[str]:
    statement = outcome.statement
    return set(nodes(outcome)) | {row.name for row in statement.obligations}


@cache
def known() -> frozenset[str]:
    found = known_in(pages.decide("sections_1_to_4")) | COMMANDS
    found |= {a.name for a in pages.decide("sections_1_to_4").statement.assumptions}
    for prefix, outcome in (
        ("step", pages.decide("step")),
        ("spectrum", cite_spectrum()),
        ("classification", pages.decide("classification")),
        ("printed-set", decide("printed_set")),
    ):
        found |= {f"{prefix}:{name}" for name in known_in(outcome)}
        found |= {f"{prefix}:{a.name}" for a in outcome.statement.assumptions}
    return frozenset(found)


def test_there_is_one_line_for_every_displayed_formula() -> None:
    assert [cells[0] for cells in displays()] == [str(n) for n in range(1, DISPLAYED + 1)]
    for cells in lines():
        assert len(cells) == 4
        assert all(cells)
    assert f"All {DISPLAYED} displayed formulas" in TABLE.read_text(encoding="utf-8")


def test_the_labels_stand_where_they_do_in_the_text() -> None:
    for cells in displays():
        label = LABELS.get(int(cells[0]))
        (first,) = names(cells[1])
        assert cells[1].startswith("(none)") == (label is None)
        assert label in (None, first)


def test_there_is_one_line_for_every_numbered_claim() -> None:
    assert tuple(cells[0] for cells in claims()) == NUMBERED
    called = {number: label for label, number in printed_numbers().items()}
    for cells in claims():
        label = called.get(cells[0])
        assert cells[1] == ("(none)" if label is None else f"`{label}`")


@pytest.mark.parametrize("place", [2, 3])
def test_every_name_that_carries_a_line_exists(place: int) -> None:
    found = [(cells[0], name) for cells in lines() for name in names(cells[place])]
    assert [pair for pair in found if pair[1] not in known()] == []


def test_every_other_name_exists() -> None:
    text = TABLE.read_text(encoding="utf-8")
    said = text.partition("## Sentences that say more")[2]
    assert [name for name in names(said) if name not in known()] == []


def test_what_nothing_carries_has_a_reason() -> None:
    for cells in lines():
        if not names(cells[3]):
            assert any(reason in cells[3] for reason in REASONS), cells


def test_every_row_is_beside_what_it_is_about() -> None:
    other = (TABLE.parent / "formulas.md").read_text(encoding="utf-8")
    named = {name for cells in lines() for name in names(cells[3])}
    named |= {name.removeprefix("elsewhere:") for name in names(other)}
    assert {row.name for row in pages.decide("sections_1_to_4").statement.obligations} <= named


def test_what_is_refuted_is_called_refuted() -> None:
    """A line does not lean on a row that is false without saying that it is."""
    wrong = {row.name for row, d in pages.decide("sections_1_to_4").rows if d.verdict == REFUTED}
    wrong |= {f"spectrum:{row.name}" for row, d in cite_spectrum().rows if d.verdict == REFUTED}
    for cells in lines():
        if set(names(cells[3])) & wrong:
            words = (
                "refuted",
                "not follow",
                "nothing rests",
                "not from the display",
                "see ",
                "not by",
            )
            assert any(word in cells[3] for word in words), cells


def test_what_is_called_refuted_is_refuted() -> None:
    """The names after the word, up to where the sentence goes on, are those of false rows."""
    wrong = {row.name for row, d in pages.decide("sections_1_to_4").rows if d.verdict == REFUTED}
    wrong |= {f"spectrum:{row.name}" for row, d in cite_spectrum().rows if d.verdict == REFUTED}
    found = 0
    for cells in lines():
        for said in re.findall(r"refuted(?: |:)([^;]*)", cells[3]):
            accused = names(re.split(r"`: |, see|, corrected by", f"{said} ")[0])
            assert {*accused} <= wrong, cells
            found += len(accused)
    assert found > 20
