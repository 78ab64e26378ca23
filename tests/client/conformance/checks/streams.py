"""Channels of all kinds on which numbered messages flow."""

from __future__ import annotations

from pair import Pair, fresh

KINDS = (("oto", "udp"), ("oto", "tcp"), ("otm/pubsub", "udp"), ("otm/stream", "udp"), ("otm/stream", "tcp"))
#: The labels of publisher and subscriber, the sequence before the first numbered message, and the kind in words.
Stream = tuple[str, str, int, str]


def begun(pair: Pair, count: int, milliseconds: int) -> list[Stream]:
    """Lets both sides meet on a channel of each kind, and begins to send so many messages, one each so many milliseconds."""
    channels = []
    for mode, protocol in KINDS:
        text = fresh("service")
        p = pair.offer(f"mode={mode} text={text} protocol={protocol}")
        s = pair.ask(f"mode={mode} text={text}")
        pair.met(p, s, mode == "otm/stream")
        first = pair.settled_stream(p, s) if mode == "otm/stream" else 0
        channels.append((p, s, first, f"{mode} over {protocol}"))
    for p, _, _, _ in channels:
        pair.pub.tell(f"stream {p} {count} 8 {milliseconds}")
    return channels
