(* The characteristic polynomial of the printed matrix, its roots, and its eigenvectors. *)
From Coq Require Import Reals Lra Psatz.
From Verify Require Import Spectrum SpectrumMatrix.
Open Scope R_scope.

Lemma same_column u v : c_1 u = c_1 v -> c_2 u = c_2 v -> c_3 u = c_3 v -> c_4 u = c_4 v -> u = v.
Proof. destruct u, v. cbn. intros -> -> -> ->. reflexivity. Qed.
Theorem characteristic : characteristic_theorem.
Proof.
  intros r l. pose proof three_squared as H. set (q := sqrt 3) in *.
  unfold det4, det3, det2, combination, image, unit_1, unit_2, unit_3, unit_4, Q. cbn [c_1 c_2 c_3 c_4].
  fold q. field_simplify_eq [H]. ring [H].
Qed.

(* --- the real root, and the pair ------------------------------------------------------------------ *)

Section RootsOfQ.
Variable r : R.
Hypothesis R0 : 0 < r < 1.
Let A := (r^3-9*r^2+171*r-11)/64.
Let B := (-11*r^3+171*r^2-9*r+1)/64.
Lemma spread : A * A < 3 * B.
Proof.
  assert (E : 3 * B - A * A = - ((r+1)^2 * (r^4-20*r^3+462*r^2-1892*r-71)) / 4096) by (unfold A, B; field).
  assert (K : r^4-20*r^3+462*r^2-1892*r-71 < 0) by nra.
  assert (0 < (r+1)^2) by nra. nra.
Qed.
Lemma slope x y : 0 < y*y + x*y + x*x + A*(x+y) + B.
Proof.
  pose proof spread. pose proof (Rle_0_sqr (x - y)) as F. pose proof (Rle_0_sqr (3*(x+y)/2 + A)) as G.
  unfold Rsqr in *. nra.
Qed.
Lemma difference x y : Q r y - Q r x = (y - x) * (y*y + x*y + x*x + A*(x+y) + B).
Proof. unfold Q, A, B. field. Qed.
Lemma increasing x y : x < y -> Q r x < Q r y.
Proof. intros L. pose proof (difference x y). pose proof (slope x y). nra. Qed.
Lemma low : Q r (- r) < 0.
Proof.
  assert (E : Q r (-r) = - (r / 64 * (1 - r) * (r+1)^3)) by (unfold Q; field). rewrite E.
  assert (0 < r / 64 * (1 - r) * (r+1)^3) by (repeat apply Rmult_lt_0_compat; try lra; apply pow_lt; lra). lra.
Qed.
Lemma high : 0 < Q r (- r^3).
Proof.
  assert (E : Q r (-r^3) = 9 * r^3 / 64 * (1 - r) * (r+1)^3 * (7*r^2-13*r+7)) by (unfold Q; field). rewrite E.
  assert (0 < r^3) by (apply pow_lt; lra). assert (0 < (r+1)^3) by (apply pow_lt; lra).
  repeat apply Rmult_lt_0_compat; try lra. nra.
Qed.
Lemma at_one : 0 < Q r 1.
Proof.
  assert (E : Q r 1 = 27 * (1 + r)^3 / 32 * (1/2) + 27 * (1 + r)^3 / 64) by (unfold Q; field).
  rewrite E. assert (0 < (1 + r)^3) by (apply pow_lt; lra). lra.
Qed.
Theorem roots : exists l0 p m, -1 < - r < l0 /\ l0 < - r^3 < 0 /\ Q r l0 = 0 /\ (forall l, Q r l = 0 -> l = l0) /\
  (forall l, Q r l = (l - l0) * (l*l + p*l + m)) /\ p*p < 4*m /\ l0*l0 < m < 1.
Proof.
  assert (C : continuity (Q r)) by (unfold Q; reg).
  assert (R3 : 0 < r^3) by (apply pow_lt; lra).
  assert (L : - r < - r^3) by nra.
  destruct (IVT (Q r) (-r) (-r^3) C L low high) as (l0 & (L1 & L2) & E).
  assert (M1 : - r < l0) by (destruct L1 as [|F]; [assumption|]; pose proof low; rewrite F in *; lra).
  assert (M2 : l0 < - r^3) by (destruct L2 as [|F]; [assumption|]; pose proof high; rewrite <- F in *; lra).
  exists l0, (A + l0), (B + l0 * (A + l0)).
  assert (F : forall l, Q r l = (l - l0) * (l*l + (A + l0)*l + (B + l0*(A + l0)))).
  { intros l. pose proof (difference l0 l). nra. }
  assert (G : l0 * (B + l0 * (A + l0)) = - r^3).
  { pose proof E as E'. unfold Q in E'. unfold A, B. lra. }
  set (m := B + l0 * (A + l0)) in *.
  repeat split; try lra; try exact F.
  - intros l Z0. destruct (Rtotal_order l l0) as [K|[K|K]]; [apply increasing in K; lra | exact K | apply increasing in K; lra].
  - pose proof (slope (- (A + l0) / 2) l0). unfold m. nra.
  - assert (l0 * l0 * l0 > - r^3).
    { assert (0 < (r + l0) * (r*r - r*l0 + l0*l0)) by (apply Rmult_lt_0_compat; nra). nra. }
    nra.
  - nra.
