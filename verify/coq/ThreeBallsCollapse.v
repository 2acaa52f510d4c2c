(* What ThreeBalls.v says is proved: by the certificate each state leads to the next one, the times are
   bounded, and the places converge. *)
From Coq Require Import Reals List Arith Lra Lia Ranalysis.
From Verify Require Import Theorem1 Vectors Motion Sequences InTurn Ending Classification Contacts.
From Verify Require Import Settling Line LineProof Bounces Meaning Terms Readable Extension AnyStep.
From Verify Require Import ThreeBalls ThreeBallsStep.
From Verify Require Balls.
Import ListNotations.
Open Scope R_scope.

(* --- from a scene to the certificate ------------------------------------------------------------- *)

Section BallsCollapse.
Variable D : nat.
Variables mass radius r : ball -> R.
Variables o a c : ball.
Variables w Y k E : ball -> R.
Variables G U_most C_0 Theta z Q_0 U_0 : R.
Variable first : scene.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis round : forall b, 0 < radius b.
Hypothesis restitutes : forall b, 0 < r b <= 1.
Hypothesis distinct : distinct_balls o a c.
Hypothesis good : chosen mass radius r o a c w Y k E G U_most C_0 Theta U_0.
Hypothesis map_goes_on : goes_on mass radius r o a c w G U_most C_0 Theta Q_0 U_0.
Hypothesis good_scene : starts D mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 first.

Notation reach := (reach_of radius o).
Notation share := (share_of mass radius r o).
Notation next_ := (next_ball a c).
Notation last_ := (last_ball a c).
Let y := closing D radius o c first.
Let far := distance D first o c / reach c.
Let p := scaled (/ reach a) (to first o a).
Let q := scaled (/ (reach c * far)) (to first o c).
Let s_ := scaled (/ reach a) (relative first o a).
Let c_ := scaled (/ reach c) (relative first o c).
Lemma reach_positive b : 0 < reach b.
Proof. unfold reach_of. pose proof (round o). pose proof (round b). lra. Qed.
Lemma share_positive b b' : 0 < share b b'.
Proof.
  unfold share_of. pose proof (heavy o). pose proof (heavy b). pose proof (restitutes b).
  apply Rmult_lt_0_compat; [|apply Rdiv_lt_0_compat; apply reach_positive].
  apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
Qed.
Definition at_start : numbers := Numbers y (parting D radius o a first) (minus_cosine_at D first o a c)
  (dot D p c_) (dot D q s_) (dot D c_ c_) (dot D s_ s_) (dot D s_ c_) (far - 1).
Lemma far_positive : 0 < far.
Proof. destruct good_scene as (_ & P & _). unfold far. lra. Qed.
Lemma seen_at_start : seen D radius o at_start first a c.
Proof.
  pose proof (reach_positive a). pose proof (reach_positive c). pose proof far_positive.
  destruct good_scene as (T & _).
  assert (F : distance D first o c = reach c * far) by (unfold far; field; lra).
  assert (S1 : dot D (to first o a) (to first o a) = reach a ^ 2).
  { change (square D first o a = reach a ^ 2). rewrite square_of_distance, T. ring. }
  assert (S2 : dot D (to first o c) (to first o c) = (reach c * far) ^ 2).
  { change (square D first o c = (reach c * far) ^ 2). rewrite square_of_distance, F. ring. }
  assert (0 < reach c * far) by (apply Rmult_lt_0_compat; lra).
  exists p, q, s_, c_. unfold at_start. cbn [AnyStep.d].
  replace (1 + (far - 1)) with far by ring.
  repeat (split; [apply same_vector; intros n; unfold p, q, s_, c_, scaled; fold (reach a) (reach c);
    fold (reach_of radius o a) (reach_of radius o c); field; repeat split; lra|]).
  split; cbn [AnyStep.y AnyStep.eta_s AnyStep.C AnyStep.a AnyStep.b AnyStep.A AnyStep.B AnyStep.w]; try reflexivity;
    unfold p, q, s_, c_; rewrite !dot_scaled, ?dot_scaled_right.
  - rewrite S1. field. lra.
  - rewrite S2. field. lra.
  - unfold minus_cosine_at. rewrite T, F. field. lra.
  - unfold parting, rate. field. lra.
  - unfold y, closing, rate. rewrite F. field. lra.
