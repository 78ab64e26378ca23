import geminga.protocol.AnswerRate;
import geminga.protocol.ChannelKeys;
import geminga.protocol.Cookies;
import geminga.protocol.Frame;
import geminga.protocol.FrameWriter;
import geminga.protocol.Greeting;
import geminga.protocol.Handshake;
import geminga.protocol.Limits;
import geminga.protocol.LineException;
import geminga.protocol.Listeners;
import geminga.protocol.Places;
import geminga.protocol.Said;
import geminga.protocol.SealedFrame;
import geminga.protocol.SealedFrame.Direction;
import geminga.protocol.SendQueue;
import geminga.protocol.Sequence;
import geminga.protocol.Statement;
import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.util.List;

/** Sequences, handshakes, keys, places and queues, in given time (src/client/CHANNELS.md). */
final class BeliefTest {
    private static final long SECOND = 1_000_000_000L;
    private static final InetSocketAddress HERE = new InetSocketAddress("10.0.0.1", 1);
    private static final InetSocketAddress THERE = new InetSocketAddress("10.0.0.2", 1);

    private BeliefTest() {}

    static void whatIsProvedIsNewWhereItIsGreater() {
        Sequence sequence = new Sequence();
        Check.equal(0L, sequence.take(7, 500, true, 0)); // before the first nothing is missed
        Check.equal(-1L, sequence.take(7, 500, true, 0));
        Check.equal(-1L, sequence.take(7, 499, true, 0));
        Check.equal(2L, sequence.take(7, 503, true, 0));
        Check.equal(99_496L, sequence.take(7, 100_000, true, 0)); // however large the step is
        Check.equal(0L, sequence.take(8, 1, true, 0));
        Check.equal(4L, sequence.missedAtEnd(7, 100_004, true));
        sequence.interrupt(7); // made again: it begins anew, but nothing old is delivered
        Check.equal(0L, sequence.missedAtEnd(7, 100_004, true));
        Check.equal(-1L, sequence.take(7, 100_000, true, 0));
        Check.equal(0L, sequence.take(7, 200_000, true, 0));
        Check.equal(-1L, sequence.take(9, 0, true, 0));
        Check.equal(0L, sequence.take(9, -2, true, 0)); // sequences are unsigned
        Check.equal(-1L, sequence.take(9, 5, true, 0));
        Check.equal(0L, sequence.take(9, -1, true, 0));
    }

    static void aForgedEndClaimsNoMoreThanOneStep() {
        Sequence sequence = new Sequence();
        sequence.take(7, 10, false, 0);
        Check.equal(Limits.SEQUENCE_STEP - 1, sequence.missedAtEnd(7, 9 + Limits.SEQUENCE_STEP, false));
        Check.equal(Limits.SEQUENCE_STEP, sequence.missedAtEnd(7, 10 + Limits.SEQUENCE_STEP, false));
        Check.equal(0L, sequence.missedAtEnd(7, 11 + Limits.SEQUENCE_STEP, false));
        Check.equal(0L, sequence.missedAtEnd(7, -1, false));
    }

    static void aForgedSequenceMutesForTwoSecondsAndOneMessage() {
        Sequence sequence = new Sequence();
        Check.equal(0L, sequence.take(7, 1, false, 0));
        Check.equal(-1L, sequence.take(7, -1, false, 1)); // 2^64-1 is no step
        Check.equal(0L, sequence.take(7, 2, false, 2));
        Check.equal(49_997L, sequence.take(7, 50_000, false, 3)); // this one is believed
        long muted = 0;
        for (long time = 4, number = 3; sequence.take(7, number, false, time) < 0; time += SECOND / 50, ++number) ++muted;
        Check.equal(100L, muted);
    }

    static void soManyRunsOfSequencesAreRemembered() {
        for (int runs = Limits.DELIVERED_RANGES - 1; runs <= Limits.DELIVERED_RANGES + 1; ++runs) {
            Sequence sequence = new Sequence();
            for (int i = 0; i < runs; ++i) sequence.take(7, 10 + 2L * i, false, 0);
            sequence.take(7, 9, false, 3 * SECOND); // a straggler
            boolean isForgotten = sequence.take(7, 10, false, 3 * SECOND) == 0;
            Check.equal(runs > Limits.DELIVERED_RANGES, isForgotten);
        }
    }

    static void soManyLivesAreRemembered() {
        for (int others = Limits.REMEMBERED_LIVES - 1; others <= Limits.REMEMBERED_LIVES + 1; ++others) {
            Sequence sequence = new Sequence();
            sequence.take(1, 5, true, 0);
            for (int i = 0; i < others; ++i) sequence.take(2 + i, 5, true, 0);
            Check.equal(others < Limits.REMEMBERED_LIVES ? -1L : 0L, sequence.take(1, 5, true, 0));
        }
    }

