(* Three balls of any masses and radii that collide without end, at times that do not converge: they come
   to rest, seen from one another. *)
From Coq Require Import Reals Arith Lra Lia Classical FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Sequences Ending Classification Contacts NoTriangle Settling.
From Verify Require Import Bounds Weights Impulse.
Open Scope R_scope.
Set Default Proof Using "All".

(* Three balls by their numbers, with their weights: of others, if there were any, nothing is asked. *)
Definition number (b : ball) : nat := match b with B0 => 0 | B1 => 1 | B2 => 2 end.
Definition named (k : nat) : ball := match k with O => B0 | S O => B1 | _ => B2 end.
Definition of_three (f : ball -> vector) (k : nat) : vector :=
  match k with 0%nat => f B0 | 1%nat => f B1 | 2%nat => f B2 | _ => fun _ => 0 end.
Lemma three_number f b : of_three f (number b) = f b.
Proof. now destruct b. Qed.
Lemma named_number b : named (number b) = b.
Proof. now destruct b. Qed.

Lemma dot_zero d : dot d (fun _ => 0) (fun _ => 0) = 0.
Proof. induction d as [|d IH]; cbn [dot]; [reflexivity | rewrite IH; ring]. Qed.

Section Three.
Variable d : nat.
Variables mass radius : ball -> R.
Variables scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis round : forall b, 0 < radius b.
Hypothesis run : strikes d mass radius scenes time i j.

Let tau n := time (S n) - time n.
Let weight k := mass (named k).
Let reach k l := radius (named k) + radius (named l).
Let x n := of_three (position (scenes n)).
Let v n := of_three (velocity (scenes n)).
Let arriving n := later (tau n) (scenes n).
(* The momentum that is exchanged in collision n. *)
Definition impulse (n : nat) : R :=
  (rate d (scenes (S n)) (i n) (j n) - rate d (arriving n) (i n) (j n)) /
    ((/ mass (i n) + / mass (j n)) * (radius (i n) + radius (j n))).
Lemma weight_positive k : 0 < weight k. Proof. apply heavy. Qed.
Lemma reach_positive k l : 0 < reach k l.
Proof. unfold reach. pose proof (round (named k)). pose proof (round (named l)). lra. Qed.
Lemma places_next n : position (scenes (S n)) = position (arriving n).
Proof. destruct (run n) as (_ & _ & _ & _ & _ & J & _ & X & _). exact X. Qed.
Lemma between_three f a b : between (of_three f) (number a) (number b) = fun k => f b k - f a k.
Proof. unfold between. now rewrite !three_number. Qed.
Theorem three_collide : many_collide d 2 weight reach x v tau (fun n => number (i n)) (fun n => number (j n)) impulse.
Proof.
  intros n. destruct (run n) as (N & T & C & P & _ & J & Jp & X & V & K). fold (tau n) in *. fold (arriving n) in *. cbn zeta.
  set (a := i n) in *. set (b := j n) in *. unfold reach, weight. rewrite !named_number.
  pose proof (heavy a) as Ma. pose proof (heavy b) as Mb. pose proof (round a) as Ra. pose proof (round b) as Rb.
  set (s := radius a + radius b) in *. assert (S0 : 0 < s) by (unfold s; lra).
  assert (E : between (x (S n)) (number a) (number b) = to (arriving n) a b).
  { unfold x. rewrite between_three, X. reflexivity. }
  assert (SQ : dot d (to (arriving n) a b) (to (arriving n) a b) = s * s).
  { change (square d (arriving n) a b = s * s). now rewrite square_of_distance, C. }
  assert (OLD : opening d (x (S n)) (v n) (number a) (number b) = rate d (arriving n) a b).
  { unfold opening. rewrite E. unfold v. now rewrite between_three. }
  assert (NEW : opening d (x (S n)) (v (S n)) (number a) (number b) = rate d (scenes (S n)) a b).
  { unfold opening. rewrite E. unfold v. rewrite between_three. unfold rate, to. now rewrite X. }
  assert (W : hit_with mass J a b (arriving n) (scenes (S n))) by now split.
  assert (R : rate d (scenes (S n)) a b = rate d (arriving n) a b + (J / mass a + J / mass b) * (s * s)).
  { unfold rate. rewrite (same_places _ _ a b X), (own_velocity mass J a b _ _ N W), dot_linear_right, SQ. ring. }
  assert (JI : impulse n = J * s).
  { unfold impulse. fold a b s. rewrite R. field. repeat split; lra. }
  rewrite E, SQ, OLD, NEW, JI. split.
  { split; [unfold number; destruct a; lia|]. split; [unfold number; destruct b; lia|]. intros Q. apply N.
    rewrite <- (named_number a), <- (named_number b). now rewrite Q. }
  split; [unfold tau in *; lra|]. split.
  { unfold x, v, flown. rewrite X. extensionality k. extensionality l.
    destruct k as [|[|[|k]]]; cbn; try reflexivity. ring. }
  split; [reflexivity|]. split; [apply Rmult_le_pos; lra|].
  split; [intros k; unfold v; rewrite !three_number, V, same_true; change (velocity (arriving n)) with (velocity (scenes n)); field; lra|].
  split; [intros k; unfold v; rewrite !three_number, V, same_true, same_false by congruence; change (velocity (arriving n)) with (velocity (scenes n)); field; lra|].
  split; [|now split].
  intros k A B. unfold v. apply same_vector. intros l.
  destruct k as [|[|[|k]]]; cbn; try reflexivity;
    rewrite V, !same_false; trivial; intros Q; rewrite <- Q in *; cbn in *; congruence.
