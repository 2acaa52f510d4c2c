(* What `ReadJson.v` reads of letters, texts between quotes, numbers, and words is what `Json.v` says:
   UTF-8, escapes, and pairs of surrogates. *)
From Coq Require Import Bool String List Arith ZArith Lia Strings.Byte.
From Verify Require Import Json ReadJson.
Import ListNotations.
Open Scope N_scope.

Lemma same_byte a b : Byte.to_N a = Byte.to_N b -> a = b.
Proof.
  intro h. apply (f_equal Byte.of_N) in h. rewrite !Byte.of_to_N in h. now injection h.
Qed.

Lemma eqb_reads a b : Byte.eqb a b = true <-> a = b.
Proof.
  split; [apply byte_dec_bl |]. intros <-. now apply byte_dec_lb.
Qed.

Lemma between_reads l h b : between l h b = true <-> l <= Byte.to_N b <= h.
Proof. unfold between. rewrite andb_true_iff, !N.leb_le. reflexivity. Qed.

Lemma to_byte_is n : n < 256 -> Byte.to_N (to_byte n) = n.
Proof.
  intro h. unfold to_byte. destruct (Byte.of_N n) eqn:found; [now apply Byte.to_of_N |].
  apply Byte.of_N_None_iff in found. lia.
Qed.

(* --- UTF-8 ------------------------------------------------------------------------------------- *)

Lemma one_encoding n e e' : Encoded n e -> Encoded n e' -> e = e'.
Proof.
  intros h k. destruct h, k; try lia; repeat f_equal; apply same_byte; lia.
Qed.

Lemma tail_is n : exists y, y < 64 /\ n = 64 * (n / 64) + y /\ Byte.to_N (tail n) = 0x80 + y.
Proof.
  exists (n mod 64). pose proof (N.mod_lt n 64 ltac:(lia)) as h. repeat split; try assumption.
  - apply N.div_mod'.
  - unfold tail. apply to_byte_is. lia.
Qed.

Lemma encode_is n : n < 0x110000 -> Encoded n (encode n).
Proof.
  intro h. unfold encode.
  destruct (tail_is n) as (z & hz & nz & tz).
  destruct (tail_is (n / 64)) as (y & hy & ny & ty).
  destruct (tail_is (n / 4096)) as (x & hx & nx & tx).
  replace (n / 64 / 64) with (n / 4096) in ny by (rewrite N.div_div by lia; reflexivity).
  replace (n / 4096 / 64) with (n / 262144) in nx by (rewrite N.div_div by lia; reflexivity).
  destruct (N.ltb_spec n 0x80); [| destruct (N.ltb_spec n 0x800);
    [| destruct (N.ltb_spec n 0x10000)]].
  - apply in_one; [apply to_byte_is |]; lia.
  - apply in_two with (n / 64) z; try assumption; [apply to_byte_is |]; lia.
  - apply in_three with (n / 4096) y z; try assumption; [apply to_byte_is | |]; lia.
  - apply in_four with (n / 262144) x y z; try assumption; [apply to_byte_is | |]; lia.
Qed.

Lemma encoded_is n e : Encoded n e -> e = encode n.
Proof.
  intro h. apply (one_encoding n); [exact h |]. apply encode_is. destruct h; lia.
Qed.

Lemma follows_reads b : follows b = true -> exists y, Byte.to_N b = 0x80 + y /\ y < 64.
Proof.
  intro h. apply between_reads in h. exists (Byte.to_N b - 0x80). lia.
Qed.

