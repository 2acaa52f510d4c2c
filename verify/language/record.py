"""Records: tuples whose entries have names; and what annotations need, for all modules.

They are what `typing.NamedTuple` makes, and a type checker is told so. That compiles a constructor
for each class; the program has some fifty classes, and a process that decides one point would
spend more time on making them than on all its intervals.
"""

from __future__ import annotations

from operator import itemgetter
from types import GenericAlias

#: False when the program runs: it does not load `typing`, of which names below take the place.
TYPE_CHECKING = False

__all__ = ["TYPE_CHECKING", "Annotated", "Any", "Protocol", "Record", "TypeVar"]

if TYPE_CHECKING:
    from typing import Annotated, Any, Protocol, TypeVar
    from typing import NamedTuple as Record
else:
    Any = Protocol = object
    TypeVar = lambda name, **_bound: name  # noqa: E731
    #: A type with what is told of it, which `verify.prover.proof` reads.
    Annotated = type("Annotated", (), {"__class_getitem__": classmethod(GenericAlias)})

    class _Fields(type):
        """Makes the annotations in the body of a class the names of the entries, in that order.

        A class that only adds methods to a record has the entries of that record.
        """

        def __new__(cls, name, bases, body):
            if "__annotations__" not in body and any(hasattr(base, "_fields") for base in bases):
                return super().__new__(cls, name, bases, body | {"__slots__": ()})
            fields = tuple(body.get("__annotations__", ()))
            defaults = {field: body[field] for field in fields if field in body}
            body |= {"_last": tuple(defaults.values())}
            body |= {f: property(itemgetter(i), doc="An entry.") for i, f in enumerate(fields)}
            body |= {"_fields": fields, "_field_defaults": defaults, "__match_args__": fields}
            return super().__new__(cls, name, bases, body | {"__slots__": ()})

    class Record(tuple, metaclass=_Fields):
        """A tuple whose entries have the names, and the defaults, of the annotations."""

        def __new__(cls, *values, **named):
            """The entries in their order, or by their names; the others by default."""
            missing = len(cls._fields) - len(values)
            if named or not 0 <= missing <= len(cls._last):
                values = cls._complete(values, named)
            elif missing:
                values += cls._last[-missing:]
            return tuple.__new__(cls, values)

        @classmethod
        def _complete(cls, values, named):
            defaults, rest = cls._field_defaults, cls._fields[len(values) :]
            try:
                found = [named.pop(f) if f in named else defaults[f] for f in rest]
            except KeyError as error:
                raise TypeError(f"{cls.__name__}: {error} is missing") from None
            if named or len(values) > len(cls._fields):
                raise TypeError(f"{cls.__name__} has just the entries {', '.join(cls._fields)}")
            return (*values, *found)

        @classmethod
        def _make(cls, values):
            return cls(*values)

        def _replace(self, **changed):
            values = [changed.pop(f, value) for f, value in zip(self._fields, self, strict=True)]
            return type(self)(*values, **changed)

        def _asdict(self):
            return dict(zip(self._fields, self, strict=True))

        def __getnewargs__(self):
            return tuple(self)

        def __repr__(self):
            entries = (f"{field}={value!r}" for field, value in self._asdict().items())
            return f"{type(self).__name__}({', '.join(entries)})"
