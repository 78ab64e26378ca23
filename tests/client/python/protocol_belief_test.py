"""Counterparts, listeners, lives, sequences, the inbox and conversions, in given time."""

from __future__ import annotations

import unittest
from dataclasses import replace

import virtual  # noqa: F401  (finds the library)

from geminga.protocol.backoff import Backoff
from geminga.protocol.converter import ConversionError, convert
from geminga.protocol.counterparts import Change, Counterparts
from geminga.protocol.life import draw_life, read_life, write_life
from geminga.protocol.limits import (
    LISTENER_SECONDS,
    MAX_LISTENERS,
    MAX_REMEMBERED_LIVES,
    MAX_STEP,
    MAX_WAITING_MESSAGES,
    MAX_WAITING_OCTETS,
    ORPHAN_SECONDS,
    SETTLE_SECONDS,
)
from geminga.protocol.inbox import Inbox, Message
from geminga.protocol.listeners import Listener, Listeners
from geminga.protocol.match import Match
from geminga.protocol.sequence import Sequence


def match(word: str, life: int = 0, protocol: str = "udp", port: int = 5000) -> Match:
    return Match(
        word=word, life=life, name="", participant_name="", address="10.0.0.2", port=port, protocol=protocol, mode="oto",
        degree="exact", distance=0, priority=0, id=None, text="x", concept=None, representation=None,
    )  # fmt: skip


def kinds(changes: list[Change]) -> list[str]:
    return [f"{change.kind} {change.counterpart.match.life} {change.reason}".rstrip() for change in changes]


