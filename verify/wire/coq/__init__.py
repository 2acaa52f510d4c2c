"""Certificates for the proof assistant Coq, whose checker is in ``verify/coq``.

Terms, contexts and facts get the numbers under which ``verify/check.py`` reads them; that program
has to accept the certificate first. The numbering is not believed: Coq computes what it needs from
the data. What has to be believed is that the data are those in the files.
"""
