(* Enclosures of real numbers: exact rationals while they are short, else the verified intervals of
   coq-interval, over plain integers. Each operation encloses the results for all real numbers. *)
From Coq Require Import Reals QArith Qreals Qreduction ZArith List Lra Lia Bool.
From Interval Require Import Float.Specific_stdz Float.Specific_ops Float.Sig Interval.Interval
  Interval.Float_full Real.Xreal Float.Basic.
From Verify Require Import Meaning Polynomials.
Import ListNotations.
Open Scope R_scope.

Module F := SpecificFloat StdZRadix2.
Module I := FloatIntervalFull F.

Inductive enclosure : Type := Exact (q : Q) | Around (i : I.type).
Definition inside (i : I.type) (x : R) : Prop := contains (I.convert i) (Xreal x).
Definition encloses (e : enclosure) (x : R) : Prop :=
  match e with Exact q => x = Q2R q | Around i => inside i x end.

(* --- intervals -------------------------------------------------------------------------------- *)

Section Operations.
Variable bits : positive.
Definition p : F.precision := F.PtoP bits.

Lemma add_inside x y a b : inside x a -> inside y b -> inside (I.add p x y) (a + b).
Proof. intros X Y. exact (I.add_correct p x y (Xreal a) (Xreal b) X Y). Qed.
Lemma sub_inside x y a b : inside x a -> inside y b -> inside (I.sub p x y) (a - b).
Proof. intros X Y. exact (I.sub_correct p x y (Xreal a) (Xreal b) X Y). Qed.
Lemma mul_inside x y a b : inside x a -> inside y b -> inside (I.mul p x y) (a * b).
Proof. intros X Y. exact (I.mul_correct p x y (Xreal a) (Xreal b) X Y). Qed.
Lemma neg_inside x a : inside x a -> inside (I.neg x) (- a).
Proof. intros X. exact (I.neg_correct x (Xreal a) X). Qed.
Lemma cos_inside x a : inside x a -> inside (I.cos p x) (cos a).
Proof. intros X. exact (I.cos_correct p x (Xreal a) X). Qed.
Lemma power_inside x a n : inside x a -> inside (I.power_int p x (Zpos n)) (a ^ Pos.to_nat n).
Proof. intros X. exact (I.power_int_correct p (Zpos n) x (Xreal a) X). Qed.
Lemma div_inside x y a b : inside x a -> inside y b -> b <> 0 -> inside (I.div p x y) (a / b).
Proof.
  intros X Y N. pose proof (I.div_correct p x y (Xreal a) (Xreal b) X Y) as H.
  unfold Xdiv, Xbind2, Xdiv' in H. rewrite is_zero_false in H by assumption. exact H.
Qed.

(* coq-interval has no minimum: it lies in the union, and below both. *)
Definition least_interval x y :=
  I.meet (I.join x y) (I.meet (I.lower_extent x) (I.lower_extent y)).
Definition greatest_interval x y :=
  I.meet (I.join x y) (I.meet (I.upper_extent x) (I.upper_extent y)).
Lemma least_inside x y a b : inside x a -> inside y b -> inside (least_interval x y) (Rmin a b).
Proof.
  intros X Y. unfold least_interval, inside.
  apply I.meet_correct; [apply I.join_correct | apply I.meet_correct].
  - destruct (Rle_dec a b); [rewrite Rmin_left by lra | rewrite Rmin_right by lra]; auto.
  - apply I.lower_extent_correct with a; trivial. apply Rmin_l.
  - apply I.lower_extent_correct with b; trivial. apply Rmin_r.
Qed.
Lemma greatest_inside x y a b :
  inside x a -> inside y b -> inside (greatest_interval x y) (Rmax a b).
Proof.
  intros X Y. unfold greatest_interval, inside.
  apply I.meet_correct; [apply I.join_correct | apply I.meet_correct].
  - destruct (Rle_dec a b); [rewrite Rmax_right by lra | rewrite Rmax_left by lra]; auto.
  - apply I.upper_extent_correct with a; trivial. apply Rmax_l.
  - apply I.upper_extent_correct with b; trivial. apply Rmax_r.
