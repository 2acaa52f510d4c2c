(* What the other certificates take on trust, with what Coq proves instead, as in Sentences.v: which
   collapses there are, balls on a line, three balls of any masses, the sign as printed, where
   collisions in turn end, and the spectrum. *)
From Verify Require Import Theorem1.
From Coq Require Import Reals List.
Import ListNotations.
From Verify Require Vectors Motion Runs Classification Contacts Settling Calculus Unbounded Turning
  ClassificationProof Bounds Impulse AlternatingRuns.
From Verify Require Finite FiniteScenes Deadline ManyBalls Line LineProof PrintedSign PrintedSignProof.
From Verify Require Meaning Balls AnyStep ThreeBalls ThreeBallsStep ThreeBallsMap ThreeBallsCollapse BallsFlowStep.
From Verify Require Ends Outside OutsideStep OutsideProof.
From Verify Require Inner SandwichStep Sandwich SandwichProof.
From Verify Require Spectrum SpectrumMatrix SpectrumRoots SpectrumEigen SpectrumOrbits SpectrumSentences.
Open Scope R_scope.
Definition B1 : ball := Theorem1.B1.

(* --- which collapses there are, and the sign as printed ------------------------------------------- *)

(* The propositions are spelled out in PinnedClassification.v and PinnedPrintedSign.v. *)
Check (ClassificationProof.no_triangle_holds : Classification.no_triangle).
Check (ClassificationProof.least_angle_holds : Classification.least_angle).
Check (ClassificationProof.least_angle_any_radii_holds : Classification.least_angle_any_radii).
Check (ClassificationProof.never_any_radii_holds : Classification.never_any_radii).
Check (ClassificationProof.comes_to_rest_holds : Classification.comes_to_rest).
(* These are spelled out in PinnedBounds.v. *)
Check (Impulse.exchange_theorem_holds : Bounds.exchange_theorem).
Check (AlternatingRuns.run_theorem_holds : Bounds.run_theorem).
Check (AlternatingRuns.run_on_a_line_holds : Bounds.run_on_a_line).
Check (AlternatingRuns.run_without_end_holds : Bounds.run_without_end).
Check (PrintedSignProof.printed_sign_theorem_holds : PrintedSign.printed_sign_theorem).
(* cauchy-schwarz for planes, and for three balls: the inner product of two planes is a sum over pairs of
   coordinates; the moment of inertia times the energy bounds the squares of A and of L. *)
Check (fun d x v y w => eq_refl : Calculus.wedge d x v y w = dot d x y * dot d v w - dot d x w * dot d v y).
Check (Calculus.wedge_by_coordinates : forall d x v y w,
  dot d (fun k => dot d (fun l => x k * v l - x l * v k) (fun l => y k * w l - y l * w k)) (fun _ => 1) =
  2 * Calculus.wedge d x v y w).
Check (Turning.spin_bounded : forall d s,
  Classification.growth d s * Classification.growth d s + Classification.spin2 d s <=
  Classification.size d s * (dot d (relative s B0 B1) (relative s B0 B1) +
    dot d (relative s B0 B2) (relative s B0 B2) + dot d (relative s B1 B2) (relative s B1 B2))).
(* finite-length: the places of three balls of any masses that collapse; and of those whose
   collisions do not accumulate. *)
Check (Settling.settles_in_time : forall d mass radius scenes time i j T, (forall b, 0 < mass b) ->
  Classification.strikes d mass radius scenes time i j -> Un_cv time T ->
  exists z, Classification.settles d scenes z).
Check (Unbounded.settles_late : forall d mass radius scenes time i j, (forall b, 0 < mass b) ->
  (forall b, 0 < radius b) -> Classification.strikes d mass radius scenes time i j ->
  ~ (exists T, Un_cv time T) -> exists z, Classification.settles d scenes z).

(* glue-lemma, for bodies of any number and masses: a state is just after a collision, some of which may be
   at the same time. *)
Check (fun body x v w i j d mass => eq_refl : ManyBalls.struck body d mass x v i j w =
  (i <> j /\ ManyBalls.opening body d x v i j < 0 /\
   0 <= ManyBalls.opening body d x w i j <= - ManyBalls.opening body d x v i j /\ exists J, 0 <= J /\
    (forall k, w i k = v i k - J / mass i * (x j k - x i k)) /\
    (forall k, w j k = v j k + J / mass j * (x j k - x i k)) /\
    (forall b, b <> i -> b <> j -> w b = v b))).
