"""Messages that wait until the application receives them (src/client/CHANNELS.md, "A full inbox")."""

from __future__ import annotations

from collections import OrderedDict, deque
from dataclasses import dataclass, replace

from .limits import MAX_REMEMBERED_LIVES, MAX_WAITING_MESSAGES, MAX_WAITING_OCTETS




@dataclass(frozen=True, slots=True)
class Message:
    """A message of a subscriber. Life and sequence are 0 if the provider states no life."""

    payload: bytes
    life: int = 0
    sequence: int = 0
    missed: int = 0  #: messages of this life that are missing before this one, or were lost in a full inbox


class Inbox:
    """Keeps at most `limit` messages and 16 MiB, but always one. A full one loses the oldest datagram, or the new one if not
    `keep_newest`. Not thread-safe."""

    def __init__(self, limit: int = MAX_WAITING_MESSAGES, keep_newest: bool = True) -> None:
        if limit < 1:
            raise ValueError("a queue has room for one message at least")
        self._limit = limit
        self._keep_newest = keep_newest
        self._messages: deque[tuple[Message, bool]] = deque()  # with whether it came in a datagram
        self._octets = 0
        self._losable = 0
        self._lost: OrderedDict[int, int] = OrderedDict()  # by life, since its last message that was taken

    def __len__(self) -> int:
        return len(self._messages)

    @property
    def is_full(self) -> bool:
        """Whether a datagram would be lost for one more message."""
        return len(self._messages) >= self._limit or self._octets >= MAX_WAITING_OCTETS

    @property
    def has_room(self) -> bool:
        """Whether at least half of it is free, so that it is worth while to read on."""
        return 2 * len(self._messages) <= self._limit and 2 * self._octets <= MAX_WAITING_OCTETS

    def put_datagram(self, message: Message) -> int:
        """Keeps a message that came in a datagram. Returns how many are lost for it: the oldest datagrams, or this one."""
        lost = 0
        while self._keep_newest and self.is_full and self._losable:
            self._lose_oldest()
            lost += 1
        if self.is_full:
            self._lose(message)
            return lost + 1
        if not self._keep_newest:
            message = self._told(message)
        self._losable += 1
        self._put(message, True)
        return lost

    def put_streamed(self, message: Message) -> None:
        """Keeps a message of a stream, which cannot be lost: the caller reads no more where the inbox is full."""
        self._put(message, False)

    def take(self) -> Message:
        """The oldest message. Requires that there is one."""
        message, may_be_lost = self._messages.popleft()
        self._octets -= len(message.payload)
        self._losable -= may_be_lost
        return self._told(message) if self._keep_newest else message

    def _put(self, message: Message, may_be_lost: bool) -> None:
        self._messages.append((message, may_be_lost))
        self._octets += len(message.payload)

    def _lose_oldest(self) -> None:
        at = next(i for i, (_, may_be_lost) in enumerate(self._messages) if may_be_lost)
        message, _ = self._messages[at]
        del self._messages[at]
        self._octets -= len(message.payload)
        self._losable -= 1
        self._lose(message)

    def _lose(self, message: Message) -> None:
        if message.life:
            self._lost[message.life] = self._lost.get(message.life, 0) + message.missed + 1
            if len(self._lost) > MAX_REMEMBERED_LIVES:
                self._lost.popitem(last=False)

    def _told(self, message: Message) -> Message:
        """The message, with the messages of its life that were lost before it."""
        lost = self._lost.pop(message.life, 0) if self._lost else 0
        return replace(message, missed=message.missed + lost) if lost else message
