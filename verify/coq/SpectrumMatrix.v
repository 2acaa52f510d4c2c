(* The three collisions of a triangle have the printed matrix, in R^d. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Vectors Motion Classification Contacts Settling Spectrum.
Open Scope R_scope.

Lemma three : sqrt 3 * sqrt 3 = 3.
Proof. apply sqrt_sqrt. lra. Qed.
Lemma three_squared : sqrt 3 ^ 2 = 3.
Proof. simpl. rewrite Rmult_1_r. exact three. Qed.
Lemma root_positive : 0 < sqrt 3.
Proof. apply sqrt_lt_R0. lra. Qed.

Section Triangle.
Variable d : nat.
Variable s : scene.
Hypothesis touching : triangle d s.
Let w1 := to s B0 B1.
Let w2 := to s B0 B2.
Lemma unit_w1 : dot d w1 w1 = 1.
Proof. exact (unit_square _ _ _ _ (proj1 touching)). Qed.
Lemma unit_w2 : dot d w2 w2 = 1.
Proof. exact (unit_square _ _ _ _ (proj1 (proj2 touching))). Qed.
Lemma half : dot d w1 w2 = 1 / 2.
Proof.
  pose proof (cosines d s B0 B1 B2) as C. pose proof (unit_square _ _ _ _ (proj2 (proj2 touching))) as U.
  rewrite U in C. unfold square in C. fold w1 w2 in C. rewrite unit_w1, unit_w2 in C. lra.
Qed.
Lemma half' : dot d w2 w1 = 1 / 2.
Proof. rewrite dot_symmetric. exact half. Qed.
Lemma perp_1_is : perp_1 s = combined (- / sqrt 3) w1 (2 / sqrt 3) w2.
Proof. apply same_vector. intros k. unfold perp_1, combined, w1, w2. field. pose proof root_positive. lra. Qed.
Lemma perp_2_is : perp_2 s = combined (- (2 / sqrt 3)) w1 (/ sqrt 3) w2.
Proof. apply same_vector. intros k. unfold perp_2, combined, w1, w2. field. pose proof root_positive. lra. Qed.
Lemma with_w e a b : dot d (combined a w1 b w2) e = a * dot d w1 e + b * dot d w2 e.
Proof. apply dot_linear. Qed.

(* The vectors of the plane of the triangle, and the rest. *)
Lemma in_plane x : exists a b e, dot d e w1 = 0 /\ dot d e w2 = 0 /\ x = combined 1 (combined a w1 b w2) 1 e.
Proof.
  set (p := dot d x w1). set (q := dot d x w2). set (a := 4 / 3 * p - 2 / 3 * q). set (b := 4 / 3 * q - 2 / 3 * p).
  exists a, b, (combined 1 x (-1) (combined a w1 b w2)). split; [|split].
  - rewrite dot_linear, with_w, unit_w1, half'. fold p. unfold a, b. field.
  - rewrite dot_linear, with_w, unit_w2, half. fold q. unfold a, b. field.
  - apply same_vector. intros k. unfold combined. ring.
Qed.
Theorem basis : let omega_1 := to s B0 B1 in let omega_2 := to s B0 B2 in
  dot d omega_1 omega_2 = 1 / 2 /\
  dot d (perp_1 s) (perp_1 s) = 1 /\ dot d (perp_1 s) omega_1 = 0 /\ 0 < dot d (perp_1 s) omega_2 /\
  dot d (perp_2 s) (perp_2 s) = 1 /\ dot d (perp_2 s) omega_2 = 0 /\ dot d (perp_2 s) omega_1 < 0 /\
  exists u e f, coordinates d 1 s u e f.
Proof.
  cbv zeta. fold w1 w2. pose proof root_positive as P. pose proof three as T.
  assert (I : 0 < / sqrt 3) by now apply Rinv_0_lt_compat.
  assert (II : / sqrt 3 * / sqrt 3 = / 3) by (rewrite <- Rinv_mult, T; reflexivity).
  rewrite perp_1_is, perp_2_is, !square_of_combined, !with_w, unit_w1, unit_w2, half, half'.
  set (i := / sqrt 3) in *. unfold Rdiv. fold i.
  split; [reflexivity|]. split; [|split; [|split; [|split; [|split; [|split]]]]]; try lra.
  destruct (in_plane (relative s B0 B1)) as (a & b & e & E1 & E2 & E).
  destruct (in_plane (relative s B0 B2)) as (a' & b' & f & F1 & F2 & F).
  exists (Column (a + b / 2) (b * sqrt 3 / 2) (b' + a' / 2) (- (a' * sqrt 3 / 2))), e, f.
  split; [now split|]. split; [now split|]. intros k. rewrite perp_1_is, perp_2_is.
  rewrite E, F. unfold combined. cbn [c_1 c_2 c_3 c_4]. fold w1 w2. split; field; lra.
Qed.

(* What the three collisions do. *)
Variable r : R.
Let once := collided d r B0 B1 s.
Let twice := collided d r B0 B2 once.
Let h := (1 + r) / 2.
Let V1 := relative s B0 B1.
Let V2 := relative s B0 B2.
Let a := dot d w1 V1.
Let p := dot d w2 V2 - h * a / 2.
Let g := dot d w2 V2 - dot d w2 V1 - dot d w1 V2 + a - h * a / 2 - h * p / 2.
Lemma once_is k : relative once B0 B1 k = V1 k - 2 * h * a * w1 k /\ relative once B0 B2 k = V2 k - h * a * w1 k.
Proof.
  split; unfold once.
  - rewrite velocity_ij by discriminate. unfold combined, h, a, V1, w1, rate. field.
  - rewrite velocity_collided by discriminate. unfold combined, h, a, V1, V2, w1, rate. field.
Qed.
Lemma rate_02 : rate d once B0 B2 = p.
Proof.
  unfold rate. replace (relative once B0 B2) with (combined 1 V2 (- (h * a)) w1)
    by (apply same_vector; intros k; rewrite (proj2 (once_is k)); unfold combined; ring).
  change (to once B0 B2) with w2. rewrite dot_linear_right, half'. unfold p. field.
Qed.
Lemma twice_is k : relative twice B0 B1 k = V1 k - 2 * h * a * w1 k - h * p * w2 k /\
  relative twice B0 B2 k = V2 k - h * a * w1 k - 2 * h * p * w2 k.
Proof.
  destruct (once_is k) as (A & B). split; unfold twice.
  - rewrite velocity_collided by discriminate. unfold combined. rewrite A, rate_02. unfold h.
    change (to once B0 B2) with w2. field.
  - rewrite velocity_ij by discriminate. unfold combined. rewrite B, rate_02. unfold h.
    change (to once B0 B2) with w2. field.
Qed.
Lemma rate_12 : rate d twice B1 B2 = g.
Proof.
  unfold rate. replace (relative twice B1 B2) with
    (combined 1 (combined 1 V2 (-1) V1) 1 (combined (h * a) w1 (- (h * p)) w2)).
  - replace (to twice B1 B2) with (combined (-1) w1 1 w2)
      by (apply same_vector; intros k; unfold combined, w1, w2, to; cbn; ring).
    repeat rewrite dot_linear. repeat rewrite dot_linear_right.
    rewrite unit_w1, unit_w2, half, half'. unfold g, a. field.
  - apply same_vector. intros k. rewrite (moves_from_o twice B0 B1 B2). unfold combined.
    destruct (twice_is k) as (A & B). rewrite A, B. ring.
Qed.
Lemma thrice_is k : relative (triple d r s) B0 B1 k = V1 k - 2 * h * a * w1 k - h * p * w2 k + h * g * (w2 k - w1 k) /\
  relative (triple d r s) B0 B2 k = V2 k - h * a * w1 k - 2 * h * p * w2 k - h * g * (w2 k - w1 k).
Proof.
  unfold triple. fold once. fold twice. destruct (twice_is k) as (A & B).
  assert (E : to twice B1 B2 k = w2 k - w1 k) by (unfold w1, w2, to, twice, once, collided; cbn; ring).
  split.
  - rewrite <- A. change (velocity twice B1 k + (1 + r) / 2 * rate d twice B1 B2 * to twice B1 B2 k -
      velocity twice B0 k = relative twice B0 B1 k + h * g * (w2 k - w1 k)).
    rewrite rate_12, E. unfold relative, h. ring.
  - rewrite <- B. change (velocity twice B2 k - (1 + r) / 2 * rate d twice B1 B2 * to twice B1 B2 k -
      velocity twice B0 k = relative twice B0 B2 k - h * g * (w2 k - w1 k)).
    rewrite rate_12, E. unfold relative, h. ring.
Qed.

(* With coordinates of either sign. *)
Lemma dots_of sign u e f : sign * sign = 1 -> coordinates d sign s u e f ->
  a = c_1 u /\ dot d w2 V2 = c_3 u /\ dot d w2 V1 = c_1 u / 2 + sqrt 3 / 2 * c_2 u /\
  dot d w1 V2 = c_3 u / 2 - sign * (sqrt 3 / 2) * c_4 u.
Proof.
  intros S ((E1 & E2) & (F1 & F2) & C). pose proof root_positive as P. pose proof three as T.
  assert (A : V1 = combined 1 (combined (c_1 u) w1 (c_2 u) (perp_1 s)) 1 e).
  { apply same_vector. intros k. destruct (C k) as (A & _). unfold V1, combined. rewrite A. unfold w1. ring. }
  assert (B : V2 = combined 1 (combined (c_3 u) w2 (c_4 u * sign) (perp_2 s)) 1 f).
  { apply same_vector. intros k. destruct (C k) as (_ & B). unfold V2, combined. rewrite B. unfold w2. ring. }
  fold w1 in E1, F1. fold w2 in E2, F2. rewrite dot_symmetric in E1, E2, F1, F2.
  assert (I : 2 / sqrt 3 = 2 * (sqrt 3 / 3)) by (field_simplify_eq [three_squared]; [ring [three_squared] | lra]).
  assert (J : / sqrt 3 = sqrt 3 / 3) by (field_simplify_eq [three_squared]; [ring [three_squared] | lra]).
  unfold a. rewrite A, B, perp_1_is, perp_2_is, I, J.
  repeat rewrite dot_linear_right. rewrite unit_w1, unit_w2, half, half', E1, E2, F1, F2.
  split; [|split; [|split]]; field.
Qed.
End Triangle.

Ltac by_three H := field_simplify_eq [H]; [ring [H] | idtac].
Theorem matrix : matrix_theorem.
Proof.
  intros d r s u e f T C. pose proof C as (O1 & O2 & K).
  destruct (dots_of d s T 1 u e f ltac:(ring) C) as (D1 & D2 & D3 & D4).
  split; [exact O1|]. split; [exact O2|]. intros k. specialize (K k).
  destruct (thrice_is d s T r k) as (A & B). rewrite A, B. clear A B.
  rewrite D1, D2, D3, D4. destruct K as (K1 & K2). rewrite K1, K2.
  change (to (triple d r s)) with (to s). change (perp_1 (triple d r s)) with (perp_1 s).
  change (perp_2 (triple d r s)) with (perp_2 s). unfold perp_1, perp_2, image. cbn [c_1 c_2 c_3 c_4].
  set (W1 := to s B0 B1 k). set (W2 := to s B0 B2 k).
  pose proof three_squared as H. pose proof root_positive as P. set (q := sqrt 3) in *.
  assert (I : forall x, x / q = x * q / 3) by (intros x; field_simplify_eq [H]; [ring [H] | lra]).
  rewrite !I. split; field_simplify_eq [H]; ring [H].
Qed.
Theorem stated : stated_theorem.
Proof.
  intros d r s R T. pose proof root_positive as P. pose proof three as Q3.
  set (s' := Scene (position s) (fun b k => match b with B2 => - perp_2 s k | _ => 0 end)).
  set (none := fun _ : nat => 0).
  assert (T' : triangle d s') by exact T.
  assert (O : outside_plane d s' none).
  { assert (Z : forall v, dot d none v = 0).
    { intros v. replace none with (scaled 0 v) by (apply same_vector; intros k; unfold scaled, none; ring).
      rewrite dot_scaled. ring. }
    split; apply Z. }
  assert (C : coordinates d (-1) s' unit_4 none none).
  { split; [exact O|]. split; [exact O|]. intros k. unfold relative, s', unit_4, none. cbn [velocity c_1 c_2 c_3 c_4].
    change (perp_2 (Scene _ _)) with (perp_2 s). split; ring. }
  exists s', unit_4, none, none. split; [reflexivity|]. split; [exact C|]. intros (_ & _ & K).
  destruct (dots_of d s' T' (-1) unit_4 none none ltac:(ring) C) as (D1 & D2 & D3 & D4).
  cbn [unit_4 c_1 c_2 c_3 c_4] in D1, D2, D3, D4.
  (* The component along omega_1 of the first velocity. *)
  assert (E : dot d (to s B0 B1) (relative (triple d r s') B0 B1) = c_1 (image r unit_4)).
  { replace (relative (triple d r s') B0 B1) with (combined (c_1 (image r unit_4)) (to s B0 B1)
      (c_2 (image r unit_4)) (perp_1 s)).
    - destruct (basis d s T) as (_ & _ & N & _). rewrite dot_linear_right, (unit_w1 d s T), (dot_symmetric d _ (perp_1 s)), N. ring.
    - apply same_vector. intros k. destruct (K k) as (A & _). unfold combined. rewrite A. unfold none.
      change (to (triple d r s')) with (to s). change (perp_1 (triple d r s')) with (perp_1 s). ring. }
  assert (F : dot d (to s B0 B1) (relative (triple d r s') B0 B1) = (1 + r) / 8 * sqrt 3).
  { replace (relative (triple d r s') B0 B1) with (combined 1 (relative s' B0 B1)
      ((1 + r) / 2 * (- (sqrt 3 / 2))) (combined (-1) (to s B0 B1) 1 (to s B0 B2))).
    - rewrite dot_linear_right, dot_linear_right, (unit_w1 d s T), (half d s T).
      change (dot d (to s B0 B1) (relative s' B0 B1)) with (dot d (to s' B0 B1) (relative s' B0 B1)). rewrite D1. field.
    - apply same_vector. intros k. destruct (thrice_is d s' T' r k) as (A & _). rewrite A. rewrite D1, D2, D3, D4.
      unfold combined. change (to s') with (to s). field. }
  rewrite F in E. unfold image in E. cbn [unit_4 c_1 c_2 c_3 c_4] in E.
  assert (0 < (1 + r) * sqrt 3) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Theorem basis_holds : basis_theorem.
Proof. intros d s T. exact (basis d s T). Qed.
