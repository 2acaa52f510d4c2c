(* Polynomials with rational coefficients: sorted lists of monomials, computed and proved.
   Nothing below needs that lists are sorted; it only makes like terms meet. *)
From Coq Require Import Reals QArith Qreals Qreduction ZArith NArith List Lra Lia Bool.
Import ListNotations.
Open Scope R_scope.

(* --- coefficients ----------------------------------------------------------------------------- *)

Definition rational (n : Z) (d : positive) : Q := Qmake n d.
Definition whole (x : Q) : bool := match Qden x with xH => true | _ => false end.
(* Integers are most frequent and need no reduction. *)
Definition qadd (x y : Q) : Q :=
  if whole x && whole y then Qmake (Qnum x + Qnum y) 1 else Qred (x + y).
Definition qmul (x y : Q) : Q :=
  if whole x && whole y then Qmake (Qnum x * Qnum y) 1 else Qred (x * y).

Lemma Q2R_whole x : whole x = true -> Q2R x = IZR (Qnum x).
Proof. destruct x as [n [d|d|]]; try discriminate. intros _. unfold Q2R. simpl. field. Qed.
Lemma Q2R_red x : Q2R (Qred x) = Q2R x.
Proof. apply Qeq_eqR, Qred_correct. Qed.
Lemma Q2R_int n : Q2R (Qmake n 1) = IZR n.
Proof. now apply Q2R_whole. Qed.
Lemma qadd_value x y : Q2R (qadd x y) = Q2R x + Q2R y.
Proof.
  unfold qadd. destruct (whole x && whole y) eqn:W.
  - apply andb_prop in W. destruct W as [X Y].
    now rewrite Q2R_int, plus_IZR, (Q2R_whole _ X), (Q2R_whole _ Y).
  - now rewrite Q2R_red, Q2R_plus.
Qed.
Lemma qmul_value x y : Q2R (qmul x y) = Q2R x * Q2R y.
Proof.
  unfold qmul. destruct (whole x && whole y) eqn:W.
  - apply andb_prop in W. destruct W as [X Y].
    now rewrite Q2R_int, mult_IZR, (Q2R_whole _ X), (Q2R_whole _ Y).
  - now rewrite Q2R_red, Q2R_mult.
Qed.

(* --- monomials and polynomials ---------------------------------------------------------------- *)

Definition monomial := list (positive * positive).  (* atoms, ascending, with their exponents *)
Definition polynomial := list (monomial * Q).       (* descending in the lexicographic order *)
Definition quotient : Set := (polynomial * polynomial)%type.

Fixpoint order (a b : monomial) : comparison :=
  match a, b with
  | [], [] => Eq
  | [], _ => Lt
  | _, [] => Gt
  | (x, m) :: a', (y, n) :: b' =>
      match Pos.compare x y with
      | Lt => Gt
      | Gt => Lt
      | Eq => match Pos.compare m n with Eq => order a' b' | c => c end
      end
  end.
Fixpoint merged (a : monomial) : monomial -> monomial :=
  match a with
  | [] => fun b => b
  | (x, m) :: a' =>
      fix inner b :=
        match b with
        | [] => a
        | (y, n) :: b' =>
            match Pos.compare x y with
            | Lt => (x, m) :: merged a' b
            | Gt => (y, n) :: inner b'
            | Eq => (x, (m + n)%positive) :: merged a' b'
            end
        end
  end.
Definition cons_term (m : monomial) (c : Q) (p : polynomial) : polynomial :=
  match Qnum c with Z0 => p | _ => (m, c) :: p end.
Fixpoint plus (p : polynomial) : polynomial -> polynomial :=
  match p with
  | [] => fun q => q
  | (m, c) :: p' =>
      fix inner q :=
        match q with
        | [] => p
        | (n, d) :: q' =>
            match order m n with
            | Gt => (m, c) :: plus p' q
            | Lt => (n, d) :: inner q'
            | Eq => cons_term m (qadd c d) (plus p' q')
            end
        end
  end.
Definition scaled (m : monomial) (c : Q) (p : polynomial) : polynomial :=
  map (fun t => (merged m (fst t), qmul c (snd t))) p.
(* Sums of neighbours first, so that long lists meet long lists. *)
Fixpoint halved (l : list polynomial) : list polynomial :=
  match l with a :: b :: rest => plus a b :: halved rest | _ => l end.
