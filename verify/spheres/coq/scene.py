"""What the certificate of a scene says of its three balls: a theorem in Coq.

Each collision of the certificate applies the flow; `verify/coq/FlowStep.v` takes the inner products
of the balls' places and velocities through it, and `verify/coq/Runs.v` makes a trajectory of them.
A flight to a collision may be cut into drifts (`verify/coq/FlowDrift.v`). A scene that disperses
ends in three pairs that never meet again; one that collapses applies the sharper theorem to the
state that the last collision leaves (`verify/coq/FlowCollapse.v`). Which ball is which is found by
comparing the first numbers with the scene; Coq checks that. Where a criterion shows that there are
finitely many collisions (`verify/coq/FiniteScenes.v`), Coq decides it at the start, and after some
collisions takes it from the rows of the certificate.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import permutations
from typing import NamedTuple

from verify import check
from verify.wire.coq.readable import Readable, readable
from verify.wire.coq.reading import NotAcceptedError, Reading

#: The numbers of a state, in the order of ``gram`` in FlowStep.v.
STATE = ("v", "lam", "rho", "eps", "sig", "A", "B", "C", "a", "b", "w")
#: What follows them in ``flow_collision`` there, without r.
STEP = (
    "y", "q", "kap", "s", "T", "C_next", "lam_next", "A_next", "B_next", "a_next", "b_next",
    "w_next", "eps_next",
)  # fmt: skip
PAIRS = ("01", "02", "12")
#: What follows the numbers of a state in ``flow_drift`` of FlowDrift.v, and the state after it.
DRIFTED = (*(f"{x}_next" for x in ("lam", "rho", "eps", "sig", "C", "a", "b")), "t")
FLOWN = ("v", *DRIFTED[:4], "A", "B", *DRIFTED[4:7], "w")
#: What follows the numbers of a state in ``recentred`` of FlowCollapse.v, and the state after it.
RECENTRED = tuple(f"{x}_next" for x in ("lam", "rho", "eps", "sig", "A", "C", "a", "b", "w"))
SEEN = (*(f"{x}_next" for x in STATE[1:6]), "B", *(f"{x}_next" for x in STATE[7:]))
#: The numbers of ``unit_numbers`` there, and of a state in AnyStep.v at the start.
UNIT = (
    "v", "lam", "rho", "eps", "sig", "C", "b", "reach", "closing", "parting", "cosine", "turning",
    "distance",
)  # fmt: skip
START = tuple(f"{x}_start" for x in ("y", "eta_s", "C", "a", "b", "A", "B", "w", "d"))
#: The rows that bound the time of a collapse and its angle.
BOUNDS = ("time-from", "time-to", "angle-from", "angle-to")
ENDS = {"flow:parting", "flow:passing"}
COLLAPSE = ["flow:unit", "sharper:start"]
#: Intervals of so many bits keep all numbers with a few hundred digits.
BITS = 1 << 12
#: What may come next on the way to a collision.
FLIGHT = {"flow:collision", "flow:drift"}
REASON = "it is no scene that disperses or collapses after collisions, each seen from one ball"
#: The rows of a criterion by which finitely many collisions are possible: how their names begin,
#: and the rest, with its theorem and what that has to unfold.
FINITE = "finite."
CRITERIA: dict[tuple[str, ...], tuple[str, str]] = {
    ("restitution",): ("restitution", ""),
    ("rest", "momentum"): ("momentum", "square_spin"),
    ("far", "receding"): ("receding", "square_size total_growth"),
    ("far", "turning"): ("turning", "square_size total_growth square_spin"),
}
#: Those that may hold after some collisions and not at the start, with the rows that are used then.
LATER: dict[tuple[str, ...], tuple[str, ...]] = {
    ("far", "receding"): ("far", "receding"),
    ("far", "turning"): ("turning",),
}
#: The collisions of a theorem in Coq happen after a time.
AT_ONCE = "two balls touch and collide at once, which no theorem in Coq allows for"

HEAD = """
(* --- three balls --- *)

From Coq Require Import Lra.
From Verify Require Theorem1 Motion Citations Flow FlowStep FlowScene Runs MODULES.

Lemma the_beginning : Citations.begins Flow.the_statement the_statement
  (Citations.size Flow.the_statement the_statement) = true.
