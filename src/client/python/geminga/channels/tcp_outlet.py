"""The outlet of a publisher over TCP: it listens, and a connection becomes a consumer by its hello."""

from __future__ import annotations

import asyncio
import socket
from collections.abc import Callable

from ..protocol.counterparts import Counterpart
from ..protocol.frame import Frame, Kind, write_frame
from ..protocol.limits import MAX_STRANGERS, MAX_TCP_CONSUMERS, STRANGER_SECONDS
from . import sockets
from .tcp_connection import TcpConnection

ACCEPT_AGAIN_SECONDS = 0.5


class _Stranger:
    """A connection that has not said hello, or whose consumer the daemon has not named yet."""

    def __init__(self, timer: asyncio.TimerHandle) -> None:
        self.life = 0
        self.timer = timer
        self.connection: TcpConnection | None = None


class TcpOutlet:
    """The connections of a publisher's consumers.

    With `admits_all`, for `otm/stream`, any life that is not 0 is a consumer's; otherwise the lives of open() are. `joined` and `left`
    are called with the life of a consumer when its connection comes and goes.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        life: int,
        port: int,
        address: str,
        admits_all: bool,
        joined: Callable[[int], None],
        left: Callable[[int], None],
    ) -> None:
        self._loop = loop
        self._life = life
        self._admits_all = admits_all
        self._joined = joined
        self._left = left
        self._listener = sockets.listening(port, address)
        self.port = sockets.port_of(self._listener)
        self.targets: dict[int, TcpConnection] = {}
        self.sole = None
        self.dropped = 0
        self._expected: set[int] = set()
        self._strangers: list[_Stranger] = []
        self._leaving: set[TcpConnection] = set()
        self._retry: asyncio.TimerHandle | None = None
        loop.add_reader(self._listener, self._accept)

    def open(self, counterpart: Counterpart) -> None:
        """Expects the connection of a consumer, which may have come already."""
        life = counterpart.match.life
        if life == 0:
            return
        self._expected.add(life)
        waiting = next((one for one in self._strangers if one.life == life), None)
        if waiting is not None:
            self._admit(waiting)

    def close(self, counterpart: Counterpart) -> None:
        """Sends the frames that wait for a consumer, and closes its connection."""
        life = counterpart.match.life
        self._expected.discard(life)
        connection = self.targets.pop(life, None)
        if connection is not None:
            self._leave(connection)

    def send(self, header: bytes, payload: bytes) -> int:
        """Sends to all consumers that are connected. Returns for how many it was left out."""
        left_out = 0
        for connection in self.targets.values():
            if not connection.offer(header, payload):
                left_out += 1
        return left_out

    async def drain(self) -> None:
        """Waits until the system has taken everything for each consumer."""
        await asyncio.sleep(0)
        for connection in list(self.targets.values()):
            await connection.drain()

    async def end(self, last: int) -> None:
        """Writes the frames that wait and a frame of kind 3 to each consumer, and waits until all have closed."""
        self._stop_listening()
        frame = write_frame(Kind.END, self._life, last)
        for connection in self.targets.values():
            connection.append(frame)
            self._leave(connection)
        self.targets = {}
        try:
            for connection in list(self._leaving):
                await connection.closed()
        finally:
            self.abort()

    def abort(self) -> None:
        """Closes at once."""
        self._stop_listening()
        for connection in [*self.targets.values(), *self._leaving]:
            connection.close()
        self.targets = {}
        self._leaving.clear()

    def _stop_listening(self) -> None:
        if self._retry is not None:
            self._retry.cancel()
        if self._listener.fileno() >= 0:
            self._loop.remove_reader(self._listener)
            self._listener.close()
        for stranger in list(self._strangers):
            self._dismiss(stranger)

    def _leave(self, connection: TcpConnection) -> None:
        self._leaving.add(connection)
        connection.finish()

    def _accept(self) -> None:
        try:
            sock, _ = self._listener.accept()
        except (BlockingIOError, InterruptedError, ConnectionError):
            return
        except OSError:
            # No descriptor is left: accepting pauses, so that the loop is not kept busy.
            self._loop.remove_reader(self._listener)
            self._retry = self._loop.call_later(ACCEPT_AGAIN_SECONDS, self._listen_again)
            return
        if len(self._strangers) >= MAX_STRANGERS:
            self._dismiss(self._strangers[0])
            self.dropped += 1
        self._welcome(sock)

    def _listen_again(self) -> None:
        self._retry = None
        self._loop.add_reader(self._listener, self._accept)

    def _welcome(self, sock: socket.socket) -> None:
        stranger = _Stranger(self._loop.call_later(STRANGER_SECONDS, lambda: self._dismiss(stranger)))
        stranger.connection = TcpConnection(
            self._loop, sock, lambda frame: self._heard(stranger, frame), lambda: self._ended(stranger), max_payload=0
        )
        self._strangers.append(stranger)

    def _heard(self, stranger: _Stranger, frame: Frame) -> None:
        if frame.kind is not Kind.HELLO or stranger.life:
            self.dropped += 1
            return
        stranger.life = frame.life
        if self._admits_all or frame.life in self._expected:
            self._admit(stranger)

    def _admit(self, stranger: _Stranger) -> None:
        connection = stranger.connection
        assert connection is not None
        before = self.targets.get(stranger.life)
        if before is None and len(self.targets) >= MAX_TCP_CONSUMERS:
            self.dropped += 1
            self._dismiss(stranger)
            return
        self._strangers.remove(stranger)
        stranger.timer.cancel()
        if before is not None:
            before.close()
        self.targets[stranger.life] = connection
        if before is None:
            self._joined(stranger.life)

    def _dismiss(self, stranger: _Stranger) -> None:
        if stranger in self._strangers:
            self._strangers.remove(stranger)
        stranger.timer.cancel()
        if stranger.connection is not None:
            stranger.connection.close()

    def _ended(self, stranger: _Stranger) -> None:
        connection = stranger.connection
        assert connection is not None
        if stranger in self._strangers:
            self._dismiss(stranger)
        self._leaving.discard(connection)
        if self.targets.get(stranger.life) is connection:
            del self.targets[stranger.life]
            self._left(stranger.life)
