(* Sums over any number of balls with their masses: the moment of inertia and its rate, the angular momentum
   and how large it can be, and the frame of the centre of mass. *)
From Coq Require Import Reals Arith Lra Lia FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Sequences Calculus Bounds.
Open Scope R_scope.
Set Default Proof Using "All".

(* --- sums over the balls ------------------------------------------------------------------------- *)

Lemma sum_but_one (f g : nat -> R) i n : (forall b, b <> i -> f b = g b) ->
  sum_f_R0 f n = sum_f_R0 g n + if le_dec i n then f i - g i else 0.
Proof.
  intros E. induction n as [|n IH]; cbn [sum_f_R0].
  - destruct (le_dec i 0) as [L|L]; [replace i with O by lia; ring | rewrite E by lia; ring].
  - rewrite IH. destruct (Nat.eq_dec i (S n)) as [->|N].
    + destruct (le_dec (S n) n); [lia|]. destruct (le_dec (S n) (S n)); [ring | lia].
    + rewrite (E (S n)) by congruence. destruct (le_dec i n), (le_dec i (S n)); try lia; ring.
Qed.
Lemma sum_but_two (f g : nat -> R) i j n : i <> j -> (i <= n)%nat -> (j <= n)%nat ->
  (forall b, b <> i -> b <> j -> f b = g b) ->
  sum_f_R0 f n = sum_f_R0 g n + (f i - g i) + (f j - g j).
Proof.
  intros N I J E. set (h := fun b => if Nat.eq_dec b i then f b else g b).
  rewrite (sum_but_one f h j), (sum_but_one h g i).
  - destruct (le_dec i n), (le_dec j n); try lia. unfold h.
    destruct (Nat.eq_dec i i), (Nat.eq_dec j i); congruence.
  - intros b B. unfold h. now destruct (Nat.eq_dec b i).
  - intros b B. unfold h. destruct (Nat.eq_dec b i) as [_|M]; [reflexivity | now apply E].
Qed.
Lemma least_of (f : nat -> R) n : (forall b, 0 < f b) -> exists m, 0 < m /\ forall b, (b <= n)%nat -> m <= f b.
Proof.
  intros P. induction n as [|n (m & M & L)].
  - exists (f O). split; [apply P|]. intros b B. replace b with O by lia. lra.
  - exists (Rmin m (f (S n))). split; [now apply Rmin_glb_lt|]. intros b B. destruct (Nat.eq_dec b (S n)) as [->|N].
    + apply Rmin_r.
    + apply Rle_trans with m; [apply Rmin_l | apply L; lia].
Qed.
Lemma sum_times c f n : sum_f_R0 (fun m => c * f m) n = c * sum_f_R0 f n.
Proof. rewrite scal_sum. apply sum_eq. intros m _. ring. Qed.
Lemma root_at_most a b : 0 <= b -> a <= b * b -> sqrt a <= b.
Proof. intros B L. rewrite <- (sqrt_square b B). now apply sqrt_le_1_alt. Qed.

Section Weights.
Variable d : nat.
Variable last : nat.  (* the balls are 0, ..., last *)
Variable mass : nat -> R.
Hypothesis heavy : forall b, 0 < mass b.

Notation opening := (opening d).
Notation weighted := (weighted last mass).
Notation turning := (turning last mass).
Notation centred := (centred last mass).
Notation pairs := (pairs d).
Definition virial (x v : nat -> vector) : R := product d last mass x v.
Definition inertia (x : nat -> vector) : R := virial x x.
Lemma product_bounded x v : virial x v ^ 2 <= inertia x * inertia v.
Proof. exact (tuples_bounded d mass x v last heavy). Qed.

Lemma inertia_positive x : 0 <= inertia x.
Proof.
  apply cond_pos_sum. intros b. pose proof (heavy b). apply Rmult_le_pos; [lra | apply dot_self].
Qed.
Lemma virial_flown t x v : virial (flown t x v) v = virial x v + t * inertia v.
Proof.
  unfold inertia, virial, product. rewrite scal_sum, <- plus_sum. apply sum_eq. intros b _.
  replace (flown t x v b) with (combined 1 (x b) t (v b)) by (apply same_vector; intros k; unfold flown, combined; ring).
  rewrite dot_linear. ring.
