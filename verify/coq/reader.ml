(* Reads statement.json and certificate.json, and asks the checker that is extracted from Coq:

     reader FOLDER [FOLDER ...]

   One line for each folder: PROVED, with the sentences that are given and with what is cited and not
   proved in this run; or why not. In it, what is not ASCII is \xNN. Exit code 0 if all are proved, 1 if
   one is refused, 2 if a file cannot be read (a line on stderr), 4 if one is malformed, 5 for an error
   of its own. It counts no work: a folder that takes more than a minute of the processor, or a
   gigabyte, is malformed. This file is not proved: what it hands over is what has to be believed. *)
open Checker
open Json

(* --- shapes ----------------------------------------------------------------------------------- *)

let record keys = function
  | Obj l when List.sort compare (List.map fst l) = List.sort compare keys -> fun k -> List.assoc k l
  | _ -> bad ("an object has to have the keys " ^ String.concat ", " keys)
let list = function List l -> l | _ -> bad "expected a list"
let table = function Obj l -> l | _ -> bad "expected an object"
let str = function Str s -> s | _ -> bad "expected a text"
let optional f = function Null -> None | x -> Some (f x)
let digit c = c >= '0' && c <= '9'
let letter c = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')
let is_name s =
  let n = String.length s in
  n >= 1 && n <= 100 && letter s.[0]
  && String.for_all (fun c -> letter c || digit c || c = '_' || c = '.' || c = '-') s
let name x = let s = str x in need (is_name s) ("no name: " ^ s); s
let long_name x =
  let s = str x in need (List.for_all is_name (String.split_on_char ':' s)) ("no name: " ^ s); s
let is_whole s =
  let n = String.length s in
  n >= 1 && n <= 4300 && String.for_all digit s && (n = 1 || s.[0] <> '0')
let unsigned s = if s <> "" && s.[0] = '-' then true, String.sub s 1 (String.length s - 1) else false, s
let is_rational s =
  match String.split_on_char '/' (snd (unsigned s)) with
  | [a] -> is_whole a | [a; b] -> is_whole a && is_whole b && b <> "0" | _ -> false
let integer low high = function
  | Int n when n >= low && n <= high -> n | _ -> bad "expected a whole number"
let exponent x =
  let s = str x in
  need (is_whole s && s <> "0" && String.length s <= 3) "expected an exponent"; int_of_string s
let among words x = let s = str x in need (List.mem s words) ("expected " ^ String.concat ", " words); s
let digest x =
  let s = str x in
  need (String.length s = 64 && String.for_all (fun c -> digit c || (c >= 'a' && c <= 'f')) s) "a digest"; s
let fields kind = match kind with
  | "constant" -> ["name"; "label"; "letter"; "tex"; "term"]
  | "given" -> ["name"; "claim"; "kind"; "assumption"]
  | "context" -> ["name"; "parent"; "says"; "variables"; "givens"; "point"; "constants"]
  | "row" -> ["name"; "context"; "group"; "label"; "role"; "severity"; "says"; "claim"; "verdict"; "uses"; "corrected_by"]
  | "statement" -> ["format"; "theorem"; "title"; "parameters"; "terms"; "constants"; "contexts"; "obligations"; "assumptions"; "cites"]
  | _ -> ["format"; "statement_sha256"; "terms"; "steps"; "enclosures"]
let texts get keys = List.iter (fun k -> ignore (str (get k))) keys

(* --- numbers of Coq --------------------------------------------------------------------------- *)

let rec nat n = if n = 0 then O else S (nat (n - 1))
let rec pos n = if n = 1 then XH else if n land 1 = 0 then XO (pos (n / 2)) else XI (pos (n / 2))
let z n = if n = 0 then Z0 else if n > 0 then Zpos (pos n) else Zneg (pos (-n))
let rec whole s =  (* in pieces of 9 digits *)
  let n = String.length s in
  if n <= 9 then z (int_of_string s)
  else
    let half = n / 2 in
    let low = n - half in
    Z.add (Z.mul (whole (String.sub s 0 half)) (Z.pow (z 10) (z low)))
      (whole_digits (String.sub s half low))
and whole_digits s =
  let rec cut i = if i < String.length s - 1 && s.[i] = '0' then cut (i + 1) else i in
  let i = cut 0 in whole (String.sub s i (String.length s - i))
let positive = function Zpos p -> p | _ -> bad "expected a positive number"
let signed minus n = if minus then Z.opp n else n
let rational s =
  need (is_rational s) ("no number: " ^ s);
  let minus, s = unsigned s in
  match String.split_on_char '/' s with
  | [a; b] -> qred { qnum = signed minus (whole a); qden = positive (whole b) }
  | _ -> { qnum = signed minus (whole s); qden = XH }
let decimal x =
  let minus, s = unsigned (str x) in
  let base, e = match String.split_on_char 'e' s with
    | [a] -> a, 0
    | [a; e] ->
        let m, d = unsigned e in
        need (d <> "" && String.length d <= 5 && String.for_all digit d) "a decimal number";
        a, (if m then - int_of_string d else int_of_string d)
    | _ -> bad "a decimal number" in
  let a, b = match String.split_on_char '.' base with
    | [a] -> a, "" | [a; b] when b <> "" -> a, b | _ -> bad "a decimal number" in
  need (is_whole a && String.length a <= 100 && String.for_all digit b && String.length b <= 99) "a decimal number";
  let power = e - String.length b and digits = signed minus (whole_digits (a ^ b)) in
  if power >= 0 then { qnum = Z.mul digits (Z.pow (z 10) (z power)); qden = XH }
  else qred { qnum = digits; qden = positive (Z.pow (z 10) (z (-power))) }

