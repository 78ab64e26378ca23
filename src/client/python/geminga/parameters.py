"""Arguments of publish() and subscribe(), turned into keys of GCNP."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from .protocol.reserved import PREFIX

Attributes = Mapping[str, object]
Words = str | Sequence[str]

MODES = ("oto", "otm/stream", "otm/pubsub")


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


def check_mode(mode: str) -> None:
    """Raises ValueError for an unknown mode."""
    if mode not in MODES:
        raise ValueError(f"mode is one of {', '.join(MODES)}")
