"""The second condition: a final angle below it stops all relative motion at a collapse.

In a run let y be the approach D (-eta_c) of the ball that is next over its contact distance, eta =
eta_s, u the closing speed of the next collision, and tau the time to it. While (1+r)/2 times
-cos theta times the distance over the contact distance is at most t + t^2, where t^3 < r, the
ratio eta/y passes t^2 and then stays above r/t; from then on tau/y grows by the factor r/t^3.
"""

from __future__ import annotations

from collections.abc import Iterator

from verify.language.argument import Chapter, Item, Line, Opened, plus, power, proof, scaled, times
from verify.language.terms import as_term
from verify.paper.classification.run import E, half, next_, tau, u_next, v
from verify.paper.letters import Letters

LABEL = "EQUATSS3.4ZKCl2CondiStabi"

c = Letters("cube", s="r^{1/3}", C="C")
n = Letters(
    "tail", r="r", t="t", y="y", eta="η_s", u="u", alpha="α", y_next="y'", tau="τ", tau_next="τ'"
)
a = n.t + n.t**2
low, high = Letters("low", r="r", t="t", q="q"), Letters("high", r="r", t="t", q="q")
grown = Letters("grown", r="r", t="t", q="q")


def chapters() -> Iterator[Chapter]:
    """What a run gives, and what follows for the ratios."""
    yield Chapter(v.context, tuple(_in_a_run()))
    cube = c.opened(
        "the cube root of r, and a cosine below the bound",
        "1/2 0",
        {
            "root": 0 < c.s,
            "size": 0 < 1 + c.s**3,
            "angle": c.C < 2 * c.s * (1 + c.s) / (1 + c.s**3),
        },
    )
    tail = n.opened(
        "two steps of a run in turn, with α ≤ t + t²",
        "1/5 1/2 1 1/10 1/2 1/2 1/10 1 1",
        {
            "r": 0 < n.r,
            "t": 0 < n.t,
            "t-most": n.t <= 1,
            "cube": n.t**3 < n.r,
            "approaches": 0 < n.y,
            "recedes": 0 < n.eta,
            "closes": 0 < n.u,
            "closing": n.u <= n.y,
            "next-approaches": 0 < n.y_next,
            "law": n.y_next <= n.alpha * n.u - n.eta,
            "bent": n.alpha <= a,
            "time": 0 < n.tau,
            "later": n.eta * n.tau <= n.y_next * n.tau_next,
        },
    )
    below = low.opened(
        "a ratio q ≤ t²",
        "1/5 1/2 1/10",
        {
            "t": 0 < low.t,
            "t-most": low.t <= 1,
            "cube": low.t**3 < low.r,
            "q": 0 <= low.q,
            "q-most": low.q <= low.t**2,
        },
    )
    above = high.opened(
        "a ratio q ≥ t² that is followed by another one",
        "1/5 1/2 2/5",
        {
            "r": 0 < high.r,
            "t": 0 < high.t,
            "q": high.t**2 <= high.q,
            "room": 0 < high.t + high.t**2 - high.q,
        },
    )
    larger = grown.opened(
        "a ratio q ≥ r/t that is followed by another one",
        "1/5 1/2 1/2",
        {
            "r": 0 < grown.r,
            "t": 0 < grown.t,
            "cube": grown.t**3 < grown.r,
            "q": grown.r <= grown.t * grown.q,
            "room": 0 < grown.t + grown.t**2 - grown.q,
        },
    )
    yield Chapter(None, (*map(Opened, (cube, tail, below, above, larger)),))
    small = Line("second-small", (1 + c.s**3) / 2 * c.C < c.s + c.s**2,
                 scaled(times(2, "goal"), "cube-angle"), LABEL,
                 "if -cos θ < 2r^{1/3}(1+r^{1/3})/(1+r), then (1+r)/2 (-cos θ) < t + t² for some t "
                 "with t³ < r")  # fmt: skip
    yield Chapter(c.context, (small,))
    yield Chapter(n.context, tuple(_ratio()))
    yield Chapter(low.context, tuple(_low()))
    yield Chapter(high.context, tuple(_high()))
    yield Chapter(grown.context, tuple(_grown()))