Proof. vm_compute. reflexivity. Qed.
Lemma the_citations_are_true : citations_true the_statement.
Proof.
  apply (Citations.citations_closed
    [CITED]).
  - vm_compute. reflexivity.
  - repeat apply Forall_cons; [PROOFS | constructor].
Qed."""
CITED = "(MODULE.the_statement, Citations.size MODULE.the_statement the_statement)"


def about_scene(reading: Reading) -> list[str]:
    """What is added to the exported file.

    Raises:
        NotAcceptedError: for a statement that is no such scene.
    """
    found = reading.statement.rows.values()
    rows = [Applied(row.name, row.claim) for row in found if isinstance(row.claim, check.Applies)]
    names = tuple(row.name for row in found if row.name.startswith(FINITE))
    criterion = tuple(name.removeprefix(FINITE) for name in names)
    if names and criterion not in (LATER if rows else CRITERIA):
        raise NotAcceptedError(REASON)
    if names and not rows:
        return [*Scene(reading, [], [], collapses=False).finite(*CRITERIA[criterion])]
    contexts = [row.claim.context.name for row in rows]
    collapses = contexts[-2:] == COLLAPSE
    last = 0 if names else 2 if collapses else len(PAIRS)
    steps, ends = rows[: len(rows) - last], rows[len(rows) - last :]
    if steps and steps[-1].kind == "flow:pairs" and not collapses:
        steps.pop()
    ordered = all(
        row.kind == "flow:collision"
        or (row.kind == "flow:drift" and after in FLIGHT)
        or (row.kind == "flow:recentre" and before == "flow:collision" and after in FLIGHT)
        for before, row, after in _neighbours(steps)
    )
    ended = collapses or (len(ends) == last and {row.kind for row in ends} <= ENDS)
    if not (ordered and ended and (steps or not collapses)):
        raise NotAcceptedError(REASON)
    return [*Scene(reading, steps, ends, collapses=collapses, criterion=criterion).told()]


class Applied(NamedTuple):
    """A row that applies a context of the flow, by its name."""

    name: str
    claim: check.Applies

    @property
    def kind(self) -> str:
        """The context that it applies."""
        return self.claim.context.name


class Way(NamedTuple):
    """What has been said of the flight to the next collision: states, and how long drifts take."""

    seen: list[str]  # the labels of its states, the first one, and one after each drift
    times: list[str]

    def scene(self, n: int) -> str:
        """The last scene that has a name, after collision n."""
        return f"the_scene_{self.seen[-1] if self.times else n}"


def _neighbours(rows: list[Applied]) -> Iterator[tuple[str, Applied, str]]:
    """Each row, between what the one before it and the one after it apply."""
    kinds = ["", *(row.kind for row in rows), ""]
    yield from zip(kinds, rows, kinds[2:], strict=False)


class Scene:
    """A scene with its collisions, the balls from which they are seen, and its last rows."""

    def __init__(
        self,
        reading: Reading,
        steps: list[Applied],
        ends: list[Applied],
        *,
        collapses: bool,
        criterion: tuple[str, ...] = (),
    ) -> None:
        self.reading, self.steps, self.ends, self.collapses = reading, steps, ends, collapses
        self.limits = [f"{FINITE}{name}" for name in LATER.get(criterion, ())]
        self.criterion = CRITERIA.get(criterion, ("", ""))
        self.collisions = [row for row in steps if row.kind == "flow:collision"]
        self.meetings: list[str] = []
        self.cut: list[int] = []  # the collisions with a drift before them
        self.form = Readable(reading)
        self.places, self.velocities = self.coordinates("x"), self.coordinates("v")
        self.dimension = len(self.places[0])
        self.balls = self.roles()

    def rational(self, name: str) -> Fraction:
        """The number that a constant is."""
        kernel = self.reading.kernel
        if kernel.names.get(name) not in kernel.definitions:
            raise NotAcceptedError(REASON)
        low, high = check.Enclosing(kernel, BITS, None).enclose(kernel.names[name])
        if low != high:
            raise NotAcceptedError(REASON)
        return low

    def coordinates(self, letter: str) -> list[list[Fraction]]:
        """The places or the velocities."""
        names = self.reading.kernel.names
        axes = [k for k in range(1, 100) if f"{letter}.0.{k}" in names]
        return [[self.rational(f"{letter}.{ball}.{k}") for k in axes] for ball in range(3)]

    def given(self) -> list[str]:
        """The coordinates, as they are called."""
        names = self.reading.kernel.names
        return [
            self.form.notation.term(names[name], 4) for name in names if name[:2] in ("x.", "v.")
        ]

    def roles(self) -> tuple[int, int, int]:
        """The balls o, s and c of the first collision."""
        if not self.collisions:
            return 0, 1, 2
        found = {name: self.rational(f"{name}.0") for name in STATE[1:]}
        if not found["eps"]:
            raise NotAcceptedError(AT_ONCE)
        for o, s, c in permutations(range(3)):
            if self.inner(o, s, c) == found:
                return o, s, c
        raise NotAcceptedError(REASON)

    def inner(self, o: int, s: int, c: int) -> dict[str, Fraction]:
        """The numbers of the first state, if these balls have these roles."""
        x_s, x_c, w_s, w_c = (
            [b - a for a, b in zip(rows[o], rows[ball], strict=True)]
            for rows in (self.places, self.velocities)
            for ball in (s, c)
        )
        return {
            "lam": -_dot(x_c, w_c), "rho": _dot(x_s, w_s), "eps": _dot(x_c, x_c) - 1,
            "sig": _dot(x_s, x_s) - 1, "A": _dot(w_c, w_c), "B": _dot(w_s, w_s),
            "C": -_dot(x_s, x_c), "a": _dot(x_s, w_c), "b": _dot(x_c, w_s), "w": _dot(w_s, w_c),
        }  # fmt: skip

    def at(self, row: Applied) -> dict[str, str]:
        """The terms for the variables of a context of the flow, in ordinary notation."""
        items = row.claim.context.variables.items()
        kind = row.kind.rpartition(":")[2]
        return {
            name.rpartition(":")[2].removeprefix(f"{kind}."): self.form.notation.term(
                row.claim.at[x], 4
            )
            for name, x in items
        }

    def told(self) -> Iterator[str]:
        """All that is added."""
        names = [row.name for row in (*self.steps, *self.ends)]
        more = [*BOUNDS * self.collapses, *self.limits]
        yield from readable(self.reading, self.form, [*names, *more])
        yield self.head()
        yield self.scene()
        o, s, c = self.balls
        if self.collisions:
            yield self.first()
        n, flight = 0, Way(["0"], [])
        for row in self.steps:
            if row.kind == "flow:recentre":
                yield self.recentre(n, row, (o, s, c))
                flight = Way([f"recentre_{n}"], [])
                o, s = s, o
            elif row.kind == "flow:drift":
                yield self.drift(n, row, (o, s, c), flight)
                label = f"drift_{n}_{len(flight.times) + 1}"
                flight = Way([*flight.seen, label], [*flight.times, self.at(row)["t"]])
            else:
                n += 1
                yield self.collision(n, row, (o, s, c), flight)
                self.meetings.append(f"(Theorem1.B{o}, Theorem1.B{c}, the_time_{n})")
                self.cut += [n] * bool(flight.times)
                flight = Way([f"{n}"], [])
                s, c = c, s
        if self.limits:
            yield self.finite_later(flight.seen[-1])
        else:
            yield self.collapse((o, s, c)) if self.collapses else self.last((o, s, c))

    def finite(self, criterion: str, unfolded: str) -> Iterator[str]:
        """All that is added where finitely many collisions are possible, from the start on."""
        d, r = self.dimension, _number(self.rational("r"))
        numbers = self.inner(0, 1, 2)
        state = " ".join(f"({_number(numbers[name])})" for name in STATE[1:])
        yield f"""
