(* Angular momentum keeps three balls apart: the squares of growth and spin together are at most the
   product of size and motion. *)
From Coq Require Import Reals Arith Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Sequences Classification Contacts Settling Endless.
From Verify Require Import ClassificationProof Calculus.
Open Scope R_scope.

(* --- products of planes --------------------------------------------------------------------------- *)

(* The determinant of the inner products of three vectors. *)
Lemma three_vectors d x y z : 0 <= dot d x x * dot d y y * dot d z z +
  2 * (dot d x y * dot d y z * dot d z x) - dot d x x * dot d y z ^ 2 -
  dot d y y * dot d z x ^ 2 - dot d z z * dot d x y ^ 2.
Proof.
  pose proof (dot_self d z) as Z. pose proof (cauchy_schwarz d x z) as CX. pose proof (cauchy_schwarz d y z) as CY.
  pose proof (cauchy_schwarz d (combined (dot d z z) x (- dot d x z) z) (combined (dot d z z) y (- dot d y z) z)) as C.
  rewrite !square_of_combined, dot_linear, !dot_linear_right in C.
  rewrite (dot_symmetric d z y) in C. rewrite (dot_symmetric d z x).
  set (n := dot d z z) in *. set (a := dot d x x) in *. set (b := dot d y y) in *.
  set (p := dot d x y) in *. set (q := dot d x z) in *. set (s := dot d y z) in *.
  destruct (Rle_lt_or_eq_dec 0 n Z) as [P|P].
  - apply Rmult_le_reg_l with (n * n * n); [repeat apply Rmult_lt_0_compat; exact P|].
    replace (n * n * n * 0) with 0 by ring.
    replace (n * n * n * (a * b * n + 2 * (p * s * q) - a * s ^ 2 - b * q ^ 2 - n * p ^ 2)) with
      ((n * n * a + 2 * n * - q * q + - q * - q * n) * (n * n * b + 2 * n * - s * s + - s * - s * n) -
       (n * (n * p + - s * q) + - q * (n * s + - s * n)) ^ 2) by ring.
    lra.
  - rewrite <- P in *. rewrite Rmult_0_r in CX, CY.
    assert (Q0 : q = 0) by (apply Rsqr_0_uniq, Rle_antisym; [rewrite Rsqr_pow2; exact CX | apply Rle_0_sqr]).
    assert (S0 : s = 0) by (apply Rsqr_0_uniq, Rle_antisym; [rewrite Rsqr_pow2; exact CY | apply Rle_0_sqr]).
    rewrite Q0, S0. lra.
Qed.
Lemma four_vectors d x v y w : dot d x v * dot d y w + wedge d x v y w <=
  sqrt (dot d x x * dot d v v) * sqrt (dot d y y * dot d w w).
Proof.
  set (z := combined 1 (combined (dot d y w) v (dot d v w) y) (- dot d v y) w).
  assert (E : dot d x v * dot d y w + wedge d x v y w = dot d x z).
  { unfold z, wedge. rewrite !dot_linear_right. ring. }
  rewrite E. pose proof (cauchy_schwarz d x z) as C. pose proof (three_vectors d v y w) as G.
  assert (Z : dot d z z <= dot d v v * (dot d y y * dot d w w)).
  { unfold z. rewrite !square_of_combined, !dot_linear. rewrite (dot_symmetric d w v) in G. lra. }
  pose proof (dot_self d x) as X. pose proof (dot_self d v) as V. pose proof (dot_self d y) as Y.
  pose proof (dot_self d w) as W.
  rewrite <- sqrt_mult by (apply Rmult_le_pos; assumption).
  apply Rle_trans with (sqrt (dot d x z ^ 2)).
  - rewrite <- Rsqr_pow2, sqrt_Rsqr_abs. apply Rle_abs.
  - apply sqrt_le_1_alt. apply Rle_trans with (1 := C).
    replace (dot d x x * dot d v v * (dot d y y * dot d w w)) with
      (dot d x x * (dot d v v * (dot d y y * dot d w w))) by ring.
    apply Rmult_le_compat_l; assumption.
