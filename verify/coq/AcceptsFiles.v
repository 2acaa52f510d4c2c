(* From bytes to the answer: `accepts_files` reads the bytes of a statement.json and a
   certificate.json and says whether the statement is proved. `accepts_files_sound` says what it
   means that they are accepted. *)
From Coq Require Import Bool String List Arith ZArith QArith Strings.Byte FMapPositive.
From Verify Require Import Sha256 Json ReadJson JsonLetters JsonRead.
From Verify Require Import Meaning Terms Kernel Checker Accepted MoreNodes.
From Verify Require Import Decode DecodeTerms DecodeStatement DecodeFiles.
Import ListNotations.

Inductive answer : Type :=
  | Accepts (proved : statement)
  | Refuses (why : option complaint)
  | IsMalformed (why : string) (what : list byte).

Section Files.
(* The text of a cited statement, by its digest. *)
Variable cited : list byte -> option (list byte).

(* The last of the nodes are those of the certificate. *)
Definition added (before after : kernel) : list node :=
  rev_append (firstn (count (t after) - count (t before)) (made (t after))) [].
Definition certificate_of (hash c : list byte) (lines : list line) (own : list (list byte))
    : M certificate :=
  let! y := parsed c in certificate_in hash lines own y.
Definition checked (hash s c : list byte) : answer :=
  match parsed s nothing with
  | Bad why what => IsMalformed why what
  | Ok x _ =>
      match statement_in cited deepest [] x nothing with
      | Bad why what => IsMalformed why what
      | Ok (lines, own) k =>
          match certificate_of hash c lines own k with
          | Bad why what => IsMalformed why what
          | Ok C later =>
              let S := statement_from k lines in
              let larger := with_nodes (added k later) S in
              if names_its_own S then
                if accepts larger C then Accepts S else Refuses (complaint_about larger C)
              else IsMalformed "a name of no term" []
          end
      end
  end.
Definition accepts_files (s c : list byte) : answer := checked (hexadecimal (sha256 s)) s c.

Lemma parsed_is text (k later : kernel) x : parsed text k = Ok x later -> Document text x.
Proof.
  unfold parsed, from. destruct (document text) as [y|] eqn:E; [|discriminate].
  unfold ret. intros [= <- <-]. now apply document_reads.
Qed.

(* What is accepted is a document; it means a statement, which is true if what it cites is. *)
Theorem accepts_files_sound s c S : accepts_files s c = Accepts S ->
  exists x, Document s x /\ statement_of cited x = Some S /\
    (citations_true S -> true_statement S).
Proof.
  unfold accepts_files, checked. destruct (parsed s nothing) as [x k0|] eqn:P; [|discriminate].
  destruct (statement_in cited deepest [] x nothing) as [[lines own] k|] eqn:D; [|discriminate].
  destruct (certificate_of _ _ _ _ k) as [C later|]; [|discriminate].
  destruct (names_its_own _) eqn:N; [|discriminate].
  destruct (accepts _ C) eqn:A; [|discriminate]. intros [= <-].
  exists x. split; [eapply parsed_is; eauto|]. split; [unfold statement_of; now rewrite D|].
  destruct (same_meaning _ (added k later) N) as [T Z]. intros H. apply T.
  apply accepts_sound with C; [exact A | now apply Z].
Qed.
End Files.
