"""Channels while programs, daemons and hosts come and go."""

from __future__ import annotations

from pair import Pair, counted, counted_until, fresh, fresh_port, must
from checks import strangers

#: Messages that wait in a subscriber.
INBOX = 1024


def publisher_restarts(pair: Pair) -> None:
    """a restarted publisher is another life"""
    text = fresh("service")
    for protocol in ("udp", "tcp"):
        pub = pair.start(0)
        pub.find("connected")
        p = pair.offer(f"mode=otm/pubsub text={text}{protocol} protocol={protocol}", pub)
        s = pair.ask(f"mode=otm/pubsub text={text}{protocol}")
        life = pair.sub.find(f"provider {s} added ([0-9a-f]+) -")[1]
        pub.find(f"consumer {p} added .*")
        pub.asked(f"stream {p} 3 8 1", f"streamed {p}")
        pair.sub.find(f"message {s} {life} 3 0 8 {3:016x}")
        pub.kill()
        pub.discard()
        q = pair.offer(f"mode=otm/pubsub text={text}{protocol} protocol={protocol}")
        other = pair.sub.find(f"provider {s} added ([0-9a-f]+) -")[1]
        must(other != life, "a restarted publisher has the same life")
        pair.pub.find(f"consumer {q} added .*")
        pair.pub_to_sub(q, s, "01", missed="0")
        pair.sub.any(f"provider {s} removed {life} .*")


def subscriber_restarts(pair: Pair) -> None:
    """a restarted subscriber is another life"""
    text = fresh("service")
    for protocol in ("udp", "tcp"):
        p = pair.offer(f"mode=otm/pubsub text={text}{protocol} protocol={protocol}")
        sub = pair.start(1)
        sub.find("connected")
        pair.ask(f"mode=otm/pubsub text={text}{protocol}", sub)
        life = pair.pub.find(f"consumer {p} added ([0-9a-f]+) -")[1]
        sub.kill()
        sub.discard()
        s = pair.ask(f"mode=otm/pubsub text={text}{protocol}")
        other = pair.pub.find(f"consumer {p} added ((?!{life})[0-9a-f]+) -")[1]
        must(other != life, "a restarted subscriber has the same life")
        pair.pub.any(f"consumer {p} removed {life} .*")
        pair.pub_to_sub(p, s, "01", missed="0")


def daemons_die(pair: Pair) -> None:
    """kill -9 of both daemons: every stream goes on"""
    channels = []
    for mode, protocol in (("oto", "udp"), ("oto", "tcp"), ("otm/pubsub", "udp"), ("otm/stream", "udp"), ("otm/stream", "tcp")):
        text = fresh("service")
        p = pair.offer(f"mode={mode} text={text} protocol={protocol}")
        s = pair.ask(f"mode={mode} text={text}")
        pair.met(p, s, mode == "otm/stream")
        first = pair.settled_stream(p, s) if mode == "otm/stream" else 0
        channels.append((p, s, first, f"{mode} over {protocol}"))
    count = 700
    for p, _, _, _ in channels:
        pair.pub.tell(f"stream {p} {count} 8 20")
    p, s, first, _ = channels[0]
    pair.sub.any(f"message {s} [0-9a-f]+ {first + 30} .*")
    for host in pair.hosts:
        host.kill_daemon()
    pair.pub.find("disconnected")
    pair.sub.any("disconnected")
    # Longer than a channel goes on after the other side's daemon has lost sight of it.
    pair.sub.any(f"message {s} [0-9a-f]+ {first + 600} .*")
    for host in pair.hosts:
        host.start_daemon(pair.lab.gemingad)
    for agent in (pair.pub, pair.sub):
        agent.find("connected")
    for p, s, first, what in channels:
        pair.sub.any(f"message {s} [0-9a-f]+ {first + count} .*")
        sequences = [int(found[1]) for found in pair.sub.all(f"message {s} [0-9a-f]+ ([0-9]+) .*")]
        must(sequences[-count:] == list(range(first + 1, first + count + 1)), f"{what}: the stream has gaps: {counted(pair.sub, s)}")
    must(not pair.sub.all("provider .* removed .*"), "a provider was told as removed though its stream went on")
    must(not pair.pub.all("consumer .* removed .*"), "a consumer was told as removed though its stream went on")
    text = fresh("service")
    pair.met(pair.offer(f"mode=oto text={text}"), pair.ask(f"mode=oto text={text}"))
    for p, s, _, what in channels:
        pair.pub.asked(f"close {p}", f"closed {p}")
        pair.sub.any(f"provider {s} removed [0-9a-f]+ withdrawn")


def daemon_starts_later(pair: Pair) -> None:
    """the daemon starts later"""
    text = fresh("service")
    host = pair.hosts[0]
    host.kill_daemon()
    pub = pair.start(0)
    pub.tell(f"pub late{text} mode=oto text={text}")
    s = pair.ask(f"mode=oto text={text}")
    host.start_daemon(pair.lab.gemingad)
    pub.find("connected")
    pub.find(f"ok late{text}")
    pair.sub.find(f"provider {s} added .*")
    pub.find(f"consumer late{text} added .*")
    pub.tell(f"send late{text} 01")
    pair.sub.find(f"message {s} [0-9a-f]+ 1 0 1 01")


