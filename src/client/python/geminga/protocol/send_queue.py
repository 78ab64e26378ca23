"""The frames that wait for the TCP consumers of one publisher. Each frame is kept once, whoever waits for it."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence

from .limits import MAX_FRAMES_FOR_ALL, MAX_FRAMES_FOR_CONSUMER, MAX_WAITING_FOR_ALL, MAX_WAITING_FOR_CONSUMER


class SharedFrame:
    """A frame in one or two pieces, and how many queues keep it."""

    __slots__ = ("pieces", "octets", "holders")

    def __init__(self, *pieces: bytes) -> None:
        self.pieces = pieces
        self.octets = sum(map(len, pieces))
        self.holders = 0


class Pool:
    """All frames that wait and their octets, each frame counted once."""

    __slots__ = ("octets", "frames")

    def __init__(self) -> None:
        self.octets = 0
        self.frames = 0

    @property
    def is_over(self) -> bool:
        """Whether more waits than all consumers of a publisher may cost."""
        return self.octets > MAX_WAITING_FOR_ALL or self.frames > MAX_FRAMES_FOR_ALL


class SendQueue:
    """The frames that wait for one consumer, in order. Not thread-safe."""

    def __init__(self, pool: Pool) -> None:
        self._pool = pool
        self._frames: deque[SharedFrame] = deque()
        self._sent = 0  # octets of the first frame
        self.octets = 0  #: that wait

    def __len__(self) -> int:
        return len(self._frames)

    def has_room_for(self, octets: int) -> bool:
        """Whether a frame of this size may wait: within 4 MiB and 16384 frames, or alone."""
        return not self._frames or (self.octets + octets <= MAX_WAITING_FOR_CONSUMER and len(self._frames) < MAX_FRAMES_FOR_CONSUMER)

    def put(self, frame: SharedFrame, sent: int = 0) -> None:
        """Keeps a frame, of which so many octets have been sent. Requires that none waits if that is not 0."""
        if not frame.holders:
            self._pool.octets += frame.octets
            self._pool.frames += 1
        frame.holders += 1
        if not self._frames:
            self._sent = sent
        self._frames.append(frame)
        self.octets += frame.octets - sent

    def pieces(self) -> Sequence[bytes | memoryview]:
        """The octets of the first frame that are to be sent. Requires that there is one."""
        pieces, left = self._frames[0].pieces, self._sent
        if not left:
            return pieces
        rest: list[bytes | memoryview] = []
        for piece in pieces:
            if left < len(piece):
                rest.append(memoryview(piece)[left:])
            left = max(0, left - len(piece))
        return rest

    def took(self, octets: int) -> bool:
        """So many octets of the first frame were sent. Whether that was all of it."""
        self.octets -= octets
        self._sent += octets
        if self._sent < self._frames[0].octets:
            return False
        self._sent = 0
        self._leave(self._frames.popleft())
        return True

    def clear(self, keeps_begun: bool = False) -> None:
        """Forgets all frames, or all but one that was sent in part."""
        begun = self._frames.popleft() if keeps_begun and self._frames and self._sent else None
        for frame in self._frames:
            self._leave(frame)
        self._frames.clear()
        self.octets = 0
        if begun is not None:
            self._frames.append(begun)
            self.octets = begun.octets - self._sent
        else:
            self._sent = 0

    def _leave(self, frame: SharedFrame) -> None:
        frame.holders -= 1
        if not frame.holders:
            self._pool.octets -= frame.octets
            self._pool.frames -= 1
