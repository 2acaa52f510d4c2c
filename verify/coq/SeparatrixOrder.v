(* One step of the limit map, and the order that it preserves: what lies below a state that goes on
   goes on too, and its image lies below. Hence the states whose collisions never end form a lower
   set. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix.
Open Scope R_scope.
Set Default Proof Using "All".

Definition h (v : R) := v * (2 - v).
(* h of the next u, times the square of p. *)
Definition width (rho : R) (x : state) := rho * u x * (2 * q x + rho * u x).
Definition below (x y : state) := q x <= q y /\ u x <= u y.

Lemma h_reflects_le v w : v <= 1 -> w < 1 -> h v <= h w -> v <= w.
Proof. unfold h. intros. apply Rnot_lt_le. intros N. nra. Qed.
Lemma h_reflects_lt v w : v <= 1 -> w < 1 -> h v < h w -> v < w.
Proof. unfold h. intros. apply Rnot_le_lt. intros N. nra. Qed.
Lemma h_range v : 0 < v < 1 -> 0 < h v < 1.
Proof. unfold h. intros. split; nra. Qed.
Lemma width_positive rho x : 0 < rho -> region x -> 0 < width rho x.
Proof.
  unfold width, region. intros P [Q [U _]].
  assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra). apply Rmult_lt_0_compat; lra.
Qed.
Lemma width_le rho x y : 0 < rho -> region x -> below x y -> width rho x <= width rho y.
Proof.
  unfold width, region, below. intros P [Q [U _]] [LQ LU].
  assert (rho * u x <= rho * u y) by (apply Rmult_le_compat_l; lra).
  assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra).
  apply Rmult_le_compat; lra.
Qed.
Lemma inverse_positive rho : 0 < rho -> 0 < / rho.
Proof. apply Rinv_0_lt_compat. Qed.

Lemma ratio_positive rho n : 0 < rho -> 0 < ratio rho n.
Proof. intros P. unfold ratio. destruct (Nat.even n); auto using inverse_positive. Qed.
Lemma ratio_shift rho n : ratio rho (S n) = ratio (/ rho) n.
Proof.
  unfold ratio. rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even n); simpl; auto.
  now rewrite Rinv_inv.
Qed.
Lemma ratio_turn rho n : 0 < rho -> ratio rho (S n) * ratio rho n = 1.
Proof.
  intros P. unfold ratio. rewrite Nat.even_succ, <- Nat.negb_even.
  destruct (Nat.even n); simpl; field; lra.
Qed.

Section Step.
Variables r a : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.

Section One.
Variable rho : R.
Variable x : state.
Hypothesis P1 : 0 < rho.
Hypothesis X : region x.
Hypothesis G : goes_on a rho x.

Lemma p_positive : 0 < p a rho x.
Proof. apply G. Qed.
Lemma next_q : q (next r a rho x) * p a rho x = r * (1 - u x).
Proof. pose proof p_positive. unfold next, q at 1. field. lra. Qed.
Lemma fraction : 0 < width rho x / p a rho x ^ 2 < 1.
Proof.
  pose proof p_positive as P. pose proof (width_positive rho x P1 X) as W. destruct G as [_ L].
  assert (0 < p a rho x ^ 2) by (apply pow_lt; lra).
  split; [apply Rdiv_lt_0_compat; lra|].
  apply Rmult_lt_reg_r with (p a rho x ^ 2); [lra|]. fold (width rho x) in L.
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma next_u : u (next r a rho x) = 1 - sqrt (1 - width rho x / p a rho x ^ 2).
Proof. reflexivity. Qed.
Lemma next_u_range : 0 < u (next r a rho x) < 1.
Proof.
  rewrite next_u. pose proof fraction as F.
  assert (0 < sqrt (1 - width rho x / p a rho x ^ 2)) by (apply sqrt_lt_R0; lra).
  assert (sqrt (1 - width rho x / p a rho x ^ 2) < sqrt 1) by (apply sqrt_lt_1_alt; lra).
  rewrite sqrt_1 in *. lra.
