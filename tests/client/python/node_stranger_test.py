"""Datagrams and connections of strangers to publishers and subscribers; in virtual time."""

from __future__ import annotations

import asyncio
import socket
import unittest
from unittest import mock

from meeting import met, provider
from virtual import Daemon, Told, VirtualTestCase, add_provider, until

import geminga
from geminga.protocol.frame import Kind, read_datagram, write_frame
from geminga.protocol.handshake import Handshake, read_handshake
from geminga.protocol.limits import COOKIE_SECONDS, END_SECONDS, LISTENER_SECONDS, MAX_ANSWERS, MAX_LISTENERS


class Listener:
    """A socket that says hello to a publisher."""

    def __init__(self, pub: geminga.Publisher, life: int = 5) -> None:
        self.pub, self.life = pub, life
        self.sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.sock.setblocking(False)
        self.sock.bind(("127.0.0.1", 0))

    def __enter__(self) -> Listener:
        return self

    def __exit__(self, *_: object) -> None:
        self.sock.close()

    def send(self, octets: bytes) -> None:
        self.sock.sendto(octets, ("127.0.0.1", self.pub.port))

    def say(self, cookie: int = 0, challenge: int = 9, life: int = 0) -> bytes:
        hello = write_frame(Kind.HELLO, self.life, 0, Handshake(life or self.pub.life, challenge, cookie).write())
        self.send(hello)
        return hello

    async def hear(self) -> bytes:
        return await asyncio.get_running_loop().sock_recv(self.sock, 1000)

    def cookie_of(self, octets: bytes) -> int:
        frame = read_datagram(octets)
        said = read_handshake(frame.payload)
        assert frame.kind is Kind.FLOOR and said is not None and (said.life, said.challenge) == (self.life, 9)
        return said.cookie

    async def cookie(self) -> int:
        self.say()
        return self.cookie_of(await self.hear())

    async def accepted(self) -> None:
        self.say(await self.cookie())
        assert self.cookie_of(await self.hear()) == 0


