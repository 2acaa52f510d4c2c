(* Each rule is sound: what it accepts holds for all values that satisfy what is in scope. One lemma
   per rule, in the order of verify/check.py; the rule of intervals is in Places.v. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool Arith FMapPositive.
From Verify Require Import Meaning Roots Polynomials Terms Substitution Clearing Cleared Enclosures Cosines.
From Verify Require Import Laws Rising Kernel Induction Places.
Import ListNotations.
Open Scope R_scope.

Section Sound.
Variable S : statement.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable H : PM.t nat.
Hypothesis ready : prepared S T H.
Let found := found S T H ready.
Variable F : facts.
Hypothesis valid_facts : valid S F.
Variable grounds : list (positive * memory).
Hypothesis good_grounds : all_remembered S grounds.
Let value_is := value_is S T found.
Let defined_is := defined_is S T found.
Let is_zero_sound := is_zero_sound S T H ready.
Let scope_after := scope_after S T H ready.
Let substituted_sound := substituted_sound S T K H ready.
Let inside_scope := inside_scope S T H ready.
Let fact_at_sound := fact_at_sound S T H ready F valid_facts.
Let knows_sound := knows_sound S T H ready F valid_facts.
Let usable_right := usable_right S T H ready F valid_facts.
Let none_replaced := none_replaced S.
Let clears_sound := clears_sound S T K H ready F valid_facts.

Section AtPlace.
Variable v : valuation.
Variable p : place.
Hypothesis here : satisfied S v p.
Let branch_satisfied := branch_satisfied S v p here.
Let pieces_cover := pieces_cover S v.
Let good_points_sound := good_points_sound S T H ready v.
Let least_le := least_le S v.
Let greatest_ge := greatest_ge S v.
Let least_in := least_in S v.
Let greatest_in := greatest_in S v.

Section Inner.
Variable prove : place -> claim -> proof -> bool.
(* That proofs inside a proof are sound. *)
Definition proves (q : proof) : Prop :=
  forall p g, prove p g q = true -> forall v, satisfied S v p -> holds S v g.

(* --- cuts --- *)

Lemma cuts_sound g t points branches : Forall proves branches ->
  cuts S T K F prove p g t points branches = true -> holds S v g.
Proof.
  unfold cuts. intros P E. split_and E. apply (clears_sound v p here) in E.
  inversion_clear E as [|? ? D _]. apply good_points_sound in A0.
  destruct (pieces_cover t points [] D A0) as (more & I & M); [constructor|].
  apply paired_sound with (Q := fun more => Forall (holds S v) more -> holds S v g) in A.
  - rewrite Forall_forall in A. now apply (A more).
  - revert P. apply Forall_impl. intros q Q x X Y. exact (Q _ _ X v (branch_satisfied _ Y)).
Qed.

(* --- cases --- *)

(* What a minimum or a maximum is to its entries. *)
Definition beyond (is_min : bool) (x y : R) : Prop := if is_min then x <= y else y <= x.
Lemma extremum_at_sound t is_min l : extremum_at T t = Some (is_min, l) ->
  (forall e, In e l -> beyond is_min (value_at S v t) (value_at S v e)) /\
  (exists e, In e l /\ value_at S v t = value_at S v e) /\
  (defined_at S v t -> Forall (defined_at S v) l).
Proof.
  unfold extremum_at. destruct (PM.find t T) as [[]|] eqn:E; try discriminate; injection 1 as <- <-;
    rewrite (value_is _ _ _ E), (defined_is _ _ _ E); cbn [node_value subterms];
    (split; [|split; [|intros [D _]; now apply Forall_forall]]).
  - intros e I. now apply least_le.
  - apply least_in.
  - intros e I. now apply greatest_ge.
  - apply greatest_in.
Qed.
Lemma picked_each l : forall before e, In e l ->
  exists rest, In (e, rest) (picked before l) /\ incl rest (before ++ l).
Proof.
  induction l as [|a l IH]; cbn [picked In]; intros before e I; [tauto|]. destruct I as [<-|I].
  - exists (before ++ l). split; [now left|]. intros x X. apply in_app_or in X.
    apply in_or_app. cbn. tauto.
  - destruct (IH (before ++ [a]) e I) as (rest & J & L). exists rest. split; [now right|].
    intros x X. apply L in X. now rewrite <- app_assoc in X.
Qed.
Lemma cases_sound g t branches : Forall proves branches ->
  cases S T K F prove p g t branches = true -> holds S v g.
Proof.
  unfold cases. intros P E. destruct (extremum_at T t) as [[is_min l]|] eqn:X; try discriminate.
  split_and E. apply (clears_sound v p here) in E. inversion_clear E as [|? ? D _].
  apply extremum_at_sound in X. destruct X as (B & (e & I & V) & Q). specialize (Q D).
  rewrite Forall_forall in Q.
  destruct (picked_each l [] e I) as (rest & J & L).
  apply paired_sound with
    (Q := fun x => Forall (holds S v) (case t is_min x) -> holds S v g) in A.
  - rewrite Forall_forall in A. apply (A _ J). unfold case. cbn [fst snd]. constructor.
    + repeat split; auto.
    + apply Forall_map, Forall_forall. intros o O. apply L in O. cbn [app] in O.
      specialize (B o O). rewrite V in B. destruct is_min; repeat split; auto.
  - revert P. apply Forall_impl. intros q M x Y Z. eauto.
Qed.

(* --- entry and least --- *)

Lemma extremum_sound g s equation is_min l other :
  extremum S T K F p g s equation = Some (is_min, l, other) ->
  exists t, (t, other) = match s with Left => (lhs g, rhs g) | Right => (rhs g, lhs g) end /\
    defined_at S v t /\ defined_at S v other /\
    (forall e, In e l -> beyond is_min (value_at S v t) (value_at S v e)) /\
    (exists e, In e l /\ value_at S v t = value_at S v e).
Proof.
  unfold extremum.
  destruct (match s with Left => (lhs g, rhs g) | Right => (rhs g, lhs g) end) as [t o].
  destruct (clears S T K F p [t; o]) eqn:C; try discriminate. intros E.
  bind E u U. bind E x X. destruct x as [m l']. injection E as <- <- <-.
  apply (clears_sound v p here) in C. inversion_clear C as [|? ? Dt C']. inversion_clear C' as [|? ? Do _].
  apply extremum_at_sound in X. destruct X as (B & W & _).
  assert (V : value_at S v t = value_at S v u).
  { destruct equation as [f|]; [|now injection U as <-]. bind U h Hh.
    destruct (_ && _) eqn:Q; try discriminate. injection U as <-. split_and Q.
    apply (fact_at_sound v p here) in Hh. destruct Hh as (_ & _ & Hh). unfold stands in Hh.
    apply same_relation_sound in Q. apply Pos.eqb_eq in A0. now rewrite Q, A0 in Hh. }
  exists t. rewrite V. auto.
Qed.
Lemma entry_sound g s equation : entry S T K F p g s equation = true -> holds S v g.
Proof.
  unfold entry. destruct (extremum _ _ _ _ _ _ _ _) as [[[m l] o]|] eqn:X; try discriminate.
  intros E. split_and E. apply extremum_sound in X. destruct X as (t & Q & Dt & Do & B & _).
  apply eqb_prop in E. apply same_relation_sound in A0. apply existsb_exists in A.
  destruct A as (e & I & J). apply Pos.eqb_eq in J. subst e. specialize (B _ I).
  destruct g as [r a b]. unfold holds, stands. cbn [lhs rhs relation_of] in *. subst m r.
  destruct s; injection Q as -> ->; auto.
Qed.
Lemma least_sound g s equation branches : Forall proves branches ->
  least S T K F prove p g s equation branches = true -> holds S v g.
Proof.
  unfold least. intros P.
  destruct (extremum _ _ _ _ _ _ _ _) as [[[m l] o]|] eqn:X; try discriminate. intros E.
  split_and E. apply extremum_sound in X. destruct X as (t & Q & Dt & Do & _ & (e & I & V)).
  apply paired_sound with (Q := fun e => holds S v (match s with
    | Left => Claim (relation_of g) e o | Right => Claim (relation_of g) o e end)) in A.
  - rewrite Forall_forall in A. specialize (A _ I). destruct g as [r a b].
    destruct s; injection Q as -> ->; destruct A as (_ & _ & A); unfold holds, stands in *;
      cbn [lhs rhs relation_of] in *; rewrite V; auto.
  - revert P. apply Forall_impl. intros q M x Y. eapply M; eauto.
Qed.

(* --- root --- *)

Lemma root_sound g : root S T F p g = true -> holds S v g.
Proof.
  unfold root. destruct (PM.find (rhs g) T) as [[]|] eqn:E; try discriminate;
    try (destruct f; try discriminate); intros Q; split_and Q;
    destruct (is_zero_sound v _ Q) as [W D]; apply same_relation_sound in A0;
    apply (knows_sound v p here) in A; destruct A as (D' & Pos & Str); specialize (Str eq_refl);
    unfold holds, stands; rewrite A0, W, (value_is _ _ _ E), (defined_is _ _ _ E);
    cbn [related node_value applied subterms proviso in_domain In]; repeat split; trivial;
    try (intuition (subst; trivial)).
  - now apply sqrt_lt_R0.
  - now apply nth_root_positive.
Qed.

(* --- antisymmetry, angles, cosine, range, law and monotony --- *)

Lemma antisymmetry_sound g branches : Forall proves branches ->
  antisymmetry prove p g branches = true -> holds S v g.
Proof.
  unfold antisymmetry. intros P E. split_and E. apply same_relation_sound in E.
  apply paired_sound with (Q := holds S v) in A.
  - inversion A as [|? ? (D1 & D2 & L) A1]; subst. inversion A1 as [|? ? (_ & _ & G) _]; subst.
    unfold holds, stands in *. rewrite E. cbn [relation_of lhs rhs related] in *.
    split; [trivial | split; [trivial | now apply Rle_antisym]].
  - revert P. apply Forall_impl. intros q M x Y. eapply M; eauto.
Qed.
Lemma angles_right g : angles T K (knows S T F p) (has_value S F p) g = true -> holds S v g.
Proof.
  exact (angles_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) g).
Qed.
Lemma cosine_right g : cosine T K (knows S T F p) (has_value S F p) g = true -> holds S v g.
Proof.
  exact (cosine_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) g).
Qed.

Lemma range_right g : range T K (knows S T F p) (has_value S F p) g = true -> holds S v g.
Proof.
  exact (range_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) g).
Qed.
Lemma law_right g : law T K (knows S T F p) (has_value S F p) g = true -> holds S v g.
Proof.
  exact (law_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) g).
