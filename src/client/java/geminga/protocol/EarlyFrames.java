package geminga.protocol;

import java.net.InetSocketAddress;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.function.Predicate;

/**
 * Frames over UDP whose sender the daemon has not named yet, or that came before the floor of a sealed channel (src/client/CHANNELS.md, "Early frames"). Keeps at most
 * {@link Limits#EARLY_FRAMES} with {@link Limits#EARLY_OCTETS} of payload, each for {@link Limits#EARLY}; for one more the oldest goes. The caller gives the time, in nanoseconds.
 */
public final class EarlyFrames {
    /** A frame, where it came from, and until when it is kept. */
    public record Kept(InetSocketAddress from, WireFrame frame, long until) {}

    private final ArrayDeque<Kept> kept = new ArrayDeque<>();
    private int octets;

    public void put(InetSocketAddress from, WireFrame frame, long now) {
        forgetOld(now);
        int size = frame.size();
        if (size > Limits.EARLY_OCTETS) return;
        while (kept.size() >= Limits.EARLY_FRAMES || octets + size > Limits.EARLY_OCTETS) forgetFirst();
        kept.add(new Kept(from, frame, now + Limits.EARLY));
        octets += size;
    }

    /** Removes the frames of this life from such an address; the result has them in the order of arrival. */
    public List<Kept> take(Predicate<InetSocketAddress> isFrom, long life, long now) {
        forgetOld(now);
        List<Kept> taken = new ArrayList<>();
        for (Iterator<Kept> each = kept.iterator(); each.hasNext();) {
            Kept one = each.next();
            if (one.frame().life() != life || !isFrom.test(one.from())) continue;
            each.remove();
            octets -= one.frame().size();
            taken.add(one);
        }
        return taken;
    }

    private void forgetOld(long now) {
        while (!kept.isEmpty() && kept.getFirst().until() - now <= 0) forgetFirst();
    }

    private void forgetFirst() {
        octets -= kept.removeFirst().frame().size();
    }
}
