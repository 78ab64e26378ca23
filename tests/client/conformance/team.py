"""The keys of a team, and the configuration of its daemons, which SIGHUP reads again."""

from __future__ import annotations

import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

PLAIN = "plain"


class Team:
    """Two keys in files, and a configuration file for each host."""

    def __init__(self, gemingad: str) -> None:
        self._folder = tempfile.TemporaryDirectory(prefix="geminga-team-")
        self.keys = [Path(self._folder.name) / f"{name}.key" for name in ("first", "second")]
        for key in self.keys:
            subprocess.run([gemingad, "--generate-key", str(key)], check=True, capture_output=True)

    def configuration(self, host: int) -> Path:
        """The configuration file of a host."""
        return Path(self._folder.name) / f"host{host}.toml"

    def write(self, host: int, mode: str, keys: Sequence[int] = (0,)) -> None:
        """Writes the configuration of a host: a mode of sealing, and the numbers of its keys, the one that seals first."""
        text = ""
        if mode != PLAIN:
            text = f'sealing = "{mode}"\n'
            names = ", ".join(f'"{self.keys[number]}"' for number in keys)
            text += f"key-file = [{names}]\n"
        self.configuration(host).write_text(text, encoding="utf-8")

    def close(self) -> None:
        """Removes all files."""
        self._folder.cleanup()
