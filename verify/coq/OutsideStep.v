(* Where two balls strike, what AnyStep.v asks for holds of the numbers of the scene, as far as the
   certificate of outside takes it for granted; and the states of that certificate. *)
From Coq Require Import Reals List Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Meaning Terms Checker Readable Extension.
From Verify Require Import AnyStep ThreeBalls Outside.
From Verify Require Gram Ends.
Import ListNotations.
Open Scope R_scope.

(* --- a strike, in numbers ------------------------------------------------------------------------- *)

(* The distance e is 1 after the time t, when it falls; y e is the rate at which it falls at first. *)
Section Strike.
Variables e y A t : R.
Hypothesis apart : 1 < e.
Hypothesis takes_time : 0 < t.
Hypothesis fast : 0 <= A.
Hypothesis touches : e * e - 2 * t * e * y + t * t * A = 1.
Hypothesis falls : - (e * y) + t * A < 0.
Let k := e * y - t * A.
Lemma strike_closing : 0 < y.
Proof.
  assert (0 < t * e * y).
  { assert (0 <= t * t * A) by (repeat apply Rmult_le_pos; lra).
    assert (1 * 1 < e * e) by (apply Rmult_le_0_lt_compat; lra). lra. }
  apply Rmult_lt_reg_l with (t * e); [apply Rmult_lt_0_compat; lra | lra].
Qed.
Lemma strike_rate : k * k = e * y * (e * y) - A * (e * e - 1).
Proof. unfold k. replace (e * e - 1) with (2 * t * e * y - t * t * A) by lra. ring. Qed.
Lemma strike_root : 1 - (e * e - 1) / e / e * (A / y / y) = (k / (e * y)) ^ 2.
Proof.
  pose proof strike_closing. replace ((k / (e * y)) ^ 2) with (k * k / (e * y * (e * y))) by (field; lra).
  rewrite strike_rate. field. lra.
Qed.
Lemma strike_part : 0 < k / (e * y).
Proof.
  pose proof strike_closing. apply Rdiv_lt_0_compat; [unfold k; lra|]. apply Rmult_lt_0_compat; lra.
Qed.
Lemma strike_meets : 0 < 1 - (e * e - 1) / e / e * (A / y / y).
Proof. rewrite strike_root. apply pow_lt, strike_part. Qed.
Lemma strike_sqrt : sqrt (1 - (e * e - 1) / e / e * (A / y / y)) = k / (e * y).
Proof. rewrite strike_root. apply sqrt_pow2, Rlt_le, strike_part. Qed.
Lemma strike_time : t = (e * e - 1) / e / y / (1 + sqrt (1 - (e * e - 1) / e / e * (A / y / y))).
Proof.
  pose proof strike_closing. pose proof strike_part. rewrite strike_sqrt.
  assert (0 < e * y) by (apply Rmult_lt_0_compat; lra).
  assert (0 < 2 * (e * y) - t * A) by (unfold k in *; lra).
  replace (e * e - 1) with (t * (2 * (e * y) - t * A)) by lra. unfold k. field. repeat split; lra.
Qed.
End Strike.
Theorem next_theorem_holds : next_theorem.
Proof.
  intros d s i j t E T [X P]. set (e := distance d s i j) in *. unfold zeta_of, closing_of. cbn zeta. fold e.
  set (y := - rate d s i j / e). set (A := dot d (relative s i j) (relative s i j)).
  assert (Y : rate d s i j = - (e * y)) by (unfold y; field; lra).
  assert (F : 0 <= A) by apply dot_self.
  assert (Q : e * e = dot d (to s i j) (to s i j)).
  { change (e * e = square d s i j). rewrite square_of_distance. unfold e. ring. }
  assert (C : e * e - 2 * t * e * y + t * t * A = 1).
  { replace 1 with (square d (later t s) i j) by (rewrite square_of_distance, X; ring). unfold square.
    rewrite to_later, square_of_combined, <- Q. fold (rate d s i j). rewrite Y. fold A. ring. }
  assert (K : - (e * y) + t * A < 0).
  { unfold rate in P. rewrite to_later, relative_later, dot_linear in P. fold (rate d s i j) A in P. lra. }
  pose proof (strike_closing e y A t E T F C) as Z. split; [exact Z|].
  replace ((e ^ 2 - 1) / e ^ 2 * (A / y ^ 2)) with ((e * e - 1) / e / e * (A / y / y)) by (field; lra).
  replace (e ^ 2 - 1) with (e * e - 1) by ring. split.
  - pose proof (strike_meets e y A t E T F C K). lra.
  - exact (strike_time e y A t E T F C K).
