(* What a statement says. This is the page to read: terms, their values, when they are defined, when
   a claim holds, what contexts, rows and whole statements mean. Nothing here is computed. *)
From Coq Require Import Reals ZArith List FMapPositive.
Import ListNotations.
Module PM := PositiveMap.
Open Scope R_scope.

(* --- terms and their values ------------------------------------------------------------------- *)

Inductive elementary : Set := Exp | Log | Sin | Atan.

Inductive term : Set :=
| Rational (n : Z) (d : positive)
| Unknown (x : positive)
| Add (a b : term) | Sub (a b : term) | Mul (a b : term) | Div (a b : term) | Neg (a : term)
| Pow (a : term) (n : positive) | Sqrt (a : term)
| Min (a b : term) | Max (a b : term) | Cos (a : term) | CosPi (a : term)
| Pi | Of (f : elementary) (a : term).

(* The logarithm is the natural one, of positive numbers. *)
Definition applied (f : elementary) (x : R) : R :=
  match f with Exp => exp x | Log => ln x | Sin => sin x | Atan => atan x end.
Definition in_domain (f : elementary) (x : R) : Prop := match f with Log => 0 < x | _ => True end.

(* The values of the variables, by their numbers. *)
Definition valuation := positive -> R.

Fixpoint value (v : valuation) (t : term) : R :=
  match t with
  | Rational n d => IZR n / IZR (Zpos d)
  | Unknown x => v x
  | Add a b => value v a + value v b
  | Sub a b => value v a - value v b
  | Mul a b => value v a * value v b
  | Div a b => value v a / value v b
  | Neg a => - value v a
  | Pow a n => value v a ^ Pos.to_nat n
  | Sqrt a => sqrt (value v a)
  | Min a b => Rmin (value v a) (value v b)
  | Max a b => Rmax (value v a) (value v b)
  | Cos a => cos (value v a)
  | CosPi a => cos (PI * value v a)
  | Pi => PI
  | Of f a => applied f (value v a)
  end.

(* No division by 0, no root of a negative number, no logarithm of one that is not positive. *)
Fixpoint defined (v : valuation) (t : term) : Prop :=
  match t with
  | Rational _ _ | Unknown _ | Pi => True
  | Add a b | Sub a b | Mul a b | Min a b | Max a b => defined v a /\ defined v b
  | Div a b => defined v a /\ defined v b /\ value v b <> 0
  | Neg a | Pow a _ | Cos a | CosPi a => defined v a
  | Sqrt a => defined v a /\ 0 <= value v a
  | Of f a => defined v a /\ in_domain f (value v a)
  end.

(* --- terms by their numbers ------------------------------------------------------------------- *)

(* A file names each term once: the k-th node is the term number k, over earlier ones. A constant
   means its definition. Variables and constants belong to a context; 0 is the root. *)
Inductive node : Set :=
| NRational (n : Z) (d : positive)
| NVariable (c : nat) | NConstant (c : nat) (definition : positive)
| NAdd (a b : positive) | NSub (a b : positive) | NMul (a b : positive) | NDiv (a b : positive)
| NNeg (a : positive) | NPow (a : positive) (n : positive) | NSqrt (a : positive)
| NMin (a : positive) (l : list positive) | NMax (a : positive) (l : list positive)
| NCos (a : positive) | NCosPi (a : positive)
| NPi | NOf (f : elementary) (a : positive).

Definition undefined : term := Div (Rational 1 1) (Rational 0 1).

Section Trees.
Variable trees : PM.t term.
Definition tree_at (i : positive) : term :=
  match PM.find i trees with Some t => t | None => undefined end.
Definition tree (k : positive) (n : node) : term :=
  match n with
  | NRational n d => Rational n d
  | NVariable _ => Unknown k
  | NConstant _ a => tree_at a
  | NAdd a b => Add (tree_at a) (tree_at b)
  | NSub a b => Sub (tree_at a) (tree_at b)
  | NMul a b => Mul (tree_at a) (tree_at b)
  | NDiv a b => Div (tree_at a) (tree_at b)
  | NNeg a => Neg (tree_at a)
  | NPow a n => Pow (tree_at a) n
  | NSqrt a => Sqrt (tree_at a)
  | NMin a l => fold_right (fun x => Min (tree_at x)) (tree_at a) l
  | NMax a l => fold_right (fun x => Max (tree_at x)) (tree_at a) l
  | NCos a => Cos (tree_at a)
  | NCosPi a => CosPi (tree_at a)
  | NPi => Pi
  | NOf f a => Of f (tree_at a)
  end.
End Trees.

Fixpoint grow (k : positive) (ns : list node) (trees : PM.t term) : PM.t term :=
  match ns with
  | [] => trees
  | n :: rest => grow (Pos.succ k) rest (PM.add k (tree trees k n) trees)
  end.

(* --- claims ----------------------------------------------------------------------------------- *)

Inductive relation : Set := Less | AtMost | Equal | Differs.
Record claim : Set := Claim { relation_of : relation; lhs : positive; rhs : positive }.

Definition related (r : relation) (x y : R) : Prop :=
  match r with Less => x < y | AtMost => x <= y | Equal => x = y | Differs => x <> y end.

(* --- statements ------------------------------------------------------------------------------- *)

Inductive kind : Set := Plain | Carried | Standing.
Record given : Set := Given { given_name : positive; given_claim : claim; given_kind : kind }.

(* Numbers of variables, with the terms that are put for them. *)
Definition substitution := list (positive * positive).

