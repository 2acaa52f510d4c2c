(* Where the collisions in turn of three equal balls end, spelled out once more, with the words of Pinned.v
   and the map of PinnedThreeBalls.v. A reader compares it with the statement of certificates/outside and
   with the prose; and if Outside.v comes to say less, the proofs at the end fail. *)
From Verify Require Import Pinned.
From Verify Require PinnedThreeBalls Theorem1 Determined Outside OutsideStep OutsideProof.
From Coq Require Import Reals Arith Lra Lia.
Open Scope R_scope.
Definition B1 : ball := Pinned.B1.  (* Coq has another one *)

(* --- one collision ---------------------------------------------------------------------------------- *)

(* Two balls touch, and approach each other. *)
Definition strike d x v (i j : ball) : Prop := distance d x i j = 1 /\ rate d x v i j < 0.
(* The speed at which two balls that are apart approach; and how near they will pass: the square of the
   least distance that they would have is below 1 if and only if zeta is. *)
Definition closing d x v i j : R := - rate d x v i j / distance d x i j.
Definition zeta d x v i j : R := let e := distance d x i j in
  (e ^ 2 - 1) / e ^ 2 * (dot d (from_to v i j) (from_to v i j) / closing d x v i j ^ 2).
(* Two balls that are apart strike after free flight only if these numbers say so, and only at this time. *)
Definition next_theorem : Prop := forall d x v i j t,
  1 < distance d x i j -> 0 < t -> strike d (moved t x v) v i j ->
  0 < closing d x v i j /\ zeta d x v i j < 1 /\
  t = (distance d x i j ^ 2 - 1) / distance d x i j / closing d x v i j / (1 + sqrt (1 - zeta d x v i j)).

(* --- the map of two numbers Q and U ----------------------------------------------------------------- *)

(* After n collisions ball 0 meets this ball next, and it has just met the other one. *)
Definition c_ (n : nat) : ball := if Nat.even n then B2 else B1.
Definition s_ (n : nat) : ball := if Nat.even n then B1 else B2.
Section PinnedOutside.
Variables r G slow C_most Q_0 U_0 : R.
Variables v_ w_ : ball -> R.
Definition alpha : R := (1 + r) / 2 * G * C_most.
Definition rho (n : nat) : R := (v_ (s_ n) / w_ (c_ n)) ^ 2.
Fixpoint orbit (n : nat) : R * R :=
  match n with O => (Q_0, U_0) | S n => PinnedThreeBalls.next alpha (rho n) r (orbit n) end.
Definition ends (rho : R) (p : R * R) : Prop :=
  PinnedThreeBalls.P alpha rho p <= 0 \/ PinnedThreeBalls.P alpha rho p ^ 2 <= PinnedThreeBalls.L rho p.
Definition map_ends (N : nat) : Prop := ends (rho N) (orbit N).
(* N + 1 numbers by which this is decided: each is below where the map leads from the one before. *)
Definition floor (N : nat) (Q U : nat -> R) : Prop :=
  Q O <= Q_0 /\ U O <= U_0 /\ (forall n, (n <= N)%nat -> 0 <= Q n /\ 0 <= U n <= 1) /\
  (forall n, (n < N)%nat -> let P := PinnedThreeBalls.P alpha (rho n) (Q n, U n) in
    Q (S n) * P <= r * (1 - U n) /\ U (S n) * (2 - U (S n)) * P ^ 2 <= PinnedThreeBalls.L (rho n) (Q n, U n)) /\
  ends (rho N) (Q N, U N).

(* The givens of the certificate: of the numbers alone, and of the places x and the velocities v. *)
Definition numbers : Prop :=
  0 < r /\ 1 <= G /\ (1 + r) / 2 * G < 1 /\ 0 < slow /\ slow <= v_ B2 /\ slow <= v_ B1 /\ C_most <= 2 /\
  0 <= Q_0 /\ 0 <= U_0 < 1.
