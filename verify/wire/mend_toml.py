"""What to write for a line of a file that is not TOML: everyday slips are rewritten.

Only a line that the reader of TOML accepts is proposed. Nothing here decides what a file means.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable, Iterator
from re import Match

from verify.wire.inputs import InputError
from verify.wire.meant import hundredth

#: A longer statement is not mended, and at so many places a mark or a bracket is tried.
MAX_SIGNS, MAX_PLACES = 240, 12
#: A line with more signs is not looked at closely, nor a text with more marks behind a backslash.
MAX_LINE, MAX_MARKS = 4000, 100

_LONG_TEXT = re.compile(r'"""(?:[^\\]|\\.)*?"{3,5}|' + r"'''.*?'{3,5}", re.DOTALL)
_TEXT = re.compile(r"""(#[^\n]*)|"(?:[^"\\\n]|\\.)*"|'[^'\n]*'""")
#: The same in a long line, where the last one needs no end.
_TEXT_OR_REST = re.compile(r"""#[^\n]*|"[^"\\\n]*+(?:\\.[^"\\\n]*+)*+"?|'[^'\n]*+'?""")
#: Signs that stand for texts in quotes while a statement is rewritten.
_MASK, _T = 0xE000, "\ue000-\uf8ff"
_WORD = r"""(?:"[^"\n]*"|'[^'\n]*'|[^\s=:<>\[\]{},;"'#!()]+'*)"""
_BEGINNING = re.compile(
    rf"[ \t]*(?:{_WORD}(?:[ \t]+\w+){{0,4}}[ \t]*(?:=|:)|\[\[?[A-Za-z_][^,\[\]]*\]*[ \t]*(?:#|$))"
)
_NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?"
_DIGITS = r"(?<!\d )([+-]?)(?=\.?\d)(\d*)(?:\.(\d*))?([eE][+-]?\d+)?"
#: Before and after a value, or a number among others.
_FROM, _TO, _AFTER = r"(?<=[\[,=\s])", r"(?=\s*(?:[,\]}]|$))", r"(?=[\s,\]}]|$)"
_UNIT = r"(?:(?:[kcmµunM]?m|Å|in|ft|[kmµ]?g|[mµun]?s|min|h|diameters?)(?:/(?:[mµun]?s|min|h))?)"
_NEXT = rf"(?!0\d){_NUMBER}{_AFTER}|[\[{_T}]"
_ROUND = r"\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\)"
_ITEM = rf"(?:\[[^\[\]]*\]|(?:[^\[\]{{}},()]|{_ROUND})+)"
_SIGNS = dict(zip("\u00a0\u2007\u202f\u3000−–，；＝［］", "    --,;=[]", strict=True))
_SIGNS |= dict.fromkeys("\u200b\ufeff\r", "")
_PLAIN = rf"(?!\(\()(?:[^{_T}{''.join(_SIGNS)}\[\]{{}},;%()\"'=]|[<>]=|{_ROUND})+?"
_CLAIM = rf"[^{_T}=:\[\"'\\]*?(?:[<>≤≥]|[+*/^(][^=:]*=)[^{_T}\[{{\"'\\]*"
_NAME = rf"((?:[{_T}]|\w[\w -]*)(?:\.(?:[{_T}]|\w[\w -]*))*)"
_HEADER = rf"^[\[({{]+ *{_NAME}[ \])}}:;,]*$|^{_NAME}[\])}}:][ \])}}:;,]*$"


def _header(found: Match[str]) -> str:
    parts = [part.strip() for part in (found[1] or found[2]).split(".")]
    name = ".".join(x if not _told(f"{x} = 1") or x[0] >= chr(_MASK) else f'"{x}"' for x in parts)
    return f"[[{name}]]" if name == "chapters" else f"[{name}]"


def _key(found: Match[str]) -> str:
    words = found[2].replace(" ", "_")
    return f"{found[1]}{words} =" if not _told(f"{words} = 1") else f'{found[1]}"{found[2]}" ='


def _number(found: Match[str]) -> str:
    digits = f".{found[3]}" if found[3] else ""
    return found[1] + (found[2].lstrip("0") or "0") + digits + (found[4] or "")


def _quoted(found: Match[str]) -> str:
    if re.fullmatch(rf"{_NUMBER}(?: {_NUMBER})*|\W*", found[2]) or not _told(f"v = {found[2]}"):
        return found[0]
    return found[1] + '"' + re.sub(r"(?<=\d) */ *(?=\d)", "/", found[2]) + '"'


#: What is wrong, how it looks in a statement whose texts are masked, and what belongs there.
REWRITES: list[tuple[str, str, str | Callable[[Match[str]], str]]] = [
    ("a sign only looks like one of TOML's", f"[{''.join(_SIGNS)}]", lambda m: _SIGNS[m[0]]),
    ("a quotation mark is not TOML's", "[\"'“”„«‘’`]([^\"'“”„«»‘’`´]*)[\"'“”»’`´]", r'"\1"'),
    ("a comment begins with #", r"\s*/[/*].*", ""),
    ("a header of a table", _HEADER, _header),
    ("a claim has no name before it", f"^({_CLAIM})$", r'name = "\1"'),
    ("a claim has no name before it", f"^([{_T}])$", r"name = \1"),
    ("after a name stands =", rf"(^|[{{,] *)({_WORD}) *(?::=|==|:) *(?=\S)", r"\1\2 = "),
    ("there is no =", rf"^((?!\d){_WORD}) +(?=[\[{{\"'.\d+{_T}-])", r"\1 = "),
    ("a name is not TOML's", r"(^|[{,] *)([^\W\d]\w*(?:[ .-]\w+)*'*) *=(?!=)", _key),
    ("a sign stands at the end", r" *[,;]+(?= *\}|$)", ""),
    ("; stands where a comma belongs", ";", ","),
    ("a list stands in brackets", rf"(?<=[\[,=])( *)\(([^()]*,[^()]*)\){_TO}", r"\1[\2]"),
    ("a number has a decimal comma", r"= ?([+-]?\d+),(\d+)$", r"= \1.\2"),
    ("a number has a decimal comma", rf"{_FROM}([+-]?\d+),(0\d+){_TO}", r"\1.\2"),
    ("it is in percent", rf"{_FROM}(\d{{1,9}}(?:\.\d+)?) *%{_TO}", lambda m: hundredth(m[1])),
    ("a unit, one for all, is left out", rf"{_FROM}({_NUMBER}|\d+/\d+) ?{_UNIT}{_TO}", r"\1"),
    ("a number of TOML looks otherwise", rf"{_FROM}{_DIGITS}{_AFTER}", _number),
    ("a comma is missing", rf"({_FROM}{_NUMBER}|\]|[{_T}]) +(?={_NEXT})", r"\1, "),
    ("a list stands in brackets", rf"(?<==) *({_ITEM}(?:,{_ITEM})+)$", r" [\1]"),
    ("what is no number stands in quotes", rf"(?<=[\[,=])(?<!^\[)( *)({_PLAIN}){_TO}", _quoted),
]


def error_about(path: str, text: str, told: str, otherwise: str) -> InputError:
    """The error for a text of which the reader of TOML has told why it is none.

    ``otherwise`` is what to write where no line of the text can be mended.
    """
    number, what, instead = _remedy(text, told)
    return InputError(f"{path}, line {number}: is not valid TOML ({what}); {instead or otherwise}")


def _remedy(text: str, told: str) -> tuple[int, str, str]:
    """The line, what is wrong there, and what to write, or nothing where that is not known."""
    if text.lstrip().startswith("{"):
        return 1, "it looks like JSON", "write lines such as r = 0.03, without braces around them"
    lines = text.split("\n")
    if text.count('\\"""') <= MAX_MARKS:
        short = _LONG_TEXT.sub(lambda found: '"_"' + "\n" * found[0].count("\n"), text)
        lines = short.split("\n")
    for start, statement in _statements(lines):
        alone = _told(statement)
        if alone:
            what, mended = _mended(statement)
            at = start + (1 if mended else _line_of(alone, 1))
            return at, *((what, f"write {mended}") if mended else _advice(statement, alone))
    number = min(_line_of(told, len(lines)), len(lines))
    if "Cannot" not in told:  # inside of a text of several lines
        return number, *_advice(re.sub("[\"']", "", text.split("\n")[number - 1]), told)
    *names, name = [line.split("=")[0].strip()[:MAX_SIGNS] for line in lines[:number]]
    what = "a name stands there twice"
    what += f": {name}, in line {number - names[::-1].index(name) - 1} too" if name in names else ""
    return number, what, "leave one out, choose another, or write its lines together"


def _statements(lines: list[str]) -> Iterator[tuple[int, str]]:
    """The index of the line in which a statement begins, and the statement."""
    start, depth = 0, 0
    for i, line in enumerate(lines):
        is_long = len(line) > MAX_LINE
        if i > start and (depth <= 0 or not (is_long or _BEGINNING.match(line) is None)):
            yield start, "\n".join(lines[start:i]).rstrip()
            start, depth = i, 0
        plain = (_TEXT_OR_REST if is_long else _TEXT).sub("", line)
        depth += plain.count("[") - plain.count("]")
    yield start, "\n".join(lines[start:]).rstrip()


def _told(text: str) -> str:
    """Why a text is not TOML; nothing if it is."""
    try:
        tomllib.loads(text, parse_float=str)
    except (ValueError, RecursionError) as error:
        return " ".join(str(error).split())
    return ""


def _line_of(told: str, otherwise: int) -> int:
    return int(found[1]) if (found := re.search(r"\(at line (\d+)", told)) else otherwise


def _advice(statement: str, told: str) -> tuple[str, str]:
    """What is wrong with a statement that is not mended, and what to do, if that is known."""
    is_tex = re.search(r"\\[A-Za-z]{2,}", statement)
    if is_tex or "escape" in told.lower():
        tex = "TeX is not read, write for example (a/b)*sqrt(x) <= alpha"
        return "a backslash", tex if is_tex else r"write \\ for it"
    quotes = re.search("\"{3}|'{3}", statement)
    if quotes:
        return f"a text begins with {quotes[0]} and does not end", f"end it with {quotes[0]}"
    if re.search(r"= *$", statement):
        return "nothing stands after the =", ""
    if "Duplicate" in told:
        return "a key stands there twice", "leave one of them out"
    what = re.sub(r" \(at (?:line \d+, )?(.*)\)", r", at \1", told)
    return what, "leave it out" if re.search(r"Illegal character '(?!\\n)", told) else ""


def _mended(statement: str) -> tuple[str, str]:
    """What is wrong with a statement that is not TOML, and it as TOML; else nothing."""
    if len(statement) > MAX_SIGNS or '"_"' in statement:
        return "", ""
    line = _masked(statement.strip(), r"(?<=[^,\[\s])\s*\n\s*(?=[^,\]\s])", ", ")
    line = _masked(_masked(line, r"[ \t\n]+", " ").strip(), r"(?<=\[) | (?=\])", "")
    return next((found for found in _proposals(line) if not _told(found[1])), ("", ""))


def _proposals(line: str) -> Iterator[tuple[str, str]]:
    """What may be wrong, and a line without that: each alone, then all in order."""
    yield "a comma is missing", line
    for wrong, look, instead in REWRITES[:-1]:  # without quotes for the rest
        yield wrong, _masked(line, look, instead)
    yield from _closed(line)
    for what, whole in (("", line), *_closed(line)):
        for wrong, look, instead in REWRITES:
            before, whole = whole, _masked(whole, look, instead)
            what = what or (wrong if whole != before else "")
        yield what, whole


def _hidden(text: str) -> tuple[str, dict[int, str]]:
    """A statement without comments, with signs for the texts in it, and which text each is."""
    texts: dict[int, str] = {}

    def sign(found: Match[str]) -> str:
        texts[_MASK + len(texts)] = "" if found[1] else found[0]
        return "" if found[1] else chr(_MASK + len(texts) - 1)

    return _TEXT.sub(sign, text), texts


def _masked(text: str, pattern: str, instead: str | Callable[[Match[str]], str]) -> str:
    """A statement in which everything outside of quotes is rewritten."""
    plain, texts = _hidden(text)
    return re.sub(pattern, instead, plain).translate(texts)


def _closed(line: str) -> Iterator[tuple[str, str]]:
    """A statement with a quotation mark, or brackets, in the places where one may be missing."""
    quoted = [line]
    for mark in filter(_hidden(line)[0].__contains__, "\"'"):
        quoted += _with(mark, _TO, line) + _with(mark, r"[\[,=] *", line)[::-1]
    yield from (("a quotation mark is missing", text) for text in quoted[1:])
    for text in quoted:
        plain, texts = _hidden(text)
        for opening, closing in ("[]", "{}"):
            n = plain.count(opening) - plain.count(closing)
            found = [plain[:n], *_with(opening * -n, "= *", plain)] if n < 0 else []
            if n > 0 and not plain.endswith(opening):
                found = [*_with(closing * n, r"(?= *, *\[)", plain), plain + closing * n]
            what = f"not each {opening} has its {closing}"
            yield from ((what, mended.translate(texts)) for mended in found)


def _with(sign: str, place: str, text: str) -> list[str]:
    """The texts with a sign at the end of each of the first few places."""
    places = [found.end() for found in re.finditer(place, text)][:MAX_PLACES]
    return [text[:at] + sign + text[at:] for at in places]
