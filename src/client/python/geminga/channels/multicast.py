"""Sockets of multicast groups."""

from __future__ import annotations

import contextlib
import ipaddress
import socket
import struct

from .sockets import RECEIVE_BUFFER_OCTETS, Address

TIME_TO_LIVE = 1
_IP_MULTICAST_ALL = 49
_IPV6_MULTICAST_ALL = 29


def _family(group: str) -> socket.AddressFamily:
    return socket.AF_INET6 if ipaddress.ip_address(group).version == 6 else socket.AF_INET


def _reusable(family: socket.AddressFamily) -> socket.socket:
    sock = socket.socket(family, socket.SOCK_DGRAM)
    sock.setblocking(False)
    sock.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    return sock


def sending(group: str, port: int, interface: int) -> socket.socket:
    """Opens a socket that sends through this interface, from this port, one hop far. The own host hears it, too."""
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
            sock.setsockopt(socket.IPPROTO_IP, _IP_MULTICAST_ALL, 0)  # it receives no groups
            sock.bind(("0.0.0.0", port))
        return sock
    except OSError:
        sock.close()
        raise


def listening(group: str, port: int) -> socket.socket:
    """Opens a socket that receives this group and port, on the interfaces that join() names."""
    family = _family(group)
    sock = _reusable(family)
    try:
        sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, RECEIVE_BUFFER_OCTETS)
        # Bound to the group, it does not receive datagrams to the port alone.
        if family == socket.AF_INET:
            sock.setsockopt(socket.IPPROTO_IP, _IP_MULTICAST_ALL, 0)
            sock.bind((group, port))
        else:
            bare, zone = group.partition("%")[0], _zone(group)
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_V6ONLY, 1)
            sock.setsockopt(socket.IPPROTO_IPV6, _IPV6_MULTICAST_ALL, 0)
            # A link-local group on every interface has no single address to bind to. The sender is checked later anyway.
            sock.bind(("::" if _is_of_a_link(bare) and zone == 0 else bare, port, 0, zone))
        return sock
    except OSError:
        sock.close()
        raise


def _is_of_a_link(group: str) -> bool:
    """Whether an IPv6 group is one of a link or of an interface, so that it is a different group on each."""
    return ipaddress.ip_address(group).packed[1] & 0x0F in (1, 2)


def _zone(group: str) -> int:
    """The interface that a group names, or 0. Raises OSError if there is no such interface."""
    zone = group.partition("%")[2]
    return (int(zone) if zone.isdigit() else socket.if_nametoindex(zone)) if zone else 0


def join(sock: socket.socket, group: str, interface: int) -> None:
    """Joins the group on this interface, unless it has joined already."""
    address = ipaddress.ip_address(group.partition("%")[0]).packed
    with contextlib.suppress(OSError):
        if sock.family == socket.AF_INET6:
            sock.setsockopt(socket.IPPROTO_IPV6, socket.IPV6_JOIN_GROUP, address + struct.pack("i", interface))
        else:
            request = address + bytes(4) + struct.pack("i", interface)
            sock.setsockopt(socket.IPPROTO_IP, socket.IP_ADD_MEMBERSHIP, request)


def group_address(group: str, port: int, interface: int) -> Address:
    """The address of the group as sendto() takes it."""
    bare = group.partition("%")[0]
    return (bare, port) if _family(group) == socket.AF_INET else (bare, port, 0, interface)
