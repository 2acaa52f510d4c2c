(* The theorem on the separatrix, from what the other files prove. *)
From Coq Require Import Reals Arith Lra Lia Psatz.
From Verify Require Import Separatrix SeparatrixOrder SeparatrixMain SeparatrixTopology.
From Verify Require Import SeparatrixExists SeparatrixCurve SeparatrixGraph.
Open Scope R_scope.

Lemma separatrix : separatrix_theorem.
Proof.
  intros r a rho s R1 A1 P S1 SR. split; [|split].
  - intros x y H Q U N. now apply regime_below with y.
  - now apply unending_iff.
  - intros HIGH. exists (separatrix_at r a R1 A1 rho).
    assert (POS : forall y, 0 <= y < phi_plus r a -> 0 < separatrix_at r a R1 A1 rho y).
    { intros y Y. destruct (reached_up_to r a s R1 A1 S1 SR HIGH y Y rho P) as [e [E H]].
      apply (f_upper r a R1 A1 rho P) in H. simpl in H. lra. }
    split; [now apply f_continuous|].
    split; [|split; [exact POS|split; [|split; [|split; [|split]]]]].
    + intros y Y. split; [now apply f_not_negative|now apply f_bound].
    + intros y z Y Z. apply f_strict; auto. apply POS. lra.
    + intros y Y. pose proof (phi_plus_root r a s R1 A1 S1 SR HIGH) as [_ F].
      assert (s < 1) by now apply (s_less r a). assert (Y0 : 0 <= y) by nra.
      destruct (Rle_lt_or_eq_dec 0 _ (f_not_negative r a R1 A1 rho P y)) as [L|L]; [|lra].
      exfalso. apply (beyond_phi_plus r a s R1 A1 S1 SR HIGH rho _ P) with
        (2 := f_attained r a R1 A1 rho P y Y0 L). exact Y.
    + intros x X L. now apply regime_under_curve with R1 A1.
    + intros x X L. destruct (unending_or_ends r a R1 A1 rho P x X) as [H|H]; [|exact H].
      apply (f_upper r a R1 A1 rho P) in H. lra.
    + intros x X E. split; [apply unending_at_most with R1 A1; auto; lra|].
      now apply (not_vanishing_on_curve r a s R1 A1 S1 SR HIGH).
Qed.
Print Assumptions separatrix.
