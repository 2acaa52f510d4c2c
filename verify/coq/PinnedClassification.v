(* What is proved of the collapses of three balls, spelled out once more, with the words of Pinned.v. A
   reader compares it with the prose; and if Classification.v comes to say less, the proofs at the end
   fail. *)
From Verify Require Import Pinned.
From Verify Require Theorem1 Classification ClassificationProof Turning Finite.
From Coq Require Import Reals List Arith FunctionalExtensionality.
Import ListNotations.
Open Scope R_scope.
Definition B1 : ball := Pinned.B1.  (* Coq has another one *)

(* --- balls of any masses and radii -------------------------------------------------------------- *)

(* At the places x, balls i and j exchange momentum along the line of the centres: the velocities are v
   before it, and w after it. They part, or stay, at most as fast as they came. *)
Definition hit d (mass : ball -> R) (x v : ball -> nat -> R) i j w : Prop :=
  exists J, 0 <= J /\
    (forall k, w i k = v i k - J / mass i * from_to x i j k) /\
    (forall k, w j k = v j k + J / mass j * from_to x i j k) /\
    (forall b k, b <> i -> b <> j -> w b k = v b k) /\
    0 <= rate d x w i j <= - rate d x v i j.
(* Places and velocities n are those just after the n-th collision, which is that of i n and j n. Flights
   take some time; at each collision two balls touch and approach, and nobody overlaps. *)
Definition collisions d (mass radius : ball -> R) (places velocities : nat -> ball -> nat -> R)
    (time : nat -> R) (i j : nat -> ball) : Prop :=
  forall n, let t := time (S n) - time n in
    i n <> j n /\ 0 < t /\ places (S n) = moved t (places n) (velocities n) /\
    distance d (places (S n)) (i n) (j n) = radius (i n) + radius (j n) /\
    rate d (places (S n)) (velocities n) (i n) (j n) < 0 /\
    (forall a b, a <> b -> radius a + radius b <= distance d (places (S n)) a b) /\
    hit d mass (places (S n)) (velocities n) (i n) (j n) (velocities (S n)).
(* From collision N on, ball o meets c and a in turn. *)
Definition in_turn_from (N : nat) (i j : nat -> ball) (o a c : ball) : Prop :=
  (a <> o /\ c <> o /\ a <> c) /\ forall n, let b := if Nat.even n then c else a in
    i (N + n)%nat = o /\ j (N + n)%nat = b \/ i (N + n)%nat = b /\ j (N + n)%nat = o.
(* The places converge, relative to one another. *)
Definition settles d (places : nat -> ball -> nat -> R) (at_T : ball -> nat -> R) : Prop :=
  forall a b k, (k < d)%nat -> Un_cv (fun n => from_to (places n) a b k) (from_to at_T a b k).
(* I. *)
Definition no_triangle : Prop :=
  forall d mass radius places velocities time T i j,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) ->
  collisions d mass radius places velocities time i j -> Un_cv time T ->
  exists at_T o a c N, settles d places at_T /\ in_turn_from N i j o a c /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    dot d (from_to at_T o a) (from_to at_T o c) <= 0.

(* --- equal balls, with one coefficient of restitution ------------------------------------------- *)

(* From x and v there are collisions without end, in any order; their times may converge, or not. *)
Definition endless d r x v (places velocities : nat -> ball -> nat -> R) (time : nat -> R)
    (i j : nat -> ball) : Prop :=
  (places O = x /\ velocities O = v /\ time O = 0) /\
  forall n, let t := time (S n) - time n in
    i n <> j n /\ 0 < t /\ places (S n) = moved t (places n) (velocities n) /\
    distance d (places (S n)) (i n) (j n) = 1 /\
    rate d (places (S n)) (velocities n) (i n) (j n) < 0 /\
    (forall a b, a <> b -> 1 <= distance d (places (S n)) a b) /\
    collide d r (places (S n)) (velocities n) (i n) (j n) (velocities (S n)).
(* Minus the cosine of the angle at o. *)
Definition minus_cosine_at d x o a c : R :=
  - (dot d (from_to x o a) (from_to x o c) / (distance d x o a * distance d x o c)).
(* II and II b; all relative velocities tend to 0 if the second alternative holds. *)
Definition least_angle : Prop :=
  forall d r x v places velocities time i j, 0 < r <= 1 ->
  endless d r x v places velocities time i j ->
  exists at_T o a c N, settles d places at_T /\ in_turn_from N i j o a c /\
    distance d at_T o a = 1 /\ distance d at_T o c = 1 /\
    4 * sqrt r / (1 + r) <= minus_cosine_at d at_T o a c <= 1 /\
    (2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) <= minus_cosine_at d at_T o a c \/
      forall a b k, (k < d)%nat -> Un_cv (fun n => from_to (velocities n) a b k) 0).
