(* The enclosures of a certificate, and the certificate as a whole, beside its statement. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive MSets.MSetPositive.
From Verify Require Import Json ReadJson Meaning Terms Substitution Clearing Kernel Checker.
From Verify Require Import Decode DecodeTerms DecodeStatement DecodeSteps.
Import ListNotations.
Open Scope N_scope.

(* --- enclosures --------------------------------------------------------------------------------- *)

Definition ends_in (i bits : positive) (x : json) : M ends :=
  match x with
  | JList [low; high] =>
      let! low := decimal low in
      let! high := decimal high in
      let! _ := need (Qle_bool low high) "ends in no order" in
      ret (Ends i bits low high)
  | _ => bad "two decimals"
  end.
(* The rows of which both sides are to be enclosed. *)
Definition wanted_rows (lines : list line) : M (list (list byte * claim)) :=
  let! l := all (fun r =>
    match said r, state r with
    | Compare g, Undecided => ret []
    | Compare g, _ =>
        let! a := spot_at (lhs g) in
        let! b := spot_at (rhs g) in
        ret (if (number a =? 0) && (number b =? 0) then [(title r, g)] else [])
    | _, _ => ret []
    end) lines in
  ret (concat l).
Definition enclosures_in (lines : list line) (own : list (list byte)) (x : json) : M (list ends) :=
  let! l := record ["constants"; "rows"]%string x in
  match l with
  | [constants; sides] =>
      let why := "unknown names in enclosures"%string in
      let! constants := members_of constants in
      let! sides := members_of sides in
      let! wanted := wanted_rows lines in
      let! known := get (fun k => constants_found (o k)) in
      let own_constants := filter (fun x => member_of own (fst x)) known in
      let! first := all (fun item =>
        let! i := from (find_key (fst item) own_constants) why in
        let! l := record ["bits"; "ends"]%string (snd item) in
        match l with
        | [bits; x] => let! bits := bits_in bits in ends_in i bits x
        | _ => no_record
        end) constants in
      let! second := all (fun item =>
        let! g := from (find_key (fst item) wanted) why in
        let! l := record ["bits"; "lhs"; "rhs"]%string (snd item) in
        match l with
        | [bits; x; y] =>
            let! bits := bits_in bits in
            let! x := ends_in (lhs g) bits x in
            let! y := ends_in (rhs g) bits y in
            ret [x; y]
        | _ => no_record
        end) sides in
      ret (first ++ concat second)
  | _ => no_record
  end.

(* --- both files --------------------------------------------------------------------------------- *)

Definition positives_once (l : list positive) : list positive :=
  PositiveSet.elements (fold_left (fun s i => PositiveSet.add i s) l PositiveSet.empty).
(* What is to be enclosed once, for each precision. *)
Definition shared_terms (often constants : list positive) (l : list ends)
    : list (positive * list positive) :=
  map (fun bits => (bits, if (bits =? 128)%positive
      then positives_once (often ++ map enclosed l) else constants))
    (positives_once (128%positive :: map ends_bits l)).
Definition certificate_in (hash : list byte) (lines : list line) (own : list (list byte)) (x : json)
    : M certificate :=
  let! l := record ["format"; "statement_sha256"; "terms"; "steps"; "enclosures"]%string x in
  match l with
  | [format; of_; terms; steps; enclosures] =>
      let! _ := has_format format "verify-certificate/2" in
      let! of_ := digest of_ in
      let! _ := need (same of_ hash) "the certificate of another statement" in
      let! _ := need (existsb needed lines) "no needed row" in
      let! _ := share [] terms in
      let rows := table (map (fun x => (fact (title (snd x)), x)) (listed 1 lines)) in
      let! steps := items_of steps in
      let! steps := all (step_in rows) steps in
      let! l := enclosures_in lines own enclosures in
      let! known := get (fun k => constants_found (o k)) in
      let! constants := all (fun s => from (find_key s known) "no constant") own in
      let! often := get (fun k => often (o k)) in
      ret (Certificate (shared_terms often constants l) steps l)
  | _ => no_record
  end.
