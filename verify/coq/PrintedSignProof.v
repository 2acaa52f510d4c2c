(* Theorem 1 as printed, with < in (4.10), is false. *)
From Coq Require Import Reals Arith Lra Lia Classical.
From Verify Require Import Theorem1 Vectors Motion Sequences Ending Parameters Classification Contacts.
From Verify Require Import NoTriangle Settling Endless ClassificationProof PrintedSign.
Open Scope R_scope.

Lemma collapse_is_nearly_linear d r s by_time c tolerance : 0 < r < 1 ->
  collapse d r s by_time c tolerance -> nearly_linear d r s c tolerance.
Proof.
  intros R (scenes & time & T & Z & at_T & P & _ & A). destruct P as [P1 P2 P3 P4 P5 P6 P7 P8 P9 P10 P11].
  exists scenes, time, (fun _ => B0), collides_with, T, at_T, B1, B2, 0%nat.
  assert (N : forall n, B0 <> collides_with n).
  { intros n. unfold collides_with. destruct Nat.even; discriminate. }
  split; [|split; [exact P4|split; [repeat split; discriminate|split; [|split; [|exact A]]]]].
  - split; [exact P1|]. split; [exact P2|]. intros n. destruct (P3 n) as [[M1 M2 M3 M4 M5] E].
    split; [apply N|]. split; [lra|]. split; [exact M3|]. split; [exact M4|]. split; [|exact E].
    intros a b D. exact (all_apart d _ B0 (collides_with n) a b (N n) D M3 M5).
  - intros n. left. now split.
  - assert (C : forall b k, (k < d)%nat -> Un_cv (fun n => position (scenes n) b k) (position at_T b k)).
    { intros b k K e E. destruct (P8 b k K e E) as (m & M & Q). destruct (P4 (T - m)) as (n0 & L); [lra|].
      exists n0. intros n G. specialize (L n G). unfold R_dist in *. apply Rabs_def2 in L.
      assert (B : forall p, time p < T).
      { intros p. destruct (P3 p) as [[W _ _ _ _] _]. pose proof (growing_ineq time T) as I.
        specialize (I ltac:(intros q; destruct (P3 q) as [[V _ _ _ _] _]; lra) P4 (S p)). lra. }
      specialize (Q (time n) ltac:(specialize (B n); lra)). rewrite (P5 n) in Q.
      - rewrite (Rminus_diag_eq (time n) (time n) eq_refl), later_0 in Q. exact Q.
      - destruct (P3 n) as [[V _ _ _ _] _]. lra. }
    intros a b k K. unfold to. apply CV_minus; now apply C.
Qed.

Theorem least_final_angle d r s c tolerance : 0 < r < 1 -> nearly_linear d r s c tolerance ->
  4 * sqrt r / (1 + r) <= c + tolerance /\
  (2 * cube_root r * (1 + cube_root r) / (1 + r) <= c + tolerance \/
    spin2 d s = 0 /\ forall k l, (k < d)%nat -> (l < d)%nat -> spin s k l = 0).
Proof.
  intros R0 (scenes & time & i & j & T & at_T & a & b & N & E & _ & D & W & S & A).
  assert (R : 0 < r <= 1) by lra.
  destruct (ends_there d r s scenes time i j R E at_T B0 a b N S D W) as (_ & _ & L & L2).
  assert (M : minus_cosine_at d at_T B0 a b = minus_cosine d at_T).
  { destruct D as (D1 & D2 & D3). unfold minus_cosine_at, minus_cosine.
    destruct a, b; try easy. now rewrite dot_symmetric, Rmult_comm. }
  rewrite M in L, L2. apply within in A. split; [lra|]. destruct L2 as [L2|Z]; [left; lra | right].
  split; [now apply (no_spin_at_rest d r s scenes time i j R E)|].
  intros k l. now apply (spin_at_rest d r s scenes time i j R E).
Qed.
(* Near each scene one has angular momentum. *)
Lemma some_spin d set : (2 <= d)%nat -> has_interior d set -> exists s, set s /\ spin s 0 1 <> 0.
Proof.
  intros L (s & e & E & I). apply NNPP. intros N.
  set (near h g := {| position := fun b k => position s b k + if same b B1 then (if k then h else 0) else 0;
    velocity := fun b k => velocity s b k + if same b B1 then (if k then 0 else g) else 0 |}).
  assert (Z : forall h g, 0 <= h < e -> 0 <= g < e -> spin (near h g) 0 1 = 0).
  { intros h g H G. apply NNPP. intros Q. apply N. exists (near h g). split; [apply I | exact Q].
    intros b k _. unfold near. cbn. split; apply Rabs_def1; destruct same, k; lra. }
  pose proof (Z 0 0 ltac:(lra) ltac:(lra)) as Z1. pose proof (Z 0 (e / 2) ltac:(lra) ltac:(lra)) as Z2.
  pose proof (Z (e / 2) 0 ltac:(lra) ltac:(lra)) as Z3. pose proof (Z (e / 2) (e / 2) ltac:(lra) ltac:(lra)) as Z4.
  pose proof (Rmult_lt_0_compat (e / 2) (e / 2) ltac:(lra) ltac:(lra)).
  unfold spin, moment, to, relative, near in *. cbn in *. lra.