Qed.

(* --- the relation of two enclosures ----------------------------------------------------------- *)

Definition interval_of (e : enclosure) : I.type :=
  match e with
  | Exact (Qmake n 1) => I.fromZ p n
  | Exact (Qmake n d) => I.div p (I.fromZ p n) (I.fromZ p (Zpos d))
  | Around i => i
  end.
Lemma interval_of_inside e x : encloses e x -> inside (interval_of e) x.
Proof.
  destruct e as [[n d]|i]; trivial. cbn [encloses interval_of]. intros ->. unfold Q2R.
  cbn [Qnum Qden]. assert (D : inside (I.div p (I.fromZ p n) (I.fromZ p (Zpos d))) (IZR n / IZR (Zpos d))).
  { apply div_inside; try apply I.fromZ_correct. apply IZR_neq. discriminate. }
  destruct d; try exact D. rewrite Rinv_1, Rmult_1_r. apply I.fromZ_correct.
Qed.

(* The difference, times the denominator of one that is exact. *)
Definition apart (x y : enclosure) : I.type :=
  match x, y with
  | Exact q, _ => I.sub p (I.mul p (interval_of y) (I.fromZ p (Zpos (Qden q)))) (I.fromZ p (Qnum q))
  | _, Exact q => I.sub p (I.fromZ p (Qnum q)) (I.mul p (interval_of x) (I.fromZ p (Zpos (Qden q))))
  | _, _ => I.sub p (interval_of y) (interval_of x)
  end.
Definition signs (x y : enclosure) : Xcomparison * Xcomparison :=
  let d := apart x y in (I.sign_strict d, I.sign_large d).
Lemma apart_inside x y a b : encloses x a -> encloses y b ->
  exists k, 0 < k /\ inside (apart x y) (k * (b - a)).
Proof.
  intros X Y. pose proof (interval_of_inside _ _ X) as A. pose proof (interval_of_inside _ _ Y) as B.
  destruct x as [q|i].
  - exists (IZR (Zpos (Qden q))). assert (P : 0 < IZR (Zpos (Qden q))) by (apply IZR_lt; reflexivity).
    split; trivial. cbn [encloses] in X. subst. unfold Q2R. unfold apart.
    replace (IZR (Zpos (Qden q)) * (b - IZR (Qnum q) * / IZR (Zpos (Qden q)))) with
      (b * IZR (Zpos (Qden q)) - IZR (Qnum q)) by (field; lra).
    apply sub_inside; [apply mul_inside|]; trivial; apply I.fromZ_correct.
  - destruct y as [q|j].
    + exists (IZR (Zpos (Qden q))). assert (P : 0 < IZR (Zpos (Qden q))) by (apply IZR_lt; reflexivity).
      split; trivial. cbn [encloses] in Y. subst. unfold Q2R. unfold apart.
      replace (IZR (Zpos (Qden q)) * (IZR (Qnum q) * / IZR (Zpos (Qden q)) - a)) with
        (IZR (Qnum q) - a * IZR (Zpos (Qden q))) by (field; lra).
      apply sub_inside; [|apply mul_inside]; trivial; apply I.fromZ_correct.
    + exists 1. split; [lra|]. replace (1 * (b - a)) with (b - a) by ring. now apply sub_inside.
Qed.
Definition decide (r : relation) (x y : enclosure) : bool :=
  match x, y with
  | Exact a, Exact b =>
      match r, Qcompare a b with
      | Less, Lt | AtMost, (Lt | Eq) | Equal, Eq | Differs, (Lt | Gt) => true
      | _, _ => false
      end
  | _, _ =>
      match r, signs x y with
      | Less, (Xgt, _) | AtMost, (_, (Xgt | Xeq)) | Equal, (_, Xeq) | Differs, ((Xlt | Xgt), _) =>
          true
      | _, _ => false
      end
  end.
