(* From each scene of the printed set the balls collapse, and with room for the angle it has an
   interior; as it is printed, it has none. The certificate of the printed set applies the sharper
   theorem to each scene. AsPrinted.v is made from it, with the numbers that its terms have after the
   flow, as in Sharper.v. *)
From Coq Require Import Reals List Lra FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Sequences Meaning Terms Citations Readable Extension.
From Verify Require Import FromNumbers TheSet OneScene Interior PrintedSet.
From Verify Require Parameters AllProved.
From Verify Require SharperStep SharperCollapse Flow Sharper AsPrinted.
Import ListNotations.
Open Scope R_scope.

(* --- the certificate ------------------------------------------------------------------------------ *)

Notation SP := AsPrinted.the_statement.
Notation SS := Sharper.the_statement.
Lemma beginning : begins SS SP (size SS SP) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma citations : citations_true SP.
Proof.
  apply (citations_closed [(Flow.the_statement, size Flow.the_statement SP); (SS, size SS SP)]).
  - vm_compute. reflexivity.
  - apply Forall_cons; [exact Flow.proved|]. apply Forall_cons; [|constructor].
    exact (Sharper.proved SharperStep.citations).
Qed.

(* What the sharper theorem is applied to: the row that says it. *)
Definition numbers_in_it := Eval vm_compute in
  match find (fun r => match row_sentence r with Applies _ _ => true | _ => false end) (rows SP) with
  | Some (Row _ _ _ _ (Applies _ at_)) => at_
  | _ => []
  end.
Lemma applied : says SP AsPrinted.context_initial (Applies SharperStep.start_context numbers_in_it).
Proof. exact (AsPrinted.collapse citations). Qed.

(* --- a scene of the set --------------------------------------------------------------------------- *)

Section PrintedScene.
Variables r c V_0 delta_theta : R.
Hypothesis good : admissible r c V_0 delta_theta.
Notation slack := (Theta r c V_0 delta_theta / 6).
Ltac row of_it := apply (of_it citations r c V_0 delta_theta); apply good.

Variable D : nat.
Variable s : scene.
Variables d_0 y : R.
Hypothesis good_scene : initial r c V_0 delta_theta slack D s d_0 y.

Definition values : valuation := fun x =>
  let m := numbers_with D s d_0 y in
  if Pos.eqb x AsPrinted.number_of_r then r else if Pos.eqb x AsPrinted.number_of_c then c
  else if Pos.eqb x AsPrinted.number_of_V_0 then V_0
  else if Pos.eqb x AsPrinted.number_of_delta_theta then delta_theta
  else if Pos.eqb x AsPrinted.number_of_y_start then AnyStep.y m
  else if Pos.eqb x AsPrinted.number_of_eta_s_start then AnyStep.eta_s m
  else if Pos.eqb x AsPrinted.number_of_C_start then AnyStep.C m
  else if Pos.eqb x AsPrinted.number_of_a_start then AnyStep.a m
  else if Pos.eqb x AsPrinted.number_of_b_start then AnyStep.b m
  else if Pos.eqb x AsPrinted.number_of_A_start then AnyStep.A m
  else if Pos.eqb x AsPrinted.number_of_B_start then AnyStep.B m
  else if Pos.eqb x AsPrinted.number_of_w_start then AnyStep.w m else AnyStep.d m.
Definition the_givens := Eval vm_compute in map (fun a => read_claim AsPrinted.the_table (given_claim a))
  (flat_map (givens_of SP) (rev (around SP AsPrinted.context_initial))).
Lemma the_givens_are : map (fun a => read_claim AsPrinted.the_table (given_claim a))
  (flat_map (givens_of SP) (rev (around SP AsPrinted.context_initial))) = the_givens.
