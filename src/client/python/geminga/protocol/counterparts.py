"""The counterparts of a channel: the providers of a subscriber, or the consumers of a publisher.

A counterpart is known by its life, which stays the same while daemons come and go (src/client/CHANNELS.md, "How a channel
ends"). The caller gives the time, in seconds of a monotonic clock. Not thread-safe.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from .belief import Belief
from .limits import ORPHAN_SECONDS, SETTLE_SECONDS
from .match import Match

#: Reasons that end a channel at once. Every other reason says that the daemons have lost sight of the counterpart.
WITHDRAWN = "withdrawn"
CHANGED = "changed"
OUTRANKED = "outranked"
FINAL_REASONS = frozenset({WITHDRAWN, OUTRANKED, CHANGED})

DISCONNECTED = "disconnected"  #: the own daemon came back and did not confirm the channel
LOST = "lost"  #: the connection of a channel ended, and no daemon announces the counterpart
SLOW = "slow"  #: a consumer took nothing for the longest time while too much waited for all

Key = int | str  #: the life, or the word of a counterpart without one


@dataclass(eq=False, slots=True)
class Counterpart:
    """The other end of a channel. `words` are the daemon's words under which it is matched now."""

    key: Key
    match: Match
    words: dict[str, Match] = field(default_factory=dict)
    reason: str = ""  #: why the daemons have lost sight of it
    is_orphan: bool = False
    is_connected: bool = False  #: over TCP: whether its connection is open
    belief: Belief | None = None  #: of a provider with a life
    closes_at: float | None = None


@dataclass(frozen=True, slots=True)
class Change:
    """A change of a counterpart. `kind` is `added`, `modified` or `removed`; the last has a reason."""

    kind: str
    counterpart: Counterpart
    reason: str = ""


def _told(match: Match) -> Match:
    """The part of a match that the application is told, which is all but the daemon's word for it."""
    return replace(match, word="")


class Counterparts:
    """All counterparts of one channel. `limit` is how many the request admits, 0 for all. `protocol` is that of a publisher, since
    the events of consumers name none."""

    def __init__(self, protocol: str = "", limit: int = 0) -> None:
        self._protocol = protocol
        self.limit = limit
        self._by_key: dict[Key, Counterpart] = {}
        self._keys: dict[str, Key] = {}
        self._confirm_by: float | None = None
        self._is_lost = False

    def __iter__(self) -> Iterator[Counterpart]:
        return iter(list(self._by_key.values()))

    def __len__(self) -> int:
        return len(self._by_key)

    def get(self, key: Key) -> Counterpart | None:
        """The counterpart with this life or word."""
        return self._by_key.get(key)

    def key_of(self, word: str) -> Key | None:
        """The key of the counterpart that the daemon means by this word."""
        return self._keys.get(word)

    def modify(self, match: Match, now: float) -> list[Change]:
        """Takes a `modify` of the daemon. It does not bring back a counterpart that has ended."""
        return self.add(match, now) if match.word in self._keys else []

    def add(self, match: Match, now: float) -> list[Change]:
        """Takes an `add` of the daemon. A life whose word another one has is lost sight of: the daemon may tell it by another word."""
        key: Key = match.life or match.word
        changes: list[Change] = []
        if self._keys.get(match.word, key) != key:
            changes += self._delete(match.word, CHANGED, now, is_final=False)
        self._keys[match.word] = key
        known = self._by_key.get(key)
        if known is None:
            known = self._by_key[key] = Counterpart(key, match, {match.word: match})
            changes.append(Change("added", known))
        else:
            before, known.match = known.match, match
            known.words[match.word] = match
            known.is_orphan, known.closes_at, known.reason = False, None, ""
            if _told(before) != _told(match):
                changes.append(Change("modified", known))
        return changes + self._without_surplus()

    def delete(self, word: str, reason: str, now: float) -> list[Change]:
        """Takes a `del` of the daemon.

        A consumer that is outranked within 10 s after the own daemon came back may only have chosen the same life under its former word.
        """
        is_in_doubt = reason == OUTRANKED and self._protocol != "" and self._confirm_by is not None
        return self._delete(word, reason, now, reason in FINAL_REASONS and not is_in_doubt)

    def _delete(self, word: str, reason: str, now: float, is_final: bool) -> list[Change]:
        key = self._keys.pop(word, None)
        known = self._by_key.get(key) if key is not None else None
        if known is None or known.words.pop(word, None) is None:
            return []
        if known.words:
            known.match = next(reversed(known.words.values()))
            return []
        if is_final:
            return [self._remove(known, reason)]
        return self._orphan(known, reason, now) + self._without_surplus()

    def daemon_lost(self) -> None:
        """The own daemon is gone. All channels go on, however long that takes, also those that the daemons had lost sight of."""
        self._is_lost, self._confirm_by = True, None
        self._keys.clear()
        for known in self._by_key.values():
            known.words.clear()
            known.is_orphan, known.closes_at = False, None

    def daemon_back(self, now: float) -> None:
        """The own daemon is back. Counterparts that it does not confirm in time become orphans."""
        if self._is_lost:
            self._is_lost, self._confirm_by = False, now + SETTLE_SECONDS

    def ended(self, key: Key, reason: str = WITHDRAWN) -> list[Change]:
        """The other side has ended the channel."""
        known = self._by_key.get(key)
        return [] if known is None else [self._remove(known, reason)]

    def connected(self, key: Key) -> None:
        """The TCP connection of a counterpart is open."""
        known = self._by_key.get(key)
        if known is not None:
            known.is_connected = True

    def disconnected(self, key: Key) -> list[Change]:
        """The TCP connection of a counterpart broke. A matched one may connect again; any other is gone."""
        known = self._by_key.get(key)
        if known is None:
            return []
        known.is_connected = False
        if known.words:
            return []
        return [self._remove(known, known.reason or (DISCONNECTED if self._is_unsure else LOST))]

    def tick(self, now: float) -> list[Change]:
        """Ends the channels whose time is over."""
        changes: list[Change] = []
        if self._confirm_by is not None and now >= self._confirm_by:
            self._confirm_by = None
            for known in list(self._by_key.values()):
                if not known.words and not known.is_orphan:
                    changes += self._orphan(known, DISCONNECTED, now)
            changes += self._without_surplus()
        for known in list(self._by_key.values()):
            if known.closes_at is not None and now >= known.closes_at:
                changes.append(self._remove(known, known.reason))
        return changes

    def due(self) -> float | None:
        """The time at which tick() has something to do, or None."""
        times = [known.closes_at for known in self._by_key.values() if known.closes_at is not None]
        if self._confirm_by is not None:
            times.append(self._confirm_by)
        return min(times, default=None)

    @property
    def _is_unsure(self) -> bool:
        return self._is_lost or self._confirm_by is not None

    def _orphan(self, known: Counterpart, reason: str, now: float) -> list[Change]:
        known.is_orphan, known.reason = True, reason
        if (self._protocol or known.match.protocol) != "tcp":
            known.closes_at = now + ORPHAN_SECONDS
        elif not known.is_connected:
            return [self._remove(known, reason)]
        return []

    def _remove(self, known: Counterpart, reason: str) -> Change:
        self._by_key.pop(known.key, None)
        for word in known.words:
            self._keys.pop(word, None)
        return Change("removed", known, reason)

    def _without_surplus(self) -> list[Change]:
        """Removes the orphans if the request has its limit of other counterparts."""
        if self.limit == 0 or sum(bool(known.words) for known in self._by_key.values()) < self.limit:
            return []
        return [self._remove(known, known.reason) for known in list(self._by_key.values()) if known.is_orphan]
