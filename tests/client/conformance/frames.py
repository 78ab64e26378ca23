"""Plain frames, as strangers write them (src/client/CHANNELS.md, "Frames")."""

from __future__ import annotations

import struct

MESSAGE, HELLO, END, FLOOR, FULL = 1, 2, 3, 4, 5


def frame(kind: int, life: int, sequence: int, payload: bytes) -> str:
    """A plain frame in hexadecimal digits."""
    return (struct.pack("!2sBBIQQ", b"GC", 1, kind, len(payload), life, sequence) + payload).hex()
