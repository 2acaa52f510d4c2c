(* What is proved of the collapse of three balls of any masses and radii, spelled out once more, with the
   words of Pinned.v. A reader compares it with the statements of certificates/three-balls and
   certificates/flow-of-balls, and with the prose; and if ThreeBalls.v comes to say less, the proofs at the end fail. *)
From Verify Require Import Pinned PinnedClassification PinnedLine.
From Verify Require Theorem1 Contacts Determined ThreeBalls ThreeBallsMap ThreeBallsCollapse BallsFlowStep.
From Coq Require Import Reals Arith Lra.
Open Scope R_scope.
Definition B1 : ball := Pinned.B1.  (* Coq has another one *)

(* --- the map of two numbers Q and U ---------------------------------------------------------------- *)

Definition P (alpha rho : R) (p : R * R) : R := alpha * (1 - snd p) - fst p - rho * snd p.
Definition L (rho : R) (p : R * R) : R := rho * snd p * (2 * fst p + rho * snd p).
Definition next (alpha rho ratio : R) (p : R * R) : R * R :=
  (ratio * (1 - snd p) / P alpha rho p, 1 - sqrt (1 - L rho p / P alpha rho p / P alpha rho p)).

Section PinnedThreeBalls.
Variable d : nat.
Variables mass radius : ball -> R.
Variable r : ball -> R.  (* the coefficient of restitution of o and another ball *)
Variables o a c : ball.  (* o has just met a, and meets c next *)

(* After n collisions o meets this ball next; and it has just met that one. *)
Definition c_ (n : nat) : ball := if Nat.even n then c else a.
Definition s_ (n : nat) : ball := if Nat.even n then a else c.
Definition sigma (b : ball) : R := radius o + radius b.
Definition beta (b b' : ball) : R := (1 + r b) * mass b / (mass o + mass b) * (sigma b / sigma b').

(* The numbers of the certificate: w, Y, k, E have the index 0 for c and 1 for a. *)
Variables w Y k E : ball -> R.
Variables G U_b C_0 Theta z Q_0 U_0 : R.
Definition alpha (n : nat) : R := beta (c_ n) (s_ n) * (C_0 - Theta).
Definition rho (n : nat) : R := G * (w (s_ n) / w (c_ n)) ^ 2.
Fixpoint orbit (n : nat) : R * R :=
  match n with O => (Q_0, U_0) | S n => next (alpha n) (rho n) (r (c_ n) * G) (orbit n) end.
Definition endless_map : Prop := forall n, 0 < P (alpha n) (rho n) (orbit n) /\
  L (rho n) (orbit n) <= U_b * (2 - U_b) * P (alpha n) (rho n) (orbit n) ^ 2.
(* N + 3 numbers by which this is decided: each is above where the map leads from the one before. *)
Definition stairs (N : nat) (Q U : nat -> R) : Prop :=
  0 <= Q_0 <= Q O /\ 0 <= U_0 <= U O /\
  (forall n, (n <= S N)%nat -> let p := (Q n, U n) in
    0 <= Q n /\ 0 <= U n <= U_b /\ 0 <= U (S n) <= U_b /\ 0 < P (alpha n) (rho n) p /\
    r (c_ n) * G * (1 - U n) <= Q (S n) * P (alpha n) (rho n) p /\
    L (rho n) p <= U (S n) * (2 - U (S n)) * P (alpha n) (rho n) p ^ 2) /\
  Q (S (S N)) <= Q N /\ U (S (S N)) <= U N.

