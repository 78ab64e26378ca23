#!/usr/bin/python3
"""A stranger. `forge.py udp SOURCE-PORT ADDRESS PORT HEX` sends a datagram from that port, which another socket may have.
`forge.py tcp ADDRESS PORT HEX` connects, sends, and prints how many octets came until the connection was closed.
`forge.py flood ADDRESS PORT COUNT HEX` opens so many connections, sends on each, reads nothing, and holds them until its standard
input ends; 16 octets of the text that are `LIFE` are another life on each connection.
`forge.py hellos ADDRESS PORT COUNT HEX` sends so many datagrams, each from a port of its own and with another life, and prints how
many octets came back within a second."""

from __future__ import annotations

import resource
import selectors
import socket
import struct
import sys
import time


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


def _with_life(text: str, number: int) -> bytes:
    return bytes.fromhex(text.replace("LIFE", f"{0x5742A17E00000000 + number:016x}"))


def flood(address: str, port: int, count: int, text: str) -> None:
    """Opens connections and holds them. Those that the other side refuses are not opened again."""
    opened = []
    for number in range(count):
        try:
            opened.append(socket.create_connection((address, port), timeout=5))
            opened[-1].sendall(_with_life(text, number + 1))
        except OSError:
            continue
    print(f"opened {len(opened)}", flush=True)
    sys.stdin.read()


def hellos(address: str, port: int, count: int, text: str) -> None:
    """Sends datagrams from many ports, and counts what comes back."""
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (min(most, count + 64), most))
    sockets = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(count)]
    selector = selectors.DefaultSelector()
    for number, sock in enumerate(sockets):
        sock.sendto(_with_life(text, number + 1), (address, port))
        selector.register(sock, selectors.EVENT_READ, sock)
    end = time.monotonic() + 1
    octets = 0
    while (patience := end - time.monotonic()) > 0:
        octets += sum(len(key.data.recv(65536)) for key, _ in selector.select(patience))
    print(f"received {octets}", flush=True)


if __name__ == "__main__":
    if sys.argv[1] in ("flood", "hellos"):
        {"flood": flood, "hellos": hellos}[sys.argv[1]](sys.argv[2], int(sys.argv[3]), int(sys.argv[4]), sys.argv[5])
    elif sys.argv[1] == "tcp":
        connect(sys.argv[2], int(sys.argv[3]), bytes.fromhex(sys.argv[4]))
    elif int(sys.argv[2]) == 0:
        send_datagram(sys.argv[3], int(sys.argv[4]), bytes.fromhex(sys.argv[5]))
    else:
        forge_datagram(int(sys.argv[2]), sys.argv[3], int(sys.argv[4]), bytes.fromhex(sys.argv[5]))
