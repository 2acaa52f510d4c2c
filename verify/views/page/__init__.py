"""The report as a page: what it says (`content`), and how that is written (`html`, `text`)."""
