"""What `.ci/coq` has compiled, asked of Coq at once.

    python -m tests.coq.everything DIRECTORY --certificates    # a file each; prints the folders
    python -m tests.coq.everything DIRECTORY                   # writes Everything.v and Printed.v

Everything.v has a definition for each committed certificate, whose type says that its statement is
true: a file that proves something else, or nothing, stops it there. Printed.v prints the statements
as Coq has them.
"""

from __future__ import annotations

import json
import sys
import tomllib
from collections.abc import Iterable, Iterator
from contextlib import redirect_stdout
from fractions import Fraction
from io import StringIO
from pathlib import Path

from tests.coq.closing import BALLS, BUILT, ROOT, module, unread
from verify import check
from verify.cli import main
from verify.paper.in_coq import CITED_IN_COQ, IN_COQ
from verify.spheres.coq.motion import about_balls
from verify.wire.coq.export import export

#: What Theorem1.v says and Pinned.v says once more, each of them proved.
SENTENCES = (
    "theorem_1", "interior", "positive_volume", "determined", "constants_defined",
    "same_hypothesis", "printed_theorem",
)  # fmt: skip
#: What follows from the point runs at r = 0.03, and at r = 0.01 and theta_0 = 5 pi / 6.
POINTS = (
    "Definition point : forall d s d_0 y, FromNumbers.initial_with",
    "  (Theorem1.phi_minus (3 / 100) 1) (637 / 1000000) (13 / 25000000) (147 / 10000000)",
    "  (59 / 6250000) 1 (1249 / 1000) (59 / 1000000) 1 d s d_0 y ->",
    "  Theorem1.collapse d (3 / 100) s (89 / 1000000000000) 1 (1 / 10)",
    "  := Point.three_balls.",
    "Definition angle : forall d s d_0 y, FromNumbers.initial_with",
    "  (Theorem1.phi_minus (1 / 100) (- cos (PI * (5 / 6)))) (291 / 500000) (289 / 500000000)",
    "  (161 / 10000000) (427 / 50000000) 1 (11 / 8) (647 / 10000000) (- cos (PI * (5 / 6)))",
    "  d s d_0 y -> Theorem1.collapse d (1 / 100) s (463 / 5000000000000)",
    "  (- cos (PI * (5 / 6))) (1 / 10) := Angle.three_balls.",
)
#: Which collapses there are, what becomes of scenes, and the spectrum.
COLLAPSES = (
    "no_triangle", "least_angle", "least_angle_any_radii", "never_any_radii", "bounded_impulse",
    "no_spin", "comes_to_rest", "finite_or_endless", "finite_if",
)  # fmt: skip
BOUNDS = ("exchange_theorem", "run_theorem", "run_on_a_line", "run_without_end")
THREE_BALLS = ("three_balls_theorem", "stairs_theorem", "three_equal_balls", "law_theorem")
OUTSIDE = ("next_theorem", "outside_theorem", "floor_theorem", "no_collapse")
ALEXANDER = (
    "collision_theorem", "order_theorem", "growth_theorem", "beneath_theorem", "two_orbits_theorem",
    "turn_theorem", "trap_theorem", "threshold_theorem", "stays_theorem",
)  # fmt: skip
MATRIX = ("basis_theorem", "matrix_theorem", "stated_theorem", "one_triple_theorem")
VALUES = (
    "characteristic_theorem", "spectrum_theorem", "eigenvector_theorem", "parameter_theorem",
    "orbit_theorem",
)  # fmt: skip
#: What it means that the program accepts the bytes of a certificate with a statement's digest.
FILES = (
    "From Verify Require Json DecodeStatement AcceptsFiles PinnedFiles.",
    "Definition files : forall texts d c S,",
    "  AcceptsFiles.accepts_beside (AcceptsFiles.by_digest texts) d c = AcceptsFiles.Accepts S ->",
    "  exists s x, In s texts /\\ AcceptsFiles.digest_of s = d /\\ Json.Document s x /\\",
    "  DecodeStatement.statement_of (AcceptsFiles.text_with (AcceptsFiles.by_digest texts)) x",
    "    = Some S /\\ (Meaning.citations_true S -> Meaning.true_statement S)",
    "  := AcceptsFiles.accepts_beside_sound.",
)
#: The scenes that disperse, with the balls that collide.
DISPERSING = {"passing": "", "parting": "01 02 01 02", "cut-later": "01 12"}
#: The scenes that collapse: the balls that collide, then the one in the middle, the one that it met
#: last and the one that it meets next; between what the time and minus the cosine of the angle are.
COLLAPSING = {
    "nearly-aligned": ("01 02", "021", "8953/1250000 9753/1250000 99483/100000 249719/250000"),
    "in-space": ("01 12", "120", "6277/20000 7933/25000 97079/100000 19831/20000"),
    "cut": ("01", "012", "305233/10000000 153313/5000000 486003/500000 486521/500000"),
}
#: The scenes with finitely many collisions, and the balls that collide before a criterion holds: no
#: more collisions are followed.
FINITE = {
    "on-a-line": "", "spinning": "", "turning": "", "turning-later": "02",
    "receding-later": "01 02 21",
}  # fmt: skip
#: For the scenes of each kind, what Coq proves of them: the last word before their numbers.
SCENES = {
    "Runs.disperses": DISPERSING, "Runs.collapses_after": COLLAPSING,
    "FiniteScenes.finite_after": FINITE,
}  # fmt: skip
#: The definition by which the theorem on three balls speaks that ends the file of a folder.
SAYS = dict.fromkeys(("theorem1-r-3-100", "theorem1-theta-5pi-6"), "Theorem1.collapse") | {
    f"scenes/{name}": word for word, names in SCENES.items() for name in names
}
#: Those whose certificates are made here; the others' are committed.
OWN_SCENES = Path(__file__).with_name("scenes")
#: The files of statements that are exported once more, after the flow, as `verify/coq/build` does.
AFTER_FLOW = {
    "Sharper": "sharper", "AsPrinted": "printed-set", "Collapsing": "classification",
}  # fmt: skip
PARTS = ("the_nodes", "the_contexts", "the_rows", "the_citations", "the_statement")


