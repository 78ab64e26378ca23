"""Whom a channel goes to or comes from, and for how long (src/client/CHANNELS.md, "How a channel ends").

A subscriber's counterparts are its providers, those of a publisher its consumers. They are known by their life, which stays
the same whatever becomes of daemons. Time is seconds of a monotonic clock, given by the caller. Not thread-safe.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from .limits import ORPHAN_SECONDS, SETTLE_SECONDS
from .match import Match

#: What ends a channel at once; every other reason says that somebody was lost sight of.
FINAL_REASONS = frozenset({"withdrawn", "outranked", "changed"})

WITHDRAWN = "withdrawn"
DISCONNECTED = "disconnected"  #: the own daemon went, and its return did not confirm the channel
LOST = "lost"  #: the connection of a channel ended, and nobody announces it any more

Key = int | str  #: the life, or the word of who has none


@dataclass(eq=False, slots=True)
class Counterpart:
    """One other end of a channel. `words`: the daemon's words under which it is matched now."""

    key: Key
    match: Match
    words: dict[str, Match] = field(default_factory=dict)
    reason: str = ""  #: why it has been lost sight of
    is_orphan: bool = False
    is_connected: bool = False  #: over TCP: whether its connection is open
    closes_at: float | None = None


@dataclass(frozen=True, slots=True)
class Change:
    """`kind` is `added`, `modified` or `removed`. What is removed has a reason."""

    kind: str
    counterpart: Counterpart
    reason: str = ""


def _told(match: Match) -> Match:
    """What the application is told of: the daemon's word for it is not among that."""
    return replace(match, word="")


class Counterparts:
    """`limit`: how many the request admits, 0 for all. `protocol` of the publication, for consumers, of whom it is not told."""

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
        """The counterpart with this life, or word."""
        return self._by_key.get(key)

    def modify(self, match: Match) -> list[Change]:
        """`modify` of the daemon. What has ended meanwhile is not made again."""
        return self.add(match) if match.word in self._keys else []

    def add(self, match: Match) -> list[Change]:
        """`add` of the daemon."""
        key: Key = match.life or match.word
        changes: list[Change] = []
        if self._keys.get(match.word, key) != key:
            changes += self.delete(match.word, "changed", 0.0)
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
        """`del` of the daemon."""
        key = self._keys.pop(word, None)
        known = self._by_key.get(key) if key is not None else None
        if known is None or known.words.pop(word, None) is None:
            return []
        if known.words:
            known.match = next(reversed(known.words.values()))
            return []
        if reason in FINAL_REASONS:
            return [self._remove(known, reason)]
        return self._orphan(known, reason, now) + self._without_surplus()

    def daemon_lost(self) -> None:
        """The own daemon is gone: channels go on however long that takes."""
        self._is_lost, self._confirm_by = True, None
        self._keys.clear()
        for known in self._by_key.values():
            known.words.clear()

    def daemon_back(self, now: float) -> None:
        """It is there again: what it does not confirm in time has been lost sight of."""
        if self._is_lost:
            self._is_lost, self._confirm_by = False, now + SETTLE_SECONDS

    def ended(self, key: Key, reason: str = WITHDRAWN) -> list[Change]:
        """The other side ended the channel."""
        known = self._by_key.get(key)
        return [] if known is None else [self._remove(known, reason)]

    def connected(self, key: Key) -> None:
        """Its TCP connection is open."""
        known = self._by_key.get(key)
        if known is not None:
            known.is_connected = True

    def disconnected(self, key: Key) -> list[Change]:
        """Its TCP connection ended, not cleanly. Who is still matched may be connected again, all others are gone."""
        known = self._by_key.get(key)
        if known is None:
            return []
        known.is_connected = False
        if known.words:
            return []
        return [self._remove(known, known.reason or (DISCONNECTED if self._is_unsure else LOST))]

    def tick(self, now: float) -> list[Change]:
        """What is due."""
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
        """When tick() has something to do, or None."""
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
        """Where the request has its limit of others, orphans are closed."""
        if self.limit == 0 or sum(bool(known.words) for known in self._by_key.values()) < self.limit:
            return []
        return [self._remove(known, known.reason) for known in list(self._by_key.values()) if known.is_orphan]
