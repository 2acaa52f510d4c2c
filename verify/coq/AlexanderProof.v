(* Proofs for PinnedAlexander.v, from the rows of certificates/alexander. *)
From Coq Require Import Reals Lra Psatz.
From Verify Require Import Vectors PinnedAlexander.
From Verify Require Almost.
Open Scope R_scope.

Lemma quotient_at_most a b c : 0 < b -> a <= c * b -> a / b <= c.
Proof.
  intros P L. apply Rmult_le_reg_r with b; trivial. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.
Lemma quotient_at_least a b c : 0 < b -> c * b <= a -> c <= a / b.
Proof.
  intros P L. apply Rmult_le_reg_r with b; trivial. unfold Rdiv. rewrite Rmult_assoc, Rinv_l; lra.
Qed.

(* --- one collision -------------------------------------------------------------------------------------- *)

Section Combinations.
Variable d : nat.
Variables e beta kappa y q : R.
Variables n_s n_c V_s V_c : vector.
Definition combination a b c f : vector := fun i => a * n_s i + b * n_c i + c * V_s i + f * V_c i.
Lemma dot_same (u u' v v' : vector) : (forall i, u i = u' i) -> (forall i, v i = v' i) -> dot d u v = dot d u' v'.
Proof. intros P Q. induction d as [|k IH]; cbn [dot]; [reflexivity|]. now rewrite IH, P, Q. Qed.
Lemma dot_combination a b c f a' b' c' f' : dot d (combination a b c f) (combination a' b' c' f') =
  a * a' * dot d n_s n_s + b * b' * dot d n_c n_c + c * c' * dot d V_s V_s + f * f' * dot d V_c V_c +
  (a * b' + b * a') * dot d n_s n_c + (a * c' + c * a') * dot d n_s V_s + (a * f' + f * a') * dot d n_s V_c +
  (b * c' + c * b') * dot d n_c V_s + (b * f' + f * b') * dot d n_c V_c + (c * f' + f * c') * dot d V_s V_c.
Proof. induction d as [|k IH]; cbn [dot]; [ring|]. rewrite IH. unfold combination. ring. Qed.
End Combinations.
Ltac combined := unfold combination; intros; cbv beta; field; trivial.
Ltac given row := apply row; trivial;
  match goal with H : ?x = _ |- ?x = _ => etransitivity; [exact H | unfold Rdiv; ring] end.
