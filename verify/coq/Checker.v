(* Whether a certificate proves its statement: step by step, with the rules of Kernel.v. Accepted.v
   proves that the answer is right. *)
From Coq Require Import Reals QArith Qreals ZArith NArith List Lra Lia Bool Arith FMapPositive.
From Verify Require Import Meaning Polynomials Terms Substitution Clearing Enclosures Kernel.
Import ListNotations.
Open Scope R_scope.

(* --- certificates ----------------------------------------------------------------------------- *)

Inductive defining : Set := ByClearing | ByInterval (bits : positive) (bounds : list bound).
Inductive row_proof : Set :=
| ByProof (q : proof)
| ByWitness (at_ : substitution) (premises : list proof) (negation : proof)
| ByInstance (premises : list proof)
| ByInduction (start next : list proof).
Inductive step : Set :=
| Open_ (c : nat) (premises : list proof)
| Lemma_ (name : positive) (c : nat) (g : claim) (q : proof)
| Constant_ (name : positive) (term : positive) (d : defining)
| Obligation (row : positive) (q : row_proof).
(* The value of a term lies between two rational numbers. *)
Record ends : Set := Ends { enclosed : positive; ends_bits : positive; low : Q; high : Q }.
Record certificate : Set := Certificate {
  shared : list (positive * list positive);  (* terms to be enclosed once, for each precision *)
  steps : list step;
  enclosures : list ends
}.

Section Checker.
Variable S : statement.
Variable T : PM.t node.
Variable K : PM.t positive.
Variable H : PM.t nat.
Notation home := (home_in H).
Variable rows_by_number : PM.t row.
Variable grounds : list (positive * memory).

Record state : Type := State {
  known : facts;
  opened : list nat;  (* contexts that have a point *)
  done_rows : PM.t unit;
  done_constants : PM.t unit
}.

Definition pushed (t : positive) (c : nat) (m : PM.t (list nat)) : PM.t (list nat) :=
  PM.add t (match PM.find t m with Some l => c :: l | None => [c] end) m.
Definition install (name : positive) (c : nat) (g : claim) (F : facts) : facts :=
  let zero := is_zero T (lhs g) in
  Facts (PM.add name (c, g) (named F))
    (if zero && same_relation (relation_of g) Less then pushed (rhs g) c (positives F)
     else positives F)
    (if zero && same_relation (relation_of g) AtMost then pushed (rhs g) c (nonnegatives F)
     else nonnegatives F)
    (having_values F).
Definition with_value (c : nat) (i : positive) (F : facts) : facts :=
  Facts (named F) (positives F) (nonnegatives F) (PM.add i c (having_values F)).
Definition in_scope (c : nat) (g : claim) : bool :=
  is_inside S c (home (lhs g)) && is_inside S c (home (rhs g)).
Definition is_open (s : state) (c : nat) : bool :=
  Nat.eqb c 0 || existsb (Nat.eqb c) (opened s).
Notation prove F := (prove S T K H F grounds).
Notation at_context c := (no_hypotheses c).

(* Terms that have values, put for the variables of a context; premises for some of its givens. *)
Definition holds_after (F : facts) (p : place) (c : nat) (at_ : substitution) (l : list given)
  (premises : list proof) : bool :=
  givens_hold S T K H F (prove F) p c at_ (phi_of S T K H c at_) l premises.

Definition is_carried (a : given) : bool :=
  match given_kind a with Carried => true | _ => false end.
Definition is_plain (a : given) : bool :=
  match given_kind a with Plain => true | _ => false end.
Definition applies (F : facts) (c d : nat) (at_ : substitution) (premises : list proof) : bool :=
  in_parent S (at_context c) d &&
  holds_after F (at_context c) d at_ (givens_of S d) premises.
Definition induction (F : facts) (c d : nat) (start next : substitution)
  (first later : list proof) : bool :=
  Nat.eqb (parent_of S d) c && negb (existsb is_plain (givens_of S d)) &&
  holds_after F (at_context c) d start (filter is_carried (givens_of S d)) first &&
  holds_after F (at_context d) d next (filter is_carried (givens_of S d)) later.