Lemma utf8_sound s : utf8 s = true -> Utf8 s.
Proof.
  enough (all : forall k s, (length s <= k)%nat -> utf8 s = true -> Utf8 s)
    by exact (all _ s (le_n _)).
  clear s. induction k as [| k IH]; intros [| a s] long h; try constructor; [cbn in long; lia |].
  cbn [utf8 length] in *.
  destruct (N.ltb_spec (Byte.to_N a) 0x80) as [ha | ha].
  { apply (a_letter (Byte.to_N a) [a]); [now constructor | unfold Surrogate; lia |].
    apply IH; [lia | exact h]. }
  destruct s as [| b s]; [discriminate |]. cbn [length] in long.
  destruct (N.ltb_spec (Byte.to_N a) 0xe0) as [ha' | ha'].
  { destruct (N.leb_spec 0xc2 (Byte.to_N a)); [| discriminate].
    destruct (follows b) eqn:hb; [| discriminate].
    destruct (follows_reads b hb) as (y & ty & hy).
    apply (a_letter (64 * (Byte.to_N a - 0xc0) + y) [a; b]).
    - apply in_two with (Byte.to_N a - 0xc0) y; lia.
    - unfold Surrogate. lia.
    - apply IH; [lia | exact h]. }
  destruct s as [| c s]; [discriminate |]. cbn [length] in long.
  destruct (N.ltb_spec (Byte.to_N a) 0xf0) as [ha'' | ha''].
  { destruct (three a b c) eqn:good; [| discriminate]. unfold three in good.
    rewrite !andb_true_iff, negb_true_iff, andb_false_iff, N.leb_le, N.leb_gt, N.ltb_ge in good.
    destruct good as [[[hb hc] large] surrogate].
    destruct (follows_reads b hb) as (y & ty & hy), (follows_reads c hc) as (z & tz & hz).
    apply (a_letter (4096 * (Byte.to_N a - 0xe0) + 64 * y + z) [a; b; c]).
    - apply in_three with (Byte.to_N a - 0xe0) y z; lia.
    - unfold Surrogate. lia.
    - apply IH; [lia | exact h]. }
  destruct s as [| d s]; [discriminate |]. cbn [length] in long.
  destruct (four a b c d) eqn:good; [| discriminate]. unfold four in good.
  rewrite !andb_true_iff, N.leb_le, N.ltb_lt in good.
  destruct good as [[[[hb hc] hd] large] small].
  destruct (follows_reads b hb) as (x & tx & hx), (follows_reads c hc) as (y & ty & hy),
    (follows_reads d hd) as (z & tz & hz).
  apply (a_letter (262144 * (Byte.to_N a - 0xf0) + 4096 * x + 64 * y + z) [a; b; c; d]).
  - apply in_four with (Byte.to_N a - 0xf0) x y z; lia.
  - unfold Surrogate. lia.
  - apply IH; [lia | exact h].
Qed.

Lemma utf8_letter n e t : Encoded n e -> ~ Surrogate n -> utf8 (e ++ t) = utf8 t.
Proof.
  unfold Surrogate. intros h s. destruct h; cbn [app utf8].
  - destruct (N.ltb_spec (Byte.to_N a) 0x80); [reflexivity | lia].
  - destruct (N.ltb_spec (Byte.to_N a) 0x80); [lia |].
    destruct (N.ltb_spec (Byte.to_N a) 0xe0); [| lia].
    destruct (N.leb_spec 0xc2 (Byte.to_N a)); [| lia].
    assert (follows b = true) as -> by (apply between_reads; lia). reflexivity.
  - destruct (N.ltb_spec (Byte.to_N a) 0x80); [lia |].
    destruct (N.ltb_spec (Byte.to_N a) 0xe0); [lia |].
    destruct (N.ltb_spec (Byte.to_N a) 0xf0); [| lia].
    assert (three a b c = true) as ->; [| reflexivity]. unfold three.
    rewrite !andb_true_iff, negb_true_iff, andb_false_iff, N.leb_le, N.leb_gt, N.ltb_ge.
    unfold follows. rewrite !between_reads. lia.
  - destruct (N.ltb_spec (Byte.to_N a) 0x80); [lia |].
    destruct (N.ltb_spec (Byte.to_N a) 0xe0); [lia |].
    destruct (N.ltb_spec (Byte.to_N a) 0xf0); [lia |].
    assert (four a b c d = true) as ->; [| reflexivity]. unfold four.
    rewrite !andb_true_iff, N.leb_le, N.ltb_lt. unfold follows. rewrite !between_reads. lia.
Qed.

Lemma utf8_reads s : utf8 s = true <-> Utf8 s.
Proof.
  split; [apply utf8_sound |]. induction 1 as [| n e t h surrogate _ IH]; [reflexivity |].
  now rewrite (utf8_letter n).
Qed.

(* --- texts between quotes ---------------------------------------------------------------------- *)

Lemma hexadecimal_small b n : hexadecimal_digit b = Some n -> n < 16.
Proof.
  unfold hexadecimal_digit, digit.
  destruct (between 48 57 b) eqn:h; [apply between_reads in h; intros [= <-]; lia |].
  destruct (between 97 102 b) eqn:k; [apply between_reads in k; intros [= <-]; lia |].
  destruct (between 65 70 b) eqn:l; [apply between_reads in l; intros [= <-]; lia | discriminate].
Qed.

