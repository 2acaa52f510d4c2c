(* The theorem on the separatrix once more, with Coq's own real numbers: this file fails to compile if
   Separatrix.v comes to say anything else. Nothing is imported from there but the names of a state
   and of its two numbers. *)
From Coq Require Import Reals Arith.
From Verify Require Separatrix.
Open Scope R_scope.

Definition state := Separatrix.state.
Definition State (y v : R) : state := Separatrix.State y v.
Definition q (x : state) : R := Separatrix.q x.
Definition u (x : state) : R := Separatrix.u x.
Check (fun y v => eq_refl : (q (State y v), u (State y v)) = (y, v)).

(* --- the map ---------------------------------------------------------------------------------- *)

Definition region (x : state) : Prop := 0 <= q x /\ 0 < u x < 1.
Definition p a rho (x : state) : R := a * (1 - u x) - q x - rho * u x.
Definition goes_on a rho (x : state) : Prop :=
  0 < p a rho x /\ rho * u x * (2 * q x + rho * u x) < p a rho x ^ 2.
Definition next r a rho (x : state) : state := State (r * (1 - u x) / p a rho x)
  (1 - sqrt (1 - rho * u x * (2 * q x + rho * u x) / p a rho x ^ 2)).
(* With rho, 1/rho, rho, 1/rho, ... in turn. *)
Definition ratio (rho : R) (n : nat) : R := if Nat.even n then rho else / rho.
Section PinnedOrbit.
Variables r a : R.
Fixpoint orbit (rho : R) (x : state) (n : nat) : state :=
  match n with O => x | S k => next r a (ratio rho k) (orbit rho x k) end.
End PinnedOrbit.

(* --- what becomes of an orbit ----------------------------------------------------------------- *)

Definition unending r a rho x : Prop :=
  region x /\ forall n, goes_on a (ratio rho n) (orbit r a rho x n).
Definition ends r a rho x : Prop := exists n, ~ goes_on a (ratio rho n) (orbit r a rho x n).
Definition vanishing r a rho x : Prop := Un_cv (fun n => u (orbit r a rho x n)) 0.
Definition regime r a rho x : Prop := unending r a rho x /\ vanishing r a rho x /\
  Un_cv (fun n => q (orbit r a rho x n)) ((a - sqrt (a ^ 2 - 4 * r)) / 2).
Definition phi_plus r a : R := (a + sqrt (a ^ 2 - 4 * r)) / 2.
Definition cycle r a rho x : Prop := unending r a rho x /\ orbit r a rho x 2 = x.
Definition tends_to r a rho x y : Prop :=
  Un_cv (fun n => q (orbit r a rho x n) - q (orbit r a rho y n)) 0 /\
  Un_cv (fun n => u (orbit r a rho x n) - u (orbit r a rho y n)) 0.

(* --- the theorem ------------------------------------------------------------------------------ *)

Definition separatrix_theorem : Prop :=
  forall r a rho s, 0 < r < 1 -> 0 < a -> 0 < rho -> 0 < s -> s ^ 3 = r ->
  (forall x y, unending r a rho y -> 0 <= q x <= q y -> 0 < u x <= u y -> x <> y ->
    regime r a rho x) /\
  ((exists x, unending r a rho x) <-> s + s ^ 2 < a) /\
  (s + s ^ 2 < a -> exists (f : R -> R) (c : state),
    (forall x e, 0 <= x -> 0 < e ->
      exists d, 0 < d /\ forall y, 0 <= y -> Rabs (y - x) < d -> Rabs (f y - f x) < e) /\
    (forall x y k, 0 <= x -> 0 <= y -> 0 <= k <= 1 ->
      f (k * x + (1 - k) * y) <= k * f x + (1 - k) * f y) /\
    (forall y, 0 <= y -> 0 <= f y <= a / (a + rho)) /\
    (forall y, 0 <= y < phi_plus r a -> 0 < f y) /\
    (forall y z, 0 <= y < z -> z <= phi_plus r a -> f z < f y) /\
    (forall y, phi_plus r a <= y -> f y = 0) /\
    (forall x, region x -> u x < f (q x) -> regime r a rho x) /\
    (forall x, region x -> f (q x) < u x -> ends r a rho x) /\
    (forall x, region x -> u x = f (q x) ->
      unending r a rho x /\ ~ vanishing r a rho x /\ tends_to r a rho x c) /\
    (forall x, cycle r a rho x <-> x = c) /\ u c = f (q c) /\
    (rho = 1 -> next r a rho c = c)).
Check (eq_refl : Separatrix.separatrix_theorem = separatrix_theorem).

(* What the certificate of the separatrix takes on trust and has no proof: limit-map and unending. *)
Check (fun a rho x => eq_refl : Separatrix.p a rho x = p a rho x).
Check (fun a rho x => eq_refl : Separatrix.goes_on a rho x = goes_on a rho x).
Check (fun r a rho x => eq_refl : Separatrix.next r a rho x = next r a rho x).
Check (fun r a rho x => eq_refl : Separatrix.unending r a rho x = unending r a rho x).
