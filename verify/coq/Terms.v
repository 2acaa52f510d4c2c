(* Terms, names and contexts of a statement as the checker looks them up, and that what it finds is
   what they mean. *)
From Coq Require Import Reals ZArith NArith List Lra Lia Bool Arith Wf_nat FMapPositive.
From Verify Require Import Meaning.
Import ListNotations.
Open Scope R_scope.

Lemma find_add {A} (i j : positive) (x y : A) m :
  PM.find i (PM.add j x m) = Some y -> (i = j /\ x = y) \/ PM.find i m = Some y.
Proof.
  destruct (Pos.eq_dec i j) as [->|N].
  - rewrite PositiveMapAdditionalFacts.gsspec. destruct (PM.E.eq_dec j j) as [_|N].
    + injection 1 as ->. auto.
    + now destruct N.
  - rewrite PM.gso by assumption. auto.
Qed.

Lemma bind_some {A B} (a : option A) (f : A -> option B) y :
  (match a with Some x => f x | None => None end) = Some y -> exists x, a = Some x /\ f x = Some y.
Proof. destruct a; [eauto | discriminate]. Qed.
Ltac bind H x E := apply bind_some in H; destruct H as (x & E & H).
Notation "'let*' x := a 'in' b" := (match a with Some x => b | None => None end)
  (at level 200, x pattern, a at level 100, b at level 200).

(* The results for the items of a list, one after the other, with a memory. *)
Fixpoint each {X Y M} (f : M -> X -> option (Y * M)) (s : M) (l : list X) : option (list Y * M) :=
  match l with
  | [] => Some ([], s)
  | a :: r =>
      let* (x, s1) := f s a in
      let* (xs, s2) := each f s1 r in
      Some (x :: xs, s2)
  end.
Lemma each_sound {X Y M} (good : M -> Prop) (right : X -> Y -> Prop) f (l : list X) :
  (forall s i x s1, In i l -> good s -> f s i = Some (x, s1) -> good s1 /\ right i x) ->
  forall s xs s1, good s -> each f s l = Some (xs, s1) -> good s1 /\ Forall2 right l xs.
Proof.
  induction l as [|a l IH]; cbn [each]; intros F s xs s1 Q H.
  - injection H as <- <-. auto.
  - bind H y E. destruct y as [y s2]. bind H z G. destruct z as [z s3]. injection H as <- <-.
    apply F in E; [|now left | trivial]. destruct E as [Q1 Q2].
    apply IH in G; trivial; [|intros; eapply F; eauto; now right]. destruct G. auto.
Qed.

(* --- claims ----------------------------------------------------------------------------------- *)

Definition same_relation (r s : relation) : bool :=
  match r, s with
  | Less, Less | AtMost, AtMost | Equal, Equal | Differs, Differs => true
  | _, _ => false
  end.
Definition same_claim (g h : claim) : bool :=
  same_relation (relation_of g) (relation_of h) && Pos.eqb (lhs g) (lhs h) && Pos.eqb (rhs g) (rhs h).
Lemma same_claim_sound g h : same_claim g h = true -> g = h.
Proof.
  unfold same_claim. destruct g as [r a b], h as [s c d]. cbn [relation_of lhs rhs]. intros H.
  apply andb_prop in H. destruct H as [H B]. apply andb_prop in H. destruct H as [H A].
  apply Pos.eqb_eq in A, B. subst. destruct r, s; try discriminate; reflexivity.
Qed.
Definition negated (g : claim) : claim :=
  let r := match relation_of g with
    | Less => AtMost | AtMost => Less | Equal => Differs | Differs => Equal end in
  Claim r (rhs g) (lhs g).

(* --- tables ----------------------------------------------------------------------------------- *)

Definition subterms (n : node) : list positive :=
  match n with
  | NRational _ _ | NVariable _ | NPi => []
  | NConstant _ a | NNeg a | NPow a _ | NSqrt a | NCos a | NCosPi a | NOf _ a => [a]
  | NAdd a b | NSub a b | NMul a b | NDiv a b => [a; b]
  | NMin a l | NMax a l => a :: l
  end.
Fixpoint listed {A} (k : positive) (ns : list A) : list (positive * A) :=
  match ns with [] => [] | n :: r => (k, n) :: listed (Pos.succ k) r end.
Definition table {A} (l : list (positive * A)) : PM.t A :=
  fold_right (fun x m => PM.add (fst x) (snd x) m) (PM.empty A) l.
(* Subterms come first. *)
Definition ordered (l : list (positive * node)) : bool :=
  forallb (fun x => forallb (fun k => Pos.ltb k (fst x)) (subterms (snd x))) l.