class WhoIsThere(unittest.TestCase):
    def test_is_added_modified_and_removed(self) -> None:
        all_ = Counterparts()
        self.assertEqual(kinds(all_.add(match("a", 1), 0)), ["added 1"])
        self.assertEqual(kinds(all_.modify(match("a", 1, port=5001), 0)), ["modified 1"])
        self.assertEqual(kinds(all_.delete("a", "withdrawn", 0)), ["removed 1 withdrawn"])
        self.assertEqual((len(all_), all_.due()), (0, None))

    def test_is_the_same_under_another_word(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        self.assertEqual(kinds(all_.add(match("b", 1), 0)), [])
        self.assertEqual(kinds(all_.delete("a", "expired", 0)), [])
        self.assertEqual(kinds(all_.delete("b", "changed", 0)), ["removed 1 changed"])

    def test_goes_on_for_ten_seconds_over_udp_when_lost_sight_of(self) -> None:
        for reason in ("expired", "left", "lagged", "renamed", "something new"):
            all_ = Counterparts()
            all_.add(match("a", 1), 0)
            self.assertEqual(kinds(all_.delete("a", reason, 5)), [])
            self.assertEqual(all_.due(), 5 + ORPHAN_SECONDS)
            self.assertEqual(kinds(all_.tick(5 + ORPHAN_SECONDS - 0.001)), [])
            self.assertEqual(kinds(all_.tick(5 + ORPHAN_SECONDS)), [f"removed 1 {reason}"])

    def test_comes_back_as_the_same(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        all_.delete("a", "expired", 0)
        self.assertEqual(kinds(all_.add(match("b", 1), 0)), [])
        self.assertEqual((all_.due(), kinds(all_.tick(1000))), (None, []))

    def test_goes_on_over_tcp_as_long_as_the_connection_does(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1, "tcp"), 0)
        all_.connected(1)
        self.assertEqual(kinds(all_.delete("a", "expired", 0)), [])
        self.assertEqual((all_.due(), kinds(all_.tick(1000))), (None, []))
        self.assertEqual(kinds(all_.disconnected(1)), ["removed 1 expired"])

    def test_is_gone_over_tcp_where_there_is_no_connection(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1, "tcp"), 0)
        self.assertEqual(kinds(all_.delete("a", "expired", 0)), ["removed 1 expired"])

    def test_stays_where_only_the_connection_goes(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1, "tcp"), 0)
        all_.connected(1)
        self.assertEqual(kinds(all_.disconnected(1)), [])

    def test_of_a_consumer_the_protocol_is_the_publications(self) -> None:
        all_ = Counterparts("tcp")
        all_.add(match("a", 1), 0)
        all_.connected(1)
        all_.delete("a", "expired", 0)
        self.assertIsNone(all_.due())

    def test_is_closed_where_others_take_the_limit(self) -> None:
        all_ = Counterparts(limit=1)
        all_.add(match("a", 1), 0)
        all_.delete("a", "expired", 0)
        self.assertEqual(kinds(all_.add(match("b", 2), 0)), ["added 2", "removed 1 expired"])

    def test_is_one_more_than_the_limit_while_a_better_one_comes(self) -> None:
        all_ = Counterparts(limit=1)
        all_.add(match("a", 1), 0)
        self.assertEqual(kinds(all_.add(match("b", 2), 0)), ["added 2"])
        self.assertEqual(kinds(all_.delete("a", "outranked", 0)), ["removed 1 outranked"])

    def test_is_not_made_again_by_a_modify_once_it_has_ended(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        self.assertEqual(kinds(all_.ended(1)), ["removed 1 withdrawn"])
        self.assertEqual(kinds(all_.modify(match("a", 1), 0)), [])
        self.assertEqual(kinds(all_.delete("a", "withdrawn", 0)), [])
        self.assertEqual(kinds(all_.add(match("a", 1), 0)), ["added 1"])

    def test_without_a_life_is_known_by_its_word(self) -> None:
        all_ = Counterparts()
        all_.add(match("a"), 0)
        self.assertEqual(kinds(all_.add(match("b"), 0)), ["added 0"])
        self.assertEqual(len(all_), 2)

    def test_with_another_life_is_another_and_the_former_goes_on(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        self.assertEqual(kinds(all_.modify(match("a", 2), 5)), ["added 2"])
        self.assertEqual(kinds(all_.add(match("b", 1), 6)), [])
        self.assertEqual(kinds(all_.add(match("b", 3), 7)), ["added 3"])
        self.assertEqual(kinds(all_.tick(7 + ORPHAN_SECONDS)), ["removed 1 changed"])


class WhenTheDaemonGoes(unittest.TestCase):
    def test_all_go_on_however_long_that_takes(self) -> None:
        all_ = Counterparts(limit=1)
        all_.add(match("a", 1), 0)
        all_.daemon_lost()
        self.assertEqual((kinds(all_.tick(1e9)), all_.due()), ([], None))

    def test_whom_its_return_confirms_goes_on(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        all_.daemon_lost()
        all_.daemon_back(100)
        self.assertEqual(kinds(all_.add(match("x/1", 1), 0)), [])
        self.assertEqual((kinds(all_.tick(1e9)), all_.due()), ([], None))

    def test_whom_its_return_does_not_confirm_ends_over_udp_after_ten_and_ten_seconds(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        all_.daemon_lost()
        all_.daemon_back(100)
        self.assertEqual(all_.due(), 100 + SETTLE_SECONDS)
        self.assertEqual(kinds(all_.tick(100 + SETTLE_SECONDS)), [])
        self.assertEqual(kinds(all_.tick(100 + SETTLE_SECONDS + ORPHAN_SECONDS)), ["removed 1 disconnected"])

    def test_a_worse_provider_that_is_heard_first_closes_nobody_within_the_ten_seconds(self) -> None:
        all_ = Counterparts(limit=1)
        all_.add(match("a", 1), 0)
        all_.daemon_lost()
        all_.daemon_back(0)
        self.assertEqual(kinds(all_.add(match("worse", 2), 0)), ["added 2"])
        self.assertEqual(kinds(all_.tick(SETTLE_SECONDS)), ["removed 1 disconnected"])

    def test_no_time_runs_out_while_it_is_away(self) -> None:
        for protocol in ("udp", "tcp"):
            all_ = Counterparts()
            all_.add(match("a", 1, protocol), 0)
            all_.connected(1)
            all_.delete("a", "expired", 5)
            all_.daemon_lost()
            self.assertEqual((kinds(all_.tick(1000)), all_.due()), ([], None))
            all_.daemon_back(1000)
            self.assertEqual(kinds(all_.add(match("x/1", 1, protocol), 1009)), [])
            self.assertEqual((kinds(all_.tick(1e9)), all_.due()), ([], None))

    def test_it_may_go_again_before_that(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        all_.daemon_lost()
        all_.daemon_back(0)
        all_.daemon_lost()
        self.assertEqual((kinds(all_.tick(1e9)), all_.due()), ([], None))

    def test_a_consumer_that_is_outranked_right_after_its_return_goes_on(self) -> None:
        for protocol, now, told in (("udp", 9.9, []), ("udp", 10, ["removed 1 outranked"]), ("", 9.9, ["removed 1 outranked"])):
            all_ = Counterparts(protocol)
            all_.add(match("a", 1), 0)
            all_.daemon_lost()
            all_.daemon_back(0)
            all_.add(match("b", 1), 1)
            all_.tick(now)
            self.assertEqual(kinds(all_.delete("b", "outranked", now)), told)
            self.assertEqual(kinds(all_.add(match("b", 1), now)), ["added 1"] if told else [])

    def test_a_connection_that_ends_meanwhile_is_gone(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1, "tcp"), 0)
        all_.connected(1)
        all_.daemon_lost()
        self.assertEqual(kinds(all_.disconnected(1)), ["removed 1 disconnected"])

    def test_what_it_says_first_is_no_return(self) -> None:
        all_ = Counterparts()
        all_.daemon_back(0)
        self.assertIsNone(all_.due())


class Messages(unittest.TestCase):
    """tests/client/vectors/sequence.tsv has the messages over UDP without a key."""

    def test_are_delivered_once_and_in_order(self) -> None:
        sequence = Sequence()
        heard = [sequence.missed_surely(7, number) for number in (5, 5, 6, 4, 9, 7, 2**64 - 1)]
        self.assertEqual(heard, [0, None, 0, None, 2, None, 2**64 - 11])

    def test_of_another_life_are_counted_for_themselves(self) -> None:
        sequence = Sequence()
        self.assertEqual([sequence.missed(1, 9, 0), sequence.missed(2, 1, 0), sequence.missed(1, 10, 0)], [0, 0, 0])

    def test_are_not_missed_while_the_channel_is_closed(self) -> None:
        sequence = Sequence()
        sequence.missed_surely(1, 9)
        sequence.interrupted(1)
        self.assertEqual([sequence.missed_surely(1, number) for number in (9, 20, 22)], [None, 0, 1])

    def test_that_are_missing_before_the_end_are_missed(self) -> None:
        sequence = Sequence()
        sequence.missed(1, 9, 0)
        self.assertEqual([sequence.missed_at_end(1, last) for last in (9, 11, 3, 10 + MAX_STEP)], [0, 2, 0, 1 + MAX_STEP])
        self.assertEqual(sequence.missed_at_end(2, 5), 0)

    def test_before_an_end_that_may_be_forged_are_counted_within_bounds(self) -> None:
        sequence = Sequence()
        sequence.missed(1, 9, 0)
        lasts = (8 + MAX_STEP, 9 + MAX_STEP, 10 + MAX_STEP, 2**64 - 1)
        self.assertEqual([sequence.missed_at_end(1, last, is_sure=False) for last in lasts], [MAX_STEP - 1, MAX_STEP, 0, 0])

    def test_that_are_sealed_are_not_muted_by_what_was_forged_before(self) -> None:
        sequence = Sequence()
        self.assertEqual([sequence.missed(1, number, 0) for number in (5, 6, 60_000)], [0, 0, 59_993])
        self.assertEqual([sequence.missed_surely(1, number) for number in (6, 7, 9, 8)], [None, 0, 1, None])

    def test_that_are_sealed_follow_those_that_were_not(self) -> None:
        sequence = Sequence()
        sequence.missed(1, 5, 0)
        self.assertEqual([sequence.missed_surely(1, number) for number in (8, 9)], [2, 0])

    def test_of_1024_lives_are_remembered(self) -> None:
        sequence = Sequence()
        for life in range(1, MAX_REMEMBERED_LIVES + 1):
            sequence.missed(life, 1, 0)
        self.assertIsNone(sequence.missed(1, 1, 0))
        sequence.missed(1, 2, 0)
        sequence.missed(MAX_REMEMBERED_LIVES + 1, 1, 0)
        self.assertEqual((sequence.missed(1, 2, 0), sequence.missed(2, 1, 0)), (None, 0))


class Waiting(unittest.TestCase):
    def test_the_oldest_are_lost_or_the_newest(self) -> None:
        for keep_newest, kept in ((True, [b"2", b"3"]), (False, [b"1", b"2"])):
            box = Inbox(2, keep_newest)
            self.assertEqual([box.put_datagram(Message(octets)) for octets in (b"1", b"2", b"3")], [0, 0, 1])
            self.assertEqual([box.take().payload for _ in range(len(box))], kept)

    def test_1024_messages_are_full(self) -> None:
        for count, lost in ((MAX_WAITING_MESSAGES - 1, 0), (MAX_WAITING_MESSAGES, 0), (MAX_WAITING_MESSAGES + 1, 1)):
            box = Inbox()
            self.assertEqual(sum(box.put_datagram(Message(b"")) for _ in range(count)), lost)
            self.assertEqual((len(box), box.is_full), (count - lost, count >= MAX_WAITING_MESSAGES))

    def test_16_mebioctets_are_full_and_one_message_always_fits(self) -> None:
        self.assertEqual(MAX_WAITING_OCTETS, 16_777_216)
        box = Inbox(10)
        box.put_datagram(Message(bytes(MAX_WAITING_OCTETS - 1)))
        self.assertFalse(box.is_full)
        box.put_datagram(Message(b"x"))
        self.assertTrue(box.is_full)
        self.assertEqual((box.put_datagram(Message(b"y")), len(box)), (1, 2))
        box = Inbox(1)
        self.assertEqual((box.put_datagram(Message(bytes(MAX_WAITING_OCTETS + 1))), box.is_full, box.has_room), (0, True, False))
        self.assertRaises(ValueError, Inbox, 0)

    def test_what_was_lost_is_told_with_the_next_message_of_its_life(self) -> None:
        for keep_newest, told in ((True, [(3, 2), (4, 0)]), (False, [(1, 0), (2, 0), (5, 2)])):
            box = Inbox(2, keep_newest)
            for sequence in range(1, 5):
                box.put_datagram(Message(b"", 7, sequence))
            got = [box.take() for _ in range(2)]
            box.put_datagram(Message(b"", 8, 9))
            box.put_datagram(Message(b"", 7, 5))
            self.assertEqual((box.take().missed, box.take().missed), (0, 0 if keep_newest else 2))
            got += [] if keep_newest else [Message(b"", 7, 5, 2)]
            self.assertEqual([(one.sequence, one.missed) for one in got], told)

    def test_what_may_not_be_lost_is_not(self) -> None:
        box = Inbox(2)
        box.put_streamed(Message(b"tcp"))
        box.put_datagram(Message(b"old", 7, 1))
        self.assertEqual(box.put_datagram(Message(b"new", 7, 2)), 1)
        box.take()
        box.put_streamed(Message(b"tcp"))
        self.assertEqual((box.take().missed, box.take().payload), (1, b"tcp"))
        for _ in range(2):
            box.put_streamed(Message(b"tcp"))
        self.assertEqual((box.put_datagram(Message(b"lost", 7, 3)), len(box)), (1, 2))

    def test_has_room_when_it_is_half_empty(self) -> None:
        box = Inbox(4)
        for _ in range(4):
            box.put_streamed(Message(b""))
        box.take()
        self.assertFalse(box.has_room)
        box.take()
        self.assertTrue(box.has_room)


class Listening(unittest.TestCase):
    def test_1024_are_heard_and_one_more_when_one_falls_silent(self) -> None:
        listeners = Listeners()

        def say(port: int, now: float) -> bool:
            return listeners.add(("a", port), Listener(1, 1, now, 0))[0]

        for port in range(MAX_LISTENERS):
            self.assertTrue(say(port, 0))
        self.assertFalse(say(MAX_LISTENERS, 1))
        known = listeners.get(("a", 0))
        assert known is not None
        known.heard = 1
        listeners.tick(LISTENER_SECONDS - 0.001)
        self.assertEqual(len(listeners.addresses), MAX_LISTENERS)
        listeners.tick(LISTENER_SECONDS)
        self.assertEqual(listeners.addresses, [("a", 0)])
        self.assertTrue(say(MAX_LISTENERS, 4))
        listeners.end(("a", 0))
        self.assertEqual(listeners.addresses, [("a", MAX_LISTENERS)])

    def test_one_more_of_an_address_that_holds_fewer_takes_a_place(self) -> None:
        listeners = Listeners()
        for port in range(MAX_LISTENERS):
            listeners.add(("a", port), Listener(1, 1, 0, 0))
        took, lost = listeners.add(("b", 1), Listener(2, 2, 0, 0))
        assert lost is not None
        self.assertEqual((took, lost[0], len(listeners.addresses)), (True, ("a", MAX_LISTENERS - 1), MAX_LISTENERS))


class Converting(unittest.TestCase):
    def test_goes_step_by_step_or_all_at_once(self) -> None:
        steps = {"A>B": lambda octets: octets + b"b", "B>C": lambda octets: octets + b"c"}
        self.assertEqual(convert(b"a", ("A", "B", "C"), steps), b"abc")
        self.assertEqual(convert(b"a", ("A", "B", "C"), {**steps, "A>C": lambda octets: b"at once"}), b"at once")
        self.assertEqual(convert(b"a", (), {}), b"a")

    def test_says_which_step_is_missing_or_failed(self) -> None:
        with self.assertRaises(ConversionError) as caught:
            convert(b"", ("A", "B", "C"), {"A>B": bytes})
        self.assertEqual(caught.exception.step, "B>C")
        self.assertEqual(str(caught.exception), "there is no function for the conversion B>C")
        with self.assertRaises(ConversionError) as caught:
            convert(b"", ("A", "B", "C"), {"A>B": bytes}, "-,udp://10.0.0.7:6000/9c0d1e2f/1/1")
        self.assertIn("conversion B>C, which the service udp://10.0.0.7:6000/9c0d1e2f/1/1 does", str(caught.exception))
        with self.assertRaises(ConversionError) as caught:
            convert(b"", ("A", "B"), {"A>B": lambda octets: octets[1].to_bytes()})
        self.assertEqual(caught.exception.step, "A>B")


class Lives(unittest.TestCase):
    def test_are_never_0_and_come_back(self) -> None:
        for life in (1, 2**64 - 1, draw_life()):
            self.assertEqual(read_life(write_life(life)), life)
        for wrong in ("", "0" * 16, "1" * 15, "1" * 17, "A" * 16, "g" * 16, "1" * 16 + "\n", "\u0661" * 16):
            self.assertEqual(read_life(wrong), 0)


class ComingBack(unittest.TestCase):
    def test_takes_longer_and_longer_up_to_a_second(self) -> None:
        backoff = Backoff(lambda: 0.0)
        self.assertEqual([backoff.seconds() for _ in range(6)], [0.1, 0.2, 0.4, 0.8, 1.0, 1.0])
        backoff.reset()
        self.assertEqual(backoff.seconds(), 0.1)
        self.assertEqual(Backoff(lambda: 1.0).seconds(), 0.125)


class WhatIsTold(unittest.TestCase):
    def test_the_daemons_word_is_not_a_change(self) -> None:
        all_ = Counterparts()
        all_.add(match("a", 1), 0)
        self.assertEqual(kinds(all_.add(replace(match("b", 1), attributes={"rate": "1"}), 0)), ["modified 1"])


if __name__ == "__main__":
    unittest.main()
