(* The set has an interior. A scene of the initial set for which all inequalities are strict flies on
   for a while; each scene near the one into which it flies comes from another scene of the set. *)
From Coq Require Import Reals List Lra Lia Ranalysis.
From Verify Require Import Theorem1 Vectors Motion Determined FromNumbers Collapse OneScene Steady.
Open Scope R_scope.

Section Interior.
Variables phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c : R.
Variable d : nat.
Notation initial :=
  (initial_with phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d).
Hypothesis first_meeting : forall s d_0 y, initial s d_0 y -> exists t, first_to_meet d s B0 B2 t.

(* --- the initial set by strict inequalities --------------------------------------------------- *)

Definition gap (s : scene) : R := distance d s B0 B2 - 1.
Definition approach_speed (s : scene) : R := - rate d s B0 B2 / distance d s B0 B2.
Definition lowest : R := V_0 + (V_1 - V_0) / 3.
Definition highest : R := V_1 - (V_1 - V_0) / 3.
Record inside (s : scene) : Prop := {
  gap_open : 0 < gap s;
  gap_const : gap s < d_const;
  gap_slope : gap s < d_slope * (approach_speed s * approach_speed s);
  recede_open : 0 < rate d s B0 B1;
  approach_open : 0 < approach_speed s;
  slow_open : approach_speed s < eta_bar;
  ratio_open : Rabs (rate d s B0 B1 - phi_minus * approach_speed s) < x_0 * approach_speed s;
  low_1 : lowest < dot d (relative s B0 B1) (relative s B0 B1);
  high_1 : dot d (relative s B0 B1) (relative s B0 B1) < highest;
  low_2 : lowest < dot d (relative s B0 B2) (relative s B0 B2);
  high_2 : dot d (relative s B0 B2) (relative s B0 B2) < highest;
  angle_open : Rabs (minus_cosine d s - c) < Delta_theta / 4
}.
Lemma inside_initial s : inside s -> distance d s B0 B1 = 1 ->
  initial s (gap s) (approach_speed s).
Proof.
  intros [G1 G2 G3 P A1 A2 Q L1 H1 L2 H2 C] T.
  replace (approach_speed s * approach_speed s) with (approach_speed s ^ 2) in G3 by ring.
  unfold gap, lowest, highest in *.
  split; try lra.
  - unfold approach_speed. field. lra.
  - split; trivial. apply Rmin_glb; lra.
Qed.

(* --- near a scene of it ----------------------------------------------------------------------- *)

Variable s_0 : scene.
Hypothesis inside_0 : inside s_0.
Hypothesis touch_0 : distance d s_0 B0 B1 = 1.

Lemma steady_now f : steady d s_0 (fun s => f (later 0 s)) -> steady d s_0 f.
Proof.
  intros A e E. generalize (A e E). apply nearby_follows. intros s. now rewrite !later_0.
Qed.
Lemma steady_distance_now i j : steady d s_0 (fun s => distance d s i j).
Proof. apply (steady_now (fun s => distance d s i j)), steady_distance. Qed.
Lemma steady_rate_now i j : steady d s_0 (fun s => rate d s i j).
Proof. apply (steady_now (fun s => rate d s i j)), steady_rate. Qed.
Lemma steady_speed i j : steady d s_0 (fun s => dot d (relative s i j) (relative s i j)).
Proof. apply steady_dot; apply steady_relative. Qed.
Lemma steady_gap : steady d s_0 gap.
Proof.
  apply (steady_plus d s_0 (fun s => distance d s B0 B2)); [|apply steady_constant].
  apply steady_distance_now.
Qed.
Lemma steady_approach : steady d s_0 approach_speed.
Proof.
  apply steady_quotient.
  - apply steady_opposite, steady_rate_now.
  - apply steady_distance_now.
  - pose proof (gap_open _ inside_0). unfold gap in *. lra.
Qed.
Lemma steady_angle : steady d s_0 (minus_cosine d).
Proof.
  apply steady_opposite, steady_quotient.
  - apply (steady_now (fun s => dot d (to s B0 B1) (to s B0 B2))). apply steady_dot; apply steady_to.
  - apply steady_times; apply steady_distance_now.
  - rewrite touch_0. pose proof (gap_open _ inside_0). unfold gap in *. lra.
