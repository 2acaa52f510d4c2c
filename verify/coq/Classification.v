(* Which collapses three balls have: what is proved of them. This page can be read after Theorem1.v; it
   proves nothing. The balls may collide in any order, and infinitely often.

   I. Three balls of any masses and radii that collapse: from some collision on, one of them meets the
   other two in turn, and in the limit the angle at it is at least a right one. So there is no
   triangular collapse. II. Of equal balls with one coefficient of restitution, that angle has a least
   size. II b. It has a larger one, unless all relative velocities tend to 0. III. The momentum that is
   exchanged in all collisions is bounded. IV. If the collisions do not accumulate, then the angular
   momentum is 0. So there are no endless collisions if r is large, or larger with angular momentum. *)
From Coq Require Import Reals List Arith.
From Verify Require Import Theorem1.
Open Scope R_scope.

(* --- balls of any masses and radii ------------------------------------------------------------ *)

Section AnyBalls.
Variable d : nat.
Variables mass radius : ball -> R.

(* Balls i and j exchange momentum along the line of their centres. They do not approach afterwards, and
   part no faster than they came. *)
Definition hits (i j : ball) (s s' : scene) : Prop :=
  exists J, 0 <= J /\ position s' = position s /\
    (forall b k, velocity s' b k =
      if same b i then velocity s b k - J / mass i * to s i j k
      else if same b j then velocity s b k + J / mass j * to s i j k
      else velocity s b k) /\
    0 <= rate d s' i j <= - rate d s i j.
(* After the time t of flight from s, balls i and j touch and approach, and hit each other. Then nobody
   overlaps. *)
