"""The vectors of `verify.paper.dynamics`, under their former name."""

from verify.paper.dynamics.vectors import Combination, add, scale

__all__ = ["Combination", "add", "scale"]
