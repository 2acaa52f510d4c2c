(* Vectors in R^d: the inequality of Cauchy and Schwarz, and that no other condition binds two. *)
From Coq Require Import Reals Lra Lia FunctionalExtensionality.
From Verify Require Import Theorem1.
Open Scope R_scope.

Definition combined (a : R) (u : vector) (b : R) (v : vector) : vector := fun i => a * u i + b * v i.
Definition scaled (a : R) (u : vector) : vector := fun i => a * u i.
Lemma same_vector (u v : vector) : (forall i, u i = v i) -> u = v.
Proof. intros E. extensionality i. apply E. Qed.

Section Dimension.
Variable dimension : nat.
Notation "u ** v" := (dot dimension u v) (at level 40).
Lemma dot_symmetric u v : u ** v = v ** u.
Proof. induction dimension as [|k IH]; cbn [dot]; [reflexivity | rewrite IH; ring]. Qed.
Lemma dot_linear a u b v w : combined a u b v ** w = a * (u ** w) + b * (v ** w).
Proof.
  induction dimension as [|k IH]; cbn [dot]; [ring|]. rewrite IH. unfold combined. ring.
Qed.
Lemma dot_linear_right a u b v w : w ** combined a u b v = a * (w ** u) + b * (w ** v).
Proof. now rewrite dot_symmetric, dot_linear, (dot_symmetric u), (dot_symmetric v). Qed.
Lemma dot_scaled a u v : scaled a u ** v = a * (u ** v).
Proof.
  induction dimension as [|k IH]; cbn [dot]; [ring|]. rewrite IH. unfold scaled. ring.
Qed.
Lemma dot_scaled_right a u v : v ** scaled a u = a * (v ** u).
Proof. now rewrite dot_symmetric, dot_scaled, (dot_symmetric u). Qed.
Lemma dot_self u : 0 <= u ** u.
Proof.
  induction dimension as [|k IH]; cbn [dot]; [lra|]. pose proof (Rle_0_sqr (u k)). unfold Rsqr in *. lra.
Qed.
Lemma square_of_combined a u b v :
  combined a u b v ** combined a u b v = a * a * (u ** u) + 2 * a * b * (u ** v) + b * b * (v ** v).
Proof. rewrite dot_linear, !dot_linear_right, (dot_symmetric v u). ring. Qed.
Theorem cauchy_schwarz u v : (u ** v) ^ 2 <= (u ** u) * (v ** v).
Proof.
  pose proof (dot_self u) as U. destruct (Rle_lt_or_eq_dec _ _ U) as [P|P].
  - pose proof (dot_self (combined (u ** u) v (- (u ** v)) u)) as Q.
    rewrite square_of_combined, (dot_symmetric v u) in Q.
    apply Rmult_le_reg_l with (u ** u); trivial. lra.
  - destruct (Req_dec (u ** v) 0) as [E|E]; [rewrite E, <- P; lra|].
    pose proof (dot_self (combined 1 v (- ((v ** v + 1) / (2 * (u ** v)))) u)) as Q.
    rewrite square_of_combined, <- P, (dot_symmetric v u) in Q.
    replace (2 * 1 * - ((v ** v + 1) / (2 * (u ** v))) * (u ** v)) with (- (v ** v + 1)) in Q
      by (field; exact E).
    lra.
Qed.
End Dimension.

Lemma coordinate_at_most d (u : vector) k : (k < d)%nat -> u k * u k <= dot d u u.
Proof.
  induction d as [|d IH]; intros K; [lia|]. cbn [dot].
  destruct (Nat.eq_dec k d) as [->|N]; [pose proof (dot_self d u); lra|].
  specialize (IH ltac:(lia)). pose proof (Rle_0_sqr (u d)). unfold Rsqr in *. lra.
Qed.

(* --- the plane of the first two coordinates --------------------------------------------------- *)

Definition plane (a b : R) : vector := fun k => match k with O => a | S O => b | _ => 0 end.
Lemma dot_with_plane d x a b : (2 <= d)%nat -> dot d x (plane a b) = x 0%nat * a + x 1%nat * b.
Proof.
  intros L. induction L as [|d L IH]; [cbn; ring|]. cbn [dot]. rewrite IH.
  destruct d as [|[|d]]; [lia | lia | cbn; ring].
Qed.
Lemma dot_plane d a b a' b' : (2 <= d)%nat -> dot d (plane a b) (plane a' b') = a * a' + b * b'.
Proof. intros L. now rewrite dot_with_plane. Qed.
(* No other condition than the inequality of Cauchy and Schwarz binds two vectors. *)
Theorem vector_exists d x p b : (2 <= d)%nat -> 0 < dot d x x -> p ^ 2 <= dot d x x * b ->
  exists z, dot d x z = p /\ dot d z z = b.
Proof.
  intros L X P. assert (N : exists n, dot d x n = 0 /\ 0 < dot d n n).
  { destruct (Req_dec (x 0%nat) 0) as [E|E].
    - exists (plane 1 0). rewrite dot_with_plane, dot_plane by exact L. rewrite E. lra.
    - exists (plane (- x 1%nat) (x 0%nat)). rewrite dot_with_plane, dot_plane by exact L.
      split; [ring|]. pose proof (Rsqr_pos_lt _ E) as A. pose proof (Rle_0_sqr (x 1%nat)) as B.
      unfold Rsqr in *. lra. }
  destruct N as (n & O & N). set (m := dot d x x) in *. set (s := (b - p ^ 2 / m) / dot d n n).
  assert (S : 0 <= s).
  { assert (A : p ^ 2 / m * m <= b * m) by (unfold Rdiv; rewrite Rmult_assoc, Rinv_l; lra).
    apply Rmult_le_reg_r in A; trivial. apply Rmult_le_pos; [lra | now apply Rlt_le, Rinv_0_lt_compat]. }
  exists (combined (p / m) x (sqrt s) n). split.
  - rewrite dot_linear_right, O. fold m. field. lra.
  - rewrite square_of_combined, O. fold m. rewrite (sqrt_sqrt s S). unfold s. field. lra.
Qed.
