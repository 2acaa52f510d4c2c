(* Reads documents in hexadecimal digits, a line each. Writes the digest of each, if it is short, and
   the document as the extracted reader of JSON has read it, also in hexadecimal digits; or a minus
   sign where it is refused. *)
open Document

let bytes s = List.of_seq (String.to_seq s)
let text l = String.of_seq (List.to_seq l)
let rec positive = function XH -> 1 | XO p -> 2 * positive p | XI p -> 2 * positive p + 1
let hex s = String.concat "" (List.map (fun c -> Printf.sprintf "%02x" (Char.code c)) (List.of_seq (String.to_seq s)))
let unhex s = String.init (String.length s / 2) (fun i -> Char.chr (int_of_string ("0x" ^ String.sub s (2 * i) 2)))
let quoted b s =
  Buffer.add_char b '"';
  String.iter (fun c ->
    if c < ' ' || c = '"' || c = '\\' then Printf.bprintf b "\\u%04x" (Char.code c)
    else Buffer.add_char b c) s;
  Buffer.add_char b '"'
let rec written b = function
  | JNull -> Buffer.add_string b "null"
  | JBool x -> Buffer.add_string b (string_of_bool x)
  | JInt N0 -> Buffer.add_string b "0"
  | JInt (Npos n) -> Buffer.add_string b (string_of_int (positive n))
  | JStr s -> quoted b (text s)
  | JList l -> Buffer.add_char b '['; between b (written b) l; Buffer.add_char b ']'
  | JObj l ->
      Buffer.add_char b '{';
      between b (fun (k, x) -> quoted b (text k); Buffer.add_char b ':'; written b x) l;
      Buffer.add_char b '}'
and between : 'a. Buffer.t -> ('a -> unit) -> 'a list -> unit = fun b f l ->
  List.iteri (fun i x -> if i > 0 then Buffer.add_char b ','; f x) l

let () =
  try
    while true do
      let b = Buffer.create 999 in
      let found = unhex (input_line stdin) in
      let digest () = text (hexadecimal (sha256 (bytes found))) in
      print_string ((if String.length found < 250 then digest () else "-") ^ " ");
      (match document (bytes found) with
       | Some value -> written b value; print_string (hex (Buffer.contents b))
       | None -> print_char '-');
      print_newline ()
    done
  with End_of_file -> ()
