(* How much momentum balls exchange, and how many collisions there are in turn, spelled out once more, with
   the words of Pinned.v. A reader compares it with the prose; and if Bounds.v comes to say less, the proofs
   at the end fail. *)
From Verify Require Import Pinned.
From Verify Require Theorem1 Classification Contacts Motion Line Bounces Bounds Impulse AlternatingRuns.
From Coq Require Import Reals Arith Lra.
Open Scope R_scope.

(* --- any number of balls: 0, ..., last ----------------------------------------------------------- *)

(* The difference of two places, or of two velocities. *)
Definition apart (x : nat -> nat -> R) (a b : nat) : nat -> R := fun k => x b k - x a k.
(* Places x and velocities v number n are those just after the n-th collision. After a flight of time t n,
   balls i n and j n touch and approach; they exchange the momentum J n along the line of their centres, and
   part, or stay, at most as fast as they came. Others may collide at the same time. *)
Definition many_collide d last (mass : nat -> R) (sigma : nat -> nat -> R)
    (x v : nat -> nat -> nat -> R) (t : nat -> R) (i j : nat -> nat) (J : nat -> R) : Prop :=
  forall n, let e := apart (x (S n)) (i n) (j n) in let s := sigma (i n) (j n) in
    ((i n <= last)%nat /\ (j n <= last)%nat /\ i n <> j n) /\
    0 <= t n /\ x (S n) = (fun b k => x n b k + t n * v n b k) /\
    dot d e e = s * s /\ 0 <= J n /\
    (forall k, v (S n) (i n) k = v n (i n) k - J n / mass (i n) * (e k / s)) /\
    (forall k, v (S n) (j n) k = v n (j n) k + J n / mass (j n) * (e k / s)) /\
    (forall b, b <> i n -> b <> j n -> v (S n) b = v n b) /\
    dot d e (apart (v n) (i n) (j n)) < 0 /\
    0 <= dot d e (apart (v (S n)) (i n) (j n)) <= - dot d e (apart (v n) (i n) (j n)).
(* Seen from the centre of mass. *)
Definition centred last (mass : nat -> R) (x : nat -> nat -> R) : nat -> nat -> R := fun b k =>
  x b k - sum_f_R0 (fun b => mass b * x b k) last / sum_f_R0 mass last.
(* Sums over the balls: R^2, A and e^2; the angular momentum, and its square. *)
Definition product d last (mass : nat -> R) (x v : nat -> nat -> R) : R :=
  sum_f_R0 (fun b => mass b * dot d (x b) (v b)) last.
Definition turning last (mass : nat -> R) (x v : nat -> nat -> R) (k l : nat) : R :=
  sum_f_R0 (fun b => mass b * (x b k * v b l - x b l * v b k)) last.
Definition turning2 d last mass x v : R :=
  / 2 * dot d (fun k => dot d (turning last mass x v k) (turning last mass x v k)) (fun _ => 1).
(* III. *)
Definition exchange_theorem : Prop :=
  forall d last mass sigma x v t i j J, (forall b, 0 < mass b) -> (forall a b, 0 < sigma a b) ->
  many_collide d last mass sigma x v t i j J ->
  let x_0 := centred last mass (x 0%nat) in let v_0 := centred last mass (v 0%nat) in
  (forall n, sum_f_R0 (fun m => sigma (i m) (j m) * J m) n <=
    sqrt (product d last mass x_0 x_0) * sqrt (product d last mass v_0 v_0) - product d last mass x_0 v_0) /\
  (exists bound, forall n, sum_f_R0 J n <= bound) /\
  (exists bound, forall n, sum_f_R0 (fun m => - dot d (apart (x (S m)) (i m) (j m)) (apart (v m) (i m) (j m)) /
    sigma (i m) (j m)) n <= bound) /\
  (forall b k, (k < d)%nat -> exists l, Un_cv (fun n => v n b k) l) /\
  (forall n k l, turning last mass (centred last mass (x n)) (centred last mass (v n)) k l =
    turning last mass x_0 v_0 k l) /\
  turning2 d last mass x_0 v_0 <= product d last mass x_0 x_0 * product d last mass v_0 v_0.

(* --- runs of collisions in turn ------------------------------------------------------------------- *)

(* Minus the cosine of the angle at o. *)
Definition minus_cosine_at d x o a c : R :=
  - (dot d (from_to x o a) (from_to x o c) / (distance d x o a * distance d x o c)).
Definition distinct (o a c : ball) : Prop := a <> o /\ c <> o /\ a <> c.
(* Three balls of mass m: o collides k times, with c and a in turn, each time so that both part at r times the
   speed. At each collision two balls touch and approach, and nobody overlaps. *)
