"""The link of a node to its daemon, which connects again whenever the connection is lost."""

from __future__ import annotations

import asyncio
import contextlib
import os
import random
import socket
from collections.abc import Callable

from ..protocol.backoff import Backoff
from ..protocol.limits import AWAY_SECONDS
from ..protocol.report import Report, Welcome
from ..protocol.session import Session
from ..protocol.statement import LineError
from .endpoint import VARIABLE, Endpoint

#: Seconds to wait for a connection, and for the answer to hello.
ANSWER_SECONDS = 5.0


class _Lines(asyncio.Protocol):
    def __init__(self, link: DaemonLink) -> None:
        self._link = link
        self.closed = asyncio.get_running_loop().create_future()

    def data_received(self, octets: bytes) -> None:
        self._link.received(octets)

    def connection_lost(self, error: Exception | None) -> None:
        if not self.closed.done():
            self.closed.set_result(None)


class DaemonLink:
    """Calls `report` with reports of the session, and `lost` when the daemon is gone. Belongs to an event loop; not thread-safe."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        session: Session,
        endpoints: tuple[Endpoint, ...],
        report: Callable[[Report], None],
        lost: Callable[[], None],
        log: Callable[[str], None],
    ) -> None:
        self._loop = loop
        self._session = session
        self._endpoints = endpoints
        self._report = report
        self._lost = lost
        self._log = log
        self._transport: asyncio.Transport | None = None
        self._backoff = Backoff(random.random)
        self._failure = "no answer"  #: why the daemon was not reached last
        self._is_away_said = False
        self._away = loop.call_later(AWAY_SECONDS, self._say_away)
        self.is_connected = False
        #: Done when the daemon has been reached, or was not at the first attempt.
        self.attempted: asyncio.Future[None] = loop.create_future()
        self._task = loop.create_task(self._run())

    def flush(self) -> None:
        """Sends the outgoing octets of the session."""
        if self._session.outgoing and self._transport is not None:
            self._transport.write(bytes(self._session.outgoing))
        self._session.outgoing.clear()

    def received(self, octets: bytes) -> None:
        """Takes octets of the daemon."""
        try:
            for report in self._session.receive(octets):
                if isinstance(report, Welcome):
                    self.is_connected = True
                    self._backoff.reset()
                    self._say_back()
                    self._attempt()
                self._report(report)
        except LineError:
            if self._transport is not None:
                self._transport.abort()
        self.flush()

    async def close(self) -> None:
        """Says goodbye, and waits until the daemon has closed the connection."""
        self._session.bye()
        self.flush()
        transport, self._transport = self._transport, None
        if transport is not None:
            transport.close()
            protocol = transport.get_protocol()
            assert isinstance(protocol, _Lines)
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(asyncio.shield(protocol.closed), ANSWER_SECONDS)
        self.abort()

    def abort(self) -> None:
        """Closes at once. The daemon withdraws the requests of this node when it sees that."""
        self._task.cancel()
        self._away.cancel()
        self._attempt()
        if self._transport is not None:
            self._transport.abort()
            self._transport = None

    async def _run(self) -> None:
        while True:
            sock = await self._reach()
            if sock is not None:
                await self._talk(sock)
            self._attempt()
            await asyncio.sleep(self._backoff.seconds())

    async def _reach(self) -> socket.socket | None:
        for endpoint in self._endpoints:
            try:
                sock = socket.socket(endpoint.family, socket.SOCK_STREAM)
            except OSError as error:
                self._failure = error.strerror or "no socket"
                continue
            try:
                sock.setblocking(False)
                async with asyncio.timeout(ANSWER_SECONDS):
                    await self._loop.sock_connect(sock, endpoint.address)
                return sock
            except OSError as error:  # TimeoutError is a subclass.
                self._failure = os.strerror(error.errno) if error.errno else "no answer"
                sock.close()
            except BaseException:
                sock.close()
                raise
        return None

    async def _talk(self, sock: socket.socket) -> None:
        transport, protocol = await self._loop.create_connection(lambda: _Lines(self), sock=sock)
        self._transport = transport
        self._failure = "no answer"
        self._session.open()
        self.flush()
        timer = self._loop.call_later(ANSWER_SECONDS, self._look)
        try:
            await protocol.closed
        finally:
            timer.cancel()
            transport.abort()
            self._transport = None
        for report in self._session.close():
            self._report(report)
        if self.is_connected:
            self.is_connected = False
            self._away = self._loop.call_later(AWAY_SECONDS, self._say_away)
            self._lost()

    def _say_away(self) -> None:
        self._is_away_said = True
        there = f"no daemon at {self._endpoints[0]} for {AWAY_SECONDS:.0f} s ({self._failure})"
        self._log(f"{there}: start gemingad, or say where it is with {VARIABLE}")

    def _say_back(self) -> None:
        self._away.cancel()
        if self._is_away_said:
            self._is_away_said = False
            self._log(f"the daemon at {self._endpoints[0]} answers")

    def _attempt(self) -> None:
        if not self.attempted.done():
            self.attempted.set_result(None)

    def _look(self) -> None:
        """Closes the connection to a daemon that has not answered hello."""
        if not self.is_connected and self._transport is not None:
            self._transport.abort()
