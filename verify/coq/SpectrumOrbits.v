(* Eigenvectors of the printed matrix, the parameter m, and what becomes of orbits. *)
From Coq Require Import Reals Lra Lia Psatz.
From Verify Require Import Theorem1 Vectors Motion Contacts Settling Spectrum SpectrumMatrix SpectrumRoots.
Open Scope R_scope.

Theorem eigenvectors : eigenvector_theorem.
Proof.
  intros r mu E. set (h := (1 + r) / 4) in *.
  assert (W : eigenvector_of r mu = with_forms r 1 mu (mu ^ 2) 0).
  { unfold eigenvector_of, with_forms. fold h. cbv zeta. pose proof root_positive as P.
    apply same_column; cbn [c_1 c_2 c_3 c_4]; field; lra. }
  rewrite W. destruct (with_forms_are r 1 mu (mu ^ 2) 0) as (F0 & F1 & F2 & FL). set (u := with_forms r 1 mu (mu ^ 2) 0) in *.
  destruct (form_combination r (mu ^ 3) u 0 zero) as (C0 & C1 & C2 & CL).
  destruct (form_zero r) as (Z0 & Z1 & Z2 & ZL). rewrite Z0, F0 in C0. rewrite Z1, F1 in C1. rewrite Z2, F2 in C2. rewrite ZL, FL in CL.
  assert (K0 : form_0 (image r u) = mu ^ 3) by (rewrite image_0, F0, F1, F2; fold h; lra).
  assert (K1 : form_1 r (image r u) = mu ^ 4).
  { rewrite image_1, K0, F1, F2. fold h. assert (G : mu * (mu ^ 3 + h * mu ^ 2 + h * mu + r) = 0) by (rewrite E; ring). lra. }
  apply (by_forms r).
  - rewrite C0, K0. ring.
  - rewrite C1, K1. ring.
  - rewrite C2, image_2, K0, K1, F2. fold h.
    assert (G : mu ^ 2 * (mu ^ 3 + h * mu ^ 2 + h * mu + r) = 0) by (rewrite E; ring). lra.
  - rewrite CL, image_l, FL. ring.
Qed.

(* --- the parameter -------------------------------------------------------------------------------- *)

Lemma denominator m : 0 < m ^ 2 - m + 4.
Proof. nra. Qed.
Lemma r_of_rises m n : 0 < m -> m < n -> n < 1 -> r_of m < r_of n.
Proof.
  intros M N L. unfold r_of. pose proof (denominator m) as P. pose proof (denominator n) as P'.
  apply Rmult_lt_reg_r with ((m ^ 2 - m + 4) * (n ^ 2 - n + 4)); [now apply Rmult_lt_0_compat|].
  replace (m * (4 * m ^ 2 - m + 1) / (m ^ 2 - m + 4) * ((m ^ 2 - m + 4) * (n ^ 2 - n + 4)))
    with (m * (4 * m ^ 2 - m + 1) * (n ^ 2 - n + 4)) by (field; lra).
  replace (n * (4 * n ^ 2 - n + 1) / (n ^ 2 - n + 4) * ((m ^ 2 - m + 4) * (n ^ 2 - n + 4)))
    with (n * (4 * n ^ 2 - n + 1) * (m ^ 2 - m + 4)) by (field; lra).
  assert (E : n * (4 * n ^ 2 - n + 1) * (m ^ 2 - m + 4) - m * (4 * m ^ 2 - m + 1) * (n ^ 2 - n + 4) =
    (n - m) * (4 * m ^ 2 * n ^ 2 - 4 * m * n * (m + n) + 16 * (m ^ 2 + m * n + n ^ 2) - 4 * (m + n) + 4)) by ring.
  assert (0 < 4 * m ^ 2 * n ^ 2 - 4 * m * n * (m + n) + 16 * (m ^ 2 + m * n + n ^ 2) - 4 * (m + n) + 4).
  { assert (m * n < 1 * 1) by (apply Rmult_le_0_lt_compat; lra).
    assert (0 <= m * n * (m + n)) by (repeat apply Rmult_le_pos; lra).
    assert (m * n * (m + n) <= 1 * (m + n)) by (apply Rmult_le_compat_r; lra). nra. }
  assert (0 < (n - m) * (4 * m ^ 2 * n ^ 2 - 4 * m * n * (m + n) + 16 * (m ^ 2 + m * n + n ^ 2) - 4 * (m + n) + 4))
    by (apply Rmult_lt_0_compat; lra). lra.
