(* JSON, as `certificates/README.md` admits it: what texts, as lists of bytes, are documents, and
   which value each has.

   A document is UTF-8 of at most 4 MiB, with at most 100 nested brackets and no key twice in an
   object; its only numbers are natural ones below 10^9. All else is as RFC 8259 has it. Texts in a
   value are in UTF-8, too; half a surrogate pair, which may be escaped alone, is encoded there as
   if it were a letter. `ReadJson.v` reads such documents. *)
From Coq Require Import Bool String List Arith ZArith Strings.Byte.
Import ListNotations.
Open Scope N_scope.

Inductive json :=
  | JNull
  | JBool (b : bool)
  | JInt (n : N)
  | JStr (s : list byte)
  | JList (l : list json)
  | JObj (l : list (list byte * json)).

(* --- letters ----------------------------------------------------------------------------------- *)

Definition quote : byte := x22.
Definition backslash : byte := x5c.
Definition blank (b : byte) : bool := existsb (Byte.eqb b) [x20; x0a; x0d; x09].
Definition Blank (t : list byte) : Prop := Forall (fun b => blank b = true) t.
Definition between (low high : N) (b : byte) : bool :=
  (low <=? Byte.to_N b) && (Byte.to_N b <=? high).
Definition digit : byte -> bool := between 48 57.

(* The bytes of a letter in UTF-8, by its number (RFC 3629). *)
Inductive Encoded (n : N) : list byte -> Prop :=
  | in_one a : Byte.to_N a = n -> n < 0x80 -> Encoded n [a]
  | in_two x y a b :
      Byte.to_N a = 0xc0 + x -> Byte.to_N b = 0x80 + y -> y < 64 ->
      n = 64 * x + y -> 0x80 <= n < 0x800 -> Encoded n [a; b]
  | in_three x y z a b c :
      Byte.to_N a = 0xe0 + x -> Byte.to_N b = 0x80 + y -> Byte.to_N c = 0x80 + z ->
      y < 64 -> z < 64 -> n = 4096 * x + 64 * y + z -> 0x800 <= n < 0x10000 ->
      Encoded n [a; b; c]
  | in_four w x y z a b c d :
      Byte.to_N a = 0xf0 + w -> Byte.to_N b = 0x80 + x -> Byte.to_N c = 0x80 + y ->
      Byte.to_N d = 0x80 + z -> x < 64 -> y < 64 -> z < 64 ->
      n = 262144 * w + 4096 * x + 64 * y + z -> 0x10000 <= n < 0x110000 ->
      Encoded n [a; b; c; d].
Definition Surrogate (n : N) : Prop := 0xd800 <= n < 0xe000.
Inductive Utf8 : list byte -> Prop :=
  | no_letter : Utf8 []
  | a_letter n e t : Encoded n e -> ~ Surrogate n -> Utf8 t -> Utf8 (e ++ t).

(* --- texts ------------------------------------------------------------------------------------- *)

Definition hexadecimal_digit (b : byte) : option N :=
  if digit b then Some (Byte.to_N b - 48)
  else if between 97 102 b then Some (Byte.to_N b - 87)
  else if between 65 70 b then Some (Byte.to_N b - 55)
  else None.
Definition four_digits (a b c d : byte) : option N :=
  match hexadecimal_digit a, hexadecimal_digit b, hexadecimal_digit c, hexadecimal_digit d with
  | Some w, Some x, Some y, Some z => Some (4096 * w + 256 * x + 16 * y + z)
  | _, _, _, _ => None
  end.

(* What a letter after a backslash stands for. *)
Definition short (b : byte) : option byte :=
  option_map snd (find (fun p => Byte.eqb (fst p) b)
    [(quote, quote); (backslash, backslash); ("/", "/"); ("b", x08); ("f", x0c); ("n", x0a);
     ("r", x0d); ("t", x09)]%byte).
Definition plain (b : byte) : bool :=
  negb (Byte.eqb b quote) && negb (Byte.eqb b backslash) && (32 <=? Byte.to_N b).

