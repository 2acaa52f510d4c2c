(* Reads JSON: `document` finds the value of a text if it is a document in the sense of `Json.v`, and
   `document_reads` says that it finds that value and no other, and nothing in other texts.

   Lists may be as long as a file, so that all loops that are as long are tail-recursive. A loop that
   does not follow its input step by step gets a list that is long enough instead. *)
From Coq Require Import Bool String List Arith ZArith Lia Strings.Byte MSets.MSetPositive.
From Verify Require Import Json.
Import ListNotations.
Open Scope N_scope.

(* --- UTF-8 ------------------------------------------------------------------------------------- *)

Definition to_byte (n : N) : byte := match Byte.of_N n with Some b => b | None => x00 end.
Definition tail (n : N) : byte := to_byte (0x80 + n mod 64).
Definition encode (n : N) : list byte :=
  if n <? 0x80 then [to_byte n]
  else if n <? 0x800 then [to_byte (0xc0 + n / 64); tail n]
  else if n <? 0x10000 then [to_byte (0xe0 + n / 4096); tail (n / 64); tail n]
  else [to_byte (0xf0 + n / 262144); tail (n / 4096); tail (n / 64); tail n].

Definition follows : byte -> bool := between 0x80 0xbf.
Definition three (a b c : byte) : bool :=
  let n := 4096 * (Byte.to_N a - 0xe0) + 64 * (Byte.to_N b - 0x80) + (Byte.to_N c - 0x80) in
  follows b && follows c && (0x800 <=? n) && negb ((0xd800 <=? n) && (n <? 0xe000)).
Definition four (a b c d : byte) : bool :=
  let n := 262144 * (Byte.to_N a - 0xf0) + 4096 * (Byte.to_N b - 0x80)
           + 64 * (Byte.to_N c - 0x80) + (Byte.to_N d - 0x80) in
  follows b && follows c && follows d && (0x10000 <=? n) && (n <? 0x110000).
Fixpoint utf8 (s : list byte) : bool :=
  match s with
  | [] => true
  | a :: s =>
      if Byte.to_N a <? 0x80 then utf8 s
      else match s with
      | [] => false
      | b :: s =>
          if Byte.to_N a <? 0xe0
          then if (0xc2 <=? Byte.to_N a) && follows b then utf8 s else false
          else match s with
          | [] => false
          | c :: s =>
              if Byte.to_N a <? 0xf0 then if three a b c then utf8 s else false
              else match s with
              | [] => false
              | d :: s => if four a b c d then utf8 s else false
              end
          end
      end
  end.

(* --- texts ------------------------------------------------------------------------------------- *)

Fixpoint skip (s : list byte) : list byte :=
  match s with b :: rest => if blank b then skip rest else s | [] => [] end.

Definition unicode (s : list byte) : option (list byte * list byte) :=
  match s with
  | a :: b :: c :: d :: rest =>
      match four_digits a b c d with
      | Some n =>
          match (if high n then low_ahead rest else None) with
          | Some (m, rest) => Some (encode (joined n m), rest)
          | None => Some (encode n, rest)
          end
      | None => None
      end
  | _ => None
  end.
Definition escaped (s : list byte) : option (list byte * list byte) :=
  match s with
  | e :: rest =>
      match short e with
      | Some c => Some ([c], rest)
      | None => if Byte.eqb e "u"%byte then unicode rest else None
      end
  | [] => None
  end.
Fixpoint chars (fuel found s : list byte) : option (list byte * list byte) :=
  match fuel, s with
  | _ :: less, b :: rest =>
      if Byte.eqb b quote then Some (rev_append found [], rest)
      else if Byte.eqb b backslash then
        match escaped rest with
        | Some (e, rest) => chars less (rev_append e found) rest
        | None => None
        end
      else if 32 <=? Byte.to_N b then chars less (b :: found) rest
      else None
  | _, _ => None
  end.

(* --- numbers, words, lists, objects ------------------------------------------------------------ *)

Fixpoint digits (count : nat) (n : N) (s : list byte) : N * list byte :=
  match count, s with
  | S less, b :: rest => if digit b then digits less (add_digit n b) rest else (n, s)
  | _, _ => (n, s)
  end.
Definition read_number (s : list byte) : option (N * list byte) :=
  match s with
  | b :: rest =>
      if Byte.eqb b "0"%byte then Some (0, rest)
      else if digit b then Some (digits 8 (add_digit 0 b) rest)
      else None
  | [] => None
  end.

