(* Three balls of any masses and radii that collide in any order, whose places converge: one of them
   meets the other two in turn from some collision on. *)
From Coq Require Import Reals Arith Lra Lia Classical.
From Verify Require Import Theorem1 Vectors Motion Sequences Ending Classification Contacts.
Open Scope R_scope.

Section Balls.
Variable d : nat.
Variables mass radius : ball -> R.
Variables scenes : nat -> scene.
Variable time : nat -> R.
Variables i j : nat -> ball.
Variable at_T : scene.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis large : forall b, 0 < radius b.
Hypothesis run : strikes d mass radius scenes time i j.
Hypothesis converge : settles d scenes at_T.

Definition meets (n : nat) (a b : ball) : Prop := pair_is (i n) (j n) a b.
Lemma meets_symmetric n a b : meets n a b -> meets n b a.
Proof. unfold meets, pair_is. tauto. Qed.
Lemma limit a b c : Un_cv (fun n => dot d (to (scenes n) a b) (to (scenes n) a c))
  (dot d (to at_T a b) (to at_T a c)).
Proof. apply dot_converges; intros k K; now apply converge. Qed.
Lemma arrives n a b : to (scenes (S n)) a b = to (later (time (S n) - time n) (scenes n)) a b.
Proof. destruct (run n) as (_ & _ & _ & _ & _ & J & _ & X & _). exact (same_places _ _ a b X). Qed.
Lemma apart n a b : a <> b -> (radius a + radius b) ^ 2 <= square d (scenes (S n)) a b.
Proof.
  intros N. unfold square. rewrite arrives. destruct (run n) as (_ & _ & _ & _ & A & _).
  specialize (A a b N). pose proof (large a). pose proof (large b).
  change (dot _ _ _) with (square d (later (time (S n) - time n) (scenes n)) a b).
  rewrite square_of_distance. rewrite <- Rsqr_pow2. apply Rsqr_incr_1; [exact A | lra|].
  apply sqrt_pos.
Qed.
Lemma apart_at_the_end a b : a <> b -> 0 < (radius a + radius b) ^ 2 <= square d at_T a b.
Proof.
  intros N. pose proof (large a). pose proof (large b). split; [apply pow_lt; lra|].
  enough (- square d at_T a b <= - (radius a + radius b) ^ 2) by lra.
  apply (limit_at_most (fun n => - square d (scenes (S n)) a b)).
  - apply limit_opposite. intros e E. destruct (limit a b b e E) as (m & M). exists m. intros n K.
    apply M. lia.
  - intros n. pose proof (apart n a b N). lra.
Qed.
(* If the angle at a is acute in the limit, then from some collision on. *)
Lemma acute a b c : 0 < dot d (to at_T a b) (to at_T a c) ->
  exists N, forall n, (n >= N)%nat -> 0 <= dot d (to (scenes (S n)) a b) (to (scenes (S n)) a c).
Proof.
  intros P. destruct (limit a b c _ P) as (N & H). exists N. intros n K. specialize (H (S n) ltac:(lia)).
  unfold R_dist in H. apply Rabs_def2 in H. lra.
Qed.
Lemma acute_at_end a b c : a <> c -> square d at_T b c <= square d at_T a b ->
  0 < dot d (to at_T a b) (to at_T a c).
Proof.
  intros N L. pose proof (cosines d at_T a b c). destruct (apart_at_the_end a c N). lra.
Qed.

Lemma closing n a b : meets n a b -> rate d (later (time (S n) - time n) (scenes n)) a b < 0.
Proof.
  destruct (run n) as (_ & _ & _ & G & _). intros [[E F]|[E F]]; rewrite E, F in G; [exact G|].
  now rewrite rate_symmetric.
Qed.
Lemma hit_of n a b : meets n a b ->
  hits d mass a b (later (time (S n) - time n) (scenes n)) (scenes (S n)).
Proof.
  destruct (run n) as (IJ & _ & _ & _ & _ & H). intros [[E F]|[E F]]; rewrite E, F in *; [exact H|].
  now apply hit_symmetric.
Qed.
Lemma parts n a b : meets n a b -> 0 <= rate d (scenes (S n)) a b.
Proof. intros M. destruct (hit_of n a b M) as (J & _ & _ & _ & K). apply K. Qed.
Lemma parting_pair n a b : 0 <= rate d (scenes n) a b -> ~ meets n a b /\
  0 <= rate d (later (time (S n) - time n) (scenes n)) a b.
Proof.
  intros P. destruct (run n) as (_ & T & _).
  pose proof (rate_rises d (scenes n) a b _ (Rlt_le _ _ T)) as U.
  split; [|lra]. intros M. apply closing in M. lra.
