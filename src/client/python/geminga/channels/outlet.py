"""The outlet of a publisher, whatever its mode and protocol."""

from __future__ import annotations

from collections.abc import Callable, Sized
from typing import Protocol

from ..protocol.counterparts import Counterpart
from .sockets import Address

#: Payloads up to this size are copied behind their header, because one small piece costs less than two.
COPIED_OCTETS = 16 * 1024
#: A function that sends a frame, and the address to send to.
Sole = tuple[Callable[[bytes, Address], int], Address]


class OutletHost(Protocol):
    """The part of a publisher that its outlet tells of what happens."""

    def joined(self, life: int) -> None:
        """A message reaches the consumer with this life from now on."""

    def left(self, life: int, reason: str) -> None:
        """The connection of a consumer has ended."""

    def no_place(self, what: str, count: int) -> None:
        """A newcomer found all places taken."""

    def places_again(self) -> None:
        """Enough places are free again."""

    def moved(self, port: int) -> None:
        """The port had to change."""

    def problem(self, text: str) -> None:
        """Something that the application should know."""


class Outlet(Protocol):
    """The sockets of a publisher. Belongs to an event loop; not thread-safe."""

    @property
    def targets(self) -> Sized:
        """The consumers that are sent to; empty if there are none."""

    @property
    def sole(self) -> Sole | None:
        """The function to call instead of send() for payloads up to COPIED_OCTETS, if there is one target that takes plain frames as
        datagrams.

        Most messages are sent so, and it saves a call.
        """

    @property
    def port(self) -> int:
        """The port where it can be reached."""

    @property
    def dropped(self) -> int:
        """The number of datagrams and connections that were not believed."""

    def open(self, counterpart: Counterpart) -> None:
        """A consumer was added, or its address or port changed."""

    def close(self, counterpart: Counterpart) -> None:
        """A consumer is gone."""

    def rekeyed(self, begins_to_seal: bool = False) -> None:
        """The daemon has said which keys there are, or other ones."""

    def send(self, header: bytes, body: bytes, payload: bytes) -> int:
        """Sends a message to all consumers: its frame, or its payload alone. Returns for how many it was left out."""

    async def drain(self) -> None:
        """Waits until there is room for more."""

    async def end(self) -> None:
        """Sends what waits and the end after the last message, and closes."""

    def abort(self) -> None:
        """Closes at once."""
