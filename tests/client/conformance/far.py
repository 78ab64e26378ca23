"""How many round trips pass between `pub add` and the first message: two hosts with so long a way between them that nothing
else counts.

Each host has a TAP interface, and knows the other's place on it, so that nobody asks for that; what comes out of the one goes
into the other after half a round trip. The conformance agents (AGENT.md) say what they are told, and
when is when their line comes.
"""

from __future__ import annotations

import fcntl
import heapq
import itertools
import os
import select
import struct
import subprocess
import threading
import time
from collections.abc import Sequence
from pathlib import Path

from lab import LINK, Lab
from spoken import Spoken

TUNSETIFF, IFF_TAP, IFF_NO_PI = 0x400454CA, 0x0002, 0x1000
_LABELS = itertools.count(1)


class Way:
    """Two interfaces, and a thread that takes frames from the one to the other."""

    def __init__(self, half_seconds: float) -> None:
        self.names = [f"far{number}" for number in range(2)]
        self._half = half_seconds
        self._files = [self._open(name) for name in self.names]
        self._is_open = True
        self._thread = threading.Thread(target=self._carry, daemon=True)

    @staticmethod
    def _open(name: str) -> int:
        file = os.open("/dev/net/tun", os.O_RDWR | os.O_NONBLOCK)
        fcntl.ioctl(file, TUNSETIFF, struct.pack("16sH22x", name.encode(), IFF_TAP | IFF_NO_PI))
        return file

    def start(self) -> None:
        self._thread.start()

    def _carry(self) -> None:
        under_way: list[tuple[float, int, int, bytes]] = []
        numbers = itertools.count()
        while self._is_open:
            patience = under_way[0][0] - time.monotonic() if under_way else 0.1
            readable, _, _ = select.select(self._files, [], [], max(0.0, min(patience, 0.1)))
            for file in readable:
                other = self._files[1 - self._files.index(file)]
                heapq.heappush(under_way, (time.monotonic() + self._half, next(numbers), other, os.read(file, 65536)))
            while under_way and under_way[0][0] <= time.monotonic():
                _, _, to, packet = heapq.heappop(under_way)
                try:
                    os.write(to, packet)
                except OSError:
                    pass  # its interface is not up yet

    def close(self) -> None:
        self._is_open = False
        self._thread.join()
        for file in self._files:
            os.close(file)


class FarLab:
    """Two hosts with a daemon each that are so far from each other. Raises OSError where it cannot be made."""

    def __init__(self, gemingad: Path, round_trip_seconds: float) -> None:
        self.lab = Lab(str(gemingad), [])
        self._way: Way | None = None
        try:
            if not self.lab.has_namespaces:
                raise OSError("no namespace may be made")
            self._way = Way(round_trip_seconds / 2)
            self._replace(self._way)
            self.lab.start_daemons()
            time.sleep(round_trip_seconds * 4)  # until both have heard each other's answers
        except BaseException:
            self.close()
            raise

    def _replace(self, way: Way) -> None:
        """The lab's link by the far one."""
        for host, holder, name in zip(self.lab.hosts, self.lab._holders, way.names):
            subprocess.run(["ip", "link", "set", name, "netns", str(holder.pid), "name", "far"], check=True, capture_output=True)
            if host.number == 0:
                host.run(["ip", "link", "del", LINK])
            host.run(["ip", "address", "add", f"{host.address}/24", "dev", "far"])
            other = 2 - host.number
            host.run(["ip", "link", "set", "far", "address", f"02:00:00:00:00:0{host.number + 1}", "up"])
            host.run(["ip", "neigh", "add", f"10.66.0.{other}", "lladdr", f"02:00:00:00:00:0{other}", "dev", "far", "nud", "permanent"])
        way.start()

    def close(self) -> None:
        self.lab.close()
        if self._way is not None:
            self._way.close()


class Meeting:
    """A publisher's agent here and a subscriber's there."""

    def __init__(self, lab: Lab, command: Sequence[str]) -> None:
        self._agents = [host.start(f"agent {host.number}", [*command, f"agent{host.number}"]) for host in lab.hosts]
        for agent in self._agents:
            agent.find("connected")

    def __enter__(self) -> Meeting:
        return self

    def __exit__(self, *_: object) -> None:
        for agent in self._agents:
            agent.discard()

    def seconds(self, mode: str, protocol: str, publisher_first: bool, settle_seconds: float) -> float:
        """From `pub add` until the first message; 0 where that was there already."""
        publisher, subscriber = self._agents
        name = f"m{next(_LABELS)}"
        offer, wish = f"pub {name} mode={mode} text={name} protocol={protocol}", f"sub {name} mode={mode} text={name} protocol={protocol}"
        if publisher_first:
            self._state(publisher, offer, name)
            publisher.tell(f"stream {name} 1000000 16 1")
            time.sleep(settle_seconds)
            self._state(subscriber, wish, name)
        else:
            self._state(subscriber, wish, name)
            time.sleep(settle_seconds)
            self._state(publisher, offer, name)
            publisher.tell(f"stream {name} 1000000 16 1")
        subscriber.any(rf"provider {name} added .*")
        added = time.monotonic()
        subscriber.any(rf"message {name} .*")
        first = time.monotonic()
        for agent in (subscriber, publisher):
            agent.tell(f"close {name}")
        return first - added

    @staticmethod
    def _state(agent: Spoken, line: str, name: str) -> None:
        agent.tell(line)
        agent.find(rf"ok {name}")
