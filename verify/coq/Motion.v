(* Free flight and collisions of three balls, in relative places and velocities. *)
From Coq Require Import Reals Lra FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors.
Open Scope R_scope.

Lemma to_later t s i j : to (later t s) i j = combined 1 (to s i j) t (relative s i j).
Proof. apply same_vector. intros k. unfold to, later, relative, combined. cbn. ring. Qed.
Lemma relative_later t s i j : relative (later t s) i j = relative s i j.
Proof. reflexivity. Qed.
Lemma later_later t u s : later t (later u s) = later (u + t) s.
Proof.
  unfold later. cbn [position velocity]. f_equal. extensionality i. extensionality k. ring.
Qed.
Lemma later_0 s : later 0 s = s.
Proof.
  destruct s as [x v]. unfold later. cbn. f_equal. extensionality i. extensionality k. ring.
Qed.
Lemma to_collided d r i j s a b : to (collided d r i j s) a b = to s a b.
Proof. reflexivity. Qed.

(* The relative velocities after a collision of 0 and j, of j and of the third ball i. *)
Lemma relative_collided d r j s : j <> B0 -> relative (collided d r B0 j s) B0 j =
  combined 1 (relative s B0 j) (- ((1 + r) * rate d s B0 j)) (to s B0 j).
Proof.
  intros N. apply same_vector. intros k. unfold relative, collided, combined.
  destruct j; [now destruct N|..]; cbn [velocity same]; field.
Qed.
Lemma relative_collided_other d r i j s : i <> B0 -> i <> j -> relative (collided d r B0 j s) B0 i =
  combined 1 (relative s B0 i) (- ((1 + r) / 2 * rate d s B0 j)) (to s B0 j).
Proof.
  intros N M. apply same_vector. intros k. unfold relative, collided, combined.
  destruct i, j; try easy; cbn [velocity same]; field.
Qed.

(* Seen from ball o. *)
Lemma from_o x o i j : to x i j = combined (-1) (to x o i) 1 (to x o j).
Proof. apply same_vector. intros k. unfold to, combined. ring. Qed.
Lemma moves_from_o x o i j : relative x i j = combined (-1) (relative x o i) 1 (relative x o j).
Proof. apply same_vector. intros k. unfold relative, combined. ring. Qed.
Lemma to_opposite s i j : to s i j = scaled (-1) (to s j i).
Proof. apply same_vector. intros k. unfold to, scaled. ring. Qed.
Lemma relative_opposite s i j : relative s i j = scaled (-1) (relative s j i).
Proof. apply same_vector. intros k. unfold relative, scaled. ring. Qed.
Lemma distance_symmetric d s i j : distance d s i j = distance d s j i.
Proof.
  unfold distance. f_equal. rewrite (to_opposite s i j), dot_scaled, dot_scaled_right. ring.
Qed.

Lemma rate_symmetric d s i j : rate d s i j = rate d s j i.
Proof.
  unfold rate. rewrite (to_opposite s i j), (relative_opposite s i j), dot_scaled, dot_scaled_right.
  ring.
Qed.

(* Distances by their squares. *)
Definition square d s i j := dot d (to s i j) (to s i j).
Lemma farther d s i j x : 0 <= x -> x ^ 2 < square d s i j -> x < distance d s i j.
Proof.
  intros P Q. rewrite <- (sqrt_pow2 x P). unfold distance. apply sqrt_lt_1; [apply pow2_ge_0 | apply dot_self | exact Q].
Qed.
Lemma as_far d s i j x : 0 <= x -> square d s i j = x ^ 2 -> distance d s i j = x.
Proof. intros P Q. unfold distance. unfold square in Q. rewrite Q. now apply sqrt_pow2. Qed.
Lemma distance_above d s i j : 1 < square d s i j -> 1 < distance d s i j.
Proof. intros H. apply farther; lra. Qed.
Lemma distance_one d s i j : square d s i j = 1 -> distance d s i j = 1.
Proof. intros H. apply as_far; lra. Qed.
Lemma square_of_distance d s i j : square d s i j = distance d s i j * distance d s i j.
Proof. symmetry. apply sqrt_sqrt, dot_self. Qed.

