(* The theorem about the checker: if it accepts a certificate, the statement is true. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool Arith FMapPositive.
From Verify Require Import Meaning Polynomials Terms Substitution Clearing Enclosures Kernel Places Sound Checker.
Import ListNotations.
Open Scope R_scope.

Section Accepted.
Variable S : statement.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable H : PM.t nat.
Hypothesis ready : prepared S T H.
Let found := found S T H ready.
Let parents_first := parents_first S T H ready.
Variable grounds : list (positive * memory).
Hypothesis good_grounds : all_remembered S grounds.
Notation prove F := (prove S T K H F grounds).
Notation at_context c := (no_hypotheses c).
Notation valid := (valid S).

Lemma satisfied_here c v : scope S c v -> satisfied S v (at_context c).
Proof. split; [assumption | constructor]. Qed.
Lemma prove_fact F c g q : valid F -> prove F (at_context c) g q = true -> fact S c g.
Proof.
  intros V P v I. eapply prove_sound; eauto. now apply satisfied_here.
Qed.
Lemma all_prove F : valid F -> forall l, Forall (proves S (prove F)) l.
Proof.
  intros V l. apply Forall_forall. intros q _ p g E v I. eapply prove_sound; eauto.
Qed.
Lemma pushed_in t c m u l d : PM.find u (pushed t c m) = Some l -> In d l ->
  (u = t /\ d = c) \/ exists l', PM.find u m = Some l' /\ In d l'.
Proof.
  unfold pushed. intros E I. apply find_add in E. destruct E as [[-> <-]|E]; [|eauto].
  destruct (PM.find t m) as [l'|]; destruct I as [<-|I]; eauto. destruct I.
Qed.
Lemma install_valid name c g F : valid F -> fact S c g -> valid (install T name c g F).
Proof.
  intros (A & B & C & D) G. unfold install. split; [|split; [|split]]; cbn [named positives nonnegatives having_values].
  - intros f d h E. apply find_add in E. destruct E as [[_ E]|E]; [|eauto]. injection E as <- <-.
    exact G.
  - destruct (is_zero T (lhs g) && _) eqn:Z0; [|apply B]. intros t l d E I v V.
    apply (pushed_in _ _ _ _ _ _ E) in I. destruct I as [[-> ->]|(l' & E' & I)]; [|eapply B; eauto].
    split_and Z0. destruct (G v V) as (_ & W & R). split; trivial. unfold stands in R.
    apply same_relation_sound in A0. rewrite A0 in R.
    destruct (is_zero_sound S T H ready v _ Z0) as [X _]. now rewrite X in R.
  - destruct (is_zero T (lhs g) && _) eqn:Z0; [|apply C]. intros t l d E I v V.
    apply (pushed_in _ _ _ _ _ _ E) in I. destruct I as [[-> ->]|(l' & E' & I)]; [|eapply C; eauto].
    split_and Z0. destruct (G v V) as (_ & W & R). split; trivial. unfold stands in R.
    apply same_relation_sound in A0. rewrite A0 in R.
    destruct (is_zero_sound S T H ready v _ Z0) as [X _]. now rewrite X in R.
  - exact D.
Qed.
Lemma with_value_valid c i F : valid F -> (forall v, scope S c v -> defined_at S v i) ->
  valid (with_value c i F).
Proof.
  intros (A & B & C & D) G. split; [|split; [|split]]; trivial. cbn [having_values with_value].
  intros j d E. apply find_add in E. destruct E as [[-> <-]|E]; eauto.
Qed.
Lemma no_facts_valid : valid no_facts.
Proof.
  split; [|split; [|split]]; cbn [named positives nonnegatives having_values no_facts].
  - intros f c g E. now rewrite PM.gempty in E.
  - intros t l c E. now rewrite PM.gempty in E.
  - intros t l c E. now rewrite PM.gempty in E.
  - intros i c E. now rewrite PM.gempty in E.
Qed.

(* --- the rules with whole steps of their own --- *)

Lemma holds_after_sound F c d at_ l premises v : valid F ->
  holds_after S T K H grounds F (at_context c) d at_ l premises = true -> scope S c v ->
  (0 < d)%nat /\ of_context T d at_ = true /\ all_defined S v at_ /\
  satisfies S (after S v at_) l.
Proof.
  intros V E I. unfold holds_after in E. apply satisfied_here in I.
  pose proof E as E'. apply (givens_hold_defined S T K H ready F V v _ I) in E'.
  destruct E' as (A & B & C). repeat split; trivial.
  exact (givens_hold_sound S T K H ready F v _ I _ d at_
    A B C l premises (all_prove F V premises) E).
Qed.
Lemma applies_sound F c d at_ premises : valid F ->
  applies S T K H grounds F c d at_ premises = true -> says S c (Applies d at_).
Proof.
  unfold applies. intros V E v I. split_and E.
  destruct (holds_after_sound _ _ _ _ _ _ v V A I) as (P & O & D & G). split; trivial.
  apply (scope_after S T H ready); trivial.
  apply is_inside_sound in E. eapply scope_within; eauto.
Qed.
Lemma kinds v l : satisfies S v (filter is_carried l) ->
  satisfies S v (filter (fun a => match given_kind a with Standing => true | _ => false end) l) ->
  existsb is_plain l = false -> satisfies S v l.
Proof.
  unfold satisfies. rewrite !Forall_forall. intros A B P a I.
  destruct (given_kind a) eqn:E.
  - assert (Q : existsb is_plain l = true); [|congruence].
    apply existsb_exists. exists a. unfold is_plain. now rewrite E.
  - apply A, filter_In. unfold is_carried. now rewrite E.
  - apply B, filter_In. now rewrite E.
Qed.
Lemma induction_sound F c d start next first later : valid F ->
  induction S T K H grounds F c d start next first later = true -> says S c (Always d start next).
Proof.
  unfold induction. intros V E v I. split_and E. apply Nat.eqb_eq in E. subst c.
  apply negb_true_iff in A1.
  destruct (holds_after_sound _ _ _ _ _ _ v V A0 I) as (P & O & D & G). split; trivial.
  assert (W : forall n, (forall k, (k <= n)%nat ->
    satisfies S (Meaning.state S v start next k) (standing S d)) ->
    scope S d (Meaning.state S v start next n)).
  { induction n as [|n IH]; intros Q; cbn [Meaning.state].
    - apply (scope_after S T H ready); trivial.
      apply kinds; trivial. apply (Q 0%nat). lia.
    - assert (J : scope S d (Meaning.state S v start next n)) by (apply IH; intros; apply Q; lia).
      destruct (holds_after_sound _ _ _ _ _ _ _ V A J) as (_ & O' & _ & G').
      apply (scope_after S T H ready); trivial.
      + intros k X. apply J. rewrite (around_step S parents_first d P). now right.
      + apply kinds; trivial. apply (Q (Datatypes.S n)). lia. }
  intros n Q. specialize (W n Q). split; trivial.
  now destruct (holds_after_sound _ _ _ _ _ _ _ V A W) as (_ & _ & D' & _).
Qed.
Lemma negated_sound v g : holds S v (negated g) -> fails S v g.
Proof.
  destruct g as [r a b]. unfold holds, fails, stands, negated. cbn [lhs rhs relation_of].
  intros (A & B & C). repeat split; trivial. destruct r; cbn [related] in *; lra.
Qed.
Definition inhabited (c : nat) : Prop := exists v, scope S c v.
Lemma root_inhabited : inhabited 0.
Proof. exists (fun _ => 0). intros k [<-|[]]. constructor. Qed.
Definition all_inhabited (s : state) : Prop := forall c, In c (opened s) -> inhabited c.
Lemma is_open_sound s c : all_inhabited s -> is_open s c = true -> inhabited c.
Proof.
  intros A E. apply orb_prop in E. destruct E as [E|E].
  - apply Nat.eqb_eq in E. subst. apply root_inhabited.
  - apply existsb_exists in E. destruct E as (d & I & E). apply Nat.eqb_eq in E. subst. auto.
Qed.
Lemma witness_sound s c g at_ premises negation : valid (known s) -> all_inhabited s ->
  witness S T K H grounds s c g at_ premises negation = true ->
  exists v, scope S c v /\ fails S v g.
Proof.
  unfold witness. intros V In_ E. split_and E. destruct (is_open_sound _ _ In_ E) as [v I].
  destruct (holds_after_sound _ _ _ _ _ _ v V A0 I) as (P & O & D & G).
  destruct (substituted _ _ _ _ _) as [h|] eqn:X; try discriminate.
  exists (after S v at_). split.
  - apply (scope_after S T H ready); trivial.
  - pose proof (prove_fact _ _ _ _ V A v I) as N0. apply negated_sound in N0.
    unfold fails, holds in *.
    destruct (substituted_sound S T K H ready v c at_ P O D
      _ _ X) as [Y1 Y2].
    pose proof X as X'. unfold substituted in X'. bind X' a Ha. bind X' b Hb. injection X' as <-.
    apply (new_term_sound S H T ready c at_ v O P) in Ha, Hb;
      try (apply (phi_sound S T K H ready v c at_ P O D)).
    destruct Ha as [_ Ha], Hb as [_ Hb]. cbn [lhs rhs] in N0. rewrite Ha, Hb, Y1. tauto.
Qed.
Lemma define_sound F c t d : valid F -> define S T K H grounds F (at_context c) t d = true ->
  forall v, scope S c v -> defined_at S v t.
Proof.
  unfold define. intros V E v I. apply satisfied_here in I. destruct d as [|bits bounds].
  - apply (clears_sound S T K H ready F V v _ I) in E. now inversion E.
  - destruct (enclosing _ _ _ _ _ _ _ _) as [m|] eqn:X; try discriminate.
    apply (enclosing_sound S T H ready F V v _ I) in X;
      [|now apply ground_sound].
    destruct (enclose _ _ _ _ _) as [[x m1]|] eqn:Y; try discriminate.
    eapply enclose_sound in Y; eauto. apply Y.
Qed.
Lemma open_givens_sound c at_ v : (0 < c)%nat -> of_context T c at_ = true ->
  scope S (parent_of S c) v -> all_defined S v at_ ->
  forall l premises F F', valid F -> incl l (givens_of S c) ->
  open_givens S T K H grounds c at_ (phi_of S T K H c at_) F l premises = Some F' ->
  (forall w, scope S c w -> Forall (fun a => holds S w (given_claim a)) l) /\ valid F' /\
  satisfies S (after S v at_) l.
Proof.
  intros P O I D. induction l as [|a l IH]; intros [|q premises] F F' V In_; cbn [open_givens];
    try discriminate; intros E.
  - injection E as <-. split; [intros w _; constructor | split; [trivial | constructor]].
  - bind E h X. destruct (_ && _) eqn:Y; try discriminate. split_and Y.
    assert (G : fact S c (given_claim a)).
    { intros w W. pose proof (satisfied_here _ _ W) as W'.
      apply (clears_sound S T K H ready F V w _ W') in A.
      inversion_clear A as [|? ? D1 A1]. inversion_clear A1 as [|? ? D2 _].
      repeat split; trivial. specialize (W c (around_self S parents_first c)).
      unfold satisfies in W. rewrite Forall_forall in W. apply W, In_. now left. }
    apply IH in E; [|now apply install_valid | intros x J; apply In_; now right].
    destruct E as (E1 & E2 & E3). split; [|split]; trivial.
    + intros w W. constructor; auto.
    + constructor; trivial. pose proof (prove_fact _ _ _ _ V Y v I) as (_ & _ & St).
      exact (proj2 (proj1 (substituted_sound S T K H ready
        v c at_ P O D _ _ X)) St).
Qed.

(* --- steps --- *)

Variable rows_by_number : PM.t row.
(* What is true after some steps. *)
Record true_so_far (s : state) : Prop := {
  true_facts : valid (known s);
  true_contexts : forall c, In c (opened s) -> context_good S c;
  true_constants : forall i, PM.find i (done_constants s) <> None ->
    exists c a, PM.find i T = Some (NConstant c a) /\ forall v, scope S c v -> defined_at S v a;
  true_rows : forall k r, PM.find k (done_rows s) <> None -> PM.find k rows_by_number = Some r ->
    row_true S r
}.
Lemma added_to {A} (i j : positive) (x : A) m : PM.find i (PM.add j x m) <> None ->
  i = j \/ PM.find i m <> None.
Proof.
  destruct (Pos.eq_dec i j); [auto|]. rewrite PM.gso by assumption. auto.
Qed.
Lemma obligation_sound s r q F : valid (known s) -> all_inhabited s -> inhabited (row_context r) ->
  obligation S T K H grounds s r q = Some F -> valid F /\ row_true S r.
Proof.
  unfold obligation, row_true. intros V In_ W E.
  destruct (row_sentence r) as [g|d at_|d start next], (row_verdict r), q;
    try discriminate; destruct (_ && _) eqn:Y in E || destruct (_ : bool) eqn:Y in E;
    try discriminate; injection E as <-; try split_and Y.
  - apply prove_fact in A; trivial. split; [now apply install_valid | exact A].
  - apply prove_fact in A; trivial. split; trivial. destruct W as [v W].
    exists v. split; trivial. now apply negated_sound, A.
  - apply witness_sound in A; auto.
  - split; trivial. eapply applies_sound; eauto.
  - split; trivial. eapply induction_sound; eauto.
Qed.
Lemma is_open_here s c : true_so_far s -> is_open s c = true -> inhabited c.
Proof.
  intros [_ C _ _]. apply is_open_sound. intros d I. apply (C d I).
Qed.
Lemma take_sound s x s1 : true_so_far s ->
  take S T K H rows_by_number grounds s x = Some s1 -> true_so_far s1.
Proof.
  intros Q E. pose proof Q as [V C D R].
  assert (I : all_inhabited s) by (intros d J; apply (C d J)).
  destruct x as [c premises|name c g q|name i d|k q]; cbn [take] in E.
  - destruct (_ && _) eqn:Y in E; try discriminate. bind E F X. injection E as <-. split_and Y.
    apply negb_true_iff, Nat.eqb_neq in A2.
    destruct (is_open_here _ _ Q Y) as [v W].
    apply (clears_sound S T K H ready _ V v _ (satisfied_here _ _ W)) in A.
    rewrite Forall_map in A. assert (P : (0 < c)%nat) by lia.
    apply (open_givens_sound c (point_of S c) v P A0 W A _ _ _ _ V (incl_refl _)) in X.
    destruct X as (X1 & X2 & X3). split; trivial. cbn [opened]. intros d [<-|J]; [|now apply C].
    split; trivial. exists (after S v (point_of S c)).
    apply (scope_after S T H ready); trivial.
  - destruct (_ && _) eqn:Y in E; try discriminate. injection E as <-. split_and Y.
    apply prove_fact in A; trivial. split; trivial. now apply install_valid.
  - destruct (PM.find i T) as [[]|] eqn:N0; try discriminate.
    destruct (_ && _) eqn:Y in E; try discriminate. injection E as <-. split_and Y.
    pose proof (define_sound _ _ _ _ V A) as G.
    assert (G' : forall v, scope S c v -> defined_at S v i).
    { intros v W. rewrite (defined_is S T found v _ _ N0). cbn [subterms proviso In].
      split; trivial. intros a [<-|[]]. now apply G. }
    split; trivial.
    + cbn [known]. apply install_valid; [now apply with_value_valid|]. intros v W.
      split; [now apply G'|]. split; [now apply G|]. unfold stands. cbn [relation_of lhs rhs related].
      now rewrite (value_is S T found v _ _ N0).
    + cbn [done_constants]. intros j J. apply added_to in J. destruct J as [->|J]; eauto.
  - bind E r M0. destruct (_ && _) eqn:Y in E; try discriminate. bind E F X. injection E as <-.
    split_and Y. apply obligation_sound in X; trivial; [|eapply is_open_here; eauto].
    destruct X as [X1 X2]. split; trivial. cbn [done_rows]. intros j r' J. apply added_to in J.
    destruct J as [->|J]; [|now apply R]. intros E. rewrite M0 in E. now injection E as <-.
Qed.
Lemma run_sound l : forall s s1, true_so_far s ->
  run S T K H rows_by_number grounds s l = Some s1 -> true_so_far s1.
Proof.
  induction l as [|x l IH]; cbn [run]; intros s s1 Q E; [now injection E as <-|].
  bind E s2 X. eapply IH; [|exact E]. eapply take_sound; eauto.
Qed.

(* --- what is cited --- *)

Hypothesis citations : citations_true S.
Lemma constant_node i : PM.find i T = nth_error (nodes S) (pred (Pos.to_nat i)).
Proof.
  rewrite (is_table S T found). unfold numbered. rewrite nth_listed by lia. f_equal.
  change (Pos.to_nat 1) with 1%nat. lia.
Qed.
Lemma constant_defined_node i : constant_defined S i ->
  exists c a, PM.find i T = Some (NConstant c a) /\ forall v, scope S c v -> defined_at S v a.
Proof.
  unfold constant_defined. destruct (nth_error _ _) as [[]|] eqn:E; try tauto. intros D.
  rewrite <- constant_node in E. eauto.
Qed.
Lemma initial_true : true_so_far (initial S T).
Proof.
  destruct citations as (A & B & C). split; cbn [known opened done_rows done_constants initial].
  - assert (V : valid (citing T (cited S) no_facts)).
    { clear - B ready. induction B as [|[n [c g]] l G B IH]; cbn [citing fold_right fst snd].
      - apply no_facts_valid.
      - now apply install_valid. }
    revert V. generalize (citing T (cited S) no_facts). intros F V.
    induction A as [|i l G A IH]; cbn [fold_right]; trivial. apply with_value_valid; trivial.
    apply constant_defined_node in G. destruct G as (c & a & E & G). unfold defining_context.
    rewrite E. intros v W. rewrite (defined_is S T found v _ _ E).
    cbn [subterms proviso In]. split; trivial. intros b [<-|[]]. now apply G.
  - intros c I. apply filter_In in I. destruct I as [I N0]. apply in_seq in I.
    destruct (C c ltac:(lia)) as [J|J]; trivial. apply negb_true_iff in N0.
    assert (Q : existsb (Nat.eqb c) (own_contexts S) = true); [|congruence].
    apply existsb_exists. exists c. now rewrite Nat.eqb_refl.
  - intros i X. now rewrite PM.gempty in X.
  - intros k r X. now rewrite PM.gempty in X.
Qed.
End Accepted.

Lemma ground_terms_sound S T H l : prepared S T H -> all_remembered S (ground_terms T l).
Proof.
  intros ready v. unfold ground_terms. apply Forall_map, Forall_forall. intros [bits ids] _. cbn [fst snd].
  assert (Z0 : remembered S v (PM.empty enclosure)) by (intros i x X; now rewrite PM.gempty in X).
  destruct (each _ _ ids) as [[xs m]|] eqn:E; trivial.
  apply (each_sound (remembered S v) (right S v)) in E; trivial; [tauto|].
  intros; eapply enclose_sound; eauto.
Qed.
Lemma well_formed_prepared S H : well_formed S H = true -> prepared S (table (numbered S)) H.
Proof.
  unfold well_formed. intros W. apply andb_prop in W. destruct W as [P W].
  apply andb_prop in P. destruct P as [P homes]. apply andb_prop in P. destruct P as [order parents].
  split; trivial; [now split|]. intros c a I. assert (B : In c (seq 1 (length (contexts S)))).
  { apply in_seq. unfold givens_of, context_at in I. destruct c as [|k]; [destruct I|].
    destruct (nth_error (contexts S) k) eqn:E; [|destruct I].
    assert (k < length (contexts S))%nat by (apply nth_error_Some; congruence). lia. }
  rewrite forallb_forall in W. specialize (W c B). rewrite forallb_forall in W. specialize (W a I).
  unfold in_scope in W. apply andb_prop in W. destruct W as [L R].
  split; now apply is_inside_sound.
Qed.

(* The theorem about the checker. *)
Theorem accepts_sound S C : accepts S C = true -> citations_true S -> true_statement S.
Proof.
  unfold accepts. intros E cites.
  apply andb_prop in E. destruct E as [E _]. apply andb_prop in E. destruct E as [W E].
  apply well_formed_prepared in W.
  set (T := table (numbered S)) in *. set (K := keys (numbered S)) in *.
  set (H := homes S) in *. set (grounds := ground_terms T (shared C)) in *.
  assert (G : all_remembered S grounds) by exact (ground_terms_sound S T H _ W).
  destruct (run _ _ _ _ _ _ _ _) as [s|] eqn:R; try discriminate.
  apply (run_sound S T K H W grounds G) in R;
    [|now apply (initial_true S T H W)].
  destruct R as [_ Cs Ds Rs]. unfold finished in E. apply andb_prop in E. destruct E as [E Needed].
  apply andb_prop in E. destruct E as [E Rows]. apply andb_prop in E. destruct E as [Open Defined].
  rewrite forallb_forall in *. unfold true_statement.
  split; [|split; [|split]]; apply Forall_forall.
  - intros i I. specialize (Defined i I).
    assert (M : PM.find i (done_constants s) <> None).
    { apply PM.mem_2 in Defined. destruct Defined as [u M]. apply PM.find_1 in M. congruence. }
    destruct (Ds i M) as (c & a & X & Y). unfold constant_defined.
    rewrite (constant_node S T H W) in X. now rewrite X.
  - intros c I. specialize (Open c I). apply existsb_exists in Open. destruct Open as (d & J & X).
    apply Nat.eqb_eq in X. subst d. now apply Cs.
  - intros r I. destruct (in_listed _ _ I 1%positive) as [k J]. specialize (Rows _ J).
    apply orb_prop in Rows. cbn [fst snd] in Rows. destruct Rows as [D|D].
    + unfold decided in D. unfold row_true. destruct (row_verdict r); try discriminate. exact Logic.I.
    + apply (Rs k r); [|now apply listed_find]. apply PM.mem_2 in D. destruct D as [u D].
      apply PM.find_1 in D. congruence.
  - intros r I N. specialize (Needed r I). rewrite N in Needed. cbn in Needed.
    destruct (row_verdict r); trivial; discriminate.
Qed.
(* And about the enclosures that it accepts. *)
Theorem enclosures_sound S C : accepts S C = true -> forall v,
  Forall (fun e => defined_at S v (enclosed e) /\ Q2R (low e) <= value_at S v (enclosed e) <= Q2R (high e))
    (enclosures C).
Proof.
  unfold accepts. intros E v. apply andb_prop in E. destruct E as [E R].
  apply andb_prop in E. destruct E as [W _]. apply well_formed_prepared in W.
  apply Forall_forall. intros e I. rewrite forallb_forall in R. specialize (R e I).
  apply at_some_precision_sound in R. destruct R as [bits R]. unfold right_ends_at in R.
  destruct (enclose _ _ _ _ _) as [[x m]|] eqn:X; try discriminate.
  apply andb_prop in R. destruct R as [L U].
  eapply (enclose_sound S _ _ W v) in X.
  - destruct X as [_ [D X]]. split; trivial.
    split; [eapply (decide_sound _ AtMost (Exact (low e))) in L |
            eapply (decide_sound _ AtMost x (Exact (high e))) in U]; eauto; try reflexivity;
      try exact L; try exact U.
  - apply ground_sound, (ground_terms_sound _ _ _ _ W).
Qed.
(* A statement that cites nothing needs nothing. *)
Definition cites_nothing (S : statement) : bool :=
  match cited S, cited_constants S with [], [] => true | _, _ => false end &&
  forallb (fun c => existsb (Nat.eqb c) (own_contexts S)) (seq 1 (length (contexts S))).
Lemma no_citations S : cites_nothing S = true -> citations_true S.
Proof.
  unfold cites_nothing, citations_true. destruct (cited S), (cited_constants S); try discriminate.
  cbn [andb]. intros E. split; [constructor|]. split; [constructor|]. intros c B. left.
  rewrite forallb_forall in E. specialize (E c). rewrite in_seq in E.
  specialize (E ltac:(lia)). apply existsb_exists in E. destruct E as (d & I & X).
  apply Nat.eqb_eq in X. now subst d.
Qed.