(* --- three balls --- *)

From Coq Require Import Reals Lra.
From Verify Require Theorem1 FlowStep FiniteScenes.
Open Scope R_scope.{self.scene()}"""
        proof = f"apply FiniteScenes.finite_by_{criterion}; lra."
        if criterion != "restitution":
            yield f"""
Lemma the_seen_0 : FlowStep.gram {d} the_scene_0 Theorem1.B0 Theorem1.B1 Theorem1.B2 1
  {state}.
Proof.
  split; unfold the_scene_0, Theorem1.to, Theorem1.relative;
    cbn [Theorem1.dot Theorem1.position Theorem1.velocity]; field.
Qed."""
            names = ", ".join(f"FiniteScenes.{name}" for name in unfolded.split())
            proof = f"""eapply FiniteScenes.finite_by_{criterion};
    [lra | | exact the_seen_0 | ..]; [repeat split; discriminate | ..];
    unfold {names}; lra."""
        yield f"""
(* All collisions, of every trajectory, are at finitely many times. *)
Theorem three_balls : FiniteScenes.finite_after {d} {r} the_scene_0 [].
Proof.
  apply (FiniteScenes.run_finite {d} {r} [] the_scene_0); [lra | | reflexivity].
  {proof}
Qed."""

    def finite_later(self, seen: str) -> str:
        """A criterion for the state after the last collision, and the theorem."""
        n, d, r = len(self.collisions), self.dimension, self.restitution()
        theorem, unfolded = self.criterion
        said = map(self.form.notation.name, self.limits)
        rows = [f"pose proof ({name} the_citations_are_true); lra" for name in said]
        names = ", ".join(f"FiniteScenes.{x}" for x in unfolded.split())
        return f"""
