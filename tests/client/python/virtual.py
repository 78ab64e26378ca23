"""Tests of sockets without waiting: an event loop whose clock advances when nothing is left to do, and a scripted daemon."""

from __future__ import annotations

import asyncio
import hashlib
import selectors
import sys
import unittest
from collections.abc import Callable, Coroutine
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "src/client/python"))

import geminga  # noqa: E402
import geminga.log  # noqa: E402
from geminga.protocol.line_reader import LineReader  # noqa: E402
from geminga.protocol.statement import ErrorLine, Statement, read_line  # noqa: E402

geminga.log.to_standard_error = lambda line: None  # Tests look at problems themselves.

#: Seconds after which a datagram to the own host has arrived, also where the system delivers it after the call that sends it.
_IN_FLIGHT_SECONDS = 0.001
_HANGS_SECONDS = 60.0


class _Selector(selectors.EpollSelector):
    """If no socket is ready, the loop waits for a timer, and the clock advances to it."""

    def __init__(self) -> None:
        super().__init__()
        self.loop: VirtualLoop

    def select(self, timeout: float | None = None) -> list[tuple[selectors.SelectorKey, int]]:
        if timeout is None:
            ready = super().select(_HANGS_SECONDS)
            if not ready:
                for task in asyncio.all_tasks(self.loop):
                    task.print_stack()
                raise AssertionError("everybody waits, and nothing will come")
            return ready
        ready = super().select(0 if timeout <= 0 else _IN_FLIGHT_SECONDS)
        if not ready and timeout > 0:
            self.loop.passed += timeout
        return ready


class VirtualLoop(asyncio.SelectorEventLoop):
    """An event loop whose clock begins at 0 and stands still while there is something to do."""

    def __init__(self) -> None:
        self.passed = 0.0
        selector = _Selector()
        selector.loop = self
        super().__init__(selector)

    def time(self) -> float:
        return self.passed


class VirtualTestCase(unittest.TestCase):
    """`self.run_async(coroutine)` runs it in virtual time; an exception in a callback fails the test."""

    def run_async(self, work: Coroutine[Any, Any, None]) -> None:
        broken: list[dict[str, Any]] = []

        async def watched() -> None:
            asyncio.get_running_loop().set_exception_handler(lambda _, context: broken.append(context))
            try:
                await work
            finally:
                for daemon in list(Daemon.running):
                    await daemon.stop()

        with asyncio.Runner(loop_factory=VirtualLoop) as runner:
            runner.run(watched())
        self.assertEqual(broken, [])


async def until(holds: Callable[[], object], seconds: float = 60.0) -> None:
    """Lets the other tasks run until the condition holds."""
    loop = asyncio.get_running_loop()
    end, step = loop.time() + seconds, 0.001
    while not holds():
        if loop.time() >= end:
            raise AssertionError("this did not come to hold")
        await asyncio.sleep(step)
        step = min(2 * step, 0.1)


class Peer:
    """A connection to the daemon, as the daemon sees it."""

    def __init__(self, daemon: Daemon, writer: asyncio.StreamWriter) -> None:
        self.daemon = daemon
        self.writer = writer
        self.heard: list[Statement] = []

    def say(self, *lines: str) -> None:
        for line in lines:
            self.writer.write(line.encode() + b"\r\n")

    def of(self, command: str, subcommand: str) -> list[Statement]:
        """The lines of this kind that the daemon has received."""
        return [line for line in self.heard if (line.command, line.subcommand) == (command, subcommand)]


def keys_of(life: int, secret: bytes) -> tuple[int, bytes, bytes]:
    """The id and the keys of a channel that a scripted daemon derives from a secret."""
    forward, back = (hashlib.blake2b(b"%d %016x" % (way, life), key=secret, digest_size=32).digest() for way in (1, 2))
    return int.from_bytes(hashlib.blake2b(secret).digest()[:2], "big"), forward, back


def ring_of(life: int, secrets: list[bytes]) -> list[tuple[int, bytes, bytes]]:
    return [keys_of(life, secret) for secret in secrets]


