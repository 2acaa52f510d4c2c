(* When collisions can go on for ever: if and only if a > s + s^2, where s is the cube root of r.
   Then they do so from small u for every q below phi_plus, and for no q from phi_plus on. *)
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
  assert (0 < s ^ 3) by lra. replace (s ^ 2 / 2 * (s + s ^ 2)) with (s ^ 3 * ((1 + s) / 2))
    by field.
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
    apply Rmult_le_compat_l with (r := ratio rho (S (2 * n + 1))) in G1;
      [|left; now apply ratio_positive].
    rewrite <- Rmult_assoc, ratio_turn in G1; lra. }
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
  assert (N : fades r a rho (State (q x) (u x / 2))).
  { apply (fades_below r a R1 A1 rho _ x P H); simpl; try lra.
    intros E. rewrite <- E in U at 2. apply (f_equal u) in E. simpl in E. lra. }
  destruct N as [N V]. now apply (not_vanishing_low rho _ P N).
Qed.
End Low.

(* --- if a > s + s^2, the states below (s^2, e) go on for ever --------------------------------- *)

Section High.
Hypothesis HIGH : s + s ^ 2 < a.

(* The image of (s^2, e) lies below (s^2, rho e). *)
Definition shrinks (rho e : R) :=
  region (State (s ^ 2) e) /\ goes_on a rho (State (s ^ 2) e) /\
  below (next r a rho (State (s ^ 2) e)) (State (s ^ 2) (rho * e)).
Lemma shrinks_if_small rho : 0 < rho -> exists d, 0 < d /\ forall e, 0 < e <= d -> shrinks rho e.
Proof.
  intros P. set (m := (a - s ^ 2 + s) / 2). assert (M : s < m) by (unfold m; lra).
  assert (S2 : 0 < s ^ 2) by nra.
  destruct (small 1 (-1) 0) as [e1 [E1 F1]]; [lra|].
  destruct (small (a - s ^ 2 - m) (- (a + rho)) 0) as [e2 [E2 F2]]; [unfold m; lra|].
  destruct (small (s ^ 2 * (a - s ^ 2) - r) (r - s ^ 2 * (a + rho)) 0) as [e3 [E3 F3]];
    [rewrite <- SR; nra|].
  destruct (small (m ^ 2 - s ^ 2) (- rho * (m ^ 2 + 1) / 2) 0) as [e4 [E4 F4]]; [nra|].
  destruct (small 1 (- rho) 0) as [e5 [E5 F5]]; [lra|].
  exists (Rmin (Rmin (Rmin e1 e2) (Rmin e3 e4)) e5). split; [repeat apply Rmin_glb_lt; lra|].
  intros e [E0 E].
  assert (L : e <= Rmin (Rmin e1 e2) (Rmin e3 e4)) by (eapply Rle_trans; [exact E|apply Rmin_l]).
  assert (L5 : e <= e5) by (eapply Rle_trans; [exact E|apply Rmin_r]).
  pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2). pose proof (Rmin_l e3 e4).
  pose proof (Rmin_r e3 e4). pose proof (Rmin_l (Rmin e1 e2) (Rmin e3 e4)).
  pose proof (Rmin_r (Rmin e1 e2) (Rmin e3 e4)).
  specialize (F1 e ltac:(lra)). specialize (F2 e ltac:(lra)). specialize (F3 e ltac:(lra)).
  specialize (F4 e ltac:(lra)). specialize (F5 e ltac:(lra)).
  set (x := State (s ^ 2) e). assert (X : region x) by (unfold region, x; simpl; nra).
  assert (PE : p a rho x = a - s ^ 2 - (a + rho) * e) by (unfold p, x; simpl; ring).
  assert (PM : m < p a rho x) by lra.
  assert (PS : m ^ 2 < p a rho x ^ 2) by nra.
  assert (RE : 0 < rho * e) by now apply Rmult_lt_0_compat.
  assert (W : width rho x < h (rho * e) * p a rho x ^ 2).
  { replace (width rho x) with (rho * e * (2 * s ^ 2 + rho * e)) by reflexivity. unfold h.
    rewrite (Rmult_assoc (rho * e) (2 - rho * e)). apply Rmult_lt_compat_l; [exact RE|].
    apply Rlt_trans with ((2 - rho * e) * m ^ 2); [lra|]. apply Rmult_lt_compat_l; lra. }
  assert (G : goes_on a rho x).
  { split; [lra|]. fold (width rho x). apply Rlt_le_trans with (1 := W).
    pose proof (h_range (rho * e) ltac:(lra)).
    assert (0 < p a rho x ^ 2) by (apply pow_lt; lra). nra. }
  split; [exact X|]. split; [exact G|]. split;
    [change (q (next r a rho x) <= s ^ 2)|change (u (next r a rho x) <= rho * e)].
  - apply next_q_le; auto. rewrite PE. simpl u. lra.
  - apply next_u_le; auto; lra.
