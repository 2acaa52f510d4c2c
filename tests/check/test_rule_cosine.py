"""``cosine``: the partial sums of the series lie above and below, in turn."""

from __future__ import annotations

import pytest

from tests.check.support import COSINE, Json, Pair, box, cuts, term, total, verdict
from verify import check

SIDE = "on the wrong side"
TERMS = "found a bound on the other side"
FORM = "expected <= between"


def written(claim: Json) -> Json:
    """The claim, in which a negative quotient of whole numbers is a rational number."""
    match term(claim):
        case ["div", str(a), str(b)] if b.isdigit() and a[0] == "-":
            return f"{a}/{b}"
        case [op, *parts]:
            return [op, *map(written, parts)]
        case other:
            return other


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        ("cos(x) <= 1", "proved"),
        ("cos(x) <= 2", "proved"),
        ("cos_pi(x) <= 1", "proved"),
        ("cos(3) <= 1", "proved"),
        ("cos(x*y - 1) <= 1", "proved"),
        ("1 + x**2*(-1/2) <= cos(x)", "proved"),
        ("1 + x**2*-1 <= cos(x)", "proved"),
        ("cos(x) <= 1 + x**2*(-1/2 + x**2*(1/24))", "proved"),
        ("1 + x**2*(-1/2 + x**2*(1/24 + x**2*(-1/720))) <= cos(x)", "proved"),
        ("1 + x**2*(-494/100) <= cos_pi(x)", "proved"),
        ("p*(31/10 + p**2*(-52/10)) <= cos_pi(1/2 - p)", "proved"),
        ("cos_pi(1/2 - p) <= p*(22/7)", "proved"),
        ("cos_pi(1/2 - q) <= q*(22/7)", "proved"),
        ("cos(x) <= 999/1000", SIDE),
        ("cos(x) < 1", FORM),
        ("cos(x) = 1", FORM),
        ("1 <= cos(x)", TERMS),
        ("1 + x**2*(-1/2 + x**2*(1/24)) <= cos(x)", TERMS),
        ("cos(x) <= 1 + x**2*(-1/2)", TERMS),
        ("1 + x**2*(-49/100) <= cos(x)", SIDE),
        ("1001/1000 + x**2*(-1/2) <= cos(x)", SIDE),
        ("cos(x) <= 1 + x**2*(-51/100 + x**2*(1/24))", SIDE),
        ("cos(x) <= 1 + x**2*(-1/2 + x**2*(1/25))", SIDE),
        ("1 + x**2*(-1/2 + x**2*(1/24 + x**2*(-1/721))) <= cos(x)", SIDE),
        ("1 + x**2*(-493/100) <= cos_pi(x)", SIDE),
        ("1 + x**2*(-1/2) <= cos_pi(x)", SIDE),
        ("1 + y**2*(-1/2) <= cos(x)", "found no square of the angle"),
        ("1 + x**3*(-1/2) <= cos(x)", "found no square of the angle"),
        ("1 + x*(-1/2) <= cos(x)", "found no square of the angle"),
        ("1 + (-1/2)*x**2 <= cos(x)", "found no square of the angle"),
        ("1 + x**2 <= cos(x)", "found pow, expected mul"),
        ("x**2*(-1/2) + 1 <= cos(x)", "REFUSED"),
        ("1 + x**2*y <= cos(x)", "found a coefficient that is no number"),
        ("y <= cos(x)", "found a coefficient that is no number"),
        ("x <= 1", FORM),
        ("sqrt(p) <= 1", FORM),
        ("x*(3 + x**2*-6) <= cos_pi(1/2 - x)", "not known to be >= 0"),
        ("cos_pi(1/2 - p) <= p*3", SIDE),
        ("cos_pi(1/2 - p) <= p*(-22/7)", SIDE),
        ("p*(3 + p**2*-5) <= cos_pi(1/2 - p)", SIDE),
        ("p*3 <= cos_pi(1/2 - p)", TERMS),
        ("p*(3 + p**2*-6) <= cos_pi(p - 1/2)", "expected u times a polynomial"),
        ("p*(3 + p**2*-6) <= cos_pi(1/3 - p)", "expected u times a polynomial"),
        ("p*(3 + p**2*-6) <= cos_pi(1/2 - q)", "expected u times a polynomial"),
        ("p*(3 + p**2*-6) <= cos_pi(p)", "found name, expected sub"),
        ("p*(3 + q**2*-6) <= cos_pi(1/2 - p)", "found no square of the angle"),
        ("p*(1/2 + p**2*-6) <= cos(1/2 - p)", "REFUSED"),
        ("cos(1/x) <= 1", "a division by a term"),
        ("cos(sqrt(x)) <= 1", "the root of a term"),
        ("cos_pi(1/2 - sqrt(x)) <= sqrt(x)*4", "the root of a term"),
    ],
)
def test_cosine(claim: str, reason: str) -> None:
    """Each coefficient has its side; so has the number of terms."""
    pair = Pair().context(
        "c", {"x": "0", "y": "1", "p": "2", "q": "1"}, {"p-low": "0 <= p", "q-pos": "0 < q"}
    )
    assert reason in verdict(pair.row("row", written(claim), COSINE, "c"))


def test_the_sign_of_an_angle_is_that_of_its_branch() -> None:
    claim = "cos_pi(1/2 - x) <= x*4"
    pair = box(("-1", "1")).row("row", claim, cuts("x", ["0"], COSINE, COSINE), "box")
    assert "not known to be >= 0" in verdict(pair)  # and false
    pair = box(("0", "1")).row("row", claim, COSINE, "box")
    assert verdict(pair) == "proved"


def test_a_hypothesis_tells_the_sign() -> None:
    """The context says 1/8 <= x, which is another claim than the branch's 0 <= x."""
    claim, none = "cos_pi(1/2 - x) <= x*4", total("x-low", "@1", "1/8")
    pair = box(("1/8", "1")).row("row", claim, cuts("x", ["0"], none, COSINE), "box")
    assert verdict(pair) == "proved"
    pair = box(("1/8", "1")).row("row", claim, COSINE, "box")
    assert "not known to be >= 0" in verdict(pair)


def test_coefficients_have_128_bits() -> None:
    """Those of pi^2 / 2: the bound of 128 bits is one, and a closer one is not."""
    lows = []
    for bits in (127, 128, 129):
        scope = check.Enclosing(check.Kernel(), bits, None)
        y = scope.pi()
        half = scope.div(scope.mul(y, y), scope.rational(2, 1))
        lows.append(scope.outward(scope.neg(half)).low)
    assert lows[0] < lows[1] < lows[2]
    for low, reason in zip(lows, ("proved", "proved", SIDE), strict=True):
        claim = ["<=", ["add", "1", ["mul", ["pow", "x", "2"], str(low)]], ["cos_pi", "x"]]
        assert reason in verdict(box(("0", "1")).row("row", claim, COSINE, "box"))


def test_many_coefficients() -> None:
    """Forty terms are no more work than a file may ask for; the last one decides the side."""
    bound = "1"
    for k in range(41):
        bound = f"{1 if k % 2 else -1} + x**2*({bound})"
    claim = f"cos(x) <= 1 + x**2*({bound})"
    assert SIDE in verdict(box(("0", "1")).row("row", written(claim), COSINE, "box"))
