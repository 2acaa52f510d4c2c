(* A certificate adds terms to those of its statement. `same_meaning` says that the statement means the
   same with them, if what it names is among its own terms; and likewise what is believed of what it
   cites. *)
From Coq Require Import Reals ZArith List Lia Bool FMapPositive FunctionalExtensionality.
From Verify Require Import Meaning Terms.
Import ListNotations.
Open Scope R_scope.

Definition with_nodes (more : list node) (S : statement) : statement :=
  Statement (nodes S ++ more) (contexts S) (own_contexts S) (constants S) (rows S) (cited S)
    (cited_constants S).

(* --- what a statement names --------------------------------------------------------------------- *)

Section OwnNames.
Variable bound : positive.
Definition among_them (i : positive) : bool := Pos.ltb i bound.
Definition claim_names (g : claim) : bool := among_them (lhs g) && among_them (rhs g).
Definition substitution_names (s : substitution) : bool := forallb (fun x => among_them (snd x)) s.
Definition context_names (c : context) : bool :=
  forallb (fun a => claim_names (given_claim a)) (givens c).
Definition row_names (r : row) : bool :=
  match row_sentence r with
  | Compare g => claim_names g
  | Applies _ at_ => substitution_names at_
  | Always _ start next => substitution_names start && substitution_names next
  end.
End OwnNames.
Definition names_its_own (S : statement) : bool :=
  let bound := Pos.of_succ_nat (length (nodes S)) in
  forallb (fun x => forallb (among_them bound) (subterms x)) (nodes S) &&
  forallb (context_names bound) (contexts S) &&
  forallb (among_them bound) (constants S) && forallb (among_them bound) (cited_constants S) &&
  forallb (row_names bound) (rows S) &&
  forallb (fun x => claim_names bound (snd (snd x))) (cited S).

(* --- they mean the same ------------------------------------------------------------------------- *)

Lemma grow_more a b : forall k trees, exists j,
  grow k (a ++ b) trees = grow j b (grow k a trees) /\ Pos.to_nat j = (Pos.to_nat k + length a)%nat.
Proof.
  induction a as [|x a IH]; intros k trees; cbn [app grow length].
  - exists k. split; [reflexivity | lia].
  - destruct (IH (Pos.succ k) (PM.add k (tree trees k x) trees)) as (j & E & L).
    exists j. split; [exact E | lia].
Qed.

Section MoreNodes.
Variable S : statement.
Variable more : list node.
Let larger := with_nodes more S.
Let bound := Pos.of_succ_nat (length (nodes S)).
Hypothesis own_names : names_its_own S = true.

Lemma term_same i : among_them bound i = true -> term_at larger i = term_at S i.
Proof.
  intros B. apply Pos.ltb_lt in B. unfold term_at, larger, with_nodes, tree_at. cbn [nodes].
  destruct (grow_more (nodes S) more 1 (PM.empty term)) as (j & -> & L).
  rewrite grow_before; [reflexivity|]. unfold bound in B. lia.
Qed.
Lemma value_same v i : among_them bound i = true -> value_at larger v i = value_at S v i.
Proof. intros B. unfold value_at. now rewrite term_same. Qed.
Lemma defined_same v i : among_them bound i = true -> defined_at larger v i = defined_at S v i.
Proof. intros B. unfold defined_at. now rewrite term_same. Qed.
Lemma stands_same v g : claim_names bound g = true -> stands larger v g = stands S v g.
Proof.
  intros B. apply andb_prop in B. destruct B. unfold stands. now rewrite !value_same.
Qed.
Lemma holds_same v g : claim_names bound g = true -> holds larger v g = holds S v g.
Proof.
  intros B. unfold holds. rewrite stands_same by exact B. apply andb_prop in B. destruct B.
  now rewrite !defined_same.
Qed.
Lemma fails_same v g : claim_names bound g = true -> fails larger v g = fails S v g.
Proof.
  intros B. unfold fails. rewrite stands_same by exact B. apply andb_prop in B. destruct B.
  now rewrite !defined_same.
Qed.

