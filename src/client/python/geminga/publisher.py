"""A publisher: a service with a channel, which sends to its consumers."""

from __future__ import annotations

import asyncio
from types import TracebackType
from typing import Protocol

from .channels import sockets
from .channels.listeners_outlet import ListenersOutlet
from .channels.multicast_outlet import MulticastOutlet
from .channels.outlet import COPIED_OCTETS, Outlet
from .channels.tcp_outlet import TcpOutlet
from .channels.udp_outlet import UdpOutlet
from .errors import Closed, MessageTooLarge
from .protocol.counterparts import LOST, Change, Counterpart, Counterparts
from .protocol.frame import HEADER, MAGIC, VERSION, Kind
from .protocol.limits import MAX_DATAGRAM_PAYLOAD, MAX_STREAM_PAYLOAD
from .protocol.match import Match
from .request_owner import Host, RequestOwner

Octets = bytes | bytearray | memoryview

_pack = HEADER.pack
_MESSAGE = int(Kind.MESSAGE)


class PublisherHost(Host, Protocol):
    """The part of a node that a publisher uses."""

    def tell_consumer(self, publisher: Publisher, change: str, consumer: Match, reason: str) -> None:
        """Tells the application what became of a consumer."""


class Publisher(RequestOwner):
    """Made by Node.publish(). Belongs to the event loop of its node; not thread-safe."""

    def __init__(self, node: PublisherHost, said: dict[str, str]) -> None:
        protocol = said.setdefault("protocol", "udp")
        if protocol not in ("udp", "tcp"):
            raise ValueError("protocol is udp or tcp")
        super().__init__(node, Counterparts(protocol))
        self._node: PublisherHost = node
        self._is_stream = said["mode"] == "otm/stream"
        self._is_tcp = protocol == "tcp"
        self._joined: set[int] = set()
        self._sequence = 0
        self._left_out = 0
        self._max_payload = MAX_STREAM_PAYLOAD if protocol == "tcp" else MAX_DATAGRAM_PAYLOAD
        self._outlet = self._make_outlet(said["mode"], int(said.get("port", "0")), said.get("address", ""))
        said["port"] = str(self._outlet.port)
        try:
            self.state("pub", said)
        except BaseException:
            self._outlet.abort()
            raise

    @property
    def port(self) -> int:
        """The announced port, where it can be reached."""
        return self._outlet.port

    @property
    def consumers(self) -> list[Match]:
        """The consumers that the daemon has named; none for `otm/stream`."""
        return [one.match for one in self._counterparts if not self._is_tcp or one.match.life in self._joined]

    @property
    def has_consumers(self) -> bool:
        """Whether there is a consumer. Always true for multicast."""
        return bool(self._outlet.targets)

    @property
    def sent(self) -> int:
        """The messages that were sent while there was a consumer."""
        return self._sequence

    @property
    def left_out(self) -> int:
        """The messages that were left out for a consumer without room, counted for each consumer."""
        return self._left_out

    @property
    def dropped(self) -> int:
        """The datagrams and connections that were not believed."""
        return self._outlet.dropped

    def send(self, payload: Octets) -> bool:
        """Sends to all consumers, and never waits. Whether there are any.

        Over TCP a consumer for which more than 4 MiB wait is left out; drain() waits for room. Raises MessageTooLarge over
        65 000 octets for UDP and over 16 MiB for TCP, and Closed.
        """
        size = len(payload)
        if size > self._max_payload:
            self._refuse(size)
        if type(payload) is not bytes:
            payload = bytes(payload)  # The application may change its own object.
        outlet = self._outlet
        sole = outlet.sole
        if sole is not None and size <= COPIED_OCTETS:
            self._sequence = sequence = self._sequence + 1
            sendto, there = sole
            try:
                sendto(_pack(MAGIC, VERSION, _MESSAGE, size, self._life, sequence) + payload, there)
            except OSError:
                self._left_out += 1
            return True
        if not outlet.targets:
            if self._is_closed:
                raise Closed("the publisher has been closed")
            return False
        self._sequence = sequence = self._sequence + 1
        self._left_out += outlet.send(_pack(MAGIC, VERSION, _MESSAGE, size, self._life, sequence), payload)
        return True

    async def drain(self) -> None:
        """Waits until the system has taken all messages to TCP consumers. Over UDP it lets the event loop turn once."""
        await self._outlet.drain()

    async def close(self) -> None:
        """Withdraws the service. Over TCP it waits until consumers have all messages, 5 s for one that takes nothing."""
        if self._is_closed:
            return
        try:
            if self._is_tcp:  # Frames that wait may take long.
                self._leave()
            await self._outlet.end(self._sequence)
        finally:
            self.abort()

    def abort(self) -> None:
        """Withdraws the service and closes its sockets at once."""
        if not self._is_closed:
            self._leave()
        self._outlet.abort()

    async def __aenter__(self) -> Publisher:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    # Inside

    def _make_outlet(self, mode: str, port: int, address: str) -> Outlet:
        if self._is_tcp:
            return TcpOutlet(self._loop, self._life, port, address, self._is_stream, self._join, self._part)
        if not self._is_stream:
            return UdpOutlet(self._life, port, address, mode == "otm/pubsub", self._move)
        if sockets.is_multicast(address):
            return MulticastOutlet(self._loop, self._life, port, address)
        return ListenersOutlet(self._loop, self._life, port, address)

    def _refuse(self, octets: int) -> None:
        hint = "" if self._is_tcp else ": offer the service with protocol=tcp"
        raise MessageTooLarge(f"a message of {octets} octets; at most {self._max_payload} fit{hint}")

    def _change(self, change: Change) -> None:
        counterpart = change.counterpart
        if change.kind != "removed":
            self._outlet.open(counterpart)
        else:
            self._outlet.close(counterpart)
        if not self._is_tcp:
            self._tell(change.kind, counterpart, change.reason)
        elif change.kind == "modified":
            if counterpart.key in self._joined:
                self._tell(change.kind, counterpart, "")
        elif change.kind == "removed" and counterpart.match.life in self._joined:
            self._joined.discard(counterpart.match.life)
            self._tell(change.kind, counterpart, change.reason)

    def _join(self, life: int) -> None:
        counterpart = self._counterparts.get(life)
        if counterpart is not None:
            self._joined.add(life)
            self._counterparts.connected(life)
            self._tell("added", counterpart, "")

    def _part(self, life: int) -> None:
        """The connection of a consumer has ended."""
        counterpart = self._counterparts.get(life)
        if counterpart is None:
            return
        changes = self._counterparts.disconnected(life)
        if changes:
            self._apply(changes)
        elif life in self._joined:
            self._joined.discard(life)
            self._tell("removed", counterpart, LOST)

    def _tell(self, kind: str, counterpart: Counterpart, reason: str) -> None:
        self._node.tell_consumer(self, kind, counterpart.match, reason)

    def _move(self, port: int) -> None:
        """States another port, because the old one was taken while there was no consumer."""
        request = self._request
        if request is not None:
            self._loop.create_task(self._node.modify(request, {"port": str(port)}))
