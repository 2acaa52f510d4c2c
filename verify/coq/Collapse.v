(* From a scene of the initial set, ball 0 collides with 2 and 1 in turn without end: the certificates
   of the step and of theorem1 --all, put together. Step.v and All.v are what
   `verify export coq --readable` prints for them. *)
From Coq Require Import Reals ZArith List Lra Lia FMapPositive.
From Verify Require Import Theorem1 Vectors Motion Sequences Meaning Terms Citations Readable Extension.
From Verify Require Import Gram OneStep Trajectory.
From Verify Require Step All.
Import ListNotations.
Open Scope R_scope.

Notation S1 := All.the_statement.
(* What theorem1 --all cites is what the certificate of the step proves. *)
Lemma beginning : begins S0 S1 (size S0 S1) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma citations : citations_true S1.
Proof.
  apply (citations_closed [(S0, size S0 S1)]); [vm_compute; reflexivity|].
  apply Forall_cons; [exact Step.proved | constructor].
Qed.

(* The row that applies the step to the constants. *)
Definition the_application := Eval vm_compute in
  match find (fun r => match row_sentence r with Applies _ _ => true | _ => false end) (rows S1) with
  | Some (Row _ c _ _ (Applies d at_)) => (c, d, at_)
  | _ => (0%nat, 0%nat, [])
  end.
Definition everywhere := Eval vm_compute in fst (fst the_application).
Definition numbers_context := Eval vm_compute in snd (fst the_application).
Definition constants := Eval vm_compute in snd the_application.

Section Parameters.
Variables r c V_0 delta_theta : R.
Hypothesis good : admissible r c V_0 delta_theta.

Definition parameters : valuation := fun x =>
  if Pos.eqb x All.number_of_r then r else if Pos.eqb x All.number_of_c then c
  else if Pos.eqb x All.number_of_V_0 then V_0 else delta_theta.
Definition the_hypotheses := Eval vm_compute in map (fun a => read_claim All.the_table (given_claim a))
  (flat_map (givens_of S1) (rev (around S1 everywhere))).
Lemma the_hypotheses_are : map (fun a => read_claim All.the_table (given_claim a))
  (flat_map (givens_of S1) (rev (around S1 everywhere))) = the_hypotheses.
Proof. vm_compute. reflexivity. Qed.
Lemma parameters_good : scope S1 everywhere parameters.
Proof.
  apply (scope_shown S1 All.the_order All.the_table All.the_table_is _ _ _ All.all_right).
  rewrite the_hypotheses_are. destruct good as [[G1 G2] [G3 G4] G5 G6 G7]. unfold the_hypotheses.
  repeat (apply Forall_cons; [first [exact G1 | exact G2 | exact G3 | exact G4 | exact G5
    | exact G6 | exact G7]|]). apply Forall_nil.
Qed.

(* The constants as the numbers of the step. *)
Definition numbers : valuation := after S1 parameters constants.
Lemma number x t : put constants x = Some t ->
  numbers x = show S1 All.all_values parameters (read All.the_table 400 t).
Proof.
  intros E. rewrite (read_right S1 All.the_order All.the_table All.the_table_is _ _ All.all_right).
  unfold numbers, after. now rewrite E.
Qed.
(* They are those of Theorem1.v, since both are the same formulas. *)
Lemma number_c : numbers Step.number_of_c = c.
Proof. exact (number Step.number_of_c _ eq_refl). Qed.
Lemma number_r : numbers Step.number_of_r = r.
Proof. exact (number Step.number_of_r _ eq_refl). Qed.
Lemma number_V_0 : numbers Step.number_of_V_0 = V_0.
Proof. exact (number Step.number_of_V_0 _ eq_refl). Qed.
Lemma number_V_1 : numbers Step.number_of_V_1 = V_1 r c V_0.
Proof. exact (number Step.number_of_V_1 _ eq_refl). Qed.
Lemma number_phi_minus : numbers Step.number_of_phi_minus = phi_minus r c.
Proof. exact (number Step.number_of_phi_minus _ eq_refl). Qed.
Lemma number_x_0 : numbers Step.number_of_x_0 = x_0 r c V_0.
Proof. exact (number Step.number_of_x_0 _ eq_refl). Qed.
Lemma number_Delta_theta : numbers Step.number_of_Delta_theta = Delta_theta r c V_0 delta_theta.
Proof. exact (number Step.number_of_Delta_theta _ eq_refl). Qed.
Lemma number_eta_bar : numbers Step.number_of_eta_bar = eta_bar r c V_0 delta_theta.
Proof. exact (number Step.number_of_eta_bar _ eq_refl). Qed.
Lemma number_d_slope : numbers Step.number_of_d_slope = d_slope r c V_0.
Proof. exact (number Step.number_of_d_slope _ eq_refl). Qed.
Lemma number_d_const : numbers Step.number_of_d_const = d_const r c V_0 delta_theta.
Proof. exact (number Step.number_of_d_const _ eq_refl). Qed.
Lemma number_T_star : numbers Step.number_of_T_star = T_star r c V_0 delta_theta.
Proof. exact (number Step.number_of_T_star _ eq_refl). Qed.
Lemma number_C_eta : numbers Step.number_of_C_eta = C_eta r c.
Proof. exact (number Step.number_of_C_eta _ eq_refl). Qed.
Lemma number_d_bar : numbers Step.number_of_d_bar = All.repaired_d_bar r c V_0 delta_theta.
Proof. exact (number Step.number_of_d_bar _ eq_refl). Qed.
Lemma numbers_good : scope S0 numbers_context numbers.
Proof.
  assert (A : scope S1 numbers_context numbers)
    by exact (proj2 (All.collapse citations parameters parameters_good)).
  apply (scope_same S0 S1 (size S0 S1) beginning); [vm_compute; lia | exact A].
