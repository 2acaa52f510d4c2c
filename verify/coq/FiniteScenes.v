(* Scenes from which only finitely many collisions are possible: the four criteria, by the numbers of a
   state, and what they mean after some collisions. *)
From Coq Require Import Reals List Lra Classical.
From Verify Require Import Theorem1 Vectors Motion Determined Runs Joined FlowStep.
From Verify Require Import Classification Contacts Settling ClassificationProof Calculus Turning Finite.
Import ListNotations.
Open Scope R_scope.

(* From s the next collisions are these; and all collisions, of every trajectory, are at finitely many
   times. *)
Definition finite_after (d : nat) (r : R) (s : scene) (l : list meeting) : Prop :=
  (exists z, run d r s l z) /\ finite d r s.

Lemma never_finite d r s : 0 < r <= 1 -> (forall scenes time i j, ~ endless d r s scenes time i j) -> finite d r s.
Proof.
  intros R N. destruct (finite_or_endless_holds d r s R) as [F|(scenes & time & i & j & E)]; [exact F|].
  now destruct (N scenes time i j).
Qed.
(* One collision more before them. *)
Lemma one_before d r s i j u : 0 < r <= 1 -> i <> j -> first_to_meet d s i j u ->
  finite d r (collided d r i j (later u s)) -> finite d r s.
Proof.
  intros R N M (times & F). set (z := collided d r i j (later u s)) in *.
  exists (u :: map (fun t => u + t) times). intros T Z G t L C. destruct M as [P B K A O].
  assert (M : first_to_meet d s i j u) by (split; assumption).
  assert (V : trajectory d r z 0 (fun t => later t z)).
  { split; [apply later_0 | intros x X; lra | intros x X; lra]. }
  pose proof (one_more_collision d r s i j u 0 _ N M V) as W. rewrite Rplus_0_r in W.
  assert (H : forall x, 0 <= x < u -> x < T -> Z x = later x s).
  { intros x X Y. rewrite <- (agree d r s u T _ Z W G x X Y). destruct (Rlt_dec x u); [reflexivity | lra]. }
  destruct (Rtotal_order t u) as [Q|[->|Q]].
  - exfalso. apply (free_none d r s T Z R G 0 (Rmin u T) t).
    + lra.
    + split; [lra | apply Rmin_glb_lt; lra].
    + apply Rmin_r.
    + intros x X. pose proof (Rmin_l u T). pose proof (Rmin_r u T). rewrite (H x) by lra. rewrite (begins d r s T Z G).
      now rewrite Rminus_0_r.
    + exact C.
  - now left.
  - right. apply in_map_iff. exists (t - u). split; [ring|].
    assert (E : Z u = z).
    { destruct (before_it d r s T Z G u ltac:(lra)) as (e & x & E & X & D).
      assert (XE : x = later u s).
      { apply (same_arriving d r s T Z R G u e u x _ E P X). intros y Y. rewrite H by lra.
        rewrite later_later. reflexivity. }
      subst x. destruct D as [[D _]|D]; [destruct (D i j N) as [_ D']; specialize (D' K); lra|].
      destruct D as (i' & j' & N' & K' & _ & _ & ->).
      destruct (same_two d (later u s) i j i' j' N N' K' O) as [[<- <-]|[<- <-]]; [reflexivity|].
      now apply collided_symmetric. }
    apply (F (T - u) (fun x => Z (u + x)) (shifted d r s z u T Z ltac:(lra) E G)); [lra|].
    destruct C as (e & a & i' & j' & C1 & C2 & C3). exists (Rmin e (t - u)), a, i', j'.
    pose proof (Rmin_l e (t - u)). pose proof (Rmin_r e (t - u)).
    split; [apply Rmin_glb_lt; lra|]. split; [|exact C3]. intros y Y.
    replace (u + (t - u - y)) with (t - y) by ring. apply C2. lra.