(* The same of balls of equal masses and any radii that part at r times the speed in each collision. For
   large r there are none. *)
Definition restituted d r (places velocities : nat -> ball -> nat -> R) (i j : nat -> ball) : Prop :=
  forall n, rate d (places (S n)) (velocities (S n)) (i n) (j n) =
    - r * rate d (places (S n)) (velocities n) (i n) (j n).
Definition least_angle_any_radii : Prop :=
  forall d m radius r places velocities time i j,
  0 < m -> (forall b, 0 < radius b) -> 0 < r <= 1 ->
  collisions d (fun _ => m) radius places velocities time i j -> restituted d r places velocities i j ->
  exists at_T o a c N, settles d places at_T /\ in_turn_from N i j o a c /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    4 * sqrt r / (1 + r) <= minus_cosine_at d at_T o a c <= 1 /\
    (2 * Rpower r (1 / 3) * (1 + Rpower r (1 / 3)) / (1 + r) <= minus_cosine_at d at_T o a c \/
      forall a b k, (k < d)%nat -> Un_cv (fun n => from_to (velocities n) a b k) 0).
Definition never_any_radii : Prop :=
  forall d m radius r places velocities time i j,
  0 < m -> (forall b, 0 < radius b) -> 7 - 4 * sqrt 3 < r <= 1 ->
  collisions d (fun _ => m) radius places velocities time i j -> ~ restituted d r places velocities i j.
(* III. *)
Definition bounded_impulse : Prop :=
  forall d r x v places velocities time i j, 0 < r <= 1 ->
  endless d r x v places velocities time i j ->
  exists bound, forall n,
    sum_f_R0 (fun m => - rate d (places (S m)) (velocities m) (i m) (j m)) n <= bound.

(* The angular momentum about the centre of mass: 3 times its components, and the sum of their squares,
   each pair of coordinates once. Three times the moment of inertia about it, and half its rate. *)
Definition moment (x v : ball -> nat -> R) (k l : nat) (a b : ball) : R :=
  from_to x a b k * from_to v a b l - from_to x a b l * from_to v a b k.
Definition spin x v k l : R := moment x v k l B0 B1 + moment x v k l B0 B2 + moment x v k l B1 B2.
Definition spin2 d x v : R := / 2 * dot d (fun k => dot d (spin x v k) (spin x v k)) (fun _ => 1).
Definition size d x : R := distance d x B0 B1 ^ 2 + distance d x B0 B2 ^ 2 + distance d x B1 B2 ^ 2.
Definition growth d x v : R := rate d x v B0 B1 + rate d x v B0 B2 + rate d x v B1 B2.
(* IV. *)
Definition no_spin : Prop :=
  forall d r x v places velocities time i j, 0 < r <= 1 ->
  endless d r x v places velocities time i j -> 0 < spin2 d x v -> exists T, Un_cv time T.

(* IV for any masses and radii: the balls come to rest, seen from one another, and until then do not recede
   from their centre of mass. The sums are over pairs: with the mass of all three, the product R A and the
   angular momentum about that centre. *)
Definition over_pairs (mass : ball -> R) (f : ball -> ball -> R) : R :=
  mass B0 * mass B1 * f B0 B1 + mass B0 * mass B2 * f B0 B2 + mass B1 * mass B2 * f B1 B2.
Definition comes_to_rest : Prop :=
  forall d mass radius places velocities time i j,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) ->
  collisions d mass radius places velocities time i j -> ~ (exists T, Un_cv time T) ->
  (forall a b k, (k < d)%nat -> Un_cv (fun n => from_to (velocities n) a b k) 0) /\
  (forall n, over_pairs mass (rate d (places n) (velocities n)) <= 0) /\
  (forall n k l, (k < d)%nat -> (l < d)%nat ->
    over_pairs mass (moment (places n) (velocities n) k l) = 0) /\
  exists at_T o a c N, settles d places at_T /\ in_turn_from N i j o a c /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    dot d (from_to at_T o a) (from_to at_T o c) <= 0.

(* --- trajectories with finitely many collisions ------------------------------------------------- *)

(* At the time t, where the balls arrive with velocities w, two of them touch and approach. *)
Definition collision_at d (X V : R -> ball -> nat -> R) (t : R) : Prop :=
  exists e w i j, 0 < e /\ (forall u, 0 < u < e -> X (t - u) = moved (- u) (X t) w /\ V (t - u) = w) /\
    i <> j /\ distance d (X t) i j = 1 /\ rate d (X t) w i j < 0.
