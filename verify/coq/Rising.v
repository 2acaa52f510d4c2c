(* The rule of functions that rise: they keep the order of their arguments, and show it. *)
From Coq Require Import Reals ZArith List Lra Bool FMapPositive.
From Verify Require Import Meaning Roots Terms Substitution Clearing Cosines Laws.
Import ListNotations.
Open Scope R_scope.

Section RisingRules.
Variable T : PM.t node.
Variable K : PM.t positive.

Definition rises (f : elementary) : bool := negb (same_function f Sin).
Definition applied_node (f : rising) (a : positive) : node :=
  match f with SquareRoot => NSqrt a | Elementary f => NOf f a end.
(* The claim on arguments from that on values; or on the values of a function at both sides. *)
Definition below (under : option rising) (g : claim) : option claim :=
  let (r, a, b) := g in
  let equal := match r with Equal => true | _ => false end in
  match under with
  | None =>
      match PM.find a T, PM.find b T with
      | Some (NOf f c), Some (NOf h d) =>
          if same_function f h && (rises f || equal) then Some (Claim r c d) else None
      | Some (NSqrt c), Some (NSqrt d) => Some (Claim r c d)
      | Some (NCos c), Some (NCos d) | Some (NCosPi c), Some (NCosPi d) =>
          if equal then Some (Claim r c d) else None
      | _, _ => None
      end
  | Some f =>
      if match f with Elementary f => rises f | SquareRoot => true end then
        let* c := find_node T K (applied_node f a) in
        let* d := find_node T K (applied_node f b) in
        Some (Claim r c d)
      else None
  end.
End RisingRules.

(* --- soundness -------------------------------------------------------------------------------- *)

Lemma related_rising (D : R -> Prop) f r x y :
  (forall x y, D x -> D y -> x < y -> f x < f y) -> D x -> D y ->
  related r x y <-> related r (f x) (f y).
Proof.
  intros M X Y. pose proof (M x y X Y) as A. pose proof (M y x Y X) as B.
  destruct (Rtotal_order x y) as [L|[->|L]]; [specialize (A L) | | specialize (B L)];
    destruct r; cbn [related]; lra.
Qed.
Definition applies (f : rising) (x : R) : R :=
  match f with SquareRoot => sqrt x | Elementary f => applied f x end.
Definition domain (f : rising) (x : R) : Prop :=
  match f with SquareRoot => 0 <= x | Elementary f => in_domain f x end.
Lemma it_rises f x y : match f with Elementary f => rises f | SquareRoot => true end = true ->
  domain f x -> domain f y -> x < y -> applies f x < applies f y.
Proof.
  destruct f as [|[]]; cbn [domain applies in_domain applied]; intros R X Y L; try discriminate.
  - apply sqrt_lt_1; trivial.
  - now apply exp_increasing.
  - now apply ln_increasing.
  - now apply atan_increasing.
  - now apply nth_root_rises.
Qed.

Section SoundRising.
Variable S : statement.
Variable T : PM.t node.
Hypothesis ready : tabled S T.
Variable K : PM.t positive.
Variable v : valuation.
Notation val := (value_at S v).
Notation def := (defined_at S v).
Let value_of := value_is S T ready v.
Let defined_of := defined_is S T ready v.

Lemma rising_node f c i : PM.find i T = Some (applied_node f c) ->
  val i = applies f (val c) /\ (def i -> domain f (val c)).
Proof.
  intros E. rewrite (value_of _ _ E), (defined_of _ _ E). destruct f; cbn; tauto.
Qed.
Lemma below_sound under g h : below T K under g = Some h ->
  def (lhs g) -> def (rhs g) -> holds S v h -> holds S v g.
Proof.
  destruct g as [r a b]. unfold below, holds, stands. cbn [lhs rhs relation_of].
  intros E A B (C & D & H). split; [trivial|]. split; [trivial|].
  destruct under as [f|].
  - destruct (match f with SquareRoot => _ | Elementary _ => _ end) eqn:F; try discriminate.
    bind E c X. bind E d Y. injection E as <-. cbn [lhs rhs relation_of] in *.
    apply find_node_sound, rising_node in X, Y. destruct X as [X P], Y as [Y Q].
    rewrite X, Y in H. revert H. apply (related_rising (domain f)); auto.
    intros x y. now apply it_rises.
  - assert (R : forall f c d, match f with Elementary f => rises f | SquareRoot => true end = true ->
      PM.find a T = Some (applied_node f c) -> PM.find b T = Some (applied_node f d) ->
      h = Claim r c d -> related r (val a) (val b)).
    { intros f c d F X Y ->. cbn [lhs rhs relation_of] in *.
      apply rising_node in X, Y. destruct X as [X P], Y as [Y Q]. rewrite X, Y.
      revert H. apply (related_rising (domain f)); auto. intros x y. now apply it_rises. }
    destruct (PM.find a T) as [n|] eqn:X; try discriminate.
    destruct (PM.find b T) as [m|] eqn:Y; [|destruct n; discriminate].
    destruct n, m; try discriminate.
    + injection E as <-. now apply (R SquareRoot a0 a1).
    + destruct r; try discriminate. injection E as <-. rewrite (value_of _ _ X), (value_of _ _ Y).
      cbn in *. now rewrite H.
    + destruct r; try discriminate. injection E as <-. rewrite (value_of _ _ X), (value_of _ _ Y).
      cbn in *. now rewrite H.
    + destruct (same_function f f0) eqn:F; [|discriminate]. apply same_function_sound in F. subst f0.
      cbn [andb] in E. destruct (rises f) eqn:M.
      * injection E as <-. now apply (R (Elementary f) a0 a1).
      * cbn [orb] in E. destruct r; try discriminate. injection E as <-.
        rewrite (value_of _ _ X), (value_of _ _ Y). cbn in *. now rewrite H.
Qed.
End SoundRising.
