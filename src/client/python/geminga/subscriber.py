"""A subscriber: a request for services with a channel, which receives from its providers."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Mapping
from types import TracebackType

from .errors import Closed
from .protocol.converter import Conversion, ConversionError, convert
from .protocol.counterparts import Counterpart
from .protocol.inbox import Inbox, Message
from .protocol.limits import MAX_WAITING_MESSAGES
from .providers import Providers, ProvidersHost


class Subscriber(Providers):
    """Made by Node.subscribe(). Belongs to the event loop of its node; not thread-safe.

    An inbox holds `queue` messages and 16 MiB, but always one. When it is full, TCP providers are not read, and of UDP the oldest message
    is lost for a new one, or the new one with `keep="oldest"`. The next message says in `missed` how many were lost.
    """

    def __init__(
        self,
        node: ProvidersHost,
        said: dict[str, str],
        conversions: Mapping[str, Conversion] | None = None,
        queue: int = MAX_WAITING_MESSAGES,
        keep: str = "newest",
    ) -> None:
        if keep not in ("newest", "oldest"):
            raise ValueError("keep is newest or oldest")
        self._inbox = Inbox(queue, keep == "newest")
        super().__init__(node, said)
        self._conversions = dict(conversions or {})
        self._waiters: deque[asyncio.Future[None]] = deque()
        self._is_paused = False
        self._received = 0
        try:
            self.state("sub", said)
        except BaseException:
            self._close_all()
            raise

    @property
    def received(self) -> int:
        """The messages that were received or wait for that."""
        return self._received

    async def receive(self, timeout: float | None = None) -> Message:
        """The next message. Raises TimeoutError after so many seconds, and Closed when the subscriber is closed and none is left.

        No message is lost if it is cancelled.
        """
        if timeout is None or len(self._inbox):
            return await self._receive()
        async with asyncio.timeout(timeout):
            return await self._receive()

    async def _receive(self) -> Message:
        while not len(self._inbox):
            if self._is_closed:
                raise Closed("the subscriber has been closed")
            waiter: asyncio.Future[None] = self._loop.create_future()
            self._waiters.append(waiter)
            try:
                await waiter
            except asyncio.CancelledError:
                # A waiter that was woken and cancelled wakes the next one.
                if waiter.done() and not waiter.cancelled():
                    self._wake()
                raise
        return self._take()

    def receive_now(self) -> Message | None:
        """The next message that is here already, or None."""
        return self._take() if len(self._inbox) else None

    def __aiter__(self) -> Subscriber:
        return self

    async def __anext__(self) -> Message:
        try:
            return await self.receive()
        except Closed:
            raise StopAsyncIteration from None

    async def close(self) -> None:
        """Withdraws the request. Messages that have come can still be received."""
        self.abort()

    def abort(self) -> None:
        """Withdraws the request at once."""
        if not self._is_closed:
            self._leave()
        self._close_all()
        while self._waiters:
            self._wake()

    async def __aenter__(self) -> Subscriber:
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    # Inside: messages

    def _deliver(self, counterpart: Counterpart, payload: bytes, life: int, sequence: int, missed: int) -> None:
        if counterpart.match.convert:
            try:
                payload = convert(payload, counterpart.match.convert, self._conversions, counterpart.match.via)
            except ConversionError as error:
                self._dropped += 1
                self._complain(counterpart, error.step, str(error))
                return
        self._received += 1
        message = Message(payload, life, sequence, missed)
        if counterpart.match.protocol == "tcp":
            self._inbox.put_streamed(message)
        else:
            lost = self._inbox.put_datagram(message)
            self._received -= lost
            self._missed += lost
        if self._inbox.is_full and not self._is_paused:
            self._is_paused = True
            self._tcp.pause()
        if self._waiters:
            self._wake()

    def _take(self) -> Message:
        message = self._inbox.take()
        if self._is_paused and self._inbox.has_room:
            self._is_paused = False
            self._tcp.resume()
        return message

    def _wake(self) -> None:
        while self._waiters:
            waiter = self._waiters.popleft()
            if not waiter.done():
                waiter.set_result(None)
                return
