(* Sentences that the certificate of the spectrum takes on trust, and that are about more than its rows:
   signs, forms and planes, and what a spectral radius says of a recursion. *)
From Coq Require Import Reals Lra Lia Psatz.
From Verify Require Import Spectrum SpectrumMatrix SpectrumRoots SpectrumOrbits.
Open Scope R_scope.

Lemma signs : (forall x y, 0 < x -> 0 < y -> 0 < x + y /\ 0 < x * y) /\ (forall x, 0 <= x * x) /\
  (forall a b x y, 0 < a -> 0 <= b -> x < 0 -> y < 0 -> a * x + b * y < 0) /\
  (forall x y, 0 < x -> 0 < y -> (x < y <-> x * x < y * y)).
Proof.
  split; [intros x y X Y; split; [lra | now apply Rmult_lt_0_compat]|]. split; [exact Rle_0_sqr|]. split.
  - intros a b x y A B X Y. assert (0 < a * - x) by (apply Rmult_lt_0_compat; lra).
    assert (0 <= b * - y) by (apply Rmult_le_pos; lra). lra.
  - intros x y X Y. split; intros H; [apply Rmult_le_0_lt_compat; lra|]. apply Rnot_le_lt. intros L.
    assert (y * y <= x * x) by (apply Rmult_le_compat; lra). lra.
Qed.

(* --- forms and planes ------------------------------------------------------------------------------ *)

(* The left eigenvector for l_0 = - m^3. *)
Definition form_of_root (m : R) (u : column) : R :=
  let r := r_of m in let h := (1 + r) / 4 in r / m * form_0 u + (h - m) * form_1 r u + form_2 r u.
Lemma left_eigenvector m u : 0 < m < 1 -> form_of_root m (image (r_of m) u) = - m ^ 3 * form_of_root m u.
Proof.
  intros M. unfold form_of_root. rewrite image_2, image_1, image_0. unfold r_of. pose proof (denominator m). field. lra.
Qed.
(* The plane of an eigenvector that is not real is in its kernel. *)
Lemma plane_of_the_pair m mu nu u v : 0 < m < 1 -> nu <> 0 -> eigenvector (r_of m) mu nu u v ->
  form_of_root m u = 0 /\ form_of_root m v = 0.
