"""What a scene needs of the theorems on one collision: the names in them.

These are `verify/paper/flow.toml` for equal spheres, and `flow_of_balls.toml` for others.
"""

from __future__ import annotations

#: The theorems, and their contexts.
FLOW, FLOW_OF_BALLS = "flow", "flow-of-balls"
#: A collision while another pair is in contact: its theorem, and the context there.
TOUCHING = "touching"
COLLISION, RECENTRE, DRIFT = "collision", "recentre", "drift"
PAIRS, UNIT = "pairs", "unit"
#: Those of pairs that do not collide any more.
PARTING, PASSING = "parting", "passing"

#: The numbers of the next state that have names of their own there.
NAMED = {
    COLLISION: ("lam", "eps", "A", "B", "C", "a", "b", "w"),
    RECENTRE: ("lam", "rho", "eps", "sig", "A", "C", "a", "b", "w"),
    DRIFT: ("lam", "rho", "eps", "sig", "C", "a", "b"),
}

#: How people read the numbers of a state and of a flight.
LETTERS = {
    "v": ("v", "v"),
    "lam": ("λ", r"\lambda"),
    "rho": ("ρ", r"\rho"),
    "eps": ("ε", r"\varepsilon"),
    "sig": ("σ", r"\sigma"),
    "A": ("A", "A"),
    "B": ("B", "B"),
    "C": ("C", "C"),
    "a": ("a", "a"),
    "b": ("b", "b"),
    "w": ("w", "w"),
    "y": ("y", "y"),
    "q": ("q", "q"),
    "kap": ("κ", r"\kappa"),
    "s": ("s", "s"),
    "T": ("T", "T"),
    "time": ("t", "t"),
    "R2": ("R²", "R^2"),
    "virial": ("A", "A"),
    "L2": ("L²", "L^2"),
}