def better_provider(pair: Pair) -> None:
    """a better provider takes over"""
    for protocol in ("udp", "tcp"):
        text = fresh("service")
        s = pair.ask(f"mode=oto text={text}")
        p = pair.offer(f"mode=oto text={text} protocol={protocol} priority=1")
        life, _ = pair.met(p, s)
        pair.pub_to_sub(p, s, "01", missed="0")
        q = pair.offer(f"mode=oto text={text} protocol={protocol} priority=2")
        better, _ = pair.met(q, s)
        pair.sub.any(f"provider {s} removed {life} outranked")
        pair.pub.stands(f"consumer {p} .*", f"consumer {p} removed [0-9a-f]+ .*")
        pair.pub.tell(f"send {p} 02")
        said, _, _ = pair.pub_to_sub(q, s, "03", missed="0")
        must(said == better, "a message has another life")
        must(not pair.sub.all(f"message {s} .* 02"), "an outranked provider was heard")
        # The first one comes back when the better one goes.
        pair.pub.tell(f"close {q}")
        pair.sub.find(f"provider {s} added {life} -")
        pair.pub.stands(f"consumer {p} .*", f"consumer {p} added [0-9a-f]+ -")
        # A provider follows the consumer's choice, which may change again before it is announced.
        pair.sends_until_heard(p, s, "04")


def host_dies(pair: Pair) -> None:
    """the best provider's host dies: the next one takes over"""
    text = fresh("service")
    far = pair.start(0)
    far.find("connected")
    p = pair.offer(f"mode=oto text={text} priority=2", far)
    s = pair.ask(f"mode=oto text={text}")
    life = pair.sub.find(f"provider {s} added ([0-9a-f]+) -")[1]
    far.find(f"consumer {p} added .*")
    near = pair.start(1)
    near.find("connected")
    q = pair.offer(f"mode=oto text={text} priority=1", near)
    far.tell(f"send {p} 01")
    pair.sub.find(f"message {s} {life} 1 0 1 01")
    pair.hosts[0].kill_daemon()
    far.kill()
    far.discard()
    other = pair.sub.find(f"provider {s} added ((?!{life})[0-9a-f]+) -")[1]
    pair.sub.any(f"provider {s} removed {life} .*")
    near.find(f"consumer {q} added .*")
    near.tell(f"send {q} 02")
    pair.sub.find(f"message {s} {other} 1 0 1 02")
    pair.hosts[0].start_daemon(pair.lab.gemingad)
    pair.pub.any("connected")


def modified(pair: Pair) -> None:
    """what is modified is the same channel"""
    text = fresh("service")
    p, s = pair.offer(f"mode=oto text={text} rate=10"), pair.ask(f"mode=oto text={text}")
    life, _ = pair.met(p, s)
    pair.pub_to_sub(p, s, "01", missed="0")
    pair.pub.tell(f"modify {p} rate=20")
    pair.sub.find(f"provider {s} modified {life} -")
    pair.pub_to_sub(p, s, "02", missed="0")
    pair.sub.tell(f'modify {s} where="rate > 50"')
    pair.sub.find(f"provider {s} removed {life} changed")
    pair.pub.find(f"consumer {p} removed .* changed")
    pair.sub.tell(f'modify {s} where=""')
    pair.sub.find(f"provider {s} added {life} -")
    pair.pub.find(f"consumer {p} added .*")
    must(not pair.sub.all("error .*"), "a change was refused")


def refused(pair: Pair) -> None:
    """what the daemon refuses is an error"""
    pair.pub.asked("pub bad mode=oto concept=soccer:NoSuchThing", "error bad .*")
    pair.sub.asked('sub worse mode=oto text=x where="rate >"', "error worse .*")
    port = fresh_port()
    pair.offer(f"mode=oto text={fresh('service')} port={port}")
    pair.pub.asked(f"pub taken mode=oto text={fresh('service')} port={port}", "error taken .*")


