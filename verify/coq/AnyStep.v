(* One collision of ball 0, whatever the constants are: if the inner products of a scene are the
   numbers of a state, and a few inequalities hold of these, then the next collision is that of ball 0
   with the other ball, and the scene after it has the numbers of the next state. The certificates of
   the step and of the sharper theorem both prove these inequalities, each from its own givens. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Vectors Motion.
Open Scope R_scope.

(* --- states ----------------------------------------------------------------------------------- *)

Record numbers := Numbers { y : R; eta_s : R; C : R; a : R; b : R; A : R; B : R; w : R; d : R }.

(* p and q are the directions from ball 0 to the ball that just met it and to the one that it meets
   next; s and c are their relative velocities. *)
Record products (m : numbers) (dimension : nat) (p q s c : vector) : Prop := {
  of_p : dot dimension p p = 1; of_q : dot dimension q q = 1;
  of_p_q : dot dimension p q = - C m;
  of_p_s : dot dimension p s = eta_s m; of_q_c : dot dimension q c = - y m;
  of_p_c : dot dimension p c = a m; of_q_s : dot dimension q s = b m;
  of_s_s : dot dimension s s = B m; of_c_c : dot dimension c c = A m; of_s_c : dot dimension s c = w m
}.
(* Ball i has just met ball 0, and j is next. *)
Definition has (m : numbers) (dimension : nat) (x : scene) (i j : ball) : Prop :=
  exists q, to x B0 j = scaled (1 + d m) q /\
    products m dimension (to x B0 i) q (relative x B0 i) (relative x B0 j).

(* --- the step --------------------------------------------------------------------------------- *)

Section AnyStep.
Variables share r : R.  (* of the speed of impact the third ball gets a share *)
Variable m : numbers.
Variable t : R.  (* until the collision *)
Notation e := (1 + d m).

(* The rate at the collision, and the distance of the other ball there. *)
Definition impact : R := e * - y m + t * A m.
Definition reach : R := sqrt (1 + t * eta_s m + t * eta_s m + t * t * B m).
Definition after_sharing : numbers :=
  let half := - (share * impact) in
  let all := - ((1 + r) * impact) in
  Numbers
    (- (1 / reach * eta_s m + t / reach * B m + half * e * (1 / reach) * - C m
      + half * e * (t / reach) * b m + half * t * (1 / reach) * a m + half * t * (t / reach) * w m))
    (all * e * e + all * e * t * - y m + (1 + all * t) * e * - y m + (1 + all * t) * t * A m)
    (- (e * (1 / reach) * - C m + e * (t / reach) * b m + t * (1 / reach) * a m
      + t * (t / reach) * w m))
    (e * b m + e * (half * e) + e * (half * t) * - y m + t * w m + t * (half * e) * - y m
      + t * (half * t) * A m)
    (1 / reach * (all * e) * - C m + 1 / reach * (1 + all * t) * a m + t / reach * (all * e) * b m
      + t / reach * (1 + all * t) * w m)
    (B m + 2 * half * (e * b m + t * w m)
      + half * half * (e * e + 2 * e * t * - y m + t * t * A m))
    (all * e * (all * e) + all * e * (1 + all * t) * - y m + (1 + all * t) * (all * e) * - y m
      + (1 + all * t) * (1 + all * t) * A m)
    (all * e * b m + all * e * (half * e) + all * e * (half * t) * - y m + (1 + all * t) * w m
      + (1 + all * t) * (half * e) * - y m + (1 + all * t) * (half * t) * A m)
    (reach - 1).

(* The outer pair is apart as long as it is told. *)
Record certified_if (outer : R -> Prop) : Prop := {
  takes_time : 0 < t; recedes : 0 < eta_s m; far : 0 < e; far_after : 0 < reach;
  touching : e * e + e * t * - y m + t * e * - y m + t * t * A m = 1;
  approaching : impact < 0;
  colliding_apart : forall u, 0 <= u < t ->
    1 < e * e + e * u * - y m + u * e * - y m + u * u * A m;
  spectator_apart : forall u, 0 <= u <= t ->
    1 + 2 * u * eta_s m <= 1 + u * eta_s m + u * eta_s m + u * u * B m;
  outer_apart : forall u, 0 <= u <= t -> outer u
}.

Variable D : nat.  (* the dimension *)
(* Inner products of combinations of p, q, s and c, in the numbers of the state. *)
Ltac in_numbers :=
  repeat (rewrite ?dot_linear, ?dot_linear_right, ?dot_scaled, ?dot_scaled_right);
  match goal with
  | PQ : dot D ?p ?q = - C m, SC : dot D ?s ?c = w m |- _ =>
      rewrite ?(dot_symmetric D q p), ?(dot_symmetric D s p), ?(dot_symmetric D c p),
        ?(dot_symmetric D s q), ?(dot_symmetric D c q), ?(dot_symmetric D c s)
  end;
  repeat match goal with E : dot D _ _ = _ |- _ => progress rewrite ?E; clear E end.

Section StepVectors.
Variables p q s c : vector.
Hypothesis seen : products m D p q s c.
(* The squared distances after a time, and the rate of the pair that is next. *)
Lemma square_behind u : dot D (combined 1 p u s) (combined 1 p u s) = 1 + u * eta_s m + u * eta_s m + u * u * B m.
Proof. destruct seen as [P Q PQ PS QC PC QS SS CC SC]. in_numbers. ring. Qed.
Lemma square_ahead u : dot D (combined e q u c) (combined e q u c) = e * e + e * u * - y m + u * e * - y m + u * u * A m.
Proof. destruct seen as [P Q PQ PS QC PC QS SS CC SC]. in_numbers. ring. Qed.
Lemma product_between u : dot D (combined 1 p u s) (combined e q u c) = e * - C m + u * (a m + e * b m) + u * u * w m.
Proof. destruct seen as [P Q PQ PS QC PC QS SS CC SC]. in_numbers. ring. Qed.
Lemma rate_ahead : dot D (combined e q t c) c = impact.
Proof. destruct seen as [P Q PQ PS QC PC QS SS CC SC]. in_numbers. unfold impact. ring. Qed.
(* After the collision the two exchange their roles. *)
Lemma products_next outer : certified_if outer -> let omega := combined e q t c in
  products after_sharing D omega (combined (1 / reach) p (t / reach) s)
    (combined 1 c (- ((1 + r) * impact)) omega) (combined 1 s (- (share * impact)) omega).
Proof.
  intros certified. cbn zeta. pose proof (far_after _ certified) as F. pose proof (touching _ certified) as T.
  assert (Root : reach * reach = 1 + t * eta_s m + t * eta_s m + t * t * B m).
  { unfold reach. apply sqrt_sqrt. rewrite <- square_behind. apply dot_self. }
  destruct seen as [P Q PQ PS QC PC QS SS CC SC].
  set (root := reach) in *. set (kappa := impact).
  split; in_numbers; unfold after_sharing; cbn [y eta_s C a b A B w d]; fold root kappa.
  - etransitivity; [|exact T]. ring.
  - transitivity ((root * root) / (root * root)); [rewrite Root at 1 | ]; field; lra.
  - ring.
  - ring.
  - ring.
  - ring.
  - ring.
  - ring.
  - ring.
  - ring.
Qed.
End StepVectors.
End AnyStep.

(* --- equal balls of diameter 1 ------------------------------------------------------------------ *)

Section EqualBalls.
Variable r : R.
Variable m : numbers.
Variable t : R.
Notation e := (1 + d m).
Definition after_step : numbers := after_sharing ((1 + r) / 2) r m t.
Definition outer_of_equal (u : R) : Prop :=
  1 < 1 - 2 * e * - C m + e ^ 2 + 2 * u * (eta_s m - a m - e * b m + e * - y m)
    + u ^ 2 * (A m + B m - 2 * w m).
Definition step_certified : Prop := certified_if m t outer_of_equal.
Hypothesis certified : step_certified.

Variable D : nat.
Variable x : scene.
Variable i j : ball.
Hypothesis others : i <> B0 /\ j <> B0 /\ i <> j.
Hypothesis shown_by : has m D x i j.

(* The squared distances after a time. *)
Lemma squares u :
  square D (later u x) B0 i = 1 + u * eta_s m + u * eta_s m + u * u * B m /\
  square D (later u x) B0 j = e * e + e * u * - y m + u * e * - y m + u * u * A m /\
  square D (later u x) i j =
    1 - 2 * e * - C m + e ^ 2 + 2 * u * (eta_s m - a m - e * b m + e * - y m)
      + u ^ 2 * (A m + B m - 2 * w m).
Proof.
  destruct shown_by as (q & X & G). pose proof (square_behind m D _ _ _ _ G u) as S1.
  pose proof (square_ahead m D _ _ _ _ G u) as S2. pose proof (product_between m D _ _ _ _ G u) as S3.
  assert (E : to (later u x) B0 j = combined e q u (relative x B0 j)).
  { rewrite to_later, X. apply same_vector. intros k. unfold combined, scaled. ring. }
  unfold square. rewrite (to_outer _ i j), E, to_later. split; [exact S1|]. split; [exact S2|].
  rewrite square_of_combined, S1, S2, S3. ring.
Qed.

Lemma seen_at_impact : exists q, products m D (to x B0 i) q (relative x B0 i) (relative x B0 j) /\
  to (later t x) B0 j = combined e q t (relative x B0 j) /\ rate D (later t x) B0 j = impact m t.
Proof.
  destruct shown_by as (q & X & G). exists q. split; [exact G|].
  assert (E : to (later t x) B0 j = combined e q t (relative x B0 j)).
  { rewrite to_later, X. apply same_vector. intros k. unfold combined, scaled. ring. }
  split; [exact E|]. unfold rate. rewrite E. exact (rate_ahead m t D _ _ _ _ G).
Qed.

Theorem meets : first_to_meet D x B0 j t.
Proof.
  destruct others as (Ni & Nj & Nij). pose proof (takes_time _ _ _ certified) as F.
  pose proof (recedes _ _ _ certified) as E.
  assert (Pairs : forall k l, k <> l -> (k = B0 /\ l = i) \/ (k = i /\ l = B0) \/ (k = B0 /\ l = j) \/
    (k = j /\ l = B0) \/ (k = i /\ l = j) \/ (k = j /\ l = i)).
  { intros k l. destruct i, j, k, l; tauto || easy. }
  assert (Away : forall u, 0 < u <= t ->
    1 < distance D (later u x) B0 i /\ 1 < distance D (later u x) i j).
  { intros u U. destruct (squares u) as (Qi & _ & Qo). split; apply distance_above.
    - rewrite Qi. pose proof (spectator_apart _ _ _ certified u ltac:(lra)) as S.
      assert (0 < u * eta_s m) by (apply Rmult_lt_0_compat; lra). lra.
    - rewrite Qo. apply (outer_apart _ _ _ certified). lra. }
  split; trivial.
  - intros u k l U N. destruct (Away u ltac:(lra)) as [Ai Ao]. destruct (squares u) as (_ & Qj & _).
    assert (Aj : 1 < distance D (later u x) B0 j)
      by (apply distance_above; rewrite Qj; apply (colliding_apart _ _ _ certified); lra).
    destruct (Pairs k l N) as [[-> ->]|[[-> ->]|[[-> ->]|[[-> ->]|[[-> ->]|[-> ->]]]]]]; trivial;
      now rewrite distance_symmetric.
  - apply distance_one. destruct (squares t) as (_ & Qj & _). rewrite Qj. exact (touching _ _ _ certified).
  - destruct seen_at_impact as (q & _ & _ & ->). exact (approaching _ _ _ certified).
  - intros k K0 Kj. destruct (Away t ltac:(lra)) as [Ai Ao].
    assert (k = i) by (destruct i, j, k; easy). subst k. split; trivial. now rewrite distance_symmetric.
Qed.
Theorem shows_next : has after_step D (collided D r B0 j (later t x)) j i.
Proof.
  destruct others as (Ni & Nj & Nij). pose proof (far_after _ _ _ certified) as F.
  destruct seen_at_impact as (q & G & Omega & Rate).
  exists (combined (1 / reach m t) (to x B0 i) (t / reach m t) (relative x B0 i)).
  rewrite !to_collided, Omega, (relative_collided _ _ _ _ Nj),
    (relative_collided_other _ _ _ _ _ Ni Nij), Rate, Omega. split.
  - replace (1 + d after_step) with (reach m t) by (unfold after_step, after_sharing; cbn [d]; ring).
    rewrite to_later. apply same_vector. intros k. unfold combined, scaled. field. lra.
  - exact (products_next _ _ _ _ _ _ _ _ _ G _ certified).
Qed.
End EqualBalls.

Lemma cosine_of m n x i j : has m n x i j -> i <> B0 /\ j <> B0 /\ i <> j -> 0 < 1 + d m ->
  minus_cosine n x = C m.
Proof.
  intros (q & X & [P Q PQ _ _ _ _ _ _ _]) (Ni & Nj & N) F. set (e := 1 + d m) in *.
  assert (U : distance n x B0 i = 1) by (apply distance_one; exact P).
  assert (W : distance n x B0 j = e).
  { unfold distance. rewrite X, dot_scaled, dot_scaled_right, Q.
    replace (e * (e * 1)) with (e * e) by ring. apply sqrt_square. lra. }
  assert (K : dot n (to x B0 i) (to x B0 j) = - (e * C m)).
  { rewrite X, dot_scaled_right, PQ. ring. }
  assert (M : dot n (to x B0 B1) (to x B0 B2) = - (e * C m) /\
    distance n x B0 B1 * distance n x B0 B2 = e).
  { destruct i, j; try easy; rewrite U, W; [|rewrite dot_symmetric]; split; trivial; ring. }
  unfold minus_cosine. destruct M as [-> ->]. field. lra.
Qed.
