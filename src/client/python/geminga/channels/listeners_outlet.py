"""The outlet of `otm/stream` over UDP to a unicast address: a datagram for each listener that says hello."""

from __future__ import annotations

import asyncio
import socket

from ..protocol.counterparts import Counterpart
from ..protocol.frame import Frame, Kind
from ..protocol.frame_writer import PublisherFrames
from ..protocol.handshake import Handshake
from ..protocol.limits import HELLO_SECONDS, MAX_LISTENERS
from ..protocol.listeners import Listener, Listeners
from . import sockets
from .outlet import COPIED_OCTETS, OutletHost, Sole
from .reception import Reception, counter_of
from .sockets import Address


class ListenersOutlet:
    """Receives hellos with the publisher's life at its port, and sends to those that have shown by a cookie to receive there."""

    def __init__(
        self, loop: asyncio.AbstractEventLoop, frames: PublisherFrames, port: int, address: str, host: OutletHost
    ) -> None:
        self._loop = loop
        self._frames = frames
        self._host = host
        self._sock = sockets.bound(socket.SOCK_DGRAM, port, address)
        self.port = sockets.port_of(self._sock)
        self._listeners = Listeners()
        self.targets: list[Address] = []
        self.sole: Sole | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._reception = Reception(loop, frames, self._hello, self._ended)
        self._reception.read(self._sock)

    @property
    def dropped(self) -> int:
        """The number of datagrams that were not believed."""
        return self._reception.dropped

    def open(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def close(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def rekeyed(self, begins_to_seal: bool = False) -> None:
        """Other keys are in force, or another mode. Where plain hellos are no longer taken, they renew no listener, so its time runs out."""
        if begins_to_seal:
            for there in self._listeners.addresses:
                known = self._listeners.get(there)
                if known is not None:
                    self._reception.floor(there, known.life, known.challenge)
        self._changed()

    def send(self, header: bytes, body: bytes, payload: bytes) -> int:
        """Sends to all listeners. Returns for how many it was left out."""
        left_out = 0
        frame = header + body if len(body) <= COPIED_OCTETS else b""
        for there in self.targets:
            if frame:
                took = sockets.send_datagram(self._sock, frame, there)
            else:
                took = sockets.send_frame(self._sock, header, body, there)
            left_out += not took
        return left_out

    async def drain(self) -> None:
        """Lets the event loop turn once, because datagrams do not wait."""
        await asyncio.sleep(0)

    async def end(self) -> None:
        """Sends a frame of kind 3 to each listener, and closes."""
        if self.targets:
            frame = self._frames.other(Kind.END)
            for there in self.targets:
                sockets.send_datagram(self._sock, frame, there)
        self.abort()

    def abort(self) -> None:
        """Closes the socket."""
        if self._timer is not None:
            self._timer.cancel()
        self.targets = []
        self.sole = None
        self._reception.rest()
        sockets.close(self._sock)

    def _hello(self, source: Address, frame: Frame, said: Handshake) -> None:
        known = self._listeners.get(source)
        counter = counter_of(frame)
        if known is not None and counter and known.life != frame.life:
            known = None  # The port belongs to another subscriber.
        if known is not None:
            if counter and counter <= known.counter:
                self._reception.dropped += 1
                return
            known.life, known.challenge, known.heard = frame.life, said.challenge, self._loop.time()
            known.counter = max(counter, known.counter)
        elif not self._reception.has_cookie(source, frame, said):
            self._reception.ask(source, frame, said)
            return
        elif not self._admit(source, Listener(frame.life, said.challenge, self._loop.time(), counter)):
            self._reception.answer(Kind.FULL, source, frame.life, said.challenge)
            return
        self._reception.answer(Kind.FLOOR, source, frame.life, said.challenge, is_known=known is not None)

    def _admit(self, source: Address, listener: Listener) -> bool:
        self._listeners.end(source)
        took, lost = self._listeners.add(source, listener)
        if not took or lost is not None:
            self._host.no_place("listeners", MAX_LISTENERS)
        if lost is not None:
            self._reception.answer(Kind.FULL, lost[0], lost[1].life, lost[1].challenge)
        self._changed()
        return took

    def _ended(self, source: Address, frame: Frame) -> None:
        known = self._listeners.get(source)
        counter = counter_of(frame)
        if known is None or (counter and (known.life != frame.life or counter <= known.counter)):
            self._reception.dropped += 1
            return
        self._listeners.end(source)
        self._changed()

    def _changed(self) -> None:
        self.targets = self._listeners.addresses if self._frames.keys is not None else []
        is_sole = len(self.targets) == 1 and not self._frames.seals
        self.sole = (self._sock.sendto, self.targets[0]) if is_sole else None
        if self._listeners.places.has_room_again:
            self._host.places_again()
        if self.targets and self._timer is None:
            self._timer = self._loop.call_later(HELLO_SECONDS / 4, self._tick)

    def _tick(self) -> None:
        self._timer = None
        self._listeners.tick(self._loop.time())
        self._changed()