Definition run d (m : R) (radius : ball -> R) r k (places velocities : nat -> ball -> nat -> R)
    (time : nat -> R) (o a c : ball) : Prop :=
  forall n, (n < k)%nat -> let b := if Nat.even n then c else a in let t := time (S n) - time n in
    0 < t /\ places (S n) = moved t (places n) (velocities n) /\
    distance d (places (S n)) o b = radius o + radius b /\
    rate d (places (S n)) (velocities n) o b < 0 /\
    (forall a b, a <> b -> radius a + radius b <= distance d (places (S n)) a b) /\
    (exists J, 0 <= J /\
      (forall l, velocities (S n) o l = velocities n o l - J / m * from_to (places (S n)) o b l) /\
      (forall l, velocities (S n) b l = velocities n b l + J / m * from_to (places (S n)) o b l) /\
      (forall z l, z <> o -> z <> b -> velocities (S n) z l = velocities n z l)) /\
    rate d (places (S n)) (velocities (S n)) o b = - r * rate d (places (S n)) (velocities n) o b.
(* A sequence s with s_0 = 0, s_1 = 1 and s_(n+2) = a s_(n+1) - r s_n. *)
Definition compares (a r : R) (s : nat -> R) : Prop :=
  s 0%nat = 0 /\ s 1%nat = 1 /\ forall n, s (S (S n)) = a * s (S n) - r * s n.
Definition run_theorem : Prop :=
  forall d m radius r k places velocities time o a c most s, 0 < m -> (forall b, 0 < radius b) ->
  0 < r <= 1 -> distinct o a c -> run d m radius r k places velocities time o a c ->
  (forall n, (2 <= n < k)%nat -> (1 + r) / 2 * minus_cosine_at d (places n) o a c <= most) ->
  compares most r s -> forall n, (1 <= n < k)%nat -> 0 < s n.
(* On a line there are as many; and in the flight before each of them no two balls touch, and at it no other
   two. *)
Definition run_on_a_line : Prop :=
  forall d m radius r k o a c s, (1 <= d)%nat -> 0 < m -> (forall b, 0 < radius b) -> 0 < r <= 1 ->
  distinct o a c -> compares ((1 + r) / 2) r s -> (forall n, (1 <= n < k)%nat -> 0 < s n) ->
  exists places velocities time, run d m radius r k places velocities time o a c /\
    forall n, (n < k)%nat -> minus_cosine_at d (places n) o a c = 1 /\
      (forall u a b, 0 < u < time (S n) - time n -> a <> b ->
        radius a + radius b < distance d (moved u (places n) (velocities n)) a b) /\
      radius a + radius c < distance d (places (S n)) a c /\
      (let z := if Nat.even n then a else c in radius o + radius z < distance d (places (S n)) o z).
(* For small r there is no bound. *)
Definition run_without_end : Prop :=
  forall r s, 0 < r <= 7 - 4 * sqrt 3 -> compares ((1 + r) / 2) r s -> forall n, (1 <= n)%nat -> 0 < s n.

(* --- Bounds.v says this --------------------------------------------------------------------------- *)

Theorem exchange_proved : exchange_theorem.
Proof. exact Impulse.exchange_theorem_holds. Qed.
Lemma same_terms a r s : compares a r s -> forall n, Bounds.s a r n = s n.
Proof.
  intros (A & B & C). assert (G : forall n, Bounds.comparison a r n = (s n, s (S n))).
  { induction n as [|n IH]; cbn [Bounds.comparison]; [now rewrite A, B | now rewrite IH, C]. }
  intros n. unfold Bounds.s. now rewrite G.
Qed.
Lemma same_ball_or (a b : ball) : a = b \/ a <> b.
Proof. destruct a, b; (now left) || (right; discriminate). Qed.
Theorem run_proved : run_theorem.
Proof.
  intros d m radius r k places velocities time o a c most s M P R D H B SEQ n N.
  rewrite <- (same_terms _ _ _ SEQ). revert n N.
  apply (AlternatingRuns.run_theorem_holds d m radius r k (fun n => placed (places n) (velocities n)) time o a c most M P R D); [|exact B].
  intros n K. cbn zeta. destruct (H n K) as (T & X & C & Q & O & (J & J0 & I1 & I2 & I3) & V). cbn zeta in *.
  set (b := if Nat.even n then c else a) in *.
  assert (N : o <> b) by (destruct D as (D1 & D2 & _); unfold b; destruct (Nat.even n); congruence).
  assert (E : Theorem1.rate d (placed (places (S n)) (velocities (S n))) o b =
    - r * Theorem1.rate d (Theorem1.later (time (S n) - time n) (placed (places n) (velocities n))) o b).
  { unfold Theorem1.rate, Theorem1.to. cbn [Theorem1.position placed Theorem1.later].
    rewrite X in V. rewrite X. exact V. }
  split; [|exact E]. rewrite X in *. split; [exact N|]. split; [exact T|]. split; [exact C|]. split; [exact Q|]. split; [exact O|].
  exists J. split; [exact J0|]. split; [reflexivity|]. split.
  - intros z l. change (velocities (S n) z l = if Theorem1.same z o
      then velocities n z l - J / m * from_to (moved (time (S n) - time n) (places n) (velocities n)) o b l
      else if Theorem1.same z b
        then velocities n z l + J / m * from_to (moved (time (S n) - time n) (places n) (velocities n)) o b l
        else velocities n z l).
    destruct (same_ball_or z o) as [ -> | Zo ]; [rewrite Contacts.same_true; apply I1|].
    rewrite (Contacts.same_false z o Zo). destruct (same_ball_or z b) as [ -> | Zb ]; [rewrite Contacts.same_true; apply I2|].
    rewrite (Contacts.same_false z b Zb). now apply I3.
  - set (x := moved (time (S n) - time n) (places n) (velocities n)) in *.
    change (0 <= rate d x (velocities (S n)) o b <= - rate d x (velocities n) o b). rewrite V.
    assert (0 <= r * - rate d x (velocities n) o b) by (apply Rmult_le_pos; lra).
    assert (0 <= (1 - r) * - rate d x (velocities n) o b) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma distance_symmetric d x a b : distance d x a b = distance d x b a.
