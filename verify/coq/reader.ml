(* Reads statement.json and certificate.json, and asks the checker that is extracted from Coq:

     reader FOLDER [FOLDER ...]

   One line for each folder: PROVED, with the sentences that are given and with what is cited and not
   proved in this run; or why not. In it, what is not ASCII is \xNN. Exit code 0 if all are proved, 1 if
   one is refused, 2 if a file cannot be read (a line on stderr), 4 if one is malformed, 5 for an error
   of its own. It counts no work: a folder that takes more than a minute of the processor, or a
   gigabyte, is malformed. The answer on the bytes of the files is Coq's (AcceptsFiles.v). What has to be
   believed here is that these are the bytes of the files, that the answer is printed, and that what is
   cited counts as proved only where a certificate of it is accepted. *)
open Checker

exception Malformed of string

let bytes s =
  let rec before i found = if i = 0 then found else before (i - 1) (s.[i - 1] :: found) in
  before (String.length s) []
let text l =
  let b = Buffer.create 16 in
  List.iter (Buffer.add_char b) l; Buffer.contents b

(* --- files ------------------------------------------------------------------------------------ *)

(* A text in one line of ASCII, whatever is in it. *)
let shown s =
  let b = Buffer.create 99 in
  String.iter (fun c ->
    if c >= ' ' && c <= '~' && c <> '\\' then Buffer.add_char b c
    else Printf.bprintf b "\\x%02x" (Char.code c)) s;
  Buffer.contents b

exception Unusable of string
(* A longer text is no document; its digest, which is slow, is not asked for. *)
let most_bytes = 1 lsl 22
let is_short s = String.length s <= most_bytes
let is_file path = try (Unix.stat path).Unix.st_kind = Unix.S_REG with Unix.Unix_error _ -> false
let is_folder path = try Sys.is_directory path with Sys_error _ -> false
let read_file path =
  if not (is_file path) then raise (Unusable (path ^ " is no file"));
  try
    let input = open_in_bin path in
    let text = really_input_string input (min (in_channel_length input) (most_bytes + 1)) in
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
type report = { verdict_ : verdict_; why : string; hash : string; names : summary }
let nothing_named = { sentences = []; printed_only = []; cites = [] }
let rec int_of_nat = function O -> 0 | S n -> 1 + int_of_nat n

let seconds = 60. and words = 1 lsl 27
let too_much = Malformed "more than a minute of work, or a gigabyte"
(* What a function answers, within these limits. *)
let limited f x =
  let timer value = ignore (Unix.setitimer Unix.ITIMER_VIRTUAL { Unix.it_interval = 0.; it_value = value }) in
  Sys.set_signal Sys.sigvtalrm (Sys.Signal_handle (fun _ -> raise too_much));
  let heap () = (Gc.quick_stat ()).Gc.heap_words in
  let before = heap () in
  let alarm = Gc.create_alarm (fun () -> if heap () > before + words then raise too_much) in
  let stop () = timer 0.; Gc.delete_alarm alarm in
  timer seconds;
  match f x with
  | found -> stop (); found
  | exception (Stack_overflow | Out_of_memory) -> stop (); raise too_much
  | exception e -> stop (); raise e

(* Statements by their digests; and the digests of their texts. *)
type library = { found : (char list * char list) list; digests : (string, char list) Hashtbl.t }
let library texts =
  let texts = List.filter is_short texts and digests = Hashtbl.create 9 in
  let found = by_digest (List.map bytes texts) in
  List.iter2 (fun s (digest, _) -> Hashtbl.replace digests s digest) texts found;
  { found; digests }
let summary available digest = Option.bind (text_with available.found digest) summary_of

