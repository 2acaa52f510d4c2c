(* Words of 32 bits as lists of bits, the lowest first: what plus, rotating and shifting are, which
   SHA-256 is made of, and that they are that on numbers. *)
From Coq Require Import Bool List Arith ZArith Lia.
Import ListNotations.
Open Scope N_scope.

Definition word : Type := list bool.
Fixpoint value (x : word) : N :=
  match x with [] => 0 | b :: x => N.b2n b + 2 * value x end.
Fixpoint bits (count : nat) (n : N) : word :=
  match count with O => [] | S k => N.odd n :: bits k (N.div2 n) end.
Definition to_word : N -> word := bits 32.

(* What is carried if three bits are added, in few branches. *)
Definition carried (a b c : bool) : bool := if xorb a b then c else a.
Fixpoint sum (carry : bool) (x y : word) : word :=
  match x, y with
  | a :: x, b :: y => xorb a (xorb b carry) :: sum (carried a b carry) x y
  | _, _ => []
  end.
Definition plus : word -> word -> word := sum false.
Definition rotate (n : nat) (x : word) : word := skipn n x ++ firstn n x.
Definition right (n : nat) (x : word) : word := skipn n x ++ repeat false n.
Fixpoint bitwise (f : bool -> bool -> bool -> bool) (x y z : word) : word :=
  match x, y, z with
  | a :: x, b :: y, c :: z => f a b c :: bitwise f x y z
  | _, _, _ => []
  end.

Lemma value_bits count : forall n, value (bits count n) = n mod 2 ^ N.of_nat count.
Proof.
  induction count as [| k IH]; intro n.
  - cbn [value bits]. symmetry. apply N.mod_1_r.
  - cbn [value bits]. rewrite IH, Nnat.Nat2N.inj_succ, N.pow_succ_r', N.div2_div.
    rewrite (N.mod_mul_r n 2) by (try apply N.pow_nonzero; lia). f_equal.
    rewrite <- N.bit0_odd. apply N.bit0_mod.
Qed.

Lemma value_below x : value x < 2 ^ N.of_nat (length x).
Proof.
  induction x as [| b x IH]; [reflexivity |].
  cbn [value length]. rewrite Nnat.Nat2N.inj_succ, N.pow_succ_r'. destruct b; cbn [N.b2n]; lia.
Qed.

Lemma sum_length x : forall carry y, length x = length y -> length (sum carry x y) = length x.
Proof.
  induction x as [| a x IH]; intros carry [| b y] h; try discriminate; [reflexivity |].
  cbn [sum length]. f_equal. apply IH. now injection h.
Qed.

Lemma sum_value x : forall carry y, length x = length y -> exists over,
  value x + value y + N.b2n carry = 2 ^ N.of_nat (length x) * over + value (sum carry x y).
Proof.
  induction x as [| a x IH]; intros carry [| b y] h; try discriminate.
  - exists (N.b2n carry). cbn [value sum length]. change (2 ^ N.of_nat 0) with 1. lia.
  - injection h as h. destruct (IH (carried a b carry) y h) as [over same]. exists over.
    cbn [value sum length]. rewrite Nnat.Nat2N.inj_succ, N.pow_succ_r'.
    destruct a, b, carry; cbn [carried andb orb xorb N.b2n] in *; lia.
Qed.

Lemma plus_is_sum x y : length x = 32%nat -> length y = 32%nat ->
  value (plus x y) = (value x + value y) mod 2 ^ 32.
Proof.
  intros hx hy. destruct (sum_value x false y) as [over same]; [congruence |].
  rewrite hx, N.add_0_r in same. apply N.mod_unique with over; [| exact same].
  pose proof (value_below (plus x y)) as below. unfold plus in below at 2.
  rewrite sum_length, hx in below by congruence. exact below.
Qed.

(* Bit i of a rotated word is bit i + n of the word, counted around. *)
Lemma rotate_bits n x i : length x = 32%nat -> (n < 32)%nat -> (i < 32)%nat ->
  nth i (rotate n x) false = nth ((i + n) mod 32) x false.
Proof.
  intros h hn hi. rewrite <- (firstn_skipn n x) at 2. unfold rotate.
  assert (left : length (firstn n x) = n) by (rewrite firstn_length; lia).
  assert (rest : length (skipn n x) = (32 - n)%nat) by (rewrite skipn_length; lia).
  destruct (le_lt_dec (32 - n) i) as [outside | inside].
  - rewrite app_nth2, rest by lia.
    replace ((i + n) mod 32)%nat with (i - (32 - n))%nat by (apply Nat.mod_unique with 1%nat; lia).
    rewrite app_nth1; [reflexivity | lia].
  - rewrite app_nth1, Nat.mod_small by lia. rewrite app_nth2, left by lia.
    f_equal. lia.
Qed.
