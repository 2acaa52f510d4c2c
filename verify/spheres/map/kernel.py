"""Functions of boxes, compiled: the operations of numpy in their order, in one loop over the boxes.

A function is run once on symbols instead of arrays, which note each operation; LLVM makes machine
code of what they have noted. It may neither reorder nor contract nor approximate them: so each
number is the one that numpy gives, up to the sign of a zero or the bits of NaN, which no comparison
sees, and a map has the same bytes with and without this.
"""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import cache
from hashlib import sha256
from importlib.util import cache_from_source
from pathlib import Path
from typing import Any

import numpy as np
from llvmlite import binding

from verify.spheres.map.elementwise import Tree, leaves, mapped

#: So many boxes are done at once; where registers are shorter, LLVM takes several. In a step that
#: is repeated each operation waits for the one before: with more boxes more is done meanwhile.
LANES, LANES_OF_STEP = 8, 16
#: The operations of numpy, as LLVM calls them.
ARITHMETIC = {"add": "fadd", "subtract": "fsub", "multiply": "fmul", "divide": "fdiv"}
COMPARISONS = {"less": "olt", "less_equal": "ole", "greater": "ogt", "greater_equal": "oge"}
LOGIC = {"bitwise_and": "and", "bitwise_or": "or"}
FUNCTIONS = {"sqrt": "sqrt", "absolute": "fabs", "rint": "rint", "ceil": "ceil"}
TELLS_TRUTH = {*COMPARISONS, *LOGIC, "invert", "truth", "given truth"}

#: The place of an operation in a trace.
Slot = int


class Trace:
    """Operations in their order, each with the slots that it takes; none is there twice."""

    def __init__(self) -> None:
        self.code: list[tuple[Any, ...]] = []
        #: Whether it is a truth value, and not a number.
        self.truths: list[bool] = []
        self._known: dict[tuple[Any, ...], Slot] = {}

    def slot(self, *operation: Any) -> Slot:
        """The place of an operation: its name, and its slots."""
        found = self._known.get(operation)
        if found is None:
            name, *of = operation
            found = self._known[operation] = len(self.code)
            self.code.append(operation)
            self.truths.append(self.truths[of[1]] if name == "where" else name in TELLS_TRUTH)
        return found


class Symbol(np.lib.mixins.NDArrayOperatorsMixin):
    """Instead of an array the slot of its values; instead of a matrix those of its rows."""

    dtype = ndim = None

    def __init__(self, trace: Trace, slots: Sequence[Slot], is_matrix: bool = False) -> None:
        self.trace, self.slots, self.is_matrix = trace, [*slots], is_matrix

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **_: Any) -> Symbol:
        if method == "reduce":
            found, *rest = self.slots
            for slot in rest:
                found = self.trace.slot(ufunc.__name__, found, slot)
            return Symbol(self.trace, [found])
        return self._noted(ufunc.__name__, inputs)

    def __array_function__(self, function: Any, _: Any, given: Any, __: Any) -> Symbol:
        if function is np.where:
            return self._noted("where", given)
        if function is np.stack:
            return Symbol(self.trace, [slot for x in given[0] for slot in self._slots_of(x)], True)
        if function is np.full_like:
            return Symbol(self.trace, self._slots_of(given[1]))
        if function is np.zeros_like:
            is_truth = self.trace.truths[self.slots[0]] or any(x is bool for x in given)
            return Symbol(self.trace, self._slots_of(False if is_truth else 0.0))
        raise TypeError(f"{function.__name__} cannot be compiled")

    def _noted(self, name: str, inputs: Sequence[Any]) -> Symbol:
        columns = [self._slots_of(x) for x in inputs]
        rows = max(map(len, columns))
        columns = [column * rows if len(column) == 1 else column for column in columns]
        slots = [self.trace.slot(name, *row) for row in zip(*columns, strict=True)]
        return Symbol(self.trace, slots, rows > 1)

    def _slots_of(self, value: Any) -> list[Slot]:
        if isinstance(value, Symbol):
            return value.slots
        if isinstance(value, bool | np.bool):
            return [self.trace.slot("truth", bool(value))]
        return [self.trace.slot("number", float(value).hex())]

    def __getitem__(self, place: int | slice) -> Symbol:
        found = self.slots[place]
        return Symbol(self.trace, *((found, True) if isinstance(found, list) else ([found],)))

    def __setitem__(self, place: int | slice, value: Any) -> None:
        rows = place if isinstance(place, slice) else slice(place, place + 1)
        self.slots[rows] = self._slots_of(value)

    def copy(self) -> Symbol:
        """The same, which may be changed."""
        return Symbol(self.trace, self.slots, self.is_matrix)


