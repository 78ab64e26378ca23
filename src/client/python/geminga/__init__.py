"""Geminga: service discovery for teams of mobile robots, with channels. This is the asyncio front; geminga.blocking is the blocking one.

    async with geminga.connect("vision") as node:
        async with node.publish(concept="soccer:BallInfo", mode="otm/pubsub") as ball:
            ball.send(b"...")
"""

from __future__ import annotations

from .errors import Closed, GemingaError, MessageTooLarge, PortTaken, Refused
from .happening import Connected, ConsumerChanged, Disconnected, Happening, Problem, ProviderChanged
from .log import LogHook
from .node import Node, OnEvent
from .protocol.identity import identity
from .protocol.inbox import Message
from .protocol.match import Match
from .publisher import Publisher
from .subscriber import Subscriber

__version__ = "1.0.0"

__all__ = [
    "Closed",
    "Connected",
    "ConsumerChanged",
    "Disconnected",
    "GemingaError",
    "Happening",
    "LogHook",
    "Match",
    "Message",
    "MessageTooLarge",
    "Node",
    "OnEvent",
    "PortTaken",
    "Problem",
    "ProviderChanged",
    "Publisher",
    "Refused",
    "Subscriber",
    "connect",
    "identity",
]


def connect(
    name: str | None = None,
    connect: str | None = None,
    on_event: OnEvent | None = None,
    room: int = 0,
    log: LogHook | None = None,
) -> Node:
    """A node with this name, to be entered by `async with`.

    `connect` is the daemon: ADDRESS:PORT, [ADDRESS]:PORT, /PATH or unix:PATH; else $GEMINGA_CONNECT or the usual port. `on_event` is called
    in the event loop with each event. `room` is for programs that need more than 256 subscriptions of `otm/stream`: how many more; if the
    daemon has no room, that is a Problem. `log` is called with each line that a person should read, as that no daemon answers; unless told,
    lines go to standard error. Raises ValueError for an address that cannot be read; a missing daemon is no error.
    """
    return Node(name, connect, on_event, room, log)
