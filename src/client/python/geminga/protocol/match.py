"""The daemon's words on a counterpart: a service that suits a request, or a consumer that suits a publication."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

from .life import KEY, read_life
from .reserved import attribute_of
from .statement import Statement

_NAME = re.compile(r"<[^<>]*>|[^<>]+")  # names are separated by ">"


@dataclass(frozen=True, slots=True)
class Match:
    """A provider of a subscriber, or a consumer of a publisher. A value that is not stated is empty, 0 or None."""

    word: str  #: PARTICIPANT/PEER/NUMBER
    life: int  #: of its channel; 0 if it has none
    name: str
    participant_name: str
    address: str
    port: int
    protocol: str
    mode: str
    degree: str
    distance: int
    priority: int
    id: int | None
    text: str | None
    concept: str | None
    representation: str | None
    convert: tuple[str, ...] = ()  #: the representations from the offered one to the requested one
    cost: int = 0
    via: str = ""  #: the service of each conversion, with commas: `udp://ADDRESS:PORT/SERVICE`, or `-` for the consumer
    attributes: dict[str, str] = field(default_factory=dict)
    hops: int = 0  #: relays on the way to its host; 0: it is heard directly
    path: str = ""  #: the names of those that are known, joined by `/`, the nearest to its host first
    reachable: bool = True  #: false: its address cannot be reached from this host, as far as that is certain


def _number(text: str, least: int, most: int) -> int:
    digits = text[1:] if text.startswith("-") else text
    if not digits.isascii() or not digits.isdigit() or len(digits) > 10:
        return 0
    return int(text) if least <= int(text) <= most else 0


def read_match(line: Statement) -> Match:
    """Reads `pub add`, `pub modify`, `sub add` or `sub modify`. A value that cannot be read counts as not stated."""
    convert = tuple(_NAME.findall(line.get("convert")))
    hops = _number(line.get("hops"), 0, 0xFFFFFFFF)
    attributes = {}
    for key, value in line.parameters.items():
        is_key = (convert and key in ("cost", "via")) or (hops and key == "path")
        name = None if is_key else attribute_of(key)
        if name is not None:
            attributes[name] = value or ""
    return Match(
        word=line.get("service" if line.command == "pub" else "subscription"),
        life=read_life(attributes.get(KEY, "")),
        name=line.get("name"),
        participant_name=line.get("participant_name"),
        address=line.get("address"),
        port=_number(line.get("port"), 1, 65535),
        protocol=line.get("protocol") or "udp",
        mode=line.get("mode"),
        degree=line.get("degree"),
        distance=_number(line.get("distance"), 0, 0xFFFFFFFF),
        priority=_number(line.get("priority"), -(2**31), 2**31 - 1),
        id=_number(line.get("id"), 0, 0xFFFFFFFF) if "id" in line.parameters else None,
        text=line.parameters.get("text"),
        concept=line.parameters.get("concept"),
        representation=line.parameters.get("representation"),
        convert=convert,
        cost=_number(line.get("cost"), 0, 0xFFFFFFFF) if convert else 0,
        via=line.get("via") if convert else "",
        attributes=attributes,
        hops=hops,
        path=line.get("path") if hops else "",
        reachable=line.get("reachable") != "no",
    )
