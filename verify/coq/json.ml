(* Files for the extracted program: JSON and SHA-256 come from Coq (Json.v, JsonRead.v, Sha256.v), and
   this turns OCaml's strings into Coq's lists of bytes, and values of Coq into values of OCaml. *)
exception Malformed of string
let bad what = raise (Malformed what)
let need good what = if not good then bad what

type json = Null | Bool of bool | Int of int | Str of string | List of json list | Obj of (string * json) list

let bytes s =
  let rec before i found = if i = 0 then found else before (i - 1) (s.[i - 1] :: found) in
  before (String.length s) []
let text l =
  let b = Buffer.create 16 in
  List.iter (Buffer.add_char b) l; Buffer.contents b

(* Tail-recursive, since a list may be as long as a file. *)
let each f l = List.rev (List.rev_map f l)
let rec positive = function
  | Document.XH -> 1 | Document.XO p -> 2 * positive p | Document.XI p -> 2 * positive p + 1
let rec value = function
  | Document.JNull -> Null
  | Document.JBool b -> Bool b
  | Document.JInt Document.N0 -> Int 0
  | Document.JInt (Document.Npos p) -> Int (positive p)
  | Document.JStr s -> Str (text s)
  | Document.JList l -> List (each value l)
  | Document.JObj l -> Obj (each (fun (key, x) -> text key, value x) l)

(* The value of a document. *)
let parse s = match Document.document (bytes s) with
  | Some found -> value found
  | None -> bad "no JSON as the format has it: UTF-8 of at most 4 MiB, no key twice, at most 100 \
                 nested brackets, and natural numbers below 10^9"
(* The digest of a text, in hexadecimal digits. Each is computed once. *)
let digests = Hashtbl.create 9
let sha256 s = match Hashtbl.find_opt digests s with
  | Some found -> found
  | None ->
      let found = text (Document.hexadecimal (Document.sha256 (bytes s))) in
      Hashtbl.add digests s found; found