def _slots(tree: Tree) -> list[Slot]:
    return [slot for symbol in leaves(tree) for slot in symbol.slots]


class Kernel:
    """A function for trees of one shape, compiled; or a step that is taken so often at most."""

    def __init__(self, function: Callable[..., Tree], given: Tree, most: int) -> None:
        trace, count = Trace(), 0

        def symbol(x: Any) -> Symbol:
            nonlocal count
            if x.dtype not in (np.float64, bool) or (x.dtype == bool and x.ndim != 1):
                raise TypeError(f"arrays of {x.ndim} dimensions of {x.dtype} cannot be compiled")
            name = ("given truth" if x.dtype == bool else "given", x.ndim > 0)
            rows = len(x) if x.ndim == 2 else 1
            count += rows
            return Symbol(
                trace, [trace.slot(*name, k) for k in range(count - rows, count)], x.ndim == 2
            )

        symbols = mapped(given, symbol)
        self._tree, loop = function(*symbols), None
        if most:
            after, ends, goes = self._tree
            loop = Loop(_slots(symbols[1]), _slots(after), ends.slots[0], goes.slots[0], most)
            self._tree = after, ends
        slots = _slots(self._tree)
        self._truths = sum(trace.truths[slot] for slot in slots)
        self._numbers = len(slots) - self._truths
        #: Of each array that is found, whether it has truth values, and where its rows are.
        self._found: list[tuple[bool, int | slice]] = []
        at = {False: 0, True: 0}
        for x in leaves(self._tree):
            is_truth, rows = trace.truths[x.slots[0]], len(x.slots)
            first = at[is_truth]
            self._found.append((is_truth, slice(first, first + rows) if x.is_matrix else first))
            at[is_truth] += rows
        self._lanes = LANES if loop is None else LANES_OF_STEP
        self._run = compiled(text_of(trace, slots, loop, self._lanes))

    def __call__(self, arrays: Sequence[Any], chosen: Any) -> Tree:
        """The value at the chosen boxes, or at all of them."""
        boxes = max([x.shape[-1] for x in arrays if x.ndim])
        places = np.arange(boxes) if chosen is None else chosen
        if places.dtype != np.int64:
            raise TypeError(f"places of {places.dtype} cannot be read")
        size = len(places)
        if size and not 0 <= places.min() <= places.max() < boxes:
            raise IndexError(f"places beyond {boxes} boxes")
        if size < self._lanes:
            places = np.resize(places, self._lanes)
        kept: list[Any] = []
        table: list[int] = []
        for x in arrays:
            if x.ndim and x.shape[-1] != boxes:
                x = np.broadcast_to(x, (*x.shape[:-1], boxes))
            if not x.flags.carray:
                x = np.array(x, order="C")
            kept.append(x)  # or its address would be that of something else
            at = _address(x)
            table += range(at, at + x.nbytes, 8 * boxes) if x.ndim == 2 else (at,)
        numbers = np.empty((self._numbers or 1, len(places)))
        truths = np.empty((self._truths or 1, len(places)), bool)
        given = (ctypes.c_void_p * len(table))(*table)
        self._run(len(places), given, *map(_address, (places, numbers, truths)))
        rows = numbers[:, :size], truths[:, :size]
        found = iter([rows[is_truth][place] for is_truth, place in self._found])
        return mapped(self._tree, lambda _: next(found))


def _address(x: Any) -> int:
    return ctypes.addressof(ctypes.c_char.from_buffer(x))


# --- the text of a function, in the language of LLVM ---------------------------------------------


class Loop:
    """A step: the slots of its state, of the next one, and whether that ends it, or it goes on."""

    def __init__(
        self, before: list[Slot], after: list[Slot], ends: Slot, goes: Slot, most: int
    ) -> None:
        self.before, self.after, self.ends, self.goes, self.most = before, after, ends, goes, most