    static void aCookieIsForOneAddressLifeAndChallengeAndForSixteenSecondsAtMost() {
        long begin = Long.MAX_VALUE - 1; // the clock may begin anywhere
        Cookies cookies = new Cookies(new byte[Cookies.SECRET], begin);
        long cookie = cookies.make(HERE, 7, 5, begin + 7 * SECOND);
        Check.that(cookie != 0, "not 0");
        Check.that(cookies.isRight(cookie, HERE, 7, 5, begin + 16 * SECOND - 1), "in time");
        Check.that(!cookies.isRight(cookie, HERE, 7, 5, begin + 16 * SECOND), "too late");
        Check.that(!cookies.isRight(cookie, THERE, 7, 5, begin), "another address");
        Check.that(!cookies.isRight(cookie, new InetSocketAddress("10.0.0.1", 2), 7, 5, begin), "another port");
        Check.that(!cookies.isRight(cookie, HERE, 8, 5, begin), "another life");
        Check.that(!cookies.isRight(cookie, HERE, 7, 6, begin), "another challenge");
        Check.that(!cookies.isRight(0, HERE, 7, 5, begin), "none");
        byte[] other = new byte[Cookies.SECRET];
        other[0] = 1;
        Check.that(!new Cookies(other, begin).isRight(cookie, HERE, 7, 5, begin), "another publisher");
    }

    static void soManyAnswersAreGivenAtOnceAndInASecond() {
        AnswerRate rate = new AnswerRate(0);
        for (int i = 0; i < Limits.ANSWERS; ++i) Check.that(rate.take(false, 0), "answer " + i);
        Check.that(!rate.take(false, 0), "one more");
        int more = 0;
        for (long time = 0; time <= SECOND; time += SECOND / 10_000) more += rate.take(false, time) ? 1 : 0;
        Check.equal(Limits.ANSWERS, more);
        for (int i = 0; i < Limits.ANSWERS / 2; ++i) Check.that(rate.take(true, 100 * SECOND), "a listener's " + i);
        Check.that(!rate.take(true, 100 * SECOND), "the other half is for newcomers");
        Check.that(rate.take(false, 100 * SECOND), "as this one");
    }

    static void aHelloIsSaidAgainLessAndLessOften() {
        Greeting greeting = new Greeting(5);
        for (long milliseconds : new long[] {20, 40, 80, 160, 320, 640, 1000, 1000}) Check.equal(milliseconds * 1_000_000, greeting.next());
        Check.that(greeting.floor(new Handshake(1, 5, 9), 3, false), "a cookie is given back at once");
        Check.equal(new Handshake(2, 5, 9), greeting.hello(2));
        Check.that(!greeting.floor(new Handshake(1, 5, 9), 3, false), "the same one is not, or both would talk in a circle");
        Check.that(!greeting.floor(new Handshake(1, 5, 0), 4, false), "accepted");
        Check.equal(SECOND, greeting.next());
        Check.that(greeting.floor(new Handshake(1, 5, 10), 4, false), "forgotten, and asked again");
        Check.equal(20_000_000L, greeting.next());
        greeting.refused();
        Check.equal(SECOND, greeting.next());
        Check.equal(0L, greeting.hello(2).cookie());
    }

    static void theFirstFloorCountsAndASealedOneMoreThanAPlainOne() {
        Greeting greeting = new Greeting(5);
        Check.that(!greeting.hasFloor(true), "none yet");
        greeting.floor(new Handshake(1, 5, 9), 3, false);
        Check.that(greeting.hasFloor(true) && !greeting.hasFloor(false), "a plain one counts while plain frames are taken");
        greeting.floor(new Handshake(1, 5, 0), 7, true);
        greeting.floor(new Handshake(1, 5, 0), 9, true);
        Check.that(greeting.hasFloor(false), "a sealed one");
        Check.that(!greeting.isFresh(7) && greeting.isFresh(8) && greeting.isFresh(-1), "greater than the first sealed one");
        Check.that(greeting.isAnswer(new Handshake(1, 5, 0), 1) && !greeting.isAnswer(new Handshake(1, 6, 0), 1) && !greeting.isAnswer(new Handshake(2, 5, 0), 1), "for us");
        Check.that(!greeting.isAnswer(null, 1), "no answer");
    }