Qed.
Lemma monotony_sound g under premise : proves premise ->
  monotony S T K F prove p g under premise = true -> holds S v g.
Proof.
  unfold monotony. intros P E. split_and E. apply (clears_sound v p here) in E.
  inversion_clear E as [|? ? L E']. inversion_clear E' as [|? ? R _].
  destruct (below T K under g) as [h|] eqn:B; try discriminate.
  apply (below_sound S T found K v under g h B L R). exact (P _ _ A v here).
Qed.

(* --- sum --- *)

Lemma replacing_sound l : forall m m1,
  (forall i j, PM.find i m = Some j -> defined_at S v i /\ value_at S v i = value_at S v j) ->
  replacing S T F p l m = Some m1 ->
  forall i j, PM.find i m1 = Some j -> defined_at S v i /\ value_at S v i = value_at S v j.
Proof.
  induction l as [|f l IH]; cbn [replacing]; intros m m1 R E; [now injection E as <-|].
  bind E g G. destruct (_ && _) eqn:Q; try discriminate.
  destruct (PM.find (lhs g) m) eqn:N0; try discriminate. refine (IH _ _ _ E). clear IH E.
  split_and Q. apply same_relation_sound in Q. apply (fact_at_sound v p here) in G.
  destruct G as (D & _ & G). unfold stands in G. rewrite Q in G.
  intros i j X. apply find_add in X. destruct X as [[-> <-]|X]; auto.
Qed.
Section Replaced.
Variable m : PM.t positive.
Hypothesis replaced : forall i j, PM.find i m = Some j ->
  defined_at S v i /\ value_at S v i = value_at S v j.
Let clear_here := clear_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) m replaced.
Let difference_here := difference_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) m replaced.
Notation poly := (at_values (value_at S v)).
Lemma zeros_sound l : forall s z s1, sound S v s -> zeros S T K F p m s l = Some (z, s1) ->
  sound S v s1 /\ poly z = 0.