def text_of(trace: Trace, found: Sequence[Slot], loop: Loop | None, lanes: int) -> str:
    """The function of the number of boxes, and the addresses of what is given, places and found.

    It takes so many boxes at once; the last ones begin early enough to end with the last box.
    """
    w = Writer(trace, lanes)
    w.lines.append(
        "define void @kernel(i64 %n, ptr %given, ptr %places, ptr %numbers, ptr %truths) {\nentry:"
    )
    last = w.set(f"sub i64 %n, {lanes}")
    given = [slot for slot, operation in enumerate(trace.code) if operation[0].startswith("given")]
    arrays = [w.set(f"load ptr, ptr {w.at('%given', 'ptr', str(k))}") for k in range(len(given))]
    for slot, array in zip(given, arrays, strict=True):
        if not trace.code[slot][1]:
            w.names[slot] = w.one(array)
    w.lines.append("  br label %boxes\nboxes:\n  %i = phi i64 [ 0, %entry ], [ %next, %found ]")
    places = w.set(f"load {w.bits}, ptr {w.at('%places', 'i64', '%i')}, align 8")
    for slot, array in zip(given, arrays, strict=True):
        if trace.code[slot][1]:
            w.names[slot] = w.some(array, places, trace.truths[slot])
    if loop:
        values = w.rounds(loop)
    else:
        w.body()
        values = [w.names[slot] for slot in found]
        w.lines.append("  br label %found\nfound:")
    rows = {False: 0, True: 0}
    for slot, value in zip(found, values, strict=True):
        w.store(value, trace.truths[slot], rows[trace.truths[slot]])
        rows[trace.truths[slot]] += 1
    after = w.set(f"add i64 %i, {lanes}")
    beyond = w.set(f"icmp sgt i64 {after}, {last}")
    w.lines.append(f"  %next = select i1 {beyond}, i64 {last}, i64 {after}")
    done = w.set(f"icmp eq i64 %i, {last}")
    w.lines.append(f"  br i1 {done}, label %exit, label %boxes\nexit:\n  ret void\n}}")
    for name in FUNCTIONS.values():
        w.lines.append(f"declare {w.numbers} @llvm.{name}.v{lanes}f64({w.numbers})")
    for kind, many in (("f64", w.numbers), ("i8", w.bytes)):
        types = f"{w.addresses}, i32, {w.truths}, {many}"
        w.lines.append(f"declare {many} @llvm.masked.gather.v{lanes}{kind}.v{lanes}p0({types})")
    return "\n".join(w.lines)


