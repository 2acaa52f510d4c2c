(* The separatrix of the limit map: what the theorem says. This page can be read alone; it proves
   nothing. The proof is in the other files with this name; SeparatrixProof.v puts it together. It
   uses no certificate.

   Three balls collapse: ball 0 collides with the two others in turn. In the limit of small
   distances the state just after a collision is a pair of numbers. q >= 0, phi_1 in the letters of
   the paper, is the normal speed with which the pair that has just collided recedes, divided by
   the one with which the next pair approaches. 0 < u < 1 stands for the distance of the next pair:
   u (2 - u) = 2 phi_2 |W|^2, where W is its tangential velocity. *)
From Coq Require Import Reals Arith.
Open Scope R_scope.

Record state := State { q : R; u : R }.
Definition region (x : state) := 0 <= q x /\ 0 < u x < 1.

Section Map.
Variables r a : R.  (* the coefficient of restitution; (1+r)/2 times minus the cosine *)

(* --- the map: rho is |W|^2 of the pair that has collided, divided by |W|^2 of the next pair --- *)

(* The factor by which the normal speed shrinks. The next pair approaches if it is positive. *)
Definition p (rho : R) (x : state) := a * (1 - u x) - q x - rho * u x.
(* There is a next collision. *)
Definition goes_on (rho : R) (x : state) :=
  0 < p rho x /\ rho * u x * (2 * q x + rho * u x) < p rho x ^ 2.
(* The state after it; the second number is the v in [0, 1[ for which
   v (2 - v) = rho * u x * (2 * q x + rho * u x) / p rho x ^ 2. *)
Definition next (rho : R) (x : state) :=
  State (r * (1 - u x) / p rho x)
    (1 - sqrt (1 - rho * u x * (2 * q x + rho * u x) / p rho x ^ 2)).

(* The ratio is rho, 1/rho, rho, 1/rho, ... *)
Definition ratio (rho : R) (n : nat) := if Nat.even n then rho else / rho.
Fixpoint orbit (rho : R) (x : state) (n : nat) : state :=
  match n with O => x | S k => next (ratio rho k) (orbit rho x k) end.

(* --- what becomes of an orbit ----------------------------------------------------------------- *)

(* The collisions never end. *)
Definition unending (rho : R) (x : state) :=
  region x /\ forall n, goes_on (ratio rho n) (orbit rho x n).
(* They end. What next says after that means nothing. *)
Definition ends (rho : R) (x : state) := exists n, ~ goes_on (ratio rho n) (orbit rho x n).

(* The Zhou-Kadanoff regime: they never end, u tends to 0, q tends to phi_minus. *)
Definition phi_minus := (a - sqrt (a ^ 2 - 4 * r)) / 2.
Definition phi_plus := (a + sqrt (a ^ 2 - 4 * r)) / 2.
Definition vanishing (rho : R) (x : state) := Un_cv (fun n => u (orbit rho x n)) 0.
Definition regime (rho : R) (x : state) :=
  unending rho x /\ vanishing rho x /\ Un_cv (fun n => q (orbit rho x n)) phi_minus.

(* After two collisions the state is the same again. *)
Definition cycle (rho : R) (y : state) := unending rho y /\ orbit rho y 2 = y.
(* The orbits of x and of y come together. *)
Definition tends_to (rho : R) (x y : state) :=
  Un_cv (fun n => q (orbit rho x n) - q (orbit rho y n)) 0 /\
  Un_cv (fun n => u (orbit rho x n) - u (orbit rho y n)) 0.
End Map.

Definition continuous_from_0 (f : R -> R) :=
  forall x e, 0 <= x -> 0 < e ->
  exists d, 0 < d /\ forall y, 0 <= y -> Rabs (y - x) < d -> Rabs (f y - f x) < e.
Definition convex_from_0 (f : R -> R) :=
  forall x y c, 0 <= x -> 0 <= y -> 0 <= c <= 1 ->
  f (c * x + (1 - c) * y) <= c * f x + (1 - c) * f y.

(* --- the theorem ------------------------------------------------------------------------------ *)

(* s is the cube root of r. *)
Definition separatrix_theorem : Prop :=
  forall r a rho s, 0 < r < 1 -> 0 < a -> 0 < rho -> 0 < s -> s ^ 3 = r ->
  (* 1. Whatever lies below a state whose collisions never end is in the regime. *)
  (forall x y, unending r a rho y -> 0 <= q x <= q y -> 0 < u x <= u y -> x <> y ->
    regime r a rho x) /\
  (* 2. There are such states if and only if a exceeds a threshold. *)
  ((exists x, unending r a rho x) <-> s + s ^ 2 < a) /\
  (* 3. Then there is a separatrix: a convex continuous curve u = f(q), strictly decreasing until it
     reaches 0 at phi_plus. Below it is the regime; above it the collisions end; on it they do
     neither, and all orbits tend to one cycle on the curve, the only cycle that there is. *)
  (s + s ^ 2 < a -> exists (f : R -> R) (c : state),
    continuous_from_0 f /\ convex_from_0 f /\
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
