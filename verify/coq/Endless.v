(* Endless collisions of three equal balls: what one of them does; and the places converge. *)
From Coq Require Import Reals Arith Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Sequences Classification Contacts Settling.
From Verify Require Unbounded.
Open Scope R_scope.
Set Default Proof Using "All".

Section Endless.
Variable d : nat.
Variable r : R.
Variable first : scene.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis run : endless d r first scenes time i j.

Let tau n := time (S n) - time n.
Let arriving n := later (tau n) (scenes n).
(* The speed at which the pair meets. *)
Definition meeting_speed n := - rate d (arriving n) (i n) (j n).
Let g := meeting_speed.
Lemma facts n : i n <> j n /\ 0 < tau n /\ distance d (arriving n) (i n) (j n) = 1 /\ 0 < g n /\
  (forall a b, a <> b -> 1 <= distance d (arriving n) a b) /\
  scenes (S n) = collided d r (i n) (j n) (arriving n).
Proof.
  destruct run as (_ & _ & A). destruct (A n) as (N & L & C & P & O & E). fold (tau n) (arriving n) in *.
  unfold g, meeting_speed. repeat split; trivial; unfold tau; lra.
Qed.
Theorem endless_strikes : strikes d (fun _ => 1) (fun _ => 1 / 2) scenes time i j.
Proof.
  intros n. destruct (facts n) as (N & L & C & P & O & E). fold (tau n). fold (arriving n).
  unfold g, meeting_speed in P.
  split; [exact N|]. split; [exact L|]. fold (arriving n). split; [lra|]. split; [lra|].
  split; [intros a b M; specialize (O a b M); lra|]. rewrite E. apply collided_hits; trivial. lra.
Qed.

(* --- what one collision does -------------------------------------------------------------------- *)

Lemma growth_next n : growth d (scenes (S n)) =
  growth d (scenes n) + tau n * motion2 d (scenes n) + 3 / 2 * (1 + r) * g n.
Proof.
  destruct (facts n) as (N & _ & C & _ & _ & ->). rewrite growth_collided by assumption.
  unfold arriving at 1. rewrite growth_later. unfold g, meeting_speed. ring.
Qed.
Lemma growth_rises n : growth d (scenes n) + tau n * motion2 d (scenes n) < growth d (scenes (S n)).
Proof.
  rewrite growth_next. destruct (facts n) as (_ & _ & _ & P & _).
  assert (0 < 3 / 2 * (1 + r) * g n) by (repeat apply Rmult_lt_0_compat; lra). lra.
Qed.
Lemma growth_grows n : growth d (scenes n) < growth d (scenes (S n)).
Proof.
  pose proof (growth_rises n). destruct (facts n) as (_ & L & _).
  pose proof (motion2_positive d (scenes n)).
  assert (0 <= tau n * motion2 d (scenes n)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma growth_after n m : (n <= m)%nat -> growth d (scenes n) <= growth d (scenes m).
Proof. intros L. induction L as [|m L IH]; [lra|]. pose proof (growth_grows m). lra. Qed.
Lemma motion2_next n : motion2 d (scenes (S n)) <= motion2 d (scenes n).
Proof.
  destruct (facts n) as (N & _ & C & _ & _ & ->). rewrite motion2_collided by assumption.
  unfold arriving at 1. rewrite motion2_later.
  assert (0 <= (1 - r) * (1 + r)) by (apply Rmult_le_pos; lra).
  assert (0 <= 3 / 2 * (1 - r * r) * (rate d (arriving n) (i n) (j n) * rate d (arriving n) (i n) (j n))).
  { apply Rmult_le_pos; [lra | apply Rle_0_sqr]. }
  lra.
Qed.
Lemma motion2_after n m : (n <= m)%nat -> motion2 d (scenes m) <= motion2 d (scenes n).
Proof. intros L. induction L as [|m L IH]; [lra|]. pose proof (motion2_next m). lra. Qed.
Lemma size_next n : size d (scenes (S n)) =
  size d (scenes n) + 2 * tau n * growth d (scenes n) + tau n * tau n * motion2 d (scenes n).
Proof. destruct (facts n) as (_ & _ & _ & _ & _ & ->). rewrite size_collided. apply size_later. Qed.
Lemma spin_next n k l : spin (scenes (S n)) k l = spin (scenes n) k l.
Proof.
  destruct (facts n) as (N & _ & C & _ & _ & ->).
  rewrite (spin_collided d r _ _ _ N C k l). apply spin_later.
Qed.
Lemma spin_stays n k l : spin (scenes n) k l = spin (scenes 0%nat) k l.
Proof.
  induction n as [|n IH]; [reflexivity | now rewrite spin_next].
Qed.
Theorem settles_always : exists z, settles d scenes z.
Proof.
  apply (Unbounded.settles_always d (fun _ => 1) (fun _ => 1 / 2) scenes time i j); [intros _; lra..|].
  exact endless_strikes.
Qed.
End Endless.
