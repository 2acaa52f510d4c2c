(* Endless collisions of three equal balls whose times do not converge: the balls never recede from
   their centre of mass, all relative velocities tend to 0, and the places converge. *)
From Coq Require Import Reals Arith Lra Lia Classical.
From Verify Require Import Theorem1 Vectors Motion Sequences Classification Contacts Settling.
Open Scope R_scope.
Set Default Proof Using "All".

Section Endless.
Variable d : nat.
Variable r : R.
Variable first : scene.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis run : endless d r first scenes time i j.

Let tau n := time (S n) - time n.
Let arriving n := later (tau n) (scenes n).
(* The speed at which the pair meets. *)
Definition meeting_speed n := - rate d (arriving n) (i n) (j n).
Let g := meeting_speed.
Lemma facts n : i n <> j n /\ 0 < tau n /\ distance d (arriving n) (i n) (j n) = 1 /\ 0 < g n /\
  (forall a b, a <> b -> 1 <= distance d (arriving n) a b) /\
  scenes (S n) = collided d r (i n) (j n) (arriving n).
Proof.
  destruct run as (_ & _ & A). destruct (A n) as (N & L & C & P & O & E). fold (tau n) (arriving n) in *.
  unfold g, meeting_speed. repeat split; trivial; unfold tau; lra.
Qed.
Theorem endless_strikes : strikes d (fun _ => 1) (fun _ => 1 / 2) scenes time i j.
Proof.
  intros n. destruct (facts n) as (N & L & C & P & O & E). fold (tau n). fold (arriving n).
  unfold g, meeting_speed in P.
  split; [exact N|]. split; [exact L|]. fold (arriving n). split; [lra|]. split; [lra|].
  split; [intros a b M; specialize (O a b M); lra|]. rewrite E. apply collided_hits; trivial. lra.
Qed.
Lemma times_grow : Un_growing time.
Proof. intros n. destruct (facts n) as (_ & L & _). unfold tau in L. lra. Qed.

(* --- what one collision does -------------------------------------------------------------------- *)

Lemma growth_next n : growth d (scenes (S n)) =
  growth d (scenes n) + tau n * motion2 d (scenes n) + 3 / 2 * (1 + r) * g n.
Proof.
  destruct (facts n) as (N & _ & C & _ & _ & ->). rewrite growth_collided by assumption.
  unfold arriving at 1. rewrite growth_later. unfold g, meeting_speed. ring.
