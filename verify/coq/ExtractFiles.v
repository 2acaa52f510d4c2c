(* JSON and SHA-256 as an OCaml program; a byte is a char, and numbers stay Coq's own. *)
From Verify Require Import Sha256 ReadJson.
From Coq Require Import ExtrOcamlBasic ExtrOcamlChar.
Extraction Language OCaml.
(* Without a branch, since SHA-256 takes it for each bit. *)
Extract Constant xorb => "fun (a : bool) b -> a <> b".
Extraction "document.ml" document sha256 hexadecimal.