Qed.
Theorem run_finite d r l z : 0 < r <= 1 -> finite d r z -> forall s, run d r s l z -> finite_after d r s l.
Proof.
  intros R F s U. split; [now exists z|]. revert s U. induction l as [|[[i j] u] l IH]; cbn [run]; intros s U.
  - now subst z.
  - destruct U as (N & M & U). exact (one_before d r s i j u R N M (IH _ U)).
Qed.

(* --- the criteria --------------------------------------------------------------------------------- *)

Lemma above_7 r : 0 < r <= 1 -> r ^ 2 - 14 * r + 1 < 0 -> 7 - 4 * sqrt 3 < r.
Proof.
  intros R H. pose proof (sqrt_sqrt 3 ltac:(lra)) as S. pose proof (sqrt_pos 3) as P. apply Rnot_le_lt. intros L.
  assert (0 <= (7 - 4 * sqrt 3 - r) * (7 + 4 * sqrt 3 - r)) by (apply Rmult_le_pos; lra). lra.
Qed.
Lemma above_9 r : 0 < r <= 1 -> r ^ 2 - 18 * r + 1 < 0 -> 9 - 4 * sqrt 5 < r.
Proof.
  intros R H. pose proof (sqrt_sqrt 5 ltac:(lra)) as S. pose proof (sqrt_pos 5) as P. apply Rnot_le_lt. intros L.
  assert (0 <= (9 - 4 * sqrt 5 - r) * (9 + 4 * sqrt 5 - r)) by (apply Rmult_le_pos; lra). lra.
Qed.
Theorem finite_by_restitution d r s : 0 < r <= 1 -> r ^ 2 - 14 * r + 1 < 0 -> finite d r s.
Proof.
  intros R H. apply never_finite; [exact R|]. intros scenes time i j. apply never_holds.
  pose proof (above_7 r R H). lra.
Qed.
Theorem finite_outward d r s : 0 < r <= 1 -> 0 <= growth d s -> 6 <= size d s -> finite d r s.
Proof.
  intros R A Z. apply never_finite; [exact R|]. intros scenes time i j. now apply never_outward_holds.
Qed.

(* R^2, A and L^2 of the frame of the centre of mass, by the numbers of a state. *)
Section StateNumbers.
Variable d : nat.
Variable r : R.
Variable x : scene.
Variables o s c : ball.
Variables v lam rho eps sig A B C a b w : R.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis distinct : s <> o /\ c <> o /\ s <> c.
Hypothesis seen : gram d x o s c v lam rho eps sig A B C a b w.
Definition square_size : R := 1 + (eps * v ^ 2 + sig * v ^ 2 + (1 + (eps + sig) * v ^ 2 + 2 * C)) / 3.
Definition total_growth : R := (- (lam * v) + rho * v + ((rho - lam) * v - a - b)) / 3.
Definition square_spin : R :=
  (4 * ((1 + sig * v ^ 2) * B - (rho * v) ^ 2) + 4 * ((1 + eps * v ^ 2) * A - (lam * v) ^ 2) +
   ((1 + sig * v ^ 2) * A - a ^ 2) + ((1 + eps * v ^ 2) * B - b ^ 2) +
   8 * (- C * w - a * b) - 4 * ((1 + sig * v ^ 2) * w - a * (rho * v)) - 4 * (- C * B - rho * v * b) -
   4 * (- C * A - - (lam * v) * a) - 4 * ((1 + eps * v ^ 2) * w - b * - (lam * v)) +
   2 * (- C * w - rho * v * - (lam * v))) / 9.
Lemma outer_to : to x s c = combined (-1) (to x o s) 1 (to x o c).
Proof. apply same_vector. intros k. unfold to, combined. ring. Qed.
Lemma outer_relative : relative x s c = combined (-1) (relative x o s) 1 (relative x o c).
Proof. apply same_vector. intros k. unfold relative, combined. ring. Qed.
Lemma total_seen f : (forall p q, f p q = f q p) -> total f = f o s + f o c + f s c.
Proof.
  intros S. destruct distinct as (D1 & D2 & D3). destruct (total_is f o s S ltac:(congruence)) as (k & K1 & K2 & ->).
  assert (k = c) by (destruct o, s, c, k; easy). now subst k.
