(* From a scene of an initial set that is described by any numbers that satisfy the conditions of the
   step: ball 0 collides with 2 and 1 in turn without end, and the balls collapse. Collapse.v has
   such numbers for all parameters; a point run has others, rounded ones. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Sequences Meaning Terms Citations Readable Extension.
From Verify Require Import Gram OneStep Trajectory InTurn Ending.
From Verify Require AnyStep Step.
Import ListNotations.
Open Scope R_scope.

(* The initial set of Theorem1.v, for constants that may be any numbers. *)
Record initial_with (phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c : R)
    (d : nat) (s : scene) (d_0 y : R) : Prop := {
  distance_with : distance d s B0 B2 = 1 + d_0;
  speed_with : rate d s B0 B2 = - y * (1 + d_0);
  touch_with : distance d s B0 B1 = 1;
  recede_with : 0 < rate d s B0 B1;
  slow_with : 0 < y <= eta_bar;
  ratio_with : Rabs (rate d s B0 B1 - phi_minus * y) <= x_0 * y;
  near_with : 0 < d_0 <= Rmin d_const (d_slope * y ^ 2);
  speed_1_with : V_0 + (V_1 - V_0) / 3 <= dot d (relative s B0 B1) (relative s B0 B1)
    <= V_1 - (V_1 - V_0) / 3;
  speed_2_with : V_0 + (V_1 - V_0) / 3 <= dot d (relative s B0 B2) (relative s B0 B2)
    <= V_1 - (V_1 - V_0) / 3;
  angle_with : Rabs (minus_cosine d s - c) <= Delta_theta / 4
}.

(* Its numbers: the inner products of the directions and the relative velocities of balls 1 and 2. *)
Definition numbers_with (d : nat) (s : scene) (d_0 y : R) : AnyStep.numbers :=
  let p := to s B0 B1 in let q := scaled (/ (1 + d_0)) (to s B0 B2) in
  let w_s := relative s B0 B1 in let w_c := relative s B0 B2 in
  AnyStep.Numbers y (rate d s B0 B1) (minus_cosine d s) (dot d p w_c) (dot d q w_s) (dot d w_c w_c)
    (dot d w_s w_s) (dot d w_s w_c) d_0.
Lemma numbers_of_initial phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d s d_0 y :
  initial_with phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d s d_0 y ->
  AnyStep.has (numbers_with d s d_0 y) d s B1 B2.
Proof.
  intros [G1 G2 G3 _ _ _ [G4 _] _ _ _]. unfold numbers_with. eexists.
  split; [|split]; cbn [AnyStep.y AnyStep.eta_s AnyStep.C AnyStep.a AnyStep.b AnyStep.A AnyStep.B
    AnyStep.w AnyStep.d]; try reflexivity.
  - apply same_vector. intros k. unfold scaled. field. lra.
  - change (square d s B0 B1 = 1). rewrite square_of_distance, G3. ring.
  - rewrite dot_scaled, dot_scaled_right.
    change (dot d (to s B0 B2) (to s B0 B2)) with (square d s B0 B2).
    rewrite square_of_distance, G1. field. lra.
  - unfold minus_cosine. rewrite dot_scaled_right, G1, G3. field. lra.
  - rewrite dot_scaled. fold (rate d s B0 B2). rewrite G2. field. lra.
Qed.
(* Scenes into which those of a set fly while no two balls touch. *)
Definition flown_from (d : nat) (set : scene -> R -> R -> Prop) (s : scene) : Prop :=
  exists s_0 d_0 y u, set s_0 d_0 y /\ 0 <= u /\
    (forall v i j, 0 < v <= u -> i <> j -> 1 < distance d (later v s_0) i j) /\ s = later u s_0.

Definition numbers_context := Eval vm_compute in parent_of S0 start_context.

Section FromNumbers.
Variable numbers : valuation.
Hypothesis numbers_good : scope S0 numbers_context numbers.

(* Each given of the step, for these numbers. *)
Definition the_givens := Eval vm_compute in
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 numbers_context).
Lemma the_givens_are :
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 numbers_context) = the_givens.
Proof. vm_compute. reflexivity. Qed.
Lemma given_of_numbers g :
  (if in_dec same_shown g the_givens then true else false) = true -> shown_here numbers g.
