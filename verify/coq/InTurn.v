(* Where ball 0 collides with 2 and 1 in turn, at times that converge: there is a trajectory with just
   these collisions until the limit of the times, and none goes beyond. *)
From Coq Require Import Reals Lra Lia ClassicalDedekindReals.
From Verify Require Import Theorem1 Vectors Motion Determined.
Open Scope R_scope.

Section InTurn.
Variable d : nat.
Variable r : R.
Hypothesis restitutes : 0 < r < 1.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variable T : R.
Hypothesis time_0 : time O = 0.
Hypothesis in_turn : collides_in_turn d r scenes time.
Hypothesis converges : Un_cv time T.

Notation partner n := (collides_with n).
Lemma partner_not_0 n : partner n <> B0.
Proof. unfold collides_with. destruct Nat.even; discriminate. Qed.

(* --- the times -------------------------------------------------------------------------------- *)

Lemma time_grows n : time n < time (S n).
Proof. destruct (in_turn n) as [[A _ _ _ _] _]. lra. Qed.
Lemma time_monotone n m : (n <= m)%nat -> time n <= time m.
Proof. intros L. induction L as [|m L IH]; [lra|]. pose proof (time_grows m). lra. Qed.
Lemma time_before_T n : time n < T.
Proof.
  apply Rlt_le_trans with (time (S n)); [apply time_grows|]. apply Rnot_lt_le. intros N.
  destruct (converges (time (S n) - T)) as [m M]; [lra|].
  specialize (M (Nat.max m (S n)) (Nat.le_max_l _ _)).
  pose proof (time_monotone _ _ (Nat.le_max_r m (S n))). unfold R_dist, Rabs in M.
  destruct Rcase_abs; lra.
Qed.
Lemma time_above t : t < T -> exists n, t < time n.
Proof.
  intros L. destruct (converges (T - t)) as [m M]; [lra|]. exists m.
  specialize (M m (Nat.le_refl m)). unfold R_dist, Rabs in M. destruct Rcase_abs; lra.
Qed.

(* How many collisions there have been. *)
Fixpoint counted (t : R) (n : nat) : nat :=
  match n with O => O | S k => if Rle_dec (time (S k)) t then S k else counted t k end.
Lemma counted_right t n : 0 <= t < time (S n) -> time (counted t n) <= t < time (S (counted t n)).
Proof.
  induction n as [|n IH]; cbn; intros H; [rewrite time_0; lra|].
  destruct Rle_dec as [L|L]; [lra | apply IH; lra].
Qed.
Definition stage (t : R) : nat :=
  match sig_forall_dec (fun n => time n <= t) (fun n => Rle_dec (time n) t) with
  | inleft (exist _ n _) => counted t n
  | inright _ => O
  end.
Lemma stage_right t : 0 <= t < T -> time (stage t) <= t < time (S (stage t)).
Proof.
  intros H. unfold stage. destruct sig_forall_dec as [[n N]|N].
  - apply counted_right. pose proof (time_grows n). lra.
  - destruct (time_above t ltac:(lra)) as [n M]. specialize (N n). lra.
Qed.
Lemma same_stage t n m : time n <= t < time (S n) -> time m <= t < time (S m) -> n = m.
Proof.
  intros N M. destruct (Nat.lt_trichotomy n m) as [L|[L|L]]; trivial; exfalso.
  - pose proof (time_monotone (S n) m L). lra.
  - pose proof (time_monotone (S m) n L). lra.
Qed.

(* --- the trajectory --------------------------------------------------------------------------- *)

Definition course (t : R) : scene := later (t - time (stage t)) (scenes (stage t)).
Lemma course_between n t : time n <= t < time (S n) -> course t = later (t - time n) (scenes n).
Proof.
  intros N. unfold course. pose proof (time_before_T (S n)). pose proof (time_monotone 0 n ltac:(lia)).
  assert (M : 0 <= t < T) by lra. now rewrite (same_stage t (stage t) n (stage_right t M) N).
