"""Search for proofs of claims with variables: one technique in each file. None is trusted."""
