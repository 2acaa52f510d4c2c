(* What Coq proves of the proof that almost every start of three balls has finitely many collisions, or a
   collapse in the Zhou-Kadanoff regime (certificates/alexander): the algebra and the inductions. Limit
   points and measure are not there. This page can be read alone; AlexanderProof.v has the proofs. *)
From Coq Require Import Reals.
Open Scope R_scope.

Definition vector : Set := nat -> R.
Fixpoint dot (d : nat) (u v : vector) : R :=
  match d with O => 0 | S k => dot k u v + u k * v k end.

(* --- one collision, across the collapse ----------------------------------------------------------------- *)

(* Ball 0 has just met s and meets c next. Lengths and speeds of a pair are divided by its distance of
   contact. n_s, n_c are the directions of s and c, V_s, V_c their relative velocities; c approaches at
   the speed y, s recedes at q y, and c is farther than contact by kappa y^2. A and B are the squares of
   V_c and V_s. Then 0 meets c after the time y T, at the speed y (1 + kappa y^2) S; here are S and T. *)
Definition S_ (A kappa y : R) : R :=
  let gap := kappa * y ^ 2 in sqrt (1 - A * kappa * (2 + gap) / (1 + gap) ^ 2).
Definition T_ (A kappa y : R) : R :=
  let gap := kappa * y ^ 2 in kappa * (2 + gap) / ((1 + gap) * (1 + S_ A kappa y)).

(* In the collision c recedes at e times the speed, and s gets the share beta of it. The next state has
   y' = p y, q', kappa', the directions x_c of c and m_s of s, and the velocities W_c and W_s. The laws
   and all changes are without a division by y, A or B. *)
Definition collision_theorem : Prop :=
  forall d e beta kappa y q (n_s n_c V_s V_c : vector),
  let A := dot d V_c V_c in let B := dot d V_s V_s in let gap := kappa * y ^ 2 in
  let S := S_ A kappa y in let T := T_ A kappa y in let U := y * (1 + gap) * S in
  let x_c := fun i => (1 + gap) * n_c i + y * T * V_c i in
  let x_s := fun i => n_s i + y * T * V_s i in let E := sqrt (dot d x_s x_s) in
  let m_s := fun i => x_s i / E in
  let W_c := fun i => V_c i + (1 + e) * U * x_c i in let W_s := fun i => V_s i + beta * U * x_c i in
  let p := - dot d m_s W_s / y in
  let q' := dot d x_c W_c / (p * y) in let kappa' := (E - 1) / (p * y) ^ 2 in
  0 < e -> 0 < beta -> 0 < kappa -> 0 < y -> 0 < q -> dot d n_s n_s = 1 -> dot d n_c n_c = 1 ->
  dot d n_s V_s = q * y -> dot d n_c V_c = - y -> 0 < S -> 0 < p ->
  (dot d x_c x_c = 1 /\ dot d x_c V_c = - U) /\
  (E ^ 2 = 1 + y ^ 2 * (T * (2 * q + B * T)) /\ p = beta * (1 + gap) * - dot d x_c m_s * S - (q + B * T) / E /\
   q' = e * (1 + gap) * S / p /\ kappa' = T * (2 * q + B * T) / ((1 + E) * p ^ 2)) /\
  forall i, x_c i = n_c i + y * (kappa * y * n_c i + T * V_c i) /\ E * m_s i = n_s i + y * (T * V_s i) /\
    W_c i - e * U * x_c i = V_c i + y * n_c i + y * ((1 + gap) * S * x_c i - n_c i) /\
    W_s i + p * y * m_s i =
      V_s i - q * y * n_s i + y * (beta * (1 + gap) * S * x_c i + p * m_s i + q * n_s i).

(* --- the order, also where a speed vanishes ------------------------------------------------------------- *)

(* The same with y = 0 is the limit map of (q, kappa); alpha is beta times minus the cosine. *)
Section LimitMap.
Variables alpha e A B : R.
Definition p_ (q kappa : R) : R := alpha * S_ A kappa 0 - q - B * T_ A kappa 0.
Definition next_q (q kappa : R) : R := e * S_ A kappa 0 / p_ q kappa.
Definition next_kappa (q kappa : R) : R :=
  T_ A kappa 0 * (2 * q + B * T_ A kappa 0) / (2 * p_ q kappa ^ 2).
(* A state below another one, which has an image. A or B may be 0. *)
Definition below (q kappa Q K : R) : Prop :=
  0 < alpha /\ 0 < e /\ 0 <= A /\ 0 <= B /\ 0 < q <= Q /\ 0 < kappa <= K /\ 2 * A * K < 1 /\ 0 < p_ Q K.
End LimitMap.
Definition order_theorem : Prop :=
  forall alpha e A B q kappa Q K, below alpha e A B q kappa Q K ->
  let p := p_ alpha A B q kappa in let P := p_ alpha A B Q K in
  let q' := next_q alpha e A B q kappa in let Q' := next_q alpha e A B Q K in
  let kappa' := next_kappa alpha A B q kappa in let K' := next_kappa alpha A B Q K in
  0 < P <= p /\ (alpha * A + B) * (K - kappa) + (Q - q) <= p - P /\ 0 < q' <= Q' /\ 0 < kappa' <= K' /\
  kappa' / K' <= kappa / K * (P / p) ^ 2 /\ e * (q * A + B) * (K - kappa) / (p * P) <= Q' - q'.

