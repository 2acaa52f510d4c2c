(* Endless collisions of three balls: the places converge. If the times converge, that is so since
   speeds are bounded, for any masses. If not, then the balls, which are equal, never recede from their
   centre of mass, and that bounds what they move. *)
From Coq Require Import Reals Arith Lra Lia Classical.
From Verify Require Import Theorem1 Vectors Motion Sequences Ending Classification Contacts.
Open Scope R_scope.

Lemma settled_by_coordinates d scenes :
  (forall a b k, (k < d)%nat -> exists l, Un_cv (fun n => to (scenes n) a b k) l) ->
  exists z, settles d scenes z.
Proof.
  intros A.
  assert (C : forall b k, (k < d)%nat -> Cauchy_crit (fun n => to (scenes n) B0 b k)).
  { intros b k K. destruct (A B0 b k K) as (l & L). apply CV_Cauchy. now exists l. }
  set (z := Scene (fun b k => match lt_dec k d with
    | left L => proj1_sig (R_complete _ (C b k L)) | right _ => 0 end) (fun _ _ => 0)).
  assert (P : forall b k, (k < d)%nat -> Un_cv (fun n => to (scenes n) B0 b k) (position z b k)).
  { intros b k K. unfold z. cbn [position]. destruct (lt_dec k d) as [L|L]; [|easy].
    exact (proj2_sig (R_complete _ (C b k L))). }
  exists z. intros a b k K. pose proof (CV_minus _ _ _ _ (P b k K) (P a k K)) as M.
  intros e E. destruct (M e E) as (m & Q). exists m. intros n L. specialize (Q n L).
  unfold to at 1 in Q. unfold to in Q. unfold to.
  replace (position (scenes n) b k - position (scenes n) a k) with
    (position (scenes n) b k - position (scenes n) B0 k -
      (position (scenes n) a k - position (scenes n) B0 k)) by ring. exact Q.
Qed.

(* --- any masses, in finite time ----------------------------------------------------------------- *)

Section InTime.
Variable d : nat.
Variables mass radius : ball -> R.
Variables scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Variable T : R.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis run : strikes d mass radius scenes time i j.
Hypothesis finite_time : Un_cv time T.

Let E0 := energy_of d mass (scenes O).
Lemma energy_stays n : energy_of d mass (scenes n) <= E0.
Proof.
  induction n as [|n IH]; [unfold E0; lra|]. destruct (run n) as (N & _ & _ & _ & _ & H).
  pose proof (energy_falls d mass heavy _ _ _ _ N H) as F.
  unfold energy_of in F at 2. cbn [velocity later] in F. unfold energy_of in *. lra.
Qed.
Let top := 1 + E0 / mass B0 + E0 / mass B1 + E0 / mass B2.
Lemma coordinate_slow n b k : (k < d)%nat -> Rabs (velocity (scenes n) b k) <= top.
Proof.
  intros K. pose proof (coordinate_at_most d (velocity (scenes n) b) k K) as C.
  pose proof (energy_stays n) as F.
  assert (P : forall b, 0 <= mass b * dot d (velocity (scenes n) b) (velocity (scenes n) b)).
  { intros c. pose proof (heavy c). apply Rmult_le_pos; [lra | apply dot_self]. }
  assert (E : 0 <= E0) by (unfold energy_of in F; pose proof (P B0); pose proof (P B1); pose proof (P B2); lra).
  assert (Q : forall b, 0 <= E0 / mass b).
  { intros c. apply Rmult_le_pos; [exact E|]. now apply Rlt_le, Rinv_0_lt_compat. }
  assert (S : velocity (scenes n) b k * velocity (scenes n) b k <= E0 / mass b).
  { apply Rle_trans with (1 := C). apply Rmult_le_reg_l with (mass b); [apply heavy|].
    replace (mass b * (E0 / mass b)) with E0 by (field; pose proof (heavy b); lra).
    unfold energy_of in F. pose proof (P B0). pose proof (P B1). pose proof (P B2). destruct b; lra. }
  assert (U : E0 / mass b <= top - 1).
  { unfold top. pose proof (Q B0). pose proof (Q B1). pose proof (Q B2). destruct b; lra. }
  set (x := velocity (scenes n) b k) in *. pose proof (Rle_0_sqr (x - 1)). pose proof (Rle_0_sqr (x + 1)).
  unfold Rsqr in *. apply Rabs_le. lra.
