"""Frames put together from the octets of a stream."""

from __future__ import annotations

from .frame import HEADER_OCTETS, Frame, FrameError, Kind, read_header
from .limits import MAX_STREAM_PAYLOAD
from .sealed_frame import SEALED_HEADER_OCTETS, AnyFrame, is_sealed, read_whole, sealed_length


class FrameReader:
    """Keeps at most one unfinished frame and the octets that were fed last. Frames may have any form."""

    def __init__(self, max_payload: int = MAX_STREAM_PAYLOAD) -> None:
        self._max_payload = max_payload
        self._buffer = bytearray()
        self._plain: tuple[Kind, int, int, int] | None = None  # the header of the unfinished frame
        self._sealed: int | None = None  # the length that follows the header of a sealed one

    def feed(self, octets: bytes) -> list[AnyFrame]:
        """The frames that are whole now. Raises BrokenStream if nothing more can be read: close the connection."""
        self._buffer += octets
        frames: list[AnyFrame] = []
        at = 0
        try:
            while (end := self._end_of_frame(at)) <= len(self._buffer):
                if self._plain is not None:
                    kind, _, life, sequence = self._plain
                    frames.append(Frame(kind, life, sequence, bytes(self._buffer[at + HEADER_OCTETS : end])))
                else:
                    frames.append(read_whole(bytes(self._buffer[at:end])))
                at, self._plain, self._sealed = end, None, None
        except FrameError as error:
            raise BrokenStream(frames) from error
        del self._buffer[:at]
        return frames

    def _end_of_frame(self, at: int) -> int:
        """The end of the frame that begins here, or of its header while that is not whole."""
        if self._plain is None and self._sealed is None:
            if len(self._buffer) - at < HEADER_OCTETS:
                return at + HEADER_OCTETS
            with memoryview(self._buffer) as view:
                header = view[at : at + SEALED_HEADER_OCTETS]
                if not is_sealed(header):
                    self._plain = read_header(header, self._max_payload)
                elif len(header) < SEALED_HEADER_OCTETS:
                    return at + SEALED_HEADER_OCTETS
                else:
                    self._sealed = sealed_length(header, self._max_payload)
                header.release()
        if self._plain is not None:
            return at + HEADER_OCTETS + self._plain[1]
        assert self._sealed is not None
        return at + SEALED_HEADER_OCTETS + self._sealed


class BrokenStream(FrameError):
    """Nothing more can be read of a stream. `frames` came before the broken octets."""

    def __init__(self, frames: list[AnyFrame]) -> None:
        super().__init__("the stream of frames is broken")
        self.frames = frames
