(* Finitely many collisions, one after the other, and then none: that is a trajectory without end. *)
From Coq Require Import Reals List Lra.
From Verify Require Import Theorem1 Vectors Motion.
Import ListNotations.
Open Scope R_scope.

(* --- the page: what the theorem on a scene says ----------------------------------------------- *)

(* Which balls meet, and after which time since the collision before. *)
Definition meeting : Set := (ball * ball * R)%type.

Section Runs.
Variable d : nat.
Variable r : R.

(* From s the next collisions are these, each the first one; afterwards the scene is z. *)
Fixpoint run (s : scene) (l : list meeting) (z : scene) : Prop :=
  match l with
  | [] => z = s
  | (i, j, t) :: rest =>
      i <> j /\ first_to_meet d s i j t /\ run (collided d r i j (later t s)) rest z
  end.
(* The scene at the time t. *)
Fixpoint motion (s : scene) (l : list meeting) (t : R) : scene :=
  match l with
  | [] => later t s
  | (i, j, u) :: rest =>
      if Rlt_dec t u then later t s else motion (collided d r i j (later u s)) rest (t - u)
  end.
(* From s there are these collisions and no others, for ever. *)
Definition disperses (s : scene) (l : list meeting) : Prop :=
  (exists z, run s l z /\ forall t, 0 < t -> nobody_collides d (later t z)) /\
  forall T, trajectory d r s T (motion s l).

(* --- the page for scenes that collapse ---------------------------------------------------------- *)

(* The balls o, s and c of a scene get the names 0, 1 and 2. *)
Definition role (o s c i : ball) : ball := match i with B0 => o | B1 => s | B2 => c end.
Definition renamed (o s c : ball) (x : scene) : scene :=
  Scene (fun i => position x (role o s c i)) (fun i => velocity x (role o s c i)).
(* How long the collisions of a list take. *)
Definition lasts (l : list meeting) : R := fold_right (fun m t => snd m + t) 0 l.
(* From s there are these collisions, and from then on o collides with c and i in turn without end.
   There is a trajectory until the collapse, and none from s lasts longer. The whole takes a time
   between the two times, and minus the cosine of the angle at o is between the two numbers in the
   end. *)
