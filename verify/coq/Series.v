(* The series of cosine and sine: their partial sums lie above and below, in turn. *)
From Coq Require Import Reals List Lra Lia.
Import ListNotations.
Open Scope R_scope.

(* The k-th term of cos t (s = 0) or sin t (s = 1), and the sum of some terms from the k-th on. *)
Definition term_of (s k : nat) (t : R) : R := (-1) ^ k * t ^ (2 * k + s) / INR (fact (2 * k + s)).
Fixpoint from (s k count : nat) (t : R) : R :=
  match count with O => 0 | S n => term_of s k t + from s (S k) n t end.
Definition partial (s count : nat) (t : R) : R := from s 0 count t.

Lemma from_more s t count : forall k, from s k (S count) t = from s k count t + term_of s (k + count) t.
Proof.
  induction count as [|n IH]; intros k.
  - cbn [from]. rewrite Nat.add_0_r. ring.
  - change (from s k (S (S n)) t) with (term_of s k t + from s (S k) (S n) t). rewrite IH.
    change (from s k (S n) t) with (term_of s k t + from s (S k) n t).
    replace (S k + n)%nat with (k + S n)%nat by lia. ring.
Qed.
Lemma partial_more s count t : partial s (S count) t = partial s count t + term_of s count t.
Proof. exact (from_more s t count 0). Qed.

Lemma partial_one t : partial 0 1 t = 1.
Proof. unfold partial. cbn [from]. unfold term_of. cbn. field. Qed.

(* The coefficient of x^(2k + s) in the k-th term at y x is the k-th term at y. *)
Lemma term_product s k y x : term_of s k (y * x) = term_of s k y * x ^ (2 * k + s).
Proof. unfold term_of. rewrite Rpow_mult_distr. field. apply INR_fact_neq_0. Qed.
Lemma term_next s k y : term_of s (S k) y =
  term_of s k y * (y * y * (-1 / (INR (2 * k + s + 1) * INR (2 * k + s + 2)))).
Proof.
  unfold term_of. replace (2 * S k + s)%nat with (S (S (2 * k + s))) by lia.
  set (n := (2 * k + s)%nat). replace (n + 1)%nat with (S n) by lia.
  replace (n + 2)%nat with (S (S n)) by lia. change (fact (S (S n))) with (S (S n) * (S n * fact n))%nat.
  rewrite !mult_INR. cbn [pow]. field.
  repeat split; try (apply not_0_INR; discriminate). apply INR_fact_neq_0.
Qed.

(* --- derivatives ------------------------------------------------------------------------------ *)

Lemma power_derivative c n t :
  derivable_pt_lim (fun t => c * t ^ S n / INR (fact (S n))) t (c * t ^ n / INR (fact n)).
Proof.
  assert (F : INR (fact n) <> 0) by apply INR_fact_neq_0.
  assert (N : INR (S n) <> 0) by (apply not_0_INR; discriminate).
  replace (c * t ^ n / INR (fact n)) with (c / INR (fact (S n)) * (INR (S n) * t ^ pred (S n))).
  - apply (derivable_pt_lim_ext (mult_real_fct (c / INR (fact (S n))) (fun t => t ^ S n))).
    + intros x. unfold mult_real_fct, Rdiv. ring.
    + apply derivable_pt_lim_scal, derivable_pt_lim_pow.
  - cbn [pred]. change (fact (S n)) with (S n * fact n)%nat. rewrite mult_INR. field. auto.
Qed.
Lemma sine_term k t : derivable_pt_lim (term_of 1 k) t (term_of 0 k t).
Proof.
  unfold term_of. rewrite Nat.add_0_r. replace (2 * k + 1)%nat with (S (2 * k)) by lia.
  apply power_derivative.
Qed.
Lemma cosine_term k t : derivable_pt_lim (term_of 0 (S k)) t (- term_of 1 k t).
Proof.
  unfold term_of. replace (2 * S k + 0)%nat with (S (2 * k + 1)) by lia.
  replace (- ((-1) ^ k * t ^ (2 * k + 1) / INR (fact (2 * k + 1)))) with
    ((-1) ^ S k * t ^ (2 * k + 1) / INR (fact (2 * k + 1))).
  - apply power_derivative.
  - cbn [pow]. field. apply INR_fact_neq_0.
Qed.
Lemma sine_partial count t : derivable_pt_lim (partial 1 count) t (partial 0 count t).
Proof.
  induction count as [|n IH]; [apply derivable_pt_lim_const|]. rewrite partial_more.
  apply (derivable_pt_lim_ext (partial 1 n + term_of 1 n)%F); [intros; symmetry; apply partial_more|].
  apply derivable_pt_lim_plus; [exact IH | apply sine_term].
