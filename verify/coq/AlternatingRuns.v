(* How often one of three balls of equal masses collides with the other two in turn: the bound, and that it
   is attained. *)
From Coq Require Import Reals Arith Lra Lia.
From Verify Require Import Theorem1 Vectors Motion Classification Contacts Line Bounces LineProof Bounds.
Open Scope R_scope.
Set Default Proof Using "All".

Lemma s_next a r n : s a r (S (S n)) = a * s a r (S n) - r * s a r n.
Proof. unfold s. cbn [comparison]. now destruct (comparison a r n). Qed.

Section AtMost.
Variable d : nat.
Variable m : R.
Variable radius : ball -> R.
Variable r : R.
Variable k : nat.
Variable scenes : nat -> scene.
Variable time : nat -> R.
Variables o a c : ball.
Variable most : R.
Hypothesis heavy : 0 < m.
Hypothesis round : forall b, 0 < radius b.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis distinct : distinct_balls o a c.
Hypothesis runs : run d m radius r k scenes time o a c.
Hypothesis bent : forall n, (2 <= n < k)%nat -> (1 + r) / 2 * minus_cosine_at d (scenes n) o a c <= most.

Let next n := if Nat.even n then c else a.
Let other n := if Nat.even n then a else c.
Let arriving n := later (time (S n) - time n) (scenes n).
(* The speed at which a ball recedes from o. *)
Let part s b := rate d s o b / distance d s o b.
Let u n := - part (arriving n) (next n).
Lemma turned n : next (S n) = other n /\ other (S n) = next n.
Proof. unfold next, other. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even n). Qed.
Lemma others n : o <> next n /\ other n <> o /\ other n <> next n.
Proof. destruct distinct as (A & C & N). unfold next, other. destruct (Nat.even n); repeat split; congruence. Qed.
Lemma part_rises s b t : 0 < distance d s o b -> 0 < distance d (later t s) o b -> 0 <= t ->
  part s b <= part (later t s) b.
Proof.
  intros D E T. unfold part. apply Rmult_le_reg_r with (distance d s o b * distance d (later t s) o b); [now apply Rmult_lt_0_compat|].
  replace (rate d s o b / distance d s o b * (distance d s o b * distance d (later t s) o b)) with
    (rate d s o b * distance d (later t s) o b) by (field; lra).
  replace (rate d (later t s) o b / distance d (later t s) o b * (distance d s o b * distance d (later t s) o b)) with
    (rate d (later t s) o b * distance d s o b) by (field; lra).
  pose proof (square_of_distance d s o b) as D2. pose proof (square_of_distance d (later t s) o b) as E2.
  pose proof (cauchy_schwarz d (to s o b) (relative s o b)) as C. fold (square d s o b) (rate d s o b) in C.
  unfold square in E2. rewrite to_later, square_of_combined in E2. fold (square d s o b) (rate d s o b) in E2.
  unfold rate at 2. rewrite to_later, relative_later, dot_linear. fold (rate d s o b).
  pose proof (dot_self d (relative s o b)) as W0. set (p := rate d s o b) in *. set (W := dot d (relative s o b) (relative s o b)) in *.
  rewrite D2 in C, E2. set (x := distance d s o b) in *. set (y := distance d (later t s) o b) in *.
  assert (TW : 0 <= t * W) by now apply Rmult_le_pos.
  assert (G : 0 <= x * x * W - p * p) by lra.
  replace ((1 * p + t * W) * x) with ((p + t * W) * x) by ring.
  assert (SQ : (p + t * W) * x * ((p + t * W) * x) - p * y * (p * y) = t * (2 * p + t * W) * (x * x * W - p * p)).
  { replace (p * y * (p * y)) with (p * p * (y * y)) by ring. rewrite <- E2. ring. }
  destruct (Rle_lt_dec p 0) as [P|P].
  - destruct (Rle_lt_dec 0 (p + t * W)) as [Q|Q].
    + apply Rle_trans with 0; [|apply Rmult_le_pos; lra]. assert (0 <= - p * y) by (apply Rmult_le_pos; lra). lra.
    + apply Ropp_le_cancel, Rnot_lt_le. intros L. assert (N1 : 0 <= - (p * y)) by (assert (0 <= - p * y) by (apply Rmult_le_pos; lra); lra).
      assert (- (p * y) * - (p * y) < - ((p + t * W) * x) * - ((p + t * W) * x)) by (apply Rmult_le_0_lt_compat; lra).
      assert (0 <= t * - (2 * p + t * W) * (x * x * W - p * p)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact G]). lra.
  - apply Rnot_lt_le. intros L. assert (0 <= (p + t * W) * x) by (apply Rmult_le_pos; lra).
    assert ((p + t * W) * x * ((p + t * W) * x) < p * y * (p * y)) by (apply Rmult_le_0_lt_compat; lra).
    assert (0 <= t * (2 * p + t * W) * (x * x * W - p * p)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact G]). lra.
