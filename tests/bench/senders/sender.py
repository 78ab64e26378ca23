"""See ../clients. With the argument `blocking` the blocking front is measured."""

from __future__ import annotations

import asyncio
import socket
import sys
import time
from collections.abc import Callable

import geminga
import geminga.blocking

WAY, MODE, PROTOCOL, IDENTITY, PORT = *sys.argv[1:5], int(sys.argv[5])


def plain_socket() -> tuple[socket.socket, Callable[[bytes], object]]:
    there = ("127.0.0.1", PORT)
    if PROTOCOL == "tcp":
        sock = socket.create_connection(there)
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        return sock, sock.send
    sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    return sock, lambda payload: None


def timed(count: int, send: Callable[[bytes], object], payload: bytes) -> int:
    begin = time.perf_counter_ns()
    for _ in range(count):
        send(payload)
    return time.perf_counter_ns() - begin


def timed_to(count: int, sendto: Callable[..., object], payload: bytes) -> int:
    there = ("127.0.0.1", PORT)
    begin = time.perf_counter_ns()
    for _ in range(count):
        sendto(payload, there)
    return time.perf_counter_ns() - begin


class Orders:
    """Carries out the commands of the driver."""

    def __init__(self, send: Callable[[bytes], object]) -> None:
        self._library = send
        self._sock, self._plain = plain_socket()

    def follow(self, line: str) -> bool:
        """False if the driver has closed its end."""
        words = line.split()
        if not words or words[0] == "quit":
            return False
        count, payload = int(words[1]), b"x" * int(words[2])
        if words[0] == "library":
            took = timed(count, self._library, payload)
        elif PROTOCOL == "udp":
            took = timed_to(count, self._sock.sendto, payload)
        else:
            took = timed(count, self._plain, payload)
        print(took, flush=True)
        return True


async def with_asyncio() -> None:
    loop = asyncio.get_running_loop()
    async with geminga.connect("sender") as node:
        async with node.publish(text=IDENTITY, mode=MODE, protocol=PROTOCOL) as publisher:
            orders = Orders(publisher.send)
            while not publisher.has_consumers:
                await asyncio.sleep(0.01)
            print("ready", flush=True)
            while orders.follow(await loop.run_in_executor(None, sys.stdin.readline)):
                pass


def with_blocking() -> None:
    with geminga.blocking.connect("sender") as node:
        with node.publish(text=IDENTITY, mode=MODE, protocol=PROTOCOL) as publisher:
            orders = Orders(publisher.send)
            while not publisher.has_consumers:
                node.wait(0.01)
            print("ready", flush=True)
            while orders.follow(sys.stdin.readline()):
                pass


if WAY == "blocking":
    with_blocking()
else:
    asyncio.run(with_asyncio())
