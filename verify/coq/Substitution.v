(* Terms put for the variables of a context, whose constants are unfolded. The new terms are looked
   up among the nodes; what is found is compared, so that nothing rests on how it was found. *)
From Coq Require Import Reals ZArith List Lia Bool Arith FMapPositive.
From Verify Require Import Meaning Terms.
Import ListNotations.
Open Scope R_scope.

(* --- finding a node --------------------------------------------------------------------------- *)

Definition node_dec (m n : node) : {m = n} + {m <> n}.
Proof. repeat decide equality. Defined.

Fixpoint coded (p rest : positive) : positive :=
  match p with
  | xH => xO rest
  | xO q => xI (xO (coded q rest))
  | xI q => xI (xI (coded q rest))
  end.
Definition key (n : node) : positive :=
  match n with
  | NRational _ _ | NVariable _ | NConstant _ _ => 1
  | NAdd a b => coded 2 (coded a (coded b 1))
  | NSub a b => coded 3 (coded a (coded b 1))
  | NMul a b => coded 4 (coded a (coded b 1))
  | NDiv a b => coded 5 (coded a (coded b 1))
  | NNeg a => coded 6 (coded a 1)
  | NPow a n => coded 7 (coded a (coded n 1))
  | NSqrt a => coded 8 (coded a 1)
  | NMin a l => coded 9 (coded a (fold_right coded 1%positive l))
  | NMax a l => coded 10 (coded a (fold_right coded 1%positive l))
  | NCos a => coded 11 (coded a 1)
  | NCosPi a => coded 12 (coded a 1)
  | NOf Exp a => coded 13 (coded a 1)
  | NOf Log a => coded 14 (coded a 1)
  | NOf Sin a => coded 15 (coded a 1)
  | NOf Atan a => coded 16 (coded a 1)
  | NOf (NthRoot n) a => coded 18 (coded n (coded a 1))
  | NPi => coded 17 1
  end.
Definition keys (l : list (positive * node)) : PM.t positive :=
  fold_right (fun x m => PM.add (key (snd x)) (fst x) m) (PM.empty positive) l.
Definition find_node (T : PM.t node) (K : PM.t positive) (n : node) : option positive :=
  match PM.find (key n) K with
  | None => None
  | Some i =>
      match PM.find i T with
      | Some m => if node_dec m n then Some i else None
      | None => None
      end
  end.
Lemma find_node_sound T K n i : find_node T K n = Some i -> PM.find i T = Some n.
Proof.
  unfold find_node. destruct (PM.find (key n) K) as [j|]; try discriminate.
  destruct (PM.find j T) as [m|] eqn:E; try discriminate.
  destruct (node_dec m n); try discriminate. injection 1 as <-. now subst.
Qed.

(* --- the same node over other subterms --------------------------------------------------------- *)

Section Mapped.
Variable f : positive -> option positive.
Fixpoint mapped_list (l : list positive) : option (list positive) :=
  match l with
  | [] => Some []
  | a :: r =>
      match f a, mapped_list r with Some b, Some s => Some (b :: s) | _, _ => None end
  end.
Definition rebuilt (n : node) (l : list positive) : option node :=
  match n, l with
  | NAdd _ _, [a; b] => Some (NAdd a b)
  | NSub _ _, [a; b] => Some (NSub a b)
  | NMul _ _, [a; b] => Some (NMul a b)
  | NDiv _ _, [a; b] => Some (NDiv a b)
  | NNeg _, [a] => Some (NNeg a)
  | NPow _ k, [a] => Some (NPow a k)
  | NSqrt _, [a] => Some (NSqrt a)
  | NMin _ _, a :: r => Some (NMin a r)
  | NMax _ _, a :: r => Some (NMax a r)
  | NCos _, [a] => Some (NCos a)
  | NCosPi _, [a] => Some (NCosPi a)
  | NOf f _, [a] => Some (NOf f a)
  | _, _ => None
  end.
Definition mapped (n : node) : option node :=
  match mapped_list (subterms n) with Some l => rebuilt n l | None => None end.

Lemma mapped_list_sound l : forall s, mapped_list l = Some s ->
  Forall2 (fun a b => f a = Some b) l s.