Qed.
Lemma sink rho : 0 < rho -> exists e, 0 < e /\ unending r a rho (State (s ^ 2) e).
Proof.
  intros P. destruct (shrinks_if_small rho P) as [d [D H]].
  destruct (shrinks_if_small (/ rho) (inverse_positive rho P)) as [c [C J]].
  set (e := Rmin d (c / rho)).
  assert (E : 0 < e) by (apply Rmin_glb_lt; [lra|now apply Rdiv_lt_0_compat]).
  assert (ED : e <= d) by apply Rmin_l.
  assert (EC : rho * e <= c).
  { apply Rle_trans with (rho * (c / rho)); [apply Rmult_le_compat_l; [lra|apply Rmin_r]|].
    right. field. lra. }
  exists e. split; [exact E|].
  apply (unending_if r a R1 A1 (fun rho x => region x /\ exists e, below x (State (s ^ 2) e) /\
    shrinks rho e /\ shrinks (/ rho) (rho * e))); [|exact P|].
  - clear rho P d D H c C J e E ED EC. intros rho x P [X [e [B [[Y [G N]] S]]]].
    pose proof (goes_on_below r a R1 A1 rho x _ P X Y B G) as GX.
    split; [exact X|]. split; [exact GX|]. split; [now apply next_region|].
    exists (rho * e). split.
    + destruct (next_below r a R1 A1 rho x _ P X Y B G). destruct N. split; lra.
    + rewrite Rinv_inv. split; [exact S|].
      replace (/ rho * (rho * e)) with e by (field; lra). repeat split; try apply Y; try apply G;
        apply N.
  - split; [apply (H e ltac:(lra))|]. exists e. split; [unfold below; lra|].
    split; [apply H; lra|]. apply J. split; [now apply Rmult_lt_0_compat|exact EC].
Qed.

(* --- phi_plus --------------------------------------------------------------------------------- *)

Lemma phi_plus_root : phi_plus r a ^ 2 = a * phi_plus r a - r /\ a - s ^ 2 < phi_plus r a < a.
Proof.
  unfold phi_plus. set (d := a ^ 2 - 4 * r).
  assert (S2 : 0 < s ^ 2) by nra.
  assert (L : 0 < s ^ 2 * (a - s ^ 2 - s)) by nra.
  assert (D : (a - 2 * s ^ 2) ^ 2 < d) by (unfold d; rewrite <- SR; nra).
  assert (D0 : 0 <= d) by (pose proof (pow2_ge_0 (a - 2 * s ^ 2)); lra).
  pose proof (sqrt_sqrt d D0) as Q. pose proof (sqrt_pos d) as Q0. split; [unfold d in *; lra|].
  split.
  - apply Rnot_le_lt. intros N. assert (sqrt d <= a - 2 * s ^ 2) by lra.
    assert (sqrt d * sqrt d <= (a - 2 * s ^ 2) * (a - 2 * s ^ 2))
      by (apply Rmult_le_compat; lra). lra.
  - apply Rnot_le_lt. intros N. assert (a <= sqrt d) by lra.
    assert (a * a <= sqrt d * sqrt d) by (apply Rmult_le_compat; lra). unfold d in *. lra.