Proof.
  induction l as [|[f c] l IH]; cbn [zeros]; intros s z s1 Q E.
  - injection E as <- <-. auto.
  - bind E g G. destruct (same_relation _ _) eqn:R; try discriminate.
    bind E x X. destruct x as [x s2]. bind E d D. destruct d as [d s3].
    bind E y Y. destruct y as [y s4]. injection E as <- <-.
    apply clear_here in X; trivial. destruct X as [Q2 _].
    apply difference_here in D; trivial. destruct D as (Q3 & _ & _ & k & _ & V).
    apply IH in Y; trivial. destruct Y as [Q4 Y]. split; trivial.
    apply (fact_at_sound v p here) in G. destruct G as (_ & _ & G). unfold stands in G.
    apply same_relation_sound in R. rewrite R in G. cbn [related] in G.
    rewrite plus_value, times_value, V, Y, G. ring.
Qed.
End Replaced.
Lemma sum_sound g replacements addends equations :
  sum S T K F p g replacements addends equations = true -> holds S v g.
Proof.
  unfold sum. intros E. destruct (replacing _ _ _ _ _ _) as [m|] eqn:M; try discriminate.
  pose proof (replacing_sound _ _ _ (none_replaced v) M) as R. clear M.
  destruct (difference _ _ _ _ _ _ _ _) as [[goal s1]|] eqn:G; try discriminate.
  apply (difference_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) m R) in G; [|apply nothing_sound].
  destruct G as (Q1 & Dl & Dr & k & Pos & V).
  destruct (zeros _ _ _ _ _ _ _ _) as [[z s2]|] eqn:Zs; try discriminate.
  apply (zeros_sound m R) in Zs; trivial. destruct Zs as [Q2 Zs].
  split; [trivial|]. split; [trivial|]. unfold stands.
  assert (N0 : forall strict, is_signed S v (goal, strict) ->
    match addend_value T K (knows S T F p) (has_value S F p) m (fact_at S F p)
      (goal, strict) (Sum addends) s2 with
    | Some ((q, st), s3) => vanishes s3 (plus q z) && st
    | None => false
    end = false).
  { intros strict Sg. clear E.
    destruct (addend_value _ _ _ _ _ _ _ _ _) as [[[q st] s3]|] eqn:A; trivial.
    apply (addend_value_sound S T found K v (knows S T F p) (has_value S F p)
    (usable_right v p here) m R (fact_at S F p)
      (fact_at_sound v p here) _ Sg) in A; trivial.
    destruct A as [Q3 [A B]]. cbn [fst snd] in *.
    destruct st; [|apply andb_false_r]. rewrite andb_true_r. specialize (B eq_refl).
    destruct (vanishes s3 (plus q z)) eqn:W; trivial.
    apply (vanishes_sound S v) in W; trivial. rewrite plus_value, Zs in W. lra. }
  destruct (relation_of g) eqn:Rel; cbn [same_relation related] in *.
  - destruct (Rlt_le_dec (value_at S v (lhs g)) (value_at S v (rhs g))) as [L|L]; trivial.
    rewrite N0 in E; [discriminate|]. split; cbn [fst snd]; [|discriminate]. rewrite V.
    apply Rmult_le_pos; lra.
  - destruct (Rle_lt_dec (value_at S v (lhs g)) (value_at S v (rhs g))) as [L|L]; trivial.
    rewrite N0 in E; [discriminate|]. unfold is_signed. cbn [fst snd]. rewrite V.
    assert (0 < k * (value_at S v (lhs g) - value_at S v (rhs g)))
      by (apply Rmult_lt_0_compat; lra).
    split; [lra | trivial].
  - destruct addends; try discriminate. apply (vanishes_sound S v) in E; trivial.
    rewrite minus_value, V, Zs in E.
    assert (W : k * (value_at S v (lhs g) - value_at S v (rhs g)) = 0) by lra.
    apply Rmult_integral in W. lra.
  - discriminate.
