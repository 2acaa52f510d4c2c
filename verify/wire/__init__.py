"""The two files of a certificate: written, and read back."""
