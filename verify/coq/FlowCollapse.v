(* From the flow to the sharper theorem: a scene whose numbers are those of a state of the flow, in
   which two balls touch, has the numbers of a state of the sharper theorem, when the balls are named
   by their roles; and the numbers of a state seen from another ball. *)
From Coq Require Import Reals List Lra.
From Verify Require Import Theorem1 Vectors Motion Sequences Meaning Terms Citations Readable.
From Verify Require Import FlowStep FlowScene AnyStep SharperStep SharperCollapse Runs Joined.
From Verify Require Flow Sharper.
Import ListNotations.
Open Scope R_scope.

(* --- the balls by their roles ------------------------------------------------------------------- *)

Lemma renamed_to o s c x i j : to (renamed o s c x) i j = to x (role o s c i) (role o s c j).
Proof. reflexivity. Qed.
Lemma renamed_relative o s c x i j :
  relative (renamed o s c x) i j = relative x (role o s c i) (role o s c j).
Proof. reflexivity. Qed.

(* What the flow's context unit asks for. *)
Record unit_numbers (v lam rho eps sig C b reach closing parting cosine turning distance : R) : Prop := {
  unit_1 : sig = 0; unit_2 : 0 < 1 + eps * v ^ 2; unit_3 : reach = sqrt (1 + eps * v ^ 2);
  unit_4 : 0 < reach; unit_5 : 0 < 1 + reach; unit_6 : closing = lam * v / reach;
  unit_7 : parting = rho * v; unit_8 : cosine = C / reach; unit_9 : turning = b / reach;
  unit_10 : distance = eps * v ^ 2 / (1 + reach)
}.
Definition unit_givens := Eval vm_compute in flow_givens Flow.context_unit.
Lemma unit_certified w : scope SF Flow.context_unit w -> unit_numbers
  (w Flow.number_of_unit_v) (w Flow.number_of_unit_lam) (w Flow.number_of_unit_rho)
  (w Flow.number_of_unit_eps) (w Flow.number_of_unit_sig) (w Flow.number_of_unit_C)
  (w Flow.number_of_unit_b) (w Flow.number_of_unit_reach) (w Flow.number_of_unit_closing)
  (w Flow.number_of_unit_parting) (w Flow.number_of_unit_cosine) (w Flow.number_of_unit_turning)
  (w Flow.number_of_unit_distance).
Proof.
  intros S. givens_of_flow w S Flow.context_unit unit_givens.
  split; assumption.
Qed.
Theorem unit_state n x o s c v lam rho eps sig A B C a b w reach closing parting cosine turning far :
  gram n x o s c v lam rho eps sig A B C a b w ->
  unit_numbers v lam rho eps sig C b reach closing parting cosine turning far ->
  has (Numbers closing parting cosine a turning A B w far) n (renamed o s c x) B1 B2.
Proof.
  intros [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10] [U1 U2 U3 U4 U5 U6 U7 U8 U9 U10].
  assert (Q : reach * reach = 1 + eps * v ^ 2) by (rewrite U3; apply sqrt_sqrt; lra).
  assert (E : 1 + far = reach).
  { rewrite U10. replace (eps * v ^ 2) with (reach * reach - 1) by lra. field. lra. }
  exists (scaled (/ reach) (to x o c)). rewrite !renamed_to, !renamed_relative. cbn [role]. split.
  - cbn [AnyStep.d]. rewrite E. apply same_vector. intros k. unfold scaled. field. lra.
  - split; cbn [AnyStep.y AnyStep.eta_s AnyStep.C AnyStep.a AnyStep.b AnyStep.A AnyStep.B AnyStep.w];
      rewrite ?dot_scaled, ?dot_scaled_right, ?G1, ?G2, ?G3, ?G4, ?G5, ?G6, ?G7, ?G8, ?G9, ?G10; trivial.
    + rewrite U1. ring.
    + rewrite <- Q. field. lra.
    + rewrite U8. field. lra.
    + now rewrite U7.
    + rewrite U6. field. lra.
    + rewrite U9. field. lra.
Qed.

(* --- seen from another ball --------------------------------------------------------------------- *)

Record recentred (v lam rho eps sig A B C a b w
    lam_next rho_next eps_next sig_next A_next C_next a_next b_next w_next : R) : Prop := {
  recentre_1 : lam_next = - ((rho - lam) * v - a - b); recentre_2 : rho_next = rho * v;
  recentre_3 : eps_next = 1 + (eps + sig) * v ^ 2 + 2 * C; recentre_4 : sig_next = sig * v ^ 2;
  recentre_5 : A_next = A + B - 2 * w; recentre_6 : C_next = - C - 1 - sig * v ^ 2;
  recentre_7 : a_next = rho * v - a; recentre_8 : b_next = rho * v - b; recentre_9 : w_next = B - w
}.
Definition recentre_givens := Eval vm_compute in flow_givens Flow.context_recentre.
Lemma recentre_certified w : scope SF Flow.context_recentre w -> recentred
  (w Flow.number_of_recentre_v) (w Flow.number_of_recentre_lam) (w Flow.number_of_recentre_rho)
  (w Flow.number_of_recentre_eps) (w Flow.number_of_recentre_sig) (w Flow.number_of_recentre_A)
  (w Flow.number_of_recentre_B) (w Flow.number_of_recentre_C) (w Flow.number_of_recentre_a)
  (w Flow.number_of_recentre_b) (w Flow.number_of_recentre_w) (w Flow.number_of_recentre_lam_next)
  (w Flow.number_of_recentre_rho_next) (w Flow.number_of_recentre_eps_next)
  (w Flow.number_of_recentre_sig_next) (w Flow.number_of_recentre_A_next)
  (w Flow.number_of_recentre_C_next) (w Flow.number_of_recentre_a_next)
  (w Flow.number_of_recentre_b_next) (w Flow.number_of_recentre_w_next).
Proof.
  intros S. givens_of_flow w S Flow.context_recentre recentre_givens.
  split; assumption.
Qed.
Theorem seen_from_s n x o s c v lam rho eps sig A B C a b w lam' rho' eps' sig' A' C' a' b' w' :
  gram n x o s c v lam rho eps sig A B C a b w ->
  recentred v lam rho eps sig A B C a b w lam' rho' eps' sig' A' C' a' b' w' ->
  gram n x s o c 1 lam' rho' eps' sig' A' B C' a' b' w'.
Proof.
  intros [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10] [-> -> -> -> -> -> -> -> ->].
  assert (E1 : to x s o = scaled (-1) (to x o s)) by apply to_opposite.
  assert (E2 : relative x s o = scaled (-1) (relative x o s)) by apply relative_opposite.
  pose proof G3 as R3. pose proof G4 as R4. pose proof G5 as R5. pose proof G6 as R6.
  pose proof G7 as R7. pose proof G10 as R10.
  rewrite dot_symmetric in R3, R4, R5, R6, R7, R10.
  split; rewrite ?E1, ?E2, ?(from_o x o s c), ?(moves_from_o x o s c);
    repeat (rewrite ?dot_linear, ?dot_linear_right, ?dot_scaled, ?dot_scaled_right);
    rewrite ?G1, ?G2, ?G3, ?G4, ?G5, ?G6, ?G7, ?G8, ?G9, ?G10, ?R3, ?R4, ?R5, ?R6, ?R7, ?R10; ring.
Qed.
(* Some time passes until the pair that is next then meets, since it is apart. *)
Lemma apart_seen n x o s c lam rho eps sig A B C a b w :
  gram n x o s c 1 lam rho eps sig A B C a b w -> 1 < square n x o c -> 0 < eps.
Proof. intros [_ G _ _ _ _ _ _ _ _] P. unfold square in P. lra. Qed.

(* --- the collapse ------------------------------------------------------------------------------- *)

(* What the row says that applies the sharper theorem. *)
Lemma sharper_of_row S1 at_ : begins SS S1 (size SS S1) = true -> says S1 0 (Applies start_context at_) ->
  scope SS start_context (after S1 (fun _ => 0) at_).
Proof.
  intros P A. apply (scope_same SS S1 (size SS S1) P); [vm_compute; repeat constructor|].
  apply A. intros k [<-|[]]. apply Forall_nil.
Qed.
(* Which name a ball has. *)
Definition name_of (o s c b : ball) : ball := if same b o then B0 else if same b s then B1 else B2.
Lemma name_of_role o s c : s <> o /\ c <> o /\ s <> c ->
  (forall b, name_of o s c (role o s c b) = b) /\ (forall b, role o s c (name_of o s c b) = b).
Proof. intros (N & M & K). split; intros b; destruct o, s, c, b; easy. Qed.
Theorem collapses_from d r s l z o i c by_time angle tolerance earliest latest least most :
  i <> o /\ c <> o /\ i <> c ->
  run d r s l z -> collapse d r (renamed o i c z) by_time angle tolerance ->
  earliest <= lasts l -> lasts l + by_time <= latest ->
  least <= angle - tolerance -> angle + tolerance <= most ->
  collapses_after d r s l o i c earliest latest least most.
Proof.
  intros N U (scenes & time & T & Z & at_T & P & X & Y) E L H M.
  destruct (name_of_role o i c N) as [R1 R2]. set (f := name_of o i c) in *. set (g := role o i c) in *.
  assert (W : 0 < T).
  { assert (G : Un_growing time).
    { intros n. destruct (in_turn _ _ _ _ _ _ _ _ P n) as [[K _ _ _ _] _]. lra. }
    pose proof (growing_ineq _ _ G (finite_time _ _ _ _ _ _ _ _ P) 1%nat) as K.
    destruct (in_turn _ _ _ _ _ _ _ _ P 0%nat) as [[V _ _ _ _] _].
    rewrite (first_time _ _ _ _ _ _ _ _ P) in V. lra. }
  assert (F : trajectory d r z T (fun t => named f (Z t))).
  { rewrite <- (named_twice g f z R2).
    exact (named_trajectory d r f g R1 R2 _ _ _ (goes_until_T _ _ _ _ _ _ _ _ P)). }
  assert (G : forall T' Z', trajectory d r z T' Z' -> T' <= T).
  { intros T' Z' K. apply (none_goes_beyond _ _ _ _ _ _ _ _ P T' (fun t => named g (Z' t))).
    exact (named_trajectory d r g f R2 R1 _ _ _ K). }
  exists z, scenes, time, T, Z, at_T, (joined d r s l (fun t => named f (Z t))).
  split; [exact U|]. split; [exact P|]. split; [exact (joined_trajectory d r _ _ _ _ F _ U)|].
  split; [|split; [exact (none_lasts_longer d r _ _ _ _ F W G _ U)|]].
  - intros t K. rewrite (joined_later d r _ _ _ _ _ U K). exact (named_twice f g (Z t) R1).
  - apply within in Y. split; lra.
Qed.
Lemma duration_at_most p Y T e most : 0 < 1 - (p + Y) -> T * e <= most * (1 - (p + Y)) ->
  Sharper.duration p Y T * e <= most.
Proof.
  intros P M. unfold Sharper.duration. apply Rmult_le_reg_r with (1 - (p + Y)); [exact P|].
  replace (T / (1 - (p + Y)) * e * (1 - (p + Y))) with (T * e) by (field; lra). exact M.
Qed.
