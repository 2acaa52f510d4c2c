(* Free flight of three balls, from the certificate of the flow: if the inner products of a scene are the
   numbers of a state, and these satisfy what the flow's context drift asks for, then nobody touches
   meanwhile, and the scene after it has the numbers that the flow calls next. A flight to the next
   collision may be cut into such flights. *)
From Coq Require Import Reals List Lra.
From Verify Require Import Theorem1 Vectors Motion Meaning Bounces BallsFlowStep FlowStep FlowScene.
From Verify Require Flow.
Open Scope R_scope.

(* What stays positive in between: the coefficients of Bernstein's polynomials are. *)
Lemma in_between g p m t u : 0 <= g -> 0 <= g + p * t -> 0 < g + t * (2 * p + m * t) -> 0 < u <= t ->
  1 < 1 + g + 2 * u * p + u * u * m.
Proof.
  intros G H K U.
  assert (exists s, 0 < s /\ u = s * t) as (s & S & ->)
    by (exists (u / t); split; [apply Rdiv_lt_0_compat; lra | field; lra]).
  assert (S1 : 0 <= 1 - s).
  { apply Rmult_le_reg_r with t; lra. }
  assert (A : 0 <= (1 - s) * (1 - s) * g) by (repeat apply Rmult_le_pos; trivial).
  assert (B : 0 <= 2 * s * (1 - s) * (g + p * t)) by (repeat apply Rmult_le_pos; trivial; lra).
  assert (C : 0 < s * s * (g + t * (2 * p + m * t))) by (repeat apply Rmult_lt_0_compat; trivial).
  lra.
Qed.

Section FlowDrift.
Variables v lam rho eps sig A B C a b w lam_next rho_next eps_next sig_next C_next a_next b_next t : R.
(* What the certificate asks for. *)
Record flow_drift : Prop := {
  drift_1 : 0 < v; drift_2 : 0 <= t;
  drift_3 : lam_next = lam - t / v * A; drift_4 : rho_next = rho + t / v * B;
  drift_5 : eps_next = eps - t / v * (2 * lam - t / v * A);
  drift_6 : sig_next = sig + t / v * (2 * rho + t / v * B);
  drift_7 : C_next = C - t * (a + b + t * w); drift_8 : a_next = a + t * w; drift_9 : b_next = b + t * w;
  drift_10 : 0 <= eps * v ^ 2; drift_11 : 0 <= eps * v ^ 2 + - (lam * v) * t;
  drift_12 : 0 < eps * v ^ 2 + t * (2 * - (lam * v) + A * t);
  drift_13 : 0 <= sig * v ^ 2; drift_14 : 0 <= sig * v ^ 2 + rho * v * t;
  drift_15 : 0 < sig * v ^ 2 + t * (2 * (rho * v) + B * t);
  drift_16 : 0 <= 1 + (eps + sig) * v ^ 2 + 2 * C;
  drift_17 : 0 <= 1 + (eps + sig) * v ^ 2 + 2 * C + ((rho - lam) * v - a - b) * t;
  drift_18 : 0 < 1 + (eps + sig) * v ^ 2 + 2 * C +
    t * (2 * ((rho - lam) * v - a - b) + (A + B - 2 * w) * t)
}.
Hypothesis certified : flow_drift.
Variable d : nat.
Variable x : scene.
Variables o i c : ball.
Hypothesis distinct : i <> o /\ c <> o /\ i <> c.
Hypothesis seen : gram d x o i c v lam rho eps sig A B C a b w.

Theorem drift_next : gram d (later t x) o i c
  v lam_next rho_next eps_next sig_next A B C_next a_next b_next w.
Proof.
  destruct seen as [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10].
  destruct certified as [V _ -> -> -> -> -> -> -> _ _ _ _ _ _ _ _ _].
  pose proof G3 as R3. pose proof G4 as R4. pose proof G5 as R5. pose proof G6 as R6.
  pose proof G7 as R7. pose proof G10 as R10.
  rewrite dot_symmetric in R3, R4, R5, R6, R7, R10.
  split; rewrite ?to_later, ?relative_later; repeat (rewrite dot_linear || rewrite dot_linear_right);
    rewrite ?G1, ?G2, ?G3, ?G4, ?G5, ?G6, ?G7, ?G8, ?G9, ?G10, ?R3, ?R4, ?R5, ?R6, ?R7, ?R10; field; lra.
Qed.
Theorem drift_apart u : 0 < u <= t -> forall k l, k <> l -> 1 < distance d (later u x) k l.
Proof.
  intros U. destruct certified as [_ _ _ _ _ _ _ _ _ C1 C2 C3 S1 S2 S3 O1 O2 O3].
  pose proof seen as G. apply gram_is in G. pose proof (law_square_i _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ G u) as Qi.
  pose proof (law_square_c _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ G u) as Qc.
  pose proof (law_square_outer _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ G u) as Qo. unfold half in *.
  apply (any_of_three _ o i c distinct);
    [intros k l; now rewrite distance_symmetric | | |]; apply distance_above.
  - pose proof (in_between _ _ _ _ u S1 S2 S3 U). lra.
  - pose proof (in_between _ _ _ _ u C1 C2 C3 U). lra.
  - pose proof (in_between _ _ _ _ u O1 O2 O3 U). lra.
Qed.
Lemma drift_still_apart : 0 < eps_next.
Proof.
  destruct certified as [V _ _ _ -> _ _ _ _ _ _ K _ _ _ _ _ _].
  apply Rmult_lt_reg_r with (v ^ 2); [now apply pow_lt|].
  replace ((eps - t / v * (2 * lam - t / v * A)) * v ^ 2) with (eps * v ^ 2 + t * (2 * - (lam * v) + A * t))
    by (field; lra). lra.
Qed.
(* What meets next after the flight meets next before it. *)
Theorem drift_meets u k l : first_to_meet d (later t x) k l u -> first_to_meet d x k l (t + u).
Proof.
  intros [P F E R N]. assert (T : 0 <= t) by apply certified.
  assert (Q : later u (later t x) = later (t + u) x) by (rewrite later_later; f_equal; ring).
  rewrite Q in *. split; trivial; [lra|].
  intros s h j S M. destruct (Rle_lt_dec s t) as [L|L]; [now apply drift_apart|].
  replace (later s x) with (later (s - t) (later t x)) by (rewrite later_later; f_equal; ring).
  apply F; trivial. lra.
Qed.
End FlowDrift.

Definition drift_givens := Eval vm_compute in flow_givens Flow.context_drift.
Lemma drift_certified w : scope SF Flow.context_drift w -> flow_drift
  (w Flow.number_of_drift_v) (w Flow.number_of_drift_lam) (w Flow.number_of_drift_rho)
  (w Flow.number_of_drift_eps) (w Flow.number_of_drift_sig) (w Flow.number_of_drift_A)
  (w Flow.number_of_drift_B) (w Flow.number_of_drift_C) (w Flow.number_of_drift_a)
  (w Flow.number_of_drift_b) (w Flow.number_of_drift_w) (w Flow.number_of_drift_lam_next)
  (w Flow.number_of_drift_rho_next) (w Flow.number_of_drift_eps_next)
  (w Flow.number_of_drift_sig_next) (w Flow.number_of_drift_C_next) (w Flow.number_of_drift_a_next)
  (w Flow.number_of_drift_b_next) (w Flow.number_of_drift_t).
Proof.
  intros S. givens_of_flow w S Flow.context_drift drift_givens.
  split; assumption.
Qed.