def conjunction(prefix: str, sentences: Iterable[str] = SENTENCES) -> str:
    """What is said of three balls, by names with a prefix."""
    return " /\\ ".join(f"{prefix}{name}" for name in sentences)


def dispersing(name: str) -> str:
    """What Coq proves of a scene, with its numbers as the file of the scene has them."""
    return _about_scene(name, DISPERSING[name], [])


def collapsing(name: str) -> str:
    """The same of a scene that collapses."""
    pairs, roles, bounds = COLLAPSING[name]
    more = [f"Theorem1.B{ball}" for ball in roles]
    return _about_scene(name, pairs, [*more, *map(_number, bounds.split())])


def finite(name: str) -> str:
    """The same of a scene with finitely many collisions."""
    return _about_scene(name, FINITE[name], [])


def _about_scene(name: str, collisions: str, more: list[str]) -> str:
    scene = tomllib.loads(scene_file(name).read_text(encoding="utf-8"))
    pairs = [(f"Theorem1.B{i}", f"Theorem1.B{j}") for i, j in collisions.split()]
    times = "".join(f"exists t_{n}, " for n, _ in enumerate(pairs))
    meetings = "; ".join(f"({i}, {j}, t_{n})" for n, (i, j) in enumerate(pairs))
    places, velocities = (_coordinates(scene[key]) for key in ("positions", "velocities"))
    says = " ".join(
        (f"{times}{SAYS[f'scenes/{name}']} {len(scene['positions'][0])} {_number(scene['r'])}",
         f"(Theorem1.Scene {places} {velocities})", f"[{meetings}]", *more)
    )  # fmt: skip
    file = compiled(name)
    proof = f"{'eexists. ' * len(pairs)}exact Scene_{file}.three_balls."
    return f"Theorem {file} : {says}.\nProof. {proof} Qed."


def scene_file(name: str) -> Path:
    """The file of a scene."""
    own = OWN_SCENES / f"{name}.toml"
    return own if own.exists() else ROOT / f"scenes/{name}.toml"


