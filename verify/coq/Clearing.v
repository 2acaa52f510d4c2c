(* Terms without fractions: each cleared term is equal to N/D, with D > 0, for two polynomials in
   atoms; and sums and products of what is known to be positive. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool FMapPositive.
From Verify Require Import Meaning Polynomials Terms Substitution.
Import ListNotations.
Open Scope R_scope.

(* Usable facts: by their names, or the hypotheses of the branches around, from 1 on inwards. *)
Inductive reference : Set := Fact (f : positive) | Hypothesis_ (k : nat).
(* What is >= 0 for all values in scope. *)
Inductive addend : Set :=
| Goal | Number (q : Q) | Known (f : reference) | Root (t : positive) | Square (t : positive)
| Sum (l : list addend) | Product (l : list addend) | Power (a : addend) (n : positive).

Record clearing := Clearing {
  cleared : PM.t quotient;
  squares : list (positive * quotient)  (* of roots, with their radicands; the latest first *)
}.
Definition nothing_cleared : clearing := Clearing (PM.empty quotient) [].
Definition levels : nat := 400.

Section Clear.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable knows : bool -> positive -> bool.  (* 0 < t (true), or 0 <= t (false), is usable *)
Variable is_defined : positive -> bool.  (* constants whose step is done *)
Variable replaced : PM.t positive.

Definition is_rational (i : positive) : option Q :=
  match PM.find i T with Some (NRational n d) => Some (Qmake n d) | _ => None end.
Definition remember (i : positive) (x : quotient) (s : clearing) : clearing :=
  Clearing (PM.add i x (cleared s)) (squares s).
Definition added (plus_ : polynomial -> polynomial -> polynomial) (x y : quotient) : quotient :=
  let (n, d) := x in
  let (m, e) := y in
  if same d e then (plus_ n m, d) else (plus_ (times n e) (times m d), times d e).
Definition divided (b : positive) (x y : quotient) : option quotient :=
  let (n, d) := x in
  let (m, e) := y in
  match is_rational b with
  | Some q => if Z.eqb (Qnum q) 0 then None else Some (times n (number (Qinv q)), d)
  | None =>
      if knows true b then Some (times n e, times d m)
      else let* o := find_node T K (NNeg b) in
        if knows true o then Some (times (opposite n) e, times d (opposite m)) else None
  end.
(* The logarithm of what is known to be positive, and the root of what is known to be nonnegative. *)
Definition positive_there (a : positive) : bool :=
  match is_rational a with Some q => Z.ltb 0 (Qnum q) | None => knows true a end.
Definition applies_there (f : elementary) (a : positive) : bool :=
  match f with Log => positive_there a | _ => true end.
Definition rooted (a : positive) : bool :=
  match is_rational a with
  | Some q => Z.leb 0 (Qnum q)
  | None => knows true a || knows false a
  end.
Definition parts (n : node) : list positive :=
  match n with NConstant _ _ => [] | _ => subterms n end.
Definition combined (i : positive) (n : node) (xs : list quotient) : option quotient :=
  match n, xs with
  | NRational n d, _ => Some (number (Qmake n d), one)
  | NVariable _, _ | NMin _ _, _ | NMax _ _, _ | NCos _, _ | NCosPi _, _ | NPi, _ =>
      Some (atom i, one)
  | NOf f a, _ => if applies_there f a then Some (atom i, one) else None
  | NConstant _ _, _ => if is_defined i then Some (atom i, one) else None
  | NSqrt a, _ => if rooted a then Some (atom i, one) else None
  | NAdd _ _, [x; y] => Some (added plus x y)
  | NSub _ _, [x; y] => Some (added minus x y)
  | NMul _ _, [(n, d); (m, e)] => Some (times n m, times d e)
  | NDiv _ b, [x; y] => divided b x y
  | NNeg _, [(n, d)] => Some (opposite n, d)
  | NPow _ k, [(n, d)] => Some (power n (Pos.to_nat k), power d (Pos.to_nat k))
  | _, _ => None
  end.
Definition with_square (i : positive) (n : node) (xs : list quotient) (s : clearing) : clearing :=
  match n, xs with
  | NSqrt _, [x] => Clearing (cleared s) ((i, x) :: squares s)
  | _, _ => s
  end.

Fixpoint clear (fuel : nat) (s : clearing) (i : positive) : option (quotient * clearing) :=
  match PM.find i (cleared s) with
  | Some x => Some (x, s)
  | None =>
      match fuel with
      | O => None
      | S fuel =>
          match PM.find i replaced with
          | Some j => let* (x, s1) := clear fuel s j in Some (x, remember i x s1)
          | None =>
              let* n := PM.find i T in
              let* (xs, s1) := each (clear fuel) s (parts n) in
              let* x := combined i n xs in
              Some (x, remember i x (with_square i n xs s1))
          end
      end
  end.
Definition difference (s : clearing) (a b : positive) : option (polynomial * clearing) :=
  let* (x, s1) := clear levels s a in
  let* (y, s2) := clear levels s1 b in
  Some (minus (times (fst x) (snd y)) (times (fst y) (snd x)), s2).

Variable usable : reference -> option claim.
Variable goal : polynomial * bool.
Definition signed : Type := option ((polynomial * bool) * clearing).
Section Each.
Variable f : addend -> clearing -> signed.
Variable join : polynomial -> polynomial -> polynomial.
Variable both : bool -> bool -> bool.
Fixpoint value_each (p : polynomial * bool) (s : clearing) (l : list addend) : signed :=
  match l with
  | [] => Some (p, s)
  | a :: r =>
      let* (q, s1) := f a s in
      value_each (join (fst p) (fst q), both (snd p) (snd q)) s1 r
  end.
End Each.
Fixpoint addend_value (a : addend) (s : clearing) : signed :=
  match a with
  | Goal => Some (goal, s)
  | Number q => if Z.leb 0 (Qnum q) then Some ((number q, Z.ltb 0 (Qnum q)), s) else None
  | Known f =>
      let* g := usable f in
      match relation_of g with
      | Less => let* (p, s1) := difference s (rhs g) (lhs g) in Some ((p, true), s1)
      | AtMost => let* (p, s1) := difference s (rhs g) (lhs g) in Some ((p, false), s1)
      | _ => None
      end
  | Root t =>
      match PM.find t T with
      | Some (NSqrt _) => let* (x, s1) := clear levels s t in Some ((fst x, false), s1)
      | _ => None
      end
  | Square t =>
      let* (x, s1) := clear levels s t in Some ((times (fst x) (fst x), false), s1)
  | Sum l => value_each addend_value plus orb ([], false) s l
  | Product l => value_each addend_value times andb (one, true) s l
  | Power b n =>
      let* (q, s1) := addend_value b s in
      Some ((power (fst q) (Pos.to_nat n), snd q), s1)
  end.

Definition reduce (s : clearing) (p : polynomial) : polynomial :=
  fold_left (fun p x => without_squares (fst x) (fst (snd x)) (snd (snd x)) p) (squares s) p.
Definition vanishes (s : clearing) (p : polynomial) : bool :=
  match reduce s p with [] => true | _ => false end.
End Clear.
