(* What Classification.v says is proved. *)
From Coq Require Import Reals Arith Lra Lia Classical.
From Verify Require Import Theorem1 Vectors Motion Sequences Ending Parameters Classification Contacts.
From Verify Require Import NoTriangle Settling Unbounded Endless LeastAngle.
Open Scope R_scope.

Theorem no_triangle_holds : no_triangle.
Proof.
  intros d mass radius scenes time T i j M P S L.
  destruct (settles_in_time d mass radius scenes time i j T M S L) as (z & Z).
  destruct (settled_in_turn d mass radius scenes time i j z M P S Z) as (o & a & c & N & H).
  exists z, o, a, c, N. now split.
Qed.

Lemma limit_later (u : nat -> R) l N : Un_cv u l -> Un_cv (fun n => u (N + n)%nat) l.
Proof. intros A e E. destruct (A e E) as (m & M). exists m. intros n L. apply M. lia. Qed.
Lemma limit_before (u : nat -> R) l N : Un_cv (fun n => u (N + n)%nat) l -> Un_cv u l.
Proof.
  intros A e E. destruct (A e E) as (m & M). exists (N + m)%nat. intros n L.
  replace n with (N + (n - N))%nat by lia. apply M. lia.
Qed.
Lemma small_square (u v : nat -> R) : Un_cv v 0 -> (forall n, u n * u n <= v n) -> Un_cv u 0.
Proof.
  intros V B e E. destruct (V (e * e)) as (m & M); [now apply Rmult_lt_0_compat|].
  exists m. intros n L. specialize (M n L). specialize (B n). unfold R_dist in *.
  rewrite Rminus_0_r in *. pose proof (Rle_abs (v n)).
  rewrite <- (Rabs_right e) by lra. apply Rsqr_lt_abs_0. unfold Rsqr. lra.
Qed.
Lemma limit_zero_by_parity (u p q : nat -> R) : Un_cv p 0 -> Un_cv q 0 ->
  (forall n, u n = p n \/ u n = q n) -> Un_cv u 0.
Proof.
  intros P Q B e E. destruct (P e E) as (k & K). destruct (Q e E) as (m & M). exists (max k m). intros n L.
  specialize (K n ltac:(lia)). specialize (M n ltac:(lia)). destruct (B n) as [-> | ->]; assumption.
Qed.
Lemma limit_unique_constant (u : nat -> R) l c : Un_cv u l -> (forall n, u n = c) -> l = c.
Proof. intros L E. apply (often_equal u l c L). intros m. exists m. now split. Qed.

(* Collisions without end of balls of equal masses whose places converge. *)
Section Settled.
Variable d : nat.
Variable r : R.
Variable radius : ball -> R.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Hypothesis round : forall b, 0 < radius b.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis run : strikes d (fun _ => 1) radius scenes time i j.
Hypothesis slowed : restituted d r scenes time i j.
Variable z : scene.
Hypothesis converge : settles d scenes z.
Variables o a c : ball.
Variable N : nat.
Hypothesis distinct : distinct_balls o a c.
Hypothesis in_turn : in_turn_from N i j o a c.
Notation reach := (fun b => radius o + radius b).
Hypothesis touch_a : distance d z o a = reach a.
Hypothesis touch_c : distance d z o c = reach c.
Lemma reach_positive b : 0 < reach b.
Proof. pose proof (round o). pose proof (round b). lra. Qed.

Lemma products x y w : Un_cv (fun n => dot d (to (scenes n) x y) (to (scenes n) x w)) (dot d (to z x y) (to z x w)).
Proof. apply dot_converges; intros k K; now apply converge. Qed.
Lemma distances x y : Un_cv (fun n => distance d (scenes n) x y) (distance d z x y).
Proof.
  unfold distance. apply (continuity_seq sqrt (fun n => dot d (to (scenes n) x y) (to (scenes n) x y))).
  - apply continuity_pt_sqrt. apply dot_self.
  - apply products.