Qed.

Section Collision.
Variable n : nat.
Hypothesis within : (n < k)%nat.
Let e := to (arriving n) o (next n).
Lemma collides : 0 < time (S n) - time n /\ distance d (arriving n) o (next n) = radius o + radius (next n) /\
  rate d (arriving n) o (next n) < 0 /\ radius o + radius (other n) <= distance d (arriving n) o (other n) /\
  position (scenes (S n)) = position (arriving n) /\ even_hit d r o (next n) (arriving n) (scenes (S n)).
Proof.
  destruct (runs n within) as ((N & T & C & P & O & H) & V). change (if Nat.even n then c else a) with (next n) in *.
  fold (arriving n) in *. destruct (others n) as (_ & M & _). pose proof H as (J & _ & X & _).
  split; [exact T|]. split; [exact C|]. split; [exact P|]. split; [apply O; congruence|]. split; [exact X|].
  exact (even_hit_of d m r o (next n) _ _ heavy H V).
Qed.
Lemma apart b : (b = next n \/ b = other n) -> 0 < distance d (arriving n) o b.
Proof.
  destruct collides as (_ & C & _ & O & _). pose proof (round o). pose proof (round b). intros [-> | ->]; lra.
Qed.
Lemma after b : distance d (scenes (S n)) o b = distance d (arriving n) o b.
Proof. destruct collides as (_ & _ & _ & _ & X & _). unfold distance. now rewrite (same_places _ _ o b X). Qed.
Lemma u_positive : 0 < u n.
Proof.
  destruct collides as (_ & _ & P & _). pose proof (apart (next n) (or_introl eq_refl)). unfold u, part.
  replace (- (rate d (arriving n) o (next n) / distance d (arriving n) o (next n))) with
    (- rate d (arriving n) o (next n) / distance d (arriving n) o (next n)) by (unfold Rdiv; ring). apply Rdiv_lt_0_compat; lra.
Qed.
Lemma recedes : part (scenes (S n)) (next n) = r * u n.
Proof.
  destruct collides as (_ & _ & _ & _ & _ & _ & E). unfold u, part. rewrite after, E. unfold Rdiv. ring.
Qed.
Lemma pushed : part (scenes (S n)) (other n) =
  part (arriving n) (other n) - (1 + r) / 2 * minus_cosine_at d (scenes (S n)) o a c * u n.
Proof.
  destruct collides as (_ & _ & _ & _ & X & H). destruct (others n) as (N & M & O).
  pose proof (apart (next n) (or_introl eq_refl)) as D. pose proof (apart (other n) (or_intror eq_refl)) as D'.
  assert (S0 : 0 < square d (arriving n) o (next n)) by (rewrite square_of_distance; now apply Rmult_lt_0_compat).
  assert (C : dot d (to (arriving n) o (next n)) (to (arriving n) o (other n)) = - (minus_cosine_at d (scenes (S n)) o a c *
    distance d (arriving n) o (next n) * distance d (arriving n) o (other n))).
  { unfold minus_cosine_at. rewrite !after, !(same_places _ _ _ _ X). unfold next, other in *. destruct (Nat.even n).
    - rewrite (dot_symmetric d (to (arriving n) o c)). field. split; lra.
    - field. split; lra. }
  unfold part at 1, rate. rewrite after, (same_places _ _ _ _ X), (even_velocity d r o (next n) (other n) _ _ N M O S0 H), dot_linear_right.
  rewrite (dot_symmetric d (to (arriving n) o (other n)) (to (arriving n) o (next n))), C, square_of_distance.
  fold (rate d (arriving n) o (other n)). unfold u, part. field. split; lra.
