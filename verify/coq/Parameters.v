(* The hypothesis as the paper prints it, with cube roots, is the one of Theorem1.v; and under it the
   constants are defined, positive, and solve the equations that the paper defines them by. *)
From Coq Require Import Reals List Lra Psatz.
From Verify Require Import Theorem1 OneScene.
Open Scope R_scope.

(* --- cube roots ------------------------------------------------------------------------------- *)

Lemma cube_root_positive r : 0 < cube_root r.
Proof. apply exp_pos. Qed.
Lemma cube_of_root r : 0 < r -> cube_root r ^ 3 = r.
Proof.
  intros P. unfold cube_root. rewrite <- Rpower_pow by apply exp_pos. rewrite Rpower_mult.
  replace (1 / 3 * INR 3) with 1 by (cbn; field). now apply Rpower_1.
Qed.
(* One is where the polynomial of the other is positive. *)
Lemma threshold s a : 0 < s -> 0 < a ->
  (s + s ^ 2 < a <-> 3 * s ^ 3 * a + s ^ 3 * (1 + s ^ 3) < a ^ 3).
Proof.
  intros S A. set (f := a ^ 2 + a * (s + s ^ 2) + s ^ 2 * (1 - s + s ^ 2)).
  assert (E : a ^ 3 - (3 * s ^ 3 * a + s ^ 3 * (1 + s ^ 3)) = (a - (s + s ^ 2)) * f)
    by (unfold f; ring).
  assert (F : 0 < f).
  { unfold f. assert (0 < 1 - s + s ^ 2) by (pose proof (pow2_ge_0 (s - 1 / 2)); lra).
    repeat apply Rplus_lt_0_compat; repeat apply Rmult_lt_0_compat; try apply pow_lt; try lra.
    apply Rplus_lt_0_compat; trivial. now apply pow_lt. }
  split; intros H.
  - pose proof (Rmult_lt_0_compat (a - (s + s ^ 2)) f). lra.
  - apply Rnot_le_lt. intros N. pose proof (Rmult_le_compat_r f (a - (s + s ^ 2)) 0). lra.
Qed.
Lemma below_stable s : 0 < s < 1 -> 2 * (s + s ^ 2) < 1 + s ^ 3 -> s ^ 3 < 9 - 4 * sqrt 5.
Proof.
  intros S H. pose proof (sqrt_pos 5) as P. set (q := sqrt 5) in *.
  assert (Q : q * q = 5) by (apply sqrt_sqrt; lra). assert (2 < q < 3) by nra.
  assert (L : 0 < 1 - 3 * s + s ^ 2) by nra.
  assert (B : s < (3 - q) / 2) by nra.
  replace (9 - 4 * q) with (((3 - q) / 2) ^ 3) by nra.
  assert (s ^ 2 < ((3 - q) / 2) ^ 2) by nra. nra.
Qed.
Lemma stable_below_1 : 9 - 4 * sqrt 5 < 1.
Proof. assert (2 < sqrt 5); [|lra]. pose proof (sqrt_sqrt 5). pose proof (sqrt_pos 5). nra. Qed.
Lemma root_below_1 r : 0 < r < 1 -> 0 < cube_root r < 1.
Proof.
  intros R. pose proof (cube_root_positive r). pose proof (cube_of_root r). split; [lra|].
  apply Rnot_le_lt. intros N. pose proof (pow_R1_Rle (cube_root r) 3 N). lra.
Qed.

