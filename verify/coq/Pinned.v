(* Theorem 1 once more, spelled out with Coq's own real numbers: the only thing on this page that
   comes from another of our files is that there are three balls. A reader compares it with the
   paper; and if Theorem1.v comes to say anything else, the proofs at the end fail. Nothing is
   imported from Verify, so that no notation and no scope of another file changes what is read. *)
From Coq Require Import Reals List Arith Lra FunctionalExtensionality.
From Verify Require Theorem1 AllProved.
Import ListNotations.
Open Scope R_scope.

Definition ball := Theorem1.ball.
Definition B0 : ball := Theorem1.B0.
Definition B1 : ball := Theorem1.B1.
Definition B2 : ball := Theorem1.B2.
Theorem three_balls : (forall b : ball, b = B0 \/ b = B1 \/ b = B2) /\ B0 <> B1 /\ B0 <> B2 /\ B1 <> B2.
Proof. split; [intros []; auto | repeat split; discriminate]. Qed.

(* --- three balls of diameter 1 in R^d, at the places x, with the velocities v ----------------- *)

(* u_0 v_0 + ... + u_(d-1) v_(d-1) *)
Fixpoint dot (d : nat) (u v : nat -> R) : R :=
  match d with O => 0 | S k => dot k u v + u k * v k end.
Definition from_to (x : ball -> nat -> R) (i j : ball) : nat -> R := fun k => x j k - x i k.
Definition distance d x i j := sqrt (dot d (from_to x i j) (from_to x i j)).
Definition rate d x v i j := dot d (from_to x i j) (from_to v i j).
Definition minus_cosine d x :=
  - (dot d (from_to x B0 B1) (from_to x B0 B2) / (distance d x B0 B1 * distance d x B0 B2)).

(* The places after the time t of free flight. *)
Definition moved (t : R) (x v : ball -> nat -> R) : ball -> nat -> R := fun i k => x i k + t * v i k.

(* After the time t, the balls i and j are the first to meet, and only they. *)
Definition meet d x v i j t : Prop :=
  0 < t /\ (forall u a b, 0 < u < t -> a <> b -> 1 < distance d (moved u x v) a b) /\
  distance d (moved t x v) i j = 1 /\ rate d (moved t x v) v i j < 0 /\
  (forall k, k <> i -> k <> j ->
    1 < distance d (moved t x v) i k /\ 1 < distance d (moved t x v) j k).

(* The balls i and j collide at the places x. Of the rate at which they approach, the part r is left
   as the rate at which they part; momentum is kept. The velocities are v before it, and w after it. *)
Definition collide d r x v i j w : Prop :=
  (forall k, w i k = v i k + (1 + r) / 2 * rate d x v i j * from_to x i j k) /\
  (forall k, w j k = v j k - (1 + r) / 2 * rate d x v i j * from_to x i j k) /\
  (forall b k, b <> i -> b <> j -> w b k = v b k).

(* --- trajectories ----------------------------------------------------------------------------- *)

(* From the places x with the velocities v, until just before the time T: the places X(t), and the
   velocities V(t) just after what happens at the time t. After each time t there is free flight for
   a while; before it, too, arriving with velocities w. Nobody overlaps. If balls touch that approach,
   then there are just two of them, and they collide. *)
Definition trajectory d r x v T (X V : R -> ball -> nat -> R) : Prop :=
  (X 0 = x /\ V 0 = v) /\
  (forall t, 0 <= t < T -> exists e, 0 < e /\
    forall u, 0 <= u < e -> X (t + u) = moved u (X t) (V t) /\ V (t + u) = V t) /\
  (forall t, 0 < t < T -> exists e w, 0 < e /\
    (forall u, 0 < u < e -> X (t - u) = moved (- u) (X t) w /\ V (t - u) = w) /\
    (V t = w /\ (forall i j, i <> j ->
       1 <= distance d (X t) i j /\ (distance d (X t) i j = 1 -> 0 <= rate d (X t) w i j)) \/
     exists i j, i <> j /\ distance d (X t) i j = 1 /\ rate d (X t) w i j < 0 /\
       (forall k, k <> i -> k <> j -> 1 < distance d (X t) i k /\ 1 < distance d (X t) j k) /\
       collide d r (X t) w i j (V t))).

(* From x and v, there are infinitely many collisions before a time T, of ball 0 with 2, 1, 2, 1, ...
   in turn, but finitely many before each earlier time. There is one trajectory, and it ends at T. The
   positions tend to places where both other balls touch ball 0. T is at most by_time, and minus the
   cosine of the angle at ball 0 is c, to within the tolerance. *)
