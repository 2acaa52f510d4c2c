(* Three balls of any masses and radii, with a coefficient of restitution for each of the two pairs that
   collide: what is proved of their collapse. This page can be read after Theorem1.v, Classification.v
   and Line.v; it proves nothing.

   Ball o has just met a, and c approaches. If the numbers that are chosen satisfy the inequalities of
   certificates/three-balls, and a map of two numbers goes on for ever from the point where it begins,
   then o meets c and a in turn without end, in a finite time, which has a bound; nobody meets otherwise;
   and at the end both touch o, at an angle that is nearly known. *)
From Coq Require Import Reals Arith.
From Verify Require Import Theorem1 Classification Line.
Open Scope R_scope.

(* --- the map of two numbers ---------------------------------------------------------------------- *)

Definition pace (alpha rho : R) (p : R * R) : R := alpha * (1 - snd p) - fst p - rho * snd p.
Definition load (rho : R) (p : R * R) : R := rho * snd p * (2 * fst p + rho * snd p).
Definition mapped (alpha rho ratio : R) (p : R * R) : R * R :=
  (ratio * (1 - snd p) / pace alpha rho p,
   1 - sqrt (1 - load rho p / pace alpha rho p / pace alpha rho p)).
(* Numbers that are above where the map leads from numbers (Q, U). *)
Definition above (alpha rho ratio U_most Q U Q' U' : R) : Prop :=
  0 <= Q /\ 0 <= U <= U_most /\ 0 <= U' <= U_most /\ 0 < pace alpha rho (Q, U) /\
  ratio * (1 - U) <= Q' * pace alpha rho (Q, U) /\
  load rho (Q, U) <= U' * (2 - U') * pace alpha rho (Q, U) ^ 2.

