(* Theorem 1 once more, spelled out with Coq's own real numbers: the only thing on this page that
   comes from another of our files is that there are three balls. A reader compares it with the
   paper; and if Theorem1.v comes to say anything else, the proofs at the end fail. Nothing is
   imported from Verify, so that no notation and no scope of another file changes what is read. *)
From Coq Require Import Reals List Arith Lra FunctionalExtensionality.
From Verify Require Theorem1 Inhabited.
Import ListNotations.
Open Scope R_scope.

Definition ball := Theorem1.ball.
Definition B0 : ball := Theorem1.B0.
Definition B1 : ball := Theorem1.B1.
Definition B2 : ball := Theorem1.B2.
Theorem three_balls : (forall b : ball, b = B0 \/ b = B1 \/ b = B2) /\ B0 <> B1 /\ B0 <> B2 /\ B1 <> B2.
Proof. split; [intros []; auto | repeat split; discriminate]. Qed.

(* --- three balls of diameter 1 in R^d, at the places x, with the velocities v ----------------- *)

(* u_0 v_0 + ... + u_(d-1) v_(d-1) *)
Fixpoint dot (d : nat) (u v : nat -> R) : R :=
  match d with O => 0 | S k => dot k u v + u k * v k end.
Definition from_to (x : ball -> nat -> R) (i j : ball) : nat -> R := fun k => x j k - x i k.
Definition distance d x i j := sqrt (dot d (from_to x i j) (from_to x i j)).
Definition rate d x v i j := dot d (from_to x i j) (from_to v i j).
Definition minus_cosine d x :=
  - (dot d (from_to x B0 B1) (from_to x B0 B2) / (distance d x B0 B1 * distance d x B0 B2)).

(* The places after the time t of free flight. *)
Definition moved (t : R) (x v : ball -> nat -> R) : ball -> nat -> R := fun i k => x i k + t * v i k.

(* After the time t, the balls i and j are the first to meet, and only they. *)
Definition meet d x v i j t : Prop :=
  0 < t /\ (forall u a b, 0 < u < t -> a <> b -> 1 < distance d (moved u x v) a b) /\
  distance d (moved t x v) i j = 1 /\ rate d (moved t x v) v i j < 0 /\
  (forall k, k <> i -> k <> j ->
    1 < distance d (moved t x v) i k /\ 1 < distance d (moved t x v) j k).

(* The balls 0 and j collide at the places z. Of the rate at which they approach, the part r is left
   as the rate at which they part; momentum is kept. Their velocities afterwards are w. *)
Definition collide d r z v j w : Prop :=
  (forall k, w B0 k = v B0 k + (1 + r) / 2 * rate d z v B0 j * from_to z B0 j k) /\
  (forall k, w j k = v j k - (1 + r) / 2 * rate d z v B0 j * from_to z B0 j k) /\
  (forall i k, i <> B0 -> i <> j -> w i k = v i k).

(* --- the constants, as in the paper, with the repaired minima --------------------------------- *)

