"""The handshake of a consumer with a publisher, and the cookies that nobody keeps (src/client/CHANNELS.md, "The handshake")."""

from __future__ import annotations

import hmac
import secrets
import struct
from collections.abc import Callable
from typing import NamedTuple

from .limits import COOKIE_SECONDS, MAX_ANSWERS

PAYLOAD = struct.Struct("!QQQ")


class Handshake(NamedTuple):
    """The payload of a hello, a floor, a full, or the end of a listener. `life` is that of the other side."""

    life: int
    challenge: int
    cookie: int

    def write(self) -> bytes:
        """Its 24 octets."""
        return PAYLOAD.pack(*self)


def read_handshake(payload: bytes) -> Handshake | None:
    """The handshake that a payload is, or None if it has another size."""
    return Handshake(*PAYLOAD.unpack(payload)) if len(payload) == PAYLOAD.size else None


class Cookies:
    """The cookies of one publisher. Times are seconds of a monotonic clock."""

    def __init__(self, secret: bytes = b"") -> None:
        self._secret = secret or secrets.token_bytes(32)

    def cookie(self, source: tuple[str, int], life: int, challenge: int, now: float) -> int:
        """The cookie for a hello of this life from this address and port; never 0."""
        return self._of(source, life, challenge, int(now // COOKIE_SECONDS))

    def are_right(self, source: tuple[str, int], life: int, challenge: int, cookie: int, now: float) -> bool:
        """Whether a cookie is that of the present 8 s, or of the 8 s before."""
        period = int(now // COOKIE_SECONDS)
        return cookie != 0 and cookie in (self._of(source, life, challenge, one) for one in (period, period - 1))

    def _of(self, source: tuple[str, int], life: int, challenge: int, period: int) -> int:
        said = f"{source[0]} {source[1]} {life} {challenge} {period}".encode()
        return int.from_bytes(hmac.digest(self._secret, said, "sha256")[:8], "big") or 1


class Allowance:
    """The answers to datagrams that a publisher may give: 512 at once, and 512 a second."""

    def __init__(self, now: Callable[[], float], most: int = MAX_ANSWERS) -> None:
        self._now = now
        self._most = most
        self._left = float(most)
        self._at = now()

    def take(self, keeps_half: bool = False) -> bool:
        """Whether there is one more; with `keeps_half`, whether there is one without the half that is kept for others."""
        now = self._now()
        self._left = min(self._most, self._left + (now - self._at) * self._most)
        self._at = now
        if self._left < 1 + (self._most // 2 if keeps_half else 0):
            return False
        self._left -= 1
        return True
