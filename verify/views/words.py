"""What all views of an outcome say: headline, counts, letters, and the theorem in numbers.

Everything is taken from the outcome, fresh or read back; nothing is decided here.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from verify.language.statement import (
    NEEDED,
    PRINTED,
    PROVED,
    REFUTED,
    UNDECIDED,
    Assumption,
    Cite,
    Constant,
    Obligation,
)
from verify.language.terms import Claim, Term, names_of, symbol
from verify.language.typeset import LONG, Typesetter, letters_apart
from verify.prover.decimals import as_one_or_two, short
from verify.prover.outcome import Decision, Ends, Outcome, conjunction
from verify.publication import HYPOTHESES, LETTERS, OTHERWISE, REMARK, TITLE_LETTERS, Publication

#: The headline where a hypothesis does not hold.
DOES_NOT_APPLY = "does not apply"

#: The kind of a sentence that says what the objects are.
DEFINITION = "definition"

#: The kinds of assumptions that are granted: what the objects are, theorems of
#: general mathematics, and sentences that do nothing but put facts together that they name.
GRANTED = (DEFINITION, "general mathematics", "numbered glue")

#: How relations are shown.
SIGNS = {"<": "<", "<=": "≤", "=": "="}

#: A longer formula is left to the statement file where a row is told in one line.
MAX_FORMULA = 400

#: Bits of the thresholds and entries of minima that are only shown.
SHOWN_BITS = 192


# --- verdicts ------------------------------------------------------------------------------------


def headline(outcome: Outcome) -> str:
    """The verdict in a few words.

    It is the same word for people and for scripts; what it rests on stands beside it. Where a
    hypothesis does not hold, a theorem does not apply.
    """
    if outcome.verdict == REFUTED and group_fails(outcome, HYPOTHESES):
        return DOES_NOT_APPLY
    return outcome.verdict


def rests_on_more(outcome: Outcome) -> bool:
    """Whether what is proved rests on more than what is granted, here or in what is cited."""
    kinds = {assumption.kind for assumption in outcome.assumptions}
    return outcome.verdict == PROVED and not kinds <= set(GRANTED)


def group_fails(outcome: Outcome, group: str) -> bool:
    """Whether a needed row of a group is refuted."""
    rows = outcome.of_group(group)
    return any(row.role == NEEDED and found.verdict == REFUTED for row, found in rows)


def verdict_text(outcome: Outcome, paper: Publication) -> str:
    """The headline, with the number of assumptions on which a proof rests."""
    found = headline(outcome)
    return found if outcome.verdict != PROVED else f"{found}, given {given_by(outcome, paper)}"


def given(assumptions: Iterable[Assumption]) -> str:
    """How many assumptions there are, of which kinds."""
    kinds = Counter(assumption.kind for assumption in assumptions)
    total = sum(kinds.values())
    if total == 0:
        return "no assumptions"
    names = {
        kind: f"{kind}s" if kind == DEFINITION and n > 1 else kind for kind, n in kinds.items()
    }
    parts = ", ".join(f"{count} {names[kind]}" for kind, count in kinds.items())
    return f"{total} {'assumption' if total == 1 else 'assumptions'} ({parts})"


def is_about(outcome: Outcome, paper: Publication) -> bool:
    """Whether a statement says something about the paper: a row or a sentence has its label."""
    statement = outcome.statement
    labels = [row.label for row in statement.obligations]
    return paper.has([*labels, *(assumption.label for assumption in statement.assumptions)])


def given_by(outcome: Outcome, paper: Publication) -> str:
    """What an outcome rests on: its own assumptions, and those of each statement that it cites."""
    cites = outcome.statement.cites
    cited = [f"{given(c.trusted)} of {cited_as(c, paper)}" for c in cites]
    own = [given(outcome.own_assumptions)] if outcome.own_assumptions or not cited else []
    return ", and ".join([*own, *cited])


def believed(outcome: Outcome, paper: Publication) -> str:
    """All assumptions that the verdict has, and which of them are believed, and proved in Coq.

    Coq has definitions as well; that they say what is meant is believed. Where Coq proves what is
    cited, the verdict rests on none of the assumptions behind that, but on its definitions. Each
    is counted once: so the parts add up to all, which are those that `given_by` counts.
    """
    theorem = outcome.statement.theorem
    own = [(theorem, one) for one in outcome.own_assumptions]
    cited = list(_cited(theorem, outcome.statement.cites, paper))
    known: dict[Assumption, bool] = {}
    for theorem, one in [*own, *cited]:
        known[one] = known.get(one, True) and one.name in paper.in_coq.get(theorem, ())
    proved = [one.name for one, found in known.items() if found and one.kind != DEFINITION]
    others = [one for one, found in known.items() if not found or one.kind == DEFINITION]
    names = [f"{one.name} ({one.kind})" if one.kind == DEFINITION else one.name for one in others]
    whole, total = cited_in_coq(outcome, paper), len(outcome.assumptions)
    replaced = [f"the others of {name}, as Coq proves what is used of it" for name in whole]
    parts = (
        (len(names), "believed", names),
        (len(proved), "proved in Coq", proved),
        (total - len(known), "not needed", replaced),
    )
    told = (f"{n} {_be(n)} {what}: {', '.join(list_)}." for n, what, list_ in parts if n)
    return " ".join((f"Uses {total or 'no'} assumption{'s' * (total != 1)}.", *told))


def _be(count: int) -> str:
    return "is" if count == 1 else "are"


def cited_in_coq(outcome: Outcome, paper: Publication) -> list[str]:
    """The names of the theorems that a statement cites and Coq proves, as far as they are used."""
    proved = paper.cited_in_coq.get(outcome.statement.theorem, ())
    return [cite.name for cite in outcome.statement.cites if cite.theorem in proved]


def _cited(
    theorem: str, cites: Iterable[Cite], paper: Publication
) -> Iterator[tuple[str, Assumption]]:
    proved = paper.cited_in_coq.get(theorem, ())
    for cite in cites:
        is_proved = cite.theorem in proved
        found = [(cite.theorem, one) for one in cite.assumptions]
        found += _cited(cite.theorem, cite.cites, paper)
        yield from ((by, one) for by, one in found if not is_proved or one.kind == DEFINITION)


def cited_as(cite: Cite, paper: Publication) -> str:
    """A cited statement, with the folder of its certificate where that is one of ours."""
    is_ours = paper.has(assumption.label for assumption in cite.trusted)
    folder = paper.folders.get(cite.theorem) if is_ours else None
    return f"the cited '{cite.name}'" + (f" ({folder})" if folder else "")


def summary(outcome: Outcome, paper: Publication, title: str = "") -> str:
    """The whole result in one line: verdict, theorem, parameters, rows, assumptions.

    ``title`` stands for that of the statement where it says the same.
    """
    parts = [counts(outcome, role) for role in (NEEDED, PRINTED)]
    rows = "; ".join(part for part in parts if part)
    own = outcome.statement.title
    title = title or (in_letters(own) if is_about(outcome, paper) else own)
    return f"{headline(outcome)}: {title}: {rows}; given {given_by(outcome, paper)}"


def in_letters(title: str) -> str:
    """A title of the program's own, which files have in ASCII, in the paper's letters."""
    for name, letter in TITLE_LETTERS.items():
        title = title.replace(name, letter)
    return title


def begun(text: str, names: Iterable[str] = ()) -> str:
    """The text with a capital, unless one of these names, or another letter, comes first."""
    first = re.findall(r"\w*", text)[0]
    if first in names or (len(first) == 1 and first not in "aA"):
        return text
    return text[:1].upper() + text[1:]


def taken_on_trust(outcome: Outcome, paper: Publication) -> Iterator[str]:
    """What the verdict takes on trust, sentence by sentence, and what only printed rows do."""
    if outcome.assumptions:
        yield f"Taken on trust, and not proved by this program: {given_by(outcome, paper)}"
        yield from (_assumption(one, paper) for one in outcome.assumptions)
    others = outcome.printed_assumptions
    if others:
        yield ""
        yield f"What only printed rows take on trust: {given(others)}"
        yield from (_assumption(one, paper) for one in others)


def _assumption(assumption: Assumption, paper: Publication) -> str:
    where = f", {paper.cited(assumption.label)}" if assumption.label else ""
    return f"  {assumption.name} ({assumption.kind}{where}): {assumption.sentence}"


def fair(outcome: Outcome, row: Obligation, found: Decision) -> str:
    """The verdict on what the text says; that on the claim is another where the text is right.

    A claim that is false is a remark where the text does not make it. Where the text says what is
    true, and derives it from the claim, it is proved, but not by the printed argument: if the row
    that takes the place of the claim is proved.
    """
    better = outcome.decisions.get(row.corrected_by or "")
    return fair_verdict(row, found.verdict, None if better is None else better.verdict)


def fair_verdict(row: Obligation, verdict: str, better: str | None) -> str:
    """The same from the verdicts on the row and on the one that takes its place."""
    if verdict != REFUTED or row.role != PRINTED:
        return verdict
    if row.severity == REMARK:
        return REMARK
    return OTHERWISE if row.severity == OTHERWISE and better == PROVED else REFUTED


#: What stands before the name of the row that takes the place of one.
INSTEAD_WORDS = {OTHERWISE: "proved by", REMARK: "see", REFUTED: "corrected by"}


#: The verdicts on rows, in the order in which they are counted, and how many of them are told.
COUNTED = {
    PROVED: "proved",
    REFUTED: "refuted",
    UNDECIDED: "undecided",
    OTHERWISE: "proved, but not by the printed argument",
    REMARK: "remarks",
}


def counts(outcome: Outcome, role: str) -> str:
    """The number of rows of one role by verdict; empty if there are no such rows."""
    found = Counter(fair(outcome, row, d) for row, d in outcome.rows if row.role == role)
    total = sum(found.values())
    parts = ", ".join(f"{found[v]} {word}" for v, word in COUNTED.items() if found[v])
    return f"{total} {role} ({parts})" if total else ""


def group_verdict(outcome: Outcome, group: str) -> str:
    """The verdict on all rows of one group, whatever their role; remarks are none of them."""
    rows = outcome.of_group(group)
    return conjunction(d for row, d in rows if fair(outcome, row, d) not in (OTHERWISE, REMARK))


def groups(outcome: Outcome) -> list[str]:
    """The groups of rows, in the order in which they are shown."""
    return list(dict.fromkeys(row.group for row in outcome.statement.obligations))


# --- rows ----------------------------------------------------------------------------------------


def letters(outcome: Outcome) -> Typesetter:
    """A typesetter in the paper's letters."""
    return letters_and_tex(outcome)[0]


