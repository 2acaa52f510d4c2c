"""One step of the recursion of `THEORSS4.1ExistenCollapse`, for every state."""
