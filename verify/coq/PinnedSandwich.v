(* The sandwich theorem, spelled out once more, with the words of Pinned.v and the map of
   PinnedThreeBalls.v. A reader compares it with the statement of certificates/sandwich; and if Sandwich.v
   comes to say less, the proofs at the end fail. *)
From Verify Require Import Pinned.
From Verify Require PinnedThreeBalls Determined Sandwich SandwichProof.
From Coq Require Import Reals Arith Lra.
Open Scope R_scope.
Definition B1 : ball := Pinned.B1.  (* Coq has another one *)

(* After n collisions ball 0 meets this ball next; and it has just met that one. *)
Definition c_ (n : nat) : ball := if Nat.even n then B2 else B1.
Definition s_ (n : nat) : ball := if Nat.even n then B1 else B2.
Section PinnedSandwich.
Variables r G slow U_b C_0 Theta Q_0 U_0 : R.
Variable w : ball -> R.
Definition alpha : R := (1 + r) / 2 * (C_0 - Theta).
Definition rho (n : nat) : R := G * (w (s_ n) / w (c_ n)) ^ 2.
Fixpoint orbit (n : nat) : R * R :=
  match n with O => (Q_0, U_0) | S n => PinnedThreeBalls.next alpha (rho n) (r * G) (orbit n) end.
Definition endless_map : Prop := forall n, let P := PinnedThreeBalls.P alpha (rho n) (orbit n) in
  0 < P /\ PinnedThreeBalls.L (rho n) (orbit n) <= U_b * (2 - U_b) * P ^ 2.
(* N + 3 numbers by which this is decided: each is above where the map leads from the one before. *)
Definition stairs (N : nat) (Q U : nat -> R) : Prop :=
  0 <= Q_0 <= Q O /\ 0 <= U_0 <= U O /\
  (forall n, (n <= S N)%nat -> let P := PinnedThreeBalls.P alpha (rho n) (Q n, U n) in
    0 <= Q n /\ 0 <= U n <= U_b /\ 0 <= U (S n) <= U_b /\ 0 < P /\
    r * G * (1 - U n) <= Q (S n) * P /\
    PinnedThreeBalls.L (rho n) (Q n, U n) <= U (S n) * (2 - U (S n)) * P ^ 2) /\
  Q (S (S N)) <= Q N /\ U (S (S N)) <= U N.
Definition numbers : Prop :=
  0 < r /\ 1 <= G /\ (1 + r) / 2 * G < 1 /\ 0 < slow /\ slow <= w B2 /\ slow <= w B1 /\
  U_0 <= U_b < 1 /\ Theta < C_0 <= 1.
(* The speed at which 2 approaches. *)
Definition closing d (x v : ball -> nat -> R) : R := - rate d x v B0 B2 / distance d x B0 B2.
Definition start d (x v : ball -> nat -> R) : Prop :=
  let y := closing d x v in let gap := distance d x B0 B2 - 1 in
  let fall := (1 + r) / 2 * G in let gain := fall / (1 - fall ^ 2) in
  let speed b := sqrt (dot d (from_to v B0 b) (from_to v B0 b)) in
  distance d x B0 B1 = 1 /\ 0 < gap /\ 0 < y /\ 0 < rate d x v B0 B1 <= Q_0 * y /\
  gap * (2 + gap) * w B2 ^ 2 <= U_0 * (2 - U_0) * (1 + gap) ^ 2 * y ^ 2 /\
  U_b * (2 - U_b) * y ^ 2 * G ^ 2 <= slow ^ 2 * (G ^ 2 - 1) /\
  speed B2 <= w B2 - fall * gain * y /\ speed B1 <= w B1 - gain * y /\
  Rabs (minus_cosine d x - C_0) + (w B2 + w B1 + y) * (G * U_b / slow / slow) / (1 - fall) * y <= Theta.
End PinnedSandwich.

Definition sandwich_theorem : Prop :=
  forall d r G slow U_b C_0 Theta Q_0 U_0 w x v,
  numbers r G slow U_b C_0 Theta U_0 w -> endless_map r G U_b C_0 Theta Q_0 U_0 w ->
  start r G slow U_b C_0 Theta Q_0 U_0 w d x v ->
  collapse d r x v (G * U_b / slow / slow / (1 - (1 + r) / 2 * G) * closing d x v) C_0 Theta.
