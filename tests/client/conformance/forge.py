#!/usr/bin/python3
"""A stranger. `forge.py udp SOURCE-PORT ADDRESS PORT HEX` sends a datagram from that port, which another socket may have.
`forge.py tcp ADDRESS PORT HEX` connects, sends, and prints how many octets came until the connection was closed."""

from __future__ import annotations

import socket
import struct
import sys


def forge_datagram(source_port: int, address: str, port: int, octets: bytes) -> None:
    """Sends by a raw socket, which only root may have; otherwise the exit status is 77."""
    try:
        sock = socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_UDP)
    except PermissionError:
        sys.exit(77)
    with sock:
        # A checksum of 0 means that there is none.
        sock.sendto(struct.pack("!HHHH", source_port, port, 8 + len(octets), 0) + octets, (address, 0))


def send_datagram(address: str, port: int, octets: bytes) -> None:
    """Sends from any port."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.sendto(octets, (address, port))


def connect(address: str, port: int, octets: bytes) -> None:
    """Connects, sends, and waits until the other side closes."""
    count = 0
    with socket.create_connection((address, port), timeout=30) as sock:
        sock.sendall(octets)
        try:
            while piece := sock.recv(65536):
                count += len(piece)
        except ConnectionResetError:
            pass
    print(f"closed {count}", flush=True)


if __name__ == "__main__":
    if sys.argv[1] == "tcp":
        connect(sys.argv[2], int(sys.argv[3]), bytes.fromhex(sys.argv[4]))
    elif int(sys.argv[2]) == 0:
        send_datagram(sys.argv[3], int(sys.argv[4]), bytes.fromhex(sys.argv[5]))
    else:
        forge_datagram(int(sys.argv[2]), sys.argv[3], int(sys.argv[4]), bytes.fromhex(sys.argv[5]))
