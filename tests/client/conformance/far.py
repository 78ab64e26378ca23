"""Round trips between `pub add` and the first message, on two hosts so far from each other that nothing else counts.

Each host has a TAP interface and a fixed entry for the other's address. A frame that leaves one interface enters the other
after half a round trip. The time of an event is the time at which a conformance agent (AGENT.md) prints its line.
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

from lab import LINK, Host, Lab
from spoken import Spoken

TUNSETIFF, IFF_TAP, IFF_NO_PI = 0x400454CA, 0x0002, 0x1000
_LABELS = itertools.count(1)


class Way:
    """Two interfaces, and a thread that carries frames between them."""

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
    """Two hosts with a daemon each that are so far from each other. Raises OSError where it cannot be made.

    `services` and `requests` are the lines of `geminga-query --watch`: what the second host knows of services, and the first
    one of requests.
    """

    def __init__(self, binaries: Path, round_trip_seconds: float) -> None:
        self.lab = Lab(str(binaries / "gemingad"), [])
        self._query = str(binaries / "geminga-query")
        self._watches: list[Spoken] = []
        self._way: Way | None = None
        try:
            if not self.lab.has_namespaces:
                raise OSError("no namespace may be made")
            self._way = Way(round_trip_seconds / 2)
            self._replace(self._way)
            self.lab.start_daemons()
            for host in self.lab.hosts:
                self._watch(host, "participants").find(rf".*host{1 - host.number}\b.*")
            self.services = self._watch(self.lab.hosts[1], "services")
            self.requests = self._watch(self.lab.hosts[0], "requests")
        except BaseException:
            self.close()
            raise

    def _watch(self, host: Host, what: str) -> Spoken:
        watch = host.start(f"{what} of host{host.number}", [self._query, "--watch", what])
        self._watches.append(watch)
        return watch

    def _replace(self, way: Way) -> None:
        """Puts the far link in the place of the lab's own."""
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
        for watch in self._watches:
            watch.discard()
        self.lab.close()
        if self._way is not None:
            self._way.close()


class Meeting:
    """A publisher's agent on the first host and a subscriber's on the second."""

    def __init__(self, far: FarLab, command: Sequence[str]) -> None:
        self._far = far
        self._agents = [host.start(f"agent {host.number}", [*command, f"agent{host.number}"]) for host in far.lab.hosts]
        for agent in self._agents:
            agent.find("connected")

    def __enter__(self) -> Meeting:
        return self

    def __exit__(self, *_: object) -> None:
        for agent in self._agents:
            agent.discard()

    def seconds(self, mode: str, protocol: str, publisher_first: bool) -> float:
        """From `pub add` until the first message. The second agent begins when its daemon knows what the first one stated."""
        publisher, subscriber = self._agents
        name = f"m{next(_LABELS)}"
        offer, wish = f"pub {name} mode={mode} text={name} protocol={protocol}", f"sub {name} mode={mode} text={name} protocol={protocol}"
        if publisher_first:
            self._state(publisher, offer, name)
            publisher.tell(f"stream {name} 1000000 16 1")
            self._far.services.find(rf".*\b{name}\b.*")
            self._state(subscriber, wish, name)
        else:
            self._state(subscriber, wish, name)
            if mode != "otm/stream":  # requests of streams are not announced
                self._far.requests.find(rf".*\b{name}\b.*")
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
