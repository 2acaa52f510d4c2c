(* The statement of a file, with what it cites, in the words of Meaning.v. `statement_of` is what a
   statement.json means; its last nodes may be followed by those that a certificate adds. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive.
From Verify Require Import Json ReadJson Meaning Terms Substitution Decode DecodeTerms.
Import ListNotations.
Open Scope N_scope.

(* A row, with what a certificate needs of it: its context, and that of its claim if it has one. *)
Record line := Line {
  title : list byte;
  inside : home;
  state : verdict;
  needed : bool;
  said : sentence;
  applied_to : option home
}.
Definition nat_of (c : home) : nat := N.to_nat (number (spot_of c)).
Definition is_own (prefix : list byte) : bool := match prefix with [] => true | _ => false end.
Definition member_of (l : list (list byte)) (s : list byte) : bool := existsb (same s) l.

(* --- constants ---------------------------------------------------------------------------------- *)

Definition cite (s : list byte) (c : home) (g : claim) : M unit :=
  with_output (fun o => Output (contexts_found o) ((fact s, (nat_of c, g)) :: cited_found o)
    (cited_constants_found o) (constants_found o) (own_found o) (often o)).
Definition constant (prefix : list byte) (c : home) (s : list byte) (x : json) : M unit :=
  let full := prefix ++ s in
  let! d := scoped prefix (spot_of c) x in
  let! i := new_name full (spot_of c) (Some d) in
  let g := Claim Equal i d in
  let! _ := remember full (spot_of c) g in
  if is_own prefix then
    with_output (fun o => Output (contexts_found o) (cited_found o) (cited_constants_found o)
      ((s, i) :: constants_found o) (own_found o) (often o))
  else
    let! _ := cite full c g in
    with_output (fun o => Output (contexts_found o) (cited_found o) (i :: cited_constants_found o)
      (constants_found o) (own_found o) (often o)).
(* The names of the constants in a list. *)
Definition constants_in (prefix : list byte) (c : home) (x : json) : M (list (list byte)) :=
  let! l := items_of x in
  all (fun item =>
    let! l := record ["name"; "label"; "letter"; "tex"; "term"]%string item in
    match l with
    | [s; label; letter; tex; d] =>
        let! _ := texts [label; letter; tex] in
        let! s := name s in
        let! _ := constant prefix c s d in
        ret s
    | _ => no_record
    end) l.

(* --- contexts ----------------------------------------------------------------------------------- *)

Definition kinds : list (string * kind) :=
  [("plain", Plain); ("carried", Carried); ("standing", Standing)]%string.
Definition put_home (c : home) : M unit :=
  with_names (fun m => set_homes (places m)
    (PM.add (N.succ_pos (number (spot_of c))) c (homes_found m)) (contexts_count m) m).
Definition new_place (s : list byte) (parent : home) : M home :=
  let! _ := introduce s in
  let! many := get (fun k => contexts_count (n k)) in
  let i := many + 1 in
  let p := spot_of parent in
  let! _ := need (depth p <? 100) "more than 100 contexts" in
  let c := Home (Spot i (depth p + 1) (i :: within p)) (Some (number p)) [] [] in
  let! _ := with_names (fun m =>
    set_homes (PM.add (fact s) i (places m)) (homes_found m) i m) in
  let! _ := put_home c in
  ret c.
Definition variable (prefix : list byte) (c : home) (x : json) : M (list byte * positive) :=
  let! l := record ["name"; "letter"; "tex"]%string x in
  match l with
  | [s; letter; tex] =>
      let! _ := texts [letter; tex] in
      let! s := name s in
      let! i := new_name (prefix ++ s) (spot_of c) None in
      ret (s, i)
  | _ => no_record
  end.
Definition given_of (prefix : list byte) (assumptions : list (list byte)) (c : home) (x : json)
    : M given :=
  let! l := record ["name"; "claim"; "kind"; "assumption"]%string x in
  match l with
  | [s; g; which; assumption] =>
      let! g := claim_in prefix (spot_of c) g in
      let! which := among kinds which in
      let! assumption := optional name assumption in
      let! _ := match which, assumption with
        | Standing, Some a => need (member_of assumptions a) "no such assumption"
        | Standing, None => bad "a standing given without an assumption"
        | _, None => ret tt
        | _, Some _ => bad "an assumption of a given that is not standing"
        end in
      let! s := name s in
      let full := prefix ++ s in
      let! _ := introduce full in
      let! _ := remember full (spot_of c) g in
      ret (Given (fact full) g which)
  | _ => no_record
  end.
Definition context_of (prefix : list byte) (assumptions : list (list byte)) (x : json) : M unit :=
  let! l := record
    ["name"; "parent"; "says"; "variables"; "givens"; "point"; "constants"]%string x in
  match l with
  | [s; parent; says; variables; givens; point; constants] =>
      let! _ := str says in
      let! s := name s in
      let! parent := optional name parent in
      let! parent := find_place prefix parent in
      let! c := new_place (prefix ++ s) parent in
      let! variables := items_of variables in
      let! own := all (variable prefix c) variables in
      let c := Home (spot_of c) (outside c) own [] in
      let! givens := items_of givens in
      let! givens := all (given_of prefix assumptions c) givens in
      let c := Home (spot_of c) (outside c) own givens in
      let! _ := put_home c in
      let! at_ := values prefix c (spot_of parent) point in
      let! _ := put_givens c at_ [] in
      let new := Context (nat_of parent) (map snd own) givens at_ in
      let! _ := with_output (fun o => Output (new :: contexts_found o)
        (if is_own prefix then cited_found o
         else rev_append (map (fun a => (given_name a, (nat_of c, given_claim a))) givens)
           (cited_found o))
        (cited_constants_found o) (constants_found o)
        (if is_own prefix then nat_of c :: own_found o else own_found o) (often o)) in
      let! _ := constants_in prefix c constants in
      ret tt
  | _ => no_record
  end.

(* --- rows --------------------------------------------------------------------------------------- *)

Definition verdicts : list (string * verdict) :=
  [("proved", Proved); ("refuted", Refuted); ("undecided", Undecided)]%string.
Definition roles : list (string * bool) := [("needed", true); ("printed", false)]%string.
Definition sentence_of (prefix : list byte) (c : home) (x : json) : M (sentence * option home) :=
  let compared := let! g := claim_in prefix (spot_of c) x in ret (Compare g, None) in
  match x with
  | JList (JStr word :: args) =>
      if is "applies" word then
        match args with
        | [d; at_] =>
            let! d := long_name d in
            let! d := find_place prefix (Some d) in
            let! at_ := values prefix d (spot_of c) at_ in
            let! _ := put_givens d at_ [] in
            ret (Applies (nat_of d) at_, Some d)
        | _ => bad "expected a claim"
        end
      else if is "always" word then
        match args with
        | [d; start; later] =>
            let! d := long_name d in
            let! d := find_place prefix (Some d) in
            let! start := values prefix d (spot_of c) start in
            let! later := values prefix d (spot_of d) later in
            let! _ := put_givens d start [] in
            let! _ := put_givens d later [] in
            ret (Always (nat_of d) start later, Some d)
        | _ => bad "expected a claim"
        end
      else compared
  | _ => compared
  end.
Definition row_of (prefix : list byte) (assumptions : list (list byte)) (x : json) : M line :=
  let! l := record ["name"; "context"; "group"; "label"; "role"; "severity"; "says"; "claim";
                    "verdict"; "uses"; "corrected_by"]%string x in
  match l with
  | [s; context; group; label; role; severity; says; claim; verdict; uses; corrected_by] =>
      let! _ := texts [group; label; says] in
      let! _ := optional str severity in
      let! _ := optional str corrected_by in
      let! s := name s in
      let! context := optional name context in
      let! c := find_place prefix context in
      let! role := among roles role in
      let! decided := among verdicts verdict in
      let! uses := items_of uses in
      let! _ := all (fun a =>
        let! a := name a in need (member_of assumptions a) "no such assumption") uses in
      let! (says, d) := sentence_of prefix c claim in
      let proved := match decided with Proved => true | _ => false end in
      let! _ := need (proved || match d with None => true | _ => false end)
        "a claim about a context has to be proved" in
      let full := prefix ++ s in
      let! _ := introduce full in
      let! _ := match says with
        | Compare g =>
            let! _ := remember full (spot_of c) g in
            if negb (is_own prefix) && proved then cite full c g else ret tt
        | _ => ret tt
        end in
      ret (Line s c decided role says d)
  | _ => no_record
  end.

(* --- statements --------------------------------------------------------------------------------- *)

Definition assumption_of (x : json) : M (list byte) :=
  let! l := record ["name"; "kind"; "label"; "sentence"]%string x in
  match l with
  | [s; kind; label; words] => let! _ := texts [kind; label; words] in name s
  | _ => no_record
  end.
Fixpoint no_text_twice (l : list (list byte)) : bool :=
  match l with [] => true | s :: l => negb (member_of l s) && no_text_twice l end.
Definition statement_keys : list string :=
  ["format"; "theorem"; "title"; "parameters"; "terms"; "constants"; "contexts"; "obligations";
   "assumptions"; "cites"]%string.
Definition has_format (x : json) (format : string) : M unit :=
  match x with JStr s => need (is format s) "format" | _ => bad "format" end.

Section Cited.
(* The text of a cited statement, by its digest. *)
Variable cited : list byte -> option (list byte).

Definition parsed (text : list byte) : M json :=
  from (document text) "no JSON as the format has it: UTF-8 of at most 4 MiB, no key twice, at most 100 nested brackets, and natural numbers below 10^9".
(* The rows, and the names of the constants of the root. `deep` bounds how statements cite each other:
   each citation makes names longer, and no name has more than 1000 bytes. *)
Definition deepest : nat := N.to_nat 1000.
Fixpoint statement_in (deep : nat) (prefix : list byte) (x : json)
    : M (list line * list (list byte)) :=
  let! l := record statement_keys x in
  match l with
  | [format; theorem; title; parameters; terms; constants; contexts; rows; assumptions; cites] =>
      let! _ := has_format format "verify-statement/2" in
      let! _ := texts [theorem; title] in
      let! cites := items_of cites in
      let! _ := all (fun item =>
        let! l := record ["name"; "theorem"; "statement_sha256"]%string item in
        match l with
        | [s; theorem; hash] =>
            let! s := name s in
            let! hash := digest hash in
            let! _ := introduce (prefix ++ s) in
            let! inner := from (cited hash) "a cited statement is not at hand" in
            let! inner := parsed inner in
            let! l := record statement_keys inner in
            let! wanted := str theorem in
            let! _ := need (match l with _ :: JStr found :: _ => same found wanted | _ => false end)
              "a cited statement with another title" in
            match deep with
            | O => bad "more than 1000 statements cite each other"
            | Datatypes.S less =>
                let! _ := statement_in less (prefix ++ s ++ [":"%byte]) inner in ret tt
            end
        | _ => no_record
        end) cites in
      let! assumptions := items_of assumptions in
      let! assumptions := all assumption_of assumptions in
      let! _ := need (no_text_twice assumptions) "an assumption twice" in
      let! root := home_number 0 in
      let! parameters := members_of parameters in
      let! _ := all (fun item =>
        let! _ := name (JStr (fst item)) in scoped prefix (spot_of root) (snd item)) parameters in
      let! _ := all (fun item => constant prefix root (fst item) (snd item)) parameters in
      let! _ := share prefix terms in
      let! own := constants_in prefix root constants in
      let! contexts := items_of contexts in
      let! _ := all (context_of prefix assumptions) contexts in
      let! terms := members_of terms in
      let! _ := all (fun item => term prefix (JStr (fst item))) terms in
      let! rows := items_of rows in
      let! lines := all (row_of prefix assumptions) rows in
      ret (lines, map fst parameters ++ own)
  | _ => no_record
  end.
End Cited.

(* The statement, when all is read. *)
Definition row_in (r : line) : row :=
  Row (fact (title r)) (nat_of (inside r)) (state r) (needed r) (said r).
Definition statement_from (k : kernel) (lines : list line) : statement :=
  Statement (rev_append (made (t k)) []) (rev_append (contexts_found (o k)) [])
    (rev_append (own_found (o k)) []) (map snd (constants_found (o k))) (map row_in lines)
    (rev_append (cited_found (o k)) []) (cited_constants_found (o k)).
(* What a statement.json means. *)
Definition statement_of (cited : list byte -> option (list byte)) (x : json) : option statement :=
  match statement_in cited deepest [] x nothing with
  | Ok (lines, _) k => Some (statement_from k lines)
  | Bad _ _ => None
  end.
