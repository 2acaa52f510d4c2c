(* The spectrum of the matrix of Section 5, spelled out once more, with the words of Pinned.v. A reader
   compares it with the paper; and if Spectrum.v comes to say anything else, the proofs at the end fail.
   Nothing is taken from there but the name of a column of four numbers. *)
From Verify Require Import Pinned.
From Verify Require Theorem1 Spectrum SpectrumProof.
From Coq Require Import Reals.
Open Scope R_scope.
Definition B1 : ball := Pinned.B1.  (* Coq has another one *)

Definition column := Spectrum.column.
Definition Column (a b c d : R) : column := Spectrum.Column a b c d.
Definition c_1 (u : column) : R := Spectrum.c_1 u.
Definition c_2 (u : column) : R := Spectrum.c_2 u.
Definition c_3 (u : column) : R := Spectrum.c_3 u.
Definition c_4 (u : column) : R := Spectrum.c_4 u.
Check (fun a b c d => eq_refl : (c_1 (Column a b c d), c_2 (Column a b c d), c_3 (Column a b c d),
  c_4 (Column a b c d)) = (a, b, c, d)).

(* --- three balls that touch one another, in R^d -------------------------------------------------- *)

Definition triangle d x : Prop := distance d x B0 B1 = 1 /\ distance d x B0 B2 = 1 /\ distance d x B1 B2 = 1.
(* The collisions 0-1, 0-2 and 1-2, one after the other, at these places, from v to w. *)
Definition triple d r x v w : Prop := exists v_1 v_2,
  collide d r x v B0 B1 v_1 /\ collide d r x v_1 B0 B2 v_2 /\ collide d r x v_2 B1 B2 w.
(* omega_1 and omega_2 are the directions from ball 0 to 1 and 2. *)
Definition omega_1 (x : ball -> nat -> R) : nat -> R := from_to x B0 B1.
Definition omega_2 (x : ball -> nat -> R) : nat -> R := from_to x B0 B2.
Definition perp_1 x : nat -> R := fun k => (2 * omega_2 x k - omega_1 x k) / sqrt 3.
Definition perp_2 x : nat -> R := fun k => (omega_2 x k - 2 * omega_1 x k) / sqrt 3.
(* The relative velocities of 1 and 2, seen from 0, in the basis of the paper; what is left, e and f, is
   orthogonal to the triangle. With the sign -1 the last vector of the basis is as the text states it. *)
Definition coordinates d (sign : R) x v (u : column) (e f : nat -> R) : Prop :=
  (dot d e (omega_1 x) = 0 /\ dot d e (omega_2 x) = 0) /\
  (dot d f (omega_1 x) = 0 /\ dot d f (omega_2 x) = 0) /\ forall k,
  from_to v B0 B1 k = c_1 u * omega_1 x k + c_2 u * perp_1 x k + e k /\
  from_to v B0 B2 k = c_3 u * omega_2 x k + c_4 u * (sign * perp_2 x k) + f k.

(* --- the printed matrix and the polynomial ------------------------------------------------------- *)

Section PinnedMatrix.
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
End PinnedMatrix.
(* The determinant, by the first row. *)
Definition det2 (a b c d : R) : R := a * d - b * c.
Definition det3 (f g h : column -> R) (u v w : column) : R := f u * det2 (g v) (g w) (h v) (h w) -
  f v * det2 (g u) (g w) (h u) (h w) + f w * det2 (g u) (g v) (h u) (h v).
Definition det4 (u v w x : column) : R :=
  c_1 u * det3 c_2 c_3 c_4 v w x - c_1 v * det3 c_2 c_3 c_4 u w x +
  c_1 w * det3 c_2 c_3 c_4 u v x - c_1 x * det3 c_2 c_3 c_4 u v w.
Definition combination (a : R) (u : column) (b : R) (v : column) : column := Column
  (a * c_1 u + b * c_1 v) (a * c_2 u + b * c_2 v) (a * c_3 u + b * c_3 v) (a * c_4 u + b * c_4 v).
Definition zero : column := Column 0 0 0 0.
(* A column of l I - A. *)
Definition shifted (r l : R) (u : column) : column := combination l u (-1) (image r u).
(* u + i v is an eigenvector of the complex matrix for mu + i nu. *)
Definition eigenvector (r mu nu : R) (u v : column) : Prop :=
  ~ (u = zero /\ v = zero) /\
  image r u = combination mu u (- nu) v /\ image r v = combination nu u mu v.
Fixpoint orbit (r : R) (u : column) (n : nat) : column :=
  match n with O => u | S k => image r (orbit r u k) end.