Qed.
Lemma inertia_flown t x v : inertia (flown t x v) = inertia x + 2 * t * virial x v + t * t * inertia v.
Proof.
  unfold inertia, virial, product. rewrite !scal_sum, <- !plus_sum. apply sum_eq. intros b _.
  replace (flown t x v b) with (combined 1 (x b) t (v b)) by (apply same_vector; intros k; unfold flown, combined; ring).
  rewrite square_of_combined. ring.
Qed.
Lemma turning_flown t x v k l : turning (flown t x v) v k l = turning x v k l.
Proof. apply sum_eq. intros b _. unfold flown. ring. Qed.

(* --- the size of the angular momentum -------------------------------------------------------------- *)

Lemma sum_positive (f : vector) : (forall k, 0 <= f k) -> 0 <= dot d f (fun _ => 1).
Proof. intros F. induction d as [|m IH]; cbn [dot]; [lra|]. specialize (F m). lra. Qed.
Lemma pairs_positive p : 0 <= pairs p p.
Proof. unfold Bounds.pairs. assert (0 <= dot d (fun k => dot d (p k) (p k)) (fun _ => 1)); [|lra]. apply sum_positive. intros k. apply dot_self. Qed.
Lemma pairs_linear a p b q w : pairs (fun k => combined a (p k) b (q k)) w = a * pairs p w + b * pairs q w.
Proof.
  unfold Bounds.pairs. replace (fun k => dot d (combined a (p k) b (q k)) (w k)) with
    (combined a (fun k => dot d (p k) (w k)) b (fun k => dot d (q k) (w k)))
    by (apply same_vector; intros k; unfold combined at 1; now rewrite dot_linear).
  rewrite dot_linear. ring.
Qed.
Lemma pairs_symmetric p q : pairs p q = pairs q p.
Proof. unfold Bounds.pairs. f_equal. f_equal. apply same_vector. intros k. apply dot_symmetric. Qed.
Lemma pairs_bounded p q : pairs p q ^ 2 <= pairs p p * pairs q q.
Proof.
  apply form_bounded; [apply pairs_positive|]. intros a b.
  pose proof (pairs_positive (fun k => combined a (p k) b (q k))) as P. rewrite pairs_linear in P.
  rewrite !(pairs_symmetric _ (fun k => combined a (p k) b (q k))), !pairs_linear, (pairs_symmetric q p) in P. lra.
Qed.
Definition outer (x v : vector) (k : nat) : vector := fun l => x k * v l - x l * v k.
Lemma pairs_outer x v : pairs (outer x v) (outer x v) <= dot d x x * dot d v v.
Proof.
  unfold Bounds.pairs, outer. rewrite wedge_by_coordinates. unfold wedge. rewrite (dot_symmetric d v x).
  pose proof (Rle_0_sqr (dot d x v)) as Q. unfold Rsqr in Q. lra.
Qed.
Lemma turning_pairs p x v : pairs (turning x v) p = sum_f_R0 (fun b => mass b * pairs (outer (x b) (v b)) p) last.
Proof.
  unfold Bounds.turning. induction last as [|n IH]; cbn [sum_f_R0].
  - replace (fun k l => mass 0%nat * (x 0%nat k * v 0%nat l - x 0%nat l * v 0%nat k)) with
      (fun k => combined (mass 0%nat) (outer (x 0%nat) (v 0%nat) k) 0 (outer (x 0%nat) (v 0%nat) k))
      by (extensionality k; extensionality l; unfold combined, outer; ring).
    rewrite pairs_linear. ring.
  - rewrite <- IH.
    replace (fun k l => sum_f_R0 (fun b => mass b * (x b k * v b l - x b l * v b k)) n +
        mass (S n) * (x (S n) k * v (S n) l - x (S n) l * v (S n) k)) with
      (fun k => combined 1 (fun l => sum_f_R0 (fun b => mass b * (x b k * v b l - x b l * v b k)) n)
        (mass (S n)) (outer (x (S n)) (v (S n)) k))
      by (extensionality k; extensionality l; unfold combined, outer; ring).
    rewrite pairs_linear. ring.