def followed(name: str) -> list[str]:
    """The options by which no more collisions of a scene are followed than have to be."""
    return ["--collisions", str(len(FINITE[name].split()))] if name in FINITE else []


def compiled(name: str) -> str:
    """A scene in the name of a file for Coq."""
    return name.replace("-", "_")


def _number(x: object) -> str:
    value = Fraction(str(x))
    return f"({value.numerator} / {value.denominator})"


def _coordinates(rows: list[list[object]]) -> str:
    """The function that gives each coordinate of each ball."""
    cases = [
        f"| Theorem1.B{ball}, {k}%nat => {'- ' * (x < 0)}({abs(x.numerator)} / {x.denominator})"
        for ball, row in enumerate(rows)
        for k, x in enumerate(map(Fraction, map(str, row)))
    ]
    return f"(fun ball k => match ball, k with {' '.join(cases)} | _, _ => 0 end)"


def discharging() -> list[str]:
    """The theorems and definitions in Coq that stand for sentences taken on trust."""
    sentences = [
        names
        for known in (IN_COQ, CITED_IN_COQ)
        for found in known.values()
        for names in found.values()
    ]
    return [*dict.fromkeys(name for names in sentences for name in names)]


def folders() -> list[Path]:
    """Those with a certificate that the checker in Coq can read; each statement has to have one."""
    found = sorted(path.parent for path in ROOT.rglob("certificate.json"))
    if found != sorted(path.parent for path in ROOT.rglob("statement.json")) or not found:
        raise SystemExit("a folder has a statement without a certificate, or there are none")
    return [folder for folder in found if folder not in unread()]


def exports(directory: Path) -> Iterator[str]:
    """The folders; each has a file afterwards, or `verify/coq/build` writes it.

    So have the scenes of `.ci/coq` alone, whose certificates are made here.
    """
    for folder in folders():
        name = str(folder.relative_to(ROOT))
        if name not in BUILT:
            _export(folder, name in BALLS, directory / f"{module(folder)}.v")
        yield f"certificates/{name}"
    for scene in sorted(OWN_SCENES.glob("*.toml")):
        made = directory / f"Scene_{compiled(scene.stem)}"
        with redirect_stdout(StringIO()):
            if code := main(["scene", str(scene), *followed(scene.stem), "--out", str(made)]):
                raise SystemExit(f"{scene}: no certificate, exit code {code}")
        _export(made, True, made.with_suffix(".v"))


def _export(folder: Path, balls: bool, file: Path) -> None:
    (read,) = check.read_folders([str(folder)])
    file.write_text(
        export(read, ending=about_balls if balls else None).rpartition("Print Assumptions")[0]
    )