Qed.

Let m := at_start.
Definition the_values : valuation := fun x =>
  if Pos.eqb x Balls.number_of_m then mass o else if Pos.eqb x Balls.number_of_m_0 then mass c
  else if Pos.eqb x Balls.number_of_m_1 then mass a else if Pos.eqb x Balls.number_of_r_0 then r c
  else if Pos.eqb x Balls.number_of_r_1 then r a else if Pos.eqb x Balls.number_of_sigma_0 then reach c
  else if Pos.eqb x Balls.number_of_sigma_1 then reach a
  else if Pos.eqb x Balls.number_of_sigma_12 then radius a + radius c
  else if Pos.eqb x Balls.number_of_beta_0 then share c a
  else if Pos.eqb x Balls.number_of_beta_1 then share a c
  else if Pos.eqb x Balls.number_of_G then G else if Pos.eqb x Balls.number_of_w_0 then w c
  else if Pos.eqb x Balls.number_of_w_1 then w a else if Pos.eqb x Balls.number_of_U_b then U_most
  else if Pos.eqb x Balls.number_of_C_0 then C_0 else if Pos.eqb x Balls.number_of_Theta then Theta
  else if Pos.eqb x Balls.number_of_Y_0 then Y c else if Pos.eqb x Balls.number_of_Y_1 then Y a
  else if Pos.eqb x Balls.number_of_k_0 then k c else if Pos.eqb x Balls.number_of_k_1 then k a
  else if Pos.eqb x Balls.number_of_E_0 then E c else if Pos.eqb x Balls.number_of_E_1 then E a
  else if Pos.eqb x Balls.number_of_z_b then z else if Pos.eqb x Balls.number_of_Q_0 then Q_0
  else if Pos.eqb x Balls.number_of_U_0 then U_0
  else if Pos.eqb x Balls.number_of_y_start then AnyStep.y m
  else if Pos.eqb x Balls.number_of_eta_s_start then AnyStep.eta_s m
  else if Pos.eqb x Balls.number_of_C_start then AnyStep.C m
  else if Pos.eqb x Balls.number_of_a_start then AnyStep.a m
  else if Pos.eqb x Balls.number_of_b_start then AnyStep.b m
  else if Pos.eqb x Balls.number_of_A_start then AnyStep.A m
  else if Pos.eqb x Balls.number_of_B_start then AnyStep.B m
  else if Pos.eqb x Balls.number_of_w_start then AnyStep.w m else AnyStep.d m.
Definition the_givens := Eval vm_compute in conditions_of SB Balls.the_table start_context.
Lemma the_givens_are : conditions_of SB Balls.the_table start_context = the_givens.
Proof. vm_compute. reflexivity. Qed.
(* The squares of the speeds are at least those of their parts along the lines of the centres. *)
Lemma slower b x : 0 < x -> x ^ 2 <= dot D (scaled (/ reach b) (relative first o b)) (scaled (/ reach b) (relative first o b)) ->
  forall bound, speed_of D radius o first b <= bound -> 0 < bound /\
  dot D (scaled (/ reach b) (relative first o b)) (scaled (/ reach b) (relative first o b)) <= bound ^ 2.
