"""What comes with the program: certificates that are not checked in each run; what Coq checked."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from functools import cache
from hashlib import sha256

from verify.language.errors import OwnError
from verify.language.record import Record

#: The folder with copies of some of those in `certificates`.
PACKAGED = os.path.join(os.path.dirname(os.path.dirname(__file__)), "data")
#: The one about all parameters.
ALL = "theorem1-all"
#: Those about the theorem as printed: its set with > for <, and that with < it is false.
PRINTED_SET, PRINTED_SIGN = "printed-set", "printed-sign"
#: The rows of the printed set for all parameters, of which some are refuted.
AS_PRINTED = "printed"
#: Their files with their digests. Who cites one rests on them: it is not checked again in each run.
PACKAGED_FILES = {
    "step": {
        "statement.json": "920523cdfa1f9afd807f321e05b78cadd7ee760b1a5764d4e1f36c9a7e786716",
        "certificate.json": "25236b082b9cf3cceeff68dfd52115a55bb8507e6d307924ad5cff2b25935eec",
    },
    "step-printed": {
        "statement.json": "1aa67de5dabc18e6bcb076c0e7974e19b4363aa9f9b1935d8ef599e125b1a25b",
        "certificate.json": "947372616aa1f1b98820d80b41ad0fc428ebd8be0bb6535a9e0120cc0835f0a1",
    },
    ALL: {
        "statement.json": "8732bbdf352eef2623fb3cb50fd30b6ab0b4e6fb49f2b4592ba61278b9a95619",
        "certificate.json": "d1800a119d7d2012c81fffc8d4624f026948f7f3f1c9e011e8124207301747c2",
    },
    PRINTED_SET: {
        "statement.json": "0cc7a4cc9fbe85282249c5391d26d9d73b5a7a88e07f9294c400f171538a48b1",
        "certificate.json": "3d4226f92179f1e84ee4bf52254c7cdfbcce96956eab2a481376f0fc402ae1e7",
    },
    PRINTED_SIGN: {
        "statement.json": "463af7a92b5e55614165a6db3576bbdc71f2369147ab8e69e1116bd12ed9cd30",
        "certificate.json": "89babf16199a2031626b0e2e9b1a92642a77685bcc1a5cf4507760ade71c7e10",
    },
    "thresholds": {
        "statement.json": "cd4602cefb1bfc76902297d936571f3de8ddb6e51fe4789ca75bdc3f263bc9c5",
        "certificate.json": "b91a2e5c5fe90afc92de5e8b376eee099f1d51c28586d9a8b721f0aa230076b0",
    },
    "spectrum": {
        "statement.json": "cb88e35f0984c1c4533cbdb35be8510235da71449440e01f380931109a05b129",
        "certificate.json": "91da4da5fac5a1c12ce9f4cbe2d585155b646cf1174a1735ed1e1e48303e58a7",
    },
    "classification": {
        "statement.json": "569536f6f737b332a6639a14e1b17d8a66ed12a481014b00afc956fabfa560ab",
        "certificate.json": "00ae127acd0ac1b159de5d65cddd2c59c8297c38257a9e68a2b10a79abdc2360",
    },
    "elsewhere": {
        "statement.json": "181792ad7ec7f2175bb89072eab89add2312e806111684bdafdf88cb98b09151",
        "certificate.json": "22bd5211b6e5f66e11c24ec50522ac5ec883a7fdca776f8257fc125d3a654123",
    },
    "sharper": {
        "statement.json": "52d5abca77e65dd9c6c064ef529d4774214a42f6914bb076b725552dd0940776",
        "certificate.json": "52bf65d988214955a003a13c0de0dd745538e6a65af9b62d488e281873240d92",
    },
    "sandwich": {
        "statement.json": "c4a6b29d0fb22d2b4c1b93aef03e7f3b1df83d4922468a59103e03abd25083b9",
        "certificate.json": "641b74fbafa49f91669cdb7c294f79a1ffb796198fc1bde675d0138db20d7438",
    },
    "outside": {
        "statement.json": "5c9b97b7904e956200959e7a74a67b9b8ed478dbec6286276938d93f0f1a141c",
        "certificate.json": "aa181b9d7644d9858063e895dabc816bd8dcc0b83e4dc027035255b1680d0864",
    },
    "flow": {
        "statement.json": "63e41a57a263ab3bc26da25168946bcc4dbcc0661e77b674833aa1c073e32efd",
        "certificate.json": "a8a89c0d654ee10d935093008c06f9dc368db237fa56c46816deb8f0a043a38f",
    },
    "line": {
        "statement.json": "8240884d6bff9ab4d3d8c70114ee085dc1ef5ecbed7a8381895a083125bc43d6",
        "certificate.json": "3f2568497398c41a31aa9b3ebfd4452a6a7fd3f7ae25c86389432d982e0a77ce",
    },
    "separatrix": {
        "statement.json": "62a1f81ac3024b2a1e30d5d257908b85f86946db48cdd8a2e5b28041db533128",
        "certificate.json": "a988e231b813396ebbc62e0b6d2e00dd254afc1cc1d2a537e049129e9dd44a44",
    },
    AS_PRINTED: {
        "statement.json": "5c9a22d238e60320ab5e80a982eba34ca454f3ac39e3e63bc9f15dc32133b5d6",
        "certificate.json": "004f02dd90e0b4ab2a212c4b4eb6cb8aceed660aa9a6c8fa5b2bafc2fdb933e0",
    },
}

#: The pages of the paper: which of these each has become, and the digest of its text then.
PAGES = {
    "all_parameters": (
        "theorem1-all",
        "2780e0acfbe8b668d50c65c510656fa9c02d4d7e1389021fc0204cbbd45ac3a6",
    ),
    "classification": (
        "classification",
        "9e15a4313b855ed5e2b25e3b0f9bd0d5414074ee70bc7dad295bbcb036f370eb",
    ),
    "line": (
        "line",
        "928dc7410896cca46bb968e03e2661aa0266bd4db760927a1c7184f37a159043",
    ),
    "printed_rows": (
        "printed",
        "62052da5222f4fbae2a085f1521d2bd41b812d352226ec78588d951a1f59b7c4",
    ),
    "printed_set": (
        "printed-set",
        "2bec233c32488f0a9f9aab198b1ca456184c065cbb4bd374069b4fe864c9ffec",
    ),
    "printed_sign": (
        "printed-sign",
        "8ea8f14ec938f38e9c0f0638e53db830037d51a1aa8c6af00e7444a730dce55c",
    ),
    "sandwich_above": (
        "outside",
        "0fc5b3ad651103e0ac5a4033d289112bf56c3cb3095efee04cfa6813bb905b52",
    ),
    "sandwich_below": (
        "sandwich",
        "c12298705b271b6598de93c741c9953e5d17b56f5b8d950f13c21d35873b8e7b",
    ),
    "sections_1_to_4": (
        "elsewhere",
        "db8a0d8255641f6a87d3ad9f34a46fa59d23d09b0cc147edc36293a72e99f820",
    ),
    "separatrix": (
        "separatrix",
        "2cfe7a2d29dc9e7128c7e34efdfe9e2de8f3dcf6bc17ef046bfe7314292967c3",
    ),
    "sharper": (
        "sharper",
        "d2c894a4aeaf6f75e19c5fca8fffd7963b721e270606e6c485eddcc3942862b6",
    ),
    "spectrum": (
        "spectrum",
        "3cf75bed1a0460949f33c127db70dbd44d7671c3c8ab3cbfbda860d9523860dc",
    ),
    "step": (
        "step",
        "fbc3dde261e2ba847277cf9f9c52da0128d16001edf4ca978e3f704e62af7baf",
    ),
    "thresholds": (
        "thresholds",
        "c10f0320f217c6e452bd06ad8fb3f08fff840fd991e38ee91eced7dec88a96f4",
    ),
}


def became(page: str, text: bytes) -> str | None:
    """The name of what this text of a page has become, if that comes with the program.

    The digest is recorded only of a text that makes the very files: see `tests/bring.py`.
    """
    name, digest = PAGES.get(page, ("", ""))
    return name if sha256(text).hexdigest() == digest else None


def packaged_statements(digests: Iterable[str]) -> dict[str, bytes]:
    """The statements with these digests that come with the program, and what those cite.

    Raises:
        OwnError: if one is not as the checker has accepted it.
    """
    names = {files["statement.json"]: name for name, files in PACKAGED_FILES.items()}
    found: dict[str, bytes] = {}
    missing = [digest for digest in digests if digest in names]
    while missing:
        digest = missing.pop()
        content = packaged_files(names[digest])[0]
        found[digest] = content
        missing += [other for other in cited_digests(content) if other not in found]
    return found


def cited_digests(statement: bytes) -> list[str]:
    """The digests of statements that come with the program and are named in a statement."""
    return [
        files["statement.json"]
        for files in PACKAGED_FILES.values()
        if files["statement.json"].encode() in statement
    ]


@cache
def packaged_files(name: str) -> tuple[bytes, bytes]:
    """A statement and its certificate, which come with the program.

    Raises:
        OwnError: if they are not those that the checker has accepted.
    """
    found = []
    for file, expected in PACKAGED_FILES[name].items():
        path = os.path.join(PACKAGED, name, file)
        with open(path, "rb") as opened:
            found.append(opened.read())
        if sha256(found[-1]).hexdigest() != expected:
            raise OwnError(f"{path} is not the file that came with the program; install it anew")
    return found[0], found[1]


def packaged_certificate(digest: str) -> bytes:
    """The certificate of the statement with this digest, if it comes with the program."""
    for name, files in PACKAGED_FILES.items():
        if files["statement.json"] == digest:
            return packaged_files(name)[1]
    return b""


# --- what Coq has checked ------------------------------------------------------------------------


class Checked(Record):
    """The version of Coq, and the digests of each statement that it has checked, with its proof."""

    version: str
    pairs: frozenset[tuple[str, str]]

    def has(self, digests: Mapping[str, str]) -> bool:
        """Whether Coq has checked these very files, given by their digests."""
        return (digests["statement.json"], digests["certificate.json"]) in self.pairs


def checked() -> Checked:
    """The committed record."""
    import json  # loaded only where it is used

    with open(os.path.join(PACKAGED, "coq.json"), encoding="utf-8") as file:
        record = json.load(file)
    pairs = (
        (item["statement_sha256"], item["certificate_sha256"]) for item in record["certificates"]
    )
    return Checked(record["coq"], frozenset(pairs))
