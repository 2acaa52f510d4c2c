(* The set as the paper prints it, spelled out once more, with the words of Pinned.v. A reader compares
   it with the paper; and if PrintedSet.v comes to say anything else, the proofs at the end fail. *)
From Verify Require Import Pinned.
From Verify Require Theorem1 AllProved PrintedSet PrintedProof.
From Coq Require Import Reals List Arith Lra.
Import ListNotations.
Open Scope R_scope.
Definition B1 : ball := Pinned.B1.  (* Coq has another one *)

Section PinnedPrintedSet.
Variables r c V_0 delta_theta : R.

(* --- the constants of the paper, as it defines them and Pinned.v, too -------------------------- *)

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

(* --- those whose minima are as printed here, and repaired in Pinned.v: (4.37) to (4.43) ---------- *)

Definition delta_x := minimum delta_1 [delta_2; delta_3; delta_4; delta_5].
Definition x_0 := minimum ((1 - h_4) * delta_x) [V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition Delta_theta := minimum (c / 2) [h_4 / 8 * delta_x; delta_theta].
Definition eta_bar :=
  minimum 1 [
    (sqrt 2 - 1) / 16 * (V_0 / sqrt V_1);
    V_0 / (33 * sqrt V_1) * Delta_theta;
    (1 - C_eta) * (V_1 - V_0) / (12 * (sqrt V_1 + 2));
    V_0 / sqrt V_1 * (2 / (15 * alpha_0) + h_4 * delta_2 / 6 + h_4 / (12 * alpha_0) + h_4 / 24) * delta_x].
Definition zeta_bar :=
  minimum (2 * (sqrt 2 - 1)) [
    V_0 * h_5 / (3 * V_1 * (alpha_0 + 8 * V_1 / V_0)) * delta_2 ^ 2;
    (1 + 4 * delta_2 + V_0 / V_1) / 16 * h_4 * delta_x].
Definition d_slope := zeta_bar / (2 * V_1).
Definition d_const :=
  minimum ((sqrt 2 - 1) / 4) [
    Delta_theta / 3;
    (1 + delta_2 * h_4) * delta_x / 5;
    (1 + 2 * delta_2) / 4 * h_4 * delta_x].

(* What the paper does not say: the time it takes at most, and how far the angle turns at most. *)
Definition T_star := 2 / (V_0 * (1 - C_eta)) * eta_bar * zeta_bar.
Definition Theta := 3 * zeta_bar * eta_bar / sqrt V_1.

(* --- the set ------------------------------------------------------------------------------------ *)

(* (4.43) but for the angle; after a collision, 0 and 1 part. That a gap is left before 2 is added. *)
Definition initial d x v : Prop :=
  exists d_0 y, distance d x B0 B2 = 1 + d_0 /\ rate d x v B0 B2 = - y * (1 + d_0) /\
  distance d x B0 B1 = 1 /\ 0 < rate d x v B0 B1 /\
  0 < y <= eta_bar /\ Rabs (rate d x v B0 B1 - phi_minus * y) <= x_0 * y /\
  0 < d_0 <= Rmin d_const (d_slope * y ^ 2) /\
  V_0 + (V_1 - V_0) / 3 <= dot d (from_to v B0 B1) (from_to v B0 B1) <= V_1 - (V_1 - V_0) / 3 /\
  V_0 + (V_1 - V_0) / 3 <= dot d (from_to v B0 B2) (from_to v B0 B2) <= V_1 - (V_1 - V_0) / 3.

(* With the angle as printed, and with room for it; and what flies from there while no two balls touch. *)
Definition printed_set d x' v : Prop :=
  exists x u, initial d x v /\ minus_cosine d x = c /\ 0 <= u /\
    (forall w i j, 0 < w <= u -> i <> j -> 1 < distance d (moved w x v) i j) /\ x' = moved u x v.
Definition with_room d x' v : Prop :=
  exists x u, initial d x v /\ Rabs (minus_cosine d x - c) <= Theta / 6 /\ 0 <= u /\
    (forall w i j, 0 < w <= u -> i <> j -> 1 < distance d (moved w x v) i j) /\ x' = moved u x v.
End PinnedPrintedSet.

(* --- what follows ------------------------------------------------------------------------------- *)

(* Under the hypotheses of the paper, with > in (4.10): the set is not empty, and it has no interior;
   with room for the angle it has one. From everywhere there, so also from the set as it is printed,
   the balls collapse, as Pinned.v says it; at the end the angle is as near as was asked for. *)
Definition printed_set_theorem : Prop :=
  forall r theta_0 V_0 delta_theta d, (2 <= d)%nat -> PI / 2 < theta_0 <= PI ->
  printed_hypothesis r (- cos theta_0) -> 0 < V_0 -> 0 < delta_theta ->
  let c := - cos theta_0 in
  let Theta := Theta r c V_0 delta_theta in
  let as_printed := printed_set r c V_0 delta_theta d in
  let roomy := with_room r c V_0 delta_theta d in
  (exists x v, as_printed x v) /\ ~ has_interior d as_printed /\
  (forall x v, as_printed x v -> roomy x v) /\ has_interior d roomy /\ contains_a_box d roomy /\
  (forall x v, roomy x v -> collapse d r x v (T_star r c V_0 delta_theta) c Theta) /\
  Theta <= delta_theta.

(* --- PrintedSet.v says just this ---------------------------------------------------------------- *)

Lemma same_initial slack r c V_0 delta_theta d x v :
  (exists d_0 y, PrintedSet.initial r c V_0 delta_theta slack d (placed x v) d_0 y) <->
  initial r c V_0 delta_theta d x v /\ Rabs (minus_cosine d x - c) <= slack.
Proof.
  assert (E : 4 * slack / 4 = slack) by field. split.
  - intros (d_0 & y & [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10]). rewrite E in G10. split; [|exact G10].
    exists d_0, y. repeat (split; [assumption|]). assumption.
  - intros [(d_0 & y & G1 & G2 & G3 & G4 & G5 & G6 & G7 & G8 & G9) G10]. exists d_0, y.
    split; try assumption. rewrite E. exact G10.
Qed.
Lemma same_slack slack r c V_0 delta_theta d x' v :
  PrintedSet.with_slack r c V_0 delta_theta slack d (placed x' v) <->
  exists x u, (initial r c V_0 delta_theta d x v /\ Rabs (minus_cosine d x - c) <= slack) /\ 0 <= u /\
    (forall w i j, 0 < w <= u -> i <> j -> 1 < distance d (moved w x v) i j) /\ x' = moved u x v.
Proof.
  split.
  - intros ([x w] & d_0 & y & u & I & P & F & Q). injection Q as -> ->. exists x, u.
    split; [apply same_initial; exists d_0, y; exact I|]. repeat (split; [assumption|]). reflexivity.
  - intros (x & u & I & P & F & ->). apply same_initial in I. destruct I as (d_0 & y & I).
    exists (placed x v), d_0, y, u. repeat (split; [assumption|]). reflexivity.
Qed.
Lemma same_printed_set r c V_0 delta_theta d x v :
  PrintedSet.printed_set r c V_0 delta_theta d (placed x v) <-> printed_set r c V_0 delta_theta d x v.
Proof.
  unfold PrintedSet.printed_set. rewrite same_slack. split.
  - intros (x' & u & [I A] & F). exists x', u. split; [exact I|]. split; [|exact F].
    unfold Rabs in A. destruct Rcase_abs; lra.
  - intros (x' & u & I & A & F). exists x', u. split; [|exact F]. split; [exact I|].
    rewrite A, Rminus_diag_eq, Rabs_R0; [apply Rle_refl | reflexivity].
Qed.
Lemma same_with_room r c V_0 delta_theta d x v :
  PrintedSet.with_room r c V_0 delta_theta d (placed x v) <-> with_room r c V_0 delta_theta d x v.
Proof.
  unfold PrintedSet.with_room. rewrite same_slack. split.
  - intros (x' & u & [I A] & F). now exists x', u.
  - intros (x' & u & I & A & F). now exists x', u.
Qed.
Theorem same_printed_set_theorem : Theorem1.determined ->
  PrintedSet.printed_set_theorem <-> printed_set_theorem.
Proof.
  intros ONE. split; intros A r theta_0 V_0 delta_theta d L T H V P;
    destruct (A r theta_0 V_0 delta_theta d L T H V P) as (A1 & A2 & A3 & A4 & A5 & A6 & A7);
    cbv zeta in *.
  - split; [|split; [|split; [|split; [|split; [|split]]]]].
    + destruct A1 as [[x v] A1]. exists x, v. now apply same_printed_set.
    + intros I. apply A2. apply same_interior. revert I. apply same_set. intros x v.
      symmetry. apply same_printed_set.
    + intros x v I. apply same_with_room, A3. now apply same_printed_set.
    + apply same_interior in A4. revert A4. apply same_set. intros x v. apply same_with_room.
    + destruct A5 as ([x v] & [y w] & B & C). exists x, y, v, w. split; [exact B|].
      intros x' v' I. apply same_with_room. apply C. exact I.
    + intros x v I. apply same_collapse; [exact ONE|]. apply A6. now apply same_with_room.
    + exact A7.
  - split; [|split; [|split; [|split; [|split; [|split]]]]].
    + destruct A1 as (x & v & A1). exists (placed x v). now apply same_printed_set.
    + intros I. apply A2. apply same_interior in I. revert I. apply same_set. intros x v.
      apply same_printed_set.
    + intros [x v] I. apply same_with_room, A3. now apply same_printed_set.
    + apply same_interior. revert A4. apply same_set. intros x v. symmetry. apply same_with_room.
    + destruct A5 as (x & y & v & w & B & C). exists (placed x v), (placed y w). split; [exact B|].
      intros [x' v'] I. apply same_with_room. apply C. exact I.
    + intros [x v] I. apply same_collapse; [exact ONE|]. apply A6. now apply same_with_room.
    + exact A7.
Qed.

(* --- what is proved --------------------------------------------------------------------------- *)

Check (PrintedProof.printed_set_theorem_holds : PrintedSet.printed_set_theorem).
Theorem printed_set_proved : printed_set_theorem.
Proof.
  apply same_printed_set_theorem; [|exact PrintedProof.printed_set_theorem_holds].
  apply AllProved.all_proved.
Qed.
Print Assumptions printed_set_proved.