(* --- terms, names, contexts ------------------------------------------------------------------- *)

type home = { number : int; depth : int; around : int list; label : string; mutable own : (string * int) list;
              mutable given : (string * claim * string) list; up : home option }
type key = Rat of q | Node of string * int list * int

let root = { number = 0; depth = 0; around = [0]; label = ""; own = []; given = []; up = None }
let is_inside c d = List.mem d.number c.around

type kernel = {
  mutable nodes : (node * home * int) list;  (* the latest first, with its home and height *)
  mutable count : int;
  by_number : (int, node * home * int) Hashtbl.t;
  index : (key, int) Hashtbl.t;
  names : (string, int) Hashtbl.t;
  definitions : (int, int) Hashtbl.t;
  taken : (string, unit) Hashtbl.t;
  unread : (string, string * json) Hashtbl.t;  (* shared terms, with the prefix of their names *)
  read : (string, int) Hashtbl.t;
  places : (string, home) Hashtbl.t;
  mutable contexts : context list;  (* the latest first *)
  facts : (string, int) Hashtbl.t;
  known : (string, home * claim) Hashtbl.t;
  mutable cited : (positive * (nat * claim)) list;
  mutable cited_constants : positive list;
  mutable constants : (string * int) list;
  mutable own_contexts : nat list;
  mutable often : int list;  (* ground terms that are worth to be enclosed once *)
}
let kernel () = {
  nodes = []; count = 0; by_number = Hashtbl.create 999; index = Hashtbl.create 999; names = Hashtbl.create 99;
  definitions = Hashtbl.create 99; taken = Hashtbl.create 99; unread = Hashtbl.create 99; read = Hashtbl.create 99;
  places = Hashtbl.create 9; contexts = []; facts = Hashtbl.create 99; known = Hashtbl.create 99;
  cited = []; cited_constants = []; constants = []; own_contexts = []; often = [] }

let home k i = let _, h, _ = Hashtbl.find k.by_number i in h
let height k i = let _, _, n = Hashtbl.find k.by_number i in n
let introduce k s =
  need (String.length s <= 1000 && s <> "goal" && not (Hashtbl.mem k.taken s)) ("a name twice: " ^ s);
  Hashtbl.add k.taken s ()
let add k n h height =
  k.count <- k.count + 1;
  k.nodes <- (n, h, height) :: k.nodes;
  Hashtbl.add k.by_number k.count (n, h, height);
  k.count
let make op args extra =
  match op, List.map pos args with
  | "add", [a; b] -> NAdd (a, b) | "sub", [a; b] -> NSub (a, b) | "mul", [a; b] -> NMul (a, b)
  | "div", [a; b] -> NDiv (a, b) | "neg", [a] -> NNeg a | "pow", [a] -> NPow (a, pos extra)
  | "sqrt", [a] -> NSqrt a | "cos", [a] -> NCos a | "cos_pi", [a] -> NCosPi a
  | "min", a :: (_ :: _ as l) -> NMin (a, l) | "max", a :: (_ :: _ as l) -> NMax (a, l)
  | "pi", [] -> NPi | "exp", [a] -> NOf (Exp, a) | "log", [a] -> NOf (Log, a)
  | "sin", [a] -> NOf (Sin, a) | "atan", [a] -> NOf (Atan, a)
  | "root", _ -> bad ("the checker in Coq has no operation " ^ op)
  | _ -> bad ("no term: " ^ op)
let named = function Exp -> "exp" | Log -> "log" | Sin -> "sin" | Atan -> "atan"
let node k op args extra =
  let key = Node (op, args, extra) in
  match Hashtbl.find_opt k.index key with
  | Some i -> i
  | None ->
      let n = make op args extra in
      let inner = List.fold_left (fun h a ->
        let other = home k a in
        need (is_inside h other || is_inside other h) "names of two contexts in a term";
        if other.depth > h.depth then other else h) root args in
      let tall = 1 + List.fold_left (fun m a -> max m (height k a)) 0 args in
      need (tall <= 200) "a term of more than 200 levels";
      let i = add k n inner tall in
      Hashtbl.add k.index key i; i
let number k q =
  match Hashtbl.find_opt k.index (Rat q) with
  | Some i -> i
  | None ->
      let i = add k (NRational (q.qnum, q.qden)) root 1 in
      Hashtbl.add k.index (Rat q) i; i
let rec term k prefix = function
  | Str s ->
      let full = prefix ^ s in
      if Hashtbl.mem k.names full then Hashtbl.find k.names full
      else if Hashtbl.mem k.read full then Hashtbl.find k.read full
      else if Hashtbl.mem k.unread full then begin
        let p, value = Hashtbl.find k.unread full in
        Hashtbl.remove k.unread full;
        let i = term k p value in
        Hashtbl.add k.read full i; i
      end else number k (rational s)
  | List [Str "pow"; a; n] -> let a = term k prefix a in node k "pow" [a] (exponent n)
  | List (Str op :: args) when op <> "pow" ->
      let args = List.fold_left (fun l a -> term k prefix a :: l) [] args in
      node k op (List.rev args) 0
  | _ -> bad "expected a term"