Qed.
Lemma inside_nearby : nearby d s_0 inside.
Proof.
  pose proof steady_gap as G. pose proof steady_approach as A. pose proof steady_angle as C.
  pose proof (steady_rate_now B0 B1) as R1. pose proof (steady_speed B0 B1) as S1.
  pose proof (steady_speed B0 B2) as S2. pose proof (steady_constant d s_0) as K.
  destruct inside_0 as [I1 I2 I3 I4 I5 I6 I7 I8 I9 I10 I11 I12].
  apply (steady_less d s_0 _ _ (K 0) G) in I1. apply (steady_less d s_0 _ _ G (K _)) in I2.
  apply (steady_less d s_0 _ _ G (steady_times _ _ _ _ (K _) (steady_times _ _ _ _ A A))) in I3.
  apply (steady_less d s_0 _ _ (K 0) R1) in I4. apply (steady_less d s_0 _ _ (K 0) A) in I5.
  apply (steady_less d s_0 _ _ A (K _)) in I6.
  apply (steady_less d s_0 _ _ (steady_absolute _ _ _ (steady_plus _ _ _ _ R1
    (steady_opposite _ _ _ (steady_times _ _ _ _ (K _) A)))) (steady_times _ _ _ _ (K _) A)) in I7.
  apply (steady_less d s_0 _ _ (K _) S1) in I8. apply (steady_less d s_0 _ _ S1 (K _)) in I9.
  apply (steady_less d s_0 _ _ (K _) S2) in I10. apply (steady_less d s_0 _ _ S2 (K _)) in I11.
  apply (steady_less d s_0 _ _ (steady_absolute _ _ _ (steady_plus _ _ _ _ C (K (- c)))) (K _)) in I12.
  generalize (nearby_both _ _ _ _ I1 (nearby_both _ _ _ _ I2 (nearby_both _ _ _ _ I3
    (nearby_both _ _ _ _ I4 (nearby_both _ _ _ _ I5 (nearby_both _ _ _ _ I6 (nearby_both _ _ _ _ I7
    (nearby_both _ _ _ _ I8 (nearby_both _ _ _ _ I9 (nearby_both _ _ _ _ I10
    (nearby_both _ _ _ _ I11 I12))))))))))).
  apply nearby_follows. intros s (J1 & J2 & J3 & J4 & J5 & J6 & J7 & J8 & J9 & J10 & J11 & J12).
  now split.
Qed.

(* --- a contact nearby ------------------------------------------------------------------------- *)

Lemma square_later t s i j : square d (later t s) i j =
  square d s i j + 2 * t * rate d s i j + t * t * dot d (relative s i j) (relative s i j).
Proof. unfold square, rate. rewrite to_later, square_of_combined. ring. Qed.
Lemma rate_later t s i j :
  rate d (later t s) i j = rate d s i j + t * dot d (relative s i j) (relative s i j).
Proof. unfold rate. rewrite to_later, relative_later, dot_linear. ring. Qed.
Lemma contact_nearby t : 0 < t ->
  nearby d s_0 (fun s => exists u, Rabs u < t /\ distance d (later u s) B0 B1 = 1).
