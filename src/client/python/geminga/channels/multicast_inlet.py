"""The multicast groups of a subscriber: a socket for each group and port."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from ..protocol.counterparts import Counterpart, Key
from ..protocol.frame import Frame
from ..protocol.limits import INTERFACES_SECONDS
from . import multicast, sockets
from .interfaces import interfaces
from .udp_inlet import DATAGRAMS_AT_END, dispatch

_DATAGRAMS_A_TURN = 64

Place = tuple[str, int]


class _Group:
    def __init__(self, sock: socket.socket) -> None:
        self.sock = sock
        self.lives: dict[int, Counterpart] = {}


class MulticastInlet:
    """Believes a datagram by the sender's port and the life, because the announced address is the group's."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        on_message: Callable[[Counterpart, Frame], None],
        on_datagram: Callable[[Counterpart, bytes], None],
        on_end: Callable[[Key, bool], None],
        on_drop: Callable[[], None],
    ) -> None:
        self._loop = loop
        self._on_message = on_message
        self._on_datagram = on_datagram
        self._on_end = on_end
        self._on_drop = on_drop
        self._groups: dict[Place, _Group] = {}
        self._places: dict[Key, Place] = {}
        self._timer: asyncio.TimerHandle | None = None

    def open(self, counterpart: Counterpart) -> None:
        """Joins the provider's group. Raises OSError if that is not possible."""
        self.close(counterpart)
        place = (counterpart.match.address, counterpart.match.port)
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
                dispatch(octets, group.lives, self._on_message, self._on_datagram, self._on_end, self._on_drop)
            else:
                self._on_drop()
        return True