Qed.
Theorem parameter : parameter_theorem.
Proof.
  intros r R0. set (f := fun m => m * (4 * m ^ 2 - m + 1) - r * (m ^ 2 - m + 4)).
  assert (C : continuity f) by (unfold f; reg).
  destruct (IVT f 0 1 C ltac:(lra)) as (m & (M1 & M2) & E); [unfold f; lra | unfold f; lra|].
  assert (m0 : 0 < m) by (destruct M1 as [M1|<-]; [exact M1 | unfold f in E; lra]).
  assert (m1 : m < 1) by (destruct M2 as [M2| ->]; [exact M2 | unfold f in E; lra]).
  pose proof (denominator m) as P.
  assert (RM : r_of m = r).
  { unfold r_of. apply Rmult_eq_reg_r with (m ^ 2 - m + 4); [|lra]. unfold f in E.
    replace (m * (4 * m ^ 2 - m + 1) / (m ^ 2 - m + 4) * (m ^ 2 - m + 4)) with (m * (4 * m ^ 2 - m + 1)) by (field; lra). lra. }
  exists m. split; [lra|]. split; [exact RM|]. split.
  - rewrite <- RM. unfold Q, r_of. field. lra.
  - intros n N RN. destruct (Rtotal_order n m) as [L|[L|L]]; [|exact L|].
    + pose proof (r_of_rises n m ltac:(lra) L m1). lra.
    + pose proof (r_of_rises m n m0 L ltac:(lra)). lra.
Qed.

Lemma small_discriminant m : 0 < m < 1 ->
  (m ^ 2 - 4 * m + 1) * (m ^ 2 - 4 * m + 1) < 4 * (4 * m ^ 2 - m + 1) * (m ^ 2 - m + 4).
Proof.
  intros M. pose proof (Rle_0_sqr (m - 1 / 2)) as P1. pose proof (Rle_0_sqr (2 * m - 1 / 4)) as P2.
  assert (P3 : 0 <= m * (1 - m)) by (apply Rmult_le_pos; lra). pose proof (Rle_0_sqr (1 - m)) as P4. unfold Rsqr in *.
  set (a := m ^ 2 - 4 * m + 1). set (b := 4 * m ^ 2 - m + 1). set (c := m ^ 2 - m + 4).
  assert (A : -2 <= a <= 1) by (unfold a; lra). assert (B : 15 / 16 <= b) by (unfold b; lra).
  assert (C : 15 / 4 <= c) by (unfold c; lra). clearbody a b c.
  assert (a * a <= 4) by nra. assert (15 / 16 * (15 / 4) <= b * c) by (apply Rmult_le_compat; lra). lra.
Qed.

(* --- orbits --------------------------------------------------------------------------------------- *)

