"""A statement as a page of constants, which `read_page` reads as the same statement."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from hashlib import sha256
from typing import Any

from verify.language.statement import (
    NEEDED,
    Always,
    Applies,
    Assumption,
    Constant,
    Context,
    Given,
    Obligation,
    Statement,
    Variable,
)
from verify.language.terms import Claim, Term, names_of, signs_in
from verify.wire.inputs import InputError
from verify.wire.text.letters import letter_of, tex_of
from verify.wire.text.written import claim_text, term_text
from verify.wire.write import statement_terms

#: Longer lists and tables get a line for each entry.
WIDTH = 100
#: About so many signs the terms of a page have at most.
MAX_SIGNS = 1 << 20


def page_text(statement: Statement) -> str:
    """The page, in the order in which it is read.

    Raises:
        InputError: if shared parts of terms, which have no names in a page, would make it too long.
    """
    if sum(map(signs_in, statement_terms(statement))) > MAX_SIGNS:
        raise InputError(
            "a page of this statement would be too long, as its terms share parts that a page "
            "writes out; make constants of these parts"
        )
    return "\n".join(_lines(statement)).strip() + "\n"


def _lines(statement: Statement) -> Iterator[str]:
    yield f"title = {_text(statement.title)}"
    if statement.theorem != statement.title:
        yield f"theorem = {_text(statement.theorem)}"
    cites = {
        cite.name: {"theorem": cite.theorem, "statement_sha256": sha256(cite.content).hexdigest()}
        for cite in statement.cites
    }
    yield from _table("cites", cites)
    yield from _table("assumptions", {a.name: _assumption(a) for a in statement.assumptions})
    parameters = {name: term_text(term) for name, term in statement.parameters.items()}
    yield from _table("parameters", parameters)
    yield from _table("constants", {c.name: _constant(c) for c in statement.constants})
    for context in statement.contexts:
        yield from _context(context)
    homes = _homes(statement)
    parents = {context.name: context.parent for context in statement.contexts}
    rows = {row.name: _row(row, homes, parents) for row in statement.obligations}
    yield from _table("rows", rows)


def _table(name: str, entries: Mapping[str, Any], *, always: bool = False) -> Iterator[str]:
    if entries or always:
        yield ""
        yield f"[{name}]"
        yield from (f"{_key(key)} = {_value(value)}" for key, value in entries.items())


def _key(name: str) -> str:
    return name if re.fullmatch(r"[A-Za-z0-9_-]+", name, re.ASCII) else _text(name)


def _text(text: str) -> str:
    r"""A text in quotes, single ones if it has a backslash and may have them."""
    if "\\" in text and "'" not in text and text.isprintable():
        return f"'{text}'"
    signs = {'"': '\\"', "\\": "\\\\", "\n": "\\n", "\t": "\\t", "\r": "\\r"}
    return '"' + "".join(signs.get(sign) or _sign(sign) for sign in text) + '"'


def _sign(sign: str) -> str:
    return sign if sign.isprintable() else f"\\U{ord(sign):08x}"


def _value(value: Any) -> str:
    if isinstance(value, str):
        return _text(value)
    if isinstance(value, dict):
        return f"{{ {', '.join(f'{_key(k)} = {_value(v)}' for k, v in value.items())} }}"
    texts = [_value(item) for item in value]
    line = f"[{', '.join(texts)}]"
    return line if len(line) <= WIDTH else "[\n" + "".join(f"  {text},\n" for text in texts) + "]"


def _short(entry: dict[str, Any], key: str) -> Any:
    """The entry, or what stands under its only key."""
    return entry[key] if entry.keys() == {key} else entry


def _assumption(assumption: Assumption) -> Any:
    entry = {"sentence": assumption.sentence}
    if assumption.kind != "assumption":
        entry["kind"] = assumption.kind
    if assumption.label:
        entry["label"] = assumption.label
    return _short(entry, "sentence")


def _letters(item: Constant | Variable) -> dict[str, str]:
    plain, tex = letter_of(item.name)
    found = {} if item.letter == plain else {"letter": item.letter}
    default = tex_of(item.letter) if found else tex
    return found if item.tex == default else found | {"tex": item.tex}


def _constant(constant: Constant) -> Any:
    entry = {"value": term_text(constant.term), **_letters(constant)}
    return _short(entry | ({"label": constant.label} if constant.label else {}), "value")


def _context(context: Context) -> Iterator[str]:
    entries: dict[str, Any] = {}
    if context.parent is not None:
        entries["in"] = context.parent
    if context.says:
        entries["says"] = context.says
    letters = {v.name: _letters(v) for v in context.variables}
    entries["variables"] = letters if any(letters.values()) else list(letters)
    if context.givens:
        entries |= _givens(context)
    entries["point"] = {name: term_text(term) for name, term in context.point.items()}
    key = f"contexts.{_key(context.name)}"
    yield from _table(key, entries)
    yield from _table(f"{key}.constants", {c.name: _constant(c) for c in context.constants})


def _givens(context: Context) -> dict[str, Any]:
    """The givens under the key that most of them need; a list if their names are those of one."""
    claims = [(given, claim_text(given.claim)) for given in context.givens]
    for key, kind in (("given", "plain"), ("carried", "carried")):
        if all(given.kind == kind and given.assumption is None for given in context.givens):
            numbered = [f"{context.name}.{i}" for i in range(1, len(claims) + 1)]
            if [given.name for given in context.givens] == numbered:
                return {key: [text for _, text in claims]}
            return {key: {given.name: text for given, text in claims}}
    return {"given": {given.name: _given(given, text) for given, text in claims}}


def _given(given: Given, text: str) -> Any:
    entry = {"claim": text}
    if given.kind != "plain":
        entry["kind"] = given.kind
    if given.assumption is not None:
        entry["assumption"] = given.assumption
    return _short(entry, "claim")


# --- rows ----------------------------------------------------------------------------------------


def _homes(statement: Statement) -> dict[str, str]:
    """The context of each name that is in one."""
    found: dict[str, str] = {}
    for context in statement.contexts:
        found |= {variable.name: context.name for variable in context.variables}
        found |= {constant.name: context.name for constant in context.constants}
    return found


def _row(row: Obligation, homes: Mapping[str, str], parents: Mapping[str, str | None]) -> Any:
    entry: dict[str, Any]
    home: str | None
    if isinstance(row.claim, Claim):
        entry = {"claim": claim_text(row.claim)}
        home = _innermost((row.claim.lhs, row.claim.rhs), homes, parents)
    elif isinstance(row.claim, Applies):
        entry = {"applies": row.claim.context, "at": _values(row.claim.at)}
        home = _innermost(row.claim.at.values(), homes, parents)
    else:
        entry = _always(row.claim)
        home = parents.get(row.claim.context)
    if row.context != home:
        entry["in"] = row.context
    fields = (
        ("says", ""),
        ("role", NEEDED),
        ("uses", ()),
        ("label", ""),
        ("group", ""),
        ("severity", None),
        ("corrected_by", None),
    )
    for name, default in fields:
        value = getattr(row, name)
        if value != default:
            entry[name] = value
    return _short(entry, "claim")


def _always(claim: Always) -> dict[str, Any]:
    return {"always": claim.context, "start": _values(claim.start), "next": _values(claim.next)}


def _values(values: Mapping[str, Term]) -> dict[str, str]:
    return {name: term_text(term) for name, term in values.items()}


def _innermost(
    terms: Iterable[Term], homes: Mapping[str, str], parents: Mapping[str, str | None]
) -> str | None:
    """The innermost context of the names in terms."""
    found = [homes[name] for name in names_of(*terms) if name in homes]
    depth: Callable[[str], int] = lambda name: _depth(name, parents)  # noqa: E731
    return max(found, key=depth, default=None)


def _depth(name: str | None, parents: Mapping[str, str | None]) -> int:
    return 0 if name is None else 1 + _depth(parents[name], parents)
