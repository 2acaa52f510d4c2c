(* Of any number of balls, two that have collided do so again only after one of them was hit from such a
   side that it is pushed towards the other: the first sentence of the classification. *)
From Coq Require Import Reals Lra Lia.
From Verify Require Import Theorem1 Vectors.
Open Scope R_scope.

Section ManyBalls.
Variable body : Set.
Variable d : nat.
Variable mass : body -> R.
Hypothesis heavy : forall b, 0 < mass b.

Definition between (x : body -> vector) (a b : body) : vector := fun k => x b k - x a k.
(* The rate at which the distance grows, times the distance. *)
Definition opening (x v : body -> vector) (a b : body) : R := dot d (between x a b) (between v a b).
Definition apart2 (x : body -> vector) (a b : body) : R := dot d (between x a b) (between x a b).
Definition flown (t : R) (x v : body -> vector) : body -> vector := fun b k => x b k + t * v b k.
(* Bodies i and j, which approach, exchange momentum along the line of their centres, and part, or stay, at
   most as fast as they came. *)
Definition struck (x v : body -> vector) (i j : body) (w : body -> vector) : Prop :=
  i <> j /\ opening x v i j < 0 /\ 0 <= opening x w i j <= - opening x v i j /\ exists J, 0 <= J /\
    (forall k, w i k = v i k - J / mass i * between x i j k) /\
    (forall k, w j k = v j k + J / mass j * between x i j k) /\
    (forall b, b <> i -> b <> j -> w b = v b).
(* Places and velocities n are those just after collision n-1; some may be at the same time. *)
Definition history (x v : nat -> body -> vector) (t : nat -> R) (i j : nat -> body) : Prop :=
  forall n, 0 <= t n /\ x (S n) = flown (t n) (x n) (v n) /\ struck (x (S n)) (v n) (i n) (j n) (v (S n)).
Definition is_pair (i j a b : body) : Prop := i = a /\ j = b \/ i = b /\ j = a.
(* If a or b is hit by another body in collision n, then the angle at it is at most a right one. *)
Definition hit_from_behind (x : nat -> body -> vector) (i j : nat -> body) (a b : body) (n : nat) : Prop :=
  forall c, c <> a -> c <> b ->
    (is_pair (i n) (j n) a c -> 0 <= dot d (between (x (S n)) a b) (between (x (S n)) a c)) /\
    (is_pair (i n) (j n) b c -> 0 <= dot d (between (x (S n)) b a) (between (x (S n)) b c)).

Lemma between_opposite x a b : between x b a = scaled (-1) (between x a b).
Proof. apply same_vector. intros k. unfold between, scaled. ring. Qed.
Lemma opening_symmetric x v a b : opening x v a b = opening x v b a.
Proof.
  unfold opening. rewrite (between_opposite x b a), (between_opposite v b a), dot_scaled, dot_scaled_right. ring.
