"""A point of Theorem 1: what `theorem1` prints if nobody asks for more, and the numbers in it."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from verify.language.record import TYPE_CHECKING
from verify.language.statement import NEEDED, PRINTED, PROVED, REFUTED, Obligation
from verify.language.terms import Term
from verify.prover.decimals import decimal_text as decimal
from verify.prover.decimals import (
    exact_number,
    people,
    round_decimal,
    rounded_inwards,
    short,
    told_apart,
)
from verify.prover.outcome import Outcome
from verify.publication import (
    BREAKS,
    HARMLESS,
    HYPOTHESES,
    OTHERWISE,
    REMARK,
    REPAIRED,
    SLIP,
    Publication,
)
from verify.views import words

if TYPE_CHECKING:
    from verify.prover.balls import Ball

#: Digits of a number that is rounded to the safe side.
SAFE_DIGITS = 6
TITLES = {PRINTED: "The printed argument", REPAIRED: "The theorem with repaired constants"}


def place(outcome: Outcome) -> str:
    """The point in a few words: r and the angle."""
    parameters = outcome.statement.parameters
    return f"r = {exact_number(parameters['r'].value)}, {_angle(parameters['c'])}"


def parameters_told(outcome: Outcome) -> str:
    """All parameters; beside an angle the value of -cos."""
    parameters = outcome.statement.parameters
    v_0, delta = (exact_number(parameters[name].value) for name in ("V_0", "delta_theta"))
    return f"{place(outcome)}{_cosine(outcome)}, V₀ = {v_0}, δ_θ = {delta}"


def _angle(c: Term) -> str:
    """The angle as it is written, where it is; else -cos of it."""
    if c.op == "rational":
        return "θ₀ = π" if c.value == 1 else f"-cos θ₀ = {exact_number(c.value)}"
    cosine = c.children[0]
    angle = cosine.children[0].value
    if cosine.op == "cos":
        return f"θ₀ = {exact_number(angle)}"
    above = "" if angle.numerator == 1 else angle.numerator
    return f"θ₀ = {above}π" + (f"/{angle.denominator}" if angle.denominator > 1 else "")


def _cosine(outcome: Outcome) -> str:
    """The value of -cos where the angle is not given by it."""
    c = outcome.statement.parameters["c"]
    if c.op == "rational" and c.value != 1:
        return ""
    value = "1" if c.op == "rational" else words.ends_told(words.ends_of(outcome, "c"))
    return f" (-cos θ₀ = {value})"


def threshold(outcome: Outcome, hypothesis: str) -> str:
    """The number that a hypothesis is about, and its own threshold; nothing for other rows."""
    from verify.prover import balls  # flint is loaded only where it is used

    r = outcome.statement.parameters["r"].value
    name = hypothesis.removeprefix(f"{HYPOTHESES}.")
    with balls.precision(words.SHOWN_BITS):
        if name == "r-below-stabi":
            stabi = short(balls.ends(9 - 4 * balls.root(balls.from_fraction(Fraction(5)))))
            return f"r = {exact_number(r)}, r_stabi = {stabi}"
        if name not in ("existence", "stability"):
            return ""
        c, right = outcome.statement.parameters["c"], balls.ends(_bound(r, name))
        if c.op == "rational":
            own, other = exact_number(c.value), told_apart((c.value, c.value), right)[1]
        else:
            enclosed = words.ends_of(outcome, "c")
            own, other = (
                ("undefined", short(right)) if enclosed is None else told_apart(enclosed, right)
            )
        return f"-cos θ₀ = {own}, the right side is {other}"


def _bound(r: Fraction, hypothesis: str) -> Ball:
    """The number that -cos of the angle has to exceed, at the precision that is set."""
    from verify.prover import balls  # flint is loaded only where it is used

    ball = balls.from_fraction(r)
    if hypothesis == "existence":
        return 4 * balls.root(ball) / (1 + ball)
    root = balls.cube_root(ball)
    return 2 * root * (1 + root) / (1 + ball)


def in_numbers(outcome: Outcome) -> str | None:
    """The theorem with its repaired constants, where these are numbers that serve; else None."""
    if words.group_verdict(outcome, REPAIRED) != PROVED or outcome.verdict != PROVED:
        return None
    if not outcome.statement.parameters:  # it is about all parameters
        return None
    return theorem_in_numbers(outcome)


def theorem_in_numbers(outcome: Outcome) -> str:
    """The theorem with the repaired constants as the short decimals that they are.

    What has no short decimal is rounded so that the set of the theorem only becomes smaller.
    """
    known = words.definitions_of(outcome)

    def value(name: str) -> Fraction:
        return known[f"{REPAIRED}.{name}"].value

    def told(name: str) -> str:
        return people(_safe(value(name), up=False))

    third = (value("V_1") - known["V_0"].value) / 3
    low, high = rounded_inwards((known["V_0"].value + third, value("V_1") - third), SAFE_DIGITS)
    angle = people(_safe(value("Delta_theta") / 4, up=False))
    root = words.ends_told(words.ends_of(outcome, "phi_minus"))
    v_0, delta = (exact_number(known[name].value) for name in ("V_0", "delta_theta"))
    return (
        f"Given the assumptions: let {place(outcome)}{_cosine(outcome)}. Three particles in "
        f"dimension 2 or more, 0 and 1 in contact and just collided, with "
        f"0 < -η_c ≤ {told('eta_bar')}, |η_s/(-η_c) - φ⁻| ≤ {told('x_0')} and η_s > 0 "
        f"(φ⁻ = {root}), 0 < d ≤ min({told('d_const')}, {told('d_slope')} η_c²), "
        f"|W_c|² and |W_s|² in [{low}, {high}], and |cos θ - cos θ₀| ≤ "
        f"{angle}, collide infinitely often, in the order 0-2, 0-1, 0-2, …, all "
        f"within the time {people(_safe(value('T_star'), up=True))} (unit of length: a diameter; "
        f"|W|² ≥ V₀ = {v_0}), and "
        f"the final -cos θ differs from -cos θ₀ by at most δ_θ = {delta}."
    )


def _safe(value: Fraction, *, up: bool) -> str:
    """A decimal of a few digits at most, rounded one way."""
    return decimal(*round_decimal(value, SAFE_DIGITS, up))


def failed_hypotheses(outcome: Outcome) -> list[tuple[Obligation, str]]:
    """The needed hypotheses that do not hold, each with the reason in numbers."""
    found = []
    for row, decision in outcome.of_group(HYPOTHESES):
        if row.role == NEEDED and decision.verdict == REFUTED:
            sides = words.sides_of(row, decision)
            equal = sides is not None and sides[0] == sides[1] and sides[0][0] == sides[0][1]
            found.append((row, "both sides are equal" if equal else threshold(outcome, row.name)))
    return found


def known_there(outcome: Outcome) -> list[str]:
    """What is known where a hypothesis of the theorem does not hold: the strongest that is proved.

    It is proved of the claim that some set with interior collapses with a final -cos within delta
    of -cos of the angle: it is false if r is above 9-4√5, or if such an angle is below the bound of
    the second condition.
    """
    refuted = {row.name.removeprefix(f"{HYPOTHESES}.") for row, _ in failed_hypotheses(outcome)}
    if not refuted & {"existence", "stability", "r-below-stabi"}:
        return []
    from verify.views.restitution import (  # loaded only where they are used
        LEAST_ANGLE,
        comes_to_rest,
        never,
        without_interior,
    )

    r = outcome.statement.parameters["r"].value
    known = [f"Known there: {line}" for line in without_interior(r)]
    if "existence" in refuted and not never(r):
        least = f"Known there: {LEAST_ANGLE}"
        if _ends_below(outcome, "existence"):
            return [f"{least}. -cos θ₀ + δ_θ is below that: no state collapses as the theorem says"]
        known.append(least)
    if not comes_to_rest(r) and _ends_below(outcome, "stability"):
        known[0] += "; -cos θ₀ + δ_θ is below that: the conclusion of the theorem is false here"
    return known


def _ends_below(outcome: Outcome, hypothesis: str) -> bool:
    """Whether -cos of the angle, with the deviation that is allowed, is below a bound."""
    from verify.prover import balls  # flint is loaded only where it is used

    given = outcome.statement.parameters
    enclosed = words.ends_of(outcome, "c")
    with balls.precision(words.SHOWN_BITS):
        bound = balls.ends(_bound(given["r"].value, hypothesis))
    return enclosed is not None and enclosed[1] + given["delta_theta"].value < bound[0]


#: The certificate about thresholds: the drift of the printed angle is more than `DRIFT` |Δθ|/(1-φ⁺)
#: and at most `DRIFT_MOST` |Δθ|/(1-φ⁺), |Δθ| is the smaller one of h₄δ_x/8 and δ_θ, for these V₀.
DRIFT, DRIFT_MOST = Fraction(28, 33), Fraction(28, 33) + Fraction(1, 100000)
THRESHOLD_V_0 = (Fraction(1, 16), Fraction(10**6))


def final_angle(outcome: Outcome) -> str:
    """For which δ_θ the printed bound of the angle exceeds δ_θ, here; nothing where for none."""
    phi, h_4, x = (
        words.ends_of(outcome, name) for name in ("phi_plus", "h_4", f"{PRINTED}.delta_x")
    )
    v_0 = outcome.statement.parameters["V_0"].value
    if phi is None or h_4 is None or x is None or not _between(v_0, THRESHOLD_V_0):
        return ""
    if DRIFT < 1 - phi[0]:
        return ""
    most = DRIFT * (h_4[0] * x[0] / 8) / (1 - phi[0])
    limit = people(decimal(*round_decimal(most, 3, up=False)))
    factor = decimal(*round_decimal(DRIFT_MOST / (1 - phi[1]), 3, up=True))
    return (
        f"For δ_θ ≤ {limit}, at this r and θ₀, final-angle breaks it too: the printed bounds let "
        f"the final -cos θ differ from -cos θ₀ by up to {factor} δ_θ, and the theorem claims at "
        "most δ_θ (certificates/thresholds)."
    )


def _between(value: Fraction, ends: tuple[Fraction, Fraction]) -> bool:
    return ends[0] <= value <= ends[1]


# --- what fits on a screen ---


def screen(
    outcome: Outcome, paper: Publication, as_printed: Mapping[str, str] | None = None
) -> Iterator[str]:
    """What fits on a screen: whether the theorem is true, whether its set is right, what fails.

    ``as_printed`` has the verdicts on the theorem with its sign, and its set, as printed. The last
    line is the result with everything it is about.
    """
    yield f"Theorem 1 at {parameters_told(outcome)}"
    yield ""
    yield from printed_lines(as_printed or {}, paper)
    sets = [group for group in words.groups(outcome) if group != HYPOTHESES]
    yield from _hypotheses(outcome, paper)
    for group in sets:
        yield _set_line(outcome, group)
        if group == PRINTED:
            yield from _argument(outcome, paper)
    numbers = in_numbers(outcome) if REPAIRED in sets else None
    if numbers is not None:
        yield numbers
    yield ""
    yield "All rows: -v; some: --rows NAME; for programs: --json; a certificate: --out DIR."
    yield ""
    if outcome.verdict == PROVED and outcome.assumptions:
        yield words.believed(outcome, paper)
    yield _verdict(outcome, paper, sets)


def printed_lines(verdicts: Mapping[str, str], paper: Publication) -> Iterator[str]:
    """Whether the theorem is true as it is printed, and by which misprint not; and its set."""
    if (verdicts.get("sign"), verdicts.get("set")) == (REFUTED, PROVED):
        where = "; ".join(paper.fatal.values())
        yield f"The theorem is true once one sign is corrected: {where}."
    if "sign" in verdicts:
        is_in_coq = f"{paper.theorem}, the sign as printed" in paper.whole_in_coq
        told = f"{verdicts['sign']}{' (Coq)' * is_in_coq}, certificates/printed-sign"
        yield f"  As printed, with <: {told}"
    if "set" in verdicts:
        yield (
            f"  With >, its set as printed: {verdicts['set']} (certificates/printed-set) where "
            "d₀, η_s > 0; for an interior it needs room for the angle: Θ/6, Θ = 3 ζ̄ η̄/V₁^{1/2}"
        )


#: What one row of a severity is, and what several are.
SEVERAL = {
    HARMLESS: ("harmless here", "harmless here"),
    SLIP: ("slip of wording", "slips of wording"),
    OTHERWISE: (
        "is true, but the reason given does not suffice",
        "are true, but the reason given does not suffice",
    ),
    REMARK: ("is a remark", "are remarks"),
}


def _argument(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """How bad it is with the printed argument: what breaks it, why, and what else is false."""
    yield from _breaking(outcome, paper)
    kinds = Counter(
        row.severity
        for row, found in outcome.rows
        if row.severity and words.fair(outcome, row, found) in (REFUTED, OTHERWISE, REMARK)
    )
    rest = _told(kinds, (HARMLESS, SLIP))
    refuted = {row.name for row, d in outcome.rows if words.fair(outcome, row, d) == REFUTED}
    if rest and refuted & paper.fatal.keys():
        rest += ", one of them that sign"
    if rest:
        yield f"  Also refuted: {rest}."
    others = _told(kinds, (OTHERWISE, REMARK))
    if others:
        yield f"  Not held against the paper: {others}."
    angle = final_angle(outcome)
    if angle:
        yield f"  {angle}"


def _told(kinds: Mapping[str, int], severities: Iterable[str]) -> str:
    """How many rows there are of some severities: 2 harmless here; 6 slips of wording."""
    found = ((kinds[kind], SEVERAL[kind]) for kind in severities if kinds[kind])
    return "; ".join(f"{count} {one if count == 1 else many}" for count, (one, many) in found)


def _breaking(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The refuted steps that break the printed argument, a line each with both numbers."""
    rows = [
        p for p in outcome.rows if words.fair(outcome, *p) == REFUTED and p[0].severity == BREAKS
    ]
    if rows:
        mistakes = len([*causes([row for row, _ in rows], paper)])
        cause = f", from {mistakes} mistakes" if mistakes > 1 else ""
        steps = (
            f"{len(rows)} refuted steps break it" if len(rows) > 1 else "One refuted step breaks it"
        )
        yield f"  {steps}{cause} (left side, right side, formula):"
    for row, decision in rows:
        numbers = words.sides_told(row, decision, 3)
        if numbers:
            yield f"    {words.short_name(row):<18} {numbers:<26} {paper.number(row.label)}"
    yield from causes([row for row, _ in rows], paper)