Definition collapses_after (s : scene) (l : list meeting) (o i c : ball)
    (earliest latest least most : R) : Prop :=
  exists z scenes time T Z at_T whole, run s l z /\
    collapses d r (renamed o i c z) scenes time T Z at_T /\
    trajectory d r s (lasts l + T) whole /\
    (forall t, 0 <= t -> renamed o i c (whole (lasts l + t)) = Z t) /\
    (forall T' Z', trajectory d r s T' Z' -> T' <= lasts l + T) /\
    earliest <= lasts l + T <= latest /\ least <= minus_cosine d at_T <= most.

(* --- the proof -------------------------------------------------------------------------------- *)

Lemma run_on s i j t y rest z : i <> j -> first_to_meet d s i j t -> collided d r i j (later t s) = y ->
  run y rest z -> run s ((i, j, t) :: rest) z.
Proof. intros N M <- U. exact (conj N (conj M U)). Qed.
Lemma free_for_ever s : (forall t, 0 < t -> nobody_collides d (later t s)) ->
  forall T, trajectory d r s T (fun t => later t s).
Proof.
  intros N T. split.
  - apply later_0.
  - intros t [L _]. exists 1. split; [lra|]. intros u _. now rewrite later_later.
  - intros t [L _]. exists t, (later t s). split; [exact L|]. split.
    + intros u _. now rewrite later_later.
    + left. split; [now apply N | reflexivity].
Qed.
Lemma one_more_collision s i j u T Z : i <> j -> first_to_meet d s i j u ->
  trajectory d r (collided d r i j (later u s)) T Z ->
  trajectory d r s (u + T) (fun t => if Rlt_dec t u then later t s else Z (t - u)).
Proof.
  intros N [P B C A O] F. split.
  - destruct (Rlt_dec 0 u) as [_|K]; [apply later_0 | now destruct K].
  - intros t [L M']. destruct (Rlt_dec t u) as [K|K].
    + exists (u - t). split; [lra|]. intros v V. destruct (Rlt_dec (t + v) u); [|lra].
      now rewrite later_later.
    + destruct F as [_ G _]. destruct (G (t - u) ltac:(lra)) as (e & E & H).
      exists e. split; [exact E|]. intros v V. destruct (Rlt_dec (t + v) u); [lra|].
      rewrite <- (H v V). f_equal. ring.
  - intros t [L M']. destruct (Rlt_dec t u) as [K|K].
    + exists t, (later t s). split; [exact L|]. split.
      * intros v V. destruct (Rlt_dec (t - v) u); [|lra]. now rewrite later_later.
      * left. split; [|reflexivity]. intros a b M. pose proof (B t a b ltac:(lra) M). split; lra.
    + destruct (Req_dec t u) as [->|M].
      * exists u, (later u s). split; [exact L|]. split.
        -- intros v V. destruct (Rlt_dec (u - v) u); [|lra]. now rewrite later_later.
        -- right. exists i, j. split; [exact N|]. split; [exact C|]. split; [exact A|].
           split; [exact O|]. destruct F as [G _ _]. rewrite Rminus_diag_eq by reflexivity.
           exact G.
      * destruct F as [_ _ G].
        destruct (G (t - u) ltac:(lra)) as (e & w & E & H & Q). exists (Rmin e (t - u)), w.
        split; [apply Rmin_glb_lt; lra|]. split; [|exact Q].
        intros v V. pose proof (Rmin_l e (t - u)). pose proof (Rmin_r e (t - u)).
        destruct (Rlt_dec (t - v) u); [lra|]. rewrite <- (H v ltac:(lra)). f_equal. ring.
Qed.
Theorem run_disperses s l z : run s l z -> (forall t, 0 < t -> nobody_collides d (later t z)) ->
  disperses s l.
Proof.
  intros U F. split; [now exists z|]. revert s U.
  induction l as [|[[i j] u] l IH]; cbn [run motion]; intros s U.
  - subst z. now apply free_for_ever.
  - destruct U as (N & M & U).
    intros T. replace T with (u + (T - u)) by ring.
    exact (one_more_collision s i j u _ _ N M (IH _ U (T - u))).
Qed.

(* A pair that never meets again: it parts, or passes by. *)
Lemma apart_for_ever s i j : 1 <= square d s i j -> 0 <= rate d s i j ->
  forall t, 0 < t -> 1 <= distance d (later t s) i j /\ 0 <= rate d (later t s) i j.
Proof.
  intros S K t L. pose proof (dot_self d (relative s i j)) as A.
  assert (0 <= t * rate d s i j) by (apply Rmult_le_pos; lra).
  assert (0 <= t * dot d (relative s i j) (relative s i j)) by (apply Rmult_le_pos; lra).
  assert (0 <= t * t * dot d (relative s i j) (relative s i j)).
  { apply Rmult_le_pos; [apply Rle_0_sqr | exact A]. }
  split.
  - unfold distance. rewrite <- sqrt_1. apply sqrt_le_1_alt. rewrite to_later, square_of_combined.
    fold (rate d s i j). unfold square in S. lra.
  - unfold rate. rewrite to_later, relative_later, dot_linear. fold (rate d s i j). lra.
Qed.
Lemma passes_by s i j : 0 < dot d (relative s i j) (relative s i j) ->
  rate d s i j ^ 2 < dot d (relative s i j) (relative s i j) * (square d s i j - 1) ->
  forall t, 1 < distance d (later t s) i j.
Proof.
  intros M K t. apply distance_above. unfold square in *. rewrite to_later, square_of_combined.
  fold (rate d s i j). set (m := dot d (relative s i j) (relative s i j)) in *.
  set (p := rate d s i j) in *. set (g := dot d (to s i j) (to s i j)) in *.
  apply Rmult_lt_reg_l with m; [exact M|]. pose proof (Rle_0_sqr (m * t + p)) as Q. unfold Rsqr in Q.
  replace (m * (1 * 1 * g + 2 * 1 * t * p + t * t * m))
    with ((m * t + p) * (m * t + p) + (m * g - p * p)) by ring.
  lra.
Qed.
Definition never_meets (s : scene) (i j : ball) : Prop := forall t, 0 < t ->
  1 <= distance d (later t s) i j /\ (distance d (later t s) i j = 1 -> 0 <= rate d (later t s) i j).
Lemma never_by_parting s i j : 1 <= square d s i j -> 0 <= rate d s i j -> never_meets s i j.
Proof. intros S K t L. destruct (apart_for_ever s i j S K t L). now split. Qed.
Lemma never_by_passing s i j : 0 < dot d (relative s i j) (relative s i j) ->
  rate d s i j ^ 2 < dot d (relative s i j) (relative s i j) * (square d s i j - 1) ->
  never_meets s i j.
Proof. intros M K t _. pose proof (passes_by s i j M K t). split; lra. Qed.
Lemma never_any s o i c : i <> o /\ c <> o /\ i <> c ->
  never_meets s o i -> never_meets s o c -> never_meets s i c ->
  forall t, 0 < t -> nobody_collides d (later t s).
Proof.
  intros (D1 & D2 & D3) P1 P2 P3 t L k l N.
  specialize (P1 t L). specialize (P2 t L). specialize (P3 t L).
  assert (Y : forall k l, 1 <= distance d (later t s) k l /\
      (distance d (later t s) k l = 1 -> 0 <= rate d (later t s) k l) ->
    1 <= distance d (later t s) l k /\
      (distance d (later t s) l k = 1 -> 0 <= rate d (later t s) l k)).
  { intros a b. now rewrite distance_symmetric, rate_symmetric. }
  destruct o, i, c, k, l; try easy; auto.
Qed.
End Runs.