Qed.
Lemma growth_rises n : growth d (scenes n) + tau n * motion2 d (scenes n) < growth d (scenes (S n)).
Proof.
  rewrite growth_next. destruct (facts n) as (_ & _ & _ & P & _).
  assert (0 < 3 / 2 * (1 + r) * g n) by (repeat apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma growth_grows n : growth d (scenes n) < growth d (scenes (S n)).
Proof.
  pose proof (growth_rises n). destruct (facts n) as (_ & L & _).
  pose proof (motion2_positive d (scenes n)).
  assert (0 <= tau n * motion2 d (scenes n)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma growth_after n m : (n <= m)%nat -> growth d (scenes n) <= growth d (scenes m).
Proof. intros L. induction L as [|m L IH]; [lra|]. pose proof (growth_grows m). lra. Qed.
Lemma motion2_next n : motion2 d (scenes (S n)) <= motion2 d (scenes n).
Proof.
  destruct (facts n) as (N & _ & C & _ & _ & ->). rewrite motion2_collided by assumption.
  unfold arriving at 1. rewrite motion2_later.
  assert (0 <= (1 - r) * (1 + r)) by (apply Rmult_le_pos; lra).
  assert (0 <= 3 / 2 * (1 - r * r) * (rate d (arriving n) (i n) (j n) * rate d (arriving n) (i n) (j n))).
  { apply Rmult_le_pos; [lra | apply Rle_0_sqr]. }
  lra.
Qed.
Lemma motion2_after n m : (n <= m)%nat -> motion2 d (scenes m) <= motion2 d (scenes n).
Proof. intros L. induction L as [|m L IH]; [lra|]. pose proof (motion2_next m). lra. Qed.
Lemma size_next n : size d (scenes (S n)) =
  size d (scenes n) + 2 * tau n * growth d (scenes n) + tau n * tau n * motion2 d (scenes n).
Proof. destruct (facts n) as (_ & _ & _ & _ & _ & ->). rewrite size_collided. apply size_later. Qed.
Lemma spin_next n k l : spin (scenes (S n)) k l = spin (scenes n) k l.
Proof.
  destruct (facts n) as (N & _ & C & _ & _ & ->).
  rewrite (spin_collided d r _ _ _ N C k l). apply spin_later.
Qed.
Lemma spin_stays n k l : spin (scenes n) k l = spin (scenes 0%nat) k l.
Proof.
  induction n as [|n IH]; [reflexivity | now rewrite spin_next].
Qed.
Lemma square_at_least n a b : a <> b -> 1 <= square d (scenes (S n)) a b.
Proof.
  intros N. destruct (facts n) as (_ & _ & _ & _ & O & ->). specialize (O a b N).
  change (1 <= square d (arriving n) a b). rewrite square_of_distance.
  apply Rle_trans with (1 * 1); [lra | apply Rmult_le_compat; lra].
Qed.

(* --- times that do not converge ------------------------------------------------------------------ *)

Section Unbounded.
Hypothesis unbounded : ~ exists T, Un_cv time T.
Lemma late b m : exists n, (n >= m)%nat /\ b < time n.
Proof.
  apply NNPP. intros N. apply unbounded. apply (bounded_increasing_converges time (Rmax b (time m))).
  - exact times_grow.
  - intros n. destruct (le_lt_dec m n) as [L|L].
    + apply Rle_trans with b; [|apply Rmax_l]. apply Rnot_lt_le. intros K. apply N. now exists n.
    + apply Rle_trans with (time m); [|apply Rmax_r].
      pose proof (growing_prop time m n times_grow ltac:(lia)). lra.
Qed.

(* If the balls recede once, they move apart like rays, and no pair can meet. *)
Section Receding.
Variable m : nat.
Hypothesis recedes : 0 < growth d (scenes m).
Let A n := growth d (scenes n).
Let N2 n := size d (scenes n).
Let W2 n := motion2 d (scenes n).
Lemma A_positive n : (n >= m)%nat -> 0 < A n.
Proof. intros L. pose proof (growth_after m n L). unfold A. lra. Qed.
Lemma N2_positive n : (n >= m)%nat -> 0 < N2 n.
Proof.
  intros L. pose proof (A_positive n L) as P. pose proof (growth_bounded d (scenes n)) as C.
  fold (A n) (N2 n) (W2 n) in C. assert (Q : 0 < A n * A n) by (apply Rmult_lt_0_compat; exact P).
  apply Rnot_le_lt. intros K.
  assert (0 <= (- N2 n) * W2 n) by (apply Rmult_le_pos; [lra | apply motion2_positive]). lra.
Qed.
Lemma A_next n : A n + tau n * W2 n <= A (S n). Proof. apply Rlt_le, growth_rises. Qed.
Lemma N2_next n : N2 (S n) = N2 n + 2 * tau n * A n + tau n * tau n * W2 n.
Proof. apply size_next. Qed.
Let defect n := N2 n * W2 n - A n * A n.
Lemma defect_next n : (n >= m)%nat -> defect (S n) <= defect n.
Proof.
  intros L. unfold defect. pose proof (N2_positive (S n) ltac:(lia)) as P. pose proof (A_next n) as Q.
  pose proof (A_positive n L) as PA. destruct (facts n) as (_ & T & _).
  pose proof (motion2_positive d (scenes n)) as PW. fold (W2 n) in PW.
  assert (TW : 0 <= tau n * W2 n) by (apply Rmult_le_pos; lra).
  assert (E1 : N2 (S n) * W2 (S n) <= N2 (S n) * W2 n) by (apply Rmult_le_compat_l; [lra | apply motion2_next]).
  assert (E2 : (A n + tau n * W2 n) * (A n + tau n * W2 n) <= A (S n) * A (S n))
    by (apply Rmult_le_compat; lra).
  rewrite N2_next in E1 at 2.
  assert (E3 : (N2 n + 2 * tau n * A n + tau n * tau n * W2 n) * W2 n =
    N2 n * W2 n - A n * A n + (A n + tau n * W2 n) * (A n + tau n * W2 n)) by ring.
  lra.
Qed.
Lemma defect_after n : (n >= m)%nat -> defect n <= defect m.
Proof. intros L. induction L as [|n L IH]; [lra|]. pose proof (defect_next n ltac:(lia)). lra. Qed.
(* The square of growth over size does not fall. *)
Lemma share_next n : (n >= m)%nat -> A n * A n * N2 (S n) <= A (S n) * A (S n) * N2 n.
Proof.
  intros L. pose proof (N2_positive n L) as P. pose proof (A_next n) as Q.
  pose proof (A_positive n L) as PA. destruct (facts n) as (_ & T & _).
  pose proof (motion2_positive d (scenes n)) as PW. fold (W2 n) in PW.
  pose proof (growth_bounded d (scenes n)) as C. fold (A n) (N2 n) (W2 n) in C.
  assert (TW : 0 <= tau n * W2 n) by (apply Rmult_le_pos; lra).
  apply Rle_trans with ((A n + tau n * W2 n) * (A n + tau n * W2 n) * N2 n).
  - rewrite N2_next.
    assert (C1 : 0 <= 2 * tau n * A n * (N2 n * W2 n - A n * A n)).
    { apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; lra. }
    assert (C2 : 0 <= tau n * tau n * W2 n * (N2 n * W2 n - A n * A n)).
    { apply Rmult_le_pos; [|lra]. apply Rmult_le_pos; [|exact PW]. apply Rmult_le_pos; lra. }
    lra.
  - apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat; lra.
Qed.
Let share := A m * A m / N2 m.
Lemma share_positive : 0 < share.
Proof.
  unfold share. pose proof (A_positive m (le_n m)) as P.
  apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; exact P | exact (N2_positive m (le_n m))].
Qed.
Lemma share_after n : (n >= m)%nat -> share * N2 n <= A n * A n.
Proof.
  intros L. induction L as [|n L IH].
  - unfold share. right. field. pose proof (N2_positive m (le_n m)). lra.
  - pose proof (share_next n ltac:(lia)) as P. pose proof (N2_positive n ltac:(lia)) as Q.
    pose proof (N2_positive (S n) ltac:(lia)) as Q'.
    apply Rmult_le_reg_r with (N2 n); [exact Q|]. apply Rle_trans with (2 := P).
    replace (share * N2 (S n) * N2 n) with (share * N2 n * N2 (S n)) by ring.
    apply Rmult_le_compat_r; lra.
Qed.
Lemma W2_at_least n : (n >= m)%nat -> share <= W2 n.
Proof.
  intros L. pose proof (share_after n L) as P. pose proof (N2_positive n L) as Q.
  pose proof (growth_bounded d (scenes n)) as C. fold (A n) (N2 n) (W2 n) in C.
  apply Rmult_le_reg_r with (N2 n); [exact Q|]. lra.
Qed.
Lemma A_grows n : (n >= m)%nat -> A m + share * (time n - time m) <= A n.
Proof.
  intros L. induction L as [|n L IH]; [lra|]. pose proof (A_next n) as P.
  pose proof (W2_at_least n ltac:(lia)) as Q. destruct (facts n) as (_ & T & _).
  assert (tau n * share <= tau n * W2 n) by (apply Rmult_le_compat_l; lra).
  replace (share * (time (S n) - time m)) with (share * (time n - time m) + tau n * share)
    by (unfold tau; ring). lra.
Qed.
(* Far from a contact pair the third ball recedes from both. *)
Lemma third_recedes n a b c : (n >= m)%nat -> distinct_balls c a b -> square d (scenes n) a b = 1 ->
  12 <= N2 n -> 4 * defect m < A n * A n -> 0 <= rate d (scenes n) a c.
Proof.
  intros L (CA & CB & AB) U F G. apply Rnot_lt_le. intros K. set (s := scenes n) in *.
  assert (E : N2 n = square d s a b + square d s a c + square d s b c).
  { unfold N2. rewrite size_is. fold s. unfold total. pose proof (square_symmetric d s B1 B0).
    pose proof (square_symmetric d s B2 B0). pose proof (square_symmetric d s B2 B1).
    destruct a, b, c; try easy; lra. }
  set (X := square d s a c) in *.
  assert (B : square d s b c <= 2 * X + 2).
  { pose proof (dot_self d (combined 1 (to s a c) 1 (to s a b))) as P.
    assert (Q : square d s b c = X + square d s a b - 2 * dot d (to s a c) (to s a b)).
    { pose proof (cosines d s a c b). rewrite (square_symmetric d s c b) in H. fold X in H. lra. }
    rewrite square_of_combined in P. fold (square d s a c) in P. fold X in P.
    fold (square d s a b) in P. rewrite U in *. lra. }
  assert (HX : N2 n <= 4 * X) by lra.
  set (k := A n / N2 n). pose proof (N2_positive n L) as PN. pose proof (A_positive n L) as PA.
  assert (KN : k * N2 n = A n) by (unfold k; field; lra).
  (* The part of the velocity that is not along the place. *)
  set (rest x y := combined 1 (relative s x y) (- k) (to s x y)).
  set (q x y := dot d (rest x y) (rest x y)).
  assert (Qp : forall x y, 0 <= q x y) by (intros; apply dot_self).
  assert (Qe : forall x y, q x y = speed2 d s x y - 2 * k * rate d s x y + k * k * square d s x y).
  { intros x y. unfold q, rest. rewrite square_of_combined, (dot_symmetric d (relative s x y) (to s x y)).
    unfold speed2, rate, square. ring. }
  assert (Qs : q a c <= W2 n - k * A n).
  { assert (S0 : forall x y, q x y = q y x).
    { intros x y. rewrite !Qe. rewrite speed2_symmetric, rate_symmetric, square_symmetric. reflexivity. }
    destruct (total_is q a c S0 ltac:(congruence)) as (z & _ & _ & T).
    assert (T' : total q = W2 n - 2 * k * A n + k * k * N2 n).
    { unfold total. rewrite !Qe. unfold W2, A, N2. rewrite size_is. unfold motion2, growth, total. fold s. ring. }
    replace (k * k * N2 n) with (k * A n) in T' by (rewrite <- KN; ring).
    pose proof (Qp a z). pose proof (Qp c z). lra. }
  assert (CS : (k * X) * (k * X) <= X * q a c).
  { pose proof (cauchy_schwarz d (to s a c) (rest a c)) as P. fold (square d s a c) in P. fold X in P.
    fold (q a c) in P.
    assert (V : dot d (to s a c) (rest a c) = rate d s a c - k * X).
    { unfold rest. rewrite dot_linear_right. unfold rate, X, square. ring. }
    rewrite V in P. apply Rle_trans with (2 := P).
    assert (kX : 0 <= k * X).
    { apply Rmult_le_pos; [|unfold X; apply square_positive]. apply Rlt_le, Rdiv_lt_0_compat; assumption. }
    replace ((rate d s a c - k * X) ^ 2) with ((k * X - rate d s a c) * (k * X - rate d s a c)) by ring.
    apply Rmult_le_compat; lra. }
  assert (XP : 0 < X) by lra.
  assert (CS' : k * k * X <= W2 n - k * A n).
  { apply Rmult_le_reg_r with X; [exact XP|].
    assert (X * q a c <= X * (W2 n - k * A n)) by (apply Rmult_le_compat_l; lra). lra. }
  pose proof (defect_after n L) as D. unfold defect at 1 in D.
  assert (M1 : N2 n * (k * k * X) <= N2 n * (W2 n - k * A n)) by (apply Rmult_le_compat_l; lra).
  replace (N2 n * (W2 n - k * A n)) with (N2 n * W2 n - (k * N2 n) * A n) in M1 by ring.
  rewrite KN in M1.
  replace (N2 n * (k * k * X)) with (A n * (k * X)) in M1 by (rewrite <- KN; ring).
  assert (M2 : A n * (k * N2 n) <= A n * (k * (4 * X))).
  { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; [|exact HX].
    apply Rlt_le, Rdiv_lt_0_compat; assumption. }
  rewrite KN in M2. lra.
Qed.
Lemma no_receding : False.
Proof.
  pose proof share_positive as P.
  set (need := 1 + 4 * Rabs (defect m) + 12 * motion2 d (scenes m)).
  pose proof (motion2_positive d (scenes m)) as W0.
  pose proof (Rabs_pos (defect m)) as D0. pose proof (Rle_abs (defect m)) as D1.
  destruct (late (time m + need / share) (S m)) as (n & L & T).
  assert (G : need <= A n).
  { pose proof (A_grows n ltac:(lia)) as Q. pose proof (A_positive m (le_n m)).
    assert (share * (need / share) < share * (time n - time m)) by (apply Rmult_lt_compat_l; lra).
    replace (share * (need / share)) with need in H0 by (field; lra). lra. }
  assert (G2 : A n <= A n * A n).
  { replace (A n) with (1 * A n) at 1 by ring. apply Rmult_le_compat_r; unfold need in *; lra. }
  assert (F : 12 <= N2 n).
  { pose proof (growth_bounded d (scenes n)) as C. fold (A n) (N2 n) (W2 n) in C.
    pose proof (motion2_after m n ltac:(lia)) as W. fold (W2 n) in W.
    pose proof (N2_positive n ltac:(lia)) as PN. pose proof (W2_at_least n ltac:(lia)) as PW.
    apply Rnot_lt_le. intros K.
    assert (N2 n * W2 n <= 12 * motion2 d (scenes m)).
    { apply Rmult_le_compat; lra. }
    unfold need in *. lra. }
  destruct n as [|n]; [lia|].
  destruct (facts n) as (N & _ & C & _ & _ & E). destruct (facts (S n)) as (N' & L' & _ & P' & _).
  assert (U : square d (scenes (S n)) (i n) (j n) = 1).
  { rewrite E. change (square d (arriving n) (i n) (j n) = 1). now apply unit_square. }
  assert (U' : square d (scenes (S n)) (j n) (i n) = 1) by now rewrite square_symmetric.
  assert (R1 : 0 <= rate d (scenes (S n)) (i n) (j n)).
  { rewrite E, rate_collided by assumption. destruct (facts n) as (_ & _ & _ & Q & _).
    unfold g, meeting_speed in Q. assert (0 <= r * - rate d (arriving n) (i n) (j n)) by (apply Rmult_le_pos; lra).
    lra. }
  assert (R2 : forall a c, a <> c -> 0 <= rate d (scenes (S n)) a c).
  { intros a c AC.
    assert (H1 : forall c, c <> i n -> c <> j n -> 0 <= rate d (scenes (S n)) (i n) c).
    { intros x X Y. apply (third_recedes (S n) (i n) (j n) x); trivial; [lia | repeat split; congruence |].
      unfold need in *. lra. }
    assert (H2 : forall c, c <> i n -> c <> j n -> 0 <= rate d (scenes (S n)) (j n) c).
    { intros x X Y. apply (third_recedes (S n) (j n) (i n) x); trivial; [lia | repeat split; congruence |].
      unfold need in *. lra. }
    pose proof (rate_symmetric d (scenes (S n)) a c) as Z.
    destruct (i n), (j n), a, c; try easy;
      first [exact R1 | rewrite Z; exact R1 | apply H1; discriminate | apply H2; discriminate
        | rewrite Z; apply H1; discriminate | rewrite Z; apply H2; discriminate]. }
  pose proof (R2 _ _ N') as K.
  pose proof (rate_rises d (scenes (S n)) (i (S n)) (j (S n)) (tau (S n)) ltac:(lra)) as K2.
  unfold g, meeting_speed in P'. fold (arriving (S n)) in K2. lra.
Qed.
End Receding.
Theorem never_recedes n : growth d (scenes n) <= 0.
Proof. apply Rnot_lt_le. intros P. exact (no_receding n P). Qed.

Lemma motion2_by_time n : motion2 d (scenes n) * (time n - time 0%nat) <= - growth d (scenes 0%nat).
Proof.
  assert (G : forall k, (k <= n)%nat ->
    growth d (scenes 0%nat) + motion2 d (scenes n) * (time k - time 0%nat) <= growth d (scenes k)).
  { induction k as [|k IH]; intros L; [lra|]. specialize (IH ltac:(lia)).
    pose proof (growth_rises k). pose proof (motion2_after k n ltac:(lia)). destruct (facts k) as (_ & T & _).
    assert (tau k * motion2 d (scenes n) <= tau k * motion2 d (scenes k)) by (apply Rmult_le_compat_l; lra).
    replace (motion2 d (scenes n) * (time (S k) - time 0%nat)) with
      (motion2 d (scenes n) * (time k - time 0%nat) + tau k * motion2 d (scenes n)) by (unfold tau; ring).
    lra. }
  specialize (G n (le_n n)). pose proof (never_recedes n). lra.
Qed.
Theorem motion2_vanishes : Un_cv (fun n => motion2 d (scenes n)) 0.
Proof.
  intros e E. destruct (late (time 0%nat + (1 - growth d (scenes 0%nat)) / e) 0) as (m & _ & T).
  exists m. intros n L. pose proof (motion2_by_time n) as B. pose proof (motion2_positive d (scenes n)) as P.
  unfold R_dist. rewrite Rminus_0_r, Rabs_right by lra. apply Rnot_le_lt. intros K.
  pose proof (growing_prop time n m times_grow L) as G. pose proof (never_recedes 0) as A0.
  assert (Q : 0 < (1 - growth d (scenes 0%nat)) / e) by (apply Rdiv_lt_0_compat; lra).
  assert (e * ((1 - growth d (scenes 0%nat)) / e) <= motion2 d (scenes n) * (time n - time 0%nat)).
  { apply Rmult_le_compat; lra. }
  replace (e * ((1 - growth d (scenes 0%nat)) / e)) with (1 - growth d (scenes 0%nat)) in H by (field; lra).
  lra.
Qed.
Lemma velocities_vanish : stops d scenes.
Proof.
  intros a b k K e E.
  assert (D : {a = b} + {a <> b}) by (destruct a, b; (now left) || (right; discriminate)).
  destruct D as [->|N].
  - exists O. intros n _. rewrite relative_self. unfold R_dist. now rewrite Rminus_diag_eq, Rabs_R0.
  - destruct (motion2_vanishes (e * e)) as (m & M); [now apply Rmult_lt_0_compat|].
    exists m. intros n L. specialize (M n L). pose proof (motion2_positive d (scenes n)).
    unfold R_dist in *. rewrite Rminus_0_r in *. rewrite Rabs_right in M by lra.
    pose proof (coordinate_by_motion2 d (scenes n) a b k K N) as C.
    rewrite <- (Rabs_right e) by lra. apply Rsqr_lt_abs_0. unfold Rsqr. lra.
Qed.
(* What a coordinate of a relative velocity is, the growth still has to make up for. *)
Lemma velocity_bounded n a b k : (k < d)%nat -> a <> b ->
  Rabs (relative (scenes n) a b k) <=
    - (2 / 3) * (growth d (scenes n) + tau n * motion2 d (scenes n)).
Proof.
  intros K N.
  set (f n := Rabs (relative (scenes n) a b k) + 2 / 3 * growth d (scenes n)).
  assert (STEP : forall m, Rabs (relative (scenes m) a b k) +
    2 / 3 * (growth d (scenes m) + tau m * motion2 d (scenes m)) <= f (S m)).
  { intros m. unfold f. rewrite growth_next. destruct (facts m) as (M & _ & C & P & _ & E).
    pose proof (change_at_most d r (i m) (j m) (arriving m) C a b k K ltac:(lra)) as B.
    rewrite <- E in B. change (relative (arriving m) a b k) with (relative (scenes m) a b k) in B.
    rewrite (Rabs_left (rate d (arriving m) (i m) (j m))) in B by (unfold g, meeting_speed in P; lra).
    change (- rate d (arriving m) (i m) (j m)) with (g m) in B.
    pose proof (Rabs_triang_inv (relative (scenes m) a b k) (relative (scenes (S m)) a b k)) as Q.
    rewrite (Rabs_minus_sym (relative (scenes m) a b k)) in Q. lra. }
  assert (G : forall m p, f m <= f (m + p)%nat).
  { intros m. induction p as [|p IH]; [rewrite Nat.add_0_r; lra|].
    replace (m + S p)%nat with (S (m + p)) by lia. pose proof (STEP (m + p)%nat) as Q.
    destruct (facts (m + p)%nat) as (_ & T & _). pose proof (motion2_positive d (scenes (m + p)%nat)).
    assert (0 <= tau (m + p)%nat * motion2 d (scenes (m + p)%nat)) by (apply Rmult_le_pos; lra).
    unfold f in *. lra. }
  assert (Z : forall m, f m <= 0).
  { intros m. apply Rnot_lt_le. intros P.
    destruct (motion2_vanishes (f m * f m)) as (p & Q); [now apply Rmult_lt_0_compat|].
    specialize (Q (m + p)%nat ltac:(lia)). pose proof (motion2_positive d (scenes (m + p)%nat)).
    unfold R_dist in Q. rewrite Rminus_0_r, Rabs_right in Q by lra.
    pose proof (coordinate_by_motion2 d (scenes (m + p)%nat) a b k K N) as C.
    pose proof (never_recedes (m + p)) as A0. specialize (G m p). unfold f at 2 in G.
    assert (L : f m <= Rabs (relative (scenes (m + p)%nat) a b k)) by lra.
    assert (f m * f m <= Rabs (relative (scenes (m + p)%nat) a b k) * Rabs (relative (scenes (m + p)%nat) a b k))
      by (apply Rmult_le_compat; lra).
    rewrite <- Rabs_mult, Rabs_right in H0 by (apply Rle_ge, Rle_0_sqr). lra. }
  pose proof (STEP n). specialize (Z (S n)). lra.
Qed.
Theorem settles_late : exists z, settles d scenes z.
Proof.
  apply settled_by_coordinates. intros a b k K.
  assert (D : {a = b} + {a <> b}) by (destruct a, b; (now left) || (right; discriminate)).
  destruct D as [->|N].
  { exists 0. intros e E. exists O. intros n _. rewrite to_self. unfold R_dist. now rewrite Rminus_diag_eq, Rabs_R0. }
  assert (M : forall n, Rabs (tau n * relative (scenes n) a b k) <=
    1 / 3 * (size d (scenes n) - size d (scenes (S n)))).
  { intros n. destruct (facts n) as (_ & T & _). rewrite Rabs_mult, (Rabs_right (tau n)) by lra.
    pose proof (velocity_bounded n a b k K N) as V. rewrite size_next.
    assert (tau n * Rabs (relative (scenes n) a b k) <=
      tau n * (- (2 / 3) * (growth d (scenes n) + tau n * motion2 d (scenes n)))) by (apply Rmult_le_compat_l; lra).
    assert (0 <= tau n * tau n * motion2 d (scenes n)).
    { apply Rmult_le_pos; [apply Rle_0_sqr | apply motion2_positive]. }
    lra. }
  assert (P : forall n, to (scenes (S n)) a b k = to (scenes n) a b k + tau n * relative (scenes n) a b k).
  { intros n. destruct (facts n) as (_ & _ & _ & _ & _ & ->). rewrite to_collided. unfold arriving.
    rewrite to_later. unfold combined. ring. }
  apply (bounded_variation_converges _ (fun n => - (1 / 3) * size d (scenes n)) 0).
  - intros n. rewrite P. specialize (M n). apply within in M. lra.
  - intros n. rewrite P. specialize (M n). apply within in M. lra.
  - intros n. pose proof (size_positive d (scenes n)). lra.
Qed.
End Unbounded.

Theorem settles_always : exists z, settles d scenes z.
Proof.
  destruct (classic (exists T, Un_cv time T)) as [(T & L)|N]; [|now apply settles_late].
  apply (settles_in_time d (fun _ => 1) (fun _ => 1 / 2) scenes time i j T); trivial.
  - intros _. lra.
  - exact endless_strikes.
Qed.
End Endless.
