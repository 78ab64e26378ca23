"""Frames of a channel (src/client/CHANNELS.md, "Frames")."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum

from .limits import MAX_DATAGRAM_PAYLOAD

HEADER = struct.Struct("!2sBBIQQ")
HEADER_OCTETS = 24
MAGIC = b"GC"
VERSION = 1


class Kind(IntEnum):
    """The kind of a frame."""

    MESSAGE = 1
    HELLO = 2
    END = 3


class FrameError(ValueError):
    """Octets that are no frame."""


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame as it was read. `life` is not 0."""

    kind: Kind
    life: int
    sequence: int
    payload: bytes


def write_frame(kind: Kind, life: int, sequence: int, payload: bytes = b"") -> bytes:
    """The octets of a frame. Requires that the payload is within its limit."""
    return HEADER.pack(MAGIC, VERSION, kind, len(payload), life, sequence) + payload


def read_header(octets: bytes | bytearray | memoryview, max_payload: int) -> tuple[Kind, int, int, int]:
    """Kind, length of the payload, life and sequence of the 24 octets at the beginning. Raises FrameError."""
    magic, version, kind, length, life, sequence = HEADER.unpack_from(octets)
    if magic != MAGIC or version != VERSION or not 1 <= kind <= 3:
        raise FrameError("this is no frame")
    if life == 0:
        raise FrameError("a frame without a life")
    if length > max_payload:
        raise FrameError("a frame that is too large")
    return Kind(kind), length, life, sequence


def read_datagram(octets: bytes) -> Frame:
    """The one frame that a datagram is. Raises FrameError."""
    if len(octets) < HEADER_OCTETS:
        raise FrameError("this is no frame")
    kind, length, life, sequence = read_header(octets, MAX_DATAGRAM_PAYLOAD)
    if length != len(octets) - HEADER_OCTETS:
        raise FrameError("a frame whose length is not so")
    return Frame(kind, life, sequence, octets[HEADER_OCTETS:])
