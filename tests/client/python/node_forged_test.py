"""Forged and recorded frames on sealed channels (src/client/CHANNELS.md, "Freshness"); in virtual time."""

from __future__ import annotations

import asyncio
import select
import socket
import unittest
from typing import Any

from meeting import met
from team import GROUP, Consumer, keys_for, stream
from virtual import Daemon, Told, VirtualTestCase, add_provider, until

import geminga
from geminga.protocol.frame import Kind, write_frame
from geminga.protocol.handshake import Handshake, read_handshake
from geminga.protocol.limits import COOKIE_SECONDS
from geminga.protocol.sealed_frame import read_any_datagram


async def heard(sock: socket.socket) -> tuple[bytes, Any]:
    """The next datagram, and its source."""
    await until(lambda: select.select([sock], [], [], 0)[0])
    octets, source = sock.recvfrom(1000)
    return octets, source


class Attacked(VirtualTestCase):
    def test_whoever_has_no_key_is_not_answered_and_sends_nothing_that_is_heard(self) -> None:
        async def story(mode: str) -> None:
            async with met(mode, "udp", "encrypted") as both:
                outlet, port, life = both.pub._outlet._sock, both.sub._udp.port, both.pub.life  # type: ignore[attr-defined,union-attr]
                there = ("::ffff:127.0.0.1", port) if outlet.family == socket.AF_INET6 else ("127.0.0.1", port)
                dropped = both.sub.dropped
                stranger = keys_for(life, secret=b"another team")
                for octets in (
                    write_frame(Kind.MESSAGE, life, 2**64 - 1, b"forged"),
                    write_frame(Kind.END, life, 2**64 - 1),
                    b"".join(stranger.seal_forward(Kind.MESSAGE, life, 2**64 - 1, 1, b"forged")),
                    b"".join(stranger.seal_forward(Kind.END, life, 2**64 - 1, 2, b"")),
                ):
                    outlet.sendto(octets, there)
                await until(lambda: both.sub.dropped == dropped + 4)
                for number in range(10):
                    both.pub.send(b"%d" % number)
                self.assertEqual(await both.take(10), [b"%d" % number for number in range(10)])
                consumer, consumers = Consumer(both.pub, secret=b"another team"), both.told.changes.count("added")
                dropped = both.pub.dropped
                consumer.say()
                consumer.send(write_frame(Kind.HELLO, 5, 0, Handshake(life, 9, 0).write()))
                await until(lambda: both.pub.dropped == dropped + 2)
                self.assertRaises(BlockingIOError, consumer.sock.recv, 100)
                self.assertEqual(both.told.changes.count("added"), consumers)
                consumer.sock.close()

        for mode in ("oto", "otm/pubsub", "otm/stream"):
            with self.subTest(mode=mode):
                self.run_async(story(mode))

    def test_a_life_that_was_heard_sealed_is_not_heard_plain(self) -> None:
        async def story() -> None:
            async with met("oto", "udp", "mixed") as both:
                both.pub.send(b"1")
                self.assertEqual(await both.take(1), [b"1"])
                outlet, port, life = both.pub._outlet._sock, both.sub._udp.port, both.pub.life  # type: ignore[attr-defined,union-attr]
                there = ("::ffff:127.0.0.1", port) if outlet.family == socket.AF_INET6 else ("127.0.0.1", port)
                for octets in (write_frame(Kind.MESSAGE, life, 2, b"forged"), write_frame(Kind.END, life, 2)):
                    outlet.sendto(octets, there)
                await until(lambda: both.sub.dropped == 2)
                both.pub.send(b"2")
                self.assertEqual(await both.take(1), [b"2"])

        self.run_async(story())

    def test_a_plain_hello_to_a_group_is_answered_while_plain_frames_are_taken(self) -> None:
        async def story(sealing: str, answers: int) -> None:
            daemon = Daemon(sealing)
            await daemon.start()
            async with geminga.connect("test", daemon.address) as node:
                pub = await node.publish(text="x", mode="otm/stream", address=GROUP)
                await until(lambda: pub._frames.hello_port)
                consumer = Consumer(pub)
                hellos = (write_frame(Kind.HELLO, 5, 0, Handshake(pub.life, 9, 0).write()), consumer.say())
                for octets in hellos:
                    consumer.sock.sendto(octets, ("127.0.0.1", pub._frames.hello_port))
                self.assertEqual([await consumer.asked() for _ in range(answers)], [0] * answers)
                await asyncio.sleep(1)
                self.assertRaises(BlockingIOError, consumer.sock.recv, 100)
                consumer.sock.close()

        self.run_async(story("mixed", 2))
        self.run_async(story("encrypted", 1))

    def test_256_connections_without_a_key_are_closed_at_once(self) -> None:
        async def story() -> None:
            async with met("otm/stream", "tcp", "encrypted") as both:
                begin, loop = asyncio.get_running_loop().time(), asyncio.get_running_loop()
                for life in range(1, 257):
                    with socket.create_connection(("127.0.0.1", both.pub.port)) as stranger:
                        stranger.sendall(write_frame(Kind.HELLO, life, 0, Handshake(both.pub.life, 1, 0).write()))
                        stranger.setblocking(False)
                        self.assertEqual(await loop.sock_recv(stranger, 1000), b"")
                self.assertLess(loop.time() - begin, 1)
                both.pub.send(b"x")
                self.assertEqual(await both.take(1), [b"x"])

        self.run_async(story())

    def test_a_recorded_hello_or_end_does_nothing(self) -> None:
        async def story() -> None:
            async with stream() as pub:
                consumer = Consumer(pub)
                hello = await consumer.accepted()
                dropped = pub.dropped
                consumer.send(hello)
                end = consumer.say(kind=Kind.END)
                await until(lambda: not pub.has_consumers)
                self.assertEqual(pub.dropped, dropped + 1)
                await asyncio.sleep(2 * COOKIE_SECONDS)
                consumer.send(hello)
                self.assertNotEqual(await consumer.asked(), 0)
                self.assertFalse(pub.has_consumers)
                await consumer.accepted()
                consumer.send(end)
                await until(lambda: pub.dropped == dropped + 2)
                self.assertTrue(pub.has_consumers)
                consumer.sock.close()

        self.run_async(story())

    def test_a_recorded_tcp_handshake_opens_nothing(self) -> None:
        async def story() -> None:
            async with met("otm/stream", "tcp", "encrypted") as both:
                loop, keys = asyncio.get_running_loop(), keys_for(both.pub.life)
                hellos = [keys.seal_back(Kind.HELLO, 7, n, Handshake(both.pub.life, 9, n - 1).write()) for n in (1, 2)]
                with socket.create_connection(("127.0.0.1", both.pub.port)) as stranger:
                    stranger.setblocking(False)
                    await loop.sock_sendall(stranger, hellos[0])
                    floor = keys.take(read_any_datagram(await loop.sock_recv(stranger, 1000)), is_back=False)
                    assert floor is not None and floor.kind is Kind.FLOOR
                    await loop.sock_sendall(stranger, hellos[1])
                    self.assertEqual(await loop.sock_recv(stranger, 1000), b"")
                self.assertEqual(len(both.pub._outlet.targets), 1)

        self.run_async(story())

    def test_a_recording_is_not_heard_by_a_subscriber_that_comes_later(self) -> None:
        async def story() -> None:
            daemon, told = Daemon("encrypted"), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                sub = await node.subscribe(text="x", mode="otm/stream")
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as provider:
                    provider.bind(("127.0.0.1", 0))
                    provider.setblocking(False)
                    life, keys = 77, keys_for(77)
                    peer, line = await daemon.request("sub")
                    daemon.give_keys(peer, line.id, f"{life:016x}")
                    place = f"address=127.0.0.1 port={provider.getsockname()[1]} protocol=udp channel={life:016x}"
                    peer.say(f"{line.id} pub add service=1a2b3c4d/9/1 mode=otm/stream {place}")
                    octets, there = await heard(provider)
                    hello = keys.take(read_any_datagram(octets), is_back=True)
                    said = None if hello is None else read_handshake(hello.payload)
                    assert hello is not None and said is not None
                    recorded = [b"".join(keys.seal_forward(Kind.MESSAGE, life, n, n, b"%d" % n)) for n in (1, 2, 3, 4)]
                    end = b"".join(keys.seal_forward(Kind.END, life, 4, 5, b""))
                    old = b"".join(keys.seal_forward(Kind.FLOOR, life, 0, 6, Handshake(hello.life, said.challenge ^ 1, 0).write()))
                    for one in (*recorded[:3], old):
                        provider.sendto(one, there)
                    await until(lambda: sub.dropped == 4)
                    self.assertEqual(sub.received, 0)
                    floor = keys.seal_forward(Kind.FLOOR, life, 2, 7, Handshake(hello.life, said.challenge, 0).write())
                    provider.sendto(b"".join(floor), there)
                    self.assertEqual((await sub.receive()).sequence, 3)  # it came before the floor, and is newer
                    for one in (*recorded, end):
                        provider.sendto(one, there)
                    self.assertEqual((await sub.receive()).sequence, 4)
                    await until(lambda: not sub.providers)
                    self.assertEqual((sub.received, sub.missed), (2, 0))

        self.run_async(story())

    def test_a_multicast_group_is_heard_once_its_floor_has_come(self) -> None:
        async def story() -> None:
            daemon, told = Daemon("encrypted"), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="otm/stream", address=GROUP)
                sub = await node.subscribe(text="x", mode="otm/stream")
                p, s = await daemon.request("pub"), await daemon.request("sub")
                await until(lambda: pub.has_consumers)
                add_provider(s, p[1])
                await until(lambda: sub.providers)
                pub.send(b"asks for a floor")
                if pub.left_out:
                    self.skipTest("no multicast leaves this host")
                await asyncio.sleep(1)
                self.assertEqual(sub.received, 0)
                pub.send(b"x")
                self.assertEqual((await sub.receive(5)).payload, b"x")
                keys = keys_for(pub.life)
                recorded = b"".join(keys.seal_forward(Kind.MESSAGE, pub.life, 1, 1, b"asks for a floor", pub._frames.hello_port))
                self.assertTrue(pub._outlet.targets)
                pub._outlet.send(recorded, b"", b"")
                await until(lambda: sub.dropped == 2)
                await pub.close()
                await until(lambda: not sub.providers)

        self.run_async(story())


if __name__ == "__main__":
    unittest.main()
