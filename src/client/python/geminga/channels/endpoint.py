"""Endpoints of daemons."""

from __future__ import annotations

import ipaddress
import os
import socket
from dataclasses import dataclass
from typing import Any

VARIABLE = "GEMINGA_CONNECT"


@dataclass(frozen=True, slots=True)
class Endpoint:
    """A family of sockets and an address of this family."""

    family: socket.AddressFamily
    address: Any

    def __str__(self) -> str:
        if self.family == socket.AF_UNIX:
            return str(self.address)
        host, port = self.address
        return f"[{host}]:{port}" if self.family == socket.AF_INET6 else f"{host}:{port}"


USUAL = (
    Endpoint(socket.AF_INET, ("127.0.0.1", 4717)),
    Endpoint(socket.AF_INET6, ("::1", 4717)),
)


def read_endpoint(text: str) -> Endpoint:
    """Reads `ADDRESS:PORT`, `[ADDRESS]:PORT`, `/PATH` or `unix:PATH` with a numeric address. Raises ValueError."""
    if text.startswith(("unix:", "/")):
        path = text.removeprefix("unix:")
        if not path or "\0" in path:
            raise ValueError(f"{text!r} is no path of a socket")
        return Endpoint(socket.AF_UNIX, path)
    address, _, port = text.rpartition(":")
    has_brackets = address.startswith("[") and address.endswith("]")
    try:
        if not port.isascii() or not port.isdigit() or not 0 < int(port) < 65536:
            raise ValueError
        ip = ipaddress.ip_address(address[1:-1] if has_brackets else address)
        if has_brackets != (ip.version == 6):
            raise ValueError
    except ValueError:
        raise ValueError(f"{text!r} is no address of a daemon: write ADDRESS:PORT, [ADDRESS]:PORT or a path") from None
    return Endpoint(socket.AF_INET6 if ip.version == 6 else socket.AF_INET, (str(ip), int(port)))


def endpoints(text: str | None) -> tuple[Endpoint, ...]:
    """The endpoint of the text, or of $GEMINGA_CONNECT, or the usual ones. Raises ValueError."""
    text = text or os.environ.get(VARIABLE)
    return (read_endpoint(text),) if text else USUAL
