(* What the words of a statement.json mean, by examples that Coq computes: each operation, relation,
   kind and verdict; which names are in scope; and a whole statement that cites another. Coq's
   libraries are imported last: no name of ours hides one of theirs. *)
From Verify Require Import Json ReadJson Meaning Terms Decode DecodeTerms DecodeStatement.
From Verify Require JsonRead.
From Coq Require Import Bool String ZArith QArith Strings.Byte FMapPositive List.
Import ListNotations.
Open Scope positive_scope.

Definition bytes : string -> list byte := list_byte_of_string.
(* A document, with ' in place of quotation marks. *)
Definition text (w : string) : list byte :=
  map (fun b => if Byte.eqb b "'"%byte then """"%byte else b) (bytes w).
Definition read {A} (f : json -> M A) (w : string) (k : kernel) : option (A * kernel) :=
  match document (text w) with
  | Some x => match f x k with Ok found k => Some (found, k) | Bad _ _ => None end
  | None => None
  end.
(* What a document is, is what is read. *)
Check (JsonRead.document_reads : forall s v, document s = Some v <-> Document s v).
Definition absent {A} (x : option A) : bool := match x with None => true | Some _ => false end.
Definition named (w : string) : positive := DecodeTerms.fact (bytes w).

(* --- terms and claims --------------------------------------------------------------------------- *)

(* The variables x and y are the terms 1 and 2. *)
Definition two_variables : kernel :=
  match (let! x := new_name (bytes "x") root None in new_name (bytes "y") root None) nothing with
  | Ok _ k => k
  | Bad _ _ => nothing
  end.
Definition as_node (w : string) : option node :=
  match read (term []) w two_variables with
  | Some (i, k) => option_map node_of (PM.find i (infos (t k)))
  | None => None
  end.
Lemma operations : map as_node
  ["['add', 'x', 'y']"; "['sub', 'x', 'y']"; "['mul', 'x', 'y']"; "['div', 'x', 'y']";
   "['neg', 'x']"; "['pow', 'x', '7']"; "['sqrt', 'x']"; "['min', 'x', 'y', 'x']";
   "['max', 'y', 'x']"; "['cos', 'x']"; "['cos_pi', 'x']"; "['pi']"; "['exp', 'x']"; "['log', 'x']";
   "['sin', 'x']"; "['atan', 'x']"; "['root', 'x', '3']"]%string =
  [Some (NAdd 1 2); Some (NSub 1 2); Some (NMul 1 2); Some (NDiv 1 2);
   Some (NNeg 1); Some (NPow 1 7); Some (NSqrt 1); Some (NMin 1 [2; 1]);
   Some (NMax 2 [1]); Some (NCos 1); Some (NCosPi 1); Some NPi; Some (NOf Exp 1); Some (NOf Log 1);
   Some (NOf Sin 1); Some (NOf Atan 1); Some (NOf (NthRoot 3) 1)].
Proof. vm_compute. reflexivity. Qed.
Lemma numbers : map as_node ["'3/100'"; "'-3'"; "'6/4'"; "'0'"; "'y'"]%string =
  [Some (NRational 3 100); Some (NRational (-3) 1); Some (NRational 3 2); Some (NRational 0 1);
   Some (NVariable 0)].
Proof. vm_compute. reflexivity. Qed.
Lemma no_terms : forallb (fun w => absent (as_node w))
  ["'03'"; "'1/0'"; "'1.5'"; "'z'"; "3"; "['add', 'x']"; "['neg', 'x', 'y']"; "['min', 'x']"; "['x']";
   "['tan', 'x']"; "['pow', 'x', '0']"; "['pow', 'x', '1000']"; "['root', 'x', '1']";
   "['root', 'x', '100']"]%string = true.
Proof. vm_compute. reflexivity. Qed.
Definition as_claim (w : string) : option claim :=
  option_map fst (read (claim_in [] root) w two_variables).
Lemma claims : map as_claim
  ["['<', 'x', 'y']"; "['<=', 'x', 'y']"; "['=', 'x', 'y']"; "['!=', 'x', 'y']"; "['<', 'x']"]%string =
  [Some (Claim Less 1 2); Some (Claim AtMost 1 2); Some (Claim Equal 1 2); None; None].
Proof. vm_compute. reflexivity. Qed.

(* --- statements --------------------------------------------------------------------------------- *)

Definition statement_with (terms contexts rows assumptions cites : string) : string :=
  "{'format': 'verify-statement/2', 'theorem': 'an example', 'title': '', 'parameters': {'r': '1/2'}, 'terms': {" ++
  terms ++ "}, 'constants': [], 'contexts': [" ++ contexts ++ "], 'obligations': [" ++ rows ++
  "], 'assumptions': [" ++ assumptions ++ "], 'cites': [" ++ cites ++ "]}".
Definition context_with (name parent variables givens point : string) : string :=
  "{'name': '" ++ name ++ "', 'parent': " ++ parent ++ ", 'says': '', 'variables': [" ++ variables ++
  "], 'givens': [" ++ givens ++ "], 'point': {" ++ point ++ "}, 'constants': []}".
Definition variable_named (name : string) : string :=
  "{'name': '" ++ name ++ "', 'letter': '', 'tex': ''}".
Definition given_with (name claim kind assumption : string) : string :=
  "{'name': '" ++ name ++ "', 'claim': " ++ claim ++ ", 'kind': '" ++ kind ++ "', 'assumption': " ++
  assumption ++ "}".
Definition row_with (name context role claim verdict : string) : string :=
  "{'name': '" ++ name ++ "', 'context': " ++ context ++ ", 'group': '', 'label': '', 'role': '" ++ role ++
  "', 'severity': null, 'says': '', 'claim': " ++ claim ++ ", 'verdict': '" ++ verdict ++
  "', 'uses': [], 'corrected_by': null}".
Definition assumed (name : string) : string :=
  "{'name': '" ++ name ++ "', 'kind': '', 'label': '', 'sentence': ''}".
Definition meaning_of (w : string) : option statement :=
  match document (text w) with Some x => statement_of (fun _ => None) x | None => None end.

(* Two contexts beside each other, each with its variable, and a child of the first. *)
Definition family : string :=
  context_with "c" "null" (variable_named "x")
    (given_with "low" "['<', '0', 'x']" "plain" "null" ++ ", " ++
     given_with "kept" "['<=', 'x', 'r']" "carried" "null" ++ ", " ++
     given_with "law" "['=', 'x', 's']" "standing" "'nature'") "'x': '1/3'" ++ ", " ++
  context_with "inner" "'c'" (variable_named "z") "" "'z': 'x'" ++ ", " ++
  context_with "d" "null" (variable_named "y") "" "'y': 'r'".
Definition with_rows (rows : string) : option statement :=
  meaning_of (statement_with "'s': ['neg', 'r']" family rows (assumed "nature") "").
Lemma example : with_rows
  (row_with "one" "'c'" "needed" "['<', 'x', 'r']" "proved" ++ ", " ++
   row_with "two" "null" "printed" "['<=', 'r', 's']" "refuted" ++ ", " ++
   row_with "three" "'inner'" "printed" "['=', 'z', 'x']" "undecided" ++ ", " ++
   row_with "four" "'d'" "needed" "['applies', 'c', {'x': 'y'}]" "proved" ++ ", " ++
   row_with "five" "'d'" "needed" "['always', 'c', {'x': 'y'}, {'x': 's'}]" "proved") =
  Some (Statement
    [NRational 1 2; NConstant 0 1; NVariable 1; NRational 0 1; NNeg 2; NRational 1 3; NVariable 2;
     NVariable 3]
    [Context 0 [3]
       [Given (named "low") (Claim Less 4 3) Plain; Given (named "kept") (Claim AtMost 3 2) Carried;
        Given (named "law") (Claim Equal 3 5) Standing] [(3, 6)];
     Context 1 [7] [] [(7, 3)]; Context 0 [8] [] [(8, 2)]]
    [1%nat; 2%nat; 3%nat] [2]
    [Row (named "one") 1 Proved true (Compare (Claim Less 3 2));
     Row (named "two") 0 Refuted false (Compare (Claim AtMost 2 5));
     Row (named "three") 2 Undecided false (Compare (Claim Equal 7 3));
     Row (named "four") 3 Proved true (Applies 1 [(3, 8)]);
     Row (named "five") 3 Proved true (Always 1 [(3, 8)] [(3, 5)])]
    [] []).
Proof. vm_compute. reflexivity. Qed.
(* In a context are its own names and those of what is around it, and no others. *)
Definition in_scope_of (x : string * string) : bool :=
  negb (absent (with_rows (row_with "one" (fst x) "needed" (snd x) "proved"))).
Lemma in_scope : forallb in_scope_of
  [("null", "['<', 'r', 's']"); ("'c'", "['<', 'x', 's']"); ("'inner'", "['<', 'x', 'z']");
   ("'d'", "['<', 'y', 'r']"); ("'inner'", "['applies', 'inner', {'z': 'x'}]")]%string = true.
Proof. vm_compute. reflexivity. Qed.
Lemma not_in_scope : existsb in_scope_of
  [("null", "['<', 'x', 'r']"); ("'c'", "['<', 'x', 'z']"); ("'inner'", "['<', 'z', 'y']");
   ("'d'", "['<', 'y', 'x']"); ("'d'", "['<', 'y', ['add', 'y', 'x']]"); ("'e'", "['<', 'r', 's']");
   ("'d'", "['applies', 'c', {'x': 'x'}]"); ("'d'", "['applies', 'c', {}]");
   ("'d'", "['applies', 'c', {'x': 'y', 'y': 'y'}]"); ("'d'", "['applies', 'e', {}]")]%string = false.
Proof. vm_compute. reflexivity. Qed.
Lemma no_statements : forallb (fun w => absent (meaning_of w))
  ["{}"; statement_with "" "" (row_with "r" "null" "needed" "['<', 'r', '1']" "proved") "" "";
   statement_with "" "" "" (assumed "a" ++ ", " ++ assumed "a") "";
   statement_with "'s': 'q', 'q': 's'" "" "" "" "";
   statement_with "" (context_with "c" "null" (variable_named "x")
     (given_with "law" "['=', 'x', 'r']" "standing" "'nature'") "'x': '1'") "" "" "";
   statement_with "" (context_with "c" "null" (variable_named "x") "" "") "" "" "";
   statement_with "" "" (row_with "one" "null" "needed" "['<', 'r', '1']" "true") "" "";
   statement_with "" "" (row_with "one" "null" "all" "['<', 'r', '1']" "proved") "" ""]%string = true.
Proof. vm_compute. reflexivity. Qed.

(* What is cited has its own names after that of the citation, and its proved rows are facts. *)
Definition other : string := statement_with "" ""
  (row_with "less" "null" "needed" "['<', 'r', '1']" "proved" ++ ", " ++
   row_with "not" "null" "printed" "['<', '1', 'r']" "refuted") "" "".
Definition zeros : string :=
  "0000000000000000000000000000000000000000000000000000000000000000".
Definition citing : string := statement_with "" ""
  (row_with "one" "null" "needed" "['<', 'o:r', 'r']" "proved") ""
  ("{'name': 'o', 'theorem': 'an example', 'statement_sha256': '" ++ zeros ++ "'}").
Definition cited_by_digest (d : list byte) : option (list byte) :=
  if is zeros d then Some (text other) else None.
Lemma cites : match document (text citing) with
    | Some x => statement_of cited_by_digest x
    | None => None
    end =
  Some (Statement [NRational 1 2; NConstant 0 1; NRational 1 1; NConstant 0 1] [] [] [4]
    [Row (named "one") 0 Proved true (Compare (Claim Less 2 4))]
    [(named "o:r", (0%nat, Claim Equal 2 1)); (named "o:less", (0%nat, Claim Less 2 3))] [2]).
Proof. vm_compute. reflexivity. Qed.
Lemma not_at_hand : meaning_of citing = None.
Proof. vm_compute. reflexivity. Qed.