Proof.
  intros M N (_ & U & V). pose proof (left_eigenvector m u M) as A. pose proof (left_eigenvector m v M) as B.
  assert (L : forall a x b y, form_of_root m (combination a x b y) = a * form_of_root m x + b * form_of_root m y).
  { intros a x b y. destruct (form_combination (r_of m) a x b y) as (F0 & F1 & F2 & _). unfold form_of_root.
    rewrite F0, F1, F2. ring. }
  rewrite U, L in A. rewrite V, L in B. set (p := form_of_root m u) in *. set (q := form_of_root m v) in *.
  set (k := mu + m ^ 3). assert (A' : k * p = nu * q) by (unfold k; lra). assert (B' : k * q = - nu * p) by (unfold k; lra).
  assert (D : 0 < k * k + nu * nu).
  { pose proof (Rle_0_sqr k) as K. pose proof (Rsqr_pos_lt nu N) as K2. unfold Rsqr in *. lra. }
  assert (P : (k * k + nu * nu) * p = 0).
  { replace ((k * k + nu * nu) * p) with (k * (k * p) + nu * (nu * p)) by ring. rewrite A'.
    replace (k * (nu * q)) with (nu * (k * q)) by ring. rewrite B'. ring. }
  assert (Q0 : (k * k + nu * nu) * q = 0).
  { replace ((k * k + nu * nu) * q) with (k * (k * q) + nu * (nu * q)) by ring. rewrite B', <- A'. ring. }
  apply Rmult_integral in P. apply Rmult_integral in Q0. split; [destruct P | destruct Q0]; lra.
Qed.
(* The kernel of a form is transverse to that of another one that is no multiple of it. *)
Definition apply_form (p u : column) : R := c_1 p * c_1 u + c_2 p * c_2 u + c_3 p * c_3 u + c_4 p * c_4 u.
Lemma transverse p q : (forall k, q <> combination k p 0 zero) -> exists u, apply_form p u = 0 /\ apply_form q u <> 0.
Proof.
  intros N.
  assert (Z : forall u, apply_form u u = 0 -> u = zero).
  { intros [a b c d]. unfold apply_form, zero. cbn [c_1 c_2 c_3 c_4]. intros E.
    pose proof (Rle_0_sqr a). pose proof (Rle_0_sqr b). pose proof (Rle_0_sqr c). pose proof (Rle_0_sqr d). unfold Rsqr in *.
    assert (K : forall x, x * x = 0 -> x = 0) by (intros x X; apply Rmult_integral in X; destruct X; assumption).
    f_equal; apply K; lra. }
  destruct (Req_dec (apply_form p p) 0) as [E|E].
  - exists q. rewrite (Z p E) in *. split; [unfold apply_form, zero; cbn [c_1 c_2 c_3 c_4]; ring|].
    intros F. apply Z in F. apply (N 0). rewrite F. unfold combination, zero. cbn [c_1 c_2 c_3 c_4]. f_equal; ring.
  - set (k := apply_form p q / apply_form p p). exists (combination 1 q (- k) p).
    assert (P : apply_form p (combination 1 q (- k) p) = 0).
    { replace (apply_form p (combination 1 q (- k) p)) with (apply_form p q - k * apply_form p p)
        by (unfold apply_form, combination; cbn [c_1 c_2 c_3 c_4]; ring). unfold k. field. exact E. }
    split; [exact P|]. intros F. apply (N k).
    assert (S : apply_form (combination 1 q (- k) p) (combination 1 q (- k) p) = 0).
    { replace (apply_form (combination 1 q (- k) p) (combination 1 q (- k) p)) with
        (apply_form q (combination 1 q (- k) p) - k * apply_form p (combination 1 q (- k) p))
        by (unfold apply_form, combination; cbn [c_1 c_2 c_3 c_4]; ring). rewrite F, P. ring. }
    apply Z in S. unfold combination, zero in *. cbn [c_1 c_2 c_3 c_4] in *. injection S as S1 S2 S3 S4.
    destruct q as [a b c d]. cbn [c_1 c_2 c_3 c_4] in *. f_equal; lra.
Qed.

(* --- rates ------------------------------------------------------------------------------------------ *)

(* Recursions of order two, with trace t and determinant s. If the eigenvalues are not real, a definite
   square is multiplied by s each time; if they are, the solutions are sums of their powers. *)
Lemma rates t s (u : nat -> R) : (forall n, u (S (S n)) = t * u (S n) - s * u n) ->
  (t * t < 4 * s -> forall n, let size n := u (S n) * u (S n) - t * u n * u (S n) + s * (u n * u n) in
    size n = s ^ n * size 0%nat /\ (s - t * t / 4) * (u n * u n) <= size n) /\
  (forall d, 0 < d -> d * d = t * t - 4 * s -> exists a b, forall n,
    u n = a * ((t + d) / 2) ^ n + b * ((t - d) / 2) ^ n).
Proof.
  intros L. split.
  - intros D n. cbv zeta. split.
    + induction n as [|n IH]; [simpl; ring|]. rewrite L.
      change (s ^ S n) with (s * s ^ n). rewrite (Rmult_assoc s), <- IH. ring.
    + pose proof (Rle_0_sqr (u (S n) - t / 2 * u n)) as Q. unfold Rsqr in Q. lra.
  - intros d D E. set (p := (t + d) / 2). set (q := (t - d) / 2).
    exists ((u 1%nat - q * u 0%nat) / d), ((p * u 0%nat - u 1%nat) / d).
    assert (P2 : p * p = t * p - s) by (unfold p; nra). assert (Q2 : q * q = t * q - s) by (unfold q; nra).
    set (a := (u 1%nat - q * u 0%nat) / d). set (b := (p * u 0%nat - u 1%nat) / d).
    assert (TWO : forall n, u n = a * p ^ n + b * q ^ n /\ u (S n) = a * p ^ S n + b * q ^ S n).
    { induction n as [|n [I1 I2]].
      - unfold a, b, p, q. split; simpl; field; lra.
      - split; [exact I2|]. rewrite L, I1, I2. simpl.
        replace (a * (p * (p * p ^ n))) with (a * (p * p) * p ^ n) by ring.
        replace (b * (q * (q * q ^ n))) with (b * (q * q) * q ^ n) by ring. rewrite P2, Q2. ring. }
    intros n. apply TWO.
Qed.
(* A forcing term that is only summable leaves no exponential rate. *)
Lemma no_rate_when_forced s : 0 < s < 1 -> exists v f : nat -> R,
  (forall n, v (S n) = s * v n + f n) /\ (forall n, sum_f_R0 (fun k => Rabs (f k)) n <= 2) /\
  forall q K, 0 < q < 1 -> exists n, K * q ^ n < v n.
Proof.
  intros R. set (w n := / INR (S n)). set (v n := w n - w (S n)).
  assert (P : forall n, 0 < INR (S n)) by (intros n; apply lt_0_INR; lia).
  assert (V : forall n, v n = / (INR (S n) * INR (S (S n)))).
  { intros n. unfold v, w. rewrite (S_INR (S n)). pose proof (P n). field. split; lra. }
  assert (V0 : forall n, 0 < v n).
  { intros n. rewrite V. apply Rinv_0_lt_compat, Rmult_lt_0_compat; apply P. }
  exists v, (fun n => v (S n) - s * v n). split; [intros n; ring|]. split.
  - intros n. assert (B : sum_f_R0 (fun k => Rabs (v (S k) - s * v k)) n <= 1 - w (S n) + (w 1%nat - w (S (S n)))).
    { assert (F : forall k, Rabs (v (S k) - s * v k) <= v k + v (S k)).
      { intros k. pose proof (V0 k). pose proof (V0 (S k)). assert (0 <= s * v k <= 1 * v k)
          by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra). apply Rabs_le. lra. }
      induction n as [|n IH]; cbn [sum_f_R0].
      - specialize (F 0%nat). unfold v at 3 4, w in F. unfold w in *. simpl INR in *. lra.
      - specialize (F (S n)). unfold v at 3 4 in F. lra. }
    assert (W : forall k, 0 < w k) by (intros k; apply Rinv_0_lt_compat, P).
    assert (W1 : w 1%nat <= 1) by (unfold w; simpl; lra). pose proof (W (S n)). pose proof (W (S (S n))). lra.
  - intros q K Q. set (x := Rmin 1 ((/ q - 1) / 7)).
    assert (IQ : 1 < / q) by (rewrite <- Rinv_1; apply Rinv_lt_contravar; lra).
    assert (X0 : 0 < x) by (apply Rmin_glb_lt; lra). assert (X1 : x <= 1) by apply Rmin_l.
    assert (X2 : x <= (/ q - 1) / 7) by apply Rmin_r.
    assert (X3 : (1 + x) ^ 3 <= / q) by nra.
    set (c := Rabs K + 1). pose proof (Rabs_pos K) as K0. pose proof (Rle_abs K) as K1.
    assert (xxx : 0 < x * x * x) by (repeat apply Rmult_lt_0_compat; lra).
    assert (N0 : 0 <= 6 * c / (x * x * x)) by (apply Rlt_le, Rdiv_lt_0_compat; [unfold c; lra | exact xxx]).
    set (b := 6 * c / (x * x * x) + 2).
    destruct (archimed_cor1 (/ b)) as (n & N' & N1); [apply Rinv_0_lt_compat; unfold b; lra|].
    assert (N : b < INR n).
    { apply Rnot_le_lt. intros F. apply Rinv_le_contravar in F; [lra | now apply lt_0_INR]. }
    unfold b in N.
    exists n. pose proof (poly n x X0) as B. assert (QN : 0 < q ^ n) by (apply pow_lt; lra).
    assert (B3 : (1 + INR n * x) ^ 3 <= / q ^ n).
    { rewrite <- pow_inv. apply Rle_trans with (((1 + x) ^ n) ^ 3).
      - apply pow_incr. split; [assert (0 <= INR n * x) by (apply Rmult_le_pos; lra); lra | exact B].
      - rewrite <- pow_mult, Nat.mul_comm, pow_mult. apply pow_incr. split; [apply pow_le; lra | exact X3]. }
    assert (G : c * (INR (S n) * INR (S (S n))) < (1 + INR n * x) ^ 3).
    { rewrite !S_INR. set (y := INR n) in *.
      assert (Y1 : (y + 1) * (y + 1 + 1) <= 6 * (y * y)) by nra.
      assert (Y2 : 6 * c < x * x * x * y).
      { apply Rmult_lt_reg_r with (/ (x * x * x)); [now apply Rinv_0_lt_compat|].
        replace (x * x * x * y * / (x * x * x)) with y by (field; lra). unfold Rdiv in N. lra. }
      assert (Y3 : c * ((y + 1) * (y + 1 + 1)) <= c * (6 * (y * y))) by (apply Rmult_le_compat_l; [unfold c; lra | exact Y1]).
      assert (Y4 : 6 * c * (y * y) < x * x * x * y * (y * y)) by (apply Rmult_lt_compat_r; [apply Rmult_lt_0_compat; lra | exact Y2]).
      assert (Y5 : 0 <= y * x) by (apply Rmult_le_pos; lra).
      assert (Y6 : (y * x) ^ 3 <= (1 + y * x) ^ 3) by (apply pow_incr; lra).
      replace ((y * x) ^ 3) with (x * x * x * y * (y * y)) in Y6 by ring. lra. }
    rewrite V. set (z := INR (S n) * INR (S (S n))) in *. assert (Z0 : 0 < z) by (apply Rmult_lt_0_compat; apply P).
    apply Rmult_lt_reg_r with (z * / q ^ n); [apply Rmult_lt_0_compat; [exact Z0 | now apply Rinv_0_lt_compat]|].
    replace (K * q ^ n * (z * / q ^ n)) with (K * z) by (field; lra).
    replace (/ z * (z * / q ^ n)) with (/ q ^ n) by (field; lra).
    assert (K * z <= c * z) by (apply Rmult_le_compat_r; unfold c; lra). lra.
Qed.