Qed.
(* Each given of the step, for these numbers. *)
Definition the_givens := Eval vm_compute in
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 numbers_context).
Lemma the_givens_are :
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 numbers_context) = the_givens.
Proof. vm_compute. reflexivity. Qed.
Lemma given_number g :
  (if in_dec same_shown g the_givens then true else false) = true -> shown_here numbers g.
Proof.
  intros G. destruct (in_dec _ _ _) as [J|]; [clear G | discriminate].
  rewrite <- the_givens_are in J. apply in_map_iff in J. destruct J as (a & <- & J).
  apply (read_claim_right S0 Step.the_order Step.the_table Step.the_table_is _ _ _ Step.all_right).
  pose proof (numbers_good numbers_context) as A. unfold satisfies in A. rewrite Forall_forall in A.
  exact (A (or_introl eq_refl) a J).
Qed.

(* A scene of the initial set, and its numbers. *)
Variable D : nat.
Variable s : scene.
Variables d_0 y : R.
Hypothesis good_scene : initial r c V_0 delta_theta D s d_0 y.

Notation p := (to s B0 B1).
Notation q := (scaled (/ (1 + d_0)) (to s B0 B2)).
Notation w_s := (relative s B0 B1).
Notation w_c := (relative s B0 B2).
Definition starting : valuation := fun x =>
  if Pos.eqb x Step.number_of_y_start then y
  else if Pos.eqb x Step.number_of_eta_s_start then rate D s B0 B1
  else if Pos.eqb x Step.number_of_C_start then minus_cosine D s
  else if Pos.eqb x Step.number_of_a_start then dot D p w_c
  else if Pos.eqb x Step.number_of_b_start then dot D q w_s
  else if Pos.eqb x Step.number_of_A_start then dot D w_c w_c
  else if Pos.eqb x Step.number_of_B_start then dot D w_s w_s
  else if Pos.eqb x Step.number_of_w_start then dot D w_s w_c
  else d_0.
Definition start_keys := Eval vm_compute in
  match context_at S0 start_context with Some x => variables x | None => [] end.
Definition at_start : valuation := extended numbers start_keys starting.
Lemma same_number x : existsb (Pos.eqb x) start_keys = false -> at_start x = numbers x.
Proof. unfold at_start, extended. now intros ->. Qed.
Definition the_start := Eval vm_compute in
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 start_context).
Lemma the_start_is :
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 start_context) = the_start.
Proof. vm_compute. reflexivity. Qed.
Lemma start_good : scope S0 start_context at_start.
Proof.
  apply (scope_extended S0 well Step.the_table start_context numbers start_keys starting
    Step.the_table_is).
  - unfold start_context. lia.
  - vm_compute. reflexivity.
  - exact numbers_good.
  - fold at_start.
    assert (A : Forall (shown_here at_start) the_start).
    { destruct good_scene as [_ _ _ G1 [G2 G3] G4 [G5 G6] [G7 G8] [G9 G10] G11].
      apply within in G4, G11. destruct G4 as [G12 G4], G11 as [G13 G11].
      assert (G14 : c - minus_cosine D s <= Delta_theta r c V_0 delta_theta / 4) by lra.
      pose proof (Rle_trans _ _ _ G6 (Rmin_l _ _)) as G15.
      pose proof (Rle_trans _ _ _ G6 (Rmin_r _ _)) as G16. clear G6 G13.
      rewrite <- number_eta_bar in G3. rewrite <- number_phi_minus, <- number_x_0 in G4, G12.
      rewrite <- number_V_1, <- number_V_0 in G7, G8, G9, G10.
      rewrite <- number_Delta_theta, <- number_c in G11, G14.
      rewrite <- number_d_const in G15. rewrite <- number_d_slope in G16.
      unfold the_start. repeat (apply Forall_cons; [first [exact G1 | exact G2 | exact G3 | exact G4
        | exact G5 | exact G7 | exact G8 | exact G9 | exact G10 | exact G11 | exact G12 | exact G14
        | exact G15 | exact G16]|]). apply Forall_nil. }
    rewrite <- the_start_is in A. unfold satisfies. rewrite Forall_map in A. revert A.
    apply Forall_impl. intros g.
    apply (read_claim_right S0 Step.the_order Step.the_table Step.the_table_is _ _ _ Step.all_right).
