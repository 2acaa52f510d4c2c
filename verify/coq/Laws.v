(* The rules on exponentials, logarithms, sines, cosines and inverse tangents: their ranges, and the
   identities between them. *)
From Coq Require Import Reals QArith Qreals ZArith List Lra Lia Bool FMapPositive.
From Verify Require Import Meaning Polynomials Terms Substitution Clearing Cleared Cosines.
Import ListNotations.
Open Scope R_scope.

Definition same_function (f g : elementary) : bool :=
  match f, g with
  | Exp, Exp | Log, Log | Sin, Sin | Atan, Atan => true
  | NthRoot m, NthRoot n => Pos.eqb m n
  | _, _ => false
  end.
Lemma same_function_sound f g : same_function f g = true -> f = g.
Proof.
  destruct f, g; try discriminate; trivial. cbn [same_function]. intros E. f_equal.
  now apply Pos.eqb_eq.
Qed.

(* What makes an identity true. *)
Inductive condition : Set :=
| Added (u v s : positive)  (* u + v = s *)
| Multiplied (u v s : positive)  (* u v = s *)
| Doubled (u v s : positive)  (* 2 (u + v) = s *)
| Same (u v : positive).

Section LawRules.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable knows : bool -> positive -> bool.
Variable is_defined : positive -> bool.
Notation clear_all := (each (clear T K knows is_defined (PM.empty positive) levels) nothing_cleared).

Definition is_number (i : positive) (q : Q) : bool :=
  match is_rational T i with Some r => Qeq_bool r q | None => false end.
Definition argument (f : elementary) (i : positive) : option positive :=
  match PM.find i T with
  | Some (NOf g a) => if same_function f g then Some a else None
  | _ => None
  end.
Definition is_of (f : elementary) (i : positive) : bool :=
  match argument f i with Some _ => true | None => false end.
Definition cosine_argument (i : positive) : option positive :=
  match PM.find i T with Some (NCos a) => Some a | _ => None end.

(* --- range --- *)

Definition is_circular (i : positive) : bool :=
  is_of Sin i || match cosine_of T i with Some _ => true | None => false end.
(* pi/2 *)
Definition is_quarter (i : positive) : bool :=
  match PM.find i T with
  | Some (NDiv a b) => match PM.find a T with Some NPi => is_number b 2 | _ => false end
  | _ => false
  end.
Definition is_opposite_quarter (i : positive) : bool :=
  match PM.find i T with Some (NNeg a) => is_quarter a | _ => false end.
Definition range (g : claim) : bool :=
  let (r, a, b) := g in
  match clear_all [a; b] with
  | None => false
  | Some _ =>
      match r with
      | Less =>
          is_number a 0 && is_of Exp b || is_opposite_quarter a && is_of Atan b ||
          is_of Atan a && is_quarter b
      | AtMost => is_number a (-1) && is_circular b || is_circular a && is_number b 1
      | _ => false
      end
  end.

(* --- law --- *)

Definition product (x y : quotient) : quotient := (times (fst x) (fst y), times (snd x) (snd y)).
Definition agree (m : clearing) (x y : quotient) : bool :=
  vanishes m (minus (times (fst x) (snd y)) (times (fst y) (snd x))).
Definition terms_of (c : condition) : list positive :=
  match c with Added u v s | Multiplied u v s | Doubled u v s => [u; v; s] | Same u v => [u; v] end.
Definition satisfied_by (c : condition) (m : clearing) (xs : list quotient) : bool :=
  match c, xs with
  | Added _ _ _, [x; y; z] => agree m (added plus x y) z
  | Multiplied _ _ _, [x; y; z] => agree m (product x y) z
  | Doubled _ _ _, [x; y; z] => agree m (product (number 2, one) (added plus x y)) z
  | Same _ _, [x; y] => agree m x y
  | _, _ => false
  end.
(* exp (log b), or log (exp b). *)
Definition is_inverse (a b : positive) : bool :=
  match PM.find a T with
  | Some (NOf f c) =>
      match f, PM.find c T with
      | Exp, Some (NOf Log d) | Log, Some (NOf Exp d) => Pos.eqb d b
      | _, _ => false
      end
  | _ => false
  end.
