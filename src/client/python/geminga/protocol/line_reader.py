"""Lines put together from the octets of a stream."""

from __future__ import annotations

from collections.abc import Iterator

from .statement import MAX_LINE_OCTETS, LineError


class LineReader:
    """Reads lines that end in LF or CR LF. Keeps at most one unfinished line."""

    def __init__(self) -> None:
        self._rest = b""

    def feed(self, octets: bytes) -> Iterator[bytes]:
        """The lines that are whole now, without their ends. Raises LineError after them if the rest is too long."""
        *lines, self._rest = (self._rest + octets).split(b"\n")
        for line in lines:
            yield line.removesuffix(b"\r")
        if len(self._rest.removesuffix(b"\r")) > MAX_LINE_OCTETS:
            self._rest = b""
            raise LineError(f"a line has at most {MAX_LINE_OCTETS} octets")