(* --- what the order does to two orbits ------------------------------------------------------------------ *)

(* On one base point (the same directions and tangential velocities, of which alpha, A and B are made) the
   quotient of the two kappa grows, if m, l and M bound what stays between positive bounds. *)
Definition growth_theorem : Prop :=
  forall alpha e A B q kappa Q K m l M c, below alpha e A B q kappa Q K -> kappa < K ->
  0 < m <= alpha * A + B -> l <= kappa -> p_ alpha A B Q K <= M -> 0 < c -> c * M <= 2 * (m * l) -> c * M <= 2 ->
  let x := K / kappa - 1 in
  1 + x + c * (x + (Q - q)) <= next_kappa alpha A B Q K / next_kappa alpha A B q kappa.
(* Below an orbit on which kappa is at least c, the quotient falls by a factor. *)
Definition beneath_theorem : Prop :=
  forall alpha e A B q kappa Q K m c L, below alpha e A B q kappa Q K ->
  0 < m <= alpha * A + B -> 0 < c <= K -> kappa / K <= L < 1 ->
  next_kappa alpha A B q kappa / next_kappa alpha A B Q K <= (1 - m * (1 - L) * c / alpha) * (kappa / K).
(* Two orbits of the full motion over one base point: x is the quotient of the two kappa, less 1, D the
   difference of the two q, Y that of the two log y, H the distance of what is else. They differ from
   the limit map by a share of g, which bounds y, and of H. Then they move apart without bound. *)
Definition two_orbits_theorem : Prop :=
  forall c K g (x D Y H : nat -> R), 0 < c <= 1 -> 1 <= K -> 0 <= g -> 80 * K ^ 3 * g <= c ^ 3 ->
  0 < x O -> D O = 0 -> Y O = 0 -> H O = 0 ->
  (forall n, let off := H n + g * Y n + g * (x n + D n) in
    x n + c * (x n + D n) - K * off <= x (S n) /\ c * x n - K * off <= D (S n) /\
    D (S n) <= K * (x n + D n + H n + g * Y n) /\ Y (S n) <= Y n + K * (x n + D n + H n + g * Y n) /\
    0 <= H (S n) <= H n + K * g * (x n + D n + H n + Y n)) ->
  forall n, x O * (1 + c / 2) ^ n <= x n /\ 0 <= D n.

(* --- kappa falls, or stays away from 0 ------------------------------------------------------------------ *)

(* Where kappa is small, the limit map is q' = e / p with p = a - q, kappa is multiplied by q / p^2, and the
   pairs take turns: e and f, a and a'. Two collisions depend on z = p p' and on D = a a' alone. *)
Definition next_z (e f D z : R) : R := D - e - f - e * f / z.
Definition factor (e D z : R) : R := e * (D - e - z) / ((z + e) * z ^ 2).
Definition turn_theorem : Prop :=
  forall a a' e f q, let p := a - q in let q' := e / p in let p' := a' - q' in let q'' := f / p' in
  let p'' := a - q'' in let z := p * p' in 0 < e -> 0 < p -> 0 < p' -> 0 < p'' ->
  q / p ^ 2 * (q' / p' ^ 2) = factor e (a * a') z /\ p'' * (a' - e / p'') = next_z e f (a * a') z.
(* Above the threshold: if two collisions once do not increase kappa, then from there on it falls at least
   like a geometric sequence. *)
Definition trap_theorem : Prop :=
  forall e f t D h, 0 < e -> 0 < f -> 0 < t -> 0 < h -> t ^ 3 = e * f -> e + f + t + t ^ 2 < D ->
  factor e D h = 1 ->
  (t < h < next_z e f D h) /\
  exists rho, 0 <= rho < 1 /\ forall z kappa : nat -> R,
    0 < z O -> (forall n, 0 < kappa n /\ z (S n) = next_z e f D (z n) /\ kappa (S n) = factor e D (z n) * kappa n) ->
    kappa 1%nat <= kappa O -> forall n, h <= z n /\ kappa (S n) <= kappa 1%nat * rho ^ n.
(* At the threshold: what z is above t shrinks by the factor t, and kappa falls by no more than a multiple
   of that; *)
Definition threshold_theorem : Prop :=
  forall e f t z, 0 < e -> 0 < t -> 0 < z -> t ^ 3 = e * f -> let D := e + f + t + t ^ 2 in
  (t <= z -> next_z e f D z - t <= t * (z - t) /\ 1 - (1 + 3 * t) / t ^ 2 * (z - t) <= factor e D z) /\
  (z <= t -> next_z e f D z <= t /\ 1 <= factor e D z).
(* so it stays above a positive number, with errors eps that decay, too. *)
Definition stays_theorem : Prop :=
  forall t m L (kappa x eps : nat -> R), t < 1 -> m < 1 -> 0 < L ->
  (forall n, 0 < kappa n /\ 0 <= x n /\ 0 <= eps n /\ x (S n) <= t * x n + eps n /\ eps (S n) <= m * eps n /\
    kappa n * (1 - L * x n - eps n) <= kappa (S n)) ->
  let W := (L * x O + (1 - t + L) / (1 - m) * eps O) / (1 - t) in
  W < 1 -> forall n, kappa O * (1 - W) <= kappa n.
