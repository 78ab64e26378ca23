"""The connections of a subscriber to its providers over TCP, which have a limited number of places."""

from __future__ import annotations

import asyncio
from typing import Protocol

from ..protocol.counterparts import Counterpart, Key
from ..protocol.frame import Frame
from ..protocol.frame_writer import ConsumerFrames
from ..protocol.limits import MAX_TCP_PROVIDERS, UNCONNECTED_SECONDS
from ..protocol.places import Places
from .tcp_inlet import TcpInlet
from .udp_inlet import InletHost


class TcpInletsHost(InletHost, Protocol):
    """The part of a subscriber that its connections tell of what happens."""

    def connected(self, key: Key) -> None:
        """The connection to a provider is open."""

    def lost(self, key: Key) -> bool:
        """The connection to a provider ended or failed. Whether it is to be made again."""

    def ended(self, key: Key) -> None:
        """A provider has said its end, or was withdrawn and says nothing more."""

    def no_place(self, what: str, count: int) -> None:
        """A newcomer found all places taken."""

    def places_again(self) -> None:
        """Enough places are free again."""


class TcpInlets:
    """Keeps a connection for each provider that has a place; the others wait for one. Belongs to an event loop; not thread-safe."""

    def __init__(self, loop: asyncio.AbstractEventLoop, frames: ConsumerFrames, host: TcpInletsHost) -> None:
        self._loop = loop
        self._frames = frames
        self._host = host
        self._inlets: dict[Key, TcpInlet] = {}
        self._counterparts: dict[Key, Counterpart] = {}
        self._resting: dict[Key, TcpInlet] = {}  # of providers that were withdrawn
        self._places: Places[Key] = Places(MAX_TCP_PROVIDERS)
        self._waiting: dict[Key, Counterpart] = {}
        self._unconnected: dict[Key, float] = {}  # since when
        self._timer: asyncio.TimerHandle | None = None
        self._is_paused = False

    def open(self, counterpart: Counterpart) -> None:
        """Connects to a provider at the address and port that it has now, when there is a place."""
        key, match = counterpart.key, counterpart.match
        inlet = self._inlets.get(key)
        if inlet is not None and inlet.place == (match.address, match.port):
            inlet.rekeyed()
            return
        self._stop(key)
        took, loser = self._places.take(key, match.address)
        if loser is not None:
            self._wait(loser, self._counterparts[loser])
        if took:
            self._start(counterpart)
        else:
            self._wait(key, counterpart)
        if self._waiting:
            self._host.no_place("providers over TCP", MAX_TCP_PROVIDERS)

    def withdrawn(self, counterpart: Counterpart) -> bool:
        """The provider was withdrawn: reads up to its end, of which ended() tells. False if there is nothing to read."""
        inlet = self._inlets.get(counterpart.key)
        if inlet is None or not inlet.is_connected:
            return False
        del self._inlets[counterpart.key]
        self._unconnected.pop(counterpart.key, None)
        self._resting[counterpart.key] = inlet
        inlet.rest()
        return True

    def close(self, counterpart: Counterpart) -> None:
        """Forgets a provider."""
        self._stop(counterpart.key)
        self._next()

    def pause(self) -> None:
        """Stops reading."""
        self._is_paused = True
        for inlet in [*self._inlets.values(), *self._resting.values()]:
            inlet.pause()

    def resume(self) -> None:
        """Reads again."""
        self._is_paused = False
        for inlet in [*self._inlets.values(), *self._resting.values()]:
            inlet.resume()

    def abort(self) -> None:
        """Closes all connections."""
        if self._timer is not None:
            self._timer.cancel()
        for inlet in [*self._inlets.values(), *self._resting.values()]:
            inlet.close()
        self._inlets.clear()
        self._resting.clear()
        self._waiting.clear()

    # Calls of the connections

    def hear(self, counterpart: Counterpart, frame: Frame) -> None:
        """A message or an end has come that is believed."""
        self._places.serve(counterpart.key)
        self._host.hear(counterpart, frame)

    def hear_datagram(self, counterpart: Counterpart, octets: bytes) -> None:
        """Is not called."""

    def drop(self) -> None:
        """Octets were not believed."""
        self._host.drop()

    def find(self) -> None:
        """A frame is believed that was dropped."""
        self._host.find()

    def full(self, counterpart: Counterpart) -> None:
        """The provider has no place for this consumer."""
        self._host.full(counterpart)

    def failed(self, error: Exception) -> None:
        """No frame can be sent any more."""
        self._host.failed(error)

    def connected(self, key: Key) -> None:
        """The connection to a provider is open."""
        self._unconnected.pop(key, None)
        self._host.connected(key)

    def lost(self, key: Key) -> bool:
        """The connection to a provider ended or failed. Whether it is to be made again."""
        if not self._host.lost(key):
            return False
        self._unconnected.setdefault(key, self._loop.time())
        self._set_timer()
        return True

    def ended(self, key: Key) -> None:
        """A provider has said its end, or was withdrawn and says nothing more."""
        self._stop(key)
        self._host.ended(key)
        self._next()

    # Inside

    def _start(self, counterpart: Counterpart) -> None:
        assert counterpart.belief is not None
        key = counterpart.key
        self._counterparts[key] = counterpart
        self._unconnected[key] = self._loop.time()
        inlet = self._inlets[key] = TcpInlet(self._loop, self._frames, counterpart, counterpart.belief, self)
        if self._is_paused:
            inlet.pause()

    def _stop(self, key: Key) -> None:
        for inlets in (self._inlets, self._resting):
            inlet = inlets.pop(key, None)
            if inlet is not None:
                inlet.close()
        self._unconnected.pop(key, None)
        self._waiting.pop(key, None)
        self._counterparts.pop(key, None)
        self._places.leave(key)

    def _wait(self, key: Key, counterpart: Counterpart) -> None:
        """A provider waits for a place behind the others."""
        self._stop(key)
        self._waiting[key] = counterpart
        self._set_timer()

    def _next(self) -> None:
        """Gives free places to those that wait, in turn."""
        while self._waiting and not self._places.is_full:
            key = next(iter(self._waiting))
            counterpart = self._waiting.pop(key)
            self._places.take(key, counterpart.match.address)
            self._start(counterpart)
        if self._places.has_room_again:
            self._host.places_again()

    def _set_timer(self) -> None:
        if self._waiting and self._unconnected and self._timer is None:
            due = min(self._unconnected.values()) + UNCONNECTED_SECONDS
            self._timer = self._loop.call_at(due, self._tick)

    def _tick(self) -> None:
        """Takes the places of providers that are not connected, for others that wait."""
        self._timer = None
        now = self._loop.time()
        late = [key for key, since in self._unconnected.items() if now - since >= UNCONNECTED_SECONDS]
        for key in late[: len(self._waiting)]:
            self._wait(key, self._counterparts[key])
        self._next()
        self._set_timer()
