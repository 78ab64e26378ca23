"""The providers of a subscriber: which channels are open, and what is believed of them."""

from __future__ import annotations

from typing import Protocol

from .channels import sockets
from .channels.multicast_inlet import MulticastInlet
from .channels.tcp_inlets import TcpInlets
from .channels.udp_inlet import UdpInlet
from .protocol.belief import Belief
from .protocol.channel_keys import PLAIN, ChannelKeys
from .protocol.counter import CounterError
from .protocol.counterparts import WITHDRAWN, Change, Counterpart, Counterparts, Key
from .protocol.endings import Endings
from .protocol.frame import Frame, Kind
from .protocol.frame_writer import ConsumerFrames
from .protocol.limits import END_SECONDS
from .protocol.match import Match, read_match
from .protocol.provider_keys import ProviderKeys
from .protocol.sequence import Sequence
from .protocol.statement import Statement
from .request_owner import Host, RequestOwner


class ProvidersHost(Host, Protocol):
    """The part of a node that a subscriber uses."""

    def tell_provider(self, subscriber: Providers, change: str, provider: Match, reason: str) -> None:
        """Tells the application what became of a provider."""


class Providers(RequestOwner):
    """The base of Subscriber, which keeps the messages. Not thread-safe."""

    def __init__(self, node: ProvidersHost, said: dict[str, str]) -> None:
        limit = int(said.get("limit", "1" if said["mode"] == "oto" else "0"))
        super().__init__(node, Counterparts(limit=limit))
        self._node: ProvidersHost = node
        self._sequence = Sequence()
        self._frames = ConsumerFrames(self._life)
        self._keys = ProviderKeys()
        self._endings = Endings()
        self._complained: set[tuple[Key, str]] = set()
        self._missed = self._dropped = 0
        self._tcp = TcpInlets(self._loop, self._frames, self)
        self._udp: UdpInlet | None = None
        if "udp" in said.setdefault("protocol", "udp,tcp").split(","):
            self._udp = UdpInlet(self._loop, self._frames, int(said.get("port", "0")), said["mode"] == "otm/stream", self)
            said["port"] = str(self._udp.port)
        self._multicast = MulticastInlet(self._loop, self._udp, self)

    @property
    def providers(self) -> list[Match]:
        """The providers that are matched."""
        return self._matches()

    @property
    def missed(self) -> int:
        """The messages that are known to be missing, those lost in a full queue with them."""
        return self._missed

    @property
    def dropped(self) -> int:
        """The datagrams and frames that were not believed or could not be converted."""
        return self._dropped

    def _deliver(self, counterpart: Counterpart, payload: bytes, life: int, sequence: int, missed: int) -> None:
        raise NotImplementedError

    # Calls of the node

    def told(self, line: Statement) -> None:
        """Takes an event of the daemon about this request."""
        word = line.get("service")
        if line.subcommand == "modify":
            self._endings.modify_match(read_match(line))
        else:
            self._endings.take_match(word)
        if line.subcommand == "del":
            self._endings.deleted(self._counterparts.key_of(word), self._loop.time())
        super().told(line)

    def keyed(self, life: int, keys: ChannelKeys | None, text: str) -> None:
        """The daemon has said which keys a provider has, or something about them that cannot be done."""
        self._keys.put(life, keys, [one.match.life for one in self._counterparts])
        counterpart = self._counterparts.get(life)
        if keys is None:
            self.problem_once(text)
            if counterpart is not None and counterpart.belief is not None:
                counterpart.belief.keys = None
                self._close(counterpart)
        elif counterpart is not None:
            self._open(counterpart)
            self._deliver_early(counterpart)

    def mode_changed(self) -> None:
        """The daemon has said how this host seals, which counts for channels that have no line of keys."""
        for one in self._counterparts:
            if one.belief is None:
                self._open(one)

    def daemon_back(self, has_keys: bool) -> None:
        """The daemon is back. Without keys all channels are plain."""
        if not has_keys:
            self._keys.clear()
            for one in self._counterparts:
                self._open(one)
        super().daemon_back(has_keys)

    def daemon_lost(self) -> None:
        """The daemon is gone; channels go on."""
        self._endings.forget_matches()
        super().daemon_lost()

    # Inside

    def _change(self, change: Change) -> None:
        counterpart = change.counterpart
        if change.kind == "removed":
            self._removed(change)
            return
        resting = self._endings.take_resting(counterpart.key)
        if resting is not None:
            self._gone(resting)  # It is stated again before it has ended.
        self._open(counterpart)
        self._tell(change)
        self._deliver_early(counterpart)

    def _deliver_early(self, counterpart: Counterpart) -> None:
        if self._udp is not None and counterpart.belief is not None and counterpart.belief.keys is not None:
            self._udp.deliver_early(counterpart)

    def _open(self, counterpart: Counterpart) -> None:
        """Opens the channel to a provider, or moves it, as far as its keys and its place are known."""
        match = counterpart.match
        if match.life == 0 and not self._admits_without_life(counterpart):
            self._close(counterpart)
            return
        keys = self._keys.get(match.life, PLAIN if self._node.has_keys is False else None)
        if keys is not None and match.life:
            if counterpart.belief is None:
                counterpart.belief = Belief(self._life, match.life, keys)
            elif counterpart.belief.keys is not keys:
                counterpart.belief.rekey(keys)
        if match.life and (counterpart.belief is None or counterpart.belief.keys is None):
            return
        if match.protocol == "tcp":
            self._tcp.open(counterpart)
        elif match.protocol == "udp" and not sockets.is_multicast(match.address):
            if self._udp is not None:
                self._udp.open(counterpart)
        elif match.protocol == "udp":
            try:
                self._multicast.open(counterpart)
            except OSError as error:
                self.problem(f"{match.address} port {match.port} cannot be heard: {error.strerror}")

    def _admits_without_life(self, counterpart: Counterpart) -> bool:
        """Whether a service without a life is connected; if not, the application is told once."""
        match = counterpart.match
        if match.protocol == "tcp":
            text = f"{match.word} is offered over TCP without a channel: it is not connected"
        elif self._node.takes_plain:
            return True
        else:
            text = f"{match.word} states no life, so its channel cannot be sealed"
        self._complain(counterpart, text, text)
        return False

    def _removed(self, change: Change) -> None:
        counterpart = change.counterpart
        if change.reason == WITHDRAWN:
            if counterpart.match.protocol == "tcp" and self._tcp.withdrawn(counterpart):
                self._endings.rest(change)
                return
            self._read_all()
        self._close(counterpart)
        last = self._endings.last_of(counterpart.key)
        if change.reason == WITHDRAWN and last is not None:
            self._missed += self._sequence.missed_at_end(counterpart.match.life, last, is_sure=False)
        self._gone(change)

    def _close(self, counterpart: Counterpart) -> None:
        self._tcp.close(counterpart)
        self._multicast.close(counterpart)
        if self._udp is not None:
            self._udp.close(counterpart)

    def _gone(self, change: Change) -> None:
        key = change.counterpart.key
        if isinstance(key, int):
            self._sequence.interrupted(key)
        self._endings.forget(key)
        self._complained = {one for one in self._complained if one[0] != key}
        self._tell(change)

    def _reason(self, word: str, reason: str) -> str:
        """The reason of a `del`, which is that of an end that was said before."""
        return WITHDRAWN if self._endings.was_said(self._counterparts.key_of(word), self._loop.time()) else reason

    def _read_all(self) -> None:
        self._multicast.read_all()
        if self._udp is not None:
            self._udp.read_all()

    def _tell(self, change: Change) -> None:
        self._node.tell_provider(self, change.kind, change.counterpart.match, change.reason)

    # Calls of the inlets

    def connected(self, key: Key) -> None:
        """The connection to a provider is open."""
        self._counterparts.connected(key)

    def lost(self, key: Key) -> bool:
        """The connection to a provider ended or failed. Whether it is to be made again."""
        changes = self._counterparts.disconnected(key)
        self._apply(changes)
        return not changes and not self._is_closed

    def ended(self, key: Key) -> None:
        """A provider has said its end, or was withdrawn and says nothing more."""
        resting = self._endings.take_resting(key)
        if resting is not None:
            self._gone(resting)
            return
        counterpart = self._counterparts.get(key)
        if counterpart is None:
            return
        if counterpart.match.protocol == "tcp":
            for match in counterpart.words.values():
                timer = self._loop.call_later(END_SECONDS, self._again, match.word)
                self._endings.keep_match(match, timer)
        self._apply(self._counterparts.ended(key))

    def full(self, counterpart: Counterpart) -> None:
        """The provider has no place for this consumer."""
        belief, match = counterpart.belief, counterpart.match
        if belief is not None and not belief.is_told_full:
            belief.is_told_full = True
            address = f"[{match.address}]" if ":" in match.address else match.address
            self.problem(f"the provider {address}:{match.port} has no place for another consumer")

    def failed(self, error: Exception) -> None:
        """No frame can be sent any more."""
        self.problem_once(str(error))
        if isinstance(error, CounterError):
            self._loop.call_soon(self.abort)

    def drop(self) -> None:
        """Octets were not believed, or not yet."""
        self._dropped += 1

    def find(self) -> None:
        """A frame is believed that was dropped."""
        self._dropped -= 1

    def hear_datagram(self, counterpart: Counterpart, octets: bytes) -> None:
        """A datagram of a provider without a life has come."""
        self._deliver(counterpart, octets, 0, 0, 0)

    def hear(self, counterpart: Counterpart, frame: Frame) -> None:
        """A message or an end has come that is believed."""
        is_sure = frame.is_sealed or counterpart.match.protocol == "tcp"
        if frame.kind is Kind.END:
            if not is_sure:
                self._endings.said(counterpart.key, frame.sequence, self._loop.time())
                return
            self._missed += self._sequence.missed_at_end(frame.life, frame.sequence)
            if counterpart.match.protocol != "tcp":
                self._endings.forget(counterpart.key)
                self.ended(counterpart.key)
            return
        if is_sure:
            missed = self._sequence.missed_surely(frame.life, frame.sequence)
        else:
            missed = self._sequence.missed(frame.life, frame.sequence, self._loop.time())
        if missed is None:
            self._dropped += 1
            return
        self._missed += missed
        self._deliver(counterpart, frame.payload, frame.life, frame.sequence, missed)

    # Inside: ends

    def _again(self, word: str) -> None:
        """The match has lasted although its provider has said its end."""
        match = self._endings.take_match(word)
        if match is not None and not self._is_closed:
            self._apply(self._counterparts.add(match, self._loop.time()))

    def _complain(self, counterpart: Counterpart, cause: str, text: str) -> None:
        if (counterpart.key, cause) not in self._complained:
            self._complained.add((counterpart.key, cause))
            self.problem(text)

    def _close_all(self) -> None:
        self._endings.forget_matches()
        self._tcp.abort()
        self._multicast.abort()
        if self._udp is not None:
            self._udp.abort()
