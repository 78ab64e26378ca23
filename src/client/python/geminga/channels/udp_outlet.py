"""The outlet of `oto` and `otm/pubsub` over UDP: a datagram for each consumer, from the publisher's port."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from ..errors import PortTaken
from ..protocol.counterparts import Counterpart, Key
from ..protocol.frame import Kind, write_frame
from . import sockets
from .outlet import COPIED_OCTETS, Sole
from .sockets import Address


class UdpOutlet:
    """Sends to each consumer. With `is_lazy` the socket is open only while there are consumers. `moved` is called with a port that had to
    change."""

    def __init__(self, life: int, port: int, address: str, is_lazy: bool, moved: Callable[[int], None]) -> None:
        self._life = life
        self._address = address
        self._is_lazy = is_lazy
        self._moved = moved
        sock = sockets.bound(socket.SOCK_DGRAM, port, address)
        self._sock: socket.socket | None = sock
        self.port = sockets.port_of(sock)
        self._by_key: dict[Key, tuple[Address, bool]] = {}
        self.dropped = 0
        self.targets: tuple[tuple[Address, bool], ...] = ()
        self.sole: Sole | None = None
        if is_lazy:
            self._close_socket()

    def open(self, counterpart: Counterpart) -> None:
        """Sends to a consumer from now on, if it states a port. One without a life is sent payloads without frames."""
        sock = self._opened()
        there = sockets.target(sock.family, counterpart.match.address, counterpart.match.port)
        if there is None or counterpart.match.port == 0:
            self._by_key.pop(counterpart.key, None)
        else:
            self._by_key[counterpart.key] = (there, counterpart.match.life != 0)
        self._changed()

    def close(self, counterpart: Counterpart) -> None:
        """Ends sending to a consumer."""
        if self._by_key.pop(counterpart.key, None) is not None:
            self._changed()

    def send(self, header: bytes, payload: bytes) -> int:
        """Sends to all targets, of which there is one at least. Returns for how many it was left out."""
        sock, left_out = self._opened(), 0
        frame = header + payload if len(payload) <= COPIED_OCTETS else b""
        for there, has_frames in self.targets:
            if frame or not has_frames:
                took = sockets.send_datagram(sock, frame if has_frames else payload, there)
            else:
                took = sockets.send_frame(sock, header, payload, there)
            left_out += not took
        return left_out

    async def drain(self) -> None:
        """Lets the event loop turn once, because datagrams do not wait."""
        await asyncio.sleep(0)

    async def end(self, last: int) -> None:
        """Sends a frame of kind 3 to each consumer, and closes."""
        if self.targets:
            frame = write_frame(Kind.END, self._life, last)
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

    def _changed(self) -> None:
        self.targets = tuple(self._by_key.values())
        is_sole = len(self.targets) == 1 and self.targets[0][1]
        self.sole = (self._opened().sendto, self.targets[0][0]) if is_sole else None
        if self._is_lazy and not self.targets:
            self._close_socket()

    def _opened(self) -> socket.socket:
        sock = self._sock
        if sock is None:
            try:
                sock = sockets.bound(socket.SOCK_DGRAM, self.port, self._address)
            except PortTaken:
                sock = sockets.bound(socket.SOCK_DGRAM, 0, self._address)
                self.port = sockets.port_of(sock)
                self._moved(self.port)
            self._sock = sock
        return sock

    def _close_socket(self) -> None:
        sockets.close(self._sock)
        self._sock = None