class Daemon:
    """Answers hello and ping. `answer` may do more with each statement. With a mode of `sealing` it gives keys from `secrets`."""

    running: list[Daemon] = []

    def __init__(self, sealing: str = "") -> None:
        self.sealing = sealing
        self.secrets = [b"first secret"]
        self.keyed: dict[tuple[Peer, int, int], None] = {}
        self.peers: list[Peer] = []
        self.port = 0
        self.answer: Callable[[Peer, Statement], None] = lambda peer, line: None
        self.answers_hello = True
        self._server: asyncio.Server | None = None

    async def start(self) -> None:
        self._server = await asyncio.start_server(self._serve, "127.0.0.1", self.port)
        self.port = self._server.sockets[0].getsockname()[1]
        Daemon.running.append(self)

    async def stop(self) -> None:
        """As kill -9 does."""
        assert self._server is not None
        Daemon.running.remove(self)
        self._server.close()
        for peer in self.peers:
            peer.writer.transport.abort()
        self.peers.clear()
        await self._server.wait_closed()

    def give_keys(self, peer: Peer, number: int, life: str) -> None:
        """Gives the keys of a life to the one who states it, or is about to be told of it."""
        if self.sealing:
            self.keyed[peer, number, int(life, 16)] = None
            self._give(peer, number, int(life, 16))

    def rekey(self, sealing: str, *secrets: bytes) -> None:
        """Has another mode, and other secrets if there are any, and tells all who were given keys."""
        self.sealing = sealing
        self.secrets = list(secrets) or self.secrets
        for peer in self.peers:
            peer.say(f"0 msg sealing mode={sealing}")
        for peer, number, life in self.keyed:
            self._give(peer, number, life)

    def _give(self, peer: Peer, number: int, life: int) -> None:
        ring = ",".join(f"{key:04x}:{forward.hex()}:{back.hex()}" for key, forward, back in ring_of(life, self.secrets))
        peer.say(f"{number} pub keys life={life:016x} mode={self.sealing}" + (f" ring={ring}" if self.sealing != "plain" else ""))

    @property
    def address(self) -> str:
        return f"127.0.0.1:{self.port}"

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        peer = Peer(self, writer)
        self.peers.append(peer)
        lines = LineReader()
        while octets := await reader.read(65536):
            for octets in lines.feed(octets):
                line = read_line(octets)
                assert not isinstance(line, ErrorLine)
                peer.heard.append(line)
                if line.subcommand == "hello" and self.answers_hello:
                    sealing = f" keys=yes sealing={self.sealing}" if self.sealing else ""
                    peer.say(f"0 msg hello version=1 participant=1a2b3c4d peer=1 participant_name=host{sealing}")
                self.answer(peer, line)
                if (line.command, line.subcommand) == ("pub", "create"):
                    self.give_keys(peer, line.id, line.get("channel"))
                if line.subcommand == "ping":
                    peer.say("0 msg pong")
        writer.close()

    async def request(self, command: str, number: int = 0) -> tuple[Peer, Statement]:
        """The request of this kind that was made, of any peer, counted from 0."""

        def made() -> list[tuple[Peer, Statement]]:
            return [(peer, line) for peer in self.peers for line in peer.of(command, "create")]

        await until(lambda: len(made()) > number)
        return made()[number]


def add_provider(to: tuple[Peer, Statement], of: Statement, word: str = "1a2b3c4d/1/1", change: str = "add", more: str = "") -> None:
    """Tells a subscriber of a publication."""
    peer, sub = to
    address = of.get("address", "127.0.0.1")
    peer.daemon.give_keys(peer, sub.id, of.get("channel"))
    peer.say(
        f"{sub.id} pub {change} service={word} provider=1a2b3c4d/1 text=x degree=exact distance=0 mode={of.get('mode')} "
        f"address={address} port={of.get('port')} protocol={of.get('protocol')} priority=0 channel={of.get('channel')} {more}"
    )


def add_consumer(to: tuple[Peer, Statement], of: Statement, word: str = "1a2b3c4d/2/1", change: str = "add") -> None:
    """Tells a publisher of a subscription."""
    peer, pub = to
    port = f"port={of.get('port')} " if of.get("port") else ""
    peer.say(
        f"{pub.id} sub {change} subscription={word} consumer=1a2b3c4d/2 text=x degree=exact distance=0 mode={of.get('mode')} "
        f"address=127.0.0.1 {port}priority=0 channel={of.get('channel')}"
    )


class Told:
    """The events that an application received."""

    def __init__(self) -> None:
        self.all: list[geminga.Happening] = []

    def __call__(self, what: geminga.Happening) -> None:
        self.all.append(what)

    @property
    def changes(self) -> list[str]:
        """`added`, `removed withdrawn`, ... of providers and consumers."""
        kinds = (geminga.ProviderChanged, geminga.ConsumerChanged)
        return [f"{one.change} {one.reason}".strip() for one in self.all if isinstance(one, kinds)]

    @property
    def problems(self) -> list[str]:
        return [one.text for one in self.all if isinstance(one, geminga.Problem)]