Qed.
Lemma next_h : h (u (next r a rho x)) * p a rho x ^ 2 = width rho x.
Proof.
  rewrite next_u. pose proof fraction as F. pose proof p_positive as P. unfold h.
  set (w := width rho x / p a rho x ^ 2) in *. set (y := sqrt (1 - w)).
  assert (E : y * y = 1 - w) by (apply sqrt_sqrt; lra).
  replace ((1 - y) * (2 - (1 - y))) with (1 - y * y) by ring. rewrite E.
  unfold w. field. lra.
Qed.
Lemma next_q_positive : 0 < q (next r a rho x).
Proof.
  pose proof p_positive. unfold next, q. destruct X as [_ [_ U]].
  apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra|lra].
Qed.
Lemma next_region : region (next r a rho x).
Proof. pose proof next_q_positive. pose proof next_u_range. split; lra. Qed.

(* How to show that the next state lies below another one. *)
Lemma next_q_le b : r * (1 - u x) <= b * p a rho x -> q (next r a rho x) <= b.
Proof.
  intros B. rewrite <- next_q in B. apply Rmult_le_reg_r in B; [exact B|exact p_positive].
Qed.
Lemma next_q_lt b : r * (1 - u x) < b * p a rho x -> q (next r a rho x) < b.
Proof.
  intros B. rewrite <- next_q in B. apply Rmult_lt_reg_r in B; [exact B|exact p_positive].
Qed.
Lemma next_u_le b : b < 1 -> width rho x <= h b * p a rho x ^ 2 -> u (next r a rho x) <= b.
Proof.
  intros L B. rewrite <- next_h in B. pose proof next_u_range.
  apply Rmult_le_reg_r in B; [|apply pow_lt, p_positive]. apply h_reflects_le; lra.
Qed.
Lemma next_u_lt b : b < 1 -> width rho x < h b * p a rho x ^ 2 -> u (next r a rho x) < b.
Proof.
  intros L B. rewrite <- next_h in B. pose proof next_u_range.
  apply Rmult_lt_reg_r in B; [|apply pow_lt, p_positive]. apply h_reflects_lt; lra.
Qed.
(* The next q is large, and the next u is. *)
Lemma next_q_lower : r < q (next r a rho x) * (a - q x).
Proof.
  pose proof next_q as E. pose proof next_q_positive as Q. destruct X as [Q0 [U0 U1]].
  assert (L : p a rho x < (a - q x) * (1 - u x)) by (unfold p; nra).
  apply (Rmult_lt_compat_l _ _ _ Q) in L. rewrite E in L.
  apply Rmult_lt_reg_r with (1 - u x); lra.
Qed.
Lemma q_less : q x < a.
Proof.
  pose proof p_positive as P. unfold p in P. destruct X as [Q0 [U0 U1]].
  assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra). nra.
Qed.
Lemma u_bound : u x <= a / (a + rho).
Proof.
  pose proof p_positive as P. unfold p in P. destruct X as [Q0 [U0 U1]].
  apply Rmult_le_reg_r with (a + rho); [lra|]. unfold Rdiv.
  rewrite Rmult_assoc, Rinv_l; nra.
Qed.
Lemma next_u_lower :
  rho * u x * q x * q (next r a rho x) ^ 2 <= u (next r a rho x) * r ^ 2.