Qed.
Lemma size_seen : size d x = 3 * square_size.
Proof.
  rewrite size_is, total_seen by apply square_symmetric. unfold square. rewrite outer_to, square_of_combined.
  destruct seen as [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10]. rewrite G1, G2, G3. unfold square_size. field.
Qed.
Lemma growth_seen : growth d x = 3 * total_growth.
Proof.
  rewrite growth_is, total_seen by apply rate_symmetric. unfold rate. rewrite outer_to, outer_relative.
  rewrite dot_linear, !dot_linear_right. destruct seen as [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10].
  rewrite G4, G5, G6, G7. unfold total_growth. field.
Qed.
Lemma spin_seen : spin2 d x = 9 * square_spin.
Proof.
  assert (E : spin2 d x = turned d x o s o s + turned d x o c o c + turned d x s c s c +
    2 * (turned d x o s o c + turned d x o s s c + turned d x o c s c)).
  { rewrite spin2_is.
    assert (F : forall p q p' q', turned d x p q p' q' = turned d x q p p' q').
    { intros p q p' q'. unfold turned, wedge. rewrite (to_opposite x p q), (relative_opposite x p q), !dot_scaled. ring. }
    assert (F' : forall p q p' q', turned d x p q p' q' = turned d x p q q' p').
    { intros p q p' q'. now rewrite turned_symmetric, F, turned_symmetric. }
    set (f p q := turned d x p q p q). set (t := turned d x).
    assert (SY : forall p q p' q', t p q p' q' = t p' q' p q) by (intros; apply turned_symmetric).
    destruct distinct as (D1 & D2 & D3). fold t in F, F'.
    destruct o, s, c; try easy;
      rewrite ?(F B1 B0), ?(F B2 B0), ?(F B2 B1), ?(F' _ _ B1 B0), ?(F' _ _ B2 B0), ?(F' _ _ B2 B1);
      pose proof (SY B0 B1 B0 B2); pose proof (SY B0 B1 B1 B2); pose proof (SY B0 B2 B1 B2); lra. }
  rewrite E. unfold turned, wedge. rewrite outer_to, outer_relative.
  destruct seen as [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10].
  rewrite ?square_of_combined, ?dot_linear, ?dot_linear_right.
  rewrite ?(dot_symmetric d (to x o c) (to x o s)), ?(dot_symmetric d (relative x o s) (to x o s)),
    ?(dot_symmetric d (relative x o s) (to x o c)), ?(dot_symmetric d (relative x o c) (to x o s)),
    ?(dot_symmetric d (relative x o c) (to x o c)), ?(dot_symmetric d (relative x o c) (relative x o s)).
  rewrite G1, G2, G3, G4, G5, G6, G7, G8, G9, G10. unfold square_spin. field.
Qed.
Theorem finite_by_momentum : r ^ 2 - 18 * r + 1 < 0 -> 0 < square_spin -> finite d r x.
Proof.
  intros H P. apply never_finite; [exact restitutes|]. intros scenes time i j. apply never_with_spin_holds.
  - pose proof (above_9 r restitutes H). lra.
  - rewrite spin_seen. lra.
Qed.
Theorem finite_by_receding : 2 <= square_size -> 0 <= total_growth -> finite d r x.
Proof.
  intros H P. apply finite_outward; [exact restitutes | |].
  - rewrite growth_seen. lra.
  - rewrite size_seen. lra.
Qed.
Theorem finite_by_turning : 0 < (square_size - 2) * square_spin - total_growth ^ 2 * square_size -> finite d r x.
Proof.
  intros H. apply never_finite; [exact restitutes|]. intros scenes time i j. apply never_turning_holds; [exact restitutes|].
  rewrite growth_seen, size_seen, spin_seen. lra.
Qed.
End StateNumbers.
