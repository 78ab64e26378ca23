"""The base of publishers and subscribers: a request, a life, and counterparts."""

from __future__ import annotations

import asyncio
from typing import Protocol

from .errors import Closed, Refused
from .parameters import Attributes, changes_of
from .protocol.channel_keys import ChannelKeys
from .protocol.counterparts import Change, Counterparts
from .protocol.life import KEY, draw_life, write_life
from .protocol.match import Match, read_match
from .protocol.request import Request
from .protocol.reserved import PREFIX
from .protocol.statement import ErrorLine, Statement

class Host(Protocol):
    """The part of a node that the owner of a request uses."""

    loop: asyncio.AbstractEventLoop
    has_keys: bool | None  #: whether the daemon has keys; None until it has said so
    takes_plain: bool  #: whether this host takes plain frames

    def create(self, owner: RequestOwner, command: str, said: dict[str, str]) -> Request:
        """States a request of this owner."""

    async def modify(self, request: Request, changes: dict[str, str]) -> None:
        """Changes a request. Raises Refused."""

    def remove(self, request: Request) -> None:
        """Withdraws a request."""

    def tell_problem(self, owner: RequestOwner, text: str) -> None:
        """Tells the application of a problem of this owner."""


class RequestOwner:
    """The base of Publisher and Subscriber. Belongs to the event loop of its node; not thread-safe."""

    def __init__(self, node: Host, counterparts: Counterparts) -> None:
        self._node = node
        self._loop = node.loop
        self._life = draw_life()
        self._counterparts = counterparts
        self._request: Request | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._is_closed = False
        self._has_no_places = False
        self._told: set[str] = set()
        self._accepted: asyncio.Future[None] = self._loop.create_future()
        self._accepted.add_done_callback(lambda future: future.cancelled() or future.exception())

    @property
    def life(self) -> int:
        """The 64 bits by which the other side knows this channel."""
        return self._life

    @property
    def is_closed(self) -> bool:
        """Whether it has been closed."""
        return self._is_closed

    async def accepted(self) -> None:
        """Waits until a daemon has accepted the request, however long that takes. Raises Refused or Closed."""
        await asyncio.shield(self._accepted)

    async def modify(self, attributes: Attributes | None = None, **keys: object) -> None:
        """Changes keys of `pub modify` or `sub modify` and attributes. An empty text takes a key back.

        Waits for the answer of the daemon if there is one. Mode, protocol, port, address and limit cannot be changed. Raises Refused,
        ValueError, TypeError for an unknown key, or Closed.
        """
        if self._is_closed or self._request is None:
            raise Closed("it has been closed")
        await self._node.modify(self._request, changes_of(self._request.command, attributes, keys))

    async def close(self) -> None:
        """Withdraws the request cleanly."""
        raise NotImplementedError

    def abort(self) -> None:
        """Withdraws the request at once."""
        raise NotImplementedError

    # Calls of the node

    def state(self, command: str, said: dict[str, str]) -> None:
        """States the request, with the life. Raises LineError for a value that GCNP cannot carry."""
        said.pop(PREFIX + KEY, None)
        said[KEY] = write_life(self._life)
        self._request = self._node.create(self, command, said)

    def settled(self, error: ErrorLine | None) -> None:
        """The daemon has accepted the request, or refused it."""
        if error is None:
            if not self._accepted.done():
                self._accepted.set_result(None)
            return
        if not self._accepted.done():
            self._accepted.set_exception(Refused(error.code, error.text))
        else:
            self.complain(error, True)

    def complain(self, error: ErrorLine, is_gone: bool) -> None:
        """Tells an error that answers no call."""
        self.problem(f"{error.code} {error.text}")
        if is_gone:
            for counterpart in self._counterparts:
                self._apply(self._counterparts.ended(counterpart.key, "refused"))

    def told(self, line: Statement) -> None:
        """Takes an event of the daemon about this request."""
        if line.subcommand == "del":
            word = line.get("service" if line.command == "pub" else "subscription")
            changes = self._counterparts.delete(word, self._reason(word, line.get("reason")), self._loop.time())
        else:
            match = read_match(line)
            now = self._loop.time()
            changes = self._counterparts.add(match, now) if line.subcommand == "add" else self._counterparts.modify(match, now)
        self._apply(changes)

    def daemon_lost(self) -> None:
        """The daemon is gone; channels go on."""
        self._counterparts.daemon_lost()

    def keyed(self, life: int, keys: ChannelKeys | None, text: str) -> None:
        """The daemon has said which keys a life has. Without keys `text` says why they cannot be used."""
        raise NotImplementedError

    def mode_changed(self) -> None:
        """The daemon has said how this host seals, which counts for channels that have no line of keys."""

    def daemon_back(self, has_keys: bool) -> None:
        """The daemon is back; counterparts that it does not confirm in time become orphans."""
        self._counterparts.daemon_back(self._loop.time())
        self._set_timer()

    def no_place(self, what: str, count: int) -> None:
        """A newcomer found all places taken: tells it once, until there are places again."""
        if not self._has_no_places:
            self._has_no_places = True
            self.problem(f"all {count} places for {what} are taken")

    def places_again(self) -> None:
        """Enough places are free again."""
        self._has_no_places = False

    def problem(self, text: str) -> None:
        """Tells the application of a problem."""
        self._node.tell_problem(self, text)

    # Inside

    def problem_once(self, text: str) -> None:
        """Tells the application of a problem that stays."""
        if text not in self._told:
            self._told.add(text)
            self.problem(text)

    def _reason(self, word: str, reason: str) -> str:
        """The reason of a `del`, as the application is told it."""
        return reason

    def _matches(self) -> list[Match]:
        return [counterpart.match for counterpart in self._counterparts]

    def _apply(self, changes: list[Change]) -> None:
        for change in changes:
            self._change(change)
        self._set_timer()

    def _change(self, change: Change) -> None:
        raise NotImplementedError

    def _set_timer(self) -> None:
        if self._timer is not None:
            self._timer.cancel()
        due = None if self._is_closed else self._counterparts.due()
        self._timer = None if due is None else self._loop.call_at(due, self._tick)

    def _tick(self) -> None:
        self._timer = None
        self._apply(self._counterparts.tick(self._loop.time()))

    def _leave(self) -> None:
        """Withdraws the request."""
        self._is_closed = True
        if self._timer is not None:
            self._timer.cancel()
        if not self._accepted.done():
            self._accepted.set_exception(Closed("it has been closed"))
        if self._request is not None:
            self._node.remove(self._request)
