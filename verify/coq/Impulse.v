(* Any number of balls, of any masses and contact distances: the momentum that they exchange in all
   collisions is bounded, so that velocities converge; the angular momentum is kept. Then the same in the frame
   of the centre of mass. Last, balls that come to rest. *)
From Coq Require Import Reals Arith Lra Lia FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Sequences Bounds Weights.
Open Scope R_scope.
Set Default Proof Using "All".

Section Impulses.
Variable d : nat.
Variable last : nat.  (* the balls are 0, ..., last *)
Variable mass : nat -> R.
Variable sigma : nat -> nat -> R.  (* the distances of contact *)
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis far : forall a b, 0 < sigma a b.

Notation opening := (opening d).
Notation many_collide := (many_collide d last mass sigma).
Notation weighted := (weighted last mass).
Notation turning := (turning last mass).
Notation centred := (centred last mass).
Notation pairs := (pairs d).
Notation virial := (virial d last mass).
Notation inertia := (inertia d last mass).
Let inertia_positive := inertia_positive d last mass heavy.
Let inertia_flown := inertia_flown d last mass heavy.
Let virial_flown := virial_flown d last mass heavy.
Let turning_flown := turning_flown d last mass heavy.
Let product_bounded := product_bounded d last mass heavy.
Let turning_bounded := turning_bounded d last mass heavy.
Let pairs_positive := pairs_positive d last mass heavy.
Let centred_flown := centred_flown d last mass heavy.
Let centred_between := centred_between d last mass heavy.
Let centred_opening := centred_opening d last mass heavy.

(* --- all collisions --------------------------------------------------------------------------------- *)

Section Run.
Variables x v : nat -> nat -> vector.
Variable t : nat -> R.
Variables i j : nat -> nat.
Variable J : nat -> R.
Hypothesis run : many_collide x v t i j J.
Let e n := between (x (S n)) (i n) (j n).
Let s n := sigma (i n) (j n).

Lemma velocity_i n : v (S n) (i n) = combined 1 (v n (i n)) (- (J n / mass (i n) / s n)) (e n).
Proof.
  destruct (run n) as (_ & _ & _ & _ & _ & V & _). apply same_vector. intros k. rewrite V. unfold combined, e, s, Rdiv. ring.
Qed.
Lemma velocity_j n : v (S n) (j n) = combined 1 (v n (j n)) (J n / mass (j n) / s n) (e n).
Proof.
  destruct (run n) as (_ & _ & _ & _ & _ & _ & V & _). apply same_vector. intros k. rewrite V. unfold combined, e, s, Rdiv. ring.
Qed.
Lemma from_places n : e n = combined 1 (x (S n) (j n)) (-1) (x (S n) (i n)).
Proof. apply same_vector. intros k. unfold e, between, combined. ring. Qed.
Lemma contact n : dot d (e n) (e n) = s n * s n.
Proof. apply (run n). Qed.
Lemma s_positive n : 0 < s n.
Proof. apply far. Qed.
Lemma parting n : opening (x (S n)) (v (S n)) (i n) (j n) =
  opening (x (S n)) (v n) (i n) (j n) + J n * (/ mass (i n) + / mass (j n)) * s n.
Proof.
  unfold Bounds.opening. fold (e n).
  assert (F : between (v (S n)) (i n) (j n) =
    combined 1 (between (v n) (i n) (j n)) (J n * (/ mass (i n) + / mass (j n)) / s n) (e n)).
  { apply same_vector. intros k. unfold between at 1. rewrite velocity_i, velocity_j.
    unfold combined, between, Rdiv. ring. }
  rewrite F, dot_linear_right, contact. field. pose proof (s_positive n). pose proof (heavy (i n)). pose proof (heavy (j n)).
  repeat split; lra.
Qed.
Lemma changes (f : nat -> vector -> R) n : sum_f_R0 (fun b => f b (v (S n) b)) last =
  sum_f_R0 (fun b => f b (v n b)) last + (f (i n) (v (S n) (i n)) - f (i n) (v n (i n))) +
    (f (j n) (v (S n) (j n)) - f (j n) (v n (j n))).
