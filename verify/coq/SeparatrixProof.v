(* The theorem on the separatrix, from what the other files prove. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixExists SeparatrixCurve SeparatrixGraph SeparatrixCycle.
From Verify Require Import SeparatrixConvex SeparatrixLimit.
Open Scope R_scope.

Lemma separatrix : separatrix_theorem.
Proof.
  intros r a rho s R1 A1 P S1 SR.
  pose proof (unending_iff r a s R1 A1 S1 SR rho P) as EXISTS.
  assert (REGIME : forall x, fades r a rho x -> regime r a rho x).
  { intros x H. assert (HIGH : s + s ^ 2 < a) by (apply EXISTS; exists x; apply H).
    destruct H as [H V]. split; [exact H|]. split; [exact V|].
    apply (q_tends r a s R1 A1 S1 SR HIGH); auto. now split. }
  split; [|split; [exact EXISTS|split]].
  - intros x y H Q U N. apply REGIME. now apply fades_below with y.
  - intros HIGH. set (f := separatrix_at r a R1 A1 rho). exists f.
    pose proof (phi_plus_root r a s R1 A1 S1 SR HIGH) as [_ F].
    pose proof (s_less r a s R1 A1 S1 SR) as S2.
    assert (POS : forall y, 0 <= y < phi_plus r a -> 0 < f y).
    { intros y Y. destruct (reached_up_to r a s R1 A1 S1 SR HIGH y Y rho P) as [e [E H]].
      apply (f_upper r a R1 A1 rho P) in H. simpl in H. fold f in H. lra. }
    split; [now apply f_continuous|].
    split; [intros x y c X Y C; now apply f_convex|].
    split; [intros y Y; split; [now apply f_not_negative|now apply f_bound]|].
    split; [exact POS|].
    split; [intros y z Y Z; apply f_strict; auto; apply POS; lra|].
    split; [|split; [|split]].
    + intros y Y. assert (Y0 : 0 <= y) by nra.
      destruct (Rle_lt_or_eq_dec 0 _ (f_not_negative r a R1 A1 rho P y)) as [L|L]; [|now symmetry].
      exfalso. apply (beyond_phi_plus r a s R1 A1 S1 SR HIGH rho _ P) with
        (2 := f_attained r a R1 A1 rho P y Y0 L). exact Y.
    + intros x X L. now apply REGIME, fades_under_curve with R1 A1.
    + intros x X L. destruct (unending_or_ends r a R1 A1 rho P x X) as [H|H]; [|exact H].
      apply (f_upper r a R1 A1 rho P) in H. fold f in H. lra.
    + intros x X E. assert (C : on_curve r a R1 A1 rho x) by now split.
      split; [now apply (on_curve_unending r a R1 A1)|].
      split; [now apply (not_vanishing_on_curve r a s R1 A1 S1 SR HIGH)|].
      destruct (tends_to_cycle r a s R1 A1 S1 SR HIGH rho x P C) as [y [Y [CY T]]].
      exists y. split; [|split; [apply Y|exact T]].
      split; [now apply (on_curve_unending r a R1 A1)|exact CY].
  - intros HIGH ->.
    assert (E : exists x, on_curve r a R1 A1 1 x).
    { pose proof (s_less r a s R1 A1 S1 SR) as S2.
      pose proof (phi_plus_root r a s R1 A1 S1 SR HIGH) as [_ F].
      destruct (reached_up_to r a s R1 A1 S1 SR HIGH 0 ltac:(nra) 1 P) as [e [E H]].
      apply (f_upper r a R1 A1 1 P) in H. simpl in H.
      pose proof (f_less_1 r a R1 A1 1 P 0).
      exists (State 0 (separatrix_at r a R1 A1 1 0)).
      split; [unfold region; simpl; lra|reflexivity]. }
    destruct E as [x C]. destruct (tends_to_cycle r a s R1 A1 S1 SR HIGH 1 x P C) as [y [Y [CY _]]].
    assert (H := on_curve_unending r a R1 A1 1 y P Y).
    exists y. split; [now apply (cycle_fixed r a s R1 A1 S1 SR HIGH)|].
    intros z. split; [|intros ->; now split].
    intros [Z CZ]. now apply (one_cycle r a s R1 A1 S1 SR HIGH).
Qed.
Print Assumptions separatrix.
