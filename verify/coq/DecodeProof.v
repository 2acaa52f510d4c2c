(* The certificate of a file, in the words of Checker.v: its proofs, steps and enclosures. Its terms
   are numbered after those of the statement. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive MSets.MSetPositive.
From Verify Require Import Json ReadJson Meaning Terms Substitution Clearing Kernel Checker.
From Verify Require Import Decode DecodeTerms DecodeStatement.
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
  | _ => bad "rule"
  end.
(* The values of a proof with these keys besides the rule. *)
Definition parts_of (keys : list string) (x : json) : M (list json) :=
  let! l := record ("rule"%string :: keys) x in ret (tl l).

Section Rules.
Variable c : spot.
(* What has proofs inside is given the function that reads them. *)
Variable branches_in : json -> M (list proof).
Variable premises_in : json -> M (list proof).

Definition interval (x : json) : M proof :=
  let! l := parts_of ["bits"; "bounds"]%string x in
  match l with
  | [b; l] => let! b := bits_in b in let! l := bounds_in l in ret (Interval b l)
  | _ => no_record
  end.
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
          let! _ := put_givens d at_ [g] in
          let! l := premises_in l in
          ret (Instance (fact s) at_ l)
      | None => bad_name "no fact " s
      end
  | _ => no_record
  end.

(* The rules, by their names in files. *)
Definition rules : list (string * (json -> M proof)) :=
  [("interval", interval); ("cuts", cuts); ("cases", cases); ("entry", entry_rule);
   ("least", least); ("root", alone PositiveRoot); ("antisymmetry", antisymmetry);
   ("angles", alone Angles); ("cosine", alone Cosine_); ("sum", sum); ("instance", instance)]%string.
End Rules.

(* A document has at most 100 nested brackets, so that `fuel` of 100 is enough. *)
Fixpoint proof_with (fuel : nat) (c : spot) (x : json) : M proof :=
  match fuel with
  | O => bad "a proof of more than 100 levels"
  | Datatypes.S less =>
      let! s := rule_of x in
      let branches x := let! l := items_of x in all (proof_with less c) l in
      let premises x :=
        let! l := items_of x in
        all (fun x => match x with
          | JStr _ => let! f := reference_in x in ret (Given_ f)
          | _ => proof_with less c x
          end) l in
      match choice (rules c branches premises) s with
      | Some read => read x
      | None => bad_name "no rule here: " s
      end
  end.
Definition proof_in : spot -> json -> M proof := proof_with 100.
Definition premises_in (c : spot) (x : json) : M (list proof) :=
  let! l := items_of x in
  all (fun x => match x with
    | JStr _ => let! f := reference_in x in ret (Given_ f)
    | _ => proof_in c x
    end) l.

(* --- steps -------------------------------------------------------------------------------------- *)

Definition by_witness (r : line) (g : claim) (x : json) : M row_proof :=
  let! l := parts_of ["at"; "givens"; "negation"]%string x in
  match l, outside (inside r) with
  | [at_; l; negation], Some c =>
      let! c := home_number c in
      let! at_ := values [] (inside r) (spot_of c) at_ in
      let! found := put_givens (inside r) at_ [g] in
      let! _ := if number (spot_of c) =? 0
        then with_output (fun o => Output (contexts_found o) (cited_found o)
          (cited_constants_found o) (constants_found o) (own_found o) (found ++ often o))
        else ret tt in
      let! l := premises_in (spot_of c) l in
      let! p := proof_in (spot_of c) negation in
      ret (ByWitness at_ l p)
  | _, None => bad "a witness, but no variable"
  | _, _ => no_record
  end.
Definition row_proof_in (r : line) (x : json) : M row_proof :=
  let! rule := rule_of x in
  let here := spot_of (inside r) in
  match said r, applied_to r with
  | Applies _ _, _ =>
      if is "instance" rule then
        let! l := parts_of ["givens"]%string x in
        match l with [l] => let! l := premises_in here l in ret (ByInstance l) | _ => no_record end
      else bad "another rule is needed"
  | Always _ _ _, Some d =>
      if is "induction" rule then
        let! l := parts_of ["start"; "next"]%string x in
        match l with
        | [start; later] =>
            let! start := premises_in here start in
            let! later := premises_in (spot_of d) later in
            ret (ByInduction start later)
        | _ => no_record
        end
      else bad "another rule is needed"
  | Compare g, _ =>
      if is "witness" rule && match state r with Refuted => true | _ => false end
      then by_witness r g x
      else let! p := proof_in here x in ret (ByProof p)
  | _, _ => bad "another rule is needed"
  end.
Definition defining_in (x : json) : M defining :=
  let! rule := rule_of x in
  if is "define" rule then let! _ := parts_of [] x in ret ByClearing
  else if is "interval" rule then
    let! l := parts_of ["bits"; "bounds"]%string x in
    match l with
    | [b; l] => let! b := bits_in b in let! l := bounds_in l in ret (ByInterval b l)
    | _ => no_record
    end
  else bad "another rule is needed".

Section Steps.
Variable rows : PM.t (positive * line).

Definition open_step (x : json) : M step :=
  let! l := record ["open"; "givens"]%string x in
  match l with
  | [s; l] =>
      let! s := name s in
      let! c := find_place [] (Some s) in
      let! _ := once s in
      let! p := from (outside c) "no context" in
      let! p := home_number p in
      let! l := premises_in (spot_of p) l in
      ret (Open_ (nat_of c) l)
  | _ => no_record
  end.
Definition lemma_step (x : json) : M step :=
  let! l := record ["lemma"; "context"; "claim"; "proof"]%string x in
  match l with
  | [s; c; g; p] =>
      let! c := optional long_name c in
      let! c := find_place [] c in
      let! s := name s in
      let! _ := introduce s in
      let! g := claim_in [] (spot_of c) g in
      let! p := proof_in (spot_of c) p in
      let! _ := remember s (spot_of c) g in
      ret (Lemma_ (fact s) (nat_of c) g p)
  | _ => no_record
  end.
Definition obligation_step (x : json) : M step :=
  let! l := record ["obligation"; "proof"]%string x in
  match l with
  | [s; p] =>
      let! s := name s in
      match PM.find (fact s) rows with
      | Some (i, r) =>
          let! _ := once s in
          let! _ := need match state r with Undecided => false | _ => true end
            "a proof of an undecided row" in
          let! p := row_proof_in r p in
          ret (Obligation i p)
      | None => bad_name "no row " s
      end
  | _ => no_record
  end.
Definition constant_step (x : json) : M step :=
  let! l := record ["constant"; "proof"]%string x in
  match l with
  | [s; p] =>
      let! s := name s in
      let! i := get (fun k => find_key s (constants_found (o k))) in
      match i with
      | Some i =>
          let! _ := once s in
          let! d := defining_in p in
          ret (Constant_ (fact s) i d)
      | None => bad_name "no constant " s
      end
  | _ => no_record
  end.
Definition define_step (x : json) : M step :=
  let! l := record ["define"; "context"; "term"; "proof"]%string x in
  match l with
  | [s; c; d; p] =>
      let! c := optional long_name c in
      let! c := find_place [] c in
      let! s := name s in
      let! d := scoped [] (spot_of c) d in
      let! i := new_name s (spot_of c) (Some d) in
      let! _ := remember s (spot_of c) (Claim Equal i d) in
      let! p := defining_in p in
      ret (Constant_ (fact s) i p)
  | _ => no_record
  end.
(* The steps, by the key that says which one it is. *)
Definition steps_by_key : list (string * (json -> M step)) :=
  [("obligation", obligation_step); ("lemma", lemma_step); ("constant", constant_step);
   ("define", define_step); ("open", open_step)]%string.
Definition step_in (x : json) : M step :=
  let has w := match x with
    | JObj l => match find_key (list_byte_of_string w) l with Some _ => true | None => false end
    | _ => false
    end in
  match filter (fun s => has (fst s)) steps_by_key with
  | [(_, read)] => read x
  | _ => bad "steps: expected one of obligation, lemma, constant, define, open"
  end.
End Steps.
