(* A citation is closed by a proof of the cited statement: if the citing statement begins with the
   same terms and contexts, what it believes of them is what the other one proves. *)
From Coq Require Import Reals ZArith List Lia Bool Arith FMapPositive.
From Verify Require Import Meaning Terms Substitution Kernel.
Import ListNotations.

Section Closing.
Variable S S' : statement.  (* the cited one, and the one that cites *)

Fixpoint common (l l' : list node) : list node :=
  match l, l' with
  | n :: r, n' :: r' => if node_dec n n' then n :: common r r' else []
  | _, _ => []
  end.
Definition shared_nodes : list node := common (nodes S) (nodes S').
Definition size : nat := length shared_nodes.
Variable m : nat.  (* so many terms are the same; computed once *)
Definition is_shared (i : positive) : bool := Nat.leb (Pos.to_nat i) m.
Definition shared_claim (g : claim) : bool := is_shared (lhs g) && is_shared (rhs g).
Fixpoint same_givens (l l' : list given) : bool :=
  match l, l' with
  | [], [] => true
  | a :: r, a' :: r' =>
      same_claim (given_claim a) (given_claim a') && shared_claim (given_claim a) && same_givens r r'
  | _, _ => false
  end.
Definition same_context (c : nat) : bool :=
  Nat.eqb (parent_of S c) (parent_of S' c) && Nat.ltb (parent_of S c) c &&
  same_givens (givens_of S c) (givens_of S' c).
Definition proves_row (c : nat) (g : claim) (r : row) : bool :=
  Nat.eqb (row_context r) c &&
  match row_verdict r, row_sentence r with Proved, Compare h => same_claim h g | _, _ => false end.
Definition proves_constant (c : nat) (g : claim) (i : positive) : bool :=
  Pos.eqb i (lhs g) &&
  match nth_error (nodes S) (pred (Pos.to_nat i)) with
  | Some (NConstant d a) => Nat.eqb d c && same_claim (Claim Equal i a) g
  | _ => false
  end.
Definition own (c : nat) : bool := existsb (Nat.eqb c) (own_contexts S).
Definition proves (c : nat) (g : claim) : bool :=
  shared_claim g && Nat.leb c (length (contexts S)) &&
  (existsb (proves_row c g) (rows S) || existsb (proves_constant c g) (constants S) ||
   own c && existsb (fun a => same_claim (given_claim a) g) (givens_of S c)).
Definition closes_constant (i : positive) : bool :=
  existsb (Pos.eqb i) (constants S) && is_shared i &&
  match nth_error (nodes S) (pred (Pos.to_nat i)) with
  | Some (NConstant c a) => is_shared a && Nat.leb c (length (contexts S))
  | _ => false
  end.
Definition closes_context (c : nat) : bool :=
  Nat.ltb 0 c && Nat.leb c (length (contexts S)) && own c.
Definition begins : bool :=
  Nat.leb m size && ordered (numbered S) && forallb same_context (seq 1 (length (contexts S))).

(* --- soundness --- *)

Lemma common_begins : forall l l', exists r r', l = common l l' ++ r /\ l' = common l l' ++ r'.
Proof.
  induction l as [|n l IH]; intros [|n' l']; cbn [common]; try (do 2 eexists; split; reflexivity).
  destruct (node_dec n n') as [<-|_]; [|do 2 eexists; split; reflexivity].
  destruct (IH l') as (r & r' & A & B). exists r, r'. cbn [app]. now rewrite <- A, <- B.
Qed.
Lemma grow_begins l : forall k r trees i, (Pos.to_nat i < Pos.to_nat k + length l)%nat ->
  PM.find i (grow k (l ++ r) trees) = PM.find i (grow k l trees).
Proof.
  induction l as [|n l IH]; intros k r trees i L; cbn [app grow length] in *.
  - apply grow_before. lia.
  - apply IH. lia.
Qed.
Hypothesis beginning : begins = true.
Lemma enough : (m <= size)%nat.
Proof.
  pose proof beginning as B. unfold begins in B. apply andb_prop in B. destruct B as [B _].
  apply andb_prop in B. now apply Nat.leb_le.
Qed.
Lemma in_order : ordered (numbered S) = true.
Proof.
  pose proof beginning as B. unfold begins in B. apply andb_prop in B. destruct B as [B _].
  now apply andb_prop in B.
Qed.
Lemma term_shared i : is_shared i = true -> term_at S' i = term_at S i.
Proof.
  unfold is_shared. intros L. apply Nat.leb_le in L. pose proof enough as M. unfold size in M.
  destruct (common_begins (nodes S) (nodes S')) as (r & r' & A & B). fold shared_nodes in A, B.
  unfold term_at, tree_at. rewrite A, B, !grow_begins; trivial; lia.
Qed.
Lemma node_shared i : is_shared i = true ->
  nth_error (nodes S') (pred (Pos.to_nat i)) = nth_error (nodes S) (pred (Pos.to_nat i)).
Proof.
  unfold is_shared. intros L. apply Nat.leb_le in L. pose proof enough as M. unfold size in M.
  destruct (common_begins (nodes S) (nodes S')) as (r & r' & A & B). fold shared_nodes in A, B.
  rewrite A, B. rewrite !nth_error_app1; trivial; lia.
Qed.
Lemma stands_shared v g : shared_claim g = true -> (stands S' v g <-> stands S v g).
Proof.
  unfold shared_claim. intros L. apply andb_prop in L. destruct L as [L R].
  unfold stands, value_at. rewrite !term_shared by assumption. tauto.
Qed.
Lemma holds_shared v g : shared_claim g = true -> (holds S' v g <-> holds S v g).
Proof.
  intros L. unfold holds. rewrite (stands_shared v g L). unfold shared_claim in L.
  apply andb_prop in L. destruct L as [L R].
  unfold defined_at. rewrite !term_shared by assumption. tauto.
Qed.

Lemma contexts_same c : (0 < c <= length (contexts S))%nat -> same_context c = true.
Proof.
  pose proof beginning as B. unfold begins in B. apply andb_prop in B. destruct B as [_ B].
  intros L. rewrite forallb_forall in B. apply B, in_seq. lia.
Qed.
Lemma givens_same v : forall l l', same_givens l l' = true -> (satisfies S' v l' <-> satisfies S v l).
Proof.
  unfold satisfies. induction l as [|a l IH]; intros [|a' l']; cbn [same_givens]; try discriminate.
  - intros _. split; constructor.
  - intros E. apply andb_prop in E. destruct E as [E G]. apply andb_prop in E. destruct E as [E L].
    apply same_claim_sound in E. specialize (IH l' G). pose proof (stands_shared v _ L) as M.
    rewrite !Forall_cons_iff, <- E. tauto.
Qed.
Lemma upwards_same : forall c j, (c <= length (contexts S))%nat -> upwards S' j c = upwards S j c.
Proof.
  intros c j. revert c. induction j as [|j IH]; intros [|c] L; cbn [upwards]; trivial. f_equal.
  pose proof (contexts_same (Datatypes.S c) ltac:(lia)) as E. unfold same_context in E.
  apply andb_prop in E. destruct E as [E _]. apply andb_prop in E. destruct E as [E B].
  apply Nat.eqb_eq in E. apply Nat.ltb_lt in B. rewrite <- E. apply IH. lia.
Qed.
Lemma upwards_below : forall j c k, (c <= length (contexts S))%nat -> In k (upwards S j c) ->
  (k <= length (contexts S))%nat.
Proof.
  induction j as [|j IH]; intros [|c] k L I; cbn [upwards In] in I; try (destruct I as [<-|[]]; lia).
  destruct I as [<-|I]; [lia|].
  pose proof (contexts_same (Datatypes.S c) ltac:(lia)) as E. unfold same_context in E.
  apply andb_prop in E. destruct E as [E _]. apply andb_prop in E. destruct E as [_ B].
  apply Nat.ltb_lt in B. apply IH in I; trivial. lia.
Qed.
Lemma scope_same c v : (c <= length (contexts S))%nat -> (scope S' c v <-> scope S c v).
Proof.
  intros L. unfold scope, around. rewrite (upwards_same c c L).
  assert (Q : forall k, In k (upwards S c c) ->
    (satisfies S' v (givens_of S' k) <-> satisfies S v (givens_of S k))).
  { intros k I. apply upwards_below in I; trivial. destruct k as [|k].
    - cbn. split; intros; constructor.
    - pose proof (contexts_same (Datatypes.S k) ltac:(lia)) as E. unfold same_context in E.
      apply andb_prop in E. destruct E as [_ E]. now apply givens_same. }
  split; intros A k I; apply (Q k I), A, I.
Qed.
Lemma fact_same c g : (c <= length (contexts S))%nat -> shared_claim g = true -> fact S c g ->
  fact S' c g.
Proof.
  intros L G A v V. apply (holds_shared v g G), A. now apply (scope_same c v L).
Qed.

Hypothesis true_cited : true_statement S.
Lemma own_good c : own c = true -> context_good S c.
Proof.
  destruct true_cited as (_ & Contexts & _). rewrite Forall_forall in Contexts.
  intros E. apply existsb_exists in E. destruct E as (d & I & E). apply Nat.eqb_eq in E.
  subst. now apply Contexts.
Qed.
Lemma constant_closed i : closes_constant i = true -> constant_defined S' i.
Proof.
  destruct true_cited as (Constants & _). rewrite Forall_forall in Constants. unfold closes_constant.
  intros C. apply andb_prop in C. destruct C as [E M]. apply andb_prop in E. destruct E as [E Sh].
  apply existsb_exists in E. destruct E as (j & J & E). apply Pos.eqb_eq in E. subst j.
  specialize (Constants i J). unfold constant_defined in *. rewrite (node_shared i Sh).
  destruct (nth_error _ _) as [[]|]; try discriminate. apply andb_prop in M. destruct M as [M L].
  apply Nat.leb_le in L. intros v V. unfold defined_at. rewrite (term_shared _ M).
  apply Constants. now apply (scope_same _ v L).
Qed.
Lemma fact_closed c g : proves c g = true -> fact S' c g.
Proof.
  destruct true_cited as (Constants & _ & Rows & _). rewrite Forall_forall in Constants, Rows.
  unfold proves. intros F. apply andb_prop in F. destruct F as [E F].
  apply andb_prop in E. destruct E as [G L]. apply Nat.leb_le in L. apply fact_same; trivial.
  apply orb_prop in F. destruct F as [F|F]; [apply orb_prop in F; destruct F as [F|F]|].
  - apply existsb_exists in F. destruct F as (r & J & F). specialize (Rows r J).
    unfold proves_row in F. unfold row_true in Rows. apply andb_prop in F. destruct F as [A B].
    apply Nat.eqb_eq in A. destruct (row_verdict r), (row_sentence r); try discriminate.
    apply same_claim_sound in B. subst. exact Rows.
  - apply existsb_exists in F. destruct F as (i & J & F). specialize (Constants i J).
    unfold proves_constant in F. apply andb_prop in F. destruct F as [_ F].
    unfold constant_defined in Constants.
    destruct (nth_error (nodes S) (pred (Pos.to_nat i))) as [[]|] eqn:E; try discriminate.
    apply andb_prop in F. destruct F as [A B]. apply Nat.eqb_eq in A. apply same_claim_sound in B.
    subst. replace (pred (Pos.to_nat i)) with (Pos.to_nat i - Pos.to_nat 1)%nat in E
      by (change (Pos.to_nat 1) with 1%nat; lia).
    rewrite <- nth_listed in E by lia. fold (numbered S) in E. intros v V.
    specialize (Constants v V).
    split; [|split]; trivial.
    + apply (defined_node S in_order v _ _ E). cbn [subterms proviso In]. split; trivial.
      now intros a [<-|[]].
    + unfold stands. cbn [related relation_of lhs rhs]. now rewrite (value_node S in_order v _ _ E).
  - apply andb_prop in F. destruct F as [O F]. apply existsb_exists in F.
    destruct F as (a & J & F). apply same_claim_sound in F. subst g.
    destruct (own_good c O) as [_ A]. intros v V. specialize (A v V). rewrite Forall_forall in A.
    now apply A.
Qed.
Lemma context_closed c : closes_context c = true -> context_good S' c.
Proof.
  unfold closes_context. intros O. apply andb_prop in O. destruct O as [M O].
  apply andb_prop in M. destruct M as [Z M]. apply Nat.leb_le in M. apply Nat.ltb_lt in Z.
  destruct (own_good c O) as [[v V] A]. split; [exists v; now apply (scope_same c v M)|].
  intros w W. apply (scope_same c w M) in W. specialize (A w W).
  destruct c as [|c]; [lia|]. pose proof (contexts_same (Datatypes.S c) ltac:(lia)) as E.
  unfold same_context in E. apply andb_prop in E. destruct E as [_ E]. clear - A E beginning.
  revert E. generalize (givens_of S' (Datatypes.S c)). revert A.
  induction (givens_of S (Datatypes.S c)) as [|a l IH]; intros A [|a' l']; cbn [same_givens];
    try discriminate; intros E; constructor.
  - apply andb_prop in E. destruct E as [E _]. apply andb_prop in E. destruct E as [E B].
    apply same_claim_sound in E. rewrite <- E. apply (holds_shared w _ B). now inversion A.
  - apply andb_prop in E. destruct E as [_ E]. apply IH; trivial. now inversion A.
Qed.
End Closing.

(* What a statement believes is proved by some others: each with the number of terms it shares. *)
Definition closes (l : list (statement * nat)) (S' : statement) : bool :=
  let by_one f := existsb (fun x : statement * nat => f (fst x) (snd x)) l in
  forallb (fun x => begins (fst x) S' (snd x)) l &&
  forallb (fun x => by_one (fun S m => proves S m (fst (snd x)) (snd (snd x)))) (cited S') &&
  forallb (fun i => by_one (fun S m => closes_constant S m i)) (cited_constants S') &&
  forallb (fun c => existsb (Nat.eqb c) (own_contexts S') || by_one (fun S _ => closes_context S c))
    (seq 1 (length (contexts S'))).
Theorem citations_closed l S' : closes l S' = true ->
  Forall (fun x => true_statement (fst x)) l -> citations_true S'.
Proof.
  unfold closes. intros C T. apply andb_prop in C. destruct C as [C Open]. apply andb_prop in C.
  destruct C as [C Values]. apply andb_prop in C. destruct C as [Begin Facts].
  rewrite forallb_forall in Begin, Open, Values, Facts. rewrite Forall_forall in T.
  split; [|split].
  - apply Forall_forall. intros i I. specialize (Values i I). apply existsb_exists in Values.
    destruct Values as ([S m] & J & V). eapply constant_closed; [apply (Begin _ J) | apply (T _ J) | exact V].
  - apply Forall_forall. intros x I. specialize (Facts x I). apply existsb_exists in Facts.
    destruct Facts as ([S m] & J & V). eapply fact_closed; [apply (Begin _ J) | apply (T _ J) | exact V].
  - intros c L. specialize (Open c ltac:(apply in_seq; lia)). apply orb_prop in Open.
    destruct Open as [O|O].
    + left. apply existsb_exists in O. destruct O as (d & I & E). apply Nat.eqb_eq in E. now subst.
    + right. apply existsb_exists in O. destruct O as ([S m] & J & V).
      eapply context_closed; [apply (Begin _ J) | apply (T _ J) | exact V].
Qed.