Lemma the_limit : Classification.finite {d} {r} the_scene_{n}.
Proof.
  eapply FiniteScenes.finite_by_{theorem}; [lra | | exact the_seen_{seen} | ..];
    [repeat split; discriminate | ..]; unfold {names};
    [{" | ".join(rows)}].
Qed.

(* {n} collisions; and all collisions, of every trajectory, are at finitely many times. *)
Theorem three_balls : FiniteScenes.finite_after {d} {r} the_scene_0
  [{"; ".join(self.meetings)}].
Proof.
  refine (FiniteScenes.run_finite {d} {r} _ the_scene_{n} _ the_limit the_scene_0 _); [lra |].
  {self.run()}
Qed."""

    def head(self) -> str:
        """The head of the file: the cited theorems, with their proofs."""
        cited = [("Flow", "exact Flow.proved")]
        cited += [("Sharper", "exact (Sharper.proved SharperStep.citations)")] * self.collapses
        if self.limits:
            cited.append(("Collapsing", "exact (Collapsing.proved FlowFinite.citations)"))
        kinds = {row.kind for row in self.steps}
        more = "FlowDrift " * ("flow:drift" in kinds)
        more += "FlowCollapse " * (self.collapses or "flow:recentre" in kinds)
        more += "AnyStep Sharper SharperStep SharperCollapse" * self.collapses
        more += "Collapsing FlowFinite Classification FiniteScenes" * bool(self.limits)
        return (
            HEAD.replace(" MODULES", f" {more}".rstrip())
            .replace("CITED", ";\n     ".join(CITED.replace("MODULE", name) for name, _ in cited))
            .replace("PROOFS", " | ".join(proof for _, proof in cited))
        )

    def scene(self) -> str:
        """The scene that is given."""
        return f"""
Definition the_scene_0 : Theorem1.scene := Theorem1.Scene
  (fun ball k => match ball, k with{_cases(self.places)} | _, _ => 0 end)
  (fun ball k => match ball, k with{_cases(self.velocities)} | _, _ => 0 end)."""

    def first(self) -> str:
        """That the numbers of the scene are the first ones."""
        o, s, c = (f"Theorem1.B{ball}" for ball in self.balls)
        start = self.at(self.steps[0])
        unfolded = ", ".join((*(start[name] for name in STATE[1:]), *self.given()))
        return f"""
Lemma the_seen_0 : FlowStep.gram {self.dimension} the_scene_0 {o} {s} {c}
  {" ".join(start[name] for name in STATE)}.
Proof.
  split; unfold the_scene_0, Theorem1.to, Theorem1.relative, {unfolded};
    cbn [Theorem1.dot Theorem1.position Theorem1.velocity]; field.
Qed.
Lemma the_apart_0 : 0 < {start["eps"]}.
Proof. unfold {start["eps"]}, {", ".join(self.given())}. lra. Qed."""

    def substitution(self, n: str, row: Applied) -> str:
        """The numbers to which a row applies the flow."""
        text = self.form.numbers.substitution(row.claim.context, row.claim.at)
        return f"""
Definition the_at_{n} : substitution := {text}%positive.
Lemma the_numbers_{n} x t : put the_at_{n} x = Some t ->
  after the_statement (fun _ => 0) the_at_{n} x =
  show the_statement all_values (fun _ => 0) (read the_table 400 t).
Proof.
  intros E. rewrite (read_right the_statement the_order the_table the_table_is _ _ all_right).
  unfold after. now rewrite E.
