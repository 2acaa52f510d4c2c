(* The sharper theorem on trajectories: if a scene has the numbers of a start that its certificate
   admits, then ball 0 collides with 2 and 1 in turn without end, and the balls collapse, by the time
   and at the angle that the certificate says. *)
From Coq Require Import Reals List Lra Lia Arith.
From Verify Require Import Theorem1 Vectors Motion Sequences InTurn Ending Meaning Terms Readable.
From Verify Require Import Extension AnyStep SharperStep.
From Verify Require Trajectory Sharper.
Open Scope R_scope.

Section SharperCollapse.
(* Numbers that satisfy the conditions on the start, and a scene with them. *)
Variable v : valuation.
Hypothesis good_start : scope SS start_context v.
Variable D : nat.
Variable first : scene.
Hypothesis shown_first : has (numbers_of (after SS v start)) D first B1 B2.
Let r : R := v Sharper.number_of_r.

Definition at_step : nat -> valuation := state SS v start next.
Fixpoint scenes (n : nat) : scene :=
  match n with
  | O => first
  | S k => collided D (v Sharper.number_of_r) B0 (collides_with k) (later (flight (at_step k)) (scenes k))
  end.
Definition shown_at (k : nat) : Prop :=
  has (numbers_of (at_step k)) D (scenes k) (collides_with (S k)) (collides_with k).

Lemma next_state n : at_step (S n) = new (at_step n).
Proof. reflexivity. Qed.
Lemma kept_value n x : put next x = None -> put start x = None -> at_step n x = v x.
Proof.
  intros N P. unfold at_step. induction n as [|n IH]; cbn [state]; unfold after; [now rewrite P|].
  now rewrite N.
Qed.
Lemma good_after n : (forall k, (k <= n)%nat -> shown_at k) -> scope SS state_context (at_step n).
Proof.
  intros V. destruct (Sharper.always citations v good_start) as [_ G]. destruct (G n) as [P _]; [|exact P].
  intros k K. destruct (V k K) as (q & _ & Q). now apply vectors_standing in Q.
Qed.
Lemma always_shown n : forall k, (k <= n)%nat -> shown_at k.
Proof.
  induction n as [|n IH]; intros k K.
  - replace k with O by lia. exact shown_first.
  - apply Nat.le_succ_r in K. destruct K as [K|K]; [now apply IH|]. subst k.
    pose proof (good_after n IH) as G. unfold shown_at. rewrite next_state, new_numbers.
    rewrite (kept_value n Sharper.number_of_r eq_refl eq_refl).
    exact (shows_next _ _ _ (sharper_step _ G) D _ _ _ (Trajectory.in_turn n) (IH n (Nat.le_refl n))).
Qed.
Lemma always_good n : scope SS state_context (at_step n).
Proof. exact (good_after n (always_shown n)). Qed.

Definition time (n : nat) : R := at_step n Sharper.number_of_clock.
Lemma time_next n : time (S n) = time n + flight (at_step n).
Proof. unfold time. rewrite next_state. exact (new_value _ Sharper.number_of_clock _ eq_refl). Qed.
Lemma started x t : put start x = Some t ->
  after SS v start x = show SS Sharper.all_values v (read Sharper.the_table 400 t).
Proof. exact (substituted SS Sharper.the_order _ Sharper.the_table_is _ Sharper.all_right _ _ _ _). Qed.
Lemma clock_starts : time O = 0.
Proof. exact (started Sharper.number_of_clock _ eq_refl). Qed.
Lemma flight_positive n : 0 < flight (at_step n).
Proof. exact (takes_time _ _ _ (sharper_step _ (always_good n))). Qed.
Lemma collide_in_turn : collides_in_turn D r scenes time.
Proof.
  intros n. replace (time (S n) - time n) with (flight (at_step n)) by (rewrite time_next; ring).
  split; [|reflexivity].
  exact (meets _ _ (sharper_step _ (always_good n)) D _ _ _ (Trajectory.in_turn n)
    (always_shown n n (Nat.le_refl n))).
Qed.

(* The time by which they collapse. *)
Definition latest : R := Sharper.duration (v Sharper.number_of_p) (v Sharper.number_of_Y)
  (v Sharper.number_of_T) * v Sharper.number_of_eta_0.
Lemma time_bounded n : time n <= latest.
Proof.
  assert (K : time n <= Sharper.duration (at_step n Sharper.number_of_p)
    (at_step n Sharper.number_of_Y) (at_step n Sharper.number_of_T) *
    at_step n Sharper.number_of_eta_0)
    by row_of (at_step n) Sharper.row_of_time_total_is (always_good n).
  now rewrite !kept_value in K by reflexivity.
Qed.
Lemma angle_stays n : Rabs (minus_cosine D (scenes n) - v Sharper.number_of_C_0) <=
  v Sharper.number_of_Theta.
Proof.
  pose proof (always_good n) as G. pose proof (far _ _ _ (sharper_step _ G)) as F.
  rewrite (cosine_of _ _ _ _ _ (always_shown n n (Nat.le_refl n)) (Trajectory.in_turn n) F).
  assert (U : at_step n Sharper.number_of_C - at_step n Sharper.number_of_C_0 <=
    at_step n Sharper.number_of_Theta) by row_of (at_step n) Sharper.row_of_angle_final_upper_is G.
  assert (L : at_step n Sharper.number_of_C_0 - at_step n Sharper.number_of_C <=
    at_step n Sharper.number_of_Theta) by row_of (at_step n) Sharper.row_of_angle_final_lower_is G.
  pose proof (kept_value n Sharper.number_of_C_0 eq_refl eq_refl) as E1.
  pose proof (kept_value n Sharper.number_of_Theta eq_refl eq_refl) as E2.
  unfold numbers_of. cbn [C]. rewrite E1, E2 in *. apply Rabs_le. lra.
Qed.
Lemma restitution_good : 0 < r < 1.
Proof.
  assert (L : 0 < 1 - r) by row_of v Sharper.row_of_r_below_one_is good_start.
  assert (P : shown_here (at_step 0) (Less, Whole 0, Named Sharper.number_of_r)).
  { apply (condition _ _ (always_good 0)). vm_compute. reflexivity. }
  change (0 < at_step 0 Sharper.number_of_r) in P. rewrite kept_value in P by reflexivity.
  fold r in P. lra.
Qed.
Theorem sharper_collapse : collapse D r first latest
  (v Sharper.number_of_C_0) (v Sharper.number_of_Theta).
Proof.
  destruct (bounded_increasing_converges time latest) as [T L].
  - intros n. rewrite time_next. pose proof (flight_positive n). lra.
  - exact time_bounded.
  - pose proof (in_turn_collapses D r restitution_good scenes time T clock_starts collide_in_turn L)
      as P.
    exists scenes, time, T. do 2 eexists. split; [exact P|].
    split; [exact (limit_at_most _ _ _ L time_bounded)|].
    exact (limit_within _ _ _ _ (Theorem1.angle_converges _ _ _ _ _ _ _ _ P) angle_stays).
Qed.
End SharperCollapse.
Lemma first_numbers v : numbers_of (after SS v start) = Numbers (v Sharper.number_of_y_start)
  (v Sharper.number_of_eta_s_start) (v Sharper.number_of_C_start) (v Sharper.number_of_a_start)
  (v Sharper.number_of_b_start) (v Sharper.number_of_A_start) (v Sharper.number_of_B_start)
  (v Sharper.number_of_w_start) (v Sharper.number_of_d_start).
Proof.
  unfold numbers_of. f_equal; match goal with |- after _ _ _ ?x = _ => exact (started v x _ eq_refl) end.
Qed.
