(* Roots of numbers that are not negative: what Meaning.v calls nth_root is one, and rises. *)
From Coq Require Import Reals ZArith Lra Lia.
From Verify Require Import Meaning.
Open Scope R_scope.

Lemma nth_root_positive n x : 0 < x -> 0 < nth_root n x.
Proof. intros X. unfold nth_root. destruct (Rlt_dec 0 x); [apply exp_pos | contradiction]. Qed.
Lemma nth_root_of_zero n : nth_root n 0 = 0.
Proof. unfold nth_root. destruct (Rlt_dec 0 0); [lra | reflexivity]. Qed.
Lemma nth_root_nonnegative n x : 0 <= nth_root n x.
Proof.
  unfold nth_root. destruct (Rlt_dec 0 x); [left; apply exp_pos | lra].
Qed.
Lemma nth_root_power n x : 0 <= x -> nth_root n x ^ Pos.to_nat n = x.
Proof.
  intros [X|<-].
  - rewrite <- Rpower_pow by now apply nth_root_positive.
    unfold nth_root. destruct (Rlt_dec 0 x); [|contradiction].
    rewrite Rpower_mult, INR_IZR_INZ, positive_nat_Z, Rinv_l by (apply IZR_neq; discriminate).
    now apply Rpower_1.
  - rewrite nth_root_of_zero. apply pow_i, Pos2Nat.is_pos.
Qed.
Lemma nth_root_rises n x y : 0 <= x -> x < y -> nth_root n x < nth_root n y.
Proof.
  intros X L. destruct (Rlt_le_dec (nth_root n x) (nth_root n y)) as [|M]; trivial.
  pose proof (pow_incr _ _ (Pos.to_nat n) (conj (nth_root_nonnegative n y) M)) as P.
  rewrite !nth_root_power in P by lra. lra.
Qed.
(* There is no other one. *)
Lemma nth_root_unique n x r : 0 <= r -> r ^ Pos.to_nat n = x -> nth_root n x = r.
Proof.
  intros P <-. assert (Q : 0 <= r ^ Pos.to_nat n) by now apply pow_le.
  pose proof (nth_root_power n _ Q) as E. set (s := nth_root n _) in *.
  assert (0 <= s) by apply nth_root_nonnegative.
  assert (I : forall a b, 0 <= a -> a < b -> a ^ Pos.to_nat n < b ^ Pos.to_nat n).
  { intros a b A L. apply Rle_lt_trans with (a ^ Pos.to_nat n); [lra|].
    destruct (Pos2Nat.is_succ n) as [k ->]. cbn [pow].
    apply Rle_lt_trans with (a * b ^ k).
    - apply Rmult_le_compat_l; trivial. apply pow_incr. lra.
    - apply Rmult_lt_compat_r; trivial. apply pow_lt. lra. }
  destruct (Rtotal_order s r) as [L|[L|L]]; trivial; apply I in L; lra.
Qed.