    static void theCounterOfAConsumerRises() throws Exception {
        ChannelKeys keys = PublisherBench.keysOf("encrypted");
        Said said = new Said();
        Frame hello = Frame.hello(7, new Handshake(1, 5, 0));
        SealedFrame first = keys.seal(hello, Direction.BACK, 0, 5);
        SealedFrame second = keys.seal(hello, Direction.BACK, 0, 6);
        Check.that(said.take(first, 5), "the first");
        Check.that(!said.take(first, 5), "recorded");
        Check.that(said.take(second, 5), "higher");
        Check.that(!said.take(first, 5) && !said.take(hello, 5), "lower, or plain again");
        Check.equal("7 5", said.life() + " " + said.challenge());
    }

    static void noCounterIsUsedTwiceAndAUsedUpOneEndsTheChannel() throws Exception {
        ChannelKeys keys = PublisherBench.keysOf("encrypted");
        for (Direction direction : Direction.values()) {
            FrameWriter writer = new FrameWriter(7, direction, direction.last() - 2);
            for (long counter : new long[] {direction.last() - 1, direction.last()}) {
                byte[] octets = writer.write(keys, Frame.Kind.HELLO, 0, new byte[0]);
                Check.equal(counter, ByteBuffer.wrap(octets).getLong(28));
            }
            Check.that(writer.isUsedUp(), "used up");
            Check.equal(null, writer.write(keys, Frame.Kind.HELLO, 0, new byte[0]));
            Check.that(writer.write(ChannelKeys.NONE, Frame.Kind.HELLO, 0, new byte[0]) != null, "a plain frame needs none");
        }
    }

    static void modesSendAndTakeWhatTheTableSays() throws Exception {
        String[][] table = {{"plain", "1", "1"}, {"prepared", "1", "123"}, {"mixed", "2", "123"}, {"authenticated", "3", "23"}, {"encrypted", "2", "23"}};
        Frame frame = new Frame(Frame.Kind.MESSAGE, 7, 1, "ball".getBytes());
        for (String[] row : table) {
            ChannelKeys keys = PublisherBench.keysOf(row[0]);
            byte[] sent = new FrameWriter(7, Direction.FORWARD).write(keys, Frame.Kind.MESSAGE, 1, frame.payload());
            Check.equal(row[1], Integer.toString(sent[2]));
            Check.equal(row[2].contains("1"), keys.open(frame, Direction.FORWARD) != null);
            Check.equal(row[2].contains("2"), keys.open(PublisherBench.keysOf("encrypted").seal(frame, Direction.FORWARD, 0, 1), Direction.FORWARD) != null);
            Check.equal(row[2].contains("3"), keys.open(PublisherBench.keysOf("authenticated").seal(frame, Direction.FORWARD, 0, 2), Direction.FORWARD) != null);
        }
    }

    static void aRingHasSoManyKeysAndTheyAreNeverShown() throws Exception {
        String key = PublisherBench.RING;
        String secret = key.substring(5, 69);
        for (int count = ChannelKeys.MOST - 1; count <= ChannelKeys.MOST; ++count) {
            ChannelKeys keys = ChannelKeys.read("encrypted", String.join(",", java.util.Collections.nCopies(count, key)));
            Check.equal("encrypted with " + count + " keys", keys.toString());
        }
        List<String> wrong = List.of(String.join(",", java.util.Collections.nCopies(ChannelKeys.MOST + 1, key)), "", ",", key + ",", key.substring(1), key.replace("61", "6x"), "6208:" + secret,
                key + ":00", "620x" + key.substring(4));
        for (String ring : wrong) Check.that(!Check.fails(LineException.class, () -> ChannelKeys.read("encrypted", ring)).getMessage().contains(secret.substring(4, 12)), "not shown");
        Check.fails(LineException.class, () -> ChannelKeys.read("sealed", key));
        Check.equal(ChannelKeys.NONE, ChannelKeys.read(Statement.read("5 pub keys life=0123456789abcdef mode=plain")));
        Check.equal(0x0123456789abcdefL, ChannelKeys.life(Statement.read("5 pub keys life=0123456789abcdef mode=plain")));
        Check.equal(0L, ChannelKeys.life(Statement.read("5 pub keys mode=plain")));
    }