Definition speed d (v : ball -> nat -> R) b : R := sqrt (dot d (from_to v B0 b) (from_to v B0 b)).
Definition start d (x v : ball -> nat -> R) : Prop :=
  distance d x B0 B1 = 1 /\
  let y := closing d x v B0 B2 in let eta := rate d x v B0 B1 in
  let gap := distance d x B0 B2 - 1 in let gain := G / (1 - (1 + r) / 2 * G) in
  let turning := (w_ B2 + w_ B1 + 2 * y) * (G / slow / slow) / (1 - (1 + r) / 2 * G) in
  0 < gap /\ 0 < y /\ 0 < eta /\ Q_0 * y <= eta /\
  U_0 * (2 - U_0) * (1 + gap) ^ 2 * y ^ 2 <= gap * (2 + gap) * v_ B2 ^ 2 /\
  y ^ 2 * G ^ 2 <= slow ^ 2 * (G ^ 2 - 1) /\
  v_ B2 + gain * y <= speed d v B2 <= w_ B2 - gain * y /\
  v_ B1 + gain * y <= speed d v B1 <= w_ B1 - gain * y /\
  0 <= C_most - turning * y /\ minus_cosine d x <= C_most - turning * y.
End PinnedOutside.

(* --- trajectories ------------------------------------------------------------------------------------ *)

(* In the trajectory X, V until the time T, ball 0 strikes 2, 1, 2, ... in turn, at the times of which the
   first is time 1 and the last time M, with free flight in between. *)
Definition strikes_in_turn d T (X V : R -> ball -> nat -> R) (time : nat -> R) (M : nat) : Prop :=
  time O = 0 /\ forall n, (n < M)%nat -> time n < time (S n) < T /\
    (forall t, time n <= t < time (S n) ->
      X t = moved (t - time n) (X (time n)) (V (time n)) /\ V t = V (time n)) /\
    strike d (moved (time (S n) - time n) (X (time n)) (V (time n))) (V (time n)) B0 (c_ n).

(* If the map does not go on after N steps, then no trajectory has N + 2 collisions in turn. *)
Definition outside_theorem : Prop :=
  forall d r G slow C_most Q_0 U_0 v_ w_ x v N,
  numbers r G slow C_most Q_0 U_0 v_ -> start r G slow C_most Q_0 U_0 v_ w_ d x v ->
  map_ends r G C_most Q_0 U_0 v_ w_ N ->
  forall T X V time, trajectory d r x v T X V -> ~ strikes_in_turn d T X V time (N + 2).
(* That it does not go on is shown by a floor. *)
Definition floor_theorem : Prop :=
  forall r G slow C_most Q_0 U_0 v_ w_ N Q U,
  numbers r G slow C_most Q_0 U_0 v_ -> 0 <= C_most -> floor r G C_most Q_0 U_0 v_ w_ N Q U ->
  exists M, (M <= N)%nat /\ map_ends r G C_most Q_0 U_0 v_ w_ M.
(* And so these balls do not collapse, as Pinned.v defines it, by any time and at any angle. *)
Definition no_collapse : Prop :=
  forall d r G slow C_most Q_0 U_0 v_ w_ x v N,
  numbers r G slow C_most Q_0 U_0 v_ -> start r G slow C_most Q_0 U_0 v_ w_ d x v ->
  map_ends r G C_most Q_0 U_0 v_ w_ N ->
  forall by_time c tolerance, ~ collapse d r x v by_time c tolerance.

(* --- Outside.v says this ------------------------------------------------------------------------------ *)

Theorem next_theorem_proved : next_theorem.
Proof. intros d x v i j t. exact (OutsideStep.next_theorem_holds d (placed x v) i j t). Qed.
Lemma same_rho v_ w_ n : rho v_ w_ n = Outside.below_rho v_ w_ n.
Proof.
  unfold rho, Outside.below_rho, s_, c_, Theorem1.collides_with. rewrite Nat.even_succ, <- Nat.negb_even.
  now destruct (Nat.even n).
