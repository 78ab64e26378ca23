"""The functions of the application that turn one representation into another."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

Conversion = Callable[[bytes], bytes]


class ConversionError(Exception):
    """A conversion is missing, or failed. `step` is the one: `A>B`."""

    def __init__(self, step: str, text: str) -> None:
        super().__init__(text)
        self.step = step


def service_of(via: str, step: int) -> str:
    """Who does a step, counted from 0, by the words of `via`; empty: the consumer."""
    words = via.split(",")
    return words[step] if step < len(words) and words[step] != "-" else ""


def convert(payload: bytes, path: Sequence[str], conversions: Mapping[str, Conversion], via: str = "") -> bytes:
    """Applies `A>B`, `B>C`, ... for the path A, B, C, ..., or `A>C` alone where that is given. Raises ConversionError, which
    names who of `via` would do what is missing."""
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
        except Exception as error:  # The application's own.
            raise ConversionError(step, f"the conversion {step} failed: {error}") from error
    return payload
