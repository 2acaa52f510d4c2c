(* Theorem 1 as the paper prints it, with < in (4.10), spelled out once more, with the words of Pinned.v,
   and that it is false. A reader compares it with the paper; and if PrintedSign.v comes to say anything
   else, the proofs at the end fail. *)
From Verify Require Import Pinned PinnedClassification.
From Verify Require Theorem1 Classification PrintedSign PrintedSignProof.
From Coq Require Import Reals Arith Lra.
Open Scope R_scope.

(* From x and v there are collisions without end, in finite time, in any order at first; from some
   collision on, ball 0 meets the other two in turn. The places converge, relative to one another, and in
   the limit minus the cosine of the angle at ball 0 is c, to within the tolerance. *)
Definition nearly_linear d r x v c tolerance : Prop :=
  exists places velocities time i j T at_T a b N,
    endless d r x v places velocities time i j /\ Un_cv time T /\
    in_turn_from N i j B0 a b /\ settles d places at_T /\
    Rabs (minus_cosine d at_T - c) <= tolerance.
(* (4.9) and (4.10), as printed; the power 1/3 is the cube root. *)
Definition hypotheses_as_printed r theta_0 delta_theta : Prop :=
  0 < r < 9 - 4 * sqrt 5 /\ PI / 2 < theta_0 <= PI /\
  0 < - cos theta_0 < 2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) /\ 0 < delta_theta.
Definition as_printed_at d r theta_0 delta_theta : Prop :=
  exists set, has_interior d set /\
    forall x v, set x v -> nearly_linear d r x v (- cos theta_0) delta_theta.
Definition as_printed : Prop :=
  forall r theta_0 delta_theta d, (2 <= d)%nat -> hypotheses_as_printed r theta_0 delta_theta ->
  as_printed_at d r theta_0 delta_theta.

(* It is false, and so for all r and theta_0 that it admits, as soon as -cos theta_0 + delta_theta is below
   the bound in (4.10), too: no initial data with angular momentum collapse as it claims. There are
   parameters for which no initial data at all do; that is so wherever -cos theta_0 + delta_theta is below
   4 sqrt(r)/(1+r). What Pinned.v calls a collapse is one in this sense. *)
Definition printed_sign_theorem : Prop :=
  ~ as_printed /\
  (forall d r theta_0 delta_theta, (2 <= d)%nat -> 0 < r < 1 ->
    - cos theta_0 + delta_theta < 2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) ->
    ~ as_printed_at d r theta_0 delta_theta) /\
  (forall d r x v c delta_theta, 0 < r < 1 -> 0 < spin2 d x v ->
    c + delta_theta < 2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) ->
    ~ nearly_linear d r x v c delta_theta) /\
  (exists r theta_0 delta_theta, hypotheses_as_printed r theta_0 delta_theta /\
    - cos theta_0 + delta_theta < 4 * sqrt r / (1 + r)) /\
  (forall d r x v c delta_theta, 0 < r < 1 -> c + delta_theta < 4 * sqrt r / (1 + r) ->
    ~ nearly_linear d r x v c delta_theta) /\
  (forall d r x v by_time c tolerance, 0 < r < 1 ->
    collapse d r x v by_time c tolerance -> nearly_linear d r x v c tolerance).

(* --- PrintedSign.v says just this ----------------------------------------------------------------- *)

Lemma same_nearly_linear d r x v c tolerance :
  PrintedSign.nearly_linear d r (placed x v) c tolerance <-> nearly_linear d r x v c tolerance.
Proof.
  split.
  - intros (s & time & i & j & T & z & a & b & N & E & L & D & W & S & A).
    exists (fun n => Theorem1.position (s n)), (fun n => Theorem1.velocity (s n)), time, i, j, T,
      (Theorem1.position z), a, b, N.
    split.
    { apply same_endless. replace (fun n => placed (Theorem1.position (s n)) (Theorem1.velocity (s n))) with s; [exact E|].
      apply FunctionalExtensionality.functional_extensionality. intros n. now destruct (s n). }
    split; [exact L|]. split; [now apply same_turns|]. split; [exact S | exact A].
  - intros (places & velocities & time & i & j & T & z & a & b & N & E & L & (D & W) & S & A).
    exists (fun n => placed (places n) (velocities n)), time, i, j, T, (placed z (fun _ _ => 0)), a, b, N.
    split; [now apply same_endless|]. repeat (split; [assumption|]). exact A.
