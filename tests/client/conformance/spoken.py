"""A process whose lines a check waits for: an agent, or a daemon."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import threading
import time
from collections.abc import Sequence
from pathlib import Path

#: Seconds after which a wait has failed.
PATIENCE_SECONDS = 60.0


class Failed(Exception):
    """A check does not hold."""


class Spoken:
    """Keeps every line of its standard output (with `with_errors` also of its standard error), and waits for lines from a position on."""

    def __init__(self, name: str, command: Sequence[str], environment: dict[str, str], with_errors: bool = False) -> None:
        self.name = name
        self.lines: list[str] = []
        self._changed = threading.Condition()
        self._is_over = False
        self.was_killed = False
        self._at = 0
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT if with_errors else None,
            env=environment,
            text=True,
            errors="replace",
            start_new_session=True,
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            with self._changed:
                self.lines.append(line.rstrip("\r\n"))
                self._changed.notify_all()
        with self._changed:
            self._is_over = True
            self._changed.notify_all()

    def tell(self, line: str) -> None:
        """Writes a line to the process."""
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(line + "\n")
            self._process.stdin.flush()
        except OSError as error:
            raise Failed(f"{self.name} has ended; it was told: {line[:100]}") from error

    def find(self, pattern: str, seconds: float = PATIENCE_SECONDS) -> re.Match[str]:
        """Waits for a line of this pattern among those that no find() has passed, and passes all lines up to it."""
        wanted = re.compile(pattern)
        end = time.monotonic() + seconds
        with self._changed:
            at = self._at
            while True:
                while at < len(self.lines):
                    found = wanted.fullmatch(self.lines[at])
                    at += 1
                    if found is not None:
                        self._at = at
                        return found
                if self._is_over or not self._changed.wait(max(0.0, end - time.monotonic())):
                    break
        why = "it ended" if self._is_over else f"not within {seconds:g} s"
        raise Failed(f"{self.name}: no line {pattern!r} ({why})")

    def last_lines(self, count: int = 16) -> str:
        """The last lines, indented."""
        with self._changed:
            return "".join(f"\n      {line[:200]}" for line in self.lines[-count:])

    def any(self, pattern: str, seconds: float = PATIENCE_SECONDS) -> re.Match[str]:
        """Waits for a line of this pattern among all lines. Passes none."""
        at, self._at = self._at, 0
        try:
            return self.find(pattern, seconds)
        finally:
            self._at = at

    def stands(self, pattern: str, wanted: str, seconds: float = PATIENCE_SECONDS) -> None:
        """Waits until the last line of a pattern is the wanted one. Passes none."""
        end = time.monotonic() + seconds
        with self._changed:
            while True:
                last = next((line for line in reversed(self.lines) if re.fullmatch(pattern, line)), "")
                if re.fullmatch(wanted, last):
                    return
                if self._is_over or not self._changed.wait(max(0.0, end - time.monotonic())):
                    raise Failed(f"{self.name}: the last line {pattern!r} is {last!r}, and no {wanted!r} came in {seconds:g} s")

    def all(self, pattern: str) -> list[re.Match[str]]:
        """All lines of this pattern so far."""
        with self._changed:
            found = [re.fullmatch(pattern, line) for line in self.lines]
        return [one for one in found if one is not None]

    def passed(self, pattern: str) -> list[re.Match[str]]:
        """All lines of this pattern that find() has passed."""
        with self._changed:
            found = [re.fullmatch(pattern, line) for line in self.lines[: self._at]]
        return [one for one in found if one is not None]

    def asked(self, line: str, pattern: str, seconds: float = PATIENCE_SECONDS) -> re.Match[str]:
        """Writes a line and finds the answer."""
        self.tell(line)
        return self.find(pattern, seconds)

    def kill(self) -> None:
        """Kills the process by SIGKILL, and waits for its end."""
        self.was_killed = True
        self._signal(signal.SIGKILL)
        self._process.wait()
        self._reader.join()

    def stand(self) -> None:
        """Stops the process until go_on()."""
        self._signal(signal.SIGSTOP)

    def go_on(self) -> None:
        """Continues the process after stand()."""
        self._signal(signal.SIGCONT)

    def reload(self) -> None:
        """Sends SIGHUP."""
        self._signal(signal.SIGHUP)

    def memory_kib(self) -> int:
        """The resident memory of the process and those that it started."""
        total = 0
        for folder in Path("/proc").iterdir():
            try:
                if os.getpgid(int(folder.name)) == self._process.pid:
                    text = (folder / "status").read_text()
                    total += sum(int(line.split()[1]) for line in text.splitlines() if line.startswith("VmRSS:"))
            except (ValueError, OSError):
                continue
        return total

    def end(self, word: str | None = None) -> int:
        """Ends the process by a word, or by SIGTERM. Returns its exit status. A process that does not end is killed, and has failed."""
        if word is None:
            self._signal(signal.SIGTERM)
        elif self._process.poll() is None:
            self.tell(word)
        try:
            status = self._process.wait(PATIENCE_SECONDS)
        except subprocess.TimeoutExpired:
            self.kill()
            raise Failed(f"{self.name} did not end") from None
        self._reader.join()
        return status

    def discard(self) -> None:
        """Kills the process if it still runs, and closes its pipes."""
        if self._process.poll() is None:
            self.kill()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                try:
                    pipe.close()
                except OSError:
                    pass

    def _signal(self, number: int) -> None:
        if self._process.poll() is None:
            try:
                # Wrappers of agents are in the same process group.
                os.killpg(self._process.pid, number)
            except ProcessLookupError:
                pass
