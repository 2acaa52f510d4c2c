(* What Outside.v says is proved: by the certificate of outside the map goes on wherever two more balls
   strike, and what is above a floor ends when the floor ends. *)
From Coq Require Import Reals List Arith Lra Lia FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Readable Extension.
From Verify Require Import AnyStep ThreeBalls Outside OutsideStep.
From Verify Require Gram Ends Determined.
Import ListNotations.
Open Scope R_scope.

(* --- the states of the certificate ---------------------------------------------------------------- *)

Notation SO := Ends.the_statement.
Notation shown_here := (shown SO Ends.all_values).
Definition the_induction := Eval vm_compute in induction_of SO.
Definition start_context := Eval vm_compute in fst (fst (fst the_induction)).
Definition state_context := Eval vm_compute in snd (fst (fst the_induction)).
Definition start := Eval vm_compute in snd (fst the_induction).
Definition next := Eval vm_compute in snd the_induction.
Definition numbers_of (v : valuation) : numbers := Numbers (v Ends.number_of_y)
  (v Ends.number_of_eta_s) (v Ends.number_of_C) (v Ends.number_of_a) (v Ends.number_of_b)
  (v Ends.number_of_A) (v Ends.number_of_B) (v Ends.number_of_w) (v Ends.number_of_d).
Definition the_standing := Eval vm_compute in
  map (fun a => read_claim Ends.the_table (given_claim a)) (standing SO state_context).
Lemma the_standing_is :
  map (fun a => read_claim Ends.the_table (given_claim a)) (standing SO state_context) = the_standing.
Proof. vm_compute. reflexivity. Qed.
(* The time to the collision, and what is left of its speed, are kept as numbers of the state. *)
Definition timely (v : valuation) : Prop :=
  v Ends.number_of_time_here = time_of (numbers_of v) /\ v Ends.number_of_root_here = root_of (numbers_of v).
Lemma impact_at n p q s c T e y A B C a b w : dot n p p = 1 -> dot n q q = 1 -> dot n p q = - C ->
  dot n q c = - y -> dot n p c = a -> dot n q s = b -> dot n s s = B -> dot n c c = A -> dot n s c = w ->
  (e * b + T * w) ^ 2 <= B * (e * e + e * T * - y + T * e * - y + T * T * A).
Proof.
  intros P Q PQ QC PC QS SS CC SC. pose proof (proj1 (Gram.impact_square n p q s c T e P Q)) as K.
  now rewrite QS, SC, SS, QC, CC in K.
Qed.
Lemma vectors_standing v n p q s c : products (numbers_of v) n p q s c -> timely v ->
  let m := numbers_of v in let k := (1 + d m) * y m * root_of m in let T := time_of m in
  let r := v Ends.number_of_r in
  let law := (1 + r) / 2 * k * ((1 + d m) * C m - T * a m - (1 + d m) * T * b m - T ^ 2 * w m) -
    (eta_s m + T * B m) in
  0 < law ->
  (2 * eta_s m * T + B m * T ^ 2) *
    (B m + 2 * ((1 + r) / 2) * k * ((1 + d m) * b m + T * w m) + ((1 + r) / 2) ^ 2 * k ^ 2) < law ^ 2 ->
  satisfies SO v (standing SO state_context).
Proof.
  intros [P Q PQ PS QC PC QS SS CC SC] [E1 E2]. cbn zeta. rewrite <- E1, <- E2. intros K1 K2.
  cbn [y eta_s C a b A B w d numbers_of] in *.
  assert (X : Forall (shown_here v) the_standing).
  { pose proof (cauchy_schwarz n p s) as C2. pose proof (cauchy_schwarz n q c) as C3.
    pose proof (cauchy_schwarz n p c) as C4.
    pose proof (fun t e => Gram.impact_square n p q s c t e P Q) as C8.
    rewrite PS, P, SS in C2. rewrite QC, Q, CC in C3. rewrite PC, P, CC in C4.
    rewrite PQ, PS, QC, PC, QS, SS, CC, SC in C8. unfold the_standing.
    repeat (apply Forall_cons; [first [exact C2 | exact C3 | exact C4 | exact K1 | exact K2
      | exact (proj1 (C8 _ (1 + v Ends.number_of_d))) | exact (proj2 (C8 _ (1 + v Ends.number_of_d)))]|]).
    apply Forall_nil. }
  apply (givens_shown SO Ends.the_order _ Ends.the_table_is _ Ends.all_right). now rewrite the_standing_is.
