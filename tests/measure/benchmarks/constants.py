"""Enclose the printed constants at 1000 values of r: the program against straight-line code.

Run ``python tests/measure/benchmarks/constants.py``; it prints both times and their ratio, each
the median of several alternating runs. The two must give overlapping balls.
"""

from __future__ import annotations

from fractions import Fraction
from statistics import median
from time import process_time

from flint import arb, ctx, fmpq

from verify.paper.commands.theorem1 import constants_enclosure

BITS = 128
COUNT = 1000
ROUNDS = 7


def straight_line(r: arb, c: arb, v_0: arb, delta_theta: arb) -> dict[str, arb]:
    """The constants of the printed proof, written out by hand."""
    alpha = (1 + r) / 2 * c
    root = (alpha * alpha - 4 * r).sqrt()
    minus = 2 * r / (alpha + root)
    plus = (alpha + root) / 2
    gap = alpha - minus
    delta_1 = alpha / 2 - minus
    delta_2 = gap / 2
    delta_3 = (1 - gap) / 2
    c_eta = 1 - delta_3
    h_4 = (1 - r / (gap * gap)) / 2
    delta_4 = gap - (r / (1 - h_4)).sqrt()
    h_5 = (1 - minus / (gap * gap)) / 2
    delta_5 = gap - (minus / (1 - h_5)).sqrt()
    v_1 = v_0 * ((1 - h_5 / 2) / (1 - h_5))
    delta_x = delta_1.min(delta_2).min(delta_3).min(delta_4).min(delta_5)
    x_0 = ((1 - h_4) * delta_x).min(v_0 / v_1 * (delta_2 * delta_2 * h_5 / 12))
    angle = (c / 2).min(h_4 / 8 * delta_x).min(delta_theta)
    speed = v_1.sqrt()
    unit = v_0 / speed
    root_2 = arb(2).sqrt()
    eta = arb(1).min((root_2 - 1) / 16 * unit).min(v_0 / (33 * speed) * angle)
    eta = eta.min((1 - c_eta) * (v_1 - v_0) / (12 * (speed + 2)))
    total = 2 / (15 * alpha) + h_4 * delta_2 / 6 + h_4 / (12 * alpha) + h_4 / 24
    eta = eta.min(unit * total * delta_x)
    zeta = (2 * (root_2 - 1)).min(
        v_0 * h_5 / (3 * v_1 * (alpha + 8 * v_1 / v_0)) * (delta_2 * delta_2)
    )
    zeta = zeta.min((1 + 4 * delta_2 + v_0 / v_1) / 16 * h_4 * delta_x)
    slope = zeta / (2 * v_1)
    const = ((root_2 - 1) / 4).min(angle / 3).min((1 + delta_2 * h_4) * delta_x / 5)
    const = const.min((1 + 2 * delta_2) / 4 * h_4 * delta_x)
    d = const.min(slope * (eta * eta))
    time = 2 / (v_0 * (1 - c_eta)) * eta * zeta
    return {
        "alpha_0": alpha, "phi_minus": minus, "phi_plus": plus, "delta_1": delta_1,
        "delta_2": delta_2, "delta_3": delta_3, "C_eta": c_eta, "h_4": h_4, "delta_4": delta_4,
        "h_5": h_5, "delta_5": delta_5, "V_1": v_1, "printed.delta_x": delta_x,
        "printed.x_0": x_0, "printed.Delta_theta": angle, "printed.eta_bar": eta,
        "printed.zeta_bar": zeta, "printed.d_slope": slope, "printed.d_const": const,
        "printed.d_bar": d, "printed.T_star": time,
    }  # fmt: skip


def main() -> None:
    """Print the two times and the ratio."""
    values = [Fraction(k, 20 * COUNT) for k in range(1, COUNT + 1)]
    enclose = constants_enclosure(BITS)
    one, tenth = Fraction(1), Fraction(1, 10)

    def by_program() -> list[dict[str, arb]]:
        return [enclose({"r": r, "c": one, "V_0": one, "delta_theta": tenth}) for r in values]

    def by_hand() -> list[dict[str, arb]]:
        with ctx.workprec(BITS):
            return [
                straight_line(
                    arb(fmpq(r.numerator, r.denominator)), arb(1), arb(1), arb(fmpq(1, 10))
                )
                for r in values
            ]

    for ours, theirs in zip(by_program(), by_hand(), strict=True):
        if not all(ours[name].overlaps(theirs[name]) for name in theirs):
            raise SystemExit("the two computations disagree")
    times: list[tuple[float, float]] = []
    for _ in range(ROUNDS):
        start = process_time()
        by_program()
        middle = process_time()
        by_hand()
        times.append((middle - start, process_time() - middle))
    program, hand = (median(column) for column in zip(*times, strict=True))
    ratio = median(a / b for a, b in times)
    print(f"{COUNT} values of r at {BITS} bits: program {program * 1e3:.1f} ms, "
          f"straight line {hand * 1e3:.1f} ms, ratio {ratio:.2f}")  # fmt: skip


if __name__ == "__main__":
    main()