Proof.
  destruct (run n) as ((I & L & N) & _ & _ & _ & _ & _ & _ & O & _).
  apply (sum_but_two (fun b => f b (v (S n) b)) (fun b => f b (v n b))); trivial.
  intros b A B. now rewrite O.
Qed.
Lemma virial_next n : virial (x (S n)) (v (S n)) = virial (x n) (v n) + t n * inertia (v n) + s n * J n.
Proof.
  destruct (run n) as (_ & _ & X & _). rewrite <- virial_flown, <- X. unfold Weights.virial, product.
  rewrite (changes (fun b w => mass b * dot d (x (S n) b) w)), velocity_i, velocity_j, !dot_linear_right.
  assert (E : dot d (x (S n) (j n)) (e n) - dot d (x (S n) (i n)) (e n) = s n * s n).
  { rewrite <- contact. rewrite (from_places n) at 3. rewrite dot_linear. ring. }
  pose proof (s_positive n). pose proof (heavy (i n)). pose proof (heavy (j n)).
  replace (dot d (x (S n) (j n)) (e n)) with (s n * s n + dot d (x (S n) (i n)) (e n)) by lra. field. repeat split; lra.
Qed.
Lemma energy_next n : inertia (v (S n)) <= inertia (v n).
Proof.
  destruct (run n) as (_ & _ & _ & _ & P & _ & _ & _ & _ & Q). pose proof (parting n) as W.
  unfold Weights.inertia, Weights.virial, product. rewrite (changes (fun b w => mass b * dot d w w)), velocity_i, velocity_j, !square_of_combined.
  rewrite contact. pose proof (s_positive n) as S0. pose proof (heavy (i n)) as M1. pose proof (heavy (j n)) as M2.
  assert (E : opening (x (S n)) (v n) (i n) (j n) = dot d (v n (j n)) (e n) - dot d (v n (i n)) (e n)).
  { unfold Bounds.opening. fold (e n). rewrite (dot_symmetric d (e n)).
    replace (between (v n) (i n) (j n)) with (combined 1 (v n (j n)) (-1) (v n (i n)))
      by (apply same_vector; intros k; unfold between, combined; ring).
    rewrite dot_linear. ring. }
  assert (G : J n / s n * (opening (x (S n)) (v n) (i n) (j n) + opening (x (S n)) (v (S n)) (i n) (j n)) <= 0).
  { assert (0 <= J n / s n) by (apply Rmult_le_pos; [exact P | now apply Rlt_le, Rinv_0_lt_compat]).
    assert (0 <= J n / s n * - (opening (x (S n)) (v n) (i n) (j n) + opening (x (S n)) (v (S n)) (i n) (j n)))
      by (apply Rmult_le_pos; lra). lra. }
  rewrite W, E in G. apply Rminus_le. apply Rle_trans with (2 := G). right. field. repeat split; lra.
Qed.
Lemma weighted_next n k : weighted (v (S n)) k = weighted (v n) k.
Proof.
  unfold Bounds.weighted. rewrite (changes (fun b w => mass b * w k)), velocity_i, velocity_j. unfold combined.
  pose proof (s_positive n). pose proof (heavy (i n)). pose proof (heavy (j n)). field. repeat split; lra.
Qed.
Lemma turning_next n k l : turning (x (S n)) (v (S n)) k l = turning (x n) (v n) k l.
Proof.
  destruct (run n) as (_ & _ & X & _). rewrite <- (turning_flown (t n) (x n)), <- X. unfold Bounds.turning.
  rewrite (changes (fun b w => mass b * (x (S n) b k * w l - x (S n) b l * w k))), velocity_i, velocity_j.
  unfold combined, e, between. pose proof (s_positive n). pose proof (heavy (i n)). pose proof (heavy (j n)).
  field. repeat split; lra.
Qed.
Lemma turning_kept n k l : turning (x n) (v n) k l = turning (x 0%nat) (v 0%nat) k l.
Proof. induction n as [|n IH]; [reflexivity | now rewrite turning_next]. Qed.

(* --- the momentum exchanged ------------------------------------------------------------------------ *)

