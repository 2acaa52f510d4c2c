(* Theorem 1 for all parameters: what it says. This page can be read alone; it proves nothing.
   AllProved.v puts the proof together, from two certificates that Coq has checked. The constants
   are those of the repaired set, with their minima as they stand.

   Three balls of diameter 1 and of equal mass in R^d lose energy when they collide. From every
   scene in a set that is given by inequalities, ball 0 collides with 2, 1, 2, 1, ... and so on
   without end, in a finite time, and nothing else can happen. At the end both other balls touch
   ball 0, and the angle between them is near the one that was asked for. The set has an interior. *)
From Coq Require Import Reals List Arith.
Import ListNotations.
Open Scope R_scope.

(* --- vectors in R^d, by their coordinates 0, ..., d-1 ----------------------------------------- *)

Definition vector := nat -> R.
Fixpoint dot (d : nat) (u v : vector) : R :=
  match d with O => 0 | S k => dot k u v + u k * v k end.

(* --- three balls ------------------------------------------------------------------------------ *)

Inductive ball : Set := B0 | B1 | B2.
Record scene := Scene { position : ball -> vector; velocity : ball -> vector }.

(* From ball i to ball j: the place, and the velocity. *)
Definition to (s : scene) (i j : ball) : vector := fun k => position s j k - position s i k.
Definition relative (s : scene) (i j : ball) : vector := fun k => velocity s j k - velocity s i k.

Section Motion.
Variable d : nat.  (* the dimension *)
Variable r : R.  (* the coefficient of restitution *)

Definition distance (s : scene) (i j : ball) : R := sqrt (dot d (to s i j) (to s i j)).
(* The rate at which two balls in contact move apart. *)
Definition rate (s : scene) (i j : ball) : R := dot d (to s i j) (relative s i j).

(* Free flight for a time. *)
Definition later (t : R) (s : scene) : scene :=
  Scene (fun i k => position s i k + t * velocity s i k) (velocity s).
(* The collision of balls i and j: momentum is exchanged along the line of the centres. *)
Definition same (i j : ball) : bool :=
  match i, j with B0, B0 | B1, B1 | B2, B2 => true | _, _ => false end.
Definition collided (i j : ball) (s : scene) : scene :=
  let omega := to s i j in
  let J := (1 + r) / 2 * rate s i j in
  Scene (position s) (fun b k =>
    if same b i then velocity s b k + J * omega k
    else if same b j then velocity s b k - J * omega k
    else velocity s b k).

(* --- trajectories: any two balls may collide, in any order ------------------------------------ *)

(* Nobody overlaps, and balls that touch do not approach. *)
Definition nobody_collides (s : scene) : Prop :=
  forall i j, i <> j -> 1 <= distance s i j /\ (distance s i j = 1 -> 0 <= rate s i j).
