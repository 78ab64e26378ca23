"""A subscriber: a request for services with a channel, which receives from its providers."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Mapping
from types import TracebackType
from typing import Protocol

from .channels import sockets
from .channels.multicast_inlet import MulticastInlet
from .channels.tcp_inlet import TcpInlet
from .channels.udp_inlet import UdpInlet
from .errors import Closed
from .protocol.converter import Conversion, ConversionError, convert
from .protocol.counterparts import WITHDRAWN, Change, Counterpart, Counterparts, Key
from .protocol.frame import Frame, Kind
from .protocol.inbox import Inbox, Message
from .protocol.limits import MAX_WAITING_MESSAGES
from .protocol.match import Match
from .protocol.sequence import Sequence
from .request_owner import Host, RequestOwner


class SubscriberHost(Host, Protocol):
    """The part of a node that a subscriber uses."""

    def tell_provider(self, subscriber: Subscriber, change: str, provider: Match, reason: str) -> None:
        """Tells the application what became of a provider."""


class Subscriber(RequestOwner):
    """Made by Node.subscribe(). Belongs to the event loop of its node; not thread-safe.

    An inbox holds `queue` messages and 16 MiB, but always one. When it is full, TCP providers are not read, and of UDP the oldest message
    is lost for a new one, or the new one with `keep="oldest"`. The next message says in `missed` how many were lost.
    """

    def __init__(
        self,
        node: SubscriberHost,
        said: dict[str, str],
        conversions: Mapping[str, Conversion] | None = None,
        queue: int = MAX_WAITING_MESSAGES,
        keep: str = "newest",
    ) -> None:
        if keep not in ("newest", "oldest"):
            raise ValueError("keep is newest or oldest")
        limit = int(said.get("limit", "1" if said["mode"] == "oto" else "0"))
        super().__init__(node, Counterparts(limit=limit))
        self._node: SubscriberHost = node
        self._conversions = dict(conversions or {})
        self._inbox = Inbox(queue, keep == "newest")
        self._sequence = Sequence()
        self._waiters: deque[asyncio.Future[None]] = deque()
        self._tcp: dict[Key, TcpInlet] = {}
        self._resting: dict[Key, tuple[TcpInlet, Change]] = {}
        self._multicast = MulticastInlet(self._loop, self._hear, self._hear_datagram, self._end, self._drop)
        self._udp: UdpInlet | None = None
        self._is_paused = False
        self._complained: set[tuple[Key, str]] = set()
        self._received = self._missed = self._dropped = 0
        protocols = said.setdefault("protocol", "udp,tcp").split(",")
        if "udp" in protocols:
            is_stream = said["mode"] == "otm/stream"
            self._udp = UdpInlet(
                self._loop,
                self._life,
                int(said.get("port", "0")),
                is_stream,
                self._hear,
                self._hear_datagram,
                self._end,
                self._drop,
                self._find,
            )
            said["port"] = str(self._udp.port)
        try:
            self.state("sub", said)
        except BaseException:
            self._close_all()
            raise

    @property
    def providers(self) -> list[Match]:
        """The providers that are matched."""
        return self._matches()

    @property
    def received(self) -> int:
        """The messages that were received or wait for that."""
        return self._received

    @property
    def missed(self) -> int:
        """The messages that are known to be missing, those lost in a full queue with them."""
        return self._missed

    @property
    def dropped(self) -> int:
        """The datagrams and frames that were not believed or could not be converted."""
        return self._dropped

    async def receive(self) -> Message:
        """The next message. Raises Closed when the subscriber is closed and none is left. No message is lost if it is cancelled."""
        while not len(self._inbox):
            if self._is_closed:
                raise Closed("the subscriber has been closed")
            waiter: asyncio.Future[None] = self._loop.create_future()
            self._waiters.append(waiter)
            try:
                await waiter
            except asyncio.CancelledError:
                # A waiter that was woken and cancelled wakes the next one.
                if waiter.done() and not waiter.cancelled():
                    self._wake()
                raise
        return self._take()

    def receive_now(self) -> Message | None:
        """The next message that is here already, or None."""
        return self._take() if len(self._inbox) else None

    def __aiter__(self) -> Subscriber:
        return self

    async def __anext__(self) -> Message:
        try:
            return await self.receive()
        except Closed:
            raise StopAsyncIteration from None

    async def close(self) -> None:
        """Withdraws the request. Messages that have come can still be received."""
        self.abort()

    def abort(self) -> None:
        """Withdraws the request at once."""
        if not self._is_closed:
            self._leave()
        self._close_all()
        while self._waiters:
            self._wake()

    async def __aenter__(self) -> Subscriber:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    # Inside: providers

    def _change(self, change: Change) -> None:
        counterpart = change.counterpart
        if change.kind == "removed":
            self._removed(change)
            return
        if counterpart.match.life == 0 and counterpart.match.protocol == "tcp":
            if change.kind == "added":
                self.problem(f"{counterpart.match.word} is offered over TCP without a channel: it is not connected")
        else:
            self._open(counterpart)
        self._tell(change)
        if self._udp is not None:
            self._udp.deliver_early(counterpart)

    def _open_udp(self, counterpart: Counterpart) -> None:
        match = counterpart.match
        if not sockets.is_multicast(match.address):
            if self._udp is not None:
                self._udp.open(counterpart)
            return
        try:
            self._multicast.open(counterpart)
        except OSError as error:
            self.problem(f"{match.address} port {match.port} cannot be heard: {error.strerror}")

    def _open(self, counterpart: Counterpart) -> None:
        match = counterpart.match
        if match.protocol == "udp":
            self._open_udp(counterpart)
        if match.protocol != "tcp":
            return
        inlet = self._tcp.get(counterpart.key)
        if inlet is not None:
            if inlet.place == (match.address, match.port):
                return
            inlet.close()
        resting = self._resting.pop(counterpart.key, None)
        if resting is not None:
            resting[0].close()
        inlet = TcpInlet(
            self._loop, self._life, counterpart, self._hear, self._counterparts.connected, self._lost, self._end, self._drop
        )
        self._tcp[counterpart.key] = inlet
        if self._is_paused:
            inlet.pause()

    def _removed(self, change: Change) -> None:
        counterpart = change.counterpart
        inlet = self._tcp.pop(counterpart.key, None)
        if inlet is not None:
            if change.reason == WITHDRAWN and counterpart.is_connected:
                self._resting[counterpart.key] = (inlet, change)
                inlet.rest()
                return
            inlet.close()
        else:
            if change.reason == WITHDRAWN:
                self._read_all()
            self._multicast.close(counterpart)
            if self._udp is not None:
                self._udp.close(counterpart)
        self._gone(change)

    def _gone(self, change: Change) -> None:
        key = change.counterpart.key
        if isinstance(key, int):
            self._sequence.interrupted(key)
        self._complained = {one for one in self._complained if one[0] != key}
        self._tell(change)

    def _read_all(self) -> None:
        self._multicast.read_all()
        if self._udp is not None:
            self._udp.read_all()

    def _lost(self, key: Key) -> bool:
        """The connection to a provider ended or failed. Whether it is to be made again."""
        changes = self._counterparts.disconnected(key)
        self._apply(changes)
        return not changes and not self._is_closed

    def _end(self, key: Key, was_clean: bool) -> None:
        """A provider has ended."""
        resting = self._resting.pop(key, None)
        if resting is not None:
            self._gone(resting[1])
            return
        counterpart = self._counterparts.get(key)
        if counterpart is None:
            return
        if counterpart.match.protocol == "tcp":
            self._tcp.pop(key, None)
        else:
            self._multicast.close(counterpart)
            if self._udp is not None:
                self._udp.close(counterpart)
        self._counterparts.ended(key)
        self._gone(Change("removed", counterpart, WITHDRAWN))

    def _tell(self, change: Change) -> None:
        self._node.tell_provider(self, change.kind, change.counterpart.match, change.reason)

    # Inside: messages

    def _hear(self, counterpart: Counterpart, frame: Frame) -> None:
        if frame.kind is Kind.END:
            self._missed += self._sequence.missed_at_end(frame.life, frame.sequence)
            return
        missed = self._sequence.missed(frame.life, frame.sequence)
        if missed is None:
            self._dropped += 1
            return
        self._missed += missed
        self._deliver(counterpart, frame.payload, frame.life, frame.sequence, missed)

    def _hear_datagram(self, counterpart: Counterpart, octets: bytes) -> None:
        self._deliver(counterpart, octets, 0, 0, 0)

    def _deliver(self, counterpart: Counterpart, payload: bytes, life: int, sequence: int, missed: int) -> None:
        if counterpart.match.convert:
            try:
                payload = convert(payload, counterpart.match.convert, self._conversions, counterpart.match.via)
            except ConversionError as error:
                self._dropped += 1
                if (counterpart.key, error.step) not in self._complained:
                    self._complained.add((counterpart.key, error.step))
                    self.problem(str(error))
                return
        self._received += 1
        message = Message(payload, life, sequence, missed)
        if counterpart.match.protocol == "tcp":
            self._inbox.put_streamed(message)
        else:
            lost = self._inbox.put_datagram(message)
            self._received -= lost
            self._missed += lost
        if self._inbox.is_full and not self._is_paused:
            self._is_paused = True
            for inlet in self._inlets():
                inlet.pause()
        if self._waiters:
            self._wake()

    def _take(self) -> Message:
        message = self._inbox.take()
        if self._is_paused and self._inbox.has_room:
            self._is_paused = False
            for inlet in self._inlets():
                inlet.resume()
        return message

    def _inlets(self) -> list[TcpInlet]:
        return [*self._tcp.values(), *(inlet for inlet, _ in self._resting.values())]

    def _wake(self) -> None:
        while self._waiters:
            waiter = self._waiters.popleft()
            if not waiter.done():
                waiter.set_result(None)
                return

    def _drop(self) -> None:
        self._dropped += 1

    def _find(self) -> None:
        self._dropped -= 1

    def _close_all(self) -> None:
        for inlet in self._inlets():
            inlet.close()
        self._tcp.clear()
        self._resting.clear()
        self._multicast.abort()
        if self._udp is not None:
            self._udp.abort()