Lemma parts_named :
  (forall x, In x (nodes S) -> forall i, In i (subterms x) -> among_them bound i = true) /\
  (forall c a, In c (contexts S) -> In a (givens c) -> claim_names bound (given_claim a) = true) /\
  (forall i, In i (constants S) -> among_them bound i = true) /\
  (forall i, In i (cited_constants S) -> among_them bound i = true) /\
  (forall r, In r (rows S) -> row_names bound r = true) /\
  (forall x, In x (cited S) -> claim_names bound (snd (snd x)) = true).
Proof.
  pose proof own_names as N. unfold names_its_own in N. fold bound in N.
  repeat (apply andb_prop in N; destruct N as [N ?]). rewrite forallb_forall in *.
  split; [|split; [|split; [|split; [|split]]]]; auto.
  - intros x I. apply forallb_forall. auto.
  - intros c a I J. assert (X : context_names bound c = true) by auto.
    unfold context_names in X. rewrite forallb_forall in X. auto.
Qed.

Lemma givens_named c a : In a (givens_of S c) -> claim_names bound (given_claim a) = true.
Proof.
  intros I. unfold givens_of, context_at in I. destruct c as [|k]; [destruct I|].
  destruct (nth_error (contexts S) k) as [x|] eqn:E; [|destruct I].
  apply nth_error_In in E. eapply (proj1 (proj2 parts_named)); eauto.
Qed.
Lemma satisfies_same v l : (forall a, In a l -> claim_names bound (given_claim a) = true) ->
  (satisfies larger v l <-> satisfies S v l).
Proof.
  intros B. unfold satisfies. rewrite !Forall_forall.
  split; intros H a I; specialize (H a I); rewrite (stands_same v _ (B a I)) in *; exact H.
Qed.
Lemma scope_same c v : scope larger c v <-> scope S c v.
Proof.
  unfold scope. split; intros H k I; specialize (H k I);
    apply (satisfies_same v (givens_of S k)); eauto using givens_named.
Qed.
Lemma fact_same c g : claim_names bound g = true -> (fact larger c g <-> fact S c g).
Proof.
  intros B. unfold fact. split; intros H v I;
    [rewrite <- (holds_same v g B) | rewrite (holds_same v g B)]; apply H, scope_same, I.
Qed.

Lemma put_named s x i : substitution_names bound s = true -> put s x = Some i -> among_them bound i = true.
Proof.
  unfold substitution_names. rewrite forallb_forall. intros B.
  induction s as [|[y t] s IH]; cbn [put]; [discriminate|].
  destruct (Pos.eqb x y); [injection 1 as <-; exact (B _ (or_introl eq_refl))|].
  apply IH. intros z I. apply B. now right.
Qed.
Lemma after_same v s : substitution_names bound s = true -> after larger v s = after S v s.
Proof.
  intros B. apply functional_extensionality. intros x. unfold after.
  destruct (put s x) as [i|] eqn:E; [|reflexivity]. apply value_same. eapply put_named; eauto.
Qed.
Lemma all_defined_same v s : substitution_names bound s = true ->
  (all_defined larger v s <-> all_defined S v s).
Proof.
  unfold substitution_names, all_defined. rewrite forallb_forall, !Forall_forall. intros B.
  split; intros H x I; specialize (H x I); rewrite (defined_same v _ (B x I)) in *; exact H.
Qed.
Lemma state_same v start next m :
  substitution_names bound start = true -> substitution_names bound next = true ->
  state larger v start next m = state S v start next m.
Proof.
  intros B C. induction m as [|m IH]; cbn [state]; [now apply after_same|].
  rewrite IH. now apply after_same.
Qed.
Lemma standing_named c a : In a (standing S c) -> claim_names bound (given_claim a) = true.
Proof. intros I. apply filter_In in I. eapply givens_named, I. Qed.

