(* The sandwich theorem is a special case of the theorem on any three balls: masses and diameters are 1,
   and both shares are (1+r)/2. *)
From Coq Require Import Reals Arith Lra.
From Verify Require Import Theorem1 Vectors Motion Classification Contacts Bounces ThreeBalls ThreeBallsMap ThreeBallsCollapse Sandwich.
Open Scope R_scope.

Section SandwichProof.
Variable d : nat.
Variables r G slow U_most C_0 Theta Q_0 U_0 : R.
Variable w : ball -> R.
Variable s : scene.
Hypothesis good : inner_bounds r G slow U_most C_0 Theta U_0 w.
Hypothesis good_map : inner_goes_on r G U_most C_0 Theta Q_0 U_0 w.
Hypothesis good_scene : inner_starts r G slow U_most C_0 Theta Q_0 U_0 w d s.
Let share := (1 + r) / 2.
Let fall := share * G.
Let rest := G * U_most / slow / slow / (1 - fall).
Let y := - rate d s B0 B2 / distance d s B0 B2.
Let same_r (_ : ball) := r.
Lemma reach_is b : reach_of half B0 b = 1.
Proof. unfold reach_of, half. lra. Qed.
Lemma share_is b b' : share_of one half same_r B0 b b' = share.
Proof. unfold share_of. rewrite !reach_is. unfold one, same_r, share. field. Qed.
Lemma orbit_is n : orbit one half same_r B0 B1 B2 w G C_0 Theta Q_0 U_0 n = inner r G C_0 Theta Q_0 U_0 w n.
Proof.
  induction n as [|n IH]; [reflexivity|]. cbn [orbit inner]. rewrite IH. unfold alpha_of. rewrite share_is. reflexivity.
Qed.
Lemma closing_is : closing d half B0 B2 s = y.
Proof. unfold closing. rewrite reach_is. unfold y. now rewrite Rmult_1_r. Qed.
Lemma speed_is b : speed_of d half B0 s b = sqrt (dot d (relative s B0 b) (relative s B0 b)).
Proof. unfold speed_of. rewrite reach_is. field. Qed.
Lemma r_range : 0 < r < 1.
Proof.
  destruct good as (R0 & G1 & F & _). split; [exact R0|].
  assert ((1 + r) / 2 * 1 <= (1 + r) / 2 * G) by (apply Rmult_le_compat_l; lra). lra.
Qed.
Lemma fall_range : 0 < fall < 1.
Proof.
  destruct good as (R0 & G1 & F & _). unfold fall, share. split; [apply Rmult_lt_0_compat; lra | exact F].
Qed.
Lemma U_positive : 0 < U_0.
Proof.
  destruct good_scene as (_ & P & Y & _ & S & _). destruct good as (_ & _ & _ & W & W2 & _ & [U1 U2] & _).
  set (gap := distance d s B0 B2 - 1) in *. fold y in S, Y.
  assert (0 < gap * (2 + gap) * w B2 ^ 2).
  { apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat; lra | apply pow_lt; lra]. }
  apply Rnot_le_lt. intros L.
  assert (0 <= - U_0 * ((2 - U_0) * (1 + gap) ^ 2 * y ^ 2)).
  { apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [apply Rmult_le_pos; [lra|] |]; apply pow2_ge_0. }
  lra.
Qed.
Lemma square_rises a b : 0 <= a -> a <= b -> a ^ 2 <= b ^ 2.
Proof. intros. now apply pow_incr. Qed.
Lemma chosen_is : chosen one half same_r B0 B1 B2 w (fun _ => fall) (fun _ => 0) (fun _ => rest) G U_most C_0 Theta U_0.
Proof.
  pose proof fall_range as F. pose proof U_positive as U. pose proof r_range.
  destruct good as (R0 & G1 & _ & W & W2 & W1 & [U1 U2] & [C1 C2]).
  assert (E : forall b, slow <= w b -> G * U_most <= w b ^ 2 * (rest - fall * rest)).
  { intros b L. replace (rest - fall * rest) with (G * U_most * / slow ^ 2) by (unfold rest; field; lra).
    pose proof (square_rises slow (w b) ltac:(lra) L). assert (P : 0 < slow ^ 2) by now apply pow_lt.
    assert (V : 0 <= G * U_most * / slow ^ 2).
    { apply Rmult_le_pos; [apply Rmult_le_pos; lra | now apply Rlt_le, Rinv_0_lt_compat]. }
    apply Rle_trans with (slow ^ 2 * (G * U_most * / slow ^ 2)); [right; field; lra | now apply Rmult_le_compat_r]. }
  assert (K : forall b b', slow <= w b -> chosen_for one half same_r B0 w (fun _ => fall) (fun _ => 0) (fun _ => rest) G U_most b b').
  { intros b b' L. unfold chosen_for. rewrite share_is. split; [lra|]. split; [lra|]. split; [lra|].
    split; [unfold fall; right; ring|]. split; [|now apply E]. rewrite Rmult_0_l. unfold same_r. apply Rmult_le_pos; lra. }
  split; [exact G1|]. split; [lra|]. split; [assert (fall * fall < 1 * 1) by (apply Rmult_le_0_lt_compat; lra); lra|].
  split; [lra|]. split; [now apply K|]. split; [now apply K|]. rewrite !reach_is. unfold half. lra.
