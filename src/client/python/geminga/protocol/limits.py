"""How much a channel takes from others, and how long it waits for them (src/client/CHANNELS.md)."""

from __future__ import annotations

#: Octets of one message over UDP, and over TCP.
MAX_DATAGRAM_PAYLOAD = 65_000
MAX_STREAM_PAYLOAD = 16_777_216
#: Octets that may wait for one TCP consumer; one message may always wait. And for all consumers of a publisher, each frame counted once.
MAX_WAITING_FOR_CONSUMER = 4 * 1024 * 1024
MAX_WAITING_FOR_ALL = 64 * 1024 * 1024
#: Frames that may wait so, since a small one costs more than its octets.
MAX_FRAMES_FOR_CONSUMER = 16_384
MAX_FRAMES_FOR_ALL = 262_144
#: Listeners of one `otm/stream` over UDP.
MAX_LISTENERS = 1024
#: TCP connections of one publisher that have not become a consumer's, and those that have.
MAX_STRANGERS = 64
MAX_TCP_CONSUMERS = 256
#: Providers over TCP of one subscriber.
MAX_TCP_PROVIDERS = 256
#: Floors and fulls of one publisher that answer datagrams: at once, and in a second.
MAX_ANSWERS = 512
#: The greatest step of the sequence that is believed without a key, and the runs of delivered sequences that are remembered of a life.
MAX_STEP = 65_536
MAX_RANGES = 256
#: Lives of which a subscriber keeps the keys, beside those of its providers.
MAX_KEYS = 1024
#: Lives of which a subscriber remembers the last sequence.
MAX_REMEMBERED_LIVES = 1024
#: Frames over UDP that came before the daemon told of their sender, and the octets of their payloads.
MAX_EARLY_FRAMES = 64
MAX_EARLY_OCTETS = 256 * 1024
#: Messages of one subscriber that wait to be received, and the octets of their payloads; one may always wait.
MAX_WAITING_MESSAGES = 1024
MAX_WAITING_OCTETS = 16 * 1024 * 1024
#: Happenings that wait for one events(); for one more the oldest is thrown away.
MAX_WAITING_EVENTS = 4096

#: Seconds between two hellos, and without a hello until a listener is forgotten.
HELLO_SECONDS = 1.0
LISTENER_SECONDS = 3.0
#: Seconds until a hello that is not accepted is said again; twice as many each time.
FIRST_HELLO_SECONDS = 0.02
#: Seconds after which a publisher makes other cookies. Those of the time before are accepted, too.
COOKIE_SECONDS = 8.0
#: Seconds without a message after which a straggler is believed that a lower one came before.
STRAGGLER_SECONDS = 2.0
#: Seconds that an end without a key is remembered, and that a match lasts after an end until its consumer connects again.
END_SECONDS = 10.0
#: Seconds that a provider without a connection keeps its place from others.
UNCONNECTED_SECONDS = 5.0
#: Seconds without a daemon that are said.
AWAY_SECONDS = 1.0
#: Seconds that a connection has to become a consumer's.
STRANGER_SECONDS = 5.0
#: Seconds that a subscriber waits for more of a provider that was withdrawn.
DRAIN_SECONDS = 2.0
#: Seconds that a publisher waits at its end for a consumer that takes nothing.
LEAVING_SECONDS = 5.0
#: Seconds between two looks at the interfaces of a multicast group.
INTERFACES_SECONDS = 2.0
#: Seconds that a channel over UDP goes on of which the daemons have lost sight.
ORPHAN_SECONDS = 10.0
#: Seconds that a daemon that is back has to confirm a channel.
SETTLE_SECONDS = 10.0
#: Seconds that an early frame is kept.
EARLY_SECONDS = 1.0
