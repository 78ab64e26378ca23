import geminga.Degree;
import geminga.Identity;
import geminga.Match;
import geminga.Mode;
import geminga.protocol.Backoff;
import geminga.protocol.Counterparts;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Limits;
import geminga.protocol.Listeners;
import geminga.protocol.Sequence;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** Counterparts, sequences, listeners and back-off, in given time (src/client/CHANNELS.md, "How a channel ends"). */
final class CounterpartsTest {
    private static final long SECOND = 1_000_000_000L;

    /** Writes down every call. */
    private static final class Witness implements Counterparts.Watcher<String> {
        private final List<String> told = new ArrayList<>();

        @Override
        public void opened(Entry<String> entry) {
            told.add("opened " + entry.match().life());
        }

        @Override
        public void changed(Entry<String> entry, Match before) {
            told.add("changed " + entry.match().life() + " " + before.port() + ">" + entry.match().port());
        }

        @Override
        public void ending(Entry<String> entry) {
            told.add("ending " + entry.match().life());
        }

        @Override
        public void closed(Entry<String> entry, String reason) {
            told.add("closed " + entry.match().life() + " " + reason);
        }

        void told(String... expected) {
            Check.equal(List.of(expected), told);
            told.clear();
        }
    }

    private final Witness witness = new Witness();
    private final Counterparts<String> all = new Counterparts<>(witness, true);

    private static Match match(String word, long life, int port) {
        return new Match(word, "a/1", "n", "h", life, Identity.text("x"), Degree.EXACT, 0, Mode.PUBSUB, "10.0.0.1", port, "udp", 0, List.of(), 0, "", Map.of());
    }

    private void tick(long now) {
        all.tick(now, entry -> false);
    }

