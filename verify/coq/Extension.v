(* A scope with more variables: the givens of a context say nothing of variables of inner ones. *)
From Coq Require Import Reals ZArith List Bool Arith Lia FMapPositive.
From Verify Require Import Meaning Terms Checker Accepted.
Import ListNotations.

(* New values for the variables in a list. *)
Definition extended (v : valuation) (keys : list positive) (w : valuation) : valuation :=
  fun x => if existsb (Pos.eqb x) keys then w x else v x.

Section Extension.
Variable S : statement.
Hypothesis well : well_formed S (homes S) = true.

Lemma well_parts : ordered (numbered S) = true /\ descending S = true /\
  at_home S (homes S) = true /\
  forall c a, In a (givens_of S c) ->
    In (home_in (homes S) (lhs (given_claim a))) (around S c) /\
    In (home_in (homes S) (rhs (given_claim a))) (around S c).
Proof.
  pose proof well as W. unfold well_formed in W. apply andb_prop in W. destruct W as [W G].
  apply andb_prop in W. destruct W as [W A]. apply andb_prop in W. destruct W as [O D].
  repeat split; trivial; now apply (well_formed_givens S (homes S) G).
Qed.
Lemma scope_agrees c v w : agree S c v w -> scope S c v -> scope S c w.
Proof.
  destruct well_parts as (O & D & A & G). intros E P k K. specialize (P k K). unfold satisfies in *.
  rewrite Forall_forall in *. intros a I. specialize (P a I).
  destruct (G k a I) as [L R].
  assert (Q : forall i, In (home_in (homes S) i) (around S k) -> value_at S v i = value_at S w i).
  { intros i J. apply (home_value S O D (homes S) A).
    apply agree_within with k; trivial. now apply agree_within with c. }
  unfold stands in *. now rewrite <- (Q _ L), <- (Q _ R).
Qed.

Definition belong (T : PM.t node) (c : nat) (keys : list positive) : bool :=
  forallb (fun x => match PM.find x T with Some (NVariable d) => Nat.eqb d c | _ => false end) keys.
Lemma scope_extended T c v keys w : table (numbered S) = T -> (0 < c)%nat ->
  belong T c keys = true -> scope S (parent_of S c) v ->
  satisfies S (extended v keys w) (givens_of S c) -> scope S c (extended v keys w).
Proof.
  intros <- P B V G. destruct well_parts as (_ & D & _ & _). intros k K.
  rewrite (around_step S D c P) in K. destruct K as [<-|K]; trivial. revert k K.
  apply (scope_agrees _ v); trivial. intros x d X I. unfold extended.
  destruct (existsb (Pos.eqb x) keys) eqn:E; trivial. apply existsb_exists in E.
  destruct E as (y & Y & E). apply Pos.eqb_eq in E. subst y. unfold belong in B.
  rewrite forallb_forall in B. specialize (B x Y). rewrite X in B. apply Nat.eqb_eq in B. subst d.
  apply (around_at_most S D) in I. pose proof (parent_below S D c P). lia.
Qed.
End Extension.
