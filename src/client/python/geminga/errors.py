"""Exceptions of this library, beside ValueError and OSError."""

from __future__ import annotations


class GemingaError(Exception):
    """The base of all errors of this library."""


class Refused(GemingaError):
    """The daemon refused a request. `code` is one of src/discovery/gcnp/GCNP.md, "Errors"."""

    def __init__(self, code: int, text: str) -> None:
        super().__init__(f"{code} {text}")
        self.code = code
        self.text = text


class MessageTooLarge(GemingaError):
    """A message is longer than its channel carries."""


class PortTaken(GemingaError):
    """Another socket has a port that was stated."""


class Closed(GemingaError):
    """The node, publisher or subscriber has been closed."""