Check (fun body d x v a b => eq_refl : ManyBalls.opening body d x v a b =
  dot d (fun k => x b k - x a k) (fun k => v b k - v a k)).
Check (fun body d mass x v t i j => eq_refl : ManyBalls.history body d mass x v t i j =
  forall n, 0 <= t n /\ x (S n) = (fun b k => x n b k + t n * v n b k) /\
    ManyBalls.struck body d mass (x (S n)) (v n) (i n) (j n) (v (S n))).
Check (fun body d x i j a b n => eq_refl : ManyBalls.hit_from_behind body d x i j a b n =
  forall c, c <> a -> c <> b ->
    (i n = a /\ j n = c \/ i n = c /\ j n = a ->
      0 <= dot d (fun k => x (S n) b k - x (S n) a k) (fun k => x (S n) c k - x (S n) a k)) /\
    (i n = b /\ j n = c \/ i n = c /\ j n = b ->
      0 <= dot d (fun k => x (S n) a k - x (S n) b k) (fun k => x (S n) c k - x (S n) b k))).
Check (fun body d x a b => eq_refl : ManyBalls.apart2 body d x a b =
  dot d (fun k => x b k - x a k) (fun k => x b k - x a k)).
Check (fun body i j a b => eq_refl : ManyBalls.is_pair body i j a b = (i = a /\ j = b \/ i = b /\ j = a)).
Check (fun body t x v => eq_refl : ManyBalls.flown body t x v = fun b k => x b k + t * v b k).
Check (ManyBalls.apart_from_then_on : forall (body : Set) d mass, (forall b, 0 < mass b) ->
  (forall a b : body, {a = b} + {a <> b}) -> forall x v t i j a b m n,
  ManyBalls.history body d mass x v t i j -> ManyBalls.is_pair body (i m) (j m) a b -> (m < n)%nat ->
  (forall k, (m < k < n)%nat -> ManyBalls.hit_from_behind body d x i j a b k) ->
  (forall s, 0 <= s -> 0 <= ManyBalls.opening body d (ManyBalls.flown body s (x n) (v n)) (v n) a b) /\
  (forall s u, 0 <= s <= u -> ManyBalls.apart2 body d (ManyBalls.flown body s (x n) (v n)) a b <=
    ManyBalls.apart2 body d (ManyBalls.flown body u (x n) (v n)) a b) /\
  ~ ManyBalls.is_pair body (i n) (j n) a b).
Check (ManyBalls.one_in_between : forall (body : Set) d mass, (forall b, 0 < mass b) ->
  (forall a b : body, {a = b} + {a <> b}) -> forall x v t i j a b m n,
  ManyBalls.history body d mass x v t i j -> ManyBalls.is_pair body (i m) (j m) a b -> (m < n)%nat ->
  ManyBalls.is_pair body (i n) (j n) a b ->
  ~ forall k, (m < k < n)%nat -> forall c, c <> a -> c <> b ->
    ~ ManyBalls.is_pair body (i k) (j k) a c /\ ~ ManyBalls.is_pair body (i k) (j k) b c).
(* glue-scenes: (i) free flight; (ii) and (iii); (iv), where size is 3 R^2, growth is 3 A and spin2 9 L^2; (v). *)
Check (Runs.never_by_parting : forall d s i j, 1 <= Motion.square d s i j -> 0 <= rate d s i j ->
  Runs.never_meets d s i j).
Check (Runs.never_by_passing : forall d s i j, 0 < dot d (relative s i j) (relative s i j) ->
  rate d s i j ^ 2 < dot d (relative s i j) (relative s i j) * (Motion.square d s i j - 1) ->
  Runs.never_meets d s i j).
Check (Runs.never_any : forall d s o i c, i <> o /\ c <> o /\ i <> c -> Runs.never_meets d s o i ->
  Runs.never_meets d s o c -> Runs.never_meets d s i c ->
  forall t, 0 < t -> nobody_collides d (Theorem1.later t s)).
