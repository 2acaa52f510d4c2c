(* The checker as an OCaml program; numbers stay Coq's own, so that nothing but the reader of files
   (ExtractFiles.v, json.ml, reader.ml) has to be believed besides. *)
From Coq Require Import ZArith QArith.
From Verify Require Import Meaning Clearing Kernel Checker.
From Coq Require Import ExtrOcamlBasic.
Extraction Language OCaml.
(* The reals are there since libraries mention them; nothing that is computed uses them. *)
Extract Constant ClassicalDedekindReals.sig_forall_dec => "fun _ -> assert false".
Extraction "checker.ml" accepts complaint_about Z.add Z.mul Z.opp Z.of_nat Pos.of_nat Qred Z.pow.
