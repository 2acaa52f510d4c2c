"""What to write for a line of a file that is not TOML: it is read leniently, and written anew.

Only a line that the reader of TOML accepts is proposed. Nothing here decides what a file means.
"""

from __future__ import annotations

import re
import tomllib
from contextlib import suppress

from verify.wire.inputs import InputError, shown
from verify.wire.meant import hundredth, ungrouped

#: A longer line is not shown in a message.
MAX_SHOWN = 240
#: A statement of more lines, or of more signs, is not mended.
MAX_LINES, MAX_SIGNS = 200, 4000

_WORD_KEY = r"""(?:"[^"\n]*"|'[^'\n]*'|[^\s=:<>\[\]{},;"'#!]+'*)"""
_KEY = rf"""{_WORD_KEY}(?:[ \t]+(?![\d.+-])[^\s=:<>\[\]{{}},;"'#!]+){{0,4}}"""
#: What stands outside of quotes.
_OUTSIDE = re.compile(r"""(?:"[^"\n]*"|'[^'\n]*')()|[^"']+|.""", re.DOTALL)
#: A key with the sign after it, and what follows.
_ENTRY = re.compile(rf"[ \t]*({_KEY})[ \t]*(:=|==|=|:)(.*)", re.DOTALL)
#: The same without a sign.
_UNSIGNED = re.compile(rf"[ \t]*({_WORD_KEY})[ \t]+((?:[\[{{\"'“]|[+-]?\.?\d).*)", re.DOTALL)
_NO_VALUE = re.compile(rf"[ \t]*{_KEY}[ \t]*=\s*")
#: How a line begins with which a statement begins.
_BEGINNING = re.compile(
    rf"[ \t]*(?:{_KEY}[ \t]*(?::=|==|=|:)|\[\[?[A-Za-z_][^,\[\]]*\]*[ \t]*(?:#|$))"
)
_HEADER = re.compile(
    r"[ \t]*(\[{0,2})[ \t]*([^\[\]#=,\s][^\[\]#=,]*?)[ \t]*(\]{0,2})[ \t:;,]*(?:#.*)?"
)
_LONG_TEXT = re.compile(r'"""(?:[^\\]|\\.)*?"{3,5}|' + r"'''.*?'{3,5}", re.DOTALL)
_AT_LINE = re.compile(r"\(at line (\d+)")

_SIGNS = str.maketrans(
    {**dict.fromkeys("\u00a0\u2007\u202f\u3000", " "), **dict.fromkeys("\u200b\ufeff\r", "")}
    | dict(zip("−–，；＝［］", "--,;=[]", strict=True))
)
_QUOTES = {'"': '"', "'": "'", "“": "”“", "„": "“”", "”": "”", "‘": "’", "’": "’", "«": "»"}
_QUOTES["`"] = "`´"
_UNIT = re.compile(
    r"([+-]?\d+(?:[.,]\d+|/\d+)?(?:[eE][+-]?\d+)?) ?"
    r"(?:[kcmµunM]?m|Å|in|ft|[kmµ]?g|[mµun]?s|min|h|diameters?)(?:/(?:[mµun]?s|min|h))?"
)
_TABLE = re.compile(rf"""\s*{_WORD_KEY}[ \t]*=[ \t]*["']""")
_DECIMAL_COMMA = re.compile(r"\s*([+-]?\d+),(\d+)\s*(?:#[^\n]*\s*)?")
_NUMBER = re.compile(r"([+-]?)(\d*)(?:\.(\d*))?([eE][+-]?\d+)?")


def error_about(path: str, text: str, told: str, otherwise: str) -> InputError:
    """The error for a text of which the reader of TOML has told why it is none.

    ``otherwise`` is what to write where no line of the text can be mended.
    """
    number, what, instead = _remedy(text, told)
    place = f", line {number}" if number else ""
    return InputError(f"{path}{place}: is not valid TOML ({what}); {instead or otherwise}")


