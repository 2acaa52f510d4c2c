(* The spectrum of the matrix of Section 5: what is proved. This page can be read after Theorem1.v; it
   proves nothing.

   Three balls touch one another, and the pairs 0-1, 0-2 and 1-2 collide, one after the other, at these
   places. What that does to the relative velocities is a linear map. In the plane of the triangle it has
   the printed matrix, and beyond it changes nothing. *)
From Coq Require Import Reals.
From Verify Require Import Theorem1.
Open Scope R_scope.

(* --- the three collisions in R^d ---------------------------------------------------------------- *)

Definition triangle (d : nat) (s : scene) : Prop :=
  distance d s B0 B1 = 1 /\ distance d s B0 B2 = 1 /\ distance d s B1 B2 = 1.
Definition triple (d : nat) (r : R) (s : scene) : scene :=
  collided d r B1 B2 (collided d r B0 B2 (collided d r B0 B1 s)).
(* omega_1 and omega_2 are the directions from ball 0 to 1 and 2; these are the unit vectors in their
   plane that are orthogonal to them, the first one with omega_2 at an acute angle, the second one with
   omega_1 at an obtuse one. *)
Definition perp_1 (s : scene) : vector := fun k => (2 * to s B0 B2 k - to s B0 B1 k) / sqrt 3.
Definition perp_2 (s : scene) : vector := fun k => (to s B0 B2 k - 2 * to s B0 B1 k) / sqrt 3.
Record column := Column { c_1 : R; c_2 : R; c_3 : R; c_4 : R }.
(* The relative velocities of 1 and 2, seen from 0, in the basis of the paper, with remainders e and f
   that are orthogonal to the triangle. The second of the orthogonal vectors is the one above if the
   sign is 1, and its opposite, as the text states it, if the sign is -1. *)
Definition outside_plane (d : nat) (s : scene) (e : vector) : Prop :=
  dot d e (to s B0 B1) = 0 /\ dot d e (to s B0 B2) = 0.
Definition coordinates (d : nat) (sign : R) (s : scene) (u : column) (e f : vector) : Prop :=
  outside_plane d s e /\ outside_plane d s f /\ forall k,
  relative s B0 B1 k = c_1 u * to s B0 B1 k + c_2 u * perp_1 s k + e k /\
  relative s B0 B2 k = c_3 u * to s B0 B2 k + c_4 u * (sign * perp_2 s k) + f k.

(* --- the printed matrix ------------------------------------------------------------------------- *)

Section Matrix.
Variable r : R.
Definition image (u : column) : column := Column
  ((- r ^ 3 + 5 * r ^ 2 - 59 * r - 1) / 64 * c_1 u + sqrt 3 * (r + 1) / 8 * c_2 u +
    (r ^ 2 - 4 * r - 5) / 16 * c_3 u + - (sqrt 3 * (r + 1) / 8) * c_4 u)
  (sqrt 3 * (r ^ 3 + 3 * r ^ 2 + 11 * r + 9) / 64 * c_1 u + (5 - 3 * r) / 8 * c_2 u +
    - (sqrt 3 * (r ^ 2 + 4 * r + 3) / 16) * c_3 u + (3 * r + 3) / 8 * c_4 u)
  ((- r ^ 3 + 17 * r ^ 2 + 13 * r - 5) / 64 * c_1 u + sqrt 3 * (r + 1) / 8 * c_2 u +
    (r ^ 2 - 16 * r - 1) / 16 * c_3 u + - (sqrt 3 * (r + 1) / 8) * c_4 u)
  (sqrt 3 * (- r ^ 3 + r ^ 2 + 13 * r + 11) / 64 * c_1 u + (3 * r + 3) / 8 * c_2 u +
    sqrt 3 * (r ^ 2 - 1) / 16 * c_3 u + (5 - 3 * r) / 8 * c_4 u).
Definition Q (l : R) : R := l ^ 3 + (r ^ 3 - 9 * r ^ 2 + 171 * r - 11) / 64 * l ^ 2 +
  (- 11 * r ^ 3 + 171 * r ^ 2 - 9 * r + 1) / 64 * l + r ^ 3.
End Matrix.
(* The determinant of a matrix, whose columns these are. *)
Definition det2 (a b c d : R) : R := a * d - b * c.
Definition det3 (f : column -> R) (g : column -> R) (h : column -> R) (u v w : column) : R :=
  f u * det2 (g v) (g w) (h v) (h w) - f v * det2 (g u) (g w) (h u) (h w) + f w * det2 (g u) (g v) (h u) (h v).
Definition det4 (u v w x : column) : R :=
  c_1 u * det3 c_2 c_3 c_4 v w x - c_1 v * det3 c_2 c_3 c_4 u w x +
  c_1 w * det3 c_2 c_3 c_4 u v x - c_1 x * det3 c_2 c_3 c_4 u v w.
Definition combination (a : R) (u : column) (b : R) (v : column) : column := Column
  (a * c_1 u + b * c_1 v) (a * c_2 u + b * c_2 v) (a * c_3 u + b * c_3 v) (a * c_4 u + b * c_4 v).
Definition unit_1 := Column 1 0 0 0.
Definition unit_2 := Column 0 1 0 0.
Definition unit_3 := Column 0 0 1 0.
Definition unit_4 := Column 0 0 0 1.
Definition zero := Column 0 0 0 0.
(* u + i v is an eigenvector of the complex matrix for mu + i nu. *)
Definition eigenvector (r mu nu : R) (u v : column) : Prop :=
  ~ (u = zero /\ v = zero) /\
  image r u = combination mu u (- nu) v /\ image r v = combination nu u mu v.

