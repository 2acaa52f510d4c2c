(* What a value of JSON has to look like to be read further: texts, names, numbers, objects with their
   keys. Whatever is not as `certificates/README.md` has it is `Bad`, with a reason for messages; what
   has been read so far is handed on from one step to the next. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive.
From Verify Require Import Json ReadJson.
Import ListNotations.
Open Scope N_scope.

(* --- steps that may find something bad ---------------------------------------------------------- *)

Inductive result (K A : Type) : Type :=
  | Ok (found : A) (k : K)
  | Bad (why : string) (what : list byte).
Arguments Ok {K A}.
Arguments Bad {K A}.
Definition reading (K A : Type) : Type := K -> result K A.
Notation "'let!' x := a 'in' b" :=
  (fun k => match a k with Ok x k1 => b k1 | Bad why what => Bad why what end)
  (at level 200, x pattern, a at level 100, b at level 200).
Definition ret {K A} (x : A) : reading K A := Ok x.
Definition bad {K A} (why : string) : reading K A := fun _ => Bad why [].
Definition bad_name {K A} (why : string) (what : list byte) : reading K A := fun _ => Bad why what.
Definition need {K} (good : bool) (why : string) : reading K unit :=
  if good then ret tt else bad why.
Definition from {K A} (x : option A) (why : string) : reading K A :=
  match x with Some x => ret x | None => bad why end.

Section Over.
Context {K : Type}.
Context {A : Type}.
Context {B : Type}.
Variable f : A -> reading K B.
(* The results for the items of a list, in order, after those that are found. *)
Fixpoint over (found : list B) (l : list A) : reading K (list B) :=
  match l with
  | [] => ret (rev_append found [])
  | a :: l => let! b := f a in over (b :: found) l
  end.
End Over.
Definition all {K A B} (f : A -> reading K B) : list A -> reading K (list B) := over f [].

(* --- texts -------------------------------------------------------------------------------------- *)

Fixpoint same (s t : list byte) : bool :=
  match s, t with
  | [], [] => true
  | a :: s, b :: t => Byte.eqb a b && same s t
  | _, _ => false
  end.
Definition is (w : string) (s : list byte) : bool := same (list_byte_of_string w) s.
Fixpoint find_key {A} (s : list byte) (l : list (list byte * A)) : option A :=
  match l with [] => None | (t, x) :: l => if same s t then Some x else find_key s l end.
(* What a table has for a word. *)
Definition choice {A} (l : list (string * A)) (s : list byte) : option A :=
  option_map snd (find (fun x => is (fst x) s) l).

Definition letter (b : byte) : bool := between 65 90 b || between 97 122 b.
Definition in_name (b : byte) : bool :=
  letter b || digit b || existsb (Byte.eqb b) ["_"; "."; "-"]%byte.
Definition is_name (s : list byte) : bool :=
  match s with b :: _ => letter b && at_most 100 s && forallb in_name s | [] => false end.
Fixpoint split (at_ : byte) (part s : list byte) : list (list byte) :=
  match s with
  | [] => [rev_append part []]
  | b :: s =>
      if Byte.eqb b at_ then rev_append part [] :: split at_ [] s else split at_ (b :: part) s
  end.
Definition parts (at_ : byte) (s : list byte) : list (list byte) := split at_ [] s.

(* --- numbers ------------------------------------------------------------------------------------ *)

Definition digits_only (s : list byte) : bool := forallb digit s.
Definition number_of (s : list byte) : N := fold_left add_digit s 0.
Definition is_whole (s : list byte) : bool :=
  match s with
  | [] => false
  | [b] => digit b
  | b :: _ => negb (Byte.eqb b "0"%byte) && at_most 4300 s && digits_only s
  end.
Definition unsigned (s : list byte) : bool * list byte :=
  match s with
  | b :: rest => if Byte.eqb b "-"%byte then (true, rest) else (false, s)
  | [] => (false, s)
  end.
Definition signed (minus : bool) (n : N) : Z :=
  if minus then Z.opp (Z.of_N n) else Z.of_N n.
Definition rational_of (s : list byte) : option Q :=
  let (minus, s) := unsigned s in
  match parts "/"%byte s with
  | [a] => if is_whole a then Some (Qmake (signed minus (number_of a)) 1) else None
  | [a; b] =>
      if is_whole a && is_whole b then
        match number_of b with
        | N0 => None
        | Npos d => Some (Qred (Qmake (signed minus (number_of a)) d))
        end
      else None
  | _ => None
  end.
(* The power of ten after an e. *)
Definition power_of (s : list byte) : option (list byte * Z) :=
  match parts "e"%byte s with
  | [a] => Some (a, 0%Z)
  | [a; e] =>
      let (minus, d) := unsigned e in
      match d with
      | _ :: _ =>
          if at_most 5 d && digits_only d then Some (a, signed minus (number_of d)) else None
      | [] => None
      end
  | _ => None
  end.
Definition decimal_of (s : list byte) : option Q :=
  let (minus, s) := unsigned s in
  match power_of s with
  | None => None
  | Some (base, e) =>
      let read a b :=
        if is_whole a && at_most 100 a && digits_only b && at_most 99 b then
          let digits := signed minus (number_of (a ++ b)) in
          let power := (e - Z.of_nat (length b))%Z in
          match (10 ^ Z.abs power)%Z with
          | Zpos ten =>
              Some (if (0 <=? power)%Z then Qmake (digits * Zpos ten) 1 else Qred (Qmake digits ten))
          | _ => None
          end
        else None in
      match parts "."%byte base with
      | [a] => read a []
      | [a; (_ :: _) as b] => read a b
      | _ => None
      end
  end.
Definition exponent_of (s : list byte) : option positive :=
  if is_whole s && at_most 3 s then
    match number_of s with N0 => None | Npos n => Some n end
  else None.

(* --- values of JSON ----------------------------------------------------------------------------- *)

Section Shapes.
Context {K : Type}.

Definition str (x : json) : reading K (list byte) :=
  match x with JStr s => ret s | _ => bad "expected a text" end.
Definition items_of (x : json) : reading K (list json) :=
  match x with JList l => ret l | _ => bad "expected a list" end.
Definition members_of (x : json) : reading K (list (list byte * json)) :=
  match x with JObj l => ret l | _ => bad "expected an object" end.
Definition optional {A} (f : json -> reading K A) (x : json) : reading K (option A) :=
  match x with JNull => ret None | _ => let! y := f x in ret (Some y) end.
Definition among {A} (l : list (string * A)) (x : json) : reading K A :=
  let! s := str x in
  from (choice l s) ("expected " ++ String.concat ", " (map fst l)).
Definition name (x : json) : reading K (list byte) :=
  let! s := str x in if is_name s then ret s else bad_name "no name: " s.
(* Names of what is cited, too: with the citations before them, and colons. *)
Definition long_name (x : json) : reading K (list byte) :=
  let! s := str x in
  if forallb is_name (parts ":"%byte s) then ret s else bad_name "no name: " s.
Definition rational (s : list byte) : reading K Q :=
  match rational_of s with Some q => ret q | None => bad_name "no number: " s end.
Definition decimal (x : json) : reading K Q :=
  let! s := str x in from (decimal_of s) "a decimal number".
Definition exponent (x : json) : reading K positive :=
  let! s := str x in from (exponent_of s) "expected an exponent".
Definition root_index (x : json) : reading K positive :=
  let! n := exponent x in
  if (2 <=? n)%positive && (n <=? 99)%positive then ret n else bad "expected the index of a root".
Definition bits_in (x : json) : reading K positive :=
  match x with
  | JInt (Npos n) => if (2 <=? n)%positive && (n <=? 65536)%positive then ret n else bad "bits"
  | _ => bad "bits"
  end.
Definition digest (x : json) : reading K (list byte) :=
  let! s := str x in
  let! _ := need (at_most 64 s && negb (at_most 63 s) &&
    forallb (fun b => digit b || between 97 102 b) s) "a digest" in
  ret s.

(* The values of an object with these keys and no others, in the order of the keys. *)
Definition record (keys : list string) (x : json) : reading K (list json) :=
  let why := ("an object has to have the keys " ++ String.concat ", " keys)%string in
  match x with
  | JObj l =>
      if Nat.eqb (length l) (length keys) then
        all (fun w => from (find_key (list_byte_of_string w) l) why) keys
      else bad why
  | _ => bad why
  end.
Definition no_record {A} : reading K A := bad "an object with other keys".
Definition texts (l : list json) : reading K unit := let! _ := all str l in ret tt.
End Shapes.