Definition strike (s : scene) (t : R) (i j : ball) (s' : scene) : Prop :=
  i <> j /\ 0 < t /\ distance d (later t s) i j = radius i + radius j /\ rate d (later t s) i j < 0 /\
  (forall a b, a <> b -> radius a + radius b <= distance d (later t s) a b) /\
  hits i j (later t s) s'.
(* Scene n is the one just after the n-th collision, which is at the time n. *)
Definition strikes (scenes : nat -> scene) (time : nat -> R) (i j : nat -> ball) : Prop :=
  forall n, strike (scenes n) (time (S n) - time n) (i n) (j n) (scenes (S n)).
End AnyBalls.

Definition distinct_balls (o a c : ball) : Prop := a <> o /\ c <> o /\ a <> c.
(* From collision N on, ball o meets c and a in turn. *)
Definition pair_is (i j a b : ball) : Prop := i = a /\ j = b \/ i = b /\ j = a.
Definition in_turn_from (N : nat) (i j : nat -> ball) (o a c : ball) : Prop :=
  forall n, pair_is (i (N + n)%nat) (j (N + n)%nat) o (if Nat.even n then c else a).
(* The place of ball b, seen from ball a, tends to that in a scene, whose velocities mean nothing. *)
Definition settles (d : nat) (scenes : nat -> scene) (at_T : scene) : Prop :=
  forall a b k, (k < d)%nat -> Un_cv (fun n => to (scenes n) a b k) (to at_T a b k).

Definition no_triangle : Prop :=
  forall d mass radius scenes time T i j, (forall b, 0 < mass b) -> (forall b, 0 < radius b) ->
  strikes d mass radius scenes time i j -> Un_cv time T ->
  exists at_T o a c N, settles d scenes at_T /\ distinct_balls o a c /\ in_turn_from N i j o a c /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    dot d (to at_T o a) (to at_T o c) <= 0.

(* --- equal balls, as in Theorem1.v ------------------------------------------------------------- *)

(* From s there are collisions without end, in any order; their times may converge, or not. Nobody
   overlaps at the time of a collision; what follows needs no more. *)
Definition endless (d : nat) (r : R) (s : scene) (scenes : nat -> scene) (time : nat -> R)
    (i j : nat -> ball) : Prop :=
  scenes O = s /\ time O = 0 /\ forall n, let arriving := later (time (S n) - time n) (scenes n) in
    i n <> j n /\ time n < time (S n) /\ distance d arriving (i n) (j n) = 1 /\
    rate d arriving (i n) (j n) < 0 /\ (forall a b, a <> b -> 1 <= distance d arriving a b) /\
    scenes (S n) = collided d r (i n) (j n) arriving.
Definition minus_cosine_at (d : nat) (s : scene) (o a c : ball) : R :=
  - (dot d (to s o a) (to s o c) / (distance d s o a * distance d s o c)).
(* The components of the angular momentum about the centre of mass, times 3, by pairs of coordinates. *)
Definition moment (s : scene) (k l : nat) (a b : ball) : R :=
  to s a b k * relative s a b l - to s a b l * relative s a b k.
Definition spin (s : scene) (k l : nat) : R := moment s k l B0 B1 + moment s k l B0 B2 + moment s k l B1 B2.
(* The sum of their squares, each pair of coordinates once: 9 times the square of the angular momentum. *)
Definition spin2 (d : nat) (s : scene) : R :=
  / 2 * dot d (fun k => dot d (spin s k) (spin s k)) (fun _ => 1).
(* Sums over the three pairs: 3 times the moment of inertia about the centre of mass, and half its rate. *)
Definition size (d : nat) (s : scene) : R :=
  distance d s B0 B1 ^ 2 + distance d s B0 B2 ^ 2 + distance d s B1 B2 ^ 2.
Definition growth (d : nat) (s : scene) : R := rate d s B0 B1 + rate d s B0 B2 + rate d s B1 B2.
(* All relative velocities tend to 0. *)
Definition stops (d : nat) (scenes : nat -> scene) : Prop :=
  forall a b k, (k < d)%nat -> Un_cv (fun n => relative (scenes n) a b k) 0.

(* II and II b. *)
Definition least_angle : Prop :=
  forall d r s scenes time i j, 0 < r <= 1 -> endless d r s scenes time i j ->
  exists at_T o a c N, settles d scenes at_T /\ distinct_balls o a c /\ in_turn_from N i j o a c /\
    distance d at_T o a = 1 /\ distance d at_T o c = 1 /\
    4 * sqrt r / (1 + r) <= minus_cosine_at d at_T o a c <= 1 /\
    (2 * cube_root r * (1 + cube_root r) / (1 + r) <= minus_cosine_at d at_T o a c \/
      stops d scenes).
(* The same of three balls of equal masses and any radii, each time with one r. *)
Definition restituted (d : nat) (r : R) (scenes : nat -> scene) (time : nat -> R) (i j : nat -> ball) : Prop :=
  forall n, rate d (scenes (S n)) (i n) (j n) =
    - r * rate d (later (time (S n) - time n) (scenes n)) (i n) (j n).
Definition least_angle_any_radii : Prop :=
  forall d m radius r scenes time i j, 0 < m -> (forall b, 0 < radius b) -> 0 < r <= 1 ->
  strikes d (fun _ => m) radius scenes time i j -> restituted d r scenes time i j ->
  exists at_T o a c N, settles d scenes at_T /\ distinct_balls o a c /\ in_turn_from N i j o a c /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    4 * sqrt r / (1 + r) <= minus_cosine_at d at_T o a c <= 1 /\
    (2 * cube_root r * (1 + cube_root r) / (1 + r) <= minus_cosine_at d at_T o a c \/
      stops d scenes).
Definition never_any_radii : Prop :=
  forall d m radius r scenes time i j, 0 < m -> (forall b, 0 < radius b) -> 7 - 4 * sqrt 3 < r <= 1 ->
  strikes d (fun _ => m) radius scenes time i j -> ~ restituted d r scenes time i j.
Definition never : Prop :=
  forall d r s scenes time i j, 7 - 4 * sqrt 3 < r <= 1 -> ~ endless d r s scenes time i j.
(* III. The speed at which a pair meets is the momentum exchanged, divided by (1+r)/2. *)
Definition bounded_impulse : Prop :=
  forall d r s scenes time i j, 0 < r <= 1 -> endless d r s scenes time i j ->
  exists bound, forall n,
    sum_f_R0 (fun m => - rate d (later (time (S m) - time m) (scenes m)) (i m) (j m)) n <= bound.
(* IV. Of any masses and radii: the balls come to rest, seen from one another, and until then do not recede
   from their centre of mass; the rest as if the times converged. The sums are over pairs: with the mass of
   all, R A and the angular momentum about that centre. *)
Definition over_pairs (mass : ball -> R) (f : ball -> ball -> R) : R :=
  mass B0 * mass B1 * f B0 B1 + mass B0 * mass B2 * f B0 B2 + mass B1 * mass B2 * f B1 B2.
Definition comes_to_rest : Prop :=
  forall d mass radius scenes time i j, (forall b, 0 < mass b) -> (forall b, 0 < radius b) ->
  strikes d mass radius scenes time i j -> ~ (exists T, Un_cv time T) ->
  stops d scenes /\
  (forall n, over_pairs mass (rate d (scenes n)) <= 0) /\
  (forall n k l, (k < d)%nat -> (l < d)%nat -> over_pairs mass (moment (scenes n) k l) = 0) /\
  exists at_T o a c N, settles d scenes at_T /\ distinct_balls o a c /\ in_turn_from N i j o a c /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    dot d (to at_T o a) (to at_T o c) <= 0.
(* Of equal ones, also IV b. *)
Definition no_spin : Prop :=
  forall d r s scenes time i j, 0 < r <= 1 -> endless d r s scenes time i j -> 0 < spin2 d s ->
  exists T, Un_cv time T.
Definition never_with_spin : Prop :=
  forall d r s scenes time i j, 9 - 4 * sqrt 5 < r <= 1 -> 0 < spin2 d s -> ~ endless d r s scenes time i j.
(* If the balls do not come nearer to their centre of mass, and are as far from it as on a line in
   contact; or if their angular momentum keeps them as far from it. *)
Definition never_outward : Prop :=
  forall d r s scenes time i j, 0 < r <= 1 -> 0 <= growth d s -> 6 <= size d s ->
  ~ endless d r s scenes time i j.
Definition never_turning : Prop :=
  forall d r s scenes time i j, 0 < r <= 1 -> growth d s ^ 2 * size d s < (size d s - 6) * spin2 d s ->
  ~ endless d r s scenes time i j.

(* --- trajectories with finitely many collisions -------------------------------------------------- *)

(* At the time t two balls arrive in contact, and approach. *)
Definition collision_at (d : nat) (Z : R -> scene) (t : R) : Prop :=
  exists e arriving i j, 0 < e /\ (forall u, 0 < u < e -> Z (t - u) = later (- u) arriving) /\
    i <> j /\ distance d arriving i j = 1 /\ rate d arriving i j < 0.
(* All collisions of all trajectories from s are at times of one list. *)
Definition finite (d : nat) (r : R) (s : scene) : Prop :=
  exists times : list R, forall T Z, trajectory d r s T Z ->
  forall t, 0 < t < T -> collision_at d Z t -> In t times.
(* If not, then there are collisions without end. *)
Definition finite_or_endless : Prop :=
  forall d r s, 0 < r <= 1 -> finite d r s \/ exists scenes time i j, endless d r s scenes time i j.