Proof.
  intros X S bound L. pose proof (reach_positive b) as P. unfold speed_of in L.
  rewrite dot_scaled, dot_scaled_right in *. set (v := dot D (relative first o b) (relative first o b)) in *.
  assert (V : 0 <= v) by apply dot_self. set (u := sqrt v / reach b) in *.
  assert (U2 : / reach b * (/ reach b * v) = u ^ 2).
  { unfold u. rewrite <- (sqrt_sqrt v V) at 1. field. lra. }
  rewrite U2 in *. assert (0 <= u) by (apply Rmult_le_pos; [apply sqrt_pos | now apply Rlt_le, Rinv_0_lt_compat]).
  assert (0 < u).
  { destruct (Rle_lt_or_eq_dec 0 u) as [|Z]; trivial. pose proof (pow_lt x 2 X). rewrite <- Z in S. lra. }
  split; [lra|]. apply pow_incr. lra.
Qed.
Lemma start_good : scope SB start_context the_values.
Proof.
  assert (A : Forall (shown SB Balls.all_values the_values) the_givens).
  { pose proof seen_at_start as (p' & q' & s' & c' & Z1 & Z2 & Z3 & Z4 & W).
    destruct good as (K1 & [K2 K3] & K4 & [K5 K6] & (B1_ & B2_ & B3 & B4 & B5 & B6) & (A1 & A2 & A3 & A4 & A5 & A6) & K7).
    destruct good_scene as (_ & S1 & S2 & S3 & [S4 S5] & S6 & S7 & S8 & S9 & T1 & T2 & T3 & T4 & T5 & T6).
    change (Rabs (minus_cosine_at D first o a c - C_0) + (w c + w a + z) * E c * y <= Theta) in T6.
    pose proof (reach_positive a) as Ra. pose proof (reach_positive c) as Rc.
    pose proof (heavy o) as Mo. pose proof (heavy a) as Ma. pose proof (heavy c) as Mc.
    pose proof (restitutes a) as [Ia Ja]. pose proof (restitutes c) as [Ic Jc].
    destruct W as [P Q PQ PS QC PC QS SS CC SC].
    pose proof (cauchy_schwarz D q' c') as V1. rewrite QC, Q, CC in V1.
    pose proof (cauchy_schwarz D p' s') as V2. rewrite PS, P, SS in V2.
    unfold at_start in V1, V2. cbn [AnyStep.y AnyStep.eta_s AnyStep.A AnyStep.B] in V1, V2.
    assert (W1 : y ^ 2 <= dot D c_ c_) by lra.
    assert (W2 : parting D radius o a first ^ 2 <= dot D s_ s_) by lra.
    destruct (slower c y S2 W1 _ T4) as [X1 X2]. destruct (slower a _ S3 W2 _ T5) as [X3 X4].
    assert (H1 : share c a * (mass o + mass c) * reach a = (1 + r c) * mass c * reach c).
    { unfold share_of. field. split; lra. }
    assert (H2 : share a c * (mass o + mass a) * reach c = (1 + r a) * mass a * reach a).
    { unfold share_of. field. split; lra. }
    pose proof (Rle_abs (minus_cosine_at D first o a c - C_0)) as N1.
    pose proof (Rle_abs (- (minus_cosine_at D first o a c - C_0))) as N2. rewrite Rabs_Ropp in N2.
    assert (N3 : minus_cosine_at D first o a c - C_0 + (w c + w a + z) * E c * y <= Theta) by lra.
    assert (N4 : C_0 - minus_cosine_at D first o a c + (w c + w a + z) * E c * y <= Theta) by lra.
    destruct (map_goes_on O) as [G1 G2]. assert (K4' : 0 < 1 - Y c * Y a) by lra. assert (K3' : 0 < 1 - U_most) by lra.
    unfold the_givens.
    apply Forall_cons; [exact Mo|]. apply Forall_cons; [exact Mc|]. apply Forall_cons; [exact Ma|].
    apply Forall_cons; [exact Ic|]. apply Forall_cons; [exact Ia|]. apply Forall_cons; [exact Jc|].
    apply Forall_cons; [exact Ja|]. apply Forall_cons; [exact Rc|]. apply Forall_cons; [exact Ra|].
    apply Forall_cons; [exact H1|]. apply Forall_cons; [exact H2|]. apply Forall_cons; [exact K1|].
    apply Forall_cons; [exact B1_|]. apply Forall_cons; [exact A1|]. apply Forall_cons; [exact K4'|].
    apply Forall_cons; [exact B2_|]. apply Forall_cons; [exact A2|]. apply Forall_cons; [exact B4|].
    apply Forall_cons; [exact A4|]. apply Forall_cons; [exact B3|]. apply Forall_cons; [exact A3|].
    apply Forall_cons; [exact K3'|]. apply Forall_cons; [exact B5|]. apply Forall_cons; [exact A5|].
    apply Forall_cons; [exact B6|]. apply Forall_cons; [exact A6|]. apply Forall_cons; [exact K5|].
    apply Forall_cons; [exact K6|]. apply Forall_cons; [exact K7|]. apply Forall_cons; [exact K2|].
    apply Forall_cons; [exact S2|]. apply Forall_cons; [exact S3|]. apply Forall_cons; [exact S5|].
    apply Forall_cons; [exact S4|]. apply Forall_cons; [exact S1|]. apply Forall_cons; [exact W1|].
    apply Forall_cons; [exact W2|]. apply Forall_cons; [exact S6|]. apply Forall_cons; [exact S7|].
    apply Forall_cons; [exact S8|]. apply Forall_cons; [exact S9|]. apply Forall_cons; [exact T1|].
    apply Forall_cons; [exact T2|]. apply Forall_cons; [exact T3|]. apply Forall_cons; [exact X1|].
    apply Forall_cons; [exact X3|]. apply Forall_cons; [exact X2|]. apply Forall_cons; [exact X4|].
    apply Forall_cons; [exact N3|]. apply Forall_cons; [exact N4|]. apply Forall_cons; [exact G1|].
    apply Forall_cons; [exact G2|]. apply Forall_nil. }
  rewrite <- the_givens_are in A. unfold conditions_of in A.
  apply (scope_shown SB Balls.the_order Balls.the_table Balls.the_table_is) in A; [exact A|].
  exact Balls.all_right.
Qed.

(* --- all collisions ------------------------------------------------------------------------------ *)

Definition at_step : nat -> valuation := state SB the_values start next.
Fixpoint scenes (n : nat) : scene := match n with
  | O => first
  | S n => bounced D mass (r (next_ n)) o (next_ n) (later (flight (at_step n)) (scenes n))
  end.
Definition time (n : nat) : R := at_step n Balls.number_of_clock.
Lemma next_state n : at_step (S n) = new (at_step n).
Proof. reflexivity. Qed.
Lemma started x t : put start x = Some t ->
  at_step O x = show SB Balls.all_values the_values (read Balls.the_table 400 t).
Proof. exact (substituted SB Balls.the_order _ Balls.the_table_is _ Balls.all_right _ _ _ _). Qed.
Lemma kept_value n x : put next x = None -> put start x = None -> at_step n x = the_values x.
Proof.
  intros N P. unfold at_step. induction n as [|n IH]; cbn [state]; unfold after; [now rewrite P|].
  now rewrite N.
Qed.
(* What has the index c or s changes it with each collision. *)
Lemma alternates (f : ball -> R) xc xs : (forall v, new v xc = v xs) -> (forall v, new v xs = v xc) ->
  at_step O xc = f c -> at_step O xs = f a -> forall n, at_step n xc = f (next_ n) /\ at_step n xs = f (last_ n).
Proof.
  intros F F' B B' n. induction n as [|n [I J]]; [now split|]. rewrite next_state, F, F', I, J.
  unfold next_ball, last_ball. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even n).
Qed.
Ltac alternate f xc xs := apply (alternates f xc xs); [intros v; exact (new_value v xc _ eq_refl)
  | intros v; exact (new_value v xs _ eq_refl) | exact (started xc _ eq_refl) | exact (started xs _ eq_refl)].
Lemma restitution_at n : at_step n Balls.number_of_r_c = r (next_ n) /\ at_step n Balls.number_of_r_s = r (last_ n).
Proof. alternate r Balls.number_of_r_c Balls.number_of_r_s. Qed.
Lemma reach_at n : at_step n Balls.number_of_sigma_c = reach (next_ n) /\ at_step n Balls.number_of_sigma_s = reach (last_ n).
Proof. alternate (reach_of radius o) Balls.number_of_sigma_c Balls.number_of_sigma_s. Qed.
Lemma speed_at n : at_step n Balls.number_of_w_c = w (next_ n) /\ at_step n Balls.number_of_w_s = w (last_ n).
Proof. alternate w Balls.number_of_w_c Balls.number_of_w_s. Qed.
Lemma other n : last_ n = if same (next_ n) c then a else c.
Proof.
  destruct distinct as (N1 & N2 & N3). unfold next_ball, last_ball. destruct (Nat.even n); [now rewrite same_true|].
  now rewrite same_false.
Qed.
Lemma share_at n : at_step n Balls.number_of_beta_c = share (next_ n) (last_ n).
Proof.
  destruct distinct as (N1 & N2 & N3). rewrite other. set (f b := share b (if same b c then a else c)).
  assert (A : at_step n Balls.number_of_beta_c = f (next_ n) /\ at_step n Balls.number_of_beta_s = f (last_ n)); [|apply A].
  apply alternates.
  - intros v. exact (new_value v Balls.number_of_beta_c _ eq_refl).
  - intros v. exact (new_value v Balls.number_of_beta_s _ eq_refl).
  - unfold f. rewrite same_true. exact (started Balls.number_of_beta_c _ eq_refl).
  - unfold f. rewrite same_false by congruence. exact (started Balls.number_of_beta_s _ eq_refl).
Qed.
Lemma orbit_at n : here (at_step n) = orbit mass radius r o a c w G C_0 Theta Q_0 U_0 n.
Proof.
  induction n as [|n IH].
  - rewrite (started Balls.number_of_Q _ eq_refl), (started Balls.number_of_U _ eq_refl). reflexivity.
  - change (orbit _ _ _ _ _ _ _ _ _ _ _ _ (S n)) with (mapped (alpha_of mass radius r o a c C_0 Theta n)
      (rho_of a c w G n) (ratio_of r a c G n) (orbit mass radius r o a c w G C_0 Theta Q_0 U_0 n)).
    rewrite <- IH. unfold alpha_of, rho_of, ratio_of. destruct (speed_at n) as [<- <-].
    rewrite <- share_at, <- (proj1 (restitution_at n)).
    rewrite <- (kept_value n Balls.number_of_C_0 eq_refl eq_refl : _ = C_0),
      <- (kept_value n Balls.number_of_Theta eq_refl eq_refl : _ = Theta),
      <- (kept_value n Balls.number_of_G eq_refl eq_refl : _ = G).
    exact (mapped_next (at_step n)).
Qed.
Definition shown_at (n : nat) : Prop := seen D radius o (numbers_of (at_step n)) (scenes n) (last_ n) (next_ n).
Lemma good_after n : (forall j, (j <= n)%nat -> shown_at j) -> scope SB state_context (at_step n).
Proof.
  intros V. destruct (Balls.always the_values start_good) as [_ A]. destruct (A n) as [B _]; [|exact B].
  intros j J. destruct (V j J) as (p' & q' & s' & c' & _ & _ & _ & _ & W).
  apply (vectors_standing _ _ _ _ _ _ W); fold (at_step j);
    destruct (map_goes_on j) as [M1 M2]; rewrite orbit_at; destruct (speed_at j) as [-> ->]; rewrite share_at,
    (kept_value j Balls.number_of_C_0), (kept_value j Balls.number_of_Theta), (kept_value j Balls.number_of_G) by reflexivity.
  - exact M1.
  - rewrite (kept_value j Balls.number_of_U_b) by reflexivity. exact M2.
Qed.
Lemma turned n : next_ (S n) = last_ n /\ last_ (S n) = next_ n.
Proof. unfold next_ball, last_ball. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even n). Qed.
Lemma three n : distinct_balls o (last_ n) (next_ n).
Proof.
  destruct distinct as (N1 & N2 & N3). unfold next_ball, last_ball, distinct_balls.
  destruct (Nat.even n); repeat split; congruence.
