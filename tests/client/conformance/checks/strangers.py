"""Datagrams and connections of strangers: they are not delivered and do no harm."""

from __future__ import annotations

import sys
from pathlib import Path

from frames import END, HELLO, MESSAGE, frame
from pair import Pair, counted, counted_until, fresh, fresh_port, must
from spoken import Failed

FORGE = [sys.executable, str(Path(__file__).resolve().parents[1] / "forge.py")]
STRANGER = 0x5742A17E00000001
#: Octets that a publisher may take for connections that read nothing, and for its own language's heap.
MAX_GROWTH_KIB = 192 * 1024
FLOOD = 256
#: Messages of 64 KiB that are sent meanwhile, at a pace that a busy machine follows in one of so many bursts: where the
#: subscriber gets no processor for a while, it is slow, too, and messages to it are left out.
BURST = 300
BURSTS = 3


def forged(pair: Pair, host: int, source_port: int, port: int, octets: str) -> int:
    """Sends a datagram from a host to a port of the second host. Whether the system let it."""
    address = pair.hosts[1].address
    try:
        pair.hosts[host].run([*FORGE, "udp", str(source_port), address, str(port), octets])
    except Failed:
        if source_port == 0:
            raise
        return 0
    return 1


def forged_datagrams(pair: Pair) -> None:
    """forged datagrams are not delivered"""
    text, pub_port, sub_port = fresh("service"), fresh_port(), fresh_port()
    p = pair.offer(f"mode=oto text={text} port={pub_port}")
    s = pair.ask(f"mode=oto text={text} port={sub_port}")
    word, _ = pair.met(p, s)
    life = int(word, 16)
    message = frame(MESSAGE, life, 1, b"forged")
    count = 0
    count += forged(pair, 0, 0, sub_port, message)  # another port
    count += forged(pair, 1, pub_port if pair.lab.has_namespaces else 0, sub_port, message)  # another host
    count += forged(pair, 0, pub_port, sub_port, frame(MESSAGE, STRANGER, 1, b"forged"))  # another life
    count += forged(pair, 0, pub_port, sub_port, b"no frame".hex())
    count += forged(pair, 0, pub_port, sub_port, message[:-2])  # a length that is not so
    count += forged(pair, 0, pub_port, sub_port, frame(END, STRANGER, 1, b""))
    _, sequence, missed = pair.pub_to_sub(p, s, "01")
    must((sequence, missed) == ("1", "0"), f"the first message came as {sequence}, {missed} were missed")
    must(len(pair.sub.all(f"message {s} .*")) == 1, "a forged message was delivered")
    must(counted(pair.sub, s)["dropped"] == count, f"{count} were forged, and it dropped {counted(pair.sub, s)}")


def repeated_datagrams(pair: Pair) -> None:
    """a message that comes again is delivered once"""
    text, pub_port, sub_port = fresh("service"), fresh_port(), fresh_port()
    p = pair.offer(f"mode=oto text={text} port={pub_port}")
    s = pair.ask(f"mode=oto text={text} port={sub_port}")
    word, _ = pair.met(p, s)
    for octets in ("01", "02", "03"):
        pair.pub_to_sub(p, s, octets)
    for sequence in (1, 3):
        forged(pair, 0, pub_port, sub_port, frame(MESSAGE, int(word, 16), sequence, b"again"))
    pair.pub_to_sub(p, s, "04", missed="0")
    must(len(pair.sub.all(f"message {s} .*")) == 4, "an old message was delivered")


def forged_hellos(pair: Pair) -> None:
    """a hello without the publisher's life is no listener"""
    text, port = fresh("service"), fresh_port()
    p = pair.offer(f"mode=otm/stream text={text} port={port}")
    before = counted(pair.pub, p)
    address = pair.hosts[0].address
    for octets in (frame(HELLO, STRANGER, 0, b""), frame(HELLO, STRANGER, 0, bytes(8)), b"no frame".hex()):
        pair.hosts[1].run([*FORGE, "udp", "0", address, str(port), octets])
    for _ in range(200):
        if counted(pair.pub, p)["dropped"] >= before["dropped"] + 3:
            break
    pair.pub.tell(f"send {p} 01")
    after = counted(pair.pub, p)
    must(after["dropped"] == before["dropped"] + 3, f"three hellos were forged: {after}")
    must(after["sent"] == 0, "a stranger was sent to")