Qed.
Lemma cosine_partial count t : derivable_pt_lim (partial 0 (S count)) t (- partial 1 count t).
Proof.
  induction count as [|n IH].
  - replace (- partial 1 0 t) with 0 by (cbn; ring).
    apply (derivable_pt_lim_ext (fct_cte 1)); [|apply derivable_pt_lim_const].
    intros x. symmetry. apply partial_one.
  - rewrite partial_more. replace (- (partial 1 n t + term_of 1 n t)) with
      (- partial 1 n t + - term_of 1 n t) by ring.
    apply (derivable_pt_lim_ext (partial 0 (S n) + term_of 0 (S n))%F);
      [intros; symmetry; apply partial_more|].
    apply derivable_pt_lim_plus; [exact IH | apply cosine_term].
Qed.

(* --- signs ------------------------------------------------------------------------------------ *)

(* What is 0 at 0 and does not fall is not negative afterwards. *)
Lemma rising f f' t : (forall x, derivable_pt_lim f x (f' x)) -> (forall x, 0 <= x -> 0 <= f' x) ->
  f 0 = 0 -> 0 <= t -> 0 <= f t.
Proof.
  intros D P Z T. destruct (Req_dec t 0) as [->|N]; [lra|].
  destruct (MVT_cor2 f f' 0 t) as (c & E & C); [lra | auto |].
  rewrite Z in E. assert (0 <= f' c * (t - 0)); [|lra]. apply Rmult_le_pos; [apply P|]; lra.
Qed.
Lemma partial_zero n : partial 0 (S n) 0 = 1 /\ partial 1 n 0 = 0.
Proof.
  induction n as [|n [A B]].
  - split; [apply partial_one | reflexivity].
  - rewrite (partial_more 0), (partial_more 1), A, B. unfold term_of.
    replace (2 * S n + 0)%nat with (S (2 * n + 1)) by lia. replace (2 * n + 1)%nat with (S (2 * n)) by lia.
    rewrite !pow_i by lia. split; field; apply INR_fact_neq_0.
Qed.
(* The sums of n + 1 terms lie above if n is even, and below if n is odd. *)
Lemma alternating n : forall t, 0 <= t ->
  0 <= (-1) ^ n * (partial 0 (S n) t - cos t) /\ 0 <= (-1) ^ n * (partial 1 (S n) t - sin t).
Proof.
  assert (Sines : forall m, (forall t, 0 <= t -> 0 <= (-1) ^ m * (partial 0 (S m) t - cos t)) ->
    forall t, 0 <= t -> 0 <= (-1) ^ m * (partial 1 (S m) t - sin t)).
  { intros m C t T.
    apply (rising (fun t => (-1) ^ m * (partial 1 (S m) t - sin t))
      (fun t => (-1) ^ m * (partial 0 (S m) t - cos t))); trivial.
    - intros x. apply (derivable_pt_lim_scal (partial 1 (S m) - sin)%F).
      apply derivable_pt_lim_minus; [apply sine_partial | apply derivable_pt_lim_sin].
    - rewrite (proj2 (partial_zero (S m))), sin_0. ring. }
  induction n as [|n IH]; intros t T.
  - assert (C : forall t, 0 <= t -> 0 <= (-1) ^ 0 * (partial 0 1 t - cos t)).
    { intros x _. rewrite partial_one.
      pose proof (COS_bound x). rewrite pow_O. lra. }
    split; [now apply C | now apply Sines].
  - assert (C : forall t, 0 <= t -> 0 <= (-1) ^ S n * (partial 0 (S (S n)) t - cos t)).
    { intros x X. apply (rising (fun t => (-1) ^ S n * (partial 0 (S (S n)) t - cos t))
        (fun t => (-1) ^ n * (partial 1 (S n) t - sin t))); trivial.
      - intros y. replace ((-1) ^ n * (partial 1 (S n) y - sin y)) with
          ((-1) ^ S n * (- partial 1 (S n) y - - sin y)) by (cbn [pow]; ring).
        apply (derivable_pt_lim_scal (partial 0 (S (S n)) - cos)%F).
        apply derivable_pt_lim_minus; [apply cosine_partial | apply derivable_pt_lim_cos].
      - intros y Y. now apply IH.
      - rewrite (proj1 (partial_zero (S n))), cos_0. ring. }
    split; [now apply C | now apply Sines].
Qed.
Lemma even_term k t : term_of 0 k (- t) = term_of 0 k t.
Proof.
  unfold term_of. rewrite Nat.add_0_r, !pow_mult.
  replace ((- t) ^ 2) with (t ^ 2) by ring. reflexivity.
Qed.
Lemma even_partial count t : partial 0 count (- t) = partial 0 count t.
Proof.
  assert (E : forall k, from 0 k count (- t) = from 0 k count t); [|apply E].
  induction count as [|n IH]; intros k; cbn [from]; trivial. now rewrite even_term, IH.
Qed.
Lemma cosine_bounds n t : 0 <= (-1) ^ n * (partial 0 (S n) t - cos t).
Proof.
  destruct (Rle_dec 0 t); [now apply alternating|].
  rewrite <- even_partial, <- cos_neg. apply alternating. lra.
Qed.
Lemma sine_bounds n t : 0 <= t -> 0 <= (-1) ^ n * (partial 1 (S n) t - sin t).
Proof. intros T. now apply alternating. Qed.