Qed.
Lemma angles : Un_cv (fun n => minus_cosine_at d (scenes n) o a c) (minus_cosine_at d z o a c).
Proof.
  unfold minus_cosine_at. apply CV_opp.
  apply (CV_mult (fun n => dot d (to (scenes n) o a) (to (scenes n) o c))
    (fun n => / (distance d (scenes n) o a * distance d (scenes n) o c))).
  - apply products.
  - apply (continuity_seq Rinv (fun n => distance d (scenes n) o a * distance d (scenes n) o c)).
    + apply continuity_pt_inv; [apply derivable_continuous_pt, derivable_pt_id|]. rewrite touch_a, touch_c.
      pose proof (Rmult_lt_0_compat _ _ (reach_positive a) (reach_positive c)). lra.
    + apply (CV_mult (fun n => distance d (scenes n) o a) (fun n => distance d (scenes n) o c)); apply distances.
Qed.
Let late n := scenes (N + n)%nat.
Let tau n := time (S (N + n)) - time (N + n)%nat.
Let arriving n := later (tau n) (late n).
Let next := partner a c.
Let other := spectator a c.
Lemma runs_in_turn n : 0 < tau n /\ distance d (arriving n) o (next n) = reach (next n) /\
  rate d (arriving n) o (next n) < 0 /\ reach (other n) <= distance d (arriving n) o (other n) /\
  even_hit d r o (next n) (arriving n) (late (S n)).
Proof.
  destruct (others o a c distinct n) as (N1 & N2 & N3). fold next other in N1, N2, N3.
  destruct (run (N + n)%nat) as (M & T & C & P & O & E). pose proof (slowed (N + n)%nat) as V.
  fold (tau n) (late n) in *. fold (arriving n) in *.
  replace (scenes (S (N + n))) with (late (S n)) in * by (unfold late; f_equal; lia).
  split; [exact T|].
  pose proof (in_turn n) as W. change (if Nat.even n then c else a) with (next n) in W.
  destruct W as [[I J]|[I J]]; rewrite I, J in *.
  - repeat (split; [assumption|]). split; [apply O; congruence | now split].
  - rewrite distance_symmetric, Rplus_comm in C. rewrite rate_symmetric in P. split; [exact C|]. split; [exact P|].
    split; [apply O; congruence|]. apply even_hit_symmetric; [congruence | now split].
Qed.
Lemma next_square n : 0 < square d (arriving n) o (next n).
Proof.
  destruct (runs_in_turn n) as (_ & C & _). rewrite square_of_distance, C. pose proof (reach_positive (next n)).
  now apply Rmult_lt_0_compat.
Qed.
Lemma touches x : distance d z o x = reach x -> Un_cv (fun n => distance d (late n) o x) (reach x).
Proof. intros E. pose proof (limit_later _ _ N (distances o x)) as L. rewrite E in L. exact L. Qed.
Lemma least : 4 * sqrt r / (1 + r) <= minus_cosine_at d z o a c.
Proof.
  apply (angle_at_least d r _ late tau o a c reach reach_positive); trivial; try now apply touches.
  - exact runs_in_turn.
  - exact (limit_later _ _ N angles).
Qed.
Lemma most : minus_cosine_at d z o a c <= 1.
Proof.
  unfold minus_cosine_at. rewrite touch_a, touch_c. pose proof (cauchy_schwarz d (to z o a) (to z o c)) as C.
  change (dot d (to z o a) (to z o a)) with (square d z o a) in C.
  change (dot d (to z o c) (to z o c)) with (square d z o c) in C. rewrite !square_of_distance, touch_a, touch_c in C.
  set (x := dot d (to z o a) (to z o c)) in *. pose proof (Rmult_lt_0_compat _ _ (reach_positive a) (reach_positive c)) as P.
  set (p := (radius o + radius a) * (radius o + radius c)) in *. apply Rnot_lt_le. intros L.
  assert (Q : p < - x).
  { apply Rmult_lt_reg_r with (/ p); [now apply Rinv_0_lt_compat|]. rewrite Rinv_r by lra. unfold Rdiv in L. lra. }
  assert (p * p < - x * - x) by (apply Rmult_le_0_lt_compat; lra).
  replace (x ^ 2) with (- x * - x) in C by ring. unfold p in *. lra.
