(* Where ball 0 collides with 2 and 1 in turn, at times that converge, the positions converge, and in
   the limit both other balls touch ball 0. Energy is lost, so that velocities stay bounded. *)
From Coq Require Import Reals Lra Lia Ranalysis.
From Verify Require Import Theorem1 Vectors Motion Sequences Determined InTurn.
Open Scope R_scope.

(* --- limits of inner products ----------------------------------------------------------------- *)

Lemma dot_converges d (u v : nat -> vector) (x y : vector) :
  (forall k, (k < d)%nat -> Un_cv (fun n => u n k) (x k)) ->
  (forall k, (k < d)%nat -> Un_cv (fun n => v n k) (y k)) ->
  Un_cv (fun n => dot d (u n) (v n)) (dot d x y).
Proof.
  induction d as [|d IH]; intros U V; cbn [dot].
  - intros e E. exists O. intros n _. now rewrite R_dist_eq.
  - apply (CV_plus (fun n => dot d (u n) (v n)) (fun n => u n d * v n d)).
    + apply IH; intros k K; [apply U | apply V]; lia.
    + apply (CV_mult (fun n => u n d) (fun n => v n d)); [apply U | apply V]; lia.
Qed.
Lemma often_equal (u : nat -> R) (l c : R) :
  Un_cv u l -> (forall m, exists n, (m <= n)%nat /\ u n = c) -> l = c.
Proof.
  intros L A. destruct (Req_dec l c) as [E|N]; trivial. exfalso.
  destruct (L (Rabs (c - l))) as [m M]; [apply Rabs_pos_lt; lra|].
  destruct (A m) as (n & G & E). specialize (M n G). unfold R_dist in M. rewrite E in M. lra.
Qed.

Section Ending.
Variable d : nat.
Variable r : R.
Hypothesis restitutes : 0 < r < 1.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variable T : R.
Hypothesis time_0 : time O = 0.
Hypothesis in_turn : collides_in_turn d r scenes time.
Hypothesis converges : Un_cv time T.

Lemma energy_bounded n : energy d (scenes n) <= energy d (scenes O).
Proof.
  induction n as [|n IH]; [lra|]. destruct (in_turn n) as [[_ _ C _ _] ->].
  apply Rle_trans with (2 := IH). apply (energy_lost d r _ (later _ (scenes n)) restitutes); trivial.
  apply partner_not_0.
Qed.
Definition speed : R := 1 + energy d (scenes O).
Lemma velocity_bounded n i k : (k < d)%nat -> Rabs (velocity (scenes n) i k) <= speed.
Proof.
  intros K. pose proof (velocity_at_most d (scenes n) i k K). pose proof (energy_bounded n).
  unfold speed. lra.
Qed.
Lemma speed_positive : 0 < speed.
Proof. unfold speed. pose proof (energy_positive d (scenes O)). lra. Qed.

(* --- positions -------------------------------------------------------------------------------- *)

Definition place (i : ball) (k n : nat) : R := if lt_dec k d then position (scenes n) i k else 0.
Lemma place_next i k n : (k < d)%nat ->
  place i k (S n) = place i k n + (time (S n) - time n) * velocity (scenes n) i k.
Proof.
  intros K. unfold place. destruct lt_dec; [|easy]. destruct (in_turn n) as [_ ->]. reflexivity.
Qed.
Lemma place_moves i k n t : (k < d)%nat -> time n <= t ->
  Rabs ((t - time n) * velocity (scenes n) i k) <= speed * (t - time n).
Proof.
  intros K L. rewrite Rabs_mult, Rabs_right, Rmult_comm by lra.
  apply Rmult_le_compat_r; [lra | now apply velocity_bounded].
Qed.
Lemma place_cauchy i k : Cauchy_crit (place i k).
Proof.
  destruct (lt_dec k d) as [K|K].
  - destruct (bounded_variation_converges (place i k) (fun n => speed * time n) (speed * T)) as [l L].
    + intros n. rewrite place_next by trivial. pose proof (time_grows d r scenes time in_turn n).
      pose proof (within _ _ (place_moves i k n (time (S n)) K ltac:(lra))). lra.
    + intros n. rewrite place_next by trivial. pose proof (time_grows d r scenes time in_turn n).
      pose proof (within _ _ (place_moves i k n (time (S n)) K ltac:(lra))). lra.
    + intros n. apply Rmult_le_compat_l; [left; apply speed_positive|]. left.
      now apply (time_before_T d r scenes time T in_turn).
    + apply CV_Cauchy. now exists l.
  - intros e E. exists O. intros n m _ _. unfold place. destruct lt_dec; [easy|]. now rewrite R_dist_eq.
Qed.
Definition ending : scene :=
  Scene (fun i k => proj1_sig (R_complete (place i k) (place_cauchy i k))) (fun _ _ => 0).
Lemma positions_converge_to_ending i k : (k < d)%nat ->
  Un_cv (fun n => position (scenes n) i k) (position ending i k).
Proof.
  intros K. unfold ending. cbn [position]. destruct R_complete as [l L]. cbn. intros e E.
  destruct (L e E) as [m M]. exists m. intros n N. specialize (M n N). unfold place in M.
  now destruct lt_dec.