    static void aDaemonThatComesBackWithOtherNumbersChangesNothing() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10));
        test.all.lost();
        test.tick(Long.MAX_VALUE / 2); // however long that takes
        test.all.back(0);
        test.all.put(match("b/9/4", 7, 10));
        test.tick(100 * SECOND);
        test.witness.told("opened 7");
        test.all.remove("a/1/1", "withdrawn", 0, false); // of the life before: nobody's
        test.witness.told();
    }

    static void whoIsNotConfirmedIsAnOrphanAfterTenSecondsAndClosedAfterTenMore() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10));
        test.all.lost();
        test.all.back(0);
        test.tick(20 * SECOND - 1);
        test.tick(30 * SECOND - 2);
        test.witness.told("opened 7");
        test.tick(30 * SECOND - 1);
        test.witness.told("closed 7 disconnected");
    }

    static void anOrphanLivesForTenSecondsOverUdpAndComesBackWithoutAWord() {
        for (String reason : List.of("expired", "left", "lagged", "renamed", "whatever comes")) {
            CounterpartsTest test = new CounterpartsTest();
            test.all.put(match("a/1/1", 7, 10));
            test.all.remove("a/1/1", reason, 0, false);
            test.tick(Limits.ORPHAN - 1);
            test.all.put(match("a/2/1", 7, 10));
            test.tick(Limits.ORPHAN);
            test.witness.told("opened 7");
            test.all.remove("a/2/1", reason, 0, false);
            test.tick(Limits.ORPHAN);
            test.witness.told("closed 7 " + reason);
        }
    }

    static void anOrphanWithAConnectionLivesAsLongAsThat() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10));
        test.all.remove("a/1/1", "expired", 0, true);
        test.tick(1000 * SECOND);
        test.witness.told("opened 7");
        Check.that(!test.all.broke(test.all.of(7)), "it is not to be connected again");
        test.witness.told("closed 7 expired");
    }

    static void anOrphanEndsWhereTheRequestHasItsLimitOfOthers() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.limit(2);
        test.all.put(match("a/1/1", 1, 10));
        test.all.put(match("a/1/2", 2, 10));
        test.all.remove("a/1/1", "expired", 0, false);
        test.witness.told("opened 1", "opened 2");
        test.all.put(match("a/1/3", 3, 10));
        test.witness.told("opened 3", "closed 1 expired");
    }

    static void whoIsOutrankedOrDoesNotMatchIsClosedAtOnce() {
        for (String reason : List.of("outranked", "changed")) {
            CounterpartsTest test = new CounterpartsTest();
            test.all.put(match("a/1/1", 7, 10));
            test.all.remove("a/1/1", reason, 0, true);
            test.witness.told("opened 7", "closed 7 " + reason);
            test.all.modify(match("a/1/1", 7, 10)); // what has ended is made again by an add only
            test.witness.told();
        }
    }

    static void whoIsWithdrawnIsHeardToItsEndWhileItSpeaks() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10));
        test.all.remove("a/1/1", "withdrawn", 0, true);
        test.tick(Limits.ENDING - 1);
        test.all.extend(test.all.of(7), Limits.ENDING - 1);
        test.tick(2 * Limits.ENDING - 2);
        test.witness.told("opened 7", "ending 7");
        test.tick(2 * Limits.ENDING - 1);
        test.witness.told("closed 7 withdrawn");
        CounterpartsTest other = new CounterpartsTest();
        other.all.put(match("a/1/1", 7, 10));
        other.all.ended(other.all.of(7));
        other.all.remove("a/1/1", "withdrawn", 0, true);
        other.witness.told("opened 7", "closed 7 withdrawn");
    }

    static void aConsumerThatIsWithdrawnIsGone() {
        Witness witness = new Witness();
        Counterparts<String> consumers = new Counterparts<>(witness, false);
        consumers.put(match("a/1/1", 7, 10));
        consumers.remove("a/1/1", "withdrawn", 0, true);
        witness.told("opened 7", "closed 7 withdrawn");
    }

    static void oneLifeUnderTwoWordsIsOneChannel() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10));
        test.all.put(match("b/1/1", 7, 11));
        test.all.remove("b/1/1", "left", 0, false);
        test.all.remove("a/1/1", "outranked", 0, false);
        test.witness.told("opened 7", "changed 7 10>11", "changed 7 11>10", "closed 7 outranked");
    }

    static void anotherLifeUnderTheSameWordIsAnotherChannel() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10));
        test.all.modify(match("a/1/1", 8, 10));
        test.witness.told("opened 7", "closed 7 changed", "opened 8");
    }

    static void whoStatesNoLifeIsKnownByItsWord() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 0, 10));
        test.all.put(match("a/1/2", 0, 10));
        Check.equal(2, test.all.all().size());
        Check.equal(null, test.all.of(0));
    }

    static void noMessageIsDeliveredTwiceAndGapsAreCounted() {
        Sequence sequence = new Sequence();
        Check.equal(0L, sequence.take(7, 500)); // before the first nothing is missed
        Check.equal(-1L, sequence.take(7, 500));
        Check.equal(-1L, sequence.take(7, 499));
        Check.equal(2L, sequence.take(7, 503));
        Check.equal(0L, sequence.take(8, 1));
        Check.equal(4L, sequence.missedAtEnd(7, 507));
        sequence.interrupt(7); // made again: it begins anew, but nothing old is delivered
        Check.equal(0L, sequence.missedAtEnd(7, 507));
        Check.equal(-1L, sequence.take(7, 503));
        Check.equal(0L, sequence.take(7, 600));
        Check.equal(-1L, sequence.take(9, 0));
        Check.equal(0L, sequence.take(9, -2)); // sequences are unsigned
        Check.equal(-1L, sequence.take(9, 5));
        Check.equal(0L, sequence.take(9, -1));
    }

    static void soManyLivesAreRemembered() {
        for (int others = Limits.REMEMBERED_LIVES - 1; others <= Limits.REMEMBERED_LIVES + 1; ++others) {
            Sequence sequence = new Sequence();
            sequence.take(1, 5);
            for (int i = 0; i < others; ++i) sequence.take(2 + i, 5);
            Check.equal(others < Limits.REMEMBERED_LIVES ? -1L : 0L, sequence.take(1, 5));
        }
    }

    static void soManyListenersHaveAPlace() {
        Listeners<Integer> listeners = new Listeners<>();
        for (int i = 0; i < Limits.LISTENERS; ++i) Check.that(listeners.heard(i, i), "listener " + i);
        Check.that(listeners.heard(0, 100), "who has a place keeps it");
        Check.that(!listeners.heard(99, 101), "one more");
        listeners.remove(5);
        Check.that(listeners.heard(99, 102), "in the place of who left");
        Check.that(listeners.heard(98, 1 + Limits.LISTENER_SILENCE), "in the place of who fell silent");
    }

    static void aListenerIsForgottenAfterThreeSecondsOfSilence() {
        Listeners<String> listeners = new Listeners<>();
        listeners.heard("a", 0);
        listeners.heard("b", 1);
        listeners.heard("a", 2);
        Check.equal(1 + Limits.LISTENER_SILENCE, listeners.deadline());
        listeners.forget(Limits.LISTENER_SILENCE);
        Check.equal(2, listeners.all().size());
        listeners.forget(1 + Limits.LISTENER_SILENCE);
        Check.equal(List.of("a"), List.copyOf(listeners.all()));
    }

    static void attemptsAreMadeLessAndLessOften() {
        Backoff backoff = new Backoff(new Random(1));
        for (double seconds : new double[] {.1, .2, .4, .8, 1, 1, 1}) {
            double waited = backoff.next() / 1e9;
            Check.that(waited >= seconds && waited <= seconds * 1.25, waited + " s");
        }
        backoff.reset();
        Check.that(backoff.next() <= .125e9, "from the beginning");
    }
}