(* Two escaped halves in a row are one letter. *)
Definition high (n : N) : bool := (0xd800 <=? n) && (n <=? 0xdbff).
Definition low (n : N) : bool := (0xdc00 <=? n) && (n <=? 0xdfff).
Definition joined (n m : N) : N := 0x10000 + (n - 0xd800) * 0x400 + (m - 0xdc00).
(* The lower half with which a text begins, and what comes after it. *)
Definition low_ahead (t : list byte) : option (N * list byte) :=
  match t with
  | x :: y :: a :: b :: c :: d :: rest =>
      if Byte.eqb x backslash && Byte.eqb y "u"%byte then
        match four_digits a b c d with
        | Some m => if low m then Some (m, rest) else None
        | None => None
        end
      else None
  | _ => None
  end.

(* What stands between quotes, and the text that is meant. *)
Inductive Chars : list byte -> list byte -> Prop :=
  | chars_end : Chars [] []
  | chars_plain b t s : plain b = true -> Chars t s -> Chars (b :: t) (b :: s)
  | chars_short e c t s :
      short e = Some c -> Chars t s -> Chars (backslash :: e :: t) (c :: s)
  | chars_escaped a b c d n e t s :
      four_digits a b c d = Some n -> (high n = true -> low_ahead t = None) -> Encoded n e ->
      Chars t s -> Chars (backslash :: "u"%byte :: a :: b :: c :: d :: t) (e ++ s)
  | chars_pair a b c d n m e t rest s :
      four_digits a b c d = Some n -> high n = true -> low_ahead t = Some (m, rest) ->
      Encoded (joined n m) e ->
      Chars rest s -> Chars (backslash :: "u"%byte :: a :: b :: c :: d :: t) (e ++ s).

(* --- numbers, words, lists, objects ------------------------------------------------------------ *)

Definition add_digit (n : N) (b : byte) : N := 10 * n + (Byte.to_N b - 48).
Inductive Natural : list byte -> N -> Prop :=
  | zero : Natural ["0"%byte] 0
  | natural b t :
      b <> "0"%byte -> Forall (fun b => digit b = true) (b :: t) -> (length t <= 8)%nat ->
      Natural (b :: t) (fold_left add_digit (b :: t) 0).

Inductive Scalar : list byte -> json -> Prop :=
  | null_word : Scalar (list_byte_of_string "null") JNull
  | true_word : Scalar (list_byte_of_string "true") (JBool true)
  | false_word : Scalar (list_byte_of_string "false") (JBool false)
  | number t n : Natural t n -> Scalar t (JInt n)
  | text t s : Chars t s -> Scalar (quote :: t ++ [quote]) (JStr s).

(* Items with commas between them, if `R t x` says that t is a text of the item x. *)
Inductive Items {A} (R : list byte -> A -> Prop) : list byte -> list A -> Prop :=
  | last_item t x w : R t x -> Blank w -> Items R (t ++ w) [x]
  | next_item t x w u l :
      R t x -> Blank w -> Items R u l -> Items R (t ++ w ++ ","%byte :: u) (x :: l).
Definition Bracketed {A} (R : list byte -> A -> Prop) (opening closing : byte)
    (t : list byte) (l : list A) : Prop :=
  exists u, t = opening :: u ++ [closing] /\ ((Blank u /\ l = []) \/ Items R u l).

Definition Indented {A} (R : list byte -> A -> Prop) (t : list byte) (x : A) : Prop :=
  exists w u, t = w ++ u /\ Blank w /\ R u x.
Definition Member {A} (R : list byte -> A -> Prop) (t : list byte) (x : list byte * A) : Prop :=
  exists w c w' u, t = w ++ quote :: c ++ quote :: w' ++ ":"%byte :: u /\
    Blank w /\ Chars c (fst x) /\ Blank w' /\ Indented R u (snd x).

(* A value with at most so many nested brackets. *)
Fixpoint Value (depth : nat) (t : list byte) (v : json) : Prop :=
  Scalar t v \/
  match depth with
  | O => False
  | S less =>
      (exists l, v = JList l /\ Bracketed (Indented (Value less)) "["%byte "]"%byte t l) \/
      (exists l, v = JObj l /\ Bracketed (Member (Value less)) "{"%byte "}"%byte t l /\
        NoDup (map fst l))
  end.

Definition most_bytes : N := 4194304.
Definition Document (t : list byte) (v : json) : Prop :=
  Utf8 t /\ N.of_nat (length t) <= most_bytes /\
  exists w u w', t = w ++ u ++ w' /\ Blank w /\ Value 100 u v /\ Blank w'.