(* Just two balls touch; they approach, and collide. *)
Definition two_collide (s s' : scene) : Prop :=
  exists i j, i <> j /\ distance s i j = 1 /\ rate s i j < 0 /\
    (forall k, k <> i -> k <> j -> 1 < distance s i k /\ 1 < distance s j k) /\
    s' = collided i j s.

(* Z gives the scene at each time from 0 until just before T; at the time of a collision, it is the
   scene after it. After each time there is free flight for a while. Before each time there was, to
   some scene, which stays as it is if nobody collides. Where three balls touch and two of them
   approach, no trajectory goes on. *)
Record trajectory (s : scene) (T : R) (Z : R -> scene) : Prop := {
  begins : Z 0 = s;
  after_it : forall t, 0 <= t < T ->
    exists e, 0 < e /\ forall u, 0 <= u < e -> Z (t + u) = later u (Z t);
  before_it : forall t, 0 < t < T ->
    exists e arriving, 0 < e /\ (forall u, 0 < u < e -> Z (t - u) = later (- u) arriving) /\
      (nobody_collides arriving /\ Z t = arriving \/ two_collide arriving (Z t))
}.

(* --- the collapse: ball 0 collides with 2 and 1 in turn --------------------------------------- *)

(* In free flight from s, balls i and j are the first to meet, after the time t, and only they. *)
Record first_to_meet (s : scene) (i j : ball) (t : R) : Prop := {
  after_a_time : 0 < t;
  nobody_before : forall u a b, 0 < u < t -> a <> b -> 1 < distance (later u s) a b;
  contact : distance (later t s) i j = 1;
  approach : rate (later t s) i j < 0;
  only_they : forall k, k <> i -> k <> j ->
    1 < distance (later t s) i k /\ 1 < distance (later t s) j k
}.

(* Scene n is the one just after the n-th collision, at the time t n; scene 0 is the given one. *)
Definition collides_with (n : nat) : ball := if Nat.even n then B2 else B1.
Definition collides_in_turn (s : nat -> scene) (t : nat -> R) : Prop :=
  forall n, first_to_meet (s n) B0 (collides_with n) (t (S n) - t n) /\
    s (S n) = collided B0 (collides_with n) (later (t (S n) - t n) (s n)).

(* Minus the cosine of the angle at ball 0. *)
Definition minus_cosine (s : scene) : R :=
  - (dot d (to s B0 B1) (to s B0 B2) / (distance s B0 B1 * distance s B0 B2)).

(* f(t) tends to l when t tends to T from below. *)
Definition tends_to (f : R -> R) (T l : R) : Prop :=
  forall e, 0 < e -> exists m, m < T /\ forall t, m < t < T -> Rabs (f t - l) < e.

(* From s, there are infinitely many collisions before the time T, but finitely many before each
   earlier time. Z is a trajectory with just these collisions, and none from s lasts longer. The
   balls' positions tend to those of the scene at_T, in which both other balls touch ball 0; its
   velocities mean nothing. *)
Record collapses (s : scene) (scenes : nat -> scene) (time : nat -> R) (T : R) (Z : R -> scene)
    (at_T : scene) : Prop := {
  first_scene : scenes O = s;
  first_time : time O = 0;
  in_turn : collides_in_turn scenes time;
  finite_time : Un_cv time T;
  between : forall n t, time n <= t < time (S n) -> Z t = later (t - time n) (scenes n);
  goes_until_T : trajectory s T Z;
  none_goes_beyond : forall T' Z', trajectory s T' Z' -> T' <= T;
  positions_converge : forall i k, (k < d)%nat ->
    tends_to (fun t => position (Z t) i k) T (position at_T i k);
  touch_1 : distance at_T B0 B1 = 1;
  touch_2 : distance at_T B0 B2 = 1;
  angle_converges : Un_cv (fun n => minus_cosine (scenes n)) (minus_cosine at_T)
}.
(* By a time, and at an angle whose cosine is known with a tolerance. *)
Definition collapse (s : scene) (by_time c tolerance : R) : Prop :=
  exists scenes time T Z at_T, collapses s scenes time T Z at_T /\
    T <= by_time /\ Rabs (minus_cosine at_T - c) <= tolerance.

(* Scenes with positions and velocities that differ by less than e, coordinate by coordinate. *)
Definition close (e : R) (s s' : scene) : Prop :=
  forall i k, (k < d)%nat -> Rabs (position s' i k - position s i k) < e /\
    Rabs (velocity s' i k - velocity s i k) < e.
Definition has_interior (set : scene -> Prop) : Prop :=
  exists s e, 0 < e /\ forall s', close e s s' -> set s'.
(* All scenes whose coordinates lie in intervals, of positive length for each of the 6 d numbers. Such
   a box has a positive volume, the product of the lengths. *)
Definition in_box (low high s : scene) : Prop :=
  forall i k, (k < d)%nat -> position low i k <= position s i k <= position high i k /\
    velocity low i k <= velocity s i k <= velocity high i k.
Definition contains_a_box (set : scene -> Prop) : Prop :=
  exists low high, (forall i k, (k < d)%nat ->
      position low i k < position high i k /\ velocity low i k < velocity high i k) /\
    forall s, in_box low high s -> set s.
End Motion.

(* --- parameters and constants ----------------------------------------------------------------- *)

(* c is minus the cosine of theta_0; V_0 is a speed squared; delta_theta is chosen. *)
Record admissible (r c V_0 delta_theta : R) : Prop := {
  restitution : 0 < r < 1;
  angle_obtuse : 0 < c <= 1;
  stability : 3 * r * ((1 + r) / 2 * c) + r * (1 + r) < ((1 + r) / 2 * c) ^ 3;
  speed_positive : 0 < V_0;
  tolerance_positive : 0 < delta_theta
}.

Definition least (a : R) (others : list R) : R := fold_right Rmin a others.

Section Constants.
Variables r c V_0 delta_theta : R.

Definition alpha_0 := (1 + r) / 2 * c.
Definition phi_minus := 2 * r / (alpha_0 + sqrt (alpha_0 ^ 2 - 4 * r)).
Definition delta_1 := alpha_0 / 2 - phi_minus.
Definition delta_2 := (alpha_0 - phi_minus) / 2.
Definition delta_3 := (1 - (alpha_0 - phi_minus)) / 2.
Definition C_eta := 1 - delta_3.
Definition h_4 := (1 - r / (alpha_0 - phi_minus) ^ 2) / 2.
Definition delta_4 := alpha_0 - phi_minus - sqrt (r / (1 - h_4)).
Definition h_5 := (1 - phi_minus / (alpha_0 - phi_minus) ^ 2) / 2.
Definition delta_5 := alpha_0 - phi_minus - sqrt (phi_minus / (1 - h_5)).
Definition V_1 := V_0 * ((1 - h_5 / 2) / (1 - h_5)).

Definition delta_x :=
  least delta_1 [delta_2; delta_3; delta_4; delta_5; V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition x_0 := least ((1 - h_4) * delta_x) [V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition Delta_theta := least (c / 2) [h_4 * delta_x / 8; delta_theta].
Definition eta_bar :=
  least 1 [
    (sqrt 2 - 1) / 16 * (V_0 / sqrt V_1);
    (1 - C_eta) / 28 * (V_0 / sqrt V_1) * Delta_theta;
    (1 - C_eta) * (V_1 - V_0) / (12 * (sqrt V_1 + 2));
    V_0 / sqrt V_1 / (12 * alpha_0) * (h_4 * delta_x);
    V_0 / sqrt V_1 * (delta_2 / 6) * (h_4 * delta_x);
    V_0 / sqrt V_1 / 24 * (h_4 * delta_x)].
Definition zeta_bar :=
  least (2 * (sqrt 2 - 1)) [
    V_0 * h_5 / (3 * V_1 * (alpha_0 + 8 * V_1 / V_0)) * delta_2 ^ 2;
    h_4 * delta_x / 16;
    delta_2 / 4 * (h_4 * delta_x);
    V_0 / V_1 / 16 * (h_4 * delta_x)].
Definition d_slope := zeta_bar / (2 * V_1).
Definition d_const :=
  least ((sqrt 2 - 1) / 4) [Delta_theta / 4; delta_2 / 2 * (h_4 * delta_x); h_4 * delta_x / 8].
Definition T_star := 2 / (V_0 * (1 - C_eta)) * eta_bar * zeta_bar.

(* --- the initial scenes ----------------------------------------------------------------------- *)

(* Balls 0 and 1 have just collided: they touch and move apart. Ball 2 is near, at the distance
   1 + d_0, and approaches ball 0 with the speed y along the line of the centres. *)
Record initial (d : nat) (s : scene) (d_0 y : R) : Prop := {
  distance_0 : distance d s B0 B2 = 1 + d_0;
  speed_0 : rate d s B0 B2 = - y * (1 + d_0);
  touch : distance d s B0 B1 = 1;
  recede : 0 < rate d s B0 B1;
  slow : 0 < y <= eta_bar;
  ratio : Rabs (rate d s B0 B1 - phi_minus * y) <= x_0 * y;
  near : 0 < d_0 <= Rmin d_const (d_slope * y ^ 2);
  speed_1 : V_0 + (V_1 - V_0) / 3 <= dot d (relative s B0 B1) (relative s B0 B1)
    <= V_1 - (V_1 - V_0) / 3;
  speed_2 : V_0 + (V_1 - V_0) / 3 <= dot d (relative s B0 B2) (relative s B0 B2)
    <= V_1 - (V_1 - V_0) / 3;
  angle_0 : Rabs (minus_cosine d s - c) <= Delta_theta / 4
}.

(* The set: these scenes, and those into which they fly while no two balls touch. *)
Definition ZK (d : nat) (s : scene) : Prop :=
  exists s_0 d_0 y u, initial d s_0 d_0 y /\ 0 <= u /\
    (forall v i j, 0 < v <= u -> i <> j -> 1 < distance d (later v s_0) i j) /\ s = later u s_0.
End Constants.

(* --- the theorem ------------------------------------------------------------------------------ *)

Definition theorem_1 : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d s, ZK r c V_0 delta_theta d s ->
    collapse d r s (T_star r c V_0 delta_theta) c (Delta_theta r c V_0 delta_theta).

(* The set contains all scenes, of the 6 d numbers that make one up, near one of them. *)
Definition interior : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d, (2 <= d)%nat -> has_interior d (ZK r c V_0 delta_theta d).

(* The set has a positive measure, since it contains a box. *)
Definition positive_volume : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d, (2 <= d)%nat -> contains_a_box d (ZK r c V_0 delta_theta d).

(* Two trajectories from the same scene are the same for as long as both last. *)
Definition determined : Prop :=
  forall d r s T Z T' Z', trajectory d r s T Z -> trajectory d r s T' Z' ->
  forall t, 0 <= t < T -> t < T' -> Z t = Z' t.

(* The constants are defined: what stands under a root or below a fraction bar is made of numbers that
   are positive, r, c, V_0 and the first seven here, by sums, products, quotients and roots. The next
   three are equations by which the paper defines phi_minus, delta_4 and delta_5. The rest says that
   the set is described by positive numbers, and that the angle is as near as was asked for. *)
Definition constants_defined : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  0 < alpha_0 r c /\ 0 < alpha_0 r c ^ 2 - 4 * r /\ 0 < alpha_0 r c - phi_minus r c /\
  0 < 1 - h_4 r c /\ 0 < 1 - h_5 r c /\ 0 < 1 - C_eta r c /\ 0 < V_1 r c V_0 /\
  phi_minus r c = (alpha_0 r c - sqrt (alpha_0 r c ^ 2 - 4 * r)) / 2 /\
  r / (alpha_0 r c - (phi_minus r c + delta_4 r c)) ^ 2 = 1 - h_4 r c /\
  phi_minus r c / (alpha_0 r c - (phi_minus r c + delta_5 r c)) ^ 2 = 1 - h_5 r c /\
  0 < phi_minus r c /\ 0 < delta_x r c V_0 /\ 0 < x_0 r c V_0 /\ V_0 < V_1 r c V_0 /\
  0 < Delta_theta r c V_0 delta_theta <= delta_theta /\ 0 < eta_bar r c V_0 delta_theta /\
  0 < zeta_bar r c V_0 /\ 0 < d_const r c V_0 delta_theta /\ 0 < d_slope r c V_0.

(* --- as the paper prints it, with > instead of < for the cosine ------------------------------- *)

Definition cube_root (r : R) : R := Rpower r (1 / 3).
Definition printed_hypothesis (r c : R) : Prop :=
  0 < r < 9 - 4 * sqrt 5 /\ 2 * cube_root r * (1 + cube_root r) / (1 + r) < c.
Definition same_hypothesis : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta <->
    printed_hypothesis r c /\ c <= 1 /\ 0 < V_0 /\ 0 < delta_theta.

Definition printed_theorem : Prop :=
  forall r theta_0 delta_theta d, (2 <= d)%nat -> PI / 2 < theta_0 <= PI ->
  printed_hypothesis r (- cos theta_0) -> 0 < delta_theta ->
  exists set, has_interior d set /\
    exists by_time, forall s, set s -> collapse d r s by_time (- cos theta_0) delta_theta.