Let Z n := sqrt (inertia (x n)).
Let E n := sqrt (inertia (v n)).
Lemma R_square n : Z n * Z n = inertia (x n). Proof. apply sqrt_sqrt, inertia_positive. Qed.
Lemma E_square n : E n * E n = inertia (v n). Proof. apply sqrt_sqrt, inertia_positive. Qed.
Lemma E_next n : E (S n) <= E n. Proof. apply sqrt_le_1_alt, energy_next. Qed.
Lemma virial_bounded n : virial (x n) (v n) <= Z n * E n.
Proof.
  pose proof (product_bounded (x n) (v n)) as C. rewrite <- R_square, <- E_square in C.
  assert (0 <= Z n * E n) by (apply Rmult_le_pos; apply sqrt_pos). apply Rnot_lt_le. intros L.
  assert (Z n * E n * (Z n * E n) < virial (x n) (v n) * virial (x n) (v n)) by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.
Lemma R_next n : Z (S n) <= Z n + t n * E n.
Proof.
  destruct (run n) as (_ & T & X & _). pose proof (virial_bounded n) as B.
  assert (0 <= Z n) by apply sqrt_pos. assert (0 <= E n) by apply sqrt_pos. assert (0 <= t n * E n) by now apply Rmult_le_pos.
  apply root_at_most; [lra|]. rewrite X, inertia_flown, <- R_square, <- E_square.
  assert (2 * t n * virial (x n) (v n) <= 2 * t n * (Z n * E n)) by (apply Rmult_le_compat_l; lra). lra.
Qed.
(* R is at most P, the first R and the integral of E; I is that of its square. *)
Fixpoint P (n : nat) : R := match n with O => Z O | S m => P m + t m * E m end.
Fixpoint I (n : nat) : R := match n with O => 0 | S m => I m + t m * (E m * E m) end.
Fixpoint exchanged (n : nat) : R := match n with O => 0 | S m => exchanged m + s m * J m end.
Lemma bounds n : Z n <= P n /\ Z 0%nat <= P n /\ P n * E n <= Z 0%nat * E n + I n /\
  virial (x n) (v n) = virial (x 0%nat) (v 0%nat) + I n + exchanged n.
Proof.
  induction n as [|n (A & B & C & D)]; [cbn; repeat split; lra|].
  destruct (run n) as (_ & T & _). pose proof (R_next n) as N. pose proof (E_next n) as F.
  assert (E0 : 0 <= E n) by apply sqrt_pos. assert (E1 : 0 <= E (S n)) by apply sqrt_pos.
  assert (TE : 0 <= t n * E n) by now apply Rmult_le_pos. cbn [P I exchanged].
  split; [lra|]. split; [lra|]. split.
  - assert ((P n - Z 0%nat) * E (S n) <= (P n - Z 0%nat) * E n) by (apply Rmult_le_compat_l; lra).
    assert (t n * E n * E (S n) <= t n * E n * E n) by (apply Rmult_le_compat_l; lra). lra.
  - rewrite virial_next, D, E_square. lra.
Qed.
Lemma E_falls n : E n <= E 0%nat.
Proof. induction n as [|n IH]; [lra|]. pose proof (E_next n). lra. Qed.
Theorem exchanged_bounded n : exchanged n <= Z 0%nat * E 0%nat - virial (x 0%nat) (v 0%nat).
Proof.
  destruct (bounds n) as (A & B & C & D). pose proof (virial_bounded n) as V.
  assert (E0 : 0 <= E n) by apply sqrt_pos. assert (R0 : 0 <= Z 0%nat) by apply sqrt_pos.
  assert (Z n * E n <= P n * E n) by (apply Rmult_le_compat_r; lra).
  assert (Z 0%nat * E n <= Z 0%nat * E 0%nat) by (apply Rmult_le_compat_l; [exact R0 | apply E_falls]). lra.
