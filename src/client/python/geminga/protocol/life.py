"""Lives: 64 random bits by which both sides of a channel know each other."""

from __future__ import annotations

import re
import secrets

KEY = "channel"
_WRITTEN = re.compile(r"[0-9a-f]{16}")


def draw_life() -> int:
    """A new life, which is not 0."""
    return secrets.randbelow(0xFFFFFFFFFFFFFFFF) + 1


def write_life(life: int) -> str:
    """Sixteen lower-case hexadecimal digits."""
    return f"{life:016x}"


def read_life(text: str) -> int:
    """The life that is written so, or 0 where that is none."""
    return int(text, 16) if _WRITTEN.fullmatch(text) else 0
