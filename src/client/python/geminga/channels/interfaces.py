"""The interfaces that multicasts use: all that are up and no loopback, or the loopback if there is no other."""

from __future__ import annotations

import fcntl
import socket
import struct

_GET_FLAGS = 0x8913
_IS_UP, _IS_LOOPBACK = 0x1, 0x8


def _flags(sock: socket.socket, name: str) -> int:
    try:
        answer = fcntl.ioctl(sock.fileno(), _GET_FLAGS, struct.pack("16sH14x", name.encode(), 0))
    except OSError:
        return 0
    return int(struct.unpack("16sH14x", answer)[1])


def interfaces() -> list[int]:
    """The indices of these interfaces."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        flags = {index: _flags(sock, name) for index, name in socket.if_nameindex()}
    up = [index for index, flag in flags.items() if flag & _IS_UP]
    return [index for index in up if not flags[index] & _IS_LOOPBACK] or up
