(* Terms, claims and names of a file: each term gets the next number when it is first met. A name is a
   fact's number, too: its bytes in a row. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive.
From Verify Require Import Json ReadJson Meaning Terms Substitution Decode.
Import ListNotations.
Open Scope N_scope.

(* --- what has been read ------------------------------------------------------------------------- *)

(* A context by its number, with its own number and those around; 0 is the root. *)
Record spot := Spot { number : N; depth : N; within : list N }.
Record home := Home {
  spot_of : spot;
  outside : option N;
  own : list (list byte * positive);  (* its variables *)
  premises : list given
}.
Record info := Info { node_of : node; lives : spot; tall : N }.
(* What a name of a term is: a term, or one that is read when it is used, with a prefix for names. *)
Inductive entry := Known (i : positive) | Unread (prefix : list byte) (x : json).

Record terms := Terms {
  next : positive;
  count : nat;
  made : list node;  (* the latest first *)
  infos : PM.t info;
  index : PM.t positive;
  rationals : PM.t positive
}.
Record names := Names {
  taken : PM.t unit;
  entries : PM.t entry;
  shared : nat;  (* how many terms were to be read when they are used *)
  places : PM.t N;
  homes_found : PM.t home;
  contexts_count : N;
  known : PM.t (N * claim);
  finished : PM.t unit
}.
Record output := Output {
  contexts_found : list context;  (* the latest first, here and below *)
  cited_found : list (positive * (nat * claim));
  cited_constants_found : list positive;
  constants_found : list (list byte * positive);
  own_found : list nat;
  often : list positive  (* ground terms that are worth to be enclosed once *)
}.
Record kernel := Kernel { t : terms; n : names; o : output }.

Definition root : spot := Spot 0 0 [0].
Definition outermost : home := Home root None [] [].
Definition nothing : kernel :=
  Kernel (Terms 1 0 [] (PM.empty _) (PM.empty _) (PM.empty _))
    (Names (PM.empty _) (PM.empty _) 0 (PM.empty _) (PM.add 1%positive outermost (PM.empty _)) 0
       (PM.empty _) (PM.empty _))
    (Output [] [] [] [] [] []).

Definition M : Type -> Type := reading kernel.
Definition get {A} (f : kernel -> A) : M A := fun k => Ok (f k) k.
Definition with_terms (f : terms -> terms) : M unit := fun k => Ok tt (Kernel (f (t k)) (n k) (o k)).
Definition with_names (f : names -> names) : M unit := fun k => Ok tt (Kernel (t k) (f (n k)) (o k)).
Definition with_output (f : output -> output) : M unit :=
  fun k => Ok tt (Kernel (t k) (n k) (f (o k))).

Definition set_taken x m := Names x (entries m) (shared m) (places m) (homes_found m)
  (contexts_count m) (known m) (finished m).
Definition set_entries x s m := Names (taken m) x s (places m) (homes_found m)
  (contexts_count m) (known m) (finished m).
Definition set_homes p x c m := Names (taken m) (entries m) (shared m) p x c (known m) (finished m).
Definition set_known x m := Names (taken m) (entries m) (shared m) (places m) (homes_found m)
  (contexts_count m) x (finished m).
Definition set_finished x m := Names (taken m) (entries m) (shared m) (places m) (homes_found m)
  (contexts_count m) (known m) x.

(* --- names -------------------------------------------------------------------------------------- *)

Definition fact (s : list byte) : positive := as_number s.
Definition introduce (s : list byte) : M unit :=
  let i := fact s in
  let! used := get (fun k => PM.mem i (taken (n k))) in
  if at_most 1000 s && negb (is "goal" s) && negb used
  then with_names (fun m => set_taken (PM.add i tt (taken m)) m)
  else bad_name "a name twice: " s.
Definition once (s : list byte) : M unit :=
  let i := fact s in
  let! used := get (fun k => PM.mem i (finished (n k))) in
  let! _ := need (negb used) "a second step" in
  with_names (fun m => set_finished (PM.add i tt (finished m)) m).
Definition remember (s : list byte) (c : spot) (g : claim) : M unit :=
  with_names (fun m => set_known (PM.add (fact s) (number c, g) (known m)) m).
Definition enter (s : list byte) (e : entry) (more : nat) : M unit :=
  with_names (fun m => set_entries (PM.add (fact s) e (entries m)) (more + shared m) m).
Definition home_number (c : N) : M home :=
  let! h := get (fun k => PM.find (N.succ_pos c) (homes_found (n k))) in from h "no context".
Definition find_place (prefix : list byte) (s : option (list byte)) : M home :=
  match s with
  | None => home_number 0
  | Some s =>
      let! c := get (fun k => PM.find (fact (prefix ++ s)) (places (n k))) in
      match c with Some c => home_number c | None => bad_name "no context " s end
  end.

(* --- terms -------------------------------------------------------------------------------------- *)

Definition is_inside (c d : spot) : bool := existsb (N.eqb (number d)) (within c).
Definition info_at (i : positive) : M info :=
  let! x := get (fun k => PM.find i (infos (t k))) in from x "no term".
Definition spot_at (i : positive) : M spot := let! x := info_at i in ret (lives x).
Definition add (x : node) (c : spot) (height : N) : M positive :=
  let! i := get (fun k => next (t k)) in
  let! _ := with_terms (fun l => Terms (Pos.succ i) (Datatypes.S (count l)) (x :: made l)
    (PM.add i (Info x c height) (infos l)) (index l) (rationals l)) in
  ret i.
(* The innermost context of subterms, and the height above them. *)
Fixpoint above (c : spot) (height : N) (args : list positive) : M (spot * N) :=
  match args with
  | [] => ret (c, height + 1)
  | i :: args =>
      let! x := info_at i in
      let d := lives x in
      let! _ := need (is_inside c d || is_inside d c) "names of two contexts in a term" in
      above (if depth c <? depth d then d else c) (N.max height (tall x)) args
  end.
Definition put_node (x : node) : M positive :=
  let! i := get (fun k => PM.find (key x) (index (t k))) in
  match i with
  | Some i => ret i
  | None =>
      let! (c, height) := above root 0 (subterms x) in
      let! _ := need (height <=? 200) "a term of more than 200 levels" in
      let! i := add x c height in
      let! _ := with_terms (fun l => Terms (next l) (count l) (made l) (infos l)
        (PM.add (key x) i (index l)) (rationals l)) in
      ret i
  end.
Definition rational_key (q : Q) : positive :=
  let d := coded (Qden q) 1 in
  match Qnum q with Z0 => coded 1 d | Zpos p => coded 2 (coded p d) | Zneg p => coded 3 (coded p d) end.
Definition put_rational (q : Q) : M positive :=
  let! i := get (fun k => PM.find (rational_key q) (rationals (t k))) in
  match i with
  | Some i => ret i
  | None =>
      let! i := add (NRational (Qnum q) (Qden q)) root 1 in
      let! _ := with_terms (fun l => Terms (next l) (count l) (made l) (infos l) (index l)
        (PM.add (rational_key q) i (rationals l))) in
      ret i
  end.

(* The operations, by their names in files. *)
Definition nullary : list (string * node) := [("pi", NPi)]%string.
Definition unary : list (string * (positive -> node)) :=
  [("neg", NNeg); ("sqrt", NSqrt); ("cos", NCos); ("cos_pi", NCosPi); ("exp", NOf Exp);
   ("log", NOf Log); ("sin", NOf Sin); ("atan", NOf Atan)]%string.
Definition binary : list (string * (positive -> positive -> node)) :=
  [("add", NAdd); ("sub", NSub); ("mul", NMul); ("div", NDiv)]%string.
Definition variadic : list (string * (positive -> list positive -> node)) :=
  [("min", NMin); ("max", NMax)]%string.
Definition node_for (op : list byte) (args : list positive) : option node :=
  match args with
  | [] => choice nullary op
  | [a] => option_map (fun f => f a) (choice unary op)
  | a :: ((b :: more) as l) =>
      match more, choice binary op with
      | [], Some f => Some (f a b)
      | _, _ => option_map (fun f => f a l) (choice variadic op)
      end
  end.
Definition operation (op : list byte) (args : list positive) : M positive :=
  match node_for op args with Some x => put_node x | None => bad_name "no term: " op end.
(* Those that have a number besides, with what reads it. *)
Definition with_number : list (string * ((json -> M positive) * (positive -> positive -> node))) :=
  [("pow", (exponent, NPow)); ("root", (root_index, fun a n => NOf (NthRoot n) a))]%string.

(* A term. Each shared term is read once, so that `fuel`, their number, is enough. *)
Fixpoint term_with (fuel : nat) : list byte -> json -> M positive :=
  fix inside prefix (x : json) {struct x} :=
    match x with
    | JStr s =>
        let full := prefix ++ s in
        let i := fact full in
        let! e := get (fun k => PM.find i (entries (n k))) in
        match e with
        | Some (Known i) => ret i
        | Some (Unread p value) =>
            match fuel with
            | O => bad "shared terms that use each other"
            | Datatypes.S less =>
                let! _ := with_names (fun m =>
                  set_entries (PM.remove i (entries m)) (shared m) m) in
                let! j := term_with less p value in
                let! _ := enter full (Known j) 0 in
                ret j
            end
        | None => let! q := rational s in put_rational q
        end
    | JList (JStr op :: args) =>
        match choice with_number op, args with
        | Some (read, node), [a; n] =>
            let! a := inside prefix a in
            let! n := read n in
            put_node (node a n)
        | Some _, _ => bad "expected a term"
        | None, _ =>
            let! args := over (inside prefix) [] args in
            operation op args
        end
    | _ => bad "expected a term"
    end.
Definition term (prefix : list byte) (x : json) : M positive :=
  let! fuel := get (fun k => shared (n k)) in term_with fuel prefix x.
Definition scoped (prefix : list byte) (c : spot) (x : json) : M positive :=
  let! i := term prefix x in
  let! d := spot_at i in
  let! _ := need (is_inside c d) "a name that is not in scope" in
  ret i.

Definition relations : list (string * relation) :=
  [("<", Less); ("<=", AtMost); ("=", Equal)]%string.
Definition claim_in (prefix : list byte) (c : spot) (x : json) : M claim :=
  match x with
  | JList [JStr r; a; b] =>
      let! r := from (choice relations r) "a relation" in
      let! a := scoped prefix c a in
      let! b := scoped prefix c b in
      ret (Claim r a b)
  | _ => bad "expected a claim"
  end.

(* A name for a variable of a context, or for a constant with its definition. *)
Definition new_name (s : list byte) (c : spot) (definition : option positive) : M positive :=
  let! _ := introduce s in
  let at_ := N.to_nat (number c) in
  let! i := add (match definition with None => NVariable at_ | Some d => NConstant at_ d end) c 1 in
  let! _ := enter s (Known i) 0 in
  ret i.
Definition share (prefix : list byte) (x : json) : M unit :=
  let! l := members_of x in
  let! _ := all (fun item =>
    let! s := name (JStr (fst item)) in
    let! _ := introduce (prefix ++ s) in
    enter (prefix ++ s) (Unread prefix (snd item)) 1) l in
  ret tt.

(* Terms over the names of a place for the variables of a context, in its order. *)
Definition values (prefix : list byte) (c : home) (place : spot) (x : json) : M substitution :=
  let! l := members_of x in
  let why := "too many or too few variables"%string in
  let! _ := need (Nat.eqb (length l) (length (own c)) &&
    forallb (fun item => match find_key (fst item) (own c) with Some _ => true | None => false end) l)
    why in
  let! found := all (fun item => let! i := scoped prefix place (snd item) in ret (fst item, i)) l in
  all (fun v => let! i := from (find_key (fst v) found) why in ret (snd v, i)) (own c).

(* --- substitution ------------------------------------------------------------------------------- *)

(* The results for the items of a list, one after the other, with a memory; after those found. *)
Definition after_each {X} (f : X -> positive -> M (positive * X)) :=
  fix go (memo : X) (found : list positive) (l : list positive) : M (list positive * X) :=
    match l with
    | [] => ret (rev_append found [], memo)
    | i :: l => let! (j, memo) := f memo i in go memo (j :: found) l
    end.

Section PutValues.
Variable c : spot.
Variable at_ : PM.t positive.
(* The term after values are put for the variables of c; its nodes are made where needed. *)
Fixpoint substituted (fuel : nat) (memo : PM.t positive) (i : positive)
    : M (positive * PM.t positive) :=
  match PM.find i memo with
  | Some j => ret (j, memo)
  | None =>
      let! x := info_at i in
      match fuel with
      | O => bad "no term"
      | Datatypes.S less =>
          let! (j, memo) :=
            (if negb (number (lives x) =? number c) then ret (i, memo)
             else match node_of x with
             | NVariable _ => let! j := from (PM.find i at_) "no term" in ret (j, memo)
             | NConstant _ d => substituted less memo d
             | NRational _ _ | NPi => ret (i, memo)
             | y =>
                 let! (l, memo) := after_each (substituted less) memo [] (subterms y) in
                 let! y := from (rebuilt y l) "no term" in
                 let! j := put_node y in ret (j, memo)
             end) in
          ret (j, PM.add i j memo)
      end
  end.
End PutValues.
(* Makes the nodes of claims after values are put for the variables of a context. *)
Definition put_claims (c : home) (at_ : substitution) (claims : list claim) : M (list positive) :=
  let m := fold_right (fun x m => PM.add (fst x) (snd x) m) (PM.empty positive) at_ in
  let! fuel := get (fun k => count (t k)) in
  let! (found, _) := after_each (substituted (spot_of c) m fuel) (PM.empty positive) []
    (flat_map (fun g => [lhs g; rhs g]) claims) in
  ret found.
Definition put_givens (c : home) (at_ : substitution) (more : list claim) : M (list positive) :=
  put_claims c at_ (more ++ map given_claim (premises c)).