(* Which ball is named first does not matter. *)
Lemma collided_symmetric d r i j s : i <> j -> collided d r i j s = collided d r j i s.
Proof.
  intros N. unfold collided. f_equal. extensionality b. extensionality k.
  rewrite (rate_symmetric d s j i). unfold to.
  destruct i, j; try easy; destruct b; cbn [same]; ring.
Qed.

(* The energy of motion, times 2. Each collision takes some. *)
Definition energy d s : R := dot d (velocity s B0) (velocity s B0) +
  dot d (velocity s B1) (velocity s B1) + dot d (velocity s B2) (velocity s B2).
Lemma energy_positive d s : 0 <= energy d s.
Proof.
  unfold energy. pose proof (dot_self d (velocity s B0)). pose proof (dot_self d (velocity s B1)).
  pose proof (dot_self d (velocity s B2)). lra.
Qed.
Lemma velocity_at_most d s i k : (k < d)%nat -> Rabs (velocity s i k) <= 1 + energy d s.
Proof.
  intros K. pose proof (coordinate_at_most d (velocity s i) k K) as A.
  assert (B : dot d (velocity s i) (velocity s i) <= energy d s).
  { unfold energy. pose proof (dot_self d (velocity s B0)). pose proof (dot_self d (velocity s B1)).
    pose proof (dot_self d (velocity s B2)). destruct i; lra. }
  set (x := velocity s i k) in *. pose proof (Rle_0_sqr (x - 1)) as P.
  pose proof (Rle_0_sqr (x + 1)) as M. unfold Rsqr in *. apply Rabs_le. lra.
Qed.
Lemma energy_lost d r j s : 0 < r < 1 -> j <> B0 -> distance d s B0 j = 1 ->
  energy d (collided d r B0 j s) <= energy d s.
Proof.
  intros Q N C. set (omega := to s B0 j).
  assert (U : dot d omega omega = 1).
  { change (square d s B0 j = 1). rewrite square_of_distance, C. ring. }
  assert (K : rate d s B0 j = dot d omega (velocity s j) - dot d omega (velocity s B0)).
  { unfold rate. replace (relative s B0 j) with (combined 1 (velocity s j) (-1) (velocity s B0))
      by (apply same_vector; intros k; unfold combined, relative; ring).
    rewrite dot_linear_right. fold omega. ring. }
  set (J := (1 + r) / 2 * rate d s B0 j).
  assert (V0 : velocity (collided d r B0 j s) B0 = combined 1 (velocity s B0) J omega).
  { apply same_vector. intros k. unfold collided, combined. cbn [velocity same]. fold omega J. ring. }
  assert (Vj : velocity (collided d r B0 j s) j = combined 1 (velocity s j) (- J) omega).
  { apply same_vector. intros k. unfold collided, combined. fold omega J.
    destruct j; [now destruct N|..]; cbn [velocity same]; ring. }
  assert (L : 0 <= (1 - r * r) / 2 * (rate d s B0 j * rate d s B0 j)).
  { apply Rmult_le_pos; [|apply Rle_0_sqr].
    assert (r * r < 1 * 1) by (apply Rmult_gt_0_lt_compat; lra). lra. }
  assert (G : dot d (velocity (collided d r B0 j s) B0) (velocity (collided d r B0 j s) B0) +
    dot d (velocity (collided d r B0 j s) j) (velocity (collided d r B0 j s) j) =
    dot d (velocity s B0) (velocity s B0) + dot d (velocity s j) (velocity s j) -
    (1 - r * r) / 2 * (rate d s B0 j * rate d s B0 j)).
  { rewrite V0, Vj, !square_of_combined, U, (dot_symmetric d _ omega), (dot_symmetric d _ omega).
    unfold J. rewrite K. field. }
  unfold energy. destruct j; [now destruct N|..].
  - change (velocity (collided d r B0 B1 s) B2) with (velocity s B2). lra.
  - change (velocity (collided d r B0 B2 s) B1) with (velocity s B1). lra.
Qed.
