(* The states of the sharper theorem: the numbers of each satisfy what AnyStep.v asks for, and the
   certificate's next state is the one there. Sharper.v has the lemmas of that certificate, with the
   numbers that its terms have in a statement that cites the flow before it. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Checker Readable.
From Verify Require Import Extension AnyStep.
From Verify Require Citations Flow Gram OneStep Sharper.
Import ListNotations.
Open Scope R_scope.

Notation SS := Sharper.the_statement.
Notation shown_here := (shown SS Sharper.all_values).

(* The induction of the certificate, and its contexts. *)
Definition the_induction := Eval vm_compute in induction_of SS.
Definition start_context := Eval vm_compute in fst (fst (fst the_induction)).
Definition state_context := Eval vm_compute in snd (fst (fst the_induction)).
Definition start := Eval vm_compute in snd (fst the_induction).
Definition next := Eval vm_compute in snd the_induction.
Lemma well : well_formed SS (homes SS) = true.
Proof. vm_compute. reflexivity. Qed.

Definition numbers_of (v : valuation) : numbers := Numbers (v Sharper.number_of_y)
  (v Sharper.number_of_eta_s) (v Sharper.number_of_C) (v Sharper.number_of_a)
  (v Sharper.number_of_b) (v Sharper.number_of_A) (v Sharper.number_of_B) (v Sharper.number_of_w)
  (v Sharper.number_of_d).

Lemma citations : citations_true SS.
Proof.
  apply (Citations.citations_closed [(Flow.the_statement, Citations.size Flow.the_statement SS)]).
  - vm_compute. reflexivity.
  - apply Forall_cons; [exact Flow.proved | constructor].
Qed.

(* --- the inequalities of Cauchy and Schwarz that the certificate uses --------------------------- *)

Definition the_standing := Eval vm_compute in
  map (fun a => read_claim Sharper.the_table (given_claim a)) (standing SS state_context).
Lemma the_standing_is :
  map (fun a => read_claim Sharper.the_table (given_claim a)) (standing SS state_context) = the_standing.
Proof. vm_compute. reflexivity. Qed.
Lemma apart_square n p q s c e : dot n p p = 1 -> dot n q q = 1 ->
  (-1 * -1 * dot n p s + -1 * dot n p c + e * -1 * dot n q s + e * dot n q c) ^ 2 <=
    (-1 * -1 + -1 * e * dot n p q + e * -1 * dot n p q + e * e) *
    (-1 * -1 * dot n s s + -1 * dot n s c + -1 * dot n s c + dot n c c).
Proof.
  intros P Q. pose proof (cauchy_schwarz n (combined (-1) p e q) (combined (-1) s 1 c)) as A.
  rewrite !square_of_combined, dot_linear, !dot_linear_right, P, Q in A.
  replace (-1 * -1 * dot n p s + -1 * dot n p c + e * -1 * dot n q s + e * dot n q c) with
    (-1 * (-1 * dot n p s + 1 * dot n p c) + e * (-1 * dot n q s + 1 * dot n q c)) by ring.
  lra.
Qed.
Lemma vectors_standing v dimension p q s c : products (numbers_of v) dimension p q s c ->
  satisfies SS v (standing SS state_context).
Proof.
  intros [P Q PQ PS QC PC QS S2 CC SC]. cbn [y eta_s C a b A B w d numbers_of] in *.
  assert (X : Forall (shown_here v) the_standing).
  { pose proof (cauchy_schwarz dimension p q) as C1. pose proof (cauchy_schwarz dimension p s) as C2.
    pose proof (cauchy_schwarz dimension q c) as C3. pose proof (cauchy_schwarz dimension p c) as C4.
    pose proof (cauchy_schwarz dimension q s) as C5. pose proof (cauchy_schwarz dimension s c) as C6.
    pose proof (fun e => apart_square dimension p q s c e P Q) as C7.
    pose proof (fun t e => Gram.impact_square dimension p q s c t e P Q) as C8.
    rewrite PQ, P, Q in C1. rewrite PS, P, S2 in C2. rewrite QC, Q, CC in C3. rewrite PC, P, CC in C4.
    rewrite QS, Q, S2 in C5. rewrite SC, S2, CC in C6. rewrite PS, PC, QS, QC, PQ, S2, SC, CC in C7.
    rewrite PQ, PS, QC, PC, QS, S2, CC, SC in C8. unfold the_standing.
    repeat (apply Forall_cons; [first [exact C1 | exact C2 | exact C3 | exact C4 | exact C5
      | exact C6 | exact (C7 (1 + v Sharper.number_of_d))
      | exact (proj1 (C8 _ (1 + v Sharper.number_of_d)))
      | exact (proj2 (C8 _ (1 + v Sharper.number_of_d)))]|]).
    apply Forall_nil. }
  apply (givens_shown SS Sharper.the_order _ Sharper.the_table_is _ Sharper.all_right). now rewrite the_standing_is.
Qed.

(* --- what the certificate says of a state ------------------------------------------------------- *)

Ltac row_of w is_row inside :=
  refine (row_in_scope SS Sharper.the_order Sharper.the_table Sharper.the_table_is
    (Sharper.the_rows_hold citations) Sharper.all_values _ _ _ w Sharper.all_right is_row _); exact inside.
Definition the_conditions := Eval vm_compute in conditions_of SS Sharper.the_table state_context.
Lemma the_conditions_are : conditions_of SS Sharper.the_table state_context = the_conditions.
Proof. vm_compute. reflexivity. Qed.
Definition condition v g : scope SS state_context v -> _ -> shown_here v g :=
  condition_shown SS well Sharper.the_table Sharper.the_table_is _ Sharper.all_right _ v g _
    the_conditions_are.

Section SharperStep.
Variable v : valuation.
Hypothesis inside : scope SS state_context v.
Notation r := (v Sharper.number_of_r).
Notation vy := (v Sharper.number_of_y).
Notation vs := (v Sharper.number_of_eta_s).
Notation vA := (v Sharper.number_of_A).
Notation vB := (v Sharper.number_of_B).
Notation vd := (v Sharper.number_of_d).
Definition flight : R := Sharper.tau vy vA vd.
Definition new : valuation := after SS v next.
Lemma new_value x t : put next x = Some t ->
  new x = show SS Sharper.all_values v (read Sharper.the_table 400 t).
Proof. exact (substituted SS Sharper.the_order _ Sharper.the_table_is _ Sharper.all_right _ _ _ _). Qed.

Lemma before t : 0 <= t < flight -> scope SS Sharper.context_before (at_time v Sharper.number_of_s t).
Proof. in_flight SS well Sharper.the_table_is Sharper.all_right inside. Qed.
Lemma meanwhile t : 0 <= t <= flight -> scope SS Sharper.context_meanwhile (at_time v Sharper.number_of_t t).
Proof. in_flight SS well Sharper.the_table_is Sharper.all_right inside. Qed.

Theorem sharper_step : step_certified (numbers_of v) flight.
Proof.
  split.
  - row_of v Sharper.row_of_tau_positive_is inside.
  - refine (condition _ (Less, Whole 0, Named Sharper.number_of_eta_s) inside _). vm_compute. reflexivity.
  - refine (condition _ (Less, Whole 0, Plus (Whole 1) (Named Sharper.number_of_d)) inside _).
    vm_compute. reflexivity.
  - assert (P : 0 < Sharper.d_next vy vs vA vB vd) by row_of v Sharper.row_of_next_d_positive_is inside.
    unfold Sharper.d_next in P. change (0 < Sharper.D vy vs vA vB vd). lra.
  - row_of v Sharper.row_of_contact_is inside.
  - assert (E : Sharper.kappa vy vA vd = - ((1 + vd) * vy * Sharper.S vy vA vd))
      by row_of v Sharper.row_of_impact_speed_is inside.
    assert (P : 0 < (1 + vd) * vy * Sharper.S vy vA vd)
      by row_of v Sharper.row_of_impact_positive_is inside.
    change (Sharper.kappa vy vA vd < 0). lra.
  - intros t T.
    row_of (at_time v Sharper.number_of_s t) Sharper.row_of_colliding_pair_apart_is (before t T).
  - intros t T.
    row_of (at_time v Sharper.number_of_t t) Sharper.row_of_spectator_apart_is (meanwhile t T).
  - intros t T. unfold outer_of_equal. cbn [y eta_s C a b A B w d numbers_of].
    assert (Q : 1 < (-1) * (-1) + (-1) * (t * (-1)) * vs
      + (-1) * (1 + vd) * (- v Sharper.number_of_C)
      + (-1) * t * v Sharper.number_of_a + t * (-1) * (-1) * vs + t * (-1) * (t * (-1)) * vB
      + t * (-1) * (1 + vd) * v Sharper.number_of_b + t * (-1) * t * v Sharper.number_of_w
      + (1 + vd) * (-1) * (- v Sharper.number_of_C) + (1 + vd) * (t * (-1)) * v Sharper.number_of_b
      + (1 + vd) * (1 + vd) + (1 + vd) * t * (- vy)
      + t * (-1) * v Sharper.number_of_a + t * (t * (-1)) * v Sharper.number_of_w
      + t * (1 + vd) * (- vy) + t * t * vA)
      by row_of (at_time v Sharper.number_of_t t) Sharper.row_of_outer_pair_apart_is (meanwhile t T).
    apply (Rlt_le_trans _ _ _ Q), Req_le. ring.
Qed.
Ltac in_new x := rewrite (new_value x _ eq_refl).
Lemma new_numbers : numbers_of new = after_step r (numbers_of v) flight.
Proof.
  unfold numbers_of. in_new Sharper.number_of_y. in_new Sharper.number_of_eta_s.
  in_new Sharper.number_of_C. in_new Sharper.number_of_a. in_new Sharper.number_of_b.
  in_new Sharper.number_of_A. in_new Sharper.number_of_B. in_new Sharper.number_of_w.
  in_new Sharper.number_of_d. unfold after_step, after_sharing. cbn [y eta_s C a b A B w d].
  f_equal; try reflexivity.
  transitivity (Sharper.A_next r vy (v Sharper.number_of_b) vA vB (v Sharper.number_of_w) vd).
  - reflexivity.
  - unfold Sharper.A_next, impact. cbn [y A d]. unfold Sharper.kappa. fold flight. ring.
Qed.
End SharperStep.
