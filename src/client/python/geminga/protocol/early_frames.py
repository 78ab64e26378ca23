"""Frames over UDP whose sender the daemon has not named yet, or whose floor has not come (src/client/CHANNELS.md, "Early frames")."""

from __future__ import annotations

from collections import deque
from typing import Any

from .limits import EARLY_SECONDS, MAX_EARLY_FRAMES, MAX_EARLY_OCTETS
from .sealed_frame import AnyFrame


Address = tuple[Any, ...]


class EarlyFrames:
    """Keeps early frames; for one more than the limit the oldest goes. Addresses are as the socket writes them, times are seconds of a
    monotonic clock. Not thread-safe."""

    def __init__(self) -> None:
        self._kept: deque[tuple[float, Address, AnyFrame]] = deque()
        self._octets = 0

    def put(self, source: Address, frame: AnyFrame, now: float) -> None:
        """Keeps a frame for a second, unless it is too large."""
        self._forget_old(now)
        size = len(frame.payload)
        if size > MAX_EARLY_OCTETS:
            return
        while len(self._kept) >= MAX_EARLY_FRAMES or self._octets + size > MAX_EARLY_OCTETS:
            self._forget_first()
        self._kept.append((now + EARLY_SECONDS, source, frame))
        self._octets += size

    def take(self, source: Address, life: int, now: float) -> list[AnyFrame]:
        """Removes the frames of this life from this address, and returns them in the order of arrival."""
        self._forget_old(now)
        if not self._kept:
            return []
        kept, self._kept = self._kept, deque()
        taken = []
        for one in kept:
            _, there, frame = one
            if there == source and frame.life == life:
                self._octets -= len(frame.payload)
                taken.append(frame)
            else:
                self._kept.append(one)
        return taken

    def _forget_old(self, now: float) -> None:
        while self._kept and self._kept[0][0] <= now:
            self._forget_first()

    def _forget_first(self) -> None:
        _, _, frame = self._kept.popleft()
        self._octets -= len(frame.payload)
