"""The inlet of a subscriber over UDP. It believes a datagram by its address, port and life, and by its seal where there is a key."""

from __future__ import annotations

import asyncio
import socket
from typing import Protocol

from ..protocol.belief import AGAIN, FORGED, FULL
from ..protocol.counter import CounterError, ForkError
from ..protocol.counterparts import Counterpart, Key
from ..protocol.early_frames import EarlyFrames
from ..protocol.frame import Form, Frame, FrameError, Kind
from ..protocol.frame_writer import ConsumerFrames
from ..protocol.sealed_frame import AnyFrame, OpenedFrame, read_any_datagram
from . import sockets
from .sockets import Address

_DATAGRAMS_A_TURN = 64
_MAX_DATAGRAM_OCTETS = 65_536
#: Datagrams that are read at the end of a provider: more than the buffer of a socket holds.
DATAGRAMS_AT_END = 16_384
#: The place among the early frames of those that wait for a floor; they are known by their life.
_BEFORE_THE_FLOOR: Address = ("",)


class InletHost(Protocol):
    """The part of a subscriber that its inlets tell of what they hear."""

    def hear(self, counterpart: Counterpart, frame: Frame) -> None:
        """A message or an end has come that is believed."""

    def hear_datagram(self, counterpart: Counterpart, octets: bytes) -> None:
        """A datagram of a provider without a life has come."""

    def drop(self) -> None:
        """Octets were not believed, or not yet."""

    def find(self) -> None:
        """A frame is believed that was dropped."""

    def full(self, counterpart: Counterpart) -> None:
        """The provider has no place for this consumer."""

    def failed(self, error: Exception) -> None:
        """No frame can be sent any more."""


class _Greeted:
    """A provider that is said hello to, and when next."""

    def __init__(self, there: Address, counterpart: Counterpart) -> None:
        self.there = there
        self.counterpart = counterpart
        self.form = Form.PLAIN  #: of its last hello
        self.timer: asyncio.TimerHandle | None = None

    def rest(self) -> None:
        """Says hello no more."""
        if self.timer is not None:
            self.timer.cancel()
            self.timer = None


