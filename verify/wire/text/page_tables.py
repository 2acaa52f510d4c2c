"""The tables of a page: parameters, constants, contexts, rows, each checked as it is read."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any

from verify.check import MAX_NESTING
from verify.language.record import TYPE_CHECKING
from verify.language.statement import (
    NEEDED,
    PRINTED,
    Always,
    Applies,
    Assumption,
    Choice,
    Cite,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Claim, Term, names_of
from verify.prover.hint import Hint
from verify.wire.inputs import InputError, nearest, shown
from verify.wire.text import Page
from verify.wire.text.estimates import estimate
from verify.wire.text.infix import (
    CALLED,
    Names,
    PageFunction,
    read_claims,
    read_entries,
    read_givens,
    read_term,
)
from verify.wire.text.letters import letter_of, name_of, tex_of
from verify.wire.text.places import Places
from verify.wire.text.points import Points
from verify.wire.text.scope import Scope

if TYPE_CHECKING:
    from verify.language.argument import Chapter

#: What may stand in a page, and in its tables.
TOP = (
    *("title", "theorem", "group", "parameters", "cites", "assumptions", "let", "constants"),
    *("contexts", "rows", "chapters", "sets"),
)
CONSTANT = ("value", "letter", "tex", "label", "choose", "above")
VARIABLE = ("letter", "tex")
CONTEXT = (
    *("in", "says", "variables", "let", "given", "carried", "standing", "point"),
    *("constants", "rows", "root", "between", "states", "by"),
    *("gram", "products", "vectors", "granted_by", "label"),
)
GIVEN = ("claim", "kind", "assumption")
ROW = (
    *("claim", "applies", "at", "always", "start", "next", "in", "says", "role", "uses", "label"),
    *("group", "severity", "corrected_by", "by", "using"),
)
ASSUMPTION = ("sentence", "kind", "label")
CITE = ("theorem", "statement_sha256")

#: A function and its parameters, as ``Q(x, r)``.
_WORD = r"[A-Za-z][A-Za-z0-9_]*"
CALL = re.compile(rf"({_WORD})\(\s*({_WORD}(?:\s*,\s*{_WORD})*)\s*\)", re.ASCII)
#: So many rows are in a page, and names of rows, lemmas, givens and all else; so many constants,
#: abbreviations and functions, for each of which all known names are looked through.
MAX_ROWS, MAX_NAMES, MAX_DEFINED = 4000, 20_000, 4000
#: What is a name in files.
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.-]{0,99}", re.ASCII)


class Reader:
    """Reads one page."""

    def __init__(
        self,
        places: Places,
        cited: Sequence[Cite],
        stated: Mapping[str, Obligation],
        seconds: float | None,
    ) -> None:
        self.places, self.scope = places, Scope()
        self.cited, self.stated = cited, stated  # rows of another page
        self.taken: dict[str, str] = {"goal": "is a word of certificates"}
        self.contexts: dict[str, Context] = {}
        self.assumptions: dict[str, Assumption] = {}
        self.rows: dict[str, Obligation] = {}
        self.constants: list[Constant] = []
        self.sets: dict[str, str] = {}  # the role of the rows of each
        self.choices: dict[str, Choice] = {}
        self.hints: dict[str, Hint] = {}
        self.states: dict[str, dict[str, Mapping[str, Term]]] = {}
        self.premises: dict[str, tuple[str, ...]] = {}
        self.granted_by: str | None = None
        self.contexts_cited: dict[str, tuple[tuple[Variable, ...], str | None]] = {}
        self.functions: dict[str, tuple[str, ...]] = {}  # by their names, where they stand
        self.defined = 0  # how many constants, abbreviations and functions
        self.points = Points(seconds)
        self.floats: dict[str, float] = {}  # about what names stand for, to guess points

    # --- what stands under a key ----------------------------------------------------------------

    def table(self, keys: Sequence[str], value: object, known: Sequence[str] = ()) -> Any:
        """The table under some keys, which has no other keys than those that are known."""
        if not isinstance(value, dict):
            raise self.places.error(keys, f"{_told(value)} is no table; write key = value below it")
        for key in value if known else ():
            if key not in known:
                instead = nearest(key, known, f"write {', '.join(known)}")
                what = f"{shown(key)} is not known here; {instead}"
                raise self.places.error([*keys, key], what)
        return value

    def text(self, keys: Sequence[str], value: object, what: str = "a formula") -> str:
        """The text under some keys; a number is the text that it is written as."""
        if type(value) is int:
            return str(value)
        if not isinstance(value, str):
            raise self.places.error(keys, f'{_told(value)} is no text; write {what} in "quotes"')
        return value

    def texts(self, keys: Sequence[str], value: object) -> tuple[str, ...]:
        """The texts under some keys: a list of them, or one."""
        found = value if isinstance(value, list) else [value]
        return tuple(self.text(keys, one, "a name") for one in found)

    def name(self, keys: Sequence[str], name: str) -> str:
        """A name that is new."""
        self.plain(keys, name)
        if name in self.taken:
            raise self.places.error(keys, f"{shown(name)} {self.taken[name]}; choose another name")
        if len(self.taken) >= MAX_NAMES:
            raise self.places.error(keys, f"the page has more than {MAX_NAMES} names; split it")
        self.taken[name] = f"is already the name of {'.'.join(keys[:-1]) or 'something'}.{name}"
        return name

    def define(self, keys: Sequence[str]) -> None:
        """A name is defined, and there are not too many."""
        self.defined += 1
        if self.defined > MAX_DEFINED:
            raise self.places.error(
                keys, f"the page defines more than {MAX_DEFINED} names; split it"
            )

    def plain(self, keys: Sequence[str], name: str) -> str:
        """What may be a name."""
        if not NAME.fullmatch(name):
            raise self.places.error(
                keys, f"{shown(name)} is no name; write ASCII letters, digits, and _ . - between"
            )
        return name

    def term(self, keys: Sequence[str], value: object, names: Names) -> Term:
        """The term under some keys."""
        text = self.text(keys, value)
        return read_term(self.places.where(keys, text), text, names)

    def claims(self, keys: Sequence[str], value: object, names: Names) -> tuple[Claim, ...]:
        """The claims under some keys."""
        text = self.text(keys, value, "a claim")
        return read_claims(self.places.where(keys, text), text, names)

    def givens(self, keys: Sequence[str], value: object, home: str) -> tuple[Claim, ...]:
        """What is given under some keys, in a context."""
        text = self.text(keys, value, "a claim")
        return read_givens(self.places.where(keys, text), text, self.scope.inside(home))

    def values(self, keys: Sequence[str], value: object, names: Names) -> dict[str, Term]:
        """The terms under some keys: a table, or a text such as ``x = 1/2, y = a + b``."""
        found = value
        if isinstance(value, str):
            parts = [part.partition("=") for part in _at_commas(value)]
            found = {name.strip(): text for name, _, text in parts}
            if len(found) < len(parts) or not all(text.strip() for _, _, text in parts):
                raise self.places.error(keys, f'{_told(value)} is unclear; write "x = 1/2, y = 3"')
        found = self.table(keys, found)
        return {name: self.term([*keys, name], term, names) for name, term in found.items()}

    # --- the page -------------------------------------------------------------------------------

    def page(
        self, table: dict[str, Any], chapters: Callable[[Reader, object], tuple[Chapter, ...]]
    ) -> Page:
        """The whole page, whose chapters are read last."""
        self.table([], table, TOP)
        title = self.text(["title"], table.get("title", ""), "a title")
        if not title:
            raise self.places.error([], 'the title is missing; begin with title = "..."')
        theorem = self.text(["theorem"], table.get("theorem", title), "a name")
        self.group = self.text(["group"], table.get("group", ""), "a heading")
        cites = tuple(self._cites(table.get("cites", {})))
        self._assumptions(table.get("assumptions", {}))
        parameters = self._parameters(table.get("parameters", {}))
        self._sets(table.get("sets", {}))
        self._abbreviated(table.get("let", {}), table.get("constants", {}))
        for name, value in self.table(["contexts"], table.get("contexts", {})).items():
            self._context(name, value)
        self._rows(table)
        lines = chapters(self, table.get("chapters", []))
        if not any(row.role == NEEDED for row in self.rows.values()):
            raise self.places.error(
                ["rows"], 'there is no question; write below [rows] a line such as big = "x > 0"'
            )
        statement = Statement(
            theorem,
            title,
            parameters,
            tuple(sorted(self.constants, key=self._place)),
            tuple(self.contexts.values()),
            tuple(sorted(self.rows.values(), key=self._place)),
            tuple(self.assumptions.values()),
            cites,
        )
        self._known_rows()
        self._used_functions()
        return Page(statement, self.hints, chapters=lines, choices=self.choices)

    def _abbreviated(self, lets: Any, constants: Any) -> None:
        """Abbreviations and constants, of which each may stand for what is over the other ones."""
        late: dict[str, object] = {}
        if lets and constants:
            from verify.wire.text.late import split  # loaded only where it is used

            lets, late = split(lets, constants)
        self.let(["let"], lets, (None,))
        self.constants += self._constants(["constants"], constants, None)
        self.let(["let"], late, (None,))

    # --- sets -----------------------------------------------------------------------------------

    def _sets(self, value: object) -> None:
        """Sets of constants with the same rows: in the order in which they stand in the statement.

        A name that is written in a set is that of one of its constants, if it has such a one.
        """
        for name, role in self.table(["sets"], value).items():
            keys = ["sets", name]
            self.name(keys, name)
            self.sets[name] = self.one_of(keys, role, (PRINTED, NEEDED))
            self.scope.open(name, None)

    def _place(self, item: Constant | Obligation) -> int:
        """What is in no set stands first, then the sets one by one."""
        before = item.name.partition(".")[0]
        return 1 + list(self.sets).index(before) if before in self.sets else 0

    def placed(
        self, entries: Mapping[str, Any], homes: Sequence[str | None]
    ) -> Iterator[tuple[str, str, str | None]]:
        """The key of each entry, its name without that of a set, and the place that it is about.

        An entry whose name begins with that of a set is about this set, others about all places.
        """
        for key in entries:
            before, point, rest = key.partition(".")
            if point and before in self.sets:
                yield key, rest, before
            else:
                yield from ((key, key, home) for home in homes)

    def full(self, name: str, home: str | None) -> str:
        """The name in the statement of what is written in a place, which may be a set."""
        return f"{home}.{name}" if home in self.sets else name

    def _cites(self, value: object) -> Iterator[Cite]:
        for name, entry in self.table(["cites"], value).items():
            keys = ["cites", name]
            self.name(keys, name)
            wanted = entry if isinstance(entry, dict) else {"theorem": entry}
            self.table(keys, wanted, CITE)
            theorem = self.text(keys, wanted.get("theorem", ""), "the name of a theorem")
            found = self._cited(theorem, wanted.get("statement_sha256"))
            if found is None:
                known = ", ".join(cite.theorem for cite in self.cited) or "none"
                raise self.places.error(
                    keys,
                    f"no statement of the theorem {shown(theorem)} is in the folder cited beside "
                    f"this file, which has {known}; write its certificate there, as in "
                    f"verify prove ITS_PAGE --out cited/{name}",
                )
            cite = found._replace(name=name)
            self._names_of(cite)
            yield cite

    def _cited(self, theorem: str, digest: object) -> Cite | None:
        from hashlib import sha256  # loaded only where it is used

        for cite in self.cited:
            same = digest in (None, sha256(cite.content).hexdigest())
            if same and cite.theorem == theorem:
                return cite
        return None

    def _names_of(self, cite: Cite) -> None:
        """The names that a citation brings, with its own name before each."""
        import json  # loaded only where it is used

        document = json.loads(cite.content)
        for name in (*document["parameters"], *(c["name"] for c in document["constants"])):
            self.scope.add(f"{cite.name}:{name}", f"{cite.name}:{name}", None)
        for item in document["contexts"]:
            parent = item["parent"] and f"{cite.name}:{item['parent']}"
            context = f"{cite.name}:{item['name']}"
            self.scope.open(context, parent)
            variables = tuple(Variable(**variable) for variable in item["variables"])
            self.contexts_cited[context] = (variables, parent)
            for entry in (*item["variables"], *item["constants"]):
                full = f"{cite.name}:{entry['name']}"
                self.scope.add(full, full, context)
        for inner in cite.cites:
            self._names_of(inner._replace(name=f"{cite.name}:{inner.name}"))

    def _assumptions(self, value: object) -> None:
        for name, entry in self.table(["assumptions"], value).items():
            keys = ["assumptions", name]
            item = entry if isinstance(entry, dict) else {"sentence": entry}
            self.table(keys, item, ASSUMPTION)
            found = {key: self.text([*keys, key], text, "a sentence") for key, text in item.items()}
            if not found.get("sentence"):
                raise self.places.error(keys, 'its sentence is missing; write sentence = "..."')
            self.assumptions[name] = Assumption(
                name, found.get("label", ""), found["sentence"], found.get("kind", "assumption")
            )

    def _parameters(self, value: object) -> dict[str, Term]:
        found = {}
        for name, term in self.table(["parameters"], value).items():
            keys = ["parameters", name]
            self.name(keys, name)
            found[name] = self.term(keys, term, Names({}))
            self.scope.add(name, name, None)
            self.floats[name] = estimate(found[name], self.floats)
        return found

    def _constants(
        self, keys: Sequence[str], value: object, home: str | None, default: str = ""
    ) -> list[Constant]:
        return [
            self.constant([*keys, key], name_of(key), entry, home, default)
            for key, entry in self.table(keys, value).items()
        ]

    def constant(
        self, place: Sequence[str], key: str, entry: object, home: str | None, default: str = ""
    ) -> Constant:
        """A constant of a place: of the page, of a context, or of a set.

        One of a set has the letters and the label of an earlier one that is called the same.
        """
        self.define(place)
        item = entry if isinstance(entry, dict) else {"value": entry}
        self.table(place, item, CONSTANT)
        if "value" not in item:
            raise self.places.error(place, 'its value is missing; write value = "..."')
        where = [*place, "value"] if isinstance(entry, dict) else place
        term = self.term(where, item["value"], self.scope.inside(home))
        written = self._full(key, home)
        name = self._new(place, written, home)
        if home in self.sets:
            item = self._said_before(written) | item
        letter, tex = self._letters(place, item, written)
        label = self.text([*place, "label"], item.get("label", default), "a label")
        found = Constant(name, letter, tex, label, term)
        self._choice(place, item, found, home)
        self.scope.add(written, name, home)
        self.floats[name] = estimate(term, self.floats)
        return found

    def _said_before(self, written: str) -> dict[str, Any]:
        """What is said of an earlier constant that is called the same, without its set."""
        names = {written, *(f"{name}.{written}" for name in self.sets)}
        same = (c for c in self.constants if c.name in names)
        return next(({"letter": c.letter, "tex": c.tex, "label": c.label} for c in same), {})

    def _choice(
        self, place: Sequence[str], item: Mapping[str, Any], bound: Constant, home: str | None
    ) -> None:
        """Whether the value is a bound, on one side of which the constant may be chosen."""
        if "choose" not in item:
            if "above" in item:
                raise self.places.error([*place, "above"], 'write choose = "down", too')
            return
        if home is not None and home not in self.sets:
            what = "a constant of a context is not chosen; leave choose out"
            raise self.places.error([*place, "choose"], what)
        direction = self.one_of([*place, "choose"], item["choose"], ("down", "up"))
        base = None
        if "above" in item:
            base = self.term([*place, "above"], item["above"], self.scope.inside(home))
        self.choices[bound.name] = Choice(bound, direction, base)

    @staticmethod
    def _is_taken(name: str) -> str:
        return f"{shown(name)} stands for something else here already; choose another name"

    def _full(self, name: str, home: str | None) -> str:
        """A name; if it begins with a point, with the name of its context before it."""
        return f"{home}{name}" if home and name.startswith(".") else name

    def _new(self, keys: Sequence[str], written: str, home: str | None) -> str:
        """The name in the statement; one that another context has gets its context before it."""
        if written in self.scope.short[home]:
            raise self.places.error(keys, self._is_taken(written))
        elsewhere = any(
            written in names
            for place, names in self.scope.written.items()
            if place not in (*self.scope.chain(home),)
        )
        return self.name(keys, f"{home}.{written}" if elsewhere or home in self.sets else written)

    def _letters(
        self, keys: Sequence[str], item: Mapping[str, Any], written: str
    ) -> tuple[str, str]:
        plain, tex = letter_of(written)
        letter = self.text([*keys, "letter"], item.get("letter", plain), "a letter")
        if letter != plain:
            from verify.wire.text import instead  # loaded only where it is used

            if meant := instead.of_letter(letter, written):
                raise self.places.error(keys, meant)
        default = tex if letter == plain else tex_of(letter)
        return letter, self.text([*keys, "tex"], item.get("tex", default), "LaTeX")

    # --- contexts -------------------------------------------------------------------------------

    def _context(self, name: str, value: object) -> None:
        keys = ["contexts", name]
        table = self.table(keys, value, CONTEXT)
        self.name(keys, name)
        parent = self.around(keys, table, "an earlier one")
        self.scope.open(name, parent)
        if sum(1 for _ in self.scope.chain(name)) > MAX_NESTING + 1:
            raise self.places.error(keys, f"it is inside of {MAX_NESTING} contexts; join some")
        names = self._variables(keys, table, name)
        self.let([*keys, "let"], table.get("let", {}), (name,))
        if "gram" in table or "products" in table:
            self._vectors(keys, table, name)
        if "root" in table:
            self._root(keys, name, table, names)
            return
        givens = tuple(self._givens(keys, table, name))
        point = table.get("point")
        at = None if point is None else self._point(keys, point, names, parent)
        if at is None:
            new = [variable.name for variable in names.values()]
            around = [other for other, home in self.scope.homes.items() if home is not None]
            at = self.points.find(new, givens, self.floats, {*around} - {*new})
            if at is None:
                from verify.wire.text.no_point import why_no_point  # only where it is needed

                written, numbers = (
                    {k: v.name for k, v in names.items()},
                    (self.constants, self.floats),
                )
                why = why_no_point(name, written, givens, numbers, self.points.in_time)
                raise self.places.error(*why)
        self.floats |= {v: estimate(term, self.floats) for v, term in at.items()}
        label = self.text([*keys, "label"], table.get("label", ""), "a label")
        own = table.get("constants", {})
        constants = self._constants([*keys, "constants"], own, name, label)
        says = self.text([*keys, "says"], table.get("says", ""), "a sentence")
        variables = tuple(names.values())
        self.contexts[name] = Context(name, variables, givens, at, parent, says, tuple(constants))
        self._states(keys, table, self.contexts[name])
        if "by" in table:
            self.premises[name] = tuple(self.text([*keys, "by"], table["by"], "names").split())

    def _states(self, keys: Sequence[str], table: Mapping[str, Any], context: Context) -> None:
        """The states of a context: values of all its variables, under a name."""
        found = {"point": context.point}
        for state, values in self.table([*keys, "states"], table.get("states", {})).items():
            place = [*keys, "states", state]
            inside = self.scope.inside(context.name)
            at = self.values(place, values, inside)
            found[state] = self.complete(place, at, inside.known, context.variables)
        self.states[context.name] = found

    def _vectors(self, keys: Sequence[str], table: Mapping[str, Any], home: str) -> None:
        """The vectors of a context, of which the inner products of some are known."""
        kinds = [kind for kind in ("gram", "products") if kind in table]
        place, inside = [*keys, kinds[0]], self.scope.inside(home)
        if len(kinds) > 1:
            raise self.places.error(place, "products stand there, too; write one of the two")
        known = {
            name: [
                self.term([*place, name], text, inside)
                for text in _at_commas(self.text(place, row))
            ]
            for name, row in self.table(place, table[kinds[0]]).items()
        }
        vectors = self.table([*keys, "vectors"], table.get("vectors", {}))
        texts = {name: self.text([*keys, "vectors", name], text) for name, text in vectors.items()}
        try:
            from verify.wire.text.vectors import gram_of, products_of  # only where it is used

            gram = (gram_of if kinds == ["gram"] else products_of)(known)
        except ValueError as error:
            raise self.places.error(place, str(error)) from error
        for name in {name: None for pair in gram for name in pair} | texts:
            self.plain(place, name)
            if name in inside.known or name in inside.short:
                raise self.places.error(place, self._is_taken(name))
        self.scope.span(home, gram, texts)

    def let(self, keys: Sequence[str], value: object, homes: Sequence[str | None]) -> None:
        """Abbreviations, each of which is the term or table for which it stands; and functions."""
        entries = self.table(keys, value)
        for key, short, home in self.placed(entries, homes):
            place, body, inside = [*keys, key], entries[key], self.scope.inside(home)
            where = self.places.where(place, body)
            self.define(place)
            match = CALL.fullmatch(short)
            if match:
                names = tuple(name.strip() for name in match[2].split(","))
                self._new_function(place, match[1], names, home)
                function = PageFunction(where, names, body, inside)
                self.scope.define(match[1], function, home)
                continue
            name = self.plain(place, name_of(short))
            if name in self.scope.written[home] or name in self.scope.short[home]:
                raise self.places.error(place, self._is_taken(name))
            self.scope.abbreviate(name, read_entries(where, body, inside), home)

    def _new_function(
        self, keys: Sequence[str], name: str, parameters: Sequence[str], home: str | None
    ) -> None:
        """Afterwards the name is that of a function, and of no other one."""
        inside = self.scope.inside(home)
        if any(name in table for table in (CALLED, self.functions, inside.known, inside.short)):
            raise self.places.error(keys, f"{name} stands for something; choose another name")
        if len({*parameters}) < len(parameters):
            raise self.places.error(keys, "a parameter stands there twice; choose another name")
        self.functions[name] = tuple(keys)

    def _used_functions(self) -> None:
        """Afterwards each function is used, so that its formula was read."""
        for name in self.functions.keys() - self.scope.spent.used:
            raise self.places.error(self.functions[name], f"{name} is not used; leave it out")

    def _root(
        self, keys: Sequence[str], name: str, table: Mapping[str, Any], names: dict[str, Variable]
    ) -> None:
        """A context whose variable stands for a root, with rows that show that there is one."""
        for key in _NOT_AT_A_ROOT:
            if key in table:
                raise self.places.error(
                    [*keys, key], "a context with a root has none; leave it out"
                )
        between = table.get("between", ())
        place = [*keys, "between"]
        if not isinstance(between, list) or len(between) != 2 or len(names) != 1:
            raise self.places.error(
                keys, "a root has one variable, and two numbers; write between = [1, 2]"
            )
        inside = self.scope.inside(name)
        ends = [self.term(place, end, Names({})) for end in between]
        if any(end.op != "rational" for end in ends):
            raise self.places.error(place, "the two are no numbers; write between = [1, 2]")
        term = self.term([*keys, "root"], table["root"], inside)
        whole = f"{name}.range"
        self.name(keys, whole)
        self.scope.open(whole, None)
        ((written, variable),) = names.items()
        other = variable._replace(name=self.name(keys, f"{whole}.{written}"))
        self.scope.add(other.name, other.name, whole)
        from verify.wire.text.roots import about, isolated  # loaded only where they are used

        numbers, known = (ends[0].value, ends[1].value), about(term, self.constants, self.floats)
        try:
            found = isolated(name, (variable, other), term, numbers, known)
        except InputError as error:
            raise self.places.error([*keys, "root"], str(error)) from error
        says = self.text([*keys, "says"], table.get("says", found.context.says), "a sentence")
        self.contexts |= {name: found.context._replace(says=says), whole: found.range}
        for row in found.rows:
            self.name(keys, row.name)
            self.add(keys, row)
        self.floats[variable.name] = estimate(found.context.point[variable.name], {})

    def around(
        self, keys: Sequence[str], table: Mapping[str, Any], wanted: str = "one of the page"
    ) -> str | None:
        """The context that a table says it is in; None if it says nothing."""
        if "in" not in table:
            return None
        place = [*keys, "in"]
        name = self.text(place, table["in"], "the name of a context")
        if name not in self.contexts:
            raise self.places.error(place, self.no_context(name, wanted))
        return name

    def no_context(self, name: object, wanted: str = "one of the page") -> str:
        """What is wrong with the name of a context that there is not, and what to write."""
        known = ", ".join(self.contexts) or "none"
        instead = nearest(str(name), self.contexts, f"write {wanted}; there is {known}")
        return f"{_told(name)} is no context; {instead}"

    def _variables(
        self, keys: Sequence[str], table: Mapping[str, Any], home: str
    ) -> dict[str, Variable]:
        """The variables by the names that the page writes."""
        point = table.get("point")
        entry = table.get("variables", [*point] if isinstance(point, dict) else [])
        place = [*keys, "variables"]
        if isinstance(entry, str):
            parts = _at_commas(entry) if ":" in entry else entry.replace(",", " ").split()
            pairs = [[_unquoted(part.strip()) for part in text.split(":", 2)] for text in parts]
            self._are_different(place, [name for name, *_ in pairs])
            entry = {name: letters for name, *letters in pairs}
        if "variables" not in table and not entry:
            raise self.places.error(keys, 'it has no variables; write variables = ["x"]')
        names = () if isinstance(entry, dict) else self.texts(place, entry)
        self._are_different(place, names)
        items = entry if isinstance(entry, dict) else {name: {} for name in names}
        found = {}
        for key, item in items.items():
            written = self._full(name_of(key), home)
            self.table([*place, key], _lettered(item), VARIABLE)
            name = self._new([*place, written], written, home)
            letters = self._letters([*place, written], _lettered(item), written)
            found[written] = Variable(name, *letters)
            self.scope.add(written, name, home, is_variable=True)
        return found

    def _are_different(self, keys: Sequence[str], names: Sequence[str]) -> None:
        """Afterwards no variable stands there twice."""
        known: set[str] = set()
        for name in names:
            if name in known:
                raise self.places.error(keys, f"{shown(name)} stands there twice; leave one out")
            known.add(name)

    def _point(
        self, keys: Sequence[str], value: object, names: Mapping[str, Variable], parent: str | None
    ) -> dict[str, Term]:
        place = [*keys, "point"]
        found = self.values(place, value, self.scope.inside(parent))
        return self.complete(place, found, self.scope.inside(keys[-1]).known, names.values())

    def complete(
        self,
        keys: Sequence[str],
        found: Mapping[str, Term],
        known: Mapping[str, str],
        variables: Iterable[Variable],
    ) -> dict[str, Term]:
        """The values by the names that are meant: one for each variable, and for nothing else."""
        names, at = [variable.name for variable in variables], {}
        wanted = f"write values of {', '.join(names) or 'nothing'}"
        for written, term in found.items():
            name = known.get(written, written)
            if name not in names or name in at:
                what = "has two values" if name in at else "is no variable of the context"
                raise self.places.error(keys, f"{shown(written)} {what}; {wanted}")
            at[name] = term
        for name in names:
            if name not in at:
                raise self.places.error(keys, f"{shown(name)} has no value; {wanted}")
        return at

    def _givens(self, keys: Sequence[str], table: Mapping[str, Any], home: str) -> Iterator[Given]:
        count = 0
        granted_by = table.get("granted_by")
        if granted_by is not None:
            granted_by = self.text([*keys, "granted_by"], granted_by, "the name of an assumption")
        self.granted_by = granted_by
        for key, kind in (("given", "plain"), ("carried", "carried"), ("standing", "standing")):
            entry = table.get(key, [])
            place = [*keys, key]
            if isinstance(entry, str):
                entry = [entry]
            if isinstance(entry, dict):
                for name, item in entry.items():
                    yield from self._given([*place, name], name, item, kind, home)
                continue
            if not isinstance(entry, list):
                raise self.places.error(place, f'{_told(entry)} is no list; write ["0 <= x"]')
            for item in entry:
                for claim in self.givens(place, item, home):
                    count += 1
                    name = self.name([*place, f"{home}.{count}"], f"{home}.{count}")
                    granted = self.granted_by if kind == "standing" else None
                    yield self._of_kind(place, Given(name, claim, kind, granted))

    def _given(
        self, keys: Sequence[str], name: str, item: object, kind: str, home: str
    ) -> Iterator[Given]:
        entry = item if isinstance(item, dict) else {"claim": item}
        self.table(keys, entry, GIVEN)
        where = [*keys, "claim"] if isinstance(item, dict) else keys
        claims = self.givens(where, entry.get("claim", ""), home)
        kind = self.one_of([*keys, "kind"], entry.get("kind", kind), _KINDS)
        assumption = entry.get("assumption", self.granted_by if kind == "standing" else None)
        if assumption is not None:
            assumption = self.text([*keys, "assumption"], assumption, "a name")
        for new, claim in zip(_numbered(name, len(claims)), claims, strict=True):
            self.name(keys, new)
            yield self._of_kind(keys, Given(new, claim, kind, assumption))

    def _of_kind(self, keys: Sequence[str], given: Given) -> Given:
        """The given, which names an assumption if it is standing, and only then."""
        if given.kind == "standing" and given.assumption not in self.assumptions:
            raise self.places.error(
                keys,
                "a standing given needs the assumption that grants it; write "
                'NAME = { claim = "...", assumption = "..." }, with a name of [assumptions]',
            )
        if given.kind != "standing" and given.assumption is not None:
            raise self.places.error(keys, "only a standing given has an assumption; leave it out")
        return given

    def one_of(self, keys: Sequence[str], value: object, known: Sequence[str]) -> str:
        """The value, which is one of those that are known."""
        if value not in known:
            raise self.places.error(keys, f"{_told(value)} is unknown; write {', '.join(known)}")
        return str(value)

    # --- rows -----------------------------------------------------------------------------------

    def _rows(self, table: Mapping[str, Any]) -> None:
        """All rows, in the order of the page."""
        for key, value in table.items():
            if key == "rows":
                for name, row in self.table(["rows"], value).items():
                    self._row(["rows", name], name, row)
            for context in value if key == "contexts" else ():
                keys = ["contexts", context, "rows"]
                for name, row in self.table(keys, value[context].get("rows", {})).items():
                    entry = row if isinstance(row, dict) else {"claim": row}
                    self._row([*keys, name], name, {"in": context} | entry)

    def _row(self, keys: Sequence[str], name: str, value: object) -> None:
        table = value if isinstance(value, dict) else {"claim": value}
        self.table(keys, table, ROW)
        kinds = [kind for kind in ("claim", "applies", "always") if kind in table]
        if len(kinds) != 1:
            what = "has no claim" if not kinds else f"has {' and '.join(kinds)}"
            raise self.places.error(keys, f'it {what}; write one claim = "..."')
        home = self.around(keys, table)
        where = [*keys, "claim"] if isinstance(value, dict) else keys
        claims: Sequence[Claim | Applies | Always]
        if kinds == ["claim"]:
            claims, home = self._compared(where, table["claim"], home)
        else:
            other, home = self._of_context(keys, table, home)
            claims = [other]
        fields = self.fields(keys, table)
        for new, claim in zip(_numbered(name, len(claims)), claims, strict=True):
            self.name(keys, new)
            self.add(keys, Obligation(name=new, claim=claim, context=home, **fields))
            self._hint(keys, new, table)

    def add(self, keys: Sequence[str], row: Obligation) -> None:
        """A row of the statement, in which there are not too many."""
        if len(self.rows) >= MAX_ROWS:
            raise self.places.error(keys, f"the page has more than {MAX_ROWS} rows; split it")
        self.rows[row.name] = row

    def _hint(self, keys: Sequence[str], row: str, table: Mapping[str, Any]) -> None:
        texts = self.texts([*keys, "by"], table.get("by", []))
        by = tuple(word for text in texts for word in text.split())
        using = None if "using" not in table else self.texts([*keys, "using"], table["using"])
        facts = self._facts_before(row) if by else []
        if by and all(word in facts for word in by):
            self.hints[row] = Hint((), (*by, *(using or ())), follows=True)
            return
        if by:
            from verify.prover.techniques import TECHNIQUES  # loaded only where it is used

            for text in texts:
                if not any(text in name for name in TECHNIQUES):
                    known = [*facts, *TECHNIQUES]
                    instead = nearest(text, known, "write names of givens and of earlier rows")
                    what = f"{shown(text)} is no fact before it, and no technique; {instead}"
                    raise self.places.error([*keys, "by"], what)
        if by or using is not None:
            self.hints[row] = Hint(texts, using)

    def _facts_before(self, row: str) -> list[str]:
        """The names of what is given, and of the rows before one."""
        givens = [given.name for context in self.contexts.values() for given in context.givens]
        rows = [*self.rows]
        return [*givens, *rows[: rows.index(row)]]

    def _compared(
        self, keys: Sequence[str], value: object, home: str | None
    ) -> tuple[Sequence[Claim], str | None]:
        """The claims of a row and their context, which the names in them have if none is given."""
        if home is not None:
            return self.claims(keys, value, self.scope.inside(home)), home
        claims = self.claims(keys, value, self.scope.anywhere())
        return claims, self._home(keys, [side for c in claims for side in (c.lhs, c.rhs)])

    def _home(self, keys: Sequence[str], terms: Sequence[Term]) -> str | None:
        try:
            return self.scope.home(list(names_of(*terms)))
        except ValueError as error:
            raise self.places.error(keys, f"{error}, of which none is inside the other") from error

    def _of_context(
        self, keys: Sequence[str], table: Mapping[str, Any], home: str | None
    ) -> tuple[Applies | Always, str | None]:
        kind = "applies" if "applies" in table else "always"
        context = self.text([*keys, kind], table[kind], "the name of a context")
        if context in self.contexts:
            variables, parent = self.contexts[context].variables, self.contexts[context].parent
        elif context in self.contexts_cited:
            variables, parent = self.contexts_cited[context]
        else:
            raise self.places.error([*keys, kind], self.no_context(context))
        if kind == "always":
            home = home or parent
            start = self.at(keys, "start", table, variables, self.scope.inside(home))
            after = self.at(keys, "next", table, variables, self.scope.inside(context))
            return Always(context, start, after), home
        names = self.scope.inside(home) if home else self.scope.anywhere()
        at = self.at(keys, "at", table, variables, names)
        return Applies(context, at), home or self._home(keys, [*at.values()])

    def at(
        self,
        keys: Sequence[str],
        key: str,
        table: Mapping[str, Any],
        variables: Sequence[Variable],
        names: Names,
    ) -> dict[str, Term]:
        """The values of the variables of a context, which may be one that is cited."""
        found = self.values([*keys, key], table.get(key, {}), names)
        full = [v._replace(name=v.name.rpartition(":")[2]) for v in variables]
        short = {v.name.rpartition(".")[2]: v.name for v in full} | {v.name: v.name for v in full}
        return self.complete([*keys, key], found, short, full)

    def fields(self, keys: Sequence[str], table: Mapping[str, Any]) -> dict[str, Any]:
        """What is said of a row beside its claim."""
        uses = self.texts([*keys, "uses"], table.get("uses", []))
        for name in uses:
            if name not in self.assumptions:
                instead = nearest(name, self.assumptions, "write it below [assumptions]")
                raise self.places.error(
                    [*keys, "uses"], f"{shown(name)} is no assumption; {instead}"
                )
        severity = table.get("severity")
        if severity is not None:
            self.text([*keys, "severity"], severity, "a text")
        role = self.one_of([*keys, "role"], table.get("role", NEEDED), (NEEDED, PRINTED))
        found = {
            key: self.text([*keys, key], table.get(key, default), "a text")
            for key, default in (("group", self.group), ("label", ""), ("says", ""))
        }
        corrected = table.get("corrected_by")
        return found | {
            "role": role,
            "uses": uses,
            "severity": severity,
            "corrected_by": None if corrected is None else self.text(keys, corrected, "a name"),
        }

    def _known_rows(self) -> None:
        """Afterwards the hints name what stands before their rows."""
        for row, hint in self.hints.items():
            earlier = self._facts_before(row)
            for name in hint.using or ():
                if name not in earlier:
                    instead = nearest(name, earlier, "write names of givens, or of rows before it")
                    what = f"{shown(name)} is no given, and no earlier row; {instead}"
                    raise self.places.error(["rows", row, "using"], what)


_KINDS = ("plain", "carried", "standing")
#: What a context with a root has not.
_NOT_AT_A_ROOT = (
    *("in", "given", "carried", "standing", "granted_by", "point", "constants", "states", "by"),
    *("gram", "products", "vectors"),
)


def _numbered(name: str, count: int) -> list[str]:
    """The names of claims that one text has: its name, or with a number behind it."""
    return [name] if count == 1 else [f"{name}.{i}" for i in range(1, count + 1)]


def _lettered(item: object) -> Any:
    """What is said of a variable: its letter, its letter and that in LaTeX, or a table of them."""
    if isinstance(item, str):
        return {"letter": item}
    return dict(zip(VARIABLE, item, strict=False)) if isinstance(item, list) else item


def _unquoted(text: str) -> str:
    """A text without the quotation marks around it, in which spaces at its ends count."""
    return text[1:-1] if len(text) > 1 and text[0] == text[-1] == '"' else text


def _at_commas(text: str) -> list[str]:
    """The parts of a text between commas that stand outside of parentheses and braces."""
    parts, depth, start = [], 0, 0
    for at, sign in enumerate(text):
        depth += (sign in "({") - (sign in ")}")
        if sign == "," and depth == 0:
            parts.append(text[start:at])
            start = at + 1
    return [*parts, text[start:]]


def _told(value: object) -> str:
    return shown(value if isinstance(value, str) else repr(value))
