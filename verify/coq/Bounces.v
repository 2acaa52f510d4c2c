(* A collision of two of three balls, of any masses and radii, after which they part at r times the speed. *)
From Coq Require Import Reals Lra FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Classification Contacts Line.
Open Scope R_scope.

Section Bounces.
Variable d : nat.
Variable mass : ball -> R.
Variable r : R.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis restitutes : 0 < r.
Definition bounced (i j : ball) (s : scene) : scene :=
  let lost := (1 + r) * rate d s i j / distance d s i j ^ 2 / (mass i + mass j) in
  Scene (position s) (fun b k =>
    if same b i then velocity s b k + mass j * lost * to s i j k
    else if same b j then velocity s b k - mass i * lost * to s i j k
    else velocity s b k).
(* The collision is a hit, after which the balls part at r times the speed. *)
Lemma bounced_parts i j z : i <> j -> 0 < distance d z i j -> rate d z i j < 0 ->
  parts d mass r i j z (bounced i j z).
Proof.
  intros N D P. pose proof (heavy i). pose proof (heavy j).
  assert (SQ : dot d (to z i j) (to z i j) = distance d z i j ^ 2)
    by (change (square d z i j = distance d z i j ^ 2); rewrite square_of_distance; ring).
  set (J := mass i * mass j * ((1 + r) * - rate d z i j / distance d z i j ^ 2 / (mass i + mass j))).
  assert (W : hit_with mass J i j z (bounced i j z)).
  { split; [reflexivity|]. intros x k. unfold bounced. cbn [velocity]. unfold J.
    destruct (same x i); [field; repeat split; lra|]. destruct (same x j); [field; repeat split; lra | reflexivity]. }
  exists J. split; [|split; [reflexivity | split; [apply W|]]].
  - apply Rlt_le, Rmult_lt_0_compat; [now apply Rmult_lt_0_compat|]. apply Rdiv_lt_0_compat; [|lra].
    apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat; lra | now apply pow_lt].
  - unfold rate at 1. rewrite (same_places z (bounced i j z)) by reflexivity.
    rewrite (own_velocity mass J i j z _ N W), dot_linear_right, SQ. fold (rate d z i j). unfold J. field. repeat split; lra.
Qed.
End Bounces.
Lemma any_of_three (P : ball -> ball -> Prop) o a c : distinct_balls o a c ->
  (forall i j, P i j -> P j i) -> P o a -> P o c -> P a c -> forall i j, i <> j -> P i j.
Proof. intros (A & C & N) S X Y Z i j M. destruct o, a, c, i, j; try easy; auto. Qed.

(* For equal balls of diameter 1 these collisions are those of Theorem1.v. *)
Definition half (_ : ball) : R := 1 / 2.
Definition one (_ : ball) : R := 1.
Lemma half_positive b : 0 < half b.
Proof. unfold half. lra. Qed.
Lemma one_positive b : 0 < one b.
Proof. unfold one. lra. Qed.
Lemma equal_meets d s i j t : meets_next d half s i j t -> first_to_meet d s i j t.
Proof.
  unfold half. intros (T & N & X & Y & O). split; [exact T | | lra | exact Y |].
  - intros u a b U D. specialize (N u a b U D). lra.
  - intros k K1 K2. destruct (O k K1 K2). lra.
Qed.
Lemma equal_bounced d r i j z : distance d z i j = 1 -> bounced d one r i j z = collided d r i j z.
Proof.
  intros X. unfold bounced, collided, one. rewrite X. f_equal. extensionality b. extensionality k.
  destruct (same b i); [field|]. destruct (same b j); [field | reflexivity].
Qed.
