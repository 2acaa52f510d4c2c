"""Which collapses there are: four theorems beyond the paper, for every state."""
