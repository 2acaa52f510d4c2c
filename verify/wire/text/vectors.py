"""Vectors of which only inner products are known: `dot(x, z)` in a formula is a term.

    [contexts.state]
    gram = { omega = "1, -y", W = "A" }

    [contexts.state.vectors]
    next = "(1 + d)*omega + tau*W"

The rows of ``gram`` are the upper triangle of the Gram matrix: each vector times itself and those
after it. Other vectors are combinations of these. Nothing is multiplied out but the sums.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from verify.language.terms import Term, as_term

Combination = Mapping[str, Term]
#: The inner products of vectors, each pair in the order of the rows.
Gram = Mapping[tuple[str, str], Term]


def gram_of(rows: Mapping[str, Sequence[Term]]) -> Gram:
    """The inner products in the rows of an upper triangle.

    Raises:
        ValueError: if a row is too long or too short.
    """
    names = list(rows)
    found: dict[tuple[str, str], Term] = {}
    for number, (name, row) in enumerate(rows.items()):
        others = names[number:]
        if len(others) != len(row):
            raise ValueError(f"the row of {name} has {len(row)} products, and not {len(others)}")
        found |= {(name, other): term for other, term in zip(others, row, strict=True)}
    return found


def dot(gram: Gram, x: Combination, z: Combination) -> Term:
    """The inner product of two combinations."""
    total: Term | None = None
    names = list(dict.fromkeys(name for name, _ in gram))
    for i in names:
        for j in names:
            if i in x and j in z:
                known = gram[(i, j) if (i, j) in gram else (j, i)]
                part = _times(_times(x[i], z[j]), known)
                total = part if total is None else total + part
    return as_term(0) if total is None else total


def combination(term: Term, vectors: Mapping[str, Combination]) -> Combination:
    """The combination that a term over vectors is.

    Raises:
        ValueError: for a product of vectors, a quotient by one, and a sum with a number.
    """
    op, args = term.op, term.children
    if op == "symbol" and term.name in vectors:
        return vectors[term.name]
    if op in ("add", "sub"):
        x, z = (combination(part, vectors) for part in args)
        return _sum(x, z if op == "add" else _scaled(as_term(-1), z))
    if op == "neg":
        return _scaled(as_term(-1), combination(args[0], vectors))
    if op == "mul":
        scalars = [not _is_vector(part, vectors) for part in args]
        if scalars == [True, False]:
            return _scaled(args[0], combination(args[1], vectors))
        if scalars == [False, True]:
            return _scaled(args[1], combination(args[0], vectors))
    if op == "div" and not _is_vector(args[1], vectors):
        return {name: x / args[1] for name, x in combination(args[0], vectors).items()}
    raise ValueError("is no combination of vectors; write for example omega + tau*W")


def basis(name: str) -> Combination:
    """One of the vectors whose inner products are known."""
    return {name: as_term(1)}


def _is_vector(term: Term, vectors: Mapping[str, Combination]) -> bool:
    if term.op == "symbol":
        return term.name in vectors
    return any(_is_vector(part, vectors) for part in term.children)


def _scaled(number: Term, x: Combination) -> Combination:
    return {name: _times(number, value) for name, value in x.items()}


def _sum(x: Combination, z: Combination) -> Combination:
    total = dict(x)
    for name, value in z.items():
        total[name] = total[name] + value if name in total else value
    return total


def _times(x: Term, z: Term) -> Term:
    one = as_term(1)
    return z if x is one else x if z is one else x * z
