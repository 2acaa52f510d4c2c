(* What an accepted statement says in ordinary notation: terms are read back from their numbers,
   down to constants, which have names of their own. *)
From Coq Require Import Reals ZArith List Bool FMapPositive.
From Verify Require Import Meaning Terms.
Import ListNotations.
Open Scope R_scope.

(* A term as it is shown; ``Abbreviated`` are constants, and what lies too deep. *)
Inductive shape : Set :=
| Whole (n : Z) | Fraction (n : Z) (d : positive) | Named (x : positive) | Abbreviated (i : positive)
| Plus (a b : shape) | Minus (a b : shape) | Times (a b : shape) | Over (a b : shape)
| Opposite (a : shape) | ToThe (a : shape) (n : nat) | RootOf (a : shape)
| Smaller (a b : shape) | Larger (a b : shape) | CosOf (a : shape) | CosPiOf (a : shape)
| PiItself | Function (f : elementary) (a : shape).

Fixpoint read (T : PM.t node) (fuel : nat) (i : positive) : shape :=
  match fuel with
  | O => Abbreviated i
  | S fuel =>
      let r := read T fuel in
      match PM.find i T with
      | None | Some (NConstant _ _) => Abbreviated i
      | Some (NRational n 1) => Whole n
      | Some (NRational n d) => Fraction n d
      | Some (NVariable _) => Named i
      | Some (NAdd a b) => Plus (r a) (r b)
      | Some (NSub a b) => Minus (r a) (r b)
      | Some (NMul a b) => Times (r a) (r b)
      | Some (NDiv a b) => Over (r a) (r b)
      | Some (NNeg a) => Opposite (r a)
      | Some (NPow a n) => ToThe (r a) (Pos.to_nat n)
      | Some (NSqrt a) => RootOf (r a)
      | Some (NMin a l) => fold_right (fun x => Smaller (r x)) (r a) l
      | Some (NMax a l) => fold_right (fun x => Larger (r x)) (r a) l
      | Some (NCos a) => CosOf (r a)
      | Some (NCosPi a) => CosPiOf (r a)
      | Some NPi => PiItself
      | Some (NOf f a) => Function f (r a)
      end
  end.

Section Shown.
Variable S : statement.
(* The constants that are read so far, the latest first, as functions of the variables. *)
Definition values := list (positive * (valuation -> R)).
Fixpoint look_up (l : values) (i : positive) (v : valuation) : R :=
  match l with
  | [] => value_at S v i
  | (j, f) :: r => if Pos.eqb i j then f v else look_up r i v
  end.
Fixpoint show (l : values) (v : valuation) (t : shape) : R :=
  match t with
  | Whole n => IZR n
  | Fraction n d => IZR n / IZR (Zpos d)
  | Named x => v x
  | Abbreviated i => look_up l i v
  | Plus a b => show l v a + show l v b
  | Minus a b => show l v a - show l v b
  | Times a b => show l v a * show l v b
  | Over a b => show l v a / show l v b
  | Opposite a => - show l v a
  | ToThe a n => show l v a ^ n
  | RootOf a => sqrt (show l v a)
  | Smaller a b => Rmin (show l v a) (show l v b)
  | Larger a b => Rmax (show l v a) (show l v b)
  | CosOf a => cos (show l v a)
  | CosPiOf a => cos (PI * show l v a)
  | PiItself => PI
  | Function Exp a => exp (show l v a)
  | Function Log a => ln (show l v a)
  | Function Sin a => sin (show l v a)
  | Function Atan a => atan (show l v a)
  end.

Hypothesis in_order : ordered (numbered S) = true.
Variable T : PM.t node.
Hypothesis is_table : table (numbered S) = T.
Definition right_values (l : values) : Prop :=
  Forall (fun x => forall v, value_at S v (fst x) = snd x v) l.

Lemma look_up_right l i v : right_values l -> look_up l i v = value_at S v i.
Proof.
  induction 1 as [|[j f] l A _ IH]; cbn [look_up]; trivial.
  destruct (Pos.eqb_spec i j); trivial. subst. symmetry. apply A.
Qed.
Lemma read_right l v : right_values l -> forall fuel i, show l v (read T fuel i) = value_at S v i.
Proof.
  intros R. induction fuel as [|fuel IH]; intros i; cbn [read]; [now apply look_up_right|].
  destruct (PM.find i T) as [n|] eqn:E; [|now apply look_up_right].
  pose proof E as V. rewrite <- is_table in V. apply (value_node S in_order v) in V.
  destruct n; try (cbn [show]; rewrite ?IH; symmetry; exact V).
  - destruct d; try (symmetry; exact V). cbn [show]. rewrite V. cbn [node_value].
    unfold Rdiv. now rewrite Rinv_1, Rmult_1_r.
  - now apply look_up_right.
  - rewrite V. cbn [node_value]. clear V E.
    induction l0 as [|x l0 IHl]; cbn [fold_right show]; trivial. now rewrite IH, IHl.
  - rewrite V. cbn [node_value]. clear V E.
    induction l0 as [|x l0 IHl]; cbn [fold_right show]; trivial. now rewrite IH, IHl.
Qed.
(* One more constant: its definition is read with those before it. *)
Lemma one_more l i f t : right_values l ->
  match PM.find i T with Some (NConstant _ a) => read T 400 a | _ => Abbreviated i end = t ->
  (forall v, f v = show l v t) -> right_values ((i, f) :: l).