def _remedy(text: str, told: str) -> tuple[int, str, str]:
    """The line, what is wrong there, and what to write, or nothing where that is not known."""
    if text.lstrip().startswith("{"):
        return 1, "it looks like JSON", "write lines such as r = 0.03, without braces around them"
    lines = _LONG_TEXT.sub(lambda found: '"_"' + "\n" * found[0].count("\n"), text).split("\n")
    number = _line_of(told, lines)
    twice = _twice(lines, number, told)
    if twice:
        return number, *twice
    if "Illegal character" in told and "\\n" not in told:
        return number, " ".join(told.split()), "leave it out"
    found = _beginnings(lines, number, is_known="end of document" not in told)
    for start in found:
        statement = "\n".join(lines[start : _end(lines, start)])
        alone = "\n".join(lines[start : found[-1]])
        if not _is_toml(statement) and not (start < found[-1] == number - 1 and _is_toml(alone)):
            what, instead = _told_of(statement, told)
            return start + 1, what or " ".join(told.split()), instead
    return number, " ".join(told.split()), ""


def _told_of(statement: str, told: str) -> tuple[str, str]:
    """What is wrong with a statement that is not TOML, and what to write."""
    for quotes in ('"""', "'''"):
        if quotes in statement:
            return f"a text begins with {quotes} and does not end", f"end it with {quotes}"
    if "escape" in told.lower():
        return "a backslash in a text", _instead_of_backslash(statement)
    if _NO_VALUE.fullmatch(statement):
        return "nothing stands after the =", ""
    if len(statement) > MAX_SIGNS:
        return "", ""
    with suppress(_UnreadError, RecursionError):
        what, mended = _mended(statement)
        if _is_toml(mended):
            is_whole = len(mended) <= MAX_SHOWN and '"_"' not in statement
            return what, f"write {mended}" if is_whole else "mend it there"
    return "", ""


def _instead_of_backslash(statement: str) -> str:
    if re.search(r"\\[A-Za-z]{2,}", statement):
        return r"TeX is not read, write for example (a/b)*sqrt(x) <= alpha"
    return r"write \\ for it"


def _line_of(told: str, lines: list[str]) -> int:
    """The number of the line in which the reader has stopped."""
    found = _AT_LINE.search(told)
    last = max((i for i, line in enumerate(lines, 1) if line.strip()), default=1)
    return min(int(found[1]), last) if found else last


def _twice(lines: list[str], number: int, told: str) -> tuple[str, str] | None:
    """What is said where a key or a table stands twice, and what to write."""
    line = lines[number - 1].strip()
    if "Cannot declare" in told:
        first = next(
            (i for i, other in enumerate(lines[: number - 1], 1) if other.strip() == line), 0
        )
        place = f", in line {first} too" if first else ""
        return f"a table stands there twice: {line}{place}", "write its lines together"
    if "Duplicate inline table key" in told:
        return "a key stands there twice", "leave one of them out"
    if "Cannot overwrite a value" not in told and "Cannot mutate immutable" not in told:
        return None
    entry = _ENTRY.match(line)
    name = entry[1].strip() if entry else ""
    place = ""
    for i in range(number - 2, -1, -1):
        before = _ENTRY.match(lines[i])
        if name and before and before[1].strip() == name:
            place = f": {name}, in line {i + 1} too"
            break
    return f"a name stands there twice{place}", "leave one out or choose another"


def _beginnings(lines: list[str], number: int, *, is_known: bool) -> list[int]:
    """The lines in which the statement before a line begins, and the statement of that line.

    All above where it is not known in which line the mistake is.
    """
    found: list[int] = []
    least = number - 1 - MAX_LINES if is_known else -1
    for i in range(number - 1, max(-1, least), -1):
        if _BEGINNING.match(lines[i]) or (i == number - 1 and _stands_alone(lines, i)):
            found.append(i)
        if is_known and len(found) == 2:
            break
    return found[::-1]


