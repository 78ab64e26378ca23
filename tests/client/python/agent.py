#!/usr/bin/python3
"""The agent of the Python library (tests/client/conformance/AGENT.md)."""

from __future__ import annotations

import asyncio
import os
import sys
from collections.abc import Callable
from typing import Any

sys.path.insert(0, os.environ.get("GEMINGA_PYTHON") or os.path.join(os.path.dirname(__file__), "../../../src/client/python"))

import geminga  # noqa: E402
from geminga.protocol.frame import FrameError, read_datagram  # noqa: E402
from geminga.protocol.life import write_life  # noqa: E402
from geminga.protocol.reserved import PREFIX, RESERVED  # noqa: E402
from geminga.protocol.statement import LineError, read_line, read_parameters, write_line  # noqa: E402

SHOWN_OCTETS = 32


def say(*words: object) -> None:
    print(*words, flush=True)


def arguments(text: str) -> dict[str, Any]:
    """These parameters of GCNP as arguments of publish(), subscribe() or modify()."""
    keys: dict[str, Any] = {"attributes": {}}
    for key, value in read_parameters(text).items():
        if key in RESERVED:
            keys["for_" if key == "for" else key] = value or ""
        else:
            keys["attributes"][key.removeprefix(PREFIX)] = value or ""
    for key in ("port", "limit", "priority"):
        if keys.get(key):
            keys[key] = int(keys[key])
    return keys


