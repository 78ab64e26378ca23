"""The ends that providers have said, until the daemon confirms them (src/client/CHANNELS.md, "How a channel ends")."""

from __future__ import annotations

from typing import Protocol

from .counterparts import Change, Key
from .limits import END_SECONDS
from .match import Match


class Timer(Protocol):
    """A timer that can be cancelled."""

    def cancel(self) -> None:
        """It does not ring."""


class Endings:
    """The ends of one subscriber's channels. Times are seconds of a monotonic clock. Not thread-safe."""

    def __init__(self) -> None:
        self._hints: dict[Key, tuple[int, float]] = {}  # the last sequence of an end without a key, and when that came
        self._resting: dict[Key, Change] = {}  # withdrawn providers over TCP, until their ends
        self._matches: dict[str, tuple[Match, Timer]] = {}  # ended over TCP before the daemon said so, by the daemon's words

    def said(self, key: Key, last: int, now: float) -> None:
        """An end came that anybody may have forged."""
        self._hints[key] = last, now

    def was_said(self, key: Key | None, now: float) -> bool:
        """Whether such an end came in the last 10 s."""
        hint = None if key is None else self._hints.get(key)
        return hint is not None and now - hint[1] < END_SECONDS

    def deleted(self, key: Key | None, now: float) -> None:
        """The daemon has told of an end: a hint that is too old is forgotten."""
        if key is not None and not self.was_said(key, now):
            self._hints.pop(key, None)

    def last_of(self, key: Key) -> int | None:
        """The last sequence that such an end named."""
        hint = self._hints.get(key)
        return None if hint is None else hint[0]

    def forget(self, key: Key) -> None:
        """The channel has ended."""
        self._hints.pop(key, None)

    def rest(self, change: Change) -> None:
        """A provider was withdrawn, of which something may still come."""
        self._resting[change.counterpart.key] = change

    def take_resting(self, key: Key) -> Change | None:
        """The provider that was withdrawn, if it was."""
        return self._resting.pop(key, None)

    def keep_match(self, match: Match, timer: Timer) -> None:
        """A provider has ended whose match lasts."""
        self.take_match(match.word)
        self._matches[match.word] = match, timer

    def modify_match(self, match: Match) -> None:
        """The daemon has said something else of such a match."""
        kept = self._matches.get(match.word)
        if kept is not None:
            self._matches[match.word] = match, kept[1]

    def take_match(self, word: str) -> Match | None:
        """The match has ended, is stated anew, or its time is over. Returns it if it was kept."""
        match, timer = self._matches.pop(word, (None, None))
        if timer is not None:
            timer.cancel()
        return match

    def forget_matches(self) -> None:
        """The daemon is gone, or the subscriber is closed."""
        for word in list(self._matches):
            self.take_match(word)
