"""Sealed channels (src/client/CHANNELS.md, "Sealed channels"); in virtual time."""

from __future__ import annotations

import asyncio
import socket
import sys
import unittest
from unittest import mock

from meeting import Met, met
from team import GROUP, Consumer, keys_for, stream
from virtual import Daemon, Told, VirtualTestCase, add_consumer, add_provider, ring_of, until

import geminga
from geminga.protocol.frame import Kind, write_frame
from geminga.protocol.handshake import Handshake
from geminga.protocol.limits import STRANGER_SECONDS

CHANNELS = (("oto", "udp"), ("otm/pubsub", "udp"), ("otm/stream", "udp"), ("oto", "tcp"), ("otm/stream", "tcp"))


class Sealed(VirtualTestCase):
    async def exchange(self, both: Met, first: int, count: int = 10) -> None:
        for number in range(first, first + count):
            self.assertTrue(both.pub.send(b"%d" % number))
        got = [await both.sub.receive(30) for _ in range(count)]
        self.assertEqual([(one.payload, one.sequence, one.missed) for one in got], [(b"%d" % n, n, 0) for n in range(first, first + count)])

    def test_every_mode_and_protocol_delivers_in_order(self) -> None:
        async def story(mode: str, protocol: str, sealing: str) -> None:
            async with met(mode, protocol, sealing) as both:
                await self.exchange(both, 1)
                payload = b"a" + bytes(60_000) + b"z"
                both.pub.send(payload)
                self.assertEqual((await both.sub.receive()).payload, payload)
                await both.pub.close()
                await until(lambda: not both.sub.providers)
                self.assertEqual(both.told.changes[-1], "removed withdrawn")
                self.assertEqual((both.sub.missed, both.sub.dropped, both.told.problems), (0, 0, []))

        for mode, protocol in CHANNELS:
            for sealing in ("authenticated", "encrypted"):
                with self.subTest(mode=mode, protocol=protocol, sealing=sealing):
                    self.run_async(story(mode, protocol, sealing))

    def test_a_payload_is_read_by_nobody_else_where_it_is_encrypted(self) -> None:
        async def story(sealing: str, is_shown: bool) -> None:
            async with stream(sealing) as pub:
                consumer = Consumer(pub)
                await consumer.accepted()
                pub.send(b"the ball is here")
                octets = await asyncio.get_running_loop().sock_recv(consumer.sock, 1000)
                self.assertEqual((b"the ball is here" in octets, octets[2]), (is_shown, 3 if is_shown else 2))
                consumer.sock.close()

        self.run_async(story("encrypted", False))
        self.run_async(story("authenticated", True))

    def test_modes_follow_each_other_and_lose_nothing(self) -> None:
        async def story(mode: str, protocol: str) -> None:
            async with met(mode, protocol, "prepared") as both:
                loop, first = asyncio.get_running_loop(), 1
                for sealing in ("prepared", "mixed", "encrypted", "authenticated", "encrypted"):
                    both.daemon.rekey(sealing)
                    await asyncio.sleep(3)
                    await until(lambda: both.pub.has_consumers)
                    await self.exchange(both, first)
                    first += 10
                self.assertEqual((both.sub.missed, both.told.problems), (0, []))
                self.assertLess(loop.time(), 60)

        for mode, protocol in CHANNELS:
            with self.subTest(mode=mode, protocol=protocol):
                self.run_async(story(mode, protocol))

    def test_a_daemon_that_begins_to_seal_takes_its_channels_along(self) -> None:
        async def story(mode: str, protocol: str) -> None:
            async with met(mode, protocol) as both:
                await self.exchange(both, 1)
                (p, pub), (s, sub) = await both.daemon.request("pub"), await both.daemon.request("sub")
                for sealing in ("encrypted", "plain"):
                    both.daemon.sealing = sealing
                    for peer, line in ((p, pub), (s, sub)):
                        peer.say(f"0 msg sealing mode={sealing}")
                        both.daemon.give_keys(peer, line.id, pub.get("channel"))
                    await asyncio.sleep(5)
                    await until(lambda: both.pub.has_consumers)
                    self.assertTrue(both.pub.send(b"x"))
                    self.assertEqual((await both.sub.receive(30)).missed, 0)
                    self.assertEqual(both.pub._frames.seals, sealing == "encrypted")

        for mode, protocol in CHANNELS:
            with self.subTest(mode=mode, protocol=protocol):
                self.run_async(story(mode, protocol))

    def test_two_hosts_go_from_mode_to_mode_one_after_the_other_and_lose_nothing(self) -> None:
        async def story(mode: str, protocol: str, first: str, pause: float) -> None:
            daemons, told = [Daemon("prepared"), Daemon("prepared")], Told()
            for one in daemons:
                await one.start()
            async with geminga.connect("a", daemons[0].address, told) as a, geminga.connect("b", daemons[1].address, told) as b:
                pub = await a.publish(text="x", mode=mode, protocol=protocol)
                sub = await b.subscribe(text="x", mode=mode)
                p, s = await daemons[0].request("pub"), await daemons[1].request("sub")
                if mode != "otm/stream":
                    add_consumer(p, s[1])
                add_provider(s, p[1])
                await until(lambda: pub.has_consumers and sub.providers)
                count = 250

                async def send() -> None:
                    for _ in range(count):
                        self.assertTrue(pub.send(b"x"))
                        await asyncio.sleep(0.02)

                sending = asyncio.create_task(send())
                if first == "late":
                    daemons[0].rekey("mixed")
                    await asyncio.sleep(pause)
                    daemons[0].rekey("encrypted")
                for sealing in ("mixed", "encrypted", "authenticated", "encrypted"):
                    for one in reversed(daemons) if first == "subscriber" else daemons:
                        await asyncio.sleep(pause)
                        one.rekey(sealing)
                await sending
                await asyncio.sleep(10)
                got = [await sub.receive(30) for _ in range(count)]
                self.assertEqual([one.sequence for one in got], list(range(1, count + 1)))
                self.assertEqual((sub.missed, set(told.changes), told.problems), (0, {"added"}, []))

        for mode, protocol in CHANNELS:
            for first, pause in (("publisher", 0.05), ("publisher", 0.5), ("subscriber", 0.05)):
                with self.subTest(mode=mode, protocol=protocol, first=first, pause=pause):
                    self.run_async(story(mode, protocol, first, pause))
            if protocol == "tcp":  # The consumer's host is behind by a moment.
                self.run_async(story(mode, protocol, "late", 0.05))

    def test_a_consumer_that_says_no_sealed_hello_is_closed_after_five_seconds(self) -> None:
        async def story(protocol: str) -> None:
            daemons = [Daemon("prepared"), Daemon("prepared")]
            for one in daemons:
                await one.start()
            async with geminga.connect("a", daemons[0].address) as a, geminga.connect("b", daemons[1].address) as b:
                pub = await a.publish(text="x", mode="oto", protocol=protocol)
                await b.subscribe(text="x", mode="oto")
                p, s = await daemons[0].request("pub"), await daemons[1].request("sub")
                add_consumer(p, s[1])
                add_provider(s, p[1])
                await until(lambda: pub.has_consumers)
                await asyncio.sleep(1)
                daemons[0].rekey("encrypted")
                await until(lambda: not pub.has_consumers, STRANGER_SECONDS + 1)
                daemons[1].rekey("encrypted")
                await until(lambda: pub.has_consumers)

        for protocol in ("udp", "tcp"):
            self.run_async(story(protocol))

    def test_a_rotation_loses_nothing(self) -> None:
        async def story(mode: str, protocol: str) -> None:
            async with met(mode, protocol, "encrypted") as both:
                number = 0
                for ring in ((b"a",), (b"a", b"b"), (b"b", b"a"), (b"b",)):
                    both.daemon.rekey("encrypted", *ring)
                    for _ in range(20):
                        number += 1
                        both.pub.send(b"%d" % number)
                        await asyncio.sleep(0.1)
                got = [await both.sub.receive(30) for _ in range(60)]
                self.assertEqual({one.missed for one in got}, {0})
                self.assertEqual([one.sequence for one in got], list(range(got[0].sequence, got[0].sequence + 60)))

        for mode, protocol in CHANNELS:
            with self.subTest(mode=mode, protocol=protocol):
                self.run_async(story(mode, protocol))

    def test_nothing_is_sent_or_answered_before_the_keys_are_known(self) -> None:
        async def story() -> None:
            daemon = Daemon("encrypted")
            setattr(daemon, "give_keys", lambda *_: None)
            await daemon.start()
            async with geminga.connect("test", daemon.address) as node:
                udp = await node.publish(text="x", mode="otm/stream")
                tcp = await node.publish(text="x", mode="otm/stream", protocol="tcp")
                group = await node.publish(text="x", mode="otm/stream", address=GROUP)
                consumer = Consumer(udp)
                consumer.say()
                consumer.send(write_frame(Kind.HELLO, 7, 0, Handshake(udp.life, 1, 0).write()))
                with socket.create_connection(("127.0.0.1", tcp.port)) as stranger:
                    stranger.sendall(write_frame(Kind.HELLO, 7, 0, Handshake(tcp.life, 1, 0).write()))
                    stranger.setblocking(False)
                    await asyncio.sleep(1)
                    self.assertRaises(BlockingIOError, stranger.recv, 100)
                self.assertRaises(BlockingIOError, consumer.sock.recv, 100)
                self.assertEqual([one.send(b"x") for one in (udp, tcp, group)], [False] * 3)
                consumer.sock.close()

        self.run_async(story())

    def test_services_without_a_life_are_connected_while_plain_frames_are_taken(self) -> None:
        async def story() -> None:
            daemon, told = Daemon("encrypted"), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                sub = await node.subscribe(text="x", mode="oto")
                pub = await node.publish(text="x", mode="oto")
                with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as raw:
                    raw.bind(("127.0.0.1", 0))
                    raw.setblocking(False)
                    place = f"address=127.0.0.1 port={raw.getsockname()[1]}"
                    (peer, line), (_, other) = await daemon.request("sub"), await daemon.request("pub")
                    peer.say(f"{line.id} pub add service=1a2b3c4d/9/1 mode=oto {place} protocol=udp")
                    peer.say(f"{other.id} sub add subscription=1a2b3c4d/9/3 mode=oto {place}")
                    await until(lambda: len(told.problems) == 2)
                    self.assertEqual(told.problems, [f"1a2b3c4d/9/{n} states no life, so its channel cannot be sealed" for n in (1, 3)])
                    raw.sendto(b"as it is", ("127.0.0.1", sub._udp.port))  # type: ignore[union-attr]
                    await until(lambda: sub.dropped == 1)
                    self.assertFalse(pub.send(b"x"))
                    daemon.rekey("mixed")
                    await until(lambda: pub.has_consumers)
                    raw.sendto(b"as it is", ("127.0.0.1", sub._udp.port))  # type: ignore[union-attr]
                    self.assertEqual(await sub.receive(), geminga.Message(b"as it is"))
                    pub.send(b"the same")
                    self.assertEqual(raw.recv(100), b"the same")

        self.run_async(story())