(* The normal components of an orbit, one after the other, are a sequence that decays. *)
Section Decay.
Variables r m : R.
Hypothesis m_range : 0 < m < 1.
Hypothesis r_is : r_of m = r.
Let h := (1 + r) / 4.
Let e := (m ^ 2 - 4 * m + 1) / (m ^ 2 - m + 4).
Let s := (4 * m ^ 2 - m + 1) / (m ^ 2 - m + 4).
Lemma h_is : h = e + m.
Proof. unfold h, e. rewrite <- r_is. unfold r_of. field. pose proof (denominator m). lra. Qed.
Lemma h_is_too : h = e * m + s.
Proof. unfold h, e, s. rewrite <- r_is. unfold r_of. field. pose proof (denominator m). lra. Qed.
Lemma r_is_too : r = s * m.
Proof. rewrite <- r_is. unfold r_of, s. field. pose proof (denominator m). lra. Qed.
Lemma s_range : 0 < s < 1 /\ e * e < 4 * s.
Proof.
  pose proof (denominator m) as P. assert (S : s * (m ^ 2 - m + 4) = 4 * m ^ 2 - m + 1) by (unfold s; field; lra).
  assert (E : e * (m ^ 2 - m + 4) = m ^ 2 - 4 * m + 1) by (unfold e; field; lra).
  split; [split|].
  - unfold s. apply Rdiv_lt_0_compat; [nra | exact P].
  - apply Rmult_lt_reg_r with (m ^ 2 - m + 4); [exact P|]. rewrite S. nra.
  - apply Rmult_lt_reg_r with ((m ^ 2 - m + 4) * (m ^ 2 - m + 4)); [now apply Rmult_lt_0_compat|].
    replace (e * e * ((m ^ 2 - m + 4) * (m ^ 2 - m + 4))) with ((e * (m ^ 2 - m + 4)) * (e * (m ^ 2 - m + 4))) by ring.
    replace (4 * s * ((m ^ 2 - m + 4) * (m ^ 2 - m + 4))) with (4 * (s * (m ^ 2 - m + 4)) * (m ^ 2 - m + 4)) by ring.
    rewrite E, S. apply small_discriminant; exact m_range.
Qed.
Variable c : nat -> R.
Hypothesis law : forall k, c (S (S (S k))) = - h * c (S (S k)) - h * c (S k) - r * c k.
Let psi k := s * c k + e * c (S k) + c (S (S k)).
Lemma psi_next k : psi (S k) = - m * psi k.
Proof.
  unfold psi. rewrite law. pose proof h_is as H1. pose proof h_is_too as H2.
  replace (- h * c (S (S k)) - h * c (S k) - r * c k) with
    (- (e + m) * c (S (S k)) - (e * m + s) * c (S k) - s * m * c k)
    by (rewrite <- H1, <- H2, <- r_is_too; reflexivity). ring.
Qed.
Lemma psi_is k : Rabs (psi k) = m ^ k * Rabs (psi 0).
Proof.
  induction k as [|k IH]; [simpl; ring|]. rewrite psi_next, Rabs_mult, Rabs_Ropp, (Rabs_right m) by lra. rewrite IH. simpl. ring.
Qed.
Let norm x y := y * y + e * x * y + s * (x * x).
Lemma norm_least x y : (s - e * e / 4) * (x * x) <= norm x y.
Proof. unfold norm. pose proof (Rle_0_sqr (y + e / 2 * x)) as Q. unfold Rsqr in Q. lra. Qed.
Lemma norm_positive x y : 0 <= norm x y.
Proof.
  apply Rle_trans with (2 := norm_least x y). destruct s_range as (_ & E).
  apply Rmult_le_pos; [lra | apply Rle_0_sqr].
