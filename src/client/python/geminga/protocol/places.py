"""Places that are limited, and shared by address where all are taken (src/client/CHANNELS.md, "Places")."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from typing import Generic, TypeVar

Holder = TypeVar("Holder", bound=Hashable)


class Places(Generic[Holder]):
    """So many places. An address is a text without the port. Not thread-safe."""

    def __init__(self, count: int) -> None:
        self.count = count
        self._held: dict[Holder, str] = {}  # in the order in which places were taken
        self._by_address: dict[str, dict[Holder, int]] = {}  # with the number of each place
        self._served: set[Holder] = set()
        self._last = 0

    def __len__(self) -> int:
        return len(self._held)

    def __iter__(self) -> Iterator[Holder]:
        return iter(list(self._held))

    def __contains__(self, holder: object) -> bool:
        return holder in self._held

    @property
    def is_full(self) -> bool:
        """Whether all places are taken."""
        return len(self._held) >= self.count

    @property
    def has_room_again(self) -> bool:
        """Whether three quarters of the places are taken at most."""
        return 4 * len(self._held) <= 3 * self.count

    def take(self, holder: Holder, address: str) -> tuple[bool, Holder | None]:
        """Whether a newcomer gets a place, and who loses its own for it."""
        loser: Holder | None = None
        if self.is_full:
            loser = self._loser(address)
            if loser is None:
                return False, None
            self.leave(loser)
        self._last += 1
        self._held[holder] = address
        self._by_address.setdefault(address, {})[holder] = self._last
        return True, loser

    def leave(self, holder: Holder) -> None:
        """Gives a place back, if it was held."""
        address = self._held.pop(holder, None)
        if address is None:
            return
        self._served.discard(holder)
        of_address = self._by_address[address]
        del of_address[holder]
        if not of_address:
            del self._by_address[address]

    def serve(self, holder: Holder) -> None:
        """A provider has delivered a message."""
        if holder in self._held:
            self._served.add(holder)

    def _loser(self, address: str) -> Holder | None:
        """The newest place of the address that holds most of them, if that holds two more than the newcomer's; one not served first."""
        most = max(len(of) for of in self._by_address.values())
        if len(self._by_address.get(address, ())) + 2 > most:
            return None
        of_address = max((of for of in self._by_address.values() if len(of) == most), key=lambda of: max(of.values()))
        return max(of_address, key=lambda holder: (holder not in self._served, of_address[holder]))