Qed.
Lemma between_flown t x v a b : between (flown t x v) a b = combined 1 (between x a b) t (between v a b).
Proof. apply same_vector. intros k. unfold between, flown, combined. ring. Qed.
Lemma opening_flown t x v a b : 0 <= t -> opening x v a b <= opening (flown t x v) v a b.
Proof.
  intros T. unfold opening. rewrite between_flown, dot_linear. pose proof (dot_self d (between v a b)).
  assert (0 <= t * dot d (between v a b) (between v a b)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma flight_apart s t x v a b : 0 <= opening x v a b -> 0 <= s <= t ->
  apart2 (flown s x v) a b <= apart2 (flown t x v) a b.
Proof.
  intros O T. unfold apart2. rewrite !between_flown, !square_of_combined. fold (opening x v a b).
  pose proof (dot_self d (between v a b)). assert (s * opening x v a b <= t * opening x v a b) by (apply Rmult_le_compat_r; lra).
  assert (s * s * dot d (between v a b) (between v a b) <= t * t * dot d (between v a b) (between v a b)).
  { apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat; lra. } lra.
Qed.
Lemma pair_symmetric i j a b : is_pair i j a b -> is_pair j i a b.
Proof. unfold is_pair. tauto. Qed.
Lemma struck_symmetric x v i j w : struck x v i j w -> struck x v j i w.
Proof.
  intros (N & O & K & J & P & A & B & C). rewrite !(opening_symmetric x _ i j) in *.
  split; [congruence|]. split; [exact O|]. split; [exact K|]. exists J. split; [exact P|]. rewrite (between_opposite x i j).
  split; [intros k; rewrite B; unfold scaled; ring|]. split; [intros k; rewrite A; unfold scaled; ring|]. auto.
Qed.
(* Body a is hit by c. *)
Lemma pushed_on x v w a b c : c <> b -> a <> b -> struck x v a c w -> 0 <= dot d (between x a b) (between x a c) ->
  opening x v a b <= opening x w a b.
Proof.
  intros N M (_ & _ & _ & J & P & A & _ & C) D. unfold opening.
  replace (between w a b) with (combined 1 (between v a b) (J / mass a) (between x a c)).
  - rewrite dot_linear_right. assert (0 <= J / mass a) by (apply Rmult_le_pos; [exact P | now apply Rlt_le, Rinv_0_lt_compat]).
    assert (0 <= J / mass a * dot d (between x a b) (between x a c)) by now apply Rmult_le_pos. lra.
  - apply same_vector. intros k. unfold combined, between. rewrite (C b), A by congruence. unfold between. ring.
Qed.
Variable same_or_not : forall a b : body, {a = b} + {a <> b}.
Lemma kept x v w i j a b : a <> b -> struck x v i j w -> ~ is_pair i j a b -> 0 <= opening x v a b ->
  (forall c, c <> a -> c <> b -> (is_pair i j a c -> 0 <= dot d (between x a b) (between x a c)) /\
    (is_pair i j b c -> 0 <= dot d (between x b a) (between x b c))) -> 0 <= opening x w a b.
Proof.
  intros N S F O H.
  assert (G : forall c, c <> a -> c <> b -> is_pair i j a c \/ is_pair i j b c -> 0 <= opening x w a b).
  { intros c A B [P|P]; destruct (H c A B) as [H1 H2].
    - apply Rle_trans with (1 := O), (pushed_on x v w a b c B N); [|now apply H1].
      destruct P as [[-> ->]|[-> ->]]; [exact S | now apply struck_symmetric].
    - rewrite (opening_symmetric x w), (opening_symmetric x v) in *.
      apply Rle_trans with (1 := O), (pushed_on x v w b a c A (not_eq_sym N)); [|now apply H2].
      destruct P as [[-> ->]|[-> ->]]; [exact S | now apply struck_symmetric]. }
  pose proof S as (M & _ & _ & J & _ & _ & _ & C).
  assert (U : a <> i -> a <> j -> b <> i -> b <> j -> 0 <= opening x w a b).
  { intros A1 A2 B1 B2. unfold opening, between in *. rewrite (C a A1 A2), (C b B1 B2). exact O. }
  unfold is_pair in *.
  destruct (same_or_not i a) as [->|Ia]; [apply (G j); [congruence | intros ->; apply F; now left | left; now left]|].
  destruct (same_or_not i b) as [->|Ib]; [apply (G j); [intros ->; apply F; now right | congruence | right; now left]|].
  destruct (same_or_not j a) as [->|Ja]; [apply (G i); [congruence | congruence | left; now right]|].
  destruct (same_or_not j b) as [->|Jb]; [apply (G i); [congruence | congruence | right; now right]|].
  apply U; congruence.
Qed.

Section History.
Variables x v : nat -> body -> vector.
Variable t : nat -> R.
Variables i j : nat -> body.
Hypothesis run : history x v t i j.
Variables a b : body.
Hypothesis differ : a <> b.
Lemma no_approach n : 0 <= opening (x n) (v n) a b -> ~ is_pair (i n) (j n) a b.
Proof.
  intros O P. destruct (run n) as (T & X & _ & Q & _). rewrite X in Q.
  pose proof (opening_flown (t n) (x n) (v n) a b T) as W.
  destruct P as [[E E']|[E E']]; rewrite E, E' in Q; [|rewrite opening_symmetric in Q]; lra.
Qed.
Lemma stay_open m n : (m <= n)%nat -> 0 <= opening (x m) (v m) a b ->
  (forall k, (m <= k < n)%nat -> hit_from_behind x i j a b k) -> 0 <= opening (x n) (v n) a b.
Proof.
  intros L O H. induction L as [|n L IH]; [exact O|].
  specialize (IH ltac:(intros k K; apply H; lia)). destruct (run n) as (T & X & S).
  apply (kept _ (v n) _ (i n) (j n) a b differ S); [now apply no_approach | | apply H; lia].
  rewrite X. apply Rle_trans with (1 := IH), opening_flown, T.
Qed.
End History.

(* After a collision of a and b, as long as both are only hit so: they do not approach, the distance does
   not fall, and they do not collide. *)
Lemma opens_after x v t i j a b m : history x v t i j -> is_pair (i m) (j m) a b ->
  a <> b /\ 0 <= opening (x (S m)) (v (S m)) a b.
Proof.
  intros R F. destruct (R m) as (_ & _ & N & _ & (K & _) & _).
  destruct F as [[<- <-]|[<- <-]]; (split; [congruence|]); [exact K | now rewrite opening_symmetric].
Qed.
Theorem apart_from_then_on x v t i j a b m n : history x v t i j -> is_pair (i m) (j m) a b -> (m < n)%nat ->
  (forall k, (m < k < n)%nat -> hit_from_behind x i j a b k) ->
  (forall s, 0 <= s -> 0 <= opening (flown s (x n) (v n)) (v n) a b) /\
  (forall s u, 0 <= s <= u -> apart2 (flown s (x n) (v n)) a b <= apart2 (flown u (x n) (v n)) a b) /\
  ~ is_pair (i n) (j n) a b.
Proof.
  intros R F L H. destruct (opens_after x v t i j a b m R F) as (N & A).
  pose proof (stay_open x v t i j R a b N (S m) n L A ltac:(intros k K; apply H; lia)) as O. split; [|split].
  - intros s S. now apply Rle_trans with (1 := O), opening_flown.
  - intros s u S. now apply flight_apart.
  - now apply (no_approach x v t i j R).
Qed.
(* So no pair collides twice without a collision of one of them with another body in between. *)
Theorem one_in_between x v t i j a b m n : history x v t i j -> is_pair (i m) (j m) a b -> (m < n)%nat ->
  is_pair (i n) (j n) a b ->
  ~ forall k, (m < k < n)%nat -> forall c, c <> a -> c <> b -> ~ is_pair (i k) (j k) a c /\ ~ is_pair (i k) (j k) b c.
Proof.
  intros R F L P N. apply (apart_from_then_on x v t i j a b m n R F L); [|exact P].
  intros k K c A B. destruct (N k K c A B). split; intros Q; contradiction.
Qed.
(* Nor does a pair collide that does not approach at first, before one of them is hit from the other side. *)
Theorem not_before x v t i j a b n : history x v t i j -> a <> b -> 0 <= opening (x 0%nat) (v 0%nat) a b ->
  (forall k, (k < n)%nat -> hit_from_behind x i j a b k) -> ~ is_pair (i n) (j n) a b.
Proof.
  intros R N O H. apply (no_approach x v t i j R).
  apply (stay_open x v t i j R a b N 0 n); [lia | exact O|]. intros k K. apply H. lia.
Qed.
End ManyBalls.