Qed.
Ltac row_of w is_row inside :=
  refine (row_in_scope SO Ends.the_order Ends.the_table Ends.the_table_is
    Ends.the_rows_hold Ends.all_values _ _ _ w Ends.all_right is_row _); exact inside.
Section OutsideState.
Variable v : valuation.
Definition flight : R := Ends.tau (v Ends.number_of_y) (v Ends.number_of_A) (v Ends.number_of_d).
Definition new : valuation := after SO v next.
Lemma new_value x t : put next x = Some t ->
  new x = show SO Ends.all_values v (read Ends.the_table 400 t).
Proof. exact (substituted SO Ends.the_order _ Ends.the_table_is _ Ends.all_right _ _ _ _). Qed.
Ltac in_new x := rewrite (new_value x _ eq_refl).
Lemma new_numbers : numbers_of new = after_step (v Ends.number_of_r) (numbers_of v) flight.
Proof.
  unfold numbers_of. in_new Ends.number_of_y. in_new Ends.number_of_eta_s.
  in_new Ends.number_of_C. in_new Ends.number_of_a. in_new Ends.number_of_b.
  in_new Ends.number_of_A. in_new Ends.number_of_B. in_new Ends.number_of_w.
  in_new Ends.number_of_d. unfold after_step, after_sharing. cbn [y eta_s C a b A B w d].
  f_equal; try reflexivity.
  transitivity (Ends.A_next (v Ends.number_of_r) (v Ends.number_of_y) (v Ends.number_of_b) (v Ends.number_of_A)
    (v Ends.number_of_B) (v Ends.number_of_w) (v Ends.number_of_d)).
  - reflexivity.
  - unfold Ends.A_next, impact. cbn [y A d]. unfold Ends.kappa. fold flight. ring.
Qed.
Lemma new_timely : timely new.
Proof.
  split; unfold time_of, root_of, numbers_of; cbn [y A d]; in_new Ends.number_of_y; in_new Ends.number_of_A;
    in_new Ends.number_of_d; [in_new Ends.number_of_time_here | in_new Ends.number_of_root_here]; reflexivity.
Qed.
End OutsideState.

(* --- a run of strikes in turn ---------------------------------------------------------------------- *)

Section OutsideRun.
Variable D : nat.
Variables r G slow C_most Q_0 U_0 : R.
Variables v w : ball -> R.
Hypothesis good : bounds r G slow C_most Q_0 U_0 v.
Variable first : scene.
Hypothesis good_scene : starting r G slow C_most Q_0 U_0 v w D first.
Variable N : nat.
Variable scenes : nat -> scene.
Variable flights : nat -> R.
Hypothesis first_is : scenes O = first.
Hypothesis strikes : forall n, (n < S (S N))%nat -> 0 < flights n /\
  strike D (later (flights n) (scenes n)) B0 (collides_with n) /\
  scenes (S n) = collided D r B0 (collides_with n) (later (flights n) (scenes n)).
Let y0 := closing_of D first B0 B2.
Let far := distance D first B0 B2.
Let q := scaled (/ far) (to first B0 B2).
Definition at_start : numbers := Numbers y0 (rate D first B0 B1) (minus_cosine D first)
  (dot D (to first B0 B1) (relative first B0 B2)) (dot D q (relative first B0 B1))
  (dot D (relative first B0 B2) (relative first B0 B2)) (dot D (relative first B0 B1) (relative first B0 B1))
  (dot D (relative first B0 B1) (relative first B0 B2)) (far - 1).
