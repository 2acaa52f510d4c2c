(* Enclosures of exponentials, logarithms, sines and arc tangents: exact at 0, 1 and 0, else the
   verified functions of coq-interval. An exponential of more than 2^16 is refused, since its value
   would be too long, and so is a logarithm of what is not known to be positive. *)
From Coq Require Import Reals QArith Qreals ZArith Lra.
From Interval Require Import Real.Xreal Interval.Interval.
From Verify Require Import Meaning Enclosures.
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
Definition enclosed_elementary (f : elementary) (x : enclosure) : option enclosure :=
  match f with
  | Exp => enclosed_exp x
  | Log => enclosed_log x
  | Sin => Some (at_zero (I.sin p) x)
  | Atan => Some (at_zero (I.atan p) x)
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
Qed.
End Functions.