Qed.
Lemma norm_next k : sqrt (norm (c (S k)) (c (S (S k)))) <= sqrt s * sqrt (norm (c k) (c (S k))) + Rabs (psi k).
Proof.
  destruct s_range as ((S0 & S1) & E). set (x := c k). set (y := c (S k)). set (z := - e * y - s * x).
  assert (Z : c (S (S k)) = z + psi k) by (unfold psi, z, x, y; ring). rewrite Z. set (p := psi k).
  assert (NZ : norm y z = s * norm x y) by (unfold norm, z; ring).
  pose proof (norm_positive x y) as P. pose proof (Rabs_pos p) as Pp. pose proof (sqrt_pos s). pose proof (sqrt_pos (norm x y)).
  assert (RHS : 0 <= sqrt s * sqrt (norm x y) + Rabs p).
  { assert (0 <= sqrt s * sqrt (norm x y)) by (apply Rmult_le_pos; assumption). lra. }
  rewrite <- (sqrt_square (sqrt s * sqrt (norm x y) + Rabs p)) by exact RHS. apply sqrt_le_1_alt.
  assert (SS : sqrt s * sqrt s = s) by (apply sqrt_sqrt; lra).
  assert (NN : sqrt (norm x y) * sqrt (norm x y) = norm x y) by (apply sqrt_sqrt; exact P).
  assert (PP : Rabs p * Rabs p = p * p) by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr).
  replace ((sqrt s * sqrt (norm x y) + Rabs p) * (sqrt s * sqrt (norm x y) + Rabs p)) with
    ((sqrt s * sqrt s) * (sqrt (norm x y) * sqrt (norm x y)) + 2 * (sqrt s * sqrt (norm x y)) * Rabs p + Rabs p * Rabs p) by ring.
  rewrite SS, NN, PP. replace (norm y (z + p)) with (norm y z + p * (2 * z + e * y) + p * p) by (unfold norm; ring). rewrite NZ.
  assert (B : Rabs (2 * z + e * y) <= 2 * (sqrt s * sqrt (norm x y))).
  { assert (W : 0 <= sqrt s * sqrt (norm x y)) by (apply Rmult_le_pos; assumption).
    apply Rsqr_incr_0_var; [|lra].
    rewrite <- Rsqr_abs. unfold Rsqr.
    replace (2 * (sqrt s * sqrt (norm x y)) * (2 * (sqrt s * sqrt (norm x y)))) with
      (4 * ((sqrt s * sqrt s) * (sqrt (norm x y) * sqrt (norm x y)))) by ring. rewrite SS, NN, <- NZ.
    unfold norm. assert (0 <= (4 * s - e * e) * (y * y)) by (apply Rmult_le_pos; [lra | apply Rle_0_sqr]). lra. }
  assert (p * (2 * z + e * y) <= 2 * (sqrt s * sqrt (norm x y)) * Rabs p); [|lra].
  apply Rle_trans with (1 := Rle_abs _). rewrite Rabs_mult, Rmult_comm. apply Rmult_le_compat_r; assumption.
Qed.
Variable q : R.
Hypothesis q_range : m < q < 1.
Hypothesis q_root : sqrt s < q.
Lemma decays : exists K, forall k, Rabs (c k) <= K * q ^ k.
Proof.
  destruct s_range as ((S0 & S1) & E). set (b := s - e * e / 4). assert (b0 : 0 < b) by (unfold b; lra).
  pose proof (sqrt_pos s) as Ps.
  set (K := Rmax (sqrt (norm (c 0%nat) (c 1%nat))) (Rabs (psi 0) / (q - sqrt s))).
  assert (K1 : sqrt (norm (c 0%nat) (c 1%nat)) <= K) by apply Rmax_l.
  assert (K2 : Rabs (psi 0) <= K * (q - sqrt s)).
  { replace (Rabs (psi 0)) with (Rabs (psi 0) / (q - sqrt s) * (q - sqrt s)) by (field; lra).
    apply Rmult_le_compat_r; [lra | apply Rmax_r]. }
  assert (G : forall k, sqrt (norm (c k) (c (S k))) <= K * q ^ k).
  { induction k as [|k IH]; [simpl; lra|]. apply Rle_trans with (1 := norm_next k). rewrite psi_is.
    assert (MQ : m ^ k <= q ^ k) by (apply pow_incr; lra). pose proof (Rabs_pos (psi 0)).
    pose proof (pow_lt q k ltac:(lra)) as QP.
    assert (A1 : sqrt s * sqrt (norm (c k) (c (S k))) <= sqrt s * (K * q ^ k)) by (apply Rmult_le_compat_l; assumption).
    assert (A2 : m ^ k * Rabs (psi 0) <= q ^ k * (K * (q - sqrt s))).
    { apply Rmult_le_compat; [apply pow_le; lra | apply Rabs_pos | exact MQ | exact K2]. }
    simpl. lra. }
  exists (K / sqrt b). intros k. pose proof (sqrt_lt_R0 b b0) as SB.
  apply Rmult_le_reg_l with (sqrt b); [exact SB|].
  replace (sqrt b * (K / sqrt b * q ^ k)) with (K * q ^ k) by (field; lra). apply Rle_trans with (2 := G k).
  rewrite <- (sqrt_square (Rabs (c k))) by apply Rabs_pos. rewrite <- sqrt_mult; [| lra | apply Rle_0_sqr].
  apply sqrt_le_1_alt. replace (Rabs (c k) * Rabs (c k)) with (c k * c k).
  - apply norm_least.
  - rewrite <- Rabs_mult. symmetry. apply Rabs_right, Rle_ge, Rle_0_sqr.
