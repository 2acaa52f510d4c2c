(* Where collisions in turn end: what is proved of three equal balls. This page can be read after Theorem1.v
   and ThreeBalls.v; it proves nothing.

   Balls 0 and 1 have just met, and 2 may be next. If the numbers that are chosen satisfy the inequalities
   of certificates/outside, and a map of two numbers does not go on from the point to which it comes after
   N steps, then no trajectory has N + 2 collisions in turn, of 0 with 2, 1, 2, ... *)
From Coq Require Import Reals Arith.
From Verify Require Import Theorem1 ThreeBalls.
Open Scope R_scope.

(* Two balls touch, and approach each other. *)
Definition strike d (s : scene) (i j : ball) : Prop := distance d s i j = 1 /\ rate d s i j < 0.
(* One collision: if two balls that are apart strike after free flight, then they approach from the
   beginning; zeta, which tells how near they pass, is below 1; and the time is the first at which they touch. *)
Definition closing_of d (s : scene) i j : R := - rate d s i j / distance d s i j.
Definition zeta_of d (s : scene) i j : R := let e := distance d s i j in
  (e ^ 2 - 1) / e ^ 2 * (dot d (relative s i j) (relative s i j) / closing_of d s i j ^ 2).
Definition next_theorem : Prop := forall d s i j t, 1 < distance d s i j -> 0 < t -> strike d (later t s) i j ->
  0 < closing_of d s i j /\ zeta_of d s i j < 1 /\
  t = (distance d s i j ^ 2 - 1) / distance d s i j / closing_of d s i j / (1 + sqrt (1 - zeta_of d s i j)).

Section Outside.
(* What is chosen: the relative speeds of each ball are between v and w, those of both at least slow; the
   distance of the next one is at most G, and minus the cosine of the angle at most C_most. *)
Variables r G slow C_most Q_0 U_0 : R.
Variables v w : ball -> R.
Definition below_alpha : R := (1 + r) / 2 * G * C_most.
Definition below_rho (n : nat) : R := (v (collides_with (S n)) / w (collides_with n)) ^ 2.
Fixpoint below (n : nat) : R * R :=
  match n with O => (Q_0, U_0) | S n => mapped below_alpha (below_rho n) r (below n) end.
(* The map does not go on from there. *)
Definition no_step (rho : R) (p : R * R) : Prop :=
  pace below_alpha rho p <= 0 \/ pace below_alpha rho p ^ 2 <= load rho p.
Definition stops (N : nat) : Prop := no_step (below_rho N) (below N).
(* N + 1 numbers by which this is decided: each is below where the map leads from the one before. *)
Definition floor (N : nat) (Q U : nat -> R) : Prop :=
  Q O <= Q_0 /\ U O <= U_0 /\ (forall n, (n <= N)%nat -> 0 <= Q n /\ 0 <= U n <= 1) /\
  (forall n, (n < N)%nat -> let p := (Q n, U n) in
    Q (S n) * pace below_alpha (below_rho n) p <= r * (1 - U n) /\
    U (S n) * (2 - U (S n)) * pace below_alpha (below_rho n) p ^ 2 <= load (below_rho n) p) /\
  no_step (below_rho N) (Q N, U N).

Definition bounds : Prop :=
  0 < r /\ 1 <= G /\ (1 + r) / 2 * G < 1 /\ 0 < slow /\ slow <= v B2 /\ slow <= v B1 /\ C_most <= 2 /\
  0 <= Q_0 /\ 0 <= U_0 < 1.
Variable d : nat.
Definition speed_at (s : scene) b : R := sqrt (dot d (relative s B0 b) (relative s B0 b)).
Definition starting (s : scene) : Prop :=
  distance d s B0 B1 = 1 /\
  let y := closing_of d s B0 B2 in let gap := distance d s B0 B2 - 1 in
  let gain := G / (1 - (1 + r) / 2 * G) in
  let turning := (w B2 + w B1 + 2 * y) * (G / slow / slow) / (1 - (1 + r) / 2 * G) in
  0 < gap /\ 0 < y /\ 0 < rate d s B0 B1 /\ Q_0 * y <= rate d s B0 B1 /\
  U_0 * (2 - U_0) * (1 + gap) ^ 2 * y ^ 2 <= gap * (2 + gap) * v B2 ^ 2 /\
  y ^ 2 * G ^ 2 <= slow ^ 2 * (G ^ 2 - 1) /\
  v B2 + gain * y <= speed_at s B2 <= w B2 - gain * y /\
  v B1 + gain * y <= speed_at s B1 <= w B1 - gain * y /\
  0 <= C_most - turning * y /\ minus_cosine d s <= C_most - turning * y.

(* In the trajectory Z until the time T, ball 0 strikes 2, 1, 2, ... in turn at the first M of these times,
   with free flight in between. Other balls may graze each other meanwhile. *)
Definition strikes_in_turn (T : R) (Z : R -> scene) (time : nat -> R) (M : nat) : Prop :=
  time O = 0 /\ forall n, (n < M)%nat -> time n < time (S n) < T /\
    (forall t, time n <= t < time (S n) -> Z t = later (t - time n) (Z (time n))) /\
    strike d (later (time (S n) - time n) (Z (time n))) B0 (collides_with n).
End Outside.

Definition outside_theorem : Prop :=
  forall d r G slow C_most Q_0 U_0 v w s N,
  bounds r G slow C_most Q_0 U_0 v -> starting r G slow C_most Q_0 U_0 v w d s ->
  stops r G C_most Q_0 U_0 v w N ->
  forall T Z time, trajectory d r s T Z -> ~ strikes_in_turn d T Z time (S (S N)).
Definition floor_theorem : Prop :=
  forall r G slow C_most Q_0 U_0 v w N Q U,
  bounds r G slow C_most Q_0 U_0 v -> 0 <= C_most -> floor r G C_most Q_0 U_0 v w N Q U ->
  exists M, (M <= N)%nat /\ stops r G C_most Q_0 U_0 v w M.
(* So such scenes do not collapse. *)
Definition no_collapse_theorem : Prop :=
  forall d r G slow C_most Q_0 U_0 v w s N,
  bounds r G slow C_most Q_0 U_0 v -> starting r G slow C_most Q_0 U_0 v w d s ->
  stops r G C_most Q_0 U_0 v w N ->
  forall by_time c tolerance, ~ collapse d r s by_time c tolerance.