let scoped k prefix c x =
  let i = term k prefix x in
  need (is_inside c (home k i)) "a name that is not in scope"; i
let relation s = match s with "<" -> Less | "<=" -> AtMost | "=" -> Equal | _ -> bad "a relation"
let claim k prefix c = function
  | List [Str r; a; b] ->
      let r = relation r in
      let a = scoped k prefix c a in
      let b = scoped k prefix c b in
      { relation_of = r; lhs = pos a; rhs = pos b }
  | _ -> bad "expected a claim"
let rec int_of_nat = function O -> 0 | S n -> 1 + int_of_nat n
let rec int_of = function XH -> 1 | XO p -> 2 * int_of p | XI p -> 2 * int_of p + 1
let fact k s =
  match Hashtbl.find_opt k.facts s with
  | Some i -> pos i
  | None -> let i = 1 + Hashtbl.length k.facts in Hashtbl.add k.facts s i; pos i
let find k prefix = function
  | None -> root
  | Some s -> (try Hashtbl.find k.places (prefix ^ s) with Not_found -> bad ("no context " ^ s))
let new_name k s c definition =
  introduce k s;
  let n = match definition with
    | None -> NVariable (nat c.number) | Some d -> NConstant (nat c.number, pos d) in
  let i = add k n c 1 in
  Hashtbl.add k.names s i;
  (match definition with Some d -> Hashtbl.add k.definitions i d | None -> ());
  i
(* Terms over the names of a place for the variables of a context, in its order. *)
let values k prefix c place x =
  let l = table x in
  let short s = List.hd (List.rev (String.split_on_char ':' s)) in
  need (List.sort compare (List.map fst l) = List.sort compare (List.map (fun (s, _) -> short s) c.own))
    "too many or too few variables";
  let found = List.map (fun (s, x) -> s, scoped k prefix place x) l in
  List.map (fun (s, v) -> v, List.assoc (short s) found) c.own
let pairs = List.map (fun (v, t) -> pos v, pos t)
(* The term after values are put for the variables of a context; its nodes are made where needed. *)
let rec substituted k c at memo i =
  match Hashtbl.find_opt memo i with
  | Some j -> j
  | None ->
      let again = List.map (fun p -> substituted k c at memo (int_of p)) in
      let j =
        if (home k i).number <> c.number then i
        else match Hashtbl.find k.by_number i with
          | NVariable _, _, _ -> List.assoc i at
          | NConstant (_, d), _, _ -> substituted k c at memo (int_of d)
          | NAdd (a, b), _, _ -> node k "add" (again [a; b]) 0
          | NSub (a, b), _, _ -> node k "sub" (again [a; b]) 0
          | NMul (a, b), _, _ -> node k "mul" (again [a; b]) 0
          | NDiv (a, b), _, _ -> node k "div" (again [a; b]) 0
          | NNeg a, _, _ -> node k "neg" (again [a]) 0
          | NPow (a, n), _, _ -> node k "pow" (again [a]) (int_of n)
          | NSqrt a, _, _ -> node k "sqrt" (again [a]) 0
          | NMin (a, l), _, _ -> node k "min" (again (a :: l)) 0
          | NMax (a, l), _, _ -> node k "max" (again (a :: l)) 0
          | NCos a, _, _ -> node k "cos" (again [a]) 0
          | NCosPi a, _, _ -> node k "cos_pi" (again [a]) 0
          | NPi, _, _ -> node k "pi" [] 0
          | NOf (f, a), _, _ -> node k (named f) (again [a]) 0
          | NRational _, _, _ -> i in
      Hashtbl.replace memo i j; j
let put k c at claims =
  let memo = Hashtbl.create 99 in
  List.concat_map (fun g -> List.map (fun i -> substituted k c at memo (int_of i)) [g.lhs; g.rhs]) claims
let put_givens k c at more = put k c at (more @ List.map (fun (_, g, _) -> g) c.given)

(* --- the statement ---------------------------------------------------------------------------- *)

type line = { title : string; inside : home; state : string; needed : bool; said : sentence; at : home option }

let constant k prefix c s x =
  let d = scoped k prefix c x in
  let i = new_name k (prefix ^ s) c (Some d) in
  let g = { relation_of = Equal; lhs = pos i; rhs = pos d } in
  Hashtbl.replace k.known (prefix ^ s) (c, g);
  if prefix = "" then k.constants <- (s, i) :: k.constants
  else begin
    k.cited <- (fact k (prefix ^ s), (nat c.number, g)) :: k.cited;
    k.cited_constants <- pos i :: k.cited_constants
  end
let each_constant k prefix c x =
  List.iter (fun item ->
    let get = record (fields "constant") item in
    texts get ["label"; "letter"; "tex"]; constant k prefix c (name (get "name")) (get "term")) (list x)