Qed.

Lemma met_in_scene n : opening d (x (S n)) (v n) (number (i n)) (number (j n)) = rate d (arriving n) (i n) (j n).
Proof. unfold opening, x, v. now rewrite !between_three, places_next. Qed.
Theorem meeting_bounded : exists bound, forall n,
  sum_f_R0 (fun m => - rate d (later (time (S m) - time m) (scenes m)) (i m) (j m) / (radius (i m) + radius (j m))) n <= bound.
Proof.
  destruct (speeds_summable d 2 weight reach weight_positive reach_positive x v tau _ _ impulse three_collide) as (b & B).
  exists b. intros n. apply Rle_trans with (2 := B n). right. apply sum_eq. intros m _. rewrite met_in_scene.
  unfold reach. now rewrite !named_number.
Qed.

(* --- relative velocities ------------------------------------------------------------------------- *)

Lemma relative_converges a b k : (k < d)%nat -> exists l, Un_cv (fun n => relative (scenes n) a b k) l.
Proof.
  intros K. assert (G : forall c, exists l, Un_cv (fun n => velocity (scenes n) c k) l).
  { intros c. destruct (velocities_converge d 2 weight reach weight_positive reach_positive x v tau _ _ impulse three_collide
      (number c) k K) as (l & L). exists l. intros e E. destruct (L e E) as (m & M). exists m. intros n H. specialize (M n H).
    unfold v in M. now rewrite three_number in M. }
  destruct (G a) as (p & A), (G b) as (q & B). exists (q - p). exact (CV_minus _ _ _ _ B A).
