(* Three balls on a line: what is proved of them. This page can be read after Theorem1.v and
   Classification.v; it proves nothing.

   Ball o is between a and c on a line in R^d; it has just met a, and c approaches. If a is left behind
   slowly enough, then o meets c and a in turn without end, in a finite time, which has a bound; nobody
   meets otherwise; and if r < 1, both touch o at the end, at opposite sides. Masses and radii are any. *)
From Coq Require Import Reals Arith.
From Verify Require Import Theorem1 Classification.
Open Scope R_scope.

Section OnALine.
Variable d : nat.
Variables mass radius : ball -> R.
Variable r : R.

(* In free flight from s, balls i and j are the first to touch, after the time t, and only they. *)
Definition meets_next (s : scene) (i j : ball) (t : R) : Prop :=
  0 < t /\
  (forall u a b, 0 < u < t -> a <> b -> radius a + radius b < distance d (later u s) a b) /\
  distance d (later t s) i j = radius i + radius j /\ rate d (later t s) i j < 0 /\
  (forall k, k <> i -> k <> j -> radius i + radius k < distance d (later t s) i k /\
    radius j + radius k < distance d (later t s) j k).
(* Balls i and j exchange momentum along the line of their centres, and part at r times the speed. *)
Definition parts (i j : ball) (s s' : scene) : Prop :=
  exists J, 0 <= J /\ position s' = position s /\
    (forall b k, velocity s' b k =
      if same b i then velocity s b k - J / mass i * to s i j k
      else if same b j then velocity s b k + J / mass j * to s i j k
      else velocity s b k) /\
    rate d s' i j = - r * rate d s i j.
(* Scene n is the one just after the n-th collision; o meets c first, then a, then c again. *)
Definition meets_in_turn (scenes : nat -> scene) (time : nat -> R) (o a c : ball) : Prop :=
  forall n, let b := if Nat.even n then c else a in let t := time (S n) - time n in
    meets_next (scenes n) o b t /\ parts o b (later t (scenes n)) (scenes (S n)).

(* The line has the direction of e. Ball a touches o, and is left behind at the speed away; c is at the
   distance gap from contact with o, on the other side, and approaches at the speed closing. *)
Definition on_a_line (e : vector) (s : scene) (o a c : ball) (away gap closing : R) : Prop :=
  dot d e e = 1 /\ forall k, (k < d)%nat ->
    to s o a k = - (radius o + radius a) * e k /\ relative s o a k = - away * e k /\
    to s o c k = (radius o + radius c + gap) * e k /\ relative s o c k = - closing * e k.
(* The share of the closing speed that ball o takes over in a collision with b. *)
Definition share (o b : ball) : R := (1 + r) * mass b / (mass o + mass b).
End OnALine.

Definition line_theorem : Prop :=
  forall d mass radius r s o a c e away gap closing Q,
  (forall b, 0 < mass b) -> (forall b, 0 < radius b) -> 0 < r -> distinct_balls o a c ->
  on_a_line d radius e s o a c away gap closing -> 0 < away -> 0 < gap -> 0 < closing ->
  away <= Q * share mass r o c * closing -> 2 * Q < 1 ->
  r <= share mass r o c * share mass r o a * Q * (1 - Q) ->
  exists scenes time T, scenes O = s /\ time O = 0 /\
    meets_in_turn d mass radius r scenes time o a c /\
    Un_cv time T /\ T <= (1 - Q) / (1 - 2 * Q) * (gap / closing) /\
    (forall n, minus_cosine_at d (scenes n) o a c = 1) /\
    (r < 1 -> exists at_T, settles d scenes at_T /\
      distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
      minus_cosine_at d at_T o a c = 1).

(* For equal balls with the names of Theorem1.v, this is the collapse there; no other trajectory starts
   from s, and none lasts longer. *)
Definition equal_on_a_line : Prop :=
  forall d r s e away gap closing Q, 0 < r < 1 ->
  on_a_line d (fun _ => 1 / 2) e s B0 B1 B2 away gap closing -> 0 < away -> 0 < gap -> 0 < closing ->
  away <= Q * ((1 + r) / 2) * closing -> 2 * Q < 1 -> r <= ((1 + r) / 2) ^ 2 * Q * (1 - Q) ->
  collapse d r s ((1 - Q) / (1 - 2 * Q) * (gap / closing)) 1 0.
