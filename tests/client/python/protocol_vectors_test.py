"""The vectors of all languages."""

from __future__ import annotations

import re
import unittest
from typing import Any

from virtual import ROOT

from geminga.protocol.channel_keys import ChannelKeys
from geminga.protocol.frame import Form, FrameError, Kind, read_datagram, write_frame
from geminga.protocol.identity import identity
from geminga.protocol.inbox import Inbox, Message
from geminga.protocol.match import read_match
from geminga.protocol.places import Places
from geminga.protocol.reserved import RESERVED
from geminga.protocol.sealed_frame import SealedFrame, read_any_datagram
from geminga.protocol.sequence import Sequence
from geminga.protocol.statement import LineError, Statement, read_line, write_line
from geminga.protocol.xxh32 import xxh32


def rows(name: str) -> list[list[str]]:
    lines = (ROOT / "tests/client/vectors" / name).read_text(encoding="utf-8").splitlines()
    return [line.split("\t") for line in lines if line and not line.startswith("#")]


def block(name: str) -> list[str]:
    text = (ROOT / "src/discovery/gcnp/GCNP.md").read_text(encoding="utf-8")
    found = re.search(rf"^```{name}\n(.*?)^```", text, re.DOTALL | re.MULTILINE)
    assert found is not None
    return found[1].splitlines()


