"""The inlet of a subscriber over TCP: one connection to each provider, made again while the provider is matched."""

from __future__ import annotations

import asyncio
import random
import socket
from typing import Protocol

from ..protocol.backoff import Backoff
from ..protocol.belief import AGAIN, FORGED, FULL, Belief
from ..protocol.counter import CounterError, ForkError
from ..protocol.counterparts import Counterpart, Key
from ..protocol.frame import Kind
from ..protocol.frame_writer import ConsumerFrames
from ..protocol.limits import DRAIN_SECONDS
from ..protocol.sealed_frame import AnyFrame
from . import sockets
from .tcp_connection import TcpConnection
from .udp_inlet import InletHost, believed, hear


class TcpInletHost(InletHost, Protocol):
    """The part of a subscriber that its connections tell of what happens."""

    def connected(self, key: Key) -> None:
        """The connection to a provider is open."""

    def lost(self, key: Key) -> bool:
        """The connection to a provider ended or failed. Whether it is to be made again."""

    def ended(self, key: Key) -> None:
        """A provider that was withdrawn has said its end, or nothing for two seconds."""


class TcpInlet:
    """The connection to one provider, whose messages and end go to `host`."""

    def __init__(
        self, loop: asyncio.AbstractEventLoop, frames: ConsumerFrames, counterpart: Counterpart, belief: Belief, host: TcpInletHost
    ) -> None:
        self._loop = loop
        self._frames = frames
        self._counterpart = counterpart
        self._belief = belief
        self.place = (counterpart.match.address, counterpart.match.port)
        self._host = host
        self._connection: TcpConnection | None = None
        self._is_ended = False
        self._rest: asyncio.TimerHandle | None = None
        self._came = False
        self._mode = ""  #: in which the last hello was said
        self._is_paused = False
        self._task = loop.create_task(self._run())

    @property
    def is_connected(self) -> bool:
        """Whether the connection is open."""
        return self._connection is not None

    def rest(self) -> None:
        """The provider was withdrawn: reads up to its end, or until nothing comes for two seconds."""
        if self._connection is None:
            self._finish()
            return
        self._came = False
        self._rest = self._loop.call_later(DRAIN_SECONDS, self._look)

    def pause(self) -> None:
        """Stops reading."""
        self._is_paused = True
        if self._connection is not None:
            self._connection.pause()

    def resume(self) -> None:
        """Reads again."""
        self._is_paused = False
        if self._connection is not None:
            self._connection.resume()

    def rekeyed(self) -> None:
        """Other keys may be in force, or another mode. A connection that says nothing that is believed is made again."""
        keys = self._belief.keys
        if keys is not None and keys.mode != self._mode and not keys.takes_plain and self._belief.floor is None:
            self._break()

    def close(self) -> None:
        """Closes at once. No function is called after that."""
        self._is_ended = True
        self._task.cancel()
        if self._rest is not None:
            self._rest.cancel()
        if self._connection is not None:
            self._connection.close()
            self._connection = None

    def _look(self) -> None:
        if self._came or self._is_paused:
            self.rest()
        else:
            self._finish()

    def _finish(self) -> None:
        if not self._is_ended:
            self.close()
            self._host.ended(self._counterpart.key)

    def _break(self) -> None:
        """Ends this connection; another one is made."""
        if self._connection is not None:
            self._connection.close()

    async def _run(self) -> None:
        backoff = Backoff(random.random)
        while not self._is_ended:
            connection = await self._connect()
            if connection is not None:
                await connection.closed()
                self._connection = None
                if connection.is_broken:
                    self._host.drop()
                if self._came:
                    backoff.reset()
                if self._is_ended:
                    return
                if self._rest is not None:
                    self._finish()
                    return
            if not self._host.lost(self._counterpart.key):
                return
            await asyncio.sleep(backoff.seconds())

    async def _connect(self) -> TcpConnection | None:
        there = sockets.connectable(*self.place)
        if there is None or self.place[1] == 0:
            return None
        family, address = there
        try:
            sock = socket.socket(family, socket.SOCK_STREAM)
        except OSError:
            return None  # No descriptor is left.
        sock.setblocking(False)
        try:
            await self._loop.sock_connect(sock, address)
        except OSError:
            sock.close()
            return None
        except BaseException:
            sock.close()
            raise
        self._came = False
        self._connection = TcpConnection(self._loop, sock, self._heard, lambda: None)
        self._belief.greet()
        self._hello()
        if self._is_paused:
            self._connection.pause()
        self._host.connected(self._counterpart.key)
        return self._connection

    def _hello(self) -> None:
        if self._belief.keys is None or self._connection is None:
            return
        try:
            octets = self._frames.write(self._belief.keys, Kind.HELLO, self._belief.hello())
        except (CounterError, ForkError) as error:
            self._host.failed(error)
            return
        self._mode = self._belief.keys.mode
        self._connection.append(octets)

    def _heard(self, octets: AnyFrame) -> None:
        if octets.life != self._counterpart.match.life or octets.kind is Kind.HELLO:
            self._host.drop()
            return
        frame = believed(self._counterpart, octets)
        if frame is None:
            self._host.drop()
            self._break()  # Nothing behind it can be believed.
        elif frame.kind in (Kind.FLOOR, Kind.FULL):
            outcome = self._belief.answered(frame)
            if outcome == FORGED:
                self._host.drop()
            elif outcome == FULL:
                self._host.full(self._counterpart)
            elif outcome == AGAIN:
                self._hello()
        elif not hear(self._counterpart, frame, self._host):
            self._break()  # A floor comes before the messages of the next connection.
        else:
            self._came = True
            if frame.kind is Kind.END:
                self._finish()