def strange_connections(pair: Pair) -> None:
    """TCP strangers get nothing, and are closed"""
    text, port = fresh("service"), fresh_port()
    p = pair.offer(f"mode=oto text={text} protocol=tcp port={port}")
    s = pair.ask(f"mode=oto text={text}")
    pair.met(p, s)
    address = pair.hosts[0].address
    strangers = []
    for number, octets in enumerate((frame(HELLO, STRANGER, 0, b""), "", b"GET / HTTP/1.1\r\n\r\n padding to a header".hex())):
        command = [*FORGE, "tcp", address, str(port), octets]
        strangers.append(pair.hosts[1].start(f"stranger {number}", command))
    pair.pub_to_sub(p, s, "01", missed="0")
    try:
        for stranger in strangers:
            must(stranger.find("closed ([0-9]+)")[1] == "0", f"{stranger.name} was sent something")
    finally:
        for stranger in strangers:
            stranger.discard()
    pair.pub_to_sub(p, s, "02", missed="0")


def forged_sequence(pair: Pair) -> None:
    """a forged sequence and a forged end mute nobody"""
    for kind, sequence, payload in ((MESSAGE, 2**64 - 1, b"forged"), (END, 3, b"")):
        text, pub_port, sub_port = fresh("service"), fresh_port(), fresh_port()
        p = pair.offer(f"mode=oto text={text} port={pub_port}")
        s = pair.ask(f"mode=oto text={text} port={sub_port}")
        word, _ = pair.met(p, s)
        for octets in ("01", "02", "03"):
            pair.pub_to_sub(p, s, octets)
        if not forged(pair, 0, pub_port, sub_port, frame(kind, int(word, 16), sequence, payload)):
            return  # only root may forge an address
        pair.pub_to_sub(p, s, "04", missed="0")
        must(not pair.sub.all(f"provider {s} removed .*"), "a forged end ended the channel")
        must(not pair.sub.all(f"message {s} .* 6 {b'forged'.hex()}"), "a message was delivered that was 2^64 ahead")


def flooded_connections(pair: Pair) -> None:
    """256 connections that read nothing cost a share of the memory, and nobody a message"""
    for keys, life in (("otm/stream", "LIFE"), ("otm/pubsub", "LIFE")):
        text, port = fresh("service"), fresh_port()
        p = pair.offer(f"mode={keys} text={text} protocol=tcp port={port}")
        s = pair.ask(f"mode={keys} text={text}")
        word, _ = pair.met(p, s, keys == "otm/stream")
        if keys == "otm/stream":
            pair.heard(p, s)
        before = pair.pub.memory_kib()
        hello = frame(HELLO, STRANGER, 0, bytes.fromhex(word) + bytes(7) + b"\1" + bytes(8)).replace(f"{STRANGER:016x}", life)
        command = [*FORGE, "flood", pair.hosts[0].address, str(port), str(FLOOD), hello]
        stranger = pair.hosts[1].start("flood of connections", command)
        try:
            stranger.find("opened .*")
            pair.sub.tell(f"quiet {s}")
            for _ in range(BURSTS):
                had = counted(pair.sub, s)["received"]
                pair.pub.asked(f"stream {p} {BURST} 65536 4", f"streamed {p}")
                grown = pair.pub.memory_kib() - before
                must(grown < MAX_GROWTH_KIB, f"{FLOOD} connections that read nothing took {grown} KiB of the publisher")
                sent = counted(pair.pub, p)["sent"]
                counts = counted_until(pair.sub, s, lambda so_far: so_far["received"] + so_far["missed"] >= sent - 1)
                if counts["received"] - had > 0.9 * BURST:
                    break
            else:
                raise Failed(f"of {sent} messages in {BURSTS} bursts the subscriber got {counts}")
        finally:
            stranger.discard()


def flooded_hellos(pair: Pair) -> None:
    """1100 hellos of one host are answered by no more octets, and lock nobody out"""
    text, port, count = fresh("service"), fresh_port(), 1100
    p = pair.offer(f"mode=otm/stream text={text} port={port}")
    early = pair.ask(f"mode=otm/stream text={text}")
    word, _ = pair.met(p, early, True)
    pair.heard(p, early)
    hello = frame(HELLO, STRANGER, 0, bytes.fromhex(word) + bytes(7) + b"\1" + bytes(8)).replace(f"{STRANGER:016x}", "LIFE")
    stranger = pair.hosts[1].start("flood of hellos", [*FORGE, "hellos", pair.hosts[0].address, str(port), str(count), hello])
    try:
        pair.pub_to_sub(p, early, "01", missed="[0-9]+")
        octets = int(stranger.find("received ([0-9]+)")[1])
    finally:
        stranger.discard()
    must(octets <= count * len(hello.replace("LIFE", "0" * 16)) // 2, f"{count} hellos without a cookie were answered by {octets} octets")
    late = pair.ask(f"mode=otm/stream text={text}")
    pair.sub.find(f"provider {late} added .*")
    for _ in range(100):
        if pair.came(p, late, "02"):
            return
    raise Failed("a subscriber that came after a flood of hellos hears nothing")


CHECKS = [forged_datagrams, repeated_datagrams, forged_hellos, strange_connections, forged_sequence, flooded_connections, flooded_hellos]
