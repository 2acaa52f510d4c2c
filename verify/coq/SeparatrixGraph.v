(* On the separatrix u does not tend to 0. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixExists SeparatrixCurve.
Open Scope R_scope.
Set Default Proof Using "All".

Section Graph.
Variables r a s : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Hypothesis S1 : 0 < s.
Hypothesis SR : s ^ 3 = r.
Hypothesis HIGH : s + s ^ 2 < a.

Notation f := (separatrix_at r a R1 A1).

(* If u tends to 0, q gets below s again and again: otherwise u grows over two steps. *)
Lemma gets_low rho x e N : 0 < rho -> unending r a rho x -> vanishing r a rho x -> 0 < e ->
  exists n, (N <= n)%nat /\ q (orbit r a rho x n) < s /\ u (orbit r a rho x n) < e.
Proof.
  intros P H V E. set (y := orbit r a rho x) in *.
  assert (Y : forall n, unending r a (ratio rho n) (y n)) by (intros; now apply unending_orbit).
  destruct (V e E) as [m' M']. set (m := (N + m')%nat).
  assert (M : forall n, (m <= n)%nat -> u (y n) < e).
  { intros n L. specialize (M' n ltac:(lia)). unfold R_dist in M'. rewrite Rminus_0_r in M'.
    apply Rle_lt_trans with (2 := M'). apply Rle_abs. }
  destruct (Classical_Prop.classic (exists n, (m <= n)%nat /\ q (y n) < s)) as [[n [L Q]]|ALL].
  { exists n. split; [lia|]. auto. }
  exfalso. pose proof (s_less r a s R1 A1 S1 SR) as S2.
  assert (U : forall n, 0 < u (y n)) by (intros n; apply (Y n)).
  assert (Q : forall n, (m <= n)%nat -> s <= q (y n)).
  { intros n L. apply Rnot_lt_le. intros Z. apply ALL. now exists n. }
  assert (ONE : forall n, (m <= n)%nat -> ratio rho n * u (y n) <= u (y (S n))).
  { intros n L. pose proof (Q n L) as Q0. pose proof (Q (S n) ltac:(lia)) as Q1.
    pose proof (ratio_positive rho n P) as Pn. destruct (unending_now _ _ R1 A1 _ _ (Y n)) as [X G].
    pose proof (next_u_lower r a R1 A1 (ratio rho n) (y n) Pn X G) as I.
    change (next r a (ratio rho n) (y n)) with (y (S n)) in I. specialize (U n).
    assert (0 < ratio rho n * u (y n)) by now apply Rmult_lt_0_compat.
    assert (C : r <= q (y n) * q (y (S n)) ^ 2).
    { rewrite <- SR. replace (s ^ 3) with (s * s ^ 2) by ring.
      apply Rmult_le_compat; try lra; [nra|]. apply pow_incr. lra. }
    assert (r ^ 2 <= r) by nra.
    assert (0 < r ^ 2) by (apply pow_lt; lra).
    apply Rmult_le_reg_r with (r ^ 2); [lra|]. apply Rle_trans with (2 := I).
    rewrite (Rmult_assoc _ (q (y n))). apply Rmult_le_compat_l; lra. }
  assert (TWO : forall n, (m <= n)%nat -> u (y n) <= u (y (S (S n)))).
  { intros n L. pose proof (ONE n L) as I. pose proof (ONE (S n) ltac:(lia)) as J.
    apply Rle_trans with (2 := J).
    apply Rmult_le_compat_l with (r := ratio rho (S n)) in I; [|left; now apply ratio_positive].
    rewrite <- Rmult_assoc, ratio_turn in I; lra. }
  assert (LOW : forall n, u (y m) <= u (y (m + 2 * n)%nat)).
  { induction n; [rewrite Nat.add_0_r; lra|]. apply Rle_trans with (1 := IHn).
    replace (m + 2 * S n)%nat with (S (S (m + 2 * n))) by lia. apply TWO. lia. }
  destruct (V (u (y m)) (U m)) as [k K]. specialize (K (m + 2 * k)%nat ltac:(lia)).
  specialize (LOW k). specialize (U (m + 2 * k)%nat). fold y in K. unfold R_dist in K.
  rewrite Rminus_0_r, Rabs_pos_eq in K; lra.
Qed.
Lemma not_vanishing_on_curve rho x : 0 < rho -> region x -> u x = f rho (q x) ->
  ~ vanishing r a rho x.
Proof.
  intros P X E V. assert (H : unending r a rho x) by (apply unending_at_most with R1 A1; auto; lra).
  assert (RE : reached r a s).
  { apply (reached_up_to r a s R1 A1 S1 SR HIGH).
    pose proof (phi_plus_root r a s R1 A1 S1 SR HIGH). nra. }
  destruct (RE rho P) as [c [C HC]]. destruct (RE _ (inverse_positive rho P)) as [d [D HD]].
  assert (L : forall n, Rmin c d <= f (ratio rho n) s).
  { intros n. unfold ratio. destruct (Nat.even n).
    - apply Rle_trans with (1 := Rmin_l _ _).
      exact (f_upper r a R1 A1 rho P _ HC).
    - apply Rle_trans with (1 := Rmin_r _ _).
      exact (f_upper r a R1 A1 _ (inverse_positive rho P) _ HD). }
  destruct (gets_low rho x (Rmin c d) 0 P H V) as [n [_ [Q U]]]; [now apply Rmin_glb_lt|].
  specialize (L n). pose proof (ratio_positive rho n P) as Pn.
  pose proof (unending_orbit r a R1 A1 rho x n P H) as [[Q0 _] _].
  rewrite (stays_on_curve r a R1 A1 rho x n P X E) in U.
  assert (f (ratio rho n) s <= f (ratio rho n) (q (orbit r a rho x n)))
    by (apply f_decreasing; lra). lra.
Qed.
End Graph.
