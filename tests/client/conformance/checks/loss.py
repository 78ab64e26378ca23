"""A network that loses a tenth: messages come in order and once, missing ones are counted, and TCP loses none."""

from __future__ import annotations

from collections.abc import Callable

from pair import Pair, counted, fresh, fresh_port, must

COUNT = 200
#: The least number of 200 datagrams: fewer come once in 10^20 runs.
LEAST = 120


def _lossy(pair: Pair, mode: str, protocol: str, address: str = "") -> None:
    text = fresh("service")
    is_stream = mode == "otm/stream"
    p = pair.offer(f"mode={mode} text={text} protocol={protocol} {address}")
    s = pair.ask(f"mode={mode} text={text}")
    life, _ = pair.met(p, s, is_stream)
    before = pair.heard(p, s) if is_stream else 0
    before = max(before, counted(pair.pub, p)["sent"])
    pair.pub.tell(f"stream {p} {COUNT} 100 2")
    pair.pub.find(f"streamed {p}")
    mark = 0
    while not mark:
        mark = pair.came(p, s, "ee")
    counts = counted(pair.sub, s)
    rows = [(int(found[1]), int(found[2])) for found in pair.sub.passed(f"message {s} {life} ([0-9]+) ([0-9]+) .*")]
    last = 0
    for sequence, missed in rows:
        must(sequence > last, f"message {sequence} came behind {last}")
        must(missed == (sequence - last - 1 if last else 0), f"between {last} and {sequence} are {missed} missing")
        last = sequence
    streamed = sum(before < sequence <= before + COUNT for sequence, _ in rows)
    least = COUNT if protocol == "tcp" else LEAST
    must(streamed >= least, f"of {COUNT} messages {streamed} came")
    must(counts["received"] == len(rows), f"{len(rows)} messages, and it counts {counts}")
    must(counts["missed"] == sum(missed for _, missed in rows), f"what is missing is counted as {counts}")
    must((counts["missed"] > 0) == (protocol == "udp"), f"a tenth was lost, and it counts {counts}")
    pair.pub.asked(f"close {p}", f"closed {p}")
    pair.sub.any(f"provider {s} removed {life} withdrawn")


def _check(mode: str, protocol: str) -> Callable[[Pair], None]:
    def check(pair: Pair) -> None:
        _lossy(pair, mode, protocol)

    check.__doc__ = f"a tenth is lost: {mode} over {protocol.upper()}"
    return check


def multicast(pair: Pair) -> None:
    """a tenth is lost: otm/stream, multicast"""
    port = fresh_port()
    _lossy(pair, "otm/stream", "udp", f"address=239.66.2.{port % 250 + 1} port={port}")


CHECKS = [*(_check(mode, protocol) for mode in ("oto", "otm/pubsub", "otm/stream") for protocol in ("udp", "tcp")), multicast]
