(* Free flight and collisions of three balls, in relative places and velocities. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Vectors.
Open Scope R_scope.

Lemma to_later t s i j : to (later t s) i j = combined 1 (to s i j) t (relative s i j).
Proof. apply same_vector. intros k. unfold to, later, relative, combined. cbn. ring. Qed.
Lemma relative_later t s i j : relative (later t s) i j = relative s i j.
Proof. reflexivity. Qed.
Lemma to_collided d r j s a b : to (collided d r j s) a b = to s a b.
Proof. reflexivity. Qed.

(* The relative velocities after a collision of 0 and j, of j and of the third ball i. *)
Lemma relative_collided d r j s : j <> B0 -> relative (collided d r j s) B0 j =
  combined 1 (relative s B0 j) (- ((1 + r) * rate d s B0 j)) (to s B0 j).
Proof.
  intros N. apply same_vector. intros k. unfold relative, collided, combined.
  destruct j; [now destruct N|..]; cbn [velocity]; field.
Qed.
Lemma relative_collided_other d r i j s : i <> B0 -> i <> j -> relative (collided d r j s) B0 i =
  combined 1 (relative s B0 i) (- ((1 + r) / 2 * rate d s B0 j)) (to s B0 j).
Proof.
  intros N M. apply same_vector. intros k. unfold relative, collided, combined.
  destruct i, j; try easy; cbn [velocity]; field.
Qed.

(* Seen from ball 0. *)
Lemma to_outer s i j : to s i j = combined (-1) (to s B0 i) 1 (to s B0 j).
Proof. apply same_vector. intros k. unfold to, combined. ring. Qed.
Lemma relative_outer s i j : relative s i j = combined (-1) (relative s B0 i) 1 (relative s B0 j).
Proof. apply same_vector. intros k. unfold relative, combined. ring. Qed.
Lemma to_opposite s i j : to s i j = scaled (-1) (to s j i).
Proof. apply same_vector. intros k. unfold to, scaled. ring. Qed.
Lemma distance_symmetric d s i j : distance d s i j = distance d s j i.
Proof.
  unfold distance. f_equal. rewrite (to_opposite s i j), dot_scaled, dot_scaled_right. ring.
Qed.

(* Distances by their squares. *)
Definition square d s i j := dot d (to s i j) (to s i j).
Lemma distance_above d s i j : 1 < square d s i j -> 1 < distance d s i j.
Proof. intros H. unfold distance. rewrite <- sqrt_1. apply sqrt_lt_1; unfold square in H; lra. Qed.
Lemma distance_one d s i j : square d s i j = 1 -> distance d s i j = 1.
Proof. unfold square, distance. intros ->. exact sqrt_1. Qed.
Lemma square_of_distance d s i j : square d s i j = distance d s i j * distance d s i j.
Proof. symmetry. apply sqrt_sqrt, dot_self. Qed.

(* Which balls meet first, and when, is determined by the scene. *)
Theorem meetings_are_determined : determined.
Proof.
  intros d s i j t i' j' t' N N' [P B C A O] [P' B' C' A' O']. assert (E : t = t').
  { destruct (Rtotal_order t t') as [L|[L|L]]; trivial; exfalso.
    - specialize (B' t i j (conj P L) N). lra.
    - specialize (B t' i' j' (conj P' L) N'). lra. }
  subst t'. split; trivial. clear B B'.
  destruct i, j; try easy; destruct i', j'; try easy; auto; exfalso;
    first [destruct (O B0 ltac:(easy) ltac:(easy)) | destruct (O B1 ltac:(easy) ltac:(easy))
      | destruct (O B2 ltac:(easy) ltac:(easy))];
    rewrite ?(distance_symmetric d _ B1 B0), ?(distance_symmetric d _ B2 B0),
      ?(distance_symmetric d _ B2 B1) in *; lra.
Qed.
