"""The last message of each life, by which new messages are told from old ones and missing ones are counted."""

from __future__ import annotations

from collections import OrderedDict

from .limits import MAX_REMEMBERED_LIVES



class Sequence:
    """Remembers which message of each life a subscriber delivered last, of the lives that were heard last. Not thread-safe."""

    def __init__(self) -> None:
        self._last: OrderedDict[int, int] = OrderedDict()
        self._breaks: set[int] = set()

    def missed(self, life: int, sequence: int) -> int | None:
        """The number of messages that are missing before this one; None if it is old."""
        last = self._last.get(life)
        if last is None:
            self._last[life] = sequence
            if len(self._last) > MAX_REMEMBERED_LIVES:
                self._breaks.discard(self._last.popitem(last=False)[0])
            return 0
        if sequence <= last:
            return None
        self._last[life] = sequence
        self._last.move_to_end(life)
        if life in self._breaks:
            self._breaks.discard(life)
            return 0
        return sequence - last - 1

    def missed_at_end(self, life: int, last: int) -> int:
        """The number of messages that are missing up to the last one of this life."""
        heard = self._last.get(life)
        return max(0, last - heard) if heard is not None and life not in self._breaks else 0

    def interrupted(self, life: int) -> None:
        """The channel was closed: messages that are sent until it is opened again are not missed."""
        if life in self._last:
            self._breaks.add(life)
