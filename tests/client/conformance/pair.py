"""A pair of agents: the publisher's on the first host and the subscriber's on the second."""

from __future__ import annotations

import itertools
import time
from collections.abc import Callable, Sequence
from types import TracebackType

from lab import Host, Lab
from spoken import PATIENCE_SECONDS, Failed, Spoken

Command = Sequence[str]
_LABELS = itertools.count(1)
_PORTS = itertools.count(21000)


def fresh(word: str) -> str:
    """A label, or a name of a service, that is not in use."""
    return f"{word}{next(_LABELS)}"


def fresh_port() -> int:
    """A port that no check has stated."""
    return next(_PORTS)


class Pair:
    """Two agents, which are connected within the `with` block and are told to quit at its end."""

    def __init__(self, lab: Lab, publisher: Command, subscriber: Command) -> None:
        self.lab = lab
        self._commands = (publisher, subscriber)
        self._started: list[Spoken] = []

    def __enter__(self) -> Pair:
        try:
            self.pub = self.start(0)
            self.sub = self.start(1)
            self.pub.find("connected")
            self.sub.find("connected")
        except BaseException:
            for agent in self._started:
                agent.discard()
            raise
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        try:
            for agent in self._started:
                if error is None and not agent.was_killed and agent.end("quit") != 0:
                    raise Failed(f"{agent.name} was told to quit and did not end with 0")
        finally:
            for agent in self._started:
                agent.discard()

    def tried(self, check: Callable[[Pair], None]) -> None:
        """Runs a check. If it fails, the error has the last lines of all agents."""
        try:
            check(self)
        except Failed as error:
            error.add_note("".join(f"\n    {agent.name} said last:{agent.last_lines()}" for agent in self._started))
            raise

    @property
    def hosts(self) -> tuple[Host, Host]:
        """The host of the publisher and that of the subscriber."""
        return self.lab.hosts[0], self.lab.hosts[1]

    def start(self, number: int) -> Spoken:
        """Starts one more agent of the publisher's (0) or the subscriber's (1) language, on its host."""
        agent = self.lab.hosts[number].start(f"{'publisher' if number == 0 else 'subscriber'}'s agent", [*self._commands[number], fresh("agent")])
        self._started.append(agent)
        return agent

    def offer(self, keys: str, agent: Spoken | None = None) -> str:
        """Offers a service. Returns its label."""
        return self._request("pub", keys, agent or self.pub)

    def ask(self, keys: str, agent: Spoken | None = None) -> str:
        """Asks for a service. Returns its label."""
        return self._request("sub", keys, agent or self.sub)

    def met(self, p: str, s: str, is_stream: bool = False) -> tuple[str, str]:
        """Waits until both sides know each other. Returns the lives of the publisher and, unless it is a stream, of the subscriber."""
        life = self.sub.find(f"provider {s} added ([0-9a-f]{{16}}) -")[1]
        return life, "" if is_stream else self.pub.find(f"consumer {p} added ([0-9a-f]{{16}}) -")[1]

    def heard(self, p: str, s: str) -> int:
        """Sends to a stream until a message comes. Returns its sequence."""
        for _ in range(100):
            sequence = self.came(p, s, "00")
            if sequence:
                return sequence
        raise Failed("no message came to a listener")

    def came(self, p: str, s: str, octets: str) -> int:
        """Sends this message. Returns its sequence if it comes soon, else 0."""
        self.pub.tell(f"send {p} {octets}")
        try:
            return int(self.sub.find(f"message {s} [0-9a-f]+ ([0-9]+) [0-9]+ {len(octets) // 2} {octets}", 0.1)[1])
        except Failed:
            return 0

    def settled_stream(self, p: str, s: str) -> int:
        """Waits until a publisher of `otm/stream` is heard. Returns the sequence of its last message."""
        self.heard(p, s)
        return self.settled(p, s)

    def settled(self, p: str, s: str) -> int:
        """Sends a mark, and passes all messages before it. Returns the mark's sequence."""
        mark = fresh("ff").encode().hex()
        return int(self.pub_to_sub(p, s, mark)[1])

    def pub_to_sub(self, p: str, s: str, octets: str, missed: str = "[0-9]+") -> tuple[str, str, str]:
        """Sends this message and waits for it. Returns its life, its sequence, and how many were missed."""
        self.pub.tell(f"send {p} {octets}")
        size = len(octets) // 2
        found = self.sub.find(f"message {s} ([0-9a-f]{{16}}) ([0-9]+) ({missed}) {size} {octets[:64]}")
        return found[1], found[2], found[3]

    def sends_until_heard(self, p: str, s: str, octets: str) -> None:
        """Sends this message again and again until it comes."""
        for _ in range(20):
            try:
                self.pub.tell(f"send {p} {octets}")
                self.sub.find(f"message {s} .* {octets[:64]}", seconds=1)
                return
            except Failed as failed:
                last = failed
        raise last

    def _request(self, command: str, keys: str, agent: Spoken) -> str:
        label = fresh(command)
        found = agent.asked(f"{command} {label} {keys}", f"(ok|error) {label}( .*)?")
        if found[1] == "error":
            raise Failed(f"{agent.name} was refused {command} {keys}:{found[2]}")
        return label


def counted(agent: Spoken, label: str) -> dict[str, int]:
    """The counts of a publisher or subscriber."""
    found = agent.asked(f"count {label}", f"count {label} (.*)")
    return {key: int(value) for key, value in (word.split("=") for word in found[1].split())}


def counted_until(agent: Spoken, label: str, is_so: Callable[[dict[str, int]], bool]) -> dict[str, int]:
    """The counts when a condition holds, or after some seconds in which it did not hold."""
    end = time.monotonic() + PATIENCE_SECONDS
    while not is_so(counts := counted(agent, label)) and time.monotonic() < end:
        agent.asked("identity number 1", "identity 1")  # gives it time
    return counts


def must(holds: bool, text: str) -> None:
    """Raises Failed unless the condition holds."""
    if not holds:
        raise Failed(text)
