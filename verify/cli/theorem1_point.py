"""A point of Theorem 1 as options give it: what is meant where nothing is said, exact terms."""

from __future__ import annotations

from verify.cli.options import Options
from verify.language.terms import Term, as_term
from verify.spheres.parameters import angle, neg_cos, restitution
from verify.wire.inputs import InputError, positive

#: What options have that are not given.
DEFAULTS = {
    "delta_theta": "1/10",
    "V0": "1",
    "constants": "all",
    "precision": "128",
    "max_precision": "65536",
    "jobs": "1",
}
#: The options that only a single point has.
POINT_OPTIONS = ("theta0", "precision", "max_precision")


def read_parameters(options: Options) -> dict[str, Term]:
    """The parameters as exact terms.

    Raises:
        InputError: for a number outside its range, or two angles.
    """
    if options.theta0 is not None and options.neg_cos is not None:
        raise InputError("--theta0 and --neg-cos both give the angle; write only one of them")
    r = restitution(options.r)
    if options.theta0 is not None:
        c = angle("--theta0", options.theta0)
    else:
        c = as_term(neg_cos("1" if options.neg_cos is None else options.neg_cos))
    return {
        "r": as_term(r),
        "c": c,
        "V_0": as_term(positive("--V0", options.V0)),
        "delta_theta": as_term(positive("--delta-theta", options.delta_theta)),
    }