Lemma has_at_start : has at_start D first B1 B2.
Proof.
  destruct good_scene as (T & P & _). fold far in P. assert (F : 0 < far) by lra. exists q. split.
  - apply same_vector. intros k. unfold q, at_start, scaled. cbn [AnyStep.d]. field. lra.
  - assert (S1 : dot D (to first B0 B1) (to first B0 B1) = 1) by exact (Contacts.unit_square _ _ _ _ T).
    assert (S2 : dot D (to first B0 B2) (to first B0 B2) = far * far).
    { change (square D first B0 B2 = far * far). rewrite square_of_distance. unfold far. ring. }
    split; unfold at_start; cbn [AnyStep.y AnyStep.eta_s AnyStep.C AnyStep.a AnyStep.b AnyStep.A AnyStep.B AnyStep.w];
      try reflexivity; try exact S1; unfold q; rewrite ?dot_scaled, ?dot_scaled_right.
    + rewrite S2. field. lra.
    + unfold minus_cosine. rewrite T. fold far. field. lra.
    + unfold y0, closing_of, rate. fold far. field. lra.
Qed.
Let m := at_start.
Definition the_values : valuation := fun x =>
  if Pos.eqb x Ends.number_of_r then r else if Pos.eqb x Ends.number_of_G then G
  else if Pos.eqb x Ends.number_of_v_ then slow else if Pos.eqb x Ends.number_of_v_0 then v B2
  else if Pos.eqb x Ends.number_of_v_1 then v B1 else if Pos.eqb x Ends.number_of_w_0 then w B2
  else if Pos.eqb x Ends.number_of_w_1 then w B1 else if Pos.eqb x Ends.number_of_C_p then C_most
  else if Pos.eqb x Ends.number_of_Q_0 then Q_0 else if Pos.eqb x Ends.number_of_U_0 then U_0
  else if Pos.eqb x Ends.number_of_y_start then AnyStep.y m
  else if Pos.eqb x Ends.number_of_eta_s_start then AnyStep.eta_s m
  else if Pos.eqb x Ends.number_of_C_start then AnyStep.C m
  else if Pos.eqb x Ends.number_of_a_start then AnyStep.a m
  else if Pos.eqb x Ends.number_of_b_start then AnyStep.b m
  else if Pos.eqb x Ends.number_of_A_start then AnyStep.A m
  else if Pos.eqb x Ends.number_of_B_start then AnyStep.B m
  else if Pos.eqb x Ends.number_of_w_start then AnyStep.w m else AnyStep.d m.
Definition at_step : nat -> valuation := state SO the_values start next.
Lemma next_state n : at_step (S n) = new (at_step n).
Proof. reflexivity. Qed.
Lemma started x t : put start x = Some t ->
  at_step O x = show SO Ends.all_values the_values (read Ends.the_table 400 t).
Proof. exact (substituted SO Ends.the_order _ Ends.the_table_is _ Ends.all_right _ _ _ _). Qed.
Lemma kept_value n x : put next x = None -> put start x = None -> at_step n x = the_values x.
Proof.
  intros P Q. unfold at_step. induction n as [|n IH]; cbn [state]; unfold after; [now rewrite Q|].
  now rewrite P.
Qed.
Lemma numbers_start : numbers_of (at_step O) = at_start.
Proof.
  unfold numbers_of, at_start. f_equal; match goal with |- at_step O ?x = _ => exact (started x _ eq_refl) end.
Qed.
Lemma turns n : collides_with (S (S n)) = collides_with n.
Proof. reflexivity. Qed.
Lemma three n : collides_with (S n) <> B0 /\ collides_with n <> B0 /\ collides_with (S n) <> collides_with n.
Proof.
  unfold collides_with. rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even n); repeat split; discriminate.
Qed.
(* What is known of a state before the certificate is asked. *)
Definition known (n : nat) : Prop :=
  (has (numbers_of (at_step n)) D (scenes n) (collides_with (S n)) (collides_with n) /\
   0 < d (numbers_of (at_step n)) /\ 0 < eta_s (numbers_of (at_step n))) /\ timely (at_step n).
