(* Theorem 1 as the paper prints it, with < in (4.10), and that it is false: what is proved. This page
   can be read after Theorem1.v and Classification.v; it proves nothing.

   The collapse is the weakest that the text can mean: the balls may collide in any order first, and
   need not begin with 0 and 2; no time bounds the collapses of the whole set. *)
From Coq Require Import Reals Arith.
From Verify Require Import Theorem1 Classification.
Open Scope R_scope.

(* From s there are collisions without end, in finite time; from some collision on, ball 0 meets the
   other two in turn. The places converge, relative to one another, and in the limit minus the cosine of
   the angle at ball 0 is c, to within the tolerance. *)
Definition nearly_linear (d : nat) (r : R) (s : scene) (c tolerance : R) : Prop :=
  exists scenes time i j T at_T a b N, endless d r s scenes time i j /\ Un_cv time T /\
    distinct_balls B0 a b /\ in_turn_from N i j B0 a b /\ settles d scenes at_T /\
    Rabs (minus_cosine d at_T - c) <= tolerance.

(* (4.9) and (4.10), as printed. *)
Definition hypotheses_as_printed (r theta_0 delta_theta : R) : Prop :=
  0 < r < 9 - 4 * sqrt 5 /\ PI / 2 < theta_0 <= PI /\
  0 < - cos theta_0 < 2 * cube_root r * (1 + cube_root r) / (1 + r) /\ 0 < delta_theta.
Definition as_printed_at (d : nat) (r theta_0 delta_theta : R) : Prop :=
  exists set, has_interior d set /\
    forall s, set s -> nearly_linear d r s (- cos theta_0) delta_theta.
Definition as_printed : Prop :=
  forall r theta_0 delta_theta d, (2 <= d)%nat -> hypotheses_as_printed r theta_0 delta_theta ->
  as_printed_at d r theta_0 delta_theta.

Definition printed_sign_theorem : Prop :=
  ~ as_printed /\
  (* It is false for all r and theta_0 that it admits, once delta_theta is so small that (4.10), as printed,
     holds for - cos theta_0 + delta_theta, too: no scene with angular momentum collapses as it is claimed. *)
  (forall d r theta_0 delta_theta, (2 <= d)%nat -> 0 < r < 1 ->
    - cos theta_0 + delta_theta < 2 * cube_root r * (1 + cube_root r) / (1 + r) ->
    ~ as_printed_at d r theta_0 delta_theta) /\
  (forall d r s c delta_theta, 0 < r < 1 -> 0 < spin2 d s ->
    c + delta_theta < 2 * cube_root r * (1 + cube_root r) / (1 + r) ->
    ~ nearly_linear d r s c delta_theta) /\
  (* For some of these parameters no scene at all does. *)
  (exists r theta_0 delta_theta, hypotheses_as_printed r theta_0 delta_theta /\
    - cos theta_0 + delta_theta < 4 * sqrt r / (1 + r)) /\
  (forall d r s c delta_theta, 0 < r < 1 -> c + delta_theta < 4 * sqrt r / (1 + r) ->
    ~ nearly_linear d r s c delta_theta) /\
  (* What Theorem1.v calls a collapse is one. *)
  (forall d r s by_time c tolerance, 0 < r < 1 ->
    collapse d r s by_time c tolerance -> nearly_linear d r s c tolerance).
