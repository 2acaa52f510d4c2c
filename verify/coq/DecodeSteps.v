(* The steps of a certificate, in the words of Checker.v. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive.
From Verify Require Import Json ReadJson Meaning Terms Substitution Kernel Checker.
From Verify Require Import Decode DecodeTerms DecodeStatement DecodeProof.
Import ListNotations.
Open Scope N_scope.

(* --- proofs of rows ----------------------------------------------------------------------------- *)

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
      let! l := premises_in (spot_of c) found l in
      let! p := proof_in (spot_of c) found negation in
      ret (ByWitness at_ l p)
  | _, None => bad "a witness, but no variable"
  | _, _ => no_record
  end.
Definition row_proof_in (r : line) (x : json) : M row_proof :=
  let! rule := rule_of x in
  let here := spot_of (inside r) in
  match said r, applied_to r with
  | Applies _ at_, Some d =>
      if is "instance" rule then
        let! l := parts_of ["givens"]%string x in
        match l with
        | [l] =>
            let! sides := put_givens d at_ [] in
            let! l := premises_in here sides l in
            ret (ByInstance l)
        | _ => no_record
        end
      else bad "another rule is needed"
  | Always _ first after, Some d =>
      if is "induction" rule then
        let! l := parts_of ["start"; "next"]%string x in
        match l with
        | [start; later] =>
            let! sides := put_givens d first [] in
            let! start := premises_in here sides start in
            let! sides := put_givens d after [] in
            let! later := premises_in (spot_of d) sides later in
            ret (ByInduction start later)
        | _ => no_record
        end
      else bad "another rule is needed"
  | Compare g, _ =>
      if is "witness" rule && match state r with Refuted => true | _ => false end
      then by_witness r g x
      else let! p := proof_in here (sides_at g) x in ret (ByProof p)
  | _, _ => bad "another rule is needed"
  end.
Definition defining_in (x : json) : M defining :=
  let! rule := rule_of x in
  if is "define" rule then let! _ := parts_of [] x in ret ByClearing
  else if is "interval" rule then
    let! p := precision x in ret (ByInterval (fst p) (snd p))
  else bad "another rule is needed".

(* --- steps -------------------------------------------------------------------------------------- *)

Section Steps.
Variable rows : PM.t (positive * line).

(* The point of a context, of which the latest was read first. *)
Definition point_of (c : home) : M substitution :=
  let! l := get (fun k => contexts_found (o k)) in
  let! x := from (nth_error l (length l - nat_of c)) "no context" in
  ret (point x).
Definition open_step (x : json) : M step :=
  let! l := record ["open"; "givens"]%string x in
  match l with
  | [s; l] =>
      let! s := name s in
      let! c := find_place [] (Some s) in
      let! _ := once s in
      let! p := from (outside c) "no context" in
      let! p := home_number p in
      let! at_ := point_of c in
      let! sides := put_givens c at_ [] in
      let! l := premises_in (spot_of p) sides l in
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
      let! p := proof_in (spot_of c) (sides_at g) p in
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