class Keys(VirtualTestCase):
    def test_are_shown_nowhere(self) -> None:
        async def story() -> None:
            lines: list[str] = []
            daemon, told = Daemon("encrypted"), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told, log=lines.append) as node:
                pub = await node.publish(text="x", mode="oto")
                sub = await node.subscribe(text="x", mode="oto")
                p, s = await daemon.request("pub"), await daemon.request("sub")
                add_provider(s, p[1])
                await until(lambda: sub.providers)
                secret = ring_of(pub.life, daemon.secrets)[0][1].hex()
                for wrong in (f"mode=encrypted ring=6208:{secret}", f"mode=secret ring=6208:{secret}:{secret}", "mode=encrypted", f"ring={secret}"):
                    p[0].say(f"{p[1].id} pub keys life={pub.life:016x} {wrong}")
                await until(lambda: len(told.problems) == 3)
                keys = keys_for(pub.life)
                said = [repr(one) for one in (node, pub, sub, keys, pub._frames, told.all, vars(pub), vars(sub), node._session.__dict__)]
                for text in [*said, *lines, *told.problems]:
                    self.assertNotIn(secret, text)
                    self.assertNotIn(repr(bytes.fromhex(secret)), text)
                self.assertFalse(pub.send(b"x"))

        self.run_async(story())

    def test_that_cannot_be_used_any_more_close_the_channel(self) -> None:
        async def story(mode: str, protocol: str) -> None:
            async with met(mode, protocol) as both:
                both.pub.send(b"x")
                await both.take(1)
                (p, pub), (s, sub) = await both.daemon.request("pub"), await both.daemon.request("sub")
                for peer, number in ((p, pub.id), (s, sub.id)):
                    peer.say(f"{number} pub keys life={both.pub.life:016x} mode=encrypted ring=broken")
                await until(lambda: not both.pub.has_consumers)
                self.assertEqual((both.pub.send(b"secret"), both.sub.received), (False, 1))
                await until(lambda: len(both.told.problems) == 2)
                for peer, number in ((p, pub.id), (s, sub.id)):
                    both.daemon.sealing = "encrypted"
                    both.daemon.give_keys(peer, number, f"{both.pub.life:016x}")
                await until(lambda: both.pub.has_consumers)
                both.pub.send(b"y")
                self.assertEqual(await both.take(1), [b"y"])

        for mode, protocol in CHANNELS:
            with self.subTest(mode=mode, protocol=protocol):
                self.run_async(story(mode, protocol))

    def test_that_cannot_be_used_open_no_channel_and_that_is_told(self) -> None:
        async def story() -> None:
            daemon, told = Daemon("encrypted"), Told()
            await daemon.start()
            missing = {name: None for name in list(sys.modules) if name.split(".")[0] == "cryptography"} | {"cryptography": None}
            with mock.patch.dict(sys.modules, missing):
                async with geminga.connect("test", daemon.address, told) as node:
                    pub = await node.publish(text="x", mode="otm/stream")
                    sub = await node.subscribe(text="x", mode="otm/stream")
                    p, s = await daemon.request("pub"), await daemon.request("sub")
                    add_provider(s, p[1])
                    await until(lambda: len(told.problems) == 2)
                    for text in told.problems:
                        self.assertIn("python3-cryptography", text)
                    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
                        stranger.sendto(write_frame(Kind.HELLO, 5, 0, Handshake(pub.life, 9, 0).write()), ("127.0.0.1", pub.port))
                        await until(lambda: pub.dropped)
                    self.assertEqual((pub.send(b"x"), sub.received, sub._udp._greeted), (False, 0, {}))  # type: ignore[union-attr]

        self.run_async(story())


if __name__ == "__main__":
    unittest.main()
