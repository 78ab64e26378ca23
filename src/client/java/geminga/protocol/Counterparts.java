package geminga.protocol;

import geminga.Match;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * The counterparts of a channel: the providers of a subscriber, or the consumers of a publisher, by their lives. Decides how long a channel goes on when daemons lose sight
 * of them (src/client/CHANNELS.md, "How a channel ends"). The caller gives the time, in nanoseconds.
 *
 * @param <C> the sockets that the caller keeps for each of them
 */
public final class Counterparts<C> {
    /** The owner of the sockets. Its methods may not call back. */
    public interface Watcher<C> {
        /** A counterpart was added. */
        void opened(Entry<C> entry);

        /** Its statement or its address has changed. */
        void changed(Entry<C> entry, Match before);

        /** It was withdrawn. Messages on their way are still delivered, until {@link #ended} or until {@link Limits#ENDING} has passed. */
        void ending(Entry<C> entry);

        /** Whether it has a connection, with which its channel goes on without its daemon. */
        boolean hasConnection(Entry<C> entry);

        /** Its channel is over. */
        void closed(Entry<C> entry, String reason);
    }

    /** The state of an entry. */
    private enum State { CONFIRMED, UNCONFIRMED, ORPHAN, ENDING }

    /** One counterpart. */
    public static final class Entry<C> {
        private static final long NEVER = Long.MAX_VALUE;

        private final String key;
        private final Map<String, Match> words = new LinkedHashMap<>();
        private Match match;
        private State state = State.CONFIRMED;
        private long deadline = NEVER;
        private String reason = "";
        /** The sockets that the watcher keeps for it. */
        public C channel;

        private Entry(String key) {
            this.key = key;
        }

        /** All that is known of it. */
        public Match match() {
            return match;
        }

        /** Whether it was withdrawn and only messages on their way still come. */
        public boolean isEnding() {
            return state == State.ENDING;
        }

        /** The reason of the daemon why it is gone. */
        public String reason() {
            return reason;
        }
    }

    private final Watcher<C> watcher;
    private final boolean lingers;
    private final Map<String, Entry<C>> entries = new LinkedHashMap<>();
    private final Map<String, Entry<C>> byWord = new LinkedHashMap<>();
    private long limit;
    /** Whether the own daemon has come back, and until when it finds out who is there. */
    private boolean isBack;
    private long settled;

    /** With {@code lingers}, messages on their way from a withdrawn counterpart are still taken. */
    public Counterparts(Watcher<C> watcher, boolean lingers) {
        this.watcher = watcher;
        this.lingers = lingers;
    }

    /** The largest number of counterparts; 0 for all. */
    public void limit(long most) {
        limit = most;
    }

    /** All counterparts, in the order in which they came. */
    public List<Entry<C>> all() {
        return new ArrayList<>(entries.values());
    }

    /** The counterpart with this life, which is not 0; or null. */
    public Entry<C> of(long life) {
        return entries.get(Life.write(life));
    }

    /** The counterpart with this word of the daemon, or null. */
    public Entry<C> at(String word) {
        return byWord.get(word);
    }

    /** Takes a {@code modify}. It does not bring back a counterpart that has ended. */
    public void modify(Match match, long now) {
        if (byWord.containsKey(match.word())) put(match, now);
    }

    /** Takes an {@code add}. */
    public void put(Match match, long now) {
        String key = match.life() != 0 ? Life.write(match.life()) : match.word();
        Entry<C> known = byWord.get(match.word());
        // Daemons that come back give their words anew: that another life has the word is no end of the former one.
        if (known != null && !known.key.equals(key)) lose(match.word(), known, now);
        Entry<C> entry = entries.get(key);
        if (entry == null) {
            entry = new Entry<>(key);
            entries.put(key, entry);
        }
        Match before = entry.match;
        boolean wasEnding = entry.state == State.ENDING;
        entry.words.remove(match.word());
        entry.words.put(match.word(), match);
        byWord.put(match.word(), entry);
        entry.match = match;
        entry.state = State.CONFIRMED;
        entry.deadline = Entry.NEVER;
        if (before == null) {
            watcher.opened(entry);
        } else if (wasEnding || !isSame(before, match)) {
            watcher.changed(entry, before);
        }
        closeOrphansBeyondLimit();
    }

    /** Takes a {@code del}. An orphan over TCP goes on as long as its connection, one over UDP for {@link Limits#ORPHAN}. */
    public void remove(String word, String reason, long now) {
        Entry<C> entry = byWord.remove(word);
        if (entry == null) return;
        if (hasOtherWord(entry, word)) return;
        entry.reason = reason;
        switch (reason) {
            case "withdrawn" -> {
                if (!lingers) {
                    close(entry);
                    return;
                }
                entry.state = State.ENDING;
                entry.deadline = now + Limits.ENDING;
                watcher.ending(entry);
            }
            case "outranked" -> {
                // After a restart the consumer's daemon may still prefer this same life under its former word.
                boolean isUnsettled = !lingers && isBack && now - settled < 0;
                if (isUnsettled) {
                    orphan(entry, now, watcher.hasConnection(entry));
                } else {
                    close(entry);
                }
            }
            case "changed" -> close(entry);
            default -> orphan(entry, now, watcher.hasConnection(entry));
        }
        closeOrphansBeyondLimit();
    }