Theorem hypothesis_is_the_printed : same_hypothesis.
Proof.
  intros r c V_0 delta_theta. unfold printed_hypothesis.
  pose proof (cube_of_root r) as CUBE. pose proof (cube_root_positive r) as S.
  pose proof (root_below_1 r) as S1. set (s := cube_root r) in *.
  assert (D : forall x, 0 < r -> (2 * s * (1 + s) / (1 + r) < x <-> s + s ^ 2 < (1 + r) / 2 * x)).
  { intros x R0. replace (2 * s * (1 + s) / (1 + r)) with ((s + s ^ 2) / ((1 + r) / 2)) by (field; lra).
    set (k := (1 + r) / 2). assert (K : 0 < k) by (unfold k; lra).
    assert (E : (s + s ^ 2) / k * k = s + s ^ 2) by (field; lra).
    split; intros H.
    - apply (Rmult_lt_compat_r k) in H; lra.
    - apply (Rmult_lt_reg_r k); lra. }
  assert (T : 0 < r -> 0 < c -> (s + s ^ 2 < (1 + r) / 2 * c <->
    3 * r * ((1 + r) / 2 * c) + r * (1 + r) < ((1 + r) / 2 * c) ^ 3)).
  { intros R C. pose proof (threshold s ((1 + r) / 2 * c) S) as A.
    rewrite (CUBE R) in A.
    apply A. apply Rmult_lt_0_compat; lra. }
  split.
  - intros [[R R1] [C C1] H V P]. repeat split; trivial; [|now apply D, T].
    rewrite <- (CUBE R) at 1. apply below_stable; [now apply S1|].
    rewrite (CUBE R). apply T in H; trivial.
    assert ((1 + r) / 2 * c <= (1 + r) / 2 * 1) by (apply Rmult_le_compat_l; lra). lra.
  - intros (([R R1] & H) & C1 & V & P). pose proof stable_below_1.
    assert (C : 0 < c).
    { apply Rlt_trans with (2 := H). unfold Rdiv. repeat apply Rmult_lt_0_compat; try lra. apply Rinv_0_lt_compat. lra. }
    split; trivial; [lra | lra |]. now apply T, D.
Qed.

(* --- the constants ---------------------------------------------------------------------------- *)

Section PositiveConstants.
Variables r c V_0 delta_theta : R.
Hypothesis good : admissible r c V_0 delta_theta.

Lemma alpha_between : 0 < alpha_0 r c < 1.
Proof.
  destruct good as [R C _ _ _]. unfold alpha_0. split; [apply Rmult_lt_0_compat; lra|].
  assert ((1 + r) / 2 * c <= (1 + r) / 2 * 1) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma discriminant_positive : 0 < alpha_0 r c ^ 2 - 4 * r.
Proof.
  pose proof alpha_between as [A _]. destruct good as [R C H _ _].
  pose proof (cube_root_positive r) as S. pose proof (cube_of_root r (proj1 R)) as CUBE.
  set (s := cube_root r) in *. pose proof (threshold s (alpha_0 r c) S A) as E. rewrite CUBE in E.
  apply E in H. clear E. rewrite <- CUBE at 2.
  assert (s ^ 2 * (1 + s) ^ 2 < alpha_0 r c ^ 2).
  { replace (s ^ 2 * (1 + s) ^ 2) with ((s + s ^ 2) ^ 2) by ring.
    pose proof (pow_lt s 2 S). assert (0 < s + s ^ 2) by lra. nra. }
  assert (0 <= s ^ 2 * (1 - s) ^ 2) by (apply Rmult_le_pos; apply pow2_ge_0). lra.
Qed.
Notation root := (sqrt (alpha_0 r c ^ 2 - 4 * r)).
Lemma root_positive : 0 < root.
Proof. apply sqrt_lt_R0, discriminant_positive. Qed.
Lemma phi_minus_is : phi_minus r c = (alpha_0 r c - root) / 2.
Proof.
  pose proof root_positive. pose proof alpha_between.
  pose proof (sqrt_sqrt (alpha_0 r c ^ 2 - 4 * r)) as Q. pose proof discriminant_positive.
  unfold phi_minus. apply Rmult_eq_reg_r with (alpha_0 r c + root); [|lra].
  field_simplify; [|lra]. specialize (Q ltac:(lra)). lra.
Qed.
Lemma half_of_square x y : 0 < x -> 0 < y -> 0 < 1 - (1 - x / y ^ 2) / 2.
Proof.
  intros X Y. assert (0 < x / y ^ 2) by (apply Rdiv_lt_0_compat; trivial; now apply pow_lt). lra.
