(* A scene in every dimension from 2 on, in the plane of the first two coordinates, and its numbers:
   for an initial set that is described by any numbers that leave room for it. The certificate of the
   step proves that those of Theorem1.v do. The scene lies in the initial set, and Interior.v shows what
   is near it. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Readable Gram OneStep Collapse.
From Verify Require Step.
Import ListNotations.
Open Scope R_scope.

Opaque numbers.  (* nothing is to be computed from them *)

Section Point.
Variables phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c : R.
Variable d : nat.
Hypothesis enough : (2 <= d)%nat.

Definition y : R := eta_bar / 2.
Definition eta_s : R := phi_minus * y.
Definition d_0 : R := Rmin d_const (d_slope * y ^ 2) / 2.
Definition norm : R := (V_0 + V_1) / 2.
Definition sine : R := sqrt (1 - c * c).
Definition free_s : R := sqrt (norm - eta_s * eta_s).
Definition free_c : R := sqrt (norm - y * y).
Definition point : scene := Scene
  (fun i => match i with
    | B0 => plane 0 0 | B1 => plane 1 0 | B2 => plane ((1 + d_0) * - c) ((1 + d_0) * sine) end)
  (fun i => match i with
    | B0 => plane 0 0 | B1 => plane eta_s free_s
    | B2 => plane (y * c + free_c * sine) (- y * sine + free_c * c) end).

Ltac in_plane := apply same_vector; unfold to, relative; intros [|[|k]]; cbn; ring.

Record room : Prop := {
  room_angle : 0 < c <= 1; room_phi : 0 < phi_minus; room_x : 0 < x_0; room_eta : 0 < eta_bar;
  room_const : 0 < d_const; room_slope : 0 < d_slope; room_theta : 0 < Delta_theta;
  room_speeds : V_0 < V_1; room_c : y ^ 2 < norm; room_s : eta_s ^ 2 < norm
}.
Hypothesis roomy : room.

(* Its numbers. *)
Record numbers_of_point : Prop := {
  bounds : 0 < d_0 < Rmin d_const (d_slope * y ^ 2);
  point_touch : distance d point B0 B1 = 1;
  point_distance : distance d point B0 B2 = 1 + d_0;
  point_recede : rate d point B0 B1 = eta_s;
  point_approach : rate d point B0 B2 = - y * (1 + d_0);
  point_speed_1 : dot d (relative point B0 B1) (relative point B0 B1) = norm;
  point_speed_2 : dot d (relative point B0 B2) (relative point B0 B2) = norm;
  point_angle : minus_cosine d point = c
}.
Lemma numbers_of_point_are : numbers_of_point.
Proof.
  assert (P : to point B0 B1 = plane 1 0) by in_plane.
  assert (Q : to point B0 B2 = plane ((1 + d_0) * - c) ((1 + d_0) * sine)) by in_plane.
  assert (S : relative point B0 B1 = plane eta_s free_s) by in_plane.
  assert (C : relative point B0 B2 = plane (y * c + free_c * sine) (- y * sine + free_c * c)) by in_plane.
  destruct roomy as [[c0 c1] K1 _ K2 K3 K4 _ K5 Room_c Room_s].
  assert (Y : 0 < y) by (unfold y; lra).
  assert (N : 0 < Rmin d_const (d_slope * y ^ 2)).
  { apply Rmin_glb_lt; trivial. apply Rmult_lt_0_compat; trivial. now apply pow_lt. }
  assert (E : 0 < eta_s) by now apply Rmult_lt_0_compat.
  assert (Sine : sine * sine = 1 - c * c).
  { apply sqrt_sqrt. assert (c * c <= 1 * 1) by (apply Rmult_le_compat; lra). lra. }
  assert (Fs : free_s * free_s = norm - eta_s * eta_s).
  { apply sqrt_sqrt. cbn in Room_s. lra. }
  assert (Fc : free_c * free_c = norm - y * y).
  { apply sqrt_sqrt. cbn in Room_c. lra. }
  assert (D1 : distance d point B0 B1 = 1).
  { apply distance_one. unfold square. rewrite P, dot_plane by exact enough. ring. }
  assert (D2 : distance d point B0 B2 = 1 + d_0).
  { unfold distance. rewrite Q, dot_plane by exact enough.
    replace ((1 + d_0) * - c * ((1 + d_0) * - c) + (1 + d_0) * sine * ((1 + d_0) * sine))
      with ((1 + d_0) * (1 + d_0) * (c * c + sine * sine)) by ring.
    rewrite Sine.
    replace ((1 + d_0) * (1 + d_0) * (c * c + (1 - c * c))) with ((1 + d_0) * (1 + d_0)) by ring.
    apply sqrt_square. unfold d_0. lra. }
  assert (D0 : 0 < d_0) by (unfold d_0; lra).
  split; trivial.
  - unfold d_0 in *. lra.
  - unfold rate. rewrite P, S, dot_plane by exact enough. ring.
  - unfold rate. rewrite Q, C, dot_plane by exact enough.
    replace ((1 + d_0) * - c * (y * c + free_c * sine) + (1 + d_0) * sine * (- y * sine + free_c * c))
      with (- (1 + d_0) * y * (c * c + sine * sine)) by ring.
    rewrite Sine. ring.
  - rewrite S, dot_plane, Fs by exact enough. ring.
  - rewrite C, dot_plane by exact enough.
    replace ((y * c + free_c * sine) * (y * c + free_c * sine) +
      (- y * sine + free_c * c) * (- y * sine + free_c * c))
      with ((y * y + free_c * free_c) * (c * c + sine * sine)) by ring.
    rewrite Sine, Fc. ring.
  - unfold minus_cosine. rewrite D1, D2, P, Q, dot_plane by exact enough. field. lra.
Qed.
End Point.

(* --- the constants of Theorem1.v leave room ---------------------------------------------------- *)

Section RoomForAll.
Variables r c V_0 delta_theta : R.
Hypothesis good : admissible r c V_0 delta_theta.

Ltac row row_is :=
  refine (row_in_scope S0 Step.the_order Step.the_table Step.the_table_is Step.the_rows_hold
    Step.all_values _ _ _ (numbers r c V_0 delta_theta) Step.all_right row_is _);
  exact (numbers_good r c V_0 delta_theta good).
Ltac given g := refine (given_number r c V_0 delta_theta good g _); vm_compute; reflexivity.
Lemma eta_positive : 0 < eta_bar r c V_0 delta_theta.
Proof. rewrite <- number_eta_bar. given (Less, Whole 0, Named Step.number_of_eta_bar). Qed.
Lemma phi_positive : 0 < phi_minus r c.
Proof.
  rewrite <- (number_phi_minus r c V_0 delta_theta).
  given (Less, Whole 0, Named Step.number_of_phi_minus).
Qed.
Lemma x_0_positive : 0 < x_0 r c V_0.
Proof.
  rewrite <- (number_x_0 r c V_0 delta_theta). given (Less, Whole 0, Named Step.number_of_x_0).
Qed.
Lemma theta_positive : 0 < Delta_theta r c V_0 delta_theta.
Proof. rewrite <- number_Delta_theta. given (Less, Whole 0, Named Step.number_of_Delta_theta). Qed.
Lemma const_positive : 0 < d_const r c V_0 delta_theta.
Proof. rewrite <- number_d_const. given (Less, Whole 0, Named Step.number_of_d_const). Qed.
Lemma slope_positive : 0 < d_slope r c V_0.
Proof.
  rewrite <- (number_d_slope r c V_0 delta_theta).
  given (Less, Whole 0, Named Step.number_of_d_slope).
Qed.
Lemma speeds : V_0 < V_1 r c V_0.
Proof.
  rewrite <- (number_V_1 r c V_0 delta_theta). rewrite <- (number_V_0 r c V_0 delta_theta) at 1.
  given (Less, Named Step.number_of_V_0, Named Step.number_of_V_1).
Qed.
Lemma room_for_c : y (eta_bar r c V_0 delta_theta) ^ 2 < norm V_0 (V_1 r c V_0).
Proof.
  unfold norm, y. rewrite <- number_eta_bar, <- (number_V_1 r c V_0 delta_theta).
  rewrite <- (number_V_0 r c V_0 delta_theta) at 2. row Step.row_of_room_c_is.
Qed.
Lemma room_for_s : eta_s (phi_minus r c) (eta_bar r c V_0 delta_theta) ^ 2 < norm V_0 (V_1 r c V_0).
Proof.
  unfold norm, eta_s, y.
  rewrite <- number_eta_bar, <- (number_V_1 r c V_0 delta_theta).
  rewrite <- (number_phi_minus r c V_0 delta_theta).
  rewrite <- (number_V_0 r c V_0 delta_theta) at 3. row Step.row_of_room_s_is.
Qed.
Theorem constants_leave_room : room (phi_minus r c) (x_0 r c V_0) (eta_bar r c V_0 delta_theta)
  (d_const r c V_0 delta_theta) (d_slope r c V_0) V_0 (V_1 r c V_0) (Delta_theta r c V_0 delta_theta) c.
Proof.
  split; [exact (angle_obtuse _ _ _ _ good) | exact phi_positive | exact x_0_positive
    | exact eta_positive | exact const_positive | exact slope_positive | exact theta_positive
    | exact speeds | exact room_for_c | exact room_for_s].
Qed.
End RoomForAll.
