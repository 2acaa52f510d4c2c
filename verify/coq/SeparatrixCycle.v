(* Orbits on the separatrix tend to a cycle of length two, because the map is increasing on it. If
   the ratio is 1, the cycle is a fixed point. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixExists SeparatrixCurve SeparatrixGraph.
Open Scope R_scope.
Set Default Proof Using "All".

(* --- sequences -------------------------------------------------------------------------------- *)

Lemma cv_even_odd (v : nat -> R) l :
  Un_cv (fun n => v (2 * n)%nat) l -> Un_cv (fun n => v (S (2 * n))) l -> Un_cv v l.
Proof.
  intros A B e E. destruct (A e E) as [i I]. destruct (B e E) as [j J]. exists (2 * i + 2 * j)%nat.
  intros n N. destruct (Nat.Even_or_Odd n) as [[k ->]|[k ->]].
  - apply I. lia.
  - rewrite Nat.add_1_r. apply J. lia.
Qed.
Lemma monotone_converges (v : nat -> R) (b : R) : (forall n, 0 <= v n <= b) ->
  (forall n, v n <= v (S n)) \/ (forall n, v (S n) <= v n) -> exists l, Un_cv v l /\ 0 <= l.
Proof.
  intros B [U|D].
  - destruct (growing_cv v U) as [l L].
    + exists b. intros x [n ->]. apply B.
    + exists l. split; [exact L|]. apply (cv_le _ _ _ _ (cv_const 0) L). intros n. apply B.
  - apply decreasing_converges; [exact D|]. intros n. apply B.
Qed.
Lemma ratio_even rho n : ratio rho (2 * n) = rho.
Proof. unfold ratio. now rewrite Nat.even_mul. Qed.
Lemma ratio_odd rho n : ratio rho (S (2 * n)) = / rho.
Proof. rewrite ratio_shift. apply ratio_even. Qed.
Lemma state_equal (x y : state) : q x = q y -> u x = u y -> x = y.
Proof. destruct x, y. simpl. now intros -> ->. Qed.

Section Increasing.
Variables r a : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Notation f := (separatrix_at r a R1 A1).

(* --- the map is increasing on the curve ------------------------------------------------------- *)

Lemma image_order rho x y : 0 < rho -> region x -> region y -> goes_on a rho x -> goes_on a rho y ->
  q (next r a rho y) <= q (next r a rho x) -> u (next r a rho x) <= u (next r a rho y) ->
  u x <= u y.
Proof.
  intros P X Y GX GY LQ LU.
  pose proof (next_q r a R1 A1 rho x P X GX) as QX.
  pose proof (next_q r a R1 A1 rho y P Y GY) as QY.
  pose proof (next_h r a R1 A1 rho x P X GX) as HX.
  pose proof (next_h r a R1 A1 rho y P Y GY) as HY.
  pose proof (next_u_range r a R1 A1 rho x P X GX) as UX.
  pose proof (next_u_range r a R1 A1 rho y P Y GY) as UY.
  pose proof (next_q_positive r a R1 A1 rho y P Y GY) as PQ.
  set (qx := q (next r a rho x)) in *. set (qy := q (next r a rho y)) in *.
  set (vx := u (next r a rho x)) in *. set (vy := u (next r a rho y)) in *.
  destruct X as [X0 [X1 X2]]. destruct Y as [Y0 [Y1 Y2]].
  (* k, l: (q + rho u)/(1 - u) and q/(1 - u); w: p/(1 - u). *)
  set (k := fun z => (q z + rho * u z) / (1 - u z)). set (l := fun z => q z / (1 - u z)).
  assert (W : forall z, u z < 1 -> p a rho z = (a - k z) * (1 - u z))
    by (intros z Z; unfold p, k; field; lra).
  assert (D : forall z, u z < 1 -> width rho z = (k z ^ 2 - l z ^ 2) * (1 - u z) ^ 2)
    by (intros z Z; unfold width, k, l; field; lra).
  assert (KL : forall z, u z < 1 -> k z - l z = rho * (u z / (1 - u z)))
    by (intros z Z; unfold k, l; field; lra).
  assert (L0 : forall z, 0 <= q z -> u z < 1 -> 0 <= l z).
  { intros z Z0 Z1. unfold l, Rdiv. apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra. }
  assert (E : forall z, 0 < u z < 1 -> 0 < u z / (1 - u z))
    by (intros z Z; apply Rdiv_lt_0_compat; lra).
  rewrite W in QX, QY, HX, HY by lra. rewrite D in HX, HY by lra.
  assert (QX' : qx * (a - k x) = r) by (apply Rmult_eq_reg_r with (1 - u x); lra).
  assert (QY' : qy * (a - k y) = r) by (apply Rmult_eq_reg_r with (1 - u y); lra).
  assert (HX' : h vx * (a - k x) ^ 2 = k x ^ 2 - l x ^ 2).
  { apply Rmult_eq_reg_r with ((1 - u x) ^ 2); [|apply pow_nonzero; lra]. rewrite <- HX. ring. }
  assert (HY' : h vy * (a - k y) ^ 2 = k y ^ 2 - l y ^ 2).
  { apply Rmult_eq_reg_r with ((1 - u y) ^ 2); [|apply pow_nonzero; lra]. rewrite <- HY. ring. }
  specialize (L0 x X0 X2) as LX. specialize (L0 y Y0 Y2) as LY.
  specialize (KL x X2) as KX. specialize (KL y Y2) as KY.
  specialize (E x (conj X1 X2)) as EX. specialize (E y (conj Y1 Y2)) as EY.
  set (gx := u x / (1 - u x)) in *. set (gy := u y / (1 - u y)) in *.
  assert (WX : 0 < a - k x) by (apply Rmult_lt_reg_l with qx; lra).
  assert (WL : a - k x <= a - k y).
  { apply Rnot_lt_le. intros N. apply (Rmult_lt_compat_l qy _ _ PQ) in N.
    assert (qy * (a - k x) <= qx * (a - k x)) by (apply Rmult_le_compat_r; lra). lra. }
  assert (H2 : k x ^ 2 - l x ^ 2 <= k y ^ 2 - l y ^ 2).
  { rewrite <- HX', <- HY'. pose proof (h_range vx UX). apply Rmult_le_compat; try lra.
    - apply pow_le. lra.
    - unfold h. assert (0 <= (vy - vx) * (2 - vx - vy)) by (apply Rmult_le_pos; lra). lra.
    - apply pow_incr. lra. }
  assert (RX : 0 < rho * gx) by now apply Rmult_lt_0_compat.
  assert (RY : 0 < rho * gy) by now apply Rmult_lt_0_compat.
  assert (LL : l y <= l x).
  { apply Rnot_lt_le. intros N.
    assert (0 < (l y - l x) * (l y + l x)) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= (k x - k y) * (k x + k y)) by (apply Rmult_le_pos; lra). lra. }
  assert (GG : gx <= gy).
  { apply Rnot_lt_le. intros N. assert (rho * gy < rho * gx) by now apply Rmult_lt_compat_l.
    assert ((k y - l y) * (k x + l x) < (k x - l x) * (k x + l x))
      by (apply Rmult_lt_compat_r; lra).
    assert ((k y - l y) * (k y + l y) <= (k y - l y) * (k x + l x))
      by (apply Rmult_le_compat_l; lra).
    lra. }
  unfold gx, gy in GG.
  assert (u x * (1 - u y) <= u y * (1 - u x)); [|lra].
  apply Rmult_le_compat_r with (r := (1 - u x) * (1 - u y)) in GG; [|apply Rmult_le_pos; lra].
  replace (u x / (1 - u x) * ((1 - u x) * (1 - u y))) with (u x * (1 - u y)) in GG by (field; lra).
  replace (u y / (1 - u y) * ((1 - u x) * (1 - u y))) with (u y * (1 - u x)) in GG by (field; lra).
  exact GG.
Qed.

Definition on_curve rho x := region x /\ u x = f rho (q x).
Lemma on_curve_unending rho x : 0 < rho -> on_curve rho x -> unending r a rho x.
Proof. intros P [X E]. apply unending_at_most with R1 A1; auto. lra. Qed.
Lemma on_curve_orbit rho x n : 0 < rho -> on_curve rho x ->
  on_curve (ratio rho n) (orbit r a rho x n).
Proof.
  intros P C. split; [|apply stays_on_curve; auto; apply C].
  apply (unending_orbit r a R1 A1 rho x n P (on_curve_unending rho x P C)).
Qed.
Lemma on_curve_next rho x : 0 < rho -> on_curve rho x -> on_curve (/ rho) (next r a rho x).
Proof. intros P C. exact (on_curve_orbit rho x 1 P C). Qed.
Lemma on_curve_equal rho x y : on_curve rho x -> on_curve rho y -> q x = q y -> x = y.
Proof. intros [_ X] [_ Y] E. apply state_equal; [exact E|]. now rewrite X, Y, E. Qed.

Lemma increasing rho x y : 0 < rho -> on_curve rho x -> on_curve rho y -> q x < q y ->
  q (next r a rho x) < q (next r a rho y).
Proof.
  intros P X Y L. apply Rnot_le_lt. intros N. assert (P' := inverse_positive rho P).
  destruct (unending_now _ _ R1 A1 _ _ (on_curve_unending rho x P X)) as [RX GX].
  destruct (unending_now _ _ R1 A1 _ _ (on_curve_unending rho y P Y)) as [RY GY].
  destruct (on_curve_next rho x P X) as [NX EX]. destruct (on_curve_next rho y P Y) as [NY EY].
  assert (u x <= u y).
  { apply (image_order rho x y); auto. rewrite EX, EY. apply f_decreasing; auto.
    split; [apply NY|exact N]. }
  destruct X as [_ X]. destruct Y as [_ Y]. destruct RX as [X0 [X1 X2]].
  assert (f rho (q y) < f rho (q x)) by (apply f_strict; lra). lra.
Qed.
Lemma nondecreasing rho x y : 0 < rho -> on_curve rho x -> on_curve rho y -> q x <= q y ->
  q (next r a rho x) <= q (next r a rho y).
Proof.
  intros P X Y L. destruct (Rle_lt_or_eq_dec _ _ L) as [M|E].
  - left. now apply increasing.
  - right. now rewrite (on_curve_equal rho x y X Y E).
Qed.

(* --- every orbit on the curve converges along even times -------------------------------------- *)

Lemma even_step rho x n : orbit r a rho x (2 * S n) =
  next r a (/ rho) (next r a rho (orbit r a rho x (2 * n))).
Proof.
  replace (2 * S n)%nat with (S (S (2 * n))) by lia.
  change (next r a (ratio rho (S (2 * n))) (next r a (ratio rho (2 * n)) (orbit r a rho x (2 * n)))
    = next r a (/ rho) (next r a rho (orbit r a rho x (2 * n)))).
  now rewrite ratio_odd, ratio_even.
Qed.
Lemma on_curve_even rho x n : 0 < rho -> on_curve rho x -> on_curve rho (orbit r a rho x (2 * n)).
Proof. intros P C. rewrite <- (ratio_even rho n) at 1. now apply on_curve_orbit. Qed.
Lemma even_converges rho x : 0 < rho -> on_curve rho x ->
  exists l, Un_cv (fun n => q (orbit r a rho x (2 * n))) l /\ 0 <= l.
Proof.
  intros P C. assert (P' := inverse_positive rho P). apply monotone_converges with a.
  - intros n. pose proof (on_curve_even rho x n P C) as Cn.
    destruct (unending_now _ _ R1 A1 _ _ (on_curve_unending _ _ P Cn)) as [X G].
    pose proof (q_less r a R1 A1 rho _ P X G). destruct X. lra.
  - set (y := fun n => orbit r a rho x (2 * n)).
    assert (STEP : forall m n, q (y m) <= q (y n) -> q (y (S m)) <= q (y (S n))).
    { intros m n L. unfold y. rewrite !even_step.
      apply nondecreasing; auto; try (apply on_curve_next; auto; now apply on_curve_even).
      apply nondecreasing; auto; now apply on_curve_even. }
    destruct (Rle_lt_dec (q (y 0%nat)) (q (y 1%nat))) as [L|L].
    + left. intros n. induction n; [exact L|]. now apply STEP.
    + right. intros n. induction n; [left; exact L|]. now apply STEP.
Qed.
Lemma continuous_tends (g : R -> R) (v : nat -> R) l : continuous_from_0 g -> 0 <= l ->
  (forall n, 0 <= v n) -> Un_cv v l -> Un_cv (fun n => g (v n)) (g l).
Proof.
  intros G L V C e E. destruct (G l e L E) as [d [D H]]. destruct (C d D) as [m M].
  exists m. intros n N. apply H; [apply V|]. exact (M n N).
Qed.
End Increasing.

Section Cycle.
Variables r a s : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Hypothesis S1 : 0 < s.
Hypothesis SR : s ^ 3 = r.
Hypothesis HIGH : s + s ^ 2 < a.
Notation f := (separatrix_at r a R1 A1).
Notation on_curve := (on_curve r a R1 A1).

Theorem tends_to_cycle rho x : 0 < rho -> on_curve rho x ->
  exists y, on_curve rho y /\ orbit r a rho y 2 = y /\
    Un_cv (fun n => q (orbit r a rho x n) - q (orbit r a rho y n)) 0 /\
    Un_cv (fun n => u (orbit r a rho x n) - u (orbit r a rho y n)) 0.
Proof.
  intros P C. assert (P' := inverse_positive rho P).
  destruct (even_converges r a R1 A1 rho x P C) as [l [L L0]].
  set (z := orbit r a rho x) in *.
  assert (Z : forall n, unending r a (ratio rho n) (z n)).
  { intros n. now apply unending_orbit, on_curve_unending with R1 A1. }
  assert (UL : Un_cv (fun n => u (z (2 * n)%nat)) (f rho l)).
  { apply cv_ext with (fun n => f rho (q (z (2 * n)%nat))).
    - intros n. symmetry. apply (on_curve_even r a R1 A1 rho x n P C).
    - apply (continuous_tends r a R1 A1 (f rho)); auto using f_continuous. intros n.
      apply (Z (2 * n)%nat). }
  destruct (Rle_lt_or_eq_dec 0 _ (f_not_negative r a R1 A1 rho P l)) as [F|F].
  - set (y := State l (f rho l)).
    pose proof (f_less_1 r a R1 A1 rho P l) as F1.
    assert (Y : on_curve rho y) by (split; [unfold region; simpl; lra|reflexivity]).
    pose proof (on_curve_unending r a R1 A1 rho y P Y) as HY.
    destruct (unending_now _ _ R1 A1 _ _ HY) as [RY GY].
    destruct (unending_now _ _ R1 A1 _ _ (unending_next r a R1 A1 _ _ P HY)) as [RN GN].
    assert (T0 : tends (fun n => z (2 * n)%nat) y) by (split; [exact L|exact UL]).
    assert (T1 : tends (fun n => next r a rho (z (2 * n)%nat)) (next r a rho y))
      by now apply next_tends.
    assert (T2 : tends (fun n => next r a (/ rho) (next r a rho (z (2 * n)%nat)))
      (next r a (/ rho) (next r a rho y))) by now apply next_tends.
    assert (CY : next r a (/ rho) (next r a rho y) = y).
    { apply state_equal.
      - apply UL_sequence with (fun n => q (z (2 * S n)%nat)).
        + apply cv_ext with (2 := proj1 T2). intros n. unfold z. now rewrite (even_step r a R1 A1).
        + exact (cv_shift _ _ L).
      - apply UL_sequence with (fun n => u (z (2 * S n)%nat)).
        + apply cv_ext with (2 := proj2 T2). intros n. unfold z. now rewrite (even_step r a R1 A1).
        + exact (cv_shift _ _ UL). }
    assert (EVEN : forall n, orbit r a rho y (2 * n) = y).
    { induction n; [reflexivity|]. now rewrite (even_step r a R1 A1), IHn. }
    assert (ODD : forall x n, orbit r a rho x (S (2 * n)) = next r a rho (orbit r a rho x (2 * n))).
    { intros v n. rewrite <- (ratio_even rho n) at 2. reflexivity. }
    assert (DIFF : forall g : state -> R, Un_cv (fun n => g (z (2 * n)%nat)) (g y) ->
      Un_cv (fun n => g (next r a rho (z (2 * n)%nat))) (g (next r a rho y)) ->
      Un_cv (fun n => g (z n) - g (orbit r a rho y n)) 0).
    { intros g G0 G1. apply cv_even_odd.
      - apply cv_ext with (fun n => g (z (2 * n)%nat) - g y); [intros n; now rewrite EVEN|].
        rewrite <- (Rminus_diag_eq (g y) (g y) eq_refl). apply CV_minus; [exact G0|apply cv_const].
      - apply cv_ext with (fun n => g (next r a rho (z (2 * n)%nat)) - g (next r a rho y)).
        { intros n. unfold z. now rewrite !ODD, EVEN. }
        rewrite <- (Rminus_diag_eq (g (next r a rho y)) _ eq_refl).
        apply CV_minus; [exact G1|apply cv_const]. }
    exists y. split; [exact Y|]. split; [exact (EVEN 1%nat)|].
    split; apply DIFF; solve [apply T0|apply T1].
  - (* u would tend to 0. *)
    exfalso. rewrite <- F in UL.
    apply (not_vanishing_on_curve r a s R1 A1 S1 SR HIGH rho x P (proj1 C) (proj2 C)).
    apply cv_even_odd; [exact UL|]. fold z.
    set (c := r ^ 2 * / (/ rho * (r / a) ^ 3)).
    assert (RA : 0 < r / a) by (apply Rdiv_lt_0_compat; lra).
    assert (C0 : 0 < / rho * (r / a) ^ 3) by (apply Rmult_lt_0_compat; [lra|apply pow_lt; lra]).
    assert (QL : forall n, r / a <= q (z (S n))).
    { intros n. destruct (unending_now _ _ R1 A1 _ _ (Z n)) as [X G].
      pose proof (ratio_positive rho n P) as Pn.
      pose proof (next_q_lower r a R1 A1 _ _ Pn X G) as I.
      pose proof (next_q_positive r a R1 A1 _ _ Pn X G) as J.
      change (next r a (ratio rho n) (z n)) with (z (S n)) in *. destruct X as [X _].
      apply Rmult_le_reg_r with a; [lra|]. replace (r / a * a) with r by (field; lra). nra. }
    apply cv_squeeze with (fun n => c * u (z (2 * S n)%nat)).
    + intros n. destruct (unending_now _ _ R1 A1 _ _ (Z (S (2 * n)))) as [X G].
      rewrite ratio_odd in G. split; [left; apply X|].
      pose proof (next_u_lower r a R1 A1 _ _ P' X G) as I.
      replace (next r a (/ rho) (z (S (2 * n)))) with (z (S (S (2 * n)))) in I
        by (rewrite <- (ratio_odd rho n); reflexivity).
      replace (2 * S n)%nat with (S (S (2 * n))) by lia.
      pose proof (QL (2 * n)%nat) as Q1. pose proof (QL (S (2 * n))) as Q2.
      apply Rmult_le_reg_r with (/ rho * (r / a) ^ 3); [exact C0|].
      unfold c. replace (r ^ 2 * / (/ rho * (r / a) ^ 3) * u (z (S (S (2 * n)))) *
        (/ rho * (r / a) ^ 3)) with (u (z (S (S (2 * n)))) * r ^ 2) by (field; lra).
      apply Rle_trans with (2 := I). destruct X as [_ [X _]].
      replace (u (z (S (2 * n))) * (/ rho * (r / a) ^ 3))
        with (/ rho * u (z (S (2 * n))) * (r / a * (r / a) ^ 2)) by ring.
      rewrite (Rmult_assoc _ (q _)). apply Rmult_le_compat_l.
      * left. now apply Rmult_lt_0_compat.
      * apply Rmult_le_compat; try lra; [apply pow_le; lra|]. apply pow_incr. lra.
    + replace 0 with (c * 0) by ring. apply CV_mult; [apply cv_const|].
      exact (cv_shift _ _ UL).
Qed.

(* --- cycles ----------------------------------------------------------------------------------- *)

Lemma cycle_on_curve rho y : 0 < rho -> unending r a rho y -> orbit r a rho y 2 = y ->
  on_curve rho y.
Proof.
  intros P H C. assert (X := proj1 H). split; [exact X|].
  apply Rle_antisym; [now apply f_upper|]. apply Rnot_lt_le. intros L.
  destruct (fades_under_curve r a R1 A1 rho P y X L) as [_ V].
  assert (EVEN : forall n, orbit r a rho y (2 * n) = y).
  { induction n; [reflexivity|]. rewrite (even_step r a R1 A1), IHn. exact C. }
  destruct X as [_ [U _]]. destruct (V (u y) U) as [m M]. specialize (M (2 * m)%nat ltac:(lia)).
  rewrite EVEN in M. unfold R_dist in M. rewrite Rminus_0_r, Rabs_pos_eq in M; lra.
Qed.
Lemma cycle_fixed y : on_curve 1 y -> orbit r a 1 y 2 = y -> next r a 1 y = y.
Proof.
  intros Y C. assert (P := Rlt_0_1). pose proof (on_curve_next r a R1 A1 1 y P Y) as N.
  rewrite Rinv_1 in N. change (orbit r a 1 y 2) with (next r a (/ 1) (next r a 1 y)) in C.
  rewrite Rinv_1 in C. symmetry. apply (on_curve_equal r a R1 A1 1); auto.
  destruct (Rtotal_order (q y) (q (next r a 1 y))) as [L|[E|L]]; [|exact E|].
  - pose proof (increasing r a R1 A1 1 _ _ P Y N L) as M. rewrite C in M. lra.
  - pose proof (increasing r a R1 A1 1 _ _ P N Y L) as M. rewrite C in M. lra.
Qed.
End Cycle.