Definition collapse d r x v by_time c tolerance : Prop :=
  exists (places velocities : nat -> ball -> nat -> R) (time : nat -> R) (T : R)
    (X V : R -> ball -> nat -> R) (at_T : ball -> nat -> R),
  (places O = x /\ velocities O = v /\ time O = 0) /\
  (forall n, let j := if Nat.even n then B2 else B1 in
    let t := time (S n) - time n in
    meet d (places n) (velocities n) B0 j t /\
    places (S n) = moved t (places n) (velocities n) /\
    collide d r (places (S n)) (velocities n) B0 j (velocities (S n))) /\
  Un_cv time T /\
  (forall n t, time n <= t < time (S n) ->
    X t = moved (t - time n) (places n) (velocities n) /\ V t = velocities n) /\
  trajectory d r x v T X V /\
  (forall T' X' V', trajectory d r x v T' X' V' ->
    T' <= T /\ forall t, 0 <= t < T' -> X' t = X t /\ V' t = V t) /\
  (forall i k, (k < d)%nat -> forall e, 0 < e ->
    exists m, m < T /\ forall t, m < t < T -> Rabs (X t i k - at_T i k) < e) /\
  distance d at_T B0 B1 = 1 /\ distance d at_T B0 B2 = 1 /\
  Un_cv (fun n => minus_cosine d (places n)) (minus_cosine d at_T) /\
  T <= by_time /\ Rabs (minus_cosine d at_T - c) <= tolerance.

(* Something holds for all positions and velocities that are near some. *)
Definition has_interior d (set : (ball -> nat -> R) -> (ball -> nat -> R) -> Prop) : Prop :=
  exists x v e, 0 < e /\ forall x' v',
    (forall i k, (k < d)%nat -> Rabs (x' i k - x i k) < e /\ Rabs (v' i k - v i k) < e) -> set x' v'.

(* Something holds for all coordinates in some intervals of positive lengths. *)
Definition contains_a_box d (set : (ball -> nat -> R) -> (ball -> nat -> R) -> Prop) : Prop :=
  exists x y v w, (forall i k, (k < d)%nat -> x i k < y i k /\ v i k < w i k) /\
    forall x' v', (forall i k, (k < d)%nat ->
      x i k <= x' i k <= y i k /\ v i k <= v' i k <= w i k) -> set x' v'.

(* --- the constants, as in the paper, with the repaired minima --------------------------------- *)

Section PinnedConstants.
Variables r c V_0 delta_theta : R.
Definition minimum (a : R) (others : list R) : R := fold_right Rmin a others.

