(* The separatrix f(q), the largest u from which collisions never end: it is attained, it bounds
   what the set is a neighbourhood of, it decreases strictly, it is continuous. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Coq Require ClassicalDedekindReals.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
Open Scope R_scope.
Set Default Proof Using "All".

(* A null sequence of positive numbers below 1. *)
Definition fine (n : nat) : R := RinvN (S n).
Lemma fine_range n : 0 < fine n < 1.
Proof.
  unfold fine, RinvN. cbn [pos]. pose proof (pos_INR n). rewrite S_INR.
  split; [apply Rinv_0_lt_compat; lra|]. rewrite <- Rinv_1. apply Rinv_lt_contravar; lra.
Qed.
Lemma fine_tends (b c : R) : Un_cv (fun n => b - c * fine n) b.
Proof.
  pose proof (CV_minus _ _ _ _ (cv_const b)
    (CV_mult _ _ _ _ (cv_const c) (cv_shift _ _ RinvN_cv))) as H.
  rewrite Rmult_0_r, Rminus_0_r in H. exact H.
Qed.

Section Curve.
Variables r a : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.

Definition share (rho y v : R) := v = 0 \/ unending r a rho (State y v).
Lemma share_bound rho y : bound (share rho y).
Proof. exists 1. intros v [->|[[_ V] _]]; simpl in *; lra. Qed.
Lemma share_inhabited rho y : exists v, share rho y v.
Proof. exists 0. now left. Qed.
Definition separatrix_at (rho y : R) : R :=
  proj1_sig (completeness (share rho y) (share_bound rho y) (share_inhabited rho y)).

Section Ratio.
Variable rho : R.
Hypothesis P1 : 0 < rho.
Notation f := (separatrix_at rho).

Lemma f_least y : is_lub (share rho y) (f y).
Proof. unfold separatrix_at. now destruct completeness. Qed.
Lemma f_upper x : unending r a rho x -> u x <= f (q x).
Proof. intros H. apply (f_least (q x)). right. now destruct x. Qed.
Lemma f_not_negative y : 0 <= f y.
Proof. apply (f_least y). now left. Qed.
Lemma f_bound y : f y <= a / (a + rho).
Proof.
  apply (f_least y). intros v [->|H].
  - left. apply Rdiv_lt_0_compat; lra.
  - destruct (unending_now _ _ R1 A1 _ _ H) as [X G]. exact (u_bound r a R1 A1 _ _ P1 X G).
Qed.
Lemma unending_or_ends x : region x -> unending r a rho x \/ ends r a rho x.
Proof.
  intros X. assert (E : forall n, {goes_on a (ratio rho n) (orbit r a rho x n)} +
    {~ goes_on a (ratio rho n) (orbit r a rho x n)}).
  { intros n. set (y := orbit r a rho x n). set (c := ratio rho n). unfold goes_on.
    destruct (Rlt_dec 0 (p a c y)); [|right; tauto].
    destruct (Rlt_dec (c * u y * (2 * q y + c * u y)) (p a c y ^ 2)); [left|right]; tauto. }
  destruct (ClassicalDedekindReals.sig_forall_dec _ E) as [[n N]|H];
    [right; now exists n|left; now split].
Qed.
Lemma unending_under x : region x -> u x < f (q x) -> unending r a rho x.
Proof.
  intros X L. destruct (unending_or_ends x X) as [H|[n N]]; [exact H|]. exfalso.
  apply (Rlt_irrefl (u x)). apply Rlt_le_trans with (1 := L). apply (f_least (q x)).
  intros v [->|H]; [apply Rlt_le, X|]. apply Rnot_lt_le. intros V. apply N.
  apply unending_below with (State (q x) v); auto. unfold below. simpl. lra.
Qed.
Lemma f_less_1 y : f y < 1.
Proof.
  apply Rle_lt_trans with (1 := f_bound y). apply Rmult_lt_reg_r with (a + rho); [lra|].
  unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma f_attained y : 0 <= y -> 0 < f y -> unending r a rho (State y (f y)).
Proof.
  intros Y F. pose proof (f_less_1 y) as F1.
  apply (unending_limit r a R1 A1) with (X := fun n => State y (f y - f y * fine n)); auto.
  - intros n. pose proof (fine_range n). apply unending_under; unfold region; simpl; nra.
  - split; simpl; [apply cv_const|apply fine_tends].
Qed.
(* A state at most on the curve is in the set. *)
Lemma unending_at_most x : region x -> u x <= f (q x) -> unending r a rho x.
Proof.
  intros X L. apply unending_below with (State (q x) (f (q x))); auto.
  - split; simpl; lra.
  - destruct X as [X0 X1]. apply f_attained; lra.
Qed.
Lemma below_curve_if_interior x : region x -> interior r a rho x -> u x < f (q x).
Proof.
  intros X [e [E H]]. assert (V : unending r a rho (State (q x) (u x + e))).
  { destruct (unending_now _ _ R1 A1 _ _ H) as [[H0 H1] _]. simpl in H0, H1. destruct X.
    apply unending_below with (State (q x + e) (u x + e)); auto;
      unfold region, below; simpl; lra. }
  apply f_upper in V. simpl in V. lra.
Qed.
Lemma interior_if_below_curve x : region x -> u x < f (q x) -> interior r a rho x.
Proof.
  intros X L. destruct X as [X0 X1].
  apply interior_below with (State (q x) (f (q x))); auto; unfold region, below; simpl; try lra.
  apply f_attained; lra.
Qed.
Lemma fades_under_curve x : region x -> u x < f (q x) -> fades r a rho x.
Proof.
  intros X L. destruct (interior_if_below_curve x X L) as [e [E H]].
  apply fades_below with (State (q x + e) (u x + e)); auto; simpl; unfold region in X; try lra.
  intros N. apply (f_equal q) in N. simpl in N. lra.
Qed.
Lemma f_strict y z : 0 <= y < z -> 0 < f y -> f z < f y.
Proof.
  intros Y F. destruct (Rle_lt_or_eq_dec 0 (f z) (f_not_negative z)) as [Z|Z]; [|lra].
  pose proof (f_less_1 z). assert (X : region (State y (f z))) by (unfold region; simpl; lra).
  apply (below_curve_if_interior _ X).
  apply interior_below with (State z (f z)); auto; unfold below; simpl; try lra.
  apply f_attained; lra.
Qed.
Lemma f_decreasing y z : 0 <= y <= z -> f z <= f y.
Proof.
  intros Y. destruct (Rle_lt_or_eq_dec y z (proj2 Y)) as [L| ->]; [|lra].
  apply Rnot_lt_le. intros N. pose proof (f_not_negative y). pose proof (f_less_1 z).
  assert (U : unending r a rho (State y (f z))).
  { apply unending_below with (State z (f z)); auto; unfold region, below; simpl; try lra.
    apply f_attained; lra. }
  apply f_upper in U. simpl in U. lra.
Qed.
Theorem f_continuous : continuous_from_0 f.
Proof.
  intros y e Y E. assert (F0 := f_not_negative).
  (* To the right. *)
  assert (RIGHT : exists d, 0 < d /\ forall z, y <= z < y + d -> f y - e < f z).
  { destruct (Rlt_le_dec (f y) e) as [L|L].
    - exists 1. split; [lra|]. intros z Z. specialize (F0 z). lra.
    - pose proof (f_less_1 y) as F1. assert (X : region (State y (f y - e / 2)))
        by (unfold region; simpl; lra).
      destruct (interior_if_below_curve _ X) as [d [D H]]; [simpl; lra|]. simpl in H.
      exists d. split; [exact D|]. intros z Z. apply f_upper in H. simpl in H.
      assert (f (y + d) <= f z) by (apply f_decreasing; lra). lra. }
  (* To the left. *)
  assert (LEFT : exists d, 0 < d /\ forall z, 0 <= z -> y - d < z <= y -> f z < f y + e).
  { destruct (Rle_lt_or_eq_dec 0 y Y) as [Y'| <-];
      [|exists 1; split; [lra|]; intros z Z ZL; replace z with 0 by lra; lra].
    destruct (ClassicalDedekindReals.sig_forall_dec (fun n => f y + e <= f (y - y * fine n))
      (fun n => Rle_dec (f y + e) (f (y - y * fine n)))) as [[n N]|H].
    - exists (y * fine n). pose proof (fine_range n). split; [nra|]. intros z Z ZL.
      assert (f z <= f (y - y * fine n)) by (apply f_decreasing; nra). lra.
    - exfalso. specialize (F0 y).
      assert (U : unending r a rho (State y (f y + e))).
      { apply (unending_limit r a R1 A1) with (X := fun n => State (y - y * fine n) (f y + e));
          simpl; auto; try lra.
        - intros n. specialize (H n). pose proof (fine_range n).
          pose proof (f_less_1 (y - y * fine n)).
          apply unending_at_most; unfold region; simpl; [|exact H]. split; [nra|lra].
        - split; simpl; [apply fine_tends|apply cv_const]. }
      apply f_upper in U. simpl in U. lra. }
  destruct RIGHT as [d [D RI]]. destruct LEFT as [c [C LE]].
  exists (Rmin c d). split; [now apply Rmin_glb_lt|]. intros z Z L.
  pose proof (Rmin_l c d). pose proof (Rmin_r c d). apply Rabs_def2 in L.
  destruct (Rle_lt_dec z y) as [O|O].
  - specialize (LE z Z ltac:(lra)). assert (f y <= f z) by (apply f_decreasing; lra).
    apply Rabs_def1; lra.
  - specialize (RI z ltac:(lra)). assert (f z <= f y) by (apply f_decreasing; lra).
    apply Rabs_def1; lra.
Qed.
End Ratio.

(* An orbit that starts on the curve stays there. *)
Lemma stays_on_curve rho x n : 0 < rho -> region x -> u x = separatrix_at rho (q x) ->
  u (orbit r a rho x n) = separatrix_at (ratio rho n) (q (orbit r a rho x n)).
Proof.
  intros P X E. assert (H : unending r a rho x) by (apply unending_at_most; auto; lra).
  pose proof (unending_orbit r a R1 A1 rho x n P H) as Hn.
  pose proof (ratio_positive rho n P) as Pn.
  apply Rle_antisym; [now apply f_upper|]. apply Rnot_lt_le. intros L.
  assert (u x < separatrix_at rho (q x)); [|lra].
  apply below_curve_if_interior; auto. apply interior_if_later with n; auto.
  apply interior_if_below_curve; auto. apply Hn.
Qed.
End Curve.
