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
Variable r : R.
Variable m : numbers.
Variable t : R.  (* until the collision *)
Notation e := (1 + d m).

(* The rate at the collision, and the distance of the other ball there. *)
Definition impact : R := e * - y m + t * A m.
Definition reach : R := sqrt (1 + t * eta_s m + t * eta_s m + t * t * B m).
Definition after_step : numbers :=
  let half := - ((1 + r) / 2 * impact) in
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

Record step_certified : Prop := {
  takes_time : 0 < t; recedes : 0 < eta_s m; far : 0 < e; far_after : 0 < reach;
  touching : e * e + e * t * - y m + t * e * - y m + t * t * A m = 1;
  approaching : impact < 0;
  colliding_apart : forall u, 0 <= u < t ->
    1 < e * e + e * u * - y m + u * e * - y m + u * u * A m;
  spectator_apart : forall u, 0 <= u <= t ->
    1 + 2 * u * eta_s m <= 1 + u * eta_s m + u * eta_s m + u * u * B m;
  outer_apart : forall u, 0 <= u <= t ->
    1 < 1 - 2 * e * - C m + e ^ 2 + 2 * u * (eta_s m - a m - e * b m + e * - y m)
      + u ^ 2 * (A m + B m - 2 * w m)
}.
Hypothesis certified : step_certified.

Variable D : nat.  (* the dimension *)
Variable x : scene.
Variable i j : ball.
Hypothesis others : i <> B0 /\ j <> B0 /\ i <> j.
Hypothesis shown_by : has m D x i j.

(* Inner products of combinations of p, q, s and c, in the numbers of the state. *)
Ltac in_numbers :=
  repeat (rewrite ?dot_linear, ?dot_linear_right, ?dot_scaled, ?dot_scaled_right);
  match goal with
  | PQ : dot D ?p ?q = - C m, SC : dot D ?s ?c = w m |- _ =>
      rewrite ?(dot_symmetric D q p), ?(dot_symmetric D s p), ?(dot_symmetric D c p),
        ?(dot_symmetric D s q), ?(dot_symmetric D c q), ?(dot_symmetric D c s)
  end;
  repeat match goal with E : dot D _ _ = _ |- _ => progress rewrite ?E; clear E end.

(* The squared distances after a time. *)
Lemma squares u :
  square D (later u x) B0 i = 1 + u * eta_s m + u * eta_s m + u * u * B m /\
  square D (later u x) B0 j = e * e + e * u * - y m + u * e * - y m + u * u * A m /\
  square D (later u x) i j =
    1 - 2 * e * - C m + e ^ 2 + 2 * u * (eta_s m - a m - e * b m + e * - y m)
      + u ^ 2 * (A m + B m - 2 * w m).
Proof.
  destruct shown_by as (q & X & [P Q PQ PS QC PC QS SS CC SC]). unfold square.
  rewrite (to_outer _ i j), !to_later, X. in_numbers. repeat split; ring.
Qed.

Theorem meets : first_to_meet D x B0 j t.
Proof.
  destruct others as (Ni & Nj & Nij). pose proof (takes_time certified) as F.
  pose proof (recedes certified) as E.
  assert (Pairs : forall k l, k <> l -> (k = B0 /\ l = i) \/ (k = i /\ l = B0) \/ (k = B0 /\ l = j) \/
    (k = j /\ l = B0) \/ (k = i /\ l = j) \/ (k = j /\ l = i)).
  { intros k l. destruct i, j, k, l; tauto || easy. }
  assert (Away : forall u, 0 < u <= t ->
    1 < distance D (later u x) B0 i /\ 1 < distance D (later u x) i j).
  { intros u U. destruct (squares u) as (Qi & _ & Qo). split; apply distance_above.
    - rewrite Qi. pose proof (spectator_apart certified u ltac:(lra)) as S.
      assert (0 < u * eta_s m) by (apply Rmult_lt_0_compat; lra). lra.
    - rewrite Qo. apply (outer_apart certified). lra. }
  split; trivial.
  - intros u k l U N. destruct (Away u ltac:(lra)) as [Ai Ao]. destruct (squares u) as (_ & Qj & _).
    assert (Aj : 1 < distance D (later u x) B0 j)
      by (apply distance_above; rewrite Qj; apply (colliding_apart certified); lra).
    destruct (Pairs k l N) as [[-> ->]|[[-> ->]|[[-> ->]|[[-> ->]|[[-> ->]|[-> ->]]]]]]; trivial;
      now rewrite distance_symmetric.
  - apply distance_one. destruct (squares t) as (_ & Qj & _). rewrite Qj. exact (touching certified).
  - replace (rate D (later t x) B0 j) with impact; [exact (approaching certified)|].
    destruct shown_by as (q & X & [P Q PQ PS QC PC QS SS CC SC]).
    unfold rate. rewrite to_later, relative_later, X. in_numbers. unfold impact. ring.
  - intros k K0 Kj. destruct (Away t ltac:(lra)) as [Ai Ao].
    assert (k = i) by (destruct i, j, k; easy). subst k. split; trivial. now rewrite distance_symmetric.
Qed.
Theorem shows_next : has after_step D (collided D r B0 j (later t x)) j i.
Proof.
  destruct others as (Ni & Nj & Nij). pose proof (far_after certified) as F.
  destruct shown_by as (q & X & [P Q PQ PS QC PC QS SS CC SC]).
  set (p := to x B0 i) in *. set (s := relative x B0 i) in *. set (c := relative x B0 j) in *.
  set (omega := combined e q t c).
  assert (Omega : to (later t x) B0 j = omega).
  { rewrite to_later, X. fold c. apply same_vector. intros k. unfold omega, combined, scaled. ring. }
  assert (Rate : rate D (later t x) B0 j = impact).
  { unfold rate. rewrite Omega. change (relative (later t x) B0 j) with c. unfold omega.
    in_numbers. unfold impact. ring. }
  assert (Root : reach * reach = 1 + t * eta_s m + t * eta_s m + t * t * B m).
  { unfold reach. apply sqrt_sqrt.
    destruct (squares t) as (E & _). rewrite <- E. apply dot_self. }
  exists (combined (1 / reach) p (t / reach) s).
  rewrite !to_collided, Omega, (relative_collided _ _ _ _ Nj),
    (relative_collided_other _ _ _ _ _ Ni Nij), Rate, Omega.
  change (relative (later t x) B0 j) with c. change (relative (later t x) B0 i) with s.
  pose proof (touching certified) as T. set (root := reach) in *. set (kappa := impact).
  split.
  - replace (1 + d after_step) with root by (unfold after_step; cbn [d]; fold root; ring).
    rewrite to_later. fold p s. apply same_vector. intros k. unfold combined, scaled. field. lra.
  - split; unfold omega; in_numbers; unfold after_step; cbn [y eta_s C a b A B w d];
      fold root kappa.
    + etransitivity; [|exact T]. ring.
    + transitivity ((root * root) / (root * root)); [rewrite Root at 1 | ]; field; lra.
    + ring.
    + ring.
    + ring.
    + ring.
    + ring.
    + ring.
    + ring.
    + ring.
Qed.
End AnyStep.

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
