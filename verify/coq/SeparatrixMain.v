(* The main step: below a state whose collisions never end they never end either, and u tends to 0.
   Before it, what is needed on limits. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder.
Open Scope R_scope.
Set Default Proof Using "All".

(* --- limits ----------------------------------------------------------------------------------- *)

Lemma cv_const (c : R) : Un_cv (fun _ => c) c.
Proof. intros e E. exists 0%nat. intros. unfold R_dist. rewrite Rminus_diag_eq, Rabs_R0; auto. Qed.
Lemma cv_ext (f g : nat -> R) l : (forall n, f n = g n) -> Un_cv f l -> Un_cv g l.
Proof. intros E L e P. destruct (L e P) as [m M]. exists m. intros n N. rewrite <- E. auto. Qed.
Lemma cv_inv (f : nat -> R) l : l <> 0 -> Un_cv f l -> Un_cv (fun n => / f n) (/ l).
Proof.
  intros N L. apply (continuity_seq (fun x => / x) f l); [|exact L].
  apply (continuity_pt_inv id l); [|exact N]. apply derivable_continuous_pt, derivable_pt_id.
Qed.
Lemma cv_le (f g : nat -> R) l m : Un_cv f l -> Un_cv g m -> (forall n, f n <= g n) -> l <= m.
Proof.
  intros F G H. apply Rnot_lt_le. intros N.
  destruct (F ((l - m) / 2)) as [i I]; [lra|]. destruct (G ((l - m) / 2)) as [j J]; [lra|].
  specialize (I (i + j)%nat ltac:(lia)). specialize (J (i + j)%nat ltac:(lia)).
  specialize (H (i + j)%nat). unfold R_dist in *. apply Rabs_def2 in I. apply Rabs_def2 in J. lra.
Qed.
Lemma cv_squeeze (f g : nat -> R) : (forall n, 0 <= f n <= g n) -> Un_cv g 0 -> Un_cv f 0.
Proof.
  intros H G e E. destruct (G e E) as [m M]. exists m. intros n N. specialize (M n N).
  specialize (H n). unfold R_dist in *. rewrite Rminus_0_r in *.
  rewrite Rabs_pos_eq in *; lra.
Qed.
Lemma cv_shift (f : nat -> R) l : Un_cv f l -> Un_cv (fun n => f (S n)) l.
Proof. intros L e E. destruct (L e E) as [m M]. exists m. intros n N. apply M. lia. Qed.
Lemma cv_unshift (f : nat -> R) l : Un_cv (fun n => f (S n)) l -> Un_cv f l.
Proof.
  intros L e E. destruct (L e E) as [m M]. exists (S m). intros [|n] N; [lia|]. apply M. lia.
Qed.
Lemma decreasing_converges (f : nat -> R) :
  (forall n, f (S n) <= f n) -> (forall n, 0 <= f n) -> exists l, Un_cv f l /\ 0 <= l.
Proof.
  intros D P. destruct (decreasing_cv f) as [l L].
  - exact D.
  - exists 0. intros x [n ->]. unfold opp_seq. specialize (P n). lra.
  - exists l. split; [exact L|]. exact (cv_le _ _ _ _ (cv_const 0) L P).
Qed.
(* A quadratic polynomial that is positive at 0 is positive nearby. *)
Lemma small (b c d : R) : 0 < b ->
  exists e, 0 < e /\ forall x, 0 < x <= e -> 0 < b + c * x + d * x ^ 2.
Proof.
  intros B. set (m := Rabs c + Rabs d + 1).
  assert (M : 0 < m) by (unfold m; pose proof (Rabs_pos c); pose proof (Rabs_pos d); lra).
  exists (Rmin 1 (b / (2 * m))). split.
  { apply Rmin_glb_lt; [lra|]. apply Rdiv_lt_0_compat; lra. }
  intros x [X0 X1]. pose proof (Rmin_l 1 (b / (2 * m))). pose proof (Rmin_r 1 (b / (2 * m))).
  assert (L : x * m <= b / 2).
  { apply Rle_trans with (b / (2 * m) * m); [apply Rmult_le_compat_r; lra|]. right. field. lra. }
  pose proof (Rle_abs (- c)). pose proof (Rle_abs (- d)). rewrite Rabs_Ropp in *.
  assert (- c * x <= Rabs c * x) by (apply Rmult_le_compat_r; lra).
  assert (- d * x ^ 2 <= Rabs d * x).
  { apply Rle_trans with (Rabs d * x ^ 2); [apply Rmult_le_compat_r; nra|].
    apply Rmult_le_compat_l; [apply Rabs_pos|nra]. }
  unfold m in L. nra.
Qed.

Definition fades (r a rho : R) (x : state) := unending r a rho x /\ vanishing r a rho x.

Section Main.
Variables r a : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.

(* --- the main step ---------------------------------------------------------------------------- *)

(* The quotient of the two numbers u falls, by a factor that is the smaller, the larger u is. *)
Lemma quotient rho x y l : 0 < rho -> region x -> region y -> below x y -> goes_on a rho y ->
  l <= 1 -> u x <= l * u y ->
  u (next r a rho x) <= l * (1 - (1 - l) * u y) * u (next r a rho y).
Proof.
  intros P X Y B G L U. pose proof (goes_on_below r a R1 A1 rho x y P X Y B G) as GX.
  pose proof (next_below r a R1 A1 rho x y P X Y B G) as [_ BU].
  pose proof (next_h r a R1 A1 rho x P X GX) as HX. pose proof (next_h r a R1 A1 rho y P Y G) as HY.
  pose proof (next_u_range r a R1 A1 rho x P X GX) as UX.
  pose proof (next_u_range r a R1 A1 rho y P Y G) as UY.
  pose proof (p_difference r a R1 A1 rho x y P X Y B G) as D.
  pose proof (p_order r a R1 A1 rho x y P X Y B G) as O.
  pose proof (p_positive r a R1 A1 rho y P Y G) as PY.
  set (v := u (next r a rho x)) in *. set (w := u (next r a rho y)) in *.
  set (px := p a rho x) in *. set (py := p a rho y) in *.
  destruct B as [BQ BV]. destruct X as [Q0 [U0 U1]]. destruct Y as [V0 [W0 W1]].
  assert (l0 : 0 < l) by nra.
  assert (PA : px <= a) by (unfold px, p; nra).
  (* p falls. *)
  assert (F : py <= (1 - (1 - l) * u y) * px).
  { assert (a * ((1 - l) * u y) <= (a + rho) * (u y - u x)) by nra. nra. }
  assert (F0 : 0 <= (1 - l) * u y) by nra.
  assert (F1 : 0 < 1 - (1 - l) * u y) by nra.
  (* h of the next u falls. *)
  assert (W : width rho x <= l * width rho y).
  { unfold width. assert (rho * u x <= l * (rho * u y)) by nra.
    assert (0 < rho * u x) by (apply Rmult_lt_0_compat; lra).
    assert (rho * u x <= rho * u y) by nra.
    apply Rle_trans with (l * (rho * u y) * (2 * q x + rho * u x)).
    - apply Rmult_le_compat_r; lra.
    - rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
  rewrite <- HX, <- HY in W.
  assert (K : h v <= l * (1 - (1 - l) * u y) * h w).
  { apply Rmult_le_reg_r with (px ^ 2); [apply pow_lt; lra|]. apply Rle_trans with (1 := W).
    assert (py ^ 2 <= (1 - (1 - l) * u y) * px ^ 2).
    { apply Rle_trans with (((1 - (1 - l) * u y) * px) ^ 2); [apply pow_incr; lra|].
      rewrite Rpow_mult_distr. apply Rmult_le_compat_r; [apply pow_le; lra|]. nra. }
    pose proof (h_range _ UY). assert (0 <= l * h w) by nra. nra. }
  (* Hence u falls. *)
  assert (v * (2 - w) <= l * (1 - (1 - l) * u y) * w * (2 - w)) by (unfold h in K; nra).
  apply Rmult_le_reg_r with (2 - w); lra.
Qed.

Lemma vanishing_strictly_below rho x y : 0 < rho -> unending r a rho y -> region x -> below x y ->
  u x < u y -> vanishing r a rho x.
Proof.
  intros P H X B L. pose proof (unending_below r a R1 A1 rho x y P X B H) as HX.
  set (v := fun n => u (orbit r a rho x n)). set (w := fun n => u (orbit r a rho y n)).
  set (t := fun n => v n / w n).
  assert (VW : forall n, below (orbit r a rho x n) (orbit r a rho y n)).
  { induction n; [exact B|]. pose proof (ratio_positive rho n P) as Pn.
    destruct (unending_now _ _ R1 A1 _ _ (unending_orbit r a R1 A1 rho x n P HX)) as [Xn _].
    destruct (unending_now _ _ R1 A1 _ _ (unending_orbit r a R1 A1 rho y n P H)) as [Yn G].
    now apply next_below. }
  assert (V : forall n, 0 < v n < 1).
  { intros n. apply (unending_now _ _ R1 A1 _ _ (unending_orbit r a R1 A1 rho x n P HX)). }
  assert (W : forall n, 0 < w n < 1).
  { intros n. apply (unending_now _ _ R1 A1 _ _ (unending_orbit r a R1 A1 rho y n P H)). }
  assert (T : forall n, t n * w n = v n).
  { intros n. specialize (W n). unfold t. field. lra. }
  assert (T0 : forall n, 0 < t n).
  { intros n. apply Rdiv_lt_0_compat; [apply V|apply W]. }
  assert (T1 : forall n, t n <= 1).
  { intros n. specialize (W n). destruct (VW n) as [_ E]. fold (v n) (w n) in E.
    apply Rmult_le_reg_r with (w n); [lra|]. rewrite T. lra. }
  assert (STEP : forall n, t (S n) <= t n * (1 - (1 - t n) * w n)).
  { intros n. pose proof (ratio_positive rho n P) as Pn.
    destruct (unending_now _ _ R1 A1 _ _ (unending_orbit r a R1 A1 rho x n P HX)) as [Xn _].
    destruct (unending_now _ _ R1 A1 _ _ (unending_orbit r a R1 A1 rho y n P H)) as [Yn G].
    apply Rmult_le_reg_r with (w (S n)); [apply W|]. rewrite T.
    apply (quotient (ratio rho n) _ _ (t n) Pn Xn Yn (VW n) G (T1 n)).
    right. symmetry. apply T. }
  assert (FALL : forall n, t (S n) <= t n).
  { intros n. specialize (STEP n). specialize (T0 n). specialize (T1 n). specialize (W n).
    assert (0 <= t n * ((1 - t n) * w n)) by (apply Rmult_le_pos; nra). lra. }
  assert (BOUND : forall n, t n <= t 0%nat).
  { induction n; [lra|]. specialize (FALL n). lra. }
  assert (C : 0 < 1 - t 0%nat).
  { specialize (W 0%nat). specialize (T 0%nat). unfold v, w in *. simpl in *. nra. }
  destruct (decreasing_converges t FALL) as [l [CV L0]]; [intros n; specialize (T0 n); lra|].
  change (Un_cv v 0). destruct (Rle_lt_or_eq_dec 0 l L0) as [LP|<-].
  - (* If the quotient does not tend to 0, u of the larger state does. *)
    assert (LE : forall n, l <= t n) by (intros n; now apply decreasing_ineq).
    apply cv_squeeze with (g := fun n => (t n - t (S n)) * / (l * (1 - t 0%nat))).
    + intros n. split; [left; apply V|].
      apply Rmult_le_reg_r with (l * (1 - t 0%nat)); [nra|].
      rewrite Rmult_assoc, Rinv_l, Rmult_1_r; [|nra].
      specialize (STEP n). specialize (LE n). specialize (BOUND n). specialize (W n).
      specialize (T n). specialize (T1 n). specialize (T0 n).
      assert (v n <= w n) by nra.
      assert (l * (1 - t 0%nat) <= t n * (1 - t n)) by (apply Rmult_le_compat; lra).
      assert (w n * (l * (1 - t 0%nat)) <= w n * (t n * (1 - t n)))
        by (apply Rmult_le_compat_l; lra).
      assert (0 < l * (1 - t 0%nat)) by nra. nra.
    + replace 0 with ((l - l) * / (l * (1 - t 0%nat))) at 1 by (field; lra).
      apply CV_mult; [|apply cv_const]. apply CV_minus; [exact CV|]. now apply cv_shift.
  - apply cv_squeeze with (g := t); [|exact CV]. intros n. specialize (V n). specialize (T n).
    specialize (W n). specialize (T0 n). split; [lra|]. nra.
Qed.

Lemma vanishing_shift rho x :
  vanishing r a (/ rho) (next r a rho x) -> vanishing r a rho x.
Proof.
  intros H. apply cv_unshift. apply cv_ext with (2 := H). intros n.
  now rewrite (orbit_shift r a R1 A1).
Qed.
Theorem fades_below rho x y : 0 < rho -> unending r a rho y -> 0 <= q x <= q y ->
  0 < u x <= u y -> x <> y -> fades r a rho x.
Proof.
  intros P H Q U N. destruct (unending_now _ _ R1 A1 _ _ H) as [Y G].
  assert (X : region x) by (unfold region in *; lra).
  assert (B : below x y) by (unfold below; lra).
  pose proof (unending_below r a R1 A1 rho x y P X B H) as HX. split; [exact HX|].
  destruct (Rle_lt_or_eq_dec (u x) (u y) (proj2 U)) as [L|E].
  - now apply vanishing_strictly_below with y.
  - assert (D : q x < q y \/ u x < u y).
    { left. destruct (Rle_lt_or_eq_dec (q x) (q y) (proj2 Q)) as [L|E']; [exact L|].
      destruct N. destruct x, y. simpl in *. now subst. }
    destruct (unending_now _ _ R1 A1 _ _ HX) as [_ GX].
    pose proof (next_strictly_below r a R1 A1 rho x y P X Y B G D).
    apply vanishing_shift. apply vanishing_strictly_below with (next r a rho y).
    + now apply inverse_positive.
    + now apply unending_next.
    + now apply next_region.
    + unfold below. lra.
    + lra.
Qed.
End Main.