Qed.
(* At all times, not only just after collisions. *)
Lemma course_converges i k : (k < d)%nat ->
  tends_to (fun t => position (course scenes time t) i k) T (position ending i k).
Proof.
  intros K e E. pose proof speed_positive as V.
  destruct (positions_converge_to_ending i k K (e / 2)) as [m M]; [lra|].
  destruct (converges (e / (2 * speed))) as [l L]; [apply Rdiv_lt_0_compat; lra|].
  set (n := Nat.max m l). exists (time n).
  pose proof (time_before_T d r scenes time T in_turn converges) as B.
  split; [apply B|]. intros t H. pose proof (time_monotone d r scenes time in_turn) as G.
  assert (Z : 0 <= t < T) by (specialize (G O n ltac:(lia)); lra).
  destruct (stage_right d r scenes time T time_0 in_turn converges t Z) as [S1 S2].
  unfold course. set (j := stage time t) in *.
  assert (J : (n <= j)%nat).
  { destruct (le_lt_dec n j) as [J|J]; trivial. specialize (G (S j) n J). lra. }
  specialize (M j ltac:(lia)). specialize (L n ltac:(lia)).
  pose proof (within _ _ (place_moves i k j t K S1)) as P. cbn [position later].
  assert (Q : speed * (t - time j) < e / 2).
  { apply Rle_lt_trans with (speed * (T - time n)).
    - apply Rmult_le_compat_l; [lra|]. specialize (G n j J). lra.
    - apply Rlt_le_trans with (speed * (e / (2 * speed))); [|right; field; lra].
      apply Rmult_lt_compat_l; trivial. specialize (B n). unfold R_dist, Rabs in L.
      destruct Rcase_abs; lra. }
  apply Rabs_def2 in M. apply Rabs_def1; lra.
Qed.

(* --- contact ---------------------------------------------------------------------------------- *)

Lemma inner_products_converge i j : Un_cv (fun n => dot d (to (scenes n) B0 i) (to (scenes n) B0 j))
  (dot d (to ending B0 i) (to ending B0 j)).
Proof.
  apply dot_converges; intros k K;
    apply (CV_minus (fun n => position (scenes n) _ k) (fun n => position (scenes n) B0 k));
    now apply positions_converge_to_ending.
Qed.
Lemma touch_after n : square d (scenes (S n)) B0 (collides_with n) = 1.
Proof.
  destruct (in_turn n) as [[_ _ C _ _] ->].
  change (square d (later (time (S n) - time n) (scenes n)) B0 (collides_with n) = 1).
  rewrite square_of_distance, C. ring.
Qed.
Lemma touch_in_the_end j : j <> B0 -> distance d ending B0 j = 1.
Proof.
  intros N. apply distance_one. apply (often_equal _ _ _ (inner_products_converge j j)).
  intros m. destruct j; [now destruct N|..].
  - exists (S (S (2 * m))). split; [lia|]. replace B1 with (collides_with (S (2 * m))).
    + exact (touch_after (S (2 * m))).
    + unfold collides_with. rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul. reflexivity.
  - exists (S (2 * m)). split; [lia|]. replace B2 with (collides_with (2 * m)).
    + exact (touch_after (2 * m)).
    + unfold collides_with. rewrite Nat.even_mul. reflexivity.
Qed.
Lemma distance_converges j : j <> B0 -> Un_cv (fun n => distance d (scenes n) B0 j) 1.
Proof.
  intros N. rewrite <- (touch_in_the_end j N) at 1. unfold distance.
  apply (continuity_seq sqrt (fun n => dot d (to (scenes n) B0 j) (to (scenes n) B0 j))).
  - apply continuity_pt_sqrt. apply dot_self.
  - apply inner_products_converge.
Qed.
Lemma angle_in_the_end : Un_cv (fun n => minus_cosine d (scenes n)) (minus_cosine d ending).
Proof.
  unfold minus_cosine. apply CV_opp. rewrite !touch_in_the_end by discriminate.
  apply (CV_mult (fun n => dot d (to (scenes n) B0 B1) (to (scenes n) B0 B2))
    (fun n => / (distance d (scenes n) B0 B1 * distance d (scenes n) B0 B2))).
  - apply inner_products_converge.
  - apply (continuity_seq Rinv (fun n => distance d (scenes n) B0 B1 * distance d (scenes n) B0 B2)).
    + apply continuity_pt_inv; [apply derivable_continuous_pt, derivable_pt_id | lra].
    + apply (CV_mult (fun n => distance d (scenes n) B0 B1) (fun n => distance d (scenes n) B0 B2));
        now apply distance_converges.
Qed.

Theorem in_turn_collapses :
  collapses d r (scenes O) scenes time T (course scenes time) ending.
Proof.
  split; trivial.
  - exact (course_between d r scenes time T time_0 in_turn converges).
  - exact (course_is_trajectory d r scenes time T time_0 in_turn converges).
  - exact (none_beyond d r restitutes scenes time T time_0 in_turn converges).
  - exact course_converges.
  - now apply touch_in_the_end.
  - now apply touch_in_the_end.
  - exact angle_in_the_end.
Qed.
End Ending.
