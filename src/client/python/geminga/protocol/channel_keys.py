"""The keys of one publisher's life, as the daemon's line `pub keys` gives them (src/client/CHANNELS.md, "Sealed channels")."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable

from .cipher import Cipher
from .frame import Form, Frame, Kind
from .life import read_life
from .sealed_frame import OpenedFrame, SealedFrame, open_sealed, seal
from .statement import Statement

MAX_KEYS_OF_A_RING = 64
#: The counter of a publisher ends here, and that of a consumer.
LAST_FORWARD = 2**64 - 1
LAST_BACK = 2**32 - 1

_KEY = re.compile(r"([0-9a-f]{4}):([0-9a-f]{64}):([0-9a-f]{64})")
_FORWARD_NONCE = struct.Struct("!4xQ")
_BACK_NONCE = struct.Struct("!QI")

#: What a host of each mode sends, and whether it takes plain frames.
_MODES = {
    "plain": (Form.PLAIN, True),
    "prepared": (Form.PLAIN, True),
    "mixed": (Form.ENCRYPTED, True),
    "authenticated": (Form.AUTHENTICATED, False),
    "encrypted": (Form.ENCRYPTED, False),
}


def mode_takes_plain(mode: str) -> bool:
    """Whether a host of this mode takes plain frames; no host of an unknown mode does."""
    return mode in _MODES and _MODES[mode][1]


class KeysError(ValueError):
    """The daemon's line about keys cannot be read. The text has none of it."""


class ChannelKeys:
    """The mode of this host and the ring of one life. It shows no key. Not thread-safe, and never changed."""

    __slots__ = ("mode", "form", "takes_plain", "_ring", "_first")

    def __init__(self, mode: str, ring: Iterable[tuple[int, bytes, bytes]] = ()) -> None:
        """Keys with their ids, the forward ones and the back ones. Raises SealingMissing, and KeysError for an unknown mode."""
        if mode not in _MODES:
            raise KeysError("the daemon names a mode of sealing that this library does not know")
        self.mode = mode
        self.form, self.takes_plain = _MODES[mode]
        self._ring = {key: (Cipher(forward), Cipher(back)) for key, forward, back in ring}
        self._first = next(iter(self._ring), 0)
        if not self._ring and mode != "plain":
            raise KeysError("the daemon gives no keys for a sealed channel")

    def __repr__(self) -> str:
        return f"ChannelKeys({self.mode!r}, {len(self._ring)} keys)"

    @property
    def has_ring(self) -> bool:
        """Whether sealed frames can be opened."""
        return bool(self._ring)

    @property
    def seals(self) -> bool:
        """Whether frames are sent sealed."""
        return self.form is not Form.PLAIN

    def seal_forward(self, kind: Kind, life: int, sequence: int, counter: int, payload: bytes, port: int = 0) -> tuple[bytes, bytes]:
        """The header of a publisher's frame, and what follows it. Requires that this mode seals."""
        cipher = self._ring[self._first][0]
        return seal(cipher, _FORWARD_NONCE.pack(counter), self.form, kind, life, sequence, self._first, port, counter, payload)

    def seal_back(self, kind: Kind, life: int, counter: int, payload: bytes) -> bytes:
        """A consumer's frame. Requires that this mode seals."""
        cipher = self._ring[self._first][1]
        header, rest = seal(cipher, _BACK_NONCE.pack(life, counter), self.form, kind, life, 0, self._first, 0, counter, payload)
        return header + rest

    def open_forward(self, frame: SealedFrame) -> OpenedFrame | None:
        """A publisher's frame, or None if it cannot be opened."""
        ciphers = self._ring.get(frame.key)
        return None if ciphers is None else open_sealed(ciphers[0], _FORWARD_NONCE.pack(frame.counter), frame)

    def open_back(self, frame: SealedFrame) -> OpenedFrame | None:
        """A consumer's frame, or None if it cannot be opened."""
        ciphers = self._ring.get(frame.key)
        if ciphers is None or frame.counter > LAST_BACK:
            return None
        return open_sealed(ciphers[1], _BACK_NONCE.pack(frame.life, frame.counter), frame)

    def take(self, frame: Frame | SealedFrame, *, is_back: bool) -> Frame | None:
        """A frame as this mode takes it, opened; None if it does not."""
        if isinstance(frame, SealedFrame):
            return self.open_back(frame) if is_back else self.open_forward(frame)
        return frame if self.takes_plain else None


#: The keys of a channel that has none.
PLAIN = ChannelKeys("plain")


def read_channel_keys(line: Statement) -> tuple[int, ChannelKeys]:
    """The life and the keys of a line `pub keys`. Raises KeysError and SealingMissing."""
    life = read_life(line.get("life"))
    if life == 0:
        raise KeysError("the daemon gives keys for no life")
    words = line.get("ring").split(",") if line.get("ring") else []
    if len(words) > MAX_KEYS_OF_A_RING:
        raise KeysError(f"the daemon gives more than {MAX_KEYS_OF_A_RING} keys for a channel")
    ring = []
    for word in words:
        found = _KEY.fullmatch(word)
        if found is None:
            raise KeysError("the daemon gives a key that cannot be read")
        ring.append((int(found[1], 16), bytes.fromhex(found[2]), bytes.fromhex(found[3])))
    return life, ChannelKeys(line.get("mode"), ring)