(* What makes two terms equal, by the law for such terms. *)
Definition condition_of (a b : positive) : option condition :=
  match PM.find a T, PM.find b T with
  | Some (NOf Exp s), Some (NMul c d) =>
      let* u := argument Exp c in let* v := argument Exp d in Some (Added u v s)
  | Some (NOf Log s), Some (NAdd c d) =>
      let* u := argument Log c in let* v := argument Log d in Some (Multiplied u v s)
  | Some (NOf Sin u), Some (NCos v) => let* s := find_node T K NPi in Some (Doubled u v s)
  | Some (NCos u), Some (NCosPi v) => let* s := find_node T K NPi in Some (Multiplied s v u)
  | Some (NOf Sin u), Some (NMul t c) =>
      let* w := argument Atan u in
      let* v := cosine_argument c in
      if Pos.eqb w t then Some (Same u v) else None
  | Some (NAdd c d), Some (NRational _ _) =>
      match PM.find c T, PM.find d T with
      | Some (NPow e m), Some (NPow f n) =>
          let* u := argument Sin e in
          let* v := cosine_argument f in
          if is_number b 1 && Pos.eqb m 2 && Pos.eqb n 2 then Some (Same u v) else None
      | _, _ => None
      end
  | _, _ => None
  end.
Definition law (g : claim) : bool :=
  let (r, a, b) := g in
  match r with
  | Equal =>
      if is_inverse a b then match clear_all [a; b] with Some _ => true | None => false end
      else
        match condition_of a b with
        | Some c =>
            match clear_all (a :: b :: terms_of c) with
            | Some (_ :: _ :: xs, m) => satisfied_by c m xs
            | _ => false
            end
        | None => false
        end
  | _ => false
  end.

End LawRules.

(* --- soundness -------------------------------------------------------------------------------- *)

Section SoundLaws.
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
Let value_of := value_is S T ready v.
Let defined_of := defined_is S T ready v.
Let cleared_of := each_cleared S T ready K v knows is_defined right_here.
Notation poly := (at_values val).

Lemma is_number_sound i q : is_number T i q = true -> val i = Q2R q.
Proof.
  unfold is_number. destruct (is_rational T i) as [r|] eqn:E; try discriminate. intros Q.
  apply (rational_sound S T ready v) in E. destruct E as [-> _].
  now apply Qeq_eqR, Qeq_bool_eq.
Qed.
Lemma argument_sound f i a : argument T f i = Some a ->
  val i = applied f (val a) /\ (def i -> def a /\ in_domain f (val a)).
Proof.
  unfold argument. destruct (PM.find i T) as [[]|] eqn:E; try discriminate.
  destruct (same_function f f0) eqn:F; try discriminate. apply same_function_sound in F. subst.
  injection 1 as ->. rewrite (value_of _ _ E), (defined_of _ _ E). cbn. intuition.
Qed.
Lemma is_of_sound f i : is_of T f i = true -> exists x, val i = applied f x.
Proof.
  unfold is_of. destruct (argument T f i) as [a|] eqn:A; try discriminate. intros _.
  apply argument_sound in A. destruct A. eauto.
Qed.
Lemma cosine_argument_sound i a : cosine_argument T i = Some a -> val i = cos (val a).
Proof.
  unfold cosine_argument. destruct (PM.find i T) as [[]|] eqn:E; try discriminate.
  injection 1 as ->. exact (value_of _ _ E).
Qed.

(* --- range --- *)

Lemma is_circular_sound i : is_circular T i = true -> -1 <= val i <= 1.
Proof.
  unfold is_circular. intros C. apply orb_prop in C. destruct C as [C|C].
  - apply is_of_sound in C. destruct C as [x ->]. cbn [applied]. pose proof (SIN_bound x). lra.
  - destruct (cosine_of T i) as [[k a]|] eqn:E; try discriminate.
    apply (cosine_of_sound S T ready v) in E. destruct E as [-> _].
    pose proof (COS_bound (turn k * val a)). lra.
Qed.
Lemma is_quarter_sound i : is_quarter T i = true -> val i = PI / 2.
Proof.
  unfold is_quarter. destruct (PM.find i T) as [[]|] eqn:E; try discriminate.
  destruct (PM.find a T) as [[]|] eqn:A; try discriminate. intros B. apply is_number_sound in B.
  rewrite (value_of _ _ E). cbn [node_value]. rewrite B, (value_of _ _ A). cbn [node_value].
  unfold Q2R. cbn. now rewrite Rinv_1, Rmult_1_r.