Definition witness (s : state) (c : nat) (g : claim) (at_ : substitution)
  (premises : list proof) (negation : proof) : bool :=
  let outside := at_context (parent_of S c) in
  is_open s (parent_of S c) &&
  holds_after (known s) outside c at_ (givens_of S c) premises &&
  match substituted S H c (phi_of S T K H c at_) g with
  | Some h => prove (known s) outside (negated h) negation
  | None => false
  end.
Definition define (F : facts) (p : place) (t : positive) (d : defining) : bool :=
  match d with
  | ByClearing => clears S T K F p [t]
  | ByInterval bits bounds =>
      match enclosing S T H F bits p (ground grounds bits) bounds with
      | Some m => match enclose T bits levels m t with Some _ => true | None => false end
      | None => false
      end
  end.
(* The givens one by one: each at the point, then its sides in the context itself. *)
Fixpoint open_givens (c : nat) (at_ : substitution) (phi : PM.t positive) (F : facts)
  (l : list given) (premises : list proof) : option facts :=
  match l, premises with
  | [], [] => Some F
  | a :: l, q :: premises =>
      let g := given_claim a in
      let* h := substituted S H c phi g in
      if prove F (at_context (parent_of S c)) h q && clears S T K F (at_context c) [lhs g; rhs g]
      then open_givens c at_ phi (install (given_name a) c g F) l premises
      else None
  | _, _ => None
  end.
Definition point_of (c : nat) : substitution :=
  match context_at S c with Some x => point x | None => [] end.

Definition obligation (s : state) (r : row) (q : row_proof) : option facts :=
  let F := known s in
  let c := row_context r in
  match row_sentence r, row_verdict r, q with
  | Compare g, Proved, ByProof q =>
      if in_scope c g && prove F (at_context c) g q then Some (install (row_name r) c g F) else None
  | Compare g, Refuted, ByProof q =>
      if in_scope c g && prove F (at_context c) (negated g) q then Some F else None
  | Compare g, Refuted, ByWitness at_ premises negation =>
      if in_scope c g && witness s c g at_ premises negation then Some F else None
  | Applies d at_, Proved, ByInstance premises =>
      if applies F c d at_ premises then Some F else None
  | Always d start next, Proved, ByInduction first later =>
      if induction F c d start next first later then Some F else None
  | _, _, _ => None
  end.
Definition take (s : state) (x : step) : option state :=
  match x with
  | Open_ c premises =>
      let outside := at_context (parent_of S c) in
      let at_ := point_of c in
      if is_open s (parent_of S c) && negb (is_open s c) && negb (Nat.eqb c 0) &&
         same_names (variables_of S c) at_ && of_context T c at_ &&
         clears S T K (known s) outside (map snd at_)
      then
        let* F := open_givens c at_ (phi_of S T K H c at_) (known s) (givens_of S c) premises in
        Some (State F (c :: opened s) (done_rows s) (done_constants s))
      else None
  | Lemma_ name c g q =>
      if is_open s c && in_scope c g && prove (known s) (at_context c) g q
      then Some (State (install name c g (known s)) (opened s) (done_rows s) (done_constants s))
      else None
  | Constant_ name i d =>
      match PM.find i T with
      | Some (NConstant c a) =>
          if is_open s c && define (known s) (at_context c) a d
          then Some (State (install name c (Claim Equal i a) (with_value c i (known s)))
                 (opened s) (done_rows s) (PM.add i tt (done_constants s)))
          else None
      | _ => None
      end
  | Obligation k q =>
      let* r := PM.find k rows_by_number in
      if is_open s (row_context r) && negb (PM.mem k (done_rows s))
      then
        let* F := obligation s r q in
        Some (State F (opened s) (PM.add k tt (done_rows s)) (done_constants s))
      else None
  end.
Fixpoint run (s : state) (l : list step) : option state :=
  match l with
  | [] => Some s
  | x :: r => let* s1 := take s x in run s1 r
  end.