Qed.

(* --- instance --- *)

Section Put.
Variable c : nat.
Variable at_ : substitution.
Hypothesis not_root : (0 < c)%nat.
Hypothesis own : of_context T c at_ = true.
Hypothesis values_defined : all_defined S v at_.
Lemma givens_hold_sound l premises : Forall proves premises ->
  givens_hold S T K H F prove p c at_ (phi_of S T K H c at_) l premises = true ->
  satisfies S (after S v at_) l.
Proof.
  unfold givens_hold. intros P E. split_and E.
  apply paired_sound with
    (Q := fun a => stands S (after S v at_) (given_claim a)) in A; trivial.
  revert P. apply Forall_impl. intros q M x Y.
  destruct (substituted _ _ _ _ _) as [h|] eqn:X; try discriminate.
  apply (substituted_sound v c at_ not_root own values_defined) in X. apply X. eapply M; eauto.
Qed.
End Put.
Lemma givens_hold_defined c at_ phi l premises :
  givens_hold S T K H F prove p c at_ phi l premises = true ->
  (0 < c)%nat /\ of_context T c at_ = true /\ all_defined S v at_.
Proof.
  unfold givens_hold. intros E. split_and E. apply negb_true_iff, Nat.eqb_neq in E.
  split; [lia|]. split; trivial. apply (clears_sound v p here) in A0.
  unfold all_defined. now rewrite Forall_map in A0.
