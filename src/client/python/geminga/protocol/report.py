"""Reports of a session about the lines of the daemon."""

from __future__ import annotations

from dataclasses import dataclass

from .channel_keys import ChannelKeys
from .request import Request
from .statement import ErrorLine, Statement


@dataclass(frozen=True, slots=True)
class Welcome:
    """The daemon answered hello."""

    participant: str
    participant_name: str
    sealing: str = "plain"  #: the mode of this host; plain if the daemon has no keys for channels


@dataclass(eq=False, slots=True)
class Asked:
    """A statement whose answer is awaited. One Settled follows."""

    request: Request
    before: dict[str, str] | None  #: the parameters before a modify; None of a create


@dataclass(frozen=True, slots=True)
class Settled:
    """The daemon has accepted a statement, or refused it."""

    asked: Asked
    error: ErrorLine | None


@dataclass(frozen=True, slots=True)
class Told:
    """An `add`, `modify` or `del` for a request."""

    request: Request
    line: Statement


@dataclass(frozen=True, slots=True)
class Keyed:
    """The keys of a life, for a request. Without keys `text` says why the channel cannot be opened."""

    request: Request
    life: int
    keys: ChannelKeys | None
    text: str = ""


@dataclass(frozen=True, slots=True)
class Sealing:
    """The daemon has other keys, or another mode."""

    mode: str


@dataclass(frozen=True, slots=True)
class Complaint:
    """An error that answers no statement. `is_gone`: the daemon no longer has the request."""

    request: Request | None
    error: ErrorLine
    is_gone: bool


Report = Welcome | Settled | Told | Keyed | Sealing | Complaint
