(* There is only one cycle. Two cycles and phi_plus would be three points on two convex curves; what
   the two chords say, multiplied, is a contradiction. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixExists SeparatrixCurve SeparatrixCycle SeparatrixProjective.
From Verify Require Import SeparatrixConvex.
Open Scope R_scope.
Set Default Proof Using "All".

Section Unique.
Variables r a s : R.
Hypothesis R1 : 0 < r < 1.
Hypothesis A1 : 0 < a.
Hypothesis S1 : 0 < s.
Hypothesis SR : s ^ 3 = r.
Hypothesis HIGH : s + s ^ 2 < a.
Notation f := (separatrix_at r a R1 A1).
Notation on_curve := (on_curve r a R1 A1).
Notation t := (phi_plus r a).

Lemma curve_at_phi_plus rho : 0 < rho -> f rho t = 0.
Proof.
  intros P. pose proof (phi_plus_root r a s R1 A1 S1 SR HIGH) as [_ T].
  pose proof (s_less r a s R1 A1 S1 SR) as S2. assert (T0 : 0 <= t) by nra.
  destruct (Rle_lt_or_eq_dec 0 _ (f_not_negative r a R1 A1 rho P t)) as [L|L]; [|now symmetry].
  exfalso. apply (beyond_phi_plus r a s R1 A1 S1 SR HIGH rho _ P) with
    (2 := f_attained r a R1 A1 rho P t T0 L). apply Rle_refl.
Qed.
Lemma q_below_phi_plus rho x : 0 < rho -> on_curve rho x -> q x < t.
Proof.
  intros P C. apply Rnot_le_lt. intros N.
  apply (beyond_phi_plus r a s R1 A1 S1 SR HIGH rho x P N). now apply (on_curve_unending r a R1 A1).
Qed.
(* 1 - u, from q and the next q. *)
Lemma height rho x : 0 < rho -> on_curve rho x ->
  (1 - u x) * ((a + rho) * q (next r a rho x) - r) = q (next r a rho x) * (q x + rho) /\
  0 < (a + rho) * q (next r a rho x) - r.
Proof.
  intros P C.
  destruct (unending_now r a R1 A1 _ _ (on_curve_unending r a R1 A1 rho x P C)) as [X G].
  pose proof (next_q r a R1 A1 rho x P X G) as Q. pose proof (next_q_lower r a R1 A1 rho x P X G).
  pose proof (next_q_positive r a R1 A1 rho x P X G) as Q0.
  set (z := q (next r a rho x)) in *. unfold p in Q. split; [lra|].
  destruct X as [X _]. assert (0 < z * rho) by now apply Rmult_lt_0_compat. nra.
Qed.
(* What the chord from the first state to phi_plus says about the second. *)
Lemma chord rho x y : 0 < rho -> on_curve rho x -> on_curve rho y -> q x < q y ->
  ((a + rho) * t - r) * (q x + rho) *
    ((q (next r a rho y) - q (next r a rho x)) * (t - q y)) <=
  ((a + rho) * q (next r a rho x) - r) * (t + rho) * ((t - q (next r a rho y)) * (q y - q x)).
Proof.
  intros P X Y L. pose proof (phi_plus_root r a s R1 A1 S1 SR HIGH) as [ROOT _].
  pose proof (q_below_phi_plus rho y P Y) as T.
  pose proof (increasing r a R1 A1 rho x y P X Y L) as LN.
  destruct (height rho x P X) as [HX DX]. destruct (height rho y P Y) as [HY DY].
  set (v := q (next r a rho x)) in *. set (w := q (next r a rho y)) in *.
  set (c := (t - q y) / (t - q x)).
  assert (X0 : 0 <= q x) by apply X.
  assert (C : 0 <= c <= 1) by (apply share_range; lra).
  pose proof (f_convex r a R1 A1 rho (q x) t c P X0 ltac:(lra) C) as F.
  rewrite curve_at_phi_plus in F by exact P.
  replace (c * q x + (1 - c) * t) with (q y) in F by (unfold c; field; lra).
  rewrite <- (proj2 X), <- (proj2 Y) in F.
  (* The chord, in 1 - u. *)
  assert (K : (1 - u x) * (t - q y) + (q y - q x) <= (1 - u y) * (t - q x)).
  { apply Rmult_le_compat_r with (r := t - q x) in F; [|lra].
    replace ((c * u x + (1 - c) * 0) * (t - q x)) with (u x * (t - q y)) in F
      by (unfold c; field; lra). lra. }
  set (d := (a + rho) * v - r) in *. set (e := (a + rho) * w - r) in *.
  set (g := (a + rho) * t - r).
  assert (G : g = t * (t + rho)) by (unfold g; lra).
  assert (T0 : 0 < t) by lra. assert (G0 : 0 < g) by (rewrite G; apply Rmult_lt_0_compat; lra).
  assert (DE : 0 < d * e) by now apply Rmult_lt_0_compat.
  (* Multiplied with the three denominators. *)
  assert (K' : v * (q x + rho) * e * g * (t - q y) + t * (t + rho) * d * e * (q y - q x) <=
    w * (q y + rho) * d * g * (t - q x)).
  { rewrite <- HX, <- HY, <- G. apply Rmult_le_compat_l with (r := d * e * g) in K; [lra|].
    left. now apply Rmult_lt_0_compat. }
  assert (E1 : v * e - w * d = r * (w - v)) by (unfold d, e; ring).
  assert (E2 : w * g - t * e = r * (t - w)) by (unfold g, e; ring).
  assert (M : (v * e - w * d) * (g * (q x + rho) * (t - q y)) <=
    (w * g - t * e) * (d * (t + rho) * (q y - q x))) by lra.
  rewrite E1, E2 in M. apply Rmult_le_reg_l with r; [lra|]. lra.
Qed.

Theorem one_cycle rho x y : 0 < rho -> cycle r a rho x -> cycle r a rho y -> x = y.
Proof.
  intros P [HX CX] [HY CY]. assert (P' := inverse_positive rho P).
  assert (LESS : forall x y, on_curve rho x -> on_curve rho y -> orbit r a rho x 2 = x ->
    orbit r a rho y 2 = y -> ~ q x < q y).
  { clear x y HX CX HY CY. intros x y X Y CX CY L.
    pose proof (on_curve_next r a R1 A1 rho x P X) as NX.
    pose proof (on_curve_next r a R1 A1 rho y P Y) as NY.
    pose proof (increasing r a R1 A1 rho x y P X Y L) as LN.
    pose proof (q_below_phi_plus rho y P Y) as T. pose proof (q_below_phi_plus _ _ P' NY) as TN.
    pose proof (chord rho x y P X Y L) as A. pose proof (chord _ _ _ P' NX NY LN) as B.
    destruct (height rho x P X) as [_ D]. destruct (height _ _ P' NX) as [_ E].
    change (next r a (/ rho) (next r a rho x)) with (orbit r a rho x 2) in *.
    change (next r a (/ rho) (next r a rho y)) with (orbit r a rho y 2) in *.
    rewrite CX, CY in *. assert (X0 : 0 <= q x) by apply X. assert (Z0 := proj1 (proj1 NX)).
    set (z := q (next r a rho x)) in *. set (w := q (next r a rho y)) in *. set (c := / rho) in *.
    assert (F : ((a + c) * q x - r) * (t + rho) < ((a + c) * t - r) * (q x + rho)).
    { assert (0 < (t - q x) * ((a + c) * rho + r)); [|lra]. apply Rmult_lt_0_compat; [lra|].
      assert (0 < (a + c) * rho) by (apply Rmult_lt_0_compat; lra). lra. }
    assert (G : ((a + rho) * z - r) * (t + c) < ((a + rho) * t - r) * (z + c)).
    { assert (0 < (t - z) * ((a + rho) * c + r)); [|lra]. apply Rmult_lt_0_compat; [lra|].
      assert (0 < (a + rho) * c) by (apply Rmult_lt_0_compat; lra). lra. }
    set (m := (t - w) * (q y - q x)) in *. set (n := (w - z) * (t - q y)) in *.
    replace ((q y - q x) * (t - w)) with m in B by (unfold m; ring).
    replace ((t - q y) * (w - z)) with n in B by (unfold n; ring).
    assert (M : 0 < m) by (apply Rmult_lt_0_compat; lra).
    assert (N : 0 < n) by (apply Rmult_lt_0_compat; lra).
    set (d := (a + rho) * z - r) in *. set (e := (a + c) * q x - r) in *.
    set (D3 := (a + rho) * t - r) in *. set (E3 := (a + c) * t - r) in *.
    assert (F0 : 0 < e * (t + rho)) by (apply Rmult_lt_0_compat; lra).
    assert (G0 : 0 < d * (t + c)) by (apply Rmult_lt_0_compat; lra).
    assert (LT : (e * (t + rho)) * (d * (t + c)) < (E3 * (q x + rho)) * (D3 * (z + c)))
      by (apply Rmult_le_0_lt_compat; lra).
    assert (D0 : 0 < D3) by nra. assert (E0 : 0 < E3) by nra.
    assert (LE : (D3 * (q x + rho) * n) * (E3 * (z + c) * m) <=
      (d * (t + rho) * m) * (e * (t + c) * n)).
    { apply Rmult_le_compat; auto; apply Rmult_le_pos; try lra; apply Rmult_le_pos; lra. }
    assert (MN : 0 < m * n) by now apply Rmult_lt_0_compat.
    apply Rmult_lt_compat_r with (r := m * n) in LT; [|exact MN]. lra. }
  pose proof (cycle_on_curve r a s R1 A1 S1 SR HIGH rho x P HX CX) as X.
  pose proof (cycle_on_curve r a s R1 A1 S1 SR HIGH rho y P HY CY) as Y.
  apply (on_curve_equal r a R1 A1 rho); auto.
  destruct (Rtotal_order (q x) (q y)) as [L|[E|L]]; [|exact E|]; exfalso.
  - now apply (LESS x y).
  - now apply (LESS y x).
Qed.
End Unique.