Section Constants.
Variables r c V_0 delta_theta : R.
Definition minimum (a : R) (others : list R) : R := fold_right Rmin a others.

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
  minimum delta_1 [delta_2; delta_3; delta_4; delta_5; V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition x_0 := minimum ((1 - h_4) * delta_x) [V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition Delta_theta := minimum (c / 2) [h_4 * delta_x / 8; delta_theta].
Definition eta_bar :=
  minimum 1 [
    (sqrt 2 - 1) / 16 * (V_0 / sqrt V_1);
    (1 - C_eta) / 28 * (V_0 / sqrt V_1) * Delta_theta;
    (1 - C_eta) * (V_1 - V_0) / (12 * (sqrt V_1 + 2));
    V_0 / sqrt V_1 / (12 * alpha_0) * (h_4 * delta_x);
    V_0 / sqrt V_1 * (delta_2 / 6) * (h_4 * delta_x);
    V_0 / sqrt V_1 / 24 * (h_4 * delta_x)].
Definition zeta_bar :=
  minimum (2 * (sqrt 2 - 1)) [
    V_0 * h_5 / (3 * V_1 * (alpha_0 + 8 * V_1 / V_0)) * delta_2 ^ 2;
    h_4 * delta_x / 16;
    delta_2 / 4 * (h_4 * delta_x);
    V_0 / V_1 / 16 * (h_4 * delta_x)].
Definition d_slope := zeta_bar / (2 * V_1).
Definition d_const :=
  minimum ((sqrt 2 - 1) / 4) [Delta_theta / 4; delta_2 / 2 * (h_4 * delta_x); h_4 * delta_x / 8].
Definition T_star := 2 / (V_0 * (1 - C_eta)) * eta_bar * zeta_bar.

(* --- what is asked for, and what follows ------------------------------------------------------ *)

Definition admissible : Prop :=
  0 < r < 1 /\ 0 < c <= 1 /\
  3 * r * ((1 + r) / 2 * c) + r * (1 + r) < ((1 + r) / 2 * c) ^ 3 /\
  0 < V_0 /\ 0 < delta_theta.

Definition initial d x v d_0 y : Prop :=
  distance d x B0 B2 = 1 + d_0 /\ rate d x v B0 B2 = - y * (1 + d_0) /\
  distance d x B0 B1 = 1 /\ 0 < rate d x v B0 B1 /\
  0 < y <= eta_bar /\ Rabs (rate d x v B0 B1 - phi_minus * y) <= x_0 * y /\
  0 < d_0 <= Rmin d_const (d_slope * y ^ 2) /\
  V_0 + (V_1 - V_0) / 3 <= dot d (from_to v B0 B1) (from_to v B0 B1) <= V_1 - (V_1 - V_0) / 3 /\
  V_0 + (V_1 - V_0) / 3 <= dot d (from_to v B0 B2) (from_to v B0 B2) <= V_1 - (V_1 - V_0) / 3 /\
  Rabs (minus_cosine d x - c) <= Delta_theta / 4.

(* Places, velocities and times after each collision: ball 0 meets 2, 1, 2, 1, ... without end. *)
Definition collapse d x v : Prop :=
  exists (places velocities : nat -> ball -> nat -> R) (time : nat -> R),
    places O = x /\ velocities O = v /\ time O = 0 /\
    (forall n, let j := if Nat.even n then B2 else B1 in
      let t := time (S n) - time n in
      meet d (places n) (velocities n) B0 j t /\
      places (S n) = moved t (places n) (velocities n) /\
      collide d r (places (S n)) (velocities n) j (velocities (S n))) /\
    (exists T, Un_cv time T /\ T <= T_star) /\
    (exists l, Un_cv (fun n => minus_cosine d (places n)) l /\ Rabs (l - c) <= Delta_theta).
End Constants.

Definition theorem_1 : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d x v d_0 y, initial r c V_0 delta_theta d x v d_0 y ->
    collapse r c V_0 delta_theta d x v.
Definition not_empty : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d, (2 <= d)%nat -> exists x v d_0 y, initial r c V_0 delta_theta d x v d_0 y.
Definition determined : Prop :=
  forall d x v i j t i' j' t', i <> j -> i' <> j' -> meet d x v i j t -> meet d x v i' j' t' ->
    t = t' /\ ((i = i' /\ j = j') \/ (i = j' /\ j = i')).

(* --- Theorem1.v says just this ---------------------------------------------------------------- *)

Definition placed (x v : ball -> nat -> R) : Theorem1.scene := Theorem1.Scene x v.
Lemma same_admissible r c V_0 delta_theta :
  Theorem1.admissible r c V_0 delta_theta <-> admissible r c V_0 delta_theta.
Proof. split; [intros [] | intros (? & ? & ? & ? & ?)]; repeat split; tauto. Qed.
Lemma same_initial r c V_0 delta_theta d x v d_0 y :
  Theorem1.initial r c V_0 delta_theta d (placed x v) d_0 y <-> initial r c V_0 delta_theta d x v d_0 y.
Proof.
  split; [intros [] | intros (? & ? & ? & ? & ? & ? & ? & ? & ? & ?); constructor]; try assumption.
  repeat (split; [assumption|]). assumption.
Qed.
Lemma same_meet d x v i j t : Theorem1.first_to_meet d (placed x v) i j t <-> meet d x v i j t.
Proof.
  split; [intros [] | intros (? & ? & ? & ? & ?); constructor]; try assumption.
  repeat (split; [assumption|]). assumption.
Qed.
Lemma same_collision d r x v j w t : j <> B0 ->
  placed (moved t x v) w = Theorem1.collided d r j (Theorem1.later t (placed x v)) <->
  collide d r (moved t x v) v j w.
Proof.
  intros N. split.
  - intros E. injection E as E. subst w.
    repeat split; intros; destruct j; try (now destruct N); try reflexivity;
      destruct i; try reflexivity; try (now destruct H); now destruct H0.
  - intros (A & B & C). unfold placed, Theorem1.collided. f_equal. extensionality i. extensionality k.
    destruct i, j; try (now destruct N); try apply A; try apply B; apply C; discriminate.
Qed.
Lemma same_collapse r c V_0 delta_theta d x v :
  Theorem1.collapse r c V_0 delta_theta d (placed x v) <-> collapse r c V_0 delta_theta d x v.
Proof.
  assert (N : forall n, Theorem1.collides_with n <> B0)
    by (intros n; unfold Theorem1.collides_with; destruct Nat.even; discriminate).
  split.
  - intros (s & t & A & B & C & D & E).
    exists (fun n => Theorem1.position (s n)), (fun n => Theorem1.velocity (s n)), t.
    rewrite A. repeat (split; [reflexivity || assumption|]). split; [|split; assumption].
    intros n. destruct (C n) as [F G]. cbn zeta. change (if Nat.even n then B2 else B1) with (Theorem1.collides_with n).
    split; [|split].
    + apply same_meet. unfold placed. destruct (s n). exact F.
    + now rewrite G.
    + replace (Theorem1.position (s (S n))) with
        (moved (t (S n) - t n) (Theorem1.position (s n)) (Theorem1.velocity (s n))) by now rewrite G.
      apply same_collision; [apply N|]. rewrite G. reflexivity.
  - intros (p & w & t & A & B & C & D & E & F).
    exists (fun n => placed (p n) (w n)), t. rewrite A, B.
    repeat (split; [reflexivity || assumption|]). split; [|split; assumption].
    intros n. destruct (D n) as (G & H & I). split; [now apply same_meet|].
    rewrite H in *. apply same_collision; [apply N | exact I].
Qed.
Theorem same_theorem : Theorem1.theorem_1 <-> theorem_1.
Proof.
  split.
  - intros A r c V_0 delta_theta B d x v d_0 y C. apply same_collapse.
    apply A with d_0 y; [now apply same_admissible | now apply same_initial].
  - intros A r c V_0 delta_theta B d [x v] d_0 y C. apply same_collapse.
    apply A with d_0 y; [now apply same_admissible | now apply same_initial].
Qed.
Theorem same_not_empty : Theorem1.not_empty <-> not_empty.
Proof.
  split; intros A r c V_0 delta_theta B d C; apply same_admissible in B.
  - destruct (A _ _ _ _ B d C) as ([x v] & d_0 & y & D). exists x, v, d_0, y. now apply same_initial.
  - destruct (A _ _ _ _ B d C) as (x & v & d_0 & y & D). exists (placed x v), d_0, y. now apply same_initial.
Qed.
Theorem same_determined : Theorem1.determined <-> determined.
Proof.
  split; intros A d.
  - intros x v i j t i' j' t' B C D E. apply (A d (placed x v)); trivial; now apply same_meet.
  - intros [x v] i j t i' j' t' B C D E. apply (A d x v); trivial; now apply same_meet.
Qed.

(* --- what is proved --------------------------------------------------------------------------- *)

Check (Inhabited.theorem_1_proved :
  Theorem1.theorem_1 /\ Theorem1.not_empty /\ Theorem1.determined).
Theorem proved : theorem_1 /\ not_empty /\ determined.
Proof.
  destruct Inhabited.theorem_1_proved as (A & B & C).
  split; [now apply same_theorem | split; [now apply same_not_empty | now apply same_determined]].
Qed.

(* It is about something: these are admissible parameters, with scenes that collapse. *)
Theorem admissible_parameters : admissible (3 / 100) 1 1 1.
Proof. repeat split; lra. Qed.
Theorem collapsing_scene : exists x v, collapse (3 / 100) 1 1 1 2 x v.
Proof.
  destruct proved as (A & B & _).
  destruct (B _ _ _ _ admissible_parameters 2%nat (Nat.le_refl 2)) as (x & v & d_0 & y & C).
  exists x, v. exact (A _ _ _ _ admissible_parameters _ _ _ _ _ C).
Qed.
Print Assumptions collapsing_scene.