Qed.
Lemma place_after n b k : position (scenes (S n)) b k =
  position (scenes n) b k + (time (S n) - time n) * velocity (scenes n) b k.
Proof. destruct (run n) as (_ & _ & _ & _ & _ & J & _ & X & _). now rewrite X. Qed.
Theorem settles_in_time : exists z, settles d scenes z.
Proof.
  assert (G : Un_growing time) by (intros n; destruct (run n) as (_ & P & _); lra).
  apply settled_by_coordinates. intros a b k K.
  assert (P : forall c, exists l, Un_cv (fun n => position (scenes n) c k) l).
  { intros c. assert (V : forall n, - top <= velocity (scenes n) c k <= top).
    { intros n. apply within, coordinate_slow, K. }
    assert (M : forall n, - (top * (time (S n) - time n)) <= (time (S n) - time n) * velocity (scenes n) c k <=
      top * (time (S n) - time n)).
    { intros n. destruct (run n) as (_ & Q & _). specialize (V n). split.
      - replace (- (top * (time (S n) - time n))) with ((time (S n) - time n) * - top) by ring.
        apply Rmult_le_compat_l; lra.
      - rewrite (Rmult_comm top). apply Rmult_le_compat_l; lra. }
    apply (bounded_variation_converges _ (fun n => top * time n) (top * T)).
    - intros n. rewrite place_after. specialize (M n). lra.
    - intros n. rewrite place_after. specialize (M n). lra.
    - intros n. apply Rmult_le_compat_l; [specialize (V O); lra|].
      exact (growing_ineq time T G finite_time n). }
  destruct (P a) as (p & A), (P b) as (q & B). exists (q - p). exact (CV_minus _ _ _ _ B A).
Qed.
End InTime.

(* --- sums over the three pairs ------------------------------------------------------------------ *)

Definition total (f : ball -> ball -> R) : R := f B0 B1 + f B0 B2 + f B1 B2.
Lemma total_is f i j : (forall a b, f a b = f b a) -> i <> j ->
  exists k, k <> i /\ k <> j /\ total f = f i j + f i k + f j k.
Proof.
  intros S N. unfold total. pose proof (S B1 B0). pose proof (S B2 B0). pose proof (S B2 B1).
  destruct i, j; try (now destruct N);
    [exists B2 | exists B1 | exists B2 | exists B0 | exists B1 | exists B0]; repeat split; try discriminate; lra.
Qed.
Lemma size_is d s : size d s = total (square d s).
Proof. unfold size, total. rewrite !square_of_distance. ring. Qed.
Lemma growth_is d s : growth d s = total (rate d s).
Proof. reflexivity. Qed.
Definition speed2 d s a b := dot d (relative s a b) (relative s a b).
Definition motion2 d s := total (speed2 d s).
Lemma speed2_symmetric d s a b : speed2 d s a b = speed2 d s b a.
Proof.
  unfold speed2. rewrite (relative_opposite s a b), dot_scaled, dot_scaled_right. ring.
Qed.
Lemma speed2_positive d s a b : 0 <= speed2 d s a b.
Proof. apply dot_self. Qed.
Lemma motion2_positive d s : 0 <= motion2 d s.
Proof.
  unfold motion2, total. pose proof (speed2_positive d s B0 B1). pose proof (speed2_positive d s B0 B2).
  pose proof (speed2_positive d s B1 B2). lra.
Qed.
Lemma speed2_at_most d s a b : a <> b -> speed2 d s a b <= motion2 d s.
Proof.
  intros N. destruct (total_is (speed2 d s) a b (speed2_symmetric d s) N) as (k & _ & _ & E).
  unfold motion2. rewrite E. pose proof (speed2_positive d s a k). pose proof (speed2_positive d s b k). lra.
