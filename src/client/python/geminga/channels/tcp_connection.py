"""One TCP connection of a channel, with the frames that wait to be written."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections.abc import Callable, Sequence

from ..protocol.frame_reader import BrokenStream, FrameReader
from ..protocol.limits import LEAVING_SECONDS, MAX_STREAM_PAYLOAD
from ..protocol.sealed_frame import AnyFrame
from ..protocol.send_queue import Pool, SendQueue, SharedFrame
from .outlet import COPIED_OCTETS

_READ_OCTETS = 256 * 1024


class TcpConnection:
    """Gives frames to `on_frame`, in order, and calls `on_end` once, unless close() was called. Not thread-safe.

    The frames that wait count in `pool`, which is that of all connections of a publisher.
    """

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        sock: socket.socket,
        on_frame: Callable[[AnyFrame], None],
        on_end: Callable[[], None],
        max_payload: int = MAX_STREAM_PAYLOAD,
        pool: Pool | None = None,
    ) -> None:
        self._loop = loop
        self._sock = sock
        self._send = sock.send
        self._sendmsg = sock.sendmsg
        self._on_frame = on_frame
        self._on_end = on_end
        self._reader = FrameReader(max_payload)
        self._queue = SendQueue(pool or Pool())
        self.took_at = 0.0  #: when the other side took something last, or something began to wait; only while something waits
        self.is_open = True
        self.is_broken = False  #: octets came that are no frame
        self._is_finishing = False
        self._is_paused = False
        self._timer: asyncio.TimerHandle | None = None
        self._waiters: list[asyncio.Future[None]] = []
        sock.setblocking(False)
        with contextlib.suppress(OSError):
            sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        loop.add_reader(sock, self._read)

    @property
    def waiting_octets(self) -> int:
        """The octets that wait to be written."""
        return self._queue.octets

    def offer(self, frame: SharedFrame) -> bool:
        """Sends a frame, or keeps it until there is room. False if too much waits already."""
        if not self._queue:
            sent = self._sent(frame.pieces)
            if sent < frame.octets:
                self._keep(frame, sent)
            return True
        if not self._queue.has_room_for(frame.octets):
            return False
        self._keep(frame, 0)
        return True

    def append(self, octets: bytes) -> None:
        """Sends a small frame after those that wait, however many these are."""
        if not self.is_open:
            return
        sent = 0 if self._queue else self._sent((octets,))
        if self.is_open and sent < len(octets):
            self._keep(SharedFrame(octets), sent)

    def dismiss(self, octets: bytes) -> None:
        """Sends a last small frame in the place of those that wait, and closes."""
        self._queue.clear(keeps_begun=True)
        self.append(octets)
        self.finish()

    async def drain(self) -> None:
        """Waits until everything is written, or the connection ends."""
        await self._until(lambda: not self._queue)

    async def closed(self) -> None:
        """Waits until the connection ends."""
        await self._until(lambda: False)

    def finish(self) -> None:
        """Closes our half after the frames that wait, and the connection when the other half is closed, or after 5 s without progress."""
        if self.is_open and not self._is_finishing:
            self._is_finishing = True
            self._progress()
            if not self._queue:
                self._shut_down()

    def pause(self) -> None:
        """Stops reading, which holds the sender back."""
        if self.is_open and not self._is_paused:
            self._is_paused = True
            self._loop.remove_reader(self._sock)

    def resume(self) -> None:
        """Reads again."""
        if self.is_open and self._is_paused:
            self._is_paused = False
            self._loop.add_reader(self._sock, self._read)

    def close(self) -> None:
        """Closes at once. No function is called after that."""
        if not self.is_open:
            return
        self.is_open = False
        if self._timer is not None:
            self._timer.cancel()
        self._loop.remove_reader(self._sock)
        self._loop.remove_writer(self._sock)
        self._sock.close()
        self._queue.clear()
        self._wake()

    def _end(self) -> None:
        if self.is_open:
            self.close()
            self._on_end()

    def _read(self) -> None:
        try:
            octets = self._sock.recv(_READ_OCTETS)
        except (BlockingIOError, InterruptedError):
            return
        except OSError:
            octets = b""
        if not octets:
            self._end()
            return
        try:
            frames = self._reader.feed(octets)
        except BrokenStream as error:
            frames, self.is_broken = error.frames, True
        for frame in frames:
            if self.is_open:
                self._on_frame(frame)
        if self.is_broken:
            self._end()

    def _sent(self, pieces: Sequence[bytes | memoryview]) -> int:
        """Sends what the system takes now, and says how much that is."""
        try:
            return self._send(pieces[0]) if len(pieces) == 1 else self._sendmsg(pieces)
        except (BlockingIOError, InterruptedError):
            return 0
        except OSError:
            # The event loop tells the end, not a call of send().
            self._loop.call_soon(self._end)
            return sum(map(len, pieces))

    def _keep(self, frame: SharedFrame, sent: int) -> None:
        if not self._queue:
            self._loop.add_writer(self._sock, self._write)
            self.took_at = self._loop.time()
        self._queue.put(frame, sent)

    def _write(self) -> None:
        took = False
        while self._queue and self.is_open:
            sent = self._sent(self._queue.pieces())
            if not self.is_open:
                return
            took = took or sent > 0
            if not self._queue.took(sent):
                break
        if took:
            self.took_at = self._loop.time()
        if self._is_finishing:
            self._progress()
        if not self._queue:
            self._loop.remove_writer(self._sock)
            if self._is_finishing:
                self._shut_down()
        self._wake()

    def _shut_down(self) -> None:
        try:
            self._sock.shutdown(socket.SHUT_WR)
        except OSError:
            self._loop.call_soon(self._end)

    def _progress(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
        self._timer = self._loop.call_later(LEAVING_SECONDS, self._end)

    async def _until(self, is_so: Callable[[], bool]) -> None:
        while self.is_open and not is_so():
            waiter: asyncio.Future[None] = self._loop.create_future()
            self._waiters.append(waiter)
            await waiter

    def _wake(self) -> None:
        waiters, self._waiters = self._waiters, []
        for waiter in waiters:
            if not waiter.done():
                waiter.set_result(None)


def shared(header: bytes, body: bytes) -> SharedFrame:
    """A frame to offer to many connections. A small one is one piece, because that costs less than two."""
    return SharedFrame(header + body) if len(body) <= COPIED_OCTETS else SharedFrame(header, body)