Qed.
Lemma certified_at n : scope SB state_context (at_step n) ->
  certified_if (numbers_of (at_step n)) (flight (at_step n)) (outer_of_balls radius o (last_ n) (next_ n) (numbers_of (at_step n))).
Proof.
  intros P. destruct (reach_at n) as [R1 R2]. apply balls_step; [exact P | exact R2 | exact R1|].
  rewrite kept_value by reflexivity. change (radius a + radius c = radius (last_ n) + radius (next_ n)).
  unfold next_ball, last_ball. destruct (Nat.even n); ring.
Qed.
Lemma always_shown n : forall j, (j <= n)%nat -> shown_at j.
Proof.
  induction n as [|n IH]; intros j J.
  - replace j with O by lia. unfold shown_at. replace (numbers_of (at_step O)) with at_start; [exact seen_at_start|].
    unfold numbers_of, at_start. f_equal; symmetry; match goal with |- at_step O ?x = _ => exact (started x _ eq_refl) end.
  - apply Nat.le_succ_r in J. destruct J as [J|J]; [now apply IH|]. subst j.
    pose proof (good_after n IH) as P. unfold shown_at. destruct (turned n) as [-> ->].
    rewrite next_state, new_numbers, (proj1 (restitution_at n)), share_at.
    exact (balls_after D mass radius (r (next_ n)) heavy round o _ _ (three n) _ _ (certified_at n P) _ (IH n (le_n n))).