Qed.

(* --- of a scene ----------------------------------------------------------------------------------- *)

Definition turned d s (a b p q : ball) : R := wedge d (to s a b) (relative s a b) (to s p q) (relative s p q).
Lemma turned_symmetric d s a b p q : turned d s a b p q = turned d s p q a b.
Proof.
  unfold turned, wedge. rewrite (dot_symmetric d (to s p q) (to s a b)), (dot_symmetric d (relative s p q) (relative s a b)),
    (dot_symmetric d (to s p q) (relative s a b)), (dot_symmetric d (relative s p q) (to s a b)). ring.
Qed.
Theorem spin2_is d s : spin2 d s =
  turned d s B0 B1 B0 B1 + turned d s B0 B2 B0 B2 + turned d s B1 B2 B1 B2 +
  2 * (turned d s B0 B1 B0 B2 + turned d s B0 B1 B1 B2 + turned d s B0 B2 B1 B2).
Proof.
  set (m a b k l := to s a b k * relative s a b l - to s a b l * relative s a b k).
  set (t a b p q := dot d (fun k => dot d (m a b k) (m p q k)) (fun _ => 1)).
  assert (T : forall a b p q, t a b p q = 2 * turned d s a b p q).
  { intros a b p q. unfold t, m, turned. apply wedge_by_coordinates. }
  assert (E : dot d (fun k => dot d (spin s k) (spin s k)) (fun _ => 1) =
    t B0 B1 B0 B1 + t B0 B2 B0 B2 + t B1 B2 B1 B2 + (t B0 B1 B0 B2 + t B0 B2 B0 B1 +
      (t B0 B1 B1 B2 + t B1 B2 B0 B1) + (t B0 B2 B1 B2 + t B1 B2 B0 B2))).
  { unfold t. rewrite <- !dot_add. f_equal. apply same_vector. intros k.
    replace (spin s k) with (combined 1 (combined 1 (m B0 B1 k) 1 (m B0 B2 k)) 1 (m B1 B2 k))
      by (apply same_vector; intros l; unfold combined, m, spin, moment; ring).
    repeat rewrite dot_linear. repeat rewrite dot_linear_right. ring. }
  unfold spin2. rewrite E, !T.
  pose proof (turned_symmetric d s B0 B2 B0 B1). pose proof (turned_symmetric d s B1 B2 B0 B1).
  pose proof (turned_symmetric d s B1 B2 B0 B2). lra.
Qed.
Theorem spin_bounded d s : growth d s * growth d s + spin2 d s <= size d s * motion2 d s.
Proof.
  set (n a b := sqrt (square d s a b * speed2 d s a b)).
  assert (P : forall a b p q, rate d s a b * rate d s p q + turned d s a b p q <= n a b * n p q)
    by (intros; apply four_vectors).
  rewrite spin2_is. unfold growth.
  pose proof (P B0 B1 B0 B1). pose proof (P B0 B2 B0 B2). pose proof (P B1 B2 B1 B2).
  pose proof (P B0 B1 B0 B2). pose proof (P B0 B1 B1 B2). pose proof (P B0 B2 B1 B2).
  apply Rle_trans with ((n B0 B1 + n B0 B2 + n B1 B2) * (n B0 B1 + n B0 B2 + n B1 B2)); [lra|].
  assert (S : forall a b, n a b * n a b = square d s a b * speed2 d s a b).
  { intros a b. apply sqrt_sqrt. apply Rmult_le_pos; [apply square_positive | apply speed2_positive]. }
  assert (M : forall a b p q, 2 * (n a b * n p q) <= square d s a b * speed2 d s p q + square d s p q * speed2 d s a b).
  { intros a b p q. unfold n. rewrite <- sqrt_mult by (apply Rmult_le_pos; [apply square_positive | apply speed2_positive]).
    set (A := square d s a b). set (B := speed2 d s p q). set (C := square d s p q). set (D := speed2 d s a b).
    assert (HA : 0 <= A) by apply square_positive. assert (HB : 0 <= B) by apply speed2_positive.
    assert (HC : 0 <= C) by apply square_positive. assert (HD : 0 <= D) by apply speed2_positive.
    replace (A * D * (C * B)) with (A * B * (C * D)) by ring.
    rewrite sqrt_mult by (apply Rmult_le_pos; assumption).
    pose proof (Rle_0_sqr (sqrt (A * B) - sqrt (C * D))) as Q. unfold Rsqr in Q.
    pose proof (sqrt_sqrt (A * B) ltac:(apply Rmult_le_pos; assumption)).
    pose proof (sqrt_sqrt (C * D) ltac:(apply Rmult_le_pos; assumption)). lra. }
  rewrite size_is. unfold motion2, total.
  pose proof (S B0 B1). pose proof (S B0 B2). pose proof (S B1 B2).
  pose proof (M B0 B1 B0 B2). pose proof (M B0 B1 B1 B2). pose proof (M B0 B2 B1 B2). lra.