def letters_and_tex(outcome: Outcome) -> tuple[Typesetter, dict[str, str]]:
    """The same, and the letters of all constants and variables in LaTeX."""
    found = letters_apart(outcome.statement).items()
    names, tex = ({name: letters[i] for name, letters in found} for i in (0, 1))
    return Typesetter(names | parameter_letters(outcome)), tex


def parameter_letters(outcome: Outcome) -> dict[str, str]:
    """The letters of the parameters: the paper's where they are those of Theorem 1."""
    found = parameters_of(outcome)
    known = LETTERS if {"V_0", "delta_theta"} <= found.keys() else {}
    return {name: known.get(name, name) for name in found}


def values_told(values: Mapping[str, Term], typesetter: Typesetter) -> str:
    """Names with the values that they have."""
    term = typesetter.term
    return ", ".join(f"{term(symbol(name))} = {term(value)}" for name, value in values.items())


def short_name(row: Obligation) -> str:
    """The name of a row without its group."""
    return row.name.removeprefix(f"{row.group}.")


def is_called(row: Obligation, word: str, paper: Publication) -> bool:
    """Whether a word is a row's name, with or without its group, its label, or its number."""
    number = paper.printed(row.label) or ""
    return word in (row.name, short_name(row), row.label, number, number.strip("()")) and word != ""