Qed.
Theorem no_pair_twice n a b : meets n a b -> ~ meets (S n) a b.
Proof. intros M. now apply parting_pair, parts. Qed.
Lemma other_pair n a b c : distinct_balls a b c -> ~ meets n a b -> meets n a c \/ meets n b c.
Proof.
  intros (N & M & O) K. destruct (run n) as (IJ & _). unfold meets, pair_is in *.
  destruct (i n), (j n), a, b, c; try easy; tauto.
Qed.
(* A pair stops colliding if from some collision on its balls hit the third at acute angles only. *)
Lemma pair_stops a b c N : distinct_balls a b c ->
  (forall n, (n >= N)%nat -> meets n a c ->
    0 <= dot d (to (scenes (S n)) a b) (to (scenes (S n)) a c)) ->
  (forall n, (n >= N)%nat -> meets n b c ->
    0 <= dot d (to (scenes (S n)) b a) (to (scenes (S n)) b c)) ->
  exists M, (M >= N)%nat /\ forall n, (n >= M)%nat -> ~ meets n a b.
Proof.
  intros B A1 A2.
  assert (STEP : forall n, (n >= N)%nat -> 0 <= rate d (scenes n) a b ->
      ~ meets n a b /\ 0 <= rate d (scenes (S n)) a b).
  { intros n L P. destruct (parting_pair n a b P) as [NO UP]. split; [exact NO|].
    destruct B as (BA & CA & BC).
    destruct (other_pair n a b c (conj BA (conj CA BC)) NO) as [M|M].
    - pose proof (A1 n L M) as A. rewrite !arrives in A.
      pose proof (pushed d mass heavy a b c _ _ ltac:(congruence) ltac:(congruence) ltac:(congruence)
        (hit_of n a c M) A). lra.
    - pose proof (A2 n L M) as A. rewrite !arrives in A.
      pose proof (pushed d mass heavy b a c _ _ ltac:(congruence) ltac:(congruence) ltac:(congruence)
        (hit_of n b c M) A) as K.
      rewrite !(rate_symmetric d _ b a) in K. lra. }
  destruct (classic (exists n, (n >= N)%nat /\ meets n a b)) as [(m & M & H)|NONE].
  - assert (EVER : forall k, 0 <= rate d (scenes (S m + k)%nat) a b).
    { induction k as [|k IH]; [rewrite Nat.add_0_r; now apply parts|].
      replace (S m + S k)%nat with (S (S m + k)) by lia. apply STEP; [lia | exact IH]. }
    exists (S m). split; [lia|]. intros n L. replace n with (S m + (n - S m))%nat by lia.
    apply STEP; [lia | apply EVER].
  - exists N. split; [lia|]. intros n L H. apply NONE. now exists n.
Qed.
Lemma longest_stops a b c : distinct_balls a b c ->
  square d at_T a c <= square d at_T a b -> square d at_T b c <= square d at_T a b ->
  exists M, forall n, (n >= M)%nat -> ~ meets n a b.
Proof.
  intros B L1 L2. pose proof B as (BA & CA & BC).
  destruct (acute a b c) as (N1 & H1); [apply acute_at_end; [congruence | exact L2]|].
  destruct (acute b a c) as (N2 & H2).
  { apply acute_at_end; [exact BC | now rewrite (square_symmetric d at_T b a)]. }
  destruct (pair_stops a b c (max N1 N2) B) as (M & _ & K).
  - intros n L _. apply H1. lia.
  - intros n L _. apply H2. lia.
  - now exists M.
Qed.
Lemma some_pair_stops : exists o a c M, distinct_balls o a c /\ forall n, (n >= M)%nat -> ~ meets n a c.
Proof.
  assert (G : exists o a c, distinct_balls o a c /\ square d at_T a o <= square d at_T a c /\
    square d at_T c o <= square d at_T a c).
  { pose proof (square_symmetric d at_T B1 B0). pose proof (square_symmetric d at_T B2 B0).
    pose proof (square_symmetric d at_T B2 B1). unfold distinct_balls.
    destruct (Rle_lt_dec (square d at_T B0 B1) (square d at_T B0 B2)) as [P|P],
      (Rle_lt_dec (square d at_T B1 B2) (square d at_T B0 B2)) as [Q|Q],
      (Rle_lt_dec (square d at_T B0 B1) (square d at_T B1 B2)) as [K|K].
    all: try (exists B1, B0, B2; repeat split; (discriminate || lra)).
    all: try (exists B2, B0, B1; repeat split; (discriminate || lra)).
    all: exists B0, B1, B2; repeat split; (discriminate || lra). }
  destruct G as (o & a & c & (N & M & O) & P & Q).
  destruct (longest_stops a c o) as (K & H); [repeat split; congruence | exact P | exact Q|].
  exists o, a, c, K. now split.