Qed.
End Collision.
Lemma recursion n : (S (S n) < k)%nat -> u (S (S n)) <= most * u (S n) - r * u n.
Proof.
  intros K. destruct (turned n) as [T1 T2]. destruct (turned (S n)) as [T3 T4].
  pose proof (recedes n ltac:(lia)) as P. pose proof (pushed (S n) ltac:(lia)) as Q. rewrite T2 in Q.
  destruct (collides (S n) ltac:(lia)) as (F1 & _). destruct (collides (S (S n)) ltac:(lia)) as (F2 & _).
  pose proof (apart n ltac:(lia) (next n) (or_introl eq_refl)) as A1. rewrite <- (after n ltac:(lia)) in A1.
  pose proof (apart (S n) ltac:(lia) (next n) ltac:(right; now rewrite T2)) as A2.
  pose proof A2 as A3. rewrite <- (after (S n) ltac:(lia)) in A3.
  pose proof (apart (S (S n)) ltac:(lia) (next n) ltac:(left; now rewrite T3, T2)) as A4.
  pose proof (part_rises (scenes (S n)) (next n) _ A1 A2 (Rlt_le _ _ F1)) as R1. fold (arriving (S n)) in R1.
  pose proof (part_rises (scenes (S (S n))) (next n) _ A3 A4 (Rlt_le _ _ F2)) as R2. fold (arriving (S (S n))) in R2.
  pose proof (bent (S (S n)) ltac:(lia)) as B. pose proof (u_positive (S n) ltac:(lia)) as U.
  assert ((1 + r) / 2 * minus_cosine_at d (scenes (S (S n))) o a c * u (S n) <= most * u (S n)) by (apply Rmult_le_compat_r; lra).
  unfold u at 1. rewrite T3, T2. lra.
Qed.
Lemma compared n : (S n < k)%nat -> 0 <= s most r n /\ u (S n) * s most r n < u n * s most r (S n).
Proof.
  induction n as [|n IH]; intros K.
  - unfold s. cbn. pose proof (u_positive 0 ltac:(lia)). lra.
  - destruct (IH ltac:(lia)) as [A B]. pose proof (recursion n K) as R1. pose proof (u_positive n ltac:(lia)) as U0.
    pose proof (u_positive (S n) ltac:(lia)) as U1.
    assert (P : 0 < s most r (S n)).
    { apply Rmult_lt_reg_l with (u n); [exact U0|]. assert (0 <= u (S n) * s most r n) by (apply Rmult_le_pos; lra). lra. }
    split; [lra|]. rewrite s_next.
    assert (u (S (S n)) * s most r (S n) <= (most * u (S n) - r * u n) * s most r (S n)) by (apply Rmult_le_compat_r; lra).
    assert (r * (u (S n) * s most r n) < r * (u n * s most r (S n))) by (apply Rmult_lt_compat_l; lra). lra.
Qed.
Theorem run_at_most n : (1 <= n < k)%nat -> 0 < s most r n.
Proof.
  intros K. destruct n as [|n]; [lia|]. destruct (compared n ltac:(lia)) as [A B].
  pose proof (u_positive n ltac:(lia)) as U0. pose proof (u_positive (S n) ltac:(lia)) as U1.
  apply Rmult_lt_reg_l with (u n); [exact U0|]. assert (0 <= u (S n) * s most r n) by (apply Rmult_le_pos; lra). lra.
Qed.
End AtMost.

Theorem run_theorem_holds : run_theorem.
Proof.
  intros d m radius r k scenes time o a c most M P R D S B n K.
  exact (run_at_most d m radius r k scenes time o a c most M P R D S B n K).
