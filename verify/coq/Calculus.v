(* General mathematics that statements take on trust: series, a recursion that ends, and functions with a
   positive second derivative. *)
From Coq Require Import Reals Ranalysis5 Lra Lia List FinFun.
From Verify Require Import Theorem1 Vectors Sequences.
Import ListNotations.
Open Scope R_scope.

(* --- inner products ------------------------------------------------------------------------------ *)

(* What Cauchy and Schwarz say of any form that is one. *)
Lemma form_bounded a b c : 0 <= a -> (forall s t, 0 <= s * s * a + 2 * (s * t) * b + t * t * c) -> b ^ 2 <= a * c.
Proof.
  intros A Q. destruct (Rle_lt_or_eq_dec _ _ A) as [P|P].
  - specialize (Q (- b) a). apply Rmult_le_reg_l with a; [exact P|]. lra.
  - destruct (Req_dec b 0) as [->|N]; [rewrite <- P; lra|].
    specialize (Q (- ((c + 1) / (2 * b))) 1).
    replace (2 * (- ((c + 1) / (2 * b)) * 1) * b) with (- (c + 1)) in Q by (field; exact N). rewrite <- P in Q. lra.
Qed.
(* Tuples of vectors, with masses. *)
Definition mixed (d : nat) (m : nat -> R) (x z : nat -> vector) (n : nat) : R :=
  sum_f_R0 (fun i => m i * dot d (x i) (z i)) n.
Lemma tuples_bounded d m x z n : (forall i, 0 < m i) -> mixed d m x z n ^ 2 <= mixed d m x x n * mixed d m z z n.
Proof.
  intros M. apply form_bounded.
  - apply cond_pos_sum. intros i. specialize (M i). apply Rmult_le_pos; [lra | apply dot_self].
  - intros s t. replace (s * s * mixed d m x x n + 2 * (s * t) * mixed d m x z n + t * t * mixed d m z z n)
      with (sum_f_R0 (fun i => m i * dot d (combined s (x i) t (z i)) (combined s (x i) t (z i))) n).
    + apply cond_pos_sum. intros i. specialize (M i). apply Rmult_le_pos; [lra | apply dot_self].
    + unfold mixed. rewrite !scal_sum, <- !plus_sum. apply sum_eq. intros i _. rewrite square_of_combined. ring.
Qed.
Lemma lengths_add d u v :
  sqrt (dot d (combined 1 u 1 v) (combined 1 u 1 v)) <= sqrt (dot d u u) + sqrt (dot d v v).
Proof.
  pose proof (sqrt_pos (dot d u u)) as A. pose proof (sqrt_pos (dot d v v)) as B.
  pose proof (sqrt_sqrt _ (dot_self d u)) as A2. pose proof (sqrt_sqrt _ (dot_self d v)) as B2.
  set (a := sqrt (dot d u u)) in *. set (b := sqrt (dot d v v)) in *.
  rewrite <- (sqrt_square (a + b)) by lra. apply sqrt_le_1_alt. rewrite square_of_combined, <- A2, <- B2.
  assert (dot d u v <= a * b); [|lra].
  apply Rnot_lt_le. intros L. assert (0 <= a * b) by now apply Rmult_le_pos.
  pose proof (cauchy_schwarz d u v) as C. rewrite <- A2, <- B2 in C.
  assert (a * b * (a * b) < dot d u v * dot d u v) by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.

(* --- inner products of two planes ----------------------------------------------------------------- *)

Definition wedge d (x v y w : vector) : R := dot d x y * dot d v w - dot d x w * dot d v y.
Lemma dot_ones d u : dot d u (fun _ => 1) = dot d (fun _ => 1) u.
Proof. apply dot_symmetric. Qed.
Lemma dot_add d u v w : dot d (fun k => u k + v k) w = dot d u w + dot d v w.
Proof.
  replace (fun k => u k + v k) with (combined 1 u 1 v) by (apply same_vector; intros k; unfold combined; ring).
  rewrite dot_linear. ring.