Lemma listed_above {A} (ns : list A) : forall k i n, In (i, n) (listed k ns) -> (k <= i)%positive.
Proof.
  induction ns as [|m ns IH]; cbn [listed In]; intros k i n H; [tauto|].
  destruct H as [H|H]; [injection H as -> _; lia | apply IH in H; lia].
Qed.
Lemma table_in {A} l i (n : A) : PM.find i (table l) = Some n -> In (i, n) l.
Proof.
  induction l as [|[k m] l IH]; cbn [table fold_right fst snd]; intros H.
  - now rewrite PM.gempty in H.
  - apply find_add in H. destruct H as [[-> ->]|H]; [now left | right; auto].
Qed.
Lemma listed_find {A} (ns : list A) : forall k i n,
  In (i, n) (listed k ns) -> PM.find i (table (listed k ns)) = Some n.
Proof.
  induction ns as [|m ns IH]; cbn [listed In table fold_right fst snd]; intros k i n H; [tauto|].
  destruct H as [H|H]; [injection H as -> ->; apply PM.gss|].
  rewrite PM.gso; [now apply IH|]. apply listed_above in H. lia.
Qed.
Lemma nth_listed {A} (l : list A) : forall k i, (k <= i)%positive ->
  PM.find i (table (listed k l)) = nth_error l (Pos.to_nat i - Pos.to_nat k).
Proof.
  induction l as [|x l IH]; intros k i L; cbn [listed table fold_right fst snd].
  - rewrite PM.gempty. now destruct (_ - _)%nat.
  - destruct (Pos.eq_dec i k) as [->|N].
    + now rewrite PM.gss, Nat.sub_diag.
    + rewrite PM.gso by assumption. fold (table (listed (Pos.succ k) l)). rewrite IH by lia.
      replace (Pos.to_nat i - Pos.to_nat k)%nat with
        (Datatypes.S (Pos.to_nat i - Pos.to_nat (Pos.succ k))) by lia.
      reflexivity.
Qed.
Lemma in_listed {A} (l : list A) x : In x l -> forall k, exists i, In (i, x) (listed k l).
Proof.
  induction l as [|y l IH]; [intros []|]. intros [<-|I] k; cbn [listed In]; [eauto|].
  destruct (IH I (Pos.succ k)) as [i J]. eauto.
Qed.
Lemma grow_before ns : forall k trees i, (i < k)%positive ->
  PM.find i (grow k ns trees) = PM.find i trees.
Proof.
  induction ns as [|n ns IH]; cbn [grow]; intros k trees i H; trivial.
  rewrite IH by lia. apply PM.gso. lia.
Qed.
Lemma tree_same trees trees' k n : (forall a, In a (subterms n) -> PM.find a trees = PM.find a trees') ->
  tree trees k n = tree trees' k n.
