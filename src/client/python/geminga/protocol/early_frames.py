"""Frames over UDP that came before the daemon told of whom they are (src/client/CHANNELS.md, "Early frames")."""

from __future__ import annotations

from collections import deque
from typing import Any

from .frame import Frame
from .limits import EARLY_SECONDS, MAX_EARLY_FRAMES, MAX_EARLY_OCTETS


Address = tuple[Any, ...]


class EarlyFrames:
    """The oldest goes where one more comes. Addresses as the socket writes them. Time is seconds of a monotonic clock. Not thread-safe."""

    def __init__(self) -> None:
        self._kept: deque[tuple[float, Address, Frame]] = deque()
        self._octets = 0

    def put(self, source: Address, frame: Frame, now: float) -> None:
        """Keeps a frame for a second, if it may be kept at all."""
        self._forget_old(now)
        size = len(frame.payload)
        if size > MAX_EARLY_OCTETS:
            return
        while len(self._kept) >= MAX_EARLY_FRAMES or self._octets + size > MAX_EARLY_OCTETS:
            self._forget_first()
        self._kept.append((now + EARLY_SECONDS, source, frame))
        self._octets += size

    def take(self, source: Address, life: int, now: float) -> list[Frame]:
        """What is there of this life from there, in the order in which it came."""
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