Check (FiniteScenes.finite_by_restitution : forall d r s, 0 < r <= 1 -> r ^ 2 - 14 * r + 1 < 0 ->
  Classification.finite d r s).
Check (FiniteScenes.finite_outward : forall d r s, 0 < r <= 1 ->
  0 <= Classification.growth d s -> 6 <= Classification.size d s -> Classification.finite d r s).
Check (fun d s => eq_refl : Deadline.least_motion d s =
  Classification.spin2 d s / Rmax (Classification.size d s) 6).
Check (Deadline.deadline : forall d r s scenes time i j T, 0 < r <= 1 -> 0 < Classification.spin2 d s ->
  Classification.endless d r s scenes time i j -> Un_cv time T -> let m := Deadline.least_motion d s in
  0 <= Classification.growth d s ^ 2 + (6 - Classification.size d s) * m /\
  T <= (sqrt (Classification.growth d s ^ 2 + (6 - Classification.size d s) * m) -
    Classification.growth d s) / m).
Check (Deadline.never_late : forall d r s, 0 < r <= 1 -> 0 < Classification.spin2 d s ->
  Classification.growth d s ^ 2 + (6 - Classification.size d s) * Deadline.least_motion d s < 0 ->
  Classification.finite d r s).
Check (ManyBalls.not_before : forall (body : Set) d mass, (forall b, 0 < mass b) ->
  (forall a b : body, {a = b} + {a <> b}) -> forall x v t i j a b n,
  ManyBalls.history body d mass x v t i j -> a <> b -> 0 <= ManyBalls.opening body d (x 0%nat) (v 0%nat) a b ->
  (forall k, (k < n)%nat -> ManyBalls.hit_from_behind body d x i j a b k) ->
  ~ ManyBalls.is_pair body (i n) (j n) a b).

(* --- balls on a line ---------------------------------------------------------------------------- *)

(* The proposition is spelled out in PinnedLine.v, and so is what it means to be on a line. *)
Check (fun d mass r i j s s' => eq_refl : Line.parts d mass r i j s s' =
  exists J, 0 <= J /\ position s' = position s /\
    (forall b k, velocity s' b k =
      if same b i then velocity s b k - J / mass i * to s i j k
      else if same b j then velocity s b k + J / mass j * to s i j k
      else velocity s b k) /\
    rate d s' i j = - r * rate d s i j).
Check (fun mass r o b => eq_refl : Line.share mass r o b = (1 + r) * mass b / (mass o + mass b)).
Check (LineProof.line_theorem_holds : Line.line_theorem).

(* --- three balls of any masses and radii --------------------------------------------------------- *)

(* The propositions are spelled out in PinnedThreeBalls.v, with the map of two numbers. *)
Check (fun d radius s i j t => eq_refl : Line.meets_next d radius s i j t =
  (0 < t /\
  (forall u a b, 0 < u < t -> a <> b -> radius a + radius b < distance d (Theorem1.later u s) a b) /\
  distance d (Theorem1.later t s) i j = radius i + radius j /\ rate d (Theorem1.later t s) i j < 0 /\
  (forall k, k <> i -> k <> j -> radius i + radius k < distance d (Theorem1.later t s) i k /\
    radius j + radius k < distance d (Theorem1.later t s) j k))).