let context k prefix assumptions item =
  let get = record (fields "context") item in
  ignore (str (get "says"));
  let s = prefix ^ name (get "name") and parent = find k prefix (optional name (get "parent")) in
  introduce k s;
  let n = 1 + Hashtbl.length k.places in
  need (parent.depth < 100) "more than 100 contexts";
  let c = { number = n; depth = parent.depth + 1; around = n :: parent.around; label = s; own = []; given = [];
            up = Some parent } in
  Hashtbl.add k.places s c;
  c.own <- List.map (fun v ->
    let get = record ["name"; "letter"; "tex"] v in
    texts get ["letter"; "tex"];
    let s = prefix ^ name (get "name") in s, new_name k s c None) (list (get "variables"));
  List.iter (fun a ->
    let get = record (fields "given") a in
    let g = claim k prefix c (get "claim") and kind = among ["plain"; "carried"; "standing"] (get "kind") in
    (match kind, optional name (get "assumption") with
     | "standing", Some a -> need (List.mem a assumptions) "no such assumption"
     | "standing", None -> bad "a standing given without an assumption"
     | _, a -> need (a = None) "an assumption of a given that is not standing");
    let s = prefix ^ name (get "name") in
    introduce k s;
    Hashtbl.replace k.known s (c, g);
    c.given <- c.given @ [s, g, kind]) (list (get "givens"));
  let at = values k prefix c parent (get "point") in
  List.iter (fun (s, _) -> ignore (name (Str s))) (table (get "point"));
  ignore (put_givens k c at []);
  let kind = function "plain" -> Plain | "carried" -> Carried | _ -> Standing in
  k.contexts <- { parent = nat parent.number; variables = List.map (fun (_, v) -> pos v) c.own;
    givens = List.map (fun (s, g, t) -> { given_name = fact k s; given_claim = g; given_kind = kind t }) c.given;
    point = pairs at } :: k.contexts;
  if prefix = "" then k.own_contexts <- nat n :: k.own_contexts
  else List.iter (fun (s, g, _) -> k.cited <- (fact k s, (nat n, g)) :: k.cited) c.given;
  each_constant k prefix c (get "constants")
let sentence k prefix c = function
  | List [Str "applies"; d; at] ->
      let d = find k prefix (Some (long_name d)) in
      let at = values k prefix d c at in
      ignore (put_givens k d at []);
      Applies (nat d.number, pairs at), Some d
  | List [Str "always"; d; start; next] ->
      let d = find k prefix (Some (long_name d)) in
      let start = values k prefix d c start in
      let next = values k prefix d d next in
      ignore (put_givens k d start []); ignore (put_givens k d next []);
      Always (nat d.number, pairs start, pairs next), Some d
  | x -> Compare (claim k prefix c x), None
let row k prefix assumptions item =
  let get = record (fields "row") item in
  texts get ["group"; "label"; "says"];
  ignore (optional str (get "severity")); ignore (optional str (get "corrected_by"));
  let s = name (get "name") and inside = find k prefix (optional name (get "context")) in
  let role = among ["needed"; "printed"] (get "role") in
  let state = among ["proved"; "refuted"; "undecided"] (get "verdict") in
  List.iter (fun a -> need (List.mem (name a) assumptions) "no such assumption") (list (get "uses"));
  let said, at = sentence k prefix inside (get "claim") in
  need (at = None || state = "proved") "a claim about a context has to be proved";
  introduce k (prefix ^ s);
  (match said with
   | Compare g ->
       Hashtbl.replace k.known (prefix ^ s) (inside, g);
       if prefix <> "" && state = "proved" then
         k.cited <- (fact k (prefix ^ s), (nat inside.number, g)) :: k.cited
   | _ -> ());
  { title = s; inside; state; needed = role = "needed"; said; at }
let share k prefix x =
  List.iter (fun (s, value) ->
    introduce k (prefix ^ name (Str s));
    Hashtbl.replace k.unread (prefix ^ s) (prefix, value)) (table x)
let rec statement k available prefix document =
  let get = record (fields "statement") document in
  need (get "format" = Str "verify-statement/2") "format"; texts get ["theorem"; "title"];
  List.iter (fun item ->
    let get = record ["name"; "theorem"; "statement_sha256"] item in
    let s = name (get "name") and hash = digest (get "statement_sha256") in
    introduce k (prefix ^ s);
    let inner = try Hashtbl.find available hash with Not_found -> bad "a cited statement is not at hand" in
    let inner = parse inner in
    need (record (fields "statement") inner "theorem" = get "theorem") "a cited statement with another title";
    ignore (statement k available (prefix ^ s ^ ":") inner)) (list (get "cites"));
  let assumptions = List.map (fun item ->
    let get = record ["name"; "kind"; "label"; "sentence"] item in
    texts get ["kind"; "label"; "sentence"]; name (get "name")) (list (get "assumptions")) in
  need (List.length (List.sort_uniq compare assumptions) = List.length assumptions) "an assumption twice";
  let parameters = List.map (fun (s, x) -> name (Str s), scoped k prefix root x) (table (get "parameters")) in
  List.iter (fun (s, _) -> constant k prefix root s (List.assoc s (table (get "parameters")))) parameters;
  share k prefix (get "terms");
  each_constant k prefix root (get "constants");
  List.iter (context k prefix assumptions) (list (get "contexts"));
  List.iter (fun (s, _) -> ignore (term k prefix (Str s))) (table (get "terms"));
  let rows = List.fold_left (fun l item -> row k prefix assumptions item :: l) [] (list (get "obligations")) in
  List.rev rows,
  List.map fst parameters @ List.map (fun item -> name (record (fields "constant") item "name")) (list (get "constants"))

