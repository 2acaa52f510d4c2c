"""Files in parentheses, as SMT-LIB and FPCore have them: read into lists of words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager

from verify.language.record import Record
from verify.wire.inputs import InputError, shown


class Word(str):
    """A word of a file, with the line in which it stands; ``|x|`` is the word x, quoted."""

    __slots__ = ("line", "quoted")
    line: int
    quoted: bool

    @property
    def is_symbol(self) -> bool:
        """Whether the word can be a name: it is no number, text or keyword."""
        return self.quoted or not re.match(r'[0-9":#]', self)


Tree = Word | list["Tree"]


class Lexicon(Record):
    """What may stand between two words of a file, what is a word, and which brackets there are."""

    space: re.Pattern[str]
    word: re.Pattern[str]
    brackets: str


#: SMT-LIB 2.6, section 3.1; a comment ends with its line.
SMTLIB = Lexicon(
    re.compile(r"(?:[ \t\r\n]|;[^\n]*)+"),
    re.compile(r'"(?:[^"]|"")*"|\|[^|\\]*\||[A-Za-z0-9~!@$%^&*_+=<>.?/:#-]+'),
    "()",
)
#: FPCore 2.0.
FPCORE = Lexicon(
    re.compile(r"(?:[ \t\r\n]|;[^\n]*)+"),
    re.compile(r'"(?:[^"\\]|\\.)*"|[A-Za-z0-9~!@$%^&*_+=<>.?/:#-]+', re.DOTALL),
    "()[]",
)
#: So many parentheses are inside of one another at most.
MAX_DEPTH = 300
TOO_DEEP = "it nests too deeply; name its parts"


class Source:
    """A file, for messages that name it and a line."""

    def __init__(self, path: str, content: bytes, lexicon: Lexicon) -> None:
        self.path, self.lexicon = path, lexicon
        try:
            self.text = content.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            raise InputError(f"{path}: is not UTF-8; save it as UTF-8") from error

    @contextmanager
    def shallow(self) -> Iterator[None]:
        """Terms and formulas that nest too deeply to be read are bad input."""
        try:
            yield
        except RecursionError as error:
            raise self.error(None, TOO_DEEP) from error

    def error(self, tree: Tree | int | None, what: str) -> InputError:
        """The error that something is wrong where a tree begins, or in a line."""
        line = tree if isinstance(tree, int) else _line(tree)
        return InputError(f"{self.path}{f', line {line}' if line else ''}: {what}")

    def pairs(self, bindings: Tree) -> Iterator[tuple[Word, Tree]]:
        """The names in a ``let`` with what they stand for."""
        for binding in bindings if isinstance(bindings, list) else [bindings]:
            match binding:
                case [Word() as name, body] if name.is_symbol:
                    yield name, body
                case _:
                    raise self.error(bindings, "a let needs pairs of a name and a term")

    def trees(self) -> list[Tree]:
        """All that stands in the file.

        Raises:
            InputError: where parentheses do not match, too many are open, or a sign is no part of
                the language.
        """
        self._check_line_ends()
        stack: list[list[Tree]] = [[]]
        opened: list[tuple[str, int]] = []
        for sign, line in self._tokens():
            if isinstance(sign, Word):
                stack[-1].append(sign)
            elif sign in "([":
                stack.append([])
                opened.append((sign, line))
                if len(stack) > MAX_DEPTH:
                    raise self.error(None, TOO_DEEP)
            else:
                if not opened:
                    raise self.error(line, "a parenthesis closes that was not opened")
                if opened.pop()[0] + sign not in ("()", "[]"):
                    raise self.error(line, f"{sign} does not close the bracket that is open here")
                closed = stack.pop()
                stack[-1].append(closed)
        if opened:
            raise self.error(opened[-1][1], "a parenthesis that opens here is not closed")
        return stack[0]

    def _check_line_ends(self) -> None:
        """Afterwards all programs agree where a line, and so a comment, ends."""
        alone = re.search(r"\r(?!\n)", self.text)
        if alone:
            line = self.text.count("\n", 0, alone.start()) + 1
            raise self.error(line, "a carriage return ends it; save the file with line feeds")

    def _tokens(self) -> Iterator[tuple[str, int]]:
        """Words and brackets, with their lines."""
        at, line = 0, 1
        while at < len(self.text):
            space = self.lexicon.space.match(self.text, at)
            match = space or self.lexicon.word.match(self.text, at)
            sign = match[0] if match else self.text[at]
            if match is None and sign not in self.lexicon.brackets:
                what = "has no end; close the quotation" if sign in '"|' else "cannot be used here"
                raise self.error(line, f"{shown(sign)} {what}")
            if space is None:
                yield (_word(sign, line) if match else sign), line
            at, line = at + len(sign), line + sign.count("\n")


def _word(text: str, line: int) -> Word:
    quoted = text.startswith("|")
    word = Word(text[1:-1] if quoted else text)
    word.line, word.quoted = line, quoted
    return word


def _line(tree: Tree | None) -> int:
    while isinstance(tree, list):
        tree = next((part for part in tree if part or isinstance(part, Word)), None)
    return 0 if tree is None else tree.line


#: What the names of variables in a statement begin with if they are not those of the file.
WRITTEN_OTHERWISE = "v-"
#: A name of a file that is a name of a statement as it is; "goal" is a word of certificates.
_PLAIN = re.compile(r"(?!goal$)[A-Za-z][A-Za-z0-9_]{0,59}", re.ASCII)
_MOST = 60


class Names:
    """The names of a file as names of a statement: different ones for different ones.

    They have no dot, and a hyphen only as their second sign, so that names with a dot, or with a
    hyphen elsewhere, are left for what the readers name themselves.
    """

    def __init__(self) -> None:
        self._known: dict[str, str] = {}

    def __getitem__(self, name: str) -> str:
        if name not in self._known:
            self._known[name] = self._spelt(str(name))
        return self._known[name]

    def __iter__(self) -> Iterator[str]:
        """The names that were looked for, in their order."""
        return iter([*self._known])

    def _spelt(self, name: str) -> str:
        if _PLAIN.fullmatch(name):
            return name
        spelt = re.sub(r"[^A-Za-z0-9]", lambda sign: f"_{ord(sign[0]):x}_", name)
        number = f"_{len(self._known) + 1}"
        return f"{WRITTEN_OTHERWISE}{spelt if len(spelt) <= _MOST else number}"

    def letter(self, name: str) -> str:
        """How people see a name: as it is written, if that may stand anywhere."""
        readable = re.fullmatch(r"[A-Za-z0-9_.+-]{1,60}", name, re.ASCII)
        return name if readable and not name.startswith(WRITTEN_OTHERWISE) else self[name]