Qed.
End RootsOfQ.

(* --- the normal components ------------------------------------------------------------------------ *)

(* Before 0-1, before 0-2 and before 1-2; and the angular momentum. *)
Section Forms.
Variable r : R.
Let h := (1 + r) / 4.
Definition form_0 (u : column) : R := c_1 u.
Definition form_1 (u : column) : R := c_3 u - h * c_1 u.
Definition form_2 (u : column) : R :=
  (c_1 u + c_3 u) / 2 + sqrt 3 / 2 * (c_4 u - c_2 u) - h * c_1 u - h * form_1 u.
Definition form_l (u : column) : R := c_1 u + sqrt 3 * c_2 u - c_3 u + sqrt 3 * c_4 u.
Ltac forms := pose proof three_squared as H; set (q := sqrt 3) in *;
  unfold form_l, form_2, form_1, form_0, image, h; cbn [c_1 c_2 c_3 c_4]; fold q;
  field_simplify_eq [H]; ring [H].
Lemma image_0 u : form_0 (image r u) =
  - ((1 + r) / 4) * form_2 u - (1 + r) / 4 * form_1 u - r * form_0 u.
Proof. forms. Qed.
Lemma image_1 u : form_1 (image r u) =
  - ((1 + r) / 4) * form_0 (image r u) - (1 + r) / 4 * form_2 u - r * form_1 u.
Proof. forms. Qed.
Lemma image_2 u : form_2 (image r u) =
  - ((1 + r) / 4) * form_1 (image r u) - (1 + r) / 4 * form_0 (image r u) - r * form_2 u.
Proof. forms. Qed.
Lemma image_l u : form_l (image r u) = form_l u.
Proof. forms. Qed.
Lemma by_forms u v : form_0 u = form_0 v -> form_1 u = form_1 v -> form_2 u = form_2 v -> form_l u = form_l v -> u = v.
Proof.
  unfold form_l, form_2, form_1, form_0. intros F0 F1 F2 FL. pose proof root_positive as P.
  assert (F3 : c_3 u = c_3 v) by (rewrite F0 in F1; lra).
  rewrite F0, F3 in F2, FL.
  assert (S : sqrt 3 * (c_4 u - c_2 u) = sqrt 3 * (c_4 v - c_2 v)) by lra.
  assert (T : sqrt 3 * (c_4 u + c_2 u) = sqrt 3 * (c_4 v + c_2 v)) by lra.
  apply Rmult_eq_reg_l in S; [|lra]. apply Rmult_eq_reg_l in T; [|lra].
  apply same_column; lra.
Qed.
(* The column with these values. *)
Definition with_forms (c0 c1 c2 l : R) : column :=
  let z := c1 + h * c0 in
  let sum := (l - c0 + z) / sqrt 3 in
  let difference := 2 / sqrt 3 * (c2 - (c0 + z) / 2 + h * c0 + h * c1) in
  Column c0 ((sum - difference) / 2) z ((sum + difference) / 2).
Lemma with_forms_are c0 c1 c2 l : let u := with_forms c0 c1 c2 l in
  form_0 u = c0 /\ form_1 u = c1 /\ form_2 u = c2 /\ form_l u = l.
Proof.
  pose proof root_positive as P. pose proof three_squared as H. unfold with_forms, form_l, form_2, form_1, form_0.
  cbn [c_1 c_2 c_3 c_4]. set (q := sqrt 3) in *.
  split; [reflexivity|]. split; [ring|]. split; field_simplify_eq [H]; try ring [H]; lra.
Qed.
Lemma form_combination a u b v : form_0 (combination a u b v) = a * form_0 u + b * form_0 v /\
  form_1 (combination a u b v) = a * form_1 u + b * form_1 v /\
  form_2 (combination a u b v) = a * form_2 u + b * form_2 v /\
  form_l (combination a u b v) = a * form_l u + b * form_l v.
Proof. unfold form_l, form_2, form_1, form_0, combination. cbn [c_1 c_2 c_3 c_4]. repeat split; field. Qed.
Lemma form_zero : form_0 zero = 0 /\ form_1 zero = 0 /\ form_2 zero = 0 /\ form_l zero = 0.
Proof. unfold form_l, form_2, form_1, form_0, zero. cbn [c_1 c_2 c_3 c_4]. repeat split; field. Qed.
End Forms.