Qed.
Lemma square_positive d s a b : 0 <= square d s a b.
Proof. apply dot_self. Qed.
Lemma coordinate_by_motion2 d s a b k : (k < d)%nat -> a <> b ->
  relative s a b k * relative s a b k <= motion2 d s.
Proof.
  intros K N. apply Rle_trans with (speed2 d s a b); [now apply coordinate_at_most | now apply speed2_at_most].
Qed.
Lemma size_positive d s : 0 <= size d s.
Proof.
  rewrite size_is. unfold total. pose proof (square_positive d s B0 B1).
  pose proof (square_positive d s B0 B2). pose proof (square_positive d s B1 B2). lra.
Qed.
Lemma size_converges d scenes z : settles d scenes z ->
  Un_cv (fun n => size d (scenes n)) (size d z).
Proof.
  intros Z. rewrite size_is. intros e E.
  assert (L : Un_cv (fun n => total (square d (scenes n))) (total (square d z))).
  { unfold total. repeat apply CV_plus; apply dot_converges; intros k K; now apply Z. }
  destruct (L e E) as (m & M). exists m. intros n G. rewrite size_is. now apply M.
Qed.
Lemma size_later d s t : size d (later t s) = size d s + 2 * t * growth d s + t * t * motion2 d s.
Proof.
  rewrite !size_is. unfold growth, motion2, total, square, speed2, rate. rewrite !to_later, !square_of_combined. ring.
Qed.
Lemma growth_later d s t : growth d (later t s) = growth d s + t * motion2 d s.
Proof.
  unfold growth, motion2, total, speed2, rate. rewrite !to_later, !relative_later, !dot_linear. ring.
Qed.
Lemma motion2_later d s t : motion2 d (later t s) = motion2 d s.
Proof. reflexivity. Qed.
Lemma size_collided d r i j s : size d (collided d r i j s) = size d s.
Proof. reflexivity. Qed.

Section Struck.
Variable d : nat.
Variable r : R.
Variables i j : ball.
Variable s : scene.
Hypothesis differ : i <> j.
Hypothesis contact : distance d s i j = 1.
Let g := rate d s i j.
Let e := to s i j.
Lemma velocity_ij : relative (collided d r i j s) i j = combined 1 (relative s i j) (- ((1 + r) * g)) e.
Proof.
  apply same_vector. intros k. unfold relative, collided, combined, g, e. cbn [velocity].
  rewrite !same_true, (same_false j i) by congruence. field.
Qed.
Lemma velocity_jk k : k <> i -> k <> j ->
  relative (collided d r i j s) j k = combined 1 (relative s j k) ((1 + r) / 2 * g) e.
Proof.
  intros N M. apply same_vector. intros m. unfold relative, collided, combined, g, e. cbn [velocity].
  rewrite !same_true, (same_false j i), (same_false k i), (same_false k j) by congruence. ring.
Qed.
Lemma unit_e : dot d e e = 1.
Proof. exact (unit_square _ _ _ _ contact). Qed.
Lemma differences k : dot d e (relative s i k) - dot d e (relative s j k) = g.
Proof.
  unfold g, rate. fold e. replace (relative s i j) with (combined 1 (relative s i k) (-1) (relative s j k))
    by (apply same_vector; intros m; unfold combined, relative; ring).
  rewrite dot_linear_right. ring.