Qed.
Lemma always_good n : scope SB state_context (at_step n).
Proof. exact (good_after n (always_shown n)). Qed.
Lemma time_next n : time (S n) = time n + flight (at_step n).
Proof. unfold time. rewrite next_state. exact (new_value _ Balls.number_of_clock _ eq_refl). Qed.
Lemma clock_starts : time O = 0.
Proof. exact (started Balls.number_of_clock _ eq_refl). Qed.
Lemma flight_positive n : 0 < flight (at_step n).
Proof. exact (takes_time _ _ _ (certified_at n (always_good n))). Qed.
Lemma in_turn : meet_in_turn D mass radius r o a c scenes time.
Proof.
  intros n. cbn zeta. replace (time (S n) - time n) with (flight (at_step n)) by (rewrite time_next; ring).
  pose proof (balls_meet D radius round o _ _ (three n) _ _ (certified_at n (always_good n)) _ (always_shown n n (le_n n))) as M.
  split; [exact M|]. destruct M as (_ & _ & C & P & _). destruct (three n) as (_ & N & _).
  pose proof (reach_positive (next_ n)). apply bounced_parts; [exact heavy | apply restitutes | congruence | rewrite C; assumption | exact P].
Qed.
Lemma time_bounded n : time n <= E c * y.
Proof.
  assert (K : time n <= at_step n Balls.number_of_E_0 * at_step n Balls.number_of_y_start)
    by row_of (at_step n) Balls.row_of_time_total_is (always_good n).
  now rewrite !kept_value in K by reflexivity.