Definition alpha_0 := (1 + r) / 2 * c.
Definition phi_minus := 2 * r / (alpha_0 + sqrt (alpha_0 ^ 2 - 4 * r)).
Definition delta_1 := alpha_0 / 2 - phi_minus.
Definition delta_2 := (alpha_0 - phi_minus) / 2.
Definition delta_3 := (1 - (alpha_0 - phi_minus)) / 2.
Definition C_eta := 1 - delta_3.
Definition h_4 := (1 - r / (alpha_0 - phi_minus) ^ 2) / 2.
Definition delta_4 := alpha_0 - phi_minus - sqrt (r / (1 - h_4)).
Definition h_5 := (1 - phi_minus / (alpha_0 - phi_minus) ^ 2) / 2.
Definition delta_5 := alpha_0 - phi_minus - sqrt (phi_minus / (1 - h_5)).
Definition V_1 := V_0 * ((1 - h_5 / 2) / (1 - h_5)).
Definition delta_x :=
  minimum delta_1 [delta_2; delta_3; delta_4; delta_5; V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition x_0 := minimum ((1 - h_4) * delta_x) [V_0 / V_1 * (delta_2 ^ 2 * h_5 / 12)].
Definition Delta_theta := minimum (c / 2) [h_4 * delta_x / 8; delta_theta].
Definition eta_bar :=
  minimum 1 [
    (sqrt 2 - 1) / 16 * (V_0 / sqrt V_1);
    (1 - C_eta) / 28 * (V_0 / sqrt V_1) * Delta_theta;
    (1 - C_eta) * (V_1 - V_0) / (12 * (sqrt V_1 + 2));
    V_0 / sqrt V_1 / (12 * alpha_0) * (h_4 * delta_x);
    V_0 / sqrt V_1 * (delta_2 / 6) * (h_4 * delta_x);
    V_0 / sqrt V_1 / 24 * (h_4 * delta_x)].
Definition zeta_bar :=
  minimum (2 * (sqrt 2 - 1)) [
    V_0 * h_5 / (3 * V_1 * (alpha_0 + 8 * V_1 / V_0)) * delta_2 ^ 2;
    h_4 * delta_x / 16;
    delta_2 / 4 * (h_4 * delta_x);
    V_0 / V_1 / 16 * (h_4 * delta_x)].
Definition d_slope := zeta_bar / (2 * V_1).
Definition d_const :=
  minimum ((sqrt 2 - 1) / 4) [Delta_theta / 4; delta_2 / 2 * (h_4 * delta_x); h_4 * delta_x / 8].
Definition T_star := 2 / (V_0 * (1 - C_eta)) * eta_bar * zeta_bar.

(* --- what is asked for, and what follows ------------------------------------------------------ *)

Definition admissible : Prop :=
  0 < r < 1 /\ 0 < c <= 1 /\
  3 * r * ((1 + r) / 2 * c) + r * (1 + r) < ((1 + r) / 2 * c) ^ 3 /\
  0 < V_0 /\ 0 < delta_theta.

Definition initial d x v d_0 y : Prop :=
  distance d x B0 B2 = 1 + d_0 /\ rate d x v B0 B2 = - y * (1 + d_0) /\
  distance d x B0 B1 = 1 /\ 0 < rate d x v B0 B1 /\
  0 < y <= eta_bar /\ Rabs (rate d x v B0 B1 - phi_minus * y) <= x_0 * y /\
  0 < d_0 <= Rmin d_const (d_slope * y ^ 2) /\
  V_0 + (V_1 - V_0) / 3 <= dot d (from_to v B0 B1) (from_to v B0 B1) <= V_1 - (V_1 - V_0) / 3 /\
  V_0 + (V_1 - V_0) / 3 <= dot d (from_to v B0 B2) (from_to v B0 B2) <= V_1 - (V_1 - V_0) / 3 /\
  Rabs (minus_cosine d x - c) <= Delta_theta / 4.

(* These, and those into which they fly while no two balls touch. *)
Definition ZK d x' v : Prop :=
  exists x d_0 y u, initial d x v d_0 y /\ 0 <= u /\
    (forall w i j, 0 < w <= u -> i <> j -> 1 < distance d (moved w x v) i j) /\ x' = moved u x v.
End PinnedConstants.

Definition theorem_1 : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d x v, ZK r c V_0 delta_theta d x v ->
    collapse d r x v (T_star r c V_0 delta_theta) c (Delta_theta r c V_0 delta_theta).
Definition interior : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d, (2 <= d)%nat -> has_interior d (ZK r c V_0 delta_theta d).
Definition positive_volume : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  forall d, (2 <= d)%nat -> contains_a_box d (ZK r c V_0 delta_theta d).
Definition determined : Prop :=
  forall d r x v T X V T' X' V', trajectory d r x v T X V -> trajectory d r x v T' X' V' ->
  forall t, 0 <= t < T -> t < T' -> X t = X' t /\ V t = V' t.
Definition constants_defined : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta ->
  0 < alpha_0 r c /\ 0 < alpha_0 r c ^ 2 - 4 * r /\ 0 < alpha_0 r c - phi_minus r c /\
  0 < 1 - h_4 r c /\ 0 < 1 - h_5 r c /\ 0 < 1 - C_eta r c /\ 0 < V_1 r c V_0 /\
  phi_minus r c = (alpha_0 r c - sqrt (alpha_0 r c ^ 2 - 4 * r)) / 2 /\
  r / (alpha_0 r c - (phi_minus r c + delta_4 r c)) ^ 2 = 1 - h_4 r c /\
  phi_minus r c / (alpha_0 r c - (phi_minus r c + delta_5 r c)) ^ 2 = 1 - h_5 r c /\
  0 < phi_minus r c /\ 0 < delta_x r c V_0 /\ 0 < x_0 r c V_0 /\ V_0 < V_1 r c V_0 /\
  0 < Delta_theta r c V_0 delta_theta <= delta_theta /\ 0 < eta_bar r c V_0 delta_theta /\
  0 < zeta_bar r c V_0 /\ 0 < d_const r c V_0 delta_theta /\ 0 < d_slope r c V_0.
(* The power 1/3 is the cube root. *)
Definition printed_hypothesis r c : Prop :=
  0 < r < 9 - 4 * sqrt 5 /\ 2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) < c.