Qed.
End Decay.

Lemma form_l_orbit r u n : form_l (orbit r u n) = form_l u.
Proof. induction n as [|n IH]; cbn [orbit]; [reflexivity | now rewrite image_l]. Qed.
(* The sequence of all normal components of an orbit. *)
Definition component (r : R) (u : column) (k : nat) : R :=
  let v := orbit r u (Nat.div k 3) in
  match Nat.modulo k 3 with O => form_0 v | S O => form_1 r v | _ => form_2 r v end.
Lemma component_0 r u n : component r u (3 * n) = form_0 (orbit r u n).
Proof. unfold component. rewrite Nat.mul_comm, Nat.div_mul, Nat.mod_mul by lia. reflexivity. Qed.
Lemma component_1 r u n : component r u (S (3 * n)) = form_1 r (orbit r u n).
Proof.
  unfold component. replace (S (3 * n)) with (1 + n * 3)%nat by lia.
  rewrite Nat.div_add, Nat.mod_add by lia. reflexivity.
Qed.
Lemma component_2 r u n : component r u (S (S (3 * n))) = form_2 r (orbit r u n).
Proof.
  unfold component. replace (S (S (3 * n))) with (2 + n * 3)%nat by lia.
  rewrite Nat.div_add, Nat.mod_add by lia. reflexivity.
Qed.
Lemma component_law r u k : component r u (S (S (S k))) = - ((1 + r) / 4) * component r u (S (S k)) -
  (1 + r) / 4 * component r u (S k) - r * component r u k.
Proof.
  pose proof (Nat.div_mod k 3 ltac:(lia)) as E. set (n := Nat.div k 3) in *.
  pose proof (Nat.mod_upper_bound k 3 ltac:(lia)) as B.
  destruct (Nat.modulo k 3) as [|[|[|j]]]; [| | |lia].
  - replace k with (3 * n)%nat by lia. replace (S (S (S (3 * n)))) with (3 * S n)%nat by lia.
    rewrite component_0, component_0, component_1, component_2. cbn [orbit]. apply image_0.
  - replace k with (S (3 * n)) by lia. replace (S (S (S (S (3 * n))))) with (S (3 * S n)) by lia.
    replace (S (S (S (3 * n)))) with (3 * S n)%nat by lia.
    rewrite component_0, component_1, component_1, component_2. cbn [orbit]. apply image_1.
  - replace k with (S (S (3 * n))) by lia. replace (S (S (S (S (S (3 * n)))))) with (S (S (3 * S n))) by lia.
    replace (S (S (S (S (3 * n))))) with (S (3 * S n)) by lia. replace (S (S (S (3 * n)))) with (3 * S n)%nat by lia.
    rewrite component_0, component_1, component_2, component_2. cbn [orbit]. apply image_2.
