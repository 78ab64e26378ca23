"""The counter of a life's frames, by which no nonce is used twice, and the process that may count."""

from __future__ import annotations

import os


class Process:
    """The process that runs. `number` rises in the child of a fork, also in the child of a child."""

    number = 0

    @classmethod
    def forked(cls) -> None:
        """This is the child of a fork now."""
        cls.number += 1


os.register_at_fork(after_in_child=Process.forked)


class CounterError(Exception):
    """A frame may not be sealed: the counter is used up."""


class ForkError(Exception):
    """A node was forked together with its process, and does not belong to the child."""

    def __init__(self) -> None:
        super().__init__("this node belongs to another process")


class Counter:
    """Counts from 1 to `last`, in the process that made it."""

    def __init__(self, last: int, value: int = 0) -> None:
        self._last = last
        self._value = value
        self._process = Process.number

    def next(self) -> int:
        """The next number. Raises CounterError and ForkError."""
        if Process.number != self._process:
            raise ForkError
        if self._value >= self._last:
            raise CounterError("the counter of this channel is used up: close it, and make another one")
        self._value += 1
        return self._value