    static void soManyListenersHaveAPlaceAndAreForgottenAfterThreeSecondsOfSilence() {
        Listeners listeners = new Listeners();
        for (int i = 0; i < Limits.LISTENERS; ++i) {
            Check.that(listeners.add(new InetSocketAddress("10.0.0.1", 1 + i), i).isTaken(), "listener " + i);
            Check.that(!listeners.places().isToBeTold(), "nobody was refused");
        }
        Check.that(!listeners.add(new InetSocketAddress("10.0.0.1", 5000), 2000).isTaken(), "one more");
        Check.that(listeners.places().isToBeTold() && !listeners.places().isToBeTold(), "told once");
        Places.Outcome<Listeners.Listener> other = listeners.add(THERE, 2001);
        Check.equal(Limits.LISTENERS, other.loser().address().getPort()); // the newest of the address that has most
        Check.equal(null, listeners.at(other.loser().address()));
        listeners.remove(new InetSocketAddress("10.0.0.1", 6));
        Check.that(listeners.add(new InetSocketAddress("10.0.0.1", 5000), 2002).isTaken(), "in the place of who left");
        listeners.renew(listeners.at(new InetSocketAddress("10.0.0.1", 1)), 3000);
        Check.equal(1 + Limits.LISTENER_SILENCE, listeners.deadline());
        Check.that(listeners.add(new InetSocketAddress("10.0.0.1", 5001), 1 + Limits.LISTENER_SILENCE).isTaken(), "in the place of who fell silent");
        Check.that(listeners.at(new InetSocketAddress("10.0.0.1", 1)) != null, "who said hello again is still there");
        Check.that(listeners.places().isShort(), "there are few places");
        listeners.forget(Limits.LISTENERS + Limits.LISTENER_SILENCE);
        Check.that(!listeners.places().isShort(), "there are places again");
    }

    static void aShortageEndsWhenThreeQuartersAreTaken() {
        Places<Integer> places = new Places<>(8);
        for (int i = 0; i < 9; ++i) places.take(i, "a");
        places.leave(0);
        Check.that(places.isShort(), "seven are taken");
        places.leave(1);
        Check.that(!places.isShort(), "six are taken");
        Check.that(!places.leave(1), "it has none");
    }

    static void aFrameThatWaitsForManyIsCountedOnce() {
        SendQueue.Pool pool = new SendQueue.Pool();
        List<SendQueue> queues = List.of(new SendQueue(pool), new SendQueue(pool), new SendQueue(pool));
        SendQueue.Shared frame = new SendQueue.Shared(new byte[1000]);
        for (SendQueue queue : queues) queue.put(frame, frame.octets());
        Check.equal(1000L, pool.octets());
        queues.get(0).first().position(400);
        queues.get(0).written(400);
        Check.equal("600 1000", queues.get(0).octets() + " " + pool.octets());
        queues.get(0).first().position(1000);
        queues.get(0).written(600);
        queues.get(1).clear();
        Check.equal("0 0 1000", queues.get(0).octets() + " " + queues.get(1).octets() + " " + pool.octets());
        queues.get(2).clear();
        Check.equal(0L, pool.octets());
    }

    static void soMuchWaitsForOneAndForAll() {
        SendQueue.Pool pool = new SendQueue.Pool();
        SendQueue one = new SendQueue(pool);
        Check.that(one.hasRoom(Limits.TCP_MESSAGE), "one message of any size");
        SendQueue.Shared large = new SendQueue.Shared(new byte[Limits.WAITING_FOR_CONSUMER - 10]);
        one.put(large, large.octets());
        Check.that(one.hasRoom(9) && one.hasRoom(10) && !one.hasRoom(11), "4 MiB");
        SendQueue.Shared rest = new SendQueue.Shared(new byte[Limits.WAITING_FOR_ALL - large.size() - 1]);
        for (int more : new int[] {0, 1, 2}) {
            SendQueue other = new SendQueue(pool);
            SendQueue.Shared few = new SendQueue.Shared(new byte[more]);
            other.put(rest, rest.octets());
            other.put(few, few.octets());
            Check.equal(more == 2, pool.isOver());
            other.clear();
        }
    }

    static void soManyTinyFramesWaitForOneAndForAll() {
        SendQueue.Pool pool = new SendQueue.Pool();
        SendQueue.Shared tiny = new SendQueue.Shared(new byte[1]);
        SendQueue one = new SendQueue(pool);
        for (int i = 1; i < Limits.WAITING_FRAMES; ++i) one.put(tiny, tiny.octets());
        Check.that(one.hasRoom(1), "one more");
        one.put(tiny, tiny.octets());
        Check.that(!one.hasRoom(1), "no more");
        one.first().position(1);
        one.written(1);
        Check.that(one.hasRoom(1), "one was taken");
        one.clear();
        for (int i = 0; i < Limits.WAITING_FRAMES_FOR_ALL; ++i) one.put(tiny, tiny.octets());
        Check.that(!pool.isOver(), "at the limit");
        one.put(tiny, tiny.octets());
        Check.that(pool.isOver(), "one more");
        one.clear();
        Check.that(!pool.isOver() && pool.octets() == 0, "none");
    }
}
