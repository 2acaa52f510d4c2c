(* If the collisions of the trajectories from a scene are not at finitely many times, then they are
   collisions without end, one after the other. *)
From Coq Require Import Reals List Lra Classical FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Determined Classification Contacts.
Open Scope R_scope.
Set Default Proof Using "All".

Lemma decided (P : Prop) : {P} + {~ P}.
Proof. destruct (ClassicalDedekindReals.sig_not_dec P) as [H|H]; [left; now apply NNPP | now right]. Qed.
(* The number of which something holds, if it is only one. *)
Lemma described (P : R -> Prop) : (exists x, P x) -> (forall x y, P x -> P y -> x = y) -> {x | P x}.
Proof.
  intros E U. destruct (completeness P) as (m & M & L).
  - destruct E as (x & X). exists x. intros y Y. right. now apply U.
  - exact E.
  - exists m. destruct E as (x & X). replace m with x; [exact X|]. apply Rle_antisym; [now apply M|].
    apply L. intros y Y. right. now apply U.
Qed.
Lemma least_in_list (P : R -> Prop) (l : list R) : (exists t, In t l /\ P t) ->
  exists t, P t /\ forall u, In u l -> P u -> t <= u.
Proof.
  induction l as [|a l IH]; intros (t & I & H); [now destruct I|].
  destruct (classic (exists t, In t l /\ P t)) as [K|K].
  - destruct (IH K) as (b & B & L). destruct (classic (P a /\ a < b)) as [[A C]|C].
    + exists a. split; [exact A|]. intros u [<-|J] U; [lra|]. specialize (L u J U). lra.
    + exists b. split; [exact B|]. intros u [<-|J] U; [|now apply L]. apply Rnot_lt_le. intros D. now apply C.
  - destruct I as [<-|I]; [|exfalso; apply K; now exists t].
    exists a. split; [exact H|]. intros u [<-|J] U; [lra|]. exfalso. apply K. now exists u.
Qed.

(* --- one trajectory ------------------------------------------------------------------------------ *)

Section OneTrajectory.
Variable d : nat.
Variable r : R.
Variable s : scene.
Variable T : R.
Variable Z : R -> scene.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis goes : trajectory d r s T Z.

Lemma same_arriving t e e' a a' : 0 < e -> 0 < e' -> (forall u, 0 < u < e -> Z (t - u) = later (- u) a) ->
  (forall u, 0 < u < e' -> Z (t - u) = later (- u) a') -> a = a'.