Qed.

Lemma started x t : put start x = Some t ->
  after S0 at_start start x = show S0 Step.all_values at_start (read Step.the_table 400 t).
Proof.
  intros E. rewrite (read_right S0 Step.the_order Step.the_table Step.the_table_is _ _ Step.all_right).
  unfold after. now rewrite E.
Qed.
Ltac at_the_start x a :=
  replace (after S0 at_start start x) with a by (symmetry; exact (started x _ eq_refl)).
Lemma start_shown : shows (after S0 at_start start) D s B1 B2.
Proof.
  destruct good_scene as [G1 G2 G3 _ _ _ [G4 _] _ _ _]. exists q. split; [|split].
  - at_the_start Step.number_of_d d_0. apply same_vector. intros k. unfold scaled. field. lra.
  - change (square D s B0 B1 = 1). rewrite square_of_distance, G3. ring.
  - rewrite dot_scaled, dot_scaled_right.
    change (dot D (to s B0 B2) (to s B0 B2)) with (square D s B0 B2).
    rewrite square_of_distance, G1. field. lra.
  - at_the_start Step.number_of_C (minus_cosine D s). unfold minus_cosine.
    rewrite dot_scaled_right, G1, G3. field. lra.
  - at_the_start Step.number_of_eta_s (rate D s B0 B1). reflexivity.
  - at_the_start Step.number_of_y y. rewrite dot_scaled. fold (rate D s B0 B2). rewrite G2.
    field. lra.
  - at_the_start Step.number_of_a (dot D p w_c). reflexivity.
  - at_the_start Step.number_of_b (dot D q w_s). reflexivity.
  - at_the_start Step.number_of_B (dot D w_s w_s). reflexivity.
  - at_the_start Step.number_of_A (dot D w_c w_c). reflexivity.
  - at_the_start Step.number_of_w (dot D w_s w_c). reflexivity.
Qed.
Lemma drift_small : drift at_start <= Delta_theta r c V_0 delta_theta.
Proof.
  unfold drift. rewrite !same_number by reflexivity.
  rewrite number_Delta_theta, number_d_bar, number_C_eta, number_V_1, number_V_0, number_eta_bar.
  exact (row_in_scope S1 All.the_order All.the_table All.the_table_is (All.the_rows_hold citations)
    All.all_values _ _ _ parameters All.all_right All.row_of_repaired_angle_absorbed_is parameters_good).
Qed.
Definition without_end : Prop :=
  exists (scenes : nat -> scene) (time : nat -> R),
    scenes O = s /\ time O = 0 /\ collides_in_turn D r scenes time /\
    (exists T, Un_cv time T /\ T <= T_star r c V_0 delta_theta) /\
    (exists l, Un_cv (fun n => minus_cosine D (scenes n)) l /\
      Rabs (l - c) <= Delta_theta r c V_0 delta_theta).
Theorem collides_without_end : without_end.
Proof.
  exists (scenes at_start D s), (time at_start).
  split; [reflexivity|]. split; [|split; [|split]].
  - transitivity (IZR 0); [exact (started Step.number_of_clock _ eq_refl) | reflexivity].
  - pose proof (scenes_collide_in_turn at_start start_good D s start_shown) as A.
    rewrite same_number, number_r in A by reflexivity. exact A.
  - destruct (finite_time at_start start_good D s start_shown) as (T & L & B). exists T.
    split; trivial. now rewrite same_number, number_T_star in B by reflexivity.
  - destruct (angle_converges at_start start_good D s start_shown) as (l & L & B). exists l. split.
    + intros e E. destruct (L e E) as [m M]. exists m. intros n N.
      rewrite (cosine_is at_start start_good D s start_shown). exact (M n N).
    + rewrite same_number, number_c in B by reflexivity.
      exact (Rle_trans _ _ _ B drift_small).
Qed.
End Parameters.
