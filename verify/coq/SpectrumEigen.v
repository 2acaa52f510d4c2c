(* The complex eigenvalues of the printed matrix are 1 and the roots of Q, each of multiplicity 1. *)
From Coq Require Import Reals Lra Psatz.
From Verify Require Import Spectrum SpectrumMatrix SpectrumRoots.
Open Scope R_scope.

(* --- complex numbers ------------------------------------------------------------------------------ *)

Record complex := Complex { re : R; im : R }.
Definition plus (a b : complex) := Complex (re a + re b) (im a + im b).
Definition times (a b : complex) := Complex (re a * re b - im a * im b) (re a * im b + im a * re b).
Definition real (x : R) := Complex x 0.
Lemma same_complex a b : re a = re b -> im a = im b -> a = b.
Proof. destruct a, b. cbn. intros -> ->. reflexivity. Qed.
Ltac complexly := apply same_complex; unfold plus, times, real; cbn [re im]; try ring.
Lemma zero_product a b : times a b = real 0 -> a = real 0 \/ b = real 0.
Proof.
  intros E. assert (P : (re a ^ 2 + im a ^ 2) * (re b ^ 2 + im b ^ 2) = 0).
  { replace ((re a ^ 2 + im a ^ 2) * (re b ^ 2 + im b ^ 2)) with (re (times a b) ^ 2 + im (times a b) ^ 2)
      by (unfold times; cbn [re im]; ring).
    rewrite E. unfold real. cbn [re im]. ring. }
  apply Rmult_integral in P. destruct P as [P|P]; [left | right]; apply same_complex; unfold real; cbn [re im]; nra.
Qed.
Lemma quotient a b : a <> real 0 -> exists k, times k a = b.
Proof.
  intros N. assert (P : re a ^ 2 + im a ^ 2 <> 0).
  { intros P. apply N. apply same_complex; unfold real; cbn [re im]; nra. }
  exists (Complex ((re b * re a + im b * im a) / (re a ^ 2 + im a ^ 2)) ((im b * re a - re b * im a) / (re a ^ 2 + im a ^ 2))).
  apply same_complex; unfold times; cbn [re im]; field; nra.
Qed.

Section Eigen.
Variable r : R.
Hypothesis R0 : 0 < r < 1.
Let h := (1 + r) / 4.
Definition value_Q (l : complex) : complex :=
  plus (times l (times l l)) (plus (times (real ((r ^ 3 - 9 * r ^ 2 + 171 * r - 11) / 64)) (times l l))
    (plus (times (real ((- 11 * r ^ 3 + 171 * r ^ 2 - 9 * r + 1) / 64)) l) (real (r ^ 3)))).
Definition over_a (l : complex) := plus (times (real (1 - h)) l) (real r).
Definition over_b (l : complex) := plus l (real (r - h)).
(* Eliminated from the three equations of an eigenvector. *)
Lemma eliminated l : value_Q l = plus (times (plus l (real r)) (times (over_b l) (over_b l)))
  (times (real h) (plus (times (over_a l) (over_b l)) (times (over_a l) (over_a l)))).
Proof. unfold value_Q, over_a, over_b, h. complexly; field. Qed.
Lemma not_both l : over_a l = real 0 -> over_b l = real 0 -> False.
Proof.
  unfold over_a, over_b, plus, times, real, h. destruct l as [x y]. cbn [re im]. intros A B.
  injection A as A1 A2. injection B as B1 B2. assert (X : x = (1 + r) / 4 - r) by lra. rewrite X in A1. nra.
Qed.
(* The equations, for the complex normal components. *)
Definition equations (l c0 c1 c2 : complex) : Prop :=
  plus (times (plus l (real r)) c0) (times (real h) (plus c1 c2)) = real 0 /\
  times (over_a l) c0 = times (over_b l) c1 /\ times (over_a l) c1 = times (over_b l) c2.
Lemma solved l c0 c1 c2 : equations l c0 c1 c2 ->
  value_Q l = real 0 /\ c0 <> real 0 /\ over_b l <> real 0 \/ c0 = real 0 /\ c1 = real 0 /\ c2 = real 0.
