"""Lives: 64 random bits of a publisher or subscriber, which stay the same while its daemon is restarted."""

from __future__ import annotations

import re
import secrets

KEY = "channel"
_WRITTEN = re.compile(r"[0-9a-f]{16}")


def draw_life() -> int:
    """A new life, which is not 0."""
    return secrets.randbelow(0xFFFFFFFFFFFFFFFF) + 1


def write_life(life: int) -> str:
    """The life in sixteen lower-case hexadecimal digits."""
    return f"{life:016x}"


def read_life(text: str) -> int:
    """The life that a text writes, or 0 if it writes none."""
    return int(text, 16) if _WRITTEN.fullmatch(text) else 0
