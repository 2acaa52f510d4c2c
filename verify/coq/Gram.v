(* The states of the step's certificate, and that the inequalities of Cauchy and Schwarz which it
   uses hold where the numbers of a state are inner products of vectors. Step.v is what
   `verify.wire.coq.named` prints for that certificate, with the rows that are named. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Checker Readable Extension.
From Verify Require Import AnyStep.
From Verify Require Step.
Import ListNotations.
Open Scope R_scope.

Notation S0 := Step.the_statement.
Notation shown_here := (shown S0 Step.all_values).

(* The induction of the certificate, and its contexts. *)
Definition the_induction := Eval vm_compute in induction_of S0.
Definition start_context := Eval vm_compute in fst (fst (fst the_induction)).
Definition state_context := Eval vm_compute in snd (fst (fst the_induction)).
Definition start := Eval vm_compute in snd (fst the_induction).
Definition next := Eval vm_compute in snd the_induction.

Lemma well : well_formed S0 (homes S0) = true.
Proof. vm_compute. reflexivity. Qed.

(* --- states that are those of vectors --------------------------------------------------------- *)

Definition numbers_of (v : valuation) : numbers := Numbers (v Step.number_of_y)
  (v Step.number_of_eta_s) (v Step.number_of_C) (v Step.number_of_a) (v Step.number_of_b)
  (v Step.number_of_A) (v Step.number_of_B) (v Step.number_of_w) (v Step.number_of_d).
(* Ball i has just met ball 0, and j is next. *)
Definition shows (v : valuation) : nat -> scene -> ball -> ball -> Prop := has (numbers_of v).

(* The inequalities of Cauchy and Schwarz that the certificate uses. *)
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
  map (fun a => read_claim Step.the_table (given_claim a)) (standing S0 state_context).
Lemma the_standing_is :
  map (fun a => read_claim Step.the_table (given_claim a)) (standing S0 state_context) = the_standing.
Proof. vm_compute. reflexivity. Qed.
Lemma vectors_standing v dimension p q s c : products (numbers_of v) dimension p q s c ->
  satisfies S0 v (standing S0 state_context).
Proof.
  intros [P Q PQ PS QC PC QS SS CC SC].
  cbn [y eta_s C a b A B w d numbers_of] in *.
  assert (X : Forall (shown_here v) the_standing).
  { pose proof (cauchy_schwarz dimension p q) as C1. pose proof (cauchy_schwarz dimension p s) as C2.
    pose proof (cauchy_schwarz dimension q c) as C3. pose proof (cauchy_schwarz dimension p c) as C4.
    pose proof (cauchy_schwarz dimension q s) as C5. pose proof (cauchy_schwarz dimension s c) as C6.
    pose proof (outer_square dimension q s c Q) as C7.
    pose proof (fun t e => impact_square dimension p q s c t e P Q) as C8.
    rewrite PQ, P, Q in C1. rewrite PS, P, SS in C2. rewrite QC, Q, CC in C3. rewrite PC, P, CC in C4.
    rewrite QS, Q, SS in C5. rewrite SC, SS, CC in C6. rewrite QS, QC, SS, SC, CC in C7.
    rewrite PQ, PS, QC, PC, QS, SS, CC, SC in C8. unfold the_standing.
    repeat (apply Forall_cons; [first [exact C1 | exact C2 | exact C3 | exact C4 | exact C5
      | exact C6 | exact C7 | exact (proj1 (C8 _ (1 + v Step.number_of_d)))
      | exact (proj2 (C8 _ (1 + v Step.number_of_d)))]|]).
    apply Forall_nil. }
  apply (givens_shown S0 Step.the_order _ Step.the_table_is _ Step.all_right). now rewrite the_standing_is.
Qed.
