(* The sandwich theorem in the givens of certificates/sandwich. This page can be read after Theorem1.v and
   ThreeBalls.v; it proves nothing. *)
From Coq Require Import Reals Arith.
From Verify Require Import Theorem1 ThreeBalls.
Open Scope R_scope.

Section Sandwich.
Variables r G slow U_most C_0 Theta Q_0 U_0 : R.
Variable w : ball -> R.
Let alpha := (1 + r) / 2 * (C_0 - Theta).
Definition inner_rho (n : nat) : R := G * (w (last_ball B1 B2 n) / w (next_ball B1 B2 n)) ^ 2.
Fixpoint inner (n : nat) : R * R :=
  match n with O => (Q_0, U_0) | S n => mapped alpha (inner_rho n) (r * G) (inner n) end.
Definition inner_goes_on : Prop := forall n, 0 < pace alpha (inner_rho n) (inner n) /\
  load (inner_rho n) (inner n) <= U_most * (2 - U_most) * pace alpha (inner_rho n) (inner n) ^ 2.
(* It does if it begins below finitely many numbers, the last two below the first two. *)
Definition inner_stair (N : nat) (Q U : nat -> R) : Prop :=
  0 <= Q_0 <= Q O /\ 0 <= U_0 <= U O /\
  (forall n, (n <= S N)%nat ->
    above alpha (inner_rho n) (r * G) U_most (Q n) (U n) (Q (S n)) (U (S n))) /\
  Q (S (S N)) <= Q N /\ U (S (S N)) <= U N.
Definition inner_bounds : Prop :=
  0 < r /\ 1 <= G /\ (1 + r) / 2 * G < 1 /\ 0 < slow /\ slow <= w B2 /\ slow <= w B1 /\
  U_0 <= U_most < 1 /\ Theta < C_0 <= 1.
Definition inner_starts (d : nat) (s : scene) : Prop :=
  let y := - rate d s B0 B2 / distance d s B0 B2 in let gap := distance d s B0 B2 - 1 in
  let fall := (1 + r) / 2 * G in let gain := fall / (1 - fall ^ 2) in
  let speed b := sqrt (dot d (relative s B0 b) (relative s B0 b)) in
  distance d s B0 B1 = 1 /\ 0 < gap /\ 0 < y /\ 0 < rate d s B0 B1 <= Q_0 * y /\
  gap * (2 + gap) * w B2 ^ 2 <= U_0 * (2 - U_0) * (1 + gap) ^ 2 * y ^ 2 /\
  U_most * (2 - U_most) * y ^ 2 * G ^ 2 <= slow ^ 2 * (G ^ 2 - 1) /\
  speed B2 <= w B2 - fall * gain * y /\ speed B1 <= w B1 - gain * y /\
  Rabs (minus_cosine d s - C_0) + (w B2 + w B1 + y) * (G * U_most / slow / slow) / (1 - fall) * y <= Theta.
End Sandwich.
Definition sandwich_theorem : Prop :=
  forall d r G slow U_most C_0 Theta Q_0 U_0 w s,
  inner_bounds r G slow U_most C_0 Theta U_0 w -> inner_goes_on r G U_most C_0 Theta Q_0 U_0 w ->
  inner_starts r G slow U_most C_0 Theta Q_0 U_0 w d s ->
  collapse d r s (G * U_most / slow / slow / (1 - (1 + r) / 2 * G) * (- rate d s B0 B2 / distance d s B0 B2))
    C_0 Theta.
Definition inner_stair_theorem : Prop :=
  forall r G U_most C_0 Theta Q_0 U_0 w N Q U, 0 < r -> 1 <= G -> U_most < 1 -> Theta < C_0 ->
  inner_stair r G U_most C_0 Theta Q_0 U_0 w N Q U -> inner_goes_on r G U_most C_0 Theta Q_0 U_0 w.
