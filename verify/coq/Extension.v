(* What the theorems on balls read off a statement: its induction, the givens in scope, and what holds
   in a scope with more variables, since the givens of a context say nothing of those of inner ones. *)
From Coq Require Import Reals ZArith List Bool Arith Lia FMapPositive.
From Verify Require Import Meaning Terms Checker Accepted Readable.
Import ListNotations.
Open Scope R_scope.

(* The contexts of the induction, and what is put for variables at the start and afterwards. *)
Definition induction_of (S : statement) : nat * nat * substitution * substitution :=
  match find (fun r => match row_sentence r with Always _ _ _ => true | _ => false end) (rows S) with
  | Some (Row _ c _ _ (Always d start next)) => (c, d, start, next)
  | _ => (0%nat, 0%nat, [], [])
  end.

(* New values for the variables in a list. *)
Definition extended (v : valuation) (keys : list positive) (w : valuation) : valuation :=
  fun x => if existsb (Pos.eqb x) keys then w x else v x.

(* What is read off a statement in ordinary notation: new values, and lists of givens. *)
Section Read.
Variable S : statement.
Hypothesis in_order : ordered (numbered S) = true.
Variable T : PM.t node.
Hypothesis is_table : table (numbered S) = T.
Variable l : values.
Hypothesis right : right_values S l.
Lemma substituted v s x t : put s x = Some t -> after S v s x = show S l v (read T 400 t).
Proof. intros E. rewrite (read_right S in_order T is_table) by exact right. unfold after. now rewrite E. Qed.
Lemma givens_shown v gs :
  Forall (shown S l v) (map (fun a => read_claim T (given_claim a)) gs) <-> satisfies S v gs.
Proof.
  rewrite Forall_map. split; apply Forall_impl; intros g; now apply (read_claim_right S in_order T is_table).
Qed.
End Read.

Section Extension.
Variable S : statement.
Hypothesis well : well_formed S (homes S) = true.

Lemma scope_agrees c v w : agree S c v w -> scope S c v -> scope S c w.
Proof.
  destruct (well_formed_prepared S _ well) as [[O _] D A G]. intros E P k K. specialize (P k K). unfold satisfies in *.
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
  intros <- P B V G. destruct (well_formed_prepared S _ well) as [_ D _ _]. intros k K.
  rewrite (around_step S D c P) in K. destruct K as [<-|K]; trivial. revert k K.
  apply (scope_agrees _ v); trivial. intros x d X I. unfold extended.
  destruct (existsb (Pos.eqb x) keys) eqn:E; trivial. apply existsb_exists in E.
  destruct E as (y & Y & E). apply Pos.eqb_eq in E. subst y. unfold belong in B.
  rewrite forallb_forall in B. specialize (B x Y). rewrite X in B. apply Nat.eqb_eq in B. subst d.
  apply (around_at_most S D) in I. pose proof (parent_below S D c P). lia.
Qed.

(* --- givens in ordinary notation -------------------------------------------------------------- *)

Definition same_shape (s t : shape) : {s = t} + {s <> t}.
Proof.
  decide equality; apply Z.eq_dec || apply Pos.eq_dec || apply Nat.eq_dec ||
    (decide equality; apply Pos.eq_dec).
Defined.
Definition same_shown (g h : shown_claim) : {g = h} + {g <> h}.
Proof. repeat decide equality; apply same_shape. Defined.

Variable T : PM.t node.
Hypothesis T_is : table (numbered S) = T.
Variable l : values.
Hypothesis right : right_values S l.
(* The givens in scope, the outermost first. *)
Definition conditions_of (c : nat) : list shown_claim :=
  map (fun a => read_claim T (given_claim a)) (flat_map (givens_of S) (rev (around S c))).
Lemma condition_shown c v g found : conditions_of c = found -> scope S c v ->
  (if in_dec same_shown g found then true else false) = true -> shown S l v g.
Proof.
  intros <- I G. destruct (in_dec _ _ _) as [J|]; [clear G | discriminate].
  apply (scope_shown S (in_order S _ (Terms.found S _ _ (well_formed_prepared S _ well))) T T_is _ _ _
    right) in I.
  rewrite Forall_forall in I. exact (I g J).
Qed.

(* Within a flight: an inner context has a time as its variable, and two givens. *)
Definition at_time (w : valuation) (key : positive) (t : R) : valuation :=
  extended w [key] (fun _ => t).
Lemma at_a_time w c key t relation number : (0 < c)%nat -> scope S (parent_of S c) w ->
  map (fun a => read_claim T (given_claim a)) (givens_of S c) =
    [(AtMost, Whole 0, Named key); (relation, Named key, Abbreviated number)] ->
  belong T c [key] = true ->
  related AtMost 0 t -> related relation t (look_up S l number (at_time w key t)) ->
  scope S c (at_time w key t).
Proof.
  intros P Parent G K L U. apply (scope_extended T c w [key] _ T_is P K Parent).
  fold (at_time w key t). unfold satisfies. assert (Q : at_time w key t key = t).
  { unfold at_time, extended. cbn [existsb]. now rewrite Pos.eqb_refl. }
  assert (F : Forall (shown S l (at_time w key t))
    (map (fun a => read_claim T (given_claim a)) (givens_of S c))).
  { rewrite G. apply Forall_cons; [|apply Forall_cons; [|apply Forall_nil]];
      unfold shown; cbn [fst snd show]; now rewrite Q. }
  rewrite Forall_map in F. revert F. apply Forall_impl. intros g.
  apply (read_claim_right S (in_order S _ (Terms.found S _ _ (well_formed_prepared S _ well))) T T_is
    _ _ _ right).
Qed.
End Extension.
(* The scope of an inner context of that kind, whose bound the flight is. *)
Ltac in_flight S well table_is all_right inside :=
  let T := fresh in intros T; eapply (at_a_time S well _ table_is _ all_right);
  [apply Nat.lt_0_succ | exact inside | vm_compute; reflexivity | vm_compute; reflexivity | apply T | apply T].