Proof.
  intros (E1 & E2 & E3).
  assert (E : times (value_Q l) c0 = real 0).
  { rewrite eliminated. assert (F : times (times (over_b l) (over_b l))
      (plus (times (plus l (real r)) c0) (times (real h) (plus c1 c2))) = real 0) by (rewrite E1; complexly).
    rewrite <- F. symmetry.
    transitivity (plus (times (times (over_b l) (over_b l)) (times (plus l (real r)) c0))
      (times (real h) (plus (times (over_b l) (times (over_b l) c1)) (times (over_b l) (times (over_b l) c2))))).
    { complexly. }
    rewrite <- E2, <- E3.
    transitivity (plus (times (times (over_b l) (over_b l)) (times (plus l (real r)) c0))
      (times (real h) (plus (times (over_b l) (times (over_a l) c0)) (times (over_a l) (times (over_b l) c1))))).
    { complexly. }
    rewrite <- E2. complexly. }
  assert (D : forall a : complex, a = real 0 \/ a <> real 0).
  { intros [x y]. destruct (Req_dec x 0) as [->|X]; [|right; intros F; injection F; easy].
    destruct (Req_dec y 0) as [->|Y]; [now left|]. right. intros F. injection F. easy. }
  destruct (D c0) as [Z|N].
  - right. split; [exact Z|]. rewrite Z in *.
    assert (Y : times (over_b l) c1 = real 0) by (rewrite <- E2; complexly).
    assert (Z1 : c1 = real 0).
    { destruct (zero_product _ _ Y) as [Y1|Y1]; [|exact Y1].
      assert (Y2 : times (over_a l) c1 = real 0) by (rewrite E3, Y1; complexly).
      destruct (zero_product _ _ Y2) as [Y3|Y3]; [destruct (not_both l Y3 Y1) | exact Y3]. }
    split; [exact Z1|]. rewrite Z1 in E1.
    assert (Y2 : times (real h) c2 = real 0) by (rewrite <- E1; complexly).
    destruct (zero_product _ _ Y2) as [Y3|Y3]; [|exact Y3].
    unfold real, h in Y3. injection Y3. intros. lra.
  - left. destruct (zero_product _ _ E) as [F|F]; [|easy]. split; [exact F|]. split; [exact N|]. intros Bz.
    assert (Y : times (over_a l) c0 = real 0) by (rewrite E2, Bz; complexly).
    destruct (zero_product _ _ Y) as [Y1|Y1]; [exact (not_both l Y1 Bz) | easy].
Qed.

(* --- eigenvectors ------------------------------------------------------------------------------- *)

Definition z_0 u v := Complex (form_0 u) (form_0 v).
Definition z_1 u v := Complex (form_1 r u) (form_1 r v).
Definition z_2 u v := Complex (form_2 r u) (form_2 r v).
Definition z_l u v := Complex (form_l u) (form_l v).
Definition scaled_by l u v : Prop := image r u = combination (re l) u (- im l) v /\
  image r v = combination (im l) u (re l) v.
Lemma scaled_by_forms l u v : scaled_by l u v <-> equations l (z_0 u v) (z_1 u v) (z_2 u v) /\
  times (plus l (real (-1))) (z_l u v) = real 0.
Proof.
  pose proof (form_combination r (re l) u (- im l) v) as (A0 & A1 & A2 & AL).
  pose proof (form_combination r (im l) u (re l) v) as (B0 & B1 & B2 & BL).
  pose proof (image_0 r u) as U0. pose proof (image_1 r u) as U1. pose proof (image_2 r u) as U2. pose proof (image_l r u) as UL.
  pose proof (image_0 r v) as V0. pose proof (image_1 r v) as V1. pose proof (image_2 r v) as V2. pose proof (image_l r v) as VL.
  split.
  - intros (S1 & S2). rewrite S1 in *. rewrite S2 in *. rewrite A0, A1, A2, AL, B0, B1, B2, BL in *.
    unfold equations, z_0, z_1, z_2, z_l, over_a, over_b, h.
    split; [split; [|split]|]; complexly; cbn [re im] in *; lra.
  - intros ((E1 & E2 & E3) & EL). unfold z_0, z_1, z_2, z_l, over_a, over_b, plus, times, real, h in E1, E2, E3, EL.
    cbn [re im] in E1, E2, E3, EL.
    injection E1 as E1 F1. injection E2 as E2 F2. injection E3 as E3 F3. injection EL as EL FL.
    assert (K0 : form_0 (image r u) = re l * form_0 u + - im l * form_0 v) by (rewrite U0; lra).
    assert (L0 : form_0 (image r v) = im l * form_0 u + re l * form_0 v) by (rewrite V0; lra).
    assert (K1 : form_1 r (image r u) = re l * form_1 r u + - im l * form_1 r v) by (rewrite U1, K0; lra).
    assert (L1 : form_1 r (image r v) = im l * form_1 r u + re l * form_1 r v) by (rewrite V1, L0; lra).
    split; apply (by_forms r).
    + now rewrite A0.
    + now rewrite A1.
    + rewrite A2, U2, K0, K1. lra.
    + rewrite AL, UL. lra.
    + now rewrite B0.
    + now rewrite B1.
    + rewrite B2, V2, L0, L1. lra.
    + rewrite BL, VL. lra.
