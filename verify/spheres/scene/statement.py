"""What happens in a scene, as a statement: numbers with names, and a row for each event.

Each row says that a theorem about all states applies to these numbers: the flow's, to each
collision, and what decides the scene, to the state after the last one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction
from itertools import chain, pairwise
from math import lcm

from verify.language.record import Record
from verify.language.statement import NEEDED, Applies, Constant, Obligation
from verify.language.terms import Claim, Number, Term, as_term, equal, sqrt, symbol
from verify.spheres.flow import contexts
from verify.spheres.flow.collapse import LINE, SANDWICH, SHARPER, THREE_BALLS
from verify.spheres.flow.contexts import (
    COLLISION,
    DRIFT,
    FLOW,
    FLOW_OF_BALLS,
    LETTERS,
    NAMED,
    PARTING,
    PASSING,
    RECENTRE,
    TOUCHING,
    UNIT,
)
from verify.spheres.flow.follow import Weights
from verify.spheres.flow.law import EQUAL, Pair, Sizes, State, collided, drifted, flight, recentred
from verify.spheres.flow.pairs_and_units import Unit, pairs_of, scaled_unit_of, unit_of
from verify.spheres.scene.criteria import (
    INELASTIC,
    MOMENTUM,
    RECEDING,
    SAYS,
    TURNING,
    Spread,
    comes_to_rest,
    inelastic,
    spread,
    turning,
    whole,
)
from verify.spheres.scene.middle import Middle, excluded, middles, rests
from verify.spheres.scene.scene import (
    FIRST_FRAMES,
    PAIRS,
    Coordinates,
    Frame,
    Scene,
    coordinates,
    difference,
    pair_name,
)

LABEL = "EQUATSS2.1_Loi_de_Newton_"
#: The theorems that are cited besides the flow.
CLASSIFICATION = "classification"
CLASSIFICATION_OF_BALLS = "classification-of-balls"
EXCLUDED, RESTS = f"{CLASSIFICATION_OF_BALLS}:excluded", f"{CLASSIFICATION_OF_BALLS}:rests"
SAYS_EXCLUDED = "no collapse has particle {} in the middle"
SAYS_RESTS = "a collapse with particle {} in the middle ends all relative motion"
START, LINE_START = f"{SHARPER}:start", f"{LINE}:start"
SANDWICH_START, STAIR = f"{SANDWICH}:start", f"{SANDWICH}:stair"
BALLS_START, BALLS_STAIR = f"{THREE_BALLS}:start", f"{THREE_BALLS}:stair"
#: The name of the constant for the time of a move.
TIME = "time"
#: Intervals of 128 bits keep fractions with so many bits above and below the bar together.
SHORT = 256
#: The letter of the coefficients of restitution.
RESTITUTION = "r"
r = symbol(RESTITUTION)
#: The letters of the parameters of masses and radii.
SIZES = MASS, RADIUS = "m", "R"


class Numbers(Record):
    """The numbers with which a theorem is applied, and the enclosures that follow.

    ``stair`` has the points for the sandwich theorem, or for that on three balls.
    """

    values: Mapping[str, Fraction]
    time: tuple[Fraction, Fraction]
    angle: tuple[Fraction, Fraction]
    stair: tuple[tuple[Fraction, Fraction], ...] = ()


class Telling:
    """The parameters, constants and rows so far, and the state that was reached.

    ``is_short`` says that intervals of 128 bits keep the constants that follow from what is given,
    and all on the way to them, as they are.
    """

    def __init__(self, scene: Scene) -> None:
        self.parameters: dict[str, Term] = {}
        if scene.restitutions is None:
            self.parameters[RESTITUTION] = as_term(scene.r)
        else:
            names = (f"{RESTITUTION}.{pair_name(i, j)}" for i, j in PAIRS)
            self.parameters |= zip(names, map(as_term, scene.restitutions), strict=True)
        self.scene = scene
        self.flow = FLOW if scene.bodies is None else FLOW_OF_BALLS
        self.constants: list[Constant] = []
        self.rows: list[Obligation] = []
        self.given = Coordinates(
            self._coordinates("x", scene.positions), self._coordinates("v", scene.velocities),
            self._squares(),
        )  # fmt: skip
        self.exact = coordinates(scene, Fraction)
        self.is_short = _is_short(scene)
        self.state: State | None = None
        self.frame: Frame = (0, 1, 2)
        self.moves = self.collisions = 0
        self.time = as_term(0)
        for i, j in PAIRS:
            says = f"at the start the particles {i} and {j} do not overlap"
            self.row(f"start.{pair_name(i, j)}", says, 0 <= self.given.pair(i, j).g)

    def _coordinates(self, letter: str, rows: tuple[tuple[Fraction, ...], ...]) -> list[list[Term]]:
        found = []
        for i, row in enumerate(rows):
            names = [f"{letter}.{i}.{k}" for k, _ in enumerate(row, 1)]
            self.parameters |= {n: as_term(x) for n, x in zip(names, row, strict=True)}
            found.append([symbol(name) for name in names])
        return found

    def _squares(self) -> list[Term] | tuple[int, int, int]:
        """Masses and radii as parameters; the squares of the contact distances."""
        if self.scene.bodies is None:
            return (1, 1, 1)
        for letter, row in zip(SIZES, self.scene.bodies, strict=True):
            self.parameters |= {f"{letter}.{i}": as_term(x) for i, x in enumerate(row)}
        return [(symbol(f"{RADIUS}.{i}") + symbol(f"{RADIUS}.{j}")) ** 2 for i, j in PAIRS]

    def _size(self, letter: str, name: str, term: Term) -> Term:
        """A constant of the balls, where it is first used."""
        full = f"{letter}.{name}"
        if all(constant.name != full for constant in self.constants):
            written = f"{letter}_{{{name}}}"
            self.constants.append(Constant(full, f"{letter}_{name}", written, "", term))
        return symbol(full)

    def restitution(self, i: int, j: int) -> Term:
        """The coefficient of restitution of a pair."""
        one = self.scene.restitutions is None
        return r if one else symbol(f"{RESTITUTION}.{pair_name(i, j)}")

    def mass(self, i: int) -> Term:
        """The parameter of a mass."""
        return symbol(f"{MASS}.{i}")

    def contact(self, i: int, j: int) -> Term:
        """The distance at which two balls touch."""
        term = symbol(f"{RADIUS}.{min(i, j)}") + symbol(f"{RADIUS}.{max(i, j)}")
        return self._size("l", pair_name(i, j), term)

    def square(self, i: int, j: int) -> Term:
        """Its square."""
        return self._size("K", pair_name(i, j), self.contact(i, j) ** 2)

    def sizes(self) -> Sizes:
        """What the law needs besides r, seen from here."""
        if self.scene.bodies is None:
            return EQUAL
        o, s, c = self.frame
        ratio = self._size("n", f"{o}{c}", 1 + self.mass(o) / self.mass(c))
        return Sizes(self.square(o, c), self.square(o, s), self.square(s, c), ratio)

    def _squares_at(self, context: str) -> dict[str, Number]:
        """The sizes as values of the variables of a context."""
        sizes = self.sizes()
        if sizes is EQUAL:
            return {}
        found = {"K_c": sizes.c, "K_s": sizes.s, "K_o": sizes.outer}
        return {**found, "n": sizes.ratio} if context == COLLISION else _of(context, found)

    # --- constants and rows ---------------------------------------------------------------------

    def keep(self, name: str, term: Number) -> Term:
        """A new constant of the present move."""
        full = f"{name}.{self.moves}"
        letter, tex = LETTERS.get(name, (name, name))
        here = Constant(
            full, f"{letter}_{self.moves}", f"{tex}_{{{self.moves}}}", "", as_term(term)
        )
        self.constants.append(here)
        return symbol(full)

    def known(self, name: str, value: Fraction, term: Term) -> Term:
        """A new constant that follows from what is given.

        Where the given numbers are long, its definition is its value, and a row says what it is.
        """
        found = self.keep(name, term if self.is_short else value)
        if not self.is_short:
            self.row(f"is.{found.name}", "what this number is", equal(found, term))
        return found

    def row(self, name: str, says: str, claim: Claim | Applies, *uses: str) -> None:
        """A new row."""
        self.rows.append(Obligation(name, "scene", LABEL, NEEDED, says, claim, uses))

    def apply(
        self, name: str, says: str, context: str, at: Mapping[str, Number], *uses: str
    ) -> None:
        """A new row: the theorem of a context of the flow applies to these numbers."""
        values = {key: as_term(value) for key, value in at.items()}
        self.row(name, says, Applies(f"{self.flow}:{context}", values), "scene", *uses)

    # --- what happens ---------------------------------------------------------------------------

    def begin(self, frame: Frame) -> None:
        """The scene seen from a particle."""
        self.frame = frame
        values: dict[str, Fraction] = {}
        self.exact.state(frame, lambda name, x: values.setdefault(name, x))
        self.state = _terms(
            self.given.state(frame, lambda name, term: self.known(name, values[name], term))
        )

    def collide(self, weights: Weights | None = None) -> None:
        """The pair o, c collides: the next collision; with weights if another is in contact."""
        before, (o, s, c) = self._next(), self.frame
        self.collisions += 1
        way, restitution = flight(before, sqrt, self.keep), self.restitution(o, c)
        after = collided(restitution, before, way, self.keep, self.sizes())
        self.time = self.keep(TIME, self.time + way.y * way.T)
        later = {f"{n}_next": getattr(after, n) for n in NAMED[COLLISION]}
        at = {"r": restitution, **self._squares_at(COLLISION)}
        at |= {**before._asdict(), **way._asdict(), **later}
        uses = [] if self.scene.restitutions is None else ["scene-restitutions"]
        context, others = f"{self.flow}:{COLLISION}", "no other pair meets before"
        if weights is not None:
            at |= {"z_s": weights.s, "z_o": weights.o, "e": weights.angle}
            uses, context = [*uses, "scene-touching"], f"{TOUCHING}:{TOUCHING}"
            others = "no other pair in contact approaches, or at a right angle only"
        says = f"collision {self.collisions}, of {pair_name(o, c)}, at the time t_{self.moves}; "
        claim = Applies(context, {key: as_term(value) for key, value in at.items()})
        self.row(f"collision.{self.collisions}", says + others, claim, "scene", *uses)
        self.frame, self.state = (o, c, s), _terms(after)

    def recentre(self) -> None:
        """The same moment, seen from the spectator."""
        before, (o, s, c) = self._next(), self.frame
        after = recentred(before, self.keep, self.sizes())
        says = f"the particles {o} and {c} as they are seen from {s}"
        self._change(RECENTRE, says, before, after, {})
        self.frame = (s, o, c)

    def drift(self, time: Fraction) -> None:
        """Free flight for a time."""
        before = self._next()
        after = drifted(before, as_term(time), self.keep)
        self.time = self.keep(TIME, self.time + as_term(time))
        says = f"free flight until t_{self.moves}; no pair meets"
        self._change(DRIFT, says, before, after, {"drift.t": time})

    def _next(self) -> State:
        self.moves += 1
        if self.state is None:
            raise ValueError("the scene has not begun")
        return self.state

    def _change(
        self, kind: str, says: str, before: State, after: State, more: Mapping[str, Number]
    ) -> None:
        named = NAMED[kind]
        at = {f"{kind}.{name}": value for name, value in before._asdict().items()}
        at |= {f"{kind}.{name}_next": getattr(after, name) for name in named}
        self.apply(f"{kind}.{self.moves}", says, kind, {**at, **self._squares_at(kind), **more})
        self.state = _terms(after)

    # --- how it ends ----------------------------------------------------------------------------

    def pairs(self) -> dict[str, Pair]:
        """The three pairs at the end, by their names, each with its numbers."""
        if self.state is None:
            return {pair_name(i, j): self._given_pair(i, j) for i, j in PAIRS}
        state, (o, s, c) = self._next(), self.frame
        found = pairs_of(state, self.keep, self.sizes())
        at = _of(contexts.PAIRS, state._asdict()) | self._squares_at(contexts.PAIRS)
        for name, pair in found.items():
            numbers = {f"{field}_{name}": term for field, term in pair._asdict().items()}
            at |= _of(contexts.PAIRS, numbers)
        says = f"the pairs {pair_name(o, c)}, {pair_name(o, s)} and {pair_name(s, c)} of this state"
        self.apply(f"pairs.{self.moves}", says, contexts.PAIRS, at)
        names = {"c": pair_name(o, c), "s": pair_name(o, s), "outer": pair_name(s, c)}
        return {names[name]: pair for name, pair in found.items()}

    def _given_pair(self, i: int, j: int) -> Pair:
        values, terms = self.exact.pair(i, j), self.given.pair(i, j)
        name = pair_name(i, j)
        found = zip(Pair._fields, values, terms, strict=True)
        return Pair(*(self.known(f"{field}.{name}", x, term) for field, x, term in found))

    def disperse(self, contexts: Mapping[str, str]) -> None:
        """No pair collides any more, each for a reason: it parts, or it passes by."""
        words = {PARTING: "do not approach any more", PASSING: "will miss each other"}
        for name, pair in self.pairs().items():
            context = contexts[name]
            fields = ("p", "m") if context == PARTING else ("g", "p", "m")
            at = {f"{context}.{field}": getattr(pair, field) for field in fields}
            says = f"the particles {name[0]} and {name[1]} {words[context]}"
            self.apply(f"end.{name}", says, context, at, "scene-disperses")

    def limit(self, criterion: str) -> None:
        """Only finitely many collisions are possible, from this state on."""
        for name in (name for name in self.parameters if name.partition(".")[0] == RESTITUTION):
            ending, one = name.removeprefix(RESTITUTION), symbol(name)
            self.row(f"range.low{ending}", "the coefficient of restitution is positive", 0 < one)
            is_elastic = self.parameters[name].value == 1
            how, most = ("at most", one <= 1) if is_elastic else ("below", one < 1)
            self.row(f"range.high{ending}", f"and {how} 1: no collision adds energy", most)
        if self.scene.bodies is not None:
            self._limit_of_balls(criterion)
            return
        if criterion == INELASTIC:
            self._finite("restitution", criterion, inelastic(r) < 0)
            return
        if self.state is None:
            self.begin(FIRST_FRAMES[0])
        now = whole(self._next())
        if criterion == MOMENTUM:
            for name, claim in (("rest", comes_to_rest(r) < 0), ("momentum", 0 < now.L2)):
                self._finite(name, criterion, claim, "scene-momentum")
            return
        self._finite("far", criterion, 2 <= now.R2)
        claim = 0 <= now.A if criterion == RECEDING else 0 < turning(now)
        self._finite(criterion, criterion, claim)

    def _finite(self, name: str, criterion: str, claim: Claim, glue: str = "scene-finite") -> None:
        self.row(f"finite.{name}", SAYS[criterion], claim, "scene", glue)

    def _limit_of_balls(self, criterion: str) -> None:
        """The same of balls that are not equal."""
        if criterion == INELASTIC:
            self._middles(EXCLUDED, "s", excluded, SAYS_EXCLUDED)
            return
        if self.state is None:
            self.begin(FIRST_FRAMES[0])
        state, glue = self._next(), "scene-finite-balls"
        masses = [self.mass(i) for i in range(3)]
        contacts = [self.contact(i, j) for i, j in PAIRS]
        now = spread(state, self.frame, masses, contacts, self.sizes())
        found = {"R2": now.R2, "virial": now.A, "L2": now.L2}
        R2, A, L2 = (self.keep(name, term) for name, term in found.items())
        if criterion == MOMENTUM:
            self._middles(RESTS, "t", rests, SAYS_RESTS)
            self.row("finite.momentum", "L² is not 0", 0 < L2, "scene", glue)
            return
        for o, most in enumerate(map(as_term, now.touching)):
            says = f"R² is at least what it can be at most where {o} touches both others"
            self.row(f"finite.far.{o}", says, most <= R2, "scene", glue)
            if criterion == TURNING:
                claim = 0 < turning(Spread(R2, A, L2, now.touching), most)
                says = "and L is so large that R² does not fall to that"
                self.row(f"finite.turning.{o}", says, claim, "scene", glue)
        if criterion == RECEDING:
            self.row("finite.receding", "the particles recede as a whole", 0 <= A, "scene", glue)

    def _middles(
        self, context: str, letter: str, shown: Callable[[Middle], Fraction | None], says: str
    ) -> None:
        """A theorem applies to each ball in the middle."""
        for middle in middles(self.scene):
            o, (i, j), root = middle.ball, middle.others, shown(middle)
            if root is None:
                raise ValueError(f"the criterion does not hold of particle {o}")
            at = {
                "m": self.mass(o), "m_1": self.mass(i), "m_2": self.mass(j),
                "r_1": self.restitution(o, i), "r_2": self.restitution(o, j),
                letter: as_term(root),
            }  # fmt: skip
            here = {n: as_term(x) for n, x in _of(context.partition(":")[2], at).items()}
            claim = Applies(context, here)
            self.row(f"finite.middle.{o}", says.format(o), claim, "scene", "scene-finite-balls")

    def collapse(self, found: Numbers) -> None:
        """A theorem applies; when, and at which angle, the particles collapse."""
        state, value = self._next(), found.values
        unit = self._unit(state)
        is_on_a_line = "E" in value
        if is_on_a_line:
            later = self._collapse_on_a_line(unit, value)
        else:
            later = self._collapse_in_space(state, unit, found)
        low, high = found.time
        self.row("time-from", "the collapse is not before", as_term(low) <= self.time)
        self.row("time-to", "nor after", self.time + later <= as_term(high))
        if not is_on_a_line:
            (least, most), (C_0, theta) = found.angle, (value["C_0"], value["Theta"])
            says = "the final -cos θ is at least"
            self.row("angle-from", says, as_term(least) <= as_term(C_0 - theta))
            highest = as_term(min(C_0 + theta, Fraction(1)))
            self.row("angle-to", "and at most", highest <= as_term(most))

    def _contacts(self) -> tuple[Term, Term]:
        """The distances at which o touches c and s."""
        o, s, c = self.frame
        return self.contact(o, c), self.contact(o, s)

    def _unit(self, state: State) -> Unit:
        """This state with unit vectors."""
        at = _of(UNIT, state._asdict())
        if self.scene.bodies is None:
            unit = unit_of(state, sqrt, self.keep)
        else:
            c, s = self._contacts()
            unit = scaled_unit_of(state, (c, s), sqrt, self.keep)
            at |= _of(UNIT, {"l_c": c, "l_s": s})
        at |= _of(UNIT, unit._asdict())
        self.apply(f"unit.{self.moves}", "this state with unit vectors", UNIT, at)
        return unit

    def _applies(self, start: str, values: Mapping[str, Number], *uses: str) -> None:
        o, s, c = self.frame
        says = (
            f"from here on {pair_name(o, c)} and {pair_name(o, s)} collide in turn for ever, in "
            "finite time"
        )
        at = {name: as_term(value) for name, value in values.items()}
        self.row("collapse", says, Applies(start, at), "scene", *uses)

    def _collapse_in_space(self, state: State, unit: Unit, found: Numbers) -> Term:
        """The sharper theorem or the sandwich applies; a bound of the time that is left."""
        value = found.values
        if self.scene.bodies is not None:
            return self._balls(state, unit, found)
        start = {
            "y": unit.closing,
            "eta_s": unit.parting,
            "C": unit.cosine,
            "a": state.a,
            "b": unit.turning,
            "A": state.A,
            "B": state.B,
            "w": state.w,
            "d": unit.distance,
        }
        at = {**value, **{f"{name}_start": term for name, term in start.items()}}
        if found.stair:
            return self._stair(at, found.stair, value) * as_term(unit.closing)
        self._applies(START, at, "scene-collapses")
        return as_term(value["T"] * value["eta_0"] / (1 - value["p"] - value["Y"]))

    def _stair(
        self,
        at: Mapping[str, Number],
        points: tuple[tuple[Fraction, Fraction], ...],
        value: Mapping[str, Fraction],
    ) -> Term:
        """The sandwich theorem applies; a bound of the time that is left, per closing speed."""
        self._applies(SANDWICH_START, at, "scene-stair")
        half, G = (1 + r) / 2, as_term(value["G"])
        self._steps(STAIR, points, value, (half, half), (r, r), "scene-stair")
        return G * as_term(value["U_b"]) / as_term(value["w_b"] ** 2) / (1 - half * G)

    def _steps(
        self,
        stair: str,
        points: tuple[tuple[Fraction, Fraction], ...],
        value: Mapping[str, Fraction],
        shares: tuple[Term, Term],
        restitutions: tuple[Term, Term],
        glue: str,
    ) -> None:
        """The points are a stair, which ends below itself."""
        w, G = (as_term(value["w_0"]), as_term(value["w_1"])), as_term(value["G"])
        for n, ((Q, U), (Q_next, U_next)) in enumerate(pairwise(points)):
            numbers = {
                "alpha": shares[n % 2] * as_term(value["C_0"] - value["Theta"]),
                "rho": G * (w[(n + 1) % 2] / w[n % 2]) ** 2,
                "R": restitutions[n % 2] * G,
                "U_b": as_term(value["U_b"]),
            }
            step = {"Q": Q, "U": U, "Q_next": Q_next, "U_next": U_next}
            here = {key: as_term(x) for key, x in _of("stair", {**numbers, **step}).items()}
            says = f"the numbers Q_{n + 1}, U_{n + 1} are above where the map leads from the last"
            self.row(f"stair.{n}", says, Applies(stair, here), "scene", glue)
        for name, first, last in zip("qu", points[-3], points[-1], strict=True):
            says = "two steps later the stair is not above this one"
            self.row(f"period.{name}", says, as_term(last) <= as_term(first), "scene", glue)

    def _balls(self, state: State, unit: Unit, found: Numbers) -> Term:
        """The theorem on three balls applies; a bound of the time that is left."""
        (o, s, c), (to_c, to_s), value = self.frame, self._contacts(), found.values
        start = {
            "y": unit.closing,
            "eta_s": unit.parting,
            "C": unit.cosine,
            "a": self.keep("spin", state.a / to_s / to_c),
            "b": unit.turning,
            "A": self.keep("speed_c", state.A / to_c / to_c),
            "B": self.keep("speed_s", state.B / to_s / to_s),
            "w": self.keep("speeds", state.w / to_s / to_c),
            "d": unit.distance,
        }
        both = self.restitution(o, c), self.restitution(o, s)
        given = {
            "m": self.mass(o), "m_0": self.mass(c), "m_1": self.mass(s),
            "r_0": both[0], "r_1": both[1],
            "sigma_0": to_c, "sigma_1": to_s, "sigma_12": self.contact(s, c),
        }  # fmt: skip
        at = {**value, **given, **{f"{name}_start": term for name, term in start.items()}}
        self._applies(BALLS_START, at, "scene-balls")
        shares = as_term(value["beta_0"]), as_term(value["beta_1"])
        self._steps(BALLS_STAIR, found.stair, value, shares, both, "scene-balls")
        return as_term(value["E_0"]) * as_term(unit.closing)

    def _collapse_on_a_line(self, unit: Unit, value: Mapping[str, Fraction]) -> Term:
        """The theorem on a line applies; a bound of the time that is left."""
        for number, claim in enumerate(self._parallel(), 1):
            self.row(f"line.{number}", "the relative positions and velocities are on a line", claim)
        says = f"particle {self.frame[0]} is between the two others"
        self.row("between", says, 0 < as_term(unit.cosine))
        first = self.keep("first", as_term(unit.distance) / as_term(unit.closing))
        o, s, c = self.frame
        one = self.restitution(o, c)
        numbers = {"r": one, **value, "y": unit.closing, "eta": unit.parting, "T": first}
        if self.scene.bodies is None:
            numbers |= dict.fromkeys(("b", "b_s"), (1 + one) / 2)
        else:
            to_c, to_s = self._contacts()
            numbers |= {"y": unit.closing * to_c, "eta": unit.parting * to_s}
            numbers |= {
                name: self._size(
                    "b", f"{o}{i}", (1 + one) * self.mass(i) / (self.mass(o) + self.mass(i))
                )
                for name, i in (("b", c), ("b_s", s))
            }
        self._applies(LINE_START, _of("start", numbers), "scene-on-a-line")
        return as_term(value["E"]) * first

    def _parallel(self) -> Iterator[Claim]:
        """That all relative positions and velocities are multiples of one of them."""
        first, exact = (difference(rows.x, 0, 1) for rows in (self.given, self.exact))
        place = next(i for i, value in enumerate(exact) if value)
        others = [difference(self.given.x, 0, 2)]
        others += [difference(self.given.v, 0, i) for i in (1, 2)]
        for other in others:
            for i, value in enumerate(other):
                if i != place:
                    yield equal(value * first[place], other[place] * first[i])


def _of(context: str, values: Mapping[str, Number]) -> dict[str, Number]:
    """Values for the variables of a context, whose names begin with its name."""
    return {f"{context}.{name}": value for name, value in values.items()}


def _terms(state: State) -> State:
    return State(*map(as_term, state))


def _is_short(scene: Scene) -> bool:
    """Whether differences and inner products of given vectors are no longer than `SHORT`.

    Over the square of a common denominator these are integers, and at most ``most``: sums of
    products of two differences, one for each axis, less 1.
    """
    given = [
        *(scene.restitutions or (scene.r,)),
        *(x for rows in (scene.positions, scene.velocities) for x in chain(*rows)),
    ]
    given += () if scene.bodies is None else scene.bodies.radii
    divisor = lcm(*(number.denominator for number in given))
    top = int(max(map(abs, given)) * divisor)
    most = 4 * (scene.dimension + (scene.bodies is not None)) * top**2 + divisor**2
    return most.bit_length() + (divisor**2).bit_length() <= SHORT