Qed.
Lemma map_is : goes_on one half same_r B0 B1 B2 w G U_most C_0 Theta Q_0 U_0.
Proof.
  intros n. rewrite orbit_is. unfold alpha_of. rewrite share_is. exact (good_map n).
Qed.
Lemma starts_is : starts d one half same_r B0 B1 B2 w (fun _ => fall) (fun _ => 0) (fun _ => rest) G U_most C_0 Theta y Q_0 U_0 s.
Proof.
  pose proof fall_range as F. pose proof U_positive as U. pose proof r_range as R.
  destruct good as (R0 & G1 & _ & W & W2 & W1 & [U1 U2] & [C1 C2]).
  destruct good_scene as (S0 & S1 & S2 & [S3 S4] & S5 & S6 & S7 & S8 & S9).
  fold share in S7, S8, S9. fold fall in S7, S8, S9. fold y in S2, S4, S5, S6, S7, S8, S9.
  unfold starts. cbv zeta. rewrite closing_is, !reach_is, !share_is, !speed_is. unfold parting. rewrite reach_is.
  replace (distance d s B0 B2 / 1 - 1) with (distance d s B0 B2 - 1) by field.
  replace (rate d s B0 B1 / 1 ^ 2) with (rate d s B0 B1) by field.
  assert (FF : fall * fall < 1 * 1) by (apply Rmult_le_0_lt_compat; lra).
  assert (GG : 0 <= G ^ 2 - 1) by (pose proof (square_rises 1 G ltac:(lra) G1); lra).
  assert (Far : forall b, slow <= w b -> slow ^ 2 * (G ^ 2 - 1) <= w b ^ 2 * (G ^ 2 - 1)).
  { intros b L. apply Rmult_le_compat_r; [exact GG|]. apply square_rises; lra. }
  assert (YF : 0 < fall * y) by (apply Rmult_lt_0_compat; lra).
  assert (YL : fall * y <= 1 * y) by (apply Rmult_le_compat_r; lra).
  assert (Slow : (fall * y) ^ 2 <= y ^ 2) by (apply square_rises; lra).
  assert (Pos : 0 <= U_most * (2 - U_most) * G ^ 2).
  { apply Rmult_le_pos; [apply Rmult_le_pos; lra | apply pow2_ge_0]. }
  assert (Slow' : U_most * (2 - U_most) * G ^ 2 * (fall * y) ^ 2 <= U_most * (2 - U_most) * G ^ 2 * y ^ 2)
    by (now apply Rmult_le_compat_l).
  pose proof (Far B2 W2). pose proof (Far B1 W1).
  assert (Sy : share * y <= 1 * y) by (apply Rmult_le_compat_r; unfold share; lra).
  assert (Sf : share * (fall * y) <= 1 * (fall * y)) by (apply Rmult_le_compat_r; unfold share; lra).
  split; [exact S0|]. split; [exact S1|]. split; [exact S2|]. split; [exact S3|].
  split; [split; [lra | exact S4]|]. split; [exact S5|]. split; [lra|]. split; [lra|].
  split; [lra|]. split; [lra|]. split; [lra|]. split; [lra|].
  split; [|split].
  - apply Rle_trans with (1 := S7), Req_le. unfold fall. field. fold fall. lra.
  - apply Rle_trans with (1 := S8), Req_le. unfold fall. field. fold fall. lra.
  - apply Rle_trans with (2 := S9), Req_le. change (minus_cosine_at d s B0 B1 B2) with (minus_cosine d s).
    unfold rest. field. repeat split; lra.
Qed.
Theorem sandwich_collapses : collapse d r s (rest * y) C_0 Theta.
Proof.
  pose proof (three_equal_balls_holds d r w _ _ _ G U_most C_0 Theta y Q_0 U_0 s r_range chosen_is map_is starts_is) as K.
  rewrite <- closing_is. exact K.
Qed.
End SandwichProof.
Theorem sandwich_theorem_holds : sandwich_theorem.
Proof.
  intros d r G slow U_most C_0 Theta Q_0 U_0 w s B M S.
  exact (sandwich_collapses d r G slow U_most C_0 Theta Q_0 U_0 w s B M S).
Qed.
Theorem inner_stair_theorem_holds : inner_stair_theorem.
Proof.
  intros r G U_most C_0 Theta Q_0 U_0 w N Q U R G1 U1 C (Q0 & U0 & Steps & Last).
  pose proof (stair_theorem_holds one half (fun _ => r) B0 B1 B2 w G U_most C_0 Theta Q_0 U_0 N Q U one_positive
    half_positive ltac:(intros; exact R) G1 U1 C) as K.
  intros n. rewrite <- orbit_is, <- (share_is r (next_ball B1 B2 n) (last_ball B1 B2 n)). apply K.
  split; [exact Q0|]. split; [exact U0|]. split; [|exact Last].
  intros m L. unfold alpha_of. rewrite (share_is r). exact (Steps m L).
Qed.
