"""Datagrams and connections of strangers to publishers and subscribers; in virtual time."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import unittest

from meeting import met
from virtual import Daemon, Told, VirtualTestCase, add_consumer, add_provider, until

import geminga
from geminga.protocol.frame import Kind, write_frame
from geminga.protocol.limits import LISTENER_SECONDS, MAX_STRANGERS, MAX_TCP_CONSUMERS, STRANGER_SECONDS


class Strangers(VirtualTestCase):
    def connected(self, pub: geminga.Publisher, octets: bytes = b"") -> socket.socket:
        sock = socket.create_connection(("127.0.0.1", pub.port))
        self.addCleanup(sock.close)
        sock.sendall(octets)
        sock.setblocking(False)
        return sock

    async def is_closed(self, sock: socket.socket) -> bool:
        with contextlib.suppress(ConnectionResetError):
            return await asyncio.get_running_loop().sock_recv(sock, 1000) == b""
        return True

    def test_datagrams_of_others_are_dropped(self) -> None:
        async def story() -> None:
            async with met() as both:
                life, port = both.pub.life, both.sub._udp.port  # type: ignore[union-attr]
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
                    stranger.sendto(write_frame(Kind.MESSAGE, life, 1, b"forged"), ("127.0.0.1", port))
                outlet = both.pub._outlet._sock  # type: ignore[attr-defined]
                for octets in (write_frame(Kind.MESSAGE, life ^ 1, 1, b"forged"), b"no frame", write_frame(Kind.HELLO, life, 0)):
                    outlet.sendto(octets, ("::ffff:127.0.0.1", port) if outlet.family == socket.AF_INET6 else ("127.0.0.1", port))
                both.pub.send(b"x")
                self.assertEqual(await both.take(1), [b"x"])
                self.assertEqual((both.sub.received, both.sub.dropped), (1, 4))

        self.run_async(story())

    def test_a_provider_without_a_channel_is_heard_as_it_is(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                sub = await node.subscribe(text="x", mode="oto")
                pub = await node.publish(text="x", mode="oto")
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as raw:
                    raw.bind(("127.0.0.1", 0))
                    raw.settimeout(1)
                    peer, line = await daemon.request("sub")
                    peer.say(f"{line.id} pub add service=1a2b3c4d/9/1 mode=oto address=127.0.0.1 port={raw.getsockname()[1]} protocol=udp")
                    peer.say(f"{line.id} pub add service=1a2b3c4d/9/2 mode=oto address=127.0.0.1 port=9 protocol=tcp")
                    await until(lambda: len(sub.providers) == 2)
                    raw.sendto(b"as it is", ("127.0.0.1", sub._udp.port))  # type: ignore[union-attr]
                    self.assertEqual(await sub.receive(), geminga.Message(b"as it is"))
                    self.assertEqual(len(told.problems), 1)
                    peer, line = await daemon.request("pub")
                    peer.say(f"{line.id} sub add subscription=1a2b3c4d/9/3 mode=oto address=127.0.0.1 port={raw.getsockname()[1]}")
                    await until(lambda: pub.has_consumers)
                    pub.send(b"the same")
                    self.assertEqual(raw.recv(100), b"the same")

        self.run_async(story())

    def test_listeners_that_fall_silent_are_forgotten(self) -> None:
        async def story() -> None:
            async with met("otm/stream") as both:
                await both.sub.close()
                await until(lambda: not both.pub.has_consumers, LISTENER_SECONDS / 2)
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as raw:
                    hello = write_frame(Kind.HELLO, 5, 0, both.pub.life.to_bytes(8, "big"))
                    raw.sendto(hello[:-1] + b"\x00" if hello[-1] else hello[:-1] + b"\x01", ("127.0.0.1", both.pub.port))
                    await until(lambda: both.pub.dropped == 1)
                    self.assertFalse(both.pub.has_consumers)
                    raw.sendto(hello, ("127.0.0.1", both.pub.port))
                    await until(lambda: both.pub.has_consumers)
                    begin = asyncio.get_running_loop().time()
                    await until(lambda: not both.pub.has_consumers)
                    self.assertAlmostEqual(asyncio.get_running_loop().time() - begin, LISTENER_SECONDS, delta=0.5)

        self.run_async(story())

    def test_connections_that_say_nothing_are_closed(self) -> None:
        async def story() -> None:
            async with met("oto", "tcp") as both:
                loop = asyncio.get_running_loop()
                begin = loop.time()
                silent, unknown = self.connected(both.pub), self.connected(both.pub, write_frame(Kind.HELLO, 99, 0))
                hostile = self.connected(both.pub, b"GET / HTTP/1.1\r\n\r\n        ")
                self.assertTrue(await self.is_closed(hostile))
                self.assertLess(loop.time() - begin, 1)
                self.assertTrue(await self.is_closed(silent) and await self.is_closed(unknown))
                self.assertAlmostEqual(loop.time() - begin, STRANGER_SECONDS, delta=0.5)
                both.pub.send(b"x")
                self.assertEqual(await both.take(1), [b"x"])

        self.run_async(story())

    def test_sixteen_may_wait_and_the_oldest_is_closed_for_one_more(self) -> None:
        async def story() -> None:
            async with met("oto", "tcp") as both:
                strangers = [self.connected(both.pub) for _ in range(MAX_STRANGERS + 1)]
                begin = asyncio.get_running_loop().time()
                self.assertTrue(await self.is_closed(strangers[0]))
                self.assertLess(asyncio.get_running_loop().time() - begin, 1)
                self.assertTrue(await self.is_closed(strangers[1]))
                self.assertGreater(asyncio.get_running_loop().time() - begin, STRANGER_SECONDS - 1)

        self.run_async(story())

    def test_hello_may_come_before_its_consumer(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="oto", protocol="tcp")
                sub = await node.subscribe(text="x", mode="oto", protocol="tcp")
                p, s = await daemon.request("pub"), await daemon.request("sub")
                self.assertEqual(s[1].get("port"), "")
                add_provider(s, p[1])
                await until(lambda: sub.providers)
                await asyncio.sleep(1)
                self.assertEqual((pub.has_consumers, told.changes), (False, ["added"]))
                add_consumer(p, s[1])
                await until(lambda: pub.has_consumers)
                self.assertEqual(told.changes, ["added", "added"])

        self.run_async(story())

    def test_a_second_connection_takes_the_place_of_the_first(self) -> None:
        async def story() -> None:
            async with geminga.connect("test", "127.0.0.1:1") as node:
                pub = await node.publish(text="x", mode="otm/stream", protocol="tcp")
                first = self.connected(pub, write_frame(Kind.HELLO, 7, 0))
                await until(lambda: pub.has_consumers)
                second = self.connected(pub, write_frame(Kind.HELLO, 7, 0))
                self.assertTrue(await self.is_closed(first))
                pub.send(b"x")
                octets = await asyncio.get_running_loop().sock_recv(second, 100)
                self.assertEqual(octets, write_frame(Kind.MESSAGE, pub.life, 1, b"x"))
                second.close()

        self.run_async(story())

    def test_256_consumers_are_sent_to_and_one_more_is_closed(self) -> None:
        async def story() -> None:
            async with geminga.connect("test", "127.0.0.1:1") as node:
                pub = await node.publish(text="x", mode="otm/stream", protocol="tcp")
                for life in range(1, MAX_TCP_CONSUMERS + 1):
                    self.connected(pub, write_frame(Kind.HELLO, life, 0))
                    await until(lambda: len(pub._outlet.targets) == life)  # noqa: B023
                self.assertTrue(await self.is_closed(self.connected(pub, write_frame(Kind.HELLO, 999, 0))))
                self.assertEqual(len(pub._outlet.targets), MAX_TCP_CONSUMERS)
                pub.abort()

        self.run_async(story())


if __name__ == "__main__":
    unittest.main()
