"""Vectors of which only inner products are known: `dot(x, z)` in a formula is a term.

    [contexts.state]
    gram = { omega = "1, -y", W = "A" }

    [contexts.state.vectors]
    next = "(1 + d)*omega + tau*W"

The rows of ``gram`` are the upper triangle of the Gram matrix: each vector times itself and those
after it. Other vectors are combinations of these. Nothing is multiplied out but the sums.

    [contexts.collision.products]
    "e e" = "1"
    "e v" = "rho"

Where only some inner products are known, ``products`` lists them pair by pair. Then each summand of
``dot(x, z)`` is the coefficient in x, that in z and the product, in the order in which the vectors
are written; a factor 1 is written, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from verify.language.terms import Term, as_term

Combination = Mapping[str, Term]
#: The inner products of vectors, each pair in the order of the rows.
Gram = Mapping[tuple[str, str], Term]


class Products(dict[tuple[str, str], Term]):
    """Those of some pairs only."""


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


def products_of(table: Mapping[str, Sequence[Term]]) -> Products:
    """The inner products of the pairs of vectors that stand before them, with a space between.

    Raises:
        ValueError: for anything else than a pair, and for one that stands there twice.
    """
    found = Products()
    for pair, terms in table.items():
        names = tuple(pair.split())
        if len(names) != 2 or len(terms) != 1:
            raise ValueError(f'{pair!r} is no pair of vectors; write for example "e v" = "rho"')
        if names[::-1] in found:
            raise ValueError(f"the product of {pair!r} stands there twice")
        found[names[0], names[1]] = terms[0]
    return found


def dot(gram: Gram, x: Combination, z: Combination) -> Term:
    """The inner product of two combinations.

    Raises:
        ValueError: if a product that it needs is not among those that are listed.
    """
    if isinstance(gram, Products):
        return _written_out(gram, x, z)
    total: Term | None = None
    names = list(dict.fromkeys(name for name, _ in gram))
    for i in names:
        for j in names:
            if i in x and j in z:
                known = gram[(i, j) if (i, j) in gram else (j, i)]
                part = _times(_times(x[i], z[j]), known)
                total = part if total is None else total + part
    return as_term(0) if total is None else total


def _written_out(products: Products, x: Combination, z: Combination) -> Term:
    total: Term | None = None
    for i, p in x.items():
        for j, q in z.items():
            known = products.get((i, j), products.get((j, i)))
            if known is None:
                raise ValueError(f"the product of {i} and {j} is not known; write it in products")
            part = p * q * known
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