(* --- the certificate -------------------------------------------------------------------------- *)

let reference k x =
  let s = str x in
  if s <> "" && s.[0] = '@' then begin
    let d = String.sub s 1 (String.length s - 1) in
    need (is_whole d && d <> "0" && String.length d <= 3) "a hypothesis";
    Hypothesis_ (nat (int_of_string d))
  end else Fact (fact k (long_name x))
let bits = function Int n when n >= 2 && n <= 65536 -> pos n | _ -> bad "bits"
let precision k get =
  bits (get "bits"), List.map (function
    | List [s; low; high] ->
        let s = long_name s in
        let i = try Hashtbl.find k.names s with Not_found -> bad ("no name " ^ s) in
        { bound_name = pos i; bound_below = reference k low; bound_above = reference k high }
    | _ -> bad "bounds") (list (get "bounds"))
let rec addend k c = function
  | Str "goal" -> Goal
  | Str s when is_rational s -> Number (rational s)
  | Str _ as x -> Known (reference k x)
  | List [Str "square"; t] -> Square (pos (scoped k "" c t))
  | List [Str "root"; t] -> Root (pos (scoped k "" c t))
  | List [Str "pow"; a; n] -> let n = exponent n in Power (addend k c a, pos n)
  | List (Str "add" :: l) -> Sum (List.map (addend k c) l)
  | List (Str "mul" :: l) -> Product (List.map (addend k c) l)
  | _ -> bad "expected a value"
let side x = if among ["lhs"; "rhs"] x = "lhs" then Left else Right
let rule_of = function Obj l -> (match List.assoc_opt "rule" l with Some (Str s) -> s | _ -> bad "rule") | _ -> bad "rule"
let rec proof k c x =
  let keys l = record ("rule" :: l) x in
  match rule_of x with
  | "interval" -> let b, l = precision k (keys ["bits"; "bounds"]) in Interval (b, l)
  | "cuts" ->
      let get = keys ["term"; "at"; "branches"] in
      let t = scoped k "" c (get "term") in
      let points = List.map (fun q -> pos (number k (rational (str q)))) (list (get "at")) in
      let branches = proofs k c (get "branches") in
      need (List.length branches = List.length points + 1 || points = []) "too many or too few branches";
      Cuts (pos t, points, branches)
  | "cases" ->
      let get = keys ["of"; "branches"] in
      let t = scoped k "" c (get "of") in Cases (pos t, proofs k c (get "branches"))
  | "entry" -> let get = keys ["side"; "equation"] in Entry (side (get "side"), optional (reference k) (get "equation"))
  | "least" ->
      let get = keys ["side"; "equation"; "branches"] in
      Least (side (get "side"), optional (reference k) (get "equation"), proofs k c (get "branches"))
  | "root" -> ignore (keys []); PositiveRoot
  | "antisymmetry" ->
      let branches = proofs k c (keys ["branches"] "branches") in
      need (List.length branches = 2) "too many or too few branches"; Antisymmetry branches
  | "angles" -> ignore (keys []); Angles
  | "cosine" -> ignore (keys []); Cosine_
  | "sum" ->
      let get = keys ["using"; "addends"; "equations"] in
      let replacements = List.map (reference k) (list (get "using")) in
      let equations = List.map (function
        | List [f; t] -> let f = reference k f in f, pos (scoped k "" c t) | _ -> bad "equations") (list (get "equations")) in
      BySum (replacements, List.map (addend k c) (list (get "addends")), equations)
  | "instance" ->
      let get = keys ["of"; "at"; "givens"] in
      let s = long_name (get "of") in
      let d, g = try Hashtbl.find k.known s with Not_found -> bad ("no fact " ^ s) in
      let at = values k "" d c (get "at") in
      ignore (put_givens k d at [g]);
      Instance (fact k s, pairs at, premises k c (get "givens"))
  | s -> bad ("no rule here: " ^ s)
and proofs k c x = List.map (proof k c) (list x)
and premises k c x = List.map (function Str _ as s -> Given_ (reference k s) | p -> proof k c p) (list x)

let row_proof k (r : line) x =
  let keys l = record ("rule" :: l) x in
  match r.said, rule_of x with
  | Applies _, "instance" -> ByInstance (premises k r.inside (keys ["givens"] "givens"))
  | Always _, "induction" ->
      let get = keys ["start"; "next"] in
      let d = Option.get r.at in
      let start = premises k r.inside (get "start") in ByInduction (start, premises k d (get "next"))
  | Compare g, "witness" when r.state = "refuted" ->
      let get = keys ["at"; "givens"; "negation"] in
      let outside = match r.inside.up with Some p -> p | None -> bad "a witness, but no variable" in
      let at = values k "" r.inside outside (get "at") in
      let terms = put_givens k r.inside at [g] in
      if outside.number = 0 then k.often <- terms @ k.often;
      let given = premises k outside (get "givens") in
      ByWitness (pairs at, given, proof k outside (get "negation"))
  | Compare _, _ -> ByProof (proof k r.inside x)
  | _ -> bad "another rule is needed"
