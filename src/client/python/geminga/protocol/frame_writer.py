"""The frames of one life, plain or sealed as the mode wants it, with the one counter of this life."""

from __future__ import annotations

from collections.abc import Callable

from .channel_keys import LAST_BACK, LAST_FORWARD, ChannelKeys
from .counter import Counter, ForkError, Process
from .frame import HEADER, MAGIC, Form, Frame, Kind, write_frame
from .sealed_frame import AnyFrame


class PublisherFrames:
    """The frames of a publisher. `keys` are None until the daemon has said which there are; `sequence` gives that of its last message."""

    def __init__(self, life: int, sequence: Callable[[], int] = lambda: 0, keys: ChannelKeys | None = None) -> None:
        self.life = life
        self.keys = keys
        self.hello_port = 0  #: where hellos are taken, if it is not the port that is sent from
        self._sequence = sequence
        self._counter = Counter(LAST_FORWARD)
        self._process = Process.number

    @property
    def seals(self) -> bool:
        """Whether frames are sent sealed."""
        return self.keys is not None and self.keys.seals

    @property
    def is_strict(self) -> bool:
        """Whether no plain frame is taken."""
        return self.keys is not None and not self.keys.takes_plain

    @property
    def has_ring(self) -> bool:
        """Whether consumers say hello on every channel."""
        return self.keys is not None and self.keys.has_ring

    def message(self, sequence: int, payload: bytes) -> tuple[bytes, bytes]:
        """The header of a message, and what follows it. Requires that keys are known. Raises CounterError and ForkError."""
        keys = self.keys
        if keys is not None and keys.seals:
            return keys.seal_forward(Kind.MESSAGE, self.life, sequence, self._counter.next(), payload, self.hello_port)
        return HEADER.pack(MAGIC, Form.PLAIN, Kind.MESSAGE, len(payload), self.life, sequence), payload

    def other(self, kind: Kind, payload: bytes = b"", is_from_hello_port: bool = False) -> bytes:
        """An end, a floor or a full. Raises CounterError and ForkError."""
        if Process.number != self._process:
            raise ForkError
        keys = self.keys
        if keys is None or not keys.seals:
            return write_frame(kind, self.life, self._sequence(), payload)
        port = 0 if is_from_hello_port else self.hello_port
        header, rest = keys.seal_forward(kind, self.life, self._sequence(), self._counter.next(), payload, port)
        return header + rest

    def take(self, frame: AnyFrame) -> Frame | None:
        """A frame of a consumer as this host takes it; None if it does not."""
        return None if self.keys is None else self.keys.take(frame, is_back=True)


class ConsumerFrames:
    """The frames of a subscriber."""

    def __init__(self, life: int) -> None:
        self.life = life
        self._counter = Counter(LAST_BACK)
        self._process = Process.number

    def write(self, keys: ChannelKeys, kind: Kind, payload: bytes) -> bytes:
        """A hello or an end to a publisher with these keys. Raises CounterError and ForkError."""
        if Process.number != self._process:
            raise ForkError
        if keys.seals:
            return keys.seal_back(kind, self.life, self._counter.next(), payload)
        return write_frame(kind, self.life, 0, payload)
