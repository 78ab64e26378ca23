"""Handshakes, cookies, counters, keys and sealed frames of a stream, in given time."""

from __future__ import annotations

import random
import unittest

from virtual import ring_of

from geminga.protocol.belief import AGAIN, FORGED, FULL, HEARD, Belief
from geminga.protocol.channel_keys import LAST_BACK, MAX_KEYS_OF_A_RING, PLAIN, ChannelKeys, KeysError, read_channel_keys
from geminga.protocol.counter import Counter, CounterError
from geminga.protocol.frame import Frame, Kind, write_frame
from geminga.protocol.frame_reader import BrokenStream, FrameReader
from geminga.protocol.handshake import Allowance, Cookies, Handshake, read_handshake
from geminga.protocol.limits import COOKIE_SECONDS, MAX_ANSWERS, MAX_KEYS, MAX_STREAM_PAYLOAD
from geminga.protocol.provider_keys import ProviderKeys
from geminga.protocol.sealed_frame import OpenedFrame, SealedFrame
from geminga.protocol.statement import Statement, read_line

KEYS = ChannelKeys("encrypted", ring_of(7, [b"secret"]))
HERE = ("10.0.0.2", 5000)


def floor(belief: Belief, cookie: int, sequence: int = 3, kind: Kind = Kind.FLOOR, own: int = 5, challenge: int = 0) -> Frame:
    return Frame(kind, 7, sequence, Handshake(own, challenge or belief.challenge, cookie).write())


