(* The rules, in the order of verify/check.py and under the same names. Sound.v proves
   them right. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool Arith FMapPositive.
From Verify Require Import Meaning Polynomials Terms Substitution Clearing Enclosures Functions Cosines.
Import ListNotations.
Open Scope R_scope.

(* --- proofs ----------------------------------------------------------------------------------- *)

Inductive side : Set := Left | Right.
Record bound : Set := Bound { bound_name : positive; bound_below : reference; bound_above : reference }.
Inductive proof : Set :=
| Given_ (f : reference)  (* a premise that is a usable fact *)
| Interval (bits : positive) (bounds : list bound)
| Cuts (t : positive) (points : list positive) (branches : list proof)
| Cases (t : positive) (branches : list proof)
| Entry (s : side) (equation : option reference)
| Least (s : side) (equation : option reference) (branches : list proof)
| PositiveRoot
| Antisymmetry (branches : list proof) | Angles | Cosine_
| BySum (replacements : list reference) (addends : list addend) (equations : list (reference * positive))
| Instance (of : positive) (at_ : substitution) (premises : list proof).

(* --- facts ------------------------------------------------------------------------------------ *)

Record facts := Facts {
  named : PM.t (nat * claim);
  positives : PM.t (list nat);  (* contexts in which 0 < t is a fact, by t *)
  nonnegatives : PM.t (list nat);
  having_values : PM.t nat  (* constants, with the context in which their definition has a value *)
}.
Definition no_facts : facts :=
  Facts (PM.empty _) (PM.empty _) (PM.empty _) (PM.empty _).

(* A context, and the hypotheses of the branches around, the outermost first. *)
Definition place : Set := (nat * list claim)%type.
Definition no_hypotheses (c : nat) : place := (c, []).
Definition branch (p : place) (more : list claim) : place := (fst p, snd p ++ more).

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

Section Paired.
Context {A : Type}.
Variable f : A -> proof -> bool.
(* Each thing that is to be proved with its proof. *)
Fixpoint paired (expected : list A) (proofs : list proof) {struct proofs} : bool :=
  match expected, proofs with
  | [], [] => true
  | x :: xs, p :: ps => f x p && paired xs ps
  | _, _ => false
  end.
Lemma paired_sound (Q : A -> Prop) ps :
  Forall (fun p => forall x, f x p = true -> Q x) ps ->
  forall xs, paired xs ps = true -> Forall Q xs.
Proof.
  induction 1 as [|p ps H _ IH]; intros [|x xs]; cbn [paired]; try discriminate; auto.
  intros E. apply andb_prop in E. destruct E. auto.
Qed.
End Paired.

Section Kernel.
Variable S : statement.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable H : PM.t nat.
Notation home := (home_in H).
Notation is_inside := (is_inside S).

Section Facts.
Variable F : facts.

Definition is_zero (i : positive) : bool :=
  match PM.find i T with Some (NRational Z0 _) => true | _ => false end.
Definition fact_at (p : place) (f : reference) : option claim :=
  match f with
  | Fact f =>
      let* (c, g) := PM.find f (named F) in
      if is_inside (fst p) c then Some g else None
  | Hypothesis_ O => None
  | Hypothesis_ (Datatypes.S k) => nth_error (snd p) k
  end.
Definition is_known (contexts : PM.t (list nat)) (p : place) (t : positive) : bool :=
  match PM.find t contexts with Some l => existsb (is_inside (fst p)) l | None => false end.
Definition knows (p : place) (strict : bool) (t : positive) : bool :=
  existsb (fun g => is_zero (lhs g) && Pos.eqb (rhs g) t &&
    same_relation (relation_of g) (if strict then Less else AtMost)) (snd p) ||
  is_known (if strict then positives F else nonnegatives F) p t.
Definition has_value (p : place) (i : positive) : bool :=
  match PM.find i (having_values F) with Some c => is_inside (fst p) c | None => false end.

(* --- clearing and enclosing at a place --- *)

Definition clear_at (p : place) := clear T K (knows p) (has_value p) (PM.empty positive).
Definition clears (p : place) (l : list positive) : bool :=
  match each (clear_at p levels) nothing_cleared l with Some _ => true | None => false end.

Definition memory := PM.t enclosure.
Variable grounds : list (positive * memory).  (* what is enclosed already, for some precisions *)
Definition ground (bits : positive) : memory :=
  match find (fun x => Pos.eqb bits (fst x)) grounds with
  | Some x => snd x
  | None => PM.empty enclosure
  end.
Definition operation (bits : positive) (n : node) (xs : list enclosure) : option enclosure :=
  match n, xs with
  | NRational n d, [] => Some (exact bits (Qmake n d))
  | NConstant _ _, [x] => Some x
  | NAdd _ _, [x; y] => Some (enclosed_add bits x y)
  | NSub _ _, [x; y] => Some (enclosed_sub bits x y)
  | NMul _ _, [x; y] => Some (enclosed_mul bits x y)
  | NDiv _ _, [x; y] => enclosed_div bits x y
  | NNeg _, [x] => Some (enclosed_neg x)
  | NPow _ k, [x] => Some (enclosed_power bits x k)
  | NSqrt _, [x] => enclosed_sqrt bits x
  | NMin _ _, x :: r => Some (fold_right (enclosed_min bits) x r)
  | NMax _ _, x :: r => Some (fold_right (enclosed_max bits) x r)
  | NCos _, [x] => Some (enclosed_cos bits x)
  | NCosPi _, [x] => Some (enclosed_cos_pi bits x)
  | NPi, [] => Some (Around (I.pi (p bits)))
  | NOf f _, [x] => enclosed_elementary bits f x
  | _, _ => None
  end.
Fixpoint enclose (bits : positive) (fuel : nat) (m : memory) (i : positive) :
  option (enclosure * memory) :=
  match PM.find i m with
  | Some x => Some (x, m)
  | None =>
      match fuel with
      | O => None
      | Datatypes.S fuel =>
          let* n := PM.find i T in
          let* (xs, m1) := each (enclose bits fuel) m (subterms n) in
          let* x := operation bits n xs in
          Some (x, PM.add i x m1)
      end
  end.
(* The term that a fact says is below a name, or above it. *)
Definition bounding (s : side) (name : positive) (g : claim) : option positive :=
  let (near, far) := match s with Left => (rhs g, lhs g) | Right => (lhs g, rhs g) end in
  match relation_of g with
  | Less | AtMost => if Pos.eqb near name then Some far else None
  | Equal => if Pos.eqb near name then Some far
             else if Pos.eqb far name then Some near else None
  | Differs => None
  end.
Definition is_name (i : positive) : bool :=
  match PM.find i T with Some (NVariable _ | NConstant _ _) => true | _ => false end.
Definition with_bound (bits : positive) (p : place) (m : memory) (b : bound) : option memory :=
  match PM.find (bound_name b) m with
  | Some _ => None
  | None =>
      if is_name (bound_name b) && negb (Nat.eqb (home (bound_name b)) 0) then
        let* g := fact_at p (bound_below b) in
        let* low := bounding Left (bound_name b) g in
        let* (x, m1) := enclose bits levels m low in
        let* h := fact_at p (bound_above b) in
        let* high := bounding Right (bound_name b) h in
        let* (y, m2) := enclose bits levels m1 high in
        let* z := enclosed_between bits x y in
        Some (PM.add (bound_name b) z m2)
      else None
  end.
Fixpoint enclosing (bits : positive) (p : place) (m : memory) (l : list bound) : option memory :=
  match l with
  | [] => Some m
  | b :: r => let* m1 := with_bound bits p m b in enclosing bits p m1 r
  end.

(* --- the rules --- *)

Definition interval_at (p : place) (g : claim) (bounds : list bound) (bits : positive) : bool :=
  match enclosing bits p (ground bits) bounds with
  | Some m =>
      match each (enclose bits levels) m [lhs g; rhs g] with
      | Some ([x; y], _) => decide bits (relation_of g) x y
      | _ => false
      end
  | None => false
  end.
(* A lower precision is often enough, and cheaper. *)
Definition at_some_precision (f : positive -> bool) (bits : positive) : bool :=
  if Pos.ltb 128 bits then f 128%positive || f bits else f bits.
Definition interval (p : place) (g : claim) (bits : positive) (bounds : list bound) : bool :=
  at_some_precision (interval_at p g bounds) bits.

Fixpoint increasing (low : Q) (l : list positive) : bool :=
  match l with
  | [] => true
  | i :: r =>
      match is_rational T i with
      | Some q => match Qcompare low q with Lt => increasing q r | _ => false end
      | None => false
      end
  end.
Definition good_points (l : list positive) : bool :=
  match l with
  | [] => false
  | i :: r => match is_rational T i with Some q => increasing q r | None => false end
  end.
Fixpoint pieces (t : positive) (low : list claim) (l : list positive) : list (list claim) :=
  match l with
  | [] => [low]
  | i :: r => (low ++ [Claim AtMost t i]) :: pieces t [Claim AtMost i t] r
  end.
Section Branches.
Variable prove : place -> claim -> proof -> bool.

Definition cuts (p : place) (g : claim) (t : positive) (points : list positive)
  (branches : list proof) : bool :=
  clears p [t] && good_points points &&
  paired (fun more => prove (branch p more) g) (pieces t [] points) branches.

Definition extremum_at (i : positive) : option (bool * list positive) :=
  match PM.find i T with
  | Some (NMin a l) => Some (true, a :: l)
  | Some (NMax a l) => Some (false, a :: l)
  | _ => None
  end.
(* Each item with the others. *)
Fixpoint picked (before l : list positive) : list (positive * list positive) :=
  match l with [] => [] | a :: r => (a, before ++ r) :: picked (before ++ [a]) r end.
Definition case (t : positive) (is_min : bool) (x : positive * list positive) : list claim :=
  Claim Equal t (fst x) ::
  map (fun o => if is_min then Claim AtMost (fst x) o else Claim AtMost o (fst x)) (snd x).
Definition cases (p : place) (g : claim) (t : positive) (branches : list proof) : bool :=
  match extremum_at t with
  | Some (is_min, l) =>
      clears p [t] && paired (fun x => prove (branch p (case t is_min x)) g) (picked [] l) branches
  | None => false
  end.

(* The minimum (true) or maximum on a side of a claim, its entries, and the other side. *)
Definition extremum (p : place) (g : claim) (s : side) (equation : option reference) :
  option (bool * list positive * positive) :=
  let (t, other) := match s with Left => (lhs g, rhs g) | Right => (rhs g, lhs g) end in
  if clears p [t; other] then
    let* u :=
      match equation with
      | None => Some t
      | Some f =>
          let* h := fact_at p f in
          if same_relation (relation_of h) Equal && Pos.eqb (lhs h) t && clears p [rhs h]
          then Some (rhs h) else None
      end in
    let* (is_min, l) := extremum_at u in
    Some (is_min, l, other)
  else None.
Definition is_left (s : side) : bool := match s with Left => true | Right => false end.
Definition entry (p : place) (g : claim) (s : side) (equation : option reference) : bool :=
  match extremum p g s equation with
  | Some (is_min, l, other) =>
      Bool.eqb is_min (is_left s) && same_relation (relation_of g) AtMost &&
      existsb (Pos.eqb other) l
  | None => false
  end.
Definition least (p : place) (g : claim) (s : side) (equation : option reference)
  (branches : list proof) : bool :=
  match extremum p g s equation with
  | Some (is_min, l, other) =>
      Bool.eqb is_min (negb (is_left s)) &&
      (same_relation (relation_of g) Less || same_relation (relation_of g) AtMost) &&
      paired (fun e => prove p (match s with
        | Left => Claim (relation_of g) e other
        | Right => Claim (relation_of g) other e end)) l branches
  | None => false
  end.

Definition root (p : place) (g : claim) : bool :=
  match PM.find (rhs g) T with
  | Some (NSqrt a) =>
      is_zero (lhs g) && same_relation (relation_of g) Less && knows p true a
  | _ => false
  end.

Definition antisymmetry (p : place) (g : claim) (branches : list proof) : bool :=
  same_relation (relation_of g) Equal &&
  paired (prove p) [Claim AtMost (lhs g) (rhs g); Claim AtMost (rhs g) (lhs g)] branches.

Definition is_atom (i : positive) : bool :=
  match PM.find i T with
  | Some (NVariable _ | NConstant _ _ | NSqrt _ | NMin _ _ | NMax _ _ | NCos _ | NCosPi _ | NPi
      | NOf _ _) => true
  | _ => false
  end.
Fixpoint replacing (p : place) (l : list reference) (m : PM.t positive) : option (PM.t positive) :=
  match l with
  | [] => Some m
  | f :: r =>
      let* g := fact_at p f in
      if same_relation (relation_of g) Equal && is_atom (lhs g) then
        match PM.find (lhs g) m with
        | Some _ => None
        | None => replacing p r (PM.add (lhs g) (rhs g) m)
        end
      else None
  end.
(* Multiples of what equations say is 0. *)
Fixpoint zeros (p : place) (m : PM.t positive) (s : clearing) (l : list (reference * positive)) :
  option (polynomial * clearing) :=
  match l with
  | [] => Some ([], s)
  | (f, cofactor) :: r =>
      let* g := fact_at p f in
      if same_relation (relation_of g) Equal then
        let* (x, s1) := clear T K (knows p) (has_value p) m levels s cofactor in
        let* (d, s2) := difference T K (knows p) (has_value p) m s1 (lhs g) (rhs g) in
        let* (z, s3) := zeros p m s2 r in
        Some (plus (times d (fst x)) z, s3)
      else None
  end.
Definition sum (p : place) (g : claim) (replacements : list reference) (addends : list addend)
  (equations : list (reference * positive)) : bool :=
  match replacing p replacements (PM.empty positive) with
  | None => false
  | Some m =>
      match difference T K (knows p) (has_value p) m nothing_cleared (lhs g) (rhs g) with
      | None => false
      | Some (goal, s1) =>
          match zeros p m s1 equations with
          | None => false
          | Some (z, s2) =>
              match relation_of g, addends with
              | Differs, _ => false
              | Equal, [] => vanishes s2 (minus goal z)
              | Equal, _ => false
              | r, _ =>
                  match addend_value T K (knows p) (has_value p) m (fact_at p)
                    (goal, same_relation r AtMost) (Sum addends) s2 with
                  | Some ((q, strict), s3) => vanishes s3 (plus q z) && strict
                  | None => false
                  end
              end
          end
      end
  end.

(* The claim at terms for the variables of a context. *)
Definition substituted (c : nat) (phi : PM.t positive) (g : claim) : option claim :=
  let* a := new_term S H c phi (lhs g) in
  let* b := new_term S H c phi (rhs g) in
  Some (Claim (relation_of g) a b).
Definition same_names (l : list positive) (s : substitution) : bool :=
  if list_eq_dec Pos.eq_dec l (map fst s) then true else false.
Definition variables_of (c : nat) : list positive :=
  match context_at S c with Some x => variables x | None => [] end.
(* Premises for some of the givens, at terms that have values. *)
Definition givens_hold (p : place) (c : nat) (at_ : substitution) (phi : PM.t positive)
  (l : list given) (premises : list proof) : bool :=
  negb (Nat.eqb c 0) && same_names (variables_of c) at_ && of_context T c at_ &&
  clears p (map snd at_) &&
  paired (fun a q => match substituted c phi (given_claim a) with
    | Some g => prove p g q
    | None => false end) l premises.
Definition phi_of (c : nat) (at_ : substitution) : PM.t positive :=
  new_terms S H T K c at_ (numbered S) (PM.empty positive).
Definition in_parent (p : place) (c : nat) : bool := is_inside (fst p) (parent_of S c).
Definition instance (p : place) (g : claim) (of : positive) (at_ : substitution)
  (premises : list proof) : bool :=
  match PM.find of (named F) with
  | None => false
  | Some (c, f) =>
      let phi := phi_of c at_ in
      in_parent p c && givens_hold p c at_ phi (givens_of S c) premises &&
      match substituted c phi f with Some h => same_claim h g | None => false end
  end.
End Branches.

Fixpoint prove (p : place) (g : claim) (q : proof) {struct q} : bool :=
  match q with
  | Given_ f => match fact_at p f with Some h => same_claim h g | None => false end
  | Interval bits bounds => interval p g bits bounds
  | Cuts t points branches => cuts prove p g t points branches
  | Cases t branches => cases prove p g t branches
  | Entry s e => entry p g s e
  | Least s e branches => least prove p g s e branches
  | PositiveRoot => root p g
  | Antisymmetry branches => antisymmetry prove p g branches
  | Angles => angles T K (knows p) (has_value p) g
  | Cosine_ => cosine T K (knows p) (has_value p) g
  | BySum u a e => sum p g u a e
  | Instance f s premises => instance prove p g f s premises
  end.
End Facts.
End Kernel.
