"""The outlet of `otm/stream` over UDP to a multicast address: one datagram for each interface, whether anybody listens or not."""

from __future__ import annotations

import asyncio
import errno
import socket

from ..errors import PortTaken
from ..protocol.counterparts import Counterpart
from ..protocol.frame import Kind, write_frame
from ..protocol.limits import INTERFACES_SECONDS
from . import multicast, sockets
from .interfaces import interfaces



class MulticastOutlet:
    """Sends through all interfaces, and looks every two seconds which there are."""

    def __init__(self, loop: asyncio.AbstractEventLoop, life: int, port: int, group: str) -> None:
        self._loop = loop
        self._life = life
        self._group = group
        self.port = port or _free_port()
        self._by_interface: dict[int, socket.socket] = {}
        self._timer: asyncio.TimerHandle | None = None
        self.dropped = 0
        self.sole = None
        self._refresh()

    @property
    def targets(self) -> dict[int, socket.socket]:
        """The socket of each interface."""
        return self._by_interface

    def open(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def close(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def send(self, header: bytes, payload: bytes) -> int:
        """Sends through each interface. Returns 1 if none took it."""
        frame = header + payload
        took = False
        for interface, sock in self._by_interface.items():
            took |= sockets.send_datagram(sock, frame, multicast.group_address(self._group, self.port, interface))
        return 0 if took else 1

    async def drain(self) -> None:
        """Lets the event loop turn once, because datagrams do not wait."""
        await asyncio.sleep(0)

    async def end(self, last: int) -> None:
        """Sends a frame of kind 3 to the group, and closes."""
        self.send(write_frame(Kind.END, self._life, last), b"")
        self.abort()

    def abort(self) -> None:
        """Closes the sockets."""
        if self._timer is not None:
            self._timer.cancel()
        for sock in self._by_interface.values():
            sockets.close(sock)
        self._by_interface.clear()

    def _refresh(self) -> None:
        there = interfaces()
        for gone in [index for index in self._by_interface if index not in there]:
            sockets.close(self._by_interface.pop(gone))
        for index in there:
            if index not in self._by_interface:
                try:
                    self._by_interface[index] = multicast.sending(self._group, self.port, index)
                except OSError as error:
                    if error.errno == errno.EADDRINUSE and not self._by_interface:
                        raise PortTaken(f"port {self.port} is taken: say another one, or none for any") from error
                    continue  # It has no address of this family.
        self._timer = self._loop.call_later(INTERFACES_SECONDS, self._refresh)


def _free_port() -> int:
    sock = sockets.bound(socket.SOCK_DGRAM, 0)
    port = sockets.port_of(sock)
    sock.close()
    return port