Qed.
Lemma angle_stays n : Rabs (minus_cosine_at D (scenes n) o a c - C_0) <= Theta.
Proof.
  pose proof (always_good n) as P. pose proof (AnyStep.far _ _ _ (certified_at n P)) as F.
  pose proof (cosine_seen D radius round o _ _ _ _ (always_shown n n (le_n n)) F) as C.
  assert (V : minus_cosine_at D (scenes n) o a c = at_step n Balls.number_of_C).
  { refine (eq_trans _ C). unfold minus_cosine_at, next_ball, last_ball. destruct (Nat.even n); [reflexivity|].
    rewrite (dot_symmetric D (to (scenes n) o c)), (Rmult_comm (distance D (scenes n) o c)). reflexivity. }
  assert (U : at_step n Balls.number_of_C - at_step n Balls.number_of_C_0 <=
    at_step n Balls.number_of_Theta) by row_of (at_step n) Balls.row_of_angle_final_upper_is P.
  assert (L : at_step n Balls.number_of_C_0 - at_step n Balls.number_of_C <=
    at_step n Balls.number_of_Theta) by row_of (at_step n) Balls.row_of_angle_final_lower_is P.
  rewrite (kept_value n Balls.number_of_C_0), (kept_value n Balls.number_of_Theta) in U, L by reflexivity.
  change (the_values Balls.number_of_C_0) with C_0 in *. change (the_values Balls.number_of_Theta) with Theta in *.
  rewrite V. apply Rabs_le. lra.
