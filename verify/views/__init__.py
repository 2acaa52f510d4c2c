"""What people see of a statement and its outcome; decides nothing.

Begin with `screen.py` for the terminal, `document.py` for JSON, `page/build.py` for the page.
"""