Section ThreeBalls.
Variable d : nat.
Variables mass radius : ball -> R.
Variable r : ball -> R.  (* the coefficient of restitution of o and another ball *)
Variables o a c : ball.
Definition next_ball (n : nat) : ball := if Nat.even n then c else a.
Definition last_ball (n : nat) : ball := if Nat.even n then a else c.
Definition reach_of (b : ball) : R := radius o + radius b.
(* The share of the closing speed of o and b that the other ball b' gets. *)
Definition share_of (b b' : ball) : R :=
  (1 + r b) * mass b / (mass o + mass b) * (reach_of b / reach_of b').

(* What is chosen: of the balls c and a bounds w of the speeds, Y of what a collision leaves of the
   closing speed, k of the ratios from below, E of the time that is left; and others. *)
Variables w Y k E : ball -> R.
Variables G U_most C_0 Theta z Q_0 U_0 : R.
Definition alpha_of (n : nat) : R := share_of (next_ball n) (last_ball n) * (C_0 - Theta).
Definition rho_of (n : nat) : R := G * (w (last_ball n) / w (next_ball n)) ^ 2.
Definition ratio_of (n : nat) : R := r (next_ball n) * G.
Fixpoint orbit (n : nat) : R * R :=
  match n with O => (Q_0, U_0) | S n => mapped (alpha_of n) (rho_of n) (ratio_of n) (orbit n) end.
Definition goes_on : Prop := forall n, 0 < pace (alpha_of n) (rho_of n) (orbit n) /\
  load (rho_of n) (orbit n) <= U_most * (2 - U_most) * pace (alpha_of n) (rho_of n) (orbit n) ^ 2.
(* The map goes on if it begins below finitely many numbers, the last two below the first two. *)
Definition stair (N : nat) (Q U : nat -> R) : Prop :=
  0 <= Q_0 <= Q O /\ 0 <= U_0 <= U O /\
  (forall n, (n <= S N)%nat ->
    above (alpha_of n) (rho_of n) (ratio_of n) U_most (Q n) (U n) (Q (S n)) (U (S n))) /\
  Q (S (S N)) <= Q N /\ U (S (S N)) <= U N.

Definition chosen_for (b b' : ball) : Prop :=
  0 < Y b /\ 0 <= k b /\ 0 < w b /\
  G ^ 2 * share_of b b' <= G * Y b + k b /\ k b' * Y b <= r b * (1 - U_most) /\
  G * U_most <= w b ^ 2 * (E b - Y b * E b').
Definition chosen : Prop :=
  1 <= G /\ U_0 <= U_most < 1 /\ Y c * Y a < 1 /\ Theta < C_0 <= 1 /\ chosen_for c a /\ chosen_for a c /\
  (radius a + radius c) ^ 2 <
    reach_of c ^ 2 + reach_of a ^ 2 + 2 * reach_of c * reach_of a * (C_0 - Theta).

(* The scene: c approaches at the speed y times its reach, at the distance 1 + gap times that. *)
Definition closing (s : scene) : R := - rate d s o c / (distance d s o c * reach_of c).
Definition parting (s : scene) : R := rate d s o a / reach_of a ^ 2.
Definition speed_of (s : scene) (b : ball) : R :=
  sqrt (dot d (relative s o b) (relative s o b)) / reach_of b.
Definition starts (s : scene) : Prop :=
  distance d s o a = reach_of a /\
  let y := closing s in let gap := distance d s o c / reach_of c - 1 in
  let gain := G / (1 - Y c * Y a) in
  0 < gap /\ 0 < y /\ 0 < parting s /\ k c * y <= parting s <= Q_0 * y /\
  gap * (2 + gap) * w c ^ 2 <= U_0 * (2 - U_0) * (1 + gap) ^ 2 * y ^ 2 /\
  U_most * (2 - U_most) * G ^ 2 * y ^ 2 <= w c ^ 2 * (G ^ 2 - 1) /\
  U_most * (2 - U_most) * G ^ 2 * (Y c * y) ^ 2 <= w a ^ 2 * (G ^ 2 - 1) /\
  y <= z /\ Y c * y <= z /\ share_of c a * y <= z /\ share_of a c * (Y c * y) <= z /\
  speed_of s c <= w c - share_of a c * Y c * gain * y /\
  speed_of s a <= w a - share_of c a * gain * y /\
  Rabs (minus_cosine_at d s o a c - C_0) + (w c + w a + z) * E c * y <= Theta.

(* Ball o meets c first, then a, then c again. *)
Definition meet_in_turn (scenes : nat -> scene) (time : nat -> R) : Prop :=
  forall n, let b := next_ball n in let t := time (S n) - time n in
    meets_next d radius (scenes n) o b t /\ parts d mass (r b) o b (later t (scenes n)) (scenes (S n)).
End ThreeBalls.

Definition three_balls_theorem : Prop :=
  forall d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> (forall b, 0 < r b <= 1) -> distinct_balls o a c ->
  chosen mass radius r o a c w Y k E G U_most C_0 Theta U_0 ->
  goes_on mass radius r o a c w G U_most C_0 Theta Q_0 U_0 ->
  starts d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s ->
  exists scenes time T at_T, scenes O = s /\ time O = 0 /\
    meet_in_turn d mass radius r o a c scenes time /\
    Un_cv time T /\ T <= E c * closing d radius o c s /\ settles d scenes at_T /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    Un_cv (fun n => minus_cosine_at d (scenes n) o a c) (minus_cosine_at d at_T o a c) /\
    Rabs (minus_cosine_at d at_T o a c - C_0) <= Theta.
Definition stair_theorem : Prop :=
  forall mass radius r o a c w G U_most C_0 Theta Q_0 U_0 N Q U,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> (forall b, 0 < r b) -> 1 <= G -> U_most < 1 ->
  Theta < C_0 ->
  stair mass radius r o a c w G U_most C_0 Theta Q_0 U_0 N Q U ->
  goes_on mass radius r o a c w G U_most C_0 Theta Q_0 U_0.

(* For equal balls with the names of Theorem1.v, this is the collapse there; no other trajectory starts
   from s, and none lasts longer. *)
Definition three_equal_balls : Prop :=
  forall d r w Y k E G U_most C_0 Theta z Q_0 U_0 s, 0 < r < 1 ->
  let mass := fun _ : ball => 1 in let radius := fun _ : ball => 1 / 2 in let same := fun _ : ball => r in
  chosen mass radius same B0 B1 B2 w Y k E G U_most C_0 Theta U_0 ->
  goes_on mass radius same B0 B1 B2 w G U_most C_0 Theta Q_0 U_0 ->
  starts d mass radius same B0 B1 B2 w Y k E G U_most C_0 Theta z Q_0 U_0 s ->
  collapse d r s (E B2 * closing d radius B0 B2 s) C_0 Theta.

(* --- one collision of three balls in inner products, as certificates/flow-of-balls has it ------------- *)

(* Seen from ball o: the ball i is at x_i and moves with W_i, the ball c at x_c with W_c. *)
Definition in_products (d : nat) (radius : ball -> R) (x : scene) (o i c : ball)
    (v lam rho eps sig A B C a b w : R) : Prop :=
  dot d (to x o i) (to x o i) = (radius o + radius i) ^ 2 + sig * v ^ 2 /\
  dot d (to x o c) (to x o c) = (radius o + radius c) ^ 2 + eps * v ^ 2 /\
  dot d (to x o i) (to x o c) = - C /\
  dot d (to x o i) (relative x o i) = rho * v /\ dot d (to x o c) (relative x o c) = - (lam * v) /\
  dot d (to x o i) (relative x o c) = a /\ dot d (to x o c) (relative x o i) = b /\
  dot d (relative x o i) (relative x o i) = B /\ dot d (relative x o c) (relative x o c) = A /\
  dot d (relative x o i) (relative x o c) = w.
(* The givens: what the numbers are of the collision, after the time y T, and of the state after it; and
   that nobody meets before, in Bernstein's basis. *)
Definition collision_numbers (K_c K_s K_o n r v lam rho eps sig A B C a b w y q kap s T
    C' lam' A' B' a' b' w' eps' : R) : Prop :=
  0 < r /\ 0 < v /\ 0 < lam /\ 0 <= A /\ y = lam * v /\ q = rho / lam /\ kap = eps / lam / lam /\
  0 < kap /\ 0 < 1 - A * kap /\ s = sqrt (1 - A * kap) /\ T = kap / (1 + s) /\
  C' = C - y * T * (a + (b + y * T * w)) /\
  lam' = (1 + r) / n * s * C' / K_c - q - T * B /\
  A' = B + (1 + r) / n * (y * s) * (2 * (b + y * T * w) + (1 + r) / n * (y * s)) / K_c /\
  B' = A - (1 - r ^ 2) * (y * s) ^ 2 / K_c /\
  a' = b + y * T * w + (1 + r) / n * (y * s) /\
  b' = a + y * T * w - n * ((1 + r) / n * (y * s)) * C' / K_c /\
  w' = w + (1 + r) / n * (y * s) * (n * (b + y * T * w) + r * (y * s)) / K_c /\
  eps' = sig / lam / lam + T * (2 * q + T * B) /\
  0 <= sig /\ 0 <= sig + T * lam * rho /\ 0 < eps' /\
  0 <= K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C /\
  0 <= K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C + ((rho - lam) * v - a - b) * (y * T) /\
  0 < K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C +
    y * T * (2 * ((rho - lam) * v - a - b) + (A + B - 2 * w) * (y * T)) /\
  0 <= B'.
Definition law_theorem : Prop :=
  forall d mass radius r x o i c v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps',
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> distinct_balls o i c ->
  in_products d radius x o i c v lam rho eps sig A B C a b w ->
  collision_numbers ((radius o + radius c) ^ 2) ((radius o + radius i) ^ 2) ((radius i + radius c) ^ 2)
    (1 + mass o / mass c) r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' ->
  exists z, meets_next d radius x o c (y * T) /\ parts d mass r o c (later (y * T) x) z /\
    in_products d radius z o c i y lam' (r * s) eps' 0 A' B' C' a' b' w'.