Proof.
  intros E E' A A'. set (u := Rmin e e' / 2). assert (P : 0 < Rmin e e') by now apply Rmin_glb_lt.
  pose proof (Rmin_l e e'). pose proof (Rmin_r e e').
  rewrite <- (later_back u a), <- (later_back u a'). f_equal.
  rewrite <- A, <- A' by (unfold u; lra). reflexivity.
Qed.
(* What happens at a collision. *)
Lemma at_collision t : 0 < t < T -> collision_at d Z t ->
  exists e arriving, 0 < e /\ (forall u, 0 < u < e -> Z (t - u) = later (- u) arriving) /\
    two_collide d r arriving (Z t).
Proof.
  intros L (e & a & i & j & E & A & N & C & P). destruct (before_it d r s T Z goes t L) as (e' & a' & E' & A' & W).
  exists e', a'. split; [exact E'|]. split; [exact A'|]. destruct W as [[W _]|W]; [|exact W].
  rewrite <- (same_arriving t e e' a a' E E' A A') in W. destruct (W i j N) as [_ K]. specialize (K C). lra.
Qed.
Lemma two_collide_moves x y : two_collide d r x y -> velocity y <> velocity x.
Proof.
  intros (i & j & N & C & P & _ & ->) E.
  assert (S : forall k, velocity (collided d r i j x) i k = velocity x i k) by (intros k; now rewrite E).
  unfold collided in S. cbn [velocity] in S.
  assert (same i i = true) by now destruct i. rewrite H in S.
  assert (F : forall k, to x i j k = 0).
  { intros k. specialize (S k). assert ((1 + r) / 2 * rate d x i j * to x i j k = 0) by lra.
    apply Rmult_integral in H0. destruct H0 as [K|K]; [|exact K].
    assert ((1 + r) / 2 * rate d x i j < 0); [|lra].
    assert (0 < (1 + r) / 2 * - rate d x i j) by (apply Rmult_lt_0_compat; lra). lra. }
  unfold rate in P. assert (G : dot d (to x i j) (relative x i j) = 0).
  { replace (to x i j) with (scaled 0 (to x i j)) by (apply same_vector; intros k; unfold scaled; rewrite F; ring).
    rewrite dot_scaled. ring. }
  lra.
Qed.
(* In free flight around a time there is no collision at it. *)
Lemma free_none a b t : 0 <= a -> a < t < b -> b <= T -> (forall u, a <= u < b -> Z u = later (u - a) (Z a)) ->
  ~ collision_at d Z t.
Proof.
  intros A L B F C. destruct (at_collision t ltac:(lra) C) as (e & x & E & X & W).
  apply (two_collide_moves _ _ W). set (u := Rmin e (t - a) / 2).
  assert (P : 0 < Rmin e (t - a)) by (apply Rmin_glb_lt; lra).
  pose proof (Rmin_l e (t - a)). pose proof (Rmin_r e (t - a)).
  pose proof (X u ltac:(unfold u; lra)) as Y. rewrite (F (t - u)) in Y by (unfold u; lra).
  rewrite (F t) by lra. change (velocity (later (t - a) (Z a))) with (velocity (later (t - u - a) (Z a))).
  now rewrite Y.
Qed.
(* Without collisions between, there is free flight. *)
Lemma free_between a b : 0 <= a < b -> b <= T -> (forall t, a < t < b -> ~ collision_at d Z t) ->
  forall u, a <= u < b -> Z u = later (u - a) (Z a).
Proof.
  intros A B N u U. set (free := fun x => a <= x <= u /\ forall v, a <= v <= x -> Z v = later (v - a) (Z a)).
  destruct (completeness free) as (m & M1 & M2).
  - exists u. intros x [X _]. lra.
  - exists a. split; [lra|]. intros v V. replace v with a by lra. rewrite Rminus_diag_eq by reflexivity.
    now rewrite later_0.
  - assert (Ma : a <= m).
    { apply M1. split; [lra|]. intros v V. replace v with a by lra. rewrite Rminus_diag_eq by reflexivity.
      now rewrite later_0. }
    assert (Mu : m <= u) by (apply M2; intros x [X _]; lra).
    assert (F : forall v, a <= v < m -> Z v = later (v - a) (Z a)).
    { intros v V. apply NNPP. intros K. enough (m <= v) by lra. apply M2. intros x [X Y].
      apply Rnot_lt_le. intros W. apply K, Y. lra. }
    assert (G : Z m = later (m - a) (Z a)).
    { destruct (Rle_lt_or_eq_dec a m Ma) as [L|<-];
        [|rewrite Rminus_diag_eq by reflexivity; now rewrite later_0].
      destruct (before_it d r s T Z goes m ltac:(lra)) as (e & x & E & X & W).
      assert (XE : x = later (m - a) (Z a)).
      { apply (same_arriving m e (m - a) x _ E ltac:(lra) X). intros v V. rewrite F by lra.
        rewrite later_later. f_equal. ring. }
      destruct W as [[_ W]|W]; [now rewrite W|]. exfalso. apply (N m); [lra|].
      destruct W as (i & j & D & C & P & _). exists e, x, i, j. tauto. }
    destruct (after_it d r s T Z goes m ltac:(lra)) as (e & E & H).
    destruct (Rle_lt_or_eq_dec m u Mu) as [L|<-]; [|exact G].
    assert (K : free (Rmin u (m + e / 2))).
    { pose proof (Rmin_l u (m + e / 2)). pose proof (Rmin_r u (m + e / 2)).
      assert (m < Rmin u (m + e / 2)) by (apply Rmin_glb_lt; lra). split; [lra|]. intros v V.
      destruct (Rlt_le_dec v m) as [Q|Q]; [apply F; lra|].
      replace v with (m + (v - m)) at 1 by ring. rewrite H by lra. rewrite G, later_later. f_equal. ring. }
    apply M1 in K. assert (m < Rmin u (m + e / 2)) by (apply Rmin_glb_lt; lra). lra.
Qed.
(* Up to each time there are finitely many collisions. *)
Lemma finitely_many t : 0 <= t < T ->
  exists l, forall u, 0 < u <= t -> collision_at d Z u -> In u l.
Proof.
  intros L. set (few := fun x => 0 <= x <= t /\ exists l, forall u, 0 < u <= x -> collision_at d Z u -> In u l).
  assert (F0 : few 0) by (split; [lra|]; exists nil; intros; lra).
  destruct (completeness few) as (m & M1 & M2).
  - exists t. intros x [X _]. lra.
  - now exists 0.
  - assert (M : 0 <= m <= t) by (split; [now apply M1 | apply M2; intros x [X _]; lra]).
    destruct (after_it d r s T Z goes m ltac:(lra)) as (e & E & H).
    assert (AFTER : forall u, m < u < Rmin T (m + e) -> ~ collision_at d Z u).
    { intros u U. pose proof (Rmin_l T (m + e)). pose proof (Rmin_r T (m + e)).
      apply (free_none m (Rmin T (m + e))); try lra. intros v V.
      replace v with (m + (v - m)) at 1 by ring. apply H. lra. }
    assert (BEFORE : exists y l, y < m + 1 /\ (0 < m -> y < m) /\ (forall u, 0 < u < m -> y < u -> ~ collision_at d Z u) /\
      (forall u, 0 < u <= y -> collision_at d Z u -> In u l)).
    { destruct (Rle_lt_or_eq_dec 0 m (proj1 M)) as [P|<-];
        [|exists 0, nil; repeat split; intros; lra].
      destruct (before_it d r s T Z goes m ltac:(lra)) as (e' & x & E' & X & _).
      set (w := Rmin e' m / 2). assert (W : 0 < Rmin e' m) by (apply Rmin_glb_lt; lra).
      pose proof (Rmin_l e' m). pose proof (Rmin_r e' m).
      assert (NOT : exists y, m - w < y <= m /\ few y).
      { apply NNPP. intros K. assert (m <= m - w); [|unfold w in *; lra].
        apply M2. intros y Y. apply Rnot_lt_le. intros Q. apply K. exists y. split; [|exact Y].
        split; [exact Q | now apply M1]. }
      destruct NOT as (y & Y & _ & l & LL). exists (Rmin y (m - w / 2)), l.
      pose proof (Rmin_l y (m - w / 2)). pose proof (Rmin_r y (m - w / 2)).
      assert (m - w < Rmin y (m - w / 2)) by (apply Rmin_glb_lt; unfold w in *; lra).
      split; [unfold w in *; lra|]. split; [unfold w in *; lra|]. split.
      - intros u U V. apply (free_none (m - w) m); unfold w in *; try lra. intros v V'.
        replace v with (m - (m - v)) by ring. rewrite X by lra.
        replace (m - Rmin e' m / 2) with (m - (Rmin e' m / 2)) by ring. rewrite (X (Rmin e' m / 2)) by lra.
        rewrite later_later. f_equal. ring.
      - intros u U. apply LL. lra. }
    destruct BEFORE as (y & l & Y1 & Y2 & Y3 & Y4).
    assert (K : few (Rmin t (m + Rmin (T - m) e / 2))).
    { assert (P : 0 < Rmin (T - m) e) by (apply Rmin_glb_lt; lra).
      pose proof (Rmin_l (T - m) e). pose proof (Rmin_r (T - m) e).
      pose proof (Rmin_l t (m + Rmin (T - m) e / 2)). pose proof (Rmin_r t (m + Rmin (T - m) e / 2)).
      assert (m <= Rmin t (m + Rmin (T - m) e / 2)) by (apply Rmin_glb; lra).
      split; [lra|]. exists (m :: l). intros u U C.
      destruct (Rtotal_order u m) as [Q|[->|Q]]; [|now left|].
      - destruct (Rlt_le_dec y u) as [W|W]; [exfalso; apply (Y3 u); trivial; lra|]. right. apply Y4; trivial. lra.
      - exfalso. apply (AFTER u); [|exact C]. split; [exact Q|]. apply Rmin_glb_lt; lra. }
    pose proof (M1 _ K) as Q.
    assert (P : 0 < Rmin (T - m) e) by (apply Rmin_glb_lt; lra).
    destruct (Rle_lt_dec t (m + Rmin (T - m) e / 2)) as [W|W].
    + rewrite Rmin_left in K by exact W. destruct K as [_ K]. exact K.
    + rewrite Rmin_right in Q by lra. lra.
Qed.
End OneTrajectory.

(* --- all trajectories from a scene --------------------------------------------------------------- *)

Section AllTrajectories.
Variable d : nat.
Variable r : R.
Variable s : scene.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis endlessly : ~ finite d r s.

Definition happens (t : R) : Prop := exists T Z, trajectory d r s T Z /\ 0 < t < T /\ collision_at d Z t.
Definition reached (t : R) (x : scene) : Prop := exists T Z, trajectory d r s T Z /\ 0 <= t < T /\ Z t = x.
Lemma one_scene t x y : reached t x -> reached t y -> x = y.
Proof.
  intros (T & Z & G & L & <-) (T' & Z' & G' & L' & <-). apply (agree d r s T T' Z Z' G G' t); lra.
Qed.
Lemma shared_collision T Z t : trajectory d r s T Z -> 0 < t < T -> happens t -> collision_at d Z t.
Proof.
  intros G L (T' & Z' & G' & L' & e & a & i & j & E & A & N & C & P).
  exists (Rmin e t), a, i, j. pose proof (Rmin_l e t). pose proof (Rmin_r e t).
  split; [apply Rmin_glb_lt; lra|]. split; [|tauto]. intros u U.
  rewrite <- (agree d r s T' T Z' Z G' G) by lra. apply A. lra.
Qed.
(* A time at which the motion is, and the next collision after it. *)
Definition good (t : R) : Prop := 0 <= t /\ exists x, reached t x.
Definition next_time (a b : R) : Prop := happens b /\ a < b /\ forall u, happens u -> a < u -> b <= u.
Lemma there_is_next a : good a -> exists b, next_time a b.
Proof.
  intros (A & x & T & Z & G & L & _).
  destruct (finitely_many d r s T Z restitutes G a L) as (l & F).
  assert (H : exists b, happens b /\ a < b).
  { apply NNPP. intros N. apply endlessly. exists l. intros T' Z' G' t L' C.
    assert (H : happens t) by (exists T', Z'; tauto).
    destruct (Rle_lt_dec t a) as [K|K]; [|exfalso; apply N; now exists t].
    apply F; [lra|]. apply (shared_collision T Z t G); [lra | exact H]. }
  destruct H as (b & (T' & Z' & G' & L' & C) & B).
  destruct (finitely_many d r s T' Z' restitutes G' b ltac:(lra)) as (l' & F').
  destruct (least_in_list (fun u => happens u /\ a < u) l') as (c & (H1 & H2) & M).
  - exists b. split; [apply F'; [lra | exact C]|]. split; [exists T', Z'; tauto | exact B].
  - exists c. split; [exact H1|]. split; [exact H2|]. intros u U V.
    destruct (Rle_lt_dec u b) as [K|K].
    + apply M; [|now split]. apply F'; [destruct U as (? & ? & ? & ? & _); lra|].
      apply (shared_collision T' Z' u G'); [destruct U as (? & ? & ? & ? & _); lra | exact U].
    + apply Rle_trans with b; [|lra]. apply M; [apply F'; [lra | exact C]|]. split; [exists T', Z'; tauto | exact B].
Qed.
Lemma next_is_one a b c : next_time a b -> next_time a c -> b = c.
Proof. intros (B1 & B2 & B3) (C1 & C2 & C3). apply Rle_antisym; [now apply B3 | now apply C3]. Qed.
Lemma next_is_good a b : good a -> next_time a b -> good b.
Proof.
  intros (A & _) ((T & Z & G & L & _) & B & _). split; [lra|]. exists (Z b), T, Z. split; [exact G|]. split; [lra | reflexivity].
Qed.
Lemma begins_good : good 0.
Proof.
  split; [lra|]. apply NNPP. intros N. apply endlessly. exists nil. intros T Z G t L _. apply N.
  exists (Z 0), T, Z. split; [exact G|]. split; [lra | reflexivity].
Qed.
Definition after_one (a : {a | good a}) : {b | good b} :=
  let (b, H) := described (next_time (proj1_sig a)) (there_is_next _ (proj2_sig a)) (next_is_one _) in
  exist _ b (next_is_good _ b (proj2_sig a) H).
Fixpoint time_of (n : nat) : {a | good a} :=
  match n with O => exist _ 0 begins_good | S k => after_one (time_of k) end.
Definition time (n : nat) : R := proj1_sig (time_of n).
Lemma time_next n : next_time (time n) (time (S n)).
Proof. unfold time. cbn [time_of]. unfold after_one. now destruct described. Qed.

Definition value_at (t : R) (f : scene -> R) (y : R) : Prop := exists x, reached t x /\ f x = y.
Lemma value_one t f y z : value_at t f y -> value_at t f z -> y = z.
Proof. intros (x & X & <-) (x' & X' & <-). now rewrite (one_scene t x x' X X'). Qed.
Lemma value_is n f : exists y, value_at (time n) f y.
Proof. destruct (proj2_sig (time_of n)) as (_ & x & X). exists (f x), x. now split. Qed.
Definition number (n : nat) (f : scene -> R) : R :=
  proj1_sig (described (value_at (time n) f) (value_is n f) (value_one _ f)).
Definition scenes (n : nat) : scene :=
  Scene (fun b k => number n (fun x => position x b k)) (fun b k => number n (fun x => velocity x b k)).
Lemma number_is n f x : reached (time n) x -> number n f = f x.
Proof.
  intros X. unfold number. destruct described as (y & Y). cbn [proj1_sig].
  apply (value_one (time n) f); [exact Y|]. now exists x.
Qed.
Lemma scenes_are n x : reached (time n) x -> scenes n = x.
Proof.
  intros X. destruct x as [p v]. unfold scenes. f_equal; extensionality b; extensionality k.
  - exact (number_is n (fun x => position x b k) _ X).
  - exact (number_is n (fun x => velocity x b k) _ X).
Qed.
Let arriving n := later (time (S n) - time n) (scenes n).
Definition met (n : nat) (i j : ball) : Prop := i <> j /\ distance d (arriving n) i j = 1 /\
  rate d (arriving n) i j < 0 /\ (forall a b, a <> b -> 1 <= distance d (arriving n) a b) /\
  scenes (S n) = collided d r i j (arriving n).
Lemma somebody_meets n : exists i j, met n i j.
Proof.
  destruct (time_next n) as (H & L & M). pose proof H as (T & Z & G & B & C).
  destruct (proj2_sig (time_of n)) as (P & _). fold (time n) in P.
  assert (X : scenes n = Z (time n)) by (apply scenes_are; exists T, Z; split; [exact G | split; [lra | reflexivity]]).
  assert (Y : scenes (S n) = Z (time (S n))) by (apply scenes_are; exists T, Z; split; [exact G | split; [lra | reflexivity]]).
  destruct (at_collision d r s T Z restitutes G _ B C) as (e & x & E & A & W).
  assert (F : forall u, time n <= u < time (S n) -> Z u = later (u - time n) (Z (time n))).
  { apply (free_between d r s T Z restitutes G); [lra | lra |]. intros t K N.
    assert (time (S n) <= t); [|lra]. apply M; [exists T, Z; split; [exact G | split; [lra | exact N]] | lra]. }
  assert (XE : x = arriving n).
  { unfold arriving. rewrite X. apply (same_arriving d r s T Z restitutes G (time (S n)) e (time (S n) - time n) x _ E ltac:(lra) A).
    intros u U. rewrite F by lra. rewrite later_later. f_equal. ring. }
  rewrite XE in W. destruct W as (i & j & N & K & Q & O & V). exists i, j.
  split; [exact N|]. split; [exact K|]. split; [exact Q|]. split; [|now rewrite Y].
  intros a b D. exact (all_apart d _ i j a b N D K O).
Qed.
Lemma met_symmetric n i j : met n i j -> met n j i.
Proof.
  intros (N & C & P & O & E). split; [congruence|]. rewrite distance_symmetric, rate_symmetric.
  repeat (split; [assumption|]). rewrite E. now apply collided_symmetric.
Qed.
Definition pair (n : nat) : ball * ball :=
  if decided (met n B0 B1) then (B0, B1) else if decided (met n B0 B2) then (B0, B2) else (B1, B2).
Lemma pair_met n : met n (fst (pair n)) (snd (pair n)).
Proof.
  destruct (somebody_meets n) as (i & j & H). pose proof (met_symmetric n i j H) as H'. pose proof H as (N & _).
  unfold pair. destruct decided as [K|K]; [exact K|]. destruct decided as [K'|K']; [exact K'|].
  cbn [fst snd]. destruct i, j; easy.
Qed.
Theorem collisions_without_end : endless d r s scenes time (fun n => fst (pair n)) (fun n => snd (pair n)).
Proof.
  split; [|split; [reflexivity|]].
  - destruct (proj2_sig (time_of 0)) as (_ & x & X). rewrite (scenes_are 0 x X).
    destruct X as (T & Z & G & _ & <-). exact (begins d r s T Z G).
  - intros n. destruct (pair_met n) as (N & C & P & O & E). destruct (time_next n) as (_ & L & _).
    repeat (split; [assumption|]). exact E.
Qed.
End AllTrajectories.

Theorem finite_or_endless_holds : finite_or_endless.
Proof.
  intros d r s R. destruct (classic (finite d r s)) as [F|N]; [now left | right].
  eexists. eexists. eexists. eexists. exact (collisions_without_end d r s R N).
Qed.
