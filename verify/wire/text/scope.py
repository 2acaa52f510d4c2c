"""The names that the formulas of a page may use, and what each means where."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from verify.language.record import TYPE_CHECKING
from verify.wire.text.infix import Names, PageFunction
from verify.wire.text.matrices import Spent, Value

if TYPE_CHECKING:
    from verify.wire.text.vectors import Gram


class _Elsewhere(Mapping[str, str]):
    """Why a name of another context cannot be used here."""

    def __init__(self, homes: Mapping[str, str | None], known: Mapping[str, str]) -> None:
        self._homes, self._known = homes, known

    def __getitem__(self, written: str) -> str:
        if written in self._known:
            raise KeyError(written)
        home = self._homes[written]
        return f'is a name of the context {home}; write in = "{home}"'

    def __iter__(self) -> Iterator[str]:
        return (written for written in self._homes if written not in self._known)

    def __len__(self) -> int:
        return sum(1 for _ in self)


class Scope:
    """The names that formulas may use: each as it is written, and what it means where."""

    def __init__(self) -> None:
        self.homes: dict[str, str | None] = {}
        #: The variables (true), and the constants in which there are none.
        self.are_variables: dict[str, bool] = {}
        self.parents: dict[str, str | None] = {}
        self.written: dict[str | None, dict[str, str]] = {None: {}}
        self.elsewhere: dict[str, str | None] = {}
        self.short: dict[str | None, dict[str, Value]] = {None: {}}
        self.functions: dict[str | None, dict[str, PageFunction]] = {None: {}}
        self.vectors: dict[str | None, dict[str, str | None]] = {}
        self.grams: dict[str | None, Gram] = {}
        self.spent = Spent()
        self._inside: dict[str | None, Names] = {}

    def add(self, written: str, name: str, home: str | None, *, is_variable: bool = False) -> None:
        """A name that may be written in a context, and inside of it."""
        self._inside.clear()
        if is_variable or home is None:
            self.are_variables[name] = is_variable
        self.homes[name] = home
        self.written[home][written] = name
        self.elsewhere[written] = home

    def abbreviate(self, written: str, value: Value, home: str | None) -> None:
        """A name that stands for a term or a table in a context, and inside of it."""
        self._inside.clear()
        self.short[home][written] = value

    def define(self, written: str, function: PageFunction, home: str | None) -> None:
        """A function in a context, and inside of it."""
        self._inside.clear()
        self.functions[home][written] = function

    def open(self, context: str, parent: str | None) -> None:
        """A context, inside of another."""
        self._inside.clear()
        self.parents[context], self.written[context], self.short[context] = parent, {}, {}
        self.functions[context] = {}

    def chain(self, context: str | None) -> Iterator[str | None]:
        """A context and those around it."""
        while context is not None:
            yield context
            context = self.parents[context]
        yield None

    def inside(self, context: str | None) -> Names:
        """What is known in a context; of names of other contexts is said that they are those."""
        if context not in self._inside:
            self._inside[context] = self._known_inside(context)
        return self._inside[context]

    def _known_inside(self, context: str | None) -> Names:
        known: dict[str, str] = {}
        short: dict[str, Value] = {}
        functions: dict[str, PageFunction] = {}
        for place in self.chain(context):
            short = {n: t for n, t in self.short[place].items() if n not in known} | short
            known = {n: w for n, w in self.written[place].items() if n not in short} | known
            functions = self.functions[place] | functions
        known |= {name: name for name in known.values()}
        known = self._without_context(context) | known
        hidden = _Elsewhere(self.elsewhere, known)
        place = next((home for home in self.chain(context) if home in self.grams), None)
        vectors, gram = self.vectors.get(place, {}), self.grams.get(place, {})
        others = (vectors, gram, functions, self.spent, self.are_variables)
        return Names(known, hidden, short, *others)

    def span(self, home: str, gram: Gram, vectors: Mapping[str, str]) -> None:
        """Vectors of a context, some by their inner products, others as combinations of these."""
        self._inside.clear()
        self.grams[home] = gram
        self.vectors[home] = {name: None for pair in gram for name in pair} | dict(vectors)

    def _without_context(self, context: str | None) -> dict[str, str]:
        """In a context ``ball`` one may write ``x`` for ``ball.x``, where nothing else is ``x``."""
        found: dict[str, str] = {}
        for place in self.chain(context):
            before = f"{place}."
            own = self.written[place].values() if place else ()
            found = {n.removeprefix(before): n for n in own if n.startswith(before)} | found
        return found

    def anywhere(self) -> Names:
        """What is known if the context is to be found by the names."""
        known: dict[str, str] = {}
        twice: dict[str, str] = {}
        for home, names in self.written.items():
            for written, name in names.items():
                other = known.setdefault(written, name)
                if other != name:
                    first = self.homes[other]
                    where = f'say in which by in = "{first}", or the other one'
                    twice[written] = f"is a name of the context {first} and of {home}; {where}"
        for written in self.short[None].keys() & known.keys():
            home = self.homes[known[written]]
            where = f'write in = "{home}" if that is meant, or another name for the term'
            twice[written] = f"stands for a term, and is a name of the context {home}; {where}"
        known = {name: name for name in self.homes} | known
        one = {key: name for key, name in known.items() if key not in twice}
        short = {key: term for key, term in self.short[None].items() if key not in twice}
        return Names(
            one,
            twice,
            short,
            functions=self.functions[None],
            spent=self.spent,
            are_variables=self.are_variables,
        )

    def home(self, names: Sequence[str]) -> str | None:
        """The innermost context of names.

        Raises:
            ValueError: if no context is inside of all others.
        """
        homes = list(dict.fromkeys(self.homes.get(name) for name in names))
        for home in homes:
            if {*homes} <= {*self.chain(home)}:
                return home
        if not homes:
            return None
        places = [str(home) for home in homes if home is not None]
        raise ValueError(f"its names are of the contexts {' and '.join(places)}")