def slow_consumer(pair: Pair) -> None:
    """a slow TCP consumer holds nobody up"""
    text = fresh("service")
    p = pair.offer(f"mode=otm/pubsub text={text} protocol=tcp")
    s = pair.ask(f"mode=otm/pubsub text={text}")
    pair.met(p, s)
    quick = pair.start(1)
    quick.find("connected")
    other = pair.ask(f"mode=otm/pubsub text={text}", quick)
    pair.pub.find(f"consumer {p} added .*")
    pair.sub.tell(f"deaf {s}")
    quick.tell(f"quiet {other}")
    sent = 0
    for _ in range(20):
        pair.pub.asked(f"stream {p} 400 65536 4", f"streamed {p}")  # at a pace that a busy machine follows
        sent += 400
        if counted(pair.pub, p)["left_out"] > 0:
            break
    must(counted(pair.pub, p)["left_out"] > 0, f"{sent} messages of 64 KiB were kept for a consumer that does not read")
    counts = counted_until(quick, other, lambda so_far: so_far["received"] + so_far["missed"] >= sent)
    must(counts["received"] == sent, f"of {sent} messages the other consumer got {counts}")
    pair.sub.tell(f"reading {s}")
    mark = 0
    for _ in range(200):
        mark = pair.came(p, s, "aa")
        if mark:
            break
    must(mark > sent, "no message comes after the consumer reads again")
    counts = counted(pair.sub, s)
    must(counts["received"] + counts["missed"] >= mark, f"of {mark} messages: {counts}")
    must(counts["missed"] > 0 and counts["dropped"] == 0, f"messages that were left out are not missed: {counts}")


def full_inbox(pair: Pair) -> None:
    """a full inbox keeps the newest of UDP"""
    text = fresh("service")
    p, s = pair.offer(f"mode=oto text={text}"), pair.ask(f"mode=oto text={text}")
    pair.met(p, s)
    pair.sub.tell(f"deaf {s}")
    pair.sub.asked("identity number 1", "identity 1")  # it is deaf when it answers
    pair.pub.asked(f"stream {p} {2 * INBOX} 8 1", f"streamed {p}")
    counted_until(pair.sub, s, lambda so_far: so_far["missed"] >= INBOX - 1)
    pair.sub.tell(f"reading {s}")
    mark = 0
    while not mark:
        mark = pair.came(p, s, "aa")
    rows = [(int(found[1]), int(found[2])) for found in pair.sub.passed(f"message {s} [0-9a-f]+ ([0-9]+) ([0-9]+) .*")]
    last = 0
    for sequence, missed in rows:
        must(sequence > last, f"message {sequence} came behind {last}")
        must(missed == (sequence - last - 1), f"between {last} and {sequence} are {missed} missing")
        last = sequence
    newest = sum(sequence > INBOX + 1 for sequence, _ in rows)
    must(newest > INBOX / 2, f"of the newest {INBOX} messages {newest} came")
    # The agent may have taken a message before it stopped.
    eldest = sum(sequence <= INBOX for sequence, _ in rows)
    must(eldest <= 3, f"{eldest} of the eldest {INBOX} messages came")
    sent = counted(pair.pub, p)["sent"]
    counts = counted_until(pair.sub, s, lambda so_far: so_far["received"] + so_far["missed"] >= sent)
    must(counts["received"] + counts["missed"] == sent, f"of {sent} messages: {counts}")
    must(counts["dropped"] == 0, f"messages that were lost in the inbox count as dropped: {counts}")


def conversions(pair: Pair) -> None:
    """representations are converted"""
    polar, robot, field = (f"soccer:{word}" for word in ("PolarRobotFrame", "CartesianRobotFrame", "CartesianFieldFrame"))
    p = pair.offer(f"mode=otm/pubsub concept=soccer:BallInfo representation={polar}")
    wishes = f"mode=otm/pubsub concept=soccer:BallInfo representation={field} convert=yes"
    steps = fresh("sub")
    pair.sub.tell(f"convert {steps} {polar} {robot} a1")
    pair.sub.tell(f"convert {steps} {robot} {field} a2")
    whole = fresh("sub")
    pair.sub.tell(f"convert {whole} {polar} {field} b0")
    pair.sub.tell(f"convert {whole} {polar} {robot} b1")
    missing = fresh("sub")
    pair.sub.tell(f"convert {missing} {polar} {robot} c1")
    for label in (steps, whole, missing):
        pair.sub.asked(f"sub {label} {wishes}", f"ok {label}")
        pair.sub.any(f"provider {label} added .*")
        pair.pub.find(f"consumer {p} added .*")
    pair.pub.tell(f"send {p} 01")
    pair.sub.any(f"message {steps} [0-9a-f]+ 1 0 3 a2a101")
    pair.sub.any(f"message {whole} [0-9a-f]+ 1 0 2 b001")
    pair.sub.any(f"problem {missing} .*there is no function for the conversion {robot}>{field}.*")
    pair.pub.tell(f"send {p} 02")
    pair.sub.any(f"message {steps} [0-9a-f]+ 2 0 3 a2a102")
    counts = counted_until(pair.sub, missing, lambda so_far: so_far["dropped"] >= 2)
    must(counts["dropped"] == 2 and counts["received"] == 0, f"without a function: {counts}")
    must(len(pair.sub.all(f"problem {missing} .*")) == 1, "a missing function is told more than once")


#: Checks that a face of another library does not run: they are long, or need something that it does not show.
WHOLE = [daemons_die, strangers.forged_hellos]
CHECKS = [
    publisher_restarts, subscriber_restarts, daemons_die, daemon_starts_later, better_provider, host_dies, modified, refused,
    slow_consumer, full_inbox, conversions, *strangers.CHECKS,
]  # fmt: skip