Proof.
  intros G. destruct (in_dec _ _ _) as [J|]; [clear G | discriminate].
  rewrite <- the_givens_are in J. apply in_map_iff in J. destruct J as (a & <- & J).
  apply (read_claim_right S0 Step.the_order Step.the_table Step.the_table_is _ _ _ Step.all_right).
  pose proof (numbers_good numbers_context) as A. unfold satisfies in A. rewrite Forall_forall in A.
  exact (A (or_introl eq_refl) a J).
Qed.

(* A scene of the initial set, and its numbers. *)
Variable D : nat.
Variable s : scene.
Variables d_0 y : R.
Hypothesis good_scene : initial_with (numbers Step.number_of_phi_minus) (numbers Step.number_of_x_0)
  (numbers Step.number_of_eta_bar) (numbers Step.number_of_d_const) (numbers Step.number_of_d_slope)
  (numbers Step.number_of_V_0) (numbers Step.number_of_V_1) (numbers Step.number_of_Delta_theta)
  (numbers Step.number_of_c) D s d_0 y.

Definition starting : valuation := fun x =>
  let m := numbers_with D s d_0 y in
  if Pos.eqb x Step.number_of_y_start then AnyStep.y m
  else if Pos.eqb x Step.number_of_eta_s_start then AnyStep.eta_s m
  else if Pos.eqb x Step.number_of_C_start then AnyStep.C m
  else if Pos.eqb x Step.number_of_a_start then AnyStep.a m
  else if Pos.eqb x Step.number_of_b_start then AnyStep.b m
  else if Pos.eqb x Step.number_of_A_start then AnyStep.A m
  else if Pos.eqb x Step.number_of_B_start then AnyStep.B m
  else if Pos.eqb x Step.number_of_w_start then AnyStep.w m
  else AnyStep.d m.
Definition start_keys := Eval vm_compute in
  match context_at S0 start_context with Some x => variables x | None => [] end.
Definition at_start : valuation := extended numbers start_keys starting.
Lemma same_number x : existsb (Pos.eqb x) start_keys = false -> at_start x = numbers x.
Proof. unfold at_start, extended. now intros ->. Qed.
Definition the_start := Eval vm_compute in
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 start_context).
Lemma the_start_is :
  map (fun a => read_claim Step.the_table (given_claim a)) (givens_of S0 start_context) = the_start.
Proof. vm_compute. reflexivity. Qed.
Lemma start_good : scope S0 start_context at_start.
Proof.
  apply (scope_extended S0 well Step.the_table start_context numbers start_keys starting
    Step.the_table_is).
  - unfold start_context. lia.
  - vm_compute. reflexivity.
  - exact numbers_good.
  - fold at_start.
    assert (A : Forall (shown_here at_start) the_start).
    { destruct good_scene as [_ _ _ G1 [G2 G3] G4 [G5 G6] [G7 G8] [G9 G10] G11].
      apply within in G4, G11. destruct G4 as [G12 G4], G11 as [G13 G11].
      assert (G14 : numbers Step.number_of_c - minus_cosine D s <=
        numbers Step.number_of_Delta_theta / 4) by lra.
      pose proof (Rle_trans _ _ _ G6 (Rmin_l _ _)) as G15.
      pose proof (Rle_trans _ _ _ G6 (Rmin_r _ _)) as G16. clear G6 G13.
      unfold the_start. repeat (apply Forall_cons; [first [exact G1 | exact G2 | exact G3 | exact G4
        | exact G5 | exact G7 | exact G8 | exact G9 | exact G10 | exact G11 | exact G12 | exact G14
        | exact G15 | exact G16]|]). apply Forall_nil. }
    apply (givens_shown S0 Step.the_order _ Step.the_table_is _ Step.all_right). now rewrite the_start_is.
Qed.

Lemma started x t : put start x = Some t ->
  after S0 at_start start x = show S0 Step.all_values at_start (read Step.the_table 400 t).
Proof. exact (substituted S0 Step.the_order _ Step.the_table_is _ Step.all_right _ _ _ _). Qed.
Lemma start_shown : shows (after S0 at_start start) D s B1 B2.
Proof.
  pose proof (numbers_of_initial _ _ _ _ _ _ _ _ _ _ _ _ _ good_scene) as A. unfold shows.
  replace (numbers_of (after S0 at_start start)) with (numbers_with D s d_0 y); [exact A|].
  unfold numbers_of, numbers_with.
  f_equal; symmetry; match goal with |- after _ _ _ ?x = _ => exact (started x _ eq_refl) end.
