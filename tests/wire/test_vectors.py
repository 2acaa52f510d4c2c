"""Inner products in pages: what is known of vectors, and what `dot` is then."""

from __future__ import annotations

import pytest

from verify.language.terms import Claim, Term, symbol
from verify.wire.inputs import InputError
from verify.wire.text.read_page import read_page

a, b = symbol("a"), symbol("b")
PAGE = """
title = "vectors"

[contexts.c]
variables = "a b"
point = "a = 1, b = 2"
{known}

[contexts.c.vectors]
w = "e + a*v"

[[chapters]]
in = "c"

[chapters.rows]
row = {{ claim = "{claim} = 0", says = "?", by = "" }}
"""
GRAM = 'gram = { e = "1, a", v = "b" }'
PRODUCTS = 'products = { "e e" = "1", "v v" = "b" }'
#: With the product that the other two leave out.
ALL = 'products = { "v e" = "a", "e e" = "1", "v v" = "b" }'


def left(known: str, term: str) -> Term:
    page = read_page("p.toml", PAGE.format(known=known, claim=term).encode())
    (row,) = page.statement.obligations
    assert isinstance(row.claim, Claim)
    return row.claim.lhs


def test_a_gram_matrix_leaves_out_factors_1() -> None:
    """The summands are in the order of its rows."""
    assert left(GRAM, "dot(w, e)") == left(GRAM, "1 + a*a")
    assert left(GRAM, "dot(v, e)") == left(GRAM, "dot(e, v)") == a


def test_listed_products_are_written_in_full() -> None:
    """The summands are in the order in which the vectors are written, and every factor stands."""
    assert left(ALL, "dot(w, e)") == left(ALL, "1*1*1 + a*1*a")
    assert left(ALL, "dot(v, e + v)") == left(ALL, "1*1*a + 1*1*b")
    assert left(ALL, "dot(v + e, e - v)") == left(ALL, "1*1*a + 1*(-1)*b + 1*1*1 + 1*(-1)*a")
    assert left(PRODUCTS, "dot(2*v, v)") == left(PRODUCTS, "2*1*b")


def test_a_letter_that_numbers_terms_is_known_in_a_product_of_vectors() -> None:
    assert left(GRAM, "sum(dot(k*v, v), k, 1, 2)") == left(GRAM, "b + 2*b")
    assert left(GRAM, "sum(dot(e*v, v), e, 1, 2)") == left(GRAM, "b + 2*b")


@pytest.mark.parametrize(
    ("known", "term", "told"),
    [
        (PRODUCTS, "dot(w, v)", "the product of e and v is not known"),
        (PRODUCTS, "dot(e, v)", "the product of e and v is not known"),
        (f"{GRAM}\n{PRODUCTS}", "1", "write one of the two"),
        ('products = { e = "1" }', "1", "is no pair"),
        ('products = { "e v w" = "1" }', "1", "is no pair"),
        ('products = { "e v" = "1, a" }', "1", "is no pair"),
        ('products = { "e v" = "a", "v e" = "a" }', "1", "stands there twice"),
        ('gram = { e = "1", v = "b" }', "1", "has 1 products, and not 2"),
        ('gram = { "δ" = "1" }', "1", "is no name"),
        ('gram = { a = "1" }', "1", "stands for something else here already"),
    ],
)
def test_what_is_not_known_is_refused_by_name(known: str, term: str, told: str) -> None:
    with pytest.raises(InputError, match=told):
        left(known, term)