Proof. vm_compute. reflexivity. Qed.
Lemma values_good : scope SP AsPrinted.context_initial values.
Proof.
  apply (scope_shown SP AsPrinted.the_order AsPrinted.the_table AsPrinted.the_table_is _ _ _
    AsPrinted.all_right).
  rewrite the_givens_are. destruct good as [[A1 A2] [A3 A4] A5 A6 A7].
  destruct good_scene as [_ _ _ G1 [G2 G3] G4 [G5 G6] [G7 G8] [G9 G10] G11].
  apply within in G4, G11. replace (4 * slack / 4) with slack in G11 by field.
  destruct G4 as [G12 G4], G11 as [G13 G11].
  assert (G14 : c - minus_cosine D s <= slack) by lra.
  pose proof (Rle_trans _ _ _ G6 (Rmin_l _ _)) as G15.
  pose proof (Rle_trans _ _ _ G6 (Rmin_r _ _)) as G16. clear G6 G13.
  unfold the_givens. repeat (apply Forall_cons; [first [exact A1 | exact A2 | exact A3 | exact A4
    | exact A5 | exact A6 | exact A7 | exact G1 | exact G2 | exact G3 | exact G4 | exact G5 | exact G7
    | exact G8 | exact G9 | exact G10 | exact G11 | exact G12 | exact G14 | exact G15 | exact G16]|]).
  apply Forall_nil.
Qed.

(* The numbers of the sharper theorem. *)
Definition sharper_values : valuation := after SP values numbers_in_it.
Lemma sharper_good : scope SS SharperStep.start_context sharper_values.
Proof.
  apply (scope_same SS SP (size SS SP) beginning); [vm_compute; repeat constructor|].
  exact (proj2 (applied values values_good)).
Qed.
Lemma number x t : put numbers_in_it x = Some t ->
  sharper_values x = show SP AsPrinted.all_values values (read AsPrinted.the_table 400 t).
Proof. exact (substituted SP AsPrinted.the_order _ AsPrinted.the_table_is _ AsPrinted.all_right _ _ _ _). Qed.
Lemma start_shown : AnyStep.has
  (SharperStep.numbers_of (after SS sharper_values SharperStep.start)) D s B1 B2.
Proof.
  rewrite SharperCollapse.first_numbers.
  pose proof (numbers_of_initial _ _ _ _ _ _ _ _ _ _ _ _ _ good_scene) as A.
  replace (AnyStep.Numbers _ _ _ _ _ _ _ _ _) with (numbers_with D s d_0 y); [exact A|].
  unfold numbers_with.
  f_equal; symmetry; match goal with |- sharper_values ?x = _ => exact (number x _ eq_refl) end.
Qed.
Theorem printed_scene_collapses : collapse D r s (T_star r c V_0 delta_theta) c (Theta r c V_0 delta_theta).
Proof.
  destruct (SharperCollapse.sharper_collapse sharper_values sharper_good D s start_shown)
    as (scenes & time & T & Z & at_T & P & B & M).
  assert (E : sharper_values Sharper.number_of_r = r) by exact (number Sharper.number_of_r _ eq_refl).
  assert (F : sharper_values Sharper.number_of_C_0 = c) by exact (number Sharper.number_of_C_0 _ eq_refl).
  assert (G : sharper_values Sharper.number_of_Theta = Theta r c V_0 delta_theta)
    by exact (number Sharper.number_of_Theta _ eq_refl).
  rewrite E in P. rewrite F, G in M. exists scenes, time, T, Z, at_T. split; [exact P|].
  split; [|exact M]. apply Rle_trans with (1 := B). unfold SharperCollapse.latest, Sharper.duration.
  rewrite (number Sharper.number_of_p _ eq_refl), (number Sharper.number_of_Y _ eq_refl),
    (number Sharper.number_of_T _ eq_refl), (number Sharper.number_of_eta_0 _ eq_refl).
  assert (K : AsPrinted.T r c V_0 * eta_bar r c V_0 delta_theta / (1 - AsPrinted.ratio r c V_0) <=
    T_star r c V_0 delta_theta) by row AsPrinted.collapse_time.
  apply Rle_trans with (2 := K). apply Req_le.
  change (AsPrinted.T r c V_0 / (1 - ((AsPrinted.ratio r c V_0 + AsPrinted.least_ratio r c V_0) / 2 +
    (AsPrinted.ratio r c V_0 - AsPrinted.least_ratio r c V_0) / 2)) * eta_bar r c V_0 delta_theta =
    AsPrinted.T r c V_0 * eta_bar r c V_0 delta_theta / (1 - AsPrinted.ratio r c V_0)).
  replace ((AsPrinted.ratio r c V_0 + AsPrinted.least_ratio r c V_0) / 2 +
    (AsPrinted.ratio r c V_0 - AsPrinted.least_ratio r c V_0) / 2) with (AsPrinted.ratio r c V_0) by field.
  unfold Rdiv. ring.