Qed.
Lemma spin2_positive d s : 0 <= spin2 d s.
Proof.
  unfold spin2. assert (0 <= dot d (fun k => dot d (spin s k) (spin s k)) (fun _ => 1)); [|lra].
  assert (P : forall n, 0 <= dot n (fun k => dot d (spin s k) (spin s k)) (fun _ => 1)); [|apply P].
  induction n as [|n IH]; cbn [dot]; [lra|]. pose proof (dot_self d (spin s n)). lra.
Qed.

Section Turns.
Variable d : nat.
Variable r : R.
Variable first : scene.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis run : endless d r first scenes time i j.
Let L := spin2 d (scenes 0%nat).
Lemma spin2_stays n : spin2 d (scenes n) = L.
Proof.
  unfold L, spin2. f_equal. f_equal. apply same_vector. intros k.
  replace (spin (scenes n) k) with (spin (scenes 0%nat) k); [reflexivity|].
  apply same_vector. intros l. symmetry.
  apply (spin_stays d r first scenes time i j restitutes run).
Qed.
(* While the balls approach one another, size stays above m; and afterwards. *)
Definition above (m : R) (s : scene) : Prop :=
  (0 <= growth d s /\ m <= size d s) \/
  (growth d s < 0 /\ m * (growth d s * growth d s + L) <= size d s * L).
Lemma above_is_above m s : 0 <= m -> 0 < L -> above m s -> m <= size d s.
Proof.
  intros M P [[_ A]|[G A]]; [exact A|]. apply Rmult_le_reg_r with L; [exact P|].
  assert (0 <= m * (growth d s * growth d s)) by (apply Rmult_le_pos; [exact M | apply Rle_0_sqr]). lra.