Definition close_to (e : R) (u v : column) : Prop :=
  Rabs (c_1 u - c_1 v) <= e /\ Rabs (c_2 u - c_2 v) <= e /\ Rabs (c_3 u - c_3 v) <= e /\ Rabs (c_4 u - c_4 v) <= e.

(* --- what is proved of them ---------------------------------------------------------------------- *)

Definition basis_theorem : Prop := forall d x, triangle d x ->
  dot d (omega_1 x) (omega_2 x) = 1 / 2 /\
  dot d (perp_1 x) (perp_1 x) = 1 /\ dot d (perp_1 x) (omega_1 x) = 0 /\ 0 < dot d (perp_1 x) (omega_2 x) /\
  dot d (perp_2 x) (perp_2 x) = 1 /\ dot d (perp_2 x) (omega_2 x) = 0 /\ dot d (perp_2 x) (omega_1 x) < 0 /\
  forall v, exists u e f, coordinates d 1 x v u e f.
(* In this basis the three collisions have the printed matrix, and leave e and f as they are. *)
Definition matrix_theorem : Prop := forall d r x v w u e f, triangle d x -> triple d r x v w ->
  coordinates d 1 x v u e f -> coordinates d 1 x w (image r u) e f.
(* In the basis as the text states it they do not. *)
Definition stated_theorem : Prop := forall d r x, 0 < r < 1 -> triangle d x ->
  exists v w u e f, triple d r x v w /\ coordinates d (-1) x v u e f /\
    ~ coordinates d (-1) x w (image r u) e f.
(* Where all three take place, 0-1 recedes afterwards. *)
Definition one_triple_theorem : Prop := forall d r x v v_1 v_2 w, 0 < r < 1 -> triangle d x ->
  collide d r x v B0 B1 v_1 -> collide d r x v_1 B0 B2 v_2 -> collide d r x v_2 B1 B2 w ->
  rate d x v B0 B1 < 0 -> rate d x v_1 B0 B2 < 0 -> rate d x v_2 B1 B2 < 0 -> 0 < rate d x w B0 B1.
Definition characteristic_theorem : Prop := forall r l,
  det4 (shifted r l (Column 1 0 0 0)) (shifted r l (Column 0 1 0 0)) (shifted r l (Column 0 0 1 0))
    (shifted r l (Column 0 0 0 1)) = (l - 1) * Q r l.
Definition spectrum_theorem : Prop := forall r, 0 < r < 1 -> exists l_0 re im,
  -1 < - r < l_0 /\ l_0 < - r ^ 3 < 0 /\ 0 < im /\ 0 < l_0 ^ 2 < re ^ 2 + im ^ 2 /\ re ^ 2 + im ^ 2 < 1 /\
  (forall l, Q r l = 0 <-> l = l_0) /\
  (forall l, Q r l = (l - l_0) * ((l - re) ^ 2 + im ^ 2)) /\
  (forall mu nu, (exists u v, eigenvector r mu nu u v) <->
    mu = 1 /\ nu = 0 \/ mu = l_0 /\ nu = 0 \/ mu = re /\ nu = im \/ mu = re /\ nu = - im) /\
  (forall mu nu u v u' v', eigenvector r mu nu u v -> eigenvector r mu nu u' v' ->
    exists a b, u' = combination a u (- b) v /\ v' = combination b u a v) /\
  (forall u, image r u = u <-> exists y, u = Column 0 y 0 y).
Definition eigenvector_of (r mu : R) : column :=
  let h := (1 + r) / 4 in
  let sum := (mu + h - 1) / sqrt 3 in
  let difference := 2 / sqrt 3 * (mu ^ 2 - (1 - h) / 2 - (1 / 2 - h) * mu) in
  Column 1 ((sum - difference) / 2) (mu + h) ((sum + difference) / 2).
Definition eigenvector_theorem : Prop := forall r mu,
  mu ^ 3 + (1 + r) / 4 * mu ^ 2 + (1 + r) / 4 * mu + r = 0 ->
  image r (eigenvector_of r mu) = combination (mu ^ 3) (eigenvector_of r mu) 0 zero.
Definition r_of (m : R) : R := m * (4 * m ^ 2 - m + 1) / (m ^ 2 - m + 4).
Definition parameter_theorem : Prop := forall r, 0 < r < 1 ->
  exists m, 0 < m < 1 /\ r_of m = r /\ Q r (- m ^ 3) = 0 /\
    forall n, 0 < n < 1 -> r_of n = r -> n = m.
Definition orbit_theorem : Prop := forall r, 0 < r < 1 -> exists q, 0 < q < 1 /\
  forall u, exists y K, forall n, close_to (K * q ^ n) (orbit r u n) (Column 0 y 0 y).

