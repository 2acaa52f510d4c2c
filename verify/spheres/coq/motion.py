"""What a certificate says of three balls: a theorem in Coq that follows from it.

That of a point run applies the step to numbers. `verify/coq/FromNumbers.v` proves for all numbers
that satisfy what the step needs that the balls collapse. The theorem is written with the numbers as
the statement has them; Coq compares them by conversion.
"""

from __future__ import annotations

from verify import check
from verify.spheres.coq.scene import about_scene
from verify.wire.coq.readable import Readable, readable
from verify.wire.coq.reading import NotAcceptedError, Reading

#: What the set is described by, in the order of ``initial_with`` in FromNumbers.v.
DESCRIBED = (
    "phi_minus", "x_0", "eta_bar", "d_const", "d_slope", "V_0", "V_1", "Delta_theta", "c",
)  # fmt: skip
#: What the theorem says of the collapse.
SAID = ("r", "T_star", "delta_theta")

HEAD = """
(* --- three balls --- *)

From Verify Require Theorem1 Citations FromNumbers Step.

Lemma the_citations_are_true : citations_true the_statement.
Proof.
  apply (Citations.citations_closed
    [(Step.the_statement, Citations.size Step.the_statement the_statement)]).
  - vm_compute. reflexivity.
  - apply Forall_cons; [exact Step.proved | constructor].
Qed."""


def about_balls(reading: Reading) -> list[str]:
    """What is added to the exported file; the last lines are the theorem, and what it rests on.

    Raises:
        NotAcceptedError: for a statement that is neither a point run nor a scene that disperses.
    """
    found = about_scene(reading) if reading.theorem == "scene" else _about_point(reading)
    return [*found, "\nPrint Assumptions three_balls.\n"]


def _about_point(reading: Reading) -> list[str]:
    row, claim, at = _application(reading)
    form = Readable(reading)
    texts = {name: form.notation.term(at[name], 4) for name in (*DESCRIBED, *SAID)}
    lemmas = (_number(name, texts[name]) for name in (*DESCRIBED, *SAID))
    values = {name: _value(form, at[name]) for name in texts}
    values["phi_minus"] = f"(Theorem1.phi_minus {values['r']} {values['c']})"
    described = " ".join(values[name] for name in DESCRIBED)
    substitution = form.numbers.substitution(claim.context, claim.at)
    rewritten = ",\n    ".join(f"the_{name}_is" for name in (*DESCRIBED, *SAID))
    says = form.notation.name(row.name)
    theorem = f"""
Definition the_substitution : substitution := {substitution}%positive.
Definition the_numbers := after the_statement (fun _ => 0) the_substitution.
Lemma the_number_is x t : put the_substitution x = Some t ->
  the_numbers x = show the_statement all_values (fun _ => 0) (read the_table 400 t).
Proof.
  intros E. rewrite (read_right the_statement the_order the_table the_table_is _ _ all_right).
  unfold the_numbers, after. now rewrite E.
Qed.
Lemma the_numbers_are_good : scope Step.the_statement FromNumbers.numbers_context the_numbers.
Proof.
  apply FromNumbers.numbers_of_row; [vm_compute; reflexivity|].
  exact ({says} the_citations_are_true).
Qed."""
    final = f"""
(* The theorem at these numbers: c is minus the cosine of theta_0. *)
Theorem three_balls : forall d s d_0 y,
  FromNumbers.initial_with {described}
    d s d_0 y ->
  Theorem1.collapse d {values["r"]} s {values["T_star"]} {values["c"]} {values["delta_theta"]}.
Proof.
  intros d s d_0 y. pose proof (FromNumbers.collapse_from_numbers the_numbers
    the_numbers_are_good d s d_0 y) as A.
  rewrite {rewritten} in A. exact A.
Qed."""
    return [*readable(reading, form, [row.name]), HEAD, theorem, *lemmas, final]


def _application(reading: Reading) -> tuple[check.Row, check.Applies, dict[str, int]]:
    """The row that applies the step at no variables, and the term for each number of the step."""
    for row in reading.statement.rows.values():
        claim = row.claim
        if not isinstance(claim, check.Applies) or row.verdict != "proved":
            continue
        names = {x: name.rpartition(":")[2] for name, x in claim.context.variables.items()}
        at = {names[x]: term for x, term in claim.at.items()}
        alone = len(reading.statement.cites) == 1 and row.context.parent is None
        if alone and {*DESCRIBED, *SAID} <= at.keys():
            return row, claim, at
    raise NotAcceptedError("it does not apply the step to numbers, as a point run of theorem1 does")


def _value(form: Readable, term: int) -> str:
    """A number as it is defined, if that is a number."""
    return form.notation.term(form.kernel.definitions.get(term, term), 4)


def _number(name: str, text: str) -> str:
    """The lemma that a number of the step is a constant of the statement."""
    return (
        f"Lemma the_{name}_is : the_numbers Step.number_of_{name} = {text}.\n"
        f"Proof. exact (the_number_is Step.number_of_{name} _ eq_refl). Qed."
    )
