"""The blocking front, the quick start and the examples at a real daemon, that of GEMINGA_CONNECT."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
import time
import unittest

from virtual import ROOT

import geminga
import geminga.blocking

PATIENCE_SECONDS = 60.0
ENVIRONMENT = dict(os.environ, PYTHONPATH=str(ROOT / "src/client/python"))


def quick_start() -> list[str]:
    """The programs of README.md."""
    text = (ROOT / "src/client/python/README.md").read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```", text, re.DOTALL | re.MULTILINE)


def run_together(*commands: list[str]) -> list[str]:
    """The output of programs that have all ended well."""
    running = [
        subprocess.Popen([sys.executable, *command], env=ENVIRONMENT, stdout=subprocess.PIPE, text=True) for command in commands
    ]
    said = [one.communicate(timeout=PATIENCE_SECONDS)[0] for one in running]
    assert all(one.returncode == 0 for one in running), said
    return said


class Blocking(unittest.TestCase):
    def setUp(self) -> None:
        self.name = f"{self.id()}"

    def served(self, nodes: list[geminga.blocking.Node], is_so: object) -> None:
        """Lets the programs run, one after the other, until the condition holds."""
        end = time.monotonic() + PATIENCE_SECONDS
        while not is_so():  # type: ignore[operator]
            self.assertLess(time.monotonic(), end)
            for node in nodes:
                node.wait(0.001)

    def test_messages_go_from_one_to_the_other_without_a_thread(self) -> None:
        for mode, protocol in (("oto", "udp"), ("otm/pubsub", "tcp"), ("otm/stream", "udp"), ("otm/stream", "tcp")):
            text = f"{self.name} {mode} {protocol}"
            with geminga.blocking.connect("a") as one, geminga.blocking.connect("b") as other:
                pub = one.publish(text=text, mode=mode, protocol=protocol)
                sub = other.subscribe(text=text, mode=mode)
                self.served([one, other], lambda: pub.has_consumers and sub.providers)  # noqa: B023
                for number in range(100):
                    self.assertTrue(pub.send(b"%d" % number))
                got = [sub.receive(timeout=PATIENCE_SECONDS).payload for _ in range(100)]
                self.assertEqual(got, [b"%d" % number for number in range(100)])
                self.assertEqual(threading.active_count(), 1)
                with self.assertRaises(TimeoutError):
                    sub.receive(timeout=0.01)
                self.assertIsNone(sub.receive_now())

    def test_an_interrupt_ends_a_call_and_loses_nothing(self) -> None:
        with geminga.blocking.connect("a") as one, geminga.blocking.connect("b") as other:
            pub = one.publish(text=self.name, mode="oto")
            sub = other.subscribe(text=self.name, mode="oto")
            self.served([one, other], lambda: pub.consumers and sub.providers)
            assert other._served is not None
            other._served.loop.call_later(0.01, os.kill, os.getpid(), signal.SIGINT)
            with self.assertRaises(KeyboardInterrupt):
                sub.receive()
            pub.send(b"x")
            self.assertEqual(sub.receive(timeout=PATIENCE_SECONDS).payload, b"x")

    def test_what_is_refused_is_raised(self) -> None:
        with geminga.blocking.connect("a") as node:
            with self.assertRaises(geminga.Refused) as caught:
                node.publish(concept="soccer:NoSuchThing", mode="oto", timeout=PATIENCE_SECONDS)
            self.assertEqual(caught.exception.code, 422)
            pub = node.publish(text=self.name, mode="oto")
            with self.assertRaises(geminga.PortTaken):
                node.publish(text=self.name, mode="oto", port=pub.port)
            pub.modify({"rate": 3}, scope="host")
            pub.close()
            with self.assertRaises(geminga.Closed):
                pub.send(b"x")
        with self.assertRaises(geminga.Closed):
            node.publish(text=self.name, mode="oto")

    def test_a_daemon_that_is_away_is_no_error(self) -> None:
        with geminga.blocking.connect("a", connect="127.0.0.1:9") as node:
            with node.publish(text="x", mode="oto") as pub:
                self.assertFalse(pub.send(b"x"))
                with self.assertRaises(TimeoutError):
                    pub.accepted(timeout=0.01)
        self.assertRaises(ValueError, geminga.blocking.connect, "a", "nowhere")


class WhatIsWritten(unittest.TestCase):
    def test_the_quick_start_runs_as_it_is_written(self) -> None:
        publisher, subscriber = quick_start()
        _, said = run_together(["-c", publisher], ["-c", subscriber])
        self.assertEqual(said, "x=1 y=2\n" * 3)
        for program in (publisher, subscriber):
            self.assertLessEqual(len([line for line in program.splitlines() if line.strip()]), 10)

    def test_the_examples_meet(self) -> None:
        folder = ROOT / "examples/python"
        _, said = run_together([str(folder / "hello_publisher.py"), "3"], [str(folder / "hello_subscriber.py"), "3"])
        self.assertEqual([line.split('"number": ')[1] for line in said.splitlines()], ["1}", "2}", "3}"])


if __name__ == "__main__":
    unittest.main()