Qed.
Lemma all_stop : Un_cv (next_speed d late o a c) 0 -> stops d scenes.
Proof.
  intros V.
  assert (P : forall k, (k < d)%nat -> Un_cv (fun n => relative (late n) o (next n) k) 0).
  { intros k K. apply (small_square _ _ V). intros n. now apply coordinate_at_most. }
  assert (Q : forall k, (k < d)%nat -> Un_cv (fun n => relative (late n) o (other n) k) 0).
  { intros k K.
    (* The change of velocity is along the line of the centres: no larger than the velocity. *)
    set (share n := rate d (arriving n) o (next n) / square d (arriving n) o (next n) * to (arriving n) o (next n) k).
    assert (F : Un_cv share 0).
    { apply (small_square _ _ V). intros n. pose proof (next_square n) as S. unfold share.
      pose proof (coordinate_at_most d (to (arriving n) o (next n)) k K) as X.
      fold (square d (arriving n) o (next n)) in X.
      pose proof (cauchy_schwarz d (to (arriving n) o (next n)) (relative (arriving n) o (next n))) as Q.
      fold (rate d (arriving n) o (next n)) (square d (arriving n) o (next n)) in Q.
      change (dot d (relative (arriving n) o (next n)) (relative (arriving n) o (next n))) with
        (next_speed d late o a c n) in Q.
      set (g := rate d (arriving n) o (next n)) in *. set (q := square d (arriving n) o (next n)) in *.
      set (x := to (arriving n) o (next n) k) in *. set (w := next_speed d late o a c n) in *.
      replace (g / q * x * (g / q * x)) with (g / q * (g / q) * (x * x)) by ring.
      apply Rle_trans with (g / q * (g / q) * q).
      - apply Rmult_le_compat_l; [apply Rle_0_sqr | exact X].
      - apply Rmult_le_reg_r with q; [exact S|]. replace (g / q * (g / q) * q * q) with (g ^ 2) by (field; lra). lra. }
    assert (W : Un_cv (fun n => relative (late (S n)) o (next (S n)) k + (1 + r) / 2 * share n) 0).
    { replace 0 with (0 + (1 + r) / 2 * 0) by ring. apply CV_plus.
      - exact (limit_later _ _ 1 (P k K)).
      - apply (CV_mult (fun _ => (1 + r) / 2)); [|exact F].
        intros e E. exists O. intros n _. unfold R_dist. now rewrite Rminus_diag_eq, Rabs_R0. }
    intros e E. destruct (W e E) as (m & M). exists m. intros n L. specialize (M n L).
    destruct (runs_in_turn n) as (_ & _ & _ & _ & R1).
    destruct (others o a c distinct n) as (N1 & N2 & N3). fold next other in N1, N2, N3.
    unfold next at 1 in M. rewrite next_partner in M. fold other in M.
    rewrite (even_velocity d r o (next n) (other n) _ _ N1 N2 N3 (next_square n) R1) in M. unfold combined, share in M.
    change (relative (arriving n)) with (relative (late n)) in M.
    match type of M with R_dist ?x _ < _ => replace (relative (late n) o (other n) k) with x by ring end. exact M. }
  assert (ALL : forall x k, (k < d)%nat -> Un_cv (fun n => relative (scenes n) o x k) 0).
  { intros x k K. apply (limit_before _ _ N). destruct distinct as (D1 & D2 & D3).
    assert (T : x = o \/ x = a \/ x = c) by (destruct o, a, c, x; try easy; auto).
    destruct T as [-> | T].
    - intros e E. exists O. intros n _. rewrite relative_self. unfold R_dist. now rewrite Rminus_diag_eq, Rabs_R0.
    - apply (limit_zero_by_parity _ _ _ (P k K) (Q k K)). intros n. unfold next, other, partner, spectator, late.
      destruct (Nat.even n), T as [-> | ->]; auto. }
  intros x y k K. replace 0 with (0 - 0) by ring.
  pose proof (CV_minus _ _ _ _ (ALL y k K) (ALL x k K)) as M. intros e E. destruct (M e E) as (m & B).
  exists m. intros n L. specialize (B n L). unfold relative in *.
  replace (velocity (scenes n) y k - velocity (scenes n) x k) with (velocity (scenes n) y k -
    velocity (scenes n) o k - (velocity (scenes n) x k - velocity (scenes n) o k)) by ring. exact B.
