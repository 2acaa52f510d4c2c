(* From a scene of the initial set, ball 0 collides with 2 and 1 in turn without end: the certificates
   of the step and of theorem1 --all, put together. Step.v and All.v are what
   `verify.wire.coq.named` prints for them, with the rows that are named. *)
From Coq Require Import Reals ZArith List Lra Lia FMapPositive.
From Verify Require Import Theorem1 Vectors Motion Sequences Meaning Terms Citations Readable Extension.
From Verify Require Import Gram OneStep Trajectory FromNumbers.
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
Lemma applies_there : snd (fst the_application) = numbers_context.
Proof. reflexivity. Qed.
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
Proof. exact (substituted S1 All.the_order _ All.the_table_is _ All.all_right _ _ _ _). Qed.
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
Lemma given_number g :
  (if in_dec same_shown g the_givens then true else false) = true -> shown_here numbers g.
Proof. exact (given_of_numbers numbers numbers_good g). Qed.

(* A scene of the initial set, and its numbers. *)
Variable D : nat.
Variable s : scene.
Variables d_0 y : R.
Hypothesis good_scene : initial r c V_0 delta_theta D s d_0 y.

(* The set is that of Theorem1.v. *)
Lemma scene_with_constants : initial_with (phi_minus r c) (x_0 r c V_0)
  (eta_bar r c V_0 delta_theta) (d_const r c V_0 delta_theta) (d_slope r c V_0) V_0 (V_1 r c V_0)
  (Delta_theta r c V_0 delta_theta) c D s d_0 y <-> initial r c V_0 delta_theta D s d_0 y.
Proof. split; intros [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10]; split; assumption. Qed.
Lemma scene_with_numbers : initial_with (numbers Step.number_of_phi_minus)
  (numbers Step.number_of_x_0) (numbers Step.number_of_eta_bar) (numbers Step.number_of_d_const)
  (numbers Step.number_of_d_slope) (numbers Step.number_of_V_0) (numbers Step.number_of_V_1)
  (numbers Step.number_of_Delta_theta) (numbers Step.number_of_c) D s d_0 y.
Proof.
  rewrite number_eta_bar, number_phi_minus, number_x_0, number_V_1, number_V_0, number_Delta_theta,
    number_c, number_d_const, number_d_slope.
  now apply scene_with_constants.
Qed.
Let start_values : valuation := at_start numbers D s d_0 y.
Lemma drift_small : drift start_values <= Delta_theta r c V_0 delta_theta.
Proof.
  unfold drift, start_values. rewrite !same_number by reflexivity.
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
  pose proof (scenes_in_turn numbers numbers_good D s d_0 y scene_with_numbers) as C.
  pose proof (ends_by numbers numbers_good D s d_0 y scene_with_numbers) as E.
  destruct (angle_tends numbers numbers_good D s d_0 y scene_with_numbers) as (l & L & B).
  rewrite number_r in C. rewrite number_T_star in E. rewrite number_c in B.
  exists (scenes start_values D s), (time start_values).
  split; [reflexivity|]. split; [apply clock_starts|]. split; [exact C|]. split; [exact E|].
  exists l. split; [exact L | exact (Rle_trans _ _ _ B drift_small)].
Qed.
End Parameters.