def _in_a_run() -> Iterator[Item]:
    """The law of approach, and two bounds of the times between collisions."""
    pulled = times("tau-positive", "speed-s-positive")
    yield from (
        Line("speed-s-positive", 0 < v.B, proof("run-cs-s", power("eta-positive", 2))),
        Line("second-law",     E * next_["y"] <= half * E * next_["C"] * u_next - v.s * v.eta,
             proof(pulled, equations=(("law-approach", as_term(-1)),)), LABEL,
             "y' ≤ α u - η_s, where α = (1+r)/2 (-cos θ') |x_s'|/σ_s", ("hard-spheres",)),
        Line("second-closing", v.c * u_next <= v.D * v.y,
             proof(times("run-contact-c", "tau-positive"), using="tau u_next"), LABEL, "u ≤ y"),
        Line("second-time",    v.D**2 - v.c**2 <= 2 * v.D * v.y * tau,
             proof(times("speed-positive", power("tau-positive", 2)),
                   equations=(("contact", as_term(-1)),)), LABEL,
             "|x_c|² - σ_c² ≤ 2 |x_c| (-η_c) τ"),
        Line("second-distance", 2 * v.s * v.eta * tau <= E**2 - v.s**2,
             proof(times("tau-positive", pulled), equations=(("path-s", as_term(1)),)), LABEL,
             "2 σ_s η_s τ ≤ |x_s'|² - σ_s²: so η_s τ ≤ y' τ'"),
        Line("second-speed",   v.A * tau <= v.D * v.y,
             proof(times("speed-positive", "S-positive"), using="tau"), LABEL, "|W_c|² τ/y ≤ σ_c"),
    )  # fmt: skip


def _ratio() -> Iterator[Item]:
    """Of q = eta_s/y and sigma = tau/y, from one step to the next."""
    q, sigma = n.eta / n.y, n.tau / n.y
    q_next, sigma_next = n.r * n.u / n.y_next, n.tau_next / n.y_next
    bent = times("tail-closes", "tail-bent")
    left = plus(
        times(bent, "tail-approaches"),
        times("tail-recedes", "tail-closing"),
        times("tail-approaches", "tail-law"),
    )
    sum_ = plus("tail-t", power("tail-t", 2))
    y2 = power("tail-approaches", 2)
    yield from (
        Line("second-ratio",  n.r <= q_next * (a - q), proof(times("tail-r", left)), LABEL,
             "q' ≥ r/(t+t²-q), where q = η_s/y"),
        Line("second-slower", n.y_next <= a * n.y - n.eta,
             proof("tail-law", bent, times(sum_, "tail-closing"))),
        Line("second-later",  0 < n.tau_next,
             scaled(times("goal", "tail-next-approaches"), "tail-later",
                    times("tail-recedes", "tail-time"))),
        Line("second-growth", sigma * q <= sigma_next * (a - q) ** 2,
             proof(times(y2, "second-later", "second-slower",
                         plus("second-slower", times(2, "tail-next-approaches"))),
                   times(y2, "tail-next-approaches", "tail-later")), LABEL,
             "τ'/y' ≥ q/(t+t²-q)² τ/y"),
    )  # fmt: skip


def _low() -> Iterator[Item]:
    """While q is small it grows."""
    x, size = low, plus("low-t", power("low-t", 2))
    room = plus("low-q-most", times("low-t", "low-t-most"))
    yield from (
        Line("low-sum",  0 < x.t + x.t**2, proof(size)),
        Line("low-room", 0 < x.t + x.t**2 - x.q, proof("low-q-most", "low-t")),
        Line("second-below", x.q + (x.r - x.t**3) / (x.t + x.t**2) <= x.r / (x.t + x.t**2 - x.q),
             proof(times(size, "low-q-most", room), times("low-cube", "low-q")), LABEL,
             "while q ≤ t², it grows by (r-t³)/(t+t²) at least"),
    )  # fmt: skip


def _high() -> Iterator[Item]:
    """Then it stays large, and sigma grows."""
    x = high
    room = x.t + x.t**2 - x.q
    yield from (
        Line("second-above",  x.r / x.t <= x.r / room, proof(times("high-r", "high-q")), LABEL,
             "from q ≥ t² on it is at least r/t, which is more than t²"),
    )  # fmt: skip


def _grown() -> Iterator[Item]:
    """And sigma grows."""
    x = grown
    room = x.t + x.t**2 - x.q
    yield from (
        Line("grown-fast",    x.t**2 < x.q,
             scaled(times("goal", "grown-t"), "grown-q", "grown-cube")),
        Line("second-factor", x.r / x.t / x.t / x.t <= x.q / room / room,
             proof(times(power("grown-t", 2), "grown-q"),
                   times("grown-r", "grown-fast", plus("grown-t", "grown-room"))), LABEL,
             "and from q ≥ r/t on q/(t+t²-q)² is at least r/t³, which is more than 1"),
    )  # fmt: skip