Proof. exact (Motion.distance_symmetric d (placed x x) a b). Qed.
Theorem run_on_a_line_proved : run_on_a_line.
Proof.
  intros d m radius r k o a c s L M P R D SEQ T.
  destruct (AlternatingRuns.run_on_a_line_holds d m radius r k o a c L M P R D) as (z & time & H).
  { intros n N. rewrite (same_terms _ _ _ SEQ). exact (T n N). }
  exists (fun n => Theorem1.position (z n)), (fun n => Theorem1.velocity (z n)), time.
  assert (G : forall n, (n < k)%nat -> let b := if Nat.even n then c else a in let y := if Nat.even n then a else c in
    let x := Theorem1.position (z (S n)) in
    x = moved (time (S n) - time n) (Theorem1.position (z n)) (Theorem1.velocity (z n)) /\ (o <> b /\ y <> o /\ y <> b) /\
    distance d x o b = radius o + radius b /\ radius o + radius y < distance d x o y /\ radius b + radius y < distance d x b y).
  { intros n K b y x. destruct (H n K) as ((_ & _ & C & _ & O) & (J & _ & X & _) & _). fold b in C, O, X.
    assert (N : o <> b /\ y <> o /\ y <> b) by (destruct D as (D1 & D2 & D3); unfold b, y; destruct (Nat.even n); repeat split; congruence).
    assert (E : x = moved (time (S n) - time n) (Theorem1.position (z n)) (Theorem1.velocity (z n))) by exact X.
    split; [exact E|]. split; [exact N|]. rewrite E. split; [exact C|]. exact (O y (proj1 (proj2 N)) (proj2 (proj2 N))). }
  split.
  - intros n K. cbn zeta. destruct (G n K) as (E & (N1 & N2 & N3) & C & O1 & O2). destruct (H n K) as ((T0 & _ & _ & Q & _) & (J & J0 & X & V & F) & _).
    cbn zeta in *. set (b := if Nat.even n then c else a) in *. set (y := if Nat.even n then a else c) in *.
    split; [exact T0|]. split; [exact E|]. split; [exact C|].
    assert (Q' : rate d (Theorem1.position (z (S n))) (Theorem1.velocity (z n)) o b < 0) by (rewrite E; exact Q).
    split; [exact Q'|]. split.
    { apply (Bounces.any_of_three (fun a b => radius a + radius b <= distance d (Theorem1.position (z (S n))) a b) o y b).
      - repeat split; congruence.
      - intros v w B. rewrite distance_symmetric. lra.
      - lra.
      - lra.
      - rewrite distance_symmetric. lra. }
    split.
    { exists J. split; [exact J0|]. rewrite E. split; [|split].
      - intros l. rewrite V, Contacts.same_true. reflexivity.
      - intros l. rewrite V, Contacts.same_false, Contacts.same_true by congruence. reflexivity.
      - intros w l W1 W2. rewrite V, (Contacts.same_false w o W1).
        match goal with |- context [Theorem1.same w ?y] => change y with b end. rewrite (Contacts.same_false w b W2). reflexivity. }
    change (Theorem1.rate d (z (S n)) o b = - r * rate d (Theorem1.position (z (S n))) (Theorem1.velocity (z n)) o b).
    rewrite E. exact F.
  - intros n K. destruct (G n K) as (E & _ & _ & O1 & O2). destruct (H n K) as ((_ & F & _) & _ & A). cbn zeta in *.
    split; [exact A|]. split; [exact F|]. split; [|exact O1].
    destruct (Nat.even n); [rewrite distance_symmetric|]; lra.
Qed.
Theorem run_without_end_proved : run_without_end.
Proof.
  intros r s R SEQ n N. rewrite <- (same_terms _ _ _ SEQ). exact (AlternatingRuns.run_without_end_holds r R n N).
Qed.

(* --- what is proved ------------------------------------------------------------------------------- *)

Theorem bounds_proved : exchange_theorem /\ run_theorem /\ run_on_a_line /\ run_without_end.
Proof.
  split; [exact exchange_proved|]. split; [exact run_proved|].
  split; [exact run_on_a_line_proved | exact run_without_end_proved].
Qed.
Print Assumptions bounds_proved.