let defining k x = match rule_of x with
  | "define" -> ignore (record ["rule"] x); ByClearing
  | "interval" -> let b, l = precision k (record ["rule"; "bits"; "bounds"] x) in ByInterval (b, l)
  | _ -> bad "another rule is needed"
let step k rows numbered once x =
  let kinds = ["obligation"; "lemma"; "constant"; "define"; "open"] in
  let has kind = match x with Obj l -> List.mem_assoc kind l | _ -> false in
  match List.filter has kinds with
  | ["open"] ->
      let get = record ["open"; "givens"] x in
      let s = name (get "open") in
      let c = find k "" (Some s) in
      once s; Open_ (nat c.number, premises k (Option.get c.up) (get "givens"))
  | ["lemma"] ->
      let get = record ["lemma"; "context"; "claim"; "proof"] x in
      let c = find k "" (optional long_name (get "context")) and s = name (get "lemma") in
      introduce k s;
      let g = claim k "" c (get "claim") in
      let p = proof k c (get "proof") in
      Hashtbl.replace k.known s (c, g);
      Lemma_ (fact k s, nat c.number, g, p)
  | ["obligation"] ->
      let get = record ["obligation"; "proof"] x in
      let s = name (get "obligation") in
      let r = try Hashtbl.find rows s with Not_found -> bad ("no row " ^ s) in
      once s; need (r.state <> "undecided") "a proof of an undecided row";
      Obligation (pos (Hashtbl.find numbered s), row_proof k r (get "proof"))
  | ["constant"] ->
      let get = record ["constant"; "proof"] x in
      let s = name (get "constant") in
      need (List.mem_assoc s k.constants) ("no constant " ^ s); once s;
      Constant_ (fact k s, pos (List.assoc s k.constants), defining k (get "proof"))
  | ["define"] ->
      let get = record ["define"; "context"; "term"; "proof"] x in
      let c = find k "" (optional long_name (get "context")) and s = name (get "define") in
      let d = scoped k "" c (get "term") in
      let i = new_name k s c (Some d) in
      Hashtbl.replace k.known s (c, { relation_of = Equal; lhs = pos i; rhs = pos d });
      Constant_ (fact k s, pos i, defining k (get "proof"))
  | _ -> bad "steps: expected one of obligation, lemma, constant, define, open"

let in_order low high =
  match Z.add (Z.mul high.qnum (Zpos low.qden)) (Z.opp (Z.mul low.qnum (Zpos high.qden))) with
  | Zneg _ -> false | _ -> true
let ends k (t, b, x) = match x with
  | List [low; high] ->
      let low = decimal low and high = decimal high in
      need (in_order low high) "ends in no order";
      { enclosed = pos t; ends_bits = b; low; high }
  | _ -> ignore k; bad "two decimals"
let enclosures k rows own x =
  let get = record ["constants"; "rows"] x in
  let ground g = (home k (int_of g.lhs)).number = 0 && (home k (int_of g.rhs)).number = 0 in
  let wanted = List.filter_map (fun r -> match r.said with
    | Compare g when r.state <> "undecided" && ground g -> Some (r.title, g) | _ -> None) rows in
  let same l names = List.sort compare (List.map fst l) = List.sort compare names in
  let constants = table (get "constants") and sides = table (get "rows") in
  need (same constants own && same sides (List.map fst wanted)) "too many or too few enclosures";
  List.map (fun (s, x) ->
    let get = record ["bits"; "ends"] x in
    ends k (List.assoc s k.constants, bits (get "bits"), get "ends")) constants
  @ List.concat_map (fun (s, x) ->
    let get = record ["bits"; "lhs"; "rhs"] x in
    let g = List.assoc s wanted and b = bits (get "bits") in
    [ends k (int_of g.lhs, b, get "lhs"); ends k (int_of g.rhs, b, get "rhs")]) sides

(* --- files ------------------------------------------------------------------------------------ *)

(* A text in one line of ASCII, whatever is in it. *)
let shown s =
  let b = Buffer.create 99 in
  String.iter (fun c ->
    if c >= ' ' && c <= '~' && c <> '\\' then Buffer.add_char b c
    else Printf.bprintf b "\\x%02x" (Char.code c)) s;
  Buffer.contents b

exception Unusable of string
let is_file path = try (Unix.stat path).Unix.st_kind = Unix.S_REG with Unix.Unix_error _ -> false
let is_folder path = try Sys.is_directory path with Sys_error _ -> false
let read_file path =
  if not (is_file path) then raise (Unusable (path ^ " is no file"));
  try
    let input = open_in_bin path in
    let text = really_input_string input (min (in_channel_length input) (1 lsl 22 + 1)) in
    close_in input; text
  with Sys_error why -> raise (Unusable why) | End_of_file -> raise (Unusable (path ^ " has changed"))

