"""The keys that GCNP gives a meaning to; every other key is an attribute of a service."""

from __future__ import annotations

PREFIX = "attr."

RESERVED = frozenset(
    """
    mode id text concept representation port address protocol priority match provider where limit service name degree
    reason subscription participant_name consumer distance age local used served participant peer favour prefer convert
    scope rank for
    """.split()
)

#: Keys of the daemon's lines that are no attributes there.
KEYS_OF_LINES = frozenset({"why", "because", "on", "placed", "unplaced", "hops", "reachable", "reach"})


def attribute_of(key: str) -> str | None:
    """The name of the attribute that a key of the daemon's lines stands for, or None where it is a key of GCNP."""
    if key.startswith(PREFIX):
        return key[len(PREFIX) :]
    return None if key in RESERVED or key in KEYS_OF_LINES else key
