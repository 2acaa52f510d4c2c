(* From bytes to the answer: `accepts_files` reads the bytes of a statement.json and a
   certificate.json and says whether the statement is proved. `accepts_files_sound` says what it
   means that they are accepted; `accepts_beside_sound` says it of the program, which finds all
   statements by their digests. *)
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
Definition digest_of (text : list byte) : list byte := hexadecimal (sha256 text).
Definition accepts_files (s c : list byte) : answer := checked (digest_of s) s c.

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

(* --- statements by their digests ---------------------------------------------------------------- *)

Definition by_digest (texts : list (list byte)) : list (list byte * list byte) :=
  map (fun text => (digest_of text, text)) texts.
(* The text with a digest. *)
Definition text_with (found : list (list byte * list byte)) (d : list byte) : option (list byte) :=
  find_key d found.
Definition accepts_beside (found : list (list byte * list byte)) (d c : list byte) : answer :=
  match text_with found d with
  | Some s => checked (text_with found) d s c
  | None => IsMalformed "no statement with the digest " d
  end.

Lemma same_is s : forall t, same s t = true -> s = t.
Proof.
  induction s as [|a s IH]; intros [|b t]; cbn [same]; try discriminate; trivial.
  intros H. apply andb_prop in H. destruct H as [A B]. apply Byte.byte_dec_bl in A.
  f_equal; auto.
Qed.
Lemma text_with_is texts d s : text_with (by_digest texts) d = Some s -> In s texts /\ digest_of s = d.
Proof.
  induction texts as [|text texts IH]; [discriminate|].
  unfold text_with, by_digest. cbn [map find_key].
  destruct (same d (digest_of text)) eqn:E.
  - injection 1 as <-. apply same_is in E. split; [now left | now symmetry].
  - intros H. destruct (IH H). split; [now right | assumption].
Qed.
(* One of these texts has the digest; it is a document, and a statement that is true if what it cites
   among these texts is. *)
Theorem accepts_beside_sound texts d c S : accepts_beside (by_digest texts) d c = Accepts S ->
  exists s x, In s texts /\ digest_of s = d /\ Document s x /\
    statement_of (text_with (by_digest texts)) x = Some S /\ (citations_true S -> true_statement S).
Proof.
  unfold accepts_beside. destruct (text_with (by_digest texts) d) as [s|] eqn:F; [|discriminate].
  apply text_with_is in F. destruct F as [I <-]. intros A.
  destruct (accepts_files_sound (text_with (by_digest texts)) s c S A) as (x & D & M & T).
  exists s, x. auto.
Qed.
