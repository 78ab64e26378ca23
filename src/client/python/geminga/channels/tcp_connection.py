"""One TCP connection of a channel, with the frames that wait to be written."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections import deque
from collections.abc import Callable

from ..protocol.frame import HEADER_OCTETS, Frame
from ..protocol.frame_reader import BrokenStream, FrameReader
from ..protocol.limits import LEAVING_SECONDS, MAX_STREAM_PAYLOAD, MAX_WAITING_FOR_CONSUMER
from .outlet import COPIED_OCTETS

_READ_OCTETS = 256 * 1024


class TcpConnection:
    """Gives frames to `on_frame`, in order, and calls `on_end` once, unless close() was called. Not thread-safe."""

    def __init__(
        self,
        loop: asyncio.AbstractEventLoop,
        sock: socket.socket,
        on_frame: Callable[[Frame], None],
        on_end: Callable[[], None],
        max_payload: int = MAX_STREAM_PAYLOAD,
    ) -> None:
        self._loop = loop
        self._sock = sock
        self._send = sock.send
        self._sendmsg = sock.sendmsg
        self._on_frame = on_frame
        self._on_end = on_end
        self._reader = FrameReader(max_payload)
        self._waiting: deque[memoryview] = deque()
        self.waiting_octets = 0
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

    def offer(self, header: bytes, payload: bytes) -> bool:
        """Sends a frame, or keeps it until there is room. False if too much waits already."""
        if not self._waiting:
            size = len(payload)
            try:  # As in _sent(), but without another call, which senders would notice.
                if size <= COPIED_OCTETS:
                    sent = self._send(header + payload)
                else:
                    sent = self._sendmsg((header, payload))
            except OSError as error:
                sent = self._unsent(error, HEADER_OCTETS + size)
            sent -= HEADER_OCTETS
            if sent < 0:
                self._keep(memoryview(header)[sent:])
            if max(sent, 0) < size:
                self._keep(memoryview(payload)[max(sent, 0) :])
            return True
        if self.waiting_octets + HEADER_OCTETS + len(payload) > MAX_WAITING_FOR_CONSUMER:
            return False
        self._keep(memoryview(header + payload))
        return True

    def append(self, frame: bytes) -> None:
        """Sends a small frame after those that wait, however many these are."""
        if not self._waiting and self.is_open:
            sent = self._sent(frame)
            if sent == len(frame):
                return
            frame = frame[sent:]
        if self.is_open:
            self._keep(memoryview(frame))

    async def drain(self) -> None:
        """Waits until everything is written, or the connection ends."""
        await self._until(lambda: not self._waiting)

    async def closed(self) -> None:
        """Waits until the connection ends."""
        await self._until(lambda: False)

    def finish(self) -> None:
        """Closes our half after the frames that wait, and the connection when the other half is closed, or after 5 s without progress."""
        if self.is_open and not self._is_finishing:
            self._is_finishing = True
            self._progress()
            if not self._waiting:
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
        self._waiting.clear()
        self.waiting_octets = 0
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

    def _sent(self, octets: bytes | memoryview) -> int:
        try:
            return self._send(octets)
        except OSError as error:
            return self._unsent(error, len(octets))

    def _unsent(self, error: OSError, size: int) -> int:
        if isinstance(error, (BlockingIOError, InterruptedError)):
            return 0
        # The event loop tells the end, not a call of send().
        self._loop.call_soon(self._end)
        return size

    def _keep(self, octets: memoryview) -> None:
        if not self._waiting:
            self._loop.add_writer(self._sock, self._write)
        self._waiting.append(octets)
        self.waiting_octets += len(octets)

    def _write(self) -> None:
        while self._waiting and self.is_open:
            octets = self._waiting[0]
            sent = self._sent(octets)
            if not self.is_open:
                return
            self.waiting_octets -= sent
            if sent < len(octets):
                self._waiting[0] = octets[sent:]
                break
            self._waiting.popleft()
        if self._is_finishing:
            self._progress()
        if not self._waiting:
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
