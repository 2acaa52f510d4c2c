"""What commands find, as records that views show: nothing is computed, and nothing decided here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import Any

from verify.language.record import Record
from verify.language.statement import UNDECIDED, Constant
from verify.language.terms import Claim
from verify.prover.outcome import Ends, Outcome
from verify.publication import Publication

#: Two intervals, one for each side of a cell.
Cell = tuple[Ends, ...]


# --- Theorem 1 at many points --------------------------------------------------------------------


class ParameterBox(Record):
    """Closed intervals of r and of -cos theta_0."""

    r: Ends
    c: Ends

    @property
    def area(self) -> Fraction:
        """The product of the lengths of the sides."""
        return (self.r[1] - self.r[0]) * (self.c[1] - self.c[0])


class Answer(Record):
    """The verdict on a box, the part of it that is certified, and what is certified about that.

    If the box is undecided, the part is one on which the hypotheses hold, and the outcome is about
    that part.
    """

    box: ParameterBox
    part: ParameterBox
    outcome: Outcome

    @property
    def verdict(self) -> str:
        """That of the outcome, if it is about the whole box."""
        return self.outcome.verdict if self.part == self.box else UNDECIDED


class ScannedPoint(Record):
    """The verdict on the needed rows at one point, and those on all rows by their names."""

    verdict: str
    rows: Mapping[str, str]


# --- the other theorems at one r -----------------------------------------------------------------


class AtR(Record):
    """What the theorems on collapses say at one r.

    ``excluded``: three equal balls have no collapse, and finitely many collisions. ``longest``: the
    largest number of collisions of a run in which one ball meets two others in turn; None if there
    is no largest one, or where ``undecided`` says that the work did not suffice to find it.
    ``comes_to_rest``: in a collapse both velocities relative to the middle ball tend to 0.
    """

    r: Fraction
    least_neg_cos: Ends
    excluded: bool
    longest: int | None
    undecided: bool
    comes_to_rest: bool


class AboutMiddle(Record):
    """What is possible with one of three balls in the middle, all pairs with the same r.

    ``excluded``: no collapse has it in the middle. ``comes_to_rest``: all relative motion ends in
    one. ``largest_r`` encloses the number above which the first is so.
    """

    ball: int
    excluded: bool
    comes_to_rest: bool
    largest_r: Ends


class AtMasses(Record):
    """The same of three masses, each in the middle."""

    r: Fraction
    masses: tuple[Fraction, ...]
    middles: tuple[AboutMiddle, ...]


class Count(Record):
    """A number of collisions, and the least r with so many: enclosed, and written exactly.

    ``exact`` is empty where the number is no quadratic one, or long.
    """

    collisions: int
    least_r: Ends
    exact: str


class OnALine(Record):
    """Collisions on a line, where one of two outer balls hits the two others, at rest, by r.

    ``share`` is M = m_1 m_2/((m_0+m_1)(m_0+m_2)), for ball 0 in the middle. Up to ``endless`` there
    is no end of collisions, and above it no collapse with this ball in the middle, on a line or
    not. The first of ``counts`` is for all r up to 1.
    """

    ball: int
    share: Fraction
    endless: Count
    counts: tuple[Count, ...]


VECTORS = ("vector_0", "vector_plus")


class Rectangle(Record):
    """Enclosures of the real and the imaginary part of a complex number: balls, or intervals."""

    real: Any
    imaginary: Any

    def __str__(self) -> str:
        return complex_told(str(self.real), str(self.imaginary))


def complex_told(real: str, imaginary: str) -> str:
    """A complex number from its parts: 1, or 0.105… - i 0.245…."""
    if imaginary == "0":
        return real
    if imaginary.startswith("["):
        return f"{real} + i {imaginary}"
    sign = "-" if imaginary.startswith("-") else "+"
    return f"{real} {sign} i {imaginary.removeprefix('-')}"


class Spectrum(Record):
    """The eigenvalues other than 1, and eigenvectors with first coordinate 1: balls, or intervals.

    ``r`` is None where they are those of all r between two. ``exact`` is lambda_0 where it is
    rational; ``plus`` is the complex eigenvalue with positive imaginary part, with its modulus and
    its argument; its conjugate is the last one. The eigenvector of 1 is (0, 1, 0, 1).
    """

    r: Fraction | None
    exact: Fraction | None
    lambda_0: Any
    plus: Rectangle
    modulus: Any
    argument: Any
    vector_0: tuple[Any, ...]
    vector_plus: tuple[Rectangle, ...]

    def __str__(self) -> str:
        told = {name: getattr(self, name) for name in ("lambda_0", "plus", "modulus", "argument")}
        lines = [f"{name} = {value}" for name, value in told.items()]
        vectors = [f"{name} = ({', '.join(map(str, getattr(self, name)))})" for name in VECTORS]
        return "\n".join((f"r = {self.r}", *lines, *vectors))

    @property
    def parts(self) -> list[Any]:
        """All enclosures in one list; the constant first coordinates are left out."""
        found = [self.lambda_0, *self.plus, self.modulus, self.argument, *self.vector_0[1:]]
        for entry in self.vector_plus[1:]:
            found += entry
        return found


# --- what is plotted -----------------------------------------------------------------------------


class Ratios(Record):
    """A row with its ratio lhs/rhs on each interval of r where it is enclosed, and its verdicts.

    ``middle`` is an upper bound of the ratio halfway, or where it is next enclosed.
    """

    name: str
    says: str
    severity: str | None
    boxes: Sequence[tuple[Ends, Ends]]
    verdicts: set[str]
    middle: Fraction


class Roots(Record):
    """Enclosures over one interval of m, where -m^3 is the real root."""

    side: Ends
    r: Ends
    real: Ends
    re: Ends
    im: Ends
    minus_r: Ends
    minus_r_cubed: Ends


class Margins(Record):
    """The ratios of both sets over intervals of r up to ``end``, from the largest to the smallest.

    ``factor`` is how far apart the ends of a ratio may be that is shown.
    """

    intervals: Sequence[Ends]
    end: Fraction
    factor: int
    printed: Sequence[Ratios]
    repaired: Sequence[Ratios]


class Region(Record):
    """Theorem 1 over the plane of s = r^(1/3), up to ``width``, and of c = -cos theta_0.

    ``bands`` are intervals of phi_plus, with the number of printed rows that are refuted in them,
    of those that depend on it; None where one is not decided. ``shares`` are those of the plane on
    which such a row has each verdict. ``curves`` are boxes that contain the two thresholds of c.
    """

    everywhere: Outcome
    printed: Outcome
    thresholds: Outcome
    shares: Mapping[str, Mapping[str, Ends]]
    bands: Sequence[tuple[Fraction, Fraction, int | None]]
    width: Fraction
    curves: Sequence[Sequence[Cell]]


class Plotted(Record):
    """Everything that is plotted."""

    region: Region
    margins: Margins
    roots: Sequence[Roots]


# --- the report ----------------------------------------------------------------------------------


class CertifiedOutcome(Record):
    """One accepted certificate, read back; ``said`` is the checker's last line."""

    name: str
    outcome: Outcome
    digests: dict[str, str]
    said: str


