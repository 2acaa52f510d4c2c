"""What the options of Theorem 1 mean where nothing is said."""

from __future__ import annotations

from verify.spheres.parameters import DEFAULTS as OF_POINT

#: What options have that are not given.
DEFAULTS = {
    **OF_POINT,
    "constants": "all",
    "precision": "128",
    "max_precision": "65536",
    "jobs": "1",
}
#: The options that only a single point has.
POINT_OPTIONS = ("theta0", "precision", "max_precision")
