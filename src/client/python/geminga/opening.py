"""The result of publish() and subscribe(), to be awaited, or to be entered by `async with`."""

from __future__ import annotations

from collections.abc import Coroutine, Generator
from types import TracebackType
from typing import Any, Generic, TypeVar

from .publisher import Publisher
from .subscriber import Subscriber

Channel = TypeVar("Channel", bound=Publisher | Subscriber)


class Opening(Generic[Channel]):
    """Opens a channel once: by `channel = await opening`, or by `async with opening as channel`, which closes it at the end."""

    def __init__(self, made: Coroutine[Any, Any, Channel]) -> None:
        self._made = made
        self._channel: Channel | None = None

    def __await__(self) -> Generator[Any, Any, Channel]:
        return self._made.__await__()

    async def __aenter__(self) -> Channel:
        self._channel = channel = await self._made
        return channel

    async def __aexit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        assert self._channel is not None
        await self._channel.close()
