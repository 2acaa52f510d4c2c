"""What people see of Theorem 1 for all parameters: counts, the theorem in words, its set."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from verify.language.statement import PROVED, REFUTED, UNDECIDED, Obligation
from verify.language.typeset import Typesetter
from verify.prover.decimals import exact_number
from verify.prover.outcome import Decision, Ends, Outcome, conjunction
from verify.publication import ACCUSATIONS, BREAKS, Publication
from verify.views import words
from verify.views.findings import Whole
from verify.views.point import causes, printed_lines
from verify.views.row_lists import MORE, plain_letters
from verify.views.tex import sentences
from verify.views.tex.formulas import Formulas

FORMAT = "verify-theorem1-all/1"

#: For a row, bounds of the share of the plane on which it has each verdict.
Shares = Mapping[str, Mapping[str, Ends]]

#: Beside the verdicts: the values of φ⁺ for which nothing is proved, from the first to the second.
LEFT_OPEN = "left open"

CLAIM = (
    "Let 0 < r < 1, V₀ > 0, δ_θ > 0, and let θ₀ satisfy "
    "0 < -cos θ₀ ≤ 1 and -cos θ₀ > 2r^(1/3)(1+r^(1/3))/(1+r). Then the constants of the repaired "
    "set exist and are positive, and three particles in dimension 2 or more that start in the set "
    "they describe, 0 and 1 in contact, collide infinitely often, in the order 0-2, 0-1, 0-2, …, "
    "in finite time, and -cos of the angle converges to a limit within δ_θ of -cos θ₀. The data "
    "that free flight reaches from this set before the collision 0-2 go on in the same way; their "
    "set has interior points."
)
THEOREM = f"Theorem 1, given these assumptions. {CLAIM}"


def screen(
    outcome: Outcome,
    paper: Publication,
    as_printed: Mapping[str, str],
    printed: Outcome,
    whole: Iterable[str] = (),
) -> Iterator[str]:
    """Whether the theorem is true, whether its set is right, what fails; and what is proved.

    ``as_printed`` has the verdicts on the theorem as printed, ``printed`` those on its rows;
    ``whole`` are the lines with the constants and the set of the theorem.
    """
    (cite,) = outcome.statement.cites
    yield "Theorem 1 for all parameters"
    yield ""
    yield from printed_lines(as_printed, paper)
    yield from _argument(printed, paper)
    yield f"The theorem with repaired constants: {words.headline(outcome)}"
    yield ""
    yield f"Rows: {words.counts(outcome, 'needed')}"
    yield f"The step, for every state, is {words.cited_as(cite, paper)}"
    yield f"{words.believed(outcome, paper)} Their text: -v."
    yield MORE
    yield ""
    if outcome.verdict == PROVED:
        yield THEOREM
        yield from whole
        yield ""
    title = words.in_letters(outcome.statement.title)
    yield f"Verdict: {words.headline(outcome)}: {title}; given {words.given_by(outcome, paper)}"


def _argument(printed: Outcome, paper: Publication) -> Iterator[str]:
    """The verdict on the printed argument, and which of its steps break it."""
    yield f"The printed argument: {conjunction(printed.decisions.values())}"
    rows = [
        (row, found)
        for row, found in printed.rows
        if row.severity == BREAKS and words.fair(printed, row, found) == REFUTED
    ]
    for title, depends in (("for all parameters", False), ("for some, such as small δ_θ", True)):
        here = [row for row, found in rows if bool(found.witness) == depends]
        where = (f"({paper.number(row.label).strip('()')})" for row in here)
        names = ", ".join(
            f"{words.short_name(row)} {at}" for row, at in zip(here, where, strict=True)
        )
        if here:
            yield f"  Refuted steps that break it, {title}: {names}."
            yield from causes(here, paper)
    yield "  All of them, and where they fail: verify theorem1 --all --constants printed."


def printed_screen(
    outcome: Outcome,
    where: Outcome,
    shares: Shares,
    paper: Publication,
    as_printed: Mapping[str, str],
) -> Iterator[str]:
    """Which rows of the printed set fail for all parameters, and which depend on them, and where.

    ``where`` is the statement about thresholds; ``shares`` follow from it. ``as_printed`` has the
    verdicts on the printed theorem and set.
    """
    yield "The printed set, for all parameters that satisfy the corrected hypothesis"
    yield ""
    found = [(row, d) for row, d in outcome.rows if words.fair(outcome, row, d) == REFUTED]
    for severity in ACCUSATIONS:
        here = [row for row, d in found if not d.witness and row.severity == severity]
        for told in dict.fromkeys(paper.severity(row) for row in here):
            yield f"  {told}, for all parameters:"
            yield from (
                f"    {words.short_name(row)}   [{paper.cited(row.label)}]"
                for row in here
                if paper.severity(row) == told
            )
    yield ""
    for row, decision in found:
        if decision.witness:
            yield f"  {_dependence(outcome, row, decision)}   [{paper.cited(row.label)}]"
            yield f"    where it fails: {row.severity}"
            yield from (
                f"    {sentence}" for sentence in _sentences(where, shares, words.short_name(row))
            )
    yield ""
    yield (
        "Thresholds: for 1/16 ≤ V₀ ≤ 10⁶ and all other parameters. Shares are of the area where "
        "-cos θ₀ ≤ 1 in the plane of φ⁻/(φ⁺)², between 0 and 1, and φ⁺, at V₀ = 1 and δ_θ = 1/10."
    )
    yield ""
    yield from printed_lines(as_printed, paper)
    yield "What the claim needs all the same: room for the angle at the start, which the set fixes."
    yield ""
    found_all = conjunction(outcome.decisions.values())
    argument = (
        f"{found_all}: the printed argument, for all parameters: {words.counts(outcome, 'printed')}"
    )
    yield f"Verdict: {argument}; {as_printed['set']}: the set as printed, with > for <"


def _dependence(outcome: Outcome, row: Obligation, decision: Decision) -> str:
    at = words.values_told(decision.witness, plain_letters(outcome))
    return f"depends: {words.short_name(row)}: fails at {at}"


def dependences(outcome: Outcome, where: Outcome, shares: Shares) -> Iterator[tuple[str, str]]:
    """The printed rows that fail for some parameters only, with what is known of where."""
    for row, decision in outcome.rows:
        if words.fair(outcome, row, decision) == REFUTED and decision.witness:
            found = list(_sentences(where, shares, words.short_name(row)))
            yield row.says, "; ".join(found) or _dependence(outcome, row, decision)


def _sentences(where: Outcome, shares: Shares, name: str) -> Iterator[str]:
    """What is certified about one row, and the shares of the plane."""
    rows = [row for row, found in where.rows if found.verdict == PROVED]
    yield from (row.says for row in rows if row.name.startswith(f"{name}."))
    if name in shares:
        parts = shares[name]
        decided = [
            f"{v} at least {_percent(parts[v][0])}" for v in (PROVED, REFUTED) if parts[v][1]
        ]
        if LEFT_OPEN in parts:
            low, high = parts[LEFT_OPEN]
            end = exact_number(high)
            yield f"nothing is proved where {end} - {exact_number(high - low)} ≤ φ⁺ < {end}"
        left = parts[UNDECIDED][1]
        rest = f"undecided at most {_percent(left, up=True)}" if left else "nothing undecided"
        yield f"share: {', '.join([*decided, rest])}"


def _percent(share: Fraction, *, up: bool = False) -> str:
    """A share in percent with two decimals, rounded one way."""
    hundredths = share * 10000
    whole = -(-hundredths // 1) if up else hundredths // 1
    return f"{whole // 100}.{whole % 100:02} %"


# --- the theorem, whole --------------------------------------------------------------------------

CONSTANTS = "Its constants:"
SET = (
    "Its set: 0 and 1 are in contact and have just collided, s is 1 and c is 2, d is the gap "
    "between 0 and 2, and"
)
FLIGHT = "and what free flight reaches from there before the next collision."


def constants_and_set(whole: Whole) -> Iterator[str]:
    """Constants and set for a terminal."""
    typesetter = plain(whole)
    yield CONSTANTS
    for constant in whole.constants:
        yield f"  {constant.letter} = {typesetter.term(constant.term)}"
    yield f"{SET} {', '.join(map(typesetter.claim, whole.givens))}; {FLIGHT}"


def plain(whole: Whole) -> Typesetter:
    """A typesetter in its letters."""
    return Typesetter({name: letter for name, (letter, _) in whole.letters.items()})


def latex(whole: Whole) -> str:
    """Theorem, constants and set, to be copied into a theorem environment; every line breaks."""
    tex = {name: letter for name, (_, letter) in whole.letters.items()}
    formulas = Formulas(tex, {name: letter for name, (letter, _) in whole.letters.items()})
    constants = [rf"{c.tex} = {formulas.term(c.term)}" for c in whole.constants]
    givens = ", ".join(f"${formulas.claim(given)}$" for given in whole.givens)
    return "\n".join(
        [
            sentences.words(f"{CLAIM} {CONSTANTS}"),
            r"\begin{itemize}",
            *(rf"\item $\displaystyle {text}$" for text in constants),
            r"\end{itemize}",
            f"{sentences.words(SET)} {givens};",
            sentences.words(FLIGHT),
        ]
    )