class Writer:
    """The lines of one function, and the names of the values of slots."""

    def __init__(self, trace: Trace, lanes: int) -> None:
        self.trace, self.lines, self.lanes = trace, list[str](), lanes
        self.names: dict[Slot, str] = {}
        kinds = ("double", "i1", "i64", "i8", "ptr")
        self.numbers, self.truths, self.bits, self.bytes, self.addresses = (
            f"<{lanes} x {kind}>" for kind in kinds
        )
        self.yes = self.all("i1", "true")

    def all(self, kind: str, value: str) -> str:
        """The same value in each lane."""
        return f"<{', '.join([f'{kind} {value}'] * self.lanes)}>"

    def number(self, value: float) -> str:
        """The same double in each lane, with all its bits."""
        return self.all("double", f"0x{np.float64(value).view(np.uint64):016X}")

    def set(self, text: str) -> str:
        """The name of a new value."""
        name = f"%v{len(self.lines)}"
        self.lines.append(f"  {name} = {text}")
        return name

    def at(self, array: str, kind: str, place: str) -> str:
        """The address of an entry."""
        return self.set(f"getelementptr {kind}, ptr {array}, i64 {place}")

    def one(self, array: str) -> str:
        """The number that all boxes have."""
        value = self.set(f"load double, ptr {array}")
        value = self.set(f"insertelement {self.numbers} poison, double {value}, i64 0")
        zeros = f"<{self.lanes} x i32> zeroinitializer"
        return self.set(f"shufflevector {self.numbers} {value}, {self.numbers} poison, {zeros}")

    def some(self, array: str, places: str, is_truth: bool) -> str:
        """The numbers, or truth values, at some places."""
        kind, name, many, size = (
            ("i8", "i8", self.bytes, 1) if is_truth else ("double", "f64", self.numbers, 8)
        )
        at = self.set(f"getelementptr {kind}, ptr {array}, {self.bits} {places}")
        given = f"{self.addresses} {at}, i32 {size}, {self.truths} {self.yes}, {many} poison"
        found = self.set(
            f"call {many} @llvm.masked.gather.v{self.lanes}{name}.v{self.lanes}p0({given})"
        )
        return self.set(f"icmp ne {self.bytes} {found}, zeroinitializer") if is_truth else found

    def store(self, value: str, is_truth: bool, row: int) -> None:
        """Put numbers, or truth values, into a row of what is found."""
        first = self.set(f"mul i64 %n, {row}")
        place = self.set(f"add i64 {first}, %i")
        if is_truth:
            value = self.set(f"zext {self.truths} {value} to {self.bytes}")
            self.lines.append(
                f"  store {self.bytes} {value}, ptr {self.at('%truths', 'i8', place)}, align 1"
            )
        else:
            at = self.at("%numbers", "double", place)
            self.lines.append(f"  store {self.numbers} {value}, ptr {at}, align 8")

    def rounds(self, loop: Loop) -> list[str]:
        """Take the step until no box goes on; the last states, and where there is one."""
        states = {}
        self.lines.append("  br label %rounds\nrounds:")
        for k, slot in enumerate(loop.before):
            states[slot] = f"[ {self.names[slot]}, %boxes ], [ %y{k}, %rounds ]"
            self.names[slot] = f"%x{k}"
            self.lines.append(f"  %x{k} = phi {self.numbers} {states[slot]}")
        self.lines.append(
            f"  %goes = phi {self.truths} [ {self.yes}, %boxes ], [ %on, %rounds ]\n"
            f"  %ended = phi {self.truths} [ zeroinitializer, %boxes ], [ %over, %rounds ]\n"
            "  %round = phi i64 [ 1, %boxes ], [ %more, %rounds ]\n"
            "  %more = add i64 %round, 1"
        )
        self.body()
        for k, slot in enumerate(loop.after):
            new = f"{self.numbers} {self.names[slot]}, {self.numbers} %x{k}"
            self.lines.append(f"  %y{k} = select {self.truths} %goes, {new}")
        ends = self.set(f"and {self.truths} %goes, {self.names[loop.ends]}")
        self.lines.append(f"  %over = or {self.truths} %ended, {ends}")
        self.lines.append(f"  %on = and {self.truths} %goes, {self.names[loop.goes]}")
        lanes = self.set(f"bitcast {self.truths} %on to i{self.lanes}")
        some = self.set(f"icmp ne i{self.lanes} {lanes}, 0")
        few = self.set(f"icmp slt i64 %round, {loop.most}")
        again = self.set(f"and i1 {some}, {few}")
        self.lines.append(f"  br i1 {again}, label %rounds, label %found\nfound:")
        return [*(f"%y{k}" for k in range(len(loop.after))), "%over"]

    def body(self) -> None:
        """The operations in their order."""
        for slot, (name, *of) in enumerate(self.trace.code):
            if slot not in self.names:
                self.names[slot] = self._value(slot, name, of)

    def _value(self, slot: Slot, name: str, of: Sequence[Any]) -> str:
        if name == "number":
            return self.number(float.fromhex(of[0]))
        if name == "truth":
            return self.yes if of[0] else "zeroinitializer"
        values = [self.names[x] for x in of]
        if name in ARITHMETIC:
            return self.set(f"{ARITHMETIC[name]} {self.numbers} {', '.join(values)}")
        if name in FUNCTIONS:
            function = f"@llvm.{FUNCTIONS[name]}.v{self.lanes}f64"
            return self.set(f"call {self.numbers} {function}({self.numbers} {values[0]})")
        if name in COMPARISONS:
            return self._compare(COMPARISONS[name], *values)
        if name in LOGIC:
            return self.set(f"{LOGIC[name]} {self.truths} {', '.join(values)}")
        return self._others(slot, name, of, values)

    def _others(self, slot: Slot, name: str, of: Sequence[Any], values: Sequence[str]) -> str:
        if name == "where":
            which, one, two = values
            return self._select(
                which, one, two, self.truths if self.trace.truths[slot] else self.numbers
            )
        if name == "invert":
            return self.set(f"xor {self.truths} {values[0]}, {self.yes}")
        if name == "negative":
            return self.set(f"fneg {self.numbers} {values[0]}")
        if name == "nextafter":
            return self._next(values[0], float.fromhex(self.trace.code[of[1]][1]))
        if name in ("minimum", "maximum", "fmin", "fmax"):
            one, two = values
            better = self._compare("olt" if "min" in name else "ogt", one, two)
            # Of a number and NaN it is NaN for the first two names, and else the number.
            first = one if name in ("minimum", "maximum") else two
            is_nan = self._compare("uno", first, first)
            return self._select(is_nan, one, self._select(better, one, two))
        raise TypeError(f"{name} cannot be compiled")

    def _compare(self, how: str, one: str, two: str) -> str:
        return self.set(f"fcmp {how} {self.numbers} {one}, {two}")

    def _select(self, which: str, one: str, two: str, kind: str = "") -> str:
        kind = kind or self.numbers
        return self.set(f"select {self.truths} {which}, {kind} {one}, {kind} {two}")

    def _next(self, value: str, goal: float) -> str:
        """The next double towards an infinity: its bits, as a whole number, are the next ones."""
        up = goal > 0
        bits = self.set(f"bitcast {self.numbers} {value} to {self.bits}")
        sign = self.set(f"ashr {self.bits} {bits}, {self.all('i64', '63')}")
        unit = self.set(f"or {self.bits} {sign}, {self.all('i64', '1')}")
        moved = self.set(f"{'add' if up else 'sub'} {self.bits} {bits}, {unit}")
        is_zero = self._compare("oeq", value, "zeroinitializer")
        moved = self._select(
            is_zero, self.all("i64", str(1 if up else 1 - 2**63)), moved, self.bits
        )
        found = self.set(f"bitcast {self.bits} {moved} to {self.numbers}")
        moves = self._compare("olt" if up else "ogt", value, self.number(goal))
        return self._select(moves, found, value)