Theorem collision_holds : collision_theorem.
Proof.
  intros d e beta kappa y q n_s n_c V_s V_c A B gap S T U x_c x_s E m_s W_c W_s p q' kappa'
    E0 B0 K0 Y0 Q0 Ns Nc Ps Pc S0 P0.
  pose proof (cauchy_schwarz d n_c V_c) as CA. pose proof (cauchy_schwarz d n_s V_s) as CB.
  change (Theorem1.dot d) with (dot d) in CA, CB. rewrite Nc, Pc in CA. rewrite Ns, Ps in CB.
  fold A in CA. fold B in CB.
  assert (Y2 : 0 < y ^ 2) by now apply pow_lt.
  assert (QY : 0 < q * y) by now apply Rmult_lt_0_compat.
  assert (QY2 : 0 < (q * y) ^ 2) by now apply pow_lt.
  assert (A0 : 0 < A) by lra. assert (B1 : 0 < B) by lra.
  assert (G0 : 0 < gap) by now apply Rmult_lt_0_compat.
  assert (G1 : 0 < 1 + gap) by lra. assert (S1 : 0 < 1 + S) by lra.
  assert (G2 : 0 < (1 + gap) ^ 2) by now apply pow_lt.
  assert (SS : S ^ 2 * (1 + gap) ^ 2 = (1 + gap) ^ 2 - kappa * (2 + gap) * A).
  { replace (S ^ 2) with (1 - A * kappa * (2 + gap) / (1 + gap) ^ 2); [field; lra|]. symmetry. apply pow2_sqrt.
    apply Rnot_lt_le. intros N. unfold S, S_ in S0. rewrite sqrt_neg_0 in S0; [lra | now apply Rlt_le]. }
  assert (TT : T = kappa * (2 + gap) / (1 + gap) / (1 + S)).
  { unfold T, T_. fold gap. fold S. field. lra. }
  assert (T0 : 0 < T).
  { rewrite TT. apply Rdiv_lt_0_compat; trivial. apply Rdiv_lt_0_compat; trivial. apply Rmult_lt_0_compat; lra. }
  assert (TL : T * (1 + gap) * (1 + S) = kappa * (2 + gap)) by (rewrite TT; field; lra).
  assert (AT : A * T = (1 + gap) * (1 - S)).
  { apply Rmult_eq_reg_r with ((1 + gap) * (1 + S)); [|apply Rgt_not_eq, Rmult_lt_0_compat; lra].
    transitivity (A * (T * (1 + gap) * (1 + S))); [ring|]. rewrite TL.
    transitivity ((1 + gap) ^ 2 - S ^ 2 * (1 + gap) ^ 2); [rewrite SS|]; ring. }
  set (C := - dot d n_s n_c). set (g := dot d n_s V_c). set (h := dot d n_c V_s). set (w := dot d V_s V_c).
  assert (form : forall a b c f a' b' c' f', dot d (combination n_s n_c V_s V_c a b c f)
    (combination n_s n_c V_s V_c a' b' c' f') = a * a' + b * b' + c * c' * B + f * f' * A + (a * b' + b * a') * - C
    + (a * c' + c * a') * (q * y) + (a * f' + f * a') * g + (b * c' + c * b') * h + (b * f' + f * b') * - y
    + (c * f' + f * c') * w).
  { intros. rewrite dot_combination, Ns, Nc, Ps, Pc. unfold C, g, h, w, A, B. ring. }
  assert (xc : forall i, x_c i = combination n_s n_c V_s V_c 0 (1 + gap) 0 (y * T) i) by (unfold x_c; combined).
  assert (xs : forall i, x_s i = combination n_s n_c V_s V_c 1 0 (y * T) 0 i) by (unfold x_s; combined).
  assert (EE : E ^ 2 = dot d x_s x_s) by (apply pow2_sqrt, (dot_self d)).
  assert (ER : E ^ 2 = 1 + y ^ 2 * (T * (2 * q + B * T))).
  { rewrite EE, (dot_same d _ _ _ _ xs xs), form. ring. }
  assert (R0 : 0 < y ^ 2 * (T * (2 * q + B * T))).
  { apply Rmult_lt_0_compat; trivial. apply Rmult_lt_0_compat; trivial.
    assert (0 < B * T) by now apply Rmult_lt_0_compat. lra. }
  assert (E1 : 0 < E).
  { destruct (sqrt_pos (dot d x_s x_s)) as [L|L]; [exact L|]. fold E in L. rewrite <- L in ER. lra. }
  assert (EN : E <> 0) by lra.
  assert (ms : forall i, m_s i = combination n_s n_c V_s V_c (1 / E) 0 (1 / E * (y * T)) 0 i)
    by (unfold m_s, x_s; combined).
  assert (wc : forall i, W_c i = combination n_s n_c V_s V_c 0 ((1 + e) * U * (1 + gap)) 0 (1 + (1 + e) * U * (y * T)) i)
    by (unfold W_c, x_c; combined).
  assert (ws : forall i, W_s i = combination n_s n_c V_s V_c 0 (beta * U * (1 + gap)) 1 (beta * U * (y * T)) i)
    by (unfold W_s, x_c; combined).
  assert (contact : dot d x_c x_c = 1).
  { rewrite (dot_same d _ _ _ _ xc xc), form.
    transitivity ((1 + gap) ^ 2 - 2 * (1 + gap) * y ^ 2 * T + y ^ 2 * T * (A * T)); [ring|]. rewrite AT.
    transitivity ((1 + gap) ^ 2 - y ^ 2 * (T * (1 + gap) * (1 + S))); [ring|]. rewrite TL. unfold gap. ring. }
  assert (unit : dot d m_s m_s = 1).
  { rewrite (dot_same d _ _ _ _ ms ms), form. transitivity ((1 + y ^ 2 * (T * (2 * q + B * T))) / E ^ 2);
    [field | rewrite <- ER; field]; trivial. }
  set (c := - dot d x_c m_s).
  assert (C1 : c <= 1).
  { pose proof (cauchy_schwarz d x_c m_s) as K. change (Theorem1.dot d) with (dot d) in K.
    rewrite contact, unit in K. unfold c. nra. }
  assert (pe : p = - (dot d m_s W_s / y)) by (unfold p; field; lra).
  assert (qe : q' = dot d x_c W_c / y / p) by (unfold q'; field; lra).
  assert (ke : kappa' = (E - 1) / y / y / p / p) by (unfold kappa'; field; lra).
  rewrite (dot_same d _ _ _ _ ms ws), form in pe. rewrite (dot_same d _ _ _ _ xc wc), form in qe.
  assert (ce : c = - dot d x_c m_s) by reflexivity. rewrite (dot_same d _ _ _ _ xc ms), form in ce.
  rewrite (dot_same d _ _ _ _ xs xs), form in EE.
  unfold U, gap in pe, qe, ce.
  assert (LP : p * E = beta * (1 + gap) * S * c * E - (q + B * T)).
  { given (Almost.law_p e beta kappa y q C g h A B w S T E p q' kappa' c). }
  assert (LQ : q' * p = e * (1 + gap) * S).
  { given (Almost.law_q e beta kappa y q C g h A B w S T E p q' kappa' c). }
  assert (LK : kappa' * (1 + E) * p ^ 2 = T * (2 * q + B * T)).
  { given (Almost.law_kappa e beta kappa y q C g h A B w S T E p q' kappa' c). }
  split; [split; [exact contact|]|split; [split; [exact ER|split; [|split]]|]].
  - assert (vc : forall i, V_c i = combination n_s n_c V_s V_c 0 0 0 1 i) by combined.
    rewrite (dot_same d _ _ _ _ xc vc), form.
    transitivity (y * (A * T) - y * (1 + gap)); [ring|]. rewrite AT. unfold U. ring.
  - apply Rmult_eq_reg_r with E; trivial. rewrite LP. unfold c. field. trivial.
  - rewrite <- LQ. field. lra.
  - rewrite <- LK. field. lra.
  - intros i. unfold m_s, W_c, W_s, U, x_c, x_s, gap. repeat split; field; trivial.
Qed.

(* --- the order ------------------------------------------------------------------------------------------ *)

(* At y = 0 and with T the limit map is rational. *)
Lemma at_limit A kappa : 0 <= A -> 0 < kappa -> 2 * A * kappa < 1 -> let T := T_ A kappa 0 in
  0 < T /\ 0 < 1 - A * T /\ S_ A kappa 0 = 1 - A * T /\ kappa = T * (1 - A * T / 2).
Proof.
  intros A0 K0 L T. set (S := S_ A kappa 0).
  assert (E : S = sqrt (1 - 2 * A * kappa)) by (unfold S, S_; f_equal; field).
  assert (S0 : 0 < S) by (rewrite E; apply sqrt_lt_R0; lra).
  assert (S2 : S ^ 2 = 1 - 2 * A * kappa) by (rewrite E; apply pow2_sqrt; lra).
  assert (TE : T = 2 * kappa / (1 + S)).
  { unfold T, T_. fold S. replace (kappa * 0 ^ 2) with 0 by ring. field. lra. }
  assert (AT : A * T = 1 - S).
  { rewrite TE. transitivity ((1 - S ^ 2) / (1 + S)); [rewrite S2|]; field; lra. }
  assert (TK : T * (1 + S) = 2 * kappa) by (rewrite TE; field; lra).
  split; [rewrite TE; apply Rdiv_lt_0_compat; lra|]. split; [lra|]. split; [lra|].
  transitivity (T * (1 + S) / 2); [lra|]. replace S with (1 - A * T) by lra. field.
Qed.

Section TwoStates.
Variables alpha e A B q kappa Q K : R.
Hypothesis lower : below alpha e A B q kappa Q K.
Let p := p_ alpha A B q kappa.
Let P := p_ alpha A B Q K.
Let q' := next_q alpha e A B q kappa.
Let Q' := next_q alpha e A B Q K.
Let kappa' := next_kappa alpha A B q kappa.
Let K' := next_kappa alpha A B Q K.
Lemma ordered : 0 < P <= p /\ p <= alpha /\ (alpha * A + B) * (K - kappa) + (Q - q) <= p - P /\ 0 < q' <= Q' /\
  0 < kappa' <= K' /\ kappa' * K * p ^ 2 <= kappa * K' * P ^ 2 /\
  e * (q * A + B) * (K - kappa) <= (Q' - q') * (p * P).
Proof.
  destruct lower as (L0 & E0 & A0 & B0 & [Q0 QQ] & [K0 KK] & M & P0). fold P in P0.
  assert (AK : A * kappa <= A * K) by now apply Rmult_le_compat_l.
  destruct (at_limit A kappa A0 K0) as (t0 & s0 & Se & Ke); [lra|].
  destruct (at_limit A K A0) as (T0 & S0 & SE & KE); [lra | lra|].
  set (t := T_ A kappa 0) in *. set (T := T_ A K 0) in *.
  assert (pe : p = alpha * (1 - A * t) - q - B * t) by (unfold p, p_; fold t; rewrite Se; ring).
  assert (PE : P = alpha * (1 - A * T) - Q - B * T) by (unfold P, p_; fold T; rewrite SE; ring).
  assert (tT : t <= T) by (apply Rnot_lt_le; intros N; nra).
  assert (a0 : 0 <= alpha * A) by (apply Rmult_le_pos; lra).
  assert (0 <= alpha * A * t) by (apply Rmult_le_pos; lra).
  assert (0 <= B * t) by (apply Rmult_le_pos; lra).
  assert (alpha * A * t <= alpha * A * T) by now apply Rmult_le_compat_l.
  assert (B * t <= B * T) by now apply Rmult_le_compat_l.
  assert (PP : P <= p) by lra. assert (pa : p <= alpha) by lra.
  assert (qe : q' * p = e * (1 - A * t)).
  { unfold q', next_q. fold p. rewrite Se. field. lra. }
  assert (QE : Q' * P = e * (1 - A * T)).
  { unfold Q', next_q. fold P. rewrite SE. field. lra. }
  assert (ke : 2 * kappa' * p ^ 2 = t * (2 * q + B * t)).
  { unfold kappa', next_kappa. fold p t. field. lra. }
  assert (KE' : 2 * K' * P ^ 2 = T * (2 * Q + B * T)).
  { unfold K', next_kappa. fold P T. field. lra. }
  assert (q0 : 0 < q').
  { unfold q', next_q. fold p. rewrite Se. apply Rdiv_lt_0_compat; [now apply Rmult_lt_0_compat | lra]. }
  assert (k0 : 0 < kappa').
  { unfold kappa', next_kappa. fold p t. assert (0 < p ^ 2) by (apply pow_lt; lra). apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  assert (KK' : t * (1 - A * t / 2) <= T * (1 - A * T / 2)) by lra.
  rewrite pe in qe, ke. rewrite PE in QE, KE', P0.
  split; [lra|]. split; [exact pa|]. rewrite pe, PE, Ke, KE.
  split; [|split; [split; [trivial|]|split; [split; [trivial|]|split]]].
  - now apply (Almost.under_p alpha e A B q t q' kappa' Q T Q' K').
  - now apply (Almost.under_x_ alpha e A B q t q' kappa' Q T Q' K').
  - now apply (Almost.under_v_ alpha e A B q t q' kappa' Q T Q' K').
  - now apply (Almost.under_ratio alpha e A B q t q' kappa' Q T Q' K').
  - now apply (Almost.under_apart alpha e A B q t q' kappa' Q T Q' K').
Qed.
End TwoStates.
Theorem order_holds : order_theorem.
Proof.
  intros alpha e A B q kappa Q K L p P q' Q' kappa' K'.
  destruct (ordered _ _ _ _ _ _ _ _ L) as ([P0 PP] & _ & G & X & [V0 V] & R & D).
  destruct L as (_ & _ & _ & _ & _ & [K0 KK] & _). fold p P q' Q' kappa' K' in P0, PP, G, X, V0, V, R, D.
  assert (0 < p ^ 2) by (apply pow_lt; lra).
  split; [lra|]. split; [exact G|]. split; [exact X|]. split; [lra|]. split.
  - apply quotient_at_most; [lra|]. replace (kappa / K * (P / p) ^ 2 * K') with (kappa * K' * P ^ 2 / (K * p ^ 2))
      by (field; lra).
    apply quotient_at_least; [apply Rmult_lt_0_compat|]; lra.
  - apply quotient_at_most; [apply Rmult_lt_0_compat; lra | exact D].
Qed.

(* --- two orbits ----------------------------------------------------------------------------------------- *)

Theorem growth_holds : growth_theorem.
Proof.
  intros alpha e A B q kappa Q K m l M c L S [M0 MM] LK PM C0 C1 C2 x.
  destruct (ordered _ _ _ _ _ _ _ _ L) as ([P0 PP] & _ & G & X & [V0 V] & R & _).
  destruct L as (_ & _ & _ & _ & [Q0 QQ] & [K0 _] & _).
  apply quotient_at_least; [exact V0|]. rewrite Rmult_comm.
  assert (x0 : 0 < x).
  { assert (1 < K / kappa); [|unfold x; lra]. apply Rmult_lt_reg_r with kappa; trivial. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l; lra. }
  apply (Almost.spread_expands kappa K (p_ alpha A B q kappa) (p_ alpha A B Q K) _ _ (Q - q) x m l M c); trivial.
  - unfold x. field. lra.
  - lra.
  - apply Rle_trans with (2 := G), Rplus_le_compat_r, Rmult_le_compat_r; lra.
Qed.
Theorem beneath_holds : beneath_theorem.
Proof.
  intros alpha e A B q kappa Q K m c L W [M0 MM] [C0 CK] [LL L1].
  destruct (ordered _ _ _ _ _ _ _ _ W) as ([P0 PP] & PA & G & X & [V0 V] & R & _).
  destruct W as (A0 & _ & _ & _ & [Q0 QQ] & [K0 KK] & _).
  set (p := p_ alpha A B q kappa) in *. set (P := p_ alpha A B Q K) in *.
  set (v := next_kappa alpha A B q kappa) in *. set (V' := next_kappa alpha A B Q K) in *.
  assert (KE : kappa / K * K = kappa) by (field; lra).
  apply quotient_at_most; [lra|]. apply Rmult_le_reg_l with alpha; trivial.
  replace (alpha * ((1 - m * (1 - L) * c / alpha) * (kappa / K) * V')) with
    ((alpha - m * (1 - L) * c) * (kappa / K) * V') by (field; lra).
  apply (Almost.beneath_falls (kappa / K) K p P v V' alpha m c L); rewrite ?KE; trivial.
  - apply Rdiv_lt_0_compat; lra.
  - lra.
  - lra.
  - apply Rle_trans with (2 := G). assert (m * (K - kappa) <= (alpha * A + B) * (K - kappa)); [|lra].
    apply Rmult_le_compat_r; lra.
Qed.
Theorem two_orbits_hold : two_orbits_theorem.
Proof.
  intros c K g x D Y H [C0 C1] K1 G0 G x0 D0 Y0 H0 Step.
  assert (P : 0 <= 4 * K / c) by (apply Rlt_le, Rdiv_lt_0_compat; lra).
  assert (P' : 0 <= c / 4 / K) by (apply Rlt_le, Rdiv_lt_0_compat; lra).
  assert (All : forall n, x O * (1 + c / 2) ^ n <= x n /\ 0 < x n /\ 0 <= D n /\ D n <= 4 * K / c * x n /\
    Y n <= 4 * K / c * x n /\ 0 <= H n /\ H n <= c / 4 / K * x n).
  { induction n as [|n (X & X0 & I0 & I1 & I2 & I3 & I4)].
    - rewrite D0, Y0, H0. cbn [pow]. assert (0 <= 4 * K / c * x O) by (apply Rmult_le_pos; lra).
      assert (0 <= c / 4 / K * x O) by (apply Rmult_le_pos; lra). repeat split; lra.
    - destruct (Step n) as (S1 & S2 & S3 & S4 & S5 & S6). assert (0 < K) by lra.
      assert (N : x n + 1 / 2 * c * (x n + D n) <= x (S n))
        by now apply (Almost.next_x c K g (x n) (D n) (Y n) (H n) (x (S n)) (D (S n)) (Y (S n)) (H (S n))).
      assert (0 <= c * D n) by (apply Rmult_le_pos; lra).
      assert (0 <= c * x n) by (apply Rmult_le_pos; lra).
      split; [|split; [lra|split; [|split; [|split; [|split; [exact S5|]]]]]].
      + cbn [pow]. assert (0 <= (1 + c / 2) * (x n - x O * (1 + c / 2) ^ n)) by (apply Rmult_le_pos; lra). lra.
      + now apply (Almost.next_D c K g (x n) (D n) (Y n) (H n) (x (S n)) (D (S n)) (Y (S n)) (H (S n))).
      + now apply (Almost.next_D_most c K g (x n) (D n) (Y n) (H n) (x (S n)) (D (S n)) (Y (S n)) (H (S n))).
      + now apply (Almost.next_Y_most c K g (x n) (D n) (Y n) (H n) (x (S n)) (D (S n)) (Y (S n)) (H (S n))).
      + now apply (Almost.next_H_most c K g (x n) (D n) (Y n) (H n) (x (S n)) (D (S n)) (Y (S n)) (H (S n))). }
  intros n. destruct (All n) as (X & _ & I & _). now split.
Qed.

(* --- kappa falls, or stays away from 0 ------------------------------------------------------------------ *)

Theorem turn_holds : turn_theorem.
Proof.
  intros a a' e f q p q' p' q'' p'' z E0 P0 P1 P2.
  assert (Z : z = a * a' - e - a' * q).
  { transitivity (a' * p - e); [unfold z, p', q'; field; lra | unfold p; ring]. }
  assert (Z0 : 0 < z) by now apply Rmult_lt_0_compat.
  pose proof Z0 as Z1. rewrite Z in Z1. split.
  - pose proof (Almost.turn_factor a a' e f q E0 P0 Z1) as F. rewrite <- Z in F. change (a - q) with p in F.
    transitivity (q * (e / p) * (z + e) / ((z + e) * z ^ 2)); [unfold z, q'; field | rewrite F; reflexivity].
    repeat split; first [lra | fold z; lra].
  - pose proof (Almost.turn_next a a' e f q E0 P0 Z1) as N. rewrite <- Z in N. change (a - q) with p in N.
    unfold next_z. rewrite <- N. transitivity (a' * p'' - e); [field; lra|]. unfold p'', q'', z. field. lra.
Qed.
(* The factor in terms without a division. *)
Lemma factor_is e D z : 0 < e -> 0 < z -> factor e D z * ((z + e) * z ^ 2) = e * (D - e - z).
Proof. intros. unfold factor. field. lra. Qed.
Lemma size e z : 0 < e -> 0 < z -> 0 < (z + e) * z ^ 2.
Proof. intros. apply Rmult_lt_0_compat; [lra | now apply pow_lt]. Qed.
Lemma factor_falls e D z z' : 0 < e -> 0 < z <= z' -> factor e D z' <= Rmax 0 (factor e D z).
Proof.
  intros E0 [Z0 ZZ]. pose proof (size e z E0 Z0) as P. pose proof (size e z' E0 ltac:(lra)) as P'.
  destruct (Rle_dec (D - e - z') 0) as [N|N].
  - apply Rle_trans with (2 := Rmax_l _ _), quotient_at_most; [exact P'|]. rewrite Rmult_0_l.
    assert (0 <= e * - (D - e - z')) by (apply Rmult_le_pos; lra). lra.
  - apply Rle_trans with (2 := Rmax_r _ _), quotient_at_most; [exact P'|].
    assert (0 < factor e D z).
    { apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | exact P]. }
    apply Rle_trans with (e * (D - e - z)); [apply Rmult_le_compat_l; lra|].
    rewrite <- (factor_is e D z) by lra. apply Rmult_le_compat_l; [lra|].
    apply Rmult_le_compat; [lra | apply pow2_ge_0 | lra | apply pow_incr; lra].
Qed.
Theorem trap_holds : trap_theorem.
Proof.
  intros e f t D h E0 F0 T0 H0 TE L HE.
  assert (HI : e * (D - e - h) = (h + e) * h ^ 2) by (rewrite <- factor_is by lra; rewrite HE; ring).
  pose proof (Almost.trap_high e f t D h E0 T0 H0 TE HI L) as H1.
  pose proof (Almost.trap_rises e f t D h E0 T0 H0 TE HI L) as H2.
  set (h' := next_z e f D h). change (h < h') in H2. split; [now split|].
  exists (Rmax 0 (factor e D h')).
  assert (R : factor e D h' < 1).
  { pose proof (Almost.inside_falls e f D h' h E0 F0 H0 H2 HI) as I. pose proof (size e h' E0 ltac:(lra)) as P.
    rewrite <- factor_is in I by lra. apply Rmult_lt_reg_r with (1 := P). lra. }
  pose proof (Rmax_l 0 (factor e D h')) as M. split; [split; [exact M | apply Rmax_lub_lt; lra]|].
  intros z kappa Z0 Step Once.
  assert (First : h <= z O).
  { destruct (Step O) as (K0 & _ & K1). apply (Almost.record_place e D (z O) h E0 Z0 H0 HI).
    rewrite <- factor_is by lra. rewrite <- (Rmult_1_l ((z O + e) * z O ^ 2)) at 2.
    apply Rmult_le_compat_r; [apply Rlt_le; now apply size|]. apply Rmult_le_reg_r with (1 := K0). lra. }
  assert (Rises : forall n, h <= z n -> h' <= z (S n)).
  { intros n [N|N]; destruct (Step n) as (_ & -> & _); [|rewrite <- N; apply Rle_refl].
    exact (Almost.inside_keeps e f D (z n) h E0 F0 H0 N HI). }
  assert (Stays : forall n, h <= z n) by (induction n as [|n I]; [|apply Rises in I]; lra).
  intros n. split; [apply Stays|]. induction n as [|n IH]; [cbn [pow]; lra|].
  destruct (Step (S n)) as (K0 & _ & ->). cbn [pow]. set (rho := Rmax 0 (factor e D h')) in *.
  apply Rle_trans with (rho * kappa (S n)).
  - apply Rmult_le_compat_r; [lra|]. apply factor_falls; [exact E0|]. pose proof (Rises n (Stays n)). lra.
  - assert (0 <= rho * (kappa 1%nat * rho ^ n - kappa (S n))) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem threshold_holds : threshold_theorem.
Proof.
  intros e f t z E0 T0 Z0 TE D. pose proof (size e z E0 Z0) as P.
  assert (N : next_z e f D z = t + t ^ 2 - e * f / z) by (unfold next_z, D; ring).
  assert (F : e * (D - e - z) = e * (f + t + t ^ 2 - z)) by (unfold D; ring).
  rewrite N. split; intros Z; split.
  - exact (Almost.level_next e f t z E0 T0 TE Z).
  - apply quotient_at_least; [exact P|]. rewrite F. apply Rle_trans with (2 := Almost.level_factor e f t z E0 T0 TE Z).
    apply Req_le. field. lra.
  - exact (Almost.low_next e f t z E0 T0 TE Z0 Z).
  - apply quotient_at_least; [exact P|]. rewrite F, Rmult_1_l. exact (Almost.low_factor e f t z E0 T0 TE Z0 Z).
Qed.
Theorem stays_holds : stays_theorem.
Proof.
  intros t m L kappa x eps T0 M0 L0 Step W W1.
  set (weight := fun n => (L * x n + (1 - t + L) / (1 - m) * eps n) / (1 - t)). change (weight O < 1) in W1.
  assert (All : forall n, weight n < 1 /\ kappa O * (1 - weight O) <= kappa n * (1 - weight n)).
  { induction n as [|n [I1 I2]]; [split; [exact W1 | apply Rle_refl]|].
    destruct (Step n) as (K0 & X0 & N0 & X & N & K). destruct (Step (S n)) as (K1 & X1 & N1 & _).
    assert (G : kappa n * (1 - weight n) <= kappa (S n) * (1 - weight (S n))).
    { apply (Almost.weigh_keeps (kappa n) (kappa (S n)) (x n) (x (S n)) (eps n) (eps (S n)) t m L);
        trivial; try lra; unfold weight; field; lra. }
    split; [|lra]. assert (0 < kappa n * (1 - weight n)) by (apply Rmult_lt_0_compat; lra).
    apply Rnot_le_lt. intros B. assert (0 <= kappa (S n) * - (1 - weight (S n))) by (apply Rmult_le_pos; lra). lra. }
  intros n. destruct (All n) as [_ G]. change W with (weight O). apply Rle_trans with (1 := G).
  destruct (Step n) as (K0 & X0 & N0 & _).
  assert (0 <= weight n).
  { apply Rmult_le_pos; [|apply Rlt_le, Rinv_0_lt_compat; lra].
    apply Rplus_le_le_0_compat; apply Rmult_le_pos; try lra. apply Rmult_le_pos; [lra|].
    apply Rlt_le, Rinv_0_lt_compat. lra. }
  assert (0 <= kappa n * weight n) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem alexander : collision_theorem /\ order_theorem /\ growth_theorem /\ beneath_theorem /\
  two_orbits_theorem /\ turn_theorem /\ trap_theorem /\ threshold_theorem /\ stays_theorem.
Proof.
  exact (conj collision_holds (conj order_holds (conj growth_holds (conj beneath_holds (conj two_orbits_hold
    (conj turn_holds (conj trap_holds (conj threshold_holds stays_holds)))))))).
Qed.
Print Assumptions alexander.