Qed.
Lemma second : 2 * cube_root r * (1 + cube_root r) / (1 + r) <= minus_cosine_at d z o a c \/ stops d scenes.
Proof.
  pose proof (cube_root_positive r) as S. pose proof (cube_of_root r (proj1 restitutes)) as C.
  destruct (second_condition d r _ late tau o a c reach reach_positive restitutes distinct runs_in_turn
    (touches a touch_a) (touches c touch_c) (limit_later _ _ N angles) (cube_root r) S) as [P|P].
  - rewrite <- C at 4. ring.
  - left. replace (2 * cube_root r * (1 + cube_root r)) with (2 * (cube_root r + cube_root r * cube_root r)) by ring.
    exact P.
  - right. now apply all_stop.
Qed.
End Settled.
Lemma angle_there d r radius scenes time i j z o a c N : (forall b, 0 < radius b) -> 0 < r <= 1 ->
  strikes d (fun _ => 1) radius scenes time i j -> restituted d r scenes time i j -> settles d scenes z ->
  distinct_balls o a c -> in_turn_from N i j o a c ->
  distance d z o a = radius o + radius a /\ distance d z o c = radius o + radius c /\
  4 * sqrt r / (1 + r) <= minus_cosine_at d z o a c <= 1 /\
  (2 * cube_root r * (1 + cube_root r) / (1 + r) <= minus_cosine_at d z o a c \/ stops d scenes).
Proof.
  intros P R S V Z D T.
  destruct (touching_in_turn d (fun _ => 1) radius scenes time i j z P S Z o a c N T) as [A C].
  split; [exact A|]. split; [exact C|]. split; [split|].
  - exact (least d r radius scenes time i j P R S V z Z o a c N D T A C).
  - exact (most d radius P z o a c A C).
  - exact (second d r radius scenes time i j P R S V z Z o a c N D T A C).
