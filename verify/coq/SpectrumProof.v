(* What Spectrum.v says is proved. *)
From Coq Require Import Reals.
From Verify Require Import Spectrum SpectrumMatrix SpectrumRoots SpectrumEigen SpectrumOrbits.
Open Scope R_scope.

Theorem matrix_proved : basis_theorem /\ matrix_theorem /\ stated_theorem /\ one_triple_theorem.
Proof. exact (conj basis_holds (conj matrix (conj stated one_triple))). Qed.
Theorem spectrum_proved : characteristic_theorem /\ spectrum_theorem /\ eigenvector_theorem /\
  parameter_theorem /\ orbit_theorem.
Proof. exact (conj characteristic (conj spectrum (conj eigenvectors (conj parameter orbits)))). Qed.
