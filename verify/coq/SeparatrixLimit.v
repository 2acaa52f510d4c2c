(* In the regime q tends to phi_minus: from below because every q is at least r/(a - q before), from
   above because u is small when q is below s, and stays so. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixExists SeparatrixCurve SeparatrixGraph.
Open Scope R_scope.
Set Default Proof Using "All".

Section Limit.
Variables r a s : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Hypothesis S1 : 0 < s.
Hypothesis SR : s ^ 3 = r.
Hypothesis HIGH : s + s ^ 2 < a.

Notation m := (phi_minus r a).
Notation t := (phi_plus r a).

Lemma roots : m + t = a /\ m * t = r /\ 0 < m < s ^ 2 /\ s < t.
Proof.
  destruct (phi_plus_root r a s R1 A1 S1 SR HIGH) as [E [B1 B2]].
  assert (S : m + t = a) by (unfold phi_minus, phi_plus; lra).
  assert (m = a - t) by lra. split; [exact S|]. rewrite H. split; [lra|].
  pose proof (s_less r a s R1 A1 S1 SR). nra.
Qed.

Section Orbit.
Variable rho : R.
Variable x : state.
Hypothesis P : 0 < rho.
Hypothesis H : unending r a rho x.
Notation y := (orbit r a rho x).

Lemma states n : region (y n) /\ goes_on a (ratio rho n) (y n).
Proof. now apply (unending_now r a R1 A1), unending_orbit. Qed.
Lemma from_below n : m - q (y n) <= (m / t) ^ n * m.
Proof.
  destruct roots as [SUM [PROD [M T]]]. pose proof (s_less r a s R1 A1 S1 SR) as S2.
  set (c := m / t). assert (C : 0 < c) by (apply Rdiv_lt_0_compat; lra).
  assert (CT : c * t = m) by (unfold c; field; lra).
  induction n; [simpl; destruct (states 0) as [[Q _] _]; simpl in Q; lra|].
  destruct (states n) as [X G]. pose proof (ratio_positive rho n P) as Pn.
  pose proof (next_q_lower r a R1 A1 _ _ Pn X G) as L.
  pose proof (next_q_positive r a R1 A1 _ _ Pn X G) as Q.
  change (next r a (ratio rho n) (y n)) with (y (S n)) in *.
  set (z := q (y (S n))) in *. set (w := q (y n)) in *.
  assert (K : 0 < c ^ n) by now apply pow_lt.
  change (c ^ S n) with (c * c ^ n). rewrite Rmult_assoc.
  destruct (Rle_lt_dec m w) as [N|N].
  - assert (m <= z).
    { apply Rnot_lt_le. intros Z. assert (z * (a - w) <= z * t) by (apply Rmult_le_compat_l; lra).
      assert (z * t < m * t) by (apply Rmult_lt_compat_r; lra). lra. }
    assert (0 < c ^ n * m) by (apply Rmult_lt_0_compat; lra).
    assert (0 < c * (c ^ n * m)) by now apply Rmult_lt_0_compat. lra.
  - apply Rle_trans with (c * (m - w)); [|apply Rmult_le_compat_l; lra].
    apply Rnot_lt_le. intros Z. assert (Z' : z < m - c * (m - w)) by lra.
    assert (z * (a - w) < (m - c * (m - w)) * (a - w)) by (apply Rmult_lt_compat_r; lra).
    assert (E : (m - c * (m - w)) * (a - w) = m * t - c * (m - w) ^ 2).
    { replace (a - w) with (t + (m - w)) by lra.
      replace ((m - c * (m - w)) * (t + (m - w)))
        with (m * t + m * (m - w) - (c * t) * (m - w) - c * (m - w) ^ 2) by ring.
      rewrite CT. ring. }
    assert (0 <= c * (m - w) ^ 2) by (apply Rmult_le_pos; [lra|apply pow2_ge_0]). lra.
Qed.

(* From above: while q lies in [b, s], it falls by a fixed amount; then it stays below b. *)
Variable b : R.
Hypothesis B : m < b <= s.
Definition gap := (b - m) * (t - s).
Definition fall := gap / (2 * a).
Definition tiny := gap / (2 * s * (a + (rho + / rho))).
Lemma gap_positive : 0 < gap.
Proof. destruct roots as [_ [_ [_ T]]]. unfold gap. apply Rmult_lt_0_compat; lra. Qed.
Lemma falls n : q (y n) <= s -> u (y n) <= tiny -> q (y (S n)) <= Rmax b (q (y n) - fall).
Proof.
  intros Q U. pose proof gap_positive as D. destruct roots as [SUM [PROD [M T]]].
  destruct (states n) as [X G]. pose proof (ratio_positive rho n P) as Pn.
  assert (P' := inverse_positive rho P).
  assert (RB : ratio rho n <= rho + / rho)
    by (unfold ratio; destruct (Nat.even n); lra).
  assert (TINY : s * ((a + (rho + / rho)) * tiny) = gap / 2).
  { unfold tiny. assert (0 < a + (rho + / rho)) by lra. set (k := a + (rho + / rho)) in *.
    field. lra. }
  assert (FALL : fall * a = gap / 2) by (unfold fall; field; lra).
  assert (F0 : 0 < fall) by (apply Rdiv_lt_0_compat; lra).
  assert (ROOM : forall v, b <= v <= s -> r + gap <= v * (a - v)).
  { intros v V. assert (gap <= (v - m) * (t - v)) by (apply Rmult_le_compat; lra).
    assert (v * a = v * (m + t)) by now rewrite SUM. lra. }
  assert (STEP : forall c, 0 <= c <= s -> r + gap / 2 <= c * (a - q (y n)) ->
    q (y (S n)) <= c).
  { intros c C L. apply (next_q_le r a R1 A1 (ratio rho n) (y n) Pn X G). destruct X as [_ X].
    replace (c * p a (ratio rho n) (y n))
      with (c * (a - q (y n)) - c * ((a + ratio rho n) * u (y n))) by (unfold p; ring).
    assert (c * ((a + ratio rho n) * u (y n)) <= s * ((a + (rho + / rho)) * tiny)).
    { apply Rmult_le_compat; try lra.
      - apply Rmult_le_pos; lra.
      - apply Rmult_le_compat; lra. }
    assert (0 <= r * u (y n)) by (apply Rmult_le_pos; lra). lra. }
  pose proof (Rmax_l b (q (y n) - fall)). pose proof (Rmax_r b (q (y n) - fall)).
  destruct X as [X0 _]. destruct (Rle_lt_dec (q (y n)) b) as [N|N].
  - apply Rle_trans with b; [|lra]. apply STEP; [lra|]. specialize (ROOM b ltac:(lra)).
    assert (b * (a - b) <= b * (a - q (y n))) by (apply Rmult_le_compat_l; lra). lra.
  - apply Rle_trans with (q (y n) - fall); [|lra]. specialize (ROOM (q (y n)) ltac:(lra)).
    assert (L : r + gap / 2 <= (q (y n) - fall) * (a - q (y n))).
    { assert (fall * (a - q (y n)) <= fall * a) by (apply Rmult_le_compat_l; lra). lra. }
    apply STEP; [|exact L]. split; [|lra]. apply Rnot_lt_le. intros Z.
    pose proof (q_less r a R1 A1 _ _ Pn (proj1 (states n)) G). nra.
Qed.
Lemma from_above k : (forall n, (k <= n)%nat -> u (y n) <= tiny) -> q (y k) <= s ->
  exists N, forall n, (N <= n)%nat -> q (y n) <= b.
Proof.
  intros U Q. pose proof gap_positive as D.
  assert (F0 : 0 < fall) by (apply Rdiv_lt_0_compat; lra).
  assert (ALL : forall n, q (y (k + n)) <= Rmax b (s - INR n * fall) /\ q (y (k + n)) <= s).
  { induction n.
    - rewrite Nat.add_0_r. simpl INR. replace (s - 0 * fall) with s by ring.
      split; [|exact Q]. apply Rle_trans with (1 := Q), Rmax_r.
    - destruct IHn as [I J]. rewrite Nat.add_succ_r, S_INR.
      pose proof (falls (k + n) J (U (k + n)%nat ltac:(lia))) as L. split.
      + apply Rle_trans with (1 := L). apply Rmax_lub; [apply Rmax_l|].
        unfold Rmax at 1 in I. destruct Rle_dec in I.
        * apply Rle_trans with (s - (INR n + 1) * fall); [lra|apply Rmax_r].
        * apply Rle_trans with b; [lra|apply Rmax_l].
      + apply Rle_trans with (1 := L). apply Rmax_lub; lra. }
  destruct (archimed ((s - b) / fall)) as [N _].
  assert (N0 : 0 <= (s - b) / fall).
  { unfold Rdiv. apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat. }
  exists (k + Z.to_nat (up ((s - b) / fall)))%nat. intros n L.
  replace n with (k + (n - k))%nat by lia. apply Rle_trans with (1 := proj1 (ALL (n - k)%nat)).
  apply Rmax_lub; [lra|].
  assert (I : (s - b) / fall <= INR (n - k)).
  { apply Rle_trans with (INR (Z.to_nat (up ((s - b) / fall)))).
    - rewrite INR_IZR_INZ, Z2Nat.id; [lra|]. apply le_IZR. lra.
    - apply le_INR. lia. }
  apply Rmult_le_compat_r with (r := fall) in I; [|lra].
  replace ((s - b) / fall * fall) with (s - b) in I by (field; lra). lra.
Qed.
End Orbit.

Theorem q_tends rho x : 0 < rho -> fades r a rho x ->
  Un_cv (fun n => q (orbit r a rho x n)) (phi_minus r a).
Proof.
  intros P [H V] e E. destruct roots as [SUM [PROD [M T]]].
  pose proof (s_less r a s R1 A1 S1 SR) as S2.
  set (b := Rmin (m + e / 2) s).
  assert (B : m < b <= s) by (split; [apply Rmin_glb_lt; nra|apply Rmin_r]).
  assert (BE : b <= m + e / 2) by apply Rmin_l.
  assert (P' := inverse_positive rho P).
  assert (D : 0 < tiny rho b).
  { apply Rdiv_lt_0_compat; [now apply (gap_positive rho x P H b B)|].
    apply Rmult_lt_0_compat; lra. }
  destruct (V _ D) as [i I].
  destruct (gets_low r a s R1 A1 S1 SR HIGH rho x _ i P H V D) as [k [K [Q _]]].
  destruct (from_above rho x P H b B k) as [j J]; [|lra|].
  { intros n N. specialize (I n ltac:(lia)). unfold R_dist in I. rewrite Rminus_0_r in I.
    apply Rlt_le, Rle_lt_trans with (2 := I), Rle_abs. }
  assert (C : Rabs (m / t) < 1).
  { assert (m / t < 1).
    { apply Rmult_lt_reg_r with t; [lra|]. replace (m / t * t) with m by (field; lra). nra. }
    assert (0 < m / t) by (apply Rdiv_lt_0_compat; lra). rewrite Rabs_pos_eq; lra. }
  destruct (pow_lt_1_zero _ C (e / m)) as [l L]; [apply Rdiv_lt_0_compat; lra|].
  exists (j + l)%nat. intros n N. specialize (J n ltac:(lia)). specialize (L n ltac:(lia)).
  pose proof (from_below rho x P H n) as Z. unfold R_dist.
  assert ((m / t) ^ n * m < e).
  { replace e with (e / m * m) by (field; lra). apply Rmult_lt_compat_r; [lra|].
    apply Rle_lt_trans with (2 := L), Rle_abs. }
  apply Rabs_def1; lra.
Qed.
End Limit.
