(* What the certificates take on trust, sentence by sentence, with what Coq proves instead: this file
   fails to compile if one of these theorems comes to say anything else. The list of sentences and
   names is verify/paper/in_coq.py. Sentences of general mathematics are about all vectors, sequences
   and functions; the numbered sentences are about the rows of one certificate, that of the step or
   that of the sharper theorem; BeyondSentences.v has the others. Coq's libraries are imported last: no name of ours hides one of theirs. *)
From Verify Require Import Theorem1.
From Coq Require Import Reals List.
Import ListNotations.
From Verify Require Vectors Sequences Ending Steady OneStep Trajectory OneScene Interior InTurn Gram.
From Verify Require Meaning Step Collapse FromNumbers Runs Sharper AnyStep SharperStep SharperCollapse.
From Verify Require PrintedSet PrintedProof.
From Verify Require Calculus.
Open Scope R_scope.
Definition B1 : ball := Theorem1.B1.

(* --- hard-spheres: a definition, and what it says --------------------------------------------- *)

Check (fun t s i k => eq_refl : position (Theorem1.later t s) i k = position s i k + t * velocity s i k).
Check (fun t s => eq_refl : velocity (Theorem1.later t s) = velocity s).
Check (fun d r i j s => eq_refl : position (Theorem1.collided d r i j s) = position s).
Check (fun d r b i j s k => eq_refl : velocity (Theorem1.collided d r i j s) b k =
  if same b i then velocity s b k + (1 + r) / 2 * rate d s i j * to s i j k
  else if same b j then velocity s b k - (1 + r) / 2 * rate d s i j * to s i j k
  else velocity s b k).
Definition hard_spheres_meet (d : nat) (s : scene) (i j : ball) (t : R) : Prop :=
  0 < t /\ (forall u a b, 0 < u < t -> a <> b -> 1 < distance d (later u s) a b) /\
  distance d (later t s) i j = 1 /\ rate d (later t s) i j < 0 /\
  (forall k, k <> i -> k <> j -> 1 < distance d (later t s) i k /\ 1 < distance d (later t s) j k).
Theorem same_meeting d s i j t : Theorem1.first_to_meet d s i j t <-> hard_spheres_meet d s i j t.
Proof.
  split; [intros [A B C D E]; exact (conj A (conj B (conj C (conj D E))))|].
  intros (A & B & C & D & E). split; assumption.
Qed.

(* --- general mathematics ---------------------------------------------------------------------- *)

(* cauchy-schwarz, and that no other condition binds two vectors. *)
Check (Vectors.cauchy_schwarz : forall d u v, dot d u v ^ 2 <= dot d u u * dot d v v).
Check (Vectors.vector_exists : forall d x p b, (2 <= d)%nat -> 0 < dot d x x ->
  p ^ 2 <= dot d x x * b -> exists z, dot d x z = p /\ dot d z z = b).

(* bounded-monotone *)
Check (Sequences.bounded_increasing_converges : forall u b,
  (forall n, u n <= u (S n)) -> (forall n, u n <= b) -> exists l, Un_cv u l).
Check (Sequences.bounded_decreasing_converges : forall u b,
  (forall n, u (S n) <= u n) -> (forall n, b <= u n) -> exists l, Un_cv u l).

(* the same for tuples of vectors with masses; and that lengths add *)
Check (fun d m x z n => eq_refl : Calculus.mixed d m x z n = sum_f_R0 (fun i => m i * dot d (x i) (z i)) n).
Check (Calculus.tuples_bounded : forall d m x z n, (forall i, 0 < m i) ->
  Calculus.mixed d m x z n ^ 2 <= Calculus.mixed d m x x n * Calculus.mixed d m z z n).
Check (Calculus.lengths_add : forall d u v, sqrt (dot d (Vectors.combined 1 u 1 v) (Vectors.combined 1 u 1 v)) <=
  sqrt (dot d u u) + sqrt (dot d v v)).
(* bounded-monotone: series of vectors, and sums in another order *)
Check (Calculus.vectors_summable : forall d (u : nat -> vector) b,
  (forall n, sum_f_R0 (fun m => sqrt (dot d (u m) (u m))) n <= b) ->
  forall k, (k < d)%nat -> exists l, Un_cv (fun n => sum_f_R0 (fun m => u m k) n) l).
Check (Calculus.any_order : forall u p q l, (forall n, 0 <= u n) ->
  (forall n, q (p n) = n) -> (forall n, p (q n) = n) ->
  Un_cv (fun n => sum_f_R0 u n) l -> Un_cv (fun n => sum_f_R0 (fun m => u (p m)) n) l).
(* monotone *)
Check (Calculus.falls_and_rises : forall a b f f' f'', a < b ->
  (forall x, a <= x <= b -> derivable_pt_lim f x (f' x)) ->
  (forall x, a <= x <= b -> derivable_pt_lim f' x (f'' x)) ->
  (forall x, a <= x <= b -> 0 < f'' x) -> f' a < 0 -> 0 < f' b ->
  exists c, a < c < b /\ f' c = 0 /\ (forall x y, a <= x < y -> y <= c -> f y < f x) /\
    (forall x y, c <= x < y -> y <= b -> f x < f y)).

(* open-condition: a function is steady at a scene if it is continuous there. *)
Check (fun d s P => eq_refl :
  Steady.nearby d s P = exists h, 0 < h /\ forall s', close d h s s' -> P s').
Check (fun d s f => eq_refl : Steady.steady d s f = forall e, 0 < e ->
  exists h, 0 < h /\ forall s', close d h s s' -> Rabs (f s' - f s) < e).
Check (Steady.steady_less : forall d s f g, Steady.steady d s f -> Steady.steady d s g ->
  f s < g s -> exists h, 0 < h /\ forall s', close d h s s' -> f s' < g s').
Check (Steady.nearby_both : forall d s (P Q : scene -> Prop),
  (exists h, 0 < h /\ forall s', close d h s s' -> P s') ->
  (exists h, 0 < h /\ forall s', close d h s s' -> Q s') ->
  exists h, 0 < h /\ forall s', close d h s s' -> P s' /\ Q s').

(* finite-length, for balls that collide in turn until the time T: each coordinate of each of them
   has a limit. *)
Check (Ending.place_cauchy : forall d r, 0 < r < 1 -> forall scenes time T,
  collides_in_turn d r scenes time -> Un_cv time T ->
  forall i k, Cauchy_crit (Ending.place d scenes i k)).
Check (Ending.positions_converge_to_ending : forall d r restitutes scenes time T in_turn converges i k,
  (k < d)%nat -> Un_cv (fun n => position (scenes n) i k)
    (position (Ending.ending d r restitutes scenes time T in_turn converges) i k)).

(* --- the numbered sentences of the step ------------------------------------------------------- *)

(* The values w are those of a state of the certificate; the scene x has them, i has just collided
   with ball 0, and j is next. *)
Definition a_state (w : Meaning.valuation) : Prop :=
  Meaning.scope Step.the_statement Gram.state_context w.
Definition distinct (i j : ball) : Prop := i <> B0 /\ j <> B0 /\ i <> j.
(* Of the direction and the relative velocity of i and of j, seen from ball 0, the numbers are the inner
   products, and 1 + d is the distance of j. *)
Definition has_numbers (m : AnyStep.numbers) d (x : scene) (i j : ball) : Prop :=
  exists q, (to x B0 j = fun k => (1 + AnyStep.d m) * q k) /\
    let p := to x B0 i in let s := relative x B0 i in let c := relative x B0 j in
    dot d p p = 1 /\ dot d q q = 1 /\ dot d p q = - AnyStep.C m /\
    dot d p s = AnyStep.eta_s m /\ dot d q c = - AnyStep.y m /\
    dot d p c = AnyStep.a m /\ dot d q s = AnyStep.b m /\
    dot d s s = AnyStep.B m /\ dot d c c = AnyStep.A m /\ dot d s c = AnyStep.w m.
Theorem same_numbers m d x i j : AnyStep.has m d x i j <-> has_numbers m d x i j.
Proof.
  split; intros (q & E & F); exists q; (split; [exact E|]).
  - destruct F. repeat (split; [assumption|]). assumption.
  - destruct F as (? & ? & ? & ? & ? & ? & ? & ? & ? & ?). split; assumption.
Qed.
Check (fun w => eq_refl : Gram.shows w = AnyStep.has (AnyStep.Numbers
  (w Step.number_of_y) (w Step.number_of_eta_s) (w Step.number_of_C) (w Step.number_of_a)
  (w Step.number_of_b) (w Step.number_of_A) (w Step.number_of_B) (w Step.number_of_w)
  (w Step.number_of_d))).
(* glue-next: the next collision, and the state after it. *)
Check (OneStep.meets : forall w, a_state w -> forall d x i j, distinct i j ->
  Gram.shows w d x i j -> first_to_meet d x B0 j (OneStep.flight w)).
Check (OneStep.shows_next : forall w, a_state w -> forall d x i j, distinct i j ->
  Gram.shows w d x i j -> Gram.shows (OneStep.new w) d
    (collided d (w Step.number_of_r) B0 j (later (OneStep.flight w) x)) j i).

(* glue-collapse: collisions without end, in finite time. The values v are those of a start. *)
Definition a_start (v : Meaning.valuation) : Prop :=
  Meaning.scope Step.the_statement Gram.start_context v.
Definition begins_with (v : Meaning.valuation) (d : nat) (x : scene) : Prop :=
  Gram.shows (Meaning.after Step.the_statement v Gram.start) d x B1 B2.
Check (Trajectory.scenes_collide_in_turn : forall v, a_start v -> forall d x, begins_with v d x ->
  collides_in_turn d (v Step.number_of_r) (Trajectory.scenes v d x) (Trajectory.time v)).
Check (Trajectory.finite_time : forall v, a_start v -> forall d x, begins_with v d x ->
  exists t, Un_cv (Trajectory.time v) t /\ t <= v Step.number_of_T_star).

(* glue-angle: the angle converges, to that of the places to which the balls come. *)
Check (Trajectory.angle_converges : forall v, a_start v -> forall d x, begins_with v d x ->
  exists l, Un_cv (Trajectory.cosine v) l /\ Rabs (l - v Step.number_of_c) <= OneStep.drift v).
Check (Ending.in_turn_collapses : forall d r restitutes scenes time T, time 0%nat = 0 ->
  forall in_turn converges, collapses d r (scenes 0%nat) scenes time T (InTurn.course scenes time)
    (Ending.ending d r restitutes scenes time T in_turn converges)).

(* glue-interior: there is a scene that satisfies all inequalities strictly, and scenes near one into
   which it flies are in the set; for any numbers that describe a set and leave room for the scene. *)
Definition strictly_inside (phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c : R) d s : Prop :=
  let gap := distance d s B0 B2 - 1 in
  let y := - rate d s B0 B2 / distance d s B0 B2 in
  0 < gap /\ gap < d_const /\ gap < d_slope * (y * y) /\
  0 < rate d s B0 B1 /\ 0 < y /\ y < eta_bar /\
  Rabs (rate d s B0 B1 - phi_minus * y) < x_0 * y /\
  V_0 + (V_1 - V_0) / 3 < dot d (relative s B0 B1) (relative s B0 B1) /\
  dot d (relative s B0 B1) (relative s B0 B1) < V_1 - (V_1 - V_0) / 3 /\
  V_0 + (V_1 - V_0) / 3 < dot d (relative s B0 B2) (relative s B0 B2) /\
  dot d (relative s B0 B2) (relative s B0 B2) < V_1 - (V_1 - V_0) / 3 /\
  Rabs (minus_cosine d s - c) < Delta_theta / 4.
Theorem same_inside a b c e f g h i j d s :
  Interior.inside a b c e f g h i j d s <-> strictly_inside a b c e f g h i j d s.
Proof.
  split; [intros []; repeat (split; [assumption|]); assumption|].
  intros (? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ? & ?). split; assumption.
Qed.
Check (OneScene.numbers_of_point_are : forall phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c
  d, (2 <= d)%nat -> OneScene.room phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c ->
  OneScene.numbers_of_point phi_minus eta_bar d_const d_slope V_0 V_1 c d).
Check (Interior.set_near : forall phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d,
  let initial := FromNumbers.initial_with phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d in
  (forall s d_0 y, initial s d_0 y -> exists t, first_to_meet d s B0 B2 t) ->
  forall s, Interior.inside phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c d s ->
  distance d s B0 B1 = 1 ->
  has_interior d (fun s' => exists s_0 d_0 y u, initial s_0 d_0 y /\ 0 <= u /\
    (forall v i j, 0 < v <= u -> i <> j -> 1 < distance d (later v s_0) i j) /\ s' = later u s_0)).
Check (Interior.the_set_has_an_interior : forall r c V_0 delta_theta,
  admissible r c V_0 delta_theta -> forall d, (2 <= d)%nat ->
  has_interior d (ZK r c V_0 delta_theta d)).
(* The same of the printed set with room for the angle. *)
Check (PrintedProof.room_has_an_interior : forall r c V_0 delta_theta,
  admissible r c V_0 delta_theta -> forall d, (2 <= d)%nat ->
  has_interior d (PrintedSet.with_room r c V_0 delta_theta d)).

(* --- what is said of a point run, and of a scene that disperses --------------------------------- *)

(* The initial scenes of a point run, for numbers in place of the constants. *)
Definition initial_by_numbers (phi_minus x_0 eta_bar d_const d_slope V_0 V_1 Delta_theta c : R)
    (d : nat) (s : scene) (d_0 y : R) : Prop :=
  distance d s B0 B2 = 1 + d_0 /\ rate d s B0 B2 = - y * (1 + d_0) /\
  distance d s B0 B1 = 1 /\ 0 < rate d s B0 B1 /\
  0 < y <= eta_bar /\ Rabs (rate d s B0 B1 - phi_minus * y) <= x_0 * y /\
  0 < d_0 <= Rmin d_const (d_slope * y ^ 2) /\
  V_0 + (V_1 - V_0) / 3 <= dot d (relative s B0 B1) (relative s B0 B1) <= V_1 - (V_1 - V_0) / 3 /\
  V_0 + (V_1 - V_0) / 3 <= dot d (relative s B0 B2) (relative s B0 B2) <= V_1 - (V_1 - V_0) / 3 /\
  Rabs (minus_cosine d s - c) <= Delta_theta / 4.
Theorem same_initial_with a b c d e f g h i n s d_0 y :
  FromNumbers.initial_with a b c d e f g h i n s d_0 y <-> initial_by_numbers a b c d e f g h i n s d_0 y.
Proof.
  split; [intros []; repeat (split; [assumption|]); assumption|].
  intros (? & ? & ? & ? & ? & ? & ? & ? & ? & ?). split; assumption.
Qed.
Check (Collapse.scene_with_constants : forall r c V_0 delta_theta d s d_0 y,
  FromNumbers.initial_with (phi_minus r c) (x_0 r c V_0) (eta_bar r c V_0 delta_theta)
    (d_const r c V_0 delta_theta) (d_slope r c V_0) V_0 (V_1 r c V_0)
    (Delta_theta r c V_0 delta_theta) c d s d_0 y <-> initial r c V_0 delta_theta d s d_0 y).
Check (fun d r s z => eq_refl : Runs.run d r s [] z = (z = s)).
Check (fun d r s i j t rest z => eq_refl : Runs.run d r s ((i, j, t) :: rest) z =
  (i <> j /\ first_to_meet d s i j t /\ Runs.run d r (collided d r i j (later t s)) rest z)).
Check (fun d r s t => eq_refl : Runs.motion d r s [] t = later t s).
Check (fun d r s i j u rest t => eq_refl : Runs.motion d r s ((i, j, u) :: rest) t =
  if Rlt_dec t u then later t s else Runs.motion d r (collided d r i j (later u s)) rest (t - u)).
Check (fun d r s l => eq_refl : Runs.disperses d r s l =
  ((exists z, Runs.run d r s l z /\ forall t, 0 < t -> nobody_collides d (later t z)) /\
   forall T, trajectory d r s T (Runs.motion d r s l))).
Check (fun o s c x => eq_refl : Runs.renamed o s c x =
  let role i := match i with B0 => o | Theorem1.B1 => s | B2 => c end in
  Scene (fun i => position x (role i)) (fun i => velocity x (role i))).
Check (fun i j t l => eq_refl : Runs.lasts ((i, j, t) :: l) = t + Runs.lasts l).
Check (eq_refl : Runs.lasts [] = 0).
Check (fun d r s l o i c earliest latest least most => eq_refl :
  Runs.collapses_after d r s l o i c earliest latest least most =
  exists z scenes time T Z at_T whole, Runs.run d r s l z /\
    collapses d r (Runs.renamed o i c z) scenes time T Z at_T /\
    trajectory d r s (Runs.lasts l + T) whole /\
    (forall t, 0 <= t -> Runs.renamed o i c (whole (Runs.lasts l + t)) = Z t) /\
    (forall T' Z', trajectory d r s T' Z' -> T' <= Runs.lasts l + T) /\
    earliest <= Runs.lasts l + T <= latest /\ least <= minus_cosine d at_T <= most).

(* --- the numbered sentences of the sharper theorem ---------------------------------------------- *)

(* glue-next: the values v are those of a state. *)
Check (SharperStep.sharper_step : forall v,
  Meaning.scope Sharper.the_statement SharperStep.state_context v ->
  AnyStep.step_certified (SharperStep.numbers_of v) (SharperStep.flight v)).
Check (AnyStep.meets : forall m t, AnyStep.step_certified m t -> forall d x i j, distinct i j ->
  AnyStep.has m d x i j -> first_to_meet d x B0 j t).
Check (AnyStep.shows_next : forall r m t, AnyStep.step_certified m t -> forall d x i j, distinct i j ->
  AnyStep.has m d x i j ->
  AnyStep.has (AnyStep.after_step r m t) d (collided d r B0 j (later t x)) j i).
Check (SharperStep.new_numbers : forall v,
  SharperStep.numbers_of (SharperStep.new v) =
  AnyStep.after_step (v Sharper.number_of_r) (SharperStep.numbers_of v) (SharperStep.flight v)).

(* glue-collapse: collisions without end, in finite time. The values v are those of a start. *)
Definition sharper_start (v : Meaning.valuation) : Prop :=
  Meaning.scope Sharper.the_statement SharperStep.start_context v.
Definition sharper_begins (v : Meaning.valuation) (d : nat) (x : scene) : Prop :=
  AnyStep.has (SharperStep.numbers_of (Meaning.after Sharper.the_statement v SharperStep.start)) d x
    B1 B2.
Definition sharper_latest (v : Meaning.valuation) : R :=
  Sharper.duration (v Sharper.number_of_p) (v Sharper.number_of_Y) (v Sharper.number_of_T) *
    v Sharper.number_of_eta_0.
Check (SharperCollapse.collide_in_turn : forall v, sharper_start v -> forall d x,
  sharper_begins v d x -> collides_in_turn d (v Sharper.number_of_r) (SharperCollapse.scenes v d x)
    (SharperCollapse.time v)).
Check (SharperCollapse.time_bounded : forall v, sharper_start v -> forall d x,
  sharper_begins v d x -> forall n, SharperCollapse.time v n <= sharper_latest v).

(* glue-angle *)
Check (SharperCollapse.angle_stays : forall v, sharper_start v -> forall d x,
  sharper_begins v d x -> forall n, Rabs (minus_cosine d (SharperCollapse.scenes v d x n) -
    v Sharper.number_of_C_0) <= v Sharper.number_of_Theta).
Check (SharperCollapse.sharper_collapse : forall v, sharper_start v -> forall d x,
  sharper_begins v d x -> collapse d (v Sharper.number_of_r) x (sharper_latest v)
    (v Sharper.number_of_C_0) (v Sharper.number_of_Theta)).
