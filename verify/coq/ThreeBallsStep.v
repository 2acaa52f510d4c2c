(* One collision of three balls of any masses and radii, by the certificate of the collapse theorem for
   them: in units of the distances of contact the inner products are those of AnyStep.v, with another
   share of the speed of impact. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Checker Readable Extension.
From Verify Require Import Classification Contacts Line LineProof AnyStep ThreeBalls.
From Verify Require Gram Balls.
Import ListNotations.
Open Scope R_scope.

(* --- a flight and a collision -------------------------------------------------------------------- *)

Lemma farther D s i j x : 0 <= x -> x ^ 2 < square D s i j -> x < distance D s i j.
Proof.
  intros P Q. rewrite <- (sqrt_pow2 x P). unfold distance. apply sqrt_lt_1; [apply pow2_ge_0 | apply dot_self | exact Q].
Qed.
Lemma as_far D s i j x : 0 <= x -> square D s i j = x ^ 2 -> distance D s i j = x.
Proof. intros P Q. unfold distance. unfold square in Q. rewrite Q. now apply sqrt_pow2. Qed.

Section BallsFlight.
Variable D : nat.
Variables mass radius : ball -> R.
Variable r : R.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis round : forall b, 0 < radius b.

Variables o i j : ball.  (* i has just met o, and j is next *)
Hypothesis distinct : distinct_balls o i j.
Notation si := (radius o + radius i).
Notation sj := (radius o + radius j).

(* In units of the distances of contact, the scene has these numbers. *)
Definition seen (m : numbers) (x : scene) (i j : ball) : Prop := exists p q s c,
  to x o i = scaled (radius o + radius i) p /\ relative x o i = scaled (radius o + radius i) s /\
  to x o j = scaled ((radius o + radius j) * (1 + d m)) q /\ relative x o j = scaled (radius o + radius j) c /\
  products m D p q s c.
Lemma cosine_seen m x : seen m x i j -> 0 < 1 + d m -> minus_cosine_at D x o i j = C m.
Proof.
  intros (p & q & s & c & X1 & _ & X2 & _ & [P Q PQ _ _ _ _ _ _ _]) F. unfold minus_cosine_at.
  pose proof (round o). pose proof (round i). pose proof (round j).
  assert (0 < sj * (1 + d m)) by (apply Rmult_lt_0_compat; lra).
  assert (E1 : distance D x o i = si).
  { apply as_far; [lra|]. unfold square. rewrite X1, dot_scaled, dot_scaled_right, P. ring. }
  assert (E2 : distance D x o j = sj * (1 + d m)).
  { apply as_far; [lra|]. unfold square. rewrite X2, dot_scaled, dot_scaled_right, Q. ring. }
  rewrite E1, E2, X1, X2, dot_scaled, dot_scaled_right, PQ. field. repeat split; lra.
Qed.

Variable m : numbers.
Variable t : R.
Definition outer_of_balls (u : R) : Prop := (radius i + radius j) ^ 2 <
  si ^ 2 * (1 + u * eta_s m + u * eta_s m + u * u * B m)
  - 2 * si * sj * ((1 + d m) * - C m + u * (a m + (1 + d m) * b m) + u * u * w m)
  + sj ^ 2 * ((1 + d m) * (1 + d m) + (1 + d m) * u * - y m + u * (1 + d m) * - y m + u * u * A m).
Hypothesis certified : certified_if m t outer_of_balls.
Variable x : scene.
Hypothesis shown_by : seen m x i j.

Lemma squares_of_balls u :
  square D (later u x) o i = si ^ 2 * (1 + u * eta_s m + u * eta_s m + u * u * B m) /\
  square D (later u x) o j = sj ^ 2 * ((1 + d m) * (1 + d m) + (1 + d m) * u * - y m + u * (1 + d m) * - y m + u * u * A m) /\
  square D (later u x) i j =
    si ^ 2 * (1 + u * eta_s m + u * eta_s m + u * u * B m)
    - 2 * si * sj * ((1 + d m) * - C m + u * (a m + (1 + d m) * b m) + u * u * w m)
    + sj ^ 2 * ((1 + d m) * (1 + d m) + (1 + d m) * u * - y m + u * (1 + d m) * - y m + u * u * A m).
Proof.
  destruct shown_by as (p & q & s & c & X1 & X2 & X3 & X4 & G).
  pose proof (square_behind m D _ _ _ _ G u) as S1. pose proof (square_ahead m D _ _ _ _ G u) as S2.
  pose proof (product_between m D _ _ _ _ G u) as S3.
  assert (E1 : to (later u x) o i = scaled si (combined 1 p u s)).
  { rewrite to_later, X1, X2. apply same_vector. intros n. unfold combined, scaled. ring. }
  assert (E2 : to (later u x) o j = scaled sj (combined (1 + d m) q u c)).
  { rewrite to_later, X3, X4. apply same_vector. intros n. unfold combined, scaled. ring. }
  assert (E3 : to (later u x) i j = combined (- si) (combined 1 p u s) sj (combined (1 + d m) q u c)).
  { replace (to (later u x) i j) with (combined (-1) (to (later u x) o i) 1 (to (later u x) o j))
      by (apply same_vector; intros n; unfold combined, to; ring).
    rewrite E1, E2. apply same_vector. intros n. unfold combined, scaled. ring. }
  unfold square. rewrite E1, E2, E3. split; [|split].
  - rewrite dot_scaled, dot_scaled_right, S1. ring.
  - rewrite dot_scaled, dot_scaled_right, S2. ring.
  - rewrite square_of_combined, S1, S2, S3. ring.
Qed.
Lemma impact_of_balls : exists p q s c, to x o i = scaled si p /\ relative x o i = scaled si s /\
  relative x o j = scaled sj c /\ products m D p q s c /\
  to (later t x) o j = scaled sj (combined (1 + d m) q t c) /\
  rate D (later t x) o j = sj ^ 2 * impact m t.
Proof.
  destruct shown_by as (p & q & s & c & X1 & X2 & X3 & X4 & G). exists p, q, s, c.
  assert (E2 : to (later t x) o j = scaled sj (combined (1 + d m) q t c)).
  { rewrite to_later, X3, X4. apply same_vector. intros n. unfold combined, scaled. ring. }
  repeat (split; [assumption|]). unfold rate. rewrite E2, relative_later, X4, dot_scaled, dot_scaled_right,
    (rate_ahead m t D _ _ _ _ G). ring.
Qed.

Theorem balls_meet : meets_next D radius x o j t.
Proof.
  pose proof (round o). pose proof (round i). pose proof (round j).
  pose proof (takes_time _ _ _ certified) as F. pose proof (recedes _ _ _ certified) as E.
  assert (PI : 0 < si ^ 2) by (apply pow_lt; lra). assert (PJ : 0 < sj ^ 2) by (apply pow_lt; lra).
  assert (Ai : forall u, 0 < u <= t -> si < distance D (later u x) o i).
  { intros u U. destruct (squares_of_balls u) as (Q & _). apply farther; [lra|]. rewrite Q.
    pose proof (spectator_apart _ _ _ certified u ltac:(lra)) as S.
    assert (0 < u * eta_s m) by (apply Rmult_lt_0_compat; lra).
    rewrite <- (Rmult_1_r (si ^ 2)) at 1. apply Rmult_lt_compat_l; lra. }
  assert (Ao : forall u, 0 < u <= t -> radius i + radius j < distance D (later u x) i j).
  { intros u U. destruct (squares_of_balls u) as (_ & _ & Q). apply farther; [lra|]. rewrite Q.
    apply (outer_apart _ _ _ certified). lra. }
  split; [exact F|]. split; [|split; [|split]].
  - intros u k l U N. revert k l N. apply (any_of_three _ o i j distinct).
    + intros k l B. rewrite distance_symmetric, Rplus_comm. exact B.
    + apply Ai. lra.
    + destruct (squares_of_balls u) as (_ & Q & _). apply farther; [lra|]. rewrite Q.
      rewrite <- (Rmult_1_r (sj ^ 2)) at 1. apply Rmult_lt_compat_l; [exact PJ|].
      apply (colliding_apart _ _ _ certified). lra.
    + apply Ao. lra.
  - destruct (squares_of_balls t) as (_ & Q & _). apply as_far; [lra|]. rewrite Q, (touching _ _ _ certified). ring.
  - destruct impact_of_balls as (_ & _ & _ & _ & _ & _ & _ & _ & _ & ->). pose proof (approaching _ _ _ certified).
    assert (0 < sj ^ 2 * - impact m t) by (apply Rmult_lt_0_compat; lra). lra.
  - intros k N1 N2. destruct distinct as (D1 & D2 & D3). assert (k = i) as -> by (destruct o, i, j, k; congruence).
    split; [apply Ai; lra|]. rewrite distance_symmetric, Rplus_comm. apply Ao. lra.
Qed.
Theorem balls_after :
  seen (after_sharing (share_of mass radius (fun _ => r) o j i) r m t) (bounced D mass r o j (later t x)) j i.
Proof.
  pose proof (round o). pose proof (round i). pose proof (round j). pose proof (heavy o). pose proof (heavy j).
  pose proof (far_after _ _ _ certified) as F. destruct distinct as (N1 & N2 & N3).
  destruct impact_of_balls as (p & q & s & c & X1 & X2 & X4 & G & Omega & Rate).
  assert (Far : distance D (later t x) o j = sj).
  { destruct (squares_of_balls t) as (_ & Q & _). apply as_far; [lra|]. rewrite Q, (touching _ _ _ certified). ring. }
  set (kappa := impact m t) in *. set (share := share_of mass radius (fun _ => r) o j i).
  exists (combined (1 + d m) q t c), (combined (1 / reach m t) p (t / reach m t) s),
    (combined 1 c (- ((1 + r) * kappa)) (combined (1 + d m) q t c)),
    (combined 1 s (- (share * kappa)) (combined (1 + d m) q t c)).
  split; [exact Omega|]. split; [|split; [|split]].
  - apply same_vector. intros n. transitivity (relative x o j n -
      (1 + r) * rate D (later t x) o j / distance D (later t x) o j ^ 2 * to (later t x) o j n).
    + unfold relative, bounced. cbn [velocity]. rewrite !same_true, (same_false j o) by congruence.
      cbn [later velocity]. rewrite Far. field. split; lra.
    + rewrite Far, Rate, Omega, X4. unfold scaled, combined. field. lra.
  - replace (1 + d (after_sharing share r m t)) with (reach m t) by (unfold after_sharing; cbn [d]; ring).
    change (to (bounced D mass r o j (later t x)) o i) with (to (later t x) o i). rewrite to_later, X1, X2.
    apply same_vector. intros n. unfold combined, scaled. field. lra.
  - apply same_vector. intros n. transitivity (relative x o i n - mass j *
      ((1 + r) * rate D (later t x) o j / distance D (later t x) o j ^ 2 / (mass o + mass j)) * to (later t x) o j n).
    + unfold relative, bounced. cbn [velocity]. rewrite !same_true, (same_false i o), (same_false i j) by congruence.
      cbn [later velocity]. ring.
    + rewrite Far, Rate, Omega, X2. unfold scaled, combined, share, share_of, reach_of. field. repeat split; lra.
  - exact (products_next share r m t D _ _ _ _ G _ certified).
Qed.
End BallsFlight.

(* --- the states of the certificate --------------------------------------------------------------- *)

Notation SB := Balls.the_statement.
Notation shown_here := (shown SB Balls.all_values).
Definition the_induction := Eval vm_compute in induction_of SB.
Definition start_context := Eval vm_compute in fst (fst (fst the_induction)).
Definition state_context := Eval vm_compute in snd (fst (fst the_induction)).
Definition start := Eval vm_compute in snd (fst the_induction).
Definition next := Eval vm_compute in snd the_induction.
Lemma well : well_formed SB (homes SB) = true.
Proof. vm_compute. reflexivity. Qed.

Definition numbers_of (v : valuation) : numbers := Numbers (v Balls.number_of_y)
  (v Balls.number_of_eta_s) (v Balls.number_of_C) (v Balls.number_of_a) (v Balls.number_of_b)
  (v Balls.number_of_A) (v Balls.number_of_B) (v Balls.number_of_w) (v Balls.number_of_d).
Notation here v := (v Balls.number_of_Q, v Balls.number_of_U).
Notation alpha_here v :=
  (v Balls.number_of_beta_c * (v Balls.number_of_C_0 - v Balls.number_of_Theta)).
Notation rho_here v :=
  (v Balls.number_of_G * (v Balls.number_of_w_s / v Balls.number_of_w_c) ^ 2).

(* What the certificate takes for granted: inequalities of Cauchy and Schwarz, and that the map goes on. *)
Definition the_standing := Eval vm_compute in
  map (fun a => read_claim Balls.the_table (given_claim a)) (standing SB state_context).
Lemma the_standing_is :
  map (fun a => read_claim Balls.the_table (given_claim a)) (standing SB state_context) = the_standing.
Proof. vm_compute. reflexivity. Qed.
Lemma vectors_standing v dimension p q s c : products (numbers_of v) dimension p q s c ->
  0 < pace (alpha_here v) (rho_here v) (here v) ->
  load (rho_here v) (here v) <= v Balls.number_of_U_b * (2 - v Balls.number_of_U_b) *
    pace (alpha_here v) (rho_here v) (here v) ^ 2 ->
  satisfies SB v (standing SB state_context).
Proof.
  intros [P Q PQ PS QC PC QS S2 CC SC] Approaches Meets. cbn [y eta_s C a b A B w d numbers_of] in *.
  assert (X : Forall (shown_here v) the_standing).
  { pose proof (cauchy_schwarz dimension p q) as C1. pose proof (cauchy_schwarz dimension p s) as C2.
    pose proof (cauchy_schwarz dimension q c) as C3. pose proof (cauchy_schwarz dimension p c) as C4.
    pose proof (cauchy_schwarz dimension q s) as C5.
    pose proof (fun t e => Gram.impact_square dimension p q s c t e P Q) as C8.
    rewrite PQ, P, Q in C1. rewrite PS, P, S2 in C2. rewrite QC, Q, CC in C3. rewrite PC, P, CC in C4.
    rewrite QS, Q, S2 in C5. rewrite PQ, PS, QC, PC, QS, S2, CC, SC in C8. unfold the_standing.
    repeat (apply Forall_cons; [first [exact C1 | exact C2 | exact C3 | exact C4 | exact C5
      | exact (proj1 (C8 _ (1 + v Balls.number_of_d))) | exact (proj2 (C8 _ (1 + v Balls.number_of_d)))
      | exact Approaches | exact Meets]|]).
    apply Forall_nil. }
  rewrite <- the_standing_is in X. unfold satisfies. rewrite Forall_map in X. revert X.
  apply Forall_impl. intros g.
  apply (read_claim_right SB Balls.the_order Balls.the_table Balls.the_table_is).
  exact Balls.all_right.
Qed.

Ltac row_of w is_row inside :=
  refine (row_in_scope SB Balls.the_order Balls.the_table Balls.the_table_is
    Balls.the_rows_hold Balls.all_values _ _ _ w Balls.all_right is_row _); exact inside.
Definition the_conditions := Eval vm_compute in conditions_of SB Balls.the_table state_context.
Lemma the_conditions_are : conditions_of SB Balls.the_table state_context = the_conditions.
Proof. vm_compute. reflexivity. Qed.
Definition condition v g : scope SB state_context v -> _ -> shown_here v g :=
  condition_shown SB well Balls.the_table Balls.the_table_is _ Balls.all_right _ v g _
    the_conditions_are.

Section BallsState.
Variable v : valuation.
Hypothesis inside : scope SB state_context v.
Notation vy := (v Balls.number_of_y).
Notation vs := (v Balls.number_of_eta_s).
Notation vA := (v Balls.number_of_A).
Notation vB := (v Balls.number_of_B).
Notation vd := (v Balls.number_of_d).
Definition flight : R := Balls.tau vy vA vd.
Definition new : valuation := after SB v next.
Lemma new_value x t : put next x = Some t ->
  new x = show SB Balls.all_values v (read Balls.the_table 400 t).
Proof.
  intros E. rewrite (read_right SB Balls.the_order Balls.the_table Balls.the_table_is _ _
    Balls.all_right).
  unfold new, after. now rewrite E.
Qed.
Lemma mapped_next : here new = mapped (alpha_here v) (rho_here v) (v Balls.number_of_r_c * v Balls.number_of_G) (here v).
Proof. rewrite (new_value Balls.number_of_Q _ eq_refl), (new_value Balls.number_of_U _ eq_refl). reflexivity. Qed.
Lemma before t : 0 <= t < flight -> scope SB Balls.context_before (at_time v Balls.number_of_s t).
Proof.
  intros T. eapply (at_a_time SB well Balls.the_table Balls.the_table_is _ Balls.all_right);
    [apply Nat.lt_0_succ | exact inside | vm_compute; reflexivity | vm_compute; reflexivity
    | apply T | apply T].
Qed.
Lemma meanwhile t : 0 <= t <= flight -> scope SB Balls.context_meanwhile (at_time v Balls.number_of_t t).
Proof.
  intros T. eapply (at_a_time SB well Balls.the_table Balls.the_table_is _ Balls.all_right);
    [apply Nat.lt_0_succ | exact inside | vm_compute; reflexivity | vm_compute; reflexivity
    | apply T | apply T].
Qed.
Theorem balls_step radius o i j : v Balls.number_of_sigma_s = radius o + radius i ->
  v Balls.number_of_sigma_c = radius o + radius j -> v Balls.number_of_sigma_12 = radius i + radius j ->
  certified_if (numbers_of v) flight (outer_of_balls radius o i j (numbers_of v)).
Proof.
  intros Si Sj Sij. split.
  - row_of v Balls.row_of_tau_positive_is inside.
  - refine (condition _ (Less, Whole 0, Named Balls.number_of_eta_s) inside _). vm_compute. reflexivity.
  - refine (condition _ (Less, Whole 0, Plus (Whole 1) (Named Balls.number_of_d)) inside _).
    vm_compute. reflexivity.
  - assert (P : 0 < Balls.d_next vy vs vA vB vd) by row_of v Balls.row_of_next_d_positive_is inside.
    unfold Balls.d_next in P. change (0 < Balls.D vy vs vA vB vd). lra.
  - row_of v Balls.row_of_contact_is inside.
  - assert (E : Balls.kappa vy vA vd = - ((1 + vd) * vy * Balls.S vy vA vd))
      by row_of v Balls.row_of_impact_speed_is inside.
    assert (P : 0 < (1 + vd) * vy * Balls.S vy vA vd)
      by row_of v Balls.row_of_impact_positive_is inside.
    change (Balls.kappa vy vA vd < 0). lra.
  - intros t T.
    row_of (at_time v Balls.number_of_s t) Balls.row_of_colliding_pair_apart_is (before t T).
  - intros t T.
    row_of (at_time v Balls.number_of_t t) Balls.row_of_spectator_apart_is (meanwhile t T).
  - intros t T. unfold outer_of_balls. rewrite <- Si, <- Sj, <- Sij. cbn [y eta_s C a b A B w d numbers_of].
    set (S := v Balls.number_of_sigma_s). set (K := v Balls.number_of_sigma_c).
    assert (Q : v Balls.number_of_sigma_12 ^ 2 < (- S) * (- S) + (- S) * (t * (- S)) * vs
      + (- S) * (K * (1 + vd)) * (- v Balls.number_of_C) + (- S) * (t * K) * v Balls.number_of_a
      + t * (- S) * (- S) * vs + t * (- S) * (t * (- S)) * vB
      + t * (- S) * (K * (1 + vd)) * v Balls.number_of_b + t * (- S) * (t * K) * v Balls.number_of_w
      + K * (1 + vd) * (- S) * (- v Balls.number_of_C) + K * (1 + vd) * (t * (- S)) * v Balls.number_of_b
      + K * (1 + vd) * (K * (1 + vd)) + K * (1 + vd) * (t * K) * (- vy)
      + t * K * (- S) * v Balls.number_of_a + t * K * (t * (- S)) * v Balls.number_of_w
      + t * K * (K * (1 + vd)) * (- vy) + t * K * (t * K) * vA)
      by row_of (at_time v Balls.number_of_t t) Balls.row_of_outer_pair_apart_is (meanwhile t T).
    apply (Rlt_le_trans _ _ _ Q), Req_le. ring.
Qed.
Ltac in_new x := rewrite (new_value x _ eq_refl).
Lemma new_numbers : numbers_of new =
  after_sharing (v Balls.number_of_beta_c) (v Balls.number_of_r_c) (numbers_of v) flight.
Proof.
  unfold numbers_of. in_new Balls.number_of_y. in_new Balls.number_of_eta_s.
  in_new Balls.number_of_C. in_new Balls.number_of_a. in_new Balls.number_of_b.
  in_new Balls.number_of_A. in_new Balls.number_of_B. in_new Balls.number_of_w.
  in_new Balls.number_of_d. unfold after_sharing. cbn [y eta_s C a b A B w d].
  f_equal; try reflexivity.
  transitivity (Balls.A_next vy (v Balls.number_of_b) vA vB (v Balls.number_of_w) vd (v Balls.number_of_beta_c)).
  - reflexivity.
  - unfold Balls.A_next, impact. cbn [y A d]. unfold Balls.kappa. fold flight. ring.
Qed.
End BallsState.