Qed.
Lemma dot_times d a u w : dot d (fun k => a * u k) w = a * dot d u w.
Proof. exact (dot_scaled d a u w). Qed.
Lemma dot_product d u v : dot d (fun k => u k * v k) (fun _ => 1) = dot d u v.
Proof. induction d as [|d IH]; cbn [dot]; [reflexivity|]. rewrite IH. ring. Qed.
(* Twice that product is a sum over pairs of coordinates. *)
Lemma wedge_by_coordinates d x v y w :
  dot d (fun k => dot d (fun l => x k * v l - x l * v k) (fun l => y k * w l - y l * w k)) (fun _ => 1) =
  2 * wedge d x v y w.
Proof.
  assert (E : (fun k => dot d (fun l => x k * v l - x l * v k) (fun l => y k * w l - y l * w k)) =
    (fun k => (dot d v w * (x k * y k) + - (dot d v y) * (x k * w k)) +
      (- (dot d x w) * (v k * y k) + dot d x y * (v k * w k)))).
  { apply same_vector. intros k.
    replace (fun l => x k * v l - x l * v k) with (combined (x k) v (- v k) x)
      by (apply same_vector; intros l; unfold combined; ring).
    replace (fun l => y k * w l - y l * w k) with (combined (y k) w (- w k) y)
      by (apply same_vector; intros l; unfold combined; ring).
    rewrite dot_linear, !dot_linear_right. ring. }
  rewrite E, !dot_add, !dot_times, !dot_product. unfold wedge. ring.
Qed.

(* --- series -------------------------------------------------------------------------------------- *)

(* A series of vectors converges if the partial sums of their lengths are bounded. *)
Lemma vectors_summable d (u : nat -> vector) b :
  (forall n, sum_f_R0 (fun m => sqrt (dot d (u m) (u m))) n <= b) ->
  forall k, (k < d)%nat -> exists l, Un_cv (fun n => sum_f_R0 (fun m => u m k) n) l.
Proof.
  intros B k K.
  assert (A : forall m, Rabs (u m k) <= sqrt (dot d (u m) (u m))).
  { intros m. rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. exact (coordinate_at_most d (u m) k K). }
  apply (bounded_variation_converges _ (fun n => sum_f_R0 (fun m => sqrt (dot d (u m) (u m))) n) b); [| | exact B];
    intros n; cbn [sum_f_R0]; pose proof (within _ _ (A (S n))); lra.
