"""Identities, frames and lines, as every language computes them (tests/client/vectors, src/discovery/gcnp/GCNP.md)."""

from __future__ import annotations

import re
from pathlib import Path

from pair import must
from spoken import Spoken

ROOT = Path(__file__).resolve().parents[4]
VECTORS = ROOT / "tests/client/vectors"


def _rows(name: str) -> list[list[str]]:
    lines = (VECTORS / name).read_text(encoding="utf-8").splitlines()
    return [line.split("\t") for line in lines if line and not line.startswith("#")]


def identities(agent: Spoken) -> None:
    """identities"""
    for kind, value, representation, number in _rows("identities.tsv"):
        told = f"identity {kind} {value} {representation}".rstrip()
        said = agent.asked(told, "identity (.*)")[1]
        must(said == number, f"{told}: {said}, it is {number}")


def _shows(agent: Spoken, word: str, example: str) -> bool:
    """Whether the library shows such a thing."""
    return agent.asked(f"{word} {example}", f"{word}( .*)?")[0] != f"{word} unknown"


def frames(agent: Spoken) -> None:
    """frames of datagrams"""
    if not _shows(agent, "frame", "00"):
        return
    for row in _rows("frames.tsv"):
        *meaning, octets = row
        wanted = "frame refused" if meaning[0] == "refused" else "frame " + " ".join(meaning)
        said = agent.asked(f"frame {octets}".rstrip(), "frame( .*)?")[0]
        must(said.rstrip() == wanted.rstrip(), f"frame {octets}: {said!r}, it is {wanted!r}")


def _block(name: str) -> list[str]:
    text = (ROOT / "src/discovery/gcnp/GCNP.md").read_text(encoding="utf-8")
    found = re.search(rf"^```{name}\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert found is not None
    return found[1].splitlines()


def lines(agent: Spoken) -> None:
    """lines of GCNP, read and written again"""
    if not _shows(agent, "line", "5 pub"):
        return
    for line in _block("events"):
        said = agent.asked(f"line {line}", "line .*")[0]
        must(said == f"line {line}", f"{line}: {said}")
    for line, wanted in {
        "5  pub   remove ": "line 5 pub remove",
        '5 pub create note="a b" x=""': 'line 5 pub create note="a b" x=""',
        r'5 pub create note="tab\t \"q\" \\"': r'line 5 pub create note="tab\t \"q\" \\"',
        r"5 pub create note=a\b": r"line 5 pub create note=a\b",
        'pub create mode=oto id=7 port=5000': "line refused",
        "4294967296 pub remove": "line refused",
        "5 pub": "line refused",
        '5 pub create note="half': "line refused",
        '5 pub create note="a"b': "line refused",
        '5 pub create note=a"b': "line refused",
        r'5 pub create note="\x"': "line refused",
        "5 pub create =x": "line refused",
        "5 pub create a:b=x": "line refused",
        "5 pub create x=1 x=2": "line refused",
        "5 pub create " + " ".join(f"k{number}=1" for number in range(257)): "line refused",
    }.items():
        said = agent.asked(f"line {line}", "line .*")[0]
        must(said == wanted, f"{line[:80]}: {said[:80]}, it is {wanted}")


CHECKS = [identities, frames, lines]
