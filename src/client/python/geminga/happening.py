"""Events that the application is told."""

from __future__ import annotations

from dataclasses import dataclass

from .protocol.match import Match
from .publisher import Publisher
from .subscriber import Subscriber


@dataclass(frozen=True, slots=True)
class Connected:
    """The daemon was reached."""

    participant: str
    participant_name: str


@dataclass(frozen=True, slots=True)
class Disconnected:
    """The daemon is gone. Channels go on, and the node connects again."""


@dataclass(frozen=True, slots=True)
class ProviderChanged:
    """A provider of a subscriber has changed. `change` is `added`, `modified` or `removed`; the last has a reason."""

    subscriber: Subscriber
    change: str
    provider: Match
    reason: str = ""


@dataclass(frozen=True, slots=True)
class ConsumerChanged:
    """A consumer of a publisher has changed, but for `otm/stream`. `change` is `added`, `modified` or `removed`; the last has a reason."""

    publisher: Publisher
    change: str
    consumer: Match
    reason: str = ""


@dataclass(frozen=True, slots=True)
class Problem:
    """Something that a person should know: a request that was taken back, a conversion without a function, a provider without a channel."""

    source: Publisher | Subscriber | None
    text: str


Happening = Connected | Disconnected | ProviderChanged | ConsumerChanged | Problem
