"""ChaCha20-Poly1305 of RFC 8439, by the package python3-cryptography, which is asked for when a channel is sealed and not earlier."""

from __future__ import annotations

import importlib
from typing import Any

TAG_OCTETS = 16


class SealingMissing(Exception):
    """A channel is sealed, and this Python cannot seal."""

    def __init__(self, reason: str) -> None:
        super().__init__(
            f"the channel is sealed, which needs the package cryptography (Debian: python3-cryptography): {reason}"
        )


class Cipher:
    """One key. It is not shown by repr()."""

    __slots__ = ("_primitive", "_forged")

    def __init__(self, key: bytes) -> None:
        """Raises SealingMissing."""
        try:
            exceptions: Any = importlib.import_module("cryptography.exceptions")
            aead: Any = importlib.import_module("cryptography.hazmat.primitives.ciphers.aead")
        except ImportError as error:
            raise SealingMissing(str(error)) from None
        try:
            self._primitive: Any = aead.ChaCha20Poly1305(key)
        except exceptions.UnsupportedAlgorithm as error:
            raise SealingMissing(str(error)) from None
        self._forged: type[Exception] = exceptions.InvalidTag

    def __repr__(self) -> str:
        return "Cipher(...)"

    def seal(self, nonce: bytes, text: bytes, additional: bytes) -> bytes:
        """The encrypted text with its tag."""
        return bytes(self._primitive.encrypt(nonce, text, additional))

    def open(self, nonce: bytes, sealed: bytes, additional: bytes) -> bytes | None:
        """The text, or None if no holder of the key sealed it so."""
        try:
            return bytes(self._primitive.decrypt(nonce, sealed, additional))
        except self._forged:
            return None
