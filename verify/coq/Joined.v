(* Trajectories put together: finitely many collisions and a trajectory from the scene after them are
   a trajectory, and if that one cannot go on, then the whole cannot. Balls with other names move on
   the same trajectories. *)
From Coq Require Import Reals List Lra FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Determined Runs.
Import ListNotations.
Open Scope R_scope.

(* --- other names ------------------------------------------------------------------------------- *)

Definition named (f : ball -> ball) (x : scene) : scene :=
  Scene (fun i => position x (f i)) (fun i => velocity x (f i)).
Lemma named_twice f g x : (forall i, f (g i) = i) -> named g (named f x) = x.
Proof.
  intros E. destruct x as [p v]. unfold named. cbn [position velocity].
  f_equal; apply functional_extensionality; intros i; now rewrite E.
Qed.

Section Named.
Variable d : nat.
Variable r : R.
Variables f g : ball -> ball.
Hypothesis there : forall i, f (g i) = i.
Hypothesis back : forall i, g (f i) = i.

Lemma named_nobody x : nobody_collides d x -> nobody_collides d (named f x).
Proof.
  intros N i j M. apply (N (f i) (f j)). intros E. apply M. now rewrite <- (back i), <- (back j), E.
Qed.
Lemma same_named i b : same b (g i) = same (f b) i.
Proof.
  destruct (same (f b) i) eqn:E.
  - assert (f b = i) by (destruct (f b), i; easy). subst i. rewrite back. now destruct b.
  - destruct (same b (g i)) eqn:F; trivial.
    assert (b = g i) by (destruct b, (g i); easy). subst b. rewrite there in E. now destruct i.
Qed.
Lemma named_collided x i j :
  named f (collided d r i j x) = collided d r (g i) (g j) (named f x).
Proof.
  unfold collided, named. cbn [position velocity]. f_equal.
  apply functional_extensionality. intros b. apply functional_extensionality. intros k.
  rewrite !same_named. unfold to, rate, relative, to. cbn [position velocity]. now rewrite !there.
Qed.
Lemma named_two x y : two_collide d r x y -> two_collide d r (named f x) (named f y).
Proof.
  intros (i & j & N & C & A & O & ->). exists (g i), (g j).
  assert (E : forall a b, distance d (named f x) a b = distance d x (f a) (f b)) by reflexivity.
  assert (K : rate d (named f x) (g i) (g j) = rate d x i j).
  { change (rate d x (f (g i)) (f (g j)) = rate d x i j). now rewrite !there. }
  rewrite !E, K, !there. split; [intros F; apply N; now rewrite <- (there i), <- (there j), F|].
  split; [exact C|]. split; [exact A|]. split; [|apply named_collided].
  intros k Ki Kj. rewrite !E, !there. apply O; intros F; [apply Ki | apply Kj];
    now rewrite <- (back k), F.
Qed.
Lemma named_trajectory x T Z : trajectory d r x T Z ->
  trajectory d r (named f x) T (fun t => named f (Z t)).
Proof.
  intros [P A Q]. split.
  - now rewrite P.
  - intros t L. destruct (A t L) as (e & E & H). exists e. split; [exact E|]. intros u U.
    now rewrite (H u U).
  - intros t L. destruct (Q t L) as (e & y & E & H & W). exists e, (named f y). split; [exact E|].
    split; [intros u U; now rewrite (H u U)|]. destruct W as [[N ->]|W]; [left | right].
    + split; [now apply named_nobody | reflexivity].
    + now apply named_two.
Qed.
End Named.

(* --- one after the other ------------------------------------------------------------------------ *)

Section Joined.
Variable d : nat.
Variable r : R.

Fixpoint joined (s : scene) (l : list meeting) (Z : R -> scene) (t : R) : scene :=
  match l with
  | [] => Z t
  | (i, j, u) :: rest =>
      if Rlt_dec t u then later t s else joined (collided d r i j (later u s)) rest Z (t - u)
  end.
Lemma lasts_positive l : forall s z, run d r s l z -> 0 <= lasts l.
Proof.
  induction l as [|[[i j] u] l IH]; cbn [run lasts fold_right snd]; intros s z U; [lra|].
  destruct U as (_ & [P _ _ _ _] & U). apply IH in U. unfold lasts in U. lra.
Qed.
Lemma joined_later l Z : forall s z t, run d r s l z -> 0 <= t -> joined s l Z (lasts l + t) = Z t.
Proof.
  induction l as [|[[i j] u] l IH]; cbn [run joined lasts fold_right snd]; intros s z t U L.
  - f_equal. ring.
  - destruct U as (_ & [P _ _ _ _] & U). pose proof (lasts_positive _ _ _ U) as M. unfold lasts in M.
    destruct (Rlt_dec _ u) as [K|_]; [lra|].
    rewrite <- (IH _ _ t U L). f_equal. unfold lasts. ring.
Qed.
Lemma joined_trajectory l Z T z : trajectory d r z T Z ->
  forall s, run d r s l z -> trajectory d r s (lasts l + T) (joined s l Z).
Proof.
  intros G. induction l as [|[[i j] u] l IH]; cbn [run joined lasts fold_right snd]; intros s U.
  - subst z. now rewrite Rplus_0_l.
  - destruct U as (N & M & U). rewrite Rplus_assoc.
    exact (one_more_collision d r s i j u _ _ N M (IH _ U)).
Qed.
Lemma shifted s s' u T Z : 0 <= u -> Z u = s' -> trajectory d r s T Z ->
  trajectory d r s' (T - u) (fun t => Z (u + t)).
Proof.
  intros L E [P A Q]. split.
  - now rewrite Rplus_0_r.
  - intros t H. destruct (A (u + t) ltac:(lra)) as (e & F & G). exists e. split; [exact F|].
    intros v V. rewrite <- (G v V). f_equal. ring.
  - intros t H. destruct (Q (u + t) ltac:(lra)) as (e & y & F & G & W). exists e, y.
    split; [exact F|]. split; [|exact W]. intros v V. rewrite <- (G v V). f_equal. ring.
Qed.
(* If no trajectory from the last scene lasts longer than T, then none from the first one does. *)
Theorem none_lasts_longer l Z T z : trajectory d r z T Z -> 0 < T ->
  (forall T' Z', trajectory d r z T' Z' -> T' <= T) ->
  forall s, run d r s l z -> forall T' Z', trajectory d r s T' Z' -> T' <= lasts l + T.
Proof.
  intros G P M s U T' Z' F. pose proof (lasts_positive _ _ _ U) as L.
  destruct (Rle_lt_dec T' (lasts l)) as [K|K]; [lra|].
  assert (E : Z' (lasts l) = z).
  { rewrite <- (agree d r s (lasts l + T) T' (joined s l Z) Z' (joined_trajectory _ _ _ _ G s U) F);
      [|lra|exact K].
    rewrite <- (Rplus_0_r (lasts l)), (joined_later _ _ _ _ _ U) by lra.
    exact (begins d r z T Z G). }
  pose proof (M _ _ (shifted s z (lasts l) T' Z' L E F)). lra.
Qed.
End Joined.
