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
from .errors import Closed, GemingaError, MessageTooLarge
from .parameters import octets_of
from .protocol.channel_keys import PLAIN, ChannelKeys
from .protocol.counter import CounterError, ForkError, Process
from .protocol.counterparts import Change, Counterpart, Counterparts, Key
from .protocol.frame import HEADER, MAGIC, Form, Kind
from .protocol.frame_writer import PublisherFrames
from .protocol.limits import MAX_DATAGRAM_PAYLOAD, MAX_STREAM_PAYLOAD
from .protocol.match import Match
from .protocol.request import Request
from .request_owner import Host, RequestOwner

Octets = bytes | bytearray | memoryview

#: The attribute by which a publisher states how many places it has, while all of them are taken.
FULL_KEY = "channel.full"

_pack = HEADER.pack
_MESSAGE = int(Kind.MESSAGE)
_PLAIN = int(Form.PLAIN)


class PublisherHost(Host, Protocol):
    """The part of a node that a publisher uses."""

    def tell_consumer(self, publisher: Publisher, change: str, consumer: Match, reason: str) -> None:
        """Tells the application what became of a consumer."""


class Publisher(RequestOwner):
    """Made by Node.publish(). Belongs to the event loop of its node; not thread-safe."""

    def __init__(self, node: PublisherHost, said: dict[str, str]) -> None:
        protocol = said.setdefault("protocol", "udp")
        super().__init__(node, Counterparts(protocol))
        self._node: PublisherHost = node
        self._is_stream = said["mode"] == "otm/stream"
        self._is_tcp = protocol == "tcp"
        self._joined: set[Key] = set()  # the consumers that the application was told of
        self._process = Process.number
        self._sequence = 0
        self._left_out = 0
        self._changing: asyncio.Task[None] | None = None  # kept, so that it is not collected
        self._frames = PublisherFrames(self._life, lambda: self._sequence, PLAIN if node.has_keys is False else None)
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
        return [one.match for one in self._counterparts if one.key in self._joined]

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

        A payload is bytes, bytearray or memoryview; TypeError for others, of which a text is to be encoded. Over TCP a consumer for
        which more than 4 MiB wait is left out; drain() waits for room. Raises MessageTooLarge over 65 000 octets for UDP and over
        16 MiB for TCP, and Closed.
        """
        if type(payload) is not bytes:
            payload = octets_of(payload)  # The application may change its own object.
        size = len(payload)
        if size > self._max_payload:
            self._refuse(size)
        if Process.number != self._process:
            raise GemingaError(str(ForkError()))
        outlet = self._outlet
        sole = outlet.sole
        if sole is not None and size <= COPIED_OCTETS:
            self._sequence = sequence = self._sequence + 1
            sendto, there = sole
            try:
                sendto(_pack(MAGIC, _PLAIN, _MESSAGE, size, self._life, sequence) + payload, there)
            except OSError:
                self._left_out += 1
            return True
        if not outlet.targets:
            if self._is_closed:
                raise Closed("the publisher has been closed")
            return False
        try:
            header, body = self._frames.message(self._sequence + 1, payload)
        except CounterError as error:
            self.abort()
            raise Closed(str(error)) from None
        self._sequence += 1
        self._left_out += outlet.send(header, body, payload)
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
            if Process.number == self._process:
                await self._outlet.end()
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

    # Calls of the node

    def keyed(self, life: int, keys: ChannelKeys | None, text: str) -> None:
        """The daemon has said which keys this publisher has."""
        if life != self._life:
            return
        if keys is None:
            self.problem_once(text)
        self._rekey(keys)

    def daemon_back(self, has_keys: bool) -> None:
        """The daemon is back. Without keys the channel is plain."""
        if not has_keys:
            self._rekey(PLAIN)
        super().daemon_back(has_keys)

    def mode_changed(self) -> None:
        """The daemon has said how this host seals, which counts for channels that have no line of keys."""
        if self._node.has_keys is False and self._frames.keys is None:
            self._rekey(PLAIN)

    # Calls of the outlet

    def joined(self, life: int) -> None:
        """A message reaches the consumer with this life from now on."""
        counterpart = self._counterparts.get(life)
        if counterpart is not None:
            self._counterparts.connected(life)
            if life not in self._joined:
                self._joined.add(life)
                self._tell("added", counterpart, "")

    def left(self, life: int, reason: str) -> None:
        """The connection of a consumer has ended."""
        counterpart = self._counterparts.get(life)
        if counterpart is None:
            return
        changes = self._counterparts.disconnected(life)
        if changes:
            self._apply(changes)
        elif life in self._joined:
            self._joined.discard(life)
            self._tell("removed", counterpart, reason)

    def no_place(self, what: str, count: int) -> None:
        """A newcomer found all places taken: tells it once, and states it."""
        if not self._has_no_places:
            self._state_full(count)
        super().no_place(what, count)

    def places_again(self) -> None:
        """Enough places are free again."""
        if self._has_no_places:
            self._state_full(0)
        super().places_again()

    def moved(self, port: int) -> None:
        """States another port, because the old one was taken while there was no consumer."""
        self._restate({"port": str(port)})

    # Inside

    def _make_outlet(self, mode: str, port: int, address: str) -> Outlet:
        if self._is_tcp:
            return TcpOutlet(self._loop, self._frames, port, address, self._is_stream, self)
        if not self._is_stream:
            return UdpOutlet(self._loop, self._frames, port, address, mode == "otm/pubsub", self)
        if sockets.is_multicast(address):
            return MulticastOutlet(self._loop, self._frames, port, address)
        return ListenersOutlet(self._loop, self._frames, port, address, self)

    def _refuse(self, octets: int) -> None:
        hint = "" if self._is_tcp else ": offer the service with protocol=tcp"
        raise MessageTooLarge(f"a message of {octets} octets; at most {self._max_payload} fit{hint}")

    def _rekey(self, keys: ChannelKeys | None) -> None:
        if self._frames.keys is keys or self._is_closed:
            return
        was_sealing, self._frames.keys = self._frames.seals, keys
        self._outlet.rekeyed(self._frames.seals and not was_sealing)
        for counterpart in self._counterparts:
            self._greet(counterpart)

    def _change(self, change: Change) -> None:
        counterpart = change.counterpart
        if change.kind == "removed":
            self._outlet.close(counterpart)
            if counterpart.key in self._joined:
                self._joined.discard(counterpart.key)
                self._tell(change.kind, counterpart, change.reason)
            return
        self._outlet.open(counterpart)
        if change.kind == "modified" and counterpart.key in self._joined:
            self._tell(change.kind, counterpart, "")
        else:
            self._greet(counterpart)

    def _greet(self, counterpart: Counterpart) -> None:
        """Tells of a consumer over UDP that messages reach without a hello."""
        keys = self._frames.keys
        if self._is_tcp or self._is_stream or keys is None or counterpart.key in self._joined:
            return
        match = counterpart.match
        if match.life == 0 and not keys.takes_plain:
            self.problem_once(f"{match.word} states no life, so its channel cannot be sealed")
        elif match.life == 0 or not keys.seals:
            self._joined.add(counterpart.key)
            self._tell("added", counterpart, "")

    def _tell(self, kind: str, counterpart: Counterpart, reason: str) -> None:
        self._node.tell_consumer(self, kind, counterpart.match, reason)

    def _state_full(self, count: int) -> None:
        self._restate({FULL_KEY: str(count)})

    def _restate(self, changes: dict[str, str]) -> None:
        """Changes the request. An error of the daemon is told, because there is no call that it answers."""
        if self._request is not None and not self._is_closed:
            self._changing = self._loop.create_task(self._changed(self._request, changes))

    async def _changed(self, request: Request, changes: dict[str, str]) -> None:
        try:
            await self._node.modify(request, changes)
        except GemingaError as error:
            self.problem(str(error))
