(* The map of two numbers of ThreeBalls.v goes on for ever below finitely many numbers, by induction. *)
From Coq Require Import Reals Arith Lra Lia.
From Verify Require Import Theorem1 ThreeBalls.
From Verify Require Balls.
Open Scope R_scope.

Theorem stair_theorem_holds : stair_theorem.
Proof.
  intros mass radius r o a c w G U_most C_0 Theta Q_0 U_0 N Q U M P Pr PG PU PC (Q0 & U0 & Steps & QN & UN).
  set (alpha n := alpha_of mass radius r o a c C_0 Theta n). set (rho n := rho_of a c w G n).
  set (ratio n := ratio_of r a c G n).
  assert (Pa : forall n, 0 <= alpha n).
  { intros n. unfold alpha, alpha_of, share_of, reach_of. apply Rlt_le, Rmult_lt_0_compat; [|lra].
    set (b := next_ball a c n). set (b' := last_ball a c n).
    pose proof (M o). pose proof (M b). pose proof (P o). pose proof (P b). pose proof (P b'). pose proof (Pr b).
    apply Rmult_lt_0_compat; [|apply Rdiv_lt_0_compat; lra].
    apply Rdiv_lt_0_compat; [apply Rmult_lt_0_compat|]; lra. }
  assert (Pp : forall n, 0 <= rho n).
  { intros n. unfold rho, rho_of. apply Rmult_le_pos; [lra | apply pow2_ge_0]. }
  assert (PR : forall n, 0 <= ratio n).
  { intros n. unfold ratio, ratio_of. pose proof (Pr (next_ball a c n)). apply Rmult_le_pos; lra. }
  assert (Same : forall n i, Nat.even i = Nat.even n -> alpha i = alpha n /\ rho i = rho n /\ ratio i = ratio n).
  { intros n i E. unfold alpha, rho, ratio, alpha_of, rho_of, ratio_of, next_ball, last_ball. rewrite E.
    repeat split. }
  set (p := orbit mass radius r o a c w G C_0 Theta Q_0 U_0).
  (* A point below a step of the stair: what the certificate says of it, and that the next one is not negative. *)
  assert (Step : forall i x u, (i <= S N)%nat -> 0 <= x <= Q i -> 0 <= u <= U i -> let q := (x, u) in
    (0 < pace (alpha i) (rho i) q /\ load (rho i) q <= U_most * (2 - U_most) * pace (alpha i) (rho i) q ^ 2) /\
    0 <= fst (mapped (alpha i) (rho i) (ratio i) q) <= Q (S i) /\
    0 <= snd (mapped (alpha i) (rho i) (ratio i) q) <= U (S i)).
  { intros i x u L [A A'] [B B']. destruct (Steps i L) as (S1 & [S2 S2'] & [S3 S3'] & S4 & S5 & S6).
    fold (alpha i) (rho i) (ratio i) in S4, S5, S6. unfold mapped, pace, load. unfold pace, load in S4, S5, S6.
    cbn [fst snd] in *.
    pose proof (Balls.orbit_approaches _ _ _ _ _ _ _ _ _ _ (Pa i) (Pp i) (PR i) PU S1 S2 S3 S2' S3' S4 S5 S6 A B A' B') as F1.
    pose proof (Balls.orbit_meets _ _ _ _ _ _ _ _ _ _ (Pa i) (Pp i) (PR i) PU S1 S2 S3 S2' S3' S4 S5 S6 A B A' B') as F2.
    pose proof (Balls.orbit_Q_falls _ _ _ _ _ _ _ _ _ _ (Pa i) (Pp i) (PR i) PU S1 S2 S3 S2' S3' S4 S5 S6 A B A' B') as F3.
    pose proof (Balls.orbit_U_falls _ _ _ _ _ _ _ _ _ _ (Pa i) (Pp i) (PR i) PU S1 S2 S3 S2' S3' S4 S5 S6 A B A' B') as F4.
    split; [now split|]. split; (split; [|assumption]).
    - apply Rmult_le_pos; [apply Rmult_le_pos; [apply PR | lra] | now apply Rlt_le, Rinv_0_lt_compat].
    - set (e := alpha i * (1 - u) - x - rho i * u) in *. set (l := rho i * u * (2 * x + rho i * u)).
      assert (0 <= l).
      { unfold l. assert (0 <= rho i * u) by (apply Rmult_le_pos; [apply Pp | exact B]). apply Rmult_le_pos; lra. }
      assert (0 <= l / e / e) by (apply Rmult_le_pos; [apply Rmult_le_pos; [assumption|]|]; now apply Rlt_le, Rinv_0_lt_compat).
      assert (sqrt (1 - l / e / e) <= 1); [|lra].
      apply Rle_trans with (sqrt 1); [apply sqrt_le_1_alt | rewrite sqrt_1]; lra. }
  assert (Below : forall n, exists i, (i <= S N)%nat /\ Nat.even i = Nat.even n /\
    0 <= fst (p n) <= Q i /\ 0 <= snd (p n) <= U i).
  { induction n as [|n (i & L & E & A & B)]; [exists O; repeat split; lia || apply Q0 || apply U0|].
    destruct (Same n i E) as (E1 & E2 & E3). destruct (Step i _ _ L A B) as (_ & F).
    rewrite <- surjective_pairing, E1, E2, E3 in F. change (mapped _ _ _ _) with (p (S n)) in F.
    destruct (Nat.eq_dec i (S N)) as [->|D].
    - exists N. rewrite Nat.even_succ, <- Nat.negb_even in E.
      split; [lia|]. split; [|lra]. rewrite Nat.even_succ, <- Nat.negb_even, <- E. now destruct (Nat.even N).
    - exists (S i). split; [lia|]. split; [|exact F]. rewrite !Nat.even_succ, <- !Nat.negb_even. now rewrite E. }
  intros n. destruct (Below n) as (i & L & E & A & B). destruct (Same n i E) as (E1 & E2 & E3).
  destruct (Step i _ _ L A B) as (F & _). rewrite <- surjective_pairing, E1, E2 in F. exact F.
Qed.
