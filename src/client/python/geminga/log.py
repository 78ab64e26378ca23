"""The log hook: one line for each cause that a person should know of (src/client/CHANNELS.md, "The log hook")."""

from __future__ import annotations

import sys
from collections.abc import Callable

LogHook = Callable[[str], object]


def to_standard_error(line: str) -> None:
    """Writes a line where nobody has said another hook."""
    stream = sys.stderr
    if stream is not None:
        print(f"geminga: {line}", file=stream, flush=True)


class Log:
    """Calls the application's hook, or writes to standard error. An exception of the hook is given to `failed`."""

    def __init__(self, hook: LogHook | None, failed: Callable[[Exception], None]) -> None:
        self._hook = hook or to_standard_error
        self._failed = failed

    def say(self, line: str) -> None:
        """Writes a line."""
        try:
            self._hook(line)
        except Exception as error:  # An exception of the application; the channels go on.
            self._failed(error)
