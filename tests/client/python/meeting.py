"""Publishers and subscribers that a scripted daemon has told of each other, or of a socket."""

from __future__ import annotations

import contextlib
import socket
from collections.abc import AsyncIterator

from virtual import Daemon, Told, add_consumer, add_provider, until

import geminga


class Met:
    """A publisher and a subscriber that have been told of each other."""

    def __init__(self, node: geminga.Node, daemon: Daemon, told: Told, pub: geminga.Publisher, sub: geminga.Subscriber) -> None:
        self.node, self.daemon, self.told, self.pub, self.sub = node, daemon, told, pub, sub

    async def rows(self) -> tuple[object, object]:
        return await self.daemon.request("pub"), await self.daemon.request("sub")

    async def say(self, line: str) -> None:
        """The daemon sends this event of the subscription."""
        peer, sub = await self.daemon.request("sub")
        peer.say(f"{sub.id} {line}")

    async def take(self, count: int) -> list[bytes]:
        return [(await self.sub.receive()).payload for _ in range(count)]


@contextlib.asynccontextmanager
async def met(mode: str = "oto", protocol: str = "udp", sealing: str = "", address: str = "", **wishes: object) -> AsyncIterator[Met]:
    daemon, told = Daemon(sealing), Told()
    await daemon.start()
    async with geminga.connect("test", daemon.address, told) as node:
        pub = await node.publish(text="x", mode=mode, protocol=protocol, address=address or None)
        sub = await node.subscribe(text="x", mode=mode, **wishes)  # type: ignore[arg-type]
        p, s = await daemon.request("pub"), await daemon.request("sub")
        if mode != "otm/stream":
            add_consumer(p, s[1])
        add_provider(s, p[1])
        await until(lambda: sub.providers and pub.has_consumers)
        yield Met(node, daemon, told, pub, sub)


class Provider:
    """A socket that sends before the daemon has told of it, and a subscriber."""

    def __init__(self, sub: geminga.Subscriber, to: tuple, sock: socket.socket, told: Told) -> None:  # type: ignore[type-arg]
        self.sub, self.to, self.sock, self.told = sub, to, sock, told

    async def send(self, *frames: bytes) -> None:
        """Sends these frames, and waits until all of them have arrived."""
        before = self.sub.dropped
        for octets in frames:
            self.sock.sendto(octets, ("127.0.0.1", self.sub._udp.port))  # type: ignore[union-attr]
        await until(lambda: self.sub.dropped == before + len(frames))

    async def add(self, life: int, word: str = "1a2b3c4d/9/1") -> None:
        """The daemon tells of the socket as a provider."""
        peer, line = self.to
        port, said = self.sock.getsockname()[1], len(self.told.all)
        peer.say(f"{line.id} pub add service={word} mode=oto address=127.0.0.1 port={port} protocol=udp channel={life:016x}")
        await until(lambda: len(self.told.all) > said)


@contextlib.asynccontextmanager
async def provider(**wishes: object) -> AsyncIterator[Provider]:
    daemon, told = Daemon(), Told()
    await daemon.start()
    async with geminga.connect("test", daemon.address, told) as node:
        sub = await node.subscribe(text="x", mode="otm/pubsub", **wishes)  # type: ignore[arg-type]
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
            sock.bind(("127.0.0.1", 0))
            yield Provider(sub, await daemon.request("sub"), sock, told)