class Vectors(unittest.TestCase):
    def test_identities_are_those_of_the_table(self) -> None:
        for kind, value, representation, number in rows("identities.tsv"):
            with self.subTest(value=value):
                if kind == "number":
                    self.assertEqual(identity(id=int(value)), int(number))
                else:
                    said: dict[str, Any] = {kind: value, "representation": representation or None}
                    self.assertEqual(identity(**said), int(number))

    def test_the_hash_is_that_of_the_xxhash_project(self) -> None:
        # From the table of the specification, for the seed 0.
        for text, value in {"": 0x02CC5D05, "a": 0x550D7456, "abc": 0x32D153FF}.items():
            self.assertEqual(xxh32(text.encode()), value)
        self.assertEqual(xxh32(b"Nobody inspects the spammish repetition"), 0xE2293B2F)

    def test_an_identity_is_one_of_its_kinds(self) -> None:
        self.assertEqual(identity(id=0xFFFFFFFF), 0xFFFFFFFF)
        slips: list[dict[str, Any]] = [{}, {"id": 1, "text": "x"}, {"id": -1}, {"id": 2**32}, {"text": "x", "representation": "y"}]
        for wrong in slips:
            with self.assertRaises(ValueError):
                identity(**wrong)

    def test_a_full_inbox_loses_what_the_table_says(self) -> None:
        def message(word: str) -> Message:
            life, sequence, missed = (int(one) for one in word.split(":"))
            return Message(b"", life, sequence, missed)

        def taken(inbox: Inbox) -> str:
            one = inbox.take()
            return f"{one.life}:{one.sequence}:{one.missed}"

        for room, words, wanted, count in rows("inbox.tsv"):
            with self.subTest(words=words):
                inbox, lost, got = Inbox(int(room)), 0, []
                for word in words.split():
                    if word == "-":
                        got.append(taken(inbox))
                    elif word[0] == "s":
                        inbox.put_streamed(message(word[1:]))
                    else:
                        lost += inbox.put_datagram(message(word[1:]))
                got += [taken(inbox) for _ in range(len(inbox))]
                self.assertEqual((got, lost), (wanted.split(), int(count)))

    def test_frames_are_those_of_the_table(self) -> None:
        for row in rows("frames.tsv"):
            octets = bytes.fromhex(row[-1])
            with self.subTest(frame=row[-1]):
                if row[0] == "refused":
                    self.assertRaises(FrameError, read_datagram, octets)
                    continue
                frame = read_datagram(octets)
                kind, life, sequence, payload = Kind[row[0].upper()], int(row[1], 16), int(row[2]), bytes.fromhex(row[3])
                self.assertEqual((frame.kind, frame.life, frame.sequence, frame.payload), (kind, life, sequence, payload))
                self.assertEqual(write_frame(kind, life, sequence, payload), octets)

    def test_sealed_frames_are_those_of_the_table(self) -> None:
        text = (ROOT / "tests/client/vectors/sealed.tsv").read_text(encoding="utf-8")
        forward, back = (bytes.fromhex(found) for found in re.findall(r"(?:forward|back) ([0-9a-f]{64})", text))
        by_form = {2: ChannelKeys("encrypted", [(0x6208, forward, back)]), 3: ChannelKeys("authenticated", [(0x6208, forward, back)])}
        for row in rows("sealed.tsv"):
            with self.subTest(row=row):
                if row[0] == "refused":
                    self.assertIsNone(self.opened(by_form[2], row[1], bytes.fromhex(row[2])))
                    continue
                kind, keys = Kind[row[2].upper()], by_form[int(row[1])]
                life, sequence, key, port, counter = int(row[3], 16), int(row[4]), int(row[5], 16), int(row[6]), int(row[7])
                payload, octets = bytes.fromhex(row[8]), bytes.fromhex(row[9])
                if row[0] == "forward":
                    sealed = b"".join(keys.seal_forward(kind, life, sequence, counter, payload, port))
                else:
                    sealed = keys.seal_back(kind, life, counter, payload)
                self.assertEqual(sealed.hex(), octets.hex())
                read = read_any_datagram(octets)
                assert isinstance(read, SealedFrame)
                self.assertEqual((read.form, read.key), (Form(int(row[1])), key))
                frame = self.opened(by_form[2], row[0], octets)
                assert frame is not None
                self.assertEqual((frame.kind, frame.life, frame.sequence), (kind, life, sequence))
                self.assertEqual((frame.payload, frame.port, frame.counter), (payload, port, counter))

    def opened(self, keys: ChannelKeys, direction: str, octets: bytes) -> Any:
        try:
            frame = read_any_datagram(octets)
        except FrameError:
            return None
        return keys.take(frame, is_back=direction == "back")

    def test_messages_without_a_key_are_new_where_the_table_says_so(self) -> None:
        for words, wanted in rows("sequence.tsv"):
            with self.subTest(words=words[:200]):
                sequence, told = Sequence(), []
                for word in words.split():
                    if word == "again":
                        sequence.interrupted(7)
                        continue
                    milliseconds, number = (int(one) for one in word.split(":"))
                    missed = sequence.missed(7, number, milliseconds / 1000)
                    told.append("-" if missed is None else str(missed))
                self.assertEqual(told, wanted.split())

    def test_places_are_shared_as_the_table_says(self) -> None:
        for count, words, wanted in rows("places.tsv"):
            with self.subTest(words=words):
                places: Places[int] = Places(int(count))
                last, told = 0, []
                for word in words.split():
                    if word[0] == "!":
                        places.serve(int(word[1:]))
                    elif word[0] == "-":
                        places.leave(int(word[1:]))
                    else:
                        last += 1
                        took, loser = places.take(last, word)
                        told.append("refused" if not took else "taken" if loser is None else f"taken-{loser}")
                self.assertEqual(told, wanted.split())

    def test_lines_of_the_specification_are_read_and_written_again(self) -> None:
        for name in ("events", "requests"):
            for line in block(name):
                if not line.startswith("="):
                    read = read_line(line.encode())
                    self.assertEqual(read_line(write_line(read)[:-2]), read)
        for line in block("events"):
            self.assertEqual(write_line(read_line(line.encode())), line.encode() + b"\r\n")

    def test_the_reserved_keys_are_those_of_the_specification(self) -> None:
        self.assertEqual(RESERVED, frozenset(" ".join(block("reserved")).split()))

    def test_a_provider_is_read_with_its_attributes(self) -> None:
        matches = [read_match(line) for text in block("events") if isinstance(line := read_line(text.encode()), Statement)]
        first, second, *_ = matches
        self.assertEqual((first.word, first.name, first.participant_name), ("5e6f7a8b/2/1", "vision", "robot2"))
        self.assertEqual((first.address, first.port, first.protocol, first.mode), ("10.0.0.2", 5000, "udp", "otm/stream"))
        self.assertEqual((first.degree, first.distance, first.concept), ("narrower", 1, "soccer:SharedBallInfo"))
        self.assertEqual(second.attributes, {"attr.x": "1", "modes": "3", "rate": "30", "where": "left"})
        converted = next(match for match in matches if match.convert)
        self.assertEqual(converted.convert, ("soccer:PolarRobotFrame", "soccer:CartesianRobotFrame"))
        self.assertEqual((converted.cost, converted.attributes), (1, {"cost": "3"}))

    def test_who_converts_is_read_behind_a_conversion_only(self) -> None:
        lines = (
            (b"1 pub add service=a convert=a:A>a:B cost=2 via=udp://10.0.0.7:6000/b/1/1 attr.via=x", "udp://10.0.0.7:6000/b/1/1"),
            (b"1 pub add service=a via=x", ""),
        )
        for octets, via in lines:
            line = read_line(octets)
            assert isinstance(line, Statement)
            match = read_match(line)
            self.assertEqual((match.via, match.attributes), (via, {"via": "x"}))

    def test_the_way_is_no_attribute(self) -> None:
        line = read_line(b"1 pub add service=a attr.hops=9 attr.path=/left rate=30 hops=2 path=base/tower reachable=no")
        assert isinstance(line, Statement)
        match = read_match(line)
        self.assertEqual((match.hops, match.path, match.reachable), (2, "base/tower", False))
        self.assertEqual(match.attributes, {"hops": "9", "path": "/left", "rate": "30"})
        line = read_line(b"1 pub add service=a path=/left attr.reachable=no")
        assert isinstance(line, Statement)
        match = read_match(line)
        self.assertEqual((match.hops, match.path, match.reachable), (0, "", True))
        self.assertEqual(match.attributes, {"path": "/left", "reachable": "no"})

    def test_a_conversion_between_iris_is_read(self) -> None:
        line = read_line(b"1 pub add service=a convert=<http://a#A>>b:B><http://a#C> cost=2")
        assert isinstance(line, Statement)
        self.assertEqual(read_match(line).convert, ("<http://a#A>", "b:B", "<http://a#C>"))


class HostileEvents(unittest.TestCase):
    def test_what_cannot_be_read_counts_as_not_stated(self) -> None:
        for text in ("port=0", "port=65536", "port=x", "port=-1", "port=\u0663", "port=99999999999999999999", "priority=-", "cost=x"):
            line = read_line(f"1 pub add service=a {text} channel=0123456789ABCDEF".encode())
            assert isinstance(line, Statement)
            match = read_match(line)
            self.assertEqual((match.port, match.priority, match.life), (0, 0, 0))

    def test_an_error_has_no_control_characters(self) -> None:
        self.assertEqual(getattr(read_line(b"1 400 a\x1b[2Jb"), "text"), "a?[2Jb")
        self.assertRaises(LineError, read_line, b"99999999999 400 x")


if __name__ == "__main__":
    unittest.main()
