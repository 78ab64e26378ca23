"""A publisher and a subscriber that a scripted daemon has told of each other."""

from __future__ import annotations

import contextlib
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
async def met(mode: str = "oto", protocol: str = "udp", **wishes: object) -> AsyncIterator[Met]:
    daemon, told = Daemon(), Told()
    await daemon.start()
    async with geminga.connect("test", daemon.address, told) as node:
        pub = await node.publish(text="x", mode=mode, protocol=protocol)
        sub = await node.subscribe(text="x", mode=mode, **wishes)  # type: ignore[arg-type]
        p, s = await daemon.request("pub"), await daemon.request("sub")
        if mode != "otm/stream":
            add_consumer(p, s[1])
        add_provider(s, p[1])
        await until(lambda: sub.providers and pub.has_consumers)
        yield Met(node, daemon, told, pub, sub)
