(* The induction of Theorem 1, and what follows for the whole trajectory. Step.v is what
   `verify export coq --readable certificates/step` prints.

   The n-th state is defined from the numbers of the start by the map that the certificate is about.
   If each state has the inner products of some vectors in R^d, then for all n the conditions of the
   recursion hold, the times of the collisions increase and converge, to at most T_star, and C, minus
   the cosine of the angle, converges, to at most delta_theta away from c. That the inner products
   are those of the particles is not proved here. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Meaning Vectors Readable Step.
Import Coq.Init.Datatypes Coq.Lists.List Meaning Vectors Readable.  (* again: Step has names of its own *)
Import ListNotations.
Open Scope R_scope.

(* --- sequences -------------------------------------------------------------------------------- *)

Lemma bounded_increasing_converges (u : nat -> R) (b : R) :
  (forall n, u n <= u (S n)) -> (forall n, u n <= b) -> exists l, Un_cv u l.
Proof.
  intros G B. destruct (Un_cv_crit u G) as [l L]; [|eauto].
  exists b. intros x [n ->]. apply B.
Qed.
Lemma limit_at_most (u : nat -> R) (l b : R) : Un_cv u l -> (forall n, u n <= b) -> l <= b.
Proof.
  intros L B. apply Rnot_lt_le. intros N. destruct (L (l - b)) as [m M]; [lra|].
  specialize (M m (Nat.le_refl m)). specialize (B m). unfold R_dist, Rabs in M.
  destruct Rcase_abs; lra.
Qed.
Lemma limit_opposite (u : nat -> R) (l : R) : Un_cv u l -> Un_cv (fun n => - u n) (- l).
Proof. apply CV_opp. Qed.
Lemma limit_after_one (u : nat -> R) (l : R) : Un_cv (fun n => u (S n)) l -> Un_cv u l.
Proof.
  intros L e E. destruct (L e E) as [m M]. exists (S m). intros [|n] N; [lia|]. apply M. lia.
Qed.
(* What moves by no more than a bounded increasing sequence does converges. *)
Lemma bounded_variation_converges (u w : nat -> R) (b : R) :
  (forall n, u (S n) - u n <= w (S n) - w n) -> (forall n, u n - u (S n) <= w (S n) - w n) ->
  (forall n, w n <= b) -> exists l, Un_cv u l.
Proof.
  intros A B W.
  assert (G : forall n, w n <= w (S n)) by (intros n; specialize (A n); specialize (B n); lra).
  destruct (bounded_increasing_converges w b G W) as [m M].
  assert (P : forall n, u n - u 0%nat <= w n - w 0%nat).
  { induction n; [lra|]. specialize (A n). lra. }
  destruct (bounded_increasing_converges (fun n => u n + w n) (u 0%nat + b + b - w 0%nat)) as [l L].
  - intros n. specialize (B n). lra.
  - intros n. specialize (P n). specialize (W n). lra.
  - exists (l - m). pose proof (CV_minus _ _ _ _ L M) as Q. intros e E. destruct (Q e E) as [k R].
    exists k. intros n N. specialize (R n N). unfold R_dist in *.
    replace (u n - (l - m)) with (u n + w n - w n - (l - m)) by ring. exact R.
Qed.

(* --- the trajectory --------------------------------------------------------------------------- *)

Notation S0 := the_statement.
Definition the_induction := Eval vm_compute in
  match find (fun r => match row_sentence r with Always _ _ _ => true | _ => false end) (rows S0) with
  | Some (Row _ c _ _ (Always d start next)) => (c, d, start, next)
  | _ => (0%nat, 0%nat, [], [])
  end.
Definition start_context := Eval vm_compute in fst (fst (fst the_induction)).
Definition state_context := Eval vm_compute in snd (fst (fst the_induction)).
Definition start := Eval vm_compute in snd (fst the_induction).
Definition next := Eval vm_compute in snd the_induction.

(* A state has the inner products of four vectors: the directions p and q, of which one is from the
   particle in the middle to that which is about to collide, and the relative velocities s and c. *)
Record has_vectors (v : valuation) (dimension : nat) (p q s c : vector) : Prop := {
  unit_p : dot dimension p p = 1; unit_q : dot dimension q q = 1;
  angle : dot dimension p q = - v number_of_C;
  p_s : dot dimension p s = v number_of_eta_s; q_c : dot dimension q c = - v number_of_y;
  p_c : dot dimension p c = v number_of_a; q_s : dot dimension q s = v number_of_b;
  square_s : dot dimension s s = v number_of_B; square_c : dot dimension c c = v number_of_A;
  s_c : dot dimension s c = v number_of_w
}.
Lemma impact_square d p q s c t e :
  (dot d p p = 1) -> (dot d q q = 1) ->
  (e * dot d q s + t * dot d s c) ^ 2 <=
    dot d s s * (e * e + e * t * dot d q c + t * e * dot d q c + t * t * dot d c c) /\
  (e * dot d p q + e * t * dot d q s + t * dot d p c + t * t * dot d s c) ^ 2 <=
    (e * e + e * t * dot d q c + t * e * dot d q c + t * t * dot d c c) *
    (1 + t * dot d p s + t * dot d p s + t * t * dot d s s).
Proof.
  intros P Q. split.
  - pose proof (cauchy_schwarz d s (combined e q t c)) as A.
    rewrite dot_linear_right, square_of_combined, Q, (dot_symmetric d s q) in A. lra.
  - pose proof (cauchy_schwarz d (combined e q t c) (combined 1 p t s)) as A.
    rewrite !square_of_combined, dot_linear, !dot_linear_right, P, Q, (dot_symmetric d q p),
      (dot_symmetric d c p), (dot_symmetric d c s) in A.
    replace (e * dot d p q + e * t * dot d q s + t * dot d p c + t * t * dot d s c) with
      (e * (1 * dot d p q + t * dot d q s) + t * (1 * dot d p c + t * dot d s c)) by ring.
    lra.
Qed.
Lemma outer_square d q s c : dot d q q = 1 ->
  (-1 * dot d q s + dot d q c) ^ 2 <= 1 * (-1 * -1 * dot d s s + -1 * dot d s c + -1 * dot d s c + dot d c c).
Proof.
  intros Q. pose proof (cauchy_schwarz d q (combined (-1) s 1 c)) as A.
  rewrite dot_linear_right, square_of_combined, Q in A.
  replace (-1 * dot d q s + dot d q c) with (-1 * dot d q s + 1 * dot d q c) by ring. lra.
Qed.
Definition the_standing := Eval vm_compute in
  map (fun a => read_claim the_table (given_claim a)) (standing S0 state_context).
Lemma the_standing_is :
  map (fun a => read_claim the_table (given_claim a)) (standing S0 state_context) = the_standing.
Proof. vm_compute. reflexivity. Qed.
Lemma vectors_standing v dimension p q s c : has_vectors v dimension p q s c ->
  satisfies S0 v (standing S0 state_context).
Proof.
  intros [P Q PQ PS QC PC QS SS CC SC].
  assert (A : Forall (shown S0 all_values v) the_standing).
  { pose proof (cauchy_schwarz dimension p q) as C1. pose proof (cauchy_schwarz dimension p s) as C2.
    pose proof (cauchy_schwarz dimension q c) as C3. pose proof (cauchy_schwarz dimension p c) as C4.
    pose proof (cauchy_schwarz dimension q s) as C5. pose proof (cauchy_schwarz dimension s c) as C6.
    pose proof (outer_square dimension q s c Q) as C7.
    pose proof (fun t e => impact_square dimension p q s c t e P Q) as C8.
    rewrite PQ, P, Q in C1. rewrite PS, P, SS in C2. rewrite QC, Q, CC in C3. rewrite PC, P, CC in C4.
    rewrite QS, Q, SS in C5. rewrite SC, SS, CC in C6. rewrite QS, QC, SS, SC, CC in C7.
    assert (C9 : forall t e, (e * v number_of_b + t * v number_of_w) ^ 2 <=
        v number_of_B * (e * e + e * t * - v number_of_y + t * e * - v number_of_y
          + t * t * v number_of_A) /\
      (e * - v number_of_C + e * t * v number_of_b + t * v number_of_a + t * t * v number_of_w) ^ 2 <=
        (e * e + e * t * - v number_of_y + t * e * - v number_of_y + t * t * v number_of_A) *
        (1 + t * v number_of_eta_s + t * v number_of_eta_s + t * t * v number_of_B)).
    { intros t e. specialize (C8 t e). now rewrite PQ, PS, QC, PC, QS, SS, CC, SC in C8. }
    clear C8. unfold the_standing.
    repeat (apply Forall_cons; [first [exact C1 | exact C2 | exact C3 | exact C4 | exact C5
      | exact C6 | exact C7 | exact (proj1 (C9 _ (1 + v number_of_d)))
      | exact (proj2 (C9 _ (1 + v number_of_d)))]|]).
    apply Forall_nil. }
  rewrite <- the_standing_is in A. unfold satisfies. rewrite Forall_map in A. revert A.
  apply Forall_impl. intros a. apply (read_claim_right S0 the_order the_table the_table_is).
  exact all_right.
Qed.

Section Trajectory.
(* Numbers that satisfy the conditions on the parameters and on the start. *)
Variable v : valuation.
Hypothesis good_start : scope S0 start_context v.
Definition at_step (n : nat) : valuation := state S0 v start next n.
Hypothesis vectors_always : forall n, exists dimension p q s c,
  has_vectors (at_step n) dimension p q s c.

Lemma scope_always n : scope S0 state_context (at_step n).
Proof.
  destruct (always v good_start) as [_ A]. destruct (A n) as [B _]; [|exact B].
  intros k _. destruct (vectors_always k) as (dimension & p & q & s & c & V).
  now apply vectors_standing in V.
Qed.
(* What a row says of each state. *)
Ltac row_at n is_row := refine (row_in_scope S0 the_order the_table the_table_is the_rows_hold
  all_values _ _ _ (at_step n) all_right is_row _); exact (scope_always n).

Definition time (n : nat) : R := at_step n number_of_clock.
Definition cosine (n : nat) : R := at_step n number_of_C.
Definition distance (n : nat) : R := at_step n number_of_d.
(* The time until the next collision. *)
Definition flight (n : nat) : R :=
  look_up S0 all_values (match put next number_of_clock with
    | Some t => match read the_table 400 t with Plus _ (Abbreviated i) => i | _ => 1%positive end
    | None => 1%positive end) (at_step n).

Lemma next_value n x t : put next x = Some t ->
  at_step (S n) x = show S0 all_values (at_step n) (read the_table 400 t).
Proof.
  intros E. rewrite (read_right S0 the_order the_table the_table_is _ _ all_right).
  unfold at_step at 1. cbn [state]. unfold after. now rewrite E.
Qed.
Lemma kept_value n x : put next x = None -> put start x = None -> at_step n x = v x.
Proof.
  intros N P. induction n as [|n IH]; unfold at_step in *; cbn [state]; unfold after.
  - now rewrite P.
  - now rewrite N.
Qed.
Lemma time_next n : time (S n) = time n + flight n.
Proof. exact (next_value n number_of_clock _ eq_refl). Qed.
Lemma flight_positive n : 0 < flight n.
Proof. row_at n row_of_tau_positive_is. Qed.
Lemma time_bounded n : time n <= v number_of_T_star.
Proof.
  rewrite <- (kept_value n number_of_T_star eq_refl eq_refl). row_at n row_of_time_total_is.
Qed.
Definition speed : R := sqrt (v number_of_V_1).
Lemma distance_next n : distance (S n) <= 3 / 2 * speed * flight n.
Proof.
  unfold speed. rewrite <- (kept_value n number_of_V_1 eq_refl eq_refl).
  replace (distance (S n)) with (show S0 all_values (at_step n)
    (match put next number_of_d with Some t => read the_table 400 t | None => Whole 0 end))
    by (symmetry; exact (next_value n number_of_d _ eq_refl)).
  row_at n row_of_distance_time_is.
Qed.
Lemma cosine_up n : cosine (S n) - cosine n <= distance n + distance (S n) + 4 * speed * flight n.
Proof.
  unfold speed. rewrite <- (kept_value n number_of_V_1 eq_refl eq_refl).
  replace (cosine (S n)) with (show S0 all_values (at_step n)
    (match put next number_of_C with Some t => read the_table 400 t | None => Whole 0 end))
    by (symmetry; exact (next_value n number_of_C _ eq_refl)).
  replace (distance (S n)) with (show S0 all_values (at_step n)
    (match put next number_of_d with Some t => read the_table 400 t | None => Whole 0 end))
    by (symmetry; exact (next_value n number_of_d _ eq_refl)).
  row_at n row_of_angle_step_upper_is.
Qed.
Lemma cosine_down n : cosine n - cosine (S n) <= distance n + distance (S n) + 4 * speed * flight n.
Proof.
  unfold speed. rewrite <- (kept_value n number_of_V_1 eq_refl eq_refl).
  replace (cosine (S n)) with (show S0 all_values (at_step n)
    (match put next number_of_C with Some t => read the_table 400 t | None => Whole 0 end))
    by (symmetry; exact (next_value n number_of_C _ eq_refl)).
  replace (distance (S n)) with (show S0 all_values (at_step n)
    (match put next number_of_d with Some t => read the_table 400 t | None => Whole 0 end))
    by (symmetry; exact (next_value n number_of_d _ eq_refl)).
  row_at n row_of_angle_step_lower_is.
Qed.
Lemma cosine_near n : cosine n - v number_of_c <= v number_of_delta_theta /\
  v number_of_c - cosine n <= v number_of_delta_theta.
Proof.
  rewrite <- (kept_value n number_of_c eq_refl eq_refl),
    <- (kept_value n number_of_delta_theta eq_refl eq_refl).
  split; [row_at n row_of_angle_final_upper_is | row_at n row_of_angle_final_lower_is].
Qed.

(* --- the theorem ------------------------------------------------------------------------------ *)

Theorem finite_time : exists t, Un_cv time t /\ t <= v number_of_T_star.
Proof.
  destruct (bounded_increasing_converges time (v number_of_T_star)) as [t L].
  - intros n. rewrite time_next. pose proof (flight_positive n). lra.
  - exact time_bounded.
  - exists t. split; trivial. exact (limit_at_most _ _ _ L time_bounded).
Qed.
Theorem angle_converges : exists l, Un_cv cosine l /\
  Rabs (l - v number_of_c) <= v number_of_delta_theta.
Proof.
  assert (P : 0 <= speed) by apply sqrt_pos.
  assert (D : forall n, distance (S n) <= 3 / 2 * speed * (time (S n) - time n)).
  { intros n. rewrite time_next. replace (time n + flight n - time n) with (flight n) by ring.
    apply distance_next. }
  assert (F : forall n, flight n = time (S n) - time n) by (intros n; rewrite time_next; ring).
  set (w := fun n => 3 / 2 * speed * time n + 11 / 2 * speed * time (S n)).
  destruct (bounded_variation_converges (fun n => cosine (S n)) w
    (3 / 2 * speed * v number_of_T_star + 11 / 2 * speed * v number_of_T_star)) as [l L].
  - intros n. pose proof (cosine_up (S n)) as A. rewrite F in A.
    pose proof (D n). pose proof (D (S n)). unfold w. lra.
  - intros n. pose proof (cosine_down (S n)) as A. rewrite F in A.
    pose proof (D n). pose proof (D (S n)). unfold w. lra.
  - intros n. unfold w. apply Rplus_le_compat; apply Rmult_le_compat_l; try apply time_bounded; lra.
  - apply limit_after_one in L. exists l. split; trivial. apply Rabs_le. split.
    + pose proof (limit_at_most (fun n => - cosine n) (- l)
        (v number_of_delta_theta - v number_of_c) (limit_opposite _ _ L)) as Q.
      enough (- l <= v number_of_delta_theta - v number_of_c) by lra.
      apply Q. intros n. pose proof (cosine_near n). lra.
    + enough (l <= v number_of_c + v number_of_delta_theta) by lra.
      apply (limit_at_most _ _ _ L). intros n. pose proof (cosine_near n). lra.
Qed.
End Trajectory.
Print Assumptions angle_converges.