(* All collisions of all trajectories from x and v are at times of one list. *)
Definition finite d r x v : Prop :=
  exists times : list R, forall T X V, trajectory d r x v T X V ->
  forall t, 0 < t < T -> collision_at d X V t -> In t times.
Definition finite_or_endless : Prop :=
  forall d r x v, 0 < r <= 1 -> finite d r x v \/
    exists places velocities time i j, endless d r x v places velocities time i j.
Definition finite_if : Prop := forall d r x v, 0 < r <= 1 ->
  7 - 4 * sqrt 3 < r \/ 9 - 4 * sqrt 5 < r /\ 0 < spin2 d x v \/
  0 <= growth d x v /\ 6 <= size d x \/
  growth d x v ^ 2 * size d x < (size d x - 6) * spin2 d x v ->
  finite d r x v.

(* --- Classification.v says this ------------------------------------------------------------------- *)

Lemma same_strikes d mass radius places velocities time i j :
  collisions d mass radius places velocities time i j ->
  Classification.strikes d mass radius (fun n => placed (places n) (velocities n)) time i j.
Proof.
  intros A n. destruct (A n) as (N & T & P & C & Q & O & J & J0 & I1 & I2 & I3 & K).
  cbn zeta in *. rewrite P in *. split; [exact N|]. split; [exact T|]. split; [exact C|].
  split; [exact Q|]. split; [exact O|]. exists J. split; [exact J0|].
  split; [reflexivity|]. split; [|exact K].
  intros b k. cbn [Theorem1.velocity placed]. set (p := i n) in *. set (q := j n) in *.
  destruct p, q, b; try (now destruct N); first [apply I1 | apply I2 | apply I3; discriminate].
Qed.
Lemma same_endless d r x v places velocities time i j :
  endless d r x v places velocities time i j <->
  Classification.endless d r (placed x v) (fun n => placed (places n) (velocities n)) time i j.
Proof.
  split.
  - intros ((A & B & C) & D). split; [now rewrite A, B|]. split; [exact C|]. intros n. cbn zeta.
    destruct (D n) as (N & T & P & K & Q & O & W). cbn zeta in *. rewrite P in *.
    split; [exact N|]. split; [exact (Rminus_gt_0_lt _ _ T)|].
    split; [exact K|]. split; [exact Q|]. split; [exact O|].
    apply same_collision; [exact N | now split].
  - intros (A & C & D). split; [injection A as -> ->; now repeat split|]. intros n. cbn zeta.
    destruct (D n) as (N & T & K & Q & O & W). cbn zeta in *.
    apply same_collision in W; [|exact N]. destruct W as (P & W). rewrite P.
    split; [exact N|]. split; [now apply Rlt_Rminus|]. repeat (split; [assumption || reflexivity|]). exact W.
Qed.
Lemma same_turns N i j o a c : Classification.distinct_balls o a c ->
  Classification.in_turn_from N i j o a c -> in_turn_from N i j o a c.
Proof. intros D T. split; [exact D | exact T]. Qed.
Lemma same_finite d r x v : Classification.finite d r (placed x v) -> finite d r x v.
Proof.
  intros (times & F). exists times. intros T X V G t L (e & w & i & j & E & A & K).
  apply (F T (fun t => placed (X t) (V t))); [now apply same_trajectory | exact L|].
  exists e, (placed (X t) w), i, j. split; [exact E|]. split; [|exact K].
  intros u U. destruct (A u U) as [P Q]. now rewrite P, Q.
Qed.
Theorem no_triangle_proved : no_triangle.
Proof.
  intros d mass radius places velocities time T i j M P S L. apply same_strikes in S.
  destruct (ClassificationProof.no_triangle_holds _ _ _ _ _ _ _ _ M P S L) as (z & o & a & c & N & Z & D & W & K).
  exists (Theorem1.position z), o, a, c, N. split; [exact Z|]. split; [now apply same_turns | exact K].
Qed.
Theorem least_angle_proved : least_angle.
Proof.
  intros d r x v places velocities time i j R E. apply same_endless in E.
  destruct (ClassificationProof.least_angle_holds _ _ _ _ _ _ _ R E) as (z & o & a & c & N & Z & D & W & K).
  exists (Theorem1.position z), o, a, c, N. split; [exact Z|]. split; [now apply same_turns | exact K].
