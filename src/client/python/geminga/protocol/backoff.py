"""How long to wait before the next attempt."""

from __future__ import annotations

from collections.abc import Callable

FIRST_SECONDS = 0.1
LONGEST_SECONDS = 1.0


class Backoff:
    """.1, .2, .4, .8, 1, 1, ... seconds, each up to a quarter longer by chance, which gives 0 to 1."""

    def __init__(self, chance: Callable[[], float]) -> None:
        self._chance = chance
        self._next = FIRST_SECONDS

    def seconds(self) -> float:
        """The next wait."""
        wait = self._next
        self._next = min(2 * wait, LONGEST_SECONDS)
        return wait * (1 + self._chance() / 4)

    def reset(self) -> None:
        """After an attempt that went well: from the beginning."""
        self._next = FIRST_SECONDS