Qed."""

    def read(self, n: str, at: dict[str, str]) -> str:
        """The end of a proof: in A, the numbers of these names are what the row puts for them.

        Where they are values of a variable, Coq need not compute to tell two of them apart; and
        it types what takes their place quickly where that is written as it is defined.
        """
        equations = ",\n    ".join(f"(E {x} _ eq_refl : v {x} = {text})" for x, text in at.items())
        return f"""pose proof the_numbers_{n} as E. revert A E.
  generalize (after the_statement (fun _ => 0) the_at_{n}). intros v A E.
  rewrite {equations} in A. exact A."""

    def certified(self, row: Applied, number: int, n: str) -> str:
        """The values satisfy what a context of the flow asks for."""
        return (
            f"(FlowScene.scope_of_row the_statement {number} the_at_{n} the_beginning eq_refl\n"
            f"    ({self.form.notation.name(row.name)} the_citations_are_true))"
        )

    def recentre(self, n: int, row: Applied, balls: tuple[int, int, int]) -> str:
        """The state after collision n as it is seen from the ball that was struck."""
        o, s, c = (f"Theorem1.B{ball}" for ball in balls)
        here, label = self.at(row), f"recentre_{n}"
        numbers = (*STATE, *RECENTRED)
        state = " ".join(("1", *(here[name] for name in SEEN)))
        return f"""{self.substitution(label, row)}
Lemma the_certified_{label} : FlowCollapse.recentred {" ".join(here[name] for name in numbers)}.
Proof.
  pose proof (FlowCollapse.recentre_certified _ {self.certified(row, 4, label)}) as A.
  {self.read(label, {f"Flow.number_of_recentre_{name}": here[name] for name in numbers})}
Qed.
Lemma the_seen_{label} : FlowStep.gram {self.dimension} the_scene_{n} {s} {o} {c} {state}.
Proof. eapply FlowCollapse.seen_from_s; [exact the_seen_{n} | exact the_certified_{label}]. Qed.
Lemma the_apart_{label} : 0 < {here["eps_next"]}.
Proof. eapply FlowCollapse.apart_seen; [exact the_seen_{label} | apply the_clear_{n}]. Qed."""

    def drift(self, n: int, row: Applied, balls: tuple[int, int, int], flight: Way) -> str:
        """The state after a part of the flight that follows collision n."""
        o, s, c = (f"Theorem1.B{ball}" for ball in balls)
        here, seen, scene = self.at(row), flight.seen[-1], flight.scene(n)
        label = f"drift_{n}_{len(flight.times) + 1}"
        numbers = (*STATE, *DRIFTED)
        state = " ".join(here[name] for name in FLOWN)
        return f"""{self.substitution(label, row)}
Lemma the_certified_{label} : FlowDrift.flow_drift {" ".join(here[name] for name in numbers)}.
Proof.
  pose proof (FlowDrift.drift_certified _ {self.certified(row, 5, label)}) as A.
  {self.read(label, {f"Flow.number_of_drift_{name}": here[name] for name in numbers})}
Qed.
Definition the_scene_{label} : Theorem1.scene := Theorem1.later {here["t"]} {scene}.
Lemma the_seen_{label} : FlowStep.gram {self.dimension} the_scene_{label} {o} {s} {c} {state}.
Proof. eapply FlowDrift.drift_next; [exact the_certified_{label} | exact the_seen_{seen}]. Qed.
Lemma the_apart_{label} : 0 < {here["eps_next"]}.
Proof. eapply FlowDrift.drift_still_apart; exact the_certified_{label}. Qed."""

    def collision(self, n: int, row: Applied, balls: tuple[int, int, int], flight: Way) -> str:
        """One collision: what the certificate says, the scene after it, and its numbers."""
        o, s, c = (f"Theorem1.B{ball}" for ball in balls)
        here, d, before = self.at(row), self.dimension, n - 1
        seen, scene = flight.seen[-1], flight.scene(before)
        numbers = ("r", *STATE, *STEP)
        values = " ".join(here[name] for name in numbers)
        names = (f"Flow.number_of_{'v_' if name == 'v' else name}" for name in numbers)
        rho = f"({here['r']} * {here['s']})"
        after = (here["y"], here["lam_next"], rho, here["eps_next"], "0")
        state = " ".join((*after, *(here[f"{name}_next"] for name in STATE[5:])))
        given = f"exact the_certified_{n} | exact the_later_{n} | "
        given += f"repeat split; discriminate | exact the_seen_{seen}"
        last = f"FlowStep.flight_time {here['y']} {here['T']}"
        cuts = "".join(
            f"eapply FlowDrift.drift_meets with (o := {o}) (i := {s}) (c := {c});\n  "
            f"[exact the_certified_{label} | repeat split; discriminate |"
            f" exact the_seen_{earlier} | ].\n  "
            for earlier, label in zip(flight.seen, flight.seen[1:], strict=False)
        )
        drifts = "".join(f", the_scene_{label}" for label in flight.seen[:0:-1])
        following = f"""
