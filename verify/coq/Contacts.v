(* What a collision of two balls does to the relative velocities of three, for any masses. *)
From Coq Require Import Reals Lra Lia FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Ending Classification.
Open Scope R_scope.

Lemma same_true i : same i i = true.
Proof. now destruct i. Qed.
Lemma same_false i j : i <> j -> same i j = false.
Proof. now destruct i, j. Qed.
Lemma same_places s s' a b : position s' = position s -> to s' a b = to s a b.
Proof. intros E. unfold to. now rewrite E. Qed.
Lemma to_self s a k : to s a a k = 0.
Proof. unfold to. ring. Qed.
Lemma relative_self s a k : relative s a a k = 0.
Proof. unfold relative. ring. Qed.
Lemma unit_square d s i j : distance d s i j = 1 -> square d s i j = 1.
Proof. intros E. rewrite square_of_distance, E. ring. Qed.
Lemma square_symmetric d s i j : square d s i j = square d s j i.
Proof. now rewrite !square_of_distance, distance_symmetric. Qed.
Lemma rate_rises d s i j t : 0 <= t -> rate d s i j <= rate d (later t s) i j.
Proof.
  intros T. unfold rate. rewrite to_later, relative_later, dot_linear.
  pose proof (dot_self d (relative s i j)).
  assert (0 <= t * dot d (relative s i j) (relative s i j)) by (apply Rmult_le_pos; lra). lra.
Qed.
(* If two balls touch and the third is apart from both, then nobody overlaps. *)
Lemma all_apart d s i j a b : i <> j -> a <> b -> distance d s i j = 1 ->
  (forall k, k <> i -> k <> j -> 1 < distance d s i k /\ 1 < distance d s j k) -> 1 <= distance d s a b.
Proof.
  intros N M C O.
  assert (H : forall x y, pair_is x y i j -> 1 <= distance d s x y).
  { intros x y [[-> ->]|[-> ->]]; [|rewrite distance_symmetric]; lra. }
  assert (K : forall x y, x = i \/ x = j -> y <> i -> y <> j -> 1 <= distance d s x y).
  { intros x y [-> | ->] P Q; destruct (O y P Q); lra. }
  destruct i, j, a, b; try easy;
    first [apply H; unfold pair_is; tauto | apply K; (discriminate || tauto)
      | rewrite distance_symmetric; apply K; (discriminate || tauto)].
Qed.
(* Twice an inner product at one ball, by the squares of the three distances. *)
Lemma cosines d s a b c :
  2 * dot d (to s a b) (to s a c) = square d s a b + square d s a c - square d s b c.
Proof.
  unfold square. replace (to s b c) with (combined (-1) (to s a b) 1 (to s a c))
    by (apply same_vector; intros k; unfold combined, to; ring).
  rewrite square_of_combined. ring.
Qed.

Section Hit.
Variable d : nat.
Variable mass : ball -> R.
Hypothesis heavy : forall b, 0 < mass b.

