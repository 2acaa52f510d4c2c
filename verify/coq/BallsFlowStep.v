(* One collision of three balls of any masses and radii, from the certificate of their flow: what
   ThreeBalls.v calls the law is proved. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Vectors Motion Classification Contacts Line Bounces ThreeBalls.
From Verify Require BallsFlow.
Open Scope R_scope.

Section BallsFlowStep.
Variable d : nat.
Variables mass radius : ball -> R.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis round : forall b, 0 < radius b.
Variable x : scene.
Variables o i c : ball.
Hypothesis distinct : distinct_balls o i c.
Variables r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' : R.
Notation Kc := ((radius o + radius c) ^ 2).
Notation Ki := ((radius o + radius i) ^ 2).
Notation Ko := ((radius i + radius c) ^ 2).
Notation n := (1 + mass o / mass c).
Hypothesis seen : in_products d radius x o i c v lam rho eps sig A B C a b w.
Hypothesis certified :
  collision_numbers Kc Ki Ko n r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps'.
Lemma contact_positive : 0 < Kc.
Proof. pose proof (round o). pose proof (round c). apply pow_lt. lra. Qed.
Lemma ratio_positive : 0 < n.
Proof. assert (0 < mass o / mass c) by now apply Rdiv_lt_0_compat. lra. Qed.
Lemma kap_not_negative : 0 <= kap.
Proof. destruct certified as (_ & _ & _ & _ & _ & _ & _ & K & _). lra. Qed.
Lemma divisor_positive : 0 < 1 + s.
Proof.
  destruct certified as (_ & _ & _ & _ & _ & _ & _ & _ & _ & -> & _). pose proof (sqrt_pos (1 - A * kap)). lra.
Qed.
Ltac given F := repeat match type of F with ?P -> _ =>
    let Q := fresh in assert (Q : P) by assumption; specialize (F Q); clear Q end.
Ltac numbers := pose proof contact_positive; pose proof ratio_positive; pose proof kap_not_negative;
  pose proof divisor_positive; pose proof certified as (? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? &
    ? & ? & ? & ? & ? & ? & ? & ? & ?).
Ltac flow L F :=
  pose proof (L Kc Ki Ko n r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps') as F; given F.
Notation t := (y * T).
Lemma law_takes_time : 0 < t.
Proof.
  numbers. apply Rmult_lt_0_compat; [|]; subst; [apply Rmult_lt_0_compat | apply Rdiv_lt_0_compat]; assumption.
Qed.
Lemma law_square_i u : square d (later u x) o i = Ki + sig * v ^ 2 + 2 * u * (rho * v) + u * u * B.
Proof.
  destruct seen as (G1 & _ & _ & G4 & _ & _ & _ & G8 & _ & _). unfold square.
  rewrite to_later, square_of_combined, G1, G4, G8. ring.
Qed.
Lemma law_square_c u : square d (later u x) o c = Kc + eps * v ^ 2 - 2 * u * (lam * v) + u * u * A.
Proof.
  destruct seen as (_ & G2 & _ & _ & G5 & _ & _ & _ & G9 & _). unfold square.
  rewrite to_later, square_of_combined, G2, G5, G9. ring.
Qed.
Lemma law_square_outer u : square d (later u x) i c =
  square d (later u x) o i + square d (later u x) o c - 2 * (- C + u * a + u * b + u * u * w).
Proof.
  destruct seen as (_ & _ & G3 & _ & _ & G6 & G7 & _ & _ & G10). unfold square. rewrite (from_o (later u x) o i c).
  rewrite square_of_combined.
  replace (dot d (to (later u x) o i) (to (later u x) o c)) with (- C + u * a + u * b + u * u * w).
  - ring.
  - rewrite !to_later, dot_linear, !dot_linear_right, G3, G6, (dot_symmetric d _ (to x o c)), G7, G10. ring.
Qed.
Lemma law_apart u : 0 < u <= t -> Ki < square d (later u x) o i /\ Ko < square d (later u x) i c.
Proof.
  intros U. numbers. pose proof law_takes_time as P. set (share := u / t).
  assert (S0 : 0 < share) by (apply Rdiv_lt_0_compat; lra).
  assert (E : u = share * t) by (unfold share, Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; reflexivity).
  assert (S1 : 0 <= 1 - share).
  { apply Rmult_le_reg_r with t; [exact P|]. replace ((1 - share) * t) with (t - u) by (rewrite E at 1; ring). lra. }
  pose proof (BallsFlow.spectator_apart Kc Ki Ko n r v lam rho eps sig A B C a b w y q kap s T
    C' lam' A' B' a' b' w' eps' share) as F.
  pose proof (BallsFlow.outer_apart Kc Ki Ko n r v lam rho eps sig A B C a b w y q kap s T
    C' lam' A' B' a' b' w' eps' share) as G.
  given F. given G. rewrite law_square_outer, law_square_i, law_square_c, E. lra.
Qed.
Lemma law_impact_positive : 0 < y * s.
Proof. numbers. flow BallsFlow.impact_positive F. exact F. Qed.
Lemma law_apart_c u : 0 < u < t -> Kc < square d (later u x) o c.
Proof.
  intros U. numbers. pose proof law_takes_time as P. pose proof law_impact_positive as Q. set (share := u / t).
  assert (S0 : 0 < share) by (apply Rdiv_lt_0_compat; lra).
  assert (E : u = share * t) by (unfold share, Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra; reflexivity).
  assert (S2 : 0 < 1 - share).
  { apply Rmult_lt_reg_r with t; [exact P|]. replace ((1 - share) * t) with (t - u) by (rewrite E at 1; ring). lra. }
  assert (S1 : 0 <= 1 - share) by lra.
  pose proof (BallsFlow.colliding_pair_apart Kc Ki Ko n r v lam rho eps sig A B C a b w y q kap s T
    C' lam' A' B' a' b' w' eps' share) as F.
  given F. assert (Z : 0 < 2 * (1 - share) * t * (y * s)).
  { apply Rmult_lt_0_compat; [|exact Q]. apply Rmult_lt_0_compat; [lra | exact P]. }
  rewrite law_square_c, E. lra.
Qed.
Lemma law_touches : square d (later t x) o c = Kc.
Proof. numbers. flow BallsFlow.contact F. rewrite law_square_c. lra. Qed.
Lemma law_rate : rate d (later t x) o c = - (y * s).
Proof.
  numbers. flow BallsFlow.impact F. destruct seen as (_ & _ & _ & _ & G5 & _ & _ & _ & G9 & _).
  unfold rate. rewrite to_later, relative_later, dot_linear, G5, G9. lra.
Qed.
Lemma law_distance : distance d (later t x) o c = radius o + radius c.
Proof. pose proof (round o). pose proof (round c). apply as_far; [lra | exact law_touches]. Qed.
Theorem law_meets : meets_next d radius x o c t.
Proof.
  pose proof (round o). pose proof (round i). pose proof (round c). pose proof law_takes_time.
  split; [assumption|]. split; [|split; [exact law_distance | split]].
  - intros u j l U N. revert j l N. apply (any_of_three _ o i c distinct).
    + intros j l M. rewrite distance_symmetric, Rplus_comm. exact M.
    + apply farther; [lra|]. apply law_apart. lra.
    + apply farther; [lra|]. now apply law_apart_c.
    + apply farther; [lra|]. apply law_apart. lra.
  - rewrite law_rate. pose proof law_impact_positive. lra.
  - intros j N1 N2. destruct distinct as (D1 & D2 & D3). assert (j = i) as -> by (destruct o, i, c, j; congruence).
    destruct (law_apart t ltac:(lra)). split; [apply farther; lra|].
    rewrite distance_symmetric, Rplus_comm. apply farther; lra.
Qed.
Theorem law_next : in_products d radius (bounced d mass r o c (later t x)) o c i
  y lam' (r * s) eps' 0 A' B' C' a' b' w'.
Proof.
  pose proof law_rate as K. pose proof law_distance as L. destruct distinct as (D1 & D2 & D3). numbers.
  pose proof (heavy o) as Mo. pose proof (heavy c) as Mc. pose proof (round o). pose proof (round c).
  set (z := bounced d mass r o c (later t x)).
  assert (E1 : to z o c = combined 1 (to x o c) t (relative x o c)) by apply (to_later t x o c).
  assert (E2 : to z o i = combined 1 (to x o i) t (relative x o i)) by apply (to_later t x o i).
  assert (E3 : relative z o c = combined 1 (relative x o c) ((1 + r) * (y * s) / Kc) (combined 1 (to x o c) t (relative x o c))).
  { apply same_vector. intros k. rewrite <- to_later. unfold relative at 1, z, bounced. cbn [velocity].
    rewrite !same_true, (same_false c o), K, L by congruence. unfold combined, relative. cbn [later velocity].
    field. repeat split; lra. }
  assert (E4 : relative z o i = combined 1 (relative x o i) ((1 + r) / n * (y * s) / Kc) (combined 1 (to x o c) t (relative x o c))).
  { apply same_vector. intros k. rewrite <- to_later. unfold relative at 1, z, bounced. cbn [velocity].
    rewrite !same_true, (same_false i o), (same_false i c), K, L by congruence. unfold combined, relative. cbn [later velocity].
    field. repeat split; lra. }
  assert (Kappa : 1 * 1 * (- (lam * v)) + 1 * t * A = - (y * s)).
  { flow BallsFlow.impact F. exact F. }
  pose proof seen as (G1 & G2 & G3 & G4 & G5 & G6 & G7 & G8 & G9 & G10).
  pose proof G3 as R3. pose proof G4 as R4. pose proof G5 as R5. pose proof G6 as R6.
  pose proof G7 as R7. pose proof G10 as R10.
  rewrite dot_symmetric in R3, R4, R5, R6, R7, R10.
  unfold in_products. rewrite ?E1, ?E2, ?E3, ?E4.
  repeat split; repeat (rewrite dot_linear || rewrite dot_linear_right);
    rewrite ?G1, ?G2, ?G3, ?G4, ?G5, ?G6, ?G7, ?G8, ?G9, ?G10, ?R3, ?R4, ?R5, ?R6, ?R7, ?R10.
  - flow BallsFlow.next_x_s_x_s F. etransitivity; [|exact F]. ring.
  - flow BallsFlow.next_x_c_x_c F. etransitivity; [|exact F]. ring.
  - flow BallsFlow.next_x_s_x_c F. etransitivity; [|exact F]. ring.
  - flow BallsFlow.next_x_s_W_s F. rewrite Kappa in F. etransitivity; [|exact F]. field. lra.
  - flow BallsFlow.next_x_c_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field. repeat split; lra.
  - flow BallsFlow.next_x_s_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field. repeat split; lra.
  - flow BallsFlow.next_W_s_x_c F. rewrite Kappa in F. etransitivity; [|exact F]. field. repeat split; lra.
  - flow BallsFlow.next_W_s_W_s F. rewrite Kappa in F. etransitivity; [|exact F]. field. lra.
  - flow BallsFlow.next_W_c_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field. repeat split; lra.
  - flow BallsFlow.next_W_s_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field. repeat split; lra.
Qed.
End BallsFlowStep.

Theorem law_theorem_holds : law_theorem.
Proof.
  intros d mass radius r x o i c v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' M P D G N.
  exists (bounced d mass r o c (later (y * T) x)).
  pose proof (law_meets d mass radius M P x o i c D r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' G N) as F.
  split; [exact F|]. split; [|exact (law_next d mass radius M P x o i c D r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' G N)].
  destruct F as (_ & _ & L & K & _). destruct N as (R & _), D as (_ & D & _). pose proof (P o). pose proof (P c).
  apply bounced_parts; trivial; [congruence | rewrite L; lra].
Qed.
