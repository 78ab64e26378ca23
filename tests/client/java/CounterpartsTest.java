import geminga.Degree;
import geminga.Identity;
import geminga.Match;
import geminga.Mode;
import geminga.protocol.Backoff;
import geminga.protocol.Counterparts;
import geminga.protocol.Counterparts.Entry;
import geminga.protocol.Limits;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;

/** Counterparts and back-off, in given time (src/client/CHANNELS.md, "How a channel ends"). */
final class CounterpartsTest {
    private static final long SECOND = 1_000_000_000L;

    /** Writes down every call. */
    private static final class Witness implements Counterparts.Watcher<String> {
        private final List<String> told = new ArrayList<>();
        private boolean hasConnection;

        @Override
        public boolean hasConnection(Entry<String> entry) {
            return hasConnection;
        }

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
        return new Match(word, "a/1", "n", "h", life, Identity.text("x"), Degree.EXACT, 0, Mode.PUBSUB, "10.0.0.1", port, "udp", 0, List.of(), 0, "", Map.of(), 0, "", true);
    }

    private void tick(long now) {
        all.tick(now);
    }

    static void aDaemonThatComesBackWithOtherNumbersChangesNothing() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.all.lost();
        test.tick(Long.MAX_VALUE / 2); // however long that takes
        test.all.back(0);
        test.all.put(match("b/9/4", 7, 10), 0);
        test.tick(100 * SECOND);
        test.witness.told("opened 7");
        test.all.remove("a/1/1", "withdrawn", 0); // of the life before: nobody's
        test.witness.told();
    }

    static void whoIsNotConfirmedIsAnOrphanAfterTenSecondsAndClosedAfterTenMore() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
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
            test.all.put(match("a/1/1", 7, 10), 0);
            test.all.remove("a/1/1", reason, 0);
            test.tick(Limits.ORPHAN - 1);
            test.all.put(match("a/2/1", 7, 10), 0);
            test.tick(Limits.ORPHAN);
            test.witness.told("opened 7");
            test.all.remove("a/2/1", reason, 0);
            test.tick(Limits.ORPHAN);
            test.witness.told("closed 7 " + reason);
        }
    }

    static void anOrphanWithAConnectionLivesAsLongAsThat() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.witness.hasConnection = true;
        test.all.remove("a/1/1", "expired", 0);
        test.tick(1000 * SECOND);
        test.witness.told("opened 7");
        Check.that(!test.all.broke(test.all.of(7)), "it is not to be connected again");
        test.witness.told("closed 7 expired");
    }

    static void anOrphanEndsWhereTheRequestHasItsLimitOfOthers() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.limit(2);
        test.all.put(match("a/1/1", 1, 10), 0);
        test.all.put(match("a/1/2", 2, 10), 0);
        test.all.remove("a/1/1", "expired", 0);
        test.witness.told("opened 1", "opened 2");
        test.all.put(match("a/1/3", 3, 10), 0);
        test.witness.told("opened 3", "closed 1 expired");
    }

    static void whoIsOutrankedOrDoesNotMatchIsClosedAtOnce() {
        for (String reason : List.of("outranked", "changed")) {
            CounterpartsTest test = new CounterpartsTest();
            test.all.put(match("a/1/1", 7, 10), 0);
            test.witness.hasConnection = true;
            test.all.remove("a/1/1", reason, 0);
            test.witness.told("opened 7", "closed 7 " + reason);
            test.all.modify(match("a/1/1", 7, 10), 0); // what has ended is made again by an add only
            test.witness.told();
        }
    }

    static void whoIsWithdrawnIsHeardToItsEndWhileItSpeaks() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.witness.hasConnection = true;
        test.all.remove("a/1/1", "withdrawn", 0);
        test.tick(Limits.ENDING - 1);
        test.all.extend(test.all.of(7), Limits.ENDING - 1);
        test.tick(2 * Limits.ENDING - 2);
        test.witness.told("opened 7", "ending 7");
        test.tick(2 * Limits.ENDING - 1);
        test.witness.told("closed 7 withdrawn");
        CounterpartsTest other = new CounterpartsTest();
        other.all.put(match("a/1/1", 7, 10), 0);
        other.all.ended(other.all.of(7));
        other.witness.hasConnection = true;
        other.all.remove("a/1/1", "withdrawn", 0);
        other.witness.told("opened 7", "closed 7 withdrawn");
    }

    static void aConsumerThatIsWithdrawnIsGone() {
        Witness witness = new Witness();
        Counterparts<String> consumers = new Counterparts<>(witness, false);
        consumers.put(match("a/1/1", 7, 10), 0);
        witness.hasConnection = true;
        consumers.remove("a/1/1", "withdrawn", 0);
        witness.told("opened 7", "closed 7 withdrawn");
    }

    static void oneLifeUnderTwoWordsIsOneChannel() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.all.put(match("b/1/1", 7, 11), 0);
        test.all.remove("b/1/1", "left", 0);
        test.all.remove("a/1/1", "outranked", 0);
        test.witness.told("opened 7", "changed 7 10>11", "changed 7 11>10", "closed 7 outranked");
    }

    static void anotherLifeUnderTheSameWordIsAnotherChannelAndTheFormerOneIsAnOrphan() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.all.modify(match("a/1/1", 8, 10), 0);
        test.witness.told("opened 7", "opened 8");
        test.tick(Limits.ORPHAN);
        test.witness.told("closed 7 changed");
    }

    static void livesThatHaveOneAnothersWordsAfterARestartGoOn() {
        // A daemon with a state folder comes back with its identifier, and its clients in another order.
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.all.put(match("a/2/1", 8, 11), 0);
        test.all.put(match("a/1/1", 8, 11), SECOND);
        test.all.put(match("a/2/1", 7, 10), 2 * SECOND);
        test.tick(100 * SECOND);
        test.witness.told("opened 7", "opened 8");
    }

    static void anOrphanComesNoCloserToItsEndWhileItsOwnDaemonIsDeadToo() {
        // kill -9 of both daemons, the other one first: nobody can confirm the channel until both are back.
        for (long between : new long[] {0, 3 * SECOND, Limits.ORPHAN - 1}) {
            CounterpartsTest test = new CounterpartsTest();
            test.all.put(match("a/1/1", 7, 10), 0);
            test.all.remove("a/1/1", "expired", 0);
            test.tick(between);
            test.all.lost();
            test.tick(60 * SECOND);
            test.all.back(60 * SECOND);
            test.tick(70 * SECOND - 1);
            test.all.put(match("b/9/4", 7, 10), 70 * SECOND);
            test.tick(200 * SECOND);
            test.witness.told("opened 7");
        }
        CounterpartsTest alone = new CounterpartsTest(); // and ends where nobody confirms it
        alone.all.put(match("a/1/1", 7, 10), 0);
        alone.all.remove("a/1/1", "expired", 0);
        alone.all.lost();
        alone.all.back(60 * SECOND);
        alone.tick(70 * SECOND);
        alone.tick(80 * SECOND - 1);
        alone.witness.told("opened 7");
        alone.tick(80 * SECOND);
        alone.witness.told("closed 7 expired");
    }

    static void aConsumerThatIsOutrankedByItsOwnProvidersFormerWordGoesOn() {
        // Both daemons were killed: the consumer's one still prefers the publication of the daemon that is dead, which has the same life.
        for (long later : new long[] {0, SECOND, Limits.CONFIRMATION - 1}) {
            Witness witness = new Witness();
            Counterparts<String> consumers = new Counterparts<>(witness, false);
            consumers.put(match("b/1/1", 7, 10), 0);
            consumers.lost();
            consumers.back(5 * SECOND);
            consumers.put(match("c/1/1", 7, 10), 5 * SECOND);
            consumers.remove("c/1/1", "outranked", 5 * SECOND + later);
            consumers.tick(5 * SECOND + later + Limits.ORPHAN - 1);
            consumers.put(match("c/1/1", 7, 10), 5 * SECOND + later + Limits.ORPHAN - 1);
            consumers.tick(100 * SECOND);
            witness.told("opened 7");
            consumers.remove("c/1/1", "outranked", 100 * SECOND); // the daemon knows by now
            witness.told("closed 7 outranked");
        }
        Witness witness = new Witness();
        Counterparts<String> consumers = new Counterparts<>(witness, false);
        consumers.put(match("b/1/1", 7, 10), 0);
        consumers.lost();
        consumers.back(0);
        consumers.put(match("b/1/1", 7, 10), 1);
        consumers.remove("b/1/1", "outranked", Limits.CONFIRMATION - 1);
        consumers.tick(Limits.CONFIRMATION + Limits.ORPHAN - 2);
        witness.told("opened 7");
        consumers.tick(Limits.CONFIRMATION + Limits.ORPHAN - 1);
        witness.told("closed 7 outranked");
    }

    static void whatWasWithdrawnStillEndsWhileTheDaemonIsDead() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.all.remove("a/1/1", "withdrawn", 0);
        test.all.lost();
        test.tick(Limits.ENDING);
        test.witness.told("opened 7", "ending 7", "closed 7 withdrawn");
    }

    static void whatIsAddedAgainWhileItDrainsIsToldItsInlet() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 7, 10), 0);
        test.all.remove("a/1/1", "withdrawn", 0);
        test.all.put(match("a/1/1", 7, 10), 1);
        test.witness.told("opened 7", "ending 7", "changed 7 10>10");
        test.tick(100 * SECOND);
        test.witness.told();
    }

    static void whoStatesNoLifeIsKnownByItsWord() {
        CounterpartsTest test = new CounterpartsTest();
        test.all.put(match("a/1/1", 0, 10), 0);
        test.all.put(match("a/1/2", 0, 10), 0);
        Check.equal(2, test.all.all().size());
        Check.equal(null, test.all.of(0));
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