Record context : Set := Context {
  parent : nat;  (* contexts are numbered from 1, and come after their parents; 0 is the root *)
  variables : list positive;
  givens : list given;
  point : substitution  (* over names of the parent; all givens hold there *)
}.

Inductive sentence : Set :=
| Compare (g : claim)
| Applies (c : nat) (at_ : substitution)
| Always (c : nat) (start next : substitution).

Inductive verdict : Set := Proved | Refuted | Undecided.
Record row : Set := Row { row_name : positive; row_context : nat; row_verdict : verdict;
                          row_needed : bool; row_sentence : sentence }.

Record statement : Set := Statement {
  nodes : list node;
  contexts : list context;
  own_contexts : list nat;  (* those that no citation brings *)
  constants : list positive;  (* likewise *)
  rows : list row;
  cited : list (positive * (nat * claim));  (* facts of cited statements, by their names *)
  cited_constants : list positive
}.

Section Meaning.
Variable S : statement.

Definition term_at : positive -> term := tree_at (grow 1 (nodes S) (PM.empty term)).
Definition value_at (v : valuation) (i : positive) : R := value v (term_at i).
Definition defined_at (v : valuation) (i : positive) : Prop := defined v (term_at i).

(* A claim stands if the relation does; it holds if both sides are defined, too. *)
Definition stands (v : valuation) (g : claim) : Prop :=
  related (relation_of g) (value_at v (lhs g)) (value_at v (rhs g)).
Definition holds (v : valuation) (g : claim) : Prop :=
  defined_at v (lhs g) /\ defined_at v (rhs g) /\ stands v g.
Definition fails (v : valuation) (g : claim) : Prop :=
  defined_at v (lhs g) /\ defined_at v (rhs g) /\ ~ stands v g.

(* A context and those around it, to the root. *)
Definition context_at (c : nat) : option context :=
  match c with O => None | Datatypes.S k => nth_error (contexts S) k end.
Definition parent_of (c : nat) : nat :=
  match context_at c with Some x => parent x | None => O end.
Definition givens_of (c : nat) : list given :=
  match context_at c with Some x => givens x | None => [] end.
Fixpoint upwards (steps : nat) (c : nat) : list nat :=
  match steps, c with
  | Datatypes.S k, Datatypes.S _ => c :: upwards k (parent_of c)
  | _, _ => [O]
  end.
Definition around (c : nat) : list nat := upwards c c.

(* The values satisfy the givens in scope. *)
Definition satisfies (v : valuation) (l : list given) : Prop :=
  Forall (fun a => stands v (given_claim a)) l.
Definition scope (c : nat) (v : valuation) : Prop :=
  forall k, In k (around c) -> satisfies v (givens_of k).
(* What a fact of a context says. *)
Definition fact (c : nat) (g : claim) : Prop := forall v, scope c v -> holds v g.

(* The valuation after terms are put for variables, all at once. *)
Fixpoint put (s : substitution) (x : positive) : option positive :=
  match s with [] => None | (y, t) :: r => if Pos.eqb x y then Some t else put r x end.
Definition after (v : valuation) (s : substitution) : valuation :=
  fun x => match put s x with Some t => value_at v t | None => v x end.
Definition all_defined (v : valuation) (s : substitution) : Prop :=
  Forall (fun xt => defined_at v (snd xt)) s.
(* The n-th state of a sequence that begins with ``start`` and goes on with ``next``. *)
Fixpoint state (v : valuation) (start next : substitution) (n : nat) : valuation :=
  match n with
  | O => after v start
  | Datatypes.S k => after (state v start next k) next
  end.
Definition standing (c : nat) : list given :=
  filter (fun a => match given_kind a with Standing => true | _ => false end) (givens_of c).

Definition says (c : nat) (s : sentence) : Prop :=
  match s with
  | Compare g => fact c g
  | Applies d at_ => forall v, scope c v -> all_defined v at_ /\ scope d (after v at_)
  | Always d start next =>
      forall v, scope c v -> all_defined v start /\
      forall n, (forall k, (k <= n)%nat -> satisfies (state v start next k) (standing d)) ->
        scope d (state v start next n) /\ all_defined (state v start next n) next
  end.
Definition row_true (r : row) : Prop :=
  match row_verdict r, row_sentence r with
  | Proved, s => says (row_context r) s
  | Refuted, Compare g => exists v, scope (row_context r) v /\ fails v g
  | Refuted, _ => False
  | Undecided, _ => True
  end.

Definition constant_defined (k : positive) : Prop :=
  match nth_error (nodes S) (pred (Pos.to_nat k)) with
  | Some (NConstant c a) => forall v, scope c v -> defined_at v a
  | _ => False
  end.
(* There are values, and for all that satisfy the givens these are defined. *)
Definition context_good (c : nat) : Prop :=
  (exists v, scope c v) /\
  (forall v, scope c v -> Forall (fun a => holds v (given_claim a)) (givens_of c)).

Definition true_statement : Prop :=
  Forall constant_defined (constants S) /\ Forall context_good (own_contexts S) /\
  Forall row_true (rows S) /\
  Forall (fun r => row_needed r = true -> row_verdict r = Proved) (rows S).
(* What is believed of the statements that are cited. *)
Definition citations_true : Prop :=
  Forall constant_defined (cited_constants S) /\
  Forall (fun x => fact (fst (snd x)) (snd (snd x))) (cited S) /\
  (forall c, (0 < c <= length (contexts S))%nat -> In c (own_contexts S) \/ context_good c).
End Meaning.