Qed.
Lemma range_sound g : range T K knows is_defined g = true -> holds S v g.
Proof.
  unfold range. destruct g as [r a b]. destruct (each _ _ _) as [[xs m]|] eqn:C; try discriminate.
  apply cleared_of in C. destruct C as [_ C]. inversion C as [|? ? ? ? (A & _) C1]; subst.
  inversion C1 as [|? ? ? ? (B & _) _]; subst. clear C C1. intros H.
  unfold holds, stands. cbn [relation_of lhs rhs]. split; [trivial|]. split; [trivial|].
  destruct r; try discriminate; cbn [related]; apply orb_prop in H.
  - destruct H as [H|H]; [apply orb_prop in H; destruct H as [H|H]|];
      apply andb_prop in H; destruct H as [X Y].
    + apply is_number_sound in X. apply is_of_sound in Y. destruct Y as [z ->]. rewrite X.
      replace (Q2R 0) with 0 by (unfold Q2R; cbn; ring). apply exp_pos.
    + apply is_of_sound in Y. destruct Y as [z ->]. cbn [applied].
      unfold is_opposite_quarter in X. destruct (PM.find a T) as [[]|] eqn:E; try discriminate.
      apply is_quarter_sound in X. rewrite (value_of _ _ E). cbn [node_value]. rewrite X.
      pose proof (atan_bound z). lra.
    + apply is_quarter_sound in Y. apply is_of_sound in X. destruct X as [z ->]. rewrite Y.
      apply atan_bound.
  - destruct H as [H|H]; apply andb_prop in H; destruct H as [X Y].
    + apply is_number_sound in X. apply is_circular_sound in Y. rewrite X.
      unfold Q2R. cbn. lra.
    + apply is_number_sound in Y. apply is_circular_sound in X. rewrite Y. unfold Q2R. cbn. lra.
Qed.

(* --- law --- *)

Definition condition_holds (c : condition) : Prop :=
  match c with
  | Added a b s => val a + val b = val s
  | Multiplied a b s => val a * val b = val s
  | Doubled a b s => 2 * (val a + val b) = val s
  | Same a b => val a = val b
  end.
Definition stands_for (x : quotient) (a : R) : Prop := 0 < poly (snd x) /\ a * poly (snd x) = poly (fst x).
Lemma agree_sound m x y a b : sound S v m -> stands_for x a -> stands_for y b ->
  agree m x y = true -> a = b.
Proof.
  intros M [P X] [Q Y]. unfold agree. intros W. apply (vanishes_sound S v) in W; trivial.
  rewrite minus_value, !times_value, <- X, <- Y in W.
  apply Rmult_eq_reg_r with (poly (snd x) * poly (snd y)).
  - lra.
  - apply Rgt_not_eq, Rmult_lt_0_compat; lra.
Qed.
Lemma product_stands x y a b : stands_for x a -> stands_for y b -> stands_for (product x y) (a * b).
Proof.
  intros [P X] [Q Y]. unfold stands_for, product. cbn [fst snd]. rewrite !times_value, <- X, <- Y.
  split; [now apply Rmult_lt_0_compat | ring].
Qed.
Lemma added_stands x y a b : stands_for x a -> stands_for y b -> stands_for (added plus x y) (a + b).
Proof.
  intros [P X] [Q Y]. apply (added_value S v Rplus); trivial; [apply plus_value | intros; ring].
Qed.
Lemma two_stands : stands_for (number 2, one) 2.
Proof.
  unfold stands_for. cbn [fst snd]. rewrite one_value, number_value. unfold Q2R. cbn. lra.
Qed.
Lemma satisfied_by_sound c m xs : sound S v m -> Forall2 (is_quotient S v) (terms_of c) xs ->
  satisfied_by c m xs = true -> condition_holds c.
