"""Messages in every mode, over UDP and TCP, of every size."""

from __future__ import annotations

import time

from pair import Pair, counted, counted_until, fresh, fresh_port, must
from spoken import Failed

#: Seconds that a subscriber keeps an early frame.
EARLY_SECONDS = 1.0
#: Attempts, because a busy machine may take longer than that.
ATTEMPTS = 30
MAX_UDP = 65_000
MAX_TCP = 16 * 1024 * 1024


def exchange(pair: Pair, mode: str, protocol: str, address: str = "") -> None:
    """Lets both sides meet, sends messages, and closes."""
    text = fresh("service")
    is_stream = mode == "otm/stream"
    p = pair.offer(f"mode={mode} text={text} protocol={protocol} {address}")
    s = pair.ask(f"mode={mode} text={text}")
    life, _ = pair.met(p, s, is_stream)
    last = pair.settled_stream(p, s) if is_stream else 0
    for octets in ("", "68656c6c6f", "ab" * 40):
        said, sequence, missed = pair.pub_to_sub(p, s, octets)
        must(said == life, f"the message has the life {said}, the provider {life}")
        must((int(sequence), int(missed)) == (last + 1, 0), f"message {last + 1} came as {sequence}, {missed} were missed")
        last += 1
    must(counted(pair.pub, p)["sent"] == last, f"the publisher did not count {last} messages")
    if not (pair.lab.is_sealed and address):  # over multicast, what was sent before the subscriber was proved to is dropped
        must(counted(pair.sub, s)["dropped"] == 0, "messages were dropped")
    pair.pub.asked(f"close {p}", f"closed {p}")
    pair.sub.find(f"provider {s} removed {life} withdrawn")
    must(not pair.sub.all(f"provider {s} modified .*"), "the provider was told as modified")
    pair.sub.asked(f"close {s}", f"closed {s}")


def oto_udp(pair: Pair) -> None:
    """oto over UDP"""
    exchange(pair, "oto", "udp")


def oto_tcp(pair: Pair) -> None:
    """oto over TCP"""
    exchange(pair, "oto", "tcp")


def pubsub_udp(pair: Pair) -> None:
    """otm/pubsub over UDP"""
    exchange(pair, "otm/pubsub", "udp")


def pubsub_tcp(pair: Pair) -> None:
    """otm/pubsub over TCP"""
    exchange(pair, "otm/pubsub", "tcp")


def stream_udp(pair: Pair) -> None:
    """otm/stream over UDP"""
    exchange(pair, "otm/stream", "udp")


def stream_tcp(pair: Pair) -> None:
    """otm/stream over TCP"""
    exchange(pair, "otm/stream", "tcp")


def stream_multicast(pair: Pair) -> None:
    """otm/stream, multicast"""
    port = fresh_port()
    exchange(pair, "otm/stream", "udp", f"address=239.66.1.{port % 250 + 1} port={port}")


def sizes_udp(pair: Pair) -> None:
    """65 000 octets over UDP, no more"""
    text = fresh("service")
    p, s = pair.offer(f"mode=oto text={text}"), pair.ask(f"mode=oto text={text}")
    pair.met(p, s)
    pair.pub.asked(f"stream {p} 1 {MAX_UDP + 1} 1", f"error {p} .*tcp.*")
    pair.pub.asked(f"stream {p} 1 {MAX_UDP} 1", f"streamed {p}")
    pair.sub.find(f"message {s} [0-9a-f]+ 1 0 {MAX_UDP} {1:016x}{'00' * 24}")


def sizes_tcp(pair: Pair) -> None:
    """16 MiB over TCP, no more"""
    text = fresh("service")
    p, s = pair.offer(f"mode=oto text={text} protocol=tcp"), pair.ask(f"mode=oto text={text}")
    pair.met(p, s)
    pair.pub.asked(f"stream {p} 1 {MAX_TCP + 1} 1", f"error {p} .*")
    pair.pub.asked(f"stream {p} 2 {MAX_TCP} 0", f"streamed {p}")
    pair.sub.find(f"message {s} [0-9a-f]+ 1 0 {MAX_TCP} {1:016x}{'00' * 24}")
    pair.sub.find(f"message {s} [0-9a-f]+ 2 0 {MAX_TCP} {2:016x}{'00' * 24}")


