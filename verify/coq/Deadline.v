(* With angular momentum, collisions without end are over by a time that the first state gives. *)
From Coq Require Import Reals Arith Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Sequences Classification Contacts Settling Endless.
From Verify Require Import ClassificationProof Turning Finite.
Open Scope R_scope.

(* The most that size can be until then, and the least motion. *)
Definition most (d : nat) (s : scene) : R := Rmax (size d s) 6.
Definition least_motion (d : nat) (s : scene) : R := spin2 d s / most d s.

Lemma constant_limit a : Un_cv (fun _ => a) a.
Proof. intros e E. exists 0%nat. intros n _. now rewrite R_dist_eq. Qed.
Lemma quadratic (t : nat -> R) l a b c : Un_cv t l ->
  Un_cv (fun n => a + 2 * t n * b + t n * t n * c) (a + 2 * l * b + l * l * c).
Proof.
  intros L. apply CV_plus; [apply CV_plus; [apply constant_limit|]|].
  - apply CV_mult; [apply CV_mult; [apply constant_limit | exact L] | apply constant_limit].
  - apply CV_mult; [now apply CV_mult | apply constant_limit].
Qed.

Section Late.
Variable d : nat.
Variable r : R.
Variable first : scene.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis run : endless d r first scenes time i j.
Hypothesis turns : 0 < spin2 d first.
Let S n := size d (scenes n).
Let G n := growth d (scenes n).
Let V n := motion2 d (scenes n).
Let tau n := time (Datatypes.S n) - time n.
Let P := most d first.
Let m := least_motion d first.
Lemma first_is : scenes 0%nat = first /\ time 0%nat = 0.
Proof. destruct run as (A & B & _). now split. Qed.
Lemma next_numbers n : 0 < tau n /\ S (Datatypes.S n) = S n + 2 * tau n * G n + tau n * tau n * V n /\
  G n + tau n * V n <= G (Datatypes.S n).
Proof.
  destruct (facts d r first scenes time i j restitutes run n) as (N & T & C & P1 & _ & E).
  fold (tau n) in *. unfold S, G, V. rewrite E, size_collided, size_later, growth_collided by assumption.
  rewrite growth_later. split; [exact T|]. split; [reflexivity|]. unfold meeting_speed in P1. fold (tau n) in P1.
  assert (0 < 3 / 2 * (1 + r) * - rate d (later (tau n) (scenes n)) (i n) (j n)) by (repeat apply Rmult_lt_0_compat; lra).
  lra.
