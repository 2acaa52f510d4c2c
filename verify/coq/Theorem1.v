(* Theorem 1 for all parameters: what it says. This page can be read alone; it proves nothing.
   The proof is in Collapse.v and Inhabited.v, from two certificates that Coq has checked. The
   constants are those of the repaired set, with their minima as they stand.

   Three balls of diameter 1 and of equal mass in R^d lose energy when they collide. From every
   scene in a set that is given by inequalities, the ball 0 collides with 2, 1, 2, 1, ... and so on
   without end, in a finite time, and its angle to the other two converges. *)
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
(* The collision of ball 0 with ball j: momentum is exchanged along the line of the centres. *)
Definition collided (j : ball) (s : scene) : scene :=
  let omega := to s B0 j in
  let J := (1 + r) / 2 * rate s B0 j in
  Scene (position s) (fun i k =>
    match i, j with
    | B0, _ => velocity s B0 k + J * omega k
    | B1, B1 | B2, B2 => velocity s j k - J * omega k
    | _, _ => velocity s i k
    end).

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
    s (S n) = collided (collides_with n) (later (t (S n) - t n) (s n)).

(* Minus the cosine of the angle at ball 0. *)
Definition minus_cosine (s : scene) : R :=
  - (dot d (to s B0 B1) (to s B0 B2) / (distance s B0 B1 * distance s B0 B2)).
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
End Constants.

(* --- the theorem ------------------------------------------------------------------------------ *)

(* Infinitely many collisions, of ball 0 with 2 and with 1 in turn; their times converge; the angle
   at ball 0 converges, to one that is as near to theta_0 as is said. *)
Definition collapse (r c V_0 delta_theta : R) (d : nat) (s : scene) : Prop :=
  exists (scenes : nat -> scene) (time : nat -> R),
    scenes O = s /\ time O = 0 /\ collides_in_turn d r scenes time /\
    (exists T, Un_cv time T /\ T <= T_star r c V_0 delta_theta) /\
    (exists l, Un_cv (fun n => minus_cosine d (scenes n)) l /\
      Rabs (l - c) <= Delta_theta r c V_0 delta_theta).

Definition theorem_1 : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d s d_0 y, initial r c V_0 delta_theta d s d_0 y -> collapse r c V_0 delta_theta d s.

(* It is not about nothing: there are such scenes, in the plane and in every higher dimension. *)
Definition not_empty : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d, (2 <= d)%nat -> exists s d_0 y, initial r c V_0 delta_theta d s d_0 y.

(* And there is no other way to go on: which balls meet first, and when, is determined. *)
Definition determined : Prop :=
  forall d s i j t i' j' t', i <> j -> i' <> j' ->
  first_to_meet d s i j t -> first_to_meet d s i' j' t' ->
  t = t' /\ ((i = i' /\ j = j') \/ (i = j' /\ j = i')).
