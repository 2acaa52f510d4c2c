"""The rules of the kernel, on the side that searches: each is written here, and only here.

A class has the proofs by one rule; its fields are those of the certificate. The first sentence of
its docstring is what the rule says, the rest is the law, which whoever writes a checker reads in
`certificates/README.md`. That page and the JSON schema are made from this file, by
``python docs/generated.py``; proofs are written, read and explained from it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction

from verify.language.record import Annotated, Any, Record, TypeVar
from verify.language.terms import Claim, Term
from verify.prover.proof import Bits, Fact, Name, Premise, Proof, Side, Value


class Rule(Record):
    """What is known of a rule besides the class of its proofs.

    ``says`` has the proof in words, with fields in braces, and ``shown`` the field whose proofs are
    shown below, with what each is called. ``stands`` tells where such proofs may stand: in any
    ``proof``, or only for a ``definition``, for a row with ``applies`` or ``always``, or for a
    refuted row, as a ``witness``.
    """

    name: str
    says: str
    examples: tuple[str, ...]
    shown: tuple[str, str] | None
    stands: str


#: The rules by the classes of their proofs, in the order of the law.
RULES: dict[Any, Rule] = {}

_Class = TypeVar("_Class", bound=type[Any])


def _rule(
    name: str,
    says: str,
    examples: str = "",
    shown: tuple[str, str] | None = None,
    stands: str = "proof",
) -> Callable[[_Class], _Class]:
    """Makes a class that of the proofs by a rule; an example is called as its rule by default."""

    def register(proofs: _Class) -> _Class:
        RULES[proofs] = Rule(name, says, tuple((examples or name).split()), shown, stands)
        return proofs

    return register


# --- enclosures ----------------------------------------------------------------------------------


@_rule("interval", says="by enclosures of both sides with {bits} bits")
class Interval(Record):
    """The enclosures of the two sides, evaluated with ``bits`` bits, decide.

    the two sides are evaluated with intervals, and for all numbers in these the relation holds: for
    < the left one ends before the right one begins, for <= not after; for = both are the same
    single point; for ≠ they are disjoint. `bounds` is a list of `[name, lower, upper]`, each for a
    variable or a constant of a context, none twice. `lower` is a usable fact `t < name` or `t <=
    name`, `upper` one `name < t` or `name <= t`, and an equation with the name on either side may
    serve as both; t is enclosed with the bounds before. Constants without bounds get the interval
    of their definition, variables need bounds. *Sound, since* operations on intervals enclose the
    results for all numbers in them, and a division by an interval with 0, a root of one that
    reaches below 0, or a logarithm of one that reaches 0, is refused.

    The operations are exact on rational ends (`mul` takes the least and greatest product of ends;
    `pow` is by repeated squaring with the same rounding between, and even powers are ≥ 0), and each
    result is rounded outward: a lower end n/d whose n and d have together more than 2·bits binary
    digits becomes ⌊2^s n/d⌋/2^s with s = bits - len(n) + len(d). The root of n/d lies between
    ⌊R⌋/(2^bits d) and ⌈R⌉/(2^bits d), with R² = 4^bits n d; an n-th root likewise, with R^n = 2^(n
    bits) n d^(n-1). cos(x) is cos_pi(x/π), sin(x) is cos_pi(1/2 - x/π), and cos_pi is computed at
    both ends by Taylor's formula with an enclosure of π, but exact at multiples of 1/2, and is ±1
    at integers between. exp, log and atan rise, so they are computed at both ends, by series with
    bounds of what is left out, and they are exact at exp(0), log(1) and atan(0). An exponential of
    more than 2^16 is refused, and one of less than -2^16 lies between 0 and 2^-65536. A second
    implementation may round in other ways; certificates should leave room for that.
    """

    bits: Bits
    bounds: tuple[tuple[Name, Fact, Fact], ...] = ()


@_rule(
    "mean_value",
    says="by enclosures with {bits} bits: right - left at {at}, and on the box the derivative\n"
    "for each of these variables, times how far it is from there",
    examples="mean-value",
)
class MeanValue(Record):
    """On a box the value at a point, and for each variable a slope times its change, decide.

    proves < or <=, with bits and bounds as in `interval`, but bounds of variables only. They make a
    box, the product of the intervals of these variables. `at` has for some of them, all variables
    of the context itself, a number c in the interval. On the box h = `["sub", rhs, lhs]` is
    enclosed, and for each variable x in `at` its derivative D by x, as in `derivative` below. And h
    is enclosed where each x in `at` is its c and the others have their intervals. The last
    interval, plus D times [low - c, high - c] for each x with the interval from low to high, has to
    lie above 0 for <, and not to reach below it for <=. *Sound, since* all values in scope lie in
    the box, h and D are defined on all of it, and D is the derivative of h: so from c to these
    values, one variable after the other, each step changes h by a value of D on the box times x -
    c, by the mean value theorem. If D has a sign on the box, c is best the end at which h is least.
    *Why:* `interval` does not see that what occurs twice is the same, so that it may need a hundred
    times as many parts of a box.
    """

    bits: Bits
    bounds: tuple[tuple[Name, Fact, Fact], ...]
    at: Mapping[str, Fraction]


@_rule("cuts", says="in {branches} cases, for {term}", shown=("branches", "case"))
class Cuts(Record):
    """A term lies between neighbouring cuts: one branch for each piece.

    `at` lists rationals q1 < … < qk, and there are k + 1 branches, proofs of the same claim with
    the additional hypotheses `term <= q1`; `q1 <= term`, `term <= q2`; …; `qk <= term`, in this
    order. The term has to clear. *Sound, since* each value of the term lies in one of these pieces.
    """

    term: Term
    at: Annotated[tuple[Fraction, ...], 1]
    branches: Annotated[tuple[Proof, ...], 2]


# --- minima and maxima ---------------------------------------------------------------------------


@_rule(
    "cases",
    says="in {branches} cases, for {of}",
    examples="minimum maximum",
    shown=("branches", "case"),
)
class Cases(Record):
    """A minimum or maximum is one of its entries: one branch for each of them.

    `of` is a min (max) that clears, with a branch for each entry e: the hypotheses are `of = e`,
    then `e <= other` (`other <= e`) for the other entries in order. *Sound, since* a minimum is one
    of its entries, and none is less.
    """

    of: Term
    branches: tuple[Proof, ...]


@_rule(
    "entry",
    says="a minimum is at most each of its entries (a maximum at least)",
    examples="minimum maximum",
)
class Entry(Record):
    """A minimum is at most each of its entries, a maximum at least.

    proves `min <= e` (side `lhs`) or `e <= max` (side `rhs`), where e is an entry. Both sides have
    to clear. If `equation` is not null, it is a usable equation whose left side is that side of the
    claim, and whose right side, which has to clear, is the min or max.
    """

    side: Side
    equation: Fact | None = None


@_rule(
    "least",
    says="for each of {branches} entries",
    examples="minimum maximum",
    shown=("branches", "entry"),
)
class Least(Record):
    """What is below each entry is below their minimum; above each, above their maximum.

    proves `t < min` or `t <= min` (side `rhs`), or `max < t`, `max <= t` (side `lhs`), with a
    branch for each entry e: a proof of the same relation with e in place of the min or max. Both
    sides have to clear; `equation` is as before.
    """

    side: Side
    branches: tuple[Proof, ...]
    equation: Fact | None = None


# --- algebra -------------------------------------------------------------------------------------


@_rule("root", says="the root of a positive number is positive")
class Root(Record):
    """The root of a positive number is positive.

    proves `0 < sqrt(a)`, or `0 < root(a, n)`, if `0 < a` is usable.
    """


@_rule("antisymmetry", says="each side is at most the other", shown=("branches", "order"))
class Antisymmetry(Record):
    """Two numbers are equal, because each is at most the other.

    proves `a = b`, with a proof of `a <= b` and one of `b <= a`. *Why:* `sum` negates no equation,
    so that it cannot use signs to show one, as an equation of nested roots needs.
    """

    branches: tuple[Proof, Proof]


@_rule(
    "sum",
    says="if the claim failed, a positive number would be zero",
    examples="sum-transitivity sum-monotony sum-bernstein sum-identity sum-squaring",
)
class Sum(Record):
    """The negation of the claim would make a positive number zero.

    `using` lists usable equations whose left side is a name, min, max, root, `pi` or another
    function: wherever that atom occurs in what this proof clears, the right side takes its place,
    and so on within the right sides; each atom is replaced by one equation, and there must be no
    circle. Let G be the difference of lhs and rhs.

    - For =: `addends` is empty. `equations` lists pairs [equation, cofactor] of a usable equation
      and a term. G less the sum of the equations' differences times the N of the cleared cofactors
      has to reduce to the zero polynomial. *Sound, since* the differences of equations are 0.
    - For < and <=: assume the negation. Then G ≥ 0 (for <) or G > 0 (for <=). `addends` are
      *values*, below, each a polynomial that is then ≥ 0, and > 0 if the value is strict. The sum
      of the addends, plus the equations as above, has to reduce to the zero polynomial, and at
      least one addend has to be strict. *Sound, since* a positive number would be zero.

    | value | polynomial | strict |
    | --- | --- | --- |
    | `"goal"` | G | if the claim is <= |
    | a rational q ≥ 0 | q | if q > 0 |
    | the name (or `@k`) of a usable `a < b` or `a <= b` | the difference of b and a | if it is < |
    | `["root", t]` with t a `sqrt` or `root` | N of t | no |
    | `["square", t]` | N² of t | no |
    | `["add", v, ...]` | the sum | if one of them is |
    | `["mul", v, ...]` | the product | if all are |
    | `["pow", v, "k"]` | the k-th power | if v is |

    Cofactors and t are terms over the names in scope, and have to clear. The roots are cleared in
    this order: lhs, rhs; for each equation its cofactor, its lhs, its rhs; then the addends (of a
    fact `a < b` first b, then a).
    """

    addends: tuple[Value, ...] = ()
    using: tuple[Fact, ...] = ()
    equations: tuple[tuple[Fact, Term], ...] = ()


# --- functions -----------------------------------------------------------------------------------


@_rule("angles", says="2 cos u cos v = cos(u + v) + cos(u - v)")
class Angles(Record):
    """2 cos u cos v = cos (u + v) + cos (u - v), with the angles of the claim.

    proves `["=", ["mul", "2", ["mul", C(u), C(v)]], ["add", C(s), C(t)]]`, where C is `cos` or
    `cos_pi`. All angles have to clear, and the differences of u + v and s, and of u - v and t, have
    to reduce to the zero polynomial. *Sound, since* 2 cos u cos v = cos(u + v) + cos(u - v). *Why:*
    with cos_pi(1) = -1, which `interval` shows, all relations between cosines of multiples of an
    angle follow from it: cos(-x) = cos x with u = 0, cos(2x) = 2 cos²x - 1 with u = v.
    """


@_rule("cosine", says="a partial sum of the series of a cosine is on this side of it")
class Cosine(Record):
    """Partial sums of the series of a cosine are above it and below, in turn.

    proves `p <= C(u)` or `C(u) <= p`, where u clears and p is a rational c, or `["add", c, ["mul",
    ["pow", u, "2"], p']]` with p' of the same form: the polynomial with coefficients c0, c1, … in
    u². Also, for cos_pi(1/2 - u) = sin(πu), where `0 <= u` or `0 < u` is usable, the same with
    `["mul", u, p]` for p and `["cos_pi", ["sub", "1/2", u]]` for C(u). The series is 1 - y²/2! +
    y⁴/4! - …, for the sine y - y³/3! + …, with y = u for `cos` and y = πu for `cos_pi`. Each
    coefficient of a lower (upper) bound has to be at most (at least) that of the series, by
    intervals of 128 bits, and there is an even (odd) number of them. *Sound, since* the partial
    sums lie above and below in turn (integrate cos y ≤ 1 from 0, again and again), for all y, or
    for y ≥ 0 in the case of the sine; and since the powers of u that occur are ≥ 0. *Why:*
    enclosures do not show what holds with equality at 0, or on an unbounded range.
    """


@_rule("range", says="no value of the function is outside its range", examples="exponential")
class InRange(Record):
    """A value of an exponential, a sine, a cosine or an inverse tangent is in their range.

    proves `0 < exp(a)`; `-1 <= C(a)` or `C(a) <= 1`, where C is `cos`, `cos_pi` or `sin`; or
    `-(π/2) < atan(a)` or `atan(a) < π/2`, written `["neg", ["div", ["pi"], "2"]]` and `["div",
    ["pi"], "2"]`. a has to clear. *Why:* on an unbounded range no enclosure shows it.
    """


@_rule("law", says="this holds identically", examples="laws")
class Law(Record):
    """An identity of functions, such as exp (a + b) = exp a exp b.

    proves one of these equations, if both sides clear, and the condition beside it holds
    identically: the difference of its sides reduces to the zero polynomial.

    | equation | condition |
    | --- | --- |
    | `exp(log(a)) = a`, `log(exp(a)) = a` | |
    | `exp(s) = exp(a) exp(b)` | s = a + b |
    | `log(s) = log(a) + log(b)` | s = a b |
    | `sin(u)^2 + cos(v)^2 = 1` | u = v |
    | `sin(u) = cos(v)` | v = π/2 - u |
    | `cos(u) = cos_pi(v)` | u = π v |
    | `sin(atan(t)) = t cos(atan(t))` | |

    *Sound, since* a, b, s and a in `log` are > 0 where they clear, and the cosine of an inverse
    tangent is not 0.
    """


@_rule(
    "monotony",
    says="a function that rises keeps the order of its arguments",
    shown=("premise", "premise"),
)
class Monotony(Record):
    """A function that rises keeps the order; with ``under`` the order is read off from it.

    if `under` is null, proves f(a) R f(b) from a premise for a R b, where f is exp, log, atan,
    sqrt, or a root of the same index on both sides; for = also sin, cos or cos_pi. If `under` names
    a function f of `exp`, `log`, `atan`, `sqrt`, it proves a R b from a premise for f(a) R f(b).
    Both sides have to clear. *Sound, since* these functions rise.
    """

    premise: Premise
    under: Annotated[str | None, ("exp", "log", "atan", "sqrt", None)] = None


@_rule(
    "derivative",
    says="it holds at {variable} = {at}; from there to {variable}, which lies {side},\n"
    "right - left does not fall, because of its derivative {term}",
    shown=("sign", "its sign"),
)
class Derivative(Record):
    """What holds at a number still holds at a variable, as the derivative has a sign between.

    what holds at a number c (`at`) still holds at x (`variable`), as the derivative of rhs - lhs
    has a sign between them. x is a variable of the context itself. `term` is the derivative D of
    `["sub", rhs, lhs]` by x, as below. x must not occur in c; a name also has what occurs in its
    definition. Both sides and c have to clear. With `side` above, c lies below x. `start` is a
    premise for the claim at c (constants of the context are replaced by their definitions), `order`
    for c ≤ x, and `sign` for 0 ≤ D; with `side` below, for x ≤ c and D ≤ 0. Their relations are

    | claim | `strict` | `start` | `order` | `sign` |
    | --- | --- | --- | --- | --- |
    | <= | any | <= | <= | <= |
    | < | `start` | < | <= | <= |
    | < | `slope` | <= | < | < |
    | = | any | = | <= | = |

    Each given of the context, and each hypothesis, in which x occurs has to be `t < x`, `t <= x`,
    `x < t` or `x <= t` where x does not occur in t. `bounds` has a premise `t <= c` for each of the
    first two kinds (side above; in order, givens first), or `c <= t` for each of the last two (side
    below). *Sound, since* each number s strictly between c and x satisfies all givens and
    hypotheses, if the other variables keep their values: so D has its sign there, rhs - lhs is
    continuous from c to x, and the mean value theorem says that it changes by D(s) (x - c). *Why:*
    enclosures do not show what holds with equality at c, or on an unbounded range.

    The derivative D(t) of a term t in which x occurs is built like this and not otherwise. Here p·q
    is q if p is `1`, p if q is `1`, else `["mul", p, q]`; and t^1 is t. A subterm is *free* if x
    does not occur in it.

    | t | D(t) |
    | --- | --- |
    | x; a constant of the context | 1; D of its definition |
    | a + b | D(a) if b is free, D(b) if a is, else D(a) + D(b) |
    | a - b | D(a) if b is free, -D(b) if a is, else D(a) - D(b) |
    | -a | -D(a) |
    | a b | b·D(a) if b is free, a·D(b) if a is, else b·D(a) + a·D(b) |
    | a/b | D(a)/b if b is free, -((a·D(b))/b^2) if a is, else (b·D(a) - a·D(b))/b^2 |
    | a^k | D(a) if k = 1, else (`["mul", k, a^(k-1)]`)·D(a) |
    | sqrt(a), root(a, n) | D(a)/(`["mul", n, t^(n-1)]`), where n = 2 for sqrt |
    | exp(a), log(a), atan(a) | t·D(a), D(a)/a, D(a)/(1 + a^2) |
    | sin(a), cos(a) | cos(a)·D(a), -(sin(a)·D(a)) |
    | cos_pi(a) | -(`["mul", ["pi"], ["sin", ["mul", ["pi"], a]]]`·D(a)) |

    There is none of min and max.
    """

    variable: Name
    at: Term
    term: Term
    side: Annotated[str, ("above", "below")]
    strict: Annotated[str, ("start", "slope")]
    start: Premise
    order: Premise
    sign: Premise
    bounds: tuple[Premise, ...]


# --- on the way, and in other contexts -----------------------------------------------------------


@_rule("have", says="at first: {claim}", examples="derivative", shown=("branches", "step"))
class Have(Record):
    """A claim is shown at first, and is a hypothesis for what follows.

    there are two branches, a proof of `claim`, and one of the goal with `claim` as an additional
    hypothesis. *Why:* facts have no hypotheses, so that a branch has no other place for what it
    needs on the way.
    """

    claim: Claim
    branches: tuple[Proof, Proof]


@_rule("instance", says="{of} at {at}", examples="instance contexts mean-applied")
class Instance(Record):
    """What holds for all values that satisfy the givens holds for these.

    `of` is a fact of a context that is not the root. The place is inside the parent of that context
    (or is the parent). `at` has a term over the names at the place for each variable; they have to
    clear. They are put for the variables all at once, and constants of that context are replaced by
    their definitions, and so on. `givens` has a premise for each given so substituted, and the fact
    so substituted has to be the claim, as a term. *Sound, since* the fact holds for all values that
    satisfy the givens. For a row with `applies` the proof is `{rule, givens}`, with the table in
    the claim.
    """

    of: Name
    at: Mapping[str, Term]
    givens: tuple[Premise, ...]


@_rule(
    "instance", says="each of the {givens} givens holds", examples="mean-applied", stands="applies"
)
class Applying(Record):
    """The values in the claim itself satisfy the givens of its context."""

    givens: tuple[Premise, ...]


@_rule("define", says="each divisor and radicand has its sign", stands="definition")
class Define(Record):
    """A term has a value, because each divisor and radicand has a fact that shows its sign.

    in steps `constant` and `define` only. The definition clears. The other proof that such a step
    may have is `interval`.
    """


@_rule("witness", says="false at {at}", stands="witness")
class Witness(Record):
    """The claim is false at values that satisfy the givens; its negation there has a proof.

    for a refuted row only. `at` has a term over the names of the parent for each variable of the
    row's context, `givens` has premises as in `instance`, and `negation` is a proof, in the parent,
    of the negation of the claim at these terms, where = becomes ≠. *Sound, since* the parent has a
    point, and so there are such values.
    """

    at: Mapping[str, Term]
    givens: tuple[Premise, ...]
    negation: Proof


@_rule(
    "induction",
    says="by induction: each carried given holds at the start, and at the next state",
    examples="induction induction-standing",
    stands="always",
)
class Induction(Record):
    """What holds at the start and goes on holds always.

    for a row with `always` only. No given of that context is plain. `start` has a premise for each
    carried given at the start, in the row's context; `next` one for each carried given at the next
    state, in the context itself. The terms have to clear. *Sound* by induction on the step: the
    standing givens are part of the hypothesis of the claim, the carried ones hold at the start, and
    at each next state if all givens hold at this one.
    """

    start: tuple[Premise, ...]
    next: tuple[Premise, ...]


def rule_of(proof: Proof) -> str:
    """The name of the rule by which a proof shows its claim."""
    return RULES[type(proof)].name