Definition same_hypothesis : Prop :=
  forall r c V_0 delta_theta, admissible r c V_0 delta_theta <->
    printed_hypothesis r c /\ c <= 1 /\ 0 < V_0 /\ 0 < delta_theta.
Definition printed_theorem : Prop :=
  forall r theta_0 delta_theta d, (2 <= d)%nat -> PI / 2 < theta_0 <= PI ->
  printed_hypothesis r (- cos theta_0) -> 0 < delta_theta ->
  exists set, has_interior d set /\
    exists by_time, forall x v, set x v -> collapse d r x v by_time (- cos theta_0) delta_theta.

(* --- Theorem1.v says just this ---------------------------------------------------------------- *)

Definition placed (x v : ball -> nat -> R) : Theorem1.scene := Theorem1.Scene x v.
Lemma same_admissible r c V_0 delta_theta :
  Theorem1.admissible r c V_0 delta_theta <-> admissible r c V_0 delta_theta.
Proof. split; [intros [] | intros (? & ? & ? & ? & ?)]; repeat split; tauto. Qed.
Lemma same_initial r c V_0 delta_theta d x v d_0 y :
  Theorem1.initial r c V_0 delta_theta d (placed x v) d_0 y <-> initial r c V_0 delta_theta d x v d_0 y.
Proof.
  split; [intros [] | intros (? & ? & ? & ? & ? & ? & ? & ? & ? & ?); constructor]; try assumption.
  repeat (split; [assumption|]). assumption.
Qed.
Lemma same_ZK r c V_0 delta_theta d x v :
  Theorem1.ZK r c V_0 delta_theta d (placed x v) <-> ZK r c V_0 delta_theta d x v.
Proof.
  split.
  - intros ([x' v'] & d_0 & y & u & A & B & C & D). injection D as -> ->. exists x', d_0, y, u.
    split; [now apply same_initial | now repeat split].
  - intros (x' & d_0 & y & u & A & B & C & ->). exists (placed x' v), d_0, y, u.
    split; [now apply same_initial | now repeat split].
Qed.
Lemma same_meet d x v i j t : Theorem1.first_to_meet d (placed x v) i j t <-> meet d x v i j t.
Proof.
  split; [intros [] | intros (? & ? & ? & ? & ?); constructor]; try assumption.
  repeat (split; [assumption|]). assumption.
Qed.
Lemma same_collision d r x v i j y w : i <> j ->
  placed y w = Theorem1.collided d r i j (placed x v) <-> y = x /\ collide d r x v i j w.
Proof.
  intros N. split.
  - intros E. injection E as E F. subst w. split; [exact E|]. repeat split; intros.
    + destruct i; reflexivity.
    + destruct i, j; try (now destruct N); reflexivity.
    + destruct b, i, j; try reflexivity; try (now destruct N); try (now destruct H); now destruct H0.
  - intros (-> & A & B & C). unfold placed, Theorem1.collided. f_equal.
    extensionality b. extensionality k.
    destruct i, j, b; try (now destruct N); try apply A; try apply B; apply C; discriminate.
Qed.
Lemma same_trajectory d r x v T X V :
  Theorem1.trajectory d r (placed x v) T (fun t => placed (X t) (V t)) <-> trajectory d r x v T X V.