Proof.
  pose proof next_q as E. pose proof next_h as H. pose proof p_positive as P.
  pose proof next_u_range as U. destruct X as [Q0 [U0 U1]].
  assert (S : rho * u x * q x <= u (next r a rho x) * p a rho x ^ 2).
  { assert (h (u (next r a rho x)) * p a rho x ^ 2 <= 2 * u (next r a rho x) * p a rho x ^ 2).
    { apply Rmult_le_compat_r; [apply pow_le; lra|]. unfold h. nra. }
    assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra). unfold width in H. nra. }
  apply Rmult_le_compat_r with (r := q (next r a rho x) ^ 2) in S; [|nra].
  apply Rle_trans with (1 := S).
  replace (u (next r a rho x) * p a rho x ^ 2 * q (next r a rho x) ^ 2)
    with (u (next r a rho x) * (q (next r a rho x) * p a rho x) ^ 2) by ring.
  rewrite E. apply Rmult_le_compat_l; [lra|]. apply pow_incr. nra.
Qed.
End One.

(* --- order ------------------------------------------------------------------------------------ *)

Section Order.
Variable rho : R.
Variables x y : state.
Hypothesis P1 : 0 < rho.
Hypothesis X : region x.
Hypothesis Y : region y.
Hypothesis B : below x y.
Hypothesis G : goes_on a rho y.

Lemma p_difference : p a rho x - p a rho y = (a + rho) * (u y - u x) + (q y - q x).
Proof. unfold p. ring. Qed.
Lemma p_order : p a rho y <= p a rho x.
Proof. pose proof p_difference. destruct B. nra. Qed.
Lemma goes_on_below : goes_on a rho x.
Proof.
  pose proof p_order as O. pose proof (width_le rho x y P1 X B) as W. destruct G as [P L].
  fold (width rho y) in L. split; [lra|]. fold (width rho x).
  apply Rle_lt_trans with (1 := W). apply Rlt_le_trans with (1 := L). apply pow_incr. lra.
Qed.
Lemma next_below : below (next r a rho x) (next r a rho y).
Proof.
  pose proof p_order as O. pose proof (width_le rho x y P1 X B) as W.
  pose proof (p_positive rho y P1 Y G) as P. pose proof goes_on_below as GX.
  pose proof (next_u_range rho y P1 Y G) as U. destruct B as [BQ BU].
  destruct X as [Q0 [U0 U1]]. destruct Y as [V0 [W0 W1]]. split.
  - apply next_q_le; auto. apply Rmult_le_reg_r with (p a rho y); [exact P|].
    replace (q (next r a rho y) * p a rho x * p a rho y)
      with (q (next r a rho y) * p a rho y * p a rho x) by ring.
    rewrite (next_q rho y P1 Y G).
    assert ((1 - u x) * p a rho y <= (1 - u y) * p a rho x).
    { assert (E : (1 - u y) * p a rho x - (1 - u x) * p a rho y =
        (1 - u x) * (q y + rho * u y) - (1 - u y) * (q x + rho * u x)) by (unfold p; ring).
      assert (rho * u x <= rho * u y) by (apply Rmult_le_compat_l; lra).
      assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra).
      assert ((1 - u y) * (q x + rho * u x) <= (1 - u x) * (q y + rho * u y))
        by (apply Rmult_le_compat; lra).
      lra. }
    nra.
  - apply next_u_le; auto; [lra|]. apply Rle_trans with (1 := W).
    rewrite <- (next_h rho y P1 Y G). apply Rmult_le_compat_l.
    + pose proof (h_range _ U). lra.
    + apply pow_incr. lra.
Qed.
Hypothesis D : q x < q y \/ u x < u y.
Lemma p_order_strict : p a rho y < p a rho x.
Proof. pose proof p_difference. destruct B, D; nra. Qed.
Lemma next_strictly_below :
  q (next r a rho x) < q (next r a rho y) /\ u (next r a rho x) < u (next r a rho y).
