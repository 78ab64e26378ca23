"""The blocking front, for programs without an event loop.

    with geminga.blocking.connect("vision") as node:
        with node.subscribe(concept="soccer:BallInfo", mode="otm/pubsub") as balls:
            for ball in balls:
                print(ball.payload)

This front has no thread: sockets are served while one of its calls runs, and about every 10 ms by send() and receive_now(). A
program that does something else for more than 2 s calls Node.wait() meanwhile; otherwise providers of `otm/stream` forget it as a
listener. Ctrl+C ends a call with KeyboardInterrupt, and no message is lost by that. Not thread-safe: a node, its publishers and
its subscribers belong to one thread.
"""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine, Iterator
from time import monotonic
from types import TracebackType
from typing import Any, Generic, TypeVar

from . import node as front
from . import publisher, subscriber
from .errors import Closed, GemingaError
from .log import LogHook
from .node import OnEvent
from .parameters import Attributes
from .protocol.counter import ForkError, Process
from .protocol.inbox import Message
from .protocol.match import Match

#: Seconds between two turns of the event loop by send() and receive_now().
SERVE_SECONDS = 0.01

Result = TypeVar("Result")
Front = TypeVar("Front", bound=publisher.Publisher | subscriber.Subscriber)


class _Served:
    """An event loop that runs within calls only."""

    def __init__(self) -> None:
        self.runner = asyncio.Runner(loop_factory=asyncio.new_event_loop)
        self.loop = self.runner.get_loop()
        self.serve_at = 0.0  #: the time of the next turn
        self._process = Process.number

    def run(self, work: Coroutine[Any, Any, Result], timeout: float | None = None) -> Result:
        """Runs a coroutine to its end. Raises TimeoutError after so many seconds."""
        if Process.number != self._process:
            work.close()
            raise GemingaError(str(ForkError()))

        async def within() -> Result:
            async with asyncio.timeout(timeout):
                return await work

        result = self.runner.run(within())
        self.serve_at = monotonic() + SERVE_SECONDS
        return result

    def serve(self) -> None:
        """Lets the event loop turn once, unless it has done so lately."""
        if monotonic() >= self.serve_at:
            self.run(asyncio.sleep(0))


class _Channel(Generic[Front]):
    def __init__(self, served: _Served, channel: Front) -> None:
        self._served = served
        self._front = channel

    @property
    def life(self) -> int:
        """The 64 bits by which the other side knows this channel."""
        return self._front.life

    @property
    def is_closed(self) -> bool:
        """Whether it has been closed."""
        return self._front.is_closed

    def accepted(self, timeout: float | None = None) -> None:
        """Waits until the daemon has accepted the request. Raises Refused, Closed or TimeoutError."""
        self._served.run(self._front.accepted(), timeout)

    def modify(self, attributes: Attributes | None = None, timeout: float | None = None, **keys: object) -> None:
        """Changes the keys and attributes of the request, as the asyncio front does."""
        self._served.run(self._front.modify(attributes, **keys), timeout)

    def close(self) -> None:
        """Withdraws the request. A publisher over TCP waits until its consumers have all messages, 5 s for one that takes nothing."""
        self._served.run(self._front.close())

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if not self._served.loop.is_closed():
            self.close()


class Publisher(_Channel[publisher.Publisher]):
    """Made by Node.publish(). A context manager, which closes it."""

    def __enter__(self) -> Publisher:
        return self

    @property
    def port(self) -> int:
        """The port where it can be reached."""
        return self._front.port

    @property
    def consumers(self) -> list[Match]:
        """The consumers that the daemon has named; none for `otm/stream`."""
        return self._front.consumers

    @property
    def has_consumers(self) -> bool:
        """Whether there is a consumer. Always true for multicast."""
        self._served.serve()
        return self._front.has_consumers

    @property
    def sent(self) -> int:
        """The messages that were sent while there was a consumer."""
        return self._front.sent

    @property
    def left_out(self) -> int:
        """The messages that were left out for a consumer without room, counted for each consumer."""
        return self._front.left_out

    def send(self, payload: publisher.Octets) -> bool:
        """Sends to all consumers, and never waits. Whether there are any. Raises MessageTooLarge and Closed."""
        if monotonic() >= self._served.serve_at:
            self._served.serve()
        return self._front.send(payload)

    def drain(self, timeout: float | None = None) -> None:
        """Waits until the system has taken all messages to TCP consumers. Raises TimeoutError."""
        self._served.run(self._front.drain(), timeout)


class Subscriber(_Channel[subscriber.Subscriber]):
    """Made by Node.subscribe(). A context manager, which closes it, and an iterator over messages."""

    def __enter__(self) -> Subscriber:
        return self

    @property
    def providers(self) -> list[Match]:
        """The providers that are matched."""
        return self._front.providers

    @property
    def received(self) -> int:
        """The messages that were received or wait for that."""
        return self._front.received

    @property
    def missed(self) -> int:
        """The messages that are known to be missing, those lost in a full queue with them."""
        return self._front.missed

    @property
    def dropped(self) -> int:
        """The datagrams and frames that were not believed or could not be converted."""
        return self._front.dropped

    def receive(self, timeout: float | None = None) -> Message:
        """The next message. Raises TimeoutError after so many seconds, and Closed."""
        message = self.receive_now()
        return self._served.run(self._front.receive(), timeout) if message is None else message

    def receive_now(self) -> Message | None:
        """The next message that is here already, or None."""
        self._served.serve()
        return self._front.receive_now()

    def __iter__(self) -> Iterator[Message]:
        while True:
            try:
                yield self.receive()
            except Closed:
                return


class Node:
    """Made by connect(). A context manager, which withdraws everything at its end."""

    def __init__(self, name: str | None, connect: str | None, on_event: OnEvent | None, room: int, log: LogHook | None) -> None:
        self._front = front.Node(name, connect, on_event, room, log)
        self._served: _Served | None = None

    def __enter__(self) -> Node:
        self._served = _Served()
        self._served.run(self._front.open())
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    @property
    def is_connected(self) -> bool:
        """Whether the daemon is there."""
        return self._front.is_connected

    def publish(self, *, mode: str, timeout: float | None = None, **keys: Any) -> Publisher:
        """Offers a service. The arguments are those of geminga.Node.publish(); raises TimeoutError besides."""
        return Publisher(self._here(), self._here().run(self._made(self._front.publish(mode=mode, **keys)), timeout))

    def subscribe(self, *, mode: str, timeout: float | None = None, **keys: Any) -> Subscriber:
        """Asks for services. The arguments are those of geminga.Node.subscribe(); raises TimeoutError besides."""
        return Subscriber(self._here(), self._here().run(self._made(self._front.subscribe(mode=mode, **keys)), timeout))

    def wait(self, seconds: float) -> None:
        """Serves the sockets for so many seconds. `on_event` is called meanwhile, as in every call."""
        self._here().run(asyncio.sleep(seconds))

    def close(self) -> None:
        """Withdraws everything, and waits until TCP consumers have all messages."""
        served, self._served = self._served, None
        if served is not None:
            try:
                served.run(self._front.close())
            finally:
                served.runner.close()

    async def _made(self, opening: Any) -> Any:
        return await opening

    def _here(self) -> _Served:
        if self._served is None:
            raise Closed("the node is not open")
        return self._served


def connect(
    name: str | None = None,
    connect: str | None = None,
    on_event: OnEvent | None = None,
    room: int = 0,
    log: LogHook | None = None,
) -> Node:
    """A node as that of geminga.connect(), to be entered by `with`. `on_event` is called within calls of this front."""
    return Node(name, connect, on_event, room, log)
