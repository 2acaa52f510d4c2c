(* One collision of ball o, whatever the constants are: if the inner products of a scene are the numbers
   of a state, in units of the distances of contact, and a few inequalities hold of these, then the next
   collision is that of o with the other ball, and the scene after it has the numbers of the next state.
   The certificates of the step, of the sharper theorem and of the collapse of any three balls prove these
   inequalities, each from its own givens. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Vectors Motion Classification Contacts Line Bounces ThreeBalls.
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

Definition in_contact : Prop := e * e + e * t * - y m + t * e * - y m + t * t * A m = 1.
(* The outer pair is apart as long as it is told. *)
Record certified_if (outer : R -> Prop) : Prop := {
  takes_time : 0 < t; recedes : 0 < eta_s m; far : 0 < e; far_after : 0 < reach;
  touching : in_contact;
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
Lemma products_next : 0 < reach -> in_contact -> let omega := combined e q t c in
  products after_sharing D omega (combined (1 / reach) p (t / reach) s)
    (combined 1 c (- ((1 + r) * impact)) omega) (combined 1 s (- (share * impact)) omega).
Proof.
  intros F T. unfold in_contact in T. cbn zeta. assert (Root : reach * reach = 1 + t * eta_s m + t * eta_s m + t * t * B m).
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

(* --- balls of any masses and radii ---------------------------------------------------------------- *)

Section BallsFlight.
Variable D : nat.
Variables mass radius : ball -> R.
Variable r : R.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis round : forall b, 0 < radius b.

Variables o i j : ball.  (* i has just met o, and j is next *)
Hypothesis distinct : distinct_balls o i j.
Notation si := (radius o + radius i).
Notation sj := (radius o + radius j).

(* In units of the distances of contact, the scene has these numbers. *)
Definition seen (m : numbers) (x : scene) (i j : ball) : Prop := exists p q s c,
  to x o i = scaled (radius o + radius i) p /\ relative x o i = scaled (radius o + radius i) s /\
  to x o j = scaled ((radius o + radius j) * (1 + d m)) q /\ relative x o j = scaled (radius o + radius j) c /\
  products m D p q s c.
Lemma cosine_seen m x : seen m x i j -> 0 < 1 + d m -> minus_cosine_at D x o i j = C m.
Proof.
  intros (p & q & s & c & X1 & _ & X2 & _ & [P Q PQ _ _ _ _ _ _ _]) F. unfold minus_cosine_at.
  pose proof (round o). pose proof (round i). pose proof (round j).
  assert (0 < sj * (1 + d m)) by (apply Rmult_lt_0_compat; lra).
  assert (E1 : distance D x o i = si).
  { apply as_far; [lra|]. unfold square. rewrite X1, dot_scaled, dot_scaled_right, P. ring. }
  assert (E2 : distance D x o j = sj * (1 + d m)).
  { apply as_far; [lra|]. unfold square. rewrite X2, dot_scaled, dot_scaled_right, Q. ring. }
  rewrite E1, E2, X1, X2, dot_scaled, dot_scaled_right, PQ. field. repeat split; lra.
Qed.

Variable m : numbers.
Variable t : R.
Definition outer_of_balls (u : R) : Prop := (radius i + radius j) ^ 2 <
  si ^ 2 * (1 + u * eta_s m + u * eta_s m + u * u * B m)
  - 2 * si * sj * ((1 + d m) * - C m + u * (a m + (1 + d m) * b m) + u * u * w m)
  + sj ^ 2 * ((1 + d m) * (1 + d m) + (1 + d m) * u * - y m + u * (1 + d m) * - y m + u * u * A m).
Hypothesis certified : certified_if m t outer_of_balls.
Variable x : scene.
Hypothesis shown_by : seen m x i j.

Lemma squares_of_balls u :
  square D (later u x) o i = si ^ 2 * (1 + u * eta_s m + u * eta_s m + u * u * B m) /\
  square D (later u x) o j = sj ^ 2 * ((1 + d m) * (1 + d m) + (1 + d m) * u * - y m + u * (1 + d m) * - y m + u * u * A m) /\
  square D (later u x) i j =
    si ^ 2 * (1 + u * eta_s m + u * eta_s m + u * u * B m)
    - 2 * si * sj * ((1 + d m) * - C m + u * (a m + (1 + d m) * b m) + u * u * w m)
    + sj ^ 2 * ((1 + d m) * (1 + d m) + (1 + d m) * u * - y m + u * (1 + d m) * - y m + u * u * A m).
Proof.
  destruct shown_by as (p & q & s & c & X1 & X2 & X3 & X4 & G).
  pose proof (square_behind m D _ _ _ _ G u) as S1. pose proof (square_ahead m D _ _ _ _ G u) as S2.
  pose proof (product_between m D _ _ _ _ G u) as S3.
  assert (E1 : to (later u x) o i = scaled si (combined 1 p u s)).
  { rewrite to_later, X1, X2. apply same_vector. intros n. unfold combined, scaled. ring. }
  assert (E2 : to (later u x) o j = scaled sj (combined (1 + d m) q u c)).
  { rewrite to_later, X3, X4. apply same_vector. intros n. unfold combined, scaled. ring. }
  assert (E3 : to (later u x) i j = combined (- si) (combined 1 p u s) sj (combined (1 + d m) q u c)).
  { replace (to (later u x) i j) with (combined (-1) (to (later u x) o i) 1 (to (later u x) o j))
      by (apply same_vector; intros n; unfold combined, to; ring).
    rewrite E1, E2. apply same_vector. intros n. unfold combined, scaled. ring. }
  unfold square. rewrite E1, E2, E3. split; [|split].
  - rewrite dot_scaled, dot_scaled_right, S1. ring.
  - rewrite dot_scaled, dot_scaled_right, S2. ring.
  - rewrite square_of_combined, S1, S2, S3. ring.
Qed.
Lemma impact_of_balls : exists p q s c, to x o i = scaled si p /\ relative x o i = scaled si s /\
  relative x o j = scaled sj c /\ products m D p q s c /\
  to (later t x) o j = scaled sj (combined (1 + d m) q t c) /\
  rate D (later t x) o j = sj ^ 2 * impact m t.
Proof.
  destruct shown_by as (p & q & s & c & X1 & X2 & X3 & X4 & G). exists p, q, s, c.
  assert (E2 : to (later t x) o j = scaled sj (combined (1 + d m) q t c)).
  { rewrite to_later, X3, X4. apply same_vector. intros n. unfold combined, scaled. ring. }
  repeat (split; [assumption|]). unfold rate. rewrite E2, relative_later, X4, dot_scaled, dot_scaled_right,
    (rate_ahead m t D _ _ _ _ G). ring.
Qed.

(* The next scene if they are in contact then, whatever happens before. *)
Theorem contact_after : 0 < reach m t -> in_contact m t ->
  seen (after_sharing (share_of mass radius (fun _ => r) o j i) r m t) (bounced D mass r o j (later t x)) j i.
Proof.
  pose proof (round o). pose proof (round i). pose proof (round j). pose proof (heavy o). pose proof (heavy j).
  intros F T. destruct distinct as (N1 & N2 & N3).
  destruct impact_of_balls as (p & q & s & c & X1 & X2 & X4 & G & Omega & Rate).
  assert (Far : distance D (later t x) o j = sj).
  { destruct (squares_of_balls t) as (_ & Q & _). apply as_far; [lra|]. rewrite Q, T. ring. }
  set (kappa := impact m t) in *. set (share := share_of mass radius (fun _ => r) o j i).
  exists (combined (1 + d m) q t c), (combined (1 / reach m t) p (t / reach m t) s),
    (combined 1 c (- ((1 + r) * kappa)) (combined (1 + d m) q t c)),
    (combined 1 s (- (share * kappa)) (combined (1 + d m) q t c)).
  split; [exact Omega|]. split; [|split; [|split]].
  - apply same_vector. intros n. transitivity (relative x o j n -
      (1 + r) * rate D (later t x) o j / distance D (later t x) o j ^ 2 * to (later t x) o j n).
    + unfold relative, bounced. cbn [velocity]. rewrite !same_true, (same_false j o) by congruence.
      cbn [later velocity]. rewrite Far. field. split; lra.
    + rewrite Far, Rate, Omega, X4. unfold scaled, combined. field. lra.
  - replace (1 + d (after_sharing share r m t)) with (reach m t) by (unfold after_sharing; cbn [d]; ring).
    change (to (bounced D mass r o j (later t x)) o i) with (to (later t x) o i). rewrite to_later, X1, X2.
    apply same_vector. intros n. unfold combined, scaled. field. lra.
  - apply same_vector. intros n. transitivity (relative x o i n - mass j *
      ((1 + r) * rate D (later t x) o j / distance D (later t x) o j ^ 2 / (mass o + mass j)) * to (later t x) o j n).
    + unfold relative, bounced. cbn [velocity]. rewrite !same_true, (same_false i o), (same_false i j) by congruence.
      cbn [later velocity]. ring.
    + rewrite Far, Rate, Omega, X2. unfold scaled, combined, share, share_of, reach_of. field. repeat split; lra.
  - exact (products_next share r m t D _ _ _ _ G F T).
Qed.

Theorem balls_meet : meets_next D radius x o j t.
Proof.
  pose proof (round o). pose proof (round i). pose proof (round j).
  pose proof (takes_time _ _ _ certified) as F. pose proof (recedes _ _ _ certified) as E.
  assert (PI : 0 < si ^ 2) by (apply pow_lt; lra). assert (PJ : 0 < sj ^ 2) by (apply pow_lt; lra).
  assert (Ai : forall u, 0 < u <= t -> si < distance D (later u x) o i).
  { intros u U. destruct (squares_of_balls u) as (Q & _). apply farther; [lra|]. rewrite Q.
    pose proof (spectator_apart _ _ _ certified u ltac:(lra)) as S.
    assert (0 < u * eta_s m) by (apply Rmult_lt_0_compat; lra).
    rewrite <- (Rmult_1_r (si ^ 2)) at 1. apply Rmult_lt_compat_l; lra. }
  assert (Ao : forall u, 0 < u <= t -> radius i + radius j < distance D (later u x) i j).
  { intros u U. destruct (squares_of_balls u) as (_ & _ & Q). apply farther; [lra|]. rewrite Q.
    apply (outer_apart _ _ _ certified). lra. }
  split; [exact F|]. split; [|split; [|split]].
  - intros u k l U N. revert k l N. apply (any_of_three _ o i j distinct).
    + intros k l B. rewrite distance_symmetric, Rplus_comm. exact B.
    + apply Ai. lra.
    + destruct (squares_of_balls u) as (_ & Q & _). apply farther; [lra|]. rewrite Q.
      rewrite <- (Rmult_1_r (sj ^ 2)) at 1. apply Rmult_lt_compat_l; [exact PJ|].
      apply (colliding_apart _ _ _ certified). lra.
    + apply Ao. lra.
  - destruct (squares_of_balls t) as (_ & Q & _). apply as_far; [lra|]. rewrite Q, (touching _ _ _ certified). ring.
  - destruct impact_of_balls as (_ & _ & _ & _ & _ & _ & _ & _ & _ & ->). pose proof (approaching _ _ _ certified).
    assert (0 < sj ^ 2 * - impact m t) by (apply Rmult_lt_0_compat; lra). lra.
  - intros k N1 N2. destruct distinct as (D1 & D2 & D3). assert (k = i) as -> by (destruct o, i, j, k; congruence).
    split; [apply Ai; lra|]. rewrite distance_symmetric, Rplus_comm. apply Ao. lra.
Qed.
Theorem balls_after :
  seen (after_sharing (share_of mass radius (fun _ => r) o j i) r m t) (bounced D mass r o j (later t x)) j i.
Proof. exact (contact_after (far_after _ _ _ certified) (touching _ _ _ certified)). Qed.
End BallsFlight.

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
Lemma has_seen n x i j : has n D x i j <-> seen D half B0 n x i j.
Proof.
  assert (U : forall f : vector, scaled (1 / 2 + 1 / 2) f = f) by (intros f; apply same_vector; intros k; unfold scaled; field).
  assert (W : (1 / 2 + 1 / 2) * (1 + d n) = 1 + d n) by field. unfold seen, half. rewrite W. split.
  - intros (q & X & G). exists (to x B0 i), q, (relative x B0 i), (relative x B0 j). rewrite !U. repeat (split; trivial).
  - intros (p & q & s & c & X1 & X2 & X3 & X4 & G). rewrite U in X1, X2, X4. subst. now exists q.
Qed.
Variable x : scene.
Variable i j : ball.
Hypothesis others : i <> B0 /\ j <> B0 /\ i <> j.
Hypothesis shown_by : has m D x i j.
Theorem contact_next : 0 < reach m t -> distance D (later t x) B0 j = 1 ->
  has after_step D (collided D r B0 j (later t x)) j i.
Proof.
  intros F T. apply has_seen. pose proof shown_by as G. apply has_seen in G.
  assert (K : in_contact m t).
  { destruct (squares_of_balls D half B0 i j m x G t) as (_ & K & _). rewrite (unit_square _ _ _ _ T) in K.
    unfold in_contact, half in *. lra. }
  pose proof (contact_after D one half r one_positive half_positive B0 i j others m t x G F K) as L.
  replace (share_of one half (fun _ => r) B0 j i) with ((1 + r) / 2) in L by (unfold share_of, reach_of, one, half; field).
  now rewrite (equal_bounced _ _ _ _ _ T) in L.
Qed.

Lemma certified_of_balls : certified_if m t (outer_of_balls half B0 i j m).
Proof.
  destruct certified as [K1 K2 K3 K4 K5 K6 K7 K8 K9]. split; trivial. intros u U. specialize (K9 u U).
  unfold outer_of_balls, outer_of_equal, half in *. lra.
Qed.
Theorem meets : first_to_meet D x B0 j t.
Proof.
  apply equal_meets. apply has_seen in shown_by.
  exact (balls_meet D half half_positive B0 i j others m t certified_of_balls x shown_by).
Qed.
Theorem shows_next : has after_step D (collided D r B0 j (later t x)) j i.
Proof. pose proof meets as [_ _ T _ _]. exact (contact_next (far_after _ _ _ certified) T). Qed.
End EqualBalls.

Lemma cosine_of m n x i j : has m n x i j -> i <> B0 /\ j <> B0 /\ i <> j -> 0 < 1 + d m ->
  minus_cosine n x = C m.
Proof.
  intros G N F. apply has_seen in G. rewrite <- (cosine_seen n half half_positive B0 i j m x G F).
  unfold minus_cosine, minus_cosine_at. destruct N as (N1 & N2 & N3), i, j; try easy.
  now rewrite dot_symmetric, Rmult_comm.
Qed.
