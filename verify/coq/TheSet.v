(* Theorem 1: from each scene of the set the balls collapse. A scene of the initial set does; one into
   which such a scene flies does, too, a little earlier. *)
From Coq Require Import Reals Lra Lia.
From Verify Require Import Theorem1 Vectors Motion InTurn Ending Collapse.
Open Scope R_scope.

(* --- later by u, before the first collision --------------------------------------------------- *)

Section Flown.
Variable d : nat.
Variable r : R.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variable T : R.
Hypothesis time_0 : time O = 0.
Hypothesis in_turn : collides_in_turn d r scenes time.
Hypothesis converges : Un_cv time T.
Variable u : R.
Hypothesis before : 0 <= u < time 1%nat.

Definition flown_scenes (n : nat) : scene := match n with O => later u (scenes O) | S _ => scenes n end.
Definition flown_time (n : nat) : R := match n with O => 0 | S _ => time n - u end.
Lemma flown_in_turn : collides_in_turn d r flown_scenes flown_time.
Proof.
  intros [|n]; cbn [flown_scenes flown_time].
  - destruct (in_turn O) as [[P B C A O] E]. rewrite time_0 in *.
    replace (time 1%nat - u - 0) with (time 1%nat - u) by ring.
    replace (time 1%nat - 0) with (time 1%nat) in * by ring.
    assert (Q : later (time 1%nat - u) (later u (scenes 0%nat)) = later (time 1%nat) (scenes 0%nat))
      by (rewrite later_later; f_equal; ring).
    split; [split|]; rewrite ?Q; trivial; [lra|].
    intros v a b V N. rewrite later_later. apply B; trivial. lra.
  - replace (time (S (S n)) - u - (time (S n) - u)) with (time (S (S n)) - time (S n)) by ring.
    exact (in_turn (S n)).
Qed.
Lemma flown_converges : Un_cv flown_time (T - u).
Proof.
  intros e E. destruct (converges e E) as [m M]. exists (S m). intros [|n] N; [lia|].
  cbn [flown_time]. specialize (M (S n) ltac:(lia)). unfold R_dist in *.
  replace (time (S n) - u - (T - u)) with (time (S n) - T) by ring. exact M.
Qed.
End Flown.

Lemma same_limit (f g : nat -> R) l : (forall n, f (S n) = g (S n)) -> Un_cv f l -> Un_cv g l.
Proof.
  intros E L e P. destruct (L e P) as [m M]. exists (S m). intros [|n] N; [lia|].
  rewrite <- E. apply M. lia.
Qed.

(* A scene into which one flies that collapses does, too. *)
Theorem flown_collapses d r s u by_time c tolerance : 0 < r < 1 -> 0 <= u ->
  (forall v i j, 0 < v <= u -> i <> j -> 1 < distance d (later v s) i j) ->
  collapse d r s by_time c tolerance -> collapse d r (later u s) by_time c tolerance.
Proof.
  intros R U F (scenes & time & T & ? & at_T & P0 & B & M).
  pose proof (first_scene _ _ _ _ _ _ _ _ P0) as S. subst s.
  pose proof (first_time _ _ _ _ _ _ _ _ P0) as Z. pose proof (in_turn _ _ _ _ _ _ _ _ P0) as C.
  pose proof (finite_time _ _ _ _ _ _ _ _ P0) as L.
  assert (Q : 0 <= u < time 1%nat).
  { split; trivial. apply Rnot_le_lt. intros N. destruct (C O) as [[P _ E _ _] _].
    rewrite Z, Rminus_0_r in P, E. specialize (F _ B0 (collides_with 0) (conj P N)).
    specialize (F ltac:(discriminate)). lra. }
  pose proof (flown_in_turn d r scenes time Z C u Q) as C'.
  pose proof (in_turn_collapses d r R (flown_scenes scenes u)
    (flown_time time u) (T - u) eq_refl C' (flown_converges time T L u)) as P.
  exists (flown_scenes scenes u), (flown_time time u), (T - u). do 2 eexists.
  split; [exact P|]. split; [lra|].
  pose proof (same_limit (fun n => minus_cosine d (scenes n))
    (fun n => minus_cosine d (flown_scenes scenes u n)) _ (fun n => eq_refl)
    (angle_converges _ _ _ _ _ _ _ _ P0)) as K.
  rewrite <- (UL_sequence _ _ _ K (angle_converges _ _ _ _ _ _ _ _ P)). exact M.
Qed.

(* --- the theorem ------------------------------------------------------------------------------ *)

Theorem theorem_1_holds : theorem_1.
Proof.
  intros r c V_0 delta_theta A d s (s_0 & d_0 & y & u & I & U & F & ->).
  destruct (collides_without_end r c V_0 delta_theta A d s_0 d_0 y I)
    as (scenes & time & <- & Z & C & (T & L & B) & (l & K & M)).
  apply flown_collapses; trivial; [exact (restitution _ _ _ _ A)|].
  pose proof (in_turn_collapses d r (restitution _ _ _ _ A) scenes time T Z C L) as P.
  exists scenes, time, T. do 2 eexists. split; [exact P|]. split; [exact B|].
  rewrite <- (UL_sequence _ _ _ K (angle_converges _ _ _ _ _ _ _ _ P)). exact M.
Qed.
