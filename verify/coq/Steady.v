(* What is continuous in the numbers that make up a scene; and that free flight of a scene nearby ends
   nearby. *)
From Coq Require Import Reals Lra Lia Ranalysis.
From Verify Require Import Theorem1 Vectors Motion.
Open Scope R_scope.

Section Steady.
Variable d : nat.
Variable s_0 : scene.

(* It holds for all scenes near s_0. *)
Definition nearby (P : scene -> Prop) : Prop :=
  exists h, 0 < h /\ forall s, close d h s_0 s -> P s.
Lemma close_more h h' s : h <= h' -> close d h s_0 s -> close d h' s_0 s.
Proof. intros L A i k K. destruct (A i k K). lra. Qed.
Lemma nearby_both P Q : nearby P -> nearby Q -> nearby (fun s => P s /\ Q s).
Proof.
  intros (h & H & A) (h' & H' & A'). exists (Rmin h h'). split; [now apply Rmin_glb_lt|].
  intros s S. split; [apply A | apply A']; revert S; apply close_more; apply Rmin_l || apply Rmin_r.
Qed.
Lemma nearby_follows (P Q : scene -> Prop) : (forall s, P s -> Q s) -> nearby P -> nearby Q.
Proof. intros I (h & H & A). exists h. auto. Qed.

Definition steady (f : scene -> R) : Prop :=
  forall e, 0 < e -> nearby (fun s => Rabs (f s - f s_0) < e).
Lemma steady_less f g : steady f -> steady g -> f s_0 < g s_0 -> nearby (fun s => f s < g s).
Proof.
  intros F G L. specialize (F ((g s_0 - f s_0) / 2) ltac:(lra)).
  specialize (G ((g s_0 - f s_0) / 2) ltac:(lra)). generalize (nearby_both _ _ F G).
  apply nearby_follows. intros s [A B]. apply Rabs_def2 in A. apply Rabs_def2 in B. lra.
Qed.
Lemma steady_constant c : steady (fun _ => c).
Proof. intros e E. exists 1. split; [lra|]. intros s _. now rewrite Rminus_diag_eq, Rabs_R0. Qed.
Lemma steady_position i k : (k < d)%nat -> steady (fun s => position s i k).
Proof. intros K e E. exists e. split; trivial. intros s A. apply (A i k K). Qed.
Lemma steady_velocity i k : (k < d)%nat -> steady (fun s => velocity s i k).
Proof. intros K e E. exists e. split; trivial. intros s A. apply (A i k K). Qed.
Lemma steady_plus f g : steady f -> steady g -> steady (fun s => f s + g s).
Proof.
  intros F G e E. generalize (nearby_both _ _ (F (e / 2) ltac:(lra)) (G (e / 2) ltac:(lra))).
  apply nearby_follows. intros s [A B]. apply Rabs_def2 in A. apply Rabs_def2 in B. apply Rabs_def1; lra.
Qed.
Lemma steady_through g f : steady f -> continuity_pt g (f s_0) -> steady (fun s => g (f s)).
Proof.
  intros F C e E. destruct (C e E) as (h & H & A). generalize (F h H). apply nearby_follows.
  intros s B. destruct (Req_dec (f s) (f s_0)) as [Q|Q].
  - now rewrite Q, Rminus_diag_eq, Rabs_R0.
  - apply (A (f s)). repeat split; trivial. now apply not_eq_sym.
Qed.
Lemma steady_opposite f : steady f -> steady (fun s => - f s).
Proof. intros F. apply (steady_through Ropp); trivial. reg. Qed.
Lemma steady_times f g : steady f -> steady g -> steady (fun s => f s * g s).
Proof.
  intros F G. assert (Q : forall h, steady h -> steady (fun s => / 4 * (h s * h s))).
  { intros h S. apply (steady_through (fun x => / 4 * (x * x)) h S). reg. }
  pose proof (steady_plus _ _ (Q _ (steady_plus _ _ F G))
    (steady_opposite _ (Q _ (steady_plus _ _ F (steady_opposite _ G))))) as A.
  intros e E. generalize (A e E). apply nearby_follows. intros s B. revert B. apply Rle_lt_trans.
  right. f_equal. field.
Qed.
Lemma steady_root f : steady f -> 0 <= f s_0 -> steady (fun s => sqrt (f s)).
Proof. intros F P. apply (steady_through sqrt); trivial. now apply continuity_pt_sqrt. Qed.
Lemma steady_quotient f g : steady f -> steady g -> g s_0 <> 0 -> steady (fun s => f s / g s).
Proof.
  intros F G N. apply steady_times; trivial. apply (steady_through Rinv); trivial.
  apply continuity_pt_inv; trivial. reg.
Qed.
Lemma steady_absolute f : steady f -> steady (fun s => Rabs (f s)).
Proof. intros F. apply (steady_through Rabs); trivial. apply Rcontinuity_abs. Qed.

(* --- places, velocities, and what is made of them --------------------------------------------- *)

Definition steady_vector (v : scene -> vector) : Prop := forall k, (k < d)%nat -> steady (fun s => v s k).
Lemma steady_dot u v : steady_vector u -> steady_vector v -> steady (fun s => dot d (u s) (v s)).
Proof.
  unfold steady_vector. intros U V.
  assert (A : forall m, (m <= d)%nat -> steady (fun s => dot m (u s) (v s))); [|now apply A].
  induction m as [|m IH]; intros M; cbn [dot]; [apply steady_constant|].
  apply steady_plus; [apply IH; lia|]. apply steady_times; [apply U | apply V]; lia.
Qed.
Lemma steady_relative i j : steady_vector (fun s => relative s i j).
Proof.
  intros k K. apply steady_plus; [|apply steady_opposite]; now apply steady_velocity.
Qed.
Lemma steady_to t i j : steady_vector (fun s => to (later t s) i j).
Proof.
  assert (A : forall b k, (k < d)%nat -> steady (fun s => position (later t s) b k)).
  { intros b k K. apply steady_plus; [now apply steady_position|].
    apply steady_times; [apply steady_constant | now apply steady_velocity]. }
  intros k K. apply steady_plus; [|apply steady_opposite]; now apply A.
Qed.
Lemma steady_square t i j : steady (fun s => square d (later t s) i j).
Proof. apply steady_dot; apply steady_to. Qed.
Lemma steady_rate t i j : steady (fun s => rate d (later t s) i j).
Proof. apply steady_dot; [apply steady_to | exact (steady_relative i j)]. Qed.
Lemma steady_distance t i j : steady (fun s => distance d (later t s) i j).
Proof. apply steady_root; [apply steady_square | apply dot_self]. Qed.

(* --- a short flight ends nearby --------------------------------------------------------------- *)

Lemma flight_nearby P : nearby P -> exists t, 0 < t /\
  nearby (fun s => forall u, Rabs u < t -> P (later u s)).
Proof.
  intros (h & H & A). pose proof (energy_positive d s_0) as M0. set (M := energy d s_0) in *.
  assert (Q : 0 < h / (2 * (1 + M + h))) by (apply Rdiv_lt_0_compat; lra).
  exists (h / (2 * (1 + M + h))). split; trivial. exists (h / 2). split; [lra|].
  intros s S u U. apply A. intros i k K. destruct (S i k K) as [X V]. cbn [position velocity later].
  split; [|lra].
  pose proof (velocity_at_most d s_0 i k K) as B. fold M in B.
  replace (position s i k + u * velocity s i k - position s_0 i k) with
    (position s i k - position s_0 i k + u * velocity s i k) by ring.
  apply Rle_lt_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult.
  assert (W : Rabs (velocity s i k) <= 1 + M + h).
  { replace (velocity s i k) with (velocity s i k - velocity s_0 i k + velocity s_0 i k) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  assert (L : Rabs u * Rabs (velocity s i k) <= h / (2 * (1 + M + h)) * (1 + M + h))
    by (apply Rmult_le_compat; try apply Rabs_pos; lra).
  replace (h / (2 * (1 + M + h)) * (1 + M + h)) with (h / 2) in L by (field; lra). lra.
Qed.
(* What holds for the scenes near s_0 holds for those that such scenes fly into, back where they were. *)
Lemma flown_back P u : nearby P -> 0 <= u ->
  exists e, 0 < e /\ forall s, close d e (later u s_0) s -> P (later (- u) s).
Proof.
  intros (h & H & A) U. exists (h / (1 + u)). assert (Q : 0 < h / (1 + u)) by (apply Rdiv_lt_0_compat; lra).
  split; trivial. intros s S. apply A. intros i k K. destruct (S i k K) as [X V].
  cbn [position velocity later] in *. set (e := h / (1 + u)) in *.
  assert (E : e + u * e = h) by (unfold e; field; lra).
  assert (L : 0 <= u * e) by (apply Rmult_le_pos; lra). split; [|lra].
  replace (position s i k + - u * velocity s i k - position s_0 i k) with
    (position s i k - (position s_0 i k + u * velocity s_0 i k) +
      - u * (velocity s i k - velocity s_0 i k)) by ring.
  apply Rle_lt_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult, Rabs_Ropp, (Rabs_right u) by lra.
  assert (u * Rabs (velocity s i k - velocity s_0 i k) <= u * e) by (apply Rmult_le_compat_l; lra). lra.
Qed.
End Steady.
