"""Lines of the log hook and errors of calls (src/client/CHANNELS.md, "The log hook"); in virtual time."""

from __future__ import annotations

import asyncio
import contextlib
import io
import os
import socket
import subprocess
import sys
import unittest
from collections.abc import Callable
from typing import Any
from unittest import mock

from meeting import met
from virtual import ROOT, Daemon, VirtualTestCase, until

import geminga
import geminga.log


class Lines(VirtualTestCase):
    def test_a_missing_daemon_is_said_once_after_a_second_and_when_it_is_back(self) -> None:
        async def story() -> None:
            lines: list[str] = []
            daemon = Daemon()
            await daemon.start()
            await daemon.stop()
            there, loop = daemon.address, asyncio.get_running_loop()
            async with geminga.connect("test", there, log=lines.append) as node:
                await asyncio.sleep(0.9 - loop.time())
                self.assertEqual(lines, [])
                await asyncio.sleep(100)
                away = f"no daemon at {there} for 1 s (Connection refused): start gemingad, or say where it is with GEMINGA_CONNECT"
                self.assertEqual(lines, [away])
                await daemon.start()
                await until(lambda: node.is_connected)
                self.assertEqual(lines[1:], [f"the daemon at {there} answers"])
                await daemon.stop()
                await daemon.start()
                await until(lambda: node.is_connected and len(daemon.peers) == 1)
                self.assertEqual(len(lines), 2)  # it was back within a second
                await daemon.stop()
                await asyncio.sleep(5)
                self.assertEqual(lines[2:], [away])

        self.run_async(story())

    def test_a_place_is_written_as_it_is_stated(self) -> None:
        async def story() -> None:
            for place in ("[::1]:9", "/nowhere/at all", "unix:/nowhere"):
                lines: list[str] = []
                async with geminga.connect("test", place, log=lines.append):
                    await asyncio.sleep(1.5)
                self.assertIn(f"no daemon at {place.removeprefix('unix:')} for 1 s (", lines[0])

        self.run_async(story())

    def test_a_refused_request_is_said_with_the_daemons_text(self) -> None:
        async def story() -> None:
            lines: list[str] = []
            daemon = Daemon()
            daemon.answer = lambda peer, line: peer.say(f"{line.id} 422 no such name") if line.command == "pub" else None
            await daemon.start()
            async with geminga.connect("test", daemon.address, log=lines.append) as node:
                with contextlib.suppress(geminga.Refused):
                    await node.publish(concept="x:Y", representation="x:Z", mode="oto")
            self.assertEqual(lines, ["the request mode=oto concept=x:Y representation=x:Z is refused: no such name"])

        self.run_async(story())

    def test_events_that_are_thrown_away_are_said_once_until_they_are_taken(self) -> None:
        async def story() -> None:
            lines: list[str] = []
            daemon = Daemon()
            await daemon.start()
            async with geminga.connect("test", daemon.address, log=lines.append) as node:
                with mock.patch("geminga.node.MAX_WAITING_EVENTS", 2):
                    events = node.events()
                    first = asyncio.ensure_future(anext(events))
                    await asyncio.sleep(0)
                    node.tell(geminga.Disconnected())
                    await first
                    for _ in range(3):
                        node.tell(geminga.Disconnected())
                        node.tell(geminga.Disconnected())
                    self.assertEqual(await anext(events), geminga.Problem(None, "4 events were thrown away: take them more often"))
            self.assertEqual(lines, ["1 events were thrown away: take them more often"])

        self.run_async(story())

    def test_lines_go_to_standard_error_unless_told(self) -> None:
        # virtual.py makes the lines of other tests silent, so this one asks a program of its own.
        program = "import geminga.log; geminga.log.Log(None, print).say('said'); geminga.log.Log(print, print).say('hooked')"
        environment = dict(os.environ, PYTHONPATH=str(ROOT / "src/client/python"))
        done = subprocess.run([sys.executable, "-B", "-c", program], env=environment, capture_output=True, text=True, check=True)
        self.assertEqual((done.stderr, done.stdout), ("geminga: said\n", "hooked\n"))

    def test_a_hook_that_fails_harms_nothing(self) -> None:
        failed: list[Exception] = []
        geminga.log.Log(lambda line: 1 // 0, failed.append).say("x")
        self.assertIsInstance(failed[0], ZeroDivisionError)


class Errors(VirtualTestCase):
    def test_wrong_arguments_are_named_with_their_values(self) -> None:
        async def story() -> None:
            daemon = Daemon()
            await daemon.start()
            async with geminga.connect("test", daemon.address) as node:
                fine: dict[str, Any] = {"text": "x", "mode": "oto"}
                cases: tuple[tuple[str, dict[str, Any], type[Exception], str], ...] = (
                    ("publish", {"port": 99999}, ValueError, "port is 1 to 65535, or 0 for any, not 99999"),
                    ("publish", {"port": -1}, ValueError, "port is"),
                    ("publish", {"port": "5000"}, TypeError, "port is a number .* not str"),
                    ("subscribe", {"port": 65536}, ValueError, "port is"),
                    ("publish", {"mode": "otm"}, ValueError, "mode is one of oto, otm/stream, otm/pubsub, not 'otm'"),
                    ("publish", {"protocol": "sctp"}, ValueError, "protocol is udp or tcp, not 'sctp'"),
                    ("publish", {"protocol": "udp,tcp"}, ValueError, "protocol is udp or tcp"),
                    ("subscribe", {"protocol": "udp,sctp"}, ValueError, "protocol is udp or tcp, or both, not 'udp,sctp'"),
                    ("subscribe", {"limit": -1}, ValueError, "limit is"),
                    ("publish", {"text": None, "concept": ""}, ValueError, "concept is empty"),
                    ("subscribe", {"match": ""}, ValueError, "match is empty"),
                    ("publish", {"attributes": {"": 1}}, ValueError, "an attribute has an empty name"),
                    ("publish", {"prot": "udp"}, TypeError, "prot"),
                    ("subscribe", {"keep": "all"}, ValueError, "keep is newest or oldest"),
                    ("subscribe", {"queue": 0}, ValueError, "room for one message"),
                )
                for call, wrong, error, text in cases:
                    with self.subTest(wrong=wrong), self.assertRaisesRegex(error, text):
                        await getattr(node, call)(**{**fine, **wrong})
                for port in (0, 1, 65535):
                    with contextlib.suppress(geminga.PortTaken, PermissionError):
                        await (await node.publish(**fine, port=port)).close()
                pub = await node.publish(**fine)
                with self.assertRaisesRegex(TypeError, "no parameter 'rat'"):
                    await pub.modify(rat=3)
                with self.assertRaisesRegex(ValueError, "cannot be changed"):
                    await pub.modify(port=5)
            for name, room, text in (("", 0, "name is empty"), ("x", 16_385, "room is 0 to 16384, not 16385")):
                with self.assertRaisesRegex(ValueError, text):
                    geminga.connect(name, room=room)
            geminga.connect()

        self.run_async(story())

    def test_a_payload_is_octets(self) -> None:
        async def story() -> None:
            async with met() as both:
                for wrong, text in (("text", r"not str: encode the text, as in text.encode\(\)"), (5, "not int"), ([1, 2], "not list"), (None, "not")):
                    with self.assertRaisesRegex(TypeError, text):
                        both.pub.send(wrong)  # type: ignore[arg-type]
                for right in (b"\x01\x02\x03\x04", bytearray(b"\x01\x02\x03\x04"), memoryview(b"\x01\x02\x03\x04").cast("I")):
                    both.pub.send(right)
                    self.assertEqual((await both.sub.receive()).payload, b"\x01\x02\x03\x04")

        self.run_async(story())

    def test_receive_raises_timeout_error(self) -> None:
        async def story() -> None:
            async with met() as both:
                begin = asyncio.get_running_loop().time()
                with self.assertRaises(TimeoutError):
                    await both.sub.receive(2)
                self.assertAlmostEqual(asyncio.get_running_loop().time() - begin, 2, delta=0.1)
                both.pub.send(b"x")
                self.assertEqual((await both.sub.receive(2)).payload, b"x")

        self.run_async(story())


class Forks(unittest.TestCase):
    def test_a_child_of_a_fork_does_not_send(self) -> None:
        for sealing in ("", "encrypted"):
            out, into = os.pipe()
            with contextlib.redirect_stderr(io.StringIO()), asyncio.Runner() as runner:
                runner.run(self.story(sealing, into))
            os.close(into)
            with open(out, encoding="utf-8") as said:
                self.assertEqual(said.read(), "this node belongs to another process\n" * 4)

    async def story(self, sealing: str, into: int) -> None:
        daemon = Daemon(sealing)
        await daemon.start()
        async with geminga.connect("test", daemon.address) as node:
            pub = await node.publish(text="x", mode="otm/stream")
            sub = await node.subscribe(text="x", mode="otm/stream")
            p, s = await daemon.request("pub"), await daemon.request("sub")
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as provider:
                provider.bind(("127.0.0.1", 0))
                daemon.give_keys(s[0], s[1].id, "0000000000000005")
                s[0].say(
                    f"{s[1].id} pub add service=1a2b3c4d/9/1 mode=otm/stream address=127.0.0.1 port={provider.getsockname()[1]} "
                    "protocol=udp channel=0000000000000005"
                )
                await until(lambda: sub.providers and p)
                child = os.fork()
                if child == 0:
                    self.try_all(node, pub, sub, into)
                os.waitpid(child, 0)
                pub.send(b"x")
        await daemon.stop()

    def try_all(self, node: geminga.Node, pub: geminga.Publisher, sub: geminga.Subscriber, into: int) -> None:
        """Runs in the child, and ends it."""
        try:
            calls: tuple[Callable[[], object], ...] = (
                lambda: pub.send(b"x"),
                lambda: node.close().send(None),
                lambda: node.publish(text="y", mode="oto").__await__().send(None),
                lambda: sub._frames.write(sub._counterparts.get(5).belief.keys, 2, b""),  # type: ignore[union-attr,arg-type]
            )
            for call in calls:
                try:
                    call()
                    os.write(into, b"nothing\n")
                except Exception as error:
                    os.write(into, f"{error}\n".encode())
        finally:
            os._exit(0)


if __name__ == "__main__":
    unittest.main()
