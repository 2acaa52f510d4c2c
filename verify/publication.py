"""What is said of a text in print: how bad its slips are, and what stands beside its labels.

Statements, proofs and certificates know nothing of it; `verify/paper` fills it in, and the views
show it.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence

from verify.language.record import Record
from verify.language.statement import Constant, Obligation

#: The step is refuted, and what the paper concludes from it does not follow.
BREAKS = "breaks the argument"
#: The sentence is false, and nothing that follows rests on it; what does rests on other rows.
HARMLESS = "false, but harmless here"
#: The sentence is false as it is written, and what it plainly means is a row of its own.
SLIP = "slip of wording"
#: What is said besides of a slip that, taken literally, makes the theorem false.
FATAL = "fatal to the theorem as printed"
#: How bad it is that a printed row is false, the worst first.
ACCUSATIONS = (BREAKS, HARMLESS, SLIP)
#: The sentence is true by the row that takes its place; the claim is what the text derives it from.
OTHERWISE = "proved; not by the printed argument"
#: The claim is false, and the text does not make it: nothing is held against the paper.
REMARK = "remark"
#: What a printed row is whose claim is false.
SEVERITIES = (*ACCUSATIONS, OTHERWISE, REMARK)

#: Groups of rows, beside those of the set as PRINTED: what a theorem assumes, and what repairs it.
HYPOTHESES, REPAIRED = "hypotheses", "repaired"

#: How the parameters of Theorem 1 are written, in the paper's order.
LETTERS = {"r": "r", "c": "(-cos θ₀)", "V_0": "V₀", "delta_theta": "δ_θ"}

#: How they, and some constants, stand in titles and sentences.
TITLE_LETTERS = {
    "V_0": "V₀",
    "delta_theta": "δ_θ",
    "theta_0": "θ₀",
    "<=": "≤",
    "Delta_theta": "Δθ",
    "eta_bar": "η̄",
    "zeta_bar": "ζ̄",
    "d_bar": "d̄",
    "delta_x": "δ_x",
    "delta_y": "δ_y",
    "eta_s": "η_s",
    "d_0": "d₀",
    "Theta/6": "Θ/6",
    "sqrt(r)": "√r",
    "]0,1[": "(0, 1)",
}


class Change(Record):
    """One line of the table `paper | needed | why`, with the rows of the repaired set behind it."""

    label: str
    paper: str
    needed: str
    why: str
    rows: tuple[str, ...]


class Cause(Record):
    """What is wrong, once, with the names of all rows that show it."""

    rows: tuple[str, ...]
    text: str


class Remark(Record):
    r"""A sentence about the text near one of the paper's ``\label``s."""

    label: str
    text: str


class Notes(Record):
    """What there is to say of a text where no row says it.

    ``causes`` has names of rows that are false for one reason, with the reason; ``remarks`` have a
    label each. ``bounds`` has for each constant the sign after it, and its definition or bound.
    """

    changes: Sequence[Change]
    causes: Sequence[tuple[Sequence[str], str]]
    remarks: Sequence[tuple[str, str]]
    bounds: Mapping[str, tuple[str, Constant]]


class Publication(Record):
    r"""The text that statements are about, for those who show them.

    ``theorem`` is the label of its main theorem, ``printed`` gives what stands in print beside a
    ``\label`` (the number of a formula, a section or a theorem) or None, and ``folders`` says where
    the certificates of cited theorems are. ``in_coq`` has for a theorem the sentences that it takes
    on trust and Coq proves, by their names, ``cited_in_coq`` the theorems that it cites and Coq
    proves; ``whole_in_coq`` are those that Coq proves as a whole. ``notes`` are made where they are
    shown. ``source`` is the SHA-256 of the text that was read, and ``fatal`` has the names of the
    rows that refute the theorem if they are taken literally, with what is misprinted there.
    """

    authors: str
    title: str
    companion: str
    theorem: str
    printed: Callable[[str], str | None]
    folders: Mapping[str, str]
    in_coq: Mapping[str, Collection[str]]
    cited_in_coq: Mapping[str, Collection[str]]
    whole_in_coq: Collection[str]
    notes: Callable[[], Notes]
    source: Callable[[], str]
    fatal: Mapping[str, str]

    def number(self, label: str) -> str:
        """What a label is called in print, or the label itself."""
        return self.printed(label) or label

    def cited(self, label: str) -> str:
        """A label with its printed number before it; a label that has none as it is."""
        number = self.printed(label)
        return label if number is None else f"{number}, {label}"

    @property
    def text_read(self) -> str:
        """Which version of the text was read."""
        return f"the LaTeX text with the SHA-256 {self.source()}"

    def severity(self, row: Obligation) -> str:
        """How bad it is that a row is false, and whether the theorem is false with it."""
        found = row.severity or ""
        return f"{found}, {FATAL}" if row.name in self.fatal else found

    def has(self, labels: Iterable[str]) -> bool:
        """Whether one of the labels is of this text: a statement without any is somebody else's."""
        return any(self.printed(label) is not None for label in labels)


#: A text that is not in print, and of which nothing is known.
NOBODYS = Publication(
    "", "", "", "", lambda _: None, {}, {}, {}, (), lambda: Notes((), (), (), {}), lambda: "", {}
)
