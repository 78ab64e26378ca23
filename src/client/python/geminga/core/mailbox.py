"""Messages that wait for the application, with a limit."""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass

MAX_MESSAGES = 1024
MAX_OCTETS = 64 * 1024 * 1024


@dataclass(frozen=True, slots=True)
class Message:
    """What a subscriber receives. Life and sequence are 0 where the provider does not speak in frames."""

    payload: bytes
    life: int = 0
    sequence: int = 0
    missed: int = 0  #: messages of this life that are missing before this one


class Mailbox:
    """At most `limit` messages and 64 MiB, but always one. Not thread-safe."""

    def __init__(self, limit: int = MAX_MESSAGES, keep_newest: bool = True) -> None:
        if limit < 1:
            raise ValueError("a queue has room for one message at least")
        self._limit = limit
        self._keep_newest = keep_newest
        self._messages: deque[Message] = deque()
        self._octets = 0

    def __len__(self) -> int:
        return len(self._messages)

    @property
    def is_full(self) -> bool:
        """Whether another message would be lost, or take the place of the oldest."""
        return len(self._messages) >= self._limit or self._octets >= MAX_OCTETS

    @property
    def has_room(self) -> bool:
        """Whether it is half empty."""
        return 2 * len(self._messages) <= self._limit and 2 * self._octets <= MAX_OCTETS

    def put(self, message: Message) -> int:
        """Takes a message, and says how many were lost for that: the oldest ones, or this one."""
        lost = 0
        if self.is_full:
            if not self._keep_newest:
                return 1
            while self.is_full:
                self._octets -= len(self._messages.popleft().payload)
                lost += 1
        self.put_anyway(message)
        return lost

    def put_anyway(self, message: Message) -> None:
        """Takes a message that may not be lost. Whoever calls it stops reading where the mailbox is full."""
        self._messages.append(message)
        self._octets += len(message.payload)

    def take(self) -> Message:
        """The oldest message. Requires that there is one."""
        message = self._messages.popleft()
        self._octets -= len(message.payload)
        return message
