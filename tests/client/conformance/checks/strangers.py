"""Datagrams and connections of strangers: they are not delivered and do no harm."""

from __future__ import annotations

import struct
import sys
from pathlib import Path

from pair import Pair, counted, fresh, fresh_port, must
from spoken import Failed

FORGE = [sys.executable, str(Path(__file__).resolve().parents[1] / "forge.py")]
MESSAGE, HELLO, END = 1, 2, 3
STRANGER = 0x5742A17E00000001


def _frame(kind: int, life: int, sequence: int, payload: bytes) -> str:
    return (struct.pack("!2sBBIQQ", b"GC", 1, kind, len(payload), life, sequence) + payload).hex()


def _forge(pair: Pair, host: int, source_port: int, port: int, octets: str) -> int:
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
    message = _frame(MESSAGE, life, 1, b"forged")
    count = 0
    count += _forge(pair, 0, 0, sub_port, message)  # another port
    count += _forge(pair, 1, pub_port if pair.lab.has_namespaces else 0, sub_port, message)  # another host
    count += _forge(pair, 0, pub_port, sub_port, _frame(MESSAGE, STRANGER, 1, b"forged"))  # another life
    count += _forge(pair, 0, pub_port, sub_port, b"no frame".hex())
    count += _forge(pair, 0, pub_port, sub_port, message[:-2])  # a length that is not so
    count += _forge(pair, 0, pub_port, sub_port, _frame(END, STRANGER, 1, b""))
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
        _forge(pair, 0, pub_port, sub_port, _frame(MESSAGE, int(word, 16), sequence, b"again"))
    pair.pub_to_sub(p, s, "04", missed="0")
    must(len(pair.sub.all(f"message {s} .*")) == 4, "an old message was delivered")


def forged_hellos(pair: Pair) -> None:
    """a hello without the publisher's life is no listener"""
    text, port = fresh("service"), fresh_port()
    p = pair.offer(f"mode=otm/stream text={text} port={port}")
    before = counted(pair.pub, p)
    address = pair.hosts[0].address
    for octets in (_frame(HELLO, STRANGER, 0, b""), _frame(HELLO, STRANGER, 0, bytes(8)), b"no frame".hex()):
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
    for number, octets in enumerate((_frame(HELLO, STRANGER, 0, b""), "", b"GET / HTTP/1.1\r\n\r\n padding to a header".hex())):
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


CHECKS = [forged_datagrams, repeated_datagrams, forged_hellos, strange_connections]
