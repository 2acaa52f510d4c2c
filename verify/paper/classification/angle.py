"""A collision with a third ball at a right or an acute angle never brings a pair together.

By the law of collision such a collision adds (J/m) times the cosine of the angle to rho.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Chapter, Line, Opened, proof, times
from verify.paper.classification.settings import Letters

a = Letters("acute", J="J", m="m", cosine="e_ab·e_ak", rho="ρ_ab")


def chapters() -> Iterator[Chapter]:
    """Where the angle at the ball that is hit is at most a right one."""
    context = a.opened(
        "a ball a collides with k, with the impulse J; e_ab and e_ak make at most a right angle",
        "1 1 0 0",
        {"impulse": 0 < a.J, "mass": 0 < a.m, "angle": 0 <= a.cosine},
    )
    yield Chapter(None, (Opened(context),))
    line = Line("acute-keeps", a.rho <= a.rho + a.J / a.m * a.cosine,
                proof(times("acute-impulse", "acute-angle")), "DEFINSS2.1DecmpVitesNrmTg",
                "a collision of a with k at which the angle at a is at most a right one lowers "
                "ρ_ab never")  # fmt: skip
    yield Chapter(a.context, (line,))
