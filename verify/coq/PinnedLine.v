(* What is proved of three balls on a line, spelled out once more, with the words of Pinned.v. A reader
   compares it with the statement of certificates/line, and with the prose; and if Line.v comes to say
   less, the proofs at the end fail. *)
From Verify Require Import Pinned PinnedClassification.
From Verify Require Theorem1 Classification Contacts Determined Line LineProof.
From Coq Require Import Reals Arith Lra.
Open Scope R_scope.
Definition B1 : ball := Pinned.B1.  (* Coq has another one *)

(* --- balls of any masses and radii in R^d ---------------------------------------------------------- *)

(* After the time t, the balls i and j are the first to touch, and only they. *)
Definition meet_first d (radius : ball -> R) x v i j t : Prop :=
  0 < t /\
  (forall u a b, 0 < u < t -> a <> b -> radius a + radius b < distance d (moved u x v) a b) /\
  distance d (moved t x v) i j = radius i + radius j /\ rate d (moved t x v) v i j < 0 /\
  (forall k, k <> i -> k <> j -> radius i + radius k < distance d (moved t x v) i k /\
    radius j + radius k < distance d (moved t x v) j k).
(* At the places x they exchange momentum along the line of the centres, and part at r times the speed. *)
Definition part d (mass : ball -> R) r x v i j w : Prop :=
  exists J, (forall k, w i k = v i k - J / mass i * from_to x i j k) /\
    (forall k, w j k = v j k + J / mass j * from_to x i j k) /\
    (forall b k, b <> i -> b <> j -> w b k = v b k) /\ rate d x w i j = - r * rate d x v i j.
(* From x and v, the collisions of ball o with c, a, c, ... in turn without end, and no others. *)
Definition turns d mass radius r x v o a c (places velocities : nat -> ball -> nat -> R) time : Prop :=
  (places O = x /\ velocities O = v /\ time O = 0) /\
  forall n, let b := if Nat.even n then c else a in let t := time (S n) - time n in
    meet_first d radius (places n) (velocities n) o b t /\
    places (S n) = moved t (places n) (velocities n) /\
    part d mass r (places (S n)) (velocities n) o b (velocities (S n)).

(* --- on a line ------------------------------------------------------------------------------------- *)

(* The line has the direction e. Ball a touches o, and parts from it at a speed; c is on the other side, at
   the distance gap from contact, and approaches. *)
Definition line d (radius : ball -> R) e x v o a c parting gap closing : Prop :=
  dot d e e = 1 /\ 0 < parting /\ 0 < gap /\ 0 < closing /\ forall k, (k < d)%nat ->
    from_to x o a k = - (radius o + radius a) * e k /\ from_to v o a k = - parting * e k /\
    from_to x o c k = (radius o + radius c + gap) * e k /\ from_to v o c k = - closing * e k.
