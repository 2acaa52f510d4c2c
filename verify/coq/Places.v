(* At a place in a proof: what is found there of facts, clearings and enclosures is true for all values
   that satisfy what is in scope. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool Arith FMapPositive.
From Verify Require Import Meaning Polynomials Terms Substitution Clearing Cleared Enclosures Functions Cosines Kernel.
Import ListNotations.
Open Scope R_scope.

Ltac split_and H := repeat match type of H with
  | _ && _ = true => let A := fresh "A" in apply andb_prop in H; destruct H as [H A]; split_and A
  end.

Lemma at_some_precision_sound f bits : at_some_precision f bits = true -> exists b, f b = true.
Proof.
  unfold at_some_precision. destruct (Pos.ltb 128 bits); intros E; [|eauto].
  apply orb_prop in E. destruct E; eauto.
Qed.
Lemma same_relation_sound r s : same_relation r s = true -> r = s.
Proof. destruct r, s; try discriminate; reflexivity. Qed.

Section Places.
Variable S : statement.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable H : PM.t nat.
Hypothesis ready : prepared S T H.
Let found := found S T H ready.
Let in_order := in_order S T found.
Let is_table := is_table S T found.
Let parents_first := parents_first S T H ready.
Let good_homes := good_homes S T H ready.
Notation home := (home_in H).

(* The values satisfy the givens in scope, and the hypotheses of the branches around hold. *)
Definition satisfied (v : valuation) (p : place) : Prop :=
  scope S (fst p) v /\ Forall (holds S v) (snd p).
(* All facts are true. *)
Definition valid (F : facts) : Prop :=
  (forall f c g, PM.find f (named F) = Some (c, g) -> fact S c g) /\
  (forall t l c, PM.find t (positives F) = Some l -> In c l ->
    forall v, scope S c v -> defined_at S v t /\ 0 < value_at S v t) /\
  (forall t l c, PM.find t (nonnegatives F) = Some l -> In c l ->
    forall v, scope S c v -> defined_at S v t /\ 0 <= value_at S v t) /\
  (forall i c, PM.find i (having_values F) = Some c -> forall v, scope S c v -> defined_at S v i).
Definition remembered (v : valuation) (m : memory) : Prop :=
  forall i x, PM.find i m = Some x -> defined_at S v i /\ encloses x (value_at S v i).
Definition all_remembered (grounds : list (positive * memory)) : Prop :=
  forall v, Forall (fun x => remembered v (snd x)) grounds.

(* What is put for the variables of a context leaves the givens around it true. *)
Lemma given_same v w c a : In a (givens_of S c) -> agree S c v w ->
  stands S v (given_claim a) -> stands S w (given_claim a).
Proof.
  intros I A. destruct (givens_home S T H ready _ _ I) as [L R]. unfold stands.
  destruct (home_value S in_order parents_first H good_homes v w _
    (agree_within S parents_first _ _ _ _ L A)) as [-> _].
  destruct (home_value S in_order parents_first H good_homes v w _
    (agree_within S parents_first _ _ _ _ R A)) as [-> _].
  trivial.
Qed.
Lemma scope_after v c at_ : (0 < c)%nat -> of_context T c at_ = true ->
  scope S (parent_of S c) v -> satisfies S (after S v at_) (givens_of S c) ->
  scope S c (after S v at_).
Proof.
  intros C O P G k I. rewrite (around_step S parents_first c C) in I.
  destruct I as [<-|I]; trivial. specialize (P k I). unfold satisfies in *.
  rewrite Forall_forall in *. intros a J. apply given_same with (v := v) (c := k); auto.
  intros x d X D. unfold after. destruct (put at_ x) as [t|] eqn:E; trivial.
  apply put_sound in E. unfold of_context in O. rewrite forallb_forall in O.
  specialize (O _ E). cbn [fst] in O. rewrite is_table, X in O. apply Nat.eqb_eq in O. subst d.
  pose proof (parent_below S parents_first c C).
  apply (around_at_most S parents_first) in D, I. lia.
Qed.

Let value_is := value_is S T found.
Let defined_is := defined_is S T found.
Lemma is_zero_sound v i : is_zero T i = true -> value_at S v i = 0 /\ defined_at S v i.
Proof.
  unfold is_zero. destruct (PM.find i T) as [n|] eqn:E; try discriminate.
  destruct n as [[] d| | | | | | | | | | | | | | |]; try discriminate.
  intros _. rewrite (value_is _ _ _ E), (defined_is _ _ _ E). cbn. split; [unfold Rdiv; ring | tauto].
Qed.

Lemma phi_sound v c at_ : (0 < c)%nat -> of_context T c at_ = true -> all_defined S v at_ ->
  all_replaced S at_ v (phi_of S T K H c at_).
Proof.
  intros C O D. unfold phi_of. apply (new_terms_sound S H T ready K c at_ v O D C).
  - intros i n I. now apply listed_find.
  - intros i j X. now rewrite PM.gempty in X.
Qed.
(* What is found for a claim at terms for variables says of these what the claim says. *)
Section Substituted.
Variable v : valuation.
Variable c : nat.
Variable at_ : substitution.
Hypothesis not_root : (0 < c)%nat.
Hypothesis own : of_context T c at_ = true.
Hypothesis values_defined : all_defined S v at_.
Lemma substituted_sound g h : substituted S H c (phi_of S T K H c at_) g = Some h ->
  (stands S (after S v at_) g <-> stands S v h) /\
  (holds S (after S v at_) g <-> holds S v h).
Proof.
  unfold substituted. intros E. bind E a A. bind E b B. injection E as <-.
  apply (new_term_sound S H T ready c at_ v own not_root) in A, B; try now apply phi_sound.
  destruct A as [A1 A2], B as [B1 B2]. unfold holds, stands. cbn [lhs rhs relation_of].
  rewrite A1, B1, A2, B2. tauto.
Qed.
End Substituted.

Section ValidFacts.
Variable F : facts.
Hypothesis valid_facts : valid F.
Variable grounds : list (positive * memory).
Hypothesis good_grounds : all_remembered grounds.

Section Place.
Variable v : valuation.
Variable p : place.
Hypothesis here : satisfied v p.

Lemma inside_scope c : is_inside S (fst p) c = true -> scope S c v.
Proof.
  intros I. apply is_inside_sound in I. eapply scope_within; eauto. apply here.
Qed.
Lemma fact_at_sound f g : fact_at S F p f = Some g -> holds S v g.
Proof.
  destruct f as [f|[|k]]; cbn [fact_at]; intros E.
  - bind E x X. destruct x as [c h]. destruct (is_inside S (fst p) c) eqn:I; try discriminate.
    injection E as <-. apply (proj1 valid_facts _ _ _ X). now apply inside_scope.
  - discriminate.
  - apply nth_error_In in E. destruct here as [_ A]. rewrite Forall_forall in A. auto.
Qed.
Lemma is_known_sound (Q : positive -> Prop) m t :
  (forall t l c, PM.find t m = Some l -> In c l -> scope S c v -> Q t) ->
  is_known S m p t = true -> Q t.
Proof.
  unfold is_known. intros V E. destruct (PM.find t m) as [l|] eqn:X; try discriminate.
  rewrite existsb_exists in E. destruct E as (c & I & J). eapply V; eauto. now apply inside_scope.
Qed.
Lemma knows_sound b t : knows S T F p b t = true ->
  defined_at S v t /\ 0 <= value_at S v t /\ (b = true -> 0 < value_at S v t).
Proof.
  unfold knows. intros E. apply orb_prop in E. destruct E as [E|E].
  - rewrite existsb_exists in E. destruct E as (g & I & E). split_and E.
    destruct here as [_ A1]. rewrite Forall_forall in A1. apply A1 in I.
    destruct I as (_ & D & I). unfold stands in I. apply Pos.eqb_eq in A0. rewrite A0 in D, I.
    destruct (is_zero_sound v _ E) as [W _]. rewrite W in I.
    apply same_relation_sound in A. rewrite A in I. destruct b; cbn [related] in I;
      repeat split; trivial; try lra; discriminate.
  - destruct valid_facts as (_ & Pos & Non & _). destruct b.
    + apply (is_known_sound (fun t => defined_at S v t /\ 0 < value_at S v t)) in E.
      * destruct E. repeat split; trivial. lra.
      * intros; eapply Pos; eauto.
    + apply (is_known_sound (fun t => defined_at S v t /\ 0 <= value_at S v t)) in E.
      * destruct E. repeat split; trivial. discriminate.
      * intros; eapply Non; eauto.
Qed.
Lemma knows_sign b t : knows S T F p b t = true ->
  0 <= value_at S v t /\ (b = true -> 0 < value_at S v t).
Proof. intros E. apply knows_sound in E. tauto. Qed.
Lemma has_value_sound i : has_value S F p i = true -> defined_at S v i.
Proof.
  unfold has_value. destruct (PM.find i (having_values F)) as [c|] eqn:E; try discriminate.
  intros I. eapply (proj2 (proj2 (proj2 valid_facts))); eauto. now apply inside_scope.
Qed.
Lemma usable_right : right_at S v (knows S T F p) (has_value S F p).
Proof. split; [exact knows_sign | exact has_value_sound]. Qed.
Lemma none_replaced i j : PM.find i (PM.empty positive) = Some j ->
  defined_at S v i /\ value_at S v i = value_at S v j.
Proof. now rewrite PM.gempty. Qed.
Lemma clears_sound l : clears S T K F p l = true -> Forall (defined_at S v) l.
Proof.
  unfold clears, clear_at. destruct (each _ _ l) as [[xs s]|] eqn:E; try discriminate. intros _.
  apply (each_sound (sound S v) (is_quotient S v)) in E.
  - destruct E as [_ E]. induction E as [|a x l xs A _ IH]; constructor; trivial. apply A.
  - intros s0 i x s1 _ Q C. eapply clear_sound in C; eauto.
    + exact usable_right.
    + exact none_replaced.
  - apply nothing_sound.
Qed.

(* --- interval --- *)

Lemma least_of v' l : forall a x xs, encloses x (value_at S v' a) ->
  Forall2 (fun b y => defined_at S v' b /\ encloses y (value_at S v' b)) l xs -> forall bits,
  encloses (fold_right (enclosed_min bits) x xs)
    (fold_right (fun b => Rmin (value_at S v' b)) (value_at S v' a) l).
Proof.
  intros a x xs X Q bits. induction Q as [|b y l xs [_ B] _ IH]; cbn [fold_right]; trivial.
  now apply min_sound.
Qed.
Lemma greatest_of v' l : forall a x xs, encloses x (value_at S v' a) ->
  Forall2 (fun b y => defined_at S v' b /\ encloses y (value_at S v' b)) l xs -> forall bits,
  encloses (fold_right (enclosed_max bits) x xs)
    (fold_right (fun b => Rmax (value_at S v' b)) (value_at S v' a) l).
Proof.
  intros a x xs X Q bits. induction Q as [|b y l xs [_ B] _ IH]; cbn [fold_right]; trivial.
  now apply max_sound.
Qed.
End Place.

Definition right (v : valuation) (i : positive) (x : enclosure) : Prop :=
  defined_at S v i /\ encloses x (value_at S v i).
Lemma operation_sound v bits i n xs x : PM.find i T = Some n ->
  Forall2 (right v) (subterms n) xs -> operation bits n xs = Some x -> right v i x.
Proof.
  intros E Q O.
  assert (D : forall a, In a (subterms n) -> defined_at S v a).
  { clear - Q. induction Q as [|a x l xs [A _] _ IH]; intros b; [intros [] | intros [<-|I]]; auto. }
  unfold right. rewrite (defined_is _ _ _ E), (value_is _ _ _ E).
  destruct n; cbn [subterms proviso node_value] in *;
    repeat match goal with
      | Q : Forall2 _ [] _ |- _ => inversion Q; clear Q; subst
      | Q : Forall2 _ (_ :: _) _ |- _ => inversion Q as [|? ? ? ? [? ?] ?]; clear Q; subst
      end; cbn [operation] in O; try discriminate.
  - injection O as <-. repeat split; trivial. apply (exact_encloses bits (Qmake n d)).
  - injection O as <-. auto.
  - injection O as <-. auto using add_sound.
  - injection O as <-. auto using sub_sound.
  - injection O as <-. auto using mul_sound.
  - eapply div_sound in O; eauto. tauto.
  - injection O as <-. auto using neg_sound.
  - injection O as <-. auto using power_sound.
  - eapply sqrt_sound in O; eauto. tauto.
  - injection O as <-. auto using least_of.
  - injection O as <-. auto using greatest_of.
  - injection O as <-. auto using cos_sound.
  - injection O as <-. auto using cos_pi_sound.
  - injection O as <-. split; [tauto|]. apply I.pi_correct.
  - eapply elementary_sound in O; eauto. tauto.
Qed.
Lemma enclose_sound v bits fuel : forall m i x m1, remembered v m ->
  enclose T bits fuel m i = Some (x, m1) -> remembered v m1 /\ right v i x.
Proof.
  induction fuel as [|fuel IH]; cbn [enclose]; intros m i x m1 R E;
    destruct (PM.find i m) as [y|] eqn:C; try discriminate;
    try (injection E as <- <-; split; trivial; now apply R).
  bind E n X. bind E y Y. destruct y as [xs m2]. bind E z W0. injection E as <- <-.
  apply (each_sound (remembered v) (right v)) in Y; [|intros; eapply IH; eauto | trivial].
  destruct Y as [R2 Y]. pose proof (operation_sound _ _ _ _ _ _ X Y W0) as W. split; trivial.
  intros j w J. apply find_add in J. destruct J as [[-> ->]|J]; [exact W | now apply R2].
Qed.

Section Again.
Variable v : valuation.
Variable p : place.
Hypothesis here : satisfied v p.

Lemma ground_sound bits : remembered v (ground grounds bits).
Proof.
  unfold ground. destruct (find _ grounds) as [x|] eqn:E.
  - apply find_some in E. destruct E as [E _]. pose proof (good_grounds v) as G.
    rewrite Forall_forall in G. now apply G.
  - intros i x. now rewrite PM.gempty.
Qed.
Lemma bounding_sound s name g t : bounding s name g = Some t -> holds S v g ->
  defined_at S v name /\
  match s with
  | Left => value_at S v t <= value_at S v name
  | Right => value_at S v name <= value_at S v t
  end.
Proof.
  destruct g as [r a b]. intros E (A & B & C). unfold stands in C.
  cbn [lhs rhs relation_of] in *. unfold bounding in E.
  destruct s, r; cbn [lhs rhs relation_of related] in *; try discriminate;
    repeat match type of E with
      | (if Pos.eqb ?x ?y then _ else _) = _ => destruct (Pos.eqb_spec x y); try discriminate
      end; injection E as <-; subst; split; trivial; lra.
Qed.
Lemma with_bound_sound bits m b m1 : remembered v m ->
  with_bound S T H F bits p m b = Some m1 -> remembered v m1.
Proof.
  unfold with_bound. intros R E. destruct (PM.find (bound_name b) m); try discriminate.
  destruct (_ && _); try discriminate.
  bind E g G. bind E low L. bind E x X. destruct x as [x m2]. bind E h Hh. bind E high U.
  bind E y Y. destruct y as [y m3]. bind E z W0. injection E as <-.
  apply (fact_at_sound v p here) in G, Hh. eapply bounding_sound in L, U; eauto.
  apply (enclose_sound v) in X; trivial. destruct X as [R2 [_ X]].
  apply (enclose_sound v) in Y; trivial. destruct Y as [R3 [_ Y]].
  intros j w J. apply find_add in J. destruct J as [[-> ->]|J]; [|now apply R3].
  split; [tauto|]. eapply between_sound; [exact X | exact Y | tauto | exact W0].
Qed.
Lemma enclosing_sound bits l : forall m m1, remembered v m ->
  enclosing S T H F bits p m l = Some m1 -> remembered v m1.
Proof.
  induction l as [|b l IH]; cbn [enclosing]; intros m m1 R E; [now injection E as <-|].
  bind E m2 X. apply IH in E; trivial. eapply with_bound_sound; eauto.
Qed.
Lemma interval_at_sound g bits bounds :
  interval_at S T H F grounds p g bounds bits = true -> holds S v g.
Proof.
  unfold interval_at. intros E. destruct (enclosing _ _ _ _ _ _ _ _) as [m|] eqn:X; try discriminate.
  apply enclosing_sound in X; [|apply ground_sound].
  destruct (each _ _ _) as [[[|x [|y [|]]] m1]|] eqn:Y; try discriminate.
  apply (each_sound (remembered v) (right v)) in Y; trivial;
    [|intros; eapply enclose_sound; eauto].
  destruct Y as [_ Y]. inversion Y as [|? ? ? ? [A B] Y1]; subst.
  inversion Y1 as [|? ? ? ? [C D] _]; subst. repeat split; trivial.
  unfold stands. eapply decide_sound; eauto.
Qed.
Lemma interval_sound g bits bounds :
  interval S T H F grounds p g bits bounds = true -> holds S v g.
Proof.
  intros E. apply at_some_precision_sound in E. destruct E as [b E]. now apply interval_at_sound in E.
Qed.

(* --- the pieces of a cut --- *)

Lemma branch_satisfied more : Forall (holds S v) more -> satisfied v (branch p more).
Proof.
  intros Q. destruct here as [A B]. split; trivial. cbn [snd branch]. now apply Forall_app.
Qed.
Lemma pieces_cover t l : forall low, defined_at S v t ->
  Forall (defined_at S v) l -> Forall (holds S v) low ->
  exists more, In more (pieces t low l) /\ Forall (holds S v) more.
Proof.
  induction l as [|i l IH]; cbn [pieces]; intros low D Q L.
  - exists low. split; [now left | trivial].
  - inversion_clear Q as [|? ? Di Ql].
    destruct (Rle_lt_dec (value_at S v t) (value_at S v i)) as [A|A].
    + exists (low ++ [Claim AtMost t i]). split; [now left|]. apply Forall_app. split; trivial.
      constructor; trivial. repeat split; trivial.
    + destruct (IH [Claim AtMost i t]) as (more & I & M); trivial.
      * constructor; trivial. repeat split; trivial. unfold stands. cbn. lra.
      * exists more. split; [now right | trivial].
Qed.
Lemma rational_defined i : is_rational T i <> None -> defined_at S v i.
Proof.
  intros N. destruct (is_rational T i) as [q|] eqn:E; [|now destruct N].
  eapply rational_sound; eauto.
Qed.
Lemma increasing_sound l : forall q, increasing T q l = true -> Forall (defined_at S v) l.
Proof.
  induction l as [|i l IH]; cbn [increasing]; intros q E; constructor.
  - apply rational_defined. destruct (is_rational T i); discriminate.
  - destruct (is_rational T i); try discriminate. destruct (Qcompare _ _); try discriminate. eauto.
Qed.
Lemma good_points_sound l : good_points T l = true -> Forall (defined_at S v) l.
Proof.
  destruct l as [|i l]; cbn [good_points]; try discriminate. intros E. constructor.
  - apply rational_defined. destruct (is_rational T i); discriminate.
  - destruct (is_rational T i); try discriminate. eapply increasing_sound; eauto.
Qed.

(* --- minima and maxima --- *)

Lemma least_le a l : forall x, In x (a :: l) ->
  fold_right (fun x => Rmin (value_at S v x)) (value_at S v a) l <= value_at S v x.
Proof.
  induction l as [|y l IH]; cbn [fold_right In]; intros x I.
  - destruct I as [<-|[]]. lra.
  - destruct I as [<-|[<-|I]].
    + eapply Rle_trans; [apply Rmin_r | apply IH; now left].
    + apply Rmin_l.
    + eapply Rle_trans; [apply Rmin_r | apply IH; now right].
Qed.
Lemma greatest_ge a l : forall x, In x (a :: l) ->
  value_at S v x <= fold_right (fun x => Rmax (value_at S v x)) (value_at S v a) l.
Proof.
  induction l as [|y l IH]; cbn [fold_right In]; intros x I.
  - destruct I as [<-|[]]. lra.
  - destruct I as [<-|[<-|I]].
    + eapply Rle_trans; [apply IH; now left | apply Rmax_r].
    + apply Rmax_l.
    + eapply Rle_trans; [apply IH; now right | apply Rmax_r].
Qed.
Lemma least_in a l : exists x, In x (a :: l) /\
  fold_right (fun x => Rmin (value_at S v x)) (value_at S v a) l = value_at S v x.
Proof.
  induction l as [|y l (x & I & E)]; cbn [fold_right In]; [eauto|]. rewrite E.
  destruct (Rle_dec (value_at S v y) (value_at S v x)).
  - exists y. rewrite Rmin_left by assumption. auto.
  - exists x. rewrite Rmin_right by lra. cbn [In] in I. intuition.
Qed.
Lemma greatest_in a l : exists x, In x (a :: l) /\
  fold_right (fun x => Rmax (value_at S v x)) (value_at S v a) l = value_at S v x.
Proof.
  induction l as [|y l (x & I & E)]; cbn [fold_right In]; [eauto|]. rewrite E.
  destruct (Rle_dec (value_at S v x) (value_at S v y)).
  - exists y. rewrite Rmax_left by assumption. auto.
  - exists x. rewrite Rmax_right by lra. cbn [In] in I. intuition.
Qed.
End Again.
End ValidFacts.
End Places.
