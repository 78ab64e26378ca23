"""Publishers and subscribers with each other, and with strangers; in virtual time."""

from __future__ import annotations

import asyncio
import socket
import unittest

from meeting import met
from virtual import Daemon, Told, VirtualTestCase, add_consumer, add_provider, until

import geminga
from geminga.channels import sockets
from geminga.channels.outlet import COPIED_OCTETS
from geminga.protocol.limits import MAX_DATAGRAM_PAYLOAD, MAX_STREAM_PAYLOAD


class Exchange(VirtualTestCase):
    def test_every_mode_and_protocol_delivers_in_order(self) -> None:
        async def story(mode: str, protocol: str) -> None:
            async with met(mode, protocol) as both:
                for number in range(20):
                    self.assertTrue(both.pub.send(b"%d" % number))
                self.assertEqual(await both.take(20), [b"%d" % number for number in range(20)])
                self.assertEqual((both.sub.received, both.sub.missed, both.sub.dropped), (20, 0, 0))
                await both.pub.close()
                if protocol == "udp":  # Without a key the end is a hint.
                    await asyncio.sleep(1)
                    self.assertTrue(both.sub.providers)
                    await both.say("pub del service=1a2b3c4d/1/1 reason=expired")
                await until(lambda: not both.sub.providers)
                self.assertEqual(both.told.changes[-1], "removed withdrawn")

        for mode in ("oto", "otm/pubsub", "otm/stream"):
            for protocol in ("udp", "tcp"):
                with self.subTest(mode=mode, protocol=protocol):
                    self.run_async(story(mode, protocol))

    def test_one_consumer_more_or_less_is_sent_to_or_not(self) -> None:
        async def story(mode: str) -> None:
            async with met(mode, "udp") as both:
                (peer, pub), (_, sub) = await both.daemon.request("pub"), await both.daemon.request("sub")
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
                    other.bind(("127.0.0.1", 0))
                    other.setblocking(False)
                    told = f"subscription=1a2b3c4d/2/9 consumer=1a2b3c4d/2 text=x degree=exact distance=0 mode={mode}"
                    peer.say(f"{pub.id} sub add {told} address=127.0.0.1 port={other.getsockname()[1]} priority=0")
                    await until(lambda: len(both.pub.consumers) == 2)
                    self.assertTrue(both.pub.send(b"both"))
                    self.assertEqual(other.recv(100), b"both")
                    add_consumer((peer, pub), sub, change="del")
                    await until(lambda: len(both.pub.consumers) == 1)
                    self.assertTrue(both.pub.send(b"one"))
                    self.assertEqual(other.recv(100), b"one")
                    peer.say(f"{pub.id} sub del {told} reason=withdrawn")
                    await until(lambda: not both.pub.has_consumers)
                    self.assertFalse(both.pub.send(b"nobody"))
                    self.assertRaises(BlockingIOError, other.recv, 100)
                    add_consumer((peer, pub), sub)
                    await until(lambda: both.pub.has_consumers)
                    self.assertTrue(both.pub.send(b"again"))
                    self.assertEqual((await both.take(2))[-1], b"again")
                    self.assertEqual(both.pub.sent, 3)

        for mode in ("oto", "otm/pubsub"):
            with self.subTest(mode=mode):
                self.run_async(story(mode))

    def test_a_multicast_group_is_heard_by_those_who_were_told(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="otm/stream", address="239.66.3.9")
                sub = await node.subscribe(text="x", mode="otm/stream")
                if not pub.has_consumers or not pub.send(b"before"):
                    self.skipTest("no interface takes multicasts here")
                p, s = await daemon.request("pub"), await daemon.request("sub")
                add_provider(s, p[1])
                await until(lambda: sub.providers)
                if pub.send(b"x") and pub.left_out:
                    self.skipTest("no multicast leaves this host")
                self.assertEqual((await sub.receive()).payload, b"x")

        self.run_async(story())

    def test_without_a_consumer_nothing_is_sent_or_counted(self) -> None:
        async def story() -> None:
            async with geminga.connect("test", "127.0.0.1:1") as node:
                for mode, protocol in (("oto", "udp"), ("otm/pubsub", "udp"), ("otm/stream", "udp"), ("oto", "tcp")):
                    pub = await node.publish(text="x", mode=mode, protocol=protocol)
                    self.assertEqual((pub.send(b"x"), pub.sent, pub.has_consumers), (False, 0, False))

        self.run_async(story())

    def test_a_message_that_is_too_large_is_refused(self) -> None:
        async def story() -> None:
            async with met("oto", "udp") as both:
                with self.assertRaisesRegex(geminga.MessageTooLarge, "protocol=tcp"):
                    both.pub.send(bytes(MAX_DATAGRAM_PAYLOAD + 1))
                for size in (MAX_DATAGRAM_PAYLOAD - 1, MAX_DATAGRAM_PAYLOAD):
                    both.pub.send(bytes(size))
                    self.assertEqual(len((await both.sub.receive()).payload), size)
            async with met("oto", "tcp") as both:
                self.assertRaises(geminga.MessageTooLarge, both.pub.send, bytes(MAX_STREAM_PAYLOAD + 1))
                both.pub.send(bytes(MAX_STREAM_PAYLOAD))
                self.assertEqual(len((await both.sub.receive()).payload), MAX_STREAM_PAYLOAD)

        self.run_async(story())

    def test_messages_are_whole_whether_they_are_sent_in_one_piece_or_two(self) -> None:
        async def story(mode: str, protocol: str) -> None:
            async with met(mode, protocol) as both:
                for size in (COPIED_OCTETS - 1, COPIED_OCTETS, COPIED_OCTETS + 1, 60_000):
                    payload = b"a" + bytes(size - 2) + b"z"
                    self.assertTrue(both.pub.send(payload))
                    self.assertEqual((await both.sub.receive()).payload, payload)

        for mode, protocol in (("oto", "udp"), ("otm/stream", "udp"), ("oto", "tcp")):
            with self.subTest(mode=mode, protocol=protocol):
                self.run_async(story(mode, protocol))

    def test_nothing_is_lost_when_a_tcp_publisher_ends_whatever_comes_first(self) -> None:
        async def story() -> None:
            async with met("oto", "tcp") as both:
                for number in range(1000):
                    both.pub.send(b"%d" % number)
                await both.say("pub del service=1a2b3c4d/1/1 reason=withdrawn")
                closing = asyncio.create_task(both.pub.close())
                self.assertEqual(await both.take(1000), [b"%d" % number for number in range(1000)])
                await closing
                await until(lambda: both.told.changes[-1] == "removed withdrawn")

        self.run_async(story())

    def test_a_withdrawn_tcp_publisher_that_says_no_end_is_closed_behind_two_seconds(self) -> None:
        async def story() -> None:
            async with met("oto", "tcp") as both:
                loop = asyncio.get_running_loop()
                begin = loop.time()
                await both.say("pub del service=1a2b3c4d/1/1 reason=withdrawn")
                await until(lambda: "removed withdrawn" in both.told.changes)
                self.assertAlmostEqual(loop.time() - begin, 2, delta=0.5)

        self.run_async(story())

    def test_what_a_udp_socket_holds_is_read_before_it_is_withdrawn(self) -> None:
        async def story() -> None:
            async with met() as both:
                p, s = await both.daemon.request("pub"), await both.daemon.request("sub")
                s[0].say(f"{s[1].id} pub del service=1a2b3c4d/1/1 reason=withdrawn")
                both.pub.send(b"last")
                self.assertEqual(await both.take(1), [b"last"])

        self.run_async(story())

    def test_a_lazy_publisher_whose_port_is_taken_states_another_one(self) -> None:
        async def story() -> None:
            async with met("otm/pubsub") as both:
                before = both.pub.port
                p, s = await both.daemon.request("pub"), await both.daemon.request("sub")
                p[0].say(f"{p[1].id} sub del subscription=1a2b3c4d/2/1 reason=withdrawn")
                await until(lambda: not both.pub.has_consumers)
                with sockets.bound(socket.SOCK_DGRAM, before):
                    add_consumer(p, s[1])
                    await until(lambda: both.pub.has_consumers)
                    both.pub.send(b"x")
                    await until(lambda: p[0].of("pub", "modify"))
                self.assertEqual(p[0].of("pub", "modify")[0].get("port"), str(both.pub.port))
                self.assertNotEqual(both.pub.port, before)

        self.run_async(story())

    def test_a_stated_port_that_is_taken_is_an_error(self) -> None:
        async def story() -> None:
            async with geminga.connect("test", "127.0.0.1:1") as node:
                for protocol in ("udp", "tcp"):
                    pub = await node.publish(text="x", mode="oto", protocol=protocol)
                    with self.assertRaises(geminga.PortTaken):
                        await node.publish(text="y", mode="oto", protocol=protocol, port=pub.port)
                group = {"text": "x", "mode": "otm/stream", "address": "239.66.3.10"}
                with sockets.bound(socket.SOCK_DGRAM, 0) as taken:
                    with self.assertRaises(geminga.PortTaken):
                        await node.publish(**group, port=sockets.port_of(taken))  # type: ignore[arg-type]
                for wrong in ({"mode": "otm"}, {"mode": "oto", "protocol": "sctp"}):
                    with self.assertRaises(ValueError):
                        await node.publish(text="x", **wrong)  # type: ignore[arg-type]

        self.run_async(story())