Qed.
Theorem run_without_end_holds : run_without_end.
Proof.
  intros r [R0 R1] n N. pose proof (sqrt_pos 3) as P3. pose proof (sqrt_sqrt 3 ltac:(lra)) as S3.
  assert (B : 4 * r <= (1 + r) / 2 * ((1 + r) / 2)).
  { assert (0 <= (7 - 4 * sqrt 3 - r) * (7 + 4 * sqrt 3 - r)) by (apply Rmult_le_pos; lra). lra. }
  set (a := (1 + r) / 2) in *. assert (A : 0 < a) by (unfold a; lra).
  assert (G : forall n, 0 <= s a r n /\ 0 < s a r (S n) /\ a / 2 * s a r n <= s a r (S n)).
  { induction n0 as [|m (IH0 & IH1 & IH2)]; [unfold s; cbn [comparison fst]; repeat split; lra|]. rewrite s_next.
    assert (r * s a r m <= a * a / 4 * s a r m) by (apply Rmult_le_compat_r; lra).
    assert (a / 2 * (a / 2 * s a r m) <= a / 2 * s a r (S m)) by (apply Rmult_le_compat_l; lra).
    assert (0 < a / 2 * s a r (S m)) by (apply Rmult_lt_0_compat; lra). lra. }
  destruct n as [|n]; [lia|]. apply G.
Qed.

(* --- on a line ---------------------------------------------------------------------------------- *)

Definition axis : vector := fun k => match k with O => 1 | _ => 0 end.
Lemma axis_unit d : (1 <= d)%nat -> dot d axis axis = 1.
Proof.
  intros L. induction L as [|d L IH]; [cbn; ring|]. cbn [dot]. rewrite IH. destruct d; [lia | cbn; ring].
Qed.
Section RunOnALine.
Variable d : nat.
Variable m : R.
Variable radius : ball -> R.
Variable r : R.
Variable k : nat.
Variables o a c : ball.
Hypothesis space : (1 <= d)%nat.
Hypothesis heavy : 0 < m.
Hypothesis round : forall b, 0 < radius b.
Hypothesis restitutes : 0 < r <= 1.
Hypothesis distinct : distinct_balls o a c.
Let alpha := (1 + r) / 2.
Hypothesis terms : forall n, (1 <= n < k)%nat -> 0 < s alpha r n.
Let mass (_ : ball) := m.
Lemma mass_positive b : 0 < mass b. Proof. exact heavy. Qed.
Lemma share_is b : share mass r o b = alpha.
Proof. unfold share, mass, alpha. field. lra. Qed.
(* The second closing speed is large enough. *)
Lemma large_enough : exists x, 0 < x /\ forall n, (S n < k)%nat -> r * s alpha r n < x * s alpha r (S n).
Proof.
  clear distinct. assert (G : forall K, (K <= k)%nat -> exists x, 0 < x /\ forall n, (S n < K)%nat -> r * s alpha r n < x * s alpha r (S n)).
  { induction K as [|K IH]; intros L; [exists 1; split; [lra | intros; lia]|].
    destruct (IH ltac:(lia)) as (x & X & H). destruct K as [|K]; [exists 1; split; [lra | intros; lia]|].
    pose proof (terms (S K) ltac:(lia)) as P. exists (x + Rabs (r * s alpha r K / s alpha r (S K))).
    pose proof (Rabs_pos (r * s alpha r K / s alpha r (S K))) as A. split; [lra|]. intros n N.
    pose proof (terms (S n) ltac:(lia)) as Q.
    destruct (Nat.eq_dec n K) as [->|NE].
    - pose proof (Rle_abs (r * s alpha r K / s alpha r (S K))) as B.
      replace (r * s alpha r K) with (r * s alpha r K / s alpha r (S K) * s alpha r (S K)) at 1 by (field; lra).
      apply Rmult_lt_compat_r; lra.
    - specialize (H n ltac:(lia)). assert (0 <= Rabs (r * s alpha r K / s alpha r (S K)) * s alpha r (S n)) by (apply Rmult_le_pos; lra). lra. }
  exact (G k (le_n k)).
Qed.
Variable x : R.
Hypothesis x_positive : 0 < x.
Hypothesis large : forall n, (S n < k)%nat -> r * s alpha r n < x * s alpha r (S n).
(* How far the other ball is from contact, the distance to close, and both speeds. *)
Definition numbers : nat -> R * R * R * R := fix numbers n := match n with
  | O => (1 - (alpha - x), 1, alpha - x, 1)
  | S n => let '(g, gap, v, w) := numbers n in (0, g + gap / w * v, r * w, alpha * w - v)
  end.