Lemma restitution_positive : 0 < r.
Proof. apply good. Qed.
Lemma known_start : known O.
Proof.
  split.
  - rewrite numbers_start. rewrite first_is. split; [exact has_at_start|].
    destruct good_scene as (_ & P & _ & Q & _). now split.
  - split; unfold time_of, root_of; rewrite numbers_start;
      [exact (started Ends.number_of_time_here _ eq_refl) | exact (started Ends.number_of_root_here _ eq_refl)].
Qed.
Lemma flight_is n : (n < S (S N))%nat -> known n -> flights n = flight (at_step n).
Proof.
  intros L ((H & P & _) & _). destruct (strikes n L) as (F & S & _).
  destruct (strike_numbers D _ _ _ _ _ H P F S) as (_ & _ & E & _). exact E.
Qed.
Lemma two_of n : (n <= N)%nat -> known n -> known (S n) /\ satisfies SO (at_step n) (standing SO state_context).
Proof.
  intros L K. pose proof K as ((H & P & Q) & T). destruct (strikes n ltac:(lia)) as (F & S & E).
  destruct (strikes (Datatypes.S n) ltac:(lia)) as (F' & S' & _). rewrite E in S'.
  destruct (two_strikes r restitution_positive D _ _ _ _ _ _ (three n) H P Q F S F' S') as (A1 & A2 & A3).
  split.
  - split; [|apply new_timely]. rewrite next_state, new_numbers, E, turns, <- flight_is by (assumption || lia).
    rewrite (kept_value n Ends.number_of_r eq_refl eq_refl : _ = r). exact A1.
  - destruct H as (p & _ & H). apply (vectors_standing _ _ _ _ _ _ H T);
      rewrite (kept_value n Ends.number_of_r eq_refl eq_refl : _ = r); assumption.
Qed.
Lemma always_known n : (n <= N)%nat -> known n.
Proof.
  induction n as [|n IH]; intros L; [exact known_start|]. apply two_of; [lia|]. apply IH. lia.
Qed.

Definition the_givens := Eval vm_compute in conditions_of SO Ends.the_table start_context.
Lemma the_givens_are : conditions_of SO Ends.the_table start_context = the_givens.
Proof. vm_compute. reflexivity. Qed.
Lemma square_between low speed high : 0 < low -> low <= sqrt speed <= high -> 0 <= speed ->
  0 < high /\ low ^ 2 <= speed /\ speed <= high ^ 2.
Proof.
  intros P [L H] S. pose proof (pow2_sqrt speed S) as E. pose proof (pow_incr low (sqrt speed) 2 ltac:(lra)).
  pose proof (pow_incr (sqrt speed) high 2 ltac:(lra)). lra.
