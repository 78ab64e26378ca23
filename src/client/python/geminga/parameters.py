"""Arguments of publish() and subscribe(), turned into keys of GCNP."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .protocol.reserved import PREFIX

Attributes = Mapping[str, object]
Words = str | Sequence[str]

MODES = ("oto", "otm/stream", "otm/pubsub")
PROTOCOLS = ("udp", "tcp")

#: The keys of `pub modify` and of `sub modify`, besides those that cannot be changed.
_CHANGEABLE = {
    "pub": ("id", "text", "concept", "representation", "priority", "scope", "for"),
    "sub": (
        "id", "text", "concept", "representation", "priority", "scope", "match", "provider", "favour", "prefer", "rank", "where", "convert",
        "on",
        "reach",
    ),
}  # fmt: skip
#: Arguments that are numbers, with the least and the greatest value.
_NUMBERS = {
    "port": (0, 65535, "1 to 65535, or 0 for any"),
    "id": (0, 2**32 - 1, "0 to 4294967295"),
    "priority": (-(2**31), 2**31 - 1, "-2147483648 to 2147483647"),
    "limit": (0, 2**32 - 1, "0 (all) or more"),
}
FIXED = ("mode", "protocol", "port", "address", "limit")


def words(value: Words) -> str:
    """Several words, with commas between them."""
    return value if isinstance(value, str) else ",".join(value)


def attribute_value(value: object) -> str:
    """An attribute's value as text; true and false are 1 and 0."""
    return str(int(value)) if isinstance(value, bool) else str(value)


def parameters(attributes: Attributes | None, **keys: object) -> dict[str, str]:
    """The keys that are not None, and the attributes with their prefix. A `_` at the end of a key is left out."""
    said: dict[str, str] = {}
    for key, value in keys.items():
        if value is None:
            continue
        if isinstance(value, (list, tuple)):
            value = words(value)
        said[key.removesuffix("_")] = value if isinstance(value, str) else attribute_value(value)
    for name, value in (attributes or {}).items():
        said[PREFIX + name] = attribute_value(value)
    return said


def checked(said: dict[str, str], protocols: int, **numbers: object) -> dict[str, str]:
    """The keys of a request, whose protocol has so many words at most. Raises ValueError, and TypeError for numbers that are none."""
    mode = said.get("mode", "")
    if mode not in MODES:
        raise ValueError(f"mode is one of {', '.join(MODES)}, not {mode!r}")
    listed = said.get("protocol", "udp").split(",")
    if len(listed) > protocols or any(one not in PROTOCOLS for one in listed):
        raise ValueError(f"protocol is {' or '.join(PROTOCOLS)}{', or both' if protocols > 1 else ''}, not {said['protocol']!r}")
    check_numbers(**numbers)
    for key, value in said.items():
        if value == "" and key != "text" and not key.startswith(PREFIX):
            raise ValueError(f"{key} is empty: leave it out, or say what it is")
        if key == PREFIX:
            raise ValueError("an attribute has an empty name")
    return said


def check_numbers(**numbers: object) -> None:
    """Raises ValueError for a number that is outside of its range, and TypeError for what is no number."""
    for key, value in numbers.items():
        if value is None or key not in _NUMBERS:
            continue
        least, greatest, words = _NUMBERS[key]
        if not isinstance(value, int) or isinstance(value, bool):
            raise TypeError(f"{key} is a number ({words}), not {type(value).__name__}")
        if not least <= value <= greatest:
            raise ValueError(f"{key} is {words}, not {value}")


def changes_of(command: str, attributes: Attributes | None, keys: dict[str, object]) -> dict[str, str]:
    """The keys of `pub modify` or `sub modify`. Raises ValueError for one that cannot be changed, and TypeError for an unknown one."""
    for key in keys:
        bare = key.removesuffix("_")
        if bare in FIXED:
            raise ValueError(f"{key} cannot be changed: close this one and make another")
        if bare not in _CHANGEABLE[command]:
            known = ", ".join(_CHANGEABLE[command])
            raise TypeError(f"modify() has no parameter {key!r}: it changes {known}; any other name is one of attributes={{...}}")
    check_numbers(**keys)
    return parameters(attributes, **keys)


def octets_of(payload: object) -> bytes:
    """The octets of a payload. Raises TypeError."""
    if isinstance(payload, (bytes, bytearray, memoryview)):
        return bytes(payload)
    hint = ": encode the text, as in text.encode()" if isinstance(payload, str) else ""
    raise TypeError(f"a payload is bytes, bytearray or memoryview, not {type(payload).__name__}{hint}")