Qed.
Lemma same_orbit r G C_most Q_0 U_0 v_ w_ n :
  orbit r G C_most Q_0 U_0 v_ w_ n = Outside.below r G C_most Q_0 U_0 v_ w_ n.
Proof. induction n as [|n IH]; [reflexivity|]. cbn [orbit Outside.below]. rewrite IH, same_rho. reflexivity. Qed.
Lemma same_ends r G C_most Q_0 U_0 v_ w_ n :
  map_ends r G C_most Q_0 U_0 v_ w_ n <-> Outside.stops r G C_most Q_0 U_0 v_ w_ n.
Proof. unfold map_ends, Outside.stops. rewrite same_rho, same_orbit. reflexivity. Qed.
Theorem outside_theorem_proved : outside_theorem.
Proof.
  intros d r G slow C_most Q_0 U_0 v_ w_ x v N K S E T X V time P [T0 F].
  apply same_ends in E. apply same_trajectory in P.
  apply (OutsideProof.outside_theorem_holds d r G slow C_most Q_0 U_0 v_ w_ (placed x v) N K S E T _ time P).
  split; [exact T0|]. intros n L. destruct (F n ltac:(lia)) as (H1 & H2 & H3). split; [exact H1|].
  split; [|exact H3]. intros t H. destruct (H2 t H) as [E1 E2]. now rewrite E1, E2.
Qed.
Theorem floor_theorem_proved : floor_theorem.
Proof.
  intros r G slow C_most Q_0 U_0 v_ w_ N Q U K C (F1 & F2 & F3 & F4 & F5).
  destruct (OutsideProof.floor_theorem_holds r G slow C_most Q_0 U_0 v_ w_ N Q U K C) as (M & L & E).
  - split; [exact F1|]. split; [exact F2|]. split; [exact F3|]. split.
    + intros n H. rewrite <- same_rho. exact (F4 n H).
    + rewrite <- same_rho. exact F5.
  - exists M. split; [exact L|]. now apply same_ends.
Qed.
Theorem no_collapse_proved : no_collapse.
Proof.
  intros d r G slow C_most Q_0 U_0 v_ w_ x v N K S E by_time c tolerance H. apply same_ends in E.
  apply (same_collapse d r x v by_time c tolerance Determined.trajectories_are_determined) in H.
  exact (OutsideProof.no_collapse_theorem_holds d r G slow C_most Q_0 U_0 v_ w_ (placed x v) N K S E
    by_time c tolerance H).
Qed.

(* --- what is proved ----------------------------------------------------------------------------------- *)

Theorem outside_proved : next_theorem /\ outside_theorem /\ floor_theorem /\ no_collapse.
Proof.
  exact (conj next_theorem_proved (conj outside_theorem_proved (conj floor_theorem_proved no_collapse_proved))).
Qed.
(* It is about something: balls in the plane of which 2 does approach 0, and the map ends after one step. *)
Definition somewhere_in (holds : R -> R -> R -> R -> R -> R -> (ball -> R) -> (ball -> R) -> Prop) : Prop :=
  holds (3 / 100) (1001 / 1000) (9 / 10) (1006 / 1000) (1 / 10) (13 / 100) (fun _ => 9 / 10) (fun _ => 11 / 10).
Theorem somewhere : exists x v, somewhere_in (fun r G slow C_most Q_0 U_0 v_ w_ =>
  numbers r G slow C_most Q_0 U_0 v_ /\ start r G slow C_most Q_0 U_0 v_ w_ 2 x v /\
  (exists M, (M <= 1)%nat /\ map_ends r G C_most Q_0 U_0 v_ w_ M) /\ ~ map_ends r G C_most Q_0 U_0 v_ w_ 0) /\
  1 < distance 2 x B0 B2 /\ exists t, 0 < t /\ strike 2 (moved t x v) v B0 B2.
