"""The inlet of a subscriber over TCP: one connection to each provider, made again while the provider is matched."""

from __future__ import annotations

import asyncio
import random
import socket
from collections.abc import Callable

from ..protocol.backoff import Backoff
from ..protocol.counterparts import Counterpart, Key
from ..protocol.frame import Frame, Kind, write_frame
from ..protocol.limits import DRAIN_SECONDS
from . import sockets
from .tcp_connection import TcpConnection



class TcpInlet:
    """The connection to one provider.

    `on_message` gets its messages and its end. `on_end` is called when it has ended for good, with whether that was clean. `on_lost` is
    called when the connection is lost, and says whether it is to be made again.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        life: int,
        counterpart: Counterpart,
        on_message: Callable[[Counterpart, Frame], None],
        on_connected: Callable[[Key], None],
        on_lost: Callable[[Key], bool],
        on_end: Callable[[Key, bool], None],
        on_drop: Callable[[], None],
    ) -> None:
        self._loop = loop
        self._life = life
        self._counterpart = counterpart
        self.place = (counterpart.match.address, counterpart.match.port)
        self._on_message = on_message
        self._on_connected = on_connected
        self._on_lost = on_lost
        self._on_end = on_end
        self._on_drop = on_drop
        self._connection: TcpConnection | None = None
        self._is_ended = False
        self._rest: asyncio.TimerHandle | None = None
        self._came = False
        self._is_paused = False
        self._task = loop.create_task(self._run())

    def rest(self) -> None:
        """The provider was withdrawn: reads up to its end, or until nothing comes for two seconds."""
        if self._connection is None:
            self._finish(False)
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
            self._finish(False)

    def _finish(self, was_clean: bool) -> None:
        if not self._is_ended:
            self.close()
            self._on_end(self._counterpart.key, was_clean)

    async def _run(self) -> None:
        backoff = Backoff(random.random)
        while not self._is_ended:
            connection = await self._connect()
            if connection is not None:
                await connection.closed()
                self._connection = None
                if connection.is_broken:
                    self._on_drop()
                if self._came:
                    backoff.reset()
                if self._is_ended:
                    return
                if self._rest is not None:
                    self._finish(False)
                    return
            if not self._on_lost(self._counterpart.key):
                return
            await asyncio.sleep(backoff.seconds())

    async def _connect(self) -> TcpConnection | None:
        there = sockets.connectable(*self.place)
        if there is None or self.place[1] == 0:
            return None
        family, address = there
        sock = socket.socket(family, socket.SOCK_STREAM)
        sock.setblocking(False)
        try:
            await self._loop.sock_connect(sock, address)
        except OSError:
            sock.close()
            return None
        except BaseException:
            sock.close()
            raise
        self._connection = TcpConnection(self._loop, sock, self._heard, lambda: None)
        self._connection.append(write_frame(Kind.HELLO, self._life, 0))
        if self._is_paused:
            self._connection.pause()
        self._on_connected(self._counterpart.key)
        return self._connection

    def _heard(self, frame: Frame) -> None:
        if frame.life != self._counterpart.match.life or frame.kind is Kind.HELLO:
            self._on_drop()
            return
        self._came = True
        if frame.kind is Kind.END:
            self._on_message(self._counterpart, frame)
            self._finish(True)
        else:
            self._on_message(self._counterpart, frame)