(* A hit with the exchanged momentum J. *)
Definition hit_with (J : R) (i j : ball) (s s' : scene) : Prop :=
  position s' = position s /\
  forall b k, velocity s' b k =
    if same b i then velocity s b k - J / mass i * to s i j k
    else if same b j then velocity s b k + J / mass j * to s i j k
    else velocity s b k.
Lemma own_velocity J i j s s' : i <> j -> hit_with J i j s s' -> relative s' i j =
  combined 1 (relative s i j) (J / mass i + J / mass j) (to s i j).
Proof.
  intros N [_ V]. apply same_vector. intros k. unfold relative, combined. rewrite !V.
  rewrite !same_true, same_false by congruence. ring.
Qed.
Lemma velocity_from_i J i j k s s' : k <> i -> k <> j -> hit_with J i j s s' ->
  relative s' i k = combined 1 (relative s i k) (J / mass i) (to s i j).
Proof.
  intros N M [_ V]. apply same_vector. intros m. unfold relative, combined. rewrite !V.
  rewrite !same_true, !same_false by congruence. ring.
Qed.
Lemma velocity_from_j J i j k s s' : i <> j -> k <> i -> k <> j -> hit_with J i j s s' ->
  relative s' j k = combined 1 (relative s j k) (- (J / mass j)) (to s i j).
Proof.
  intros O N M [_ V]. apply same_vector. intros m. unfold relative, combined. rewrite !V.
  rewrite !same_true, !same_false by congruence. ring.
Qed.
Lemma hit_is i j s s' : hits d mass i j s s' ->
  exists J, 0 <= J /\ hit_with J i j s s' /\ 0 <= rate d s' i j <= - rate d s i j.
Proof. intros (J & P & X & V & K). exists J. split; [exact P|]. now split. Qed.
(* Which ball is named first does not matter. *)
Lemma hit_symmetric i j s s' : i <> j -> hits d mass i j s s' -> hits d mass j i s s'.
Proof.
  intros N (J & P & X & V & K). exists J. split; [exact P|]. split; [exact X|].
  split; [|now rewrite !(rate_symmetric d _ j i)].
  intros b k. rewrite V. rewrite (to_opposite s j i). unfold scaled.
  destruct (same b i) eqn:E, (same b j) eqn:F; trivial; try ring.
  exfalso. apply N. now destruct b, i, j.
Qed.
Lemma divided J b : 0 <= J -> 0 <= J / mass b.
Proof. intros P. apply Rmult_le_pos; [exact P|]. now apply Rlt_le, Rinv_0_lt_compat. Qed.
(* A hit of a and c does not lower the rate of a and b if the angle at a is at most a right one. *)
Lemma pushed a b c s s' : a <> b -> a <> c -> b <> c -> hits d mass a c s s' ->
  0 <= dot d (to s a b) (to s a c) -> rate d s a b <= rate d s' a b.
Proof.
  intros AB AC BC H A. destruct (hit_is _ _ _ _ H) as (J & P & W & _).
  unfold rate. rewrite (same_places s s') by apply W.
  rewrite (velocity_from_i J a c b s s') by (congruence || exact W).
  rewrite dot_linear_right. pose proof (divided J a P).
  assert (0 <= J / mass a * dot d (to s a b) (to s a c)) by now apply Rmult_le_pos. lra.
Qed.

(* The energy of motion, times 2. *)
Definition energy_of (s : scene) : R :=
  mass B0 * dot d (velocity s B0) (velocity s B0) + mass B1 * dot d (velocity s B1) (velocity s B1) +
  mass B2 * dot d (velocity s B2) (velocity s B2).
Lemma energy_falls i j s s' : i <> j -> hits d mass i j s s' -> energy_of s' <= energy_of s.
Proof.
  intros N H. destruct (hit_is _ _ _ _ H) as (J & P & W & K).
  set (e := to s i j) in *.
  assert (R1 : rate d s' i j = rate d s i j + (J / mass i + J / mass j) * dot d e e).
  { unfold rate. rewrite (same_places s s') by apply W. rewrite (own_velocity J i j s s' N W).
    rewrite dot_linear_right. fold e. ring. }
  assert (R0 : rate d s i j = dot d e (velocity s j) - dot d e (velocity s i)).
  { unfold rate. replace (relative s i j) with (combined 1 (velocity s j) (-1) (velocity s i))
      by (apply same_vector; intros k; unfold combined, relative; ring).
    rewrite dot_linear_right. fold e. ring. }
  destruct W as [_ V].
  assert (Vi : velocity s' i = combined 1 (velocity s i) (- (J / mass i)) e).
  { apply same_vector. intros k. rewrite V, same_true. unfold combined. fold e. ring. }
  assert (Vj : velocity s' j = combined 1 (velocity s j) (J / mass j) e).
  { apply same_vector. intros k. rewrite V, same_true, same_false by congruence. unfold combined.
    fold e. ring. }
  assert (Vo : forall b, b <> i -> b <> j -> velocity s' b = velocity s b).
  { intros b A B. apply same_vector. intros k. now rewrite V, !same_false by congruence. }
  assert (G : mass i * dot d (velocity s' i) (velocity s' i) +
    mass j * dot d (velocity s' j) (velocity s' j) = mass i * dot d (velocity s i) (velocity s i) +
    mass j * dot d (velocity s j) (velocity s j) + J * (rate d s i j + rate d s' i j)).
  { rewrite R1, R0, Vi, Vj, !square_of_combined, (dot_symmetric d (velocity s i) e),
      (dot_symmetric d (velocity s j) e). field.
    pose proof (heavy i). pose proof (heavy j). split; lra. }
  assert (J * (rate d s i j + rate d s' i j) <= 0).
  { assert (0 <= J * - (rate d s i j + rate d s' i j)) by (apply Rmult_le_pos; lra). lra. }
  unfold energy_of. destruct i, j; try (now destruct N);
    [rewrite (Vo B2) | rewrite (Vo B1) | rewrite (Vo B2) | rewrite (Vo B0) | rewrite (Vo B1)
      | rewrite (Vo B0)]; try discriminate; lra.
Qed.
End Hit.

(* Balls of equal masses that part at r times the speed: what the others see of it. *)
Definition even_hit d (r : R) (i j : ball) (s s' : scene) : Prop :=
  hits d (fun _ => 1) i j s s' /\ rate d s' i j = - r * rate d s i j.
Lemma even_hit_symmetric d r i j s s' : i <> j -> even_hit d r i j s s' -> even_hit d r j i s s'.
Proof.
  intros N [H E]. split; [now apply hit_symmetric|]. now rewrite !(rate_symmetric d _ j i).
Qed.
Lemma even_hit_of d m r i j s s' : 0 < m -> hits d (fun _ => m) i j s s' ->
  rate d s' i j = - r * rate d s i j -> even_hit d r i j s s'.
Proof.
  intros M (J & P & X & V & K) E. split; [|exact E]. exists (J / m).
  split; [apply Rmult_le_pos; [exact P | now apply Rlt_le, Rinv_0_lt_compat]|].
  split; [exact X|]. split; [|exact K]. intros b k. rewrite V. unfold Rdiv at 3 5. now rewrite Rinv_1, !Rmult_1_r.
Qed.
Lemma even_velocity d r i j k s s' : i <> j -> k <> i -> k <> j -> 0 < square d s i j -> even_hit d r i j s s' ->
  relative s' i k = combined 1 (relative s i k) (- ((1 + r) / 2 * (rate d s i j / square d s i j))) (to s i j).
Proof.
  intros O N M Q [(J & _ & W) E]. assert (H : hit_with (fun _ => 1) J i j s s') by (split; apply W).
  rewrite (velocity_from_i _ J i j k s s' N M H). f_equal. unfold rate at 1 in E.
  rewrite (same_places s s'), (own_velocity _ J i j s s' O H), dot_linear_right in E by apply W.
  fold (rate d s i j) (square d s i j) in E. apply Rmult_eq_reg_r with (square d s i j); [|lra].
  replace (- ((1 + r) / 2 * (rate d s i j / square d s i j)) * square d s i j) with
    (- ((1 + r) / 2 * rate d s i j)) by (field; lra). lra.
Qed.

(* Equal balls with one coefficient of restitution. *)
Lemma collided_hits d r i j s : 0 < r <= 1 -> i <> j -> distance d s i j = 1 -> rate d s i j < 0 ->
  hits d (fun _ => 1) i j s (collided d r i j s).
Proof.
  intros Q N C P. exists (- ((1 + r) / 2 * rate d s i j)).
  assert (W : hit_with (fun _ => 1) (- ((1 + r) / 2 * rate d s i j)) i j s (collided d r i j s)).
  { split; [reflexivity|]. intros b k. unfold collided. cbn [velocity].
    destruct (same b i), (same b j); field. }
  split.
  - assert (0 <= (1 + r) / 2 * - rate d s i j) by (apply Rmult_le_pos; lra). lra.
  - split; [reflexivity|]. split; [apply W|].
    assert (E : rate d (collided d r i j s) i j = - r * rate d s i j).
    { unfold rate at 1. rewrite to_collided, (own_velocity _ _ _ _ _ _ N W), dot_linear_right.
      pose proof (unit_square _ _ _ _ C) as U. unfold square in U. rewrite U.
      fold (rate d s i j). field. }
    rewrite E. assert (0 <= r * - rate d s i j) by (apply Rmult_le_pos; lra).
    assert (0 <= (1 - r) * - rate d s i j) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma rate_collided d r i j s : i <> j -> distance d s i j = 1 ->
  rate d (collided d r i j s) i j = - r * rate d s i j.
Proof.
  intros N C. unfold rate at 1. rewrite to_collided.
  replace (relative (collided d r i j s) i j) with
    (combined 1 (relative s i j) (- ((1 + r) * rate d s i j)) (to s i j)).
  - rewrite dot_linear_right. pose proof (unit_square _ _ _ _ C) as U. unfold square in U.
    rewrite U. fold (rate d s i j). ring.
  - apply same_vector. intros k. unfold relative, collided, combined. cbn [velocity].
    rewrite !same_true, (same_false j i) by congruence. field.
Qed.
Lemma velocity_collided d r i j k s : i <> j -> k <> i -> k <> j ->
  relative (collided d r i j s) i k =
  combined 1 (relative s i k) (- ((1 + r) / 2 * rate d s i j)) (to s i j).
Proof.
  intros O N M. apply same_vector. intros m. unfold relative, collided, combined. cbn [velocity].
  rewrite !same_true, (same_false k i), (same_false k j) by congruence. ring.
Qed.
Lemma other_rate d r i j k s : i <> j -> k <> i -> k <> j -> rate d (collided d r i j s) i k =
  rate d s i k - (1 + r) / 2 * rate d s i j * dot d (to s i j) (to s i k).
Proof.
  intros O N M. unfold rate at 1. rewrite to_collided, velocity_collided, dot_linear_right by assumption.
  fold (rate d s i k). rewrite (dot_symmetric d (to s i k)). ring.
Qed.
Lemma collided_evenly d r i j s : 0 < r <= 1 -> i <> j -> distance d s i j = 1 -> rate d s i j < 0 ->
  even_hit d r i j s (collided d r i j s).
Proof. intros R N C P. split; [now apply collided_hits | now apply rate_collided]. Qed.
