"""Crowds of TCP connections to publishers, and of providers to subscribers; in virtual time."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import unittest
from unittest import mock

from meeting import met
from virtual import Daemon, Told, VirtualTestCase, add_consumer, add_provider, until

import geminga
from geminga.protocol.frame import Kind, read_datagram, write_frame
from geminga.protocol.handshake import Handshake
from geminga.protocol.limits import (
    END_SECONDS,
    MAX_FRAMES_FOR_ALL,
    MAX_FRAMES_FOR_CONSUMER,
    MAX_STRANGERS,
    MAX_TCP_CONSUMERS,
    MAX_TCP_PROVIDERS,
    MAX_WAITING_FOR_ALL,
    MAX_WAITING_FOR_CONSUMER,
    STRANGER_SECONDS,
    UNCONNECTED_SECONDS,
)
from geminga.protocol.send_queue import Pool, SendQueue, SharedFrame


def hello(pub: geminga.Publisher, life: int) -> bytes:
    return write_frame(Kind.HELLO, life, 0, Handshake(pub.life, 9, 0).write())


class Crowd(VirtualTestCase):
    def connected(self, pub: geminga.Publisher, octets: bytes = b"", source: str = "127.0.0.1") -> socket.socket:
        sock = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
        self.addCleanup(sock.close)
        sock.bind((source, 0))
        sock.connect(("127.0.0.1", pub.port))
        sock.sendall(octets)
        sock.setblocking(False)
        return sock

    async def heard(self, sock: socket.socket) -> bytes:
        """The octets up to the end of the connection."""
        octets = b""
        with contextlib.suppress(ConnectionResetError):
            while more := await asyncio.get_running_loop().sock_recv(sock, 1 << 20):
                octets += more
        return octets

    def test_connections_that_say_nothing_are_closed_after_five_seconds_and_wrong_hellos_at_once(self) -> None:
        async def story() -> None:
            async with met("oto", "tcp") as both:
                loop, pub = asyncio.get_running_loop(), both.pub
                begin = loop.time()
                silent, unknown = self.connected(pub), self.connected(pub, hello(pub, 99))
                right = Handshake(pub.life, 9, 0).write()
                for wrong in (
                    b"GET / HTTP/1.1\r\n\r\n        ",
                    write_frame(Kind.HELLO, 99, 0),
                    write_frame(Kind.HELLO, 99, 0, pub.life.to_bytes(8, "big")),
                    write_frame(Kind.HELLO, 99, 0, right[:-1]),
                    write_frame(Kind.HELLO, 99, 0, right + b"x"),
                    write_frame(Kind.HELLO, 99, 0, Handshake(pub.life ^ 1, 9, 0).write()),
                    write_frame(Kind.HELLO, 99, 0, Handshake(pub.life, 0, 0).write()),
                    write_frame(Kind.MESSAGE, 99, 0, right),
                ):
                    dropped = pub.dropped
                    self.assertEqual(await self.heard(self.connected(pub, wrong)), b"")
                    self.assertEqual(pub.dropped, dropped + 1)
                self.assertLess(loop.time() - begin, 1)
                self.assertEqual((await self.heard(silent), await self.heard(unknown)), (b"", b""))
                self.assertAlmostEqual(loop.time() - begin, STRANGER_SECONDS, delta=0.5)
                both.pub.send(b"x")
                self.assertEqual(await both.take(1), [b"x"])

        self.run_async(story())

    def test_64_strangers_have_a_place_and_another_address_takes_one(self) -> None:
        async def story(count: int) -> None:
            async with met("oto", "tcp") as both:
                loop, begin = asyncio.get_running_loop(), asyncio.get_running_loop().time()
                dropped = both.pub.dropped
                strangers = [self.connected(both.pub) for _ in range(count)]
                await until(lambda: len(both.pub._outlet._strangers) == min(count, MAX_STRANGERS))  # type: ignore[attr-defined]
                await asyncio.sleep(0.5)
                self.assertEqual(both.pub.dropped, dropped + max(0, count - MAX_STRANGERS))
                other = self.connected(both.pub, source="127.0.0.2")
                await asyncio.sleep(0.5)
                self.assertEqual(both.pub.dropped, dropped + max(0, count - MAX_STRANGERS + 1))
                self.assertEqual(await self.heard(other), b"")
                self.assertGreater(loop.time() - begin, STRANGER_SECONDS)
                for one in strangers:
                    one.close()

        for count in (MAX_STRANGERS - 1, MAX_STRANGERS, MAX_STRANGERS + 1):
            self.run_async(story(count))

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
            async with met("otm/stream", "tcp") as both:
                first = self.connected(both.pub, hello(both.pub, 7))
                await until(lambda: len(both.pub._outlet.targets) == 2)
                second = self.connected(both.pub, hello(both.pub, 7))
                self.assertEqual(await self.heard(first), b"")
                both.pub.send(b"x")
                octets = await asyncio.get_running_loop().sock_recv(second, 100)
                self.assertEqual(octets, write_frame(Kind.MESSAGE, both.pub.life, 1, b"x"))

        self.run_async(story())

    def test_256_consumers_are_sent_to_and_an_address_shares_its_places_with_others(self) -> None:
        async def story() -> None:
            async with met("otm/stream", "tcp") as both:
                pub, sockets = both.pub, []
                for life in range(1, MAX_TCP_CONSUMERS):
                    sockets.append(self.connected(pub, hello(pub, life)))
                    await until(lambda: len(pub._outlet.targets) == life + 1)  # noqa: B023
                self.assertEqual(both.told.problems, [])
                full = read_datagram(await self.heard(self.connected(pub, hello(pub, 999))))
                self.assertEqual((full.kind, full.payload), (Kind.FULL, Handshake(999, 9, 0).write()))
                other = self.connected(pub, hello(pub, 1000), source="127.0.0.2")
                full = read_datagram(await self.heard(sockets[-1]))
                self.assertEqual((full.kind, full.payload), (Kind.FULL, Handshake(MAX_TCP_CONSUMERS - 1, 9, 0).write()))
                pub.send(b"x")
                self.assertEqual(await asyncio.get_running_loop().sock_recv(other, 100), write_frame(Kind.MESSAGE, pub.life, 1, b"x"))
                self.assertEqual(await both.take(1), [b"x"])
                self.assertEqual(both.told.problems, [f"all {MAX_TCP_CONSUMERS} places for consumers are taken"])
                peer, _ = await both.daemon.request("pub")
                for one in sockets[: MAX_TCP_CONSUMERS // 4]:
                    one.close()
                await until(lambda: len(peer.of("pub", "modify")) == 2)
                self.assertEqual([line.get("channel.full") for line in peer.of("pub", "modify")], [str(MAX_TCP_CONSUMERS), "0"])

        self.run_async(story())

    def test_256_consumers_that_read_nothing_cost_their_frames_once(self) -> None:
        async def story() -> None:
            async with met("otm/stream", "tcp") as both:
                pub = both.pub
                for life in range(1, MAX_TCP_CONSUMERS):
                    self.connected(pub, hello(pub, life))
                    await until(lambda: len(pub._outlet.targets) == life + 1)  # noqa: B023
                payload, sent = bytes(256 * 1024), 0
                while pub.left_out < MAX_TCP_CONSUMERS:
                    pub.send(payload)
                    sent += 1
                    await both.sub.receive(5)
                    self.assertLess(sent, 100)
                self.assertLess(pub._outlet.waiting_octets, 3 * MAX_WAITING_FOR_CONSUMER)  # type: ignore[attr-defined]
                self.assertEqual(both.sub.missed, 0)
                await until(lambda: len(both.told.problems) == MAX_TCP_CONSUMERS - 1)  # once for each
                self.assertIn("is slow: messages to it are left out until it has taken some", both.told.problems[0])
                pub.abort()

        self.run_async(story())

    def test_of_all_that_wait_64_mebioctets_are_kept_and_then_the_slowest_consumer_goes(self) -> None:
        async def story(over: int) -> None:
            size = MAX_WAITING_FOR_ALL // 8
            async with met("oto", "tcp") as both:
                pub, loop = both.pub, asyncio.get_running_loop()
                peer, line = await both.daemon.request("pub")
                nothing = mock.patch("geminga.channels.tcp_connection.TcpConnection._sent", lambda self, pieces: 0)
                with nothing, mock.patch.object(loop, "add_writer"):
                    for life in range(1, 9):
                        peer.say(f"{line.id} sub add subscription=1a2b3c4d/3/{life} mode=oto address=127.0.0.1 channel={life:016x}")
                        self.connected(pub, hello(pub, life))
                        await until(lambda: len(pub._outlet.targets) == life + 1)  # noqa: B023
                        loop.passed += 1  # type: ignore[attr-defined]
                        if life == 1:
                            both.told.all.clear()
                        # More than a message of this size has no room beside what waits already.
                        pub.send(bytes(size - 24 + (over if life == 8 else 0)))
                    waits = pub._outlet.waiting_octets  # type: ignore[attr-defined]
                    await asyncio.sleep(0)
                    self.assertEqual(waits, MAX_WAITING_FOR_ALL + min(over, 0) if over <= 0 else waits)
                    await asyncio.sleep(0.1)
                    removed = [one for one in both.told.changes if one.startswith("removed")]
                    self.assertEqual(len(removed) > 0, over > 0)
                    self.assertEqual(set(removed), {"removed slow"} if over > 0 else set())
                pub.abort()

        for over in (-1, 0, 1):
            with self.subTest(over=over):
                self.run_async(story(over))

    def test_one_consumer_has_room_for_4_mebioctets_or_one_message(self) -> None:
        for size, kept in ((MAX_WAITING_FOR_CONSUMER // 4 - 1, 4), (MAX_WAITING_FOR_CONSUMER // 4, 4), (MAX_WAITING_FOR_CONSUMER // 4 + 1, 3)):
            pool = Pool()
            queues = [SendQueue(pool), SendQueue(pool)]
            for number in range(5):
                frame = SharedFrame(bytes(24), bytes(size - 24))
                for queue in queues:
                    self.assertEqual(queue.has_room_for(frame.octets), number < kept)
                    if number < kept:
                        queue.put(frame)
            self.assertEqual((pool.octets, queues[0].octets), (kept * size, kept * size))
            self.assertFalse(queues[0].took(size - 1))
            self.assertEqual(b"".join(bytes(one) for one in queues[0].pieces()), b"\0")
            self.assertTrue(queues[0].took(1))
            self.assertEqual((pool.octets, queues[0].octets), (kept * size, (kept - 1) * size))
            queues[1].clear()
            self.assertEqual(pool.octets, (kept - 1) * size)
            queues[0].took(5)
            queues[0].clear(keeps_begun=True)
            self.assertEqual((pool.octets, queues[0].octets, len(queues[0])), (size, size - 5, 1))
        self.assertTrue(SendQueue(Pool()).has_room_for(MAX_WAITING_FOR_CONSUMER + 1))

    def test_small_frames_are_limited_by_their_number(self) -> None:
        pool = Pool()
        queue = SendQueue(pool)
        for number in range(MAX_FRAMES_FOR_CONSUMER + 1):
            self.assertEqual(queue.has_room_for(24), number < MAX_FRAMES_FOR_CONSUMER)
            queue.put(SharedFrame(bytes(24)))
        self.assertEqual(pool.frames, MAX_FRAMES_FOR_CONSUMER + 1)
        queue.clear()
        self.assertEqual((pool.frames, pool.octets), (0, 0))
        for frames, octets, is_over in (
            (MAX_FRAMES_FOR_ALL - 1, 0, False), (MAX_FRAMES_FOR_ALL, 0, False), (MAX_FRAMES_FOR_ALL + 1, 0, True),
            (0, MAX_WAITING_FOR_ALL - 1, False), (0, MAX_WAITING_FOR_ALL, False), (0, MAX_WAITING_FOR_ALL + 1, True),
        ):  # fmt: skip
            pool.frames, pool.octets = frames, octets
            self.assertEqual(pool.is_over, is_over)


class Providers(VirtualTestCase):
    def test_256_have_a_place_and_an_honest_one_that_comes_later_is_connected(self) -> None:
        async def story(count: int) -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="otm/stream", protocol="tcp")
                sub = await node.subscribe(text="x", mode="otm/stream")
                p, (peer, line) = await daemon.request("pub"), await daemon.request("sub")
                with mock.patch("geminga.channels.tcp_inlet.TcpInlet._connect", self.never):
                    for number in range(1, count + 1):
                        place = f"address=10.0.0.{number % 6 + 1} port=9 protocol=tcp channel={number:016x}"
                        peer.say(f"{line.id} pub add service=1a2b3c4d/9/{number} mode=otm/stream {place}")
                    await until(lambda: len(sub.providers) == count)
                    self.assertEqual(len(sub._tcp._places), min(count, MAX_TCP_PROVIDERS))
                    problem = f"all {MAX_TCP_PROVIDERS} places for providers over TCP are taken"
                    self.assertEqual(told.problems, [problem] if count > MAX_TCP_PROVIDERS else [])
                add_provider((peer, line), p[1])
                await until(lambda: pub.has_consumers, 1)
                pub.send(b"x")
                self.assertEqual((await sub.receive(1)).payload, b"x")
                self.assertEqual(len(told.problems), 0 if count < MAX_TCP_PROVIDERS else 1)

        for count in (MAX_TCP_PROVIDERS - 1, MAX_TCP_PROVIDERS, MAX_TCP_PROVIDERS + 1, 1800):
            with self.subTest(count=count):
                self.run_async(story(count))

    @staticmethod
    async def never(_: object) -> None:
        await asyncio.get_running_loop().create_future()

    def test_a_place_that_is_not_connected_goes_to_others_in_turn(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            with mock.patch("geminga.channels.tcp_inlets.MAX_TCP_PROVIDERS", 2):
                async with geminga.connect("test", daemon.address, told) as node:
                    pub = await node.publish(text="x", mode="otm/stream", protocol="tcp")
                    sub = await node.subscribe(text="x", mode="otm/stream")
                    p, (peer, line) = await daemon.request("pub"), await daemon.request("sub")
                    for number in range(1, 6):
                        place = f"address=127.0.0.1 port=9 protocol=tcp channel={number:016x}"
                        peer.say(f"{line.id} pub add service=1a2b3c4d/9/{number} mode=otm/stream {place}")
                    add_provider((peer, line), p[1])
                    await until(lambda: len(sub.providers) == 6)
                    begin = asyncio.get_running_loop().time()
                    await until(lambda: pub.has_consumers)
                    self.assertAlmostEqual(asyncio.get_running_loop().time() - begin, 2 * UNCONNECTED_SECONDS, delta=1)
                    await asyncio.sleep(20)
                    self.assertTrue(pub.send(b"x"))
                    self.assertEqual((await sub.receive(1)).payload, b"x")
                    self.assertEqual(told.problems, ["all 2 places for providers over TCP are taken"])
                    peer.say(*(f"{line.id} pub del service=1a2b3c4d/9/{number} reason=withdrawn" for number in range(1, 6)))
                    await until(lambda: len(sub.providers) == 1)

        self.run_async(story())

    def test_a_provider_that_has_delivered_keeps_its_place(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            with mock.patch("geminga.channels.tcp_inlets.MAX_TCP_PROVIDERS", 2):
                async with geminga.connect("test", daemon.address, told) as node:
                    pub = await node.publish(text="x", mode="otm/stream", protocol="tcp")
                    sub = await node.subscribe(text="x", mode="otm/stream")
                    p, (peer, line) = await daemon.request("pub"), await daemon.request("sub")
                    words = f"{line.id} pub add service=1a2b3c4d/9/1 mode=otm/stream port=9 protocol=tcp"
                    peer.say(f"{words} address=127.0.0.1 channel=0000000000000001")
                    add_provider((peer, line), p[1])
                    await until(lambda: pub.has_consumers)
                    pub.send(b"1")
                    await sub.receive(1)
                    peer.say(f"{words.replace('9/1', '9/2')} address=127.0.0.2 channel=0000000000000002")
                    await until(lambda: len(sub.providers) == 3)
                    self.assertEqual([key for key in sub._tcp._places], [pub.life, 2])
                    pub.send(b"2")
                    self.assertEqual((await sub.receive(1)).payload, b"2")

        self.run_async(story())

    def test_a_match_that_outlasts_its_end_is_connected_again(self) -> None:
        async def story(change: str) -> None:
            async with met("otm/stream", "tcp") as both:
                _, pub = await both.daemon.request("pub")
                end = write_frame(Kind.END, both.pub.life, 0)
                next(iter(both.pub._outlet.targets.values())).connection.append(end)  # type: ignore[attr-defined]
                await until(lambda: both.told.changes == ["added", "removed withdrawn"])
                begin = asyncio.get_running_loop().time()
                if change == "modify":
                    add_provider(await both.daemon.request("sub"), pub, change="modify")
                elif change == "del":
                    await both.say("pub del service=1a2b3c4d/1/1 reason=withdrawn")
                    await asyncio.sleep(2 * END_SECONDS)
                    self.assertEqual((both.told.changes, both.pub.has_consumers), (["added", "removed withdrawn"], False))
                    return
                await until(lambda: both.pub.has_consumers and both.sub.providers)
                self.assertAlmostEqual(asyncio.get_running_loop().time() - begin, END_SECONDS, delta=1)
                both.pub.send(b"x")
                self.assertEqual((await both.sub.receive(1)).missed, 0)

        for change in ("", "modify", "del"):
            with self.subTest(change=change):
                self.run_async(story(change))


if __name__ == "__main__":
    unittest.main()