Lemma the_next_{n} : Theorem1.collided {d} {here["r"]} {o} {c}
  (Theorem1.later the_time_{n} the_scene_{before}) = the_scene_{n}.
Proof.
  unfold the_scene_{n}, the_time_{n}{drifts}. rewrite !Motion.later_later.
  apply f_equal, (f_equal (fun t => Theorem1.later t _)). ring.
Qed."""
        following *= bool(drifts)
        return f"""{self.substitution(str(n), row)}
Lemma the_certified_{n} : FlowStep.flow_collision {values}.
Proof.
  pose proof (FlowScene.collision_certified _ {self.certified(row, 1, str(n))}) as A.
  {self.read(str(n), dict(zip(names, (here[x] for x in numbers), strict=True)))}
Qed.
Lemma the_later_{n} : 0 < {here["kap"]}.
Proof. eapply FlowStep.kap_positive; [exact the_certified_{n} | exact the_apart_{seen}]. Qed.
Definition the_time_{n} : R := {" + (".join([*flight.times, last])}{")" * len(flight.times)}.
Definition the_scene_{n} : Theorem1.scene :=
  Theorem1.collided {d} {here["r"]} {o} {c} (Theorem1.later ({last}) {scene}).
Lemma the_meets_{n} : Theorem1.first_to_meet {d} the_scene_{before} {o} {c} the_time_{n}.
Proof. {cuts}eapply FlowStep.flow_meets with (i := {s}); [{given}]. Qed.{following}
Lemma the_seen_{n} : FlowStep.gram {d} the_scene_{n} {o} {c} {s} {state}.
Proof. eapply FlowStep.flow_next; [{given}]. Qed.
Lemma the_clear_{n} : 1 <= Motion.square {d} the_scene_{n} {o} {c} /\\
  1 < Motion.square {d} the_scene_{n} {o} {s} /\\ 1 < Motion.square {d} the_scene_{n} {c} {s}.
Proof.
  eapply FlowStep.flow_apart_after; [{given}].
Qed.
Lemma the_apart_{n} : 0 < {here["eps_next"]}.
Proof. apply the_certified_{n}. Qed."""

    def last(self, balls: tuple[int, int, int]) -> str:
        """No pair meets again, and the theorem."""
        n, d = len(self.collisions), self.dimension
        texts = "".join(self.end(i, row) for i, row in enumerate(self.ends))
        r = self.restitution()
        again = self.by_state(balls) if n else self.by_numbers(balls)
        return f"""{texts}
Lemma the_end : forall t, 0 < t -> Theorem1.nobody_collides {d} (Theorem1.later t the_scene_{n}).
Proof.{again}
Qed.

(* {len(self.collisions)} collisions, and then none. *)
Theorem three_balls : Runs.disperses {d} {r} the_scene_0
  [{"; ".join(self.meetings)}].
Proof.
  refine (Runs.run_disperses {d} {r} the_scene_0 _ the_scene_{n} _ the_end). {self.run()}