Fixpoint total (rounds : nat) (l : list polynomial) : polynomial :=
  match rounds with O => fold_right plus [] l | S k => total k (halved l) end.
Definition sum_of (l : list polynomial) : polynomial :=
  match l with [p] => p | [p; q] => plus p q | _ => total 12 l end.
Definition times (p q : polynomial) : polynomial :=
  if (length q <? length p)%nat then sum_of (map (fun t => scaled (fst t) (snd t) p) q)
  else sum_of (map (fun t => scaled (fst t) (snd t) q) p).
Definition opposite (p : polynomial) : polynomial := map (fun t => (fst t, Qopp (snd t))) p.
Definition minus (p q : polynomial) : polynomial := plus p (opposite q).
Definition one : polynomial := [([], 1%Q)].
Definition number (q : Q) : polynomial := cons_term [] (Qred q) [].
Definition atom (x : positive) : polynomial := [([(x, 1%positive)], 1%Q)].
Fixpoint power (p : polynomial) (n : nat) : polynomial :=
  match n with O => one | S O => p | S k => times p (power p k) end.
Definition same_q (c d : Q) : bool := Z.eqb (Qnum c) (Qnum d) && Pos.eqb (Qden c) (Qden d).
Fixpoint same (p q : polynomial) : bool :=
  match p, q with
  | [], [] => true
  | (m, c) :: p', (n, d) :: q' =>
      match order m n with Eq => same_q c d && same p' q' | _ => false end
  | _, _ => false
  end.

(* --- their values ----------------------------------------------------------------------------- *)

Section Values.
Variable v : positive -> R.
Fixpoint monomial_value (m : monomial) : R :=
  match m with [] => 1 | (x, n) :: r => v x ^ Pos.to_nat n * monomial_value r end.
Fixpoint at_values (p : polynomial) : R :=
  match p with [] => 0 | (m, c) :: r => Q2R c * monomial_value m + at_values r end.

Lemma order_same a : forall b, order a b = Eq -> a = b.
Proof.
  induction a as [|[x m] a IH]; intros [|[y n] b]; cbn [order]; try discriminate; trivial.
  destruct (Pos.compare_spec x y); try discriminate.
  destruct (Pos.compare_spec m n); try discriminate.
  intros H1. subst. f_equal. auto.
Qed.
Lemma merged_value a : forall b,
  monomial_value (merged a b) = monomial_value a * monomial_value b.
Proof.
  induction a as [|[x m] a IH]; intros b; [simpl; ring|].
  induction b as [|[y n] b IHb]; [simpl; ring|]. cbn [merged].
  destruct (Pos.compare_spec x y).
  - subst. cbn [monomial_value]. rewrite IH, Pos2Nat.inj_add, pow_add. ring.
  - cbn [monomial_value]. rewrite IH. cbn [monomial_value]. ring.
  - change (monomial_value ((y, n) :: merged ((x, m) :: a) b) =
            monomial_value ((x, m) :: a) * monomial_value ((y, n) :: b)).
    cbn [monomial_value] in *. rewrite IHb. ring.
Qed.
Lemma cons_term_value m c p :
  at_values (cons_term m c p) = Q2R c * monomial_value m + at_values p.
Proof.
  unfold cons_term. destruct c as [[|n|n] d]; try reflexivity.
  cbn [Qnum]. unfold Q2R. simpl. ring.
Qed.
Lemma plus_value p : forall q, at_values (plus p q) = at_values p + at_values q.
Proof.
  induction p as [|[m c] p IH]; intros q; [simpl; ring|].
  induction q as [|[n d] q IHq]; [simpl; ring|]. cbn [plus].
  destruct (order m n) eqn:E.
  - apply order_same in E. subst. rewrite cons_term_value, qadd_value, IH. cbn [at_values]. ring.
  - change (at_values ((n, d) :: plus ((m, c) :: p) q) =
            at_values ((m, c) :: p) + at_values ((n, d) :: q)).
    cbn [at_values] in *. rewrite IHq. ring.
  - cbn [at_values]. rewrite IH. cbn [at_values]. ring.
Qed.
Lemma scaled_value m c p : at_values (scaled m c p) = Q2R c * monomial_value m * at_values p.
Proof.
  induction p as [|[n d] p IH]; cbn [scaled map at_values fst snd]; [ring|].
  unfold scaled in IH. rewrite IH, merged_value, qmul_value. ring.