Definition slack_at n := fst (fst (fst (numbers n))).
Definition gap_at n := snd (fst (fst (numbers n))).
Definition away_at n := snd (fst (numbers n)).
Definition closing_at n := snd (numbers n).
Let next n := if Nat.even n then c else a.
Let other n := if Nat.even n then a else c.
Let reach b := radius o + radius b.
Definition start : scene :=
  Scene (fun b l => (if same b a then - (reach a + slack_at 0) else if same b c then reach c + gap_at 0 else 0) * axis l)
    (fun b l => (if same b a then - away_at 0 else if same b c then - closing_at 0 else 0) * axis l).
Fixpoint scenes (n : nat) : scene := match n with
  | O => start
  | S n => bounced d mass r o (next n) (later (gap_at n / closing_at n) (scenes n))
  end.
Fixpoint time (n : nat) : R := match n with O => 0 | S n => time n + gap_at n / closing_at n end.
Let direction n := if Nat.even n then axis else scaled (-1) axis.
Lemma numbers_next n : slack_at (S n) = 0 /\ gap_at (S n) = slack_at n + gap_at n / closing_at n * away_at n /\
  away_at (S n) = r * closing_at n /\ closing_at (S n) = alpha * closing_at n - away_at n.
Proof.
  unfold slack_at, gap_at, away_at, closing_at. cbn [numbers]. now destruct (numbers n) as [[[g p] v] w].
Qed.
Lemma closings n : closing_at (S n) = x * s alpha r (S n) - r * s alpha r n /\
  closing_at (S (S n)) = x * s alpha r (S (S n)) - r * s alpha r (S n).
