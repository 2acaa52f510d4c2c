(* Reads documents in hexadecimal digits, a line each. Writes the digest of each, if it is short, and
   the document as verify/coq/json.ml has read it, also in hexadecimal digits; or a minus sign where
   it is refused. *)
open Json

let hex s = String.concat "" (List.map (fun c -> Printf.sprintf "%02x" (Char.code c)) (List.of_seq (String.to_seq s)))
let unhex s = String.init (String.length s / 2) (fun i -> Char.chr (int_of_string ("0x" ^ String.sub s (2 * i) 2)))
let quoted b s =
  Buffer.add_char b '"';
  String.iter (fun c ->
    if c < ' ' || c = '"' || c = '\\' then Printf.bprintf b "\\u%04x" (Char.code c)
    else Buffer.add_char b c) s;
  Buffer.add_char b '"'
let rec written b = function
  | Null -> Buffer.add_string b "null"
  | Bool x -> Buffer.add_string b (string_of_bool x)
  | Int n -> Buffer.add_string b (string_of_int n)
  | Str s -> quoted b s
  | List l -> Buffer.add_char b '['; between b (written b) l; Buffer.add_char b ']'
  | Obj l ->
      Buffer.add_char b '{';
      between b (fun (k, x) -> quoted b k; Buffer.add_char b ':'; written b x) l;
      Buffer.add_char b '}'
and between : 'a. Buffer.t -> ('a -> unit) -> 'a list -> unit = fun b f l ->
  List.iteri (fun i x -> if i > 0 then Buffer.add_char b ','; f x) l

let () =
  try
    while true do
      let b = Buffer.create 999 in
      let found = unhex (input_line stdin) in
      print_string ((if String.length found < 1000 then sha256 found else "-") ^ " ");
      (match parse found with
       | value -> written b value; print_string (hex (Buffer.contents b))
       | exception Malformed _ -> print_char '-');
      print_newline ()
    done
  with End_of_file -> ()
