(* A scene that is finite after some collisions cites the flow and the classification. The rows of its
   certificate may be used, as both are true; of the classification it uses none here. *)
From Coq Require Import List.
From Verify Require Import Meaning Citations.
From Verify Require Flow Collapsing.
Import ListNotations.

Lemma citations : citations_true Collapsing.the_statement.
Proof.
  apply (citations_closed [(Flow.the_statement, size Flow.the_statement Collapsing.the_statement)]).
  - vm_compute. reflexivity.
  - repeat apply Forall_cons; [exact Flow.proved | constructor].
Qed.