def causes(rows: Iterable[Obligation], paper: Publication) -> Iterator[str]:
    """Why these rows are false: the first sentence on each cause."""
    names = {row.name: words.short_name(row) for row in rows}
    for own, text in paper.notes().causes:
        first, *others = [names[name] for name in own if name in names] or [""]
        if first:
            more = f" and {len(others)} more" if others else ""
            yield f"  Why {first}{more}: {text.partition('. ')[0].removesuffix('.')}."


def verdict_lines(outcome: Outcome, paper: Publication, sets: list[str]) -> Iterator[str]:
    """What fails or is left open, and the verdicts; the last line is the whole result."""
    yield from _hypotheses(outcome, paper)
    yield from (_set_line(outcome, group) for group in sets)
    if outcome.verdict == PROVED and outcome.assumptions:
        yield words.believed(outcome, paper)
    yield _verdict(outcome, paper, sets)


def _hypotheses(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The hypotheses that fail, and what is known there; and whether the precision sufficed."""
    for row, why in failed_hypotheses(outcome):
        where = paper.number(row.label)
        yield f"Hypothesis {where} does not hold: {row.says} ({why})"
    yield from known_there(outcome)
    if outcome.spent:
        yield f"Precision budget spent: {outcome.spent}"


def _set_line(outcome: Outcome, group: str) -> str:
    return f"{TITLES.get(group, group)}: {words.group_verdict(outcome, group)}"


def _verdict(outcome: Outcome, paper: Publication, sets: list[str]) -> str:
    which = f", {' and '.join(sets)} constants," if sets else ""
    title = f"Theorem 1{which} at {parameters_told(outcome)}"
    if words.headline(outcome) == words.DOES_NOT_APPLY:
        title = f"a hypothesis is refuted (exit code 1): {title}"
    return f"Verdict: {words.summary(outcome, paper, title)}"