Proof.
  intros M Q E.
  assert (Q' : Forall2 (fun i x => stands_for x (val i)) (terms_of c) xs)
    by (clear E; induction Q as [|i x l ys [_ I]]; constructor; trivial). clear Q.
  destruct c; cbn [terms_of] in Q';
    repeat match goal with
    | H : Forall2 _ [] _ |- _ => inversion H; subst; clear H
    | H : Forall2 _ (_ :: _) _ |- _ => inversion H; subst; clear H
    end; cbn [satisfied_by condition_holds] in *;
    eapply agree_sound; eauto using product_stands, added_stands, two_stands.
Qed.
Lemma is_inverse_sound a b : is_inverse T a b = true -> def a -> val a = val b.
Proof.
  unfold is_inverse. destruct (PM.find a T) as [[]|] eqn:A; try discriminate.
  destruct f; try discriminate; destruct (PM.find a0 T) as [[]|] eqn:B; try discriminate;
    destruct f; try discriminate; intros E D; apply Pos.eqb_eq in E; subst;
    rewrite (value_of _ _ A), (defined_of _ _ A) in *; cbn [node_value applied subterms proviso In] in *;
    destruct D as [D _]; specialize (D a0 (or_introl eq_refl)); rewrite (value_of _ _ B);
    cbn [node_value applied].
  - rewrite (defined_of _ _ B) in D. apply exp_ln, D.
  - apply ln_exp.
Qed.
Lemma sine_of_atan t : sin (atan t) = t * cos (atan t).
Proof.
  pose proof (atan_bound t). pose proof (cos_gt_0 (atan t)) as P.
  rewrite <- (tan_atan t) at 2. unfold tan. field. apply Rgt_not_eq, P; lra.
Qed.
Lemma condition_of_sound a b c : condition_of T K a b = Some c -> def a -> def b ->
  condition_holds c -> val a = val b.
Proof.
  unfold condition_of. destruct (PM.find a T) as [n|] eqn:A; try discriminate.
  destruct (PM.find b T) as [m|] eqn:B; [|destruct n; try destruct f; discriminate].
  rewrite (value_of _ _ A), (value_of _ _ B), (defined_of _ _ B).
  destruct n; try discriminate; [| |destruct f; try discriminate]; destruct m; try discriminate;
    cbn [node_value applied subterms proviso In]; intros E Da [Db _].
  - (* sin^2 + cos^2 *)
    destruct (PM.find a0 T) as [[]|] eqn:X; try discriminate.
    destruct (PM.find b0 T) as [[]|] eqn:Y; try discriminate.
    bind E u U. bind E w W. destruct (_ && _) eqn:Q; try discriminate. injection E as <-.
    apply andb_prop in Q. destruct Q as [Q N2]. apply andb_prop in Q. destruct Q as [Q N1].
    apply Pos.eqb_eq in N1, N2. subst. apply is_number_sound in Q.
    rewrite (value_of _ _ B) in Q. cbn [node_value] in Q.
    apply argument_sound in U. apply cosine_argument_sound in W. destruct U as [U _].
    rewrite Q, (value_of _ _ X), (value_of _ _ Y). cbn [node_value condition_holds]. rewrite U, W.
    intros ->. cbn [applied]. pose proof (sin2_cos2 (val w)) as P. unfold Rsqr in P.
    replace (Pos.to_nat 2) with 2%nat by reflexivity. unfold Q2R. cbn. lra.
  - bind E s P. injection E as <-. apply find_node_sound in P. cbn [condition_holds].
    rewrite (value_of _ _ P). cbn [node_value]. now intros ->.
  - bind E u U. bind E w W. injection E as <-. apply argument_sound in U, W.
    destruct U as [-> _], W as [-> _]. cbn [condition_holds applied]. intros <-. apply exp_plus.
  - bind E u U. bind E w W. injection E as <-. apply argument_sound in U, W.
    destruct U as [-> U], W as [-> W]. cbn [condition_holds applied in_domain] in *. intros <-.
    apply ln_mult; [apply U | apply W]; auto.
  - bind E u U. bind E w W. destruct (Pos.eqb_spec u a1); try discriminate. injection E as <-.
    subst. apply argument_sound in U. apply cosine_argument_sound in W. destruct U as [U _].
    rewrite W. cbn [condition_holds applied] in *. intros <-. rewrite U. apply sine_of_atan.
  - bind E s P. injection E as <-. apply find_node_sound in P. cbn [condition_holds].
    rewrite (value_of _ _ P). cbn [node_value]. intros Q.
    rewrite <- cos_shift. f_equal. lra.
Qed.
Lemma law_sound g : law T K knows is_defined g = true -> holds S v g.
Proof.
  unfold law. destruct g as [r a b]. destruct r; try discriminate.
  unfold holds, stands. cbn [relation_of lhs rhs related].
  destruct (is_inverse T a b) eqn:I.
  - destruct (each _ _ _) as [[xs m]|] eqn:C; try discriminate. intros _.
    apply cleared_of in C. destruct C as [_ C]. inversion C as [|? ? ? ? (A & _) C1]; subst.
    inversion C1 as [|? ? ? ? (B & _) _]; subst. split; [trivial|]. split; [trivial|].
    now apply is_inverse_sound.
  - destruct (condition_of T K a b) as [c|] eqn:E; try discriminate.
    destruct (each _ _ _) as [[xs m]|] eqn:C; try discriminate. intros W.
    apply cleared_of in C. destruct C as [M C].
    inversion C as [|? ? ? ? (A & _) C1]; subst. inversion C1 as [|? ? ? ? (B & _) C2]; subst.
    split; [trivial|]. split; [trivial|]. apply (condition_of_sound _ _ _ E); trivial.
    now apply satisfied_by_sound in W.
Qed.

End SoundLaws.
