"""The last message of each life, by which new messages are told from old ones and missing ones are counted."""

from __future__ import annotations

from bisect import bisect_right
from collections import OrderedDict

from .limits import MAX_RANGES, MAX_REMEMBERED_LIVES, MAX_STEP, STRAGGLER_SECONDS


class _Life:
    """One life: its last message, when that was, and what was delivered, as runs without a gap."""

    __slots__ = ("last", "at", "firsts", "ends", "straggler", "is_made_again", "is_sure")

    def __init__(self, sequence: int, now: float) -> None:
        self.last = sequence
        self.at = now
        self.firsts = [sequence]
        self.ends = [sequence]
        self.straggler: int | None = None  #: the dropped frame before, if none was delivered since
        self.is_made_again = False
        self.is_sure = False  #: the last message came over TCP, or sealed

    def was_delivered(self, sequence: int) -> bool:
        at = bisect_right(self.firsts, sequence) - 1
        return at >= 0 and sequence <= self.ends[at]

    def deliver(self, sequence: int, now: float) -> None:
        self.last, self.at, self.straggler, self.is_made_again, self.is_sure = sequence, now, None, False, False
        ends = self.ends
        if ends and ends[-1] + 1 == sequence:  # as nearly always
            ends[-1] = sequence
            return
        firsts = self.firsts
        at = bisect_right(firsts, sequence)
        joins_left = at > 0 and ends[at - 1] + 1 == sequence
        joins_right = at < len(firsts) and firsts[at] == sequence + 1
        if joins_left and joins_right:
            ends[at - 1] = ends[at]
            del firsts[at], ends[at]
        elif joins_left:
            ends[at - 1] = sequence
        elif joins_right:
            firsts[at] = sequence
        else:
            firsts.insert(at, sequence)
            ends.insert(at, sequence)
            if len(firsts) > MAX_RANGES:
                shortest = min(range(len(firsts)), key=lambda one: ends[one] - firsts[one])
                del firsts[shortest], ends[shortest]


class Sequence:
    """Remembers which messages of each life a subscriber delivered, of the lives that were heard last. Not thread-safe.

    Times are seconds of a monotonic clock. src/client/CHANNELS.md, "Which message is new", has the rules.
    """

    def __init__(self) -> None:
        self._lives: OrderedDict[int, _Life] = OrderedDict()

    def missed(self, life: int, sequence: int, now: float) -> int | None:
        """The number of messages that are missing before this one, which came over UDP without a key; None if it is to be dropped."""
        if sequence == 0:
            return None
        known = self._lives.get(life)
        if known is None:
            self._remember(life, sequence, now)
            return 0
        if sequence <= known.ends[-1] and known.was_delivered(sequence):
            return None
        if known.last < sequence and known.is_made_again:
            missed = 0
        elif known.last < sequence <= known.last + MAX_STEP:
            missed = sequence - known.last - 1
        else:
            before, known.straggler = known.straggler, sequence
            if now - known.at < STRAGGLER_SECONDS or before is None or not before < sequence <= before + MAX_STEP:
                return None
            missed = 0
        known.deliver(sequence, now)
        self._lives.move_to_end(life)
        return missed

    def missed_surely(self, life: int, sequence: int) -> int | None:
        """The number of messages that are missing before this one, which came over TCP or sealed; None if it is old."""
        known = self._lives.get(life)
        if known is None:
            self._remember(life, sequence, 0.0).is_sure = True
            return 0
        missed = sequence - known.last - 1
        if known.is_sure:
            if missed < 0:
                return None
        elif known.was_delivered(sequence):  # without a key
            return None
        elif not 0 <= missed < MAX_STEP:
            missed = 0  # Nobody can say whether the last message was forged.
        if known.is_made_again:
            missed, known.is_made_again = 0, False
        known.last, known.is_sure = sequence, True
        self._lives.move_to_end(life)
        return missed

    def missed_at_end(self, life: int, last: int, is_sure: bool = True) -> int:
        """The number of messages that are missing up to the last one of this life; 0 for one that cannot be believed."""
        known = self._lives.get(life)
        if known is None or known.is_made_again:
            return 0
        missed = max(0, last - known.last)
        return missed if is_sure or missed <= MAX_STEP else 0

    def interrupted(self, life: int) -> None:
        """The channel was closed: messages that are sent until it is opened again are not missed."""
        known = self._lives.get(life)
        if known is not None:
            known.is_made_again = True

    def _remember(self, life: int, sequence: int, now: float) -> _Life:
        known = self._lives[life] = _Life(sequence, now)
        if len(self._lives) > MAX_REMEMBERED_LIVES:
            self._lives.popitem(last=False)
        return known
