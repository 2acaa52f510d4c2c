(* The states of the sandwich theorem: the numbers of each satisfy what AnyStep.v asks for, and the
   certificate's next state is the one there. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Checker Readable.
From Verify Require Import Extension AnyStep.
From Verify Require Citations Flow Gram OneStep Inner.
Import ListNotations.
Open Scope R_scope.

Notation SI := Inner.the_statement.
Notation shown_here := (shown SI Inner.all_values).

(* The induction of the certificate, and its contexts. *)
Definition the_induction := Eval vm_compute in induction_of SI.
Definition start_context := Eval vm_compute in fst (fst (fst the_induction)).
Definition state_context := Eval vm_compute in snd (fst (fst the_induction)).
Definition start := Eval vm_compute in snd (fst the_induction).
Definition next := Eval vm_compute in snd the_induction.
Lemma well : well_formed SI (homes SI) = true.
Proof. vm_compute. reflexivity. Qed.

Definition numbers_of (v : valuation) : numbers := Numbers (v Inner.number_of_y)
  (v Inner.number_of_eta_s) (v Inner.number_of_C) (v Inner.number_of_a)
  (v Inner.number_of_b) (v Inner.number_of_A) (v Inner.number_of_B) (v Inner.number_of_w)
  (v Inner.number_of_d).

(* --- what the certificate says of a state ------------------------------------------------------- *)

Ltac row_of w is_row inside :=
  refine (row_in_scope SI Inner.the_order Inner.the_table Inner.the_table_is
    Inner.the_rows_hold Inner.all_values _ _ _ w Inner.all_right is_row _); exact inside.
Definition the_conditions := Eval vm_compute in conditions_of SI Inner.the_table state_context.
Lemma the_conditions_are : conditions_of SI Inner.the_table state_context = the_conditions.
Proof. vm_compute. reflexivity. Qed.
Definition condition v g : scope SI state_context v -> _ -> shown_here v g :=
  condition_shown SI well Inner.the_table Inner.the_table_is _ Inner.all_right _ v g _
    the_conditions_are.

Section SandwichStep.
Variable v : valuation.
Hypothesis inside : scope SI state_context v.
Notation r := (v Inner.number_of_r).
Notation vy := (v Inner.number_of_y).
Notation vs := (v Inner.number_of_eta_s).
Notation vA := (v Inner.number_of_A).
Notation vB := (v Inner.number_of_B).
Notation vd := (v Inner.number_of_d).
Definition flight : R := Inner.tau vy vA vd.
Definition new : valuation := after SI v next.
Lemma new_value x t : put next x = Some t ->
  new x = show SI Inner.all_values v (read Inner.the_table 400 t).
Proof. exact (substituted SI Inner.the_order _ Inner.the_table_is _ Inner.all_right _ _ _ _). Qed.

Lemma before t : 0 <= t < flight -> scope SI Inner.context_before (at_time v Inner.number_of_s t).
Proof. in_flight SI well Inner.the_table_is Inner.all_right inside. Qed.
Lemma meanwhile t : 0 <= t <= flight -> scope SI Inner.context_meanwhile (at_time v Inner.number_of_t t).
Proof. in_flight SI well Inner.the_table_is Inner.all_right inside. Qed.

Theorem sandwich_step : step_certified (numbers_of v) flight.
Proof.
  split.
  - row_of v Inner.row_of_tau_positive_is inside.
  - refine (condition _ (Less, Whole 0, Named Inner.number_of_eta_s) inside _). vm_compute. reflexivity.
  - refine (condition _ (Less, Whole 0, Plus (Whole 1) (Named Inner.number_of_d)) inside _).
    vm_compute. reflexivity.
  - assert (P : 0 < Inner.d_next vy vs vA vB vd) by row_of v Inner.row_of_next_d_positive_is inside.
    unfold Inner.d_next in P. change (0 < Inner.D vy vs vA vB vd). lra.
  - row_of v Inner.row_of_contact_is inside.
  - assert (E : Inner.kappa vy vA vd = - ((1 + vd) * vy * Inner.S vy vA vd))
      by row_of v Inner.row_of_impact_speed_is inside.
    assert (P : 0 < (1 + vd) * vy * Inner.S vy vA vd)
      by row_of v Inner.row_of_impact_positive_is inside.
    change (Inner.kappa vy vA vd < 0). lra.
  - intros t T.
    row_of (at_time v Inner.number_of_s t) Inner.row_of_colliding_pair_apart_is (before t T).
  - intros t T.
    row_of (at_time v Inner.number_of_t t) Inner.row_of_spectator_apart_is (meanwhile t T).
  - intros t T. unfold outer_of_equal. cbn [y eta_s C a b A B w d numbers_of].
    assert (Q : 1 < (-1) * (-1) + (-1) * (t * (-1)) * vs
      + (-1) * (1 + vd) * (- v Inner.number_of_C)
      + (-1) * t * v Inner.number_of_a + t * (-1) * (-1) * vs + t * (-1) * (t * (-1)) * vB
      + t * (-1) * (1 + vd) * v Inner.number_of_b + t * (-1) * t * v Inner.number_of_w
      + (1 + vd) * (-1) * (- v Inner.number_of_C) + (1 + vd) * (t * (-1)) * v Inner.number_of_b
      + (1 + vd) * (1 + vd) + (1 + vd) * t * (- vy)
      + t * (-1) * v Inner.number_of_a + t * (t * (-1)) * v Inner.number_of_w
      + t * (1 + vd) * (- vy) + t * t * vA)
      by row_of (at_time v Inner.number_of_t t) Inner.row_of_outer_pair_apart_is (meanwhile t T).
    apply (Rlt_le_trans _ _ _ Q), Req_le. ring.
Qed.
Ltac in_new x := rewrite (new_value x _ eq_refl).
Lemma new_numbers : numbers_of new = after_step r (numbers_of v) flight.
Proof.
  unfold numbers_of. in_new Inner.number_of_y. in_new Inner.number_of_eta_s.
  in_new Inner.number_of_C. in_new Inner.number_of_a. in_new Inner.number_of_b.
  in_new Inner.number_of_A. in_new Inner.number_of_B. in_new Inner.number_of_w.
  in_new Inner.number_of_d. unfold after_step, after_sharing. cbn [y eta_s C a b A B w d].
  f_equal; try reflexivity.
  transitivity (Inner.A_next r vy (v Inner.number_of_b) vA vB (v Inner.number_of_w) vd).
  - reflexivity.
  - unfold Inner.A_next, impact. cbn [y A d]. unfold Inner.kappa. fold flight. ring.
Qed.
End SandwichStep.