Qed.
Lemma exchanged_is n : sum_f_R0 (fun m => s m * J m) n = exchanged (S n).
Proof. induction n as [|n IH]; cbn [sum_f_R0]; [cbn; ring|]. rewrite IH. reflexivity. Qed.
Lemma J_positive n : 0 <= J n. Proof. apply (run n). Qed.
Lemma least_contact : exists m, 0 < m /\ forall n, m <= s n.
Proof.
  assert (H : forall a, exists m, 0 < m /\ forall b, (b <= last)%nat -> m <= sigma a b) by (intros a; now apply least_of).
  assert (K : forall c, exists m, 0 < m /\ forall a b, (a <= c)%nat -> (b <= last)%nat -> m <= sigma a b).
  { induction c as [|c (m & M & L)].
    - destruct (H O) as (m & M & L). exists m. split; [exact M|]. intros a b A B. replace a with O by lia. now apply L.
    - destruct (H (S c)) as (m' & M' & L'). exists (Rmin m m'). split; [now apply Rmin_glb_lt|]. intros a b A B.
      destruct (Nat.eq_dec a (S c)) as [->|N]; [apply Rle_trans with m'; [apply Rmin_r | now apply L']|].
      apply Rle_trans with m; [apply Rmin_l | apply L; lia]. }
  destruct (K last) as (m & M & L). exists m. split; [exact M|]. intros n. destruct (run n) as ((A & B & _) & _). now apply L.
Qed.
Theorem impulses_bounded : exists bound, forall n, sum_f_R0 J n <= bound.
Proof.
  destruct least_contact as (m & M & L). exists ((Z 0%nat * E 0%nat - virial (x 0%nat) (v 0%nat)) / m). intros n.
  apply Rmult_le_reg_l with m; [exact M|].
  replace (m * ((Z 0%nat * E 0%nat - virial (x 0%nat) (v 0%nat)) / m)) with (Z 0%nat * E 0%nat - virial (x 0%nat) (v 0%nat)) by (field; lra).
  apply Rle_trans with (2 := exchanged_bounded (S n)). rewrite <- exchanged_is, <- sum_times. apply sum_Rle. intros k _.
  apply Rmult_le_compat_r; [apply J_positive | apply L].