Proof.
  intros P. pose proof (recede_open _ inside_0) as R0.
  set (w := dot d (relative s_0 B0 B1) (relative s_0 B0 B1)).
  pose proof (dot_self d (relative s_0 B0 B1)) as W. fold w in W. set (h := rate d s_0 B0 B1) in *.
  set (u := Rmin (t / 2) (h / (1 + w))).
  assert (U : 0 < u) by (apply Rmin_glb_lt; [lra | apply Rdiv_lt_0_compat; lra]).
  pose proof (Rmin_l (t / 2) (h / (1 + w))) as U1. pose proof (Rmin_r (t / 2) (h / (1 + w))) as U2.
  fold u in U1, U2.
  assert (L : u * w < h).
  { apply (Rmult_le_compat_r (1 + w)) in U2; [|lra].
    replace (h / (1 + w) * (1 + w)) with h in U2 by (field; lra). lra. }
  assert (E : square d s_0 B0 B1 = 1) by (rewrite square_of_distance, touch_0; ring).
  assert (F : 1 < square d (later u s_0) B0 B1).
  { rewrite square_later, E. fold h w. assert (0 < u * h) by now apply Rmult_lt_0_compat.
    assert (0 <= u * u * w) by (repeat apply Rmult_le_pos; lra). lra. }
  assert (G : square d (later (- u) s_0) B0 B1 < 1).
  { rewrite square_later, E. fold h w. pose proof (Rmult_lt_compat_l u _ _ U L).
    assert (0 < u * h) by now apply Rmult_lt_0_compat. lra. }
  apply (steady_less d s_0 _ _ (steady_constant d s_0 1) (steady_square d s_0 u B0 B1)) in F.
  apply (steady_less d s_0 _ _ (steady_square d s_0 (- u) B0 B1) (steady_constant d s_0 1)) in G.
  generalize (nearby_both _ _ _ _ F G). apply nearby_follows. intros s [A B].
  destruct (IVT (fun x => square d (later x s) B0 B1 - 1) (- u) u) as (x & X & Z); try lra.
  - intros x. apply continuity_pt_locally_ext with (a := 1)
      (f := fun x => square d s B0 B1 + 2 * x * rate d s B0 B1 +
        x * x * dot d (relative s B0 B1) (relative s B0 B1) - 1); [lra| |].
    + intros y _. now rewrite square_later.
    + reg.
  - exists x. split; [apply Rabs_def1; lra|]. apply distance_one. lra.
Qed.

(* --- a flight without a collision ------------------------------------------------------------- *)

(* Balls 0 and 2 still approach, and have not met: then nobody has. *)
Lemma nobody_yet s u : inside s -> distance d s B0 B1 = 1 -> 0 < u ->
  1 < distance d (later u s) B0 B2 -> rate d (later u s) B0 B2 < 0 ->
  forall v i j, 0 < v <= u -> i <> j -> 1 < distance d (later v s) i j.
Proof.
  intros I T U A B. destruct (first_meeting s _ _ (inside_initial s I T)) as (t & [P F C _ _]).
  assert (L : u < t); [|intros v i j V N; apply F; trivial; lra].
  apply Rnot_le_lt. intros N.
  assert (Q : later t s = later (t - u) (later u s)) by (rewrite later_later; f_equal; ring).
  assert (E : square d (later (t - u) (later u s)) B0 B2 = 1).
  { rewrite <- Q, square_of_distance, C. ring. }
  assert (G : 1 < square d (later u s) B0 B2).
  { rewrite square_of_distance. apply Rlt_trans with (1 * distance d (later u s) B0 B2); [lra|].
    apply Rmult_lt_compat_r; lra. }
  rewrite square_later in E.
  assert (0 <= (t - u) * rate d (later u s) B0 B2)
    by (rewrite <- Rmult_opp_opp; apply Rmult_le_pos; lra).
  assert (0 <= (t - u) * (t - u) * dot d (relative (later u s) B0 B2) (relative (later u s) B0 B2))
    by (apply Rmult_le_pos; [apply Rle_0_sqr | apply dot_self]).
  lra.