Qed.
Definition values_sum (l : list polynomial) : R := fold_right (fun p x => at_values p + x) 0 l.
Lemma halved_value l : values_sum (halved l) = values_sum l.
Proof.
  enough (H : values_sum (halved l) = values_sum l /\
              forall a, values_sum (halved (a :: l)) = values_sum (a :: l)) by apply H.
  induction l as [|b l [H1 H2]]; [split; reflexivity|]. split; [apply H2|].
  intros a. cbn [halved values_sum fold_right]. fold (values_sum (halved l)). fold (values_sum l).
  rewrite plus_value, H1. ring.
Qed.
Lemma sum_of_value l : at_values (sum_of l) = values_sum l.
Proof.
  assert (F : forall l, at_values (fold_right plus [] l) = values_sum l).
  { clear l. induction l; cbn [fold_right values_sum]; [reflexivity|].
    rewrite plus_value, IHl. reflexivity. }
  assert (T : forall n l, at_values (total n l) = values_sum l).
  { clear l. induction n; intros l; cbn [total]; [apply F|]. now rewrite IHn, halved_value. }
  unfold sum_of. destruct l as [|a [|b [|c l]]]; try apply T.
  - cbn [values_sum fold_right]. ring.
  - cbn [values_sum fold_right]. rewrite plus_value. ring.
Qed.
Lemma products_value p q :
  values_sum (map (fun t => scaled (fst t) (snd t) q) p) = at_values p * at_values q.
Proof.
  induction p as [|[m c] p IH]; cbn [map values_sum fold_right at_values fst snd]; [ring|].
  fold (values_sum (map (fun t => scaled (fst t) (snd t) q) p)). rewrite IH, scaled_value. ring.
Qed.
Lemma times_value p q : at_values (times p q) = at_values p * at_values q.
Proof. unfold times. destruct (_ <? _)%nat; rewrite sum_of_value, products_value; ring. Qed.
Lemma opposite_value p : at_values (opposite p) = - at_values p.
Proof.
  induction p as [|[m c] p IH]; cbn [opposite map at_values fst snd]; [ring|].
  unfold opposite in IH. rewrite IH, Q2R_opp. ring.
Qed.
Lemma minus_value p q : at_values (minus p q) = at_values p - at_values q.
Proof. unfold minus. rewrite plus_value, opposite_value. ring. Qed.
Lemma one_value : at_values one = 1.
Proof. unfold one. cbn [at_values monomial_value]. rewrite Q2R_int. ring. Qed.
Lemma number_value q : at_values (number q) = Q2R q.
Proof.
  unfold number. rewrite cons_term_value, Q2R_red. cbn [at_values monomial_value]. ring.
Qed.
Lemma atom_value x : at_values (atom x) = v x.
Proof.
  unfold atom. cbn [at_values monomial_value]. rewrite Q2R_int.
  change (Pos.to_nat 1) with 1%nat. ring.
Qed.
Lemma power_value p n : at_values (power p n) = at_values p ^ n.
Proof.
  induction n as [|n IH]; [exact one_value|]. destruct n; [simpl; ring|].
  change (power p (S (S n))) with (times p (power p (S n))).
  rewrite times_value, IH. simpl. ring.
Qed.
Lemma same_value p : forall q, same p q = true -> at_values p = at_values q.
Proof.
  induction p as [|[m c] p IH]; intros [|[n d] q]; cbn [same]; try discriminate; trivial.
  destruct (order m n) eqn:E; try discriminate. intros H.
  apply order_same in E. apply andb_prop in H. destruct H as [H H2].
  apply andb_prop in H. destruct H as [H0 H1]. apply Z.eqb_eq in H0. apply Pos.eqb_eq in H1.
  cbn [at_values]. rewrite (IH _ H2). destruct c, d. simpl in *. now subst.
Qed.
End Values.

(* --- powers of roots -------------------------------------------------------------------------- *)

(* The exponent of an atom, and the other factors. *)
Fixpoint split_at (x : positive) (m : monomial) : N * monomial :=
  match m with
  | [] => (0%N, [])
  | (y, n) :: r =>
      if Pos.eqb x y then (Npos n, r)
      else let (k, rest) := split_at x r in (k, (y, n) :: rest)
  end.
