(* The set of the states whose collisions never end contains its limits, and it is a neighbourhood
   of every state whose image lies strictly below one of its states. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain.
Open Scope R_scope.
Set Default Proof Using "All".

Definition tends (X : nat -> state) (x : state) :=
  Un_cv (fun n => q (X n)) (q x) /\ Un_cv (fun n => u (X n)) (u x).

Section Topology.
Variables r a : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.

(* --- the step is continuous ------------------------------------------------------------------- *)

Lemma p_tends rho X x : tends X x -> Un_cv (fun n => p a rho (X n)) (p a rho x).
Proof.
  intros [Q U]. unfold p. apply CV_minus; [apply CV_minus|].
  - apply CV_mult; [apply cv_const|]. apply CV_minus; [apply cv_const|exact U].
  - exact Q.
  - apply CV_mult; [apply cv_const|exact U].
Qed.
Lemma width_tends rho X x : tends X x -> Un_cv (fun n => width rho (X n)) (width rho x).
Proof.
  intros [Q U]. unfold width. assert (W : Un_cv (fun n => rho * u (X n)) (rho * u x))
    by (apply CV_mult; [apply cv_const|exact U]).
  apply CV_mult; [exact W|]. apply CV_plus; [|exact W]. apply CV_mult; [apply cv_const|exact Q].
Qed.
Lemma square_tends rho X x : tends X x -> Un_cv (fun n => p a rho (X n) ^ 2) (p a rho x ^ 2).
Proof.
  intros H. apply p_tends with (rho := rho) in H. simpl.
  apply CV_mult; [exact H|]. apply CV_mult; [exact H|apply cv_const].
Qed.
Lemma next_tends rho X x : 0 < rho -> region x -> goes_on a rho x -> tends X x ->
  tends (fun n => next r a rho (X n)) (next r a rho x).
Proof.
  intros P HX G T. pose proof (p_positive r a R1 A1 rho x P HX G) as PX.
  pose proof (fraction r a R1 A1 rho x P HX G) as F.
  split.
  - unfold next, q, Rdiv. apply CV_mult.
    + apply CV_mult; [apply cv_const|]. apply CV_minus; [apply cv_const|apply T].
    + apply cv_inv; [lra|]. now apply p_tends.
  - unfold next, u at 1 5. apply CV_minus; [apply cv_const|].
    apply (continuity_seq sqrt); [apply sqrt_continuity_pt; unfold width in F; lra|].
    apply CV_minus; [apply cv_const|]. unfold Rdiv. apply CV_mult; [now apply width_tends|].
    apply cv_inv; [apply pow_nonzero; lra|]. now apply square_tends.
Qed.

(* --- limits ----------------------------------------------------------------------------------- *)

Lemma goes_on_limit rho X x : 0 < rho -> 0 <= q x -> 0 < u x ->
  (forall n, unending r a rho (X n)) -> tends X x -> region x /\ goes_on a rho x.
Proof.
  intros P Q U H T. assert (P' := inverse_positive rho P).
  (* The next u stays away from 1, because there is still another step. *)
  set (b := a / (a + / rho)).
  assert (B : 0 < b < 1).
  { unfold b. split; [apply Rdiv_lt_0_compat; lra|].
    apply Rmult_lt_reg_r with (a + / rho); [lra|]. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra. }
  assert (W : width rho x <= h b * p a rho x ^ 2).
  { apply cv_le with (fun n => width rho (X n)) (fun n => h b * p a rho (X n) ^ 2).
    - now apply width_tends.
    - apply CV_mult; [apply cv_const|now apply square_tends].
    - intros n. destruct (unending_now r a R1 A1 _ _ (H n)) as [Xn Gn].
      rewrite <- (next_h r a R1 A1 rho (X n) P Xn Gn). apply Rmult_le_compat_r.
      + apply pow_le. left. now apply (p_positive r a R1 A1).
      + destruct (unending_now r a R1 A1 _ _ (unending_next r a R1 A1 _ _ P (H n))) as [Yn G'].
        pose proof (u_bound r a R1 A1 _ _ P' Yn G') as UB. fold b in UB. destruct Yn as [_ Yn].
        unfold h. nra. }
  assert (PX : 0 <= p a rho x).
  { apply cv_le with (fun _ => 0) (fun n => p a rho (X n)); [apply cv_const|now apply p_tends|].
    intros n. left. destruct (unending_now r a R1 A1 _ _ (H n)) as [Xn Gn].
    now apply (p_positive r a R1 A1). }
  assert (W0 : 0 < width rho x).
  { unfold width. assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra).
    apply Rmult_lt_0_compat; lra. }
  pose proof (h_range b B) as HB.
  assert (PX' : 0 < p a rho x).
  { destruct (Rle_lt_or_eq_dec _ _ PX) as [L|E]; [exact L|]. rewrite <- E in W. lra. }
  assert (PP : 0 < p a rho x ^ 2) by (apply pow_lt; lra).
  split; [|split; [exact PX'|fold (width rho x); nra]].
  split; [exact Q|]. split; [exact U|]. unfold p in PX'.
  assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra). nra.
Qed.
Lemma unending_limit rho X x : 0 < rho -> 0 <= q x -> 0 < u x ->
  (forall n, unending r a rho (X n)) -> tends X x -> unending r a rho x.
Proof.
  intros P Q U H T.
  apply (unending_if r a R1 A1 (fun rho x => 0 <= q x /\ 0 < u x /\
    exists X, (forall n, unending r a rho (X n)) /\ tends X x)); [|exact P|eauto].
  clear rho X x P Q U H T. intros rho x P [Q [U [X [H T]]]].
  destruct (goes_on_limit rho X x P Q U H T) as [HX G]. split; [exact HX|]. split; [exact G|].
  destruct (next_region r a R1 A1 rho x P HX G) as [NQ NU].
  split; [exact NQ|]. split; [apply NU|]. exists (fun n => next r a rho (X n)). split.
  - intros n. now apply unending_next.
  - now apply next_tends.
Qed.

(* --- neighbourhoods --------------------------------------------------------------------------- *)

Definition interior (rho : R) (x : state) :=
  exists e, 0 < e /\ unending r a rho (State (q x + e) (u x + e)).

Lemma interior_if_next_below rho x y : 0 < rho -> region x -> goes_on a rho x ->
  unending r a (/ rho) y -> q (next r a rho x) < q y -> u (next r a rho x) < u y ->
  interior rho x.
Proof.
  intros P X G H LQ LU. pose proof (p_positive r a R1 A1 rho x P X G) as PX.
  pose proof (next_q r a R1 A1 rho x P X G) as NQ. pose proof (next_h r a R1 A1 rho x P X G) as NH.
  pose proof (next_u_range r a R1 A1 rho x P X G) as NU.
  destruct (unending_now _ _ R1 A1 _ _ H) as [Y _]. destruct Y as [Y0 [Y1 Y2]].
  pose proof X as [X0 [X1 X2]].
  set (m := 1 + a + rho). set (c := h (u y)).
  assert (C : h (u (next r a rho x)) < c < 1) by (unfold c, h; split; nra).
  destruct (small (1 - u x) (-1) 0) as [e1 [E1 F1]]; [lra|].
  destruct (small (p a rho x) (- m) 0) as [e2 [E2 F2]]; [lra|].
  destruct (small (q y * p a rho x - r * (1 - u x)) (r - q y * m) 0) as [e3 [E3 F3]];
    [rewrite <- NQ; nra|].
  destruct (small (c * p a rho x ^ 2 - width rho x)
    (- 2 * c * p a rho x * m - rho * (2 * q x + rho * u x) - rho * u x * (2 + rho))
    (c * m ^ 2 - rho * (2 + rho))) as [e4 [E4 F4]].
  { rewrite <- NH. assert (0 < p a rho x ^ 2) by (apply pow_lt; lra). nra. }
  set (e := Rmin (Rmin e1 e2) (Rmin e3 e4)).
  assert (E : 0 < e /\ e <= e1 /\ e <= e2 /\ e <= e3 /\ e <= e4).
  { unfold e. pose proof (Rmin_l e1 e2). pose proof (Rmin_r e1 e2). pose proof (Rmin_l e3 e4).
    pose proof (Rmin_r e3 e4). pose proof (Rmin_l (Rmin e1 e2) (Rmin e3 e4)).
    pose proof (Rmin_r (Rmin e1 e2) (Rmin e3 e4)). split; [|lra]. repeat apply Rmin_glb_lt; lra. }
  destruct E as [E0 [L1 [L2 [L3 L4]]]]. exists e. split; [exact E0|].
  specialize (F1 e ltac:(lra)). specialize (F2 e ltac:(lra)). specialize (F3 e ltac:(lra)).
  specialize (F4 e ltac:(lra)). set (z := State (q x + e) (u x + e)).
  assert (Z : region z) by (unfold region, z; simpl; lra).
  assert (PE : p a rho z = p a rho x - m * e) by (unfold p, z, m; simpl; ring).
  assert (WE : c * p a rho z ^ 2 - width rho z = c * p a rho x ^ 2 - width rho x +
    (- 2 * c * p a rho x * m - rho * (2 * q x + rho * u x) - rho * u x * (2 + rho)) * e
    + (c * m ^ 2 - rho * (2 + rho)) * e ^ 2) by (rewrite PE; unfold width, z; simpl; ring).
  assert (PZ : 0 < p a rho z) by lra.
  assert (GZ : goes_on a rho z).
  { split; [exact PZ|]. fold (width rho z). assert (0 < p a rho z ^ 2) by (apply pow_lt; lra).
    nra. }
  apply unending_from_next; auto. apply unending_below with y; auto using inverse_positive.
  - now apply next_region.
  - split.
    + apply next_q_le; auto. rewrite PE. unfold z. simpl. nra.
    + apply next_u_le; auto. fold c. lra.
Qed.
(* What lies below a state of the set, and is another state. *)
Lemma interior_below rho x y : 0 < rho -> unending r a rho y -> region x -> below x y ->
  q x < q y \/ u x < u y -> interior rho x.
Proof.
  intros P H X B D. destruct (unending_now _ _ R1 A1 _ _ H) as [Y G].
  pose proof (goes_on_below r a R1 A1 rho x y P X Y B G) as GX.
  destruct (next_strictly_below r a R1 A1 rho x y P X Y B G D).
  apply interior_if_next_below with (next r a rho y); auto. now apply unending_next.
Qed.
(* The states whose image has a neighbourhood in the set. *)
Lemma interior_if_next rho x : 0 < rho -> region x -> goes_on a rho x ->
  interior (/ rho) (next r a rho x) -> interior rho x.
Proof.
  intros P X G [e [E H]].
  apply interior_if_next_below with (2 := X) (3 := G) (4 := H); simpl; lra.
Qed.
Lemma interior_if_later rho x n : 0 < rho -> unending r a rho x ->
  interior (ratio rho n) (orbit r a rho x n) -> interior rho x.
Proof.
  revert rho x. induction n; intros rho x P H I; [exact I|].
  destruct (unending_now _ _ R1 A1 _ _ H) as [X G]. apply interior_if_next; auto.
  rewrite ratio_shift, (orbit_shift r a R1 A1) in I.
  apply IHn; auto using inverse_positive, unending_next.
Qed.
End Topology.
