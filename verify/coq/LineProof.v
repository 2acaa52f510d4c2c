(* What Line.v says is proved: by induction on the number of collisions, with a bound of the ratio of the
   speeds, and of the time that is left. *)
From Coq Require Import Reals Arith Lra Lia FunctionalExtensionality.
From Verify Require Import Theorem1 Vectors Motion Sequences InTurn Ending Classification Contacts.
From Verify Require Import ClassificationProof Line Bounces.
Open Scope R_scope.

Lemma same_dot d u u' v v' : (forall k, (k < d)%nat -> u k = u' k /\ v k = v' k) -> dot d u v = dot d u' v'.
Proof.
  induction d as [|d IH]; intros E; [reflexivity|]. cbn [dot]. destruct (E d) as [-> ->]; [lia|].
  rewrite IH; [reflexivity|]. intros k K. apply E. lia.
Qed.

Section OnTheLine.
Variable d : nat.
Variables mass radius : ball -> R.
Variable r : R.
Hypothesis heavy : forall b, 0 < mass b.
Hypothesis round : forall b, 0 < radius b.
Hypothesis restitutes : 0 < r.

(* Ball a is at the distance p behind o, c at the distance q before it; v and w are their speeds. *)
Definition aligned (e : vector) (s : scene) (o a c : ball) (p q v w : R) : Prop :=
  dot d e e = 1 /\ forall k, (k < d)%nat -> to s o a k = - p * e k /\ relative s o a k = - v * e k /\
    to s o c k = q * e k /\ relative s o c k = - w * e k.

Section OneFlight.
Variable e : vector.
Variable s : scene.
Variables o a c : ball.
Variables p q v w : R.
Hypothesis line : aligned e s o a c p q v w.
Lemma aligned_later t : aligned e (later t s) o a c (p + t * v) (q - t * w) v w.
Proof.
  destruct line as [U L]. split; [exact U|]. intros k K. destruct (L k K) as (A & B & C & D).
  rewrite !to_later, !relative_later. unfold combined. rewrite A, B, C, D. repeat split; ring.
Qed.
Lemma on_line (f g : vector) x y : (forall k, (k < d)%nat -> f k = x * e k /\ g k = y * e k) -> dot d f g = x * y.
Proof.
  intros F. rewrite (same_dot d f (scaled x e) g (scaled y e) F), dot_scaled, dot_scaled_right.
  destruct line as [-> _]. ring.
Qed.
Lemma behind : 0 <= p -> distance d s o a = p.
Proof.
  intros P. unfold distance. rewrite (on_line _ _ (- p) (- p)).
  - replace (- p * - p) with (p * p) by ring. now apply sqrt_square.
  - intros k K. destruct line as [_ L]. now destruct (L k K) as (A & _).
Qed.
Lemma ahead : 0 <= q -> distance d s o c = q.
Proof.
  intros P. unfold distance. rewrite (on_line _ _ q q); [now apply sqrt_square|].
  intros k K. destruct line as [_ L]. now destruct (L k K) as (_ & _ & C & _).
Qed.
Lemma outside : 0 <= p + q -> distance d s a c = p + q.
Proof.
  intros P. unfold distance. rewrite (on_line _ _ (p + q) (p + q)); [now apply sqrt_square|].
  intros k K. destruct line as [_ L]. destruct (L k K) as (A & _ & C & _).
  assert (to s a c k = (p + q) * e k); [|tauto].
  replace (to s a c k) with (to s o c k - to s o a k) by (unfold to; ring). rewrite A, C. ring.
Qed.
Lemma ahead_rate : rate d s o c = - (q * w).
Proof.
  unfold rate. rewrite (on_line _ _ q (- w)); [ring|]. intros k K. destruct line as [_ L].
  destruct (L k K) as (_ & _ & C & D). now split.
Qed.
End OneFlight.

