"""Frames of a channel (src/client/CHANNELS.md, "Frames")."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum
from typing import ClassVar

from .limits import MAX_DATAGRAM_PAYLOAD

HEADER = struct.Struct("!2sBBIQQ")
HEADER_OCTETS = 24
MAGIC = b"GC"


class Form(IntEnum):
    """The form of a frame."""

    PLAIN = 1
    ENCRYPTED = 2
    AUTHENTICATED = 3


class Kind(IntEnum):
    """The kind of a frame."""

    MESSAGE = 1
    HELLO = 2
    END = 3
    FLOOR = 4
    FULL = 5


class FrameError(ValueError):
    """Octets that are no frame."""


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame as it was read. `life` is not 0."""

    is_sealed: ClassVar[bool] = False

    kind: Kind
    life: int
    sequence: int
    payload: bytes


def write_frame(kind: Kind, life: int, sequence: int, payload: bytes = b"") -> bytes:
    """The octets of a frame. Requires that the payload is within its limit."""
    return HEADER.pack(MAGIC, Form.PLAIN, kind, len(payload), life, sequence) + payload


def read_header(octets: bytes | bytearray | memoryview, max_payload: int) -> tuple[Kind, int, int, int]:
    """Kind, length of the payload, life and sequence of the 24 octets at the beginning. Raises FrameError."""
    magic, form, kind, length, life, sequence = HEADER.unpack_from(octets)
    if form != Form.PLAIN:
        raise FrameError("this is no frame")
    check_header(magic, kind, length, life, max_payload)
    return Kind(kind), length, life, sequence


def check_header(magic: bytes, kind: int, length: int, life: int, max_payload: int) -> None:
    """Raises FrameError for what no form of a frame has."""
    if magic != MAGIC or not Kind.MESSAGE <= kind <= Kind.FULL:
        raise FrameError("this is no frame")
    if life == 0:
        raise FrameError("a frame without a life")
    if length > max_payload:
        raise FrameError("a frame that is too large")


def read_datagram(octets: bytes) -> Frame:
    """The one frame that a datagram is. Raises FrameError."""
    if len(octets) < HEADER_OCTETS:
        raise FrameError("this is no frame")
    kind, length, life, sequence = read_header(octets, MAX_DATAGRAM_PAYLOAD)
    if length != len(octets) - HEADER_OCTETS:
        raise FrameError("a frame whose length is not so")
    return Frame(kind, life, sequence, octets[HEADER_OCTETS:])
