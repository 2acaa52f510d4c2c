"""The chapters of a page: lines in one context, each a claim and what it follows from.

    [[chapters]]
    in = "state"
    label = "EQUATSS4.1SysteDynamColSp"

    [chapters.rows]
    gained-positive = { lemma = "0 < gained", by = "tau-positive B-positive", using = "gained" }
    next-Cnd4 = { claim = "Cnd4 at next", by = "gained-positive law-angle", says = "..." }

A claim is a row of the statement, a lemma is not. ``Cnd4 at next`` is the claim of that name with
the values of that state of its context in place of the variables.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import Any

from verify.language.argument import (
    ByApplying,
    ByCases,
    ByEntry,
    ByInduction,
    ByInstance,
    ByInterval,
    ByLeast,
    ByNames,
    ByNegation,
    ByRoot,
    BySum,
    ByWitness,
    Chapter,
    Defined,
    Line,
    Opened,
    Reason,
    ToBeFound,
)
from verify.language.statement import NEEDED, REFUTED, Always, Applies, Obligation
from verify.language.terms import Claim, Term, names_of, substitute, substitute_claim
from verify.prover.arguments import facts_of
from verify.wire.inputs import nearest, shown
from verify.wire.text.by import Facts, read_by
from verify.wire.text.infix import read_term
from verify.wire.text.page_tables import Reader

CHAPTER = (
    *("in", "group", "label", "says", "uses", "role", "let", "at", "by", "using", "facts"),
    *("constants", "rows"),
)
LINE = (
    *("lemma", "claim", "applies", "at", "always", "start", "next", "instance", "in"),
    *("entries", "says", "label", "uses", "role", "severity", "corrected_by"),
    *("by", "using", "plus", "rule", "of", "side", "false_at", "verdict"),
)
#: What stands in place of a text where a sum for one entry replaces names.
BRANCH = ("by", "using", "plus")
#: What a line is.
KINDS = ("lemma", "claim", "applies", "always", "instance")
#: Rules that are named, since no facts are added.
RULES = ("cases", "least", "entry", "root", "interval")
AT = re.compile(r"\s*([A-Za-z][A-Za-z0-9_.:-]*)\s+at\s+([A-Za-z][A-Za-z0-9_-]*)\s*")

Keys = Sequence[str]


def read_chapters(page: Reader, value: object) -> tuple[Chapter, ...]:
    """The chapters of a page whose contexts have been read."""
    return Lines(page).chapters(value)


class Lines:
    """Reads the chapters of a page, whose contexts have been read."""

    def __init__(self, page: Reader) -> None:
        self.page, self.places = page, page.places
        self.claims: dict[str, Claim] = {}
        self.homes: dict[str, str | None] = {}
        self.waiting = list(page.contexts.values())
        self.conditions = {g.name: (g.claim, c.name) for c in self.waiting for g in c.givens}
        self.facts: tuple[str, ...] = ()  # what each line from here on may use
        self.names: set[str] = set()  # of all lines, as they are written
        self.undefined: dict[str, tuple[str | None, Term]] = {}
        self.defined: dict[str, Term] = {}
        for context in self.waiting:
            for constant in context.constants:
                self.undefined[constant.name] = (context.name, constant.term)
                self.defined[constant.name] = constant.term
                self.homes[constant.name] = context.name

    def chapters(self, value: object) -> tuple[Chapter, ...]:
        """All chapters, with the places where contexts open and constants are defined."""
        if not isinstance(value, list):
            raise self.places.error(["chapters"], "is no list of tables; write [[chapters]]")
        self.names = {name for entry in value for name in _rows_of(entry)}
        last = {self._home(entry): number for number, entry in enumerate(value)}
        found = [*self._before()] if value else []
        for number, entry in enumerate(value):
            found += self._chapter(entry)
            home = self._home(entry)
            if last[home] == number:
                found.append(Chapter(home, tuple(self._left(home))))
        if value:
            found += self._opened(len(self.waiting))
            found += [Chapter(home, tuple(self._left(home))) for home in self.page.contexts]
        return tuple(_joined(found))

    def _before(self) -> Iterator[Chapter]:
        """The rows that stand outside of chapters, as lines before them."""
        for row in self.page.rows.values():
            claim = row.claim
            yield from self._opened_up_to(row.context)
            yield from self._opened_up_to(None if isinstance(claim, Claim) else claim.context)
            line = Line(row.name, claim, ToBeFound())
            yield from self._with_constants(line, row.context)
            self._known(line, row.context)

    def _with_constants(self, line: Line, home: str | None) -> Iterator[Chapter]:
        """A line, after the constants that it is the first to use."""
        for constant in self._defined(line):
            yield Chapter(self.homes[constant.name], (constant,))
        yield Chapter(home, (line,))

    def _home(self, entry: object) -> str | None:
        """The context of a chapter, if it is in one."""
        (home, *others) = self._homes(entry)
        return None if others or home in self.page.sets else home

    def _homes(self, entry: object) -> Sequence[str | None]:
        """Where a chapter is: in a context, in one or some sets of constants, or in neither."""
        table, sets = self.page.table(["chapters"], entry, CHAPTER), self.page.sets
        value = table.get("in", [])
        if not sets or not value or (isinstance(value, str) and value not in sets):
            return (self.page.around(["chapters"], table),)
        names = self.page.texts(["chapters", "in"], value)
        return [self.page.one_of(["chapters", "in"], name, [*sets]) for name in names]

    def _are_here(self, keys: Keys, line: Line, home: str | None) -> None:
        """Afterwards the facts that a line names, and its terms, are known where it uses them."""
        reason = line.reason.reason if isinstance(line.reason, ByNegation) else line.reason
        places: dict[str, str | None] = dict.fromkeys(facts_of(reason), home)
        if isinstance(reason, ByInstance):
            places = dict.fromkeys(reason.givens, home)
        if isinstance(reason, ByInduction) and isinstance(line.claim, Always):
            places = dict.fromkeys(reason.next, line.claim.context)
            places |= dict.fromkeys(reason.start, home)
        for name, place in places.items():
            found = self.homes.get(name)
            if found not in (*self.page.scope.chain(place),):
                what = f"{shown(name)} is a fact of {found}, and not known {_where(place)}"
                raise self.places.error([*keys, "by"], f"{what}; name another one")
        self._are_in_scope(keys, _terms(line, inside=False), home)
        if isinstance(reason, ByWitness) and home in self.page.contexts:
            self._are_in_scope(keys, reason.at.values(), self.page.contexts[home].parent)

    def _are_in_scope(self, keys: Keys, terms: Iterable[Term], home: str | None) -> None:
        """Afterwards the names in terms are known in a context; those of states may be others."""
        for name in names_of(*terms):
            found = self.page.scope.homes.get(name)
            if found in self.page.contexts and found not in self.page.scope.chain(home):
                what = f"{shown(name)} is a name of {found}, and not known {_where(home)}"
                raise self.places.error(keys, f"{what}; write values without it, or another in")

    def _left(self, home: str | None) -> Iterator[Defined]:
        """The constants of a context that none of its lines uses."""
        for name in [name for name, (context, _) in self.undefined.items() if context == home]:
            yield from self._define(name)

    def _chapter(self, entry: object) -> Iterator[Chapter]:
        table = self.page.table(["chapters"], entry, CHAPTER)
        homes = self._homes(entry)
        yield from self._opened_up_to(self._home(entry))
        self.page.let(["chapters", "let"], table.get("let", {}), homes)
        self._constants(table, homes)
        self.facts += self._names(["chapters", "facts"], table.get("facts", ""))
        rows = self.page.table(["chapters", "rows"], table.get("rows", {}))
        for key, short, home in self.page.placed(rows, homes):
            keys, row = ["chapters", "rows", key], rows[key]
            inner = self._home_of_line(keys, row, home)
            yield from self._opened_up_to(inner)
            for place, line in self._lines(keys, self.page.full(short, inner), row, inner, table):
                self._are_here(keys, line, place)
                yield from self._with_constants(line, None if place in self.page.sets else place)

    def _constants(self, chapter: Mapping[str, Any], homes: Sequence[str | None]) -> None:
        """The constants that a chapter defines, of the page or of its sets."""
        keys = ["chapters", "constants"]
        entries = self.page.table(keys, chapter.get("constants", {}))
        if entries and {*homes} & {*self.page.contexts}:
            what = "a context has its constants below [contexts.NAME.constants]; write them there"
            raise self.places.error(keys, what)
        label = self.page.text(["chapters", "label"], chapter.get("label", ""), "a label")
        for key, short, home in self.page.placed(entries, homes):
            place = [*keys, key]
            self.page.constants.append(self.page.constant(place, short, entries[key], home, label))

    def _home_of_line(self, keys: Keys, row: object, home: str | None) -> str | None:
        """The context that a line names, of which "" is none; else that of its chapter."""
        found = row.get("in", home) if isinstance(row, dict) else home
        if found in (None, ""):
            return None
        if found == home:
            return home
        if not isinstance(found, str) or found not in self.page.contexts:
            raise self.places.error([*keys, "in"], self.page.no_context(found))
        return found

    def _opened_up_to(self, home: str | None) -> Iterator[Chapter]:
        """The contexts of the page up to this one, if it is not open."""
        names = [context.name for context in self.waiting]
        yield from self._opened(names.index(home) + 1 if home in names else 0)

    def _opened(self, count: int) -> Iterator[Chapter]:
        """The next contexts of the page, each opened where its parent is."""
        for context in self.waiting[:count]:
            self.claims |= {given.name: given.claim for given in context.givens}
            self.homes |= {given.name: context.name for given in context.givens}
            premises = self.page.premises.get(context.name)
            if premises is not None:
                self._paired(["contexts", context.name], " ".join(premises), context.name)
            yield Chapter(context.parent, (Opened(context, premises),))
        del self.waiting[:count]

    def _defined(self, line: Line) -> Iterator[Defined]:
        """The constants that a line is the first to use, after those that they use."""
        used = [*_terms(line)]
        facts = _facts(line.reason)
        for name in [*names_of(*used), *facts]:
            yield from self._define(name)

    def _define(self, name: str) -> Iterator[Defined]:
        if name in self.undefined:
            _, term = self.undefined.pop(name)
            for inner in names_of(term):
                yield from self._define(inner)
            yield Defined(name)

    # --- one line, or a family of them ---------------------------------------------------------

    def _lines(
        self, keys: Keys, name: str, row: object, home: str | None, chapter: Mapping[str, Any]
    ) -> Iterator[tuple[str | None, Line]]:
        """The lines under a name, each with its context."""
        table = self.page.table(keys, row if isinstance(row, dict) else {"lemma": row}, LINE)
        if "entries" in table:
            for line in self._family(keys, name, table, home, chapter):
                yield home, line
        elif "at" in table and "claim" in table and "instance" not in table:
            place = None if home is None else self.page.contexts[home].parent
            claim = self._at_values(keys, table, home)
            yield (
                place,
                self._stated(
                    keys,
                    name,
                    claim,
                    self._reason(keys, table, claim, place),
                    place,
                    table,
                    chapter,
                ),
            )
        else:
            yield home, self._line(keys, name, table, home, chapter)

    def _family(
        self,
        keys: Keys,
        name: str,
        table: Mapping[str, Any],
        home: str | None,
        chapter: Mapping[str, Any],
    ) -> Iterator[Line]:
        """What each entry of the minimum, or maximum, says that a constant is.

        These are rows if something is said of them, in which ``{i}`` is the number of the entry.
        """
        of = self.page.text([*keys, "entries"], table["entries"], "the name of a constant")
        if of not in self.defined:
            instead = nearest(of, self.defined, "write the name of a constant of a context")
            raise self.places.error([*keys, "entries"], f"{shown(of)} is no constant; {instead}")
        whole, term = Term("symbol", of), self.defined[of]
        extremum = term.op in ("min", "max")
        for number, entry in enumerate(term.children if extremum else (term,), 1):
            sides = (entry, whole) if term.op == "max" else (whole, entry)
            reason = ByEntry(of) if extremum else ByNames((of, *self._facts_in(home)))
            if term.op == "max":
                reason = ByEntry(of, "rhs")
            line = f"{name}-{number}", Claim("<=", *sides), reason
            if "says" not in table and line[0] not in self.page.stated:
                self.page.name(keys, line[0])
                self._known(Line(*line), home)
                yield Line(*line)
                continue
            said = dict(table)
            if "says" in table:
                says = self.page.text([*keys, "says"], table["says"])
                said["says"] = says.replace("{i}", str(number))
            yield self._stated(keys, *line, home, said, chapter)

    def _at_values(self, keys: Keys, table: Mapping[str, Any], home: str | None) -> Claim:
        """A claim at values of the variables of its context, with what the constants are there."""
        claim = self._claim([*keys, "claim"], table["claim"], home)
        values = self._values([*keys, "at"], table["at"], home or "", None)
        return substitute_claim(claim, self._with_constants_at(home, values))

    def _with_constants_at(
        self, context: str | None, values: Mapping[str, Term]
    ) -> Mapping[str, Term]:
        """Values of the variables of a context, with what its constants are there."""
        found = dict(values)
        for constant in self.page.contexts[context or ""].constants:
            found[constant.name] = substitute(constant.term, found)
        return found

    def _line(
        self,
        keys: Keys,
        name: str,
        table: Mapping[str, Any],
        home: str | None,
        chapter: Mapping[str, Any],
    ) -> Line:
        if "instance" in table:
            table = {**_fields(chapter, ("at", "by")), **table}
        elif not {*BRANCH, "rule", "false_at", "instance"} & {*table}:
            table = {**_fields(chapter, ("using",)), **table}
        kinds = [kind for kind in KINDS if kind in table]
        if len(kinds) != 1 and kinds != ["claim", "instance"]:
            what = f"it has {' and '.join(kinds)}" if kinds else "it has no claim"
            raise self.places.error(keys, f"{what}; write one of {', '.join(KINDS)}")
        (kind, *_) = kinds
        for key in _passed_over(table):
            raise self.places.error([*keys, key], "it changes nothing here; leave it out")
        claim: Claim | Applies | Always
        if kind in ("applies", "always"):
            claim = self._of_context(keys, kind, table, home)
        elif kind == "instance":
            claim = self._instance(keys, table, home)
        else:
            claim = self._claim([*keys, kind], table[kind], home)
        reason = self._reason(keys, table, claim, home)
        if kind not in ("lemma", "instance"):
            return self._stated(keys, name, claim, reason, home, table, chapter)
        self.page.name(keys, name)
        self._holds(keys, table)
        line = Line(name, claim, reason)
        self._known(line, home)
        return line

    def _stated(
        self,
        keys: Keys,
        name: str,
        claim: Claim | Applies | Always,
        reason: Reason,
        home: str | None,
        table: Mapping[str, Any],
        chapter: Mapping[str, Any],
    ) -> Line:
        """A line that is a row of the statement."""
        self.page.name(keys, name)
        line = Line(name, claim, reason)
        if "verdict" in table:
            line = line._replace(reason=self._negation(keys, table["verdict"], line.reason))
        stated = self._as_stated(keys, name, claim)
        said = {**_fields(chapter, _FIELDS[:5]), **stated, **_fields(table)}
        if home in self.page.sets:
            said, home = self._said_in(home, name, said), None
        fields = self.page.fields(keys, said)
        line = line._replace(label=fields["label"], says=fields["says"], uses=fields["uses"])
        self.page.add(keys, Obligation(name=name, claim=claim, context=home, **fields))
        self._known(line, home)
        return line

    def _as_stated(self, keys: Keys, name: str, claim: Claim | Applies | Always) -> dict[str, Any]:
        """What the other page, whose rows this one shows, says of a row; it has the same claim."""
        row = self.page.stated.get(name)
        if row is None:
            return {}
        if row.claim != claim:
            what = f"the page under rows_of has another claim of the name {shown(name)}"
            raise self.places.error(keys, f"{what}; write that, or choose another name")
        found = {key: getattr(row, key) for key in _FIELDS if key != "uses"}
        return {key: value for key, value in found.items() if value}

    def _said_in(self, home: str, name: str, said: Mapping[str, Any]) -> dict[str, Any]:
        """What is said of a row of a set; how bad it is if it is false concerns the printed one."""
        role = self.page.sets[home]
        found = {"group": home, "role": role, **said}
        if role == NEEDED:
            return {k: v for k, v in found.items() if k not in ("severity", "corrected_by")}
        needed = (s for s, other in self.page.sets.items() if other == NEEDED)
        if "severity" in found and "corrected_by" not in found:
            for better in needed:
                found["corrected_by"] = name.replace(home, better, 1)
        return found

    def _holds(self, keys: Keys, table: Mapping[str, Any]) -> None:
        """Afterwards a table says nothing that only rows may say."""
        for key in ("false_at", "verdict", "role", "uses", "severity", "corrected_by"):
            if key in table:
                what = "a lemma is no row, and has to hold; write claim = ..., or leave it out"
                raise self.places.error([*keys, key], what)

    def _negation(self, keys: Keys, verdict: object, reason: Reason) -> ByNegation:
        """The reason, for the negation of the claim."""
        if verdict != REFUTED:
            what = f"{shown(str(verdict))} is no verdict here; write {REFUTED!r}, or leave it out"
            raise self.places.error([*keys, "verdict"], what.replace("'", '"'))
        return ByNegation(reason)

    def _known(self, line: Line, home: str | None) -> None:
        if isinstance(line.claim, Claim) and not isinstance(line.reason, ByWitness | ByNegation):
            self.claims[line.name], self.homes[line.name] = line.claim, home

    def _claim(self, keys: Keys, value: object, home: str | None) -> Claim:
        text = self.page.text(keys, value, "a claim")
        match = AT.fullmatch(text)
        if match and match[1] in self.conditions:
            condition, context = self.conditions[match[1]]
            return substitute_claim(condition, self._state(keys, context, match[2]))
        found = self.page.claims(keys, text, self.page.scope.inside(home))
        if len(found) != 1:
            raise self.places.error(
                keys, f"{shown(text)} is {len(found)} claims; write a line each"
            )
        return found[0]

    def _state(self, keys: Keys, context: str, state: str) -> Mapping[str, Term]:
        """The values of a state of a context."""
        states = self.page.states.get(context, {})
        if not states:
            raise self.places.error(keys, f"{shown(context or 'a number')} has no states")
        if state not in states:
            instead = nearest(state, states, f"{context} has the states {', '.join(states)}")
            raise self.places.error(keys, f"{shown(state)} is no state; {instead}")
        return states[state]

    def _instanced(self, keys: Keys, table: Mapping[str, Any]) -> str:
        """The fact of which a line is an instance."""
        fact = self.page.text([*keys, "instance"], table["instance"], "the name of a fact")
        self._fact([*keys, "instance"], fact)
        if fact not in self.claims:
            what = f"{shown(fact)} is a constant; write the name of a given or of an earlier line"
            raise self.places.error([*keys, "instance"], what)
        return fact

    def _instance(self, keys: Keys, table: Mapping[str, Any], home: str | None) -> Claim:
        fact = self._instanced(keys, table)
        place = self.homes[fact]
        values = self._values([*keys, "at"], table.get("at"), place or "", home)
        return substitute_claim(self.claims[fact], self._with_constants_at(place, values))

    def _values(self, keys: Keys, value: object, name: str, home: str | None) -> Mapping[str, Term]:
        """The values of the variables of a context, or those of the state that is named."""
        self._is_there(keys, value, "values, or the name of a state")
        if isinstance(value, str) and "=" not in value:
            return self._state(keys, name, value)
        if name not in self.page.contexts:
            raise self.places.error(keys, "numbers have no other values; leave it out")
        context, names = self.page.contexts[name], self.page.scope.inside(home)
        known = self.page.scope.inside(context.name).known
        return self.page.complete(
            keys, self.page.values(keys, value, names), known, context.variables
        )

    def _of_context(
        self, keys: Keys, kind: str, table: Mapping[str, Any], home: str | None
    ) -> Applies | Always:
        name = self.page.text([*keys, kind], table[kind], "the name of a context")
        if kind == "applies" and name in self.page.contexts_cited:
            variables, _ = self.page.contexts_cited[name]
            inside = self.page.scope.inside(home)
            return Applies(name, self.page.at(keys, "at", table, variables, inside))
        if name not in self.page.contexts:
            raise self.places.error([*keys, kind], self.page.no_context(name))
        if kind == "applies":
            return Applies(name, self._values([*keys, "at"], table.get("at"), name, home))
        parent = self.page.contexts[name].parent
        if home != parent:
            what = f"{name} is not a context inside of {home or 'the page'}"
            raise self.places.error(keys, f'{what}; write in = "{parent or ""}"')
        start = self._values([*keys, "start"], table.get("start"), name, home)
        return Always(name, start, self._values([*keys, "next"], table.get("next"), name, name))

    # --- what it follows from -------------------------------------------------------------------

    def _reason(
        self,
        keys: Keys,
        table: Mapping[str, Any],
        claim: Claim | Applies | Always,
        home: str | None,
    ) -> Reason:
        by = table.get("by")
        if "false_at" in table:
            place = [*keys, "false_at"]
            around = self.page.contexts[home].parent if home in self.page.contexts else None
            return ByWitness(self._values(place, table["false_at"], home or "", around))
        if isinstance(claim, Applies):
            return ToBeFound() if by is None else ByApplying(self._paired(keys, by, claim.context))
        if isinstance(claim, Always):
            if by is None:
                return ToBeFound()
            pair = by if isinstance(by, list) and len(by) == 2 else [by, by]
            start, after = (self._paired(keys, text, claim.context, "carried") for text in pair)
            return ByInduction(start, after)
        if "instance" in table:
            fact = self._instanced(keys, table)
            values = self._values([*keys, "at"], table.get("at"), self.homes[fact] or "", home)
            return ByInstance(fact, values, self._paired(keys, by, self.homes[fact]))
        if "rule" in table:
            return self._rule(keys, table, claim, home)
        if (
            by is None
            and "using" not in table
            and "plus" not in table
            and not self._may_use(claim, home)
        ):
            return ToBeFound()
        if isinstance(by, list):
            equation, side = self._entries(keys, table, "rhs")
            entries = self._extremum(keys, claim, equation, side).children
            return ByLeast(self._branches(keys, by, entries, home), equation, side)
        return self._sum(keys, table, home)

    def _rule(self, keys: Keys, table: Mapping[str, Any], claim: Claim, home: str | None) -> Reason:
        rule = self.page.text([*keys, "rule"], table["rule"], "the name of a rule")
        if rule == "root":
            return ByRoot()
        if rule == "interval":
            return ByInterval()
        if rule == "entry":
            return ByEntry(*self._entries(keys, table, "lhs"))
        if rule == "cases":
            return self._cases(keys, table, home)
        if rule == "least":
            return self._least(keys, table, claim, home)
        instead = nearest(rule, RULES, f"write {', '.join(RULES)}")
        raise self.places.error([*keys, "rule"], f"{shown(rule)} is no rule here; {instead}")

    def _entries(self, keys: Keys, table: Mapping[str, Any], side: str) -> tuple[str | None, str]:
        """The equation that says what a minimum is, if it is named, and the side with it."""
        of = table.get("of")
        if of is not None:
            of = self.page.text([*keys, "of"], of, "the name of an equation")
            self._fact([*keys, "of"], of)
        return of, self.page.one_of([*keys, "side"], table.get("side", side), ("lhs", "rhs"))

    def _least(
        self, keys: Keys, table: Mapping[str, Any], claim: Claim, home: str | None
    ) -> ByLeast:
        """The same names for each entry of the minimum, or maximum, of a side."""
        equation, side = self._entries(keys, table, "rhs")
        found = self._sum(keys, table, home)
        if isinstance(found, BySum):
            raise self.places.error(keys, "products are written for each entry: by = [...]")
        entries = self._extremum(keys, claim, equation, side).children
        return ByLeast((found,) * len(entries), equation, side)

    def _extremum(self, keys: Keys, claim: Claim, equation: str | None, side: str) -> Term:
        """The minimum or maximum on a side, or the one that an equation says it is."""
        found = claim.lhs if side == "lhs" else claim.rhs
        found = found if equation is None else self._meaning(equation)
        if found.op not in ("min", "max"):
            where = "left" if side == "lhs" else "right"
            what = f"the {where} side is no minimum or maximum"
            instead = 'write its equation as of = ..., or side = "lhs", or one text as by'
            raise self.places.error(keys, f"{what}; {instead}")
        return found

    def _meaning(self, equation: str) -> Term:
        """The right side of an equation, or of the definition of a constant."""
        known = self.claims.get(equation)
        return self.defined[equation] if known is None else known.rhs

    def _cases(self, keys: Keys, table: Mapping[str, Any], home: str | None) -> ByCases:
        """A sum for each entry of a minimum or maximum; ``@1``, ... name what holds there."""
        of = self.page.term([*keys, "of"], table.get("of", ""), self.page.scope.inside(home))
        by = table.get("by")
        if of.op not in ("min", "max") or not isinstance(by, list):
            what = 'write of = "min(a, b)", or max, and by = [...] with a sum for each entry'
            raise self.places.error(keys, what)
        assumed = tuple(f"@{i}" for i, _ in enumerate(of.children, 1))
        found = self._branches(keys, by, of.children, home, assumed)
        branches = [b for b in found if isinstance(b, BySum)]
        if len(branches) < len(by):
            raise self.places.error(keys, 'write the products for each entry: "goal + a*b"')
        return ByCases(of, tuple(branches))

    def _sum(
        self, keys: Keys, table: Mapping[str, Any], home: str | None, assumed: Sequence[str] = ()
    ) -> BySum | ByNames:
        inside = self.page.scope.inside(home)
        place = [*keys, "by"]
        text = self.page.text(place, table.get("by", ""), "names of facts")

        def term(inner: str) -> Term:
            return read_term(self.places.where(place, text), inner, inside)

        def fact(name: str) -> None:
            self._fact(place, name, assumed)

        addends = read_by(self.places.where(place, text), text, fact, term)
        using = self._names([*keys, "using"], table.get("using", ""), assumed)
        self._equations([*keys, "using"], [name for name in using if name not in assumed])
        plus = self.page.values([*keys, "plus"], table.get("plus", {}), inside)
        self._equations([*keys, "plus"], plus)
        equations = tuple(plus.items())
        if not isinstance(addends, Facts):
            return BySum(addends, using, equations)
        if using or equations:
            if addends:
                what = "names of facts have no equations; write the products: goal + a*b, or leave"
                raise self.places.error(place, f"{what} using and plus out")
            return BySum((), using, equations)
        return ByNames((*dict.fromkeys((*addends, *self._facts_in(home))),))

    def _may_use(self, claim: Claim, home: str | None) -> bool:
        """Whether a line that names nothing may use facts that a chapter names."""
        return bool(self._facts_in(home)) and any(names_of(claim.lhs, claim.rhs))

    def _facts_in(self, home: str | None) -> list[str]:
        """What each line may use beside what it names, as far as it is known in a context."""
        around = {*self.page.scope.chain(home)}
        return [name for name in self.facts if self.homes.get(name) in around]

    def _branches(
        self,
        keys: Keys,
        by: Sequence[object],
        entries: Sequence[object],
        home: str | None,
        assumed: Sequence[str] = (),
    ) -> tuple[BySum | ByNames, ...]:
        """The sums for the entries of a minimum or maximum."""
        if len(by) != len(entries):
            what = f"it has {len(by)} texts for {len(entries)} entries; write one for each"
            raise self.places.error([*keys, "by"], what)
        tables = [entry if isinstance(entry, dict) else {"by": entry} for entry in by]
        place = [*keys, "by"]
        return tuple(
            self._sum(keys, self.page.table(place, table, BRANCH), home, assumed)
            for table in tables
        )

    def _names(self, keys: Keys, value: object, assumed: Sequence[str] = ()) -> tuple[str, ...]:
        """The facts of which a text has the names."""
        self._is_there(keys, value, "names of facts")
        names = self.page.text(keys, value, "names of facts").split()
        for name in names:
            self._fact(keys, name, assumed)
        return tuple(names)

    def _paired(
        self, keys: Keys, value: object, context: str | None, kind: str | None = None
    ) -> tuple[str, ...]:
        """The facts that say, given by given, that those of a context hold."""
        place, found = [*keys, "by"], self._names([*keys, "by"], value)
        if context in self.page.contexts:
            givens = self.page.contexts[context].givens
            names = [given.name for given in givens if kind in (None, given.kind)]
            if len(names) != len(found):
                what = f"it names {len(found)} facts; write one for each of {', '.join(names)}"
                raise self.places.error(
                    place, what if names else f'{context} has no givens; by = ""'
                )
        return found

    def _is_there(self, keys: Keys, value: object, what: str) -> None:
        """Afterwards a key that is needed has a value."""
        if value is None:
            raise self.places.error(keys, f'is missing; write {what} as {keys[-1]} = "..."')

    def _fact(self, keys: Keys, name: str, assumed: Sequence[str] = ()) -> None:
        """Afterwards a name is that of a fact, or of what a case assumes."""
        if name in self.claims or name in self.homes or name in assumed:
            return
        if name in self.names:
            what = f"{shown(name)} is this line, a later one, or one that is false"
            raise self.places.error(keys, f"{what}; name facts that are shown before")
        known = [*self.claims, *self.homes]
        otherwise = "write names of what is given, of earlier lines, or of constants"
        instead = nearest(name, known, otherwise)
        raise self.places.error(keys, f"{shown(name)} is no fact known here; {instead}")

    def _equations(self, keys: Keys, names: Iterable[str]) -> None:
        """Afterwards names are those of equations, or of definitions."""
        for name in names:
            self._fact(keys, name)
            claim = self.claims.get(name)
            if claim is not None and claim.relation != "=":
                what = f"{shown(name)} is no equation"
                raise self.places.error(keys, f"{what}; name it in by, or name an equation")


def _passed_over(table: Mapping[str, Any]) -> Iterator[str]:
    """The keys of a line that say how it follows, and of which its kind of proof has no use."""
    rule, products = table.get("rule"), ("by", "using", "plus")
    others: tuple[str, ...] = ()
    if "false_at" in table:
        others = (*products, "rule", "of", "side", "verdict")
    elif any(kind in table for kind in ("applies", "always", "instance")):
        others = ("using", "plus", "rule", "of", "side")
    elif rule in ("root", "interval"):
        others = (*products, "of", "side")
    elif rule == "entry":
        others = products
    elif rule == "cases":
        others = ("using", "plus", "side")
    elif rule is None and not isinstance(table.get("by"), list):
        others = ("of", "side")
    yield from (key for key in others if key in table)


def _joined(chapters: Iterable[Chapter]) -> Iterator[Chapter]:
    """The chapters, with those that follow one another in one context in one."""
    for home, some in groupby(chapters, key=lambda chapter: chapter.context):
        items = tuple(item for chapter in some for item in chapter.items)
        if items:
            yield Chapter(home, items)


#: What is said of a row; the first five may be said of a chapter.
_FIELDS = ("group", "label", "says", "uses", "role", "severity", "corrected_by")


def _fields(table: Mapping[str, Any], keys: Sequence[str] = _FIELDS) -> dict[str, Any]:
    return {key: table[key] for key in keys if key in table}


def _where(home: str | None) -> str:
    return "outside of contexts" if home is None else f"in {home}"


def _rows_of(chapter: object) -> Iterable[str]:
    """The names of the lines of a chapter, if it has any."""
    rows = chapter.get("rows") if isinstance(chapter, dict) else None
    return rows if isinstance(rows, dict) else ()


def _terms(line: Line, *, inside: bool = True) -> Iterator[Term]:
    """The terms in a line: those of its claim, and those in its reason.

    Those of the next state of an induction are terms inside of its context.
    """
    claim = line.claim
    if isinstance(claim, Claim):
        yield from (claim.lhs, claim.rhs)
    elif isinstance(claim, Applies):
        yield from claim.at.values()
    else:
        yield from (*claim.start.values(), *(claim.next.values() if inside else ()))
    reason = line.reason.reason if isinstance(line.reason, ByNegation) else line.reason
    if isinstance(reason, ByCases):
        yield reason.of
    for part in (reason, *(reason.branches if isinstance(reason, ByLeast | ByCases) else ())):
        if isinstance(part, BySum):
            yield from (term for _, term in part.equations)
            yield from (term for value in part.addends for term in _squared(value))
        if isinstance(part, ByNames):
            yield from (term for value in part.facts for term in _squared(value))
        if isinstance(part, ByInstance):
            yield from part.values.values()


def _squared(value: object) -> Iterator[Term]:
    if isinstance(value, Term):
        yield value
    elif isinstance(value, tuple):
        for part in value[1:]:
            yield from _squared(part)


def _facts(reason: Reason) -> Iterator[str]:
    """The names of equations that a reason uses, which may define constants."""
    if isinstance(reason, ByNegation):
        yield from _facts(reason.reason)
    elif isinstance(reason, BySum):
        yield from reason.using
        yield from (name for name, _ in reason.equations)
    elif isinstance(reason, ByNames):
        yield from (fact for fact in reason.facts if isinstance(fact, str))
    elif isinstance(reason, ByLeast | ByCases):
        yield from (name for branch in reason.branches for name in _facts(branch))
        yield from [reason.equation] if isinstance(reason, ByLeast) and reason.equation else []
    elif isinstance(reason, ByEntry) and reason.equation:
        yield reason.equation
    elif isinstance(reason, ByApplying | ByInstance):
        yield from reason.givens