Lemma decide_sound r x y a b : encloses x a -> encloses y b -> decide r x y = true -> related r a b.
Proof.
  intros X Y.
  assert (W : match r, signs x y with
    | Less, (Xgt, _) | AtMost, (_, (Xgt | Xeq)) | Equal, (_, Xeq) | Differs, ((Xlt | Xgt), _) =>
        true
    | _, _ => false end = true -> related r a b).
  { unfold signs. destruct (apart_inside _ _ _ _ X Y) as (k & P & D).
    pose proof (I.sign_strict_correct (apart x y)) as St.
    pose proof (I.sign_large_correct (apart x y)) as La.
    assert (Z1 : 0 < k * (b - a) -> a < b).
    { intros Q. apply Rnot_le_lt. intros N. assert (0 <= k * (a - b)) by (apply Rmult_le_pos; lra). lra. }
    assert (Z2 : k * (b - a) < 0 -> b < a).
    { intros Q. apply Rnot_le_lt. intros N. assert (0 <= k * (b - a)) by (apply Rmult_le_pos; lra). lra. }
    assert (Z3 : k * (b - a) = 0 -> a = b).
    { intros Q. apply Rmult_integral in Q. lra. }
    destruct r, (I.sign_strict (apart x y)), (I.sign_large (apart x y)); try discriminate; intros _;
      cbn [related];
      first [ destruct (St _ D) as [? Q]; simpl in Q; specialize (Z1 Q); lra
            | destruct (St _ D) as [? Q]; simpl in Q; specialize (Z2 Q); lra
            | destruct (La _ D) as [? Q]; simpl in Q;
              destruct (Req_dec (k * (b - a)) 0) as [E|E]; [specialize (Z3 E); lra | specialize (Z1 ltac:(lra)); lra]
            | specialize (La _ D); injection La as Q; specialize (Z3 Q); lra ]. }
  destruct x as [q|i], y as [q'|j]; try exact W. clear W. cbn [encloses decide] in *. subst.
  destruct r, (Qcompare_spec q q') as [E|E|E]; try discriminate; intros _; cbn [related];
    first [apply Qeq_eqR in E | apply Qlt_Rlt in E]; lra.
Qed.

(* --- operations ------------------------------------------------------------------------------- *)

(* A rational stays as it is while it is short. *)
Definition short (q : Q) : bool :=
  (Zpos (Pos.size (Qden q)) + Z.log2 (Z.abs (Qnum q)) <=? 2 * Zpos bits)%Z.
Definition exact (q : Q) : enclosure :=
  if short q then Exact q else Around (interval_of (Exact q)).
Lemma exact_encloses q : encloses (exact q) (Q2R q).
Proof.
  unfold exact. destruct (short q); [reflexivity|]. now apply (interval_of_inside (Exact q)).
Qed.

Definition enclosed_add (x y : enclosure) : enclosure :=
  match x, y with
  | Exact a, Exact b => exact (qadd a b)
  | _, _ => Around (I.add p (interval_of x) (interval_of y))
  end.
Definition enclosed_neg (x : enclosure) : enclosure :=
  match x with Exact a => Exact (Qopp a) | Around i => Around (I.neg i) end.
Definition enclosed_sub (x y : enclosure) : enclosure :=
  match x, y with
  | Exact a, Exact b => exact (qadd a (Qopp b))
  | _, _ => Around (I.sub p (interval_of x) (interval_of y))
  end.
Definition enclosed_mul (x y : enclosure) : enclosure :=
  match x, y with
  | Exact a, Exact b => exact (qmul a b)
  | _, _ => Around (I.mul p (interval_of x) (interval_of y))
  end.
Definition enclosed_div (x y : enclosure) : option enclosure :=
  if decide Less (Exact 0) y || decide Less y (Exact 0) then
    Some match x, y with
    | Exact a, Exact b => exact (Qred (a / b))
    | _, _ => Around (I.div p (interval_of x) (interval_of y))
    end
  else None.
Definition exact_power (q : Q) (n : positive) : Q :=
  Qmake (Qnum q ^ Zpos n) (Qden q ^ n).
Definition enclosed_power (x : enclosure) (n : positive) : enclosure :=
  match x with
  | Exact a =>
      if short (Qmake (Zpos n * (1 + Z.log2 (Z.abs (Qnum a)) + Zpos (Pos.size (Qden a)))) 1)
      then exact (exact_power a n)
      else Around (I.power_int p (interval_of x) (Zpos n))
  | Around i => Around (I.power_int p i (Zpos n))
  end.
Definition root_of_square (q : Q) : option Q :=
  let n := Z.sqrt (Qnum q) in
  let d := Pos.sqrt (Qden q) in
  if Z.eqb (n * n) (Qnum q) && Pos.eqb (d * d) (Qden q) then Some (Qmake n d) else None.
Definition enclosed_sqrt (x : enclosure) : option enclosure :=
  if decide AtMost (Exact 0) x then
    Some match x with
    | Exact a =>
        match root_of_square a with
        | Some r => Exact r
        | None => Around (I.sqrt p (interval_of x))
        end
    | Around i => Around (I.sqrt p i)
    end
  else None.
Definition enclosed_min (x y : enclosure) : enclosure :=
  if decide AtMost x y then x else if decide AtMost y x then y
  else Around (least_interval (interval_of x) (interval_of y)).
Definition enclosed_max (x y : enclosure) : enclosure :=
  if decide AtMost x y then y else if decide AtMost y x then x
  else Around (greatest_interval (interval_of x) (interval_of y)).
Definition enclosed_cos (x : enclosure) : enclosure :=
  match x with
  | Exact (Qmake 0 _) => Exact 1
  | _ => Around (I.cos p (interval_of x))
  end.
Definition enclosed_cos_pi (x : enclosure) : enclosure :=
  match x with
  | Exact (Qmake n 1) => Exact (if Z.even n then 1 else (-1))%Q
  | Exact (Qmake n 2) =>
      if Z.odd n then Exact 0 else Around (I.cos p (I.mul p (I.pi p) (interval_of x)))
  | _ => Around (I.cos p (I.mul p (I.pi p) (interval_of x)))
  end.

Ltac intervals := repeat match goal with
  | H : encloses _ _ |- _ => apply interval_of_inside in H end.

Lemma add_sound x y a b : encloses x a -> encloses y b -> encloses (enclosed_add x y) (a + b).
Proof.
  destruct x as [q|i], y as [q'|j]; intros X Y; try (intervals; now apply add_inside).
  cbn [encloses enclosed_add] in *. subst. rewrite <- qadd_value. apply exact_encloses.
Qed.
Lemma neg_sound x a : encloses x a -> encloses (enclosed_neg x) (- a).
Proof.
  destruct x; intros X; [|now apply neg_inside].
  cbn [encloses enclosed_neg] in *. subst. now rewrite Q2R_opp.
Qed.
Lemma sub_sound x y a b : encloses x a -> encloses y b -> encloses (enclosed_sub x y) (a - b).
Proof.
  destruct x as [q|i], y as [q'|j]; intros X Y; try (intervals; now apply sub_inside).
  cbn [encloses enclosed_sub] in *. subst. unfold Rminus. rewrite <- Q2R_opp, <- qadd_value.
  apply exact_encloses.
Qed.
Lemma mul_sound x y a b : encloses x a -> encloses y b -> encloses (enclosed_mul x y) (a * b).
Proof.
  destruct x as [q|i], y as [q'|j]; intros X Y; try (intervals; now apply mul_inside).
  cbn [encloses enclosed_mul] in *. subst. rewrite <- qmul_value. apply exact_encloses.
Qed.
Lemma zero_value : Q2R 0 = 0.
Proof. unfold Q2R. simpl. ring. Qed.
Lemma zero_encloses : encloses (Exact 0) 0.
Proof. cbn. now rewrite zero_value. Qed.
Lemma div_sound x y z a b : encloses x a -> encloses y b -> enclosed_div x y = Some z ->
  b <> 0 /\ encloses z (a / b).
Proof.
  unfold enclosed_div. intros X Y.
  destruct (decide Less (Exact 0) y || decide Less y (Exact 0)) eqn:D; try discriminate.
  assert (N : b <> 0).
  { apply orb_prop in D. destruct D as [D|D]; eapply decide_sound in D;
      eauto using zero_encloses; cbn [related] in D; lra. }
  injection 1 as <-. split; trivial.
  destruct x as [q|i], y as [q'|j]; try (intervals; now apply div_inside).
  cbn [encloses] in *. subst.
  assert (~ q' == 0)%Q by (intros K; apply Qeq_eqR in K; rewrite zero_value in K; contradiction).
  rewrite <- Q2R_div, <- (Q2R_red (q / q')) by assumption. apply exact_encloses.
Qed.
Lemma exact_power_value q n : Q2R (exact_power q n) = Q2R q ^ Pos.to_nat n.
Proof.
  unfold Q2R, exact_power. cbn [Qnum Qden]. rewrite Rpow_mult_distr, pow_inv.
  rewrite Pos2Z.inj_pow, <- !positive_nat_Z, <- !pow_IZR. now rewrite positive_nat_Z.
Qed.
Lemma power_sound x a n : encloses x a -> encloses (enclosed_power x n) (a ^ Pos.to_nat n).
Proof.
  destruct x as [q|i]; intros X; cbn [enclosed_power]; [|now apply power_inside].
  destruct (short _).
  - cbn [encloses] in X. subst. rewrite <- exact_power_value. apply exact_encloses.
  - intervals. now apply power_inside.
Qed.
Lemma root_of_square_value q r : root_of_square q = Some r -> 0 <= Q2R q -> sqrt (Q2R q) = Q2R r.
Proof.
  unfold root_of_square. destruct (_ && _) eqn:E; try discriminate. injection 1 as <-.
  apply andb_prop in E. destruct E as [N D]. apply Z.eqb_eq in N. apply Pos.eqb_eq in D. intros P.
  set (n := Z.sqrt (Qnum q)) in *. set (d := Pos.sqrt (Qden q)) in *.
  assert (V : Q2R q = Q2R (Qmake n d) * Q2R (Qmake n d)).
  { unfold Q2R. cbn [Qnum Qden]. rewrite <- N, <- D, Pos2Z.inj_mul, !mult_IZR.
    assert (IZR (Zpos d) <> 0) by (apply IZR_neq; discriminate). field. assumption. }
  rewrite V. apply sqrt_square. unfold Q2R. cbn [Qnum Qden]. apply Rmult_le_pos.
  - apply IZR_le. apply Z.sqrt_nonneg.
  - apply Rlt_le, Rinv_0_lt_compat, IZR_lt. reflexivity.
Qed.
Lemma sqrt_sound x z a : encloses x a -> enclosed_sqrt x = Some z -> 0 <= a /\ encloses z (sqrt a).
Proof.
  unfold enclosed_sqrt. intros X. destruct (decide AtMost (Exact 0) x) eqn:D; try discriminate.
  assert (P : 0 <= a) by (eapply decide_sound in D; eauto using zero_encloses).
  injection 1 as <-. split; trivial.
  assert (K : inside (I.sqrt p (interval_of x)) (sqrt a))
    by exact (I.sqrt_correct p _ (Xreal a) (interval_of_inside _ _ X)).
  destruct x as [q|i]; trivial. destruct (root_of_square q) eqn:E; trivial.
  cbn [encloses] in *. subst. now apply root_of_square_value.
Qed.
Lemma min_sound x y a b : encloses x a -> encloses y b -> encloses (enclosed_min x y) (Rmin a b).
Proof.
  intros X Y. unfold enclosed_min. destruct (decide AtMost x y) eqn:D.
  - eapply decide_sound in D; eauto. cbn [related] in D. now rewrite Rmin_left.
  - clear D. destruct (decide AtMost y x) eqn:D.
    + eapply decide_sound in D; eauto. cbn [related] in D. now rewrite Rmin_right.
    + intervals. now apply least_inside.
Qed.
Lemma max_sound x y a b : encloses x a -> encloses y b -> encloses (enclosed_max x y) (Rmax a b).
Proof.
  intros X Y. unfold enclosed_max. destruct (decide AtMost x y) eqn:D.
  - eapply decide_sound in D; eauto. cbn [related] in D. now rewrite Rmax_right.
  - clear D. destruct (decide AtMost y x) eqn:D.
    + eapply decide_sound in D; eauto. cbn [related] in D. now rewrite Rmax_left.
    + intervals. now apply greatest_inside.
Qed.
Lemma cos_sound x a : encloses x a -> encloses (enclosed_cos x) (cos a).
Proof.
  intros X. assert (C : inside (I.cos p (interval_of x)) (cos a)) by (intervals; now apply cos_inside).
  destruct x as [[[] d]|i]; try exact C. cbn [encloses enclosed_cos] in *. subst.
  replace (Q2R (Qmake 0 d)) with 0 by (unfold Q2R; cbn; ring). rewrite cos_0.
  unfold Q2R. cbn. field.
Qed.
Lemma cos_even k : cos (PI * IZR (2 * k)) = 1.
Proof.
  assert (N : forall n, cos (PI * (2 * INR n)) = 1).
  { intros n. replace (PI * (2 * INR n)) with (0 + 2 * INR n * PI) by ring.
    now rewrite cos_period, cos_0. }
  rewrite mult_IZR. destruct (Z_le_gt_dec 0 k).
  - rewrite <- (Z2Nat.id k), <- INR_IZR_INZ by assumption. apply N.
  - rewrite <- cos_neg. replace (- (PI * (2 * IZR k))) with (PI * (2 * IZR (- k)))
      by (rewrite opp_IZR; ring).
    rewrite <- (Z2Nat.id (- k)), <- INR_IZR_INZ by lia. apply N.
Qed.
Lemma cos_integer n : cos (PI * IZR n) = if Z.even n then 1 else -1.
Proof.
  destruct (Z.even n) eqn:E.
  - apply Z.even_spec in E. destruct E as [k ->]. apply cos_even.
  - assert (O : Z.odd n = true) by (rewrite <- Z.negb_even, E; reflexivity).
    apply Z.odd_spec in O. destruct O as [k ->]. rewrite plus_IZR.
    replace (PI * (IZR (2 * k) + 1)) with (PI * IZR (2 * k) + PI) by ring.
    rewrite neg_cos, cos_even. reflexivity.
Qed.
Lemma cos_half_integer k : cos (PI * Q2R (Qmake (2 * k + 1) 2)) = 0.
Proof.
  apply cos_eq_0_1. exists k. unfold Q2R. cbn [Qnum Qden]. rewrite plus_IZR, mult_IZR. field.
Qed.
Lemma cos_pi_sound x a : encloses x a -> encloses (enclosed_cos_pi x) (cos (PI * a)).
Proof.
  intros X.
  assert (K : inside (I.cos p (I.mul p (I.pi p) (interval_of x))) (cos (PI * a))).
  { intervals. apply cos_inside, mul_inside; trivial. apply I.pi_correct. }
  destruct x as [[n [d|[d|d|]|]]|i]; try exact K.
  - cbn [encloses enclosed_cos_pi] in *. destruct (Z.odd n) eqn:O; [|exact K]. clear K. subst.
    apply Z.odd_spec in O. destruct O as [k ->]. cbn [encloses]. rewrite zero_value.
    now apply cos_half_integer.
  - clear K. cbn [encloses enclosed_cos_pi] in *. subst. rewrite Q2R_int, cos_integer.
    destruct (Z.even n); unfold Q2R; simpl; lra.
Qed.

(* What lies above one number and below another; none, if no number does. *)
Definition enclosed_between (low high : enclosure) : option enclosure :=
  if decide Less high low then None
  else if decide Equal low high then Some low
  else Some (Around (I.meet (I.upper_extent (interval_of low)) (I.lower_extent (interval_of high)))).
Lemma between_sound low high z a b x : encloses low a -> encloses high b -> a <= x <= b ->
  enclosed_between low high = Some z -> encloses z x.
Proof.
  unfold enclosed_between. intros L H [A B]. destruct (decide Less high low); try discriminate.
  destruct (decide Equal low high) eqn:E; injection 1 as <-.
  - eapply decide_sound in E; eauto. cbn [related] in E. replace x with a by lra. assumption.
  - intervals. cbn [encloses]. apply I.meet_correct.
    + now apply I.upper_extent_correct with a.
    + now apply I.lower_extent_correct with b.
Qed.
End Operations.
