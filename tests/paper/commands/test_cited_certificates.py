"""What a folder cites lies in it with its certificate, so that it is checked alone."""

from __future__ import annotations

from pathlib import Path

import pytest

from verify import check
from verify.language.errors import OwnError, UnreadError
from verify.language.statement import PROVED
from verify.paper.commands.scene import scene_outcome
from verify.spheres.scene.decide import decide_scene
from verify.spheres.scene.scene_files import read_scene
from verify.wire.judge import accept
from verify.wire.write import write

CERTIFICATES = Path(__file__).parents[3] / "certificates"
SCENES = CERTIFICATES / "scenes"
FOLDERS = sorted({*CERTIFICATES.rglob("statement.json")})


@pytest.mark.parametrize("statement", FOLDERS, ids=lambda path: path.parent.name)
def test_a_committed_folder_needs_no_other_one(statement: Path) -> None:
    code, lines = check.check_folders(check.read_folders([str(statement.parent)]))
    assert code == 0
    assert "not proved here" not in lines[-1]


def written(name: str) -> dict[str, bytes]:
    path = SCENES / f"{name}.toml"
    found = decide_scene(read_scene(str(path), path.read_bytes()))
    return write(scene_outcome(found, found.flow.bits))


@pytest.mark.parametrize("name", ["nearly-aligned", "on-a-line", "parting"])
def test_a_scene_is_written_with_the_certificates_of_what_it_cites(name: str) -> None:
    files = written(name)
    cited = {file for file in files if file.startswith("cited/")}
    statements = {file for file in cited if not file.endswith(check.CERTIFIED)}
    assert cited - statements == {f"{file[:-5]}{check.CERTIFIED}" for file in statements} != set()
    accept(files, PROVED)


def test_a_folder_with_a_false_certificate_of_what_it_cites_is_not_accepted() -> None:
    files = written("parting")
    (name,) = (file for file in files if file.endswith(check.CERTIFIED))
    false = files | {name: files[name].replace(b'["goal", ', b'["goal", "goal", ', 1)}
    assert false != files
    with pytest.raises(OwnError, match="REFUSED"):
        accept(false, PROVED)


def test_one_limit_of_work_is_for_all_that_lies_in_a_folder(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    files = written("parting")
    statement, certificate = files["statement.json"], files["certificate.json"]
    cited = [file for file in files if file.startswith("cited/")]
    proof, other = (files[name] for name in sorted(cited))
    (found, (also,)) = next(
        iter(check.judged([check.Folder("", statement, certificate, [other], [(other, proof)])]))
    )
    assert min(found.work, also.work) > 0
    monkeypatch.setattr(check, "MAX_WORK", found.work + also.work)
    accept(files, PROVED)
    monkeypatch.setattr(check, "MAX_WORK", found.work + also.work - 1)
    with pytest.raises(UnreadError):
        accept(files, PROVED)