Definition citing (l : list (positive * (nat * claim))) (F : facts) : facts :=
  fold_right (fun x F => install (fst x) (fst (snd x)) (snd (snd x)) F) F l.
Definition defining_context (i : positive) : nat :=
  match PM.find i T with Some (NConstant c _) => c | _ => O end.
Definition initial : state :=
  State
    (fold_right (fun i F => with_value (defining_context i) i F)
       (citing (cited S) no_facts) (cited_constants S))
    (filter (fun c => negb (existsb (Nat.eqb c) (own_contexts S))) (seq 1 (length (contexts S))))
    (PM.empty unit) (PM.empty unit).
Definition decided (r : row) : bool :=
  match row_verdict r with Undecided => false | _ => true end.
Definition finished (s : state) : bool :=
  forallb (fun c => existsb (Nat.eqb c) (opened s)) (own_contexts S) &&
  forallb (fun i => PM.mem i (done_constants s)) (constants S) &&
  forallb (fun x => negb (decided (snd x)) || PM.mem (fst x) (done_rows s)) (listed 1 (rows S)) &&
  forallb (fun r => negb (row_needed r) ||
    match row_verdict r with Proved => true | _ => false end) (rows S).
Definition right_ends_at (e : ends) (bits : positive) : bool :=
  match enclose T bits levels (ground grounds bits) (enclosed e) with
  | Some (x, _) => decide bits AtMost (Exact (low e)) x && decide bits AtMost x (Exact (high e))
  | None => false
  end.
Definition right_ends (e : ends) : bool := at_some_precision (right_ends_at e) (ends_bits e).
End Checker.

(* Subterms and parents come first, and the names in givens are those in scope. *)
Definition well_formed (S : statement) (H : PM.t nat) : bool :=
  ordered (numbered S) && descending S && at_home S H &&
  forallb (fun c => forallb (fun a => in_scope S H c (given_claim a)) (givens_of S c))
    (seq 1 (length (contexts S))).
(* Each precision with what is enclosed for it, once. *)
Definition ground_terms (T : PM.t node) (l : list (positive * list positive)) :
  list (positive * memory) :=
  map (fun x => (fst x, match each (enclose T (fst x) levels) (PM.empty enclosure) (snd x) with
    | Some (_, m) => m | None => PM.empty enclosure end)) l.

(* Whether the certificate proves the statement. *)
Definition accepts (S : statement) (C : certificate) : bool :=
  let T := table (numbered S) in
  let K := keys (numbered S) in
  let H := homes S in
  let grounds := ground_terms T (shared C) in
  well_formed S H &&
  match run S T K H (table (listed 1 (rows S))) grounds (initial S T) (steps C) with
  | Some s => finished S s
  | None => false
  end &&
  forallb (right_ends T grounds) (enclosures C).

(* --- what is wrong, for messages --- *)

Inductive complaint : Set := IllFormed | AtStep (number : nat) | Unfinished | AtEnclosure (number : nat).
Fixpoint first_refused (S : statement) T K H by_number grounds (n : nat) (s : state) (l : list step) :
  complaint + state :=
  match l with
  | [] => inr s
  | x :: r =>
      match take S T K H by_number grounds s x with
      | Some s1 => first_refused S T K H by_number grounds (Datatypes.S n) s1 r
      | None => inl (AtStep n)
      end
  end.
Definition complaint_about (S : statement) (C : certificate) : option complaint :=
  let T := table (numbered S) in
  let grounds := ground_terms T (shared C) in
  if accepts S C then None
  else if well_formed S (homes S) then
    match first_refused S T (keys (numbered S)) (homes S) (table (listed 1 (rows S))) grounds 1
      (initial S T) (steps C) with
    | inl c => Some c
    | inr s =>
        if finished S s then
          match find (fun x => negb (right_ends T grounds (snd x))) (listed 1 (enclosures C)) with
          | Some x => Some (AtEnclosure (Pos.to_nat (fst x)))
          | None => Some Unfinished
          end
        else Some Unfinished
    end
  else Some IllFormed.