(* One collision with c, at which a does not touch, though it may have been in contact before. *)
Section OneCollision.
Variable e : vector.
Variable s : scene.
Variables o a c : ball.
Variables slack gap v w : R.
Hypothesis distinct : distinct_balls o a c.
Hypothesis line : aligned e s o a c (radius o + radius a + slack) (radius o + radius c + gap) v w.
Hypothesis apart : 0 <= slack.
Hypothesis open : 0 < gap.
Hypothesis approaches : 0 < w.
Let t := gap / w.
Hypothesis stays : 0 < slack + t * v.
Lemma duration : 0 < t.
Proof. now apply Rdiv_lt_0_compat. Qed.
Lemma duration_is : t * w = gap.
Proof. unfold t. field. lra. Qed.
Lemma next_meeting : meets_next d radius s o c t.
Proof.
  pose proof duration as T. pose proof duration_is as W. pose proof (round o). pose proof (round a). pose proof (round c).
  assert (Y : forall x, 0 < x <= t -> 0 < slack + x * v).
  { intros x X. destruct (Rle_lt_dec 0 v) as [V|V].
    - destruct (Rle_lt_or_eq_dec _ _ apart) as [S0|S0]; [assert (0 <= x * v) by (apply Rmult_le_pos; lra); lra|].
      rewrite <- S0 in *. assert (0 < v) by (apply Rmult_lt_reg_l with t; lra). rewrite Rplus_0_l. apply Rmult_lt_0_compat; lra.
    - assert (0 <= (t - x) * - v) by (apply Rmult_le_pos; lra). lra. }
  assert (M : 0 < radius o + radius c + gap - t * w) by lra.
  pose proof (aligned_later _ _ _ _ _ _ _ _ _ line t) as L.
  pose proof (Y t ltac:(lra)) as YT.
  split; [exact T|]. split.
  - intros u i j U N. revert i j N. pose proof (aligned_later _ _ _ _ _ _ _ _ _ line u) as F.
    assert (0 < (t - u) * w) by (apply Rmult_lt_0_compat; lra). pose proof (Y u ltac:(lra)).
    apply (any_of_three _ o a c distinct).
    + intros i j B. rewrite distance_symmetric, Rplus_comm. exact B.
    + rewrite (behind _ _ _ _ _ _ _ _ _ F); lra.
    + rewrite (ahead _ _ _ _ _ _ _ _ _ F); lra.
    + rewrite (outside _ _ _ _ _ _ _ _ _ F); lra.
  - split; [rewrite (ahead _ _ _ _ _ _ _ _ _ L); lra|]. split.
    + rewrite (ahead_rate _ _ _ _ _ _ _ _ _ L). pose proof (Rmult_lt_0_compat _ _ M approaches). lra.
    + intros k N1 N2. destruct distinct as (D1 & D2 & D3). assert (k = a) as -> by (destruct o, a, c, k; congruence).
      rewrite (behind _ _ _ _ _ _ _ _ _ L) by lra. rewrite (distance_symmetric d _ c a), (outside _ _ _ _ _ _ _ _ _ L) by lra. lra.
Qed.
Lemma reversed : dot d (scaled (-1) e) (scaled (-1) e) = 1.
Proof. destruct line as [U _]. rewrite dot_scaled, dot_scaled_right, U. ring. Qed.
Lemma next_state : aligned (scaled (-1) e) (bounced d mass r o c (later t s)) o c a
  (radius o + radius c) (radius o + radius a + slack + t * v) (r * w) (share mass r o c * w - v).