Qed.
Lemma all_zero u v : z_0 u v = real 0 -> z_1 u v = real 0 -> z_2 u v = real 0 -> z_l u v = real 0 -> u = zero /\ v = zero.
Proof.
  unfold z_0, z_1, z_2, z_l, real. intros E0 E1 E2 EL. injection E0 as A0 B0. injection E1 as A1 B1.
  injection E2 as A2 B2. injection EL as AL BL. destruct (form_zero r) as (Z0 & Z1 & Z2 & ZL).
  split; apply (by_forms r); lra.
Qed.
(* An eigenvalue is 1 or a root; and the components of an eigenvector. *)
Lemma eigenvector_cases l u v : eigenvector r (re l) (im l) u v ->
  value_Q l = real 0 /\ l <> real 1 /\ over_b l <> real 0 /\ z_0 u v <> real 0 /\ z_l u v = real 0 \/
  l = real 1 /\ z_0 u v = real 0 /\ z_1 u v = real 0 /\ z_2 u v = real 0 /\ z_l u v <> real 0.
Proof.
  intros (N & S). apply (scaled_by_forms l u v) in S. destruct S as (E & EL).
  destruct (solved _ _ _ _ E) as [(K1 & K2 & K3)|(K1 & K2 & K3)].
  - left. assert (L1 : l <> real 1).
    { intros ->. unfold value_Q, plus, times, real in K1. cbn [re im] in K1. injection K1 as K _.
      pose proof (at_one r R0). unfold Q in H. lra. }
    split; [exact K1|]. split; [exact L1|]. split; [exact K3|]. split; [exact K2|].
    destruct (zero_product _ _ EL) as [F|F]; [|exact F]. destruct L1.
    unfold plus, real in F. injection F as F1 F2. apply same_complex; unfold real; cbn [re im] in *; lra.
  - right. destruct (zero_product _ _ EL) as [F|F]; [|destruct N; now apply all_zero].
    split.
    + unfold plus, real in F. injection F as F1 F2. apply same_complex; unfold real; cbn [re im] in *; lra.
    + repeat (split; [assumption|]). intros ZL. apply N. now apply all_zero.
Qed.
Lemma proportional l u v u' v' : eigenvector r (re l) (im l) u v -> eigenvector r (re l) (im l) u' v' ->
  exists a b, u' = combination a u (- b) v /\ v' = combination b u a v.
