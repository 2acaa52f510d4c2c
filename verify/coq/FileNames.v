(* What the answer on a file is printed with: the sentences that a statement takes on trust, those of
   them that only printed rows use, and the statements that it cites. *)
From Coq Require Import Bool String List Strings.Byte.
From Verify Require Import Json ReadJson Decode.
Import ListNotations.

Record cited_one := Cited { cited_name : list byte; cited_theorem : list byte; cited_digest : list byte }.
Record summary := Summary {
  sentences : list (list byte);
  printed_only : list (list byte);
  cites : list cited_one
}.

Definition at_key (w : string) (x : json) : json :=
  match x with
  | JObj l => match find_key (list_byte_of_string w) l with Some y => y | None => JNull end
  | _ => JNull
  end.
Definition items_at (w : string) (x : json) : list json :=
  match at_key w x with JList l => l | _ => [] end.
Definition text_of (x : json) : list byte := match x with JStr s => s | _ => [] end.
Definition is_text (x : json) : bool := match x with JStr _ => true | _ => false end.

Definition uses (needed : bool) (x : json) : list json :=
  flat_map (fun row => if Bool.eqb (is "needed" (text_of (at_key "role" row))) needed
    then items_at "uses" row else []) (items_at "obligations" x).
Definition given_at_contexts (x : json) : list json :=
  flat_map (fun c => map (at_key "assumption") (items_at "givens" c)) (items_at "contexts" x).
Definition has (l : list json) (s : list byte) : bool :=
  existsb (fun x => is_text x && same s (text_of x)) l.
Definition summary_of (text : list byte) : option summary :=
  match document text with
  | None => None
  | Some x =>
      let names := map (fun a => text_of (at_key "name" a)) (items_at "assumptions" x) in
      let for_needed := given_at_contexts x ++ uses true x in
      let for_printed := uses false x in
      Some (Summary names (filter (fun s => has for_printed s && negb (has for_needed s)) names)
        (map (fun item => Cited (text_of (at_key "name" item)) (text_of (at_key "theorem" item))
          (text_of (at_key "statement_sha256" item))) (items_at "cites" x)))
  end.