(* The two numbers b and b' of certificates/line, and its givens; E is the smallest one. *)
Definition slow mass r (o a c : ball) parting closing Q : Prop :=
  let b := (1 + r) * mass c / (mass o + mass c) in let b' := (1 + r) * mass a / (mass o + mass a) in
  parting <= Q * b * closing /\ r <= b * b' * Q * (1 - Q) /\ 2 * Q < 1.
Definition line_theorem : Prop :=
  forall d mass radius r x v o a c e parting gap closing Q,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> 0 < r -> (a <> o /\ c <> o /\ a <> c) ->
  line d radius e x v o a c parting gap closing -> slow mass r o a c parting closing Q ->
  exists places velocities time T, turns d mass radius r x v o a c places velocities time /\
    Un_cv time T /\ T <= (1 - Q) / (1 - 2 * Q) * (gap / closing) /\
    (forall n, minus_cosine_at d (places n) o a c = 1) /\
    (r < 1 -> exists at_T, settles d places at_T /\ distance d at_T o a = radius o + radius a /\
      distance d at_T o c = radius o + radius c /\ minus_cosine_at d at_T o a c = 1).
(* Of equal balls this is a collapse, as Pinned.v defines it: there is one trajectory, and it ends. *)
Definition equal_on_a_line : Prop :=
  forall d r x v e parting gap closing Q, 0 < r < 1 ->
  line d (fun _ => 1 / 2) e x v B0 B1 B2 parting gap closing ->
  slow (fun _ => 1) r B0 B1 B2 parting closing Q ->
  collapse d r x v ((1 - Q) / (1 - 2 * Q) * (gap / closing)) 1 0.

(* --- Line.v says this ------------------------------------------------------------------------------ *)

Lemma places_n (s : nat -> Theorem1.scene) n :
  s n = placed (Theorem1.position (s n)) (Theorem1.velocity (s n)).
Proof. now destruct (s n). Qed.
Theorem line_theorem_proved : line_theorem.
Proof.
  intros d mass radius r x v o a c e parting gap closing Q M P R D (U & A & G & C & L) (S1 & S2 & S3).
  destruct (LineProof.line_theorem_holds d mass radius r (placed x v) o a c e parting gap closing Q M P R D
    (conj U (fun k K => match L k K with conj X (conj Y (conj Z W)) => conj X (conj Y (conj Z W)) end)) A G C S1 S3 S2)
    as (s & t & T & S0 & T0 & I & LT & B & W & E).
  exists (fun n => Theorem1.position (s n)), (fun n => Theorem1.velocity (s n)), t, T.
  split; [split; [now rewrite S0|]|].
  - intros n. destruct (I n) as ((F & N & X & Y & O) & Z). cbn zeta in *.
    set (b := if Nat.even n then c else a) in *.
    assert (K : o <> b) by (unfold b; destruct D as (? & ? & ?), (Nat.even n); congruence).
    split; [repeat (split; [assumption|]); assumption|].
    destruct Z as (J & _ & Z & V & H). rewrite Z. split; [reflexivity|]. exists J.
    split; [|split; [|split]].
    + intros k. rewrite V. now rewrite Contacts.same_true.
    + intros k. rewrite V, Contacts.same_true, Contacts.same_false by congruence. reflexivity.
    + intros q k Q1 Q2. rewrite V. now rewrite !Contacts.same_false by assumption.
    + unfold Theorem1.rate, Theorem1.to in H. rewrite Z in H. exact H.
  - split; [exact LT|]. split; [exact B|]. split; [exact W|]. intros below.
    destruct (E below) as (z & E1 & E2 & E3 & E4). exists (Theorem1.position z). now repeat (split; [assumption|]).
Qed.
Theorem equal_on_a_line_proved : equal_on_a_line.
Proof.
  intros d r x v e parting gap closing Q R (U & A & G & C & L) (S1 & S2 & S3).
  replace ((1 + r) * 1 / (1 + 1)) with ((1 + r) / 2) in S1, S2 by field.
  replace ((1 + r) / 2 * ((1 + r) / 2) * Q * (1 - Q)) with (((1 + r) / 2) ^ 2 * Q * (1 - Q)) in S2 by ring.
  apply same_collapse; [exact Determined.trajectories_are_determined|].
  exact (LineProof.equal_on_a_line_holds d r (placed x v) e parting gap closing Q R (conj U L) A G C S1 S3 S2).
Qed.

(* --- what is proved -------------------------------------------------------------------------------- *)

Theorem line_proved : line_theorem /\ equal_on_a_line.
Proof. exact (conj line_theorem_proved equal_on_a_line_proved). Qed.
(* It is about something. *)
Theorem somewhere : exists x v, line 1 (fun _ => 1 / 2) (fun _ => 1) x v B0 B1 B2 (1 / 100) 1 1 /\
  slow (fun _ => 1) (3 / 100) B0 B1 B2 (1 / 100) 1 (2 / 5).
Proof.
  exists (fun b _ => match b with Theorem1.B0 => 0 | Theorem1.B1 => - 1 | Theorem1.B2 => 2 end),
    (fun b _ => match b with Theorem1.B0 => 0 | Theorem1.B1 => - (1 / 100) | Theorem1.B2 => - 1 end).
  split; [|unfold slow; lra].
  split; [cbn [dot]; lra|]. repeat (split; [lra|]). intros k _. unfold from_to, B0, B1, B2, Pinned.B1. cbv beta iota. repeat split; lra.
Qed.
Print Assumptions line_proved.