(* Two files, and what lies beside them to be cited: statements, some with certificates. *)
type pair = { statement_text : string; certificate_text : string }
type folder = { path : string; own : pair; beside : string list; proofs : pair list }
let certified = ".certificate.json"
let read_folder path =
  let inside = Filename.concat path in
  let cited = inside "cited" in
  let names = if path <> "" && is_folder cited then List.sort compare (Array.to_list (Sys.readdir cited)) else [] in
  let room = ref (1 lsl 25) in
  let read name =
    let text = read_file (Filename.concat cited name) in
    room := !room - String.length text;
    if !room < 0 then raise (Unusable (cited ^ " has more than 32 MiB"));
    text in
  let ends, others = List.partition (fun s -> Filename.check_suffix s certified) names in
  let others = List.map (fun s -> s, read s) others in
  let proofs = List.map (fun s ->
    let first = Filename.chop_suffix s certified ^ ".json" in
    match List.assoc_opt first others with
    | Some text -> { statement_text = text; certificate_text = read s }
    | None -> raise (Unusable (Filename.concat cited s ^ " lies there without " ^ first))) ends in
  let own = { statement_text = read_file (inside "statement.json");
              certificate_text = read_file (inside "certificate.json") } in
  { path; own; beside = List.map snd others; proofs }

(* --- what is found ---------------------------------------------------------------------------- *)

type verdict_ = Proved_ | Undecided_ | Refused_ | Malformed_  (* from good to bad *)
type report = { verdict_ : verdict_; why : string; hash : string; sentences : string list;
                printed_only : string list; cites : (string * string * string) list }

(* The verdict, and why. *)
let judged available hash { statement_text; certificate_text } =
  let document = parse statement_text in
  let certificate = parse certificate_text in
  let get = record (fields "certificate") certificate in
  need (get "format" = Str "verify-certificate/2") "format";
  need (digest (get "statement_sha256") = hash) "the certificate of another statement";
  let k = kernel () in
  let lines, own = statement k available "" document in
  need (List.exists (fun r -> r.needed) lines) "no needed row";
  share k "" (get "terms");
  let rows = Hashtbl.create 99 and numbered = Hashtbl.create 99 and finished = Hashtbl.create 99 in
  List.iteri (fun i r -> Hashtbl.add rows r.title r; Hashtbl.add numbered r.title (i + 1)) lines;
  let once s = need (not (Hashtbl.mem finished s)) "a second step"; Hashtbl.add finished s () in
  let steps = List.fold_left (fun l x -> step k rows numbered once x :: l) [] (list (get "steps")) in
  let enclosures = enclosures k lines own (get "enclosures") in
  let precisions = List.sort_uniq compare (pos 128 :: List.map (fun e -> e.ends_bits) enclosures) in
  let state = function "proved" -> Proved | "refuted" -> Refuted | _ -> Undecided in
  let s : statement = {
    nodes = List.rev_map (fun (n, _, _) -> n) k.nodes; contexts = List.rev k.contexts;
    own_contexts = List.rev k.own_contexts; constants = List.rev_map (fun (_, i) -> pos i) k.constants;
    rows = List.map (fun r -> { row_name = fact k r.title; row_context = nat r.inside.number;
      row_verdict = state r.state; row_needed = r.needed; row_sentence = r.said }) lines;
    cited = List.rev k.cited; cited_constants = k.cited_constants } in
  let constants = List.map (fun s -> pos (List.assoc s k.constants)) own in
  let terms = List.sort_uniq compare (k.often @ List.map (fun e -> int_of e.enclosed) enclosures) in
  let shared = List.map (fun b -> b, if b = pos 128 then List.map pos terms else constants) precisions in
  let c : certificate = { shared; steps = List.rev steps; enclosures } in
  if accepts s c then Proved_, ""
  else Refused_, match complaint_about s c with
    | Some (AtStep n) -> "step " ^ string_of_int (int_of_nat n) ^ " is refused"
    | Some (AtEnclosure _) -> "an enclosure is refused"
    | _ -> "not all that is needed is proved"

let seconds = 60. and words = 1 lsl 27
let too_much = Malformed "more than a minute of work, or a gigabyte"
(* What a function answers, within these limits. *)
let limited f x =
  let timer value = ignore (Unix.setitimer Unix.ITIMER_VIRTUAL { Unix.it_interval = 0.; it_value = value }) in
  Sys.set_signal Sys.sigvtalrm (Sys.Signal_handle (fun _ -> raise too_much));
  let alarm = Gc.create_alarm (fun () -> if (Gc.quick_stat ()).Gc.heap_words > words then raise too_much) in
  let stop () = timer 0.; Gc.delete_alarm alarm in
  timer seconds;
  match f x with
  | found -> stop (); found
  | exception (Stack_overflow | Out_of_memory) -> stop (); raise too_much
  | exception e -> stop (); raise e

let malformed hash why =
  { verdict_ = Malformed_; why; hash; sentences = []; printed_only = []; cites = [] }
let check available pair =
  let hash = sha256 pair.statement_text in
  match limited (judged available hash) pair with
  | verdict_, why -> { verdict_; why; hash; sentences = []; printed_only = []; cites = [] }
  | exception Malformed why -> malformed hash why

let named_sentences document =
  List.map (fun item -> str (List.assoc "name" (table item)))
    (list (record (fields "statement") document "assumptions"))
let citations_in document = List.map (fun item ->
  let get key = str (List.assoc key (table item)) in
  get "name", get "theorem", get "statement_sha256") (list (record (fields "statement") document "cites"))
