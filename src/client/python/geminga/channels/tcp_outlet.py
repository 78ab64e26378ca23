"""The outlet of a publisher over TCP: it listens, and a connection becomes a consumer by its hello."""

from __future__ import annotations

import asyncio
import socket

from ..protocol.counterparts import LOST, SLOW, Counterpart
from ..protocol.frame import Frame, Kind
from ..protocol.frame_writer import PublisherFrames
from ..protocol.handshake import PAYLOAD, Handshake, read_handshake
from ..protocol.life import draw_life, write_life
from ..protocol.limits import MAX_STRANGERS, MAX_TCP_CONSUMERS, STRANGER_SECONDS
from ..protocol.places import Places
from ..protocol.sealed_frame import AnyFrame
from ..protocol.send_queue import Pool
from . import sockets
from .outlet import OutletHost
from .reception import counter_of
from .tcp_connection import TcpConnection, shared

ACCEPT_AGAIN_SECONDS = 0.5
ASK_AGAIN_SECONDS = 0.1


class _Client:
    """A connection, which is a stranger until it has said hello and the daemon has named its consumer."""

    def __init__(self, address: str, timer: asyncio.TimerHandle) -> None:
        self.address = address
        self.timer = timer
        self.connection: TcpConnection
        self.first: AnyFrame | None = None  #: a hello that came before the keys
        self.life = 0  #: of the consumer, when its handshake is done
        self.challenge = 0
        self.cookie = 0  #: of the connection, where the handshake has two hellos
        self.counter = 0  #: of its last sealed frame; 0: it says hello plainly
        self.is_left_out = False


