"""A publication or subscription as this library states it to every daemon."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import Enum

from .statement import Statement


class State(Enum):
    """The state of a request at the daemon."""

    WAITING = "not stated yet, or again to be stated"
    STATED = "stated; no answer yet"
    TAKEN = "the daemon has it"
    REFUSED = "refused or taken back; it is not stated again"
    REMOVED = "withdrawn"


@dataclass(eq=False, slots=True)
class Request:
    """One request. `command` is `pub` or `sub`; `parameters` are those that hold now, as `create` states them."""

    number: int
    command: str
    parameters: dict[str, str] = field(default_factory=dict)
    state: State = State.WAITING

    def create(self) -> Statement:
        """The statement that makes it."""
        return Statement(self.number, self.command, "create", dict(self.parameters))

    def modify(self, changes: dict[str, str]) -> Statement:
        """The statement that changes it."""
        return Statement(self.number, self.command, "modify", dict(changes))

    def remove(self) -> Statement:
        """The statement that withdraws it."""
        return Statement(self.number, self.command, "remove")

    @property
    def is_wanted(self) -> bool:
        """Whether it is to be stated to a daemon."""
        return self.state not in (State.REFUSED, State.REMOVED)


IDENTITY_KEYS = ("id", "text", "concept", "representation")


def changed(parameters: dict[str, str], changes: dict[str, str]) -> dict[str, str]:
    """The parameters of `create` after `modify` with these changes. An empty value takes a key back."""
    after = dict(parameters)
    if any(key in changes for key in ("id", "text")):
        for key in IDENTITY_KEYS:
            after.pop(key, None)
    elif "concept" in changes:
        after.pop("id", None)
        after.pop("text", None)
    for key, value in changes.items():
        if value == "" and not key.startswith("attr."):
            after.pop(key, None)
        else:
            after[key] = value
    return after
