(* One collision: if a scene has the numbers of a state, then the next collision is that of ball 0
   with the other ball, after the time tau, and the scene after it has the numbers that the
   certificate of the step calls next. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Checker Readable Extension Gram.
From Verify Require Import AnyStep.
From Verify Require Step.
Import ListNotations.
Open Scope R_scope.

(* --- what the certificate says of a state ----------------------------------------------------- *)

Ltac row_of w is_row inside :=
  refine (row_in_scope S0 Step.the_order Step.the_table Step.the_table_is Step.the_rows_hold
    Step.all_values _ _ _ w Step.all_right is_row _); exact inside.

Definition the_conditions := Eval vm_compute in conditions_of S0 Step.the_table state_context.
Lemma the_conditions_are : conditions_of S0 Step.the_table state_context = the_conditions.
Proof. vm_compute. reflexivity. Qed.
Definition condition v g : scope S0 state_context v -> _ -> shown_here v g :=
  condition_shown S0 well Step.the_table Step.the_table_is _ Step.all_right _ v g _ the_conditions_are.
Ltac is_condition g inside := refine (condition _ g inside _); vm_compute; reflexivity.

Section OneStep.
Variable w : valuation.
Hypothesis inside : scope S0 state_context w.

Notation r := (w Step.number_of_r).
Notation y := (w Step.number_of_y).
Notation eta_s := (w Step.number_of_eta_s).
Notation C := (w Step.number_of_C).
Notation a := (w Step.number_of_a).
Notation b := (w Step.number_of_b).
Notation A := (w Step.number_of_A).
Notation B := (w Step.number_of_B).
Notation n := (w Step.number_of_w).
Notation d := (w Step.number_of_d).
Definition flight : R := Step.tau y A d.
Definition new : valuation := after S0 w next.
Lemma new_value x t : put next x = Some t ->
  new x = show S0 Step.all_values w (read Step.the_table 400 t).
Proof. exact (substituted S0 Step.the_order _ Step.the_table_is _ Step.all_right _ _ _ _). Qed.
Ltac is_new x := exact (new_value x _ eq_refl).

Lemma flight_positive : 0 < flight.
Proof. row_of w Step.row_of_tau_positive_is inside. Qed.
Lemma recedes : 0 < eta_s.
Proof. is_condition (Less, Whole 0, Named Step.number_of_eta_s) inside. Qed.
Lemma far : 0 < 1 + d.
Proof. is_condition (Less, Whole 0, Plus (Whole 1) (Named Step.number_of_d)) inside. Qed.
Lemma touching : (1 + d) * (1 + d) + (1 + d) * flight * - y + flight * (1 + d) * - y
  + flight * flight * A = 1.
Proof. row_of w Step.row_of_contact_is inside. Qed.
Lemma approaching : Step.kappa y A d < 0.
Proof.
  assert (E : Step.kappa y A d = - ((1 + d) * y * Step.S y A d))
    by row_of w Step.row_of_impact_speed_is inside.
  assert (P : 0 < (1 + d) * y * Step.S y A d) by row_of w Step.row_of_impact_positive_is inside.
  lra.
Qed.
Lemma far_after : 0 < Step.D y eta_s A B d.
Proof.
  assert (P : 0 < Step.d_next y eta_s A B d) by row_of w Step.row_of_next_d_positive_is inside.
  unfold Step.d_next in P. lra.
Qed.

(* What makes the sums over all collisions converge. *)
Notation V_1 := (w Step.number_of_V_1).
Definition drift (v : valuation) : R :=
  v Step.number_of_Delta_theta / 4 + (v Step.number_of_d_bar + 14 / (1 - v Step.number_of_C_eta) *
    (sqrt (v Step.number_of_V_1) / v Step.number_of_V_0) * v Step.number_of_eta_bar).
Ltac in_new x value := replace (new x) with value by (symmetry; is_new x).
Lemma clock_next : new Step.number_of_clock = w Step.number_of_clock + flight.
Proof. is_new Step.number_of_clock. Qed.
Lemma clock_bounded : w Step.number_of_clock <= w Step.number_of_T_star.
Proof. row_of w Step.row_of_time_total_is inside. Qed.
Lemma distance_next : new Step.number_of_d <= 3 / 2 * sqrt V_1 * flight.
Proof.
  in_new Step.number_of_d (Step.d_next y eta_s A B d). row_of w Step.row_of_distance_time_is inside.
Qed.
Lemma cosine_up : new Step.number_of_C - C <= d + new Step.number_of_d + 4 * sqrt V_1 * flight.
Proof.
  in_new Step.number_of_C (Step.C_next y eta_s C a b A B n d).
  in_new Step.number_of_d (Step.d_next y eta_s A B d).
  row_of w Step.row_of_angle_step_upper_is inside.
Qed.
Lemma cosine_down : C - new Step.number_of_C <= d + new Step.number_of_d + 4 * sqrt V_1 * flight.
Proof.
  in_new Step.number_of_C (Step.C_next y eta_s C a b A B n d).
  in_new Step.number_of_d (Step.d_next y eta_s A B d).
  row_of w Step.row_of_angle_step_lower_is inside.
Qed.
Lemma cosine_near : Rabs (new Step.number_of_C - w Step.number_of_c) <= drift w.
Proof.
  set (beta := 14 / (1 - w Step.number_of_C_eta) * (sqrt V_1 / w Step.number_of_V_0)).
  set (later_g := w Step.number_of_C_eta * w Step.number_of_g).
  assert (G : 0 <= beta * later_g).
  { assert (Y : 0 < y) by is_condition (Less, Whole 0, Named Step.number_of_y) inside.
    assert (Yg : y <= w Step.number_of_g)
      by is_condition (AtMost, Named Step.number_of_y, Named Step.number_of_g) inside.
    assert (P : 0 < w Step.number_of_C_eta)
      by is_condition (Less, Whole 0, Named Step.number_of_C_eta) inside.
    assert (E : 0 < 1 - w Step.number_of_C_eta)
      by is_condition (Less, Whole 0, Minus (Whole 1) (Named Step.number_of_C_eta)) inside.
    assert (V : 0 < w Step.number_of_V_0) by is_condition (Less, Whole 0, Named Step.number_of_V_0) inside.
    unfold beta, later_g. repeat apply Rmult_le_pos; try apply sqrt_pos; try lra;
      now apply Rlt_le, Rinv_0_lt_compat. }
  in_new Step.number_of_C (Step.C_next y eta_s C a b A B n d).
  assert (P : 0 < Step.d_next y eta_s A B d) by row_of w Step.row_of_next_d_positive_is inside.
  assert (U : Step.C_next y eta_s C a b A B n d - w Step.number_of_c <=
    drift w - Step.d_next y eta_s A B d - beta * later_g)
    by row_of w Step.row_of_next_Cnd8_upper_is inside.
  assert (L : - (drift w - Step.d_next y eta_s A B d - beta * later_g) <=
    Step.C_next y eta_s C a b A B n d - w Step.number_of_c)
    by row_of w Step.row_of_next_Cnd8_lower_is inside.
  apply Rabs_le. lra.
Qed.

Lemma before t : 0 <= t < flight -> scope S0 Step.context_before (at_time w Step.number_of_s t).
Proof. in_flight S0 well Step.the_table_is Step.all_right inside. Qed.
Lemma meanwhile t : 0 <= t <= flight -> scope S0 Step.context_meanwhile (at_time w Step.number_of_t t).
Proof. in_flight S0 well Step.the_table_is Step.all_right inside. Qed.
Lemma colliding_apart t : 0 <= t < flight ->
  1 < (1 + d) * (1 + d) + (1 + d) * t * - y + t * (1 + d) * - y + t * t * A.
Proof. intros T. row_of (at_time w Step.number_of_s t) Step.row_of_colliding_pair_apart_is (before t T). Qed.
Lemma spectator_apart t : 0 <= t <= flight ->
  1 + 2 * t * eta_s <= 1 + t * eta_s + t * eta_s + t * t * B.
Proof. intros T. row_of (at_time w Step.number_of_t t) Step.row_of_spectator_apart_is (meanwhile t T). Qed.
Lemma outer_apart t : 0 <= t <= flight ->
  1 < 1 - 2 * (1 + d) * - C + (1 + d) ^ 2 + 2 * t * (eta_s - a - (1 + d) * b + (1 + d) * - y)
    + t ^ 2 * (A + B - 2 * n).
Proof.
  intros T.
  assert (Q : 1 < (-1) * (-1) + (-1) * (t * (-1)) * eta_s + (-1) * (1 + d) * (- C) + (-1) * t * a
    + t * (-1) * (-1) * eta_s + t * (-1) * (t * (-1)) * B + t * (-1) * (1 + d) * b + t * (-1) * t * n
    + (1 + d) * (-1) * (- C) + (1 + d) * (t * (-1)) * b + (1 + d) * (1 + d) + (1 + d) * t * (- y)
    + t * (-1) * a + t * (t * (-1)) * n + t * (1 + d) * (- y) + t * t * A)
    by row_of (at_time w Step.number_of_t t) Step.row_of_outer_pair_apart_is (meanwhile t T).
  apply (Rlt_le_trans _ _ _ Q), Req_le. ring.
Qed.

(* --- the scene -------------------------------------------------------------------------------- *)

Theorem step_is_certified : step_certified (numbers_of w) flight.
Proof.
  split; [exact flight_positive | exact recedes | exact far | exact far_after | exact touching
    | exact approaching | exact colliding_apart | exact spectator_apart | exact outer_apart].
Qed.
Lemma new_numbers : numbers_of new = after_step r (numbers_of w) flight.
Proof.
  unfold numbers_of. rewrite (new_value Step.number_of_y _ eq_refl),
    (new_value Step.number_of_eta_s _ eq_refl), (new_value Step.number_of_C _ eq_refl),
    (new_value Step.number_of_a _ eq_refl), (new_value Step.number_of_b _ eq_refl),
    (new_value Step.number_of_A _ eq_refl), (new_value Step.number_of_B _ eq_refl),
    (new_value Step.number_of_w _ eq_refl), (new_value Step.number_of_d _ eq_refl).
  unfold after_step, after_sharing. f_equal; try reflexivity.
  transitivity (Step.A_next r y b A B n d).
  - reflexivity.
  - unfold Step.A_next, impact.
    cbn [AnyStep.y AnyStep.A AnyStep.d AnyStep.B AnyStep.b AnyStep.w]. unfold Step.kappa. fold flight.
    ring.
Qed.
Variable D : nat.  (* the dimension *)
Variable x : scene.
Variable i j : ball.
Hypothesis others : i <> B0 /\ j <> B0 /\ i <> j.
Hypothesis shown_by : shows w D x i j.

Theorem meets : first_to_meet D x B0 j flight.
Proof. exact (AnyStep.meets _ _ step_is_certified D x i j others shown_by). Qed.
Theorem shows_next : shows new D (collided D r B0 j (later flight x)) j i.
Proof.
  unfold shows. rewrite new_numbers.
  exact (AnyStep.shows_next _ _ _ step_is_certified D x i j others shown_by).
Qed.
End OneStep.
