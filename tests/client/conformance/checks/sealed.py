"""A team with a key: who has none reads, writes, mutes and fills no channel; modes and keys change without a loss."""

from __future__ import annotations

import sys
from pathlib import Path

from checks import behaviours, streams
from checks.strangers import forged
from frames import END, FLOOR, HELLO, MESSAGE, frame
from pair import Pair, counted, counted_until, fresh, fresh_port, must

FORGE = [sys.executable, str(Path(__file__).resolve().parents[1] / "forge.py")]
STRANGER = 0x5742A17E00000002
#: The steps of a migration behind `prepared`. A way back costs a host thirty seconds (src/discovery/sealing/SEALING.md, "Modes").
STEPS = ("mixed", "encrypted", "authenticated", "encrypted")
#: Messages of a channel between two steps, 10 ms each.
MESSAGES_OF_A_STEP = 5


def stranger_reads_nothing(pair: Pair) -> None:
    """sealed: a stranger is sent no octet over TCP, and no message over UDP"""
    for protocol in ("tcp", "udp"):
        text, port = fresh("service"), fresh_port()
        p = pair.offer(f"mode=otm/stream text={text} protocol={protocol} port={port}")
        s = pair.ask(f"mode=otm/stream text={text}")
        word, _ = pair.met(p, s, True)
        pair.heard(p, s)
        hello = frame(HELLO, STRANGER, 0, bytes.fromhex(word) + bytes(7) + b"\1" + bytes(8))
        address = pair.hosts[0].address
        command = ["tcp", address, str(port), hello] if protocol == "tcp" else ["hellos", address, str(port), "8", hello]
        stranger = pair.hosts[1].start("stranger", [*FORGE, *command])
        try:
            pair.pub_to_sub(p, s, "01")
            octets = stranger.find("(?:closed|received) ([0-9]+)")[1]
        finally:
            stranger.discard()
        must(octets == "0", f"a stranger was sent {octets} octets over {protocol.upper()}")


def stranger_writes_nothing(pair: Pair) -> None:
    """sealed: plain frames from the provider's address are not believed"""
    text, pub_port, sub_port = fresh("service"), fresh_port(), fresh_port()
    p = pair.offer(f"mode=oto text={text} port={pub_port}")
    s = pair.ask(f"mode=oto text={text} port={sub_port}")
    word, _ = pair.met(p, s)
    pair.pub_to_sub(p, s, "01", missed="0")
    life = int(word, 16)
    for octets in (
        frame(MESSAGE, life, 2, b"forged"),
        frame(MESSAGE, life, 2**64 - 1, b"forged"),
        frame(END, life, 2, b""),
        frame(FLOOR, life, 2**64 - 1, bytes(24)),
    ):
        forged(pair, 0, pub_port, sub_port, octets)
    pair.pub_to_sub(p, s, "02", missed="0")
    must(len(pair.sub.all(f"message {s} .*")) == 2, "a forged message was delivered")
    must(not pair.sub.all(f"provider {s} removed .*"), "a forged end ended a sealed channel")


def stranger_fills_nothing(pair: Pair) -> None:
    """sealed: 256 connections of a stranger hold no place"""
    text, port = fresh("service"), fresh_port()
    p = pair.offer(f"mode=otm/stream text={text} protocol=tcp port={port}")
    s = pair.ask(f"mode=otm/stream text={text}")
    word, _ = pair.met(p, s, True)
    pair.heard(p, s)
    hello = frame(HELLO, STRANGER, 0, bytes.fromhex(word) + bytes(7) + b"\1" + bytes(8)).replace(f"{STRANGER:016x}", "LIFE")
    before = pair.pub.memory_kib()
    stranger = pair.hosts[1].start("flood of connections", [*FORGE, "flood", pair.hosts[0].address, str(port), "256", hello])
    try:
        stranger.find("opened .*")
        pair.sub.tell(f"quiet {s}")
        pair.pub.asked(f"stream {p} 200 65536 4", f"streamed {p}")
        grown = pair.pub.memory_kib() - before
        must(grown < 128 * 1024, f"connections without the key took {grown} KiB of the publisher")
        late = pair.ask(f"mode=otm/stream text={text}")
        pair.sub.find(f"provider {late} added .*")
        must(any(pair.came(p, late, "02") for _ in range(100)), "a subscriber that came after strangers hears nothing")
    finally:
        stranger.discard()


def keys_are_not_shown(pair: Pair) -> None:
    """sealed: no program prints a key"""
    text = fresh("service")
    p, s = pair.offer(f"mode=oto text={text}"), pair.ask(f"mode=oto text={text}")
    pair.met(p, s)
    pair.pub_to_sub(p, s, "01", missed="0")
    for agent in (pair.pub, pair.sub):
        must(not agent.all(".*(?:ring=|[0-9a-f]{64}).*"), f"{agent.name} printed a key")


def _must_go_on(pair: Pair, channels: list[streams.Stream]) -> None:
    """Waits until further messages have come on each channel: a step is made when all programs have made the one before."""
    for _, s, _, _ in channels:
        number = counted(pair.sub, s)["received"] + MESSAGES_OF_A_STEP
        counted_until(pair.sub, s, lambda so_far: so_far["received"] >= number)  # noqa: B023


def _must_have_all(pair: Pair, channels: list[streams.Stream], count: int) -> None:
    for p, s, first, what in channels:
        pair.pub.any(f"streamed {p}")
        counts = counted_until(pair.sub, s, lambda so_far: so_far["received"] + so_far["missed"] >= first + count)
        sequences = [int(found[1]) for found in pair.sub.all(f"message {s} [0-9a-f]+ ([0-9]+) .*")]
        must(sequences[-count:] == list(range(first + 1, first + count + 1)), f"{what}: the stream has gaps: {counts}, of {counted(pair.pub, p)}")


def rotation(pair: Pair) -> None:
    """sealed: a rotation of keys loses no message"""
    count = 500
    channels = streams.begun(pair, count, 10)
    try:
        for keys in ((0, 1), (1, 0), (1,), (1, 0), (0, 1), (0,)):
            pair.lab.seal("encrypted", keys)
            _must_go_on(pair, channels)
        _must_have_all(pair, channels, count)
    finally:
        pair.lab.seal(pair.lab.sealing)


def migration(pair: Pair) -> None:
    """sealed: the steps from plain to sealed lose no message"""
    count = 500
    pair.lab.start_daemons_as("prepared")
    for agent in (pair.pub, pair.sub):
        agent.any("disconnected")
        agent.find("connected")
    channels = streams.begun(pair, count, 10)
    try:
        for mode in STEPS:
            pair.lab.seal(mode)
            _must_go_on(pair, channels)
        _must_have_all(pair, channels, count)
    finally:
        pair.lab.seal(pair.lab.sealing)


#: Behaviours that a key changes.
BEHAVIOURS = [behaviours.daemons_die, behaviours.subscriber_restarts, behaviours.better_provider, behaviours.slow_consumer]
CHECKS = [stranger_reads_nothing, stranger_writes_nothing, stranger_fills_nothing, keys_are_not_shown, rotation, migration]
