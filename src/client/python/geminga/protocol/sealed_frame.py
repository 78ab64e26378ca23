"""Sealed frames: those of the forms 2 and 3 (src/client/CHANNELS.md, "Sealed channels")."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import ClassVar

from .cipher import TAG_OCTETS, Cipher
from .frame import HEADER_OCTETS, MAGIC, Form, Frame, FrameError, Kind, check_header, read_datagram
from .limits import MAX_DATAGRAM_PAYLOAD

SEALED_HEADER = struct.Struct("!2sBBIQQHHQ")
SEALED_HEADER_OCTETS = 36

_FORM_AT = 2


@dataclass(frozen=True, slots=True)
class SealedFrame:
    """A sealed frame that has not been opened. `octets` are all of it, `key` is the id of its key."""

    form: Form
    kind: Kind
    life: int
    sequence: int
    key: int
    port: int  #: where a publisher takes hellos, or 0
    counter: int
    octets: bytes

    @property
    def payload(self) -> bytes:
        """The payload as it was sent, behind which there is a tag."""
        return self.octets[SEALED_HEADER_OCTETS:-TAG_OCTETS]


@dataclass(frozen=True, slots=True)
class OpenedFrame(Frame):
    """A frame that a holder of the key has sealed."""

    is_sealed: ClassVar[bool] = True

    port: int = 0
    counter: int = 0


AnyFrame = Frame | SealedFrame


def is_sealed(octets: bytes | bytearray | memoryview) -> bool:
    """Whether octets, at least 24 of them, begin as a sealed frame does."""
    return octets[_FORM_AT] in (Form.ENCRYPTED, Form.AUTHENTICATED)


def sealed_length(header: bytes | bytearray | memoryview, max_payload: int) -> int:
    """The length that follows the 36 octets of the header. Raises FrameError."""
    magic, _, kind, length, life, _, _, _, _ = SEALED_HEADER.unpack_from(header)
    check_header(magic, kind, length, life, max_payload + TAG_OCTETS)
    if length < TAG_OCTETS:
        raise FrameError("a sealed frame without a tag")
    return int(length)


def read_whole(octets: bytes) -> SealedFrame:
    """The sealed frame that these octets are; its header has been checked."""
    _, form, kind, _, life, sequence, key, port, counter = SEALED_HEADER.unpack_from(octets)
    return SealedFrame(Form(form), Kind(kind), life, sequence, key, port, counter, octets)


def read_any_datagram(octets: bytes) -> AnyFrame:
    """The one frame of any form that a datagram is. Raises FrameError."""
    if len(octets) < HEADER_OCTETS or not is_sealed(octets):
        return read_datagram(octets)
    if len(octets) < SEALED_HEADER_OCTETS:
        raise FrameError("this is no frame")
    if sealed_length(octets, MAX_DATAGRAM_PAYLOAD) != len(octets) - SEALED_HEADER_OCTETS:
        raise FrameError("a frame whose length is not so")
    return read_whole(octets)


def seal(
    cipher: Cipher, nonce: bytes, form: Form, kind: Kind, life: int, sequence: int, key: int, port: int, counter: int, payload: bytes
) -> tuple[bytes, bytes]:
    """The header of a sealed frame, and what follows it."""
    header = SEALED_HEADER.pack(MAGIC, form, kind, len(payload) + TAG_OCTETS, life, sequence, key, port, counter)
    if form is Form.ENCRYPTED:
        return header, cipher.seal(nonce, payload, header)
    return header, payload + cipher.seal(nonce, b"", header + payload)


def open_sealed(cipher: Cipher, nonce: bytes, frame: SealedFrame) -> OpenedFrame | None:
    """The frame, or None if it cannot be opened by this key."""
    octets = frame.octets
    if frame.form is Form.ENCRYPTED:
        payload = cipher.open(nonce, octets[SEALED_HEADER_OCTETS:], octets[:SEALED_HEADER_OCTETS])
    else:
        tag_at = len(octets) - TAG_OCTETS
        shown = cipher.open(nonce, octets[tag_at:], octets[:tag_at])
        payload = None if shown is None else octets[SEALED_HEADER_OCTETS:tag_at]
    if payload is None:
        return None
    return OpenedFrame(frame.kind, frame.life, frame.sequence, payload, frame.port, frame.counter)
