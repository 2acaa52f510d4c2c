(* One collision of any three equal balls: if the inner products of a scene are the numbers of a state,
   and these satisfy what the certificate of the flow asks for, then the next collision is that of balls
   o and c, and the scene after it has the numbers that the flow calls next. This is the law of
   ThreeBalls.v for equal masses and radii. *)
From Coq Require Import Reals Lra.
From Verify Require Import Theorem1 Motion Line Bounces ThreeBalls BallsFlowStep.
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

(* In the words of ThreeBalls.v. *)
Lemma gram_is d x o s c v lam rho eps sig A B C a b w : gram d x o s c v lam rho eps sig A B C a b w <->
  in_products d half x o s c v lam rho eps sig A B C a b w.
Proof.
  unfold in_products, half. replace ((1 / 2 + 1 / 2) ^ 2) with 1 by field. split.
  - intros [? ? ? ? ? ? ? ? ? ?]. repeat (split; [assumption|]). assumption.
  - intros (? & ? & ? & ? & ? & ? & ? & ? & ? & ?). now split.
Qed.

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

Variable d : nat.
Variable x : scene.
Variables o i c : ball.  (* i is the ball s of the certificate *)
Hypothesis distinct : i <> o /\ c <> o /\ i <> c.
Hypothesis seen : gram d x o i c v lam rho eps sig A B C a b w.

Definition flight_time : R := y * T.
Lemma certified_of_balls : collision_numbers ((half o + half c) ^ 2) ((half o + half i) ^ 2) ((half i + half c) ^ 2)
  (1 + one o / one c) r v lam rho eps sig A B C a b w y q kap s T
  C_next lam_next A_next B_next a_next b_next w_next eps_next.
Proof.
  unfold half, one. replace ((1 / 2 + 1 / 2) ^ 2) with 1 by field. replace (1 + 1 / 1) with 2 by field.
  destruct certified. repeat split; first [assumption | lra | etransitivity; [eassumption | field]].
Qed.
Theorem flow_meets : first_to_meet d x o c flight_time.
Proof.
  apply equal_meets. apply gram_is in seen. eapply law_meets with (mass := one) (i := i);
    [exact one_positive | exact half_positive | exact distinct | exact seen | exact certified_of_balls].
Qed.
(* After it, with i and c exchanged. *)
Theorem flow_next : gram d (collided d r o c (later flight_time x)) o c i
  y lam_next (r * s) eps_next 0 A_next B_next C_next a_next b_next w_next.
Proof.
  destruct flow_meets as [_ _ L _ _]. apply gram_is in seen. apply gram_is.
  rewrite <- (equal_bounced _ _ _ _ _ L).
  eapply law_next; [exact one_positive | exact half_positive | exact distinct | exact seen | exact certified_of_balls].
Qed.
(* Nobody overlaps there, and only o and c touch. *)
Theorem flow_apart_after : let z := collided d r o c (later flight_time x) in
  1 <= square d z o c /\ 1 < square d z o i /\ 1 < square d z c i.
Proof.
  destruct flow_meets as [_ _ L _ O]. destruct distinct as (D1 & D2 & D3). destruct (O i D1 D3) as (P & Q).
  cbn zeta. unfold square. rewrite !to_collided. fold (square d (later flight_time x) o c)
    (square d (later flight_time x) o i) (square d (later flight_time x) c i).
  rewrite !square_of_distance, L. split; [lra|]. split; rewrite <- (Rmult_1_l 1) at 1; apply Rmult_le_0_lt_compat; lra.
Qed.
End FlowStep.

Lemma kap_positive r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' :
  flow_collision r v lam rho eps sig A B C a b w y q kap s T C' lam' A' B' a' b' w' eps' ->
  0 < eps -> 0 < kap.
Proof.
  intros H E. destruct H as [_ _ L _ _ _ K _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _]. rewrite K.
  repeat apply Rdiv_lt_0_compat; assumption.
Qed.
