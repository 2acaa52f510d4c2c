(* The checker as an OCaml program, from the bytes of two files to the answer (AcceptsFiles.v); a byte
   is a char, and numbers stay Coq's own. reader.ml reads the files and prints the answer. *)
From Verify Require Import FileNames AcceptsFiles.
From Coq Require Import ExtrOcamlBasic ExtrOcamlChar ExtrOcamlNativeString.
Extraction Language OCaml.
(* Without a branch, since SHA-256 takes it for each bit. *)
Extract Constant xorb => "fun (a : bool) b -> a <> b".
(* The reals are there since libraries mention them; nothing that is computed uses them. *)
Extract Constant ClassicalDedekindReals.sig_forall_dec => "fun _ -> assert false".
Extraction "checker.ml" by_digest text_with accepts_beside summary_of.