Qed.
Theorem least_angle_any_radii_holds : least_angle_any_radii.
Proof.
  intros d m radius r scenes time i j M P R S V. assert (M' : forall _ : ball, 0 < m) by (intros; exact M).
  destruct (Unbounded.settles_always d (fun _ => m) radius scenes time i j M' P S) as (z & Z).
  destruct (settled_in_turn d (fun _ => m) radius scenes time i j z M' P S Z) as (o & a & c & N & D & W & _).
  exists z, o, a, c, N. repeat (split; [assumption|]).
  apply (angle_there d r radius scenes time i j z o a c N P R); trivial.
  intros n. destruct (S n) as (S1 & S2 & S3 & S4 & S5 & S6). repeat (split; [assumption|]).
  exact (proj1 (even_hit_of d m r _ _ _ _ M S6 (V n))).
Qed.

Section FromEndless.
Variable d : nat.
Variable r : R.
Variable first : scene.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis run : endless d r first scenes time i j.
Lemma ends_there z o a c N : settles d scenes z -> distinct_balls o a c -> in_turn_from N i j o a c ->
  distance d z o a = 1 /\ distance d z o c = 1 /\ 4 * sqrt r / (1 + r) <= minus_cosine_at d z o a c <= 1 /\
  (2 * cube_root r * (1 + cube_root r) / (1 + r) <= minus_cosine_at d z o a c \/ stops d scenes).
Proof.
  intros Z D T. destruct (angle_there d r (fun _ => 1 / 2) scenes time i j z o a c N ltac:(intros; lra) restitutes
    (endless_strikes d r first scenes time i j restitutes run)) as (A & C & H); trivial.
  - intros n. destruct run as (_ & _ & G). destruct (G n) as (M & _ & E & _ & _ & ->). now apply rate_collided.
  - split; [lra|]. split; [lra | exact H].
Qed.
Theorem angle_in_the_end : exists z o a c N, settles d scenes z /\ distinct_balls o a c /\
  in_turn_from N i j o a c /\ distance d z o a = 1 /\ distance d z o c = 1 /\
  4 * sqrt r / (1 + r) <= minus_cosine_at d z o a c <= 1 /\
  (2 * cube_root r * (1 + cube_root r) / (1 + r) <= minus_cosine_at d z o a c \/ stops d scenes).
Proof.
  destruct (settles_always d r first scenes time i j restitutes run) as (z & Z).
  destruct (settled_in_turn d (fun _ => 1) (fun _ => 1 / 2) scenes time i j z ltac:(intros; lra)
    ltac:(intros; lra) (endless_strikes d r first scenes time i j restitutes run) Z)
    as (o & a & c & N & D & T & _).
  exists z, o, a, c, N. repeat (split; [assumption|]). now apply (ends_there z o a c N).
Qed.
(* If all relative velocities vanish, then so does the angular momentum. *)
Lemma spin_at_rest k l : stops d scenes -> (k < d)%nat -> (l < d)%nat -> spin first k l = 0.
Proof.
  intros S K L. destruct (settles_always d r first scenes time i j restitutes run) as (z & Z).
  assert (M : forall x y, Un_cv (fun n => moment (scenes n) k l x y) 0).
  { intros x y. unfold moment. replace 0 with (to z x y k * 0 - to z x y l * 0) by ring.
    apply CV_minus; apply CV_mult; try (now apply Z); now apply S. }
  symmetry. apply (limit_unique_constant (fun n => spin (scenes n) k l)).
  - unfold spin. replace 0 with (0 + 0 + 0) by ring. repeat apply CV_plus; apply M.
  - intros n. rewrite (spin_stays d r first scenes time i j restitutes run n k l).
    destruct run as (F & _). now rewrite F.
Qed.
Lemma no_spin_at_rest : stops d scenes -> spin2 d first = 0.
Proof.
  intros S. pose proof (fun k l => spin_at_rest k l S) as M.
  assert (N : forall n, (n <= d)%nat -> dot n (fun k => dot d (spin first k) (spin first k)) (fun _ => 1) = 0).
  { induction n as [|n IH]; intros L; [reflexivity|]. cbn [dot]. rewrite IH by lia.
    assert (P : forall m, (m <= d)%nat -> dot m (spin first n) (spin first n) = 0).
    { induction m as [|m IH2]; intros L2; [reflexivity|]. cbn [dot]. rewrite IH2, M by lia. ring. }
    rewrite P by lia. ring. }
  unfold spin2. rewrite N by lia. ring.
Qed.
(* In the limit the balls are no farther from one another than on a line. *)
Lemma small_in_the_end : exists z, settles d scenes z /\ size d z <= 6.
Proof.
  destruct angle_in_the_end as (z & o & a & c & N & Z & D & _ & T1 & T2 & _). exists z. split; [exact Z|].
  rewrite size_is.
  destruct (total_is (square d z) o a (square_symmetric d z) ltac:(destruct D; congruence)) as (k & K1 & K2 & W).
  rewrite W. clear W. assert (k = c) by (destruct D as (D1 & D2 & D3), o, a, c, k; easy). subst k.
  pose proof (dot_self d (combined 1 (to z o a) 1 (to z o c))) as P. rewrite square_of_combined in P.
  pose proof (cosines d z o a c) as Q. pose proof (unit_square _ _ _ _ T1) as U1.
  pose proof (unit_square _ _ _ _ T2) as U2. unfold square in *. lra.
Qed.
Lemma not_large m N : 6 < m -> (forall n, (n >= N)%nat -> m <= size d (scenes n)) -> False.
Proof.
  intros L A. destruct small_in_the_end as (z & Z & B).
  pose proof (limit_at_most (fun n => - size d (scenes (N + n)%nat)) (- size d z) (- m)
    (limit_opposite _ _ (limit_later _ _ N (size_converges d scenes z Z)))
    ltac:(intros n; specialize (A (N + n)%nat ltac:(lia)); lra)). lra.
Qed.
Theorem impulse_bounded : exists bound, forall n, sum_f_R0 (meeting_speed d scenes time i j) n <= bound.
Proof.
  pose proof (endless_strikes d r first scenes time i j restitutes run) as S.
  assert (P : forall _ : ball, 0 < 1 / 2) by (intros; lra).
  destruct (meeting_bounded d (fun _ => 1) (fun _ => 1 / 2) scenes time i j (fun _ => Rlt_0_1) P S) as (b & B).
  exists b. intros n. apply Rle_trans with (2 := B n). right. apply sum_eq. intros m _. unfold meeting_speed. field.
Qed.
End FromEndless.

Theorem least_angle_holds : least_angle.
Proof. intros d r s scenes time i j R E. exact (angle_in_the_end d r s scenes time i j R E). Qed.
Lemma above_1 r : 7 - 4 * sqrt 3 < r <= 1 -> 0 < r /\ 1 < 4 * sqrt r / (1 + r).
Proof.
  intros R. assert (S3 : sqrt 3 * sqrt 3 = 3) by (apply sqrt_sqrt; lra). pose proof (sqrt_pos 3).
  assert (T : sqrt 3 < 7 / 4) by nra. assert (R0 : 0 < r) by lra. split; [exact R0|].
  assert (SS : sqrt r * sqrt r = r) by (apply sqrt_sqrt; lra).
  pose proof (sqrt_lt_R0 r R0) as S. set (x := sqrt r) in *. set (y := sqrt 3) in *.
  assert (X1 : x <= 1) by nra. assert (X : 2 - y < x) by nra.
  apply Rmult_lt_reg_r with (1 + r); [lra|].
  replace (4 * x / (1 + r) * (1 + r)) with (4 * x) by (field; lra). nra.
Qed.
Theorem never_holds : never.
Proof.
  intros d r s scenes time i j R E. destruct (above_1 r R) as (R0 & B).
  destruct (least_angle_holds d r s scenes time i j ltac:(lra) E) as (z & o & a & c & N & _ & _ & _ & _ & _ & G & _).
  lra.
Qed.
Theorem never_any_radii_holds : never_any_radii.
Proof.
  intros d m radius r scenes time i j M P R S V. destruct (above_1 r R) as (R0 & B).
  destruct (least_angle_any_radii_holds d m radius r scenes time i j M P ltac:(lra) S V)
    as (z & o & a & c & N & _ & _ & _ & _ & _ & G & _). lra.
Qed.
Theorem comes_to_rest_holds : comes_to_rest.
Proof.
  intros d mass radius scenes time i j M P S N.
  split; [exact (velocities_vanish d mass radius scenes time i j M P S N)|].
  split; [exact (never_recede d mass radius scenes time i j M P S N)|].
  split; [exact (no_angular_momentum d mass radius scenes time i j M P S N)|].
  destruct (settles_late d mass radius scenes time i j M P S N) as (z & Z).
  destruct (settled_in_turn d mass radius scenes time i j z M P S Z) as (o & a & c & K & H).
  exists z, o, a, c, K. now split.
Qed.
Theorem bounded_impulse_holds : bounded_impulse.
Proof. intros d r s scenes time i j R E. exact (impulse_bounded d r s scenes time i j R E). Qed.
Theorem no_spin_holds : no_spin.
Proof.
  intros d r s scenes time i j R E S. apply NNPP. intros N.
  pose proof (no_spin_at_rest d r s scenes time i j R E
    (velocities_vanish d (fun _ => 1) (fun _ => 1 / 2) scenes time i j (fun _ => Rlt_0_1)
      (fun _ => Rdiv_lt_0_compat 1 2 Rlt_0_1 Rlt_0_2) (endless_strikes d r s scenes time i j R E) N)). lra.
Qed.
Lemma above_1_too r : 9 - 4 * sqrt 5 < r <= 1 -> 0 < r /\ 1 < 2 * cube_root r * (1 + cube_root r) / (1 + r).
Proof.
  intros R. assert (S5 : sqrt 5 * sqrt 5 = 5) by (apply sqrt_sqrt; lra). pose proof (sqrt_pos 5).
  assert (T : sqrt 5 < 9 / 4) by nra. assert (R0 : 0 < r) by lra. split; [exact R0|].
  pose proof (cube_of_root r R0) as C. pose proof (cube_root_positive r) as S. set (x := cube_root r) in *.
  assert (S1 : x <= 1) by nra.
  apply Rmult_lt_reg_r with (1 + r); [lra|].
  replace (2 * x * (1 + x) / (1 + r) * (1 + r)) with (2 * x * (1 + x)) by (field; lra).
  apply Rnot_le_lt. intros L. rewrite <- C in L at 1. set (y := sqrt 5) in *.
  assert (0 <= 1 - 3 * x + x * x) by nra. assert (X : x <= (3 - y) / 2) by nra.
  assert (x * x <= (3 - y) / 2 * ((3 - y) / 2)) by (apply Rmult_le_compat; lra).
  assert (x * x * x <= (3 - y) / 2 * ((3 - y) / 2) * ((3 - y) / 2)) by (apply Rmult_le_compat; nra).
  replace ((3 - y) / 2 * ((3 - y) / 2) * ((3 - y) / 2)) with (9 - 4 * y) in * by nra. lra.
Qed.
Theorem never_with_spin_holds : never_with_spin.
Proof.
  intros d r s scenes time i j R S E. destruct (above_1_too r R) as (R0 & B).
  destruct (least_angle_holds d r s scenes time i j ltac:(lra) E)
    as (z & o & a & c & N & _ & _ & _ & _ & _ & G & [K|K]); [lra|].
  pose proof (no_spin_at_rest d r s scenes time i j ltac:(lra) E K). lra.
Qed.
Theorem never_outward_holds : never_outward.
Proof.
  intros d r s scenes time i j R A Z E. pose proof E as (F & _). rewrite <- F in A, Z.
  pose proof (growth_grows d r s scenes time i j R E) as G.
  pose proof (growth_after d r s scenes time i j R E) as GA.
  assert (P : forall n, growth d (scenes n) >= 0).
  { intros n. specialize (GA 0%nat n ltac:(lia)). lra. }
  assert (UP : forall n, size d (scenes n) + 2 * (time (S n) - time n) * growth d (scenes n) <= size d (scenes (S n))).
  { intros n. rewrite (size_next d r s scenes time i j R E). pose proof (motion2_positive d (scenes n)).
    assert (0 <= (time (S n) - time n) * (time (S n) - time n) * motion2 d (scenes n))
      by (apply Rmult_le_pos; [apply Rle_0_sqr | lra]). lra. }
  assert (B : forall n, size d (scenes 2%nat) <= size d (scenes (2 + n)%nat)).
  { induction n as [|n IH]; [simpl; lra|]. apply Rle_trans with (1 := IH). specialize (UP (2 + n)%nat).
    destruct (facts d r s scenes time i j R E (2 + n)) as (_ & T & _). specialize (P (2 + n)%nat).
    assert (0 <= 2 * (time (S (2 + n)) - time (2 + n)%nat) * growth d (scenes (2 + n)%nat)) by (apply Rmult_le_pos; lra).
    replace (2 + S n)%nat with (S (2 + n)) by lia. lra. }
  apply (not_large d r s scenes time i j R E (size d (scenes 2%nat)) 2).
  - destruct (facts d r s scenes time i j R E 0) as (_ & T0 & _). destruct (facts d r s scenes time i j R E 1) as (_ & T1 & _).
    pose proof (UP 0%nat). pose proof (UP 1%nat). pose proof (P 0%nat). pose proof (G 0%nat).
    assert (0 <= 2 * (time 1%nat - time 0%nat) * growth d (scenes 0%nat)) by (apply Rmult_le_pos; lra).
    assert (0 < 2 * (time 2%nat - time 1%nat) * growth d (scenes 1%nat)) by (apply Rmult_lt_0_compat; lra). lra.
  - intros n L. specialize (B (n - 2)%nat). now replace (2 + (n - 2))%nat with n in B by lia.
Qed.