def end_without_loss(pair: Pair) -> None:
    """10000 messages over TCP, then the end"""
    text = fresh("service")
    p, s = pair.offer(f"mode=otm/pubsub text={text} protocol=tcp"), pair.ask(f"mode=otm/pubsub text={text}")
    life, _ = pair.met(p, s)
    pair.sub.tell(f"quiet {s}")
    pair.pub.tell(f"stream {p} 10000 100 0")
    pair.pub.find(f"streamed {p}")
    pair.pub.asked(f"close {p}", f"closed {p}")
    pair.sub.find(f"provider {s} removed {life} withdrawn")
    counts = counted_until(pair.sub, s, lambda so_far: so_far["received"] >= 10000)
    must(counts == {"received": 10000, "missed": 0, "dropped": 0}, f"of 10000 messages: {counts}")


def subscriber_leaves(pair: Pair) -> None:
    """a subscriber withdraws, another stays"""
    text = fresh("service")
    p = pair.offer(f"mode=otm/pubsub text={text}")
    one = pair.ask(f"mode=otm/pubsub text={text}")
    _, life = pair.met(p, one)
    other = pair.ask(f"mode=otm/pubsub text={text}")
    pair.met(p, other)
    pair.sub.asked(f"close {one}", f"closed {one}")
    pair.pub.find(f"consumer {p} removed {life} withdrawn")
    pair.pub_to_sub(p, other, "01", missed="0")
    pair.sub.asked(f"close {other}", f"closed {other}")
    pair.pub.find(f"consumer {p} removed [0-9a-f]+ withdrawn")
    before = counted(pair.pub, p)["sent"]
    pair.pub.tell(f"send {p} 02")
    must(counted(pair.pub, p)["sent"] == before, "a message without a consumer was counted")


def link_multicast(pair: Pair) -> None:
    """otm/stream, multicast of a link of IPv6"""
    port = fresh_port()
    exchange(pair, "otm/stream", "udp", f"address=ff02::66:{port % 250 + 1:x} port={port}")


def early(pair: Pair) -> None:
    """messages that come before the consumer is told"""
    for _ in range(ATTEMPTS):
        if _is_heard_early(pair):
            return
    raise Failed(f"the daemons did not tell both sides within a second, {ATTEMPTS} times")


def _is_heard_early(pair: Pair) -> bool:
    """Sends before the consumer is told of the provider. Whether it was told within the second, and so had to deliver."""
    keys = f"mode=otm/pubsub text={fresh('service')}"
    s = pair.ask(keys)
    known = pair.offer(keys)
    pair.met(known, s)  # the publisher's daemon knows the request then
    with pair.hosts[1].standing_daemon():
        p = pair.offer(keys)
        pair.pub.find(f"consumer {p} added .*")
        begin = time.monotonic()
        for octets in ("01", "02", "03"):
            pair.pub.tell(f"send {p} {octets}")
        counts = counted_until(pair.sub, s, lambda so_far: so_far["dropped"] >= 3)
        must(counts == {"received": 0, "missed": 0, "dropped": 3}, f"before the consumer was told: {counts}")
    life = pair.sub.find(f"provider {s} added ([0-9a-f]+) -")[1]
    is_soon = time.monotonic() - begin < EARLY_SECONDS
    if is_soon:
        for sequence in (1, 2, 3):
            pair.sub.find(f"message {s} {life} {sequence} 0 1 0{sequence}")
        counts = counted(pair.sub, s)
        must(counts == {"received": 3, "missed": 0, "dropped": 0}, f"of three early messages: {counts}")
    for label in (p, known):
        pair.pub.asked(f"close {label}", f"closed {label}")
    pair.sub.asked(f"close {s}", f"closed {s}")
    return is_soon


CHECKS = [
    oto_udp, oto_tcp, pubsub_udp, pubsub_tcp, stream_udp, stream_tcp, stream_multicast, link_multicast,
    early, sizes_udp, sizes_tcp, end_without_loss, subscriber_leaves,
]  # fmt: skip