Qed.
Lemma growth_collided : growth d (collided d r i j s) = growth d s - 3 / 2 * (1 + r) * g.
Proof.
  destruct (total_is (rate d s) i j (rate_symmetric d s) differ) as (k & N & M & E).
  rewrite !growth_is. rewrite E. clear E.
  destruct (total_is (rate d (collided d r i j s)) i j (rate_symmetric d _) differ) as (k' & N' & M' & E).
  assert (k' = k) by (destruct i, j, k, k'; congruence). subst k'. rewrite E. clear E.
  unfold rate. rewrite !to_collided, velocity_ij, velocity_jk, velocity_collided by assumption.
  rewrite !dot_linear_right. fold e g. rewrite unit_e.
  replace (to s j k) with (combined 1 (to s i k) (-1) e)
    by (apply same_vector; intros m; unfold combined, e, to; ring).
  rewrite !dot_linear, unit_e. field.
Qed.
Lemma motion2_collided : motion2 d (collided d r i j s) = motion2 d s - 3 / 2 * (1 - r * r) * (g * g).
Proof.
  destruct (total_is (speed2 d s) i j (speed2_symmetric d s) differ) as (k & N & M & E).
  unfold motion2. rewrite E. clear E.
  destruct (total_is (speed2 d (collided d r i j s)) i j (speed2_symmetric d _) differ) as (k' & N' & M' & E).
  assert (k' = k) by (destruct i, j, k, k'; congruence). subst k'. rewrite E. clear E.
  unfold speed2. rewrite velocity_ij, velocity_jk, velocity_collided by assumption.
  fold g e. rewrite !square_of_combined, unit_e.
  pose proof (differences k) as D. rewrite (dot_symmetric d (relative s i j) e),
    (dot_symmetric d (relative s i k) e), (dot_symmetric d (relative s j k) e).
  change (dot d e (relative s i j)) with g. set (p := dot d e (relative s i k)) in *.
  replace (dot d e (relative s j k)) with (p - g) by lra. field.
Qed.
(* Each coordinate of a relative velocity changes by at most twice the momentum exchanged. *)
Lemma change_at_most a b k : (k < d)%nat -> 0 < 1 + r ->
  Rabs (relative (collided d r i j s) a b k - relative s a b k) <= (1 + r) * Rabs g.
Proof.
  intros K P. pose proof (coordinate_at_most d e k K) as C. rewrite unit_e in C.
  assert (X : Rabs (e k) <= 1).
  { pose proof (Rle_0_sqr (e k - 1)). pose proof (Rle_0_sqr (e k + 1)). unfold Rsqr in *. apply Rabs_le. split.
    - apply Rnot_lt_le. intros L. assert (1 < e k * e k) by (assert (1 * 1 < - e k * - e k) by (apply Rmult_gt_0_lt_compat; lra); lra). lra.
    - apply Rnot_lt_le. intros L. assert (1 * 1 < e k * e k) by (apply Rmult_gt_0_lt_compat; lra). lra. }
  assert (Y : exists q, -1 <= q <= 1 /\
    relative (collided d r i j s) a b k - relative s a b k = q * ((1 + r) * g * e k)).
  { unfold relative, collided. cbn [velocity]. fold g. fold e.
    destruct (same b i), (same b j), (same a i), (same a j);
    first [exists 0; split; [lra | field] | exists (1 / 2); split; [lra | field] | exists (- (1 / 2)); split; [lra | field]
      | exists 1; split; [lra | field] | exists (-1); split; [lra | field]]. }
  destruct Y as (q & Q & ->). rewrite !Rabs_mult, (Rabs_right (1 + r)) by lra.
  assert (Rabs q <= 1) by (apply Rabs_le; lra). pose proof (Rabs_pos q). pose proof (Rabs_pos g).
  pose proof (Rabs_pos (e k)).
  assert (0 <= (1 + r) * Rabs g) by (apply Rmult_le_pos; lra).
  apply Rle_trans with (1 * ((1 + r) * Rabs g * 1)); [|lra].
  apply Rmult_le_compat; try lra; [|apply Rmult_le_compat_l; lra].
  apply Rmult_le_pos; lra.
Qed.
(* Nor does the angular momentum change. *)
Lemma moment_symmetric x k l a b : moment x k l a b = moment x k l b a.
Proof. unfold moment, to, relative. ring. Qed.
Lemma spin_collided k l : spin (collided d r i j s) k l = spin s k l.
Proof.
  change (total (moment (collided d r i j s) k l) = total (moment s k l)).
  destruct (total_is (moment s k l) i j (moment_symmetric s k l) differ) as (b & N & M & E).
  rewrite E. clear E.
  destruct (total_is (moment (collided d r i j s) k l) i j (moment_symmetric _ k l) differ) as (b' & N' & M' & E).
  assert (b' = b) by (destruct i, j, b, b'; congruence). subst b'. rewrite E. clear E.
  unfold moment. rewrite !to_collided, velocity_ij, velocity_jk, velocity_collided by assumption.
  unfold combined, g, e, to. field.
Qed.
End Struck.
Lemma spin_later s t k l : spin (later t s) k l = spin s k l.
Proof. unfold spin, moment, to, relative, later. cbn [position velocity]. ring. Qed.
(* Cauchy and Schwarz for the sums over pairs. *)
Lemma growth_bounded d s : growth d s * growth d s <= size d s * motion2 d s.
Proof.
  set (q a b := dot d (combined (size d s) (relative s a b) (- growth d s) (to s a b))
    (combined (size d s) (relative s a b) (- growth d s) (to s a b))).
  assert (Q : forall a b, 0 <= q a b) by (intros; apply dot_self).
  assert (E : total q = size d s * (size d s * motion2 d s - growth d s * growth d s)).
  { assert (F : forall a b, q a b = size d s * size d s * speed2 d s a b -
      2 * size d s * growth d s * rate d s a b + growth d s * growth d s * square d s a b).
    { intros a b. unfold q. rewrite square_of_combined, (dot_symmetric d (relative s a b) (to s a b)).
      unfold speed2, rate, square. ring. }
    unfold total. rewrite !F. unfold motion2 at 1. unfold total.
    replace (growth d s * growth d s) with (growth d s * (rate d s B0 B1 + rate d s B0 B2 + rate d s B1 B2))
      by reflexivity.
    assert (Z : size d s = square d s B0 B1 + square d s B0 B2 + square d s B1 B2) by apply size_is.
    assert (G : growth d s = rate d s B0 B1 + rate d s B0 B2 + rate d s B1 B2) by reflexivity.
    set (n := size d s) in *. set (m := growth d s) in *. rewrite <- G.
    replace (m * m * square d s B0 B1) with (m * m * (n - square d s B0 B2 - square d s B1 B2))
      by (rewrite Z; ring).
    replace (rate d s B0 B1) with (m - rate d s B0 B2 - rate d s B1 B2) by (rewrite G; ring). ring. }
  destruct (Rle_lt_or_eq_dec 0 (size d s)) as [P|P].
  - rewrite size_is. unfold total. pose proof (square_positive d s B0 B1). pose proof (square_positive d s B0 B2).
    pose proof (square_positive d s B1 B2). lra.
  - assert (0 <= size d s * (size d s * motion2 d s - growth d s * growth d s)).
    { rewrite <- E. unfold total. pose proof (Q B0 B1). pose proof (Q B0 B2). pose proof (Q B1 B2). lra. }
    apply Rnot_lt_le. intros L.
    assert (0 < size d s * (growth d s * growth d s - size d s * motion2 d s)) by (apply Rmult_lt_0_compat; lra).
    lra.
  - rewrite <- P.
    assert (Z : forall a b, square d s a b = 0 -> rate d s a b = 0).
    { intros a b F. pose proof (cauchy_schwarz d (to s a b) (relative s a b)) as C.
      change (dot d (to s a b) (to s a b)) with (square d s a b) in C. rewrite F, Rmult_0_l in C.
      apply Rsqr_0_uniq. apply Rle_antisym; [|apply Rle_0_sqr]. rewrite Rsqr_pow2. exact C. }
    rewrite size_is in P. unfold total in P. pose proof (square_positive d s B0 B1). pose proof (square_positive d s B0 B2).
    pose proof (square_positive d s B1 B2).
    unfold growth, total. rewrite !Z by lra. lra.
Qed.
