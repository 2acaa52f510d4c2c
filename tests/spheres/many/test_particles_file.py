"""Files of simulations: the same particles from each kind, exactly; what is odd is refused."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pytest

from verify.spheres.many.system import System
from verify.spheres.many.system_file import system_from, table_in
from verify.wire.inputs import InputError

CSV = """id,x,y,vx,vy,mass,diameter
1,0.1,0,1e-1,0,1,1
2,1.5,0.25,-0.3,0,2,0.5
"""
XYZ = """2
Lattice="9 0 0 0 8 0 0 0 7" Properties=species:S:1:pos:R:3:velo:R:3:mass:R:1:radius:R:1 Time=3
A 0.1 0 0 1e-1 0 0 1 0.5
A 1.5 0.25 0 -0.3 0 0 2 0.25
"""
DUMP = """ITEM: TIMESTEP
1000
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS pp pp pp
-1 8
0 8
-0.5 0.5
ITEM: ATOMS id type x y z vx vy vz mass radius
1 1 0.1 0 0 1e-1 0 0 1 0.5
2 1 1.5 0.25 0 -0.3 0 0 2 0.25
"""


def read(folder: Path, name: str, text: str, more: str = "") -> System:
    (folder / name).write_text(text)
    scene = f'r = "0.1"\nparticles = "{name}"\n{more}'
    where = str(folder / "scene.toml")
    return system_from(where, table_in(where, scene.encode()))


def test_the_same_particles_from_each_kind(tmp_path: Path) -> None:
    periods = (Fraction(9), Fraction(8))
    first = read(tmp_path, "a.csv", CSV, "box = [9, 8]\n")
    assert first.positions == ((Fraction(1, 10), 0), (Fraction(3, 2), Fraction(1, 4)))
    assert first.velocities == ((Fraction(1, 10), 0), (Fraction(-3, 10), 0))
    assert (first.masses, first.radii, first.box) == (
        (1, 2),
        (Fraction(1, 2), Fraction(1, 4)),
        periods,
    )
    assert read(tmp_path, "a.xyz", XYZ) == first
    assert read(tmp_path, "a.lammpstrj", DUMP) == first


def test_without_periods(tmp_path: Path) -> None:
    assert read(tmp_path, "a.xyz", XYZ.replace("Time=3", 'pbc="F F F"')).box == ()
    assert read(tmp_path, "a.dump", DUMP.replace("pp pp pp", "ff ff ff")).box == ()


def test_other_keys_of_extended_xyz_and_words_are_not_read(tmp_path: Path) -> None:
    more = 'Time=3 a-pbc="F F F" b="pbc=F" free_energy=-1.5e3 relaxed'
    assert read(tmp_path, "a.xyz", XYZ.replace("Time=3", more)) == read(tmp_path, "a.xyz", XYZ)


def test_a_third_coordinate_is_left_out_only_where_it_stays_0(tmp_path: Path) -> None:
    assert read(tmp_path, "a.dump", DUMP.replace("pp pp pp", "ff ff ff")).dimension == 2
    moving = DUMP.replace("pp pp pp", "ff ff ff").replace("-0.3 0 0 2", "-0.3 0 0.5 2")
    assert read(tmp_path, "a.dump", moving).dimension == 3


BAD = {
    "ending": ("a.txt", CSV, "", "a file that ends in .csv"),
    "column": ("a.csv", CSV.replace("mass", "weight"), "", "line 1: the column 'weight'"),
    "twice": ("a.csv", CSV.replace("mass", "x"), "", "line 1: the column 'x'"),
    "no-velocity": ("a.csv", CSV.replace("vy", "id2").replace("id2", "type"), "", "a velocity for"),
    "no-number": ("a.csv", CSV.replace("0.25", "0.2.5"), "", "line 3: y: '0.2.5'"),
    "infinite": ("a.csv", CSV.replace("1e-1", "nan"), "", "line 2: vx: 'nan'"),
    "words": ("a.csv", CSV.replace("2,1.5,", "1.5,"), "", "line 3: has 6 columns"),
    "both": ("a.csv", CSV, "masses = [1, 1]\n", "masses: a.csv has them too"),
    "both-boxes": ("a.xyz", XYZ, "box = [9, 8]\n", "box: a.xyz has them too"),
    "frames": ("a.xyz", XYZ + XYZ, "", "line 1: '2' is not the number of the 6 lines"),
    "skew": ("a.xyz", XYZ.replace("9 0 0", "9 1 0"), "", "a Lattice with right angles"),
    "partly": ("a.xyz", XYZ.replace("Time=3", 'pbc="T T F"'), "", 'write pbc="T T T"'),
    "property": ("a.xyz", XYZ.replace("mass:R", "force:R"), "", "the column 'force'"),
    "properties": ("a.xyz", XYZ.replace("Properties", "Property"), "", "line 2: write Properties="),
    "scaled": ("a.dump", DUMP.replace(" x y z", " xs ys zs"), "", "line 9: the column 'xs'"),
    "walls": ("a.dump", DUMP.replace("pp pp pp", "pp pp ff"), "", "in all directions"),
    "tilted": ("a.dump", DUMP.replace("-1 8", "-1 8 0"), "", "a box with right angles"),
    "moments": ("a.dump", DUMP + DUMP, "", "one moment and no more"),
    "empty": ("a.csv", "", "", "not a velocity for each"),
    "cut": ("a.dump", "ITEM: TIMESTEP\n", "", "line 3: has to begin with"),
    "blank": ("a.csv", CSV.replace("2,1.5", "\n\n2,1.5a"), "", "line 5: x: '1.5a'"),
    "sizes": ("a.csv", CSV.replace("mass", "radius"), "", "line 1: has a column radius and"),
    "spaced": ("a.xyz", XYZ.replace("Time=3", 'pbc = "F F F"'), "", "without spaces around ="),
    "letters": ("a.xyz", XYZ.replace("Time=3", 'PBC="F F F"'), "", "line 2: write each of"),
    "lattice": ("a.xyz", XYZ.replace("Lattice", "lattice"), "", "line 2: write each of"),
    "again": ("a.xyz", XYZ.replace("Time=3", 'Lattice="9 0 0 0 9 0 0 0 9"'), "", "at most once"),
    "quotes": ("a.xyz", XYZ.replace("Time=3", "a='pbc=T T'"), "", "line 2: write each of"),
    "glued": ("a.xyz", XYZ.replace('7" P', '7"P'), "", "line 2: write each of"),
    "only-names": ("a.csv", CSV.partition("\n")[0] + "\n", "", "line 2: has no particle"),
    "turned": ("a.dump", DUMP.replace("-1 8", "8 -1"), "", "a side of its box is not positive"),
    "nobody": ("a.xyz", "0\n", "", "line 1: '0' is not the number"),
}


@pytest.mark.parametrize("name", BAD)
def test_what_is_not_understood_is_refused_by_name_and_line(name: str, tmp_path: Path) -> None:
    file, text, more, why = BAD[name]
    with pytest.raises(InputError) as error:
        read(tmp_path, file, text, more)
    assert why in str(error.value)


def test_a_file_that_is_missing_is_named(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"particles: none\.csv cannot be read"):
        system_from(str(tmp_path / "scene.toml"), {"r": "0.1", "particles": "none.csv"})
