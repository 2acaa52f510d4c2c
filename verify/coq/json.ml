(* JSON, as strict as verify/check.py reads it: UTF-8 without a key twice, at most 4 MiB, at most 100
   nested brackets, and natural numbers below 10^9 as the only numbers. *)
exception Malformed of string
let bad what = raise (Malformed what)
let need good what = if not good then bad what

type json = Null | Bool of bool | Int of int | Str of string | List of json list | Obj of (string * json) list

let utf8 b code =
  if code < 0x80 then Buffer.add_char b (Char.chr code)
  else begin
    let tail shift = Buffer.add_char b (Char.chr (0x80 lor ((code lsr shift) land 63))) in
    if code < 0x800 then (Buffer.add_char b (Char.chr (0xc0 lor (code lsr 6))); tail 0)
    else if code < 0x10000 then
      (Buffer.add_char b (Char.chr (0xe0 lor (code lsr 12))); tail 6; tail 0)
    else (Buffer.add_char b (Char.chr (0xf0 lor (code lsr 18))); tail 12; tail 6; tail 0)
  end

let is_utf8 s =
  let n = String.length s in
  let byte i = if i < n then Char.code s.[i] else 0 in
  let rec tail i k = k = 0 || (byte i land 0xc0 = 0x80 && tail (i + 1) (k - 1)) in
  let rec go i =
    i >= n ||
    let c = byte i in
    let k = if c < 0x80 then 0 else if c >= 0xc2 && c < 0xe0 then 1 else if c >= 0xe0 && c < 0xf0 then 2
      else if c >= 0xf0 && c < 0xf5 then 3 else -1 in
    let second = byte (i + 1) in
    k >= 0 && tail (i + 1) k
    && not (c = 0xe0 && second < 0xa0) && not (c = 0xed && second >= 0xa0)
    && not (c = 0xf0 && second < 0x90) && not (c = 0xf4 && second >= 0x90)
    && go (i + 1 + k) in
  go 0

(* The document in a text; no key twice, and natural numbers below 10^9 are the only ones. *)
let parse (s : string) : json =
  let n = String.length s and i = ref 0 in
  need (n <= 1 lsl 22) "more than 4 MiB";
  need (is_utf8 s) "no UTF-8";
  let peek () = if !i < n then s.[!i] else '\000' in
  let rec blank () =
    match peek () with ' ' | '\n' | '\t' | '\r' when !i < n -> incr i; blank () | _ -> () in
  let expect c = need (!i < n && s.[!i] = c) (Printf.sprintf "JSON: expected %c" c); incr i in
  let word w value =
    let k = String.length w in
    need (!i + k <= n && String.sub s !i k = w) "JSON"; i := !i + k; value in
  let rec hexadecimal code k =
    if k = 0 then code
    else begin
      need (!i < n) "JSON: an escape has no end";
      let digit = match s.[!i] with
        | '0' .. '9' as c -> Char.code c - 48
        | 'a' .. 'f' as c -> Char.code c - 87
        | 'A' .. 'F' as c -> Char.code c - 55
        | _ -> bad "JSON: expected four hexadecimal digits" in
      incr i; hexadecimal (16 * code + digit) (k - 1)
    end in
  (* What follows \u; two halves that belong together are one letter. *)
  let escaped () =
    let code = hexadecimal 0 4 in
    if code >= 0xd800 && code < 0xdc00 && !i + 2 <= n && String.sub s !i 2 = "\\u" then begin
      let back = !i in
      i := !i + 2;
      let low = hexadecimal 0 4 in
      if low >= 0xdc00 && low < 0xe000 then 0x10000 + ((code - 0xd800) lsl 10) + (low - 0xdc00)
      else (i := back; code)
    end else code in
  let text () =
    let b = Buffer.create 16 in
    expect '"';
    let rec go () =
      need (!i < n) "JSON: a text has no end";
      let c = s.[!i] in
      incr i;
      if c = '\\' then begin
        need (!i < n) "JSON"; let e = s.[!i] in incr i;
        (match e with
         | '"' | '\\' | '/' -> Buffer.add_char b e
         | 'b' -> Buffer.add_char b '\b' | 'f' -> Buffer.add_char b '\012'
         | 'n' -> Buffer.add_char b '\n' | 'r' -> Buffer.add_char b '\r'
         | 't' -> Buffer.add_char b '\t'
         | 'u' -> utf8 b (escaped ())
         | _ -> bad "JSON: an unknown escape");
        go ()
      end else if c <> '"' then (need (c >= ' ') "JSON: a control letter"; Buffer.add_char b c; go ())
    in
    go (); Buffer.contents b in
  let rec value depth =
    blank ();
    match peek () with
    | '[' | '{' when depth = 100 -> bad "more than 100 nested brackets"
    | '"' -> Str (text ())
    | '[' -> incr i; List (items ']' (fun () -> value (depth + 1)))
    | '{' ->
        incr i;
        let found = items '}' (fun () ->
          blank (); let key = text () in blank (); expect ':'; key, value (depth + 1)) in
        let keys = List.map fst found in
        need (List.length (List.sort_uniq compare keys) = List.length keys) "a key twice";
        Obj found
    | 'n' -> word "null" Null | 't' -> word "true" (Bool true) | 'f' -> word "false" (Bool false)
    | '0' .. '9' ->
        let start = !i in
        while (match peek () with '0' .. '9' | '.' | 'e' | 'E' | '+' | '-' -> true | _ -> false) do incr i done;
        let t = String.sub s start (!i - start) in
        need (String.length t <= 9 && String.for_all (fun c -> c >= '0' && c <= '9') t
              && (t = "0" || t.[0] <> '0')) "numbers have to be texts";
        Int (int_of_string t)
    | _ -> bad "JSON"
  and items : 'a. char -> (unit -> 'a) -> 'a list = fun close item ->
    blank ();
    if peek () = close then (incr i; [])
    else
      let rec more found =
        let found = item () :: found in
        blank ();
        if peek () = ',' then (incr i; more found) else (expect close; List.rev found) in
      more [] in
  let found = value 0 in
  blank (); need (!i = n) "JSON: more than one value"; found