Qed.

(* --- what follows ----------------------------------------------------------------------------- *)

Lemma clock_starts : time at_start O = 0.
Proof. transitivity (IZR 0); [exact (started Step.number_of_clock _ eq_refl) | reflexivity]. Qed.
Lemma scenes_in_turn : collides_in_turn D (numbers Step.number_of_r) (scenes at_start D s) (time at_start).
Proof.
  pose proof (scenes_collide_in_turn at_start start_good D s start_shown) as A.
  now rewrite same_number in A by reflexivity.
Qed.
Lemma ends_by : exists T, Un_cv (time at_start) T /\ T <= numbers Step.number_of_T_star.
Proof.
  destruct (finite_time at_start start_good D s start_shown) as (T & L & B). exists T.
  split; [exact L | exact B].
Qed.
Lemma angle_tends : exists l, Un_cv (fun n => minus_cosine D (scenes at_start D s n)) l /\
  Rabs (l - numbers Step.number_of_c) <= drift at_start.
Proof.
  destruct (angle_converges at_start start_good D s start_shown) as (l & L & B). exists l. split.
  - intros e E. destruct (L e E) as [m M]. exists m. intros n N.
    rewrite (cosine_is at_start start_good D s start_shown). exact (M n N).
  - now rewrite same_number in B by reflexivity.
Qed.
Lemma angle_stays n : Rabs (minus_cosine D (scenes at_start D s n) - numbers Step.number_of_c) <=
  numbers Step.number_of_delta_theta.
Proof.
  rewrite (cosine_is at_start start_good D s start_shown). unfold cosine.
  set (w := state S0 at_start start next n).
  assert (W : scope S0 state_context w) by exact (always_good at_start start_good D s start_shown n).
  assert (K : w Step.number_of_c = numbers Step.number_of_c /\
    w Step.number_of_delta_theta = numbers Step.number_of_delta_theta).
  { unfold w. rewrite !kept_value, !same_number by reflexivity. split; reflexivity. }
  assert (U : w Step.number_of_C - w Step.number_of_c <= w Step.number_of_delta_theta).
  { refine (row_in_scope S0 Step.the_order Step.the_table Step.the_table_is Step.the_rows_hold
      Step.all_values _ _ _ w Step.all_right Step.row_of_angle_final_upper_is _); exact W. }
  assert (L : w Step.number_of_c - w Step.number_of_C <= w Step.number_of_delta_theta).
  { refine (row_in_scope S0 Step.the_order Step.the_table Step.the_table_is Step.the_rows_hold
      Step.all_values _ _ _ w Step.all_right Step.row_of_angle_final_lower_is _); exact W. }
  destruct K as [<- <-]. apply Rabs_le. lra.
Qed.
Lemma restitution_good : 0 < numbers Step.number_of_r < 1.
Proof.
  split.
  - refine (given_of_numbers (Less, Whole 0, Named Step.number_of_r) _). vm_compute. reflexivity.
  - refine (given_of_numbers (Less, Named Step.number_of_r, Whole 1) _). vm_compute. reflexivity.
Qed.
Theorem collapse_from_numbers : collapse D (numbers Step.number_of_r) s
  (numbers Step.number_of_T_star) (numbers Step.number_of_c) (numbers Step.number_of_delta_theta).
Proof.
  destruct ends_by as (T & L & B).
  pose proof (in_turn_collapses D _ restitution_good (scenes at_start D s) (time at_start) T
    clock_starts scenes_in_turn L) as P.
  exists (scenes at_start D s), (time at_start), T. do 2 eexists. split; [exact P|].
  split; [exact B|].
  exact (limit_within _ _ _ _ (Theorem1.angle_converges _ _ _ _ _ _ _ _ P) angle_stays).
Qed.
End FromNumbers.

(* A statement that begins with the step, and applies it to constants. *)
Lemma numbers_of_row S1 at_ : begins S0 S1 (size S0 S1) = true ->
  says S1 0 (Applies numbers_context at_) ->
  scope S0 numbers_context (after S1 (fun _ => 0) at_).
Proof.
  intros B A. apply (scope_same S0 S1 (size S0 S1) B); [vm_compute; lia|].
  apply A. intros k [<-|[]]. apply Forall_nil.
Qed.
