(* The separatrix is a convex function: the states from which collisions end within n steps form a
   convex set, by induction on n. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixCurve SeparatrixProjective.
Open Scope R_scope.
Set Default Proof Using "All".

Section Convex.
Variables r a : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Notation failing := (failing r a).

(* --- the states from which collisions end within n steps -------------------------------------- *)

Fixpoint bad (n : nat) (rho x v : R) : Prop :=
  match n with
  | O => 0 <= x /\ v = 1
  | S k => 0 <= x /\ 0 <= v <= 1 /\ failing (bad k (/ rho)) (1 - v) (a * (1 - v) - x - rho * v) x
  end.
Lemma bad_range n rho x v : bad n rho x v -> 0 <= x /\ 0 <= v <= 1.
Proof. destruct n; simpl; intros H; [lra|tauto]. Qed.
Lemma bad_one n rho x : 0 < rho -> 0 <= x -> bad n rho x 1.
Proof. destruct n; simpl; intros P X; [lra|]. split; [lra|]. split; [lra|]. left. lra. Qed.
Lemma bad_upper n : forall rho x v y w, 0 < rho -> bad n rho x v -> x <= y -> v <= w <= 1 ->
  bad n rho y w.
Proof.
  induction n; intros rho x v y w P H XY VW; [simpl in *; lra|].
  destruct H as [X [V H]]. split; [lra|]. split; [lra|].
  set (S := 1 - v) in *. set (T := 1 - w). set (A := a * S - x - rho * v) in *.
  set (C := a * T - y - rho * w). assert (P' := inverse_positive rho P).
  assert (L : C <= A) by (unfold C, A, T, S; nra).
  destruct (Rle_lt_dec C 0) as [C0|C0]; [now left|]. right.
  destruct H as [H|[t [[A0 [T0 H]] J]]]; [lra|]. exists (t * C / A).
  pose proof (share_range t A A0 T0) as F.
  assert (E : t = t / A * A) by (field; lra). set (c := t / A) in *.
  replace (t * C / A) with (c * C) by (unfold c; field; lra). split.
  - split; [exact C0|]. split; [nra|]. replace (c * C / C) with c by (field; lra).
    apply (IHn (/ rho)) with (2 := H); [exact P'| |lra].
    assert (O : S * C <= T * A).
    { assert (0 <= S * (y + rho * w) - T * (x + rho * v)).
      { assert (rho * v <= rho * w) by (apply Rmult_le_compat_l; lra).
        assert (0 <= rho * v) by (apply Rmult_le_pos; lra).
        assert (T * (x + rho * v) <= S * (y + rho * w))
          by (apply Rmult_le_compat; unfold S, T; lra). lra. }
      unfold A, C. lra. }
    apply Rmult_le_reg_r with (A * C); [nra|].
    replace (r * S / A * (A * C)) with (r * (S * C)) by (field; lra).
    replace (r * T / C * (A * C)) with (r * (T * A)) by (field; lra). nra.
  - rewrite E in J. assert (N : rho * v * (2 * x + rho * v) <= rho * w * (2 * y + rho * w)).
    { assert (rho * v <= rho * w) by (apply Rmult_le_compat_l; lra).
      assert (0 <= rho * v) by (apply Rmult_le_pos; lra). apply Rmult_le_compat; lra. }
    assert (K : (1 - c ^ 2) * C ^ 2 <= (1 - c ^ 2) * A ^ 2).
    { apply Rmult_le_compat_l; [nra|]. apply pow_incr. lra. }
    assert (J1 : (1 - c ^ 2) * A ^ 2 <= rho * v * (2 * x + rho * v)).
    { assert (Q : a * S - A = x + rho * v) by (unfold A; ring).
      replace (rho * v * (2 * x + rho * v)) with ((a * S - A) ^ 2 - x ^ 2) by (rewrite Q; ring).
      lra. }
    assert (J2 : (1 - c ^ 2) * C ^ 2 <= (a * T - C) ^ 2 - y ^ 2).
    { replace ((a * T - C) ^ 2 - y ^ 2) with (rho * w * (2 * y + rho * w)); [lra|].
      unfold C. ring. }
    lra.
Qed.
Lemma bad_convex n : forall rho x v y w c, 0 < rho -> bad n rho x v -> bad n rho y w ->
  0 <= c <= 1 -> bad n rho (c * x + (1 - c) * y) (c * v + (1 - c) * w).
Proof.
  induction n; intros rho x v y w c P H K C.
  { simpl in *. split; [nra|]. destruct H as [_ ->]. destruct K as [_ ->]. ring. }
  destruct (Rle_lt_or_eq_dec 0 c (proj1 C)) as [C0|C0];
    [|rewrite <- C0; replace (0 * x + (1 - 0) * y) with y by ring;
      replace (0 * v + (1 - 0) * w) with w by ring; exact K].
  destruct (Rle_lt_or_eq_dec c 1 (proj2 C)) as [C1|C1];
    [|rewrite C1; replace (1 * x + (1 - 1) * y) with x by ring;
      replace (1 * v + (1 - 1) * w) with v by ring; exact H].
  destruct H as [X [V H]]. destruct K as [Y [W K]]. assert (P' := inverse_positive rho P).
  split; [nra|]. split; [nra|].
  assert (RV : 0 <= rho * v) by (apply Rmult_le_pos; lra).
  assert (RW : 0 <= rho * w) by (apply Rmult_le_pos; lra).
  replace (1 - (c * v + (1 - c) * w)) with (c * (1 - v) + (1 - c) * (1 - w)) by ring.
  replace (a * (c * (1 - v) + (1 - c) * (1 - w)) - (c * x + (1 - c) * y) -
    rho * (c * v + (1 - c) * w)) with (c * (a * (1 - v) - x - rho * v) +
    (1 - c) * (a * (1 - w) - y - rho * w)) by ring.
  pose proof (bad_range n (/ rho)) as B1. pose proof (fun z => bad_one n (/ rho) z P') as B2.
  pose proof (fun z0 v0 z1 v1 => bad_upper n (/ rho) z0 v0 z1 v1 P') as B3.
  pose proof (fun z0 v0 z1 v1 d => IHn (/ rho) z0 v0 z1 v1 d P') as B4.
  apply failing_sum; auto; try (apply Rmult_le_pos; lra).
  - split; [apply Rmult_le_pos; lra|]. assert (0 <= c * (rho * v)) by (apply Rmult_le_pos; lra).
    lra.
  - split; [apply Rmult_le_pos; lra|].
    assert (0 <= (1 - c) * (rho * w)) by (apply Rmult_le_pos; lra). lra.
  - apply failing_scale; auto.
  - apply failing_scale; auto. lra.
Qed.
Lemma bad_more n : forall rho x v, 0 < rho -> bad n rho x v -> bad (S n) rho x v.
Proof.
  induction n; intros rho x v P H.
  - destruct H as [X ->]. now apply bad_one.
  - destruct H as [X [V H]]. split; [exact X|]. split; [exact V|].
    destruct H as [H|[t [[A0 [T H]] J]]]; [now left|]. right. exists t. split; [|exact J].
    split; [exact A0|]. split; [exact T|]. apply IHn; [now apply inverse_positive|exact H].
Qed.
Lemma bad_later n m rho x v : 0 < rho -> (n <= m)%nat -> bad n rho x v -> bad m rho x v.
Proof. intros P L H. induction L; [exact H|]. now apply bad_more. Qed.

(* They are what they are called. *)
Lemma bad_if_stuck rho x : 0 < rho -> region x -> ~ goes_on a rho x -> bad 1 rho (q x) (u x).
Proof.
  intros P [Q U] N. split; [exact Q|]. split; [lra|].
  destruct (Rle_lt_dec (p a rho x) 0) as [L|L]; [now left|]. right. exists 0.
  assert (W : p a rho x ^ 2 <= width rho x) by (apply Rnot_lt_le; intros M; apply N; now split).
  fold (p a rho x). split.
  - split; [exact L|]. split; [lra|]. split; [|unfold Rdiv; ring].
    apply Rmult_le_pos; [nra|]. left. now apply Rinv_0_lt_compat.
  - unfold width, p in *. lra.
Qed.
Lemma bad_if_ends n : forall rho x, 0 < rho -> region x ->
  ~ goes_on a (ratio rho n) (orbit r a rho x n) -> exists m, bad m rho (q x) (u x).
Proof.
  induction n; intros rho x P X N.
  - exists 1%nat. now apply bad_if_stuck.
  - destruct (Classical_Prop.classic (goes_on a rho x)) as [G|G];
      [|exists 1%nat; now apply bad_if_stuck].
    rewrite ratio_shift, (orbit_shift r a R1 A1) in N.
    destruct (IHn _ _ (inverse_positive rho P) (next_region r a R1 A1 rho x P X G) N) as [m M].
    exists (S m). pose proof (p_positive r a R1 A1 rho x P X G) as A0.
    pose proof (next_u_range r a R1 A1 rho x P X G) as V.
    pose proof (next_h r a R1 A1 rho x P X G) as H. destruct X as [Q U].
    split; [exact Q|]. split; [lra|]. right. fold (p a rho x).
    set (v := u (next r a rho x)) in *. exists ((1 - v) * p a rho x). split.
    + split; [exact A0|]. split; [split; nra|].
      replace (1 - (1 - v) * p a rho x / p a rho x) with v by (field; lra). exact M.
    + replace (((1 - v) * p a rho x) ^ 2) with (p a rho x ^ 2 - h v * p a rho x ^ 2)
        by (unfold h; ring). rewrite H. unfold width, p. lra.
Qed.
Lemma bad_not_unending n : forall rho x, 0 < rho -> bad n rho (q x) (u x) -> ~ unending r a rho x.
Proof.
  induction n; intros rho x P B H; destruct (unending_now _ _ R1 A1 _ _ H) as [X G].
  - destruct B as [_ B]. destruct X. lra.
  - pose proof (p_positive r a R1 A1 rho x P X G) as A0.
    pose proof (next_u_range r a R1 A1 rho x P X G) as V.
    pose proof (next_h r a R1 A1 rho x P X G) as W. assert (P' := inverse_positive rho P).
    destruct B as [_ [_ [B|[t [[_ [T B]] J]]]]]; fold (p a rho x) in *; [lra|].
    apply (IHn _ (next r a rho x) P'); [|now apply unending_next].
    apply (bad_upper n _ _ _ _ _ P' B); [apply Rle_refl|]. split; [|lra].
    pose proof (share_range t _ A0 T) as F. set (c := t / p a rho x) in *.
    apply h_reflects_le; [lra|lra|].
    apply Rmult_le_reg_r with (p a rho x ^ 2); [apply pow_lt; lra|]. rewrite W.
    replace (h (1 - c) * p a rho x ^ 2) with (p a rho x ^ 2 - (c * p a rho x) ^ 2)
      by (unfold h; ring).
    replace (c * p a rho x) with t by (unfold c; field; lra). unfold width, p in *. lra.
Qed.

Theorem f_convex rho y z c : 0 < rho -> 0 <= y -> 0 <= z -> 0 <= c <= 1 ->
  separatrix_at r a R1 A1 rho (c * y + (1 - c) * z) <=
    c * separatrix_at r a R1 A1 rho y + (1 - c) * separatrix_at r a R1 A1 rho z.
Proof.
  intros P Y Z C. set (f := separatrix_at r a R1 A1 rho). set (x := c * y + (1 - c) * z).
  assert (X : 0 <= x) by (unfold x; nra).
  assert (F0 : forall v, 0 <= f v) by (intros; now apply f_not_negative).
  assert (F1 : forall v, f v < 1) by (intros; now apply f_less_1).
  apply Rnot_lt_le. intros N. set (m := c * f y + (1 - c) * f z) in *.
  set (e := Rmin (f x - m) (Rmin (1 - f y) (1 - f z)) / 2).
  assert (E : 0 < e /\ m + e < f x /\ f y + e < 1 /\ f z + e < 1).
  { pose proof (Rmin_l (f x - m) (Rmin (1 - f y) (1 - f z))).
    pose proof (Rmin_r (f x - m) (Rmin (1 - f y) (1 - f z))).
    pose proof (Rmin_l (1 - f y) (1 - f z)). pose proof (Rmin_r (1 - f y) (1 - f z)).
    assert (0 < Rmin (f x - m) (Rmin (1 - f y) (1 - f z))).
    { specialize (F1 y) as G. specialize (F1 z) as K. repeat apply Rmin_glb_lt; lra. }
    unfold e. lra. }
  assert (BAD : forall v, 0 <= v -> f v + e < 1 -> exists n, bad n rho v (f v + e)).
  { intros v V L. specialize (F0 v). set (w := State v (f v + e)).
    assert (W : region w) by (unfold region, w; simpl; lra).
    destruct (unending_or_ends r a R1 A1 rho P w W) as [H|[n H]].
    - apply (f_upper r a R1 A1 rho P) in H. simpl in H. fold f in H. lra.
    - exact (bad_if_ends n rho w P W H). }
  destruct (BAD y Y) as [i I]; [lra|]. destruct (BAD z Z) as [j J]; [lra|].
  apply (bad_later i (i + j)) in I; [|exact P|lia].
  apply (bad_later j (i + j)) in J; [|exact P|lia].
  pose proof (bad_convex _ _ _ _ _ _ c P I J C) as K. fold x in K.
  replace (c * (f y + e) + (1 - c) * (f z + e)) with (m + e) in K by (unfold m; ring).
  apply (bad_not_unending _ rho (State x (m + e)) P K).
  apply (unending_under r a R1 A1 rho P); simpl; [|fold f; lra].
  specialize (F1 x). unfold region, m. simpl. split; [exact X|].
  assert (0 <= c * f y) by (apply Rmult_le_pos; [lra|apply F0]).
  assert (0 <= (1 - c) * f z) by (apply Rmult_le_pos; [lra|apply F0]). unfold m in *. lra.
Qed.
End Convex.