Lemma row_same r : In r (rows S) -> (row_true larger r <-> row_true S r).
Proof.
  intros I. assert (B : row_names bound r = true) by now apply parts_named.
  unfold row_names in B. unfold row_true. destruct (row_sentence r) as [g | d at_ | d start next].
  - destruct (row_verdict r); cbn [says]; [now apply fact_same | | reflexivity].
    split; intros (v & H & F); exists v; (split; [now apply scope_same|]);
      [rewrite <- (fails_same v g B) | rewrite (fails_same v g B)]; exact F.
  - destruct (row_verdict r); cbn [says]; [| reflexivity | reflexivity].
    split; intros H v J;
      [rewrite <- (all_defined_same v at_ B), <- scope_same, <- (after_same v at_ B)
      | rewrite (all_defined_same v at_ B), scope_same, (after_same v at_ B)];
      apply H, scope_same, J.
  - apply andb_prop in B. destruct B as [B C].
    destruct (row_verdict r); cbn [says]; [| reflexivity | reflexivity].
    assert (X : forall v m, (forall k, (k <= m)%nat ->
        satisfies larger (state larger v start next k) (standing larger d)) <->
      (forall k, (k <= m)%nat -> satisfies S (state S v start next k) (standing S d))).
    { intros v m. split; intros H k L; specialize (H k L);
        [rewrite state_same in H by assumption | rewrite state_same by assumption];
        apply (satisfies_same _ (standing S d)); eauto using standing_named. }
    split; intros H v J; specialize (H v).
    + rewrite <- scope_same in J. destruct (H J) as [D E]. rewrite all_defined_same in D by exact B.
      split; [exact D|]. intros m K. rewrite <- X in K. specialize (E m K).
      rewrite state_same, scope_same, all_defined_same in E by assumption. exact E.
    + rewrite scope_same in J. destruct (H J) as [D E]. rewrite all_defined_same by exact B.
      split; [exact D|]. intros m K. rewrite X in K. specialize (E m K).
      rewrite state_same, scope_same, all_defined_same by assumption. exact E.
Qed.
Lemma constant_same i : among_them bound i = true -> (constant_defined larger i <-> constant_defined S i).
Proof.
  intros B. unfold constant_defined. change (nodes larger) with (nodes S ++ more).
  apply Pos.ltb_lt in B. rewrite nth_error_app1 by (unfold bound in B; lia).
  destruct (nth_error (nodes S) _) as [x|] eqn:E; [|reflexivity]. apply nth_error_In in E.
  destruct x; try reflexivity.
  assert (D : among_them bound definition = true).
  { eapply (proj1 parts_named); [exact E | now left]. }
  split; intros H v J; [rewrite <- (defined_same v _ D) | rewrite (defined_same v _ D)];
    apply H, scope_same, J.
Qed.
Lemma context_same c : context_good larger c <-> context_good S c.
Proof.
  unfold context_good. change (givens_of larger c) with (givens_of S c).
  assert (X : forall v, Forall (fun a => holds larger v (given_claim a)) (givens_of S c) <->
    Forall (fun a => holds S v (given_claim a)) (givens_of S c)).
  { intros v. rewrite !Forall_forall. split; intros H a I; specialize (H a I);
      rewrite (holds_same v _ (givens_named c a I)) in *; exact H. }
  split; intros [[v G] H]; (split; [exists v; now apply scope_same|]);
    intros w J; apply X, H, scope_same, J.
Qed.

Theorem same_meaning :
  (true_statement larger <-> true_statement S) /\ (citations_true larger <-> citations_true S).
Proof.
  destruct parts_named as (_ & _ & own_constants & others & _ & facts).
  unfold true_statement, citations_true. change (contexts larger) with (contexts S).
  change (own_contexts larger) with (own_contexts S). change (constants larger) with (constants S).
  change (rows larger) with (rows S). change (cited larger) with (cited S).
  change (cited_constants larger) with (cited_constants S). rewrite !Forall_forall.
  split; split.
  - intros (A & B & C & D). split; [|split; [|split]]; intros x I; auto.
    + apply constant_same; auto.
    + apply context_same; auto.
    + apply row_same; auto.
  - intros (A & B & C & D). split; [|split; [|split]]; intros x I; auto.
    + apply constant_same; auto.
    + apply context_same; auto.
    + apply row_same; auto.
  - intros (A & B & C). split; [|split]; intros x I.
    + apply constant_same; auto.
    + apply fact_same; auto.
    + destruct (C x I); auto. right. now apply context_same.
  - intros (A & B & C). split; [|split]; intros x I.
    + apply constant_same; auto.
    + apply fact_same; auto.
    + destruct (C x I); auto. right. now apply context_same.
Qed.
End MoreNodes.