Qed."""

    def restitution(self) -> str:
        """The number r of the scene."""
        kernel = self.reading.kernel
        return self.form.notation.term(kernel.definitions[kernel.names["r"]], 4)

    def run(self) -> str:
        """The proof that the collisions are those, one after the other."""
        proofs = (
            f"[discriminate | exact the_meets_{i} | "
            f"{f'exact the_next_{i}' if i in self.cut else 'reflexivity'} | ]"
            for i in range(1, len(self.collisions) + 1)
        )
        return "".join(f"eapply Runs.run_on; {proof}.\n  " for proof in proofs) + "reflexivity."

    def collapse(self, balls: tuple[int, int, int]) -> str:
        """The sharper theorem for the state after the last collision, and the theorem."""
        o, s, c = (f"Theorem1.B{ball}" for ball in balls)
        n, d, r = len(self.collisions), self.dimension, self.restitution()
        unit, start = map(self.at, self.ends)
        at_start = ", ".join(
            f"(the_numbers_collapse Sharper.number_of_{name} _ eq_refl)" for name in START
        )
        said = ("r", "p", "Y", "T", "eta_0", "C_0", "Theta")
        limit = f"(Sharper.duration {start['p']} {start['Y']} {start['T']} * {start['eta_0']})"
        bounds = self.bounds()
        time_from, time_to, angle_from, angle_to = (
            f"({self.form.notation.name(name)} the_citations_are_true)" for name in BOUNDS
        )
        times = ", ".join(f"the_time_{i}" for i in range(1, n + 1))
        return f"""{self.substitution("unit", self.ends[0])}
Lemma the_unit : FlowCollapse.unit_numbers {" ".join(unit[name] for name in UNIT)}.
Proof.
  pose proof (FlowCollapse.unit_certified _ {self.certified(self.ends[0], 8, "unit")}) as A.
  {self.read("unit", {f"Flow.number_of_unit_{name}": unit[name] for name in UNIT})}
Qed.{self.substitution("collapse", self.ends[1])}
Definition the_start := after the_statement (fun _ => 0) the_at_collapse.
Lemma the_start_is_good : scope SharperStep.SS SharperStep.start_context the_start.
Proof.
  apply FlowCollapse.sharper_of_row; [vm_compute; reflexivity|].
  exact ({self.form.notation.name(self.ends[1].name)} the_citations_are_true).
Qed.
Definition the_renamed_scene := Runs.renamed {o} {s} {c} the_scene_{n}.
Lemma the_state : AnyStep.has (SharperStep.numbers_of
  (after SharperStep.SS the_start SharperStep.start)) {d} the_renamed_scene Theorem1.B1 Theorem1.B2.
Proof.
  rewrite SharperCollapse.first_numbers. unfold the_start.
  rewrite {at_start}.
  eapply FlowCollapse.unit_state; [exact the_seen_{n} | exact the_unit].
Qed.
Lemma the_collapse : Theorem1.collapse {d} {r} the_renamed_scene
  {limit} {start["C_0"]} {start["Theta"]}.
Proof.
  pose proof (SharperCollapse.sharper_collapse the_start the_start_is_good {d} _ the_state) as A.
  unfold SharperCollapse.latest, the_start in A.
  {self.read("collapse", {f"Sharper.number_of_{name}": start[name] for name in said})}
Qed.

(* {n} collisions, and then collisions without end. *)
Theorem three_balls : Runs.collapses_after {d} {r} the_scene_0
  [{"; ".join(self.meetings)}] {o} {s} {c}
  {" ".join(bounds)}.
Proof.
  refine (FlowCollapse.collapses_from {d} {r} the_scene_0 _ the_scene_{n} {o} {s} {c}
    _ _ _ _ _ _ _ _ _ the_collapse _ _ _ _).
  - repeat split; discriminate.
  - {self.run()}
  - pose proof {time_from} as A. revert A. unfold Runs.lasts, {times}, FlowStep.flight_time,
      {self.clocks()}. cbn [fold_right snd]. lra.
  - pose proof {time_to} as A. revert A. unfold Runs.lasts, {times}, FlowStep.flight_time,
      {self.clocks()}. cbn [fold_right snd]. intros A.
    refine (Rle_trans _ _ _ (Rplus_le_compat_l _ _ _ (FlowCollapse.duration_at_most _ _ _ _
      {self.duration()} _ _)) _); lra.
  - pose proof {angle_from} as A. lra.
  - pose proof {angle_to} as A. lra.
