"""The outlet of `oto` and `otm/pubsub` over UDP: a datagram for each consumer, from the publisher's port."""

from __future__ import annotations

import asyncio
import socket
from dataclasses import dataclass

from ..errors import PortTaken
from ..protocol.counterparts import Counterpart, Key
from ..protocol.frame import Frame, Kind
from ..protocol.frame_writer import PublisherFrames
from ..protocol.handshake import Handshake
from ..protocol.limits import STRANGER_SECONDS
from . import sockets
from .outlet import COPIED_OCTETS, OutletHost, Sole
from .reception import Reception, counter_of
from .sockets import Address


@dataclass(eq=False, slots=True)
class _Consumer:
    there: Address | None  #: None if it states no port, or no address that can be reached
    life: int
    counter: int | None = None  #: of its last hello, 0 if that was plain; None until one was accepted
    challenge: int = 0
    source: Address = ()  #: where it said hello


class UdpOutlet:
    """Sends to each consumer; where frames are sealed, to each that has said hello. With `is_lazy` the socket is open only while there
    are consumers."""

    def __init__(
        self, loop: asyncio.AbstractEventLoop, frames: PublisherFrames, port: int, address: str, is_lazy: bool, host: OutletHost
    ) -> None:
        self._loop = loop
        self._frames = frames
        self._address = address
        self._is_lazy = is_lazy
        self._host = host
        self._reception = Reception(loop, frames, self._hello, self._ended)
        sock = sockets.bound(socket.SOCK_DGRAM, port, address)
        self._sock: socket.socket | None = sock
        self.port = sockets.port_of(sock)
        self._by_key: dict[Key, _Consumer] = {}
        self.targets: tuple[tuple[Address, bool], ...] = ()
        self.sole: Sole | None = None
        if is_lazy:
            self._close_socket()
        else:
            self.rekeyed()

    @property
    def dropped(self) -> int:
        """The number of datagrams that were not believed."""
        return self._reception.dropped

    def open(self, counterpart: Counterpart) -> None:
        """Sends to a consumer from now on, if it states a port. One without a life is sent payloads without frames."""
        match = counterpart.match
        there = sockets.target(self._opened().family, match.address, match.port) if match.port else None
        known = self._by_key.get(counterpart.key)
        if known is None:
            self._by_key[counterpart.key] = _Consumer(there, match.life)
        else:
            known.there = there
        self._changed()

    def close(self, counterpart: Counterpart) -> None:
        """Ends sending to a consumer."""
        if self._by_key.pop(counterpart.key, None) is not None:
            self._changed()

    def rekeyed(self, begins_to_seal: bool = False) -> None:
        """Other keys are in force, or another mode: reads hellos where there is a ring."""
        if self._frames.is_strict and self._by_key:
            self._loop.call_later(STRANGER_SECONDS, self._end_plain)
        if self._sock is not None:
            if self._frames.has_ring:
                self._reception.read(self._sock)
            else:
                self._reception.rest()
        for one in self._by_key.values():
            if begins_to_seal and one.counter is not None:
                self._reception.floor(one.source, one.life, one.challenge)
        self._changed()

    def _end_plain(self) -> None:
        """Forgets consumers that have said no sealed hello, where that is needed."""
        if self._frames.is_strict:
            for one in self._by_key.values():
                if one.counter == 0:
                    one.counter = None
            self._changed()

    def send(self, header: bytes, body: bytes, payload: bytes) -> int:
        """Sends to all targets, of which there is one at least. Returns for how many it was left out."""
        sock, left_out = self._opened(), 0
        frame = header + body if len(body) <= COPIED_OCTETS else b""
        for there, has_frames in self.targets:
            if frame or not has_frames:
                took = sockets.send_datagram(sock, frame if has_frames else payload, there)
            else:
                took = sockets.send_frame(sock, header, body, there)
            left_out += not took
        return left_out

    async def drain(self) -> None:
        """Lets the event loop turn once, because datagrams do not wait."""
        await asyncio.sleep(0)

    async def end(self) -> None:
        """Sends a frame of kind 3 to each consumer, and closes."""
        if any(has_frames for _, has_frames in self.targets):
            frame = self._frames.other(Kind.END)
            for there, has_frames in self.targets:
                if has_frames:
                    sockets.send_datagram(self._opened(), frame, there)
        self.abort()

    def abort(self) -> None:
        """Closes the socket."""
        self._by_key.clear()
        self.targets = ()
        self.sole = None
        self._close_socket()

    def _hello(self, source: Address, frame: Frame, said: Handshake) -> None:
        consumer = self._by_key.get(frame.life)
        counter = counter_of(frame)
        if consumer is not None and consumer.counter is not None:
            if counter and counter <= consumer.counter:
                self._reception.dropped += 1
                return
            consumer.counter = max(counter, consumer.counter)
            consumer.challenge, consumer.source = said.challenge, source
        elif not self._reception.has_cookie(source, frame, said):
            self._reception.ask(source, frame, said)
            return
        elif consumer is None:
            return  # It will be accepted when the daemon has told of it, and it says hello again.
        else:
            consumer.counter, consumer.challenge, consumer.source = counter, said.challenge, source
            self._changed()
            self._host.joined(frame.life)
        self._reception.answer(Kind.FLOOR, source, frame.life, said.challenge)

    def _ended(self, source: Address, frame: Frame) -> None:
        """A consumer says that it has ended, before its daemon does."""
        consumer = self._by_key.get(frame.life)
        counter = counter_of(frame)
        if consumer is None or consumer.counter is None or counter <= consumer.counter:
            self._reception.dropped += 1
            return
        consumer.counter = None
        self._changed()

    def _reaches(self, one: _Consumer) -> bool:
        keys = self._frames.keys
        if keys is None or one.there is None:
            return False
        if one.life == 0:
            return keys.takes_plain
        return not keys.seals or one.counter is not None

    def _changed(self) -> None:
        reached = [one for one in self._by_key.values() if self._reaches(one)]
        self.targets = tuple((one.there, one.life != 0) for one in reached if one.there is not None)
        is_sole = len(reached) == 1 and reached[0].life != 0 and not self._frames.seals
        self.sole = (self._opened().sendto, self.targets[0][0]) if is_sole else None
        if self._is_lazy and not self._by_key:
            self._close_socket()

    def _opened(self) -> socket.socket:
        sock = self._sock
        if sock is None:
            try:
                sock = sockets.bound(socket.SOCK_DGRAM, self.port, self._address)
            except PortTaken:
                sock = sockets.bound(socket.SOCK_DGRAM, 0, self._address)
                self.port = sockets.port_of(sock)
                self._host.moved(self.port)
            self._sock = sock
            if self._frames.has_ring:
                self._reception.read(sock)
        return sock

    def _close_socket(self) -> None:
        self._reception.rest()
        sockets.close(self._sock)
        self._sock = None