Qed.
Lemma V_positive n : 0 <= V n.
Proof. apply motion2_positive. Qed.
Lemma tV_positive n : 0 <= tau n * V n.
Proof. destruct (next_numbers n) as (T & _). apply Rmult_le_pos; [lra | apply V_positive]. Qed.
Lemma first_falls n : S n <= S 0%nat \/ 0 < G n.
Proof.
  induction n as [|n IH]; [left; lra|]. destruct (next_numbers n) as (T & E & K). pose proof (tV_positive n) as W.
  destruct IH as [IH|IH]; [|right; lra]. destruct (Rlt_le_dec 0 (G (Datatypes.S n))) as [L|L]; [now right | left].
  rewrite E. assert (0 <= tau n * (- (G n + tau n * V n))) by (apply Rmult_le_pos; lra).
  assert (0 <= tau n * (tau n * V n)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma then_rises n k : 0 < G n -> S n <= S (n + k)%nat /\ 0 < G (n + k)%nat.
Proof.
  intros L. induction k as [|k (A & B)]; [rewrite Nat.add_0_r; split; [apply Rle_refl | exact L]|].
  rewrite Nat.add_succ_r. destruct (next_numbers (n + k)) as (T & E & K). pose proof (tV_positive (n + k)) as W.
  split; [|lra]. rewrite E. assert (0 < tau (n + k) * G (n + k)%nat) by now apply Rmult_lt_0_compat.
  assert (0 <= tau (n + k) * (tau (n + k) * V (n + k))) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma at_most n : S n <= P.
Proof.
  unfold P, most. rewrite <- (proj1 first_is). fold (S 0%nat). pose proof (Rmax_l (S 0%nat) 6). pose proof (Rmax_r (S 0%nat) 6).
  apply Rnot_lt_le. intros N. destruct (first_falls n) as [A|A]; [lra|].
  apply (not_large d r first scenes time i j restitutes run (S n) n); [lra|]. intros k K.
  replace k with (n + (k - n))%nat by lia. apply then_rises, A.
Qed.
Lemma P_positive : 0 < P.
Proof. unfold P, most. pose proof (Rmax_r (size d first) 6). lra. Qed.
Lemma m_positive : 0 < m.
Proof. unfold m, least_motion. apply Rdiv_lt_0_compat; [exact turns | exact P_positive]. Qed.
Lemma moves n : m <= V n.
Proof.
  pose proof P_positive as P0. apply Rmult_le_reg_r with P; [exact P0|].
  unfold m, least_motion. fold P. replace (spin2 d first / P * P) with (spin2 d first) by (field; lra).
  pose proof (spin_bounded d (scenes n)) as B. rewrite (spin2_stays d r first scenes time i j restitutes run n), (proj1 first_is) in B.
  fold (S n) (G n) (V n) in B. pose proof (Rle_0_sqr (G n)) as Q. unfold Rsqr in Q.
  assert (S n * V n <= P * V n) by (apply Rmult_le_compat_r; [apply V_positive | apply at_most]). lra.
Qed.
Definition bound (t : R) : R := size d first + 2 * t * growth d first + t * t * m.
Lemma late n : G 0%nat + time n * m <= G n /\ bound (time n) <= S n.
Proof.
  destruct first_is as (F & T0). unfold bound. rewrite <- F. fold (S 0%nat) (G 0%nat).
  induction n as [|n (A & B)]; [rewrite T0; split; lra|].
  destruct (next_numbers n) as (T & E & K). pose proof (moves n) as M. 
  assert (tau n * m <= tau n * V n) by (apply Rmult_le_compat_l; lra).
  assert (tau n * (tau n * m) <= tau n * (tau n * V n)) by (apply Rmult_le_compat_l; lra).
  assert (tau n * (G 0%nat + time n * m) <= tau n * G n) by (apply Rmult_le_compat_l; lra).
  replace (time (Datatypes.S n)) with (time n + tau n) by (unfold tau; ring). split; [lra|]. rewrite E. lra.
Qed.
Variable T : R.
Hypothesis finite_time : Un_cv time T.
Lemma over_in_time : bound T <= 6.
Proof.
  apply Rnot_lt_le. intros N.
  assert (L : Un_cv (fun n => bound (time n)) (bound T)) by exact (quadratic time T _ _ _ finite_time).
  destruct (L ((bound T - 6) / 2)) as (k & K); [lra|].
  apply (not_large d r first scenes time i j restitutes run ((bound T + 6) / 2) k); [lra|]. intros n H.
  specialize (K n H). unfold R_dist in K. apply Rabs_def2 in K. destruct (late n) as (_ & B). unfold S in B. lra.
Qed.
End Late.

(* The time of a collapse satisfies this, and there are finitely many collisions where no time does. *)
Theorem deadline d r s scenes time i j T : 0 < r <= 1 -> 0 < spin2 d s ->
  endless d r s scenes time i j -> Un_cv time T ->
  let m := least_motion d s in
  0 <= growth d s ^ 2 + (6 - size d s) * m /\
  T <= (sqrt (growth d s ^ 2 + (6 - size d s) * m) - growth d s) / m.
Proof.
  intros R L E C m. pose proof (over_in_time d r s scenes time i j R E T C) as B. unfold bound in B. fold m in B.
  pose proof (m_positive d s L : 0 < m) as M.
  assert (Q : (m * T + growth d s) ^ 2 <= growth d s ^ 2 + (6 - size d s) * m).
  { assert (0 <= m * (6 - (size d s + 2 * T * growth d s + T * T * m))) by (apply Rmult_le_pos; lra). lra. }
  split; [pose proof (pow2_ge_0 (m * T + growth d s)); lra|].
  apply Rmult_le_reg_r with m; [exact M|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra.
  apply sqrt_le_1_alt in Q. rewrite <- Rsqr_pow2, sqrt_Rsqr_abs in Q. pose proof (Rle_abs (m * T + growth d s)). lra.
Qed.
Theorem never_late d r s : 0 < r <= 1 -> 0 < spin2 d s ->
  growth d s ^ 2 + (6 - size d s) * least_motion d s < 0 -> finite d r s.
Proof.
  intros R L N. destruct (finite_or_endless_holds d r s R) as [F|(scenes & time & i & j & E)]; [exact F | exfalso].
  destruct (no_spin_holds d r s scenes time i j R E L) as (T & C).
  destruct (deadline d r s scenes time i j T R L E C) as (A & _). lra.
Qed.