# --- machine code --------------------------------------------------------------------------------


@cache
def _machine() -> tuple[Any, Any, str]:
    """What makes machine code for this processor, what runs it, and which processor that is."""
    binding.initialize_native_target()
    binding.initialize_native_asmprinter()
    cpu, features = binding.get_host_cpu_name(), binding.get_host_cpu_features().flatten()
    target = binding.Target.from_default_triple()
    machine = target.create_target_machine(cpu=cpu, features=features, opt=2)
    engine = binding.create_mcjit_compiler(binding.parse_assembly(""), machine)
    return machine, engine, f"{binding.llvm_version_info} {cpu} {features}"


@cache
def compiled(text: str) -> Callable[..., None]:
    """The function; its machine code is kept beside the .pyc of this file."""
    machine, engine, host = _machine()
    name = "kernel_" + sha256(f"{host}\n{text}".encode()).hexdigest()[:32]
    path = Path(cache_from_source(__file__)).with_name(f"{name}.o")
    code = _kept(path)
    if code is None:
        code = machine.emit_object(binding.parse_assembly(text.replace("@kernel(", f"@{name}(")))
        _keep(path, code)
    engine.add_object_file(binding.ObjectFileRef.from_data(code))
    engine.finalize_object()
    kind = ctypes.CFUNCTYPE(None, ctypes.c_int64, *[ctypes.c_void_p] * 4)
    return kind(engine.get_function_address(name))


def _kept(path: Path) -> bytes | None:
    """What a file has, if it is there and was written to its end."""
    try:
        content = path.read_bytes()
    except OSError:
        return None
    return content[32:] if sha256(content[32:]).digest() == content[:32] else None


def _keep(path: Path, code: bytes) -> None:
    if sys.dont_write_bytecode:
        return
    part = path.with_suffix(f".{os.getpid()}")
    with suppress(OSError):  # then it is compiled again next time
        path.parent.mkdir(exist_ok=True)
        part.write_bytes(sha256(code).digest() + code)
        part.replace(path)