Qed.
End PrintedScene.

(* --- the set -------------------------------------------------------------------------------------- *)

Section PrintedSet.
Variables r c V_0 delta_theta : R.
Hypothesis good : admissible r c V_0 delta_theta.
Notation Theta := (Theta r c V_0 delta_theta).
Ltac row of_it := refine (of_it citations r c V_0 delta_theta _ _ _ _ _ _ _); apply good.

Lemma numbers_fit : 0 < Theta <= delta_theta.
Proof.
  assert (A : c - c < Theta / 6) by row AsPrinted.inside_start_C_upper.
  assert (B : Theta <= delta_theta) by row AsPrinted.final_angle. lra.
Qed.
Theorem collapses_with_room d s : with_room r c V_0 delta_theta d s ->
  collapse d r s (T_star r c V_0 delta_theta) c Theta.
Proof.
  intros (s_0 & g & y & u & I & U & F & ->).
  apply flown_collapses; trivial; [exact (restitution _ _ _ _ good)|].
  now apply printed_scene_collapses with g y.
Qed.
Lemma printed_has_room d s : printed_set r c V_0 delta_theta d s -> with_room r c V_0 delta_theta d s.
Proof.
  intros (s_0 & g & y & u & [A1 A2 A3 A4 A5 A6 A7 A8 A9 A10] & U). exists s_0, g, y, u.
  split; [|exact U]. split; trivial. pose proof numbers_fit. lra.
Qed.
Theorem constants_leave_room : room (phi_minus r c) (x_0 r c V_0) (eta_bar r c V_0 delta_theta)
  (d_const r c delta_theta) (d_slope r c V_0) V_0 (V_1 r c V_0) (4 * (Theta / 6)) c.
Proof.
  assert (E : eta_bar r c V_0 delta_theta / 2 < eta_bar r c V_0 delta_theta)
    by row AsPrinted.inside_start_eta_bar.
  set (y := eta_bar r c V_0 delta_theta / 2) in *.
  assert (X : phi_minus r c * y - phi_minus r c * y < x_0 r c V_0 * y)
    by row AsPrinted.inside_start_x_upper.
  set (m := Rmin (d_slope r c V_0 * y ^ 2) (d_const r c delta_theta)).
  assert (C : m / 2 < d_const r c delta_theta) by row AsPrinted.inside_start_d_const.
  assert (S : m / 2 < d_slope r c V_0 * y ^ 2) by row AsPrinted.inside_start_d_slope.
  assert (M : m = d_slope r c V_0 * y ^ 2 \/ m = d_const r c delta_theta)
    by (unfold m, Rmin; destruct Rle_dec; [left | right]; reflexivity).
  pose proof (Rmin_l (d_slope r c V_0 * y ^ 2) (d_const r c delta_theta)) as M1.
  pose proof (Rmin_r (d_slope r c V_0 * y ^ 2) (d_const r c delta_theta)) as M2. fold m in M1, M2.
  assert (Y : 0 < y) by (unfold y in *; lra).
  assert (W : 0 < y ^ 2) by now apply pow_lt.
  split; [exact (angle_obtuse _ _ _ _ good) | exact (phi_positive _ _ _ _ good) | | unfold y in Y; lra
    | lra | | pose proof numbers_fit; lra | | |].
  - apply Rmult_lt_reg_r with y; lra.
  - apply Rmult_lt_reg_r with (y ^ 2); lra.
  - assert (V_0 + (V_1 r c V_0 - V_0) / 3 < (V_0 + V_1 r c V_0) / 2) by row AsPrinted.inside_start_A_above.
    lra.
  - row AsPrinted.room_c.
  - row AsPrinted.room_s.