class UdpInlet:
    """The UDP socket of a subscriber. `says_hello` is for `otm/stream`; providers with a ring of keys are always said hello to."""

    def __init__(
        self, loop: asyncio.AbstractEventLoop, frames: ConsumerFrames, port: int, says_hello: bool, host: InletHost
    ) -> None:
        self._loop = loop
        self._frames = frames
        self._says_hello = says_hello
        self._host = host
        self._early = EarlyFrames()
        self._sock = sockets.bound(socket.SOCK_DGRAM, port)
        self.port = sockets.port_of(self._sock)
        self._by_key: dict[Key, tuple[Address, Counterpart]] = {}
        self._by_source: dict[Address, dict[int, Counterpart]] = {}
        self._greeted: dict[Key, _Greeted] = {}
        self._groups: dict[int, Counterpart] = {}  # providers over multicast that are asked for a floor, by their lives
        loop.add_reader(self._sock, self.read)

    def open(self, counterpart: Counterpart) -> None:
        """Believes this provider at the address and port that it has now."""
        there = sockets.target(self._sock.family, counterpart.match.address, counterpart.match.port)
        known = self._by_key.get(counterpart.key)
        if known is None or known[0] != there:
            self._forget(counterpart)
            if there is None or counterpart.match.port == 0:
                return
            self._by_key[counterpart.key] = (there, counterpart)
            self._by_source.setdefault(there, {})[counterpart.match.life] = counterpart
        belief = counterpart.belief
        if there is not None and belief is not None and (self._says_hello or belief.has_ring):
            greeted = self._greeted.get(counterpart.key)
            if greeted is None:
                self._greeted[counterpart.key] = _Greeted(there, counterpart)
            if greeted is None or (belief.keys is not None and greeted.form is not belief.keys.form):
                self._greet(counterpart.key)  # at once, so that a publisher that begins to need sealed hellos has one
        else:
            self._ungreet(counterpart.key)

    def deliver_early(self, counterpart: Counterpart) -> None:
        """Delivers the frames that came from this provider before open()."""
        known = self._by_key.get(counterpart.key)
        if known is not None:
            self._deliver_early(known[0], counterpart)

    def ask(self, counterpart: Counterpart, address: str, port: int) -> None:
        """Asks a provider over multicast for a floor, unless it is being asked."""
        there = sockets.target(self._sock.family, address, port)
        known = self._greeted.get(counterpart.key)
        if there is None or port == 0 or (known is not None and known.there == there):
            return
        self._ungreet(counterpart.key)
        self._groups[counterpart.match.life] = counterpart
        self._greeted[counterpart.key] = _Greeted(there, counterpart)
        self._greet(counterpart.key)

    def keep(self, frame: Frame) -> None:
        """Keeps a frame that is believed when its provider's floor comes."""
        self._early.put(_BEFORE_THE_FLOOR, frame, self._loop.time())

    def close(self, counterpart: Counterpart) -> None:
        """Forgets a provider. A publisher that was said hello to is told the end."""
        greeted = self._greeted.get(counterpart.key)
        if greeted is not None and counterpart.key in self._by_key:
            self._say(Kind.END, greeted)
        self._forget(counterpart)
        self._groups.pop(counterpart.match.life, None)

    def abort(self) -> None:
        """Closes the socket. Publishers that were said hello to are told the end."""
        for key, greeted in self._greeted.items():
            greeted.rest()
            if key in self._by_key:
                self._say(Kind.END, greeted)
        self._greeted.clear()
        self._groups.clear()
        self._by_key.clear()
        self._by_source.clear()
        if self._sock.fileno() >= 0:
            self._loop.remove_reader(self._sock)
        sockets.close(self._sock)

    def read(self) -> None:
        """Reads what the socket holds, but not more than its share of a turn."""
        self._read(_DATAGRAMS_A_TURN)

    def read_all(self) -> None:
        """Reads what the socket holds now, but not without end."""
        self._read(DATAGRAMS_AT_END)

    # Inside: frames

    def _read(self, most: int) -> None:
        for _ in range(most):
            if self._sock.fileno() < 0:
                return
            try:
                octets, source = self._sock.recvfrom(_MAX_DATAGRAM_OCTETS)
            except OSError:
                return
            self._heard(octets, source)

    def _heard(self, octets: bytes, source: Address) -> None:
        lives = self._by_source.get(source) or self._by_source.get(sockets.canonical(source)) or {}
        frame, counterpart = sort(octets, lives)
        if frame is not None and counterpart is None and frame.kind in (Kind.FLOOR, Kind.FULL):
            counterpart = self._groups.get(frame.life)
        if frame is not None and counterpart is not None:
            self._take(counterpart, frame)
        elif 0 in lives:
            self._host.hear_datagram(lives[0], octets)
        else:
            self._host.drop()
            if frame is not None and frame.kind in (Kind.MESSAGE, Kind.END):
                self._early.put(sockets.canonical(source), frame, self._loop.time())

    def _take(self, counterpart: Counterpart, octets: AnyFrame) -> None:
        frame = believed(counterpart, octets)
        if frame is None:
            self._host.drop()
        elif frame.kind in (Kind.FLOOR, Kind.FULL):
            self._answered(counterpart, frame)
        elif not hear(counterpart, frame, self._host):
            self.keep(frame)

    def _answered(self, counterpart: Counterpart, frame: Frame) -> None:
        belief, greeted = counterpart.belief, self._greeted.get(counterpart.key)
        if belief is None or greeted is None:
            self._host.drop()
            return
        had_floor = belief.floor is not None
        outcome = belief.answered(frame)
        if outcome == FORGED:
            self._host.drop()
            return
        if outcome == FULL:
            self._host.full(counterpart)
        elif not had_floor and belief.floor is not None:
            self._deliver_early(_BEFORE_THE_FLOOR, counterpart)
        if self._greeted.get(counterpart.key) is not greeted:
            return  # It has ended.
        if counterpart.match.life in self._groups and belief.floor is not None:
            self._ungreet(counterpart.key)  # A group has no listeners.
        elif outcome == AGAIN:
            self._greet(counterpart.key)

    def _deliver_early(self, there: Address, counterpart: Counterpart) -> None:
        for octets in self._early.take(there, counterpart.match.life, self._loop.time()):
            if counterpart.belief is None or self._is_gone(counterpart):
                return  # It has ended.
            frame = octets if isinstance(octets, OpenedFrame) else believed(counterpart, octets)
            if frame is None:
                continue
            self._host.find()
            if not hear(counterpart, frame, self._host):
                self.keep(frame)

    def _is_gone(self, counterpart: Counterpart) -> bool:
        return counterpart.key not in self._by_key and counterpart.match.life not in self._groups

    def _forget(self, counterpart: Counterpart) -> None:
        self._ungreet(counterpart.key)
        known = self._by_key.pop(counterpart.key, None)
        if known is None:
            return
        lives = self._by_source.get(known[0], {})
        lives = {life: one for life, one in lives.items() if one is not known[1]}
        if lives:
            self._by_source[known[0]] = lives
        else:
            self._by_source.pop(known[0], None)

    # Inside: hellos

    def _ungreet(self, key: Key) -> None:
        greeted = self._greeted.pop(key, None)
        if greeted is not None:
            greeted.rest()

    def _greet(self, key: Key) -> None:
        greeted = self._greeted.get(key)
        if greeted is None or greeted.counterpart.belief is None:
            return
        greeted.rest()
        greeted.timer = self._loop.call_later(greeted.counterpart.belief.wait(), self._greet, key)
        self._say(Kind.HELLO, greeted)

    def _say(self, kind: Kind, greeted: _Greeted) -> None:
        belief = greeted.counterpart.belief
        if belief is None or belief.keys is None:
            return
        try:
            octets = self._frames.write(belief.keys, kind, belief.hello())
        except (CounterError, ForkError) as error:
            greeted.rest()
            self._host.failed(error)
            return
        greeted.form = belief.keys.form
        sockets.send_datagram(self._sock, octets, greeted.there)


def sort(octets: bytes, lives: dict[int, Counterpart]) -> tuple[AnyFrame | None, Counterpart | None]:
    """The frame that a datagram is, and which of the providers there has its life. None for a datagram that is no frame."""
    try:
        frame = read_any_datagram(octets)
    except FrameError:
        return None, None
    return frame, lives.get(frame.life) if frame.kind is not Kind.HELLO else None


def believed(counterpart: Counterpart, frame: AnyFrame) -> Frame | None:
    """A provider's frame as this host takes it, opened; None if it does not."""
    return None if counterpart.belief is None else counterpart.belief.take(frame)


def hear(counterpart: Counterpart, frame: Frame, host: InletHost) -> bool:
    """Gives a message or an end to the subscriber. False for a sealed one that has no floor yet, which counts as dropped."""
    belief = counterpart.belief
    if frame.is_sealed and belief is not None:
        floor = belief.floor
        if floor is None:
            host.drop()
            return False
        if frame.kind is Kind.MESSAGE and frame.sequence <= floor:
            host.drop()
            return True
    host.hear(counterpart, frame)
    return True