Qed.
Lemma times_grow : Un_growing time.
Proof. intros n. destruct (run n) as (_ & L & _). lra. Qed.
Definition often (a b : ball) : Prop := forall m, exists n, (m <= n)%nat /\ meets i j n a b.
Lemma often_symmetric a b : often a b -> often b a.
Proof. intros O m. destruct (O m) as (n & L & M). exists n. split; [exact L | now apply meets_symmetric]. Qed.
(* Two of the pairs collide again and again. *)
Lemma two_often : exists o a c, distinct_balls o a c /\ often o a /\ often o c.
Proof.
  assert (G : forall a b c, distinct_balls a b c -> ~ often a b -> often a c /\ often b c).
  { intros a b c D N. apply not_all_ex_not in N. destruct N as (m & N).
    assert (NO : forall n, (m <= n)%nat -> ~ meets i j n a b) by (intros n L M; apply N; now exists n).
    assert (ONE : forall n, (m <= n)%nat -> meets i j n a c \/ meets i j n b c).
    { intros n L. exact (other_pair d mass radius scenes time i j run n a b c D (NO n L)). }
    split; intros k; destruct (ONE (m + k)%nat ltac:(lia)) as [M|M]; try (exists (m + k)%nat; split; [lia | exact M]);
      destruct (ONE (S (m + k)) ltac:(lia)) as [M'|M']; try (exists (S (m + k)); split; [lia | exact M']);
      exfalso; exact (no_pair_twice d mass radius scenes time i j run _ _ _ M M'). }
  destruct (classic (often B0 B1)) as [O1|O1].
  - destruct (classic (often B0 B2)) as [O2|O2].
    + exists B0, B1, B2. repeat split; (discriminate || assumption).
    + destruct (G B0 B2 B1 ltac:(repeat split; discriminate) O2) as [P Q].
      exists B1, B0, B2. repeat split; try discriminate; now apply often_symmetric.
  - destruct (G B0 B1 B2 ltac:(repeat split; discriminate) O1) as [P Q].
    exists B2, B0, B1. repeat split; try discriminate; now apply often_symmetric.
Qed.
Lemma contact_at n a b : meets i j n a b -> distance d (scenes (S n)) a b = radius a + radius b.
Proof.
  destruct (run n) as (_ & _ & C & _). fold (tau n) in C. fold (arriving n) in C. intros M.
  unfold distance. rewrite (same_places _ _ a b (places_next n)). fold (distance d (arriving n) a b).
  destruct M as [[E F]|[E F]]; rewrite E, F in C; [exact C|]. rewrite distance_symmetric, C. ring.
Qed.

Section Unbounded.
Hypothesis unbounded : ~ exists T, Un_cv time T.
Lemma late b m : exists n, (n >= m)%nat /\ b < time n.
Proof.
  apply NNPP. intros N. apply unbounded. apply (bounded_increasing_converges time (Rmax b (time m))).
  - exact times_grow.
  - intros n. destruct (le_lt_dec m n) as [L|L].
    + apply Rle_trans with b; [|apply Rmax_l]. apply Rnot_lt_le. intros K. apply N. now exists n.
    + apply Rle_trans with (time m); [|apply Rmax_r].
      pose proof (growing_prop time m n times_grow ltac:(lia)). lra.
Qed.
(* A pair that meets again and again is not far away at late times. *)
Lemma no_drift a b k l : (k < d)%nat -> often a b -> Un_cv (fun n => relative (scenes n) a b k) l -> l <= 0.
Proof.
  intros K O L. apply Rnot_lt_le. intros P. destruct (L (l / 2) ltac:(lra)) as (N & H).
  assert (S0 : forall n, (n >= N)%nat -> to (scenes N) a b k + l / 2 * (time n - time N) <= to (scenes n) a b k).
  { intros n G. induction G as [|n G IH]; [lra|]. specialize (H n G). unfold R_dist in H. apply Rabs_def2 in H.
    rewrite (same_places _ _ a b (places_next n)). unfold arriving. rewrite to_later. unfold combined.
    destruct (run n) as (_ & T & _). fold (tau n) in T.
    assert (tau n * (l / 2) <= tau n * relative (scenes n) a b k) by (apply Rmult_le_compat_l; lra). unfold tau in *. lra. }
  set (far := radius a + radius b + Rabs (to (scenes N) a b k)). pose proof (round a). pose proof (round b).
  pose proof (Rabs_pos (to (scenes N) a b k)). pose proof (Rle_abs (- to (scenes N) a b k)) as A. rewrite Rabs_Ropp in A.
  destruct (late (time N + far / (l / 2)) N) as (m & M & TM). destruct (O m) as (n & LN & ME).
  specialize (S0 (S n) ltac:(lia)). pose proof (growing_prop time (S n) m times_grow ltac:(lia)) as G.
  assert (F : l / 2 * (far / (l / 2)) < l / 2 * (time (S n) - time N)) by (apply Rmult_lt_compat_l; lra).
  replace (l / 2 * (far / (l / 2))) with far in F by (field; lra).
  pose proof (coordinate_at_most d (to (scenes (S n)) a b) k K) as C.
  change (dot d (to (scenes (S n)) a b) (to (scenes (S n)) a b)) with (square d (scenes (S n)) a b) in C.
  rewrite square_of_distance, (contact_at n a b ME) in C. set (y := to (scenes (S n)) a b k) in *.
  assert ((radius a + radius b) * (radius a + radius b) < y * y) by (apply Rmult_le_0_lt_compat; unfold far in *; lra). lra.
Qed.
Lemma pair_stops a b k : (k < d)%nat -> often a b -> Un_cv (fun n => relative (scenes n) a b k) 0.
Proof.
  intros K O. destruct (relative_converges a b k K) as (l & L).
  assert (L' : Un_cv (fun n => relative (scenes n) b a k) (- l)).
  { intros e E. destruct (CV_opp _ _ L e E) as (m & M). exists m. intros n G. specialize (M n G). unfold opp_seq in M.
    replace (relative (scenes n) b a k) with (- relative (scenes n) a b k) by (unfold relative; ring). exact M. }
  pose proof (no_drift a b k l K O L). pose proof (no_drift b a k (- l) K (often_symmetric _ _ O) L').
  replace 0 with l by lra. exact L.
Qed.
Theorem velocities_vanish : stops d scenes.
Proof.
  destruct two_often as (o & a & c & D & A & C).
  assert (FROM : forall b k, (k < d)%nat -> Un_cv (fun n => relative (scenes n) o b k) 0).
  { intros b k K. assert (T : b = o \/ b = a \/ b = c) by (destruct D as (D1 & D2 & D3), o, a, c, b; try easy; auto).
    destruct T as [ -> | [ -> | -> ] ]; [| now apply pair_stops | now apply pair_stops].
    intros e E. exists O. intros n _. rewrite relative_self. unfold R_dist. now rewrite Rminus_diag_eq, Rabs_R0. }
  intros y z k K e E. replace 0 with (0 - 0) by ring.
  destruct (CV_minus _ _ _ _ (FROM z k K) (FROM y k K) e E) as (m & M). exists m. intros n G. specialize (M n G).
  unfold R_dist, relative in *.
  replace (velocity (scenes n) z k - velocity (scenes n) y k - (0 - 0)) with (velocity (scenes n) z k - velocity (scenes n) o k -
    (velocity (scenes n) y k - velocity (scenes n) o k) - (0 - 0)) by ring. exact M.
Qed.

(* --- in the frame of the centre of mass --------------------------------------------------------- *)

Let xc n := centred 2 weight (x n).
Let vc n := centred 2 weight (v n).
Let total := mass B0 + mass B1 + mass B2.
Lemma total_positive : 0 < total.
Proof. unfold total. pose proof (heavy B0). pose proof (heavy B1). pose proof (heavy B2). lra. Qed.
Lemma centred_is f b k : centred 2 weight (of_three f) (number b) k =
  (mass B0 * (f b k - f B0 k) + mass B1 * (f b k - f B1 k) + mass B2 * (f b k - f B2 k)) / total.
Proof.
  unfold centred, weighted. rewrite three_number. cbn [sum_f_R0 of_three]. unfold weight. cbn [named]. fold total.
  pose proof total_positive. unfold total in *. field. lra.
Qed.
Lemma rests_in_frame : Un_cv (fun n => inertia d 2 weight (vc n)) 0.
Proof.
  assert (Z : forall b k, (k < d)%nat -> Un_cv (fun n => vc n (number b) k) 0).
  { intros b k K. assert (Q : Un_cv (fun n => (mass B0 * relative (scenes n) B0 b k + mass B1 * relative (scenes n) B1 b k +
      mass B2 * relative (scenes n) B2 b k) * / total) 0).
    { assert (C : forall y, Un_cv (fun _ : nat => y) y) by (intros y e E; exists O; intros n _; now rewrite R_dist_eq).
      replace 0 with ((mass B0 * 0 + mass B1 * 0 + mass B2 * 0) * / total) by ring.
      assert (P : forall m y, Un_cv (fun n => m * relative (scenes n) y b k) (m * 0))
        by (intros m y; apply (CV_mult (fun _ => m)); [apply C | now apply velocities_vanish]).
      exact (CV_mult _ (fun _ => / total) _ _ (CV_plus _ _ _ _ (CV_plus _ _ _ _ (P _ B0) (P _ B1)) (P _ B2)) (C _)). }
    intros e E. destruct (Q e E) as (m & M). exists m. intros n G. specialize (M n G). unfold vc, v. rewrite centred_is. exact M. }
  assert (D : forall b, Un_cv (fun n => mass b * dot d (vc n (number b)) (vc n (number b))) (mass b * 0)).
  { intros b. apply (CV_mult (fun _ => mass b)); [intros e E; exists O; intros n _; now rewrite R_dist_eq|].
    rewrite <- (dot_zero d).
    exact (dot_converges d _ _ (fun _ => 0) (fun _ => 0) (Z b) (Z b)). }
  intros e E. destruct (CV_plus _ _ _ _ (CV_plus _ _ _ _ (D B0) (D B1)) (D B2) e E) as (m & M). exists m. intros n G.
  specialize (M n G). rewrite !Rmult_0_r, !Rplus_0_r in M. exact M.
Qed.
Let in_frame := centred_run d 2 weight reach weight_positive reach_positive x v tau _ _ impulse three_collide.
Theorem settles_late : exists z, settles d scenes z.
Proof.
  apply settled_by_coordinates. intros a b k K.
  assert (P : forall c, exists l, Un_cv (fun n => xc n (number c) k) l).
  { intros c. apply (places_converge d 2 weight reach weight_positive reach_positive xc vc tau _ _ impulse in_frame rests_in_frame); [|exact K].
    destruct c; cbn; lia. }
  destruct (P a) as (p & A), (P b) as (q & B). exists (q - p). intros e E. destruct (CV_minus _ _ _ _ B A e E) as (m & M).
  exists m. intros n G. specialize (M n G). replace (to (scenes n) a b k) with (xc n (number b) k - xc n (number a) k); [exact M|].
  unfold xc, x. rewrite !centred_is. unfold to. pose proof total_positive. unfold total in *. field. lra.
Qed.
(* The sum over pairs is that over the balls, in this frame, times the whole mass. *)
Notation over_pairs := (over_pairs mass).
Lemma centred_vector f b : centred 2 weight (of_three f) (number b) = combined (/ total * mass B0) (fun k => f b k - f B0 k)
  1 (combined (/ total * mass B1) (fun k => f b k - f B1 k) (/ total * mass B2) (fun k => f b k - f B2 k)).
Proof. apply same_vector. intros k. rewrite centred_is. unfold combined, Rdiv. ring. Qed.
Theorem pairs_of_frame n : over_pairs (rate d (scenes n)) = total * virial d 2 weight (xc n) (vc n).
Proof.
  assert (Z : forall f b, (fun k : nat => f b k - f b k) = scaled 0 (fun k : nat => f B1 k - f B0 k : R))
    by (intros; apply same_vector; intros k; unfold scaled; ring).
  assert (N : forall f a b, (fun k : nat => f a k - f b k) = combined (-1) (fun k => f b k - f B0 k) 1 (fun k => f a k - f B0 k : R))
    by (intros; apply same_vector; intros k; unfold combined; ring).
  unfold virial, product. cbn [sum_f_R0]. unfold weight. cbn [named]. unfold xc, vc, x, v.
  pose proof (fun f => centred_vector f B0) as C0. pose proof (fun f => centred_vector f B1) as C1.
  pose proof (fun f => centred_vector f B2) as C2. cbn [number] in C0, C1, C2. rewrite !C0, !C1, !C2. unfold Classification.over_pairs, rate, to, relative.
  set (p := position (scenes n)). set (q := velocity (scenes n)).
  rewrite (N p B2 B1), (N q B2 B1), (N p B0 B1), (N q B0 B1), (N p B0 B2), (N q B0 B2), (N p B1 B2), (N q B1 B2), !(Z p), !(Z q).
  set (a := fun k => p B1 k - p B0 k). set (c := fun k => p B2 k - p B0 k).
  set (u := fun k => q B1 k - q B0 k). set (w := fun k => q B2 k - q B0 k).
  repeat rewrite dot_linear. repeat rewrite dot_linear_right. repeat rewrite dot_scaled. repeat rewrite dot_scaled_right.
  repeat rewrite dot_linear. repeat rewrite dot_linear_right. repeat rewrite dot_scaled. repeat rewrite dot_scaled_right.
  pose proof total_positive. unfold total in *. field. lra.
Qed.
Theorem never_recede n : over_pairs (rate d (scenes n)) <= 0.
Proof.
  pose proof (never_recedes d 2 weight reach weight_positive reach_positive xc vc tau _ _ impulse in_frame rests_in_frame n) as V.
  rewrite pairs_of_frame. pose proof total_positive.
  assert (0 <= total * - virial d 2 weight (xc n) (vc n)); [apply Rmult_le_pos|]; lra.
Qed.
(* The angular momentum is kept, and tends to 0 where the velocities do. *)
Theorem no_angular_momentum n k l : (k < d)%nat -> (l < d)%nat -> over_pairs (moment (scenes n) k l) = 0.
Proof.
  intros K L. destruct settles_late as (z & Z).
  assert (E : forall m, over_pairs (moment (scenes m) k l) = over_pairs (moment (scenes 0%nat) k l)).
  { assert (F : forall m, over_pairs (moment (scenes m) k l) = total * turning 2 weight (xc m) (vc m) k l).
    { intros m. unfold turning. cbn [sum_f_R0]. unfold weight. cbn [named]. unfold xc, vc, x, v.
      pose proof (fun f => centred_is f B0) as C0. pose proof (fun f => centred_is f B1) as C1.
      pose proof (fun f => centred_is f B2) as C2. cbn [number] in C0, C1, C2. rewrite !C0, !C1, !C2. unfold Classification.over_pairs, moment, to, relative. pose proof total_positive. unfold total in *. field. lra. }
    intros m. rewrite !F. f_equal.
    exact (turning_kept d 2 weight reach weight_positive reach_positive xc vc tau _ _ impulse in_frame m k l). }
  assert (M : forall a b, Un_cv (fun m => moment (scenes m) k l a b) 0).
  { intros a b. unfold moment. replace 0 with (to z a b k * 0 - to z a b l * 0) by ring.
    apply CV_minus; apply CV_mult; try (now apply Z); now apply velocities_vanish. }
  assert (C : forall y, Un_cv (fun _ : nat => y) y) by (intros y e G; exists O; intros m _; now rewrite R_dist_eq).
  assert (S : Un_cv (fun m => over_pairs (moment (scenes m) k l)) 0).
  { unfold Classification.over_pairs. replace 0 with (mass B0 * mass B1 * 0 + mass B0 * mass B2 * 0 + mass B1 * mass B2 * 0) by ring.
    assert (P : forall m a b, Un_cv (fun n => m * moment (scenes n) k l a b) (m * 0))
      by (intros m a b; apply (CV_mult (fun _ => m)); [apply C | apply M]).
    exact (CV_plus _ _ _ _ (CV_plus _ _ _ _ (P _ B0 B1) (P _ B0 B2)) (P _ B1 B2)). }
  rewrite E. apply (UL_sequence (fun _ => over_pairs (moment (scenes 0%nat) k l))); [apply C|]. intros e G.
  destruct (S e G) as (m & H). exists m. intros p P. specialize (H p P). now rewrite E in H.
Qed.
End Unbounded.
Theorem settles_always : exists z, settles d scenes z.
Proof.
  destruct (classic (exists T, Un_cv time T)) as [(T & L)|N]; [|now apply settles_late].
  exact (settles_in_time d mass radius scenes time i j T heavy run L).
Qed.
End Three.