Qed.
Theorem room_has_an_interior d : (2 <= d)%nat -> has_interior d (with_room r c V_0 delta_theta d).
Proof.
  intros L. apply room_is_interior; trivial; [exact constants_leave_room|].
  intros s g y I.
  destruct (printed_scene_collapses r c V_0 delta_theta good d s g y I)
    as (scenes & time & T & Z & at_T & P & _).
  destruct (in_turn _ _ _ _ _ _ _ _ P O) as [F _]. rewrite (first_scene _ _ _ _ _ _ _ _ P) in F.
  exact (ex_intro _ _ F).
Qed.
Theorem printed_set_is_not_empty d : (2 <= d)%nat -> exists s, printed_set r c V_0 delta_theta d s.
Proof.
  intros L. pose proof constants_leave_room as K.
  pose proof (numbers_of_point_are _ _ _ _ _ _ _ _ _ d L K) as [G T D P Q S1 S2 C].
  set (s := point _ _ _ _ _ _ _) in *. set (g := OneScene.d_0 _ _ _) in *.
  set (y := OneScene.y _) in *. destruct K as [? K1 K2 K3 K4 K5 K6 K7 _ _].
  assert (V : 0 < y < eta_bar r c V_0 delta_theta) by (unfold y, OneScene.y; lra).
  assert (0 < phi_minus r c * y) by (apply Rmult_lt_0_compat; lra).
  assert (0 < x_0 r c V_0 * y) by (apply Rmult_lt_0_compat; lra).
  exists s, s, g, y, 0. split; [|split; [lra|split; [intros; lra | now rewrite later_0]]].
  split; rewrite ?P, ?S1, ?S2, ?C; trivial; unfold OneScene.norm, eta_s; fold y; try lra.
  - rewrite Rminus_diag_eq, Rabs_R0; trivial. lra.
  - rewrite Rminus_diag_eq, Rabs_R0; trivial. lra.
Qed.
End PrintedSet.

(* --- as it is printed, it has no interior --------------------------------------------------------- *)

(* Balls that touch and part have not touched before. *)
Lemma one_contact d s t : distance d s B0 B1 = 1 -> 0 < rate d s B0 B1 ->
  distance d (later t s) B0 B1 = 1 -> 0 < rate d (later t s) B0 B1 -> t = 0.
Proof.
  intros A B C D. rewrite rate_later in D. pose proof (square_later d t s B0 B1) as E.
  rewrite !square_of_distance, A, C in E.
  set (h := rate d s B0 B1) in *. set (w := dot d (relative s B0 B1) (relative s B0 B1)) in *.
  assert (F : t * (2 * h + t * w) = 0) by lra. apply Rmult_integral in F. destruct F; lra.
Qed.
(* Ball 2 at another place. *)
Definition aside (e : R) (w : vector) (s : scene) : scene :=
  Scene (fun i k => match i with B2 => position s B2 k + e * w k | _ => position s i k end) (velocity s).
Lemma later_aside t e w s : later t (aside e w s) = aside e w (later t s).
Proof.
  unfold later, aside. cbn [position velocity]. f_equal. apply functional_extensionality. intros i.
  apply functional_extensionality. intros k. destruct i; ring.
Qed.
Theorem printed_set_has_no_interior r c V_0 delta_theta d : 0 < c -> (2 <= d)%nat ->
  ~ has_interior d (printed_set r c V_0 delta_theta d).
