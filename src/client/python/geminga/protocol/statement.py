"""One line of GCNP (src/discovery/gcnp/GCNP.md): read strictly, written as the daemon writes it."""

from __future__ import annotations

import re
from dataclasses import dataclass, field

MAX_LINE_OCTETS = 65536
MAX_PARAMETERS = 256
MAX_ID = 0xFFFFFFFF

_KEY = re.compile(r"[A-Za-z0-9_.\-]+")
_BARE = re.compile(r'[^ "\x00-\x1f\x7f]*')
_QUOTED = re.compile(r'"((?:[^"\\\x00-\x1f\x7f]|\\["\\nrt])*)"')
_NEEDS_QUOTES = re.compile(r'[ "\n\r\t]')
_ERROR = re.compile(r"([0-9]+) ([0-9]{3})(?: (.*))?", re.DOTALL)
_CONTROL = re.compile(r"[\x00-\x1f\x7f]")
_UNESCAPED = {"\\n": "\n", "\\r": "\r", "\\t": "\t", '\\"': '"', "\\\\": "\\"}
_ESCAPED = {after: before for before, after in _UNESCAPED.items()}


class LineError(ValueError):
    """A line that is not GCNP, or a value that GCNP cannot carry."""


@dataclass(frozen=True, slots=True)
class Statement:
    """The line `id command subcommand key=value ...`. A key without a value has None."""

    id: int
    command: str
    subcommand: str
    parameters: dict[str, str | None] = field(default_factory=dict)

    def __repr__(self) -> str:
        shown = {key: "..." if key == "ring" else value for key, value in self.parameters.items()}  # keys of channels are shown nowhere
        return f"Statement({self.id}, {self.command!r}, {self.subcommand!r}, {shown})"

    def get(self, key: str, default: str = "") -> str:
        """The value of a key, or the default if the key or its value is missing."""
        value = self.parameters.get(key)
        return default if value is None else value


@dataclass(frozen=True, slots=True)
class ErrorLine:
    """The line `id code text`: an error of the daemon."""

    id: int
    code: int
    text: str


def _number(word: str) -> int:
    digits = word.lstrip("0")
    if not word.isascii() or not word.isdigit() or len(digits) > 10 or int(digits or "0") > MAX_ID:
        raise LineError("a statement begins with a number of 0 to 4294967295")
    return int(digits or "0")


def read_parameters(text: str) -> dict[str, str | None]:
    """Reads `key=value key=value ...` with spaces between them, before and behind. Raises LineError."""
    parameters: dict[str, str | None] = {}
    at, length = 0, len(text)
    while at < length:
        if text[at] == " ":
            at += 1
            continue
        key = _KEY.match(text, at)
        if key is None:
            raise LineError(f"octet {at + 1}: here a key is expected")
        if key[0] in parameters:
            raise LineError(f"{key[0]} stands twice")
        at, value = key.end(), None
        if at < length and text[at] == "=":
            quoted = _QUOTED.match(text, at + 1)
            if quoted is not None:
                at = quoted.end()
                value = re.sub(r"\\.", lambda escape: _UNESCAPED[escape[0]], quoted[1])
            else:
                bare = _BARE.match(text, at + 1)
                assert bare is not None  # the pattern matches an empty text, too
                at, value = bare.end(), bare[0]
        if at < length and text[at] != " ":
            raise LineError(f"octet {at + 1}: behind a value a space is expected")
        parameters[key[0]] = value
        if len(parameters) > MAX_PARAMETERS:
            raise LineError(f"a line has at most {MAX_PARAMETERS} parameters")
    return parameters


def read_line(line: bytes) -> Statement | ErrorLine:
    """Reads a line without its end. Raises LineError if it is not GCNP, or longer than 65536 octets."""
    if len(line) > MAX_LINE_OCTETS:
        raise LineError(f"a line has at most {MAX_LINE_OCTETS} octets")
    try:
        text = line.decode()
    except UnicodeDecodeError as error:
        raise LineError("a line is UTF-8") from error
    failed = _ERROR.fullmatch(text)
    if failed is not None:
        return ErrorLine(_number(failed[1]), int(failed[2]), _CONTROL.sub("?", failed[3] or ""))
    words = re.fullmatch(r"([^ ]+) +([^ ]+) +([^ ]+)(?: (.*))?", text, re.DOTALL)
    if words is None:
        raise LineError("a statement is a number, a command and a subcommand")
    if not _KEY.fullmatch(words[2]) or not _KEY.fullmatch(words[3]):
        raise LineError("a command is letters, digits, '_', '.' and '-'")
    return Statement(_number(words[1]), words[2], words[3], read_parameters(words[4] or ""))


def _written(value: str) -> str:
    if value and not _NEEDS_QUOTES.search(value):
        return value
    return '"' + "".join(_ESCAPED.get(one, one) for one in value) + '"'


def write_line(line: Statement | ErrorLine) -> bytes:
    """The line with CR LF. Raises LineError for a line that cannot be read again: control characters, or too long."""
    if isinstance(line, ErrorLine):
        written = f"{line.id} {line.code:03} {line.text}"
    else:
        words = [str(line.id), line.command, line.subcommand]
        words += [key if value is None else f"{key}={_written(value)}" for key, value in line.parameters.items()]
        written = " ".join(words)
    octets = written.encode(errors="strict")
    if read_line(octets) != line:
        raise LineError("this cannot be said in GCNP")
    return octets + b"\r\n"