Proof.
  intros H. assert (K : forall a, In a (subterms n) -> tree_at trees a = tree_at trees' a)
    by (intros a A; unfold tree_at; now rewrite H).
  clear H. destruct n; cbn [tree subterms In] in *;
    try (rewrite ?K by auto; reflexivity).
  - induction l as [|x l IH]; cbn [fold_right In] in *; [now apply K; auto|].
    rewrite IH, (K x) by (intuition; subst; auto). reflexivity.
  - induction l as [|x l IH]; cbn [fold_right In] in *; [now apply K; auto|].
    rewrite IH, (K x) by (intuition; subst; auto). reflexivity.
Qed.
Lemma grow_listed ns : forall k trees i n, ordered (listed k ns) = true -> In (i, n) (listed k ns) ->
  tree_at (grow k ns trees) i = tree (grow k ns trees) i n.
Proof.
  induction ns as [|m ns IH]; cbn [listed In]; intros k trees i n O H; [tauto|].
  cbn [ordered forallb] in O. fold (ordered (listed (Pos.succ k) ns)) in O.
  apply andb_prop in O. destruct O as [O1 O2]. cbn [grow].
  destruct H as [H|H]; [|now apply IH]. injection H as -> ->.
  unfold tree_at at 1. rewrite grow_before by lia. rewrite PM.gss. apply tree_same.
  intros a A. rewrite forallb_forall in O1. cbn [fst snd] in O1. apply O1, Pos.ltb_lt in A.
  rewrite grow_before by lia. rewrite PM.gso by lia. reflexivity.
Qed.

Lemma listed_in_table {A} l : forall i (n : A), In (i, n) l -> PM.find i (table l) <> None.
Proof.
  induction l as [|[k m] l IH]; cbn [In table fold_right fst snd]; intros i n H; [tauto|].
  destruct (Pos.eq_dec i k) as [->|N]; [rewrite PM.gss; discriminate|].
  rewrite PM.gso by assumption. destruct H as [H|H]; [congruence | eapply IH; eauto].
Qed.
Lemma grow_only ns : forall k trees i t, PM.find i (grow k ns trees) = Some t ->
  PM.find i trees = Some t \/ exists n, In (i, n) (listed k ns).
Proof.
  induction ns as [|n ns IH]; cbn [grow listed In]; intros k trees i t H; [auto|].
  apply IH in H. destruct H as [H|[m H]]; [|right; eauto].
  apply find_add in H. destruct H as [[-> _]|H]; [right; eauto | auto].
Qed.

(* The value, and the definedness, of a node over its subterms. *)
Definition node_value (v : valuation) (f : positive -> R) (k : positive) (n : node) : R :=
  match n with
  | NRational n d => IZR n / IZR (Zpos d)
  | NVariable _ => v k
  | NConstant _ a => f a
  | NAdd a b => f a + f b
  | NSub a b => f a - f b
  | NMul a b => f a * f b
  | NDiv a b => f a / f b
  | NNeg a => - f a
  | NPow a n => f a ^ Pos.to_nat n
  | NSqrt a => sqrt (f a)
  | NMin a l => fold_right (fun x => Rmin (f x)) (f a) l
  | NMax a l => fold_right (fun x => Rmax (f x)) (f a) l
  | NCos a => cos (f a)
  | NCosPi a => cos (PI * f a)
  | NPi => PI
  | NOf h a => applied h (f a)
  end.
Definition proviso (f : positive -> R) (n : node) : Prop :=
  match n with
  | NDiv _ b => f b <> 0
  | NSqrt a => 0 <= f a
  | NOf h a => in_domain h (f a)
  | _ => True
  end.

Section Table.
Variable S : statement.
Definition numbered := listed 1 (nodes S).
Hypothesis in_order : ordered numbered = true.
Notation T := (table numbered).

Lemma node_listed i n : PM.find i T = Some n -> term_at S i = tree (grow 1 (nodes S) (PM.empty term)) i n.
Proof. intros H. apply table_in in H. now apply grow_listed. Qed.
Lemma value_node v i n : PM.find i T = Some n -> value_at S v i = node_value v (value_at S v) i n.
Proof.
  intros H. unfold value_at at 1. rewrite (node_listed _ _ H). clear H.
  destruct n; cbn [tree value node_value]; trivial; unfold value_at, term_at;
    induction l as [|x l IH]; cbn [fold_right value]; trivial; now rewrite IH.
Qed.
Lemma defined_node v i n : PM.find i T = Some n ->
  (defined_at S v i <->
   (forall a, In a (subterms n) -> defined_at S v a) /\ proviso (value_at S v) n).
Proof.
  intros H. unfold defined_at at 1. rewrite (node_listed _ _ H). clear H.
  destruct n; cbn [tree defined subterms proviso In]; unfold defined_at, term_at, value_at;
    try (intuition (subst; auto); fail).
  - split.
    + intros D; split; trivial. induction l as [|x l IH]; cbn [fold_right defined In] in *.
      * intros y [<-|[]]. exact D.
      * intros y [<-|[<-|Y]]; [apply IH; tauto | tauto | apply IH; tauto].
    + intros [D _]. induction l as [|x l IH]; cbn [fold_right defined In] in *.
      * apply D. auto.
      * split; [apply D; auto|]. apply IH. intros y [Y|Y]; apply D; auto.
  - split.
    + intros D; split; trivial. induction l as [|x l IH]; cbn [fold_right defined In] in *.
      * intros y [<-|[]]. exact D.
      * intros y [<-|[<-|Y]]; [apply IH; tauto | tauto | apply IH; tauto].
    + intros [D _]. induction l as [|x l IH]; cbn [fold_right defined In] in *.
      * apply D. auto.
      * split; [apply D; auto|]. apply IH. intros y [Y|Y]; apply D; auto.
Qed.
Lemma unlisted i : PM.find i T = None -> term_at S i = undefined.
Proof.
  intros H. unfold term_at, tree_at.
  destruct (PM.find i (grow 1 (nodes S) (PM.empty term))) eqn:E; trivial.
  apply grow_only in E. destruct E as [E|[n E]].
  - now rewrite PM.gempty in E.
  - now apply listed_in_table in E.
Qed.
Lemma below_node i n a : PM.find i T = Some n -> In a (subterms n) -> (a < i)%positive.
Proof.
  intros H A. apply table_in in H. pose proof in_order as O. unfold ordered in O.
  rewrite forallb_forall in O. specialize (O _ H). rewrite forallb_forall in O.
  now apply O, Pos.ltb_lt in A.
Qed.

(* --- contexts --------------------------------------------------------------------------------- *)

Definition descending : bool :=
  forallb (fun k => Nat.ltb (parent_of S k) k) (seq 1 (length (contexts S))).
Hypothesis parents_first : descending = true.
Definition is_inside (c d : nat) : bool := existsb (Nat.eqb d) (around S c).

Lemma parent_below c : (0 < c)%nat -> (parent_of S c < c)%nat.
Proof.
  intros H. destruct c as [|k]; [lia|]. destruct (le_lt_dec (Datatypes.S k) (length (contexts S))).
  - pose proof parents_first as P. unfold descending in P. rewrite forallb_forall in P.
    apply Nat.ltb_lt. apply P, in_seq. lia.
  - unfold parent_of, context_at. replace (nth_error (contexts S) k) with (@None context); [lia|].
    symmetry. apply nth_error_None. lia.
Qed.
Lemma upwards_enough c : forall m n, (c <= m)%nat -> (c <= n)%nat -> upwards S m c = upwards S n c.
Proof.
  induction c as [c IH] using lt_wf_ind. intros m n M N.
  destruct c as [|c]; [destruct m, n; reflexivity|].
  destruct m as [|m]; [lia|]. destruct n as [|n]; [lia|]. cbn [upwards]. f_equal.
  pose proof (parent_below (Datatypes.S c) ltac:(lia)). apply IH; lia.
Qed.
Lemma around_step c : (0 < c)%nat -> around S c = c :: around S (parent_of S c).
Proof.
  intros H. unfold around. destruct c as [|c]; [lia|]. cbn [upwards]. f_equal.
  pose proof (parent_below (Datatypes.S c) H). apply upwards_enough; lia.
Qed.
Lemma around_self c : In c (around S c).
Proof. destruct c; [now left|]. rewrite around_step by lia. now left. Qed.
Lemma around_at_most c : forall d, In d (around S c) -> (d <= c)%nat.
Proof.
  induction c as [c IH] using lt_wf_ind. intros d H.
  destruct c as [|c]; [destruct H as [<-|[]]; lia|].
  rewrite around_step in H by lia. destruct H as [<-|H]; [lia|].
  pose proof (parent_below (Datatypes.S c) ltac:(lia)). apply IH in H; lia.
Qed.
Lemma around_within c : forall d, In d (around S c) -> incl (around S d) (around S c).
Proof.
  induction c as [c IH] using lt_wf_ind. intros d H.
  destruct c as [|c]; [destruct H as [<-|[]]; apply incl_refl|].
  rewrite around_step in H by lia. destruct H as [<-|H]; [apply incl_refl|].
  rewrite (around_step (Datatypes.S c)) by lia. apply incl_tl.
  pose proof (parent_below (Datatypes.S c) ltac:(lia)). apply IH; trivial; lia.
Qed.
Lemma is_inside_sound c d : is_inside c d = true -> In d (around S c).
Proof.
  unfold is_inside. rewrite existsb_exists. intros (x & H & E). apply Nat.eqb_eq in E. now subst.
Qed.
Lemma scope_within c d v : In d (around S c) -> scope S c v -> scope S d v.
Proof. intros H C k K. apply C. now apply (around_within _ _ H). Qed.

(* --- the innermost context of the names in a term --------------------------------------------- *)

Definition home_in (homes : PM.t nat) (i : positive) : nat :=
  match PM.find i homes with Some c => c | None => O end.
Definition deeper (c d : nat) : nat := if is_inside c d then c else d.
Fixpoint homes_from (l : list (positive * node)) (homes : PM.t nat) : PM.t nat :=
  match l with
  | [] => homes
  | (i, n) :: r =>
      let c := match n with
        | NVariable c | NConstant c _ => c
        | _ => fold_right (fun a => deeper (home_in homes a)) O (subterms n) end in
      homes_from r (match c with O => homes | _ => PM.add i c homes end)
  end.
Definition homes : PM.t nat := homes_from numbered (PM.empty nat).
(* Whatever was found: names of a term are those of its home and of contexts around it. *)
Definition at_home (homes : PM.t nat) : bool :=
  forallb (fun x => let c := home_in homes (fst x) in
    match snd x with
    | NVariable d => is_inside c d
    | n => forallb (fun a => is_inside c (home_in homes a)) (subterms n)
    end) numbered.

Variable H : PM.t nat.
Hypothesis good_homes : at_home H = true.
Notation home := (home_in H).

Definition agree (c : nat) (v w : valuation) : Prop :=
  forall x d, PM.find x T = Some (NVariable d) -> In d (around S c) -> v x = w x.
Lemma agree_within c d v w : In d (around S c) -> agree c v w -> agree d v w.
Proof. intros D A x e X E. apply (A x e X). now apply (around_within _ _ D). Qed.

Lemma node_same v w f g k n : (forall d, n <> NVariable d) ->
  (forall a, In a (subterms n) -> f a = g a) -> node_value v f k n = node_value w g k n.
Proof.
  intros N E. destruct n; cbn [node_value subterms In] in *;
    try (rewrite ?E by auto; reflexivity).
  - now destruct (N c).
  - clear N. induction l as [|x l IH]; cbn [fold_right In] in *; [now apply E; auto|].
    rewrite IH, (E x) by (intuition; subst; auto). reflexivity.
  - clear N. induction l as [|x l IH]; cbn [fold_right In] in *; [now apply E; auto|].
    rewrite IH, (E x) by (intuition; subst; auto). reflexivity.
Qed.
Lemma proviso_same f g n : (forall a, In a (subterms n) -> f a = g a) -> proviso f n -> proviso g n.
Proof. intros E. destruct n; cbn [proviso subterms In] in *; trivial; now rewrite E by auto. Qed.

Lemma home_value v w : forall i, agree (home i) v w ->
  value_at S v i = value_at S w i /\ (defined_at S v i -> defined_at S w i).
Proof.
  induction i as [i IH] using (well_founded_induction (well_founded_ltof _ Pos.to_nat)).
  intros A. destruct (PM.find i T) as [n|] eqn:E.
  - pose proof good_homes as G. unfold at_home in G. rewrite forallb_forall in G.
    specialize (G _ (table_in _ _ _ E)). cbn [fst snd] in G.
    assert (K : forall a, In a (subterms n) ->
      value_at S v a = value_at S w a /\ (defined_at S v a -> defined_at S w a)).
    { intros a I. apply IH.
      - unfold ltof. apply Pos2Nat.inj_lt. eapply below_node; eauto.
      - apply agree_within with (home i); trivial. apply is_inside_sound.
        destruct n; try (destruct I; fail); rewrite forallb_forall in G; auto. }
    split.
    + rewrite !(value_node _ _ _ E). destruct n; try (apply node_same; [discriminate|]; intros x I; apply (K x I); fail).
      cbn [node_value]. apply (A i c E). now apply is_inside_sound.
    + rewrite !(defined_node _ _ _ E). intros [D P]. split.
      * intros x I. apply (K x I), (D x I).
      * apply proviso_same with (value_at S v); trivial. intros x I. apply (K x I).
  - unfold value_at, defined_at. rewrite (unlisted _ E). split; [reflexivity|].
    cbn. lra.
Qed.
Lemma agree_sym c v w : agree c v w -> agree c w v.
Proof. intros A x d X D. symmetry. eapply A; eauto. Qed.
End Table.

(* A term is looked up last when two values are compared: it may be as large as a certificate. *)
Strategy 1000 [term_at].

(* --- what all rules use of a statement -------------------------------------------------------- *)

(* T has its nodes by their numbers; and H has the homes of its terms, so that the givens of a context
   are claims over names in scope there. The checker looks once whether this is so. *)
Record tabled (S : statement) (T : PM.t node) : Prop := {
  in_order : ordered (numbered S) = true;
  is_table : forall i, PM.find i T = PM.find i (table (numbered S))
}.
Record prepared (S : statement) (T : PM.t node) (H : PM.t nat) : Prop := {
  found : tabled S T;
  parents_first : descending S = true;
  good_homes : at_home S H = true;
  givens_home : forall c a, In a (givens_of S c) ->
    In (home_in H (lhs (given_claim a))) (around S c) /\
    In (home_in H (rhs (given_claim a))) (around S c)
}.
Lemma value_is S T (Q : tabled S T) v i n : PM.find i T = Some n ->
  value_at S v i = node_value v (value_at S v) i n.
Proof. rewrite (is_table S T Q). apply value_node, Q. Qed.
Lemma defined_is S T (Q : tabled S T) v i n : PM.find i T = Some n ->
  (defined_at S v i <-> (forall a, In a (subterms n) -> defined_at S v a) /\ proviso (value_at S v) n).
Proof. rewrite (is_table S T Q). apply defined_node, Q. Qed.