Proof.
  intros P L (s & e & E & A).
  destruct (A s) as (s_0 & g & y & u & [G1 _ G3 G4 _ _ [G7 _] _ _ G10] & U & _ & ->).
  { intros i k _. now rewrite !Rminus_diag_eq, Rabs_R0. }
  set (p := to s_0 B0 B1).
  assert (N : dot d p p = 1).
  { change (square d s_0 B0 B1 = 1). rewrite square_of_distance, G3. ring. }
  destruct (vector_exists d p 0 1 L) as (w & W0 & W1); [lra | lra |].
  set (q := to s_0 B0 B2).
  (* Ball 2 moves at a right angle to the direction of ball 1: then its distance does not change. *)
  assert (K : forall h, Rabs h < e -> 2 * h * dot d q w + h * h = 0).
  { intros h H. destruct (A (aside h w (later u s_0))) as (t & g' & y' & u' & I & _ & _ & F).
    - intros i k B. cbn [position velocity aside]. set (x := position (later u s_0)).
      split; [|rewrite Rminus_diag_eq by reflexivity; now rewrite Rabs_R0].
      destruct i; try (rewrite Rminus_diag_eq by reflexivity; now rewrite Rabs_R0).
      replace (x B2 k + h * w k - x B2 k) with (h * w k) by ring.
      pose proof (coordinate_at_most d w k B) as M. rewrite W1 in M.
      assert (O : Rabs (w k) <= 1) by (rewrite <- Rabs_R1; apply Rsqr_le_abs_0; unfold Rsqr; lra).
      rewrite Rabs_mult. pose proof (Rmult_le_compat_l _ _ _ (Rabs_pos h) O). lra.
    - rewrite <- later_aside in F.
      assert (T : t = later (u - u') (aside h w s_0)).
      { transitivity (later (- u') (later u' t)).
        - rewrite later_later, Rplus_opp_r. symmetry. apply later_0.
        - now rewrite <- F, later_later. }
      destruct I as [I1 _ I3 I4 _ _ [I7 _] _ _ I10].
      assert (Z : u - u' = 0) by (apply (one_contact d (aside h w s_0)); trivial; now rewrite <- T).
      rewrite Z, later_0 in T. subst t. set (a := aside h w s_0) in *.
      assert (Pa : to a B0 B1 = p) by reflexivity.
      assert (Qa : to a B0 B2 = combined 1 q h w).
      { apply same_vector. intros k. unfold combined, q, to. cbn [position aside a]. ring. }
      assert (X : forall x, distance d x B0 B1 = 1 -> 0 < distance d x B0 B2 ->
        Rabs (minus_cosine d x - c) <= 4 * 0 / 4 ->
        dot d (to x B0 B1) (to x B0 B2) = - (c * distance d x B0 B2)).
      { intros x X1 X2 X3. apply within in X3. unfold minus_cosine in X3. rewrite X1 in X3.
        apply Rmult_eq_reg_r with (/ (1 * distance d x B0 B2)); [|apply Rinv_neq_0_compat; lra].
        replace (- (c * distance d x B0 B2) * / (1 * distance d x B0 B2)) with (- c) by (field; lra).
        unfold Rdiv in X3. lra. }
      pose proof (X a I3 ltac:(lra) I10) as Xa. pose proof (X s_0 G3 ltac:(lra) G10) as Xs.
      rewrite Pa, Qa, dot_linear_right, W0 in Xa. fold p q in Xs.
      assert (Y : distance d a B0 B2 = distance d s_0 B0 B2) by (apply Rmult_eq_reg_l with c; lra).
      pose proof (square_of_distance d a B0 B2) as S. unfold square in S.
      rewrite Y, <- square_of_distance, Qa, square_of_combined, W1 in S. unfold square in S. fold q in S.
      lra. }
  pose proof (K (e / 2)) as K1. pose proof (K (- (e / 2))) as K2.
  rewrite Rabs_Ropp, Rabs_right in * by lra. specialize (K1 ltac:(lra)). specialize (K2 ltac:(lra)).
  assert (0 < e / 2 * (e / 2)) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Theorem printed_set_theorem_holds : printed_set_theorem.
Proof.
  intros r theta_0 V_0 delta_theta d L [A0 A1] H V P. cbv zeta. set (c := - cos theta_0) in *.
  assert (A : admissible r c V_0 delta_theta).
  { apply Parameters.hypothesis_is_the_printed. repeat split; trivial; try apply H.
    unfold c. pose proof (COS_bound theta_0). lra. }
  split; [now apply printed_set_is_not_empty|].
  split; [apply printed_set_has_no_interior; trivial; apply A|].
  split; [now apply printed_has_room|]. split; [now apply room_has_an_interior|].
  split; [now apply AllProved.interior_contains_a_box, room_has_an_interior|].
  split; [now apply collapses_with_room | now apply numbers_fit].
Qed.