Qed."""

    def bounds(self) -> list[str]:
        """The bounds of the time and of the angle."""
        rows, term = self.reading.statement.rows, self.form.notation.term
        claims = {name: rows[name].claim for name in BOUNDS if name in rows}
        if len(claims) < len(BOUNDS) or not all(
            isinstance(x, check.Claim) for x in claims.values()
        ):
            raise NotAcceptedError(REASON)
        return [
            term(claim.lhs if name.endswith("from") else claim.rhs, 4)
            for name, claim in claims.items()
            if isinstance(claim, check.Claim)
        ]

    def duration(self) -> str:
        """How long the collapse takes at most, from the last collision on: a term of a bound."""
        claim, kernel = self.reading.statement.rows["time-to"].claim, self.reading.kernel
        if not isinstance(claim, check.Claim) or kernel.nodes[claim.lhs].op != "add":
            raise NotAcceptedError(REASON)
        return self.form.notation.term(kernel.nodes[claim.lhs].subterms[1], 4)

    def clocks(self) -> str:
        """The constants that are the times of the collisions, the last one first."""
        names = self.reading.kernel.names
        found = [name for name in names if name.startswith("time.")][::-1]
        return ", ".join(self.form.notation.term(names[name], 4) for name in found)

    def pairs(self, balls: tuple[int, int, int]) -> Iterator[tuple[str, int]]:
        """The pairs o-s, o-c and s-c by name, each with the number of its last row."""
        o, s, c = balls
        rows = [row.name.rpartition(".")[2] for row in self.ends]
        for pair in ((o, s), (o, c), (s, c)):
            name = "".join(map(str, sorted(pair)))
            yield name, rows.index(name)

    def by_state(self, balls: tuple[int, int, int]) -> str:
        """That no pair meets again after the last collision."""
        n, names = len(self.collisions), " ".join(f"Theorem1.B{ball}" for ball in balls)
        order = " | ".join(f"apply the_ends_{i}" for _, i in self.pairs(balls))
        return f"""
  eapply (FlowScene.never_again {self.dimension} the_scene_{n} {names});
    [repeat split; discriminate | exact the_seen_{n} | | {order}].
  destruct the_clear_{n} as (A & B & C). repeat split; lra."""

    def by_numbers(self, balls: tuple[int, int, int]) -> str:
        """That no pair of the given scene ever meets."""
        names = " ".join(f"Theorem1.B{ball}" for ball in balls)
        begun = f"""
  apply (Runs.never_any {self.dimension} the_scene_0 {names});
    [repeat split; discriminate | | | ]."""
        return begun + "".join(self.never(pair, i) for pair, i in self.pairs(balls))

    def never(self, pair: str, i: int) -> str:
        """That a pair of the given scene never meets."""
        term, names = self.form.notation.term, self.reading.kernel.names
        m, g, p = (term(names[f"{letter}.{pair}.0"], 4) for letter in "mgp")
        return f"""
  - apply FlowScene.never_by_numbers with (m := {m}) (g := {g}) (p := {p});
      [ | | | | apply the_ends_{i}]; unfold {m}, {g}, {p}, {", ".join(self.given())},
      the_scene_0, Motion.square, Theorem1.rate, Theorem1.to, Theorem1.relative;
    cbn [Theorem1.dot Theorem1.position Theorem1.velocity]; lra."""

    def end(self, i: int, row: Applied) -> str:
        """The claim of a row that a pair does not meet again, with its proof."""
        kind = row.claim.context.name.removeprefix("flow:")
        number = {"parting": 9, "passing": 11}[kind]
        here = self.at(row)
        p = here["p"]
        says = f"forall m g, FlowScene.pair_ends m g {p}"
        intros, more, names = "intros m g. ", " m g", ["p"]
        if kind == "passing":
            says = f"FlowScene.pair_ends {here['m']} {here['g']} {p}"
            intros, more, names = "", "", ["m", "g", "p"]
        good = self.certified(row, number, f"end_{i}")
        return f"""{self.substitution(f"end_{i}", row)}
Lemma the_ends_{i} : {says}.
Proof.
  {intros}pose proof (FlowScene.{kind}_certified _ {good}{more}) as A.
  {self.read(f"end_{i}", {f"Flow.number_of_{kind}_{x}": here[x] for x in names})}
Qed."""


def _dot(u: list[Fraction], v: list[Fraction]) -> Fraction:
    return sum((a * b for a, b in zip(u, v, strict=True)), Fraction(0))


def _cases(rows: list[list[Fraction]]) -> str:
    """The coordinates, each as a case of a match."""
    return "".join(
        f"\n    | Theorem1.B{ball}, {k}%nat => {_number(x)}"
        for ball, row in enumerate(rows)
        for k, x in enumerate(row)
    )


def _number(x: Fraction) -> str:
    sign = "- " if x < 0 else ""
    return f"{sign}({abs(x.numerator)} / {x.denominator})"