Qed.

(* --- two strikes one after the other --------------------------------------------------------------- *)

Definition root_of (m : numbers) : R := sqrt (1 - d m * (2 + d m) / (1 + d m) / (1 + d m) * (A m / y m / y m)).
Definition time_of (m : numbers) : R := d m * (2 + d m) / (1 + d m) / y m / (1 + root_of m).
Section TwoStrikes.
Variable r : R.
Hypothesis restitutes : 0 < r.
Variable D : nat.
Lemma strike_numbers m t x i j : has m D x i j -> 0 < d m -> 0 < t -> strike D (later t x) B0 j ->
  0 < y m /\ 0 < 1 - d m * (2 + d m) / (1 + d m) / (1 + d m) * (A m / y m / y m) /\ t = time_of m /\
  in_contact m t /\ impact m t = - ((1 + d m) * y m * root_of m) /\ impact m t < 0.
Proof.
  intros (q & X & G) P T [S K]. set (e := 1 + d m).
  assert (F : 0 <= A m) by (rewrite <- (of_c_c _ _ _ _ _ _ G); apply dot_self).
  assert (E : to (later t x) B0 j = combined e q t (relative x B0 j)).
  { rewrite to_later, X. apply same_vector. intros k. unfold combined, scaled, e. ring. }
  assert (C : in_contact m t).
  { pose proof (square_ahead m D _ _ _ _ G t) as Q. fold e in Q. rewrite <- E in Q.
    change (square D (later t x) B0 j = e * e + e * t * - y m + t * e * - y m + t * t * A m) in Q.
    rewrite square_of_distance, S in Q. unfold in_contact. fold e. rewrite <- Q. ring. }
  assert (I : impact m t < 0).
  { rewrite <- (rate_ahead m t D _ _ _ _ G). fold e. rewrite <- E. exact K. }
  unfold in_contact, impact in C, I. fold e in C, I.
  assert (C' : e * e - 2 * t * e * y m + t * t * A m = 1) by lra.
  assert (I' : - (e * y m) + t * A m < 0) by lra. assert (E1 : 1 < e) by (unfold e; lra).
  pose proof (strike_closing e _ _ t E1 T F C') as Y.
  replace (d m * (2 + d m)) with (e * e - 1) by (unfold e; ring). split; [exact Y|].
  split; [exact (strike_meets e _ _ t E1 T F C' I')|]. unfold time_of, root_of. fold e.
  replace (d m * (2 + d m)) with (e * e - 1) by (unfold e; ring).
  split; [exact (strike_time e _ _ t E1 T F C' I')|]. split; [unfold in_contact; fold e; lra|].
  split; [|unfold impact; fold e; lra].
  rewrite (strike_sqrt e _ _ t E1 T F C' I'). unfold impact. fold e. field. lra.
Qed.
(* The second one in the numbers of the first. *)
Lemma two_strikes m t u x i j : i <> B0 /\ j <> B0 /\ i <> j -> has m D x i j -> 0 < d m -> 0 < eta_s m ->
  0 < t -> strike D (later t x) B0 j ->
  0 < u -> strike D (later u (collided D r B0 j (later t x))) B0 i ->
  let k := (1 + d m) * y m * root_of m in let T := time_of m in
  let turn := (1 + d m) * C m - T * a m - (1 + d m) * T * b m - T ^ 2 * w m in
  let law := (1 + r) / 2 * k * turn - (eta_s m + T * B m) in
  (has (after_step r m t) D (collided D r B0 j (later t x)) j i /\ 0 < d (after_step r m t) /\
   0 < eta_s (after_step r m t)) /\ 0 < law /\
  (2 * eta_s m * T + B m * T ^ 2) *
    (B m + 2 * ((1 + r) / 2) * k * ((1 + d m) * b m + T * w m) + ((1 + r) / 2) ^ 2 * k ^ 2) < law ^ 2.
Proof.
  intros N G P R T S U V. cbn zeta. destruct (strike_numbers m t x i j G P T S) as (Y & _ & E & C & I & K).
  rewrite <- E. set (k := (1 + d m) * y m * root_of m) in *.
  set (turn := (1 + d m) * AnyStep.C m - t * a m - (1 + d m) * t * b m - t ^ 2 * w m).
  set (law := (1 + r) / 2 * k * turn - (eta_s m + t * B m)).
  assert (FB : 0 <= B m) by (destruct G as (q & _ & G); rewrite <- (of_s_s _ _ _ _ _ _ G); apply dot_self).
  assert (K1 : 0 < t * eta_s m) by (apply Rmult_lt_0_compat; lra).
  assert (K2 : 0 <= t * t * B m) by (repeat apply Rmult_le_pos; lra).
  set (q := reach m t). assert (Q : q * q = 1 + t * eta_s m + t * eta_s m + t * t * B m) by (apply sqrt_sqrt; lra).
  assert (Q1 : 1 < q).
  { unfold q, reach. rewrite <- sqrt_1 at 1. apply sqrt_lt_1; lra. }
  assert (H : has (after_step r m t) D (collided D r B0 j (later t x)) j i).
  { apply contact_next; try assumption; [fold q; lra | apply S]. }
  assert (PD : d (after_step r m t) = q - 1) by reflexivity.
  assert (PE : 0 < eta_s (after_step r m t)).
  { replace (eta_s (after_step r m t)) with (r * k).
    - apply Rmult_lt_0_compat; lra.
    - unfold after_step, after_sharing. cbn [eta_s]. rewrite I. unfold impact in I. unfold in_contact in C.
      set (e := 1 + d m) in *. transitivity ((1 + r) * k * (e * e + e * t * - y m + t * e * - y m + t * t * A m)
        + (e * - y m + t * A m)); [rewrite C, I|]; ring. }
  split; [split; [exact H|]; split; [lra | exact PE]|].
  assert (J : j <> B0 /\ i <> B0 /\ j <> i) by (destruct N as (N1 & N2 & N3); repeat split; congruence).
  destruct (strike_numbers _ u _ j i H ltac:(lra) U V) as (Y' & Z' & _). rewrite PD in Z'.
  assert (L : q * y (after_step r m t) = law).
  { unfold after_step, after_sharing. cbn [y]. rewrite I. fold q. unfold law, turn. field. lra. }
  assert (L' : A (after_step r m t) =
    B m + 2 * ((1 + r) / 2) * k * ((1 + d m) * b m + t * w m) + ((1 + r) / 2) ^ 2 * k ^ 2).
  { unfold after_step, after_sharing. cbn [A]. rewrite I. unfold in_contact in C.
    replace ((1 + d m) * (1 + d m) + 2 * (1 + d m) * t * - y m + t * t * A m) with 1 by lra. ring. }
  rewrite <- L', <- L. split; [apply Rmult_lt_0_compat; lra|].
  set (y' := y (after_step r m t)) in *. set (A' := A (after_step r m t)) in *.
  replace (2 * eta_s m * t + B m * t ^ 2) with ((q - 1) * (2 + (q - 1))) by lra.
  apply Rmult_lt_reg_r with (/ (q * y') ^ 2); [apply Rinv_0_lt_compat, pow_lt, Rmult_lt_0_compat; lra|].
  rewrite Rinv_r by (apply pow_nonzero, Rmult_integral_contrapositive; lra).
  replace (1 + (q - 1)) with q in Z' by ring.
  replace ((q - 1) * (2 + (q - 1)) * A' * / (q * y') ^ 2) with
    ((q - 1) * (2 + (q - 1)) / q / q * (A' / y' / y')) by (field; lra).
  lra.
Qed.
End TwoStrikes.