Qed.
Lemma ends : exists T, Un_cv time T /\ T <= E c * y.
Proof.
  destruct (bounded_increasing_converges time (E c * y)) as [T L].
  - intros n. rewrite time_next. pose proof (flight_positive n). lra.
  - exact time_bounded.
  - exists T. split; [exact L|]. exact (limit_at_most _ _ _ L time_bounded).
Qed.
(* The places converge, and both balls touch o in the limit. *)
Lemma are_strikes : strikes D mass radius scenes time (fun _ => o) next_.
Proof.
  intros n. destruct (in_turn n) as ((T & _ & C & P & O) & W). cbn zeta in *.
  set (t := time (S n) - time n) in *. set (b := next_ n) in *. destruct (three n) as (N1 & N2 & N3).
  fold b in N2, N3. split; [congruence|]. split; [exact T|]. split; [exact C|]. split; [exact P|]. split.
  - apply (any_of_three _ o (last_ n) b).
    + repeat split; assumption.
    + intros i j B. rewrite distance_symmetric, Rplus_comm. exact B.
    + apply Rlt_le, O; congruence.
    + apply Req_le. symmetry. exact C.
    + rewrite distance_symmetric, Rplus_comm. apply Rlt_le, O; congruence.
  - destruct W as (J & J0 & X & V & R1). exists J. split; [exact J0|]. split; [exact X | split; [exact V|]].
    rewrite R1. destruct (restitutes b) as [R2 R3]. set (u := rate D (later t (scenes n)) o b) in *.
    assert (0 < r b * - u) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= (1 - r b) * - u) by (apply Rmult_le_pos; lra). lra.