(* How often a power of the atom is in a monomial, and the power that is left. *)
Definition whole_times (x index : positive) (t : monomial * Q) : nat :=
  N.to_nat (fst (N.div_eucl (fst (split_at x (fst t))) (Npos index))).
Definition highest (x index : positive) (p : polynomial) : nat :=
  fold_right (fun t => Nat.max (whole_times x index t)) O p.
(* One monomial times d^top, where x^index = n/d: n^h d^(top - h) takes the place of x^(index h). *)
Definition without_power (x index : positive) (n d : polynomial) (top : nat) (t : monomial * Q) :=
  let (k, rest) := split_at x (fst t) in
  let (h, o) := N.div_eucl k (Npos index) in
  let left := match o with N0 => rest | Npos e => merged [(x, e)] rest end in
  scaled left (snd t) (times (power n (N.to_nat h)) (power d (top - N.to_nat h))).
Definition without_powers (x index : positive) (n d : polynomial) (p : polynomial) : polynomial :=
  match highest x index p with
  | O => p
  | top => sum_of (map (without_power x index n d top) p)
  end.

Section Powers.
Variable v : positive -> R.
Lemma split_at_value x m : forall k rest, split_at x m = (k, rest) ->
  monomial_value v m = v x ^ N.to_nat k * monomial_value v rest.
Proof.
  induction m as [|[y n] m IH]; cbn [split_at]; intros k rest H.
  - injection H as <- <-. simpl. ring.
  - destruct (Pos.eqb_spec x y).
    + injection H as <- <-. subst. reflexivity.
    + destruct (split_at x m) as [k' rest']. injection H as <- <-.
      cbn [monomial_value]. rewrite (IH _ _ eq_refl). ring.
Qed.
Lemma without_power_value x index n d top t :
  v x ^ Pos.to_nat index * at_values v d = at_values v n -> (whole_times x index t <= top)%nat ->
  at_values v (without_power x index n d top t) =
  at_values v d ^ top * (Q2R (snd t) * monomial_value v (fst t)).
Proof.
  destruct t as [m c]. unfold without_power, whole_times. cbn [fst snd].
  destruct (split_at x m) as [k rest] eqn:E. cbn [fst].
  pose proof (N.div_eucl_spec k (Npos index)) as D.
  destruct (N.div_eucl k (Npos index)) as [q o]. cbn [fst]. intros Hx Hk.
  apply split_at_value in E. rewrite E, scaled_value, times_value, !power_value.
  set (h := N.to_nat q) in *.
  assert (K : v x ^ N.to_nat k * monomial_value v rest = (v x ^ Pos.to_nat index) ^ h *
    monomial_value v (match o with N0 => rest | Npos e => merged [(x, e)] rest end)).
  { rewrite D, N2Nat.inj_add, N2Nat.inj_mul, pow_add, pow_mult. fold h. clearbody h.
    change (N.to_nat (Npos index)) with (Pos.to_nat index). destruct o as [|e].
    - change (N.to_nat 0) with 0%nat. ring.
    - rewrite merged_value. cbn [monomial_value]. change (N.to_nat (Npos e)) with (Pos.to_nat e).
      ring. }
  rewrite K, <- Hx, Rpow_mult_distr.
  replace (at_values v d ^ top) with (at_values v d ^ h * at_values v d ^ (top - h))
    by (rewrite <- pow_add; f_equal; lia).
  ring.
Qed.
Lemma without_powers_value x index n d p :
  0 < at_values v d -> v x ^ Pos.to_nat index * at_values v d = at_values v n ->
  exists k, 0 < k /\ at_values v (without_powers x index n d p) = k * at_values v p.
Proof.
  intros Hd Hx. unfold without_powers. destruct (highest x index p) as [|h] eqn:E.
  - exists 1. split; [lra | ring].
  - exists (at_values v d ^ S h). split; [now apply pow_lt|].
    assert (B : (highest x index p <= S h)%nat) by lia. clear E.
    rewrite sum_of_value. induction p as [|t p IH]; cbn [map values_sum fold_right].
    + simpl. ring.
    + cbn [highest fold_right] in B. fold (highest x index p) in B.
      fold (values_sum v (map (without_power x index n d (S h)) p)).
      rewrite IH by lia. rewrite without_power_value by (trivial; lia).
      destruct t as [m c]. cbn [at_values fst snd]. ring.
Qed.
End Powers.