    /** Another life has taken the word: as far as the daemon tells, this one may still be there, under another word. */
    private void lose(String word, Entry<C> entry, long now) {
        byWord.remove(word);
        if (hasOtherWord(entry, word)) return;
        entry.reason = "changed";
        if (entry.state != State.ENDING) orphan(entry, now, watcher.hasConnection(entry));
    }

    /** Takes a word away. Whether there is another one. */
    private boolean hasOtherWord(Entry<C> entry, String word) {
        Match removed = entry.words.remove(word);
        if (entry.words.isEmpty()) return false;
        for (Match last : entry.words.values()) entry.match = last;
        if (!isSame(removed, entry.match)) watcher.changed(entry, removed);
        return true;
    }

    /**
     * The own daemon is gone. All channels go on, however long that takes: nobody can confirm a channel meanwhile, so an orphan does not come closer to its end either. Only what
     * was withdrawn still ends.
     */
    public void lost() {
        byWord.clear();
        for (Entry<C> entry : entries.values()) {
            entry.words.clear();
            if (entry.state != State.ENDING) {
                if (entry.state != State.ORPHAN) entry.reason = "disconnected";
                entry.state = State.UNCONFIRMED;
                entry.deadline = Entry.NEVER;
            }
        }
    }

    /** The own daemon is back, and confirms counterparts. */
    public void back(long now) {
        isBack |= !entries.isEmpty();
        settled = now + Limits.CONFIRMATION;
        for (Entry<C> entry : entries.values()) {
            if (entry.state == State.UNCONFIRMED) entry.deadline = now + Limits.CONFIRMATION;
        }
    }

    /** The other side has ended the channel. */
    public void ended(Entry<C> entry) {
        if (entries.get(entry.key) != entry) return;
        entry.reason = "withdrawn";
        close(entry);
    }

    /** A withdrawn counterpart sent something, or waits for room: its time begins anew. */
    public void extend(Entry<C> entry, long now) {
        if (entry.state == State.ENDING) entry.deadline = now + Limits.ENDING;
    }

    /** Whether the daemons have lost sight of it. */
    public boolean isLost(Entry<C> entry) {
        return entry.state == State.ORPHAN;
    }

    /** Whether a {@code del} of this word, for this reason, takes the last sight of its counterpart and leaves open whether it has ended. */
    public boolean isLeftOpen(String word, String reason) {
        Entry<C> entry = byWord.get(word);
        return entry != null && entry.words.size() == 1 && !reason.equals("outranked") && !reason.equals("changed");
    }

    /** Its connection broke. Whether to make another one. */
    public boolean broke(Entry<C> entry) {
        if (entries.get(entry.key) != entry) return false;
        if (entry.state == State.CONFIRMED || entry.state == State.UNCONFIRMED) return true;
        close(entry);
        return false;
    }

    /** Ends channels whose time is over. One that has a connection goes on without its daemons. */
    public void tick(long now) {
        for (Entry<C> entry : all()) {
            if (entry.deadline == Entry.NEVER || now - entry.deadline < 0) continue;
            if (entry.state == State.UNCONFIRMED) {
                orphan(entry, now, watcher.hasConnection(entry));
            } else {
                close(entry);
            }
        }
        closeOrphansBeyondLimit();
    }

    /** The time at which {@link #tick} has something to do; {@link Long#MAX_VALUE} for never. */
    public long deadline() {
        long first = Entry.NEVER;
        for (Entry<C> entry : entries.values()) {
            if (entry.deadline != Entry.NEVER && (first == Entry.NEVER || entry.deadline - first < 0)) first = entry.deadline;
        }
        return first;
    }

    /** Ends all channels. */
    public void closeAll(String reason) {
        for (Entry<C> entry : all()) {
            entry.reason = reason;
            close(entry);
        }
    }

    private void orphan(Entry<C> entry, long now, boolean hasConnection) {
        entry.state = State.ORPHAN;
        entry.deadline = hasConnection ? Entry.NEVER : now + Limits.ORPHAN;
    }

    private void closeOrphansBeyondLimit() {
        if (limit == 0 || entries.values().stream().filter(entry -> entry.state == State.CONFIRMED).count() < limit) return;
        for (Entry<C> entry : all()) {
            if (entry.state == State.ORPHAN) close(entry);
        }
    }

    private void close(Entry<C> entry) {
        entries.remove(entry.key);
        entry.words.keySet().forEach(byWord::remove);
        entry.words.clear();
        watcher.closed(entry, entry.reason);
    }

    /** Whether two matches are equal but for the numbers that daemons gave them. */
    public static boolean isSame(Match one, Match other) {
        return one.equals(other) || anonymous(one).equals(anonymous(other));
    }

    private static Match anonymous(Match match) {
        return new Match("", "", match.name(), match.host(), match.life(), match.identity(), match.degree(), match.distance(), match.mode(), match.address(), match.port(),
                match.protocol(), match.priority(), match.conversion(), match.cost(), match.via(), match.attributes(), match.hops(), match.path(), match.reachable());
    }
}
