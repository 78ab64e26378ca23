"""Sockets of multicast groups."""

from __future__ import annotations

import contextlib
import ipaddress
import socket
import struct

from .sockets import RECEIVE_BUFFER_OCTETS, Address

TIME_TO_LIVE = 1
_IP_MULTICAST_ALL = 49


def _family(group: str) -> socket.AddressFamily:
    return socket.AF_INET6 if ipaddress.ip_address(group).version == 6 else socket.AF_INET


def _reusable(family: socket.AddressFamily) -> socket.socket:
    sock = socket.socket(family, socket.SOCK_DGRAM)
    sock.setblocking(False)
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    return sock


def sending(group: str, port: int, interface: int) -> socket.socket:
    """A socket that sends through this interface, from this port, one hop far; the own host hears it, too."""
    family = _family(group)
    sock = _reusable(family)
    try:
        if family == socket.AF_INET6:
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_IF, interface)
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_MULTICAST_HOPS, TIME_TO_LIVE)
            sock.bind(("::", port))
        else:
            sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, struct.pack("4s4si", b"", b"", interface))
            sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_TTL, TIME_TO_LIVE)
            sock.setsockopt(socket.IPPROTO_IP, _IP_MULTICAST_ALL, 0)  # it hears nothing
            sock.bind(("0.0.0.0", port))
        return sock
    except OSError:
        sock.close()
        raise


def listening(group: str, port: int) -> socket.socket:
    """A socket that hears what is sent to this group and port, on the interfaces that join() names."""
    family = _family(group)
    sock = _reusable(family)
    try:
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER_OCTETS)
        # Bound to the group, it hears nothing that is sent to the port alone.
        sock.bind((group.partition("%")[0], port) if family == socket.AF_INET else (group.partition("%")[0], port, 0, _scope(group)))
        return sock
    except OSError:
        sock.close()
        raise


def _scope(group: str) -> int:
    """Zone of a group; where a link-local one has none, the first interface."""
    zone = group.partition("%")[2]
    if zone:
        return int(zone) if zone.isdigit() else socket.if_nametoindex(zone)
    return 0


def join(sock: socket.socket, group: str, interface: int) -> None:
    """Joins the group on this interface, if it has not done so."""
    address = ipaddress.ip_address(group.partition("%")[0]).packed
    with contextlib.suppress(OSError):
        if sock.family == socket.AF_INET6:
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_JOIN_GROUP, address + struct.pack("i", interface))
        else:
            request = address + bytes(4) + struct.pack("i", interface)
            sock.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, request)


def group_address(group: str, port: int, interface: int) -> Address:
    """The group as sendto() wants it."""
    bare = group.partition("%")[0]
    return (bare, port) if _family(group) == socket.AF_INET else (bare, port, 0, interface)