Qed.
Lemma start_good : scope SO start_context the_values.
Proof.
  assert (A : Forall (shown SO Ends.all_values the_values) the_givens).
  { destruct (strikes O ltac:(lia)) as (F & S & E). destruct (strikes 1%nat ltac:(lia)) as (F' & S' & _).
    rewrite E in S'. rewrite first_is in S, S'. pose proof known_start as ((H & P & Q) & _).
    rewrite numbers_start, first_is in *.
    destruct (strike_numbers D _ _ _ _ _ H P F S) as (Y & Z & _).
    destruct (two_strikes r restitution_positive D _ _ _ _ _ _ (three O) H P Q F S F' S') as (_ & L1 & L2).
    destruct H as (q' & _ & [X1 X2 X3 X4 X5 X6 X7 X8 X9 X0]).
    pose proof (cauchy_schwarz D (to first B0 B1) (relative first B0 B1)) as C2.
    pose proof (cauchy_schwarz D q' (relative first B0 B2)) as C3.
    pose proof (cauchy_schwarz D (to first B0 B1) (relative first B0 B2)) as C4.
    pose proof (fun t e => Gram.impact_square D _ q' (relative first B0 B1) (relative first B0 B2) t e X1 X2) as C8.
    change (collides_with 1) with B1 in *. change (collides_with 0) with B2 in *.
    rewrite X4, X1, X8 in C2. rewrite X5, X2, X9 in C3. rewrite X6, X1, X9 in C4.
    rewrite X3, X4, X5, X6, X7, X8, X9, X0 in C8.
    destruct good as (G1 & G2 & G3 & G4 & G5 & G6 & G7 & G8 & G9 & G0).
    destruct good_scene as (_ & H1 & H2 & H3 & H4 & H5 & H6 & H7 & H8 & H9 & H0).
    fold y0 in H2, H4, H5, H6, H7, H8, H9, H0.
    assert (K1 : 0 < 1 - (1 + r) / 2 * G) by lra. assert (K2 : 0 < 1 - U_0) by lra.
    assert (K3 : 0 < 1 + d m) by (change (0 < d m) in P; lra).
    assert (Gain : 0 < G / (1 - (1 + r) / 2 * G) * y0).
    { apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra. }
    assert (V2 : 0 < v B2 + G / (1 - (1 + r) / 2 * G) * y0) by lra.
    assert (V1 : 0 < v B1 + G / (1 - (1 + r) / 2 * G) * y0) by lra.
    destruct (square_between _ _ _ V2 H7 (dot_self D _)) as (I1 & I2 & I3).
    destruct (square_between _ _ _ V1 H8 (dot_self D _)) as (J1 & J2 & J3).
    assert (K4 : 0 < 1 + root_of m).
    { pose proof (sqrt_pos (1 - d m * (2 + d m) / (1 + d m) / (1 + d m) * (A m / y m / y m))). unfold root_of. lra. }
    unfold the_givens.
    apply Forall_cons; [exact G1|]. apply Forall_cons; [exact G2|]. apply Forall_cons; [exact K1|].
    apply Forall_cons; [exact G4|]. apply Forall_cons; [exact G5|]. apply Forall_cons; [exact G6|].
    apply Forall_cons; [exact G7|]. apply Forall_cons; [exact G8|]. apply Forall_cons; [exact (proj1 G0) || exact G9|].
    apply Forall_cons; [exact K2|]. apply Forall_cons; [exact H2|]. apply Forall_cons; [exact H3|].
    apply Forall_cons; [exact H4|]. apply Forall_cons; [exact H1|]. apply Forall_cons; [exact K3|].
    apply Forall_cons; [exact H5|]. apply Forall_cons; [exact H6|]. apply Forall_cons; [exact I1|].
    apply Forall_cons; [exact J1|]. apply Forall_cons; [exact I3|]. apply Forall_cons; [exact J3|].
    apply Forall_cons; [exact I2|]. apply Forall_cons; [exact J2|]. apply Forall_cons; [exact H0|].
    apply Forall_cons; [exact H9|]. apply Forall_cons; [exact Z|]. apply Forall_cons; [exact K4|].
    apply Forall_cons; [exact C2|]. apply Forall_cons; [exact C3|]. apply Forall_cons; [exact C4|].
    apply Forall_cons; [exact (proj1 (C8 _ (1 + d m)))|]. apply Forall_cons; [exact (proj2 (C8 _ (1 + d m)))|].
    apply Forall_cons; [exact L1|]. apply Forall_cons; [exact L2|]. apply Forall_nil. }
  rewrite <- the_givens_are in A. unfold conditions_of in A.
  apply (scope_shown SO Ends.the_order Ends.the_table Ends.the_table_is) in A; [exact A|].
  exact Ends.all_right.
Qed.
Lemma good_at n : (n <= N)%nat -> scope SO state_context (at_step n).
Proof.
  intros L. destruct (Ends.always the_values start_good) as [_ A]. destruct (A n) as [B _]; [|exact B].
  intros j J. apply two_of; [lia|]. apply always_known. lia.
Qed.

(* The numbers Q and U of the state are those of the map. *)
Lemma alternates (f : ball -> R) xc xs : (forall u, new u xc = u xs) -> (forall u, new u xs = u xc) ->
  at_step O xc = f B2 -> at_step O xs = f B1 ->
  forall n, at_step n xc = f (collides_with n) /\ at_step n xs = f (collides_with (S n)).
Proof.
  intros F F' B B' n. induction n as [|n [I J]]; [now split|]. rewrite next_state, F, F', I, J. now split.
Qed.
Ltac alternate f xc xs := apply (alternates f xc xs); [intros u; exact (new_value u xc _ eq_refl)
  | intros u; exact (new_value u xs _ eq_refl) | exact (started xc _ eq_refl) | exact (started xs _ eq_refl)].
Lemma slow_at n : at_step n Ends.number_of_v_c = v (collides_with n) /\
  at_step n Ends.number_of_v_s = v (collides_with (S n)).
Proof. alternate v Ends.number_of_v_c Ends.number_of_v_s. Qed.
Lemma fast_at n : at_step n Ends.number_of_w_c = w (collides_with n) /\
  at_step n Ends.number_of_w_s = w (collides_with (S n)).
Proof. alternate w Ends.number_of_w_c Ends.number_of_w_s. Qed.
Lemma point_at n : (at_step n Ends.number_of_Q, at_step n Ends.number_of_U) = below r G C_most Q_0 U_0 v w n.
Proof.
  induction n as [|n IH].
  - rewrite (started Ends.number_of_Q _ eq_refl), (started Ends.number_of_U _ eq_refl). reflexivity.
  - cbn [below]. rewrite <- IH. unfold below_rho. destruct (slow_at n) as [_ <-], (fast_at n) as [<- _].
    rewrite next_state, (new_value (at_step n) Ends.number_of_Q _ eq_refl),
      (new_value (at_step n) Ends.number_of_U _ eq_refl).
    unfold below_alpha. rewrite <- (kept_value n Ends.number_of_r eq_refl eq_refl : _ = r),
      <- (kept_value n Ends.number_of_G eq_refl eq_refl : _ = G),
      <- (kept_value n Ends.number_of_C_p eq_refl eq_refl : _ = C_most). reflexivity.
Qed.
Theorem map_goes_on : ~ stops r G C_most Q_0 U_0 v w N.
Proof.
  pose proof (good_at N (le_n N)) as P. unfold stops, no_step. rewrite <- point_at. unfold below_rho, below_alpha.
  destruct (slow_at N) as [_ <-], (fast_at N) as [<- _].
  rewrite <- (kept_value N Ends.number_of_r eq_refl eq_refl : _ = r),
    <- (kept_value N Ends.number_of_G eq_refl eq_refl : _ = G),
    <- (kept_value N Ends.number_of_C_p eq_refl eq_refl : _ = C_most).
  set (u := at_step N) in *. unfold pace, load. cbn [fst snd].
  assert (A : 0 < (1 + u Ends.number_of_r) / 2 * u Ends.number_of_G * u Ends.number_of_C_p * (1 - u Ends.number_of_U)
    - u Ends.number_of_Q - (u Ends.number_of_v_s / u Ends.number_of_w_c) ^ 2 * u Ends.number_of_U)
    by row_of u Ends.row_of_approaches_is P.
  assert (M : (u Ends.number_of_v_s / u Ends.number_of_w_c) ^ 2 * u Ends.number_of_U *
    (2 * u Ends.number_of_Q + (u Ends.number_of_v_s / u Ends.number_of_w_c) ^ 2 * u Ends.number_of_U) <
    ((1 + u Ends.number_of_r) / 2 * u Ends.number_of_G * u Ends.number_of_C_p * (1 - u Ends.number_of_U)
    - u Ends.number_of_Q - (u Ends.number_of_v_s / u Ends.number_of_w_c) ^ 2 * u Ends.number_of_U) ^ 2)
    by row_of u Ends.row_of_meets_is P.
  intros [K|K]; lra.
Qed.
End OutsideRun.

(* --- trajectories ---------------------------------------------------------------------------------- *)

(* Where two balls strike in a trajectory, they collide. *)
Lemma after_strike d r s T Z a b i j : trajectory d r s T Z -> 0 <= a -> a < b < T -> i <> j ->
  (forall t, a <= t < b -> Z t = later (t - a) (Z a)) -> strike d (later (b - a) (Z a)) i j ->
  Z b = collided d r i j (later (b - a) (Z a)).
Proof.
  intros P A B N F [X K]. destruct (before_it d r s T Z P b ltac:(lra)) as (e & arriving & E & G & H).
  set (u := Rmin e (b - a) / 2). pose proof (Rmin_l e (b - a)). pose proof (Rmin_r e (b - a)).
  assert (U : 0 < Rmin e (b - a)) by (apply Rmin_glb_lt; lra).
  assert (W : arriving = later (b - a) (Z a)).
  { rewrite <- (Determined.later_back u arriving), <- G, F by (unfold u; lra). rewrite later_later. f_equal. ring. }
  rewrite <- W in *. destruct H as [[H _]|(i' & j' & N' & X' & K' & O & ->)].
  - destruct (H i j N) as [_ H']. specialize (H' X). lra.
  - destruct (Determined.same_two d arriving i' j' i j N' N X O) as [[<- <-]|[<- <-]]; trivial.
    now apply collided_symmetric.
Qed.
Theorem outside_theorem_holds : outside_theorem.
Proof.
  intros D r G slow C_most Q_0 U_0 v w s N B A K T Z time P [T0 F].
  assert (Ascends : forall n, (n <= S N)%nat -> 0 <= time n).
  { induction n as [|n IH]; intros L; [lra|]. destruct (F n ltac:(lia)) as (H & _). specialize (IH ltac:(lia)). lra. }
  apply (map_goes_on D r G slow C_most Q_0 U_0 v w B s A N (fun n => Z (time n))
    (fun n => time (S n) - time n)); trivial.
  - rewrite T0. exact (Theorem1.begins _ _ _ _ _ P).
  - intros n L. destruct (F n L) as (H1 & H2 & H3). split; [lra|]. split; [exact H3|].
    apply (after_strike D r s T Z); trivial; [apply Ascends; lia|]. destruct (three n) as (_ & M & _). congruence.
Qed.
Theorem no_collapse_theorem_holds : no_collapse_theorem.
Proof.
  intros D r G slow C_most Q_0 U_0 v w s N B A K by_time c tolerance (scenes & time & T & Z & at_T & P & _).
  apply (map_goes_on D r G slow C_most Q_0 U_0 v w B s A N scenes (fun n => time (S n) - time n)); trivial.
  - exact (first_scene _ _ _ _ _ _ _ _ P).
  - intros n _. destruct (in_turn _ _ _ _ _ _ _ _ P n) as [[H1 _ H2 H3 _] E]. now repeat split.
Qed.

(* --- below the map ----------------------------------------------------------------------------------- *)

Theorem floor_theorem_holds : floor_theorem.
Proof.
  intros r G slow C_most Q_0 U_0 v w N Q U (G1 & G2 & G3 & G4 & G5 & G6 & G7 & G8 & G9 & G0) C
    (Q0 & U0 & P & Steps & Last).
  set (alpha := below_alpha r G C_most) in *. set (rho := below_rho v w) in *.
  set (x n := fst (below r G C_most Q_0 U_0 v w n)). set (u n := snd (below r G C_most Q_0 U_0 v w n)).
  assert (Pa : 0 <= alpha) by (unfold alpha, below_alpha; repeat apply Rmult_le_pos; lra).
  assert (Pr : forall n, 0 <= rho n) by (intros n; apply pow2_ge_0).
  assert (R0 : 0 <= r) by lra.
  assert (D : forall n, stops r G C_most Q_0 U_0 v w n \/
    0 < alpha * (1 - u n) - x n - rho n * u n /\
    rho n * u n * (2 * x n + rho n * u n) < (alpha * (1 - u n) - x n - rho n * u n) ^ 2).
  { intros n. unfold stops, no_step, pace, load. fold alpha rho (x n) (u n).
    destruct (Rle_lt_dec (alpha * (1 - u n) - x n - rho n * u n) 0); [now left; left|].
    destruct (Rle_lt_dec ((alpha * (1 - u n) - x n - rho n * u n) ^ 2) (rho n * u n * (2 * x n + rho n * u n)));
      [now left; right | now right]. }
  assert (Above : forall n, (n <= N)%nat -> (exists M, (M < n)%nat /\ stops r G C_most Q_0 U_0 v w M) \/
    Q n <= x n /\ U n <= u n /\ 0 < 1 - u n).
  { induction n as [|n IH]; intros L; [right; unfold x, u; cbn; lra|].
    destruct (IH ltac:(lia)) as [(M & M1 & M2)|(A1 & A2 & A3)]; [left; exists M; split; [lia | exact M2]|].
    destruct (D n) as [H|[H1 H2]]; [left; exists n; split; [lia | exact H]|]. right.
    destruct (P n ltac:(lia)) as (P1 & P2 & P3), (P (S n) L) as (_ & P4 & P5), (Steps n ltac:(lia)) as [S1 S2].
    unfold pace, load in S1, S2. cbn [fst snd] in S1, S2.
    pose proof (Ends.over_Q_rises alpha (rho n) r _ _ _ _ _ _ Pa (Pr n) R0 P1 P2 P4 P5 S1 S2 A1 A2 A3 H1 H2) as F1.
    pose proof (Ends.over_U_rises alpha (rho n) r _ _ _ _ _ _ Pa (Pr n) R0 P1 P2 P4 P5 S1 S2 A1 A2 A3 H1 H2) as F2.
    split; [exact F1|]. split; [exact F2|].
    change (u (S n)) with (1 - sqrt (1 - load (rho n) (below r G C_most Q_0 U_0 v w n) /
      pace alpha (rho n) (below r G C_most Q_0 U_0 v w n) / pace alpha (rho n) (below r G C_most Q_0 U_0 v w n))).
    unfold pace, load. fold (x n) (u n). set (p := alpha * (1 - u n) - x n - rho n * u n) in *.
    set (l := rho n * u n * (2 * x n + rho n * u n)) in *.
    assert (0 < sqrt (1 - l / p / p)); [|lra]. apply sqrt_lt_R0.
    replace (1 - l / p / p) with ((p ^ 2 - l) / p ^ 2) by (field; lra). apply Rdiv_lt_0_compat; [lra | now apply pow_lt]. }
  destruct (Above N (le_n N)) as [(M & M1 & M2)|(A1 & A2 & A3)]; [exists M; split; [lia | exact M2]|].
  exists N. split; [lia|]. destruct (D N) as [H|[H1 H2]]; [exact H|]. exfalso.
  destruct (P N (le_n N)) as (P1 & P2 & P3). unfold no_step, pace, load in Last. fold alpha in Last. cbn [fst snd] in Last.
  assert (Z1 : 0 * (alpha * (1 - U N) - Q N - rho N * U N) <= r * (1 - U N)).
  { rewrite Rmult_0_l. apply Rmult_le_pos; lra. }
  assert (Z2 : 0 * (2 - 0) * (alpha * (1 - U N) - Q N - rho N * U N) ^ 2 <=
    rho N * U N * (2 * Q N + rho N * U N)).
  { rewrite !Rmult_0_l. assert (0 <= rho N * U N) by (apply Rmult_le_pos; [apply Pr | exact P2]).
    apply Rmult_le_pos; lra. }
  pose proof (Ends.over_goes alpha (rho N) r _ _ _ _ _ _ Pa (Pr N) R0 P1 P2 (Rle_refl 0) Rle_0_1 Z1 Z2 A1 A2 A3 H1 H2).
  pose proof (Ends.over_met alpha (rho N) r _ _ _ _ _ _ Pa (Pr N) R0 P1 P2 (Rle_refl 0) Rle_0_1 Z1 Z2 A1 A2 A3 H1 H2).
  destruct Last; lra.
Qed.