Qed.
Lemma same_as_printed_at d r theta_0 delta_theta :
  PrintedSign.as_printed_at d r theta_0 delta_theta <-> as_printed_at d r theta_0 delta_theta.
Proof.
  split; intros (set & I & B).
  - exists (fun x v => set (placed x v)). split; [now apply same_interior|].
    intros x v S. apply same_nearly_linear. now apply B.
  - exists (fun s => set (Theorem1.position s) (Theorem1.velocity s)). split; [now apply same_interior|].
    intros [x v] S. apply same_nearly_linear. now apply B.
Qed.
Theorem same_as_printed : PrintedSign.as_printed <-> as_printed.
Proof. split; intros A r theta_0 delta_theta d L H; now apply same_as_printed_at, A. Qed.
Theorem same_printed_sign : Theorem1.determined -> PrintedSign.printed_sign_theorem <-> printed_sign_theorem.
Proof.
  intros ONE. split; intros (A & F & M & B & C & D);
    (split; [now intros P; apply A, same_as_printed|]; split;
    [now intros d r theta_0 delta_theta L R K P; apply (F d r theta_0 delta_theta L R K), same_as_printed_at|]).
  - split; [|split; [exact B|split]].
    + intros d r x v c delta_theta R S L K. apply (M d r (placed x v) c delta_theta R S L). now apply same_nearly_linear.
    + intros d r x v c delta_theta R L K. apply (C d r (placed x v) c delta_theta R L). now apply same_nearly_linear.
    + intros d r x v by_time c tolerance R K. apply same_nearly_linear, (D d r (placed x v) by_time c tolerance R).
      now apply same_collapse.
  - split; [|split; [exact B|split]].
    + intros d r [x v] c delta_theta R S L K. apply (M d r x v c delta_theta R S L). now apply same_nearly_linear.
    + intros d r [x v] c delta_theta R L K. apply (C d r x v c delta_theta R L). now apply same_nearly_linear.
    + intros d r [x v] by_time c tolerance R K. apply same_nearly_linear, (D d r x v by_time c tolerance R).
      now apply same_collapse.
Qed.

(* --- what is proved ------------------------------------------------------------------------------- *)

Check (PrintedSignProof.printed_sign_theorem_holds : PrintedSign.printed_sign_theorem).
Theorem printed_sign_proved : printed_sign_theorem.
Proof.
  apply same_printed_sign; [apply AllProved.all_proved | exact PrintedSignProof.printed_sign_theorem_holds].
Qed.
Theorem false_as_printed : ~ as_printed.
Proof. exact (proj1 printed_sign_proved). Qed.
(* It is false for each r and theta_0 that it admits. *)
Theorem false_for_all d r theta_0 : (2 <= d)%nat ->
  (exists delta_theta, hypotheses_as_printed r theta_0 delta_theta) ->
  exists most, 0 < most /\ forall delta_theta, delta_theta < most -> ~ as_printed_at d r theta_0 delta_theta.
Proof.
  intros L (e & R & _ & C & _). exists (2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) - - cos theta_0).
  split; [lra|]. intros delta_theta D.
  assert (2 <= sqrt 5) by (rewrite <- (sqrt_square 2) by lra; apply sqrt_le_1; lra).
  apply (proj1 (proj2 printed_sign_proved) d r theta_0 delta_theta L); lra.
Qed.
(* It is about something: where the sign is the other one, there are such collapses. *)
Theorem somewhere : exists x v, nearly_linear 2 (3 / 100) x v 1 (Delta_theta (3 / 100) 1 1 1).
Proof.
  destruct collapsing_scene as (x & v & C). exists x, v.
  apply (proj2 (proj2 (proj2 (proj2 (proj2 printed_sign_proved))))) in C; [exact C | lra].
Qed.
Print Assumptions printed_sign_proved.