Qed.
(* Pairs that meet again and again touch in the limit. *)
Lemma touching a b : (forall m, exists n, (m <= n)%nat /\ meets n a b) ->
  distance d at_T a b = radius a + radius b.
Proof.
  intros W. pose proof (large a). pose proof (large b).
  unfold distance. rewrite <- (sqrt_square (radius a + radius b)) by lra. f_equal.
  apply (often_equal (fun n => square d (scenes n) a b)); [apply limit|].
  intros m. destruct (W m) as (n & L & M). exists (S n). split; [lia|].
  unfold square. rewrite arrives. fold (square d (later (time (S n) - time n) (scenes n)) a b).
  rewrite square_of_distance. destruct (run n) as (_ & _ & Q & _).
  destruct M as [[E F]|[E F]]; rewrite E, F in Q; [now rewrite Q|].
  rewrite distance_symmetric, Q. ring.
Qed.
Lemma meets_in_turn o a c N n : in_turn_from N i j o a c ->
  meets (N + S (2 * n)) o a /\ meets (N + 2 * n) o c.
Proof.
  intros T. split.
  - specialize (T (S (2 * n))). now rewrite Nat.even_succ, <- Nat.negb_even, Nat.even_mul in T.
  - specialize (T (2 * n)%nat). now rewrite Nat.even_mul in T.
Qed.
Lemma touching_in_turn o a c N : in_turn_from N i j o a c ->
  distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c.
Proof.
  intros T. split; apply touching; intros m.
  - exists (N + S (2 * m))%nat. split; [lia | apply (meets_in_turn o a c N m T)].
  - exists (N + 2 * m)%nat. split; [lia | apply (meets_in_turn o a c N m T)].
Qed.
Theorem settled_in_turn : exists o a c N, distinct_balls o a c /\ in_turn_from N i j o a c /\
  distance d at_T o a = radius o + radius a /\ distance d at_T o c = radius o + radius c /\
  dot d (to at_T o a) (to at_T o c) <= 0.
Proof.
  destruct some_pair_stops as (o & x & y & M & (X & Y & XY) & NO).
  assert (TWO : forall n, (n >= M)%nat -> meets n o x \/ meets n o y).
  { intros n L. destruct (other_pair n x y o ltac:(repeat split; congruence) (NO n L)) as [K|K];
      [left | right]; now apply meets_symmetric. }
  assert (T : exists a c, distinct_balls o a c /\ (forall n, (n >= M)%nat -> ~ meets n a c) /\
      forall n, meets (M + n)%nat o (if Nat.even n then c else a)).
  { assert (G : forall a c, distinct_balls o a c ->
      (forall n, (n >= M)%nat -> meets n o a \/ meets n o c) -> meets M o c ->
      forall n, meets (M + n)%nat o (if Nat.even n then c else a)).
    { intros a c D W P. induction n as [|n IH]; [now rewrite Nat.add_0_r|].
      rewrite Nat.even_succ, <- Nat.negb_even. apply no_pair_twice in IH.
      replace (M + S n)%nat with (S (M + n)) by lia. destruct (W (S (M + n)) ltac:(lia)); 
        destruct (Nat.even n); cbn [negb]; trivial; now destruct IH. }
    destruct (TWO M (le_n M)) as [P|P]; [exists y, x | exists x, y];
      (split; [repeat split; congruence|]).
    - split; [intros n L Q; now apply (NO n L), meets_symmetric|].
      apply G; [repeat split; congruence | | exact P]. intros n L. destruct (TWO n L); auto.
    - split; [exact NO | apply G; [now repeat split | exact TWO | exact P]]. }
  destruct T as (a & c & (A & C & AC) & NOT & T).
  exists o, a, c, M. split; [now repeat split|]. split; [exact T|].
  split; [|split].
  - apply (touching_in_turn o a c M T).
  - apply (touching_in_turn o a c M T).
  - apply Rnot_lt_le. intros P. destruct (acute o a c P) as (N & H).
    destruct (pair_stops o a c (max M N)) as (K & L & W).
    + now repeat split.
    + intros n L _. apply H. lia.
    + intros n L Q. now destruct (NOT n ltac:(lia)).
    + apply (W (M + S (2 * K))%nat); [lia | exact (proj1 (meets_in_turn o a c M K T))].
Qed.
End Balls.
