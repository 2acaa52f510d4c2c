(* What the rows of a scene say: each applies a context of the flow to numbers, which therefore satisfy
   what FlowStep.v and Runs.v ask for. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Citations Readable Extension FlowStep Runs.
From Verify Require Flow.
Import ListNotations.
Open Scope R_scope.

Notation SF := Flow.the_statement.

(* The givens of a context without a parent, read back. *)
Definition flow_givens (c : nat) : list shown_claim :=
  map (fun a => read_claim Flow.the_table (given_claim a)) (givens_of SF c).
Lemma flow_given c w : scope SF c w -> In c (around SF c) ->
  Forall (shown SF Flow.all_values w) (flow_givens c).
Proof.
  intros S I. apply (givens_shown SF Flow.the_order _ Flow.the_table_is _ Flow.all_right), S, I.
Qed.
Lemma scope_of_row S1 c at_ : begins SF S1 (size SF S1) = true -> Nat.leb c (length (contexts SF)) = true ->
  says S1 0 (Applies c at_) -> scope SF c (after S1 (fun _ => 0) at_).
Proof.
  intros B L A. apply (scope_same SF S1 (size SF S1) B); [now apply PeanoNat.Nat.leb_le|].
  apply A. intros k [<-|[]]. apply Forall_nil.
Qed.
Ltac givens_of_flow w S c found :=
  let F := fresh in pose proof (flow_given c w S (or_introl eq_refl)) as F;
  let E := fresh in assert (E : flow_givens c = found) by (vm_compute; reflexivity);
  rewrite E in F; clear E; unfold found in F;
  repeat (apply Forall_cons_iff in F; let X := fresh in destruct F as [X F]).
Definition collision_givens := Eval vm_compute in flow_givens Flow.context_collision.
Lemma collision_certified w : scope SF Flow.context_collision w -> flow_collision
  (w Flow.number_of_r) (w Flow.number_of_v_) (w Flow.number_of_lam) (w Flow.number_of_rho)
  (w Flow.number_of_eps) (w Flow.number_of_sig) (w Flow.number_of_A) (w Flow.number_of_B)
  (w Flow.number_of_C) (w Flow.number_of_a) (w Flow.number_of_b) (w Flow.number_of_w)
  (w Flow.number_of_y) (w Flow.number_of_q) (w Flow.number_of_kap) (w Flow.number_of_s)
  (w Flow.number_of_T) (w Flow.number_of_C_next) (w Flow.number_of_lam_next)
  (w Flow.number_of_A_next) (w Flow.number_of_B_next) (w Flow.number_of_a_next)
  (w Flow.number_of_b_next) (w Flow.number_of_w_next) (w Flow.number_of_eps_next).
Proof.
  intros S. givens_of_flow w S Flow.context_collision collision_givens.
  split; assumption.
Qed.

Definition parting_givens := Eval vm_compute in flow_givens Flow.context_parting.
Definition passing_givens := Eval vm_compute in flow_givens Flow.context_passing.

(* A pair at the rate p, with the square m of its speed and g that of its distance, less 1. *)
Definition pair_ends (m g p : R) : Prop := 0 <= p \/ (0 < m /\ p ^ 2 < m * g).
Lemma parting_certified w : scope SF Flow.context_parting w -> forall m g, pair_ends m g (w Flow.number_of_parting_p).
Proof.
  intros S m g. givens_of_flow w S Flow.context_parting parting_givens. left. assumption.
Qed.
Lemma passing_certified w : scope SF Flow.context_passing w -> pair_ends (w Flow.number_of_passing_m)
  (w Flow.number_of_passing_g) (w Flow.number_of_passing_p).
Proof.
  intros S. givens_of_flow w S Flow.context_passing passing_givens. right. split; assumption.
Qed.
Lemma pair_never_meets d x i j : 1 <= square d x i j ->
  pair_ends (dot d (relative x i j) (relative x i j)) (square d x i j - 1) (rate d x i j) ->
  never_meets d x i j.
Proof. intros S [P|[M P]]; [now apply never_by_parting | now apply never_by_passing]. Qed.
Lemma never_by_numbers d x i j m g p : dot d (relative x i j) (relative x i j) = m ->
  square d x i j = 1 + g -> rate d x i j = p -> 0 <= g -> pair_ends m g p -> never_meets d x i j.
Proof.
  intros M S P G E. apply pair_never_meets; [lra|]. rewrite M, P, S. now replace (1 + g - 1) with g by ring.
Qed.

Theorem never_again d x o i c v lam rho eps sig A B C a b w : i <> o /\ c <> o /\ i <> c ->
  gram d x o i c v lam rho eps sig A B C a b w ->
  1 <= square d x o i /\ 1 <= square d x o c /\ 1 <= square d x i c ->
  pair_ends B (sig * v ^ 2) (rho * v) -> pair_ends A (eps * v ^ 2) (- (lam * v)) ->
  pair_ends (A + B - 2 * w) (1 + (eps + sig) * v ^ 2 + 2 * C) ((rho - lam) * v - a - b) ->
  forall t, 0 < t -> nobody_collides d (later t x).
Proof.
  intros N [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10] (S1 & S2 & S3) P1 P2 P3.
  apply (never_any d x o i c N); apply pair_never_meets; trivial.
  - unfold rate, square. rewrite G8, G1, G4. now replace (1 + sig * v ^ 2 - 1) with (sig * v ^ 2) by ring.
  - unfold rate, square. rewrite G9, G2, G5. now replace (1 + eps * v ^ 2 - 1) with (eps * v ^ 2) by ring.
  - unfold rate, square. rewrite (from_o x o i c), (moves_from_o x o i c), !square_of_combined.
    rewrite dot_linear, !dot_linear_right, G1, G2, G3, G4, G5, G6, G7, G8, G9, G10.
    replace (-1 * -1 * B + 2 * -1 * 1 * w + 1 * 1 * A) with (A + B - 2 * w) by ring.
    replace (-1 * -1 * (1 + sig * v ^ 2) + 2 * -1 * 1 * - C + 1 * 1 * (1 + eps * v ^ 2) - 1)
      with (1 + (eps + sig) * v ^ 2 + 2 * C) by ring.
    replace (-1 * (-1 * (rho * v) + 1 * a) + 1 * (-1 * b + 1 * - (lam * v)))
      with ((rho - lam) * v - a - b) by ring.
    exact P3.
Qed.
