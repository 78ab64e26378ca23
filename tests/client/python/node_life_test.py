"""A node and a daemon that comes, goes and comes back; in virtual time."""

from __future__ import annotations

import asyncio
import socket
import unittest

from virtual import Daemon, Told, VirtualTestCase, add_consumer, add_provider, until

import geminga
from geminga.channels.daemon_link import ANSWER_SECONDS
from geminga.protocol.limits import MAX_WAITING_EVENTS


class Life(VirtualTestCase):
    def test_the_daemon_may_start_later(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            await daemon.stop()
            async with geminga.connect("vision", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="oto")
                self.assertFalse(node.is_connected)
                await asyncio.sleep(100)
                await daemon.start()
                await pub.accepted()
                self.assertTrue(node.is_connected)
                self.assertEqual([type(one) for one in told.all], [geminga.Connected])
                self.assertEqual(daemon.peers[0].heard[0].parameters, {"name": "vision", "keys": "yes"})

        self.run_async(story())

    def test_a_daemon_that_comes_back_is_told_all_again(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="oto", attributes={"rate": 30, "port": True})
                await node.subscribe(text="y", mode="oto", where="rate > 5")
                await daemon.stop()
                await until(lambda: not node.is_connected)
                await daemon.start()
                await until(lambda: node.is_connected)
                _, again = await daemon.request("pub")
                self.assertEqual(again.get("channel"), f"{pub.life:016x}")
                self.assertEqual((again.get("attr.rate"), again.get("attr.port")), ("30", "1"))
                _, again = await daemon.request("sub")
                self.assertEqual((again.get("where"), again.get("protocol")), ("rate > 5", "udp,tcp"))
                words = [type(one).__name__ for one in told.all]
                self.assertEqual(words, ["Connected", "Disconnected", "Connected"])

        self.run_async(story())

    def test_it_is_looked_for_after_a_tenth_of_a_second_and_longer_each_time(self) -> None:
        async def story() -> None:
            loop = asyncio.get_running_loop()
            times: list[float] = []
            with socket.socket() as listener:
                listener.bind(("127.0.0.1", 0))
                listener.listen()
                listener.setblocking(False)

                def closed_at_once() -> None:
                    listener.accept()[0].close()
                    times.append(loop.time())

                loop.add_reader(listener, closed_at_once)
                async with geminga.connect("test", f"127.0.0.1:{listener.getsockname()[1]}"):
                    await until(lambda: len(times) == 7)
                loop.remove_reader(listener)
            for wait, least in zip((after - before for before, after in zip(times, times[1:])), (0.1, 0.2, 0.4, 0.8, 1.0, 1.0)):
                self.assertGreaterEqual(wait, least - 1e-6)
                self.assertLessEqual(wait, least * 1.25 + 0.2)

        self.run_async(story())

    def test_room_has_a_limit(self) -> None:
        for room in (0, 16_383, 16_384):
            geminga.connect(room=room)
        for room in (-1, 16_385):
            self.assertRaises(ValueError, lambda: geminga.connect(room=room))  # noqa: B023

    def test_who_does_not_answer_hello_is_no_daemon(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            daemon.answers_hello = False
            await daemon.start()
            async with geminga.connect("test", daemon.address, told):
                await until(lambda: len(daemon.peers) == 2)
                self.assertGreaterEqual(asyncio.get_running_loop().time(), ANSWER_SECONDS)
                self.assertEqual(told.all, [])

        self.run_async(story())

    def test_what_is_no_gcnp_ends_the_connection(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                await until(lambda: node.is_connected)
                daemon.peers[0].say("1 pub add service=\x01")
                await until(lambda: not node.is_connected)
                await until(lambda: node.is_connected)
                self.assertEqual(len(daemon.peers), 2)

        self.run_async(story())

    def test_what_is_refused_is_raised_and_not_stated_again(self) -> None:
        async def story() -> None:
            daemon = Daemon()
            daemon.answer = lambda peer, line: peer.say(f"{line.id} 422 no such name") if line.command == "pub" else None
            await daemon.start()
            async with geminga.connect("test", daemon.address) as node:
                await until(lambda: node.is_connected)
                with self.assertRaises(geminga.Refused) as caught:
                    await node.publish(concept="x:Y", mode="oto")
                self.assertEqual((caught.exception.code, caught.exception.text), (422, "no such name"))
                await daemon.stop()
                await daemon.start()
                await until(lambda: daemon.peers and daemon.peers[0].heard)
                self.assertEqual(daemon.peers[0].of("pub", "create"), [])

        self.run_async(story())

    def test_what_is_refused_later_is_told(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            async with geminga.connect("test", daemon.address, told) as node:
                sub = await node.subscribe(text="x", mode="oto")
                await until(lambda: node.is_connected)
                await sub.accepted()
                peer, line = await daemon.request("sub")
                add_provider((peer, line), line)
                await until(lambda: sub.providers)
                peer.say(f"{line.id} 429 taken back: others have less")
                await until(lambda: told.problems)
                self.assertEqual(told.problems, ["429 taken back: others have less"])
                self.assertEqual(told.changes, ["added", "removed refused"])

        self.run_async(story())

    def test_a_change_that_is_refused_is_raised(self) -> None:
        async def story() -> None:
            daemon = Daemon()
            daemon.answer = lambda peer, line: peer.say(f"{line.id} 422 where") if line.subcommand == "modify" else None
            await daemon.start()
            async with geminga.connect("test", daemon.address) as node:
                await until(lambda: node.is_connected)
                sub = await node.subscribe(text="x", mode="oto")
                with self.assertRaises(geminga.Refused):
                    await sub.modify(where="rate >")
                with self.assertRaises(ValueError):
                    await sub.modify(mode="otm/stream")
                await sub.close()
                with self.assertRaises(geminga.Closed):
                    await sub.modify(where="")

        self.run_async(story())

    def test_leaving_withdraws(self) -> None:
        async def story() -> None:
            daemon = Daemon()
            await daemon.start()
            async with geminga.connect("test", daemon.address) as node:
                await until(lambda: node.is_connected)
                async with node.publish(text="x", mode="oto"):
                    pass
                await until(lambda: daemon.peers[0].of("pub", "remove"))
                await node.subscribe(text="x", mode="oto")
                peer = daemon.peers[0]
            await until(lambda: peer.of("sys", "bye"))
            with self.assertRaises(geminga.Closed):
                await node.publish(text="x", mode="oto")

        self.run_async(story())

    def test_events_can_be_read_as_they_come(self) -> None:
        async def story() -> None:
            daemon = Daemon()
            await daemon.start()
            seen: list[str] = []

            async def read(node: geminga.Node) -> None:
                async for happening in node.events():
                    seen.append(type(happening).__name__)

            async with geminga.connect("test", daemon.address) as node:
                reader = asyncio.create_task(read(node))
                sub = await node.subscribe(text="x", mode="oto")
                peer, line = await daemon.request("sub")
                add_provider((peer, line), line)
                await until(lambda: sub.providers)
            await reader
            self.assertEqual(seen, ["ProviderChanged"])

        self.run_async(story())

    def test_of_events_that_nobody_reads_the_oldest_go_and_that_is_told(self) -> None:
        async def story() -> None:
            daemon = Daemon()
            await daemon.start()
            for count, lost in ((MAX_WAITING_EVENTS - 1, 0), (MAX_WAITING_EVENTS, 0), (MAX_WAITING_EVENTS + 1, 1)):
                async with geminga.connect("test", daemon.address) as node:
                    await until(lambda: node.is_connected)  # noqa: B023
                    events = node.events()
                    first = asyncio.ensure_future(anext(events))
                    await asyncio.sleep(0)
                    node.tell(geminga.Problem(None, "first"))
                    self.assertEqual(await first, geminga.Problem(None, "first"))
                    for number in range(count):
                        node.tell(geminga.Problem(None, str(number)))
                    if lost:
                        self.assertEqual(await anext(events), geminga.Problem(None, "1 events were thrown away: take them more often"))
                    self.assertEqual(await anext(events), geminga.Problem(None, str(lost)))

        self.run_async(story())

    def test_a_callback_that_fails_harms_nothing(self) -> None:
        async def story() -> None:
            daemon, contexts = Daemon(), []
            await daemon.start()
            asyncio.get_running_loop().set_exception_handler(lambda _, context: contexts.append(context))

            def fails(_: geminga.Happening) -> None:
                raise RuntimeError

            async with geminga.connect("test", daemon.address, fails) as node:
                await until(lambda: node.is_connected)
                await node.subscribe(text="x", mode="oto")
            self.assertEqual(len(contexts), 1)

        self.run_async(story())


class LifeOfChannels(VirtualTestCase):
    def test_a_stream_goes_on_without_a_gap_while_both_daemons_are_away(self) -> None:
        for mode, protocol in (("oto", "udp"), ("oto", "tcp"), ("otm/stream", "udp"), ("otm/stream", "tcp")):
            with self.subTest(mode=mode, protocol=protocol):
                self.run_async(self.goes_on(mode, protocol))

    async def goes_on(self, mode: str, protocol: str) -> None:
        daemon, told = Daemon(), Told()
        await daemon.start()
        async with geminga.connect("a", daemon.address, told) as one, geminga.connect("b", daemon.address, told) as other:
            pub = await one.publish(text="x", mode=mode, protocol=protocol)
            sub = await other.subscribe(text="x", mode=mode)
            heard: list[geminga.Message] = []

            async def read() -> None:
                async for message in sub:
                    heard.append(message)

            reader = asyncio.create_task(read())

            async def meet() -> None:
                p, s = await daemon.request("pub"), await daemon.request("sub")
                if mode != "otm/stream":
                    add_consumer(p, s[1], word=f"{asyncio.get_running_loop().time():08.0f}/2/1")
                add_provider(s, p[1], word=f"{asyncio.get_running_loop().time():08.0f}/1/1")

            async def send(count: int) -> None:
                for _ in range(count):
                    pub.send(b"x")
                    await asyncio.sleep(0.5)

            await meet()
            await until(lambda: pub.has_consumers)
            await send(10)
            await daemon.stop()
            await send(120)
            await daemon.start()
            await meet()
            await send(60)
            await until(lambda: len(heard) == 190)
            self.assertEqual([message.sequence for message in heard], list(range(1, 191)))
            self.assertEqual(set(told.changes), {"added"})
            await sub.close()
            await reader

    def test_who_is_not_confirmed_ends_behind_twenty_seconds(self) -> None:
        async def story() -> None:
            daemon, told = Daemon(), Told()
            await daemon.start()
            loop = asyncio.get_running_loop()
            async with geminga.connect("test", daemon.address, told) as node:
                pub = await node.publish(text="x", mode="oto")
                sub = await node.subscribe(text="x", mode="oto")
                p, s = await daemon.request("pub"), await daemon.request("sub")
                add_provider(s, p[1])
                add_consumer(p, s[1])
                await until(lambda: sub.providers and pub.consumers)
                await daemon.stop()
                await daemon.start()
                await until(lambda: node.is_connected)
                back = loop.time()
                await until(lambda: not sub.providers and not pub.consumers)
                self.assertAlmostEqual(loop.time() - back, 20, delta=0.5)
                self.assertEqual(told.changes[2:], ["removed disconnected", "removed disconnected"])
                self.assertFalse(pub.has_consumers)

        self.run_async(story())


if __name__ == "__main__":
    unittest.main()
