(* `document` of `ReadJson.v` finds the value of each document in the sense of `Json.v`, and of
   nothing else. *)
From Coq Require Import Bool String List Arith ZArith Lia Strings.Byte MSets.MSetPositive.
From Verify Require Import Json ReadJson JsonLetters.
Import ListNotations.
Open Scope N_scope.

(* --- what lies between items ------------------------------------------------------------------- *)

Lemma skip_sound s : exists w, s = w ++ skip s /\ Blank w.
Proof.
  induction s as [| b s (w & h & all)]; [exists []; now split; [| constructor] |].
  cbn [skip]. destruct (blank b) eqn:is_blank; [| exists []; now split; [| constructor]].
  exists (b :: w). split; [cbn; now rewrite <- h | now constructor].
Qed.

Lemma skip_blank w s : Blank w -> skip (w ++ s) = skip s.
Proof. induction 1 as [| b w h _ IH]; [reflexivity |]. cbn [app skip]. now rewrite h. Qed.

Lemma skip_all w : Blank w -> skip w = [].
Proof. intro h. rewrite <- (app_nil_r w). now rewrite skip_blank. Qed.

Lemma blank_ends b : blank b = true -> digit b = false.
Proof. now destruct b. Qed.

Lemma blanks_end w s : Blank w -> ends s -> ends (w ++ s).
Proof. intros [| b w' h _] k; [exact k |]. exact (blank_ends b h). Qed.

(* --- items ------------------------------------------------------------------------------------- *)

(* An item does not begin with this letter. *)
Definition avoids {A} (R : list byte -> A -> Prop) (closing : byte) : Prop :=
  forall t x rest, R t x ->
    exists b after, skip (t ++ rest) = b :: after /\ Byte.eqb b closing = false.
Definition closes (b : byte) : Prop :=
  blank b = false /\ digit b = false /\ Byte.eqb b ","%byte = false.

Lemma items_sound {A} (item : reader A) R closing : sound item R ->
  forall fuel found s l rest, items item closing fuel found s = Some (l, rest) ->
  exists u l', s = u ++ closing :: rest /\ Items R u l' /\ l = rev found ++ l'.
Proof.
  intro good. induction fuel as [| f fuel IH]; intros found s l rest h; [discriminate |].
  cbn [items] in h. destruct (item s) as [[x s'] |] eqn:read; [| discriminate].
  apply good in read as (t & -> & k). destruct (skip_sound s') as (w & parts & blanks).
  destruct (skip s') as [| b s'']; [discriminate |]. subst s'.
  destruct (Byte.eqb b ","%byte) eqn:comma.
  - apply eqb_reads in comma as ->. apply IH in h as (u & l' & -> & all & ->).
    exists (t ++ w ++ ","%byte :: u), (x :: l'). repeat split.
    + now rewrite <- !app_assoc.
    + now apply next_item.
    + cbn [rev]. now rewrite <- app_assoc.
  - destruct (Byte.eqb b closing) eqn:close; [| discriminate]. apply eqb_reads in close as ->.
    injection h as <- <-. exists (t ++ w), [x]. repeat split.
    + now rewrite <- app_assoc.
    + now apply last_item.
    + change (rev_append (x :: found) [] = rev found ++ [x]).
      now rewrite rev_append_rev, app_nil_r.
Qed.

Lemma items_complete {A} (item : reader A) R closing u l : complete item R -> closes closing ->
  Items R u l -> forall fuel found rest,
  (length (u ++ closing :: rest) <= length fuel)%nat ->
  items item closing fuel found (u ++ closing :: rest) = Some (rev found ++ l, rest).
Proof.
  intros good (not_blank & not_digit & no_comma).
  induction 1 as [t x w h blanks | t x w u l h blanks _ IH];
    intros [| f fuel] found rest long; try (rewrite !app_length in long; cbn in long; lia).
  - cbn [items]. rewrite <- app_assoc, (good t x) by (auto using blanks_end).
    rewrite (skip_blank w) by exact blanks. cbn [skip]. rewrite not_blank, no_comma.
    rewrite (proj2 (eqb_reads _ _) eq_refl), rev_append_rev. cbn [rev]. now rewrite app_nil_r.
  - cbn [items]. rewrite <- !app_assoc. cbn [app].
    rewrite (good t x); [| exact h | now apply blanks_end].
    rewrite (skip_blank w) by exact blanks. cbn [skip].
    change (blank ","%byte) with false. cbv iota.
    change (Byte.eqb ","%byte ","%byte) with true. cbv iota.
    rewrite IH.
    + cbn [rev]. now rewrite <- app_assoc.
    + repeat (progress (rewrite ?app_length in long; cbn [app length] in long)).
      rewrite app_length. cbn [length]. lia.
Qed.

Lemma bracketed_sound {A} (item : reader A) R closing s l rest : sound item R ->
  bracketed item closing s = Some (l, rest) ->
  exists u, s = u ++ closing :: rest /\ ((Blank u /\ l = []) \/ Items R u l).
Proof.
  intros good h. unfold bracketed in h. destruct (skip_sound s) as (w & parts & blanks).
  destruct (skip s) as [| b s'] eqn:seen; [discriminate |].
  destruct (Byte.eqb b closing) eqn:close.
  - apply eqb_reads in close as ->. injection h as <- <-. exists w. auto.
  - apply (items_sound item R) in h as (u & l' & -> & all & ->); [| exact good].
    exists u. auto.
Qed.

Lemma bracketed_complete {A} (item : reader A) R closing u l rest :
  complete item R -> avoids R closing -> closes closing ->
  (Blank u /\ l = []) \/ Items R u l ->
  bracketed item closing (u ++ closing :: rest) = Some (l, rest).
Proof.
  intros good other close [[blanks ->] | all]; unfold bracketed.
  - rewrite (skip_blank u) by exact blanks. cbn [skip]. destruct close as (-> & _ & _).
    now rewrite (proj2 (eqb_reads _ _) eq_refl).
  - assert (exists b after, skip (u ++ closing :: rest) = b :: after /\
              Byte.eqb b closing = false) as (b & after & -> & ->).
    { destruct all as [t x w h | t x w u l h]; rewrite <- app_assoc; now apply (other t x). }
    now rewrite (items_complete item R closing u l good close all).
Qed.

Lemma indented_sound {A} (item : reader A) R : sound item R ->
  sound (indented item) (Indented R).
Proof.
  intros good s x rest h. destruct (skip_sound s) as (w & parts & blanks).
  apply good in h as (t & seen & k). exists (w ++ t). split; [| now exists w, t].
  rewrite <- app_assoc, <- seen. exact parts.
Qed.

(* Values begin with a letter that is not blank. *)
Definition begins {A} (R : list byte -> A -> Prop) : Prop :=
  forall t x, R t x -> exists b u, t = b :: u /\ blank b = false.

Lemma indented_complete {A} (item : reader A) R : begins R -> complete item R ->
  complete (indented item) (Indented R).
Proof.
  intros start good t x rest (w & u & -> & blanks & h) stop. unfold indented.
  rewrite <- app_assoc, (skip_blank w) by exact blanks. rewrite <- (good u x rest h stop).
  f_equal. destruct (start u x h) as (b & v & -> & no). cbn [app skip]. now rewrite no.
Qed.

Lemma member_sound {A} (item : reader A) R : sound item R -> sound (member item) (Member R).
Proof.
  intros good s [key x] rest h. unfold member in h.
  destruct (skip_sound s) as (w & parts & blanks).
  destruct (skip s) as [| q s1]; [discriminate |].
  destruct (Byte.eqb q quote) eqn:is_quote; [| discriminate]. apply eqb_reads in is_quote as ->.
  destruct (chars s1 [] s1) as [[found s2] |] eqn:read; [| discriminate].
  apply chars_sound in read as (c & k & -> & good_key & ->). cbn [rev app] in h.
  destruct (skip_sound s2) as (w' & parts' & blanks').
  destruct (skip s2) as [| colon s3]; [discriminate |].
  destruct (Byte.eqb colon ":"%byte) eqn:is_colon; [| discriminate].
  apply eqb_reads in is_colon as ->.
  destruct (indented item s3) as [[y s4] |] eqn:read; [| discriminate].
  injection h as <- <- <-.
  apply (indented_sound item R good) in read as (u & -> & ry).
  exists (w ++ quote :: c ++ quote :: w' ++ ":"%byte :: u). split.
  - rewrite parts, parts'. rewrite <- !app_assoc. cbn [app]. rewrite <- !app_assoc. cbn [app].
    rewrite <- !app_assoc. reflexivity.
  - exists w, c, w', u. auto.
Qed.

Lemma member_complete {A} (item : reader A) R : begins R -> complete item R ->
  complete (member item) (Member R).
Proof.
  intros start good t [key x] rest (w & c & w' & u & -> & blanks & k & blanks' & h) stop.
  cbn [fst snd] in *. unfold member. rewrite <- app_assoc, (skip_blank w) by exact blanks.
  cbn [app skip]. change (blank quote) with false. cbv iota.
  change (Byte.eqb quote quote) with true. cbv iota.
  rewrite <- app_assoc. cbn [app]. rewrite (chars_complete c key k) by lia. cbn [rev app].
  rewrite <- app_assoc, (skip_blank w') by exact blanks'. cbn [app skip].
  change (blank ":"%byte) with false. cbv iota.
  change (Byte.eqb ":"%byte ":"%byte) with true. cbv iota.
  now rewrite (indented_complete item R start good u x rest h stop).
Qed.

(* --- values ------------------------------------------------------------------------------------ *)

Lemma scalar_sound b s v rest : scalar b s = Some (v, rest) ->
  exists t, b :: s = t ++ rest /\ Scalar t v.
Proof.
  unfold scalar. destruct (Byte.eqb b quote) eqn:is_quote.
  { apply eqb_reads in is_quote as ->.
    destruct (chars s [] s) as [[u r] |] eqn:read; [| discriminate]. intros [= <- <-].
    apply chars_sound in read as (t & u' & -> & k & ->). exists (quote :: t ++ [quote]).
    split; [cbn; now rewrite <- app_assoc | now constructor]. }
  destruct (Byte.eqb b "n"%byte).
  { intro h. apply word_sound in h as [-> ->]. eexists. split; [reflexivity | constructor]. }
  destruct (Byte.eqb b "t"%byte).
  { intro h. apply word_sound in h as [-> ->]. eexists. split; [reflexivity | constructor]. }
  destruct (Byte.eqb b "f"%byte).
  { intro h. apply word_sound in h as [-> ->]. eexists. split; [reflexivity | constructor]. }
  destruct (read_number (b :: s)) as [[n r] |] eqn:read; [| discriminate]. intros [= <- <-].
  apply number_sound in read as (t & -> & k). exists t. split; [reflexivity | now constructor].
Qed.

Lemma digit_is b : digit b = true -> blank b = false /\ Byte.eqb b quote = false /\
  Byte.eqb b "n"%byte = false /\ Byte.eqb b "t"%byte = false /\ Byte.eqb b "f"%byte = false /\
  Byte.eqb b "["%byte = false /\ Byte.eqb b "{"%byte = false /\ Byte.eqb b "]"%byte = false.
Proof. destruct b; try discriminate; now repeat split. Qed.

Lemma natural_begins t n : Natural t n -> exists b u, t = b :: u /\ digit b = true.
Proof.
  intros [| b u _ all _]; [now exists "0"%byte, [] |]. exists b, u.
  split; [reflexivity | exact (Forall_inv all)].
Qed.

Lemma value_begins depth t v : Value depth t v -> exists b u, t = b :: u /\ blank b = false /\
  Byte.eqb b "]"%byte = false.
Proof.
  assert (scalar : Scalar t v -> exists b u, t = b :: u /\ blank b = false /\
            Byte.eqb b "]"%byte = false).
  { intros [| | | u n h | u s h]; try (eexists _, _; now repeat split).
    apply natural_begins in h as (b & r & -> & h). exists b, r.
    apply digit_is in h. split; [reflexivity |]. tauto. }
  destruct depth as [| less]; intros [h | h]; auto; [contradiction |].
  destruct h as [(l & _ & u & -> & _) | (l & _ & (u & -> & _) & _)]; eexists _, _; now repeat split.
Qed.

Lemma as_number_one one : forall other, as_number one = as_number other -> one = other.
Proof.
  assert (bits : forall b c p q, bit b p = bit c q -> b = c /\ p = q)
    by (intros [] [] p q h; inversion h; auto).
  induction one as [| b one IH]; intros [| c other] h; cbn [as_number] in h; auto.
  - destruct (Byte.to_bits c) as (c0 & c1 & c2 & c3 & c4 & c5 & c6 & c7). now destruct c0.
  - destruct (Byte.to_bits b) as (b0 & b1 & b2 & b3 & b4 & b5 & b6 & b7). now destruct b0.
  - assert (same : Byte.to_bits b = Byte.to_bits c /\ as_number one = as_number other).
    { destruct (Byte.to_bits b) as (b0 & b1 & b2 & b3 & b4 & b5 & b6 & b7),
        (Byte.to_bits c) as (c0 & c1 & c2 & c3 & c4 & c5 & c6 & c7).
      do 8 (apply bits in h as [-> h]). auto. }
    destruct same as [same more]. apply (f_equal Byte.of_bits) in same.
    rewrite !Byte.of_bits_to_bits in same. f_equal; auto.
Qed.

Lemma distinct_reads {A} (l : list (list byte * A)) : forall seen, distinct seen l = true <->
  NoDup (map fst l) /\ forall k, In k (map fst l) -> ~ PositiveSet.In (as_number k) seen.
Proof.
  induction l as [| [key x] l IH]; intro seen; cbn [distinct map fst].
  - split; [intros _; split; [constructor | easy] | reflexivity].
  - destruct (PositiveSet.mem (as_number key) seen) eqn:found.
    + split; [discriminate |]. intros [_ none]. apply PositiveSet.mem_spec in found.
      destruct (none key); [now left | exact found].
    + assert (new : ~ PositiveSet.In (as_number key) seen)
        by (intro h; apply PositiveSet.mem_spec in h; congruence).
      rewrite IH. rewrite NoDup_cons_iff. split.
      * intros [others none]. repeat split; auto.
        -- intro h. apply (none key h). apply PositiveSet.add_spec. now left.
        -- intros k [<- | h] i; [contradiction |]. apply (none k h). apply PositiveSet.add_spec.
           now right.
      * intros [[once others] none]. split; [exact others |]. intros k h i.
        apply PositiveSet.add_spec in i as [i | i]; [| now apply (none k); [right |]].
        apply as_number_one in i as ->. contradiction.
Qed.

Lemma distinct_keys {A} (l : list (list byte * A)) :
  distinct PositiveSet.empty l = true <-> NoDup (map fst l).
Proof.
  rewrite distinct_reads. split; [tauto |]. intro h. split; [exact h |].
  intros k _. apply PositiveSet.empty_spec.
Qed.

Lemma value_sound depth : sound (value depth) (Value depth).
Proof.
  induction depth as [| less IH]; intros [| b s] v rest h; try discriminate; cbn [value] in h.
  - destruct (Byte.eqb b "["%byte); [discriminate |].
    destruct (Byte.eqb b "{"%byte); [discriminate |].
    apply scalar_sound in h as (t & -> & k). exists t. split; [reflexivity | now left].
  - destruct (Byte.eqb b "["%byte) eqn:opens.
    { apply eqb_reads in opens as ->.
      destruct (bracketed _ _ s) as [[l r] |] eqn:read; [| discriminate]. injection h as <- <-.
      apply (bracketed_sound _ (Indented (Value less))) in read as (u & -> & k);
        [| now apply indented_sound].
      exists ("["%byte :: u ++ ["]"%byte]). split; [cbn; now rewrite <- app_assoc |].
      right. left. exists l. split; [reflexivity |]. now exists u. }
    destruct (Byte.eqb b "{"%byte) eqn:opens'.
    { apply eqb_reads in opens' as ->.
      destruct (bracketed _ _ s) as [[l r] |] eqn:read; [| discriminate].
      destruct (distinct PositiveSet.empty l) eqn:once; [| discriminate]. injection h as <- <-.
      apply (bracketed_sound _ (Member (Value less))) in read as (u & -> & k);
        [| now apply member_sound].
      exists ("{"%byte :: u ++ ["}"%byte]). split; [cbn; now rewrite <- app_assoc |].
      right. right. exists l. split; [reflexivity |]. split; [now exists u |].
      now apply distinct_keys. }
    apply scalar_sound in h as (t & -> & k). exists t. split; [reflexivity | now left].
Qed.

Lemma scalar_complete depth t v rest : Scalar t v -> ends rest ->
  value depth (t ++ rest) = Some (v, rest).
Proof.
  intros [| | | u n h | u s h] stop; try (now destruct depth).
  - destruct (natural_begins u n h) as (b & r & -> & first).
    apply digit_is in first as (_ & q & n' & t' & f & open & brace & _).
    pose proof (number_complete (b :: r) n rest h stop) as read. cbn [app] in *.
    assert (scalar b (r ++ rest) = Some (JInt n, rest)) as found
      by (unfold scalar; now rewrite q, n', t', f, read).
    destruct depth; cbn [value]; now rewrite open, brace.
  - assert (scalar quote ((u ++ [quote]) ++ rest) = Some (JStr s, rest)) as found.
    { unfold scalar. change (Byte.eqb quote quote) with true. cbv iota.
      rewrite <- app_assoc. cbn [app]. now rewrite (chars_complete u s h) by lia. }
    destruct depth; exact found.
Qed.

Lemma value_complete depth : complete (value depth) (Value depth).
Proof.
  induction depth as [| less IH]; intros t v rest [h | h] stop; try contradiction;
    try (now apply scalar_complete).
  assert (start : begins (Value less)).
  { intros u x k. apply value_begins in k as (b & r & -> & k & _). now exists b, r. }
  destruct h as [(l & -> & u & -> & k) | (l & -> & (u & -> & k) & once)];
    cbn [app value]; rewrite <- app_assoc; cbn [app].
  - change (Byte.eqb "["%byte "["%byte) with true. cbv iota.
    rewrite (bracketed_complete _ (Indented (Value less)) "]"%byte u l rest); auto.
    + now apply indented_complete.
    + intros r x after (w & y & -> & blanks & ry). rewrite <- app_assoc.
      rewrite (skip_blank w) by exact blanks.
      apply value_begins in ry as (b & z & -> & no & other). exists b, (z ++ after).
      cbn [app skip]. now rewrite no.
    + now repeat split.
  - change (Byte.eqb "{"%byte "["%byte) with false.
    change (Byte.eqb "{"%byte "{"%byte) with true. cbv iota.
    rewrite (bracketed_complete _ (Member (Value less)) "}"%byte u l rest); auto.
    + now rewrite (proj2 (distinct_keys l) once).
    + now apply member_complete.
    + intros r x after (w & c & w' & y & -> & blanks & _). rewrite <- app_assoc.
      rewrite (skip_blank w) by exact blanks. cbn [app skip].
      change (blank quote) with false. cbv iota. eexists _, _. now split.
    + now repeat split.
Qed.

(* --- documents --------------------------------------------------------------------------------- *)

Lemma at_most_reads s : forall n, at_most n s = true <-> N.of_nat (length s) <= n.
Proof.
  induction s as [| b s IH]; intro n; cbn [at_most length]; [split; [lia | reflexivity] |].
  destruct (N.eqb_spec n 0) as [-> | nonzero]; [split; [discriminate | lia] |].
  rewrite IH. lia.
Qed.

Theorem document_reads s v : document s = Some v <-> Document s v.
Proof.
  unfold document, Document. split.
  - destruct (at_most most_bytes s) eqn:small; [| discriminate].
    destruct (utf8 s) eqn:letters; [| discriminate].
    destruct (value 100 (skip s)) as [[x rest] |] eqn:read; [| discriminate].
    destruct (skip rest) eqn:over; [| discriminate]. intros [= ->].
    apply value_sound in read as (u & seen & k).
    destruct (skip_sound s) as (w & parts & blanks), (skip_sound rest) as (w' & parts' & blanks').
    rewrite over, app_nil_r in parts'. subst rest.
    split; [now apply utf8_reads |]. split; [now apply at_most_reads |].
    exists w, u, w'. rewrite <- seen. auto.
  - intros (letters & small & w & u & w' & parts & blanks & k & blanks').
    rewrite (proj2 (at_most_reads s most_bytes) small), (proj2 (utf8_reads s) letters).
    rewrite parts, (skip_blank w) by exact blanks.
    destruct (value_begins 100 u v k) as (b & r & -> & no & _). cbn [app skip]. rewrite no.
    pose proof (value_complete 100 (b :: r) v w' k) as read. cbn [app] in read.
    rewrite read; [now rewrite (skip_all w') |].
    rewrite <- (app_nil_r w'). now apply blanks_end.
Qed.

(* A text has one value at most. *)
Lemma one_value s v v' : Document s v -> Document s v' -> v = v'.
Proof. rewrite <- !document_reads. congruence. Qed.