Qed.
Lemma beyond_phi_plus rho x : 0 < rho -> phi_plus r a <= q x -> ~ unending r a rho x.
Proof.
  intros P L H. destruct phi_plus_root as [E [B1 B2]]. pose proof s_less as S2.
  set (t := phi_plus r a) in *. set (y := fun n => q (orbit r a rho x n)).
  assert (T : forall v, t <= v -> v * (a - v) <= r).
  { intros v V. assert (0 <= (v - t) * (v + t - a)) by (apply Rmult_le_pos; nra). nra. }
  assert (Y : forall n, r < y (S n) * (a - y n) /\ 0 <= y n < a).
  { intros n. destruct (unending_now _ _ R1 A1 _ _ (unending_orbit r a R1 A1 rho x n P H)) as [X G].
    pose proof (ratio_positive rho n P) as Pn. split.
    - apply (next_q_lower r a R1 A1 (ratio rho n) _ Pn X G).
    - split; [apply X|]. apply (q_less r a R1 A1 (ratio rho n) _ Pn X G). }
  assert (UP : forall n, t <= y n -> y n < y (S n)).
  { intros n V. destruct (Y n) as [Y1 Y2]. specialize (T _ V).
    apply Rmult_lt_reg_r with (a - y n); lra. }
  assert (ABOVE : forall n, t <= y n).
  { induction n; [exact L|]. specialize (UP n IHn). lra. }
  destruct (growing_cv y) as [l C].
  - intros n. left. apply UP, ABOVE.
  - exists a. intros v [n ->]. left. apply (Y n).
  - assert (LT : t < l).
    { apply Rlt_le_trans with (y 1%nat); [apply Rle_lt_trans with (y 0%nat); auto|].
      apply growing_ineq; [|exact C]. intros n. left. apply UP, ABOVE. }
    assert (LA : r <= l * (a - l)).
    { apply cv_le with (fun _ => r) (fun n => y (S n) * (a - y n)); [apply cv_const| |].
      - apply CV_mult; [now apply cv_shift|]. apply CV_minus; [apply cv_const|exact C].
      - intros n. left. apply Y. }
    assert (0 < (l - t) * (l + t - a)) by (apply Rmult_lt_0_compat; nra). nra.
Qed.

(* --- below phi_plus --------------------------------------------------------------------------- *)

Definition reached (y : R) := forall rho, 0 < rho -> exists e, 0 < e /\
  unending r a rho (State y e).
Lemma reached_below y z : 0 <= y <= z -> reached z -> reached y.
Proof.
  intros L H rho P. destruct (H rho P) as [e [E U]]. exists e. split; [exact E|].
  apply unending_below with (State z e); auto; unfold region, below; simpl; [|lra].
  destruct U as [[_ U] _]. simpl in U. lra.
Qed.
(* If q moves from y to less than z for small u, and z is reached, then y is. *)
Lemma reached_step y z : 0 <= y < a -> r < z * (a - y) -> reached z -> reached y.
Proof.
  intros Y L H rho P. destruct (H _ (inverse_positive rho P)) as [v [V U]].
  destruct (unending_now _ _ R1 A1 _ _ U) as [[Z V1] _]. simpl in Z, V1.
  pose proof (h_range v V1) as HV.
  destruct (small 1 (-1) 0) as [e1 [E1 F1]]; [lra|].
  destruct (small (a - y) (- (a + rho)) 0) as [e2 [E2 F2]]; [lra|].
  destruct (small (z * (a - y) - r) (r - z * (a + rho)) 0) as [e3 [E3 F3]]; [lra|].
  destruct (small (h v * (a - y) ^ 2) (- 2 * h v * (a - y) * (a + rho) - rho * 2 * y)
    (h v * (a + rho) ^ 2 - rho ^ 2)) as [e4 [E4 F4]].
  { apply Rmult_lt_0_compat; [lra|]. apply pow_lt. lra. }
  set (e := Rmin (Rmin e1 e2) (Rmin e3 e4)).
  assert (E : 0 < e /\ e <= e1 /\ e <= e2 /\ e <= e3 /\ e <= e4).
  { unfold e. pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2). pose proof (Rmin_l e3 e4).
    pose proof (Rmin_r e3 e4). pose proof (Rmin_l (Rmin e1 e2) (Rmin e3 e4)).
    pose proof (Rmin_r (Rmin e1 e2) (Rmin e3 e4)). split; [|lra]. repeat apply Rmin_glb_lt; lra. }
  destruct E as [E0 [L1 [L2 [L3 L4]]]]. exists e. split; [exact E0|].
  specialize (F1 e ltac:(lra)). specialize (F2 e ltac:(lra)). specialize (F3 e ltac:(lra)).
  specialize (F4 e ltac:(lra)). set (x := State y e).
  assert (X : region x) by (unfold region, x; simpl; lra).
  assert (PE : p a rho x = a - y - (a + rho) * e) by (unfold p, x; simpl; ring).
  assert (W : width rho x <= h v * p a rho x ^ 2) by (rewrite PE; unfold width, x; simpl in *; nra).
  assert (G : goes_on a rho x).
  { split; [lra|]. fold (width rho x). assert (0 < p a rho x ^ 2) by (apply pow_lt; lra). nra. }
  apply unending_from_next; auto.
  apply unending_below with (State z v); auto using inverse_positive.
  - now apply next_region.
  - split; [change (q (next r a rho x) <= z)|change (u (next r a rho x) <= v)].
    + apply next_q_le; auto. rewrite PE. simpl. lra.
    + apply next_u_le; auto. lra.