Proof.
  induction l as [|a l IH]; cbn [mapped_list]; intros s H.
  - injection H as <-. constructor.
  - destruct (f a) eqn:E; try discriminate. destruct (mapped_list l); try discriminate.
    injection H as <-. auto.
Qed.
Lemma mapped_sound n m : mapped n = Some m ->
  Forall2 (fun a b => f a = Some b) (subterms n) (subterms m) /\
  forall g h v w i j, Forall2 (fun a b => g b = h a) (subterms n) (subterms m) ->
    node_value v g j m = node_value w h i n /\ (proviso h n <-> proviso g m).
Proof.
  unfold mapped. destruct (mapped_list (subterms n)) as [l|] eqn:E; try discriminate.
  apply mapped_list_sound in E. intros H.
  assert (M : subterms m = l).
  { destruct n, l as [|? [|? [|? ?]]]; cbn [rebuilt] in H; try discriminate;
      injection H as <-; reflexivity. }
  rewrite M. split; trivial. intros g h v w i j Q. clear E M.
  destruct n, l as [|? [|? [|? ?]]]; cbn [rebuilt] in H; try discriminate;
    injection H as <-; cbn [subterms node_value proviso] in *;
    inversion Q as [|? ? ? ? A B]; subst; rewrite A; try (clear - B);
    try (inversion B as [|? ? ? ? A' B']; subst; rewrite A'; split; tauto);
    split; try tauto; induction B as [|? ? ? ? C B IH]; cbn [fold_right]; trivial; now rewrite C, IH.
Qed.
End Mapped.

(* --- the substitution ------------------------------------------------------------------------- *)

Section Substitution.
Variable S : statement.
Variable H : PM.t nat.
Variable T : PM.t node.
Hypothesis ready : prepared S T H.
Let parents_first := parents_first S T H ready.
Let good_homes := good_homes S T H ready.
Let in_order := in_order S T (found S T H ready).
Let is_table := is_table S T (found S T H ready).
Variable K : PM.t positive.
Notation home := (home_in H).

Variable c : nat.
Variable at_ : substitution.
(* Only variables of the context get other values. *)
Definition of_context : bool :=
  forallb (fun x => match PM.find (fst x) T with
    | Some (NVariable d) => Nat.eqb c d | _ => false end) at_.
Definition new_term (phi : PM.t positive) (i : positive) : option positive :=
  if Nat.eqb (home i) c then PM.find i phi
  else if is_inside S c (home i) then Some i else None.
Definition new_node (phi : PM.t positive) (i : positive) (n : node) : option positive :=
  if Nat.eqb (home i) c then
    match n with
    | NVariable _ => put at_ i
    | NConstant _ a => new_term phi a
    | _ => match mapped (new_term phi) n with Some m => find_node T K m | None => None end
    end
  else None.
Fixpoint new_terms (l : list (positive * node)) (phi : PM.t positive) : PM.t positive :=
  match l with
  | [] => phi
  | (i, n) :: r =>
      new_terms r (match new_node phi i n with Some j => PM.add i j phi | None => phi end)
  end.

Variable v : valuation.
Hypothesis own : of_context = true.
Hypothesis values_defined : all_defined S v at_.
Hypothesis not_root : (0 < c)%nat.
Notation w := (after S v at_).
Definition replaces (i j : positive) : Prop :=
  value_at S v j = value_at S w i /\ (defined_at S w i <-> defined_at S v j).

Lemma put_sound i j : put at_ i = Some j -> In (i, j) at_.
Proof.
  clear. induction at_ as [|[x t] l IH]; cbn [put]; [discriminate|].
  destruct (Pos.eqb_spec i x); [injection 1 as <-; subst; now left | right; auto].
Qed.
Lemma leaf i : home i <> c -> is_inside S c (home i) = true -> replaces i i.
Proof.
  intros N I. apply is_inside_sound in I. pose proof (around_at_most S parents_first _ _ I).
  assert (A : agree S (home i) w v).
  { intros x d X D. unfold after. destruct (put at_ x) as [t|] eqn:E; trivial.
    apply put_sound in E. pose proof own as O. unfold of_context in O.
    rewrite forallb_forall in O. specialize (O _ E). cbn [fst] in O. rewrite is_table, X in O.
    apply Nat.eqb_eq in O. subst d. apply (around_at_most S parents_first) in D. lia. }
  destruct (home_value S in_order parents_first H good_homes w v i A) as [V D].
  destruct (home_value S in_order parents_first H good_homes v w i (agree_sym S _ _ _ A)).
  split; [now symmetry | tauto].
Qed.
Definition all_replaced (phi : PM.t positive) : Prop :=
  forall i j, PM.find i phi = Some j -> replaces i j.
Lemma new_term_sound phi i j : all_replaced phi -> new_term phi i = Some j -> replaces i j.
Proof.
  unfold new_term. intros Q. destruct (Nat.eqb_spec (home i) c); [apply Q|].
  destruct (is_inside S c (home i)) eqn:I; try discriminate. injection 1 as <-. now apply leaf.
Qed.
Lemma new_node_sound phi i n j : all_replaced phi -> PM.find i (table (numbered S)) = Some n ->
  new_node phi i n = Some j -> replaces i j.
Proof.
  intros Q E. unfold new_node. destruct (Nat.eqb (home i) c); try discriminate.
  assert (M : forall m, mapped (new_term phi) n = Some m -> find_node T K m = Some j ->
    (forall d, n <> NVariable d) -> replaces i j).
  { intros m X F _. apply find_node_sound in F. rewrite is_table in F.
    destruct (mapped_sound (new_term phi) n m X) as [A B].
    assert (C : Forall2 replaces (subterms n) (subterms m)).
    { clear - A Q own values_defined not_root ready parents_first good_homes in_order is_table.
      induction A; constructor; trivial. eapply new_term_sound; eauto. }
    destruct (B (value_at S v) (value_at S w) v w i j) as [V P].
    { clear - C. induction C as [|a b l s [V _] C IH]; constructor; trivial. }
    unfold replaces. rewrite (value_node S in_order v j m F), (value_node S in_order w i n E).
    rewrite (defined_node S in_order v j m F), (defined_node S in_order w i n E).
    split; [now symmetry|]. rewrite <- P.
    enough (D : (forall a, In a (subterms n) -> defined_at S w a) <->
                (forall a, In a (subterms m) -> defined_at S v a)) by tauto.
    clear - C. induction C as [|a b l s [_ V] C IH]; cbn [In]; [tauto|].
    split; intros D x [<-|I]; try (apply V, D; now left); apply IH; trivial; intros; apply D; auto. }
  destruct n;
    try (destruct (mapped _ _) as [m|] eqn:X in |- *; [|discriminate]; intros F;
         apply (M m X F); discriminate);
    clear M; intros F.
  - apply put_sound in F as I. unfold replaces.
    rewrite (value_node S in_order w i _ E). cbn [node_value]. unfold after. rewrite F.
    rewrite (defined_node S in_order w i _ E). cbn [subterms proviso In].
    split; trivial. pose proof values_defined as D. unfold all_defined in D.
    rewrite Forall_forall in D. specialize (D _ I). cbn [snd] in D. tauto.
  - apply new_term_sound in F; trivial. unfold replaces in *.
    rewrite (value_node S in_order w i _ E), (defined_node S in_order w i _ E).
    cbn [node_value subterms proviso In]. destruct F as [F G]. split; trivial.
    rewrite <- G. intuition (subst; auto).
Qed.
Lemma new_terms_sound l : forall phi,
  (forall i n, In (i, n) l -> PM.find i (table (numbered S)) = Some n) ->
  all_replaced phi -> all_replaced (new_terms l phi).
Proof.
  induction l as [|[i n] l IH]; cbn [new_terms]; intros phi L Q; trivial. apply IH.
  - intros; apply L; now right.
  - destruct (new_node phi i n) as [j|] eqn:E; trivial. intros a b X.
    apply find_add in X. destruct X as [[-> ->]|X]; [|now apply Q].
    eapply new_node_sound; eauto. apply L. now left.
Qed.
End Substitution.