Lemma four_digits_small a b c d n : four_digits a b c d = Some n -> n < 0x10000.
Proof.
  unfold four_digits.
  destruct (hexadecimal_digit a) eqn:ha; [| discriminate].
  destruct (hexadecimal_digit b) eqn:hb; [| discriminate].
  destruct (hexadecimal_digit c) eqn:hc; [| discriminate].
  destruct (hexadecimal_digit d) eqn:hd; [| discriminate].
  apply hexadecimal_small in ha, hb, hc, hd. intro h.
  apply (f_equal (fun o => match o with Some k => k | None => 0 end)) in h. cbv beta iota in h.
  lia.
Qed.

Lemma joined_small n m : high n = true -> low m = true -> joined n m < 0x110000.
Proof.
  unfold high, low, joined. rewrite !andb_true_iff, !N.leb_le. lia.
Qed.

Lemma low_ahead_low t m rest : low_ahead t = Some (m, rest) -> low m = true.
Proof.
  unfold low_ahead. destruct t as [| x [| y [| a [| b [| c [| d t]]]]]]; try discriminate.
  destruct (_ && _); [| discriminate]. destruct (four_digits a b c d); [| discriminate].
  destruct (low n) eqn:h; [| discriminate]. now intros [= <- <-].
Qed.

(* A quote ends a text before anything of what follows is looked at. *)
Lemma low_ahead_before t after :
  low_ahead (t ++ quote :: after) = match low_ahead t with
    | Some (m, rest) => Some (m, rest ++ quote :: after)
    | None => None
    end.
Proof.
  assert (no : hexadecimal_digit quote = None) by reflexivity.
  destruct t as [| x [| y [| a [| b [| c [| d t]]]]]]; cbn [app low_ahead].
  - now destruct after as [| ? [| ? [| ? [| ? [| ? ?]]]]].
  - destruct after as [| ? [| ? [| ? [| ? ?]]]]; try reflexivity.
    rewrite andb_comm. reflexivity.
  - destruct after as [| ? [| ? [| ? ?]]]; try reflexivity.
    unfold four_digits. rewrite no. now destruct (_ && _).
  - destruct after as [| ? [| ? ?]]; try reflexivity.
    unfold four_digits. rewrite no. destruct (_ && _), (hexadecimal_digit a); reflexivity.
  - destruct after as [| ? ?]; try reflexivity. unfold four_digits. rewrite no.
    destruct (_ && _), (hexadecimal_digit a), (hexadecimal_digit b); reflexivity.
  - unfold four_digits. rewrite no.
    destruct (_ && _), (hexadecimal_digit a), (hexadecimal_digit b), (hexadecimal_digit c);
      reflexivity.
  - destruct (_ && _); [| reflexivity]. destruct (four_digits a b c d); [| reflexivity].
    now destruct (low n).
Qed.

