"""The multicast groups of a subscriber: a socket for each group and port."""

from __future__ import annotations

import asyncio
import socket

from ..protocol.counterparts import Counterpart, Key
from ..protocol.frame import Kind
from ..protocol.limits import INTERFACES_SECONDS
from ..protocol.sealed_frame import OpenedFrame
from . import multicast, sockets
from .interfaces import interfaces
from .sockets import Address
from .udp_inlet import DATAGRAMS_AT_END, InletHost, UdpInlet, believed, hear, sort

_DATAGRAMS_A_TURN = 64

Place = tuple[str, int]


class _Group:
    def __init__(self, sock: socket.socket) -> None:
        self.sock = sock
        self.lives: dict[int, Counterpart] = {}


class MulticastInlet:
    """Believes a datagram by the sender's port and the life, because the announced address is the group's. A sealed one is believed when
    `udp` has asked for a floor."""

    def __init__(self, loop: asyncio.AbstractEventLoop, udp: UdpInlet | None, host: InletHost) -> None:
        self._loop = loop
        self._udp = udp
        self._host = host
        self._groups: dict[Place, _Group] = {}
        self._places: dict[Key, Place] = {}
        self._timer: asyncio.TimerHandle | None = None

    def open(self, counterpart: Counterpart) -> None:
        """Joins the provider's group. Raises OSError if that is not possible."""
        place = (counterpart.match.address, counterpart.match.port)
        known = self._groups.get(place)
        if known is not None and known.lives.get(counterpart.match.life) is counterpart:
            return
        self.close(counterpart)
        group = self._groups.get(place)
        if group is None:
            group = self._groups[place] = _Group(multicast.listening(*place))
            self._loop.add_reader(group.sock, self._read, place)
        group.lives[counterpart.match.life] = counterpart
        self._places[counterpart.key] = place
        self._join_all()

    def close(self, counterpart: Counterpart) -> None:
        """Forgets a provider, and leaves the group after its last one."""
        place = self._places.pop(counterpart.key, None)
        group = self._groups.get(place) if place is not None else None
        if group is None or place is None:
            return
        group.lives = {life: one for life, one in group.lives.items() if one is not counterpart}
        if not group.lives:
            del self._groups[place]
            self._close_socket(group)

    def read_all(self) -> None:
        """Reads what the sockets hold now, but not without end."""
        for place in list(self._groups):
            for _ in range(DATAGRAMS_AT_END // _DATAGRAMS_A_TURN):
                if not self._read(place):
                    break

    def abort(self) -> None:
        """Closes all sockets."""
        if self._timer is not None:
            self._timer.cancel()
        for group in self._groups.values():
            self._close_socket(group)
        self._groups.clear()
        self._places.clear()

    def _close_socket(self, group: _Group) -> None:
        self._loop.remove_reader(group.sock)
        sockets.close(group.sock)

    def _join_all(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        for (address, _), group in self._groups.items():
            for index in interfaces():
                multicast.join(group.sock, address, index)
        if self._groups:
            self._timer = self._loop.call_later(INTERFACES_SECONDS, self._join_all)

    def _read(self, place: Place) -> bool:
        for _ in range(_DATAGRAMS_A_TURN):
            group = self._groups.get(place)
            if group is None:
                return False
            try:
                octets, source = group.sock.recvfrom(65_536)
            except OSError:
                return False
            if source[1] == place[1]:
                self._heard(octets, source, group.lives)
            else:
                self._host.drop()
        return True

    def _heard(self, octets: bytes, source: Address, lives: dict[int, Counterpart]) -> None:
        read, counterpart = sort(octets, lives)
        if read is None or counterpart is None:
            if 0 in lives:
                self._host.hear_datagram(lives[0], octets)
            else:
                self._host.drop()
            return
        frame = believed(counterpart, read)
        if frame is None or frame.kind not in (Kind.MESSAGE, Kind.END):
            self._host.drop()
        elif not hear(counterpart, frame, self._host) and self._udp is not None and isinstance(frame, OpenedFrame):
            self._udp.keep(frame)
            self._udp.ask(counterpart, sockets.written(source), frame.port)
