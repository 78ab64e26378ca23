"""Frames put together from the octets of a stream."""

from __future__ import annotations

from .frame import HEADER_OCTETS, Frame, FrameError, Kind, read_header
from .limits import MAX_STREAM_PAYLOAD


class FrameReader:
    """Keeps at most one unfinished frame and the octets that were fed last."""

    def __init__(self, max_payload: int = MAX_STREAM_PAYLOAD) -> None:
        self._max_payload = max_payload
        self._buffer = bytearray()
        self._header: tuple[Kind, int, int, int] | None = None

    def feed(self, octets: bytes) -> list[Frame]:
        """The frames that are whole now. Raises BrokenStream if nothing more can be read: close the connection."""
        self._buffer += octets
        frames: list[Frame] = []
        at = 0
        try:
            while True:
                if self._header is None:
                    if len(self._buffer) - at < HEADER_OCTETS:
                        break
                    self._header = read_header(memoryview(self._buffer)[at : at + HEADER_OCTETS], self._max_payload)
                kind, length, life, sequence = self._header
                end = at + HEADER_OCTETS + length
                if len(self._buffer) < end:
                    break
                frames.append(Frame(kind, life, sequence, bytes(self._buffer[at + HEADER_OCTETS : end])))
                at, self._header = end, None
        except FrameError as error:
            raise BrokenStream(frames) from error
        del self._buffer[:at]
        return frames


class BrokenStream(FrameError):
    """Nothing more can be read of a stream. `frames` came before the broken octets."""

    def __init__(self, frames: list[Frame]) -> None:
        super().__init__("the stream of frames is broken")
        self.frames = frames
