(* The proofs of a certificate, in the words of Kernel.v. Its terms are numbered after those of the
   statement. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive.
From Verify Require Import Json ReadJson Meaning Terms Substitution Clearing Rising Kernel.
From Verify Require Import Decode DecodeTerms.
Import ListNotations.
Open Scope N_scope.

Definition reference_in (x : json) : M reference :=
  let! s := str x in
  match s with
  | "@"%byte :: d =>
      let! i := from (exponent_of d) "a hypothesis" in ret (Hypothesis_ (Pos.to_nat i))
  | _ => let! s := long_name x in ret (Fact (fact s))
  end.
Definition bound_in (x : json) : M bound :=
  match x with
  | JList [s; low; high] =>
      let! s := long_name s in
      let! e := get (fun k => PM.find (fact s) (entries (n k))) in
      match e with
      | Some (DecodeTerms.Known i) =>
          let! low := reference_in low in
          let! high := reference_in high in
          ret (Bound i low high)
      | _ => bad_name "no name " s
      end
  | _ => bad "bounds"
  end.
Definition bounds_in (x : json) : M (list bound) := let! l := items_of x in all bound_in l.

(* What is added up for the rule sum. *)
Fixpoint addend_in (c : spot) (x : json) {struct x} : M addend :=
  match x with
  | JStr s =>
      if is "goal" s then ret Goal
      else match rational_of s with
      | Some q => ret (Number q)
      | None => let! f := reference_in x in ret (Clearing.Known f)
      end
  | JList (JStr op :: args) =>
      if is "add" op then let! l := over (addend_in c) [] args in ret (Sum l)
      else if is "mul" op then let! l := over (addend_in c) [] args in ret (Product l)
      else match args with
      | [a] =>
          if is "square" op then let! a := scoped [] c a in ret (Square a)
          else if is "root" op then let! a := scoped [] c a in ret (Root a)
          else bad "expected a value"
      | [a; e] =>
          if is "pow" op then
            let! e := exponent e in
            let! a := addend_in c a in
            ret (Power a e)
          else bad "expected a value"
      | _ => bad "expected a value"
      end
  | _ => bad "expected a value"
  end.
Definition sides : list (string * side) := [("lhs", Left); ("rhs", Right)]%string.
Definition equation_in (c : spot) (x : json) : M (reference * positive) :=
  match x with
  | JList [f; t] =>
      let! f := reference_in f in
      let! t := scoped [] c t in
      ret (f, t)
  | _ => bad "equations"
  end.

(* --- rules -------------------------------------------------------------------------------------- *)

Definition rule_of (x : json) : M (list byte) :=
  match x with
  | JObj l =>
      match find_key (list_byte_of_string "rule") l with Some (JStr s) => ret s | _ => bad "rule" end
  | JInt _ => ret (list_byte_of_string "interval")
  | _ => bad "rule"
  end.
(* The values of a proof with these keys besides the rule. *)
Definition parts_of (keys : list string) (x : json) : M (list json) :=
  let! l := record ("rule"%string :: keys) x in ret (tl l).

(* Bits alone are a proof by enclosures without bounds. *)
Definition precision (x : json) : M (positive * list bound) :=
  match x with
  | JInt _ => let! b := bits_in x in ret (b, [])
  | _ =>
      let! l := parts_of ["bits"; "bounds"]%string x in
      match l with
      | [b; l] => let! b := bits_in b in let! l := bounds_in l in ret (b, l)
      | _ => no_record
      end
  end.

Section ReadRules.
Variable c : spot.
(* The sides of the claim that is proved. *)
Variable sides_of : list positive.
(* What has proofs inside is given the functions that read them; premises have other sides. *)
Variable branches_in : json -> M (list proof).
Variable premise_in : list positive -> json -> M proof.

Definition interval (x : json) : M proof := let! p := precision x in ret (Interval (fst p) (snd p)).
Definition cuts (x : json) : M proof :=
  let! l := parts_of ["term"; "at"; "branches"]%string x in
  match l with
  | [a; points; l] =>
      let! a := scoped [] c a in
      let! points := items_of points in
      let! points := all (fun q =>
        let! q := str q in let! q := rational q in put_rational q) points in
      let! l := branches_in l in
      let! _ := need (Nat.eqb (length l) (Datatypes.S (length points)) || Nat.eqb (length points) 0)
        "too many or too few branches" in
      ret (Cuts a points l)
  | _ => no_record
  end.
Definition cases (x : json) : M proof :=
  let! l := parts_of ["of"; "branches"]%string x in
  match l with
  | [a; l] => let! a := scoped [] c a in let! l := branches_in l in ret (Cases a l)
  | _ => no_record
  end.
Definition entry_rule (x : json) : M proof :=
  let! l := parts_of ["side"; "equation"]%string x in
  match l with
  | [s; e] =>
      let! s := among sides s in let! e := optional reference_in e in ret (Entry s e)
  | _ => no_record
  end.
Definition least (x : json) : M proof :=
  let! l := parts_of ["side"; "equation"; "branches"]%string x in
  match l with
  | [s; e; l] =>
      let! s := among sides s in
      let! e := optional reference_in e in
      let! l := branches_in l in
      ret (Least s e l)
  | _ => no_record
  end.
Definition antisymmetry (x : json) : M proof :=
  let! l := parts_of ["branches"]%string x in
  match l with
  | [l] =>
      let! l := branches_in l in
      let! _ := need (Nat.eqb (length l) 2) "too many or too few branches" in
      ret (Antisymmetry l)
  | _ => no_record
  end.
Definition alone (p : proof) (x : json) : M proof := let! _ := parts_of [] x in ret p.
(* The law of half turns names pi, which no side has to name. *)
Definition law (x : json) : M proof :=
  let! _ := parts_of [] x in
  let! _ := put_node NPi in
  ret Law.
Definition functions : list (string * rising) :=
  [("exp", Elementary Exp); ("log", Elementary Log); ("atan", Elementary Atan);
   ("sqrt", SquareRoot)]%string.
(* The premise is about values of a function at the sides, or about the arguments of both. *)
Definition monotony (x : json) : M proof :=
  let! l := parts_of ["under"; "premise"]%string x in
  match l with
  | [under; premise] =>
      let! under := optional (among functions) under in
      let! sides := match under with
        | Some f => all (fun t => put_node (applied_node f t)) sides_of
        | None =>
            let! l := all (fun t => let! x := info_at t in ret (subterms (node_of x))) sides_of in
            ret (concat l)
        end in
      let! p := premise_in sides premise in
      ret (Monotony under p)
  | _ => no_record
  end.
Definition sum (x : json) : M proof :=
  let! l := parts_of ["using"; "addends"; "equations"]%string x in
  match l with
  | [facts; addends; equations] =>
      let! facts := items_of facts in
      let! replacements := all reference_in facts in
      let! equations := items_of equations in
      let! equations := all (equation_in c) equations in
      let! addends := items_of addends in
      let! addends := all (addend_in c) addends in
      ret (BySum replacements addends equations)
  | _ => no_record
  end.
Definition instance (x : json) : M proof :=
  let! l := parts_of ["of"; "at"; "givens"]%string x in
  match l with
  | [of_; at_; l] =>
      let! s := long_name of_ in
      let! g := get (fun k => PM.find (fact s) (known (n k))) in
      match g with
      | Some (d, g) =>
          let! d := home_number d in
          let! at_ := values [] d c at_ in
          let! sides := put_givens d at_ [g] in
          let! l := items_of l in
          let! l := all (premise_in sides) l in
          ret (Instance (fact s) at_ l)
      | None => bad_name "no fact " s
      end
  | _ => no_record
  end.

(* The rules, by their names in files. *)
Definition rules : list (string * (json -> M proof)) :=
  [("interval", interval); ("cuts", cuts); ("cases", cases); ("entry", entry_rule);
   ("least", least); ("root", alone PositiveRoot); ("antisymmetry", antisymmetry);
   ("angles", alone Angles); ("cosine", alone Cosine_);
   ("range", alone Range); ("law", law); ("monotony", monotony); ("sum", sum); ("instance", instance)]%string.
End ReadRules.

(* A document has at most 100 nested brackets, so that `fuel` of 100 is enough. *)
Fixpoint proof_with (fuel : nat) (c : spot) (sides : list positive) (x : json) : M proof :=
  match fuel with
  | O => bad "a proof of more than 100 levels"
  | Datatypes.S less =>
      let! s := rule_of x in
      let branches x := let! l := items_of x in all (proof_with less c sides) l in
      let premise sides x :=
        match x with
        | JStr _ => let! f := reference_in x in ret (Given_ f)
        | _ => proof_with less c sides x
        end in
      match choice (rules c sides branches premise) s with
      | Some read => read x
      | None => bad_name "no rule here: " s
      end
  end.
Definition proof_in : spot -> list positive -> json -> M proof := proof_with 100.
Definition sides_at (g : claim) : list positive := [lhs g; rhs g].
(* Proofs of claims that have these sides. *)
Definition premises_in (c : spot) (sides : list positive) (x : json) : M (list proof) :=
  let! l := items_of x in
  all (fun x => match x with
    | JStr _ => let! f := reference_in x in ret (Given_ f)
    | _ => proof_in c sides x
    end) l.