Qed.
Theorem turning_bounded x v : pairs (turning x v) (turning x v) <= inertia x * inertia v.
Proof.
  set (L := turning x v). set (n := sqrt (pairs L L)). pose proof (pairs_positive L) as P.
  assert (N : n * n = pairs L L) by now apply sqrt_sqrt. assert (N0 : 0 <= n) by apply sqrt_pos.
  set (a b := sqrt (dot d (x b) (x b))). set (c b := sqrt (dot d (v b) (v b))).
  assert (A : forall b, a b * a b = dot d (x b) (x b)) by (intros; apply sqrt_sqrt, dot_self).
  assert (C : forall b, c b * c b = dot d (v b) (v b)) by (intros; apply sqrt_sqrt, dot_self).
  assert (B : pairs L L <= n * sum_f_R0 (fun b => mass b * (a b * c b)) last).
  { unfold L at 1. rewrite turning_pairs, <- sum_times. apply sum_Rle. intros b _. pose proof (heavy b) as M.
    replace (n * (mass b * (a b * c b))) with (mass b * (n * (a b * c b))) by ring. apply Rmult_le_compat_l; [lra|].
    pose proof (pairs_bounded (outer (x b) (v b)) L) as Q. pose proof (pairs_outer (x b) (v b)) as O.
    assert (S0 : 0 <= a b * c b) by (apply Rmult_le_pos; apply sqrt_pos).
    assert (0 <= n * (a b * c b)) by now apply Rmult_le_pos. apply Rnot_lt_le. intros K.
    assert (n * (a b * c b) * (n * (a b * c b)) < pairs (outer (x b) (v b)) L * pairs (outer (x b) (v b)) L)
      by (apply Rmult_le_0_lt_compat; lra).
    assert (pairs (outer (x b) (v b)) (outer (x b) (v b)) * pairs L L <= dot d (x b) (x b) * dot d (v b) (v b) * pairs L L)
      by (apply Rmult_le_compat_r; lra).
    rewrite <- A, <- C, <- N in H1. rewrite <- N in Q. lra. }
  pose proof (tuples_bounded 1 mass (fun b _ => a b) (fun b _ => c b) last heavy) as T.
  assert (F : forall y z, mixed 1 mass (fun b _ => y b) (fun b _ => z b) last = sum_f_R0 (fun b => mass b * (y b * z b)) last)
    by (intros y z; apply sum_eq; intros b _; cbn [dot]; ring).
  rewrite !F in T. set (w := sum_f_R0 (fun b => mass b * (a b * c b)) last) in *.
  replace (sum_f_R0 (fun b => mass b * (a b * a b)) last) with (inertia x) in T by (apply sum_eq; intros b _; now rewrite A).
  replace (sum_f_R0 (fun b => mass b * (c b * c b)) last) with (inertia v) in T by (apply sum_eq; intros b _; now rewrite C).
  apply Rle_trans with (2 := T). rewrite <- N in *. destruct (Rle_lt_or_eq_dec _ _ N0) as [S|<-].
  - assert (n <= w) by (apply Rmult_le_reg_l with n; [exact S | lra]).
    replace (w ^ 2) with (w * w) by ring. apply Rmult_le_compat; lra.
  - rewrite Rmult_0_l. apply pow2_ge_0.
Qed.

(* --- the frame of the centre of mass ---------------------------------------------------------------- *)

Lemma weighted_flown t x v k : weighted (flown t x v) k = weighted x k + t * weighted v k.
Proof. unfold Bounds.weighted. rewrite scal_sum, <- plus_sum. apply sum_eq. intros b _. unfold flown. ring. Qed.
Lemma centred_flown t x v : centred (flown t x v) = flown t (centred x) (centred v).
Proof.
  extensionality b. extensionality k. unfold Bounds.centred. rewrite weighted_flown. unfold flown, Rdiv. ring.
Qed.
Lemma centred_between x a b : between (centred x) a b = between x a b.
Proof. apply same_vector. intros k. unfold between, centred. ring. Qed.
Lemma centred_opening x v a b : opening (centred x) (centred v) a b = opening x v a b.
Proof. unfold Bounds.opening. now rewrite !centred_between. Qed.
End Weights.
