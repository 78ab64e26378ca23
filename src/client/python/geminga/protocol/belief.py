"""The belief of a subscriber in one provider: its keys, the challenge, the floor, and the hellos until it is accepted."""

from __future__ import annotations

from .channel_keys import ChannelKeys
from .frame import Frame, Kind
from .handshake import Handshake, read_handshake
from .life import draw_life
from .limits import FIRST_HELLO_SECONDS, HELLO_SECONDS
from .sealed_frame import AnyFrame

#: The outcomes of answered().
FORGED, HEARD, AGAIN, FULL = "forged", "heard", "again", "full"


class Belief:
    """One channel of a subscriber. `own_life` is the subscriber's, `life` the provider's. Not thread-safe."""

    def __init__(self, own_life: int, life: int, keys: ChannelKeys | None) -> None:
        self._own_life = own_life
        self._life = life
        self.keys = keys  #: None until the daemon has said which there are
        self.has_taken_sealed = False
        self.is_told_full = False
        self.greet()

    def greet(self) -> None:
        """Begins the handshake anew: draws another challenge, and forgets the floor."""
        self.challenge = draw_life()
        self.cookie = 0
        self.is_accepted = False
        self._floor: int | None = None
        self._has_sealed_floor = False
        self._hellos = 0

    def rekey(self, keys: ChannelKeys) -> None:
        """Other keys are in force, or another mode."""
        self.keys = keys
        if not keys.has_ring:
            self.has_taken_sealed = False

    @property
    def has_ring(self) -> bool:
        """Whether hello is said on every channel."""
        return self.keys is not None and self.keys.has_ring

    def hello(self) -> bytes:
        """The payload of a hello, or of the end by which a listener leaves."""
        return Handshake(self._life, self.challenge, self.cookie).write()

    def wait(self) -> float:
        """The seconds until the hello after this one: 20, 40, 80, ... 640 ms, then each second."""
        if self.is_accepted:
            return HELLO_SECONDS
        wait = FIRST_HELLO_SECONDS * (1 << self._hellos)
        if wait >= HELLO_SECONDS:
            return HELLO_SECONDS
        self._hellos += 1
        return wait

    def take(self, frame: AnyFrame) -> Frame | None:
        """A frame of the provider as this host takes it, opened; None if it does not."""
        if self.keys is None:
            return None
        taken = self.keys.take(frame, is_back=False)
        if taken is None:
            return None
        if taken.is_sealed:
            self.has_taken_sealed = True
        elif self.has_taken_sealed:
            return None
        return taken

    def answered(self, frame: Frame) -> str:
        """Takes a floor or a full. AGAIN: say hello at once."""
        said = read_handshake(frame.payload)
        if said is None or said.life != self._own_life or said.challenge != self.challenge:
            return FORGED
        if frame.kind is Kind.FULL:
            self.is_accepted = False
            return FULL
        if self._floor is None or (frame.is_sealed and not self._has_sealed_floor):
            self._floor, self._has_sealed_floor = frame.sequence, frame.is_sealed
        if said.cookie == 0:
            self.is_accepted, self.is_told_full, self._hellos = True, False, 0
            return HEARD
        self.is_accepted = False
        if said.cookie == self.cookie:
            return HEARD  # It is being considered: the next hello has its time.
        self.cookie = said.cookie
        return AGAIN

    @property
    def floor(self) -> int | None:
        """The sequence above which sealed messages are believed; None if no floor has come that this mode believes."""
        if self.keys is None or not (self._has_sealed_floor or self.keys.takes_plain):
            return None
        return self._floor