(* --- the theorems ------------------------------------------------------------------------------- *)

Definition basis_theorem : Prop := forall d s, triangle d s ->
  let omega_1 := to s B0 B1 in let omega_2 := to s B0 B2 in
  dot d omega_1 omega_2 = 1 / 2 /\
  dot d (perp_1 s) (perp_1 s) = 1 /\ dot d (perp_1 s) omega_1 = 0 /\ 0 < dot d (perp_1 s) omega_2 /\
  dot d (perp_2 s) (perp_2 s) = 1 /\ dot d (perp_2 s) omega_2 = 0 /\ dot d (perp_2 s) omega_1 < 0 /\
  exists u e f, coordinates d 1 s u e f.
(* The matrix is the printed one, in this basis; what is orthogonal to the triangle stays as it is. *)
Definition matrix_theorem : Prop := forall d r s u e f, triangle d s ->
  coordinates d 1 s u e f -> coordinates d 1 (triple d r s) (image r u) e f.
(* In the basis as the text states it, it is not the printed one. *)
Definition stated_theorem : Prop := forall d r s, 0 < r < 1 -> triangle d s ->
  exists s' u e f, position s' = position s /\ coordinates d (-1) s' u e f /\
    ~ coordinates d (-1) (triple d r s') (image r u) e f.
Definition characteristic_theorem : Prop := forall r l,
  det4 (combination l unit_1 (-1) (image r unit_1)) (combination l unit_2 (-1) (image r unit_2))
    (combination l unit_3 (-1) (image r unit_3)) (combination l unit_4 (-1) (image r unit_4)) =
  (l - 1) * Q r l.
(* One real root l_0, and two that are not real, re + i im and re - i im; with 1 they are the
   eigenvalues, each of geometric multiplicity 1. The eigenvectors for 1 are the multiples of (0,1,0,1). *)
Definition spectrum_theorem : Prop := forall r, 0 < r < 1 -> exists l_0 re im,
  -1 < - r < l_0 /\ l_0 < - r ^ 3 < 0 /\ 0 < im /\ 0 < l_0 ^ 2 < re ^ 2 + im ^ 2 /\ re ^ 2 + im ^ 2 < 1 /\
  (forall l, Q r l = 0 <-> l = l_0) /\
  (forall l, Q r l = (l - l_0) * ((l - re) ^ 2 + im ^ 2)) /\
  (forall mu nu, (exists u v, eigenvector r mu nu u v) <->
    mu = 1 /\ nu = 0 \/ mu = l_0 /\ nu = 0 \/ mu = re /\ nu = im \/ mu = re /\ nu = - im) /\
  (forall mu nu u v u' v', eigenvector r mu nu u v -> eigenvector r mu nu u' v' ->
    exists a b, u' = combination a u (- b) v /\ v' = combination b u a v) /\
  (forall u, image r u = u <-> exists y, u = Column 0 y 0 y).
(* An eigenvector for mu^3; one of them is that for l_0. *)
Definition eigenvector_of (r mu : R) : column :=
  let h := (1 + r) / 4 in
  let sum := (mu + h - 1) / sqrt 3 in
  let difference := 2 / sqrt 3 * (mu ^ 2 - (1 - h) / 2 - (1 / 2 - h) * mu) in
  Column 1 ((sum - difference) / 2) (mu + h) ((sum + difference) / 2).
Definition eigenvector_theorem : Prop := forall r mu,
  mu ^ 3 + (1 + r) / 4 * mu ^ 2 + (1 + r) / 4 * mu + r = 0 ->
  image r (eigenvector_of r mu) = combination (mu ^ 3) (eigenvector_of r mu) 0 zero.
(* The parameter m of the certificate, with l_0 = - m^3. *)
Definition r_of (m : R) : R := m * (4 * m ^ 2 - m + 1) / (m ^ 2 - m + 4).
Definition parameter_theorem : Prop := forall r, 0 < r < 1 ->
  exists m, 0 < m < 1 /\ r_of m = r /\ Q r (- m ^ 3) = 0 /\
    forall n, 0 < n < 1 -> r_of n = r -> n = m.
(* Orbits converge exponentially to multiples of (0,1,0,1). *)
Fixpoint orbit (r : R) (u : column) (n : nat) : column :=
  match n with O => u | S k => image r (orbit r u k) end.
Definition close_to (e : R) (u v : column) : Prop :=
  Rabs (c_1 u - c_1 v) <= e /\ Rabs (c_2 u - c_2 v) <= e /\ Rabs (c_3 u - c_3 v) <= e /\ Rabs (c_4 u - c_4 v) <= e.
Definition orbit_theorem : Prop := forall r, 0 < r < 1 -> exists q, 0 < q < 1 /\
  forall u, exists y K, forall n, close_to (K * q ^ n) (orbit r u n) (Column 0 y 0 y).
(* If the three collisions take place, then 0-1 recedes: there is no second triple. The normal
   components are those before 0-1, before 0-2 and before 1-2. *)
Definition one_triple_theorem : Prop := forall d r s, 0 < r < 1 -> triangle d s ->
  rate d s B0 B1 < 0 -> rate d (collided d r B0 B1 s) B0 B2 < 0 ->
  rate d (collided d r B0 B2 (collided d r B0 B1 s)) B1 B2 < 0 -> 0 < rate d (triple d r s) B0 B1.
