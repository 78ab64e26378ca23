"""Rounds of chaos: both daemons are killed and come back at moments drawn by chance, and no message is missed."""

from __future__ import annotations

import random

from checks import streams
from pair import Pair, counted, must

COUNT = 900
#: Messages, 20 ms apart, that one daemon is away at most.
MAX_AWAY = 600


def round_of_chaos(pair: Pair, seed: int) -> None:
    """kill -9 of both daemons at moments drawn by chance: nothing is missed"""
    chance = random.Random(seed)
    channels = streams.begun(pair, COUNT, 20)
    _, watched, first, _ = channels[0]
    moments = []
    for host in pair.hosts:
        begin = chance.randrange(COUNT // 4)
        moments += [(begin, host, True), (begin + 1 + chance.randrange(MAX_AWAY), host, False)]
    for at, host, is_killed in sorted(moments, key=lambda moment: moment[0]):
        pair.sub.any(f"message {watched} [0-9a-f]+ {first + at + 1} .*")
        if is_killed:
            host.kill_daemon()
        else:
            host.start_daemon(pair.lab.gemingad)
    for p, s, first, what in channels:
        pair.pub.any(f"streamed {p}")
        pair.sub.any(f"message {s} [0-9a-f]+ {first + COUNT} .*")
        sequences = [int(found[1]) for found in pair.sub.all(f"message {s} [0-9a-f]+ ([0-9]+) .*")]
        wanted = list(range(first + 1, first + COUNT + 1))
        must(sequences[-COUNT:] == wanted, f"seed {seed}: {what}: {COUNT - len(set(wanted) & set(sequences))} missed: {counted(pair.sub, s)}")
    for p, s, _, _ in channels:
        pair.pub.asked(f"close {p}", f"closed {p}")
        pair.sub.asked(f"close {s}", f"closed {s}")
