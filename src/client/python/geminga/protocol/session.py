"""The conversation with a daemon, without a socket: lines to send, and the meaning of the lines that come."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator

from .channel_keys import KeysError, read_channel_keys
from .cipher import SealingMissing
from .life import read_life
from .line_reader import LineReader
from .report import Asked, Complaint, Keyed, Report, Sealing, Settled, Told, Welcome
from .request import Request, State, changed
from .statement import ErrorLine, LineError, Statement, read_line, write_line

#: Requests that may be stated before the daemon has answered.
MAX_UNANSWERED = 256
#: Codes of errors that leave a request as it is.
_HARMLESS = (409,)
_STOPPING = 503


class Session:
    """The session of a node, over all its connections. Octets to send gather in `outgoing`. Not thread-safe."""

    def __init__(self, name: str, room: int = 0) -> None:
        self._name = name
        self._room = room
        self._reader = LineReader()
        self._last_number = 0
        self._requests: dict[int, Request] = {}
        self._creates: dict[int, Asked] = {}
        self._waiting: deque[Asked] = deque()  # to be stated when fewer are unanswered
        self._unanswered: deque[Asked | None] = deque()  # one for each ping; None if an error came before its pong
        self._is_welcome = False
        self._has_asked_for_room = False
        self.is_open = False
        self.outgoing = bytearray()

    # The connection

    def open(self) -> None:
        """A connection is open: says hello, and states all requests."""
        self._reader = LineReader()
        self.outgoing.clear()
        self.is_open, self._is_welcome = True, False
        self._hello(self._room)
        self._waiting = deque(self._asked_again(request) for request in self._requests.values())
        self._state_more()

    def close(self) -> list[Report]:
        """The connection is lost. Changes without an answer count as accepted, because the requests will be stated with them."""
        settled: list[Report] = [
            Settled(asked, None) for asked in self._unanswered if asked is not None and asked.before is not None
        ]
        self._unanswered.clear()
        self._waiting.clear()
        self.outgoing.clear()
        self.is_open = self._is_welcome = False
        for request in self._requests.values():
            request.state = State.WAITING
        return settled

    def receive(self, octets: bytes) -> Iterator[Report]:
        """Reports about octets of the daemon. Raises LineError if they are not GCNP: close the connection."""
        for line in self._reader.feed(octets):
            yield from self._take(read_line(line))

    def bye(self) -> None:
        """Says goodbye, which withdraws everything."""
        if self.is_open:
            self._say(Statement(0, "sys", "bye"))

    # Requests

    def create(self, command: str, parameters: dict[str, str]) -> Asked:
        """Makes a request, which is stated at once or when a daemon is there. Raises LineError for a value that GCNP cannot carry."""
        number = self._last_number + 1
        write_line(Statement(number, command, "create", dict(parameters)))
        self._last_number = number
        request = Request(number, command, dict(parameters))
        self._requests[number] = request
        asked = self._asked_again(request)
        if self.is_open:
            self._waiting.append(asked)
            self._state_more()
        return asked

    def modify(self, request: Request, changes: dict[str, str]) -> Asked | None:
        """Changes a request. None if no daemon has it now: then it will be stated with the change. Raises LineError."""
        write_line(request.modify(changes))
        before = request.parameters
        request.parameters = changed(before, changes)
        if not self.is_open or request.state not in (State.STATED, State.TAKEN):
            return None
        asked = Asked(request, before)
        self._say(request.modify(changes))
        self._ask(asked)
        return asked

    def remove(self, request: Request) -> None:
        """Withdraws a request. No report about it follows."""
        if self.is_open and request.state in (State.STATED, State.TAKEN):
            self._say(request.remove())
        request.state = State.REMOVED
        self._requests.pop(request.number, None)
        self._creates.pop(request.number, None)

    # Inside

    def _hello(self, room: int) -> None:
        said: dict[str, str | None] = {"name": self._name} if self._name else {}
        if room:
            said["room"] = str(room)
        said["keys"] = "yes"
        self._has_asked_for_room = bool(room)
        self._say(Statement(0, "sys", "hello", said))

    def _asked_again(self, request: Request) -> Asked:
        asked = self._creates.get(request.number)
        if asked is None:
            asked = self._creates[request.number] = Asked(request, None)
        return asked

    def _state_more(self) -> None:
        while self._waiting and len(self._unanswered) < MAX_UNANSWERED:
            asked = self._waiting.popleft()
            if asked.request.is_wanted:
                self._say(asked.request.create())
                asked.request.state = State.STATED
                self._ask(asked)

    def _ask(self, asked: Asked) -> None:
        # The daemon answers the ping after everything before it, so an error comes before the pong.
        self._say(Statement(0, "sys", "ping"))
        self._unanswered.append(asked)

    def _say(self, statement: Statement) -> None:
        self.outgoing += write_line(statement)

    def _take(self, line: Statement | ErrorLine) -> Iterator[Report]:
        if isinstance(line, ErrorLine):
            yield from self._take_error(line)
        elif not self._is_welcome:
            if line.id != 0 or line.command != "msg" or line.subcommand != "hello":
                raise LineError("what listens there does not speak GCNP")
            self._is_welcome = True
            sealing = line.get("sealing") if line.get("keys") == "yes" else ""
            yield Welcome(line.get("participant"), line.get("participant_name"), sealing or "plain")
        elif line.command == "msg":
            if line.subcommand == "pong" and self._unanswered:
                asked = self._unanswered.popleft()
                if asked is not None:
                    yield from self._settle(asked, None)
                self._state_more()
            elif line.subcommand == "sealing":
                yield Sealing(line.get("mode", "plain"))
        elif line.command == "pub" and line.subcommand == "keys":
            yield from self._take_keys(line)
        elif line.command in ("pub", "sub") and line.subcommand in ("add", "modify", "del"):
            request = self._requests.get(line.id)
            # Events of a subscription are about publications, and the other way round.
            if request is not None and request.command != line.command:
                yield Told(request, line)

    def _take_keys(self, line: Statement) -> Iterator[Report]:
        """Takes keys, which go to the owner of the request and nowhere else."""
        request = self._requests.get(line.id)
        if request is None:
            return
        try:
            life, keys = read_channel_keys(line)
        except (KeysError, SealingMissing) as error:
            yield Keyed(request, read_life(line.get("life")), None, str(error))
            return
        yield Keyed(request, life, keys)

    def _settle(self, asked: Asked, error: ErrorLine | None) -> Iterator[Report]:
        request = asked.request
        if asked.before is None:
            self._creates.pop(request.number, None)
            if error is None and request.state is State.STATED:
                request.state = State.TAKEN
        yield Settled(asked, error)

    def _take_error(self, error: ErrorLine) -> Iterator[Report]:
        request = self._requests.get(error.id)
        if request is None:
            if error.id == 0:
                yield Complaint(None, error, False)
                if not self._is_welcome and self._has_asked_for_room:
                    self._hello(0)  # The daemon goes on with the room of every client.
            return
        if error.code == _STOPPING:  # It will be stated again.
            yield Complaint(request, error, False)
            return
        is_gone = error.code not in _HARMLESS
        asked = next((one for one in self._unanswered if one is not None and one.request is request), None)
        if asked is None or not is_gone:
            if is_gone:
                self._forget(request)
            yield Complaint(request, error, is_gone)
            return
        self._unanswered[self._unanswered.index(asked)] = None
        if asked.before is not None:
            request.parameters = asked.before
            yield Settled(asked, error)
        else:
            yield from self._settle(asked, error)
            self._forget(request)

    def _forget(self, request: Request) -> None:
        request.state = State.REFUSED
        self._requests.pop(request.number, None)
