"""XXH32 as the xxHash project specifies it, with the seed 0."""

from __future__ import annotations

import struct

_P1, _P2, _P3, _P4, _P5 = 2654435761, 2246822519, 3266489917, 668265263, 374761393
_MASK = 0xFFFFFFFF


def _rotated(value: int, count: int) -> int:
    value &= _MASK
    return ((value << count) | (value >> (32 - count))) & _MASK


def xxh32(octets: bytes) -> int:
    """The hash of these octets. Costs some microseconds for each sixteen of them."""
    length, at = len(octets), 0
    if length >= 16:
        lanes = [_P1 + _P2, _P2, 0, -_P1]
        while at + 16 <= length:
            words = struct.unpack_from("<4I", octets, at)
            lanes = [_rotated(lane + word * _P2, 13) * _P1 & _MASK for lane, word in zip(lanes, words)]
            at += 16
        value = sum(_rotated(lane, count) for lane, count in zip(lanes, (1, 7, 12, 18)))
    else:
        value = _P5
    value += length
    while at + 4 <= length:
        value = _rotated(value + struct.unpack_from("<I", octets, at)[0] * _P3, 17) * _P4
        at += 4
    while at < length:
        value = _rotated(value + octets[at] * _P5, 11) * _P1
        at += 1
    value &= _MASK
    value = (value ^ (value >> 15)) * _P2 & _MASK
    value = (value ^ (value >> 13)) * _P3 & _MASK
    return value ^ (value >> 16)