Qed.
(* Numbers that are not negative have the same sum in any order. *)
Fixpoint listed (u : nat -> R) (l : list nat) : R := match l with [] => 0 | n :: l => u n + listed u l end.
Lemma listed_app u l l' : listed u (l ++ l') = listed u l + listed u l'.
Proof. induction l as [|n l IH]; cbn; [ring | rewrite IH; ring]. Qed.
Lemma listed_positive u l : (forall n, 0 <= u n) -> 0 <= listed u l.
Proof. intros P. induction l as [|n l IH]; cbn; [lra|]. specialize (P n). lra. Qed.
Lemma listed_among u l : (forall n, 0 <= u n) -> NoDup l -> forall l', incl l l' -> listed u l <= listed u l'.
Proof.
  intros P. induction l as [|n l IH]; intros N l' I; [now apply listed_positive|].
  apply NoDup_cons_iff in N as [F N]. destruct (in_split n l' (I n (or_introl eq_refl))) as (a & b & ->).
  rewrite listed_app. cbn [listed].
  assert (J : incl l (a ++ b)).
  { intros m M. assert (m <> n) by (intros ->; contradiction). specialize (I m (or_intror M)).
    apply in_app_iff in I. apply in_app_iff. destruct I as [I|[I|I]]; [now left | congruence | now right]. }
  specialize (IH N _ J). rewrite listed_app in IH. lra.
Qed.
Lemma sum_listed u n : sum_f_R0 u n = listed u (seq 0 (S n)).
Proof.
  induction n as [|n IH]; [cbn; ring|]. cbn [sum_f_R0]. rewrite IH, (seq_S (S n)), listed_app. cbn. ring.
Qed.
Lemma some_of_them u p n l : (forall m, 0 <= u m) -> (forall m k, p m = p k -> m = k) ->
  Un_cv (fun n => sum_f_R0 u n) l -> sum_f_R0 (fun m => u (p m)) n <= l.
Proof.
  intros P I L. set (top := list_max (map p (seq 0 (S n)))).
  assert (E : forall f, listed (fun m => u (p m)) f = listed u (map p f)).
  { induction f as [|m f IH]; cbn; [reflexivity | now rewrite IH]. }
  rewrite sum_listed, E. apply Rle_trans with (listed u (seq 0 (S top))).
  - apply listed_among; [exact P | apply Injective_map_NoDup; [exact I | apply seq_NoDup]|].
    intros m M. apply in_seq. split; [lia|]. assert (m <= top)%nat; [|lia].
    assert (F : Forall (fun k => k <= top)%nat (map p (seq 0 (S n)))) by (apply list_max_le; unfold top; lia).
    rewrite Forall_forall in F. now apply F.
  - rewrite <- sum_listed. apply (growing_ineq (fun n => sum_f_R0 u n) l); [|exact L].
    intros m. cbn [sum_f_R0]. specialize (P (S m)). lra.
Qed.
Lemma any_order u p q l : (forall n, 0 <= u n) -> (forall n, q (p n) = n) -> (forall n, p (q n) = n) ->
  Un_cv (fun n => sum_f_R0 u n) l -> Un_cv (fun n => sum_f_R0 (fun m => u (p m)) n) l.
Proof.
  intros P Q Q' L.
  assert (I : forall m k, p m = p k -> m = k) by (intros m k E; now rewrite <- (Q m), <- (Q k), E).
  assert (J : forall m k, q m = q k -> m = k) by (intros m k E; now rewrite <- (Q' m), <- (Q' k), E).
  destruct (bounded_increasing_converges (fun n => sum_f_R0 (fun m => u (p m)) n) l) as (k & K).
  - intros n. cbn [sum_f_R0]. specialize (P (p (S n))). lra.
  - intros n. now apply some_of_them.
  - replace l with k; [exact K|]. apply Rle_antisym.
    + apply (limit_at_most _ _ _ K). intros n. now apply some_of_them.
    + apply (limit_at_most _ _ _ L). intros n.
      rewrite (sum_eq u (fun m => u (p (q m)))) by (intros m _; now rewrite Q').
      now apply (some_of_them (fun m => u (p m)) q).
Qed.

(* --- a positive second derivative ------------------------------------------------------------------ *)

(* A function on an interval, with a first derivative that changes sign. *)
Lemma falls_and_rises a b f f' f'' : a < b ->
  (forall x, a <= x <= b -> derivable_pt_lim f x (f' x)) ->
  (forall x, a <= x <= b -> derivable_pt_lim f' x (f'' x)) ->
  (forall x, a <= x <= b -> 0 < f'' x) -> f' a < 0 -> 0 < f' b ->
  exists c, a < c < b /\ f' c = 0 /\ (forall x y, a <= x < y -> y <= c -> f y < f x) /\
    (forall x y, c <= x < y -> y <= b -> f x < f y).
Proof.
  intros AB D D' P A B.
  assert (G : forall x y, a <= x < y -> y <= b -> f' x < f' y).
  { intros x y X Y. destruct (MVT_cor2 f' f'' x y ltac:(lra)) as (z & E & Z); [intros z Z; apply D'; lra|].
    assert (0 < f'' z * (y - x)) by (apply Rmult_lt_0_compat; [apply P|]; lra). lra. }
  destruct (IVT_interv f' a b) as (c & C & F); trivial.
  { intros x X. apply derivable_continuous_pt. exists (f'' x). now apply D'. }
  assert (C' : a < c < b).
  { split; apply Rnot_le_lt; intros N; [assert (c = a) by lra | assert (c = b) by lra]; subst c; lra. }
  exists c. split; [exact C'|]. split; [exact F|]. split; intros x y X Y.
  - destruct (MVT_cor2 f f' x y ltac:(lra)) as (z & E & Z); [intros z Z; apply D; lra|].
    assert (f' z < 0) by (rewrite <- F; apply G; lra).
    assert (0 < - f' z * (y - x)) by (apply Rmult_lt_0_compat; lra). lra.
  - destruct (MVT_cor2 f f' x y ltac:(lra)) as (z & E & Z); [intros z Z; apply D; lra|].
    assert (0 < f' z) by (rewrite <- F; apply G; lra).
    assert (0 < f' z * (y - x)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

(* A recursion that ends. *)
Lemma no_endless a r (u : nat -> R) : 0 < a -> 0 < r -> a * a < 4 * r -> (forall n, 0 < u n) ->
  (forall n, u (S (S n)) <= a * u (S n) - r * u n) -> False.
Proof.
  intros A0 R0 A U L.
  set (q := fun n => u (S n) / u n).
  assert (Q : forall n, 0 < q n) by (intros n; unfold q; apply Rdiv_lt_0_compat; apply U).
  set (e := r - a * a / 4). assert (E : 0 < e) by (unfold e; lra).
  assert (F : forall n, q (S n) * q n <= q n * q n - e).
  { intros n. assert (G : q (S n) * q n <= a * q n - r).
    { unfold q. specialize (L n). pose proof (U n) as U0. pose proof (U (S n)) as U1.
      apply Rmult_le_reg_r with (u n); [exact U0|].
      replace (u (S (S n)) / u (S n) * (u (S n) / u n) * u n) with (u (S (S n))) by (field; lra).
      replace ((a * (u (S n) / u n) - r) * u n) with (a * u (S n) - r * u n) by (field; lra). exact L. }
    pose proof (Rle_0_sqr (q n - a / 2)) as H. unfold Rsqr in H. unfold e. lra. }
  assert (D : forall n, q n <= q O - INR n * (e / q O) /\ q n <= q O).
  { induction n as [|n [IH IH']]; [simpl; pose proof (Q O); split; lra|].
    specialize (F n). pose proof (Q n) as Qn. pose proof (Q O) as Q0.
    assert (H : q (S n) <= q n - e / q O).
    { apply Rmult_le_reg_r with (q n); [exact Qn|].
      apply Rle_trans with (1 := F).
      replace ((q n - e / q O) * q n) with (q n * q n - e * (q n / q O)) by (field; lra).
      assert (q n / q O <= 1).
      { apply Rmult_le_reg_r with (q O); [exact Q0|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
      assert (e * (q n / q O) <= e * 1) by (apply Rmult_le_compat_l; lra). lra. }
    assert (0 < e / q O) by (apply Rdiv_lt_0_compat; assumption).
    rewrite S_INR. split; lra. }
  pose proof (Q O) as Q0.
  destruct (archimed_cor1 ((e / q O) / q O)) as (N & N1 & N2).
  { apply Rdiv_lt_0_compat; [apply Rdiv_lt_0_compat|]; assumption. }
  destruct (D N) as [D1 _]. pose proof (Q N) as QN.
  assert (NR : 0 < INR N) by (apply lt_0_INR; exact N2).
  assert (q O < INR N * (e / q O)); [|lra].
  apply Rmult_lt_reg_r with (/ INR N / q O).
  { apply Rdiv_lt_0_compat; [apply Rinv_0_lt_compat|]; assumption. }
  replace (q O * (/ INR N / q O)) with (/ INR N) by (field; lra).
  replace (INR N * (e / q O) * (/ INR N / q O)) with (e / q O / q O) by (field; lra). exact N1.
Qed.
