(* Ball o collides with c and a in turn without end, and in the limit both touch it: how small the
   angle at it may be. The balls have equal masses, and any radii. *)
From Coq Require Import Reals Arith Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Classification Contacts Calculus.
Open Scope R_scope.

Section OneByOne.
Variable d : nat.
Variables r C0 : R.
Variable scenes : nat -> scene.
Variable tau : nat -> R.
Variables o a c : ball.
Variable reach : ball -> R.  (* the distance at which a ball touches o *)
Hypothesis far : forall b, 0 < reach b.
Definition partner (n : nat) : ball := if Nat.even n then c else a.
Definition spectator (n : nat) : ball := if Nat.even n then a else c.
Let arriving n := later (tau n) (scenes n).
Hypothesis restitutes : 0 < r <= 1.
Hypothesis distinct : distinct_balls o a c.
Hypothesis run : forall n, 0 < tau n /\ distance d (arriving n) o (partner n) = reach (partner n) /\
  rate d (arriving n) o (partner n) < 0 /\
  reach (spectator n) <= distance d (arriving n) o (spectator n) /\
  even_hit d r o (partner n) (arriving n) (scenes (S n)).
Hypothesis touch_a : Un_cv (fun n => distance d (scenes n) o a) (reach a).
Hypothesis touch_c : Un_cv (fun n => distance d (scenes n) o c) (reach c).
Hypothesis angle : Un_cv (fun n => minus_cosine_at d (scenes n) o a c) C0.

Lemma next_partner n : partner (S n) = spectator n.
Proof. unfold partner, spectator. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even n). Qed.
Lemma next_spectator n : spectator (S n) = partner n.
Proof. unfold partner, spectator. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even n). Qed.
Lemma others n : o <> partner n /\ spectator n <> o /\ spectator n <> partner n.
Proof.
  destruct distinct as (A & C & N). unfold partner, spectator. destruct (Nat.even n); repeat split; congruence.
Qed.

(* The speed at which a ball recedes along the line of the centres, if it touches o. *)
Let part s b := rate d s o b / reach b.
Let u n := - part (arriving n) (partner n).
Let D n := distance d (scenes (S n)) o (spectator n) / reach (spectator n).
Let C n := minus_cosine_at d (scenes (S n)) o a c.
Lemma divided_positive x b : 0 < x -> 0 < x / reach b.
Proof. intros P. now apply Rdiv_lt_0_compat. Qed.
Lemma u_positive n : 0 < u n.
Proof.
  destruct (run n) as (_ & _ & P & _). unfold u, part.
  replace (- (rate d (arriving n) o (partner n) / reach (partner n))) with
    (- rate d (arriving n) o (partner n) / reach (partner n)) by (unfold Rdiv; ring).
  apply divided_positive. lra.