Lemma escaped_sound s e rest : escaped s = Some (e, rest) ->
  (length rest < length s)%nat /\
  forall t u after, rest = t ++ quote :: after -> Chars t u ->
    exists t', s = t' ++ quote :: after /\ Chars (backslash :: t') (e ++ u).
Proof.
  unfold escaped. destruct s as [| c s]; [discriminate |].
  destruct (short c) as [b |] eqn:found.
  { intros [= <- <-]. split; [cbn; lia |]. intros t u after -> h.
    exists (c :: t). split; [reflexivity |]. now apply chars_short. }
  destruct (Byte.eqb c "u"%byte) eqn:is_u; [| discriminate]. apply eqb_reads in is_u as ->.
  unfold unicode. destruct s as [| a [| b [| c [| d s]]]]; try discriminate.
  destruct (four_digits a b c d) as [n |] eqn:four; [| discriminate].
  assert (alone : Some (encode n, s) = Some (e, rest) ->
            (high n = true -> low_ahead s = None) ->
            (length rest < length ("u"%byte :: a :: b :: c :: d :: s))%nat /\
            forall t u after, rest = t ++ quote :: after -> Chars t u ->
              exists t', "u"%byte :: a :: b :: c :: d :: s = t' ++ quote :: after /\
                Chars (backslash :: t') (e ++ u)).
  { intros [= <- <-] no. split; [cbn; lia |]. intros t u after -> h.
    exists ("u"%byte :: a :: b :: c :: d :: t). split; [reflexivity |].
    apply (chars_escaped a b c d n); auto.
    - intro is_high. specialize (no is_high). rewrite low_ahead_before in no.
      now destruct (low_ahead t) as [[? ?] |].
    - apply encode_is. apply four_digits_small in four. lia. }
  destruct (high n) eqn:is_high; [| intro k; now apply alone].
  destruct (low_ahead s) as [[m r] |] eqn:ahead; [| intro k; now apply alone].
  intros [= <- <-]. pose proof (low_ahead_low _ _ _ ahead) as is_low.
  unfold low_ahead in ahead. destruct s as [| x [| y [| a' [| b' [| c' [| d' s]]]]]];
    try discriminate.
  destruct (Byte.eqb x backslash && Byte.eqb y "u"%byte) eqn:xy; [| discriminate].
  destruct (four_digits a' b' c' d') as [m' |] eqn:four'; [| discriminate].
  destruct (low m') eqn:is_low'; [| discriminate]. injection ahead as -> ->.
  split; [cbn; lia |]. intros t u after -> h.
  exists ("u"%byte :: a :: b :: c :: d :: x :: y :: a' :: b' :: c' :: d' :: t).
  split; [reflexivity |].
  apply (chars_pair a b c d n m _ (x :: y :: a' :: b' :: c' :: d' :: t) t); auto.
  - unfold low_ahead. now rewrite xy, four', is_low.
  - apply encode_is. now apply joined_small.
Qed.

Lemma chars_sound fuel : forall found s text rest, chars fuel found s = Some (text, rest) ->
  exists t u, s = t ++ quote :: rest /\ Chars t u /\ text = rev found ++ u.
Proof.
  induction fuel as [| f fuel IH]; intros found [| b s] text rest h; try discriminate.
  cbn [chars] in h.
  destruct (Byte.eqb b quote) eqn:is_quote.
  { apply eqb_reads in is_quote as ->. injection h as <- <-. exists [], [].
    repeat split; [constructor |]. now rewrite rev_append_rev, !app_nil_r. }
  destruct (Byte.eqb b backslash) eqn:is_backslash.
  { apply eqb_reads in is_backslash as ->.
    destruct (escaped s) as [[e s'] |] eqn:read; [| discriminate].
    apply IH in h as (t & u & -> & k & ->).
    apply escaped_sound in read as [_ read]. destruct (read t u rest eq_refl k) as (t' & -> & k').
    exists (backslash :: t'), (e ++ u). repeat split; [exact k' |].
    now rewrite rev_append_rev, rev_app_distr, rev_involutive, app_assoc. }
  destruct (N.leb_spec 32 (Byte.to_N b)) as [large |]; [| discriminate].
  apply IH in h as (t & u & -> & k & ->). exists (b :: t), (b :: u).
  repeat split; [| cbn; now rewrite <- app_assoc].
  apply chars_plain; [| exact k]. unfold plain. rewrite is_quote, is_backslash. cbn.
  now apply N.leb_le.
Qed.

Lemma chars_complete t u : Chars t u -> forall fuel found rest,
  (length (t ++ quote :: rest) <= length fuel)%nat ->
  chars fuel found (t ++ quote :: rest) = Some (rev found ++ u, rest).
Proof.
  induction 1 as [| b t s h _ IH | e c t s h _ IH | a b c d n e t s four no en _ IH
                 | a b c d n m e t rest' s four is_high ahead en k IH];
    intros [| f fuel] found rest long; try (rewrite app_length in long; cbn in long; lia).
  - cbn [app chars]. now rewrite (proj2 (eqb_reads quote quote) eq_refl), rev_append_rev, !app_nil_r.
  - cbn [app chars]. unfold plain in h. rewrite !andb_true_iff, !negb_true_iff in h.
    destruct h as [[-> ->] ->]. rewrite IH by (cbn [app length] in long |- *; lia).
    cbn [rev]. now rewrite <- app_assoc.
  - cbn [app chars escaped]. rewrite h. cbn [Byte.eqb]. cbn.
    rewrite IH by (cbn [app length] in long |- *; lia).
    cbn [rev]. now rewrite <- app_assoc.
  - cbn [app chars escaped]. change (short "u"%byte) with (@None byte). cbn.
    rewrite four, low_ahead_before. rewrite (encoded_is n e en).
    assert ((if high n then match low_ahead t with
              | Some (m, r) => Some (m, r ++ quote :: rest) | None => None end else None)
            = None) as -> by (destruct (high n); [now rewrite no |]; reflexivity).
    rewrite IH by (cbn [app length] in long |- *; lia).
    now rewrite rev_append_rev, rev_app_distr, rev_involutive, app_assoc.
  - cbn [app chars escaped]. change (short "u"%byte) with (@None byte). cbn.
    rewrite four, low_ahead_before, is_high, ahead. rewrite (encoded_is _ e en).
    rewrite IH.
    + now rewrite rev_append_rev, rev_app_distr, rev_involutive, app_assoc.
    + unfold low_ahead in ahead. destruct t as [| x [| y [| a' [| b' [| c' [| d' t]]]]]];
        try discriminate.
      destruct (_ && _); [| discriminate]. destruct (four_digits a' b' c' d'); [| discriminate].
      destruct (low _); [| discriminate]. injection ahead as -> ->.
      cbn [app length] in long |- *. lia.
Qed.

(* --- numbers and words ------------------------------------------------------------------------- *)

(* What may come after a number. *)
Definition ends (s : list byte) : Prop :=
  match s with [] => True | b :: _ => digit b = false end.

Definition sound {A} (item : reader A) (R : list byte -> A -> Prop) : Prop :=
  forall s x rest, item s = Some (x, rest) -> exists t, s = t ++ rest /\ R t x.
Definition complete {A} (item : reader A) (R : list byte -> A -> Prop) : Prop :=
  forall t x rest, R t x -> ends rest -> item (t ++ rest) = Some (x, rest).

Lemma digits_sound count : forall n s m rest, digits count n s = (m, rest) ->
  exists t, s = t ++ rest /\ Forall (fun b => digit b = true) t /\ (length t <= count)%nat /\
    m = fold_left add_digit t n.
Proof.
  induction count as [| k IH]; intros n s m rest h.
  - injection h as <- <-. exists []. cbn. auto.
  - destruct s as [| b s]; cbn [digits] in h; [injection h as <- <-; exists []; cbn; auto with arith |].
    destruct (digit b) eqn:is_digit; [| injection h as <- <-; exists []; cbn; auto with arith].
    apply IH in h as (t & -> & all & short & ->). exists (b :: t). cbn. auto with arith.
Qed.

Lemma digits_complete t : forall count n rest, Forall (fun b => digit b = true) t ->
  (length t <= count)%nat -> ends rest ->
  digits count n (t ++ rest) = (fold_left add_digit t n, rest).
Proof.
  induction t as [| b t IH]; intros count n rest all short stop.
  - destruct count as [| k]; [reflexivity |]. destruct rest as [| b rest]; [reflexivity |].
    cbn [ends] in stop. cbn [app digits]. now rewrite stop.
  - destruct count as [| k]; [cbn in short; lia |]. cbn [app digits].
    rewrite (Forall_inv all). apply IH; [exact (Forall_inv_tail all) | cbn in short; lia | exact stop].
Qed.

Lemma number_sound : sound read_number Natural.
Proof.
  intros [| b s] n rest h; [discriminate |]. cbn [read_number] in h.
  destruct (Byte.eqb b "0"%byte) eqn:is_zero.
  - apply eqb_reads in is_zero as ->. injection h as <- <-. exists ["0"%byte].
    split; [reflexivity | constructor].
  - destruct (digit b) eqn:is_digit; [| discriminate].
    destruct (digits 8 (add_digit 0 b) s) as [m r] eqn:read. injection h as <- <-.
    apply digits_sound in read as (t & -> & all & short & ->). exists (b :: t).
    split; [reflexivity |]. apply natural; [| now constructor | exact short].
    intros ->. discriminate.
Qed.

Lemma number_complete : complete read_number Natural.
Proof.
  intros t n rest [| b u nonzero all short] stop; [reflexivity |].
  cbn [app read_number]. destruct (Byte.eqb b "0"%byte) eqn:is_zero;
    [now apply eqb_reads in is_zero |].
  rewrite (Forall_inv all). now rewrite digits_complete by (auto; exact (Forall_inv_tail all)).
Qed.

Lemma strip_sound w : forall s rest, strip w s = Some rest -> s = w ++ rest.
Proof.
  induction w as [| a w IH]; intros s rest h; [now injection h as -> |].
  destruct s as [| b s]; [discriminate |]. cbn [strip] in h.
  destruct (Byte.eqb a b) eqn:same; [| discriminate]. apply eqb_reads in same as ->.
  cbn [app]. f_equal. now apply IH.
Qed.

Lemma word_sound w v s x rest : word w v s = Some (x, rest) ->
  s = list_byte_of_string w ++ rest /\ x = v.
Proof.
  unfold word. destruct (strip (list_byte_of_string w) s) as [r |] eqn:read; [| discriminate].
  intros [= <- <-]. split; [now apply strip_sound | reflexivity].
Qed.
