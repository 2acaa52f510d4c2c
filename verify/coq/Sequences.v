(* Sequences of real numbers: what is monotone and bounded converges, and what follows from that. *)
From Coq Require Import Reals Lra Lia.
Open Scope R_scope.

Lemma bounded_increasing_converges (u : nat -> R) (b : R) :
  (forall n, u n <= u (S n)) -> (forall n, u n <= b) -> exists l, Un_cv u l.
Proof.
  intros G B. destruct (Un_cv_crit u G) as [l L]; [|eauto].
  exists b. intros x [n ->]. apply B.
Qed.
Lemma limit_at_most (u : nat -> R) (l b : R) : Un_cv u l -> (forall n, u n <= b) -> l <= b.
Proof.
  intros L B. apply Rnot_lt_le. intros N. destruct (L (l - b)) as [m M]; [lra|].
  specialize (M m (Nat.le_refl m)). specialize (B m). unfold R_dist, Rabs in M.
  destruct Rcase_abs; lra.
Qed.
Lemma limit_opposite (u : nat -> R) (l : R) : Un_cv u l -> Un_cv (fun n => - u n) (- l).
Proof. apply CV_opp. Qed.
Lemma bounded_decreasing_converges (u : nat -> R) (b : R) :
  (forall n, u (S n) <= u n) -> (forall n, b <= u n) -> exists l, Un_cv u l.
Proof.
  intros G B. destruct (bounded_increasing_converges (fun n => - u n) (- b)) as [l L].
  - intros n. specialize (G n). lra.
  - intros n. specialize (B n). lra.
  - exists (- l). apply limit_opposite in L. intros e E. destruct (L e E) as [m M]. exists m.
    intros n N. specialize (M n N). now rewrite Ropp_involutive in M.
Qed.
Lemma limit_after_one (u : nat -> R) (l : R) : Un_cv (fun n => u (S n)) l -> Un_cv u l.
Proof.
  intros L e E. destruct (L e E) as [m M]. exists (S m). intros [|n] N; [lia|]. apply M. lia.
Qed.
(* What moves by no more than a bounded increasing sequence does converges. *)
Lemma bounded_variation_converges (u w : nat -> R) (b : R) :
  (forall n, u (S n) - u n <= w (S n) - w n) -> (forall n, u n - u (S n) <= w (S n) - w n) ->
  (forall n, w n <= b) -> exists l, Un_cv u l.
Proof.
  intros A B W.
  assert (G : forall n, w n <= w (S n)) by (intros n; specialize (A n); specialize (B n); lra).
  destruct (bounded_increasing_converges w b G W) as [m M].
  assert (P : forall n, u n - u 0%nat <= w n - w 0%nat).
  { induction n; [lra|]. specialize (A n). lra. }
  destruct (bounded_increasing_converges (fun n => u n + w n) (u 0%nat + b + b - w 0%nat)) as [l L].
  - intros n. specialize (B n). lra.
  - intros n. specialize (P n). specialize (W n). lra.
  - exists (l - m). pose proof (CV_minus _ _ _ _ L M) as Q. intros e E. destruct (Q e E) as [k R].
    exists k. intros n N. specialize (R n N). unfold R_dist in *.
    replace (u n - (l - m)) with (u n + w n - w n - (l - m)) by ring. exact R.
Qed.
Lemma within x b : Rabs x <= b -> - b <= x <= b.
Proof. unfold Rabs. destruct Rcase_abs; lra. Qed.
Lemma limit_within (u : nat -> R) (l c b : R) :
  Un_cv u l -> (forall n, Rabs (u n - c) <= b) -> Rabs (l - c) <= b.
Proof.
  intros L B.
  assert (E : forall n, - b <= u n - c <= b).
  { intros n. now apply within. }
  apply Rabs_le. split.
  - enough (- l <= b - c) by lra. apply (limit_at_most _ _ _ (limit_opposite _ _ L)).
    intros n. specialize (E n). lra.
  - enough (l <= b + c) by lra. apply (limit_at_most _ _ _ L). intros n. specialize (E n). lra.
Qed.