Qed.
Lemma above_later m s t : 0 <= m -> 0 < L -> 0 < t -> spin2 d s = L -> above m s -> above m (later t s).
Proof.
  intros M P T SP A. unfold above in *. rewrite growth_later, size_later.
  pose proof (spin_bounded d s) as B. rewrite SP in B. pose proof (motion2_positive d s) as W.
  set (G := growth d s) in *. set (Z := size d s) in *. set (V := motion2 d s) in *.
  assert (TV : 0 <= t * V) by (apply Rmult_le_pos; lra).
  assert (TTV : 0 <= t * t * V) by (apply Rmult_le_pos; [apply Rle_0_sqr | exact W]).
  destruct A as [[A1 A2]|[A1 A2]].
  - left. split; [lra|]. assert (0 <= 2 * t * G) by (apply Rmult_le_pos; lra). lra.
  - assert (Q : 0 <= G * G) by apply Rle_0_sqr.
    assert (Zp : 0 < Z).
    { apply Rnot_le_lt. intros K. assert (0 <= (- Z) * V) by (apply Rmult_le_pos; [pose proof (size_positive d s); unfold Z in *; lra | exact W]). lra. }
    assert (Vp : 0 < V).
    { apply Rnot_le_lt. intros K. assert (0 <= Z * (- V)) by (apply Rmult_le_pos; lra). lra. }
    (* D is kept in flight; the least size is D/V. *)
    set (D := Z * V - G * G). assert (DL : L <= D) by (unfold D; lra).
    assert (MV : m * V <= D).
    { apply Rmult_le_reg_r with (Z * L); [apply Rmult_lt_0_compat; assumption|].
      assert (E1 : m * V * (Z * L) <= Z * V * (Z * L) - G * G * (Z * L)); [|unfold D; lra].
      (* m (G^2 + L) <= Z L, and G^2 + L <= Z V. *)
      assert (E2 : V * Z * (m * (G * G + L)) <= V * Z * (Z * L)).
      { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | exact A2]. }
      assert (E3 : G * G * (m * (V * Z)) >= G * G * (m * (G * G + L))).
      { apply Rle_ge. apply Rmult_le_compat_l; [exact Q|]. apply Rmult_le_compat_l; lra. }
      assert (E4 : 0 <= G * G * (Z * L - m * (G * G + L))) by (apply Rmult_le_pos; lra).
      destruct (Rle_lt_dec (m * (V * Z)) (Z * L)) as [C|C].
      - assert (E5 : 0 <= L * (Z * V - G * G - L)) by (apply Rmult_le_pos; lra).
        assert (E6 : 0 <= (Z * L - m * (V * Z)) * L) by (apply Rmult_le_pos; lra).
        assert (E7 : m * V * (Z * L) <= Z * L * L) by lra.
        assert (E8 : Z * L * (L + G * G) <= Z * L * (Z * V)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | lra]).
        lra.
      - assert (E5 : G * G * (Z * L) <= G * G * (m * (V * Z))) by (apply Rmult_le_compat_l; lra). lra. }
    destruct (Rle_lt_dec 0 (G + t * V)) as [K|K].
    + left. split; [exact K|]. apply Rmult_le_reg_r with V; [exact Vp|].
      assert (E : (Z + 2 * t * G + t * t * V) * V = D + (G + t * V) * (G + t * V)) by (unfold D; ring).
      rewrite E. pose proof (Rle_0_sqr (G + t * V)) as S. unfold Rsqr in S. lra.
    + right. split; [exact K|]. set (g := G + t * V) in *.
      apply Rmult_le_reg_r with V; [exact Vp|].
      assert (E : (Z + 2 * t * G + t * t * V) * V = D + g * g) by (unfold D, g; ring).
      replace ((Z + 2 * t * G + t * t * V) * L * V) with (L * ((Z + 2 * t * G + t * t * V) * V)) by ring.
      rewrite E. assert (GG : g * g <= G * G).
      { replace (g * g) with (- g * - g) by ring. replace (G * G) with (- G * - G) by ring.
        apply Rmult_le_compat; unfold g in *; lra. }
      assert (g0 : 0 <= g * g) by apply Rle_0_sqr.
      (* The difference of both sides is affine in g^2, and not negative at 0 and at G^2. *)
      assert (A3 : m * (G * G + L) * V <= L * (D + G * G)).
      { replace (L * (D + G * G)) with (Z * L * V) by (unfold D; ring). apply Rmult_le_compat_r; lra. }
      assert (A4 : L * (m * V) <= L * D) by (apply Rmult_le_compat_l; lra).
      destruct (Rle_lt_dec (m * V) L) as [C|C].
      * assert (0 <= g * g * (L - m * V)) by (apply Rmult_le_pos; lra). lra.
      * assert (0 <= (G * G - g * g) * (m * V - L)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma above_next m n : 0 <= m -> 0 < L -> above m (scenes n) -> above m (scenes (S n)).
Proof.
  intros M P A. destruct (facts d r first scenes time i j restitutes run n) as (N & T & C & G & _ & E).
  apply (above_later m _ _ M P T (spin2_stays n)) in A. rewrite E. unfold above in *.
  rewrite size_collided. rewrite growth_collided by assumption.
  set (s := later (time (S n) - time n) (scenes n)) in *. unfold meeting_speed in G. fold s in G.
  assert (K : 0 < - (3 / 2 * (1 + r) * rate d s (i n) (j n))).
  { assert (0 < 3 / 2 * (1 + r) * - rate d s (i n) (j n)) by (repeat apply Rmult_lt_0_compat; lra). lra. }
  set (k := - (3 / 2 * (1 + r) * rate d s (i n) (j n))) in *.
  replace (growth d s - 3 / 2 * (1 + r) * rate d s (i n) (j n)) with (growth d s + k) by (unfold k; ring).
  destruct A as [[A1 A2]|[A1 A2]]; [left; lra|].
  destruct (Rle_lt_dec 0 (growth d s + k)) as [Q|Q].
  - left. split; [exact Q|]. apply (above_is_above m s M P). right. now split.
  - right. split; [exact Q|]. apply Rle_trans with (2 := A2). apply Rmult_le_compat_l; [exact M|].
    assert ((growth d s + k) * (growth d s + k) <= growth d s * growth d s); [|lra].
    replace (growth d s * growth d s) with (- growth d s * - growth d s) by ring.
    replace ((growth d s + k) * (growth d s + k)) with (- (growth d s + k) * - (growth d s + k)) by ring.
    apply Rmult_le_compat; lra.
Qed.
Lemma never_if_above m : 6 < m -> 0 < L -> above m (scenes 0%nat) -> False.
Proof.
  intros M P A. apply (not_large d r first scenes time i j restitutes run m 0 M). intros n _.
  apply above_is_above; [lra | exact P|]. induction n as [|n IH]; [exact A|]. apply above_next; trivial. lra.
Qed.
End Turns.

Theorem never_turning_holds : never_turning.
Proof.
  intros d r s scenes time i j R A E. pose proof E as (F & _). rewrite <- F in A.
  pose proof (spin2_positive d (scenes 0%nat)) as P. pose proof (size_positive d (scenes 0%nat)) as Z.
  set (g := growth d (scenes 0%nat)) in *. set (z := size d (scenes 0%nat)) in *. set (L := spin2 d (scenes 0%nat)) in *.
  assert (Q : 0 <= g ^ 2 * z) by (apply Rmult_le_pos; [apply pow2_ge_0 | exact Z]).
  assert (L0 : 0 < L).
  { apply Rnot_le_lt. intros K. assert (L = 0) by lra. rewrite H, Rmult_0_r in A. lra. }
  assert (z6 : 6 < z).
  { apply Rnot_le_lt. intros K. assert (0 <= (6 - z) * L) by (apply Rmult_le_pos; lra). lra. }
  destruct (Rle_lt_dec 0 g) as [G|G].
  - apply (never_if_above d r s scenes time i j R E z z6 L0). left. split; [exact G | apply Rle_refl].
  - assert (D : 0 < g * g + L) by (pose proof (Rle_0_sqr g) as S; unfold Rsqr in S; lra).
    apply (never_if_above d r s scenes time i j R E (z * L / (g * g + L))); [| exact L0 |].
    + apply Rmult_lt_reg_r with (g * g + L); [exact D|].
      replace (z * L / (g * g + L) * (g * g + L)) with (z * L) by (field; lra).
      assert (6 * g ^ 2 <= g ^ 2 * z).
      { rewrite (Rmult_comm 6). apply Rmult_le_compat_l; [apply pow2_ge_0 | lra]. } lra.
    + right. split; [exact G|]. fold g z L. right. field. lra.
Qed.