class Agent:
    def __init__(self, name: str) -> None:
        self.node = geminga.connect(name, on_event=self.happened)
        self.labels: dict[object, str] = {}
        self.channels: dict[str, Any] = {}
        self.early: dict[object, list[Callable[[], None]]] = {}
        self.quiet: set[str] = set()
        self.deaf: dict[str, asyncio.Event] = {}
        self.counts: dict[str, int] = {}
        self.conversions: dict[str, dict[str, Callable[[bytes], bytes]]] = {}
        self.tasks: set[asyncio.Task[None]] = set()

    def happened(self, what: geminga.Happening) -> None:
        if isinstance(what, geminga.Connected):
            say("connected")
        elif isinstance(what, geminga.Disconnected):
            say("disconnected")
        elif isinstance(what, geminga.ProviderChanged):
            life = write_life(what.provider.life)
            self.about(what.subscriber, "provider", what.change, life, what.reason or "-")
        elif isinstance(what, geminga.ConsumerChanged):
            life = write_life(what.consumer.life)
            self.about(what.publisher, "consumer", what.change, life, what.reason or "-")
        else:
            self.about(what.source, "problem", what.text)

    def about(self, channel: object, word: str, *rest: object) -> None:
        """Reports what happens to a channel, after its ok."""
        label = self.labels.get(channel)
        if label is not None or channel is None:
            say(word, label or "-", *rest)
        else:
            self.early.setdefault(channel, []).append(lambda: say(word, self.labels[channel], *rest))

    async def open(self, label: str, opening: geminga.opening.Opening[Any]) -> None:
        try:
            channel = await opening
            await channel.accepted()
        except (geminga.GemingaError, ValueError, OSError) as error:
            say("error", label, error)
            return
        self.channels[label] = channel
        self.labels[channel] = label
        say("ok", label)
        for early in self.early.pop(channel, []):
            early()
        if isinstance(channel, geminga.Subscriber):
            self.counts[label] = 0
            self.start(self.receive(label, channel))

    def start(self, work: Any) -> None:
        task = asyncio.get_running_loop().create_task(work)
        self.tasks.add(task)
        task.add_done_callback(self.tasks.discard)

    async def receive(self, label: str, subscriber: geminga.Subscriber) -> None:
        async for message in subscriber:
            if label in self.deaf:
                await self.deaf[label].wait()
            self.counts[label] += 1
            if label not in self.quiet:
                shown = message.payload[:SHOWN_OCTETS].hex()
                say("message", label, write_life(message.life), message.sequence, message.missed, len(message.payload), shown)
            await asyncio.sleep(0)

    async def told(self, line: str) -> bool:
        """Carries out a command; False at the end."""
        word, _, rest = line.partition(" ")
        label, _, rest = rest.partition(" ")
        try:
            await self.does(word, label, rest)
        except (geminga.GemingaError, ValueError, KeyError) as error:
            say("error", label, error)
        return word != "quit"

    async def does(self, word: str, label: str, rest: str) -> None:
        if word == "pub":
            self.start(self.open(label, self.node.publish(**arguments(rest))))
        elif word == "sub":
            self.start(self.open(label, self.node.subscribe(conversions=self.conversions.get(label), **arguments(rest))))
        elif word == "convert":
            before, after, octets = (rest + " ").split(" ")[:3]
            prefix = bytes.fromhex(octets)
            self.conversions.setdefault(label, {})[f"{before}>{after}"] = lambda payload: prefix + payload
        elif word == "modify":
            keys = arguments(rest)
            await self.channels[label].modify(**keys)
        elif word == "send":
            self.channels[label].send(bytes.fromhex(rest))
        elif word == "stream":
            count, size, milliseconds = (int(one) for one in rest.split())
            self.start(self.stream(label, count, size, milliseconds))
        elif word == "count":
            self.count(label)
        elif word == "quiet":
            self.quiet.add(label)
        elif word == "deaf":
            self.deaf[label] = asyncio.Event()
        elif word == "reading":
            self.deaf.pop(label).set()
        elif word == "close":
            channel = self.channels[label]
            await channel.close()
            say("closed", label)
        elif word == "identity":
            self.identity(label, rest)
        elif word == "frame":
            self.frame(label)
        elif word == "line":
            self.line(f"{label} {rest}" if rest else label)
        elif word != "quit":
            say("error", word, "is no word of an agent")

    async def stream(self, label: str, count: int, size: int, milliseconds: int) -> None:
        publisher = self.channels[label]
        rest = bytes(max(0, size - 8))
        loop = asyncio.get_running_loop()
        start = loop.time()
        try:
            for number in range(1, count + 1):
                publisher.send((number.to_bytes(8, "big") + rest)[:size])
                if milliseconds == 0:
                    await publisher.drain()
                else:
                    await asyncio.sleep(max(0.0, start + number * milliseconds / 1000 - loop.time()))
        except geminga.GemingaError as error:
            say("error", label, error)
            return
        say("streamed", label)

    def count(self, label: str) -> None:
        channel = self.channels[label]
        if isinstance(channel, geminga.Publisher):
            say("count", label, f"sent={channel.sent} left_out={channel.left_out} dropped={channel.dropped}")
        else:
            say("count", label, f"received={self.counts[label]} missed={channel.missed} dropped={channel.dropped}")

    def identity(self, kind: str, rest: str) -> None:
        value, representation = rest, None
        if kind in ("concept", "expression") and " " in rest and not rest.endswith(")"):
            value, _, representation = rest.rpartition(" ")
        kinds: dict[str, Any] = {"id" if kind == "number" else kind: int(value) if kind == "number" else value}
        say("identity", geminga.identity(**kinds, representation=representation))

    def frame(self, digits: str) -> None:
        try:
            frame = read_datagram(bytes.fromhex(digits))
        except FrameError:
            say("frame refused")
            return
        say("frame", frame.kind.name.lower(), write_life(frame.life), frame.sequence, frame.payload.hex())

    def line(self, text: str) -> None:
        try:
            say("line", write_line(read_line(text.encode())).decode().removesuffix("\r\n"))
        except LineError:
            say("line refused")


async def main() -> None:
    agent = Agent(sys.argv[1] if len(sys.argv) > 1 else "agent")
    reader = asyncio.StreamReader(limit=2**26)
    loop = asyncio.get_running_loop()
    await loop.connect_read_pipe(lambda: asyncio.StreamReaderProtocol(reader), sys.stdin)
    async with agent.node:
        while line := await reader.readline():
            if not await agent.told(line.decode().rstrip("\r\n")):
                break


if __name__ == "__main__":
    asyncio.run(main())
