"""Sockets of channels, and addresses as these sockets write them."""

from __future__ import annotations

import contextlib
import errno
import ipaddress
import socket
from typing import Any

from ..errors import PortTaken

Address = tuple[Any, ...]

RECEIVE_BUFFER_OCTETS = 4 * 1024 * 1024  # the system gives less where its limit is less
_ANY_PORT_ATTEMPTS = 16


def is_multicast(address: str) -> bool:
    """Whether this text is a multicast address."""
    try:
        return ipaddress.ip_address(address).is_multicast
    except ValueError:
        return False


def _families(address: str) -> list[tuple[socket.AddressFamily, str]]:
    if address:
        return [(socket.AF_INET6 if ":" in address else socket.AF_INET, address), (socket.AF_INET6, "::"), (socket.AF_INET, "0.0.0.0")]
    return [(socket.AF_INET6, "::"), (socket.AF_INET, "0.0.0.0")]


def bound(kind: socket.SocketKind, port: int, address: str = "") -> socket.socket:
    """Opens a socket that does not block, bound to the port (0: any) of this address if it is the host's own, or else of all addresses.

    Raises PortTaken if another socket has the port.
    """
    failure: OSError | None = None
    for family, host in _families(address):
        sock: socket.socket | None = None
        try:
            sock = socket.socket(family, kind)
            if family == socket.AF_INET6:
                sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 0)
            if kind == socket.SOCK_STREAM:
                sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            else:
                sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER_OCTETS)
            sock.bind(_scoped(host, port) if family == socket.AF_INET6 else (host, port))
            sock.setblocking(False)
            return sock
        except OSError as error:
            if sock is not None:
                sock.close()
            if error.errno == errno.EADDRINUSE:
                raise PortTaken(f"port {port} is taken: say another one, or none for any") from error
            failure = error
    assert failure is not None
    raise failure


def listening(port: int, address: str = "") -> socket.socket:
    """Opens a TCP socket that listens at this port (0: any)."""
    for attempt in range(_ANY_PORT_ATTEMPTS):
        sock = bound(socket.SOCK_STREAM, port, address)
        try:
            sock.listen(64)
            return sock
        except OSError as error:
            # With SO_REUSEADDR two sockets may be bound to a port, and only one may listen there.
            sock.close()
            if error.errno != errno.EADDRINUSE:
                raise
            if port or attempt + 1 == _ANY_PORT_ATTEMPTS:
                raise PortTaken(f"port {port} is taken: say another one, or none for any") from error
    raise AssertionError("unreachable")


def port_of(sock: socket.socket) -> int:
    """The port to which a socket is bound."""
    return int(sock.getsockname()[1])


def _scoped(host: str, port: int) -> Address:
    host, _, zone = host.partition("%")
    index = 0
    if zone:
        index = int(zone) if zone.isdigit() else socket.if_nametoindex(zone)
    return (host, port, 0, index)


def target(family: int, address: str, port: int) -> Address | None:
    """The address as a socket of this family writes it, or None if it cannot reach it."""
    try:
        ip = ipaddress.ip_address(address)
        if family == socket.AF_INET6:
            if ip.version == 4:
                return (f"::ffff:{ip}", port, 0, 0)
            bare = str(ip).partition("%")[0]
            return (bare, *_scoped(address, port)[1:])
        return (str(ip), port) if ip.version == 4 else None
    except (ValueError, OSError):
        return None


def connectable(address: str, port: int) -> tuple[socket.AddressFamily, Address] | None:
    """The family and the address for connect(), or None if the text is no address."""
    try:
        version = ipaddress.ip_address(address).version
    except ValueError:
        return None
    family = socket.AF_INET6 if version == 6 else socket.AF_INET
    there = target(family, address, port)
    return None if there is None else (family, there)


def canonical(source: Address) -> Address:
    """The source of a datagram as target() writes it."""
    if len(source) == 2:
        return source
    host, port, _, scope = source
    return (str(host).partition("%")[0], port, 0, scope)


def written(source: Address) -> str:
    """The address of a datagram's source, with the zone of a link-local one. A multicast without a route comes from no address: from here."""
    host = {"0.0.0.0": "127.0.0.1", "::": "::1"}.get(str(source[0]), str(source[0]))
    is_of_a_link = len(source) == 4 and source[3] and "%" not in host
    return f"{host}%{source[3]}" if is_of_a_link else host


def send_datagram(sock: socket.socket, octets: bytes, there: Address) -> bool:
    """Sends one datagram. Whether the system took it; if not, it is lost."""
    try:
        sock.sendto(octets, there)
        return True
    except OSError:
        return False


def send_frame(sock: socket.socket, header: bytes, payload: bytes, there: Address) -> bool:
    """Sends a header and a payload as one datagram, without copying them. Whether the system took it."""
    try:
        sock.sendmsg((header, payload), (), 0, there)
        return True
    except OSError:
        return False


def close(sock: socket.socket | None) -> None:
    """Closes a socket, if there is one."""
    if sock is not None:
        with contextlib.suppress(OSError):
            sock.close()
