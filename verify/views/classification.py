"""What people and scripts see of the four theorems on collapses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from typing import Any

from verify.language.statement import PROVED
from verify.prover.decimals import exact_number, rational_text, short
from verify.prover.outcome import Outcome
from verify.publication import Publication
from verify.views.document import claims_document, pair
from verify.views.findings import AtMasses, AtR, Count, OnALine
from verify.views.restitution import UNLESS
from verify.views.words import summary

FORMAT = "verify-classification/1"

SETTING = (
    "Balls with any masses and radii in any dimension, and any restitution 0 ≤ ρ' ≤ -ρ at each "
    "collision, unless said otherwise; no triple contact: no ball that collides touches a third "
    "one. Apparently new; no priority is claimed."
)

THEOREMS = (
    (
        "Lemma. A pair that has collided does not approach again until one of the two hits a third "
        "ball with an obtuse angle between the two partners: no acute or right angle brings it "
        "back."
    ),
    (
        "I. No triangular collapse: in no collapse of three balls do all three pairs collide "
        "infinitely often. In every one, at a finite time, one ball eventually collides with the "
        "two others in turn, and the limiting angle at it is at least a right one; so with equal "
        "radii the two others do not touch at the limit."
    ),
    (
        "II. Three balls of equal mass, one r with 0 < r ≤ 1. In every collapse the limiting "
        "-cos θ is at least 4√r/(1+r). So for r > 7-4√3 = 0.0717… they never collapse, and by IV "
        "almost every datum has finitely many collisions. A run in which one ball meets two others "
        "in turn, with no other collision of the three meanwhile, has at most n collisions, n ≥ 1 "
        "the least number with s_n ≤ 0, where s_0 = 0, s_1 = 1, s_{n+1} = (1+r)/2 s_n - r s_{n-1}; "
        "on a line this is attained. For r ≤ 7-4√3 there is no such n, and runs have any length."
    ),
    (
        "II b. Equal masses and one r, as in II. In a collapse in which the velocities of the two "
        "others relative to the central ball do not both tend to 0, the limiting -cos θ is at "
        "least 2r^(1/3)(1+r^(1/3))/(1+r). So for r > 9-4√5 = 0.0557… both tend to 0 in every "
        "collapse."
    ),
    (
        "III. Total impulse. For N balls, in the frame of the centre of mass, with R² = Σ m|x|², "
        "e² = Σ m|v|², A = Σ m x·v: the sum of σJ over the collisions up to any time is at most "
        "R(0)e - A(0), with e at that time. So velocities converge and the normal components are "
        "summable, up to a collapse or for ever, whatever the order."
    ),
    (
        "IV. Finite or infinite time. If three balls collide infinitely often without a collapse, "
        "then in the same frame A ≤ 0 always, velocities tend to 0, positions converge, and the "
        "angular momentum L is 0; what I and II say of a collapse holds as the time tends to "
        "infinity. So with L ≠ 0 there is exactly one of: finitely many collisions; or a collapse "
        "in finite time, as in I and, for equal masses, II. For equal masses and one r with "
        "7-4√3 < r ≤ 1 it is the first, whatever L."
    ),
    (
        "IV b. With angular momentum. For equal masses and one r with 9-4√5 < r ≤ 1, L ≠ 0 leaves "
        "finitely many collisions: at a collapse velocities would tend to 0 in that frame, by "
        "II b, and L with them."
    ),
)


def meaning_lines(remarks: Iterable[tuple[str, str]], paper: Publication) -> Iterator[str]:
    """What the theorems mean for the text: remarks, each with its label."""
    yield "What it means for the text"
    for label, text in remarks:
        yield f"  {paper.cited(label)}: {text}"


def theorem_lines(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """The theorems in words, if they are proved, and the verdict."""
    if outcome.verdict == PROVED:
        yield f"Given the assumptions. {SETTING}"
        yield from THEOREMS
        yield ""
    yield f"Verdict: {summary(outcome, paper)}"


def restitution_lines(found: AtR) -> Iterator[str]:
    """What the theorems say at one r, for three balls of equal mass."""
    kind = " (elastic collisions)" if found.r == 1 else ""
    yield f"At r = {exact_number(found.r)}{kind}, three balls of equal mass"
    if found.excluded:
        yield f"  no collapse, by II: finitely many collisions{UNLESS}"
    else:
        yield (
            "  a collapse is not excluded; in each the final -cos θ is at least 4√r/(1+r) = "
            f"{short(found.least_neg_cos)}, by II"
        )
    if found.comes_to_rest and not found.excluded:
        yield (
            "  as r > 9-4√5, both velocities relative to the middle ball tend to 0 in it, and the "
            "angular momentum about the centre of mass is 0, by II b and IV b"
        )
    if not found.excluded:
        yield almost_every(comes_to_rest=found.comes_to_rest)
    if found.undecided:
        yield "  a longest run exists, but the work budget does not suffice to count it"
    elif found.longest is None:
        yield "  runs have any length: on a line one ball meets two others in turn without end"
    else:
        yield (
            f"  one ball meets two others in turn at most {found.longest} times, as long as the "
            "three have no other collision meanwhile, and no triple contact; on a line this is "
            "attained"
        )


def masses_lines(found: AtMasses) -> Iterator[str]:
    """What is possible with three masses at one r."""
    masses = ", ".join(map(exact_number, found.masses))
    yield f"At r = {exact_number(found.r)}, balls of masses {masses} and any radii"
    for one in found.middles:
        most = f"(none for r > {short(one.largest_r)})"
        if one.excluded:
            yield f"  no collapse has ball {one.ball} in the middle {most}"
        elif one.comes_to_rest:
            yield (
                f"  a collapse about ball {one.ball} is not excluded {most}; all relative motion "
                "ends in it, and the angular momentum is 0"
            )
        else:
            yield f"  a collapse about ball {one.ball} is not excluded {most}"
    if all(one.excluded for one in found.middles):
        yield f"  no collapse: finitely many collisions{UNLESS}"
    elif all(one.comes_to_rest for one in found.middles):
        yield (
            "  unless the angular momentum about the centre of mass is 0, no collapse: finitely "
            f"many collisions{UNLESS}"
        )
    if not all(one.excluded for one in found.middles):
        yield almost_every(comes_to_rest=all(one.comes_to_rest for one in found.middles))
    yield "  given certificates/classification-of-balls"


def almost_every(*, comes_to_rest: bool) -> str:
    """What happens from almost every start, where collapses are not excluded."""
    regime = (
        "" if comes_to_rest else ", or a collapse in the Zhou-Kadanoff regime: φ₂ tends to 0 in it"
    )
    return (
        "  in dimension 2 or more almost every start has finitely many collisions"
        f"{regime} (certificates/alexander)"
    )


def line_lines(masses: Iterable[Fraction], found: Sequence[OnALine]) -> Iterator[str]:
    """What is possible with three masses, by r."""
    told = ", ".join(map(exact_number, masses))
    yield f"Balls of masses {told} and any radii, with one r in (0, 1] for all pairs"
    for share in dict.fromkeys(one.share for one in found):
        alike = [one for one in found if one.share == share]
        *others, last = [str(one.ball) for one in alike]
        names = f"{', '.join(others)} or {last}" if others else last
        yield f"  no collapse has ball {names} in the middle for r > {_least(alike[0].endless)}"
        yield "    on a line, where another one hits it, and it and the third are at rest:"
        above = ""
        for count in alike[0].counts:
            bounds = "r = 1" if count.exact == "1" else f"{_least(count)} ≤ r{above}"
            above = f" < {count.exact or short(count.least_r)}"
            yield f"      {count.collisions} collisions for {bounds}"
        yield (
            "      and so on: at least N collisions for r < M/(c+√(c²-M))², where "
            f"c = cos(π/N) and M = {exact_number(share)}"
        )
        end = alike[0].endless
        yield f"      collisions without end for r ≤ {end.exact or short(end.least_r)}"
    yield "  given certificates/classification-of-balls"


def _least(count: Count) -> str:
    if not count.exact:
        return short(count.least_r)
    return count.exact if "√" not in count.exact else f"{count.exact} = {short(count.least_r)}"


def line_document(masses: Iterable[Fraction], found: Iterable[OnALine]) -> dict[str, Any]:
    """The part of the document that belongs to three masses and all r."""
    middles = [
        {
            "ball": about.ball,
            "share": rational_text(about.share),
            "largest_r": pair(about.endless.least_r),
            "on_a_line": [
                {"collisions": one.collisions, "least_r": pair(one.least_r), "exact": one.exact}
                for one in about.counts
            ],
        }
        for about in found
    ]
    return {"masses": [rational_text(mass) for mass in masses], "middles": middles}


def masses_document(found: AtMasses) -> dict[str, Any]:
    """The part of the document that belongs to three masses."""
    middles = [
        {
            "ball": one.ball,
            "collapse": "excluded" if one.excluded else "not excluded",
            "comes_to_rest": one.comes_to_rest,
            "largest_r": pair(one.largest_r),
        }
        for one in found.middles
    ]
    return {"masses": [rational_text(mass) for mass in found.masses], "middles": middles}


def classification_document(outcome: Outcome) -> dict[str, Any]:
    """The outcome as one JSON document; its theorem is all four in words."""
    document = claims_document(outcome, "classification", FORMAT)
    if outcome.verdict == PROVED:
        document["theorem"] = " ".join((SETTING, *THEOREMS))
    return document


def restitution_document(found: AtR) -> dict[str, Any]:
    """The part of the document that belongs to one r."""
    longest = "infinite" if found.longest is None else str(found.longest)
    return {
        "r": rational_text(found.r),
        "least_neg_cos": pair(found.least_neg_cos),
        "longest_run": None if found.undecided else longest,
        "collapse": "excluded" if found.excluded else "not excluded",
    }
