(* The initial set as the paper prints it, with its own constants: what is proved of it. This page
   proves nothing, PrintedProof.v does. FromNumbers.v has the inequalities that describe an initial
   set; PinnedPrintedSet.v spells all of it out once more. *)
From Coq Require Import Reals List.
From Verify Require Import Theorem1 FromNumbers.
Import ListNotations.
Open Scope R_scope.

(* --- the constants, where they are not those of Theorem1.v ------------------------------------- *)

Section PrintedConstants.
Variables r c V_0 delta_theta : R.

(* As they stand there. *)
Let alpha_0 := alpha_0 r c.
Let phi_minus := phi_minus r c.
Let delta_1 := delta_1 r c.
Let delta_2 := delta_2 r c.
Let delta_3 := delta_3 r c.
Let delta_4 := delta_4 r c.
Let delta_5 := delta_5 r c.
Let C_eta := C_eta r c.
Let h_4 := h_4 r c.
Let h_5 := h_5 r c.
Let V_1 := V_1 r c V_0.

(* As they are printed. *)
Definition delta_x := least delta_1 [delta_2; delta_3; delta_4; delta_5].
Definition x_0 := least ((1 - h_4) * delta_x) [V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition Delta_theta := least (c / 2) [h_4 / 8 * delta_x; delta_theta].
Definition eta_bar :=
  least 1 [
    (sqrt 2 - 1) / 16 * (V_0 / sqrt V_1);
    V_0 / (33 * sqrt V_1) * Delta_theta;
    (1 - C_eta) * (V_1 - V_0) / (12 * (sqrt V_1 + 2));
    V_0 / sqrt V_1 * (2 / (15 * alpha_0) + h_4 * delta_2 / 6 + h_4 / (12 * alpha_0) + h_4 / 24) * delta_x].
Definition zeta_bar :=
  least (2 * (sqrt 2 - 1)) [
    V_0 * h_5 / (3 * V_1 * (alpha_0 + 8 * V_1 / V_0)) * delta_2 ^ 2;
    (1 + 4 * delta_2 + V_0 / V_1) / 16 * h_4 * delta_x].
Definition d_slope := zeta_bar / (2 * V_1).
Definition d_const :=
  least ((sqrt 2 - 1) / 4) [
    Delta_theta / 3;
    (1 + delta_2 * h_4) * delta_x / 5;
    (1 + 2 * delta_2) / 4 * h_4 * delta_x].
Definition T_star := 2 / (V_0 * (1 - C_eta)) * eta_bar * zeta_bar.
(* How far the angle turns at most. *)
Definition Theta := 3 * zeta_bar * eta_bar / sqrt V_1.

(* Scenes with the angle at the start off by no more than the slack, and those into which they fly. As
   it is printed, the angle is not off at all. *)
Definition initial (slack : R) : nat -> scene -> R -> R -> Prop :=
  initial_with phi_minus x_0 eta_bar d_const d_slope V_0 V_1 (4 * slack) c.
Definition with_slack (slack : R) (d : nat) : scene -> Prop := flown_from d (initial slack d).
Definition printed_set : nat -> scene -> Prop := with_slack 0.
Definition with_room : nat -> scene -> Prop := with_slack (Theta / 6).
End PrintedConstants.

(* --- the theorem ------------------------------------------------------------------------------ *)

(* Under the paper's hypotheses, with > in (4.10): the set is not empty, and from each scene of it the
   balls collapse, by the time and at the angle asked for; so they do with room for the angle, which
   an interior needs. *)
Definition printed_set_theorem : Prop :=
  forall r theta_0 V_0 delta_theta d, (2 <= d)%nat -> PI / 2 < theta_0 <= PI ->
  printed_hypothesis r (- cos theta_0) -> 0 < V_0 -> 0 < delta_theta ->
  let c := - cos theta_0 in
  let Theta := Theta r c V_0 delta_theta in
  let as_printed := printed_set r c V_0 delta_theta d in
  let roomy := with_room r c V_0 delta_theta d in
  (exists s, as_printed s) /\ ~ has_interior d as_printed /\
  (forall s, as_printed s -> roomy s) /\ has_interior d roomy /\ contains_a_box d roomy /\
  (forall s, roomy s -> collapse d r s (T_star r c V_0 delta_theta) c Theta) /\
  Theta <= delta_theta.