Proof.
  pose proof (aligned_later _ _ _ _ _ _ _ _ _ line t) as L. rewrite duration_is in L.
  pose proof (round o). pose proof (round c). set (R := radius o + radius c) in *.
  replace (R + gap - gap) with R in L by ring. set (z := later t s) in *.
  assert (P : 0 < R) by (unfold R; lra).
  pose proof (ahead _ _ _ _ _ _ _ _ _ L (Rlt_le _ _ P)) as D. pose proof (ahead_rate _ _ _ _ _ _ _ _ _ L) as F.
  split; [exact reversed|]. intros k K. destruct L as [_ L]. destruct (L k K) as (A & B & C & E).
  pose proof (heavy o). pose proof (heavy c). destruct distinct as (N1 & N2 & N3).
  change (to (bounced d mass r o c z) o c) with (to z o c). change (to (bounced d mass r o c z) o a) with (to z o a).
  unfold scaled. split; [rewrite C; ring|]. split; [|split; [rewrite A; ring|]].
  - transitivity (relative z o c k - (1 + r) * rate d z o c / distance d z o c ^ 2 * to z o c k).
    + unfold relative, bounced. cbn [velocity]. rewrite !same_true, (same_false c o) by congruence. 
      rewrite D. field. split; lra.
    + rewrite E, C, D, F. field. lra.
  - transitivity (relative z o a k - mass c * ((1 + r) * rate d z o c / distance d z o c ^ 2 / (mass o + mass c)) * to z o c k).
    + unfold relative, bounced. cbn [velocity]. rewrite !same_true, (same_false a o), (same_false a c) by congruence. ring.
    + rewrite B, C, D, F. unfold share. field. split; lra.
Qed.
End OneCollision.

(* --- all collisions ------------------------------------------------------------------------------- *)

Section Collisions.
Variable e : vector.
Variable s : scene.
Variables o a c : ball.
Variables away gap closing Q : R.
Hypothesis distinct : distinct_balls o a c.
Hypothesis line : on_a_line d radius e s o a c away gap closing.
Hypothesis away_positive : 0 < away.
Hypothesis gap_positive : 0 < gap.
Hypothesis closing_positive : 0 < closing.
Hypothesis slow : away <= Q * share mass r o c * closing.
Hypothesis small : 2 * Q < 1.
Hypothesis fixed : r <= share mass r o c * share mass r o a * Q * (1 - Q).

Definition next_of (n : nat) : ball := if Nat.even n then c else a.
Definition last_of (n : nat) : ball := if Nat.even n then a else c.
Definition speeds : nat -> R * R * R := fix speeds n := match n with
  | O => (gap, away, closing)
  | S n => let '(g, v, w) := speeds n in (g / w * v, r * w, share mass r o (next_of n) * w - v)
  end.
Definition gap_at n := fst (fst (speeds n)).
Definition away_at n := snd (fst (speeds n)).
Definition closing_at n := snd (speeds n).
Fixpoint scenes (n : nat) : scene := match n with
  | O => s
  | S n => bounced d mass r o (next_of n) (later (gap_at n / closing_at n) (scenes n))
  end.
Fixpoint time (n : nat) : R := match n with O => 0 | S n => time n + gap_at n / closing_at n end.
Let direction n := if Nat.even n then e else scaled (-1) e.
Lemma share_positive b : 0 < share mass r o b.
Proof.
  unfold share. pose proof (heavy o). pose proof (heavy b). apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra.
Qed.
Lemma Q_positive : 0 < Q.
Proof.
  apply Rnot_le_lt. intros N. pose proof (share_positive c) as B.
  set (b := share mass r o c) in *. assert (0 <= - Q * (b * closing)).
  { apply Rmult_le_pos; [|apply Rmult_le_pos]; lra. }
  lra.
Qed.
Lemma shares n : r <= share mass r o (next_of n) * share mass r o (last_of n) * Q * (1 - Q).
Proof.
  unfold next_of, last_of. destruct (Nat.even n); [exact fixed|].
  rewrite (Rmult_comm (share mass r o a)). exact fixed.
Qed.
Lemma numbers_next n : gap_at (S n) = gap_at n / closing_at n * away_at n /\ away_at (S n) = r * closing_at n /\
  closing_at (S n) = share mass r o (next_of n) * closing_at n - away_at n.
Proof. unfold gap_at, away_at, closing_at. cbn [speeds]. now destruct (speeds n) as [[g v] w]. Qed.
Definition rest : R := (1 - Q) / (1 - 2 * Q).
Definition good (n : nat) : Prop :=
  aligned (direction n) (scenes n) o (last_of n) (next_of n) (radius o + radius (last_of n))
    (radius o + radius (next_of n) + gap_at n) (away_at n) (closing_at n) /\
  0 < gap_at n /\ 0 < away_at n /\ 0 < closing_at n /\
  away_at n <= Q * share mass r o (next_of n) * closing_at n /\
  time n + rest * (gap_at n / closing_at n) <= rest * (gap / closing).