Qed.
Lemma same_restitution d mass radius r places velocities time i j :
  collisions d mass radius places velocities time i j -> restituted d r places velocities i j ->
  Classification.restituted d r (fun n => placed (places n) (velocities n)) time i j.
Proof.
  intros S V n. specialize (V n). destruct (S n) as (_ & _ & E & _). cbn zeta in E. rewrite E in V.
  unfold Theorem1.rate at 1, Theorem1.to. cbn [Theorem1.position placed]. rewrite E. exact V.
Qed.
Theorem least_angle_any_radii_proved : least_angle_any_radii.
Proof.
  intros d m radius r places velocities time i j M P R S V. apply (same_restitution _ _ _ _ _ _ _ _ _ S) in V.
  apply same_strikes in S.
  destruct (ClassificationProof.least_angle_any_radii_holds d m radius r _ time i j M P R S V) as
    (z & o & a & c & N & Z & D & W & K).
  exists (Theorem1.position z), o, a, c, N. split; [exact Z|]. split; [now apply same_turns | exact K].
Qed.
Theorem never_any_radii_proved : never_any_radii.
Proof.
  intros d m radius r places velocities time i j M P R S V. apply (same_restitution _ _ _ _ _ _ _ _ _ S) in V.
  apply same_strikes in S. exact (ClassificationProof.never_any_radii_holds d m radius r _ time i j M P R S V).
Qed.
Theorem comes_to_rest_proved : comes_to_rest.
Proof.
  intros d mass radius places velocities time i j M P S N. apply same_strikes in S.
  destruct (ClassificationProof.comes_to_rest_holds d mass radius _ time i j M P S N) as
    (V & G & L & z & o & a & c & K & Z & D & W & E).
  split; [exact V|]. split; [exact G|]. split; [exact L|].
  exists (Theorem1.position z), o, a, c, K. split; [exact Z|]. split; [now apply same_turns | exact E].
Qed.
Theorem bounded_impulse_proved : bounded_impulse.
Proof.
  intros d r x v places velocities time i j R E. pose proof E as (_ & D). apply same_endless in E.
  destruct (ClassificationProof.bounded_impulse_holds _ _ _ _ _ _ _ R E) as (b & B). exists b. intros n.
  apply Rle_trans with (2 := B n). right. apply sum_eq. intros m _. destruct (D m) as (_ & _ & P & _).
  cbn zeta in P. now rewrite P.
Qed.
Theorem no_spin_proved : no_spin.
Proof.
  intros d r x v places velocities time i j R E S. apply same_endless in E.
  exact (ClassificationProof.no_spin_holds _ _ (placed x v) _ _ _ _ R E S).
Qed.
Theorem finite_or_endless_proved : finite_or_endless.
Proof.
  intros d r x v R. destruct (Finite.finite_or_endless_holds d r (placed x v) R) as [F|(s & t & i & j & E)];
    [left; now apply same_finite | right].
  exists (fun n => Theorem1.position (s n)), (fun n => Theorem1.velocity (s n)), t, i, j. apply same_endless.
  replace (fun n => placed (Theorem1.position (s n)) (Theorem1.velocity (s n))) with s; [exact E|].
  extensionality n. now destruct (s n).
Qed.
Theorem finite_if_proved : finite_if.
Proof.
  intros d r x v R H. destruct (Finite.finite_or_endless_holds d r (placed x v) R) as [F|(s & t & i & j & E)];
    [now apply same_finite | exfalso].
  destruct H as [H|[(H & S)|[(A & Z)|H]]].
  - exact (ClassificationProof.never_holds d r (placed x v) s t i j (conj H (proj2 R)) E).
  - exact (ClassificationProof.never_with_spin_holds d r (placed x v) s t i j (conj H (proj2 R)) S E).
  - exact (ClassificationProof.never_outward_holds d r (placed x v) s t i j R A Z E).
  - exact (Turning.never_turning_holds d r (placed x v) s t i j R H E).
Qed.

(* --- what is proved ------------------------------------------------------------------------------- *)

Theorem classification_proved : no_triangle /\ least_angle /\ least_angle_any_radii /\ never_any_radii /\
  bounded_impulse /\ no_spin /\ comes_to_rest /\ finite_or_endless /\ finite_if.
Proof.
  split; [exact no_triangle_proved|]. split; [exact least_angle_proved|].
  split; [exact least_angle_any_radii_proved|]. split; [exact never_any_radii_proved|].
  split; [exact bounded_impulse_proved|]. split; [exact no_spin_proved|]. split; [exact comes_to_rest_proved|].
  split; [exact finite_or_endless_proved | exact finite_if_proved].
Qed.
Print Assumptions classification_proved.
