"""What the paper prints outside the proof of Theorem 1 and the spectrum: Sections 1 to 4.1."""
