"""The inlet of a subscriber over UDP. It believes a datagram by its address, port and life."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from ..protocol.counterparts import Counterpart, Key
from ..protocol.early_frames import EarlyFrames
from ..protocol.frame import Frame, FrameError, Kind, read_datagram, write_frame
from ..protocol.limits import HELLO_SECONDS
from . import sockets
from .sockets import Address

_DATAGRAMS_A_TURN = 64
_MAX_DATAGRAM_OCTETS = 65_536
#: Datagrams that are read at the end of a provider: more than the buffer of a socket holds.
DATAGRAMS_AT_END = 16_384


class UdpInlet:
    """The UDP socket of a subscriber. `says_hello` is for `otm/stream`. `on_found` takes one `on_drop` back."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        life: int,
        port: int,
        says_hello: bool,
        on_message: Callable[[Counterpart, Frame], None],
        on_datagram: Callable[[Counterpart, bytes], None],
        on_end: Callable[[Key, bool], None],
        on_drop: Callable[[], None],
        on_found: Callable[[], None],
    ) -> None:
        self._loop = loop
        self._life = life
        self._says_hello = says_hello
        self._on_message = on_message
        self._on_datagram = on_datagram
        self._on_end = on_end
        self._on_drop = on_drop
        self._on_found = on_found
        self._early = EarlyFrames()
        self._sock = sockets.bound(socket.SOCK_DGRAM, port)
        self.port = sockets.port_of(self._sock)
        self._by_key: dict[Key, tuple[Address, Counterpart]] = {}
        self._by_source: dict[Address, dict[int, Counterpart]] = {}
        self._timer: asyncio.TimerHandle | None = None
        loop.add_reader(self._sock, self.read)

    def open(self, counterpart: Counterpart) -> None:
        """Believes this provider at the address and port that it has now."""
        self._forget(counterpart)
        there = sockets.target(self._sock.family, counterpart.match.address, counterpart.match.port)
        if there is None or counterpart.match.port == 0:
            return
        self._by_key[counterpart.key] = (there, counterpart)
        self._by_source.setdefault(there, {})[counterpart.match.life] = counterpart
        if self._says_hello:
            self._hello(Kind.HELLO, there, counterpart)
            if self._timer is None:
                self._timer = self._loop.call_later(HELLO_SECONDS, self._hello_all)

    def deliver_early(self, counterpart: Counterpart) -> None:
        """Delivers the frames that came from this provider before open()."""
        known = self._by_key.get(counterpart.key)
        if known is None:
            return
        for frame in self._early.take(known[0], counterpart.match.life, self._loop.time()):
            if self._by_key.get(counterpart.key) is not known:
                return  # It has ended.
            self._on_found()
            _deliver(counterpart, frame, self._on_message, self._on_end)

    def close(self, counterpart: Counterpart) -> None:
        """Forgets a provider. A publisher that was said hello to is told the end."""
        known = self._by_key.get(counterpart.key)
        if known is not None and self._says_hello:
            self._hello(Kind.END, *known)
        self._forget(counterpart)

    def abort(self) -> None:
        """Closes the socket. Publishers that were said hello to are told the end."""
        if self._timer is not None:
            self._timer.cancel()
        for there, counterpart in self._by_key.values():
            if self._says_hello:
                self._hello(Kind.END, there, counterpart)
        self._by_key.clear()
        self._by_source.clear()
        if self._sock.fileno() >= 0:
            self._loop.remove_reader(self._sock)
        sockets.close(self._sock)

    def read(self) -> None:
        """Reads what the socket holds, but not more than its share of a turn."""
        for _ in range(_DATAGRAMS_A_TURN):
            try:
                octets, source = self._sock.recvfrom(_MAX_DATAGRAM_OCTETS)
            except OSError:
                return
            self._heard(octets, source)

    def read_all(self) -> None:
        """Reads what the socket holds now, but not without end."""
        for _ in range(DATAGRAMS_AT_END):
            if self._sock.fileno() < 0:
                return
            try:
                octets, source = self._sock.recvfrom(_MAX_DATAGRAM_OCTETS)
            except OSError:
                return
            self._heard(octets, source)

    def _heard(self, octets: bytes, source: Address) -> None:
        lives = self._by_source.get(source) or self._by_source.get(sockets.canonical(source)) or {}
        frame = dispatch(octets, lives, self._on_message, self._on_datagram, self._on_end, self._on_drop)
        if frame is not None and frame.kind is not Kind.HELLO:
            self._early.put(sockets.canonical(source), frame, self._loop.time())

    def _forget(self, counterpart: Counterpart) -> None:
        known = self._by_key.pop(counterpart.key, None)
        if known is None:
            return
        lives = self._by_source.get(known[0], {})
        lives = {life: one for life, one in lives.items() if one is not known[1]}
        if lives:
            self._by_source[known[0]] = lives
        else:
            self._by_source.pop(known[0], None)

    def _hello(self, kind: Kind, there: Address, counterpart: Counterpart) -> None:
        if counterpart.match.life:
            payload = counterpart.match.life.to_bytes(8, "big")
            sockets.send_datagram(self._sock, write_frame(kind, self._life, 0, payload), there)

    def _hello_all(self) -> None:
        self._timer = None
        for there, counterpart in self._by_key.values():
            self._hello(Kind.HELLO, there, counterpart)
        if self._by_key:
            self._timer = self._loop.call_later(HELLO_SECONDS, self._hello_all)


def dispatch(
    octets: bytes,
    lives: dict[int, Counterpart],
    on_message: Callable[[Counterpart, Frame], None],
    on_datagram: Callable[[Counterpart, bytes], None],
    on_end: Callable[[Key, bool], None],
    on_drop: Callable[[], None],
) -> Frame | None:
    """Gives a datagram from an address and port to the provider there whose life it has. Returns a frame that is of none of them.

    A provider without a life gets each datagram that is of no other provider there.
    """
    frame: Frame | None = None
    counterpart: Counterpart | None = None
    try:
        frame = read_datagram(octets)
        counterpart = lives.get(frame.life) if frame.kind is not Kind.HELLO else None
    except FrameError:
        pass
    if frame is not None and counterpart is not None:
        _deliver(counterpart, frame, on_message, on_end)
    elif 0 in lives:
        on_datagram(lives[0], octets)
    else:
        on_drop()
        return frame
    return None


def _deliver(
    counterpart: Counterpart,
    frame: Frame,
    on_message: Callable[[Counterpart, Frame], None],
    on_end: Callable[[Key, bool], None],
) -> None:
    on_message(counterpart, frame)
    if frame.kind is Kind.END:
        on_end(counterpart.key, True)