Proof.
  assert (N : forall n, closing_at (S (S n)) = alpha * closing_at (S n) - r * closing_at n).
  { intros p. destruct (numbers_next (S p)) as (_ & _ & _ & ->). now destruct (numbers_next p) as (_ & _ & -> & _). }
  induction n as [|n [IH IH']].
  - rewrite N. destruct (numbers_next 0) as (_ & _ & _ & ->). unfold closing_at, away_at, s. cbn. split; ring.
  - split; [exact IH'|]. rewrite N, IH', IH, !s_next. ring.
Qed.
Lemma closing_positive n : (n < k)%nat -> 0 < closing_at n.
Proof.
  intros L. destruct n as [|n]; [unfold closing_at; cbn; lra|]. destruct (closings n) as [-> _]. specialize (large n L). lra.
Qed.
Lemma turns n : next (S n) = other n /\ other (S n) = next n.
Proof. unfold next, other. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even n). Qed.
Lemma three n : distinct_balls o (other n) (next n).
Proof. destruct distinct as (A & C & N). unfold next, other. destruct (Nat.even n); repeat split; congruence. Qed.
(* Before collision n, on a line, the other ball does not touch when o meets the next. *)
Definition ready (n : nat) : Prop :=
  aligned d (direction n) (scenes n) o (other n) (next n) (reach (other n) + slack_at n) (reach (next n) + gap_at n)
    (away_at n) (closing_at n) /\
  0 <= slack_at n /\ 0 < gap_at n /\ 0 < slack_at n + gap_at n / closing_at n * away_at n.
Lemma ready_at n : (n < k)%nat -> ready n.
Proof.
  induction n as [|n IH]; intros L.
  - unfold ready, next, other, direction. cbn [Nat.even]. unfold slack_at, gap_at, away_at, closing_at. cbn [numbers fst snd].
    assert (A1 : alpha <= 1) by (unfold alpha; lra). split; [|repeat split; lra].
    split; [exact (axis_unit d space)|]. intros l _. destruct distinct as (N1 & N2 & N3).
    unfold to, relative. cbn [scenes start position velocity]. unfold slack_at, gap_at, away_at, closing_at. cbn [numbers fst snd].
    rewrite !same_true, (same_false o a), (same_false o c), (same_false c a) by congruence. repeat split; ring.
  - destruct (IH ltac:(lia)) as (A & S0 & G & F). destruct (turns n) as [T1 T2]. pose proof (closing_positive n ltac:(lia)) as W.
    destruct (numbers_next n) as (E1 & E2 & E3 & E4). unfold ready. rewrite T1, T2, E1, E2, E3, E4.
    pose proof (next_state d mass radius r mass_positive round _ _ o (other n) (next n) _ _ _ _ (three n) A W) as N.
    rewrite share_is in N. replace (direction (S n)) with (scaled (-1) (direction n)).
    + split; [|split; [lra|]].
      * replace (reach (next n) + 0) with (radius o + radius (next n)) by (unfold reach; ring).
        replace (reach (other n) + (slack_at n + gap_at n / closing_at n * away_at n)) with
          (radius o + radius (other n) + slack_at n + gap_at n / closing_at n * away_at n) by (unfold reach; ring). exact N.
      * split; [exact F|]. rewrite Rplus_0_l. apply Rmult_lt_0_compat.
        -- apply Rdiv_lt_0_compat; [exact F|]. rewrite <- E4. exact (closing_positive (S n) L).
        -- apply Rmult_lt_0_compat; lra.
    + unfold direction. rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even n); cbn [negb]; [reflexivity|].
      apply same_vector. intros l. unfold scaled. ring.
Qed.
Theorem attained n : (n < k)%nat -> let t := time (S n) - time n in
  meets_next d radius (scenes n) o (next n) t /\
  parts d mass r o (next n) (later t (scenes n)) (scenes (S n)) /\ minus_cosine_at d (scenes n) o a c = 1.
Proof.
  intros L. destruct (ready_at n L) as (A & S0 & G & F). pose proof (closing_positive n L) as W. cbn zeta.
  replace (time (S n) - time n) with (gap_at n / closing_at n) by (cbn [time]; ring).
  pose proof (next_meeting d radius round _ _ o (other n) (next n) _ _ _ _ (three n) A S0 G W F) as M.
  split; [exact M|]. split.
  - destruct M as (_ & _ & C & P & _). cbn [scenes]. apply (bounced_parts d mass r mass_positive (proj1 restitutes)); trivial.
    + destruct (three n) as (_ & N & _). congruence.
    + fold (scenes n). rewrite C. pose proof (round o). pose proof (round (next n)). lra.
  - pose proof (round o) as Ro. pose proof (round (next n)) as Rn. pose proof (round (other n)) as Rt.
    pose proof (behind d _ _ _ _ _ _ _ _ _ A ltac:(unfold reach; lra)) as D1. pose proof (ahead d _ _ _ _ _ _ _ _ _ A ltac:(unfold reach; lra)) as D2.
    assert (I : dot d (to (scenes n) o (other n)) (to (scenes n) o (next n)) = - (distance d (scenes n) o (other n) * distance d (scenes n) o (next n))).
    { rewrite D1, D2. rewrite (on_line d _ _ _ _ _ _ _ _ _ A _ _ (- (reach (other n) + slack_at n)) (reach (next n) + gap_at n)); [ring|].
      intros l K. destruct A as [_ A]. destruct (A l K) as (X1 & _ & X2 & _). now split. }
    assert (Z : distance d (scenes n) o (other n) * distance d (scenes n) o (next n) <> 0).
    { rewrite D1, D2. apply Rgt_not_eq, Rmult_lt_0_compat; unfold reach; lra. }
    unfold minus_cosine_at. unfold next, other in *. destruct (Nat.even n).
    + rewrite I. field. split; intros E; apply Z; rewrite E; ring.
    + rewrite (dot_symmetric d (to (scenes n) o a)), I. field. split; intros E; apply Z; rewrite E; ring.
Qed.
End RunOnALine.
Theorem run_on_a_line_holds : run_on_a_line.
Proof.
  intros d m radius r k o a c L M P R D T. destruct (large_enough d m radius r k o a c L M P R D T) as (x & X & H).
  exists (scenes d m radius r o a c x), (time r x). intros n N.
  exact (attained d m radius r k o a c L M P R D T x X H n N).
Qed.