class CertifiedMap(Record):
    """One accepted log of a map, read back; ``said`` is what its checker says it proves."""

    name: str
    progress: Any  # what is known of the map: see `verify/views/map.py`
    digest: str
    said: str


class CertifiedStrip(Record):
    """One accepted log that encloses a border: its strip, and the number of its tiles."""

    name: str
    plane: Any
    tiles: int
    digest: str


class Instant(Record):
    """A collision: its number, its time, and between what the collapse time lies, also as told."""

    number: int
    time: Ends
    collapse: Ends | None
    told: Sequence[str] = ()


class Story(Record):
    """A collapse: what is told of the scene, its collisions, and what is known after each.

    For ``scene`` and ``steps`` see `verify/views/scene.py`.
    """

    scene: Any
    steps: Sequence[Any]
    instants: Sequence[Instant]


class CoqRecord(Record):
    """The version of Coq, and for each folder whether Coq has checked it."""

    version: str
    checked: Mapping[str, bool]


class Whole(Record):
    """Theorem 1 with the repaired constants: what it assumes, its constants, and its set.

    ``givens`` describe the set; ``letters`` are how symbols are written, for people and in LaTeX;
    ``coq`` is the same in Coq.
    """

    hypotheses: Sequence[str]
    constants: Sequence[Constant]
    givens: Sequence[Claim]
    letters: Mapping[str, tuple[str, str]]
    coq: str


class Material(Record):
    """Everything that the report shows; the main job stands first of the folders.

    ``letters`` have what each stands for, and its label; ``stories`` are of scenes, by name;
    ``separatrix`` has what is enclosed of one, and its places, where a folder is about one.
    """

    paper: Publication
    letters: Sequence[tuple[str, str, str]]
    folders: Sequence[CertifiedOutcome]
    maps: Sequence[CertifiedMap]
    strips: Sequence[CertifiedStrip]
    measurements: Mapping[str, dict[str, Any]]
    digests: dict[str, str]
    stories: Mapping[str, Story]
    plotted: Plotted
    coq: CoqRecord
    whole: Whole
    separatrix: tuple[Any, Sequence[Any]] | None = None

    @property
    def logs(self) -> dict[str, str]:
        """The logs of maps and strips with their digests."""
        found = {one.name: one.digest for one in self.maps}
        return found | {one.name: one.digest for one in self.strips}

    @property
    def main(self) -> Outcome:
        """The outcome of the main job."""
        return self.about(self.paper.theorem)[0].outcome

    def about(self, theorem_name: str) -> list[CertifiedOutcome]:
        """The certificates of one theorem."""
        return [f for f in self.folders if f.outcome.statement.theorem == theorem_name]