Qed.
Lemma unit_at_most n k : (k < d)%nat -> Rabs (e n k / s n) <= 1.
Proof.
  intros K. pose proof (s_positive n) as S0. pose proof (coordinate_at_most d (e n) k K) as C. rewrite contact in C.
  unfold Rdiv. rewrite Rabs_mult, (Rabs_right (/ s n)) by (apply Rle_ge, Rlt_le, Rinv_0_lt_compat; exact S0).
  apply Rmult_le_reg_r with (s n); [exact S0|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_1_l by lra.
  rewrite <- (Rabs_right (s n)) by lra. apply Rsqr_le_abs_0. exact C.
Qed.
Lemma velocity_moves n b k : (k < d)%nat -> Rabs (v (S n) b k - v n b k) <= J n / mass b.
Proof.
  intros K. pose proof (unit_at_most n k K) as U. pose proof (heavy b) as M. pose proof (J_positive n) as Jn.
  assert (Q : 0 <= J n / mass b) by (apply Rmult_le_pos; [exact Jn | now apply Rlt_le, Rinv_0_lt_compat]).
  assert (W : Rabs (J n / mass b * (e n k / s n)) <= J n / mass b).
  { rewrite Rabs_mult, (Rabs_right (J n / mass b)) by lra. rewrite <- (Rmult_1_r (J n / mass b)) at 2. now apply Rmult_le_compat_l. }
  destruct (run n) as (_ & _ & _ & _ & _ & VI & VJ & VO & _). fold (e n) (s n) in VI, VJ.
  destruct (Nat.eq_dec b (i n)) as [->|Ni].
  - rewrite VI. replace (v n (i n) k - J n / mass (i n) * (e n k / s n) - v n (i n) k) with
      (- (J n / mass (i n) * (e n k / s n))) by ring. now rewrite Rabs_Ropp.
  - destruct (Nat.eq_dec b (j n)) as [->|Nj].
    + rewrite VJ. replace (v n (j n) k + J n / mass (j n) * (e n k / s n) - v n (j n) k) with
        (J n / mass (j n) * (e n k / s n)) by ring. exact W.
    + rewrite VO by assumption. rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. exact Q.
Qed.
Theorem velocities_converge b k : (k < d)%nat -> exists l, Un_cv (fun n => v n b k) l.
Proof.
  intros K. destruct impulses_bounded as (B & L). pose proof (heavy b) as M.
  set (w := fix w n := match n with O => 0 | S m => w m + J m / mass b end).
  apply (bounded_variation_converges _ w (Rmax 0 (B / mass b))).
  - intros n. cbn [w]. pose proof (within _ _ (velocity_moves n b k K)). fold (w n). lra.
  - intros n. cbn [w]. pose proof (within _ _ (velocity_moves n b k K)). fold (w n). lra.
  - assert (W : forall n, w (S n) = sum_f_R0 J n / mass b).
    { induction n as [|n IH]; cbn [sum_f_R0].
      - change (w 1%nat) with (0 + J O / mass b). ring.
      - change (w (S (S n))) with (w (S n) + J (S n) / mass b). rewrite IH. unfold Rdiv. ring. }
    intros [|n]; [apply Rmax_l|]. rewrite W. apply Rle_trans with (2 := Rmax_r _ _). unfold Rdiv.
    apply Rmult_le_compat_r; [now apply Rlt_le, Rinv_0_lt_compat | apply L].
Qed.
(* The speeds at which pairs meet. *)
Theorem speeds_summable :
  exists bound, forall n, sum_f_R0 (fun m => - opening (x (S m)) (v m) (i m) (j m) / s m) n <= bound.
Proof.
  destruct (least_of mass last heavy) as (m & M & L). destruct impulses_bounded as (B & H). exists (2 / m * B). intros n.
  apply Rle_trans with (2 / m * sum_f_R0 J n).
  - rewrite <- sum_times. apply sum_Rle. intros k _. pose proof (parting k) as W. pose proof (s_positive k) as S0.
    destruct (run k) as ((A & C & _) & _ & _ & _ & Jk & _ & _ & _ & _ & Q). fold (e k) in W.
    assert (F : forall b, (b <= last)%nat -> / mass b <= / m) by (intros b b'; apply Rinv_le_contravar; [exact M | now apply L]).
    pose proof (F _ A). pose proof (F _ C).
    apply Rmult_le_reg_r with (s k); [exact S0|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    apply Rle_trans with (J k * (/ mass (i k) + / mass (j k)) * s k); [lra|].
    apply Rmult_le_compat_r; [lra|]. replace (2 * / m * J k) with (J k * (/ m + / m)) by ring. apply Rmult_le_compat_l; lra.
  - apply Rmult_le_compat_l; [|apply H]. apply Rlt_le, Rdiv_lt_0_compat; lra.
Qed.

(* --- balls that come to rest ------------------------------------------------------------------------ *)

(* If the energy tends to 0, then the balls never recede from the origin, and places converge. *)
Section AtRest.
Hypothesis rests : Un_cv (fun n => inertia (v n)) 0.
Lemma flight_positive n : 0 <= t n. Proof. apply (run n). Qed.
Lemma slower n m : (n <= m)%nat -> inertia (v m) <= inertia (v n).
Proof. intros L. induction L as [|m L IH]; [lra|]. pose proof (energy_next m). lra. Qed.
Lemma energy_positive n : 0 <= inertia (v n). Proof. apply inertia_positive. Qed.
Lemma pushed_apart n : 0 <= s n * J n.
Proof. apply Rmult_le_pos; [apply Rlt_le, s_positive | apply J_positive]. Qed.
Lemma virial_rises n : virial (x n) (v n) + t n * inertia (v n) <= virial (x (S n)) (v (S n)).
Proof. rewrite virial_next. pose proof (pushed_apart n). lra. Qed.
Lemma inertia_next n : inertia (x (S n)) =
  inertia (x n) + 2 * t n * virial (x n) (v n) + t n * t n * inertia (v n).
Proof. destruct (run n) as (_ & _ & X & _). rewrite X. apply inertia_flown. Qed.
Lemma virial_square n : virial (x n) (v n) * virial (x n) (v n) <= inertia (x n) * inertia (v n).
Proof.
  pose proof (product_bounded (x n) (v n)) as C. lra.
Qed.
Theorem never_recedes n : virial (x n) (v n) <= 0.
Proof.
  apply Rnot_lt_le. intros P. set (A m := virial (x (n + m)%nat) (v (n + m)%nat)).
  set (Q m := inertia (x (n + m)%nat)). set (W m := inertia (v (n + m)%nat)).
  assert (C : forall m, A m * A m <= Q m * W m) by (intros m; apply virial_square).
  assert (W0 : forall m, 0 <= W m) by (intros m; apply energy_positive).
  assert (Q0 : forall m, 0 <= Q m) by (intros m; apply inertia_positive).
  assert (N : forall m, A m + t (n + m)%nat * W m <= A (S m) /\
    Q (S m) = Q m + 2 * t (n + m)%nat * A m + t (n + m)%nat * t (n + m)%nat * W m).
  { intros m. unfold A, Q, W. rewrite Nat.add_succ_r. split; [apply virial_rises | apply inertia_next]. }
  assert (A0 : forall m, 0 < A m).
  { induction m as [|m IH]; [unfold A; now rewrite Nat.add_0_r|]. destruct (N m) as [G _].
    assert (0 <= t (n + m)%nat * W m) by (apply Rmult_le_pos; [apply flight_positive | apply W0]). lra. }
  assert (Qp : forall m, 0 < Q m).
  { intros m. destruct (Rle_lt_or_eq_dec _ _ (Q0 m)) as [K|K]; [exact K|]. specialize (C m). rewrite <- K, Rmult_0_l in C.
    pose proof (Rmult_lt_0_compat _ _ (A0 m) (A0 m)). lra. }
  (* The square of the virial over the moment of inertia does not fall. *)
  set (share := A O * A O / Q O).
  assert (SP : 0 < share) by (apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat | apply Qp]).
  assert (SH : forall m, share * Q m <= A m * A m).
  { induction m as [|m IH]; [unfold share; right; field; apply Rgt_not_eq, Qp|].
    destruct (N m) as [G EQ]. pose proof (A0 m) as Am. pose proof (Qp m) as Qm. pose proof (Qp (S m)).
    pose proof (flight_positive (n + m)) as T. set (f := t (n + m)%nat) in *. specialize (C m). specialize (W0 m).
    assert (0 <= f * W m) by now apply Rmult_le_pos.
    apply Rmult_le_reg_r with (Q m); [exact Qm|].
    apply Rle_trans with ((A m + f * W m) * (A m + f * W m) * Q m).
    - replace (share * Q (S m) * Q m) with (share * Q m * Q (S m)) by ring.
      apply Rle_trans with (A m * A m * Q (S m)); [apply Rmult_le_compat_r; lra|]. rewrite EQ.
      assert (0 <= 2 * f * A m * (Q m * W m - A m * A m)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | lra]).
      assert (0 <= f * f * W m * (Q m * W m - A m * A m)) by (apply Rmult_le_pos; [apply Rmult_le_pos; [apply Rle_0_sqr | exact W0] | lra]).
      lra.
    - apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat; lra. }
  destruct (rests share SP) as (M & L). specialize (L (n + M)%nat ltac:(lia)). fold (W M) in L.
  unfold R_dist in L. rewrite Rminus_0_r, Rabs_right in L by (apply Rle_ge, W0).
  specialize (SH M). specialize (C M). pose proof (Qp M) as Qm.
  assert (Q M * W M < Q M * share) by (apply Rmult_lt_compat_l; lra). lra.
Qed.
Theorem shrinks n : inertia (x (S n)) <= inertia (x n).
Proof.
  rewrite inertia_next. pose proof (virial_rises n) as V. pose proof (never_recedes (S n)) as G. pose proof (never_recedes n) as G'.
  pose proof (flight_positive n) as T.
  assert (t n * (virial (x n) (v n) + t n * inertia (v n)) <= t n * 0) by (apply Rmult_le_compat_l; lra).
  assert (t n * virial (x n) (v n) <= t n * 0) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma velocity_rests b k : (b <= last)%nat -> (k < d)%nat -> Un_cv (fun n => v n b k) 0.
Proof.
  intros B K e' E'. pose proof (heavy b) as M. destruct (rests (mass b * (e' * e'))) as (N & L).
  { apply Rmult_lt_0_compat; [exact M | now apply Rmult_lt_0_compat]. }
  exists N. intros n G. specialize (L n G). unfold R_dist in *. rewrite Rminus_0_r in *.
  rewrite Rabs_right in L by (apply Rle_ge, energy_positive).
  assert (D : mass b * dot d (v n b) (v n b) <= inertia (v n)).
  { unfold Weights.inertia, Weights.virial, product. rewrite (sum_but_one _ (fun c => if Nat.eq_dec c b then 0 else mass c * dot d (v n c) (v n c)) b).
    - destruct (le_dec b last) as [_|]; [|lia]. destruct (Nat.eq_dec b b); [|easy].
      assert (0 <= sum_f_R0 (fun c => if Nat.eq_dec c b then 0 else mass c * dot d (v n c) (v n c)) last); [|lra].
      apply cond_pos_sum. intros c. destruct (Nat.eq_dec c b); [lra|]. pose proof (heavy c). apply Rmult_le_pos; [lra | apply dot_self].
    - intros c C. now destruct (Nat.eq_dec c b). }
  pose proof (coordinate_at_most d (v n b) k K) as C. rewrite <- (Rabs_right e') by lra. apply Rsqr_lt_abs_0. unfold Rsqr.
  apply Rmult_lt_reg_l with (mass b); [exact M|].
  assert (mass b * (v n b k * v n b k) <= mass b * dot d (v n b) (v n b)) by (apply Rmult_le_compat_l; lra). lra.
Qed.
(* What a coordinate of a velocity is, the virial still has to make up for. *)
Lemma velocity_made_up b k : (b <= last)%nat -> (k < d)%nat -> exists c, 0 < c /\ forall n,
  Rabs (v n b k) <= - c * (virial (x n) (v n) + t n * inertia (v n)).
Proof.
  intros B K. destruct least_contact as (m & M & LM). pose proof (heavy b) as Mb.
  set (c := / (mass b * m)). assert (C : 0 < c) by (apply Rinv_0_lt_compat; now apply Rmult_lt_0_compat).
  exists c. split; [exact C|]. set (f n := Rabs (v n b k) + c * virial (x n) (v n)).
  assert (STEP : forall n, Rabs (v n b k) + c * (virial (x n) (v n) + t n * inertia (v n)) <= f (S n)).
  { intros n. unfold f. rewrite virial_next. pose proof (velocity_moves n b k K) as V.
    pose proof (Rabs_triang_inv (v n b k) (v (S n) b k)) as Q. rewrite Rabs_minus_sym in Q.
    assert (J n / mass b <= c * (s n * J n)); [|lra].
    replace (J n / mass b) with (c * (m * J n)) by (unfold c; field; lra). apply Rmult_le_compat_l; [lra|].
    apply Rmult_le_compat_r; [apply J_positive | apply LM]. }
  assert (G : forall n p, f n <= f (n + p)%nat).
  { intros n. induction p as [|p IH]; [rewrite Nat.add_0_r; lra|]. rewrite Nat.add_succ_r.
    specialize (STEP (n + p)%nat). pose proof (flight_positive (n + p)). pose proof (energy_positive (n + p)).
    assert (0 <= c * (t (n + p)%nat * inertia (v (n + p)%nat))) by (apply Rmult_le_pos; [lra | now apply Rmult_le_pos]).
    unfold f in *. lra. }
  assert (F : forall n, f n <= 0).
  { intros n. apply Rnot_lt_le. intros P0. destruct (velocity_rests b k B K (f n) P0) as (N & L).
    specialize (L (n + N)%nat ltac:(lia)). unfold R_dist in L. rewrite Rminus_0_r in L. specialize (G n N).
    pose proof (never_recedes (n + N)). unfold f at 2 in G.
    assert (c * virial (x (n + N)%nat) (v (n + N)%nat) <= c * 0) by (apply Rmult_le_compat_l; lra). lra. }
  intros n. specialize (STEP n). specialize (F (S n)). lra.
Qed.
Theorem places_converge b k : (b <= last)%nat -> (k < d)%nat -> exists l, Un_cv (fun n => x n b k) l.
Proof.
  intros B K. destruct (velocity_made_up b k B K) as (c & C & L).
  assert (M : forall n, Rabs (t n * v n b k) <= c / 2 * (inertia (x n) - inertia (x (S n)))).
  { intros n. pose proof (flight_positive n) as T. rewrite Rabs_mult, (Rabs_right (t n)) by lra. specialize (L n).
    assert (t n * Rabs (v n b k) <= t n * (- c * (virial (x n) (v n) + t n * inertia (v n)))) by now apply Rmult_le_compat_l.
    pose proof (energy_positive n). rewrite inertia_next.
    assert (0 <= c * (t n * t n * inertia (v n))) by (apply Rmult_le_pos; [lra | apply Rmult_le_pos; [apply Rle_0_sqr | assumption]]). lra. }
  assert (X : forall n, x (S n) b k = x n b k + t n * v n b k).
  { intros n. destruct (run n) as (_ & _ & -> & _). reflexivity. }
  apply (bounded_variation_converges _ (fun n => - (c / 2) * inertia (x n)) 0).
  - intros n. rewrite X. specialize (M n). apply within in M. lra.
  - intros n. rewrite X. specialize (M n). apply within in M. lra.
  - intros n. assert (0 <= c / 2 * inertia (x n)) by (apply Rmult_le_pos; [lra | apply inertia_positive]). lra.
Qed.
Theorem no_turning : pairs (turning (x 0%nat) (v 0%nat)) (turning (x 0%nat) (v 0%nat)) = 0.
Proof.
  set (L := pairs _ _). pose proof (pairs_positive (turning (x 0%nat) (v 0%nat))) as P0. fold L in P0.
  apply Rle_antisym; [|exact P0]. apply Rnot_lt_le. intros Q.
  assert (B : forall n, L <= inertia (x 0%nat) * inertia (v n)).
  { intros n. unfold L. replace (turning (x 0%nat) (v 0%nat)) with (turning (x n) (v n))
      by (extensionality k; extensionality l; apply turning_kept).
    apply Rle_trans with (1 := turning_bounded (x n) (v n)). apply Rmult_le_compat_r; [apply energy_positive|].
    induction n as [|n IH]; [lra|]. pose proof (shrinks n). lra. }
  pose proof (B O) as B0. assert (I0 : 0 < inertia (x 0%nat)).
  { destruct (Rle_lt_or_eq_dec _ _ (inertia_positive (x 0%nat))) as [K|K]; [exact K|]. rewrite <- K, Rmult_0_l in B0. lra. }
  destruct (rests (L / inertia (x 0%nat))) as (N & H); [now apply Rdiv_lt_0_compat|]. specialize (H N (le_n N)). specialize (B N).
  unfold R_dist in H. rewrite Rminus_0_r, Rabs_right in H by (apply Rle_ge, energy_positive).
  assert (inertia (x 0%nat) * inertia (v N) < inertia (x 0%nat) * (L / inertia (x 0%nat))) by (apply Rmult_lt_compat_l; assumption).
  replace (inertia (x 0%nat) * (L / inertia (x 0%nat))) with L in H0 by (field; lra). lra.
Qed.
End AtRest.
End Run.

Lemma centred_run x v t i j J : many_collide x v t i j J ->
  many_collide (fun n => centred (x n)) (fun n => centred (v n)) t i j J.
Proof.
  intros run n. pose proof (weighted_next x v t i j J run n) as W.
  destruct (run n) as (N & T & X & C & Jn & VI & VJ & VO & P & Q). cbn zeta. rewrite !centred_between, !centred_opening.
  split; [exact N|]. split; [exact T|]. split; [now rewrite X, centred_flown|]. split; [exact C|]. split; [exact Jn|].
  split; [intros k; unfold centred; rewrite VI, W; ring|]. split; [intros k; unfold centred; rewrite VJ, W; ring|].
  split; [|now split]. intros b A B. apply same_vector. intros k. unfold Bounds.centred. now rewrite VO, W.
Qed.
End Impulses.

Theorem exchange_theorem_holds : exchange_theorem.
Proof.
  intros d last mass sigma x v t i j J M P H x_0 v_0. pose proof (centred_run d last mass sigma M P x v t i j J H) as C.
  split; [|split; [|split; [|split; [|split]]]].
  - intros n. rewrite (exchanged_is d last mass sigma M P _ _ _ _ _ _ C). exact (exchanged_bounded d last mass sigma M P _ _ _ _ _ _ C (S n)).
  - exact (impulses_bounded d last mass sigma M P _ _ _ _ _ _ H).
  - exact (speeds_summable d last mass sigma M P _ _ _ _ _ _ H).
  - exact (velocities_converge d last mass sigma M P _ _ _ _ _ _ H).
  - exact (turning_kept d last mass sigma M P _ _ _ _ _ _ C).
  - exact (turning_bounded d last mass M x_0 v_0).
Qed.