Qed.
Theorem set_near : has_interior d (flown_from d initial).
Proof.
  destruct (first_meeting s_0 _ _ (inside_initial s_0 inside_0 touch_0)) as (t & [P F C A _]).
  (* half-way *)
  assert (D : 1 < distance d (later (t / 2) s_0) B0 B2) by (apply F; [lra | discriminate]).
  assert (B : rate d (later (t / 2) s_0) B0 B2 < 0).
  { rewrite rate_later in *. pose proof (dot_self d (relative s_0 B0 B2)) as W.
    pose proof (Rmult_le_compat_r _ (t / 2) t W ltac:(lra)). lra. }
  apply (steady_less d s_0 _ _ (steady_constant d s_0 1) (steady_distance d s_0 _ _ _)) in D.
  apply (steady_less d s_0 _ _ (steady_rate d s_0 _ _ _) (steady_constant d s_0 0)) in B.
  destruct (flight_nearby d s_0 _ inside_nearby) as (h & H & N).
  assert (M : 0 < Rmin h (t / 2)) by (apply Rmin_glb_lt; lra).
  pose proof (Rmin_l h (t / 2)) as M1. pose proof (Rmin_r h (t / 2)) as M2.
  pose proof (contact_nearby _ M) as K.
  destruct (flown_back d s_0 _ (t / 2) (nearby_both _ _ _ _ (nearby_both _ _ _ _ D B)
    (nearby_both _ _ _ _ N K)) ltac:(lra)) as (e & E & G).
  exists (later (t / 2) s_0), e. split; trivial. intros s S.
  destruct (G s S) as ([D' B'] & N' & (u & U & T)). rewrite later_back in *.
  specialize (N' u ltac:(lra)). set (s_1 := later u (later (- (t / 2)) s)) in *.
  assert (Q : s = later (t / 2 - u) s_1).
  { unfold s_1. rewrite !later_later. transitivity (later 0 s); [now rewrite later_0|]. f_equal. ring. }
  apply Rabs_def2 in U. exists s_1, (gap s_1), (approach_speed s_1), (t / 2 - u).
  split; [now apply inside_initial|]. split; [lra|]. split; [|exact Q].
  apply nobody_yet; trivial; [lra | |]; rewrite <- Q; trivial.
Qed.
End Interior.

(* The scene of OneScene.v satisfies all inequalities strictly. *)
Theorem room_is_interior phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d :
  room phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c -> (2 <= d)%nat ->
  (forall s d_0 y, initial_with phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d s d_0 y ->
    exists t, first_to_meet d s B0 B2 t) ->
  has_interior d (flown_from d
    (initial_with phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d)).
Proof.
  intros K L M. pose proof (numbers_of_point_are _ _ _ _ _ _ _ _ _ d L K) as [G T D P Q S1 S2 C].
  set (s := point _ _ _ _ _ _ _) in *. set (g := d_0 _ _ _) in *. set (v := y eta_bar) in *.
  apply set_near with s; trivial. destruct K as [? K1 K2 K3 K4 K5 K6 K7 _ _].
  assert (E : gap d s = g) by (unfold gap; rewrite D; ring).
  assert (F : approach_speed d s = v) by (unfold approach_speed; rewrite D, Q; field; lra).
  assert (V : 0 < v < eta_bar) by (unfold v, y; lra).
  destruct G as [G0 G]. pose proof (Rlt_le_trans _ _ _ G (Rmin_l _ _)) as G1.
  pose proof (Rlt_le_trans _ _ _ G (Rmin_r _ _)) as G2.
  replace (v ^ 2) with (v * v) in G2 by ring.
  assert (0 < phi_minus * v) by (apply Rmult_lt_0_compat; lra).
  assert (0 < x_0 * v) by (apply Rmult_lt_0_compat; lra).
  split; rewrite ?E, ?F, ?P, ?S1, ?S2, ?C; trivial; try lra; unfold norm, eta_s, lowest, highest; fold v; try lra.
  - rewrite Rminus_diag_eq, Rabs_R0; trivial.
  - rewrite Rminus_diag_eq, Rabs_R0; trivial. lra.
Qed.
Theorem the_set_has_an_interior : interior.
Proof.
  intros r c V_0 delta_theta A d L.
  destruct (room_is_interior _ _ _ _ _ _ _ _ _ d (constants_leave_room r c V_0 delta_theta A) L)
    as (s & e & E & B).
  - intros s g v I. apply scene_with_constants in I.
    destruct (collides_without_end r c V_0 delta_theta A d s _ _ I) as (scenes & time & <- & _ & C & _).
    destruct (C O) as [F _]. exact (ex_intro _ _ F).
  - exists s, e. split; trivial. intros s' S. destruct (B s' S) as (s_0 & g & v & u & I & F).
    exists s_0, g, v, u. split; trivial. now apply scene_with_constants.
Qed.