Qed.
Lemma reached_up_to y : 0 <= y < phi_plus r a -> reached y.
Proof.
  intros [Y0 Y1]. destruct (Rle_lt_dec y (s ^ 2)) as [L|L].
  { apply reached_below with (s ^ 2); [lra|]. exact sink. }
  destruct phi_plus_root as [E [B1 B2]]. set (t := phi_plus r a) in *.
  set (g := fun v => v * (a - v) - r).
  assert (S2 : 0 < s ^ 2) by nra.
  assert (G0 : 0 < g (s ^ 2)) by (unfold g; rewrite <- SR; nra).
  assert (G1 : 0 < g y).
  { unfold g. assert (0 < (t - y) * (y + t - a)) by (apply Rmult_lt_0_compat; lra). nra. }
  set (d := Rmin (g (s ^ 2)) (g y)). assert (D : 0 < d) by (apply Rmin_glb_lt; auto).
  assert (G : forall v, s ^ 2 <= v <= y -> d <= g v).
  { intros v V. destruct (Rle_lt_dec (v + s ^ 2) a) as [M|M].
    - apply Rle_trans with (1 := Rmin_l _ _). unfold g. nra.
    - apply Rle_trans with (1 := Rmin_r _ _). unfold g. nra. }
  set (c := d / (2 * a)). assert (C : 0 < c) by (apply Rdiv_lt_0_compat; lra).
  assert (CA : c * a < d) by (unfold c; replace (d / (2 * a) * a) with (d / 2) by (field; lra);
    lra).
  assert (ALL : forall n v, 0 <= v <= y -> v <= s ^ 2 + INR n * c -> reached v).
  { induction n; intros v V M.
    - apply reached_below with (s ^ 2); [simpl in M; lra|]. exact sink.
    - destruct (Rle_lt_dec v (s ^ 2)) as [N|N].
      + apply reached_below with (s ^ 2); [lra|]. exact sink.
      + specialize (G v ltac:(lra)). unfold g in G. rewrite S_INR in M.
        apply reached_step with (v - c); [nra|nra|]. apply IHn; [|lra]. nra. }
  assert (BIG : exists n, INR n > (y - s ^ 2) / c).
  { set (b := (y - s ^ 2) / c). assert (0 < b) by (apply Rdiv_lt_0_compat; lra).
    destruct (archimed b) as [N _]. exists (Z.to_nat (up b)).
    rewrite INR_IZR_INZ, Z2Nat.id; [exact N|]. apply le_IZR. lra. }
  destruct BIG as [n N]. apply (ALL n y); [lra|].
  apply Rmult_gt_compat_r with (r := c) in N; [|exact C].
  replace ((y - s ^ 2) / c * c) with (y - s ^ 2) in N by (field; lra). lra.
Qed.
End High.

Theorem unending_iff rho : 0 < rho -> (exists x, unending r a rho x) <-> s + s ^ 2 < a.
Proof.
  intros P. split.
  - intros [x H]. apply Rnot_le_lt. intros N. exact (none_low N rho x P H).
  - intros H. destruct (sink H rho P) as [e [_ U]]. eauto.
Qed.
End Exists.
