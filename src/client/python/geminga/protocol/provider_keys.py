"""The keys that the daemon has given for the providers of one subscriber."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Collection

from .channel_keys import ChannelKeys
from .limits import MAX_KEYS


class ProviderKeys:
    """Keys by life; None for those that cannot be used. Not thread-safe."""

    def __init__(self) -> None:
        self._by_life: OrderedDict[int, ChannelKeys | None] = OrderedDict()

    def get(self, life: int, default: ChannelKeys | None) -> ChannelKeys | None:
        """The keys of a life, or the default where the daemon has given none."""
        return self._by_life.get(life, default)

    def put(self, life: int, keys: ChannelKeys | None, kept: Collection[int]) -> None:
        """The daemon has given these keys. Of lives that are not to be kept, the first ones are forgotten beyond the limit."""
        self._by_life[life] = keys
        self._by_life.move_to_end(life)
        if len(self._by_life) > MAX_KEYS + len(kept):
            lives = {life, *kept}
            self._by_life.pop(next(one for one in self._by_life if one not in lives), None)

    def clear(self) -> None:
        """The daemon has no keys."""
        self._by_life.clear()
