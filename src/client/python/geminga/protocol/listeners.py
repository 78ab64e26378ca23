"""The listeners of a stream over UDP: those that said hello within the last seconds."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from .limits import LISTENER_SECONDS, MAX_LISTENERS
from .places import Places

Address = tuple[Any, ...]


@dataclass(eq=False, slots=True)
class Listener:
    """One listener. `counter` is that of its last sealed frame, or 0 if that was plain."""

    life: int
    challenge: int
    heard: float
    counter: int


class Listeners:
    """Keeps at most 1024 listeners. Addresses are as the socket writes them, times are seconds of a monotonic clock. Not thread-safe."""

    def __init__(self) -> None:
        self.places: Places[Address] = Places(MAX_LISTENERS)
        self._by_address: dict[Address, Listener] = {}

    @property
    def addresses(self) -> list[Address]:
        """The addresses of all listeners."""
        return list(self._by_address)

    def get(self, address: Address) -> Listener | None:
        """The listener at this address."""
        return self._by_address.get(address)

    def add(self, address: Address, listener: Listener) -> tuple[bool, tuple[Address, Listener] | None]:
        """Whether there is a place for one more, and who loses its own for it."""
        took, loser = self.places.take(address, str(address[0]))
        lost = None if loser is None else (loser, self._by_address.pop(loser))
        if took:
            self._by_address[address] = listener
        return took, lost

    def end(self, address: Address) -> None:
        """A listener has ended."""
        if self._by_address.pop(address, None) is not None:
            self.places.leave(address)

    def tick(self, now: float) -> None:
        """Forgets listeners that have been silent for 3 s."""
        for address in [one for one, listener in self._by_address.items() if now - listener.heard >= LISTENER_SECONDS]:
            self.end(address)