Qed.
Lemma instance_sound g of at_ premises : Forall proves premises ->
  instance S T K H F prove p g of at_ premises = true -> holds S v g.
Proof.
  unfold instance. intros P E. destruct (PM.find of (named F)) as [[c f]|] eqn:N0; try discriminate.
  split_and E. destruct (givens_hold_defined _ _ _ _ _ A0) as (C & O & D).
  apply (givens_hold_sound c at_ C O D) in A0; trivial.
  destruct (substituted _ _ _ _ _) as [h|] eqn:X; try discriminate.
  apply same_claim_sound in A. subst h. apply (substituted_sound v c at_ C O D) in X. apply X.
  apply (proj1 valid_facts _ _ _ N0).
  apply scope_after; trivial. unfold in_parent in E. now apply (inside_scope v p here).
Qed.
End Inner.
End AtPlace.

Notation prove := (prove S T K H F grounds).
Lemma prove_step p g q : prove p g q = match q with
  | Given_ f => match fact_at S F p f with Some h => same_claim h g | None => false end
  | Interval bits bounds => interval S T H F grounds p g bits bounds
  | Cuts t points branches => cuts S T K F prove p g t points branches
  | Cases t branches => cases S T K F prove p g t branches
  | Entry s e => entry S T K F p g s e
  | Least s e branches => least S T K F prove p g s e branches
  | PositiveRoot => root S T F p g
  | Antisymmetry branches => antisymmetry prove p g branches
  | Angles => angles T K (knows S T F p) (has_value S F p) g
  | Cosine_ => cosine T K (knows S T F p) (has_value S F p) g
  | Range => range T K (knows S T F p) (has_value S F p) g
  | Law => law T K (knows S T F p) (has_value S F p) g
  | Monotony under premise => monotony S T K F prove p g under premise
  | BySum u a e => sum S T K F p g u a e
  | Instance f s premises => instance S T K H F prove p g f s premises
  end.
Proof. destruct q; reflexivity. Qed.

Theorem prove_sound q : forall p g, prove p g q = true -> forall v, satisfied S v p -> holds S v g.
Proof.
  induction q using proof_induction; intros p g E v here; rewrite prove_step in E.
  - destruct (fact_at S F p f) as [h|] eqn:X; try discriminate.
    apply same_claim_sound in E. subst h. exact (fact_at_sound v p here _ _ X).
  - exact (interval_sound S T H ready F valid_facts grounds good_grounds v p here _ _ _ E).
  - exact (cuts_sound v p here prove _ _ _ _ H0 E).
  - exact (cases_sound v p here prove _ _ _ H0 E).
  - exact (entry_sound v p here _ _ _ E).
  - exact (least_sound v p here prove _ _ _ _ H0 E).
  - exact (root_sound v p here prove _ E).
  - exact (antisymmetry_sound v p here prove _ _ H0 E).
  - exact (angles_right v p here _ E).
  - exact (cosine_right v p here _ E).
  - exact (range_right v p here _ E).
  - exact (law_right v p here _ E).
  - exact (monotony_sound v p here prove _ _ _ IHq E).
  - exact (sum_sound v p here _ _ _ _ E).
  - exact (instance_sound v p here prove _ _ _ _ H0 E).
Qed.
End Sound.