Proof.
  intros H H'.
  assert (G : exists k, times k (z_0 u v) = z_0 u' v' /\ times k (z_1 u v) = z_1 u' v' /\
    times k (z_2 u v) = z_2 u' v' /\ times k (z_l u v) = z_l u' v').
  { destruct (eigenvector_cases l u v H) as [(K1 & K2 & K3 & K4 & K5)|(K1 & K2 & K3 & K4 & K5)],
      (eigenvector_cases l u' v' H') as [(L1 & L2 & L3 & L4 & L5)|(L1 & L2 & L3 & L4 & L5)]; try congruence.
    - destruct (quotient _ (z_0 u' v') K4) as (k & F). exists k. rewrite K5, L5.
      destruct H as (_ & S). apply (scaled_by_forms l u v) in S. destruct S as ((_ & E2 & E3) & _).
      destruct H' as (_ & S). apply (scaled_by_forms l u' v') in S. destruct S as ((_ & E2' & E3') & _).
      assert (C : forall x y, times (over_b l) x = times (over_b l) y -> x = y).
      { intros x y E. destruct (zero_product (over_b l) (plus x (times (real (-1)) y))) as [F1|F1].
        - transitivity (plus (times (over_b l) x) (times (real (-1)) (times (over_b l) y))); [complexly|].
          rewrite E. complexly.
        - easy.
        - unfold plus, times, real in F1. cbn [re im] in F1. injection F1 as F1 F2. apply same_complex; lra. }
      assert (F1 : times k (z_1 u v) = z_1 u' v').
      { apply C. rewrite <- E2', <- F. transitivity (times k (times (over_b l) (z_1 u v))); [complexly|].
        rewrite <- E2. complexly. }
      split; [exact F|]. split; [exact F1|]. split; [|complexly].
      apply C. rewrite <- E3', <- F1. transitivity (times k (times (over_b l) (z_2 u v))); [complexly|].
      rewrite <- E3. complexly.
    - destruct (quotient _ (z_l u' v') K5) as (k & F). exists k. rewrite K2, K3, K4, L2, L3, L4.
      split; [complexly | split; [complexly | split; [complexly | exact F]]]. }
  destruct G as (k & G0 & G1 & G2 & GL). exists (re k), (im k).
  destruct (form_combination r (re k) u (- im k) v) as (A0 & A1 & A2 & AL).
  destruct (form_combination r (im k) u (re k) v) as (B0 & B1 & B2 & BL).
  unfold z_0, z_1, z_2, z_l, times in *. cbn [re im] in *.
  injection G0 as P0 Q0. injection G1 as P1 Q1. injection G2 as P2 Q2. injection GL as PL QL.
  split; apply (by_forms r).
  - rewrite A0. lra. - rewrite A1. lra. - rewrite A2. lra. - rewrite AL. lra.
  - rewrite B0. lra. - rewrite B1. lra. - rewrite B2. lra. - rewrite BL. lra.
Qed.
Lemma there_is_one l : value_Q l = real 0 -> exists u v, eigenvector r (re l) (im l) u v.
Proof.
  intros E. set (x0 := times (over_b l) (over_b l)). set (x1 := times (over_a l) (over_b l)). set (x2 := times (over_a l) (over_a l)).
  set (u := with_forms r (re x0) (re x1) (re x2) 0). set (v := with_forms r (im x0) (im x1) (im x2) 0).
  exists u, v. destruct (with_forms_are r (re x0) (re x1) (re x2) 0) as (U0 & U1 & U2 & UL). fold u in U0, U1, U2, UL.
  destruct (with_forms_are r (im x0) (im x1) (im x2) 0) as (V0 & V1 & V2 & VL). fold v in V0, V1, V2, VL.
  assert (Z0 : z_0 u v = x0) by (unfold z_0; rewrite U0, V0; now destruct x0).
  assert (Z1 : z_1 u v = x1) by (unfold z_1; rewrite U1, V1; now destruct x1).
  assert (Z2 : z_2 u v = x2) by (unfold z_2; rewrite U2, V2; now destruct x2).
  split.
  - intros (-> & ->). destruct (form_zero r) as (F0 & F1 & F2 & FL).
    assert (X0 : x0 = real 0) by (rewrite <- Z0; unfold z_0, real; now rewrite F0).
    assert (X2 : x2 = real 0) by (rewrite <- Z2; unfold z_2, real; now rewrite F2).
    apply zero_product in X0. apply zero_product in X2. apply (not_both l); tauto.
  - apply (scaled_by_forms l u v). unfold z_l. rewrite Z0, Z1, Z2, UL, VL. split; [|complexly].
    split; [|split; unfold x0, x1, x2; complexly].
    rewrite <- E, eliminated. unfold x0, x1, x2. complexly.
Qed.
Lemma fixed : eigenvector r 1 0 (Column 0 1 0 1) zero.
Proof.
  split; [intros (F & _); injection F; intros; lra|]. unfold image, combination, zero. cbn [c_1 c_2 c_3 c_4].
  split; apply same_column; cbn [c_1 c_2 c_3 c_4]; field.
Qed.
Lemma fixed_are u : image r u = u <-> exists y, u = Column 0 y 0 y.
Proof.
  split.
  - intros E. exists (c_2 u).
    assert (D : u = zero \/ u <> zero).
    { destruct u as [a b c d]. unfold zero. destruct (Req_dec a 0) as [->|]; [|right; intros F; injection F; easy].
      destruct (Req_dec b 0) as [->|]; [|right; intros F; injection F; easy].
      destruct (Req_dec c 0) as [->|]; [|right; intros F; injection F; easy].
      destruct (Req_dec d 0) as [->|]; [now left | right; intros F; injection F; easy]. }
    destruct D as [->|N]; [reflexivity|].
    assert (H : eigenvector r (re (real 1)) (im (real 1)) u zero).
    { split; [intros (F & _); easy|]. unfold real. cbn [re im]. split.
      - rewrite E. unfold combination, zero. apply same_column; cbn [c_1 c_2 c_3 c_4]; ring.
      - unfold image, combination, zero. apply same_column; cbn [c_1 c_2 c_3 c_4]; ring. }
    destruct (eigenvector_cases (real 1) u zero H) as [(_ & K & _)|(_ & K0 & K1 & K2 & _)]; [easy|].
    apply (f_equal re) in K0, K1, K2. unfold z_0, z_1, z_2, real in K0, K1, K2. cbn [re] in K0, K1, K2.
    unfold form_0 in K0. unfold form_1 in K1. rewrite K0 in K1.
    assert (K3 : c_3 u = 0) by lra. unfold form_2, form_1 in K2. rewrite K0, K3 in K2.
    pose proof root_positive as P.
    assert (S : sqrt 3 * (c_4 u - c_2 u) = sqrt 3 * 0) by lra. apply Rmult_eq_reg_l in S; [|lra].
    apply same_column; cbn [c_1 c_2 c_3 c_4]; lra.
  - intros (y & ->). unfold image. apply same_column; cbn [c_1 c_2 c_3 c_4]; field.
Qed.
End Eigen.

Theorem spectrum : spectrum_theorem.
Proof.
  intros r R0. destruct (roots r R0) as (l0 & p & m & L1 & L2 & E & ONE & F & D & M).
  set (x := - p / 2). set (y := sqrt (m - p * p / 4)).
  assert (Y2 : y * y = m - p * p / 4) by (apply sqrt_sqrt; lra).
  assert (Y : 0 < y) by (apply sqrt_lt_R0; lra).
  assert (XY : x ^ 2 + y ^ 2 = m) by (unfold x; replace (y ^ 2) with (y * y) by ring; rewrite Y2; field).
  assert (F' : forall l, Q r l = (l - l0) * ((l - x) ^ 2 + y ^ 2)).
  { intros l. rewrite F. replace ((l - x) ^ 2 + y ^ 2) with (l * l - 2 * x * l + (x ^ 2 + y ^ 2)) by ring.
    rewrite XY. unfold x. field. }
  exists l0, x, y.
  split; [exact L1|]. split; [exact L2|]. split; [exact Y|]. rewrite XY.
  split; [split; nra|]. split; [lra|].
  split; [intros l; split; [apply ONE | intros ->; exact E]|]. split; [exact F'|].
  (* The coefficients. *)
  pose proof (F' 0) as C0. pose proof (F' 1) as C1. pose proof (F' (-1)) as C2. unfold Q in C0, C1, C2.
  assert (VQ : forall l, value_Q r l = times (plus l (real (- l0)))
    (plus (times (plus l (real (- x))) (plus l (real (- x)))) (real (y ^ 2)))).
  { intros l. set (a := (r ^ 3 - 9 * r ^ 2 + 171 * r - 11) / 64) in *.
    set (b := (- 11 * r ^ 3 + 171 * r ^ 2 - 9 * r + 1) / 64) in *.
    assert (A : a = - l0 - 2 * x) by lra. assert (B : b = x ^ 2 + y ^ 2 + 2 * x * l0) by lra.
    assert (C : r ^ 3 = - l0 * (x ^ 2 + y ^ 2)) by lra.
    unfold value_Q. fold a b. rewrite A, B, C. complexly. }
  assert (ROOT : forall l, value_Q r l = real 0 <-> l = real l0 \/ l = Complex x y \/ l = Complex x (- y)).
  { intros l. rewrite VQ. split.
    - intros Z. destruct (zero_product _ _ Z) as [Z1|Z1].
      + left. unfold plus, real in Z1. injection Z1 as Z1 Z2. apply same_complex; unfold real; cbn [re im] in *; lra.
      + assert (Z2 : times (plus l (Complex (- x) (- y))) (plus l (Complex (- x) y)) = real 0)
          by (rewrite <- Z1; complexly).
        destruct (zero_product _ _ Z2) as [Z3|Z3]; [right; left | right; right];
          unfold plus, real in Z3; injection Z3 as Z3 Z4; apply same_complex; cbn [re im] in *; lra.
    - intros [->|[->| ->]]; complexly. }
  split; [|split; [|exact (fixed_are r R0)]].
  - intros mu nu. split.
    + intros (u & v & H). destruct (eigenvector_cases r R0 (Complex mu nu) u v H) as [(K & _)|(K & _)].
      * apply ROOT in K. destruct K as [K|[K|K]]; unfold real in K; injection K as -> ->; tauto.
      * unfold real in K. injection K as -> ->. tauto.
    + intros [[-> ->]|[[-> ->]|[[-> ->]|[-> ->]]]].
      * exists (Column 0 1 0 1), zero. now apply fixed.
      * apply (there_is_one r R0 (real l0)), ROOT. now left.
      * apply (there_is_one r R0 (Complex x y)), ROOT. right. now left.
      * apply (there_is_one r R0 (Complex x (- y))), ROOT. right. now right.
  - intros mu nu u v u' v' H H'. exact (proportional r R0 (Complex mu nu) u v u' v' H H').
Qed.
