"""The reception of a publisher over UDP: hellos are read from a socket, and answered by floors and fulls."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from ..protocol.frame import Frame, FrameError, Kind
from ..protocol.frame_writer import PublisherFrames
from ..protocol.handshake import Allowance, Cookies, Handshake, read_handshake
from ..protocol.sealed_frame import OpenedFrame, read_any_datagram
from . import sockets
from .sockets import Address

_DATAGRAMS_A_TURN = 64
_HELLO_OCTETS = 2048  # a longer datagram is no hello


def counter_of(frame: Frame) -> int:
    """The counter of a sealed frame, or 0 of a plain one."""
    return frame.counter if isinstance(frame, OpenedFrame) else 0


class Reception:
    """Calls `on_hello` and `on_end` with frames that have a hello's payload with the publisher's life. Belongs to an event loop.

    The cookies and the number of answers are the same over all sockets that it reads.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        frames: PublisherFrames,
        on_hello: Callable[[Address, Frame, Handshake], None],
        on_end: Callable[[Address, Frame], None],
        is_hello_port: bool = False,
    ) -> None:
        self._loop = loop
        self._frames = frames
        self._on_hello = on_hello
        self._on_end = on_end
        self._is_hello_port = is_hello_port
        self._cookies = Cookies()
        self._allowance = Allowance(loop.time)
        self._sock: socket.socket | None = None
        self.dropped = 0

    def read(self, sock: socket.socket) -> None:
        """Reads this socket from now on."""
        if self._sock is None:
            self._sock = sock
            self._loop.add_reader(sock, self._read)

    def rest(self) -> None:
        """Reads no more. To be called before the socket is closed."""
        if self._sock is not None:
            self._loop.remove_reader(self._sock)
            self._sock = None

    def has_cookie(self, source: Address, frame: Frame, said: Handshake) -> bool:
        """Whether a hello gives back a cookie that was made for it."""
        return self._cookies.are_right(_place(source), frame.life, said.challenge, said.cookie, self._loop.time())

    def ask(self, source: Address, frame: Frame, said: Handshake) -> None:
        """Answers a hello by a cookie."""
        cookie = self._cookies.cookie(_place(source), frame.life, said.challenge, self._loop.time())
        self.answer(Kind.FLOOR, source, frame.life, said.challenge, cookie)

    def answer(self, kind: Kind, source: Address, life: int, challenge: int, cookie: int = 0, is_known: bool = False) -> None:
        """Answers a hello by a floor or a full, if there were not too many answers. Half of them are for those that are not known yet."""
        if self._sock is not None and self._allowance.take(is_known):
            octets = self._frames.other(kind, Handshake(life, challenge, cookie).write(), self._is_hello_port)
            sockets.send_datagram(self._sock, octets, source)

    def floor(self, there: Address, life: int, challenge: int) -> None:
        """Sends a floor to a consumer that was accepted, which has not asked for one."""
        if self._sock is not None:
            octets = self._frames.other(Kind.FLOOR, Handshake(life, challenge, 0).write(), self._is_hello_port)
            sockets.send_datagram(self._sock, octets, there)

    def _read(self) -> None:
        for _ in range(_DATAGRAMS_A_TURN):
            if self._sock is None:
                return
            try:
                octets, source = self._sock.recvfrom(_HELLO_OCTETS)
            except OSError:
                return
            self._heard(octets, source)

    def _heard(self, octets: bytes, source: Address) -> None:
        try:
            frame = self._frames.take(read_any_datagram(octets))
        except FrameError:
            frame = None
        said = None if frame is None else read_handshake(frame.payload)
        if frame is None or said is None or said.life != self._frames.life:
            self.dropped += 1
        elif frame.kind is Kind.HELLO and said.challenge:
            self._on_hello(source, frame, said)
        elif frame.kind is Kind.END:
            self._on_end(source, frame)
        else:
            self.dropped += 1


def _place(source: Address) -> tuple[str, int]:
    return str(source[0]), int(source[1])
