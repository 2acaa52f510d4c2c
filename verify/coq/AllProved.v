(* All that Theorem1.v says is proved. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Determined TheSet Interior Parameters.
Open Scope R_scope.

Theorem printed_theorem_holds : printed_theorem.
Proof.
  intros r theta_0 delta_theta d L _ H P.
  assert (A : admissible r (- cos theta_0) 1 delta_theta).
  { apply hypothesis_is_the_printed. repeat split; try apply H; trivial; [|lra].
    pose proof (COS_bound theta_0). lra. }
  exists (ZK r (- cos theta_0) 1 delta_theta d). split; [now apply the_set_has_an_interior|].
  exists (T_star r (- cos theta_0) 1 delta_theta). intros s S.
  destruct (theorem_1_holds _ _ _ _ A d s S) as (scenes & time & T & Z & at_T & C & B & E).
  exists scenes, time, T, Z, at_T. split; trivial. split; trivial.
  pose proof (constants_are_defined _ _ _ _ A) as D. lra.
Qed.
Theorem interior_contains_a_box d set : has_interior d set -> contains_a_box d set.
Proof.
  intros (s & e & E & A).
  exists (Scene (fun i k => position s i k - e / 2) (fun i k => velocity s i k - e / 2)).
  exists (Scene (fun i k => position s i k + e / 2) (fun i k => velocity s i k + e / 2)).
  cbn [position velocity]. split; [intros i k _; lra|].
  intros s' B. apply A. intros i k K. specialize (B i k K). cbn [position velocity] in B.
  split; apply Rabs_def1; lra.
Qed.
Theorem all_proved : theorem_1 /\ interior /\ positive_volume /\ determined /\ constants_defined /\
  same_hypothesis /\ printed_theorem.
Proof.
  split; [exact theorem_1_holds|]. split; [exact the_set_has_an_interior|].
  split; [intros r c V_0 delta_theta A d L; now apply interior_contains_a_box, the_set_has_an_interior|].
  split; [exact trajectories_are_determined|]. split; [exact constants_are_defined|].
  split; [exact hypothesis_is_the_printed | exact printed_theorem_holds].
Qed.