def _stands_alone(lines: list[str], i: int) -> bool:
    """Whether a line without a key is no part of what begins before it."""
    before = next((line.rstrip() for line in reversed(lines[:i]) if line.strip()), "")
    return bool(lines[i].strip()) and not before.endswith((",", "[", "{"))


def _end(lines: list[str], start: int) -> int:
    """The line before which a statement ends; braces that are closed below belong to it."""
    most = min(len(lines), start + MAX_LINES)
    depth = 0
    for i in range(start, most):
        depth += lines[i].count("{") - lines[i].count("}")
        if depth <= 0:
            break
    else:
        i = start
    return next((j for j in range(i + 1, most) if _BEGINNING.match(lines[j])), most)


def _is_toml(text: str) -> bool:
    try:
        tomllib.loads(text, parse_float=str)
    except (ValueError, RecursionError):
        return False
    return True


class _UnreadError(Exception):
    """A statement that cannot be read leniently either."""


def _mended(statement: str) -> tuple[str, str]:
    """What is wrong with a statement, and the statement as TOML."""
    clean = _OUTSIDE.sub(_plain, statement).strip("\n")
    header = _HEADER.fullmatch(clean.strip())
    if header and (header[1] or header[3]):
        return _mended_header(*header.groups())
    what, mended = _mended_entry(clean)
    return what or "it has signs that only look like -, =, commas or spaces", mended


def _plain(found: re.Match[str]) -> str:
    """What stands outside of quotes, with the signs of TOML."""
    return found[0] if found[1] is not None else found[0].translate(_SIGNS)


def _mended_entry(statement: str) -> tuple[str, str]:
    entry, sign = _ENTRY.match(statement), ""
    if entry is None:
        entry = _UNSIGNED.match(statement)
        if entry is None:
            return _unnamed(statement)
        key, rest = entry.groups()
    else:
        key, sign, rest = entry.groups()
    if re.search(r"[-+*/^(]", key) and not re.search("[\"']", key) and sign in ("=", "=="):
        return _unnamed(statement)
    if sign == ":" and not rest.strip():
        return _mended_header("", key, "")
    reader = _Reader(rest)
    if sign != "=":
        reader.told(f"after {key} stands {sign}, not =" if sign else f"there is no = after {key}")
    mended = f"{reader.key(key)} = {reader.whole()}"
    return reader.what, mended


def _unnamed(statement: str) -> tuple[str, str]:
    """A claim, or another text, without a name."""
    text = " ".join(statement.split("#")[0].split()).strip("\"'")
    if not text or re.search("^\\[|[\"'\\\\]", text):
        raise _UnreadError
    return f"{shown(text)} has no name before it", f'name = "{text}"'


def _mended_header(before: str, name: str, after: str) -> tuple[str, str]:
    marks = 2 if name == "chapters" else 1
    are_right = len(before) == len(after) == marks
    what = "" if are_right else f"the brackets around {name} are not right"
    parts = []
    for part in name.split("."):
        plain = part.strip()
        if not _is_toml(f"[{plain}]"):
            plain, what = f'"{plain}"', what or f"{plain} stands without quotes"
        parts.append(plain)
    return what or "a sign stands after the brackets", "[" * marks + ".".join(parts) + "]" * marks