Proof.
  intros R E Q. constructor; trivial. cbn [fst snd]. intros v. rewrite Q, <- E.
  destruct (PM.find i T) as [[]|] eqn:F; cbn [show]; try (symmetry; now apply look_up_right).
  rewrite read_right by assumption. rewrite <- is_table in F.
  now rewrite (value_node S in_order v _ _ F).
Qed.

(* --- rows --- *)

Definition shown_claim : Set := (relation * shape * shape)%type.
Definition read_claim (g : claim) : shown_claim :=
  (relation_of g, read T 400 (lhs g), read T 400 (rhs g)).
Definition shown (l : values) (v : valuation) (g : shown_claim) : Prop :=
  related (fst (fst g)) (show l v (snd (fst g))) (show l v (snd g)).
Lemma read_claim_right l v g : right_values l -> (shown l v (read_claim g) <-> stands S v g).
Proof.
  intros R. unfold shown, read_claim, stands. cbn [fst snd]. rewrite !read_right by assumption.
  tauto.
Qed.
(* The givens in scope, the outermost first, and the claim of a row. *)
Definition read_row (k : nat) : option (verdict * list shown_claim * shown_claim) :=
  match nth_error (rows S) k with
  | Some (Row _ c verdict _ (Compare g)) =>
      Some (verdict,
        map (fun a => read_claim (given_claim a)) (flat_map (givens_of S) (rev (around S c))),
        read_claim g)
  | _ => None
  end.
Fixpoint implied (l : values) (v : valuation) (hypotheses : list shown_claim) (g : Prop) : Prop :=
  match hypotheses with [] => g | h :: r => shown l v h -> implied l v r g end.
Fixpoint also (l : values) (v : valuation) (hypotheses : list shown_claim) (g : Prop) : Prop :=
  match hypotheses with [] => g | h :: r => shown l v h /\ also l v r g end.

Hypothesis true_rows : Forall (row_true S) (rows S).
Lemma scope_shown l v c : right_values l ->
  (Forall (shown l v)
     (map (fun a => read_claim (given_claim a)) (flat_map (givens_of S) (rev (around S c)))) <->
   scope S c v).
Proof.
  intros R. rewrite Forall_map, Forall_forall. unfold scope, satisfies. split.
  - intros A k K. apply Forall_forall. intros a I. apply (read_claim_right l v _ R), A.
    apply in_flat_map. exists k. split; trivial. now apply -> in_rev.
  - intros A a I. apply in_flat_map in I. destruct I as (k & K & I). apply in_rev in K.
    specialize (A k K). rewrite Forall_forall in A. now apply (read_claim_right l v _ R), A.
Qed.
Lemma proved_row l k hs g : right_values l -> read_row k = Some (Proved, hs, g) ->
  forall v, implied l v hs (shown l v g).
Proof.
  unfold read_row. intros R E v. destruct (nth_error (rows S) k) as [r|] eqn:N; try discriminate.
  apply nth_error_In in N. pose proof true_rows as A. rewrite Forall_forall in A. apply A in N.
  destruct r as [n c [] b [h| |]]; try discriminate. injection E as <- <-.
  cbn [row_true row_verdict row_sentence row_context] in N.
  assert (Q : forall hs, (Forall (shown l v) hs -> shown l v (read_claim h)) ->
    implied l v hs (shown l v (read_claim h))).
  { induction hs as [|x hs IH]; cbn [implied]; auto. }
  apply Q. intros F. apply (scope_shown l v c R) in F. destruct (N v F) as (_ & _ & M).
  now apply read_claim_right.
Qed.
Lemma row_in_scope l k hs g v : right_values l -> read_row k = Some (Proved, hs, g) ->
  match nth_error (rows S) k with Some r => scope S (row_context r) v | None => False end ->
  shown l v g.
Proof.
  unfold read_row. intros R E I. destruct (nth_error (rows S) k) as [r|] eqn:N; try discriminate.
  apply nth_error_In in N. pose proof true_rows as A. rewrite Forall_forall in A. apply A in N.
  destruct r as [n c [] b [h| |]]; try discriminate. injection E as <- <-.
  cbn [row_true row_verdict row_sentence row_context] in *. destruct (N v I) as (_ & _ & M).
  now apply read_claim_right.
Qed.
(* A row about a whole context, in the words of Meaning.v. *)
Lemma said_row k c s :
  match nth_error (rows S) k with Some (Row _ d Proved _ t) => Some (d, t) | _ => None end =
  Some (c, s) -> says S c s.
Proof.
  intros E. destruct (nth_error (rows S) k) as [r|] eqn:N; try discriminate.
  apply nth_error_In in N. pose proof true_rows as A. rewrite Forall_forall in A. apply A in N.
  destruct r as [n d [] b t]; try discriminate. now injection E as <- <-.
Qed.
Lemma refuted_row l k hs g : right_values l -> read_row k = Some (Refuted, hs, g) ->
  exists v, also l v hs (~ shown l v g).
Proof.
  unfold read_row. intros R E. destruct (nth_error (rows S) k) as [r|] eqn:N; try discriminate.
  apply nth_error_In in N. pose proof true_rows as A. rewrite Forall_forall in A. apply A in N.
  destruct r as [n c [] b [h| |]]; try discriminate. injection E as <- <-.
  cbn [row_true row_verdict row_sentence row_context] in N. destruct N as (v & F & _ & _ & M).
  exists v. apply (scope_shown l v c R) in F.
  assert (Q : forall hs, Forall (shown l v) hs -> also l v hs (~ shown l v (read_claim h))).
  { induction 1; cbn [also]; auto. now rewrite read_claim_right. }
  now apply Q.
Qed.
End Shown.
