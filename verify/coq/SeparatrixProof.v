(* The theorem on the separatrix, from what the other files prove. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixExists SeparatrixCurve SeparatrixGraph SeparatrixCycle.
From Verify Require Import SeparatrixConvex SeparatrixLimit SeparatrixUnique.
Open Scope R_scope.

Lemma separatrix : separatrix_theorem.
Proof.
  intros r a rho s R1 A1 P S1 SR.
  pose proof (unending_iff r a s R1 A1 S1 SR rho P) as EXISTS.
  assert (REGIME : forall x, fades r a rho x -> regime r a rho x).
  { intros x H. assert (HIGH : s + s ^ 2 < a) by (apply EXISTS; exists x; apply H).
    destruct H as [H V]. split; [exact H|]. split; [exact V|].
    apply (q_tends r a s R1 A1 S1 SR HIGH); auto. now split. }
  split; [|split; [exact EXISTS|]].
  - intros x y H Q U N. apply REGIME. now apply fades_below with y.
  - intros HIGH. set (f := separatrix_at r a R1 A1 rho).
    pose proof (phi_plus_root r a s R1 A1 S1 SR HIGH) as [_ F].
    pose proof (s_less r a s R1 A1 S1 SR) as S2.
    assert (POS : forall y, 0 <= y < phi_plus r a -> 0 < f y).
    { intros y Y. destruct (reached_up_to r a s R1 A1 S1 SR HIGH y Y rho P) as [e [E H]].
      apply (f_upper r a R1 A1 rho P) in H. simpl in H. fold f in H. lra. }
    assert (TENDS : forall x, region x -> u x = f (q x) ->
      exists c, cycle r a rho c /\ u c = f (q c) /\ tends_to r a rho x c).
    { intros x X E.
      destruct (tends_to_cycle r a s R1 A1 S1 SR HIGH rho x P (conj X E)) as [c [C [CC T]]].
      exists c. split; [|split; [apply C|exact T]].
      split; [now apply (on_curve_unending r a R1 A1)|exact CC]. }
    destruct (TENDS (State 0 (f 0))) as [c [C [UC _]]]; [|reflexivity|].
    { pose proof (POS 0 ltac:(nra)). pose proof (f_less_1 r a R1 A1 rho P 0) as F1. fold f in F1.
      unfold region. simpl. lra. }
    exists f, c.
    split; [now apply f_continuous|].
    split; [intros x y d X Y D; now apply f_convex|].
    split; [intros y Y; split; [now apply f_not_negative|now apply f_bound]|].
    split; [exact POS|].
    split; [intros y z Y Z; apply f_strict; auto; apply POS; lra|].
    split.
    { intros y Y. assert (Y0 : 0 <= y) by nra.
      assert (Z : f y <= f (phi_plus r a)) by (apply f_decreasing; auto; nra).
      pose proof (curve_at_phi_plus r a s R1 A1 S1 SR HIGH rho P) as T. fold f in T.
      pose proof (f_not_negative r a R1 A1 rho P y) as N. fold f in N. lra. }
    split; [intros x X L; now apply REGIME, fades_under_curve with R1 A1|].
    split.
    { intros x X L. destruct (unending_or_ends r a R1 A1 rho P x X) as [H|H]; [|exact H].
      apply (f_upper r a R1 A1 rho P) in H. fold f in H. lra. }
    split.
    { intros x X E. split; [now apply (on_curve_unending r a R1 A1)|].
      split; [now apply (not_vanishing_on_curve r a s R1 A1 S1 SR HIGH)|].
      destruct (TENDS x X E) as [d [D [_ T]]].
      now rewrite (one_cycle r a s R1 A1 S1 SR HIGH rho c d P C D). }
    split.
    { intros x. split; [|now intros ->].
      intros X. now apply (one_cycle r a s R1 A1 S1 SR HIGH rho x c P X C). }
    split; [exact UC|].
    intros ->. apply (cycle_fixed r a s R1 A1 S1 SR HIGH); [split; [apply C|exact UC]|apply C].
Qed.

(* PinnedSeparatrix.v says it once more, with the definitions that the certificate takes on trust. *)
Check (separatrix : separatrix_theorem).
Print Assumptions separatrix.
