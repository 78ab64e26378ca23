"""Lines of GCNP and frames of TCP, also hostile ones, at each limit."""

from __future__ import annotations

import random
import unittest

import virtual  # noqa: F401  (finds the library)

from geminga.protocol.frame import HEADER_OCTETS, Kind, write_frame
from geminga.protocol.frame_reader import BrokenStream, FrameReader
from geminga.protocol.limits import MAX_STREAM_PAYLOAD
from geminga.protocol.line_reader import LineReader
from geminga.protocol.statement import MAX_LINE_OCTETS, LineError, Statement, read_line, write_line


class Lines(unittest.TestCase):
    def test_hostile_lines_are_refused(self) -> None:
        for line in (
            b"", b" ", b"5", b"5 pub", b"pub create x", b"-1 pub remove", b"+1 pub remove", b"4294967296 pub remove", b" 5 pub remove",
            b'5 pub create a="x', b'5 pub create a="x"y', b'5 pub create a=x"y', b'5 pub create a="\\x"', b'5 pub create a="\\',
            b"5 pub create =x", b"5 pub create a:b=x", b"5 pub create a=1 a=2", b"5 pub create a=\x01", b"5 p\x00b create",
            b"5 pub create a=\xff", b"5 pub create a=\xed\xa0\x80", b"5 pub create \xc3\xa9=1", "\u0665 pub remove".encode(),
            b"9" * 5000 + b" pub remove",
        ):  # fmt: skip
            with self.subTest(line=line):
                self.assertRaises(LineError, read_line, line)

    def test_an_id_may_have_zeros_before_it(self) -> None:
        self.assertEqual(read_line(b"007 pub remove"), Statement(7, "pub", "remove"))
        self.assertEqual(read_line(b"4294967295 pub remove"), Statement(4294967295, "pub", "remove"))

    def test_values_come_back(self) -> None:
        for value in ("", "x", "a b", '"', "\\", "\\n", "\n\r\t", "a=b", "Ölstand", "=", "\U0001f916"):
            line = Statement(1, "pub", "create", {"a": value, "b": None})
            self.assertEqual(read_line(write_line(line).removesuffix(b"\r\n")), line)

    def test_what_gcnp_cannot_carry_is_not_written(self) -> None:
        for value in ("\x00", "\x7f", "\x1b", "x" * MAX_LINE_OCTETS):
            self.assertRaises(LineError, write_line, Statement(1, "pub", "create", {"a": value}))
        for key in ("", "a b", "a=b", "ä", "a\r\n2 pub remove"):
            self.assertRaises(LineError, write_line, Statement(1, "pub", "create", {key: "x"}))

    def test_a_line_has_65536_octets_at_most(self) -> None:
        beginning = b"1 pub create a="
        for length in (MAX_LINE_OCTETS - 1, MAX_LINE_OCTETS):
            read_line(beginning + b"x" * (length - len(beginning)))
        self.assertRaises(LineError, read_line, beginning + b"x" * (MAX_LINE_OCTETS + 1 - len(beginning)))

    def test_a_line_has_256_parameters_at_most(self) -> None:
        for count in (255, 256):
            read_line(("1 pub create " + " ".join(f"k{number}" for number in range(count))).encode())
        many = "1 pub create " + " ".join(f"k{number}" for number in range(257))
        self.assertRaises(LineError, read_line, many.encode())

    def test_lines_are_put_together_however_they_come(self) -> None:
        lines = [b"1 pub remove", b"", b"x" * 100, b"\xff"]
        stream = b"".join(line + end for line, end in zip(lines, (b"\r\n", b"\n", b"\r\n", b"\n")))
        for size in (1, 2, 3, 7, 1000):
            reader = LineReader()
            read = [line for at in range(0, len(stream), size) for line in reader.feed(stream[at : at + size])]
            self.assertEqual(read, lines)

    def test_a_line_without_an_end_is_refused_as_soon_as_it_is_too_long(self) -> None:
        reader = LineReader()
        self.assertEqual(list(reader.feed(b"x" * MAX_LINE_OCTETS + b"\r")), [])
        self.assertEqual(list(reader.feed(b"\n")), [b"x" * MAX_LINE_OCTETS])
        self.assertRaises(LineError, list, reader.feed(b"x" * (MAX_LINE_OCTETS + 1)))


class Frames(unittest.TestCase):
    def test_frames_are_put_together_however_they_come(self) -> None:
        seed = 4717
        chance = random.Random(seed)
        payloads = [chance.randbytes(size) for size in (0, 1, 24, 1000, 70_000)]
        stream = b"".join(write_frame(Kind.MESSAGE, 5, number, payload) for number, payload in enumerate(payloads, 1))
        for _ in range(20):
            reader, at, read = FrameReader(), 0, []
            while at < len(stream):
                size = chance.choice((1, 5, 23, 24, 25, 4096, 100_000))
                read += reader.feed(stream[at : at + size])
                at += size
            self.assertEqual([frame.payload for frame in read], payloads, f"seed {seed}")

    def test_the_largest_frame_is_read_and_one_octet_more_is_not(self) -> None:
        for length in (MAX_STREAM_PAYLOAD - 1, MAX_STREAM_PAYLOAD):
            frames = FrameReader().feed(write_frame(Kind.MESSAGE, 1, 1, bytes(length)))
            self.assertEqual(len(frames[0].payload), length)
        header = write_frame(Kind.MESSAGE, 1, 1)[:4] + (MAX_STREAM_PAYLOAD + 1).to_bytes(4, "big") + bytes(16)
        self.assertRaises(BrokenStream, FrameReader().feed, header)

    def test_behind_what_is_no_frame_nothing_is_read(self) -> None:
        good = write_frame(Kind.MESSAGE, 1, 1, b"x")
        for broken in (b"GET / HTTP/1.1\r\nHost: robot", good[:3] + b"\x06" + good[4:], good[:8] + bytes(8) + good[16:]):
            with self.assertRaises(BrokenStream) as caught:
                FrameReader().feed(good + broken + good)
            self.assertEqual(len(caught.exception.frames), 1)

    def test_an_unfinished_frame_waits(self) -> None:
        self.assertEqual(FrameReader().feed(write_frame(Kind.MESSAGE, 1, 1, b"x")[:HEADER_OCTETS]), [])


if __name__ == "__main__":
    unittest.main()