def sentence(row: Obligation, typesetter: Typesetter) -> str:
    """The step in the paper's words, then the claim that is decided, where that is short.

    A row without words has a claim that is written, or says where it is.
    """
    formula = typesetter.claim(row.claim)
    if len(formula) > MAX_FORMULA:
        return row.says or LONG
    return f"{row.says}: {formula}"


def witness_of(row: Obligation, decision: Decision) -> dict[str, Term]:
    """The values at which a claim about all values is false, of the variables that it has."""
    if not isinstance(row.claim, Claim):
        return dict(decision.witness)
    used = set(names_of(row.claim.lhs, row.claim.rhs))
    return {name: term for name, term in decision.witness.items() if name in used}


def witness_shown(outcome: Outcome, row: Obligation, decision: Decision) -> dict[str, Term]:
    """The same, of the variables on which the claim depends, through definitions too."""
    if not isinstance(row.claim, Claim):
        return dict(decision.witness)
    contexts = outcome.statement.contexts
    defined = {one.name: one.term for context in contexts for one in context.constants}
    used: set[str] = set()
    left = [row.claim.lhs, row.claim.rhs]
    while left:
        new = set(names_of(left.pop())) - used
        used |= new
        left += [defined[name] for name in new if name in defined]
    return {name: term for name, term in decision.witness.items() if name in used}


