"""The application's conversions, applied along the chain of a match (src/discovery/matching/conversions/CONVERSIONS.md)."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

Conversion = Callable[[bytes], bytes]


class ConversionError(Exception):
    """A conversion has no function, or its function failed. `step` names it: `A>B`."""

    def __init__(self, step: str, text: str) -> None:
        super().__init__(text)
        self.step = step


def service_of(via: str, step: int) -> str:
    """The service that does a step, counted from 0, by the words of `via`; empty: the consumer does it."""
    words = via.split(",")
    return words[step] if step < len(words) and words[step] != "-" else ""


def convert(payload: bytes, path: Sequence[str], conversions: Mapping[str, Conversion], via: str = "") -> bytes:
    """Applies the functions for `A>B` and `B>C` to the payload for the path A, B, C, or the one for `A>C` alone if there is one.

    Raises ConversionError; for a missing function it names the service of `via` that does the step.
    """
    if len(path) < 2:
        return payload
    whole = f"{path[0]}>{path[-1]}"
    steps = [whole] if whole in conversions else [f"{a}>{b}" for a, b in zip(path, path[1:])]
    for number, step in enumerate(steps):
        function = conversions.get(step)
        if function is None:
            service = service_of(via, number)
            by = f", which the service {service} does" if service else ""
            raise ConversionError(step, f"there is no function for the conversion {step}{by}")
        try:
            payload = function(payload)
        except Exception as error:  # The application may raise anything.
            raise ConversionError(step, f"the conversion {step} failed: {error}") from error
    return payload
