(* The states of the collapse of three balls of any masses and radii: the numbers of each satisfy what
   AnyStep.v asks for, and the certificate's next state is the one there. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Checker Readable Extension.
From Verify Require Import AnyStep ThreeBalls.
From Verify Require Gram Balls.
Import ListNotations.
Open Scope R_scope.

(* --- the states of the certificate --------------------------------------------------------------- *)

Notation SB := Balls.the_statement.
Notation shown_here := (shown SB Balls.all_values).
Definition the_induction := Eval vm_compute in induction_of SB.
Definition start_context := Eval vm_compute in fst (fst (fst the_induction)).
Definition state_context := Eval vm_compute in snd (fst (fst the_induction)).
Definition start := Eval vm_compute in snd (fst the_induction).
Definition next := Eval vm_compute in snd the_induction.
Lemma well : well_formed SB (homes SB) = true.
Proof. vm_compute. reflexivity. Qed.

Definition numbers_of (v : valuation) : numbers := Numbers (v Balls.number_of_y)
  (v Balls.number_of_eta_s) (v Balls.number_of_C) (v Balls.number_of_a) (v Balls.number_of_b)
  (v Balls.number_of_A) (v Balls.number_of_B) (v Balls.number_of_w) (v Balls.number_of_d).
Notation here v := (v Balls.number_of_Q, v Balls.number_of_U).
Notation alpha_here v :=
  (v Balls.number_of_beta_c * (v Balls.number_of_C_0 - v Balls.number_of_Theta)).
Notation rho_here v :=
  (v Balls.number_of_G * (v Balls.number_of_w_s / v Balls.number_of_w_c) ^ 2).

(* What the certificate takes for granted: inequalities of Cauchy and Schwarz, and that the map goes on. *)
Definition the_standing := Eval vm_compute in
  map (fun a => read_claim Balls.the_table (given_claim a)) (standing SB state_context).
Lemma the_standing_is :
  map (fun a => read_claim Balls.the_table (given_claim a)) (standing SB state_context) = the_standing.
Proof. vm_compute. reflexivity. Qed.
Lemma vectors_standing v dimension p q s c : products (numbers_of v) dimension p q s c ->
  0 < pace (alpha_here v) (rho_here v) (here v) ->
  load (rho_here v) (here v) <= v Balls.number_of_U_b * (2 - v Balls.number_of_U_b) *
    pace (alpha_here v) (rho_here v) (here v) ^ 2 ->
  satisfies SB v (standing SB state_context).
Proof.
  intros [P Q PQ PS QC PC QS S2 CC SC] Approaches Meets. cbn [y eta_s C a b A B w d numbers_of] in *.
  assert (X : Forall (shown_here v) the_standing).
  { pose proof (cauchy_schwarz dimension p q) as C1. pose proof (cauchy_schwarz dimension p s) as C2.
    pose proof (cauchy_schwarz dimension q c) as C3. pose proof (cauchy_schwarz dimension p c) as C4.
    pose proof (cauchy_schwarz dimension q s) as C5.
    pose proof (fun t e => Gram.impact_square dimension p q s c t e P Q) as C8.
    rewrite PQ, P, Q in C1. rewrite PS, P, S2 in C2. rewrite QC, Q, CC in C3. rewrite PC, P, CC in C4.
    rewrite QS, Q, S2 in C5. rewrite PQ, PS, QC, PC, QS, S2, CC, SC in C8. unfold the_standing.
    repeat (apply Forall_cons; [first [exact C1 | exact C2 | exact C3 | exact C4 | exact C5
      | exact (proj1 (C8 _ (1 + v Balls.number_of_d))) | exact (proj2 (C8 _ (1 + v Balls.number_of_d)))
      | exact Approaches | exact Meets]|]).
    apply Forall_nil. }
  apply (givens_shown SB Balls.the_order _ Balls.the_table_is _ Balls.all_right). now rewrite the_standing_is.
Qed.

Ltac row_of w is_row inside :=
  refine (row_in_scope SB Balls.the_order Balls.the_table Balls.the_table_is
    Balls.the_rows_hold Balls.all_values _ _ _ w Balls.all_right is_row _); exact inside.
Definition the_conditions := Eval vm_compute in conditions_of SB Balls.the_table state_context.
Lemma the_conditions_are : conditions_of SB Balls.the_table state_context = the_conditions.
Proof. vm_compute. reflexivity. Qed.
Definition condition v g : scope SB state_context v -> _ -> shown_here v g :=
  condition_shown SB well Balls.the_table Balls.the_table_is _ Balls.all_right _ v g _
    the_conditions_are.

Section BallsState.
Variable v : valuation.
Hypothesis inside : scope SB state_context v.
Notation vy := (v Balls.number_of_y).
Notation vs := (v Balls.number_of_eta_s).
Notation vA := (v Balls.number_of_A).
Notation vB := (v Balls.number_of_B).
Notation vd := (v Balls.number_of_d).
Definition flight : R := Balls.tau vy vA vd.
Definition new : valuation := after SB v next.
Lemma new_value x t : put next x = Some t ->
  new x = show SB Balls.all_values v (read Balls.the_table 400 t).
Proof. exact (substituted SB Balls.the_order _ Balls.the_table_is _ Balls.all_right _ _ _ _). Qed.
Lemma mapped_next : here new = mapped (alpha_here v) (rho_here v) (v Balls.number_of_r_c * v Balls.number_of_G) (here v).
Proof. rewrite (new_value Balls.number_of_Q _ eq_refl), (new_value Balls.number_of_U _ eq_refl). reflexivity. Qed.
Lemma before t : 0 <= t < flight -> scope SB Balls.context_before (at_time v Balls.number_of_s t).
Proof. in_flight SB well Balls.the_table_is Balls.all_right inside. Qed.
Lemma meanwhile t : 0 <= t <= flight -> scope SB Balls.context_meanwhile (at_time v Balls.number_of_t t).
Proof. in_flight SB well Balls.the_table_is Balls.all_right inside. Qed.
Theorem balls_step radius o i j : v Balls.number_of_sigma_s = radius o + radius i ->
  v Balls.number_of_sigma_c = radius o + radius j -> v Balls.number_of_sigma_12 = radius i + radius j ->
  certified_if (numbers_of v) flight (outer_of_balls radius o i j (numbers_of v)).
Proof.
  intros Si Sj Sij. split.
  - row_of v Balls.row_of_tau_positive_is inside.
  - refine (condition _ (Less, Whole 0, Named Balls.number_of_eta_s) inside _). vm_compute. reflexivity.
  - refine (condition _ (Less, Whole 0, Plus (Whole 1) (Named Balls.number_of_d)) inside _).
    vm_compute. reflexivity.
  - assert (P : 0 < Balls.d_next vy vs vA vB vd) by row_of v Balls.row_of_next_d_positive_is inside.
    unfold Balls.d_next in P. change (0 < Balls.D vy vs vA vB vd). lra.
  - row_of v Balls.row_of_contact_is inside.
  - assert (E : Balls.kappa vy vA vd = - ((1 + vd) * vy * Balls.S vy vA vd))
      by row_of v Balls.row_of_impact_speed_is inside.
    assert (P : 0 < (1 + vd) * vy * Balls.S vy vA vd)
      by row_of v Balls.row_of_impact_positive_is inside.
    change (Balls.kappa vy vA vd < 0). lra.
  - intros t T.
    row_of (at_time v Balls.number_of_s t) Balls.row_of_colliding_pair_apart_is (before t T).
  - intros t T.
    row_of (at_time v Balls.number_of_t t) Balls.row_of_spectator_apart_is (meanwhile t T).
  - intros t T. unfold outer_of_balls. rewrite <- Si, <- Sj, <- Sij. cbn [y eta_s C a b A B w d numbers_of].
    set (S := v Balls.number_of_sigma_s). set (K := v Balls.number_of_sigma_c).
    assert (Q : v Balls.number_of_sigma_12 ^ 2 < (- S) * (- S) + (- S) * (t * (- S)) * vs
      + (- S) * (K * (1 + vd)) * (- v Balls.number_of_C) + (- S) * (t * K) * v Balls.number_of_a
      + t * (- S) * (- S) * vs + t * (- S) * (t * (- S)) * vB
      + t * (- S) * (K * (1 + vd)) * v Balls.number_of_b + t * (- S) * (t * K) * v Balls.number_of_w
      + K * (1 + vd) * (- S) * (- v Balls.number_of_C) + K * (1 + vd) * (t * (- S)) * v Balls.number_of_b
      + K * (1 + vd) * (K * (1 + vd)) + K * (1 + vd) * (t * K) * (- vy)
      + t * K * (- S) * v Balls.number_of_a + t * K * (t * (- S)) * v Balls.number_of_w
      + t * K * (K * (1 + vd)) * (- vy) + t * K * (t * K) * vA)
      by row_of (at_time v Balls.number_of_t t) Balls.row_of_outer_pair_apart_is (meanwhile t T).
    apply (Rlt_le_trans _ _ _ Q), Req_le. ring.
Qed.
Ltac in_new x := rewrite (new_value x _ eq_refl).
Lemma new_numbers : numbers_of new =
  after_sharing (v Balls.number_of_beta_c) (v Balls.number_of_r_c) (numbers_of v) flight.
Proof.
  unfold numbers_of. in_new Balls.number_of_y. in_new Balls.number_of_eta_s.
  in_new Balls.number_of_C. in_new Balls.number_of_a. in_new Balls.number_of_b.
  in_new Balls.number_of_A. in_new Balls.number_of_B. in_new Balls.number_of_w.
  in_new Balls.number_of_d. unfold after_sharing. cbn [y eta_s C a b A B w d].
  f_equal; try reflexivity.
  transitivity (Balls.A_next vy (v Balls.number_of_b) vA vB (v Balls.number_of_w) vd (v Balls.number_of_beta_c)).
  - reflexivity.
  - unfold Balls.A_next, impact. cbn [y A d]. unfold Balls.kappa. fold flight. ring.
Qed.
End BallsState.
