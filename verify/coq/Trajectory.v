(* From one step to the whole motion: for all numbers and scenes that satisfy the conditions of the
   step, ball 0 collides with the others in turn without end, the times of the collisions converge,
   and so does the angle at ball 0. *)
From Coq Require Import Reals List Lra Lia Arith.
From Verify Require Import Theorem1 Vectors Motion Sequences Meaning Terms Readable Extension Gram OneStep.
From Verify Require AnyStep Step.
Open Scope R_scope.

Section Trajectory.
(* Numbers that satisfy the conditions on the parameters and on the start, and a scene with them. *)
Variable v : valuation.
Hypothesis good_start : scope S0 start_context v.
Variable D : nat.
Variable first : scene.
Hypothesis shown_first : shows (after S0 v start) D first B1 B2.

Notation at_step := (state S0 v start next).
(* Coq sees this at once, without a look at the terms of the certificate: Terms.v has them looked up last. *)
Lemma after_a_step n x : 0 < at_step (S n) x -> 0 < after S0 (at_step n) next x.
Proof. trivial. Qed.
Fixpoint scenes (n : nat) : scene :=
  match n with
  | O => first
  | S k => collided D (v Step.number_of_r) B0 (collides_with k) (later (flight (at_step k)) (scenes k))
  end.

Lemma in_turn n : collides_with (S n) <> B0 /\ collides_with n <> B0 /\
  collides_with (S n) <> collides_with n.
Proof.
  unfold collides_with. rewrite Nat.even_succ, <- Nat.negb_even.
  destruct (Nat.even n); cbn; repeat split; discriminate.
Qed.
Lemma next_state n : at_step (S n) = new (at_step n).
Proof. reflexivity. Qed.
Lemma kept_value n x : put next x = None -> put start x = None -> at_step n x = v x.
Proof.
  intros N P. induction n as [|n IH]; cbn [state]; unfold after; [now rewrite P | now rewrite N].
Qed.
Lemma good_after n :
  (forall k, (k <= n)%nat -> shows (at_step k) D (scenes k) (collides_with (S k)) (collides_with k)) ->
  scope S0 state_context (at_step n).
Proof.
  intros V. destruct (Step.always v good_start) as [_ A]. destruct (A n) as [B _]; [|exact B].
  intros k K. destruct (V k K) as (q & _ & Q). now apply vectors_standing in Q.
Qed.
Lemma always_shown n : forall k, (k <= n)%nat ->
  shows (at_step k) D (scenes k) (collides_with (S k)) (collides_with k).
Proof.
  induction n as [|n IH]; intros k K.
  - replace k with O by lia. exact shown_first.
  - apply Nat.le_succ_r in K. destruct K as [K|K]; [now apply IH|]. subst k.
    pose proof (shows_next _ (good_after n IH) D _ _ _ (in_turn n) (IH n (Nat.le_refl n))) as N.
    rewrite (kept_value n Step.number_of_r eq_refl eq_refl) in N. exact N.
Qed.
Lemma always_good n : scope S0 state_context (at_step n).
Proof. exact (good_after n (always_shown n)). Qed.

Definition time (n : nat) : R := at_step n Step.number_of_clock.
Definition cosine (n : nat) : R := at_step n Step.number_of_C.

Theorem scenes_collide_in_turn : collides_in_turn D (v Step.number_of_r) scenes time.
Proof.
  intros n. replace (time (S n) - time n) with (flight (at_step n)).
  - split; [|reflexivity].
    exact (meets _ (always_good n) D _ _ _ (in_turn n) (always_shown n n (Nat.le_refl n))).
  - unfold time. rewrite next_state, clock_next. ring.
Qed.
Lemma cosine_is n : minus_cosine D (scenes n) = cosine n.
Proof.
  exact (AnyStep.cosine_of _ _ _ _ _ (always_shown n n (Nat.le_refl n)) (in_turn n)
    (far _ (always_good n))).
Qed.
Lemma time_next n : time (S n) = time n + flight (at_step n).
Proof. unfold time. now rewrite next_state, clock_next. Qed.
Lemma time_bounded n : time n <= v Step.number_of_T_star.
Proof.
  rewrite <- (kept_value n Step.number_of_T_star eq_refl eq_refl).
  exact (clock_bounded _ (always_good n)).
Qed.
Theorem finite_time : exists t, Un_cv time t /\ t <= v Step.number_of_T_star.
Proof.
  destruct (bounded_increasing_converges time (v Step.number_of_T_star)) as [t L].
  - intros n. rewrite time_next. pose proof (flight_positive _ (always_good n)). lra.
  - exact time_bounded.
  - exists t. split; trivial. exact (limit_at_most _ _ _ L time_bounded).
Qed.
(* The angle moves by no more than the distances and times add up to. *)
Theorem angle_converges : exists l, Un_cv cosine l /\ Rabs (l - v Step.number_of_c) <= drift v.
Proof.
  set (speed := sqrt (v Step.number_of_V_1)). set (gap := fun n => at_step n Step.number_of_d).
  assert (P : 0 <= speed) by apply sqrt_pos.
  assert (V : forall n, at_step n Step.number_of_V_1 = v Step.number_of_V_1)
    by (intros n; now apply kept_value).
  assert (F : forall n, flight (at_step n) = time (S n) - time n) by (intros n; rewrite time_next; ring).
  assert (G : forall n, gap (S n) <= 3 / 2 * speed * (time (S n) - time n)).
  { intros n. pose proof (distance_next _ (always_good n)) as A.
    rewrite <- next_state, V, F in A. exact A. }
  assert (U : forall n, cosine (S n) - cosine n <=
    gap n + gap (S n) + 4 * speed * (time (S n) - time n)).
  { intros n. pose proof (cosine_up _ (always_good n)) as A.
    rewrite <- next_state, V, F in A. exact A. }
  assert (L : forall n, cosine n - cosine (S n) <=
    gap n + gap (S n) + 4 * speed * (time (S n) - time n)).
  { intros n. pose proof (cosine_down _ (always_good n)) as A.
    rewrite <- next_state, V, F in A. exact A. }
  set (w := fun n => 3 / 2 * speed * time n + 11 / 2 * speed * time (S n)).
  destruct (bounded_variation_converges (fun n => cosine (S n)) w
    (3 / 2 * speed * v Step.number_of_T_star + 11 / 2 * speed * v Step.number_of_T_star)) as [l C].
  - intros n. pose proof (U (S n)). pose proof (G n). pose proof (G (S n)). unfold w. lra.
  - intros n. pose proof (L (S n)). pose proof (G n). pose proof (G (S n)). unfold w. lra.
  - intros n. unfold w. apply Rplus_le_compat; apply Rmult_le_compat_l; try apply time_bounded; lra.
  - assert (N : forall n, Rabs (cosine (S n) - v Step.number_of_c) <= drift v).
    { intros n. pose proof (cosine_near _ (always_good n)) as A. pose proof (kept_value n) as K.
      unfold drift in *. rewrite <- next_state in A.
      rewrite (K Step.number_of_c), (K Step.number_of_Delta_theta), (K Step.number_of_d_bar),
        (K Step.number_of_C_eta), V, (K Step.number_of_V_0), (K Step.number_of_eta_bar) in A
        by reflexivity.
      exact A. }
    exists l. split; [now apply limit_after_one | exact (limit_within _ _ _ _ C N)].
Qed.
End Trajectory.