Qed.
Lemma course_at n : course (time n) = scenes n.
Proof.
  pose proof (time_grows n). rewrite (course_between n) by lra.
  replace (time n - time n) with 0 by ring. apply later_0.
Qed.
Lemma no_collision s : (forall i j, i <> j -> 1 < distance d s i j) -> nobody_collides d s.
Proof. intros A i j N. specialize (A i j N). lra. Qed.
Theorem course_is_trajectory : trajectory d r (scenes O) T course.
Proof.
  split.
  - rewrite <- time_0. apply course_at.
  - intros t H. pose proof (stage_right t H) as S. set (n := stage t) in *.
    exists (time (Datatypes.S n) - t). split; [lra|]. intros u U.
    rewrite !(course_between n) by lra. rewrite later_later. f_equal. ring.
  - intros t H. pose proof (stage_right t ltac:(lra)) as S. set (n := stage t) in *.
    destruct (in_turn n) as [[_ A _ _ _] _].
    destruct (Rle_lt_or_eq_dec _ _ (proj1 S)) as [P|P].
    + exists (t - time n), (course t). split; [lra|]. split.
      * intros u U. rewrite !(course_between n) by lra. rewrite later_later. f_equal. ring.
      * left. split; trivial. apply no_collision. intros i j N.
        rewrite (course_between n) by lra. apply A; trivial. lra.
    + destruct n as [|m]; [rewrite time_0 in P; lra|]. rewrite <- P, course_at. clear A.
      destruct (in_turn m) as [[F _ C R O] E].
      exists (time (Datatypes.S m) - time m), (later (time (Datatypes.S m) - time m) (scenes m)).
      split; trivial. split.
      * intros u U. rewrite (course_between m) by lra. rewrite later_later. f_equal. ring.
      * right. exists B0, (partner m). split; [apply not_eq_sym, partner_not_0|].
        repeat (split; [assumption|]). exact E.
Qed.

(* --- none goes beyond ------------------------------------------------------------------------- *)

(* Each collision changes the rate at which its balls move apart. *)
Lemma velocity_changes n : velocity (scenes (S n)) <> velocity (scenes n).
Proof.
  intros E. destruct (in_turn n) as [[_ _ C R _] N].
  set (arriving := later (time (S n) - time n) (scenes n)) in *. set (j := partner n) in *.
  assert (Q : rate d (scenes (S n)) B0 j = rate d arriving B0 j).
  { unfold rate, relative. rewrite E, N. reflexivity. }
  assert (U : dot d (to arriving B0 j) (to arriving B0 j) = 1).
  { change (square d arriving B0 j = 1). rewrite square_of_distance, C. ring. }
  rewrite N in Q. unfold rate in Q at 1. rewrite to_collided in Q.
  rewrite relative_collided in Q by apply partner_not_0.
  rewrite dot_linear_right, U in Q. fold (rate d arriving B0 j) in Q.
  assert (r * rate d arriving B0 j < 0).
  { rewrite Rmult_comm. rewrite <- (Rmult_0_l r). apply Rmult_lt_compat_r; lra. }
  lra.
Qed.
Theorem none_beyond T' Z' : trajectory d r (scenes O) T' Z' -> T' <= T.
Proof.
  intros A. apply Rnot_lt_le. intros L. pose proof (time_before_T 0) as P. rewrite time_0 in P.
  destruct (before_it _ _ _ _ _ A T ltac:(lra)) as (e & a & E & F & _).
  assert (V : forall n, T - e < time n -> velocity (scenes n) = velocity a).
  { intros n N. pose proof (time_before_T n) as B. pose proof (time_monotone 0 n ltac:(lia)).
    rewrite <- course_at.
    rewrite (agree _ _ _ _ _ _ _ course_is_trajectory A) by lra.
    replace (time n) with (T - (T - time n)) by ring. rewrite F by lra. reflexivity. }
  destruct (time_above (T - e) ltac:(lra)) as [n N]. pose proof (time_grows n).
  apply (velocity_changes n). rewrite !V by lra. reflexivity.
Qed.
End InTurn.
