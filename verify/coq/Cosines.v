(* The rules on cosines: sums of angles, and the partial sums of the series. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool FMapPositive.
From Verify Require Import Meaning Polynomials Terms Clearing Cleared Enclosures Series.
Import ListNotations.
Open Scope R_scope.

Section Rules.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable knows : bool -> positive -> bool.
Variable is_defined : positive -> bool.
Notation clear_all := (each (clear T K knows is_defined (PM.empty positive) levels) nothing_cleared).

(* The angle of a cosine, and whether it is that of cos_pi. *)
Definition cosine_of (i : positive) : option (bool * positive) :=
  match PM.find i T with
  | Some (NCos a) => Some (false, a)
  | Some (NCosPi a) => Some (true, a)
  | _ => None
  end.
(* Whether s is u + v, or u - v, identically. *)
Definition is_sum (plus_ : polynomial -> polynomial -> polynomial) (u v s : positive) : bool :=
  match clear_all [u; v; s] with
  | Some ([x; y; z], m) =>
      let (n, d) := added plus_ x y in vanishes m (minus (times n (snd z)) (times (fst z) d))
  | _ => false
  end.
Definition angles (g : claim) : bool :=
  match relation_of g, PM.find (lhs g) T, PM.find (rhs g) T with
  | Equal, Some (NMul two w), Some (NAdd a b) =>
      match is_rational T two, PM.find w T with
      | Some q, Some (NMul c d) =>
          match cosine_of c, cosine_of d, cosine_of a, cosine_of b with
          | Some (k, u), Some (l, v), Some (m, s), Some (n, t) =>
              Qeq_bool q 2 && Bool.eqb k l && Bool.eqb k m && Bool.eqb k n &&
              is_sum plus u v s && is_sum minus u v t
          | _, _, _, _ => false
          end
      | _, _ => false
      end
  | _, _, _ => false
  end.

Definition bits : positive := 128.
(* The coefficients of a polynomial in u^2 that is a number c, or c + u^2 (...). *)
Fixpoint coefficients (fuel : nat) (u i : positive) : option (list Q) :=
  match fuel, PM.find i T with
  | S fuel, Some (NAdd c r) =>
      match is_rational T c, PM.find r T with
      | Some q, Some (NMul w j) =>
          match PM.find w T with
          | Some (NPow x 2) =>
              if Pos.eqb x u then let* l := coefficients fuel u j in Some (q :: l) else None
          | _ => None
          end
      | _, _ => None
      end
  | _, Some (NRational n d) => Some [Qmake n d]
  | _, _ => None
  end.
(* Each coefficient is at most that of the series (at least), the first of which is given; n + 1 is
   the next power. *)
Fixpoint on_side (is_above : bool) (y exact_ : enclosure) (n : positive) (l : list Q) : bool :=
  match l with
  | [] => true
  | c :: r =>
      (if is_above then decide bits AtMost exact_ (Exact c) else decide bits AtMost (Exact c) exact_) &&
      on_side is_above y (enclosed_mul bits exact_ (enclosed_mul bits (enclosed_mul bits y y)
        (exact bits (Qmake (-1) (n * Pos.succ n))))) (Pos.succ (Pos.succ n)) r
  end.
Definition bounded (is_above is_sine is_pi : bool) (u i : positive) : bool :=
  let y := if is_pi then Around (I.pi (p bits)) else Exact 1%Q in
  match coefficients levels u i with
  | Some (c :: r) =>
      Bool.eqb (Nat.even (length r)) is_above &&
      on_side is_above y (if is_sine then y else Exact 1%Q) (if is_sine then 2 else 1) (c :: r)
  | _ => false
  end.
(* The angle u of cos_pi (1/2 - u). *)
Definition complement (a : positive) : option positive :=
  match PM.find a T with
  | Some (NSub half u) =>
      match is_rational T half with
      | Some q => if Qeq_bool q (1 # 2) then Some u else None
      | None => None
      end
  | _ => None
  end.
Definition cosine_bound (is_above : bool) (found bound : positive) : bool :=
  match cosine_of found with
  | Some (is_pi, a) =>
      match clear_all [a] with None => false | Some _ =>
        match is_pi, PM.find bound T with
        | true, Some (NMul u i) =>
            match complement a with
            | Some x =>
                Pos.eqb x u && (knows false u || knows true u) && bounded is_above true true u i
            | None => false
            end
        | _, _ => bounded is_above false is_pi a bound
        end
      end
  | None => false
  end.
Definition cosine (g : claim) : bool :=
  match relation_of g, cosine_of (lhs g) with
  | AtMost, Some _ => cosine_bound true (lhs g) (rhs g)
  | AtMost, None => cosine_bound false (rhs g) (lhs g)
  | _, _ => false
  end.
End Rules.

(* --- soundness -------------------------------------------------------------------------------- *)

Section SoundCosines.
Variable S : statement.
Variable T : PM.t node.
Hypothesis ready : tabled S T.
Variable K : PM.t positive.
Variable v : valuation.
Variable knows : bool -> positive -> bool.
Variable is_defined : positive -> bool.
Hypothesis right_here : right_at S v knows is_defined.
Notation val := (value_at S v).
Notation def := (defined_at S v).

Let value_here := value_is S T ready v.
Let defined_here := defined_is S T ready v.
Let number_here := rational_sound S T ready v.
Let knows_sound := signs_right _ _ _ _ right_here.
Lemma each_cleared l xs m :
  each (clear T K knows is_defined (PM.empty positive) levels) nothing_cleared l = Some (xs, m) ->
  sound S v m /\ Forall2 (is_quotient S v) l xs.
Proof.
  intros E. apply (each_sound (sound S v) (is_quotient S v)) in E; trivial; [|apply nothing_sound].
  intros s i x s1 _ Q C. eapply (clear_sound S T ready K v knows is_defined right_here (PM.empty positive)); eauto.
  intros a b X. now rewrite PM.gempty in X.
Qed.

Definition turn (is_pi : bool) : R := if is_pi then PI else 1.
Lemma cosine_of_sound i is_pi a : cosine_of T i = Some (is_pi, a) ->
  val i = cos (turn is_pi * val a) /\ (def a -> def i).
Proof.
  unfold cosine_of. destruct (PM.find i T) as [[]|] eqn:E; try discriminate; injection 1 as <- <-;
    rewrite (value_here _ _ E), (defined_here _ _ E); cbn; split;
    try (f_equal; ring); intros D; split; trivial; intros b [<-|[]]; trivial.
Qed.
Lemma is_sum_sound op plus_ a b c :
  (forall p q, at_values val (plus_ p q) = op (at_values val p) (at_values val q)) ->
  (forall a b c, op a b * c = op (a * c) (b * c)) ->
  is_sum T K knows is_defined plus_ a b c = true ->
  def a /\ def b /\ def c /\ val c = op (val a) (val b).
Proof.
  intros P D. unfold is_sum. destruct (each _ _ _) as [[[|x [|y [|z []]]] m]|] eqn:E; try discriminate.
  apply each_cleared in E. destruct E as [Q E].
  inversion E as [|? ? ? ? (D1 & P1 & V1) E1]; subst. inversion E1 as [|? ? ? ? (D2 & P2 & V2) E2]; subst.
  inversion E2 as [|? ? ? ? (D3 & P3 & V3) _]; subst.
  pose proof (added_value S v op plus_ x y (val a) (val b) P D P1 V1 P2 V2) as [Pd Vd].
  destruct (added plus_ x y) as [n d]. cbn [fst snd] in *. intros W. repeat (split; trivial).
  apply (vanishes_sound S v) in W; trivial. rewrite minus_value, !times_value, <- Vd, <- V3 in W.
  apply Rmult_eq_reg_r with (at_values val d * at_values val (snd z)).
  - lra.
  - apply Rgt_not_eq, Rmult_lt_0_compat; lra.
Qed.
Lemma angles_sound g : angles T K knows is_defined g = true -> holds S v g.
Proof.
  unfold angles. destruct g as [r e f]. cbn [relation_of lhs rhs].
  destruct r; try discriminate. destruct (PM.find e T) as [[]|] eqn:E; try discriminate.
  destruct (PM.find f T) as [[]|] eqn:F; try discriminate. rename a into two, b into w, a0 into a, b0 into b.
  destruct (is_rational T two) as [q|] eqn:Q; try discriminate.
  destruct (PM.find w T) as [[]|] eqn:W; try discriminate. rename a0 into c, b0 into d.
  destruct (cosine_of T c) as [[k x]|] eqn:C; try discriminate.
  destruct (cosine_of T d) as [[l y]|] eqn:D; try discriminate.
  destruct (cosine_of T a) as [[m s]|] eqn:A; try discriminate.
  destruct (cosine_of T b) as [[n t]|] eqn:B; try discriminate. intros H.
  repeat (apply andb_prop in H; let N := fresh "N" in destruct H as [H N]).
  apply eqb_prop in N1, N2, N3. subst l m n. apply Qeq_bool_eq, Qeq_eqR in H.
  apply number_here in Q. destruct Q as [Q1 Q2].
  apply cosine_of_sound in A, B, C, D.
  apply (is_sum_sound Rplus) in N0; [|apply plus_value | intros; ring].
  apply (is_sum_sound Rminus) in N; [|apply minus_value | intros; ring].
  destruct A as [A1 A2], B as [B1 B2], C as [C1 C2], D as [D1 D2].
  destruct N as (Dx & Dy & Dt & Vt), N0 as (_ & _ & Ds & Vs).
  unfold holds, stands. cbn [relation_of lhs rhs related].
  rewrite (defined_here _ _ E), (defined_here _ _ F), (value_here _ _ E), (value_here _ _ F).
  cbn [subterms proviso node_value In]. repeat split; trivial.
  - intros j [<-|[<-|[]]]; trivial. rewrite (defined_here _ _ W). cbn. split; trivial.
    intros j [<-|[<-|[]]]; auto.
  - intros j [<-|[<-|[]]]; auto.
  - rewrite (value_here _ _ W). cbn [node_value].
    rewrite Q1, H, A1, B1, C1, D1, Vs, Vt, Rmult_plus_distr_l, Rmult_minus_distr_l, cos_plus, cos_minus.
    unfold Q2R. simpl. field.
Qed.

(* --- the series --- *)

Fixpoint horner (l : list Q) (x : R) : R :=
  match l with [] => 0 | c :: r => Q2R c + x ^ 2 * horner r x end.
Lemma coefficients_sound fuel u : forall i l, coefficients T fuel u i = Some l ->
  val i = horner l (val u) /\ (def u -> def i).
Proof.
  assert (Single : forall i n d, PM.find i T = Some (NRational n d) ->
    val i = horner [Qmake n d] (val u) /\ (def u -> def i)).
  { intros i n d E. rewrite (value_here _ _ E), (defined_here _ _ E). cbn. split; [|tauto].
    unfold Q2R. cbn. unfold Rdiv. ring. }
  induction fuel as [|fuel IH]; cbn [coefficients]; intros i l E;
    destruct (PM.find i T) as [[]|] eqn:N; try discriminate; try (injection E as <-; now apply Single).
  destruct (is_rational T a) as [q|] eqn:Q; try discriminate.
  destruct (PM.find b T) as [[]|] eqn:B; try discriminate.
  destruct (PM.find a0 T) as [[]|] eqn:A; try discriminate.
  destruct n as [|[]|]; try discriminate. destruct (Pos.eqb_spec a1 u); try discriminate. subst a1.
  bind E r W. injection E as <-. apply IH in W. apply number_here in Q.
  rewrite (value_here _ _ N), (defined_here _ _ N). cbn [node_value subterms proviso In].
  rewrite (value_here _ _ B). cbn [node_value]. rewrite (value_here _ _ A). cbn [node_value].
  destruct Q as [-> Q], W as [-> W]. split; [reflexivity|].
  intros D. split; trivial. intros j [<-|[<-|[]]]; trivial. rewrite (defined_here _ _ B). split; [|constructor].
  intros j [<-|[<-|[]]]; auto. rewrite (defined_here _ _ A). cbn. split; trivial.
  intros j [<-|[]]; trivial.
Qed.

Lemma on_side_sound is_above s y (Y : R) x l : encloses y Y -> (s = 0%nat \/ 0 <= x) ->
  forall k e n, encloses e (term_of s k Y) -> Zpos n = Z.of_nat (2 * k + s + 1) ->
  on_side is_above y e n l = true ->
  let p := horner l x * x ^ (2 * k + s) in let q := from s k (length l) (Y * x) in
  if is_above then q <= p else p <= q.
Proof.
  intros HY Hx. induction l as [|c r IH]; cbn [on_side horner length from]; intros k e n He Hn H.
  - cbn. destruct is_above; lra.
  - apply andb_prop in H. destruct H as [H1 H2]. cbn zeta.
    assert (P : 0 <= x ^ (2 * k + s)).
    { destruct Hx as [->|Hx]; [|now apply pow_le]. rewrite Nat.add_0_r, pow_mult. apply pow_le, pow2_ge_0. }
    apply (IH (Datatypes.S k)) in H2.
    + cbn zeta in H2. rewrite term_product. set (z := x ^ (2 * k + s)) in *.
      replace (x ^ (2 * Datatypes.S k + s)) with (x ^ 2 * z) in H2
        by (unfold z; rewrite <- pow_add; f_equal; lia).
      assert (E : encloses (Exact c) (Q2R c)) by reflexivity.
      destruct is_above; [apply (decide_sound bits _ _ _ _ _ He E) in H1 |
        apply (decide_sound bits _ _ _ _ _ E He) in H1]; cbn [related] in H1;
        apply (Rmult_le_compat_r z) in H1; trivial; lra.
    + rewrite term_next. apply mul_sound; trivial. apply mul_sound; [now apply mul_sound|].
      replace (-1 / (INR (2 * k + s + 1) * INR (2 * k + s + 2))) with (Q2R (Qmake (-1) (n * Pos.succ n)));
        [apply exact_encloses|].
      unfold Q2R. cbn [Qnum Qden]. unfold Rdiv. f_equal. f_equal.
      rewrite Pos2Z.inj_mul, mult_IZR, Pos2Z.inj_succ, Hn, <- Nat2Z.inj_succ, <- !INR_IZR_INZ.
      f_equal. f_equal. lia.
    + rewrite !Pos2Z.inj_succ, Hn. lia.
Qed.
Lemma bounded_sound is_above (is_sine is_pi : bool) u i : (is_sine = true -> is_pi = true /\ 0 <= val u) ->
  bounded T is_above is_sine is_pi u i = true ->
  (def u -> def i) /\
  let b := if is_sine then val u * val i else val i in
  let c := if is_sine then sin (PI * val u) else cos (turn is_pi * val u) in
  if is_above then c <= b else b <= c.
Proof.
  unfold bounded. intros Q. set (y := if is_pi then _ else _).
  destruct (coefficients T levels u i) as [[|c r]|] eqn:L; try discriminate. intros H.
  apply andb_prop in H. destruct H as [O H]. apply eqb_prop in O.
  apply coefficients_sound in L. destruct L as [L D]. split; trivial. rewrite L. clear L D.
  assert (One : encloses (Exact 1%Q) 1) by (cbn; unfold Q2R; cbn; field).
  assert (Y : encloses y (turn is_pi)).
  { subst y. destruct is_pi; [apply I.pi_correct | exact One]. }
  clearbody y.
  set (s := if is_sine then 1%nat else 0%nat).
  assert (B : 0 <= (-1) ^ length r *
    (partial s (Datatypes.S (length r)) (turn is_pi * val u) -
      (if is_sine then sin (PI * val u) else cos (turn is_pi * val u)))).
  { subst s. destruct is_sine; [|apply cosine_bounds]. destruct Q as [-> Q]; trivial.
    apply sine_bounds. apply Rmult_le_pos; [pose proof PI_RGT_0; lra | trivial]. }
  apply (on_side_sound is_above s y (turn is_pi) (val u) (c :: r) Y) with (k := 0%nat) in H.
  - cbn zeta in *. replace (2 * 0 + s)%nat with s in H by lia.
    change (from s 0 (length (c :: r))) with (partial s (Datatypes.S (length r))) in H.
    replace (if is_sine then val u * horner (c :: r) (val u) else horner (c :: r) (val u)) with
      (horner (c :: r) (val u) * val u ^ s) by (subst s; destruct is_sine; cbn [pow]; ring).
    destruct (Nat.even (length r)) eqn:Ev.
    + subst is_above. apply Nat.even_spec in Ev. destruct Ev as [h Eh].
      rewrite Eh, pow_1_even in B. rewrite <- Eh in B. lra.
    + subst is_above. assert (Od : Nat.odd (length r) = true) by (unfold Nat.odd; now rewrite Ev).
      apply Nat.odd_spec in Od. destruct Od as [h Eh].
      replace (2 * h + 1)%nat with (Datatypes.S (2 * h)) in Eh by lia.
      rewrite Eh, pow_1_odd in B. rewrite <- Eh in B. lra.
  - subst s. destruct is_sine; [right; now apply Q | now left].
  - subst s. unfold term_of. destruct is_sine.
    + replace (_ / _) with (turn is_pi) by (cbn; field). exact Y.
    + replace (_ / _) with 1 by (cbn; field). exact One.
  - subst s. now destruct is_sine.
Qed.
Lemma complement_sound a u : complement T a = Some u -> val a = 1 / 2 - val u.
Proof.
  unfold complement. destruct (PM.find a T) as [[]|] eqn:A; try discriminate.
  destruct (is_rational T a0) as [q|] eqn:Q; try discriminate.
  destruct (Qeq_bool q (1 # 2)) eqn:E; try discriminate. injection 1 as <-.
  apply Qeq_bool_eq, Qeq_eqR in E. apply number_here in Q. destruct Q as [Q _].
  rewrite (value_here _ _ A). cbn [node_value]. rewrite Q, E. unfold Q2R. simpl. lra.
Qed.
Lemma cosine_bound_sound is_above found bound :
  cosine_bound T K knows is_defined is_above found bound = true ->
  def found /\ def bound /\ if is_above then val found <= val bound else val bound <= val found.
Proof.
  unfold cosine_bound. destruct (cosine_of T found) as [[is_pi a]|] eqn:C; try discriminate.
  destruct (each _ _ _) as [[xs m]|] eqn:E; try discriminate.
  apply each_cleared in E. destruct E as [_ E]. inversion E as [|? ? ? ? (D & _) _]; subst.
  apply cosine_of_sound in C. destruct C as [Cv Cd]. specialize (Cd D). rewrite Cv.
  assert (Plain : bounded T is_above false is_pi a bound = true ->
    def found /\ def bound /\ if is_above then cos (turn is_pi * val a) <= val bound
      else val bound <= cos (turn is_pi * val a)).
  { intros B. apply bounded_sound in B; [|discriminate]. destruct B as [Bd B]. auto. }
  destruct is_pi; [|exact Plain].
  destruct (PM.find bound T) as [[]|] eqn:N; try exact Plain. clear Plain.
  destruct (complement T a) as [x|] eqn:X; try discriminate. intros B.
  apply andb_prop in B. destruct B as [B1 B]. apply andb_prop in B1. destruct B1 as [B1 B2].
  apply Pos.eqb_eq in B1. subst x.
  assert (U : 0 <= val a0). { apply orb_prop in B2. destruct B2 as [B2|B2]; now apply knows_sound in B2. }
  assert (Du : def a0).
  { unfold complement in X. destruct (PM.find a T) as [[]|] eqn:A; try discriminate.
    destruct (is_rational T a1); try discriminate. destruct (Qeq_bool q (1 # 2)); try discriminate.
    injection X as <-. rewrite (defined_here _ _ A) in D. apply D. cbn. tauto. }
  apply complement_sound in X. apply bounded_sound in B; [|auto]. destruct B as [Bd B].
  rewrite (defined_here _ _ N), (value_here _ _ N), X. cbn [turn node_value] in *.
  replace (PI * (1 / 2 - val a0)) with (PI / 2 - PI * val a0) by field. rewrite cos_shift.
  split; trivial. split; [|exact B]. cbn. split; trivial. intros j [<-|[<-|[]]]; auto.
Qed.
Lemma cosine_sound g : cosine T K knows is_defined g = true -> holds S v g.
Proof.
  unfold cosine, holds, stands. destruct g as [r a b]. cbn [relation_of lhs rhs].
  destruct r; try discriminate.
  destruct (cosine_of T a); intros H; apply cosine_bound_sound in H; cbn [related]; tauto.
Qed.
End SoundCosines.
