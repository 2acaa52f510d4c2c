(* Induction over proofs, with those that are parts of them. *)
From Coq Require Import QArith List.
From Verify Require Import Meaning Clearing Kernel.
Import ListNotations.

Section Induction.
Variable P : proof -> Prop.
Hypothesis PGiven : forall f, P (Given_ f).
Hypothesis PInterval : forall b l, P (Interval b l).
Hypothesis PCuts : forall t l ps, Forall P ps -> P (Cuts t l ps).
Hypothesis PCases : forall t ps, Forall P ps -> P (Cases t ps).
Hypothesis PEntry : forall s e, P (Entry s e).
Hypothesis PLeast : forall s e ps, Forall P ps -> P (Least s e ps).
Hypothesis PRoot : P PositiveRoot.
Hypothesis PAntisymmetry : forall ps, Forall P ps -> P (Antisymmetry ps).
Hypothesis PAngles : P Angles.
Hypothesis PCosine : P Cosine_.
Hypothesis PRange : P Range.
Hypothesis PLaw : P Law.
Hypothesis PMonotony : forall u q, P q -> P (Monotony u q).
Hypothesis PSum : forall u a e, P (BySum u a e).
Hypothesis PInstance : forall f s ps, Forall P ps -> P (Instance f s ps).
Fixpoint proof_induction (p : proof) : P p :=
  let each_of := fix each_of (l : list proof) : Forall P l :=
    match l with
    | [] => Forall_nil P
    | q :: r => Forall_cons q (proof_induction q) (each_of r)
    end in
  match p with
  | Given_ f => PGiven f
  | Interval b l => PInterval b l
  | Cuts t l ps => PCuts t l ps (each_of ps)
  | Cases t ps => PCases t ps (each_of ps)
  | Entry s e => PEntry s e
  | Least s e ps => PLeast s e ps (each_of ps)
  | PositiveRoot => PRoot
  | Antisymmetry ps => PAntisymmetry ps (each_of ps)
  | Angles => PAngles
  | Cosine_ => PCosine
  | Range => PRange
  | Law => PLaw
  | Monotony u q => PMonotony u q (proof_induction q)
  | BySum u a e => PSum u a e
  | Instance f s ps => PInstance f s ps (each_of ps)
  end.
End Induction.