def sides_of(row: Obligation, decision: Decision) -> tuple[Ends, Ends] | None:
    """Enclosures of both sides, where the claim compares numbers and these are known."""
    if decision.sides is None or not isinstance(row.claim, Claim):
        return None
    lhs, rhs = decision.sides.ends
    return lhs, rhs


def sides_told(row: Obligation, decision: Decision, digits: int = 8) -> str:
    """Both sides with the sign between them; nothing where they are not known.

    Where no digits tell them apart, it is said how far apart they may be.
    """
    sides = sides_of(row, decision)
    if sides is None or not isinstance(row.claim, Claim):
        return ""
    texts = as_one_or_two(*sides, digits)
    if len(texts) == 1:
        return f"both sides {texts[0]}"
    return f" {SIGNS[row.claim.relation]} ".join(texts)


def sides_named(left: Ends, right: Ends) -> str:
    """Both sides by their names."""
    texts = as_one_or_two(left, right)
    named = "both sides {}" if len(texts) == 1 else "left side {}, right side {}"
    return named.format(*texts)


def parameters_of(outcome: Outcome) -> dict[str, Term]:
    """The parameters in the order of the paper, whatever order a file has them in."""
    found = outcome.statement.parameters
    return {name: found[name] for name in sorted(found, key=_place)}


def _place(name: str) -> tuple[int, str]:
    places = {name: place for place, name in enumerate(LETTERS)}
    return places.get(name, len(places)), name


# --- constants -----------------------------------------------------------------------------------


def definitions_of(outcome: Outcome) -> dict[str, Term]:
    """What each parameter and each constant without variables stands for."""
    statement = outcome.statement
    return {**parameters_of(outcome), **{c.name: c.term for c in statement.constants}}


def ends_of(outcome: Outcome, name: str) -> Ends | None:
    """The enclosure of a parameter or a constant, if there is one."""
    found = outcome.enclosures.get(name)
    return None if found is None else found.ends[0]


def ends_told(ends: Ends | None) -> str:
    """An enclosure in short, where a number is defined."""
    return "undefined" if ends is None else short(ends)


def constants_of(outcome: Outcome, group: str) -> list[Constant]:
    """The constants of one group; those of the group "" are common to all."""
    found = outcome.statement.constants
    return [c for c in found if c.name.rpartition(".")[0] == group]
