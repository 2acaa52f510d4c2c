(* How much momentum is exchanged, and how many collisions there are in turn: what is proved of them. This
   page can be read after Classification.v; it proves nothing.

   III. Any number of balls, of any masses and contact distances: the momentum that is exchanged in all
   their collisions is bounded, so that velocities converge; the angular momentum is kept, and bounded.
   II. Of three balls of equal masses, one collides with the other two in turn: how often it can do so, by a
   sequence of comparison; and on a line it does so as often. *)
From Coq Require Import Reals List Arith.
From Verify Require Import Theorem1 Classification Line.
Open Scope R_scope.

(* --- any number of balls ---------------------------------------------------------------------- *)

Section AnyNumber.
Variable d : nat.
Variable last : nat.  (* the balls are 0, ..., last *)
Variable mass : nat -> R.
Variable sigma : nat -> nat -> R.  (* the distance at which two balls touch *)
Definition between (x : nat -> vector) (a b : nat) : vector := fun k => x b k - x a k.
Definition opening (x v : nat -> vector) (a b : nat) : R := dot d (between x a b) (between v a b).
Definition flown (t : R) (x v : nat -> vector) : nat -> vector := fun b k => x b k + t * v b k.
(* Places x and velocities v number n are those just after the n-th collision; the next one, after a flight
   of time t n, is that of balls i n and j n, which touch and approach. They exchange the momentum J n along
   the line of their centres, and part, or stay, at most as fast as they came. *)
Definition many_collide (x v : nat -> nat -> vector) (t : nat -> R) (i j : nat -> nat) (J : nat -> R) : Prop :=
  forall n, let e := between (x (S n)) (i n) (j n) in let s := sigma (i n) (j n) in
    ((i n <= last)%nat /\ (j n <= last)%nat /\ i n <> j n) /\
    0 <= t n /\ x (S n) = flown (t n) (x n) (v n) /\
    dot d e e = s * s /\ 0 <= J n /\
    (forall k, v (S n) (i n) k = v n (i n) k - J n / mass (i n) * (e k / s)) /\
    (forall k, v (S n) (j n) k = v n (j n) k + J n / mass (j n) * (e k / s)) /\
    (forall b, b <> i n -> b <> j n -> v (S n) b = v n b) /\
    opening (x (S n)) (v n) (i n) (j n) < 0 /\
    0 <= opening (x (S n)) (v (S n)) (i n) (j n) <= - opening (x (S n)) (v n) (i n) (j n).
(* Sums over the balls, with their masses: of places or velocities; of inner products; of moments. *)
Definition weighted (x : nat -> vector) (k : nat) : R := sum_f_R0 (fun b => mass b * x b k) last.
Definition product (x v : nat -> vector) : R := sum_f_R0 (fun b => mass b * dot d (x b) (v b)) last.
Definition turning (x v : nat -> vector) (k l : nat) : R :=
  sum_f_R0 (fun b => mass b * (x b k * v b l - x b l * v b k)) last.
(* In the frame of the centre of mass. *)
Definition centred (x : nat -> vector) : nat -> vector := fun b k => x b k - weighted x k / sum_f_R0 mass last.
(* The inner product of two planes: each pair of coordinates counts once. *)
Definition pairs (p q : nat -> nat -> R) : R := / 2 * dot d (fun k => dot d (p k) (q k)) (fun _ => 1).
End AnyNumber.

Definition exchange_theorem : Prop :=
  forall d last mass sigma x v t i j J, (forall b, 0 < mass b) -> (forall a b, 0 < sigma a b) ->
  many_collide d last mass sigma x v t i j J ->
  let x_0 := centred last mass (x 0%nat) in let v_0 := centred last mass (v 0%nat) in
  (forall n, sum_f_R0 (fun m => sigma (i m) (j m) * J m) n <=
    sqrt (product d last mass x_0 x_0) * sqrt (product d last mass v_0 v_0) - product d last mass x_0 v_0) /\
  (exists bound, forall n, sum_f_R0 J n <= bound) /\
  (exists bound, forall n,
    sum_f_R0 (fun m => - opening d (x (S m)) (v m) (i m) (j m) / sigma (i m) (j m)) n <= bound) /\
  (forall b k, (k < d)%nat -> exists l, Un_cv (fun n => v n b k) l) /\
  (forall n k l, turning last mass (centred last mass (x n)) (centred last mass (v n)) k l =
    turning last mass x_0 v_0 k l) /\
  pairs d (turning last mass x_0 v_0) (turning last mass x_0 v_0) <=
    product d last mass x_0 x_0 * product d last mass v_0 v_0.

(* --- runs of collisions in turn ---------------------------------------------------------------- *)

(* Ball o collides k times, with c and a in turn; scene n is the one after n collisions. *)
Definition run (d : nat) (m : R) (radius : ball -> R) (r : R) (k : nat) (scenes : nat -> scene)
    (time : nat -> R) (o a c : ball) : Prop :=
  forall n, (n < k)%nat -> let b := if Nat.even n then c else a in let t := time (S n) - time n in
    strike d (fun _ => m) radius (scenes n) t o b (scenes (S n)) /\
    rate d (scenes (S n)) o b = - r * rate d (later t (scenes n)) o b.
(* The sequence of comparison. *)
Fixpoint comparison (a r : R) (n : nat) : R * R :=  (* with the next number *)
  match n with O => (0, 1) | S n => let (p, q) := comparison a r n in (q, a * q - r * p) end.
Definition s (a r : R) (n : nat) : R := fst (comparison a r n).

Definition run_theorem : Prop :=
  forall d m radius r k scenes time o a c most, 0 < m -> (forall b, 0 < radius b) -> 0 < r <= 1 ->
  distinct_balls o a c -> run d m radius r k scenes time o a c ->
  (forall n, (2 <= n < k)%nat -> (1 + r) / 2 * minus_cosine_at d (scenes n) o a c <= most) ->
  forall n, (1 <= n < k)%nat -> 0 < s most r n.
(* On a line there are as many, and no others meanwhile. *)
Definition run_on_a_line : Prop :=
  forall d m radius r k o a c, (1 <= d)%nat -> 0 < m -> (forall b, 0 < radius b) -> 0 < r <= 1 ->
  distinct_balls o a c -> (forall n, (1 <= n < k)%nat -> 0 < s ((1 + r) / 2) r n) ->
  exists scenes time, forall n, (n < k)%nat ->
    let b := if Nat.even n then c else a in let t := time (S n) - time n in
    meets_next d radius (scenes n) o b t /\ parts d (fun _ => m) r o b (later t (scenes n)) (scenes (S n)) /\
    minus_cosine_at d (scenes n) o a c = 1.
(* For small r there is no bound. *)
Definition run_without_end : Prop :=
  forall r, 0 < r <= 7 - 4 * sqrt 3 -> forall n, (1 <= n)%nat -> 0 < s ((1 + r) / 2) r n.
