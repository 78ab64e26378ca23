"""Frames that come before the daemon names their provider (src/client/CHANNELS.md, "Early frames"); in virtual time."""

from __future__ import annotations

import asyncio
import contextlib
import socket
import unittest

from meeting import provider
from virtual import Daemon, Told, VirtualTestCase, add_consumer, add_provider, until

import geminga
from geminga.channels import multicast
from geminga.protocol.early_frames import EarlyFrames
from geminga.protocol.frame import Frame, Kind, write_frame
from geminga.protocol.limits import EARLY_SECONDS, MAX_EARLY_FRAMES, MAX_EARLY_OCTETS
from geminga.protocol.sealed_frame import AnyFrame

HERE, THERE = ("10.0.0.2", 5000), ("10.0.0.2", 5001)


def frame(sequence: int, size: int = 0, life: int = 7) -> Frame:
    return Frame(Kind.MESSAGE, life, sequence, bytes(size))


def sequences(frames: list[AnyFrame]) -> list[int]:
    return [one.sequence for one in frames]


class Keeping(unittest.TestCase):
    def test_in_order_by_address_and_life_and_once(self) -> None:
        early = EarlyFrames()
        for number, (there, life) in enumerate([(HERE, 7), (THERE, 7), (HERE, 8), (HERE, 7)]):
            early.put(there, frame(number, 1, life), 0.0)
        self.assertEqual(sequences(early.take(HERE, 7, 0.0)), [0, 3])
        self.assertEqual(sequences(early.take(HERE, 7, 0.0)), [])
        self.assertEqual(sequences(early.take(THERE, 7, 0.0)), [1])
        self.assertEqual(sequences(early.take(HERE, 8, 0.0)), [2])

    def test_of_64_frames_and_for_one_more_the_oldest_goes(self) -> None:
        for count, first in ((MAX_EARLY_FRAMES - 1, 0), (MAX_EARLY_FRAMES, 0), (MAX_EARLY_FRAMES + 1, 1)):
            early = EarlyFrames()
            for number in range(count):
                early.put(HERE, frame(number), 0.0)
            self.assertEqual(sequences(early.take(HERE, 7, 0.0)), list(range(first, count)))

    def test_of_256_kibioctets_and_for_one_more_the_oldest_goes(self) -> None:
        for size, kept in ((MAX_EARLY_OCTETS // 8 - 1, 8), (MAX_EARLY_OCTETS // 8, 8), (MAX_EARLY_OCTETS // 8 + 1, 7)):
            early = EarlyFrames()
            for number in range(8):
                early.put(HERE, frame(number, size), 0.0)
            self.assertEqual(len(early.take(HERE, 7, 0.0)), kept)
            early.put(HERE, frame(9, MAX_EARLY_OCTETS), 0.0)  # there is room again
            self.assertEqual(len(early.take(HERE, 7, 0.0)), 1)

    def test_for_a_second(self) -> None:
        for later, kept in ((EARLY_SECONDS - 0.001, [1, 2]), (EARLY_SECONDS, [2]), (EARLY_SECONDS + 0.001, [2]), (2 * EARLY_SECONDS, [])):
            early = EarlyFrames()
            early.put(HERE, frame(1), 0.0)
            early.put(HERE, frame(2), 0.5)
            self.assertEqual(sequences(early.take(HERE, 7, later)), kept)


def message(life: int, sequence: int) -> bytes:
    return write_frame(Kind.MESSAGE, life, sequence, b"%d" % sequence)


class Early(VirtualTestCase):
    def test_messages_are_delivered_when_the_daemon_tells_of_their_provider(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="otm/pubsub")
                sub = await node.subscribe(text="x", mode="otm/pubsub")
                p, s = await daemon.request("pub"), await daemon.request("sub")
                add_consumer(p, s[1])
                await until(lambda: pub.has_consumers)
                for octets in (b"one", b"two"):
                    pub.send(octets)
                await until(lambda: sub.dropped == 2)
                add_provider(s, p[1])
                await until(lambda: sub.providers)
                pub.send(b"three")
                got = [await sub.receive() for _ in range(3)]
                self.assertEqual([(one.payload, one.missed) for one in got], [(b"one", 0), (b"two", 0), (b"three", 0)])
                self.assertEqual((sub.received, sub.missed, sub.dropped), (3, 0, 0))

        self.run_async(story())

    def test_messages_of_a_provider_that_was_restarted_at_its_port_are_delivered(self) -> None:
        async def story() -> None:
            async with provider() as one:
                await one.add(5)
                await one.send(message(6, 1))
                await one.add(6, "1a2b3c4d/9/2")
                self.assertEqual((await one.sub.receive()).life, 6)
                self.assertEqual((one.sub.received, one.sub.dropped), (1, 0))

        self.run_async(story())

    def test_an_end_is_told_behind_the_messages_before_it(self) -> None:
        async def story() -> None:
            async with provider() as one:
                await one.send(message(5, 1), write_frame(Kind.END, 5, 3), message(5, 4))
                await one.add(5)
                one.to[0].say(f"{one.to[1].id} pub del service=1a2b3c4d/9/1 reason=expired")
                await until(lambda: len(one.told.changes) == 2)
                self.assertEqual(one.told.changes, ["added", "removed withdrawn"])
                self.assertEqual([(await one.sub.receive()).sequence for _ in range(2)], [1, 4])
                self.assertEqual((one.sub.received, one.sub.missed, one.sub.dropped), (2, 2, 0))

        self.run_async(story())

    def test_what_is_no_message_or_of_another_life_or_too_old_is_not(self) -> None:
        async def story() -> None:
            async with provider() as one:
                await one.send(message(5, 1))
                await asyncio.sleep(EARLY_SECONDS)
                await one.send(message(6, 2), write_frame(Kind.HELLO, 5, 0), b"no frame", message(5, 3))
                await one.add(5)
                self.assertEqual((await one.sub.receive()).sequence, 3)
                self.assertEqual((one.sub.received, one.sub.missed, one.sub.dropped), (1, 0, 4))

        self.run_async(story())

    def test_no_more_than_64_are_delivered(self) -> None:
        async def story() -> None:
            async with provider() as one:
                await one.send(*(message(5, sequence) for sequence in range(1, MAX_EARLY_FRAMES + 2)))
                await one.add(5)
                self.assertEqual((await one.sub.receive()).sequence, 2)
                self.assertEqual((one.sub.received, one.sub.dropped), (MAX_EARLY_FRAMES, 1))

        self.run_async(story())


class Groups(unittest.TestCase):
    def test_of_a_link_is_heard_with_and_without_a_zone(self) -> None:
        names = dict(socket.if_nameindex())
        for group in ("ff02::6677", *(f"ff02::6677%{name}" for name in names.values())):
            try:
                sock = multicast.listening(group, 0)
            except OSError as error:
                if not socket.has_ipv6 or "%" in group:
                    continue  # This host, or this interface, has no IPv6.
                with contextlib.closing(socket.socket(socket.AF_INET6, socket.SOCK_DGRAM)) as probe:
                    with contextlib.suppress(OSError):
                        probe.bind(("::1", 0))
                        raise AssertionError(f"{group}: {error}") from error
                self.skipTest("no IPv6 here")
            with sock:
                for index in names:
                    multicast.join(sock, group, index)
                self.assertEqual(sock.family, socket.AF_INET6)


if __name__ == "__main__":
    unittest.main()
