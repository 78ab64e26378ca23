"""What a publisher sends through, whatever its mode and protocol."""

from __future__ import annotations

from collections.abc import Callable, Sized
from typing import Protocol

from ..protocol.counterparts import Counterpart
from .sockets import Address

#: Payloads up to here are copied behind their header: one piece costs less than two, unless it is large.
COPIED_OCTETS = 16 * 1024
#: A call that sends a frame, and where to.
Sole = tuple[Callable[[bytes, Address], int], Address]


class Outlet(Protocol):
    """Belongs to an event loop; not thread-safe."""

    @property
    def targets(self) -> Sized:
        """Whoever is sent to; empty where sending reaches nobody."""

    @property
    def sole(self) -> Sole | None:
        """What to call instead of send() for a frame with a payload of up to COPIED_OCTETS, where there is one target that takes frames
        as datagrams: that is what most sending is, and a call less."""

    @property
    def port(self) -> int:
        """Where it can be reached."""

    @property
    def dropped(self) -> int:
        """What came in and was not believed."""

    def open(self, counterpart: Counterpart) -> None:
        """A consumer came, or its address or port changed."""

    def close(self, counterpart: Counterpart) -> None:
        """A consumer went."""

    def send(self, header: bytes, payload: bytes) -> int:
        """Sends a message to all, and says for how many it was left out."""

    async def drain(self) -> None:
        """Waits until there is room for more."""

    async def end(self, last: int) -> None:
        """Sends what waits and takes leave behind the message with this sequence, then closes all."""

    def abort(self) -> None:
        """Closes all at once."""