class TcpOutlet:
    """The connections of a publisher's consumers.

    With `admits_all`, for `otm/stream`, any life that is not 0 is a consumer's; otherwise the lives of open() are.
    """

    def __init__(
        self, loop: asyncio.AbstractEventLoop, frames: PublisherFrames, port: int, address: str, admits_all: bool, host: OutletHost
    ) -> None:
        self._loop = loop
        self._frames = frames
        self._admits_all = admits_all
        self._host = host
        self._listener = sockets.listening(port, address)
        self.port = sockets.port_of(self._listener)
        self.targets: dict[int, _Client] = {}
        self.sole = None
        self.dropped = 0
        self._pool = Pool()
        self._expected: set[int] = set()
        self._strangers: Places[_Client] = Places(MAX_STRANGERS)
        self._waiting: dict[int, _Client] = {}  # strangers whose handshake is done, by their lives
        self._consumers: Places[_Client] = Places(MAX_TCP_CONSUMERS)
        self._leaving: dict[_Client, None] = {}
        self._retry: asyncio.TimerHandle | None = None
        loop.add_reader(self._listener, self._accept)

    @property
    def waiting_octets(self) -> int:
        """The octets that wait for all consumers, each frame counted once."""
        return self._pool.octets

    def open(self, counterpart: Counterpart) -> None:
        """Expects the connection of a consumer, which may have come already."""
        life = counterpart.match.life
        if life == 0:
            return
        self._expected.add(life)
        waiting = self._waiting.get(life)
        if waiting is not None:
            self._admit(waiting)

    def close(self, counterpart: Counterpart) -> None:
        """Sends the frames that wait for a consumer, and closes its connection."""
        life = counterpart.match.life
        self._expected.discard(life)
        client = self.targets.pop(life, None)
        if client is not None:
            self._leave(client)

    def rekeyed(self, begins_to_seal: bool = False) -> None:
        """Other keys are in force, or another mode. Whoever said no sealed hello is asked for one where that is needed, and has 5 s."""
        if self._frames.keys is None:  # They cannot be used: nothing is sent plain instead.
            for client in [*self.targets.values(), *self._waiting.values()]:
                client.connection.close()
                self._ended(client)
            return
        for client in list(self._waiting.values()):
            if self._frames.is_strict and not client.counter:
                self._refuse(client)
        for client in list(self.targets.values()):
            if self._frames.is_strict and not client.counter:
                self._ask(client)
                self._loop.call_later(STRANGER_SECONDS, self._end_plain, client)
            elif begins_to_seal:
                self._floor(client, 0)
        for client in [one for one in self._strangers if one.first is not None]:
            first, client.first = client.first, None
            if first is not None:
                self._heard(client, first)

    def send(self, header: bytes, body: bytes, payload: bytes) -> int:
        """Sends to all consumers that are connected. Returns for how many it was left out."""
        left_out, frame = 0, shared(header, body)
        for client in self.targets.values():
            if client.connection.offer(frame):
                client.is_left_out = False
            else:
                left_out += 1
                self._left_out(client)
        if self._pool.is_over:
            self._close_slow()
        return left_out

    async def drain(self) -> None:
        """Waits until the system has taken everything for each consumer."""
        await asyncio.sleep(0)
        for client in list(self.targets.values()):
            await client.connection.drain()

    async def end(self) -> None:
        """Sends the frames that wait and a frame of kind 3, and waits until the consumers have closed, but not for ever."""
        self._stop_listening()
        if self.targets:
            frame = self._frames.other(Kind.END)
            for client in self.targets.values():
                client.connection.append(frame)
                self._leave(client)
        self.targets = {}
        try:
            for client in list(self._leaving):
                await client.connection.closed()
        finally:
            self.abort()

    def abort(self) -> None:
        """Closes at once."""
        self._stop_listening()
        for client in [*self.targets.values(), *self._leaving]:
            client.connection.close()
        self.targets = {}
        self._leaving.clear()

    # Inside: connections

    def _stop_listening(self) -> None:
        if self._retry is not None:
            self._retry.cancel()
        if self._listener.fileno() >= 0:
            self._loop.remove_reader(self._listener)
            self._listener.close()
        for stranger in list(self._strangers):
            self._dismiss(stranger)

    def _leave(self, client: _Client, last: bytes = b"") -> None:
        """Ends the connection of a consumer behind what waits, or with this frame in its place."""
        self._consumers.leave(client)
        self._leaving[client] = None
        if last:
            client.connection.dismiss(last)
        else:
            client.connection.finish()
        if len(self._leaving) > MAX_TCP_CONSUMERS:
            eldest = next(iter(self._leaving))
            del self._leaving[eldest]
            eldest.connection.close()
        self._look_for_places()

    def _accept(self) -> None:
        try:
            sock, source = self._listener.accept()
        except (BlockingIOError, InterruptedError, ConnectionError):
            return
        except OSError:
            # No descriptor is left: accepting pauses, so that the loop is not kept busy.
            self._loop.remove_reader(self._listener)
            self._retry = self._loop.call_later(ACCEPT_AGAIN_SECONDS, self._listen_again)
            return
        self._welcome(sock, str(source[0]))

    def _listen_again(self) -> None:
        self._retry = None
        self._loop.add_reader(self._listener, self._accept)

    def _welcome(self, sock: socket.socket, address: str) -> None:
        client = _Client(address, self._loop.call_later(STRANGER_SECONDS, lambda: self._dismiss(client)))
        took, loser = self._strangers.take(client, address)
        if not took:
            client.timer.cancel()
            sock.close()
            self.dropped += 1
            return
        if loser is not None:
            self._dismiss(loser)
            self.dropped += 1
        client.connection = TcpConnection(
            self._loop, sock, lambda frame: self._heard(client, frame), lambda: self._ended(client), PAYLOAD.size, self._pool
        )

    def _dismiss(self, client: _Client) -> None:
        """Closes the connection of a stranger."""
        client.connection.close()
        self._forget(client)

    def _forget(self, client: _Client) -> None:
        """It is no stranger any more."""
        client.timer.cancel()
        self._strangers.leave(client)
        if self._waiting.get(client.life) is client:
            del self._waiting[client.life]

    def _ended(self, client: _Client, reason: str = LOST) -> None:
        self.dropped += client.connection.is_broken
        self._forget(client)
        self._leaving.pop(client, None)
        self._consumers.leave(client)
        if self.targets.get(client.life) is client:
            del self.targets[client.life]
            self._host.left(client.life, reason)
        self._look_for_places()

    def _look_for_places(self) -> None:
        if self._consumers.has_room_again:
            self._host.places_again()

    def _end_plain(self, client: _Client) -> None:
        """Closes the connection of a consumer that has said no sealed hello, where that is needed."""
        if self._asks(client):
            client.connection.close()
            self._ended(client)

    def _asks(self, client: _Client) -> bool:
        """Whether a consumer has yet to say a sealed hello, because its first one was plain."""
        return self._frames.is_strict and not client.counter and self.targets.get(client.life) is client

    def _ask(self, client: _Client) -> None:
        """Asks a consumer for a sealed hello."""
        if self._asks(client):
            client.cookie = draw_life()
            self._floor(client, client.cookie)

    # Inside: hellos

    def _refuse(self, client: _Client) -> None:
        """Closes a connection that said something else than the hello of a consumer."""
        self.dropped += 1
        client.connection.close()
        self._ended(client)

    def _heard(self, client: _Client, octets: AnyFrame) -> None:
        keys = self._frames.keys
        if keys is None:
            if client.first is not None or octets.kind is not Kind.HELLO:
                self._refuse(client)
            else:
                client.first = octets
            return
        if self._asks(client) and isinstance(octets, Frame):
            self._loop.call_later(ASK_AGAIN_SECONDS, self._ask, client)  # Its host has not gone so far yet.
            return
        frame = self._frames.take(octets)
        said = None if frame is None else read_handshake(frame.payload)
        if frame is None or said is None or said.life != self._frames.life or not said.challenge or frame.kind is not Kind.HELLO:
            self._refuse(client)
        elif client.life:
            self._greeted_again(client, frame, said)
        else:
            self._greeted(client, frame, said)

    def _greeted(self, client: _Client, frame: Frame, said: Handshake) -> None:
        counter = counter_of(frame)
        if frame.is_sealed or self._frames.seals:
            if client.cookie == 0:
                client.challenge, client.counter, client.cookie = said.challenge, counter, draw_life()
                self._answer(client, Kind.FLOOR, frame.life, client.cookie)
                return
            has_risen = counter > client.counter or counter == client.counter == 0
            if said.cookie != client.cookie or said.challenge != client.challenge or not has_risen:
                self._refuse(client)
                return
        client.life, client.challenge, client.counter = frame.life, said.challenge, counter
        if self._admits_all or frame.life in self._expected:
            self._admit(client)
            return
        other = self._waiting.get(frame.life)
        if other is not None:
            self._dismiss(other)
        self._waiting[frame.life] = client

    def _greeted_again(self, client: _Client, frame: Frame, said: Handshake) -> None:
        """A consumer has said another hello. It counts if it was asked for, because its first one was plain."""
        counter = counter_of(frame)
        if client.cookie and not client.counter < counter:
            self.dropped += 1
        elif client.cookie and (frame.life, said.challenge, said.cookie) == (client.life, client.challenge, client.cookie):
            client.counter = counter
            self._floor(client, 0)
        else:
            self.dropped += 1

    def _admit(self, client: _Client) -> None:
        before = self.targets.get(client.life)
        if before is not None:
            self._consumers.leave(before)
            before.connection.close()
        took, loser = self._consumers.take(client, client.address)
        if not took or loser is not None:
            self._host.no_place("consumers", MAX_TCP_CONSUMERS)
        if not took:
            self.dropped += 1
            self._answer(client, Kind.FULL, client.life, 0)
            self._dismiss(client)
            return
        if loser is not None:
            self._lose(loser)
        self._forget(client)
        self.targets[client.life] = client
        if client.cookie:
            self._floor(client, 0)
        if before is None:
            self._host.joined(client.life)

    def _lose(self, client: _Client) -> None:
        """A consumer loses its place."""
        del self.targets[client.life]
        self._leave(client, self._frames.other(Kind.FULL, Handshake(client.life, client.challenge, 0).write()))
        self._host.left(client.life, LOST)

    def _floor(self, client: _Client, cookie: int) -> None:
        self._answer(client, Kind.FLOOR, client.life, cookie)

    def _answer(self, client: _Client, kind: Kind, life: int, cookie: int) -> None:
        client.connection.append(self._frames.other(kind, Handshake(life, client.challenge, cookie).write()))

    # Inside: the slow

    def _left_out(self, client: _Client) -> None:
        if not client.is_left_out:
            client.is_left_out = True
            text = f"the consumer {write_life(client.life)} is slow: messages to it are left out until it has taken some"
            self._loop.call_soon(self._host.problem, text)  # not within send()

    def _close_slow(self) -> None:
        """Closes the consumers that have taken nothing for the longest time, until what waits is within its limit."""
        while self._pool.is_over:
            waiting = [one for one in [*self.targets.values(), *self._leaving] if one.connection.waiting_octets]
            if not waiting:
                return
            client = min(waiting, key=lambda one: one.connection.took_at)
            client.connection.close()
            self._loop.call_soon(self._ended, client, SLOW)
