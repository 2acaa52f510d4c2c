(* Two trajectories from the same scene are the same for as long as both last. *)
From Coq Require Import Reals Lra Classical.
From Verify Require Import Theorem1 Vectors Motion.
Open Scope R_scope.

Lemma later_back u s : later u (later (- u) s) = s.
Proof. rewrite later_later. replace (- u + u) with 0 by ring. apply later_0. Qed.

(* What arrives at a time determines how it goes on. *)
Lemma same_two d s i j i' j' : i <> j -> i' <> j' -> distance d s i' j' = 1 ->
  (forall k, k <> i -> k <> j -> 1 < distance d s i k /\ 1 < distance d s j k) ->
  (i = i' /\ j = j') \/ (i = j' /\ j = i').
Proof.
  intros N N' E O. destruct i, j; try easy; destruct i', j'; try easy; auto; exfalso;
    first [destruct (O B0 ltac:(easy) ltac:(easy)) | destruct (O B1 ltac:(easy) ltac:(easy))
      | destruct (O B2 ltac:(easy) ltac:(easy))];
    rewrite ?(distance_symmetric d _ B1 B0), ?(distance_symmetric d _ B2 B0),
      ?(distance_symmetric d _ B2 B1) in *; lra.
Qed.
Lemma nobody_or_two d r s s' : nobody_collides d s -> two_collide d r s s' -> False.
Proof. intros A (i & j & N & C & P & _). destruct (A i j N) as [_ B]. specialize (B C). lra. Qed.
Definition goes_on d r (s s' : scene) : Prop := nobody_collides d s /\ s' = s \/ two_collide d r s s'.
Lemma one_way d r s a b : goes_on d r s a -> goes_on d r s b -> a = b.
Proof.
  intros [[A ->]|A] [[B ->]|B]; trivial.
  - now destruct (nobody_or_two d r s b A).
  - now destruct (nobody_or_two d r s a B).
  - destruct A as (i & j & N & _ & _ & O & ->), B as (i' & j' & N' & C & _ & _ & ->).
    destruct (same_two d s i j i' j' N N' C O) as [[<- <-]|[<- <-]]; trivial.
    now apply collided_symmetric.
Qed.

Section Two.
Variable d : nat.
Variable r : R.
Variable s : scene.
Variables T T' : R.
Variables Z Z' : R -> scene.
Hypothesis first : trajectory d r s T Z.
Hypothesis second : trajectory d r s T' Z'.

Definition agree_until (t : R) : Prop := forall v, 0 <= v <= t -> Z v = Z' v.
Lemma agree_on m : 0 <= m < T -> m < T' -> agree_until m -> exists e, 0 < e /\ agree_until (m + e).
Proof.
  intros M M' A. destruct (after_it d r s T Z first m M) as (e & E & F).
  destruct (after_it d r s T' Z' second m ltac:(lra)) as (e' & E' & F').
  exists (Rmin e e' / 2). pose proof (Rmin_l e e'). pose proof (Rmin_r e e').
  assert (P : 0 < Rmin e e') by now apply Rmin_glb_lt. split; [lra|]. intros v V.
  destruct (Rle_lt_dec v m) as [L|L]; [apply A; lra|].
  replace v with (m + (v - m)) by ring. rewrite F, F' by lra. f_equal. apply A. lra.
Qed.
Lemma agree_at m : 0 < m < T -> m < T' -> (forall v, 0 <= v < m -> Z v = Z' v) -> Z m = Z' m.
Proof.
  intros M M' A. destruct (before_it d r s T Z first m M) as (e & a & E & F & G).
  destruct (before_it d r s T' Z' second m ltac:(lra)) as (e' & a' & E' & F' & G').
  set (u := Rmin (Rmin e e') m / 2). pose proof (Rmin_l e e'). pose proof (Rmin_r e e').
  pose proof (Rmin_l (Rmin e e') m). pose proof (Rmin_r (Rmin e e') m).
  assert (P : 0 < Rmin (Rmin e e') m) by (apply Rmin_glb_lt; [now apply Rmin_glb_lt | lra]).
  assert (U : 0 < u /\ u < e /\ u < e' /\ u < m) by (unfold u; lra).
  assert (Q : a = a').
  { rewrite <- (later_back u a), <- (later_back u a'), <- F, <- F' by lra. f_equal. apply A. lra. }
  subst a'. exact (one_way d r a _ _ G G').
Qed.
Theorem agree t : 0 <= t < T -> t < T' -> Z t = Z' t.
Proof.
  intros H H'. set (E := fun x => 0 <= x <= t /\ agree_until x).
  assert (E0 : E 0).
  { split; [lra|]. intros v V. replace v with 0 by lra.
    now rewrite (begins d r s T Z first), (begins d r s T' Z' second). }
  destruct (completeness E) as (m & B & L).
  { exists t. intros x [X _]. lra. }
  { now exists 0. }
  assert (M : 0 <= m <= t) by (split; [now apply B | apply L; intros x [X _]; lra]).
  assert (A : forall v, 0 <= v < m -> Z v = Z' v).
  { intros v V. apply NNPP. intros N. enough (m <= v) by lra. apply L. intros x [X Y].
    apply Rnot_lt_le. intros W. apply N, Y. lra. }
  assert (C : agree_until m).
  { intros v V. destruct (Rle_lt_or_eq_dec v m (proj2 V)) as [W| ->]; [apply A; lra|].
    destruct (Rle_lt_or_eq_dec 0 m (proj1 M)) as [W| <-].
    - apply agree_at; trivial; lra.
    - apply (proj2 E0). lra. }
  apply C. split; [lra|]. apply Rnot_lt_le. intros W.
  destruct (agree_on m ltac:(lra) ltac:(lra) C) as (e & P & F).
  assert (Q : E (m + Rmin e (t - m))).
  { pose proof (Rmin_l e (t - m)). pose proof (Rmin_r e (t - m)).
    assert (0 < Rmin e (t - m)) by (apply Rmin_glb_lt; lra).
    split; [lra|]. intros v V. apply F. lra. }
  specialize (B _ Q). assert (0 < Rmin e (t - m)) by (apply Rmin_glb_lt; lra). lra.
Qed.
End Two.

Theorem trajectories_are_determined : determined.
Proof. intros d r s T Z T' Z' A B t H H'. exact (agree d r s T T' Z Z' A B t H H'). Qed.