Qed.
Theorem orbits : orbit_theorem.
Proof.
  intros r R0. destruct (parameter r R0) as (m & M & RM & _).
  destruct (s_range m M) as ((S0 & S1) & _). set (s := (4 * m ^ 2 - m + 1) / (m ^ 2 - m + 4)) in *.
  assert (RS : sqrt s < 1) by (rewrite <- sqrt_1; apply sqrt_lt_1; lra).
  set (t := Rmax m (sqrt s)). assert (T1 : m <= t) by apply Rmax_l. assert (T2 : sqrt s <= t) by apply Rmax_r.
  assert (T3 : t < 1) by (unfold t; apply Rmax_lub_lt; lra). set (q := (1 + t) / 2).
  assert (Q1 : t < q < 1) by (unfold q; lra).
  exists (q ^ 3). split.
  { split; [apply pow_lt; lra|]. assert (q * q < 1 * 1) by (apply Rmult_le_0_lt_compat; lra).
    assert (q * q * q < 1 * 1) by (apply Rmult_le_0_lt_compat; try lra; apply Rmult_le_pos; lra). simpl. lra. }
  intros u. destruct (decays r m M RM (component r u) (component_law r u) q ltac:(lra) ltac:(fold s; lra)) as (K & D).
  assert (K0 : 0 <= K).
  { specialize (D 0%nat). pose proof (Rabs_pos (component r u 0)). simpl in D. lra. }
  exists (form_l u / (2 * sqrt 3)), (10 * K). intros n. pose proof root_positive as P3. pose proof three as T33.
  assert (PW : (q ^ 3) ^ n = q ^ (3 * n)) by (rewrite pow_mult; reflexivity). rewrite PW.
  set (Z := K * q ^ (3 * n)). assert (Z0 : 0 <= Z) by (apply Rmult_le_pos; [exact K0 | apply pow_le; lra]).
  pose proof (pow_le q (3 * n) ltac:(lra)) as QN.
  assert (D0 : Rabs (form_0 (orbit r u n)) <= Z) by (rewrite <- component_0; apply D).
  assert (D1 : Rabs (form_1 r (orbit r u n)) <= Z).
  { rewrite <- component_1. apply Rle_trans with (1 := D _). unfold Z. simpl pow at 1.
    apply Rmult_le_compat_l; [exact K0|]. apply Rle_trans with (1 * q ^ (3 * n)); [apply Rmult_le_compat_r; lra | lra]. }
  assert (D2 : Rabs (form_2 r (orbit r u n)) <= Z).
  { rewrite <- component_2. apply Rle_trans with (1 := D _). unfold Z. change (q ^ S (S (3 * n))) with (q * (q * q ^ (3 * n))).
    apply Rmult_le_compat_l; [exact K0|]. apply Rle_trans with (1 * (1 * q ^ (3 * n))); [|lra].
    apply Rmult_le_compat; try lra; [apply Rmult_le_pos; lra | apply Rmult_le_compat_r; lra]. }
  pose proof (form_l_orbit r u n) as DL. set (v := orbit r u n) in *.
  assert (RA : forall x, Rabs x <= Z -> - Z <= x <= Z) by (intros x; unfold Rabs; destruct Rcase_abs; lra).
  apply RA in D0. apply RA in D1. apply RA in D2. replace (10 * K * q ^ (3 * n)) with (10 * Z) by (unfold Z; ring).
  unfold form_0 in D0. unfold form_1 in D1. unfold form_2, form_1 in D2. unfold form_l in DL.
  assert (HR : - Z <= (1 + r) / 4 * c_1 v <= Z).
  { assert (0 < (1 + r) / 4 < 1) by lra. set (hh := (1 + r) / 4) in *. split.
    - apply Rle_trans with (hh * - Z); [|apply Rmult_le_compat_l; lra].
      assert (hh * Z <= 1 * Z) by (apply Rmult_le_compat_r; lra). lra.
    - apply Rle_trans with (hh * Z); [apply Rmult_le_compat_l; lra|].
      assert (hh * Z <= 1 * Z) by (apply Rmult_le_compat_r; lra). lra. }
  assert (C3 : - (2 * Z) <= c_3 v <= 2 * Z) by lra.
  assert (HR1 : - Z <= (1 + r) / 4 * (c_3 v - (1 + r) / 4 * c_1 v) <= Z).
  { assert (0 < (1 + r) / 4 < 1) by lra. set (hh := (1 + r) / 4) in *. set (w := c_3 v - hh * c_1 v) in *. split.
    - apply Rle_trans with (hh * - Z); [|apply Rmult_le_compat_l; lra].
      assert (hh * Z <= 1 * Z) by (apply Rmult_le_compat_r; lra). lra.
    - apply Rle_trans with (hh * Z); [apply Rmult_le_compat_l; lra|].
      assert (hh * Z <= 1 * Z) by (apply Rmult_le_compat_r; lra). lra. }
  assert (S3 : 3 / 2 < sqrt 3 < 2).
  { split; apply Rnot_le_lt; intros F.
    - assert (sqrt 3 * sqrt 3 <= 3 / 2 * (3 / 2)) by (apply Rmult_le_compat; lra). lra.
    - assert (2 * 2 <= sqrt 3 * sqrt 3) by (apply Rmult_le_compat; lra). lra. }
  set (y := form_l u / (2 * sqrt 3)).
  assert (Y : form_l u = 2 * sqrt 3 * y) by (unfold y; field; lra). unfold form_l in Y. rewrite Y in DL.
  assert (W1 : - (9 * Z) <= sqrt 3 * (c_4 v - c_2 v) <= 9 * Z) by lra.
  assert (W2 : - (3 * Z) <= sqrt 3 * (c_4 v + c_2 v - 2 * y) <= 3 * Z) by lra.
  assert (DIV : forall a b, - (a * Z) <= sqrt 3 * b <= a * Z -> 0 <= a -> - (2 / 3 * a * Z) <= b <= 2 / 3 * a * Z).
  { intros a b A A0. assert (AZ : 0 <= a * Z) by (apply Rmult_le_pos; lra). split; apply Rnot_lt_le; intros F.
    - assert (3 / 2 * - b < sqrt 3 * - b) by (apply Rmult_lt_compat_r; lra). lra.
    - assert (3 / 2 * b < sqrt 3 * b) by (apply Rmult_lt_compat_r; lra). lra. }
  apply DIV in W1; [|lra]. apply DIV in W2; [|lra].
  unfold close_to. cbn [c_1 c_2 c_3 c_4]. repeat split; apply Rabs_le; lra.