Proof.
  pose proof p_order_strict as O. pose proof (width_le rho x y P1 X B) as W.
  pose proof (p_positive rho y P1 Y G) as P. pose proof goes_on_below as GX.
  pose proof (next_u_range rho y P1 Y G) as U. destruct B as [BQ BU].
  destruct X as [Q0 [U0 U1]]. destruct Y as [V0 [W0 W1]]. split.
  - apply next_q_lt; auto. apply Rmult_lt_reg_r with (p a rho y); [exact P|].
    replace (q (next r a rho y) * p a rho x * p a rho y)
      with (q (next r a rho y) * p a rho y * p a rho x) by ring.
    rewrite (next_q rho y P1 Y G).
    assert ((1 - u x) * p a rho y < (1 - u y) * p a rho x).
    { assert (E : (1 - u y) * p a rho x - (1 - u x) * p a rho y =
        (1 - u x) * (q y - q x) + (u y - u x) * q x + rho * (u y - u x)) by (unfold p; ring).
      destruct D; nra. }
    nra.
  - apply next_u_lt; auto; [lra|]. apply Rle_lt_trans with (1 := W).
    rewrite <- (next_h rho y P1 Y G). apply Rmult_lt_compat_l.
    + pose proof (h_range _ U). lra.
    + simpl. nra.
Qed.
End Order.

(* --- orbits ----------------------------------------------------------------------------------- *)

Lemma orbit_shift rho x n : orbit r a rho x (S n) = orbit r a (/ rho) (next r a rho x) n.
Proof.
  induction n; [reflexivity|].
  change (next r a (ratio rho (S n)) (orbit r a rho x (S n))
    = next r a (ratio (/ rho) n) (orbit r a (/ rho) (next r a rho x) n)).
  now rewrite IHn, ratio_shift.
Qed.

Lemma unending_now rho x : unending r a rho x -> region x /\ goes_on a rho x.
Proof. intros [X G]. split; [exact X|]. exact (G 0%nat). Qed.
Lemma unending_next rho x : 0 < rho -> unending r a rho x -> unending r a (/ rho) (next r a rho x).
Proof.
  intros P H. destruct (unending_now _ _ H) as [X G]. split; [now apply next_region|].
  intros n. rewrite <- ratio_shift, <- orbit_shift. apply H.
Qed.
(* A property that lets a state go on and that the next state has too, with the other ratio. *)
Lemma unending_if (A : R -> state -> Prop) :
  (forall rho x, 0 < rho -> A rho x -> region x /\ goes_on a rho x /\ A (/ rho) (next r a rho x)) ->
  forall rho x, 0 < rho -> A rho x -> unending r a rho x.
Proof.
  intros C rho x P H. split; [apply (C rho x P H)|]. intros n. revert rho x P H.
  induction n; intros rho x P H; destruct (C rho x P H) as [X [G N]].
  - exact G.
  - rewrite ratio_shift, orbit_shift. apply IHn; auto using inverse_positive.
Qed.
Lemma unending_from_next rho x : 0 < rho -> region x -> goes_on a rho x ->
  unending r a (/ rho) (next r a rho x) -> unending r a rho x.
Proof.
  intros P X G N. split; [exact X|]. intros [|n]; [exact G|].
  rewrite ratio_shift, orbit_shift. apply N.
Qed.
Lemma unending_orbit rho x n : 0 < rho -> unending r a rho x ->
  unending r a (ratio rho n) (orbit r a rho x n).
Proof.
  revert rho x. induction n; intros rho x P H; [exact H|].
  rewrite ratio_shift, orbit_shift. apply IHn; auto using inverse_positive, unending_next.
Qed.
(* The states whose collisions never end form a lower set. *)
Lemma unending_below rho x y : 0 < rho -> region x -> below x y ->
  unending r a rho y -> unending r a rho x.
Proof.
  intros P X B H.
  apply (unending_if (fun rho x => region x /\ exists y, below x y /\ unending r a rho y));
    [|exact P|eauto].
  clear rho x y P X B H. intros rho x P [X [y [B H]]]. destruct (unending_now _ _ H) as [Y G].
  pose proof (goes_on_below rho x y P X Y B G) as GX. split; [exact X|]. split; [exact GX|].
  split; [now apply next_region|]. exists (next r a rho y).
  split; [now apply next_below|now apply unending_next].
Qed.
End Step.