class _Reader:
    """Reads a value leniently; the first thing that is wrong is told in ``what``."""

    def __init__(self, text: str) -> None:
        self.text, self.at, self.what = text, 0, ""
        self.odd = any(line.count('"') % 2 or line.count("'") % 2 for line in text.split("\n"))

    def told(self, what: str) -> None:
        """Keep what is wrong, if it is the first."""
        self.what = self.what or what

    def key(self, key: str) -> str:
        """A key that TOML reads."""
        if _is_toml(f"{key} = 1"):
            return key
        if re.fullmatch(r"\w+(?:[ \t]+\w+)+", key, re.ASCII):
            self.told(f"the name {shown(key)} has a space in it")
            return "_".join(key.split())
        self.told(f"the name {key} stands without quotes")
        return _quoted(key[1:-1] if key[0] in "\"'" else key)

    # --- signs -----------------------------------------------------------------------------------

    def _next(self, blank: str = " \t\n") -> str:
        """The next sign that is no space and in no comment; nothing at the end."""
        while self.at < len(self.text):
            sign = self.text[self.at]
            if sign == "#" or self.text.startswith("//", self.at):
                if sign != "#":
                    self.told("a comment begins with #")
                end = self.text.find("\n", self.at)
                self.at = len(self.text) if end < 0 else end
            elif sign in blank:
                self.at += 1
            else:
                return sign
        return ""

    # --- values ----------------------------------------------------------------------------------

    def whole(self) -> str:
        """The value after a key, with nothing behind it."""
        decimal = _DECIMAL_COMMA.fullmatch(self.text)
        if decimal:
            self.told(f"{decimal[1]},{decimal[2]} has a decimal comma")
            return _number(f"{decimal[1]}.{decimal[2]}")
        if not self._next():
            raise _UnreadError
        if _TABLE.match(self.text):
            self.told("a table stands without braces")
            self.text = f"{{{self.text.strip()}}}"
            self.at = 0
        values, comma, is_apart = self._values()
        if len(values) == 1:
            if comma:
                self.told(f"{comma} stands at the end")
            return values[0]
        if is_apart and not all(value.startswith("[") or _number(value) for value in values):
            return self._one_text()
        self.what = "a list stands without brackets"  # whatever else there is, that is the cause
        return f"[{', '.join(values)}]"

    def _values(self) -> tuple[list[str], str, bool]:
        """All values, a comma at the end, and whether a comma is missing between two of them."""
        values, comma, is_apart = [self._value("")], "", False
        while sign := self._next():
            if sign in ",;":
                comma = sign
                self.at += 1
            elif sign in "]})":
                self.told(f"there is a {sign} too many")
                self.at += 1
            else:
                is_apart = is_apart or not comma
                values.append(self._value(""))
                comma = ""
        return values, comma, is_apart

    def _one_text(self) -> str:
        """A text with quotation marks of its own kind in it."""
        text = self.text.strip()
        if len(text) < 2 or text[0] != text[-1] or text[0] not in "\"'" or "\n" in text:
            raise _UnreadError
        self.what = f"a text in {text[0]} has {text[0]} in it"
        return _quoted(text[1:-1])

    def _value(self, around: str) -> str:
        sign = self._next()
        after = self.text[self.at + 1 : self.at + 2]
        if sign == "[":
            return self._list("]")
        if sign == "(" and self._is_tuple():
            self.told("a list stands in parentheses, not in brackets")
            return self._list(")")
        if sign == "{":
            return self._table()
        if sign in _QUOTES and not (sign == "'" and after == ""):
            return self._string(around)
        return self._bare(around)

    def _is_tuple(self) -> bool:
        """Whether the parenthesis here is around a list, not around a part of a formula."""
        depth = 0
        for i in range(self.at, len(self.text)):
            depth += (self.text[i] in "([") - (self.text[i] in ")]")
            if depth == 0:
                rest = self.text[i + 1 :].lstrip(" \t")
                inside = self.text[self.at : i]
                return "," in inside and (not rest or rest[0] in ",;])}\n#(")
        return False

    def _list(self, closing: str) -> str:
        self.at += 1
        items: list[str] = []
        has_comma, is_open = True, True
        while is_open:
            sign = self._next()
            if not sign:
                self.told(f"a {closing} is missing")
                break
            if sign in "])}":
                if sign != closing and {sign, closing} != {")", "]"}:
                    self.told(f"a {closing} is missing")
                    break
                self.at += 1
                is_open = False
            elif sign in ",;":
                if sign == ";":
                    self.told("; stands where a comma belongs")
                has_comma = True
                self.at += 1
            elif sign in "[(" and items and not items[-1].startswith("[") and has_comma:
                self.told("a ] is missing")
                is_open = False
            else:
                if not has_comma:
                    self.told(f"a comma is missing after {items[-1]}")
                self._item(items, closing)
                has_comma = False
        return f"[{', '.join(items)}]"

    def _item(self, items: list[str], closing: str) -> None:
        """One more item; or the digits behind a decimal comma, which belong to the last one."""
        close = self.text[self.at - 1 : self.at] == ","
        digits = re.match(r"0\d+(?=[ \t]*[\],])", self.text[self.at :])
        if items and close and digits and re.fullmatch(r"[+-]?\d+", items[-1]):
            self.told(f"{items[-1]},{digits[0]} has a decimal comma")
            items[-1] = f"{items[-1]}.{digits[0]}"
            self.at += len(digits[0])
        else:
            items.append(self._value(closing))

    def _table(self) -> str:
        self.at += 1
        if self._next() in ("[", "("):
            self.told("a list stands in braces, not in brackets")
            self.at -= 1
            return self._list("}")
        entries: list[str] = []
        while (sign := self._next()) and sign not in ")]}":
            if sign == ";":
                self.told("; stands where a comma belongs")
            if sign in ",;":
                self.at += 1
            else:
                entries.append(self._table_entry())
        if sign == "}":
            self.at += 1
        else:
            self.told("a } is missing")
        if "\n" in self.text or self.text.rstrip().endswith(",}"):
            self.told("braces and what is in them stand in one line, without a comma at the end")
        return f"{{ {', '.join(entries)} }}"

    def _table_entry(self) -> str:
        entry = _ENTRY.match(self.text, self.at)
        if entry is None:
            raise _UnreadError
        if entry[2] != "=":
            self.told(f"after {entry[1]} stands {entry[2]}, not =")
        self.at = entry.start(3)
        if not self._next():
            raise _UnreadError
        return f"{self.key(entry[1])} = {self._value('}')}"

    def _string(self, around: str) -> str:
        quote = self.text[self.at]
        closing = _QUOTES[quote]
        plain = quote in "\"'"
        body = r"(?:[^\\\n%s]|\\.)*" if quote == '"' else r"[^\n%s]*"
        found = re.compile(body % re.escape(closing) + f"[{closing}]").match(self.text, self.at + 1)
        if found and not (self.odd and self._is_cut(found)):
            self.at = found.end()
            inside = found[0][:-1]
            if plain and _is_toml(f"v = {quote}{inside}{quote}"):
                return f"{quote}{inside}{quote}"
            self.told(f"the quotation mark {quote} is not one of TOML's")
            return _quoted(inside)
        self.told(f"a quotation mark {'is missing' if plain else 'of TOML is missing'}")
        return self._unclosed(around)

    def _is_cut(self, found: re.Match[str]) -> bool:
        """Whether a text goes on behind the place where its quotation mark is missing."""
        inside, after = found[0][:-1], self.text[found.end() : found.end() + 1]
        is_several = re.match(r"[ \t]*[\w./+-]*[ \t]*(?:\][ \t]*,|,[ \t]*\[)", inside)
        is_before = inside.rstrip().endswith(",") and after not in ("", *" \t\n,]}#")
        return bool(is_several) or is_before

    def _unclosed(self, around: str) -> str:
        """A text without its second mark: one word, or all up to the end of the line."""
        word = re.compile(r"[ \t]*[\w./+*^<>=() -]+").match(self.text, self.at + 1)
        is_word = word is not None and word[0].count("(") == word[0].count(")")
        if around and word and is_word and self.text[word.end() : word.end() + 1] in (*",]}",):
            self.at = word.end()
            return _quoted(word[0].strip())
        line = re.compile(r"[^\n]*").match(self.text, self.at + 1)
        inside = line[0] if line else ""
        self.at += 1 + len(inside)
        if around:
            kept = re.sub(r"[\s\],}]+$", "", inside)
            self.at -= len(inside) - len(kept)
            inside = kept
        else:
            inside = re.sub(r"[ \t]+#.*", "", inside)
        return _quoted(inside.strip().rstrip("\"'”“’"))

    def _bare(self, around: str) -> str:
        """A word without quotes: a number, or what has to stand in quotes."""
        word = self._word(around)
        if word.endswith(tuple(_QUOTES)):
            self.told("a quotation mark is missing")
            return _quoted(word.strip("".join(_QUOTES)))
        numbers = [_number(part) for part in word.split()]
        if len(numbers) > 1 and all(numbers):
            whole = ungrouped(word) if re.search(r"[ \t]0\d\d", word) else ""
            if whole:
                self.told(f"a number has spaces in it: {word}")
                return whole
            if around:
                self.told(f"a comma is missing after {numbers[0]}")
                return ", ".join(map(str, numbers))
            self.told("a list stands without brackets and commas")
            return f"[{', '.join(map(str, numbers))}]"
        return self._mended_word(word)

    def _word(self, around: str) -> str:
        depth, start = 0, self.at
        while self.at < len(self.text):
            sign = self.text[self.at]
            depth += (sign == "(") - (sign == ")")
            ends = sign in "\n#" or (sign in ",;[]{}" and depth <= 0)
            if ends or (depth < 0 and around == ")") or self.text.startswith("//", self.at):
                break
            self.at += 1
        word = self.text[start : self.at].strip()
        if not word:
            raise _UnreadError
        return word

    def _mended_word(self, word: str) -> str:
        if re.search("[\"']|^(--|%|/[*])", word):
            raise _UnreadError
        if _is_toml(f"v = {word}"):
            return word
        number = _number(word)
        if number:
            self.told(f"{word} is no number of TOML")
            return number
        percent = re.fullmatch(r"(\d{1,9}(?:\.\d{1,9})?)[ \t]*%", word)
        if percent:
            self.told(f"{word} is in percent")
            return hundredth(percent[1])
        unit = _UNIT.fullmatch(word)
        if unit:
            self.told(f"{word} has a unit; all numbers of a file are in one unit")
            return self._mended_word(unit[1].replace(",", "."))
        whole = ungrouped(word)
        if whole and "or" not in whole:
            self.told(f"the digits of {word} stand in groups")
            return whole
        if word.lower() in ("true", "false"):
            self.told(f"{word} begins with a capital")
            return word.lower()
        what = (
            "a fraction" if re.fullmatch(r"[+-]?\d+[ \t]*/[ \t]*\d+", word) else "what is no number"
        )
        self.told(f"{shown(word)} is without quotes; {what} stands in quotes")
        return _quoted(re.sub(r"[ \t]*/[ \t]*", "/", word) if what == "a fraction" else word)


def _number(word: str) -> str:
    """The number of TOML that a word means, such as 0.5 for .5; else nothing."""
    if re.fullmatch(r"[+-]?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?", word):
        return word
    found = _NUMBER.fullmatch(word)
    if found is None or not (found[2] or found[3]):
        return ""
    sign, whole, digits, exponent = found.groups()
    whole = whole.lstrip("0") or "0"
    return f"{sign}{whole}{f'.{digits}' if digits else ''}{exponent or ''}"


def _quoted(text: str) -> str:
    """A text in quotes.

    Raises:
        _UnreadError: if it has quotes in it.
    """
    for quote in "\"'":
        if quote not in text and _is_toml(f"v = {quote}{text}{quote}"):
            return f"{quote}{text}{quote}"
    raise _UnreadError