Proof.
  split.
  - intros [A B C]. split; [|split].
    + now injection A.
    + intros t L. destruct (B t L) as (e & E & F). exists e. split; [exact E|]. intros u U.
      specialize (F u U). injection F as F G. now split.
    + intros t L. destruct (C t L) as (e & [y w] & E & F & G). exists e, w. split; [exact E|].
      assert (Y : y = X t).
      { destruct G as [[_ G]|(i & j & N & _ & _ & _ & G)]; [now injection G|].
        apply same_collision in G; [|exact N]. symmetry. apply G. }
      subst y. split.
      { intros u U. specialize (F u U). injection F as F F'. now split. }
      destruct G as [[G H]|(i & j & N & P & Q & O & G)]; [left | right].
      * injection H as H. now split.
      * exists i, j. repeat (split; [assumption|]). apply same_collision in G; [apply G | exact N].
  - intros ([A A'] & B & C). split.
    + now rewrite A, A'.
    + intros t L. destruct (B t L) as (e & E & F). exists e. split; [exact E|]. intros u U.
      destruct (F u U) as [F1 F2]. now rewrite F1, F2.
    + intros t L. destruct (C t L) as (e & w & E & F & G). exists e, (placed (X t) w).
      split; [exact E|]. split.
      { intros u U. destruct (F u U) as [F1 F2]. now rewrite F1, F2. }
      destruct G as [[G H]|(i & j & N & P & Q & O & G)]; [left; now rewrite G | right].
      exists i, j. repeat (split; [assumption|]). now apply same_collision.
Qed.
Lemma same_collapse d r x v by_time c tolerance :
  Theorem1.determined ->
  Theorem1.collapse d r (placed x v) by_time c tolerance <-> collapse d r x v by_time c tolerance.
Proof.
  intros ONE.
  assert (N : forall n, B0 <> Theorem1.collides_with n)
    by (intros n; unfold Theorem1.collides_with; destruct Nat.even; discriminate).
  split.
  - intros (s & t & T & Z & z & [A B C D E F G H I J K] & L & M).
    exists (fun n => Theorem1.position (s n)), (fun n => Theorem1.velocity (s n)), t, T.
    exists (fun t => Theorem1.position (Z t)), (fun t => Theorem1.velocity (Z t)).
    exists (Theorem1.position z).
    assert (W : (fun t => placed (Theorem1.position (Z t)) (Theorem1.velocity (Z t))) = Z)
      by (extensionality u; now destruct (Z u)).
    split; [now rewrite A|]. split; [|split; [exact D|]].
    { intros n. destruct (C n) as [P Q]. cbn zeta.
      change (if Nat.even n then B2 else B1) with (Theorem1.collides_with n).
      destruct (s n) as [x' v'], (s (S n)) as [x'' v'']. split; [now apply same_meet|].
      apply same_collision in Q; [|apply N]. destruct Q as [-> Q]. now split. }
    split; [intros n u U; now rewrite (E n u U)|].
    split; [apply same_trajectory; now rewrite W|].
    split; [|repeat (split; [assumption|]); assumption].
    intros T' X' V' P. apply same_trajectory in P. specialize (G _ _ P). split; [exact G|].
    intros u U. pose proof (ONE d r _ T Z _ _ F P u ltac:(lra) ltac:(lra)) as Q. now rewrite Q.
  - intros (p & w & t & T & X & V & z & (A & A' & B) & C & D & E & F & G & H & I & J & K & L & M).
    exists (fun n => placed (p n) (w n)), t, T, (fun t => placed (X t) (V t)).
    exists (placed z (fun _ _ => 0)). split; [|now split].
    split; try assumption.
    + now rewrite A, A'.
    + intros n. destruct (C n) as (P & Q & O). split; [now apply same_meet|].
      rewrite Q in *. apply same_collision; [apply N | now split].
    + intros n u U. destruct (E n u U) as [P Q]. now rewrite P, Q.
    + now apply same_trajectory.
    + intros T' Z' P.
      assert (W : (fun t => placed (Theorem1.position (Z' t)) (Theorem1.velocity (Z' t))) = Z')
        by (extensionality u; now destruct (Z' u)).
      rewrite <- W in P. apply same_trajectory in P. exact (proj1 (G _ _ _ P)).
Qed.
Lemma same_interior d (set : Theorem1.scene -> Prop) :
  Theorem1.has_interior d set <-> has_interior d (fun x v => set (placed x v)).
Proof.
  split.
  - intros ([x v] & e & E & A). exists x, v, e. split; [exact E|]. intros x' v' C. now apply A.
  - intros (x & v & e & E & A). exists (placed x v), e. split; [exact E|]. intros [x' v'] C.
    now apply A.
Qed.
Lemma same_set d set set' : (forall x v, set x v <-> set' x v) -> has_interior d set -> has_interior d set'.
Proof. intros S (x & v & e & E & A). exists x, v, e. split; [exact E|]. intros. now apply S, A. Qed.

Theorem same_determined : Theorem1.determined <-> determined.
Proof.
  split.
  - intros A d r x v T X V T' X' V' B C t L M. apply same_trajectory in B, C.
    pose proof (A d r _ T _ T' _ B C t L M) as Q. now injection Q.
  - intros A d r [x v] T Z T' Z' B C t L M.
    assert (W : forall Y : R -> Theorem1.scene,
      (fun t => placed (Theorem1.position (Y t)) (Theorem1.velocity (Y t))) = Y)
      by (intros Y; extensionality u; now destruct (Y u)).
    rewrite <- (W Z) in B. rewrite <- (W Z') in C. apply same_trajectory in B, C.
    destruct (A _ _ _ _ _ _ _ _ _ _ B C t L M) as [P Q].
    destruct (Z t), (Z' t). cbn in P, Q. now rewrite P, Q.
Qed.
Theorem same_theorem : Theorem1.determined -> Theorem1.theorem_1 <-> theorem_1.
Proof.
  intros ONE. split.
  - intros A r c V_0 delta_theta B d x v C. apply same_collapse; [exact ONE|].
    apply A; [now apply same_admissible | now apply same_ZK].
  - intros A r c V_0 delta_theta B d [x v] C. apply same_collapse; [exact ONE|].
    apply A; [now apply same_admissible | now apply same_ZK].
Qed.
Theorem same_interiors : Theorem1.interior <-> interior.
Proof.
  split; intros A r c V_0 delta_theta B d C.
  - apply same_admissible in B. specialize (A _ _ _ _ B d C). apply same_interior in A.
    revert A. apply same_set. intros x v. apply same_ZK.
  - apply same_admissible in B. specialize (A _ _ _ _ B d C). apply same_interior.
    revert A. apply same_set. intros x v. symmetry. apply same_ZK.
Qed.
Theorem same_volume : Theorem1.positive_volume <-> positive_volume.
Proof.
  split; intros A r c V_0 delta_theta B d C; apply same_admissible in B; specialize (A _ _ _ _ B d C).
  - destruct A as ([x v] & [y w] & P & Q). exists x, y, v, w. split; [exact P|].
    intros x' v' I. apply same_ZK. apply Q. exact I.
  - destruct A as (x & y & v & w & P & Q). exists (placed x v), (placed y w). split; [exact P|].
    intros [x' v'] I. apply same_ZK. apply Q. exact I.
Qed.
Theorem same_constants : Theorem1.constants_defined <-> constants_defined.
Proof. split; intros A r c V_0 delta_theta B; apply same_admissible in B; exact (A _ _ _ _ B). Qed.
Theorem same_hypotheses : Theorem1.same_hypothesis <-> same_hypothesis.
Proof.
  split; intros A r c V_0 delta_theta; (etransitivity; [|apply A]); [symmetry|]; apply same_admissible.
Qed.
Theorem same_printed : Theorem1.determined -> Theorem1.printed_theorem <-> printed_theorem.
Proof.
  intros ONE. split; intros A r theta_0 delta_theta d L P H Q.
  - destruct (A r theta_0 delta_theta d L P H Q) as (set & I & by_time & B).
    exists (fun x v => set (placed x v)). split; [now apply same_interior|]. exists by_time.
    intros x v C. apply same_collapse; [exact ONE | now apply B].
  - destruct (A r theta_0 delta_theta d L P H Q) as (set & I & by_time & B).
    exists (fun s => set (Theorem1.position s) (Theorem1.velocity s)).
    split; [now apply same_interior|]. exists by_time. intros [x v] C.
    apply same_collapse; [exact ONE | now apply B].
Qed.

(* --- what is proved --------------------------------------------------------------------------- *)

Check (AllProved.all_proved :
  Theorem1.theorem_1 /\ Theorem1.interior /\ Theorem1.positive_volume /\ Theorem1.determined /\
  Theorem1.constants_defined /\
  Theorem1.same_hypothesis /\ Theorem1.printed_theorem).
Theorem proved :
  theorem_1 /\ interior /\ positive_volume /\ determined /\ constants_defined /\ same_hypothesis /\
  printed_theorem.
Proof.
  destruct AllProved.all_proved as (A & B & V & C & D & E & F).
  split; [now apply same_theorem|]. split; [now apply same_interiors|].
  split; [now apply same_volume|].
  split; [now apply same_determined|]. split; [now apply same_constants|].
  split; [now apply same_hypotheses | now apply same_printed].
Qed.

(* It is about something: these are admissible parameters, with scenes that collapse. *)
Theorem admissible_parameters : admissible (3 / 100) 1 1 1.
Proof. repeat split; lra. Qed.
Theorem collapsing_scene : exists x v,
  collapse 2 (3 / 100) x v (T_star (3 / 100) 1 1 1) 1 (Delta_theta (3 / 100) 1 1 1).
Proof.
  destruct proved as (A & B & _).
  destruct (B _ _ _ _ admissible_parameters 2%nat (Nat.le_refl 2)) as (x & v & e & P & C).
  exists x, v. apply (A _ _ _ _ admissible_parameters). apply C. intros i k _.
  now rewrite !Rminus_diag_eq, Rabs_R0.
Qed.
Print Assumptions collapsing_scene.
