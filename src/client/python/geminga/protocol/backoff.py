"""The wait before the next attempt to connect."""

from __future__ import annotations

from collections.abc import Callable

FIRST_SECONDS = 0.1
LONGEST_SECONDS = 1.0


class Backoff:
    """Waits .1, .2, .4, .8, 1, 1, ... seconds, each up to a quarter longer. `chance` gives random numbers from 0 to 1."""

    def __init__(self, chance: Callable[[], float]) -> None:
        self._chance = chance
        self._next = FIRST_SECONDS

    def seconds(self) -> float:
        """The next wait."""
        wait = self._next
        self._next = min(2 * wait, LONGEST_SECONDS)
        return wait * (1 + self._chance() / 4)

    def reset(self) -> None:
        """An attempt has succeeded: begins with the shortest wait again."""
        self._next = FIRST_SECONDS