Lemma turned n : next_of (S n) = last_of n /\ last_of (S n) = next_of n.
Proof. unfold next_of, last_of. rewrite Nat.even_succ, <- Nat.negb_even. now destruct (Nat.even n). Qed.
Lemma three n : distinct_balls o (last_of n) (next_of n).
Proof.
  destruct distinct as (A & B & C). unfold next_of, last_of, distinct_balls. destruct (Nat.even n); repeat split; congruence.
Qed.
Lemma always n : good n.
Proof.
  pose proof Q_positive as Q0. induction n as [|n (L & G & V & W & K & T)].
  - unfold good, gap_at, away_at, closing_at, direction, next_of, last_of. cbn [Nat.even speeds fst snd scenes time].
    split; [exact line|]. repeat (split; [assumption|]). lra.
  - destruct (numbers_next n) as (EG & EV & EW). destruct (turned n) as [TN TL].
    pose proof (share_positive (next_of n)) as B. pose proof (share_positive (last_of n)) as B'.
    rewrite <- (Rplus_0_r (radius o + radius (last_of n))) in L.
    pose proof (next_state _ _ _ _ _ _ _ _ _ (three n) L W) as N. rewrite Rplus_0_r in N.
    set (g := gap_at n) in *. set (v := away_at n) in *. set (w := closing_at n) in *.
    set (b := share mass r o (next_of n)) in *. set (b' := share mass r o (last_of n)) in *.
    assert (BW : 0 < b * w) by now apply Rmult_lt_0_compat.
    assert (P : b * w * (1 - Q) <= b * w - v) by lra.
    assert (PP : 0 < b * w * (1 - Q)) by (apply Rmult_lt_0_compat; lra).
    assert (D : 0 < g / w) by now apply Rdiv_lt_0_compat.
    unfold good. rewrite EG, EV, EW, TN, TL. fold b b'. split.
    { assert (E1 : direction (S n) = scaled (-1) (direction n)).
      { unfold direction. rewrite Nat.even_succ, <- Nat.negb_even. destruct (Nat.even n); cbn [negb]; [reflexivity|].
        apply same_vector. intros k. unfold scaled. ring. }
      rewrite E1. cbn [scenes]. fold g w. exact N. }
    split; [now apply Rmult_lt_0_compat|]. split; [apply Rmult_lt_0_compat; lra|]. split; [lra|]. split.
    + apply Rle_trans with (b * b' * Q * (1 - Q) * w).
      { apply Rmult_le_compat_r; [lra|]. exact (shares n). }
      replace (b * b' * Q * (1 - Q) * w) with (Q * b' * (b * w * (1 - Q))) by ring.
      apply Rmult_le_compat_l; [|exact P]. apply Rlt_le. now apply Rmult_lt_0_compat.
    + cbn [time]. fold g w. apply Rle_trans with (2 := T).
      assert (R0 : 0 < rest) by (apply Rdiv_lt_0_compat; lra).
      assert (S : g / w * v / (b * w - v) <= g / w * (Q / (1 - Q))).
      { apply Rmult_le_reg_r with (b * w - v); [lra|].
        replace (g / w * v / (b * w - v) * (b * w - v)) with (g / w * v) by (field; lra).
        rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|].
        apply Rmult_le_reg_r with (1 - Q); [lra|].
        replace (Q / (1 - Q) * (b * w - v) * (1 - Q)) with (Q * (b * w - v)) by (field; lra). lra. }
      assert (S' : rest * (g / w * v / (b * w - v)) <= rest * (g / w * (Q / (1 - Q)))) by (apply Rmult_le_compat_l; lra).
      replace (rest * (g / w)) with (g / w + rest * (g / w * (Q / (1 - Q)))) by (unfold rest; field; lra). lra.
Qed.
Lemma in_turn : meets_in_turn d mass radius r scenes time o a c.
Proof.
  intros n. cbn zeta. destruct (always n) as (L & G & V & W & _).
  replace (time (S n) - time n) with (gap_at n / closing_at n) by (cbn [time]; ring).
  rewrite <- (Rplus_0_r (radius o + radius (last_of n))) in L.
  assert (ST : 0 < 0 + gap_at n / closing_at n * away_at n).
  { rewrite Rplus_0_l. apply Rmult_lt_0_compat; [now apply Rdiv_lt_0_compat | exact V]. }
  pose proof (next_meeting _ _ _ _ _ _ _ _ _ (three n) L (Rle_refl 0) G W ST) as M. rewrite Rplus_0_r in L. fold (next_of n). split; [exact M|].
  destruct M as (_ & _ & C & P & _). destruct (three n) as (_ & N & _). pose proof (round o). pose proof (round (next_of n)).
  apply bounced_parts; [exact heavy | exact restitutes | congruence | rewrite C; lra | exact P].
Qed.
Lemma flight n : 0 < gap_at n / closing_at n.
Proof. destruct (always n) as (_ & G & _ & W & _). now apply Rdiv_lt_0_compat. Qed.
Lemma in_time n : time n <= rest * (gap / closing).
Proof.
  pose proof Q_positive. destruct (always n) as (_ & _ & _ & _ & _ & T). pose proof (flight n).
  assert (0 < rest * (gap_at n / closing_at n)) by (apply Rmult_lt_0_compat; [apply Rdiv_lt_0_compat|]; lra). lra.
Qed.
Lemma ends : exists T, Un_cv time T /\ T <= rest * (gap / closing).
Proof.
  destruct (bounded_increasing_converges time (rest * (gap / closing))) as [T L].
  - intros n. pose proof (flight n). cbn [time]. lra.
  - exact in_time.
  - exists T. split; [exact L|]. exact (limit_at_most _ _ _ L in_time).
Qed.
Lemma opposite n : dot d (to (scenes n) o a) (to (scenes n) o c) =
  - (distance d (scenes n) o a * distance d (scenes n) o c).
Proof.
  destruct (always n) as (L & G & _). pose proof (round o). pose proof (round (last_of n)). pose proof (round (next_of n)).
  pose proof (behind _ _ _ _ _ _ _ _ _ L ltac:(lra)) as D1. pose proof (ahead _ _ _ _ _ _ _ _ _ L ltac:(lra)) as D2.
  pose proof (on_line _ _ _ _ _ _ _ _ _ L (to (scenes n) o (last_of n)) (to (scenes n) o (next_of n))
    (- (radius o + radius (last_of n))) (radius o + radius (next_of n) + gap_at n)) as D3.
  rewrite <- D1, <- D2 in D3. unfold next_of, last_of in *. destruct (Nat.even n);
    [|rewrite dot_symmetric]; rewrite D3; try ring; intros k K; destruct L as [_ F]; destruct (F k K) as (A & _ & C & _);
    rewrite D1, D2; now split.
Qed.
Lemma straight n : minus_cosine_at d (scenes n) o a c = 1.
Proof.
  unfold minus_cosine_at. rewrite opposite.
  assert (0 < distance d (scenes n) o a /\ 0 < distance d (scenes n) o c); [|field; lra].
  destruct (always n) as (L & G & _). pose proof (round o). pose proof (round (last_of n)). pose proof (round (next_of n)).
  pose proof (behind _ _ _ _ _ _ _ _ _ L ltac:(lra)) as D1. pose proof (ahead _ _ _ _ _ _ _ _ _ L ltac:(lra)) as D2.
  unfold next_of, last_of in *. destruct (Nat.even n); lra.
Qed.
(* The collisions are such as NoTriangle.v has them. *)
Lemma are_strikes : r < 1 -> strikes d mass radius scenes time (fun _ => o) next_of.
Proof.
  intros below n. destruct (in_turn n) as ((T & _ & C & P & O) & E). cbn zeta in *. fold (next_of n) in *.
  set (t := time (S n) - time n) in *. set (z := later t (scenes n)) in *. destruct (three n) as (N1 & N2 & N3).
  set (b := next_of n) in *. assert (M : o <> b) by congruence.
  destruct E as (J & J0 & X & V & R1).
  split; [exact M|]. split; [exact T|]. split; [exact C|]. split; [exact P|]. split.
  - apply (any_of_three _ o (last_of n) b).
    + repeat split; assumption.
    + intros i j B. rewrite distance_symmetric, Rplus_comm. exact B.
    + apply Rlt_le, O; congruence.
    + apply Req_le. symmetry. exact C.
    + rewrite distance_symmetric, Rplus_comm. apply Rlt_le, O; congruence.
  - exists J. split; [exact J0|]. split; [exact X | split; [exact V|]]. fold z. rewrite R1. assert (0 < r * - rate d z o b) by (apply Rmult_lt_0_compat; lra).
    assert (0 < (1 - r) * - rate d z o b) by (apply Rmult_lt_0_compat; lra). lra.
Qed.
End Collisions.
End OnTheLine.

Theorem line_theorem_holds : line_theorem.
Proof.
  intros d mass radius r s o a c e away gap closing Q M P R D L A G C K S1 F.
  pose (z := scenes d mass r s o a c away gap closing). pose (t := time mass r o a c away gap closing).
  destruct (ends d mass radius r M P R e s o a c away gap closing Q) as (T & LT & B); trivial.
  exists z, t, T. split; [reflexivity|]. split; [reflexivity|].
  split; [now apply (in_turn d mass radius r M P R e s o a c away gap closing Q)|].
  split; [exact LT|]. split; [exact B|].
  split; [exact (straight d mass radius r M P R e s o a c away gap closing Q D L A G C K S1 F)|]. intros below.
  pose proof (are_strikes d mass radius r M P R e s o a c away gap closing Q D L A G C K S1 F below) as W.
  destruct (no_triangle_holds d mass radius z t T _ _ M P W LT) as (x & o' & a' & c' & N & Z & D' & I & T1 & T2 & O).
  assert (U : forall b, b = a \/ b = c -> distance d x o b = radius o + radius b).
  { assert (O' : o' = o /\ (a' = a /\ c' = c \/ a' = c /\ c' = a)).
    { pose proof (I 0%nat) as I0. pose proof (I 1%nat) as I1. unfold pair_is, next_of in *. cbn [Nat.even] in *.
      replace (N + 1)%nat with (S N) in I1 by lia. rewrite Nat.add_0_r in I0. rewrite Nat.even_succ, <- Nat.negb_even in I1.
      destruct D as (D1 & D2 & D3), D' as (D4 & D5 & D6).
      destruct (Nat.even N); cbn [negb] in I1; destruct I0 as [[? ?]|[? ?]], I1 as [[? ?]|[? ?]]; subst; try congruence; split; auto. }
    destruct O' as (-> & [[-> ->]|[-> ->]]); intros b [-> | ->]; assumption. }
  exists x. split; [exact Z|]. split; [apply U; now left|]. split; [apply U; now right|].
  (* The cosine is -1 at each collision, so in the limit. *)
  pose proof (U a (or_introl eq_refl)) as Ua. pose proof (U c (or_intror eq_refl)) as Uc.
  pose proof (P o). pose proof (P a). pose proof (P c).
  set (f x := dot d (to x o a) (to x o c)). set (g x := square d x o a * square d x o c).
  pose proof (opposite d mass radius r M P R e s o a c away gap closing Q D L A G C K S1 F : forall n,
    f (z n) = - (distance d (z n) o a * distance d (z n) o c)) as OP.
  assert (V : f x * f x = g x).
  { apply (UL_sequence (fun n => f (z n) * f (z n))).
    - apply CV_mult; apply dot_converges; intros k H2; now apply Z.
    - intros h H2. assert (Q2 : Un_cv (fun n => g (z n)) (g x)).
      { unfold g, square. apply CV_mult; apply dot_converges; intros k H3; now apply Z. }
      destruct (Q2 h H2) as (m & Y). exists m. intros n X. specialize (Y n X).
      replace (f (z n) * f (z n)) with (g (z n)); [exact Y|]. unfold g.
      rewrite OP, !square_of_distance. ring. }
  assert (X : f x = - (distance d x o a * distance d x o c)).
  { unfold g in V. rewrite !square_of_distance in V. set (k := distance d x o a * distance d x o c).
    assert (E : (f x - k) * (f x + k) = 0) by (unfold k; lra).
    assert (K0 : 0 < k) by (unfold k; rewrite Ua, Uc; apply Rmult_lt_0_compat; lra).
    assert (N0 : f x <= 0).
    { assert (forall n, f (z n) <= 0).
      { intros n. rewrite OP.
        assert (0 <= distance d (z n) o a * distance d (z n) o c) by (apply Rmult_le_pos; apply sqrt_pos). lra. }
      apply (limit_at_most (fun n => f (z n))); [|assumption]. apply dot_converges; intros i H3; now apply Z. }
    apply Rmult_integral in E. destruct E; lra. }
  unfold minus_cosine_at. fold (f x). rewrite X, Ua, Uc. field. split; lra.
Qed.

Lemma equal_in_turn d r z t :
  (forall n, let b := collides_with n in let u := t (S n) - t n in
    meets_next d half (z n) B0 b u /\ parts d one r B0 b (later u (z n)) (z (S n))) ->
  collides_in_turn d r z t.
Proof.
  intros I n. destruct (I n) as (M & J & _ & E & E1 & E2). fold (collides_with n) in *. apply equal_meets in M.
  split; [exact M|]. set (j := collides_with n) in *. set (y := later (t (S n) - t n) (z n)) in *.
  assert (N : B0 <> j) by (apply not_eq_sym, partner_not_0).
  assert (J1 : J = - ((1 + r) / 2 * rate d y B0 j)).
  { unfold rate at 1 in E2. rewrite (same_places _ _ _ _ E), (own_velocity one J B0 j y _ N (conj E E1)) in E2.
    rewrite dot_linear_right in E2. pose proof (unit_square _ _ _ _ (contact _ _ _ _ _ M)) as U.
    change (dot d (to y B0 j) (to y B0 j) = 1) in U. rewrite U in E2. fold (rate d y B0 j) in E2. unfold one in E2. lra. }
  destruct (z (S n)) as [places speeds]. cbn [position velocity] in E, E1. unfold collided.
  f_equal; [exact E|]. extensionality b. extensionality k. rewrite E1, J1. unfold one.
  destruct (same b B0); [field|]. destruct (same b j); [field | reflexivity].
Qed.

Theorem equal_on_a_line_holds : equal_on_a_line.
Proof.
  intros d r s e away gap closing Q R L A G C K S F.
  assert (D : distinct_balls B0 B1 B2) by (repeat split; discriminate).
  assert (H : forall b, share one r B0 b = (1 + r) / 2) by (intros; unfold share, one; field).
  destruct (line_theorem_holds d one half r s B0 B1 B2 e away gap closing Q one_positive half_positive (proj1 R) D L A G C) as
    (z & t & T & Z0 & T0 & I & LT & B & V & _).
  { rewrite H. exact K. } { exact S. }
  { rewrite !H. replace ((1 + r) / 2 * ((1 + r) / 2) * Q * (1 - Q)) with (((1 + r) / 2) ^ 2 * Q * (1 - Q)) by ring. exact F. }
  pose proof (in_turn_collapses d r R z t T T0 (equal_in_turn d r z t I) LT) as Y. rewrite Z0 in Y.
  do 5 eexists. split; [exact Y|]. split; [exact B|].
  rewrite (limit_unique_constant _ _ _ (angle_converges _ _ _ _ _ _ _ _ Y) V).
  rewrite Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
Qed.
