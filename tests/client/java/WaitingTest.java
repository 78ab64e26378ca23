import geminga.Message;
import geminga.protocol.EarlyFrames;
import geminga.protocol.Frame;
import geminga.protocol.Inbox;
import geminga.protocol.Limits;
import java.net.InetSocketAddress;
import java.util.List;

/** The inbox and the early frames of a subscriber. */
final class WaitingTest {
    private static final InetSocketAddress HERE = InetSocketAddress.createUnresolved("here", 1);

    private WaitingTest() {}

    static void soManyMessagesWait() {
        Inbox inbox = new Inbox();
        for (int i = 0; i < Limits.WAITING_MESSAGES; ++i) {
            Check.that(inbox.hasRoom(), "there is room for message " + i);
            Check.equal(0, inbox.putDatagram(new Message(new byte[1], 1, i + 1, 0, null)));
        }
        Check.that(!inbox.hasRoom(), "there is no room for one more");
        Check.equal(1, inbox.putDatagram(new Message(new byte[1], 1, Limits.WAITING_MESSAGES + 1, 0, null)));
        Message first = inbox.take();
        Check.equal(2L, first.sequence()); // the eldest is lost
        Check.equal(1L, first.missed());
        Check.that(inbox.hasRoom() && !inbox.isHalfEmpty(), "but for this one, though it is not worth while");
    }

    static void soManyOctetsWaitOrOneMessage() {
        Inbox inbox = new Inbox();
        inbox.putStreamed(new Message(new byte[Limits.WAITING_OCTETS - 1], 1, 1, 0, null));
        Check.that(inbox.hasRoom(), "one octet is left");
        inbox.putStreamed(new Message(new byte[1], 1, 2, 0, null));
        Check.that(!inbox.hasRoom(), "none is left");
        inbox.take();
        Check.that(inbox.hasRoom() && inbox.isHalfEmpty(), "nearly empty");
        inbox.clear();
        Check.that(inbox.isEmpty() && inbox.hasRoom(), "empty");
    }

    static void earlyFramesAreKeptByAddressAndLife() {
        EarlyFrames early = new EarlyFrames();
        InetSocketAddress there = InetSocketAddress.createUnresolved("there", 1);
        early.put(HERE, early(7, 0, 1), 0);
        early.put(there, early(7, 1, 1), 0);
        early.put(HERE, early(8, 2, 1), 0);
        early.put(HERE, early(7, 3, 1), 0);
        Check.equal(List.of(0L, 3L), sequences(early, 0));
        Check.equal(List.of(), sequences(early, 0));
        Check.equal(1, early.take(there::equals, 7, 0).size());
        Check.equal(1, early.take(HERE::equals, 8, 0).size());
    }

    static void soManyEarlyFramesAreKeptAndTheOldestGoes() {
        EarlyFrames early = new EarlyFrames();
        for (int count = Limits.EARLY_FRAMES - 1; count <= Limits.EARLY_FRAMES + 1; ++count) {
            for (int i = 0; i < count; ++i) early.put(HERE, early(7, i, 0), 0);
            List<Long> kept = sequences(early, 0);
            Check.equal(Math.min(count, Limits.EARLY_FRAMES), kept.size());
            Check.equal((long) Math.max(0, count - Limits.EARLY_FRAMES), kept.get(0));
        }
    }

    static void soManyOctetsOfEarlyFramesAreKeptAndTheOldestGoes() {
        EarlyFrames early = new EarlyFrames();
        int eighth = Limits.EARLY_OCTETS / 8;
        for (int size = eighth - 1; size <= eighth + 1; ++size) {
            for (int i = 0; i < 8; ++i) early.put(HERE, early(7, i, size), 0);
            Check.equal(size <= eighth ? 8 : 7, sequences(early, 0).size());
        }
    }

    static void anEarlyFrameIsKeptForASecond() {
        long begin = Long.MAX_VALUE - 1; // the clock may begin anywhere
        for (long later : new long[] {Limits.EARLY - 1, Limits.EARLY, 2 * Limits.EARLY}) {
            EarlyFrames early = new EarlyFrames();
            early.put(HERE, early(7, 1, 0), begin);
            early.put(HERE, early(7, 2, 0), begin + 1);
            Check.equal(later < Limits.EARLY ? List.of(1L, 2L) : later == Limits.EARLY ? List.of(2L) : List.of(), sequences(early, begin + later));
        }
    }

    private static Frame early(long life, long sequence, int size) {
        return new Frame(Frame.Kind.MESSAGE, life, sequence, new byte[size]);
    }

    private static List<Long> sequences(EarlyFrames early, long now) {
        return early.take(HERE::equals, 7, now).stream().map(kept -> kept.frame().sequence()).toList();
    }
}
