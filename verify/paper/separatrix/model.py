"""The limit map in terms, and what a state just after a collision has as its image.

q is the paper's φ₁, u stands for φ₂: u(2-u) = 2 φ₂ |W_c|². With a = (1+r)/2 (-cos θ) and the ratio
rho = |W_s|²/|W_c|², which becomes sigma = 1/rho at the next collision,

    p = a(1-u) - q - rho u,   x = r(1-u)/p,   v(2-v) p² = rho u (2q + rho u),   0 ≤ v < 1

is the image (x, v) of (q, u). There is one if p > 0 and rho u (2q + rho u) < p².
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import ByRoot, Defined, Item, Line, identity, power, proof
from verify.language.record import Record
from verify.language.statement import Assumption, Constant
from verify.language.terms import Claim, Term, equal, sqrt, symbol
from verify.paper.letters import Letters

LABEL = "SSSCT3.4.2LineaZhou-Kadan"
#: The paper's second condition for the Zhou-Kadanoff regime.
THRESHOLD = "EQUATSS3.4ZKCl2CondiStabi"

LIMIT_MAP, UNENDING = "limit-map", "unending"

DEFINITIONS = (
    Assumption(LIMIT_MAP, LABEL,
         "The limit map takes a state (q, u), q ≥ 0 and 0 ≤ u < 1, with the ratio ρ, to (x, v), "
         "where p = a(1-u) - q - ρu, x = r(1-u)/p and v = 1 - √(1 - ρu(2q+ρu)/p²), if p > 0 and "
         "ρu(2q+ρu) < p²; else the collisions end there. The ratio is ρ and σ = 1/ρ in turn. K is "
         "the set of the states with u > 0 whose collisions never end, and f(q) is the supremum "
         "of all u for which (q, u) is in K, or 0.", "definition"),
    Assumption(UNENDING, LABEL,
         "What is said of sequences is said of orbits that go on: in falls that of (Q, U), in "
         "grows and climbs that of (q, u); and climbs is about orbits with q < s² throughout.",
         "definition"),
)  # fmt: skip


def constants_of(letters: Letters) -> dict[str, Claim]:
    """What every context knows of r and a."""
    return {"r": 0 < letters.r, "r-one": letters.r < 1, "a": 0 < letters.a}


class State(Record):
    """A state in a context, with the names by which its image is known there."""

    r: Term
    a: Term
    rho: Term
    q: Term
    u: Term
    x: Term
    v: Term

    @property
    def p(self) -> Term:
        """The factor by which the closing speed shrinks."""
        return self.a * (1 - self.u) - self.q - self.rho * self.u

    @property
    def top(self) -> Term:
        """What has to be less than p²."""
        return self.rho * self.u * (2 * self.q + self.rho * self.u)

    @property
    def root(self) -> Term:
        """1 - v."""
        return sqrt(1 - self.top / self.p**2)

    def goes_on(self) -> dict[str, Claim]:
        """The condition for a next collision."""
        return {"p": 0 < self.p, "meets": self.top < self.p**2}

    def leads_to(self, x: Term, v: Term) -> dict[str, Claim]:
        """That there is one, and that the image lies below (x, v); the last two without roots."""
        return {
            "p": 0 < self.p,
            "x": self.r * (1 - self.u) <= x * self.p,
            "top": self.top <= v * (2 - v) * self.p**2,
        }

    def constants(self) -> tuple[Constant, ...]:
        """The image, for the context of the state."""
        terms = (self.x, self.r * (1 - self.u) / self.p), (self.v, 1 - self.root)
        return tuple(
            Constant(x.name, letter := x.name.rpartition(".")[2], letter, LABEL, term)
            for x, term in terms
        )


def state(letters: Letters, outer: Letters, names: str = "q u x v") -> State:
    """The state whose numbers have these names in a context; the last two are its constants.

    The other context has r, a and the ratio.
    """
    q, u, x, v = names.split()
    image = (symbol(letters.full(name)) for name in (x, v))
    return State(outer.r, outer.a, outer.rho, getattr(letters, q), getattr(letters, u), *image)


class Names:
    """The names of facts by what they say: those of a context begin with its name."""

    def __init__(self, prefix: str, **others: str) -> None:
        self.prefix, self.others = prefix, others

    def __getattr__(self, role: str) -> str:
        """The name of a fact; an underscore in the role stands for a hyphen."""
        return self.others.get(role, f"{self.prefix}-{role.replace('_', '-')}")


def image(of: State, positive: str, meets: str) -> Iterator[Item]:
    """The image has a value where there is one: its equations, and v < 1."""
    x, v = of.x.name, of.v.name
    radicand = of.root.children[0]
    yield from (
        Line(f"{v}-square", 0 < of.p**2, proof(power(positive, 2))),
        Line(f"{v}-radicand", 0 < radicand, proof(meets)),
        Line(f"{v}-root", 0 < of.root, ByRoot()),
        Defined(x),
        Defined(v),
        Line(f"{x}-equation", equal(of.x * of.p, of.r * (1 - of.u)), identity(using=x)),
        Line(f"{v}-equation", equal((1 - of.v) ** 2 * of.p**2, of.p**2 - of.top),
             identity(using=v)),
        Line(f"{v}-one", of.v < 1, proof(f"{v}-root", using=v)),
    )  # fmt: skip