Qed.
Lemma places n i j : to (scenes (S n)) i j = to (arriving n) i j.
Proof. destruct (run n) as (_ & _ & _ & _ & (J & _ & X & _) & _). now apply same_places. Qed.
Lemma contact n : distance d (scenes (S n)) o (partner n) = reach (partner n).
Proof. unfold distance. rewrite places. apply (run n). Qed.
Lemma contact_square n : square d (scenes (S n)) o (partner n) = reach (partner n) ^ 2.
Proof. rewrite square_of_distance, contact. ring. Qed.
Lemma D_at_least n : 1 <= D n.
Proof.
  assert (A : reach (spectator n) <= distance d (scenes (S n)) o (spectator n)) by (unfold distance; rewrite places; apply (run n)).
  pose proof (far (spectator n)). unfold D. apply Rmult_le_reg_r with (reach (spectator n)); [assumption|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l by lra. lra.
Qed.
Lemma inner n : dot d (to (arriving n) o (partner n)) (to (arriving n) o (spectator n)) =
  - (C n * D n * reach (partner n) * reach (spectator n)).
Proof.
  rewrite <- !places. pose proof (contact n) as A. pose proof (D_at_least n) as B. pose proof (far (partner n)).
  pose proof (far (spectator n)) as F. set (x := distance d (scenes (S n)) o (spectator n)) in *.
  assert (X : 0 < x).
  { replace x with (D n * reach (spectator n)) by (unfold D; fold x; field; lra). apply Rmult_lt_0_compat; lra. }
  unfold D. fold x. unfold C, minus_cosine_at, x, partner, spectator in *. destruct (Nat.even n); rewrite A.
  - rewrite (dot_symmetric d (to (scenes (S n)) o c)). field. lra.
  - field. lra.
Qed.
Lemma recedes n : part (scenes (S n)) (partner n) = r * u n.
Proof. destruct (run n) as (_ & _ & _ & _ & _ & E). unfold part, u, part. rewrite E. unfold Rdiv. ring. Qed.
Lemma pushed_together n : part (scenes (S n)) (spectator n) =
  part (arriving n) (spectator n) - (1 + r) / 2 * (C n * D n) * u n.
Proof.
  pose proof (inner n) as Q. pose proof (contact_square n) as S. pose proof (far (partner n)). pose proof (far (spectator n)).
  destruct (run n) as (_ & _ & _ & _ & H'). destruct (others n) as (N & M & O).
  unfold square in S. rewrite places in S. fold (square d (arriving n) o (partner n)) in S.
  assert (S0 : 0 < square d (arriving n) o (partner n)) by (rewrite S; now apply pow_lt).
  unfold part at 1, rate. rewrite places, (even_velocity d r o (partner n) (spectator n) _ _ N M O S0 H'), dot_linear_right.
  rewrite (dot_symmetric d _ (to (arriving n) o (partner n))), Q, S. fold (rate d (arriving n) o (spectator n)).
  unfold u, part. field. lra.
Qed.
Lemma part_rises s b t : 0 <= t -> part s b <= part (later t s) b.
Proof.
  intros T. pose proof (rate_rises d s o b t T). unfold part, Rdiv. apply Rmult_le_compat_r; [|assumption].
  now apply Rlt_le, Rinv_0_lt_compat.
Qed.
Lemma recursion n : u (S (S n)) <= (1 + r) / 2 * (C (S n) * D (S n)) * u (S n) - r * u n.
Proof.
  pose proof (recedes n) as P. pose proof (pushed_together (S n)) as Q.
  rewrite next_spectator in Q. destruct (run (S n)) as (T1 & _). destruct (run (S (S n))) as (T2 & _).
  pose proof (part_rises (scenes (S n)) (partner n) _ (Rlt_le _ _ T1)) as R1.
  pose proof (part_rises (scenes (S (S n))) (partner n) _ (Rlt_le _ _ T2)) as R2.
  fold (arriving (S n)) in R1. fold (arriving (S (S n))) in R2.
  unfold u at 1. rewrite (next_partner (S n)), next_spectator. lra.
Qed.
Lemma D_limit : Un_cv D 1.
Proof.
  assert (G : forall b, Un_cv (fun n => distance d (scenes n) o b) (reach b) -> Un_cv (fun n => distance d (scenes n) o b / reach b) 1).
  { intros b L. pose proof (far b). replace 1 with (reach b * / reach b) by (field; lra).
    apply (CV_mult _ (fun _ => / reach b) _ _ L). intros e E. exists O. intros n _. now rewrite R_dist_eq. }
  intros e E. destruct (G a touch_a e E) as (N1 & A). destruct (G c touch_c e E) as (N2 & B).
  exists (max N1 N2). intros n L. unfold D, spectator. destruct (Nat.even n); [apply A | apply B]; lia.
Qed.
Lemma C_limit : Un_cv C C0.
Proof. intros e E. destruct (angle e E) as (N & A). exists N. intros n L. unfold C. apply A. lia. Qed.
(* From some collision on the factor of u is below any number that is above its limit. *)
Lemma factor_below b : (1 + r) / 2 * C0 < b ->
  exists N, forall n, (n >= N)%nat -> (1 + r) / 2 * (C n * D n) <= b.
Proof.
  intros B. pose proof (CV_mult _ _ _ _ C_limit D_limit) as CD.
  set (gap := b - (1 + r) / 2 * C0). assert (G : 0 < gap) by (unfold gap; lra).
  destruct (CD (gap / (1 + r))) as (N & H); [apply Rdiv_lt_0_compat; lra|].
  exists N. intros n L. specialize (H n L). unfold R_dist in H. apply Rabs_def2 in H. destruct H as [H _].
  apply Rle_trans with ((1 + r) / 2 * (C0 * 1 + gap / (1 + r))); [apply Rmult_le_compat_l; lra|].
  replace ((1 + r) / 2 * (C0 * 1 + gap / (1 + r))) with ((1 + r) / 2 * C0 + gap / 2) by (field; lra).
  unfold gap in *. lra.
Qed.
Lemma below_threshold x : C0 < 2 * x / (1 + r) -> (1 + r) / 2 * C0 < x.
Proof.
  intros L. apply Rmult_lt_reg_r with (2 / (1 + r)); [apply Rdiv_lt_0_compat; lra|].
  replace ((1 + r) / 2 * C0 * (2 / (1 + r))) with C0 by (field; lra).
  replace (x * (2 / (1 + r))) with (2 * x / (1 + r)) by (field; lra). exact L.
Qed.

Theorem angle_at_least : 4 * sqrt r / (1 + r) <= C0.
Proof.
  apply Rnot_lt_le. intros LT.
  assert (S0 : 0 < sqrt r) by (apply sqrt_lt_R0; lra).
  assert (SS : sqrt r * sqrt r = r) by (apply sqrt_sqrt; lra).
  assert (B : (1 + r) / 2 * C0 < 2 * sqrt r).
  { apply below_threshold. replace (2 * (2 * sqrt r) / (1 + r)) with (4 * sqrt r / (1 + r)) by (field; lra).
    exact LT. }
  set (m := Rmax 0 ((1 + r) / 2 * C0)).
  assert (M1 : 0 <= m) by apply Rmax_l. assert (M2 : (1 + r) / 2 * C0 <= m) by apply Rmax_r.
  assert (M3 : m < 2 * sqrt r) by (unfold m; apply Rmax_lub_lt; lra).
  set (b := (m + 2 * sqrt r) / 2).
  destruct (factor_below b) as (N & H); [unfold b; lra|].
  apply (no_endless b r (fun n => u (N + n)%nat)).
  - unfold b. lra.
  - lra.
  - assert (B1 : 0 < b < 2 * sqrt r) by (unfold b; lra).
    apply Rlt_le_trans with (2 * sqrt r * (2 * sqrt r)); [apply Rmult_le_0_lt_compat; lra | lra].
  - intros n. apply u_positive.
  - intros n. replace (N + S (S n))%nat with (S (S (N + n))) by lia.
    replace (N + S n)%nat with (S (N + n)) by lia.
    apply Rle_trans with (1 := recursion (N + n)).
    pose proof (u_positive (S (N + n))). specialize (H (S (N + n)) ltac:(lia)).
    assert ((1 + r) / 2 * (C (S (N + n)) * D (S (N + n))) * u (S (N + n)) <= b * u (S (N + n)))
      by (apply Rmult_le_compat_r; lra). lra.
Qed.

(* --- the second condition ------------------------------------------------------------------------ *)

Let y n := - part (scenes n) (partner n).
Let eta n := part (scenes n) (spectator n).
Definition next_speed n := dot d (relative (scenes n) o (partner n)) (relative (scenes n) o (partner n)).
Let speed n := next_speed n / reach (partner n).
Lemma flown b n : part (arriving n) b =
  part (scenes n) b + tau n * (dot d (relative (scenes n) o b) (relative (scenes n) o b) / reach b).
Proof. unfold part, rate, arriving. rewrite to_later, relative_later, dot_linear. unfold Rdiv. ring. Qed.
Lemma path i j n : square d (scenes (S n)) i j = square d (scenes n) i j +
  2 * tau n * rate d (scenes n) i j + tau n * tau n * dot d (relative (scenes n) i j) (relative (scenes n) i j).
Proof.
  unfold square at 1. rewrite places. unfold arriving. rewrite to_later, square_of_combined.
  unfold square, rate. ring.
Qed.
Lemma speed_positive n : 0 <= speed n.
Proof. apply Rmult_le_pos; [apply dot_self | now apply Rlt_le, Rinv_0_lt_compat]. Qed.
Lemma slow n : speed n * tau n < y n.
Proof. pose proof (u_positive n) as U. unfold u in U. rewrite flown in U. unfold speed, next_speed, y. lra. Qed.
Lemma closes n : u n <= y n.
Proof.
  unfold u, y. rewrite flown. fold (next_speed n). fold (speed n). destruct (run n) as (T & _).
  assert (0 <= tau n * speed n); [|lra]. apply Rmult_le_pos; [lra | apply speed_positive].
Qed.
Lemma parts_at n : eta (S n) = r * u n.
Proof. unfold eta. rewrite next_spectator. apply recedes. Qed.
Lemma law n : y (S n) <= (1 + r) / 2 * (C n * D n) * u n - eta n.
Proof.
  unfold y. rewrite next_partner, pushed_together. destruct (run n) as (T & _).
  pose proof (part_rises (scenes n) (spectator n) _ (Rlt_le _ _ T)) as K. fold (arriving n) in K.
  unfold eta. lra.
Qed.
Lemma later_flight n : eta (S n) * tau (S n) <= y (S (S n)) * tau (S (S n)).
Proof.
  pose proof (path o (partner n) (S n)) as P. pose proof (path o (partner n) (S (S n))) as Q.
  pose proof (contact_square n) as E1. pose proof (contact_square (S (S n))) as E2.
  rewrite next_partner, next_spectator in E2.
  unfold eta, y, part. rewrite (next_partner (S n)), !next_spectator. pose proof (far (partner n)) as F.
  destruct (run (S n)) as (T1 & _). destruct (run (S (S n))) as (T2 & _).
  assert (Z : forall k, 0 <= tau k * tau k * dot d (relative (scenes k) o (partner n)) (relative (scenes k) o (partner n)))
    by (intros k; apply Rmult_le_pos; [apply Rle_0_sqr | apply dot_self]).
  pose proof (Z (S n)). pose proof (Z (S (S n))). apply Rmult_le_reg_r with (reach (partner n)); [exact F|].
  replace (rate d (scenes (S n)) o (partner n) / reach (partner n) * tau (S n) * reach (partner n)) with
    (rate d (scenes (S n)) o (partner n) * tau (S n)) by (field; lra).
  replace (- (rate d (scenes (S (S n))) o (partner n) / reach (partner n)) * tau (S (S n)) * reach (partner n)) with
    (- rate d (scenes (S (S n))) o (partner n) * tau (S (S n))) by (field; lra). lra.
Qed.

Let q n := eta n / y n.
Let sigma n := tau n / y n.
Section BelowThreshold.
Variable t : R.
Variable N : nat.
Hypothesis t_range : 0 < t <= 1.
Hypothesis t_cube : t * t * t < r.
Hypothesis bent : forall n, (n >= N)%nat -> (1 + r) / 2 * (C n * D n) <= t + t * t.
Let b := t + t * t.

Lemma y_positive n : 0 < y n. Proof. pose proof (u_positive n). pose proof (closes n). lra. Qed.
Lemma eta_positive n : 0 < eta (S n).
Proof. rewrite parts_at. pose proof (u_positive n). apply Rmult_lt_0_compat; lra. Qed.
Lemma tt_positive : 0 < t * t. Proof. apply Rmult_lt_0_compat; lra. Qed.
Lemma y_next n : (n >= N)%nat -> y (S n) <= b * u n - eta n.
Proof.
  intros L. pose proof (law n). specialize (bent n L). pose proof (u_positive n).
  assert ((1 + r) / 2 * (C n * D n) * u n <= b * u n) by (apply Rmult_le_compat_r; unfold b; lra). lra.
Qed.
Lemma room n : (S n >= N)%nat ->
  0 < b - q (S n) /\ y (S (S n)) <= (b - q (S n)) * y (S n) /\ r <= q (S (S n)) * (b - q (S n)).
Proof.
  intros L. pose proof (y_next (S n) L) as A. pose proof (y_positive (S n)) as Y1.
  pose proof (y_positive (S (S n))) as Y2. pose proof (closes (S n)) as K. pose proof (u_positive (S n)) as U.
  pose proof (eta_positive n) as E. pose proof tt_positive as TT.
  assert (b0 : 0 < b) by (unfold b; lra).
  assert (G : q (S n) * y (S n) = eta (S n)) by (unfold q; field; lra).
  assert (BU : b * u (S n) <= b * y (S n)) by (apply Rmult_le_compat_l; lra).
  assert (M : y (S (S n)) <= (b - q (S n)) * y (S n)) by lra.
  assert (P : 0 < b - q (S n)).
  { apply Rmult_lt_reg_r with (y (S n)); [exact Y1|]. lra. }
  repeat split; [exact P | exact M |].
  apply Rmult_le_reg_r with (y (S (S n))); [exact Y2|].
  replace (q (S (S n)) * (b - q (S n)) * y (S (S n))) with (eta (S (S n)) * (b - q (S n))) by (unfold q; field; lra).
  rewrite (parts_at (S n)).
  assert (Qp : 0 < q (S n)) by (unfold q; apply Rdiv_lt_0_compat; assumption).
  assert (QU : q (S n) * u (S n) <= q (S n) * y (S n)) by (apply Rmult_le_compat_l; lra).
  replace (r * u (S n) * (b - q (S n))) with (r * ((b - q (S n)) * u (S n))) by ring.
  apply Rmult_le_compat_l; lra.
Qed.
Lemma q_positive n : 0 < q (S n).
Proof. unfold q. apply Rdiv_lt_0_compat; [apply eta_positive | apply y_positive]. Qed.
(* q passes t^2 ... *)
Lemma passes : exists n, (S n >= N)%nat /\ t * t < q (S n).
Proof.
  pose proof tt_positive as TT.
  set (e := (r - t * t * t) / b). assert (b0 : 0 < b) by (unfold b; lra).
  assert (E : 0 < e) by (unfold e; apply Rdiv_lt_0_compat; lra).
  assert (S0 : forall m, (exists n, (S n >= N)%nat /\ t * t < q (S n)) \/ INR m * e <= q (S (N + m))).
  { induction m as [|m [IH|IH]]; [right; simpl; pose proof (q_positive (N + 0)); lra | left; exact IH |].
    destruct (Rlt_le_dec (t * t) (q (S (N + m)))) as [K|K]; [left; exists (N + m)%nat; split; [lia | exact K]|].
    right. destruct (room (N + m) ltac:(lia)) as (P & _ & Q1). rewrite S_INR.
    replace (N + S m)%nat with (S (N + m)) by lia. pose proof (q_positive (N + m)) as Qp.
    assert (q (S (N + m)) + e <= q (S (S (N + m)))); [|lra].
    apply Rmult_le_reg_r with (b - q (S (N + m))); [exact P|]. apply Rle_trans with (2 := Q1).
    assert (W : e * b = r - t * t * t) by (unfold e; field; lra).
    set (z := q (S (N + m))) in *.
    assert (t * t <= t) by (apply Rle_trans with (t * 1); [apply Rmult_le_compat_l|]; lra).
    assert (V1 : 0 <= (t * t - z) * (t - z)) by (apply Rmult_le_pos; lra).
    assert (V2 : 0 <= e * z) by (apply Rmult_le_pos; lra).
    replace ((z + e) * (b - z)) with (t * t * t - (t * t - z) * (t - z) + (e * b - e * z)) by (unfold b; ring).
    lra. }
  destruct (archimed_cor1 (e / (2 * (t * t)))) as (m & M1 & M2); [apply Rdiv_lt_0_compat; lra|].
  assert (Mp : 0 < INR m) by (apply lt_0_INR; exact M2).
  destruct (S0 m) as [K|K]; [exact K|]. exists (N + m)%nat. split; [lia|].
  assert (2 * (t * t) < INR m * e); [|lra].
  apply Rmult_lt_reg_r with (/ INR m / (2 * (t * t))).
  { apply Rdiv_lt_0_compat; [now apply Rinv_0_lt_compat | lra]. }
  replace (2 * (t * t) * (/ INR m / (2 * (t * t)))) with (/ INR m) by (field; repeat split; lra).
  replace (INR m * e * (/ INR m / (2 * (t * t)))) with (e / (2 * (t * t))) by (field; repeat split; lra). exact M1.
Qed.
(* ... and then stays above r/t, while sigma grows. *)
Lemma slows_down : Un_cv speed 0.
Proof.
  destruct passes as (n0 & L0 & K0). pose proof tt_positive as TT.
  assert (t0 : 0 < t) by lra.
  assert (UP : forall n, (S n >= N)%nat -> t * t < q (S n) -> r <= q (S (S n)) * t).
  { intros n L K. destruct (room n L) as (P & _ & Q1). pose proof (q_positive (S n)) as Qp.
    assert (b - q (S n) < t) by (unfold b; lra).
    apply Rle_trans with (1 := Q1). apply Rmult_le_compat_l; lra. }
  assert (OVER : forall z, r <= z * t -> t * t < z).
  { intros z Z. apply Rmult_lt_reg_r with t; [exact t0 | lra]. }
  assert (ST : forall m, r <= q (S (S (n0 + m))) * t).
  { induction m as [|m IH]; [rewrite Nat.add_0_r; now apply UP|].
    replace (n0 + S m)%nat with (S (n0 + m)) by lia. apply UP; [lia|]. apply OVER, IH. }
  set (g := r / (t * t * t)).
  assert (ttt : 0 < t * t * t) by (repeat apply Rmult_lt_0_compat; exact t0).
  assert (g1 : 1 < g).
  { apply Rmult_lt_reg_r with (t * t * t); [exact ttt|].
    replace (g * (t * t * t)) with r by (unfold g; field; lra). lra. }
  assert (GR : forall m, g * sigma (S (S (n0 + m))) <= sigma (S (S (n0 + S m)))).
  { intros m. set (n := S (n0 + m)). replace (S (S (n0 + S m))) with (S (S n)) by (unfold n; lia).
    replace (S (S (n0 + m))) with (S n) by reflexivity.
    destruct (room n ltac:(unfold n; lia)) as (P & Y & _). pose proof (ST m) as Q1. fold n in Q1.
    pose proof (later_flight n) as LT. pose proof (y_positive (S n)) as Y1. pose proof (y_positive (S (S n))) as Y2.
    destruct (run (S n)) as (T1 & _). destruct (run (S (S n))) as (T2 & _).
    pose proof (q_positive n) as Qp. set (z := q (S n)) in *.
    assert (G : eta (S n) = z * y (S n)) by (unfold z, q; field; lra). rewrite G in LT.
    assert (tz : t * t < z) by (apply OVER; exact Q1). assert (bt : b - z < t) by (unfold b; lra).
    assert (H : g * ((b - z) * (b - z)) <= z).
    { apply Rmult_le_reg_r with (t * t * t); [exact ttt|].
      replace (g * ((b - z) * (b - z)) * (t * t * t)) with (r * ((b - z) * (b - z))) by (unfold g; field; lra).
      apply Rle_trans with (r * (t * t)); [apply Rmult_le_compat_l; [lra|]; apply Rmult_le_compat; lra|].
      replace (z * (t * t * t)) with (z * t * (t * t)) by ring. apply Rmult_le_compat_r; lra. }
    unfold sigma. apply Rmult_le_reg_r with (y (S n) * (y (S (S n)) * y (S (S n)))).
    { repeat apply Rmult_lt_0_compat; assumption. }
    replace (g * (tau (S n) / y (S n)) * (y (S n) * (y (S (S n)) * y (S (S n)))))
      with (g * (y (S (S n)) * y (S (S n))) * tau (S n)) by (field; lra).
    replace (tau (S (S n)) / y (S (S n)) * (y (S n) * (y (S (S n)) * y (S (S n)))))
      with (y (S (S n)) * tau (S (S n)) * y (S n)) by (field; lra).
    apply Rle_trans with (z * y (S n) * tau (S n) * y (S n)); [|apply Rmult_le_compat_r; lra].
    assert (W : y (S (S n)) * y (S (S n)) <= (b - z) * y (S n) * ((b - z) * y (S n)))
      by (apply Rmult_le_compat; lra).
    assert (W' : g * (y (S (S n)) * y (S (S n))) <= z * (y (S n) * y (S n))).
    { apply Rle_trans with (g * ((b - z) * y (S n) * ((b - z) * y (S n)))); [apply Rmult_le_compat_l; lra|].
      replace (g * ((b - z) * y (S n) * ((b - z) * y (S n))))
        with (g * ((b - z) * (b - z)) * (y (S n) * y (S n))) by ring.
      apply Rmult_le_compat_r; [apply Rle_0_sqr | exact H]. }
    replace (z * y (S n) * tau (S n) * y (S n)) with (z * (y (S n) * y (S n)) * tau (S n)) by ring.
    apply Rmult_le_compat_r; lra. }
  set (s0 := sigma (S (S n0))).
  assert (s0p : 0 < s0) by (unfold s0, sigma; apply Rdiv_lt_0_compat; [apply (run (S (S n0))) | apply y_positive]).
  assert (ALL : forall m, g ^ m * s0 <= sigma (S (S (n0 + m)))).
  { induction m as [|m IH]; [simpl; rewrite Nat.add_0_r; unfold s0; lra|].
    apply Rle_trans with (2 := GR m). simpl. rewrite Rmult_assoc. apply Rmult_le_compat_l; lra. }
  intros e E. assert (es : 0 < e * s0) by (apply Rmult_lt_0_compat; lra).
  destruct (Pow_x_infinity g ltac:(rewrite Rabs_right; lra) (/ (e * s0))) as (M & HM).
  exists (S (S (n0 + M))). intros n L. replace n with (S (S (n0 + (n - n0 - 2)))) by lia.
  set (m := (n - n0 - 2)%nat).
  specialize (HM m ltac:(unfold m; lia)). specialize (ALL m).
  rewrite Rabs_right in HM by (apply Rle_ge, pow_le; lra).
  pose proof (slow (S (S (n0 + m)))) as SL. pose proof (y_positive (S (S (n0 + m)))) as Y.
  pose proof (speed_positive (S (S (n0 + m)))) as SP.
  unfold R_dist. rewrite Rminus_0_r, Rabs_right by lra.
  assert (B1' : speed (S (S (n0 + m))) * sigma (S (S (n0 + m))) < 1).
  { unfold sigma. apply Rmult_lt_reg_r with (y (S (S (n0 + m)))); [exact Y|].
    replace (speed (S (S (n0 + m))) * (tau (S (S (n0 + m))) / y (S (S (n0 + m)))) * y (S (S (n0 + m))))
      with (speed (S (S (n0 + m))) * tau (S (S (n0 + m)))) by (field; lra). lra. }
  assert (F : 1 <= g ^ m * s0 * e).
  { apply Rmult_le_reg_r with (/ (e * s0)); [now apply Rinv_0_lt_compat|].
    replace (g ^ m * s0 * e * / (e * s0)) with (g ^ m) by (field; lra). lra. }
  assert (F2 : g ^ m * s0 * e <= sigma (S (S (n0 + m))) * e) by (apply Rmult_le_compat_r; lra).
  assert (SG : 0 < sigma (S (S (n0 + m)))).
  { unfold sigma. apply Rdiv_lt_0_compat; [apply (run (S (S (n0 + m)))) | exact Y]. }
  apply Rmult_lt_reg_r with (sigma (S (S (n0 + m)))); [exact SG | lra].
Qed.
Lemma stops_below : Un_cv next_speed 0.
Proof.
  set (most := reach a + reach c). pose proof (far a). pose proof (far c). assert (M : 0 < most) by (unfold most; lra).
  intros e E. destruct (slows_down (e / most)) as (K & L); [now apply Rdiv_lt_0_compat|]. exists K. intros n G.
  specialize (L n G). pose proof (speed_positive n) as P. unfold R_dist in *. rewrite Rminus_0_r, Rabs_right in * by lra.
  assert (S : next_speed n = speed n * reach (partner n)) by (unfold speed; pose proof (far (partner n)); field; lra).
  assert (B : reach (partner n) <= most) by (unfold most, partner; destruct (Nat.even n); lra).
  assert (Q : speed n * reach (partner n) <= speed n * most) by (apply Rmult_le_compat_l; lra).
  assert (W : speed n * most < e).
  { apply Rmult_lt_reg_r with (/ most); [now apply Rinv_0_lt_compat|]. rewrite Rmult_assoc, Rinv_r, Rmult_1_r by lra. exact L. }
  assert (0 <= next_speed n) by apply dot_self. rewrite Rabs_right; lra.
Qed.
End BelowThreshold.

Theorem second_condition s : 0 < s -> s * s * s = r -> 2 * (s + s * s) / (1 + r) <= C0 \/ Un_cv next_speed 0.
Proof.
  intros s_positive s3.
  destruct (Rle_lt_dec (2 * (s + s * s) / (1 + r)) C0) as [K|K]; [left; exact K | right].
  apply below_threshold in K. rename K into B.
  assert (ss : 0 < s * s) by (apply Rmult_lt_0_compat; lra).
  assert (s1 : s <= 1).
  { destruct (Rle_lt_dec s 1) as [W|W]; [exact W|].
    assert (1 * 1 < s * s) by (apply Rmult_le_0_lt_compat; lra).
    assert (1 * 1 < s * s * s) by (apply Rmult_le_0_lt_compat; lra). lra. }
  set (gap := s + s * s - (1 + r) / 2 * C0). assert (G : 0 < gap) by (unfold gap; lra).
  set (t := Rmax (s / 2) (s - gap / 6)).
  assert (T1 : s / 2 <= t) by apply Rmax_l. assert (T2 : s - gap / 6 <= t) by apply Rmax_r.
  assert (T3 : t < s) by (unfold t; apply Rmax_lub_lt; lra).
  assert (T4 : (1 + r) / 2 * C0 < t + t * t).
  { assert (s + s * s - (t + t * t) <= gap / 2); [|unfold gap in *; lra].
    replace (s + s * s - (t + t * t)) with ((s - t) * (1 + s + t)) by ring.
    apply Rle_trans with ((s - t) * 3); [apply Rmult_le_compat_l; lra | lra]. }
  destruct (factor_below _ T4) as (N & H).
  apply (stops_below t N); [lra | | exact H].
  rewrite <- s3. assert (t * t < s * s) by (apply Rmult_le_0_lt_compat; lra).
  apply Rmult_le_0_lt_compat; try lra. apply Rlt_le, Rmult_lt_0_compat; lra.
Qed.
End OneByOne.
