"""What every letter stands for, in the order in which a reader meets them."""

from __future__ import annotations

from verify.language.record import Record


class Letter(Record):
    """A letter, what it stands for, and where the paper has it."""

    letter: str
    says: str
    label: str


THEOREM = "THEORSS4.1ExistenCollapse"
START = "EQUATSS4.1DescrDoIniColla"
MODEL = "DEFINSS2.1FlotrInelaSphDu"
SPECTRUM = "THEORSS3.5SpectMatricVitLm"
NEXT = "EQUATSS4.1SysteDynamColSp"

#: Those of the picture come first.
LETTERS = (
    Letter("0", "the central particle: it takes part in every collision", START),
    Letter("s", "the side particle that has just collided with 0: at first particle 1", START),
    Letter("c", "the particle that collides with 0 next: at first particle 2", START),
    Letter("ω_s, ω_c", "unit vectors from the centre of 0 to the centres of s and of c", NEXT),
    Letter("W_s, W_c", "velocities of s and of c relative to 0", NEXT),
    Letter("η_s", "ω_s·W_s > 0: how fast s leaves 0", NEXT),
    Letter("η_c", "ω_c·W_c < 0: c comes nearer with the speed -η_c", NEXT),
    Letter("d", "gap between 0 and c: their centres have the distance 1 + d", NEXT),
    Letter("θ", "angle at 0 between s and c: cos θ = ω_s·ω_c", NEXT),
    Letter("n", "the index of a collision: η_{c,n}, d_n, θ_n, … are those after the n-th", NEXT),
    Letter("τ_n", "time from the collision n to the next", "EQUATSS4.1_Controle_Tau_n"),
    Letter("ζ_n", "d_n(2+d_n)|W_{c,n}|²/((1+d_n)²η_{c,n}²): c hits 0 if ζ_n < 1", NEXT),
    Letter("x_n", "η_{s,n}/(-η_{c,n}) = φ⁻ + x_n", "EQUATSS4.1DefinReste_x_n_"),
    Letter("y_n", "η_{c,n+1}/(-η_{c,n}) = φ⁻ - α₀ + y_n", "EQUATSS4.1DefinReste_y_n_"),
    Letter("r", "restitution coefficient: a collision multiplies the normal velocity by -r", MODEL),
    Letter("θ₀", "the angle near which the particles start, between π/2 and π", THEOREM),
    Letter("δ_θ", "how far -cos of the final angle may be from -cos θ₀", THEOREM),
    Letter("V₀, V₁", "bounds of |W_c|² and |W_s|², for ever", "EQUATSS4.1Recurrence_Cnd5"),
    Letter("α₀", "(1+r)/2 · (-cos θ₀)", THEOREM),
    Letter("φ⁻, φ⁺", "fixed points of φ ↦ r/(α₀ - φ), the smaller one stable", THEOREM),
    Letter("δ₁ … δ₅", "how much room the ratio η_s/(-η_c) has around φ⁻", THEOREM),
    Letter("C_η", "each collision multiplies -η_c by at most that", "EQUATSS4.1Quantite_C_eta_"),
    Letter("h₄, h₅", "by how much x and ζ shrink in a step", "EQUATSS4.1ThExiCondiTheta"),
    Letter("δ_x, η̄, ζ̄, d̄", "bounds of |x_n|, -η_c, ζ and d in the set of starts", START),
    Letter("Δθ", "how far -cos θ_n may be from -cos θ₀", "EQUATSS4.1Recurrence_Cnd8"),
    Letter("T*", "all collisions happen within this time", THEOREM),
    Letter("𝔄_∞", "limit matrix of three collisions in a triangle", SPECTRUM),
    Letter("λ₀, λ±", "its eigenvalues besides 1", SPECTRUM),
)