Definition stairs_theorem : Prop :=
  forall r G U_b C_0 Theta Q_0 U_0 w N Q U, 0 < r -> 1 <= G -> U_b < 1 -> Theta < C_0 ->
  stairs r G U_b C_0 Theta Q_0 U_0 w N Q U -> endless_map r G U_b C_0 Theta Q_0 U_0 w.

(* --- Sandwich.v says this ----------------------------------------------------------------------------- *)

Theorem sandwich_theorem_proved : sandwich_theorem.
Proof.
  intros d r G slow U_b C_0 Theta Q_0 U_0 w x v B M S.
  apply same_collapse; [exact Determined.trajectories_are_determined|].
  exact (SandwichProof.sandwich_theorem_holds d r G slow U_b C_0 Theta Q_0 U_0 w (placed x v) B M S).
Qed.
Theorem stairs_theorem_proved : stairs_theorem.
Proof. exact SandwichProof.inner_stair_theorem_holds. Qed.
Theorem sandwich_proved : sandwich_theorem /\ stairs_theorem.
Proof. exact (conj sandwich_theorem_proved stairs_theorem_proved). Qed.
(* It is about something: balls in the plane. *)
Theorem somewhere : exists x v, (fun r G slow U_b C_0 Theta Q_0 U_0 w =>
  numbers r G slow U_b C_0 Theta U_0 w /\ endless_map r G U_b C_0 Theta Q_0 U_0 w /\
  start r G slow U_b C_0 Theta Q_0 U_0 w 2 x v)
  (2 / 100) (1001 / 1000) (9 / 10) (1 / 10) (19 / 20) (6 / 100) (6 / 100) (2 / 100) (fun _ => 11 / 10).
Proof.
  exists (fun b i => match b, i with Theorem1.B1, O => -1 | Theorem1.B2, O => 100000001 / 100000000 | _, _ => 0 end),
    (fun b i => match b, i with Theorem1.B1, O => - (5 / 100000) | Theorem1.B1, S O => 1
      | Theorem1.B2, O => - (1 / 1000) | Theorem1.B2, S O => 1 | _, _ => 0 end).
  match goal with |- context [start _ _ _ _ _ _ _ _ _ _ ?x' ?v'] => set (x := x'); set (v := v') end.
  assert (root : forall s q, 0 <= q -> s = q ^ 2 -> sqrt s = q) by (intros s q Q ->; now apply sqrt_pow2).
  assert (D1 : distance 2 x B0 B1 = 1) by (apply root; [|unfold x, dot, from_to, B0, B1, Pinned.B1]; lra).
  assert (D2 : distance 2 x B0 B2 = 100000001 / 100000000) by (apply root; [|unfold x, dot, from_to, B0, B2]; lra).
  assert (R1 : rate 2 x v B0 B1 = 5 / 100000) by (unfold rate, x, v, dot, from_to, B0, B1, Pinned.B1; lra).
  assert (R2 : rate 2 x v B0 B2 = - (100000001 / 100000000 / 1000)) by (unfold rate, x, v, dot, from_to, B0, B2; lra).
  assert (Y : closing 2 x v = 1 / 1000) by (unfold closing; rewrite R2, D2; lra).
  assert (C : minus_cosine 2 x = 1).
  { unfold minus_cosine. change Pinned.B1 with B1. rewrite D1, D2. unfold x, dot, from_to, B0, B1, B2, Pinned.B1. lra. }
  assert (most : forall s high, s <= high ^ 2 -> 0 <= high -> sqrt s <= high).
  { intros s high A H. rewrite <- (sqrt_pow2 high H). now apply sqrt_le_1_alt. }
  split; [|split].
  - unfold numbers. lra.
  - apply (stairs_theorem_proved (2 / 100) (1001 / 1000) (1 / 10) (19 / 20) (6 / 100) (6 / 100) (2 / 100) _ O
      (fun _ => 6 / 100) (fun _ => 2 / 100)); try lra.
    unfold stairs. split; [lra|]. split; [lra|]. split; [|lra].
    intros [|[|n]] N; [| |exfalso; inversion N; inversion H0];
      cbv beta zeta; unfold PinnedThreeBalls.P, PinnedThreeBalls.L, alpha, rho; cbn [fst snd]; lra.
  - unfold start. cbv beta zeta. rewrite D1, D2, R1, Y, C, Rabs_right by lra.
    repeat (split; [first [lra | apply most; [unfold v, dot, from_to, B0, B1, B2, Pinned.B1|]; lra]|]). lra.
Qed.
Print Assumptions sandwich_proved.
