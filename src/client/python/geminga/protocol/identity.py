"""The 32-bit form of an identity (src/identity/IDENTITY.md)."""

from __future__ import annotations

from .xxh32 import xxh32

MAX_NUMBER = 0xFFFFFFFF


def identity(
    *,
    id: int | None = None,
    text: str | None = None,
    concept: str | None = None,
    expression: str | None = None,
    representation: str | None = None,
) -> int:
    """The 32-bit identity of exactly one of a number, a text, a concept or a class expression.

    Concepts and representations are full IRIs without angle brackets; an expression is in canonical form.
    Raises ValueError if none or several are given, or a number has more than 32 bits.
    """
    if sum(one is not None for one in (id, text, concept, expression)) != 1:
        raise ValueError("say one of id, text, concept and expression")
    if representation is not None and concept is None and expression is None:
        raise ValueError("a representation is of a concept or of an expression")
    behind = f"<{representation}>" if representation else ""
    if id is not None:
        if not 0 <= id <= MAX_NUMBER:
            raise ValueError(f"id is 0 to {MAX_NUMBER}")
        return id
    if text is not None:
        return xxh32(text.encode())
    if concept is not None:
        return xxh32(f"<{concept}>{behind}".encode())
    return xxh32(f"({expression}){behind}".encode())
