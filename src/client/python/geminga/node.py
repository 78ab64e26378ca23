"""A node: the publishers and subscribers of one program, which go on while its daemon is restarted."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import AsyncIterator, Callable, Mapping
from types import TracebackType

from .channels.daemon_link import DaemonLink
from .channels.endpoint import endpoints
from .errors import Closed, GemingaError, Refused
from .happening import Connected, ConsumerChanged, Disconnected, Happening, Problem, ProviderChanged
from .log import Log, LogHook
from .opening import Channel, Opening
from .parameters import Attributes, Words, checked, parameters
from .protocol.channel_keys import mode_takes_plain
from .protocol.converter import Conversion
from .protocol.counter import ForkError, Process
from .protocol.limits import MAX_WAITING_EVENTS, MAX_WAITING_MESSAGES
from .protocol.match import Match
from .protocol.report import Asked, Complaint, Keyed, Report, Sealing, Settled, Told, Welcome
from .protocol.request import IDENTITY_KEYS, Request
from .protocol.session import Session
from .protocol.statement import ErrorLine
from .providers import Providers
from .publisher import Publisher
from .request_owner import RequestOwner
from .subscriber import Subscriber

#: The most subscriptions of `otm/stream` for which a node may ask for room (src/discovery/gcnp/GCNP.md, "Room").
MAX_ROOM = 16_384

OnEvent = Callable[[Happening], None]


class Node:
    """Made by geminga.connect(), used by `async with`. Belongs to the event loop where it is entered; not thread-safe.

    The daemon may start later, end and come back: the node states its requests again, and channels go on meanwhile.
    """

    def __init__(
        self,
        name: str | None = None,
        connect: str | None = None,
        on_event: OnEvent | None = None,
        room: int = 0,
        log: LogHook | None = None,
    ) -> None:
        if name == "":
            raise ValueError("name is empty: leave it out, or say what the node is called")
        if not 0 <= room <= MAX_ROOM:
            raise ValueError(f"room is 0 to {MAX_ROOM}, not {room}")
        self._endpoints = endpoints(connect)
        self._session = Session(name or "", room)
        self._on_event = on_event
        self._log = Log(log, lambda error: self._failed("the log hook", error))
        self._process = Process.number
        self.has_keys: bool | None = None  #: whether the daemon has keys; None until it has said so
        self.takes_plain = False  #: whether this host takes plain frames
        self._link: DaemonLink | None = None
        self._owners: dict[int, RequestOwner] = {}
        self._asking: dict[int, asyncio.Future[None]] = {}
        self._readers: list[_Happenings] = []
        self._is_closed = False
        self.loop: asyncio.AbstractEventLoop

    async def __aenter__(self) -> Node:
        await self.open()
        return self

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        await self.close()

    async def open(self) -> None:
        """Looks for the daemon. Returns after the first attempt, and goes on looking if that failed. `async with` calls it."""
        self.loop = asyncio.get_running_loop()
        self._link = DaemonLink(self.loop, self._session, self._endpoints, self._take, self._lost, self._log.say)
        try:
            await self._link.attempted
        except BaseException:
            self._link.abort()
            raise

    @property
    def is_connected(self) -> bool:
        """Whether the daemon is there."""
        return self._link is not None and self._link.is_connected

    def publish(
        self,
        *,
        mode: str,
        id: int | None = None,
        text: str | None = None,
        concept: str | None = None,
        representation: str | None = None,
        protocol: str = "udp",
        port: int = 0,
        address: str | None = None,
        priority: int | None = None,
        scope: Words | None = None,
        for_: str | None = None,
        attributes: Attributes | None = None,
    ) -> Opening[Publisher]:
        """Offers a service: `await` the result, or enter it. The keys are those of `pub create`; port 0 means any.

        Returns when the daemon has accepted it, or at once if there is no daemon. Raises Refused; PortTaken; ValueError and TypeError for
        values that cannot be stated.
        """
        said = parameters(
            attributes, mode=mode, id=id, text=text, concept=concept, representation=representation, protocol=protocol,
            port=port, address=address, priority=priority, scope=scope, for_=for_,
        )  # fmt: skip
        checked(said, 1, port=port, id=id, priority=priority)
        return Opening(self._make(lambda: Publisher(self, said)))

    def subscribe(
        self,
        *,
        mode: str,
        id: int | None = None,
        text: str | None = None,
        concept: str | None = None,
        representation: str | None = None,
        match: str | None = None,
        provider: Words | None = None,
        favour: Words | None = None,
        prefer: Words | None = None,
        rank: Words | None = None,
        scope: Words | None = None,
        on: str | None = None,
        where: str | None = None,
        convert: str | int | None = None,
        reach: str | None = None,
        conversions: Mapping[str, Conversion] | None = None,
        protocol: Words | None = None,
        limit: int | None = None,
        priority: int | None = None,
        port: int = 0,
        address: str | None = None,
        attributes: Attributes | None = None,
        queue: int = MAX_WAITING_MESSAGES,
        keep: str = "newest",
    ) -> Opening[Subscriber]:
        """Asks for services: `await` the result, or enter it. The keys are those of `sub create`; port 0 means any.

        `reach="any"` also takes services whose address cannot be reached from this host. `conversions` are functions from octets to octets by `A>B`, with the names that events use. Subscriber explains `queue` and
        `keep`. Raises as publish() does.
        """
        said = parameters(
            attributes, mode=mode, id=id, text=text, concept=concept, representation=representation, match=match,
            provider=provider, favour=favour, prefer=prefer, rank=rank, scope=scope, on=on, where=where,
            convert=convert, reach=reach, protocol=protocol, limit=limit, priority=priority, port=port or None,
            address=address,
        )  # fmt: skip
        checked(said, 2, port=port, id=id, priority=priority, limit=limit)
        return Opening(self._make(lambda: Subscriber(self, said, conversions, queue, keep)))

    async def events(self) -> AsyncIterator[Happening]:
        """The events from now on, until the node is closed.

        At most 4096 happenings wait; for one more the oldest is thrown away, and a Problem of no source says how many were.
        """
        reader = _Happenings()
        self._readers.append(reader)
        try:
            while True:
                while (happening := reader.take()) is not None:
                    yield happening
                if self._is_closed:
                    return
                reader.woken = self.loop.create_future()
                await reader.woken
        finally:
            self._readers.remove(reader)

    async def close(self) -> None:
        """Withdraws everything, and waits until TCP consumers have all messages."""
        if self._is_closed or self._link is None:
            return
        if Process.number != self._process:
            raise GemingaError(str(ForkError()))
        self._is_closed = True
        try:
            await asyncio.gather(*(owner.close() for owner in list(self._owners.values())))
            await self._link.close()
        finally:
            for owner in list(self._owners.values()):
                owner.abort()
            self._link.abort()
            self._wake_readers()

    # Calls of publishers and subscribers

    def create(self, owner: RequestOwner, command: str, said: dict[str, str]) -> Request:
        """States a request of this owner."""
        request = self._session.create(command, said).request
        self._owners[request.number] = owner
        self._flush()
        return request

    async def modify(self, request: Request, changes: dict[str, str]) -> None:
        """Changes a request. Raises Refused."""
        asked = self._session.modify(request, changes)
        self._flush()
        if asked is not None:
            future = self._asking[id(asked)] = self.loop.create_future()
            try:
                await future
            finally:
                self._asking.pop(id(asked), None)

    def remove(self, request: Request) -> None:
        """Withdraws a request."""
        self._owners.pop(request.number, None)
        self._session.remove(request)
        self._flush()

    def tell_problem(self, owner: RequestOwner, text: str) -> None:
        """Tells the application of a problem of a publisher or subscriber."""
        assert isinstance(owner, (Publisher, Subscriber))
        self.tell(Problem(owner, text))

    def tell_consumer(self, publisher: Publisher, change: str, consumer: Match, reason: str) -> None:
        """Tells the application what became of a consumer."""
        self.tell(ConsumerChanged(publisher, change, consumer, reason))

    def tell_provider(self, subscriber: Providers, change: str, provider: Match, reason: str) -> None:
        """Tells the application what became of a provider."""
        assert isinstance(subscriber, Subscriber)
        self.tell(ProviderChanged(subscriber, change, provider, reason))

    def tell(self, happening: Happening) -> None:
        """Tells the application. A problem is also said on the log hook."""
        if isinstance(happening, Problem):
            self._log.say(happening.text)
        if self._on_event is not None:
            try:
                self._on_event(happening)
            except Exception as error:  # An exception of the application; the channels go on.
                self._failed("on_event", error)
        for reader in self._readers:
            if reader.put(happening):
                self._log.say("1 events were thrown away: take them more often")
        self._wake_readers()

    # Inside

    def _failed(self, what: str, error: Exception) -> None:
        """A function of the application has raised an exception."""
        self.loop.call_exception_handler({"message": f"{what} failed", "exception": error})

    async def _make(self, make: Callable[[], Channel]) -> Channel:
        if self._is_closed or self._link is None:
            raise Closed("the node is not open")
        if Process.number != self._process:
            raise GemingaError(str(ForkError()))
        channel = make()
        if self._link.is_connected:
            try:
                await channel.accepted()
            except BaseException:
                channel.abort()
                raise
        return channel

    def _flush(self) -> None:
        if self._link is not None and Process.number == self._process:
            self._link.flush()

    def _wake_readers(self) -> None:
        for reader in self._readers:
            if reader.woken is not None and not reader.woken.done():
                reader.woken.set_result(None)

    def _take(self, report: Report) -> None:
        if isinstance(report, Welcome):
            self.tell(Connected(report.participant, report.participant_name))
            self.has_keys = report.sealing != "plain"
            for owner in list(self._owners.values()):
                owner.daemon_back(self.has_keys)
            self._learn(report.sealing)
        elif isinstance(report, Told):
            told = self._owners.get(report.request.number)
            if told is not None:
                told.told(report.line)
        elif isinstance(report, Keyed):
            keyed = self._owners.get(report.request.number)
            if keyed is not None:
                keyed.keyed(report.life, report.keys, report.text)
        elif isinstance(report, Sealing):
            self._learn(report.mode)
        elif isinstance(report, Settled):
            self._settle(report.asked, report.error)
        elif isinstance(report, Complaint):
            self._complain(report)

    def _learn(self, mode: str) -> None:
        """The daemon has said how this host seals. It counts for channels that have no line of keys."""
        self.has_keys, self.takes_plain = mode != "plain", mode_takes_plain(mode)
        for owner in list(self._owners.values()):
            owner.mode_changed()

    def _settle(self, asked: Asked, error: ErrorLine | None) -> None:
        if error is not None:
            self._log.say(f"the request {_shown(asked.request)} is refused: {error.text}")
        if asked.before is None:
            owner = self._owners.get(asked.request.number)
            if owner is not None:
                owner.settled(error)
            return
        future = self._asking.get(id(asked))
        if future is not None and not future.done():
            if error is None:
                future.set_result(None)
            else:
                future.set_exception(Refused(error.code, error.text))

    def _complain(self, complaint: Complaint) -> None:
        owner = None if complaint.request is None else self._owners.get(complaint.request.number)
        if owner is not None:
            owner.complain(complaint.error, complaint.is_gone)
        else:
            self.tell(Problem(None, f"{complaint.error.code} {complaint.error.text}"))

    def _lost(self) -> None:
        for owner in list(self._owners.values()):
            owner.daemon_lost()
        if not self._is_closed:
            self.tell(Disconnected())


def _shown(request: Request) -> str:
    """The mode and the identity of a request, by which a person knows it."""
    said = request.parameters
    return " ".join(f"{key}={said[key]}" for key in ("mode", *IDENTITY_KEYS) if key in said)


class _Happenings:
    """The events that wait for one reader."""

    def __init__(self) -> None:
        self._waiting: deque[Happening] = deque(maxlen=MAX_WAITING_EVENTS)
        self.lost = 0
        self.woken: asyncio.Future[None] | None = None

    def put(self, happening: Happening) -> bool:
        """Keeps a happening, in the place of the oldest where there is no other. Whether it is the first that is lost since take()."""
        is_full = len(self._waiting) == MAX_WAITING_EVENTS
        self.lost += is_full
        self._waiting.append(happening)
        return is_full and self.lost == 1

    def take(self) -> Happening | None:
        """The next happening, after the news of those that were thrown away."""
        if self.lost:
            lost, self.lost = self.lost, 0
            return Problem(None, f"{lost} events were thrown away: take them more often")
        return self._waiting.popleft() if self._waiting else None