class Strangers(VirtualTestCase):
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
                with Listener(both.pub) as one:
                    one.say(life=both.pub.life ^ 1)
                    one.send(write_frame(Kind.HELLO, 5, 0, both.pub.life.to_bytes(8, "big")))
                    one.say(challenge=0)
                    await until(lambda: both.pub.dropped == 3)
                    await one.accepted()
                    begin = asyncio.get_running_loop().time()
                    await until(lambda: not both.pub.has_consumers)
                    self.assertAlmostEqual(asyncio.get_running_loop().time() - begin, LISTENER_SECONDS, delta=0.5)

        self.run_async(story())

    def test_nothing_but_a_floor_of_its_size_is_sent_to_an_address_that_has_not_shown_to_receive(self) -> None:
        async def story() -> None:
            async with met("otm/stream") as both:
                with Listener(both.pub) as one:
                    for cookie in (0, 1, 2**64 - 1):
                        hello = one.say(cookie)
                        floor = await one.hear()
                        self.assertEqual(len(floor), len(hello))
                        both.pub.send(b"secret")
                        self.assertRaises(BlockingIOError, one.sock.recv, 100)
                    right = await one.cookie()
                    with Listener(both.pub) as other:
                        other.say(right)
                        self.assertNotIn(other.cookie_of(await other.hear()), (0, right))
                    await asyncio.sleep(2 * COOKIE_SECONDS)
                    one.say(right)
                    self.assertNotIn(one.cookie_of(await one.hear()), (0, right))

        self.run_async(story())

    def test_no_more_than_512_answers_a_second_are_given(self) -> None:
        async def story() -> None:
            async with met("otm/stream") as both:
                reception = both.pub._outlet._reception  # type: ignore[attr-defined]
                hello = write_frame(Kind.HELLO, 5, 0, Handshake(both.pub.life, 9, 0).write())
                await asyncio.sleep(1.5)
                with mock.patch("geminga.channels.reception.sockets.send_datagram") as sent:
                    for seconds in (0, 1, 0.5):
                        loop = asyncio.get_running_loop()
                        loop.passed += seconds  # type: ignore[attr-defined]
                        before = sent.call_count
                        for port in range(1, MAX_ANSWERS + 10):
                            reception._heard(hello, ("127.0.0.9", port))
                        self.assertEqual(sent.call_count - before, MAX_ANSWERS if seconds != 0.5 else MAX_ANSWERS // 2)

        self.run_async(story())

    def test_1024_listeners_of_one_host_have_a_place_and_others_take_theirs(self) -> None:
        async def story(count: int) -> None:
            async with met("otm/stream") as both:
                reception, loop = both.pub._outlet._reception, asyncio.get_running_loop()  # type: ignore[attr-defined]
                said: dict[tuple[object, ...], list[Kind]] = {}

                def answer(_: object, octets: bytes, there: tuple[object, ...]) -> bool:
                    frame = read_datagram(octets)
                    payload = read_handshake(frame.payload)
                    if payload is not None and payload.cookie:
                        cookies[there] = payload.cookie
                    else:
                        said.setdefault(there, []).append(frame.kind)
                    return True

                cookies: dict[tuple[object, ...], int] = {}
                listener = both.pub._outlet.targets[0]  # type: ignore[index]
                with mock.patch("geminga.channels.reception.sockets.send_datagram", answer):
                    for number in range(1, count + 1):
                        loop.passed += 0.004  # type: ignore[attr-defined]
                        here = (listener[0] if number <= MAX_LISTENERS + 1 else "10.0.0.9", number, *listener[2:])
                        reception._heard(write_frame(Kind.HELLO, number, 0, Handshake(both.pub.life, 9, 0).write()), here)
                        reception._heard(write_frame(Kind.HELLO, number, 0, Handshake(both.pub.life, 9, cookies[here]).write()), here)
                refused = [there for there, kinds in said.items() if kinds == [Kind.FULL]]
                lost = [there for there, kinds in said.items() if kinds == [Kind.FLOOR, Kind.FULL]]
                self.assertEqual(len(both.pub._outlet.targets), min(1 + count, MAX_LISTENERS))
                wanted = {MAX_LISTENERS - 1: (0, 0), MAX_LISTENERS: (1, 0), MAX_LISTENERS + 5: (2, 4)}[count]
                self.assertEqual((len(refused), len(lost)), wanted)
                full = [f"all {MAX_LISTENERS} places for listeners are taken"]
                self.assertEqual(both.told.problems, full if refused else [])
                peer, _ = await both.daemon.request("pub")
                await until(lambda: len(both.pub._outlet.targets) == 1)
                await until(lambda: len(peer.of("pub", "modify")) == 2 * bool(refused))
                stated = [line.get("channel.full") for line in peer.of("pub", "modify")]
                self.assertEqual(stated, [str(MAX_LISTENERS), "0"] if refused else [])

        self.run_async(story(MAX_LISTENERS - 1))
        self.run_async(story(MAX_LISTENERS))
        self.run_async(story(MAX_LISTENERS + 5))

    def test_a_subscriber_that_finds_no_place_is_told_and_goes_on_asking(self) -> None:
        async def story(protocol: str) -> None:
            with mock.patch("geminga.protocol.listeners.MAX_LISTENERS", 1), mock.patch("geminga.channels.tcp_outlet.MAX_TCP_CONSUMERS", 1):
                async with met("otm/stream", protocol) as both:
                    other = await both.node.subscribe(text="x", mode="otm/stream")
                    (_, pub), to = await both.daemon.request("pub"), await both.daemon.request("sub", 1)
                    add_provider(to, pub)
                    await until(lambda: len(both.told.problems) == 2)
                    await asyncio.sleep(10)
                    text = f"the provider 127.0.0.1:{both.pub.port} has no place for another consumer"
                    self.assertIn(text, both.told.problems)
                    self.assertEqual(len(both.told.problems), 2)
                    await both.sub.close()
                    await asyncio.sleep(2)
                    both.pub.send(b"x")
                    self.assertEqual((await other.receive(5)).payload, b"x")

        self.run_async(story("udp"))
        self.run_async(story("tcp"))

    def test_a_forged_sequence_mutes_for_two_seconds_and_a_forged_end_for_none(self) -> None:
        async def story() -> None:
            async with provider() as one:
                await one.add(5)
                for octets in (write_frame(Kind.MESSAGE, 5, 10, b"10"), write_frame(Kind.MESSAGE, 5, 2**64 - 1), write_frame(Kind.END, 5, 2**64 - 1)):
                    one.sock.sendto(octets, ("127.0.0.1", one.sub._udp.port))  # type: ignore[union-attr]
                for number in (11, 12):
                    one.sock.sendto(write_frame(Kind.MESSAGE, 5, number, b"%d" % number), ("127.0.0.1", one.sub._udp.port))  # type: ignore[union-attr]
                self.assertEqual([(m.sequence, m.missed) for m in [await one.sub.receive() for _ in range(3)]], [(10, 0), (11, 0), (12, 0)])
                await asyncio.sleep(END_SECONDS)
                one.to[0].say(f"{one.to[1].id} pub del service=1a2b3c4d/9/1 reason=expired")
                await asyncio.sleep(1)
                self.assertEqual((one.told.changes, one.sub.missed), (["added"], 0))

        self.run_async(story())

    def test_a_sequence_is_forged_first(self) -> None:
        async def story() -> None:
            async with provider() as one:
                await one.add(5)
                one.sock.sendto(write_frame(Kind.MESSAGE, 5, 2**64 - 1, b""), ("127.0.0.1", one.sub._udp.port))  # type: ignore[union-attr]
                await one.sub.receive()
                await asyncio.sleep(2)
                for number in (11, 12):
                    one.sock.sendto(write_frame(Kind.MESSAGE, 5, number, b"%d" % number), ("127.0.0.1", one.sub._udp.port))  # type: ignore[union-attr]
                self.assertEqual((await one.sub.receive()).sequence, 12)
                self.assertEqual((one.sub.missed, one.sub.dropped), (0, 1))

        self.run_async(story())


if __name__ == "__main__":
    unittest.main()
