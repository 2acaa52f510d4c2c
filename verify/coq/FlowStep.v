(* One collision of any three balls, from the certificate of the flow: if the inner products of a
   scene are the numbers of a state, and these satisfy what the flow asks for, then the next collision
   is that of balls o and c, and the scene after it has the numbers that the flow calls next. Flow.v
   is what `verify.wire.coq.named` prints for that certificate: it has the rows that are named. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Vectors Motion.
From Verify Require Flow.
Open Scope R_scope.

(* Seen from ball o: the ball s is at x_s and moves with W_s, the ball c with x_c and W_c. *)
Record gram (d : nat) (x : scene) (o s c : ball) (v lam rho eps sig A B C a b w : R) : Prop := {
  gram_s_s : dot d (to x o s) (to x o s) = 1 + sig * v ^ 2;
  gram_c_c : dot d (to x o c) (to x o c) = 1 + eps * v ^ 2;
  gram_s_c : dot d (to x o s) (to x o c) = - C;
  gram_s_ws : dot d (to x o s) (relative x o s) = rho * v;
  gram_c_wc : dot d (to x o c) (relative x o c) = - (lam * v);
  gram_s_wc : dot d (to x o s) (relative x o c) = a;
  gram_c_ws : dot d (to x o c) (relative x o s) = b;
  gram_ws_ws : dot d (relative x o s) (relative x o s) = B;
  gram_wc_wc : dot d (relative x o c) (relative x o c) = A;
  gram_ws_wc : dot d (relative x o s) (relative x o c) = w
}.

Lemma struck d r x o c : o <> c -> relative (collided d r o c x) o c =
  combined 1 (relative x o c) (- ((1 + r) * rate d x o c)) (to x o c).
Proof.
  intros N. apply same_vector. intros k. unfold relative, collided, combined.
  destruct o, c; try easy; cbn [velocity same]; field.
Qed.
Lemma struck_other d r x o s c : s <> o -> s <> c -> o <> c -> relative (collided d r o c x) o s =
  combined 1 (relative x o s) (- ((1 + r) / 2 * rate d x o c)) (to x o c).
Proof.
  intros N M K. apply same_vector. intros k. unfold relative, collided, combined.
  destruct o, s, c; try easy; cbn [velocity same]; field.
Qed.
Lemma from_o x o i j : to x i j = combined (-1) (to x o i) 1 (to x o j).
Proof. apply same_vector. intros k. unfold to, combined. ring. Qed.
Lemma moves_from_o x o i j : relative x i j = combined (-1) (relative x o i) 1 (relative x o j).
Proof. apply same_vector. intros k. unfold relative, combined. ring. Qed.

Section FlowStep.
Variables r v lam rho eps sig A B C a b w y q kap s T : R.
Variables C_next lam_next A_next B_next a_next b_next w_next eps_next : R.
(* What the certificate asks for. *)
Record flow_collision : Prop := {
  flow_1 : 0 < r; flow_2 : 0 < v; flow_3 : 0 < lam; flow_4 : 0 <= A; flow_5 : y = lam * v;
  flow_6 : q = rho / lam; flow_7 : kap = eps / lam / lam; flow_8 : 0 <= kap;
  flow_9 : 0 < 1 - A * kap; flow_10 : s = sqrt (1 - A * kap); flow_11 : 0 < 1 + s;
  flow_12 : T = kap / (1 + s);
  flow_13 : C_next = C - y * T * (a + (b + y * T * w));
  flow_14 : lam_next = (1 + r) / 2 * s * C_next - q - T * B;
  flow_15 : A_next =
    B + (1 + r) / 2 * (y * s) * (2 * (b + y * T * w) + (1 + r) / 2 * (y * s));
  flow_16 : B_next = A - (1 - r ^ 2) * (y * s) ^ 2;
  flow_17 : a_next = b + y * T * w + (1 + r) / 2 * (y * s);
  flow_18 : b_next = a + y * T * w - 2 * ((1 + r) / 2 * (y * s)) * C_next;
  flow_19 : w_next = w + (1 + r) / 2 * (y * s) * (2 * (b + y * T * w) + r * (y * s));
  flow_20 : eps_next = sig / lam / lam + T * (2 * q + T * B);
  flow_21 : 0 <= sig; flow_22 : 0 <= sig + T * lam * rho; flow_23 : 0 < eps_next;
  flow_24 : 0 <= 1 + (eps + sig) * v ^ 2 + 2 * C;
  flow_25 : 0 <= 1 + (eps + sig) * v ^ 2 + 2 * C + ((rho - lam) * v - a - b) * (y * T);
  flow_26 : 0 < 1 + (eps + sig) * v ^ 2 + 2 * C +
    y * T * (2 * ((rho - lam) * v - a - b) + (A + B - 2 * w) * (y * T));
  flow_27 : 0 <= B_next
}.
Hypothesis certified : flow_collision.
(* There is some time to the contact. *)
Hypothesis later_on : 0 < kap.
Ltac given F := repeat match type of F with ?P -> _ =>
    let Q := fresh in assert (Q : P) by assumption; specialize (F Q); clear Q end.
Ltac flow L F :=
  pose proof (L r v lam rho eps sig A B C a b w y q kap s T
    C_next lam_next A_next B_next a_next b_next w_next eps_next) as F;
  repeat match type of F with ?P -> _ =>
    let Q := fresh in assert (Q : P) by assumption; specialize (F Q); clear Q end.


Variable d : nat.
Variable x : scene.
Variables o i c : ball.  (* i is the ball s of the certificate *)
Hypothesis distinct : i <> o /\ c <> o /\ i <> c.
Hypothesis seen : gram d x o i c v lam rho eps sig A B C a b w.

Definition flight_time : R := y * T.
Lemma takes_time : 0 < flight_time.
Proof.
  destruct certified as [H1 H2 H3 H4 H5 H6 H7 H8 H9 H10 H11 H12 _ _ _ _ _ _ _ _ _ _ _ _ _ _ _].
  unfold flight_time. apply Rmult_lt_0_compat; [rewrite H5; now apply Rmult_lt_0_compat|].
  rewrite H12. now apply Rdiv_lt_0_compat.
Qed.
(* The squares of the distances at the time u. *)
Lemma square_i u : square d (later u x) o i = 1 + sig * v ^ 2 + 2 * u * (rho * v) + u * u * B.
Proof.
  destruct seen as [G1 _ _ G4 _ _ _ G8 _ _]. unfold square.
  rewrite to_later, square_of_combined, G1, G4, G8. ring.
Qed.
Lemma square_c u : square d (later u x) o c = 1 + eps * v ^ 2 - 2 * u * (lam * v) + u * u * A.
Proof.
  destruct seen as [_ G2 _ _ G5 _ _ _ G9 _]. unfold square.
  rewrite to_later, square_of_combined, G2, G5, G9. ring.
Qed.
Lemma square_outer u : square d (later u x) i c =
  square d (later u x) o i + square d (later u x) o c
  - 2 * (- C + u * a + u * b + u * u * w).
Proof.
  destruct seen as [_ _ G3 _ _ G6 G7 _ _ G10]. unfold square. rewrite (from_o (later u x) o i c).
  rewrite square_of_combined.
  replace (dot d (to (later u x) o i) (to (later u x) o c)) with (- C + u * a + u * b + u * u * w).
  - ring.
  - rewrite !to_later, dot_linear, !dot_linear_right, G3, G6, (dot_symmetric d _ (to x o c)), G7, G10.
    ring.
Qed.
Lemma apart u : 0 < u <= flight_time ->
  1 < square d (later u x) o i /\ 1 < square d (later u x) i c.
Proof.
  intros U. destruct certified. pose proof takes_time as P. set (share := u / flight_time).
  assert (S0 : 0 < share) by (apply Rdiv_lt_0_compat; lra).
  assert (E : u = share * (y * T)) by (change (y * T) with flight_time; unfold share; field; lra).
  assert (S1 : 0 <= 1 - share).
  { apply Rmult_le_reg_r with flight_time; [exact P|].
    replace ((1 - share) * flight_time) with (flight_time - u) by (unfold share; field; lra). lra. }
  pose proof (Flow.spectator_apart r v lam rho eps sig A B C a b w y q kap s T
    C_next lam_next A_next B_next a_next b_next w_next eps_next share) as F.
  pose proof (Flow.outer_apart r v lam rho eps sig A B C a b w y q kap s T
    C_next lam_next A_next B_next a_next b_next w_next eps_next share) as G.
  given F. given G. rewrite square_outer, square_i, square_c, E. lra.
Qed.
Lemma apart_c u : 0 < u < flight_time -> 1 < square d (later u x) o c.
Proof.
  intros U. destruct certified. pose proof takes_time as P. set (share := u / flight_time).
  assert (S0 : 0 < share) by (apply Rdiv_lt_0_compat; lra).
  assert (E : u = share * (y * T)) by (change (y * T) with flight_time; unfold share; field; lra).
  assert (S2 : 0 < 1 - share).
  { apply Rmult_lt_reg_r with flight_time; [exact P|].
    replace ((1 - share) * flight_time) with (flight_time - u) by (unfold share; field; lra). lra. }
  assert (S1 : 0 <= 1 - share) by lra.
  pose proof (Flow.colliding_pair_apart r v lam rho eps sig A B C a b w y q kap s T
    C_next lam_next A_next B_next a_next b_next w_next eps_next share) as F.
  given F. flow Flow.impact_positive Q.
  assert (Z : 0 < 2 * (1 - share) * (y * T) * (y * s)).
  { apply Rmult_lt_0_compat; [|exact Q]. apply Rmult_lt_0_compat; [lra | exact P]. }
  rewrite square_c, E. lra.
Qed.
Lemma touches : square d (later flight_time x) o c = 1.
Proof. destruct certified. flow Flow.contact F. rewrite square_c. unfold flight_time. lra. Qed.
Lemma impact_rate : rate d (later flight_time x) o c = - (y * s).
Proof.
  destruct certified. flow Flow.impact F. destruct seen as [_ _ _ _ G5 _ _ _ G9 _].
  unfold rate. rewrite to_later, relative_later, dot_linear, G5, G9. unfold flight_time. lra.
Qed.
Lemma speed_positive_there : 0 < y * s.
Proof. destruct certified. flow Flow.impact_positive F. exact F. Qed.
Lemma any_pair (P : ball -> ball -> Prop) : (forall k l, P k l -> P l k) ->
  P o i -> P o c -> P i c -> forall k l, k <> l -> P k l.
Proof.
  intros Y P1 P2 P3 k l N. destruct distinct as (D1 & D2 & D3).
  destruct o, i, c, k, l; try easy; auto.
Qed.
Theorem flow_meets : first_to_meet d x o c flight_time.
Proof.
  assert (Y : forall u k l, 1 < distance d (later u x) k l -> 1 < distance d (later u x) l k)
    by (intros u k l H; now rewrite distance_symmetric).
  split.
  - exact takes_time.
  - intros u k l U N. revert k l N. apply (any_pair (fun k l => 1 < distance d (later u x) k l) (Y u)).
    + apply distance_above, apart. lra.
    + now apply distance_above, apart_c.
    + apply distance_above, apart. lra.
  - apply distance_one, touches.
  - rewrite impact_rate. pose proof speed_positive_there. lra.
  - intros k K L. pose proof takes_time. destruct distinct as (D1 & D2 & D3).
    assert (k = i) by (destruct k, o, i, c; easy). subst k.
    split; [|apply Y]; apply distance_above, apart; lra.
Qed.

(* --- after it, with i and c exchanged --------------------------------------------------------- *)

Theorem flow_next : gram d (collided d r o c (later flight_time x)) o c i
  y lam_next (r * s) eps_next 0 A_next B_next C_next a_next b_next w_next.
Proof.
  pose proof impact_rate as K. destruct distinct as (D1 & D2 & D3).
  destruct seen as [G1 G2 G3 G4 G5 G6 G7 G8 G9 G10]. destruct certified.
  assert (E1 : to (collided d r o c (later flight_time x)) o c =
    combined 1 (to x o c) (y * T) (relative x o c)) by (now rewrite to_collided, to_later).
  assert (E2 : to (collided d r o c (later flight_time x)) o i =
    combined 1 (to x o i) (y * T) (relative x o i)) by (now rewrite to_collided, to_later).
  assert (E3 : relative (collided d r o c (later flight_time x)) o c =
    combined 1 (relative x o c) ((1 + r) * (y * s)) (combined 1 (to x o c) (y * T) (relative x o c))).
  { rewrite struck by (intros F; now apply D2). rewrite K, relative_later, to_later.
    unfold flight_time. f_equal. ring. }
  assert (E4 : relative (collided d r o c (later flight_time x)) o i =
    combined 1 (relative x o i) ((1 + r) / 2 * (y * s))
      (combined 1 (to x o c) (y * T) (relative x o c))).
  { rewrite struck_other by (trivial; intros F; now apply D2). rewrite K, relative_later, to_later.
    unfold flight_time. f_equal. ring. }
  assert (Kappa : 1 * 1 * (- (lam * v)) + 1 * (y * T) * A = - (y * s)).
  { flow Flow.impact F. exact F. }
  pose proof G3 as R3. pose proof G4 as R4. pose proof G5 as R5. pose proof G6 as R6.
  pose proof G7 as R7. pose proof G10 as R10.
  rewrite dot_symmetric in R3, R4, R5, R6, R7, R10.
  assert (Slope : y * T * A = lam * v - y * s) by lra.
  split; rewrite ?E1, ?E2, ?E3, ?E4; repeat (rewrite dot_linear || rewrite dot_linear_right);
    rewrite ?G1, ?G2, ?G3, ?G4, ?G5, ?G6, ?G7, ?G8, ?G9, ?G10, ?R3, ?R4, ?R5, ?R6, ?R7, ?R10.
  - flow Flow.next_x_s_x_s F. etransitivity; [|exact F]. ring.
  - flow Flow.next_x_c_x_c F. etransitivity; [|exact F]. ring.
  - flow Flow.next_x_s_x_c F. etransitivity; [|exact F]. ring.
  - flow Flow.next_x_s_W_s F. rewrite Kappa in F. etransitivity; [|exact F]. ring.
  - flow Flow.next_x_c_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field.
  - flow Flow.next_x_s_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field.
  - flow Flow.next_W_s_x_c F. rewrite Kappa in F. etransitivity; [|exact F]. field.
  - flow Flow.next_W_s_W_s F. rewrite Kappa in F. etransitivity; [|exact F]. ring.
  - flow Flow.next_W_c_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field.
  - flow Flow.next_W_s_W_c F. rewrite Kappa in F. etransitivity; [|exact F]. field.
Qed.
(* Nobody overlaps there, and only o and c touch. *)
Theorem flow_apart_after : let z := collided d r o c (later flight_time x) in
  1 <= square d z o c /\ 1 < square d z o i /\ 1 < square d z c i.
Proof.
  pose proof takes_time. destruct (apart flight_time ltac:(lra)) as [P Q]. pose proof touches as R.
  assert (E : square d (later flight_time x) c i = square d (later flight_time x) i c).
  { now rewrite !square_of_distance, distance_symmetric. }
  unfold square in *. cbn zeta. rewrite !to_collided. rewrite E. lra.
Qed.
End FlowStep.

Lemma kap_positive r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' :
  flow_collision r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' ->
  0 < eps -> 0 < kap.
Proof.
  intros H E. destruct H as [_ _ L _ _ _ K _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _]. rewrite K.
  repeat apply Rdiv_lt_0_compat; assumption.
Qed.