def everything(folders: list[Path]) -> str:
    """The theorems about what is committed, one with another, and what they assume."""
    own = {module(folder): folder for folder in folders}
    scenes = [name for names in SCENES.values() for name in names]
    lines = [f"From Verify Require {name}." for name in own]
    lines += [
        "From Verify Require Meaning Checker Accepted Closed Point Angle Pinned PinnedMeaning.",
        "From Coq Require Import Reals.",
        "From Verify Require Theorem1 FromNumbers.",
        "Open Scope R_scope.",
        *POINTS,
        "From Verify Require Runs FiniteScenes.",
        f"From Verify Require {' '.join(f'Scene_{compiled(name)}' for name in scenes)}.",
        "From Coq Require Import List.",
        "Import ListNotations.",
        *map(dispersing, DISPERSING),
        *map(collapsing, COLLAPSING),
        *map(finite, FINITE),
        "Definition soundness : forall S C, Checker.accepts S C = true ->",
        "  Meaning.citations_true S -> Meaning.true_statement S := Accepted.accepts_sound.",
        f"Definition theorem_1 : {conjunction('Pinned.')}",
        "  := Pinned.proved.",
        *FILES,
        "From Verify Require PinnedPrintedSet.",
        "Definition printed_set : PinnedPrintedSet.printed_set_theorem",
        "  := PinnedPrintedSet.printed_set_proved.",
        "From Verify Require PinnedClassification PinnedPrintedSign PinnedSpectrum PinnedLine",
        "  PinnedThreeBalls PinnedSandwich PinnedOutside PinnedBounds.",
        f"Definition classification : {conjunction('PinnedClassification.', COLLAPSES)}",
        "  := PinnedClassification.classification_proved.",
        f"Definition bounds : {conjunction('PinnedBounds.', BOUNDS)}",
        "  := PinnedBounds.bounds_proved.",
        "Definition line : PinnedLine.line_theorem /\\ PinnedLine.equal_on_a_line",
        "  := PinnedLine.line_proved.",
        f"Definition three_balls : {conjunction('PinnedThreeBalls.', THREE_BALLS)}",
        "  := PinnedThreeBalls.three_balls_proved.",
        "Definition sandwich : PinnedSandwich.sandwich_theorem /\\ PinnedSandwich.stairs_theorem",
        "  := PinnedSandwich.sandwich_proved.",
        f"Definition outside : {conjunction('PinnedOutside.', OUTSIDE)}",
        "  := PinnedOutside.outside_proved.",
        "From Verify Require PinnedAlexander AlexanderProof.",
        f"Definition alexander : {conjunction('PinnedAlexander.', ALEXANDER)}",
        "  := AlexanderProof.alexander.",
        "Definition printed_sign : PinnedPrintedSign.printed_sign_theorem",
        "  := PinnedPrintedSign.printed_sign_proved.",
        "Definition not_as_printed : ~ PinnedPrintedSign.as_printed",
        "  := PinnedPrintedSign.false_as_printed.",
        f"Definition matrix : {conjunction('PinnedSpectrum.', MATRIX)}",
        "  := PinnedSpectrum.matrix_proved.",
        f"Definition spectrum : {conjunction('PinnedSpectrum.', VALUES)}",
        "  := PinnedSpectrum.spectrum_proved.",
        "From Verify Require PinnedSeparatrix SeparatrixProof.",
        "Definition separatrix : PinnedSeparatrix.separatrix_theorem",
        "  := SeparatrixProof.separatrix.",
    ]
    theorems = discharging()
    files = dict.fromkeys(
        ["Sentences", "BeyondSentences", *(name.split(".")[0] for name in theorems)]
    )
    lines.append(f"From Verify Require {' '.join(files)}.")
    lines.append(f"Definition discharged := ({', '.join(theorems)}).")
    for name, folder in own.items():
        cites = json.loads((folder / "statement.json").read_bytes())["cites"]
        proof = f"Closed.closed_{name}" if cites else f"{name}.proved"
        lines.append(f"Definition true_{name} : Meaning.true_statement {name}.the_statement")
        lines.append(f"  := {proof}.")
    names = "".join(f", true_{name}" for name in own)
    main = f"soundness, files, theorem_1, point, angle, {', '.join(map(compiled, scenes))}"
    main += ", Pinned.collapsing_scene, printed_set, separatrix, discharged, classification"
    main += (
        ", bounds, line, three_balls, sandwich, outside, alexander, printed_sign, not_as_printed"
    )
    main += ", matrix, spectrum, PinnedPrintedSign.false_for_all"
    lines.append(f"Definition everything := ({main}{names}).")
    return "\n".join([*lines, "Print Assumptions everything.", ""])


def printed(names: list[str]) -> str:
    """Coq prints the data of the statement in each file, in the notation of the file."""
    lines = [
        "From Coq Require Import ZArith List.",
        f"From Verify Require Import Meaning. From Verify Require {' '.join(names)}.",
        "Import ListNotations.",
        "Open Scope positive_scope.",
        "Set Printing Width 100000000. Set Printing Depth 100000000. Unset Printing Records.",
        "Set Printing Raw Literals.",  # else each numeral is computed
        *(f"Print Verify.{name}.{part}." for name in names for part in PARTS),
    ]
    return "\n".join([*lines, ""])


if __name__ == "__main__":
    directory = Path(sys.argv[1])
    if sys.argv[2:] == ["--certificates"]:
        for folder in exports(directory):
            print(folder)
        sys.exit()
    (directory / "Everything.v").write_text(everything(folders()))
    (directory / "Printed.v").write_text(printed([*map(module, folders()), *AFTER_FLOW]))