let check available pair =
  let long = not (is_short pair.statement_text) in
  let digest = if long then [] else Hashtbl.find available.digests pair.statement_text in
  let hash = text digest in
  let found () =
    accepts_beside available.found digest (bytes pair.certificate_text), summary available digest in
  let report verdict_ why names = { verdict_; why; hash; names } in
  let refused why names = report Refused_ why (Option.value names ~default:nothing_named) in
  if long then report Malformed_ (Printf.sprintf "more than %d bytes" most_bytes) nothing_named else
  match limited found () with
  | Accepts _, Some names -> report Proved_ "" names
  | Refuses (Some (AtStep n)), names ->
      refused ("step " ^ string_of_int (int_of_nat n) ^ " is refused") names
  | Refuses (Some (AtEnclosure _)), names -> refused "an enclosure is refused" names
  | Refuses _, names -> refused "not all that is needed is proved" names
  | IsMalformed (why, what), _ -> report Malformed_ (why ^ text what) nothing_named
  | Accepts _, None -> report Malformed_ "no JSON" nothing_named
  | exception Malformed why -> report Malformed_ why nothing_named

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
  let rec follow prefix one =
    let hash = text one.cited_digest in
    if Hashtbl.mem seen hash then [] else begin
      Hashtbl.add seen hash ();
      let prefix = prefix ^ text one.cited_name ^ ":" in
      let names = Option.get (summary available one.cited_digest) in
      (prefix, text one.cited_theorem, hash, List.map text names.sentences)
        :: List.concat_map (follow prefix) names.cites
    end in
  List.concat_map (follow "") report.names.cites

(* The verdict, and what it rests on: sentences, also those of what is cited, and what is cited and
   not proved in this run. Such a citation leaves the whole undecided. *)
let said available closed report = match report.verdict_ with
  | Refused_ -> Refused_, "REFUSED: " ^ report.why
  | Malformed_ -> Malformed_, "MALFORMED: " ^ report.why
  | Proved_ | Undecided_ ->
      let cited = citations available report in
      let opened = List.filter (fun (_, _, hash, _) -> not (Hashtbl.mem closed hash)) cited in
      let apart = Hashtbl.create 99 in
      let printed_only = List.map text report.names.printed_only in
      List.iter (fun s -> Hashtbl.replace apart s ()) printed_only;
      let own = List.filter (fun s -> not (Hashtbl.mem apart s)) (List.map text report.names.sentences) in
      let given = List.concat_map (fun (prefix, _, _, l) -> List.map (fun s -> prefix ^ s) l) cited in
      let names l = if l = [] then "nothing" else String.concat ", " l in
      let apart = if printed_only = [] then ""
        else "; for printed rows only, also given " ^ names printed_only in
      let citing (_, theorem, hash, _) =
        "; citing " ^ theorem ^ ", which is not proved here (" ^ hash ^ ")" in
      let verdict_, word = if opened = [] then Proved_, "PROVED" else Undecided_, "UNDECIDED" in
      verdict_, word ^ ": given " ^ names (own @ given) ^ apart
                ^ String.concat "" (List.map citing opened)
let exit_code = function Proved_ -> 0 | Undecided_ -> 3 | Refused_ -> 1 | Malformed_ -> 4

let run folders =
  let found = List.map read_folder folders in
  let known = Hashtbl.create 9 and closed = Hashtbl.create 9 in
  let texts = List.concat_map (fun f -> f.own.statement_text :: f.beside) found in
  let available = library (List.sort_uniq compare texts) in
  let once pair = match Hashtbl.find_opt known pair with
    | Some report -> report
    | None ->
        let report = check available pair in
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
(* Lists are as long as files: a larger room for what is new saves a tenth of the time. *)
let () =
  Gc.set { (Gc.get ()) with Gc.minor_heap_size = 1 lsl 20; space_overhead = 200 };
  match List.tl (Array.to_list Sys.argv) with
  | [] -> complaint 2 "found no folder; write: reader FOLDER [FOLDER ...]"
  | folders ->
      (match run folders with
       | code -> exit code
       | exception Unusable why -> complaint 2 why
       | exception (Sys_error why) -> complaint 2 why
       | exception e -> complaint 5 ("an error of its own: " ^ Printexc.to_string e))
