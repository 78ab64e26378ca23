"""The outlet of `otm/stream` over UDP to a multicast address: one datagram for each interface, whether anybody listens or not."""

from __future__ import annotations

import asyncio
import errno
import socket

from ..errors import PortTaken
from ..protocol.counterparts import Counterpart
from ..protocol.frame import Frame, Kind
from ..protocol.frame_writer import PublisherFrames
from ..protocol.handshake import Handshake
from ..protocol.limits import INTERFACES_SECONDS
from . import multicast, sockets
from .interfaces import interfaces
from .reception import Reception
from .sockets import Address

class MulticastOutlet:
    """Sends through all interfaces, and looks every two seconds which there are. Where frames are sealed, a socket of its own takes
    hellos."""

    def __init__(self, loop: asyncio.AbstractEventLoop, frames: PublisherFrames, port: int, group: str) -> None:
        self._loop = loop
        self._frames = frames
        self._group = group
        self.port = port or _free_port()
        self._by_interface: dict[int, socket.socket] = {}
        self._timer: asyncio.TimerHandle | None = None
        self.sole = None
        self._reception = Reception(loop, frames, self._hello, self._ended, is_hello_port=True)
        self._hellos: socket.socket | None = None
        self._refresh()
        self.rekeyed()

    @property
    def dropped(self) -> int:
        """The number of datagrams that were not believed."""
        return self._reception.dropped

    @property
    def targets(self) -> dict[int, socket.socket]:
        """The socket of each interface, once it is known which keys there are."""
        return self._by_interface if self._frames.keys is not None else {}

    def open(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def close(self, counterpart: Counterpart) -> None:
        """Does nothing: publishers of `otm/stream` are not told of consumers."""

    def rekeyed(self, begins_to_seal: bool = False) -> None:
        """Other keys are in force, or another mode: takes hellos while frames are sealed."""
        if not self._frames.seals:
            self._close_hellos()
        elif self._hellos is None:
            self._hellos = sockets.bound(socket.SOCK_DGRAM, 0)
            self._frames.hello_port = sockets.port_of(self._hellos)
            self._reception.read(self._hellos)

    def send(self, header: bytes, body: bytes, payload: bytes) -> int:
        """Sends through each interface. Returns 1 if none took it."""
        frame = header + body
        took = False
        for interface, sock in self._by_interface.items():
            took |= sockets.send_datagram(sock, frame, multicast.group_address(self._group, self.port, interface))
        return 0 if took else 1

    async def drain(self) -> None:
        """Lets the event loop turn once, because datagrams do not wait."""
        await asyncio.sleep(0)

    async def end(self) -> None:
        """Sends a frame of kind 3 to the group, and closes."""
        if self.targets:
            self.send(self._frames.other(Kind.END), b"", b"")
        self.abort()

    def abort(self) -> None:
        """Closes the sockets."""
        if self._timer is not None:
            self._timer.cancel()
        for sock in self._by_interface.values():
            sockets.close(sock)
        self._by_interface.clear()
        self._close_hellos()

    def _hello(self, source: Address, frame: Frame, said: Handshake) -> None:
        self._reception.answer(Kind.FLOOR, source, frame.life, said.challenge)

    def _ended(self, source: Address, frame: Frame) -> None:
        """Nothing is kept of the consumers of a group."""

    def _close_hellos(self) -> None:
        self._reception.rest()
        sockets.close(self._hellos)
        self._hellos = None
        self._frames.hello_port = 0

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
