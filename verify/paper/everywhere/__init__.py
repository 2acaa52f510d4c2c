"""`THEORSS4.1ExistenCollapse` for all parameters at once."""