(* The givens of the certificate: of the numbers alone, and of the places x and the velocities v. *)
Definition numbers_for (b b' : ball) : Prop :=
  0 < Y b /\ 0 <= k b /\ 0 < w b /\
  G ^ 2 * beta b b' <= G * Y b + k b /\ k b' * Y b <= r b * (1 - U_b) /\
  G * U_b <= w b ^ 2 * (E b - Y b * E b').
Definition numbers : Prop :=
  1 <= G /\ U_0 <= U_b < 1 /\ Y c * Y a < 1 /\ Theta < C_0 <= 1 /\ numbers_for c a /\ numbers_for a c /\
  (radius a + radius c) ^ 2 < sigma c ^ 2 + sigma a ^ 2 + 2 * sigma c * sigma a * (C_0 - Theta).
Definition closing_speed (x v : ball -> nat -> R) : R := - rate d x v o c / (distance d x o c * sigma c).
Definition speed (x v : ball -> nat -> R) b : R := sqrt (dot d (from_to v o b) (from_to v o b)) / sigma b.
Definition start (x v : ball -> nat -> R) : Prop :=
  distance d x o a = sigma a /\
  let y := closing_speed x v in let eta := rate d x v o a / sigma a ^ 2 in
  let gap := distance d x o c / sigma c - 1 in let gain := G / (1 - Y c * Y a) in
  0 < gap /\ 0 < y /\ 0 < eta /\ k c * y <= eta <= Q_0 * y /\
  gap * (2 + gap) * w c ^ 2 <= U_0 * (2 - U_0) * (1 + gap) ^ 2 * y ^ 2 /\
  U_b * (2 - U_b) * G ^ 2 * y ^ 2 <= w c ^ 2 * (G ^ 2 - 1) /\
  U_b * (2 - U_b) * G ^ 2 * (Y c * y) ^ 2 <= w a ^ 2 * (G ^ 2 - 1) /\
  y <= z /\ Y c * y <= z /\ beta c a * y <= z /\ beta a c * (Y c * y) <= z /\
  speed x v c <= w c - beta a c * Y c * gain * y /\ speed x v a <= w a - beta c a * gain * y /\
  Rabs (minus_cosine_at d x o a c - C_0) + (w c + w a + z) * E c * y <= Theta.

(* From x and v, the collisions of ball o with c, a, c, ... in turn without end, and no others. *)
Definition in_turn (x v : ball -> nat -> R) (places velocities : nat -> ball -> nat -> R) time : Prop :=
  (places O = x /\ velocities O = v /\ time O = 0) /\
  forall n, let t := time (S n) - time n in
    meet_first d radius (places n) (velocities n) o (c_ n) t /\
    places (S n) = moved t (places n) (velocities n) /\
    part d mass (r (c_ n)) (places (S n)) (velocities n) o (c_ n) (velocities (S n)).
End PinnedThreeBalls.

Definition three_balls_theorem : Prop :=
  forall d mass radius r o a c w Y k E G U_b C_0 Theta z Q_0 U_0 x v,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> (forall b, 0 < r b <= 1) ->
  (a <> o /\ c <> o /\ a <> c) ->
  numbers mass radius r o a c w Y k E G U_b C_0 Theta U_0 ->
  endless_map mass radius r o a c w G U_b C_0 Theta Q_0 U_0 ->
  start d mass radius r o a c w Y k E G U_b C_0 Theta z Q_0 U_0 x v ->
  exists places velocities time T at_T, in_turn d mass radius r o a c x v places velocities time /\
    Un_cv time T /\ T <= E c * closing_speed d radius o c x v /\ settles d places at_T /\
    distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
    Un_cv (fun n => minus_cosine_at d (places n) o a c) (minus_cosine_at d at_T o a c) /\
    Rabs (minus_cosine_at d at_T o a c - C_0) <= Theta.
Definition stairs_theorem : Prop :=
  forall mass radius r o a c w G U_b C_0 Theta Q_0 U_0 N Q U,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> (forall b, 0 < r b) -> 1 <= G -> U_b < 1 ->
  Theta < C_0 -> stairs mass radius r o a c w G U_b C_0 Theta Q_0 U_0 N Q U ->
  endless_map mass radius r o a c w G U_b C_0 Theta Q_0 U_0.
(* Of equal balls this is a collapse, as Pinned.v defines it: there is one trajectory, and it ends. *)
Definition three_equal_balls : Prop :=
  forall d r w Y k E G U_b C_0 Theta z Q_0 U_0 x v, 0 < r < 1 ->
  numbers (fun _ => 1) (fun _ => 1 / 2) (fun _ => r) B0 B1 B2 w Y k E G U_b C_0 Theta U_0 ->
  endless_map (fun _ => 1) (fun _ => 1 / 2) (fun _ => r) B0 B1 B2 w G U_b C_0 Theta Q_0 U_0 ->
  start d (fun _ => 1) (fun _ => 1 / 2) (fun _ => r) B0 B1 B2 w Y k E G U_b C_0 Theta z Q_0 U_0 x v ->
  collapse d r x v (E B2 * closing_speed d (fun _ => 1 / 2) B0 B2 x v) C_0 Theta.

(* --- one collision, as certificates/flow-of-balls has it -------------------------------------------- *)

(* The inner products of the places and velocities of i and c, seen from o; v is a unit of speed. *)
Definition products d (radius : ball -> R) (x u : ball -> nat -> R) o i c
    (v lam rho eps sig A B C a b w : R) : Prop :=
  let x_i := from_to x o i in let x_c := from_to x o c in
  let W_i := from_to u o i in let W_c := from_to u o c in
  dot d x_i x_i = (radius o + radius i) ^ 2 + sig * v ^ 2 /\
  dot d x_c x_c = (radius o + radius c) ^ 2 + eps * v ^ 2 /\ dot d x_i x_c = - C /\
  dot d x_i W_i = rho * v /\ dot d x_c W_c = - (lam * v) /\ dot d x_i W_c = a /\ dot d x_c W_i = b /\
  dot d W_i W_i = B /\ dot d W_c W_c = A /\ dot d W_i W_c = w.
(* The givens: what the numbers are of the collision, after the time y T, and of the state after it; and
   that nobody meets before, in Bernstein's basis. *)
Definition collision_numbers (K_c K_s K_o n r v lam rho eps sig A B C a b w y q kap s T
    C' lam' A' B' a' b' w' eps' : R) : Prop :=
  0 < r /\ 0 < v /\ 0 < lam /\ 0 <= A /\ y = lam * v /\ q = rho / lam /\ kap = eps / lam / lam /\
  0 < kap /\ 0 < 1 - A * kap /\ s = sqrt (1 - A * kap) /\ T = kap / (1 + s) /\
  C' = C - y * T * (a + (b + y * T * w)) /\
  lam' = (1 + r) / n * s * C' / K_c - q - T * B /\
  A' = B + (1 + r) / n * (y * s) * (2 * (b + y * T * w) + (1 + r) / n * (y * s)) / K_c /\
  B' = A - (1 - r ^ 2) * (y * s) ^ 2 / K_c /\
  a' = b + y * T * w + (1 + r) / n * (y * s) /\
  b' = a + y * T * w - n * ((1 + r) / n * (y * s)) * C' / K_c /\
  w' = w + (1 + r) / n * (y * s) * (n * (b + y * T * w) + r * (y * s)) / K_c /\
  eps' = sig / lam / lam + T * (2 * q + T * B) /\
  0 <= sig /\ 0 <= sig + T * lam * rho /\ 0 < eps' /\
  0 <= K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C /\
  0 <= K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C + ((rho - lam) * v - a - b) * (y * T) /\
  0 < K_c + K_s - K_o + (eps + sig) * v ^ 2 + 2 * C +
    y * T * (2 * ((rho - lam) * v - a - b) + (A + B - 2 * w) * (y * T)) /\
  0 <= B'.
Definition law_theorem : Prop :=
  forall d mass radius r x u o i c v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps',
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> (i <> o /\ c <> o /\ i <> c) ->
  products d radius x u o i c v lam rho eps sig A B C a b w ->
  collision_numbers ((radius o + radius c) ^ 2) ((radius o + radius i) ^ 2) ((radius i + radius c) ^ 2)
    (1 + mass o / mass c) r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' ->
  exists u', meet_first d radius x u o c (y * T) /\
    part d mass r (moved (y * T) x u) u o c u' /\
    products d radius (moved (y * T) x u) u' o c i y lam' (r * s) eps' 0 A' B' C' a' b' w'.

(* --- ThreeBalls.v says this ------------------------------------------------------------------------ *)

Theorem three_balls_theorem_proved : three_balls_theorem.
Proof.
  intros d mass radius r o a c w Y k E G U_b C_0 Theta z Q_0 U_0 x v M P' R D N O S.
  destruct (ThreeBallsCollapse.three_balls_theorem_holds d mass radius r o a c w Y k E G U_b C_0 Theta z Q_0 U_0
    (placed x v) M P' R D N O S) as (s & t & T & at_T & S0 & T0 & I & X).
  exists (fun n => Theorem1.position (s n)), (fun n => Theorem1.velocity (s n)), t, T, (Theorem1.position at_T).
  split; [split; [now rewrite S0|] | exact X].
  intros n. destruct (I n) as ((F & A & B & C & W) & Z). cbn zeta in *.
  change (ThreeBalls.next_ball a c n) with (c_ a c n) in *. set (b := c_ a c n) in *.
  assert (K : o <> b) by (unfold b, c_; destruct D as (? & ? & ?), (Nat.even n); congruence).
  split; [repeat (split; [assumption|]); assumption|].
  destruct Z as (J & _ & Z & V & H). rewrite Z. split; [reflexivity|]. exists J.
  split; [|split; [|split]].
  - intros i. rewrite V. now rewrite Contacts.same_true.
  - intros i. rewrite V, Contacts.same_true, Contacts.same_false by congruence. reflexivity.
  - intros q i Q1 Q2. rewrite V. now rewrite !Contacts.same_false by assumption.
  - unfold Theorem1.rate, Theorem1.to in H. rewrite Z in H. exact H.
Qed.
Theorem stairs_theorem_proved : stairs_theorem.
Proof. exact ThreeBallsMap.stair_theorem_holds. Qed.
Theorem three_equal_balls_proved : three_equal_balls.
Proof.
  intros d r w Y k E G U_b C_0 Theta z Q_0 U_0 x v R N O S.
  apply same_collapse; [exact Determined.trajectories_are_determined|].
  exact (ThreeBallsCollapse.three_equal_balls_holds d r w Y k E G U_b C_0 Theta z Q_0 U_0 (placed x v) R N O S).
Qed.

Theorem law_theorem_proved : law_theorem.
Proof.
  intros d mass radius r x u o i c v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' M P' D G N.
  destruct (BallsFlowStep.law_theorem_holds d mass radius r (placed x u) o i c v lam rho eps sig A B C a b w y q kap s T
    C' lam' A' B' a' b' w' eps' M P' D G N) as (z & (F1 & F2 & F3 & F4 & F5) & Z & X).
  exists (Theorem1.velocity z). assert (K : o <> c) by (destruct D as (? & ? & ?); congruence).
  destruct Z as (J & _ & Z & V & H). split; [repeat (split; [assumption|]); assumption|]. split.
  - exists J. split; [|split; [|split]].
    + intros k. rewrite V. now rewrite Contacts.same_true.
    + intros k. rewrite V, Contacts.same_true, Contacts.same_false by congruence. reflexivity.
    + intros j k J1 J2. rewrite V. now rewrite !Contacts.same_false by assumption.
    + unfold Theorem1.rate, Theorem1.to in H. rewrite Z in H. exact H.
  - unfold ThreeBalls.in_products, Theorem1.to in X. rewrite Z in X. exact X.
Qed.

(* --- what is proved -------------------------------------------------------------------------------- *)

Theorem three_balls_proved : three_balls_theorem /\ stairs_theorem /\ three_equal_balls /\ law_theorem.
Proof.
  exact (conj three_balls_theorem_proved (conj stairs_theorem_proved (conj three_equal_balls_proved law_theorem_proved))).
Qed.
(* It is about something: balls of the masses 1, 1, 2 and the radii 1, 1, 1/2 in the plane. *)
Definition of_three (p q s : R) (b : ball) : R := match b with Theorem1.B0 => p | Theorem1.B1 => q | Theorem1.B2 => s end.
Definition some_numbers (holds : (ball -> R) -> (ball -> R) -> (ball -> R) -> (ball -> R) -> (ball -> R) -> (ball -> R) ->
    (ball -> R) -> Prop) : Prop :=
  holds (of_three 1 1 2) (of_three 1 1 (1 / 2)) (of_three 1 (2 / 100) (3 / 100)) (fun _ => 11 / 10)
    (of_three 0 (69 / 100) (13 / 25)) (fun _ => 1 / 100) (of_three 0 (3 / 10) (1 / 4)).
Theorem somewhere : exists x v, some_numbers (fun mass radius r w Y k E =>
  numbers mass radius r B0 B1 B2 w Y k E (1001 / 1000) (1 / 10) (19 / 20) (1 / 50) (1 / 50) /\
  endless_map mass radius r B0 B1 B2 w (1001 / 1000) (1 / 10) (19 / 20) (1 / 50) (1 / 10) (1 / 50) /\
  start 2 mass radius r B0 B1 B2 w Y k E (1001 / 1000) (1 / 10) (19 / 20) (1 / 50) (11 / 1000) (1 / 10) (1 / 50) x v).
Proof.
  exists (fun b i => match b, i with Theorem1.B1, O => - (48 / 25) | Theorem1.B1, S O => 14 / 25
      | Theorem1.B2, O => 15000015 / 10000000 | _, _ => 0 end),
    (fun b i => match b, i with Theorem1.B1, O => 558464 / 1000000 | Theorem1.B1, S O => 1920448 / 1000000
      | Theorem1.B2, O => - (15 / 1000) | Theorem1.B2, S O => 3 / 2 | _, _ => 0 end).
  unfold some_numbers. split; [|split].
  - unfold numbers, numbers_for, beta, sigma, of_three, B0, B1, B2, Pinned.B1. lra.
  - apply (stairs_theorem_proved _ _ _ _ _ _ _ _ _ _ _ _ _ O (fun n => match n with O => 1 / 10 | S O => 9 / 100 | _ => 5 / 100 end)
      (fun n => match n with S (S O) => 1 / 100 | _ => 1 / 50 end)); try lra; try (intros []; cbn; lra).
    unfold stairs. split; [lra|]. split; [lra|]. split; [|lra].
    intros [|[|n]] N; [| |exfalso; inversion N; inversion H0];
      cbv beta zeta; unfold P, L, alpha, rho, beta, sigma, c_, s_, of_three, B0, B1, B2, Pinned.B1; cbn [Nat.even fst snd]; lra.
  - match goal with |- start 2 ?m ?rad _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ ?x' ?v' => set (x := x'); set (v := v') end.
    assert (root : forall s q, 0 <= q -> s = q ^ 2 -> sqrt s = q) by (intros s q Q ->; now apply sqrt_pow2).
    assert (D1 : distance 2 x B0 B1 = 2) by (apply root; [|unfold x, dot, from_to, B0, B1, Pinned.B1]; lra).
    assert (D2 : distance 2 x B0 B2 = 15000015 / 10000000) by (apply root; [|unfold x, dot, from_to, B0, B2]; lra).
    assert (R1 : rate 2 x v B0 B1 = 32 / 10000) by (unfold rate, x, v, dot, from_to, B0, B1, Pinned.B1; lra).
    assert (R2 : rate 2 x v B0 B2 = - (225000225 / 10000000000)) by (unfold rate, x, v, dot, from_to, B0, B2; lra).
    assert (S1 : sigma (of_three 1 1 (1 / 2)) B0 B1 = 2) by (unfold sigma, of_three, B0, B1, Pinned.B1; lra).
    assert (S2 : sigma (of_three 1 1 (1 / 2)) B0 B2 = 3 / 2) by (unfold sigma, of_three, B0, B2; lra).
    assert (C : minus_cosine_at 2 x B0 B1 B2 = 24 / 25).
    { unfold minus_cosine_at. rewrite D1, D2. unfold x, dot, from_to, B0, B1, B2, Pinned.B1. lra. }
    assert (Y : closing_speed 2 (of_three 1 1 (1 / 2)) B0 B2 x v = 1 / 100).
    { unfold closing_speed. rewrite D2, R2, S2. lra. }
    assert (slow : forall s t q, 0 < q -> 0 <= t -> s <= (t * q) ^ 2 -> sqrt s / q <= t).
    { intros s t q Q T M. apply Rmult_le_reg_r with q; [exact Q|]. replace (sqrt s / q * q) with (sqrt s) by (field; lra).
      assert (0 <= t * q) by (apply Rmult_le_pos; lra). rewrite <- (sqrt_pow2 (t * q)) by assumption. now apply sqrt_le_1_alt. }
    unfold start. cbv zeta. rewrite Y, D1, D2, R1, C. unfold beta. rewrite !S1, !S2.
    replace (24 / 25 - 19 / 20) with (1 / 100) by lra. rewrite Rabs_right by lra.
    unfold speed. rewrite S1, S2. unfold of_three, B0, B1, B2, Pinned.B1.
    repeat split; try lra; (apply slow; [lra | lra|]); unfold v, dot, from_to; lra.
Qed.
Print Assumptions three_balls_proved.