Qed.
(* How the paper defines delta_4 and delta_5. *)
Lemma solves a x h : 0 < x -> 0 < 1 - h -> x / (a - (a - sqrt (x / (1 - h)))) ^ 2 = 1 - h.
Proof.
  intros X P. replace (a - (a - sqrt (x / (1 - h)))) with (sqrt (x / (1 - h))) by ring.
  rewrite pow2_sqrt by (left; now apply Rdiv_lt_0_compat). field. lra.
Qed.
Theorem defined : 
  0 < alpha_0 r c /\ 0 < alpha_0 r c ^ 2 - 4 * r /\ 0 < alpha_0 r c - phi_minus r c /\
  0 < 1 - h_4 r c /\ 0 < 1 - h_5 r c /\ 0 < 1 - C_eta r c /\ 0 < V_1 r c V_0 /\
  phi_minus r c = (alpha_0 r c - sqrt (alpha_0 r c ^ 2 - 4 * r)) / 2 /\
  r / (alpha_0 r c - (phi_minus r c + delta_4 r c)) ^ 2 = 1 - h_4 r c /\
  phi_minus r c / (alpha_0 r c - (phi_minus r c + delta_5 r c)) ^ 2 = 1 - h_5 r c /\
  0 < phi_minus r c /\ 0 < delta_x r c V_0 /\ 0 < x_0 r c V_0 /\ V_0 < V_1 r c V_0 /\
  0 < Delta_theta r c V_0 delta_theta <= delta_theta /\ 0 < eta_bar r c V_0 delta_theta /\
  0 < zeta_bar r c V_0 /\ 0 < d_const r c V_0 delta_theta /\ 0 < d_slope r c V_0.
Proof.
  pose proof alpha_between as [A A1]. pose proof root_positive as P. pose proof phi_minus_is as F.
  pose proof (phi_positive r c V_0 delta_theta good) as F0.
  pose proof (x_0_positive r c V_0 delta_theta good) as X.
  pose proof (theta_positive r c V_0 delta_theta good) as Q.
  pose proof (slope_positive r c V_0 delta_theta good) as S.
  pose proof (speeds r c V_0 delta_theta good) as V.
  destruct good as [R C _ V0 _].
  assert (G : 0 < alpha_0 r c - phi_minus r c) by lra.
  assert (H4 : 0 < 1 - h_4 r c) by (apply half_of_square; lra).
  assert (H5 : 0 < 1 - h_5 r c) by (apply half_of_square; lra).
  assert (X' : x_0 r c V_0 <= (1 - h_4 r c) * delta_x r c V_0) by apply Rmin_r.
  split; trivial. split; [exact discriminant_positive|]. do 3 (split; trivial).
  split; [unfold C_eta, delta_3; lra|]. split; [lra|]. split; trivial.
  split.
  { unfold delta_4. replace (phi_minus r c + (alpha_0 r c - phi_minus r c - sqrt (r / (1 - h_4 r c))))
      with (alpha_0 r c - sqrt (r / (1 - h_4 r c))) by ring. apply solves; trivial. lra. }
  split.
  { unfold delta_5.
    replace (phi_minus r c + (alpha_0 r c - phi_minus r c - sqrt (phi_minus r c / (1 - h_5 r c))))
      with (alpha_0 r c - sqrt (phi_minus r c / (1 - h_5 r c))) by ring. now apply solves. }
  split; trivial. split.
  { apply Rmult_lt_reg_l with (1 - h_4 r c); trivial. lra. }
  do 2 (split; trivial). split.
  { split; trivial. unfold Delta_theta, least. cbn [fold_right].
    apply Rle_trans with (1 := Rmin_r _ _). apply Rmin_l. }
  split; [now apply eta_positive|]. split; [|split; [now apply const_positive | trivial]].
  unfold d_slope in S. apply Rmult_lt_reg_r with (/ (2 * V_1 r c V_0)).
  - apply Rinv_0_lt_compat. lra.
  - rewrite Rmult_0_l. exact S.
Qed.
End PositiveConstants.
Theorem constants_are_defined : constants_defined.
Proof. exact defined. Qed.
