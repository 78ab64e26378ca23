"""Who listens to a publisher of `otm/stream` over UDP: those that said hello lately."""

from __future__ import annotations

from typing import Any

from .limits import LISTENER_SECONDS, MAX_LISTENERS


Address = tuple[Any, ...]


class Listeners:
    """Addresses as the socket writes them. Time is seconds of a monotonic clock. Not thread-safe."""

    def __init__(self) -> None:
        self._heard: dict[Address, float] = {}

    @property
    def addresses(self) -> list[Address]:
        """All that are heard."""
        return list(self._heard)

    def hello(self, address: Address, now: float) -> bool:
        """Whether who says hello is heard: one more than 64 is not."""
        if address not in self._heard and len(self._heard) >= MAX_LISTENERS:
            return False
        self._heard[address] = now
        return True

    def end(self, address: Address) -> None:
        """It takes its leave."""
        self._heard.pop(address, None)

    def tick(self, now: float) -> None:
        """Forgets who has been silent for 3 s."""
        self._heard = {address: heard for address, heard in self._heard.items() if now - heard < LISTENER_SECONDS}
