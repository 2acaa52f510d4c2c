(* When collisions can go on for ever: if and only if a > s + s^2, where s is the cube root of r. Then
   they do so from small u for every q below phi_plus, and for no q from phi_plus on. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
Open Scope R_scope.
Set Default Proof Using "All".

Section Exists.
Variables r a s : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Hypothesis S1 : 0 < s.
Hypothesis SR : s ^ 3 = r.

Lemma s_less : s < 1.
Proof. apply Rnot_le_lt. intros N. assert (1 <= s ^ 3) by (apply pow_R1_Rle; lra). lra. Qed.

(* --- if a <= s + s^2, u does not tend to 0 ---------------------------------------------------- *)

Section Low.
Hypothesis LOW : a <= s + s ^ 2.

(* How far q is below s^2, relatively. *)
Definition deficit (x : state) := Rmax 0 (1 - q x / s ^ 2).
Definition constant := 6 / (1 - s).
Definition weight (x : state) := u x / q x ^ 2 * exp (- constant * deficit x).

Lemma next_q_half rho x : 0 < rho -> unending r a rho x -> s ^ 2 / 2 <= q (next r a rho x).
Proof.
  intros P H. destruct (unending_now _ _ R1 A1 _ _ H) as [X G].
  pose proof (next_q_lower r a R1 A1 rho x P X G) as L.
  pose proof (next_q_positive r a R1 A1 rho x P X G) as Q. pose proof s_less as S2.
  pose proof (q_less r a R1 A1 rho x P X G). destruct X as [X0 _].
  assert (r < q (next r a rho x) * (s + s ^ 2)) by nra. rewrite <- SR in *.
  apply Rmult_le_reg_r with (s + s ^ 2); [nra|].
  assert (s ^ 2 / 2 * (s + s ^ 2) <= s ^ 3); [|lra].
  assert (0 < s ^ 3) by lra. replace (s ^ 2 / 2 * (s + s ^ 2)) with (s ^ 3 * ((1 + s) / 2)) by field.
  nra.
Qed.
Lemma deficit_falls rho x : 0 < rho -> unending r a rho x ->
  deficit (next r a rho x) <= s * deficit x.
Proof.
  intros P H. destruct (unending_now _ _ R1 A1 _ _ H) as [X G].
  pose proof (next_q_lower r a R1 A1 rho x P X G) as L.
  pose proof (next_q_positive r a R1 A1 rho x P X G) as Q. pose proof s_less as S2.
  set (y := q (next r a rho x)) in *. assert (L' : s ^ 3 < y * (s + s ^ 2 - q x)) by nra.
  assert (S3 : 0 < s ^ 2) by nra.
  assert (D0 : 0 <= deficit x) by apply Rmax_l.
  assert (D1 : 1 - q x / s ^ 2 <= deficit x) by apply Rmax_r.
  unfold deficit at 1. fold y. apply Rmax_lub; [apply Rmult_le_pos; lra|].
  set (v := q x / s ^ 2) in *. set (w := y / s ^ 2).
  assert (EV : q x = v * s ^ 2) by (unfold v; field; lra).
  assert (EW : y = w * s ^ 2) by (unfold w; field; lra).
  assert (W : 0 < w) by (unfold w; apply Rdiv_lt_0_compat; lra).
  assert (L2 : 1 < w * (1 + s * (1 - v))).
  { apply Rmult_lt_reg_r with (s ^ 3); [apply pow_lt; lra|]. rewrite EV, EW in L'. lra. }
  assert (w * (s * (1 - v)) <= w * (s * deficit x)).
  { apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
  assert (0 <= s * deficit x) by (apply Rmult_le_pos; lra). nra.
Qed.
Lemma exp_bound y : 0 <= y <= 1 / 2 -> exp (- (6 * y)) <= (1 - y) ^ 3.
Proof.
  intros Y. replace (- (6 * y)) with (- (2 * y) + (- (2 * y) + - (2 * y))) by ring.
  rewrite !exp_plus. assert (E : exp (- (2 * y)) <= 1 - y).
  { pose proof (exp_ineq1_le (2 * y)) as I. rewrite exp_Ropp.
    apply Rmult_le_reg_r with (exp (2 * y)); [apply exp_pos|].
    rewrite Rinv_l; [nra|]. pose proof (exp_pos (2 * y)). lra. }
  pose proof (exp_pos (- (2 * y))). simpl. rewrite Rmult_1_r.
  apply Rmult_le_compat; nra.
Qed.
Lemma weight_grows rho x : 0 < rho -> unending r a rho x -> s ^ 2 / 2 <= q x ->
  rho * weight x <= weight (next r a rho x).
Proof.
  intros P H Q. destruct (unending_now _ _ R1 A1 _ _ H) as [X G].
  pose proof (next_u_lower r a R1 A1 rho x P X G) as L.
  pose proof (next_q_positive r a R1 A1 rho x P X G) as QN. pose proof s_less as S2.
  pose proof (deficit_falls rho x P H) as D. destruct X as [X0 [X1 X2]].
  assert (S3 : 0 < s ^ 2) by nra.
  assert (D0 : 0 <= deficit x) by apply Rmax_l.
  assert (D1 : 1 - q x / s ^ 2 <= deficit x) by apply Rmax_r.
  assert (D2 : deficit x <= 1 / 2).
  { unfold deficit. apply Rmax_lub; [lra|]. apply Rmult_le_reg_r with (s ^ 2); [lra|].
    unfold Rdiv at 1. rewrite Rmult_minus_distr_r, Rmult_assoc, Rinv_l; lra. }
  set (y := next r a rho x) in *.
  assert (E : exp (- (6 * deficit x)) <= (q x / s ^ 2) ^ 3).
  { apply Rle_trans with (1 := exp_bound (deficit x) (conj D0 D2)). apply pow_incr. lra. }
  assert (E2 : exp (- constant * deficit x) <= (q x / s ^ 2) ^ 3 * exp (- constant * deficit y)).
  { apply Rle_trans with (exp (- (6 * deficit x)) * exp (- constant * deficit y)).
    - rewrite <- exp_plus.
      assert (C : constant * (1 - s) = 6) by (unfold constant; field; lra).
      assert (0 < constant) by (unfold constant; apply Rdiv_lt_0_compat; lra).
      assert (LE : - constant * deficit x <= - (6 * deficit x) + - constant * deficit y).
      { assert (constant * deficit y <= constant * (s * deficit x))
          by (apply Rmult_le_compat_l; lra). rewrite <- C. lra. }
      destruct (Rle_lt_or_eq_dec _ _ LE) as [LT|EQ];
        [left; now apply exp_increasing|rewrite EQ; lra].
    - apply Rmult_le_compat_r; [left; apply exp_pos|exact E]. }
  unfold weight.
  apply Rle_trans with (rho * (u x / q x ^ 2) * ((q x / s ^ 2) ^ 3 * exp (- constant * deficit y))).
  { rewrite <- Rmult_assoc. apply Rmult_le_compat_l; [|exact E2].
    apply Rmult_le_pos; [lra|]. left. apply Rdiv_lt_0_compat; [lra|]. apply pow_lt. lra. }
  rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [left; apply exp_pos|].
  replace (rho * (u x / q x ^ 2) * (q x / s ^ 2) ^ 3) with (rho * u x * q x / r ^ 2)
    by (rewrite <- SR; field; lra).
  assert (0 < r ^ 2) by (apply pow_lt; lra). assert (0 < q y ^ 2) by (apply pow_lt; lra).
  apply Rmult_le_reg_r with (r ^ 2 * q y ^ 2); [now apply Rmult_lt_0_compat|].
  replace (rho * u x * q x / r ^ 2 * (r ^ 2 * q y ^ 2)) with (rho * u x * q x * q y ^ 2)
    by (field; lra).
  replace (u y / q y ^ 2 * (r ^ 2 * q y ^ 2)) with (u y * r ^ 2) by (field; lra). exact L.
Qed.
Lemma weight_bound x : s ^ 2 / 2 <= q x -> 0 < u x -> weight x <= u x * (4 / s ^ 4).
Proof.
  intros Q U. assert (S2 : 0 < s ^ 2) by nra.
  assert (D0 : 0 <= deficit x) by apply Rmax_l.
  assert (C : 0 < constant) by (pose proof s_less; unfold constant; apply Rdiv_lt_0_compat; lra).
  assert (E : exp (- constant * deficit x) <= 1).
  { rewrite <- exp_0. destruct (Rle_lt_or_eq_dec 0 _ D0) as [L|Z].
    - left. apply exp_increasing. nra.
    - rewrite <- Z, Rmult_0_r. lra. }
  assert (I : / q x ^ 2 <= 4 / s ^ 4).
  { replace (4 / s ^ 4) with (/ (s ^ 2 / 2) ^ 2) by (field; lra).
    apply Rinv_le_contravar; [apply pow_lt; lra|apply pow_incr; lra]. }
  assert (0 < / q x ^ 2) by (apply Rinv_0_lt_compat, pow_lt; lra).
  unfold weight, Rdiv. rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
  pose proof (exp_pos (- constant * deficit x)). unfold Rdiv in I. nra.
Qed.
Lemma not_vanishing_low rho x : 0 < rho -> unending r a rho x -> ~ vanishing r a rho x.
Proof.
  intros P H V. set (y := orbit r a rho x).
  assert (Y : forall n, unending r a (ratio rho n) (y n)) by (intros; now apply unending_orbit).
  assert (U : forall n, 0 < u (y n)) by (intros n; apply (Y n)).
  assert (Q : forall n, s ^ 2 / 2 <= q (y (S n))).
  { intros n. apply next_q_half; auto using ratio_positive. }
  assert (W : forall n, weight (y 1%nat) <= weight (y (2 * n + 1)%nat)).
  { induction n; [simpl; lra|]. apply Rle_trans with (1 := IHn).
    pose proof (ratio_positive rho (2 * n + 1) P) as P1.
    replace (2 * S n + 1)%nat with (S (S (2 * n + 1))) by lia.
    assert (Q1 : s ^ 2 / 2 <= q (y (2 * n + 1)%nat)) by (rewrite Nat.add_1_r; apply Q).
    pose proof (weight_grows _ _ P1 (Y (2 * n + 1)%nat) Q1) as G1.
    pose proof (weight_grows _ _ (ratio_positive rho _ P) (Y (S (2 * n + 1))) (Q _)) as G2.
    change (next r a (ratio rho (2 * n + 1)) (y (2 * n + 1)%nat)) with (y (S (2 * n + 1))) in G1.
    change (next r a (ratio rho (S (2 * n + 1))) (y (S (2 * n + 1))))
      with (y (S (S (2 * n + 1)))) in G2.
    assert (E : ratio rho (S (2 * n + 1)) * ratio rho (2 * n + 1) = 1).
    { unfold ratio. rewrite Nat.even_succ, <- Nat.negb_even.
      destruct (Nat.even (2 * n + 1)); simpl; field; lra. }
    apply Rmult_le_compat_l with (r := ratio rho (S (2 * n + 1))) in G1;
      [|left; now apply ratio_positive].
    rewrite <- Rmult_assoc, E in G1. lra. }
  assert (W0 : 0 < weight (y 1%nat)).
  { unfold weight. apply Rmult_lt_0_compat; [|apply exp_pos]. apply Rdiv_lt_0_compat; [apply U|].
    apply pow_lt. specialize (Q 0%nat). nra. }
  assert (S4 : 0 < 4 / s ^ 4) by (apply Rdiv_lt_0_compat; [lra|apply pow_lt; lra]).
  destruct (V (weight (y 1%nat) / (4 / s ^ 4))) as [m M]; [now apply Rdiv_lt_0_compat|].
  specialize (M (2 * m + 1)%nat ltac:(lia)). specialize (W m). unfold R_dist in M.
  fold y in M. specialize (U (2 * m + 1)%nat).
  rewrite Rminus_0_r, Rabs_pos_eq in M; [|lra].
  apply Rmult_lt_compat_r with (r := 4 / s ^ 4) in M; [|exact S4].
  replace (weight (y 1%nat) / (4 / s ^ 4) * (4 / s ^ 4)) with (weight (y 1%nat)) in M
    by (field; lra).
  rewrite Nat.add_1_r in *. pose proof (weight_bound _ (Q (2 * m)%nat) U). lra.
Qed.
Lemma none_low rho x : 0 < rho -> ~ unending r a rho x.
Proof.
  intros P H. destruct (unending_now _ _ R1 A1 _ _ H) as [[Q U] _].
  assert (N : regime r a rho (State (q x) (u x / 2))).
  { apply (regime_below r a R1 A1 rho _ x P H); simpl; try lra.
    intros E. rewrite <- E in U at 2. apply (f_equal u) in E. simpl in E. lra. }
  destruct N as [N V]. now apply (not_vanishing_low rho _ P N).
Qed.
End Low.
End Exists.