Proof.
  exists (fun b i => match b, i with Theorem1.B1, O => -1 | Theorem1.B2, O => 64000015 / 64000001 | _, _ => 0 end),
    (fun b i => match b, i with Theorem1.B1, O => - (1 / 10000) | Theorem1.B1, S O => 1
      | Theorem1.B2, O => - (1 / 1000) | Theorem1.B2, S O => 1 | _, _ => 0 end).
  match goal with |- somewhere_in (fun _ _ _ _ _ _ _ _ => _ /\ start _ _ _ _ _ _ _ _ _ ?x' ?v' /\ _) /\ _ =>
    set (x := x'); set (v := v') end.
  assert (root : forall s q, 0 <= q -> s = q ^ 2 -> sqrt s = q) by (intros s q Q ->; now apply sqrt_pow2).
  assert (D1 : distance 2 x B0 B1 = 1) by (apply root; [|unfold x, dot, from_to, B0, B1, Pinned.B1]; lra).
  assert (D2 : distance 2 x B0 B2 = 64000015 / 64000001) by (apply root; [|unfold x, dot, from_to, B0, B2]; lra).
  assert (R1 : rate 2 x v B0 B1 = 1 / 10000) by (unfold rate, x, v, dot, from_to, B0, B1, Pinned.B1; lra).
  assert (R2 : rate 2 x v B0 B2 = - (64000015 / 64000001 / 1000)) by (unfold rate, x, v, dot, from_to, B0, B2; lra).
  assert (Y : closing 2 x v B0 B2 = 1 / 1000) by (unfold closing; rewrite R2, D2; lra).
  assert (C : minus_cosine 2 x = 1).
  { unfold minus_cosine. change Pinned.B1 with B1. rewrite D1, D2. unfold x, dot, from_to, B0, B1, B2, Pinned.B1. lra. }
  assert (between : forall s low high, 0 <= low -> low ^ 2 <= s <= high ^ 2 -> 0 <= high -> low <= sqrt s <= high).
  { intros s low high L [A B] H. split.
    - rewrite <- (sqrt_pow2 low L). now apply sqrt_le_1_alt.
    - rewrite <- (sqrt_pow2 high H). now apply sqrt_le_1_alt. }
  split; [unfold somewhere_in; split; [|split; [|split]]|split].
  - unfold numbers. lra.
  - unfold start. cbv beta zeta. rewrite D1, D2, R1, Y, C. split; [lra|].
    assert (V2 : forall low high, 0 <= low -> low ^ 2 <= 1000001 / 1000000 <= high ^ 2 -> 0 <= high ->
      low <= speed 2 v B2 <= high).
    { intros low high L A H. apply between; trivial. unfold v, dot, from_to, B0, B2. lra. }
    assert (V1 : forall low high, 0 <= low -> low ^ 2 <= 100000001 / 100000000 <= high ^ 2 -> 0 <= high ->
      low <= speed 2 v B1 <= high).
    { intros low high L A H. apply between; trivial. unfold v, dot, from_to, B0, B1, Pinned.B1. lra. }
    repeat (split; [first [lra | apply V1; lra | apply V2; lra]|]). lra.
  - apply (floor_theorem_proved (3 / 100) (1001 / 1000) (9 / 10) (1006 / 1000) (1 / 10) (13 / 100) _ _ 1%nat
      (fun _ => 98 / 1000) (fun n => match n with O => 13 / 100 | _ => 19 / 100 end)); [unfold numbers; lra | lra|].
    unfold floor, ends, PinnedThreeBalls.P, PinnedThreeBalls.L, alpha, rho. cbn [fst snd].
    split; [lra|]. split; [lra|]. split; [intros [] _; cbv beta iota; lra|]. split; [|right; lra].
    intros n H. assert (n = O) as -> by lia. cbv beta iota zeta. split; lra.
  - unfold map_ends, ends, PinnedThreeBalls.P, PinnedThreeBalls.L, alpha, rho, orbit. cbn [fst snd]. lra.
  - lra.
  - exists (16000 / 64000001). split; [lra|]. split.
    + apply root; [lra|]. unfold moved, x, v, dot, from_to, B0, B2. lra.
    + unfold rate, moved, x, v, dot, from_to, B0, B2. lra.
Qed.
Print Assumptions outside_proved.