Check (fun mass radius r o a c w G U_most C_0 Theta Q_0 U_0 => eq_refl :
  ThreeBalls.goes_on mass radius r o a c w G U_most C_0 Theta Q_0 U_0 =
  forall n, let b := if Nat.even n then c else a in let b' := if Nat.even n then a else c in
    let alpha := (1 + r b) * mass b / (mass o + mass b) * ((radius o + radius b) / (radius o + radius b')) *
      (C_0 - Theta) in
    let rho := G * (w b' / w b) ^ 2 in
    let p := ThreeBalls.orbit mass radius r o a c w G C_0 Theta Q_0 U_0 n in
    let P := alpha * (1 - snd p) - fst p - rho * snd p in
    0 < P /\ rho * snd p * (2 * fst p + rho * snd p) <= U_most * (2 - U_most) * P ^ 2).
(* glue-next: a scene in units of the distances of contact, and the values v of a state. *)
Check (fun d radius o m x i j => eq_refl : AnyStep.seen d radius o m x i j =
  exists p q s c, to x o i = (fun k => (radius o + radius i) * p k) /\
    relative x o i = (fun k => (radius o + radius i) * s k) /\
    to x o j = (fun k => (radius o + radius j) * (1 + AnyStep.d m) * q k) /\
    relative x o j = (fun k => (radius o + radius j) * c k) /\ AnyStep.products m d p q s c).
Check (ThreeBallsStep.balls_step : forall v,
  Meaning.scope Balls.the_statement ThreeBallsStep.state_context v -> forall radius o i j,
  v Balls.number_of_sigma_s = radius o + radius i -> v Balls.number_of_sigma_c = radius o + radius j ->
  v Balls.number_of_sigma_12 = radius i + radius j ->
  AnyStep.certified_if (ThreeBallsStep.numbers_of v) (ThreeBallsStep.flight v)
    (AnyStep.outer_of_balls radius o i j (ThreeBallsStep.numbers_of v))).
Check (AnyStep.balls_meet : forall d radius, (forall b, 0 < radius b) -> forall o i j,
  Classification.distinct_balls o i j -> forall m t,
  AnyStep.certified_if m t (AnyStep.outer_of_balls radius o i j m) ->
  forall x, AnyStep.seen d radius o m x i j -> Line.meets_next d radius x o j t).
Check (AnyStep.balls_after : forall d mass radius r, (forall b, 0 < mass b) ->
  (forall b, 0 < radius b) -> forall o i j, Classification.distinct_balls o i j -> forall m t,
  AnyStep.certified_if m t (AnyStep.outer_of_balls radius o i j m) ->
  forall x, AnyStep.seen d radius o m x i j ->
  AnyStep.seen d radius o (AnyStep.after_sharing
    ((1 + r) * mass j / (mass o + mass j) * ((radius o + radius j) / (radius o + radius i))) r m t)
    (Bounces.bounced d mass r o j (Theorem1.later t x)) j i).
Check (Bounces.bounced_parts : forall d mass r, (forall b, 0 < mass b) -> 0 < r ->
  forall i j z, i <> j -> 0 < distance d z i j -> rate d z i j < 0 ->
  Line.parts d mass r i j z (Bounces.bounced d mass r i j z)).
Check (ThreeBallsStep.new_numbers : forall v, ThreeBallsStep.numbers_of (ThreeBallsStep.new v) =
  AnyStep.after_sharing (v Balls.number_of_beta_c) (v Balls.number_of_r_c) (ThreeBallsStep.numbers_of v)
    (ThreeBallsStep.flight v)).
Check (ThreeBallsMap.stair_theorem_holds : ThreeBalls.stair_theorem).
Check (ThreeBallsCollapse.three_balls_theorem_holds : ThreeBalls.three_balls_theorem).
Check (ThreeBallsCollapse.three_equal_balls_holds : ThreeBalls.three_equal_balls).
Check (BallsFlowStep.law_theorem_holds : ThreeBalls.law_theorem).

(* The same of equal balls, in the givens of the sandwich; comparison is a definition. The propositions are
   spelled out in PinnedSandwich.v. *)
Check (fun r G U_most C_0 Theta Q_0 U_0 w => eq_refl :
  Sandwich.inner_goes_on r G U_most C_0 Theta Q_0 U_0 w =
  forall n, let alpha := (1 + r) / 2 * (C_0 - Theta) in
    let rho := G * (w (if Nat.even n then B1 else B2) / w (if Nat.even n then B2 else B1)) ^ 2 in
    let p := Sandwich.inner r G C_0 Theta Q_0 U_0 w n in let P := alpha * (1 - snd p) - fst p - rho * snd p in
    0 < P /\ rho * snd p * (2 * fst p + rho * snd p) <= U_most * (2 - U_most) * P ^ 2).
Check (SandwichStep.sandwich_step : forall v,
  Meaning.scope Inner.the_statement SandwichStep.state_context v ->
  AnyStep.step_certified (SandwichStep.numbers_of v) (SandwichStep.flight v)).
Check (SandwichStep.new_numbers : forall v, SandwichStep.numbers_of (SandwichStep.new v) =
  AnyStep.after_step (v Inner.number_of_r) (SandwichStep.numbers_of v) (SandwichStep.flight v)).
Check (SandwichProof.inner_stair_theorem_holds : Sandwich.inner_stair_theorem).
Check (SandwichProof.sandwich_theorem_holds : Sandwich.sandwich_theorem).

(* --- where collisions in turn end ------------------------------------------------------------------- *)

(* The propositions are spelled out in PinnedOutside.v. goes-on: a definition. *)
Check (fun d T Z time M => eq_refl : Outside.strikes_in_turn d T Z time M =
  (time O = 0 /\ forall n, (n < M)%nat -> time n < time (S n) < T /\
    (forall t, time n <= t < time (S n) -> Z t = Theorem1.later (t - time n) (Z (time n))) /\
    let arriving := Theorem1.later (time (S n) - time n) (Z (time n)) in
    distance d arriving B0 (collides_with n) = 1 /\ rate d arriving B0 (collides_with n) < 0)).
Definition distinct_others (i j : ball) : Prop := i <> B0 /\ j <> B0 /\ i <> j.
(* glue-next: the first of two strikes, and what follows from the second one. *)
Check (OutsideStep.next_theorem_holds : Outside.next_theorem).
Check (AnyStep.contact_next : forall r m t d x i j, distinct_others i j -> AnyStep.has m d x i j ->
  0 < AnyStep.reach m t -> distance d (Theorem1.later t x) B0 j = 1 ->
  AnyStep.has (AnyStep.after_step r m t) d (collided d r B0 j (Theorem1.later t x)) j i).
Check (OutsideProof.new_numbers : forall v, OutsideProof.numbers_of (OutsideProof.new v) =
  AnyStep.after_step (v Ends.number_of_r) (OutsideProof.numbers_of v) (OutsideProof.flight v)).
Check (OutsideStep.two_strikes : forall r, 0 < r -> forall d m t u x i j, distinct_others i j ->
  AnyStep.has m d x i j -> 0 < AnyStep.d m -> 0 < AnyStep.eta_s m ->
  0 < t -> Outside.strike d (Theorem1.later t x) B0 j ->
  0 < u -> Outside.strike d (Theorem1.later u (collided d r B0 j (Theorem1.later t x))) B0 i ->
  let e := 1 + AnyStep.d m in let y := AnyStep.y m in
  let root := sqrt (1 - AnyStep.d m * (2 + AnyStep.d m) / e / e * (AnyStep.A m / y / y)) in
  let T := AnyStep.d m * (2 + AnyStep.d m) / e / y / (1 + root) in let k := e * y * root in
  let law := (1 + r) / 2 * k * (e * AnyStep.C m - T * AnyStep.a m - e * T * AnyStep.b m - T ^ 2 * AnyStep.w m) -
    (AnyStep.eta_s m + T * AnyStep.B m) in
  (AnyStep.has (AnyStep.after_step r m t) d (collided d r B0 j (Theorem1.later t x)) j i /\
   0 < AnyStep.d (AnyStep.after_step r m t) /\ 0 < AnyStep.eta_s (AnyStep.after_step r m t)) /\ 0 < law /\
  (2 * AnyStep.eta_s m * T + AnyStep.B m * T ^ 2) *
    (AnyStep.B m + 2 * ((1 + r) / 2) * k * (e * AnyStep.b m + T * AnyStep.w m) + ((1 + r) / 2) ^ 2 * k ^ 2) <
    law ^ 2).
Check (OutsideProof.outside_theorem_holds : Outside.outside_theorem).
Check (OutsideProof.no_collapse_theorem_holds : Outside.no_collapse_theorem).
Check (OutsideProof.floor_theorem_holds : Outside.floor_theorem).

(* --- the spectrum ----------------------------------------------------------------------------------- *)

(* The propositions, and the matrix, are spelled out in PinnedSpectrum.v. *)
Check (fun d r s => eq_refl : Spectrum.triple d r s =
  collided d r B1 B2 (collided d r B0 B2 (collided d r B0 B1 s))).
Check (fun r u => eq_refl : Spectrum.orbit r u 0 = u).
Check (fun r u n => eq_refl : Spectrum.orbit r u (S n) = Spectrum.image r (Spectrum.orbit r u n)).
Check (SpectrumMatrix.basis_holds : Spectrum.basis_theorem).
Check (SpectrumMatrix.matrix : Spectrum.matrix_theorem).
Check (SpectrumRoots.characteristic : Spectrum.characteristic_theorem).
Check (SpectrumEigen.spectrum : Spectrum.spectrum_theorem).
Check (SpectrumOrbits.parameter : Spectrum.parameter_theorem).
Check (SpectrumOrbits.orbits : Spectrum.orbit_theorem).
Check (SpectrumSentences.signs : (forall x y, 0 < x -> 0 < y -> 0 < x + y /\ 0 < x * y) /\
  (forall x, 0 <= x * x) /\
  (forall a b x y, 0 < a -> 0 <= b -> x < 0 -> y < 0 -> a * x + b * y < 0) /\
  (forall x y, 0 < x -> 0 < y -> (x < y <-> x * x < y * y))).
Check (SpectrumRoots.roots : forall r, 0 < r < 1 -> exists l0 p m,
  -1 < - r < l0 /\ l0 < - r ^ 3 < 0 /\ Spectrum.Q r l0 = 0 /\ (forall l, Spectrum.Q r l = 0 -> l = l0) /\
  (forall l, Spectrum.Q r l = (l - l0) * (l * l + p * l + m)) /\ p * p < 4 * m /\ l0 * l0 < m < 1).
Check (SpectrumRoots.increasing : forall r, 0 < r < 1 -> forall x y, x < y ->
  Spectrum.Q r x < Spectrum.Q r y).
(* spiral: the form that vanishes on the plane of the pair, by the normal components. *)
Check (fun m u => eq_refl : SpectrumSentences.form_of_root m u =
  let r := Spectrum.r_of m in let h := (1 + r) / 4 in
  let c_0 := Spectrum.c_1 u in let c_1 := Spectrum.c_3 u - h * c_0 in
  r / m * c_0 + (h - m) * c_1 +
    ((c_0 + Spectrum.c_3 u) / 2 + sqrt 3 / 2 * (Spectrum.c_4 u - Spectrum.c_2 u) - h * c_0 - h * c_1)).
Check (SpectrumSentences.left_eigenvector : forall m u, 0 < m < 1 ->
  SpectrumSentences.form_of_root m (Spectrum.image (Spectrum.r_of m) u) =
  - m ^ 3 * SpectrumSentences.form_of_root m u).
Check (SpectrumSentences.plane_of_the_pair : forall m mu nu u v, 0 < m < 1 -> nu <> 0 ->
  Spectrum.eigenvector (Spectrum.r_of m) mu nu u v ->
  SpectrumSentences.form_of_root m u = 0 /\ SpectrumSentences.form_of_root m v = 0).
Check (fun p u => eq_refl : SpectrumSentences.apply_form p u =
  Spectrum.c_1 p * Spectrum.c_1 u + Spectrum.c_2 p * Spectrum.c_2 u +
  Spectrum.c_3 p * Spectrum.c_3 u + Spectrum.c_4 p * Spectrum.c_4 u).
Check (SpectrumSentences.transverse : forall p q,
  (forall k, q <> Spectrum.combination k p 0 Spectrum.zero) ->
  exists u, SpectrumSentences.apply_form p u = 0 /\ SpectrumSentences.apply_form q u <> 0).
(* spectral-radius *)
Check (SpectrumSentences.rates : forall t s (u : nat -> R),
  (forall n, u (S (S n)) = t * u (S n) - s * u n) ->
  (t * t < 4 * s -> forall n,
    let size n := u (S n) * u (S n) - t * u n * u (S n) + s * (u n * u n) in
    size n = s ^ n * size 0%nat /\ (s - t * t / 4) * (u n * u n) <= size n) /\
  (forall d, 0 < d -> d * d = t * t - 4 * s -> exists a b, forall n,
    u n = a * ((t + d) / 2) ^ n + b * ((t - d) / 2) ^ n)).
Check (SpectrumSentences.no_rate_when_forced : forall s, 0 < s < 1 -> exists v f : nat -> R,
  (forall n, v (S n) = s * v n + f n) /\ (forall n, sum_f_R0 (fun k => Rabs (f k)) n <= 2) /\
  forall q K, 0 < q < 1 -> exists n, K * q ^ n < v n).