(* The names of the sentences, of those that only printed rows use, and the citations. *)
let with_hypotheses pair report =
  if report.verdict_ = Malformed_ then report
  else begin
    let document = parse pair.statement_text in
    let get = record (fields "statement") document in
    let sentences = named_sentences document in
    let needed = Hashtbl.create 99 and printed = Hashtbl.create 99 in
    let mark where x = Hashtbl.replace where (str x) () in
    List.iter (fun c ->
      List.iter (fun g -> ignore (optional (mark needed) (List.assoc "assumption" (table g))))
        (list (List.assoc "givens" (table c)))) (list (get "contexts"));
    List.iter (fun row ->
      let where = if List.assoc "role" (table row) = Str "needed" then needed else printed in
      List.iter (mark where) (list (List.assoc "uses" (table row)))) (list (get "obligations"));
    let printed_only = List.filter (fun s -> Hashtbl.mem printed s && not (Hashtbl.mem needed s)) sentences in
    { report with sentences; printed_only; cites = citations_in document }
  end

(* A folder is as good as the certificates of what it cites. *)
let with_cited report others =
  let cited other = "the cited certificate of " ^ other.hash ^ ": " ^ other.why in
  let worse verdict_ other = { report with verdict_; why = cited other } in
  match report.verdict_, List.find_opt (fun x -> x.verdict_ = Malformed_) others,
        List.find_opt (fun x -> x.verdict_ = Refused_) others with
  | Malformed_, _, _ -> report
  | _, Some other, _ -> worse Malformed_ other
  | Proved_, None, Some other -> worse Refused_ other
  | _ -> report

(* All that is cited, each statement once, where it is first cited: what its names begin with, the
   theorem, the digest, and its sentences. What is cited has been read, so it is at hand. *)
let citations available report =
  let seen = Hashtbl.create 9 in
  let rec follow prefix (name, theorem, hash) =
    if Hashtbl.mem seen hash then [] else begin
      Hashtbl.add seen hash ();
      let prefix = prefix ^ name ^ ":" in
      let document = parse (Hashtbl.find available hash) in
      (prefix, theorem, hash, named_sentences document)
        :: List.concat_map (follow prefix) (citations_in document)
    end in
  List.concat_map (follow "") report.cites

(* The verdict, and what it rests on: sentences, also those of what is cited, and what is cited and
   not proved in this run. Such a citation leaves the whole undecided. *)
let said available closed report = match report.verdict_ with
  | Refused_ -> Refused_, "REFUSED: " ^ report.why
  | Malformed_ -> Malformed_, "MALFORMED: " ^ report.why
  | Proved_ | Undecided_ ->
      let cited = citations available report in
      let opened = List.filter (fun (_, _, hash, _) -> not (Hashtbl.mem closed hash)) cited in
      let apart = Hashtbl.create 99 in
      List.iter (fun s -> Hashtbl.replace apart s ()) report.printed_only;
      let own = List.filter (fun s -> not (Hashtbl.mem apart s)) report.sentences in
      let given = List.concat_map (fun (prefix, _, _, l) -> List.map (fun s -> prefix ^ s) l) cited in
      let names l = if l = [] then "nothing" else String.concat ", " l in
      let apart = if report.printed_only = [] then ""
        else "; for printed rows only, also given " ^ names report.printed_only in
      let citing (_, theorem, hash, _) =
        "; citing " ^ theorem ^ ", which is not proved here (" ^ hash ^ ")" in
      let verdict_, word = if opened = [] then Proved_, "PROVED" else Undecided_, "UNDECIDED" in
      verdict_, word ^ ": given " ^ names (own @ given) ^ apart
                ^ String.concat "" (List.map citing opened)
let exit_code = function Proved_ -> 0 | Undecided_ -> 3 | Refused_ -> 1 | Malformed_ -> 4

let run folders =
  let found = List.map read_folder folders in
  let available = Hashtbl.create 9 and known = Hashtbl.create 9 and closed = Hashtbl.create 9 in
  List.iter (fun f -> List.iter (fun text -> Hashtbl.replace available (sha256 text) text)
    (f.own.statement_text :: f.beside)) found;
  let once pair = match Hashtbl.find_opt known pair with
    | Some report -> report
    | None ->
        let report = with_hypotheses pair (check available pair) in
        Hashtbl.add known pair report; report in
  let reports = List.map (fun f ->
    let others = List.map once f.proofs in
    let report = with_cited (once f.own) others in
    List.iter (fun x -> if x.verdict_ = Proved_ then Hashtbl.replace closed x.hash x) (report :: others);
    f.path, report) found in
  let worst found (path, report) =
    let verdict_, words = said available closed report in
    Printf.printf "%s: %s\n%!" (shown path) (shown words);
    max found verdict_ in
  exit_code (List.fold_left worst Proved_ reports)

let complaint code words = prerr_endline ("reader: " ^ shown words); exit code
let () =
  match List.tl (Array.to_list Sys.argv) with
  | [] -> complaint 2 "found no folder; write: reader FOLDER [FOLDER ...]"
  | folders ->
      (match run folders with
       | code -> exit code
       | exception Unusable why -> complaint 2 why
       | exception (Sys_error why) -> complaint 2 why
       | exception e -> complaint 5 ("an error of its own: " ^ Printexc.to_string e))
