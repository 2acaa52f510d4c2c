(* What Meaning.v says, equation by equation: this file fails to compile if a definition there comes
   to mean something else. Each line is true by computation. Nothing is imported from Meaning but
   its names, and the numbers are Coq's own. *)
From Coq Require Import Reals ZArith List FMapPositive.
From Verify Require Meaning.
Module M := Verify.Meaning.
Import ListNotations.
Open Scope R_scope.

(* --- there is nothing else of a kind ----------------------------------------------------------- *)

Check (fun r => match r with M.Less | M.AtMost | M.Equal | M.Differs => tt end).
Check (fun k => match k with M.Plain | M.Carried | M.Standing => tt end).
Check (fun t => match t with M.Proved | M.Refuted | M.Undecided => tt end).
Check (fun s => match s with M.Compare _ | M.Applies _ _ | M.Always _ _ _ => tt end).

(* --- terms ------------------------------------------------------------------------------------ *)

Section Terms.
Variable v : positive -> R.
Notation value := (M.value v).
Notation defined := (M.defined v).
Check (fun n d => eq_refl : value (M.Rational n d) = IZR n / IZR (Zpos d)).
Check (fun x => eq_refl : value (M.Unknown x) = v x).
Check (fun a b => eq_refl : value (M.Add a b) = value a + value b).
Check (fun a b => eq_refl : value (M.Sub a b) = value a - value b).
Check (fun a b => eq_refl : value (M.Mul a b) = value a * value b).
Check (fun a b => eq_refl : value (M.Div a b) = value a / value b).
Check (fun a => eq_refl : value (M.Neg a) = - value a).
Check (fun a n => eq_refl : value (M.Pow a n) = value a ^ Pos.to_nat n).
Check (fun a => eq_refl : value (M.Sqrt a) = sqrt (value a)).
Check (fun a b => eq_refl : value (M.Min a b) = Rmin (value a) (value b)).
Check (fun a b => eq_refl : value (M.Max a b) = Rmax (value a) (value b)).
Check (fun a => eq_refl : value (M.Cos a) = cos (value a)).
Check (fun a => eq_refl : value (M.CosPi a) = cos (PI * value a)).
Check (eq_refl : value M.Pi = PI).
Check (fun a => eq_refl : value (M.Of M.Exp a) = exp (value a)).
Check (fun a => eq_refl : value (M.Of M.Log a) = ln (value a)).
Check (fun a => eq_refl : value (M.Of M.Sin a) = sin (value a)).
Check (fun a => eq_refl : value (M.Of M.Atan a) = atan (value a)).
Check (fun n a => eq_refl : value (M.Of (M.NthRoot n) a) = M.nth_root n (value a)).
Check (fun n x => eq_refl : M.nth_root n x =
  if Rlt_dec 0 x then Rpower x (/ IZR (Zpos n)) else 0).

Check (fun n d => eq_refl : defined (M.Rational n d) = True).
Check (fun x => eq_refl : defined (M.Unknown x) = True).
Check (fun a b => eq_refl : defined (M.Add a b) = (defined a /\ defined b)).
Check (fun a b => eq_refl : defined (M.Sub a b) = (defined a /\ defined b)).
Check (fun a b => eq_refl : defined (M.Mul a b) = (defined a /\ defined b)).
Check (fun a b => eq_refl : defined (M.Div a b) = (defined a /\ defined b /\ value b <> 0)).
Check (fun a => eq_refl : defined (M.Neg a) = defined a).
Check (fun a n => eq_refl : defined (M.Pow a n) = defined a).
Check (fun a => eq_refl : defined (M.Sqrt a) = (defined a /\ 0 <= value a)).
Check (fun a b => eq_refl : defined (M.Min a b) = (defined a /\ defined b)).
Check (fun a b => eq_refl : defined (M.Max a b) = (defined a /\ defined b)).
Check (fun a => eq_refl : defined (M.Cos a) = defined a).
Check (fun a => eq_refl : defined (M.CosPi a) = defined a).
Check (eq_refl : defined M.Pi = True).
Check (fun a => eq_refl : defined (M.Of M.Exp a) = (defined a /\ True)).
Check (fun a => eq_refl : defined (M.Of M.Log a) = (defined a /\ 0 < value a)).
Check (fun a => eq_refl : defined (M.Of M.Sin a) = (defined a /\ True)).
Check (fun a => eq_refl : defined (M.Of M.Atan a) = (defined a /\ True)).
Check (fun n a => eq_refl : defined (M.Of (M.NthRoot n) a) = (defined a /\ 0 <= value a)).
End Terms.

(* A node stands for a term over the terms that earlier nodes stand for. *)
Section Nodes.
Variable trees : PositiveMap.t M.term.
Variable k : positive.
Notation at_ i := (M.tree_at trees i).
Notation tree := (M.tree trees k).
Check (fun i => eq_refl : at_ i =
  match PositiveMap.find i trees with
  | Some t => t | None => M.Div (M.Rational 1 1) (M.Rational 0 1) end).
Check (fun n d => eq_refl : tree (M.NRational n d) = M.Rational n d).
Check (fun c => eq_refl : tree (M.NVariable c) = M.Unknown k).
Check (fun c a => eq_refl : tree (M.NConstant c a) = at_ a).
Check (fun a b => eq_refl : tree (M.NAdd a b) = M.Add (at_ a) (at_ b)).
Check (fun a b => eq_refl : tree (M.NSub a b) = M.Sub (at_ a) (at_ b)).
Check (fun a b => eq_refl : tree (M.NMul a b) = M.Mul (at_ a) (at_ b)).
Check (fun a b => eq_refl : tree (M.NDiv a b) = M.Div (at_ a) (at_ b)).
Check (fun a => eq_refl : tree (M.NNeg a) = M.Neg (at_ a)).
Check (fun a n => eq_refl : tree (M.NPow a n) = M.Pow (at_ a) n).
Check (fun a => eq_refl : tree (M.NSqrt a) = M.Sqrt (at_ a)).
Check (fun a => eq_refl : tree (M.NMin a []) = at_ a).
Check (fun a b l => eq_refl : tree (M.NMin a (b :: l)) = M.Min (at_ b) (tree (M.NMin a l))).
Check (fun a => eq_refl : tree (M.NMax a []) = at_ a).
Check (fun a b l => eq_refl : tree (M.NMax a (b :: l)) = M.Max (at_ b) (tree (M.NMax a l))).
Check (fun a => eq_refl : tree (M.NCos a) = M.Cos (at_ a)).
Check (fun a => eq_refl : tree (M.NCosPi a) = M.CosPi (at_ a)).
Check (eq_refl : tree M.NPi = M.Pi).
Check (fun f a => eq_refl : tree (M.NOf f a) = M.Of f (at_ a)).
Check (eq_refl : M.grow k [] trees = trees).
Check (fun n rest => eq_refl : M.grow k (n :: rest) trees =
  M.grow (Pos.succ k) rest (PositiveMap.add k (M.tree trees k n) trees)).
End Nodes.

(* --- claims, contexts ------------------------------------------------------------------------- *)

Check (fun x y => eq_refl : M.related M.Less x y = (x < y)).
Check (fun x y => eq_refl : M.related M.AtMost x y = (x <= y)).
Check (fun x y => eq_refl : M.related M.Equal x y = (x = y)).
Check (fun x y => eq_refl : M.related M.Differs x y = (x <> y)).

Section Statements.
Variable S : M.statement.
Variable v : positive -> R.
Notation term i := (M.tree_at (M.grow 1 (M.nodes S) (PositiveMap.empty M.term)) i).
Notation valued i := (M.value v (term i)).
Notation has_value i := (M.defined v (term i)).
Notation scope := (M.scope S).
Check (fun r a b => eq_refl : M.stands S v (M.Claim r a b) = M.related r (valued a) (valued b)).
Check (fun r a b => eq_refl : M.holds S v (M.Claim r a b) =
  (has_value a /\ has_value b /\ M.related r (valued a) (valued b))).
Check (fun r a b => eq_refl : M.fails S v (M.Claim r a b) =
  (has_value a /\ has_value b /\ ~ M.related r (valued a) (valued b))).

Check (eq_refl : M.context_at S 0 = None).
Check (fun k => eq_refl : M.context_at S (Datatypes.S k) = nth_error (M.contexts S) k).
Check (fun c => eq_refl : M.parent_of S c =
  match M.context_at S c with Some x => M.parent x | None => O end).
Check (fun c => eq_refl : M.givens_of S c =
  match M.context_at S c with Some x => M.givens x | None => [] end).
Check (fun c => eq_refl : M.upwards S 0 c = [O]).
Check (fun k => eq_refl : M.upwards S (Datatypes.S k) 0 = [O]).
Check (fun k c => eq_refl : M.upwards S (Datatypes.S k) (Datatypes.S c) =
  Datatypes.S c :: M.upwards S k (M.parent_of S (Datatypes.S c))).
Check (fun p x g q => eq_refl : (M.parent (M.Context p x g q), M.variables (M.Context p x g q),
  M.givens (M.Context p x g q), M.point (M.Context p x g q)) = (p, x, g, q)).
Check (fun n g t => eq_refl : (M.given_claim (M.Given n g t), M.given_kind (M.Given n g t)) = (g, t)).
Check (fun c => eq_refl : scope c v = (forall k, In k (M.upwards S c c) ->
  Forall (fun a => M.stands S v (M.given_claim a)) (M.givens_of S k))).
Check (fun c g => eq_refl : M.fact S c g = (forall w, scope c w -> M.holds S w g)).

Check (fun x => eq_refl : M.put [] x = None).
Check (fun x y t s => eq_refl : M.put ((y, t) :: s) x = if Pos.eqb x y then Some t else M.put s x).
Check (fun s => eq_refl : M.after S v s =
  (fun x => match M.put s x with Some t => valued t | None => v x end)).
Check (fun s => eq_refl : M.all_defined S v s = Forall (fun xt => has_value (snd xt)) s).
Check (fun start next => eq_refl : M.state S v start next 0 = M.after S v start).
Check (fun start next n => eq_refl : M.state S v start next (Datatypes.S n) =
  M.after S (M.state S v start next n) next).
Check (fun c => eq_refl : M.standing S c = filter (fun a =>
  match M.given_kind a with M.Plain => false | M.Carried => false | M.Standing => true end)
  (M.givens_of S c)).

(* --- rows, statements ------------------------------------------------------------------------- *)

Check (fun c g => eq_refl : M.says S c (M.Compare g) = M.fact S c g).
Check (fun c d s => eq_refl : M.says S c (M.Applies d s) =
  (forall w, scope c w -> M.all_defined S w s /\ scope d (M.after S w s))).
Check (fun c d start next => eq_refl : M.says S c (M.Always d start next) =
  (forall w, scope c w -> M.all_defined S w start /\
   forall n, (forall k, (k <= n)%nat -> Forall (fun a =>
       M.stands S (M.state S w start next k) (M.given_claim a)) (M.standing S d)) ->
     scope d (M.state S w start next n) /\ M.all_defined S (M.state S w start next n) next)).
Check (fun n c b s => eq_refl : M.row_true S (M.Row n c M.Proved b s) = M.says S c s).
Check (fun n c b g => eq_refl : M.row_true S (M.Row n c M.Refuted b (M.Compare g)) =
  (exists w, scope c w /\ M.fails S w g)).
Check (fun n c b d s => eq_refl : M.row_true S (M.Row n c M.Refuted b (M.Applies d s)) = False).
Check (fun n c b d s t => eq_refl : M.row_true S (M.Row n c M.Refuted b (M.Always d s t)) = False).
Check (fun n c b s => eq_refl : M.row_true S (M.Row n c M.Undecided b s) = True).
Check (fun n c t b s => eq_refl : (M.row_needed (M.Row n c t b s), M.row_verdict (M.Row n c t b s)) =
  (b, t)).

Check (fun k => eq_refl : M.constant_defined S k =
  match nth_error (M.nodes S) (pred (Pos.to_nat k)) with
  | Some (M.NConstant c a) => forall w, scope c w -> M.defined_at S w a
  | _ => False end).
Check (fun i => eq_refl : M.defined_at S v i = has_value i).
Check (fun c => eq_refl : M.context_good S c = ((exists w, scope c w) /\
  (forall w, scope c w -> Forall (fun a => M.holds S w (M.given_claim a)) (M.givens_of S c)))).
Check (eq_refl : M.true_statement S = (
  Forall (M.constant_defined S) (M.constants S) /\
  Forall (M.context_good S) (M.own_contexts S) /\
  Forall (M.row_true S) (M.rows S) /\
  Forall (fun r => M.row_needed r = true -> M.row_verdict r = M.Proved) (M.rows S))).
Check (eq_refl : M.citations_true S = (
  Forall (M.constant_defined S) (M.cited_constants S) /\
  Forall (fun x => M.fact S (fst (snd x)) (snd (snd x))) (M.cited S) /\
  (forall c, (0 < c <= length (M.contexts S))%nat ->
    In c (M.own_contexts S) \/ M.context_good S c))).
Check (fun a b c d e f g => let s := M.Statement a b c d e f g in eq_refl :
  (M.nodes s, M.contexts s, M.own_contexts s, M.constants s, M.rows s, M.cited s,
    M.cited_constants s) = (a, b, c, d, e, f, g)).
End Statements.
