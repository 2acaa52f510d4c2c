(* The states whose next state lies in a convex set form a convex set, if the given set contains
   what lies above each of its points. In the coordinates S = 1 - u, P = p, Q = q, which are affine
   in the state, the step is projective. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
Open Scope R_scope.
Set Default Proof Using "All".

(* The inequality behind it, a Cauchy-Schwarz inequality reversed. *)
Lemma reversed (a v w k l t s : R) : 0 < a -> 0 < v <= w -> w <= a -> 0 <= t <= s -> s <= w ->
  s * v <= t * w -> 0 <= k -> 0 <= l ->
  k ^ 2 <= t ^ 2 - 2 * a * v + a ^ 2 -> l ^ 2 <= s ^ 2 - 2 * a * w + a ^ 2 ->
  k * l <= t * s - a * (v + w) + a ^ 2.
Proof.
  intros A V W T S H K0 L0 K L.
  set (A0 := t ^ 2 - 2 * a * v + a ^ 2) in *. set (B0 := s ^ 2 - 2 * a * w + a ^ 2) in *.
  assert (PA : 0 <= A0) by (apply Rle_trans with (2 := K); apply pow2_ge_0).
  assert (PB : 0 <= B0) by (apply Rle_trans with (2 := L); apply pow2_ge_0).
  pose proof (sqrt_sqrt A0 PA) as EA. pose proof (sqrt_sqrt B0 PB) as EB.
  pose proof (sqrt_pos A0) as X0. pose proof (sqrt_pos B0) as Y0.
  set (x := sqrt A0) in *. set (y := sqrt B0) in *.
  assert (KX : k <= x) by (apply Rnot_lt_le; intros N; nra).
  assert (LY : l <= y) by (apply Rnot_lt_le; intros N; nra).
  assert (I1 : s * y <= a * w - s ^ 2).
  { assert (0 <= a * w - s ^ 2) by nra.
    assert (Z : (s * y) * (s * y) <= (a * w - s ^ 2) * (a * w - s ^ 2)).
    { replace ((s * y) * (s * y)) with (s ^ 2 * (y * y)) by ring. rewrite EB. unfold B0.
      assert (a ^ 2 * s ^ 2 <= a ^ 2 * w ^ 2)
        by (apply Rmult_le_compat_l; [apply pow2_ge_0|apply pow_incr; lra]). lra. }
    apply Rnot_lt_le. intros N. nra. }
  assert (I2 : (s - t) * (s + y) <= a * (w - v)).
  { apply Rmult_le_reg_r with w; [lra|].
    apply Rle_trans with (s * (w - v) * (s + y)).
    - assert ((s - t) * w <= s * (w - v)) by lra.
      replace ((s - t) * (s + y) * w) with ((s - t) * w * (s + y)) by ring.
      apply Rmult_le_compat_r; lra.
    - assert ((w - v) * (s * (s + y)) <= (w - v) * (a * w)) by (apply Rmult_le_compat_l; lra).
      lra. }
  assert (I3 : y + (s - t) <= x).
  { assert ((y + (s - t)) * (y + (s - t)) <= x * x).
    { rewrite EA. replace ((y + (s - t)) * (y + (s - t)))
        with (y * y + 2 * y * (s - t) + (s - t) * (s - t)) by ring. rewrite EB. unfold A0, B0.
        lra. }
    apply Rnot_lt_le. intros N. nra. }
  assert (k * l <= x * y) by (apply Rmult_le_compat; lra).
  assert (2 * (x * y) <= 2 * (t * s - a * (v + w) + a ^ 2)); [|lra].
  assert ((s - t) * (s - t) <= (x - y) * (x - y)) by (apply Rmult_le_compat; lra).
  unfold A0, B0 in *. lra.
Qed.

Lemma share_range t P : 0 < P -> 0 <= t <= P -> 0 <= t / P <= 1.
Proof.
  intros P0 T. split.
  - apply Rmult_le_reg_r with P; [exact P0|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
  - apply Rmult_le_reg_r with P; [exact P0|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

Section Projective.
Variables r a : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Variable B : R -> R -> Prop.
Hypothesis B_range : forall x v, B x v -> 0 <= x /\ 0 <= v <= 1.
Hypothesis B_one : forall x, 0 <= x -> B x 1.
Hypothesis B_upper : forall x v y w, B x v -> x <= y -> v <= w <= 1 -> B y w.
Hypothesis B_convex : forall x v y w c, B x v -> B y w -> 0 <= c <= 1 ->
  B (c * x + (1 - c) * y) (c * v + (1 - c) * w).

Definition cone (S P t : R) := 0 < P /\ 0 <= t <= P /\ B (r * S / P) (1 - t / P).
Definition failing (S P Q : R) :=
  P <= 0 \/ exists t, cone S P t /\ Q ^ 2 <= t ^ 2 - 2 * a * P * S + a ^ 2 * S ^ 2.

Lemma cone_sum S P t S' P' t' : cone S P t -> cone S' P' t' -> cone (S + S') (P + P') (t + t').
Proof.
  intros [P0 [T H]] [P1 [T' H']]. split; [lra|]. split; [lra|].
  assert (C : 0 <= P / (P + P') <= 1) by (apply share_range; lra).
  pose proof (B_convex _ _ _ _ _ H H' C) as D.
  replace (r * (S + S') / (P + P')) with (P / (P + P') * (r * S / P) +
    (1 - P / (P + P')) * (r * S' / P')) by (field; lra).
  replace (1 - (t + t') / (P + P')) with (P / (P + P') * (1 - t / P) +
    (1 - P / (P + P')) * (1 - t' / P')) by (field; lra). exact D.
Qed.
Lemma cone_scale c S P t : 0 < c -> cone S P t -> cone (c * S) (c * P) (c * t).
Proof.
  intros C [P0 [T H]]. split; [now apply Rmult_lt_0_compat|]. split; [split; nra|].
  replace (r * (c * S) / (c * P)) with (r * S / P) by (field; lra).
  replace (c * t / (c * P)) with (t / P) by (field; lra). exact H.
Qed.
(* A larger P, with the same t. *)
Lemma cone_wide S P P' t : cone S P t -> P <= P' -> cone S P' t.
Proof.
  intros [P0 [T H]] L. split; [lra|]. split; [lra|].
  assert (C : 0 <= P / P' <= 1) by (apply share_range; lra).
  pose proof (B_convex _ _ _ _ _ H (B_one 0 (Rle_refl 0)) C) as D.
  replace (r * S / P') with (P / P' * (r * S / P) + (1 - P / P') * 0) by (field; lra).
  replace (1 - t / P') with (P / P' * (1 - t / P) + (1 - P / P') * 1) by (field; lra). exact D.
Qed.
(* A larger S/P, with the same t/P. *)
Lemma cone_narrow S P t S' P' : cone S P t -> 0 < P' -> S * P' <= S' * P ->
  cone S' P' (t * P' / P).
Proof.
  intros [P0 [T H]] P1 L. pose proof (share_range t P P0 T) as C.
  replace (t * P' / P) with (t / P * P') by (field; lra). split; [exact P1|]. split; [nra|].
  replace (t / P * P' / P') with (t / P) by (field; lra). apply B_upper with (1 := H); [|lra].
  apply Rmult_le_reg_r with (P * P'); [nra|].
  replace (r * S / P * (P * P')) with (r * (S * P')) by (field; lra).
  replace (r * S' / P' * (P * P')) with (r * (S' * P)) by (field; lra). nra.
Qed.

Lemma failing_scale c S P Q : 0 < c -> failing S P Q -> failing (c * S) (c * P) (c * Q).
Proof.
  intros C [H|[t [H I]]]; [left; nra|]. right. exists (c * t). split; [now apply cone_scale|].
  replace ((c * t) ^ 2 - 2 * a * (c * P) * (c * S) + a ^ 2 * (c * S) ^ 2)
    with (c ^ 2 * (t ^ 2 - 2 * a * P * S + a ^ 2 * S ^ 2)) by ring.
  rewrite Rpow_mult_distr. apply Rmult_le_compat_l; [apply pow2_ge_0|exact I].
Qed.
(* One of two states does not even approach. *)
Lemma failing_sum_flat S P Q S' P' Q' : 0 <= S -> 0 <= Q <= a * S - P -> 0 <= Q' <= a * S' - P' ->
  P <= 0 -> failing S' P' Q' -> failing (S + S') (P + P') (Q + Q').
Proof.
  intros S0 I I' P0 [H|[t [C H]]]; [left; lra|].
  destruct (Rle_lt_dec (P + P') 0) as [N|N]; [now left|]. right.
  assert (P1 := proj1 C). exists (t * (P + P') / P').
  assert (S1 : 0 < S') by nra.
  split; [apply cone_narrow with (1 := C); nra|].
  set (e := (P + P') / P'). replace (t * (P + P') / P') with (e * t) by (unfold e; field; lra).
  assert (E : 0 < e <= 1).
  { unfold e. split; [now apply Rdiv_lt_0_compat|].
    apply Rmult_le_reg_r with P'; [exact P1|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (EP : P + P' = e * P') by (unfold e; field; lra).
  set (A := S + (1 - e) * S'). set (D := Q + (1 - e) * Q').
  assert (A0 : 0 <= A) by (unfold A; nra).
  assert (D0 : 0 <= D <= a * A).
  { unfold A, D. split; [nra|]. assert ((1 - e) * Q' <= (1 - e) * (a * S' - P'))
      by (apply Rmult_le_compat_l; lra). nra. }
  replace (S + S') with (A + e * S') by (unfold A; ring).
  replace (Q + Q') with (D + e * Q') by (unfold D; ring). rewrite EP.
  assert (e ^ 2 * Q' ^ 2 <= e ^ 2 * (t ^ 2 - 2 * a * P' * S' + a ^ 2 * S' ^ 2))
    by (apply Rmult_le_compat_l; [apply pow2_ge_0|exact H]).
  assert (D ^ 2 <= (a * A) ^ 2) by (apply pow_incr; lra).
  assert (D * Q' <= a * A * (a * S' - P')) by (apply Rmult_le_compat; lra).
  assert (e * (D * Q') <= e * (a * A * (a * S' - P'))) by (apply Rmult_le_compat_l; lra). nra.
Qed.
(* Both approach. The first has the smaller P/S. *)
Lemma failing_sum_steep S P Q t S' P' Q' t' : 0 <= Q <= a * S - P -> 0 <= Q' <= a * S' - P' ->
  cone S P t -> Q ^ 2 <= t ^ 2 - 2 * a * P * S + a ^ 2 * S ^ 2 ->
  cone S' P' t' -> Q' ^ 2 <= t' ^ 2 - 2 * a * P' * S' + a ^ 2 * S' ^ 2 ->
  P * S' <= P' * S -> t * S' <= t' * S -> t' * P <= t * P' ->
  failing (S + S') (P + P') (Q + Q').
Proof.
  intros I I' C H C' H' LP LT LS. right. exists (t + t'). split; [now apply cone_sum|].
  destruct C as [P0 [T _]]. destruct C' as [P1 [T' _]].
  assert (S0 : 0 < S) by nra. assert (S1 : 0 < S') by nra.
  assert (K : Q / S * (Q' / S') <= t / S * (t' / S') - a * (P / S + P' / S') + a ^ 2).
  { assert (D : forall x y z w, 0 < y -> 0 < w -> x * w <= z * y -> x / y <= z / w).
    { intros x y z w Y W L. apply Rmult_le_reg_r with (y * w); [now apply Rmult_lt_0_compat|].
      replace (x / y * (y * w)) with (x * w) by (field; lra).
      replace (z / w * (y * w)) with (z * y) by (field; lra). exact L. }
    assert (D0 : forall x y, 0 < y -> 0 <= x -> 0 <= x / y).
    { intros x y Y X. unfold Rdiv. apply Rmult_le_pos; [exact X|]. left.
      now apply Rinv_0_lt_compat. }
    assert (F : forall Q t P S, 0 < S -> Q ^ 2 <= t ^ 2 - 2 * a * P * S + a ^ 2 * S ^ 2 ->
      (Q / S) ^ 2 <= (t / S) ^ 2 - 2 * a * (P / S) + a ^ 2).
    { clear - A1. intros Q t P S S0 H. apply Rmult_le_reg_r with (S ^ 2); [apply pow_lt; lra|].
      replace ((Q / S) ^ 2 * S ^ 2) with (Q ^ 2) by (field; lra).
      replace (((t / S) ^ 2 - 2 * a * (P / S) + a ^ 2) * S ^ 2)
        with (t ^ 2 - 2 * a * P * S + a ^ 2 * S ^ 2) by (field; lra). exact H. }
    apply reversed; auto.
    - split; [now apply Rdiv_lt_0_compat|]. apply D; lra.
    - replace a with (a / 1) by field. apply D; lra.
    - split; [apply D0; lra|]. apply D; lra.
    - apply D; nra.
    - replace (t' / S' * (P / S)) with (t' * P / (S' * S)) by (field; lra).
      replace (t / S * (P' / S')) with (t * P' / (S' * S)) by (field; lra).
      assert (0 < S' * S) by now apply Rmult_lt_0_compat.
      apply D; auto. apply Rmult_le_compat_r; lra.
    - apply D0; lra.
    - apply D0; lra. }
  apply Rmult_le_compat_r with (r := S * S') in K; [|nra].
  replace (Q / S * (Q' / S') * (S * S')) with (Q * Q') in K by (field; lra).
  replace ((t / S * (t' / S') - a * (P / S + P' / S') + a ^ 2) * (S * S'))
    with (t * t' - a * (P * S' + P' * S) + a ^ 2 * S * S') in K by (field; lra). lra.
Qed.
Lemma failing_sum_ordered S P Q t S' P' Q' t' : 0 <= Q <= a * S - P -> 0 <= Q' <= a * S' - P' ->
  cone S P t -> Q ^ 2 <= t ^ 2 - 2 * a * P * S + a ^ 2 * S ^ 2 ->
  cone S' P' t' -> Q' ^ 2 <= t' ^ 2 - 2 * a * P' * S' + a ^ 2 * S' ^ 2 ->
  P * S' <= P' * S -> failing (S + S') (P + P') (Q + Q').
Proof.
  intros I I' C H C' H' LP. assert (P0 := proj1 C). assert (P1 := proj1 C').
  assert (S0 : 0 < S) by nra. assert (S1 : 0 < S') by nra.
  destruct (proj2 C) as [T _]. destruct (proj2 C') as [T' _].
  destruct (Rle_lt_dec (t * S') (t' * S)) as [L|L].
  - destruct (Rle_lt_dec (t' * P) (t * P')) as [M|M].
    + now apply failing_sum_steep with t t'.
    + (* t can be larger. *)
      assert (E : t' * P / P' * P' = t' * P) by (field; lra).
      assert (G : t <= t' * P / P') by (apply Rmult_le_reg_r with P'; lra).
      apply failing_sum_steep with (t' * P / P') t'; auto.
      * apply cone_narrow with (1 := C'); lra.
      * apply Rle_trans with (1 := H). assert (t ^ 2 <= (t' * P / P') ^ 2) by (apply pow_incr; lra).
        lra.
      * apply Rmult_le_reg_r with P'; [lra|].
        replace (t' * P / P' * S' * P') with (t' * (P * S')) by (field; lra). nra.
      * lra.
  - (* t' can be larger. *)
    assert (E : S' / S * t * S = t * S') by (field; lra).
    assert (G : t' <= S' / S * t) by (apply Rmult_le_reg_r with S; lra).
    assert (F : S' / S * P <= P').
    { apply Rmult_le_reg_r with S; [lra|]. replace (S' / S * P * S) with (P * S') by (field; lra).
      lra. }
    apply failing_sum_steep with t (S' / S * t); auto; try lra.
    + apply cone_wide with (S' / S * P); [|exact F].
      replace S' with (S' / S * S) at 1 by (field; lra). apply cone_scale; auto.
      now apply Rdiv_lt_0_compat.
    + apply Rle_trans with (1 := H'). assert (t' ^ 2 <= (S' / S * t) ^ 2) by (apply pow_incr; lra).
      lra.
    + replace (S' / S * t * P) with (S' / S * P * t) by ring. nra.
Qed.
Lemma failing_sum S P Q S' P' Q' : 0 <= S -> 0 <= S' -> 0 <= Q <= a * S - P ->
  0 <= Q' <= a * S' - P' -> failing S P Q -> failing S' P' Q' ->
  failing (S + S') (P + P') (Q + Q').
Proof.
  intros S0 S1 I I' H H'. destruct H as [H|[t [C J]]]; [now apply failing_sum_flat|].
  destruct H' as [H'|[t' [C' J']]].
  - rewrite (Rplus_comm S), (Rplus_comm P), (Rplus_comm Q). apply failing_sum_flat; auto.
    right. eauto.
  - destruct (Rle_lt_dec (P * S') (P' * S)) as [L|L].
    + now apply failing_sum_ordered with t t'.
    + rewrite (Rplus_comm S), (Rplus_comm P), (Rplus_comm Q).
      apply failing_sum_ordered with t' t; auto. lra.
Qed.
End Projective.
