(* Enclosures of exponentials, logarithms, sines, arc tangents and roots: exact where that is known, else the
   verified functions of coq-interval. An exponential of more than 2^16 is refused, since its value
   would be too long, and so is a logarithm of what is not known to be positive. *)
From Coq Require Import Reals QArith Qreals ZArith Bool Lra.
From Interval Require Import Real.Xreal Interval.Interval.
From Verify Require Import Meaning Roots Enclosures.
Open Scope R_scope.

Section Functions.
Variable bits : positive.
Notation p := (p bits).

Definition largest : Q := 65536.
(* What lies above 0 and below an exponential. *)
Definition at_most_exp (i : I.type) : I.type :=
  I.meet (I.upper_extent (I.fromZ p 0)) (I.lower_extent (I.exp p i)).
Definition enclosed_exp (x : enclosure) : option enclosure :=
  match x with
  | Exact (Qmake 0 _) => Some (Exact 1)
  | _ =>
      let i := interval_of bits x in
      if decide bits AtMost (Exact (- largest)) x then
        if decide bits AtMost x (Exact largest) then Some (Around (I.exp p i)) else None
      else
        let i' := greatest_interval i (interval_of bits (Exact (- largest))) in
        if decide bits AtMost (Around i') (Exact largest) then
          Some (Around (at_most_exp i'))
        else None
  end.
Definition enclosed_log (x : enclosure) : option enclosure :=
  if decide bits Less (Exact 0) x then
    Some match x with
    | Exact (Qmake 1 1) => Exact 0
    | _ => Around (I.ln p (interval_of bits x))
    end
  else None.
Definition at_zero (f : I.type -> I.type) (x : enclosure) : enclosure :=
  match x with Exact (Qmake 0 _) => Exact 0 | _ => Around (f (interval_of bits x)) end.
(* The greatest number whose n-th power is at most z, found bit by bit. *)
Fixpoint whole_root (n : positive) (z : Z) (bit : nat) (r : Z) : Z :=
  match bit with
  | O => r
  | S k =>
      let s := (r + 2 ^ Z.of_nat k)%Z in
      whole_root n z k (if Z.leb (s ^ Zpos n) z then s else r)
  end.
Definition root_of (n : positive) (z : Z) : Z :=
  whole_root n z (Z.to_nat (Z.log2 z / Zpos n + 1)) 0.
Definition root_of_power (n : positive) (q : Q) : option Q :=
  match root_of n (Zpos (Qden q)) with
  | Zpos d =>
      let r := Qmake (root_of n (Qnum q)) d in
      if Z.leb 0 (Qnum r) && Qeq_bool (exact_power r n) q then Some r else None
  | _ => None
  end.
(* The root of a positive number is exp (log x / n); that of 0 is 0. *)
Definition root_around (n : positive) (is_positive : bool) (i : I.type) : I.type :=
  let j := I.exp p (I.div p (I.ln p i) (I.fromZ p (Zpos n))) in
  if is_positive then j else I.join (I.fromZ p 0) j.
Definition enclosed_root (n : positive) (x : enclosure) : option enclosure :=
  if decide bits AtMost (Exact 0) x then
    Some match match x with Exact q => root_of_power n q | Around _ => None end with
    | Some r => Exact r
    | None => Around (root_around n (decide bits Less (Exact 0) x) (interval_of bits x))
    end
  else None.
Definition enclosed_elementary (f : elementary) (x : enclosure) : option enclosure :=
  match f with
  | Exp => enclosed_exp x
  | Log => enclosed_log x
  | Sin => Some (at_zero (I.sin p) x)
  | Atan => Some (at_zero (I.atan p) x)
  | NthRoot n => enclosed_root n x
  end.

Lemma exp_inside i a : inside i a -> inside (I.exp p i) (exp a).
Proof. intros X. exact (I.exp_correct p i (Xreal a) X). Qed.
Lemma at_most_exp_inside i a b : inside i b -> a <= b -> inside (at_most_exp i) (exp a).
Proof.
  intros B L. unfold at_most_exp, inside. apply I.meet_correct.
  - apply I.upper_extent_correct with 0; [apply I.fromZ_correct | left; apply exp_pos].
  - apply I.lower_extent_correct with (exp b); [now apply exp_inside|].
    destruct L as [L|L]; [left; now apply exp_increasing | right; now f_equal].
Qed.
Lemma zero_is d : Q2R (Qmake 0 d) = 0.
Proof. unfold Q2R. cbn. ring. Qed.
Lemma exp_sound x z a : encloses x a -> enclosed_exp x = Some z -> encloses z (exp a).
Proof.
  intros X. pose proof (interval_of_inside bits _ _ X) as J.
  assert (W : forall y, (if decide bits AtMost (Exact (- largest)) x then
      if decide bits AtMost x (Exact largest) then Some (Around (I.exp p (interval_of bits x))) else None
    else
      let i' := greatest_interval (interval_of bits x) (interval_of bits (Exact (- largest))) in
      if decide bits AtMost (Around i') (Exact largest) then
        Some (Around (at_most_exp i'))
      else None) = Some y -> encloses y (exp a)).
  { intros y H. destruct (decide _ _ (Exact (- largest)) x).
    - destruct (decide _ _ x _); [|discriminate]. injection H as <-. now apply exp_inside.
    - cbv zeta in H. destruct (decide _ _ (Around _) _); [|discriminate]. injection H as <-.
      apply at_most_exp_inside with (Rmax a (Q2R (- largest))); [|apply Rmax_l].
      apply greatest_inside; trivial. now apply (interval_of_inside bits (Exact (- largest))). }
  destruct x as [[[|n|n] d]|i]; try exact (W z). injection 1 as <-. cbn [encloses] in *. subst.
  rewrite zero_is, exp_0. unfold Q2R. cbn. field.
Qed.
Lemma log_sound x z a : encloses x a -> enclosed_log x = Some z -> 0 < a /\ encloses z (ln a).
Proof.
  unfold enclosed_log. intros X. destruct (decide bits Less (Exact 0) x) eqn:D; [|discriminate].
  assert (P : 0 < a) by exact (decide_sound _ _ _ _ _ _ zero_encloses X D).
  injection 1 as <-. split; trivial.
  assert (W : inside (I.ln p (interval_of bits x)) (ln a)).
  { pose proof (I.ln_correct p _ (Xreal a) (interval_of_inside bits _ _ X)) as L.
    unfold Xln, Xbind, Xln' in L. rewrite is_positive_true in L by assumption. exact L. }
  destruct x as [[[|[n|n|]|n] [d|d|]]|i]; try exact W. cbn [encloses] in *. subst.
  replace (Q2R 1) with 1 by (unfold Q2R; cbn; field). now rewrite ln_1, zero_value.
Qed.
Lemma root_of_power_sound n q r : root_of_power n q = Some r -> nth_root n (Q2R q) = Q2R r.
Proof.
  unfold root_of_power. destruct (root_of n (Zpos (Qden q))) as [|d|d]; try discriminate.
  destruct (_ && _) eqn:E; try discriminate. injection 1 as <-. apply andb_prop in E.
  destruct E as [N E]. apply Z.leb_le in N. apply Qeq_bool_eq, Qeq_eqR in E.
  rewrite exact_power_value in E. apply nth_root_unique; trivial. unfold Q2R.
  apply Rmult_le_pos; [now apply IZR_le | left; apply Rinv_0_lt_compat, IZR_lt; reflexivity].
Qed.
Lemma positive_root_inside n i a : inside i a -> 0 < a ->
  inside (I.exp p (I.div p (I.ln p i) (I.fromZ p (Zpos n)))) (nth_root n a).
Proof.
  intros X P. unfold nth_root. destruct (Rlt_dec 0 a); [|contradiction]. unfold Rpower.
  apply exp_inside. rewrite Rmult_comm. apply div_inside; [|apply I.fromZ_correct|].
  - pose proof (I.ln_correct p _ (Xreal a) X) as L.
    unfold Xln, Xbind, Xln' in L. now rewrite is_positive_true in L by assumption.
  - apply IZR_neq. discriminate.
Qed.
Lemma root_around_inside n is_positive i a : inside i a -> 0 <= a ->
  (is_positive = true -> 0 < a) -> inside (root_around n is_positive i) (nth_root n a).
Proof.
  intros X P Q. unfold root_around. destruct is_positive.
  - apply positive_root_inside; auto.
  - unfold inside. apply I.join_correct. destruct P as [P|<-].
    + right. now apply positive_root_inside.
    + left. rewrite nth_root_of_zero. apply I.fromZ_correct.
Qed.
Lemma enclosed_root_sound n x z a : encloses x a -> enclosed_root n x = Some z ->
  0 <= a /\ encloses z (nth_root n a).
Proof.
  unfold enclosed_root. intros X. destruct (decide bits AtMost (Exact 0) x) eqn:D; [|discriminate].
  assert (P : 0 <= a) by exact (decide_sound _ _ _ _ _ _ zero_encloses X D).
  injection 1 as <-. split; trivial.
  assert (W : encloses (Around (root_around n (decide bits Less (Exact 0) x) (interval_of bits x)))
    (nth_root n a)).
  { apply root_around_inside; trivial; [now apply interval_of_inside|].
    intros L. exact (decide_sound _ _ _ _ _ _ zero_encloses X L). }
  destruct x as [q|i]; trivial. destruct (root_of_power n q) as [r|] eqn:R; trivial.
  cbn [encloses] in *. subst. now apply root_of_power_sound.
Qed.
Lemma at_zero_sound f g x a : g 0 = 0 -> (forall i b, inside i b -> inside (f i) (g b)) ->
  encloses x a -> encloses (at_zero f x) (g a).
Proof.
  intros Z F X. pose proof (F _ _ (interval_of_inside bits _ _ X)) as W.
  destruct x as [[[|n|n] d]|i]; try exact W. cbn [encloses at_zero] in *. subst.
  now rewrite zero_is, Z, zero_value.
Qed.
Lemma elementary_sound f x z a : encloses x a -> enclosed_elementary f x = Some z ->
  in_domain f a /\ encloses z (applied f a).
Proof.
  intros X H. destruct f; cbn [enclosed_elementary in_domain applied] in *.
  - split; trivial. eapply exp_sound; eauto.
  - eapply log_sound; eauto.
  - injection H as <-. split; trivial. apply at_zero_sound; trivial; [exact sin_0|].
    intros i b I. exact (I.sin_correct p i (Xreal b) I).
  - injection H as <-. split; trivial. apply at_zero_sound; trivial; [exact atan_0|].
    intros i b I. exact (I.atan_correct p i (Xreal b) I).
  - eapply enclosed_root_sound; eauto.
Qed.
End Functions.