class Cookie(unittest.TestCase):
    def test_is_good_for_the_present_eight_seconds_and_the_next(self) -> None:
        cookies = Cookies()
        for begin in (0.0, 1000.0, 7.999):
            cookie = cookies.cookie(HERE, 5, 9, begin)
            last = (begin // COOKIE_SECONDS + 2) * COOKIE_SECONDS
            for now, is_good in ((begin, True), (last - 0.001, True), (last, False), (last + 1000, False)):
                self.assertEqual(cookies.are_right(HERE, 5, 9, cookie, now), is_good)

    def test_is_good_for_one_address_port_life_challenge_and_publisher(self) -> None:
        cookies = Cookies()
        cookie = cookies.cookie(HERE, 5, 9, 0)
        self.assertNotEqual(cookie, 0)
        for there, life, challenge in ((("10.0.0.3", 5000), 5, 9), (("10.0.0.2", 5001), 5, 9), (HERE, 6, 9), (HERE, 5, 8)):
            self.assertFalse(cookies.are_right(there, life, challenge, cookie, 0))
        self.assertFalse(cookies.are_right(HERE, 5, 9, 0, 0))
        self.assertFalse(Cookies().are_right(HERE, 5, 9, cookie, 0))


class Answers(unittest.TestCase):
    def test_are_512_at_once_and_512_a_second(self) -> None:
        now = [0.0]
        allowance = Allowance(lambda: now[0])
        self.assertEqual([allowance.take() for _ in range(MAX_ANSWERS + 1)], [True] * MAX_ANSWERS + [False])
        now[0] = 0.25
        self.assertEqual(sum(allowance.take() for _ in range(MAX_ANSWERS)), MAX_ANSWERS // 4)
        now[0] = 100
        self.assertEqual(sum(allowance.take() for _ in range(2 * MAX_ANSWERS)), MAX_ANSWERS)

    def test_leave_half_of_them_to_newcomers(self) -> None:
        allowance = Allowance(lambda: 0.0)
        self.assertEqual(sum(allowance.take(True) for _ in range(MAX_ANSWERS)), MAX_ANSWERS // 2)
        self.assertEqual(sum(allowance.take() for _ in range(MAX_ANSWERS)), MAX_ANSWERS // 2)


class Greeting(unittest.TestCase):
    def test_is_said_again_after_20_milliseconds_and_twice_as_long_each_time_up_to_a_second(self) -> None:
        belief = Belief(5, 7, PLAIN)
        self.assertEqual([round(belief.wait(), 3) for _ in range(8)], [0.02, 0.04, 0.08, 0.16, 0.32, 0.64, 1, 1])
        belief.answered(floor(belief, 0))
        self.assertEqual([belief.wait() for _ in range(2)], [1, 1])
        belief.answered(floor(belief, 8))
        self.assertEqual(round(belief.wait(), 3), 0.02)

    def test_is_said_at_once_with_another_cookie(self) -> None:
        belief = Belief(5, 7, PLAIN)
        self.assertEqual(read_handshake(belief.hello()), (7, belief.challenge, 0))
        self.assertEqual([belief.answered(floor(belief, cookie)) for cookie in (8, 8, 0, 9, 9)], [AGAIN, HEARD, HEARD, AGAIN, HEARD])
        self.assertEqual(read_handshake(belief.hello()), (7, belief.challenge, 9))
        self.assertEqual(belief.answered(floor(belief, 0, kind=Kind.FULL)), FULL)

    def test_is_answered_by_those_who_heard_it(self) -> None:
        belief = Belief(5, 7, PLAIN)
        for wrong in (floor(belief, 8, own=6), floor(belief, 8, challenge=belief.challenge ^ 1), Frame(Kind.FLOOR, 7, 3, b"")):
            self.assertEqual(belief.answered(wrong), FORGED)
        self.assertEqual((belief.cookie, belief.floor), (0, None))

    def test_has_the_first_floor_and_a_sealed_one_instead_of_a_plain_one(self) -> None:
        belief = Belief(5, 7, ChannelKeys("mixed", ring_of(7, [b"secret"])))
        belief.answered(floor(belief, 8, 3))
        belief.answered(floor(belief, 0, 4))
        self.assertEqual(belief.floor, 3)
        belief.rekey(KEYS)
        self.assertIsNone(belief.floor)
        for sequence in (5, 6):
            sealed = OpenedFrame(Kind.FLOOR, 7, sequence, Handshake(5, belief.challenge, 0).write(), 0, sequence)
            belief.answered(sealed)
            self.assertEqual(belief.floor, 5)
        belief.greet()
        self.assertIsNone(belief.floor)


class Counters(unittest.TestCase):
    def test_are_used_up(self) -> None:
        for last in (LAST_BACK, 2**64 - 1):
            counter = Counter(last, last - 2)
            self.assertEqual([counter.next(), counter.next()], [last - 1, last])
            self.assertRaises(CounterError, counter.next)

    def test_of_consumers_are_read_up_to_32_bits(self) -> None:
        for counter, is_read in ((LAST_BACK - 1, True), (LAST_BACK, True)):
            sealed = FrameReader().feed(KEYS.seal_back(Kind.HELLO, 5, counter, b""))[0]
            self.assertEqual(KEYS.take(sealed, is_back=True) is not None, is_read)


class Rings(unittest.TestCase):
    def line(self, ring: str, mode: str = "encrypted", life: str = "0000000000000007") -> Statement:
        read = read_line(f"1 pub keys life={life} mode={mode} ring={ring}".encode())
        assert isinstance(read, Statement)
        return read

    def test_have_64_keys_at_most(self) -> None:
        for count in (MAX_KEYS_OF_A_RING - 1, MAX_KEYS_OF_A_RING, MAX_KEYS_OF_A_RING + 1):
            line = self.line(",".join(f"{key:04x}:{'11' * 32}:{'22' * 32}" for key in range(count)))
            if count > MAX_KEYS_OF_A_RING:
                self.assertRaises(KeysError, read_channel_keys, line)
            else:
                self.assertEqual(repr(read_channel_keys(line)), f"(7, ChannelKeys('encrypted', {count} keys))")

    def test_that_cannot_be_read_are_refused_and_not_shown(self) -> None:
        key = f"6208:{'1b' * 32}:{'22' * 32}"
        for line in (
            self.line(key[:-1]), self.line(key + "3"), self.line(key.upper()), self.line(""), self.line(f"{key},"), self.line(f"{key};{key}"),
            self.line(key, mode="open"), self.line(key, life="7"), self.line(key, life="0" * 16), self.line(key[:-2] + "é"),
        ):  # fmt: skip
            with self.assertRaises(KeysError) as caught:
                read_channel_keys(line)
            self.assertNotIn("1b1b", f"{caught.exception} {line}")

    def test_of_1024_lives_besides_the_providers_are_kept(self) -> None:
        for count, kept in ((MAX_KEYS - 1, PLAIN), (MAX_KEYS, PLAIN), (MAX_KEYS + 1, None)):
            keys = ProviderKeys()
            for life in range(1, count + 1):
                keys.put(life, PLAIN, ())
            self.assertEqual((keys.get(1, None), keys.get(2, None), keys.get(count, None)), (kept, PLAIN, PLAIN))
        keys = ProviderKeys()
        for life in range(1, 2 * MAX_KEYS):
            keys.put(life, PLAIN, (1,))
        self.assertEqual((keys.get(1, None), keys.get(2, None)), (PLAIN, None))


class Streams(unittest.TestCase):
    def test_of_frames_of_all_forms_are_put_together_however_they_come(self) -> None:
        chance = random.Random(4717)
        payloads = [chance.randbytes(size) for size in (0, 1, 24, 36, 1000, 70_000)]
        stream = b""
        for number, payload in enumerate(payloads, 1):
            stream += write_frame(Kind.MESSAGE, 7, number, payload)
            stream += b"".join(KEYS.seal_forward(Kind.MESSAGE, 7, number, number, payload))
        for _ in range(10):
            reader, at, read = FrameReader(), 0, []
            while at < len(stream):
                size = chance.choice((1, 5, 24, 36, 37, 4096, 100_000))
                read += reader.feed(stream[at : at + size])
                at += size
            opened = [KEYS.open_forward(one) if isinstance(one, SealedFrame) else one for one in read]
            self.assertEqual([one.payload for one in opened if one is not None], [one for one in payloads for _ in range(2)])

    def test_have_frames_up_to_16_mebioctets_and_a_tag(self) -> None:
        sealed = b"".join(KEYS.seal_forward(Kind.MESSAGE, 7, 1, 1, b""))
        for length, is_read in ((MAX_STREAM_PAYLOAD + 15, True), (MAX_STREAM_PAYLOAD + 16, True), (MAX_STREAM_PAYLOAD + 17, False), (15, False)):
            header = sealed[:4] + length.to_bytes(4, "big") + sealed[8:36]
            if is_read:
                self.assertEqual(FrameReader().feed(header), [])
            else:
                self.assertRaises(BrokenStream, FrameReader().feed, header)


if __name__ == "__main__":
    unittest.main()