Fixpoint strip (word s : list byte) : option (list byte) :=
  match word, s with
  | [], _ => Some s
  | a :: word, b :: s => if Byte.eqb a b then strip word s else None
  | _, [] => None
  end.
Definition word (w : string) (v : json) (s : list byte) : option (json * list byte) :=
  option_map (pair v) (strip (list_byte_of_string w) s).

(* A function that reads an item where a text begins, and says what comes after it. *)
Definition reader (A : Type) : Type := list byte -> option (A * list byte).

Fixpoint items {A} (item : reader A) (closing : byte) (fuel : list byte) (found : list A)
    (s : list byte) : option (list A * list byte) :=
  match fuel with
  | [] => None
  | _ :: less =>
      match item s with
      | None => None
      | Some (x, rest) =>
          match skip rest with
          | [] => None
          | b :: rest =>
              if Byte.eqb b ","%byte then items item closing less (x :: found) rest
              else if Byte.eqb b closing then Some (rev_append (x :: found) [], rest)
              else None
          end
      end
  end.
Definition bracketed {A} (item : reader A) (closing : byte) : reader (list A) := fun s =>
  match skip s with
  | [] => None
  | b :: rest => if Byte.eqb b closing then Some ([], rest) else items item closing s [] s
  end.
Definition indented {A} (item : reader A) : reader A := fun s => item (skip s).
Definition member {A} (item : reader A) : reader (list byte * A) := fun s =>
  match skip s with
  | [] => None
  | q :: s =>
      if Byte.eqb q quote then
        match chars s [] s with
        | None => None
        | Some (key, s) =>
            match skip s with
            | [] => None
            | c :: s =>
                if Byte.eqb c ":"%byte then
                  match indented item s with
                  | Some (x, s) => Some ((key, x), s)
                  | None => None
                  end
                else None
            end
        end
      else None
  end.

(* A key as a number, to be found in a tree. *)
Definition bit (b : bool) (p : positive) : positive := if b then xI p else xO p.
Fixpoint as_number (key : list byte) : positive :=
  match key with
  | [] => xH
  | c :: key =>
      let '(b0, (b1, (b2, (b3, (b4, (b5, (b6, b7))))))) := Byte.to_bits c in
      bit b0 (bit b1 (bit b2 (bit b3 (bit b4 (bit b5 (bit b6 (bit b7 (as_number key))))))))
  end.
Fixpoint distinct {A} (seen : PositiveSet.t) (l : list (list byte * A)) : bool :=
  match l with
  | [] => true
  | (key, _) :: l =>
      let p := as_number key in
      if PositiveSet.mem p seen then false else distinct (PositiveSet.add p seen) l
  end.

Definition scalar (b : byte) (rest : list byte) : option (json * list byte) :=
  if Byte.eqb b quote then
    match chars rest [] rest with Some (t, rest) => Some (JStr t, rest) | None => None end
  else if Byte.eqb b "n"%byte then word "null" JNull (b :: rest)
  else if Byte.eqb b "t"%byte then word "true" (JBool true) (b :: rest)
  else if Byte.eqb b "f"%byte then word "false" (JBool false) (b :: rest)
  else match read_number (b :: rest) with
  | Some (n, rest) => Some (JInt n, rest)
  | None => None
  end.
Fixpoint value (depth : nat) (s : list byte) : option (json * list byte) :=
  match s with
  | [] => None
  | b :: rest =>
      if Byte.eqb b "["%byte then
        match depth with
        | O => None
        | S less =>
            match bracketed (indented (value less)) "]"%byte rest with
            | Some (l, rest) => Some (JList l, rest)
            | None => None
            end
        end
      else if Byte.eqb b "{"%byte then
        match depth with
        | O => None
        | S less =>
            match bracketed (member (value less)) "}"%byte rest with
            | Some (l, rest) => if distinct PositiveSet.empty l then Some (JObj l, rest) else None
            | None => None
            end
        end
      else scalar b rest
  end.

Fixpoint at_most (n : N) (s : list byte) : bool :=
  match s with [] => true | _ :: s => if n =? 0 then false else at_most (N.pred n) s end.
Definition document (s : list byte) : option json :=
  if at_most most_bytes s then
    if utf8 s then
      match value 100 (skip s) with
      | Some (v, rest) => match skip rest with [] => Some v | _ :: _ => None end
      | None => None
      end
    else None
  else None.
