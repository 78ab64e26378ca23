"""The conversation with a daemon, without one."""

from __future__ import annotations

import unittest

import virtual  # noqa: F401  (finds the library)

from geminga.protocol.report import Complaint, Report, Settled, Told, Welcome
from geminga.protocol.request import Request, State, changed
from geminga.protocol.session import MAX_UNANSWERED, Session
from geminga.protocol.statement import LineError

HELLO = "0 msg hello version=1 participant=1a2b3c4d participant_name=host"


def said(session: Session) -> list[str]:
    """The outgoing lines, which are removed."""
    lines = session.outgoing.decode().split("\r\n")
    session.outgoing.clear()
    return lines[:-1]


def told(session: Session, *lines: str) -> list[Report]:
    return list(session.receive("".join(line + "\r\n" for line in lines).encode()))


def met() -> Session:
    session = Session("vision")
    session.open()
    told(session, HELLO)
    said(session)
    return session


class Conversation(unittest.TestCase):
    def test_begins_with_hello(self) -> None:
        session = Session("left eye")
        session.open()
        self.assertEqual(said(session), ['0 sys hello name="left eye" keys=yes'])
        self.assertEqual(told(session, HELLO), [Welcome("1a2b3c4d", "host")])

    def test_room_is_asked_for_and_done_without_where_there_is_none(self) -> None:
        session = Session("", 10_000)
        for _ in range(2):
            session.open()
            self.assertEqual(said(session), ["0 sys hello room=10000 keys=yes"])
            (report,) = told(session, "0 429 no room for 10000 subscriptions")
            self.assertIsInstance(report, Complaint)
            self.assertEqual(said(session), ["0 sys hello keys=yes"])
            self.assertEqual(told(session, HELLO), [Welcome("1a2b3c4d", "host")])
            told(session, "0 400 something else")
            self.assertEqual(said(session), [])

    def test_what_does_not_answer_hello_is_no_daemon(self) -> None:
        for line in ("HTTP/1.1 400 Bad Request", "1 pub add service=a", "0 msg pong", "\x16\x03\x01", '0 msg hello a="'):
            session = Session("")
            session.open()
            with self.assertRaises(LineError):
                told(session, line)

    def test_a_request_is_taken_when_its_pong_comes(self) -> None:
        session = met()
        asked = session.create("pub", {"mode": "oto", "text": "x", "port": "1"})
        self.assertEqual(said(session), ["1 pub create mode=oto text=x port=1", "0 sys ping"])
        self.assertEqual(asked.request.state, State.STATED)
        self.assertEqual(told(session, "0 msg pong"), [Settled(asked, None)])
        self.assertEqual(asked.request.state, State.TAKEN)

    def test_a_request_is_refused_by_its_error_and_not_stated_again(self) -> None:
        session = met()
        asked = session.create("sub", {"mode": "oto", "concept": "x:Y"})
        kept = session.create("sub", {"mode": "oto", "text": "x"})
        reports = told(session, "1 422 no such thing", "0 msg pong", "0 msg pong")
        self.assertEqual([type(one) for one in reports], [Settled, Settled])
        self.assertEqual((reports[0].asked, reports[0].error.code), (asked, 422))  # type: ignore[union-attr]
        self.assertEqual((asked.request.state, kept.request.state), (State.REFUSED, State.TAKEN))
        session.close()
        session.open()
        self.assertEqual(said(session), ["0 sys hello name=vision keys=yes", "2 sub create mode=oto text=x", "0 sys ping"])

    def test_all_is_stated_again_as_it_is_now(self) -> None:
        session = met()
        one = session.create("pub", {"mode": "oto", "text": "x", "port": "1"}).request
        gone = session.create("pub", {"mode": "oto", "text": "y", "port": "2"}).request
        told(session, "0 msg pong", "0 msg pong")
        session.modify(one, {"attr.rate": "30", "scope": "host"})
        session.modify(one, {"scope": ""})
        session.remove(gone)
        session.close()
        session.open()
        self.assertEqual(
            said(session), ["0 sys hello name=vision keys=yes", "1 pub create mode=oto text=x port=1 attr.rate=30", "0 sys ping"]
        )

    def test_a_change_that_is_refused_leaves_the_request(self) -> None:
        session = met()
        request = session.create("sub", {"mode": "oto", "text": "x"}).request
        told(session, "0 msg pong")
        asked = session.modify(request, {"where": "rate >"})
        reports = told(session, "1 422 where", "0 msg pong")
        self.assertEqual([(one.asked, one.error.code) for one in reports], [(asked, 422)])  # type: ignore[union-attr]
        self.assertEqual((request.parameters, request.state), ({"mode": "oto", "text": "x"}, State.TAKEN))

    def test_a_change_without_a_daemon_is_stated_later(self) -> None:
        session = Session("")
        request = session.create("sub", {"mode": "oto", "text": "x"}).request
        self.assertIsNone(session.modify(request, {"priority": "3"}))
        self.assertEqual(said(session), [])
        session.open()
        self.assertEqual(said(session)[1], "1 sub create mode=oto text=x priority=3")

    def test_what_waits_for_an_answer_when_the_daemon_goes_counts_as_taken(self) -> None:
        session = met()
        request = session.create("sub", {"mode": "oto", "text": "x"}).request
        told(session, "0 msg pong")
        asked = session.modify(request, {"priority": "3"})
        self.assertEqual(session.close(), [Settled(asked, None)])  # type: ignore[arg-type]

    def test_a_request_that_is_taken_back_is_told_and_not_stated_again(self) -> None:
        session = met()
        request = session.create("sub", {"mode": "oto", "text": "x"}).request
        told(session, "0 msg pong")
        (report,) = told(session, "1 429 taken back: others have less")
        assert isinstance(report, Complaint)
        self.assertEqual((report.request, report.is_gone, request.state), (request, True, State.REFUSED))

    def test_an_ambiguous_number_is_told_and_stays(self) -> None:
        session = met()
        session.create("sub", {"mode": "oto", "id": "7"})
        told(session, "0 msg pong")
        (report,) = told(session, "1 409 the hash of two concepts")
        self.assertFalse(report.is_gone)  # type: ignore[union-attr]

    def test_a_daemon_that_stops_refuses_nothing(self) -> None:
        session = met()
        request = session.create("sub", {"mode": "oto", "text": "x"}).request
        told(session, "1 503 stopping", "0 msg pong")
        self.assertTrue(request.is_wanted)

    def test_events_go_to_their_request_and_others_nowhere(self) -> None:
        session = met()
        request = session.create("sub", {"mode": "oto", "text": "x"}).request
        reports = told(session, "0 msg pong", "1 pub add service=a", "1 sub add subscription=a", "2 pub add service=b",
                       "1 pub explode service=a", "1 who knows", "0 msg lagged", "0 msg news from=tomorrow")  # fmt: skip
        self.assertEqual([one.request for one in reports if isinstance(one, Told)], [request])
        self.assertEqual(len(reports), 2)

    def test_no_more_than_256_requests_wait_for_an_answer(self) -> None:
        session = Session("")
        for number in range(MAX_UNANSWERED + 1):
            session.create("sub", {"mode": "oto", "id": str(number)})
        session.open()
        self.assertEqual(len(said(session)), 1 + 2 * MAX_UNANSWERED)
        told(session, HELLO)
        told(session, "0 msg pong")
        self.assertEqual(said(session), ["257 sub create mode=oto id=256", "0 sys ping"])
        self.assertEqual(len(told(session, *["0 msg pong"] * MAX_UNANSWERED)), MAX_UNANSWERED)

    def test_what_cannot_be_said_is_an_error_and_changes_nothing(self) -> None:
        session = met()
        self.assertRaises(LineError, session.create, "sub", {"text": "\x00"})
        request = session.create("sub", {"mode": "oto", "text": "x"}).request
        self.assertRaises(LineError, session.modify, request, {"where": "\x00"})
        self.assertEqual((request.number, request.parameters), (1, {"mode": "oto", "text": "x"}))


class Changes(unittest.TestCase):
    def test_an_identity_takes_the_place_of_another(self) -> None:
        before = {"mode": "oto", "concept": "a:B", "representation": "a:C"}
        self.assertEqual(changed(before, {"text": "x"}), {"mode": "oto", "text": "x"})
        self.assertEqual(changed(before, {"concept": "a:D"}), {"mode": "oto", "concept": "a:D", "representation": "a:C"})
        self.assertEqual(changed(before, {"representation": ""}), {"mode": "oto", "concept": "a:B"})
        self.assertEqual(changed({"id": "7"}, {"concept": "a:D"}), {"concept": "a:D"})

    def test_an_attribute_may_be_empty(self) -> None:
        self.assertEqual(changed({}, {"attr.note": ""}), {"attr.note": ""})

    def test_a_request_says_itself(self) -> None:
        self.assertEqual(Request(3, "pub").remove().subcommand, "remove")


if __name__ == "__main__":
    unittest.main()