Qed.

Lemma cube_root_above x y : 0 < x -> x ^ 3 < y -> x < cube_root y.
Proof.
  intros X Y. assert (Y0 : 0 < y) by (pose proof (pow_lt x 3 X); lra).
  pose proof (cube_root_positive y) as P. pose proof (cube_of_root y Y0) as C.
  apply Rnot_le_lt. intros L. assert (cube_root y ^ 3 <= x ^ 3) by (apply pow_incr; lra). lra.
Qed.
(* r = 3/100, theta_0 = 2 pi/3, delta_theta = 1/10. *)
Lemma witness : hypotheses_as_printed (3 / 100) (2 * (PI / 3)) (1 / 10) /\
  - cos (2 * (PI / 3)) + 1 / 10 < 4 * sqrt (3 / 100) / (1 + 3 / 100).
Proof.
  assert (CO : - cos (2 * (PI / 3)) = 1 / 2) by (rewrite cos_2PI3; lra).
  pose proof PI_RGT_0 as PI0.
  assert (S5 : sqrt 5 < 224 / 100).
  { rewrite <- (sqrt_square (224 / 100)) by lra. apply sqrt_lt_1; lra. }
  assert (S3 : 16 / 100 < sqrt (3 / 100)).
  { rewrite <- (sqrt_square (16 / 100)) by lra. apply sqrt_lt_1; lra. }
  assert (CR : 22 / 100 < cube_root (3 / 100)) by (apply cube_root_above; lra).
  rewrite CO. split.
  - unfold hypotheses_as_printed. rewrite CO. repeat split; try lra.
    apply Rmult_lt_reg_r with (1 + 3 / 100); [lra|]. set (x := cube_root (3 / 100)) in *.
    replace (2 * x * (1 + x) / (1 + 3 / 100) * (1 + 3 / 100)) with (2 * (x + x * x)) by field.
    assert (22 / 100 * (22 / 100) < x * x) by (apply Rmult_le_0_lt_compat; lra). lra.
  - apply Rmult_lt_reg_r with (1 + 3 / 100); [lra|].
    replace (4 * sqrt (3 / 100) / (1 + 3 / 100) * (1 + 3 / 100)) with (4 * sqrt (3 / 100)) by field. lra.
Qed.
Lemma none_there d r s c delta_theta : 0 < r < 1 -> c + delta_theta < 4 * sqrt r / (1 + r) ->
  ~ nearly_linear d r s c delta_theta.
Proof. intros R L K. pose proof (least_final_angle d r s c delta_theta R K). lra. Qed.
Lemma none_with_spin d r s c delta_theta : 0 < r < 1 -> 0 < spin2 d s ->
  c + delta_theta < 2 * cube_root r * (1 + cube_root r) / (1 + r) -> ~ nearly_linear d r s c delta_theta.
Proof. intros R S L K. pose proof (least_final_angle d r s c delta_theta R K). lra. Qed.
Theorem false_at d r theta_0 delta_theta : (2 <= d)%nat -> 0 < r < 1 ->
  - cos theta_0 + delta_theta < 2 * cube_root r * (1 + cube_root r) / (1 + r) ->
  ~ as_printed_at d r theta_0 delta_theta.
Proof.
  intros D R L (set & I & A). destruct (some_spin d set D I) as (s & S & M).
  destruct (least_final_angle d r s _ _ R (A s S)) as (_ & [K|(_ & K)]); [lra|]. apply M, K; lia.
Qed.
Theorem false_as_printed : ~ as_printed.
Proof.
  intros P. destruct witness as (H & L).
  destruct (P _ _ _ 2%nat (le_n 2) H) as (set & (s & e & E & I) & A).
  apply (none_there 2 (3 / 100) s _ _ ltac:(lra) L). apply A, I. intros k l _.
  rewrite !Rminus_diag_eq, Rabs_R0 by reflexivity. split; exact E.
Qed.
Theorem printed_sign_theorem_holds : printed_sign_theorem.
Proof.
  split; [exact false_as_printed|]. split; [exact false_at|]. split; [exact none_with_spin|]. split; [|split].
  - exists (3 / 100), (2 * (PI / 3)), (1 / 10). exact witness.
  - exact none_there.
  - exact collapse_is_nearly_linear.
Qed.
