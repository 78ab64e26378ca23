"""The listeners of a stream over UDP: those that said hello within the last seconds."""

from __future__ import annotations

from typing import Any

from .limits import LISTENER_SECONDS, MAX_LISTENERS


Address = tuple[Any, ...]


class Listeners:
    """Keeps at most 64 listeners. Addresses are as the socket writes them, times are seconds of a monotonic clock. Not thread-safe."""

    def __init__(self) -> None:
        self._heard: dict[Address, float] = {}

    @property
    def addresses(self) -> list[Address]:
        """The addresses of all listeners."""
        return list(self._heard)

    def hello(self, address: Address, now: float) -> bool:
        """Adds a listener, or renews it. False if there is no room for one more."""
        if address not in self._heard and len(self._heard) >= MAX_LISTENERS:
            return False
        self._heard[address] = now
        return True

    def end(self, address: Address) -> None:
        """A listener has ended."""
        self._heard.pop(address, None)

    def tick(self, now: float) -> None:
        """Forgets listeners that have been silent for 3 s."""
        self._heard = {address: heard for address, heard in self._heard.items() if now - heard < LISTENER_SECONDS}
