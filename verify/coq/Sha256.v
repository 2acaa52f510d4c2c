(* SHA-256, as FIPS 180-4 defines it, on lists of bytes.

   `Digest m d` says what the standard says: m is padded to blocks of 64 bytes, and d is what
   compressing them leaves. `sha256` computes it from the message alone, without a copy of it, and
   `sha256_is_the_digest` says that what it finds is that and nothing else. The examples are the
   standard's. *)
From Coq Require Import Bool String List Arith ZArith Lia Strings.Byte.
From Verify Require Import Words.
Import ListNotations.
Open Scope N_scope.

(* --- the functions and constants of the standard ----------------------------------------------- *)

Definition choose : word -> word -> word -> word := bitwise (fun a b c => if a then b else c).
Definition majority : word -> word -> word -> word := bitwise carried.
Definition xor3 : word -> word -> word -> word := bitwise (fun a b c => xorb a (xorb b c)).
Definition Sigma0 (x : word) : word := xor3 (rotate 2 x) (rotate 13 x) (rotate 22 x).
Definition Sigma1 (x : word) : word := xor3 (rotate 6 x) (rotate 11 x) (rotate 25 x).
Definition sigma0 (x : word) : word := xor3 (rotate 7 x) (rotate 18 x) (right 3 x).
Definition sigma1 (x : word) : word := xor3 (rotate 17 x) (rotate 19 x) (right 10 x).

(* The standard writes two of them in another way. *)
Lemma choose_bit (a b c : bool) : (if a then b else c) = xorb (a && b) (negb a && c).
Proof. now destruct a, b, c. Qed.

Lemma majority_bit a b c : carried a b c = xorb (a && b) (xorb (a && c) (b && c)).
Proof. now destruct a, b, c. Qed.

Definition constants : list word := map to_word
  [0x428a2f98; 0x71374491; 0xb5c0fbcf; 0xe9b5dba5; 0x3956c25b; 0x59f111f1; 0x923f82a4; 0xab1c5ed5;
   0xd807aa98; 0x12835b01; 0x243185be; 0x550c7dc3; 0x72be5d74; 0x80deb1fe; 0x9bdc06a7; 0xc19bf174;
   0xe49b69c1; 0xefbe4786; 0x0fc19dc6; 0x240ca1cc; 0x2de92c6f; 0x4a7484aa; 0x5cb0a9dc; 0x76f988da;
   0x983e5152; 0xa831c66d; 0xb00327c8; 0xbf597fc7; 0xc6e00bf3; 0xd5a79147; 0x06ca6351; 0x14292967;
   0x27b70a85; 0x2e1b2138; 0x4d2c6dfc; 0x53380d13; 0x650a7354; 0x766a0abb; 0x81c2c92e; 0x92722c85;
   0xa2bfe8a1; 0xa81a664b; 0xc24b8b70; 0xc76c51a3; 0xd192e819; 0xd6990624; 0xf40e3585; 0x106aa070;
   0x19a4c116; 0x1e376c08; 0x2748774c; 0x34b0bcb5; 0x391c0cb3; 0x4ed8aa4a; 0x5b9cca4f; 0x682e6ff3;
   0x748f82ee; 0x78a5636f; 0x84c87814; 0x8cc70208; 0x90befffa; 0xa4506ceb; 0xbef9a3f7; 0xc67178f2].

Record state := State { A : word; B : word; C : word; D : word; E : word; F : word; G : word; H : word }.
Definition initial : state :=
  State (to_word 0x6a09e667) (to_word 0xbb67ae85) (to_word 0x3c6ef372) (to_word 0xa54ff53a)
        (to_word 0x510e527f) (to_word 0x9b05688c) (to_word 0x1f83d9ab) (to_word 0x5be0cd19).

(* --- one block --------------------------------------------------------------------------------- *)

(* A round, with its constant and its word of the schedule. *)
Definition round (s : state) (k w : word) : state :=
  let '(State a b c d e f g h) := s in
  let t1 := plus h (plus (Sigma1 e) (plus (choose e f g) (plus k w))) in
  let t2 := plus (Sigma0 a) (majority a b c) in
  State (plus t1 t2) a b c (plus d t1) e f g.

(* The schedule from 16 words in a row: the next of them, and what comes after these 16. *)
Definition scheduled (window : list word) : word :=
  plus (sigma1 (nth 14 window [])) (plus (nth 9 window []) (plus (sigma0 (nth 1 window []))
    (nth 0 window []))).
Fixpoint rounds (ks window : list word) (s : state) : state :=
  match ks with
  | [] => s
  | k :: more =>
      rounds more (tl window ++ [scheduled window]) (round s k (nth 0 window []))
  end.

(* Bytes in big-endian order as a number. *)
Definition number (l : list byte) : N := fold_left (fun n b => 256 * n + Byte.to_N b) l 0.
Fixpoint words (l : list byte) : list word :=
  match l with
  | a :: b :: c :: d :: more => to_word (number [a; b; c; d]) :: words more
  | _ => []
  end.

Definition compress (s : state) (block : list byte) : state :=
  let t := rounds constants (words block) s in
  State (plus (A s) (A t)) (plus (B s) (B t)) (plus (C s) (C t)) (plus (D s) (D t))
        (plus (E s) (E t)) (plus (F s) (F t)) (plus (G s) (G t)) (plus (H s) (H t)).

(* The schedule as the standard writes it. *)
Fixpoint window_at (t : nat) (window : list word) : list word :=
  match t with O => window | S n => window_at n (tl window ++ [scheduled window]) end.
Definition W (block : list byte) (t : nat) : word := nth 0 (window_at t (words block)) [].

Fixpoint rounds_from (t : nat) (block : list byte) (ks : list word) (s : state) : state :=
  match ks with [] => s | k :: more => rounds_from (S t) block more (round s k (W block t)) end.

(* --- a message --------------------------------------------------------------------------------- *)

(* A number in so many bytes, in big-endian order. *)
Definition low_byte (n : N) : byte :=
  match Byte.of_N (N.land n 0xff) with Some b => b | None => x00 end.
Fixpoint in_bytes (count : nat) (n : N) (after : list byte) : list byte :=
  match count with O => after | S k => in_bytes k (N.shiftr n 8) (low_byte n :: after) end.

(* What comes after a message of so many bytes: a bit, zeros, and the number of its bits. *)
Definition zeros (length : N) : nat := N.to_nat ((119 - length mod 64) mod 64).
Definition padding (length : N) : list byte :=
  x80 :: repeat x00 (zeros length) ++ in_bytes 8 (8 * length) [].
Definition size (m : list byte) : N := N.of_nat (length m).
Definition padded (m : list byte) : list byte := m ++ padding (size m).

Definition output (s : state) : list byte :=
  flat_map (fun w => in_bytes 4 (value w) []) [A s; B s; C s; D s; E s; F s; G s; H s].

(* The digest of a message, as the standard defines it. *)
Definition Digest (m d : list byte) : Prop :=
  exists blocks, concat blocks = padded m /\ Forall (fun b => length b = 64%nat) blocks /\
    d = output (fold_left compress blocks initial).

(* The blocks that are whole, how many bytes they have, and what is left. *)
Fixpoint whole_blocks (fuel : list byte) (s : state) (count : N) (m : list byte)
  : state * N * list byte :=
  let block := firstn 64 m in
  match fuel with
  | _ :: less =>
      if Nat.eqb (length block) 64
      then whole_blocks less (compress s block) (count + 64) (skipn 64 m)
      else (s, count, m)
  | [] => (s, count, m)
  end.
Definition sha256 (m : list byte) : list byte :=
  let '(s, count, rest) := whole_blocks m initial 0 m in
  let last := rest ++ padding (count + size rest) in
  let '(s, _, _) := whole_blocks last s 0 last in
  output s.

(* Two digits for each byte. *)
Definition hexadecimal (l : list byte) : list byte :=
  let digit n := nth (N.to_nat n) (list_byte_of_string "0123456789abcdef") x00 in
  flat_map (fun b => [digit (Byte.to_N b / 16); digit (Byte.to_N b mod 16)]) l.

(* --- the examples of the standard -------------------------------------------------------------- *)

Definition digest_of (s : string) : string :=
  string_of_list_byte (hexadecimal (sha256 (list_byte_of_string s))).

Lemma digest_of_nothing : digest_of ""
  = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855"%string.
Proof. vm_compute. reflexivity. Qed.

Lemma digest_of_abc : digest_of "abc"
  = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad"%string.
Proof. vm_compute. reflexivity. Qed.

Lemma digest_of_56_bytes :
  digest_of "abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"
  = "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1"%string.
Proof. vm_compute. reflexivity. Qed.

Lemma digest_of_112_bytes :
  digest_of ("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmn" ++
             "hijklmnoijklmnopjklmnopqklmnopqrlmnopqrsmnopqrstnopqrstu")%string
  = "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1"%string.
Proof. vm_compute. reflexivity. Qed.

(* --- the schedule is that of the standard ------------------------------------------------------ *)

Lemma window_length t w : length w = 16%nat -> length (window_at t w) = 16%nat.
Proof.
  revert w. induction t as [| t IH]; intros w h; [exact h |].
  apply IH. rewrite app_length. destruct w; cbn in *; lia.
Qed.

Lemma window_later t w : window_at (S t) w = tl (window_at t w) ++ [scheduled (window_at t w)].
Proof. revert w. induction t as [| t IH]; intro w; [reflexivity | exact (IH _)]. Qed.

Lemma window_shifts t w i : length w = 16%nat -> (i < 15)%nat ->
  nth (S i) (window_at t w) [] = nth i (window_at (S t) w) [].
Proof.
  intros h hi. rewrite window_later. pose proof (window_length t w h) as l.
  destruct (window_at t w); [discriminate |]. cbn [tl nth].
  rewrite app_nth1; [reflexivity |]. cbn in l. lia.
Qed.

Lemma window_nth w i : length w = 16%nat -> forall t, (i < 16)%nat ->
  nth i (window_at t w) [] = nth 0 (window_at (t + i) w) [].
Proof.
  intro h. induction i as [| i IH]; intros t hi.
  - now rewrite Nat.add_0_r.
  - rewrite window_shifts, IH by (assumption || lia). now rewrite Nat.add_succ_r.
Qed.

Lemma words_length n : forall block, length block = (4 * n)%nat -> length (words block) = n.
Proof.
  induction n as [| n IH]; intros block h.
  - now apply length_zero_iff_nil in h as ->.
  - destruct block as [| a [| b [| c [| d block]]]]; try (cbn in h; lia).
    cbn [words length]. f_equal. apply IH. cbn [length] in h. lia.
Qed.

Lemma W_first block t : length (words block) = 16%nat -> (t < 16)%nat ->
  W block t = nth t (words block) [].
Proof. intros h ht. symmetry. exact (window_nth _ t h 0%nat ht). Qed.

Lemma W_next block t : length (words block) = 16%nat ->
  W block (t + 16) = plus (sigma1 (W block (t + 14))) (plus (W block (t + 9))
    (plus (sigma0 (W block (t + 1))) (W block t))).
Proof.
  intro h. unfold W. replace (t + 16)%nat with (S t + 15)%nat by lia.
  rewrite <- (window_nth _ 15 h (S t)), window_later by lia.
  pose proof (window_length t _ h) as l.
  assert (tail : length (tl (window_at t (words block))) = 15%nat)
    by (destruct (window_at t (words block)); cbn in *; lia).
  rewrite app_nth2, tail by lia. cbn [Nat.sub].
  cbn [nth]. unfold scheduled.
  rewrite (window_nth _ 14 h t), (window_nth _ 9 h t), (window_nth _ 1 h t) by lia. reflexivity.
Qed.

Lemma rounds_follow_the_schedule block ks s :
  rounds ks (words block) s = rounds_from 0 block ks s.
Proof.
  enough (more : forall t, rounds ks (window_at t (words block)) s = rounds_from t block ks s)
    by exact (more 0%nat).
  revert s. induction ks as [| k ks IH]; intros s t; [reflexivity |].
  cbn [rounds rounds_from]. rewrite <- window_later. apply IH.
Qed.

(* --- the padding is that of the standard ------------------------------------------------------- *)

Lemma length_in_bytes count : forall n after,
  length (in_bytes count n after) = (count + length after)%nat.
Proof.
  induction count as [| k IH]; intros n after; [reflexivity |].
  cbn [in_bytes]. rewrite IH. cbn. lia.
Qed.

Lemma length_padding n : length (padding n) = (9 + zeros n)%nat.
Proof.
  unfold padding. cbn [length]. rewrite app_length, repeat_length, length_in_bytes. cbn. lia.
Qed.

Lemma padded_is_whole m : (N.of_nat (length (padded m))) mod 64 = 0.
Proof.
  unfold padded. rewrite app_length, length_padding. unfold zeros, size.
  rewrite !Nnat.Nat2N.inj_add, Nnat.N2Nat.id. change (N.of_nat 9) with 9.
  generalize (N.of_nat (length m)). intro n.
  zify; Z.to_euclidean_division_equations; lia.
Qed.

Lemma low_byte_is n : Byte.to_N (low_byte n) = n mod 256.
Proof.
  unfold low_byte. change 0xff with (N.ones 8). rewrite N.land_ones. change (2 ^ 8) with 256.
  destruct (Byte.of_N (n mod 256)) eqn:h; [now apply Byte.to_of_N |].
  apply Byte.of_N_None_iff in h. pose proof (N.mod_lt n 256). lia.
Qed.

Lemma number_from l : forall n, fold_left (fun n b => 256 * n + Byte.to_N b) l n
  = n * 256 ^ N.of_nat (length l) + number l.
Proof.
  unfold number. induction l as [| b l IH]; intro n; [cbn; lia |].
  cbn [fold_left length]. rewrite IH, (IH (256 * 0 + _)), Nnat.Nat2N.inj_succ, N.pow_succ_r'. lia.
Qed.

Lemma number_in_bytes count : forall n after, n < 256 ^ N.of_nat count ->
  number (in_bytes count n after) = n * 256 ^ N.of_nat (length after) + number after.
Proof.
  induction count as [| k IH]; intros n after h.
  - cbn in h. replace n with 0 by lia. reflexivity.
  - rewrite Nnat.Nat2N.inj_succ, N.pow_succ_r' in h. cbn [in_bytes].
    rewrite N.shiftr_div_pow2. change (2 ^ 8) with 256.
    rewrite IH by (apply N.div_lt_upper_bound; lia).
    unfold number at 1. cbn [fold_left length]. rewrite number_from, low_byte_is.
    rewrite Nnat.Nat2N.inj_succ, N.pow_succ_r'.
    rewrite (N.div_mod' n 256) at 3. lia.
Qed.

(* The last eight bytes are the number of bits. *)
Lemma padded_ends m : 8 * size m < 2 ^ 64 ->
  exists before after, padded m = m ++ before ++ after /\ length after = 8%nat /\
    number after = 8 * size m.
Proof.
  intro h. exists (x80 :: repeat x00 (zeros (size m))), (in_bytes 8 (8 * size m) []).
  split; [reflexivity |]. split; [apply length_in_bytes |].
  rewrite number_in_bytes by exact h. cbn [length number fold_left N.of_nat]. lia.
Qed.

(* --- what is computed is the digest ------------------------------------------------------------ *)

Lemma whole_blocks_are fuel : forall s count m s' count' rest,
  (length m <= length fuel)%nat -> whole_blocks fuel s count m = (s', count', rest) ->
  exists blocks, m = concat blocks ++ rest /\ Forall (fun b => length b = 64%nat) blocks /\
    s' = fold_left compress blocks s /\ count' + size rest = count + size m /\
    (length rest < 64)%nat.
Proof.
  induction fuel as [| b fuel IH]; intros s count m s' count' rest long found.
  - destruct m; [| cbn in long; lia]. injection found as <- <- <-. exists []. cbn. auto with arith.
  - cbn [whole_blocks] in found. destruct (Nat.eqb (length (firstn 64 m)) 64) eqn:whole.
    + apply Nat.eqb_eq in whole. pose proof (firstn_skipn 64 m) as parts.
      assert (l : length m = (64 + length (skipn 64 m))%nat)
        by (rewrite <- parts at 1; rewrite app_length; lia).
      apply IH in found; [| cbn in long; lia].
      destruct found as (blocks & parts' & all & -> & sizes & short).
      exists (firstn 64 m :: blocks). repeat split; auto.
      * cbn [concat]. rewrite <- app_assoc, <- parts'. now symmetry.
      * unfold size in *. lia.
    + injection found as <- <- <-. exists []. repeat split; auto.
      apply Nat.eqb_neq in whole. rewrite firstn_length in whole. lia.
Qed.

Theorem sha256_is_a_digest m : Digest m (sha256 m).
Proof.
  unfold sha256. destruct (whole_blocks m initial 0 m) as [[s count] rest] eqn:first.
  apply whole_blocks_are in first; [| lia].
  destruct first as (blocks & parts & all & -> & sizes & _).
  rewrite sizes, N.add_0_l. set (last := rest ++ padding (size m)).
  destruct (whole_blocks last _ 0 last) as [[s' count'] rest'] eqn:second.
  apply whole_blocks_are in second; [| lia].
  destruct second as (blocks' & parts' & all' & -> & _ & short).
  assert (joined : padded m = concat (blocks ++ blocks') ++ rest').
  { unfold padded. rewrite parts at 1. rewrite concat_app, <- !app_assoc, <- parts'. reflexivity. }
  assert (lengths : forall l : list (list byte), Forall (fun b => length b = 64%nat) l ->
            length (concat l) = (64 * length l)%nat).
  { induction 1 as [| b l hb _ IH]; [reflexivity |].
    cbn [concat length]. rewrite app_length. lia. }
  assert (both : Forall (fun b => length b = 64%nat) (blocks ++ blocks'))
    by (apply Forall_app; auto).
  assert (rest' = []) as ->.
  { apply length_zero_iff_nil. pose proof (padded_is_whole m) as whole.
    rewrite joined, app_length, (lengths _ both), Nnat.Nat2N.inj_add, Nnat.Nat2N.inj_mul in whole.
    change (N.of_nat 64) with 64 in whole.
    apply N.mod_divide in whole; [| lia]. destruct whole as [k hk]. lia. }
  exists (blocks ++ blocks'). rewrite app_nil_r in joined. repeat split; auto.
  now rewrite fold_left_app.
Qed.

Lemma blocks_are_unique : forall one other : list (list byte),
  Forall (fun b => length b = 64%nat) one -> Forall (fun b => length b = 64%nat) other ->
  concat one = concat other -> one = other.
Proof.
  induction one as [| b one IH]; intros [| c other] h k same; auto.
  - apply Forall_inv in k. destruct c; discriminate.
  - apply Forall_inv in h. destruct b; discriminate.
  - pose proof (Forall_inv h) as hb. pose proof (Forall_inv k) as kc. cbv beta in hb, kc.
    cbn [concat] in same.
    assert (b = c) as <-.
    { apply (f_equal (firstn 64)) in same.
      rewrite !firstn_app, hb, kc, Nat.sub_diag, !firstn_O, !app_nil_r in same.
      now rewrite !firstn_all2 in same by lia. }
    apply app_inv_head in same. f_equal. apply IH; auto; eapply Forall_inv_tail; eassumption.
Qed.

Theorem sha256_is_the_digest m d : Digest m d <-> d = sha256 m.
Proof.
  split; [| intros ->; apply sha256_is_a_digest].
  destruct (sha256_is_a_digest m) as (blocks & joined & all & ->).
  intros (blocks' & joined' & all' & ->).
  now rewrite (blocks_are_unique blocks' blocks all' all) by congruence.
Qed.