class Waiting(VirtualTestCase):
    def test_of_udp_the_oldest_are_lost_or_the_newest(self) -> None:
        async def story(keep: str, kept: list[bytes], first: int, next_one: int) -> None:
            async with met(queue=3, keep=keep) as both:
                for number in range(5):
                    both.pub.send(b"%d" % number)
                await until(lambda: both.sub.received + both.sub.missed == 5)
                got = [await both.sub.receive() for _ in range(3)]
                self.assertEqual(([one.payload for one in got], got[0].missed), (kept, first))
                self.assertEqual((both.sub.received, both.sub.missed, both.sub.dropped), (3, 2, 0))
                both.pub.send(b"next")
                self.assertEqual((await both.sub.receive()).missed, next_one)

        self.run_async(story("newest", [b"2", b"3", b"4"], 2, 0))
        self.run_async(story("oldest", [b"0", b"1", b"2"], 0, 2))

    def test_of_tcp_nothing_is_lost_and_what_waits_is_limited(self) -> None:
        async def story() -> None:
            async with met("oto", "tcp", queue=2) as both:
                payload, sent = bytes(65_536), 0
                while both.pub.left_out == 0:
                    both.pub.send(payload)
                    sent += 1
                    await asyncio.sleep(0)
                    self.assertLess(sent, 10_000)
                both.pub.send(payload)
                kept = sent - 1
                self.assertEqual(both.pub.left_out, 2)
                messages = [await both.sub.receive() for _ in range(kept)]
                self.assertEqual([message.sequence for message in messages], list(range(1, kept + 1)))
                await both.pub.drain()
                both.pub.send(b"after")
                after = await both.sub.receive()
                self.assertEqual((after.payload, after.missed, both.sub.missed), (b"after", 2, 2))

        self.run_async(story())

    def test_receive_can_be_cancelled_and_loses_nothing(self) -> None:
        async def story() -> None:
            async with met() as both:
                for number in range(10):
                    first, second = asyncio.create_task(both.sub.receive()), asyncio.create_task(both.sub.receive())
                    await asyncio.sleep(0)
                    both.pub.send(b"%d" % number)
                    await until(lambda: both.sub.received == number + 1)  # noqa: B023
                    first.cancel()
                    done, _ = await asyncio.wait([first, second], timeout=1)
                    got = [task.result().payload for task in done if not task.cancelled()]
                    second.cancel()
                    self.assertEqual(got, [b"%d" % number])

        self.run_async(story())

    def test_closing_ends_the_iteration_behind_what_waits(self) -> None:
        async def story() -> None:
            async with met() as both:
                both.pub.send(b"x")
                await until(lambda: both.sub.received)
                await both.sub.close()
                self.assertEqual([message.payload async for message in both.sub], [b"x"])
                with self.assertRaises(geminga.Closed):
                    await both.sub.receive()
                await both.pub.close()
                self.assertRaises(geminga.Closed, both.pub.send, b"x")

        self.run_async(story())

    def test_who_takes_nothing_at_the_end_is_not_waited_for(self) -> None:
        async def story() -> None:
            async with met("oto", "tcp", queue=1) as both:
                while both.pub.left_out == 0:
                    both.pub.send(bytes(65_536))
                    await asyncio.sleep(0)
                begin = asyncio.get_running_loop().time()
                await both.pub.close()
                self.assertAlmostEqual(asyncio.get_running_loop().time() - begin, 5, delta=1)

        self.run_async(story())


if __name__ == "__main__":
    unittest.main()