Qed.
Section BallsLimit.
Variable T : R.
Hypothesis finite : Un_cv time T.
Variable at_T : scene.
Hypothesis settled : settles D scenes at_T.
Lemma products_converge b b' : Un_cv (fun n => dot D (to (scenes n) o b) (to (scenes n) o b'))
  (dot D (to at_T o b) (to at_T o b')).
Proof. apply dot_converges; intros i I; now apply settled. Qed.
Lemma touch_after n : square D (scenes (S n)) o (next_ n) = reach (next_ n) ^ 2.
Proof.
  destruct (in_turn n) as ((_ & _ & C & _) & _ & _ & X & _). unfold square. rewrite !(same_places _ _ _ _ X).
  change (square D (later (time (S n) - time n) (scenes n)) o (next_ n) = reach (next_ n) ^ 2).
  rewrite square_of_distance, C. unfold reach_of. ring.
Qed.
Lemma touch_at_the_end b : b = a \/ b = c -> distance D at_T o b = reach b.
Proof.
  intros B. apply as_far; [apply Rlt_le, reach_positive|].
  apply (often_equal _ _ _ (products_converge b b)). intros n. pose proof (touch_after (2 * n)) as P.
  pose proof (touch_after (S (2 * n))) as Q. unfold next_ball in P, Q.
  rewrite Nat.even_succ, <- Nat.negb_even in Q. rewrite Nat.even_mul in P, Q. cbn [Nat.even orb negb] in P, Q.
  destruct B as [-> | ->]; [exists (S (S (2 * n))) | exists (S (2 * n))]; (split; [lia | assumption]).
Qed.
Lemma distance_converges b : b = a \/ b = c -> Un_cv (fun n => distance D (scenes n) o b) (reach b).
Proof.
  intros B. rewrite <- (touch_at_the_end b B) at 1. unfold distance.
  apply (continuity_seq sqrt (fun n => dot D (to (scenes n) o b) (to (scenes n) o b))).
  - apply continuity_pt_sqrt. apply dot_self.
  - apply products_converge.
Qed.
Lemma angle_converges : Un_cv (fun n => minus_cosine_at D (scenes n) o a c) (minus_cosine_at D at_T o a c).
Proof.
  unfold minus_cosine_at. apply CV_opp. rewrite (touch_at_the_end a), (touch_at_the_end c) by tauto.
  pose proof (reach_positive a). pose proof (reach_positive c).
  assert (0 < reach a * reach c) by (apply Rmult_lt_0_compat; assumption).
  apply (CV_mult (fun n => dot D (to (scenes n) o a) (to (scenes n) o c))
    (fun n => / (distance D (scenes n) o a * distance D (scenes n) o c))).
  - apply products_converge.
  - apply (continuity_seq Rinv (fun n => distance D (scenes n) o a * distance D (scenes n) o c)).
    + apply continuity_pt_inv; [apply derivable_continuous_pt, derivable_pt_id | lra].
    + apply (CV_mult (fun n => distance D (scenes n) o a) (fun n => distance D (scenes n) o c));
        apply distance_converges; tauto.
Qed.
End BallsLimit.
End BallsCollapse.

Theorem three_balls_theorem_holds : three_balls_theorem.
Proof.
  intros d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s M P R D C O S.
  pose proof (in_turn d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s M P R D C O S) as I.
  destruct (ends d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s M P R D C O S) as (T & L & B).
  pose proof (are_strikes d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s M P R D C O S) as W.
  destruct (settles_in_time d mass radius _ _ _ _ T M W L) as (x & Z).
  pose proof (touch_at_the_end d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s M P R D C O S x Z) as F.
  pose proof (angle_converges d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s M P R D C O S x Z) as V.
  do 2 eexists. exists T, x. split; [|split; [|split; [exact I|]]]; [reflexivity | apply clock_starts; assumption|].
  split; [exact L|]. split; [exact B|]. split; [exact Z|]. split; [apply F; tauto|]. split; [apply F; tauto|].
  split; [exact V|].
  exact (limit_within _ _ _ _ V (angle_stays d mass radius r o a c w Y k E G U_most C_0 Theta z Q_0 U_0 s M P R D C O S)).
Qed.

Theorem three_equal_balls_holds : three_equal_balls.
Proof.
  intros d r w Y k E G U_most C_0 Theta z Q_0 U_0 s R mass radius same_r C O S.
  assert (R' : forall b, 0 < same_r b <= 1) by (intros; unfold same_r; lra).
  assert (D : distinct_balls B0 B1 B2) by (repeat split; discriminate).
  destruct (three_balls_theorem_holds d mass radius same_r B0 B1 B2 w Y k E G U_most C_0 Theta z Q_0 U_0 s one_positive half_positive R' D C O S)
    as (x & t & T & at_T & Z0 & T0 & I & L & B & _ & _ & _ & V & W).
  pose proof (in_turn_collapses d r R x t T T0 (equal_in_turn d r x t I) L) as N. rewrite Z0 in N.
  do 5 eexists. split; [exact N|]. split; [exact B|].
  rewrite (UL_sequence _ _ _ (Theorem1.angle_converges _ _ _ _ _ _ _ _ N) V). exact W.
Qed.