(* --- Spectrum.v says just this ------------------------------------------------------------------- *)

Check (eq_refl : Spectrum.characteristic_theorem = characteristic_theorem).
Check (eq_refl : Spectrum.spectrum_theorem = spectrum_theorem).
Check (eq_refl : Spectrum.eigenvector_theorem = eigenvector_theorem).
Check (eq_refl : Spectrum.parameter_theorem = parameter_theorem).
Check (eq_refl : Spectrum.orbit_theorem = orbit_theorem).
Lemma same_triple d r x v w :
  triple d r x v w <-> placed x w = Spectrum.triple d r (placed x v).
Proof.
  split.
  - intros (v_1 & v_2 & A & B & C). unfold Spectrum.triple.
    assert (A' : placed x v_1 = Theorem1.collided d r Theorem1.B0 Theorem1.B1 (placed x v)) by (apply same_collision; [discriminate | now split]).
    assert (B' : placed x v_2 = Theorem1.collided d r Theorem1.B0 Theorem1.B2 (placed x v_1)) by (apply same_collision; [discriminate | now split]).
    assert (C' : placed x w = Theorem1.collided d r Theorem1.B1 Theorem1.B2 (placed x v_2)) by (apply same_collision; [discriminate | now split]).
    now rewrite <- A', <- B'.
  - intros E. unfold Spectrum.triple in E. set (s_1 := Theorem1.collided d r Theorem1.B0 Theorem1.B1 (placed x v)) in *.
    set (s_2 := Theorem1.collided d r Theorem1.B0 Theorem1.B2 s_1) in *.
    exists (Theorem1.velocity s_1), (Theorem1.velocity s_2).
    assert (S1 : placed x (Theorem1.velocity s_1) = s_1) by reflexivity.
    assert (S2 : placed x (Theorem1.velocity s_2) = s_2) by reflexivity.
    split; [|split].
    + apply (same_collision d r x v B0 B1 x); [discriminate | exact S1].
    + apply (same_collision d r x (Theorem1.velocity s_1) B0 B2 x); [discriminate | now rewrite S1].
    + apply (same_collision d r x (Theorem1.velocity s_2) B1 B2 x); [discriminate | now rewrite S2].
Qed.
Theorem matrix_proved : basis_theorem /\ matrix_theorem /\ stated_theorem /\ one_triple_theorem.
Proof.
  destruct SpectrumProof.matrix_proved as (A & B & C & D). split; [|split; [|split]].
  - intros d x T. pose proof (A d (placed x (fun _ _ => 0)) T) as (A1 & A2 & A3 & A4 & A5 & A6 & A7 & _).
    repeat (split; [assumption|]). intros v. apply (A d (placed x v) T).
  - intros d r x v w u e f T W K. apply same_triple in W. pose proof (B d r (placed x v) u e f T K) as M.
    rewrite <- W in M. exact M.
  - intros d r x R T. destruct (C d r (placed x (fun _ _ => 0)) R T) as ([y v] & u & e & f & P & K & N).
    cbn in P. subst y.
    exists v, (Theorem1.velocity (Spectrum.triple d r (placed x v))), u, e, f. split; [now apply same_triple|].
    split; [exact K | exact N].
  - intros d r x v v_1 v_2 w R T C1 C2 C3 P Q O.
    assert (A' : placed x v_1 = Theorem1.collided d r Theorem1.B0 Theorem1.B1 (placed x v)) by (apply same_collision; [discriminate | now split]).
    assert (B' : placed x v_2 = Theorem1.collided d r Theorem1.B0 Theorem1.B2 (placed x v_1)) by (apply same_collision; [discriminate | now split]).
    assert (W : placed x w = Spectrum.triple d r (placed x v)) by (apply same_triple; now exists v_1, v_2).
    pose proof (D d r (placed x v) R T P) as K. rewrite <- A', <- B', <- W in K. exact (K Q O).
Qed.
Theorem spectrum_proved : characteristic_theorem /\ spectrum_theorem /\ eigenvector_theorem /\
  parameter_theorem /\ orbit_theorem.
Proof. exact SpectrumProof.spectrum_proved. Qed.
Theorem all_proved : (basis_theorem /\ matrix_theorem /\ stated_theorem /\ one_triple_theorem) /\
  (characteristic_theorem /\ spectrum_theorem /\ eigenvector_theorem /\ parameter_theorem /\ orbit_theorem).
Proof. exact (conj matrix_proved spectrum_proved). Qed.
Print Assumptions all_proved.
