(* What Clearing.v computes is right, at values for which what is usable holds: a cleared term is N/D,
   with D > 0, and sums and products of what is positive are positive. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool FMapPositive.
From Verify Require Import Meaning Roots Polynomials Terms Substitution Clearing.
Import ListNotations.
Open Scope R_scope.

(* What is taken as usable is true for the values v: signs, and that constants are defined. *)
Record right_at (S : statement) (v : valuation) (knows : bool -> positive -> bool)
    (is_defined : positive -> bool) : Prop := {
  signs_right : forall b t, knows b t = true ->
    0 <= value_at S v t /\ (b = true -> 0 < value_at S v t);
  constants_right : forall i, is_defined i = true -> defined_at S v i
}.

Section Cleared.
Variable S : statement.
Variable T : PM.t node.
Hypothesis ready : tabled S T.
Variable K : PM.t positive.
Variable v : valuation.
Variable knows : bool -> positive -> bool.
Variable is_defined : positive -> bool.
Hypothesis right_here : right_at S v knows is_defined.
Variable replaced : PM.t positive.
Hypothesis replaced_sound : forall i j, PM.find i replaced = Some j ->
  defined_at S v i /\ value_at S v i = value_at S v j.

Notation val := (value_at S v).
Notation at_values := (at_values (value_at S v)).
Definition is_quotient (i : positive) (x : quotient) : Prop :=
  defined_at S v i /\ 0 < at_values (snd x) /\ val i * at_values (snd x) = at_values (fst x).
Definition is_power (x : positive * (positive * quotient)) : Prop :=
  let '(i, (k, (n, d))) := x in
  0 < at_values d /\ val i ^ Pos.to_nat k * at_values d = at_values n.
Definition sound (s : clearing) : Prop :=
  (forall i x, PM.find i (cleared s) = Some x -> is_quotient i x) /\ Forall is_power (powers s).

Lemma nothing_sound : sound nothing_cleared.
Proof. split; [|constructor]. intros i x E. cbn in E. now rewrite PM.gempty in E. Qed.
Lemma remember_sound i x s : sound s -> is_quotient i x -> sound (remember i x s).
Proof.
  intros [A B] Q. split; trivial. cbn [cleared remember]. intros j y E.
  apply find_add in E. destruct E as [[-> ->]|E]; auto.
Qed.
Let table_value := value_is S T ready v.
Let table_defined := defined_is S T ready v.
Let knows_sound := signs_right _ _ _ _ right_here.
Let is_defined_sound := constants_right _ _ _ _ right_here.
Lemma rational_sound i q : is_rational T i = Some q -> val i = Q2R q /\ defined_at S v i.
Proof.
  unfold is_rational. destruct (PM.find i T) as [[]|] eqn:E; try discriminate. injection 1 as <-.
  rewrite (table_value _ _ E), (table_defined _ _ E). cbn. repeat split; tauto.
Qed.
Lemma sign_value q : 0 <= Q2R q <-> (0 <= Qnum q)%Z.
Proof.
  unfold Q2R. assert (P : 0 < / IZR (Zpos (Qden q))) by (apply Rinv_0_lt_compat, IZR_lt; reflexivity).
  split; intros H.
  - apply le_IZR. apply Rnot_lt_le. intros N. apply (Rmult_lt_compat_r _ _ _ P) in N. lra.
  - apply Rmult_le_pos; [now apply IZR_le | lra].
Qed.
Lemma sign_value_strict q : (0 < Qnum q)%Z -> 0 < Q2R q.
Proof.
  intros H. unfold Q2R. apply Rmult_lt_0_compat; [now apply IZR_lt|].
  apply Rinv_0_lt_compat, IZR_lt. reflexivity.
Qed.

Lemma plus_of x y : at_values (plus x y) = at_values x + at_values y. Proof. apply plus_value. Qed.
Lemma minus_of x y : at_values (minus x y) = at_values x - at_values y. Proof. apply minus_value. Qed.
Lemma product_positive x y : 0 < at_values x -> 0 < at_values y -> 0 < at_values (times x y).
Proof. intros X Y. rewrite times_value. now apply Rmult_lt_0_compat. Qed.

Lemma added_value (op : R -> R -> R) plus_ x y a b :
  (forall p q, at_values (plus_ p q) = op (at_values p) (at_values q)) ->
  (forall a b c, op a b * c = op (a * c) (b * c)) ->
  0 < at_values (snd x) -> a * at_values (snd x) = at_values (fst x) ->
  0 < at_values (snd y) -> b * at_values (snd y) = at_values (fst y) ->
  0 < at_values (snd (added plus_ x y)) /\
  op a b * at_values (snd (added plus_ x y)) = at_values (fst (added plus_ x y)).
Proof.
  destruct x as [n d], y as [m e]. cbn [fst snd]. intros P D X1 X2 Y1 Y2. unfold added.
  destruct (same d e) eqn:E; cbn [fst snd].
  - split; trivial. apply (same_value val) in E. rewrite P, D, X2, <- Y2, E. reflexivity.
  - split; [now apply product_positive|].
    rewrite P, !times_value, D, <- X2, <- Y2. f_equal; ring.
Qed.
Lemma divided_value b x y z a : divided T K knows b x y = Some z ->
  0 < at_values (snd x) -> a * at_values (snd x) = at_values (fst x) ->
  0 < at_values (snd y) -> val b * at_values (snd y) = at_values (fst y) ->
  val b <> 0 /\ 0 < at_values (snd z) /\ a / val b * at_values (snd z) = at_values (fst z).
Proof.
  destruct x as [n d], y as [m e]. cbn [fst snd]. unfold divided. intros H X1 X2 Y1 Y2.
  destruct (is_rational T b) as [q|] eqn:E.
  - destruct (rational_sound _ _ E) as [V _]. destruct (Z.eqb_spec (Qnum q) 0); try discriminate.
    injection H as <-. cbn [fst snd].
    assert (N : ~ (q == 0)%Q) by (unfold Qeq; simpl; lia).
    assert (N' : val b <> 0).
    { rewrite V. intros C. apply N, eqR_Qeq. rewrite C. unfold Q2R. simpl. ring. }
    repeat split; trivial. rewrite times_value, number_value, Q2R_inv, <- V, <- X2 by assumption.
    field. assumption.
  - destruct (knows true b) eqn:P.
    + injection H as <-. cbn [fst snd]. apply knows_sound in P. destruct P as [_ P].
      specialize (P eq_refl). split; [lra|]. split.
      * apply product_positive; trivial. rewrite <- Y2. now apply Rmult_lt_0_compat.
      * rewrite !times_value, <- X2, <- Y2. field. lra.
    + bind H o F. destruct (knows true o) eqn:P'; try discriminate. injection H as <-.
      cbn [fst snd]. apply find_node_sound in F. apply knows_sound in P'. destruct P' as [_ P'].
      specialize (P' eq_refl). rewrite (table_value _ _ F) in P'. cbn [node_value] in P'.
      split; [lra|]. split.
      * rewrite times_value, opposite_value, <- Y2. apply Rmult_lt_0_compat; trivial.
        rewrite Ropp_mult_distr_l. now apply Rmult_lt_0_compat.
      * rewrite !times_value, !opposite_value, <- X2, <- Y2. field. lra.
Qed.
Lemma rooted_sound a : rooted T knows a = true -> 0 <= val a.
Proof.
  unfold rooted. destruct (is_rational T a) as [q|] eqn:E; intros H.
  - destruct (rational_sound _ _ E) as [-> _]. apply sign_value. now apply Z.leb_le.
  - apply orb_prop in H. destruct H as [H|H]; apply knows_sound in H; tauto.
Qed.
Lemma applies_there_sound f a : applies_there T knows f a = true -> in_domain f (val a).
Proof.
  destruct f; cbn [applies_there in_domain]; trivial; [|apply rooted_sound].
  unfold positive_there.
  destruct (is_rational T a) as [q|] eqn:E; intros H; [|apply knows_sound in H; tauto].
  destruct (rational_sound _ _ E) as [-> _]. apply Z.ltb_lt in H. unfold Q2R.
  apply Rmult_lt_0_compat; [now apply IZR_lt | apply Rinv_0_lt_compat, IZR_lt; reflexivity].
Qed.
Lemma atom_quotient i : 0 < at_values one /\ val i * at_values one = at_values (atom i).
Proof. rewrite one_value, atom_value. lra. Qed.

Ltac quotients := repeat match goal with
  | H : Forall2 _ _ [] |- _ => inversion H; subst; clear H
  | H : Forall2 _ [] _ |- _ => inversion H; subst; clear H
  | H : Forall2 _ (_ :: _) _ |- _ => inversion H; subst; clear H
  | H : Forall2 _ _ (_ :: _) |- _ => inversion H; subst; clear H
  end.
Ltac subterms_defined := unfold is_quotient in *;
  intros ? I; repeat (destruct I as [<-|I]; [tauto|]); destruct I.
Lemma all_parts_defined l xs : Forall2 is_quotient l xs -> forall a, In a l -> defined_at S v a.
Proof.
  induction 1 as [|a x l xs A B IH]; intros b; [intros [] | intros [<-|I]]; [apply A | auto].
Qed.
Lemma combined_sound i n xs x : PM.find i T = Some n -> Forall2 is_quotient (parts n) xs ->
  combined T K knows is_defined i n xs = Some x -> is_quotient i x.
Proof.
  intros E Q H. pose proof (all_parts_defined _ _ Q) as D. unfold is_quotient at 1.
  rewrite (table_defined _ _ E).
  destruct n; cbn [parts subterms proviso] in *; cbn [combined] in H.
  - injection H as <-. rewrite (table_value _ _ E). cbn [fst snd node_value].
    rewrite one_value, number_value. unfold Q2R. cbn [Qnum Qden].
    repeat split; trivial; unfold Rdiv; lra.
  - injection H as <-. split; [tauto | apply atom_quotient].
  - destruct (is_defined i) eqn:F; try discriminate. injection H as <-.
    apply is_defined_sound in F. rewrite (table_defined _ _ E) in F. split; trivial.
    apply atom_quotient.
  - quotients. injection H as <-. split; [tauto|]. rewrite (table_value _ _ E). cbn [node_value].
    unfold is_quotient in *. apply (added_value Rplus); try tauto; [apply plus_of | intros; ring].
  - quotients. injection H as <-. split; [tauto|]. rewrite (table_value _ _ E). cbn [node_value].
    unfold is_quotient in *. apply (added_value Rminus); try tauto; [apply minus_of | intros; ring].
  - quotients. destruct y as [n d], y0 as [m e]. injection H as <-. split; [tauto|].
    rewrite (table_value _ _ E). cbn [node_value]. unfold is_quotient in *. cbn [fst snd] in *.
    split; [now apply product_positive|]. rewrite !times_value.
    destruct H2 as (_ & _ & <-), H3 as (_ & _ & <-). ring.
  - quotients. rewrite (table_value _ _ E). cbn [node_value]. unfold is_quotient in *.
    apply divided_value with (a := val a) in H; tauto.
  - quotients. destruct y as [n d]. injection H as <-. split; [tauto|].
    rewrite (table_value _ _ E). cbn [node_value]. unfold is_quotient in *. cbn [fst snd] in *.
    split; [tauto|]. rewrite opposite_value. destruct H2 as (_ & _ & <-). ring.
  - quotients. destruct y as [m d]. injection H as <-. split; [tauto|].
    rewrite (table_value _ _ E). cbn [node_value]. unfold is_quotient in *. cbn [fst snd] in *.
    rewrite !power_value. destruct H2 as (_ & P & <-). split; [now apply pow_lt|].
    now rewrite Rpow_mult_distr.
  - destruct (rooted T knows a) eqn:F; try discriminate. injection H as <-.
    apply rooted_sound in F. split; [tauto | apply atom_quotient].
  - injection H as <-. split; [tauto | apply atom_quotient].
  - injection H as <-. split; [tauto | apply atom_quotient].
  - injection H as <-. split; [tauto | apply atom_quotient].
  - injection H as <-. split; [tauto | apply atom_quotient].
  - injection H as <-. split; [tauto | apply atom_quotient].
  - destruct (applies_there T knows f a) eqn:F; try discriminate. injection H as <-.
    apply applies_there_sound in F. split; [auto | apply atom_quotient].
Qed.
Lemma with_power_sound i n xs s x : PM.find i T = Some n -> Forall2 is_quotient (parts n) xs ->
  combined T K knows is_defined i n xs = Some x -> sound s -> sound (with_power i n xs s).
Proof.
  intros E Q H [A B].
  destruct n; cbn [with_power]; try (split; assumption).
  - destruct xs as [|y [|]]; try (split; assumption). split; trivial. constructor; trivial.
    cbn [parts subterms combined] in *. quotients.
    destruct (rooted T knows a) eqn:F; try discriminate. apply rooted_sound in F.
    unfold is_power. unfold is_quotient in *. rewrite (table_value _ _ E). destruct y as [n d].
    cbn [node_value]. change (Pos.to_nat 2) with 2%nat. rewrite pow2_sqrt by assumption. tauto.
  - destruct f; try (split; assumption).
    destruct xs as [|y [|]]; try (split; assumption). split; trivial. constructor; trivial.
    cbn [parts subterms combined applies_there] in *. quotients.
    destruct (rooted T knows a) eqn:F; try discriminate. apply rooted_sound in F.
    unfold is_power. unfold is_quotient in *. rewrite (table_value _ _ E). destruct y as [m d].
    cbn [node_value applied]. rewrite nth_root_power by assumption. tauto.
Qed.
Notation clear := (clear T K knows is_defined replaced).
Lemma clear_sound fuel : forall s i x s1, sound s -> clear fuel s i = Some (x, s1) ->
  sound s1 /\ is_quotient i x.
Proof.
  induction fuel as [|fuel IH]; cbn [Clearing.clear]; intros s i x s1 Q H;
    destruct (PM.find i (cleared s)) as [y|] eqn:C; try discriminate;
    try (injection H as <- <-; split; trivial; now apply (proj1 Q)).
  destruct (PM.find i replaced) as [j|] eqn:E.
  - bind H y F. destruct y as [y s2]. injection H as <- <-. apply IH in F; trivial.
    destruct F as [Q2 (D & P & V)]. destruct (replaced_sound _ _ E) as [D' V'].
    assert (is_quotient i y) by (unfold is_quotient; rewrite V'; tauto).
    split; trivial. now apply remember_sound.
  - bind H n W. bind H y F. destruct y as [xs s2]. bind H z G. injection H as <- <-.
    apply (each_sound sound is_quotient) in F; [|intros; eapply IH; eauto | trivial]. destruct F as [Q2 F].
    pose proof (combined_sound _ _ _ _ W F G). split; trivial.
    apply remember_sound; trivial. eapply with_power_sound; eauto.
Qed.
Notation difference := (difference T K knows is_defined replaced).
(* The difference has the sign of the difference of the terms. *)
Lemma difference_sound s a b p s1 : sound s -> difference s a b = Some (p, s1) ->
  sound s1 /\ defined_at S v a /\ defined_at S v b /\
  exists k, 0 < k /\ at_values p = k * (val a - val b).
Proof.
  unfold Clearing.difference. intros Q H. bind H x E. destruct x as [x s2].
  bind H y F. destruct y as [y s3]. injection H as <- <-.
  apply clear_sound in E; trivial. destruct E as [Q2 (D & P & V)].
  apply clear_sound in F; trivial. destruct F as [Q3 (D' & P' & V')].
  split; [trivial|]. split; [trivial|]. split; [trivial|].
  exists (at_values (snd x) * at_values (snd y)). split; [now apply Rmult_lt_0_compat|]. rewrite minus_value, !times_value, <- V, <- V'. ring.
Qed.

Variable usable : reference -> option claim.
Hypothesis usable_sound : forall f g, usable f = Some g -> holds S v g.
Variable goal : polynomial * bool.
Definition is_signed (p : polynomial * bool) : Prop :=
  0 <= at_values (fst p) /\ (snd p = true -> 0 < at_values (fst p)).
Hypothesis goal_sound : is_signed goal.
Notation addend_value := (addend_value T K knows is_defined replaced usable goal).

Lemma number_signed q : (0 <= Qnum q)%Z -> is_signed (number q, (0 <? Qnum q)%Z).
Proof.
  intros H. unfold is_signed. cbn [fst snd]. rewrite number_value. split; [now apply sign_value|].
  intros E. apply sign_value_strict. now apply Z.ltb_lt.
Qed.
Lemma sum_signed p q : is_signed p -> is_signed q -> is_signed (plus (fst p) (fst q), snd p || snd q).
Proof.
  intros [A B] [C D]. unfold is_signed. cbn [fst snd]. rewrite plus_value. split; [lra|].
  intros H. apply orb_prop in H. destruct H as [H|H]; [apply B in H | apply D in H]; lra.
Qed.
Lemma product_signed p q :
  is_signed p -> is_signed q -> is_signed (times (fst p) (fst q), snd p && snd q).
Proof.
  intros [A B] [C D]. unfold is_signed. cbn [fst snd]. rewrite times_value.
  split; [now apply Rmult_le_pos|]. intros H. apply andb_prop in H.
  apply Rmult_lt_0_compat; [apply B | apply D]; tauto.
Qed.
Lemma value_each_sound f join both l :
  (forall a s p s1, In a l -> sound s -> f a s = Some (p, s1) -> sound s1 /\ is_signed p) ->
  (forall p q, is_signed p -> is_signed q ->
    is_signed (join (fst p) (fst q), both (snd p) (snd q))) ->
  forall p s q s1, is_signed p -> sound s -> value_each f join both p s l = Some (q, s1) ->
  sound s1 /\ is_signed q.
Proof.
  induction l as [|a l IH]; cbn [value_each]; intros F J p s q s1 P Q H.
  - injection H as <- <-. auto.
  - bind H x E. destruct x as [x s2]. apply F in E; [|now left | trivial]. destruct E as [Q2 X].
    apply IH in H; trivial; [intros; eapply F; eauto; now right | now apply J].
Qed.
Fixpoint addend_value_sound (a : addend) : forall s p s1, sound s ->
  addend_value a s = Some (p, s1) -> sound s1 /\ is_signed p.
Proof.
  assert (E : forall l, Forall (fun a => forall s p s1, sound s ->
    addend_value a s = Some (p, s1) -> sound s1 /\ is_signed p) l).
  { induction l; constructor; trivial. apply addend_value_sound. }
  destruct a; cbn [Clearing.addend_value]; intros s p s1 Q H; clear addend_value_sound.
  - injection H as <- <-. auto.
  - destruct (Z.leb_spec 0 (Qnum q)); try discriminate. injection H as <- <-. split; trivial.
    now apply number_signed.
  - bind H g G. apply usable_sound in G. destruct G as (_ & _ & G). unfold stands in G.
    destruct (relation_of g); try discriminate; bind H x X; destruct x as [x s2];
      injection H as <- <-; apply difference_sound in X; trivial;
      destruct X as (Q2 & _ & _ & k & P & V); split; trivial;
      unfold is_signed; cbn [fst snd related] in *; rewrite V.
    + split; [apply Rmult_le_pos; lra | intros _; apply Rmult_lt_0_compat; lra].
    + split; [apply Rmult_le_pos; lra | discriminate].
  - destruct (PM.find t T) as [[]|] eqn:N; try discriminate; try (destruct f; try discriminate);
      bind H x X; destruct x as [x s2]; injection H as <- <-; apply clear_sound in X; trivial;
      destruct X as [Q2 (_ & P & V)]; split; trivial; unfold is_signed; cbn [fst snd];
      rewrite <- V; (split; [|discriminate]); (apply Rmult_le_pos; [|lra]);
      rewrite (table_value _ _ N); cbn [node_value applied];
      [apply sqrt_pos | apply nth_root_nonnegative].
  - bind H x X. destruct x as [x s2]. injection H as <- <-. apply clear_sound in X; trivial.
    destruct X as [Q2 _]. split; trivial. unfold is_signed. cbn [fst snd]. rewrite times_value.
    split; [apply Rle_0_sqr | discriminate].
  - specialize (E l). rewrite Forall_forall in E.
    apply value_each_sound in H; trivial; try exact sum_signed.
    + intros; eapply E; eauto.
    + unfold is_signed. cbn. split; [lra | discriminate].
  - specialize (E l). rewrite Forall_forall in E.
    apply value_each_sound in H; trivial; try exact product_signed.
    + intros; eapply E; eauto.
    + unfold is_signed. cbn [fst snd]. rewrite one_value. lra.
  - specialize (E [a]). inversion_clear E. bind H x X. destruct x as [x s2].
    injection H as <- <-. apply H0 in X; trivial. destruct X as [Q2 [P1 P2]]. split; trivial.
    unfold is_signed. cbn [fst snd]. rewrite power_value.
    split; [now apply pow_le | intros; apply pow_lt; auto].
Qed.

Lemma reduce_sound s : sound s -> forall p, exists k, 0 < k /\ at_values (reduce s p) = k * at_values p.
Proof.
  intros [_ Q]. unfold reduce. induction Q as [|[x [i [n d]]] l A B IH]; cbn [fold_left]; intros p.
  - exists 1. split; [lra | ring].
  - destruct A as [P V]. cbn [fst snd] in *.
    destruct (without_powers_value val x i n d p P V) as (k & Pk & E).
    destruct (IH (without_powers x i n d p)) as (j & Pj & F). exists (j * k).
    split; [now apply Rmult_lt_0_compat|]. rewrite F, E. ring.
Qed.
Lemma vanishes_sound s p : sound s -> vanishes s p = true -> at_values p = 0.
Proof.
  unfold vanishes. intros Q H. destruct (reduce_sound s Q p) as (k & P & E).
  destruct (reduce s p); try discriminate. simpl in E.
  apply Rmult_eq_reg_l with k; [rewrite <- E; ring | lra].
Qed.
End Cleared.