Qed.

(* --- one triple ------------------------------------------------------------------------------------- *)

Theorem one_triple : one_triple_theorem.
Proof.
  intros d r s R T A B C.
  set (once := collided d r B0 B1 s) in *. set (twice := collided d r B0 B2 once) in *.
  pose proof (basis d s T) as (HALF & _). cbv zeta in HALF.
  assert (T1 : distance d s B0 B1 = 1) by apply T. assert (T2 : distance d once B0 B2 = 1) by apply T.
  assert (T3 : distance d twice B1 B2 = 1) by apply T.
  assert (E1 : rate d once B0 B1 = - r * rate d s B0 B1) by (apply rate_collided; [discriminate | exact T1]).
  assert (E2 : rate d twice B0 B1 = rate d once B0 B1 - (1 + r) / 4 * rate d once B0 B2).
  { unfold twice. rewrite (other_rate d r B0 B2 B1) by discriminate. change (to once) with (to s).
    rewrite (dot_symmetric d (to s B0 B2)), HALF. field. }
  assert (E3 : rate d (triple d r s) B0 B1 = rate d twice B0 B1 - (1 + r) / 4 * rate d twice B1 B2).
  { unfold triple. fold once. fold twice. rewrite rate_symmetric, (other_rate d r B1 B2 B0) by discriminate.
    rewrite (rate_symmetric d twice B1 B0).
    assert (F : dot d (to twice B1 B2) (to twice B1 B0) = 1 / 2).
    { pose proof (cosines d twice B1 B2 B0) as CO. pose proof (unit_square _ _ _ _ T3) as U3.
      assert (U1 : square d twice B1 B0 = 1) by (rewrite square_symmetric; exact (unit_square _ _ _ _ T1)).
      assert (U2 : square d twice B2 B0 = 1) by (rewrite square_symmetric; exact (unit_square _ _ _ _ T2)).
      lra. }
    rewrite F. field. }
  rewrite E3, E2, E1.
  assert (0 < r * - rate d s B0 B1) by (apply Rmult_lt_0_compat; lra).
  assert (0 < (1 + r) / 4 * - rate d once B0 B2) by (apply Rmult_lt_0_compat; lra).
  assert (0 < (1 + r) / 4 * - rate d twice B1 B2) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
