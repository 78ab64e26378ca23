"""Members of a team with a key, which the scripted daemon gives them."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections.abc import AsyncIterator

from virtual import Daemon, ring_of

import geminga
from geminga.protocol.channel_keys import ChannelKeys
from geminga.protocol.frame import Frame, Kind
from geminga.protocol.handshake import Handshake, read_handshake
from geminga.protocol.sealed_frame import read_any_datagram

GROUP = "239.66.3.11"


def keys_for(life: int, mode: str = "encrypted", secret: bytes = b"first secret") -> ChannelKeys:
    return ChannelKeys(mode, ring_of(life, [secret]))


class Consumer:
    """A socket that speaks as a consumer with the key of the team."""

    def __init__(self, pub: geminga.Publisher, life: int = 5, secret: bytes = b"first secret") -> None:
        self.pub, self.life, self.counter = pub, life, 0
        self.keys = keys_for(pub.life, secret=secret)
        self.sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.sock.bind(("127.0.0.1", 0))
        self.sock.setblocking(False)

    def say(self, cookie: int = 0, kind: Kind = Kind.HELLO, challenge: int = 9) -> bytes:
        self.counter += 1
        octets = self.keys.seal_back(kind, self.life, self.counter, Handshake(self.pub.life, challenge, cookie).write())
        self.send(octets)
        return octets

    def send(self, octets: bytes) -> None:
        self.sock.sendto(octets, ("127.0.0.1", self.pub.port))

    async def hear(self) -> Frame:
        octets = await asyncio.get_running_loop().sock_recv(self.sock, 65_536)
        frame = self.keys.take(read_any_datagram(octets), is_back=False)
        assert frame is not None
        return frame

    async def asked(self) -> int:
        """The cookie of the next floor."""
        frame = await self.hear()
        said = read_handshake(frame.payload)
        assert frame.kind is Kind.FLOOR and said is not None and (said.life, said.challenge) == (self.life, 9)
        return said.cookie

    async def accepted(self) -> bytes:
        """Says hello until it is a listener; returns the last hello."""
        self.say()
        hello = self.say(await self.asked())
        assert await self.asked() == 0
        return hello


@contextlib.asynccontextmanager
async def stream(sealing: str = "encrypted") -> AsyncIterator[geminga.Publisher]:
    daemon = Daemon(sealing)
    await daemon.start()
    async with geminga.connect("test", daemon.address) as node:
        yield await node.publish(text="x", mode="otm/stream")
