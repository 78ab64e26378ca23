"""The outlet of `otm/stream` over UDP to a unicast address: a datagram for each listener that says hello."""

from __future__ import annotations

import asyncio
import socket

from ..protocol.counterparts import Counterpart
from ..protocol.frame import FrameError, Kind, read_datagram, write_frame
from ..protocol.limits import HELLO_SECONDS
from ..protocol.listeners import Listeners
from . import sockets
from .outlet import COPIED_OCTETS, Sole
from .sockets import Address

_DATAGRAMS_A_TURN = 64


class ListenersOutlet:
    """Receives hellos with the publisher's life at its port."""

    def __init__(self, loop: asyncio.AbstractEventLoop, life: int, port: int, address: str) -> None:
        self._loop = loop
        self._life = life
        self._life_octets = life.to_bytes(8, "big")
        self._sock = sockets.bound(socket.SOCK_DGRAM, port, address)
        self.port = sockets.port_of(self._sock)
        self._listeners = Listeners()
        self.targets: list[Address] = []
        self.sole: Sole | None = None
        self.dropped = 0
        self._timer: asyncio.TimerHandle | None = None
        loop.add_reader(self._sock, self._read)

    def open(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def close(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def send(self, header: bytes, payload: bytes) -> int:
        """Sends to all listeners. Returns for how many it was left out."""
        left_out = 0
        frame = header + payload if len(payload) <= COPIED_OCTETS else b""
        for there in self.targets:
            if frame:
                took = sockets.send_datagram(self._sock, frame, there)
            else:
                took = sockets.send_frame(self._sock, header, payload, there)
            left_out += not took
        return left_out

    async def drain(self) -> None:
        """Lets the event loop turn once, because datagrams do not wait."""
        await asyncio.sleep(0)

    async def end(self, last: int) -> None:
        """Sends a frame of kind 3 to each listener, and closes."""
        for there in self.targets:
            sockets.send_datagram(self._sock, write_frame(Kind.END, self._life, last), there)
        self.abort()

    def abort(self) -> None:
        """Closes the socket."""
        if self._timer is not None:
            self._timer.cancel()
        self.targets = []
        self.sole = None
        if self._sock.fileno() >= 0:
            self._loop.remove_reader(self._sock)
        sockets.close(self._sock)

    def _read(self) -> None:
        for _ in range(_DATAGRAMS_A_TURN):
            try:
                octets, source = self._sock.recvfrom(2048)
            except OSError:
                break
            self._heard(octets, source)

    def _heard(self, octets: bytes, source: Address) -> None:
        try:
            frame = read_datagram(octets)
        except FrameError:
            self.dropped += 1
            return
        if frame.payload != self._life_octets or frame.kind is Kind.MESSAGE:
            self.dropped += 1
        elif frame.kind is Kind.END:
            self._listeners.end(source)
        elif not self._listeners.hello(source, self._loop.time()):
            self.dropped += 1
        self._changed()

    def _changed(self) -> None:
        self.targets = self._listeners.addresses
        self.sole = (self._sock.sendto, self.targets[0]) if len(self.targets) == 1 else None
        if self.targets and self._timer is None:
            self._timer = self._loop.call_later(HELLO_SECONDS / 4, self._tick)

    def _tick(self) -> None:
        self._timer = None
        self._listeners.tick(self._loop.time())
        self._changed()
